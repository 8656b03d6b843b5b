// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One instance of the library: its memory, its objects by their handles, and what it says, which becomes errors.
//
// Arguments that C reads and writes by pointers lie in frames of kFrame bytes; a callback gets a frame of its own, because calls that it
// makes must not move what the call around it has there.
import {load as load_c} from './c/epode.mjs';
import {EpodeError} from './errors.mjs';
import {Robots} from './robots.mjs';
import {World} from './world.mjs';
import {adopt} from './copies.mjs';
/** @import {Handle} from './handle.mjs' */
/** @import {Vector3, Quaternion, Vector4, Matrix3, Box6} from './checks.mjs' */
/** @import {WorldOptions} from './world.mjs' */

const kFrame = 8192, kFrames = 16;

/** @typedef {object} LoadOptions
 * @property {boolean} [robots] whether the engine reads robots from files (`Engine.robots`): its module is larger; false
 * @property {URL | BufferSource | WebAssembly.Module} [source] where the module is, or its bytes; default: epode.wasm of the package,
 *     epode_robots.wasm with robots
 * @property {(text: string) => void} [onMessage] gets what the library reports without refusing a call; default: console.warn */

/**
 * Loads the library. Each engine has a memory of its own; objects of two engines do not meet.
 * @param {LoadOptions} [options]
 * @returns {Promise<Engine>}
 */
export async function load({source, robots = false, onMessage = console.warn} = {}) {
    const own = () => robots ? new URL('./epode_robots.wasm', import.meta.url) : new URL('./epode.wasm', import.meta.url);
    return new Engine(await load_c(/** @type {any} */ (source ?? own()), {print: onMessage}), onMessage);
}

/** The library in one instance of WebAssembly. */
export class Engine {
    #thrown = /** @type {unknown[]} */ ([]);
    #said = /** @type {string | null} */ (null);
    #heard = /** @type {string[] | null} */ (null);
    #robots = /** @type {Robots | null} */ (null);
    #f64 = new Float64Array(0);
    #i32 = new Int32Array(0);
    #buffers = /** @type {{pointer: number, size: number}[]} */ ([]);
    #last;

    /**
     * For the package alone: load() makes engines.
     * @param {any} c
     * @param {(text: string) => void} on_message
     */
    constructor(c, on_message) {
        /** The C functions and constants by their names, and the memory: docs/guide/howto/browser.md describes them. @readonly @type {any} */
        this.c = c;
        /** For the package alone: objects by their handles. @type {Map<number, Handle>} */
        this.objects = new Map();
        /** For the package alone: where the frame of the innermost callback begins. */
        this.base = c.malloc(kFrame * kFrames);
        this.#last = this.base + kFrame * (kFrames - 1);
        c.on_message((/** @type {string} */ channel, /** @type {number} */ _, /** @type {string} */ text) => {
            if (channel === 'message') this.#heard ? this.#heard.push(text) : on_message(text);
            else this.#said ??= text;
        });
    }

    /**
     * Creates a world. Without options it is one for games (`preset`), with gravity along -z, that finds and solves its contacts.
     * @param {WorldOptions} [options]
     * @returns {World}
     */
    createWorld(options = {}) { return World.create(this, options); }

    /**
     * Creates the world that World.save() has written, natively or here.
     * @param {Uint8Array} bytes
     * @returns {World}
     */
    loadWorld(bytes) { return adopt(this, bytes); }

    /**
     * Reads robots from URDF and MJCF. Throws where the engine was loaded without them.
     * @returns {Robots}
     */
    get robots() {
        if (!this.c.dRobotModelLoad) throw new EpodeError('failed', 'this engine reads no robots: load({robots: true}) loads one that does');
        return this.#robots ??= new Robots(this);
    }

    /** The bytes of WebAssembly's memory that the engine has. It grows and never shrinks. */
    get memorySize() { return this.c.memory.buffer.byteLength; }

