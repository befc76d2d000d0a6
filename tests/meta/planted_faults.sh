#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# Holds every repository check against a small sound tree, where it must pass, and against the same
# tree with one fault planted in it, where it must fail and name the place. A check that has stopped
# seeing anything is found here.
set -euo pipefail

checks="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)"
scratch="$(mktemp -d)"
trap 'rm -rf -- "$scratch"' EXIT
mistakes=0
planted=0

# put FILE TEXT
put() {
  mkdir -p "$(dirname -- "$1")"
  printf '%b' "$2" >"$1"
}

mit='// SPDX-License-Identifier: MIT\n'
gpl='// SPDX-License-Identifier: GPL-3.0-or-later\n'

sound_tree() {
  rm -rf -- "$scratch/tree"
  mkdir -p "$scratch/tree"
  cd "$scratch/tree"
  cp "$checks/../../.clang-format" .
  put flatland/view/view.h "$mit#pragma once\n#include <Eigen/Core>\n#include <vector>\n\n/// The view (bibliography: judd2007, eq. 3.4; dekker1971). See docs/math/view.md.\nint view();\n"
  put flatland/io/scene.cpp "$mit#include <fcntl.h>\n#include <nlohmann/json.hpp>\n\n#include \"flatland/view/view.h\"\n"
  put flatland/CMakeLists.txt '# SPDX-License-Identifier: MIT\nadd_library(flatland_core view/view.cpp)\n'
  put core3d/mesh/mesh.h "$mit#pragma once\n#include \"flatland/view/view.h\"\n"
  put ui/app/window.cpp "$gpl#include <QWidget>\n\n#include \"core3d/mesh/mesh.h\"\n"
  put ui/plot/plot.cpp "$gpl#include <qcustomplot.h>\n"
  put tests/ui/window_test.cpp "$gpl#include <QtTest/QTest>\n\n#include \"window_test.moc\"\n"
  put dev '#!/usr/bin/env bash\n# SPDX-License-Identifier: GPL-3.0-or-later\necho "./dev run"; echo "./dev test"\n'
  put README.md 'Flatland\n\n    ...\n\n./dev run\n./dev test\n\n[Pages](docs/README.md), `flatland/view`, `view.h`\n'
  put docs/README.md '[the view](math/view.md#signs)\n'
  put docs/math/view.md 'See `flatland/view/view.h` and [the start](../README.md).\n'
  put docs/bibliography.bib '@phdthesis{judd2007,\n}\n@article{dekker1971,\n}\n'
}

# sound CHECK: passes on the sound tree.
sound() {
  local output status=0
  sound_tree
  output="$("$checks/$1" "$scratch/tree" 2>&1)" || status=$?
  if [ "$status" -eq 0 ]; then return; fi
  # 77: the check's tool is missing, which the check itself shows as skipped.
  if [ "$status" -eq 77 ]; then return 77; fi
  printf 'FAILED: %s finds fault with the sound tree (%d):\n%s\n' "$1" "$status" "$output"
  mistakes=$((mistakes + 1))
}

# finds CHECK PLACE: fails on the tree as it stands, naming the place.
finds() {
  local output status=0
  planted=$((planted + 1))
  output="$("$checks/$1" "$scratch/tree" 2>&1)" || status=$?
  if [ "$status" -ne 1 ] || ! grep -qF -- "$2" <<<"$output"; then
    printf 'FAILED: %s ended with %d and did not name "%s":\n%s\n' "$1" "$status" "$2" "$output"
    mistakes=$((mistakes + 1))
  fi
  sound_tree
}

sound layering.sh
put flatland/view/view.h "$mit#pragma once\n#include <QString>\n" && finds layering.sh flatland/view/view.h:3
put flatland/view/view.h "$mit  #  include <QtCore/qglobal.h>\n" && finds layering.sh flatland/view/view.h:2
put flatland/view/view.h "$mit#include \"core3d/mesh/mesh.h\"\n" && finds layering.sh flatland/view/view.h:2
put flatland/view/view.h "$mit#include <nlohmann/json.hpp>\n" && finds layering.sh flatland/view/view.h:2
put flatland/view/view.h "$mit#include <boost/rational.hpp>\n" && finds layering.sh flatland/view/view.h:2
put flatland/view/view.h "$mit#include <fcntl.h>\n" && finds layering.sh flatland/view/view.h:2
put flatland/io/scene.h "$mit#include <nlohmann/json.hpp>\n" && finds layering.sh flatland/io/scene.h:2
put flatland/io/json_text.h "$mit#include <nlohmann/json.hpp>\n" && finds layering.sh flatland/io/json_text.h:2
put flatland/io/scene.h "$mit#include \"flatland/io/json_text.h\"\n" && finds layering.sh flatland/io/scene.h:2
put ui/cli/main.cpp "$gpl#include \"flatland/io/json_text.h\"\n" && finds layering.sh ui/cli/main.cpp:2
put flatland/view/other.cpp "$mit#include \"view.h\"\n" && finds layering.sh flatland/view/other.cpp:2
put flatland/view/other.cpp "$mit#include \"../view/view.h\"\n" && finds layering.sh flatland/view/other.cpp:2
put core3d/mesh/mesh.h "$mit#include \"ui/app/window.h\"\n" && finds layering.sh core3d/mesh/mesh.h:2
put core3d/mesh/mesh.h "$mit#include <QVector3D>\n" && finds layering.sh core3d/mesh/mesh.h:2
put core3d/io/obj_reader.cpp "$mit#include <tiny_gltf.h>\n" && finds layering.sh core3d/io/obj_reader.cpp:2
put ui/app/window.cpp "$gpl#include <qcustomplot.h>\n" && finds layering.sh ui/app/window.cpp:2
put ui/app/window.cpp "$gpl#include \"tests/ui/help.h\"\n" && finds layering.sh ui/app/window.cpp:2
put tests/flatland/a_test.cpp "$gpl#include <QTest>\n" && finds layering.sh tests/flatland/a_test.cpp:2
put flatland/CMakeLists.txt 'target_link_libraries(flatland_core PUBLIC Qt6::Core)\n' && finds layering.sh flatland/CMakeLists.txt:1

