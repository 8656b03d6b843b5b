// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The part of a solid that is under the plane of a facet of a height field, and how far it reaches. A solid
// that lies on the ground is near many facets and under few; where the part under a facet's plane does not
// reach into the facet's column, solid and ground have nothing in common there, and the facet needs no search
// for directions. The plane goes through v and rises by `slope` along x and z; heights over it are upright
// ones.
//   sinks(plane, hair)  is any of the solid less than `hair` above?
//   reach(w, side)      no point x of that part has side (x - v) farther than this along way w: x, z, or
//                       diagonally, x / dx + z / dz for cells of dx by dz
// Bounds, not the true extents: a box's part is its lowest corner p and t_i times the edges a_i there, with
// 0 <= t_i <= 1 and sum t_i (rise of a_i) <= depth of p; a cylinder's the same of its axis and of its discs,
// seen as rectangles; of a ball the smaller ball about the circle in which it cuts the plane.
#pragma once

#include "geometry/shapes.h"

namespace epode {

struct FieldPlane {
    Vec3 v;
    Real slope_x, slope_z;
    Real rise(Vec3 d) const
    {
        return d.y - slope_x * d.x - slope_z * d.z;
    }  // of a difference, over the plane
};

// A vector along the three ways.
struct FieldWays {
    Real along[3];
};

class FieldFrame {
  public:
    explicit FieldFrame(Vec3 cell) : per_x_(1 / cell.x), per_z_(1 / cell.z) {}
    Real per_x() const { return per_x_; }
    Real per_z() const { return per_z_; }
    FieldWays ways(Vec3 d) const { return {{d.x, d.z, d.x * per_x_ + d.z * per_z_}}; }

  private:
    Real per_x_, per_z_;
};

// Polyhedra: nothing is known of the part.
template <typename Shape>
class Underpart;

// Edges from a lowest corner, or what stands for them.
template <int kEdges>
class CornerUnder {
  public:
    void set(const FieldWays& corner, Real depth) { corner_ = corner, depth_ = depth; }
    // Of either sense; it is taken upwards.
    void edge(int i, const FieldWays& ways, Real rise)
    {
        // An edge that hardly rises is bounded by its length; what it adds to the other bound is nothing.
        const Real up = std::fabs(rise), least = Real(1e-20) * depth_ + Real(1e-30);
        const Real far = depth_ / (up > least ? up : least), sense = std::copysign(Real(1), rise);
        far_[i] = sense * far, share_[i] = far < 1 ? far_[i] : sense;
        edges_[i] = ways;
    }
    Real depth() const { return depth_; }
    Real reach(int way, Real side) const
    {
        Real sum = 0, most = 0;
        for (int i = 0; i < kEdges; ++i) {
            const Real along = side * edges_[i].along[way], part = along * share_[i], far = along * far_[i];
            sum += part > 0 ? part : Real(0);
            most = far > most ? far : most;
        }
        return side * corner_.along[way] + (sum < most ? sum : most);
    }

  private:
    FieldWays corner_, edges_[kEdges];
    Real depth_ = 0, far_[kEdges], share_[kEdges];  // with the sign that makes the edge rise
};

template <>
class Underpart<Box> {
  public:
    Underpart(const Box& box, const Pose& pose, const FieldFrame& frame) : frame_(frame), middle_(pose.p)
    {
        const Real half[3] = {box.half.x, box.half.y, box.half.z};
        for (int i = 0; i < 3; ++i) {
            edge_[i] = 2 * half[i] * pose.R.column(i);
            ways_[i] = frame.ways(edge_[i]);
        }
    }
    bool sinks(const FieldPlane& plane, Real hair)
    {
        const Vec3 way = middle_ - plane.v;
        const Real rise[3] = {plane.rise(edge_[0]), plane.rise(edge_[1]), plane.rise(edge_[2])};
        const Real down = Real(0.5) * (std::fabs(rise[0]) + std::fabs(rise[1]) + std::fabs(rise[2]));
        const Real depth = hair - (plane.rise(way) - down);
        if (!(depth >= 0)) return false;
        FieldWays corner = frame_.ways(way);
        for (int i = 0; i < 3; ++i) {
            const Real half = std::copysign(Real(0.5), rise[i]);
            for (int w = 0; w < 3; ++w) corner.along[w] -= half * ways_[i].along[w];
        }
        part_.set(corner, depth);
        for (int i = 0; i < 3; ++i) part_.edge(i, ways_[i], rise[i]);
        return true;
    }
    Real reach(int way, Real side) const { return part_.reach(way, side); }

