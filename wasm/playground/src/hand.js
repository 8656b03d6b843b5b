// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pointer in the picture: it pulls the body under it, in the plane that faces the eye, and with shift pushes it away; elsewhere it turns the view, and a double
// click throws a ball there.
import {Plane, Raycaster, Vector2, Vector3} from 'three';

const kBallSpeed = 18, kPushSpeed = 1;  // m/s

export class Hand {
    constructor(show) {
        this.show = show;
        const {canvas} = show;
        canvas.addEventListener('pointerdown', event => this.take(event), {capture: true});
        canvas.addEventListener('pointermove', event => this.move(event));
        for (const end of ['pointerup', 'pointercancel']) canvas.addEventListener(end, () => this.let_go());
        canvas.addEventListener('dblclick', event => this.throw_ball(...this.place(event)));
    }

    // 0 ... 1 from the upper left of the picture.
    place(event) {
        const box = this.show.canvas.getBoundingClientRect();
        return [(event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height];
    }

    ray(x, y) {
        const caster = new Raycaster();
        caster.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), this.show.stage.camera);
        return caster.ray;
    }

    take(event) {
        const {stage, simulation, canvas} = this.show, {carrier, point} = stage.hit(...this.place(event)), body = simulation.bodies[carrier];
        if (event.button !== 0 || !body || body.kinematic) return;
        if (event.shiftKey) {
            event.stopPropagation();
            simulation.strike(body, [point.x, point.y, point.z], this.ray(...this.place(event)).direction.toArray(), kPushSpeed);
            return;
        }
        const toward = stage.camera.getWorldDirection(new Vector3());
        this.plane = new Plane().setFromNormalAndCoplanarPoint(toward, point);
        simulation.grab(body, [point.x, point.y, point.z]);
        stage.controls.enabled = false;
        canvas.setPointerCapture(event.pointerId);
    }

    move(event) {
        if (!this.plane) return;
        const point = this.ray(...this.place(event)).intersectPlane(this.plane, new Vector3());
        if (point) this.show.simulation.move_hand([point.x, point.y, point.z]);
    }

    let_go() {
        if (!this.plane) return;
        this.plane = null;
        this.show.simulation.release();
        this.show.stage.controls.enabled = true;
    }

    throw_ball(x = 0.5, y = 0.5) {
        const {origin, direction} = this.ray(x, y), from = origin.clone().addScaledVector(direction, 1.5), velocity = direction.clone().multiplyScalar(kBallSpeed);
        velocity.z += 1;  // it falls on its way
        this.show.simulation.throw_ball([from.x, from.y, from.z], [velocity.x, velocity.y, velocity.z]);
    }
}
