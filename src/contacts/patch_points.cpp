// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/patch_points.h"

#include <algorithm>
#include <bit>
#include <cstdint>

#include "geometry/best_four.h"

namespace epode {
namespace {

constexpr Real kReach = Real(0.1);  // of the size

Real distance2(Float3 a, Float3 b) { return length2(widen(a) - widen(b)); }

// Index of the largest of score(0) ... score(count - 1), the first of equals.
template <typename Score>
int best_of(int count, Score&& score)
{
    int best = 0;
    Real most = score(0);
    for (int i = 1; i < count; ++i)
        if (const Real s = score(i); s > most) most = s, best = i;
    return best;
}

}  // namespace

PatchMaker::PatchMaker(std::span<KeptPatch> parts) : parts_(parts)
{
    for (KeptPatch& part : parts_) part.patch.count = 0;
}

// The patch of that normal, a new one, or when there is no more the one that is nearest.
int PatchMaker::part_for(Vec3 normal)
{
    const auto agreement = [&](int i) { return dot(widen(parts_[std::size_t(i)].patch.normal), normal); };
    const int nearest = used_ ? best_of(used_, agreement) : -1;
    if (nearest >= 0 && (agreement(nearest) > kPatchCosine || used_ == int(parts_.size()))) return nearest;
    parts_[std::size_t(used_)].patch.normal = narrow(normal);
    return used_++;
}

void PatchMaker::add(const dContactGeom& contact)
{
    const int part = part_for(load(contact.normal));
    if (counts_[part] < kMost) chosen_[part][counts_[part]++] = &contact;
}

void PatchMaker::finish()
{
    for (int part = 0; part < used_; ++part) {
        if (counts_[part] > kPatchPoints) keep_four(part);
        parts_[std::size_t(part)].patch.count = counts_[part];
    }
}

void PatchMaker::keep_four(int part)
{
    const dContactGeom** points = chosen_[part];
    ManifoldPoints lanes;
    for (int i = 0; i < counts_[part]; ++i) lanes.add(load(points[i]->pos), points[i]->depth);
    int best[kBestFour];
    const int count = best_four(lanes, widen(parts_[std::size_t(part)].patch.normal), kPatchPoints, best);
    std::uint64_t kept = 0;
    for (int i = 0; i < count; ++i) kept |= std::uint64_t(1) << best[i];
    counts_[part] = 0;
    for (; kept; kept &= kept - 1) points[counts_[part]++] = points[std::countr_zero(kept)];
}

void inherit_impulses(const KeptPatch& was, Real size, KeptPatch& part)
{
    const Real reach2 = kReach * kReach * size * size;
    bool taken[kPatchPoints] = {};
    for (int i = 0; i < part.patch.count; ++i) {
        if (was.patch.count == 0) return;
        const ContactAnchor& here = part.anchors[i];
        const auto nearness = [&](int j) {
            const ContactAnchor& there = was.anchors[j];
            return taken[j] ? -kInf : -std::min(distance2(here.a1, there.a1), distance2(here.a2, there.a2));
        };
        const int j = best_of(was.patch.count, nearness);
        if (-nearness(j) > reach2) continue;
        taken[j] = true;
        part.patch.points[i].push = was.patch.points[j].push;
        part.patch.points[i].friction = was.patch.points[j].friction;
        part.patch.roll = was.patch.roll;
    }
}

}  // namespace epode
