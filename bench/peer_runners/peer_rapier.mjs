// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rapier as WebAssembly with 128-bit lanes under Node (npm @dimforge/rapier3d-simd-compat): one thread, floats, its own parameters, no
// sleeping. Reads and writes what web.mjs describes.
import RAPIER from '@dimforge/rapier3d-simd-compat';
import { driven, inverse, play, product, readScene, rotate, turn, versionOf } from './web.mjs';

const scene = readScene();
await RAPIER.init();
const vec = ([x, y, z]) => ({ x, y, z });
const quat = ([w, x, y, z]) => ({ w, x, y, z });
const kYToZ = turn([1, 0, 0], Math.PI / 2);

let world, bodies;

// [shape, turn of it in the part]
function makeShape({ kind, size: [x, y, z], points, triangles }) {
    const { ColliderDesc } = RAPIER;
    switch (kind) {
        case 'sphere': return [ColliderDesc.ball(x)];
        case 'box': return [ColliderDesc.cuboid(x / 2, y / 2, z / 2)];
        case 'capsule': return [ColliderDesc.capsule(y / 2, x), kYToZ];
        case 'cylinder': return [ColliderDesc.cylinder(y / 2, x), kYToZ];
        case 'hull': return [ColliderDesc.convexHull(Float32Array.from(points.flat()))];
        default: return [ColliderDesc.trimesh(Float32Array.from(points.flat()), Uint32Array.from(triangles.flat()))];
    }
}

function addPart(part, body) {
    const [made, upright] = makeShape(scene.shapes[part.shape]);
    made.setDensity(0).setFriction(scene.friction).setTranslation(...part.offset);
    made.setRotation(quat(upright ? product(part.turn, upright) : part.turn));
    world.createCollider(made, body);
}

function makeBody(data) {
    const kinds = { static: 'fixed', driven: 'kinematicPositionBased', dynamic: 'dynamic' };
    const made = RAPIER.RigidBodyDesc[kinds[data.motion]]().setTranslation(...data.pos).setRotation(quat(data.turn));
    made.setLinvel(...data.linear).setAngvel(vec(data.angular)).setCanSleep(false);
    if (data.motion === 'dynamic')
        made.setAdditionalMassProperties(data.mass, vec([0, 0, 0]), vec(data.inertia), quat([1, 0, 0, 0]));
    const body = world.createRigidBody(made);
    if (data.collides) for (const part of data.parts) addPart(part, body);
    return body;
}

// A world point of the start in the frame of a body.
const local = (body, point) => rotate(inverse(body.turn), point.map((x, k) => x - body.pos[k]));

function makeJoint(data) {
    const ends = [data.body1, data.body2], [anchor1, anchor2] = ends.map((end) => vec(local(scene.bodies[end], data.anchor)));
    const axes = ends.map((end) => vec(rotate(inverse(scene.bodies[end].turn), data.axis1)));
    // The joint takes one axis for both bodies: in the scenes bodies begin unturned against each other.
    const made = data.kind === 'ball' ? RAPIER.JointData.spherical(anchor1, anchor2) : RAPIER.JointData.revolute(anchor1, anchor2, axes[0]);
    if (data.kind === 'hinge' && data.low < data.high) [made.limitsEnabled, made.limits] = [true, [-data.high, -data.low]];
    world.createImpulseJoint(made, bodies[ends[0]], bodies[ends[1]], true).setContactsEnabled(false);
}

function begin() {
    world = new RAPIER.World({ x: 0, y: 0, z: -scene.gravity });
    world.timestep = scene.dt;
    bodies = scene.bodies.map(makeBody);
    scene.joints.forEach(makeJoint);
    return { step, states, end: () => world.free() };
}

function step(at) {
    scene.bodies.forEach((data, i) => {
        if (data.motion !== 'driven') return;
        const { pos, turn } = driven(data, at);
        bodies[i].setNextKinematicTranslation(vec(pos));
        bodies[i].setNextKinematicRotation(quat(turn));
    });
    world.step();
}

const states = () => bodies.map((body) => {
    const p = body.translation(), q = body.rotation(), v = body.linvel(), w = body.angvel();
    return [p.x, p.y, p.z, q.w, q.x, q.y, q.z, v.x, v.y, v.z, w.x, w.y, w.z];
});

play(`Rapier, WebAssembly (npm @dimforge/rapier3d-simd-compat ${versionOf('@dimforge/rapier3d-simd-compat')})`, begin);
