# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""What MuJoCo refuses of an MJCF file is refused here, and what it takes is taken: each row with both, where MuJoCo is installed."""
import pytest

import epode

BODIES = ("<body name='b'><joint name='j'/><geom name='g' size='.1'/><site name='s'/></body>"
          "<body name='c' pos='1 0 0'><joint name='k'/><geom name='h' size='.1'/><site name='u'/></body>")

IN_WORLD = {  # element: whether it is good
    "<geom size='.1' material='no'/>": False, "<geom type='mesh' mesh='no'/>": False, "<geom type='hfield' hfield='no'/>": False,
    "<joint/>": False, "<freejoint/>": False, "<inertial pos='0 0 0' mass='1'/>": False, "<body childclass='no'><geom size='.1'/></body>": False,
    "<body><joint/><joint type='free'/><geom size='.1'/></body>": False, "<body><joint type='free'/><joint/><geom size='.1'/></body>": False,
    "<body><joint type='ball'/><joint/><geom size='.1'/></body>": False, "<body><joint/></body>": False,
    "<body mocap='true'><joint/><geom size='.1'/></body>": False, "<site size='.1' type='plane'/>": False,
    "<camera mode='targetbody' target='no'/>": False, "<light target='no' mode='targetbody'/>": False, "<geom size='-1'/>": False,
    "<geom type='box' size='1 1'/>": False, "<geom size='.1' condim='2'/>": False, "<geom size='.1' condim='4'/>": True,
    "<body><joint limited='true'/><geom size='.1'/></body>": False, "<body><joint axis='0 0 0'/><geom size='.1'/></body>": False,
    "<body><joint range='0 0'/><geom size='.1'/></body>": True, "<geom size='.1' quat='0 0 0 0'/>": False,
    "<geom size='.1' euler='0 0 0' quat='1 0 0 0'/>": False, "<body name='world'><geom size='.1'/></body>": False, "<geom size='.1' name='b'/>": True,
    "<body><joint type='ball' range='-20 20'/><geom size='.1'/></body>": False, "<geom type='sphere' fromto='0 0 0 0 0 1' size='.1'/>": False,
    "<geom size='.1' rgba='1 1'/>": False, "<geom size='nan'/>": False, "<geom size='.1' type='bal'/>": False, "<geom sizes='.1'/>": False,
    "<gem size='.1'/>": False, "<geom size='.1' name='g'/>": False,
}
SECTIONS = {
    "<actuator><motor joint='no'/></actuator>": False, "<actuator><motor/></actuator>": False, "<actuator><motor tendon='no'/></actuator>": False,
    "<actuator><adhesion body='no'/></actuator>": False, "<actuator><motor joint='j' ctrllimited='true'/></actuator>": False,
    "<actuator><motor joint='j' ctrlrange='0 0'/></actuator>": True, "<actuator><position joint='j' kv='1' dampratio='1'/></actuator>": False,
    "<actuator><position joint='j' kv='-1'/></actuator>": False, "<actuator><general joint='j' dyntype='no'/></actuator>": False,
    "<actuator><general joint='j' dyntype='integrator' actlimited='true'/></actuator>": False,
    "<actuator><motor joint='j' user='1 2 3'/></actuator>": True, "<size nuser_actuator='2'/><actuator><motor joint='j' user='1 2 3'/></actuator>": False,
    "<size nuser_actuator='-2'/>": False, "<custom><numeric name='n' data='1 2 3'/></custom>": True, "<custom><numeric name='n'/></custom>": False,
    "<custom><numeric name='n' size='2' data='1 2 3'/></custom>": False, "<custom><numeric data='1'/></custom>": False,
    "<custom><numeric name='n' data='x'/></custom>": False, "<custom><numeric name='n' size='5' data='1'/></custom>": True,
    "<custom><numeric name='n' size='0' data='1'/></custom>": False, "<custom><text name='t'/></custom>": False,
    "<custom><text name='t' data='x'/></custom>": True, "<custom><tuple name='t'/></custom>": False,
    "<custom><tuple name='t'><element objtype='body' objname='no'/></tuple></custom>": False,
    "<custom><tuple name='t'><element objtype='body' objname='b'/></tuple></custom>": True, "<keyframe><key qpos='1'/></keyframe>": True,
    "<keyframe><key qpos='1 2 3'/></keyframe>": False, "<keyframe><key qpos='1 2' act='1'/></keyframe>": False,
    "<sensor><jointpos joint='no'/></sensor>": False, "<sensor><jointpos/></sensor>": False, "<sensor><gyro site='no'/></sensor>": False,
    "<sensor><user name='u' dim='3'/></sensor>": True, "<sensor><framepos objtype='blob' objname='b'/></sensor>": False,
    "<sensor><framepos objtype='body' objname='no'/></sensor>": False, "<sensor><touch site='s' cutoff='-1'/></sensor>": False,
    "<equality><weld body1='no'/></equality>": False, "<equality><weld/></equality>": False, "<equality><connect body1='b'/></equality>": False,
    "<equality><connect body1='b' anchor='0 0 0' body2='b'/></equality>": False, "<equality><joint joint1='j' joint2='j'/></equality>": False,
    "<equality><tendon tendon1='no'/></equality>": False, "<contact><exclude body1='no' body2='b'/></contact>": False,
    "<contact><pair geom1='g' geom2='no'/></contact>": False, "<tendon><fixed name='t'/></tendon>": False,
    "<tendon><fixed><joint joint='j'/></fixed></tendon>": False, "<tendon><spatial><site site='no'/><site site='s'/></spatial></tendon>": False,
    "<tendon><spatial material='no'><site site='s'/><site site='u'/></spatial></tendon>": False,
    "<asset><texture name='t' type='2d' builtin='no'/></asset>": False, "<asset><material name='m' texture='no'/></asset>": False,
    "<visual><map znear='a'/></visual>": False, "<visual><no/></visual>": False, "<option integrator='no'/>": False,
    "<option><flag contact='maybe'/></option>": False, "<compiler angle='grad'/>": False, "<no/>": False,
}
TEXTS = [(f"<mujoco><worldbody>{BODIES}{element}</worldbody></mujoco>", good) for element, good in IN_WORLD.items()]
TEXTS += [(f"<mujoco><worldbody>{BODIES}</worldbody>{section}</mujoco>", good) for section, good in SECTIONS.items()]


