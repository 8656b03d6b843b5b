// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Models of robots: what a file says, of which robots in worlds are made.
import {ask, wanted} from './ask.mjs';
import {numbers, options_of, quaternion, refuse, vector} from './checks.mjs';
import {Handle} from './handle.mjs';
import {Robot} from './robot.mjs';
import {size_of} from './structures.mjs';
import {World} from './world.mjs';
/** @import {Engine} from './engine.mjs' */
/** @import {QuaternionLike, Vector3, VectorLike} from './checks.mjs' */

/** @typedef {object} ReportLine
 * @property {'changed' | 'approximated' | 'ignored' | 'error'} note changed: read as something with the same motion; approximated: nearly the same
 * @property {string} file
 * @property {number} line 0 where it is unknown
 * @property {string} text what happened */
/** @typedef {object} RobotLink
 * @property {string} name
 * @property {number} parent its number, -1 of link 0, which is the world
 * @property {number} joints between it and its parent
 * @property {number} shapes that touch
 * @property {number} mass kg
 * @property {Vector3} centre of mass, in the link's frame, m */
/** @typedef {object} RobotJoint
 * @property {string} name
 * @property {'hinge' | 'slide' | 'ball' | 'free'} kind
 * @property {number} link the one that it moves
 * @property {number} position number of its first coordinate in `Robot.positions`
 * @property {Vector3} anchor in the link's frame, m
 * @property {Vector3} axis in the link's frame
 * @property {number} low lower limit of its coordinate, m or rad; -Infinity for none
 * @property {number} high upper limit; Infinity for none
 * @property {number} maxForce N or N m; Infinity for none
 * @property {number} maxVelocity m/s or rad/s; Infinity for none */
/** @typedef {object} RobotActuator
 * @property {string} name
 * @property {number} joint that it acts on, -1 of one that acts on a tendon, a site or a link
 * @property {boolean} isFiltered its force follows its activation, which follows the control in time
 * @property {number} low least control; -Infinity for none
 * @property {number} high largest control; Infinity for none */
/** A pose with a name. @typedef {{name: string, positions: Float64Array}} RobotStart */
/** @typedef {object} BuildOptions
 * @property {VectorLike} [position] of the model's world in the world, m
 * @property {QuaternionLike} [quaternion] of the model's world
 * @property {ArrayLike<number>} [positions] coordinates to begin at; those of the file */

/** @type {ReportLine['note'][]} */
const kNotes = ['changed', 'approximated', 'ignored', 'error'];
/** @type {RobotJoint['kind'][]} */
const kKinds = ['hinge', 'slide', 'ball', 'free'];
const first3 = (/** @type {any} */ v) => /** @type {Vector3} */ ([v[0], v[1], v[2]]);

