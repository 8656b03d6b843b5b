# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What a roboticist asks a robot for by name: forces, sensors, poses, Jacobians, contacts, of one and of many; what steps do by
themselves; how a notebook shows it."""
import pickle
from pathlib import Path

import numpy as np
import pytest

import epode

# A trunk that floats, a ball joint, a slider and a hinge: every kind of joint.
TREE = """<mujoco model="tree"><worldbody><body name="trunk" pos="0 0 1"><freejoint/>
<inertial pos="0.1 0.02 0" mass="3" diaginertia="0.1 0.2 0.15"/>
<body name="arm" pos="0.3 0 0" euler="20 10 0"><joint type="ball"/><inertial pos="0 0.1 -0.2" mass="1" diaginertia="0.02 0.03 0.01"/>
<body name="rod" pos="0 0 -0.4"><joint name="slide" type="slide" axis="0 1 1"/><inertial pos="0.05 0 0" mass="0.7" diaginertia="0.01 0.01 0.02"/>
<body name="hand" pos="0.1 0 0"><joint name="turn" axis="1 0 0"/><inertial pos="0 0 0.1" mass="0.5" diaginertia="0.005 0.004 0.003"/>
<site name="tip" pos="0 0 0.2"/></body></body></body></body></worldbody></mujoco>"""
PLACE = {"position": (1, 2, 3), "quaternion": (0.5, 0.5, -0.5, 0.5)}
CRATE = """<mujoco model="crate"><worldbody><geom name="floor" type="plane" size="3 3 0.1"/><body name="crate" pos="0 0 0.1">
<freejoint/><geom type="box" size="0.1 0.1 0.1" mass="2"/></body></worldbody></mujoco>"""


def tree(**place):
    rng = np.random.default_rng(3)
    model = epode.robot.from_text(TREE)
    q = model.reference + 0.3 * rng.normal(size=model.position_count)
    for first in (3, 7):
        q[first:first + 4] /= np.linalg.norm(q[first:first + 4])
    robot = model.build(start=q, **place)
    robot.velocities = 0.2 * rng.normal(size=model.velocity_count)
    return robot


@pytest.mark.parametrize("place", [{}, PLACE])
def test_applied_forces_are_those_of_the_equation_of_motion(place):
    """M v' / h = tau - bias of a robot at rest: the first step from it is exact."""
    forces = np.random.default_rng(8).normal(size=11)
    robot = tree(**place)
    robot.velocities = np.zeros(11)
    robot.world.gravity = (1, 2, -9)
    wanted = np.linalg.solve(robot.mass_matrix(), forces - robot.bias_forces())
    robot.apply(forces)
    robot.world.step(1e-4)
    assert robot.velocities / 1e-4 == pytest.approx(wanted, rel=1e-5, abs=1e-5 * np.abs(wanted).max())
    with pytest.raises(ValueError, match="forces: 11"):
        robot.apply([1, 2])


@pytest.mark.parametrize("place", [{}, PLACE])
def test_the_jacobian_is_what_velocities_make_of_a_frame(place):
    robot = tree(**place)
    velocity = robot.jacobian("tip", (0.1, 0, 0)) @ robot.velocities
    body = robot.body("hand")
    position, quaternion = robot.pose("tip")
    point = position + epode.robot._turned(quaternion) @ (0.1, 0, 0)
    assert velocity[:3] == pytest.approx(body.velocity_at(point), abs=1e-12)
    assert velocity[3:] == pytest.approx(body.angular_velocity, abs=1e-12)
    assert robot.mass_matrix() == pytest.approx(robot.model.mass_matrix(robot.positions))
    if not place:
        assert robot.bias_forces() == pytest.approx(robot.model.inverse_dynamics(robot.positions, robot.velocities))


def test_poses_are_those_of_the_model_moved_to_its_place():
    robot = tree(**PLACE)
    turn = epode.robot._turned(np.array(PLACE["quaternion"]))
    links = robot.model.fk(robot.positions)
    assert robot.poses.shape == (5, 7) and robot.poses[:, :3] == pytest.approx(links[:, :3] @ turn.T + PLACE["position"])
    for number, name in enumerate(robot.model.link_names):
        assert np.concatenate(robot.pose(name)) == pytest.approx(robot.poses[number])
    assert np.concatenate(robot.pose("world")) == pytest.approx([*PLACE["position"], *PLACE["quaternion"]])


