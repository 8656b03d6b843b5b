// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The page: a world that steps in real time, and the controls. `window.epode` is the same for scripts.
import {Stage} from '../../../record/page/src/stage.js';
import {Pace, kLevels} from '../../../record/page/src/quality.js';
import {kStep, scenes, Simulation} from './simulation.mjs';
import {LivePoses, recording_of} from './view.js';

const element = id => document.getElementById(id);
const kMaxSteps = 4;  // in a picture; a slower machine shows slow motion
const kBallSpeed = 18;

class Show {
    constructor(ode) {
        this.ode = ode;
        this.playing = true;
        this.canvas = element('view');
        this.start(Object.keys(scenes)[0]);
        requestAnimationFrame(now => this.picture(now));
    }

    start(scene) {
        this.simulation?.destroy();
        this.stage?.controls.dispose();
        this.stage?.renderer.dispose();
        this.scene = scene;
        this.simulation = new Simulation(this.ode, scene);
        const recording = recording_of(this.simulation);
        this.stage = new Stage(this.canvas, recording, new LivePoses(recording, this.simulation));
        this.pace = new Pace(this.stage.in_software ? 2 : 0);
        this.stage.set_level(kLevels[this.pace.level]);
        this.before = undefined;
        this.owed = this.steps = this.cost = 0;
    }

    picture(now) {
        const passed = this.before === undefined ? 0 : (now - this.before) / 1000;
        this.before = now;
        if (this.playing) {
            this.advance(passed);
            if (passed > 0 && this.pace.add(1000 * passed)) this.stage.set_level(kLevels[this.pace.level]);
        }
        this.stage.poses.go_to();
        this.stage.resize(this.canvas.clientWidth, this.canvas.clientHeight);
        this.stage.update();
        this.stage.draw();
        requestAnimationFrame(next => this.picture(next));
    }

    advance(seconds) {
        this.owed = Math.min(this.owed + seconds, kMaxSteps * kStep);
        for (; this.owed >= kStep; this.owed -= kStep) {
            const begin = performance.now();
            this.simulation.step();
            this.cost += 0.1 * (performance.now() - begin - this.cost);
            ++this.steps;
        }
        const {bodies, ode} = this.simulation, seen = bodies.filter((_, i) => this.simulation.is_seen(i));
        element('figures').textContent = `${seen.filter(({body}) => ode.dBodyIsEnabled(body)).length} of ` +
            `${seen.length} bodies awake, ${(this.steps * kStep).toFixed(1)} s, ${this.cost.toFixed(2)} ms a step`;
    }

    // From the eye towards a point of the picture, 0 ... 1 from the upper left.
    throw_ball(x = 0.5, y = 0.5) {
        const {camera} = this.stage, eye = camera.position;
        const aim = eye.clone().set(2 * x - 1, 1 - 2 * y, 0.5).unproject(camera).sub(eye).normalize();
        const from = eye.clone().addScaledVector(aim, 1.5), velocity = aim.multiplyScalar(kBallSpeed);
        velocity.z += 1;  // it falls on its way
        this.simulation.throw_ball([from.x, from.y, from.z], [velocity.x, velocity.y, velocity.z]);
    }
}

async function main() {
    const {load} = await import(new URL('epode.mjs', document.baseURI));
    const show = window.epode = new Show(await load());
    for (const name of Object.keys(scenes)) element('scene').add(new Option(name));
    element('scene').onchange = () => show.start(element('scene').value);
    element('again').onclick = () => show.start(show.scene);
    element('pause').onclick = () => {
        show.playing = !show.playing;
        element('pause').textContent = show.playing ? 'Pause' : 'Go on';
    };
    element('throw').onclick = () => show.throw_ball();
    show.canvas.ondblclick = event => show.throw_ball(event.offsetX / show.canvas.clientWidth, event.offsetY / show.canvas.clientHeight);
}

main().catch(error => {
    element('problem').textContent = `${error.message}. A page from a file cannot load WebAssembly: serve the folder (docs/guide/howto/browser.md).`;
    element('problem').hidden = false;
    throw error;
});
