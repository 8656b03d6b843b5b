// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Solids of four kinds fall and make a pile.
import {slider} from './slider.mjs';

const kKinds = [
    ['box', {lengths: [0.5, 0.4, 0.3]}], ['sphere', {radius: 0.25}], ['capsule', {radius: 0.15, length: 0.35}],
    ['cylinder', {radius: 0.22, length: 0.4}],
];
const kAcross = 5;

export const pile = {
    title: 'Pile',
    about: 'Boxes, balls, capsules and cylinders fall and come to rest.',
    sliders: {count: slider('Solids', 20, 600, 10, 200), bounce: slider('Bounce', 0, 0.9, 0.05, 0), friction: slider('Friction', 0, 1.2, 0.05, 0.6)},
    view: {center: [0, 0, 1.2], radius: 4.2},
    build(kit, {count, bounce, friction}) {
        const material = {bounce, friction, rollingFriction: 0.01};
        kit.floor();
        for (let i = 0; i < count; ++i) {
            const layer = Math.floor(i / kAcross ** 2), place = j => 0.6 * (j % kAcross - 2) + kit.random.uniform(-0.05, 0.05);
            const [kind, sizes] = kKinds[i % 4];
            kit.solid(kind, sizes, [place(i), place(Math.floor(i / kAcross)), 0.5 + 0.6 * layer], {color: i % 6, density: 700, material});
        }
    },
};
