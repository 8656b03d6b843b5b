// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See placed_hull.h.
#include "collide/pairs/polyhedra/placed_hull.h"

namespace epode {

PlacedHull::PlacedHull(const ConvexView& view) : view_(view)
{
    if (view.kind != SolidKind::kPolyhedron) return;
    const Polyhedron& solid = *static_cast<const Polyhedron*>(view.shape);
    corner_groups_ = (int(solid.vertices().size()) + 3) / 4,
    face_groups_ = (int(solid.faces().size()) + 3) / 4;
    const int numbers = 28 * (corner_groups_ + face_groups_), marks = 4 * (corner_groups_ + face_groups_);
    const bool few = numbers <= kNumbers && marks <= kMarks;
    if (!few && (!many_.resize(numbers) || !many_marks_.resize(marks))) return;
    numbers_ = few ? few_ : many_.data(), marks_ = few ? few_marks_ : many_marks_.data();
    faces_ = numbers_ + 12 * corner_groups_, scratch_ = faces_ + 16 * face_groups_;
    solid_ = &solid, seam_count_ = int(solid.seams().size());
}

void PlacedHull::drop_seams_above(Real y)
{
    place();
    const std::span<const PolyhedronEdge> seams = solid_->seams();
    const int all = int(seams.size());
    if (all > kSeams && !many_kept_.resize(all)) return;
    kept_ = all > kSeams ? many_kept_.data() : few_kept_;
    seam_count_ = 0;
    for (int i = 0; i < all; ++i) {
        kept_[seam_count_] = i;
        const PolyhedronEdge& seam = seams[std::size_t(i)];
        seam_count_ += corner(seam.from).y <= y || corner(seam.to).y <= y;
    }
}

void PlacedHull::find()
{
    placed_ = true;
    const Mat3& R = view_.pose.R;
    const Vec3 p = view_.pose.p;
    const QuadPlane rows[3] = {QuadPlane(R.row0), QuadPlane(R.row1), QuadPlane(R.row2)};
    const std::span<const Vec3> corners = solid_->vertices();
    for (int g = 0; g < corner_groups_; ++g) {
        Real own[12], *const placed = numbers_ + 12 * g;
        for (int i = 0; i < 4; ++i) {
            const Vec3 v = corners[std::min(std::size_t(4 * g + i), corners.size() - 1)];
            own[i] = v.x, own[4 + i] = v.y, own[8 + i] = v.z;
        }
        for (int k = 0; k < 3; ++k) store_quad(placed + 4 * k, rows[k].along(own) + quad(p[k]));
    }
    for (int g = 0; g < face_groups_; ++g) {
        const Real* const own = solid_->face_lanes().group(g);
        Real* const placed = faces_ + 16 * g;
        Quad offset = load_quad(own + 12);
        for (int k = 0; k < 3; ++k) {
            const Quad n = rows[k].along(own);
            store_quad(placed + 4 * k, n);
            offset = offset + n * quad(p[k]);
        }
        store_quad(placed + 12, offset);
    }
}

}  // namespace epode
