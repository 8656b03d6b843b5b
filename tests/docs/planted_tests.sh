#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# planted_tests.sh CHECK_TESTS...: names that are no sentences and hashes outside tests/golden are found; good names, constants of
# generators and golden hashes are not.
set -euo pipefail
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
judge() { "$@" --root "$work" > "$work/said"; }
finds() { grep -qE "$1" "$work/said" || { echo "not '$1':"; cat "$work/said"; exit 1; }; }
mkdir -p "$work/tests/golden" "$work/python/tests"
printf 'TEST(Ball, falls_with_g) { next(0x9e3779b97f4a7c15u, 1e-7, 0x1p-53, 0.12345678901234567890); }\n' > "$work/tests/good_test.cpp"
printf '{"physics/ball", 0x0123456789abcde1},\n' > "$work/tests/golden/physics.inc"
printf 'def test_a_ball_falls():\n    pass\n' > "$work/python/tests/test_good.py"
judge "$@" || { echo "good tests are refused:"; cat "$work/said"; exit 1; }
finds '^tests: ok, 2 tests'

printf 'TEST_P(Ball, FallsWithG) { expect(12345678901234567u); }\nTEST_F(ball, falls_down) { expect(0x0123456789abcde1u); }\nTEST(Ball, falls) {}\n' \
  > "$work/tests/bad_test.cpp"
printf 'def testBall():\n    pass\n' > "$work/python/tests/test_bad.py"
if judge "$@"; then echo "planted names are not found"; exit 1; fi
finds 'bad_test.cpp:1: Ball.FallsWithG:'
finds 'bad_test.cpp:2: ball: a suite'
finds 'bad_test.cpp:3: Ball.falls:'
finds 'bad_test.cpp:1: 12345678901234567:'
finds 'bad_test.cpp:2: 0x0123456789abcde1:'
finds 'test_bad.py:1: testBall:'
