// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The library for JavaScript, in browsers and in Node:
//
//   import {load} from './epode.mjs';
//   const ode = await load();
//   const world = ode.dWorldCreate();
//   ode.dWorldSetGravity(world, 0, 0, -9.81);
//   const ball = ode.dBodyCreate(world);
//   for (let i = 0; i < 100; ++i) ode.dWorldStep(world, 0.01);
//   console.log(ode.reals(ode.dBodyGetPosition(ball), 3)[2]);
//
// Every C function and constant has its name. Handles and pointers are numbers, integers of 64 bits are BigInts. The
// memory is the module's own: what C reads by a pointer is put there first (new_reals, new_string, create) and freed
// afterwards (free).
import {Callbacks} from './callback.mjs';
import {constants, real, structures} from './interface.mjs';
import {Exit, wasi} from './wasi.mjs';

export {Exit};

const kElements = {Int32: Int32Array, Uint32: Uint32Array, Uint8: Uint8Array, Uint16: Uint16Array, Float32: Float32Array,
                   Float64: Float64Array, BigInt64: BigInt64Array, BigUint64: BigUint64Array};

// The module's bytes: from a server, or in Node from a file.
async function bytes_of(source) {
    if (!(source instanceof URL)) return source;
    if (source.protocol === 'file:') return (await import('node:fs/promises')).readFile(source);
    const response = await fetch(source);
    if (!response.ok) throw new Error(`${source}: ${response.status} ${response.statusText}`);
    return response.arrayBuffer();
}

// A structure in the module's memory, its fields as properties: numbers, and arrays as views.
function structure_class(name, memory) {
    const layout = structures[name];
    if (!layout) throw new TypeError(`no structure ${name}`);
    class Structure {
        constructor(pointer) { this.pointer = pointer; }
        set(fields) {
            for (const [key, value] of Object.entries(fields)) {
                if (!(key in layout.fields)) throw new TypeError(`${name} has no field ${key}`);
                this[key] = value;
            }
            return this;
        }
        pointer_to(field) { return this.pointer + layout.fields[field][0]; }
    }
    Structure.size = layout.size;
    for (const [field, [offset, kind, count]] of Object.entries(layout.fields)) {
        const all = structure => new kElements[kind](memory.buffer, structure.pointer + offset, count);
        Object.defineProperty(Structure.prototype, field, {
            get() { return count > 1 ? all(this) : all(this)[0]; },
            set(value) { count > 1 ? all(this).set(value) : (all(this)[0] = value); },
        });
    }
    return Structure;
}

class Ode {
    #exports;
    #memory;
    #callbacks;
    #classes = {};

    constructor(exports, report) {
        this.#exports = exports;
        this.#memory = exports.memory;
        this.#callbacks = new Callbacks(exports.__indirect_function_table, report);
        for (const [name, value] of Object.entries(exports)) if (/^d[A-Z]/.test(name)) this[name] = value;
        Object.assign(this, constants);
    }

