// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Runs a program for WASI under Node as if it were native: node --no-warnings wasi.mjs PROGRAM [ARGUMENT...].
// Its files are this machine's; it begins in the folder / and gets absolute paths. The system's functions are wrapped. Where WebAssembly
// called those of Node 20.20 directly, many long runs died of a signal, with the stack damaged; none has since.
import { readFile } from 'node:fs/promises';
import { WASI } from 'node:wasi';

const program = process.argv[2];
const wasi = new WASI({ version: 'preview1', args: process.argv.slice(2), env: process.env, preopens: { '/': '/' } });
const system = Object.fromEntries(Object.entries(wasi.wasiImport).map(([name, call]) => [name, (...values) => call(...values)]));
const module = await WebAssembly.compile(await readFile(program));
process.exitCode = wasi.start(await WebAssembly.instantiate(module, { wasi_snapshot_preview1: system }));
