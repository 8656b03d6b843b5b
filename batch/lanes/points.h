// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where two shapes are nearest, without a branch: for each point of a pair the gap, the point midway and the normal from b to a. All
// places count from O of a's tree. What the fields of shapes' sizes mean is in robots/model.h.
#pragma once

#include "batch/lanes/asked.h"

namespace epode::batch {
namespace {

template <typename P>
EPODE_LANEWISE Vec3Of<P> shifted(const Vec3Of<P>& at, const P& along, const Vec3Of<P>& direction)
{
    return at + along * direction;
}

template <typename P, bool own>
struct Points {
    const ModelView& model;
    Numbers<P, own> numbers;
    const StepOptions& options;
    Work<P>& work;

    // All shapes, each once.
    void place() const
    {
        for (int i = 0; i < model.shapes.size(); ++i) {
            const BatchShape& its = model.shapes[i];
            const LinkWork<P>& link = work.link[its.link];
            const Vec3Of<P> size = numbers.vec(its.first + shape_number::kSize);
            Vec3Of<P> at = link.p + link.r * numbers.vec(its.first + shape_number::kPlace);
            if (model.links[its.link].last_dof < 0) at = at + numbers.vec(model.terrain);
            work.placed[i] = {
                at,
                its.is_turned ? matrix_of(link.q * numbers.quat(its.first + shape_number::kTurn)) : link.r,
                size.x, size.y, size.z};
        }
    }

    int tree_of(int shape) const
    {
        const int link = model.shapes[shape].link;
        return link == 0 ? model.trees : model.links[link].tree;  // the world's own O is 0
    }

    EPODE_LANEWISE void put(int k, const P& gap, const Vec3Of<P>& point, const Vec3Of<P>& normal) const
    {
        work.gaps[k] = gap, work.points[k] = point, work.normals[k] = normal;
    }

    // A round of radius r about a point against the plane.
    EPODE_LANEWISE void round_plane(int k, const Vec3Of<P>& centre, const P& radius,
                                    const Placed<P>& plane) const
    {
        const Vec3Of<P> n = plane.axis();
        const P gap = dot(n, centre - plane.at) - radius;
        put(k, gap, shifted(centre, -(radius + P(typename P::Number(0.5)) * gap), n), n);
    }

    EPODE_LANEWISE void two_rounds(int k, const Vec3Of<P>& a, const P& ra, const Vec3Of<P>& b,
                                   const P& rb) const
    {
        const Vec3Of<P> apart = a - b;
        const P square = dot(apart, apart), distance = square_root(square),
                inverse = inverse_or_zero(distance);
        const Vec3Of<P> n{inverse * apart.x, inverse * apart.y, if_positive(square, inverse * apart.z, P(1))};
        const P gap = distance - (ra + rb);
        put(k, gap, shifted(b, rb + P(typename P::Number(0.5)) * gap, n), n);
    }

    void find(const BatchPair& pair) const
    {
        const int tree = tree_of(pair.shape_a), other = tree_of(pair.shape_b);
        const Placed<P>& a = work.placed[pair.shape_a];
        Placed<P> b = work.placed[pair.shape_b];
        if (other != tree) b.at = b.at + (work.origin[other] - work.origin[tree]);
        switch (pair.kind) {
            case PointKind::kSpherePlane:
                return round_plane(0, a.at, a.x, b);
            case PointKind::kCapsulePlane:
                round_plane(0, shifted(a.at, a.y, a.axis()), a.x, b);
                return round_plane(1, shifted(a.at, -a.y, a.axis()), a.x, b);
            case PointKind::kBoxPlane:
                return box_plane(a, b);
            case PointKind::kCylinderPlane:
                return cylinder_plane(a, b);
            case PointKind::kEllipsoidPlane:
                return ellipsoid_plane(a, b);
            case PointKind::kSphereSphere:
                return two_rounds(0, a.at, a.x, b.at, b.x);
            case PointKind::kSphereCapsule:
                return two_rounds(0, a.at, a.x,
                                  shifted(b.at, clip(dot(a.at - b.at, b.axis()), -b.y, b.y), b.axis()), b.x);
            case PointKind::kCapsuleCapsule:
                return two_capsules(a, b);
            case PointKind::kSphereBox:
                return sphere_box(a, b);
            case PointKind::kAsked:
                return Asked<P>{model, options, work}.find(pair, a, b);
        }
    }

    void box_plane(const Placed<P>& box, const Placed<P>& plane) const
    {
        for (int k = 0; k < 8; ++k) {
            const Vec3Of<P> corner{k & 1 ? box.x : -box.x, k & 2 ? box.y : -box.y, k & 4 ? box.z : -box.z};
            round_plane(k, box.at + box.r * corner, P(0), plane);
        }
    }

