#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# Programs that know nothing of the recorder, run under `epode capture`: what they print is what they print without it, and the recording
# has their own states, hash by hash; then the same on Debian's library, and with another stepper.
#     run.sh EPODE PROGRAM LIBRARY_FOLDER
set -euo pipefail
program=$1 client=$2 libraries=$3
here=$(cd "$(dirname "$0")" && pwd)
work=$(mktemp -d)
trap 'rm -r "$work"' EXIT
fail() { echo "FAILED: $*" >&2; exit 1; }

# recorded NAME FOLDER COMMAND...: with the libode of FOLDER.
recorded() {
    local name=$1 folder=$2
    shift 2
    LD_LIBRARY_PATH=$folder "$@" > "$work/alone"
    LD_LIBRARY_PATH=$folder "$program" capture -o "$work/$name.epr" -- "$@" > "$work/said" || fail "$name: the recorded program fails"
    cmp -s "$work/alone" "$work/said" || fail "$name: recording changes the program"
    "$program" inspect "$work/$name.epr" --hashes > "$work/hashes" || fail "$name: the recording cannot be read"
    cmp "$work/said" "$work/hashes" || fail "$name: the recording's states are not the program's"
    echo "$name: $(wc -l < "$work/hashes") states, all the program's own"
}

recorded c "$libraries" "$client"
"$program" inspect "$work/c.epr" > "$work/inspected"
for line in 'program +record_client' 'states +61' 'bodies +7' 'geoms +9' 'joints +1'; do
    grep -qE "^$line" "$work/inspected" || { cat "$work/inspected" >&2; fail "no '$line' in what inspect says"; }
done
# The second world has a file of its own.
"$program" inspect "$work/c-2.epr" | grep -qE '^states +21' || fail 'the second world was not recorded'

# With another stepper: the same program, other states; diff says where. The first state is the same.
LD_LIBRARY_PATH=$libraries "$program" capture -o "$work/fast.epr" --stepper fast -- "$client" > /dev/null
code=0
"$program" diff "$work/c.epr" "$work/fast.epr" --json > "$work/diff" || code=$?
[ "$code" = 1 ] && grep -q '"first_step": 1,' "$work/diff" || { cat "$work/diff" >&2; fail 'another stepper makes no difference'; }

# It becomes an animation like any other.
"$program" convert "$work/c.epr" "$work/c.glb"

# It is said whose libode was recorded, and kept in the file.
LD_LIBRARY_PATH=$libraries "$program" capture -o "$work/c.epr" -- "$client" > /dev/null 2> "$work/err"
grep -qE "c.epr': 61 states on Epode /.*/libode" "$work/err" && grep -qE "c-2.epr': 21 states" "$work/err" || fail "not said: $(cat "$work/err")"
"$program" inspect "$work/c.epr" > "$work/inspected"
for line in 'library +/.*libode.*so' 'library_kind +Epode' 'library_configuration +ODE .*ODE_(double|single)_precision'; do
    grep -qE "^$line" "$work/inspected" || fail "no '$line' in what inspect says"
done

# Nothing recorded is an error that says so, whatever was there before; the program's own failure comes first.
cp "$work/c.epr" "$work/before.epr"
code=0
"$program" capture -o "$work/before.epr" -- /bin/true 2> "$work/err" || code=$?
[ "$code" = 1 ] && grep -q "nothing was recorded.*/bin/true" "$work/err" || fail "a program without ODE gave $code: $(cat "$work/err")"
cmp -s "$work/c.epr" "$work/before.epr" || fail 'a recording was lost to a program without ODE'
code=0
"$program" capture -o "$work/none.epr" -- /bin/sh -c 'exit 7' 2> "$work/err" || code=$?
[ "$code" = 7 ] && [ ! -e "$work/none.epr" ] || fail "a failing program gave $code"
code=0
"$program" capture -o "$work/absent/x.epr" -- "$client" 2> "$work/err" > "$work/out" || code=$?
[ "$code" = 1 ] && grep -q "absent/x.epr': No such file" "$work/err" && [ ! -s "$work/out" ] || fail 'a path that cannot be written is not refused at once'

# A program that a signal ends, as Ctrl+C does, leaves a recording that is whole, and it is said so.
for signal in INT TERM KILL; do
    rm -f "$work/cut.epr"
    code=0
    LD_LIBRARY_PATH=$libraries "$program" capture -o "$work/cut.epr" -- "$client" "$signal" > /dev/null 2> "$work/err" || code=$?
    [ "$code" = $((128 + $(kill -l "$signal"))) ] || fail "signal $signal gave $code"
    grep -q 'was ended by signal' "$work/err" && grep -q 'cut.epr.*made whole' "$work/err" || fail "not said: $(cat "$work/err")"
    "$program" inspect "$work/cut.epr" > "$work/inspected" || fail "after signal $signal the recording is not whole"
    "$program" replay "$work/cut.epr" > /dev/null || fail "after signal $signal the recording does not replay"
done

# A program that does not exist is wrong usage.
code=0
"$program" capture -o "$work/x.epr" -- "$work/absent" 2> "$work/err" || code=$?
[ "$code" = 2 ] && grep -q absent "$work/err" || fail 'a program that does not exist is not refused'

debian=/usr/lib/x86_64-linux-gnu
if [ -e "$debian/libode.so.8" ]; then
    recorded debian "$debian" "$client"
    "$program" inspect "$work/debian.epr" > "$work/inspected"
    grep -qE '^library_kind +ODE$' "$work/inspected" && grep -qE "^library +$debian/libode.so.8" "$work/inspected" || fail "Debian's library is not told"
else
    echo 'not tried on the original libode8: it is not installed'
fi
if /usr/bin/python3 -c 'import ode' 2> /dev/null; then
    recorded pyode "$libraries" /usr/bin/python3 "$here/pyode_program.py"
else
    echo 'not tried on python3-pyode: it is not installed'
fi
