// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A pyramid one box deep is as good a scale as it is a tower: what solvers leave over bends it. The exact
// stepper leaves nothing over, and no box moves aside by the width of a hair, however long; substeps keep
// a lower one upright. EPODE_PYRAMID=100 (boxes at the base) stands for 20 s, in 20 minutes; without it, 24
// boxes for 2 s.
#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "world_contacts.h"

namespace epode::physics {
namespace {

struct Boxes {
    std::vector<dBodyID> bodies;
    std::vector<V3> places;
};

Boxes pyramid(WorldContactsSim& sim, int base)
{
    Boxes out;
    for (int row = 0; row < base; ++row)
        for (int i = 0; i < base - row; ++i) {
            out.places.push_back({i + 0.5 * row - 0.5 * base, 0, row + 0.5});
            out.bodies.push_back(sim.box(out.places.back(), {1, 1, 1}, 100));
        }
    return out;
}

// How far the worst is aside, and how far the worst has sunk.
struct Drift {
    double aside = 0, down = 0;
};

Drift drift_of(const Boxes& boxes)
{
    Drift worst;
    for (std::size_t i = 0; i < boxes.bodies.size(); ++i) {
        const V3 d = position(boxes.bodies[i]) - boxes.places[i];
        worst.aside = std::max({worst.aside, std::abs(d.x), std::abs(d.y)});
        worst.down = std::max(worst.down, std::abs(d.z));
    }
    return worst;
}

TEST(Pyramid, stands_with_the_exact_stepper)
{
    const char* wanted = std::getenv("EPODE_PYRAMID");
    const int base = wanted ? std::atoi(wanted) : 24;
    WorldContactsSim sim(Stepper::kExact);
    sim.ground();
    const Boxes boxes = pyramid(sim, base);
    sim.run(wanted ? 1200 : 120);
    const Drift drift = drift_of(boxes);
    // Down by the depth that contacts may keep, a row; with floats also by what the default CFM gives way.
    EXPECT_LT(drift.aside, kSingle ? 0.005 : 1e-4);
    EXPECT_LT(drift.down, (kSingle ? 0.0015 : 0.00021) * base);
}

TEST(Pyramid, stands_with_substeps)
{
    WorldContactsSim sim(Stepper::kFast);
    sim.ground();
    const Boxes boxes = pyramid(sim, 24);
    sim.run(300);
    const Drift drift = drift_of(boxes);
    EXPECT_LT(drift.aside, 0.02);
    EXPECT_LT(drift.down, 0.002 * 24);
}

}  // namespace
}  // namespace epode::physics
