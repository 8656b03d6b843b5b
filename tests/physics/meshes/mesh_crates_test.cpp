// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Crates of triangles on each other, their sides flush or nearly so. (Where sides were flush to 1e-9 there was no contact; to 1e-4, one
// was deep by half a crate or two, sideways or down.)
#include <algorithm>
#include <memory>

#include "mesh_floors.h"
#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kEdge = 0.5;

class MeshCrates : public testing::TestWithParam<Stepper> {};

TEST(MeshCratePairs, have_contacts_no_deeper_than_they_are)
{
    const std::unique_ptr<MeshGeom> low(box_mesh(nullptr, {kEdge, kEdge, kEdge})),
        high(box_mesh(nullptr, {kEdge, kEdge, kEdge}));
    for (const double yaw : {0.0, 1e-9, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.7})
        for (const double depth : {1e-5, 1e-4, 1e-3, 5e-3})
            for (const double x : {0.0, 1e-7, 1e-4, 0.01, 0.125, 0.2})
                for (const double y : {0.0, 1e-6, 0.03}) {
                    dMatrix3 R;
                    dRFromAxisAndAngle(R, 0, 0, 1, real(yaw));
                    dGeomSetRotation(high->geom, R);
                    dGeomSetPosition(high->geom, real(x), real(y), real(kEdge - depth));
                    dContactGeom c[16];
                    const int count = dCollide(high->geom, low->geom, 16, c, sizeof *c);
                    double deepest = 0, up = 0;
                    for (int i = 0; i < count; ++i) {
                        deepest = std::max(deepest, double(c[i].depth));
                        up = std::max(up, double(c[i].normal[2]));
                    }
                    EXPECT_GT(up, 0.999) << yaw << " " << depth << " " << x << " " << y;
                    EXPECT_LT(deepest, depth + tol(1e-6, 1e-5))
                        << yaw << " " << depth << " " << x << " " << y;
                }
}

TEST_P(MeshCrates, stand_on_each_other)
{
    for (const double yaw : {0.0, 1e-6, 0.1}) {
        WorldContactsSim sim(GetParam());
        sim.ground();
        std::vector<std::unique_ptr<MeshGeom>> crates;
        for (int i = 0; i < 3; ++i) {
            const dBodyID body = sim.body({0, 0, (i + 0.5) * kEdge}, 10, 10 * kEdge * kEdge / 6);
            crates.emplace_back(box_mesh(sim.space, {kEdge, kEdge, kEdge}));
            dGeomSetBody(crates.back()->geom, body);
            dMatrix3 R;
            dRFromAxisAndAngle(R, 0, 0, 1, real(i * yaw));
            dBodySetRotation(body, R);
        }
        sim.run(180);
        for (int i = 0; i < 3; ++i)
            EXPECT_LT(length(position(sim.bodies[std::size_t(i)]) - V3{0, 0, (i + 0.5) * kEdge}), 0.01)
                << yaw;
    }
}

INSTANTIATE_TEST_SUITE_P(Steppers, MeshCrates, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
