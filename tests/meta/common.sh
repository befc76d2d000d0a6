# SPDX-License-Identifier: GPL-3.0-or-later
# shellcheck shell=bash
# Shared by the repository checks. Each check is `check.sh ROOT`: it prints one line "file:line: what
# is wrong" per fault and exits with 1 if there was any, 0 if none. ROOT is an argument so that
# planted_faults.sh can hold every check against a small tree with a known fault.
set -euo pipefail
export LC_ALL=C.UTF-8

root="${1:?usage: $0 ROOT}"
cd -- "$root"
faults=0

# fault PLACE WHAT
fault() {
  printf '%s: %s\n' "$1" "$2"
  faults=$((faults + 1))
}

finish() {
  if [ "$faults" -gt 0 ]; then
    printf '%s: %d faults\n' "$(basename -- "$0")" "$faults"
    exit 1
  fi
  printf '%s: no faults in %d files\n' "$(basename -- "$0")" "${#files[@]}"
  # A check that looked at nothing has not passed.
  [ "${#files[@]}" -gt 0 ]
}

# collect [FIND TESTS]: sets `files` to the files of the repository that match, without what is built.
# By find and not by git, so that the checks work in an unpacked archive and on files not yet committed.
collect() {
  mapfile -d '' -t files < <(find . \( -path ./build -o -path ./out -o -path ./.git -o -path ./.cache \) \
    -prune -o -type f "$@" -printf '%P\0' | sort -z)
}
