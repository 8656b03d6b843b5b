// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The page: time that runs, stands or is dragged, and the controls that say so. `window.epode` is the same for
// scripts: {time, playing, speed, seek(t), fps, stage}.
import {hash_text, load_recording} from './recording.js';
import {Plot} from './plot.js';
import {Poses} from './poses.js';
import {Pace, kLevels} from './quality.js';
import {Stage} from './stage.js';

const element = id => document.getElementById(id);

function complain(text) {
    const box = element('problem');
    box.textContent = text;
    box.hidden = false;
}

const kRest = 400;  // ms without a change after which a picture is fine
const kPause = 800;  // ms at the end of a run that begins again

class Player {
    constructor(recording) {
        this.recording = recording;
        this.poses = new Poses(recording);
        this.stage = new Stage(element('view'), recording, this.poses);
        const times = recording.times;
        this.start = times[0];
        this.end = times[times.length - 1];
        this.time = this.start;
        this.playing = false;
        this.speed = 1;
        this.fps = 0;
        this.dirty = true;
        this.frames = [];
        this.pace = new Pace(this.stage.in_software ? 2 : 0);
        this.level = 0;
        this.chosen = -1;
        this.moved = -Infinity;
        const series = recording.series, energy = series.kinetic.map((k, i) => k + series.potential[i]);
        const seek = time => this.seek(time);
        this.plots = [
            new Plot(element('energy'), series.times, [
                {name: 'kinetic', color: '#c2571a', values: series.kinetic},
                {name: 'potential', color: '#2a7fb8', values: series.potential},
                {name: 'energy', color: '#3a9a63', values: energy},
            ], 'J', seek),
            new Plot(element('error'), series.times,
                     [{name: 'worst joint error', color: '#8a5bb0', values: series.joint_error.map(x => 1000 * x)}], 'mm',
                     seek),
            new Plot(element('cost'), series.times, [{name: 'time a step', color: '#8c7326', values: series.ms}], 'ms', seek),
        ];
        if (recording.joints.count === 0) element('error').hidden = true;
    }

    seek(time) {
        this.time = Math.min(this.end, Math.max(this.start, time));
        this.dirty = true;
    }

    play(on) {
        if (on && this.time >= this.end) this.seek(this.start);
        this.playing = on;
        element('play').textContent = on ? 'Pause' : 'Play';
        this.dirty = true;
    }

    // At the end it stops, or begins again when the end has been seen.
    finish(now) {
        if (!element('loop').checked) return this.play(false);
        this.ended ??= now;
        if (now - this.ended < kPause) return;
        this.ended = undefined;
        this.seek(this.start);
    }

    step(moments) {
        this.play(false);
        const at = this.poses.find(this.time + 1e-6) + moments;
        this.seek(this.recording.times[Math.min(Math.max(at, 0), this.recording.times.length - 1)]);
    }

    // The body that is marked, in the list and in the picture; -1: none.
    choose(carrier) {
        this.chosen = carrier;
        this.stage.mark.set(carrier);
        element('body').value = String(carrier);
        element('follow').disabled = carrier < 0;
        if (element('follow').checked) this.follow(carrier);
        this.dirty = true;
    }

    // To the body after or before the chosen one that is there now.
    choose_next(by) {
        const {count} = this.recording.carriers;
        for (let i = 1, at = this.chosen < 0 && by < 0 ? 0 : this.chosen; i <= count; ++i) {
            at = (at + by + count) % count;
            if (this.poses.alive[at]) return this.choose(at);
        }
    }

    follow(carrier) {
        this.stage.follow = carrier;
        element('follow').checked = carrier >= 0;
        this.dirty = true;
    }

    tick(now) {
        const spent = this.last === undefined ? 0 : (now - this.last) / 1000;
        this.last = now;
        if (this.playing) {
            this.seek(this.time + this.speed * spent);
            if (this.time >= this.end) this.finish(now); else this.ended = undefined;
        }
        this.keep_pace(now, 1000 * spent);
        if (this.dirty) this.draw();
        this.frames.push(now);
        while (this.frames.length > 2 && now - this.frames[0] > 2000) this.frames.shift();
        if (this.frames.length > 1) this.fps = 1000 * (this.frames.length - 1) / (now - this.frames[0]);
    }

