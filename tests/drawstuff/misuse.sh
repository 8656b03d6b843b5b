#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# misuse.sh PROGRAM: what drawstuff does to programs that misuse it: exit code, message.
set -euo pipefail
program=$1
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cd "$work"
ulimit -c 0
export EPODE_GL=egl EPODE_FRAMES= EPODE_FRAME_COUNT=3
fail() { echo "misuse: $*" >&2; cat err >&2; exit 1; }

# expect CODE MESSAGE ARGUMENTS...
expect() {
    local code=0
    { "$program" "${@:3}" > out 2> err; } 2> /dev/null || code=$?
    [ "$code" = "$1" ] || fail "$3: exit code $code instead of $1"
    grep -qF -- "$2" err || fail "$3: no message '$2'"
    head -1 out | grep -qx before || fail "$3: what was printed before is lost"
}

expect 1 $'Error: 3 apples' error
expect 134 'INTERNAL ERROR: no pears' debug
expect 1 'Error: drawing function called outside simulation loop' draw-before
expect 1 'Error: drawing function called outside simulation loop' draw-in-start
expect 1 'Error: dsSetViewpoint called before the simulation loop' view-before
expect 1 'Error: dsGetViewpoint called before the simulation loop' get-before
expect 1 'Error: dsSimulationLoop called inside itself' nested
expect 134 'INTERNAL ERROR: dsSimulationLoop: version 0x0003' version
expect 134 'INTERNAL ERROR: dsSimulationLoop: a window of 0 by 10 pixels' size
expect 134 'INTERNAL ERROR: dsSimulationLoop: no dsFunctions' null
sed -n 2p err | grep -q '^INTERNAL ERROR' && [ -z "$(sed -n 1p err)" ] || fail "a message does not begin with a blank line"

# Twice in a row, and the help once.
expect 0 'Ctrl-P' fine
[ "$(grep -c 'Ctrl-P' err)" = 1 ] || fail "help is not printed once"
grep -qx after out || fail "the second loop did not end"
EPODE_FRAME_COUNT=many expect 0 'EPODE_FRAME_COUNT=many is not a number' fine
EPODE_FRAME_COUNT=-1 expect 0 'EPODE_FRAME_COUNT=-1 is not a number' fine
EPODE_FRAME_EVERY=0 expect 0 'EPODE_FRAME_EVERY=0 is not a number' fine
EPODE_GL=carrier-pigeon DISPLAY='' WAYLAND_DISPLAY='' expect 0 'EPODE_GL=carrier-pigeon is neither' fine
# A folder that cannot be made is named.
: > file
EPODE_FRAMES=file/frames expect 1 'file/frames cannot be made' fine
# Textures that are not there, once, with pictures.
EPODE_FRAMES=frames expect 0 'no/such/folder/wood.ppm is missing' textures
[ "$(grep -c 'wood.ppm' err)" = 2 ] || fail "missing textures are not told once a loop"
[ -s frames/frame0003.png ] || fail "no picture without textures"
echo "misuse: good"
