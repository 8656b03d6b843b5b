// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Figures of sixteen bones (dBonesMakeHuman) tumble down stairs.
import {slider} from './slider.mjs';

const kSteps = 8, kTread = 0.45, kRise = 0.22, kWidth = 7, kBones = 16;

function stairs(kit) {
    for (let i = 0; i < kSteps; ++i) {
        const height = (kSteps - i) * kRise;
        kit.fixed('box', {lengths: [kTread, kWidth, height]}, {position: [(i + 0.5) * kTread, 0, height / 2]});
    }
    kit.fixed('box', {lengths: [2.4, kWidth, kSteps * kRise]}, {position: [-1.2, 0, kSteps * kRise / 2]});
}

export const ragdolls = {
    title: 'Ragdolls',
    about: 'Figures with limits in every joint tumble down stairs. Strength lets their muscles hold the pose.',
    sliders: {count: slider('Figures', 1, 12, 1, 5), strength: slider('Strength of muscles', 0, 1, 0.05, 0), speed: slider('Speed at the start, m/s', 0, 5, 0.1, 2.2)},
    view: {center: [1.4, 0, 0.9], radius: 4.2, direction: [0.7, -0.7, 0.35]},
    build(kit, {count, strength, speed}) {
        const {c} = kit.engine, {world} = kit, bones = c.malloc(kBones * c.size_of('dBone')), limp = c.malloc(kBones * 32);
        c.dBonesMakeHuman(bones, kBones, 1.75, 75);
        kit.floor();
        stairs(kit);
        const figures = Array.from({length: count}, (_, i) => {
            const at = c.new_reals([-0.5 - 0.7 * (i % 2), (i - (count - 1) / 2) * Math.min(1, 6 / count), kSteps * kRise + 0.1, 0]);
            const turn = kit.random.uniform(-0.4, 0.4), facing = c.new_reals([Math.cos(turn / 2), 0, 0, Math.sin(turn / 2)]);
            const make = to => c.dRagdollCreate(world.handle, world.space, bones, kBones, at, facing, to);
            const bodies = kit.made_by_c(kBones, make, i % 6);
            c.free(at), c.free(facing);
            for (const body of bodies) body.linearVelocity = [speed, 0, 0];
            return c.new_ints(bodies.map(body => body.handle));
        });
        const hold = share => figures.forEach(handles => {
            c.dRagdollGetPose(bones, handles, kBones, limp);
            c.dRagdollSetPose(bones, handles, kBones, limp, share);
        });
        hold(strength);
        return {set: {strength: hold}, destroy: () => [bones, limp, ...figures].forEach(pointer => c.free(pointer))};
    },
};
