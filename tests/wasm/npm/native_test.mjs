// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world goes from JavaScript to a native program and back: both make the same steps and have the same bits.
//   node native_test.mjs PROGRAM      (native.c, linked with the native library)
import {execFileSync} from 'node:child_process';
import {mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {load} from 'epode';

const engine = await load(), world = engine.createWorld(), folder = mkdtempSync(join(tmpdir(), 'epode-'));
const run = of => { for (let i = 0; i < 100; ++i) of.step(1 / 60); };
world.createGeom('plane', {normal: [0, 0, 1]});
const bodies = [['box', {lengths: [0.5, 0.4, 0.3]}], ['sphere', {radius: 0.25}], ['cylinder', {radius: 0.2, length: 0.5}], ['cone', {radius: 0.3, length: 0.5}]];
for (let i = 0; i < 40; ++i) {
    const body = world.createBody({position: [0.3 * (i % 3), 0.2 * (i % 2), 0.5 + 0.4 * i]}), [kind, size] = bodies[i % 4];
    body.createGeom(kind, {...size, material: {friction: 0.3 + 0.01 * i}});
}
world.createJoint('hinge', world.bodies[0], world.bodies[1], {anchor: [0, 0, 0.7], axis: [0, 1, 0]});
run(world);
const [file, states] = [join(folder, 'world.epw'), join(folder, 'state')];
writeFileSync(file, world.save());
execFileSync(process.argv[2], [file, states]);
run(world);
const native = readFileSync(states);
if (Buffer.compare(native, world.saveState()) !== 0) throw new Error('the native program has other bits');
const back = engine.loadWorld(new Uint8Array(readFileSync(file)));
run(back);
run(world);
if (Buffer.compare(back.saveState(), world.saveState()) !== 0) throw new Error('the world that came back has other bits');
world.loadState(new Uint8Array(native));
run(world);
if (Buffer.compare(back.saveState(), world.saveState()) !== 0) throw new Error('a native state goes on otherwise');
rmSync(folder, {recursive: true});
console.log(`${native.length} bytes of state: the same natively and in Node ${process.version}, there and back`);
