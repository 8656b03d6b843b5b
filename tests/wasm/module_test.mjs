// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The library through epode.mjs, under Node: node --test module_test.mjs, with EPODE_WEB=the folder that has it.
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {test} from 'node:test';

const web = process.env.EPODE_WEB;
const {Exit, load} = await import(`${web}/epode.mjs`);
const lines = [], errors = [];
const ode = await load(undefined, {print: line => lines.push(line), report: error => errors.push(error.message)});

test('a ball falls as in the README', () => {
    const world = ode.dWorldCreate();
    ode.dWorldSetGravity(world, 0, 0, -9.81);
    const ball = ode.dBodyCreate(world);
    for (let i = 0; i < 100; ++i) ode.dWorldStep(world, 0.01);
    assert.equal(ode.reals(ode.dBodyGetPosition(ball), 3)[2].toPrecision(6), '-4.95405');
    ode.dWorldDestroy(world);
});

// What the same pile ends in natively (web_pile_test.cpp).
const expected_hash = /"physics\/web_pile", 0x([0-9a-f]+)/.exec(
    await readFile(new URL('../golden/physics.inc', import.meta.url), 'utf8'))[1];

// FNV-1a, as there.
function hash(bytes) {
    let all = 0xcbf29ce484222325n;
    for (const byte of bytes) all = BigInt.asUintN(64, (all ^ BigInt(byte)) * 0x100000001b3n);
    return all.toString(16).padStart(16, '0');
}

test('a pile without a near callback has the bits of x86-64', () => {
    const world = ode.dWorldCreate(), space = ode.dHashSpaceCreate(0);
    ode.dWorldUseDefaults(world, ode.dDefaultsGame);
    ode.dWorldSetGravity(world, 0, 0, -9.81);
    ode.dWorldSetContactSpace(world, space);
    ode.dCreatePlane(space, 0, 0, 1, 0);
    const mass = ode.create('dMass'), bodies = [];
    for (let i = 0; i < 80; ++i) {
        const body = ode.dBodyCreate(world), round = i % 3 === 0;
        if (round) ode.dMassSetSphere(mass.pointer, 500, 0.25);
        else ode.dMassSetBox(mass.pointer, 500, 0.5, 0.4, 0.3);
        ode.dBodySetMass(body, mass.pointer);
        ode.dGeomSetBody(round ? ode.dCreateSphere(space, 0.25) : ode.dCreateBox(space, 0.5, 0.4, 0.3), body);
        ode.dBodySetPosition(body, 0.55 * (i % 4) + 0.03125 * (i % 5), 0.55 * (Math.floor(i / 4) % 4), 0.5 + 0.5 * Math.floor(i / 16));
        bodies.push(body);
    }
    for (let i = 0; i < 200; ++i) assert.equal(ode.dWorldStepHybrid(world, 1 / 60), 1);
    const handles = ode.new_ints(bodies), states = ode.malloc(13 * 8 * bodies.length);
    const fields = ode.dStatePosition | ode.dStateQuaternion | ode.dStateLinearVel | ode.dStateAngularVel;
    assert.equal(ode.dBodiesGetStates(handles, bodies.length, fields, states, 0), 1);
    assert.ok(Math.max(...ode.reals(states, 3)) < 10);
    assert.equal(hash(ode.bytes(states, 13 * 8 * bodies.length)), expected_hash);
    for (const pointer of [mass.pointer, handles, states]) ode.free(pointer);
    ode.dWorldDestroy(world);
    ode.dSpaceDestroy(space);
});

