// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What of a solid a plane has below it: closed forms, the two sides of a plane, hulls against meshes, and points counted.
#include <functional>
#include <random>
#include <vector>

#include "pool.h"

namespace epode::physics {
namespace {

struct Part {
    double volume;
    V3 centre;
};

Part submerged(dFluidID fluid, dGeomID geom)
{
    dReal volume;
    dVector3 c;
    dFluidGetSubmerged(fluid, geom, &volume, c);
    return {double(volume), {double(c[0]), double(c[1]), double(c[2])}};
}

void turn(dGeomID geom, double x, double y, double z, double angle)
{
    dQuaternion q;
    dQFromAxisAndAngle(q, real(x), real(y), real(z), real(angle));
    dGeomSetQuaternion(geom, q);
}

TEST(Submerged, ball_is_a_spherical_cap)
{
    Pool pool;
    const dGeomID ball = dCreateSphere(pool.space, real(0.7));
    for (const double t : {-0.69, -0.3, 0.0, 0.4, 0.69}) {
        dGeomSetPosition(ball, 3, 4, real(-t));
        const Part part = submerged(pool.fluid, ball);
        const double volume = kPi * (0.7 + t) * (0.7 + t) * (1.4 - t) / 3;
        const double moment = -kPi / 4 * (0.49 - t * t) * (0.49 - t * t);
        EXPECT_NEAR(part.volume, volume, tol(1e-14, 1e-6));
        EXPECT_NEAR(part.centre.z + t, moment / volume, tol(1e-12, 1e-4));
        EXPECT_NEAR(part.centre.x, 3, tol(1e-13, 1e-6));
    }
}

TEST(Submerged, lying_cylinder_is_a_segment_and_standing_one_a_disc)
{
    Pool pool;
    const dGeomID cylinder = dCreateCylinder(pool.space, 1, 3);
    for (const double t : {-0.9, -0.5, 0.0, 0.2, 0.95}) {
        turn(cylinder, 1, 0, 0, kPi / 2);
        dGeomSetPosition(cylinder, 0, 0, real(-t));
        const double segment = kPi / 2 + t * std::sqrt(1 - t * t) + std::asin(t);
        const Part lying = submerged(pool.fluid, cylinder);
        EXPECT_NEAR(lying.volume, 3 * segment, tol(1e-12, 1e-5));
        EXPECT_NEAR(lying.centre.z + t, -2.0 / 3 * std::pow(1 - t * t, 1.5) / segment, tol(1e-9, 1e-4));
        turn(cylinder, 1, 0, 0, 0);
        const Part standing = submerged(pool.fluid, cylinder);
        EXPECT_NEAR(standing.volume, kPi * (1.5 + t), tol(1e-12, 1e-5));
        EXPECT_NEAR(standing.centre.z, -(1.5 + t) / 2, tol(1e-12, 1e-5));
    }
}

// Through the middle of a cylinder, at any slant that leaves the ends alone, a plane has half of it below; the wedges that
// differ from the level half move the centre by r^2 tan / (4 L).
TEST(Submerged, slanted_cylinder_has_the_moments_of_its_wedges)
{
    Pool pool;
    const dGeomID cylinder = dCreateCylinder(pool.space, 1, 4);
    for (const double angle : {1e-9, 1e-5, 0.1, 0.5, 1.0}) {
        turn(cylinder, 0, 1, 0, angle);
        const Part part = submerged(pool.fluid, cylinder);
        EXPECT_NEAR(part.volume, 2 * kPi, tol(1e-10, 1e-5));
        const double across = std::tan(angle) / 4 / 2, along = -1 + across * std::tan(angle) / 2;
        EXPECT_NEAR(part.centre.z, along * std::cos(angle) - across * std::sin(angle), tol(1e-9, 1e-4))
            << angle;
    }
}

// The rest of a cone above a plane across its axis is a cone.
TEST(Submerged, cone_leaves_a_cone)
{
    Pool pool;
    const dGeomID cone = dCreateCone(pool.space, 1, 2);
    dGeomSetPosition(cone, 0, 0, real(0.1));
    const double top = 1.5 + 0.1, dry = top / 2;
    EXPECT_NEAR(submerged(pool.fluid, cone).volume, kPi * 2 / 3 * (1 - dry * dry * dry), tol(1e-12, 1e-5));
    turn(cone, 0, 1, 0, kPi / 2);
    dGeomSetPosition(cone, 0, 0, 0);
    EXPECT_NEAR(submerged(pool.fluid, cone).volume, kPi / 3, tol(1e-10, 1e-5));
}

// A tapered capsule whose one end holds the other is a ball, by slices: near its poles Gauss' rule has its worst places.
TEST(Submerged, ball_in_slices_is_a_ball_of_caps)
{
    Pool pool;
    const dGeomID slices = dCreateTaperedCapsule(pool.space, 1, real(0.3), real(0.5)),
                  caps = dCreateSphere(pool.space, 1);
    dReal r1, r2, length_of;
    dGeomTaperedCapsuleGetParams(slices, &r1, &r2, &length_of);
    dVector3 middle;
    std::mt19937 engine(5);
    std::uniform_real_distribution<double> within(-1, 1);
    for (int i = 0; i < 300; ++i) {
        turn(slices, within(engine), within(engine), within(engine), 3 * within(engine));
        dGeomSetPosition(slices, 0, 0, 0);
        dFluidSetPlane(pool.fluid, 0, 0, 1, 100);
        dFluidGetSubmerged(pool.fluid, slices, nullptr, middle);
        dGeomSetPosition(caps, middle[0], middle[1], middle[2]);
        dFluidSetPlane(pool.fluid, real(0.01 * within(engine)), 0, 1, middle[2] + real(within(engine)));
        const Part a = submerged(pool.fluid, slices), b = submerged(pool.fluid, caps);
        EXPECT_NEAR(a.volume, b.volume, tol(4e-8, 1e-4));
        EXPECT_NEAR(length(a.volume * a.centre - b.volume * b.centre), 0, tol(4e-8, 1e-4));
    }
}

std::vector<std::function<dGeomID(dSpaceID)>> solids()
{
    return {[](dSpaceID s) { return dCreateSphere(s, real(0.8)); },
            [](dSpaceID s) { return dCreateBox(s, 1, real(0.6), real(1.4)); },
            [](dSpaceID s) { return dCreateCapsule(s, real(0.4), real(0.9)); },
            [](dSpaceID s) { return dCreateCylinder(s, real(0.6), real(0.8)); },
            [](dSpaceID s) { return dCreateCone(s, real(0.7), real(1.3)); },
            [](dSpaceID s) { return dCreateEllipsoid(s, real(0.4), real(0.9), real(0.6)); },
            [](dSpaceID s) { return dCreateTaperedCapsule(s, real(0.5), real(0.2), real(0.9)); }};
}

// Below a plane and below the same plane turned over together are the whole, with its centre.
TEST(Submerged, both_sides_of_any_plane_make_the_whole)
{
    Pool pool;
    std::mt19937 engine(7);
    std::uniform_real_distribution<double> within(-1, 1);
    for (const auto& make : solids()) {
        const dGeomID geom = make(pool.space);
        dGeomSetPosition(geom, 0, 0, -5);
        dFluidSetPlane(pool.fluid, 0, 0, 1, 0);
        const double whole = submerged(pool.fluid, geom).volume;
        for (int i = 0; i < 200; ++i) {
            turn(geom, within(engine), within(engine), within(engine), 3 * within(engine));
            dGeomSetPosition(geom, 0, 0, 0);
            const double a = within(engine), b = within(engine), c = within(engine);
            const double d = within(engine) * std::sqrt(a * a + b * b + c * c);
            dFluidSetPlane(pool.fluid, real(a), real(b), real(c), real(d));
            const Part under = submerged(pool.fluid, geom);
            dFluidSetPlane(pool.fluid, real(-a), real(-b), real(-c), real(-d));
            const Part over = submerged(pool.fluid, geom);
            EXPECT_NEAR(under.volume + over.volume, whole, tol(1e-9, 1e-5) * whole);
            const V3 moment = under.volume * under.centre + over.volume * over.centre;
            dFluidSetPlane(pool.fluid, 0, 0, 1, 100);
            const V3 centre = submerged(pool.fluid, geom).centre;
            EXPECT_NEAR(length(moment - whole * centre), 0, tol(1e-9, 2e-5));
        }
        dGeomDestroy(geom);
    }
}

// Points of a ball of the solid's size, those that a ray query finds within and the plane below it: 1 / sqrt(n) of scatter.
TEST(Submerged, hull_agrees_with_its_mesh_and_with_counted_points)
{
    Pool pool;
    std::mt19937 engine(11);
    std::normal_distribution<double> normal;
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int trial = 0; trial < 5; ++trial) {
        std::vector<dReal> points;
        for (int i = 0; i < 20; ++i) {
            V3 p{normal(engine), normal(engine), normal(engine)};
            p = (1 / length(p)) * p;
            for (const double x : {p.x, p.y, p.z}) points.push_back(real(x));
        }
        const dGeomID hull = dCreateConvexHull(pool.space, points.data(), 20, 0);
        turn(hull, 1, 2, 3, trial);
        dFluidSetPlane(pool.fluid, real(0.3), real(-0.2), 1, real(0.1 * trial - 0.2));
        const Part part = submerged(pool.fluid, hull);
        dVector4 plane;
        dFluidGetPlane(pool.fluid, plane);
        const dReal* R = dGeomGetRotation(hull);
        std::vector<dReal> faces(4 * 200);
        const int count = dGeomConvexGetPlanes(hull, faces.data(), 200);
        int hits = 0;
        V3 sum{};
        constexpr int kPoints = 200000;
        for (int i = 0; i < kPoints; ++i) {
            const double x[3] = {unit(engine), unit(engine), unit(engine)};
            bool in = plane[0] * x[0] + plane[1] * x[1] + plane[2] * x[2] <= plane[3];
            double local[3];
            for (int k = 0; k < 3; ++k) local[k] = R[k] * x[0] + R[4 + k] * x[1] + R[8 + k] * x[2];
            for (int f = 0; in && f < count; ++f)
                in = faces[4 * f] * local[0] + faces[4 * f + 1] * local[1] + faces[4 * f + 2] * local[2] <=
                     faces[4 * f + 3];
            if (in) ++hits, sum = sum + V3{x[0], x[1], x[2]};
        }
        const double share = double(hits) / kPoints, scatter = 8 * std::sqrt(share * (1 - share) / kPoints);
        EXPECT_NEAR(part.volume, 8 * share, 4 * scatter);
        EXPECT_NEAR(length(part.centre - (1.0 / hits) * sum), 0, 0.01);
        dGeomDestroy(hull);
    }
}

// A closed mesh of a box, wherever its frame is, and a body of two boxes that make the same one.
TEST(Submerged, mesh_and_compound_are_the_box_that_they_make)
{
    Pool pool;
    std::vector<double> v;
    for (int i = 0; i < 8; ++i)
        v.insert(v.end(), {i & 1 ? 7.5 : 6.5, i & 2 ? 1.0 : -1.0, i & 4 ? 0.4 : -0.4});
    const std::vector<dTriIndex> t = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                      2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, v.data(), 3 * sizeof(double), 8, t.data(), int(t.size()),
                                3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(pool.space, data, nullptr, nullptr, nullptr);
    const dGeomID box = dCreateBox(pool.space, 1, 2, real(0.8));
    const dBodyID body = dBodyCreate(pool.world);
    for (const double side : {-0.5, 0.5}) {
        const dGeomID half = dCreateBox(pool.space, 1, 1, real(0.8));
        dGeomSetBody(half, body);
        dGeomSetOffsetPosition(half, 0, real(side), 0);
    }
    turn(mesh, 1, 1, 0, 0.6), turn(box, 1, 1, 0, 0.6);
    dQuaternion q;
    dQFromAxisAndAngle(q, 1, 1, 0, real(0.6));
    dBodySetQuaternion(body, q);
    const dReal* R = dGeomGetRotation(box);
    dGeomSetPosition(mesh, real(-7 * R[0]), real(-7 * R[4]), real(0.2 - 7 * R[8]));
    dGeomSetPosition(box, 0, 0, real(0.2)), dBodySetPosition(body, 0, 0, real(0.2));
    const Part a = submerged(pool.fluid, mesh), b = submerged(pool.fluid, box);
    dReal volume;
    dVector3 c;
    EXPECT_EQ(dFluidGetSubmergedBody(pool.fluid, body, &volume, c), 1);
    EXPECT_GT(b.volume, 0.1);
    EXPECT_NEAR(a.volume, b.volume, tol(1e-13, 1e-5));
    EXPECT_NEAR(length(a.centre - b.centre), 0, tol(1e-12, 1e-4));
    EXPECT_NEAR(double(volume), b.volume, tol(1e-13, 1e-5));
    EXPECT_NEAR(double(c[2]), b.centre.z, tol(1e-12, 1e-4));
    dGeomDestroy(mesh);
    dGeomTriMeshDataDestroy(data);
}

}  // namespace
}  // namespace epode::physics
