// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The page's worlds without a browser: node --test page_test.mjs, with EPODE_WEB=the folder that has epode.mjs.
import assert from 'node:assert/strict';
import {test} from 'node:test';
import {Simulation, scenes} from '../../wasm/page/src/simulation.mjs';

const {load} = await import(`${process.env.EPODE_WEB}/epode.mjs`);
const ode = await load();

function run(simulation, seconds) {
    for (let i = 0; i < 60 * seconds; ++i) assert.equal(simulation.step(), 1);
    return Float64Array.from(simulation.poses());
}
const heights = (simulation, poses) => simulation.bodies.slice(0, simulation.balls.first).map((_, i) => poses[7 * i + 2]);
const awake = simulation => simulation.bodies.filter(({body}) => ode.dBodyIsEnabled(body)).length;

test('every scene has shapes to draw, and comes to rest above the ground', () => {
    for (const name of Object.keys(scenes)) {
        const simulation = new Simulation(ode, name);
        for (let i = 0; i < simulation.bodies.length; ++i) assert.ok(simulation.triangles(i).length >= 12 * 9, name);
        const poses = run(simulation, 10);
        assert.ok(poses.every(Number.isFinite), name);
        assert.ok(Math.min(...heights(simulation, poses)) > 0.05, name);
        assert.ok(awake(simulation) <= 10, `${name}: ${awake(simulation)} bodies awake`);
        simulation.destroy();
    }
});

test('the wall stands until a ball hits it', () => {
    const simulation = new Simulation(ode, 'wall');
    const top = poses => Math.max(...heights(simulation, poses));
    assert.ok(Math.abs(top(run(simulation, 3)) - 2.85) < 0.02);
    assert.equal(simulation.is_seen(simulation.balls.first), false);
    simulation.throw_ball([8, 0, 1.5], [-20, 0, 2]);
    assert.equal(simulation.is_seen(simulation.balls.first), true);
    const hit = run(simulation, 4);
    const moved = heights(simulation, hit).filter((_, i) => Math.abs(hit[7 * i]) > 0.1).length;
    assert.ok(moved >= 3, `${moved} bricks moved`);
    simulation.destroy();
});

test('the bridge carries its load, its hinges closed', () => {
    const simulation = new Simulation(ode, 'bridge');
    const poses = run(simulation, 6), z = heights(simulation, poses);
    assert.ok(Math.min(...z.slice(0, 16)) > 1.5);
    for (let i = 1; i < 16; ++i) {
        const gap = Math.hypot(...[0, 1, 2].map(k => poses[7 * i + k] - poses[7 * (i - 1) + k]));
        assert.ok(gap < 0.52, `planks ${i - 1} and ${i} are ${gap} m apart`);
    }
    simulation.destroy();
});

test('balls are thrown again in turn', () => {
    const simulation = new Simulation(ode, 'pile');
    for (let i = 0; i < 25; ++i) simulation.throw_ball([5, 0, 3], [-10, 0, 0]), run(simulation, 0.2);
    assert.ok(run(simulation, 1).every(Number.isFinite));
    simulation.destroy();
});
