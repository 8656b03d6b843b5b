#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
#
# A program in Python (Debian's python3-pyode) that knows nothing of being recorded; it prints after each step the hash of its states, by
# the definition in docs/recording.md.
import struct

import ode

world = ode.World()
world.setGravity((0, 0, -9.81))
space = ode.HashSpace()
floor = ode.GeomPlane(space, (0, 0, 1), 0)
contacts = ode.JointGroup()
bodies, geoms = [], []
for i in range(5):
    body = ode.Body(world)
    mass = ode.Mass()
    mass.setSphere(1000, 0.25)
    body.setMass(mass)
    body.setPosition((0.05 * i, 0.02 * i, 0.5 + 0.6 * i))
    body.setAngularVel((1, 0.5 * i, 0))
    geom = ode.GeomSphere(space, 0.25)
    geom.setBody(body)
    bodies.append(body)
    geoms.append(geom)
joint = ode.BallJoint(world)
joint.attach(bodies[0], bodies[1])
joint.setAnchor((0, 0, 0.8))


def near(arguments, geom1, geom2):
    for contact in ode.collide(geom1, geom2):
        contact.setMu(50)
        ode.ContactJoint(world, contacts, contact).attach(geom1.getBody(), geom2.getBody())


def print_hash(step):
    value = 14695981039346656037
    for body in bodies:
        for number in (*body.getPosition(), *body.getQuaternion(), *body.getLinearVel(), *body.getAngularVel()):
            word = struct.unpack("<Q", struct.pack("<d", number))[0]
            value = ((value ^ word) * 1099511628211) & 0xFFFFFFFFFFFFFFFF
            value ^= value >> 32
    print(step, f"{value:016x}")


print_hash(0)
for step in range(1, 61):
    space.collide(None, near)
    world.quickStep(0.01) if step % 3 else world.step(0.01)
    contacts.empty()
    print_hash(step)
