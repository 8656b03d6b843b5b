// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Epode as WebAssembly under Node, by the classes of the npm package: one thread, doubles, the preset for games and its hybrid steps, without
// damping and sleeping, as in every engine here. Reads and writes what web.mjs describes.
import { load } from 'epode';
import { driven, play, product, readScene, rotate, versionOf } from './web.mjs';

const scene = readScene();
const engine = await load();
let world, bodies, rows;

// [kind, sizes] of createGeom.
function shapeOf({ kind, size: [x, y, z], points, triangles }) {
    switch (kind) {
        case 'sphere': return [kind, { radius: x }];
        case 'box': return [kind, { lengths: [x, y, z] }];
        case 'capsule':
        case 'cylinder': return [kind, { radius: x, length: y }];
        case 'hull': return ['convex', { points: points.flat() }];
        default: return ['triMesh', { vertices: points.flat(), indices: triangles.flat() }];
    }
}

// What stands still is a geom without a body.
function addStatic(data, part) {
    const [kind, sizes] = shapeOf(scene.shapes[part.shape]), position = rotate(data.turn, part.offset).map((x, k) => x + data.pos[k]);
    world.createGeom(kind, { ...sizes, position, quaternion: product(data.turn, part.turn), material: { friction: scene.friction } });
}

function addPart(body, part) {
    const [kind, sizes] = shapeOf(scene.shapes[part.shape]);
    body.createGeom(kind, { ...sizes, offsetPosition: part.offset, offsetQuaternion: part.turn, material: { friction: scene.friction } });
}

function makeBody(data) {
    const parts = data.collides ? data.parts : [];
    if (data.motion === 'static') {
        parts.forEach((part) => addStatic(data, part));
        return null;
    }
    const body = world.createBody({ position: data.pos, quaternion: data.turn, kinematic: data.motion === 'driven' });
    if (data.motion === 'dynamic') {
        const [x, y, z] = data.inertia;
        body.massProperties = { mass: data.mass, inertia: [x, 0, 0, 0, y, 0, 0, 0, z] };
        [body.linearVelocity, body.angularVelocity] = [data.linear, data.angular];
    }
    parts.forEach((part) => addPart(body, part));
    return body;
}

function makeJoint({ kind, body1, body2, anchor, axis1, low, high }) {
    const ends = [bodies[body1], bodies[body2]];
    if (kind === 'ball') return world.createJoint('ball', ...ends, { anchor });
    const made = world.createJoint('hinge', ...ends, { anchor, axis: axis1 });
    if (low < high) {
        made.setParam('loStop', low);
        made.setParam('hiStop', high);
    }
}

function begin() {
    world = engine.createWorld({ gravity: [0, 0, -scene.gravity], autoDisable: false, linearDamping: 0, angularDamping: 0 });
    bodies = scene.bodies.map(makeBody);
    scene.joints.forEach(makeJoint);
    rows = world.createStates(bodies.filter((body) => body), ['position', 'quaternion', 'linearVelocity', 'angularVelocity']);
    return { step, states, end: () => world.destroy() };
}

function step(at) {
    scene.bodies.forEach((data, i) => {
        if (data.motion !== 'driven') return;
        const { pos } = driven(data, at), now = bodies[i].position;
        bodies[i].linearVelocity = pos.map((x, k) => (x - now[k]) / scene.dt);
        bodies[i].angularVelocity = data.drive.spin;
    });
    world.step(scene.dt);
}

const states = () => {
    const all = rows.read();
    let at = 0;
    return bodies.map((body, i) => body ? Array.from(all.subarray(at, at += 13)) : [...scene.bodies[i].pos, ...scene.bodies[i].turn, 0, 0, 0, 0, 0, 0]);
};

play(`Epode, WebAssembly (npm epode ${versionOf('epode')})`, begin);
