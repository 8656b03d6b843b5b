// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots from files: URDF and MJCF, from their text and that of the files that they name.
import {ask} from './ask.mjs';
import {flag, options_of, real, refuse, shown} from './checks.mjs';
import {EpodeError} from './errors.mjs';
import {RobotModel} from './robot_model.mjs';
/** @import {Engine} from './engine.mjs' */
/** @import {ReportLine} from './robot_model.mjs' */

/** A file's text or bytes. @typedef {string | Uint8Array | ArrayBuffer} FileContent */
/** Files by their paths, with `/`. @typedef {{[path: string]: FileContent} | Map<string, FileContent>} FileMap */

/** @typedef {object} RobotOptions
 * @property {string} [path] of the robot's own file among the files; where it is not given: the only one that none of the others includes
 * @property {boolean} [strict] what is approximated or left out is an error; false
 * @property {boolean} [keepFixed] links that are fixed to others stay links; false
 * @property {boolean} [fixedBase] the root link of a URDF is fixed to the world; false
 * @property {boolean} [repair] inertias that no body can have are mended; false
 * @property {boolean} [inertiaFromShapes] moving links without a mass get that of their shapes, 1000 kg/m^3; false
 * @property {number} [missingMass] of other moving links without a mass, kg; 0: such a link is an error
 * @property {'hulls' | 'triangles' | 'parts'} [meshes] how meshes collide: as their convex hulls, as triangles, as several hulls each; 'hulls' */

const kFolder = '/files', kOwn = 'robot.xml';
const kFlags = {strict: 'strict', keepFixed: 'keep_fixed', fixedBase: 'fixed_base', repair: 'repair', inertiaFromShapes: 'inertia_from_shapes'};
const kMeshes = ['hulls', 'triangles', 'parts'];
const kNames = [...Object.keys(kFlags), 'path', 'missingMass', 'meshes'];

/** What is wrong with a robot's file: `report` has every line of it. */
export class RobotError extends EpodeError {
    /**
     * @param {string} message
     * @param {ReportLine[]} report
     */
    constructor(message, report) {
        super('refused', message);
        /** @readonly What the reader has noted, with file and line. */
        this.report = report;
    }
}

/** Reads robots' files. `engine.robots` is one, where load({robots: true}) has loaded the engine. */
export class Robots {
    #engine;

