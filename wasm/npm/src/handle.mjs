// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What worlds, bodies, joints and geoms have in common: a handle of C, which ends with the object.
import {EpodeError} from './errors.mjs';
/** @import {Engine} from './engine.mjs' */

/** An object of the library. It throws once it is destroyed. */
export class Handle {
    #pointer;
    #alive = true;

    /**
     * For the package alone: worlds and what is in them have create... functions.
     * @param {Engine} engine
     * @param {number} pointer
     */
    constructor(engine, pointer) {
        /** @readonly The engine that the object belongs to. */
        this.engine = engine;
        this.#pointer = pointer;
        /** What the program likes to keep with the object. @type {any} */
        this.userData = undefined;
    }

    /**
     * The object's handle, for the C functions in `engine.c`. Throws if the object is destroyed.
     * @returns {number}
     */
    get handle() {
        if (!this.#alive) throw new EpodeError('destroyed', `this ${this.constructor.name} is destroyed`);
        return this.#pointer;
    }

    /** Whether the object no longer exists. */
    get isDestroyed() { return !this.#alive; }

    /**
     * For the package alone: the object has ended, or (World.rollBack) is back again.
     * @param {boolean} alive
     */
    set_alive(alive) {
        this.#alive = alive;
        if (alive) this.engine.objects.set(this.#pointer, this);
        else this.engine.objects.delete(this.#pointer);
    }
}
