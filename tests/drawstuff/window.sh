#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# window.sh PROGRAM: drawstuff in a window of an X server without screen, with keys and mouse by xdotool. 77 where
# Xvfb or xdotool is missing or drawstuff was built without windows.
set -euo pipefail
program=$1
command -v Xvfb > /dev/null && command -v xdotool > /dev/null || { echo "window: no Xvfb or xdotool"; exit 77; }
work=$(mktemp -d)
cd "$work"
mkdir frame
server= child=
finish() {
    [ -z "$child" ] || kill "$child" 2> /dev/null || true
    [ -z "$server" ] || kill "$server" 2> /dev/null || true
    rm -rf "$work"
}
trap finish EXIT
fail() { echo "window: $*" >&2; cat out err >&2; exit 1; }
# until CONDITION...: true within some twenty seconds, or the test fails.
until_true() {
    for _ in $(seq 200); do
        if eval "$1"; then return 0; fi
        kill -0 "$child" 2> /dev/null || [ "${2:-}" = gone ] || fail "the program ended while waiting for: $1"
        sleep 0.1
    done
    fail "never came: $1"
}

exec 3> display.number
Xvfb -displayfd 3 -screen 0 640x480x24 -nolisten tcp > server.log 2>&1 &
server=$!
for _ in $(seq 100); do [ -s display.number ] && break; sleep 0.1; done
[ -s display.number ] || { echo "window: Xvfb does not start"; exit 77; }
DISPLAY=:$(cat display.number)
export DISPLAY
unset WAYLAND_DISPLAY EPODE_GL || true

"$program" -pause > out 2> err &
child=$!
window=
for _ in $(seq 200); do
    window=$(xdotool search --name '^Simulation$' 2> /dev/null | head -1) && [ -n "$window" ] && break
    if grep -q 'built without GLFW' err; then echo "window: built without GLFW"; exit 77; fi
    kill -0 "$child" 2> /dev/null || fail "the program ended at once"
    sleep 0.1
done
[ -n "$window" ] || fail "no window named Simulation"
xdotool windowfocus --sync "$window" || true

# A plain key goes to the program, once frames run; a key with Ctrl does not.
until_true 'xdotool key --window 0 k; sleep 0.3; grep -q "^command k" out'
xdotool key ctrl+v
until_true 'grep -qF "Viewpoint = (4.0000,0.0000,11.0000,0.0000,-90.0000,0.0000)" out'
# The view turns by half a degree a pixel.
xdotool mousemove --window "$window" 100 100
sleep 0.5
xdotool mousedown 1
sleep 0.5
xdotool mousemove --window "$window" 120 130
sleep 0.5
xdotool mouseup 1
xdotool key ctrl+v
until_true 'grep -qF "Viewpoint = (4.0000,0.0000,11.0000,10.0000,-75.0000,0.0000)" out'
# Two frames one by one, each captured; then go on.
xdotool key ctrl+w
xdotool key ctrl+o
until_true '[ -s frame/frame0001.ppm ]'
xdotool key ctrl+o
until_true '[ -s frame/frame0002.ppm ]'
sleep 0.5
[ ! -e frame/frame0003.ppm ] || fail "a paused frame was captured"
xdotool key ctrl+p
until_true '[ -s frame/frame0004.ppm ]'
[ "$(head -c 2 frame/frame0001.ppm)" = P6 ] || fail "a frame is no PPM"
xdotool key ctrl+x
until_true '! kill -0 $child 2> /dev/null' gone
wait "$child" || fail "exit code $?"
child=
grep -q '^capturing frame 0001$' err || fail "capturing is not told"
grep -q '^frames ' out || fail "stop was not called"
! grep -q '^command [^k]' out || fail "a key with Ctrl reached the program"
echo "window: good, $(grep '^frames' out)"
