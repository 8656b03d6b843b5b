#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""tutorials.py SOURCE_FOLDER NAME: one of pyode's own example programs, as its authors wrote it, for some hundred frames.

Prints "#library PATH INODE" and then figures in the form of falling.py, "name value...": places, rotations and velocities of what
the program simulates, frame by frame. The program draws into the stand-ins of stand_ins.py. vehicle.py is the one that is
changed, in one place: its print statement of Python 2 gets brackets.
"""

import contextlib
import io
import os
import random
import re
import sys
import time

import ode

import falling
import stand_ins

FRAMES = {"tutorial2": 100, "tutorial3": 1000, "vehicle": 300, "transforms": 3}
KEYS = {"vehicle": {100: "K_w"}}


def show_objects(frame, objects):
    for i, item in enumerate(objects):
        falling.show("frame%d.%d.place" % (frame, i), item.getPosition(), item.getRotation())
        body = item if isinstance(item, ode.Body) else item.getBody()
        if body:
            falling.show("frame%d.%d.motion" % (frame, i), body.getLinearVel(), body.getAngularVel())


def objects_of(name, program):
    if name == "tutorial2":
        return [program["body1"], program["body2"]]
    if name == "vehicle":
        return [geom for geom in program["demo"]._geoms if geom.placeable()]
    return program["bodies"]


def show_joints(frame, name, program):
    if name == "vehicle":
        for i, joint in enumerate(program["demo"]._joints):
            falling.show("frame%d.joint%d" % (frame, i), joint.getAnchor(), joint.getAnchor2(), joint.getAngle1Rate(),
                         joint.getAngle2Rate())


def show_printed(text):
    """The two programs without a window print every step: the place and velocity of their ball."""
    pattern = r"position: \((.*?)\), velocity: \((.*?)\), joints: (\d+)"
    for i, found in enumerate(re.finditer(pattern, text)):
        falling.show("frame%d.0.ball" % (i + 1), *([float(number) for number in group.split(",")] for group in found.groups()))


def run(folder, name):
    path = os.path.join(folder, "examples", name + ".py")
    with open(path) as file:
        source = file.read().replace("    print info\n", "    print(info)\n")
    program = {"__name__": "__main__", "__file__": path}

    def on_frame(frame):
        with contextlib.redirect_stdout(sys.__stdout__):
            show_objects(frame, objects_of(name, program))
            show_joints(frame, name, program)

    stand_ins.install(stand_ins.Screen(FRAMES.get(name, 0), on_frame, KEYS.get(name, {})), source)
    sys.path[0] = os.path.dirname(path)
    random.seed(1)
    time.sleep = stand_ins.nothing
    printed = io.StringIO()
    with contextlib.redirect_stdout(printed):
        try:
            exec(compile(source, path, "exec"), program)
        except SystemExit as end:
            if end.code:
                raise
    show_printed(printed.getvalue())


def main(folder, name):
    print("#library", *falling.library())
    run(folder, name)
    print("#extension", os.path.realpath(ode.__file__), flush=True)


if __name__ == "__main__":
    main(*sys.argv[1:3])
