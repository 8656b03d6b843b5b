// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts that dWorldQuickStep finds for a world obey Coulomb's law, mu N in every direction at every point, in each preset,
// at three step sizes, and just so where a contact joint is part of the island (once their friction then
// was a pyramid with fixed directions: a slab stopped after 0.81 m instead of 1.15, and 7 cm aside).
#include <algorithm>
#include <cmath>

#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kMu = 0.4, kG = 9.81, kSteps[] = {1.0 / 60, 0.005, 0.002};
constexpr int kPresets[] = {dDefaultsRobot, dDefaultsGame, dDefaultsOde};

enum class Extra { kNone, kContactJoint, kRollingFriction };

struct MixedSim : WorldContactsSim {
    MixedSim(int preset, Extra extra) : WorldContactsSim(Stepper::kQuick), extra_(extra)
    {
        dWorldUseDefaults(world, preset);
        rub(ground());
    }
    void rub(dGeomID geom)
    {
        dMaterial m;
        dMaterialInit(&m, sizeof m);
        m.friction = real(kMu);
        if (extra_ == Extra::kRollingFriction) m.rolling_friction = real(1e-6);
        ASSERT_EQ(dGeomSetMaterial(geom, &m), 1);
    }
    dBodyID add(V3 at, V3 size, double mass)
    {
        const dBodyID body = box(at, size, mass);
        rub(geom_of(body));
        return body;
    }
    // A contact joint on the first body that holds nothing: it only pushes the way it goes.
    void next(double h)
    {
        dJointGroupEmpty(contacts);
        const V3 v = velocity(bodies[0]);
        if (extra_ == Extra::kContactJoint) {
            const V3 flat{v.x, v.y, 0};
            const V3 n = length(flat) > 1e-6 ? (1 / length(flat)) * flat : V3{1, 0, 0};
            dContact c = make_contact(position(bodies[0]), n, 0);
            c.surface.mu = 0;
            dJointAttach(dJointCreateContact(world, contacts, &c), bodies[0], nullptr);
        }
        ASSERT_TRUE(advance(h));
    }

  private:
    Extra extra_;
};

struct MixedCase {
    int preset;
    Extra extra;
};

class MixedIslands : public testing::TestWithParam<MixedCase> {};

TEST_P(MixedIslands, brake_by_mu_g_straight_on)
{
    const double v = 3, way = v * v / (2 * kMu * kG);
    for (const double h : kSteps)
        for (const double a : {0.05, 0.7, 2.2, -1.9}) {
            MixedSim s(GetParam().preset, GetParam().extra);
            s.add({0, 0, 0.1}, {1, 1, 0.2}, 5);
            for (int i = 0; i < 0.3 / h; ++i) s.next(h);
            const V3 from = position(s.bodies[0]);
            velocity(s.bodies[0], {v * std::cos(a), v * std::sin(a), 0});
            dBodyEnable(s.bodies[0]);
            for (int i = 0; i < 1.2 / h; ++i) s.next(h);
            const V3 p = position(s.bodies[0]) - from;
            // A first-order step stops up to h v / 2 early.
            EXPECT_NEAR(p.x * std::cos(a) + p.y * std::sin(a), way, 0.55 * h * v + 0.001 * way)
                << h << ' ' << a;
            EXPECT_NEAR(p.y * std::cos(a) - p.x * std::sin(a), 0, tol(2e-4, 2e-3)) << h << ' ' << a;
        }
}

// A slab that spins on its four corners, each with a quarter of the weight, which go around at the distance r:
// I dw/dt = -mu m g r.
TEST_P(MixedIslands, brake_what_spins)
{
    constexpr double kMass = 5, kEdge = 0.6, kSpin = 20, kTime = 0.2;
    const double inertia = kMass * kEdge * kEdge / 6, r = kEdge / std::sqrt(2.0);
    for (const double h : kSteps) {
        MixedSim s(GetParam().preset, GetParam().extra);
        const dBodyID slab = s.add({0, 0, 0.05}, {kEdge, kEdge, 0.1}, kMass);
        for (int i = 0; i < 0.3 / h; ++i) s.next(h);
        velocity(slab, {}, {0, 0, kSpin});
        dBodyEnable(slab);
        const int steps = int(kTime / h + 0.5);
        for (int i = 0; i < steps; ++i) s.next(h);
        const double lost = kMu * kMass * kG * r / inertia * steps * h;
        EXPECT_NEAR(kSpin - spin(slab).z, lost, 0.01 * lost) << h;
    }
}

// What is reported is measured against the cone: swept for long, nothing is left.
TEST_P(MixedIslands, leave_no_residual_after_many_sweeps)
{
    MixedSim s(GetParam().preset, GetParam().extra);
    dWorldSetQuickStepNumIterations(s.world, 2000);
    dWorldSetStepReportMode(s.world, 1);
    velocity(s.add({0, 0, 0.1}, {1, 1, 0.2}, 5), {1, 2, 0});
    for (int i = 0; i < 10; ++i) s.next(0.01);
    EXPECT_LT(s.report().residual, tol(1e-6, 1e-3));
    EXPECT_GT(length(velocity(s.bodies[0])), 1.5);  // it slides
}

// 48 boxes fall onto each other.
TEST_P(MixedIslands, keep_every_friction_force_in_its_cone)
{
    MixedSim s(GetParam().preset, GetParam().extra);
    for (int i = 0; i < 48; ++i)
        s.add({0.13 * (i % 7), 0.17 * (i % 5), 0.5 + 0.33 * i}, {0.3 + 0.01 * (i % 11), 0.4, 0.3}, 1 + i % 5);
    int all = 0, outside = 0;
    for (int i = 0; i < 180; ++i) {
        s.next(1.0 / 60);
        if (i % 10 != 0) continue;
        for (const dWorldContact& c : s.all_contacts()) {
            if (!(c.normal_force > 1e-3)) continue;
            ++all;
            outside += length(vec(c.friction_force)) > kMu * double(c.normal_force) * 1.001 + 1e-3;
        }
    }
    EXPECT_GT(all, 1000);
    EXPECT_EQ(outside, 0) << all;
}

std::string mixed_name(const testing::TestParamInfo<MixedCase>& info)
{
    const int preset = info.param.preset;
    const std::string name = preset == dDefaultsRobot ? "robot" : preset == dDefaultsGame ? "game" : "ode";
    const char* const extra[] = {"", "_contact_joint", "_rolling_friction"};
    return name + extra[int(info.param.extra)];
}

std::vector<MixedCase> mixed_cases()
{
    std::vector<MixedCase> out;
    for (const int preset : kPresets)
        for (const Extra extra : {Extra::kNone, Extra::kContactJoint, Extra::kRollingFriction})
            out.push_back({preset, extra});
    return out;
}

INSTANTIATE_TEST_SUITE_P(Presets, MixedIslands, testing::ValuesIn(mixed_cases()), mixed_name);

}  // namespace
}  // namespace epode::physics
