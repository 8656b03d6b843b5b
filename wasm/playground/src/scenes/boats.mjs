// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Boats, crates and barrels in waves (ode/fluid.h).
import {slider} from './slider.mjs';

const kDepth = 4, kSide = 40;

// Two trains of waves, of 9 and 5 m.
const sea = waves => (x, y, time) => waves * (0.3 * Math.sin(0.7 * x - 2.6 * time) + 0.14 * Math.sin(1.2 * (0.5 * x + 0.87 * y) - 3.4 * time));

function boat(kit, position, color) {
    const body = kit.solid('box', {lengths: [2.6, 1, 0.45]}, position, {color, density: 330});
    kit.part(body, 'box', {lengths: [0.8, 0.7, 0.5]}, {color: 7, density: 150, offsetPosition: [-0.5, 0, 0.48]});
    kit.part(body, 'cylinder', {radius: 0.04, length: 1.8}, {color: 6, density: 300, offsetPosition: [0.5, 0, 1.1]});
}

function cargo(kit, i) {
    const angle = 2.4 * i, away = 1.5 + 0.35 * Math.sqrt(i) * 1.6, at = [away * Math.cos(angle), away * Math.sin(angle), 1 + 0.15 * i], density = kit.random.uniform(200, 800);
    const [kind, sizes] = [['box', {lengths: [0.6, 0.5, 0.5]}], ['cylinder', {radius: 0.28, length: 0.7}], ['sphere', {radius: 0.35}]][i % 3];
    kit.solid(kind, sizes, at, {color: 1 + i % 5, density});
}

export const boats = {
    title: 'Boats',
    about: 'Boats and their lost cargo float in waves, each as its shape and weight let it.',
    sliders: {waves: slider('Waves', 0, 2, 0.1, 1), cargo: slider('Crates, barrels and balls', 0, 60, 1, 24), density: slider('Density of the water, kg/m³', 300, 1400, 50, 1000)},
    view: {center: [0, 0, 0], radius: 5.5, direction: [0.5, -0.8, 0.36]},
    build(kit, values) {
        const {c} = kit.engine, {world} = kit, fluid = c.dFluidCreate(world.handle), at = pointer => c.reals(pointer, 2);
        kit.fixed('plane', {normal: [0, 0, 1], distance: -kDepth}, {color: 2});
        const height = (x, y, time) => sea(values.waves)(x, y, time);
        const surface = c.callback('iid:d', (_, place, time) => height(...at(place), time));
        const settings = c.create('dFluidSettings'), thicken = density => {
            settings.density = density;
            c.dFluidSetSettings(fluid, settings.pointer);
        };
        thicken(values.density);
        c.dFluidSetSurface(fluid, surface, 0);
        boat(kit, [-3, -2.6, 0.2], 0), boat(kit, [2.6, 2.8, 0.2], 2), boat(kit, [3, -2.4, 0.2], 5);
        for (let i = 0; i < values.cargo; ++i) cargo(kit, i);
        return {
            water: {height, side: kSide},
            set: {waves: value => { values.waves = value; }, density: thicken},
            destroy() {
                c.dFluidDestroy(fluid);
                c.free_callback(surface);
                c.free(settings.pointer);
            },
        };
    },
};
