// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The npm package by its physics, in the folder where it is installed: node --test package_test.mjs, with EPODE_ROOT=the tree.
import assert from 'node:assert/strict';
import {readFileSync} from 'node:fs';
import {test} from 'node:test';
import {Body, EpodeError, Hinge, load, Sphere} from 'epode';

const engine = await load();
const near = (value, wanted, tolerance, why) => assert.ok(Math.abs(value - wanted) <= tolerance, `${why ?? ''} ${value} is not ${wanted}`);
const steps = (world, count, h = 1 / 60, each = () => {}) => {
    for (let i = 0; i < count; ++i) {
        each(i);
        world.step(h);
    }
};
function with_world(options, use) {
    const world = engine.createWorld(options);
    try {
        return use(world);
    } finally {
        world.destroy();
    }
}
const floor = world => world.createGeom('plane', {normal: [0, 0, 1]});
const same = (a, b) => Buffer.compare(a, b) === 0;

test('a ball bounces to the height that its restitution says and comes to rest on its radius', () => with_world({}, world => {
    floor(world);
    const ball = world.createBody({position: [0, 0, 2.5]});
    ball.createGeom('sphere', {radius: 0.5, material: {bounce: 0.7}});
    near(ball.mass, 1000 * 4 / 3 * Math.PI / 8, 1e-9);
    let top = 0, touched = false;
    steps(world, 150, 1 / 120, () => {
        touched ||= world.contacts.length > 0;
        if (touched && ball.linearVelocity[2] > 0) top = Math.max(top, ball.position[2]);
    });
    near(top - 0.5, 0.49 * 2, 0.05, 'height of the bounce');
    steps(world, 600);
    near(ball.position[2], 0.5, 2e-3);  // contacts overlap by the preset's surface layer
    assert.equal(ball.enabled, false);
}));

test('the pile of web_pile_test.cpp has the bits of native programs', () => with_world({}, world => {
    const root = process.env.EPODE_ROOT, wanted = /"physics\/web_pile", 0x([0-9a-f]+)/.exec(readFileSync(`${root}/tests/golden/physics.inc`, 'utf8'))[1];
    floor(world);
    const bodies = Array.from({length: 80}, (_, i) => {
        const body = world.createBody();
        if (i % 3 === 0) body.createGeom('sphere', {radius: 0.25, density: 500});
        else body.createGeom('box', {lengths: [0.5, 0.4, 0.3], density: 500});
        body.position = [0.55 * (i % 4) + 0.03125 * (i % 5), 0.55 * (Math.floor(i / 4) % 4), 0.5 + 0.5 * Math.floor(i / 16)];
        return body;
    });
    steps(world, 200);
    const states = world.createStates(bodies, ['position', 'quaternion', 'linearVelocity', 'angularVelocity']), rows = states.read();
    let hash = 0xcbf29ce484222325n;
    for (const byte of new Uint8Array(rows.buffer, rows.byteOffset, rows.byteLength)) hash = BigInt.asUintN(64, (hash ^ BigInt(byte)) * 0x100000001b3n);
    states.destroy();
    assert.equal(hash.toString(16).padStart(16, '0'), wanted);
}));

test('a pendulum has its period and keeps its energy', () => with_world({preset: 'robot'}, world => {
    const length = 1, angle = 0.1, bob = world.createBody({position: [length * Math.sin(angle), 0, -length * Math.cos(angle)]});
    bob.createGeom('sphere', {radius: 0.01, mass: 2});
    const hinge = world.createJoint('hinge', bob, null, {anchor: [0, 0, 0], axis: [0, 1, 0]});
    assert.ok(hinge instanceof Hinge);
    const crossings = [];
    for (let i = 0, last = bob.position[0]; i < 5000; ++i) {
        world.step(0.001, 'exact');
        const x = bob.position[0];
        if (last > 0 && x <= 0) crossings.push(i + last / (last - x));
        last = x;
    }
    // The inertia of the bob about its centre, and the next term of the amplitude.
    const wanted = 2 * Math.PI * Math.sqrt((length * length + 0.4 * 1e-4) / (9.81 * length)) * (1 + angle * angle / 16);
    near((crossings[1] - crossings[0]) / 1000, wanted, 1e-3 * wanted);
}));

