# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Robots built and edited in Python. MuJoCo, where it is installed, judges what is saved: mass matrix and bias of every edited model."""
import copy
import pickle
from pathlib import Path

import numpy as np
import pytest

import epode
from epode.description import Start
from epode.robot import Description

ROOT = Path(__file__).parent.parent.parent
FILES = [ROOT / "demos/robots" / name for name in ("arm.urdf", "fourbar_gripper.xml", "gripper.xml", "quadruped.xml")]
FILES += [ROOT / "tests/robots/models" / name for name in ("fourbar.xml", "hand.xml", "inline.xml", "walker.xml")]
GYMNASIUM = ["ant", "half_cheetah", "hopper", "humanoid", "inverted_double_pendulum", "point", "pusher", "reacher", "swimmer", "walker2d"]


def file_of(name):
    if isinstance(name, Path):
        return name
    gymnasium = pytest.importorskip("gymnasium")
    return Path(gymnasium.__file__).parent / "envs/mujoco/assets" / f"{name}.xml"


every_file = pytest.mark.parametrize("name", [*FILES, *GYMNASIUM], ids=lambda name: name.name if isinstance(name, Path) else name)


def hand():
    """A palm with two fingers on a tendon."""
    its = Description("hand")
    palm = its.add_link("palm")
    palm.add_geom(epode.Box(.1, .05, .04), mass=.3)
    for side in (-1, 1):
        finger = palm.add_link(f"finger{side}", position=(.05, side * .02, 0), euler=(0.1, .2, side * .3))
        finger.add_joint(f"finger{side}", axis=(0, 0.2, 1), limits=(-.5, .5), damping=.01, armature=1e-4)
        finger.add_geom(type="capsule", size=.008, fromto=(0, 0, 0, .06, 0, .01), density=700)
        finger.add_site(f"tip{side}", position=(.06, 0, .01))
    its.add_tendon("grip", joints={"finger1": 1, "finger-1": -1})
    its.add_actuator("grip", "position", tendon="grip", kp=3)
    its.add_sensor("grip", "tendonpos", "grip")
    its.starts["open"] = Start({"finger1": .2}, {"grip": .1})
    return its


def change_an_axis(d):
    joint = next((joint for joint in d.joints if joint.kind == "hinge"), None)
    if joint is not None:
        joint.axis, joint.anchor, joint.armature = (.3, 1, -.2), (.01, .02, .03), 0.02


def attach_a_limb(d):
    d.attach(hand(), d.links[len(d.links) - 1], prefix="new_", position=(.1, 0, .1), quaternion=(.9, .1, .2, .3))


def attach_to_the_world(d):
    d.attach(hand(), prefix="new_", position=(1, 0, .1), quaternion=(.9, .1, .2, .3))


def change_masses(d):
    for link in d.links:
        if link.mass:
            link.mass *= 1.5
            link.centre = link.centre + (0.01, 0, 0.02)
            link.inertia = link.inertia + 1e-3 * link.mass * np.eye(3)


def remove_the_last_link(d):
    d.links[len(d.links) - 1].remove()


EDITS = {"nothing": lambda d: None, "axis": change_an_axis, "limb": attach_a_limb, "world": attach_to_the_world, "scale": lambda d: d.scale(2),
         "x": lambda d: d.mirror("x"), "y": lambda d: d.mirror("y"), "z": lambda d: d.mirror("z"), "masses": change_masses,
         "removed": remove_the_last_link}


def differences(model, judge, mujoco):
    """The largest of mass matrices and bias forces, over their largest numbers."""
    assert judge.nq == model.position_count and judge.nv == model.velocity_count and judge.nu == len(model.actuators)
    data, random, worst = mujoco.MjData(judge), np.random.default_rng(1), 0.0
    for _ in range(3):
        data.qpos[:], data.qvel[:] = random.normal(size=judge.nq), random.normal(size=judge.nv)
        mujoco.mj_normalizeQuat(judge, data.qpos)
        mujoco.mj_forward(judge, data)
        full = np.zeros((judge.nv, judge.nv))
        for row, unit in zip(full, np.eye(judge.nv)):
            mujoco.mj_mulM(judge, data, row, unit)
        bias = data.qfrc_bias - data.qfrc_gravcomp
        for ours, theirs in ((model.mass_matrix(data.qpos), full), (model.inverse_dynamics(data.qpos, data.qvel), bias)):
            worst = max(worst, np.abs(ours - theirs).max(initial=0) / max(1e-9, np.abs(theirs).max(initial=0)))
    return worst


