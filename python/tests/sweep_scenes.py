# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Scenes of test_sweep.py, which workers import by name."""
import os
import signal
import time
from pathlib import Path

import epode


def slide(parameters, seed):
    """A box slides down a slope for half a second, and a ball falls onto it."""
    world = epode.World(gravity=(0, 0, -9.81))
    world.reports = True
    material = epode.Material(friction=parameters["friction"])
    world.plane(normal=(0.3, 0, 1), material=material)
    box = world.body(mass=parameters["mass"], shape=epode.Box(0.2, 0.2, 0.2), position=(0, 0, 0.3 + 0.001 * seed), material=material)
    world.body(mass=1, shape=epode.Sphere(0.1), position=(0.05, 0.02, 0.6 + 0.001 * seed))
    world.step(0.01, steps=50)
    return {"x": box.position[0], "world": world}


def number(parameters, seed):
    """Work of no engine's."""
    time.sleep(parameters.get("seconds", 0.0))
    return {"value": parameters["a"] * 2.0 + seed}


def counted(parameters, seed):
    """Leaves a line in a file for each time that it is run."""
    with open(Path(os.environ["SWEEP_COUNT"]), "a", encoding="utf-8") as file:
        file.write(f"{parameters['a']} {seed}\n")
    time.sleep(float(os.environ.get("SWEEP_SECONDS", "0")))
    return {"value": parameters["a"]}


def troubled(parameters, seed):
    """Raises, never ends, kills its process, leaves it, or returns what is no row: seed by seed."""
    match seed:
        case 1:
            raise ZeroDivisionError("a scene of mine")
        case 2:
            while True:
                pass
        case 3:
            os.kill(os.getpid(), signal.SIGKILL)
        case 4:
            os._exit(7)
        case 5:
            return {"value": "much"}
        case 6:
            return {"a": 1.0}
        case 7:
            return 3
    return {"value": parameters["a"]}


def fails(parameters, seed):
    """Always."""
    raise RuntimeError(f"no file of the number {seed}")
