// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A lever of length l on a hinge, whose tip is in something fixed, with a normal at the small angle a to the lever: to leave it with
// the velocity c the lever must turn with c / (l sin a). In worlds that bound correcting velocities, corrections make at most
// twice the kinetic energy of all bodies at 3 m/s and at their own velocity, m (9 + c^2) (step/island/divergence.h).
#include <ode/ext.h>

#include <cmath>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kMass = 1, kLength = 1, kAngle = 0.05, kDepth = 0.1;

using Step = int (*)(dWorldID, dReal);

// The energy of the lever after one step.
double energy_of_lever(Step step, bool bounds, double moving)
{
    const dWorldID world = dWorldCreate();
    dWorldSetQuickStepNumIterations(world, 20000);  // sweeps close on the answer by the square of the angle
    if (bounds) dWorldSetContactMaxCorrectingVel(world, 1);
    const dBodyID lever = dBodyCreate(world);
    dMass mass;
    dMassSetBoxTotal(&mass, real(kMass), real(kLength), real(0.05), real(0.05));
    dBodySetMass(lever, &mass);
    dBodySetPosition(lever, real(kLength / 2), 0, 0);
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, lever, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dContact contact{};
    contact.surface.mode = moving != 0 ? dContactMotionN : 0;
    contact.surface.motionN = real(moving);
    contact.geom.pos[0] = real(kLength);
    contact.geom.normal[0] = real(-std::cos(kAngle)), contact.geom.normal[1] = real(std::sin(kAngle));
    contact.geom.depth = real(moving != 0 ? 0 : kDepth);
    const dJointID joint = dJointCreateContact(world, nullptr, &contact);
    dJointAttach(joint, lever, nullptr);
    step(world, real(1.0 / 60));
    const V3 v = vec(dBodyGetLinearVel(lever)), w = vec(dBodyGetAngularVel(lever));
    const double energy =
        0.5 * (kMass * dot(v, v) + double(mass.I[10]) * w.z * w.z);  // it turns about z alone
    dWorldDestroy(world);
    return energy;
}

// Less what the default CFM yields by: C = 60 CFM against A = (l sin a)^2 / I, 7 % in floats.
double energy_at(double c)
{
    const double arm = kLength * std::sin(kAngle), A = arm * arm * 3 / (kMass * kLength * kLength);
    const double w = c / arm * A / (A + 60 * tol(1e-10, 1e-5));
    return 0.5 * kMass * kLength * kLength / 3 * w * w;
}

class TrustCorrections : public testing::TestWithParam<Step> {};

TEST_P(TrustCorrections, of_contacts_throw_no_lever)
{
    const double thrown = energy_at(1);
    ASSERT_GT(thrown, 2 * kMass * (9 + 1)) << "the scene throws nothing";
    EXPECT_LT(energy_of_lever(GetParam(), true, 0), kMass * (9 + 1));
}

// Without a bound ERP moves bodies as fast as it asks; what moves by itself moves them as fast as it does, too.
TEST_P(TrustCorrections, move_bodies_as_fast_as_they_ask_where_nothing_bounds_them)
{
    const double asked = energy_at(0.2 * 60 * kDepth);
    EXPECT_NEAR(energy_of_lever(GetParam(), false, 0), asked, 0.02 * asked);
    EXPECT_NEAR(energy_of_lever(GetParam(), true, 1), energy_at(1), 0.02 * energy_at(1));
}

INSTANTIATE_TEST_SUITE_P(Steps, TrustCorrections, testing::Values(dWorldStep, dWorldQuickStep),
                         [](const auto& step) { return step.index == 0 ? "exact" : "quick"; });

}  // namespace
}  // namespace epode::physics
