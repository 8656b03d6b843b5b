// A buggy drives over a ramp; the wheels are where a page would draw them.
import {load} from 'epode';

const engine = await load();
const world = engine.createWorld();
world.createGeom('plane', {normal: [0, 0, 1]});
world.createGeom('box', {lengths: [6, 4, 0.2], position: [20, 0, 0.4], quaternion: [Math.cos(0.08), 0, -Math.sin(0.08), 0]});
const chassis = world.createBody({position: [0, 0, 0.7]});
chassis.createGeom('box', {lengths: [2.6, 1.2, 0.4], mass: 800});
const buggy = chassis.makeVehicle();
for (const [x, y] of [[1, 0.7], [1, -0.7], [-1, 0.7], [-1, -0.7]])
    buggy.addWheel({cast: 'sphere', position: [x, y, -0.1], axle: x > 0 ? 0 : 1, steer: x > 0 ? 1 : 0, drive: 1});

buggy.controls = {throttle: 0.7};
let top = 0;
for (let i = 0; i < 360; ++i) {
    buggy.update(1 / 60);
    world.step(1 / 60);
    top = Math.max(top, chassis.position[2]);
}
const {speed, gear} = buggy.report, [x, y, z] = buggy.getWheelReport(0).hub;
console.log(`${speed.toFixed(1)} m/s in gear ${gear}, ${top.toFixed(2)} m at the highest, front wheel at ${[x, y, z].map(v => v.toFixed(1)).join(' ')}`);
