# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Sensors of the file, friction against turning, loops and bent couplings of batches, compared with MuJoCo."""
import numpy as np
import pytest

import epode

mujoco = pytest.importorskip("mujoco")

SENSING = """<mujoco model="sensing"><compiler angle="radian"/><option timestep="0.002"><flag eulerdamp="disable"/></option><worldbody>
<site name="post" pos="0.3 0.2 0.1" euler="0.4 0.1 0.2"/>
<body name="cart" pos="0.1 0.2 1"><joint name="rail" type="slide" axis="1 0.2 0"/><inertial pos="0.05 0 0.02" mass="2" diaginertia="0.02 0.03 0.025"/>
<site name="eye" pos="0.1 0.05 0.2" euler="0.3 -0.5 0.7"/>
<body name="arm" pos="0.1 0 -0.1" euler="0.3 0.2 0.1"><joint name="u" axis="0 0 1" pos="0.02 0 0" armature="0.1"/><joint name="v" axis="0 1 0" pos="0 0.03 0.01"/>
<inertial pos="0 0.02 -0.2" mass="1.1" diaginertia="0.012 0.011 0.004"/><site name="elbow" pos="0.01 0.02 -0.1" euler="0.2 0.3 -0.4"/>
<body name="bob" pos="0 0 -0.4"><joint name="w" type="ball" pos="0 0 0.02"/>
<inertial pos="0.03 0.01 -0.1" euler="0.4 0 0.5" mass="0.7" diaginertia="0.004 0.005 0.002"/><site name="tip" pos="0.02 -0.01 -0.15" euler="-0.6 0.2 0.9"/></body></body></body>
<body name="kite" pos="1 0 2"><freejoint name="loose"/><inertial pos="0.1 0 0" mass="0.9" diaginertia="0.01 0.02 0.027"/>
<site name="nose" pos="0.2 0.01 0.03" euler="0.1 0.2 0.3"/><body name="tail" pos="-0.2 0 0"><joint name="t" axis="0 1 0"/>
<inertial pos="-0.1 0 0" mass="0.2" diaginertia="0.001 0.002 0.002"/><site name="end" pos="-0.2 0 0" euler="0 0.7 0"/></body></body></worldbody>
<tendon><fixed name="sum"><joint joint="u" coef="0.5"/><joint joint="t" coef="-0.3"/></fixed></tendon>
<actuator><motor name="push" joint="rail" gear="3" ctrlrange="-0.5 0.5"/><position name="hold" joint="u" kp="{kp}" forcerange="-0.4 0.4"/>
<motor name="pull" tendon="sum" gear="2"/></actuator>
<sensor><jointpos name="jp" joint="rail"/><jointvel name="jv" joint="v"/><ballquat name="bq" joint="w"/><ballangvel name="bw" joint="w"/>
<rangefinder name="ray" site="eye"/><actuatorfrc actuator="push"/><actuatorfrc actuator="hold"/><actuatorfrc actuator="pull"/>
<actuatorpos actuator="pull"/><actuatorvel actuator="hold"/><jointactuatorfrc joint="u"/><jointactuatorfrc joint="t"/>
<framepos objtype="site" objname="tip"/><framequat objtype="site" objname="elbow"/><framexaxis objtype="site" objname="nose"/>
<frameyaxis objtype="body" objname="kite"/><framezaxis objtype="xbody" objname="arm"/><framelinvel objtype="site" objname="tip"/>
<frameangvel objtype="xbody" objname="bob"/><framepos objtype="site" objname="tip" reftype="site" refname="eye"/>
<framequat objtype="site" objname="nose" reftype="site" refname="elbow"/><framelinvel objtype="site" objname="end" reftype="site" refname="tip"/>
<frameangvel objtype="site" objname="end" reftype="site" refname="tip"/><framexaxis objtype="site" objname="end" reftype="site" refname="post"/>
<velocimeter site="tip"/><gyro name="gy" site="elbow"/><subtreecom body="cart"/><subtreecom body="world"/><subtreelinvel body="kite"/>
<accelerometer name="ac" site="tip"/><accelerometer site="nose"/><force name="fo" site="elbow"/><torque site="elbow"/><force site="end"/><torque site="end"/>
<touch site="eye"/></sensor></mujoco>"""
OF_STEP = {"accelerometer", "force", "torque", "touch"}


def sensing(kp):
    text = SENSING.replace("{kp}", str(kp))
    model = epode.robot.from_text(text)
    batch, rng = epode.Batch(model, 20, dtype="float64", stepsize=0.002, tolerance=1e-13), np.random.default_rng(4)
    batch.write("qpos", batch.read("qpos") + rng.uniform(-0.5, 0.5, (20, batch.size("qpos"))))
    batch.write("qvel", rng.normal(size=(20, batch.size("qvel"))))
    batch.write("ctrl", rng.uniform(-1, 1, (20, 3)))
    return text, batch


def compare(batch, row, sensordata, theirs, of_step):
    counted, named = 0, batch.sensors
    for number, sensor in enumerate(batch.model.sensors):
        place = named.get(sensor.name or number)
        if place is None or (sensor.kind in OF_STEP) != of_step:
            continue
        first = theirs.sensor_adr[number]
        want, has = sensordata[first:first + theirs.sensor_dim[number]], row[place]
        if len(want) == 4 and want @ has < 0:
            has = -has
        assert abs(has - want).max() < 1e-9 * (1 + abs(want).max()), (number, sensor.kind, has, want)
        counted += 1
    return counted


