// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds that C has made: from a file's bytes or by a clone. Their bodies, joints and geoms get objects here.
import {Body} from './body.mjs';
import * as geoms from './geoms.mjs';
import * as joints from './joints.mjs';
import {Joint} from './joint.mjs';
import {Geom} from './geom.mjs';
import {enums} from './enums.mjs';
import {name_of} from './checks.mjs';
import {World} from './world.mjs';
import {bytes_of, with_bytes} from './states.mjs';
/** @import {Engine} from './engine.mjs' */
/** @import {Handle} from './handle.mjs' */

const kGeomClasses = /** @type {{[name: string]: any}} */ ({
    dSphereClass: geoms.Sphere, dBoxClass: geoms.Box, dCapsuleClass: geoms.Capsule, dCylinderClass: geoms.Cylinder, dPlaneClass: geoms.Plane,
    dConvexClass: geoms.Convex, dTriMeshClass: geoms.TriMesh, dHeightfieldClass: geoms.Heightfield, dConeClass: geoms.Cone,
    dEllipsoidClass: geoms.Ellipsoid, dTaperedCapsuleClass: geoms.TaperedCapsule,
});
const kFirstSpace = 'dFirstSpaceClass', kLastSpace = 'dLastSpaceClass';

/** @param {Engine} e @param {number} pointer */
function geom_class(e, pointer) {
    if (e.c.dGeomIsCharacter(pointer)) return geoms.Character;
    const number = e.c.dGeomGetClass(pointer);
    return Object.entries(kGeomClasses).find(([name]) => e.c[name] === number)?.[1] ?? Geom;
}

/** @param {Engine} e @param {number} pointer */
function joint_class(e, pointer) {
    const kind = name_of(enums.JointKind, e.c.dJointGetType(pointer));
    return Object.values(joints).find(one => one.kind === kind) ?? Joint;
}

/** Geoms of a space and of spaces in it. @param {Engine} e @param {number} space @returns {number[]} */
function geoms_of(e, space) {
    const all = Array.from({length: e.c.dSpaceGetNumGeoms(space)}, (_, i) => e.c.dSpaceGetGeom(space, i));
    return all.flatMap(pointer => {
        const number = e.c.dGeomGetClass(pointer);
        return number >= e.c[kFirstSpace] && number <= e.c[kLastSpace] ? geoms_of(e, pointer) : [pointer];
    });
}

/** @param {Engine} e @param {string} name @param {number} world @returns {number[]} */
function handles_of(e, name, world) {
    const count = e.c[name](world, 0, 0), at = e.buffer(4 * count);
    e.c[name](world, at, count);
    return Array.from(e.c.ints(at, count), handle => handle >>> 0);
}

/**
 * The handles of all that a world has: bodies, joints, then geoms.
 * @param {World} world
 * @returns {{bodies: number[], joints: number[], geoms: number[]}}
 */
export function contents_of(world) {
    const e = world.engine, {handle} = world;
    return {bodies: handles_of(e, 'dWorldGetBodies', handle), joints: handles_of(e, 'dWorldGetJoints', handle), geoms: geoms_of(e, world.space)};
}

/**
 * Makes objects for what a world has and JavaScript does not know.
 * @param {World} world
 * @param {boolean} owns whether the data of meshes and height fields end with their last geom
 */
export function adopt_contents(world, owns = true) {
    const e = world.engine, {bodies, joints: all, geoms: solids} = contents_of(world), is_new = (/** @type {number} */ p) => !e.objects.has(p);
    for (const pointer of bodies.filter(is_new)) world.begun(new Body(world, pointer));
    for (const pointer of all.filter(is_new)) world.begun(new (joint_class(e, pointer))(world, pointer));
    for (const pointer of solids.filter(is_new)) world.begun(new (geom_class(e, pointer))(world, pointer, owns ? shared_of(e, pointer) : undefined));
}

/** The data of a mesh or height field, which one object of JavaScript owns. @param {Engine} e @param {number} pointer */
function shared_of(e, pointer) {
    const number = e.c.dGeomGetClass(pointer), {c} = e;
    const [data, free] = number === c.dTriMeshClass ? [c.dGeomTriMeshGetData(pointer), 'dGeomTriMeshDataDestroy']
        : number === c.dHeightfieldClass ? [c.dGeomHeightfieldGetHeightfieldData(pointer), 'dGeomHeightfieldDataDestroy'] : [0, ''];
    if (!data) return undefined;
    const known = [...e.objects.values()].find(one => one instanceof Geom && one.shared?.data === data);
    return /** @type {Geom | undefined} */ (known)?.shared ?? {users: 0, data, free: () => c[free](data)};
}

/**
 * Creates the world that World.save() has written.
 * @param {Engine} e
 * @param {Uint8Array} bytes
 * @returns {World}
 */
export function adopt(e, bytes) {
    const label = 'Engine.loadWorld', given = bytes_of(bytes, label, 'bytes');
    const pointer = with_bytes(e, [given], at => e.c.dWorldLoadFromBuffer(at, given.length, e.base));
    e.check(label);
    const world = new World(e, pointer);
    ensure_space(world, e.i32[e.base >> 2] >>> 0);
    adopt_contents(world);
    return world;
}

/** A world here has a space. @param {World} world @param {number} space */
function ensure_space(world, space) {
    const e = world.engine;
    if (!world.space) e.c.dWorldSetContactSpace(world.handle, space || e.c.dHashSpaceCreate(0));
}

/**
 * A world like another one, in the same state.
 * @param {World} world
 * @returns {World}
 */
export function clone(world) {
    const e = world.engine, label = 'World.clone', {handle, space} = world, count = e.c.dWorldCountHandles(handle, space), table = e.c.malloc(8 * count);
    try {
        e.i32[e.base >> 2] = space;
        const made = new World(e, e.c.dWorldClone(handle, e.base, table, count));
        e.check(label);
        adopt_contents(made);
        for (let i = 0; i < count; ++i) keep_data(e, table + 8 * i);
        return made;
    } finally {
        e.c.free(table);
    }
}

/** The program's data go with the copy. @param {Engine} e @param {number} row of a handle and its copy's */
function keep_data(e, row) {
    const original = e.object_at(e.i32[row >> 2] >>> 0), copy = e.object_at(e.i32[(row >> 2) + 1] >>> 0);
    if (original && copy) copy.userData = original.userData;
}
