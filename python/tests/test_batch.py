# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Batches as a user has them: arrays that live, refusals that change nothing, the same bits on any threads."""
import os
import pickle
import subprocess
import sys

import numpy as np
import pytest

import epode

WALKER = """<mujoco model="walker"><compiler angle="radian"/><default><geom contype="0" conaffinity="1"/></default><worldbody>
<geom type="plane" size="9 9 1" contype="1" conaffinity="0"/><body name="trunk" pos="0 0 0.6"><freejoint/>
<geom type="capsule" size="0.1 0.2" euler="0 1.57 0" mass="3"/><body name="leg" pos="0.2 0 0"><joint name="hip" axis="0 1 0" range="-1 1"
damping="0.5" armature="0.01"/><geom type="capsule" fromto="0 0 0 0 0 -0.4" size="0.04" mass="1"/></body></body></worldbody>
<actuator><motor joint="hip" gear="20" ctrlrange="-1 1"/></actuator></mujoco>"""


@pytest.fixture
def model():
    return epode.robot.from_text(WALKER)


def driven(model, **options):
    batch = epode.Batch(model, 50, stepsize=0.004, **options)
    batch.write("ctrl", np.random.default_rng(1).uniform(-1, 1, (50, 1)))
    batch.step(200)
    return batch


def test_bound_arrays_live(model):
    batch = epode.Batch(model, 3)
    qpos, ctrl = batch.bind("qpos"), batch.bind("ctrl")
    assert qpos.shape == (3, 8) and qpos.dtype == np.float32 and batch.bind("qpos") is qpos
    before = qpos.copy()
    ctrl[1] = 1
    batch.step(10)
    assert (qpos[0] == qpos[2]).all() and (qpos[0] != qpos[1]).any() and (qpos != before).any()
    batch.reset(np.array([True, False, False]))
    assert (qpos[0] == before[0]).all() and (qpos[2] != before[2]).any()


@pytest.mark.parametrize("dtype", ["float32", "float64"])
def test_threads_leave_the_bits(model, dtype):
    one, many = driven(model, dtype=dtype, threads=1), driven(model, dtype=dtype, threads=3)
    assert many.threads == 3 and one.read("qpos").tobytes() == many.read("qpos").tobytes()
    assert one.bad == 0 and (one.read("residual") < 1e-4).all()


def test_a_rollout_is_steps(model):
    controls = np.random.default_rng(2).uniform(-1, 1, (4, 6, 1))
    one, other = epode.Batch(model, 4), epode.Batch(model, 4)
    qpos, qvel = one.rollout(controls, steps=5)
    for time in range(6):
        other.write("ctrl", controls[:, time])
        other.step(5)
        assert (qpos[:, time] == other.read("qpos")).all() and (qvel[:, time] == other.read("qvel")).all()


def test_copies_have_numbers_of_their_own(model):
    batch = epode.Batch(model, 2, dtype="float64")
    batch.set("gravity", [[0, 0, -9.81], [0, 0, -1.62]])
    assert batch.get("gravity")[1, 2] == -1.62 and batch.get("mass").shape == (2, 3)
    batch.step(50)
    assert np.allclose(batch.read("qvel")[:, 2], [-9.81 * 0.1, -1.62 * 0.1])
    with pytest.raises(ValueError):
        batch.set("mass", [0, -1, 1])


def test_what_is_wrong_is_refused_and_changes_nothing(model):
    batch = epode.Batch(model, 2)
    before = batch.read("qpos")
    for name, values in (("qpos", np.zeros((3, 8))), ("qpos", np.full((2, 8), np.nan)), ("qpos", np.zeros((2, 8))),
                         ("ctrl", [[np.inf], [0]]), ("bad", [[1], [0]]), ("speed", [[1], [0]])):
        with pytest.raises(ValueError):
            batch.write(name, values)
    batch.bind("ctrl")[0] = np.nan
    with pytest.raises(ValueError):
        batch.step()
    with pytest.raises(ValueError):
        batch.step(-1)
    with pytest.raises(ValueError):
        batch.reset([True])
    with pytest.raises(ValueError):
        batch.rollout(np.zeros((2, 3, 2)))
    with pytest.raises(TypeError):
        pickle.dumps(batch)
    assert (batch.read("qpos") == before).all()