@pytest.mark.parametrize("place", [{}, PLACE])
def test_inverse_kinematics_in_the_world_begin_where_the_robot_is(place):
    robot = tree(**place)
    position, quaternion = robot.pose("tip")
    here = robot.ik("tip", position, quaternion)
    assert here.reached and here.positions == pytest.approx(robot.positions, abs=1e-6)
    there = robot.ik("tip", position + (0.1, 0, 0.05), quaternion)
    robot.positions = there.positions
    assert there.reached and robot.pose("tip")[0] == pytest.approx(position + (0.1, 0, 0.05), abs=1e-8)
    assert abs(robot.pose("tip")[1] @ quaternion) == pytest.approx(1)


def test_parts_go_by_name():
    robot = tree()
    model = robot.model
    assert model.joint("turn") is model.joints[3] and model.link("hand").mass == 0.5 and list(robot.joints) == [1, "slide", "turn"]
    assert robot.joints["turn"] is robot.joint("turn")
    for wrong in (model.joint, model.link, model.actuator):
        with pytest.raises(KeyError, match="nobody"):
            wrong("nobody")


def test_geoms_go_by_the_names_of_the_file():
    """MuJoCo has the same names at the same places."""
    mujoco, gymnasium = pytest.importorskip("mujoco"), pytest.importorskip("gymnasium")
    compared = 0
    for name in ("ant", "half_cheetah", "humanoid", "pusher", "walker2d_v5"):
        path = Path(gymnasium.__file__).parent / "envs" / "mujoco" / "assets" / f"{name}.xml"
        robot = epode.load(path).build()
        theirs = mujoco.MjModel.from_xml_path(str(path))
        data = mujoco.MjData(theirs)
        data.qpos[:] = robot.positions
        mujoco.mj_forward(theirs, data)
        for geom in robot.geoms:
            its = robot.geom_name(geom)
            if its and not isinstance(geom.shape, epode.Plane) and "plane" not in repr(geom):
                assert geom.position == pytest.approx(data.geom(its).xpos, abs=1e-6) and robot.geom(its) is geom
                compared += 1
    assert compared >= 45
    robot = epode.robot.from_text(CRATE).build()
    assert robot.model.geom_names == [["floor"], [""]] and robot.geom("floor") is robot.geoms[0] and robot.geom_name(robot.geoms[1]) == ""
    robot.world.step(0.002, steps=3)
    assert {robot.geom_name(one.other_geom) for one in robot.contacts()} == {"floor"} and robot.contacts()[0].geom is robot.geoms[1]
    with pytest.raises(KeyError, match="did you mean 'floor'"):
        robot.geom("flor")


def test_contacts_have_names_normals_to_the_link_and_forces_on_it():
    robot = epode.robot.from_text(CRATE).build()
    robot.world.step(0.002, steps=300)
    touching = robot.contacts()
    assert len(touching) == len(robot.contacts("crate")) == 4 and robot.contacts("world") == []
    for one in touching:
        assert one.link == "crate" and one.other is robot.geoms[0] and one.normal == pytest.approx([0, 0, 1])
        assert one.position == pytest.approx([0, 0, 0], abs=0.15)
    assert sum(one.normal_force for one in touching) == pytest.approx(19.62, rel=1e-3)
    ball = robot.world.body(mass=1, position=(0, 0, 0.3), shape=epode.Sphere(0.1))
    robot.world.step(0.002, steps=300)
    above = [one for one in robot.contacts("crate") if one.other is ball.geoms[0]]
    assert len(above) == 1 and above[0].normal == pytest.approx([0, 0, -1], abs=1e-6)
    assert above[0].normal_force == pytest.approx(9.81, rel=1e-3)


MUSCLE = """<mujoco><option gravity="0 0 0"/><worldbody><site name="top" pos="0 0 1"/><body><joint name="down" type="slide" axis="0 0 1"/>
<geom size="0.05" mass="2"/><site name="hook"/></body></worldbody><tendon><spatial name="string" stiffness="500" damping="20" springlength="0.5">
<site site="top"/><site site="hook"/></spatial></tendon><actuator><general name="push" joint="down" dyntype="filter" dynprm="0.1"/></actuator>
<sensor><accelerometer name="felt" site="hook"/><gyro name="turning" site="hook"/><jointpos name="place" joint="down"/></sensor></mujoco>"""


