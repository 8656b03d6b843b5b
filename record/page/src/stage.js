// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is seen: one instanced mesh for each solid, lights, a floor, contacts and joints as lines, and the camera.
import {
    BasicShadowMap, BufferAttribute, BufferGeometry, Color, DirectionalLight, Fog, Group, InstancedMesh, LineBasicMaterial, LineSegments, Matrix4,
    PCFShadowMap, PerspectiveCamera, Quaternion, Raycaster, Scene, Vector2, Vector3, WebGLRenderer,
} from 'three';
import {OrbitControls} from 'three/addons/controls/OrbitControls.js';
import {Ground, level_floors} from './ground.js';
import {Mark, instances_of} from './mark.js';
import {kSunDirection, paint} from './paint.js';
import {Poses} from './poses.js';
import {draws_in_software, kLevels} from './quality.js';

const kSky = new Color(0xdfe7ee);
const kFar = 25, kFollowed = 2;  // m
const kSolid = {plane: 5}, kDirection = [0.45, -0.85, 0.32];  // from what is seen to the eye

function geometry_of(solid) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(solid.points, 3));
    geometry.setAttribute('normal', new BufferAttribute(solid.normals, 3));
    geometry.setIndex(new BufferAttribute(solid.corners, 1));
    return geometry;
}

function lines(color, capacity) {
    const geometry = new BufferGeometry();
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(6 * capacity), 3));
    const made = new LineSegments(geometry, new LineBasicMaterial({color, depthTest: false, transparent: true}));
    made.frustumCulled = false;
    made.renderOrder = 1;
    return made;
}

function dispose(shown) {
    shown.geometry.dispose();
    shown.material.dispose();
    shown.dispose?.();
}

// Lines in short pieces: some software renderers lose a line of which one end is behind the camera. They fade towards the edge: far away
// they are closer than pixels, and the edge would be seen.
function grid_of(half, spacing) {
    const points = [], colors = [];
    for (let i = -half; i <= half; ++i) {
        for (let k = -half; k < half; k += 4) points.push(i, k, 0, i, k + 4, 0, k, i, 0, k + 4, i, 0);
    }
    const geometry = new BufferGeometry();
    for (let i = 0; i < points.length; i += 3) colors.push(1, 1, 1, Math.max(0, 1 - Math.hypot(points[i], points[i + 1]) / half));
    geometry.setAttribute('position', new BufferAttribute(new Float32Array(points).map(x => spacing * x), 3));
    geometry.setAttribute('color', new BufferAttribute(new Float32Array(colors), 4));
    return geometry;
}

// Where most of the points are: their middle, and how far away all but a twentieth are.
function extent_of(points) {
    if (points.length === 0) points = [new Vector3()];
    const middle = axis => points.map(p => p.getComponent(axis)).sort((a, b) => a - b)[points.length >> 1];
    const center = new Vector3(middle(0), middle(1), middle(2));
    const distances = points.map(p => p.distanceTo(center)).sort((a, b) => a - b);
    return {center, radius: Math.max(1, 1.15 * distances[Math.floor(0.95 * (distances.length - 1))] + 0.5)};
}

// Carriers that go far, in a view of that radius, and stay together; all, or many that scatter: none.
function travellers(moments, radius) {
    const start = moments[0], ways = start.map((p, i) => Math.max(...moments.map(points => points[i].distanceTo(p))));
    const far = start.map((_, i) => i).filter(i => ways[i] > 0.5 * Math.max(...ways));
    const together = far.length <= start.length / 2 && moments.every(points => extent_of(far.map(i => points[i])).radius < radius / 8);
    return radius > kFar && together ? far : [];
}

