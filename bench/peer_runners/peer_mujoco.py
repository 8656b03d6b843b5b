# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026 The Epode authors
"""MuJoCo, native, in doubles, with its own solver and softness: made for robots rather than piles, and its contacts are
soft on purpose. Joints between free bodies are equality constraints; a hinge is two of them on its axis, its stops are
left out."""
import common
import mujoco
import numpy

GEOMS = {'sphere': mujoco.mjtGeom.mjGEOM_SPHERE, 'box': mujoco.mjtGeom.mjGEOM_BOX, 'capsule': mujoco.mjtGeom.mjGEOM_CAPSULE,
         'cylinder': mujoco.mjtGeom.mjGEOM_CYLINDER}
MOST_BODIES = 1500


class Engine:
    def __init__(self, scene):
        if len(scene['bodies']) > MOST_BODIES:
            raise common.Refused(f'more than {MOST_BODIES} bodies are not asked of MuJoCo')
        if any(b['motion'] == 'driven' or b['group'] for b in scene['bodies']):
            raise common.Refused('this runner has no driven bodies and no groups')
        self.scene = scene
        self.spec = mujoco.MjSpec()
        self.spec.option.timestep = scene['dt']
        self.spec.option.gravity = [0, 0, -scene['gravity']]
        for number, shape in enumerate(scene['shapes']):
            if shape['kind'] == 'hull':
                self.spec.add_mesh(name=f'mesh{number}', uservert=numpy.array(shape['points']).ravel())
            elif shape['kind'] == 'mesh':
                raise common.Refused('MuJoCo takes meshes for convex')
        for number, body in enumerate(scene['bodies']):
            self.body(number, body)
        for joint in scene['joints']:
            self.joint(joint)
        self.model = self.spec.compile()
        self.data = mujoco.MjData(self.model)
        self.numbers = [self.model.body(f'b{i}').id for i in range(len(scene['bodies']))]

    def body(self, number, data):
        made = self.spec.worldbody.add_body(name=f'b{number}', pos=data['pos'], quat=data['turn'])
        if data['motion'] == 'dynamic':
            made.add_freejoint()
            made.explicitinertial = True
            made.mass, made.inertia, made.ipos, made.iquat = data['mass'], data['inertia'], [0, 0, 0], [1, 0, 0, 0]
        for part in data['parts']:
            shape = self.scene['shapes'][part['shape']]
            x, y, z = shape['size']
            kind = shape['kind']
            size = {'sphere': [x, 0, 0], 'box': [x / 2, y / 2, z / 2]}.get(kind, [x, y / 2, 0])
            form = {'type': mujoco.mjtGeom.mjGEOM_MESH, 'meshname': f'mesh{part["shape"]}'} if kind == 'hull' else {
                'type': GEOMS[kind], 'size': size}
            bits = int(data['collides'])
            made.add_geom(pos=part['offset'], quat=part['turn'], friction=[self.scene['friction'], 0, 0], condim=3,
                          contype=bits, conaffinity=bits, **form)

    def joint(self, data):
        if data['kind'] == 'hinge2':
            raise common.Refused('this runner has no hinge-2')
        body = self.scene['bodies'][data['body1']]
        names = [f'b{data[end]}' for end in ('body1', 'body2')]
        anchors = [data['anchor']]
        if data['kind'] == 'hinge':
            anchors.append(common.add(data['anchor'], [0.1 * x for x in data['axis1']]))
        for anchor in anchors:
            numbers = numpy.zeros(mujoco.mjNEQDATA)
            numbers[:3] = common.local(body, anchor)
            self.spec.add_equality(type=mujoco.mjtEq.mjEQ_CONNECT, objtype=mujoco.mjtObj.mjOBJ_BODY, name1=names[0],
                                   name2=names[1], data=numbers)
        self.spec.add_exclude(bodyname1=names[0], bodyname2=names[1])

    def step(self, _):
        mujoco.mj_step(self.model, self.data)

    def states(self):
        if any(self.data.warning[w].number for w in (mujoco.mjtWarning.mjWARN_BADQPOS, mujoco.mjtWarning.mjWARN_BADQVEL,
                                                     mujoco.mjtWarning.mjWARN_BADQACC)):
            raise common.Refused('went unstable at this step size')
        mujoco.mj_kinematics(self.model, self.data)
        velocity = numpy.zeros(6)
        for number in self.numbers:
            if self.model.body_dofnum[number]:
                mujoco.mj_objectVelocity(self.model, self.data, mujoco.mjtObj.mjOBJ_XBODY, number, velocity, 0)
            else:
                velocity[:] = 0
            yield (self.data.xpos[number], self.data.xquat[number], velocity[3:], velocity[:3])

    def cast(self, rays):
        raise common.Refused('this runner times no rays')


common.play(Engine, 'MuJoCo ' + mujoco.__version__)
