// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A brick wall in stretcher bond, which a ball hits.
import {slider} from './slider.mjs';

const [kDeep, kLong, kHigh] = [0.3, 0.6, 0.3], kFirstShot = 0.7;

export const wall = {
    title: 'Wall',
    about: 'Bricks without mortar. A ball hits them; throw more.',
    sliders: {courses: slider('Courses', 3, 18, 1, 10), bricks: slider('Bricks in a course', 4, 20, 1, 12), friction: slider('Friction', 0, 1.2, 0.05, 0.6)},
    view: {center: [0, 0, 1.2], radius: 4.5, direction: [0.8, -0.6, 0.32]},
    build(kit, {courses, bricks, friction}) {
        const material = {friction};
        kit.floor();
        for (let row = 0; row < courses; ++row) {
            for (let i = 0; i < bricks; ++i) {
                const y = (i + (row % 2 ? 0.5 : 0) - bricks / 2) * kLong;
                kit.solid('box', {lengths: [kDeep, 0.995 * kLong, kHigh]}, [0, y, (row + 0.5) * kHigh], {color: kit.random.uniform(0, 1) < 0.6 ? 0 : 1, density: 800, material});
            }
        }
        let shot = false;
        return {
            before_step(h, time, simulation) {
                if (shot || time < kFirstShot) return;
                shot = true;
                simulation.throw_ball([7, -1.5, 1.4], [-17, 3, 2]);
            },
        };
    },
};
