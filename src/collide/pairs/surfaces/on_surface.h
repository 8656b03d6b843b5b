// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What solids against meshes and against height fields have in common: the box of the surface query, the pair
// function for a surface that is one plane, round solids as a core and a radius, and the transformation of
// contacts into the world. Overloads and not functions in ConvexView: the shape is known at compile time.
#pragma once

#include "collide/any_solid.h"
#include "collide/pairs/pairs.h"

namespace epode {

// A sphere or capsule: all points within r of the segment a..b.
struct RoundSolid {
    Vec3 a, b;
    Real r;
};
inline RoundSolid core_of(const Sphere& a, const Pose& A) { return {A.p, A.p, a.radius}; }
inline RoundSolid core_of(const Capsule& a, const Pose& A)
{
    const Vec3 half = a.half_length * A.R.column(2);
    return {A.p - half, A.p + half, a.radius};
}

template <typename Shape>
inline constexpr bool kRound = false;
template <>
inline constexpr bool kRound<Sphere> = true;
template <>
inline constexpr bool kRound<Capsule> = true;

// Shapes that are known by their views alone: they reach no farther along any direction than their size.
template <typename Shape>
inline constexpr bool kByView = false;
template <>
inline constexpr bool kByView<Convex> = true;
template <>
inline constexpr bool kByView<AnySolid> = true;

// One facet of a surface, for the pair of that surface: round_on(core, facet, pair) for spheres and capsules,
// solid_on(facet, pair) for solids that the view in `pair` describes.
template <typename Shape, typename Facet, typename Pair>
void meet_facet(const Shape& a, const Pose& A, const Facet& f, Pair& m)
{
    if constexpr (kRound<Shape>)
        round_on(core_of(a, A), f, m);
    else
        solid_on(f, m);
}

inline void on_plane(const Sphere& a, const Pose& A, const Plane& p, ContactSink& s)
{
    sphere_plane(a, A, p, {}, s);
}
inline void on_plane(const Capsule& a, const Pose& A, const Plane& p, ContactSink& s)
{
    capsule_plane(a, A, p, {}, s);
}
inline void on_plane(const Box& a, const Pose& A, const Plane& p, ContactSink& s)
{
    box_plane(a, A, p, {}, s);
}
inline void on_plane(const Cylinder& a, const Pose& A, const Plane& p, ContactSink& s)
{
    cylinder_plane(a, A, p, {}, s);
}
inline void on_plane(const Convex& a, const Pose& A, const Plane& p, ContactSink& s)
{
    convex_plane(a, A, p, {}, s);
}

inline void on_plane(const AnySolid& a, const Pose& A, const Plane& p, ContactSink& s)
{
    view_plane(view_of(a, A), p, s);
}

// How far a solid that is symmetric about its pose's origin reaches along n, a unit vector, either way.
inline Real reach_along(const Sphere& a, const Pose&, Vec3) { return a.radius; }
inline Real reach_along(const Capsule& a, const Pose& A, Vec3 n)
{
    return a.radius + a.half_length * std::fabs(dot(A.R.column(2), n));
}
inline Real reach_along(const Box& a, const Pose& A, Vec3 n)
{
    return dot(abs(transposed_times(A.R, n)), a.half);
}
inline Real reach_along(const Cylinder& a, const Pose& A, Vec3 n)
{
    const Real c = dot(A.R.column(2), n), s2 = 1 - c * c;
    return a.half_length * std::fabs(c) + a.radius * (s2 > 0 ? std::sqrt(s2) : Real(0));
}

// The box of a solid, larger by `more` to all sides.
template <typename Shape>
requires(!kByView<Shape>) Aabb box_around(const Shape& a, const Pose& A, Real more)
{
    const Vec3 half{reach_along(a, A, {1, 0, 0}) + more, reach_along(a, A, {0, 1, 0}) + more,
                    reach_along(a, A, {0, 0, 1}) + more};
    return {A.p - half, A.p + half};
}
template <typename Shape>
requires kByView<Shape> Aabb box_around(const Shape& a, const Pose& A, Real more)
{
    const ConvexView v = view_of(a, A);
    const Vec3 margin{more, more, more};
    const Vec3 hi = {v.support({1, 0, 0}).x, v.support({0, 1, 0}).y, v.support({0, 0, 1}).z};
    const Vec3 lo = {v.support({-1, 0, 0}).x, v.support({0, -1, 0}).y, v.support({0, 0, -1}).z};
    return {lo - margin, hi + margin};
}

// Contacts from number `from` on, which are in the frame of the surface.
inline void to_world(const Pose& surface, ContactSink& sink, int from)
{
    for (int k = from; k < sink.count(); ++k) {
        dContactGeom& c = *sink.at(k);
        store(c.pos, surface.to_world(load(c.pos)));
        store(c.normal, surface.R * load(c.normal));
    }
}

}  // namespace epode