export class Stage {
    // options: view, {center, radius, direction} of the first view (default: all that moves); contacts, how many there are at most (default:
    // as the recording has).
    constructor(canvas, recording, poses, options = {}) {
        this.recording = recording;
        this.poses = poses;
        this.max_contacts = options.contacts;
        this.in_software = draws_in_software();
        this.renderer = new WebGLRenderer({canvas, antialias: !this.in_software, preserveDrawingBuffer: false});
        this.renderer.shadowMap.enabled = true;
        this.shadows = true;
        this.scene = new Scene();
        this.scene.background = kSky;
        this.camera = new PerspectiveCamera(38, 1, 0.01, 5000);
        this.camera.up.set(0, 0, 1);
        this.controls = new OrbitControls(this.camera, canvas);
        this.controls.enableDamping = false;
        this.controls.addEventListener('change', () => this.stay_above());
        this.follow = -1;
        this.contents = new Group();
        this.scene.add(this.contents);
        this.resize(canvas.clientWidth, canvas.clientHeight);
        this.make_parts();
        this.make_lines();
        this.poses.go_to(0);
        this.make_lights();
        if (options.view) this.look_at(options.view); else this.frame_all();
        this.make_grid();
        this.set_level(kLevels[0]);
        this.update();
    }

    // Shows something else, seen from `view`, by default from where the camera is. What was shown goes last: its programs serve what comes.
    show(recording, poses, view) {
        const before = this.contents, {contact_lines, joint_lines} = this;
        Object.assign(this, {recording, poses, contents: new Group()});
        this.scene.add(this.contents);
        this.make_parts();
        this.make_lines();
        if (view) this.look_at(view);
        this.make_grid();
        this.contact_lines.visible = contact_lines.visible;
        this.joint_lines.visible = joint_lines.visible;
        this.poses.go_to(0);
        this.renderer.compile(this.scene, this.camera);
        this.scene.remove(before);
        before.children.forEach(dispose);
    }

    make_parts() {
        const {parts, solids, palette} = this.recording;
        const members = solids.map(() => []);
        for (let i = 0; i < parts.count; ++i) members[parts.numbers[4 * i]].push(i);
        this.meshes = [];
        for (let s = 0; s < solids.length; ++s) {
            if (members[s].length === 0 || solids[s].corners.length === 0) continue;
            const is_plane = solids[s].kind === kSolid.plane;
            const material = paint({polygonOffset: is_plane, polygonOffsetFactor: 1, polygonOffsetUnits: 8});
            const mesh = new InstancedMesh(geometry_of(solids[s]), material, members[s].length);
            mesh.frustumCulled = false;
            mesh.castShadow = !is_plane;
            mesh.receiveShadow = true;
            members[s].forEach((part, i) => {
                const [r, g, b] = palette[parts.numbers[4 * part + 2]];
                mesh.setColorAt(i, new Color().setRGB(r, g, b, 'srgb'));
            });
            mesh.userData = {members: members[s], kind: solids[s].kind};
            this.meshes.push(mesh);
            this.contents.add(mesh);
        }
    }

    make_lines() {
        const {contacts, joints} = this.recording;
        let largest = this.max_contacts ?? 1;
        for (let i = 0; i + 1 < contacts.starts.length; ++i)
            largest = Math.max(largest, contacts.starts[i + 1] - contacts.starts[i]);
        this.contact_lines = lines(0xd0021b, largest);
        this.contact_lines.visible = false;
        this.joint_lines = lines(0x2b2d42, 2 * Math.max(1, joints.count));
        const mark_lines = lines(0x111111, 12 * Mark.kCapacity);
        this.contents.add(this.contact_lines, this.joint_lines, mark_lines);
        this.mark = new Mark(instances_of(this.recording, this.meshes), mark_lines);
        this.ground = new Ground(this.recording, this.meshes);
    }

    make_lights() {
        const sun = new DirectionalLight();  // for its shadows: paint.js has its light
        sun.castShadow = true;
        sun.shadow.bias = -0.0005;
        sun.shadow.normalBias = 0.02;
        this.sun = sun;
        this.scene.add(sun, sun.target);
    }

    // Lines on level floors, in steps of 1, 10, 100 m: what moves is seen to move.
    make_grid() {
        this.grids = [];
        for (const height of level_floors(this.recording)) {
            const spacing = 10 ** Math.max(0, Math.round(Math.log10(this.radius / 3)));
            const grid = new LineSegments(grid_of(40, spacing), new LineBasicMaterial(
                {color: 0x000000, vertexColors: true, transparent: true, opacity: 0.14, depthWrite: false}));
            grid.position.z = height + 0.002 * this.radius;
            this.grids.push(grid);
            this.contents.add(grid);
        }
    }

