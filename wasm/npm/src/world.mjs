// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds: what they are made with, what is in them, steps and what those report.
import {name_of, number_of, real, refuse, uint32, vector} from './checks.mjs';
import {Body} from './body.mjs';
import {adopt_contents, clone, contents_of} from './copies.mjs';
import {enums} from './enums.mjs';
import {EpodeError} from './errors.mjs';
import {Geom} from './geom.mjs';
import {Handle} from './handle.mjs';
import {Joint} from './joint.mjs';
import * as joints from './joints.mjs';
import {assign, checked_options, finished} from './options.mjs';
import {create_geom} from './shapes.mjs';
import {WorldStates} from './states.mjs';
import {get_structures, size_of} from './structures.mjs';
/** @import {Engine} from './engine.mjs' */
/** @import {Defaults} from './enums.mjs' */
/** @import {Contact, ContactEvent, Event} from './fields.mjs' */
/** @import {GeomKinds, GeomKindOptions} from './geoms.mjs' */
/** @import {JointKinds, JointKindOptions} from './joints.mjs' */
/** @import {BodyOptions, GeomOptions, WorldOptions as SettableOfWorld} from './methods.mjs' */
/** @import {ShapeSizes} from './shapes.mjs' */
/** @import {Robot} from './robot.mjs' */
/** @import {VectorLike} from './checks.mjs' */

/** @typedef {object} NewWorldOptions
 * @property {Defaults} [preset] what the world is for: 'game' (the default), 'robot' or 'ode'; docs/guide/defaults.md has the values
 * @property {'hash' | 'simple' | 'sweep'} [space] how it finds pairs of geoms; 'hash' */
/** @typedef {SettableOfWorld & NewWorldOptions} WorldOptions */
/** @typedef {BodyOptions & {kinematic?: boolean, enabled?: boolean, mass?: number}} NewBodyOptions */
/** How a world steps: each island in its own way; exactly; by sweeps; in substeps. @typedef {'hybrid' | 'exact' | 'quick' | 'substeps'} StepMethod */

const kNewBody = ['kinematic', 'enabled', 'mass', 'massProperties'];
const kSpaces = /** @type {{[name: string]: (e: Engine) => number}} */ ({
    hash: e => e.c.dHashSpaceCreate(0), simple: e => e.c.dSimpleSpaceCreate(0), sweep: e => e.c.dSweepAndPruneSpaceCreate(0, 0),
});
const kSteps = /** @type {{[name: string]: (e: Engine, world: number, h: number, substeps: number) => number}} */ ({
    hybrid: (e, world, h) => e.c.dWorldStepHybrid(world, h), exact: (e, world, h) => e.c.dWorldStep(world, h),
    quick: (e, world, h) => e.c.dWorldQuickStep(world, h), substeps: (e, world, h, count) => e.c.dWorldStepFast1(world, h, count),
});

/** A world of bodies, joints and geoms. Engine.createWorld makes it. It finds and solves its contacts by itself. */
export class World extends WorldStates {
    #contents = /** @type {Set<Body | Joint | Geom>} */ (new Set());
    #ended = /** @type {Map<number, Body | Joint | Geom>} */ (new Map());
    #filter = 0;

    /**
     * For the package alone.
     * @param {Engine} engine
     * @param {number} pointer
     */
    constructor(engine, pointer) {
        super(engine, pointer);
        /** For the package alone: they end with the world. @type {Set<Robot>} */
        this.robots = new Set();
        if (pointer) this.set_alive(true);
    }

    /**
     * For the package alone: Engine.createWorld.
     * @param {Engine} e
     * @param {WorldOptions} options
     * @returns {World}
     */
    static create(e, options) {
        const own = ['preset', 'space'], label = 'Engine.createWorld', given = checked_options(options, ['World'], own, label);
        const preset = number_of(enums.Defaults, given.preset ?? 'game', label, 'preset'), kind = given.space ?? 'hash';
        if (typeof kind !== 'string' || !Object.hasOwn(kSpaces, kind)) refuse(label, 'space', `one of ${Object.keys(kSpaces).join(', ')}`, kind);
        const made = new World(e, e.c.dWorldCreate());
        return finished(made, () => {
            e.c.dWorldUseDefaults(made.handle, preset);
            e.c.dWorldSetContactSpace(made.handle, kSpaces[kind](e));
            e.check(label);
            assign(made, {gravity: [0, 0, -9.81], ...given}, own);
        });
    }

