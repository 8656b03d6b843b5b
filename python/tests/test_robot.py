# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Robots from files as a user of Python meets them."""
import gc
import pathlib
import warnings

import numpy as np
import pytest

import epode

ROOT = pathlib.Path(__file__).resolve().parent.parent.parent
DEMOS, MODELS = ROOT / "demos/robots", ROOT / "tests/robots/models"


@pytest.fixture(scope="module")
def arm():
    return epode.load(DEMOS / "arm.urdf")


@pytest.fixture(scope="module")
def walker():
    return epode.load(MODELS / "walker.xml")


def test_a_model_reports_what_is_in_it(arm):
    assert arm.format == "URDF" and arm.name == "arm"
    assert arm.joint_names == [f"axis_{i}" for i in range(1, 8)]
    assert "hand" in arm.link_names and "pen" not in arm.link_names and "pen" in arm.frame_names
    assert arm.position_count == arm.velocity_count == 7
    assert arm.links[arm.joints[0].link].mass == pytest.approx(3)
    assert arm.low[0] == -2.9 and arm.high[6] == 3
    assert [a.kind for a in arm.actuators] == ["motor"] * 7


def test_a_report_is_a_list(walker):
    assert {note.kind for note in walker.report} <= {"changed", "approximated", "ignored"}
    text = "<mujoco><worldbody><body>\n<geom size='0.1' solref='0.01 1'/></body></worldbody></mujoco>"
    with pytest.raises(epode.RefusedError, match="solref"):
        epode.robot.from_text(text, strict=True)
    (note,) = epode.robot.from_text(text).report
    assert note.kind == "approximated" and note.line == 2 and note.file == "robot.xml" and "solref" in note.text
    assert any(note.kind == "error" for note in epode.robot.check("nowhere.urdf"))
    with pytest.raises(epode.RefusedError, match="nowhere"):
        epode.load("nowhere.urdf")
    with pytest.raises(TypeError):
        epode.load(DEMOS / "arm.urdf", colour="red")


def test_a_jacobian_is_the_derivative_of_the_pose(arm):
    q, point, step = np.linspace(-0.5, 0.7, 7), (0.1, 0.02, -0.03), 1e-6
    jacobian = arm.jacobian("pen", q, point)
    for i in range(7):
        d = np.zeros(7)
        d[i] = step
        ends = []
        for at in (q + d, q - d):
            place, turn = arm.pose("pen", at)
            ends.append(epode.robot._moved(np.concatenate([place, turn]), point))
        assert jacobian[:3, i] == pytest.approx((ends[0] - ends[1]) / (2 * step), abs=1e-8)


def test_mass_matrix_and_inverse_dynamics_agree(arm):
    rng = np.random.default_rng(1)
    q, v, a = rng.normal(size=(3, 7)) * 0.5
    m = arm.mass_matrix(q)
    assert m == pytest.approx(m.T) and np.linalg.eigvalsh(m)[0] > 0
    assert arm.inverse_dynamics(q, v, a) == pytest.approx(m @ a + arm.inverse_dynamics(q, v), abs=1e-9)
    assert arm.inverse_dynamics(q) == pytest.approx(arm.gravity_forces(q))


def test_inverse_kinematics_finds_what_forward_kinematics_reaches(arm):
    rng = np.random.default_rng(2)
    for _ in range(20):
        place, turn = arm.pose("pen", rng.uniform(arm.low, arm.high))
        found = arm.ik("pen", place, turn)
        assert found.reached and found.residual < 1e-9
        assert np.all(found.positions >= arm.low) and np.all(found.positions <= arm.high)
        assert arm.pose("pen", found.positions)[0] == pytest.approx(place, abs=1e-9)
    far = arm.ik("pen", (3, 0, 0))
    assert not far.reached and far.position_error > 1
    both = arm.ik([epode.robot.Target("pen", (0.4, 0.1, 0.5)), epode.robot.Target("hand", quaternion=(0, 1, 0, 0))],
                  weights=[1, 1, 0, 1, 1, 1, 1])
    assert both.reached and both.positions[2] == 0


