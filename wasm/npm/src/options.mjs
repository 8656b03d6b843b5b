// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Options of new objects: the properties that can be set, under their names. What one refuses ends the new object, so nothing has changed.
import {options_of} from './checks.mjs';
import {settable} from './settable.mjs';

/**
 * Checks the names of options, before anything is made.
 * @param {unknown} options
 * @param {string[]} kinds classes whose properties they may be
 * @param {string[]} more further names
 * @param {string} label
 * @returns {{[name: string]: any}}
 */
export function checked_options(options, kinds, more, label) {
    return options_of(options, [...kinds.flatMap(kind => settable[kind]), ...more], label);
}

/**
 * Sets properties of a new object; if one is refused the object is destroyed.
 * @template {{destroy(): void}} T
 * @param {T} made
 * @param {() => void} set
 * @param {() => void} [restore] what destroying it may have changed
 * @returns {T}
 */
export function finished(made, set, restore = () => {}) {
    try {
        set();
    } catch (error) {
        made.destroy();
        restore();
        throw error;
    }
    return made;
}

/**
 * @param {any} object
 * @param {{[name: string]: any}} options
 * @param {string[]} left_out names that are no properties
 */
export function assign(object, options, left_out) {
    for (const [name, value] of Object.entries(options)) {
        if (value !== undefined && !left_out.includes(name)) object[name] = value;
    }
}
