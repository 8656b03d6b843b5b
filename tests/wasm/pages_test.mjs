// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The site (build/site, by scripts/docs after wasm/playground/build) in Debian's chromium, opened as files, wide and narrow: pages with a live
// scene, the first one among them, run it, complain of nothing and are no wider than the window; axe-core finds no serious fault in them.
//     EPODE_NPM=build/npm EPODE_SITE=build/site node pages_test.mjs [FOLDER for pictures]
import assert from 'node:assert/strict';
import {readdirSync, readFileSync} from 'node:fs';
import path from 'node:path';
import {fileURLToPath, pathToFileURL} from 'node:url';
import {browser, complaints, judge, kSizes, overflow, shot, watched_page} from './browser.mjs';

const site = path.resolve(process.env.EPODE_SITE), kLive = 'figure.live iframe', kSeconds = 1.5;
const docs = fileURLToPath(new URL('../../docs/', import.meta.url));
const live = readdirSync(docs, {recursive: true}).filter(name => name.endsWith('.md') && readFileSync(path.join(docs, name), 'utf8').includes('<!-- live'))
    .map(name => name.replace(/md$/, 'html')).sort();

// The frame of the scene, when it has simulated.
async function running(page) {
    await page.locator(kLive).scrollIntoViewIfNeeded();
    const frame = await (await page.locator(kLive).elementHandle()).contentFrame();
    await frame.waitForFunction(seconds => window.playground?.simulation.time > seconds, kSeconds);
    return frame;
}

// A slider's new value is the simulation's, and nothing of the controls is cut.
async function can_be_changed(frame, name) {
    const slider = frame.locator('#sliders input').first(), id = (await slider.getAttribute('id')).replace('slider-', '');
    await slider.fill(await slider.getAttribute('min'));
    assert.equal(await frame.evaluate(key => window.playground.simulation.values[key], id), Number(await slider.getAttribute('min')), name);
    await slider.evaluate(input => input.scrollIntoView());
    assert.ok(await overflow(frame) <= 0, `${name}: the scene is ${await overflow(frame)} pixels too wide`);
}

async function check(name, size) {
    const page = await watched_page(kSizes[size]), label = `${name.replace(/\W/g, '-')}-${size}`;
    await page.goto(pathToFileURL(path.join(site, name)).href);
    const frame = await running(page);
    await shot(page, label);
    await can_be_changed(frame, name);
    assert.ok(await overflow(page) <= 0, `${name}, ${size}: the page is ${await overflow(page)} pixels too wide`);
    await judge(page, label);
    assert.deepEqual(complaints.splice(0), [], label);
    await page.close();
}

try {
    for (const size of Object.keys(kSizes)) for (const name of live) await check(name, size);
    console.log(`pages: ${live.length} live scenes run in chromium ${browser.version()}, wide and narrow`);
} finally {
    await browser.close();
}
