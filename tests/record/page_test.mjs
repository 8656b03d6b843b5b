// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A replay page in a real browser without a screen: it draws, plays, scrubs, orbits, follows, shows contacts and plots, complains of
// nothing and asks the network for nothing.
//     node page_test.mjs PAGE.html FOLDER [--measure]
// FOLDER gets screenshots; --measure also counts frames a second. The browser is Debian's chromium, drawing by software.
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';
import path from 'node:path';

const {chromium} = createRequire(process.env.EPODE_NPM + '/')('playwright-core');
const [page_file, folder, measure] = process.argv.slice(2);
let failures = 0;

function check(holds, text) {
    console.log(`${holds ? 'ok    ' : 'FAILED'} ${text}`);
    if (!holds) ++failures;
}

const browser = await chromium.launch({
    executablePath: process.env.EPODE_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'],
});
const page = await browser.newPage({viewport: {width: 1100, height: 760}});
const complaints = [], requests = [];
page.on('console', message => { if (message.type() === 'error' || message.type() === 'warning') complaints.push(message.text()); });
page.on('pageerror', error => complaints.push(String(error)));
page.on('request', request => { if (!request.url().startsWith('file:') && !/^(data|blob):/.test(request.url())) requests.push(request.url()); });

// How many different colours a canvas shows, and its picture as a number that changes when it does.
const look = id => page.evaluate(canvas_id => {
    window.epode.draw();
    const canvas = document.getElementById(canvas_id), copy = document.createElement('canvas');
    copy.width = 220;
    copy.height = 150;
    const context = copy.getContext('2d', {willReadFrequently: true});
    context.drawImage(canvas, 0, 0, copy.width, copy.height);
    const data = context.getImageData(0, 0, copy.width, copy.height).data, colors = new Set();
    let hash = 0;
    for (let i = 0; i < data.length; i += 4) {
        colors.add((data[i] >> 3) << 16 | (data[i + 1] >> 3) << 8 | data[i + 2] >> 3);
        hash = (Math.imul(hash, 31) + data[i] + 3 * data[i + 1] + 7 * data[i + 2] + data[i + 3]) | 0;
    }
    return {colors: colors.size, hash};
}, id);
const get = name => page.evaluate(key => window.epode[key], name);
const state = () => page.locator('#state').textContent();

await page.goto(pathToFileURL(path.resolve(page_file)).href);
await page.waitForFunction(() => window.epode !== undefined, null, {timeout: 20000}).catch(() => {});
if (await page.evaluate(() => window.epode === undefined)) {
    console.log('FAILED the page does not start:', complaints.join('\n'));
    await page.screenshot({path: path.join(folder, 'page_start.png')});
    process.exit(1);
}
await page.evaluate(() => { window.epode.play(false); window.epode.seek(0); });
const start = await look('view');
check(start.colors > 60, `the canvas is not blank: ${start.colors} colours`);
check(await page.locator('#problem').isHidden(), 'no problem is shown');

// Whatever the run, most of what moves is in the picture all the time.
const seen = await page.evaluate(() => {
    const {stage, poses, end} = window.epode;
    let inside = 0, all = 0;
    for (let k = 0; k <= 10; ++k) {
        window.epode.seek(0.1 * k * end);
        window.epode.draw();
        stage.camera.updateMatrixWorld();
        for (let i = 0; i < poses.values.length / 7; ++i) {
            const p = stage.controls.target.clone().fromArray(poses.values, 7 * i).project(stage.camera);
            inside += Math.abs(p.x) < 1 && Math.abs(p.y) < 1 && p.z < 1;
            ++all;
        }
    }
    window.epode.seek(0);
    return inside / all;
});
check(seen > 0.85, `${(100 * seen).toFixed(0)} % of what moves is in the picture`);

