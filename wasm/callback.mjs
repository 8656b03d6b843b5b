// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions of JavaScript that C can call. A table holds functions of WebAssembly only, so each is imported by a module
// of some forty bytes that exports it again with its type.
const kCode = {i: 0x7f, j: 0x7e, f: 0x7d, d: 0x7c};

function typed(type, call) {
    const [parameters, result] = type.split(':').map(letters => [...letters].map(letter => kCode[letter]));
    if (!result || result.length > 1 || [...parameters, ...result].includes(undefined))
        throw new TypeError(`no type of a callback: '${type}'; an example is 'iid:i'`);
    const function_type = [0x60, parameters.length, ...parameters, result.length, ...result];
    const bytes = [
        0, 0x61, 0x73, 0x6d, 1, 0, 0, 0,                               // "\0asm", version 1
        1, function_type.length + 1, 1, ...function_type,              // types: this one
        2, 7, 1, 1, 0x65, 1, 0x66, 0, 0,                               // imports: e.f, a function of this type
        7, 5, 1, 1, 0x66, 0, 0,                                        // exports: f
    ];
    return new WebAssembly.Instance(new WebAssembly.Module(new Uint8Array(bytes)), {e: {f: call}}).exports.f;
}

// The functions of one instance that C can call, by their places in its table.
export class Callbacks {
    constructor(table, report) {
        this.table = table;
        this.report = report;
        this.free = [];
    }

    // The pointer for C. An error in the function must not unwind the library, whose call would never end: it is
    // reported, by default as one that nobody caught, and C gets 0.
    add(type, call) {
        const guarded = (...values) => {
            try {
                return call(...values);
            } catch (error) {
                this.report(error);
                return type.endsWith('j') ? 0n : 0;
            }
        };
        const place = this.free.pop() ?? this.table.grow(1);
        this.table.set(place, typed(type, guarded));
        return place;
    }

    remove(place) {
        this.table.set(place, null);
        this.free.push(place);
    }
}
