// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A robot from files: an arm at first, then what the visitor drops on the page. choose() reads it and gives the scene its sliders: one for
// each actuator of MJCF and each joint, or for each hinge and slider of a robot of URDF (whose transmissions are torques without a range) or without actuators.
import {slider} from './slider.mjs';

const kArm = `<mujoco model="arm">
  <option timestep="0.002"/>
  <default>
    <joint axis="0 1 0" damping="2" armature="0.1"/>
    <geom type="capsule" density="600"/>
    <position kp="300" kv="30" ctrlrange="-2 2"/>
  </default>
  <worldbody>
    <geom type="plane" size="5 5 1"/>
    <body pos="0 0 0.1">
      <geom type="cylinder" size="0.16 0.1"/>
      <joint name="turn" axis="0 0 1"/>
      <body pos="0 0 0.12">
        <joint name="shoulder"/>
        <geom fromto="0 0 0 0 0 0.5" size="0.06"/>
        <body pos="0 0 0.5">
          <joint name="elbow"/>
          <geom fromto="0 0 0 0 0 0.4" size="0.05"/>
          <body pos="0 0 0.44">
            <joint name="wrist"/>
            <geom type="box" size="0.03 0.09 0.03" pos="0 0 0.03"/>
            <body pos="0 0.07 0.06">
              <joint name="left" type="slide" axis="0 1 0" range="-0.05 0.02"/>
              <geom type="box" size="0.02 0.012 0.06" pos="0 0 0.06"/>
            </body>
            <body pos="0 -0.07 0.06">
              <joint name="right" type="slide" axis="0 1 0" range="-0.02 0.05"/>
              <geom type="box" size="0.02 0.012 0.06" pos="0 0 0.06"/>
            </body>
          </body>
        </body>
      </body>
    </body>
    <body pos="0.5 0 0.06"><freejoint/><geom type="box" size="0.05 0.05 0.06" density="300"/></body>
    <body pos="0.55 0.3 0.06"><freejoint/><geom type="sphere" size="0.06" density="300"/></body>
  </worldbody>
  <actuator>
    <position name="turn" joint="turn"/>
    <position name="shoulder" joint="shoulder"/>
    <position name="elbow" joint="elbow"/>
    <position name="wrist" joint="wrist"/>
    <position name="left" joint="left" ctrlrange="-0.05 0.02"/>
    <position name="right" joint="right" ctrlrange="-0.02 0.05"/>
  </actuator>
</mujoco>`;
const kAbout = 'Drop a URDF or MJCF file with its meshes, or its folder, on the page: every actuator has a slider.';
const kRate = 240, kMaxRate = 1000, kFrequency = 5;  // Hz; the last of the springs that pull the joints of robots without actuators
const kMostSliders = 64, kDefault = {'arm.xml': kArm};
const models = new WeakMap();  // by engine
let chosen = {files: kDefault, options: {}};

const of_range = (name, low, high, value, unit = '') => {
    const [from, to] = [Number.isFinite(low) ? low : -1, Number.isFinite(high) ? high : 1], first = Math.min(to, Math.max(from, value));
    return slider(unit ? `${name}, ${unit}` : name, from, to, (to - from) / 200 || 1, first);
};

function model_of(engine) {
    const had = models.get(engine);
    if (had?.chosen === chosen) return had.model;
    const model = engine.robots.load(chosen.files, chosen.options);
    had?.model.destroy();
    models.set(engine, {chosen, model});
    return model;
}

const driven_joints = model => model.joints.map((joint, i) => ({...joint, i})).filter(({kind}) => kind === 'hinge' || kind === 'slide');

function is_urdf() {
    const {files, options} = chosen;
    return options.path !== undefined && /<robot[\s>]/.test(new TextDecoder().decode(files.get(options.path)));
}
const has_controls = model => model.actuators.length > 0 && !is_urdf();

// A hinge or slider is put where its slider says, and goes on from there; at first it is where the robot begins.
const places_of = model => driven_joints(model).map(({name, kind, low, high, position, i}) => {
    const full = kind === 'hinge' ? Math.PI : 1, begin = model.reference[position];
    return [`p${i}`, of_range(name || `joint ${i}`, Number.isFinite(low) ? low : begin - full, Number.isFinite(high) ? high : begin + full, begin, kind === 'hinge' ? 'rad' : 'm')];
});

// The mean of the range for a position actuator's control would move the robot at once: controls begin at 0, joints where they are.
function sliders_of(model) {
    const rows = has_controls(model)
        ? [...model.actuators.map(({name, low, high}, i) => [`u${i}`, of_range(name || `actuator ${i}`, low, high, 0)]), ...places_of(model)]
        : driven_joints(model).map(({name, kind, low, high, position, i}) => {
            const full = kind === 'hinge' ? Math.PI : 1, begin = model.reference[position];
            return [`q${i}`, of_range(name, Number.isFinite(low) ? low : begin - full, Number.isFinite(high) ? high : begin + full, begin, kind === 'hinge' ? 'rad' : 'm')];
        });
    return Object.fromEntries(rows.slice(0, kMostSliders));
}

