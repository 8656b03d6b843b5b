// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all geoms have in common. Their classes, by shape, are in geoms.mjs.
import {flag, int32} from './checks.mjs';
import {GeomMethods} from './methods.mjs';
/** @import {Body} from './body.mjs' */
/** @import {World} from './world.mjs' */
/** @import {Engine} from './engine.mjs' */

/** Data of a mesh or height field in C, shared by clones and freed with the last. @typedef {{users: number, data: number, free: () => void}} Shared */

/** A solid or surface that collides: of a body, or standing in the world. World.createGeom and Body.createGeom make them. */
export class Geom extends GeomMethods {
    /**
     * For the package alone.
     * @param {World} world
     * @param {number} pointer
     * @param {Shared} [shared]
     */
    constructor(world, pointer, shared) {
        super(world.engine, pointer);
        /** @readonly The world that the geom is in. */
        this.world = world;
        /** For the package alone. */
        this.shared = shared;
        if (shared) ++shared.users;
    }

    /** The body that the geom belongs to, or null. @returns {Body | null} */
    get body() { return this.engine.object_at(this.engine.c.dGeomGetBody(this.handle)); }

    /** Whether the geom collides. @returns {boolean} */
    get enabled() { return this.engine.c.dGeomIsEnabled(this.handle) !== 0; }

    /** @param {boolean} value */
    set enabled(value) {
        const on = flag(value, 'Geom.enabled', 'value');
        on ? this.engine.c.dGeomEnable(this.handle) : this.engine.c.dGeomDisable(this.handle);
        this.engine.check('Geom.enabled');
    }

    /**
     * The surface of a convex solid as triangles, nine numbers each, counter-clockwise from outside, in the geom's frame: for drawing.
     * @param {number} [segments] round solids have so many around, 4 to 512
     * @returns {Float64Array}
     */
    triangles(segments = 24) {
        const e = this.engine, cut = int32(segments, 'Geom.triangles', 'segments');
        const count = e.c.dGeomGetTriangles(this.handle, cut, 0, 0);
        e.check('Geom.triangles');
        const at = e.buffer(72 * count);
        e.c.dGeomGetTriangles(this.handle, cut, at, count);
        return e.f64.slice(at >> 3, (at >> 3) + 9 * count);
    }

    /** Destroys the geom. The mass of its body stays. */
    destroy() {
        const e = this.engine;
        e.c.dGeomDestroy(this.handle);
        e.check('Geom.destroy');
        this.world.ended(this);
    }
}
