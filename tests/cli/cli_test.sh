#!/bin/bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# The command `epode`: what it lists, what it refuses and how, what its report and its files hold. No Python, no JSON tool: the JSON is
# checked line by line, which its layout (one key a line) allows.
set -uo pipefail
program=$1
source "$(dirname "$0")/harness.sh"

# Every scene that is listed runs, on its own stepper and on quick, with finite numbers.
expect 0 list
cp "$work/out" "$work/list"
for name in pendulum chain wall pyramid pile ragdolls buggy fourbar tops dominoes boxes-1000; do has list "^$name +[^ ]"; done
while read -r name _; do
    expect 0 run "$name" --steps 5 --json --quiet
    has out "\"scene\": \"$name\""
    has out '"nans": 0,'
    expect 0 run "$name" --steps 5 --stepper quick --json --quiet
    has out '"stepper": "quick"'
done < "$work/list"

# Help is no error; anything wrong is 2 and says what would be right.
expect 0 --help
has out 'list'
expect 0 run --help
has out '--picture'
expect 2
expect 2 nonsense
expect 2 run
expect 2 run no-such-scene
has err "no scene 'no-such-scene'.*pendulum.*boxes-1000"
lacks out .
expect 2 run pendulum --stepper best
has err "no stepper 'best'.*exact quick fast"
for wrong in '--dt 0' '--dt -1' '--dt x' '--steps 0' '--steps 1.5' '--seconds -1' '--steps 3 --seconds 1' '--iterations 0' '--unknown' \
             '--seconds 1e9 --dt 1e-9'; do
    # shellcheck disable=SC2086
    expect 2 run pendulum $wrong
    has err .
done

# The report: the table names what the issue asks for, the JSON is one object of plain values.
expect 0 run wall --steps 20 --quiet
for label in bodies joints contacts 'time a step.*median.*p99' 'worst penetration' 'worst joint error' 'worst residual' 'energy drift' \
             'momentum drift' 'NaNs +0$'; do
    has out "^$label"
done
lacks err .
expect 0 run fourbar --steps 20 --json --quiet
value='(-?[0-9][0-9.e+-]*|null|true|false|"[^"]*")'
[[ $(head -n 1 "$work/out") == '{' && $(tail -n 1 "$work/out") == '}' ]] || fail 'the JSON is not one object'
body=$(sed '1d;$d' "$work/out")
[[ -z $(grep -vE "^  \"[a-z0-9_]+\": $value,?\$" <<< "$body") ]] || fail 'a line of the JSON is not "key": value'
[[ -z $(sed '$d' <<< "$body" | grep -vE ',$') ]] || fail 'a comma is missing in the JSON'
[[ $(tail -n 1 <<< "$body") != *, ]] || fail 'a comma is left over in the JSON'
[[ -z $(sed -E 's/^ *("[^"]*").*/\1/' <<< "$body" | sort | uniq -d) ]] || fail 'a key appears twice in the JSON'
for key in bodies joints contacts_mean contacts_max ms_median ms_p99 penetration joint_error energy_change momentum_drift nans; do
    [[ -n $(number "$key") ]] || fail "the JSON has no number '$key'"
done
holds "$(number bodies) == 6 && $(number joints) == 8 && $(number steps) == 20"
holds "$(number ms_p99) >= $(number ms_median)"

# What the figures must be: a lossless pendulum keeps its energy the better the smaller the step, an isolated system its momentum.
expect 0 run pendulum --seconds 2 --json
coarse=$(number energy_change)
holds "$(number steps) == 200 && ($coarse < 0 ? -$coarse : $coarse) < 0.1"
expect 0 run pendulum --seconds 2 --dt 0.001 --json
fine=$(number energy_change)
holds "$(number steps) == 2000 && ($fine < 0 ? -$fine : $fine) < 0.5 * ($coarse < 0 ? -$coarse : $coarse)"
expect 0 run satellite --steps 400 --json
has out '"momentum_conserved_by_scene": true'
holds "$(number momentum_drift_relative) < 1e-6"

# --seconds and --dt decide the number of steps; the seed decides the pile.
expect 0 run pendulum --seconds 0.5 --dt 0.0125 --json
holds "$(number steps) == 40"
expect 0 run pile --steps 3 --seed 7 --json
seven=$(number energy_start)
expect 0 run pile --steps 3 --seed 7 --json
again=$(number energy_start)
expect 0 run pile --steps 3 --seed 8 --json
[[ $seven == "$again" ]] || fail 'the same seed gave another pile'
[[ $seven != "$(number energy_start)" ]] || fail 'another seed gave the same pile'

# The trace: a line of names and one line a step, each as wide.
expect 0 run buggy --steps 37 --trace "$work/trace.csv" --quiet
[[ $(wc -l < "$work/trace.csv") == 38 ]] || fail 'the trace has not one line a step'
has trace.csv '^time,energy,kinetic,penetration,joint_error,residual,ms,contacts,x0,y0,z0$'
[[ $(awk -F, '{print NF}' "$work/trace.csv" | sort -u | wc -l) == 1 ]] || fail 'lines of the trace differ in width'
holds "$(tail -n 1 "$work/trace.csv" | cut -d, -f1) > 0.1849 && $(tail -n 1 "$work/trace.csv" | cut -d, -f1) < 0.1851"

# Files that cannot be written: 1, and a message that names them.
expect 1 run pendulum --steps 2 --trace "$work/absent/trace.csv"
has err "absent/trace.csv"
if [[ -w /dev/full ]]; then
    expect 1 run pendulum --steps 2000 --trace /dev/full --quiet
    has err '/dev/full'
fi

# The picture: a PNG, or a refusal in a build or on a machine that cannot draw.
code=0
"$program" run table --steps 2 --picture "$work/table.png" --quiet > "$work/out" 2> "$work/err" || code=$?
if [[ $code == 0 ]]; then
    [[ $(head -c 8 "$work/table.png" | od -An -tx1 | tr -d ' \n') == 89504e470d0a1a0a ]] || fail 'the picture is not a PNG'
    (($(wc -c < "$work/table.png") > 10000)) || fail 'the picture is nearly empty'
    expect 1 run table --steps 2 --picture "$work/absent/table.png" --quiet
    has err 'absent/table.png'
else
    has err 'picture'
    echo "no picture on this machine: $(cat "$work/err")"
fi

finish