// Returns how high the box lies, on contacts that `near` makes.
function box_on_near_callback(near_of) {
    const world = ode.dWorldCreate(), space = ode.dSimpleSpaceCreate(0), group = ode.dJointGroupCreate(0);
    ode.dWorldSetGravity(world, 0, 0, -9.81);
    ode.dCreatePlane(space, 0, 0, 1, 0);
    const body = ode.dBodyCreate(world);
    ode.dGeomSetBody(ode.dCreateBox(space, 1, 1, 1), body);
    ode.dBodySetPosition(body, 0, 0, 0.6);
    const near = ode.callback('iii:', near_of(world, group));
    for (let i = 0; i < 200; ++i) {
        ode.dSpaceCollide(space, 0, near);
        ode.dWorldQuickStep(world, 0.01);
        ode.dJointGroupEmpty(group);
    }
    const height = ode.reals(ode.dBodyGetPosition(body), 3)[2];
    ode.free_callback(near);
    ode.dJointGroupDestroy(group);
    ode.dWorldDestroy(world);
    ode.dSpaceDestroy(space);
    return height;
}

test('a near callback in JavaScript makes contact joints, as programs for ODE do', () => {
    const size = ode.size_of('dContact'), contacts = ode.malloc(8 * size);
    const first_geom = ode.at(contacts, 'dContact').pointer_to('geom.pos');
    const height = box_on_near_callback((world, group) => (data, a, b) => {
        const count = ode.dCollide(a, b, 8, first_geom, size);
        for (let i = 0; i < count; ++i) {
            ode.at(contacts + i * size, 'dContact').set({'surface.mode': ode.dContactApprox1, 'surface.mu': 0.5});
            const joint = ode.dJointCreateContact(world, group, contacts + i * size);
            ode.dJointAttach(joint, ode.dGeomGetBody(a), ode.dGeomGetBody(b));
        }
    });
    assert.ok(Math.abs(height - 0.5) < 0.01, `it lies at ${height}`);
    ode.free(contacts);
});

test('an error in a callback is reported and leaves the library in order', () => {
    const height = box_on_near_callback(() => () => { throw new Error('mine'); });
    assert.ok(height < 0, 'nothing held the box');
    assert.ok(errors.length > 0 && errors.every(text => text === 'mine'));
});

test('structures have their defaults, fields and sizes', () => {
    const material = ode.create('dMaterial', {friction: 0.25, surface_velocity: [1, 2, 3, 0]});
    const box = ode.dCreateBox(0, 1, 1, 1), read = ode.create('dMaterial');
    assert.equal(material.bounce_speed, 1);
    assert.equal(ode.dGeomSetMaterial(box, material.pointer), 1);
    assert.equal(ode.dGeomGetMaterial(box, read.pointer), 1);
    assert.equal(read.friction, 0.25);
    assert.deepEqual([...read.surface_velocity], [1, 2, 3, 0]);
    assert.throws(() => read.set({no_such: 1}), /dMaterial has no field no_such/);
    assert.throws(() => ode.create('dNothing'), /dNothing|undefined/);
    ode.dGeomDestroy(box);
    ode.free(material.pointer);
    ode.free(read.pointer);
});

test('refusals are printed, or go to a handler with their text', () => {
    lines.length = 0;
    ode.dWorldSetGravity(0, 0, 0, 0);
    assert.match(lines.join('|'), /Bad argument\(s\) in dWorldSetGravity\(\)/);
    const received = [];
    ode.on_message((channel, number, text) => received.push(`${channel} ${number}: ${text}`));
    ode.dWorldDestroy(12345 * 64);
    assert.equal(received.length, 1);
    assert.match(received[0], /^debug 2: .* in dWorldDestroy\(\)$/);
});

test('strings go both ways, threads and files are refused', () => {
    assert.match(ode.string(ode.dGetConfiguration()), /^ODE/);
    const world = ode.dWorldCreate(), path = ode.new_string('/world.epw');
    assert.equal(ode.dWorldSave(world, 0, path), 0);
    assert.equal(ode.dThreadingAllocateThreadPool(2, 0, ode.dAllocateFlagBasicData, 0), 0);
    const size = ode.dWorldSaveToBuffer(world, 0, 0, 0), buffer = ode.malloc(size);
    assert.equal(ode.dWorldSaveToBuffer(world, 0, buffer, size), size);
    ode.free(buffer);
    ode.free(path);
    ode.dWorldDestroy(world);
});

test('what ends a C program is an exception', () => {
    assert.throws(() => ode.dError(3, 0, 0), error => error instanceof Exit && error.code === 1);
});
