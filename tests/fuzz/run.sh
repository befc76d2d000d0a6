#!/usr/bin/env bash
# SPDX-License-Identifier: GPL-3.0-or-later
# run.sh [SECONDS [READER...]]: builds the fuzzers with clang and runs each for SECONDS (60); a finding
# ends it with its file in build/fuzz/findings. Limits: 512 MB, 5 seconds for one input.
set -euo pipefail
root="$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/../.." && pwd -P)"
seconds="${1:-60}"
readers=(ply obj stl off gltf scene svg path lesson formula)
if [ $# -gt 1 ]; then readers=("${@:2}"); fi

compiler="$(command -v clang++-14 || command -v clang++)"
build="$root/build/fuzz"
mkdir -p "$build"
cmake -S "$root" -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Release -DCMAKE_CXX_COMPILER="$compiler" \
  -DFLATLAND_FUZZ=ON -DFLATLAND_GUI=OFF -DFLATLAND_BENCH=OFF >"$build/configure.log" 2>&1 ||
  { cat "$build/configure.log"; exit 1; }
cmake --build "$build" --target "${readers[@]/#/fuzz_}"
python3 "$root/tests/fuzz/make_corpus.py" "$build/first" "$root"
mkdir -p "$build/findings"
for reader in "${readers[@]}"; do
  mkdir -p "$build/corpus/$reader"
  echo "fuzzing $reader for $seconds s"
  # Without -e: its status counts, 0 when the time runs out, and not that of grep, which may find nothing.
  set +e
  "$build/bin/fuzz_$reader" -max_total_time="$seconds" -timeout=5 -rss_limit_mb=512 -max_len=4096 \
    -print_final_stats=1 -verbosity=0 -artifact_prefix="$build/findings/$reader-" \
    "$build/corpus/$reader" "$build/first/$reader" 2>&1 | grep -E 'stat::(number|peak|average)|ERROR|SUMMARY|artifact'
  status="${PIPESTATUS[0]}"
  set -e
  if compgen -G "$build/findings/$reader-*" >/dev/null; then
    echo "found something: $build/findings"
    exit 1
  fi
  if [ "$status" -ne 0 ]; then
    echo "the fuzzer of $reader ended with status $status"
    exit 1
  fi
done
