// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs and what came of them, pair by pair.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/array.h"
#include "bvh/near_leaves.h"
#include "contacts/contact_pair.h"

namespace epode {

struct PairList {
    Array<ContactPair> pairs;
    Array<CachedManifold> manifolds;  // those of a pair lie together; there are gaps
    Array<NearLeaves> leaves;
    std::uint64_t connections = 0;  // of the world, when `tied` was right

    std::span<const CachedManifold> of(const ContactPair& pair) const
    {
        return manifolds.span().subspan(std::size_t(pair.first), pair.count);
    }
    std::span<const CachedManifold> of(int pair) const
    {
        return pair < 0 ? std::span<const CachedManifold>{} : of(pairs.data()[pair]);
    }

    std::span<CachedManifold> own(const ContactPair& pair)
    {
        return manifolds.span().subspan(std::size_t(pair.first), pair.count);
    }

    // A pair of another list, at the end. False: out of memory, and all is as it was.
    [[nodiscard]] bool append(const PairList& other, const ContactPair& pair)
    {
        ContactPair own = pair;
        const std::span<const CachedManifold> kept = other.of(pair);
        const int manifold_count = manifolds.size(), leaf_count = leaves.size();
        own.first = manifold_count;
        if (pair.on_mesh) own.leaves = leaf_count;
        if (manifolds.extend(int(kept.size())) &&
            (!pair.on_mesh || leaves.push(other.leaves.data()[pair.leaves])) && pairs.push(own)) {
            std::copy(kept.begin(), kept.end(), manifolds.data() + manifold_count);
            return true;
        }
        manifolds.truncate(manifold_count), leaves.truncate(leaf_count);
        return false;
    }

    void scale_impulses(const ContactPair& pair, float times)
    {
        if (times == 1) return;
        for (int i = pair.first; i < pair.first + pair.count; ++i)
            epode::scale_impulses(manifolds.data()[i].manifold, times);
    }

    // What is broken about one of the pairs, in words; null: nothing.
    const char* fault(const ContactPair& pair) const
    {
        if (pair.count > kSurfaceManifolds) return "contacts: a pair has more manifolds than it may";
        if (pair.count > 0 && (pair.first < 0 || pair.first + pair.count > manifolds.size()))
            return "contacts: a pair's manifolds are not in its list";
        if (pair.on_mesh && (pair.leaves < 0 || pair.leaves >= leaves.size()))
            return "contacts: a pair's leaves are not in its list";
        for (const CachedManifold& kept : of(pair)) {
            const ContactManifold& manifold = kept.manifold;
            if (manifold.count < 0 || manifold.count > kManifoldPoints)
                return "contacts: a manifold's count is wrong";
            for (int i = 0; i < manifold.count; ++i)
                if (!(manifold.points[i].normal_impulse >= 0)) return "contacts: a normal impulse pulls";
            const Vec3 n = widen(manifold.normal);
            if (manifold.count > 0 && dot(n, n) != 0 && !(std::abs(dot(n, n) - 1) < Real(1e-3)))
                return "contacts: a normal is not of unit length";
        }
        return nullptr;
    }

    void clear()
    {
        pairs.clear();
        manifolds.clear();
        leaves.clear();
    }
    void swap(PairList& other)
    {
        pairs.swap(other.pairs);
        manifolds.swap(other.manifolds);
        leaves.swap(other.leaves);
        std::swap(connections, other.connections);
    }
};

}  // namespace epode
