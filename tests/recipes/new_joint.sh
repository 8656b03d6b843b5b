#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# new_joint.sh SOURCE OBJECTS COMPILER...: scripts/new-joint in a copy of the tree. What it makes passes the tools, is judged by the contract of joints
# and swings in every stepper. OBJECTS: a file with the library's objects, of which the registry alone is compiled again.
set -euo pipefail
source=$1 objects=$2
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cp -r "$source"/{src,include,tests,tools,scripts,docs,CONTRIBUTING.md,.clang-format} "$work"
cd "$work"

touched=$(scripts/new-joint TetherRope | grep -c '^  ')
[ "$touched" -eq 7 ] || { echo "not seven files: $touched"; exit 1; }
for bad in tether "Two Words" Ball TetherRope; do
  if scripts/new-joint "$bad" 2> said; then echo "'$bad' is taken"; exit 1; fi
  grep -q '^new-joint: ' said
done
tools/check_layers.py
tools/check_docs.py | tail -1 | grep -q ' 0 faults' || { tools/check_docs.py; exit 1; }
! command -v clang-format-14 > /dev/null || clang-format-14 --dry-run --Werror src/joints/types/tether_rope.cpp tests/physics/joints/tether_rope_joint_test.cpp include/ode/*.h

compile() { "$@" -std=c++20 -Wall -Wextra -Werror -ffp-contract=off -Iinclude -Isrc; }
compile "${@}" -O1 -c src/joints/types/tether_rope.cpp -o tether_rope.o &
compile "${@}" -O1 -c src/joints/registry.cpp -o registry.o
wait $!
compile "${@}" -O0 tests/physics/joints/tether_rope_joint_test.cpp tests/contract/joint_contract.cpp tests/contract/joint_geometry.cpp \
  tether_rope.o registry.o $(tr ';' '\n' < "$objects" | grep -v -e joints/registry.cpp -e cmake_pch) -lgtest -lgtest_main -pthread -o judge
./judge --gtest_brief=1 --gtest_filter='*TetherRope*'
