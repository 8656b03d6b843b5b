// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Spinning tops, which precess and in the end fall.
import {slider} from './slider.mjs';

const kCount = 6, kHigh = 0.3, kTip = 0.03;  // m: the disc above the middle of the round tip, and its radius

export const tops = {
    title: 'Tops',
    about: 'Tops precess as long as they spin.',
    sliders: {spin: slider('Spin, rad/s', 0, 120, 5, 60), lean: slider('Lean, degrees', 0, 40, 1, 15), friction: slider('Friction', 0, 1, 0.05, 0.3)},
    view: {center: [0, 0, 0.4], radius: 2.6, direction: [0.4, -0.8, 0.4]},
    rate: 240,
    build(kit, {spin, lean, friction}) {
        const angle = lean * Math.PI / 180, material = {friction};
        kit.floor();
        for (let i = 0; i < kCount; ++i) {
            const axis = [Math.sin(angle), 0, Math.cos(angle)], quaternion = [Math.cos(angle / 2), 0, Math.sin(angle / 2), 0];
            const tip = [1.3 * (i % 3 - 1), 1.4 * Math.floor(i / 3) - 0.7, kTip], position = tip.map((x, k) => x + kHigh * axis[k]);
            const top = kit.solid('cylinder', {radius: 0.34, length: 0.1}, position, {color: i, density: 1500, quaternion, material});
            kit.part(top, 'capsule', {radius: kTip, length: 2 * kHigh}, {color: 6, density: 600, material});
            top.angularVelocity = axis.map(x => x * spin);
            top.maxAngularSpeed = 1000;
        }
    },
};
