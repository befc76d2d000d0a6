#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# dev_script.sh ROOT: holds ./dev against machines that are not at hand. apt-get, dpkg-query, sudo, cmake,
# ctest and the program are stand-ins that write down how they were called; ./dev itself is the real one, in a
# folder with spaces, called from elsewhere.
set -euo pipefail

root="$(cd -- "$1" && pwd -P)"
scratch="$(mktemp -d)"
trap 'rm -rf -- "$scratch"' EXIT
home="$scratch/a folder/with spaces"
calls="$scratch/calls"
mistakes=0
checked=0

stand_in() {
  printf '#!/bin/bash\n%s\n' "$2" >"$scratch/bin/$1"
  chmod +x "$scratch/bin/$1"
}

# machine INSTALLED: a machine with these packages; root, no sudo, tools of the right age.
machine() {
  rm -rf -- "${scratch:?}/bin" "$home" "$calls"
  mkdir -p "$scratch/bin" "$home/build/release/bin"
  cp "$root/dev" "$home/dev"
  : >"$calls"
  # Only what ./dev needs of the real machine: whatever else is installed here must not help it.
  local tool
  for tool in bash env readlink dirname basename mkdir cat printf sed head sort grep uname rm nproc find xargs; do
    ln -s "$(command -v $tool)" "$scratch/bin/$tool"
  done
  stand_in id 'echo 0'
  stand_in dpkg-query "[[ ' $1 ' == *\" \${*: -1} \"* ]] && printf installed"
  stand_in apt-get "echo \"apt-get \$*\" >>'$calls'"
  # Of two names of a package only the second is known: the release decides, not the list.
  stand_in apt-cache 'if [ "$2" = clang-format-14 ]; then echo "  Candidate: (none)"; else echo "  Candidate: 1.0"; fi'
  stand_in ninja ''
  stand_in cmake "if [ \"\$1\" = --version ]; then echo 'cmake version 3.25.1'; exit; fi
echo \"cmake \$*\" >>'$calls'"
  # Tests need an open stdin, though the caller has closed his.
  stand_in ctest "{ true 3<&0; } 2>/dev/null || exit 9
echo \"ctest \$*\" >>'$calls'; echo '100% tests passed'"
  printf '#!/bin/bash\necho "flatland $*" >>"%s"; echo output of the program\n' "$calls" >"$home/build/release/bin/flatland"
  chmod +x "$home/build/release/bin/flatland"
}
all='cmake g++ ninja-build libeigen3-dev nlohmann-json3-dev libcli11-dev libpugixml-dev libtinygltf-dev libhwy-dev libembree-dev
 qt6-base-dev libqt6opengl6-dev libgl-dev qt6-svg-dev qt6-tools-dev qt6-tools-dev-tools qt6-l10n-tools qt6-translations-l10n
 libqcustomplot-dev fonts-dejavu-core libgtest-dev libbenchmark-dev libboost-dev xvfb xauth libgl1-mesa-dri fonts-urw-base35'
all="${all//$'\n'/}"

# dev EXPECTED_STATUS ARGS...: runs ./dev there with an empty environment and closed stdin.
dev() {
  local expected="$1" status=0
  shift
  (cd / && env -i PATH="$scratch/bin" HOME="$scratch" ${display:+DISPLAY="$display"} ${ci:+CI="$ci"} "$home/dev" "$@" \
    >"$scratch/out" 2>"$scratch/err" <&-) || status=$?
  checked=$((checked + 1))
  [ "$status" -eq "$expected" ] || wrong "./dev $*: exit code $status, not $expected"
}
wrong() {
  printf 'FAILED: %s\n' "$1"
  sed 's/^/    /' "$calls" "$scratch/out" "$scratch/err"
  mistakes=$((mistakes + 1))
}
has() { grep -qF -- "$2" "$scratch/$1" || wrong "no '$2' in $1"; }
lacks() { if grep -qF -- "$2" "$scratch/$1"; then wrong "'$2' in $1"; fi; }

# A machine that has everything is left alone.
machine "$all"
dev 0 test
lacks calls apt-get
has calls 'cmake --preset release -DCMAKE_CXX_COMPILER_LAUNCHER= -DFLATLAND_TESTS=ON -DFLATLAND_BENCH=ON'
has calls '-LE ^slow$'
[ "$(tail -n 1 "$scratch/out")" = '100% tests passed' ] || wrong "ctest does not have the last word"
dev 0 test --slow -R roots
has calls '-R roots'
[ "$(grep -c 'slow' "$calls")" -eq 1 ] || wrong "--slow still leaves tests out"

