#!/bin/sh
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# notices.sh COMPARE: the comparison must fail where it has to. Equal records pass; one changed digit, a missing
# record, an additional library message, a lost contact and the same library twice do not.
set -eu
compare=$1
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

cat >"$work/reference.txt" <<'RECORDS'
#library /reference/libode.so.8
step_hinge low/0A/p00/after.A.lvel 1.5 -0.25 2
step_hinge low/0A/p00/f1 100 20 -3
geom_closest_parallel_segments t0/distance 0.5
pair_box_box -/0 4 0.25 0 0 1 1 1 1
pair_box_box -/1 1 0.001 0 0 1 0.001 1 0
sleep_counters t0/enabled 11110000
RECORDS

expect() {
    wanted=$1 what=$2 edit=$3
    sed -e 's:^#library .*:#library /ours/libode.so.8:' -e "$edit" "$work/reference.txt" >"$work/ours.txt"
    status=0
    "$compare" "$work/ours.txt" "$work/reference.txt" "$here/tolerances.tsv" "$here/differences.tsv" \
        >"$work/report.txt" 2>&1 || status=$?
    if [ "$status" -ne "$wanted" ]; then
        cat "$work/report.txt"
        echo "parity_compare: $what: status $status, expected $wanted" >&2
        exit 1
    fi
}

expect 0 "equal records" ''
expect 0 "a difference of 1e-12" 's/lvel 1.5/lvel 1.500000000001/'
expect 1 "a difference of 1e-8" 's/lvel 1.5/lvel 1.50000001/'
expect 1 "not a number" 's/f1 100/f1 nan/'
expect 1 "a missing value" 's/f1 100 20 -3/f1 100 20/'
expect 1 "a missing record" '/f1/d'
expect 1 "a missing block" '/sleep/d'
expect 1 "a message of the library" 's:^step_hinge.*f1.*:&\nstep_hinge low/0A/p00/messages 1:'
expect 1 "a lost contact" 's:-/0 4 0.25.*:-/0 0 0 0 0 0 0 1 1:'
expect 1 "another depth" 's:-/1 1 0.001:-/1 1 0.002:'
expect 0 "a smaller distance where the least is right" 's:distance 0.5:distance 0.4:'
expect 1 "a larger distance there" 's:distance 0.5:distance 0.6:'
expect 1 "another sequence" 's/11110000/11100000/'
expect 2 "the same library" 's:^#library.*:#library /reference/libode.so.8:'
echo "parity_compare notices all of these"
