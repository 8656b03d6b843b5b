// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Small things lie on each other as large ones do, with the defaults of large ones.
#include "measure.h"

namespace epode::trials {

namespace {

// Twelve layers of three bricks of 75 x 25 x 15 mm.
void run_toy_tower(Run& run)
{
    constexpr double kLong = 0.075, kWide = 0.025, kHigh = 0.015;
    Stage stage(run);
    stage.surface.friction = 0.5;
    stage.floor();
    dBodyID top = nullptr;
    for (int layer = 0; layer < 12; ++layer)
        for (int i = -1; i <= 1; ++i) {
            const double off = 1.01 * kWide * i, z = (layer + 0.5) * kHigh;
            const bool along = layer % 2 == 0;
            top = stage.box({along ? kLong : kWide, along ? kWide : kLong, kHigh}, 0.02,
                            {along ? 0 : off, along ? off : 0, z});
        }
    const Vec begin = position(top);
    stage.advance(3);
    stage.advance(1, [&] {
        run.record("height", 100 * std::fabs(position(top).z / begin.z - 1));
        run.record("aside", 1000 * across(position(top) - begin));
    });
}

}  // namespace

extern const Scene kToyTower{
    "Rest",
    "toy_tower",
    "a tower of 36 bricks of 15 mm, with the surface layer of the preset, 4 s",
    {{"height", "height of the top, off", "%", 2}, {"aside", "its way aside", "mm", 1}},
    &run_toy_tower};

}  // namespace epode::trials