test('a drive holds a hinge at its target, and the joint measures the torque', () => with_world({preset: 'robot'}, world => {
    const arm = world.createBody({position: [0.5, 0, 0]});
    arm.createGeom('box', {lengths: [1, 0.1, 0.1], mass: 3});
    const hinge = world.createJoint('hinge', arm, null, {anchor: [0, 0, 0], axis: [0, 1, 0], measures: true});
    hinge.setDrive(0, {stiffness: 1e5, damping: 1e3});
    steps(world, 2000, 0.002);
    near(hinge.getAxisPosition(0), 0, 1e-3);
    near(Math.abs(hinge.getDriveForce(0)), 3 * 9.81 * 0.5, 0.01);
    near(Math.hypot(...hinge.feedback.f1), 3 * 9.81, 0.01);
}));

test('a hammer has its centre of mass and inertia by the parallel axis theorem, and stays where it was made', () => with_world({gravity: [0, 0, 0]}, world => {
    const hammer = world.createBody({position: [1, 2, 3], quaternion: [Math.SQRT1_2, 0, 0, Math.SQRT1_2]});
    const handle = hammer.createGeom('box', {lengths: [1, 0.1, 0.1], mass: 1});
    const head = hammer.createGeom('box', {lengths: [0.2, 0.3, 0.2], mass: 4, offsetPosition: [0.6, 0, 0]});
    const {mass, inertia} = hammer.massProperties, bar = (a, b, m) => m * (a * a + b * b) / 12, middle = 4 * 0.6 / 5;
    near(mass, 5, 1e-12);
    near(inertia[8], bar(1, 0.1, 1) + bar(0.2, 0.3, 4) + 1 * middle ** 2 + 4 * (0.6 - middle) ** 2, 1e-12);
    [[handle.position, [1, 2, 3]], [head.position, [1, 2.6, 3]], [hammer.position, [1, 2 + middle, 3]]].forEach(([is, wanted]) =>
        is.forEach((x, i) => near(x, wanted[i], 1e-12)));
    hammer.mass = 10;
    near(hammer.massProperties.inertia[8], 2 * inertia[8], 1e-12);
}));

test('rays, casts, overlaps and distances have their closed forms', () => with_world({}, world => {
    const ground = floor(world), ball = world.createGeom('sphere', {radius: 1, position: [5, 0, 3]});
    const hit = world.rayClosest({x: 0, y: 0, z: 3}, [1, 0, 0]);
    assert.equal(hit.geom, ball);
    near(hit.distance, 4, 1e-9);
    hit.normal.forEach((x, i) => near(x, [-1, 0, 0][i], 1e-9));
    assert.equal(world.rayClosest([0, 0, 3], [-1, 0, 0]), null);
    assert.deepEqual(world.rayAll([5, 0, 10], [0, 0, -1]).map(one => one.geom), [ball, ground]);
    assert.deepEqual(world.rayAll([5, 0, 10], [0, 0, -1], 100, {accept: geom => geom !== ball}).map(one => one.geom), [ground]);
    assert.deepEqual([...world.rayDistances([0, 0, 3, 0, 0, 3, 0, 0, 3], [1, 0, 0, 0, 0, -1, 0, 0, 1])].map(x => Number(x.toFixed(9))), [4, 3, Infinity]);
    const box = world.createGeom('box', {lengths: [1, 1, 1], position: [0, 0, 3]});
    near(world.distance(box, ball).distance, 3.5, 1e-9);
    near(world.cast(box, [10, 0, 0]).distance, 3.5, 1e-6);
    assert.deepEqual(world.castAll(box, [10, 0, 0]).map(one => one.geom), [ball]);
    box.position = [4, 0, 3];
    assert.deepEqual(world.overlaps(box), [ball]);
    assert.throws(() => world.rayClosest([0, 0, 3], [1, 0, 0], 10, {accept: () => { throw new Error('mine'); }}), /^Error: mine$/);
    assert.equal(world.rayClosest([0, 0, 3], [1, 0, 0], 10).geom, box);
}));

