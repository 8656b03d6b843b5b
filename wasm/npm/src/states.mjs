// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States: of a world as bytes, of many bodies as one array, and steps that are taken back.
import {numbers, number_of, refuse, uint32} from './checks.mjs';
import {Body} from './body.mjs';
import {enums} from './enums.mjs';
import {EpodeError} from './errors.mjs';
import {WorldQueries} from './queries.mjs';
/** @import {World} from './world.mjs' */
/** @import {Engine} from './engine.mjs' */
/** @import {StateField} from './enums.mjs' */

const kNumbers = /** @type {{[name: string]: number}} */ (
    {position: 3, quaternion: 4, linearVelocity: 3, angularVelocity: 3, force: 3, torque: 3, enabled: 1});

/**
 * The states of some bodies as rows of one array in the engine's memory: nothing is copied but by the library itself.
 * World.createStates makes it; destroy() frees its memory.
 */
export class BodyStates {
    #pointer;
    #handles;

    /**
     * For the package alone.
     * @param {Engine} engine
     * @param {Body[]} bodies
     * @param {StateField[]} fields
     */
    constructor(engine, bodies, fields) {
        /** @readonly */
        this.engine = engine;
        /** @readonly The bodies, in the order of the rows. */
        this.bodies = Object.freeze([...bodies]);
        /** @readonly Sum of C's dStateField. */
        this.fields = fields.reduce((all, name) => all | enums.StateField[name], 0);
        /** @readonly How many numbers a row has: position 3, quaternion 4 (w, x, y, z), velocities, force and torque 3, enabled 1. */
        this.stride = fields.reduce((all, name) => all + kNumbers[name], 0);
        this.#handles = engine.c.new_ints(bodies.map(body => body.handle));
        this.#pointer = engine.c.malloc(8 * this.stride * bodies.length || 8);
    }

    /**
     * The rows as a view of the engine's memory. It ends (its length is 0) when that grows, so take it after steps and changes, not before.
     * @returns {Float64Array}
     */
    get values() {
        const from = this.#live() >> 3;
        return this.engine.f64.subarray(from, from + this.stride * this.bodies.length);
    }

