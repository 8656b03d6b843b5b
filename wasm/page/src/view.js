// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A running simulation for the stage of the replay page (record/page/src/stage.js), which shows recordings: one of a
// single moment, and poses that are the simulation's own.
import {Poses} from '../../../record/page/src/poses.js';

const kPlane = 5, kBoxOrRound = 0;  // kinds as recordings number them
const kPalette = [[0.76, 0.36, 0.24], [0.86, 0.56, 0.34], [0.30, 0.52, 0.70], [0.36, 0.64, 0.48], [0.82, 0.68, 0.30], [0.55, 0.45, 0.68],
                  [0.25, 0.27, 0.31], [0.72, 0.74, 0.70]];
const kGround = 7, kGroundHalf = 60;

// Triangles as points, normals and corners; those of a sphere point away from its middle.
function solid_of(triangles, is_sphere) {
    const points = triangles, normals = new Float32Array(points.length), corners = Uint32Array.from({length: points.length / 3}, (_, i) => i);
    for (let t = 0; t < points.length; t += 9) {
        const [u, v] = [3, 6].map(k => [0, 1, 2].map(i => points[t + k + i] - points[t + i]));
        const flat = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
        for (let k = 0; k < 9; k += 3) {
            const n = is_sphere ? points.slice(t + k, t + k + 3) : flat, length = Math.hypot(...n) || 1;
            for (let i = 0; i < 3; ++i) normals[t + k + i] = n[i] / length;
        }
    }
    return {kind: kBoxOrRound, points, normals, corners};
}

function ground() {
    const h = kGroundHalf;
    return {kind: kPlane, points: new Float32Array([-h, -h, 0, h, -h, 0, h, h, 0, -h, h, 0]),
            normals: new Float32Array([0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1]), corners: new Uint32Array([0, 1, 2, 0, 2, 3])};
}

// What the stage wants of a recording. Bodies of one shape and size share a solid.
export function recording_of(simulation) {
    const solids = [ground()], known = new Map(), count = simulation.bodies.length;
    const numbers = new Int32Array(4 * (count + 1)), poses = new Float32Array(10 * (count + 1));
    const put = (part, solid, carrier, color) => {
        numbers.set([solid, carrier, color, carrier], 4 * part);
        poses.set([0, 0, 0, 1, 0, 0, 0, 1, 1, 1], 10 * part);
    };
    put(0, 0, -1, kGround);
    simulation.bodies.forEach(({shape, size, color}, i) => {
        const key = `${shape} ${size}`;
        if (!known.has(key)) known.set(key, solids.push(solid_of(simulation.triangles(i), shape === 'sphere')) - 1);
        put(i + 1, known.get(key), i, color);
    });
    return {
        solids, palette: kPalette, times: new Float32Array([0]), parts: {count: count + 1, numbers, poses},
        carriers: first_moment(simulation), joints: {count: 0, carriers: new Int32Array(0), anchors: new Float32Array(0)},
        contacts: {starts: new Uint32Array(0)},
    };
}

// The poses at the beginning as a recording has them; of what is not yet seen, in the middle.
function first_moment(simulation) {
    const count = simulation.bodies.length, now = simulation.poses();
    const seen = Array.from({length: count}, (_, i) => i).filter(i => simulation.is_seen(i));
    const middle = [0, 1, 2].map(k => seen.reduce((sum, i) => sum + now[7 * i + k], 0) / seen.length);
    const numbers = new Int32Array(4 * count), frames = new Float32Array(6 * count), turns = new Int16Array(4 * count);
    for (let i = 0; i < count; ++i) {
        numbers.set([i, 0, 1, i], 4 * i);
        frames.set(simulation.is_seen(i) ? now.slice(7 * i, 7 * i + 3) : middle, 6 * i);
        turns.set([32767, 0, 0, 0], 4 * i);
    }
    return {count, lives: [], numbers, frames, positions: new Uint16Array(3 * count), turns};
}

export class LivePoses extends Poses {
    constructor(recording, simulation) {
        super(recording);
        this.simulation = simulation;
    }
    go_to() {
        this.values.set(this.simulation.poses());
        for (let i = 0; i < this.alive.length; ++i) this.alive[i] = this.simulation.is_seen(i) ? 1 : 0;
    }
}
