// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts of a stage: joints of a near callback with the surfaces that the world would make of the same materials, and what acted.
#include "stage.h"

#include <algorithm>

namespace epode::trials {

namespace {

// Of two geoms with different rules the later one counts (dCombineRule).
double combine(double a, int rule_a, double b, int rule_b)
{
    switch (std::max(rule_a, rule_b)) {
        case dCombineAverage:
            return (a + b) / 2;
        case dCombineMinimum:
            return std::min(a, b);
        case dCombineProduct:
            return a * b;
        case dCombineMaximum:
            return std::max(a, b);
        default:
            return std::sqrt(a * b);
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
                       double(p.normal_force) * vec(p.normal) + vec(p.friction_force),
                       double(p.normal_force)});
    return all;
}

}  // namespace epode::trials
