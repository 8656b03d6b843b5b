// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sets that are joined, the root being the lowest number.
#include "view/session/islands.h"

#include <numeric>
#include <utility>

namespace epode::view {

namespace {

std::uint32_t root(std::vector<std::uint32_t>& parent, std::uint32_t i)
{
    while (parent[i] != i) i = parent[i] = parent[parent[i]];
    return i;
}

}  // namespace

std::vector<std::uint32_t> islands(const Stage& stage, const Moment& now)
{
    std::vector<std::uint32_t> parent(stage.bodies().size());
    std::iota(parent.begin(), parent.end(), 0u);
    const auto passes = [&](std::int32_t body) {
        return body >= 0 && size_t(body) < parent.size() && now.bodies[size_t(body)] &&
               !stage.bodies()[size_t(body)].kinematic;
    };
    const auto join = [&](std::int32_t a, std::int32_t b) {
        if (!passes(a) || !passes(b)) return;
        std::uint32_t low = root(parent, std::uint32_t(a)), high = root(parent, std::uint32_t(b));
        if (low > high) std::swap(low, high);
        parent[high] = low;
    };
    for (std::uint32_t joint : now.joints) join(stage.joints()[joint].body[0], stage.joints()[joint].body[1]);
    std::vector<std::int32_t> owner(stage.geoms().size(), record::kNobody);
    for (const Moment::PlacedGeom& geom : now.geoms) owner[geom.number] = geom.body;
    for (const record::Contact& contact : now.step->contacts) {
        if (contact.geom[0] < owner.size() && contact.geom[1] < owner.size())
            join(owner[contact.geom[0]], owner[contact.geom[1]]);
    }
    for (std::uint32_t i = 0; i < parent.size(); ++i) parent[i] = root(parent, i);
    return parent;
}

}  // namespace epode::view