def test_steps_let_tendons_and_filters_act_and_measure():
    """The same bits as of a program that adds and measures by itself, once, whoever does it."""
    model = epode.robot.from_text(MUSCLE)
    by_itself, by_hand = model.build(), model.build()
    for robot in (by_itself, by_hand):
        robot.control("push", 3)
    for _ in range(50):
        by_itself.world.step(0.002)
        assert by_hand.add_forces(0.002) == 2
        by_hand.world.step(0.002)
        by_hand.update_sensors(0.002)
    assert by_itself.positions.tobytes() == by_hand.positions.tobytes() and by_itself.positions[0] > 0.1
    assert by_itself.activations[0] == pytest.approx(3 * (1 - 0.98 ** 50))
    assert by_itself.sensor("felt").tobytes() == by_hand.sensor("felt").tobytes() and by_itself.sensor("felt")[2] != 0
    many = epode.robot.Robots([model.build(), model.build()])
    many.controls = [3]
    many.step(0.002, steps=50)
    assert many.positions[0].tobytes() == many.positions[1].tobytes() == by_itself.positions.tobytes()
    assert many.sensors["felt"].shape == (2, 3) and many.sensor("felt")[1] == pytest.approx(by_itself.sensor("felt"))


def test_many_have_what_one_has():
    model = epode.robot.from_text(MUSCLE)
    many = epode.Robots([model.build(start=[0.1 * i] * model.position_count) for i in range(3)])
    many.controls = [3]
    many.activations = [[1], [2], [0.5]]
    many.step(0.002, steps=5)
    for name in ("forces", "activations", "actuator_forces", "positions", "velocities", "poses"):
        assert np.array_equal(getattr(many, name), [getattr(robot, name) for robot in many])
    for name in ("mass_matrix", "bias_forces"):
        assert np.array_equal(getattr(many, name)(), [getattr(robot, name)() for robot in many])
    assert np.array_equal(many[0].forces, many[0].drive_forces)
    forces = np.arange(3 * model.velocity_count, dtype=float).reshape(3, -1)
    pushed, by_one = (pickle.loads(pickle.dumps(many)) for _ in range(2))
    pushed.apply(forces)
    for robot, its in zip(by_one, forces):
        robot.apply(its)
    pushed.step(0.002)
    by_one.step(0.002)
    assert np.array_equal(pushed.velocities, by_one.velocities) and not np.array_equal(pushed.velocities, many.velocities)
    with pytest.raises(ValueError, match="an array"):
        many.apply([1, 2, 3, 4])


def test_a_refused_step_says_what_is_wrong_without_functions_of_c():
    world = epode.World()
    for h in (-0.1, 0, np.nan, np.inf):
        for call in (lambda: world.step(h), lambda: epode.step_worlds([world], h)):
            with pytest.raises(epode.RefusedError) as caught:
                call()
            assert "dWorld" not in str(caught.value) and f"h={h}" in str(caught.value)


@pytest.mark.parametrize("preset", ["ode", "game", "robot"])
def test_many_step_with_the_bits_of_one(preset):
    for text in (MUSCLE, CRATE.replace('pos="0 0 0.1"', 'pos="0 0 0.3" euler="20 10 0"')):
        model = epode.robot.from_text(text)
        alone, many = (model.build(epode.World(gravity=(0, 0, -9.81), defaults=preset)) for _ in range(2))
        begin = alone.positions
        alone.world.step(0.004, steps=60)
        epode.robot.Robots([many]).step(0.004, steps=60)
        assert many.positions.tobytes() == alone.positions.tobytes() and np.abs(many.positions - begin).max() > 0.1


def test_a_clone_lets_them_act_too():
    robot = epode.robot.from_text(MUSCLE).build()
    robot.control("push", 3)
    robot.world.step(0.002, steps=20)
    for copy in (robot.world.clone(), pickle.loads(pickle.dumps(robot.world))):
        twin = copy.robots[0]
        saved = robot.world.save()
        for world in (robot.world, copy):
            world.step(0.002, steps=20)
        assert twin.positions.tobytes() == robot.positions.tobytes()
        robot.world.load(saved)


