// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "exercise.h"

#include <cmath>

namespace hostile {
namespace {

constexpr int kSteps = 3, kMostJoints = 100, kMostContacts = 8;

struct Collision {
    dWorldID world;
    dJointGroupID group;
    int joints = 0;
    bool sane = true;
};

bool sane(const dContactGeom& c)
{
    for (int i = 0; i < 3; ++i)
        if (!std::isfinite(c.pos[i]) || !std::isfinite(c.normal[i])) return false;
    return std::isfinite(c.depth);
}

// Rays touch without pushing.
bool is_solid(dGeomID geom) { return dGeomGetClass(geom) != dRayClass; }

void make_contacts(void* data, dGeomID a, dGeomID b)
{
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) return dSpaceCollide2(a, b, data, make_contacts);
    Collision& collision = *static_cast<Collision*>(data);
    dContactGeom found[kMostContacts];
    const int count = dCollide(a, b, kMostContacts, found, sizeof found[0]);
    for (int i = 0; i < count; ++i) {
        if (!sane(found[i])) collision.sane = false;
        if (++collision.joints > kMostJoints) return;
        dContact contact{};
        contact.surface.mode = dContactApprox1;
        contact.surface.mu = 1;
        contact.geom = found[i];
        const dJointID joint = dJointCreateContact(collision.world, collision.group, &contact);
        if (is_solid(a) && is_solid(b)) dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
    }
}

void step(dWorldID world, int turn)
{
    const dReal h = dReal(0.01);
    if (turn % 3 == 0) dWorldQuickStep(world, h);
    if (turn % 3 == 1) dWorldStep(world, h);
    if (turn % 3 == 2) dWorldStepFast1(world, h, 4);
}

}  // namespace

bool exercise(const Scene& scene)
{
    const Messages kept = messages();
    Collision collision{scene.world, scene.contacts};
    for (int i = 0; i < kSteps; ++i) {
        collision.joints = 0;
        dSpaceCollide(scene.space, &collision, make_contacts);
        step(scene.world, i);
        dJointGroupEmpty(scene.contacts);
    }
    messages() = kept;
    return collision.sane;
}

}  // namespace hostile
