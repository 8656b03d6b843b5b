// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The playground in Debian's chromium without a screen, drawn by a processor: every scene runs for three seconds of its own, wide and
// narrow, complains of nothing and draws; controls, keys, pointer and links do what they say; axe-core finds no serious fault; and the pile
// steps to the same bits in the browser as in this Node.
//     EPODE_NPM=build/npm EPODE_WEB=build/wasm/web EPODE_PACKAGE=build/wasm/npm node browser_test.mjs [FOLDER for pictures]
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {createServer} from 'node:http';
import path from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {scenes} from '../../wasm/playground/src/scenes/all.mjs';
import {Simulation} from '../../wasm/playground/src/simulation.mjs';
import {browser, complaints, judge, kPatience, kSizes, overflow, shot, watched_page} from './browser.mjs';

const {EPODE_WEB, EPODE_PACKAGE} = process.env, html = path.resolve(EPODE_WEB, 'index.html'), kSeconds = 3;

const server = createServer(async (request, response) => {
    const found = request.url === '/' ? await readFile(html) : null;
    response.writeHead(found ? 200 : 404, {'content-type': 'text/html'}).end(found);
});
await new Promise(resolve => server.listen(0, resolve));
const origin = `http://localhost:${server.address().port}/`;

async function open(viewport, address = origin, options = {}) {
    const page = await watched_page(viewport, options);
    await page.goto(address);
    await page.waitForFunction(() => window.playground, undefined, {timeout: kPatience});
    return page;
}
const simulated = (page, seconds) => page.waitForFunction(wanted => window.playground.simulation.time > wanted, seconds, {timeout: kPatience});

async function every_scene(size) {
    const page = await open(kSizes[size]), rates = {};
    for (const scene of Object.keys(scenes)) {
        await page.click(`#scene-${scene}`);
        await page.waitForFunction(wanted => window.playground.simulation.scene === wanted, scene);
        await simulated(page, kSeconds);
        const state = await page.evaluate(() => {
            const {simulation, interval} = window.playground, {kinetic, potential} = simulation.energy(), poses = Array.from(simulation.poses());
            return {kinetic, potential, finite: poses.every(Number.isFinite), lowest: Math.min(...simulation.bodies.map(body => body.position[2])),
                    rate: 1 / interval};
        });
        assert.ok(Number.isFinite(state.kinetic) && Number.isFinite(state.potential) && state.finite, `${scene}: ${JSON.stringify(state)}`);
        assert.ok(state.lowest > ({boats: -4, buggy: -4}[scene] ?? 0) - 0.02, `${scene}: a body is at ${state.lowest}`);
        assert.ok(await overflow(page) <= 0, `${scene}: the page is ${await overflow(page)} pixels too wide`);
        rates[scene] = state.rate.toFixed(1);
        await shot(page, `${scene}-${size}`);
        assert.deepEqual(complaints.splice(0), [], scene);
    }
    console.log(`pictures a second, ${size}, drawn by this processor: ${Object.entries(rates).map(row => row.join(' ')).join(', ')}`);
    await page.close();
}

async function controls() {
    const page = await open(kSizes.wide, `${origin}#scene=pile&count=60&stepper=quick`), inside = (code, value) => page.evaluate(code, value);
    assert.deepEqual(await inside(() => [window.playground.simulation.values.count, window.playground.simulation.method]), [60, 'quick']);
    await page.click('#pause');
    const still = await inside(() => window.playground.steps);
    await page.click('#step');
    assert.equal(await inside(() => window.playground.steps), still + 1);
    await page.locator('#slider-count').fill('40');
    assert.equal(await inside(() => window.playground.simulation.bodies.length), 40);
    await page.selectOption('#method', 'substeps');
    assert.equal(await inside(() => location.hash), '#scene=pile&count=40&stepper=substeps');
    await page.click('#throw');
    assert.equal(await inside(() => window.playground.simulation.bodies.length), 41);
    await page.check('#contacts');
    await page.click('#pause');
    await simulated(page, 1.5);
    assert.ok(await inside(() => window.playground.stage.contacts_shown) > 10);
    await page.focus('#view');
    await page.keyboard.press('Space');
    assert.equal(await inside(() => window.playground.playing), false);
    await page.keyboard.press('r');
    assert.equal(await inside(() => window.playground.simulation.time), 0);
    await shot(page, 'contacts');
    await page.close();
}

