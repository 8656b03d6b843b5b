// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A robot of four legs trots: servos (drives) in its hips and knees follow the curves of its feet.
import {slider} from './slider.mjs';

const kThigh = 0.22, kShank = 0.22, kStand = 0.36, kLift = 0.08;
const kHips = [[0.3, 0.2], [0.3, -0.2], [-0.3, 0.2], [-0.3, -0.2]];

// Angles of hip and knee, about y, that bring a foot from straight below the hip to (x, -z) of it. Knees point back.
function angles_of(x, z) {
    const reach = Math.min(Math.hypot(x, z), 0.999 * (kThigh + kShank));
    const knee = Math.PI - Math.acos((kThigh ** 2 + kShank ** 2 - reach ** 2) / (2 * kThigh * kShank));
    const inner = Math.acos((kThigh ** 2 + reach ** 2 - kShank ** 2) / (2 * kThigh * reach));
    return {hip: Math.atan2(-x, z) + inner, knee: -knee};
}

function leg(kit, trunk, [x, y], z) {
    const limb = (length, top) => kit.solid('capsule', {radius: 0.03, length: length - 0.06}, [x, y, top - length / 2], {color: 2, mass: 0.4, material: {friction: 1}});
    const thigh = limb(kThigh, z), shank = limb(kShank, z - kThigh), hinge = (a, b, top) => kit.world.createJoint('hinge', a, b, {anchor: [x, y, top], axis: [0, 1, 0]});
    kit.part(shank, 'sphere', {radius: 0.04}, {color: 6, mass: 0.05, offsetPosition: [0, 0, -kShank / 2], material: {friction: 1}});
    return {hip: hinge(thigh, trunk, z), knee: hinge(shank, thigh, z - kThigh)};
}

export const quadruped = {
    title: 'Robot',
    about: 'A robot of four legs trots; each hip and knee is a servo that follows the curve of its foot.',
    sliders: {stride: slider('Stride, m', -0.16, 0.16, 0.01, 0.1), beat: slider('Strides a second', 0.5, 3, 0.1, 1.8), stiffness: slider('Stiffness of servos, N m/rad', 20, 400, 10, 200)},
    view: {center: [0, 0, 0.35], radius: 1.3, direction: [0.35, -0.9, 0.3]},
    rate: 240,
    build(kit, values) {
        const {beat, stiffness} = values, z = kThigh + kShank + 0.06;
        kit.floor();
        const trunk = kit.solid('box', {lengths: [0.75, 0.26, 0.14]}, [0, 0, z + 0.03], {color: 0, mass: 8});
        kit.part(trunk, 'box', {lengths: [0.14, 0.16, 0.12]}, {color: 6, mass: 0.4, offsetPosition: [0.44, 0, 0.06]});
        const legs = kHips.map(hip => leg(kit, trunk, hip, z));
        const drive = (joint, target) => joint.setDrive(0, {stiffness, damping: stiffness / 25, target, forceLimit: 60});
        let phase = 0;
        return {
            follow: trunk,
            set: {stride: value => { values.stride = value; }},
            before_step(h, time) {
                const share = Math.min(1, Math.max(0, time - 0.8)), drop = kThigh + kShank - (kThigh + kShank - kStand) * Math.min(1, 1.5 * time + 0.2);
                phase += share > 0 ? h * beat : 0;
                legs.forEach(({hip, knee}, i) => {
                    const turns = (phase + (i === 0 || i === 3 ? 0 : 0.5)) % 1, swings = turns >= 0.5, part = 2 * turns % 1;
                    const x = share * values.stride * (swings ? part - 0.5 : 0.5 - part), up = swings ? share * kLift * Math.sin(Math.PI * part) : 0;
                    const angles = angles_of(x - 0.02, drop - up);
                    drive(hip, angles.hip), drive(knee, angles.knee);
                });
            },
        };
    },
};
