// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds that the page shows, without anything of a browser: tests/wasm/page_test.mjs runs them under Node. Contacts are
// world-managed, so no function of JavaScript is called during a step. Balls to throw exist from the beginning, disabled
// and unseen: the page draws a fixed number of solids.
const kBalls = 20, kBallRadius = 0.35;
export const kStep = 1 / 60;

// Builds a scene: `bodies` has for each body {body, shape, size, color}, shape one of those that view.js draws.
class Builder {
    constructor(ode, world, space) {
        Object.assign(this, {ode, world, space, bodies: []});
        this.mass = ode.create('dMass');
        this.rolling = ode.create('dMaterial', {rolling_friction: 0.01});  // a centimetre: grass
    }

    add(shape, size, density, [x, y, z], color) {
        const {ode} = this, mass = this.mass.pointer, body = ode.dBodyCreate(this.world);
        const [make, weigh] = {
            box: [ode.dCreateBox, ode.dMassSetBox],
            sphere: [ode.dCreateSphere, ode.dMassSetSphere],
            capsule: [ode.dCreateCapsule, (m, d, radius, length) => ode.dMassSetCapsule(m, d, 3, radius, length)],
            cylinder: [ode.dCreateCylinder, (m, d, radius, length) => ode.dMassSetCylinder(m, d, 3, radius, length)],
        }[shape];
        const geom = make(this.space, ...size);
        weigh(mass, density, ...size);
        ode.dBodySetMass(body, mass);
        ode.dGeomSetBody(geom, body);
        if (shape !== 'box') ode.dGeomSetMaterial(geom, this.rolling.pointer);
        ode.dBodySetPosition(body, x, y, z);
        this.bodies.push({body, geom, shape, size, color});
        return body;
    }

    free() {
        this.ode.free(this.mass.pointer);
        this.ode.free(this.rolling.pointer);
    }

    // Two bodies turn about an axis along y at a point; body 0 is the world.
    hinge(a, b, [x, y, z]) {
        const joint = this.ode.dJointCreateHinge(this.world, 0);
        this.ode.dJointAttach(joint, a, b);
        this.ode.dJointSetHingeAnchor(joint, x, y, z);
        this.ode.dJointSetHingeAxis(joint, 0, 1, 0);
    }
}

export const scenes = {
    wall(build) {
        const [x, y, z] = [0.3, 0.6, 0.3], rows = 10, columns = 10;
        for (let row = 0; row < rows; ++row) {
            const shift = row % 2 ? 0.5 : 0;
            for (let i = 0; i < columns; ++i)
                build.add('box', [x, 0.995 * y, z], 800, [0, (i + shift - columns / 2) * y, (row + 0.5) * z], (row + i) % 2);
        }
    },

    pile(build) {
        const shapes = [['box', [0.5, 0.4, 0.3]], ['sphere', [0.25]], ['capsule', [0.15, 0.35]], ['cylinder', [0.22, 0.4]]];
        for (let i = 0; i < 250; ++i) {
            const [shape, size] = shapes[i % 4], layer = Math.floor(i / 25);
            const at = [0.6 * (i % 5 - 2) + 0.05 * (layer % 3), 0.6 * (Math.floor(i / 5) % 5 - 2) + 0.04 * (layer % 2), 0.4 + 0.6 * layer];
            build.add(shape, size, 700, at, 2 + i % 4);
        }
    },

    bridge(build) {
        const planks = 16, length = 0.5, height = 3;
        let last = 0;
        for (let i = 0; i < planks; ++i) {
            const x = (i - planks / 2 + 0.5) * length;
            const plank = build.add('box', [0.94 * length, 1.6, 0.1], 600, [x, 0, height], i % 2);
            build.hinge(plank, last, [x - length / 2, 0, height]);
            last = plank;
        }
        build.hinge(last, 0, [planks * length / 2, 0, height]);
        for (let i = 0; i < 24; ++i) {
            const at = [-2 + 0.8 * (i % 6), -0.3 + 0.6 * (i % 2), height + 1 + 0.5 * Math.floor(i / 6)];
            build.add(i % 3 ? 'box' : 'cylinder', i % 3 ? [0.35, 0.35, 0.35] : [0.2, 0.4], 300, at, 2 + i % 4);
        }
    },
};

export class Simulation {
    constructor(ode, scene) {
        this.ode = ode;
        this.world = ode.dWorldCreate();
        this.space = ode.dHashSpaceCreate(0);
        ode.dWorldUseDefaults(this.world, ode.dDefaultsGame);
        ode.dWorldSetGravity(this.world, 0, 0, -9.81);
        ode.dWorldSetContactSpace(this.world, this.space);
        ode.dCreatePlane(this.space, 0, 0, 1, 0);
        const build = new Builder(ode, this.world, this.space);
        scenes[scene](build);
        this.balls = this.make_balls(build);
        this.bodies = build.bodies;
        this.thrown = 0;
        this.handles = ode.new_ints(this.bodies.map(({body}) => body));
        this.states = ode.malloc(7 * 8 * this.bodies.length);
        build.free();
    }

    make_balls(build) {
        const first = build.bodies.length;
        for (let i = 0; i < kBalls; ++i) {
            const body = build.add('sphere', [kBallRadius], 3000, [0, 0, -10 - i], 6), {geom} = build.bodies.at(-1);
            this.ode.dBodyDisable(body);
            this.ode.dGeomDisable(geom);
            this.ode.dGeomSetContinuous(geom, 1);  // it moves by more than a brick in a step
        }
        return {first, count: kBalls};
    }

    step() { return this.ode.dWorldStepHybrid(this.world, kStep); }

    // The oldest ball flies from a point with a velocity; they are taken in turn.
    throw_ball(from, velocity) {
        const {ode} = this, {body, geom} = this.bodies[this.balls.first + this.thrown++ % this.balls.count];
        ode.dBodySetPosition(body, ...from);
        ode.dBodySetLinearVel(body, ...velocity);
        ode.dBodySetAngularVel(body, 0, 0, 0);
        ode.dBodyEnable(body);
        ode.dGeomEnable(geom);
    }

    // Whether a body is to be seen.
    is_seen(i) { return i < this.balls.first + Math.min(this.thrown, this.balls.count); }

    // Position and quaternion w x y z of each body, seven numbers a body, in one call.
    poses() {
        const {ode} = this, fields = ode.dStatePosition | ode.dStateQuaternion;
        ode.dBodiesGetStates(this.handles, this.bodies.length, fields, this.states, 0);
        return ode.reals(this.states, 7 * this.bodies.length);
    }

    // The triangles of a body's shape in its frame, nine numbers each.
    triangles(i) {
        const {ode} = this, {geom} = this.bodies[i], count = ode.dGeomGetTriangles(geom, 24, 0, 0);
        const memory = ode.malloc(72 * count);
        ode.dGeomGetTriangles(geom, 24, memory, count);
        const copy = Float32Array.from(ode.reals(memory, 9 * count));
        ode.free(memory);
        return copy;
    }

    destroy() {
        this.ode.dWorldDestroy(this.world);
        this.ode.dSpaceDestroy(this.space);
        this.ode.free(this.handles);
        this.ode.free(this.states);
    }
}
