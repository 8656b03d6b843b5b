// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Keys while the picture has the focus: space pauses, . steps, r begins again, b throws a ball, c and j show contacts and joints; the arrows
// drive where there is something to drive, else they turn the view.
const kArrows = {ArrowUp: 'up', ArrowDown: 'down', ArrowLeft: 'left', ArrowRight: 'right'};
const kTurns = {up: [0, 0.1], down: [0, -0.1], left: [-0.1, 0], right: [0.1, 0]};

export class Keys {
    constructor(show, panel) {
        const actions = {' ': () => panel.pause(), '.': () => show.step_once(), r: () => show.restart(), b: () => show.hand.throw_ball(),
                         c: () => panel.toggle('contacts'), j: () => panel.toggle('joints')};
        this.down = new Set();
        show.canvas.addEventListener('keydown', event => {
            const arrow = kArrows[event.key], act = actions[event.key.toLowerCase()];
            if (event.ctrlKey || event.metaKey || event.altKey || !(arrow || act)) return;
            event.preventDefault();
            if (arrow) this.arrow(show, arrow); else act();
        });
        show.canvas.addEventListener('keyup', event => this.down.delete(kArrows[event.key]));
        show.canvas.addEventListener('blur', () => this.down.clear());
    }

    arrow(show, name) {
        this.down.add(name);
        if (show.simulation.hooks.driven) return;
        const [across, up] = kTurns[name];
        show.stage.turn(across, up);
    }

    // What a scene that is driven reads: 0 or 1 each.
    get state() {
        const held = name => this.down.has(name) ? 1 : 0;
        return {any: this.down.size > 0, up: held('up'), down: held('down'), left: held('left'), right: held('right')};
    }
}
