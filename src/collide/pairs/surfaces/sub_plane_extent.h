// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sub-plane extent: how far the part of a solid that is under the plane of a height field's facet reaches. A
// solid that lies on terrain is near many facets and under the planes of few. If the part under a facet's
// plane does not reach into the facet's column, the solid does not touch the terrain there, and the facet
// needs no search for directions. A lane is a facet, four lanes are two cells: v is its corner at the right
// angle, `slope` its rise along x and z; heights over it are vertical. The extent is measured along three
// directions, inward from the column's walls: x and z, and the diagonal x / dx + z / dz.
// Bounds, not the true extents: a box's part is its lowest corner p and t_i times the edges a_i there, with
// 0 <= t_i <= 1 and sum t_i (rise of a_i) <= depth of p; a cylinder's the same of its axis and of its discs,
// seen as rectangles; of a ball the smaller ball about the circle in which it cuts the plane. All is in an
// unnamed namespace for the reason given in simd/pack.h.
#pragma once

#include "geometry/shapes.h"
#include "simd/pack_algebra.h"
#include "simd/quad.h"

namespace epode {
namespace {

using Quad3 = Vec3Of<Quad>;
EPODE_LANEWISE Quad3 quad(Vec3 a) { return {quad(a.x), quad(a.y), quad(a.z)}; }

struct FieldPlanes {
    Quad3 v;
    Quad slope_x, slope_z;
    Quad hair;  // what is no higher than this is under it
    EPODE_LANEWISE Quad rise(const Quad3& d) const { return d.y - slope_x * d.x - slope_z * d.z; }
    EPODE_LANEWISE Quad3 normal() const { return {quad(0) - slope_x, quad(1), quad(0) - slope_z}; }
};

// Along the three directions, each inward.
struct FieldExtents {
    Quad along[3];
};

class FieldFrame {
  public:
    FieldFrame(Vec3 cell, Real slack)
        : per_x_(1 / cell.x), per_z_(1 / cell.z), walls_{-slack, -slack, -1 - slack * (per_x_ + per_z_)}
    {}
    Real per_x() const { return per_x_; }
    Real per_z() const { return per_z_; }
    // Facets with A and with D in turn.
    EPODE_LANEWISE static Quad side() { return quad(1, -1, 1, -1); }
    EPODE_LANEWISE FieldExtents inward(const Quad3& d) const
    {
        const Quad x = side() * d.x, z = side() * d.z;
        return {{x, z, quad(-per_x_) * x - quad(per_z_) * z}};
    }
    // Which of the farthest places inward are over all walls.
    EPODE_LANEWISE unsigned over(const FieldExtents& reach) const
    {
        return bits(quad(walls_[0]) <= reach.along[0]) & bits(quad(walls_[1]) <= reach.along[1]) &
               bits(quad(walls_[2]) <= reach.along[2]);
    }

  private:
    Real per_x_, per_z_, walls_[3];
};

// Edges from a lowest corner, or what stands for them, with their rises (at least 0).
class CornerReach {
  public:
    EPODE_LANEWISE CornerReach(const FieldExtents& corner, const Quad& depth) : corner_(corner), depth_(depth)
    {
        for (int w = 0; w < 3; ++w) sum_[w] = largest_[w] = quad(0);
    }
    EPODE_LANEWISE void edge(const FieldExtents& edge, const Quad& rise)
    {
        // An edge that hardly rises is bounded by its length; what it adds to the other bound is nothing.
        const Quad far = depth_ / larger(rise, quad(Real(1e-30))), share = smaller(far, quad(1));
        for (int w = 0; w < 3; ++w) {
            const Quad along = larger(edge.along[w], quad(0));
            sum_[w] = sum_[w] + along * share;
            largest_[w] = larger(along * far, largest_[w]);
        }
    }
    EPODE_LANEWISE FieldExtents reach() const
    {
        FieldExtents all;
        for (int w = 0; w < 3; ++w) all.along[w] = corner_.along[w] + smaller(largest_[w], sum_[w]);
        return all;
    }

  private:
    FieldExtents corner_;
    Quad depth_, sum_[3], largest_[3];
};

// met(planes): which of the facets the solid may touch, a bit for each. Nothing is known of polyhedra.
template <typename Shape>
class SubPlaneExtent;

template <>
class SubPlaneExtent<Box> {
  public:
    SubPlaneExtent(const Box& box, const Pose& pose, const FieldFrame& frame) : frame_(frame), middle_(pose.p)
    {
        const Real half[3] = {box.half.x, box.half.y, box.half.z};
        for (int i = 0; i < 3; ++i) arm_[i] = half[i] * pose.R.column(i);
    }
    unsigned met(const FieldPlanes& planes) const
    {
        const Quad3 way = quad(middle_) - planes.v;
        Quad rise[3], depth = planes.hair - planes.rise(way);
        for (int i = 0; i < 3; ++i) {
            rise[i] = planes.rise(quad(arm_[i]));
            depth = depth + magnitude(rise[i]);
        }
        const unsigned sinking = bits(quad(0) <= depth);
        if (!sinking) return 0;
        Quad3 corner = way, up[3];
        for (int i = 0; i < 3; ++i) {
            up[i] = if_less(rise[i], quad(0), quad(-1), quad(1)) * quad(arm_[i]);
            corner = corner - up[i];
        }
        CornerReach part(frame_.inward(corner), depth);
        for (int i = 0; i < 3; ++i) part.edge(frame_.inward(quad(2) * up[i]), quad(2) * magnitude(rise[i]));
        return sinking & frame_.over(part.reach());
    }

