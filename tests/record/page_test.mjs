// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A replay page in a real browser without a screen: it draws, plays, scrubs, orbits, follows, shows contacts and plots, complains of
// nothing and asks the network for nothing.
//     node page_test.mjs PAGE.html FOLDER [--measure] [--follows]
// FOLDER gets screenshots; --measure also counts frames a second; --follows: one body goes far, and the page must follow it by itself.
// The browser is Debian's chromium, drawing by software.
import {createRequire} from 'node:module';
import {pathToFileURL} from 'node:url';
import {execFileSync} from 'node:child_process';
import fs from 'node:fs';
import path from 'node:path';

const {chromium} = createRequire(process.env.EPODE_NPM + '/')('playwright-core');
const [page_file, folder, ...options] = process.argv.slice(2);
const measure = options.includes('--measure');
let failures = 0;

function check(holds, text) {
    console.log(`${holds ? 'ok    ' : 'FAILED'} ${text}`);
    if (!holds) ++failures;
}

const server = await chromium.launchServer({
    executablePath: process.env.EPODE_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'],
});
const browser = await chromium.connect(server.wsEndpoint());
const page = await browser.newPage({viewport: {width: 1100, height: 760}});
const complaints = [], requests = [];
page.on('console', message => { if (message.type() === 'error' || message.type() === 'warning') complaints.push(message.text()); });
page.on('pageerror', error => complaints.push(String(error)));
page.on('request', request => { if (!request.url().startsWith('file:') && !/^(data|blob):/.test(request.url())) requests.push(request.url()); });

// How many different colours a canvas shows, and its picture as a number that changes when it does.
const look = id => page.evaluate(canvas_id => {
    window.epode.use_level?.(0);
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

// Milliseconds of processors that the browser with all its processes has used: on a busy machine a better measure than the clock.
function browser_work() {
    const table = execFileSync('ps', ['-eo', 'pid=,ppid=']).toString().trim().split('\n').map(line => line.trim().split(/\s+/).map(Number));
    const family = new Set([server.process().pid]);
    for (let size = 0; size !== family.size;) {
        size = family.size;
        for (const [pid, parent] of table) if (family.has(parent)) family.add(pid);
    }
    let ticks = 0;
    for (const pid of family) {
        if (!fs.existsSync(`/proc/${pid}/stat`)) continue;
        const fields = fs.readFileSync(`/proc/${pid}/stat`, 'utf8').split(') ').pop().split(' ');
        ticks += Number(fields[11]) + Number(fields[12]);
    }
    return 10 * ticks;
}
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

// Whatever the run, most of what moves is in the picture all the time; where one body goes far, that one, and close enough to be seen.
const follows = options.includes('--follows');
const seen = await page.evaluate(follows => {
    const {stage, poses, end} = window.epode;
    const moves = Array.from({length: poses.values.length / 7}, (_, i) => i).filter(i => !follows || i === stage.follow);
    let inside = 0, all = 0;
    for (let k = 0; k <= 10; ++k) {
        window.epode.seek(0.1 * k * end);
        window.epode.draw();
        stage.camera.updateMatrixWorld();
        for (const i of moves) {
            const p = stage.controls.target.clone().fromArray(poses.values, 7 * i), near = p.distanceTo(stage.camera.position) < 20;
            p.project(stage.camera);
            inside += Math.abs(p.x) < 1 && Math.abs(p.y) < 1 && p.z < 1 && (near || !follows);
            ++all;
        }
    }
    window.epode.seek(0);
    return inside / all;
}, follows);
check(seen > 0.85, `${(100 * seen).toFixed(0)} % of what ${follows ? 'is followed' : 'moves'} is in the picture`);
if (follows) {
    await browser.close();
    await server.close();
    process.exit(failures > 0 ? 1 : 0);
}

await page.locator('#play').click();
await page.waitForFunction(() => window.epode.time > 0.15, null, {timeout: 30000}).catch(() => {});
const played = await get('time');
await page.evaluate(() => window.epode.play(false));
check(played > 0.15, `playing advances: ${played.toFixed(2)} s`);

// A run begins again when its end has been seen, or stops there.
const runs_out = async () => {
    await page.evaluate(() => { window.epode.seek(window.epode.end - 0.01); window.epode.play(true); });
    await page.waitForFunction(() => !window.epode.playing || window.epode.time < window.epode.end - 0.05, null, {timeout: 30000}).catch(() => {});
    return page.evaluate(() => [window.epode.playing, window.epode.time < window.epode.end - 0.05]);
};
check((await runs_out()).join() === 'true,true', 'at its end a run begins again');
await page.evaluate(() => document.getElementById('loop').click());
check((await runs_out()).join() === 'false,false', 'without looping it stops there');
await page.evaluate(() => window.epode.play(false));

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
    const select = document.getElementById('body');
    select.value = '0';
    select.dispatchEvent(new Event('change'));
    const box = document.getElementById('follow');
    if (!box.checked) box.click();
    window.epode.seek(window.epode.end);
    window.epode.draw();
    const target = window.epode.stage.controls.target;
    return Math.hypot(target.x - values[0], target.y - values[1], target.z - values[2]);
});
check(followed < 1e-4, 'the view follows a body');
await page.screenshot({path: path.join(folder, 'page_end.png')});

