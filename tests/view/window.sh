#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# window.sh EPODE: the viewer in a window of an X server without screen, with keys by xdotool. 77 where Xvfb or xdotool
# is missing.
set -euo pipefail
epode=$1
source "$(dirname "$(realpath "$0")")/../display.sh"
start_display 800 600

"$epode" view pendulum --paused --status --width 800 --height 600 --picture last.png > out 2> err &
child=$!
find_window '^epode view: pendulum$'
shows() { tail -1 out | grep -q "$1"; }

# Help comes by a key that is sent last, so all slower, of which there may be several, have been heard by then.
until_true 'shows "state 0 .*paused speed 1 .*help 0"'
until_key_works minus '! shows "speed 1 "'
xdotool key 1 key F1
until_true 'shows "state 0 .*paused speed 1 .*help 1"'
xdotool key Right
until_true 'shows "state 1 .*paused"'
xdotool key period
until_true 'shows "state 2 .*paused"'
xdotool key Left
until_true 'shows "state 1 .*paused"'
xdotool key Tab
until_true 'shows "state 1 .*panels 0 help 1"'
xdotool key F1 key space
until_true 'shows "running .*panels 0 help 0"'
until_true '! shows "state 1 "'
xdotool key p
until_true 'shows paused'
xdotool key ctrl+x
until_gone
[ "$(head -c 4 last.png | tail -c 3)" = PNG ] || fail "last.png is no picture"
echo "window: good"
