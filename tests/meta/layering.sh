#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# The arrows of docs/dev/architecture.md, held against every #include and the rooms' CMake files:
#   ui -> core3d -> flatland -> Eigen, std;  Qt only in ui;  QCustomPlot only in ui/plot.
# shellcheck source=tests/meta/common.sh
source "$(dirname -- "${BASH_SOURCE[0]}")/common.sh"

std='^<[a-z_0-9]+>$'                                  # <vector>; POSIX and Qt headers have a dot, slash or capital
posix='^<(sys/)?[a-z_0-9]+\.h>$'                      # <fcntl.h>, <sys/stat.h>: for io, which must flush to disk
qt='^[<"](Q[A-Z]|Qt[A-Z0-9]|q[a-z0-9_]+\.h)'          # <QWidget>, <QtTest/QTest>, <qglobal.h>
qcustomplot='^[<"](.*/)?qcustomplot\.h[>"]$'
own='^"(flatland|core3d|ui|tests)/.+"$'

# The headers that lead to nlohmann_json: flatland/io's own, not installed, for its sources and the
# JSON files of core3d/io alone.
json_headers='flatland/io/(json_text|json_node|curve_json|surface_json)\.h'

# allowed FILE INCLUDE: succeeds if the file may include it; else prints the rule that forbids it.
allowed() {
  local file="$1" include="$2"
  if [[ $include =~ $qcustomplot ]]; then
    [[ $file == ui/plot/* ]] || { echo "QCustomPlot is for ui/plot alone"; return 1; }
    return 0
  fi
  if [[ $include =~ $qt ]]; then
    [[ $file == ui/* || $file == tests/ui/* ]] || { echo "Qt is for ui alone"; return 1; }
    return 0
  fi
  if [[ $include == '"'* ]]; then
    # The moc output is included by the file it belongs to, by its bare name.
    if [[ $include == *.moc\" && ($file == ui/* || $file == tests/ui/*) ]]; then return 0; fi
    [[ $include =~ $own ]] || { echo "own headers are included by their path from the top"; return 1; }
  fi
  if [[ $include =~ ^\"$json_headers\"$ ]]; then
    [[ $file == flatland/io/*.cpp || $file == core3d/io/*_json.cpp || $file =~ ^$json_headers$ ]] ||
      { echo "this header is for the sources of flatland/io and the JSON readers of core3d/io"; return 1; }
  fi
  if [[ $file =~ ^$json_headers$ && $include == '<nlohmann/json_fwd.hpp>' ]]; then return 0; fi
  case "$file" in
    flatland/io/*.cpp)
      [[ $include == '"flatland/'* || $include == '<Eigen/'* || $include == '<nlohmann/'* ||
        $include == '<pugixml.hpp>' || $include =~ $std || $include =~ $posix ]] ||
        { echo "flatland/io may use flatland, Eigen, std, POSIX, nlohmann_json and pugixml"; return 1; } ;;
    flatland/*)
      [[ $include == '"flatland/'* || $include == '<Eigen/'* || $include =~ $std ]] ||
        { echo "flatland may use flatland, Eigen and std"; return 1; } ;;
    core3d/io/gltf_*.cpp)
      [[ $include == '"core3d/'* || $include == '"flatland/'* || $include == '<Eigen/'* ||
        $include == '<nlohmann/'* || $include == '<tiny_gltf.h>' || $include =~ $std ]] ||
        { echo "the glTF reader may use core3d, flatland, Eigen, std, nlohmann_json and TinyGLTF"; return 1; } ;;
    core3d/io/*_json.cpp)
      [[ $include == '"core3d/'* || $include == '"flatland/'* || $include == '<nlohmann/'* || $include =~ $std ]] ||
        { echo "the JSON readers may use core3d, flatland, std and nlohmann_json"; return 1; } ;;
    core3d/*.cpp)
      [[ $include == '"core3d/'* || $include == '"flatland/'* || $include == '<Eigen/'* ||
        $include == '<hwy/'* || $include == '<embree3/'* || $include =~ ^\<[xp]mmintrin\.h\>$ || $include =~ $std ]] ||
        { echo "the sources of core3d may use core3d, flatland, Eigen, std, Highway, Embree and what sets the processor up for it"; return 1; } ;;
    core3d/*)
      [[ $include == '"core3d/'* || $include == '"flatland/'* || $include == '<Eigen/'* ||
        $include =~ $std ]] ||
        { echo "core3d may use core3d, flatland, Eigen and std"; return 1; } ;;
    ui/*)
      [[ $include != '"tests/'* ]] || { echo "the program may not use its tests"; return 1; } ;;
  esac
}

collect \( -name '*.h' -o -name '*.cpp' -o -name '*.inc' \)
while IFS= read -r -d '' file && IFS=: read -r line text; do
  include="$(sed -E 's/^[[:space:]]*#[[:space:]]*include[[:space:]]*//; s/^(<[^>]*>|"[^"]*").*/\1/' <<<"$text")"
  rule="$(allowed "$file" "$include")" || fault "$file:$line" "$include: $rule"
done < <(grep -Zn -E '^[[:space:]]*#[[:space:]]*include' /dev/null "${files[@]}" || true)

# What a library does not include it must not be linked to either.
for room in flatland core3d; do
  if [ -d "$room" ]; then
    while IFS=: read -r file line text; do
      fault "$file:$line" "the libraries are built without Qt: $text"
    done < <(grep -rnEi '\b(Qt[0-9]*::|find_package\(Qt|QCustomPlot)' --include=CMakeLists.txt --include='*.cmake' "$room" || true)
  fi
done
finish
