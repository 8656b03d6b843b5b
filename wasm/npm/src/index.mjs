// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The package: load() gives an Engine, which creates worlds. The other classes are here for instanceof and types.
export {load, Engine} from './engine.mjs';
export {World} from './world.mjs';
export {Body} from './body.mjs';
export {Vehicle} from './vehicle.mjs';
export {Joint} from './joint.mjs';
export * from './joints.mjs';
export {Geom} from './geom.mjs';
export * from './geoms.mjs';
export {BodyStates, Snapshot} from './states.mjs';
export {EpodeError} from './errors.mjs';
export {RobotError, Robots} from './robots.mjs';
export {RobotModel} from './robot_model.mjs';
export {Robot} from './robot.mjs';
/** @typedef {import('./engine.mjs').LoadOptions} LoadOptions */
/** @typedef {import('./queries.mjs').Filter} Filter */
/** @typedef {import('./world.mjs').WorldOptions} WorldOptions */
/** @typedef {import('./world.mjs').NewBodyOptions} BodyOptions */
/** @typedef {import('./fields.mjs').Material} Material */
/** @typedef {import('./fields.mjs').Contact} Contact */
/** @typedef {import('./fields.mjs').ContactEvent} ContactEvent */
/** @typedef {import('./fields.mjs').QueryHit} QueryHit */
/** @typedef {import('./fields.mjs').Drive} Drive */
/** @typedef {import('./fields.mjs').CharacterSettings} CharacterSettings */
/** @typedef {import('./fields.mjs').VehicleSettings} VehicleSettings */
/** @typedef {import('./fields.mjs').VehicleWheel} VehicleWheel */
/** @typedef {import('./robots.mjs').RobotOptions} RobotOptions */
/** @typedef {import('./robot_model.mjs').ReportLine} ReportLine */
/** @typedef {import('./robot_model.mjs').RobotLink} RobotLink */
/** @typedef {import('./robot_model.mjs').RobotJoint} RobotJoint */
/** @typedef {import('./robot_model.mjs').RobotActuator} RobotActuator */
/** @typedef {import('./checks.mjs').VectorLike} VectorLike */
/** @typedef {import('./checks.mjs').Vector3} Vector3 */
/** @typedef {import('./checks.mjs').Quaternion} Quaternion */
