// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene that is seen: the simulation advances in real time, or slower where it cannot, and the stage draws it.
import {kLevels, Pace} from '../../../record/page/src/quality.js';
import {Hand} from './hand.js';
import {LiveStage} from './live_stage.js';
import {Log} from './log.mjs';
import {scenes} from './scenes/all.mjs';
import {Simulation} from './simulation.mjs';

const kMaxSimulated = 1 / 15, kMaxBusy = 0.03;  // s in a picture: simulated, and computing

export class Show {
    constructor(engine, canvas, chosen, each_picture) {
        Object.assign(this, {engine, canvas, each_picture, playing: true, is_seen: true, keys: null, steps: 0, cost: 0, interval: 1 / 60});
        this.start(chosen);
        this.hand = new Hand(this);
        requestAnimationFrame(now => this.picture(now));
    }

    // chosen: {scene, values, method}. The view stays where the scene is the same, unless what it shows is new.
    start({scene, values, method}, is_new = false) {
        const before = this.simulation, view = before?.scene === scene && !is_new ? undefined : scenes[scene].view;
        this.hand?.let_go();
        this.simulation = new Simulation(this.engine, scene, values, method);
        if (!this.stage) this.begin_stage(view); else this.stage.present(this.simulation, view);
        before?.destroy();
        this.log = new Log();
        this.owed = 0;
    }

    begin_stage(view) {
        this.stage = new LiveStage(this.canvas, this.simulation, view);
        this.pace = new Pace(this.stage.in_software ? 2 : 0);
        this.stage.set_level(kLevels[this.pace.level]);
    }

    restart() { this.start(this.simulation); }

    // A slider's value; the scene begins again unless it takes the value as it runs.
    set(name, value) { if (!this.simulation.set(name, value)) this.restart(); }

    set_method(method) { this.simulation.method = method; }

    step_once() {
        this.simulation.keys = this.keys?.state;
        const begin = performance.now();
        this.simulation.step();
        const cost = performance.now() - begin;
        this.cost += 0.1 * (cost - this.cost);
        ++this.steps;
        this.log.add(this.simulation, cost);
    }

    advance(seconds) {
        const {h} = this.simulation, begin = performance.now();
        this.owed = Math.min(this.owed + seconds, kMaxSimulated);
        for (; this.owed >= h; this.owed -= h) {
            if (performance.now() - begin > 1000 * kMaxBusy) {
                this.owed = 0;
                return;
            }
            this.step_once();
        }
    }

    picture(now) {
        if (!this.is_seen) {
            this.before = undefined;
            requestAnimationFrame(next => this.picture(next));
            return;
        }
        const passed = this.before === undefined ? 0 : (now - this.before) / 1000;
        this.before = now;
        if (passed > 0) this.interval += 0.1 * (Math.min(passed, 1) - this.interval);
        if (this.playing) {
            this.advance(passed);
            if (passed > 0 && this.pace.add(1000 * passed)) this.stage.set_level(kLevels[this.pace.level]);
        }
        this.draw();
        this.each_picture();
        requestAnimationFrame(next => this.picture(next));
    }

    draw() {
        const {stage, canvas} = this;
        if (canvas.clientWidth !== this.width || canvas.clientHeight !== this.height) {
            [this.width, this.height] = [canvas.clientWidth, canvas.clientHeight];
            stage.resize(this.width, this.height);
        }
        if (stage.generation === this.simulation.generation) stage.poses.go_to();
        stage.update();
        stage.draw();
    }
}
