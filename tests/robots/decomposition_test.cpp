// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex decomposition through the C API: solids whose distance to any point is a formula, balls in cups, and meshes
// that are no solids.
#include <epode/decomposition.h>
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr double kExact = sizeof(dReal) == 8 ? 1e-9 : 2e-6;

struct Point {
    double x, y, z;
};

struct Solid {
    std::vector<dReal> vertices;
    std::vector<unsigned> triangles;

    unsigned vertex(double x, double y, double z)
    {
        vertices.insert(vertices.end(), {dReal(x), dReal(y), dReal(z)});
        return unsigned(vertices.size() / 3 - 1);
    }
    void quad(unsigned a, unsigned b, unsigned c, unsigned d)
    {
        triangles.insert(triangles.end(), {a, b, c, a, c, d});
    }
    int vertex_count() const { return int(vertices.size() / 3); }
    int triangle_count() const { return int(triangles.size() / 3); }
};

// A profile in the half-plane (r, z), counter-clockwise, turned about the z axis; points with r = 0 are one vertex each.
Solid turned(const std::vector<std::pair<double, double>>& profile, int segments)
{
    Solid out;
    std::vector<unsigned> first;
    for (const auto& [r, z] : profile) {
        first.push_back(unsigned(out.vertex_count()));
        for (int i = 0; i < (r > 0 ? segments : 1); ++i)
            out.vertex(r * std::cos(2 * kPi * i / segments), r * std::sin(2 * kPi * i / segments), z);
    }
    const auto at = [&](size_t ring, int i) {
        return first[ring] + (profile[ring].first > 0 ? unsigned(i % segments) : 0);
    };
    for (size_t ring = 0; ring < profile.size(); ++ring) {
        const size_t next = (ring + 1) % profile.size();
        for (int i = 0; i < segments; ++i) {
            const unsigned a = at(ring, i), b = at(ring, i + 1), c = at(next, i + 1), d = at(next, i);
            if (a != b) out.triangles.insert(out.triangles.end(), {a, b, c});
            if (c != d) out.triangles.insert(out.triangles.end(), {a, c, d});
        }
    }
    return out;
}

// The polygon, counter-clockwise seen from z, as a prism from z = 0 to high; it must be star-shaped from its first corner.
Solid prism(const std::vector<std::pair<double, double>>& polygon, double high)
{
    Solid out;
    const unsigned n = unsigned(polygon.size());
    for (double z : {0.0, high})
        for (const auto& [x, y] : polygon) out.vertex(x, y, z);
    for (unsigned i = 0; i < n; ++i) out.quad(i, (i + 1) % n, n + (i + 1) % n, n + i);
    for (unsigned i = 1; i + 1 < n; ++i)
        out.triangles.insert(out.triangles.end(), {0, i + 1, i, n, n + i, n + i + 1});
    return out;
}

// An L of two plates, 1 thick: 4 long, 3 high, 2 deep.
Solid bracket() { return prism({{1, 1}, {1, 3}, {0, 3}, {0, 0}, {4, 0}, {4, 1}}, 2); }

Solid torus(double ring, double tube, int around, int along)
{
    std::vector<std::pair<double, double>> profile;
    for (int i = 0; i < along; ++i)
        profile.push_back(
            {ring + tube * std::cos(2 * kPi * i / along), tube * std::sin(2 * kPi * i / along)});
    return turned(profile, around);
}

// Walls 0.1 m thick around a hole of radius 0.4 m and depth 0.9 m.
Solid cup() { return turned({{0, 0}, {0.5, 0}, {0.5, 1}, {0.4, 1}, {0.4, 0.1}, {0, 0.1}}, 24); }

// Half a hollow ball, open above, of outer radius 0.5 m and inner 0.4 m about (0, 0, 0.5).
Solid bowl()
{
    std::vector<std::pair<double, double>> profile;
    const int steps = 10;
    for (int i = 0; i <= steps; ++i)
        profile.push_back(
            {i == 0 ? 0 : 0.5 * std::sin(kPi / 2 * i / steps), 0.5 - 0.5 * std::cos(kPi / 2 * i / steps)});
    for (int i = steps; i >= 0; --i)
        profile.push_back(
            {i == 0 ? 0 : 0.4 * std::sin(kPi / 2 * i / steps), 0.5 - 0.4 * std::cos(kPi / 2 * i / steps)});
    return turned(profile, 24);
}