    // Coarser pictures while they follow one another too slowly, a fine one where they have stopped.
    keep_pace(now, interval) {
        const rested = now - this.moved > Math.max(kRest, 2 * interval);
        if (this.dirty) {
            if (rested) this.pace.start_again(); else this.pace.add(interval);
            this.moved = now;
        }
        this.use_level(rested && !this.dirty ? 0 : this.pace.level);
    }

    use_level(level) {
        if (level === this.level) return;
        this.level = level;
        this.stage.set_level(kLevels[level]);
        this.dirty = true;
    }

    draw() {
        this.dirty = false;
        this.poses.go_to(this.time);
        this.stage.update();
        this.stage.draw();
        for (const plot of this.plots) plot.draw(this.time);
        element('timeline').value = String(this.time);
        const moment = this.poses.moment, {contacts} = this.recording;
        const counted = contacts.counts[moment];
        element('clock').textContent = `${this.time.toFixed(2)} / ${this.end.toFixed(2)} s`;
        element('where').textContent = this.chosen < 0 ? '' : place_words(this.recording, this.poses, this.chosen);
        element('state').textContent = `state ${this.recording.steps[moment]}, ${counted} contacts, hash ${hash_text(this.recording, moment)}`;
    }
}

function name_of(recording, carrier) {
    const body = recording.carriers.numbers[4 * carrier];
    return body < 0 ? `moving geom ${carrier}` : `body ${body}`;
}

function place_words(recording, poses, carrier) {
    if (!poses.alive[carrier]) return `${name_of(recording, carrier)} is not there now`;
    const [x, y, z] = Array.from(poses.values.subarray(7 * carrier, 7 * carrier + 3), value => value.toFixed(3));
    return `${name_of(recording, carrier)} at ${x}, ${y}, ${z} m`;
}

function describe(recording) {
    const {about} = recording;
    element('title').textContent = about.scene ?? about.program ?? 'Recording';
    element('description').textContent = about.description ?? '';
    const facts = ['stepper', 'dt', 'iterations', 'seed', 'precision'].filter(key => about[key] !== undefined && about[key] !== '0')
                      .map(key => `${key} ${key === 'dt' ? Number(Number(about.dt).toPrecision(6)) + ' s' : about[key]}`);
    facts.unshift(`${recording.bodies} bodies`);
    element('facts').textContent = facts.join(' · ');
}

