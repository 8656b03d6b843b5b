// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A buggy drives in a circle over hills. The arrow keys drive it, too.
import {slider} from './slider.mjs';

const kRadius = 0.45, kSide = 120, kCircle = 16;
const kHubs = [[1.15, 0.8], [1.15, -0.8], [-1.15, 0.8], [-1.15, -0.8]];

const hills = roughness => (x, y) => roughness *
    (0.55 * Math.sin(0.31 * x) * Math.cos(0.27 * y) + 0.28 * Math.sin(0.9 * x + 0.4) * Math.sin(0.8 * y) + 0.004 * Math.max(0, Math.hypot(x, y) - 30) ** 2);

// Left of the way to the circle about the origin, -1 ... 1.
function steer_of(chassis) {
    const [x, y] = chassis.position, [fx, fy] = chassis.vectorToWorld([1, 0, 0]), away = Math.hypot(x, y) - kCircle;
    const angle = Math.atan2(x, -y) + Math.max(-1, Math.min(1, 0.25 * away)), turn = angle - Math.atan2(fy, fx);
    return Math.max(-1, Math.min(1, 1.6 * Math.atan2(Math.sin(turn), Math.cos(turn)) + 0.25));
}

function wheel_pose(chassis, buggy, number) {
    const {hub, steer, angle} = buggy.getWheelReport(number), upright = [Math.SQRT1_2, Math.SQRT1_2, 0, 0];
    const about = (axis, by) => [Math.cos(by / 2), ...axis.map(part => part * Math.sin(by / 2))];
    return [hub, [about([0, 0, 1], steer), about([0, 1, 0], angle), upright].reduce(product, chassis.quaternion)];
}

const product = ([a, b, c, d], [e, f, g, h]) =>
    [a * e - b * f - c * g - d * h, a * f + b * e + c * h - d * g, a * g - b * h + c * e + d * f, a * h + b * g - c * f + d * e];

export const buggy = {
    title: 'Buggy',
    about: 'A car with suspension, tyres, engine and gears drives over hills in a circle. Drive it with the arrow keys.',
    sliders: {throttle: slider('Throttle', 0, 1, 0.05, 0.45), roughness: slider('Hills', 0, 2, 0.1, 1), grip: slider('Grip of the tyres', 0.2, 1.6, 0.05, 1.1)},
    view: {center: [kCircle, 0, 1], radius: 5, direction: [0.6, -0.85, 0.45]},
    build(kit, {throttle, roughness, grip}) {
        const height = hills(roughness), start = [kCircle, 0, height(kCircle, 0) + 1.2];
        kit.terrain(kSide, 60, height);
        for (let i = 0; i < 10; ++i) {
            const angle = 0.6 * i + 0.7, [x, y] = [kCircle * Math.cos(angle), kCircle * Math.sin(angle)];
            kit.solid('box', {lengths: [0.5, 0.5, 0.5]}, [x, y, height(x, y) + 0.6], {color: i % 2, density: 120});
        }
        const chassis = kit.solid('box', {lengths: [2.9, 1.1, 0.4]}, start, {color: 0, mass: 700, quaternion: [Math.SQRT1_2, 0, 0, Math.SQRT1_2]});
        kit.part(chassis, 'box', {lengths: [1, 0.95, 0.45]}, {color: 6, mass: 40, offsetPosition: [-0.35, 0, 0.4]});
        const buggy = chassis.makeVehicle({differential: 'limited'});
        kHubs.forEach(([x, y], i) => {
            buggy.addWheel({cast: 'sphere', position: [x, y, -0.1], radius: kRadius, axle: x > 0 ? 0 : 1, steer: x > 0 ? 1 : 0, drive: 1,
                            frictionX: grip, frictionY: grip, nominalLoad: 1900, stiffness: 22000, bumpDamping: 1800, reboundDamping: 2200});
            kit.picture('cylinder', {radius: kRadius, length: 0.3}, 6, () => wheel_pose(chassis, buggy, i));
        });
        return {
            follow: chassis,
            driven: true,
            set: {throttle: value => { throttle = value; }},
            before_step(h, time, {keys}) {
                buggy.controls = keys?.any ? {throttle: keys.up, brake: keys.down, steer: keys.left - keys.right}
                    : {throttle: buggy.report.speed < 14 * throttle ? throttle : 0, brake: 0, steer: steer_of(chassis)};
                buggy.update(h);
            },
        };
    },
};
