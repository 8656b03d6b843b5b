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
    Array<KeptPatch> patches;  // those of a pair lie together; there are gaps
    Array<NearLeaves> leaves;
    std::uint64_t ties = 0;  // of the world, when `tied` was right

    std::span<const KeptPatch> of(const ContactPair& pair) const
    {
        return patches.span().subspan(std::size_t(pair.first), pair.count);
    }
    std::span<const KeptPatch> of(int pair) const
    {
        return pair < 0 ? std::span<const KeptPatch>{} : of(pairs.data()[pair]);
    }

    // A pair of another list, at the end. False: out of memory, and all is as it was.
    [[nodiscard]] bool append(const PairList& other, const ContactPair& pair)
    {
        ContactPair own = pair;
        const std::span<const KeptPatch> kept = other.of(pair);
        const int patch_count = patches.size(), leaf_count = leaves.size();
        own.first = patch_count;
        if (pair.on_mesh) own.leaves = leaf_count;
        if (patches.extend(int(kept.size())) &&
            (!pair.on_mesh || leaves.push(other.leaves.data()[pair.leaves])) && pairs.push(own)) {
            std::copy(kept.begin(), kept.end(), patches.data() + patch_count);
            return true;
        }
        patches.truncate(patch_count), leaves.truncate(leaf_count);
        return false;
    }

    // What is broken about one of the pairs, in words; null: nothing.
    const char* fault(const ContactPair& pair) const
    {
        if (pair.count > kSurfacePatches) return "contacts: a pair has more manifolds than it may";
        if (pair.count > 0 && (pair.first < 0 || pair.first + pair.count > patches.size()))
            return "contacts: a pair's manifolds are not in its list";
        if (pair.on_mesh && (pair.leaves < 0 || pair.leaves >= leaves.size()))
            return "contacts: a pair's leaves are not in its list";
        for (const KeptPatch& kept : of(pair)) {
            const Patch& patch = kept.patch;
            if (patch.count < 0 || patch.count > kPatchPoints) return "contacts: a manifold's count is wrong";
            for (int i = 0; i < patch.count; ++i)
                if (!(patch.points[i].push >= 0)) return "contacts: a normal impulse pulls";
            const Vec3 n = widen(patch.normal);
            if (patch.count > 0 && !(std::abs(dot(n, n) - 1) < Real(1e-3)))
                return "contacts: a normal is not of unit length";
        }
        return nullptr;
    }

    void clear()
    {
        pairs.clear();
        patches.clear();
        leaves.clear();
    }
    void swap(PairList& other)
    {
        pairs.swap(other.pairs);
        patches.swap(other.patches);
        leaves.swap(other.leaves);
        std::swap(ties, other.ties);
    }
};

}  // namespace epode