@pytest.mark.parametrize("text,is_good", TEXTS)
def test_what_mujoco_refuses_is_refused_with_its_line(tmp_path, monkeypatch, text, is_good):
    path = tmp_path / "robot.xml"
    path.write_text("\n" + text)
    errors = [note for note in epode.robot.check(path) if note.kind == "error"]
    assert bool(errors) != is_good, errors
    assert all(note.line == 2 for note in errors)
    mujoco = pytest.importorskip("mujoco")
    monkeypatch.chdir(tmp_path)  # where it leaves a log
    if is_good:
        mujoco.MjModel.from_xml_string(text)
    else:
        with pytest.raises(ValueError):
            mujoco.MjModel.from_xml_string(text)


def test_a_wrong_reference_names_the_nearest_name():
    text = f"<mujoco><worldbody>{BODIES.replace('name=' + chr(39) + 'j' + chr(39), 'name=' + chr(39) + 'elbow' + chr(39))}</worldbody>"
    with pytest.raises(epode.RefusedError, match="<jointpos> joint is 'elbw', and no joint is called so; did you mean 'elbow'?"):
        epode.robot.from_text(text + "<sensor><jointpos joint='elbw'/></sensor></mujoco>")


def test_an_equality_of_joints_follows_its_polynomial_and_goes_on_from_states():
    text = """<mujoco><option gravity="0 0 -9.81"/><worldbody><body><joint name="a" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 .3 0 0" size=".02"/></body>
<body pos="0 1 0"><joint name="b" axis="0 1 0"/><geom type="capsule" fromto="0 0 0 .3 0 0" size=".02" mass=".001"/></body></worldbody>
<equality><joint joint1="b" joint2="a" polycoef=".1 .5 .2 -.1 .05" solref=".002 1"/></equality></mujoco>"""
    model = epode.robot.from_text(text)
    robot = model.build()
    states, worst = {}, 0.0
    for i in range(600):
        if i % 200 == 100:
            states[i] = robot.world.save()
        robot.world.step(0.001)
        a, b = robot.positions
        worst = max(worst, abs(b - (.1 + .5 * a + .2 * a**2 - .1 * a**3 + .05 * a**4)) if i > 10 else 0.0)
    assert worst < 2e-4
    end = robot.positions
    for begin, state in states.items():  # also of a clone
        for world in (robot.world, robot.world.clone()):
            world.load(state)
            world.step(0.001, steps=600 - begin)
            assert world.robots[0].positions.tobytes() == end.tobytes()
    c, rows = model.constraints(end)
    assert abs(c[0]) < 2e-4 and rows.shape == (1, 2)
    mujoco = pytest.importorskip("mujoco")
    theirs = mujoco.MjModel.from_xml_string(text)
    theirs.opt.timestep = 0.001
    data = mujoco.MjData(theirs)
    for _ in range(600):
        mujoco.mj_step(theirs, data)
    assert abs(data.qpos - end).max() < 0.01
