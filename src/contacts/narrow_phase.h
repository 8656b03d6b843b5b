// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From a pair to its manifolds. Two geoms that have hardly moved against each other since they were collided
// keep the points they had, fixed in both bodies, and only the gaps are measured again: a tenth of the cost,
// and points of a settled pile do not wander. How much is hardly: 2 % of the smaller one's size for a
// manifold that misses nothing, as do four points under a face, and those of two polyhedra, which are found
// with a margin of as much; a quarter of the surface layer for others. Round solids that do not stand on a face are collided in every step: where they touch is
// no point of them, and one that rolls would leave its normal and its points behind, and be pushed on by them. What is collided again finds its
// impulses by place. Pairs that did not touch get a separation test first (contacts/ahead/pair_separation.h).
#pragma once

#include <span>

#include "bvh/near_leaves.h"
#include "contacts/ahead/speculative_motion.h"
#include "contacts/contact_pair.h"

namespace epode {

struct NarrowSettings {
    Real layer;   // allowed depth, m; less between small geoms
    bool is_set;  // by the program
    SpeculativeMotion soon;
    bool foresees;  // what does not touch yet is looked at where it will be
};

// Brings up to date what is known of a pair that may touch: `old` are its manifolds of the step before,
// `into` room for pair.most new ones; the pair gets their count. `leaves`: what is kept of a mesh, or null.
// Pairs may be updated at the same time, unless functions of the program are asked about them.
void update_pair(ContactPair& pair, std::span<const CachedManifold> old, const NarrowSettings& settings,
                 CachedManifold* into, NearLeaves* leaves);

// Normal, arms and coefficients of a manifold between two whose bodies have not moved since, or were put to
// sleep by the program: as its anchors lie now; gaps, layer and impulses stay. So nothing of it has to be in
// states of the world.
void place_again(const ContactPair& pair, CachedManifold& kept);
// Loaded from a state, and not placed since.
inline bool is_unplaced(const CachedManifold& kept)
{
    const Float3 n = kept.manifold.normal;
    return n.x == 0 && n.y == 0 && n.z == 0;
}

}  // namespace epode
