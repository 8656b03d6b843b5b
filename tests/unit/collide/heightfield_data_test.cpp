// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The data object and the geom: builders, bounding boxes, refusals, lifetimes.
#include <limits>

#include "../api/message_recorder.h"
#include "terrain.h"

namespace epode::test {
namespace {

struct Box {
    dReal v[6];
    explicit Box(dGeomID g) { dGeomGetAABB(g, v); }
};

void expect_box(dGeomID g, std::initializer_list<double> expected)
{
    const Box box(g);
    int k = 0;
    for (const double e : expected) {
        if (std::isinf(e))
            EXPECT_EQ(box.v[k], dReal(e)) << k;
        else
            EXPECT_NEAR(box.v[k], e, 1e-5) << k;
        ++k;
    }
}

dReal ramp(void* user, int x, int z) { return *static_cast<double*>(user) * x + z; }
dReal nonsense(void*, int, int) { return std::numeric_limits<double>::quiet_NaN(); }

struct HeightfieldData : testing::Test {
    HeightfieldData() { dInitODE(); }
    ~HeightfieldData() override
    {
        dGeomDestroy(geom);
        dCloseODE();
    }
    Real height_at(Real x, Real z)
    {
        const dGeomID ray = dCreateRay(nullptr, 1000);
        dGeomRaySet(ray, x, 500, z, 0, -1, 0);
        const std::vector<Found> f = contacts(ray, geom);
        dGeomDestroy(ray);
        return f.empty() ? -999 : f[0].pos.y;
    }
    dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomID geom = dCreateHeightfield(nullptr, data, 1);
    double cone[9] = {0, 0, 0, 0, 1, 0, 0, 0, 0};
};

TEST_F(HeightfieldData, all_builders_mean_the_same_field)
{
    const unsigned char bytes[6] = {0, 1, 2, 10, 11, 12};
    short shorts[6];
    float singles[6];
    double doubles[6];
    for (int kind = 0; kind < 4; ++kind) {
        for (int k = 0; k < 6; ++k) shorts[k] = bytes[k], singles[k] = bytes[k], doubles[k] = bytes[k];
        switch (kind) {
            case 0:
                dGeomHeightfieldDataBuildByte(data, bytes, 1, 2, 1, 3, 2, 2, 5, 1, 0);
                break;
            case 1:
                dGeomHeightfieldDataBuildShort(data, shorts, 1, 2, 1, 3, 2, 2, 5, 1, 0);
                break;
            case 2:
                dGeomHeightfieldDataBuildSingle(data, singles, 1, 2, 1, 3, 2, 2, 5, 1, 0);
                break;
            default:
                dGeomHeightfieldDataBuildDouble(data, doubles, 1, 2, 1, 3, 2, 2, 5, 1, 0);
                break;
        }
        for (int k = 0; k < 6; ++k)
            shorts[k] = 77, singles[k] = 77, doubles[k] = 77;  // the copy does not mind
        dGeomHeightfieldSetHeightfieldData(geom, data);
        expect_box(geom, {-1, 1, 4, 29, -0.5, 0.5});
        EXPECT_NEAR(height_at(0, 0), 2 * 6 + 5, 1e-4);
    }
}

TEST_F(HeightfieldData, a_callback_is_asked_sample_by_sample)
{
    double slope = Real(0.5);
    dGeomHeightfieldDataBuildCallback(data, &slope, ramp, 4, 4, 5, 5, 1, 0, Real(0.5), 0);
    expect_box(geom, {-2, 2, -INFINITY, INFINITY, -2, 2});
    EXPECT_NEAR(height_at(1, 0), 3 * 0.5 + 2, 1e-5);
    dGeomHeightfieldDataSetBounds(data, -1, 6);
    dGeomSetPosition(geom, 0, 1, 0);
    expect_box(geom, {-2, 2, -0.5, 7, -2, 2});
    dGeomHeightfieldDataBuildCallback(data, nullptr, nonsense, 4, 4, 5, 5, 2, 3, Real(0.5), 0);
    EXPECT_NEAR(height_at(1, 0), 4, 1e-5) << "no number counts as sample 0";
}

TEST_F(HeightfieldData, boxes_follow_pose_wrap_and_scale)
{
    dGeomHeightfieldDataBuildDouble(data, cone, 0, 4, 6, 3, 3, -2, Real(0.25), Real(0.5), 0);
    dGeomSetPosition(geom, 1, 2, 3);
    expect_box(geom, {-1, 3, 2 - 2.25, 2.25, 0, 6});
    dGeomHeightfieldDataBuildDouble(data, cone, 0, 4, 6, 3, 3, 1, 0, Real(0.5), 0);
    RandomNumbers dice(1);
    for (int trial = 0; trial < 20; ++trial) {
        const Pose pose{dice.vec(), to_matrix(dice.rotation())};
        place(geom, pose.p, pose.R);
        Vec3 lo{kInf, kInf, kInf}, hi{-kInf, -kInf, -kInf};
        for (int corner = 0; corner < 8; ++corner) {
            const Vec3 p = pose.to_world({corner & 1 ? Real(2) : Real(-2), corner & 2 ? 1 : Real(-0.5),
                                          corner & 4 ? Real(3) : Real(-3)});
            lo = min(lo, p), hi = max(hi, p);
        }
        expect_box(geom, {lo.x, hi.x, lo.y, hi.y, lo.z, hi.z});
    }
    dGeomHeightfieldDataBuildDouble(data, cone, 0, 4, 6, 3, 3, 1, 0, Real(0.5), 1);
    place(geom, {});
    expect_box(geom, {-INFINITY, INFINITY, -0.5, 1, -INFINITY, INFINITY});
    place(geom, {}, to_matrix(dice.rotation()));
    expect_box(geom, {-INFINITY, INFINITY, -INFINITY, INFINITY, -INFINITY, INFINITY});
}

TEST_F(HeightfieldData, refuses_what_is_no_field_and_keeps_what_it_had)
{
    dGeomHeightfieldDataBuildDouble(data, cone, 1, 4, 4, 3, 3, 1, 0, 1, 0);
    MessageRecorder messages;
    const auto build = [&](dHeightfieldDataID d, const double* h, Real w, Real l, int nx, int nz,
                           Real scale) {
        dGeomHeightfieldDataBuildDouble(d, h, 1, w, l, nx, nz, scale, 0, 1, 0);
        return messages.take();
    };
    const std::string bad = "2: Bad argument(s) in dGeomHeightfieldDataBuildDouble()";
    EXPECT_EQ(build(data, nullptr, 4, 4, 3, 3, 1), bad);
    EXPECT_EQ(build(nullptr, cone, 4, 4, 3, 3, 1), bad);
    EXPECT_EQ(build(data, cone, 0, 4, 3, 3, 1), bad);
    EXPECT_EQ(build(data, cone, 4, -1, 3, 3, 1), bad);
    EXPECT_EQ(build(data, cone, 4, 4, 1, 3, 1), bad);
    EXPECT_EQ(build(data, cone, 4, 4, 3, 0, 1), bad);
    EXPECT_EQ(build(data, cone, 4, 4, 3, 3, std::numeric_limits<Real>::quiet_NaN()), bad);
    for (const double broken : {std::numeric_limits<double>::quiet_NaN(), HUGE_VAL, -HUGE_VAL}) {
        cone[7] = broken;
        EXPECT_NE(build(data, cone, 4, 4, 3, 3, 1), "") << broken;
    }
    dGeomHeightfieldDataSetBounds(data, std::numeric_limits<Real>::quiet_NaN(), 1);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dGeomHeightfieldDataSetBounds()");
    dGeomHeightfieldDataBuildCallback(data, nullptr, nullptr, 4, 4, 3, 3, 1, 0, 1, 0);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dGeomHeightfieldDataBuildCallback()");
    EXPECT_NEAR(height_at(0, 0), 1, 1e-6) << "the old field is still there";
    expect_box(geom, {-2, 2, -1, 1, -2, 2});
    const dGeomID ball = dCreateSphere(nullptr, 1);
    dGeomHeightfieldSetHeightfieldData(ball, data);
    EXPECT_EQ(messages.take(), "2: argument not a heightfield in dGeomHeightfieldSetHeightfieldData()");
    dGeomDestroy(ball);
}

TEST_F(HeightfieldData, collides_with_nothing_without_data)
{
    EXPECT_EQ(height_at(0, 0), -999) << "not built yet";
    dGeomHeightfieldDataBuildDouble(data, cone, 1, 4, 4, 3, 3, 1, 0, 1, 0);
    EXPECT_EQ(dGeomHeightfieldGetHeightfieldData(geom), data);
    EXPECT_NEAR(height_at(0, 0), 1, 1e-6);
    dGeomHeightfieldDataDestroy(data);
    EXPECT_EQ(height_at(0, 0), -999) << "destroyed";
    EXPECT_EQ(dGeomHeightfieldGetHeightfieldData(geom), nullptr);
    const dHeightfieldDataID next = dGeomHeightfieldDataCreate();  // may well get the old one's place
    dGeomHeightfieldDataBuildDouble(next, cone, 1, 4, 4, 3, 3, 1, 0, 1, 0);
    EXPECT_EQ(height_at(0, 0), -999) << "not the geom's";
    dGeomHeightfieldSetHeightfieldData(geom, next);
    EXPECT_NEAR(height_at(0, 0), 1, 1e-6);
    dGeomHeightfieldDataDestroy(next);
    MessageRecorder messages;
    dGeomHeightfieldDataDestroy(next);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dGeomHeightfieldDataDestroy()");
}

TEST_F(HeightfieldData, fixed_fields_have_no_pose)
{
    dGeomHeightfieldDataBuildDouble(data, cone, 1, 4, 4, 3, 3, 1, 0, 1, 0);
    const dGeomID fixed = dCreateHeightfield(nullptr, data, 0);
    EXPECT_EQ(dGeomGetClass(fixed), dHeightfieldClass);
    MessageRecorder messages;
    dGeomSetPosition(fixed, 1, 2, 3);
    EXPECT_EQ(messages.take(), "2: geom must be placeable in dGeomSetPosition()");
    expect_box(fixed, {-2, 2, -1, 1, -2, 2});
    dGeomDestroy(fixed);
}

TEST_F(HeightfieldData, lives_in_spaces_and_on_bodies)
{
    dGeomHeightfieldDataBuildDouble(data, cone, 1, 4, 4, 3, 3, 1, 0, 1, 1);
    const dVector3 centre = {0, 0, 0}, extents = {5, 5, 5};
    for (const dSpaceID space : {dSimpleSpaceCreate(nullptr), dHashSpaceCreate(nullptr),
                                 dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XZY),
                                 dQuadTreeSpaceCreate(nullptr, centre, extents, 3)}) {
        dCreateHeightfield(space, data, 1);
        const dGeomID ball = dCreateSphere(space, 1);
        dGeomSetPosition(ball, 100, Real(1.5), 100);
        int pairs = 0;
        const auto near = [](void* count, dGeomID, dGeomID) { ++*static_cast<int*>(count); };
        dSpaceCollide(space, &pairs, near);
        EXPECT_EQ(pairs, 1) << dSpaceGetClass(space);
        dGeomSetPosition(ball, 100, Real(2.5), 100);
        dSpaceCollide(space, &pairs, near);
        EXPECT_EQ(pairs, 1) << dSpaceGetClass(space);
        EXPECT_EQ(dSpaceGetNumGeoms(space), 2);
        EXPECT_EQ(dSpaceQuery(space, dSpaceGetGeom(space, 0)), 1);
        dSpaceDestroy(space);
    }
}

TEST(Spaces, refuse_hints_that_mean_nothing)
{
    MessageRecorder messages;
    EXPECT_EQ(dSweepAndPruneSpaceCreate(nullptr, 0x3f), nullptr);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dSweepAndPruneSpaceCreate()");
    const dVector3 centre = {0, 0, 0}, extents = {5, 5, std::numeric_limits<Real>::quiet_NaN()};
    EXPECT_EQ(dQuadTreeSpaceCreate(nullptr, centre, extents, 3), nullptr);
    EXPECT_EQ(dQuadTreeSpaceCreate(nullptr, centre, nullptr, 3), nullptr);
    EXPECT_EQ(dQuadTreeSpaceCreate(nullptr, centre, centre, -1), nullptr);
    EXPECT_NE(messages.take(), "");
    for (const int order :
         {dSAP_AXES_XYZ, dSAP_AXES_XZY, dSAP_AXES_YXZ, dSAP_AXES_YZX, dSAP_AXES_ZXY, dSAP_AXES_ZYX}) {
        const dSpaceID space = dSweepAndPruneSpaceCreate(nullptr, order);
        ASSERT_NE(space, nullptr);
        EXPECT_EQ(dSpaceGetClass(space), dSweepAndPruneSpaceClass);
        dSpaceDestroy(space);
    }
    const dSpaceID tree = dQuadTreeSpaceCreate(nullptr, centre, centre, 0);
    EXPECT_EQ(dSpaceGetClass(tree), dQuadTreeSpaceClass);
    dSpaceDestroy(tree);
    EXPECT_EQ(messages.take(), "");
}

}  // namespace
}  // namespace epode::test
