// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// New geoms: what sizes each shape has, how C makes it, and what it weighs.
import {flag, int32, numbers, real, refuse, uint32, vector} from './checks.mjs';
import {EpodeError} from './errors.mjs';
import {Box, Capsule, Character, Cone, Convex, Cylinder, Ellipsoid, Heightfield, Plane, Sphere, TaperedCapsule, TriMesh} from './geoms.mjs';
import {assign, checked_options, finished} from './options.mjs';
import {prepare_structure, put_structure, size_of} from './structures.mjs';
/** @import {Engine} from './engine.mjs' */
/** @import {World} from './world.mjs' */
/** @import {Body} from './body.mjs' */
/** @import {Geom, Shared} from './geom.mjs' */
/** @import {GeomKinds, GeomKindOptions} from './geoms.mjs' */
/** @import {GeomOptions} from './methods.mjs' */
/** @import {VectorLike} from './checks.mjs' */
/** @import {CharacterSettings} from './fields.mjs' */

/** Sizes of the shapes, in m. Lengths of capsules are without the caps; capsules, cylinders and cones stand along z.
 * @typedef {object} ShapeSizes
 * @property {{radius: number}} sphere
 * @property {{lengths: VectorLike}} box the whole sides
 * @property {{normal: VectorLike, distance?: number}} plane everything below it is solid; distance: of the plane from the origin along the normal
 * @property {{radius: number, length: number}} capsule
 * @property {{radius: number, length: number}} cylinder
 * @property {{radius: number, length: number}} cone its centre of mass is the origin
 * @property {{radii: VectorLike}} ellipsoid
 * @property {{radius1: number, radius2: number, length: number}} taperedCapsule
 * @property {{points: ArrayLike<number>, maxVertices?: number}} convex the convex hull of points, three numbers each
 * @property {{vertices: ArrayLike<number>, indices: ArrayLike<number>}} triMesh vertices of three numbers, triangles of three indices
 * @property {HeightfieldSizes} heightfield
 * @property {{settings?: Partial<CharacterSettings>}} character */

/** A grid of heights over x and z of the geom's own frame, its up is y.
 * @typedef {object} HeightfieldSizes
 * @property {ArrayLike<number>} heights of the samples, those along the width follow each other
 * @property {number} widthSamples
 * @property {number} depthSamples
 * @property {number} width m
 * @property {number} depth m
 * @property {number} [thickness] m, below the lowest sample; 1
 * @property {boolean} [wrap] whether it repeats; false */

/** @typedef {object} NewGeomOptions
 * @property {number} [density] kg/m^3, of a body's solid geom; 1000, but 0 for meshes and where Body.massProperties or Body.mass was set
 * @property {number} [mass] kg, in place of a density */

/** @typedef {{pointer: number, shared?: Shared}} Made shared: data in C that the geom has */
/** @typedef {object} Shape
 * @property {any} of the class
 * @property {string[]} sizes
 * @property {(e: Engine, space: number, s: any, label: string) => Made} make
 * @property {(e: Engine, mass: number, density: number, geom: any) => void} [weigh]
 * @property {boolean} [in_space] is made in the space that it moves in
 * @property {boolean} [light] has no density unless one is given */

const kUp = 3;  // C's number of the z axis
const kPose = ['position', 'rotation', 'quaternion'], kOffset = ['offsetPosition', 'offsetRotation', 'offsetQuaternion'];
const round = (/** @type {any} */ of, /** @type {string} */ create, /** @type {string} */ weigh) => /** @type {Shape} */ ({
    of, sizes: ['radius', 'length'],
    make: (e, space, s, label) => ({pointer: e.c[create](space, real(s.radius, label, 'radius'), real(s.length, label, 'length'))}),
    weigh: (e, mass, density, geom) => e.c[weigh](mass, density, kUp, geom.params.radius, geom.params.length),
});