    /** For the package alone: the memory as doubles. */
    get f64() {
        if (this.#f64.length === 0) this.#f64 = new Float64Array(this.c.memory.buffer);
        return this.#f64;
    }

    /** For the package alone: the memory as integers. */
    get i32() {
        if (this.#i32.length === 0) this.#i32 = new Int32Array(this.c.memory.buffer);
        return this.#i32;
    }

    /**
     * For the package alone: throws what the last call has refused, or what a callback in it has thrown.
     * @param {string} label
     */
    check(label) {
        if (this.#said !== null || this.#thrown.length > 0) this.#fail(label);
    }

    /**
     * For the package alone: a call, and what the library reports in it.
     * @template T
     * @param {() => T} call
     * @returns {{result: T, said: string[]}}
     */
    heard(call) {
        const before = this.#heard, said = /** @type {string[]} */ ([]);
        this.#heard = said;
        try {
            return {result: call(), said};
        } finally {
            this.#heard = before;
        }
    }

    #fail(/** @type {string} */ label) {
        const text = this.#said, [thrown] = this.#thrown.splice(0), has_thrown = thrown !== undefined;
        this.#said = null;
        if (has_thrown) throw thrown;
        throw new EpodeError('refused', `${label}: ${text}`);
    }

    /**
     * For the package alone: a function for C. What it throws is thrown by the call that has called it, and C gets 0.
     * @param {string} type
     * @param {(...values: any[]) => number | void} call
     * @returns {number}
     */
    callback(type, call) {
        return this.c.callback(type, (/** @type {any[]} */ ...values) => {
            const frame = this.base;
            try {
                if (frame >= this.#last) throw new EpodeError('failed', 'callbacks call each other without end');
                this.base = frame + kFrame;
                return call(...values);
            } catch (error) {
                this.#thrown.push(error ?? new Error('a callback has thrown nothing'));
                return 0;
            } finally {
                this.base = frame;
            }
        });
    }

    /**
     * For the package alone: memory for arrays, until the next call at the same depth of callbacks.
     * @param {number} size
     * @returns {number}
     */
    buffer(size) {
        const had = this.#buffers[this.base] ?? {pointer: 0, size: 0};
        if (had.size < size) {
            const grown = Math.max(size, 2 * had.size), pointer = this.c.malloc(grown);
            if (had.pointer) this.c.free(had.pointer);
            this.#buffers[this.base] = {pointer, size: grown};
            return pointer;
        }
        return had.pointer;
    }

    /** @param {number} at @returns {Vector3} */
    vector(at) {
        const f = this.f64, i = at >> 3;
        return [f[i], f[i + 1], f[i + 2]];
    }

    /** @param {number} at @returns {Vector4} */
    four(at) {
        const f = this.f64, i = at >> 3;
        return [f[i], f[i + 1], f[i + 2], f[i + 3]];
    }

    /** @param {number} at @returns {Box6} */
    six(at) { return /** @type {Box6} */ (Array.from(this.f64.subarray(at >> 3, (at >> 3) + 6))); }

    /** @param {number} at @returns {Matrix3} */
    matrix(at) {
        const f = this.f64, i = at >> 3;
        return [f[i], f[i + 1], f[i + 2], f[i + 4], f[i + 5], f[i + 6], f[i + 8], f[i + 9], f[i + 10]];
    }

    /** @param {number} at @param {Vector3 | null} v @returns {number} */
    put_vector(at, v) {
        if (v === null) return 0;
        this.f64.set(v, at >> 3);
        return at;
    }

    /** @param {number} at @param {Quaternion} q @returns {number} */
    put_quaternion(at, q) {
        this.f64.set(q, at >> 3);
        return at;
    }

    /** @param {number} at @param {Matrix3} m @returns {number} */
    put_matrix(at, m) {
        for (let row = 0; row < 3; ++row) this.f64.set(m.slice(3 * row, 3 * row + 3), (at >> 3) + 4 * row);
        return at;
    }

    /**
     * For the package alone: the object of a handle, null for 0.
     * @param {number} pointer
     * @returns {any}
     */
    object_at(pointer) { return this.objects.get(pointer) ?? null; }

    /**
     * For the package alone: the handle of an object of this engine.
     * @param {any} object
     * @param {Function} of its class
     * @param {string} label
     * @param {string} name
     * @returns {number}
     */
    pointer_to(object, of, label, name) {
        if (!(object instanceof of)) throw new TypeError(`${label}: ${name} must be a ${of.name}`);
        const handle = /** @type {Handle} */ (object);
        if (handle.engine !== this) throw new EpodeError('other', `${label}: ${name} is of another engine`);
        return handle.handle;
    }
}
