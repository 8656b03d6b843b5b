// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Meshes and solids for tests of mesh contacts, and an independent reference: each solid is the set where a
// convex function is not positive, so whether it meets a triangle is the sign of that function's least value
// on the triangle, found by nested golden section, without any of the library's geometry.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "../math/random_numbers.h"
#include "bvh/mesh_tree.h"
#include "collide/pairs/surfaces/mesh_contacts.h"

namespace epode::test {

// The solids by mathematics of their own: positive outside.
inline Real beyond(const Sphere& s, Vec3 p) { return length(p) - s.radius; }
inline Real beyond(const Box& b, Vec3 p) { return max_component(abs(p) - b.half); }
inline Real beyond(const Capsule& c, Vec3 p)
{
    const Real z = p.z > c.half_length ? c.half_length : p.z < -c.half_length ? -c.half_length : p.z;
    return length(p - Vec3{0, 0, z}) - c.radius;
}
inline Real beyond(const Cylinder& c, Vec3 p)
{
    return std::fmax(std::sqrt(p.x * p.x + p.y * p.y) - c.radius, std::fabs(p.z) - c.half_length);
}

inline Real side(Real d, Real h) { return d < 0 ? -h : h; }
inline Vec3 farthest(const Sphere& s, Vec3 d) { return s.radius * d; }
inline Vec3 farthest(const Box& b, Vec3 d)
{
    return {side(d.x, b.half.x), side(d.y, b.half.y), side(d.z, b.half.z)};
}
inline Vec3 farthest(const Capsule& c, Vec3 d) { return c.radius * d + Vec3{0, 0, side(d.z, c.half_length)}; }
inline Vec3 farthest(const Cylinder& c, Vec3 d)
{
    const Real rho = std::sqrt(d.x * d.x + d.y * d.y), k = rho > 0 ? c.radius / rho : 0;
    return {k * d.x, k * d.y, side(d.z, c.half_length)};
}

struct Corners {
    Vec3 v[3];
    Vec3 normal() const { return normalized_or(cross(v[1] - v[0], v[2] - v[0]), {}); }
};

// Least value of a convex function on [0, 1].
template <typename F>
Real least_on_unit(const F& f)
{
    constexpr Real kGolden = Real(0.6180339887498949);
    Real lo = 0, hi = 1, x = 1 - kGolden, y = kGolden, fx = f(x), fy = f(y);
    for (int k = 0; k < 46; ++k) {
        if (fx <= fy) {
            hi = y, y = x, fy = fx, x = hi - kGolden * (hi - lo), fx = f(x);
        } else {
            lo = x, x = y, fx = fy, y = lo + kGolden * (hi - lo), fy = f(y);
        }
    }
    return std::fmin(std::fmin(fx, fy), std::fmin(f(0), f(1)));
}

// How near the solid comes to the triangle; negative: they meet.
template <typename Shape>
Real gap(const Shape& s, const Pose& pose, const Corners& t)
{
    const Vec3 a = pose.to_local(t.v[0]), u = pose.to_local(t.v[1]) - a, w = pose.to_local(t.v[2]) - a;
    return least_on_unit([&](Real x) {
        return least_on_unit([&](Real y) { return beyond(s, a + x * u + y * (1 - x) * w); });
    });
}

// The same, but 1 for triangles that are out of the solid's reach.
template <typename Shape>
Real near_gap(const Shape& s, const Pose& pose, const Corners& t)
{
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}, t.normal()})
        for (const Vec3 d : {axis, -axis}) {
            const Real high = dot(d, pose.to_world(farthest(s, transposed_times(pose.R, d))));
            if (dot(d, t.v[0]) > high && dot(d, t.v[1]) > high && dot(d, t.v[2]) > high) return 1;
        }
    return gap(s, pose, t);
}

struct Mesh {
    TriangleMesh mesh;
    MeshTree tree;
    std::vector<Corners> all;

    explicit Mesh(const std::vector<Corners>& triangles) : all(triangles)
    {
        Array<Vec3> vertices;
        Array<MeshCorners> corners;
        for (const Corners& t : triangles) {
            const int first = vertices.size();
            for (const Vec3 v : t.v) EXPECT_TRUE(vertices.push(v));
            EXPECT_TRUE(corners.push({{first, first + 1, first + 2}}));
        }
        EXPECT_TRUE(mesh.build(vertices, corners, kEpsilon));
        EXPECT_TRUE(tree.build(mesh));
    }
};