    /**
     * Fills the rows from the bodies and returns them.
     * @returns {Float64Array}
     */
    read() { return this.#call('dBodiesGetStates', 'BodyStates.read'); }

    /** Sets the bodies from the rows. Of rows with a number that is not finite nothing is set. */
    write() { this.#call('dBodiesSetStates', 'BodyStates.write'); }

    /** Frees the memory. */
    destroy() {
        this.engine.c.free(this.#live());
        this.engine.c.free(this.#handles);
        this.#pointer = 0;
    }

    #live() {
        if (!this.#pointer) throw new EpodeError('destroyed', 'these BodyStates are destroyed');
        return this.#pointer;
    }

    /** @param {string} name @param {string} label */
    #call(name, label) {
        const at = this.#live();
        for (const body of this.bodies) void body.handle;
        this.engine.c[name](this.#handles, this.bodies.length, this.fields, at, 0);
        this.engine.check(label);
        return this.values;
    }
}

/** The whole state of a world, kept in the engine's memory. World.snapshot takes it; destroy() frees its memory. */
export class Snapshot {
    #pointer;
    #size;

    /**
     * For the package alone.
     * @param {WorldStates} world
     */
    constructor(world) {
        const {engine, handle} = world, {c} = engine;
        /** @readonly */
        this.world = world;
        this.#size = c.dWorldGetStateSize(handle);
        this.#pointer = c.malloc(this.#size);
        c.dWorldGetState(handle, this.#pointer, this.#size);
        engine.check('World.snapshot');
    }

    /** The state's bytes, a view of the engine's memory that ends when that grows. @returns {Uint8Array} */
    get bytes() { return this.world.engine.c.bytes(this.#live(), this.#size); }

    /** Gives the world this state back. */
    restore() {
        const {engine, handle} = this.world;
        engine.c.dWorldSetState(handle, this.#live(), this.#size);
        engine.check('Snapshot.restore');
    }

    /** Frees the memory. */
    destroy() {
        this.world.engine.c.free(this.#live());
        this.#pointer = 0;
    }

    #live() {
        if (!this.#pointer) throw new EpodeError('destroyed', 'this Snapshot is destroyed');
        return this.#pointer;
    }
}

/** @param {unknown} value @param {string} label @param {string} name @returns {Uint8Array} */
export function bytes_of(value, label, name) {
    if (!(value instanceof Uint8Array)) return refuse(label, name, 'a Uint8Array', value);
    return value;
}

/**
 * Calls with bytes in C's memory.
 * @template T
 * @param {Engine} e
 * @param {Uint8Array[]} all
 * @param {(...pointers: number[]) => T} call
 * @returns {T}
 */
export function with_bytes(e, all, call) {
    const copies = all.map(bytes => bytes.slice()), pointers = copies.map(bytes => e.c.malloc(bytes.length || 1));
    try {
        copies.forEach((bytes, i) => e.c.bytes(pointers[i], bytes.length).set(bytes));
        return call(...pointers);
    } finally {
        for (const pointer of pointers) e.c.free(pointer);
    }
}

/** The states of a world. */
export class WorldStates extends WorldQueries {
    /**
     * The state: all that a step changes. It is the same bytes on every machine, so it goes between browsers, Node and native programs.
     * @returns {Uint8Array}
     */
    saveState() {
        const e = this.engine, size = e.c.dWorldGetStateSize(this.handle), at = e.buffer(size);
        e.c.dWorldGetState(this.handle, at, size);
        e.check('World.saveState');
        return e.c.bytes(at, size).slice();
    }

    /**
     * Gives the world a state: its own, or that of a world of the same structure. Others are refused.
     * @param {Uint8Array} state
     */
    loadState(state) {
        const e = this.engine, label = 'World.loadState', bytes = bytes_of(state, label, 'state');
        with_bytes(e, [bytes], at => e.c.dWorldSetState(this.handle, at, bytes.length));
        e.check(label);
    }

    /**
     * What has changed since another state: what sleeps costs next to nothing. For networks.
     * @param {Uint8Array} base a state of the same structure
     * @returns {Uint8Array}
     */
    saveStateDelta(base) {
        const e = this.engine, label = 'World.saveStateDelta', bytes = bytes_of(base, label, 'base'), {handle} = this;
        return with_bytes(e, [bytes], from => {
            const size = e.c.dWorldGetStateDelta(handle, from, bytes.length, 0, 0) >>> 0, to = e.buffer(size);
            e.check(label);
            e.c.dWorldGetStateDelta(handle, from, bytes.length, to, size);
            e.check(label);
            return e.c.bytes(to, size).slice();
        });
    }

    /**
     * Gives the world the state that a base and a difference from it make up.
     * @param {Uint8Array} base
     * @param {Uint8Array} delta
     */
    loadStateDelta(base, delta) {
        const e = this.engine, label = 'World.loadStateDelta', both = [bytes_of(base, label, 'base'), bytes_of(delta, label, 'delta')];
        with_bytes(e, both, (from, to) => e.c.dWorldSetStateDelta(this.handle, from, both[0].length, to, both[1].length));
        e.check(label);
    }

    /** Keeps the state in the engine's memory, to be restored without a copy through JavaScript. @returns {Snapshot} */
    snapshot() { return new Snapshot(this); }

    /**
     * An array in the engine's memory with the states of some bodies: one call for all of them, and a view without a copy.
     * @param {Body[]} bodies
     * @param {StateField[]} [fields]
     * @returns {BodyStates}
     */
    createStates(bodies, fields = ['position', 'quaternion']) {
        const label = 'World.createStates', e = this.engine;
        if (!Array.isArray(bodies) || !Array.isArray(fields)) throw new TypeError(`${label}: bodies and fields must be arrays`);
        bodies.forEach((body, i) => e.pointer_to(body, Body, label, `bodies[${i}]`));
        const numbers_of = fields.map((name, i) => number_of(enums.StateField, name, label, `fields[${i}]`));
        if (numbers_of.some((n, i) => i > 0 && n <= numbers_of[i - 1])) throw new TypeError(`${label}: fields must be in the order ${Object.keys(enums.StateField).join(', ')}`);
        return new BodyStates(e, bodies, fields);
    }

    /** How many steps the world keeps, to take them back. 0 at first. @returns {number} */
    get history() { return this.engine.c.dWorldGetHistory(this.handle); }

    /** @param {number} value */
    set history(value) {
        const frames = uint32(value, 'World.history', 'value') | 0;
        this.engine.c.dWorldSetHistory(this.handle, frames);
        this.engine.check('World.history');
    }
}
