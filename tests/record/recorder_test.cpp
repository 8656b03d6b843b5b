// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the recorder tells of a world is what the world's own functions say, whatever is made, moved and
// destroyed meanwhile.
#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>

#include "record/file/hash.h"
#include "record/rerun/compare.h"
#include "record/watch/joints.h"
#include "record/watch/recorder.h"
#include "record/watch/shapes.h"

namespace epode::record {
namespace {

constexpr double kTiny = sizeof(dReal) == 8 ? 1e-12 : 1e-5;

class RecorderTest : public ::testing::Test {
  protected:
    void SetUp() override
    {
        dInitODE2(0);
        world = dWorldCreate();
        space = dSimpleSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
    }
    void TearDown() override
    {
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    dBodyID body_at(double x, double y, double z)
    {
        dBodyID body = dBodyCreate(world);
        dBodySetPosition(body, dReal(x), dReal(y), dReal(z));
        return body;
    }
    void step(double time) { recorder.step({time, 0.01, 0, 0, 0, 0}, {}, false); }

    dWorldID world = nullptr;
    dSpaceID space = nullptr;
    Recording got;
    Recorder recorder{got};
};

TEST_F(RecorderTest, reports_states_as_the_library_does)
{
    dBodyID a = body_at(1, 2, 3), b = body_at(4, 5, 6);
    dBodySetAngularVel(a, 1, 2, 3);
    dBodyDisable(b);
    recorder.add(a);
    recorder.add(b);
    for (int i = 0; i < 10; ++i) {
        step(0.01 * i);
        dWorldQuickStep(world, dReal(0.01));
    }
    step(0.1);
    ASSERT_EQ(got.steps.size(), 11u);
    const BodyState& last = got.steps.back().bodies.at(0);
    for (size_t i = 0; i < 3; ++i) {
        EXPECT_EQ(last.pose.pos[i], double(dBodyGetPosition(a)[i]));
        EXPECT_EQ(last.angular[i], double(dBodyGetAngularVel(a)[i]));
        EXPECT_EQ(last.linear[i], double(dBodyGetLinearVel(a)[i]));
    }
    for (size_t i = 0; i < 4; ++i) EXPECT_EQ(last.pose.turn[i], double(dBodyGetQuaternion(a)[i]));
    EXPECT_EQ(got.steps.back().hash, hash_states({state_of(a), state_of(b)}));
    EXPECT_EQ(got.steps.back().asleep, (std::vector<std::uint8_t>{0, 1}));
}

TEST_F(RecorderTest, follows_what_comes_goes_and_moves)
{
    dBodyID a = body_at(0, 0, 0), b = body_at(1, 0, 0);
    dGeomID wall = dCreateBox(space, 1, 2, 3), ball = dCreateSphere(space, 1);
    dGeomSetBody(ball, b);
    recorder.add(a);
    recorder.add(b);
    recorder.add(wall);
    recorder.add(ball);
    step(0);
    dGeomSetPosition(wall, 7, 8, 9);
    step(0.01);
    EXPECT_EQ(got.moves.size(), 1u);
    EXPECT_EQ(got.moves.at(0).pose.pos, (Vec3{7, 8, 9}));
    dGeomSetBody(ball, a);
    dGeomSetOffsetPosition(ball, 0, 0, dReal(0.5));
    recorder.remove(b);
    dBodyDestroy(b);
    dBodyID c = body_at(2, 2, 2);
    recorder.add(c);
    step(0.02);
    ASSERT_EQ(got.moves.size(), 2u);
    EXPECT_EQ(got.moves.at(1).geom, 1u);
    EXPECT_EQ(got.moves.at(1).body, 0);
    EXPECT_EQ(got.moves.at(1).pose.pos, (Vec3{0, 0, 0.5}));
    EXPECT_EQ(got.living(2), (std::vector<std::uint32_t>{0, 2}));
    recorder.remove(wall);
    step(0.03);
    EXPECT_FALSE(got.geom_lives.at(0).at(3));
    EXPECT_TRUE(got.geom_lives.at(0).at(2));
}

TEST_F(RecorderTest, gives_equal_shapes_one_number)
{
    recorder.add(dCreateSphere(space, 1));
    recorder.add(dCreateSphere(space, 1));
    recorder.add(dCreateSphere(space, 2));
    recorder.add(dCreateBox(space, 1, 0, 0));
    EXPECT_EQ(got.shapes.size(), 3u);
    EXPECT_EQ(got.geoms.at(0).shape, got.geoms.at(1).shape);
}

TEST_F(RecorderTest, joints_are_recorded_in_their_bodies_frames)
{
    dBodyID a = body_at(0, 0, 1), b = body_at(0, 0, 3);
    dMatrix3 turn;
    dRFromAxisAndAngle(turn, 1, 0, 0, dReal(M_PI / 2));
    dBodySetRotation(b, turn);
    dJointID hinge = dJointCreateHinge(world, nullptr);
    dJointAttach(hinge, a, b);
    dJointSetHingeAnchor(hinge, 0, 0, 2);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    recorder.add(a);
    recorder.add(b);
    recorder.add(hinge);
    ASSERT_EQ(got.joints.size(), 1u);
    const Joint& joint = got.joints.at(0);
    EXPECT_EQ(joint.body, (std::array<std::int32_t, 2>{0, 1}));
    EXPECT_NEAR(joint.anchor[0][2], 1, kTiny);
    EXPECT_NEAR(joint.anchor[1][1], -1, kTiny);  // b is turned: the world's -z is its -y
    EXPECT_NEAR(joint.axis[0][1], 1, kTiny);
    EXPECT_NEAR(joint_gap(hinge), 0, kTiny);
    dBodySetPosition(b, 0, 0, dReal(3.25));
    EXPECT_NEAR(joint_gap(hinge), 0.25, kTiny);
    // Attached elsewhere it is another joint.
    step(0);
    dJointAttach(hinge, b, nullptr);
    step(0.01);
    ASSERT_EQ(got.joints.size(), 2u);
    EXPECT_EQ(got.joints.at(1).body, (std::array<std::int32_t, 2>{1, kNobody}));
    EXPECT_EQ(got.joint_lives.at(0).died, 1u);
}

TEST_F(RecorderTest, every_joint_type_can_be_recorded)
{
    dBodyID a = body_at(0, 0, 1), b = body_at(0, 0, 3);
    recorder.add(a);
    recorder.add(b);
    using Make = dJointID (*)(dWorldID, dJointGroupID);
    for (Make make :
         {Make(dJointCreateBall), Make(dJointCreateHinge), Make(dJointCreateSlider),
          Make(dJointCreateUniversal), Make(dJointCreateHinge2), Make(dJointCreateFixed),
          Make(dJointCreateNull), Make(dJointCreateAMotor), Make(dJointCreateLMotor),
          Make(dJointCreatePlane2D), Make(dJointCreatePR), Make(dJointCreatePU), Make(dJointCreatePiston),
          Make(dJointCreateDBall), Make(dJointCreateDHinge), Make(dJointCreateTransmission)}) {
        dJointID joint = make(world, nullptr);
        const bool alone = dJointGetType(joint) == dJointTypePlane2D;
        dJointAttach(joint, a, alone ? nullptr : b);
        recorder.add(joint);
        const Joint& joint_seen = got.joints.back();
        EXPECT_EQ(joint_seen.type, std::uint32_t(dJointGetType(joint)));
        for (size_t i = 0; i < 2; ++i) {
            for (double value : joint_seen.anchor[i]) EXPECT_TRUE(std::isfinite(value)) << joint_seen.type;
            for (double value : joint_seen.axis[i]) EXPECT_TRUE(std::isfinite(value)) << joint_seen.type;
        }
        EXPECT_NEAR(joint_gap(joint), 0, kTiny) << joint_seen.type;
    }
}

TEST_F(RecorderTest, surfaces_are_the_librarys)
{
    // A tetrahedron as a mesh, turned and moved: its corners come back in its own frame.
    const dReal points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
    const dTriIndex faces[] = {0, 2, 1, 0, 1, 3, 1, 2, 3, 0, 3, 2};
    dVector3 corners[4] = {};
    for (int i = 0; i < 4; ++i) {
        for (int k = 0; k < 3; ++k) corners[i][k] = points[3 * i + k];
    }
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, corners[0], 4, faces, 12);
    dGeomID mesh = dCreateTriMesh(space, data, nullptr, nullptr, nullptr);
    dMatrix3 turn;
    dRFromAxisAndAngle(turn, 1, 2, 3, 1);
    dGeomSetRotation(mesh, turn);
    dGeomSetPosition(mesh, 5, 6, 7);
    dGeomID convex = dCreateConvexHull(space, points, 4, 0);
    for (const Shape& shape : {shape_of(mesh), shape_of(convex)}) {
        ASSERT_EQ(shape.vertices.size(), 4u);
        ASSERT_EQ(shape.triangles.size(), 4u);
        double volume = 0;  // six times that of the solid, positive when the triangles face outwards
        for (const auto& t : shape.triangles) {
            const Vec3 a = shape.vertices[t[0]], b = shape.vertices[t[1]], c = shape.vertices[t[2]];
            volume += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                      a[2] * (b[0] * c[1] - b[1] * c[0]);
        }
        EXPECT_NEAR(volume, 1, 100 * kTiny);
    }
    // Two geoms of one mesh are one shape.
    recorder.add(mesh);
    recorder.add(dCreateTriMesh(space, data, nullptr, nullptr, nullptr));
    EXPECT_EQ(got.shapes.size(), 1u);
    dSpaceClean(space);
    dGeomTriMeshDataDestroy(data);
}

TEST_F(RecorderTest, shapes_beyond_odes_are_recorded_by_their_surface)
{
    const struct {
        dGeomID geom;
        double volume;
    } cases[] = {{dCreateCone(space, 1, 3), 3.14159265},
                 {dCreateEllipsoid(space, 1, 2, dReal(0.5)), 4.1887902},
                 {dCreateTaperedCapsule(space, 1, dReal(0.5), 0), 4.1887902}};
    for (const auto& one : cases) {
        const Shape shape = shape_of(one.geom);
        EXPECT_EQ(shape.kind, ShapeKind::kConvex);
        ASSERT_GT(shape.triangles.size(), 30u);
        EXPECT_LT(shape.vertices.size(), shape.triangles.size());
        double volume = 0;
        for (const auto& t : shape.triangles) {
            const Vec3 a = shape.vertices[t[0]], b = shape.vertices[t[1]], c = shape.vertices[t[2]];
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                       a[2] * (b[0] * c[1] - b[1] * c[0])) /
                      6;
        }
        EXPECT_NEAR(volume, one.volume, 0.05 * one.volume);
    }
    dSpaceClean(space);
}

dReal slope(void*, int x, int z) { return dReal(0.1) * dReal(x) + dReal(0.2) * dReal(z); }

TEST_F(RecorderTest, height_fields_are_found_by_rays)
{
    // h = 0.1 i + 0.2 j over 4 x 6 m with 5 x 7 samples: h = 0.1 (x + 2) + 0.2 (z + 3) in its frame.
    dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildCallback(data, nullptr, slope, 4, 6, 5, 7, 1, 0, 1, 0);
    dGeomHeightfieldDataSetBounds(data, 0, 2);
    dGeomID field = dCreateHeightfield(space, data, 1);
    dMatrix3 upright;
    dRFromAxisAndAngle(upright, 1, 0, 0, dReal(M_PI / 2));
    dGeomSetRotation(field, upright);
    dGeomSetPosition(field, 10, 20, 30);
    const Shape shape = shape_of(field);
    ASSERT_EQ(shape.vertices.size(), 65u * 65u);
    EXPECT_EQ(shape.triangles.size(), 2u * 64u * 64u);
    for (const Vec3& p : shape.vertices) {
        EXPECT_LE(std::abs(p[0]), 2.0001);
        EXPECT_LE(std::abs(p[2]), 3.0001);
        EXPECT_NEAR(p[1], 0.1 * (p[0] + 2) + 0.2 * (p[2] + 3), sizeof(dReal) == 8 ? 1e-9 : 1e-4);
    }
    dGeomDestroy(field);
    dGeomHeightfieldDataDestroy(data);
}

TEST_F(RecorderTest, differences_are_found_where_they_are)
{
    Recording other;
    dBodyID a = body_at(0, 0, 0), b = body_at(1, 0, 0);
    for (Recording* recording : {&got, &other}) {
        Recorder twin(*recording);
        dBodySetPosition(a, 0, 0, 0);
        twin.add(a);
        twin.add(b);
        for (int i = 0; i < 5; ++i) {
            if (recording == &other && i == 3) dBodySetPosition(b, 1, 0, dReal(0.5));
            twin.step({0.01 * i, 0.01, 0, 0, 0, 0}, {}, false);
        }
    }
    EXPECT_EQ(incomparable(got, other), "");
    EXPECT_FALSE(first_difference(got, got));
    const auto found = first_difference(got, other);
    ASSERT_TRUE(found);
    EXPECT_EQ(found->step, 3u);
    EXPECT_EQ(found->body, 1u);
    EXPECT_DOUBLE_EQ(found->pos, 0.5);
    EXPECT_EQ(worst_distance(got, other, 4).body, 1u);
    other.steps[2].bodies.pop_back();
    EXPECT_NE(incomparable(got, other).find("step 2"), std::string::npos);
}

TEST(RecordingDistance, of_turns_is_the_angle_between_them)
{
    BodyState a, b;
    b.pose.turn = {std::cos(0.35), std::sin(0.35), 0, 0};
    EXPECT_NEAR(distance(a, b).turn, 0.7, 1e-12);
    for (double& value : b.pose.turn) value = -value;  // the same rotation
    EXPECT_NEAR(distance(a, b).turn, 0.7, 1e-12);
}

}  // namespace
}  // namespace epode::record
