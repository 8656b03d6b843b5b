// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The scenes of the playground, in the order of its menu. Each has a title, a sentence about itself, `sliders` (what is built depends on
// their values), a view {center, radius, direction}, and build(kit, values), which may return hooks:
//   before_step(h, time, simulation)   true: bodies were created or destroyed
//   set: {name: value => ...}          takes a slider's value as the scene runs
//   follow: body                       the view goes with it
//   robot: Robot                       of the package, built from files
//   driven: true                       the arrow keys, `simulation.keys`, drive something
//   water: {height(x, y, time), side}  is drawn as water
// A scene may ask for a rate of steps, Hz, in place of 60.
import {arch} from './arch.mjs';
import {boats} from './boats.mjs';
import {bridge} from './bridge.mjs';
import {buggy} from './buggy.mjs';
import {cradle} from './cradle.mjs';
import {dominoes} from './dominoes.mjs';
import {drum} from './drum.mjs';
import {pile} from './pile.mjs';
import {quadruped} from './quadruped.mjs';
import {ragdolls} from './ragdolls.mjs';
import {robot} from './robot.mjs';
import {ropes} from './ropes.mjs';
import {tops} from './tops.mjs';
import {tower} from './tower.mjs';
import {wall} from './wall.mjs';
import {wrecker} from './wrecker.mjs';

export const scenes = {wall, pile, ragdolls, buggy, quadruped, robot, tower, boats, bridge, ropes, dominoes, arch, cradle, wrecker, drum, tops};