struct Hull {
    std::vector<dReal> points, planes;
    double volume = 0;
    int vertices() const { return int(points.size() / 3); }
    double height(Point p) const
    {
        double out = -HUGE_VAL;
        for (size_t i = 0; i < planes.size(); i += 4)
            out = std::max(out, double(planes[i]) * p.x + double(planes[i + 1]) * p.y +
                                    double(planes[i + 2]) * p.z - double(planes[i + 3]));
        return out;
    }
};

Hull hull_of(dGeomID geom)
{
    Hull out;
    out.points.resize(3 * size_t(dGeomConvexGetPoints(geom, nullptr, 0)));
    out.planes.resize(4 * size_t(dGeomConvexGetPlanes(geom, nullptr, 0)));
    dGeomConvexGetPoints(geom, out.points.data(), int(out.points.size() / 3));
    dGeomConvexGetPlanes(geom, out.planes.data(), int(out.planes.size() / 4));
    dMass mass;
    dMassSetConvex(&mass, 1, geom);
    out.volume = double(mass.mass);
    return out;
}

class DecompositionTest : public testing::Test {
  protected:
    DecompositionTest()
    {
        dInitODE2(0);
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        dDecompositionOptionsInit(&options, sizeof options);
        report.struct_size = sizeof report;
    }
    ~DecompositionTest() override
    {
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    void decompose(const Solid& solid, int capacity = 32)
    {
        geoms.resize(size_t(capacity));
        geoms.resize(size_t(dCreateConvexDecomposition(space, solid.vertices.data(), solid.vertex_count(),
                                                       solid.triangles.data(), solid.triangle_count(),
                                                       &options, geoms.data(), capacity, &report)));
        hulls.clear();
        for (dGeomID geom : geoms) hulls.push_back(hull_of(geom));
    }
    double height(Point p) const
    {
        double out = HUGE_VAL;
        for (const Hull& hull : hulls) out = std::min(out, hull.height(p));
        return out;
    }
    // All vertices and midpoints of triangles.
    double largest_height(const Solid& solid) const
    {
        double out = -HUGE_VAL;
        for (size_t t = 0; t < solid.triangles.size(); t += 3) {
            Point middle{0, 0, 0};
            for (size_t k = 0; k < 3; ++k) {
                const dReal* v = &solid.vertices[3 * solid.triangles[t + k]];
                out = std::max(out, height({double(v[0]), double(v[1]), double(v[2])}));
                middle.x += double(v[0]) / 3, middle.y += double(v[1]) / 3, middle.z += double(v[2]) / 3;
            }
            out = std::max(out, height(middle));
        }
        return out;
    }
    // The largest distance to a solid of random points in the hulls.
    double surplus(const std::function<double(Point)>& distance) const
    {
        std::mt19937 random(1);
        std::uniform_real_distribution<double> unit(0, 1);
        double out = 0;
        for (const Hull& hull : hulls)
            for (int n = 0; n < 20000; ++n) {
                Point p{0, 0, 0};
                double sum = 0;
                for (int k = 0; k < 4; ++k) {
                    const size_t v = size_t(random() % unsigned(hull.vertices()));
                    const double weight = unit(random);
                    p.x += weight * double(hull.points[3 * v]),
                        p.y += weight * double(hull.points[3 * v + 1]);
                    p.z += weight * double(hull.points[3 * v + 2]), sum += weight;
                }
                out = std::max(out, distance({p.x / sum, p.y / sum, p.z / sum}));
            }
        return out;
    }
    double volume() const
    {
        double out = 0;
        for (const Hull& hull : hulls) out += hull.volume;
        return out;
    }
    // Where a ball of that radius is, 3 s after it was dropped from above, off the axis.
    Point resting_place(double radius, double high)
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world, space);
        const dBodyID ball = dBodyCreate(world);
        const dGeomID geom = dCreateSphere(space, dReal(radius));
        dMass mass;
        dMassSetSphereTotal(&mass, 1, dReal(radius));
        dBodySetMass(ball, &mass);
        dGeomSetBody(geom, ball);
        dBodySetPosition(ball, dReal(0.05), dReal(0.02), dReal(high));
        for (int i = 0; i < 600; ++i) dWorldStep(world, dReal(0.005));
        const dReal* p = dBodyGetPosition(ball);
        return {double(p[0]), double(p[1]), double(p[2])};
    }

    dWorldID world;
    dSpaceID space;
    dDecompositionOptions options;
    dDecompositionReport report;
    std::vector<dGeomID> geoms;
    std::vector<Hull> hulls;
};

