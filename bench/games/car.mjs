// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A car of 1,200 kg on a skid pad: four wheels by rays, springs of 30 kN/m, rear-wheel drive by an open differential in one gear, tyres with mu = 1 that
// lose nothing in slip or with load, no drag, so that there are closed forms. Jolt's tyres have the same curve, point by point; it takes the root of
// tyre times floor, so the points are squares; the slip angle says that they arrive. Both cars steer with
// parallel front wheels and a throttle that holds the speed: 0.5 (v_0 - v) + its integral.
//   circle    v = 10 m/s and front wheels at delta. Bicycle model with both axles at the slip alpha that the lateral force takes (the centre of mass
//             is in the middle, tyres are proportional to load): r (L / v_x) = tan(delta - alpha) + tan(alpha); y(c alpha) = v r / (mu g)
//   brakes    locked from 20 m/s: v^2 / (2 mu g)
//   slope     parked with the brake on 15 degrees
import {Jolt, EpodeWorld, JoltWorld, compare, figure, kGravity, largest, mean, numbers, play, rms, time_of, vec} from './common.mjs';

const kMass = 1200, kBase = 2.6, kTrack = 1.5, kRadius = 0.33, kHub = -0.4, kTravel = 0.25, kSpring = 30000, kDamping = 3000, kMaxSteer = 0.6;
const kStiffnessX = 18, kStiffnessY = 14, kTorque = 300, kGear = 2.1, kFinal = 3.8, kBrake = 4000, kSpeed = 10;
const kHubs = [[1, 1], [1, -1], [-1, 1], [-1, -1]].map(([x, y]) => [x * kBase / 2, y * kTrack / 2, kHub]);
const kBody = [4, 1.6, 0.4], kStart = 0.9;

// Force over load of a tyre at a slip, with stiffness c: src/vehicles/tyre.h with mu = 1.
function grip(slip, c) {
    const z = c * slip / 3;
    return z < 1 ? 3 * z - 3 * z ** 2 + z ** 3 : 1;
}

class EpodeCar {
    constructor(stage, speed) {
        this.h = stage.h;
        this.body = stage.world.createBody({position: [0, 0, kStart]});
        this.body.createGeom('box', {lengths: kBody});
        const [x, y, z] = inertia();
        this.body.massProperties = {mass: kMass, inertia: [x, 0, 0, 0, y, 0, 0, 0, z]};
        this.body.linearVelocity = [speed, 0, 0];
        this.car = this.body.makeVehicle({automatic: false, drag: 0, ackermann: 0, maxSteer: kMaxSteer, engineDrag: 0, torquePoints: 2,
            engineSpeeds: [0, 2000], engineTorques: [kTorque, kTorque], gears: 1, gearRatios: [kGear], finalRatio: kFinal, shiftTime: 0});
        kHubs.forEach((position, i) => this.car.addWheel({position, radius: kRadius, axle: i >> 1, steer: i < 2 ? 1 : 0, drive: i < 2 ? 0 : 1, travel: kTravel,
            stiffness: kSpring, bumpDamping: kDamping, reboundDamping: kDamping, frictionX: 1, frictionY: 1, stiffnessX: kStiffnessX, stiffnessY: kStiffnessY,
            sliding: 1, loadSensitivity: 0, rollingResistance: 0, brakeTorque: kBrake}));
    }
    control(throttle, brake, steer) { this.car.controls = {throttle, brake, steer}; }
    update() { this.car.update(this.h); }
    state() {
        const {position: place, linearVelocity: velocity, angularVelocity} = this.body;
        return {place, velocity, yaw: angularVelocity[2], forward: this.body.vectorToWorld([1, 0, 0])};
    }
}

function inertia() {
    const [x, y, z] = [4, 1.6, 0.6].map(length => kMass * length ** 2 / 12);
    return [y + z, x + z, x + y];
}

