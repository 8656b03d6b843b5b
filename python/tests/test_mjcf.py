# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Elements of MJCF against MuJoCo, which is the judge where it is installed; and what a roboticist pickles, clones and loads."""
import pickle

import numpy as np
import pytest

import epode


def judge():
    return pytest.importorskip("mujoco")


def angle(q):
    return 2 * np.arccos(min(1, abs(q[0])))


BALL = ("<mujoco><compiler angle='radian'/><worldbody><body pos='0 0 1'><joint type='ball' {joint}/>"
        "<geom type='capsule' size='.02' fromto='0 0 0 .5 0 0' mass='1'/></body></worldbody>{more}</mujoco>")


@pytest.mark.parametrize("preset", ["ode", "robot", "game"])
def test_a_ball_stops_at_its_limit_in_all_directions(preset):
    for axis in ((0, 1, 0), (1, 2, 0.5), (-1, 0.3, -1)):
        robot = epode.robot.from_text(BALL.format(joint="range='0 .5'", more="")).build(epode.World(gravity=(0, 0, 0), defaults=preset))
        robot.velocities = 2 * np.asarray(axis) / np.linalg.norm(axis)
        angles = []
        for _ in range(250):
            robot.world.step(0.002)
            angles.append(angle(robot.positions))
        assert max(angles) == pytest.approx(0.5, abs=0.01)


def test_a_ball_under_gravity_hangs_at_its_limit_where_mujocos_does():
    mujoco = judge()
    text = BALL.format(joint="range='0 .5' damping='.05'", more="")
    robot = epode.robot.from_text(text).build()
    robot.world.step(0.002, steps=1000)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    for _ in range(1000):
        mujoco.mj_step(model, data)
    assert angle(robot.positions) == pytest.approx(0.5, abs=1e-3)
    assert angle(robot.positions) == pytest.approx(angle(data.qpos), abs=0.08)  # whose limit is soft


def test_drives_of_a_ball_move_it_as_mujocos():
    mujoco = judge()
    text = BALL.format(joint="name='b' stiffness='3' damping='.2' armature='.05'",
                       more="<actuator><motor joint='b' gear='.3 -.2 .4'/><position joint='b' kp='2' gear='0 1 0'/></actuator>")
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.timestep = 1e-4
    data = mujoco.MjData(model)
    data.ctrl[:] = 1.5, -0.2
    robot = epode.robot.from_text(text).build(epode.World(gravity=(0, 0, -9.81), defaults="robot"))
    robot.controls = data.ctrl
    for _ in range(5):
        robot.world.step(1e-4, steps=1000)
        for _ in range(1000):
            mujoco.mj_step(model, data)
        np.testing.assert_allclose(robot.positions, data.qpos, atol=2e-3)


def exclusion(excluded):
    return ("<mujoco><option gravity='0 0 0'/><worldbody><geom type='box' size='.2 .2 .01' pos='.15 0 -.055'/>"
            "<body name='base'><body name='torso'><geom type='box' size='.2 .2 .2'/></body></body>"
            "<body name='arm' pos='.15 0 0'><freejoint/><geom type='capsule' size='.05' fromto='0 0 0 .3 0 0' mass='1'/></body>"
            f"</worldbody><contact>{excluded}</contact></mujoco>")


@pytest.mark.parametrize("excluded", ["", "<exclude body1='arm' body2='torso'/>", "<exclude body1='world' body2='arm'/>",
                                      "<exclude body1='arm' body2='torso'/><exclude body1='arm' body2='world'/>"])
def test_what_an_exclusion_fixed_to_the_world_names_does_not_touch_and_all_else_does(excluded):
    mujoco = judge()
    text = exclusion(excluded)
    model = mujoco.MjModel.from_xml_string(text)
    data = mujoco.MjData(model)
    mujoco.mj_step(model, data)
    touching = {int(max(c.geom)) == 2 and int(min(c.geom)) for c in data.contact}
    robot = epode.robot.from_text(text).build(epode.World(gravity=(0, 0, 0)))
    robot.world.step(0.002)
    found = {min(robot.geoms.index(robot.world.geom_of(c[end])) for end in ("g1", "g2")) for c in robot.world.contacts}
    assert found == touching


