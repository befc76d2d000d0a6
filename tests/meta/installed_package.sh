#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# installed_package.sh CMAKE COMPILER BUILD SCRATCH: installs BUILD under SCRATCH and holds the result
# against what other people rely on: the files that a desktop looks for, licences, and a CMake package
# with which a program outside the tree builds and runs.
set -euo pipefail

cmake="$1" compiler="$2" build="$3" scratch="$4"
here="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")" && pwd -P)"
prefix="$scratch/a prefix"
rm -rf -- "$scratch"
mkdir -p "$scratch"

"$cmake" --install "$build" --prefix "$prefix" >"$scratch/install.log"
status=0
expected=(bin/flatland share/doc/flatland/LICENSE share/doc/flatland/LICENSE.flatland-core
  share/doc/flatland/README.md include/flatland/features/features.h)
if grep -q '^FLATLAND_GUI:BOOL=ON' "$build/CMakeCache.txt"; then
  expected+=(share/applications/flatland.desktop share/icons/hicolor/scalable/apps/flatland.svg
    share/metainfo/org.flatland_curves.flatland.metainfo.xml share/mime/packages/flatland.xml)
fi
for file in "${expected[@]}"; do
  [ -s "$prefix/$file" ] || { echo "not installed: $file"; status=1; }
done
# What is installed must not point back into the tree or the build.
source_dir="$(sed -n 's/^CMAKE_HOME_DIRECTORY:INTERNAL=//p' "$build/CMakeCache.txt")"
if grep -rlF --include='*.cmake' --include='*.h' --include='*.desktop' -e "$source_dir" "$prefix"; then
  echo "the files above name the folder they were built in"
  status=1
fi
"$prefix/bin/flatland" --version >"$scratch/version.txt" || { echo "flatland --version fails"; status=1; }

cp "$here/installed_package/"* "$scratch/"
# Warnings of the headers would be somebody else's broken build.
if "$cmake" -S "$scratch" -B "$scratch/build" -G Ninja "-DCMAKE_CXX_COMPILER=$compiler" \
  "-DCMAKE_PREFIX_PATH=$prefix" >"$scratch/log" 2>&1 &&
  "$cmake" --build "$scratch/build" >>"$scratch/log" 2>&1; then
  "$scratch/build/consumer" || status=1
else
  cat "$scratch/log"
  status=1
fi
exit $status
