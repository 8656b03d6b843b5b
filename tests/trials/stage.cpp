// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "stage.h"

#include <algorithm>

namespace epode::trials {

namespace {

int preset_of(Method method)
{
    if (method == Method::kGame) return dDefaultsGame;
    return method == Method::kRobot ? dDefaultsRobot : dDefaultsOde;
}

// As docs/guide/sleeping.md recommends; the game preset has the same values.
void let_sleep(dWorldID world)
{
    dWorldSetAutoDisableFlag(world, 1);
    dWorldSetAutoDisableLinearThreshold(world, 0.02);
    dWorldSetAutoDisableAngularThreshold(world, 0.02);
    dWorldSetAutoDisableSteps(world, 20);
    dWorldSetAutoDisableTime(world, 0.3);
}

// Of two geoms with different rules the later one counts (dCombineRule).
double combine(double a, int rule_a, double b, int rule_b)
{
    switch (std::max(rule_a, rule_b)) {
        case dCombineAverage: return (a + b) / 2;
        case dCombineMinimum: return std::min(a, b);
        case dCombineProduct: return a * b;
        case dCombineMaximum: return std::max(a, b);
        default: return std::sqrt(a * b);
    }
}

// The velocity of a geom's surface in the world's axes.
Vec belt_of(dGeomID geom, const dMaterial& material)
{
    if (dGeomGetClass(geom) == dPlaneClass) return vec(material.surface_velocity);
    dVector3 belt;
    dMultiply0_331(belt, dGeomGetRotation(geom), material.surface_velocity);
    return vec(belt);
}

}  // namespace

Turn orientation(dBodyID body)
{
    const dReal* q = dBodyGetQuaternion(body);
    return {double(q[0]), double(q[1]), double(q[2]), double(q[3])};
}

void set_velocity(dBodyID body, Vec linear, Vec angular)
{
    dBodySetLinearVel(body, linear.x, linear.y, linear.z);
    dBodySetAngularVel(body, angular.x, angular.y, angular.z);
}

Stage::Stage(const Setting& where, Vec gravity, double step_size)
    : setting(where), h(step_size > 0 ? step_size : where.h()), callback(contains(kCallback, where.method)), world(dWorldCreate()),
      space(dHashSpaceCreate(nullptr)), contacts_(dJointGroupCreate(0))
{
    dWorldUseDefaults(world, preset_of(setting.method));
    dWorldSetStepThreads(world, 1);  // changes no bit; cells run in processes of their own
    if (setting.sleep)
        let_sleep(world);
    else
        dWorldSetAutoDisableFlag(world, 0);
    dWorldSetGravity(world, gravity.x, gravity.y, gravity.z);
    if (!callback) dWorldSetContactSpace(world, space);
    dMaterialInit(&surface, sizeof surface);
}

Stage::~Stage()
{
    dJointGroupDestroy(contacts_);
    dSpaceDestroy(space);
    dWorldDestroy(world);
}

void Stage::adopt(dWorldID other, dSpaceID its_space)
{
    dSpaceDestroy(space);
    dWorldDestroy(world);
    world = other;
    space = its_space;
}

void Stage::step()
{
    made_.clear();
    feedback_.clear();
    if (callback) dSpaceCollide(space, this, &near_callback);
    switch (setting.method) {
        case Method::kOdeExact:
        case Method::kExact: dWorldStep(world, h); break;
        case Method::kOdeQuick:
        case Method::kQuick: dWorldQuickStep(world, h); break;
        case Method::kSubsteps: dWorldStepFast1(world, h, 4); break;
        default: dWorldStepHybrid(world, h);
    }
    dJointGroupEmpty(contacts_);
}

void Stage::near_callback(void* stage, dGeomID geom1, dGeomID geom2)
{
    const bool swapped = !dGeomGetBody(geom1);
    static_cast<Stage*>(stage)->collide(swapped ? geom2 : geom1, swapped ? geom1 : geom2);
}

void Stage::collide(dGeomID geom1, dGeomID geom2)
{
    const dBodyID body1 = dGeomGetBody(geom1), body2 = dGeomGetBody(geom2);
    if (!body1 || (body2 && dAreConnectedExcluding(body1, body2, dJointTypeContact))) return;
    if (dGeomGetSensor(geom1) || dGeomGetSensor(geom2)) return;
    constexpr int kCapacity = 16;
    dContact contact[kCapacity] = {};
    const int count = dCollide(geom1, geom2, kCapacity, &contact[0].geom, sizeof contact[0]);
    for (int i = 0; i < count; ++i) {
        contact[i].surface = combined(geom1, geom2, contact[i]);
        const dJointID joint = dJointCreateContact(world, contacts_, &contact[i]);
        dJointAttach(joint, body1, body2);
        if (!wants_touches_) continue;
        dJointSetFeedback(joint, &feedback_.emplace_back());
        made_.push_back({body1, body2, vec(contact[i].geom.pos), vec(contact[i].geom.normal), {}, 0});
    }
}

// What the world makes of two materials (docs/guide/materials.md), as the surface of a contact joint.
dSurfaceParameters Stage::combined(dGeomID geom1, dGeomID geom2, dContact& contact) const
{
    dMaterial a, b;
    dMaterialInit(&a, sizeof a);
    dMaterialInit(&b, sizeof b);
    dGeomGetMaterial(geom1, &a);
    dGeomGetMaterial(geom2, &b);
    dSurfaceParameters made = {};
    made.mode = dContactApprox1;
    made.mu = combine(a.friction, a.friction_rule, b.friction, b.friction_rule);
    if ((made.bounce = std::max(a.bounce, b.bounce)) > 0) made.mode |= dContactBounce;
    made.bounce_vel = std::max(a.bounce_speed, b.bounce_speed);
    if ((made.rho = std::max(a.rolling_friction, b.rolling_friction)) > 0) made.mode |= dContactRolling;
    const Vec normal = vec(contact.geom.normal), drift = belt_of(geom2, b) - belt_of(geom1, a);
    const Vec along = drift - dot(drift, normal) * normal;
    if (made.motion1 = length(along); made.motion1 > 0) {
        made.mode |= dContactMotion1 | dContactFDir1;
        const Vec direction = (1 / length(along)) * along;
        contact.fdir1[0] = direction.x, contact.fdir1[1] = direction.y, contact.fdir1[2] = direction.z;
    }
    return made;
}

void Stage::finish(dGeomID geom, dBodyID body)
{
    constexpr unsigned long kStatic = 1, kMoving = 2;
    dGeomSetBody(geom, body);
    dGeomSetMaterial(geom, &surface);
    dGeomSetCategoryBits(geom, body ? kMoving : kStatic);
    dGeomSetCollideBits(geom, !body ? kMoving : bodies_meet ? kStatic | kMoving : kStatic);
}

dBodyID Stage::part(dMass mass, Vec at, Turn q)
{
    const dBodyID body = dBodyCreate(world);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, at.x, at.y, at.z);
    const dQuaternion turned = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dBodySetQuaternion(body, turned);
    return body;
}

