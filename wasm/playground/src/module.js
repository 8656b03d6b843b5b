// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The library, which is in the page itself (compressed, as text), so that the page also works when it is opened as a file.
export async function module_bytes() {
    const text = atob(document.getElementById('epode-module').textContent.trim());
    const packed = Uint8Array.from(text, letter => letter.charCodeAt(0));
    return new Response(new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'))).arrayBuffer();
}
