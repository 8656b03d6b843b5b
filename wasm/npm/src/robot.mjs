// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots in worlds: coordinates, velocities, controls.
import {ask, wanted} from './ask.mjs';
import {int32, numbers, real, refuse, shown} from './checks.mjs';
import {adopt_contents} from './copies.mjs';
import {EpodeError} from './errors.mjs';
import {Handle} from './handle.mjs';
/** @import {Body} from './body.mjs' */
/** @import {Joint} from './joint.mjs' */
/** @import {RobotModel} from './robot_model.mjs' */
/** @import {World} from './world.mjs' */

/** The bodies, joints and geoms that a model became in a world. RobotModel.build makes it. Do not destroy its parts one by one. */
export class Robot extends Handle {
    /**
     * For the package alone.
     * @param {RobotModel} model
     * @param {World} world
     * @param {number} pointer
     */
    constructor(model, world, pointer) {
        super(model.engine, pointer);
        /** @readonly What it was made of, which may be destroyed. */
        this.model = model;
        /** @readonly */
        this.world = world;
        adopt_contents(world, false);  // the library has the data of its meshes
        world.robots.add(this);
        const {c} = this.engine;
        /** @readonly The body of each link; null of the first, the world, and of others that have none. @type {(Body | null)[]} */
        this.bodies = model.links.map((_, i) => this.#own(() => c.dRobotGetBody(pointer, i)));
        /** @readonly The joint of each joint of the model; null of a free one. @type {(Joint | null)[]} */
        this.joints = model.joints.map((_, i) => this.#own(() => c.dRobotGetJoint(pointer, i)));
    }

    /** @param {() => number} get @returns {any} */
    #own(get) { return this.engine.object_at(ask(this.engine, 'Robot', get).result >>> 0); }

    /**
     * The body of a link, by its number or name. Links that were merged are those that they are part of.
     * @param {number | string} link
     * @returns {Body | null}
     */
    body(link) { return this.bodies[this.#number(link, this.bodies.length, name => this.model.findLink(name), 'Robot.body', 'link')]; }

    /**
     * The joint of a joint of the model, by its number or name.
     * @param {number | string} joint
     * @returns {Joint | null}
     */
    joint(joint) { return this.joints[this.#number(joint, this.joints.length, name => this.model.findJoint(name), 'Robot.joint', 'joint')]; }

    /** @param {unknown} value @param {number} count @param {(name: string) => number} find @param {string} label @param {string} what @returns {number} */
    #number(value, count, find, label, what) {
        void this.handle;
        const number = typeof value === 'string' ? find(value) : int32(value, label, what);
        if (!(number >= 0 && number < count)) throw new EpodeError('refused', `${label}: there is no ${what} ${shown(value)}`);
        return number;
    }

    /** The coordinates of all joints. Setting them puts all bodies there, at rest. @returns {Float64Array} */
    get positions() { return this.#reals('dRobotGetPositions', 'Robot.positions'); }

    /** @param {ArrayLike<number>} values */
    set positions(values) { this.#set('dRobotSetPositions', values, this.model.positionCount, 'Robot.positions'); }

    /** The velocities of all joints. @returns {Float64Array} */
    get velocities() { return this.#reals('dRobotGetVelocities', 'Robot.velocities'); }

    /** @param {ArrayLike<number>} values */
    set velocities(values) { this.#set('dRobotSetVelocities', values, this.model.velocityCount, 'Robot.velocities'); }

    /** What it has in addition to World.saveState: controls, activations, targets. Set it after World.loadState. @returns {Float64Array} */
    get state() { return this.#reals('dRobotGetState', 'Robot.state'); }

    /** @param {ArrayLike<number>} values */
    set state(values) { this.#set('dRobotSetState', values, -1, 'Robot.state'); }

    /** @param {string} of @param {string} label @returns {Float64Array} */
    #reals(of, label) {
        const e = this.engine, {handle} = this, count = ask(e, label, () => e.c[of](handle, 0, 0)).result, at = e.buffer(8 * count);
        ask(e, label, () => e.c[of](handle, at, count));
        return e.f64.slice(at >> 3, (at >> 3) + count);
    }

    /** @param {string} of @param {unknown} values @param {number} count @param {string} label */
    #set(of, values, count, label) {
        const e = this.engine, {handle} = this, given = numbers(values, count, label, 'values'), at = e.buffer(8 * given.length);
        e.f64.set(given, at >> 3);
        wanted(e, label, () => e.c[of](handle, at, given.length));
    }

    /** The controls of all actuators; setting them clamps each to its range. @returns {Float64Array} */
    get controls() { return Float64Array.from(this.model.actuators, (_, i) => this.control(i)); }

    /** @param {ArrayLike<number>} values */
    set controls(values) { numbers(values, this.model.actuators.length, 'Robot.controls', 'values').forEach((value, i) => this.setControl(i, value)); }

    /**
     * The control of an actuator, by its number or name.
     * @param {number | string} actuator
     * @returns {number}
     */
    control(actuator) {
        const e = this.engine, number = this.#actuator(actuator, 'Robot.control');
        return ask(e, 'Robot.control', () => e.c.dRobotGetControl(this.handle, number)).result;
    }

    /**
     * Sets the control of an actuator, clamped to its range.
     * @param {number | string} actuator
     * @param {number} control
     */
    setControl(actuator, control) {
        const label = 'Robot.setControl', e = this.engine, number = this.#actuator(actuator, label), value = real(control, label, 'control');
        wanted(e, label, () => e.c.dRobotSetControl(this.handle, number, value));
    }

    /** @param {number | string} actuator @param {string} label */
    #actuator(actuator, label) { return this.#number(actuator, this.model.actuators.length, name => this.model.findActuator(name), label, 'actuator'); }

    /**
     * Lets a hinge or slider be pulled to a target by a spring and a damper, at most with the joint's largest force.
     * @param {number | string} joint
     * @param {number} target m or rad
     * @param {{stiffness: number, damping: number}} drive both 0: no longer
     */
    setTarget(joint, target, {stiffness, damping}) {
        const label = 'Robot.setTarget', e = this.engine, number = this.#number(joint, this.joints.length, name => this.model.findJoint(name), label, 'joint');
        const values = [real(target, label, 'target'), real(stiffness, label, 'stiffness'), real(damping, label, 'damping')];
        wanted(e, label, () => e.c.dRobotSetTarget(this.handle, number, ...values));
    }

    /**
     * Adds what acts only from step to step: spatial tendons, the medium of the file, weights that are compensated; and moves the filters
     * of actuators on. Call it before each step of the world.
     * @param {number} h the step, s
     */
    addForces(h) {
        const label = 'Robot.addForces', e = this.engine, size = real(h, label, 'h');
        if (!(size > 0)) refuse(label, 'h', 'a step above 0', h);
        ask(e, label, () => e.c.dRobotAddForces(this.handle, size));
    }

    /** Where the links are in the world: seven numbers each, position and quaternion; those without a body are at the origin. @returns {Float64Array} */
    get linkPoses() {
        void this.handle;
        return Float64Array.from(this.bodies.flatMap(body => body ? [...body.position, ...body.quaternion] : [0, 0, 0, 1, 0, 0, 0]));
    }

    /** Destroys the robot's bodies, joints and geoms. */
    destroy() {
        const e = this.engine, {handle, world} = this;
        ask(e, 'Robot.destroy', () => e.c.dRobotDestroy(handle));
        this.set_alive(false);
        world.robots.delete(this);
        world.refresh();
    }
}
