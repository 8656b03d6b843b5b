// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays from anywhere a program may begin them, on geoms anywhere a program may put them. Many rays on a space at rest are cast in floats;
// what floats cannot hold once ended the program (a body thrown to 1e87 m, continuous collision).
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <vector>

namespace {

class FarRays : public testing::Test {
  protected:
    FarRays()
    {
        dInitODE2(0);
        space = dHashSpaceCreate(nullptr);
    }
    ~FarRays() override
    {
        dSpaceDestroy(space);
        dCloseODE();
    }

    void add_row(dReal spacing, dReal size)
    {
        for (int i = 0; i < 40; ++i) {
            const dGeomID ball = dCreateSphere(space, size);
            dGeomSetPosition(ball, spacing * dReal(i - 20), 0, 0);
            if (i == 0) first = ball;
        }
    }

    // The nearest of what dCollide says of each.
    dReal nearest_one_by_one(const dVector3 from, const dVector3 along, dReal length) const
    {
        const dGeomID ray = dCreateRay(nullptr, length);
        dGeomRaySet(ray, from[0], from[1], from[2], along[0], along[1], along[2]);
        dReal nearest = dInfinity;
        for (int i = 0; i < dSpaceGetNumGeoms(space); ++i) {
            dContactGeom hit;
            if (dCollide(ray, dSpaceGetGeom(space, i), 1, &hit, sizeof hit) > 0)
                nearest = std::min(nearest, hit.depth);
        }
        dGeomDestroy(ray);
        return nearest;
    }

    dSpaceID space;
    dGeomID first = nullptr;  // of the row
};

constexpr bool kDoubles = sizeof(dReal) == 8;

TEST_F(FarRays, end_and_are_what_pairs_say)
{
    const dReal far = kDoubles ? dReal(1e90) : dReal(1e17);
    add_row(dReal(2), dReal(0.5));
    int hits = 0;
    for (dReal away = dReal(1); away < far; away *= 10)
        for (int k = 0; k < 8; ++k) {  // more than a sixteenth of the geoms: in floats
            const dVector3 from = {dReal(4) * dReal(k), k % 2 ? away : -away, 0},
                           along = {0, k % 2 ? dReal(-1) : dReal(1), 0};
            dQueryHit hit;
            const int found = dSpaceRayClosest(space, from, along, dInfinity, nullptr, &hit);
            const dReal nearest = nearest_one_by_one(from, along, far);
            EXPECT_EQ(found, nearest < dInfinity) << away << " " << k;
            if (found && away < dReal(1e4)) {
                EXPECT_NEAR(double(hit.distance), double(nearest), 1e-6 * double(away));
            }
            hits += found;
        }
    EXPECT_GE(hits, 64);
}

TEST_F(FarRays, end_among_geoms_that_floats_cannot_hold)
{
    const dReal largest = kDoubles ? dReal(1e95) : dReal(1e16);
    for (dReal spacing = dReal(1e3); spacing < largest; spacing *= 1000) {
        dSpaceDestroy(space);
        space = dHashSpaceCreate(nullptr);
        add_row(spacing, spacing / 4);
        for (int k = 0; k < 12; ++k) {
            const dVector3 from = {-30 * spacing, spacing * dReal(0.01) * dReal(k), 0}, along = {1, 0, 0};
            dQueryHit hit;
            ASSERT_EQ(dSpaceRayClosest(space, from, along, dInfinity, nullptr, &hit), 1) << spacing;
            EXPECT_EQ(hit.geom, first) << spacing << " " << k;
        }
    }
}

}  // namespace