@pytest.mark.parametrize("text, words", [
    ("<mujoco><worldbody>\n<body><freejoint/><geom sizze='.3' size='.1'/></body></worldbody></mujoco>", [":2:", "sizze", "'size'"]),
    ("<mujoco><worldbody><body><joint dampinng='5'/><geom size='.1'/></body></worldbody></mujoco>", ["dampinng", "'damping'"]),
    ("<mujoco><worldbody><body><jiont/><geom size='.1'/></body></worldbody></mujoco>", ["<jiont>", "'joint'"]),
    ("<mujoco><worldbodie/></mujoco>", ["<worldbodie>", "'worldbody'"]),
    ("<mujoco><worldbody><body><joint name='j'/><geom size='.1'/><body>\n<joint name='j'/><geom size='.1'/></body></body></worldbody></mujoco>",
     [":2:", "'j'", "joint"]),
    ("<mujoco><worldbody><body name='a'><freejoint/><geom size='.1'/></body><body name='a'><freejoint/><geom size='.1'/></body></worldbody>"
     "</mujoco>", ["'a'", "body"]),
    ("<mujoco><default><geom siz='1'/></default><worldbody/></mujoco>", ["siz", "'size'"]),
    ("<mujoco><worldbody/><actuator><motor joint='j' geer='1'/></actuator></mujoco>", ["geer", "'gear'"])])
def test_words_that_are_none_and_names_that_stand_twice_are_errors(text, words):
    with pytest.raises(epode.RefusedError) as error:
        epode.robot.from_text(text)
    assert all(word in str(error.value) for word in words)
    with pytest.raises(ValueError):
        judge().MjModel.from_xml_string(text)


MOCAP = ("<mujoco><worldbody><body name='target' mocap='true' pos='0 0 1'><geom size='.05' contype='0' conaffinity='0'/></body>"
         "<body name='hand' pos='.1 0 1'><freejoint/><geom size='.05'/></body></worldbody>"
         "<equality><weld body1='target' body2='hand'/></equality>"
         "<keyframe><key name='there' qpos='1.1 0 1 1 0 0 0' mpos='1 0 1'/></keyframe></mujoco>")


@pytest.mark.parametrize("preset", ["ode", "robot", "game"])
def test_a_hand_that_is_welded_to_a_mocap_body_stands_and_follows(preset):
    model = epode.robot.from_text(MOCAP)
    assert model.mocap_names == ["target"] and not [n for n in model.report if n.kind == "ignored"]
    robot = model.build(epode.World(defaults=preset), start=model.reference)
    before = robot.positions
    robot.world.step(0.002, steps=100)
    np.testing.assert_allclose(robot.positions, before, atol=1e-5)
    robot.mocap["target"] = (0.2, 0.1, 1.3), None
    robot.world.step(0.002, steps=1000)
    np.testing.assert_allclose(robot.mocap["target"][0], (0.2, 0.1, 1.3), atol=1e-12)
    np.testing.assert_allclose(robot.positions[:3], (0.3, 0.1, 1.3), atol=2e-3)
    robot.mocap["target"] = None, (0, 0, 0, 1)  # half a turn about z
    robot.world.step(0.002, steps=2000)
    np.testing.assert_allclose(robot.positions[:3], (0.1, 0.1, 1.3), atol=2e-3)


def test_a_start_pose_has_its_mocap_bodies():
    robot = epode.robot.from_text(MOCAP).build()
    np.testing.assert_array_equal(robot.mocap["target"][0], (1, 0, 1))
    robot.world.step(0.002, steps=100)
    np.testing.assert_allclose(robot.positions[:3], (1.1, 0, 1), atol=1e-5)
    with pytest.raises(KeyError, match="target"):
        robot.mocap["hand"]
    with pytest.raises(ValueError):
        robot.mocap["target"] = (0, 0, 1), (0, 0, 0, 0)


