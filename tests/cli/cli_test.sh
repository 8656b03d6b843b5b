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
for name in pendulum chain wall pyramid pile shapes ragdolls buggy fourbar tops dominoes boxes-1000; do has list "^$name +[^ ]"; done
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
has err "no stepper 'best'.*exact quick fast hybrid"
for wrong in '--dt 0' '--dt -1' '--dt x' '--steps 0' '--steps 1.5' '--seconds -1' '--steps 3 --seconds 1' '--iterations 0' '--unknown' \
             '--seconds 1e9 --dt 1e-9' '--threads 0' '--threads 1000000' '--iterations 100001' '--stepper fast --iterations 10001'; do
    # shellcheck disable=SC2086
    expect 2 run pendulum $wrong
    has err .
done
# What is no number is refused at once, by every option of every verb that takes one.
for option in run:--dt run:--seconds run:--steps run:--iterations run:--threads run:--fps record:--dt view:--dt view:--frames view:--width; do
    for value in nan -nan inf -inf 1e999 -3 '' 0x 1,5 '1 2' 99999999999999999999; do
        expect 2 "${option%:*}" pendulum "${option#*:}" "$value"
        lacks out .
    done
done
for value in nan -1 1.5 4294967296; do expect 2 run pile --seed "$value"; done
expect 2 convert a.epr b.csv --fps nan
expect 2 replay a.epr --iterations nan
# More pictures than anybody waits for.
expect 2 run pendulum --dt 1e6 --steps 10 --video "$work/long.mp4"

# A scene is kept in a file, which is described and goes on.
expect 0 save wall "$work/wall.epw" --steps 20
has out 'wall.epw: wall after'
expect 0 info "$work/wall.epw" --json
has out '"world_contacts": true'
expect 0 run "$work/wall.epw" --steps 10 --json
has out '"nans": 0,'
has out '"messages": 0'
expect 0 save pendulum "$work/pendulum.epw" --steps 5 --quiet
expect 0 run "$work/pendulum.epw" --stepper exact --steps 5
expect 2 save wall "$work/wall.txt" --steps 1
has err 'does not end with .epw'
expect 1 info "$work/list"
has err 'no world'
expect 1 run "$work/none.epw"
has err 'cannot be loaded'
expect 2 run "$work/wall.epw" --picture "$work/x.png"

# Why a run went wrong: a line each, with the body to blame; in the recording, too, and nothing where all is well.
expect 0 run wall --steps 20 --diagnose --quiet
has out '^diagnosis: nothing found$'
expect 0 run tops --steps 60 --dt 0.1 --diagnose --quiet --record "$work/tops.epr"
has out '^diagnosis: (warning|error): .*rotates.* \[body [0-9]+\]$'
[[ $(grep -c '^diagnosis: ' "$work/out") -le 3 ]] || fail "more than three causes: $(cat "$work/out")"
expect 0 inspect "$work/tops.epr"
has out 'diagnosis 1.*rotates'
expect 0 replay "$work/tops.epr" --quiet
expect 0 run tops --steps 60 --dt 0.1 --diagnose --quiet --json
has err '(warning|error): .*rotates'
lacks out 'rotates'
expect 0 run tops --steps 60 --dt 0.1 --quiet
lacks out 'diagnosis'

# A mistyped word gets the nearest that there is, in whatever verb.
meant() { grep -qF "Did you mean '$1'?" "$work/err" || fail "'$1' is not suggested: $(cat "$work/err")"; }
expect 2 rnu wall
meant run
expect 2 covnert a.epr b.glb
meant convert
expect 2 run wal
meant wall
expect 2 run wall --stepper hibrid
meant hybrid
expect 2 run wall --stpes 3
meant --steps
expect 2 run wall --thread=2
meant --threads
expect 2 inspect a.epr --hashs
meant --hashes
expect 2 replay a.epr --iteratoins 3
meant --iterations
expect 2 view wall --with 300
meant --width
expect 2 --versoin
meant --version
expect 2 xyzzy
lacks err 'Did you mean'
expect 0 --version
has out '^epode [0-9]+[.][0-9]+.* precision.* with (Epode|ODE) /.*libode.*ODE_(double|single)_precision'

