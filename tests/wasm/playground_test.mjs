// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The playground's scenes without a browser: node --test playground_test.mjs, with EPODE_WEB=the folder that has epode_robots.wasm and
// EPODE_PACKAGE=that of the npm package.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {test} from 'node:test';
import {with_aliases} from '../../wasm/playground/src/robot_files.mjs';
import {link_of, read_link} from '../../wasm/playground/src/link.mjs';
import {scenes} from '../../wasm/playground/src/scenes/all.mjs';
import {choose, robot} from '../../wasm/playground/src/scenes/robot.mjs';
import {kMethods, Simulation, values_of} from '../../wasm/playground/src/simulation.mjs';

const {load} = await import(`${process.env.EPODE_PACKAGE}/lib/index.mjs`);
const messages = [], engine = await load({source: await readFile(`${process.env.EPODE_WEB}/epode_robots.wasm`), onMessage: text => messages.push(text)});
const names = Object.keys(scenes);

function with_scene(scene, given, use, method) {
    const simulation = new Simulation(engine, scene, given, method);
    try {
        return use(simulation);
    } finally {
        simulation.destroy();
    }
}
function run(simulation, seconds, each = () => {}) {
    for (const end = simulation.time + seconds; simulation.time < end - 1e-9;) {
        simulation.step();
        each();
    }
    return simulation;
}
const is_sound = ({bodies}) => bodies.every(body => [...body.position, ...body.linearVelocity].every(Number.isFinite));
const lowest = simulation => Math.min(...simulation.bodies.map(body => body.position[2]));
const floor_of = scene => ({boats: -4, buggy: -4}[scene] ?? 0);

for (const scene of names) {
    test(`${scene}: six seconds in which nothing sinks, flies off or makes energy of nothing`, () => with_scene(scene, {}, simulation => {
        const has_motor = ['buggy', 'quadruped', 'robot', 'drum', 'boats'].includes(scene);
        let first = null, balls = 0, gained = 0;
        run(simulation, 6, () => {
            const {kinetic, potential} = simulation.energy(), all = kinetic + potential;
            assert.ok(Number.isFinite(all), `energy ${all} at ${simulation.time}`);
            if (simulation.bodies.length !== balls) [first, balls] = [all, simulation.bodies.length];  // thrown, or broken off
            gained = Math.max(gained, all - first);
        });
        assert.ok(is_sound(simulation));
        assert.ok(lowest(simulation) > floor_of(scene) - 0.02, `${scene}: a body is at ${lowest(simulation)}`);
        assert.ok(has_motor || gained < 0.03 * Math.abs(first) + 20, `${scene}: ${gained} J more than ${first}`);
        assert.deepEqual(messages.splice(0), []);
    }));

    test(`${scene}: every slider at both of its ends, with every stepper`, () => {
        const {sliders} = scenes[scene];
        for (const [name, {low, high}] of Object.entries(sliders)) {
            for (const value of [low, high]) with_scene(scene, {[name]: value}, simulation => {
                run(simulation, 0.4);
                assert.ok(is_sound(simulation), `${name} = ${value}`);
                assert.deepEqual(simulation.poses().findIndex(x => !Number.isFinite(x)), -1);
            }, kMethods[value === low ? 1 : 3]);
        }
        with_scene(scene, {}, simulation => assert.ok(is_sound(run(simulation, 0.15))), 'exact');
        assert.deepEqual(messages.splice(0), []);
    });
}

test('links say what was chosen, and what they say wrongly is the default', () => {
    const chosen = {scene: 'pile', values: {...values_of('pile'), count: 300, bounce: 0.5}, method: 'quick'};
    assert.equal(link_of(chosen), '#scene=pile&count=300&bounce=0.5&stepper=quick');
    assert.deepEqual(read_link(link_of(chosen)), chosen);
    assert.deepEqual(read_link('#scene=nothing&stepper=toString'), {scene: 'wall', values: values_of('wall'), method: 'hybrid'});
    assert.equal(read_link('#scene=pile&count=1e9').values.count, 600);
    assert.equal(read_link('#scene=pile&count=many').values.count, 200);
    assert.equal(read_link('#scene=__proto__').scene, 'wall');
});

test('the ball breaks the wall, which stands until it comes', () => with_scene('wall', {}, simulation => {
    const bricks = [...simulation.bodies], away = () => bricks.filter(body => Math.abs(body.position[0]) > 0.1).length;
    run(simulation, 0.7);
    assert.equal(away(), 0);
    run(simulation, 2);
    assert.ok(away() >= 3, `${away()} bricks moved`);
}));