@pytest.mark.parametrize("preset", ["ode", "robot", "game"])
@pytest.mark.parametrize("axis", ["axis='0 1 0'", "type='slide' axis='1 0 0'"])
def test_a_violated_limit_pushes_back_at_a_bounded_speed_at_every_step(preset, axis):
    model = epode.robot.from_text("<mujoco><compiler angle='radian'/><option gravity='0 0 0'/><worldbody><body>"
                                  f"<joint {axis} range='.25 3'/><geom type='capsule' size='.02' fromto='0 0 0 .5 0 0' mass='1'/>"
                                  "</body></worldbody></mujoco>")
    for h in (1e-2, 2e-3, 5e-4, 1e-4):
        robot = model.build(epode.World(gravity=(0, 0, 0), defaults=preset), start=[0.0])
        fastest = 0.0
        for _ in range(int(0.1 / h)):
            robot.world.step(h)
            fastest = max(fastest, abs(robot.velocities[0]))
        assert fastest <= 5.1 and robot.positions[0] > 0.05


def test_models_robots_and_recordings_pickle_and_copies_keep_their_robots():
    text = ("<mujoco><worldbody><geom type='plane' size='1 1 1'/><body pos='0 0 .5'><freejoint/><geom size='.1'/><body pos='.2 0 0'>"
            "<joint name='j' axis='0 1 0'/><geom size='.05'/></body></body></worldbody><actuator><position joint='j' kp='5'/></actuator></mujoco>")
    model = pickle.loads(pickle.dumps(epode.robot.from_text(text)))
    world = epode.World()
    world.body(mass=1, shape=epode.Sphere(0.1), position=(3, 0, 1))
    robot = model.build(world, position=(0, 1, 0))
    robot.controls = [0.4]
    world.step(0.005, steps=20)
    twins = [world.clone().robots[0], pickle.loads(pickle.dumps(world)).robots[0], pickle.loads(pickle.dumps(robot))]
    for twin in twins:
        assert twin.world is not world and twin.alive
        np.testing.assert_array_equal(twin.positions, robot.positions)
        np.testing.assert_array_equal(twin.controls, [0.4])
    for one in (robot, *twins):
        one.controls = [-0.3]
        one.world.step(0.005, steps=50)
    for twin in twins:
        np.testing.assert_array_equal(twin.positions, robot.positions)
    recording = world.record()
    world.step(0.005, steps=10)
    again = pickle.loads(pickle.dumps(recording))
    assert len(again) == len(recording) and again.hash() == recording.hash()


def test_a_file_of_a_world_is_loaded(tmp_path):
    world = epode.World()
    world.plane()
    box = world.body(mass=1, shape=epode.Box(.2, .2, .2), position=(0, 0, 1))
    world.joint("hinge", box, anchor=(0, 0, 1.5), axis=(0, 1, 0))
    world.save_file(tmp_path / "a.epw")
    again = epode.load_world(tmp_path / "a.epw")
    assert [j.type for j in again.joints] == ["hinge"] and len(again.bodies) == 1 and len(again.geoms) == 2
    for one in (world, again):
        one.step(0.01, steps=50)
    np.testing.assert_array_equal(world.bodies.position, again.bodies.position)
    with pytest.raises(epode.RefusedError):
        epode.load_world(tmp_path / "none.epw")


MUSCLES = ("<mujoco><worldbody><body><joint name='j' axis='0 1 0'/><geom type='capsule' size='.02' fromto='0 0 0 .5 0 0' mass='1'/>"
           "<site name='s' pos='.3 0 .03'/></body><site name='t' pos='.1 0 .4'/></worldbody>"
           "<tendon><spatial name='cord'><site site='t'/><site site='s'/></spatial></tendon><actuator>"
           "<muscle name='a' joint='j' lengthrange='-1 1.5' gear='.04' force='300'/>"
           "<muscle name='b' tendon='cord' lengthrange='.2 .6' scale='100'/>"
           "<general name='c' joint='j' gaintype='muscle' biastype='muscle' dyntype='muscle' lengthrange='-2 2' "
           "gainprm='.8 1.1 50 200 .4 1.5 1.4 1.2 1.3' biasprm='.8 1.1 50 200 .4 1.5 1.4 1.2 1.3' dynprm='.02 .05 .1' ctrllimited='true' ctrlrange='0 1'/>"
           "<damper name='d' joint='j' kv='.3' ctrlrange='0 1'/></actuator></mujoco>")


