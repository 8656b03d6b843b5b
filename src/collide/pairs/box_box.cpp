// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box against box: the manifold of geometry/box_box.h, thinned to the four points that hold a box best.
#include "geometry/box_box.h"
#include "collide/pairs/pairs.h"

namespace epode {

void box_box(const Box& a, const Pose& A, const Box& b, const Pose& B, ContactSink& sink)
{
    BoxBox m;
    if (!box_box_manifold(a, A, b, B, m)) return;
    ContactPoint points[BoxBox::kMax];
    for (int i = 0; i < m.count; ++i) points[i] = {m.points[i], -m.normal, m.depths[i]};
    sink.add_manifold({points, std::size_t(m.count)});
}

}  // namespace epode
