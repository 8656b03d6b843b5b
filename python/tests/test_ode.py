# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""epode.ode as a program for PyODE meets it; scripts/test-pyode runs PyODE's own tests and tutorials."""
import doctest
import gc

import pytest

import epode.ode as ode


def test_a_ball_bounces_as_in_pyodes_first_tutorial():
    world, space, group = ode.World(), ode.SimpleSpace(), ode.JointGroup()
    world.setGravity((0, 0, -10))
    mass = ode.Mass()
    mass.setSphere(2500, 1)
    mass.mass = 1.0
    ball = ode.Body(world)
    ball.setMass(mass)
    ball.setPosition((0, 0, 10))
    geom, floor = ode.GeomSphere(space, 1), ode.GeomPlane(space)
    geom.setBody(ball)
    seen = []

    def near(arg, geom1, geom2):
        assert arg == "mine"
        for contact in ode.collide(geom1, geom2):
            contact.setBounce(0.5)
            contact.setMu(10000)
            seen.append(contact.getContactGeomParams())
            ode.ContactJoint(world, group, contact).attach(geom1.getBody(), geom2.getBody())
    heights = []
    for _ in range(110):
        space.collide("mine", near)
        world.quickStep(0.04)
        group.empty()
        heights.append(ball.getPosition()[2])
    assert {seen[0][3], seen[0][4]} == {geom, floor} and seen[0][2] > 0
    low = heights.index(min(heights))
    assert 1.5 < max(heights[low:]) < 5 and heights[-1] > 0.9


def test_objects_go_when_nothing_refers_to_them():
    world, space = ode.World(), ode.HashSpace()
    geom, body = ode.GeomBox(space), ode.Body(world)
    joint = ode.HingeJoint(world)
    joint.attach(body, ode.environment)
    assert len(space) == 1 and list(space) == [geom] and body.getNumJoints() == 1
    del geom, joint
    gc.collect()
    assert len(space) == 0 and body.getNumJoints() == 0
    group = ode.JointGroup()
    ode.BallJoint(world, group).attach(body, None)
    assert body.getNumJoints() == 1
    group.empty()
    assert body.getNumJoints() == 0
    del world, body
    gc.collect()


def test_joints_have_their_vectors_angles_and_parameters():
    world = ode.World()
    body = ode.Body(world)
    hinge = ode.HingeJoint(world)
    hinge.attach(body, None)
    hinge.setAnchor((1, 0, 0))
    hinge.setAxis((0, 0, 2))
    assert hinge.getAxis() == (0, 0, 1) and hinge.getAnchor() == (1, 0, 0)
    hinge.setParam(ode.ParamVel, 3)
    hinge.setParam(ode.ParamFMax, 2200)
    hinge.setFeedback()
    world.step(0.01)
    assert hinge.getAngleRate() == pytest.approx(3) and len(hinge.getFeedback()) == 4
    assert ode.ParamVel2 == ode.ParamVel + ode.ParamGroup and ode.areConnected(body, ode.environment) is False
    wheel = ode.Hinge2Joint(world)
    wheel.attach(ode.Body(world), body)
    wheel.setAxis1((0, 0, 1))
    wheel.setAxis2((0, 1, 0))
    assert wheel.getAxis1() == (0, 0, 1) and wheel.getAxis2() == (0, 1, 0)


def test_wrong_use_raises_what_pyode_raised():
    world, space = ode.World(), ode.Space()
    with pytest.raises(ValueError):
        ode.GeomPlane(space).setBody(ode.Body(world))
    with pytest.raises(IndexError):
        space.getGeom(0)
    with pytest.raises(NotImplementedError):
        ode.Joint(world)
    with pytest.raises(ValueError):
        ode.Space(space_type=7)


def test_masses_add_up():
    one, other = ode.Mass(), ode.Mass()
    one.setBoxTotal(2, 1, 1, 1)
    other.setSphereTotal(1, 0.5)
    both = one + other
    assert both.mass == 3 and both.c == (0, 0, 0) and both.I[0][0] == pytest.approx(one.I[0][0] + other.I[0][0])


def test_the_docstring_runs():
    assert doctest.testmod(ode).failed == 0
