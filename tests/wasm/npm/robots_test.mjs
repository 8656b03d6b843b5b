// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots of the npm package, in the folder where it is installed: node --test robots_test.mjs, with EPODE_ROOT=the tree and
// EPODE_NATIVE_ROBOT=the program of native_robot.c.
import assert from 'node:assert/strict';
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {test} from 'node:test';
import {EpodeError, load, RobotError} from 'epode';

const root = process.env.EPODE_ROOT, messages = [], engine = await load({robots: true, onMessage: text => messages.push(text)}), {robots} = engine;
const kStep = 0.002, models = `${root}/tests/robots/models`;
const files_of = (folder, ...names) => Object.fromEntries(names.map(name => [name, new Uint8Array(readFileSync(`${folder}/${name}`))]));
const kRobots = {
    arm: {file: `${models}/arm.urdf`, path: 'models/arm.urdf', height: 0,
          files: Object.fromEntries(Object.entries(files_of(models, 'arm.urdf', 'meshes/cube.stl')).map(([name, bytes]) => [`models/${name}`, bytes]))},
    walker: {file: `${models}/walker.xml`, height: 1.5, files: files_of(models, 'walker.xml', 'walker_defaults.xml', 'meshes/cube.obj')},
    hand: {file: `${models}/hand.xml`, height: 0.5, files: files_of(models, 'hand.xml')},
    seven: {file: `${root}/demos/robots/arm.urdf`, height: 0, files: {'arm.urdf': readFileSync(`${root}/demos/robots/arm.urdf`, 'utf8')}},
};

function with_world(use, options = {preset: 'robot'}) {
    const world = engine.createWorld(options);
    try {
        return use(world);
    } finally {
        world.destroy();
    }
}
function with_model(files, use, options = {}) {
    const model = robots.load(files, options);
    try {
        return use(model);
    } finally {
        model.destroy();
    }
}
const near = (value, wanted, tolerance, why = '') => assert.ok(Math.abs(value - wanted) <= tolerance, `${why} ${value} is not ${wanted}`);

// As native_robot.c has it.
function wave(step, i) {
    const at = (step + 37 * i) % 400;
    return (at < 200 ? at - 100 : 300 - at) / 128;
}
function drive(robot, step) {
    const {actuators, joints} = robot.model;
    actuators.forEach((_, i) => robot.setControl(i, wave(step, i)));
    if (actuators.length === 0)
        joints.forEach(({kind}, i) => { if (kind === 'hinge' || kind === 'slide') robot.setTarget(i, wave(step, i) / 4, {stiffness: 64, damping: 4}); });
}

for (const [name, {file, path, height, files}] of Object.entries(kRobots)) {
    test(`${name}: 500 steps have the bits of a native program`, {skip: !process.env.EPODE_NATIVE_ROBOT}, () => with_world(world => with_model(files, model => {
        const folder = mkdtempSync(join(tmpdir(), 'epode-')), states = join(folder, 'states');
        world.createGeom('plane', {normal: [0, 0, 1]});
        const robot = model.build(world, {position: [0, 0, height]});
        for (let i = 0; i < 500; ++i) {
            drive(robot, i);
            robot.addForces(kStep);
            world.step(kStep);
        }
        execFileSync(process.env.EPODE_NATIVE_ROBOT, [file, String(height), '500', states], {stdio: ['ignore', 'ignore', 'ignore']});
        assert.equal(Buffer.compare(readFileSync(states), world.saveState()), 0);
        assert.ok(robot.positions.some((x, i) => Math.abs(x - model.reference[i]) > 1e-3), 'it has moved');
        rmSync(folder, {recursive: true});
    }, path ? {path} : {})));
}

test('an engine without robots says how to get them', async () => {
    const plain = await load();
    assert.throws(() => plain.robots, error => error instanceof EpodeError && /load\(\{robots: true\}\)/.test(error.message));
});

