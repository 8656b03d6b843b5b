// A ball bounces and comes to rest.
import {load} from 'epode';

const engine = await load();
const world = engine.createWorld();
world.createGeom('plane', {normal: [0, 0, 1]});
const ball = world.createBody({position: [0, 0, 3]});
ball.createGeom('sphere', {radius: 0.5, material: {bounce: 0.8}});

for (let second = 0; second < 4; ++second) {
    for (let i = 0; i < 60; ++i) world.step(1 / 60);
    console.log(`${second + 1} s: ${ball.position[2].toFixed(3)} m, ${world.contacts.length} contacts`);
}