  private:
    const FieldFrame& frame_;
    Vec3 middle_, edge_[3];
    FieldWays ways_[3];
    CornerUnder<3> part_;
};

template <>
class Underpart<Cylinder> {
  public:
    Underpart(const Cylinder& cylinder, const Pose& pose, const FieldFrame& frame)
        : frame_(frame),
          radius_(cylinder.radius),
          half_(cylinder.half_length),
          middle_(pose.p),
          axis_(pose.R.column(2))
    {}
    bool sinks(const FieldPlane& plane, Real hair)
    {
        const Vec3 way = middle_ - plane.v, m = {-plane.slope_x, 1, -plane.slope_z};
        const Real along = dot(axis_, m), steep = std::fabs(along);
        Vec3 up = m - along * axis_;
        const Real size = length(up), depth = hair - (dot(way, m) - half_ * steep - radius_ * size);
        if (!(depth >= 0)) return false;
        const bool leans = size > Real(1e-6) * steep;
        Real high = radius_;  // of the part, on the disc
        if (leans) {
            up = up / size, high = depth / size;
        } else {
            Vec3 other;
            plane_space(axis_, up, other);
        }
        const Real half = std::copysign(half_, along);
        part_.set(frame_.ways(way - half * axis_ - radius_ * up), depth);
        part_.edge(0, frame_.ways(2 * half_ * axis_), 2 * half_ * along);
        part_.edge(1, frame_.ways(2 * radius_ * up), leans ? 2 * radius_ * size : Real(0));
        across_ = frame_.ways(cross(axis_, up));
        width_ = high < radius_ ? std::sqrt(high * (2 * radius_ - high)) : radius_;
        return true;
    }
    Real reach(int way, Real side) const
    {
        return part_.reach(way, side) + width_ * std::fabs(across_.along[way]);
    }

  private:
    const FieldFrame& frame_;
    Real radius_, half_, width_ = 0;
    Vec3 middle_, axis_;
    FieldWays across_;
    CornerUnder<2> part_;
};

// A ball that is moved along `axis` from -half to half.
class RoundUnder {
  public:
    RoundUnder(Vec3 middle, Vec3 half, Real radius, const FieldFrame& frame)
        : frame_(frame),
          middle_(middle),
          half_(half),
          radius_(radius),
          diagonal_(std::sqrt(frame.per_x() * frame.per_x() + frame.per_z() * frame.per_z()))
    {}
    bool sinks(const FieldPlane& plane, Real hair)
    {
        const Vec3 m = {-plane.slope_x, 1, -plane.slope_z};
        const Real size2 = length2(m), more = radius_ + hair;
        const Real along = dot(half_, m), rise = std::fabs(along);
        const Vec3 half = along < 0 ? -half_ : half_;
        Vec3 from = middle_ - plane.v - half;
        const Real low = dot(from, m), limit2 = more * more * size2;
        if (low > 0 && low * low > limit2) return false;
        width_ = more;
        Real part = 1;  // of the way from the lower end to the upper
        if (rise > 0) {
            const Real limit = std::sqrt(limit2);
            part = limit - low < 2 * rise ? (limit - low) / (2 * rise) : Real(1);
        }
        Vec3 to = from + (2 * part) * half;
        if (low > 0) {  // the feet of the middles
            const Real per = 1 / size2;
            width_ = std::sqrt(more * more - low * low * per);
            from -= (low * per) * m, to -= ((low + 2 * part * rise) * per) * m;
        }
        from_ = frame_.ways(from), to_ = frame_.ways(to);
        return true;
    }
    Real reach(int way, Real side) const
    {
        const Real a = side * from_.along[way], b = side * to_.along[way];
        return (a > b ? a : b) + (way == 2 ? width_ * diagonal_ : width_);
    }

  private:
    const FieldFrame& frame_;
    Vec3 middle_, half_;
    Real radius_, diagonal_, width_ = 0;
    FieldWays from_, to_;
};

template <>
class Underpart<Sphere> : public RoundUnder {
  public:
    Underpart(const Sphere& sphere, const Pose& pose, const FieldFrame& frame)
        : RoundUnder(pose.p, {}, sphere.radius, frame)
    {}
};

template <>
class Underpart<Capsule> : public RoundUnder {
  public:
    Underpart(const Capsule& capsule, const Pose& pose, const FieldFrame& frame)
        : RoundUnder(pose.p, capsule.half_length * pose.R.column(2), capsule.radius, frame)
    {}
};

}  // namespace epode
