// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the scenes of bench/games share. A scene is played by Epode (npm package, doubles, the preset for games) and by Jolt (npm jolt-physics,
// floats), both as WebAssembly on one thread, with the same sizes and laws. x is forward, y left, z up; Jolt, whose manual has y up, gets
// (x, y, z) as (z, x, y): forward +z, left +x. Numbers that scenes read are turned back.
// Runs repeat bit for bit, so each step's time is the least of several runs: what remains is its own work, not the machine's other load.
import {pathToFileURL} from 'node:url';
import {load} from 'epode';
import init_jolt from 'jolt-physics';

export const kGravity = 9.81, kRates = [60, 120, 240];  // steps a second
const kRuns = 5, kStill = 0, kMoving = 1;                // layers of Jolt

// EPODE_MODULE: a module with functions that the package's own has not.
const {EPODE_MODULE} = process.env;
export const epode = await load(EPODE_MODULE ? {source: pathToFileURL(EPODE_MODULE)} : {});
export const Jolt = await init_jolt();

export const vec = ([x, y, z]) => new Jolt.Vec3(y, z, x);
export const far = ([x, y, z]) => new Jolt.RVec3(y, z, x);
export const quat = ([w, x, y, z]) => new Jolt.Quat(y, z, x, w);
export const numbers = v => [v.GetZ(), v.GetX(), v.GetY()];

export class EpodeWorld {
    constructor(h) {
        this.h = h;
        this.world = epode.createWorld({gravity: [0, 0, -kGravity], autoDisable: false, linearDamping: 0, angularDamping: 0});
    }
    still({lengths, position, quaternion = [1, 0, 0, 0]}) { return this.world.createGeom('box', {lengths, position, quaternion}); }
    // A box that moves as the program says, by `drive` before each step.
    driven({lengths, position}) {
        const body = this.world.createBody({position, kinematic: true});
        body.createGeom('box', {lengths});
        return body;
    }
    drive(body, {velocity, spin}) { [body.linearVelocity, body.angularVelocity] = [velocity, [0, 0, spin]]; }
    position(body) { return body.position; }
    step() { this.world.step(this.h); }
    end() { this.world.destroy(); }
}

// Without what is freed with its world: a run is short.
export class JoltWorld {
    constructor(h) {
        this.h = h;
        const settings = new Jolt.JoltSettings(), pairs = new Jolt.ObjectLayerPairFilterTable(2), layers = new Jolt.BroadPhaseLayerInterfaceTable(2, 2);
        settings.mMaxWorkerThreads = 0;
        pairs.EnableCollision(kStill, kMoving);
        pairs.EnableCollision(kMoving, kMoving);
        for (const layer of [kStill, kMoving]) layers.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
        settings.mObjectLayerPairFilter = pairs;
        settings.mBroadPhaseLayerInterface = layers;
        settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 2, pairs, 2);
        this.made = new Jolt.JoltInterface(settings);
        this.system = this.made.GetPhysicsSystem();
        this.system.SetGravity(vec([0, 0, -kGravity]));
        this.bodies = this.system.GetBodyInterface();
        this.layer = kMoving;
    }
    // change(settings) may set more before the body exists.
    body({lengths, position, quaternion = [1, 0, 0, 0]}, motion, change = () => {}) {
        const shape = new Jolt.BoxShape(vec(lengths.map(x => x / 2)));
        const settings = new Jolt.BodyCreationSettings(shape, far(position), quat(quaternion), Jolt[`EMotionType_${motion}`], motion === 'Static' ? kStill : kMoving);
        settings.mAllowSleeping = false;
        settings.mLinearDamping = settings.mAngularDamping = 0;
        settings.mFriction = 1;
        change(settings);
        const body = this.bodies.CreateBody(settings);
        this.bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
        return body;
    }
    still(box) { return this.body(box, 'Static'); }
    driven(box) { return this.body(box, 'Kinematic'); }
    drive(body, {velocity, spin}) { this.bodies.SetLinearAndAngularVelocity(body.GetID(), vec(velocity), vec([0, 0, spin])); }
    position(body) { return numbers(body.GetPosition()); }
    // Jolt's filters of what moves.
    filters() {
        const of = this.made;
        return [new Jolt.DefaultBroadPhaseLayerFilter(of.GetObjectVsBroadPhaseLayerFilter(), kMoving),
            new Jolt.DefaultObjectLayerFilter(of.GetObjectLayerPairFilter(), kMoving), new Jolt.BodyFilter(), new Jolt.ShapeFilter()];
    }
    step() { this.made.Step(this.h, 1); }
    end() { Jolt.destroy(this.made); }
}

// begin() makes a run {step(i), sample(i), end()}; step is timed. The samples of one run, and each step's time in us.
export function play(begin, steps, runs = kRuns) {
    const times = new Float64Array(steps).fill(Infinity);
    let samples;
    for (let n = 0; n < runs; ++n) {
        const run = begin();
        samples = [];
        for (let i = 0; i < steps; ++i) {
            run.before?.(i);
            const start = process.hrtime.bigint();
            run.step(i);
            times[i] = Math.min(times[i], Number(process.hrtime.bigint() - start) / 1000);
            samples.push(run.sample(i));
        }
        run.end();
    }
    return {samples, times};
}

export const mean = list => list.reduce((sum, x) => sum + x, 0) / list.length;
export const rms = list => Math.sqrt(mean(list.map(x => x * x)));
export const largest = list => list.reduce((a, b) => Math.max(a, b), -Infinity);
export const least = list => -largest(list.map(x => -x));
export const mid = list => Float64Array.from(list).sort()[list.length >> 1];
export const time_of = times => `${mid(times).toFixed(1)} / ${largest(times).toFixed(1)}`;

const engines = {Epode: EpodeWorld, Jolt: JoltWorld};
// measure(World, rate) gives [[what, exact, value], ...], the same rows for every engine and rate: one table, a column each.
export function compare(title, measure) {
    const columns = Object.entries(engines).flatMap(([name, World]) => kRates.map(rate => ({head: `${name} 1/${rate}`, rows: measure(World, rate)})));
    console.log(`\n${title}\n`);
    const line = cells => console.log(`| ${cells.join(' | ')} |`);
    line(['', 'exact', ...columns.map(column => column.head)]);
    line(['---', '---:', ...columns.map(() => '---:')]);
    columns[0].rows.forEach(([what, exact], i) => line([what, exact, ...columns.map(column => column.rows[i][2])]));
}

// Number with as many digits as say something.
export const figure = (x, digits = 3) => !Number.isFinite(x) ? '-' : Math.abs(x) < 1e-9 ? '0' : Number(x.toPrecision(digits)).toString();
