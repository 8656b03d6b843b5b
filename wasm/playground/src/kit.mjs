// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What scenes build with: bodies and geoms of the package `epode`, each with the colour that it is drawn in, a number of the palette.
// Random numbers are the same in every run, so a link shows what it was copied from.
import {Lcg} from './random.mjs';

export class Kit {
    constructor(engine, world) {
        Object.assign(this, {engine, world, random: new Lcg(1), shown: []});
    }

    // A body with one geom; sizes are createGeom's. options: those of createBody and color, density, mass, material.
    solid(kind, sizes, position, options = {}) {
        const {color, density, mass, material, ...of_body} = options, body = this.world.createBody({position, ...of_body});
        this.part(body, kind, sizes, {color, density, mass, material});
        return body;
    }

    // A further geom of a body. Its offset is from where the centre of mass was before, which each part moves.
    part(body, kind, sizes, {color = this.world.bodies.length % 6, ...options} = {}) {
        return this.colored(body.createGeom(kind, {...sizes, ...without_undefined(options)}), color);
    }

    // A geom that stands still. options: those of createGeom and color.
    fixed(kind, sizes, {color = 7, ...options} = {}) { return this.colored(this.world.createGeom(kind, {...sizes, ...options}), color); }

    floor() { return this.fixed('plane', {normal: [0, 0, 1]}); }

    // Hills over x and y: height(x, y) in m, `samples` intervals a side.
    terrain(side, samples, height, color = 3) {
        const count = samples + 1, at = i => (i / samples - 0.5) * side, heights = [];
        for (let row = 0; row < count; ++row) for (let i = 0; i < count; ++i) heights.push(height(at(i), -at(row)));
        const geom = this.fixed('heightfield', {heights, widthSamples: count, depthSamples: count, width: side, depth: side},
                                {color, quaternion: [Math.SQRT1_2, Math.SQRT1_2, 0, 0]});
        geom.userData.triangles = triangles_of(heights, count, at);
        return geom;
    }

    // Something that is drawn and does not collide: pose() gives its [position, quaternion].
    picture(kind, sizes, color, pose) {
        const geom = this.fixed(kind, sizes, {color});
        geom.enabled = false;
        this.shown.push({geom, pose});
        return geom;
    }

    // Bodies that a function of C has made; make(pointer) writes their handles. Returns the bodies in that order.
    made_by_c(capacity, make, color) {
        const {c} = this.engine, pointer = c.malloc(4 * capacity), before = new Set(this.world.geoms);
        const handles = Array.from(c.ints(pointer, make(pointer)), handle => handle >>> 0);
        c.free(pointer);
        this.engine.check('Kit.made_by_c');
        this.world.refresh();
        for (const geom of this.world.geoms) if (!before.has(geom)) this.colored(geom, color);
        return handles.map(handle => this.engine.objects.get(handle));
    }

    colored(geom, color) {
        geom.userData = {color};
        return geom;
    }
}

const without_undefined = options => Object.fromEntries(Object.entries(options).filter(([, value]) => value !== undefined));

// Two triangles a cell, in the field's frame, whose up is y; their upper side is the outer one.
function triangles_of(heights, count, at) {
    const found = [], point = (row, i) => found.push(at(i), heights[row * count + i], at(row));
    for (let row = 0; row + 1 < count; ++row) {
        for (let i = 0; i + 1 < count; ++i) {
            point(row, i), point(row + 1, i), point(row + 1, i + 1);
            point(row, i), point(row + 1, i + 1), point(row, i + 1);
        }
    }
    return Float64Array.from(found);
}
