#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# No text file names a folder of the machine it was written on.
# shellcheck source=tests/meta/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

collect
# A path starts where no name, dot, tag or variable stands before the slash.
path='(^|[^]A-Za-z0-9_.<>)}/-])/(work|root|home|farm|Users)(/|$|[^A-Za-z0-9_.-])'
while IFS=: read -r file line text; do
  fault "$file:$line" "path of a machine: $text"
done < <(grep -nIE "$path" /dev/null "${files[@]}" || true)
finish