  private:
    const FieldFrame& frame_;
    Vec3 middle_, arm_[3];
};

template <>
class SubPlaneExtent<Cylinder> {
  public:
    SubPlaneExtent(const Cylinder& cylinder, const Pose& pose, const FieldFrame& frame)
        : frame_(frame),
          radius_(cylinder.radius),
          middle_(pose.p),
          axis_(pose.R.column(2)),
          half_(cylinder.half_length * axis_)
    {
        Vec3 other;
        plane_space(axis_, aside_, other);
    }
    unsigned met(const FieldPlanes& planes) const
    {
        const Quad3 way = quad(middle_) - planes.v, m = planes.normal(), axis = quad(axis_);
        const Quad along = dot(axis, m), rise = planes.rise(quad(half_));
        const Quad3 across = m - along * axis;
        const Quad size = square_root(dot(across, across)), r = quad(radius_), drop = r * size;
        const Quad depth = planes.hair - planes.rise(way) + magnitude(rise) + drop;
        const unsigned sinking = bits(quad(0) <= depth);
        if (!sinking) return 0;
        // If the axis is (nearly) normal to the plane, every direction across is as deep: take any, with the whole disc.
        const Quad least = quad(Real(1e-6)) * magnitude(along), per = quad(1) / larger(size, least);
        const Quad3 up = {if_less(least, size, per * across.x, quad(aside_.x)),
                          if_less(least, size, per * across.y, quad(aside_.y)),
                          if_less(least, size, per * across.z, quad(aside_.z))};
        const Quad high = smaller(if_less(least, size, depth * per, r), r);
        const Quad3 half = if_less(along, quad(0), quad(-1), quad(1)) * quad(half_);
        CornerReach part(frame_.inward(way - half - r * up), depth);
        part.edge(frame_.inward(quad(2) * half), quad(2) * magnitude(rise));
        part.edge(frame_.inward((r + r) * up), if_less(least, size, drop + drop, quad(0)));
        // Half the chord at the top of the part.
        const Quad width = square_root(high * (r + r - high));
        const FieldExtents sideways = frame_.inward(cross(quad(axis_), up));
        FieldExtents reach = part.reach();
        for (int w = 0; w < 3; ++w) reach.along[w] = reach.along[w] + width * magnitude(sideways.along[w]);
        return sinking & frame_.over(reach);
    }

  private:
    const FieldFrame& frame_;
    Real radius_;
    Vec3 middle_, axis_, half_, aside_;
};

// A ball, or one that is moved by `half` either way.
template <bool kMoved>
class RoundUnder {
  public:
    RoundUnder(Vec3 middle, Vec3 half, Real radius, const FieldFrame& frame)
        : frame_(frame),
          middle_(middle),
          half_(half),
          radius_(radius),
          diagonal_(std::sqrt(frame.per_x() * frame.per_x() + frame.per_z() * frame.per_z()))
    {}
    unsigned met(const FieldPlanes& planes) const
    {
        const Quad3 m = planes.normal(), way = quad(middle_) - planes.v;
        const Quad size2 = dot(m, m), more = quad(radius_) + planes.hair, limit2 = more * more * size2;
        Quad3 from = way, half = {};
        Quad rise = quad(0);
        if constexpr (kMoved) {
            const Quad along = planes.rise(quad(half_));
            half = if_less(along, quad(0), quad(-1), quad(1)) * quad(half_), rise = magnitude(along);
            from = way - half;
        }
        const Quad low = planes.rise(from), above = larger(low, quad(0));
        const unsigned sinking = bits(above * above <= limit2);
        if (!sinking) return 0;
        // The feet of the middles where these are above.
        const Quad per = above / size2;
        const Quad left = more * more - above * per, width = square_root(larger(left, quad(0)));
        FieldExtents reach = frame_.inward(from - per * m);
        if constexpr (kMoved) {
            const Quad part =
                smaller((square_root(limit2) - low) / larger(rise + rise, quad(Real(1e-30))), quad(1));
            const Quad up = part + part, higher = if_less(quad(0), low, low + up * rise, quad(0));
            const Quad3 to = from + up * half;
            const FieldExtents end = frame_.inward(to - (higher / size2) * m);
            for (int w = 0; w < 3; ++w) reach.along[w] = larger(end.along[w], reach.along[w]);
        }
        for (int w = 0; w < 2; ++w) reach.along[w] = reach.along[w] + width;
        reach.along[2] = reach.along[2] + width * quad(diagonal_);
        return sinking & frame_.over(reach);
    }

  private:
    const FieldFrame& frame_;
    Vec3 middle_, half_;
    Real radius_, diagonal_;
};

template <>
class SubPlaneExtent<Sphere> : public RoundUnder<false> {
  public:
    SubPlaneExtent(const Sphere& sphere, const Pose& pose, const FieldFrame& frame)
        : RoundUnder(pose.p, {}, sphere.radius, frame)
    {}
};

template <>
class SubPlaneExtent<Capsule> : public RoundUnder<true> {
  public:
    SubPlaneExtent(const Capsule& capsule, const Pose& pose, const FieldFrame& frame)
        : RoundUnder(pose.p, capsule.half_length * pose.R.column(2), capsule.radius, frame)
    {}
};

}  // namespace
}  // namespace epode
