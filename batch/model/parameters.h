// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers of the model that copies may have of their own: where each stands among BatchModel's numbers, and what it may be.
#pragma once

#include "batch/model/batch_model.h"

namespace epode::batch {

enum class Parameter {
    kGravity,
    kMasses,
    kFrictions,
    kArmatures,
    kDampings,
    kStiffnesses,
    kGains,
    kTerrain,
    kTorsions,
    kRollings,
    kCount
};

int size_of(const BatchModel& model, Parameter parameter);
int place_of(const BatchModel& model, Parameter parameter, int number);
// Masses of moving links are above 0, those of others 0 or more; gravity and gains any, the rest 0 or more; all below 1e15.
// Frictions against turning of pairs without them are 0.
bool can_be(const BatchModel& model, Parameter parameter, int number, double value);

// Calls each(place, value) of every number that follows from a parameter's: with a mass the inertia about its centre is the model's in
// proportion, whatever it was before. `models` are the model's own numbers.
template <typename T, typename Each>
void each_number(const BatchModel& model, const T* models, Parameter parameter, int number, T value,
                 const Each& each)
{
    const int place = place_of(model, parameter, number);
    each(place, value);
    if (parameter != Parameter::kMasses || !(models[place] > 0)) return;
    const int inertia = place - link_number::kMass + link_number::kInertia;
    for (int k = inertia; k < inertia + 6; ++k) each(k, models[k] * (value / models[place]));
}

}  // namespace epode::batch
