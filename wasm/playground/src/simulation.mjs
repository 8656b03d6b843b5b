// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene that runs, without anything of a browser: tests/wasm/playground_test.mjs runs them under Node. Contacts are world-managed, so
// that no function of JavaScript is called in a step, but for the height of waves.
import {Kit} from './kit.mjs';
import {scenes} from './scenes/all.mjs';

export const kMethods = ['hybrid', 'quick', 'exact', 'substeps'];
const kRate = 60, kBalls = 24, kBallRadius = 0.3;
const kHandFrequency = 2.5;  // Hz, of the spring with which the mouse pulls

// The value of each slider, in its range.
export function values_of(scene, given = {}) {
    return Object.fromEntries(Object.entries(scenes[scene].sliders).map(([name, {low, high, value}]) => {
        const wanted = Number(given[name] ?? value);
        return [name, Number.isFinite(wanted) ? Math.min(high, Math.max(low, wanted)) : value];
    }));
}

export class Simulation {
    constructor(engine, scene, given = {}, method = 'hybrid') {
        const of = scenes[scene];
        Object.assign(this, {engine, scene, method, values: values_of(scene, given), time: 0, balls: [], hand: null});
        this.h = 1 / (of.rate ?? kRate);
        this.world = engine.createWorld(of.world ?? {});
        this.kit = new Kit(engine, this.world);
        this.hooks = of.build(this.kit, this.values) ?? {};
        this.changed();
    }

    // After bodies were created or destroyed: whoever draws compares `generation`.
    changed() {
        this.generation = (this.generation ?? 0) + 1;
        this.states?.destroy();
        this.bodies = this.world.bodies.filter(body => body !== this.hand?.body);
        this.states = this.world.createStates(this.bodies, ['position', 'quaternion']);
    }

    step() {
        if (this.hooks.before_step?.(this.h, this.time, this)) {
            this.world.refresh();
            this.changed();
        }
        this.world.step(this.h, this.method);
        this.time += this.h;
    }

    // A value that the scene takes as it runs. False: it begins again for it.
    set(name, value) {
        this.values[name] = value;
        const take = this.hooks.set?.[name];
        take?.(value);
        return take !== undefined;
    }

    // x y z, then w x y z, of all bodies, then of what the scene draws besides.
    poses() {
        const {shown} = this.kit, rows = this.states.read(), all = new Float32Array(rows.length + 7 * shown.length);
        all.set(rows);
        shown.forEach(({pose}, i) => all.set(pose().flat(), rows.length + 7 * i));
        return all;
    }

    // J: of the motion, and of the height above z = 0.
    energy() {
        const [gx, gy, gz] = this.world.gravity;
        let kinetic = 0, potential = 0;
        for (const body of this.bodies) {
            if (body.kinematic) continue;
            const {mass, inertia} = body.massProperties, v = body.linearVelocity, w = body.vectorFromWorld(body.angularVelocity), p = body.position;
            kinetic += 0.5 * (mass * dot(v, v) + dot(w, [0, 3, 6].map(row => dot(inertia.slice(row, row + 3), w))));
            potential -= mass * dot([gx, gy, gz], p);
        }
        return {kinetic, potential};
    }

    // A ball flies from a point with a velocity; of many the oldest ends.
    throw_ball(from, velocity) {
        if (this.balls.length >= kBalls) this.balls.shift().destroy();
        const ball = this.kit.solid('sphere', {radius: kBallRadius}, from, {color: 6, density: 3000, linearVelocity: velocity});
        ball.geoms[0].continuous = 'on';  // it moves by more than a brick in a step
        this.balls.push(ball);
        this.changed();
    }

    // A spring pulls the point of a body (world frame) to where move_hand says: implicit, and so stable at any mass.
    grab(body, point) {
        const hand = this.world.createBody({position: point, kinematic: true}), joint = this.world.createJoint('ball', body, hand, {anchor: point});
        const rate = 2 * Math.PI * kHandFrequency, stiffness = body.mass * rate * rate, damping = 2 * body.mass * rate;
        joint.setParam('erp', this.h * stiffness / (this.h * stiffness + damping));
        joint.setParam('cfm', 1 / (this.h * stiffness + damping));
        body.enabled = true;
        this.hand = {body: hand, held: body};
    }

    // A blow at a point (world frame) that gives the body's mass a speed, m/s, along a direction.
    strike(body, point, direction, speed) {
        const {mass, inertia} = body.massProperties, size = Math.hypot(...direction), p = direction.map(x => mass * speed * x / size);
        const arm = body.position.map((x, k) => point[k] - x), turn = body.vectorFromWorld(cross(arm, p));
        const w = body.vectorToWorld(solved(inertia, turn));
        body.enabled = true;
        body.linearVelocity = body.linearVelocity.map((x, k) => x + p[k] / mass);
        body.angularVelocity = body.angularVelocity.map((x, k) => x + w[k]);
    }

    move_hand(point) {
        if (!this.hand) return;
        this.hand.body.position = point;
        if (!this.hand.held.isDestroyed) this.hand.held.enabled = true;
    }

    release() {
        this.hand?.body.destroy();
        this.hand = null;
    }

    destroy() {
        this.states.destroy();
        this.hooks.destroy?.();
        this.world.destroy();
    }
}

const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];

// I x = b of a symmetric matrix of nine numbers, by Cramer's rule.
function solved(I, b) {
    const rows = [0, 3, 6].map(row => I.slice(row, row + 3)), [x, y, z] = [cross(rows[1], rows[2]), cross(rows[2], rows[0]), cross(rows[0], rows[1])];
    return [0, 1, 2].map(k => (x[k] * b[0] + y[k] * b[1] + z[k] * b[2]) / dot(rows[0], x));
}

const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