/** @type {{[kind: string]: Shape}} */
export const shapes = {
    sphere: {
        of: Sphere, sizes: ['radius'],
        make: (e, space, s, label) => ({pointer: e.c.dCreateSphere(space, real(s.radius, label, 'radius'))}),
        weigh: (e, mass, density, geom) => e.c.dMassSetSphere(mass, density, geom.radius),
    },
    box: {
        of: Box, sizes: ['lengths'],
        make: (e, space, s, label) => ({pointer: e.c.dCreateBox(space, ...vector(s.lengths, label, 'lengths'))}),
        weigh: (e, mass, density, geom) => e.c.dMassSetBox(mass, density, ...geom.lengths),
    },
    plane: {
        of: Plane, sizes: ['normal', 'distance'],
        make: (e, space, s, label) => ({pointer: e.c.dCreatePlane(space, ...unit(s.normal, label), real(s.distance ?? 0, label, 'distance'))}),
    },
    capsule: round(Capsule, 'dCreateCapsule', 'dMassSetCapsule'),
    cylinder: round(Cylinder, 'dCreateCylinder', 'dMassSetCylinder'),
    cone: round(Cone, 'dCreateCone', 'dMassSetCone'),
    ellipsoid: {
        of: Ellipsoid, sizes: ['radii'],
        make: (e, space, s, label) => ({pointer: e.c.dCreateEllipsoid(space, ...vector(s.radii, label, 'radii'))}),
        weigh: (e, mass, density, geom) => e.c.dMassSetEllipsoid(mass, density, ...geom.radii),
    },
    taperedCapsule: {
        of: TaperedCapsule, sizes: ['radius1', 'radius2', 'length'],
        make: (e, space, s, label) => ({pointer: e.c.dCreateTaperedCapsule(
            space, real(s.radius1, label, 'radius1'), real(s.radius2, label, 'radius2'), real(s.length, label, 'length'))}),
        weigh: (e, mass, density, geom) => e.c.dMassSetTaperedCapsule(mass, density, kUp, geom.params.r1, geom.params.r2, geom.params.length),
    },
    convex: {
        of: Convex, sizes: ['points', 'maxVertices'], make: make_convex,
        weigh: (e, mass, density, geom) => e.c.dMassSetConvex(mass, density, geom.handle),
    },
    triMesh: {
        of: TriMesh, sizes: ['vertices', 'indices'], light: true, make: make_mesh,
        weigh: (e, mass, density, geom) => e.c.dMassSetTrimesh(mass, density, geom.handle),
    },
    heightfield: {of: Heightfield, sizes: ['heights', 'widthSamples', 'depthSamples', 'width', 'depth', 'thickness', 'wrap'], make: make_field},
    character: {
        of: Character, sizes: ['settings'], in_space: true,
        make: (e, space, s, label) => ({pointer: e.c.dCharacterCreate(
            space, put_structure(e, 'dCharacterSettings', s.settings ?? null, e.buffer(size_of('dCharacterSettings')), label))}),
    },
};

/** @param {unknown} normal @param {string} label */
function unit(normal, label) {
    const n = vector(normal, label, 'normal'), length = Math.hypot(...n);
    if (!(length > 0 && length < Infinity)) refuse(label, 'normal', 'a vector of finite length above 0', normal);
    return n.map(x => x / length);
}

/** @param {Engine} e @param {number} space @param {any} s @param {string} label @returns {Made} */
function make_convex(e, space, s, label) {
    const points = numbers(s.points, -1, label, 'points'), limit = uint32(s.maxVertices ?? 0, label, 'maxVertices');
    if (points.length % 3) throw new TypeError(`${label}: points must have three numbers each`);
    const at = e.buffer(8 * points.length);
    e.f64.set(points, at >> 3);
    return {pointer: e.c.dCreateConvexHull(space, at, points.length / 3, limit)};
}

/** @param {Engine} e @param {number} space @param {any} s @param {string} label @returns {Made} */
function make_mesh(e, space, s, label) {
    const vertices = numbers(s.vertices, -1, label, 'vertices'), indices = numbers(s.indices, -1, label, 'indices');
    if (vertices.length % 3 || indices.length % 3) throw new TypeError(`${label}: vertices and indices must come in threes`);
    const count = vertices.length / 3, bad = indices.find(i => !(Number.isInteger(i) && i >= 0 && i < count));
    if (bad !== undefined) throw new TypeError(`${label}: indices must be integers below ${count}, not ${bad}`);
    const at = e.buffer(8 * vertices.length + 4 * indices.length), {c} = e;
    e.f64.set(vertices, at >> 3);
    e.i32.set(indices, (at >> 2) + 2 * vertices.length);
    const data = c.dGeomTriMeshDataCreate(), shared = {users: 0, data, free: () => c.dGeomTriMeshDataDestroy(data)};
    c.dGeomTriMeshDataBuildDouble(data, at, 24, count, at + 8 * vertices.length, indices.length, 12);
    return {pointer: c.dCreateTriMesh(space, data, 0, 0, 0), shared};
}