@every_file
def test_edited_and_saved_models_are_mujocos(name, tmp_path):
    mujoco = pytest.importorskip("mujoco")
    original = epode.load(file_of(name))
    for title, edit in EDITS.items():
        description = original.edit()
        edit(description)
        model = description.model()
        description.save(tmp_path / "edited.xml")
        judge = mujoco.MjModel.from_xml_path(str(tmp_path / "edited.xml"))
        assert differences(model, judge, mujoco) < 1e-11, title
        assert epode.load(tmp_path / "edited.xml", roots=[ROOT]).joint_names == model.joint_names


@every_file
def test_a_model_that_was_not_changed_is_the_same(name):
    model = epode.load(file_of(name))
    again = model.edit().model()
    assert again.joint_names == model.joint_names and again.starts.keys() == model.starts.keys()
    assert again.actuator_names == model.actuator_names or "" in model.actuator_names
    v = np.linspace(-1, 1, model.velocity_count)
    np.testing.assert_allclose(again.mass_matrix(model.reference), model.mass_matrix(model.reference), atol=1e-12)
    np.testing.assert_allclose(again.inverse_dynamics(model.reference, v), model.inverse_dynamics(model.reference, v), rtol=1e-12, atol=1e-10)
    for start, positions in model.starts.items():
        np.testing.assert_allclose(again.starts[start], positions, atol=1e-14)


@every_file
def test_scaled_by_two_has_eight_times_the_mass_and_thirty_two_times_the_inertia(name):
    model = epode.load(file_of(name))
    large = model.edit().scale(2).model()
    for one, two in zip(model.links, large.links):
        assert two.mass == pytest.approx(8 * one.mass, rel=1e-13)
        np.testing.assert_allclose(two.inertia, 32 * one.inertia, rtol=1e-9, atol=1e-12 * np.abs(one.inertia).max())
        np.testing.assert_allclose(two.centre, 2 * one.centre, rtol=1e-13, atol=1e-15)


def without_contacts(model):
    description = model.edit()
    for geom in description.geoms:
        geom.touches = False
    return description


def rows_of(joint):
    return slice(joint.velocity, joint.velocity + {"free": 6, "ball": 3}.get(joint.kind, 1))


@every_file
@pytest.mark.parametrize("axis", ["x", "y", "z"])
def test_mirrored_models_move_as_mirror_images(name, axis):
    description = without_contacts(epode.load(file_of(name)))
    model, image = description.model(), description.mirror(axis).model()
    sign = np.where(np.array(["x", "y", "z"]) == axis, -1, 1)
    random = np.random.default_rng(2)
    v, u = random.normal(size=model.velocity_count) / 2, random.uniform(-.3, .3, len(model.actuators))
    w = v.copy()
    for joint in model.joints:
        if joint.kind in ("free", "ball"):
            w[rows_of(joint)] *= np.concatenate([sign, -sign] if joint.kind == "free" else [-sign])
    poses = []
    for its, velocities in ((model, v), (image, w)):
        robot = its.build()
        robot.velocities, robot.controls = velocities, u
        for _ in range(100):
            robot.add_forces(0.002)
            robot.world.step(0.002)
        poses.append(its.fk(robot.positions)[:, :3])
    np.testing.assert_allclose(poses[0] * sign, poses[1], atol=1e-9)


@pytest.mark.parametrize("name", [FILES[0], FILES[1], FILES[2], "half_cheetah", "inverted_double_pendulum", "pusher"],
                         ids=lambda name: name.name if isinstance(name, Path) else name)
