// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Newton's cradle. The balls hang 2 mm apart: contacts of one step are solved together, and a row of touching balls would share the
// impulse; apart, the blow goes down the row ball by ball.
import {slider} from './slider.mjs';

const kRadius = 0.2, kGap = 0.002, kLength = 1.6, kHigh = 2.2;

export const cradle = {
    title: 'Cradle',
    about: "Newton's cradle: as many balls leave as arrive.",
    sliders: {balls: slider('Balls', 2, 9, 1, 5), raised: slider('Raised', 1, 4, 1, 1), bounce: slider('Restitution', 0, 1, 0.01, 1)},
    view: {center: [0, 0, 1.3], radius: 2.1, direction: [0.25, -0.95, 0.2]},
    rate: 960,
    build(kit, {balls, raised, bounce}) {
        const material = {bounce, bounceSpeed: 0, friction: 0};
        kit.floor();
        kit.fixed('box', {lengths: [0.5 * balls + 0.4, 0.12, 0.08]}, {position: [0, 0, kHigh + 0.04], color: 6});
        for (let i = 0; i < balls; ++i) {
            const x = (i - (balls - 1) / 2) * (2 * kRadius + kGap), lift = i < raised ? 0.7 : 0;
            const at = [x - kLength * Math.sin(lift), 0, kHigh - kLength * Math.cos(lift)];
            const ball = kit.solid('sphere', {radius: kRadius}, at, {color: 2, density: 7800, material, quaternion: [Math.cos(lift / 2), 0, Math.sin(lift / 2), 0], autoDisable: false});
            ball.linearDamping = ball.angularDamping = 0;
            kit.world.createJoint('hinge', ball, null, {anchor: [x, 0, kHigh], axis: [0, 1, 0]});
            kit.picture('cylinder', {radius: 0.012, length: kLength - kRadius}, 6,
                        () => [ball.getRelPointPosition([0, 0, (kLength + kRadius) / 2]), ball.quaternion]);
        }
    },
};
