// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Depths of contacts in the extremes. Below a plane they are the distance to it at any size of numbers, never infinite (they were beyond
// 1e50). A program that asks for 4 contacts with a mesh or a bumpy height field, which have more than ODE's, gets the best 4: the
// deepest of all is among them.
#include <ode/ext.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr dReal kFar = sizeof(dReal) == 8 ? dReal(1e99) : dReal(1e17);
constexpr double kExact = sizeof(dReal) == 8 ? 1e-12 : 1e-5;

std::vector<dContactGeom> collided(dGeomID a, dGeomID b, int capacity)
{
    std::vector<dContactGeom> out(static_cast<std::size_t>(capacity));
    out.resize(static_cast<std::size_t>(dCollide(a, b, capacity, out.data(), sizeof(dContactGeom))));
    return out;
}

double deepest(const std::vector<dContactGeom>& contacts)
{
    double depth = 0;
    for (const dContactGeom& c : contacts) depth = std::max(depth, double(c.depth));
    return depth;
}

TEST(TrustDepths, of_shapes_far_below_a_plane_are_their_distances)
{
    const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, kFar);
    for (const dGeomID shape : {dCreateSphere(nullptr, 1), dCreateBox(nullptr, 2, 2, 2),
                                dCreateCapsule(nullptr, dReal(0.5), 1), dCreateCylinder(nullptr, 1, 2)}) {
        for (const double z : {0.0, 1e-50, 1e-2, 0.5, -1.0}) {
            dGeomSetPosition(shape, 0, 0, dReal(z) * kFar);
            const std::vector<dContactGeom> contacts = collided(shape, plane, 8);
            ASSERT_FALSE(contacts.empty()) << z;
            EXPECT_NEAR(deepest(contacts) / double(kFar), 1 - z, kExact)
                << z << ", class " << dGeomGetClass(shape);
        }
        dGeomDestroy(shape);
    }
    dGeomDestroy(plane);
}

TEST(TrustDepths, the_best_four_contacts_with_a_bumpy_field_have_the_deepest)
{
    double heights[49];
    for (int i = 0; i < 49; ++i) heights[i] = 0.1 * ((i * 37) % 5);
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(data, heights, 0, 6, 6, 7, 7, 1, 0, 1, 0);
    const dGeomID field = dCreateHeightfield(nullptr, data, 1);
    int more = 0;
    for (const dGeomID shape :
         {dCreateSphere(nullptr, dReal(0.4)), dCreateBox(nullptr, 1, dReal(0.8), dReal(0.6)),
          dCreateCapsule(nullptr, dReal(0.3), dReal(0.6)),
          dCreateCylinder(nullptr, dReal(0.3), dReal(0.8))}) {
        for (int i = 0; i < 100; ++i) {
            dMatrix3 R;
            dRFromEulerAngles(R, dReal(0.7 * i), dReal(1.3 * i), dReal(0.4 * i));
            dGeomSetRotation(shape, R);
            dGeomSetPosition(shape, dReal(1.5 * std::sin(3.1 * i)), dReal(0.3),
                             dReal(1.5 * std::cos(1.7 * i)));
            const std::vector<dContactGeom> all = collided(shape, field, 64),
                                            four = collided(shape, field, 4);
            EXPECT_LE(four.size(), 4u);
            EXPECT_EQ(four.empty(), all.empty());
            EXPECT_DOUBLE_EQ(deepest(four), deepest(all))
                << "class " << dGeomGetClass(shape) << ", pose " << i;
            more += all.size() > 4;
        }
        dGeomDestroy(shape);
    }
    EXPECT_GT(more, 50) << "poses with more than four contacts";
    dGeomDestroy(field);
    dGeomHeightfieldDataDestroy(data);
}

// A ball over the corner of six triangles touches all of them at one point.
TEST(TrustDepths, the_best_four_contacts_with_a_mesh_have_the_deepest)
{
    std::vector<double> v;
    std::vector<dTriIndex> t;
    for (int i = 0; i < 5; ++i)
        for (int j = 0; j < 5; ++j) v.insert(v.end(), {double(i - 2), double(j - 2), 0});
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < 4; ++j) {
            const auto a = dTriIndex(i * 5 + j);
            t.insert(t.end(), {a, a + 5, a + 1, a + 1, a + 5, a + 6});
        }
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, v.data(), 24, 25, t.data(), int(t.size()), 12);
    const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr),
                  ball = dCreateSphere(nullptr, dReal(0.7));
    int more = 0;
    for (int i = 0; i < 49; ++i) {
        dGeomSetPosition(ball, dReal(0.5) * dReal(i % 7 - 3), dReal(0.5) * dReal(i / 7 - 3), dReal(0.65));
        const std::vector<dContactGeom> all = collided(mesh, ball, 32), four = collided(mesh, ball, 4);
        EXPECT_EQ(four.size(), std::min(all.size(), std::size_t(4)));
        EXPECT_DOUBLE_EQ(deepest(four), deepest(all)) << i;
        more += all.size() > 4;
    }
    EXPECT_GT(more, 0);
    dGeomDestroy(ball), dGeomDestroy(mesh);
    dGeomTriMeshDataDestroy(data);
}

}  // namespace
}  // namespace epode::physics
