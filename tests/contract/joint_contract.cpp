// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every line of joint_types.inc must keep, whoever wrote it: rows within the stated number; Jacobians
// that are the derivative of their errors; action equals reaction, in force and in moment; (A,B) and (B,A)
// the same constraint; parameters read as they were set. Random poses, fixed seed. A new type is judged from
// its line in joint_types.inc on; how its anchors and axes are set may be a line of joint_geometry.cpp.
#include <gtest/gtest.h>

#include <string>

#include "../unit/joints/rig.h"
#include "../unit/joints/row_lines.h"
#include "joint_geometry.h"

namespace epode::test {
namespace {

class JointContract : public testing::TestWithParam<JointCase> {
  protected:
    Rig rig;
    Dice dice;

    struct Scene {
        Body *a, *b;
        JointGeometry geometry;
        dJointID joint;
    };
    Scene scene(bool one_body = false, bool swapped = false)
    {
        const Vec3 xa = dice.vector(), xb = dice.vector();
        const Quat qa = dice.rotation(), qb = dice.rotation();
        const JointGeometry g(dice);
        Scene s{rig.body(xa, qa), one_body ? nullptr : rig.body(xb, qb), g, nullptr};
        s.joint = GetParam().create(rig.id(), g, swapped);
        swapped ? Rig::join(s.joint, s.b, s.a) : Rig::join(s.joint, s.a, s.b);
        set_geometry(s.joint, g, swapped);
        return s;
    }
    const JointType& type() const { return *joint_type(GetParam().number); }
    // Plane2D holds body 1 to a fixed plane of the world, whatever body 2 and the pose of setting, and lets a
    // tilt be: promises about pairs of bodies are not its own (tests/unit/joints/plane2d_test.cpp has them).
    bool bound_to_the_world() const { return GetParam().number == dJointTypePlane2D; }
};

TEST_P(JointContract, is_in_the_table_under_its_number_and_name)
{
    const JointType* t = joint_type(GetParam().number);
    ASSERT_NE(t, nullptr);
    EXPECT_EQ(t->number, GetParam().number);
    EXPECT_STREQ(t->name, GetParam().name);
    EXPECT_TRUE(t->emit && t->attached && t->set_param && t->get_param && t->destroy);
}

TEST_P(JointContract, is_made_by_the_function_of_its_name)
{
    EXPECT_EQ(from_handle<Joint>(scene().joint)->type, &type());
}

TEST_P(JointContract, has_no_error_where_it_is_set)
{
    if (bound_to_the_world()) GTEST_SKIP() << "holds one body to a plane of the world";
    for (int trial = 0; trial < 20; ++trial) {
        const Scene s = scene(trial % 2 == 1 && !type().needs_two_bodies);
        if (!has_geometry(s.joint)) GTEST_SKIP() << kNoGeometry;
        for (const Row& r : rig.emit(s.joint).rows) {
            if (r.kind == RowKind::kLock) { EXPECT_NEAR(r.error, 0, 100 * kEpsilon); }
        }
    }
}

TEST_P(JointContract, writes_finite_rows_within_its_number)
{
    for (int trial = 0; trial < 20; ++trial) {
        const Scene s = scene(trial % 2 == 1 && !type().needs_two_bodies);
        const Emitted e = rig.emit(s.joint);
        EXPECT_LE(int(e.rows.size()), type().max_rows);
        for (const Row& r : e.rows) {
            for (Real v : line(r)) EXPECT_TRUE(usable(v));
            EXPECT_TRUE(usable(r.error) && usable(r.speed) && usable(r.erp) && usable(r.cfm));
            const bool motor = r.kind == RowKind::kLimit && r.lo < 0 && r.hi > 0;
            EXPECT_FALSE(motor && r.erp != 0);  // no position to correct
            EXPECT_LE(r.lo, 0);
            EXPECT_GE(r.hi, 0);
            EXPECT_LT(r.parent, int(e.rows.size()));
        }
    }
}

// d(error)/dt = -S J v with ones on the diagonal of S: each row's error falls at the rate its own J measures,
// up to motions that other rows of the joint forbid.
TEST_P(JointContract, jacobian_is_the_derivative_of_the_error)
{
    if (bound_to_the_world()) GTEST_SKIP() << "holds one body to a plane of the world";
    for (int trial = 0; trial < 10; ++trial) {
        const bool one_body = trial % 2 == 1 && !type().needs_two_bodies;
        const Scene s = scene(one_body);
        expect_exact_derivative(rig, s.joint, s.a, s.b);
    }
}

TEST_P(JointContract, makes_neither_momentum_nor_moment)
{
    if (bound_to_the_world()) GTEST_SKIP() << "holds one body to a plane of the world";
    for (int trial = 0; trial < 10; ++trial) {
        const Scene s = scene();
        expect_momentum(rig, s.joint, s.a, s.b);
    }
}

TEST_P(JointContract, is_the_same_constraint_with_bodies_exchanged)
{
    if (bound_to_the_world()) GTEST_SKIP() << "holds one body to a plane of the world";
    for (int trial = 0; trial < 10; ++trial) {
        const Dice before = dice;
        const Scene straight = scene();
        if (!has_geometry(straight.joint)) GTEST_SKIP() << kNoGeometry;
        dice = before;
        const Scene crossed = scene(false, true);
        const std::vector<Row> one = rig.emit(straight.joint).rows, two = rig.emit(crossed.joint).rows;
        ASSERT_EQ(one.size(), two.size());
        std::vector<Line> a, b;
        for (const Row& r : one) a.push_back(line(r));
        for (const Row& r : two) {
            Line l = line(r);
            for (int i = 0; i < 6; ++i) std::swap(l[i], l[i + 6]);
            b.push_back(l);
        }
        for (const Line& l : b) EXPECT_LT(size(outside_span(a, l)), kTight);
        for (const Line& l : a) EXPECT_LT(size(outside_span(b, l)), kTight);
    }
}

TEST_P(JointContract, leaves_the_world_out_of_one_body_rows)
{
    if (type().needs_two_bodies) GTEST_SKIP() << "needs two bodies";
    const Scene s = scene(true);
    for (const Row& r : rig.emit(s.joint).rows) {
        EXPECT_EQ(length2(r.lin2), 0);
        EXPECT_EQ(length2(r.ang2), 0);
    }
}

TEST_P(JointContract, reversed_to_the_world_holds_the_same_pose)
{
    if (bound_to_the_world()) GTEST_SKIP() << "holds one body to a plane of the world";
    if (type().needs_two_bodies) GTEST_SKIP() << "needs two bodies";
    const JointGeometry g(dice);
    Body* b = rig.body(dice.vector(), dice.rotation());
    const dJointID j = GetParam().create(rig.id(), g, false);
    Rig::join(j, nullptr, b);
    if (!has_geometry(j)) GTEST_SKIP() << kNoGeometry;
    set_geometry(j, g);
    EXPECT_TRUE(from_handle<Joint>(j)->reverse);
    for (const Row& r : rig.emit(j).rows) EXPECT_NEAR(r.error, 0, 100 * kEpsilon);
}

TEST_P(JointContract, reads_every_parameter_it_lets_be_set)
{
    const Scene s = scene();
    Joint& j = *from_handle<Joint>(s.joint);
    for (int group = 0; group < 4; ++group)
        for (int p = 0; p < dParamsInGroup; ++p) {
            const int param = group * dParamGroup + p;
            const Real wanted = Real(0.25) + Real(p) / 64 + Real(group) / 256;
            const bool known = type().set_param(j, param, wanted);
            Real value = -1;
            EXPECT_EQ(type().get_param(j, param, value), known) << std::hex << param;
            EXPECT_EQ(value, known ? wanted : -1) << std::hex << param;
        }
    // Setting one did not disturb another.
    for (int group = 0; group < 4; ++group)
        for (int p = 0; p < dParamsInGroup; ++p) {
            const Real wanted = Real(0.25) + Real(p) / 64 + Real(group) / 256;
            Real value = wanted;
            type().get_param(j, group * dParamGroup + p, value);
            EXPECT_EQ(value, wanted) << group << ' ' << p;
        }
}

TEST_P(JointContract, keeps_its_row_count_at_inner_poses)
{
    const Scene s = scene();
    Joint& j = *from_handle<Joint>(s.joint);
    if (j.type->number == dJointTypeContact) GTEST_SKIP() << "contacts are written once a step";
    for (int group = 0; group < 3; ++group) {
        type().set_param(j, group * dParamGroup + dParamLoStop, Real(-0.2));
        type().set_param(j, group * dParamGroup + dParamHiStop, Real(0.2));
        type().set_param(j, group * dParamGroup + dParamFMax, 0);
    }
    for (int trial = 0; trial < 20; ++trial) {
        rig.info.inner = false;
        Rig::place(s.a, dice.vector(), dice.rotation());
        const std::vector<Row> first = rig.emit(s.joint).rows;
        rig.info.inner = true;
        Rig::place(s.a, dice.vector(), dice.rotation());
        const Emitted inner = rig.emit(s.joint);
        EXPECT_FALSE(inner.applied);
        ASSERT_EQ(inner.rows.size(), first.size())
            << "emit() must write as many rows at an inner pose (out.info().inner) as at the step's first "
               "pose:\n"
               "decide by what was remembered then, not by the pose (docs/architecture.md, A joint type)";
        for (std::size_t i = 0; i < first.size(); ++i) {
            EXPECT_EQ(inner.rows[i].lo, first[i].lo);
            EXPECT_EQ(inner.rows[i].hi, first[i].hi);
            EXPECT_EQ(inner.rows[i].kind, first[i].kind);
        }
    }
}

TEST_P(JointContract, survives_the_loss_of_its_bodies_and_a_new_attachment)
{
    const Scene s = scene();
    Joint& j = *from_handle<Joint>(s.joint);
    destroy_body(*s.b);
    EXPECT_FALSE(j.attached());
    Body* c = rig.body(dice.vector(), dice.rotation());
    Rig::join(s.joint, s.a, c);
    EXPECT_LE(int(rig.emit(s.joint).rows.size()), type().max_rows);
}

INSTANTIATE_TEST_SUITE_P(AllTypes, JointContract, testing::ValuesIn(joint_cases()),
                         [](const auto& test) { return std::string(test.param.name); });

}  // namespace
}  // namespace epode::test
