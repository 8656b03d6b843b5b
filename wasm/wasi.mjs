// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the module asks of WASI, in a browser as in Node: clocks, and text for the console. There are no files and no
// variables of the environment; a call that wants one fails as on a system that grants nothing.
const kSuccess = 0, kBadFile = 8, kNotSupported = 58, kNotCapable = 76;

// Thrown where a C program would end: the library does so only in dError and dDebug.
export class Exit extends Error {
    constructor(code) {
        super(`the library ended the program with status ${code}`);
        this.code = code;
    }
}

// The lines that are written to a descriptor, one by one.
class Lines {
    constructor(print) {
        this.print = print;
        this.decoder = new TextDecoder();
        this.rest = '';
    }

    add(bytes) {
        const lines = (this.rest + this.decoder.decode(bytes, {stream: true})).split('\n');
        this.rest = lines.pop();
        for (const line of lines) if (line !== '') this.print(line);
    }
}

// The imports of a module. `memory()` is asked for the memory when it is there; print(line) gets what is written.
export function wasi(memory, print) {
    const view = () => new DataView(memory().buffer);
    const lines = {1: new Lines(print), 2: new Lines(print)};
    const fails = why => () => why;
    return {
        environ_sizes_get(count, size) {
            view().setUint32(count, 0, true);
            view().setUint32(size, 0, true);
            return kSuccess;
        },
        environ_get: fails(kSuccess),
        clock_res_get(clock, out) {
            view().setBigUint64(out, 1000n, true);
            return kSuccess;
        },
        clock_time_get(clock, precision, out) {
            const milliseconds = clock === 0 ? Date.now() : performance.now();
            view().setBigUint64(out, BigInt(Math.round(milliseconds * 1e6)), true);
            return kSuccess;
        },
        fd_write(file, vectors, count, written) {
            if (!lines[file]) return kBadFile;
            let total = 0;
            for (let i = 0; i < count; ++i) {
                const at = view().getUint32(vectors + 8 * i, true), size = view().getUint32(vectors + 8 * i + 4, true);
                lines[file].add(new Uint8Array(memory().buffer, at, size).slice());
                total += size;
            }
            view().setUint32(written, total, true);
            return kSuccess;
        },
        fd_fdstat_get(file, out) {
            if (!lines[file]) return kBadFile;
            new Uint8Array(memory().buffer, out, 24).fill(0)[0] = 2;  // a character device
            return kSuccess;
        },
        fd_seek: fails(kNotSupported),
        sched_yield: fails(kSuccess),
        proc_exit(code) { throw new Exit(code); },
        ...Object.fromEntries(['fd_close', 'fd_filestat_get', 'fd_prestat_get', 'fd_prestat_dir_name', 'fd_read', 'fd_sync']
            .map(name => [name, fails(kBadFile)])),
        ...Object.fromEntries(['path_filestat_get', 'path_open', 'path_rename', 'path_unlink_file']
            .map(name => [name, fails(kNotCapable)])),
    };
}
