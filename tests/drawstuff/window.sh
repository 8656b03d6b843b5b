#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# window.sh PROGRAM: drawstuff in a window of an X server without screen, with keys and mouse by xdotool. 77 where
# Xvfb or xdotool is missing or drawstuff was built without windows.
set -euo pipefail
program=$1
source "$(dirname "$(realpath "$0")")/../display.sh"
start_display 640 480
unset EPODE_GL || true
mkdir frame

"$program" -pause > out 2> err &
child=$!
window=
until_true 'window=$(xdotool search --name "^Simulation$" 2> /dev/null | head -1); [ -n "$window" ] ||
    grep -q "built without GLFW" err'
! grep -q 'built without GLFW' err || skip "built without GLFW"

# A plain key goes to the program, once frames run; a key with Ctrl does not.
until_key_works k 'grep -q "^command k" out'
xdotool key ctrl+v
until_true 'grep -qF "Viewpoint = (4.0000,0.0000,11.0000,0.0000,-90.0000,0.0000)" out'
# The view turns by half a degree a pixel.
xdotool mousemove --sync --window "$window" 100 100
xdotool mousedown 1
xdotool mousemove --sync --window "$window" 120 130
xdotool mouseup 1
xdotool key ctrl+v
until_true 'grep -qF "Viewpoint = (4.0000,0.0000,11.0000,10.0000,-75.0000,0.0000)" out'
# Two frames one by one, each captured; then a whole paused one, between two that tell their keys; then go on.
xdotool key ctrl+w key ctrl+o
until_true '[ -s frame/frame0001.ppm ]'
xdotool key ctrl+o
until_true '[ -s frame/frame0002.ppm ]'
for key in l m; do
    xdotool key $key
    until_true "grep -q '^command $key' out"
done
[ ! -e frame/frame0003.ppm ] || fail "a paused frame was captured"
xdotool key ctrl+p
until_true '[ -s frame/frame0004.ppm ]'
[ "$(head -c 2 frame/frame0001.ppm)" = P6 ] || fail "a frame is no PPM"
xdotool key ctrl+x
until_gone
grep -q '^capturing frame 0001$' err || fail "capturing is not told"
grep -q '^frames ' out || fail "stop was not called"
! grep -q '^command [^klm]' out || fail "a key with Ctrl reached the program"
echo "window: good, $(grep '^frames' out)"
