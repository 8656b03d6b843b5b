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

    // From here on the seams are those that have an end no higher (along y).
    void drop_seams_above(Real y);

    int seams() const { return seam_count_; }
    const PolyhedronEdge& seam(int i) const { return solid_->seams()[std::size_t(kept_ ? kept_[i] : i)]; }
    int corner_groups() const { return corner_groups_; }
    int face_groups() const { return face_groups_; }
    const Real* corners(int group) const { return numbers_ + 12 * group; }  // x y z of four
    const Real* faces(int group) const { return faces_ + 16 * group; }      // unit outward normals, offsets
    Vec3 corner(int i) const { return at(corners(i / 4) + i % 4); }
    Vec3 normal(int face) const { return at(faces(face / 4) + face % 4); }
    Vec3 inner() const { return view_.pose.to_world(solid_->inner()); }

    // For each corner four numbers, for each face three, and for both a byte.
    Real* scratch(int row) { return scratch_ + 4 * corner_groups_ * row; }
    Real* face_scratch(int row) { return scratch_ + 16 * corner_groups_ + 4 * face_groups_ * row; }
    unsigned char* corner_marks() { return marks_; }
    unsigned char* face_marks() { return marks_ + 4 * corner_groups_; }

  private:
    static constexpr int kNumbers = 2048, kMarks = 512, kSeams = 256;  // more need memory
    static Vec3 at(const Real* p) { return {p[0], p[4], p[8]}; }
    void find();

    const ConvexView& view_;
    const Polyhedron* solid_ = nullptr;
    int corner_groups_ = 0, face_groups_ = 0, seam_count_ = 0;
    bool placed_ = false;
    Real *numbers_ = nullptr, *faces_ = nullptr, *scratch_ = nullptr;
    unsigned char* marks_ = nullptr;
    int* kept_ = nullptr;  // null: all
    union {
        Real few_[kNumbers];  // in unions: left unwritten until placed
    };
    union {
        unsigned char few_marks_[kMarks];
    };
    union {
        int few_kept_[kSeams];
    };
    Array<Real> many_;
    Array<unsigned char> many_marks_;
    Array<int> many_kept_;
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
