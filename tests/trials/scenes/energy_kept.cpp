// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "energy_kept.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kFloor = 1e-3;  // a smaller error is compared with nothing

double reference_error(const Run& run, EnergyError error, Vec gravity)
{
    Setting setting = run.setting;
    setting.method = Method::kExact;
    Stage stage(setting, gravity);
    dWorldSetExactRotation(stage.world, 1);
    return error(stage);
}

}  // namespace

double energy_error(Stage& stage, double seconds, double scale)
{
    const double start = energy(stage);
    double worst = 0;
    stage.advance(seconds, [&] { worst = std::max(worst, std::fabs(energy(stage) - start)); });
    return worst / scale;
}

void record_energy(Run& run, EnergyError error, Vec gravity)
{
    Stage stage(run, gravity), coarse(run.setting, gravity, 2 * run.setting.h());
    const double here = error(stage), twice = error(coarse);
    run.record("energy", 100 * here);
    run.record("reference", here / std::max(kFloor, reference_error(run, error, gravity)));
    run.record("monotone", here / std::max(kFloor, twice));
}

std::vector<Law> energy_laws(Bound bound)
{
    return {{"energy", "change of energy", "%", bound},
            {"reference", "the same over that of exact rotation without projection", "1", 1.05},
            {"monotone", "the same over that at twice the step size", "1", 1.05}};
}

}  // namespace epode::trials
