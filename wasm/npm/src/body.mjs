// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies: mass, geoms, sleep. Poses, velocities and forces are the headers' (methods.mjs).
import {flag, matrix, options_of, real} from './checks.mjs';
import {BodyMethods} from './methods.mjs';
import {create_geom} from './shapes.mjs';
import {get_structure, prepare_structure, put_structure, size_of} from './structures.mjs';
import {Vehicle} from './vehicle.mjs';
/** @import {World} from './world.mjs' */
/** @import {Geom} from './geom.mjs' */
/** @import {Joint} from './joint.mjs' */
/** @import {GeomKinds, GeomKindOptions} from './geoms.mjs' */
/** @import {GeomOptions} from './methods.mjs' */
/** @import {ShapeSizes, NewGeomOptions} from './shapes.mjs' */
/** @import {Matrix3, MatrixLike} from './checks.mjs' */
/** @import {VehicleSettings} from './fields.mjs' */

/** A rigid body. World.createBody makes them. */
export class Body extends BodyMethods {
    #mass = /** @type {'default' | 'geoms' | 'own'} */ ('default');
    #vehicle = /** @type {Vehicle | null} */ (null);

    /**
     * For the package alone.
     * @param {World} world
     * @param {number} pointer
     */
    constructor(world, pointer) {
        super(world.engine, pointer);
        /** @readonly The world that the body is in. */
        this.world = world;
    }

    /** Whether the body moves as it is told, and nothing moves it. False at first. @returns {boolean} */
    get kinematic() { return this.engine.c.dBodyIsKinematic(this.handle) !== 0; }

    /** @param {boolean} value */
    set kinematic(value) {
        const on = flag(value, 'Body.kinematic', 'value');
        on ? this.engine.c.dBodySetKinematic(this.handle) : this.engine.c.dBodySetDynamic(this.handle);
        this.engine.check('Body.kinematic');
    }

    /** Whether the body is simulated: false if it sleeps or was disabled. Setting it wakes the body or disables it. @returns {boolean} */
    get enabled() { return this.engine.c.dBodyIsEnabled(this.handle) !== 0; }

    /** @param {boolean} value */
    set enabled(value) {
        const on = flag(value, 'Body.enabled', 'value');
        on ? this.engine.c.dBodyEnable(this.handle) : this.engine.c.dBodyDisable(this.handle);
        this.engine.check('Body.enabled');
    }

    /** The mass, kg: of the geoms with a density, 1 without any. Setting it scales the inertia alike. @returns {number} */
    get mass() { return this.massProperties.mass; }

    /** @param {number} value */
    set mass(value) {
        const e = this.engine, mass = this.#get_mass();
        e.c.dMassAdjust(mass, real(value, 'Body.mass', 'value'));
        e.check('Body.mass');
        this.#set_mass(mass, 'Body.mass');
        this.#mass = 'own';
    }

