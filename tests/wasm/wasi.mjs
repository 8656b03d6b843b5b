// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Runs a program for WASI under Node as if it were native: node --no-warnings wasi.mjs PROGRAM [ARGUMENT...].
// Its files are this machine's; it begins in the folder / and gets absolute paths. Node 20 now and then died of a signal in programs
// that run for minutes; it has not since its V8 frees no compiled code.
import { readFile } from 'node:fs/promises';
import { setFlagsFromString } from 'node:v8';
import { WASI } from 'node:wasi';

setFlagsFromString('--no-wasm-code-gc');
const program = process.argv[2];
const wasi = new WASI({ version: 'preview1', args: process.argv.slice(2), env: process.env, preopens: { '/': '/' } });
const module = await WebAssembly.compile(await readFile(program));
process.exit(wasi.start(await WebAssembly.instantiate(module, wasi.getImportObject())));