// Each joint is pulled as the mass that it moves wants it.
function drive_of(model) {
    const mass = model.massMatrix(model.reference), rate = 2 * Math.PI * kFrequency;
    const first = model.joints.map(() => 0);
    model.joints.reduce((at, {kind}, i) => ((first[i] = at), at + ({ball: 3, free: 6}[kind] ?? 1)), 0);
    return i => {
        const inertia = mass[first[i] * (model.velocityCount + 1)];
        return {stiffness: inertia * rate * rate, damping: 2 * inertia * rate};
    };
}

// Of all that is built: [lowest, highest] corner, without planes.
function box_of(geoms) {
    const boxes = geoms.map(geom => geom.aabb).filter(box => box.every(Number.isFinite));
    const side = (k, best) => boxes.length > 0 ? best(...boxes.map(box => box[k])) : 0;
    return [[0, 2, 4].map(k => side(k, Math.min)), [1, 3, 5].map(k => side(k, Math.max))];
}

// Where a robot of URDF stands on the floor; files of MJCF have their own.
function place_of(kit, model) {
    const robot = model.build(kit.world), [low] = box_of(kit.world.geoms);
    robot.destroy();
    return [0, 0, model.joints.some(({kind}) => kind === 'free') ? 0.002 - low[2] : Math.max(0, -low[2])];
}

// Height fields have no triangles to draw; what stands still is light.
function color_of(geom, {bodies}) {
    if (geom.constructor.kind === 'heightfield') return null;
    const link = bodies.indexOf(geom.body);
    return link > 0 ? link % 6 : 7;
}

export const robot = {
    title: 'Your robot',
    about: kAbout,
    sliders: {
        u0: slider('turn', -2, 2, 0.02, 0), u1: slider('shoulder', -2, 2, 0.02, 0.6), u2: slider('elbow', -2, 2, 0.02, 0.9),
        u3: slider('wrist', -2, 2, 0.02, 0.7), u4: slider('left', -0.05, 0.02, 0.001, 0), u5: slider('right', -0.02, 0.05, 0.001, 0),
    },
    view: {center: [0.1, 0, 0.5], radius: 1, direction: [0.5, -0.85, 0.3]},
    world: {preset: 'robot'},
    rate: 500,
    build(kit, values) {
        const model = model_of(kit.engine), {world} = kit, own_floor = model.links[0].shapes > 0 && !is_urdf();
        world.gravity = model.gravity;
        const made = model.build(world, own_floor ? {} : {position: place_of(kit, model)}), drive = has_controls(model) ? null : drive_of(model);
        world.geoms.forEach(geom => kit.colored(geom, color_of(geom, made)));
        if (!own_floor) kit.floor();
        const set = {};
        const put = (i, value) => {
            const {positions, velocities} = made, joint = model.joints[i];
            positions[joint.position] = value;
            made.positions = positions;
            made.velocities = velocities;
        };
        for (const [name, {value: first}] of Object.entries(robot.sliders)) {
            const i = Number(name.slice(1));
            if (name[0] === 'p') {
                set[name] = value => put(i, value);
                if (values[name] !== first) put(i, values[name]);
                continue;
            }
            set[name] = drive ? value => made.setTarget(i, value, drive(i)) : value => made.setControl(i, value);
            set[name](values[name]);
        }
        return {set, robot: made, before_step: h => { made.addForces(h); }};
    },
};

/**
 * Reads another robot. Throws, and the one before stays, where its files are at fault.
 * files: a map of paths, or the arm's of the beginning; options: robots.load's. Returns the model.
 */
export function choose(engine, files = kDefault, options = {}) {
    const before = chosen;
    chosen = {files, options};
    try {
        const model = model_of(engine), lines = model.report.filter(({note}) => note !== 'changed');
        const world = engine.createWorld({preset: 'robot'}), made = model.build(world), [low, high] = box_of(world.geoms.filter(geom => geom.body));
        made.destroy();
        world.destroy();
        Object.assign(robot, {
            sliders: sliders_of(model), rate: Math.min(kMaxRate, model.stepsize > 0 ? Math.round(1 / model.stepsize) : kRate), view: view_of(low, high),
            title: 'Your robot',
            about: `${counted(model.links.length - 1, 'link')}, ${counted(model.joints.length, 'joint')}, ${counted(model.actuators.length, 'actuator')}.` +
                (lines.length > 0 ? ` Of the files, ${counted(lines.length, 'line')} ${lines.length > 1 ? 'are' : 'is'} read as something near or left out; the first: line ${lines[0].line}, ${lines[0].text}.` : ''),
        });
        return model;
    } catch (error) {
        chosen = before;
        throw error;
    }
}

const counted = (count, noun) => `${count} ${noun}${count === 1 ? '' : 's'}`;

function view_of(low, high) {
    const radius = Math.max(0.05, 0.75 * Math.hypot(...high.map((x, k) => x - low[k])));
    return {center: low.map((x, k) => 0.5 * (x + high[k])), radius, direction: robot.view.direction};
}