def test_muscles_and_dampers_exert_what_mujocos_do():
    mujoco = judge()
    model = mujoco.MjModel.from_xml_string(MUSCLES)
    data = mujoco.MjData(model)
    robot = epode.robot.from_text(MUSCLES).build()
    random = np.random.default_rng(3)
    for _ in range(200):
        q, v, act, u = random.uniform(-1.5, 2), random.uniform(-3, 3), random.uniform(0, 1, 3), random.uniform(0, 1)
        data.qpos[0], data.qvel[0], data.act[:], data.ctrl[:] = q, v, act, (0, 0, 0, u)
        mujoco.mj_forward(model, data)
        robot.positions, robot.velocities = [q], [v]
        robot.activations = [*act, 0]
        robot.controls = [0, 0, 0, u]
        np.testing.assert_allclose(robot.actuator_forces, data.actuator_force, rtol=1e-9, atol=1e-9)


def test_a_muscles_activation_follows_its_control_as_mujocos():
    mujoco = judge()
    model = mujoco.MjModel.from_xml_string(MUSCLES)
    data = mujoco.MjData(model)
    robot = epode.robot.from_text(MUSCLES).build()
    random = np.random.default_rng(5)
    for _ in range(300):
        data.ctrl[:] = np.append(random.uniform(0, 1, 3), 0)
        robot.controls = data.ctrl
        robot.add_forces(model.opt.timestep)
        mujoco.mj_step(model, data)
        np.testing.assert_allclose(robot.activations[:3], data.act, rtol=0, atol=1e-9)


def test_the_surface_of_priority_says_the_friction():
    def slides(wheel, floor):
        world = epode.World()
        epode.robot.from_text(f"<mujoco><worldbody><geom type='plane' size='9 9 1' friction='{floor}'/>"
                              f"<body pos='0 0 .1'><freejoint/><geom type='box' size='.1 .1 .1' {wheel}/></body></worldbody></mujoco>").build(world)
        robot = world.robots[0]
        robot.velocities = [1, 0, 0, 0, 0, 0]
        world.step(0.005, steps=60)
        return robot.velocities[0]
    assert slides("friction='0.05' priority='1'", 1) == pytest.approx(1 - 9.81 * 0.3 * 0.05, abs=0.01)
    assert slides("friction='0.05'", 1) == pytest.approx(0, abs=1e-3)


def test_a_share_of_gravity_is_taken_off():
    mujoco = judge()
    text = ("<mujoco><worldbody><body gravcomp='.3'><joint axis='0 1 0'/><geom type='capsule' size='.02' fromto='0 0 0 .5 0 0' mass='1'/>"
            "<body pos='.5 0 0' gravcomp='1'><geom size='.05' mass='.4'/></body></body></worldbody></mujoco>")
    model = mujoco.MjModel.from_xml_string(text)
    model.opt.timestep = 1e-3
    data = mujoco.MjData(model)
    robot = epode.robot.from_text(text).build()
    for _ in range(300):
        robot.add_forces(1e-3)
        robot.world.step(1e-3)
        mujoco.mj_step(model, data)
    np.testing.assert_allclose(robot.positions, data.qpos, atol=2e-3)


