// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How much work a picture may be, so that a recording plays where a processor draws, too. While pictures follow one another too slowly, they
// become coarser step by step; a picture that stands still is fine.

// Pixels of the canvas a pixel of the page; side of the sun's map, 0: no shadows; whether shadows have soft edges.
export const kLevels = [
    {ratio: 2, map: 2048, soft: true},
    {ratio: 1, map: 1024, soft: false},
    {ratio: 0.7, map: 512, soft: false},
    {ratio: 0.5, map: 0, soft: false},
];

const kSlow = 1000 / 18, kFarTooSlow = 150;  // ms between pictures
const kSettle = 2, kCounted = 4;             // pictures after a change: those that make programs and maps, those that count

export class Pace {
    constructor(level) {
        this.level = level;
        this.start_again();
    }

    start_again() { this.intervals = []; }

    // The time from one picture to the next while playing. True: the level has changed.
    add(interval) {
        this.intervals.push(interval);
        if (this.intervals.length < kSettle + kCounted) return false;
        const typical = this.intervals.splice(0).slice(kSettle).sort((a, b) => a - b)[kCounted >> 1];
        const before = this.level;
        if (typical > kSlow) this.level = Math.min(kLevels.length - 1, before + (typical > kFarTooSlow ? 2 : 1));
        return this.level !== before;
    }
}

// Whether WebGL says that a processor draws.
export function draws_in_software() {
    const gl = document.createElement('canvas').getContext('webgl2');
    if (!gl) return false;
    const named = gl.getExtension('WEBGL_debug_renderer_info');
    const name = String(gl.getParameter(named ? named.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
    gl.getExtension('WEBGL_lose_context')?.loseContext();
    return /swiftshader|llvmpipe|softpipe|software|basic render/i.test(name);
}