    /** Mass (kg) and inertia about the centre of mass (kg m^2), which is the body's origin. @returns {{mass: number, inertia: Matrix3}} */
    get massProperties() {
        const {mass, inertia} = get_structure(this.engine, 'dMass', this.#get_mass());
        return {mass, inertia};
    }

    /** @param {{mass: number, inertia: MatrixLike}} value */
    set massProperties(value) {
        const label = 'Body.massProperties', {mass, inertia} = options_of(value, ['mass', 'inertia'], label), e = this.engine;
        const m = real(mass, label, 'mass'), i = matrix(inertia, label, 'inertia'), at = prepare_structure(e, 'dMass', e.buffer(size_of('dMass')));
        e.c.dMassSetParameters(at, m, 0, 0, 0, i[0], i[4], i[8], i[1], i[2], i[5]);
        e.check(label);
        this.#set_mass(at, label);
        this.#mass = 'own';
    }

    /** For the package alone: geoms without a stated density weigh nothing. */
    get weighs_by_itself() { return this.#mass === 'own' || this.kinematic; }

    /** The geoms of the body. @returns {Geom[]} */
    get geoms() {
        const found = [], {c} = this.engine;
        for (let geom = c.dBodyGetFirstGeom(this.handle); geom; geom = c.dBodyGetNextGeom(geom)) found.push(this.engine.object_at(geom));
        return found.filter(geom => geom !== null).reverse();
    }

    /** The joints at the body. @returns {Joint[]} */
    get joints() {
        const {c} = this.engine;
        return Array.from({length: this.jointCount}, (_, i) => this.engine.object_at(c.dBodyGetJoint(this.handle, i))).filter(joint => joint !== null);
    }

    /**
     * Adds a geom to the body, and its mass. The body's origin is its centre of mass: where a geom moves that, the body's position
     * and the offsets of its geoms change so that nothing moves in the world.
     * @template {keyof ShapeSizes} K
     * @param {K} kind
     * @param {ShapeSizes[K] & GeomOptions & NewGeomOptions & Omit<GeomKindOptions[K], keyof ShapeSizes[K]>} options sizes, place (`offsetPosition`, `offsetQuaternion`), `density` or `mass`, `material`, bits
     * @returns {GeomKinds[K]}
     */
    createGeom(kind, options) { return create_geom(this.world, this, kind, options); }

    /**
     * Makes the body a vehicle without wheels.
     * @param {Partial<VehicleSettings>} [settings] fields that are not given have their defaults
     * @returns {Vehicle}
     */
    makeVehicle(settings = {}) {
        const e = this.engine, at = put_structure(e, 'dVehicleSettings', settings, e.base, 'Body.makeVehicle');
        e.c.dVehicleCreate(this.handle, at);
        e.check('Body.makeVehicle');
        return this.#vehicle = new Vehicle(this);
    }

    /** The vehicle that the body is, or null. @returns {Vehicle | null} */
    get vehicle() {
        if (!this.engine.c.dBodyIsVehicle(this.handle)) return null;
        return this.#vehicle ??= new Vehicle(this);
    }

    /** Destroys the body with its geoms and joints. */
    destroy() {
        const e = this.engine, {geoms, joints} = this;
        for (const joint of joints) joint.destroy();
        for (const geom of geoms) geom.destroy();
        e.c.dBodyDestroy(this.handle);
        e.check('Body.destroy');
        this.world.ended(this);
    }

    #get_mass() {
        const e = this.engine, at = e.buffer(2 * size_of('dMass'));
        e.c.dBodyGetMass(this.handle, at);
        e.check('Body.mass');
        return at;
    }

    /** @param {number} mass @param {string} label */
    #set_mass(mass, label) {
        this.engine.c.dBodySetMass(this.handle, mass);
        this.engine.check(label);
    }

    /**
     * For the package alone: a geom's mass, in its own frame, joins that of the others.
     * @param {number} mass
     * @param {Geom} geom
     * @param {string} label
     */
    add_mass(mass, geom, label) {
        const e = this.engine, {c} = e, all = mass;
        e.put_matrix(e.base, geom.offsetRotation);
        c.dMassRotate(mass, e.base);
        c.dMassTranslate(mass, ...geom.offsetPosition);
        if (this.#mass !== 'default') {
            const had = c.malloc(size_of('dMass'));
            c.dBodyGetMass(this.handle, had);
            c.dMassAdd(mass, had);
            c.free(had);
        }
        e.check(label);
        this.#move_origin(all, get_structure(e, 'dMass', all).centre, label);
        this.#mass = 'geoms';
    }

    /** @param {number} mass @param {[number, number, number]} centre @param {string} label */
    #move_origin(mass, centre, label) {
        const {c} = this.engine, [x, y, z] = centre, moves = Math.hypot(x, y, z) > 1e-12;
        if (moves) c.dMassTranslate(mass, -x, -y, -z);
        this.#set_mass(mass, label);
        if (!moves) return;
        const place = this.getRelPointPosition(centre), velocity = this.getRelPointVelocity(centre);
        for (const geom of this.geoms) {
            const [gx, gy, gz] = geom.offsetPosition;
            geom.offsetPosition = [gx - x, gy - y, gz - z];
        }
        this.position = place;
        this.linearVelocity = velocity;
    }
}
