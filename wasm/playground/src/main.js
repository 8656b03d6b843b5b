// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The playground. `window.playground` is its Show, for scripts.
import {load} from 'epode';
import {Keys} from './keys.js';
import {read_link} from './link.mjs';
import {module_bytes} from './module.js';
import {Panel} from './panel.js';
import {RobotPanel} from './robot_panel.js';
import {Show} from './show.js';

const element = id => document.getElementById(id);

// In a page about something else (a link with embed=1): less around the picture, and the address stays.
const is_embedded = new URLSearchParams(location.hash.slice(1)).has('embed');
document.body.classList.toggle('embedded', is_embedded);

// A scene that is scrolled away rests.
function pause_unseen(show) {
    new IntersectionObserver(([{isIntersecting}]) => { show.is_seen = isIntersecting; }).observe(show.canvas);
}

async function main() {
    const engine = await load({source: await module_bytes()});
    let panel = null;
    const show = new Show(engine, element('view'), read_link(location.hash), () => panel?.update());
    panel = new Panel(show);
    show.keys = new Keys(show, panel);
    show.robots = new RobotPanel(show, panel);
    window.addEventListener('hashchange', () => {
        show.start(read_link(location.hash));
        panel.scene_changed();
    });
    panel.scene_changed();
    if (is_embedded) pause_unseen(show);
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) panel.pause(false);
    element('loading').remove();
    window.playground = show;
}

main().catch(error => {
    element('loading').remove();
    element('problem').textContent = `${error.message}. The playground wants WebAssembly with SIMD and WebGL 2: Chromium or Firefox of 2021, Safari 16.4, or later.`;
    element('problem').hidden = false;
    throw error;
});