/** A model of a robot. Robots.load makes it. It does not change; robots that were made of it stay when it is destroyed. */
export class RobotModel extends Handle {
    /**
     * For the package alone.
     * @param {Engine} engine
     * @param {number} pointer
     */
    constructor(engine, pointer) {
        super(engine, pointer);
        /** @readonly What was changed, approximated or left out of the file. @type {ReportLine[]} */
        this.report = this.#rows('dRobotModelGetReport', 'dRobotReportLine', row => ({
            note: kNotes[row.note], file: this.#text(row.file).replace(/^\/files\//, ''), line: row.line, text: this.#text(row.text).replaceAll('/files/', '')}));
        /** @readonly The links; the first is the world. @type {RobotLink[]} */
        this.links = this.#rows('dRobotModelGetLinks', 'dRobotLink', row => ({
            name: this.#text(row.name), parent: row.parent, joints: row.joints, shapes: row.shapes, mass: row.mass, centre: first3(row.centre)}));
        /** @readonly @type {RobotJoint[]} */
        this.joints = this.#rows('dRobotModelGetJoints', 'dRobotJoint', row => ({
            name: this.#text(row.name), kind: kKinds[row.kind], link: row.link, position: row.position, anchor: first3(row.anchor),
            axis: first3(row.axis), low: row.low, high: row.high, maxForce: row.max_force, maxVelocity: row.max_velocity}));
        /** @readonly @type {RobotActuator[]} */
        this.actuators = this.#rows('dRobotModelGetActuators', 'dRobotActuator', row => ({
            name: this.#text(row.name), joint: row.joint, isFiltered: row.is_filtered !== 0, low: row.low, high: row.high}));
        const {c} = engine;
        /** @readonly Named poses of the file (MJCF: keyframes). @type {RobotStart[]} */
        this.starts = Array.from({length: c.dRobotModelGetNumStarts(pointer)}, (_, i) => ({
            name: this.#text(c.dRobotModelGetStartName(pointer, i)),
            positions: this.#reals((at, count) => c.dRobotModelGetStart(pointer, i, at, count))}));
        /** @readonly The coordinates in which the file describes the robot. */
        this.reference = this.#reals((at, count) => c.dRobotModelGetReference(pointer, at, count));
        /** @readonly How many coordinates `Robot.positions` has. @type {number} */
        this.positionCount = c.dRobotModelGetNumPositions(pointer);
        /** @readonly How many numbers `Robot.velocities` has. @type {number} */
        this.velocityCount = c.dRobotModelGetNumVelocities(pointer);
        /** @readonly The time of a step that the file asks for, s; 0 where it does not say. @type {number} */
        this.stepsize = c.dRobotModelGetStepsize(pointer);
        c.dRobotModelGetGravity(pointer, engine.base);
        /** @readonly The file's gravity, m/s^2. @type {Vector3} */
        this.gravity = engine.vector(engine.base);
    }

    /** @param {number} pointer @returns {string} */
    #text(pointer) { return this.engine.c.string(pointer); }

    /**
     * @template T
     * @param {string} of
     * @param {string} type
     * @param {(row: any) => T} read
     * @returns {T[]}
     */
    #rows(of, type, read) {
        const {c} = this.engine, get = c[of], count = get(this.handle, 0, 0), size = size_of(type), at = this.engine.buffer(size * count);
        get(this.handle, at, count);
        return Array.from({length: count}, (_, i) => read(c.at(at + i * size, type)));
    }

    /** @param {(at: number, count: number) => number} get @returns {Float64Array} */
    #reals(get) {
        const count = get(0, 0), at = this.engine.buffer(8 * count);
        get(at, count);
        return this.engine.f64.slice(at >> 3, (at >> 3) + count);
    }

    /**
     * The number of the link of a name, also of one that was merged with another; -1 if there is none.
     * @param {string} name
     */
    findLink(name) { return this.#find('dRobotModelFindLink', name, 'RobotModel.findLink'); }

    /** The number of a joint by its name, or -1. @param {string} name */
    findJoint(name) { return this.#find('dRobotModelFindJoint', name, 'RobotModel.findJoint'); }

    /** The number of an actuator by its name, or -1. @param {string} name */
    findActuator(name) { return this.#find('dRobotModelFindActuator', name, 'RobotModel.findActuator'); }

    /** @param {string} of @param {string} name @param {string} label @returns {number} */
    #find(of, name, label) {
        if (typeof name !== 'string') refuse(label, 'name', 'a name', name);
        const {handle} = this, {c} = this.engine, text = c.new_string(name);
        try {
            return ask(this.engine, label, () => c[of](handle, text)).result;
        } finally {
            c.free(text);
        }
    }

    /**
     * Where the links are in the model's world: seven numbers each, position and quaternion (w, x, y, z).
     * @param {ArrayLike<number>} positions `positionCount` coordinates
     * @returns {Float64Array}
     */
    poses(positions) {
        const label = 'RobotModel.poses', e = this.engine, count = this.links.length, at = e.buffer(8 * (this.positionCount + 7 * count));
        const {handle} = this, to = at + 8 * this.positionCount;
        e.f64.set(numbers(positions, this.positionCount, label, 'positions'), at >> 3);
        wanted(e, label, () => e.c.dRobotModelGetPoses(handle, at, this.positionCount, to, count));
        return e.f64.slice(to >> 3, (to >> 3) + 7 * count);
    }

    /**
     * The mass matrix, row by row, with the inertias of rotors: `velocityCount` squared numbers.
     * @param {ArrayLike<number>} positions `positionCount` coordinates
     * @returns {Float64Array}
     */
    massMatrix(positions) {
        const label = 'RobotModel.massMatrix', e = this.engine, size = this.velocityCount ** 2, at = e.buffer(8 * (this.positionCount + size));
        const {handle} = this, to = at + 8 * this.positionCount;
        e.f64.set(numbers(positions, this.positionCount, label, 'positions'), at >> 3);
        ask(e, label, () => e.c.dRobotModelGetMassMatrix(handle, at, to, size));
        return e.f64.slice(to >> 3, (to >> 3) + size);
    }

    /**
     * Makes a robot in a world.
     * @param {World} world
     * @param {BuildOptions} [options]
     * @returns {Robot}
     */
    build(world, options = {}) {
        const label = 'RobotModel.build', e = this.engine, given = options_of(options, ['position', 'quaternion', 'positions'], label), {handle} = this;
        const to = e.pointer_to(world, World, label, 'world'), place = vector(given.position ?? [0, 0, 0], label, 'position');
        const q = quaternion(given.quaternion ?? [1, 0, 0, 0], label, 'quaternion');
        if (!(Math.hypot(...q) > 0)) refuse(label, 'quaternion', 'a quaternion of a length above 0', given.quaternion);
        const begin = given.positions === undefined ? null : numbers(given.positions, this.positionCount, label, 'positions');
        world.refresh();
        e.put_vector(e.base, place), e.put_quaternion(e.base + 32, q);
        const made = wanted(e, label, () => e.c.dRobotCreate(to, world.space, handle, e.base, e.base + 32));
        const robot = new Robot(this, world, made >>> 0);
        try {
            if (begin) robot.positions = begin;
        } catch (error) {
            robot.destroy();
            throw error;
        }
        return robot;
    }

    /** Destroys the model. */
    destroy() {
        this.engine.c.dRobotModelDestroy(this.handle);
        this.set_alive(false);
    }
}
