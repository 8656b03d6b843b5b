#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh SECONDS [ENDING ...]: builds the targets by clang with sanitizers and runs each (or those of the endings) for so long, or for
# EPODE_FUZZ_RUNS inputs if these take less, from the tests' models. An input that crashes, takes longer than limit.h allows or more than 2 GiB
# is left in out/fuzz/robots/ENDING, and the exit code is 1. What was found is kept there and goes on growing.
set -euo pipefail
cd "$(dirname "$0")/../../.."
seconds=$1
shift
build=build/fuzz_robots
if [ ! -f build/release/build.ninja ]; then cmake --preset release > /dev/null; fi
cmake --build build/release --target ode > /dev/null
cmake -S tests/robots/fuzz -B $build -G Ninja -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_CXX_COMPILER_LAUNCHER="$(command -v ccache || true)" > /dev/null
cmake --build $build -- ${JOBS:+-j$JOBS} > $build/build.txt || { tail -n 40 $build/build.txt; exit 1; }
endings=("$@")
if [ ${#endings[@]} -eq 0 ]; then for target in $build/fuzz_*; do endings+=("${target##*_}"); done; fi
grep -oh '"[A-Za-z_0-9:/]\{2,\}"' robots/read/*.cpp robots/meshes/{collada,glb}.cpp | sort -u > $build/words.dict
failed=0
for ending in "${endings[@]}"; do
  out=out/fuzz/robots/$ending
  mkdir -p "$out/corpus" "$out/seeds"
  find tests/robots/models demos/robots -name "*.$ending" -exec cp {} "$out/seeds" \;
  "$build/fuzz_$ending" -max_total_time="$seconds" -runs="${EPODE_FUZZ_RUNS:--1}" -timeout=120 -rss_limit_mb=2048 -max_len=32768 -dict=$build/words.dict -print_final_stats=1 \
    -artifact_prefix="$out/" "$out/corpus" "$out/seeds" > "$out/log.txt" 2>&1 || failed=1
  echo "$ending: $(grep -E 'number_of_executed_units|ERROR|SUMMARY' "$out/log.txt" | tr '\n' ' ')$(grep -oE 'cov: [0-9]+' "$out/log.txt" | tail -n 1)"
done
exit $failed