def test_a_scaled_model_moves_as_before_in_longer_times(name):
    description = without_contacts(epode.load(file_of(name)))
    for joint in description.joints:
        joint.limits = None  # which take back what violates them by a rate of their own
    model, large = description.model(), description.copy().scale(2).model()
    from epode.description._scale import Sizes
    powers = [Sizes(description, 2, True).control_power(one) for one in description.actuators]
    random = np.random.default_rng(3)
    v, u = random.normal(size=model.velocity_count) / 2, random.uniform(-.3, .3, len(model.actuators))
    slower = np.full(len(v), 2 ** -0.5)
    for joint in model.joints:
        if joint.kind in ("slide", "free"):
            slower[rows_of(joint)][:3] = 2 ** 0.5
    poses = []
    for its, velocities, controls, h in ((model, v, u, 0.002), (large, v * slower, u * 2.0 ** np.array(powers), 0.002 * 2 ** 0.5)):
        robot = its.build(epode.World(gravity=its.gravity))
        robot.velocities, robot.controls = velocities, controls
        for _ in range(200):
            robot.add_forces(h)
            robot.world.step(h)
        poses.append(its.fk(robot.positions)[:, :3])
    np.testing.assert_allclose(2 * poses[0], poses[1], atol=1e-7)


def test_forces_stay_where_they_are_asked_to():
    description = Description("one")
    link = description.add_link("a")
    link.add_joint("j", stiffness=3, damping=2, armature=0.5)
    link.add_geom(epode.Sphere(0.1), mass=1)
    description.add_actuator("m", joint="j", gear=5)
    assert description.copy().scale(2).joints["j"].stiffness == 48
    joint = description.scale(2, forces=False).joints["j"]
    assert (joint.stiffness, joint.damping, joint.armature, description.actuators["m"].gear[0]) == (3, 2, 16, 5)


def test_a_robot_is_built_from_nothing():
    """A pendulum by its closed form: period 2 pi sqrt(I / (m g l)) of small angles."""
    description = Description("pendulum")
    rod = description.add_link("rod")
    rod.add_joint("pin", axis=(0, 1, 0))
    rod.set_inertial(2, (0.02, 0.03, 0.01), centre=(0, 0, -0.5))
    model = description.model()
    moment = 0.03 + 2 * 0.25
    assert model.mass_matrix([0.0]) == pytest.approx(moment)
    robot = model.build(start=[0.01])
    period = 2 * np.pi * np.sqrt(moment / (2 * 9.81 * 0.5))
    robot.world.step(period / 1000, steps=1000)
    assert robot.positions[0] == pytest.approx(0.01, rel=1e-3)


def test_shapes_are_those_of_worlds():
    description = Description("shapes")
    link = description.add_link("a")
    link.add_joint("free", "free")
    for shape in (epode.Sphere(.1), epode.Box(.1, .2, .3), epode.Capsule(.1, .4), epode.Cylinder(.1, .4), epode.Ellipsoid(.1, .2, .3)):
        assert link.add_geom(shape, density=500).shape == shape
    cube = np.array([[x, y, z] for x in (0, .1) for y in (0, .2) for z in (0, .3)])
    link.add_geom(epode.Convex(cube), mass=0.4)
    description.world.add_geom(epode.Plane((0, 1, 0), 0.5))
    model = description.model()
    volume = 4 / 3 * np.pi * .1 ** 3 * (1 + 6) + .1 * .2 * .3 + 2 * np.pi * .01 * .4 + 4 / 3 * np.pi * .1 ** 3
    assert model.links[1].mass == pytest.approx(500 * volume + 0.4, rel=1e-12)
    world = model.build().world
    assert len(world.geoms) == 7


def test_what_is_attached_moves_with_what_it_is_attached_to():
    arm = Description("arm")
    link = arm.add_link("upper", position=(0, 0, 1))
    link.add_joint("shoulder", axis=(0, 1, 0))
    link.add_geom(epode.Capsule(.02, .4), mass=1)
    link.add_site("flange", position=(.1, 0, .2), quaternion=(0.5 ** 0.5, 0, 0, 0.5 ** 0.5))
    arm.starts["open"] = Start({"shoulder": 0.7})
    roots = arm.attach(hand(), "flange", prefix="left_", position=(0, .1, 0))
    assert [root.name for root in roots] == ["left_palm"] and roots[0].parent is link
    arm.attach(hand(), link, prefix="right_")
    model = arm.model()
    assert model.actuator_names == ["left_grip", "right_grip"] and model.sensors[0].object == "left_grip"
    p, q = model.pose("left_palm", model.reference)
    np.testing.assert_allclose(p, (0, 0, 1.2), atol=1e-15)  # the flange's y is -x
    np.testing.assert_allclose(q, (0.5 ** 0.5, 0, 0, 0.5 ** 0.5), atol=1e-15)
    joints = dict(zip(model.joint_names, model.starts["open"]))
    assert joints == {"shoulder": 0.7, "left_finger-1": 0, "left_finger1": 0.2, "right_finger-1": 0, "right_finger1": 0.2}