    // The sun's map covers what is near the camera's target.
    aim_sun() {
        const reach = Math.max(2, 1.6 * this.radius), target = this.controls.target;
        this.sun.target.position.copy(target);
        this.sun.position.copy(target).addScaledVector(kSunDirection, 2.4 * reach);
        const camera = this.sun.shadow.camera;
        camera.left = camera.bottom = -reach;
        camera.right = camera.top = reach;
        camera.near = 0.05 * reach;
        camera.far = 6 * reach;
        camera.updateProjectionMatrix();
    }

    // A view of the whole run: of everything that moves, wherever it goes, but for the few that fly far away. Where all go
    // somewhere else together, like a car, a view of the start, and the carrier in its middle is the one to follow; -1: none.
    // Likewise where a few go far together and all others stay, like a bike between posts.
    frame_all() {
        const poses = new Poses(this.recording), {carriers, times} = this.recording;
        const at = time => {
            poses.go_to(time);
            return Array.from({length: carriers.count}, (_, i) => new Vector3().fromArray(poses.values, 7 * i));
        };
        const kMoments = 12, first = times[0], span = times[times.length - 1] - first;
        const moments = Array.from({length: kMoments + 1}, (_, i) => at(first + span * i / kMoments));
        const whole = extent_of(moments.flat());
        for (const some of [moments[0].map((_, i) => i), travellers(moments, whole.radius)]) {
            const points = some.map(i => moments[0][i]), start = extent_of(points);
            if (some.length === 0 || whole.radius <= 4 * start.radius) continue;
            this.look_at(some.length < moments[0].length ? {...start, radius: Math.max(start.radius, kFollowed)} : start);
            const distances = points.map(p => p.distanceTo(start.center));
            return some[distances.indexOf(Math.min(...distances))];
        }
        this.look_at(whole);
        return -1;
    }

    look_at({center, radius, direction = kDirection}) {
        this.radius = radius;
        this.controls.target.set(...center);
        this.ground.stand_under(this.controls.target.z);
        const half = Math.atan(Math.min(1, this.camera.aspect) * Math.tan(0.5 * this.camera.fov * Math.PI / 180));
        const distance = 1.1 * this.radius / Math.sin(half);
        this.camera.position.set(...center).add(new Vector3(...direction).normalize().multiplyScalar(distance));
        this.camera.near = distance / 500;
        this.camera.far = 60 * distance;
        this.camera.updateProjectionMatrix();
        this.scene.fog = new Fog(kSky, 3 * distance, 14 * distance);
        this.controls.update();
        this.aim_sun();
    }

    // See quality.js.
    set_level(level) {
        this.level = level;
        const {sun, renderer} = this, type = level.soft ? PCFShadowMap : BasicShadowMap;
        renderer.setPixelRatio(Math.min(level.ratio, level.ratio * window.devicePixelRatio, Math.max(1, window.devicePixelRatio)));
        sun.castShadow = this.shadows && level.map > 0;
        if (level.map > 0 && sun.shadow.mapSize.x !== level.map) {
            sun.shadow.mapSize.set(level.map, level.map);
            sun.shadow.map?.dispose();
            sun.shadow.map = null;
        }
        if (renderer.shadowMap.type === type) return;
        renderer.shadowMap.type = type;
        for (const mesh of this.meshes) mesh.material.needsUpdate = true;
    }

    set_shadows(on) {
        this.shadows = on;
        this.set_level(this.level);
    }

    resize(width, height) {
        this.renderer.setSize(width, height, false);
        this.camera.aspect = Math.max(1, width) / Math.max(1, height);
        this.camera.updateProjectionMatrix();
    }

