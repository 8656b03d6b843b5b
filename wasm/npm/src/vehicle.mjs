// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vehicles: bodies on wheels. docs/guide/howto/vehicles.md explains; settings and wheels are the headers'.
import {options_of} from './checks.mjs';
import {fields} from './fields.mjs';
import {VehicleMethods} from './methods.mjs';
import {get_structure, prepare_structure, put_structure} from './structures.mjs';
/** @import {Body} from './body.mjs' */
/** @import {VehicleControls} from './fields.mjs' */

/** What drives a body on wheels. Body.makeVehicle makes it. Call update before each step of the world. */
export class Vehicle extends VehicleMethods {
    /**
     * For the package alone.
     * @param {Body} body
     */
    constructor(body) {
        super(body.engine, 0);
        /** @readonly The chassis. */
        this.body = body;
    }

    /** The handle of the chassis. @returns {number} */
    get handle() { return this.body.handle; }

    /** Whether the chassis no longer exists. */
    get isDestroyed() { return this.body.isDestroyed; }

    /** What the driver does. @returns {VehicleControls} */
    get controls() {
        const e = this.engine, at = prepare_structure(e, 'dVehicleControls', e.base);
        e.c.dVehicleGetControls(this.handle, at);
        e.check('Vehicle.controls');
        return get_structure(e, 'dVehicleControls', at);
    }

    /** What is not given stays. @param {Partial<VehicleControls>} value */
    set controls(value) {
        const e = this.engine, given = options_of(value, Object.keys(fields.dVehicleControls), 'Vehicle.controls');
        const at = put_structure(e, 'dVehicleControls', {...this.controls, ...given}, e.base, 'Vehicle.controls');
        e.c.dVehicleSetControls(this.handle, at);
        e.check('Vehicle.controls');
    }
}
