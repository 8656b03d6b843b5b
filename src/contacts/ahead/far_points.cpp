// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/ahead/far_points.h"

#include <algorithm>
#include <cmath>

#include "collide/solid_type.h"
#include "contacts/ahead/long_ray.h"
#include "geometry/best_four.h"

namespace epode {
namespace {

constexpr Real kSlant = Real(0.5);   // tangent of the tilt up to which the corners of a side are seen
constexpr Real kLying = Real(0.7);   // cosine between an axis and the normal
constexpr Real kSame = Real(0.05);   // of the size, between points that are one
constexpr Real kAlike = Real(0.7);   // cosine between the normals here and there
constexpr Real kAbove = Real(1e-3);  // of the size, where rays start

class FarPoints {
  public:
    // `up`: out of the other one.
    FarPoints(Geom& geom, const ConvexView& solid, const PlacedGeom& other, Vec3 up, Real margin)
        : geom_(geom),
          solid_(solid),
          other_(other),
          up_(up),
          margin_(margin),
          size_(solid.size + solid.radius)
    {}

    // found(place on the solid, normal of the other, gap along it)
    template <typename Found>
    void each(Found&& found) const
    {
        const Vec3 axis = solid_.pose.R.column(2);
        const bool lies = std::fabs(dot(axis, up_)) < kLying;
        if (solid_.kind == SolidKind::kSegment || (solid_.kind == SolidKind::kCylinder && lies)) {
            constexpr Real kToEnd = 10;
            for (const Real side : {-kToEnd, kToEnd}) look_below(side * axis - up_, found);
        } else if (solid_.kind == SolidKind::kCylinder || solid_.kind == SolidKind::kBox ||
                   solid_.kind == SolidKind::kPolyhedron) {
            look_around(found);
        }
    }

  private:
    template <typename Found>
    void look_around(Found&& found) const
    {
        const Mat3& R = solid_.pose.R;
        const Vec3 along = abs(transposed_times(R, up_));
        const int k = along.x >= along.y && along.x >= along.z ? 0 : along.y >= along.z ? 1 : 2;
        const Vec3 t = kSlant * R.column((k + 1) % 3), s = kSlant * R.column((k + 2) % 3);
        for (const Vec3 lean : {t + s, t - s, s - t, -t - s}) look_below(lean - up_, found);
    }

    template <typename Found>
    [[gnu::noinline]] void look_below(Vec3 direction, Found&& found) const
    {
        const Vec3 p = solid_.support(direction) - solid_.radius * up_;
        const Real above = kAbove * size_;
        const RayHit hit = cast_long_ray(p + above * up_, -up_, geom_, other_.geom, other_.pose);
        if (!(hit.distance <= above + margin_)) return;
        if (const Real cosine = dot(hit.normal, up_); cosine > kAlike)
            found(p, hit.normal, cosine * (hit.distance - above));
    }

    Geom& geom_;
    const ConvexView& solid_;
    const PlacedGeom& other_;
    const Vec3 up_;
    const Real margin_, size_;
};

int deepest_of(const ContactArray& out)
{
    int deepest = 0;
    for (int i = 1; i < out.count; ++i)
        if (out.at(i)->depth > out.at(deepest)->depth) deepest = i;
    return deepest;
}

// Seen along the normal.
bool is_known(const ContactArray& out, Vec3 place, Vec3 up, Real near)
{
    for (int i = 0; i < out.count; ++i) {
        const Vec3 way = place - load(out.at(i)->pos);
        if (length2(way - dot(way, up) * up) < near * near) return true;
    }
    return false;
}

// Polyhedra know their corners, and round solids that cross touch in one point.
bool may_have_far_points(const PlacedGeom& solid, const PlacedGeom& other)
{
    if (!is_solid(solid.geom) || !is_solid(other.geom)) return is_solid(solid.geom);
    const SolidKind kind = solid_view(solid.geom, solid.pose).kind,
                    below = solid_view(other.geom, other.pose).kind;
    return (kind == SolidKind::kSegment || kind == SolidKind::kCylinder) &&
           (below == SolidKind::kBox || below == SolidKind::kPolyhedron);
}

void add_points_of(const PlacedGeom& solid, const PlacedGeom& other, bool turned, Real margin,
                   ContactArray& out)
{
    if (!may_have_far_points(solid, other)) return;
    const ConvexView view = solid_view(solid.geom, solid.pose);
    const Vec3 normal = load(out.at(deepest_of(out))->normal), up = turned ? -normal : normal;
    const Real near = kSame * (view.size + view.radius);
    FarPoints(solid.geom, view, other, up, margin).each([&](Vec3 place, Vec3 n, Real gap) {
        if (out.full() || is_known(out, place, up, near)) return;
        dContactGeom& c = *out.at(out.count++);
        store(c.pos, turned ? place - gap * n : place), store(c.normal, turned ? -n : n);
        c.depth = -gap, c.g1 = c.g2 = nullptr, c.side1 = c.side2 = -1;
    });
}

}  // namespace

void add_far_points(const PlacedGeom& a, const PlacedGeom& b, Real margin, ContactArray& out)
{
    if (std::count_if(out.first, out.first + out.count, [](const auto& c) { return c.depth >= 0; }) >=
        kBestFour)
        return;
    add_points_of(a, b, false, margin, out);
    add_points_of(b, a, true, margin, out);
}

}  // namespace epode
