// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots that the visitor brings: files dropped on the page or chosen by a button, and what is wrong with them.
import {files_of_drop, files_of_list, with_aliases} from './robot_files.mjs';
import {choose} from './scenes/robot.mjs';

const element = id => document.getElementById(id);

export class RobotPanel {
    constructor(show, panel) {
        Object.assign(this, {show, panel, files: null});
        for (const id of ['robot-files', 'robot-folder']) element(id).onchange = event => this.take(files_of_list(event.target.files));
        element('robot-main').onchange = () => this.load();
        element('robot-fixed').onchange = () => this.files && this.load();
        document.addEventListener('dragover', event => event.preventDefault());
        document.addEventListener('drop', event => {
            event.preventDefault();
            this.take(files_of_drop(event.dataTransfer));
        });
    }

    // Files, as soon as they are read.
    async take(promise) {
        try {
            const files = with_aliases(await promise);
            if (files.size === 0) return;
            this.files = files;
            const mains = this.show.engine.robots.mainFiles(files).sort((a, b) => Number(/scene/i.test(b)) - Number(/scene/i.test(a)) || a.localeCompare(b));
            element('robot-main').replaceChildren(...mains.map(path => new Option(path, path)));
            element('robot-main').parentElement.hidden = mains.length < 2;
            this.load();
        } catch (error) {
            this.complain(error);
        }
    }

    load() {
        try {
            const path = element('robot-main').value;
            if (!path) throw new Error(`No URDF or MJCF file is among the files: ${[...this.files.keys()].slice(0, 5).join(', ')}`);
            choose(this.show.engine, this.files, {path, fixedBase: element('robot-fixed').checked, inertiaFromShapes: true, repair: true});
            element('problem').hidden = true;
            this.show.start({scene: 'robot', values: {}, method: this.show.simulation.method}, true);
            history.replaceState(null, '', '#scene=robot');
            this.panel.scene_changed();
        } catch (error) {
            this.complain(error);
        }
    }

    complain(error) {
        element('problem').textContent = error.message;
        element('problem').hidden = false;
        this.panel.say('The robot was not read.');
    }
}
