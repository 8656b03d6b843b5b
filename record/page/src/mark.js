// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What shows which body is chosen: its solids in a bright colour, and boxes around them that are seen through everything.
import {Color, Matrix4, Vector3} from 'three';

const kBright = new Color(0xffe14d);
const kEdges = [0, 1, 1, 3, 3, 2, 2, 0, 4, 5, 5, 7, 7, 6, 6, 4, 0, 4, 1, 5, 2, 6, 3, 7];  // of corners numbered by x + 2 y + 4 z

// Of each carrier its instances: [[mesh, number], ...].
export function instances_of(recording, meshes) {
    const all = Array.from({length: recording.carriers.count}, () => []);
    for (const mesh of meshes) {
        mesh.userData.members.forEach((part, i) => {
            const carrier = recording.parts.numbers[4 * part + 1];
            if (carrier >= 0) all[carrier].push([mesh, i]);
        });
    }
    return all;
}

export class Mark {
    // `lines` is a LineSegments for up to kCapacity boxes.
    static kCapacity = 64;
    constructor(instances, lines) {
        Object.assign(this, {instances, lines, carrier: -1, colors: []});
        lines.geometry.setDrawRange(0, 0);
    }

    set(carrier) {
        this.paint((mesh, i, k) => mesh.setColorAt(i, this.colors[k]));
        this.carrier = carrier;
        this.colors = this.marked().map(([mesh, i]) => {
            const color = new Color();
            mesh.getColorAt(i, color);
            return color;
        });
        this.paint((mesh, i, k) => mesh.setColorAt(i, this.colors[k].clone().lerp(kBright, 0.75)));
        this.update();
    }

    marked() { return this.carrier < 0 ? [] : this.instances[this.carrier]; }

    paint(color) {
        this.marked().forEach(([mesh, i], k) => {
            color(mesh, i, k);
            mesh.instanceColor.needsUpdate = true;
        });
    }

    // Where the bodies are now.
    update() {
        const out = this.lines.geometry.attributes.position, matrix = new Matrix4();
        let at = 0;
        for (const [mesh, i] of this.marked().slice(0, Mark.kCapacity)) {
            mesh.geometry.boundingBox ?? mesh.geometry.computeBoundingBox();
            mesh.getMatrixAt(i, matrix);
            const {min, max} = mesh.geometry.boundingBox;
            const corners = Array.from({length: 8}, (_, k) =>
                new Vector3(k & 1 ? max.x : min.x, k & 2 ? max.y : min.y, k & 4 ? max.z : min.z).applyMatrix4(matrix));
            for (const k of kEdges) out.setXYZ(at++, corners[k].x, corners[k].y, corners[k].z);
        }
        this.lines.geometry.setDrawRange(0, at);
        out.needsUpdate = true;
    }
}
