// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A heavy ball on a chain of light links swings into a stack of crates.
import {slider} from './slider.mjs';

const kLinks = 14, kLength = 4.6, kHigh = 6, kSide = 0.6;

function crates(kit, rows) {
    for (let row = 0; row < rows; ++row) for (let i = 0; i < 3; ++i) for (let k = 0; k < 3; ++k)
        kit.solid('box', {lengths: [kSide, kSide, kSide]}, [2.2 + i * kSide, (k - 1) * kSide * 1.01, (row + 0.5) * kSide], {color: (row + i + k) % 2, density: 250});
}

export const wrecker = {
    title: 'Wrecking ball',
    about: 'A ball on a chain, thousands of times as heavy as a link, swings into crates.',
    sliders: {mass: slider('Ball, kg', 50, 8000, 50, 2000), rows: slider('Rows of crates', 2, 9, 1, 6), lift: slider('Raised by, degrees', 20, 90, 5, 65)},
    view: {center: [0.4, 0, 2.6], radius: 5.2, direction: [0.3, -0.9, 0.22]},
    build(kit, {mass, rows, lift}) {
        const {c} = kit.engine, {world} = kit, angle = lift * Math.PI / 180, along = r => [0.6 - r * Math.sin(angle), 0, kHigh - r * Math.cos(angle)];
        kit.floor();
        kit.fixed('box', {lengths: [0.4, 0.4, 0.4]}, {position: [0.6, 0, kHigh + 0.2], color: 6});
        const ball = kit.solid('sphere', {radius: 0.5}, along(kLength + 0.5), {color: 6, mass}), links = c.create('dRopeSettings', {links: kLinks, mass: 0.5 * kLinks, radius: 0.05});
        const from = c.new_reals([...along(0), 0]), to = c.new_reals([...along(kLength), 0]);
        kit.made_by_c(kLinks, bodies => c.dRopeCreate(world.handle, world.space, from, to, 0, ball.handle, links.pointer, bodies, 0), 7);
        [from, to, links.pointer].forEach(pointer => c.free(pointer));
        crates(kit, rows);
    },
};
