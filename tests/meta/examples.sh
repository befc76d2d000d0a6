#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# examples.sh ROOT FLATLAND: runs every command line that a document shows. In the README and the pages
# for users, a line of a "sh" block that begins with "flatland SUBCOMMAND" or "./dev run SUBCOMMAND"
# must succeed, in the order of the page and in one empty folder per page; a "json" block whose text
# before it names a file ("my-curve.json:") is that file. A line that opens the window has no
# subcommand and is left out.
set -euo pipefail

root="$(cd -- "$1" && pwd -P)"
flatland="$2"
scratch="$(mktemp -d)"
trap 'rm -rf -- "$scratch"' EXIT
mkdir "$scratch/bin"
ln -s "$flatland" "$scratch/bin/flatland"
export PATH="$scratch/bin:$PATH"
unset DISPLAY WAYLAND_DISPLAY

run=0
failed=0
for page in "$root"/README.md "$root"/docs/user/*.md; do
  [ -e "$page" ] || continue
  folder="$scratch/$(basename -- "$page" .md)"
  mkdir "$folder"
  cd -- "$folder"
  fence=''
  file=''
  number=0
  while IFS= read -r line || [ -n "$line" ]; do
    number=$((number + 1))
    if [[ $line == '```'* ]]; then
      if [ -n "$fence" ]; then fence='' file=''; else fence="${line#\`\`\`}" fence="${fence:-plain}"; fi
    elif [ "$fence" = json ] && [ -n "$file" ]; then
      printf '%s\n' "$line" >>"$file"
    elif [ -z "$fence" ] && [[ $line =~ \`([a-z0-9-]+\.json)\`:$ ]]; then
      file="${BASH_REMATCH[1]}"
      : >"$file"
    elif [ "$fence" = sh ]; then
      command="${line/#.\/dev run /flatland }"
      # A scene alone has a dot or colon in its name and would open the window.
      if [[ $command =~ ^flatland\ (--[a-z-]+|[a-z]+)(\ |$) ]]; then
        run=$((run + 1))
        # bash, for an example may have a pipe or a redirection; a failing part fails the whole.
        if ! bash -o pipefail -c "$command" >"$scratch/output" 2>&1 </dev/null; then
          printf '%s:%d: fails: %s\n' "${page#"$root"/}" "$number" "$line"
          sed 's/^/    /' "$scratch/output"
          failed=$((failed + 1))
        fi
      fi
    fi
  done <"$page"
done
printf 'examples.sh: %d commands, %d failed\n' "$run" "$failed"
[ "$failed" -eq 0 ] && [ "$run" -gt 0 ]
