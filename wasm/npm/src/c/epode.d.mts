// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions and constants by their names, without types: docs/guide/howto/browser.md describes the interface.
export class Exit extends Error { code: number; }
export function load(source?: URL | BufferSource | WebAssembly.Module,
                     options?: {print?: (line: string) => void; report?: (error: unknown) => void}): Promise<any>;
