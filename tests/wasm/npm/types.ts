// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the declarations of the installed package must accept, and (ts-expect-error) must refuse: tsc --noEmit --strict.
import {load, type Body, type Contact, type Material, type Robot, type Sphere, type Vector3} from 'epode';

const engine = await load({onMessage: text => text.length});
const world = engine.createWorld({preset: 'robot', gravity: [0, 0, -1.62], hybridSubsteps: 8});
const body: Body = world.createBody({position: {x: 0, y: 0, z: 1}, kinematic: false});
const sphere: Sphere = body.createGeom('sphere', {radius: 0.5, density: 700, material: {bounce: 0.5, frictionRule: 'minimum'}});
const radius: number = sphere.radius, material: Material = sphere.material, place: Vector3 = body.position;
body.linearVelocity = new Float64Array([1, 2, 3]);
const hinge = world.createJoint('hinge', body, null, {anchor: [0, 0, 0], axis: [0, 1, 0]});
hinge.setParam('loStop', -1);
hinge.setDrive(0, {stiffness: 10});
const angle: number = hinge.angle;
world.step(1 / 60, 'exact');
world.contacts.forEach((contact: Contact) => contact.geom1?.body?.applyImpulse([0, 0, contact.depth], null));
const hit = world.rayClosest([0, 0, 5], [0, 0, -1], 10, {accept: geom => geom !== sphere});
const distance: number | undefined = hit?.distance;
const rows: Float64Array = world.createStates(world.bodies, ['position', 'enabled']).read();
const car = body.makeVehicle({kind: 'tracked'});
car.controls = {throttle: 1};
const walker = world.createGeom('character', {settings: {shape: 'cylinder'}, position: [0, 0, 0]});
const standing: boolean = walker.walk([1, 0, 0], 0, 1 / 60) === 'onGround';
const model = engine.robots.load({'arm.urdf': '<robot/>', 'a.stl': new Uint8Array(4)}, {path: 'arm.urdf', fixedBase: true, meshes: 'parts'});
const robot: Robot = model.build(world, {position: [0, 0, 1], positions: model.reference});
robot.controls = model.actuators.map(({low, high}) => Number.isFinite(low) ? low : high);
const coordinates: Float64Array = robot.positions, link: Body | null = robot.body('hand');
// @ts-expect-error meshes collide as hulls, triangles or parts
engine.robots.load('<robot/>', {meshes: 'soup'});

// @ts-expect-error a preset that there is not
engine.createWorld({preset: 'arcade'});
// @ts-expect-error a sphere has no lengths
body.createGeom('sphere', {lengths: [1, 1, 1]});
// @ts-expect-error a radius is wanted
body.createGeom('sphere', {});
// @ts-expect-error a ball joint has no axis
world.createJoint('ball', body, null, {axis: [0, 0, 1]});
// @ts-expect-error a number
body.mass = '5';
// @ts-expect-error a method that there is not
world.step(0.01, 'fast');
// @ts-expect-error read alone
body.isDestroyed = true;
export {angle, coordinates, distance, link, material, place, radius, rows, standing};