sound spdx.sh
put flatland/view/view.h '#pragma once\n' && finds spdx.sh flatland/view/view.h:1
put flatland/view/view.h "$gpl" && finds spdx.sh flatland/view/view.h:1
put ui/app/window.cpp "$mit" && finds spdx.sh ui/app/window.cpp:1
put ui/CMakeLists.txt 'add_subdirectory(app)\n' && finds spdx.sh ui/CMakeLists.txt:1
put dev '#!/usr/bin/env bash\n' && finds spdx.sh dev:1

sound machine_paths.sh
# Put together here, or this file would be the fault it plants.
for folder in work root home farm; do
  put docs/math/view.md "first line\nlies in /$folder/here\n" && finds machine_paths.sh docs/math/view.md:2
  put ui/app/window.cpp "const char* k = \"/$folder\";\n" && finds machine_paths.sh ui/app/window.cpp:1
done

if sound format.sh; then
  put ui/app/window.cpp "${gpl}int   a;\n" && finds format.sh ui/app/window.cpp:2
  put flatland/view/view.h "${mit}int* a;\nint *b;\n" && finds format.sh flatland/view/view.h:3
else
  echo "format.sh could not be held against a fault: its clang-format is not installed"
fi

sound docs.sh
put README.md '    ./dev run\n./dev test\n[Pages](docs/README.md)\n' && finds docs.sh "'./dev run'"
put README.md './dev run\n[Pages](docs/README.md)\n' && finds docs.sh "'./dev test'"
put docs/math/view.md '`./dev dance`\n' && finds docs.sh "docs/math/view.md:1: there is no './dev dance'"
put docs/math/view.md 'first\n[x](gone.md)\n' && finds docs.sh docs/math/view.md:2
put docs/math/view.md '![x](../images/gone.png)\n' && finds docs.sh docs/math/view.md:1
put docs/math/lonely.md 'No link leads here.\n' && finds docs.sh docs/math/lonely.md:1
put docs/math/view.md '`view/gone.h`\n' && finds docs.sh docs/math/view.md:1
put docs/math/view.md '`flatland/gone/`\n' && finds docs.sh docs/math/view.md:1
put flatland/view/view.h "$mit/// See docs/math/gone.md.\n" && finds docs.sh flatland/view/view.h:2
put flatland/view/view.h "${mit}int a;  // as in gone/gone.h, here\n" && finds docs.sh flatland/view/view.h:2
put flatland/view/view.h "$mit/// (bibliography: gauss1827)\n" && finds docs.sh flatland/view/view.h:2
put flatland/view/view.h "$mit/// (bibliography: judd2007, p. 3; gauss1827)\n" && finds docs.sh gauss1827
put docs/math/view.md 'After Gauss (bibliography: gauss1827).\n' && finds docs.sh docs/math/view.md:1
rm docs/bibliography.bib && finds docs.sh judd2007

# examples.sh with a stand-in program that knows one scene, the one the page gives.
printf '#!/bin/sh\ncase "$1 $2" in "features a.json") grep -q curves a.json ;; *) exit 1 ;; esac\n' >"$scratch/flatland"
chmod +x "$scratch/flatland"
examples() {
  local status=0
  planted=$((planted + 1))
  "$checks/examples.sh" "$scratch/tree" "$scratch/flatland" >/dev/null 2>&1 || status=$?
  if [ "$status" -ne "$1" ]; then
    printf 'FAILED: examples.sh ended with %d, not %d, for:\n' "$status" "$1"
    cat README.md
    mistakes=$((mistakes + 1))
  fi
}
scene='`a.json`:\n\n```json\n{"curves": []}\n```\n\n'
put README.md "$scene"'```sh\nflatland\nflatland features a.json\n```\n' && examples 0
put README.md "$scene"'```sh\n./dev run features a.json\n```\n' && examples 0
put README.md "$scene"'```sh\nflatland features b.json\n```\n' && examples 1
put README.md "$scene"'```sh\nflatland features a.json | cat\nflatland draw a.json -o x.svg | cat\n```\n' && examples 1
put README.md '```sh\nflatland features a.json\n```\n' && examples 1
put README.md 'No example at all.\n' && examples 1

printf 'planted_faults.sh: %d faults planted, %d mistakes\n' "$planted" "$mistakes"
[ "$mistakes" -eq 0 ]
