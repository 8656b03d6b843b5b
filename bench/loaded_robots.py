#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A step of robots as users load them: Gymnasium's files in a world with the robot preset, next to MuJoCo's Euler step of the same files, on
the same random controls held for five steps, in turns on one thread, and next to the preset without joint coordinates, "in bodies":
loaded_robots.py [STEPS], in an environment with epode, gymnasium and mujoco. The fastest of some rounds counts, since the machine may be busy; times are of the process. Next to the time: the deepest
contact, and of Epode the worst joint error and residual of any step."""
import pathlib
import sys
import time

import gymnasium
import mujoco
import numpy as np

import epode

FILES = pathlib.Path(gymnasium.__file__).parent / "envs/mujoco/assets"
ROBOTS, HELD, ROUNDS = ["ant", "half_cheetah", "humanoid", "hopper", "walker2d", "inverted_double_pendulum"], 5, 5


class Epode:
    def __init__(self, path, h, joint_coordinates):
        self.model, self.h, self.coordinates = epode.load(path), h, joint_coordinates

    def reset(self):
        self.world = epode.World(defaults="robot")
        self.world.joint_coordinates = self.coordinates
        self.robot = self.model.build(self.world)

    def advance(self, controls):
        self.robot.controls = controls
        self.world.step(self.h, steps=HELD)

    def depth(self):
        contacts = self.world.contacts
        return float(contacts["depth"].max()) if len(contacts) else 0.0

    def quality(self, controls):
        """The worst joint error and residual of a run that is not timed."""
        self.reset()
        self.world.reports = True
        joints = residual = 0.0
        for control in controls:
            self.robot.controls = control
            for _ in range(HELD):
                self.world.step(self.h)
                report = self.world.report()
                joints, residual = max(joints, report.joint_error, report.joint_angle_error), max(residual, report.residual)
        return f"joints {joints:.0e}, residual {residual:.0e}"


class MuJoCo:
    def __init__(self, path, h):
        self.model = mujoco.MjModel.from_xml_path(path)
        self.model.opt.timestep, self.model.opt.integrator = h, mujoco.mjtIntegrator.mjINT_EULER

    def reset(self):
        self.data = mujoco.MjData(self.model)

    def advance(self, controls):
        self.data.ctrl = controls
        mujoco.mj_step(self.model, self.data, HELD)

    def depth(self):
        return max((-float(c.dist) for c in self.data.contact), default=0.0)


def round_of(engine, controls):
    engine.reset()
    deepest = spent = 0.0
    for control in controls:
        begin = time.process_time()
        engine.advance(control)
        spent += time.process_time() - begin
        deepest = max(deepest, engine.depth())
    return spent / (len(controls) * HELD), deepest


def main(steps):
    print("| robot | h, s | MuJoCo Euler, us | the preset, us | share | in bodies, us | deepest: MuJoCo, Epode | Epode's quality |")
    print("|---|---|---|---|---|---|---|---|")
    for name in ROBOTS:
        path = str(FILES / f"{name}.xml")
        h = mujoco.MjModel.from_xml_path(path).opt.timestep
        engines = [MuJoCo(path, h), Epode(path, h, True), Epode(path, h, False)]
        controls = np.random.default_rng(1).uniform(-1, 1, (steps // HELD, engines[0].model.nu))
        seen = [[round_of(engine, controls) for engine in engines] for _ in range(ROUNDS)]
        best = [min(rounds[i][0] for rounds in seen) * 1e6 for i in range(3)]
        depths = [max(rounds[i][1] for rounds in seen) * 1e3 for i in range(2)]
        print(f"| {name} | {h:g} | {best[0]:.1f} | {best[1]:.1f} | {best[1] / best[0]:.2f} | {best[2]:.1f} "
              f"| {depths[0]:.1f}, {depths[1]:.1f} mm | {engines[1].quality(controls[:40])} |", flush=True)


if __name__ == "__main__":
    main(int(sys.argv[1]) if len(sys.argv) > 1 else 500)