def test_a_free_robot_is_fixed_where_it_is_attached_and_free_in_the_world():
    ball = Description("ball")
    link = ball.add_link("ball", position=(0, 0, 1))
    link.add_joint("free", "free")
    link.add_geom(epode.Sphere(.1), mass=2)
    ball.starts["up"] = Start({"free": (0, 0, 3, 1, 0, 0, 0)})
    stand = Description("stand")
    stand.add_link("stand").add_geom(epode.Box(.1, .1, .1))
    both = stand.copy()
    both.attach(ball, "stand", prefix="a_")
    assert len(both.joints) == 0 and both.model().links[0].name == "world"
    turned = (0.5 ** 0.5, 0.5 ** 0.5, 0, 0)  # z becomes -y
    stand.attach(ball, position=(1, 0, 0), quaternion=turned)
    model = stand.model()
    np.testing.assert_allclose(model.reference, (1, -1, 0, *turned), atol=1e-12)
    np.testing.assert_allclose(model.starts["up"], (1, -3, 0, *turned), atol=1e-12)


@pytest.mark.parametrize("pose", [{}, {"position": (.3, .2, .1), "quaternion": (.8, .1, .5, .2)}])
@pytest.mark.parametrize("to", [None, "cart"])
def test_loops_of_what_is_attached_hold_where_it_is(to, pose):
    loops = epode.robot.from_text(
        "<mujoco><worldbody><body name='a' pos='1 0 0'><joint name='a' axis='0 1 0'/><geom size='.1' mass='1'/></body>"
        "<body name='b' pos='1 0 .5'><freejoint/><geom size='.1' mass='1'/></body></worldbody><equality>"
        "<connect body1='a' anchor='.1 0 .2'/><connect body1='world' body2='a' anchor='1 .1 0'/><weld body1='b' body2='a'/>"
        "<weld body1='a'/></equality></mujoco>").edit()
    if to is not None:
        loops.joints[1].remove()
    base = Description("base")
    cart = base.add_link("cart", position=(0, 2, 0))
    cart.add_joint("rail", "slide", axis=(0, 1, 0))
    cart.add_geom(epode.Box(.1, .1, .1))
    base.attach(loops, to, prefix="l_", **pose)
    model = base.model()
    errors, _ = model.constraints(model.reference)
    assert len(errors) == 3 + 3 + 6 + 6 and np.abs(errors).max() < 1e-12


def test_a_left_arm_is_made_of_a_right_one():
    body = Description("body")
    trunk = body.add_link("trunk", position=(0, 0, 1))
    trunk.add_joint("root", "free")
    trunk.add_geom(epode.Box(.2, .3, .4))
    arm = trunk.add_link("right_arm", position=(.02, -.2, .1), euler=(.2, .1, -.3))
    arm.add_joint("right_arm", axis=(1, .2, .1), limits=(-1, .2))
    arm.add_geom(type="capsule", size=.03, fromto=(0, 0, 0, .05, -.02, -.3))
    arm.add_site("right_tip", position=(.05, -.02, -.3))
    body.add_actuator("right_arm", "position", joint="right_arm", kp=10)
    left = body.extract("right_arm").mirror("y", rename={"right": "left"})
    assert left.actuators.names == ["left_arm"]
    body.attach(left, "trunk")
    model = body.model()
    for angle in (0, 0.15, -0.9):
        q = [*model.reference[:7], angle, angle]
        right, left_tip = (model.pose(side + "_tip", q)[0] for side in ("right", "left"))
        np.testing.assert_allclose(right * (1, -1, 1), left_tip, atol=1e-15)
    assert np.allclose(model.links[2].inertia * np.outer((1, -1, 1), (1, -1, 1)), model.links[3].inertia, atol=1e-15)