class JoltCar {
    constructor(stage, speed) {
        this.stage = stage;
        this.body = stage.body({lengths: kBody, position: [0, 0, kStart]}, 'Dynamic', settings => {
            const [x, y, z] = inertia();
            settings.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
            settings.mMassPropertiesOverride.mMass = kMass;
            settings.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(vec([x, y, z]));
        });
        stage.bodies.SetLinearVelocity(this.body.GetID(), vec([speed, 0, 0]));
        const settings = new Jolt.VehicleConstraintSettings();
        kHubs.forEach((hub, i) => settings.mWheels.push_back(this.wheel(hub, i < 2)));
        settings.mController = this.controller();
        this.constraint = new Jolt.VehicleConstraint(this.body, settings);
        this.constraint.SetVehicleCollisionTester(new Jolt.VehicleCollisionTesterRay(stage.layer));
        stage.system.AddConstraint(this.constraint);
        stage.system.AddStepListener(new Jolt.VehicleConstraintStepListener(this.constraint));
        this.driver = Jolt.castObject(this.constraint.GetController(), Jolt.WheeledVehicleController);
        this.driver.GetTransmission().Set(1, 1);
    }
    wheel(hub, steers) {
        const wheel = new Jolt.WheelSettingsWV();
        wheel.mPosition = vec([hub[0], hub[1], hub[2] + kTravel]);
        wheel.mSuspensionMinLength = 0;
        wheel.mSuspensionMaxLength = kTravel;
        wheel.mSuspensionSpring.mMode = Jolt.ESpringMode_StiffnessAndDamping;
        wheel.mSuspensionSpring.mStiffness = kSpring;
        wheel.mSuspensionSpring.mDamping = kDamping;
        [wheel.mRadius, wheel.mWidth, wheel.mInertia, wheel.mAngularDamping] = [kRadius, 0.2, 1, 0];
        [wheel.mMaxSteerAngle, wheel.mMaxBrakeTorque] = [steers ? kMaxSteer : 0, kBrake];
        for (const [curve, c, unit] of [[wheel.mLongitudinalFriction, kStiffnessX, 1], [wheel.mLateralFriction, kStiffnessY, 180 / Math.PI]]) {
            curve.Clear();
            for (let i = 0; i <= 60; ++i) {
                const slip = i / 60 * 3 / c;
                curve.AddPoint(unit * Math.atan(slip), grip(slip, c) ** 2);
            }
        }
        return wheel;
    }
    controller() {
        const made = new Jolt.WheeledVehicleControllerSettings(), {mEngine: engine, mTransmission: gears} = made, rear = new Jolt.VehicleDifferentialSettings();
        [engine.mMaxTorque, engine.mMinRPM, engine.mMaxRPM, engine.mAngularDamping] = [kTorque, 500, 20000, 0];
        engine.mNormalizedTorque.Clear();
        engine.mNormalizedTorque.AddPoint(0, 1);
        engine.mNormalizedTorque.AddPoint(1, 1);
        gears.mMode = Jolt.ETransmissionMode_Manual;
        gears.mGearRatios.clear();
        gears.mGearRatios.push_back(kGear);
        [rear.mLeftWheel, rear.mRightWheel, rear.mDifferentialRatio, rear.mLimitedSlipRatio] = [2, 3, kFinal, Number.MAX_VALUE];
        made.mDifferentials.push_back(rear);
        made.mDifferentialLimitedSlipRatio = Number.MAX_VALUE;
        return made;
    }
    control(throttle, brake, steer) { this.driver.SetDriverInput(throttle, -steer, brake, 0); }
    update() {}
    state() {
        const {body} = this, [place, velocity] = [numbers(body.GetPosition()), numbers(body.GetLinearVelocity())];
        return {place, velocity, yaw: numbers(body.GetAngularVelocity())[2], forward: numbers(body.GetRotation().RotateAxisZ())};
    }
}

// way(t) gives {steer, brake, hold}: hold is the speed that the throttle holds.
function drive(World, rate, seconds, way, {speed = kSpeed, slope = 0} = {}, runs) {
    return play(() => {
        const stage = new World(1 / rate), car = new (World === EpodeWorld ? EpodeCar : JoltCar)(stage, speed);
        if (slope) tilt(stage, slope);
        stage.still({lengths: [400, 400, 1], position: [0, 0, -0.5]});
        let integral = 0;
        return {
            before(i) {
                const {steer = 0, brake = 0, hold} = way(i / rate), {velocity} = car.state(), missing = hold === undefined ? 0 : hold - Math.hypot(velocity[0], velocity[1]);
                integral = Math.min(1, Math.max(0, integral + 0.2 * missing / rate));
                car.control(hold === undefined ? 0 : Math.min(1, Math.max(0, 0.5 * missing + integral)), brake, steer);
            },
            step() {
                car.update();
                stage.step();
            },
            sample: () => car.state(),
            end: () => stage.end(),
        };
    }, Math.round(seconds * rate), runs);
}

// A slope is gravity that leans back.
function tilt(stage, slope) {
    const gravity = [-kGravity * Math.sin(slope), 0, -kGravity * Math.cos(slope)];
    if (stage instanceof JoltWorld) stage.system.SetGravity(vec(gravity));
    else stage.world.gravity = gravity;
}

// The yaw rate and the rear axle's slip angle of the bicycle model at speed v of the centre of mass.
function bicycle(v, delta) {
    let rate = 0, alpha = 0;
    for (let n = 0; n < 200; ++n) {
        const needed = v * rate / kGravity, z = 1 - Math.cbrt(1 - needed);
        alpha = Math.atan(3 * z / kStiffnessY);
        const side = Math.tan(delta - alpha), rear = Math.tan(alpha), beta = (side - rear) / 2;
        rate += 0.3 * (v / Math.hypot(1, beta) * (side + rear) / kBase - rate);
    }
    return {rate, alpha};
}