test('a world finds what C functions have created and destroyed in it', () => with_world({}, world => {
    const {c} = engine, kept = world.createBody(), gone = world.createBody(), handle = c.dBodyCreate(world.handle);
    world.refresh();
    assert.deepEqual(world.bodies.map(body => body.handle), [kept.handle, gone.handle, handle]);
    assert.ok(world.bodies[2] instanceof Body);
    c.dBodyDestroy(gone.handle);
    world.refresh();
    assert.deepEqual(world.bodies.map(body => body.handle), [kept.handle, handle]);
    assert.ok(gone.isDestroyed && !kept.isDestroyed);
}));

test('an explosion gives impulses that fall off, and walls protect', () => with_world({gravity: [0, 0, 0]}, world => {
    const ball = x => {
        const body = world.createBody({position: [x, 0, 0]});
        body.createGeom('sphere', {radius: 0.1, mass: 1});
        return body;
    };
    const near_one = ball(1), behind = ball(-2);
    world.createGeom('box', {lengths: [0.1, 5, 5], position: [-1, 0, 0]});
    assert.equal(world.applyRadialImpulse([0, 0, 0], 4, 8, {occlusion: true}), 1);
    near(near_one.linearVelocity[0], 8 * (1 - 0.9 / 4), 1e-9);
    assert.deepEqual(behind.linearVelocity, [0, 0, 0]);
}));

test('events report impulses, sensors and broken joints; a filter lets pairs pass', () => with_world({}, world => {
    const ground = floor(world);
    world.eventSettings = {};
    const ball = world.createBody({position: [0, 0, 0.6]}), solid = ball.createGeom('sphere', {radius: 0.5, mass: 2});
    const zone = world.createGeom('box', {lengths: [4, 4, 1], position: [0, 0, 0.5], sensor: true}), found = [];
    steps(world, 30, 1 / 60, () => found.push(...world.events));
    const touch = found.find(event => event.kind === 'contactBegin'), entry = found.find(event => event.kind === 'sensorBegin');
    assert.deepEqual([touch.geom1, touch.geom2], [solid, ground]);
    near(touch.impulse, 2 * Math.sqrt(2 * 9.81 * 0.1), 0.7);
    assert.equal(entry.geom1, zone);
    near(world.contacts.reduce((sum, one) => sum + one.normalForce, 0), 2 * 9.81, 0.1, 'weight');
    world.setContactFilter((a, b) => a !== solid && b !== solid);
    ball.position = [0, 0, 2];
    ball.enabled = true;
    steps(world, 120);
    assert.ok(ball.position[2] < -1);
    world.setContactFilter(() => { throw new Error('mine'); });
    world.createBody({position: [5, 0, 0.6]}).createGeom('sphere', {radius: 0.5});
    assert.throws(() => steps(world, 10), /^Error: mine$/);
    world.setContactFilter(null);
    steps(world, 1);
}));

test('states, snapshots, differences, clones and files go on with the same bits', () => with_world({}, world => {
    floor(world);
    const bodies = Array.from({length: 12}, (_, i) => {
        const body = world.createBody({position: [0.1 * i, 0, 1 + i]});
        body.createGeom(i % 2 ? 'box' : 'capsule', i % 2 ? {lengths: [1, 0.8, 0.6]} : {radius: 0.3, length: 0.5});
        body.userData = i;
        return body;
    });
    world.createJoint('ball', bodies[0], bodies[1], {anchor: [0.05, 0, 1.5]});
    steps(world, 50);
    const state = world.saveState(), kept = world.snapshot(), copy = world.clone(), loaded = engine.loadWorld(world.save());
    assert.deepEqual(copy.bodies.map(body => body.userData), bodies.map((_, i) => i));
    assert.equal(loaded.geoms.length, world.geoms.length);
    assert.ok(loaded.joints[0].constructor === world.joints[0].constructor && loaded.bodies[0] instanceof Body);
    const run = of => {
        steps(of, 40);
        return of.saveState();
    };
    const later = run(world), delta = world.saveStateDelta(state);
    assert.ok(same(run(copy), later) && same(run(loaded), later));
    world.loadState(state);
    assert.ok(same(run(world), later));
    kept.restore();
    assert.ok(same(new Uint8Array(kept.bytes), state) && same(run(world), later));
    kept.destroy();
    world.loadState(state);
    world.loadStateDelta(state, delta);
    assert.ok(same(world.saveState(), later));
    assert.throws(() => world.loadState(state.subarray(0, 100)), EpodeError);
    assert.ok(same(world.saveState(), later));
    copy.destroy();
    loaded.destroy();
    assert.throws(() => copy.bodies, error => error.kind === 'destroyed');
}));

