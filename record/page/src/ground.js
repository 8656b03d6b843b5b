// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The ground that the eye stays above: level planes, and what a height field or a mesh that does not move has under the eye.
import {Raycaster, Vector3} from 'three';

const kPlane = 5, kMesh = 8, kHeightField = 9;
const kDown = new Vector3(0, 0, -1);

// Heights of the level planes whose solid side is below.
export function level_floors({solids, parts}) {
    const heights = [];
    for (let i = 0; i < parts.count; ++i) {
        const solid = solids[parts.numbers[4 * i]];
        if (solid.kind === kPlane && solid.normals.length >= 3 && Math.abs(solid.normals[2]) > 0.999) heights.push(solid.points[2]);
    }
    return heights;
}

export class Ground {
    constructor(recording, meshes) {
        this.floors = level_floors(recording);
        this.stand_under(Infinity);
        const is_static = mesh => mesh.userData.members.every(part => recording.parts.numbers[4 * part + 1] < 0);
        this.terrain = meshes.filter(mesh => [kMesh, kHeightField].includes(mesh.userData.kind) && is_static(mesh));
    }

    // Of several floors the one that a view of this height stands on.
    stand_under(z) { this.floor = Math.max(-Infinity, ...this.floors.filter(floor => floor <= z)); }

    // The height of the ground at a place (x, y); -Infinity: there is none.
    height(x, y) {
        if (this.terrain.length === 0) return this.floor;
        const hit = new Raycaster(new Vector3(x, y, 1e6), kDown).intersectObjects(this.terrain)[0];
        return hit ? Math.max(this.floor, hit.point.z) : this.floor;
    }

    // Turns the camera of `controls` up, about its target, until it is above the ground by `gap`.
    keep_above(controls, gap) {
        const camera = controls.object, {target} = controls;
        const lowest = this.height(camera.position.x, camera.position.y) + gap;
        if (!(camera.position.z < lowest)) return;
        if (target.z < lowest) {  // shifted into the ground
            camera.position.z += lowest - target.z;
            target.z = lowest;
        }
        const offset = camera.position.clone().sub(target), distance = offset.length();
        if (camera.position.z < lowest) {
            const flat = Math.max(1e-9, Math.hypot(offset.x, offset.y)), z = lowest - target.z;
            const across = Math.sqrt(Math.max(0, distance * distance - z * z)) / flat;
            camera.position.set(target.x + across * offset.x, target.y + across * offset.y, lowest);
        }
        camera.lookAt(target);
    }
}
