// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/steppers/stepper.h"

#include "ode/steppers.h"

namespace epode {

const Stepper* stepper_numbered(int number)
{
    constexpr int kNoNumber = -1;
    struct Line {
        int number;
        const Stepper* stepper;
    };
    static constexpr Line kLines[] = {
#define STEPPER(name, number) {number, &k##name},
#include "step/steppers/steppers.inc"
#undef STEPPER
    };
    for (const Line& line : kLines)
        if (line.number == number && number != kNoNumber) return line.stepper;
    return nullptr;
}

int hybrid_iterations(const World& world, const Stepper& stepper)
{
    return stepper.has_substeps ? world.hybrid_substeps : world.quick_iterations;
}

}  // namespace epode