struct Hit {
    Vec3 pos, normal;
    Real depth;
    int triangle;
};

template <typename Shape>
std::vector<Hit> hits(const Shape& s, const Pose& pose, const Mesh& m, int capacity = 32)
{
    dContactGeom raw[33];
    for (dContactGeom& c : raw) c.depth = -77;
    ContactSink sink(raw, sizeof(dContactGeom), capacity, false);
    const Surface surface{m.mesh, m.tree};
    const ConvexView view = view_of(s, pose);
    NearTriangles near;
    near.find(surface, box_around(s, pose, slack_of(view)), probe_of(s, pose, slack_of(view)));
    mesh_contacts(s, pose, surface, near, sink);
    EXPECT_EQ(raw[capacity].depth, -77) << "wrote beyond its capacity";
    std::vector<Hit> out;
    for (int k = 0; k < sink.count(); ++k) {
        const dContactGeom& c = raw[k];
        EXPECT_NEAR(length(load(c.normal)), 1, kSingle ? 1e-5 : 1e-9);
        EXPECT_GE(c.depth, 0);
        EXPECT_TRUE(usable(c.depth) && usable(c.pos[0]) && usable(c.pos[1]) && usable(c.pos[2]));
        EXPECT_TRUE(c.side2 >= 0 && c.side2 < m.mesh.triangle_count());
        out.push_back({load(c.pos), load(c.normal), c.depth, c.side2});
    }
    return out;
}

inline const Hit* deepest(const std::vector<Hit>& all)
{
    const Hit* found = nullptr;
    for (const Hit& h : all) found = !found || h.depth > found->depth ? &h : found;
    return found;
}

// A grid of nx x ny cells of unit size, its lower left corner at the origin, each split along a diagonal.
inline std::vector<Corners> grid(int nx, int ny, const std::function<Real(int, int)>& height)
{
    std::vector<Corners> out;
    std::vector<Real> heights;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) heights.push_back(height(i, j));
    const auto at = [&](int i, int j) {
        return Vec3{Real(i), Real(j), heights[std::size_t(i + j * (nx + 1))]};
    };
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            out.push_back({{at(i, j), at(i + 1, j), at(i + 1, j + 1)}});
            out.push_back({{at(i, j), at(i + 1, j + 1), at(i, j + 1)}});
        }
    return out;
}

// A box of 12 triangles about the origin.
inline std::vector<Corners> box_mesh(Vec3 h)
{
    std::vector<Corners> out;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const int u = (axis + 1) % 3, w = (axis + 2) % 3;
            const auto at = [&](Real a, Real b) {
                Vec3 p;
                p.set(axis, Real(sign) * h[axis]);
                p.set(u, a * h[u]);
                p.set(w, Real(sign) * b * h[w]);
                return p;
            };
            out.push_back({{at(-1, -1), at(1, -1), at(1, 1)}});
            out.push_back({{at(-1, -1), at(1, 1), at(-1, 1)}});
        }
    return out;
}

inline Mat3 turn_about_z(Real angle)
{
    const Real c = std::cos(angle), s = std::sin(angle);
    return {{c, -s, 0}, {s, c, 0}, {0, 0, 1}};
}

template <typename Shape>
Real least_gap(const Shape& s, const Pose& pose, const Mesh& mesh)
{
    Real least = kInf;
    for (const Corners& t : mesh.all) least = std::fmin(least, near_gap(s, pose, t));
    return least;
}

inline void roll(RandomNumbers& dice, Sphere& s) { s.radius = dice.in(Real(0.2), 1); }
inline void roll(RandomNumbers& dice, Box& b)
{
    b.half = {dice.in(Real(0.1), 1), dice.in(Real(0.1), 1), dice.in(Real(0.1), 1)};
}
inline void roll(RandomNumbers& dice, Capsule& c) { c = {dice.in(Real(0.1), 1), dice.in(Real(0.1), 1)}; }
inline void roll(RandomNumbers& dice, Cylinder& c) { c = {dice.in(Real(0.1), 1), dice.in(Real(0.1), 1)}; }

}  // namespace epode::test
