// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the package throws besides TypeError, which says that an argument has the wrong type.

/** @typedef {'refused' | 'destroyed' | 'other' | 'failed'} ErrorKind refused: by the library, for its reasons; destroyed: the object no
    longer exists; other: it is of another world or engine; failed: for want of memory */

/** A call that has changed nothing, and why. */
export class EpodeError extends Error {
    /**
     * @param {ErrorKind} kind
     * @param {string} message
     */
    constructor(kind, message) {
        super(message);
        this.name = 'EpodeError';
        /** @readonly */
        this.kind = kind;
    }
}
