// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Jolt Physics as WebAssembly under node (npm jolt-physics), one thread, floats, its own parameters but for damping,
// which is off as in every engine here, and sleeping. WebAssembly has 128-bit lanes at best and no AVX2: native Jolt is
// quicker. Reads and writes what web.mjs describes. What is made once is not freed: the process ends after two worlds.
import initJolt from 'jolt-physics';
import { driven, play, readScene, refuse, versionOf } from './web.mjs';

const FIXED = 0, MOVING = 1, GHOST = 2; // layers: ghosts touch nothing

const scene = readScene();
if (scene.bodies.length > 4000) refuse('more than 4,000 bodies are more contacts than the binding has memory for');

const Jolt = await initJolt();
const vec = (v) => new Jolt.Vec3(...v);
const far = (v) => new Jolt.RVec3(...v);
const quat = ([w, x, y, z]) => new Jolt.Quat(x, y, z, w);
const kYToZ = [Math.SQRT1_2, Math.SQRT1_2, 0, 0];

function makeWorld() {
    const settings = new Jolt.JoltSettings();
    settings.mMaxBodies = 20000;
    settings.mMaxBodyPairs = 65536;
    settings.mMaxContactConstraints = 12288; // the binding's working memory is 10 MB
    settings.mMaxWorkerThreads = 0;
    const pairs = new Jolt.ObjectLayerPairFilterTable(3);
    pairs.EnableCollision(FIXED, MOVING);
    pairs.EnableCollision(MOVING, MOVING);
    const layers = new Jolt.BroadPhaseLayerInterfaceTable(3, 3);
    for (const layer of [FIXED, MOVING, GHOST]) layers.MapObjectToBroadPhaseLayer(layer, new Jolt.BroadPhaseLayer(layer));
    settings.mObjectLayerPairFilter = pairs;
    settings.mBroadPhaseLayerInterface = layers;
    settings.mObjectVsBroadPhaseLayerFilter = new Jolt.ObjectVsBroadPhaseLayerFilterTable(layers, 3, pairs, 3);
    const world = new Jolt.JoltInterface(settings);
    world.GetPhysicsSystem().SetGravity(vec([0, 0, -scene.gravity]));
    return world;
}

function meshShape(shape) {
    const list = new Jolt.TriangleList();
    list.resize(shape.triangles.length);
    shape.triangles.forEach((corners, i) => {
        corners.forEach((corner, k) => {
            const v = list.at(i).get_mV(k);
            [v.x, v.y, v.z] = shape.points[corner];
        });
    });
    return new Jolt.MeshShapeSettings(list).Create().Get();
}

function hullShape(shape) {
    const settings = new Jolt.ConvexHullShapeSettings();
    for (const point of shape.points) settings.mPoints.push_back(vec(point));
    return settings.Create().Get();
}

const upright = (shape) => new Jolt.RotatedTranslatedShapeSettings(vec([0, 0, 0]), quat(kYToZ), shape).Create().Get();

function makeShape(shape) {
    const [x, y, z] = shape.size;
    switch (shape.kind) {
        case 'sphere': return new Jolt.SphereShape(x);
        case 'box': return new Jolt.BoxShape(vec([x / 2, y / 2, z / 2]));
        case 'capsule': return upright(new Jolt.CapsuleShapeSettings(y / 2, x));
        case 'cylinder': return upright(new Jolt.CylinderShapeSettings(y / 2, x));
        case 'hull': return hullShape(shape);
        default: return meshShape(shape);
    }
}

let world, bodies, made;
const shapes = scene.shapes.map(makeShape);
const filter = new Jolt.GroupFilterTable(scene.joints.length ? scene.bodies.length : 1);
for (const joint of scene.joints) filter.DisableCollision(joint.body1, joint.body2);

function bodyShape(data) {
    if (data.parts.length === 0) return new Jolt.SphereShape(0.1); // only joints hold on to it
    if (data.parts.length === 1) return shapes[data.parts[0].shape];
    const settings = new Jolt.StaticCompoundShapeSettings();
    for (const part of data.parts) settings.AddShapeShape(vec(part.offset), quat(part.turn), shapes[part.shape], 0);
    return settings.Create().Get();
}

