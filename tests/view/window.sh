#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# window.sh EPODE: the viewer in a window of an X server without screen, with keys and mouse by xdotool. 77 where Xvfb or
# xdotool is missing.
set -euo pipefail
epode=$1
command -v Xvfb > /dev/null && command -v xdotool > /dev/null || { echo "window: no Xvfb or xdotool"; exit 77; }
work=$(mktemp -d)
cd "$work"
server= child=
finish() {
    [ -z "$child" ] || kill "$child" 2> /dev/null || true
    [ -z "$server" ] || kill "$server" 2> /dev/null || true
    rm -rf "$work"
}
trap finish EXIT
fail() { echo "window: $*" >&2; cat out err >&2; exit 1; }

exec 3> display.number
Xvfb -displayfd 3 -screen 0 800x600x24 -nolisten tcp > server.log 2>&1 &
server=$!
for _ in $(seq 100); do [ -s display.number ] && break; sleep 0.1; done
[ -s display.number ] || { echo "window: Xvfb does not start"; exit 77; }
DISPLAY=:$(cat display.number)
export DISPLAY
unset WAYLAND_DISPLAY || true
for _ in $(seq 100); do xdotool getdisplaygeometry > /dev/null 2>&1 && break; sleep 0.1; done
xdotool getdisplaygeometry > /dev/null 2>&1 || { echo "window: Xvfb does not answer"; exit 77; }

"$epode" view pendulum --paused --status --width 800 --height 600 --picture last.png > out 2> err &
child=$!
# until_true CONDITION: true within some twenty seconds, or the test fails.
until_true() {
    for _ in $(seq 200); do
        if eval "$1"; then return 0; fi
        kill -0 "$child" 2> /dev/null || fail "the program ended while waiting for: $1"
        sleep 0.1
    done
    fail "never came: $1"
}
window=
for _ in $(seq 200); do
    window=$(xdotool search --name '^epode view: pendulum$' 2> /dev/null | head -1) && [ -n "$window" ] && break
    kill -0 "$child" 2> /dev/null || fail "the program ended at once"
    sleep 0.1
done
[ -n "$window" ] || fail "no window of that name"
xdotool windowfocus --sync "$window" || true

until_true 'tail -1 out | grep -q "state 0 .*paused"'
until_true 'xdotool key Right; sleep 0.3; ! tail -1 out | grep -q "state 0 "'
state=$(tail -1 out | sed 's/.* state \([0-9]*\) .*/\1/')
xdotool key period
until_true 'tail -1 out | grep -q "state $((state + 1)) .*paused"'
xdotool key Left
until_true 'tail -1 out | grep -q "state $state .*paused"'
xdotool key Tab
until_true 'tail -1 out | grep -q "panels 0"'
xdotool key F1
until_true 'tail -1 out | grep -q "help 1"'
xdotool key F1 key space
until_true 'tail -1 out | grep -q "running .*help 0"'
xdotool key p
until_true 'tail -1 out | grep -q paused'
xdotool key ctrl+x
for _ in $(seq 200); do kill -0 "$child" 2> /dev/null || break; sleep 0.1; done
wait "$child" || fail "exit code $?"
child=
[ "$(head -c 4 last.png | tail -c 3)" = PNG ] || fail "last.png is no picture"
echo "window: good"