# The tests' exit code is that of ./dev, and without a build there are no tests.
stand_in ctest 'exit 8'
dev 8 test
stand_in cmake "if [ \"\$1\" = --version ]; then echo 'cmake version 3.25.1'; exit; fi
if [ \"\$1\" = --build ]; then exit 3; fi"
stand_in ctest "echo ctest >>'$scratch/ctest-ran'"
dev 3 test
[ ! -e "$scratch/ctest-ran" ] || wrong "tests of a failed build were run"

# What is missing is installed, and nothing else is.
machine "${all/libcli11-dev/}"
dev 0 run features scene.json
has calls 'update'
has calls 'install --no-install-recommends libcli11-dev'
lacks calls xvfb
has calls 'flatland features scene.json'
[ "$(cat "$scratch/out")" = 'output of the program' ] || wrong "something else is on the program's stdout"
machine ''
dev 0 install-deps run
has calls 'g++'
lacks calls libgtest-dev
dev 0 install-deps
has calls libgtest-dev

# A package of two names is asked for by the one that this release has, and either will do.
machine "$all"
ci=true dev 0 test
has calls 'install --no-install-recommends clang-format'
lacks calls clang-format-14
for name in clang-format clang-format-14; do
  machine "$all $name"
  ci=true dev 0 test
  lacks calls apt-get
done

# Not root: through sudo; without sudo it says what to do and goes on, for CMake has the last word.
machine "${all/xvfb/}"
stand_in id 'echo 1000'
dev 0 test
lacks calls apt-get
has err 'apt-get install --no-install-recommends xvfb'
has calls ctest
stand_in sudo "echo \"sudo \$*\" >>'$calls'; exec \"\$@\""
dev 0 test
has calls 'sudo env DEBIAN_FRONTEND=noninteractive apt-get'

# An installation that fails is said; the build is tried all the same.
stand_in apt-get 'exit 100'
dev 0 test
has err 'could not install'

# No apt-get at all: the list of needs, and on.
machine "$all"
rm "$scratch/bin/apt-get" "$scratch/bin/dpkg-query"
dev 0 test
has err 'Qt 6.4'
has calls ctest

# An old or missing CMake, a missing Ninja and a failed configuration end with what is needed.
stand_in cmake 'echo "cmake version 3.9.6"'
dev 1 run
has err 'CMake 3.9.6 is too old'
rm "$scratch/bin/cmake"
dev 1 run
has err 'CMake is missing'
machine "$all"
rm "$scratch/bin/ninja"
dev 1 run
has err 'Ninja is missing'
machine "$all"
stand_in cmake 'if [ "$1" = --version ]; then echo "cmake version 3.25.1"; exit; fi; echo "no Qt here"; exit 1'
dev 1 run
has err 'no Qt here'
has err 'Flatland needs'

# ./dev run alone leaves the tests out of the configuration; once they are in, it leaves them in.
machine "$all"
dev 0 run --help
has calls '-DFLATLAND_TESTS=OFF'
: >"$calls"
touch "$home/build/release/CTestTestfile.cmake"
dev 0 run --help
lacks calls '-DFLATLAND_TESTS=OFF'

# Without a display: pictures for the window, the program itself for everything else.
machine "$all"
dev 0 run
has err 'no display'
has calls "draw preset:thesis -o $home/out/drawing.svg"
has calls "draw preset:thesis -o $home/out/drawing.png"
has calls "shot preset:thesis -o $home/out/window.png"
has out "$home/out/window.png"
touch "$scratch/scene.json"
dev 0 run "$scratch/scene.json"
has calls "shot $scratch/scene.json -o"
: >"$calls"
dev 0 run --version
has calls 'flatland --version'
lacks calls shot
# With a display: the window, with the arguments as they are.
: >"$calls"
display=:0 dev 0 run 'a scene.json'
has calls 'flatland a scene.json'
lacks calls shot

dev 1 dance
has err "no command 'dance'"
dev 1 build sideways
has err "no preset 'sideways'"

printf 'dev_script.sh: %d calls of ./dev, %d mistakes\n' "$checked" "$mistakes"
[ "$mistakes" -eq 0 ]