    /**
     * For the package alone.
     * @param {Engine} engine
     */
    constructor(engine) { this.#engine = engine; }

    /**
     * Reads a robot. What is wrong in its files throws a RobotError, whose message says file, line and fault.
     * @param {FileContent | FileMap} files the robot's text, or it and the meshes and files that it includes, by their paths
     * @param {RobotOptions} [options]
     * @returns {RobotModel}
     */
    load(files, options = {}) {
        const label = 'robots.load', given = options_of(options, kNames, label), held = held_files(files, label), e = this.#engine;
        const path = given.path === undefined ? only_main(held, label) : plain_path(given.path, label), {c} = e;
        if (!held.has(path)) throw new TypeError(`${label}: path must be one of the files, not ${shown(given.path)}`);
        const at = put_options(e, given, label), name = c.new_string(`${kFolder}/${path}`);
        try {
            const {result, said} = ask(e, label, () => {
                for (const [file, bytes] of held) c.hold_file(`${kFolder}/${file}`, bytes);
                return c.dRobotModelLoad(name, at.pointer);
            });
            if (!result) throw new EpodeError('refused', `${label}: ${said[0] ?? 'refused'}`);
            return checked(new RobotModel(e, result >>> 0));
        } finally {
            c.drop_files();
            for (const pointer of [name, at.pointer, at.roots]) c.free(pointer);
        }
    }

    /**
     * The files that may be a robot's own: those with a root element of URDF or MJCF that no other of them includes.
     * @param {FileMap} files
     * @returns {string[]}
     */
    mainFiles(files) { return main_files(held_files(files, 'robots.mainFiles')); }
}

/** @param {RobotModel} model */
function checked(model) {
    const {report} = model, wrong = report.find(line => line.note === 'error');
    if (!wrong) return model;
    model.destroy();
    throw new RobotError(`${wrong.file}${wrong.line > 0 ? `:${wrong.line}` : ''}: ${wrong.text}`, report);
}

/** @param {unknown} path @param {string} label @returns {string} */
function plain_path(path, label) {
    if (typeof path !== 'string' || path === '' || path.includes('\0')) return refuse(label, 'path', 'the path of a file', path);
    const parts = /** @type {string[]} */ ([]);
    for (const part of path.replaceAll('\\', '/').split('/')) {
        if (part === '..' && parts.pop() === undefined) refuse(label, 'path', 'a path that leads out of no folder', path);
        if (part !== '' && part !== '.' && part !== '..') parts.push(part);
    }
    return parts.join('/');
}

/** @param {unknown} content @param {string} label @param {string} name @returns {Uint8Array} */
function bytes_of(content, label, name) {
    if (typeof content === 'string') return new TextEncoder().encode(content);
    if (content instanceof ArrayBuffer) return new Uint8Array(content);
    return content instanceof Uint8Array ? content : refuse(label, name, 'text or bytes', content);
}

/** @param {unknown} files @param {string} label @returns {Map<string, Uint8Array>} */
function held_files(files, label) {
    if (typeof files === 'string' || files instanceof Uint8Array || files instanceof ArrayBuffer) return new Map([[kOwn, bytes_of(files, label, 'files')]]);
    if (typeof files !== 'object' || files === null || Array.isArray(files)) return refuse(label, 'files', 'a text, bytes, or an object of files', files);
    const rows = files instanceof Map ? [...files] : Object.entries(files);
    return new Map(rows.map(([path, content]) => [plain_path(path, label), bytes_of(content, label, String(path))]));
}

const text_of = (/** @type {Uint8Array} */ bytes) => new TextDecoder().decode(bytes).replace(/<!--[^]*?-->/g, '');
const last_of = (/** @type {string} */ path) => path.slice(path.lastIndexOf('/') + 1);

/** @param {Map<string, Uint8Array>} held @returns {string[]} */
function main_files(held) {
    const texts = [...held].filter(([path]) => /\.(urdf|xml|mjcf)$/i.test(path)).map(([path, bytes]) => /** @type {[string, string]} */ ([path, text_of(bytes)]));
    const included = new Set(texts.flatMap(([, text]) => [...text.matchAll(/<(?:include|model)\b[^>]*?\bfile\s*=\s*["']([^"']+)/g)].map(found => last_of(found[1]))));
    const roots = texts.filter(([, text]) => /^[^<]*(?:<[?!][^>]*>[^<]*)*<(?:robot|mujoco)\b/.test(text)).map(([path]) => path);
    const free = roots.filter(path => !included.has(last_of(path)));
    return free.length > 0 ? free : roots;
}

/** @param {Map<string, Uint8Array>} held @param {string} label @returns {string} */
function only_main(held, label) {
    if (held.size === 1) return /** @type {string} */ (held.keys().next().value);
    const found = main_files(held);
    if (found.length === 1) return found[0];
    throw new TypeError(`${label}: path must say which file is the robot's: ${found.length === 0 ? 'none is URDF or MJCF' : found.join(', ')}`);
}

/** @param {Engine} e @param {{[name: string]: any}} given @param {string} label @returns {{pointer: number, roots: number}} */
function put_options(e, given, label) {
    const fields = /** @type {{[name: string]: number}} */ ({});
    for (const [name, field] of Object.entries(kFlags)) if (given[name] !== undefined) fields[field] = flag(given[name], label, name);
    if (given.missingMass !== undefined) fields.missing_mass = real(given.missingMass, label, 'missingMass');
    const meshes = given.meshes ?? 'hulls';
    if (!kMeshes.includes(meshes)) refuse(label, 'meshes', `one of ${kMeshes.join(', ')}`, meshes);
    fields.meshes_as_triangles = Number(meshes === 'triangles'), fields.meshes_as_parts = Number(meshes === 'parts');
    const roots = e.c.new_string(kFolder);
    return {pointer: e.c.create('dRobotOptions', {...fields, roots}).pointer, roots};
}