test('a model says its links, joints, actuators and poses by the names of the file', () => with_model(kRobots.walker.files, model => {
    assert.deepEqual(model.links.slice(1).map(({name}) => name), ['trunk', 'thigh', 'foot', 'tail', 'ball']);
    assert.deepEqual(model.joints.map(({name, kind}) => `${name} ${kind}`), ['lift slide', 'pitch hinge', 'hip hinge', 'ankle hinge', 'tail ball', 'ball free']);
    assert.deepEqual(model.actuators.map(({name, joint, low, high}) => [name, joint, low, high]),
                     [['hip_motor', 2, -1, 1], ['lift_servo', 0, -Infinity, Infinity], ['tendon_motor', -1, -Infinity, Infinity]]);
    assert.deepEqual([model.starts.length, model.starts[0].name, model.starts[0].positions.length], [1, 'up', model.positionCount]);
    assert.deepEqual([model.positionCount, model.velocityCount], [4 + 4 + 7, 4 + 3 + 6]);
    assert.deepEqual(model.gravity, [0, 0, -10]);
    assert.deepEqual([model.findJoint('hip'), model.findLink('foot'), model.findActuator('nobody')], [2, 3, -1]);
    near(model.links[1].mass, 4, 1e-12);
    const pose = model.poses(model.reference);
    assert.deepEqual([...pose.slice(7, 10)], [0, 0, 0.5]);
    const mass = model.massMatrix(model.reference), n = model.velocityCount;
    near(mass[0], model.links.slice(1, 5).reduce((sum, link) => sum + link.mass, 0), 1e-9, 'the slider moves all');
    for (let i = 0; i < n; ++i) for (let k = 0; k < i; ++k) near(mass[i * n + k], mass[k * n + i], 1e-9);
}));

test('positions, velocities and controls are set and read; a motor turns its joint by torque over inertia', () => with_world(world => {
    const text = `<mujoco><worldbody><body><joint name="turn" axis="0 0 1"/><geom type="box" size="0.3 0.1 0.1" mass="3"/></body></worldbody>
        <actuator><motor name="motor" joint="turn" ctrlrange="-2 2"/></actuator></mujoco>`;
    with_model(text, model => {
        const robot = model.build(world, {positions: [0.25]}), inertia = 3 / 12 * (0.6 ** 2 + 0.2 ** 2);
        near(robot.positions[0], 0.25, 1e-12);
        robot.velocities = [0.5];
        near(robot.velocities[0], 0.5, 1e-12);
        robot.setControl('motor', 5);
        assert.equal(robot.control(0), 2);
        for (let i = 0; i < 500; ++i) world.step(kStep);
        near(robot.velocities[0], 0.5 + 2 / inertia, 1e-3 * 2 / inertia);
        robot.positions = [1];
        near(robot.positions[0], 1, 1e-12);
        near(robot.linkPoses[7 + 3], Math.cos(0.5), 1e-12);
        robot.controls = [-0.5];
        assert.deepEqual([...robot.controls], [-0.5]);
        assert.throws(() => robot.body('nobody2'), error => error.kind === 'refused');
    });
}));

test('what is wrong in a file throws with its line, and nothing is left', () => {
    const wrong = [
        ['<robot name="r">\n<link name="a"/>\n<link name="a"/></robot>', /^robot\.xml:3: /, /'?a'?/],
        ['<mujoco>\n<worldbody>\n<body>\n<geom type="box" size="1"/></body></worldbody></mujoco>', /^robot\.xml:\d+: /, /./],
        ['<mujoco><worldbody></mujoco>', /^robot\.xml: /, /line 1/],
        ['<scene/>', /root element is <scene>/, /URDF/],
        ['no markup at all', /^robot\.xml/, /./], ['', /^robot\.xml/, /./],
        ['<mujoco><include file="gone.xml"/></mujoco>', /gone\.xml/, /not to be found/],
    ];
    for (const [text, first, second] of wrong) {
        assert.throws(() => robots.load(text), error => error instanceof RobotError && first.test(error.message) && second.test(error.message) &&
            error.report.some(({note}) => note === 'error'), text);
    }
    assert.deepEqual(messages.splice(0), []);
});

