// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Triangles that a mesh's callback refuses are as if they were not there: the edges towards them hold what is larger than
// the hole. A floor of 5 x 5 cells of 0.5 m, whose middle cell is refused or left out.
#include "../mesh_floors.h"

namespace epode::physics {
namespace {

constexpr int kAcross = 5;
constexpr double kCell = 0.5;

int keep_all(dGeomID, dGeomID, int) { return 1; }
int refuse_middle(dGeomID, dGeomID, int triangle) { return triangle / 2 != kAcross * kAcross / 2; }

enum class Hole { kRefused, kLeftOut };

MeshGeom* floor(dSpaceID space, Hole hole)
{
    std::vector<dReal> v;
    for (int i = 0; i <= kAcross; ++i)
        for (int j = 0; j <= kAcross; ++j)
            v.insert(v.end(), {real((i - kAcross / 2.0) * kCell), real((j - kAcross / 2.0) * kCell), 0, 0});
    std::vector<dTriIndex> t;
    for (int i = 0; i < kAcross; ++i)
        for (int j = 0; j < kAcross; ++j) {
            if (hole == Hole::kLeftOut && i * kAcross + j == kAcross * kAcross / 2) continue;
            const auto a = dTriIndex(i * (kAcross + 1) + j), b = a + kAcross + 1;
            t.insert(t.end(), {a, b, a + 1, a + 1, b, b + 1});
        }
    auto* const mesh = new MeshGeom(space, std::move(v), std::move(t));
    if (hole == Hole::kRefused) dGeomTriMeshSetCallback(mesh->geom, refuse_middle);
    return mesh;
}

enum class Shape { kBall, kLargeBall, kCapsule, kLyingCapsule, kBox, kTiltedBox, kCylinder, kConvex };
constexpr Shape kShapes[] = {Shape::kBall, Shape::kLargeBall, Shape::kCapsule,  Shape::kLyingCapsule,
                             Shape::kBox,  Shape::kTiltedBox, Shape::kCylinder, Shape::kConvex};

dReal g_planes[] = {1, 0,  0, real(0.35), -1, 0, 0, real(0.35), 0, 1, 0,  real(0.35),
                    0, -1, 0, real(0.35), 0,  0, 1, real(0.2),  0, 0, -1, real(0.2)};
dReal g_points[24];
unsigned g_faces[] = {4, 4, 6, 7, 5, 4, 0, 1, 3, 2, 4, 2, 3, 7, 6,
                      4, 0, 4, 5, 1, 4, 1, 5, 7, 3, 4, 0, 2, 6, 4};

dGeomID convex(dSpaceID space)
{
    for (int i = 0; i < 8; ++i) {
        g_points[3 * i] = real(i & 4 ? 0.35 : -0.35);
        g_points[3 * i + 1] = real(i & 2 ? 0.35 : -0.35);
        g_points[3 * i + 2] = real(i & 1 ? 0.2 : -0.2);
    }
    return dCreateConvex(space, g_planes, 6, g_points, 8, g_faces);
}

// Each larger than the hole, or as likely to fall through it.
dBodyID body(Sim& sim, Shape shape)
{
    const dBodyID b = sim.body({0.02, 0.01, 0.7}, 1, 0.02);
    dQuaternion q;
    dQFromAxisAndAngle(q, 1, 1, 0, shape == Shape::kTiltedBox ? 0.5 : kPi / 2);
    dGeomID geom = nullptr;
    switch (shape) {
        case Shape::kBall:
            geom = dCreateSphere(sim.space, real(0.3));
            break;
        case Shape::kLargeBall:
            geom = dCreateSphere(sim.space, real(0.6));
            break;
        case Shape::kCapsule:
        case Shape::kLyingCapsule:
            geom = dCreateCapsule(sim.space, real(0.3), real(0.5));
            break;
        case Shape::kBox:
        case Shape::kTiltedBox:
            geom = dCreateBox(sim.space, real(0.7), real(0.7), real(0.4));
            break;
        case Shape::kCylinder:
            geom = dCreateCylinder(sim.space, real(0.35), real(0.6));
            break;
        case Shape::kConvex:
            geom = convex(sim.space);
            break;
    }
    if (shape == Shape::kLyingCapsule || shape == Shape::kTiltedBox) dBodySetQuaternion(b, q);
    dGeomSetBody(geom, b);
    return b;
}

struct Ways {
    Stepper stepper;
    bool by_world;
    double h;
};

V3 end_over(Hole hole, Shape shape, const Ways& way)
{
    Sim sim(way.stepper);
    sim.gravity(0, 0, -9.81);
    sim.surface.mu = 1;
    if (way.by_world) dWorldSetContactSpace(sim.world, sim.space);
    MeshGeom* const mesh = floor(sim.space, hole);
    const dBodyID b = body(sim, shape);
    for (int i = 0; i < int(2.5 / way.h); ++i) way.by_world ? sim.advance(way.h) : sim.step(way.h);
    const V3 at = position(b);
    delete mesh;
    return at;
}

// With the triangles themselves left out everything is the same, to rounding and what a landing makes of it.
TEST(RefusedTriangles, are_a_hole_with_a_rim)
{
    for (const Stepper stepper : kSteppers)
        for (const bool by_world : {false, true})
            for (const double h : {1.0 / 60, 1.0 / 240})
                for (const Shape shape : kShapes) {
                    SCOPED_TRACE(testing::Message() << name_of(stepper) << ", by world " << by_world << ", h "
                                                    << h << ", shape " << int(shape));
                    const Ways way{stepper, by_world, h};
                    const V3 refused = end_over(Hole::kRefused, shape, way),
                             out = end_over(Hole::kLeftOut, shape, way);
                    EXPECT_GT(refused.z, 0.16) << "fell through";
                    EXPECT_NEAR(refused.z, out.z, tol(1e-3, 5e-3));
                    EXPECT_NEAR(refused.x, out.x, tol(5e-3, 5e-2));
                    EXPECT_NEAR(refused.y, out.y, tol(5e-3, 5e-2));
                }
}

// In the hole for the smaller ball: its centre is sqrt(0.3^2 - 0.25^2) above the edges.
TEST(RefusedTriangles, let_a_ball_sink_between_their_edges)
{
    for (const Stepper stepper : kSteppers)
        for (const bool by_world : {false, true}) {
            const V3 at = end_over(Hole::kRefused, Shape::kBall, {stepper, by_world, 1.0 / 240});
            EXPECT_NEAR(at.z, std::sqrt(0.3 * 0.3 - 0.25 * 0.25), 3e-3)
                << name_of(stepper) << " " << by_world;
        }
}

dReal flat(void*, int, int) { return 0; }

// Meshes with callbacks and functions of heights have speculative contacts, as all else: nothing sinks in before it is
// stopped. (It sank in by what a step moves it, 27 mm here.)
TEST(RefusedTriangles, and_heights_of_functions_have_speculative_contacts)
{
    for (const Stepper stepper : kSteppers)
        for (const bool field : {false, true}) {
            Sim sim(stepper);
            sim.gravity(0, 0, -9.81);
            dWorldSetContactSpace(sim.world, sim.space);
            MeshGeom* const mesh = field ? nullptr : floor(sim.space, Hole::kLeftOut);
            dHeightfieldDataID data = dGeomHeightfieldDataCreate();
            if (field) {
                dGeomHeightfieldDataBuildCallback(data, nullptr, flat, 10, 10, 2, 2, 1, 0, 1, 0);
                dGeomHeightfieldDataSetBounds(data, -1, 1);
                const dGeomID geom = dCreateHeightfield(sim.space, data, 1);
                dQuaternion q;
                dQFromAxisAndAngle(q, 1, 0, 0, real(kPi / 2));
                dGeomSetQuaternion(geom, q);
            } else {
                dGeomTriMeshSetCallback(mesh->geom, keep_all);
            }
            const dBodyID ball = sim.sphere({0.8, 0.7, 0.6}, 0.3, 1);
            double lowest = 1;
            for (int i = 0; i < 60; ++i) {
                sim.advance(1.0 / 60);
                lowest = std::min(lowest, position(ball).z);
            }
            EXPECT_GT(lowest, 0.3 - 1e-3) << name_of(stepper) << " " << field;
            delete mesh;
            dSpaceDestroy(sim.space), sim.space = dHashSpaceCreate(nullptr);
            dGeomHeightfieldDataDestroy(data);
        }
}

}  // namespace
}  // namespace epode::physics
