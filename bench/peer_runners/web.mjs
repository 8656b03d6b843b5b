// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the runners under Node share, as common.py does for those in Python: a runner reads a scene that `epode_bench export` has written,
// steps it, writes states for `epode_bench judge` after each eighth of the run, and prints its time, that of the process's own work
// around the one call that steps.
import { readFileSync, writeFileSync } from 'node:fs';

const SAMPLES = 8, kWarmUp = 60;
const scene = JSON.parse(readFileSync(process.argv[2]));

export function refuse(why) {
    console.log(JSON.stringify({ refused: why }));
    process.exit(0);
}

// The scene, if a runner of solids and joints can have it.
export function readScene() {
    if (scene.task !== 'simulate') refuse('this runner times neither rays nor the broad phase alone');
    if (scene.bodies.some((b) => b.group)) refuse('this runner knows no groups of bodies that pass through one another');
    if (scene.joints.some((j) => j.kind === 'hinge2')) refuse('this runner has no hinge-2');
    return scene;
}

// Quaternions are w, x, y, z.
export function product([w, a, b, c], [s, x, y, z]) {
    return [w * s - a * x - b * y - c * z, w * x + s * a + b * z - c * y, w * y + s * b + c * x - a * z,
        w * z + s * c + a * y - b * x];
}

export const inverse = ([w, x, y, z]) => [w, -x, -y, -z];

export function rotate(q, v) {
    return product(product(q, [0, ...v]), inverse(q)).slice(1);
}

export function turn(axis, angle) {
    const size = Math.hypot(...axis);
    return [Math.cos(angle / 2), ...axis.map((x) => (x * Math.sin(angle / 2)) / size)];
}

// The pose of a driven body at a time.
export function driven(body, at) {
    const { axis_point: centre, orbit, spin } = body.drive;
    const pos = rotate(turn([0, 0, 1], orbit * at), body.pos.map((x, k) => x - centre[k])).map((x, k) => x + centre[k]);
    const rate = Math.hypot(...spin);
    return { pos, turn: rate ? product(turn(spin, rate * at), body.turn) : body.turn };
}

// One run: `write(step, states)` after each eighth. The time of the process's own work in the steps, ms.
function run({ step, states }, steps, write) {
    let spent = 0;
    for (let i = 1; i <= steps; ++i) {
        const start = process.cpuUsage();
        step(i * scene.dt);
        const used = process.cpuUsage(start);
        spent += (used.user + used.system) / 1000;
        if (Math.floor((i * SAMPLES) / scene.steps) !== Math.floor(((i - 1) * SAMPLES) / scene.steps)) write(i, states());
    }
    return spent;
}

// begin() builds the scene's world and returns {step, states, end}: step(at) advances to the time `at`; states() has the numbers of each body:
// position, quaternion, linear and angular velocity; end() destroys the world. Node compiles a function of WebAssembly at its first call
// (all of them at once would take longer than most runs): a first world, which does not count, calls them.
export function play(version, begin) {
    let written = '';
    const first = begin();
    run(first, Math.min(scene.steps, kWarmUp), () => {});
    first.end();
    const spent = run(begin(), scene.steps, (i, lines) => { written += `state ${i}\n${lines.map((line) => line.join(' ')).join('\n')}\n`; });
    writeFileSync(process.argv[3], written);
    console.log(JSON.stringify({ version, ms: spent / scene.steps }));
}

// The version of a package of npm.
export const versionOf = (name) => JSON.parse(readFileSync(new URL(`node_modules/${name}/package.json`, import.meta.url))).version;
