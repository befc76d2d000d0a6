#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# headers_alone_fails.sh CMAKE COMPILER SCRATCH: holds headers_alone.cmake against three headers: a
# sound one must build; one that leans on its includer, and one without include guard, must not.
set -euo pipefail

cmake="$1" compiler="$2" scratch="$3"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)"

# builds HEADER_TEXT: true if a library with this one header builds.
builds() {
  rm -rf -- "$scratch"
  mkdir -p "$scratch/room"
  printf '%b' "$1" >"$scratch/room/a_header.h"
  cat >"$scratch/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.22)
project(headers LANGUAGES CXX)
function(flatland_target target)
  target_include_directories(\${target} PRIVATE \${PROJECT_SOURCE_DIR})
endfunction()
include("$here/headers_alone.cmake")
headers_alone(room_headers_alone room)
END
  # A project that cannot be configured would look like a header that cannot be compiled.
  "$cmake" -S "$scratch" -B "$scratch/build" -G Ninja "-DCMAKE_CXX_COMPILER=$compiler" >"$scratch/log" || exit 1
  "$cmake" --build "$scratch/build" >>"$scratch/log" 2>&1
}

status=0
builds '#pragma once\n#include <string>\nstruct A { std::string name; };\n' ||
  { echo "a sound header does not build:"; cat "$scratch/log"; status=1; }
if builds '#pragma once\nstruct A { std::string name; };\n'; then
  echo "a header that lacks an #include was not found"
  status=1
fi
if builds '#include <string>\nstruct A { std::string name; };\n'; then
  echo "a header without include guard was not found"
  status=1
fi
exit $status