test('files that are damaged throw, whatever was done to them', () => {
    let state = 12345;
    const random = below => (state = Math.imul(state, 1664525) + 1013904223 >>> 0, Math.floor(state / 2 ** 32 * below));
    const glb = new Uint8Array(readFileSync(`${models}/meshes/tetrahedra.glb`)), names = Object.keys(kRobots);
    for (let round = 0; round < 300; ++round) {
        const {files, path} = kRobots[names[round % names.length]], hurt = {};
        for (const [name, content] of Object.entries(files)) {
            const bytes = typeof content === 'string' ? new TextEncoder().encode(content) : content.slice();
            for (let k = random(4); k > 0; --k) bytes[random(bytes.length)] = random(256);
            hurt[name] = random(6) === 0 ? bytes.slice(0, random(bytes.length)) : bytes;
        }
        if (round % 5 === 0) hurt['models/meshes/cube.stl'] = glb.slice(0, random(glb.length));
        try {
            robots.load(hurt, {path: path ?? Object.keys(files)[0]}).destroy();
        } catch (error) {
            assert.ok(error instanceof EpodeError, error);
        }
    }
    messages.splice(0);
    with_model(kRobots.walker.files, model => assert.equal(model.joints.length, 6));
});

test('wrong arguments throw and change nothing', () => with_world(world => with_model(kRobots.walker.files, model => {
    const robot = model.build(world), before = [...robot.positions], count = world.bodies.length;
    assert.equal(count, 6, 'five links, and one between the two joints of the first');
    for (const call of [
        () => robots.load(5), () => robots.load(null), () => robots.load({'a.urdf': 7}), () => robots.load('<robot/>', {colour: 1}),
        () => robots.load('<robot/>', {strict: 1}), () => robots.load('<robot/>', {meshes: 'soup'}), () => robots.load({'../a.urdf': ''}),
        () => robots.load({'a.stl': '', 'b.stl': ''}), () => robots.load(kRobots.walker.files, {path: 'nobody.xml'}),
        () => robot.setControl(3, 1), () => robot.setControl('hip', 1), () => robot.setControl(0, NaN), () => robot.setTarget(4, 0, {stiffness: 1, damping: 1}),
        () => robot.setTarget(0, 0, {stiffness: -1, damping: 1}), () => { robot.positions = [1]; }, () => { robot.positions = before.map(() => NaN); },
        () => { robot.positions = before.map(() => Infinity); }, () => { robot.velocities = 'fast'; }, () => { robot.state = [1, 2]; },
        () => robot.addForces(0), () => robot.addForces('x'), () => model.build({}), () => model.build(world, {position: [1, 2]}),
        () => model.build(world, {quaternion: [0, 0, 0, 0]}), () => model.build(world, {positions: [1]}), () => robot.body(99), () => robot.joint(-1),
    ]) assert.throws(call, error => error instanceof TypeError || error instanceof EpodeError, String(call));
    assert.deepEqual([...robot.positions], before);
    assert.equal(world.bodies.length, count);
    robot.destroy();
    assert.equal(world.bodies.length, 0);
    assert.throws(() => robot.positions, error => error.kind === 'destroyed');
    assert.throws(() => robot.body(1), error => error.kind === 'destroyed');
    assert.deepEqual(messages.splice(0).filter(text => !/is not built/.test(text)), []);
})));

test('the main file is the one that no other includes', () => {
    assert.deepEqual(robots.mainFiles({'a/scene.xml': '<mujoco><include file="robot.xml"/></mujoco>', 'a/robot.xml': '<!-- x --><mujoco/>', 'a/b.obj': ''}), ['a/scene.xml']);
    assert.throws(() => robots.load({'a.urdf': '<robot/>', 'b.urdf': '<robot/>'}), /path must say/);
});

test('a robot goes on with the same bits from the states of its world and itself', () => with_world(world => with_model(kRobots.hand.files, model => {
    const robot = model.build(world, {position: [0, 0, 1]}), run = () => { for (let i = 0; i < 50; ++i) drive(robot, i), robot.addForces(kStep), world.step(kStep); };
    run();
    const kept = [world.saveState(), robot.state];
    run();
    const after = world.saveState();
    world.loadState(kept[0]);
    robot.state = kept[1];
    run();
    assert.equal(Buffer.compare(world.saveState(), after), 0);
})));

test('many robots made and destroyed leave no memory behind', () => {
    const round = () => with_world(world => with_model(kRobots.walker.files, model => { for (let i = 0; i < 3; ++i) model.build(world, {position: [i, 0, 0]}); }));
    for (let i = 0; i < 10; ++i) round();
    const size = engine.memorySize;
    for (let i = 0; i < 100; ++i) round();
    assert.ok(engine.memorySize <= size + 2 ** 20, `${(engine.memorySize - size) / 1024} kB more`);
    messages.splice(0);
});
