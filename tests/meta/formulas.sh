#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every formula of ui/lesson/formulas/formulas.tex has its SVG, rendered from the TeX that stands there now.
# shellcheck source=tests/meta/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

collect -name "*.svg"
room=ui/lesson/formulas
names=$'\n'
id=''
tex=''
check() {
  [ -n "$id" ] || return 0
  names+="$id"$'\n'
  local hash
  hash="$(printf '%s' "$tex" | sha256sum | cut -d' ' -f1)"
  if [ ! -e "$room/$id.svg" ]; then
    fault "$room/formulas.tex" "$id has no SVG: run $room/build.mjs"
  elif [ "$(head -n 1 "$room/$id.svg")" != "<!-- tex $hash -->" ]; then
    fault "$room/$id.svg" "is not of the TeX that stands there now: run $room/build.mjs"
  fi
}
while IFS= read -r line; do
  case "$line" in
    '%% '*) check; id="${line#%% }" tex='' ;;
    *) [ -z "$id" ] || tex+="${tex:+$'\n'}$line" ;;
  esac
done <"$room/formulas.tex"
check
for svg in "$room"/*.svg; do
  name="$(basename -- "$svg" .svg)"
  [[ $names == *$'\n'"$name"$'\n'* ]] || fault "$svg" "has no TeX in formulas.tex"
done
finish
