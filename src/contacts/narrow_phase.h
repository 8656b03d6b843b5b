// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From a pair to its patches. Two geoms that have hardly moved against each other since they were collided
// keep the points they had, fixed in both bodies, and only the gaps are measured anew: a tenth of the cost,
// and points of a settled pile do not wander. How much is hardly: 2 % of the smaller one's size for a patch
// that is full (four points under a face: no new point can appear that matters), a quarter of the surface
// layer for all others. What is collided again finds its impulses by place.
#pragma once

#include <span>

#include "contacts/contact_pair.h"

namespace epode {

struct NarrowSettings {
    Real layer;    // allowed depth, m
    Real h;        // s, until the pair is looked at again
    Vec3 gravity;  // m/s^2
};

// `parts` are the records of one pair, `old` those of the step before or empty. Pairs may be updated at the
// same time, unless functions of the program are asked about them.
void update_pair(std::span<ContactPair> parts, std::span<const ContactPair> old,
                 const NarrowSettings& settings);

}  // namespace epode
