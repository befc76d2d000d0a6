#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# What the documents and comments name exists: linked pages and pictures, files, commands of ./dev,
# bibliography keys. And nobody has to guess where to start: the README gives the two commands, and
# every page is linked from another.
# shellcheck source=tests/meta/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

collect
everything=$'\n'"$(printf '%s\n' "${files[@]}")"$'\n'
mapfile -t pages < <(printf '%s\n' "${files[@]}" | grep -E '\.md$' || true)
# Without these checks themselves: their patterns and planted faults name what does not exist.
mapfile -t sources < <(printf '%s\n' "${files[@]}" | grep -vE '^tests/meta/' |
  grep -E '\.(h|cpp|cmake|sh)$|CMakeLists\.txt$|^dev$|^\.ci/run$' || true)

# exists NAME: a file or folder of the repository has this path or ends in it.
exists() { [[ $everything == *[$'\n/']"${1%/}"[$'\n/']* ]]; }

# 1. The README gives the two commands, on lines of their own.
for command in './dev run' './dev test'; do
  grep -qsxF -- "$command" README.md || fault README.md:1 "the command '$command' has no line of its own"
done

# 2. Commands of ./dev that a document names, in code, are commands that ./dev help names too.
commands=" $(bash ./dev help | sed -n 's/^\.\/dev \([a-z-]*\).*/\1/p' | tr '\n' ' ') "
while IFS=: read -r file line name; do
  [[ $commands == *" ${name#*./dev } "* ]] || fault "$file:$line" "there is no '${name#*\`}'"
done < <(grep -noE '(^|`)\./dev [a-z-]+' /dev/null "${pages[@]}" || true)

# 3. Links of a document lead somewhere, from where the document lies.
linked=$'\n'
for page in "${pages[@]}"; do
  while IFS=: read -r line link; do
    target="${link#*](}"
    target="${target%)}"
    target="${target%%#*}"
    case "$target" in '' | http://* | https://* | mailto:*) continue ;; esac
    path="$(realpath -m --relative-to=. -- "$(dirname -- "$page")/$target")"
    if [ -e "$path" ]; then linked+="$path"$'\n'; else fault "$page:$line" "link to $target, which does not exist"; fi
  done < <(grep -noE '\]\([^) ]+\)' "$page" || true)
done
for page in "${pages[@]}"; do
  if [[ $page == docs/* && $linked != *$'\n'"$page"$'\n'* ]]; then
    fault "$page:1" "no page links to this one; docs/README.md is the index"
  fi
done

# 4. Files named in documents (as `code`) and in comments exist. A bare name may be anywhere in the tree.
name_pattern='[A-Za-z0-9_][A-Za-z0-9_./-]*\.(h|cpp|md|bib|cmake|sh)'
named() {
  grep -noE "\`$name_pattern\`" /dev/null "${pages[@]}" | tr -d '`'
  grep -nE '^[[:space:]]*(//|#)|[[:space:]]//' /dev/null "${sources[@]}" |
    grep -vE '^[^:]*:[0-9]+:[[:space:]]*#[[:space:]]*(include|define)' |
    sed -E 's/^([^:]*:[0-9]+:).*(\/\/|^[[:space:]]*#)/\1/' |
    awk -F: -v pattern="$name_pattern" '{
      place = $1 ":" $2 ":"; text = substr($0, length(place) + 1)
      while (match(text, pattern)) {
        after = substr(text, RSTART + RLENGTH, 1); before = RSTART > 1 ? substr(text, RSTART - 1, 1) : ""
        if (after !~ /[A-Za-z0-9_]/ && before !~ /[<>\/*$}]/) print place substr(text, RSTART, RLENGTH)
        text = substr(text, RSTART + RLENGTH)
      }
    }'
}
while IFS=: read -r file line name; do
  exists "$name" || fault "$file:$line" "names $name, which does not exist"
done < <(named || true)
# Folders named by their path from the top, and pairs of header and source named without suffix.
while IFS=: read -r file line name; do
  name="${name//\`/}"
  [ -e "${name%/}" ] || [ -e "$name.h" ] || fault "$file:$line" "names $name, which does not exist"
done < <(grep -noE '`(flatland|core3d|ui|tests|docs|cmake|packaging)(/[A-Za-z0-9_-]+)*/?`' /dev/null "${pages[@]}" || true)

# 5. Keys written "(bibliography: key)" are entries; several are set apart by ";", and a place in the
# source may follow a comma: "(bibliography: judd2007, eq. 3; thesis2007)".
while IFS=: read -r file line text; do
  text="${text#*bibliography: }"
  while IFS= read -r key; do
    key="${key%%,*}"
    key="${key// /}"
    grep -qsF "{$key," docs/bibliography.bib ||
      fault "$file:$line" "bibliography key '$key' is not in docs/bibliography.bib"
  done < <(tr ';' '\n' <<<"${text%)}")
done < <(grep -noE '\(bibliography: [^)]*\)' /dev/null "${pages[@]}" "${sources[@]}" || true)
finish