def test_motors_with_the_gravity_forces_hold_an_arm(arm):
    robot = arm.build(start=[0.3, 0.6, 0.1, 0.9, -0.2, 0.4, 0])
    before = robot.positions
    robot.controls = arm.gravity_forces(before)
    robot.world.step(0.002, steps=500)
    assert robot.positions == pytest.approx(before, abs=1e-5)
    place, turn = robot.pose("pen")
    expected = arm.pose("pen", robot.positions)
    assert place == pytest.approx(expected[0], abs=1e-9) and abs(turn @ expected[1]) == pytest.approx(1)


def test_positions_and_velocities_of_every_kind_of_joint_come_back(walker):
    with epode.World(gravity=(0, 0, 0)) as world:
        robot = walker.build(world, position=(0, 0, 2), start="up")
        assert robot.positions == pytest.approx(walker.starts["up"])
        robot.velocities = np.linspace(-1, 1, walker.velocity_count)
        assert robot.velocities == pytest.approx(np.linspace(-1, 1, walker.velocity_count))
        assert robot.body("foot") is robot.body("foot") and robot.body("knee_site") is robot.body("thigh")
        assert robot.joint("hip").type == "hinge" and robot.joint("ball") is None
        assert len(world.bodies) == len(robot.bodies) == len(world.bodies.position)
        assert {world.geom_of(g._key) for g in robot.geoms} == set(robot.geoms)
        robot.control("hip_motor", 5)
        assert robot.controls[0] == 1


def test_a_robot_goes_with_its_world_and_leaves_nothing_when_destroyed(walker):
    world = epode.World()
    first, second = walker.build(world), walker.build(world, position=(5, 0, 0))
    first.destroy()
    assert not first.alive and len(world.bodies) == len(second.bodies)
    with pytest.raises(epode.DeadHandleError):
        first.positions
    world.step(0.01, steps=10)
    world.destroy()
    assert not second.alive
    with pytest.raises(epode.DeadHandleError):
        second.positions = walker.reference
    del first, second
    gc.collect()
    mesh = epode.load(MODELS / "arm.urdf", meshes_as_triangles=True).build()  # the world keeps the robot's arrays
    world = mesh.world
    del mesh
    gc.collect()
    world.step(0.01, steps=10)


def test_sensors_read_closed_forms():
    model = epode.robot.from_text("""<mujoco><worldbody><geom type='plane' size='5 5 1'/>
        <body name='box' pos='0 0 0.1'><freejoint/><geom type='box' size='0.1 0.1 0.1' mass='2'/><site name='imu' pos='0 0 0.1'/></body>
        <body name='rod' pos='2 0 2'><joint name='hinge' axis='0 1 0'/><inertial pos='0 0 -0.3' mass='1' diaginertia='0.1 0.1 0.1'/>
        </body></worldbody><sensor><accelerometer name='a' site='imu'/><touch name='t' site='imu'/></sensor></mujoco>""")
    robot = model.build()
    robot.watch_force("rod")
    for _ in range(100):
        robot.world.step(0.005)
        robot.update_sensors(0.005)
    force, rate = robot.imu("imu")
    assert force == pytest.approx([0, 0, 9.81], abs=1e-3) and rate == pytest.approx([0, 0, 0], abs=1e-3)
    assert robot.sensor("a") == pytest.approx(force) and robot.sensor("t") == pytest.approx([19.62], abs=1e-2)
    assert robot.touch("box").force == pytest.approx([0, 0, 19.62], abs=1e-2)
    assert robot.force_torque("rod")[0] == pytest.approx([0, 0, -9.81], abs=1e-3)
    ranges = robot.rays("box", [[0, 0, -1], [0, 0, 1], [1, 0, -0.1]])
    assert ranges == pytest.approx([0.1, np.inf, 0.1 * np.hypot(1, 0.1) / 0.1], abs=2e-3)
    picture = robot.picture("rod", 32, 24, pose=(0, 0, 0, 1, 0, 0, 0))
    assert picture.color.shape == (24, 32, 3) and picture.depth == pytest.approx(np.full((24, 32), 2.0))
    assert robot.world.geom_of(picture.geoms[0, 0]) in robot.geoms
    with pytest.raises(KeyError, match="nobody"):
        robot.sensor("nobody")


