# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Rapier, native floats, from the PyPI package rapier3d: one thread, its own parameters, no sleeping."""
from importlib.metadata import version

import common
import numpy
import rapier3d as r


def turned(q):
    return r.Rotation3(*q)


def y_to_z():
    return common.turn([1, 0, 0], 1.5707963267948966)


class Engine:
    def __init__(self, scene):
        self.scene = scene
        self.world = r.PhysicsWorld(gravity=(0, 0, -scene['gravity']))
        self.world.integration_parameters.dt = scene['dt']
        self.world.set_num_threads(1)
        self.bodies = [self.body(b) for b in scene['bodies']]
        self.moved = [(h, b) for h, b in zip(self.bodies, scene['bodies']) if b['motion'] == 'driven']
        for joint in scene['joints']:
            self.joint(joint)

    def body(self, data):
        kind = {'static': r.RigidBodyType.FIXED, 'driven': r.RigidBodyType.KINEMATIC_POSITION_BASED,
                'dynamic': r.RigidBodyType.DYNAMIC}[data['motion']]
        made = r.RigidBodyBuilder(kind).position(r.Isometry3(data['pos'], turned(data['turn'])))
        made = made.linvel(data['linear']).angvel(data['angular']).can_sleep(False)
        if data['motion'] == 'dynamic':
            made = made.additional_mass_properties(r.MassProperties((0, 0, 0), data['mass'], data['inertia']))
        colliders = [self.collider(data, part) for part in data['parts']] if data['collides'] else []
        return self.world.add_body(made, colliders)

    def collider(self, data, part):
        if data['group']:
            raise common.Refused('this runner knows no groups of bodies that pass through one another')
        shape = self.scene['shapes'][part['shape']]
        x, y, z = shape['size']
        q = part['turn']
        if shape['kind'] == 'sphere':
            made = r.Collider.ball(x)
        elif shape['kind'] == 'box':
            made = r.Collider.cuboid(x / 2, y / 2, z / 2)
        elif shape['kind'] == 'capsule':
            made = r.Collider.capsule_z(y / 2, x)
        elif shape['kind'] == 'cylinder':
            made, q = r.Collider.cylinder(y / 2, x), common.product(q, y_to_z())
        elif shape['kind'] == 'hull':
            made = r.Collider.convex_hull(numpy.array(shape['points'], dtype=numpy.float32))
        else:
            made = r.Collider.trimesh(numpy.array(shape['points'], dtype=numpy.float32),
                                      numpy.array(shape['triangles'], dtype=numpy.uint32))
        return made.density(0).friction(self.scene['friction']).position(r.Isometry3(part['offset'], turned(q)))

    def joint(self, data):
        bodies = [self.scene['bodies'][data[end]] for end in ('body1', 'body2')]
        if data['kind'] == 'ball':
            made = r.SphericalJointBuilder()
        elif data['kind'] == 'hinge':
            axes = [common.rotate(common.inverse(b['turn']), data['axis1']) for b in bodies]
            made = r.RevoluteJointBuilder(axes[0]).local_axis1(axes[0]).local_axis2(axes[1])
            if data['low'] < data['high']:
                made = made.limits(-data['high'], -data['low'])
        else:
            raise common.Refused('Rapier has no hinge-2')
        made = made.local_anchor1(common.local(bodies[0], data['anchor'])).local_anchor2(common.local(bodies[1], data['anchor']))
        made = made.contacts_enabled(False).build()
        self.world.impulse_joints.insert(self.bodies[data['body1']], self.bodies[data['body2']], made, True)

    def step(self, at):
        for handle, data in self.moved:
            pos, q = common.driven(data, at + self.scene['dt'])
            self.world.rigid_bodies[handle].set_next_kinematic_position(r.Isometry3(pos, turned(q)))
        self.world.step()

    def states(self):
        for handle in self.bodies:
            body = self.world.rigid_bodies[handle]
            p, q, v, w = body.translation, body.rotation, body.linvel, body.angvel
            yield ((p.x, p.y, p.z), (q.w, q.i, q.j, q.k), (v.x, v.y, v.z), (w.x, w.y, w.z))

    def cast(self, rays):
        raise common.Refused('this runner times no rays: the call from Python costs more')


common.play(Engine, 'Rapier ' + version('rapier3d'))
