#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# The benchmark program: that it measures what it says and refuses what it cannot. How fast anything is, is no matter of a test.
set -uo pipefail
program=$1
compare=$2
exact=$3
accuracy=$4
source "$(dirname "$0")/harness.sh"

expect 0 wall --steps 10 --repeat 2
for key in library ms_median ms_p10 ms_p90 ms_collide ms_step ms_empty penetration_worst energy_end; do has out "^$key +[0-9/-]"; done
has out '^library +/.*libode'
expect 0 wall --steps 10 --repeat 2 --json
holds "$(number ms_p10) <= $(number ms_median) && $(number ms_median) <= $(number ms_p90) && $(number ms_step) > 0"
holds "$(number steps) == 10 && $(number contacts_mean) > 100 && $(number nans) == 0"

# Every problem of the exact stepper's table that a test has time for: solved (in single precision too), and the rows that it is named for.
for problem in box:12 chain-8:24 pile-20:219 chain-32-heavy:96 chain-100:300 wall-16:300 ladder-64:1280; do
    expect 0 exact-table --problem "${problem%:*}" --steps 1 --velocities "$work/velocities"
    has out "^${problem/:/ } [0-9.]+ [0-9.]+ "
    awk '!/^#/ && ($5 > 1e-5 || $8 + $10 > 0) { print; bad = 1 } END { exit bad }' "$work/out" || fail "exact-table: $problem is not solved"
done
for problem in chain-12 chain-24 chain-300 stack-12 stack-60 stack-300 gable-48 gable-108 gable-288; do
    expect 0 exact-table --problem "size-$problem" --steps 1
    has out "^size-$problem ${problem#*-} "
done
expect 0 exact-table --problem ladder-64 --steps 1 --velocities "$work/velocities"
(($(wc -l < "$work/velocities") == 192)) || fail 'exact-table has not written the velocities of 64 x 3 bodies'
expect 0 make-pile --count 3 --rows 12
has out '^contact [0-2] (-1|[0-2]) '
expect 1 make-pile --count 1 --rows 1000

# Tests that have a truth, briefly: a bounce loses what semi-implicit Euler loses, a chain of equal links gaps less than one.
expect 0 accuracy bouncing --dt 0.1
has out '^bouncing exact 0.1 - 0 [12][.][0-9]+e[+]06 .* messages 0 contacts'
expect 0 accuracy rolling --variant y --dt 0.1
awk '{ exit !($6 < 1e-5) }' "$work/out" || fail 'rolling is wrong'
expect 0 accuracy whip --dt 0.01 --trace "$work/gaps"
(($(wc -l < "$work/gaps") == 1000)) || fail 'whip has not traced 1,000 steps'
awk '{ exit !($6 > 0.01 && $6 < 1) }' "$work/out" || fail 'whip has another gap than it had'

# field KEY: the number of a key in JSON on one line.
field() { grep -oE "\"$1\":-?[0-9.e+-]+" "$work/out" | sed 's/^.*://'; }

# Benchmark scenes: every one that is not mere rays or pairs is alive after its first steps.
while read -r scene; do
    expect 0 run "$scene" --quick --steps 3 --no-quality
    holds "$(field ms) > 0"
done < <("$program" scenes | sed -E 's/^.*"name":"([^"]+)".*$/\1/')
expect 0 run S1 --quick
holds "$(field bodies) == 79 && $(field lost) == 0 && $(field drift_max) < 0.1 && $(field penetration_max) > 0.001"
cp "$work/out" "$work/first"
expect 0 run S1 --quick
[[ $(grep -o '"hash":"[0-9a-f]*"' "$work/out") == $(grep -o '"hash":"[0-9a-f]*"' "$work/first") ]] || fail 'two runs of S1 differ'
expect 0 export S4 --quick
has out '"kind":"hinge","body1":'
# Three boxes of 1 m on the floor: one sunk by 0.1, one that lies 0.05 in it, one apart, moving; by hand.
{
    echo 'state 1'
    echo '0 0 -1 1 0 0 0 0 0 0 0 0 0'
    echo '0 0 0.4 1 0 0 0 0 0 0 0 0 0'
    echo '5 0 0.6 1 0 0 0 3 0 0 0 0 0'
    echo '0.3 0.2 1.35 1 0 0 0 0 0 0 0 0 0'
} > "$work/states"
expect 0 judge S1 --size 2 "$work/states"
holds "$(field penetration_end_pairs) == 2 && ($(field penetration_max) - 0.1)^2 < 1e-12 && ($(field penetration_mean) - 0.075)^2 < 1e-12"
holds "($(field speed) - sqrt(3))^2 < 1e-9"
# A buggy whose wheels are spheres of radius 0.35 at z = 0.4: one 0.1 in the floor, its spring pressed, which is no error;
# one 0.03 off its axle.
{
    echo 'state 1'
    echo '0 0 -1 1 0 0 0 0 0 0 0 0 0'
    echo '-2.5 -2 0.6 1 0 0 0 0 0 0 0 0 0'
    echo '-3.6 -2.8 0.25 1 0 0 0 0 0 0 0 0 0'
    echo '-3.57 -1.2 0.4 1 0 0 0 0 0 0 0 0 0'
    echo '-1.4 -2.8 0.4 1 0 0 0 0 0 0 0 0 0'
    echo '-1.4 -1.2 0.4 1 0 0 0 0 0 0 0 0 0'
} > "$work/buggy"
expect 0 judge S11 --size 1 "$work/buggy"
holds "$(field penetration_end_pairs) == 1 && ($(field penetration_max) - 0.1)^2 < 1e-12 && ($(field joint_error_max) - 0.03)^2 < 1e-12"
sed -i 's/0[.]4/nan/' "$work/states"
expect 1 judge S1 --size 2 "$work/states"
expect 2 judge S1 "$work/states"
has err 'no file of states'
expect 2 run none
has err 'Scenes: S1 S2 '
expect 2 run S1 --engine none
expect 2 run S1 --threads 0

expect 2
expect 2 no-such-scene
has err 'Scenes: pendulum'
expect 2 wall --stepper best
expect 2 wall --repeat 0
expect 2 exact-table --problem none
has err 'chain-4096'
expect 2 accuracy no-such-test
expect 2 accuracy whip --stepper none
expect 2 exact-table --problem box --velocities /no/such/folder/file

program=$compare
expect 2 --unknown
expect 2 --rounds none
expect 2 --bench /no/such/program
has err 'there is no /no/such/program'

here=(--bench "$1" --ours "$(dirname "$1")/../lib")
# In single precision there is no library of ours that Debian's could be put in place of.
if [[ -e $(dirname "$1")/../lib/libode.so.8 ]]; then
    expect 2 --only none "${here[@]}"
    has err 'no such scene; there are S1 S2 '
    expect 0 --quick --rounds 1 --only S5-32 --strict "${here[@]}"
    has out '^  ours +[0-9.]+ '
    has out '^  debian +[0-9.]+ '
fi
program=$exact
expect 2 --only none "${here[@]}"
# In single precision there is no library of ours that Debian's could be put in place of.
[[ ! -e $(dirname "$1")/../lib/libode.so.8 ]] || has err 'no problem none'
expect 2 --bench /no/such/program

program=$accuracy
expect 2 --only none "${here[@]}"
[[ ! -e $(dirname "$1")/../lib/libode.so.8 ]] || has err 'no test none'

finish
