# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Where gymnasium's robots come to rest under gravity without controls, compared with MuJoCo's: the height of the root, which is the
coordinate of the free joint or of the slider along z, after TIME seconds in both. Robots that still move then, or rest on another side,
have no height to compare; their speeds are printed. Files make contacts and limits soft, ours are rigid: so MuJoCo's height
with rigid ones (impedance 0.99 to 0.999, 4 ms, no margins) is printed too."""
import ctypes
import pathlib
import site

import mujoco
import numpy as np

from robots_library import Model
from robots_motion import World

TIME, STEP, TOLERANCE = 20.0, 0.005, 0.005
ROBOTS = ("ant", "half_cheetah", "humanoid", "hopper", "walker2d")


def height_coordinate(model):
    """The number of the root's height among the positions."""
    for joint in range(model.njnt):
        if model.jnt_type[joint] == 0:
            return model.jnt_qposadr[joint] + 2
        if model.jnt_type[joint] == 2 and abs(model.jnt_axis[joint][2]) > 0.99:
            return model.jnt_qposadr[joint]
    raise ValueError("a robot whose root has no height")


def theirs(model):
    data = mujoco.MjData(model)
    for _ in range(round(TIME / model.opt.timestep)):
        mujoco.mj_step(model, data)
    return data.qpos.copy(), np.abs(data.qvel).max()


def rigid(path):
    model = mujoco.MjModel.from_xml_path(str(path))
    model.opt.timestep, model.opt.integrator = 0.001, mujoco.mjtIntegrator.mjINT_IMPLICITFAST
    for solref, solimp in ((model.geom_solref, model.geom_solimp), (model.jnt_solref, model.jnt_solimp)):
        solref[:], solimp[:, :3] = [0.004, 1], [0.99, 0.999, 0.0001]
    model.geom_margin[:] = 0
    return model


def ours(world, path, root, gravity):
    handle = ctypes.c_void_p
    world.ode.dHashSpaceCreate.restype = handle
    world.ode.dHashSpaceCreate.argtypes = [handle]
    world.ode.dWorldSetContactSpace.argtypes = [handle, handle]
    world.library.dRobotGetVelocities.argtypes = [handle, handle, ctypes.c_int]
    model = Model(world.library, path, root)
    its = world.ode.dWorldCreate()
    space = world.ode.dHashSpaceCreate(None)
    world.ode.dWorldSetGravity(its, *gravity)
    world.ode.dWorldSetContactSpace(its, space)
    robot = world.library.dRobotCreate(its, space, model.handle, None, None)
    for _ in range(round(TIME / STEP)):
        world.ode.dWorldStep(its, STEP)
    q, v = np.zeros(model.positions()), np.zeros(200)
    world.library.dRobotGetPositions(robot, q.ctypes.data, len(q))
    count = world.library.dRobotGetVelocities(robot, v.ctypes.data, len(v))
    world.library.dRobotDestroy(robot)
    world.ode.dWorldDestroy(its)
    model.close()
    return q, np.abs(v[:count]).max()


def table(library):
    """Prints a row for each robot. Returns 1 if one of the first three is off by more than the tolerance."""
    world, failed = World(library), 0
    root = pathlib.Path(site.getsitepackages()[0]) / "gymnasium/envs/mujoco/assets"
    print("| robot | ours, m | MuJoCo's, m | difference, mm | MuJoCo's, rigid, m | largest other difference, rad or m | speeds, ours and MuJoCo's |\n|---|---|---|---|---|---|---|")
    for name in ROBOTS:
        path = root / f"{name}.xml"
        model = mujoco.MjModel.from_xml_path(str(path))
        at = height_coordinate(model)
        (mine, speed), (other, their_speed) = ours(world, path, root, model.opt.gravity), theirs(model)
        apart = mine[at] - other[at]
        failed |= name in ROBOTS[:3] and not abs(apart) <= TOLERANCE
        print(f"| {name} | {mine[at]:.4f} | {other[at]:.4f} | {1000 * apart:.2f} | {theirs(rigid(path))[0][at]:.4f} | {np.abs(np.delete(mine - other, at)).max():.2g} | "
              f"{speed:.1g}, {their_speed:.1g} |", flush=True)
    return int(failed)
