// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A bridge of planks on hinges (ode/rope.h), and what falls on it.
import {slider} from './slider.mjs';

const kSpan = 9, kHigh = 3.2;

export const bridge = {
    title: 'Bridge',
    about: 'Planks on hinges sag under what falls on them; the hinges stay closed.',
    sliders: {planks: slider('Planks', 8, 36, 1, 18), load: slider('Crates', 0, 60, 1, 24), weight: slider('Density of the crates, kg/m³', 50, 4000, 50, 300)},
    view: {center: [0, 0, 2.2], radius: 5, direction: [0.35, -0.9, 0.3]},
    build(kit, {planks, load, weight}) {
        const {c} = kit.engine, {world} = kit;
        kit.floor();
        for (const side of [-1, 1]) kit.fixed('box', {lengths: [1.6, 2.4, kHigh]}, {position: [side * (kSpan / 2 + 0.85), 0, kHigh / 2]});
        const from = c.new_reals([-kSpan / 2, 0, kHigh, 0]), to = c.new_reals([kSpan / 2, 0, kHigh, 0]);
        const rope = c.create('dRopeSettings', {links: planks, length: 1.04 * kSpan, mass: 320, radius: 0.05, width: 1.8});
        kit.made_by_c(planks, bodies => c.dRopeCreate(world.handle, world.space, from, to, 0, 0, rope.pointer, bodies, 0), 1);
        [from, to, rope.pointer].forEach(pointer => c.free(pointer));
        for (let i = 0; i < load; ++i) {
            const at = [-2.6 + 0.75 * (i % 8) + kit.random.uniform(-0.1, 0.1), 0.5 * (Math.floor(i / 8) % 3 - 1), kHigh + 1.2 + 0.7 * Math.floor(i / 8)];
            const [kind, sizes] = i % 3 ? ['box', {lengths: [0.4, 0.4, 0.4]}] : ['cylinder', {radius: 0.22, length: 0.45}];
            kit.solid(kind, sizes, at, {color: 2 + i % 4, density: weight});
        }
    },
};
