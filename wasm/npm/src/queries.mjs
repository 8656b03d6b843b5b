// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What lies where in a world: rays, overlaps, casts and distances. Nothing moves, and no contact is made.
import {numbers, options_of, real, vector} from './checks.mjs';
import {Geom} from './geom.mjs';
import {Body} from './body.mjs';
import {WorldMethods} from './methods.mjs';
import {enums} from './enums.mjs';
import {flag, number_of} from './checks.mjs';
import {fields} from './fields.mjs';
import {get_structure, get_structures, put_structure, size_of} from './structures.mjs';
/** @import {VectorLike} from './checks.mjs' */
/** @import {QueryFilter, QueryHit, CastHit, QueryDistance} from './fields.mjs' */
/** @import {Falloff} from './enums.mjs' */

/** What a query finds; without a filter everything.
 * @typedef {Partial<QueryFilter> & {skipBody?: Body, accept?: (geom: Geom) => boolean}} Filter skipBody: the geoms of this body are left out;
 * accept: has the last word, and must not change the world */

const kFilterAt = 1024, kHitAt = 2048;

/** The spatial queries of a world. */
export class WorldQueries extends WorldMethods {
    /**
     * For the package alone: the space of the world's geoms.
     * @returns {number}
     */
    get space() { return this.engine.c.dWorldGetContactSpace(this.handle); }

    /**
     * The first geom that a ray hits, or null. From inside a geom it is hit at its far wall.
     * @param {VectorLike} origin m
     * @param {VectorLike} direction of any length but 0
     * @param {number} [length] m
     * @param {Filter} [filter]
     * @returns {QueryHit | null}
     */
    rayClosest(origin, direction, length = Infinity, filter = {}) {
        const e = this.engine, label = 'World.rayClosest', hit = e.base + kHitAt;
        const ray = this.#ray(origin, direction, length, label);
        return this.#filtered(filter, label, at => e.c.dSpaceRayClosest(this.space, ...ray, at, hit) ? get_structure(e, 'dQueryHit', hit) : null);
    }

    /**
     * All geoms that a ray hits, each once, the nearest first.
     * @param {VectorLike} origin m
     * @param {VectorLike} direction of any length but 0
     * @param {number} [length] m
     * @param {Filter} [filter]
     * @returns {QueryHit[]}
     */
    rayAll(origin, direction, length = Infinity, filter = {}) {
        const e = this.engine, label = 'World.rayAll', ray = this.#ray(origin, direction, length, label);
        return this.#filtered(filter, label, at => this.#list('dQueryHit', (to, capacity) => e.c.dSpaceRayAll(this.space, ...ray, at, to, capacity)));
    }

