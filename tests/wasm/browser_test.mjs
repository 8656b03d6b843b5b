// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The page in Debian's chromium without a screen: it draws, steps, throws balls, changes scenes and complains of nothing; and the
// pile steps to the same bits in the browser as in this Node.
//     EPODE_NPM=build/npm EPODE_WEB=build/wasm/web node browser_test.mjs [PICTURE.png]
import assert from 'node:assert/strict';
import {readFile} from 'node:fs/promises';
import {createServer} from 'node:http';
import {createRequire} from 'node:module';
import path from 'node:path';
import {Simulation} from '../../wasm/page/src/simulation.mjs';

const web = path.resolve(process.env.EPODE_WEB), kTypes = {'.html': 'text/html', '.wasm': 'application/wasm', '.js': 'text/javascript', '.mjs': 'text/javascript'};
const {chromium} = createRequire(path.resolve(process.env.EPODE_NPM) + '/')('playwright-core');

const server = createServer(async (request, response) => {
    const file = path.join(web, request.url === '/' ? 'index.html' : path.basename(request.url));
    try {
        const content = await readFile(file);
        response.writeHead(200, {'content-type': kTypes[path.extname(file)]}).end(content);
    } catch {
        response.writeHead(404).end();
    }
});
await new Promise(resolve => server.listen(0, resolve));

const browser = await chromium.launch({
    executablePath: process.env.EPODE_CHROMIUM ?? '/usr/bin/chromium',
    args: ['--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--no-sandbox'],
});
const complaints = [];
try {
    const page = await browser.newPage({viewport: {width: 1000, height: 700}});
    page.on('pageerror', error => complaints.push(String(error)));
    page.on('console', message => { if (message.type() === 'error' && !/favicon|404/.test(message.text())) complaints.push(message.text()); });
    await page.goto(`http://localhost:${server.address().port}/`);
    const stepped = count => page.waitForFunction(wanted => window.epode?.steps > wanted, count, {timeout: 60000});

    await stepped(30);
    await page.click('#throw');
    await stepped(120);
    const moved = await page.evaluate(() => {
        const poses = Array.from(window.epode.simulation.poses());
        return poses.filter((x, i) => i < 700 && i % 7 === 0 && Math.abs(x) > 0.1).length;
    });
    assert.ok(moved >= 3, `a ball moved ${moved} bricks`);
    const drawn = await page.screenshot(process.argv[2] ? {path: process.argv[2]} : {});
    for (const scene of ['pile', 'bridge']) {
        await page.selectOption('#scene', scene);
        await stepped(60);
        assert.equal(await page.evaluate(() => window.epode.scene), scene);
        assert.notDeepEqual(await page.screenshot(), drawn);
    }
    await page.click('#pause');

    const poses = simulation => {
        for (let i = 0; i < 150; ++i) simulation.step();
        return Array.from(simulation.poses());
    };
    const there = await page.evaluate(`(() => {
        const show = window.epode;
        show.start('pile');
        return (${poses})(show.simulation);
    })()`);
    const {load} = await import(`${web}/epode.mjs`);
    assert.deepEqual(there, poses(new Simulation(await load(), 'pile')));
    assert.deepEqual(complaints, []);
    console.log(`the page works in chromium ${browser.version()}: ${moved} bricks moved, 150 steps of the pile as in Node`);
} finally {
    await browser.close();
    server.close();
}
