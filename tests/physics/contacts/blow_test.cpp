// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies thrown at a floor, without gravity: whatever they do there, no step gives them energy. (Impulses of
// the blow that were carried into the next step did: a tenth of it with much friction.)
#include <algorithm>
#include <string>

#include "world_contacts.h"

namespace epode::physics {
namespace {

struct Throw {
    bool world_contacts;
    double mu, bounce;
    double gain;  // of the energy at the start, in a step
};

std::string name_of(const testing::TestParamInfo<Throw>& info)
{
    const Throw& t = info.param;
    return std::string(t.world_contacts ? "world_contacts" : "joints") + (t.mu > 10 ? "_rough" : "_mu_1") +
           (t.bounce > 0 ? "_bouncing" : "");
}

dBodyID thrown(Sim& sim, Random& random, int shape)
{
    const V3 at{0, 0, 1.5};
    const dBodyID body = shape == 0   ? sim.box(at, {1, random.uniform(0.2, 1), random.uniform(0.2, 0.7)}, 1)
                         : shape == 1 ? sim.capsule(at, 0.1, 1, 1)
                                      : sim.box(at, {2, 0.2, 0.2}, 1);
    dQuaternion q;
    random.quaternion(q);
    dBodySetQuaternion(body, q);
    V3 v = random.point(3);
    v.z = random.uniform(-6, -2);
    velocity(body, v, random.point(6));
    return body;
}

class Blows : public testing::TestWithParam<Throw> {};

TEST_P(Blows, give_no_energy)
{
    const Throw& t = GetParam();
    Random random(7);
    double largest = 0;
    int blows = 0;
    for (int k = 0; k < 120; ++k) {
        Sim sim(Stepper::kFast);
        sim.substeps = 4;
        sim.gravity(0, 0, 0);
        dWorldSetContactMaxCorrectingVel(sim.world, 1);
        const dGeomID floor = sim.ground();
        const dBodyID body = thrown(sim, random, k % 3);
        if (t.world_contacts) {
            set_material(floor, t.mu, t.bounce), set_material(geom_of(body), t.mu, t.bounce);
            dWorldSetContactSpace(sim.world, sim.space);
        }
        sim.surface.mode = dContactApprox1 | dContactBounce;
        sim.surface.mu = real(t.mu), sim.surface.bounce = real(t.bounce), sim.surface.bounce_vel = 0;
        const double start = kinetic_energy(body);
        double before = start;
        for (int i = 0; i < 200; ++i) {
            t.world_contacts ? sim.advance(0.005) : sim.step(0.005);
            const double after = kinetic_energy(body);
            largest = std::max(largest, (after - before) / start);
            blows += after < 0.9 * before;
            before = after;
        }
    }
    EXPECT_GT(blows, 120);
    EXPECT_LT(largest, t.gain);
}

INSTANTIATE_TEST_SUITE_P(Throws, Blows,
                         testing::Values(Throw{true, 1, 0, 0.002}, Throw{true, 1, 0.3, 0.002},
                                         Throw{true, 1e9, 0, 0.005}, Throw{false, 1, 0, 0.005},
                                         Throw{false, 1, 0.3, 0.005}, Throw{false, 1e9, 0, 0.02}),
                         name_of);

}  // namespace
}  // namespace epode::physics
