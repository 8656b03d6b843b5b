#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# run.sh SECONDS [RUNS]: builds the targets by clang with sanitizers and runs each for so long or so many inputs, from valid inputs that
# it writes itself and with random numbers of one seed; what was found in earlier runs is the beginning of the next. An input that
# crashes, takes more time or memory than meter.h allows is left in out/fuzz/TARGET, and the exit code is 1.
set -euo pipefail
cd "$(dirname "$0")/../.."
seconds=$1
runs=${2:--1}
export ASAN_OPTIONS=quarantine_size_mb=16
cmake -S . -B build/fuzz -G Ninja -DCMAKE_C_COMPILER=clang-14 -DCMAKE_CXX_COMPILER=clang++-14 -DCMAKE_BUILD_TYPE=Debug \
  -DCMAKE_CXX_FLAGS_DEBUG="-O1 -g1" -DEPODE_SANITIZE=address -DEPODE_FUZZ=ON -DEPODE_PRECISIONS=double \
  -DEPODE_TESTS=OFF -DEPODE_TOOLS=OFF > /dev/null
cmake --build build/fuzz --target fuzz_state fuzz_world_file fuzz_recording
failed=0
for target in state world_file recording; do
  mkdir -p out/fuzz/$target/corpus out/fuzz/$target/seeds
  EPODE_FUZZ_SEEDS=out/fuzz/$target/seeds build/fuzz/bin/fuzz_$target -runs=0 > /dev/null 2>&1
  nice build/fuzz/bin/fuzz_$target -max_total_time="$seconds" -runs="$runs" -seed=1 -timeout=60 -rss_limit_mb=1024 -max_len=16384 -print_final_stats=1 \
    -artifact_prefix=out/fuzz/$target/ out/fuzz/$target/corpus out/fuzz/$target/seeds > out/fuzz/$target.log 2>&1 || failed=1
  grep -E 'number_of_executed_units|ERROR|SUMMARY' out/fuzz/$target.log || true
done
exit $failed