def test_replicas_are_mujocos():
    mujoco = judge()
    text = ("<mujoco><worldbody><replicate count='3' offset='.5 0 0' euler='0 0 30' sep='-'><body name='b' pos='1 0 0'><joint name='j' axis='0 1 0'/>"
            "<geom name='g' size='.1'/><replicate count='2' euler='0 0 90'><geom size='.05' name='k' pos='.3 0 0'/></replicate></body></replicate>"
            "<body name='c'><freejoint/><replicate count='11' offset='0 .1 0'><geom name='h' size='.01'/></replicate></body></worldbody>"
            "<actuator><motor name='m' joint='j'/></actuator><sensor><jointpos name='q' joint='j'/></sensor></mujoco>")
    theirs = mujoco.MjModel.from_xml_string(text)
    ours = epode.robot.from_text(text)
    assert ours.joint_names == [theirs.joint(i).name for i in range(theirs.njnt)]
    assert ours.actuator_names == [theirs.actuator(i).name for i in range(theirs.nu)]
    assert [s.name for s in ours.sensors] == [theirs.sensor(i).name for i in range(theirs.nsensor)]
    data = mujoco.MjData(theirs)
    data.qpos[:3] = 0.3, -0.5, 0.7
    mujoco.mj_forward(theirs, data)
    full = np.zeros((theirs.nv, theirs.nv))
    mujoco.mj_fullM(theirs, full, data.qM) if hasattr(data, "qM") else mujoco.mj_fullM(theirs, data, full)
    np.testing.assert_allclose(ours.mass_matrix(data.qpos), full, atol=1e-9)


def test_the_table_of_words_is_mujocos():
    mujoco = judge()
    if mujoco.__version__ != "4.0.0":
        pytest.skip("the table is that of MuJoCo 4.0.0")
    import pathlib
    import subprocess
    import sys
    root = pathlib.Path(__file__).parents[2]
    subprocess.run([sys.executable, root / "tools/mjcf_names.py", "--check"], cwd=root, check=True)


HAND = """<mujoco model="hand"><compiler angle="radian"/><default><geom density="500"/><joint damping=".3"/></default><worldbody>
<geom type="box" size=".1 .1 .1" pos="0 0 -.5" mass="0"/><site name="post" pos=".3 0 0"/><body name="palm" pos="0 0 .1"><joint name="wrist" axis="0 1 0" range="-1 1"/>
<geom name="g" size=".1"/><site name="s" pos=".1 0 0"/><camera name="eye" pos=".2 0 0" euler="0 -1.57 0" fovy="60"/>
<body name="tip" pos=".2 0 0" euler="0 0 .3"><joint name="finger" axis="1 1 0"/><geom type="box" size=".05 .02 .03"/></body></body>
<body name="other" pos="0 1 0"><joint name="other" type="slide"/><geom size=".1"/></body></worldbody>
<equality><joint joint1="finger" joint2="wrist" polycoef="0 .5"/><connect body1="palm" body2="other" anchor="0 0 0"/></equality>
<tendon><fixed name="sum"><joint joint="wrist" coef="1"/><joint joint="finger" coef="-2"/></fixed>
<spatial name="cord"><site site="s"/><site site="post"/></spatial></tendon>
<actuator><motor name="wrist" joint="wrist"/><position name="sum" tendon="sum" kp="3"/><motor name="other" joint="other"/></actuator>
<sensor><jointpos name="angle" joint="wrist"/><jointpos name="far" joint="other"/></sensor>
<keyframe><key name="home" qpos=".3 .2 .1" ctrl="1 2 3"/></keyframe></mujoco>"""
ARM = """<mujoco><asset><model name="hand" file="hand.xml"/></asset><worldbody><body name="arm"><joint name="a" axis="0 1 0"/><geom size=".2"/>
<frame pos="1 0 0" euler="0 0 90"><attach model="hand" BODY prefix="l_"/></frame><attach model="hand" BODY prefix="r_"/>
<body name="after"><joint name="z"/><geom size=".1"/></body></body></worldbody>
<actuator><motor name="a" joint="a"/><motor name="its" joint="l_finger" gear="2"/></actuator>
<keyframe><key name="own" qpos="QPOS"/></keyframe></mujoco>"""


