// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What tests in Debian's chromium without a screen share: the browser, pages whose complaints are kept, pictures of them, and axe-core's
// judgement. EPODE_NPM is the folder with playwright-core and axe-core, the first argument the one for pictures.
import assert from 'node:assert/strict';
import {mkdir} from 'node:fs/promises';
import {createRequire} from 'node:module';
import path from 'node:path';

const from_npm = createRequire(path.resolve(process.env.EPODE_NPM) + '/'), {chromium} = from_npm('playwright-core');
const axe = from_npm.resolve('axe-core/axe.min.js'), pictures = process.argv[2];
export const kSizes = {wide: {width: 1280, height: 800}, narrow: {width: 390, height: 844}}, kPatience = 120000;
export const complaints = [];

if (pictures) await mkdir(pictures, {recursive: true});
export const browser = await chromium.launch({
    executablePath: process.env.EPODE_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'],
});

// A new page, whose errors and warnings, and those of frames in it, go to `complaints`.
export async function watched_page(viewport, options = {}) {
    const page = await browser.newPage({viewport, ...options});
    page.setDefaultTimeout(kPatience);
    page.on('pageerror', error => complaints.push(String(error)));
    page.on('console', message => { if (['error', 'warning'].includes(message.type()) && !/favicon|404|GPU stall/.test(message.text())) complaints.push(message.text()); });
    return page;
}

export const shot = (page, name, options = {}) => page.screenshot({...options, ...(pictures ? {path: path.join(pictures, `${name}.png`)} : {})});

// Pixels that lie right of the window.
export const overflow = page => page.evaluate(() => document.documentElement.scrollWidth - document.documentElement.clientWidth);

// No fault that axe-core calls serious; others are printed. Frames have tests of their own.
export async function judge(page, label) {
    await page.addScriptTag({path: axe});
    const {violations} = await page.evaluate(() => window.axe.run(document, {preload: false, iframes: false}));
    const serious = violations.filter(({impact}) => ['serious', 'critical'].includes(impact));
    assert.deepEqual(serious.map(({id, nodes}) => `${id}: ${nodes.map(node => node.html).join(' ')}`), [], label);
    if (violations.length > 0) console.log(`axe, ${label}: ${violations.map(({id, impact}) => `${id} (${impact})`).join(', ')}`);
}
