#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Every source says its licence in its first two lines, and the right one for its room: MIT in the
# libraries, the GPL elsewhere (docs/decisions/0001-licences.md).
# shellcheck source=tests/meta/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

collect \( -name '*.h' -o -name '*.cpp' -o -name '*.cmake' -o -name '*.cmake.in' -o -name '*.h.in' \
  -o -name CMakeLists.txt -o -name '*.sh' -o -name '*.py' -o -path ./dev -o -path ./.ci/run \)
for file in "${files[@]}"; do
  case "$file" in
    flatland/* | core3d/*) licence=MIT ;;
    *) licence=GPL-3.0-or-later ;;
  esac
  # -x would ask for the whole line; only a comment sign may stand before.
  if ! head -n 2 -- "$file" | grep -qE "^(//|#) SPDX-License-Identifier: $licence\$"; then
    fault "$file:1" "no line 'SPDX-License-Identifier: $licence' at the top"
  fi
done
finish