@pytest.mark.parametrize("body, count", [("body='palm'", 6), ("body='tip'", 4), ("", 8)])
def test_what_a_file_attaches_of_another_is_where_mujoco_has_it(body, count, tmp_path):
    mujoco = judge()
    (tmp_path / "hand.xml").write_text(HAND)
    text = ARM.replace("BODY", body).replace("QPOS", " ".join(["0"] * count))
    (tmp_path / "arm.xml").write_text(text)
    theirs = mujoco.MjModel.from_xml_path(str(tmp_path / "arm.xml"))
    ours = epode.load(tmp_path / "arm.xml", keep_fixed=True)
    data, random = mujoco.MjData(theirs), np.random.default_rng(4)
    assert ours.link_names[1:] == [theirs.body(i).name for i in range(1, theirs.nbody)]
    assert ours.joint_names == [theirs.joint(i).name for i in range(theirs.njnt)]
    assert ours.actuator_names == [theirs.actuator(i).name for i in range(theirs.nu)]
    assert ours.tendon_names == [theirs.tendon(i).name for i in range(theirs.ntendon)]
    assert [one.name for one in ours.sensors] == [theirs.sensor(i).name for i in range(theirs.nsensor)]
    assert [one.name for one in ours.cameras] == [theirs.camera(i).name for i in range(theirs.ncam)]
    assert list(ours.starts) == [theirs.key(i).name for i in range(theirs.nkey)]
    for i, positions in enumerate(ours.starts.values()):
        np.testing.assert_allclose(positions, theirs.key_qpos[i], atol=1e-14)
    for _ in range(5):
        data.qpos[:], data.qvel[:] = random.normal(size=theirs.nq), random.normal(size=theirs.nv)
        mujoco.mj_forward(theirs, data)
        full = np.zeros((theirs.nv, theirs.nv))
        for row, unit in zip(full, np.eye(theirs.nv)):
            mujoco.mj_mulM(theirs, data, row, unit)
        np.testing.assert_allclose(ours.mass_matrix(data.qpos), full, atol=1e-11)
        np.testing.assert_allclose(ours.inverse_dynamics(data.qpos, data.qvel), data.qfrc_bias, atol=1e-10)
        np.testing.assert_allclose(ours.tendons(data.qpos)[0], data.ten_length, atol=1e-12)
        for camera, place, turn in zip(ours.cameras, data.cam_xpos, data.cam_xmat):
            position, quaternion = ours.fk(data.qpos)[camera.link][:3], ours.fk(data.qpos)[camera.link][3:]
            from epode._poses import _moved, _product
            np.testing.assert_allclose(_moved(np.concatenate([position, quaternion]), camera.frame[:3]), place, atol=1e-12)
            q = _product(quaternion, camera.frame[3:])
            np.testing.assert_allclose(_moved(np.concatenate([np.zeros(3), q]), (0, 0, 1)), turn.reshape(3, 3)[:, 2], atol=1e-9)
            assert camera.field == pytest.approx(np.pi / 3)


@pytest.mark.parametrize("text, words", [
    (ARM.replace("BODY", "body='pal'").replace("QPOS", "0"), ["no body 'pal'"]),
    (ARM.replace("BODY", "").replace('model="hand" ', 'model="foot" ', 1).replace("QPOS", "0"), ["'foot'"]),
    (ARM.replace("BODY", "").replace("r_", "l_").replace("QPOS", "0 " * 8), ["prefix"]),
    (ARM.replace("hand.xml", "arm.xml").replace("BODY", "").replace("QPOS", "0"), ["attaches itself"]),
    (ARM.replace("hand.xml", "none.xml").replace("BODY", "").replace("QPOS", "0"), ["none.xml"])])
def test_an_attachment_that_cannot_be_is_refused(text, words, tmp_path):
    (tmp_path / "hand.xml").write_text(HAND)
    (tmp_path / "arm.xml").write_text(text)
    with pytest.raises(epode.RefusedError) as error:
        epode.load(tmp_path / "arm.xml")
    assert all(word in str(error.value) for word in words), str(error.value)
    if words != ["attaches itself"]:  # at which MuJoCo 4.0 ends the process
        with pytest.raises(ValueError):
            judge().MjModel.from_xml_path(str(tmp_path / "arm.xml"))


