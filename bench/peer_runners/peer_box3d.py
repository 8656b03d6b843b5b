# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""Box3D, native, from the wheel of robox3d, called through the C functions that it wraps: one worker, four substeps,
no sleeping, all else as it comes. It has no cylinders: they are hulls of 16 sides. A box is a hull to it."""
import common
from robox3d._ffi import ffi, lib


def vec(v):
    return {'x': v[0], 'y': v[1], 'z': v[2]}


def quat(q):
    return {'v': vec(q[1:]), 's': q[0]}


def pose(pos, turn):
    return {'p': vec(pos), 'q': quat(turn)}


class Engine:
    def __init__(self, scene):
        self.scene, self.kept, self.hulls, self.meshes = scene, [], {}, {}
        made = lib.b3DefaultWorldDef()
        made.gravity = vec([0, 0, -scene['gravity']])
        made.enableSleep = False
        made.workerCount = 1
        self.world = lib.b3CreateWorld(ffi.new('b3WorldDef*', made))
        self.bodies = [self.body(number, b) for number, b in enumerate(scene['bodies'])]
        for joint in scene['joints']:
            self.joint(joint)

    def hull(self, number):
        shape = self.scene['shapes'][number]
        if number not in self.hulls:
            points = common.cylinder_points(shape, 16) if shape['kind'] == 'cylinder' else shape['points']
            self.hulls[number] = lib.b3CreateHull(ffi.new('b3Vec3[]', [vec(p) for p in points]), len(points), len(points))
        return self.hulls[number]

    def mesh(self, number):
        shape = self.scene['shapes'][number]
        if number not in self.meshes:
            points = ffi.new('b3Vec3[]', [vec(p) for p in shape['points']])
            corners = ffi.new('int32_t[]', [i for t in shape['triangles'] for i in t])
            made = ffi.new('b3MeshDef*', {'vertices': points, 'indices': corners, 'vertexCount': len(shape['points']),
                                          'triangleCount': len(shape['triangles']), 'identifyEdges': True})
            self.meshes[number] = lib.b3CreateMesh(made, ffi.NULL, 0)
        return self.meshes[number]

    def body(self, number, data):
        made = lib.b3DefaultBodyDef()
        made.type = {'static': lib.b3_staticBody, 'driven': lib.b3_kinematicBody, 'dynamic': lib.b3_dynamicBody}[data['motion']]
        made.position, made.rotation = vec(data['pos']), quat(data['turn'])
        made.linearVelocity, made.angularVelocity = vec(data['linear']), vec(data['angular'])
        made.enableSleep = False
        body = lib.b3CreateBody(self.world, ffi.new('b3BodyDef*', made))
        for part in data['parts']:
            self.part(body, data, part)
        if data['motion'] == 'dynamic':
            x, y, z = data['inertia']
            inertia = {'cx': vec([x, 0, 0]), 'cy': vec([0, y, 0]), 'cz': vec([0, 0, z])}
            lib.b3Body_SetMassData(body, {'mass': data['mass'], 'center': vec([0, 0, 0]), 'inertia': inertia})
        return body

    def part(self, body, data, part):
        made = lib.b3DefaultShapeDef()
        made.baseMaterial.friction = self.scene['friction']
        made.updateBodyMass = False
        made.filter.groupIndex = -data['group']
        if not data['collides']:
            made.filter.maskBits = 0
        made = ffi.new('b3ShapeDef*', made)
        shape = self.scene['shapes'][part['shape']]
        size, place = shape['size'], pose(part['offset'], part['turn'])
        if shape['kind'] == 'sphere':
            lib.b3CreateSphereShape(body, made, ffi.new('b3Sphere*', {'center': place['p'], 'radius': size[0]}))
        elif shape['kind'] == 'capsule':
            ends = [common.add(part['offset'], common.rotate(part['turn'], [0, 0, sign * size[1] / 2])) for sign in (-1, 1)]
            lib.b3CreateCapsuleShape(body, made, ffi.new('b3Capsule*', {'center1': vec(ends[0]), 'center2': vec(ends[1]),
                                                                        'radius': size[0]}))
        elif shape['kind'] == 'box':
            box = ffi.new('b3BoxHull*', lib.b3MakeTransformedBoxHull(*(s / 2 for s in size), place))
            lib.b3CreateHullShape(body, made, ffi.addressof(box.base))
        elif shape['kind'] == 'mesh':
            lib.b3CreateMeshShape(body, made, self.mesh(part['shape']), vec([1, 1, 1]))
        else:
            lib.b3CreateTransformedHullShape(body, made, self.hull(part['shape']), place, vec([1, 1, 1]))

    def joint(self, data):
        kinds = {'ball': ('b3SphericalJointDef', lib.b3DefaultSphericalJointDef, lib.b3CreateSphericalJoint),
                 'hinge': ('b3RevoluteJointDef', lib.b3DefaultRevoluteJointDef, lib.b3CreateRevoluteJoint)}
        if data['kind'] not in kinds:
            raise common.Refused('this runner has no hinge-2 for Box3D')
        name, default, create = kinds[data['kind']]
        made = default()
        frame = common.z_to(data['axis1']) if data['kind'] == 'hinge' else [1, 0, 0, 0]
        for end, number in (('A', data['body1']), ('B', data['body2'])):
            body = self.scene['bodies'][number]
            place = pose(common.local(body, data['anchor']), common.product(common.inverse(body['turn']), frame))
            setattr(made.base, 'bodyId' + end, self.bodies[number])
            setattr(made.base, 'localFrame' + end, place)
        if data['kind'] == 'hinge' and data['low'] < data['high']:
            made.enableLimit, made.lowerAngle, made.upperAngle = True, -data['high'], -data['low']
        create(self.world, ffi.new(name + '*', made))

    def step(self, at):
        dt = self.scene['dt']
        for body, data in zip(self.bodies, self.scene['bodies']):
            if data['motion'] == 'driven':
                lib.b3Body_SetTargetTransform(body, pose(*common.driven(data, at + dt)), dt, True)
        lib.b3World_Step(self.world, dt, 4)

    def states(self):
        for body in self.bodies:
            t, v, w = lib.b3Body_GetTransform(body), lib.b3Body_GetLinearVelocity(body), lib.b3Body_GetAngularVelocity(body)
            yield ((t.p.x, t.p.y, t.p.z), (t.q.s, t.q.v.x, t.q.v.y, t.q.v.z), (v.x, v.y, v.z), (w.x, w.y, w.z))

    def cast(self, rays):
        raise common.Refused('this runner times no rays: the call from Python costs more')


def version():
    number = lib.b3GetVersion()
    return f'Box3D {number.major}.{number.minor}.{number.revision} (robox3d wheel)'


common.play(Engine, version())