    // Three points of the lower rim, the lowest among them, and the lowest of the upper one.
    void cylinder_plane(const Placed<P>& its, const Placed<P>& plane) const
    {
        using T = typename P::Number;
        const Vec3Of<P> n = plane.axis(), axis = its.axis();
        const P along = dot(n, axis), lower = if_positive(along, -its.y, its.y);
        const Vec3Of<P> across = n - along * axis;
        const P square = dot(across, across), inverse = inverse_or_zero(square_root(square)), flat(T(1e-12));
        const Vec3Of<P> side{its.r.row0.x, its.r.row1.x, its.r.row2.x};
        const Vec3Of<P> down{-if_greater(square, flat, inverse * across.x, side.x),
                             -if_greater(square, flat, inverse * across.y, side.y),
                             -if_greater(square, flat, inverse * across.z, side.z)};
        const Vec3Of<P> beside = cross(axis, down), low = shifted(its.at, lower, axis);
        const P half = P(T(-0.5)) * its.x, wide = P(T(0.86602540378443864676)) * its.x;
        round_plane(0, shifted(low, its.x, down), P(0), plane);
        round_plane(1, shifted(shifted(low, half, down), wide, beside), P(0), plane);
        round_plane(2, shifted(shifted(low, half, down), -wide, beside), P(0), plane);
        round_plane(3, shifted(shifted(its.at, -lower, axis), its.x, down), P(0), plane);
    }

    // The lowest point: c - R (a^2 u) / |a u|, u = R' n.
    void ellipsoid_plane(const Placed<P>& its, const Placed<P>& plane) const
    {
        const Vec3Of<P> u = transposed_times(its.r, plane.axis()),
                        scaled{its.x * u.x, its.y * u.y, its.z * u.z};
        const P inverse = inverse_or_zero(square_root(dot(scaled, scaled)));
        const Vec3Of<P> down{its.x * (inverse * scaled.x), its.y * (inverse * scaled.y),
                             its.z * (inverse * scaled.z)};
        round_plane(0, its.at - its.r * down, P(0), plane);
    }

    // The nearest points of two segments: the best on one line for each end of the other, clipped (parallel ones: their middles).
    void two_capsules(const Placed<P>& one, const Placed<P>& two) const
    {
        using T = typename P::Number;
        const Vec3Of<P> u = one.axis(), w = two.axis(), apart = one.at - two.at;
        const P cosine = dot(u, w), sine2 = P(1) - cosine * cosine, along_u = dot(u, apart),
                along_w = dot(w, apart);
        const P best = (cosine * along_w - along_u) / at_least(P(T(1e-6)), sine2);
        const P s0 = clip(if_greater(sine2, P(T(1e-6)), best, P(0)), -one.y, one.y);
        const P t = clip(cosine * s0 + along_w, -two.y, two.y), s = clip(cosine * t - along_u, -one.y, one.y);
        two_rounds(0, shifted(one.at, s, u), one.x, shifted(two.at, t, w), two.x);
    }

    // Outside: from the nearest point of the box. Inside: out of the nearest face.
    void sphere_box(const Placed<P>& ball, const Placed<P>& box) const
    {
        const Vec3Of<P> local = transposed_times(box.r, ball.at - box.at);
        const Vec3Of<P> nearest{clip(local.x, -box.x, box.x), clip(local.y, -box.y, box.y),
                                clip(local.z, -box.z, box.z)};
        const Vec3Of<P> out = local - nearest;
        const P square = dot(out, out), distance = square_root(square), inverse = inverse_or_zero(distance);
        const P dx = box.x - magnitude(local.x), dy = box.y - magnitude(local.y),
                dz = box.z - magnitude(local.z);
        const P zero(0), one(1), least = at_most(dx, at_most(dy, dz));
        const auto face = [&](const P& depth, const P& at) {
            return if_greater(depth, least, zero, if_greater(zero, at, -one, one));
        };
        const P fx = face(dx, local.x), fy = if_positive(magnitude(fx), zero, face(dy, local.y)),
                fz = if_positive(magnitude(fx) + magnitude(fy), zero, face(dz, local.z));
        const Vec3Of<P> n{if_positive(square, inverse * out.x, fx), if_positive(square, inverse * out.y, fy),
                          if_positive(square, inverse * out.z, fz)};
        const Vec3Of<P> normal = box.r * n;
        const P gap = if_positive(square, distance, -least) - ball.x;
        put(0, gap, shifted(ball.at, -(ball.x + P(typename P::Number(0.5)) * gap), normal), normal);
    }
};

}  // namespace
}  // namespace epode::batch