def test_a_medium_and_a_height_field():
    model = epode.robot.from_text("""<mujoco><option density='1000'/>
        <asset><hfield name='h' size='2 2 1 0.1' nrow='2' ncol='3' elevation='1 0 1 1 0 1'/></asset>
        <worldbody><geom type='hfield' hfield='h' pos='0 0 -10'/>
        <body name='stone'><freejoint/><geom type='box' size='0.3 0.2 0.1' mass='100'/></body></worldbody></mujoco>""")
    drag = 2 * 1000 * 0.3 * 0.2
    velocities = np.array([0, 0, -2.0, 0, 0, 0])
    assert model.fluid_forces(model.reference, velocities) == pytest.approx([0, 0, 4 * drag, 0, 0, 0])
    robot = model.build()
    for _ in range(600):
        assert robot.add_fluid_forces(0.005) == 1
        robot.world.step(0.005)
    assert robot.velocities[2] == pytest.approx(-np.sqrt(100 * 9.81 / drag), rel=1e-6)
    assert robot.rays("stone", [[0, 0, -1]])[0] == pytest.approx(robot.positions[2] + 10, abs=1e-6)
    with pytest.raises(ValueError, match="step size"):
        robot.add_fluid_forces(-1)


def test_a_string_over_a_ball_and_a_filter():
    model = epode.robot.from_text("""<mujoco><worldbody><site name='top' pos='-0.5 0 1'/><geom name='ball' size='0.1' pos='0 0 0.7'/>
        <body><joint name='down' type='slide' axis='0 0 -1'/><geom size='0.05' mass='2'/><site name='hook'/></body></worldbody>
        <tendon><spatial name='string' stiffness='500' damping='20'><site site='top'/><geom geom='ball'/><site site='hook'/></spatial></tendon>
        <actuator><general name='winch' tendon='string' gear='-1' dyntype='filterexact' dynprm='0.1' ctrlrange='0 50'/></actuator></mujoco>""")
    assert model.tendon_names == ["string"]
    lengths, moments = model.tendons([0.2])
    high, low = (model.tendons([0.2 + d])[0][0] for d in (1e-6, -1e-6))
    assert moments.shape == (1, 1) and moments[0, 0] == pytest.approx((high - low) / 2e-6, abs=1e-8)
    robot = model.build()
    robot.control("winch", 80)
    for _ in range(1000):
        assert robot.add_forces(0.005) == 2
        robot.world.step(0.005)
    assert robot.activations == pytest.approx([50])
    lengths, moments = model.tendons(robot.positions)
    rest = model.tendons([0])[0][0]
    assert moments[0, 0] * (500 * (lengths[0] - rest) + 50) == pytest.approx(2 * 9.81, rel=1e-6)
    robot.activations = [7]
    assert robot.activations == pytest.approx([7])
    with pytest.raises(ValueError, match="1 activations expected"):
        robot.activations = [1, 2]
    with pytest.raises(ValueError, match="step size"):
        robot.add_forces(0)


def test_history_takes_robots_back(arm):
    world = epode.World()
    world.history = 10
    robot = arm.build(world)
    world.step(0.01, steps=3)
    robot.destroy()
    world.step(0.01, steps=2)
    world.roll_back(3)
    assert robot.alive and len(world.bodies) == len(robot.bodies)
    later = arm.build(world)
    world.step(0.01)
    world.roll_back(1)
    assert not later.alive
    with pytest.raises(epode.DeadHandleError):
        later.positions
    assert np.all(np.isfinite(robot.positions))