# The report: the table names what the issue asks for, the JSON is one object of plain values.
expect 0 run wall --steps 20 --quiet
for label in bodies joints contacts 'time a step.*median.*p99' 'worst penetration .* at rest, .* at impact' 'worst joint error' 'worst residual' 'energy drift' \
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

# Where a scene says that the motion keeps something, the exact stepper of this library keeps it.
expect 0 run pendulum --json
holds "$(number exact_parts) > 1 && $(number energy_change) < 0.002 && $(number energy_change) > -0.002 && $(number energy_rise) < 0.002"
expect 0 run chain --json
holds "$(number energy_change) < 0.001 && $(number energy_change) > -0.001"
expect 0 run satellite --json
holds "$(number momentum_drift_relative) < 1e-6 && $(number angular_momentum_drift_relative) < 1e-4"
expect 0 run pendulum --steps 10
has out '^stepper +exact, [0-9]+ parts a step, exact rotation.*default'
for stepper in quick fast hybrid; do
    expect 0 run pendulum --steps 10 --stepper $stepper
    lacks out 'should stay 0'
done

# The steppers, and the guide's choice for games: substeps with world-managed contacts. Naming a stepper gives ODE's way.
expect 0 run wall --steps 10
has out '^stepper +fast, world-managed contacts \(the default for games\)'
expect 0 run wall --steps 10 --json
has out '"world_contacts": true,'
has out '"stepper_is_default": true,'
by_default=$(number energy_end)
expect 0 run wall --steps 10 --stepper fast --world-contacts --threads 3 --json
has out '"stepper_is_default": false,'
holds "$(number threads) == 3"
[[ $by_default == "$(number energy_end)" ]] || fail 'three threads give another result than one'
expect 0 run wall --steps 10 --stepper fast --json
has out '"world_contacts": false,'
[[ $by_default != "$(number energy_end)" ]] || fail 'world-managed contacts make no difference'
for stepper in exact quick fast hybrid; do
    for contacts in '' --world-contacts; do
        # shellcheck disable=SC2086
        expect 0 run wall --steps 60 --stepper $stepper $contacts --json --quiet
        has out "\"stepper\": \"$stepper\""
        holds "$(number nans) == 0 && $(number contacts_max) > 100 && $(number penetration) < 0.05"
    done
done
expect 2 run table --world-contacts
has err "'table' makes contacts of its own"
if [[ -e /usr/lib/x86_64-linux-gnu/libode.so.8 && -e $(dirname "$program")/../lib/libode.so.8 ]]; then
    LD_LIBRARY_PATH=/usr/lib/x86_64-linux-gnu expect 0 run wall --steps 10
    has out '^stepper +quick, contact joints'
    for wrong in '--world-contacts' '--threads 2' '--stepper hybrid' '--stepper fast'; do
        # shellcheck disable=SC2086
        LD_LIBRARY_PATH=/usr/lib/x86_64-linux-gnu expect 2 run wall --steps 10 $wrong
    done
fi

# Penetration at rest and at impact are two figures: a ball at 20 m/s is up to 0.1 m deep in what it meets, bricks that lie are not.
expect 0 run wall --steps 10 --stepper quick --json
holds "$(number penetration_at_impact) < 0.01"
expect 0 run boxes-1000 --steps 70 --stepper quick --json
holds "$(number penetration_at_impact) > 0.15 && $(number penetration_at_impact_step) > 20 && $(number penetration_at_impact_step) < 70"
holds "$(number penetration_at_impact) == $(number penetration) && $(number penetration_at_impact_speed) / 60 > 0.5 * $(number penetration)"
holds "$(number penetration_at_rest) < 0.5 * $(number penetration)"

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

# Files that cannot be written: 1, and a message that names them and the reason, before the first step (a million of them would show).
for option in --trace --picture --record --video; do
    [[ $option != --picture && $option != --video ]] || "$program" run table --steps 1 --picture "$work/try.png" --quiet > /dev/null 2>&1 || continue
    file=file$([[ $option == --record ]] && echo .epr)
    expect 1 run pendulum --steps 1000000 $option "$work/absent/$file"
    has err "absent/$file': No such file or directory"
    mkdir -p "$work/folder.epr"
    expect 1 run pendulum --steps 1000000 $option "$work/folder.epr"
    has err "folder.epr': Is a directory"
