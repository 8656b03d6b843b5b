// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is round and put down at rest stays where it is, to a micrometre a second, while it sinks into the surface layer and after:
// on every kind of ground, in every stepper and preset, near the origin and a kilometre away.
#include <tuple>

#include "mesh_floors.h"
#include "world_contacts.h"

namespace epode::physics {
namespace {

enum class Setting { kExact, kQuick, kFast, kGame, kRobot };
enum class Solid { kBall, kCapsule, kCylinder, kEllipsoid };

class RoundRest : public testing::TestWithParam<std::tuple<Setting, Floor, Solid>> {
  protected:
    RoundRest()
    {
        if (setting() == Setting::kGame) dWorldUseDefaults(sim.world, dDefaultsGame);
        if (setting() == Setting::kRobot) dWorldUseDefaults(sim.world, dDefaultsRobot);
        dWorldSetAutoDisableFlag(sim.world, 0);
        dWorldSetStepThreads(sim.world, 1);
        dWorldSetContactSpace(sim.world, sim.space);
        sim.gravity(0, 0, -9.81);
    }

    Setting setting() const { return std::get<0>(GetParam()); }

    dBodyID add_solid(V3 at, double r)
    {
        switch (std::get<2>(GetParam())) {
            case Solid::kBall:
                return sim.sphere(at + V3{0, 0, r}, r, 1000 * r * r * r);
            case Solid::kCapsule:
                return lay(sim.capsule(at + V3{0, 0, r}, r, 3 * r, 2000 * r * r * r));
            case Solid::kCylinder:
                return lay(sim.cylinder(at + V3{0, 0, r}, r, 3 * r, 2000 * r * r * r));
            case Solid::kEllipsoid:
                break;
        }
        dMass m;
        dMassSetSphereTotal(&m, real(1000 * r * r * r), real(r));
        const dBodyID body = sim.body(at + V3{0, 0, r});
        dBodySetMass(body, &m);
        dGeomSetBody(dCreateEllipsoid(sim.space, real(2 * r), real(1.5 * r), real(r)), body);
        return body;
    }

    // Its axis horizontal, at 30 degrees.
    static dBodyID lay(dBodyID body)
    {
        dMatrix3 R;
        dRFromZAxis(R, real(std::cos(kPi / 6)), 0.5, 0);
        dBodySetRotation(body, R);
        return body;
    }

    void step(double h)
    {
        switch (setting()) {
            case Setting::kExact:
                ASSERT_EQ(dWorldStep(sim.world, real(h)), 1);
                break;
            case Setting::kQuick:
                ASSERT_EQ(dWorldQuickStep(sim.world, real(h)), 1);
                break;
            case Setting::kFast:
                ASSERT_EQ(dWorldStepFast1(sim.world, real(h), 4), 1);
                break;
            default:
                ASSERT_EQ(dWorldStepHybrid(sim.world, real(h)), 1);
        }
    }

    Sim sim;
};

TEST_P(RoundRest, stays_where_it_is_put)
{
    const FlatGround ground(sim, std::get<1>(GetParam()), 16, 0.5);
    const bool endless = std::get<1>(GetParam()) == Floor::kPlane && !kSingle;
    std::vector<dBodyID> solids;
    std::vector<V3> starts;
    for (const double x : {0.35, endless ? 1000.35 : -1.7})
        for (const double r : {0.0025, 0.05, 0.2}) {
            solids.push_back(add_solid(V3{x + 10 * r, 0.21 - 5 * r, 0}, r));
            starts.push_back(position(solids.back()));
        }
    for (const double h : {1.0 / 60, 0.002})
        for (int i = 0, n = int(2 / h); i < n; ++i) {
            step(h);
            for (std::size_t k = 0; k < solids.size(); ++k) {
                const V3 v = velocity(solids[k]);
                ASSERT_LT(std::hypot(v.x, v.y), tol(1e-6, 1e-4)) << k << " h " << h << " step " << i;
            }
        }
    for (std::size_t i = 0; i < solids.size(); ++i) {
        const V3 moved = position(solids[i]) - starts[i];
        EXPECT_LT(std::hypot(moved.x, moved.y), tol(2e-6, 1e-4)) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(
    Everywhere, RoundRest,
    testing::Combine(testing::Values(Setting::kExact, Setting::kQuick, Setting::kFast, Setting::kGame,
                                     Setting::kRobot),
                     testing::Values(Floor::kPlane, Floor::kBox, Floor::kMesh, Floor::kField),
                     testing::Values(Solid::kBall, Solid::kCapsule, Solid::kCylinder, Solid::kEllipsoid)));

}  // namespace
}  // namespace epode::physics
