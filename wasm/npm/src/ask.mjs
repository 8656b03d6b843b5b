// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Calls of the library of robots, whose refusals become errors.
import {EpodeError} from './errors.mjs';
/** @import {Engine} from './engine.mjs' */

/**
 * Calls the robots' library, which refuses by a message. What would be an exception natively is a trap in WebAssembly, after which the
 * engine can be used further.
 * @template T
 * @param {Engine} e
 * @param {string} label
 * @param {() => T} call
 * @returns {{result: T, said: string[]}}
 */
export function ask(e, label, call) {
    const {result, said} = e.heard(() => e.c.rescue(call, () => {
        throw new EpodeError('failed', `${label}: there is no memory left, or a file is damaged in a way that no reader expects`);
    }));
    e.check(label);
    return {result, said};
}

/**
 * The same where the library's answer 0 is a refusal.
 * @param {Engine} e
 * @param {string} label
 * @param {() => number} call
 * @returns {number}
 */
export function wanted(e, label, call) {
    const {result, said} = ask(e, label, call);
    if (!result) throw new EpodeError('refused', `${label}: ${said[0] ?? 'refused'}`);
    return result;
}