test('the tower is one body until cannon balls break it, and then its bricks are drawn where they are', () => with_scene('tower', {}, simulation => {
    const {generation} = simulation;
    run(simulation, 0.5);
    assert.equal(simulation.bodies.length, 1);
    run(simulation, 4);
    assert.ok(simulation.bodies.length > 8, `${simulation.bodies.length} bodies`);
    assert.ok(simulation.generation > generation);
    assert.equal(simulation.poses().length, 7 * simulation.bodies.length);
}));

test('the robot walks forward, backwards, and does not fall', () => {
    for (const stride of [0.1, -0.1]) with_scene('quadruped', {stride}, simulation => {
        const trunk = simulation.hooks.follow;
        run(simulation, 6);
        assert.ok(trunk.position[0] * Math.sign(stride) > 0.4, `stride ${stride}: ${trunk.position[0]} m`);
        assert.ok(trunk.position[2] > 0.28 && trunk.vectorToWorld([0, 0, 1])[2] > 0.9, `at ${trunk.position}`);
    });
});

const models = new URL('../robots/models/', import.meta.url), read = async name => new Uint8Array(await readFile(new URL(name, models)));

test('the arm goes where its sliders say, and a slider is taken as it runs', () => with_scene('robot', {}, simulation => {
    const {robot: arm} = simulation.hooks, joint = name => arm.positions[arm.model.joints[arm.model.findJoint(name)].position];
    run(simulation, 3);
    assert.ok(Math.abs(joint('elbow') - simulation.values.u2) < 0.1, `elbow at ${joint('elbow')}`);
    assert.ok(simulation.set('u0', 1.2));
    run(simulation, 3);
    assert.ok(Math.abs(joint('turn') - 1.2) < 0.05, `turned to ${joint('turn')}`);
}));

test('a robot with actuators has a slider a joint, too, which puts it there as it runs', async () => {
    const before = {...robot};
    choose(engine);
    const labels = Object.entries(robot.sliders).filter(([name]) => name[0] === 'p').map(([, {label}]) => label);
    assert.deepEqual(labels, ['turn, rad', 'shoulder, rad', 'elbow, rad', 'wrist, rad', 'left, m', 'right, m']);
    with_scene('robot', {}, simulation => {
        const {robot: arm} = simulation.hooks, joint = arm.model.findJoint('elbow'), {position} = arm.model.joints[joint];
        run(simulation, 0.5);
        const rates = [...arm.velocities];
        assert.ok(simulation.set(`p${joint}`, 0.4));
        assert.ok(Math.abs(arm.positions[position] - 0.4) < 1e-6);
        rates.forEach((rate, i) => assert.ok(Math.abs(arm.velocities[i] - rate) < 1e-4, `rate ${i}`));
        assert.ok(is_sound(run(simulation, 0.5)));
    });
    Object.assign(robot, before);
    messages.splice(0);
});

test('a blow gives a body the momentum of its mass at a speed, and turns it about its centre', () => with_scene('wall', {}, simulation => {
    const [body] = simulation.bodies, {mass, inertia} = body.massProperties, before = [...body.linearVelocity], point = body.position.map((x, k) => x + [0, 0.1, 0.2][k]);
    simulation.strike(body, point, [2, 0, 0], 1.5);
    assert.ok(Math.abs(body.linearVelocity[0] - before[0] - 1.5) < 1e-5);
    const w = body.vectorFromWorld(body.angularVelocity), moment = [0, 3, 6].map(row => inertia.slice(row, row + 3).reduce((sum, x, k) => sum + x * w[k], 0));
    body.vectorToWorld(moment).forEach((x, k) => assert.ok(Math.abs(x - mass * 1.5 * [0, 0.2, -0.1][k]) < 1e-3 * mass, `${k}: ${x}`));
}));

test('a robot of a URDF without actuators gets a slider a joint, stands on the floor, and its meshes are found without their folders', async () => {
    const before = {...robot}, files = with_aliases(new Map([['arm.urdf', await read('arm.urdf')], ['cube.stl', await read('meshes/cube.stl')]]));
    assert.deepEqual([...files.keys()], ['arm.urdf', 'cube.stl', 'models/meshes/cube.stl']);
    choose(engine, files, {path: 'arm.urdf', fixedBase: true, inertiaFromShapes: true});
    assert.deepEqual(Object.values(robot.sliders).map(({label}) => label), ['shoulder, rad', 'elbow, rad', 'left_slide, m', 'right_slide, m']);
    with_scene('robot', {q0: -1, q1: 0.5}, simulation => {
        run(simulation, 2);
        assert.ok(is_sound(simulation) && lowest(simulation) >= 0);  // the base's origin is on the floor
        const [shoulder, elbow] = simulation.hooks.robot.positions;
        assert.ok(Math.abs(shoulder + 1) < 0.15 && Math.abs(elbow - 0.5) < 0.15, `${shoulder}, ${elbow}`);
    });
    const {sliders} = robot;
    assert.throws(() => choose(engine, new Map([['bad.urdf', new TextEncoder().encode('<robot name="r">\n<link/></robot>')]])), /^RobotError?|bad\.urdf:2: /);
    assert.equal(robot.sliders, sliders);
    with_scene('robot', {}, simulation => assert.ok(is_sound(run(simulation, 0.1))));
    choose(engine);
    Object.assign(robot, before);
    messages.splice(0);
});