def test_models_that_a_batch_cannot_take_are_named(model):
    rope = epode.robot.from_text("""<mujoco><worldbody><site name="s"/><body name="a"><joint/><geom size=".1"/><site name="t" pos="1 0 0"/></body>
</worldbody><tendon><spatial name="rope" stiffness="1"><site site="s"/><site site="t"/></spatial></tendon></mujoco>""")
    with pytest.raises(epode.RefusedError, match="rope"):
        epode.Batch(rope, 1)
    for wrong in ({"stepsize": 0}, {"stepsize": np.nan}, {"threads": -1}, {"max_sweeps": 0}):
        with pytest.raises(epode.RefusedError):
            epode.Batch(model, 1, **wrong)
    with pytest.raises(epode.RefusedError):
        epode.Batch(model, 0)


def test_bad_copies_stay_alone(model):
    batch, other = epode.Batch(model, 3), epode.Batch(model, 3)
    speeds = np.zeros((3, 7))
    speeds[1] = 9e14
    batch.write("qvel", speeds)
    batch.step(20)
    other.step(20)
    assert batch.bad == 1 and batch.read("bad")[1] == 1 and np.isfinite(batch.read("qpos")).all()
    assert (batch.read("qpos")[0] == other.read("qpos")[0]).all()


def test_a_copy_becomes_a_world(model):
    batch = driven(model, dtype="float64")
    world = batch.world(7)
    assert np.allclose(np.asarray(world.bodies[0].position)[2], batch.read("qpos")[7, 2], atol=0.3)
    world.step(0.004)


@pytest.mark.skipif(not hasattr(os, "fork"), reason="no fork")
def test_a_fork_has_no_batch(model):
    batch = epode.Batch(model, 1)
    child = os.fork()
    if child == 0:
        try:
            batch.step()
        except RuntimeError:
            os._exit(7)
        os._exit(0)
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 7


def test_the_interpreter_ends_while_batches_step():
    code = (f"import epode, threading, time\nmodel = epode.robot.from_text({WALKER!r})\n"
            "def go():\n    batch = epode.Batch(model, 1000, threads=2)\n    while True: batch.step(1)\n"
            "threading.Thread(target=go, daemon=True).start()\ntime.sleep(0.3)")
    for _ in range(5):
        result = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, timeout=60)
        assert result.returncode == 0, result.stderr


def test_rays_measure_heights(model):
    batch = epode.Batch(model, 4, dtype="float64")
    down = batch.rays("trunk", [(0, 0, -1), (0, 0, -2)], origins=[(0.5, 0, 0), (0, 0.7, 0.1)], axes="upright")
    assert down.shape == (4, 2) and np.allclose(down, [0.6, 0.7])
    shapes = np.empty((4, 1), np.int32)
    assert np.isinf(batch.rays(1, [(0, 0, 1)], shapes=shapes)).all() and (shapes == -1).all()
    batch.set("terrain", [0, 0, -0.25])
    assert np.allclose(batch.rays(1, [(0, 0, -1)], origins=[(1, 1, 0)], axes="world"), 0.85)
    for wrong in ([(0, 0, 0)], [(0, 1)], [(0, 0, np.nan)]):
        with pytest.raises(ValueError):
            batch.rays(1, wrong)
    with pytest.raises(IndexError):
        batch.rays(7, [(0, 0, 1)])


def test_copies_are_recorded(model, tmp_path):
    batch = epode.Batch(model, 9, stepsize=0.004)
    batch.write("ctrl", np.linspace(-1, 1, 9)[:, None])
    with batch.record([0, 8], spacing=2) as recording:
        for _ in range(20):
            batch.step(5)
    batch.step(5)
    assert len(recording) == 21 and abs(recording.times[-1] - 0.4) < 1e-9
    bodies = recording.bodies(-1)
    assert len(bodies) == 4 and abs(bodies[2, 0] - bodies[0, 0] - 2) < 0.5 and not np.allclose(bodies[0, 2:], bodies[2, 2:])
    recording.save(tmp_path / "copies.epr")
    assert len(epode.Recording.load(tmp_path / "copies.epr")) == 21
    with pytest.raises(IndexError):
        batch.record(9)


def test_arrays_go_to_others_without_a_copy(model):
    batch = epode.Batch(model, 3, pinned=True, threads=2)
    qpos = batch.bind("qpos")
    other = np.from_dlpack(qpos)
    batch.step(5)
    assert other.ctypes.data == qpos.ctypes.data and (other == batch.read("qpos")).all()


