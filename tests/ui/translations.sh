#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# translations.sh ROOT LUPDATE LRELEASE FOLDER: every word of the window is in every catalogue of
# ui/translations and translated there, and none is where the tools do not find it.
set -euo pipefail
root="$1" lupdate="$2" lrelease="$3" folder="$4"
rm -rf -- "$folder"
mkdir -p -- "$folder"
cp -- "$root"/ui/translations/flatland_*.ts "$folder"
faults=0
fault() {
  printf '%s\n' "$1"
  faults=$((faults + 1))
}

cd -- "$root"
log="$folder/lupdate.log"
"$lupdate" -recursive ui -extensions cpp,h -I . -no-obsolete -locations none \
  -ts "$folder/flatland_de.ts" >"$log" 2>&1
"$lupdate" -recursive ui -extensions cpp,h -I . -no-obsolete -locations none -pluralonly \
  -ts "$folder/flatland_en.ts" >>"$log" 2>&1
# A tr() outside a class of the window is filed under a name nobody looks it up by.
while IFS= read -r line; do fault "$line"; done < <(grep -E 'lacks Q_OBJECT|unknown namespace' "$log" | sort -u)
for catalogue in de en; do
  file="$folder/flatland_$catalogue.ts"
  if grep -q '<name>flatland::ui</name>' "$file"; then fault "flatland_$catalogue.ts: words in no class"; fi
  while IFS= read -r word; do fault "flatland_$catalogue.ts: not translated: $word"; done < <(
    awk '/<source>/ { source = $0; while (source !~ /<\/source>/ && (getline more) > 0) source = source " " more }
         /type="unfinished"/ || /<translation><\/translation>/ || /<numerusform><\/numerusform>/ {
           gsub(/^ *<source>|<\/source>.*$/, "", source); print source }' "$file")
  if ! cmp -s <(grep -c '<source>' "$file") <(grep -c '<source>' "ui/translations/flatland_$catalogue.ts"); then
    fault "flatland_$catalogue.ts: words came or went; run ./dev translations"
  fi
  "$lrelease" -silent "$file" -qm "$folder/flatland_$catalogue.qm" 2>>"$log" || fault "lrelease refuses $file"
  # %1 and the like must survive: a word that loses one loses a value.
done
# Places of the values are the same in both languages.
python3 - "$folder/flatland_de.ts" <<'PY' || faults=$((faults + 1))
import re, sys, xml.etree.ElementTree as tree
bad = 0
for message in tree.parse(sys.argv[1]).getroot().iter("message"):
    source = message.findtext("source") or ""
    node = message.find("translation")
    forms = [f.text or "" for f in node.findall("numerusform")] or [node.text or ""]
    if node.get("type") == "unfinished":
        continue
    for form in forms:
        wanted = sorted(set(re.findall(r"%\d", source)))
        found = sorted(set(re.findall(r"%\d", form)))
        if wanted != found:
            print("values differ:", source, "->", form)
            bad += 1
sys.exit(1 if bad else 0)
PY
if [ "$faults" -gt 0 ]; then
  printf 'translations.sh: %d faults\n' "$faults"
  exit 1
fi
printf 'translations.sh: no faults\n'
