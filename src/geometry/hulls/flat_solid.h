// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the search for the least overlap asks of a solid, in the solid's own frame:
//   FlatSolid  a box or polyhedron: its vertices, faces and edges
//   RoundCore  a cylinder, or what a capsule and a sphere are without their radius: a segment and a point, as
//              cylinders whose radius, or radius and height, are zero
// Both know a point inside, and how far a point lies within them: the radius of the largest ball about it
// that the solid holds. Balls are what proves that a depth is the least (flat_overlap.h).
#pragma once

#include "geometry/convex_view.h"
#include "geometry/hulls/polyhedron.h"

namespace epode {

class FlatSolid {
  public:
    // v.kind is kBox or kPolyhedron.
    explicit FlatSolid(const ConvexView& v);
    FlatSolid(const FlatSolid&) = delete;  // the lists of a box lie within
    FlatSolid& operator=(const FlatSolid&) = delete;

    static bool is_flat(const ConvexView& v)
    {
        return v.kind == SolidKind::kBox || v.kind == SolidKind::kPolyhedron;
    }

    Vec3 support(Vec3 d) const
    {
        if (polyhedron_) return polyhedron_->support(d);
        return {d.x < 0 ? -half_.x : half_.x, d.y < 0 ? -half_.y : half_.y, d.z < 0 ? -half_.z : half_.z};
    }
    // Negative outside. May stop at a number that is less than `enough`.
    Real within(Vec3 p, Real enough) const
    {
        Real least = kInf;
        for (const PolyhedronFace& f : faces) {
            const Real d = f.offset - dot(f.normal, p);
            if (d < least) least = d;
            if (least < enough) break;
        }
        return least;
    }

    std::span<const Vec3> vertices;
    std::span<const PolyhedronFace> faces;
    std::span<const PolyhedronEdge> edges;
    Vec3 inner;
    Real inner_radius = 0;

    const Polyhedron* polyhedron() const { return polyhedron_; }

  private:
    const Polyhedron* polyhedron_ = nullptr;
    Vec3 half_;
    union {  // left unwritten unless the solid is a box
        Vec3 corner_[8];
    };
    union {
        PolyhedronFace side_[6];
    };
};

// How far a point is beyond the plane of each face.
class FaceGaps {
  public:
    FaceGaps(const FlatSolid& s, Vec3 p);
    Real operator[](std::size_t i) const { return i < kCapacity ? gap_[i] : compute(i); }

    // use(face, its gap), in their order, of all faces but the widest along which the overlap with a ball of
    // radius r about the point and its like may be less than the number that `depth` is, or by then has
    // become.
    template <typename Use>
    void each_that_may_be_less(Real r, Real handicap, const Real& depth, const Use& use) const
    {
        const auto look = [&](std::size_t i) {
            if (i != widest && r - (*this)[i] + handicap < depth) use(s_.faces[i], (*this)[i]);
        };
        const std::size_t count = s_.faces.size();
        if (count > kCapacity) {
            for (std::size_t i = 0; i < count; ++i) look(i);
            return;
        }
        for (std::size_t i = 0; i < count; i += DotLanes::kWide) {
            unsigned some = bits(quad(r) - load_quad(gap_ + i) + quad(handicap) < quad(depth));
            if (count - i < DotLanes::kWide) some &= (1u << (count - i)) - 1;
            for (; some; some &= some - 1) look(i + std::size_t(__builtin_ctz(some)));
        }
    }

    std::size_t widest = 0;

  private:
    static constexpr std::size_t kCapacity = 256;
    void compute_all();
    Real compute(std::size_t i) const { return dot(s_.faces[i].normal, p_) - s_.faces[i].offset; }

    const FlatSolid& s_;
    Vec3 p_;
    Real gap_[kCapacity];  // left unwritten beyond the last face
};

struct RoundCore {
    Real radius = 0, half_length = 0;
    static constexpr Vec3 inner{};
    Real inner_radius = 0;

    explicit RoundCore(const ConvexView& v);

    static bool is_round(const ConvexView& v)
    {
        return v.kind == SolidKind::kCylinder || v.kind == SolidKind::kSegment || v.kind == SolidKind::kPoint;
    }

    Vec3 support(Vec3 d) const
    {
        const Real rho = std::sqrt(d.x * d.x + d.y * d.y), z = d.z < 0 ? -half_length : half_length;
        if (!(rho > 4 * kEpsilon * std::fabs(d.z))) return {0, 0, z};
        return {radius * d.x / rho, radius * d.y / rho, z};
    }
    // How far the core reaches along a unit direction.
    Real reach(Vec3 d) const
    {
        return radius * std::sqrt(d.x * d.x + d.y * d.y) + half_length * std::fabs(d.z);
    }
    Real within(Vec3 p, Real) const
    {
        const Real aside = radius - std::sqrt(p.x * p.x + p.y * p.y), along = half_length - std::fabs(p.z);
        return aside < along ? aside : along;
    }
};

}  // namespace epode
