// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Balls swing on ropes of light links (ode/rope.h) through a row of posts.
import {slider} from './slider.mjs';

const kLength = 3.4, kHigh = 4.2, kLinkMass = 0.05;

export const ropes = {
    title: 'Ropes',
    about: 'Each ball weighs hundreds of times as much as a link of its rope, and the ropes do not give.',
    sliders: {count: slider('Ropes', 1, 8, 1, 5), links: slider('Links', 5, 50, 1, 24), ratio: slider('Ball to link, masses', 10, 2000, 10, 400)},
    view: {center: [0, 0, 2.2], radius: 4, direction: [0.55, -0.8, 0.25]},
    build(kit, {count, links, ratio}) {
        const {c} = kit.engine, {world} = kit, rope = c.create('dRopeSettings', {links, mass: kLinkMass * links, radius: 0.025});
        kit.floor();
        kit.fixed('box', {lengths: [0.2, 1 + count, 0.2]}, {position: [0, 0, kHigh + 0.1], color: 6});
        for (let i = 0; i < count; ++i) {
            const angle = 0.9 - 0.12 * i, y = i - (count - 1) / 2, end = [-kLength * Math.sin(angle), y, kHigh - kLength * Math.cos(angle)];
            const mass = ratio * kLinkMass, ball = kit.solid('sphere', {radius: 0.28}, end.map((x, k) => x - 0.28 * [Math.sin(angle), 0, Math.cos(angle)][k]), {color: i % 6, mass});
            const from = c.new_reals([0, y, kHigh, 0]), to = c.new_reals([...end, 0]);
            kit.made_by_c(links, bodies => c.dRopeCreate(world.handle, world.space, from, to, 0, ball.handle, rope.pointer, bodies, 0), 7);
            c.free(from), c.free(to);
        }
        for (let i = 0; i < 6; ++i) for (let row = 0; row < 3; ++row)
            kit.solid('box', {lengths: [0.35, 0.35, 0.35]}, [1.7 + 0.4 * (i % 2), (i - 2.5) * 0.8, 0.175 + 0.351 * row], {color: (i + row) % 2, density: 150});
        c.free(rope.pointer);
    },
};
