// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Box against box: the manifold of geometry/overlap/box_box.h. A program gets all of its up to eight points, as from
// ODE: four of the eight corners of two squares turned by 45 degrees carry a box less far. A manifold of ours
// is reduced to the four that hold a box best. A few products find boxes whose bounding balls are apart, as
// those of many boxes are whose bounding boxes overlap by a corner: the sum of the radii is at most
// sqrt(2 (ra^2 + rb^2)).
#include "geometry/overlap/box_box.h"
#include "collide/pairs/at_once.h"
#include "geometry/best_four.h"

namespace epode {

void box_box(const Box& a, const Pose& A, const Box& b, const Pose& B, ContactSink& sink)
{
    constexpr Real kTwo = Real(2.0001);
    if (length2(B.p - A.p) > kTwo * (length2(a.half) + length2(b.half))) return;
    const int left = sink.capacity() - sink.count();
    const int capacity = sink.to_program() || left < kBestFour ? left : kBestFour;
    BoxBox m;
    if (capacity <= 0 || !box_box_manifold(a, A, b, B, m, capacity, sink.margin())) return;
    for (int i = 0; i < m.count; ++i) sink.add({m.points[i], -m.normal, m.depths[i]});
}

EPODE_AT_ONCE(Box, Box, box_box)

}  // namespace epode
