// What a game over a network does: a late input arrives, six steps are taken back and made again with it.
import {load} from 'epode';

const engine = await load();
const world = engine.createWorld();
world.createGeom('plane', {normal: [0, 0, 1]});
const crates = Array.from({length: 20}, (_, i) => {
    const crate = world.createBody({position: [0, 0, 0.5 + i]});
    crate.createGeom('box', {lengths: [1, 1, 1], density: 200});
    return crate;
});
world.history = 30;
for (let i = 0; i < 60; ++i) world.step(1 / 60);

const began = performance.now();
world.rollBack(6);
crates[19].applyImpulse([400, 0, 0], null);
for (let i = 0; i < 6; ++i) world.step(1 / 60);
console.log(`six steps again in ${(performance.now() - began).toFixed(1)} ms; the top crate moves at ${crates[19].linearVelocity[0].toFixed(2)} m/s`);