await page.locator('#play').click();
await page.waitForFunction(() => window.epode.time > 0.15, null, {timeout: 30000}).catch(() => {});
const played = await get('time');
await page.evaluate(() => window.epode.play(false));
check(played > 0.15, `playing advances: ${played.toFixed(2)} s`);

const end = await get('end');
await page.locator('#timeline').focus();
await page.evaluate(() => {
    const timeline = document.getElementById('timeline');
    timeline.value = String(0.5 * window.epode.end);
    timeline.dispatchEvent(new Event('input'));
});
check(Math.abs(await get('time') - 0.5 * end) < 0.02 * end, 'the timeline scrubs');
const middle = await look('view');
check(middle.hash !== start.hash, 'the middle looks different from the start');
await page.screenshot({path: path.join(folder, 'page_middle.png')});

const box = await page.locator('#view').boundingBox();
await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
await page.mouse.down();
await page.mouse.move(box.x + 0.75 * box.width, box.y + 0.4 * box.height, {steps: 5});
await page.mouse.up();
check((await look('view')).hash !== middle.hash, 'dragging orbits');

const before = await look('view');
await page.locator('#contacts').check();
const contacts = await page.evaluate(() => { window.epode.draw(); return window.epode.stage.contacts_shown; });
check(contacts > 0 && (await look('view')).hash !== before.hash, `contacts are shown: ${contacts}`);

const plot = await look('energy');
check(plot.colors > 5, `the plot of energy is not blank: ${plot.colors} colours`);
const energy = await page.locator('#energy').boundingBox();
await page.mouse.click(energy.x + energy.width - 2, energy.y + 0.5 * energy.height);
check(await get('time') > 0.97 * end, 'a click in the plot goes there');
check((await look('energy')).hash !== plot.hash, 'its cursor moves');
if (await page.locator('#error').isVisible()) check((await look('error')).colors > 5, 'the plot of joint errors is not blank');

await page.evaluate(() => window.epode.seek(0));
await page.keyboard.press('Escape');
await page.locator('#view').click({position: {x: 3, y: 3}});
const first = await get('time');
await page.keyboard.press('ArrowRight');
await page.waitForTimeout(300);
check(await get('time') > first && /hash [0-9a-f]{16}/.test(await state()), `the right arrow goes one picture on: ${await state()}`);

const followed = await page.evaluate(() => {
    const {values} = window.epode.poses;
    const select = document.getElementById('follow');
    select.value = '0';
    select.dispatchEvent(new Event('change'));
    window.epode.seek(window.epode.end);
    window.epode.draw();
    const target = window.epode.stage.controls.target;
    return Math.hypot(target.x - values[0], target.y - values[1], target.z - values[2]);
});
check(followed < 1e-4, 'the view follows a body');
await page.screenshot({path: path.join(folder, 'page_end.png')});

if (measure) {
    for (const shadows of [true, false]) {
        await page.evaluate(on => {
            const box = document.getElementById('shadows');
            if (box.checked !== on) box.click();
            window.epode.seek(0);
            window.epode.play(true);
        }, shadows);
        await page.waitForTimeout(5000);
        const fps = await get('fps');
        const work = await page.evaluate(() => {
            const begin = performance.now();
            for (let i = 0; i < 20; ++i) {
                window.epode.poses.go_to(0.04 * i);
                window.epode.stage.update();
            }
            return (performance.now() - begin) / 20;
        });
        console.log(`${fps.toFixed(1)} frames/s ${shadows ? 'with' : 'without'} shadows, of which own work ${work.toFixed(2)} ms a frame`);
    }
}

check(requests.length === 0, `nothing is asked of the network${requests.length ? ': ' + requests[0] : ''}`);
const real = complaints.filter(text => !/GPU stall|swiftshader|software WebGL/i.test(text));
check(real.length === 0, `no complaint on the console${real.length ? ': ' + real[0] : ''}`);
await browser.close();
if (failures > 0) {
    console.log(`${failures} failed`);
    process.exit(1);
}
console.log('all passed');