// Causes of failure, as epode run --diagnose found them: a severity, a sentence, and at the end "[body 3]". A click
// chooses that body.
function list_diagnosis(player) {
    const list = element('diagnosis');
    for (const text of player.recording.diagnosis ?? []) {
        const item = document.createElement('li');
        item.textContent = text;
        item.classList.add(text.split(':')[0]);
        const number = Number(/\[body (\d+)/.exec(text)?.[1] ?? -1);
        const carrier = carrier_of(player.recording, number);
        if (carrier >= 0) {
            item.classList.add('of-body');
            item.addEventListener('click', () => player.choose(carrier));
        }
        list.append(item);
    }
    list.hidden = list.children.length === 0;
}

function carrier_of(recording, body) {
    const {count, numbers} = recording.carriers;
    for (let i = 0; body >= 0 && i < count; ++i) if (numbers[4 * i] === body) return i;
    return -1;
}

function wire_controls(player) {
    const timeline = element('timeline');
    timeline.min = String(player.start);
    timeline.max = String(player.end);
    timeline.step = 'any';
    timeline.addEventListener('input', () => player.seek(Number(timeline.value)));
    element('play').addEventListener('click', () => player.play(!player.playing));
    element('back').addEventListener('click', () => player.step(-1));
    element('forward').addEventListener('click', () => player.step(1));
    element('speed').addEventListener('change', event => { player.speed = Number(event.target.value); });
    const show = (id, lines) => element(id).addEventListener('change', event => {
        lines.visible = event.target.checked;
        player.dirty = true;
    });
    show('contacts', player.stage.contact_lines);
    show('joints', player.stage.joint_lines);
    element('shadows').addEventListener('change', event => {
        player.stage.set_shadows(event.target.checked);
        player.dirty = true;
    });
    element('reset').addEventListener('click', () => {
        player.follow(-1);
        begin_following(player, player.stage.frame_all());
        player.stage.aim_sun();
        player.dirty = true;
    });
    const body = element('body'), follow = element('follow');
    const names = Array.from({length: player.recording.carriers.count}, (_, i) => new Option(name_of(player.recording, i), String(i)));
    body.append(new Option('none', '-1'), ...names);
    body.addEventListener('change', () => player.choose(Number(body.value)));
    follow.addEventListener('change', () => player.follow(follow.checked ? player.chosen : -1));
    player.choose(-1);
}

function begin_following(player, carrier) {
    if (carrier < 0) return;
    player.choose(carrier);
    player.follow(carrier);
}

// A click chooses what is under it, a double click follows it as well; a drag orbits and chooses nothing.
function wire_picking(player, view) {
    const picked = event => {
        const box = view.getBoundingClientRect();
        return player.stage.pick((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height);
    };
    let pressed = null;
    view.addEventListener('pointerdown', event => { pressed = event.button === 0 ? [event.clientX, event.clientY] : null; });
    view.addEventListener('pointerup', event => {
        if (pressed && Math.hypot(event.clientX - pressed[0], event.clientY - pressed[1]) < 4) player.choose(picked(event));
        pressed = null;
    });
    view.addEventListener('dblclick', event => player.follow(picked(event)));
}

function wire_view(player) {
    const view = element('view');
    player.stage.controls.addEventListener('change', () => { player.dirty = true; });
    wire_picking(player, view);
    const keys = {
        ' ': () => player.play(!player.playing),
        p: () => player.play(!player.playing),
        ArrowRight: () => player.step(1),
        '.': () => player.step(1),
        ArrowLeft: () => player.step(-1),
        ',': () => player.step(-1),
        r: () => player.seek(player.start),
        PageDown: () => player.choose_next(1),
        PageUp: () => player.choose_next(-1),
        Escape: () => player.choose(-1),
        f: () => element('follow').click(),
        l: () => element('loop').click(),
        c: () => element('contacts').click(),
        j: () => element('joints').click(),
    };
    window.addEventListener('keydown', event => {
        if (event.ctrlKey || event.metaKey || event.altKey || event.target.matches('input[type=range], select')) return;
        if (event.key === ' ' && event.target.matches('button')) return;
        const action = keys[event.key];
        if (!action) return;
        event.preventDefault();
        action();
    });
    const fit = () => {
        const box = view.parentElement.getBoundingClientRect();
        player.stage.resize(box.width, box.height);
        for (const plot of player.plots) plot.resize();
        player.dirty = true;
    };
    new ResizeObserver(fit).observe(view.parentElement);
    new ResizeObserver(fit).observe(element('plots'));
    fit();
}

async function begin() {
    document.body.classList.toggle('embedded', /^#embed\b/.test(location.hash));
    const recording = await load_recording(document);
    describe(recording);
    const player = new Player(recording);
    wire_controls(player);
    list_diagnosis(player);
    wire_view(player);
    begin_following(player, player.stage.frame_all());
    window.epode = player;
    const loop = now => {
        player.tick(now);
        requestAnimationFrame(loop);
    };
    requestAnimationFrame(loop);
    if (!window.matchMedia('(prefers-reduced-motion: reduce)').matches) player.play(true);
}

begin().catch(error => {
    complain(`This page cannot show its recording: ${error.message}. It needs a browser with WebGL 2 and DecompressionStream.`);
    throw error;
});
