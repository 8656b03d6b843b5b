// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two boxes, by the separating axis theorem (Gottschalk, Lin, Manocha 1996): of the 15 directions that can
// part two boxes - 3 face normals each and 9 products of edges - the one of least overlap is the contact
// normal. Faces: the other box's face that looks at the reference face is cut by the reference face's sides;
// the points below the reference face are the contacts. Edges: one point between the two edges. An edge
// direction must win by a factor, because near-parallel edges imitate face normals and the manifold would
// fall from four points to one and back: without it a thousand boxes dropped into a pit have a third fewer
// contacts and sink three times as deep into each other. The factor chooses the normal, not the depth: the
// face's deepest point lies where those edges cross, so its depth is what parts the boxes along that normal.
// Rejected: GJK/EPA here; it is slower and its normals are less steady.
#pragma once

#include <algorithm>

#include "geometry/shapes.h"

namespace epode {

inline constexpr Real kEdgeHandicap = Real(1.05);

struct BoxBox {
    static constexpr int kMax = 8;
    int code = 0;      // 1-3: face of box 1; 4-6: face of box 2; 7-15: edges; 0: apart
    Vec3 normal;       // unit, from box 1 towards box 2
    Real overlap = 0;  // of the boxes' shadows on the normal: no depth is more
    int count = 0;
    union {
        Vec3 points[kMax];  // in a union: left unwritten until found
    };
    Real depths[kMax];  // each >= -margin
    BoxBox() {}
    // How far the boxes must move apart along the normal, if no point was left out.
    Real deepest() const { return *std::max_element(depths, depths + count); }
};

bool boxes_touch(const Box& a, const Pose& A, const Box& b, const Pose& B);

// The manifold; false when the boxes are apart. Of more than `capacity` points the best are kept: the best
// four (geometry/best_four.h), then others as they come. Corners over a face and apart from it by no more
// than `margin` count where fewer than `capacity` touch.
bool box_box_manifold(const Box& a, const Pose& A, const Box& b, const Pose& B, BoxBox& out,
                      int capacity = BoxBox::kMax, Real margin = 0);

}  // namespace epode
