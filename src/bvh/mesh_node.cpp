// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays as nodes and packets see them, and putting boxes on the grid of a node: outward, by the very
// expression that is evaluated when it is asked.
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

// A little more than the box, so that its far side is within reach of the 255th step whatever is rounded.
void MeshNode::set_grid(const FloatBox& all)
{
    for (int i = 0; i < 3; ++i) {
        origin[i] = all.lo[i];
        step[i] = (all.hi[i] - all.lo[i]) / 254;
    }
}

void MeshNode::set_box(int k, const FloatBox& box)
{
    for (int i = 0; i < 3; ++i) {
        const auto place = [&](int q) { return origin[i] + float(q) * step[i]; };
        const auto nearest = [&](float x) { return std::clamp(int((x - origin[i]) / step[i]), 0, 255); };
        int low = nearest(box.lo[i]), high = nearest(box.hi[i]);
        while (low > 0 && place(low) > box.lo[i]) --low;
        while (high < 255 && place(high) < box.hi[i]) ++high;
        lo[i][k] = std::uint8_t(low);
        hi[i][k] = std::uint8_t(high);
    }
}

void MeshNode::set_none(int k)
{
    child[k] = kNone;
    for (int i = 0; i < 3; ++i) lo[i][k] = hi[i][k] = 0;
}

}  // namespace epode