function makeBody(data, number) {
    const motion = { static: Jolt.EMotionType_Static, driven: Jolt.EMotionType_Kinematic, dynamic: Jolt.EMotionType_Dynamic };
    const layer = !data.collides || data.parts.length === 0 ? GHOST : data.motion === 'static' ? FIXED : MOVING;
    const made = new Jolt.BodyCreationSettings(bodyShape(data), far(data.pos), quat(data.turn), motion[data.motion], layer);
    made.mFriction = scene.friction;
    made.mAllowSleeping = false;
    made.mLinearDamping = made.mAngularDamping = 0;
    if (data.motion === 'dynamic') {
        made.mOverrideMassProperties = Jolt.EOverrideMassProperties_MassAndInertiaProvided;
        made.mMassPropertiesOverride.mMass = data.mass;
        made.mMassPropertiesOverride.mInertia = Jolt.Mat44.prototype.sScaleVec3(vec(data.inertia));
    }
    if (scene.joints.length) {
        made.mCollisionGroup.SetGroupFilter(filter);
        made.mCollisionGroup.SetGroupID(0);
        made.mCollisionGroup.SetSubGroupID(number);
    }
    const body = bodies.CreateBody(made);
    bodies.AddBody(body.GetID(), Jolt.EActivation_Activate);
    if (data.motion === 'dynamic') {
        bodies.SetLinearVelocity(body.GetID(), vec(data.linear));
        bodies.SetAngularVelocity(body.GetID(), vec(data.angular));
    }
    return body;
}

function makeJoint(data, made) {
    const body1 = made[data.body1], body2 = made[data.body2];
    if (data.kind === 'ball') {
        const settings = new Jolt.PointConstraintSettings();
        settings.mPoint1 = settings.mPoint2 = far(data.anchor);
        return settings.Create(body1, body2);
    }
    const settings = new Jolt.HingeConstraintSettings();
    const side = Math.abs(data.axis1[0]) < 0.6 ? [1, 0, 0] : [0, 1, 0];
    const along = data.axis1.reduce((sum, x, i) => sum + x * side[i], 0);
    const normal = side.map((x, i) => x - along * data.axis1[i]);
    const size = Math.hypot(...normal);
    settings.mPoint1 = settings.mPoint2 = far(data.anchor);
    settings.mHingeAxis1 = settings.mHingeAxis2 = vec(data.axis1);
    settings.mNormalAxis1 = settings.mNormalAxis2 = vec(normal.map((x) => x / size));
    if (data.low < data.high) [settings.mLimitsMin, settings.mLimitsMax] = [-data.high, -data.low];
    return settings.Create(body1, body2);
}

function begin() {
    world = makeWorld();
    bodies = world.GetPhysicsSystem().GetBodyInterface();
    made = scene.bodies.map(makeBody);
    for (const joint of scene.joints) world.GetPhysicsSystem().AddConstraint(makeJoint(joint, made));
    world.GetPhysicsSystem().OptimizeBroadPhase();
    return { step, states, end: () => Jolt.destroy(world) };
}

function drive(at) {
    scene.bodies.forEach((data, i) => {
        if (data.motion !== 'driven') return;
        const { pos, turn } = driven(data, at);
        bodies.MoveKinematic(made[i].GetID(), far(pos), quat(turn), scene.dt);
    });
}

const states = () => made.map((body) => {
    const p = body.GetCenterOfMassPosition(), q = body.GetRotation(), v = body.GetLinearVelocity();
    const line = [p.GetX(), p.GetY(), p.GetZ(), q.GetW(), q.GetX(), q.GetY(), q.GetZ(), v.GetX(), v.GetY(), v.GetZ()];
    const w = body.GetAngularVelocity();
    return [...line, w.GetX(), w.GetY(), w.GetZ()];
});

function step(at) {
    drive(at);
    world.Step(scene.dt, 1);
}

play(`Jolt, WebAssembly (npm jolt-physics ${versionOf('jolt-physics')})`, begin);