def test_what_refers_to_something_goes_with_it_and_follows_its_name():
    description = hand()
    description.joints["finger1"].name = "thumb"
    assert description.tendons["grip"].joints == {"thumb": 1, "finger-1": -1} and description.starts["open"].positions == {"thumb": .2}
    description.exclude("finger1", "finger-1")
    gone = description.links["finger1"].remove()
    assert sorted(gone) == ["actuator 'grip'", "exclusion", "sensor 'grip'", "tendon 'grip'"]
    assert description.starts["open"] == Start() and description.model().joint_names == ["finger-1"]
    swap = {"finger1": "finger-1", "finger-1": "finger1"}
    swapped = hand().rename(lambda name: swap.get(name, name))
    assert swapped.links.names == ["palm", "finger1", "finger-1"] and swapped.tendons["grip"].joints == {"finger-1": 1, "finger1": -1}


def test_meshes_are_mirrored_scaled_and_found_again(tmp_path):
    mujoco = pytest.importorskip("mujoco")
    wedge = np.array([[0, 0, 0], [.3, 0, 0], [0, .2, 0], [0, 0, .1]])
    faces = np.array([[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]])
    (tmp_path / "wedge.obj").write_text("".join(f"v {x} {y} {z}\n" for x, y, z in wedge) + "".join(f"f {a + 1} {b + 1} {c + 1}\n" for a, b, c in faces))
    description = Description("wedge", folder=tmp_path)
    link = description.add_link("a")
    link.add_joint("free", "free")
    link.add_geom("wedge.obj", position=(.1, 0, 0), quaternion=(.8, .1, .3, .2), density=500)
    link.add_geom(epode.Mesh(wedge, faces), position=(0, .4, 0), density=500)
    for axis in ("x", "y", "z"):
        image = description.copy().mirror(axis).scale(2)
        (tmp_path / "elsewhere").mkdir(exist_ok=True)
        image.save(tmp_path / "elsewhere/image.xml")
        sign = np.where(np.array(["x", "y", "z"]) == axis, -1, 1)
        one, two = description.model().links[1], image.model().links[1]
        assert two.mass == pytest.approx(8 * one.mass) and one.mass == pytest.approx(500 * 2 * .3 * .2 * .1 / 6)
        np.testing.assert_allclose(two.centre, 2 * sign * one.centre, atol=1e-12)
        np.testing.assert_allclose(two.inertia, 32 * np.outer(sign, sign) * one.inertia, atol=1e-10)
        judge = mujoco.MjModel.from_xml_path(str(tmp_path / "elsewhere/image.xml"))
        np.testing.assert_allclose(judge.body_ipos[1], two.centre, atol=1e-7)


def test_descriptions_and_models_are_compared_copied_and_pickled():
    description = epode.load(FILES[3]).edit()
    for twin in (description.copy(), copy.copy(description), copy.deepcopy(description), pickle.loads(pickle.dumps(description))):
        assert twin == description and twin is not description
        twin.joints[1].damping += 1
        assert twin != description
    model = description.model()
    assert pickle.loads(pickle.dumps(model)) == model == copy.copy(model) and hash(copy.copy(model)) == hash(model)
    description.links["trunk"].mass = 9
    assert description.model() != model
    deep = Description("deep")
    link = deep.world
    for i in range(390):
        link = link.add_link(f"l{i}")
        link.add_geom(epode.Sphere(.1))
    assert pickle.loads(pickle.dumps(deep)) == deep and deep.model().edit() is not None


def test_urdf_is_edited_and_written(tmp_path):
    description = epode.load(FILES[0]).edit()
    description.joints["axis_4"].limits = (-1, 1)
    description.links["pen"].remove()
    description.save(tmp_path / "arm.urdf")
    again = epode.load(tmp_path / "arm.urdf")
    assert again.joints[3].high == 1 and "pen" not in again.frame_names and again.joint_names == [f"axis_{i}" for i in range(1, 8)]
    q = np.linspace(-.5, .5, 7)
    np.testing.assert_allclose(again.mass_matrix(q), description.model().mass_matrix(q), atol=1e-12)