@pytest.mark.parametrize("method", ["exact", "differences"])
def test_linearise_predicts_the_next_state(model, method):
    """A small change of state and controls goes where the derivatives say."""
    rng = np.random.default_rng(4)
    batch = epode.Batch(model, 3, dtype="float64", stepsize=0.004)
    batch.write("qvel", rng.normal(0, 1, 7))
    a, b = batch.linearise(method=method)
    assert batch.tangent_size == 14 and a.shape == (3, 14, 14) and b.shape == (3, 14, 1)
    assert np.array_equal(a[0], a[1]) and np.array_equal(batch.linearise([2], method=method)[0][0], a[2])
    change, control = 1e-5 * rng.normal(0, 1, (3, 7)), 1e-5 * np.array([[0.], [1.], [2.]])
    velocities = batch.read("qvel")
    moved = epode.Batch(model, 3, dtype="float64", stepsize=0.004)
    batch.step()
    moved.write("qvel", velocities + change)
    moved.write("ctrl", control)
    moved.step()
    predicted = np.einsum("cij,cj->ci", a[:, 7:, 7:], change) + (b[:, 7:] @ control[:, :, None])[:, :, 0]
    assert np.abs(moved.read("qvel") - batch.read("qvel") - predicted).max() < 1e-8


def test_linearise_over_parameters(model):
    batch = epode.Batch(model, 2, dtype="float64", stepsize=0.004)
    by_gravity = batch.linearise_parameter("gravity")
    assert by_gravity.shape == (2, 14, 3) and by_gravity[0, 7 + 2, 2] == pytest.approx(0.004)
    assert batch.linearise_parameter("mass", [1], method="differences").shape == (1, 14, 3)


def test_jacobians_are_the_models(model):
    batch = epode.Batch(model, 4, dtype="float64")
    rng = np.random.default_rng(6)
    qpos = rng.normal(0, 1, (4, 8))
    qpos[:, 3:7] /= np.linalg.norm(qpos[:, 3:7], axis=1, keepdims=True)
    batch.write("qpos", qpos)
    ours = batch.jacobian("leg", (0.1, 0, -0.4), copies=[3, 0])
    assert ours.shape == (2, 6, 7)
    for row, copy in enumerate((3, 0)):
        assert np.abs(ours[row] - model.jacobian("leg", qpos[copy], (0.1, 0, -0.4))).max() < 1e-13


def test_derivatives_refuse(model):
    batch = epode.Batch(model, 2)
    for wrong in (lambda: batch.linearise(method="guess"), lambda: batch.linearise(distance=-1), lambda: batch.linearise(distance=float("nan")),
                  lambda: batch.linearise_parameter("colour"), lambda: batch.jacobian("leg", (np.nan, 0, 0))):
        with pytest.raises(ValueError):
            wrong()
    with pytest.raises(IndexError):
        batch.linearise([2])
    with pytest.raises(KeyError):
        batch.jacobian("wing")


def test_derivatives_are_mujocos():
    """Of a cart with a pole, where both solve the same equations; jacobians of everything."""
    mujoco = pytest.importorskip("mujoco")
    text = """<mujoco><compiler angle="radian"/><option timestep="0.01"/><worldbody><body><joint name="rail" type="slide" axis="1 0 0" damping="0.2"/>
<geom size="0.1" mass="1"/><body><joint name="hinge" axis="0 1 0" damping="0.01"/><geom type="capsule" fromto="0 0 0 0.1 0 0.6" size="0.03" mass="0.3"/>
<site name="tip" pos="0.1 0 0.6"/></body></body></worldbody><actuator><motor joint="rail" gear="10" ctrlrange="-1 1"/></actuator></mujoco>"""
    theirs = mujoco.MjModel.from_xml_string(text)
    data, rng = mujoco.MjData(theirs), np.random.default_rng(8)
    batch = epode.Batch(epode.robot.from_text(text), 5, dtype="float64", stepsize=0.01)
    qpos, qvel, ctrl = rng.normal(0, 1, (5, 2)), rng.normal(0, 1, (5, 2)), rng.uniform(-0.9, 0.9, (5, 1))
    for name, values in (("qpos", qpos), ("qvel", qvel), ("ctrl", ctrl)):
        batch.write(name, values)
    a, b = batch.linearise()
    jacobian = batch.jacobian("tip")
    for i in range(5):
        data.qpos[:], data.qvel[:], data.ctrl[:] = qpos[i], qvel[i], ctrl[i]
        other_a, other_b, linear, angular = np.empty((4, 4)), np.empty((4, 1)), np.empty((3, 2)), np.empty((3, 2))
        mujoco.mjd_transitionFD(theirs, data, 1e-6, True, other_a, other_b, None, None)
        mujoco.mj_forward(theirs, data)
        mujoco.mj_jacSite(theirs, data, linear, angular, 0)
        assert np.abs(a[i] - other_a).max() < 1e-6 and np.abs(b[i] - other_b).max() < 1e-6
        assert np.abs(jacobian[i] - np.vstack([linear, angular])).max() < 1e-10
