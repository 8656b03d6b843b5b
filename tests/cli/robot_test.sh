#!/usr/bin/env bash
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# robot_test.sh PROGRAM MODELS: robots' files on the command line.
set -uo pipefail
program=$1
models=$2
source "$(dirname "$0")/harness.sh"

expect 0 robot check "$models/arm.urdf"
has out "^URDF 'arm': 4 links, 4 joints, 4 coordinates"
has out "arm.urdf:40: ignored: <plugin> in <gazebo>"
expect 1 robot check --strict "$models/arm.urdf"
has out "arm.urdf:40: error: <plugin>"
expect 0 robot check --json "$models/walker.xml"
has out '"format": "MJCF"'
[[ $(number coordinates) == 15 ]] || fail "a walker has 15 coordinates"
expect 1 robot check "$models/none.urdf"
has out "none.urdf' is no file"
expect 0 robot convert "$models/walker.xml" "$work/walker.urdf"
has out "walker.urdf: armatures of joints are not in URDF"
expect 0 robot check "$work/walker.urdf" --root "$models"
has out "^URDF 'walker'"
expect 0 run "$models/walker.xml" --steps 20 --json --quiet
[[ $(number messages) == 0 ]] || fail "a walker with a ball is built without messages"
expect 0 robot convert "$models/fourbar.xml" "$work/fourbar.xml"
expect 0 run "$work/fourbar.xml" --steps 20 --quiet
expect 1 robot convert "$models/arm.urdf" "$work/arm.txt"
has err "robots are written to .urdf, .xml and .mjcf"
expect 1 robot convert "$models/none.urdf" "$work/none.xml"
expect 1 run "$models/meshes/none.urdf"
expect 0 run "$models/arm.urdf" --steps 20 --json --quiet
expect 0 record "$models/fourbar.xml" --steps 20 --quiet -o "$work/fourbar.epr"
expect 0 inspect "$work/fourbar.epr"
expect 0 replay "$work/fourbar.epr" --quiet
has out "the same in all 21 states"
cp "$models/../../../demos/robots/quadruped.xml" "$work/gone.xml"
expect 0 record "$work/gone.xml" --steps 2 --quiet -o "$work/gone.epr"
rm "$work/gone.xml"
expect 1 replay "$work/gone.epr"
has err "gone.xml' is no file"
# The demo stands up: its trunk comes to the height of its legs.
expect 0 run "$models/../../../demos/robots/quadruped.xml" --seconds 3 --quiet --trace "$work/trace.csv"
height=$(tail -n 1 "$work/trace.csv" | cut -d, -f11)
holds "$height > 0.325 && $height < 0.34"
# A slider is dragged, and its axis follows.
expect 1 robot view "$models/none.urdf" --headless --frames 1
if "$program" view wall --headless --frames 1 > /dev/null 2>&1; then
  printf '%s\n' "frames 2" "picture $work/before.png" "move 88 215" "frames 2" "down left" "frames 2" "move 128 215" "frames 2" \
    "up left" "frames 60" "picture $work/after.png" > "$work/keys"
  expect 0 robot view "$models/../../../demos/robots/arm.urdf" --headless --script "$work/keys"
  cmp -s "$work/before.png" "$work/after.png" && fail "the picture is the same"
fi
expect 2 robot view
expect 2 robot
expect 2 robot check
finish
