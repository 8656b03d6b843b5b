// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Random calls of everything that the package has, with values of every kind: dead objects, objects of another engine, numbers that are
// none, wrong types, functions and getters that throw. A call may throw TypeError, EpodeError, RangeError (no memory) or what our own
// functions throw, and then the world that World.save writes is the one of before; nothing else may end it.
//   node hostile_test.mjs [CALLS [SEED]]
import * as epode from 'epode';

const [calls, seed] = [Number(process.argv[2] ?? 20000), Number(process.argv[3] ?? 1)];
class Mine extends Error {}

let state = seed >>> 0 || 1;
function random(below) {  // xorshift
    state ^= state << 13;
    state ^= state >>> 17;
    state ^= state << 5;
    return (state >>> 0) % below;
}
const pick = list => list[random(list.length)];

const engine = await epode.load({onMessage() {}}), stranger_engine = await epode.load({onMessage() {}});
const stranger = stranger_engine.createWorld().createBody(), stranger_geom = stranger.createGeom('sphere', {radius: 1});
const kinds = {
    joint: Object.values(epode).filter(one => one.prototype instanceof epode.Joint).map(one => one.kind),
    shape: ['sphere', 'box', 'plane', 'capsule', 'cylinder', 'cone', 'ellipsoid', 'taperedCapsule', 'convex', 'triMesh', 'heightfield', 'character'],
};
const sizes = {
    sphere: {radius: 0.3}, box: {lengths: [0.5, 0.4, 0.3]}, plane: {normal: [0, 0, 1]}, capsule: {radius: 0.2, length: 0.4},
    cylinder: {radius: 0.3, length: 0.4}, cone: {radius: 0.3, length: 0.4}, ellipsoid: {radii: [0.2, 0.3, 0.4]},
    taperedCapsule: {radius1: 0.2, radius2: 0.3, length: 0.4}, convex: {points: [0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1]},
    triMesh: {vertices: [-1, -1, 0, 1, -1, 0, 0, 1, 0], indices: [0, 1, 2]},
    heightfield: {heights: [0, 1, 0, 1], widthSamples: 2, depthSamples: 2, width: 2, depth: 2}, character: {settings: {height: 1.2}},
};

let world, dead = [], objects = [];
function rebuild() {
    world = engine.createWorld();
    world.createGeom('plane', {normal: [0, 0, 1]});
    objects = [world, engine];
    for (let i = 0; i < 4; ++i) {
        const body = world.createBody({position: [i, 0, 1]});
        const shape = pick(['sphere', 'box', 'capsule']);
        objects.push(body, body.createGeom(shape, sizes[shape]));
    }
    if (random(2)) for (let i = 0; i < 240 && world.bodies.some(body => body.enabled); ++i) world.step(1 / 60);
}

// Values of every kind.
const saved = () => world.saveState();
const numbers = [NaN, Infinity, -Infinity, -1, -0, 0, 1, 2, 3, 0.25, 1.5, 1e-9, 1e9, 1e308, 2 ** 31, 2 ** 32, -(2 ** 31), 4294967295];
const values = [
    () => pick(numbers), () => pick(numbers), () => random(5), () => random(1000) / 250 - 2, () => [pick(numbers), pick(numbers), pick(numbers)],
    () => [random(9) / 4 - 1, random(9) / 4 - 1, random(9) / 4], () => ({x: random(3), y: random(3), z: pick(numbers)}), () => [1, 0, 0, 0],
    () => [1, 0, 0, 0, 1, 0, 0, 0, 1], () => Array.from({length: random(12)}, () => pick(numbers)), () => new Float64Array(random(12)),
    () => pick([null, undefined, true, false, '', 'hinge', 10n, Symbol('s'), {}, [], () => true, () => { throw new Mine('thrown'); }, new Date(), /x/]),
    () => pick(kinds.joint), () => pick(kinds.shape), () => pick(['game', 'robot', 'quick', 'exact', 'substeps', 'on', 'off', 'loStop', 'position', 'maxForce2']),
    () => pick(objects), () => pick(objects), () => pick(world.isDestroyed ? objects : world.bodies), () => pick(world.isDestroyed ? objects : world.geoms),
    () => pick(dead) ?? stranger, () => stranger, () => stranger_geom, () => new Uint8Array(random(64)),
    () => world.isDestroyed ? new Uint8Array(3) : saved(), () => world.isDestroyed ? new Uint8Array(3) : world.save(),
    () => ({...sizes[pick(kinds.shape)], ...pick([{}, {density: pick(numbers)}, {material: {friction: pick(numbers)}}, {offsetPosition: [0, 0, 0.1]}])}),
    () => ({position: [0, 0, random(5)], ...pick([{}, {mass: pick(numbers)}, {kinematic: pick([true, 1])}])}),
    () => ({stiffness: pick(numbers), damping: pick(numbers)}), () => ({throttle: 1}), () => ({accept: pick([() => true, 3, () => { throw new Mine('thrown'); }])}),
    () => ({get x() { throw new Mine('getter'); }, y: 0, z: 0}), () => new Proxy({}, {get() { throw new Mine('proxy'); }, ownKeys() { throw new Mine('proxy'); }}),
    () => [pick(world.isDestroyed ? [stranger] : world.bodies)], () => ['position', 'linearVelocity'],
    () => ({anchor: [0, 0, random(3)]}), () => ({axis: pick([[0, 0, 1], [0, 0, 0]])}),
];
const value = () => pick(values)();

