// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A polyhedron at its pose against many facets of a surface: its corners and the planes of its faces in the
// surface's frame, four side by side, computed once on first use, and room for what is known of each corner
// about one facet. The last ones repeat where four do not come out even.
#pragma once

#include <array>
#include <bit>
#include <cstring>
#include <span>

#include "geometry/hulls/polyhedron.h"
#include "simd/quad.h"

namespace epode {

class PlacedHull {
  public:
    // Of any other solid, and without memory, it is not there.
    explicit PlacedHull(const ConvexView& view);
    PlacedHull(const PlacedHull&) = delete;
    PlacedHull& operator=(const PlacedHull&) = delete;

    bool there() const { return solid_ != nullptr; }
    void place()  // before anything below
    {
        if (!placed_) find();
    }

    // Leaves out what a field cannot touch that is nowhere higher than y and steeper than a sine: seams that have
    // no end so low (along y), or no face that looks down at such a field, and corners and faces at none. Faces
    // that are left have other numbers than in the polyhedron.
    void keep_for_field(Real y, Real sine);

    std::span<const PolyhedronEdge> seams() const
    {
        return {kept_ ? kept_ : solid_->seams().data(), std::size_t(seam_count_)};
    }
    std::span<const int> corner_groups() const { return {groups_, std::size_t(kept_corner_groups_)}; }
    int face_groups() const { return kept_face_groups_; }
    const Real* corners(int group) const { return numbers_ + 12 * group; }   // x y z of four
    const Real* faces(int group) const { return kept_faces_ + 16 * group; }  // unit outward normals, offsets
    // Of all faces, left out or not.
    int all_face_groups() const { return face_groups_; }
    const Real* all_faces(int group) const { return faces_ + 16 * group; }
    Vec3 corner(int i) const { return at(corners(i / 4) + i % 4); }
    Vec3 normal(int face) const { return at(faces(face / 4) + face % 4); }
    Vec3 inner() const { return view_.pose.to_world(solid_->inner()); }

    // For each corner four numbers, for each face three, and for both a byte.
    Real* scratch(int row) { return scratch_ + 4 * corner_groups_ * row; }
    Real* face_scratch(int row) { return scratch_ + 16 * corner_groups_ + 4 * face_groups_ * row; }
    unsigned char* corner_marks() { return marks_; }
    unsigned char* face_marks() { return marks_ + 4 * corner_groups_; }

  private:
    static constexpr int kNumbers = 1728, kMarks = 256, kSeams = 128;  // more need memory
    static Vec3 at(const Real* p) { return {p[0], p[4], p[8]}; }
    void find();
    void mark_faces_down(Real sine);
    void keep_seams(Real y);
    void keep_corners();
    void keep_faces();
    void copy_face(int from, int to);

    const ConvexView& view_;
    const Polyhedron* solid_ = nullptr;
    int corner_groups_ = 0, face_groups_ = 0, seam_count_ = 0;
    bool placed_ = false;
    Real *numbers_ = nullptr, *faces_ = nullptr, *kept_faces_ = nullptr, *scratch_ = nullptr;
    unsigned char* marks_ = nullptr;
    PolyhedronEdge* kept_ = nullptr;  // null: all
    int* groups_ = nullptr;           // of corners; then numbers of faces
    int kept_corner_groups_ = 0, kept_face_groups_ = 0;
    union {
        Real few_[kNumbers];  // in unions: left unwritten until placed
    };
    union {
        unsigned char few_marks_[kMarks];
    };
    union {
        PolyhedronEdge few_kept_[kSeams];
    };
    union {
        int few_groups_[kMarks];
    };
    Array<Real> many_;
    Array<unsigned char> many_marks_;
    Array<PolyhedronEdge> many_kept_;
    Array<int> many_groups_;
};

namespace {

// The four bits of a mask as the lowest bits of four bytes side by side.
inline std::uint32_t byte_each(unsigned mask)
{
    constexpr auto kBytes = [] {
        std::array<std::uint32_t, 16> all{};
        for (unsigned m = 0; m < 16; ++m)
            all[m] = std::bit_cast<std::uint32_t>(
                std::array<unsigned char, 4>{(unsigned char)(m & 1), (unsigned char)(m >> 1 & 1),
                                             (unsigned char)(m >> 2 & 1), (unsigned char)(m >> 3)});
        return all;
    }();
    return kBytes[mask];
}
inline void store_bytes(unsigned char* to, std::uint32_t four) { std::memcpy(to, &four, 4); }

struct QuadPlane {
    Quad x, y, z;
    explicit QuadPlane(Vec3 n) : x(quad(n.x)), y(quad(n.y)), z(quad(n.z)) {}
    // Along n, of four corners or four faces' normals.
    EPODE_LANEWISE Quad along(const Real* four) const
    {
        return load_quad(four) * x + load_quad(four + 4) * y + load_quad(four + 8) * z;
    }
};

}  // namespace
}  // namespace epode
