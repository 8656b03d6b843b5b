// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a link says after its #: the scene, the values of its sliders that are not the first ones, and the stepper.
import {scenes} from './scenes/all.mjs';
import {kMethods, values_of} from './simulation.mjs';

export function read_link(fragment) {
    const given = new URLSearchParams(fragment.replace(/^#/, '')), wanted = given.get('scene') ?? '';
    const scene = Object.hasOwn(scenes, wanted) ? wanted : Object.keys(scenes)[0], method = given.get('stepper') ?? '';
    return {scene, values: values_of(scene, Object.fromEntries(given)), method: kMethods.includes(method) ? method : kMethods[0]};
}

export function link_of({scene, values, method}) {
    const changed = Object.entries(scenes[scene].sliders).filter(([name, {value}]) => values[name] !== value).map(([name]) => [name, String(values[name])]);
    return `#${new URLSearchParams([['scene', scene], ...changed, ...(method === kMethods[0] ? [] : [['stepper', method]])])}`;
}