LOOKED_AT = ("<mujoco><asset><material name='red' rgba='1 0 0 1'/></asset><worldbody><camera name='above' pos='0 0 3' fovy='30'/>"
             "<body name='ball' pos='0 0 1'><joint axis='0 1 0'/><geom name='ball' size='.3' material='red'/>"
             "<camera name='on' pos='0 -1 0' xyaxes='1 0 0 0 0 1' focal='.01 .02' sensorsize='.02 .02'/>"
             "<site name='on' pos='0 -1 0' xyaxes='1 0 0 0 0 1'/></body>"
             "<body name='cube' pos='1 0 1'><freejoint/><geom type='box' size='.2 .2 .2' rgba='0 1 0 1' material='red'/></body></worldbody></mujoco>")


def test_cameras_of_a_file_see_its_colours():
    mujoco = judge()
    theirs = mujoco.MjModel.from_xml_string(LOOKED_AT)
    model = epode.robot.from_text(LOOKED_AT)
    assert [one.name for one in model.cameras] == ["above", "on"]
    np.testing.assert_allclose([one.field for one in model.cameras], [np.pi / 6, 2 * np.arctan(0.5)])
    data = mujoco.MjData(theirs)
    mujoco.mj_forward(theirs, data)
    robot = model.build()
    picture = robot.picture("above", 64, 48)
    middle = picture.color[24, 32].astype(int)
    assert middle[0] > 3 * max(middle[1], middle[2]) and picture.depth[24, 32] == pytest.approx(1.7, abs=0.01)
    rows = np.flatnonzero(np.isfinite(picture.depth[:, 32]))
    # Half the sphere's angle, of the field's half: tan(asin(0.3 / 2)) / tan(15 degrees) of 24 rows.
    assert len(rows) / 2 == pytest.approx(24 * np.tan(np.arcsin(0.15)) / np.tan(np.pi / 12), abs=1)
    seen = robot.picture("on", 64, 48, field=1.2)
    assert not np.isfinite(seen.depth[24, 32])  # its own link is not seen
    again = model.edit()
    assert again.model().cameras[1].field == pytest.approx(model.cameras[1].field)
    np.testing.assert_allclose(again.geoms["ball"].color, (1, 0, 0, 1))
    with pytest.raises(KeyError, match="above"):
        robot.world.picture(camera="abov")
    follows = epode.robot.from_text(LOOKED_AT.replace("fovy='30'", "mode='trackcom'"), strict=True)
    assert [note.kind for note in follows.report if "mode" in note.text] == ["changed"]


def test_a_window_s_picture_is_drawn_from_a_camera_of_the_file():
    model = epode.robot.from_text(LOOKED_AT)
    world = model.build().world
    try:
        by_name = world.picture(camera="above", width=64, height=48)
    except RuntimeError as error:
        pytest.skip(str(error))
    assert by_name == world.picture(eye=(0, 0, 3), target=(0, 0, 2), up=(0, 1, 0), field=np.pi / 6, width=64, height=48)
    assert by_name != world.picture(eye=(0, 0, 3), target=(0, 0, 2), up=(1, 0, 0), field=np.pi / 6, width=64, height=48)


@pytest.mark.parametrize("text, words", [
    ("<mujoco><worldbody><body><geom type='sphear' size='.1'/></body></worldbody></mujoco>", ["'sphear'", "'sphere'"]),
    ("<mujoco><worldbody><body><joint type='hing'/><geom size='.1'/></body></worldbody></mujoco>", ["'hing'", "'hinge'"]),
    ("<mujoco><worldbody><body><joint limited='yes'/><geom size='.1'/></body></worldbody></mujoco>", ["limited", "'yes'"]),
    ("<mujoco><compiler angle='rad'/><worldbody/></mujoco>", ["angle", "radian"]),
    ("<mujoco><option><flag gravity='off'/></option><worldbody/></mujoco>", ["gravity", "disable"])])
def test_values_that_no_keyword_is_are_errors(text, words):
    with pytest.raises(epode.RefusedError) as error:
        epode.robot.from_text(text)
    assert all(word in str(error.value) for word in words)
    with pytest.raises(ValueError):
        judge().MjModel.from_xml_string(text)


