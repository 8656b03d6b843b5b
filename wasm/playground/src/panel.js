// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The controls beside the picture: scenes, sliders, stepper, buttons, what is shown, figures and plots.
import {Plot} from '../../../record/page/src/plot.js';
import {link_of} from './link.mjs';
import {scenes} from './scenes/all.mjs';
import {kMethods} from './simulation.mjs';

const kMethodNames = {hybrid: 'Hybrid: exact where that pays', quick: 'Quick: sweeps', exact: 'Exact', substeps: 'Substeps'};
const kFigures = 0.25, kPlots = 0.2;  // s between two changes
const short = value => Number(Number(value).toPrecision(4));
const element = id => document.getElementById(id);

function made(tag, properties, ...children) {
    const one = Object.assign(document.createElement(tag), properties);
    one.append(...children);
    return one;
}

export class Panel {
    constructor(show) {
        this.show = show;
        this.last_figures = this.last_plots = 0;
        element('scenes').append(...Object.entries(scenes).map(([name, {title}]) => made('a', {href: `#scene=${name}`, textContent: title, id: `scene-${name}`})));
        element('method').append(...kMethods.map(name => new Option(kMethodNames[name], name)));
        element('method').onchange = () => this.choose_method(element('method').value);
        element('pause').onclick = () => this.pause();
        element('step').onclick = () => this.step();
        element('reset').onclick = () => this.reset();
        element('throw').onclick = () => show.hand.throw_ball();
        element('share').onclick = () => this.share();
        for (const kind of ['contacts', 'joints']) element(kind).onchange = () => this.show_lines();
        this.energy = new Plot(element('energy'), [], [], 'J');
        this.time = new Plot(element('time'), [], [], 'ms');
    }

    // After a scene has begun by a link.
    scene_changed() {
        const {scene, method} = this.show.simulation, {title, about} = scenes[scene];
        for (const link of element('scenes').children) link.id === `scene-${scene}` ? link.setAttribute('aria-current', 'true') : link.removeAttribute('aria-current');
        element(`scene-${scene}`).scrollIntoView({block: 'nearest', inline: 'center'});
        element('problem').hidden = true;
        element('title').textContent = title;
        element('about').textContent = about;
        element('method').value = method;
        element('sliders').replaceChildren(...this.sliders());
        this.show_lines();
        this.say(`${title}.`);
    }

    sliders() {
        const {scene, values} = this.show.simulation;
        return Object.entries(scenes[scene].sliders).map(([name, {label, low, high, step}]) => {
            const output = made('output', {textContent: short(values[name])}), input = made('input', {type: 'range', min: low, max: high, step, id: `slider-${name}`});
            input.value = values[name];
            output.htmlFor.add(input.id);
            input.oninput = () => { output.textContent = short(input.value); };
            input.onchange = () => this.set(name, Number(input.value));
            return made('div', {className: 'slider'}, made('label', {htmlFor: input.id, textContent: label}), output, input);
        });
    }

    set(name, value) {
        this.show.set(name, value);
        this.show_lines();
        this.keep_link();
    }

    choose_method(method) {
        this.show.set_method(method);
        this.keep_link();
    }

    keep_link() { if (!document.body.classList.contains('embedded')) history.replaceState(null, '', link_of(this.show.simulation)); }

    async share() {
        this.keep_link();
        try {
            await navigator.clipboard.writeText(location.href);
            this.say('The link to this scene and its settings is copied.');
        } catch {
            this.say('Copy the link from the address of this page.');
        }
    }

    pause(playing = !this.show.playing) {
        this.show.playing = playing;
        element('pause').textContent = playing ? 'Pause' : 'Play';
        this.say(playing ? 'Running.' : 'Paused.');
    }

    step() {
        this.pause(false);
        this.show.step_once();
    }

    reset() {
        this.show.restart();
        this.show_lines();
        this.say('From the beginning.');
    }

    toggle(kind) {
        element(kind).checked = !element(kind).checked;
        this.show_lines();
    }

    show_lines() {
        this.show.stage.contact_lines.visible = element('contacts').checked;
        this.show.stage.joint_lines.visible = element('joints').checked;
    }

    // For screen readers, and for all in the line below the picture.
    say(text) { element('said').textContent = text; }

    // Each picture.
    update(now = performance.now() / 1000) {
        if (now > this.last_figures + kFigures) {
            this.last_figures = now;
            this.figures();
        }
        if (now > this.last_plots + kPlots) {
            this.last_plots = now;
            this.plots();
        }
    }

    figures() {
        const {simulation, cost, interval} = this.show, {bodies} = simulation, awake = bodies.filter(body => body.enabled).length;
        element('figures').textContent = `${simulation.time.toFixed(1)} s · ${bodies.length} bodies, ${awake} awake · ` +
            `${cost.toFixed(2)} ms a step · ${(1 / interval).toFixed(0)} pictures a second`;
    }

    plots() {
        const {times, kinetic, potential, cost} = this.show.log;
        this.plot(this.energy, times, [{name: 'kinetic', color: '#c2571a', values: kinetic}, {name: 'potential', color: '#2f74b5', values: potential}]);
        this.plot(this.time, times, [{name: 'time of a step', color: '#2f855a', values: cost}]);
    }

    plot(plot, times, series) {
        plot.show(times, series);
        plot.resize();
        plot.draw();
    }
}