def test_many_worlds_of_one_model_have_the_same_bits(walker):
    robots = [walker.build() for _ in range(20)]
    epode.step_worlds([r.world for r in robots], 0.002, stepper="exact", steps=20)
    assert len({r.positions.tobytes() for r in robots}) == 1


@pytest.mark.parametrize("ending", ["urdf", "xml"])
def test_a_model_is_written_and_read_again(arm, walker, tmp_path, ending):
    path = tmp_path / f"again.{ending}"
    lost = arm.save(path)
    assert any(("capsules" if ending == "urdf" else "limits of velocities") in sentence for sentence in lost)
    again = epode.load(path)
    assert again.joint_names == arm.joint_names and again.format == ("URDF" if ending == "urdf" else "MJCF")
    q, v, a = np.random.default_rng(4).normal(size=(3, 7)) * 0.4
    assert again.mass_matrix(q) == pytest.approx(arm.mass_matrix(q), abs=1e-12)
    assert again.inverse_dynamics(q, v, a) == pytest.approx(arm.inverse_dynamics(q, v, a), abs=1e-10)
    text, lost = walker.text("mjcf" if ending == "xml" else "urdf", MODELS)
    assert text.startswith("<") and all(isinstance(sentence, str) for sentence in lost)
    if ending == "xml":
        assert epode.robot.from_text(text, MODELS / "x.xml").mass_matrix(walker.reference) == pytest.approx(
            walker.mass_matrix(walker.reference), abs=1e-12)


def test_what_cannot_be_written_is_refused(arm, tmp_path):
    for path in (tmp_path / "arm.sdf", tmp_path / "nowhere" / "arm.urdf"):
        with pytest.raises(epode.RefusedError, match="arm"):
            arm.save(path)
        assert not path.exists()
    with pytest.raises(ValueError, match="sdf"):
        arm.text("sdf")


def test_sdf_is_read_or_refused_with_what_to_do():
    try:
        model = epode.load(MODELS / "geared.sdf")
    except epode.RefusedError as error:
        assert "EPODE_SDF" in str(error)
    else:
        assert model.format == "SDF" and model.build().world.bodies


def test_many_robots_are_arrays(walker):
    robots = epode.robot.Robots(walker.build(start="up") for _ in range(6))
    assert len(robots.worlds) == len(robots) == 6
    np.testing.assert_array_equal(robots.positions, [robot.positions for robot in robots])
    wanted = robots.positions
    wanted[:, 0] += np.arange(6)
    robots.positions = wanted
    robots.velocities = np.linspace(-1, 1, walker.velocity_count)
    assert robots[5].positions == pytest.approx(wanted[5]) and robots[2].velocities == pytest.approx(robots[0].velocities)
    robots.control(np.full((6, len(walker.actuators)), 5.0))
    assert robots[3].controls.tolist() == robots[0].controls.tolist() and robots[3].controls[0] == 1
    before = robots.positions
    bad = before + 1
    bad[4, 0] = np.nan
    for act in (lambda: setattr(robots, "positions", bad), lambda: setattr(robots, "positions", before[:, 1:]), lambda: robots.control([0, 1, 2] * 9)):
        with pytest.raises(ValueError):
            act()
    np.testing.assert_array_equal(robots.positions, before)
    with pytest.raises(ValueError, match="one model"):
        epode.robot.Robots([robots[0], epode.load(MODELS / "walker.xml").build()])
    with pytest.raises(ValueError, match="at least one"):
        epode.robot.Robots([])
    robots[1].world.destroy()
    with pytest.raises(epode.DeadHandleError):
        robots.positions


