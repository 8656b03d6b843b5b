// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A character, a capsule of 0.3 m and 1.8 m that may climb 0.35 m and stand on 45 degrees, at 1.9 m/s (no whole number of steps a stair): 20 stairs up and down, slopes of 30 and
// 50 degrees, a lift, a raft and a turntable that carry it. Jolt's CharacterVirtual gets the velocity that its manual recommends: that of the
// ground where it stands, else its own upward part; gravity; and where it wants to go. Both characters move before the step of the world.
// Heights are compared with those of a ball that rolls over the same profile at the engine's own gap.
import {Jolt, EpodeWorld, compare, far, figure, kGravity, largest, least, mean, numbers, play, quat, rms, time_of, vec} from './common.mjs';

const kRadius = 0.3, kHeight = 1.8, kClimb = 0.35, kStick = 0.5, kSpeed = 1.9, kStairs = 20, kRun = 0.3, kLimit = Math.PI / 4, kStart = 0.02;

class EpodeWalker {
    static bottom = 0.01;  // m, of the shape over feet(): the gap that it keeps
    constructor(stage, position) {
        this.h = stage.h;
        this.made = stage.world.createGeom('character', {position, settings:
            {radius: kRadius, height: kHeight, slopeLimit: kLimit, stepHeight: kClimb, stickDistance: kStick, skin: 0.01}});
    }
    walk(velocity) { this.made.walk(velocity, 0, this.h); }
    feet() { return this.made.position; }
    stands() { return this.made.report.state === 'onGround'; }
}

class JoltWalker {
    static bottom = 0.02;
    constructor(stage, position) {
        this.h = stage.h;
        const settings = new Jolt.CharacterVirtualSettings(), shape = new Jolt.CapsuleShapeSettings(kHeight / 2 - kRadius, kRadius);
        settings.mShape = new Jolt.RotatedTranslatedShapeSettings(vec([0, 0, kHeight / 2]), quat([1, 0, 0, 0]), shape).Create().Get();
        settings.mMaxSlopeAngle = kLimit;
        settings.mCharacterPadding = 0.02;
        this.made = new Jolt.CharacterVirtual(settings, far(position), quat([1, 0, 0, 0]), stage.system);
        this.update = new Jolt.ExtendedUpdateSettings();
        this.update.mWalkStairsStepUp = vec([0, 0, kClimb]);
        this.update.mStickToFloorStepDown = vec([0, 0, -kStick]);
        [this.gravity, this.velocity, this.filters, this.memory] = [vec([0, 0, -kGravity]), vec([0, 0, 0]), stage.filters(), stage.made.GetTempAllocator()];
        this.stay();
    }
    // Its manual's way to stand on a slope: while it wants to go nowhere, ground that does not move gives it no velocity.
    stay() {
        const listener = this.listener = new Jolt.CharacterContactListenerJS();
        for (const name of ['OnAdjustBodyVelocity', 'OnCharacterContactAdded', 'OnCharacterContactPersisted', 'OnCharacterContactRemoved', 'OnCharacterContactSolve',
            'OnContactAdded', 'OnContactPersisted', 'OnContactRemoved']) listener[name] = () => {};
        listener.OnContactValidate = listener.OnCharacterContactValidate = () => true;
        listener.OnContactSolve = (character, body, part, place, normal, speed, material, old, made) => {
            const still = Jolt.wrapPointer(speed, Jolt.Vec3).LengthSq() < 1e-12;
            if (still && !this.made.IsSlopeTooSteep(Jolt.wrapPointer(normal, Jolt.Vec3))) Jolt.wrapPointer(made, Jolt.Vec3).Set(0, 0, 0);
        };
    }
    walk(wanted) {
        const c = this.made, up = c.GetLinearVelocity().GetY();
        this.listens(wanted.every(x => x === 0));
        c.UpdateGroundVelocity();
        const [gx, gy, gz] = numbers(c.GetGroundVelocity());
        const stands = c.GetGroundState() === Jolt.EGroundState_OnGround && up - gz < 0.1;
        const [x, y, z] = stands ? [gx, gy, gz] : [0, 0, up];
        this.velocity.Set(y + wanted[1], z - kGravity * this.h, x + wanted[0]);
        c.SetLinearVelocity(this.velocity);
        c.ExtendedUpdate(this.h, this.gravity, this.update, ...this.filters, this.memory);
    }
    // Only while it stands: calls from WebAssembly cost time.
    listens(on) {
        if (on === this.on) return;
        this.on = on;
        if (on) this.made.SetListener(this.listener);
    }
    feet() { return numbers(this.made.GetPosition()); }
    stands() { return this.made.GetGroundState() === Jolt.EGroundState_OnGround; }
}

