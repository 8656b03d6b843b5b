// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The recording inside the page: a JSON head that says what is where, and one block of little-endian numbers, compressed.
// record/output/page.cpp writes both.

async function bytes_of(base64) {
    const text = atob(base64);
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
    return new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate-raw'))).arrayBuffer();
}

// Puts back what record/output/columns.h has rearranged: second differences of each column, low bytes before high bytes.
export function put_back(block, [offset, count], width) {
    const rows = Math.floor(count / width), bytes = new Uint8Array(block, offset, 2 * count).slice(), out = new Uint16Array(block, offset, count);
    for (let column = 0; column < width; ++column) {
        let one = 0, two = 0;
        for (let row = 0; row < rows; ++row) {
            const at = column * rows + row, folded = bytes[at] | bytes[width * rows + at] << 8;
            const now = (folded >> 1 ^ -(folded & 1)) + 2 * one - two & 0xffff;
            out[row * width + column] = now;
            two = one;
            one = now;
        }
    }
}

export async function load_recording(document) {
    const head = JSON.parse(document.getElementById('head').textContent);
    const element = document.getElementById('data');
    const block = await bytes_of(element.textContent.trim());
    element.textContent = '';  // not needed twice in memory
    put_back(block, head.carriers.positions, 3);
    put_back(block, head.carriers.turns, 4);
    const view = (type, [offset, count]) => new type(block, offset, count);
    return {
        ...head,
        times: view(Float32Array, head.times),
        solids: head.solids.map(solid => ({
            kind: solid.kind,
            points: view(Float32Array, solid.points),
            normals: view(Float32Array, solid.normals),
            corners: view(Uint32Array, solid.corners),
        })),
        parts: {
            count: head.parts.count,
            numbers: view(Int32Array, head.parts.numbers),  // solid, carrier, colour, body
            poses: view(Float32Array, head.parts.poses),    // position, quaternion w x y z, scale
        },
        carriers: {
            count: head.carriers.count,
            lives: head.carriers.lives,
            numbers: view(Int32Array, head.carriers.numbers),  // body, first key, number of keys, place of the first
            frames: view(Float32Array, head.carriers.frames),  // low corner, extent
            positions: view(Uint16Array, head.carriers.positions),
            turns: view(Int16Array, head.carriers.turns),
        },
        series: {
            times: view(Float32Array, head.series.times),
            kinetic: view(Float32Array, head.series.kinetic),
            potential: view(Float32Array, head.series.potential),
            joint_error: view(Float32Array, head.series.joint_error),
            ms: view(Float32Array, head.series.ms),
        },
        contacts: {
            ...head.contacts,
            starts: view(Uint32Array, head.contacts.starts),
            places: view(Uint16Array, head.contacts.places),    // x, y, z in the box of all contacts
            normals: view(Int8Array, head.contacts.normals),    // x, y, z / 127
            forces: view(Uint16Array, head.contacts.forces),    // / 65535 of the largest
        },
        joints: {
            count: head.joints.count,
            carriers: view(Int32Array, head.joints.carriers),
            anchors: view(Float32Array, head.joints.anchors),
        },
        hashes: view(Uint32Array, head.hashes),  // low, high
    };
}

export function hash_text(recording, moment) {
    const part = i => recording.hashes[2 * moment + i].toString(16).padStart(8, '0');
    return part(1) + part(0);
}