def test_what_a_urdf_means_survives_edits(tmp_path):
    model = epode.load(FILES[0])
    description = model.edit()
    speeds = [joint.max_velocity for joint in model.joints]
    assert np.all(np.isfinite(speeds)) and [joint.max_velocity for joint in description.joints] == speeds
    description.joints["axis_1"].name = "waist"
    description.joints["axis_2"].max_velocity = np.inf
    description.joints["axis_3"].remove()
    again = description.model()
    assert [joint.max_velocity for joint in again.joints] == [speeds[0], np.inf, *speeds[3:]]
    with pytest.raises(ValueError, match="waist"):
        description.joints["waist"].max_velocity = 0
    both = Description("both")
    for side in ("a", "b"):
        both.attach(description, prefix=side)
    twice = both.model()
    assert [joint.max_velocity for joint in twice.joints] == 2 * [speeds[0], np.inf, *speeds[3:]]
    both.save(tmp_path / "both.xml")
    assert epode.load(tmp_path / "both.xml") == twice
    custom = both.text().split("<custom>")[1].split("</custom>")[0]
    assert "apart" in custom and "mean" in custom and not any("what it was attached to" in one for one in both.lost)
    other = epode.load(FILES[3]).edit()
    other.attach(description, prefix="x_", position=(1, 0, 0))
    assert any("what it was attached to" in one for one in other.lost)
    for joint in list(both.joints):
        joint.max_velocity = np.inf
    assert "tuple" not in both.text()
    both.save(tmp_path / "both.xml")
    pytest.importorskip("mujoco").MjModel.from_xml_path(str(tmp_path / "both.xml"))


URDF = """<robot name="r"><link name="base"><inertial><mass value="1"/><inertia ixx="1" iyy="1" izz="1" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="arm"><inertial><mass value="2"/><inertia ixx="A" iyy="A" izz="A" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="foot"><inertial><mass value="B"/><inertia ixx=".1" iyy=".2" izz=".15" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="j" type="continuous"><parent link="base"/><child link="arm"/></joint>
<joint name="f" type="fixed"><parent link="arm"/><child link="foot"/><origin xyz="1 0 0"/></joint></robot>"""


@pytest.mark.parametrize("moment, foot", [("1", "0"), ("0", "0.5"), ("-3", "0.5"), ("0", "0")])
def test_what_is_done_about_masses_is_done_after_edits_too(moment, foot, tmp_path):
    model = epode.robot.from_text(URDF.replace("A", moment).replace("B", foot), "r.urdf", repair=True)
    description = model.edit()
    again = description.model()
    description.save(tmp_path / "saved.xml")
    for its in (again, epode.load(tmp_path / "saved.xml")):
        for one, two in zip(model.links, its.links):
            assert one.name == two.name and two.mass == pytest.approx(one.mass)
            np.testing.assert_allclose(two.inertia, one.inertia, rtol=1e-9, atol=1e-12)


def edited():
    description = Description("arm")
    upper = description.add_link("upper")
    upper.add_joint("shoulder", axis=(0, 1, 0))
    upper.add_geom(epode.Capsule(.02, .4), mass=1)
    lower = upper.add_link("lower", position=(0, 0, .4))
    lower.add_joint("elbow")
    lower.add_geom(epode.Box(.1, .1, .1))
    description.add_actuator("servo", joint="elbow")
    return description