def test_sensors_come_by_name_once_a_step_has_measured_them():
    robot = epode.robot.from_text(MUSCLE).build()
    assert list(robot.sensors) == ["place"]
    robot.world.step(0.002, steps=2)
    assert list(robot.sensors) == ["felt", "turning", "place"] and robot.sensors["place"] == pytest.approx(robot.positions)


def test_force_sensors_of_the_file_need_no_further_word():
    model = epode.robot.from_text("""<mujoco><worldbody><body name="post"><joint name="j" type="slide" axis="0 0 1" stiffness="1e4" damping="400"/>
        <geom size="0.1" mass="2"/><site name="foot"/></body></worldbody><sensor><force name="f" site="foot"/></sensor></mujoco>""")
    robot = model.build()
    robot.world.step(0.002, steps=1000)
    assert abs(robot.sensor("f")[2]) == pytest.approx(0, abs=20) and np.isfinite(robot.sensor("f")).all()


def test_many_robots_answer_as_each_of_them():
    model = epode.robot.from_text(CRATE)
    robots = epode.robot.Robots([model.build() for _ in range(3)])
    for i, robot in enumerate(robots):
        robot.positions = (0, 0, 0.1 + 0.5 * (i == 2), 1, 0, 0, 0)
    robots.step(0.002, steps=100)
    touch = robots.touch("crate")
    assert touch.points.tolist() == [4, 4, 0] and touch.force.shape == (3, 3) and touch.normal_force[0] == pytest.approx(19.62, rel=1e-3)
    assert [len(one) for one in robots.contacts()] == [4, 4, 0]
    assert robots.poses.shape == (3, 2, 7) and robots.pose("crate")[0].shape == (3, 3)
    assert robots.poses[1] == pytest.approx(robots[1].poses)
    assert robots.jacobians("crate").shape == (3, 6, 6) and robots.forces.shape == (3, 6)
    assert robots.rays("crate", [[0, 0, -1]])[:, 0] == pytest.approx(robots.positions[:, 2])
    assert robots.controls.shape == (3, 0) and robots.sensors == {}


def test_robots_begin_again_at_rest():
    model = epode.robot.from_text(MUSCLE.replace("</mujoco>", "<keyframe><key name='low' qpos='-0.3'/></keyframe></mujoco>"))
    robots = epode.robot.Robots([model.build(), model.build()])
    robots.controls = [3]
    robots.step(0.002, steps=50)
    moved = robots.positions
    robots.reset([False, True])
    assert robots.positions.tolist() == [moved[0].tolist(), [-0.3]] and robots.velocities[1] == 0 and robots.controls.tolist() == [[3], [0]]
    robots[0].reset([0.2])
    assert robots.positions[0] == 0.2 and robots[0].activations == 0
    robots[0].reset("low")
    assert robots.positions[0] == -0.3
    for wrong, kind in (("high", KeyError), ([1, 2], ValueError)):
        with pytest.raises(kind):
            robots[0].reset(wrong)
    with pytest.raises(ValueError, match="mask of 2"):
        robots.reset([True])


def test_a_notebook_shows_a_picture_and_tables():
    robot = epode.robot.from_text(MUSCLE).build()
    robot.control("push", 3)
    page = robot._repr_html_()
    assert "<td>down</td><td>slide</td><td>0</td>" in page and "<td>push</td>" in page and "<td>3</td>" in page
    try:
        robot.world.picture()
    except (RuntimeError, OSError):
        return  # a build without pictures
    assert "data:image/png;base64," in page
    robot.destroy()
    assert "destroyed" in robot._repr_html_()


def test_they_go_by_their_short_names():
    assert epode.Robot is epode.robot.Robot and epode.Robots is epode.robot.Robots and epode.Model is epode.robot.Model


