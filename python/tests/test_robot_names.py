# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Every C function of include/epode has a name in Python; convex decomposition and constraints answer rightly."""
import pathlib
import re

import numpy as np
import pytest

import epode
from epode import robot

HEADERS = pathlib.Path(__file__).resolve().parents[2] / "include/epode"
# Where it is in Python. Numbers of names are looked up by the methods that take names; structures have defaults there.
NAMES = {
    "dDecompositionOptionsInit": "epode.decompose", "dCreateConvexDecomposition": "epode.decompose",
    "dRobotOptionsInit": "robot.load", "dRobotModelLoad": "robot.load", "dRobotModelLoadText": "robot.from_text",
    "dRobotModelSave": "robot.Model.save", "dRobotModelDestroy": "robot.Model",
    "dRobotModelGetReport": "robot.check", "dRobotModelHasErrors": "robot.check",
    "dRobotModelGetNumMocap": "robot.Model.mocap_names", "dRobotModelGetMocap": "robot.Model.mocap_names",
    "dRobotSetMocap": "robot.Mocap",
    "dRobotModelGetLinks": "robot.Model.link_names", "dRobotModelGetJoints": "robot.Model.joint_names",
    "dRobotModelGetNumPositions": "robot.Model.position_count", "dRobotModelGetNumVelocities": "robot.Model.velocity_count",
    "dRobotModelGetActuators": "robot.Model.actuators", "dRobotModelGetStartName": "robot.Model.starts",
    "dRobotModelGetNumActuators": "robot.Model.actuator_names", "dRobotModelGetNumStarts": "robot.Model.starts",
    "dRobotModelFindLink": "robot.Model.link_names", "dRobotModelFindJoint": "robot.Model.joint_names",
    "dRobotModelFindActuator": "robot.Model.actuator_names", "dRobotModelFindFrame": "robot.Model.frame_names",
    "dRobotModelGetGravity": "robot.Model.gravity", "dRobotModelGetStepsize": "robot.Model.stepsize",
    "dRobotModelGetReference": "robot.Model.reference", "dRobotModelGetStart": "robot.Model.starts",
    "dRobotModelGetPoses": "robot.Model.fk", "dRobotModelGetJacobian": "robot.Model.jacobian",
    "dRobotModelGetConstraints": "robot.Model.constraints", "dRobotModelGetMassMatrix": "robot.Model.mass_matrix",
    "dRobotModelGetInverseDynamics": "robot.Model.inverse_dynamics", "dRobotTargetInit": "robot.Target",
    "dRobotModelGetFluidForces": "robot.Model.fluid_forces", "dRobotAddFluidForces": "robot.Robot.add_fluid_forces",
    "dRobotAddForces": "robot.Robot.add_forces", "dRobotGetActivation": "robot.Robot.activations",
    "dRobotGetControl": "robot.Robot.controls", "dRobotGetState": "epode.World.save", "dRobotSetState": "epode.World.load",
    "dRobotSetActivation": "robot.Robot.activations", "dRobotModelFindTendon": "robot.Model.tendon_names",
    "dRobotModelGetTendons": "robot.Model.tendons",
    "dRobotInverseOptionsInit": "robot.Model.ik", "dRobotModelGetInverse": "robot.Model.ik",
    "dRobotCreate": "robot.Model.build", "dRobotDestroy": "robot.Robot.destroy", "dRobotGetBody": "robot.Robot.body",
    "dRobotGetJoint": "robot.Robot.joint", "dRobotSetPositions": "robot.Robot.positions",
    "dRobotGetPositions": "robot.Robot.positions", "dRobotSetVelocities": "robot.Robot.velocities",
    "dRobotGetVelocities": "robot.Robot.velocities", "dRobotSetControl": "robot.Robot.control",
    "dRobotSetTarget": "robot.Robot.target", "dRobotUpdateSensors": "robot.Robot.update_sensors",
    "dRobotGetDriveForces": "robot.Robot.drive_forces", "dRobotGetImu": "robot.Robot.imu",
    "dRobotSetForceSensor": "robot.Robot.watch_force", "dRobotGetForceTorque": "robot.Robot.force_torque",
    "dRobotGetTouch": "robot.Robot.touch", "dRobotCastRays": "robot.Robot.rays", "dRobotCameraInit": "robot.Robot.picture",
    "dRobotTakePicture": "robot.Robot.picture", "dRobotModelGetSensors": "robot.Model.sensors",
    "dRobotReadSensor": "robot.Robot.sensor",
    "dBatchOptionsInit": "epode.Batch", "dBatchCreate": "epode.Batch", "dBatchDestroy": "epode.Batch",
    "dBatchGetNumCopies": "epode.Batch.copies", "dBatchGetNumberSize": "epode.Batch", "dBatchGetNumThreads": "epode.Batch.threads",
    "dBatchGetSize": "epode.Batch.size", "dBatchRead": "epode.Batch.read", "dBatchWrite": "epode.Batch.write",
    "dBatchGetParameterSize": "epode.Batch.get", "dBatchReadParameter": "epode.Batch.get", "dBatchWriteParameter": "epode.Batch.set",
    "dBatchBind": "epode.Batch.bind", "dBatchStep": "epode.Batch.step", "dBatchReset": "epode.Batch.reset",
    "dBatchGetSensor": "epode.Batch.sensors", "dBatchJacobian": "epode.Batch.jacobian", "dBatchGetTangentSize": "epode.Batch.tangent_size",
    "dBatchLinearise": "epode.Batch.linearise", "dBatchLineariseParameter": "epode.Batch.linearise_parameter",
    "dBatchCastRays": "epode.Batch.rays", "dBatchCountBad": "epode.Batch.bad",
}
OF_INSTANCES = {"robot.Model.actuators", "robot.Model.starts", "robot.Model.sensors"}  # set when a model is made


