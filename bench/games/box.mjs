// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Boxes of 2 m, 2 m and 1 m with half the density of water, as Epode's fluid and Jolt's ApplyBuoyancyImpulse let them float. Without added mass:
//   draught   T = m / (rho A) = 0.5 m
//   heave     z'' = -(g / T) z: a period of 2 pi sqrt(T / g), an amplitude that lasts without drag
//   drag      z'' = -(g / T) z - k z'|z'|, k = rho C A / (2 m): a' = -4 k w a^2 / (3 pi) in the mean
//   rest      let go 1 m higher, leaning by 20 degrees, with the drag of each engine's manual: speed and draught after 60 s
//   time      100 of them, let go at many heights
import {EpodeWorld, Jolt, JoltWorld, compare, epode, far, figure, kGravity, largest, mid, numbers, play, time_of, vec} from './common.mjs';

const kLengths = [2, 2, 1], kMass = 2000, kWater = 1000, kDraught = 0.5, kAmplitude = 0.1, kDrag = 0.5;
const kPeriod = 2 * Math.PI * Math.sqrt(kDraught / kGravity);

// Drags: none; by pressure alone, of one size: Epode takes the submerged share of the area, one half; the manual's.
const kDrags = {
    none: {epode: {drag: 0, linear_drag: 0, angular_drag: 0}, jolt: [0, 0]},
    pressure: {epode: {drag: 2 * kDrag, linear_drag: 0, angular_drag: 0}, jolt: [kDrag, 0]},
    usual: {epode: {}, jolt: [0.5, 0.01]},
};

class EpodePool {
    constructor(stage, drag) {
        this.stage = stage;
        const {c} = epode, fluid = c.dFluidCreate(stage.world.handle), settings = c.create('dFluidSettings');
        for (const [name, value] of Object.entries(drag.epode)) settings[name] = value;
        c.dFluidSetSettings(fluid, settings.pointer);
        c.free(settings.pointer);
    }
    box({position, quaternion}) {
        const body = this.stage.world.createBody({position, quaternion});
        body.createGeom('box', {lengths: kLengths, mass: kMass});
        return body;
    }
    step() { this.stage.step(); }
    state(body) { return {height: body.position[2], speed: Math.hypot(...body.linearVelocity), spin: Math.hypot(...body.angularVelocity)}; }
}

class JoltPool {
    constructor(stage, drag) {
        [this.stage, this.drag, this.boxes] = [stage, drag.jolt, []];
        [this.place, this.up, this.current, this.gravity] = [far([0, 0, 0]), vec([0, 0, 1]), vec([0, 0, 0]), vec([0, 0, -kGravity])];
    }
    box(where) {
        const body = this.stage.body({...where, lengths: kLengths}, 'Dynamic', settings => {
            settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_CalculateInertia;
            settings.mMassPropertiesOverride.mMass = kMass;
        });
        this.boxes.push(body.GetID());
        return body;
    }
    step() {
        const {stage: {bodies, h}, drag: [linear, angular]} = this, buoyancy = kWater / (kMass / (kLengths[0] * kLengths[1] * kLengths[2]));
        for (const id of this.boxes) bodies.ApplyBuoyancyImpulse(id, this.place, this.up, buoyancy, linear, angular, this.current, this.gravity, h);
        this.stage.step();
    }
    state(body) {
        const speed = Math.hypot(...numbers(body.GetLinearVelocity())), spin = Math.hypot(...numbers(body.GetAngularVelocity()));
        return {height: numbers(body.GetPosition())[2], speed, spin};
    }
}

function float(World, rate, seconds, drag, places, runs = 1) {
    return play(() => {
        const stage = new World(1 / rate), pool = new (World === EpodeWorld ? EpodePool : JoltPool)(stage, kDrags[drag]);
        const boxes = places.map(place => pool.box(place));
        return {step: () => pool.step(), sample: () => pool.state(boxes[0]), end: () => stage.end()};
    }, Math.round(seconds * rate), runs);
}

// The mean period of heights about zero, by their upward crossings.
function period(heights, rate) {
    const crossings = [];
    for (let i = 1; i < heights.length; ++i) if (heights[i - 1] < 0 && heights[i] >= 0) crossings.push(i - heights[i] / (heights[i] - heights[i - 1]));
    return (crossings.at(-1) - crossings[0]) / (crossings.length - 1) / rate;
}

const amplitude = (heights, rate, from, to) => largest(heights.slice(Math.round(from * rate), Math.round(to * rate)).map(Math.abs));

function heave(World, rate) {
    const at = {position: [0, 0, kAmplitude], quaternion: [1, 0, 0, 0]};
    const free = float(World, rate, 60, 'none', [at]).samples.map(s => s.height), slowed = float(World, rate, 20, 'pressure', [at]).samples.map(s => s.height);
    const k = kWater * kDrag * kLengths[0] * kLengths[1] / (2 * kMass), w = 2 * Math.PI / kPeriod;
    const share = amplitude(slowed, rate, 20 - kPeriod, 20) , law = kAmplitude / (1 + 4 * k * w * kAmplitude * (20 - kPeriod / 2) / (3 * Math.PI));
    return [
        ['period over the law\'s, %', '0', figure(100 * (period(free, rate) / kPeriod - 1), 2)],
        ['amplitude after 60 s without drag, m', figure(kAmplitude), figure(amplitude(free, rate, 60 - kPeriod, 60), 3)],
        [`amplitude after 20 s with the drag of C = ${kDrag}, m`, figure(law), figure(share, 3)],
    ];
}

function rest(World, rate) {
    const lean = Math.PI / 9, at = {position: [0, 0, 1], quaternion: [Math.cos(lean / 2), Math.sin(lean / 2), 0, 0]};
    const {samples} = float(World, rate, 60, 'usual', [at]), last = samples.at(-1), fast = samples.findLastIndex(s => s.speed > 0.01 || s.spin > 0.01);
    return [
        ['draught, m', figure(kDraught), figure(kLengths[2] / 2 - last.height, 5)],
        ['speed after 60 s, mm/s, mrad/s', '0', `${figure(1000 * last.speed, 2)}, ${figure(1000 * last.spin, 2)}`],
        ['time until it is below 10 mm/s and 10 mrad/s, s', '', fast + 1 < samples.length ? figure((fast + 1) / rate) : 'above 60'],
    ];
}

function hundred(World, rate) {
    const places = Array.from({length: 100}, (_, i) => ({position: [4 * (i % 10), 4 * Math.floor(i / 10), 0.02 * (i % 37) - 0.2], quaternion: [1, 0, 0, 0]}));
    const {times} = float(World, rate, 5, 'usual', places, 5);
    return [['time of a step, median / worst, us', '', time_of(times)], ['of a box, median, us', '', figure(mid(times) / places.length)]];
}

compare('Heave', heave);
compare('Rest', rest);
compare('100 boxes', hundred);