dBodyID Stage::body(dGeomID geom, dMass mass, Vec at, Turn q)
{
    const dBodyID made = part(mass, at, q);
    finish(geom, made);
    return made;
}

dBodyID Stage::bar(Vec size, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetBoxTotal(&m, mass, size.x, size.y, size.z);
    return part(m, at, q);
}

dBodyID Stage::box(Vec size, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetBoxTotal(&m, mass, size.x, size.y, size.z);
    return body(dCreateBox(space, size.x, size.y, size.z), m, at, q);
}

dBodyID Stage::ball(double radius, double mass, Vec at)
{
    dMass m;
    dMassSetSphereTotal(&m, mass, radius);
    return body(dCreateSphere(space, radius), m, at);
}

dBodyID Stage::capsule(double radius, double length, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetCapsuleTotal(&m, mass, 3, radius, length);
    return body(dCreateCapsule(space, radius, length), m, at, q);
}

dBodyID Stage::cylinder(double radius, double length, double mass, Vec at, Turn q)
{
    dMass m;
    dMassSetCylinderTotal(&m, mass, 3, radius, length);
    return body(dCreateCylinder(space, radius, length), m, at, q);
}

dGeomID Stage::floor() { return place(dCreatePlane(space, 0, 0, 1, 0)); }
dGeomID Stage::block(Vec size, Vec at, Turn q) { return place(dCreateBox(space, size.x, size.y, size.z), at, q); }

dGeomID Stage::place(dGeomID geom, Vec at, Turn q)
{
    finish(geom, nullptr);
    if (dGeomGetClass(geom) == dPlaneClass) return geom;
    dGeomSetPosition(geom, at.x, at.y, at.z);
    const dQuaternion turned = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dGeomSetQuaternion(geom, turned);
    return geom;
}

dJointID Stage::ball_joint(dBodyID body1, dBodyID body2, Vec at)
{
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, body1, body2);
    dJointSetBallAnchor(joint, at.x, at.y, at.z);
    return joint;
}

dJointID Stage::hinge(dBodyID body1, dBodyID body2, Vec at, Vec axis)
{
    const dJointID joint = dJointCreateHinge(world, nullptr);
    dJointAttach(joint, body1, body2);
    dJointSetHingeAnchor(joint, at.x, at.y, at.z);
    dJointSetHingeAxis(joint, axis.x, axis.y, axis.z);
    return joint;
}

dJointID Stage::fix(dBodyID body1, dBodyID body2)
{
    const dJointID joint = dJointCreateFixed(world, nullptr);
    dJointAttach(joint, body1, body2);
    dJointSetFixed(joint);
    return joint;
}

double Stage::layer() const
{
    const double set = dWorldGetContactSurfaceLayer(world);
    return set > 0 || callback ? set : 2e-4;
}

std::vector<Touch> Stage::touches() const
{
    std::vector<Touch> all = made_;
    for (size_t i = 0; i < all.size(); ++i) {
        all[i].force = vec(feedback_[i].f1);
        all[i].normal_force = dot(all[i].force, all[i].normal);
    }
    if (callback) return all;
    std::vector<dWorldContact> points(size_t(dWorldGetContacts(world, nullptr, 0)));
    dWorldGetContacts(world, points.data(), int(points.size()));
    for (const dWorldContact& p : points)
        all.push_back({dGeomGetBody(p.g1), dGeomGetBody(p.g2), vec(p.pos), vec(p.normal),
                       double(p.normal_force) * vec(p.normal) + vec(p.friction_force), double(p.normal_force)});
    return all;
}

}  // namespace epode::trials
