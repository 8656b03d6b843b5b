// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Dominoes along a spiral; the first one is pushed.
import {slider} from './slider.mjs';

const [kThick, kWide, kTall] = [0.1, 0.5, 1], kInner = 1.4;

export const dominoes = {
    title: 'Dominoes',
    about: 'A spiral of dominoes; the first one falls.',
    sliders: {count: slider('Dominoes', 20, 400, 10, 160), gap: slider('From one to the next, m', 0.2, 0.8, 0.02, 0.42), friction: slider('Friction', 0.05, 1, 0.05, 0.4)},
    view: {center: [0, 0, 0.2], radius: 6, direction: [0.45, -0.7, 0.6]},
    build(kit, {count, gap, friction}) {
        let angle = 0;
        kit.floor();
        for (let i = 0; i < count; ++i) {
            const away = kInner + 0.75 * angle / (2 * Math.PI) * 1.4, way = angle + Math.PI / 2 + Math.atan(0.17 / away);
            const domino = kit.solid('box', {lengths: [kThick, kWide, kTall]}, [away * Math.cos(angle), away * Math.sin(angle), kTall / 2], {
                color: i % 6, density: 600, material: {friction}, quaternion: [Math.cos(way / 2), 0, 0, Math.sin(way / 2)],
            });
            if (i === 0) domino.angularVelocity = [-1.6 * Math.sin(way), 1.6 * Math.cos(way), 0];
            angle += gap / away;
        }
    },
};