// Picking: a body that nothing hides is chosen by a click on it, marked in the list and in the picture; the list, and keys, do the reverse.
await page.evaluate(() => {
    document.getElementById('follow').checked && document.getElementById('follow').click();
    document.getElementById('reset').click();
    document.getElementById('follow').checked && document.getElementById('follow').click();
    window.epode.seek(0);
    window.epode.choose(-1);
    window.epode.draw();
});
const seen_body = await page.evaluate(() => {
    const {stage, poses} = window.epode;
    stage.camera.updateMatrixWorld();
    for (let i = 0; i < poses.values.length / 7; ++i) {
        const p = stage.controls.target.clone().fromArray(poses.values, 7 * i).project(stage.camera);
        const [x, y] = [0.5 + 0.5 * p.x, 0.5 - 0.5 * p.y];
        if (Math.abs(p.x) < 0.9 && Math.abs(p.y) < 0.9 && stage.pick(x, y) === i) return {body: i, x, y};
    }
    return null;
});
const chosen_now = () => page.evaluate(() => ({list: document.getElementById('body').value, name: document.getElementById('body').selectedOptions[0].text,
                                               marked: window.epode.stage.mark.lines.geometry.drawRange.count, where: document.getElementById('where').textContent}));
const unmarked = await look('view');
const area = await page.locator('#view').boundingBox();
await page.mouse.click(area.x + seen_body.x * area.width, area.y + seen_body.y * area.height);
const after_click = await chosen_now();
check(after_click.list === String(seen_body.body), `a click in the picture chooses ${after_click.name} in the list`);
const marked = await look('view');
check(after_click.marked > 0 && marked.hash !== unmarked.hash, 'it is marked in the picture');
check((await chosen_now()).where.startsWith(`${after_click.name} at `), `its place is shown: ${(await chosen_now()).where}`);
await page.locator('#body').focus();
await page.keyboard.press('ArrowDown');
const by_list = await chosen_now();
check(by_list.list === String(seen_body.body + 1) && (await look('view')).hash !== marked.hash, `the list by keys chooses ${by_list.name}`);
await page.locator('#view').focus();
await page.keyboard.press('PageUp');
check((await chosen_now()).list === String(seen_body.body) && (await look('view')).hash === marked.hash, 'page up in the picture goes back to it');
await page.keyboard.press('Escape');
check((await chosen_now()).list === '-1' && (await look('view')).hash === unmarked.hash, 'Escape chooses nothing, and all looks as before');
await page.mouse.move(area.x + seen_body.x * area.width, area.y + seen_body.y * area.height);
await page.mouse.down();
await page.mouse.move(area.x + seen_body.x * area.width + 60, area.y + seen_body.y * area.height, {steps: 4});
await page.mouse.up();
check((await chosen_now()).list === '-1', 'a drag orbits and chooses nothing');