// The pointer takes a brick and lifts it.
async function hand() {
    const page = await open(kSizes.wide, `${origin}#scene=wall`), box = await page.locator('#view').boundingBox();
    await page.click('#pause');
    const brick = await page.evaluate(() => {
        const {stage} = window.playground;
        window.playground.restart();
        for (let y = 0.35; y < 0.8; y += 0.05) for (let x = 0.3; x < 0.7; x += 0.05) if (stage.hit(x, y).carrier >= 0) return [x, y];
        return null;
    });
    assert.ok(brick, 'a brick is seen');
    await page.mouse.move(box.x + brick[0] * box.width, box.y + brick[1] * box.height);
    await page.mouse.down();
    assert.ok(await page.evaluate(() => window.playground.simulation.hand !== null), `a brick at ${brick} is held`);
    await page.focus('#view');
    await page.keyboard.press('Space');
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.08 * box.height, {steps: 4});
    await simulated(page, 2);
    const top = await page.evaluate(() => window.playground.simulation.hand.held.position[2]);
    await shot(page, 'hand');
    await page.mouse.up();
    assert.ok(top > 3.2, `the brick was lifted to ${top} m`);
    assert.equal(await page.evaluate(() => window.playground.simulation.hand), null);
    await page.close();
}

// Files from a button and from a drop, a file that is wrong, and sliders that move the robot.
async function own_robot() {
    const page = await open(kSizes.wide, `${origin}#scene=robot`), models = new URL('../robots/models/', import.meta.url);
    const inside = (code, value) => page.evaluate(code, value);
    await page.setInputFiles('#robot-files', [fileURLToPath(new URL('arm.urdf', models)), fileURLToPath(new URL('meshes/cube.stl', models))]);
    await page.waitForSelector('#slider-q1');
    await page.locator('#slider-q1').fill('1');
    await simulated(page, 2);
    const elbow = await inside(() => window.playground.simulation.hooks.robot.positions[1]);
    assert.ok(Math.abs(elbow - 1) < 0.2, `the elbow is at ${elbow}`);
    await shot(page, 'own-robot');
    const text = '<mujoco>\n<worldbody><body><geom type="bax" size="1"/></body></worldbody></mujoco>';
    await inside(wrong => {
        const transfer = new DataTransfer();
        transfer.items.add(new File([wrong], 'wrong.xml'));
        document.dispatchEvent(new DragEvent('drop', {dataTransfer: transfer, bubbles: true, cancelable: true}));
    }, text);
    await page.waitForSelector('#problem:not([hidden])');
    assert.match(await page.textContent('#problem'), /^wrong\.xml:2: /);
    assert.equal(await page.locator('#slider-q1').count(), 1);
    await shot(page, 'wrong-robot');
    await page.close();
}

async function embedded() {
    const page = await open({width: 760, height: 384}, `${origin}#embed=1&scene=arch&friction=0.5`);
    assert.equal(await page.evaluate(() => window.playground.simulation.values.friction), 0.5);
    assert.equal(await page.isVisible('header'), false);
    await page.locator('#slider-friction').fill('0.1');
    assert.equal(await page.evaluate(() => window.playground.simulation.values.friction), 0.1);
    await simulated(page, 0.5);
    await shot(page, 'embedded');
    await page.close();
}

async function accessible() {
    for (const [size, viewport] of Object.entries(kSizes)) {
        for (const colorScheme of ['light', 'dark']) {
            const page = await open(viewport, origin, {colorScheme});
            await judge(page, `${size}, ${colorScheme}`);
            await page.close();
        }
    }
    const calm = await open(kSizes.wide, origin, {reducedMotion: 'reduce'});
    assert.equal(await calm.evaluate(() => window.playground.playing), false);
    await calm.close();
}

async function from_a_file() {
    const page = await open(kSizes.wide, pathToFileURL(html).href);
    await simulated(page, 0.3);
    await page.close();
}

async function same_bits() {
    const poses = simulation => {
        for (let i = 0; i < 150; ++i) simulation.step();
        return Array.from(simulation.states.read());
    };
    const page = await open(kSizes.wide, `${origin}#scene=pile`);
    const there = await page.evaluate(`(() => {
        const {playground} = window;
        playground.playing = false;
        playground.restart();
        return (${poses})(playground.simulation);
    })()`);
    const {load} = await import(path.resolve(EPODE_PACKAGE, 'lib/index.mjs')), source = await readFile(path.resolve(EPODE_WEB, 'epode_robots.wasm'));
    assert.deepEqual(there, poses(new Simulation(await load({source}), 'pile')));
    await page.close();
}

try {
    for (const check of [from_a_file, same_bits, controls, hand, own_robot, embedded, accessible]) await check();
    for (const size of Object.keys(kSizes)) await every_scene(size);
    assert.deepEqual(complaints, []);
    console.log(`the playground works in chromium ${browser.version()}: ${Object.keys(scenes).length} scenes, wide and narrow`);
} finally {
    await browser.close();
    server.close();
}
