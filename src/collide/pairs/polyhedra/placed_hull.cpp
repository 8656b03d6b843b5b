// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See placed_hull.h.
#include "collide/pairs/polyhedra/placed_hull.h"

namespace epode {

namespace {

// Marks of what is left: a face that looks down, one at a seam; an end of a seam, a low corner.
constexpr unsigned char kDown = 1, kAtSeam = 2, kSeamEnd = 1, kLowCorner = 2;

}  // namespace

PlacedHull::PlacedHull(const ConvexView& view) : view_(view)
{
    if (view.kind != SolidKind::kPolyhedron) return;
    const Polyhedron& solid = *static_cast<const Polyhedron*>(view.shape);
    corner_groups_ = (int(solid.vertices().size()) + 3) / 4,
    face_groups_ = (int(solid.faces().size()) + 3) / 4;
    const int numbers = 28 * corner_groups_ + 44 * face_groups_, marks = 4 * (corner_groups_ + face_groups_);
    const bool few = numbers <= kNumbers && marks <= kMarks;
    if (!few && (!many_.resize(numbers) || !many_marks_.resize(marks) || !many_groups_.resize(marks))) return;
    numbers_ = few ? few_ : many_.data(), marks_ = few ? few_marks_ : many_marks_.data();
    groups_ = few ? few_groups_ : many_groups_.data();
    faces_ = kept_faces_ = numbers_ + 12 * corner_groups_, scratch_ = faces_ + 32 * face_groups_;
    solid_ = &solid, seam_count_ = int(solid.seams().size());
}

// The normals that lean less than a right angle away from one that is so steep.
void PlacedHull::mark_faces_down(Real sine)
{
    for (int g = 0; g < face_groups_; ++g)
        store_bytes(face_marks() + 4 * g, byte_each(bits(load_quad(faces(g) + 4) <= quad(sine))));
}

void PlacedHull::keep_seams(Real y)
{
    unsigned char *const ends = corner_marks(), *const left = face_marks();
    for (int g = 0; g < corner_groups_; ++g)
        store_bytes(ends + 4 * g, byte_each(bits(load_quad(corners(g) + 4) <= quad(y))) * kLowCorner);
    PolyhedronEdge* to = kept_;
    for (const PolyhedronEdge& seam : solid_->seams()) {
        if (!((left[seam.left] | left[seam.right]) & kDown)) continue;
        if (!((ends[seam.from] | ends[seam.to]) & kLowCorner)) continue;
        *to++ = seam;
        ends[seam.from] |= kSeamEnd, ends[seam.to] |= kSeamEnd;
        left[seam.left] |= kAtSeam, left[seam.right] |= kAtSeam;
    }
    seam_count_ = int(to - kept_);
}

void PlacedHull::keep_corners()
{
    kept_corner_groups_ = 0;
    for (int g = 0; g < corner_groups_; ++g) {
        std::uint32_t four;
        std::memcpy(&four, corner_marks() + 4 * g, 4);
        groups_[kept_corner_groups_] = g;
        kept_corner_groups_ += (four & 0x01010101u * kSeamEnd) != 0;
    }
}

void PlacedHull::copy_face(int from, int to)
{
    const Real* const source = faces_ + 16 * (from / 4) + from % 4;
    Real* const target = kept_faces_ + 16 * (to / 4) + to % 4;
    for (const int k : {0, 4, 8, 12}) target[k] = source[k];
}

// In their order; the last one again where four do not come out even.
void PlacedHull::keep_faces()
{
    const unsigned char* const left = face_marks();
    int* const numbers = groups_ + corner_groups_;
    kept_faces_ = faces_ + 16 * face_groups_;
    int count = 0, last = 0;
    for (int i = 0; i < int(solid_->faces().size()); ++i)
        if (left[i]) {
            copy_face(last = i, count);
            numbers[i] = count++;
        }
    for (int i = 0; i < seam_count_; ++i)
        kept_[i].left = numbers[kept_[i].left], kept_[i].right = numbers[kept_[i].right];
    for (; count % 4; ++count) copy_face(last, count);
    kept_face_groups_ = count / 4;
}

void PlacedHull::keep_for_field(Real y, Real sine)
{
    place();
    const int all = int(solid_->seams().size());
    if (all > kSeams && !many_kept_.resize(all)) return;
    kept_ = all > kSeams ? many_kept_.data() : few_kept_;
    mark_faces_down(sine);
    keep_seams(y);
    keep_corners();
    keep_faces();
    std::memset(face_marks(), 0, std::size_t(4 * face_groups_));
}

void PlacedHull::find()
{
    placed_ = true;
    kept_corner_groups_ = corner_groups_, kept_face_groups_ = face_groups_;
    for (int g = 0; g < corner_groups_; ++g) groups_[g] = g;
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
