// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Structures of C as plain objects, by the generated tables of fields (fields.mjs) and the compiler's layouts (c/interface.mjs).
import {structures} from './c/interface.mjs';
import {flag, int32, matrix, name_of, number_of, numbers, real, refuse, shown, uint32, vector} from './checks.mjs';
import {enums} from './enums.mjs';
import {fields} from './fields.mjs';
/** @import {Engine} from './engine.mjs' */

/** @typedef {{size: number, fields: {[name: string]: [number, string, number]}}} Layout */

/** @param {string} type @returns {Layout} */
const layout_of = type => /** @type {any} */ (structures)[type];

/** @param {string} type @returns {number} */
export const size_of = type => layout_of(type).size;

/**
 * Fills a structure with its defaults, or with zeros and its size.
 * @param {Engine} e
 * @param {string} type
 * @param {number} at
 * @returns {number} at
 */
export function prepare_structure(e, type, at) {
    const {size, fields: of} = layout_of(type);
    new Uint8Array(e.c.memory.buffer, at, size).fill(0);
    if (e.c[`${type}Init`]) e.c[`${type}Init`](at, size);
    else if ('struct_size' in of) e.i32[at + of.struct_size[0] >> 2] = size;
    return at;
}

/**
 * Writes an object's fields over the defaults; null is a null pointer.
 * @param {Engine} e
 * @param {string} type
 * @param {unknown} value
 * @param {number} at
 * @param {string} label
 * @returns {number} the pointer
 */
export function put_structure(e, type, value, at, label) {
    if (value === null) return 0;
    if (typeof value !== 'object') refuse(label, 'settings', 'an object', value);
    const rows = Object.entries(/** @type {object} */ (value)).map(([name, given]) => {
        if (!Object.hasOwn(fields[type], name))
            throw new TypeError(`${label}: there is no field ${shown(name)}; there are ${Object.keys(fields[type]).join(', ')}`);
        return /** @type {[string, unknown]} */ ([name, given]);
    });
    prepare_structure(e, type, at);
    for (const [name, given] of rows) put_field(e, type, name, given, at, label);
    return at;
}

/** @param {Engine} e @param {string} type @param {string} name @param {unknown} value @param {number} base @param {string} label */
function put_field(e, type, name, value, base, label) {
    const [of, kind] = fields[type][name], at = base + layout_of(type).fields[of][0], [plain, count] = kind.split(':');
    if (plain === 'real') e.f64[at >> 3] = real(value, label, name);
    else if (plain === 'int32') e.i32[at >> 2] = int32(value, label, name);
    else if (plain === 'uint32') e.i32[at >> 2] = uint32(value, label, name);
    else if (plain === 'flag') e.i32[at >> 2] = flag(value, label, name);
    else if (plain === 'vector') e.put_vector(at, vector(value, label, name));
    else if (plain === 'matrix') e.put_matrix(at, matrix(value, label, name));
    else if (plain === 'reals') put_reals(e, at, numbers(value, -1, label, name), Number(count), label, name);
    else if (enums[plain]) e.i32[at >> 2] = number_of(enums[plain], value, label, name);
    else throw new TypeError(`${label}: ${name} cannot be set`);
}

/** What is not given is 0. @param {Engine} e @param {number} at @param {number[]} values @param {number} count @param {string} label @param {string} name */
function put_reals(e, at, values, count, label, name) {
    if (values.length > count) throw new TypeError(`${label}: ${name} has at most ${count} numbers, not ${values.length}`);
    e.f64.fill(0, at >> 3, (at >> 3) + count).set(values, at >> 3);
}

/**
 * A structure as an object.
 * @param {Engine} e
 * @param {string} type
 * @param {number} at
 * @returns {any}
 */
export function get_structure(e, type, at) {
    const found = /** @type {{[name: string]: unknown}} */ ({}), layout = layout_of(type).fields;
    for (const name in fields[type]) {
        const [of, kind] = fields[type][name];
        found[name] = get_field(e, kind, at + layout[of][0]);
    }
    return found;
}

/** @param {Engine} e @param {string} kind @param {number} at @returns {unknown} */
function get_field(e, kind, at) {
    const [plain, count] = kind.split(':');
    if (plain === 'real') return e.f64[at >> 3];
    if (plain === 'vector') return e.vector(at);
    if (plain === 'matrix') return e.matrix(at);
    if (plain === 'reals') return Array.from(e.f64.subarray(at >> 3, (at >> 3) + Number(count)));
    const number = e.i32[at >> 2];
    if (plain === 'int32') return number;
    if (plain === 'uint32') return number >>> 0;
    if (plain === 'flag') return number !== 0;
    if (plain === 'object') return e.object_at(number >>> 0);
    return plain.endsWith('?') ? (number ? name_of(enums[plain.slice(0, -1)], number) : null) : name_of(enums[plain], number);
}

/**
 * Structures that follow each other.
 * @param {Engine} e
 * @param {string} type
 * @param {number} at
 * @param {number} count
 * @returns {any[]}
 */
export function get_structures(e, type, at, count) {
    const size = size_of(type);
    return Array.from({length: count}, (_, i) => get_structure(e, type, at + i * size));
}