// Orbiting, shifting and coming back from below: the eye stays above the floor.
const floors = await page.evaluate(() => window.epode.stage.ground.floors.length);
if (floors > 0) {
    const eye = () => page.evaluate(() => window.epode.stage.camera.position.z - Math.max(...window.epode.stage.ground.floors));
    const drag = async (button, dy) => {
        for (let k = 0; k < 3; ++k) {
            await page.mouse.move(area.x + 0.5 * area.width, area.y + (dy < 0 ? 0.9 : 0.1) * area.height);
            await page.mouse.down({button});
            await page.mouse.move(area.x + 0.5 * area.width, area.y + (dy < 0 ? 0.05 : 0.95) * area.height, {steps: 6});
            await page.mouse.up({button});
        }
    };
    const high = await eye();
    await drag('left', -1);
    const low = await eye();
    check(low > 0 && low < 0.5 * high, `orbiting under the floor ends above it: ${low.toFixed(2)} m`);
    await page.screenshot({path: path.join(folder, 'page_low.png')});
    await drag('right', -1);
    check(await eye() > 0, `shifting down ends above it: ${(await eye()).toFixed(2)} m`);
    await page.evaluate(() => {
        const {controls, camera} = window.epode.stage;
        camera.position.z = -50;
        controls.update();
    });
    check(await eye() > 0, 'an eye below the floor is lifted');
}

// Pictures that follow one another too slowly become coarser, and no coarser than the last level; quick ones stay as they are.
const levels = await page.evaluate(() => {
    const {pace, stage} = window.epode, level_after = (interval, count) => {
        for (let i = 0; i < count; ++i) pace.add(interval);
        return pace.level;
    };
    pace.level = 0;
    pace.start_again();
    const found = [level_after(16, 60), level_after(80, 6), level_after(300, 6), level_after(300, 60)];
    const side = level => {
        window.epode.use_level(level);
        stage.draw();
        return stage.renderer.domElement.width;
    };
    return {found, fine: side(0), coarse: side(pace.level), shadows: stage.sun.castShadow};
});
check(levels.found.join() === '0,1,3,3' && levels.coarse < 0.6 * levels.fine && !levels.shadows,
      `slow pictures become coarser: levels ${levels.found}, ${levels.fine} and ${levels.coarse} pixels wide`);
const rests = await page.waitForFunction(() => window.epode.level === 0, null, {timeout: 20000}).then(() => true, () => false);
check(rests, 'a picture that stands still is fine');

if (measure) {
    for (const shadows of [true, false]) {
        await page.evaluate(on => {
            const box = document.getElementById('shadows');
            if (box.checked !== on) box.click();
            window.epode.seek(0);
            window.epode.play(true);
        }, shadows);
        const pictures = () => page.evaluate(() => window.epode.stage.renderer.info.render.frame);
        const [frame_before, work_before, begin] = [await pictures(), browser_work(), performance.now()];
        await page.waitForTimeout(6000);
        const drawn = await pictures() - frame_before, seconds = (performance.now() - begin) / 1000;
        const fps = drawn / seconds, cpu = (browser_work() - work_before) / drawn;
        const work = await page.evaluate(() => {
            const begin = performance.now();
            for (let i = 0; i < 20; ++i) {
                window.epode.poses.go_to(0.04 * i);
                window.epode.stage.update();
            }
            return (performance.now() - begin) / 20;
        });
        console.log(`${fps.toFixed(1)} frames/s ${shadows ? 'with' : 'without'} shadows, level ${await get('level') ?? 0}; a frame took the browser ` +
                    `${cpu.toFixed(0)} ms of processors' time, of which own work ${work.toFixed(2)} ms`);
    }
}

check(requests.length === 0, `nothing is asked of the network${requests.length ? ': ' + requests[0] : ''}`);
const real = complaints.filter(text => !/GPU stall|swiftshader|software WebGL/i.test(text));
check(real.length === 0, `no complaint on the console${real.length ? ': ' + real[0] : ''}`);
await browser.close();
await server.close();
if (failures > 0) {
    console.log(`${failures} failed`);
    process.exit(1);
}
console.log('all passed');