def test_bad_arguments_are_named(arm):
    robot = arm.build()
    for call in (lambda: arm.fk([1, 2]), lambda: arm.fk([np.nan] * 7), lambda: setattr(robot, "positions", [0] * 6),
                 lambda: setattr(robot, "controls", [0]), lambda: arm.ik("pen", (0, 0, 0), max_starts=0),
                 lambda: arm.ik("pen", (0, 0, 0), weights=[-1] * 7), lambda: robot.target("axis_1", 0, stiffness=-1, damping=0)):
        with pytest.raises(ValueError):
            call()
    for call in (lambda: arm.pose("nobody", arm.reference), lambda: robot.control("nobody", 1), lambda: robot.joint("nobody")):
        with pytest.raises(KeyError, match="nobody"):
            call()


def test_the_examples_in_the_texts_hold():
    import doctest
    assert doctest.testmod(epode.robot).failed == 0


MOTOR = """<mujoco><option gravity='0 0 0'/><worldbody><body><joint name='j' {}/><geom type='capsule' fromto='0 0 0 0 0 1' size='.02'/>
<body pos='0 0 1'><joint name='k' axis='0 1 0'/><geom size='.1'/></body></body></worldbody><actuator><motor joint='j'/></actuator></mujoco>"""


@pytest.mark.parametrize("joint", ["axis='0 1 0'", "type='slide' axis='1 0 0'", "type='slide' axis='1 0 0' range='-1 1'"])
@pytest.mark.parametrize("defaults", ["ode", "game", "robot"])
def test_states_have_the_controls_and_targets_of_robots(joint, defaults):
    model = epode.robot.from_text(MOTOR.format(joint))
    for before, after in ((None, 1.0), (0.0, 1.0), (1.0, 0.0), (1.0, 2.0)):
        robot = model.build(epode.World(gravity=model.gravity, defaults=defaults))
        world = robot.world
        if before is not None:
            robot.controls = [before]
        state = world.save()
        world.step(0.01, steps=5)
        expected = robot.velocities
        robot.controls = [after]
        robot.target("k", 1.0, stiffness=10, damping=1)
        world.step(0.01)
        world.load(state)
        assert robot.controls.tolist() == [before or 0.0]
        world.step(0.01, steps=5)
        assert robot.velocities.tolist() == expected.tolist()
        base = world.save()
        robot.controls = [3.0]
        changes = world.save_changes(base)
        world.load(base)
        assert robot.controls.tolist() == [before or 0.0]
        world.load_changes(base, changes)
        assert robot.controls.tolist() == [3.0]


URDF_ARM = """<robot name="arm"><link name="world"/>
<link name="upper"><inertial><origin xyz="0.2 0 0"/><mass value="2"/><inertia ixx=".01" iyy=".03" izz=".03" ixy="0" ixz="0" iyz="0"/></inertial></link>
<link name="fore"><inertial><origin xyz="0.2 0 0"/><mass value="1"/><inertia ixx=".01" iyy=".02" izz=".02" ixy="0" ixz="0" iyz="0"/></inertial></link>
<joint name="shoulder" type="revolute"><parent link="world"/><child link="upper"/><origin xyz="0 0 1"/><axis xyz="0 1 0"/>
<limit effort="30" velocity="9" lower="-3" upper="3"/></joint>
<joint name="elbow" type="continuous"><parent link="upper"/><child link="fore"/><origin xyz="0.4 0 0"/><axis xyz="0 1 0"/></joint></robot>"""


def test_a_urdf_without_transmissions_has_a_motor_on_each_joint():
    """Most files have none; their joints are moved all the same, by forces within the joint's effort."""
    model = epode.robot.from_text(URDF_ARM, "arm.urdf")
    assert [its.name for its in model.actuators] == ["shoulder", "elbow"] and model.actuators[0].kind == "motor"
    robot = model.build(start=[0.3, 0.4])
    robot.controls = model.gravity_forces(robot.positions)
    robot.world.step(0.002, steps=100)
    np.testing.assert_allclose(robot.positions, [0.3, 0.4], atol=1e-3)
    robot = model.build(epode.World(gravity=(0, 0, 0)))
    robot.control("shoulder", 1000)  # no more than its effort
    robot.world.step(0.001)
    np.testing.assert_allclose(robot.velocities, np.linalg.solve(model.mass_matrix([0, 0]), [30, 0]) * 0.001, rtol=0.02)