const floor = {lengths: [20, 6, 1], position: [-8, 0, -0.5]};
const stairs = rise => Array.from({length: kStairs}, (_, i) => {
    const long = i === kStairs - 1 ? 10 : kRun, high = rise * (i + 1);
    return {lengths: [long, 6, high], position: [2 + kRun * i + long / 2, 0, high / 2]};
});
// Its upper side goes up from the origin.
function slope(angle) {
    const [s, c] = [Math.sin(angle), Math.cos(angle)];
    return {lengths: [20, 6, 1], position: [10 * c + s / 2, 0, 10 * s - c / 2], quaternion: [Math.cos(angle / 2), 0, -Math.sin(angle / 2), 0]};
}

// A run whose velocity is way(t); `carrier` is what it stands on, `late` moves it after the step of the world.
function walk(World, rate, {boxes, from, way, seconds, carrier, late}, runs) {
    const h = 1 / rate;
    return play(() => {
        const stage = new World(h), walker = new (World === EpodeWorld ? EpodeWalker : JoltWalker)(stage, from);
        boxes.forEach(box => stage.still(box));
        const driven = carrier && stage.driven(carrier);
        return {
            before: i => { if (driven) stage.drive(driven, carrier.motion(i * h, h)); },
            step: i => late || walker.walk(way(i * h)),
            sample(i) {
                stage.step();
                if (late) walker.walk(way(i * h));
                return {feet: walker.feet(), stands: walker.stands(), carrier: driven && stage.position(driven)};
            },
            end: () => stage.end(),
        };
    }, Math.round(seconds * rate), runs);
}

const bottom_of = World => (World === EpodeWorld ? EpodeWalker : JoltWalker).bottom;

// Of the capsule's lower ball from the stairs, if the centre of that is at (x, z).
function clearance(x, z, rise) {
    let away = z;
    for (let i = 0; i < kStairs; ++i) away = Math.min(away, Math.hypot(Math.max(2 + kRun * i - x, 0), Math.max(z - rise * (i + 1), 0)));
    return away - kRadius;
}

function on_stairs(World, rate, rise) {
    const up = 2 + kRun * (kStairs - 1) + 2, half = up / kSpeed;
    const {samples, times} = walk(World, rate, {boxes: [floor, ...stairs(rise)], from: [0, 0, kStart], seconds: 2 * half,
        way: t => [t < half ? kSpeed : -kSpeed, 0, 0]});
    const speeds = samples.slice(1).map((s, i) => Math.abs(s.feet[0] - samples[i].feet[0]) * rate);
    const turn = Math.round(half * rate), inside = i => samples[i].feet[0] > 2 && samples[i].feet[0] < up - 2;
    const away = samples.map(({feet: [x, , z]}) => clearance(x, z + bottom_of(World) + kRadius, rise));
    const of = (list, from, to) => list.filter((_, i) => i >= from && i < to && inside(i));
    const drops = of(samples.slice(1).map((s, i) => samples[i].feet[2] - s.feet[2]), 0, turn);
    return [
        [`height at the top, m`, figure(kStairs * rise), figure(samples[turn - 1].feet[2], 4)],
        ['gap to the stairs going up, least, largest, mm', '', `${figure(1000 * least(of(away, 0, turn)), 2)}, ${figure(1000 * largest(of(away, 0, turn)), 2)}`],
        ['largest drop in a step going up, mm', '0', figure(1000 * Math.max(0, largest(drops)), 2)],
        ['horizontal speed up, mean, m/s', figure(kSpeed), figure(mean(of(speeds, 0, turn)))],
        ['its jitter, rms, m/s', '0', figure(rms(of(speeds, 0, turn).map(v => v - kSpeed)), 2)],
        ['horizontal speed down, mean, m/s', figure(kSpeed), figure(mean(of(speeds, turn, samples.length)))],
        ['its jitter, rms, m/s', '0', figure(rms(of(speeds, turn, samples.length).map(v => v - kSpeed)), 2)],
        ['steps in the air, up and down', '0', `${of(samples, 0, samples.length).filter(s => !s.stands).length}`],
        ['time of a move, median / worst, us', '', time_of(times)],
    ];
}

// Where feet are on level ground: Epode's are the ground's, Jolt's keep the gap.
const rests = new Map();
function rest_of(World) {
    if (!rests.has(World)) {
        const {samples} = walk(World, 60, {boxes: [floor], from: [0, 0, kStart], way: t => [t < 1 ? 1 : 0, 0, 0], seconds: 2}, 1);
        rests.set(World, samples.at(-1).feet[2]);
    }
    return rests.get(World);
}

