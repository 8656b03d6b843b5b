// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hulls against brute force: every point within the stated tolerance of every face, edges shared by two
// faces, Euler's formula, volumes of known solids; the same result in any order of the points and in any
// pose; clouds that are made to break hulls: points on faces, on edges, twice, almost in a plane, needles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <random>
#include <vector>

#include "geometry/hulls/polyhedron.h"
#include "geometry/hulls/quickhull.h"

using namespace epode;

namespace {

constexpr Real kFlat = kSingle ? Real(1e-5) : Real(1e-6);
constexpr int kAll = 1 << 24;

struct Dice {
    std::mt19937_64 engine;
    Real between(Real lo, Real hi) { return lo + (hi - lo) * Real(double(engine() >> 11) * 0x1p-53); }
    Vec3 point()
    {
        const Real x = between(-1, 1), y = between(-1, 1);
        return {x, y, between(-1, 1)};
    }
    Vec3 direction()
    {
        for (;;) {
            Vec3 v = point();
            if (length2(v) < 1 && normalize(v)) return v;
        }
    }
};

Real extent_of(const std::vector<Vec3>& points)
{
    Vec3 lo = points[0], hi = lo;
    for (const Vec3 p : points) lo = min(lo, p), hi = max(hi, p);
    return max_component(hi - lo);
}

std::vector<Real> flat_list(const std::vector<Vec3>& points)
{
    std::vector<Real> out;
    for (const Vec3 p : points) out.insert(out.end(), {p.x, p.y, p.z});
    return out;
}

Polyhedron solid_of(const std::vector<Vec3>& points, int max_vertices = kAll)
{
    Polyhedron solid;
    const char* refusal = solid.build(flat_list(points).data(), unsigned(points.size()), max_vertices, false);
    EXPECT_EQ(refusal, nullptr) << refusal;
    return solid;
}

// How far a point stands out of the farthest plane, as a share of the extent.
Real standing_out(const Polyhedron& solid, const std::vector<Vec3>& points)
{
    Real largest = 0;
    for (const PolyhedronFace& f : solid.faces())
        for (const Vec3 p : points) largest = std::max(largest, dot(f.normal, p - solid.centre()) - f.offset);
    return largest / extent_of(points);
}

void expect_closed(const Polyhedron& solid)
{
    std::map<std::pair<int, int>, int> edges;
    for (const PolyhedronFace& f : solid.faces())
        for (int k = 0; k < f.count; ++k) {
            const int from = solid.corners()[std::size_t(f.first + k)];
            ++edges[{from, solid.corners()[std::size_t(f.first + (k + 1) % f.count)]}];
        }
    for (const auto& [edge, count] : edges) {
        ASSERT_EQ(count, 1);
        ASSERT_TRUE(edges.contains({edge.second, edge.first})) << "an edge of one face alone";
    }
    EXPECT_EQ(int(solid.vertices().size()) - int(edges.size()) / 2 + int(solid.faces().size()), 2);
}

void expect_hull(const std::vector<Vec3>& points, int vertices, int faces)
{
    const Polyhedron solid = solid_of(points);
    expect_closed(solid);
    EXPECT_LE(standing_out(solid, points), 2 * kFlat);
    if (vertices > 0) { EXPECT_EQ(int(solid.vertices().size()), vertices); }
    if (faces > 0) { EXPECT_EQ(int(solid.faces().size()), faces); }
}

std::vector<Vec3> cube()
{
    std::vector<Vec3> out;
    for (int i = 0; i < 8; ++i)
        out.push_back({i & 1 ? Real(1) : Real(-1), i & 2 ? Real(1) : Real(-1), i & 4 ? Real(1) : Real(-1)});
    return out;
}

Mat3 some_turn(Dice& dice)
{
    Quat q = {dice.between(-1, 1), dice.between(-1, 1), dice.between(-1, 1), dice.between(Real(0.1), 1)};
    normalize(q);
    return to_matrix(q);
}

TEST(Quickhull, of_random_points_holds_them_all)
{
    Dice dice{std::mt19937_64(1)};
    for (int i = 0; i < 60; ++i) {
        std::vector<Vec3> points;
        const int count = 4 + int(dice.between(0, 200));
        for (int k = 0; k < count; ++k) points.push_back(i % 2 ? dice.direction() : dice.point());
        expect_hull(points, i % 2 ? count : 0, 0);
    }
}

TEST(Quickhull, knows_the_platonic_solids)
{
    const Real g = (1 + std::sqrt(Real(5))) / 2, h = 1 / g;
    std::vector<Vec3> octahedron, icosahedron, dodecahedron = cube();
    for (const Real a : {Real(1), Real(-1)}) {
        octahedron.insert(octahedron.end(), {{a, 0, 0}, {0, a, 0}, {0, 0, a}});
        for (const Real b : {g, -g}) icosahedron.insert(icosahedron.end(), {{0, a, b}, {a, b, 0}, {b, 0, a}});
        for (const Real b : {g, -g})
            dodecahedron.insert(dodecahedron.end(), {{0, a * h, b}, {a * h, b, 0}, {b, 0, a * h}});
    }
    const Real root5 = std::sqrt(Real(5));
    const struct {
        std::vector<Vec3> points;
        int vertices, faces;
        Real volume;
    } known[] = {{{{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}}, 4, 4, Real(8) / 3},
                 {cube(), 8, 6, 8},
                 {octahedron, 6, 8, Real(4) / 3},
                 {dodecahedron, 20, 12, (15 + 7 * root5) / 4 * 8 / (g * g * g)},
                 {icosahedron, 12, 20, 5 * (3 + root5) / 12 * 8}};
    Dice dice{std::mt19937_64(2)};
    for (const auto& k : known)
        for (int i = 0; i < 10; ++i) {
            std::vector<Vec3> points = k.points;
            const Mat3 R = i > 0 ? some_turn(dice) : Mat3::identity();
            const Vec3 p = i > 0 ? Real(3) * dice.point() : Vec3{};
            for (Vec3& v : points) v = R * v + p;
            expect_hull(points, k.vertices, k.faces);
            EXPECT_NEAR(solid_of(points).mass().mass, k.volume, k.volume * 64 * kEpsilon);
        }
}

// Points on the faces and edges, doubled, moved by rounding: still the six faces of a cube.
TEST(Quickhull, merges_what_lies_in_one_plane)
{
    Dice dice{std::mt19937_64(3)};
    for (int i = 0; i < 10; ++i) {
        std::vector<Vec3> points = cube();
        for (int k = 0; k < 400; ++k) {
            Vec3 v = dice.point();
            v.set(k % 3, k % 2 ? Real(1) : Real(-1));
            if (k % 5 == 0) v.set((k + 1) % 3, 1);
            points.push_back(v), points.push_back(v);
        }
        const Mat3 R = i > 0 ? some_turn(dice) : Mat3::identity();
        for (Vec3& v : points) {
            v = R * v;
            if (i % 3 == 2) v += Real(0.1) * kFlat * dice.point();
        }
        expect_hull(points, 8, 6);
    }
}

TEST(Quickhull, stays_closed_where_merging_is_hard)
{
    Dice dice{std::mt19937_64(4)};
    for (int i = 0; i < 40; ++i) {
        std::vector<Vec3> points;
        const Real thin = std::pow(Real(10), dice.between(-5, -1)),
                   noise = kFlat * std::pow(Real(10), dice.between(-2, 2));
        for (int k = 0; k < 300; ++k) {
            Vec3 v = dice.point();
            if (i % 4 == 0) v = dice.direction() + noise * v;                           // a rough ball
            if (i % 4 == 1) v = {v.x, v.y, thin * v.z};                                 // a sheet
            if (i % 4 == 2) v = {v.x, thin * v.y * (1 - v.x), thin * v.z * (1 - v.x)};  // a spike
            if (i % 4 == 3) v = cube()[std::size_t(k % 8)] + Real(10) * noise * v;      // rounded corners
            points.push_back(v);
        }
        SCOPED_TRACE(i);
        expect_hull(points, 0, 0);
    }
}

TEST(Quickhull, does_not_depend_on_the_order)
{
    Dice dice{std::mt19937_64(5)};
    std::vector<Vec3> points = cube();
    for (int k = 0; k < 300; ++k) points.push_back(Real(1.2) * dice.direction());
    for (int k = 0; k < 100; ++k) points.push_back(points[std::size_t(k)]);
    const Polyhedron first = solid_of(points);
    std::vector<Vec3> known(first.vertices().begin(), first.vertices().end());
    const auto less = [](Vec3 a, Vec3 b) {
        return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
    };
    std::sort(known.begin(), known.end(), less);
    for (int i = 0; i < 5; ++i) {
        std::shuffle(points.begin(), points.end(), dice.engine);
        const Polyhedron again = solid_of(points);
        std::vector<Vec3> found(again.vertices().begin(), again.vertices().end());
        std::sort(found.begin(), found.end(), less);
        ASSERT_EQ(found.size(), known.size());
        for (std::size_t k = 0; k < found.size(); ++k) EXPECT_EQ(length(found[k] - known[k]), 0);
        ASSERT_EQ(first.faces().size(), again.faces().size());
        for (std::size_t k = 0; k < first.faces().size(); ++k)
            EXPECT_LE(length(first.faces()[k].normal - again.faces()[k].normal), 16 * kEpsilon);
    }
}

TEST(Quickhull, with_a_limit_takes_what_stands_out_farthest)
{
    Dice dice{std::mt19937_64(6)};
    std::vector<Vec3> points;
    for (int k = 0; k < 3000; ++k) points.push_back(dice.direction());
    Real before = 0;
    for (const int max_vertices : {4, 8, 32, 128}) {
        const Polyhedron solid = solid_of(points, max_vertices);
        EXPECT_EQ(int(solid.vertices().size()), max_vertices);
        expect_closed(solid);
        EXPECT_GT(solid.mass().mass, before);
        before = solid.mass().mass;
    }
    EXPECT_GT(before, Real(0.93) * 4 / 3 * kPi);
}

TEST(Quickhull, many_points_are_no_trouble)
{
    Dice dice{std::mt19937_64(7)};
    std::vector<Vec3> points;
    for (int k = 0; k < 100000; ++k) points.push_back(dice.point());
    const Polyhedron solid = solid_of(points);
    expect_closed(solid);
    EXPECT_LE(standing_out(solid, points), 2 * kFlat);
    EXPECT_GT(solid.mass().mass, Real(7.9));
}

TEST(Quickhull, refuses_what_has_no_inside)
{
    Dice dice{std::mt19937_64(8)};
    const auto fault = [](const std::vector<Vec3>& points) {
        Hull hull;
        return convex_hull({points.data(), points.size()}, kFlat, kAll, hull);
    };
    std::vector<Vec3> point, line, plane;
    const Vec3 u = dice.direction(), v = dice.direction();
    for (int k = 0; k < 100; ++k) {
        point.push_back({1, 2, 3});
        line.push_back(dice.between(-1, 1) * u + Real(0.1) * kFlat * dice.point());
        plane.push_back(dice.between(-1, 1) * u + dice.between(-1, 1) * v + Real(0.1) * kFlat * dice.point());
    }
    EXPECT_EQ(fault(point), HullFault::kPoint);
    EXPECT_EQ(fault(line), HullFault::kLine);
    EXPECT_EQ(fault(plane), HullFault::kPlane);
}

// Climbing must find what trying all finds.
TEST(Quickhull, the_farthest_vertex_is_found_by_climbing)
{
    Dice dice{std::mt19937_64(9)};
    for (const int count : {33, 200, 2000}) {
        std::vector<Vec3> points;
        for (int k = 0; k < count; ++k) points.push_back(dice.direction());
        const Polyhedron solid = solid_of(points);
        for (int i = 0; i < 300; ++i) {
            const Vec3 d = dice.direction();
            Real largest = -kInf;
            for (const Vec3 v : solid.vertices()) largest = std::max(largest, dot(d, v));
            EXPECT_NEAR(dot(d, solid.support(d)), largest, 4 * kEpsilon);
        }
    }
}

}  // namespace
