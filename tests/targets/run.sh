#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# The library for other machines, cross-compiled by the preset of that name, its tests run by QEMU or by this machine.
#   tests/targets/run.sh TARGET... [--all]     aarch64 riscv64 s390x armhf i386: golden hashes, states, files of worlds;
#                                              --all: every test of the library
# (needs what `scripts/setup targets` installs). It shows bits; of speed it shows nothing. docs/platforms.md has the results.
set -euo pipefail
cd "$(dirname "$0")/../.."
known="aarch64 riscv64 s390x armhf i386"
targets=() all=
for argument in "$@"; do
  case " --all $known " in
    *" $argument "*) ;;
    *) echo "tests/targets/run.sh: unknown target '$argument' ($known)" >&2; exit 2 ;;
  esac
  if [ "$argument" = --all ]; then all=1; else targets+=("$argument"); fi
done
[ ${#targets[@]} -gt 0 ] || { echo "tests/targets/run.sh: which target? ($known)" >&2; exit 2; }

# NEON makes the bits, and fuses nothing.
judge_aarch64() {
  local text fused vectors
  text=$(aarch64-linux-gnu-objdump -d --no-show-raw-insn build/aarch64/lib/libode.so)
  fused=$(grep -cE $'\t(fn?m(add|sub)|fml[as])\t' <<<"$text" || true)
  vectors=$(grep -cE $'\tf(add|sub|mul|div)\tv[0-9]+\.(2d|4s)' <<<"$text" || true)
  echo "aarch64: $vectors vector operations, $fused fused"
  [ "$fused" -eq 0 ] && [ "$vectors" -gt 0 ]
}
emulator() { sed -n 's/^CMAKE_CROSSCOMPILING_EMULATOR:[^=]*=//p' "build/$1/CMakeCache.txt" | tr ';' ' '; }
run_tests() {
  local begin=$SECONDS program
  for program in "${@:2}"; do
    # shellcheck disable=SC2046
    $(emulator "$1") "build/$1/bin/$program" --gtest_brief=1
  done
  echo "$1: $((SECONDS - begin)) s"
}
for target in "${targets[@]}"; do
  programs=(golden_tests)
  [ -z "$all" ] || programs+=(unit_tests contract_tests physics_tests state_tests)
  cmake --preset "$target" -DEPODE_EMULATED_TESTS=$([ -z "$all" ] && echo OFF || echo ON) >/dev/null
  cmake --build --preset "$target" --target "${programs[@]}"
  [ "$target" != aarch64 ] || judge_aarch64
  run_tests "$target" "${programs[@]}"
done