test('the buggy keeps to its circle and stays on its wheels', () => with_scene('buggy', {}, simulation => {
    const chassis = simulation.hooks.follow;
    run(simulation, 3);
    run(simulation, 12, () => assert.ok(chassis.vectorToWorld([0, 0, 1])[2] > 0.5));
    const away = Math.hypot(chassis.position[0], chassis.position[1]);
    assert.ok(Math.abs(away - 16) < 6, `${away} m from the middle`);
    assert.ok(Math.abs(chassis.vehicle.report.speed) > 1);
}));

test('all dominoes fall, one after the other', () => with_scene('dominoes', {count: 60}, simulation => {
    run(simulation, 20);
    assert.equal(simulation.bodies.filter(body => body.position[2] > 0.49).length, 0);
}));

test('the arch stands as it is, and not when it is thin or smooth', () => {
    const crown = given => with_scene('arch', given, simulation => {
        const stone = simulation.bodies[7];
        run(simulation, 1.1);
        return stone.position[2];
    });
    assert.ok(crown({}) > 1.8, `${crown({})}`);
    assert.ok(crown({thick: 0.2}) < 1.7 || crown({friction: 0.1}) < 1.7);
});

test('as many balls of the cradle leave as arrive', () => {
    for (const raised of [1, 2]) with_scene('cradle', {raised}, simulation => {
        const heights = simulation.bodies.map(body => body.position[2]), rest = Math.min(...heights), top = simulation.bodies.map(() => 0);
        run(simulation, 2, () => simulation.bodies.forEach((body, i) => { top[i] = Math.max(top[i], body.position[2] - rest); }));
        top.forEach((height, i) => assert.ok(i < raised || i >= 5 - raised ? height > 0.2 : height < 0.08, `ball ${i} rose by ${height} of ${top}`));
    });
});

test('the hand pulls a body to where it is and lets go', () => with_scene('pile', {count: 20}, simulation => {
    run(simulation, 3);
    const body = simulation.bodies[0];
    simulation.grab(body, body.position);
    simulation.move_hand([0, 0, 3]);
    run(simulation, 2);
    assert.ok(Math.abs(body.position[2] - 3) < 0.2, `at ${body.position[2]}`);
    assert.equal(simulation.poses().length, 7 * 20);
    simulation.release();
    run(simulation, 3);
    assert.ok(body.position[2] < 1.5);
}));

test('many balls: the oldest end', () => with_scene('bridge', {}, simulation => {
    const before = simulation.bodies.length;
    for (let i = 0; i < 30; ++i) simulation.throw_ball([0, -6, 3], [0, 15, 1]), run(simulation, 0.1);
    assert.equal(simulation.bodies.length, before + 24);
    assert.ok(is_sound(simulation));
}));

test('a scene that has ended leaves no memory behind', () => {
    const round = () => names.forEach(scene => with_scene(scene, {}, simulation => run(simulation, 0.1)));
    round();
    round();
    const size = engine.memorySize;
    for (let i = 0; i < 5; ++i) round();
    assert.ok(engine.memorySize <= size + 2 ** 20, `${(engine.memorySize - size) / 1024} kB more`);
    assert.equal(engine.objects.size, 0);
});

test('tops stand on their tips, lean and precess: friction at a tip takes little of the spin', () => with_scene('tops', {}, simulation => {
    const axis = () => simulation.bodies[0].vectorToWorld([0, 0, 1]), turned = new Set();
    run(simulation, 5, () => turned.add(Math.floor(2 * Math.atan2(axis()[1], axis()[0]) / Math.PI)));
    for (const top of simulation.bodies) {
        const w = top.angularVelocity, [, , up] = top.vectorToWorld([0, 0, 1]);
        assert.ok(Math.hypot(...w) > 57 && up > 0.9 && up < 0.99, `${Math.hypot(...w)} rad/s, ${up}`);
    }
    assert.equal(turned.size, 4, 'the axis has looked into each quarter');
}));
