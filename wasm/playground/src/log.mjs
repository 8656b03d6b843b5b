// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The last seconds of a run for its plots: energies (J) and the time that steps took (ms).
const kSpan = 10, kInterval = 1 / 20;  // s

export class Log {
    constructor() {
        this.times = [];
        this.kinetic = [];
        this.potential = [];
        this.cost = [];
        this.slowest = 0;
    }

    // After each step, of which kInterval of simulated time make a row, with the slowest step of them.
    add(simulation, cost) {
        this.slowest = Math.max(this.slowest, cost);
        if (this.times.length > 0 && simulation.time < this.times.at(-1) + kInterval) return;
        const {kinetic, potential} = simulation.energy(), all = [this.times, this.kinetic, this.potential, this.cost];
        [simulation.time, kinetic, potential, this.slowest].forEach((value, i) => all[i].push(value));
        if (this.times.length > kSpan / kInterval) all.forEach(values => values.shift());
        this.slowest = 0;
    }
}