TEST_F(DecompositionTest, a_bracket_is_its_two_plates)
{
    decompose(bracket());
    ASSERT_EQ(geoms.size(), 2u);
    EXPECT_NEAR(volume(), 2 * (3 + 3), kExact * 12);
    EXPECT_EQ(report.is_closed, 1);
    EXPECT_EQ(report.surplus, 0);
    EXPECT_LE(largest_height(bracket()), kExact);
    for (const Hull& hull : hulls) EXPECT_EQ(hull.vertices(), 8);
}

TEST_F(DecompositionTest, a_convex_solid_stays_whole)
{
    options.max_vertices = 0;
    decompose(turned({{0, -1}, {0.6, -0.8}, {1, 0}, {0.6, 0.8}, {0, 1}}, 24));
    ASSERT_EQ(geoms.size(), 1u);
    EXPECT_EQ(report.surplus, 0);
    EXPECT_EQ(report.uncovered, 0);
}

TEST_F(DecompositionTest, a_torus_keeps_its_hole)
{
    options.tolerance = dReal(0.06), options.max_vertices = 0;
    const Solid solid = torus(1, 0.25, 48, 24);
    decompose(solid);
    EXPECT_GE(geoms.size(), 6u);
    EXPECT_LE(double(report.surplus), 0.06);
    EXPECT_LE(largest_height(solid), kExact);
    const auto distance = [](Point p) {
        return std::max(0.0, std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.25);
    };
    EXPECT_LE(surplus(distance), 0.06 + double(report.cell));
    EXPECT_GE(height({0, 0, 0}), 0.5);
}

TEST_F(DecompositionTest, the_reported_surplus_is_that_of_the_hulls)
{
    const Solid solid = torus(1, 0.25, 48, 24);
    options.max_vertices = 0;
    for (double tolerance : {0.3, 0.1}) {
        options.tolerance = dReal(tolerance);
        decompose(solid);
        const double found =
            surplus([](Point p) { return std::max(0.0, std::hypot(std::hypot(p.x, p.y) - 1, p.z) - 0.25); });
        EXPECT_LE(double(report.surplus), tolerance);
        EXPECT_NEAR(found, double(report.surplus), double(report.cell) + 0.005)
            << tolerance;  // 0.005: facets of the mesh
    }
}

TEST_F(DecompositionTest, a_cup_holds_a_ball)
{
    const Solid solid = cup();
    decompose(solid);
    EXPECT_LE(report.surplus, report.tolerance);
    EXPECT_LE(largest_height(solid), kExact);
    const Point at = resting_place(0.15, 1.3);
    EXPECT_LT(std::hypot(at.x, at.y), 0.26);
    EXPECT_NEAR(at.z, 0.25, double(report.surplus) + 0.005);
}

TEST_F(DecompositionTest, a_bowl_holds_a_ball)
{
    options.tolerance = dReal(0.02);
    const Solid solid = bowl();
    decompose(solid, 128);
    EXPECT_LE(report.surplus, report.tolerance);
    EXPECT_LE(largest_height(solid), kExact);
    const auto distance = [](Point p) {
        const double r = std::sqrt(p.x * p.x + p.y * p.y + (p.z - 0.5) * (p.z - 0.5));
        return p.z > 0.5 ? std::max(0.0, 0.4 - std::hypot(p.x, p.y)) : std::max(0.0, 0.4 - r);
    };
    EXPECT_LE(surplus(distance), 0.02 + double(report.cell) + 0.005);
    const Point at = resting_place(0.1, 0.9);
    EXPECT_NEAR(at.z, 0.2, 0.03);
    EXPECT_LT(std::hypot(at.x, at.y), 0.1);
}

