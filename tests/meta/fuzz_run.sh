#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# fuzz_run.sh ROOT: tests/fuzz/run.sh passes only where the fuzzer itself ends well. Compiler, cmake
# and python are stand-ins that do nothing.
set -euo pipefail
scratch="$(mktemp -d)"
trap 'rm -rf -- "$scratch"' EXIT
mkdir -p "$scratch/tests/fuzz" "$scratch/build/fuzz/bin" "$scratch/tools"
cp "$1/tests/fuzz/run.sh" "$scratch/tests/fuzz/"
for tool in cmake clang++-14 python3; do
  printf '#!/bin/sh\nexit 0\n' >"$scratch/tools/$tool"
  chmod +x "$scratch/tools/$tool"
done
mistakes=0

# expect STATUS WHAT BODY: what run.sh ends with if the fuzzer is a shell script of BODY
expect() {
  local status=0
  printf '#!/bin/sh\n%s\n' "$3" >"$scratch/build/fuzz/bin/fuzz_obj"
  chmod +x "$scratch/build/fuzz/bin/fuzz_obj"
  PATH="$scratch/tools:$PATH" "$scratch/tests/fuzz/run.sh" 1 obj >/dev/null 2>&1 || status=$?
  if [ "$status" -ne "$1" ]; then
    echo "$2: run.sh ended with $status, not $1"
    mistakes=$((mistakes + 1))
  fi
}
expect 0 'the time ran out' 'echo stat::number_of_executed_units: 5'
expect 0 'the time ran out and nothing was said' 'exit 0'
expect 1 'the fuzzer did not start' 'exit 127'
expect 1 'the fuzzer failed with statistics' 'echo stat::number_of_executed_units: 5; exit 77'
[ "$mistakes" -eq 0 ] && echo 'fuzz_run.sh: as expected'
