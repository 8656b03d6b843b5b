// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Prepares rays for nodes and packets, and quantises boxes to the grid of a node: outward, by the same
// expression that is evaluated in a query.
#include "bvh/mesh_packet.h"

#include <algorithm>

namespace epode {

NodeRay::NodeRay(Vec3 o, Vec3 d)
{
    constexpr float kTiny = 1e-20f;
    for (int i = 0; i < 3; ++i) {
        const float along = float(d[i]);
        down[i] = along < 0;
        origin[i] = float(o[i]);
        inverse[i] = 1 / (std::fabs(along) > kTiny ? along : down[i] ? -kTiny : kTiny);
    }
}

PacketRay::PacketRay(Vec3 o, Vec3 d)
{
    const Vec3 a = abs(d);
    z = a.x > a.y ? (a.x > a.z ? 0 : 2) : (a.y > a.z ? 1 : 2);
    x = (z + 1) % 3, y = (z + 2) % 3;
    for (int i = 0; i < 3; ++i) origin[i] = float(o[i]);
    shear[0] = float(d[x] / d[z]), shear[1] = float(d[y] / d[z]);
    per_z = float(1 / d[z]);
}

void GridSteps::enclose(float low, float high, std::uint8_t& lo, std::uint8_t& hi) const
{
    const auto place = [&](int q) { return origin + float(q) * step; };
    const auto nearest = [&](float x) { return std::clamp(int((x - origin) / step), 0, 255); };
    int from = nearest(low), to = nearest(high);
    while (from > 0 && place(from) > low) --from;
    while (to < 255 && place(to) < high) ++to;
    lo = std::uint8_t(from), hi = std::uint8_t(to);
}

void MeshNode::place(const FloatBox* boxes, const FloatBox& all)
{
    for (int i = 0; i < 3; ++i) {
        const GridSteps grid(all.lo[i], all.hi[i]);
        origin[i] = grid.origin, step[i] = grid.step;
        for (int k = 0; k < count; ++k) grid.enclose(boxes[k].lo[i], boxes[k].hi[i], lo[i][k], hi[i][k]);
    }
}

}  // namespace epode