done
expect 1 convert "$work/absent.epr" "$work/absent/x.csv"
has err "absent/x.csv': No such file"
expect 2 run pendulum --steps 2 --trace "$work/twice" --picture "$work/twice"
if [[ -w /dev/full ]]; then
    expect 1 run pendulum --steps 2000 --trace /dev/full --quiet
    has err '/dev/full.*No space left'
    if "$program" run table --steps 1 --picture "$work/try.png" --quiet > /dev/null 2>&1; then
        expect 1 run table --steps 1 --picture /dev/full --quiet
        has err "cannot write the picture '/dev/full'.*No space left"
    fi
    # No file next to the device: its name says of no format.
    expect 2 run table --steps 1 --html /dev/full --quiet
    has err "'/dev/full'"
    [[ ! -e /dev/full.html ]] || fail '--html made /dev/full.html'
    # Standard output too, of every verb.
    "$program" record wall -o "$work/wall.epr" --steps 200 --quiet > /dev/null
    for words in list --help --version 'run --help' 'run wall --steps 2 --json' 'run wall --steps 2' "inspect $work/wall.epr" \
                 "inspect $work/wall.epr --hashes" "inspect $work/wall.epr --json" "diff $work/wall.epr $work/wall.epr" \
                 "replay $work/wall.epr --quiet"; do
        code=0
        # shellcheck disable=SC2086
        "$program" $words > /dev/full 2> "$work/err" || code=$?
        [[ $code == 1 ]] || fail "'$words' to a full disk gave $code"
        has err 'cannot write to standard output: No space left on device'
    done
    code=0
    "$program" run no-such-scene 2> /dev/full || code=$?
    [[ $code == 2 ]] || fail "a message to a full disk gave $code"
fi
# Closed standard output is as bad, and does not become the recording.
code=0
"$program" record wall -o "$work/closed.epr" --steps 3 --quiet >&- 2> "$work/err" || code=$?
[[ $code == 1 ]] || fail "closed standard output gave $code"
expect 0 inspect "$work/closed.epr"
# A pipe whose reader is gone ends the command without a word; the files are whole by then.
for words in "inspect $work/closed.epr --hashes" "record wall -o $work/piped.epr --steps 50"; do
    # shellcheck disable=SC2086
    { "$program" $words 2> "$work/err"; echo $? > "$work/code"; } | true
    [[ $(cat "$work/code") == 141 || $(cat "$work/code") == 0 ]] || fail "'$words' into a closed pipe gave $(cat "$work/code")"
    lacks err .
done
expect 0 inspect "$work/piped.epr"

# Ctrl+C: the recording is whole and replays, its trace has a line a step, and it is said so.
interrupted() {
    rm -f "$work/stopped.epr"
    "$program" record pendulum -o "$work/stopped.epr" --steps 100000000 --quiet > "$work/out" 2> "$work/err" &
    local process=$! code=0
    for _ in $(seq 100); do [[ -s $work/stopped.epr ]] && break; sleep 0.1; done
    kill -"$1" $process
    wait $process || code=$?
    [[ $code == "$2" ]] || fail "signal $1 gave exit code $code, wanted $2"
    has err 'interrupted after step [0-9]+ of 100000000'
    has err "stopped.epr' is whole and has the [0-9]+ states"
    has out 'stopped early'
    expect 0 inspect "$work/stopped.epr"
}
set -m # in the background of a script SIGINT would be ignored
interrupted TERM 143
interrupted INT 130
set +m

# The picture: a PNG, or a refusal in a build or on a machine that cannot draw.
code=0
"$program" run table --steps 2 --picture "$work/table.png" --quiet > "$work/out" 2> "$work/err" || code=$?
if [[ $code == 0 ]]; then
    [[ $(head -c 8 "$work/table.png" | od -An -tx1 | tr -d ' \n') == 89504e470d0a1a0a ]] || fail 'the picture is not a PNG'
    (($(wc -c < "$work/table.png") > 10000)) || fail 'the picture is nearly empty'
else
    has err 'picture'
    echo "no picture on this machine: $(cat "$work/err")"
fi

finish