test('steps are taken back, with what was destroyed and without what was made', () => with_world({}, world => {
    floor(world);
    const made = Array.from({length: 4}, (_, i) => world.createBody({position: [2 * i, 0, 1]}));
    const solids = made.map(body => body.createGeom('sphere', {radius: 0.4}));
    world.history = 20;
    steps(world, 5);
    const before = world.saveState();
    made[1].destroy();
    const late = world.createBody();
    assert.throws(() => made[1].position, error => error.kind === 'destroyed');
    steps(world, 5);
    world.rollBack(5);
    assert.ok(same(world.saveState(), before));
    assert.ok(late.isDestroyed && !made[1].isDestroyed && made[1].geoms[0] === solids[1]);
    assert.deepEqual(new Set(world.bodies), new Set(made));
}));

test('views of many bodies need no copy and are written back', () => with_world({gravity: [0, 0, 0]}, world => {
    const bodies = Array.from({length: 100}, (_, i) => world.createBody({position: [i, 0, 0]}));
    const states = world.createStates(bodies, ['position', 'linearVelocity']), rows = states.read();
    assert.equal(rows.length, 600);
    assert.equal(rows[6 * 42], 42);
    for (let i = 0; i < 100; ++i) rows[6 * i + 4] = i;
    states.write();
    steps(world, 60);
    near(bodies[42].position[1], 42, 1e-9);
    assert.equal(states.read().buffer, states.values.buffer, 'nothing is copied');
    states.values[3] = NaN;
    const held = world.saveState();
    assert.throws(() => states.write(), EpodeError);
    assert.ok(same(world.saveState(), held));
    states.destroy();
    assert.throws(() => states.read(), error => error.kind === 'destroyed');
}));

test('a car accelerates, a character walks up a step', () => with_world({}, world => {
    floor(world);
    const chassis = world.createBody({position: [0, 0, 0.8]});
    chassis.createGeom('box', {lengths: [3, 1.4, 0.5], mass: 1200});
    const car = chassis.makeVehicle();
    for (const [x, y, axle] of [[1.2, 0.7, 0], [1.2, -0.7, 0], [-1.2, 0.7, 1], [-1.2, -0.7, 1]])
        car.addWheel({position: [x, y, -0.2], axle, steer: axle ? 0 : 1, drive: axle});
    assert.equal(car.wheelCount, 4);
    car.controls = {throttle: 1};
    steps(world, 240, 1 / 60, () => car.update(1 / 60));
    assert.ok(car.report.speed > 5 && chassis.position[0] > 5, `${car.report.speed} m/s`);
    assert.equal(car.report.wheelsOnGround, 4);
    near([0, 1, 2, 3].reduce((sum, i) => sum + car.getWheelReport(i).load, 0), 1200 * 9.81, 0.1 * 1200 * 9.81);

    world.createGeom('box', {lengths: [2, 2, 0.4], position: [-8, 8, 0]});
    const walker = world.createGeom('character', {settings: {height: 1.7}, position: [-10, 8, 0]});
    steps(world, 90, 1 / 60, () => walker.walk([1.5, 0, 0], 0, 1 / 60));
    near(walker.position[0], -10 + 1.5 * 1.5, 0.1);
    near(walker.position[2], 0.2, 0.03);
    assert.equal(walker.report.state, 'onGround');
}));

test('meshes, hulls and height fields hold what falls on them', () => with_world({}, world => {
    const drop = (x, height) => {
        const body = world.createBody({position: [x, 0, height + 1]});
        body.createGeom('sphere', {radius: 0.3});
        return body;
    };
    world.createGeom('triMesh', {vertices: [-2, -2, 1, 2, -2, 1, 2, 2, 1, -2, 2, 1], indices: [0, 1, 2, 0, 2, 3]});
    const cube = [0, 1, 2, 3, 4, 5, 6, 7].flatMap(i => [i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1]);
    const hull = world.createGeom('convex', {points: cube, position: [10, 0, 0]});
    world.createGeom('heightfield', {heights: new Float64Array(25).fill(2), widthSamples: 5, depthSamples: 5, width: 4, depth: 4,
                                     position: [20, 0, 0], quaternion: [Math.SQRT1_2, Math.SQRT1_2, 0, 0]});
    const balls = [drop(0, 1), drop(10, 1), drop(20, 2)];
    steps(world, 180);
    [1, 1, 2].forEach((height, i) => near(balls[i].position[2], height + 0.3, 2e-3));
    assert.equal(hull.triangles().length, 9 * 12);
}));