WRONG = [
    (lambda d: d.joints["elbo"], KeyError, ["elbo", "'elbow'"]),
    (lambda d: setattr(d.joints["elbow"], "dampng", 3), AttributeError, ["'elbow'", "'damping'"]),
    (lambda d: d.joints["elbow"].__setitem__("dampng", 3), epode.RefusedError, ["joint 'elbow'", "'damping'"]),
    (lambda d: d.links["lower"].add_geom(epode.Sphere(.1), frictio=.3), epode.RefusedError, ["geom of link 'lower'", "'friction'"]),
    (lambda d: setattr(d.actuators["servo"], "joint", "elbw"), epode.RefusedError, ["actuator 'servo'", "'elbow'"]),
    (lambda d: setattr(d.joints["elbow"], "axis", (0, 0, 0)), epode.RefusedError, ["'elbow'", "axis"]),
    (lambda d: setattr(d.joints["elbow"], "axis", (0, 0, np.nan)), ValueError, ["'elbow'", "axis", "nan"]),
    (lambda d: setattr(d.joints["elbow"], "kind", "hnge"), ValueError, ["'elbow'", "hinge"]),
    (lambda d: setattr(d.joints["elbow"], "limits", (2, 1)), ValueError, ["'elbow'", "limits"]),
    (lambda d: setattr(d.joints["elbow"], "name", "shoulder"), ValueError, ["'shoulder'"]),
    (lambda d: d.links["lower"].geoms[0].remove(), epode.RefusedError, ["'lower'", "no mass"]),
    (lambda d: d.links["lower"].set_inertial(1, (1, 1, 5)), epode.RefusedError, ["'lower'", "moment"]),
    (lambda d: d.links["lower"].set_inertial(-1, (1, 1, 1)), ValueError, ["'lower'", "-1"]),
    (lambda d: setattr(d.links["lower"], "mass", 2), ValueError, ["'lower'", "set_inertial"]),
    (lambda d: d.links["lower"].add_joint("free", "free"), epode.RefusedError, ["'free'", "world"]),
    (lambda d: d.attach(d.copy()), ValueError, ["'upper'", "prefix"]),
    (lambda d: d.attach(d.copy(), "uper", prefix="a"), KeyError, ["uper", "'upper'"]),
    (lambda d: d.attach(d.copy(), prefix="a", quaternion=(0, 0, 0, 0)), ValueError, ["quaternion"]),
    (lambda d: d.add_actuator("x", "moter", joint="elbow"), epode.RefusedError, ["'x'", "'motor'"]),
    (lambda d: d.add_actuator("x"), epode.RefusedError, ["'x'", "joint"]),
    (lambda d: d.add_sensor("x", "accelerometer", "elbow"), epode.RefusedError, ["'x'", "site", "'elbow'"]),
    (lambda d: d.add_tendon("t", joints={"shoudler": 1}), epode.RefusedError, ["'t'", "'shoulder'"]),
    (lambda d: d.add_loop("upper", "lowr"), epode.RefusedError, ["'lowr'", "'lower'"]),
    (lambda d: d.links["lower"].add_geom("nothere.stl"), epode.RefusedError, ["nothere.stl"]),
    (lambda d: d.links["lower"].add_geom(epode.Cone(.1, .1)), TypeError, ["Cone", "Capsule"]),
    (lambda d: d.links["lower"].add_geom(type="capsule", size=.1), epode.RefusedError, ["geom of link 'lower'", "capsule"]),
    (lambda d: d.links["lower"].add_geom(**{"class": "big"}), ValueError, ["classes"]),
    (lambda d: d.starts.update(home=Start({"elbw": 1})), epode.RefusedError, ["'home'", "'elbow'"]),
    (lambda d: d.starts.update(home=Start({"elbow": (1, 2)})), epode.RefusedError, ["'home'", "'elbow'", "1 finite"]),
    (lambda d: d.scale(-1), ValueError, ["-1"]),
    (lambda d: d.mirror("w"), ValueError, ["'w'"]),
    (lambda d: d.rename(lambda name: "one"), ValueError, ["'one'"]),
    (lambda d: d.world.remove(), ValueError, ["world"])]


@pytest.mark.parametrize("edit, kind, words", WRONG)
def test_what_is_wrong_is_refused_in_a_sentence_that_names_it(edit, kind, words):
    description = edited()
    with pytest.raises(kind) as error:
        edit(description)
        description.model()
    assert all(word in str(error.value) for word in words), str(error.value)


def test_what_was_removed_is_refused():
    description = edited()
    link = description.links["lower"]
    link.remove()
    for use in (link.remove, lambda: link.add_geom(epode.Sphere(.1)), lambda: description.extract(link), lambda: description.attach(edited(), link)):
        with pytest.raises(ValueError, match="lower"):
            use()


def test_a_refused_edit_changes_nothing():
    description = edited()
    before = description.text()
    for edit, kind, _ in WRONG:
        if kind is not epode.RefusedError:
            with pytest.raises(kind):
                edit(description)
            assert description.text() == before
