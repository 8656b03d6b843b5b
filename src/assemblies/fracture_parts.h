// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Lists of parts (ode/fracture.h): what is wrong with one, what its parts weigh, which of them hold together.
#pragma once

#include <span>

#include "base/array.h"
#include "collide/geom.h"
#include "geometry/inertia.h"
#include "math/pose.h"
#include "ode/fracture.h"

namespace epode {

using Parts = std::span<const dFracturePart>;

inline constexpr const char* kTwice = "a geom that is two parts";

// Null, or what is wrong.
const char* fault_of_list(const dFracturePart* parts, int count);  // each part for itself
const char* fault_of_parts(Parts parts);                           // geoms that are in it twice too

Pose pose_of_part(const dFracturePart& part);
// In the geom's frame; mass 0: its geom is no solid.
MassProperties mass_of_part(const dFracturePart& part);
// Of the parts of that group, in the frame of a pose.
MassProperties mass_of_group(Parts parts, std::span<const int> group_of, int group, const Pose& frame);

// Is it within the distance of a place in the world? `found` is false if memory is exhausted.
bool is_near(const dFracturePart& part, Vec3 place, Real distance, bool& found);
// Numbers the groups of `members`, parts of the list, that touch each other, from `first` on, and orders them by it;
// returns the number after the last. Parts touch that are nearer to each other than a hundredth of the smaller one's box.
int group_touching(Parts parts, std::span<int> members, int first, std::span<int> group_of);

}  // namespace epode