    /** The bodies, the oldest first. @returns {Body[]} */
    get bodies() { return /** @type {Body[]} */ (this.#of(Body)); }

    /** The joints, the oldest first. @returns {Joint[]} */
    get joints() { return /** @type {Joint[]} */ (this.#of(Joint)); }

    /** The geoms, the oldest first. @returns {Geom[]} */
    get geoms() { return /** @type {Geom[]} */ (this.#of(Geom)); }

    #of(/** @type {Function} */ kind) {
        void this.handle;
        return [...this.#contents].filter(one => one instanceof kind);
    }

    /**
     * Creates a body.
     * @param {NewBodyOptions} [options] its place, velocities and settings, in the order in which they are set
     * @returns {Body}
     */
    createBody(options = {}) {
        const given = checked_options(options, ['Body'], kNewBody, 'World.createBody'), e = this.engine;
        const pointer = e.c.dBodyCreate(this.handle);
        e.check('World.createBody');
        const made = this.begun(new Body(this, pointer));
        return finished(made, () => assign(made, given, []));
    }

    /**
     * Creates a geom that stands in the world.
     * @template {keyof ShapeSizes} K
     * @param {K} kind
     * @param {ShapeSizes[K] & GeomOptions & Omit<GeomKindOptions[K], keyof ShapeSizes[K]>} options sizes, `position`, `quaternion`, `material`, bits
     * @returns {GeomKinds[K]}
     */
    createGeom(kind, options) { return create_geom(this, null, kind, options); }

    /**
     * Creates a joint of two bodies where they are now; null is the world.
     * @template {keyof JointKinds} K
     * @param {K} kind
     * @param {Body | null} body1
     * @param {Body | null} body2
     * @param {JointKindOptions[K]} [options] anchors and axes, in the world's frame, in the order in which they are set
     * @returns {JointKinds[K]}
     */
    createJoint(kind, body1, body2, options = {}) {
        const e = this.engine, label = 'World.createJoint', [name, of] = joint_class(kind, label);
        const given = checked_options(options, ['Joint', name], ['enabled', 'measures'], label);
        const ends = [body1, body2].map((body, i) => body === null ? 0 : e.pointer_to(body, Body, label, `body${i + 1}`));
        if ([body1, body2].some(body => body && body.world !== this)) throw new EpodeError('other', `${label}: a body of another world`);
        // A joint that goes wakes its bodies, also one that is refused.
        const asleep = [body1, body2].some(body => body && !body.enabled) ? this.saveState() : null;
        const pointer = e.c[`dJointCreate${name}`](this.handle, 0);
        e.check(label);
        const made = this.begun(/** @type {any} */ (new of(this, pointer)));
        return finished(made, () => {
            e.c.dJointAttach(pointer, ...ends);
            if (kind === 'fixed') e.c.dJointSetFixed(pointer);
            e.check(label);
            assign(made, given, []);
        }, () => {
            if (asleep) this.loadState(asleep);
        });
    }

    /**
     * Advances the world.
     * @param {number} h the step, s
     * @param {StepMethod} [method]
     * @param {number} [substeps] of 'substeps'
     */
    step(h, method = 'hybrid', substeps = 4) {
        const e = this.engine, size = real(h, 'World.step', 'h'), count = uint32(substeps, 'World.step', 'substeps') | 0;
        if (typeof method !== 'string' || !Object.hasOwn(kSteps, method)) refuse('World.step', 'method', `one of ${Object.keys(kSteps).join(', ')}`, method);
        const done = kSteps[method](e, this.handle, size, count);
        e.check('World.step');
        if (!done) throw new EpodeError('failed', 'World.step: there is no memory for the step');
    }

    /** The points of contact of the last step. @returns {Contact[]} */
    get contacts() { return this.#report('dWorldGetContacts', 'dWorldContact'); }

    /** Which pairs of geoms began, went on and ended to touch in the last step. @returns {ContactEvent[]} */
    get contactEvents() { return this.#report('dWorldGetContactEvents', 'dContactEvent'); }

    /** What happened in the last step: contacts with their impact, sensors, joints that broke. None without `eventSettings`. @returns {Event[]} */
    get events() { return this.#report('dWorldGetEvents', 'dEvent'); }

    /** @param {string} name @param {string} type @returns {any[]} */
    #report(name, type) {
        const e = this.engine, count = e.c[name](this.handle, 0, 0), at = e.buffer(count * size_of(type));
        e.c[name](this.handle, at, count);
        e.check('World');
        return get_structures(e, type, at, count);
    }

    /**
     * A function that decides whether two geoms may touch, or null. It must not change the world; what it throws is thrown by the step.
     * @param {((geom1: Geom, geom2: Geom) => boolean) | null} filter
     */
    setContactFilter(filter) {
        if (filter !== null && typeof filter !== 'function') refuse('World.setContactFilter', 'filter', 'a function or null', filter);
        const e = this.engine, had = this.#filter, {handle} = this;
        const made = filter ? e.callback('iii:i', (_, a, b) => filter(e.object_at(a >>> 0), e.object_at(b >>> 0)) ? 1 : 0) : 0;
        e.c.dWorldSetContactFilter(handle, made, 0);
        try {
            e.check('World.setContactFilter');
        } catch (error) {
            if (made) e.c.free_callback(made);
            throw error;
        }
        this.#filter = made;
        if (had) e.c.free_callback(had);
    }

    /**
     * Takes steps back (`history`) and all that the program has done since: what was destroyed since is back, what was created since is
     * destroyed.
     * @param {number} frames how many, at most `historyFrames`
     */
    rollBack(frames) {
        const e = this.engine;
        e.c.dWorldRollBack(this.handle, uint32(frames, 'World.rollBack', 'frames') | 0);
        e.check('World.rollBack');
        this.refresh();
    }

    /** Finds what functions of `engine.c` have created and destroyed in the world since: `bodies`, `joints` and `geoms` have it then. */
    refresh() {
        const {bodies, joints: all, geoms} = contents_of(this), lives = new Set([...bodies, ...all, ...geoms]), e = this.engine;
        for (const one of [...this.#contents]) if (!lives.has(one.handle)) this.ended(one);
        for (const pointer of lives) if (!e.objects.has(pointer)) this.#back(pointer);
        adopt_contents(this);
    }

    /** @param {number} pointer */
    #back(pointer) {
        const one = this.#ended.get(pointer);
        if (one) this.begun(one);
    }

    /** The world with all that is in it as bytes, for Engine.loadWorld here or dWorldLoadFromBuffer in C. @returns {Uint8Array} */
    save() {
        const e = this.engine, {handle, space} = this, size = e.c.dWorldSaveToBuffer(handle, space, 0, 0) >>> 0, at = e.buffer(size);
        e.check('World.save');
        e.c.dWorldSaveToBuffer(handle, space, at, size);
        e.check('World.save');
        return e.c.bytes(at, size).slice();
    }

    /** A world like this one, in the same state: its steps give the same bits. @returns {World} */
    clone() { return clone(this); }

    /**
     * Makes a point the new origin. Nothing moves against anything else.
     * @param {VectorLike} offset m
     */
    shiftOrigin(offset) {
        const e = this.engine, at = e.put_vector(e.base, vector(offset, 'World.shiftOrigin', 'offset'));
        e.c.dWorldShiftOrigin(this.handle, this.space, at);
        e.check('World.shiftOrigin');
    }

    /** Destroys the world and all that is in it. */
    destroy() {
        const e = this.engine, {handle, space} = this;
        for (const robot of this.robots) robot.destroy();
        e.c.dWorldDestroy(handle);
        e.check('World.destroy');
        this.set_alive(false);
        for (const one of [...this.#contents]) this.ended(one);
        if (space) e.c.dSpaceDestroy(space);
        this.#forget();
        if (this.#filter) e.c.free_callback(this.#filter);
    }

    /**
     * For the package alone: an object is in the world.
     * @template {Body | Joint | Geom} T
     * @param {T} one
     * @returns {T}
     */
    begun(one) {
        one.set_alive(true);
        this.#contents.add(one);
        this.#ended.delete(one.handle);
        return one;
    }

    /**
     * For the package alone: an object has ended. While the world has a history it may come back.
     * @param {Body | Joint | Geom} one
     */
    ended(one) {
        this.#ended.set(one.handle, one);
        this.#contents.delete(one);
        one.set_alive(false);
        if (one instanceof Joint) one.free_feedback();
        if (!this.isDestroyed && this.history === 0) this.#forget();
    }

    /** What has ended does not come back. */
    #forget() {
        for (const one of this.#ended.values()) free_shared(one);
        this.#ended.clear();
    }
}

/** The class of a kind, and its name: minifiers rename classes, but not what modules export. @param {unknown} kind @param {string} label */
function joint_class(kind, label) {
    const found = typeof kind === 'string' ? Object.entries(joints).find(([, one]) => one.kind === kind) : undefined;
    return found ?? refuse(label, 'kind', `one of ${Object.values(joints).map(one => one.kind).join(', ')}`, kind);
}

/** @param {Body | Joint | Geom} one */
function free_shared(one) {
    if (one instanceof Geom && one.shared && --one.shared.users === 0) one.shared.free();
}