test('wrong arguments throw and change nothing', () => with_world({}, world => {
    const body = world.createBody(), geom = body.createGeom('sphere', {radius: 1}), other = engine.createWorld(), stranger = other.createBody();
    const gone = world.createBody();
    gone.destroy();
    const held = world.save();
    for (const call of [
        () => { body.position = [0, NaN, 0]; }, () => { body.position = [0, 0]; }, () => { body.position = 'here'; }, () => { body.position = null; },
        () => { body.mass = -1; }, () => { body.mass = '5'; }, () => { body.gravity = 1; }, () => { geom.radius = 0 / 0; },
        () => { geom.material = {friction: -1}; }, () => { geom.material = {fricton: 1}; }, () => { world.behaviour = 'v7'; },
        () => world.step(NaN), () => world.step('1'), () => world.step(0.01, 'fast'), () => world.step(-1), () => world.step(),
        () => world.createBody({positon: [0, 0, 1]}), () => world.createBody({position: [0, 0, Infinity]}), () => world.createBody(7),
        () => body.createGeom('sphere', {radius: -1}), () => body.createGeom('ball', {radius: 1}), () => body.createGeom('sphere', {radius: 1, density: -5}),
        () => world.createGeom('sphere', {radius: 1, density: 5}), () => world.createGeom('triMesh', {vertices: [0, 0, 0], indices: [0, 1, 2]}),
        () => body.createGeom('sphere', {radius: 1, position: [0, 0, 1]}),
        () => world.createJoint('hinge', body, gone), () => world.createJoint('hinge', body, stranger), () => world.createJoint('hinge', body, geom),
        () => world.createJoint('hinge', body, null, {axis: [0, 0, 0]}), () => world.createJoint('hinge', body, null, {axes: 1}),
        () => world.loadState(new Uint8Array(10)), () => world.loadState([1, 2]), () => engine.loadWorld(new Uint8Array(100)), () => world.rollBack(3),
        () => gone.position, () => gone.destroy(), () => world.createStates([gone]), () => world.createStates([body], ['velocity']),
    ]) {
        assert.throws(call, error => error instanceof TypeError || error instanceof EpodeError, call.toString());
        assert.ok(same(world.save(), held), call.toString());
    }
    other.destroy();
    assert.throws(() => stranger.position, error => error.kind === 'destroyed');
    assert.throws(() => { body.position = [0, NaN, 0]; }, /^TypeError: Body\.position: value\[1\] must be a number, not NaN$/);
    assert.throws(() => { geom.radius = -1; }, error => error instanceof EpodeError && error.kind === 'refused' && /^Sphere\.radius: /.test(error.message));
}));

test('two engines have nothing in common', async () => {
    const second = await load(), world = second.createWorld(), body = world.createBody();
    with_world({}, mine => assert.throws(() => mine.createJoint('ball', body, null), error => error.kind === 'other'));
    body.createGeom('sphere', {radius: 1});
    world.step(0.01);
    assert.ok(body.geoms[0] instanceof Sphere);
});

test('what is destroyed gives its memory back', () => {
    const round = () => with_world({}, world => {
        floor(world);
        world.setContactFilter(() => true);
        for (let i = 0; i < 50; ++i) world.createBody({position: [0, 0, 2 * i]}).createGeom('triMesh', {vertices: [0, 0, 0, 1, 0, 0, 0, 1, 0], indices: [0, 1, 2]});
        world.createJoint('ball', world.bodies[0], world.bodies[1], {measures: true});
        steps(world, 3);
        world.saveState();
        world.snapshot().destroy();
    });
    for (let i = 0; i < 5; ++i) round();
    const held = engine.memorySize;
    for (let i = 0; i < 100; ++i) round();
    assert.equal(engine.memorySize, held);
    assert.equal(engine.objects.size, 0);
});