function on_slopes(World, rate) {
    const angle = Math.PI / 6, tan = Math.tan(angle);
    const {samples, times} = walk(World, rate, {boxes: [floor, slope(angle)], from: [-1, 0, kStart], seconds: 6, way: t => [t < 3 ? kSpeed : 0, 0, 0]});
    const speeds = samples.slice(1).map((s, i) => (s.feet[0] - samples[i].feet[0]) * rate);
    const walked = samples.filter((s, i) => s.feet[0] > 1 && i < 3 * rate - 1), fast = speeds.slice(Math.round(1.2 * rate), 3 * rate - 2);
    const off = walked.map(({feet: [x, , z]}) => z - x * tan), level = mean(off), stop = samples[3 * rate + 5].feet, end = samples.at(-1).feet;
    const steep = slope(50 * Math.PI / 180), pressed = walk(World, rate, {boxes: [floor, steep], from: [-1, 0, kStart], seconds: 5, way: () => [kSpeed, 0, 0]}, 1).samples;
    const at = [4, 0, 4 * Math.tan(50 * Math.PI / 180) + 0.6], slid = walk(World, rate, {boxes: [floor, steep], from: at, seconds: 1.5, way: () => [0, 0, 0]}, 1).samples;
    const velocity = i => Math.hypot(...slid[i].feet.map((x, k) => x - slid[i - 1].feet[k])) * rate;
    return [
        ['horizontal speed up 30 degrees, m/s', figure(kSpeed), figure(mean(fast), 4)],
        ['its jitter, rms, m/s', '0', figure(rms(fast.map(v => v - mean(fast))), 2)],
        ['height there, rms, mm', '0', figure(1000 * rms(off.map(x => x - level)), 2)],
        ['creep in 3 s of standing there, mm', '0', figure(1000 * Math.hypot(...end.map((x, k) => x - stop[k])), 2)],
        ['height won against 50 degrees in 5 s, mm', '0', figure(1000 * (largest(pressed.map(s => s.feet[2])) - rest_of(World)), 2)],
        ['acceleration down 50 degrees, m/s²', figure(kGravity * Math.sin(50 * Math.PI / 180)), figure((velocity(rate) - velocity(rate / 2)) / 0.5)],
        ['time of a move, median / worst, us', '', time_of(times)],
    ];
}

// Lift: 1 m up and down in 3 s; raft: 4 m to and fro in 4 s, both after a second of rest; turntable: 0.5 rad/s, 1.5 m from its axis, one turn. The velocity
// of the middle of the step makes the motion exact.
const kRest = 1;
const swing = (size, period, axis) => (t, h) => {
    const at = time => size * (1 - Math.cos(2 * Math.PI * Math.max(time - kRest, 0) / period)) / 2, velocity = [0, 0, 0];
    velocity[axis] = (at(t + h) - at(t)) / h;
    return {velocity, spin: 0};
};
function carried(World, rate, motion, seconds, from, late = false) {
    const carrier = {lengths: [4, 4, 0.5], position: [0, 0, -0.25], motion};
    return walk(World, rate, {boxes: [], from, way: () => [0, 0, 0], seconds, carrier, late}, 1).samples;
}

function on_carriers(World, rate) {
    const relative = list => list.map(s => s.feet.map((x, k) => x - s.carrier[k]));
    const settled = (motion, seconds, late) => relative(carried(World, rate, motion, kRest + seconds, [0, 0, kStart], late)).slice(rate / 2);
    const lag = list => figure(1000 * largest(list.map(x => Math.abs(x - list[0]))), 2), sway = swing(4, 4, 0), rise = swing(1, 3, 2);
    const raft = settled(sway, 12), lift = settled(rise, 12);
    const turn = 2 * Math.PI / 0.5, table = carried(World, rate, () => ({velocity: [0, 0, 0], spin: 0.5}), turn, [1.5, 0, kStart]);
    return [
        ['raft: drift in 12 s, mm', '0', figure(1000 * Math.hypot(raft.at(-1)[0] - raft[0][0], raft.at(-1)[1]), 2)],
        ['raft: largest lag, moved before the step / after, mm', '0', `${lag(raft.map(p => p[0]))} / ${lag(settled(sway, 12, true).map(p => p[0]))}`],
        ['lift: likewise, mm', '0', `${lag(lift.map(p => p[2]))} / ${lag(settled(rise, 12, true).map(p => p[2]))}`],
        ['turntable: radius after a turn, m', '1.5', figure(Math.hypot(table.at(-1).feet[0], table.at(-1).feet[1]), 5)],
        ['turntable: largest error of the radius, mm', '0', figure(1000 * largest(table.map(s => Math.abs(Math.hypot(s.feet[0], s.feet[1]) - 1.5))), 2)],
    ];
}

compare('Stairs of 0.2 m', (World, rate) => on_stairs(World, rate, 0.2));
compare('Stairs of 0.3 m', (World, rate) => on_stairs(World, rate, 0.3));
compare('Slopes', on_slopes);
compare('What moves', on_carriers);
