# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What batches observe, compared with MuJoCo in the same states."""
import numpy as np
import pytest

import epode

mujoco = pytest.importorskip("mujoco")

HOPPER = """<mujoco model="hopper"><compiler angle="radian"/><option gravity="0 0 -9.81" timestep="0.002"/><default>
<geom contype="0" conaffinity="1" friction="0.8" condim="3"/></default><worldbody>
<geom type="plane" size="9 9 1" contype="1" conaffinity="0"/><body name="trunk" pos="0.1 0.2 0.6"><freejoint/>
<geom type="capsule" size="0.1 0.2" euler="0 1.2 0.3" mass="3"/><body name="pack" pos="0 0.1 0.1" euler="0.2 0 0"><geom type="box"
size="0.1 0.05 0.02" mass="0.4"/></body><body name="leg" pos="0.2 0 0"><joint name="hip" axis="0 1 0.1" range="-0.3 0.9" limited="true"
damping="0.5" armature="0.01"/><geom type="capsule" fromto="0 0 0 0 0.02 -0.4" size="0.04" mass="1"/><body name="foot" pos="0 0 -0.4">
<joint name="ankle" axis="1 0 0" pos="0 0 0.05" frictionloss="0.02"/><geom type="sphere" size="0.06" mass="0.5"/></body></body></body>
<body name="post" pos="3 0 1"><body name="bell" pos="0 0 0.2"><joint name="swing" type="ball"/><geom pos="0.1 0 -0.3" size="0.1"
mass="2"/></body></body></worldbody><actuator><motor joint="hip" gear="20" ctrlrange="-1 1"/><position joint="ankle" kp="30"
forcerange="-4 4"/></actuator></mujoco>"""
# Tendons with servos, a spring, a damper and a motor; filters of each kind, one early; a coupling.
PULLED = """<mujoco><compiler angle="radian"/><option timestep="0.002"/><worldbody><body><joint name="lift" axis="0 1 0"/><geom size="0.1" mass="1"/>
<body pos="0.4 0 0"><joint name="turn" axis="1 0 0"/><geom size="0.1" mass="0.4"/><body pos="0.1 0 0"><joint name="open" type="slide" axis="0 1 0"/>
<geom size="0.1" mass="0.2"/></body></body></body><body pos="0 3 1"><joint name="spin" axis="0 1 0"/><geom pos="0.1 0 0" size="0.1" mass="1"/></body>
</worldbody><equality><joint joint1="open" joint2="spin"/></equality><tendon><fixed name="pull" stiffness="40" damping="0.5"><joint joint="open" coef="0.5"/>
<joint joint="lift" coef="0.3"/></fixed><fixed name="push"><joint joint="turn" coef="1.5"/><joint joint="spin" coef="-0.5"/></fixed></tendon><actuator>
<position name="grip" tendon="pull" kp="20" kv="3" gear="0.8"/><motor tendon="pull" gear="2" ctrlrange="-1 1"/>
<position tendon="push" kp="30" forcerange="-4 4"/>
<general joint="lift" dyntype="filter" dynprm="0.03" gainprm="3" gear="2" actrange="-0.6 0.6" actlimited="true"/>
<general joint="turn" dyntype="filterexact" dynprm="0.02" gainprm="0.5" actearly="true"/>
<general joint="spin" dyntype="integrator" gainprm="2" biastype="affine" biasprm="0.1 -5 -0.2"/></actuator></mujoco>"""
OF_STATE = ("xpos", "xquat", "cvel", "cinert", "qfrc_actuator")


def copies(count, **options):
    batch = epode.Batch(epode.robot.from_text(HOPPER, keep_fixed=True), count, dtype="float64", **options)
    rng = np.random.default_rng(3)
    batch.write("qpos", batch.read("qpos") + rng.uniform(-0.3, 0.3, (count, batch.size("qpos"))))
    batch.write("qvel", rng.normal(size=(count, batch.size("qvel"))))
    batch.write("ctrl", rng.uniform(-1.5, 1.5, (count, 2)))
    return batch


def states(batch):
    model = mujoco.MjModel.from_xml_string(HOPPER)
    data = mujoco.MjData(model)
    for i in range(batch.copies):
        data.qpos[:], data.qvel[:], data.ctrl[:] = batch.read("qpos")[i], batch.read("qvel")[i], batch.read("ctrl")[i]
        mujoco.mj_forward(model, data)
        yield i, model, data