TEST_F(DecompositionTest, vertices_can_be_limited)
{
    options.tolerance = dReal(0.1), options.max_vertices = 12;
    const Solid solid = torus(1, 0.25, 48, 24);
    decompose(solid);
    ASSERT_GE(geoms.size(), 4u);
    for (const Hull& hull : hulls) EXPECT_LE(hull.vertices(), 12);
    EXPECT_GT(report.uncovered, 0);
    EXPECT_LE(largest_height(solid), double(report.uncovered) + kExact);
}

TEST_F(DecompositionTest, there_are_at_most_so_many_hulls)
{
    options.tolerance = dReal(0.04), options.max_vertices = 0;
    for (int capacity : {1, 2, 7}) {
        decompose(torus(1, 0.25, 32, 16), capacity);
        EXPECT_LE(int(geoms.size()), capacity);
        EXPECT_GE(int(geoms.size()), 1);
        EXPECT_GT(report.surplus, report.tolerance);
        EXPECT_LE(largest_height(torus(1, 0.25, 32, 16)), kExact);
    }
}

TEST_F(DecompositionTest, the_same_bits_every_time)
{
    options.tolerance = dReal(0.1);
    decompose(torus(1, 0.25, 32, 16));
    const std::vector<Hull> before = hulls;
    decompose(torus(1, 0.25, 32, 16));
    ASSERT_EQ(hulls.size(), before.size());
    for (size_t i = 0; i < hulls.size(); ++i) EXPECT_EQ(hulls[i].points, before[i].points);
}

// Two boxes that do not touch are two hulls, not one across the gap.
TEST_F(DecompositionTest, pieces_that_do_not_touch_stay_apart)
{
    Solid both = prism({{0, 0}, {1, 0}, {1, 1}, {0, 1}}, 1);
    const Solid other = prism({{3, 0}, {4, 0}, {4, 1}, {3, 1}}, 1);
    for (unsigned index : other.triangles) both.triangles.push_back(index + unsigned(both.vertex_count()));
    both.vertices.insert(both.vertices.end(), other.vertices.begin(), other.vertices.end());
    decompose(both);
    EXPECT_EQ(geoms.size(), 2u);
    EXPECT_NEAR(volume(), 2, kExact * 4);
    EXPECT_EQ(report.surplus, 0);
}

// A triangle less: still the solid, since a hole of a triangle's size in a plate is smaller than what it bounds.
TEST_F(DecompositionTest, an_open_mesh_is_reported_and_decomposed)
{
    Solid open = cup();
    open.triangles.resize(open.triangles.size() - 3);
    options.tolerance = dReal(0.05);  // half a wall; the default takes six times as long
    decompose(open);
    EXPECT_EQ(report.is_closed, 0);
    EXPECT_GE(geoms.size(), 4u);
    EXPECT_LE(report.surplus, report.tolerance);
    EXPECT_LE(largest_height(open), kExact);
    EXPECT_GE(height({0, 0, 0.7}), 0.3);
}

std::string said;
void keep_message(int, const char* text, va_list arguments)
{
    char buffer[400];
    std::vsnprintf(buffer, sizeof buffer, text, arguments);
    said = buffer;
}

TEST_F(DecompositionTest, what_is_no_solid_is_refused_with_a_reason)
{
    dSetMessageHandler(&keep_message);
    const auto refused = [&](const Solid& solid, const char* reason) {
        said.clear();
        decompose(solid);
        EXPECT_TRUE(geoms.empty()) << reason;
        EXPECT_NE(said.find(reason), std::string::npos) << said;
    };
    Solid plate;
    plate.quad(plate.vertex(0, 0, 0), plate.vertex(1, 0, 0), plate.vertex(1, 1, 0), plate.vertex(0, 1, 0));
    refused(plate, "in one plane");
    Solid broken = bracket();
    broken.triangles[5] = 1000;
    refused(broken, "index beyond the vertices");
    broken = bracket();
    broken.vertices[4] = dReal(NAN);
    refused(broken, "not a usable number");
    refused(Solid{}, "vertices and triangles");
    options.tolerance = -1;
    refused(bracket(), "a tolerance of 0 or more");
    options.tolerance = 0, options.max_vertices = 3;
    refused(bracket(), "at least 4 vertices");
    options.max_vertices = 64;
    decompose(bracket(), 2);
    EXPECT_EQ(geoms.size(), 2u);
    dSetMessageHandler(nullptr);
}

}  // namespace
