// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Names in MJCF's <custom>, where we say what the format has no word for and other programs read nothing: of texts, whether links
// that overlap at the reference position touch, and how two frictions become one; of tuples, the joints with limits of
// velocity (prm) and the sensors that feel what a joint does to the parent of its link.
#pragma once

namespace epode::robots {

constexpr const char *kOverlapsName = "epode_overlapping_links", *kOverlapsApart = "apart";
constexpr const char *kFrictionName = "epode_friction", *kFrictionMean = "mean";
constexpr const char* kVelocitiesName = "epode_max_velocity";
constexpr const char* kOnParentName = "epode_on_parent";

}  // namespace epode::robots
