#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted_complexity.sh CHECK_COMPLEXITY...: a function of 16 branches is found, in a source and in a kernel's text; one of 15 is not,
# and a tree without functions is no answer.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
judge() { "$@" --root "$work" > "$work/said"; }
function_of() { # NAME DECISIONS
  printf 'int %s(int x)\n{\n' "$1"
  for ((i = 0; i < $2; ++i)); do printf '    if (x == %d) return %d;\n' $i $i; done
  printf '    return 0;\n}\n'
}
mkdir -p "$work/src/step" "$work/src/solve/exact"
if judge "$@"; then echo "an empty tree is accepted"; exit 1; fi
function_of fifteen 14 > "$work/src/step/good.cpp"
judge "$@" || { echo "fifteen branches are refused:"; cat "$work/said"; exit 1; }
function_of sixteen 15 > "$work/src/solve/exact/bad.inc"
if judge "$@"; then echo "a planted function is not found"; exit 1; fi
grep -q 'src/solve/exact/bad.inc:1: sixteen has a cyclomatic number of 16' "$work/said" || { cat "$work/said"; exit 1; }