def test_of_the_state_as_mujoco_has_it():
    batch = copies(9)
    ours = {name: batch.read(name) for name in (*OF_STATE, "com")}
    for i, _, data in states(batch):
        for name in OF_STATE:
            assert abs(ours[name][i] - getattr(data, name).ravel()).max() < 1e-9, name
        assert abs(ours["com"][i] - data.subtree_com[0]).max() < 1e-9


def test_actuators_on_tendons_and_behind_filters_give_what_mujocos_do():
    model, rng = mujoco.MjModel.from_xml_string(PULLED), np.random.default_rng(5)
    data, batch = mujoco.MjData(model), epode.Batch(epode.robot.from_text(PULLED), 64, dtype="float64", stepsize=0.002)
    for name in ("qpos", "qvel", "ctrl", "act"):
        batch.write(name, rng.uniform(-1, 1, (64, batch.size(name))))
    ours = batch.read("qfrc_actuator")
    held = 0
    for i in range(64):
        for name in ("qpos", "qvel", "ctrl", "act"):
            getattr(data, name)[:] = batch.read(name)[i]
        mujoco.mj_forward(model, data)
        held += abs(data.actuator_force[2]) == 4
        assert abs(ours[i] - data.qfrc_actuator).max() < 1e-12 * (1 + abs(data.qfrc_actuator).max())
    assert held > 5


def test_bound_ones_are_those_that_are_read():
    batch = copies(9, stepsize=0.002, threads=2)
    bound = {name: batch.bind(name) for name in (*OF_STATE, "com", "cfrc_ext", "qfrc_constraint")}
    batch.step(40)
    for name, array in bound.items():
        assert (array == batch.read(name)).all(), name


def turned_back(before, after):
    """The rates of a floating base after a step, in its axes before it."""
    turns = []
    for quaternion in (before[3:7], after[0][3:7]):
        matrix = np.zeros(9)
        mujoco.mju_quat2Mat(matrix, quaternion)
        turns.append(matrix.reshape(3, 3))
    return turns[0].T @ turns[1] @ after[1][3:6]


def test_forces_of_constraints_are_what_changed_the_velocities():
    """M (v+ - v) / h + bias - other forces by MuJoCo's numbers where the step began, and contacts by its Jacobians of C."""
    h = 0.002
    batch = copies(40, stepsize=h, tolerance=1e-12)
    batch.step(150)
    start, touching = {name: batch.read(name) for name in ("qpos", "qvel", "ctrl")}, 0
    batch.step()
    end, along, forces = {name: batch.read(name) for name in ("qpos", "qvel")}, batch.read("qfrc_constraint"), batch.read("cfrc_ext")
    model = mujoco.MjModel.from_xml_string(HOPPER)
    data, mass = mujoco.MjData(model), np.zeros((model.nv, model.nv))
    for i in range(batch.copies):
        data.qpos[:], data.qvel[:], data.ctrl[:] = (start[name][i] for name in ("qpos", "qvel", "ctrl"))
        mujoco.mj_forward(model, data)
        mujoco.mj_fullM(model, data, mass)
        velocity = end["qvel"][i].copy()
        velocity[3:6] = turned_back(start["qpos"][i], (end["qpos"][i], velocity))
        velocity[8:11] = start["qvel"][i, 8:11]  # the ball is a tree of its own
        wanted = mass @ ((velocity - data.qvel) / h) + data.qfrc_bias
        wanted[6] += 0.5 * velocity[6] - data.qfrc_actuator[6]
        assert abs(wanted[:7] - along[i, :7]).max() < 1e-8 * (10 + abs(along[i]).max())
        moved, jacp, jacr = np.zeros(model.nv), np.zeros((3, model.nv)), np.zeros((3, model.nv))
        for body, force in enumerate(forces[i].reshape(-1, 6)):
            mujoco.mj_jac(model, data, jacp, jacr, data.subtree_com[model.body_rootid[body]], body)
            moved += jacr.T @ force[:3] + jacp.T @ force[3:]
        assert abs(moved[:6] - along[i, :6]).max() < 1e-9 * (1 + abs(along[i]).max())
        touching += abs(forces[i]).max() > 0
    assert touching > 20
