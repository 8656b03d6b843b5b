// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Arguments as JavaScript has them, checked before C sees them: a wrong type throws a TypeError that says what it was. What a
// number may be beyond that is for the library to say.

/** @typedef {[number, number, number]} Vector3 x, y, z */
/** @typedef {[number, number, number, number]} Vector4 */
/** @typedef {[number, number, number, number]} Quaternion w, x, y, z */
/** @typedef {[number, number, number, number, number, number, number, number, number]} Matrix3 three rows of three */
/** @typedef {[number, number, number, number, number, number]} Box6 smallest and largest x, then y, then z */
/** @typedef {ArrayLike<number> | {x: number, y: number, z: number}} VectorLike an array of three, or what has x, y and z, as three.js's Vector3 */
/** @typedef {ArrayLike<number> | {x: number, y: number, z: number, w: number}} QuaternionLike an array w, x, y, z, or what has these, as three.js's Quaternion */
/** @typedef {ArrayLike<number>} MatrixLike nine numbers, three rows of three */

/**
 * What a message shows of a value, whatever it is.
 * @param {unknown} value
 * @returns {string}
 */
export function shown(value) {
    if (typeof value === 'string') return JSON.stringify(value.length > 40 ? `${value.slice(0, 40)}...` : value);
    if (value === null || ['number', 'boolean', 'undefined', 'bigint'].includes(typeof value)) return String(value);
    if (Array.isArray(value)) return `an array of ${value.length}`;
    return typeof value === 'object' ? 'an object' : `a ${typeof value}`;
}

/**
 * @param {string} label
 * @param {string} name
 * @param {string} wanted
 * @param {unknown} value
 * @returns {never}
 */
export function refuse(label, name, wanted, value) {
    throw new TypeError(`${label}: ${name} must be ${wanted}, not ${shown(value)}`);
}

/**
 * A number, which may be infinite but not NaN.
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {number}
 */
export function real(value, label, name) {
    if (typeof value !== 'number' || value !== value) refuse(label, name, 'a number', value);
    return value;
}

/**
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {number}
 */
export function int32(value, label, name) {
    if (typeof value !== 'number' || (value | 0) !== value) refuse(label, name, 'an integer of 32 bits', value);
    return value;
}

/**
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {number}
 */
export function uint32(value, label, name) {
    if (typeof value !== 'number' || value >>> 0 !== value) refuse(label, name, 'an integer from 0 to 2^32 - 1', value);
    return value;
}

/**
 * A boolean, as C has it.
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {number}
 */
export function flag(value, label, name) {
    if (typeof value !== 'boolean') refuse(label, name, 'true or false', value);
    return value ? 1 : 0;
}

/**
 * Three numbers.
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {Vector3}
 */
export function vector(value, label, name) {
    if (typeof value !== 'object' || value === null) return refuse(label, name, 'three numbers', value);
    const v = /** @type {any} */ (value);
    if ('length' in v) {
        if (v.length !== 3) refuse(label, name, 'three numbers', value);
        return [real(v[0], label, `${name}[0]`), real(v[1], label, `${name}[1]`), real(v[2], label, `${name}[2]`)];
    }
    return [real(v.x, label, `${name}.x`), real(v.y, label, `${name}.y`), real(v.z, label, `${name}.z`)];
}

/**
 * Four numbers: w, x, y, z.
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {Quaternion}
 */
export function quaternion(value, label, name) {
    if (typeof value !== 'object' || value === null) return refuse(label, name, 'a quaternion', value);
    const q = /** @type {any} */ (value);
    if ('length' in q) return /** @type {Quaternion} */ (numbers(value, 4, label, name));
    return [real(q.w, label, `${name}.w`), ...vector({x: q.x, y: q.y, z: q.z}, label, name)];
}

/**
 * Nine numbers, three rows.
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {Matrix3}
 */
export function matrix(value, label, name) {
    return /** @type {Matrix3} */ (numbers(value, 9, label, name));
}

/**
 * So many numbers, or (count -1) any.
 * @param {unknown} value
 * @param {number} count
 * @param {string} label
 * @param {string} name
 * @returns {number[]}
 */
export function numbers(value, count, label, name) {
    const v = /** @type {any} */ (value);
    const is_list = typeof value === 'object' && value !== null && Number.isInteger(v.length) && v.length >= 0;
    if (!is_list || (count >= 0 && v.length !== count)) refuse(label, name, count < 0 ? 'an array of numbers' : `${count} numbers`, value);
    const found = [];
    for (let i = 0; i < v.length; ++i) found.push(real(v[i], label, `${name}[${i}]`));
    return found;
}

/**
 * The number that C has for a name.
 * @param {{[name: string]: number}} of
 * @param {unknown} value
 * @param {string} label
 * @param {string} name
 * @returns {number}
 */
export function number_of(of, value, label, name) {
    if (typeof value !== 'string' || !Object.hasOwn(of, value)) refuse(label, name, `one of ${Object.keys(of).join(', ')}`, value);
    return of[value];
}

/**
 * The name of a number of C.
 * @param {{[name: string]: number}} of
 * @param {number} number
 * @returns {any}
 */
export function name_of(of, number) {
    for (const name in of) if (of[name] === number) return name;
    return String(number);
}

/**
 * An object with these properties and no others.
 * @param {unknown} value
 * @param {string[]} names
 * @param {string} label
 * @returns {{[name: string]: any}}
 */
export function options_of(value, names, label) {
    if (typeof value !== 'object' || value === null || Array.isArray(value)) refuse(label, 'options', 'an object', value);
    for (const name of Object.keys(value)) {
        if (!names.includes(name)) throw new TypeError(`${label}: there is no option ${shown(name)}; there are ${names.join(', ')}`);
    }
    return {...value};
}
