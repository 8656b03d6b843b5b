// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What rests sinks as deep whatever it weighs: the default CFM keeps redundant rows solvable and is no spring, so
// boxes of 50 m stand as those of 1 m do, in every preset and at every step size. Literal, 1e-5 of floats let them
// fall through the ground at 3 km/s.
#include "rig.h"

namespace epode::physics::heavy_towers {
namespace {

enum class Way { kOdeExact, kOdeQuick, kOdeFast, kExact, kQuick, kFast, kGame, kRobot };
constexpr Way kWays[] = {Way::kOdeExact, Way::kOdeQuick, Way::kOdeFast, Way::kExact,
                         Way::kQuick,    Way::kFast,     Way::kGame,    Way::kRobot};

const char* name_of(Way way)
{
    constexpr const char* kNames[] = {"ode_exact", "ode_quick", "ode_fast", "exact",
                                      "quick",     "fast",      "game",     "robot"};
    return kNames[int(way)];
}

bool has_preset(Way way) { return way == Way::kGame || way == Way::kRobot; }

Stepper stepper_of(Way way)
{
    if (way == Way::kOdeQuick || way == Way::kQuick) return Stepper::kQuick;
    return way == Way::kOdeFast || way == Way::kFast ? Stepper::kFast : Stepper::kExact;
}

constexpr int kBoxes = 5;

class Tower : public Sim {
  public:
    Tower(Way way, double size, double density) : Sim(stepper_of(way)), way_(way), size_(size)
    {
        substeps = 4;
        if (has_preset(way)) dWorldUseDefaults(world, way == Way::kGame ? dDefaultsGame : dDefaultsRobot);
        dWorldSetStepThreads(world, 1);
        if (way >= Way::kExact) dWorldSetContactSpace(world, space);
        gravity(0, 0, -9.81);
        ground();
        for (int i = 0; i < kBoxes; ++i)
            box({0, 0, (i + 0.5) * size}, {size, size, size}, density * size * size * size);
    }

    void run(double h, double seconds)
    {
        for (int i = 0; i < int(seconds / h); ++i) {
            if (has_preset(way_))
                ASSERT_EQ(dWorldStepHybrid(world, real(h)), 1);
            else
                ASSERT_EQ(way_ < Way::kExact ? step(h) : advance(h), 1);
        }
    }

    // Of the topmost box.
    double sinking() const { return (kBoxes - 0.5) * size_ - position(bodies.back()).z; }

  private:
    Way way_;
    double size_;
};

class HeavyTowers : public testing::TestWithParam<Way> {};

// Soft contacts of four substeps sink by 8 mm at 1/60 s. The layer of a game's contacts is 1 mm each; a coordinate
// has so many digits.
double allowed(Way way, double size)
{
    const double layers = way == Way::kGame ? 0.001 * kBoxes : 0;
    return 0.01 + layers + 16 * kEpsilon * kBoxes * size;
}

TEST_P(HeavyTowers, sink_no_deeper_than_light_ones)
{
    for (const double h : {1.0 / 60, 1.0 / 240, 0.001})
        for (const double density : {1000.0, 2500.0})
            for (const double size : {1.0, 10.0, 50.0}) {
                Tower tower(GetParam(), size, density);
                tower.run(h, 0.5);
                EXPECT_LT(std::fabs(tower.sinking()), allowed(GetParam(), size))
                    << "boxes of " << size << " m, " << density << " kg/m^3, h = " << h;
            }
}

INSTANTIATE_TEST_SUITE_P(Ways, HeavyTowers, testing::ValuesIn(kWays),
                         [](const auto& chosen) { return name_of(chosen.param); });

}  // namespace
}  // namespace epode::physics::heavy_towers
