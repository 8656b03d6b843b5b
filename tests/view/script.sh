#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# script.sh EPODE: the viewer without a window, by keys and mouse of a script; what it says of itself, and that its
# pictures are there and differ where they should.
set -euo pipefail
epode=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
fail() { echo "script: $*" >&2; cat out err >&2; exit 1; }
unset DISPLAY WAYLAND_DISPLAY || true
view() { "$epode" view "$@" > out 2> err; }
line() { sed -n "$1p" out; }

cat > keys <<'END'
# half a second, then by hand
frames 30
key space
print
frames 20
print
key right
key .
print
key left
key ctrl+o
key left
print
key +
key c
picture contacts.png
key tab
key f1
print
picture help.png
key r
print
key ]
print
END
view ragdolls --script keys || fail "exit code $?"
state() { line "$1" | sed 's/.* state \([0-9]*\) .*/\1/'; }
first=$(state 1)
[ "$first" -ge 95 ] && [ "$first" -le 105 ] || fail "30 frames of 1/60 s are 100 steps of 5 ms, not $first"
[ "$(state 2)" = "$first" ] || fail "it goes on while paused"
[ "$(state 3)" = $((first + 2)) ] || fail "two steps"
[ "$(state 4)" = $((first + 1)) ] || fail "back, forth, back"
line 4 | grep -q paused || fail "not paused"
line 5 | grep -q 'speed 2 .*panels 0 help 1' || fail "speed, panels or help"
[ "$(state 6)" = 0 ] || fail "restart"
line 7 | grep -q '^buggy ' || fail "the next scene"
for picture in contacts.png help.png; do
    [ "$(head -c 4 $picture | tail -c 3)" = PNG ] && [ "$(wc -c < $picture)" -gt 50000 ] || fail "$picture is no picture"
done
! cmp -s contacts.png help.png || fail "the pictures are the same"

# A body before its fall, pulled up by the mouse: its own height in the panel is not to be read here, so the contacts
# and the body that was picked are.
cat > mouse <<'END'
frames 60
key space
key tab
double 685 368
print
key d
print
ctrl on
move 685 368
down left
frames 2
move 724 180
print
key space
frames 60
up left
print
END
view ragdolls --stepper quick --script mouse || fail "exit code $?"
line 1 | grep -q ' picked 34 ' || fail "the head of the fourth figure is under that pixel"
line 2 | grep -q ' picked -1 ' || fail "nothing is picked any more"
line 3 | grep -q ' picked 34 ' || fail "a drag with Ctrl picks"
line 4 | grep -q ' running .* picked 34 ' || fail "it goes on"

# A ball that is shot at the wall breaks it: fewer contacts; back before it, it is not there.
printf 'frames 6\nkey space\nprint\nkey e\nkey space\nframes 60\nprint\nkey home\nkey right\nprint\n' > keys
view wall --script keys || fail "exit code $?"
contacts() { line "$1" | sed 's/.* contacts \([0-9]*\) .*/\1/'; }
[ "$(contacts 2)" -lt $(($(contacts 1) - 40)) ] || fail "$(contacts 1) contacts became $(contacts 2): the wall still stands"

# A scene opens as `epode run` runs it.
printf 'frames 2\nprint\n' > keys
for scene in wall pendulum ragdolls; do
    "$epode" run $scene --steps 1 --json > run.json || fail "run $scene"
    stepper=$(sed -n 's/.*"stepper": *"\([a-z]*\)".*/\1/p' run.json)
    grep -q '"world_contacts": *true' run.json && kind='world contacts' || kind='contact joints'
    view $scene --script keys || fail "exit code $?"
    line 1 | grep -q " stepper $stepper $kind\$" || fail "$scene runs with $stepper and $kind"
done
view wall --stepper exact --script keys || fail "exit code $?"
line 1 | grep -q ' stepper exact contact joints$' || fail "the stepper that was asked for"

# A recording, and pictures by frames alone.
"$epode" record pendulum --seconds 0.5 --quiet -o run.epr > out 2> err || fail "record"
printf 'key end\nprint\nkey left\nkey s\nkey e\nprint\n' > keys
view run.epr --script keys || fail "exit code $?"
line 1 | grep -q '^run.epr .*time 0.5 ' || fail "the end of the recording"
view pendulum --frames 3 --picture last.png --width 320 --height 240 || fail "exit code $?"
[ "$(head -c 4 last.png | tail -c 3)" = PNG ] || fail "last.png is no picture"

refused() { local code=0; view "$@" || code=$?; [ $code = 2 ] && [ -s err ] || fail "exit code $code of: $*"; }
refused nowhere --frames 1
refused absent.epr --frames 1
refused pendulum
grep -q 'no display' err || fail "what is missing is not said"
refused pendulum --frames 1 --stepper slow
echo 'press space' > bad
refused pendulum --script bad
grep -q "'press space'" err || fail "the line is not told"
echo 'key sapce' > bad
refused pendulum --script bad
grep -q "no key 'sapce'. Keys: .*space.* ctrl+o" err || fail "the keys are not told"
echo "script: good"