def test_a_servo_within_a_force_limit_works_against_friction():
    """From 1.16 rad 100 N m pull against 60 N m of friction; near the target friction holds what is pulled by less than that."""
    text = ("<mujoco><option gravity='0 0 0'/><worldbody><body><joint name='j' axis='0 1 0' frictionloss='60'/><geom type='sphere' size='.1' pos='.3 0 0' "
            "mass='3'/></body></worldbody><actuator><position joint='j' kp='800' forcerange='-100 100'/></actuator></mujoco>")
    model = epode.robot.from_text(text)
    inertia, h = model.mass_matrix([0.0])[0, 0], 1e-4
    robot = model.build(epode.World(gravity=(0, 0, 0), defaults="robot"), start=[1.16])
    robot.controls = [0.0]
    for t in (0.05, 0.1):
        robot.world.step(h, steps=500)
        assert robot.velocities[0] == pytest.approx(-40 / inertia * t, rel=1e-6)
        assert robot.positions[0] == pytest.approx(1.16 - 20 / inertia * t * t, abs=1e-3)
    robot.world.step(h, steps=2500)
    assert abs(800 * robot.positions[0]) <= 60 and robot.velocities[0] == pytest.approx(0, abs=1e-9)


def test_steps_taken_back_take_controls_back():
    robot = epode.robot.from_text(MOTOR.format("axis='0 1 0'")).build()
    world = robot.world
    world.history = 10
    robot.controls = [1.0]
    world.step(0.01)
    robot.controls = [2.0]
    world.step(0.01)
    world.roll_back(1)
    assert robot.controls.tolist() == [1.0]
    world.roll_back(1)
    assert robot.controls.tolist() == [0.0]


def test_states_of_other_robots_are_refused_and_those_without_leave_controls():
    model = epode.robot.from_text(MOTOR.format("axis='0 1 0'"))
    robot = model.build()
    robot.controls = [1.0]
    state = robot.world.save()
    model.build(robot.world, position=(5, 0, 0))
    with pytest.raises(epode.RefusedError, match="1 robots"):
        robot.world.load(state)
    for damaged in (state[:-20] + state[-12:], state[:-12] + b"\xff\xff\xff\xff" + state[-8:], b"EPROBOTS"):
        with pytest.raises(epode.RefusedError):
            robot.world.load(damaged)
    assert robot.controls.tolist() == [1.0]
    of_library = epode.c.dWorldGetState(robot.world._handle)
    robot.controls = [0.5]
    robot.world.load(of_library)
    assert robot.controls.tolist() == [0.5]


def test_a_clone_of_a_world_with_robots_can_be_destroyed_and_saved():
    robot = epode.robot.from_text(MOTOR.format("axis='0 1 0'")).build()
    twin = robot.world.clone()
    assert twin.save() == robot.world.save()
    twin.destroy()


def test_a_controller_that_diverges_warns_once_and_steps_go_on():
    robot = epode.robot.from_text("""<mujoco><worldbody><body><joint name='j' axis='0 1 0'/><geom type='capsule' fromto='0 0 0 0 0 1'
        size='.02'/></body></worldbody><actuator><motor joint='j'/></actuator></mujoco>""").build()
    robot.velocities = [0.1]
    warned = []
    for step in range(60):
        with warnings.catch_warnings(record=True) as seen:
            warnings.simplefilter("always")
            robot.controls = -3000 * robot.velocities
            robot.world.step(0.002)
        warned += [(step, str(one.message)) for one in seen]
    assert len(warned) == 1 and "body 0 (of" in warned[0][1] and np.abs(robot.velocities).max() > 1e20