    /**
     * Many rays in one call: the distance at which each hits something, Infinity where nothing is hit. For sensors.
     * @param {ArrayLike<number>} origins three numbers a ray, m
     * @param {ArrayLike<number>} directions three numbers a ray
     * @param {number} [length] m, of all rays
     * @param {Filter} [filter]
     * @returns {Float64Array}
     */
    rayDistances(origins, directions, length = Infinity, filter = {}) {
        const e = this.engine, label = 'World.rayDistances', from = numbers(origins, -1, label, 'origins'), count = from.length / 3;
        const to = numbers(directions, from.length, label, 'directions'), reach = real(length, label, 'length');
        if (!Number.isInteger(count)) throw new TypeError(`${label}: origins must come in threes`);
        const size = size_of('dQueryHit'), at = e.c.malloc(count * (56 + size) || 1), hits = at + 56 * count;
        try {
            e.f64.set(from, at >> 3);
            e.f64.set(to, (at >> 3) + 3 * count);
            e.f64.fill(reach, (at >> 3) + 6 * count, (at >> 3) + 7 * count);
            return this.#filtered(filter, label, filter_at => {
                e.c.dSpaceRayBatch(this.space, count, at, at + 24 * count, at + 48 * count, filter_at, hits, 1);
                return Float64Array.from({length: count}, (_, i) => this.#distance_of(hits + i * size));
            });
        } finally {
            e.c.free(at);
        }
    }

    /** @param {number} at */
    #distance_of(at) {
        const hit = get_structure(this.engine, 'dQueryHit', at);
        return this.engine.i32[at >> 2] === 0 ? Infinity : hit.distance;
    }

    /**
     * The geoms that a geom touches or overlaps, but those of its own body.
     * @param {Geom} geom
     * @param {Filter | null} [filter] null: the geom's own bits
     * @returns {Geom[]}
     */
    overlaps(geom, filter = null) {
        const e = this.engine, label = 'World.overlaps', of = e.pointer_to(geom, Geom, label, 'geom');
        return this.#filtered(filter, label, at => {
            const found = e.c.dSpaceOverlap(this.space, of, at, 0, 0), to = e.buffer(4 * found), {i32} = e;
            e.c.dSpaceOverlap(this.space, of, at, to, found);
            return Array.from(i32.subarray(to >> 2, (to >> 2) + found), handle => e.object_at(handle >>> 0)).filter(one => one !== null);
        });
    }

    /**
     * The first geom that a geom would hit on its way, or null. Nothing moves.
     * @param {Geom} geom a convex solid
     * @param {VectorLike} motion from where it is, m
     * @param {Filter | null} [filter] null: the geom's own bits
     * @returns {QueryHit | null}
     */
    cast(geom, motion, filter = null) {
        const e = this.engine, label = 'World.cast', of = e.pointer_to(geom, Geom, label, 'geom'), hit = e.base + kHitAt;
        const way = e.put_vector(e.base, vector(motion, label, 'motion'));
        return this.#filtered(filter, label, at => e.c.dSpaceCast(this.space, of, way, at, hit) ? get_structure(e, 'dQueryHit', hit) : null);
    }

    /**
     * All geoms that a geom would hit on its way, each once, the nearest first.
     * @param {Geom} geom a convex solid
     * @param {VectorLike} motion m
     * @param {Filter | null} [filter] null: the geom's own bits
     * @returns {CastHit[]}
     */
    castAll(geom, motion, filter = null) {
        const e = this.engine, label = 'World.castAll', of = e.pointer_to(geom, Geom, label, 'geom');
        const way = e.put_vector(e.base, vector(motion, label, 'motion'));
        return this.#filtered(filter, label, at => this.#list('dCastHit', (to, capacity) => e.c.dSpaceCastAll(this.space, of, way, at, to, capacity)));
    }

    /**
     * How far two geoms are from each other, below 0 where they overlap; null where they are farther than the largest distance.
     * @param {Geom} geom1
     * @param {Geom} geom2
     * @param {number} [max_distance] m
     * @returns {QueryDistance | null}
     */
    distance(geom1, geom2, max_distance = Infinity) {
        const e = this.engine, label = 'World.distance', to = e.base + kHitAt;
        const a = e.pointer_to(geom1, Geom, label, 'geom1'), b = e.pointer_to(geom2, Geom, label, 'geom2');
        const found = e.c.dGeomGetDistance(a, b, real(max_distance, label, 'max_distance'), to);
        e.check(label);
        return found ? get_structure(e, 'dQueryDistance', to) : null;
    }

    /**
     * Pushes bodies away from a centre, as an explosion does. Returns how many.
     * @param {VectorLike} centre m
     * @param {number} radius m
     * @param {number} impulse N s, at the centre
     * @param {{falloff?: Falloff, occlusion?: boolean}} [options] falloff: how it decreases with the distance, 'linear'; occlusion: whether walls protect, false
     * @returns {number}
     */
    applyRadialImpulse(centre, radius, impulse, options = {}) {
        const e = this.engine, label = 'World.applyRadialImpulse', {falloff, occlusion} = options_of(options, ['falloff', 'occlusion'], label);
        const at = e.put_vector(e.base, vector(centre, label, 'centre')), hidden = flag(occlusion ?? false, label, 'occlusion');
        const how = number_of(enums.Falloff, falloff ?? 'linear', label, 'falloff');
        const count = e.c.dSpaceApplyRadialImpulse(this.space, at, real(radius, label, 'radius'), real(impulse, label, 'impulse'), how, hidden, 0);
        e.check(label);
        return count;
    }

    /** @param {VectorLike} origin @param {VectorLike} direction @param {number} length @param {string} label @returns {[number, number, number]} */
    #ray(origin, direction, length, label) {
        const e = this.engine, from = vector(origin, label, 'origin'), way = vector(direction, label, 'direction');
        return [e.put_vector(e.base, from), e.put_vector(e.base + 32, way), real(length, label, 'length')];
    }

    /**
     * Calls a query with the pointer to a filter.
     * @template T
     * @param {Filter | null} filter
     * @param {string} label
     * @param {(at: number) => T} query
     * @returns {T}
     */
    #filtered(filter, label, query) {
        const e = this.engine, layout = e.c.at(e.base + kFilterAt, 'dQueryFilter');
        let callback = 0, at = 0;
        if (filter !== null) {
            const {skipBody, accept, ...plain} = options_of(filter, [...Object.keys(fields.dQueryFilter), 'skipBody', 'accept'], label);
            const skipped = skipBody === undefined ? 0 : e.pointer_to(skipBody, Body, label, 'skipBody');
            if (accept !== undefined && typeof accept !== 'function') throw new TypeError(`${label}: accept must be a function`);
            at = put_structure(e, 'dQueryFilter', plain, e.base + kFilterAt, label);
            layout.skip_body = skipped;
            if (accept) callback = layout.callback = e.callback('ii:i', (_, geom) => accept(e.object_at(geom >>> 0)) ? 1 : 0);
        }
        try {
            const found = query(at);
            e.check(label);
            return found;
        } finally {
            if (callback) e.c.free_callback(callback);
        }
    }

    /** @param {string} type @param {(to: number, capacity: number) => number} query @returns {any[]} */
    #list(type, query) {
        const e = this.engine, count = query(0, 0), to = e.buffer(count * size_of(type));
        if (count > 0) query(to, count);
        return get_structures(e, type, to, count);
    }
}
