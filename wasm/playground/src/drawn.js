// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A running simulation as the stage of the replay page (record/page/src/stage.js) wants a recording: solids, parts of them at carriers
// (bodies, and pictures that scenes move), joints; of no moment, for the poses are the simulation's own.
import {Poses} from '../../../record/page/src/poses.js';

const kKind = {plane: 5, heightfield: 9, other: 0};  // as recordings number them
const kPalette = [[0.76, 0.36, 0.24], [0.86, 0.56, 0.34], [0.30, 0.52, 0.70], [0.36, 0.64, 0.48], [0.82, 0.68, 0.30], [0.55, 0.45, 0.68],
                  [0.25, 0.27, 0.31], [0.72, 0.74, 0.70]];
const kGroundHalf = 400, kRound = 28;
const kind_of = geom => geom.constructor.kind;

// Geoms of one key look alike.
function key_of(geom) {
    const sizes = geom.lengths ?? geom.radii ?? geom.params ?? geom.radius;
    return ['convex', 'heightfield', 'triMesh'].includes(kind_of(geom)) ? `${kind_of(geom)} ${geom.handle}` : `${kind_of(geom)} ${JSON.stringify(sizes)}`;
}

// Triangles as points, normals and corners; those of a sphere point away from its middle.
function solid_of(geom) {
    if (kind_of(geom) === 'plane') return ground();
    const points = Float32Array.from(geom.userData.triangles ?? geom.triangles(kRound)), normals = new Float32Array(points.length);
    for (let t = 0; t < points.length; t += 9) {
        const [u, v] = [3, 6].map(k => [0, 1, 2].map(i => points[t + k + i] - points[t + i]));
        const flat = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for (let k = 0; k < 9; k += 3) {
            const n = kind_of(geom) === 'sphere' ? points.slice(t + k, t + k + 3) : flat, length = Math.hypot(...n) || 1;
            for (let i = 0; i < 3; ++i) normals[t + k + i] = n[i] / length;
        }
    }
    return {kind: kKind[kind_of(geom)] ?? kKind.other, points, normals, corners: Uint32Array.from({length: points.length / 3}, (_, i) => i)};
}

function ground() {
    const h = kGroundHalf;
    return {kind: kKind.plane, points: new Float32Array([-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0]),
            normals: new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]), corners: new Uint32Array([0, 1, 2, 0, 2, 3])};
}

// Where a geom is on its carrier; a plane is drawn where it is nearest to the origin.
function place_of(geom, is_carrier) {
    if (is_carrier) return [0, 0, 0, 1, 0, 0, 0];
    if (kind_of(geom) === 'plane') return [...geom.params.slice(0, 3).map(x => x * geom.params[3]), 1, 0, 0, 0];
    return geom.body ? [...geom.offsetPosition, ...geom.offsetQuaternion] : [...geom.position, ...geom.quaternion];
}

function parts_of(simulation, geoms, solids) {
    const {bodies, kit: {shown}} = simulation, known = new Map(), carriers = new Map(bodies.map((body, i) => [body, i]));
    shown.forEach(({geom}, i) => carriers.set(geom, bodies.length + i));
    const numbers = new Int32Array(4 * geoms.length), poses = new Float32Array(10 * geoms.length);
    geoms.forEach((geom, i) => {
        const key = key_of(geom), carrier = carriers.get(geom) ?? carriers.get(geom.body) ?? -1;
        if (!known.has(key)) known.set(key, solids.push(solid_of(geom)) - 1);
        numbers.set([known.get(key), carrier, geom.userData.color, carrier], 4 * i);
        poses.set([...place_of(geom, carriers.has(geom)), 1, 1, 1], 10 * i);
    });
    return {count: geoms.length, numbers, poses};
}

// A line from each body to where its joint holds it.
function joints_of({world, bodies}) {
    const joints = world.joints.filter(joint => Array.isArray(joint.anchor)), carriers = new Int32Array(2 * joints.length);
    const anchors = new Float32Array(6 * joints.length).fill(NaN);
    joints.forEach((joint, i) => joint.bodies.forEach((body, side) => {
        carriers[2 * i + side] = body ? bodies.indexOf(body) : -1;
        if (body) anchors.set(body.getPositionRelPoint(joint.anchor), 6 * i + 3 * side);
    }));
    return {count: joints.length, carriers, anchors};
}

export function recording_of(simulation) {
    const geoms = simulation.world.geoms.filter(geom => (geom.userData?.color ?? null) !== null), solids = [];
    return {
        parts: parts_of(simulation, geoms, solids), solids, palette: kPalette, times: new Float32Array([0]), joints: joints_of(simulation),
        carriers: {count: simulation.bodies.length + simulation.kit.shown.length, lives: []}, contacts: {starts: new Uint32Array(0)},
    };
}

export class LivePoses extends Poses {
    constructor(recording, simulation) {
        super(recording);
        this.simulation = simulation;
    }
    go_to() { this.values.set(this.simulation.poses()); }
}