def test_the_time_of_a_step_is_the_files():
    text = "<mujoco>{}<worldbody><body><joint/><geom size='.1'/></body></worldbody></mujoco>"
    said, silent = (epode.robot.from_text(text.format(option)) for option in ("<option timestep='0.01'/>", ""))
    assert said.stepsize == 0.01 and silent.stepsize is None
    assert epode.robot.from_text(said.text("mjcf")[0]).stepsize == 0.01
    assert epode.Batch(said, 1).stepsize == 0.01 and epode.Batch(silent, 1).stepsize == 0.002
    assert epode.Batch(said, 1, stepsize=0.005).stepsize == 0.005


def test_a_world_that_build_makes_has_the_defaults_of_robots():
    built = epode.robot.from_text(CRATE).build().world
    wanted = epode.World(defaults="robot")
    for name in ("stepper", "friction_cone", "exact_rotation", "erp", "cfm"):
        assert getattr(built, name) == getattr(wanted, name), name


def test_a_hinge_counts_its_turns_with_stops_and_without():
    """A motor turns a free hinge by 20 rad/s for a second, through stops that are taken away half way."""
    robot = epode.robot.from_text("""<mujoco><option gravity="0 0 0"/><worldbody><body><joint name="j" range="-100 100"/>
        <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody><compiler angle="radian"/></mujoco>""").build()
    joint = robot.joint("j")
    joint.motor(20, 1e6)
    robot.world.step(0.001, steps=500)
    joint.stops = None
    robot.world.step(0.001, steps=500)
    assert robot.positions == pytest.approx([20], abs=0.03)
    assert joint.position() == pytest.approx(robot.positions[0])


@pytest.mark.parametrize("preset", ["robot", "game"])
def test_the_first_step_accelerates_as_the_equation_of_motion_says(preset):
    """Velocities that the program sets are those of the next step, gyroscopic and centrifugal parts too: nothing lags."""
    model = epode.robot.from_text("""<mujoco><option gravity='0 0 0'/><worldbody><body><freejoint/><inertial pos='0 0 0' mass='3' diaginertia='.1 .2 .15'/>
<body><joint axis='0 0 1'/><inertial pos='.2 0 0' mass='2' diaginertia='.01 .02 .025'/><body pos='.4 0 0'><joint axis='0 1 0'/>
<inertial pos='.1 0 .05' mass='1' diaginertia='.01 .012 .015'/></body></body></body></worldbody></mujoco>""")
    h = 1e-4
    robot = model.build(epode.World(gravity=(0, 0, 0), defaults=preset))
    robot.positions = [0, 0, 0, 1, 0, 0, 0, 0.3, 0.5]
    robot.velocities = [1, -2, 3, 2, -3, 1, 4, -3]
    for _ in range(3):
        q, v = robot.positions, robot.velocities
        wanted = -np.linalg.solve(model.mass_matrix(q), model.inverse_dynamics(q, v))
        robot.world.step(h)
        np.testing.assert_allclose((robot.velocities - v) / h, wanted, atol=2e-3 * np.abs(wanted).max())


def test_arrays_of_many_are_the_rows_of_each():
    model = epode.robot.from_text(TREE.replace("</mujoco>", "<actuator><motor joint='slide'/><motor joint='turn'/></actuator></mujoco>"))
    robots = epode.robot.Robots(model.build() for _ in range(3))
    robots.controls = np.linspace(-0.4, 0.4, 3 * len(model.actuators)).reshape(3, -1)
    robots.step(0.002, steps=20)
    for many, name in ((robots.controls, "controls"), (robots.positions, "positions"), (robots.velocities, "velocities"),
                       (robots.forces, "drive_forces"), (robots.poses, "poses")):
        assert np.array_equal(many, [getattr(robot, name) for robot in robots])
    assert robots.poses.shape == (3, len(model.links), 7) and np.array_equal(robots[1].poses[2], np.concatenate(robots[1].pose(model.link_names[2])))


def test_what_a_robot_does_not_have_is_empty():
    model = epode.robot.from_text(CRATE)
    robot = model.build()
    constraints, tendons = model.constraints(robot.positions)[0], model.tendons(robot.positions)[0]
    for array in (robot.controls, robot.activations, robot.actuator_forces, constraints, tendons):
        assert array.shape == (0,)
    robots = epode.robot.Robots([robot, model.build()])
    assert robots.controls.shape == (2, 0) and robots.forces.shape == robots.velocities.shape == (2, 6)
