// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Writing contacts into the client's array, a manifold thinned to four points: geometry/best_four.h.
#include "collide/contact_sink.h"

#include "geometry/best_four.h"

namespace epode {

void ContactSink::add_manifold(std::span<const ContactPoint> points)
{
    const int count = int(points.size());
    const int left = capacity_ - count_;
    const int wanted = left < kBestFour ? left : kBestFour;
    if (count <= wanted) {
        for (const ContactPoint& p : points) add(p);
        return;
    }
    if (wanted <= 0) return;
    ManifoldPoints lanes;
    for (const ContactPoint& p : points.first(std::size_t(count < lanes.kMax ? count : lanes.kMax)))
        lanes.add(p.position, p.depth);
    int chosen[kBestFour];
    const int kept = best_four(lanes, points[0].normal, wanted, chosen);
    for (int i = 0; i < kept; ++i) add(points[std::size_t(chosen[i])]);
}

}  // namespace epode