test('geoms that are refused leave a sleeping world as it is', () => {
    const world = engine.createWorld();
    world.createGeom('plane', {normal: [0, 0, 1]});
    const ball = world.createBody({position: [0, 0, 0.3]});
    ball.createGeom('sphere', {radius: 0.3});
    for (let i = 0; i < 200; ++i) world.step(1 / 60);
    assert.equal(ball.enabled, false);
    const before = world.save();
    for (const call of [
        () => ball.createGeom('plane', {normal: [0, 0, 1]}), () => ball.createGeom('sphere', {radius: 0.1, density: NaN}),
        () => ball.createGeom('box', {lengths: [1, 1, 1], material: {friction: -1}}), () => world.createGeom('sphere', {radius: 0.1, material: {friction: NaN}}),
    ]) assert.throws(call);
    assert.equal(Buffer.compare(world.save(), before), 0);
    world.destroy();
});

test('what is refused leaves a sleeping pair with a joint asleep', () => {
    const world = engine.createWorld();
    world.history = 2;
    floor(world);
    const [low, high] = [0.3, 0.9].map(z => world.createBody({position: [0, 0, z]}));
    for (const body of [low, high]) body.createGeom('box', {lengths: [0.6, 0.6, 0.6]});
    const joint = world.createJoint('hinge', low, high, {anchor: [0, 0, 0.6], axis: [0, 1, 0]});
    joint.setParam('loStop', -1);
    steps(world, 300);
    const before = world.save(), touched = world.contacts.length, events = JSON.stringify([world.contactEvents, world.events]);
    assert.deepEqual([low.enabled, high.enabled], [false, false]);
    const vehicle = {wheelRadius: 'one'};
    for (const call of [
        () => world.createJoint('hinge', low, high, {axis: [0, 0, 0]}), () => world.createJoint('hinge', low, null, {axis: [NaN, 0, 0]}),
        () => world.createJoint('hinge', null, low, {anchor: [0, 0, 0], axis: [0, 0, 0]}), () => world.createJoint('slider', high, null, {axis: [Infinity, 0, 0]}),
        () => world.createJoint('ball', low, high, {anchor: [0, 0, 0.5], enabled: 1}), () => world.createJoint('universal', high, low, {axis1: [0, 1, 0], axis2: 'z'}),
        () => world.createJoint('fixed', low, high, {measures: null}), () => world.createJoint('transmission', low, null), () => world.createJoint('hinge', low, low),
        () => { joint.axis = [0, 0, 0]; }, () => { joint.anchor = [NaN, 0, 0]; }, () => joint.setParam('loStop', NaN), () => joint.setParam('hiStop', 'x'), () => { joint.enabled = 0; },
        () => { low.position = [0, 0, NaN]; }, () => { low.linearVelocity = [Infinity, 0, 0]; }, () => { low.mass = 0; }, () => { low.massProperties = {mass: 1, inertia: [1, 0, 0]}; },
        () => { low.quaternion = [0, 0, 0, 0]; }, () => { low.enabled = 1; }, () => { low.kinematic = null; }, () => low.addForce([NaN, 0, 0]), () => low.applyImpulse([0, 0, 1], [NaN, 0, 0]),
        () => low.makeVehicle(vehicle), () => world.createBody({mass: -1}), () => world.createBody({position: [0, 0, 0.2], linearVelocity: 3}), () => { world.gravity = [0, 0, NaN]; },
        () => low.createGeom('sphere', {radius: 0.1, mass: -1}), () => low.createGeom('sphere', {radius: 0.1, offsetPosition: [0, 0, Infinity]}),
        () => { low.geoms[0].lengths = [1, 1, -1]; }, () => { low.geoms[0].material = {friction: -1}; }, () => { low.geoms[0].enabled = 'no'; }, () => { low.geoms[0].offsetPosition = [NaN, 0, 0]; },
    ]) {
        assert.throws(call, error => error instanceof TypeError || error instanceof EpodeError, call.toString());
        assert.ok(same(world.save(), before), call.toString());
        assert.deepEqual([low.enabled, high.enabled, world.contacts.length, world.joints.length], [false, false, touched, 1], call.toString());
        assert.equal(JSON.stringify([world.contactEvents, world.events]), events, call.toString());
    }
    world.destroy();
});
