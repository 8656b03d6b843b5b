// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Stacks, and objects of a robot's size. Lengths and times go together (Froude's law: t ~ sqrt(l / g)), so a
// step of 1/60 s is ten times as long for a tower of 1 cm boxes as for one of 1 m boxes. Towers of eight
// stand for 20 s with world-managed contacts: off by less than 2 % of an edge in height and aside.
// At 1/60 s substeps and sweeps do not hold them (docs/guide/stability.md); the exact stepper and hybrid steps,
// which choose it for them, do. Substeps do with steps for their size, since their springs follow it.
#include <algorithm>
#include <string>
#include <tuple>

#include "scenes.h"

namespace epode::physics {
namespace {

constexpr double kH = 1.0 / 60, kSeconds = 20;

enum class Way { kExact, kHybrid };

struct Off {
    double height = 0, aside = 0;  // in edges, the worst
};

class Tower : public Sim {
  public:
    explicit Tower(double edge, int boxes = 8, double layer = 0) : edge_(edge)
    {
        gravity(0, 0, -9.81);
        dWorldSetCFM(world, real(1e-10));  // that of floats, 1e-5, is a soft one: a tower of 8 sinks by 7 cm
        ground();
        for (int i = 0; i < boxes; ++i)
            box({0, 0, edge * (i + 0.5)}, {edge, edge, edge}, 1000 * edge * edge * edge);
        if (layer > 0) dWorldSetContactSurfaceLayer(world, real(layer));
        dWorldSetContactSpace(world, space);
    }

    void stand(Way way)
    {
        for (int i = 0; i < int(kSeconds / kH); ++i)
            ASSERT_EQ(way == Way::kExact ? dWorldStep(world, real(kH)) : dWorldStepHybrid(world, real(kH)),
                      1);
    }

    Off off() const
    {
        Off worst;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const V3 p = position(bodies[i]);
            worst.height = std::max(worst.height, std::fabs(p.z / edge_ - (double(i) + 0.5)));
            worst.aside = std::max(worst.aside, std::hypot(p.x, p.y) / edge_);
        }
        return worst;
    }

  private:
    double edge_;
};

class SmallTower : public testing::TestWithParam<std::tuple<double, Way>> {};

TEST_P(SmallTower, stands_still)
{
    const auto [edge, way] = GetParam();
    Tower tower(edge);
    tower.stand(way);
    EXPECT_LT(tower.off().height, 0.02);
    EXPECT_LT(tower.off().aside, 0.02);
}

std::string tower_name(const testing::TestParamInfo<std::tuple<double, Way>>& info)
{
    const auto [edge, way] = info.param;
    return std::to_string(int(std::lround(1000 * edge))) + "mm_" + (way == Way::kExact ? "exact" : "hybrid");
}

INSTANTIATE_TEST_SUITE_P(Sizes, SmallTower,
                         testing::Combine(testing::Values(0.01, 0.02, 0.05, 0.1, 0.037),
                                          testing::Values(Way::kExact, Way::kHybrid)),
                         tower_name);

// With steps and substeps for the size of the boxes.
TEST(TowerInSubsteps, stands_still)
{
    struct {
        double edge, h;
        int substeps;
    } const kTowers[] = {
        {0.01, 1.0 / 240, 16}, {0.02, 1.0 / 500, 4}, {0.05, 1.0 / 240, 8}, {0.1, 1.0 / 240, 4}};
    for (const auto& [edge, h, substeps] : kTowers) {
        Tower tower(edge);
        for (int i = 0; i < int(kSeconds / h); ++i)
            ASSERT_EQ(dWorldStepFast1(tower.world, real(h), substeps), 1);
        EXPECT_LT(tower.off().height, 0.02) << edge;
        EXPECT_LT(tower.off().aside, 0.02) << edge;
    }
}

// What iterates loses towers from some height on, and hybrid steps know it.
TEST(TallTower, stands_in_hybrid_steps)
{
    for (const int boxes : {10, 14, 20, 30}) {
        Tower tower(1, boxes);
        tower.stand(Way::kHybrid);
        EXPECT_LT(tower.off().height, 0.04) << boxes;
        EXPECT_LT(tower.off().aside, 0.02) << boxes;
    }
}

// A layer that was set is kept by what is large; by small things as far as it is half a percent of half their size, or a tower of toys with the
// millimetre of dDefaultsGame would sink by a tenth of itself.
TEST(SmallContacts, keep_of_a_layer_that_was_set_what_is_small_to_them)
{
    constexpr double kLayer = 1e-3, kShare = 5e-3;
    for (const double edge : {0.01, 0.1, 1.0}) {
        Tower tower(edge, 8, kLayer);
        tower.stand(Way::kExact);
        const double kept = std::min(kLayer / edge, kShare / 2);
        EXPECT_NEAR(tower.off().height, 8 * kept, 0.02 * 8 * kept) << edge;
    }
}

// Large bodies have the layer of 0.2 mm as before.
TEST(SmallContacts, leave_large_ones_alone)
{
    Tower tower(1);
    tower.stand(Way::kExact);
    EXPECT_NEAR(tower.off().height, 8 * 2e-4, tol(1e-6, 1e-4));
}

}  // namespace
}  // namespace epode::physics