@pytest.mark.parametrize("word", ["geom solref='{}' size='.1'", "joint solreflimit='{}' range='5 20'"])
def test_the_second_number_of_solref_may_be_left_out(word):
    """Files of others have it so: the damping ratio is 1 then, as MuJoCo has it."""
    ends = []
    for numbers in ("0.01", "0.01 1", "0.01 0.3"):
        geom, joint = (word.format(numbers), "freejoint") if word.startswith("geom") else ("geom size='.1' pos='.2 0 0'", word.format(numbers) + " axis='0 1 0'")
        robot = epode.robot.from_text(f"<mujoco><worldbody><geom type='plane' size='1 1 1'/><body pos='0 0 .12'><{joint}/><{geom}/></body></worldbody></mujoco>").build()
        robot.world.step(0.002, steps=100)
        ends.append(robot.positions.tolist())
    assert ends[0] == ends[1] != ends[2]


def moved(default, joint, geom, actuator):
    """Where two seconds of a robot end whose lists say that much."""
    robot = epode.robot.from_text(
        f"<mujoco><default>{default}</default><worldbody><geom type='plane' size='9 9 1' friction='1 0.005 0.0001'/><body pos='0 0 .4'><joint name='j' axis='0 1 0' {joint}/>"
        f"<geom type='box' pos='.3 0 0' {geom}/></body></worldbody><actuator>{actuator}</actuator></mujoco>").build(start=[0.3])
    robot.controls = [0.2]
    robot.world.step(0.002, steps=100)
    return robot.positions.tolist() + robot.velocities.tolist()


def test_lists_that_are_short_go_on_with_the_numbers_of_their_class():
    """As MuJoCo has it: gains, gears, sizes, frictions and softness alike."""
    short = moved("<geom size='.1 .2 .3' friction='.7 .1 .2'/><general gainprm='1' biasprm='0 -10 -4' biastype='affine' gear='1 2'/>", "", "size='.15' friction='.3'",
                  "<general joint='j' gainprm='200' biasprm='0 -200' gear='1.5'/>")
    full = moved("", "", "size='.15 .2 .3' friction='.3 .1 .2'", "<general joint='j' gainprm='200' biasprm='0 -200 -4' biastype='affine' gear='1.5 2'/>")
    without = moved("", "", "size='.15 .2 .3'", "<general joint='j' gainprm='200' biasprm='0 -200 0' biastype='affine' gear='1.5 2'/>")
    assert short == full != without


def test_a_general_servo_has_a_damping_ratio_too():
    """A third bias above 0 of a servo is its ratio, as `position dampratio` has it: not a force that drives it on."""
    general = moved("", "", "size='.1 .1 .1'", "<general joint='j' gainprm='50' biasprm='0 -50 0.7' biastype='affine'/>")
    position = moved("", "", "size='.1 .1 .1'", "<position joint='j' kp='50' dampratio='0.7'/>")
    np.testing.assert_allclose(general, position, rtol=1e-9)
    assert general != moved("", "", "size='.1 .1 .1'", "<position joint='j' kp='50'/>")


def test_a_class_hands_the_range_of_a_joint_to_servos_alone():
    """And to those alone that have no range of their own: as MuJoCo has it."""
    def range_of(actuator, more=""):
        model = epode.robot.from_text(f"<mujoco><default><position kp='5' inheritrange='0.5'/>{more}</default><worldbody><body><joint name='j' range='-60 60'/>"
                                      f"<geom size='.1'/></body></worldbody><actuator>{actuator}</actuator></mujoco>")
        return model.actuators[0].low, model.actuators[0].high
    sixth = np.pi / 6
    assert range_of("<position joint='j'/>") == pytest.approx((-sixth, sixth))
    assert range_of("<position joint='j' ctrlrange='-7 7'/>") == range_of("<motor joint='j'/>", "<motor ctrlrange='-7 7'/>") == (-7, 7)
    assert range_of("<motor joint='j'/>") == range_of("<velocity joint='j'/>") == (-np.inf, np.inf)
