// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Random numbers that are the same in every run: a linear congruential generator of 32 bits (multiplier and increment of Numerical
// Recipes), of which the upper 24 bits count.
export class Lcg {
    constructor(seed) { this.state = seed >>> 0; }

    // From low up to high.
    uniform(low, high) {
        this.state = Math.imul(this.state, 1664525) + 1013904223 >>> 0;
        return low + (high - low) * (this.state >>> 8) / 2 ** 24;
    }
}
