// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// An arch of wedges that only friction and its own thrust hold; stones fall on its crown.
import {slider} from './slider.mjs';

const kDeep = 0.9, kFirstStone = 1.2, kBetween = 1;

// The corners of a wedge between two angles, about its middle.
function wedge(low, high, radius, thick) {
    const corners = [];
    for (const angle of [low, high]) for (const r of [radius, radius + thick]) for (const y of [-kDeep / 2, kDeep / 2])
        corners.push([r * Math.cos(angle), y, r * Math.sin(angle)]);
    const middle = [0, 1, 2].map(k => corners.reduce((sum, corner) => sum + corner[k], 0) / corners.length);
    return {middle, points: corners.flatMap(corner => corner.map((x, k) => x - middle[k]))};
}

export const arch = {
    title: 'Arch',
    about: 'Wedges without mortar carry each other, and the stones that fall on them. How thin can it be?',
    sliders: {stones: slider('Wedges', 7, 25, 2, 15), thick: slider('Thickness, m', 0.2, 0.9, 0.02, 0.46), friction: slider('Friction', 0.1, 1, 0.05, 0.7)},
    view: {center: [0, 0, 1.4], radius: 3.4, direction: [0.35, -0.9, 0.25]},
    rate: 120,
    build(kit, {stones, thick, friction}) {
        const radius = 2.1 - thick / 2, material = {friction};
        kit.floor();
        for (let i = 0; i < stones; ++i) {
            const {middle, points} = wedge(Math.PI * i / stones, Math.PI * (i + 1) / stones, radius, thick);
            kit.solid('convex', {points}, middle, {color: i % 2, density: 2000, material});
        }
        for (const side of [-1, 1]) kit.fixed('box', {lengths: [0.6, 1.6, 0.5]}, {position: [side * (radius + thick + 0.3), 0, 0.25]});
        let next = kFirstStone, fallen = 0;
        return {
            before_step(h, time, simulation) {
                if (time < next || fallen >= 12) return;
                next += kBetween, ++fallen;
                kit.solid('box', {lengths: [0.3, 0.3, 0.3]}, [kit.random.uniform(-0.3, 0.3), 0, radius + thick + 1.2], {color: 2 + fallen % 3, density: 900, material});
                return true;
            },
        };
    },
};
