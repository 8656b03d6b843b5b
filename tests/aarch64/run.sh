#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Library and golden hashes on 64-bit ARM: Debian's cross compiler by the preset `aarch64`, QEMU for the processor.
#   tests/aarch64/run.sh [FILTER]      (needs what `scripts/setup aarch64` installs)
# It shows bits, and that NEON makes them without fusing; of speed it shows nothing.
set -euo pipefail
cd "$(dirname "$0")/../.."
cmake --preset aarch64 >/dev/null
cmake --build --preset aarch64 --target golden_tests
text=$(aarch64-linux-gnu-objdump -d --no-show-raw-insn build/aarch64/lib/libode.so)
count() { grep -cE "$1" <<<"$text" || true; }
fused=$(count $'\t(fn?m(add|sub)|fml[as])\t')
vectors=$(count $'\tf(add|sub|mul|div)\tv[0-9]+\.(2d|4s)')
echo "aarch64: $vectors vector operations, $fused fused"
if [ "$fused" -ne 0 ] || [ "$vectors" -eq 0 ]; then exit 1; fi
begin=$SECONDS
qemu-aarch64 -L /usr/aarch64-linux-gnu build/aarch64/bin/golden_tests --gtest_filter="${1:-*}" --gtest_brief=1
echo "aarch64: $((SECONDS - begin)) s under QEMU"