    // WebAssembly's memory. Its buffer is another one after it has grown.
    get memory() { return this.#memory; }

    // A view of numbers in the module's memory. It ends when the memory grows, which any call may do: use it at once,
    // or copy it.
    reals(pointer, count) { return new kElements[real](this.#memory.buffer, pointer, count); }
    bytes(pointer, count) { return new Uint8Array(this.#memory.buffer, pointer, count); }
    ints(pointer, count) { return new Int32Array(this.#memory.buffer, pointer, count); }
    string(pointer) {
        const from = new Uint8Array(this.#memory.buffer, pointer);
        return new TextDecoder().decode(from.slice(0, from.indexOf(0)));
    }

    // Memory for C, as pointers; free() takes it back. A throw: there is no memory left.
    malloc(size) {
        const pointer = this.#exports.malloc(size);
        if (pointer === 0) throw new RangeError(`no memory for ${size} bytes`);
        return pointer;
    }
    free(pointer) { this.#exports.free(pointer); }
    new_reals(values) {
        const pointer = this.malloc(kElements[real].BYTES_PER_ELEMENT * Math.max(1, values.length));
        this.reals(pointer, values.length).set(values);
        return pointer;
    }
    new_ints(values) {
        const pointer = this.malloc(4 * Math.max(1, values.length));
        this.ints(pointer, values.length).set(values);
        return pointer;
    }
    new_string(text) {
        const encoded = new TextEncoder().encode(text), pointer = this.malloc(encoded.length + 1);
        this.bytes(pointer, encoded.length + 1).set([...encoded, 0]);
        return pointer;
    }

    // Of the module with robots: holds bytes as the file of an absolute path for dRobotModelLoad, and forgets all files.
    hold_file(path, bytes) {
        const name = this.new_string(path), copy = this.malloc(bytes.length || 1);
        this.bytes(copy, bytes.length).set(bytes);
        this.#exports.epode_hold_file(name, copy, bytes.length);
        this.free(copy), this.free(name);
    }
    drop_files() { this.#exports.epode_drop_files(); }

    // call(), or where it traps (natively it would throw, most often for want of memory) otherwise(error), with the stack as it was. Only
    // in a module that exports its __stack_pointer.
    rescue(call, otherwise) {
        const stack = this.#exports.__stack_pointer, before = stack.value;
        try {
            return call();
        } catch (error) {
            if (!(error instanceof WebAssembly.RuntimeError || error instanceof Exit)) throw error;
            stack.value = before;
            return otherwise(error);
        }
    }

    // The structure of this name at a pointer, e.g. at(…, 'dContactGeom').depth; of nested ones 'surface.mu'.
    at(pointer, name) {
        this.#classes[name] ??= structure_class(name, this.#memory);
        return new this.#classes[name](pointer);
    }
    size_of(name) { return structures[name].size; }

    // A new structure with its defaults and these fields. Its `pointer` is for C; free(it.pointer) when it is not needed.
    create(name, fields = {}) {
        const size = this.size_of(name), made = this.at(this.malloc(size), name);
        this.bytes(made.pointer, size).fill(0);
        if (this[`${name}Init`]) this[`${name}Init`](made.pointer, size);
        else if ('struct_size' in structures[name].fields) made.struct_size = size;
        return made.set(fields);
    }

    // A function for C, as a pointer. Its type has a letter for each parameter and, after a colon, for the result: i for
    // int, pointers and handles, d for double, f for float, j for 64 bits. A near callback has 'iii:'.
    callback(type, call) { return this.#callbacks.add(type, call); }
    free_callback(pointer) { this.#callbacks.remove(pointer); }

    // handler(channel, number, text) gets all messages instead of the console; channel: 'error', 'debug' or 'message'.
    on_message(handler) {
        const kText = 1024, kSetters = {error: 'dSetErrorHandler', debug: 'dSetDebugHandler', message: 'dSetMessageHandler'};
        for (const [channel, setter] of Object.entries(kSetters)) {
            this[setter](this.callback('iii:', (number, format, values) => {
                const text = this.malloc(kText);
                this.#exports.vsnprintf(text, kText, format, values);
                const message = this.string(text);
                this.free(text);
                handler(channel, number, message);
            }));
        }
    }
}

// The library, ready for use: dInitODE2 has been called. source: a URL, or the bytes or the WebAssembly.Module; print(line)
// gets what the library writes, messages without a handler above all; report(error) gets what callbacks throw.
export async function load(source = new URL('epode.wasm', import.meta.url), {
    print = line => console.error(line),
    report = error => queueMicrotask(() => { throw error; }),
} = {}) {
    const found = await bytes_of(source);
    const module = found instanceof WebAssembly.Module ? found : await WebAssembly.compile(found);
    const instance = await WebAssembly.instantiate(module, {wasi_snapshot_preview1: wasi(() => instance.exports.memory, print)});
    instance.exports._initialize();
    const ode = new Ode(instance.exports, report);
    if (!ode.dInitODE2(0)) throw new Error('dInitODE2 failed');
    return ode;
}