// The centre of the circle that fits points best (least squares of x^2 + y^2 - 2 a x - 2 b y - c).
function centre(points) {
    const ox = mean(points.map(p => p[0])), oy = mean(points.map(p => p[1]));
    const list = points.map(([x, y]) => [x - ox, y - oy]), sum = f => list.reduce((all, [x, y]) => all + f(x, y, x * x + y * y), 0);
    const [xx, xy, yy, xr, yr] = [sum((x) => x * x), sum((x, y) => x * y), sum((x, y) => y * y), sum((x, y, r) => x * r), sum((x, y, r) => y * r)];
    const det = 2 * (xx * yy - xy * xy);
    return [ox + (xr * yy - yr * xy) / det, oy + (yr * xx - xr * xy) / det];
}

// Of the middle of three samples: its heading against the path, which is what one sees. Velocities are those of the middles of steps.
function slip_of({yaw, forward: [fx, fy]}, before, after, rate) {
    const [vx, vy] = [0, 1].map(k => (after.place[k] - before.place[k]) * rate / 2);
    return Math.atan2(yaw * kBase / 2 - (vy * fx - vx * fy), vx * fx + vy * fy);
}

function circle(World, rate, delta) {
    const {samples, times} = drive(World, rate, 45, t => ({steer: t < 2 ? 0 : delta / kMaxSteer, hold: kSpeed}));
    const steady = samples.slice(15 * rate), rates = steady.map(s => s.yaw), speed = mean(steady.map(s => Math.hypot(s.velocity[0], s.velocity[1])));
    const model = bicycle(speed, delta), lap = Math.min(steady.length / 3, Math.round(2 * Math.PI / mean(rates) * rate)) | 0, places = steady.map(s => s.place);
    const [first, last] = [centre(places.slice(0, lap)), centre(places.slice(-lap))];
    return [
        ['speed, m/s', figure(kSpeed), figure(speed, 4)],
        ['yaw rate over that of the bicycle model at this speed, %', '0', figure(100 * (mean(rates) / model.rate - 1), 2)],
        ['slip angle of the rear axle over the model\'s, %', '0', figure(100 * (mean(steady.slice(1, -1).map((s, i) => slip_of(s, steady[i], steady[i + 2], rate))) / model.alpha - 1), 2)],
        ['jitter of the yaw rate, rms, %', '0', figure(100 * rms(rates.map(r => r / mean(rates) - 1)), 2)],
        ['drift of the centre in 30 s, m', '0', figure(Math.hypot(last[0] - first[0], last[1] - first[1]), 2)],
        ['heave, rms, mm', '0', figure(1000 * rms(steady.map(s => s.place[2] - mean(steady.map(t => t.place[2])))), 2)],
        ['time of a step, median / worst, us', '', time_of(times)],
    ];
}

function brakes(World, rate) {
    const from = 6 * rate, {samples, times} = drive(World, rate, 14, t => (t < 6 ? {hold: 20} : {brake: 1}), {speed: 20});
    const start = samples[from - 1], v = start.velocity[0], stop = samples.at(-1);
    const stands = samples.slice(12 * rate), creep = Math.hypot(...stands.at(-1).place.map((x, k) => x - stands[0].place[k]));
    const parked = drive(World, rate, 32, () => ({brake: 1}), {speed: 0, slope: Math.PI / 12}, 1).samples;
    return [
        ['speed as it brakes, m/s', '20', figure(v, 4)],
        ['distance over v²/(2 mu g), %', '0', figure(100 * ((stop.place[0] - start.place[0]) / (v * v / (2 * kGravity)) - 1), 2)],
        ['goes back once it has stopped, mm', '', figure(1000 * (largest(samples.map(s => s.place[0])) - stop.place[0]), 2)],
        ['off its line, mm', '0', figure(1000 * stop.place[1], 2)],
        ['creep in the 2 s after, mm', '0', figure(1000 * creep, 2)],
        ['creep in 30 s on 15 degrees, mm', '0', figure(1000 * Math.hypot(...parked.at(-1).place.map((x, k) => x - parked[2 * rate].place[k])), 2)],
        ['time of a step, median / worst, us', '', time_of(times)],
    ];
}

compare('Circle, wheels at 0.05 rad', (World, rate) => circle(World, rate, 0.05));
compare('Circle, wheels at 0.12 rad', (World, rate) => circle(World, rate, 0.12));
compare('Brakes', brakes);