    update() {
        const {parts} = this.recording, {values, alive} = this.poses;
        const carrier_matrix = new Matrix4(), part_matrix = new Matrix4();
        const position = new Vector3(), turn = new Quaternion(), scale = new Vector3(), one = new Vector3(1, 1, 1);
        for (const mesh of this.meshes) {
            mesh.userData.members.forEach((part, i) => {
                const p = parts.poses.subarray(10 * part, 10 * part + 10), carrier = parts.numbers[4 * part + 1];
                const there = carrier < 0 || alive[carrier];
                scale.set(p[7], p[8], p[9]).multiplyScalar(there ? 1 : 0);
                part_matrix.compose(position.set(p[0], p[1], p[2]), turn.set(p[4], p[5], p[6], p[3]), scale);
                if (carrier >= 0) {
                    const v = values.subarray(7 * carrier, 7 * carrier + 7);
                    carrier_matrix.compose(position.set(v[0], v[1], v[2]), turn.set(v[4], v[5], v[6], v[3]), one);
                    part_matrix.premultiply(carrier_matrix);
                }
                mesh.setMatrixAt(i, part_matrix);
            });
            mesh.instanceMatrix.needsUpdate = true;
        }
        this.update_joints();
        this.update_contacts();
        this.mark.update();
        this.update_follow();
    }

    stay_above() {
        this.ground.keep_above(this.controls, 0.02 * this.radius);
    }

    update_joints() {
        const {joints} = this.recording;
        const out = this.joint_lines.geometry.attributes.position, point = new Vector3();
        let at = 0;
        for (let i = 0; i < joints.count; ++i) {
            for (let side = 0; side < 2; ++side) {
                const carrier = joints.carriers[2 * i + side];
                const a = joints.anchors.subarray(6 * i + 3 * side, 6 * i + 3 * side + 3);
                if (carrier < 0 || !this.poses.alive[carrier] || Number.isNaN(a[0])) continue;
                this.poses.point(carrier, 0, 0, 0, point);
                out.setXYZ(at++, point.x, point.y, point.z);
                this.poses.point(carrier, a[0], a[1], a[2], point);
                out.setXYZ(at++, point.x, point.y, point.z);
            }
        }
        this.joint_lines.geometry.setDrawRange(0, at);
        out.needsUpdate = true;
    }

    // A line along the normal, as long as the force is large.
    update_contacts() {
        const {contacts} = this.recording;
        this.contacts_shown = 0;
        if (!this.contact_lines.visible || contacts.starts.length < 2) return;
        const frame = Math.min(Math.round(this.poses.moment / contacts.stride), contacts.starts.length - 2);
        const out = this.contact_lines.geometry.attributes.position;
        let at = 0;
        for (let i = contacts.starts[frame]; i < contacts.starts[frame + 1]; ++i) {
            const p = [0, 1, 2].map(k => contacts.low[k] + contacts.extent[k] * contacts.places[3 * i + k] / 65535);
            const size = this.radius * (0.02 + 0.2 * Math.sqrt(contacts.forces[i] / 65535));
            out.setXYZ(at++, p[0], p[1], p[2]);
            out.setXYZ(at++, ...p.map((x, k) => x + size * contacts.normals[3 * i + k] / 127));
        }
        this.contacts_shown = at / 2;
        this.contact_lines.geometry.setDrawRange(0, at);
        out.needsUpdate = true;
    }

    update_follow() {
        if (this.follow < 0) return;
        const now = new Vector3().fromArray(this.poses.values, 7 * this.follow);
        const shift = now.clone().sub(this.controls.target);
        this.controls.target.add(shift);
        this.camera.position.add(shift);
        this.controls.update();
        this.aim_sun();
    }

    // The carrier under a point of the canvas (0..1 from the upper left), -1 for none.
    pick(x, y) { return this.hit(x, y).carrier; }

    // And where it is hit.
    hit(x, y) {
        const ray = new Raycaster();
        ray.setFromCamera(new Vector2(2 * x - 1, 1 - 2 * y), this.camera);
        for (const mesh of this.meshes) mesh.boundingSphere = null;  // instances moved
        const hit = ray.intersectObjects(this.meshes)[0];
        if (!hit) return {carrier: -1};
        return {carrier: this.recording.parts.numbers[4 * hit.object.userData.members[hit.instanceId] + 1], point: hit.point};
    }

    draw() {
        // Lines that a low eye sees one behind the other would add up to a black band.
        const {position} = this.camera, {target} = this.controls;
        const distance = Math.max(1e-9, position.distanceTo(target));
        for (const grid of this.grids)
            grid.material.opacity = 0.14 * Math.min(1, 0.05 + 4 * Math.abs(position.z - grid.position.z) / distance);
        this.renderer.render(this.scene, this.camera);
    }
}
