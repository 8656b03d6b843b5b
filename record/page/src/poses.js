// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where every carrier is at a time: between two moments positions go straight and quaternions the short way
// (normalized linear interpolation: the angle between two moments is small).

export class Poses {
    constructor(recording) {
        this.recording = recording;
        this.values = new Float32Array(7 * recording.carriers.count);  // position, quaternion w x y z
        this.alive = new Uint8Array(recording.carriers.count).fill(1);
        this.lives = recording.carriers.lives;  // [carrier, moment, alive, moment, alive ...]
        this.moment = 0;
    }

    // The last moment at or before the time.
    find(time) {
        const times = this.recording.times;
        let low = 0, high = times.length - 1;
        while (low < high) {
            const middle = (low + high + 1) >> 1;
            if (times[middle] <= time) low = middle; else high = middle - 1;
        }
        return low;
    }

    go_to(time) {
        const {times, carriers} = this.recording;
        const at = this.find(time), next = Math.min(at + 1, times.length - 1);
        const part = next > at ? Math.min(1, Math.max(0, (time - times[at]) / (times[next] - times[at]))) : 0;
        this.moment = part > 0.5 ? next : at;
        for (let i = 0; i < carriers.count; ++i) this.place(i, at, next, part);
        for (const life of this.lives) {
            let alive = 1;
            for (let k = 1; k < life.length && life[k] <= at; k += 2) alive = life[k + 1];
            this.alive[life[0]] = alive;
        }
    }

    place(carrier, at, next, part) {
        const {numbers, frames, positions, turns} = this.recording.carriers;
        const first = numbers[4 * carrier + 1], count = numbers[4 * carrier + 2], start = numbers[4 * carrier + 3];
        const key = moment => start + Math.min(Math.max(moment - first, 0), count - 1);
        const a = key(at), b = key(next), out = 7 * carrier;
        for (let i = 0; i < 3; ++i) {
            const low = frames[6 * carrier + i], extent = frames[6 * carrier + 3 + i];
            const value = (1 - part) * positions[3 * a + i] + part * positions[3 * b + i];
            this.values[out + i] = low + extent * value / 65535;
        }
        let dot = 0, sum = 0;
        for (let i = 0; i < 4; ++i) dot += turns[4 * a + i] * turns[4 * b + i];
        const side = dot < 0 ? -part : part;
        for (let i = 0; i < 4; ++i) {
            const value = (1 - part) * turns[4 * a + i] + side * turns[4 * b + i];
            this.values[out + 3 + i] = value;
            sum += value * value;
        }
        const scale = sum > 0 ? 1 / Math.sqrt(sum) : 0;
        for (let i = 0; i < 4; ++i) this.values[out + 3 + i] *= scale;
    }

    // A point of a carrier's frame in the world; carrier -1 is the world.
    point(carrier, x, y, z, out) {
        if (carrier < 0) return out.set(x, y, z);
        const [px, py, pz, w, qx, qy, qz] = this.values.subarray(7 * carrier, 7 * carrier + 7);
        const tx = 2 * (qy * z - qz * y), ty = 2 * (qz * x - qx * z), tz = 2 * (qx * y - qy * x);
        return out.set(px + x + w * tx + qy * tz - qz * ty, py + y + w * ty + qz * tx - qx * tz,
                       pz + z + w * tz + qx * ty - qy * tx);
    }
}
