// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A drum turns and tumbles what is in it.
import {slider} from './slider.mjs';

const kPlates = 18, kRadius = 2.4, kDeep = 1.6, kHigh = 2.7;

function walls(kit, drum) {
    const wide = 2 * (kRadius + 0.1) * Math.tan(Math.PI / kPlates) + 0.02;
    for (let i = 0; i < kPlates; ++i) {
        const angle = 2 * Math.PI * i / kPlates, place = r => [r * Math.cos(angle), 0, r * Math.sin(angle)], offsetQuaternion = [Math.cos(angle / 2), 0, -Math.sin(angle / 2), 0];
        kit.part(drum, 'box', {lengths: [0.2, kDeep, wide]}, {color: i % 2 ? 7 : 2, offsetPosition: place(kRadius), offsetQuaternion});
        if (i % 6 === 0) kit.part(drum, 'box', {lengths: [0.5, kDeep, 0.1]}, {color: 0, offsetPosition: place(kRadius - 0.3), offsetQuaternion});
    }
    for (const side of [-1, 1])  // of glass
        kit.fixed('box', {lengths: [2 * kRadius, 0.2, 2 * kRadius]}, {position: [0, side * (kDeep / 2 + 0.1), kHigh], color: null});
}

export const drum = {
    title: 'Drum',
    about: 'A drum tumbles balls, boxes and capsules without end.',
    sliders: {count: slider('Solids', 20, 250, 10, 120), speed: slider('Turns a minute', -40, 40, 1, 12), friction: slider('Friction', 0, 1.2, 0.05, 0.6)},
    view: {center: [0, 0, 2.6], radius: 3.3, direction: [0.25, -0.95, 0.2]},
    build(kit, {count, speed, friction}) {
        const drum = kit.world.createBody({position: [0, 0, kHigh], kinematic: true}), material = {friction};
        const turn = turns => { drum.angularVelocity = [0, -turns * Math.PI / 30, 0]; };
        kit.floor();
        walls(kit, drum);
        turn(speed);
        for (let i = 0; i < count; ++i) {
            const at = [0.4 * (i % 9 - 4), 0.38 * (Math.floor(i / 9) % 4 - 1.5), kHigh - 1.3 + 0.36 * Math.floor(i / 36)];
            const [kind, sizes] = [['box', {lengths: [0.32, 0.32, 0.32]}], ['sphere', {radius: 0.17}], ['capsule', {radius: 0.12, length: 0.2}]][i % 3];
            kit.solid(kind, sizes, at, {color: i % 6, density: 700, material});
        }
        return {set: {speed: turn}};
    },
};