@pytest.mark.parametrize("kp", [2, 0])
def test_sensors_are_mujocos(kp):
    text, batch = sensing(kp)
    theirs = mujoco.MjModel.from_xml_string(text)
    datas = []
    for i in range(20):
        data = mujoco.MjData(theirs)
        data.qpos[:], data.qvel[:], data.ctrl[:] = batch.read("qpos")[i], batch.read("qvel")[i], batch.read("ctrl")[i]
        mujoco.mj_forward(theirs, data)
        assert compare(batch, batch.read("sensordata")[i], data.sensordata, theirs, False) == 28
        datas.append(data)
    if kp > 0:  # servos of a batch act at the step's end
        return
    batch.step()
    for i, data in enumerate(datas):
        assert compare(batch, batch.read("sensordata")[i], data.sensordata, theirs, True) == 7


def test_sensors_go_by_name():
    _, batch = sensing(2)
    gyro, accelerometer = batch.sensor("gy"), batch.sensor("ac")
    assert gyro.shape == (20, 3) and batch.sensor(0).shape == (20, 1) and 5 in batch.sensors and "ray" not in batch.sensors
    before = gyro.copy()
    batch.step()
    assert (gyro != before).any() and abs(accelerometer).max() > 0
    assert (gyro == batch.read("sensordata")[:, batch.sensors["gy"]]).all()
    with pytest.raises(ValueError, match="'ray'"):
        batch.sensor("ray")


BALL = """<mujoco><option timestep="{h}" cone="elliptic" iterations="200" tolerance="1e-14" impratio="10"/><worldbody>
<geom type="plane" size="9 9 1" friction="0 0 0"/><body pos="0 0 0.1"><freejoint/><geom size="0.1" mass="2" condim="6" friction="1 0.004 0.002"
solref="0.002 1" solimp="0.9999 0.9999 0.001"/></body></worldbody></mujoco>"""


@pytest.mark.parametrize("velocity", [(0, 0, 0, 0, 0, 3), (0.3, 0, 0, 0, 3, 0), (0.2, -0.2, 0, 2, 2, 0)])
def test_turning_slows_as_in_mujocos_hard_limit(velocity):
    theirs = mujoco.MjModel.from_xml_string(BALL.replace("{h}", "0.0005"))
    data = mujoco.MjData(theirs)
    data.qvel[:] = velocity
    mujoco.mj_step(theirs, data, 400)
    rigid = BALL.replace("{h}", "0.0005").replace('solref="0.002 1" solimp="0.9999 0.9999 0.001"', "")
    batch = epode.Batch(epode.robot.from_text(rigid), 1, dtype="float64", stepsize=0.0005)
    batch.write("qvel", np.array(velocity, float))
    batch.step(400)
    assert abs(batch.read("qvel")[0] - data.qvel).max() < 0.01 * np.linalg.norm(velocity)
    assert abs(batch.read("qvel")[0] - velocity).max() > 0.02


def test_frictions_against_turning_are_refused_where_there_are_none():
    batch = epode.Batch(epode.robot.from_text(BALL.replace("{h}", "0.001").replace('condim="6"', 'condim="4"')), 3)
    batch.set("torsional_friction", [[0.001], [0.002], [0.003]])
    assert np.allclose(batch.get("torsional_friction")[:, 0], [0.001, 0.002, 0.003])
    with pytest.raises(ValueError):
        batch.set("rolling_friction", [0.001])
    assert (batch.get("rolling_friction") == 0).all()


BENT = """<mujoco><compiler angle="radian"/><option timestep="0.0002"><flag eulerdamp="disable"/></option><worldbody>
<body><joint name="a" axis="0 1 0"/><inertial pos="0.2 0 0" mass="1" diaginertia="0.01 0.02 0.02"/><body pos="0.4 0 0"><joint name="b" axis="1 0 0"/>
<inertial pos="0 0.1 0" mass="0.5" diaginertia="0.01 0.01 0.01"/></body></body></worldbody>
<equality><joint joint1="b" joint2="a" polycoef="0 0.5 0.3 -0.4 0.2" solref="0.0005 1" solimp="0.9999 0.9999 0.001"/></equality></mujoco>"""
BARS = """<mujoco><compiler angle="radian"/><option timestep="0.0002"><flag eulerdamp="disable"/></option><default><geom contype="0" conaffinity="0"/>
</default><worldbody><body name="crank"><joint axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 0.15" size="0.02"/>
<body name="coupler" pos="0 0 0.15"><joint axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0.5 0 0.15" size="0.02"/>
<body name="rocker" pos="0.5 0 0.15"><joint axis="0 1 0"/><geom type="capsule" fromto="0 0 0 0 0 -0.3" size="0.02"/></body></body></body></worldbody>
<equality><connect body1="rocker" body2="world" anchor="0 0 -0.3" solref="0.0005 1" solimp="0.9999 0.9999 0.001"/></equality></mujoco>"""


@pytest.mark.parametrize("text", [BENT, BARS])
def test_equalities_move_as_in_mujocos_hard_limit(text):
    theirs = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(theirs)
    batch = epode.Batch(epode.robot.from_text(text), 1, dtype="float64", stepsize=0.0002)
    data.qvel[0] = 1  # taken up by both in their first step
    batch.write("qvel", data.qvel)
    mujoco.mj_step(theirs, data, 1500)
    batch.step(1500)
    assert abs(data.qpos).max() > 0.1
    assert abs(batch.read("qpos")[0] - data.qpos).max() < 0.01 * abs(data.qpos).max()
