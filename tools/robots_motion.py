# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""One second of gymnasium's robots under constant controls, without contacts and limits, compared with MuJoCo's. The reference is
MuJoCo's fourth-order integrator, which agrees with itself at half the step to 1e-8. Our step is of first order, and so is MuJoCo's
own (implicitfast), whose error is printed next to ours; some of these motions magnify both. So the judge of the *model* is the limit
of ours for h -> 0 from the steps h, h/2, h/4:  (8 q(h/4) - 6 q(h/2) + q(h)) / 3  has an error of third order."""
import ctypes
import pathlib
import site

import mujoco
import numpy as np

from robots_library import Model, load_library, silence

SECONDS, STEP, TOLERANCE = 1.0, 1e-4, 1e-3


class World:
    """Robots of files in worlds of ours."""

    def __init__(self, path):
        self.library, (self.ode, self.handler) = load_library(path), silence(path)
        for name in ("dWorldCreate", "dRobotGetJoint", "dRobotCreate"):
            getattr(self.ode if name[:6] == "dWorld" else self.library, name).restype = ctypes.c_void_p
        number, handle = ctypes.c_double, ctypes.c_void_p
        self.ode.dWorldSetGravity.argtypes = [handle, number, number, number]
        self.ode.dWorldStep.argtypes = [handle, number]
        self.ode.dWorldDestroy.argtypes = [handle]
        self.ode.dJointGetType.argtypes = [handle]
        for name in ("dJointSetHingeParam", "dJointSetSliderParam"):
            getattr(self.ode, name).argtypes = [handle, ctypes.c_int, number]
        self.library.dRobotCreate.argtypes = [handle] * 5
        self.library.dRobotGetJoint.argtypes = [handle, ctypes.c_int]
        self.library.dRobotSetControl.argtypes = [handle, ctypes.c_int, number]
        self.library.dRobotGetPositions.argtypes = [handle, handle, ctypes.c_int]
        self.library.dRobotAddFluidForces.argtypes = [handle, number]
        self.library.dRobotDestroy.argtypes = [handle]

    def free_limits(self, robot, count):
        for i in range(count):
            joint = self.library.dRobotGetJoint(robot, i)
            kind = joint and self.ode.dJointGetType(joint)
            set_parameter = {2: self.ode.dJointSetHingeParam, 3: self.ode.dJointSetSliderParam}.get(kind)
            if set_parameter:
                set_parameter(joint, 0, -np.inf)
                set_parameter(joint, 1, np.inf)

    def run(self, path, root, gravity, controls, step):
        """The positions at the end."""
        model = Model(self.library, path, root)
        world = self.ode.dWorldCreate()
        self.ode.dWorldSetGravity(world, *gravity)
        robot = self.library.dRobotCreate(world, None, model.handle, None, None)
        self.free_limits(robot, len(model.joints()))
        for i, control in enumerate(controls):
            self.library.dRobotSetControl(robot, i, control)
        for _ in range(round(SECONDS / step)):
            self.library.dRobotAddFluidForces(robot, step)
            self.ode.dWorldStep(world, step)
        out = np.zeros(model.positions())
        self.library.dRobotGetPositions(robot, out.ctypes.data, len(out))
        self.library.dRobotDestroy(robot)
        self.ode.dWorldDestroy(world)
        model.close()
        return out


class Judge:
    """MuJoCo's robot of a file, and its positions at the end by either integrator."""

    def __init__(self, path):
        self.model = mujoco.MjModel.from_xml_path(str(path))
        options = self.model.opt
        options.timestep = STEP
        options.disableflags |= int(mujoco.mjtDisableBit.mjDSBL_CONTACT) | int(mujoco.mjtDisableBit.mjDSBL_LIMIT)
        low, high = np.clip(self.model.actuator_ctrlrange.T, -1, 1)
        self.controls = np.random.default_rng(3).uniform(0.2 * low, 0.2 * high)

    def run(self, integrator):
        self.model.opt.integrator = integrator
        data = mujoco.MjData(self.model)
        data.ctrl[:] = self.controls
        for _ in range(round(SECONDS / STEP)):
            mujoco.mj_step(self.model, data)
        return data.qpos.copy()

    def in_one_turn(self, q, reference):
        """Turns of hinges taken out (one that had stops does not count them), quaternions with the sign of the reference."""
        out = q.copy()
        for joint in range(self.model.njnt):
            at, kind = self.model.jnt_qposadr[joint], int(self.model.jnt_type[joint])
            if kind == 3:
                out[at] -= 2 * np.pi * round((out[at] - reference[at]) / (2 * np.pi))
            for w in [at + 3] if kind == 0 else [at] if kind == 1 else []:
                out[w:w + 4] *= np.sign(out[w:w + 4] @ reference[w:w + 4])
        return out


def differences(world, path, root):
    """Largest differences from the reference: our limit for h -> 0, ours at STEP, MuJoCo's own first-order step at STEP."""
    judge = Judge(path)
    reference = judge.run(mujoco.mjtIntegrator.mjINT_RK4)
    ours = [judge.in_one_turn(world.run(path, root, judge.model.opt.gravity, judge.controls, STEP / n), reference) for n in (1, 2, 4)]
    limit = (8 * ours[2] - 6 * ours[1] + ours[0]) / 3
    theirs = judge.in_one_turn(judge.run(mujoco.mjtIntegrator.mjINT_IMPLICITFAST), reference)
    return [np.abs(q - reference).max() for q in (limit, ours[0], theirs)]


def table(library):
    """Prints a row for each robot. Returns 1 if a limit is outside the tolerance."""
    world, failed = World(library), 0
    root = pathlib.Path(site.getsitepackages()[0]) / "gymnasium/envs/mujoco/assets"
    print(f"| robot | ours, h -> 0 | ours, h = {STEP:g} | MuJoCo's implicitfast, h = {STEP:g} |\n|---|---|---|---|")
    for path in sorted(root.glob("*.xml")):
        found = differences(world, path, root)
        failed |= found[0] > TOLERANCE
        print(f"| {path.name} | " + " | ".join(f"{x:.2g}" for x in found) + " |", flush=True)
    return int(failed)