const joint_options = [undefined, {}, {axis: [0, 0, 1]}, {axis: [0, 0, 0]}, {axis: [NaN, 0, 1]}, {axis1: [1, 0, 0], axis2: [1, 0, 0]}, {anchor: [0, 0, 1], axis: [0, 0, 0]},
    {anchor: [Infinity, 0, 0]}, {enabled: 1}, {measures: true, axis: []}];

// What a class has: names with a line below are the package's own.
const of_package = new Set(['constructor', 'vector', 'four', 'six', 'matrix', 'buffer', 'callback', 'check', 'begun', 'ended', 'create', 'base', 'c', 'objects']);
const memo = new Map();
function members(object) {
    const prototype = Object.getPrototypeOf(object);
    if (memo.has(prototype)) return memo.get(prototype);
    const found = [];
    for (let at = prototype; at && at !== Object.prototype; at = Object.getPrototypeOf(at)) {
        for (const [name, what] of Object.entries(Object.getOwnPropertyDescriptors(at))) {
            if (!name.includes('_') && !of_package.has(name)) found.push([name, what]);
        }
    }
    memo.set(prototype, found);
    return found;
}

// Sensible arguments now and then: random ones alone would be refused nearly always.
function arguments_of(name, count) {
    const shape = pick(kinds.shape);
    if (random(3) === 0) {
        if (name === 'step') return [random(20) / 1000, pick(['hybrid', 'exact', 'quick', 'substeps'])];
        if (name === 'createGeom') return [shape, {...sizes[shape]}];
        if (name === 'createJoint') return [pick(kinds.joint), pick(world.bodies), pick([null, ...world.bodies]), pick(joint_options)];
        if (name === 'rollBack') return [random(3)];
    }
    if (name === 'step') return [pick(numbers.slice(0, 9)), value(), random(6)];
    return Array.from({length: Math.max(count, random(4))}, value);
}

const counts = {}, covered = new Set();
function invoke(object) {
    const [name, what] = pick(members(object));
    if (name === 'destroy' && (object === world ? random(20) : random(4))) return;
    covered.add(`${object.constructor.name}.${name}`);
    if (what.get && (!what.set || random(2))) return void object[name];
    if (what.set) return void (object[name] = name === 'history' ? pick([value(), random(4)]) : value());
    const given = arguments_of(name, what.value.length), result = object[name](...given);
    if (result && typeof result === 'object' && typeof result.destroy === 'function' && result !== object && result.engine === engine) keep(result);
}

function keep(made) {
    if (made instanceof epode.World && made !== world) return made.destroy();
    objects.push(made);
}

const allowed = error => error instanceof TypeError || error instanceof epode.EpodeError || error instanceof Mine || error instanceof RangeError;
rebuild();
let before = world.save(), refused = 0;
for (let i = 0; i < calls; ++i) {
    const object = random(12) === 0 && dead.length ? pick(dead) : pick(objects);
    try {
        invoke(object);
        before = null;
    } catch (error) {
        if (!allowed(error)) throw new Error(`call ${i} of seed ${seed}`, {cause: error});
        ++refused;
        counts[error.constructor.name] = (counts[error.constructor.name] ?? 0) + 1;
        // A step that a callback has thrown out of has been made.
        const stepped = error instanceof Mine || /there is no memory/.test(error.message);
        if (before && !stepped && !world.isDestroyed && Buffer.compare(world.save(), before) !== 0)
            throw new Error(`call ${i} of seed ${seed} was refused and has changed the world`, {cause: error});
        if (stepped) before = null;
    }
    if (!world.isDestroyed && world.bodies.length + world.geoms.length > 60) world.destroy();
    if (world.isDestroyed) {
        dead = objects.filter(one => one !== engine).slice(-50);
        rebuild();
        before = null;
    }
    objects = objects.filter(one => one === engine || !(one.isDestroyed && dead.push(one)));
    if (dead.length > 100) dead = dead.slice(-50);
    before ??= world.save();
}
const all = new Set(objects.flatMap(object => members(object).map(([name]) => `${object.constructor.name}.${name}`)));
console.log(`${calls} calls, ${refused} refused: ${JSON.stringify(counts)}; ${covered.size} functions and properties reached`);
if (covered.size < 300 || [...all].some(name => calls > 1e5 && !covered.has(name))) throw new Error('some were never called');
