// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The stage of the replay page for a world that runs: bodies may come and end, contacts are those of the last step, and there may be water.
import {DoubleSide, Mesh, PlaneGeometry, ShaderMaterial} from 'three';
import {Stage} from '../../../record/page/src/stage.js';
import {LivePoses, recording_of} from './drawn.js';

const kMaxContacts = 4000, kCells = 64;

export class LiveStage extends Stage {
    constructor(canvas, simulation, view) {
        const recording = recording_of(simulation);
        super(canvas, recording, new LivePoses(recording, simulation), {view, contacts: kMaxContacts});
        this.simulation = simulation;
        this.generation = simulation.generation;
        this.show_water();
        this.follow_body();
    }

    // Another simulation, seen from the start; or (the same) with other bodies.
    present(simulation, view) {
        const recording = recording_of(simulation);
        this.simulation = simulation;
        this.generation = simulation.generation;
        this.show(recording, new LivePoses(recording, simulation), view);
        if (view) this.show_water();
        this.follow_body();
    }

    // Turns the eye about what it looks at, rad, around and upwards.
    turn(across, up) {
        const {camera, controls} = this, offset = camera.position.clone().sub(controls.target), away = offset.length();
        const angle = Math.atan2(offset.y, offset.x) + across, height = Math.min(1.5, Math.max(-0.2, Math.asin(offset.z / away) + up));
        offset.set(Math.cos(angle) * Math.cos(height), Math.sin(angle) * Math.cos(height), Math.sin(height)).multiplyScalar(away);
        camera.position.copy(controls.target).add(offset);
        controls.update();
    }

    follow_body() { this.follow = this.simulation.bodies.indexOf(this.simulation.hooks.follow); }

    show_water() {
        const {water} = this.simulation.hooks;
        if (this.water) {
            this.scene.remove(this.water);
            this.water.geometry.dispose();
            this.water = null;
        }
        if (!water) return;
        this.water = new Mesh(new PlaneGeometry(water.side, water.side, kCells, kCells), water_material());
        this.water.renderOrder = 1;
        this.scene.add(this.water);
    }

    update() {
        if (this.simulation && this.generation !== this.simulation.generation) this.present(this.simulation);
        super.update();
        if (this.water) this.update_water();
    }

    update_water() {
        const {hooks: {water}, time} = this.simulation, place = this.water.geometry.attributes.position;
        for (let i = 0; i < place.count; ++i) place.setZ(i, water.height(place.getX(i), place.getY(i), time));
        place.needsUpdate = true;
        this.water.geometry.computeVertexNormals();
    }

    // A line along the normal, as long as the force is large.
    update_contacts() {
        this.contacts_shown = 0;
        if (!this.contact_lines.visible || !this.simulation) return;
        const out = this.contact_lines.geometry.attributes.position, weight = this.simulation.world.gravity[2] * 200;
        let at = 0;
        for (const {position: p, normal: n, normalForce} of this.simulation.world.contacts.slice(0, kMaxContacts)) {
            const size = this.radius * Math.min(0.3, 0.015 + 0.04 * Math.sqrt(Math.abs(normalForce / weight)));
            out.setXYZ(at++, ...p);
            out.setXYZ(at++, ...p.map((x, k) => x + size * n[k]));
        }
        this.contacts_shown = at / 2;
        this.contact_lines.geometry.setDrawRange(0, at);
        out.needsUpdate = true;
    }
}

// Sees through, and brighter where it faces the sun.
function water_material() {
    return new ShaderMaterial({
        transparent: true, depthWrite: false, side: DoubleSide,
        vertexShader: 'varying vec3 facing; void main() { facing = normal; gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0); }',
        fragmentShader: `varying vec3 facing; void main() {
            vec3 n = normalize(facing);
            float light = 0.55 + 0.75 * max(0.0, dot(n, normalize(vec3(-1.2, -1.0, 1.8))) - 0.55);
            gl_FragColor = vec4(light * vec3(0.42, 0.66, 0.80), 0.62);
        }`,
    });
}
