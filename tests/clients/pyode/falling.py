#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""A client of ODE as Debian ships it: python3-pyode, whose binary was built for Debian's library.

Prints one figure per line, "name value...", and first the library that is in this process ("#library PATH INODE",
from the process map). run.sh runs it on two libraries and compares the figures. Nothing here may be chaotic,
for the figures are compared to 1e-6 and closer.
"""

import os
import ode

# pyode's own names for these are of an older ODE (its ParamFMax is 3, which 0.16 calls LoVel): the numbers of ode/common.h.
FMAX, FMAX2 = 5, 0x105
SUSPENSION_ERP, SUSPENSION_CFM = 11, 12


def library():
    with open("/proc/self/maps") as maps:
        for line in maps:
            fields = line.split()
            if len(fields) > 5 and "/libode.so" in fields[5]:
                return fields[5], fields[4]
    return "none", "0"


def show(name, *values):
    numbers = []
    for value in values:
        numbers.extend(value if isinstance(value, (tuple, list)) else [value])
    print(name, *("%.17g" % (number + 0.0) for number in numbers))


def show_body(name, body):
    show(name + ".position", body.getPosition())
    show(name + ".quaternion", body.getQuaternion())
    show(name + ".velocity", body.getLinearVel())
    show(name + ".spin", body.getAngularVel())


def make_world(gravity=(0, 0, -9.81)):
    world = ode.World()
    world.setGravity(gravity)
    world.setERP(0.4)
    world.setCFM(1e-6)
    return world


def box_body(world, space, size, position):
    body = ode.Body(world)
    mass = ode.Mass()
    mass.setBox(1.0, *size)
    body.setMass(mass)
    body.setPosition(position)
    geom = ode.GeomBox(space, lengths=size)
    geom.setBody(body)
    return body, geom


def sphere_body(world, space, radius, position):
    body = ode.Body(world)
    mass = ode.Mass()
    mass.setSphere(2.0, radius)
    body.setMass(mass)
    body.setPosition(position)
    geom = ode.GeomSphere(space, radius)
    geom.setBody(body)
    return body, geom


def capsule_body(world, space, radius, length, position, quaternion):
    body = ode.Body(world)
    mass = ode.Mass()
    mass.setCappedCylinder(2.0, 3, radius, length)
    body.setMass(mass)
    body.setPosition(position)
    body.setQuaternion(quaternion)
    geom = ode.GeomCapsule(space, radius, length)
    geom.setBody(body)
    return body, geom


class Contacts:
    """The usual near callback: contact joints for every touching pair, and a count of them."""

    def __init__(self, world, mu=0.5, bounce=0.0, mode=None):
        self.world = world
        self.group = ode.JointGroup()
        self.mu = mu
        self.bounce = bounce
        self.mode = ode.ContactApprox1 if mode is None else mode
        self.count = 0
        self.bounce_mode = ode.ContactBounce if bounce > 0 else 0

    def near(self, _, first, second):
        if first.getBody() and second.getBody() and ode.areConnected(first.getBody(), second.getBody()):
            return
        for contact in ode.collide(first, second):
            contact.setMode(self.mode | self.bounce_mode)
            contact.setMu(self.mu)
            contact.setBounce(self.bounce)
            contact.setBounceVel(0.05)
            joint = ode.ContactJoint(self.world, self.group, contact)
            joint.attach(first.getBody(), second.getBody())
            self.count += 1

    def run(self, space, steps, step_size):
        for _ in range(steps):
            space.collide(None, self.near)
            self.world.step(step_size)
            self.group.empty()


def free_fall():
    world = make_world()
    body = ode.Body(world)
    body.setPosition((0, 0, 10))
    body.setLinearVel((1, 0, 0))
    body.setAngularVel((1, 2, 3))
    for _ in range(100):
        world.step(0.01)
    show_body("free-fall", body)
    body.addForce((1, 2, 3))
    body.addRelTorque((0.1, 0.2, 0.3))
    body.addForceAtRelPos((0, 0, 1), (0.5, 0, 0))
    show("forces", body.getForce(), body.getTorque())
    show("points", body.getRelPointPos((1, 2, 3)), body.getRelPointVel((1, 2, 3)), body.vectorToWorld((1, 0, 0)))


def falling_bodies():
    world = make_world()
    space = ode.HashSpace()
    floor = ode.GeomPlane(space, (0, 0, 1), 0)
    box, box_geom = box_body(world, space, (1, 0.8, 0.6), (0, 0, 0.5))
    ball, ball_geom = sphere_body(world, space, 0.4, (3, 0, 1.0))
    lying = (0.5 ** 0.5, 0.5 ** 0.5, 0, 0)
    capsule, capsule_geom = capsule_body(world, space, 0.3, 1.0, (6, 0, 0.5), lying)
    ball.setLinearVel((0, 1, 0))
    contacts = Contacts(world)
    for second in range(3):
        contacts.run(space, 50, 0.01)
        show_body("box%d" % second, box)
        show_body("ball%d" % second, ball)
        show_body("capsule%d" % second, capsule)
    geoms = [floor, box_geom, ball_geom, capsule_geom]  # a geom lives as long as Python knows it
    show("things", len(geoms), contacts.count, floor.getParams()[0])


def bouncing_ball():
    world = make_world()
    space = ode.SimpleSpace()
    floor = ode.GeomPlane(space, (0, 0, 1), 0)
    ball, ball_geom = sphere_body(world, space, 0.5, (0, 0, 1.5))
    contacts = Contacts(world, bounce=0.6)
    top = 0.0
    for _ in range(100):
        contacts.run(space, 1, 0.01)
        if ball.getLinearVel()[2] > 0:
            top = max(top, ball.getPosition()[2])
    show("bounce", top, contacts.count)
    show_body("bounce", ball)
    show("bounce-floor", floor.getParams()[1], ball_geom.getRadius())


def pendulum():
    world = make_world()
    bob = ode.Body(world)
    bob.setPosition((1, 0, 0))
    hinge = ode.HingeJoint(world)
    hinge.attach(bob, ode.environment)
    hinge.setAnchor((0, 0, 0))
    hinge.setAxis((0, 1, 0))
    hinge.setFeedback(True)
    for _ in range(100):
        world.step(0.01)
    show_body("pendulum", bob)
    show("pendulum.angle", hinge.getAngle(), hinge.getAngleRate(), hinge.getAnchor(), hinge.getAxis())
    # Body 1 only: what belongs to a missing second body is never written, and pyode does not clear it.
    show("pendulum.feedback", *hinge.getFeedback()[:2])


def motors():
    world = make_world((0, 0, 0))
    arm = ode.Body(world)
    hinge = ode.HingeJoint(world)
    hinge.attach(arm, ode.environment)
    hinge.setAnchor((0, 0, 0))
    hinge.setAxis((0, 0, 1))
    hinge.setParam(ode.ParamVel, 3)
    hinge.setParam(FMAX, 4)
    hinge.setParam(ode.ParamLoStop, -1)
    hinge.setParam(ode.ParamHiStop, 1)
    rail = ode.Body(world)
    rail.setPosition((0, 5, 0))
    slider = ode.SliderJoint(world)
    slider.attach(rail, ode.environment)
    slider.setAxis((0, 1, 0))
    slider.setParam(ode.ParamVel, -2)
    slider.setParam(FMAX, 10)
    top = ode.Body(world)
    top.setPosition((0, 0, 5))
    amotor = ode.AMotor(world)
    amotor.attach(top, ode.environment)
    amotor.setMode(ode.AMotorUser)
    amotor.setNumAxes(2)
    amotor.setAxis(0, 0, (1, 0, 0))
    amotor.setAxis(1, 0, (0, 1, 0))
    amotor.setParam(ode.ParamVel, 1)
    amotor.setParam(FMAX, 2)
    amotor.setParam(ode.ParamVel2, -1)
    amotor.setParam(FMAX2, 1)
    for _ in range(100):
        world.step(0.01)
    show("hinge-motor", hinge.getAngle(), hinge.getAngleRate())
    show("slider-motor", slider.getPosition(), slider.getPositionRate())
    show("angular-motor", amotor.getAngleRate(0), amotor.getAngleRate(1))
    show_body("top", top)


def linked_bodies():
    world = make_world()
    bodies = []
    for i in range(5):
        body = ode.Body(world)
        body.setPosition((i + 0.5, 0, 0))
        mass = ode.Mass()
        mass.setCappedCylinderTotal(1.0, 1, 0.1, 0.8)
        body.setMass(mass)
        bodies.append(body)
    joints = []
    kinds = (ode.BallJoint, ode.HingeJoint, ode.UniversalJoint, ode.FixedJoint, ode.BallJoint)
    for i, kind in enumerate(kinds):
        joint = kind(world)
        joint.attach(bodies[i], bodies[i - 1] if i else ode.environment)
        if kind is ode.FixedJoint:
            joint.setFixed()
        else:
            joint.setAnchor((i, 0, 0))
        if kind is ode.HingeJoint:
            joint.setAxis((0, 1, 0))
        if kind is ode.UniversalJoint:
            joint.setAxis1((0, 1, 0))
            joint.setAxis2((0, 0, 1))
        joints.append(joint)
    for _ in range(100):
        world.step(0.005)
    for i, body in enumerate(bodies):
        show_body("link%d" % i, body)
    show("connected", float(ode.areConnected(bodies[0], bodies[1])), float(ode.areConnected(bodies[0], bodies[2])))


def car():
    world = make_world()
    space = ode.HashSpace()
    floor = ode.GeomPlane(space, (0, 0, 1), 0)
    chassis, chassis_geom = box_body(world, space, (1.4, 0.5, 0.2), (0, 0, 0.5))
    wheels = []
    keep = [floor, chassis_geom]
    for x, y in ((0.5, 0.4), (0.5, -0.4), (-0.5, 0.4), (-0.5, -0.4)):
        wheel, geom = sphere_body(world, space, 0.25, (x, y, 0.25))
        joint = ode.Hinge2Joint(world)
        joint.attach(chassis, wheel)
        joint.setAnchor((x, y, 0.25))
        joint.setAxis1((0, 0, 1))
        joint.setAxis2((0, 1, 0))
        joint.setParam(SUSPENSION_ERP, 0.4)
        joint.setParam(SUSPENSION_CFM, 0.01)
        joint.setParam(ode.ParamLoStop, 0)
        joint.setParam(ode.ParamHiStop, 0)
        joint.setParam(ode.ParamVel2, -4)
        joint.setParam(FMAX2, 0.1)
        keep.extend((geom, joint))
        wheels.append(wheel)
    Contacts(world).run(space, 100, 0.01)
    show("car", len(keep))
    show_body("chassis", chassis)
    for i, wheel in enumerate(wheels):
        show_body("wheel%d" % i, wheel)


def rays():
    space = ode.SimpleSpace()
    box = ode.GeomBox(space, lengths=(1, 2, 3))
    ball = ode.GeomSphere(space, 0.7)
    capsule = ode.GeomCapsule(space, 0.4, 1.5)
    cylinder = ode.GeomCylinder(space, 0.5, 1.2)
    floor = ode.GeomPlane(space, (0, 0, 1), -2)
    ball.setPosition((3, 0, 0))
    capsule.setPosition((6, 0, 0))
    cylinder.setPosition((9, 0, 0))
    ray = ode.GeomRay(space, 20)
    state = 1
    for i in range(200):
        numbers = []
        for _ in range(6):
            state = (state * 1103515245 + 12345) % 2147483648
            numbers.append(state / 2147483648.0)
        ray.set((numbers[0] * 12 - 1, numbers[1] * 4 - 2, 6), (numbers[2] - 0.5, numbers[3] - 0.5, -1 - numbers[4]))
        for name, target in (("box", box), ("ball", ball), ("capsule", capsule), ("cylinder", cylinder),
                             ("floor", floor)):
            for contact in ode.collide(ray, target):
                position, normal, depth, _, _ = contact.getContactGeomParams()
                show("ray%d.%s" % (i, name), position, normal, depth)


def geoms():
    space = ode.HashSpace()
    space.setLevels(-2, 3)
    box = ode.GeomBox(space, lengths=(1, 2, 3))
    box.setPosition((1, 2, 3))
    box.setQuaternion((0.5, 0.5, 0.5, 0.5))
    show("aabb", box.getAABB(), box.pointDepth((1, 2, 3)), float(box.isEnabled()), box.getCategoryBits())
    ball = ode.GeomSphere(space, 0.5)
    transform = ode.GeomTransform(space)
    inner = ode.GeomBox(None, lengths=(1, 1, 1))
    inner.setPosition((0.5, 0, 0))
    transform.setGeom(inner)
    transform.setPosition((0, 0, 0.4))
    ball.setPosition((0.6, 0.1, 1.2))
    for name, pair in (("transform-ball", (transform, ball)), ("ball-transform", (ball, transform))):
        for contact in ode.collide(*pair):
            position, normal, depth, _, _ = contact.getContactGeomParams()
            show(name, position, normal, depth)
    show("space", space.getNumGeoms(), space.getLevels())


def sleeping():
    world = make_world((0, 0, 0))
    world.setAutoDisableFlag(True)
    world.setAutoDisableSteps(7)
    first, second = ode.Body(world), ode.Body(world)
    second.setPosition((1, 0, 0))
    joint = ode.BallJoint(world)
    joint.attach(first, second)
    joint.setAnchor((0.5, 0, 0))
    states = []
    for step in range(30):
        if step == 15:
            first.enable()
            first.setLinearVel((0, 0.5, 0))
        world.step(0.01)
        states.append(2 * first.isEnabled() + second.isEnabled())
    show("sleep", states)
    show_body("woken", second)


def main():
    ode.InitODE()
    print("#library", *library())
    for part in (free_fall, falling_bodies, bouncing_ball, pendulum, motors, linked_bodies, car, rays, geoms, sleeping):
        part()
    # A last word from inside the process: PYTHONPATH cannot have replaced the extension by another one.
    print("#extension", os.path.realpath(ode.__file__))


if __name__ == "__main__":
    main()
