# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Calls as a newcomer writes them: errors name the call that was made, say what would do, and change nothing; constructors describe their
arguments; a wrong name is never taken in silence."""
import importlib
import inspect
import pickle
import pkgutil

import numpy as np
import pytest

import epode

ARM = """<mujoco model="arm"><worldbody><body name="upper" pos="0 0 1"><joint name="shoulder" axis="0 1 0" range="-120 120"/>
<geom type="capsule" fromto="0 0 0 0.3 0 0" size="0.03" mass="1.5"/><body name="lower" pos="0.3 0 0"><joint name="elbow" axis="0 1 0"/>
<geom type="capsule" fromto="0 0 0 0.25 0 0" size="0.025" mass="0.8"/><site name="tip" pos="0.25 0 0"/></body></body></worldbody>
<actuator><motor name="motor" joint="elbow"/></actuator><sensor><jointpos name="angle" joint="elbow"/></sensor></mujoco>"""


@pytest.fixture
def robot():
    return epode.robot.from_text(ARM).build()


def refused_calls():
    """Calls that the library refuses: the program, and how the error begins."""
    return [("world.step(0)", "World.step(h=0"), ("world.erp = float('nan')", "World.erp = nan"), ("world.cfm = -1", "World.cfm = -1"),
            ("world.threads = -2", "World.threads = -2"), ("world.body(mass=1, position=(0, 0, float('inf')))", "World.body(mass=1, position="),
            ("body.velocity = (0, 0, float('nan'))", "Body.velocity = (0, 0, nan)"), ("body.add_force((1, 2, float('nan')))", "Body.add_force(force="),
            ("body.quaternion = (0, 0, 0, 0)", "Body.quaternion = (0, 0, 0, 0)"), ("joint.axis = (0, 0, 0)", "Joint.axis = (0, 0, 0)"),
            ("joint.set_drive(stiffness=-1)", "Joint.set_drive("), ("joint.position(3)", "Joint.position(axis=3)"),
            ("world.joint('hinge', body, body)", "World.joint(type='hinge'"), ("world.ray((0, 0, 1), (0, 0, 0))", "World.ray(origin="),
            ("world.geom(epode.Sphere(-1))", "World.geom(shape=Sphere(radius=-1))"), ("world.load(b'123')", "World.load(state=b'123')"),
            ("world.roll_back(3)", "World.roll_back(steps=3)"), ("epode.load_world('nowhere.epw')", "epode.load_world(path='nowhere.epw')"),
            ("epode.step_worlds([world], -1)", "epode.step_worlds(worlds=")]


@pytest.mark.parametrize("program, begin", refused_calls())
def test_refusals_name_the_call_of_python(program, begin):
    with epode.World() as world:
        body = world.body(mass=1, position=(0, 0, 1), shape=epode.Box(0.1, 0.1, 0.1))
        joint = world.joint("hinge", body, None, anchor=(0, 0, 1), axis=(0, 1, 0))
        before = world.save()
        with pytest.raises(epode.RefusedError) as error:
            exec(program, {"epode": epode, "world": world, "body": body, "joint": joint})
        text = str(error.value)
        assert text.startswith(begin) and " in d" not in text and "Bad argument" not in text, text
        assert world.save() == before
        assert str(pickle.loads(pickle.dumps(error.value))) == text


def test_calls_of_c_are_named_as_they_are():
    with pytest.raises(epode.RefusedError, match=r"in dWorldStep\(\)$"):
        epode.c.dWorldStep(epode.World()._handle, -1)


def test_a_callback_of_the_program_is_where_its_call_begins():
    with epode.World() as world:
        body = world.body(mass=1, shape=epode.Sphere(0.1))
        world.geom(epode.Sphere(0.1))
        with pytest.raises(epode.RefusedError, match="^Body.position = "):
            def near(a, b):
                body.position = (0, 0, float("nan"))
            world.collide(near)


@pytest.mark.parametrize("program", [
    "world.gravity = 5", "world.gravity = [0, 0]", "body.position = [1, 2]", "body.velocity = 3", "body.add_force([1, 2])", "joint.anchor = (1, 2)",
    "world.body(mass=-1)", "world.body(mass=0, shape=epode.Sphere(1))", "body.mass = -1", "joint.stops = (2, 1)", "joint.motor(1, -1)",
    "epode.step_worlds([world], 0.1, steps=-1)", "world.step(0.1, steps=-5)", "world.plane(normal=(0, 0, 0))", "world.plane(normal=(0, 1))", "world.couple()"])
def test_wrong_values_are_refused_without_a_word_of_c(program, recwarn):
    with epode.World() as world:
        body = world.body(mass=1, position=(0, 0, 1), shape=epode.Box(0.1, 0.1, 0.1))
        joint = world.joint("hinge", body, None, anchor=(0, 0, 1), axis=(0, 1, 0))
        with pytest.raises(ValueError) as error:
            exec(program, {"epode": epode, "world": world, "body": body, "joint": joint})
        assert "expected" in str(error.value) or "lowest" in str(error.value)
        assert "dWorld" not in str(error.value) and "dBody" not in str(error.value) and not recwarn.list


@pytest.mark.parametrize("program, kind, said", [
    ("robot.pose('lowr')", KeyError, "did you mean 'lower'"), ("robot.control('x', 1)", KeyError, "motor"),
    ("robot.control(7, 1)", IndexError, "there are 1"), ("robot.model.ik('tip')", ValueError, "a position"),
    ("robot.model.ik('tip', [1, 2])", ValueError, "position: 3"), ("robot.model.build(start='home')", KeyError, "there is none"),
    ("robot.model.build(start=[0])", ValueError, "start: 2"), ("robot.model.build(position=[0, 0])", ValueError, "position: 3"),
    ("robot.imu('tip')", epode.RefusedError, "after World.step"), ("epode.load('nowhere.xml')", epode.RefusedError, "^'nowhere.xml' is no file"),
    ("robots.positions = [1]", ValueError, r"\(1, 2\)"), ("robots.controls = [1, 2, 3]", ValueError, "row of 1"),
    ("robot.postions = [0, 0]", AttributeError, "postions"), ("robots.positons = [0, 0]", AttributeError, "positons"),
    ("robot.model.ik('tip', [0.4, 0, 0.5], [0, 0, 0, 0])", ValueError, "not all 0"), ("epode.Robots(robot)", ValueError, "in a list"),
    ("epode.Robots([robot.model])", ValueError, "in a list"), ("epode.Batch('arm.xml', 4)", TypeError, "epode.load"),
    ("epode.Batch(robot.model, 2).rays('lowr', [[0, 0, 1]])", KeyError, "did you mean 'lower'"), ("world.record(robot)", TypeError, "title"),
    ("robot.jacobian('tip', [0, 0])", ValueError, "point: 3"), ("world.body(mass=1, shape='sphere')", TypeError, "epode.Box"), ("world.joint('hinge', None, axs=(0, 0, 1))", TypeError, "axis")])
def test_robots_say_what_they_want(robot, program, kind, said):
    names = {"epode": epode, "robot": robot, "robots": epode.robot.Robots([robot]), "world": robot.world, "np": np}
    before = robot.positions
    with pytest.raises(kind, match=said):
        exec(program, names)
    assert robot.positions == pytest.approx(before) and len(robot.world.bodies) == 2


def test_states_that_were_cut_off_or_have_something_behind_are_refused(robot):
    robot.controls = [1]
    world, plain = robot.world, epode.World()
    plain.body(mass=1)
    state, own = world.save(), plain.save()
    base = plain.save()
    plain.step(0.01)
    changes = plain.save_changes(base)
    robot.controls = [2]
    for cut in (1, 8, 12, 13, 40):
        with pytest.raises(epode.RefusedError):
            world.load(state[:-cut])
        assert robot.controls == 2
    for wrong in (own + b"x", own + b"more of it", own[:-1]):
        with pytest.raises(epode.RefusedError):
            plain.load(wrong)
    with pytest.raises(epode.RefusedError, match="follow the state"):
        plain.load_changes(base, changes + b"1234")
    plain.load(own), plain.load_changes(base, changes), world.load(state)
    assert robot.controls == 1


def test_stops_can_be_taken_away():
    """A hinge whose range reaches beyond half a turn, and one within it, fall freely once their stops are gone."""
    for high in (1.0, 3.7525):
        robot = epode.robot.from_text(f"""<mujoco><compiler angle='radian'/><worldbody><body pos='0 0 1'>
            <joint name='j' axis='0 1 0' range='-.0175 {high}'/><geom type='capsule' size='.02' fromto='0 0 0 -.5 0 0' mass='1'/>
            </body></worldbody></mujoco>""").build()
        joint = robot.joint("j")
        assert joint.stops == pytest.approx((-0.0175, high))
        robot.world.step(0.002, steps=200)
        assert robot.positions[0] > -0.03
        joint.stops = None
        assert joint.stops == (-np.inf, np.inf)
        robot.world.step(0.002, steps=200)
        assert robot.positions[0] < -1


def classes():
    for info in pkgutil.iter_modules(epode.__path__):
        if not info.name.startswith("_") and info.name not in ("c", "ode"):
            module = importlib.import_module(f"epode.{info.name}")
            for name, one in vars(module).items():
                init = vars(one).get("__init__") if inspect.isclass(one) else None
                if not name.startswith("_") and inspect.isfunction(init) and one.__module__ == module.__name__ and not hasattr(one, "__dataclass_fields__"):
                    yield pytest.param(init, id=f"{info.name}.{name}")


@pytest.mark.parametrize("init", list(classes()))
def test_constructors_describe_their_arguments(init):
    text = inspect.getdoc(init)
    assert text and "Initialize self" not in text
    for name in list(inspect.signature(init).parameters)[1:]:
        assert name in text, name


@pytest.mark.parametrize("one", [epode.Sphere, epode.Box, epode.Capsule, epode.Cone, epode.Mesh, epode.HeightField, epode.Material, epode.Drive])
def test_so_do_those_of_shapes(one):
    assert inspect.getdoc(one.__init__) == inspect.getdoc(one)
    words = inspect.getdoc(one).replace("_", " ")
    assert sum(name.split("_")[0] in words for name in list(inspect.signature(one).parameters)) >= min(2, len(inspect.signature(one).parameters))


def test_objects_say_what_they_are_and_forget_materials():
    world = epode.World()
    ground, ball = world.plane(), world.body(mass=2, position=(0, 1, 2), shape=epode.Sphere(0.2))
    hinge = world.joint("hinge", ball, None)
    ground.material = epode.Material(friction=0.1)
    ground.material = None
    assert ground.material == epode.Material()
    assert repr(world) == "<epode.World: 1 bodies, 1 joints, 2 geoms, 0 robots>" and repr(world.bodies) == "<epode.Bodies of 1>"
    assert repr(ball) == "<epode.Body: 2 kg at (0, 1, 2)>" and repr(ground) == "<epode.Geom: a plane>" and "sphere" in repr(ball.geoms[0])
    assert repr(hinge) == "<epode.Joint: hinge>" and repr(epode.BodyGroup([ball])) == "<epode.BodyGroup of 1>"
    world.destroy()
    assert all("destroyed" in repr(one) for one in (world, ground, ball, hinge))