/** @param {Engine} e @param {number} space @param {any} s @param {string} label @returns {Made} */
function make_field(e, space, s, label) {
    const wide = int32(s.widthSamples, label, 'widthSamples'), deep = int32(s.depthSamples, label, 'depthSamples');
    if (wide < 2 || deep < 2) throw new TypeError(`${label}: a height field has at least two samples each way`);
    const heights = numbers(s.heights, wide * deep, label, 'heights');
    const sizes = [real(s.width, label, 'width'), real(s.depth, label, 'depth')], thickness = real(s.thickness ?? 1, label, 'thickness');
    const at = e.buffer(8 * heights.length), wrap = flag(s.wrap ?? false, label, 'wrap'), {c} = e;
    e.f64.set(heights, at >> 3);
    const data = c.dGeomHeightfieldDataCreate(), shared = {users: 0, data, free: () => c.dGeomHeightfieldDataDestroy(data)};
    c.dGeomHeightfieldDataBuildDouble(data, at, 1, ...sizes, wide, deep, 1, 0, thickness, wrap);
    return {pointer: c.dCreateHeightfield(space, data, 1), shared};
}

/**
 * Makes a geom for a world, or for a body of it.
 * @param {World} world
 * @param {Body | null} body
 * @param {string} kind
 * @param {unknown} options
 * @returns {any}
 */
export function create_geom(world, body, kind, options) {
    const e = world.engine, label = `createGeom(${typeof kind === 'string' ? `'${kind}'` : typeof kind})`;
    if (typeof kind !== 'string' || !Object.hasOwn(shapes, kind)) refuse(label, 'kind', `one of ${Object.keys(shapes).join(', ')}`, kind);
    const shape = shapes[kind], own = [...shape.sizes, 'density', 'mass'], name = kind[0].toUpperCase() + kind.slice(1);
    const given = checked_options(options, ['Geom', name], own, label), misplaced = (body ? kPose : kOffset).find(name => name in given);
    if (misplaced) throw new TypeError(`${label}: ${misplaced} is not for a geom ${body ? 'of a body; its place is an offset' : 'without a body'}`);
    const handle = body?.handle ?? 0;
    // The world's space learns of it last: one that is refused would leave word there that something has been disturbed.
    const space = shape.in_space ? world.space : 0, {pointer, shared} = shape.make(e, space, given, label);
    try {
        e.check(label);
    } catch (error) {
        if (pointer) e.c.dGeomDestroy(pointer);
        shared?.free();
        throw error;
    }
    const made = world.begun(new shape.of(world, pointer, shared));
    return finished(made, () => {
        if (handle) e.c.dGeomSetBody(pointer, handle);
        e.check(label);
        assign(made, given, own);
        add_mass(body, made, shape, given, label);
        if (space === 0) e.c.dSpaceAdd(world.space, pointer);
        e.check(label);
    });
}

/** @param {Body | null} body @param {any} geom @param {Shape} shape @param {{[name: string]: any}} given @param {string} label */
function add_mass(body, geom, shape, given, label) {
    const stated = given.density !== undefined || given.mass !== undefined;
    if (stated && !(body && shape.weigh)) throw new EpodeError('refused', `${label}: only a body's solids have a density or mass`);
    if (!body || !shape.weigh || (!stated && (shape.light || body.weighs_by_itself))) return;
    const e = geom.engine, mass = prepare_structure(e, 'dMass', e.buffer(size_of('dMass')));
    const density = given.mass === undefined ? real(given.density ?? 1000, label, 'density') : 1, wanted = real(given.mass ?? 1, label, 'mass');
    if (density === 0) return;
    if (!(density > 0 && density < Infinity && wanted > 0 && wanted < Infinity))
        throw new EpodeError('refused', `${label}: a density or mass must be finite and above 0`);
    shape.weigh(e, mass, density, geom);
    if (given.mass !== undefined) e.c.dMassAdjust(mass, wanted);
    e.check(label);
    body.add_mass(mass, geom, label);
}
