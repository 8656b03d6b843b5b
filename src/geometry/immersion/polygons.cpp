// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "geometry/immersion/polygons.h"

namespace epode {
namespace {

// Corner i has the sign of bit k of i along axis k.
constexpr int kBoxFaces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

}  // namespace

Immersed immersed_box(Vec3 e, const WaterPlane& half)
{
    const Real reach = dot(e, abs(half.normal));
    if (reach <= half.offset) return {8 * e.x * e.y * e.z, {}};
    if (-reach >= half.offset) return {};
    const auto corner = [&](int i) {
        return Vec3{i & 1 ? e.x : -e.x, i & 2 ? e.y : -e.y, i & 4 ? e.z : -e.z};
    };
    PolygonCut cut(half);
    for (const auto& face : kBoxFaces) cut.add_face(4, [&](int k) { return corner(face[k]); });
    return cut.result();
}

}  // namespace epode
