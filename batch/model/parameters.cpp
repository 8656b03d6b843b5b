// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See parameters.h.
#include "batch/model/parameters.h"

#include <cmath>

namespace epode::batch {

int size_of(const BatchModel& model, Parameter parameter)
{
    switch (parameter) {
        case Parameter::kGravity:
        case Parameter::kTerrain:
            return 3;
        case Parameter::kMasses:
            return int(model.links.size());
        case Parameter::kFrictions:
        case Parameter::kTorsions:
        case Parameter::kRollings:
            return int(model.pairs.size());
        case Parameter::kGains:
            return model.controls;
        default:
            return model.velocities;
    }
}

int place_of(const BatchModel& model, Parameter parameter, int number)
{
    const auto i = std::size_t(number);
    switch (parameter) {
        case Parameter::kGravity:
            return model.gravity + number;
        case Parameter::kTerrain:
            return model.terrain + number;
        case Parameter::kMasses:
            return model.links[i].first + link_number::kMass;
        case Parameter::kFrictions:
            return model.pairs[i].first + pair_number::kFriction;
        case Parameter::kTorsions:
            return model.pairs[i].first + pair_number::kTorsion;
        case Parameter::kRollings:
            return model.pairs[i].first + pair_number::kRolling;
        case Parameter::kGains:
            return model.actuators[i].first + actuator_number::kGain;
        case Parameter::kArmatures:
            return model.dofs[i].first + dof_number::kArmature;
        case Parameter::kDampings:
            return model.dofs[i].first + dof_number::kDamping;
        default:
            return model.dofs[i].first + dof_number::kStiffness;
    }
}

bool can_be(const BatchModel& model, Parameter parameter, int number, double value)
{
    constexpr double kMost = 1e15;
    if (!(std::fabs(value) < kMost)) return false;
    if (parameter == Parameter::kGravity || parameter == Parameter::kGains ||
        parameter == Parameter::kTerrain)
        return true;
    const auto i = std::size_t(number);
    if (parameter == Parameter::kTorsions && model.pairs[i].first_turn < 0) return value == 0;
    if (parameter == Parameter::kRollings && !model.pairs[i].rolls) return value == 0;
    const bool moves = parameter == Parameter::kMasses && model.links[i].last_dof >= 0;
    const double now = model.numbers[std::size_t(place_of(model, parameter, number))];
    return moves && now > 0 ? value > 0 : value >= 0;
}

}  // namespace epode::batch
