// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Convex geoms through ODE's interface: a cube made of its faces answers as a box does, dGeomSetConvex
// changes the shape and its bounding box, the client's arrays are not needed afterwards, and bad arrays are
// refused by name and change nothing.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "../api/message_recorder.h"

namespace {

constexpr dReal kTight = sizeof(dReal) == 4 ? dReal(1e-4) : dReal(1e-12);

// A box of the given half sides about (x, 0, 0), as a client would list it.
struct Arrays {
    std::vector<dReal> points, planes;
    std::vector<unsigned> polygons;
    unsigned faces() const { return unsigned(planes.size() / 4); }
    unsigned corners() const { return unsigned(points.size() / 3); }
    dGeomID create(dSpaceID space = nullptr) const
    {
        return dCreateConvex(space, planes.data(), faces(), points.data(), corners(), polygons.data());
    }
    void give(dGeomID geom) const
    {
        dGeomSetConvex(geom, planes.data(), faces(), points.data(), corners(), polygons.data());
    }
};

Arrays box_arrays(dReal a, dReal b, dReal c, dReal x = 0)
{
    Arrays out;
    const dReal half[3] = {a, b, c};
    for (int i = 0; i < 8; ++i)
        for (int k = 0; k < 3; ++k)
            out.points.push_back((i >> k & 1 ? half[k] : -half[k]) + (k == 0 ? x : 0));
    for (int k = 0; k < 3; ++k)
        for (const dReal sign : {dReal(1), dReal(-1)}) {
            for (int j = 0; j < 3; ++j) out.planes.push_back(j == k ? sign : dReal(0));
            out.planes.push_back(half[k] + (k == 0 ? sign * x : 0));
        }
    out.polygons = {4, 1, 3, 7, 5, 4, 0, 4, 6, 2, 4, 2, 6, 7, 3, 4, 0, 1, 5, 4, 4, 4, 5, 7, 6, 4, 0, 2, 3, 1};
    return out;
}

struct Touch {
    dContactGeom contacts[8];
    int count;
    Touch(dGeomID a, dGeomID b) : contacts(), count(dCollide(a, b, 8, contacts, sizeof(dContactGeom))) {}
};

TEST(ConvexGeom, answers_as_the_box_it_is)
{
    const dGeomID box = dCreateBox(nullptr, 1, 2, 3);
    const dGeomID convex = box_arrays(dReal(0.5), 1, dReal(1.5)).create();
    ASSERT_NE(convex, nullptr);
    EXPECT_EQ(dGeomGetClass(convex), dConvexClass);
    const dGeomID others[] = {dCreateSphere(nullptr, dReal(0.4)), dCreateBox(nullptr, 1, 1, 1),
                              dCreateCapsule(nullptr, dReal(0.3), 1), dCreateCylinder(nullptr, dReal(0.4), 1),
                              dCreatePlane(nullptr, 0, 0, 1, dReal(-1.4))};
    const dReal at[][3] = {
        {0, dReal(0.1), dReal(1.8)}, {dReal(0.8), dReal(0.2), 0}, {0, dReal(1.2), dReal(0.3)}};
    for (const dGeomID other : others)
        for (const auto& p : at) {
            if (dGeomGetClass(other) != dPlaneClass) dGeomSetPosition(other, p[0], p[1], p[2]);
            const Touch first(box, other), second(convex, other), turned(other, convex);
            ASSERT_EQ(first.count > 0, second.count > 0);
            ASSERT_EQ(second.count, turned.count);
            for (int i = 0; i < second.count; ++i) {
                EXPECT_EQ(second.contacts[i].g1, convex);
                EXPECT_EQ(turned.contacts[i].g2, convex);
                EXPECT_EQ(second.contacts[i].side1, -1);
                for (int k = 0; k < 3; ++k) {
                    EXPECT_NEAR(second.contacts[i].normal[k], first.contacts[0].normal[k], kTight);
                    EXPECT_EQ(second.contacts[i].normal[k], -turned.contacts[i].normal[k]);
                }
            }
            dReal deepest[2] = {0, 0};
            for (int i = 0; i < first.count; ++i) deepest[0] = std::fmax(deepest[0], first.contacts[i].depth);
            for (int i = 0; i < second.count; ++i)
                deepest[1] = std::fmax(deepest[1], second.contacts[i].depth);
            EXPECT_NEAR(deepest[0], deepest[1], kTight);
        }
    for (const dGeomID g : others) dGeomDestroy(g);
    dGeomDestroy(box), dGeomDestroy(convex);
}

TEST(ConvexGeom, an_oblique_ray_hits_where_it_enters)
{
    const dGeomID convex = box_arrays(dReal(0.5), dReal(0.5), dReal(0.5)).create();
    const dGeomID ray = dCreateRay(nullptr, 10);
    dGeomSetPosition(convex, dReal(0.3), 0, 0);
    dGeomRaySet(ray, 2, dReal(0.2), 2, -1, 0, -1);
    const Touch hit(ray, convex);
    ASSERT_EQ(hit.count, 1);
    EXPECT_NEAR(hit.contacts[0].depth, std::sqrt(dReal(4.5)), 10 * kTight);
    EXPECT_NEAR(hit.contacts[0].pos[0], dReal(0.5), 10 * kTight);
    EXPECT_NEAR(hit.contacts[0].normal[2], 1, kTight);
    dGeomRaySetLength(ray, 2);
    EXPECT_EQ(Touch(ray, convex).count, 0);
    dGeomDestroy(ray), dGeomDestroy(convex);
}

TEST(ConvexGeom, takes_another_shape_at_once)
{
    dGeomID convex = nullptr;
    {
        Arrays arrays = box_arrays(1, 1, 1);
        convex = arrays.create();
        for (dReal& x : arrays.points) x = 77;  // not needed any more
    }
    dReal box[6];
    dGeomGetAABB(convex, box);
    EXPECT_EQ(box[0], -1);
    box_arrays(1, 2, 3, 5).give(convex);
    dGeomGetAABB(convex, box);
    EXPECT_EQ(box[0], 4);
    EXPECT_EQ(box[1], 6);
    EXPECT_EQ(box[5], 3);
    dGeomDestroy(convex);
}

// The original meets solids with all points, whatever the faces are: missing, wound inward, or passing by
// points that stand out.
TEST(ConvexGeom, is_the_hull_of_its_points_whatever_the_faces)
{
    MessageRecorder messages;
    Arrays few = box_arrays(1, 1, 1), inward = few, more = few;
    few.planes.resize(4);
    for (std::size_t f = 0; f < 6; ++f)
        std::reverse(inward.polygons.begin() + std::ptrdiff_t(5 * f + 1),
                     inward.polygons.begin() + std::ptrdiff_t(5 * f + 5));
    more.points.insert(more.points.end(), {0, 0, 2, 0, 0, 0});
    const dGeomID ball = dCreateSphere(nullptr, 1);
    dGeomSetPosition(ball, 0, 0, dReal(1.5));
    for (const Arrays* arrays : {&few, &inward, &more}) {
        const dGeomID convex = arrays->create();
        ASSERT_NE(convex, nullptr) << messages.take();
        const Touch touch(ball, convex);
        ASSERT_EQ(touch.count, 1);
        EXPECT_EQ(dGeomConvexGetPlanes(convex, nullptr, 0), arrays == &more ? 9 : 6);
        if (arrays != &more) {
            EXPECT_NEAR(touch.contacts[0].depth, dReal(0.5), kTight);
            EXPECT_NEAR(touch.contacts[0].normal[2], 1, kTight);
        }
        dGeomDestroy(convex);
    }
    EXPECT_EQ(messages.take(), "");
    dGeomDestroy(ball);
}

TEST(ConvexGeom, points_in_a_plane_make_a_plate_with_two_sides)
{
    Arrays flat = box_arrays(1, 1, 1);
    flat.points.resize(12);  // the lower four
    flat.planes = {0, 0, -1, 1};
    flat.polygons = {4, 0, 2, 3, 1};
    const dGeomID convex = flat.create(), ball = dCreateSphere(nullptr, 1), ray = dCreateRay(nullptr, 9);
    ASSERT_NE(convex, nullptr);
    EXPECT_EQ(dGeomConvexGetPlanes(convex, nullptr, 0), 2);
    for (const dReal side : {dReal(1), dReal(-1)}) {
        dGeomSetPosition(ball, dReal(0.2), dReal(0.1), -1 + side * dReal(0.75));
        const Touch touch(ball, convex);
        ASSERT_EQ(touch.count, 1);
        EXPECT_NEAR(touch.contacts[0].depth, dReal(0.25), kTight);
        EXPECT_NEAR(touch.contacts[0].normal[2], side, kTight);
        dGeomRaySet(ray, dReal(0.2), dReal(0.1), -1 + 2 * side, 0, 0, -side);
        const Touch hit(ray, convex);
        ASSERT_EQ(hit.count, 1);
        EXPECT_NEAR(hit.contacts[0].depth, 2, kTight);
    }
    MessageRecorder messages;
    dMass m;
    dMassSetConvex(&m, 1, convex);
    EXPECT_EQ(messages.take(), "2: convex has no volume in dMassSetConvex()");
    for (const dGeomID g : {convex, ball, ray}) dGeomDestroy(g);
}

TEST(ConvexHull, of_a_cloud_gives_back_a_cube_that_both_functions_take)
{
    std::vector<dReal> cloud;
    for (int i = 0; i < 5 * 5 * 5; ++i)
        for (const int n : {i % 5, i / 5 % 5, i / 25}) cloud.push_back(dReal(0.25) * dReal(n) + 3);
    const dGeomID hull = dCreateConvexHull(nullptr, cloud.data(), 125, 0);
    ASSERT_NE(hull, nullptr);
    EXPECT_EQ(dGeomGetClass(hull), dConvexClass);
    ASSERT_EQ(dGeomConvexGetPoints(hull, nullptr, 0), 8);
    ASSERT_EQ(dGeomConvexGetPlanes(hull, nullptr, 0), 6);
    ASSERT_EQ(dGeomConvexGetPolygons(hull, nullptr, 0), 30);
    Arrays back;
    back.points.resize(24), back.planes.resize(24), back.polygons.resize(30);
    dGeomConvexGetPoints(hull, back.points.data(), 8);
    dGeomConvexGetPlanes(hull, back.planes.data(), 6);
    dGeomConvexGetPolygons(hull, back.polygons.data(), 30);
    EXPECT_EQ(std::vector<dReal>(back.points.begin(), back.points.begin() + 6),
              (std::vector<dReal>{3, 3, 3, 4, 3, 3}));
    for (unsigned f = 0; f < 6; ++f) {
        EXPECT_EQ(back.polygons[5 * f], 4u);
        const dReal* n = &back.planes[4 * f];
        for (unsigned k = 1; k < 5; ++k) {
            const dReal* p = &back.points[3 * back.polygons[5 * f + k]];
            EXPECT_NEAR(n[0] * p[0] + n[1] * p[1] + n[2] * p[2], n[3], kTight * 10);
        }
    }
    dGeomSetConvexHull(hull, cloud.data(), 125, 4);
    EXPECT_EQ(dGeomConvexGetPoints(hull, nullptr, 0), 4);
    back.give(hull);
    EXPECT_EQ(dGeomConvexGetPolygons(hull, nullptr, 0), 30);
    dReal unwritten = 77;
    EXPECT_EQ(dGeomConvexGetPoints(hull, &unwritten, 0), 8);
    EXPECT_EQ(unwritten, 77);
    dMass m;
    dMassSetConvex(&m, 5, hull);
    EXPECT_NEAR(m.mass, 5, 1000 * kTight);
    for (const dReal c : {m.c[0], m.c[1], m.c[2]}) EXPECT_NEAR(c, dReal(3.5), 100 * kTight);
    dMassSetConvexTotal(&m, 12, hull);
    dMassTranslate(&m, -m.c[0], -m.c[1], -m.c[2]);
    EXPECT_NEAR(m.I[0], 2, 10000 * kTight);
    EXPECT_NEAR(m.I[1], 0, 10000 * kTight);
    dGeomDestroy(hull);
}

TEST(ConvexHull, refuses_what_has_no_inside)
{
    MessageRecorder messages;
    std::vector<dReal> points = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0, dReal(0.3), dReal(0.4), 0};
    EXPECT_EQ(dCreateConvexHull(nullptr, points.data(), 5, 0), nullptr);
    EXPECT_EQ(messages.take(), "2: all points lie in a plane in dCreateConvexHull()");
    points[14] = 1;
    const dGeomID good = dCreateConvexHull(nullptr, points.data(), 5, 0);
    ASSERT_NE(good, nullptr);
    EXPECT_EQ(dCreateConvexHull(nullptr, points.data(), 2, 0), nullptr);
    EXPECT_EQ(messages.take(), "2: too few or too many points in dCreateConvexHull()");
    EXPECT_EQ(dCreateConvexHull(nullptr, points.data(), 5, 3), nullptr);
    EXPECT_EQ(dCreateConvexHull(nullptr, nullptr, 5, 0), nullptr);
    dGeomSetConvexHull(good, nullptr, 5, 0);
    points[7] = std::numeric_limits<dReal>::infinity();
    dGeomSetConvexHull(good, points.data(), 5, 0);
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in dCreateConvexHull()|2: Bad argument(s) in dCreateConvexHull()|"
              "2: Bad argument(s) in dGeomSetConvexHull()|"
              "2: point is not a usable number in dGeomSetConvexHull()");
    EXPECT_EQ(dGeomConvexGetPoints(good, nullptr, 3), 0);
    EXPECT_EQ(dGeomConvexGetPlanes(nullptr, nullptr, 0), 0);
    EXPECT_EQ(dGeomConvexGetPolygons(good, nullptr, -1), 0);
    dMass m;
    dMassSetConvex(nullptr, 1, good);
    dMassSetConvexTotal(&m, std::numeric_limits<dReal>::quiet_NaN(), good);
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in dGeomConvexGetPoints()|"
              "2: argument not a convex shape in dGeomConvexGetPlanes()|"
              "2: Bad argument(s) in dGeomConvexGetPolygons()|"
              "2: Bad argument(s) in dMassSetConvex()|2: Bad argument(s) in dMassSetConvexTotal()");
    EXPECT_EQ(dGeomConvexGetPoints(good, nullptr, 0), 5);
    dGeomDestroy(good);
}