def functions():
    found = set()
    for header in HEADERS.glob("*.h"):
        found.update(re.findall(r"^ODE_API[^;(]*?(\w+)\(", header.read_text(), re.M))
    return found


@pytest.mark.skipif(not HEADERS.exists(), reason="installed without its sources")
def test_every_function_has_a_name():
    assert functions() == set(NAMES)


@pytest.mark.parametrize("path", sorted(set(NAMES.values()) - OF_INSTANCES))
def test_every_name_is_there(path):
    found = {"epode": epode, "robot": robot}[path.split(".")[0]]
    for part in path.split(".")[1:]:
        found = getattr(found, part)
    assert found.__doc__


# An L of two boxes of 2 x 1 x 1 and 1 x 1 x 1: volume 3.
CORNERS = np.array([(0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2)], float)


def bracket():
    n = len(CORNERS)
    vertices = np.vstack([np.c_[CORNERS, np.zeros(n)], np.c_[CORNERS, np.ones(n)]])
    caps = [(0, 1, 2), (0, 2, 3), (0, 3, 4), (0, 4, 5)]
    sides = [(i, (i + 1) % n) for i in range(n)]
    triangles = [t[::-1] for t in caps] + [tuple(n + i for i in t) for t in caps]
    triangles += [(a, b, n + b) for a, b in sides] + [(a, n + b, n + a) for a, b in sides]
    return epode.Mesh(vertices, np.array(triangles, np.uint32), solid=True)


def test_a_bracket_is_two_boxes():
    found = epode.decompose(bracket(), tolerance=1e-3)
    assert found.closed and len(found.parts) == 2 and found.surplus < 1e-3
    with epode.World() as world:
        body = world.body(mass=1, inertia=np.eye(3))
        for part in found.parts:
            world.geom(part, body=body)
        assert len(body.geoms) == 2
    volumes = sorted(np.ptp(np.asarray(part.points), axis=0).prod() for part in found.parts)
    assert 3 - 1e-9 <= sum(volumes) < 3.05  # neighbours may overlap by a cell


def test_decomposition_refuses_what_is_no_solid():
    mesh = bracket()
    with pytest.raises(epode.RefusedError):
        epode.decompose(epode.Mesh(np.asarray(mesh.vertices) * (1, 1, 0), mesh.triangles))
    with pytest.raises(IndexError):
        epode.decompose(epode.Mesh(mesh.vertices, np.array([(0, 1, 99)], np.uint32)))
    for wrong in ({"tolerance": -1.0}, {"tolerance": float("nan")}, {"max_parts": 0}, {"max_parts": 257}, {"max_vertices": 3}):
        with pytest.raises(ValueError):
            epode.decompose(mesh, **wrong)


MIMIC = """<robot name="gripper"><link name="base"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0"
iyz="0"/></inertial></link>%s<joint name="left" type="revolute"><parent link="base"/><child link="l"/><axis xyz="0 0 1"/>
<limit lower="-1" upper="1" effort="1" velocity="1"/></joint><joint name="right" type="revolute"><parent link="base"/>
<child link="r"/><axis xyz="0 0 1"/><limit lower="-9" upper="9" effort="1" velocity="1"/>
<mimic joint="left" multiplier="2" offset="0.5"/></joint></robot>""" % "".join(
    f'<link name="{n}"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>'
    for n in "lr")


def test_constraints_are_those_of_the_coupling():
    model = robot.from_text(MIMIC, "gripper.urdf")
    q = np.array(model.reference)
    left, right = (next(j.position for j in model.joints if j.name == name) for name in ("left", "right"))
    q[left], q[right] = 0.2, 2 * 0.2 + 0.5
    errors, slope = model.constraints(q)
    assert errors.shape == (1,) and slope.shape == (1, model.velocity_count) and abs(errors[0]) < 1e-12
    q[right] += 0.1
    errors, slope = model.constraints(q)
    assert abs(abs(errors[0]) - 0.1 * abs(slope[0, next(j.velocity for j in model.joints if j.name == "right")])) < 1e-12
    free = np.zeros(model.velocity_count)
    free[next(j.velocity for j in model.joints if j.name == "left")] = 1
    free[next(j.velocity for j in model.joints if j.name == "right")] = 2
    assert abs(slope @ free)[0] < 1e-12
    with pytest.raises(ValueError):
        model.constraints([0.0])


def test_constraints_of_a_model_that_has_none_are_empty():
    model = robot.from_text("<mujoco><worldbody><body><joint axis='0 1 0'/><geom size='.1'/></body></worldbody></mujoco>")
    errors, slope = model.constraints([0.0])
    assert errors.shape == (0,) and slope.shape == (0, model.velocity_count)
