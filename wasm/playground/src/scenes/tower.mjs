// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A round tower that stands as one body of bricks; cannon balls break out what they hit (ode/fracture.h).
import {slider} from './slider.mjs';

const kAround = 14, kRadius = 1.3, kThick = 0.3, kHigh = 0.35, kBetween = 1.4;

function bricks(kit, courses) {
    const wide = 2 * (kRadius - kThick / 2) * Math.tan(Math.PI / kAround), found = [];
    for (let row = 0; row < courses; ++row) {
        for (let i = 0; i < kAround; ++i) {
            const angle = 2 * Math.PI * (i + row % 2 / 2) / kAround;
            found.push(kit.fixed('box', {lengths: [kThick, wide, kHigh]}, {
                color: (i + row) % 2, position: [kRadius * Math.cos(angle), kRadius * Math.sin(angle), (row + 0.5) * kHigh],
                quaternion: [Math.cos(angle / 2), 0, 0, Math.sin(angle / 2)],
            }));
        }
    }
    return found;
}

// The list of parts and the fracture, in C's memory.
function fracture_of(kit, geoms, strength, radius) {
    const {c} = kit.engine, size = c.size_of('dFracturePart'), parts = c.malloc(size * geoms.length);
    geoms.forEach((geom, i) => c.at(parts + size * i, 'dFracturePart').set({geom: geom.handle, density: 1800}));
    return c.create('dFracture', {parts, count: geoms.length, strength, radius});
}

export const tower = {
    title: 'Tower',
    about: 'A tower of one piece, until cannon balls break out of it what they hit.',
    sliders: {courses: slider('Courses', 4, 20, 1, 12), strength: slider('Strength, N s', 50, 5000, 50, 1500), speed: slider('Speed of the balls, m/s', 5, 40, 1, 20)},
    view: {center: [0, 0, 1.9], radius: 5, direction: [0.55, -0.8, 0.3]},
    build(kit, {courses, strength, speed}) {
        const {c} = kit.engine, {world} = kit;
        kit.floor();
        const geoms = bricks(kit, courses), fracture = fracture_of(kit, geoms, strength, 0.55);
        c.dFractureCreate(world.handle, fracture.parts, geoms.length);
        world.refresh();
        let next = 0.6, shots = 0;
        return {
            set: {strength: value => { fracture.strength = value; }, speed: value => { speed = value; }},
            destroy: () => [fracture.parts, fracture.pointer].forEach(pointer => c.free(pointer)),
            before_step(h, time, simulation) {
                if (time >= next && shots < 8) {
                    next += kBetween, ++shots;
                    simulation.throw_ball([-9, kit.random.uniform(-3, 1), 1], [speed, kit.random.uniform(-0.5, 1.5), kit.random.uniform(1.2, 5)]);
                }
                return c.dFractureUpdate(world.handle, fracture.pointer, 1) > 0;
            },
        };
    },
};
