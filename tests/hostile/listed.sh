#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# listed.sh ERRORS TESTS: the tests that the table "Inside callbacks of the program" of docs/errors.md names are there, and the
# table names each kind of them.
errors=$1 tests=$2 faults=0
kinds=$(sed -n '/^## Inside callbacks/,/^### /s/^| .*| \(.*\) |$/\1/p' "$errors" | grep -o '`[a-z_]*_\.\.\.`' | tr -d '`.')
fault()
{
    echo "FAULT: $1"
    faults=$((faults + 1))
}

for kind in $kinds; do
    grep -q "^TEST_F(Callbacks, $kind" "$tests" || fault "without a test: $kind"
done
for test in $(sed -n 's/^TEST_F(Callbacks, \(.*\))$/\1/p' "$tests"); do
    known=0
    for kind in $kinds; do case $test in "$kind"*) known=1 ;; esac; done
    [ $known = 1 ] || fault "not in the table: $test"
done
echo "$(echo "$kinds" | wc -w) kinds, $faults faults"
[ $faults -eq 0 ] && [ -n "$kinds" ]
