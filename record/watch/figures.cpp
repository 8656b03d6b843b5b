// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The inertia is that of the body's frame: w is brought there, w' = R^T w.
#include "record/watch/figures.h"

#include <algorithm>

#include "record/watch/joints.h"

namespace epode::record {

namespace {

double kinetic_energy(dBodyID body, const dMass& mass)
{
    const dReal* v = dBodyGetLinearVel(body);
    const dReal* w = dBodyGetAngularVel(body);
    const dReal* rot = dBodyGetRotation(body);
    double local[3], energy = 0;
    for (int i = 0; i < 3; ++i) {
        local[i] = 0;
        for (int k = 0; k < 3; ++k) local[i] += double(rot[4 * k + i]) * double(w[k]);
        energy += 0.5 * double(mass.mass) * double(v[i]) * double(v[i]);
    }
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) energy += 0.5 * local[i] * double(mass.I[4 * i + k]) * local[k];
    }
    return energy;
}

}  // namespace

void measure(dWorldID world, const std::vector<dBodyID>& bodies, const std::vector<dJointID>& joints,
             StepFigures& figures)
{
    dVector3 gravity;
    dWorldGetGravity(world, gravity);
    figures.kinetic = figures.potential = figures.joint_error = 0;
    for (dBodyID body : bodies) {
        if (dBodyIsKinematic(body)) continue;
        dMass mass;
        dBodyGetMass(body, &mass);
        figures.kinetic += kinetic_energy(body, mass);
        if (!dBodyGetGravityMode(body)) continue;
        const dReal* pos = dBodyGetPosition(body);
        for (int i = 0; i < 3; ++i)
            figures.potential -= double(mass.mass) * double(gravity[i]) * double(pos[i]);
    }
    for (dJointID joint : joints) figures.joint_error = std::max(figures.joint_error, joint_gap(joint));
}

}  // namespace epode::record
