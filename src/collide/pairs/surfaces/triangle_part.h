// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The part of a polygon over a triangle of a mesh. Each corner records whether a seam has made it: such a
// corner is no corner of the manifold, which continues in the neighbour.
#pragma once

#include "collide/pairs/surfaces/mesh_facet.h"

namespace epode {

struct TrianglePart {
    static constexpr int kMax = Polygon::kMax + 3;  // each cut adds one corner at most
    union {
        Vec3 points[kMax];  // in a union: left unwritten until added
    };
    bool seam[kMax];
    int count = 0;
    TrianglePart() {}
    void add(Vec3 p, bool by_seam)
    {
        if (count < kMax) points[count] = p, seam[count++] = by_seam;
    }
};

// The prism of a triangle about a direction, of a facet about its normal: what is in it has out . x <= limit.
struct Prism {
    Prism() = default;
    Prism(const Triangle& triangle, Vec3 direction);
    explicit Prism(const MeshFacet& facet);
    Vec3 out[3];  // unit, or zero for an edge without length
    Real limit[3];
    bool seam[3] = {};
};

// Cuts by the prism. `seams`: false makes all cuts count.
void cut_to_prism(TrianglePart& part, const Prism& prism, bool seams, Real slack);

}  // namespace epode
