// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all joints have in common. Their classes are in joints.mjs.
import {flag} from './checks.mjs';
import {JointMethods} from './methods.mjs';
import {get_structure, size_of} from './structures.mjs';
/** @import {Body} from './body.mjs' */
/** @import {World} from './world.mjs' */
/** @import {Feedback} from './fields.mjs' */

/** A joint of two bodies, or of a body and the world. World.createJoint makes them. */
export class Joint extends JointMethods {
    #feedback = 0;

    /**
     * For the package alone.
     * @param {World} world
     * @param {number} pointer
     */
    constructor(world, pointer) {
        super(world.engine, pointer);
        /** @readonly The world that the joint is in. */
        this.world = world;
    }

    /** The two bodies; null is the world. @returns {[Body | null, Body | null]} */
    get bodies() {
        const e = this.engine;
        return [e.object_at(e.c.dJointGetBody(this.handle, 0)), e.object_at(e.c.dJointGetBody(this.handle, 1))];
    }

    /** Whether the joint acts. @returns {boolean} */
    get enabled() { return this.engine.c.dJointIsEnabled(this.handle) !== 0; }

    /** @param {boolean} value */
    set enabled(value) {
        const on = flag(value, 'Joint.enabled', 'value');
        on ? this.engine.c.dJointEnable(this.handle) : this.engine.c.dJointDisable(this.handle);
        this.engine.check('Joint.enabled');
    }

    /** Whether the joint measures its forces. False at first. @returns {boolean} */
    get measures() { return this.handle !== 0 && this.#feedback !== 0; }

    /** @param {boolean} value */
    set measures(value) {
        const on = flag(value, 'Joint.measures', 'value'), e = this.engine, had = this.#feedback, handle = this.handle;
        if ((had !== 0) === (on !== 0)) return;
        this.#feedback = on ? e.c.create('dJointFeedback').pointer : 0;
        e.c.dJointSetFeedback(handle, this.#feedback);
        if (had) e.c.free(had);
        e.check('Joint.measures');
    }

    /** The forces and torques of the last step on both bodies, null if the joint does not measure. @returns {Feedback | null} */
    get feedback() { return this.measures ? get_structure(this.engine, 'dJointFeedback', this.#feedback) : null; }

    /** Destroys the joint. */
    destroy() {
        const e = this.engine;
        e.c.dJointDestroy(this.handle);
        e.check('Joint.destroy');
        this.free_feedback();
        this.world.ended(this);
    }

    /** For the package alone: C no longer has the joint. */
    free_feedback() {
        if (this.#feedback) this.engine.c.free(this.#feedback);
        this.#feedback = 0;
    }
}