TEST(ConvexGeom, refuses_what_is_no_solid)
{
    MessageRecorder messages;
    const Arrays good = box_arrays(1, 1, 1);
    const dGeomID convex = good.create();
    const dReal nan = std::numeric_limits<dReal>::quiet_NaN();
    const auto refused = [&](const Arrays& arrays) {
        EXPECT_EQ(arrays.create(), nullptr);
        arrays.give(convex);
        dReal box[6];
        dGeomGetAABB(convex, box);
        EXPECT_EQ(box[1], 1);
        const std::string said = messages.take();
        EXPECT_NE(said.find("in dCreateConvex()"), std::string::npos) << said;
        EXPECT_NE(said.find("in dGeomSetConvex()"), std::string::npos) << said;
        return said;
    };
    Arrays bad = good;
    bad.points[5] = nan;
    EXPECT_NE(refused(bad).find("point is not a usable number"), std::string::npos);
    bad = good, bad.planes[3] = nan;
    EXPECT_NE(refused(bad).find("plane is not a usable number"), std::string::npos);
    bad = good, bad.polygons[4] = 8;
    EXPECT_NE(refused(bad).find("polygon with a corner that is no point"), std::string::npos);
    bad = good, bad.polygons[5] = 2;
    EXPECT_NE(refused(bad).find("polygon with a wrong number of corners"), std::string::npos);
    for (dReal& x : (bad = good).points) x = 3;
    EXPECT_NE(refused(bad).find("all points are one"), std::string::npos);
    bad = good;
    for (std::size_t k = 0; k < 8; ++k)
        for (std::size_t j = 0; j < 3; ++j) bad.points[3 * k + j] = dReal(k);
    EXPECT_NE(refused(bad).find("all points lie on a line"), std::string::npos);
    const auto pointers = [&](const dReal* planes, const dReal* points, const unsigned* polygons,
                              unsigned faces, unsigned corners) {
        EXPECT_EQ(dCreateConvex(nullptr, planes, faces, points, corners, polygons), nullptr);
        EXPECT_NE(messages.take(), "");
    };
    pointers(nullptr, good.points.data(), good.polygons.data(), 6, 8);
    pointers(good.planes.data(), nullptr, good.polygons.data(), 6, 8);
    pointers(good.planes.data(), good.points.data(), nullptr, 6, 8);
    pointers(good.planes.data(), good.points.data(), good.polygons.data(), 6, 0);
    pointers(good.planes.data(), good.points.data(), good.polygons.data(), 0, 8);
    pointers(good.planes.data(), good.points.data(), good.polygons.data(), 6, ~0u);  // a negative number
    pointers(good.planes.data(), good.points.data(), good.polygons.data(), ~5u, 8);
    dGeomSetConvex(nullptr, good.planes.data(), 6, good.points.data(), 8, good.polygons.data());
    EXPECT_NE(messages.take(), "");
    const dGeomID ball = dCreateSphere(nullptr, 1);
    good.give(ball);
    EXPECT_EQ(messages.take(), "2: argument not a convex shape in dGeomSetConvex()");
    dGeomDestroy(ball), dGeomDestroy(convex);
}

TEST(ConvexGeom, keeps_its_shape_while_its_space_collides)
{
    MessageRecorder messages;
    const dSpaceID space = dHashSpaceCreate(nullptr);
    struct Both {
        dGeomID convex;
        Arrays arrays;
    } both = {box_arrays(1, 1, 1).create(space), box_arrays(2, 2, 2)};
    dCreateSphere(space, 1);
    dSpaceCollide(space, &both, [](void* data, dGeomID, dGeomID) {
        const Both& b = *static_cast<Both*>(data);
        b.arrays.give(b.convex);
    });
    EXPECT_NE(messages.take().find("in dGeomSetConvex()"), std::string::npos);
    dSpaceDestroy(space);
}

}  // namespace
