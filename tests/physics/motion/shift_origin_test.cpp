// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Large worlds: what happens a thousand kilometres from the origin is what happens at it, and another origin changes
// nothing of what is relative.
#include <functional>
#include <vector>

#include "world_contacts.h"

namespace epode::physics {
namespace {

// Bodies that rest, slide, roll, hang from the world and knock each other over.
class Playground : public WorldContactsSim {
  public:
    Playground(Stepper s, V3 origin) : WorldContactsSim(s), origin_(origin)
    {
        dWorldSetAutoDisableFlag(world, 0);
        ground(origin.z);
        const dGeomID step = dCreateBox(space, 2, 2, real(0.5));
        dGeomSetPosition(step, real(origin.x + 3), real(origin.y), real(origin.z + 0.25));
        for (int i = 0; i < 4; ++i) box(at({0, 0, 0.25 + 0.5 * i}), {0.5, 0.5, 0.5}, 1);
        velocity(box(at({0, 2, 0.25}), {0.5, 0.5, 0.5}, 1), {2, 0.5, 0});
        velocity(sphere(at({-2, 0, 0.25}), 0.25, 1), {1, 0, 0});
        const dBodyID bob = sphere(at({6, 0, 2}), 0.2, 1);
        const dJointID hinge = dJointCreateHinge(world, nullptr);
        dJointAttach(hinge, bob, nullptr);
        dJointSetHingeAnchor(hinge, real(origin.x + 6), real(origin.y), real(origin.z + 3));
        dJointSetHingeAxis(hinge, 1, 0, 0);
        velocity(bob, {0, 1, 0});
        const dBodyID slid = sphere(at({9, 0, 2}), 0.2, 1);
        const dJointID slider = dJointCreateSlider(world, nullptr);
        dJointAttach(slider, slid, nullptr);
        dJointSetSliderAxis(slider, 1, 0, 0);
        velocity(slid, {0.5, 0, 0});
        const dBodyID fixed = sphere(at({12, 0, 2}), 0.2, 1);
        const dJointID holds = dJointCreateFixed(world, nullptr);
        dJointAttach(holds, fixed, nullptr);
        dJointSetFixed(holds);
    }
    V3 at(V3 p) const { return origin_ + p; }
    void shift(V3 offset)
    {
        const dVector3 by = {real(offset.x), real(offset.y), real(offset.z)};
        ASSERT_EQ(dWorldShiftOrigin(world, nullptr, by), 1);
        origin_ = origin_ - offset;
    }
    double apart(const Playground& other) const
    {
        double largest = 0;
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            const V3 one = position(bodies[i]) - origin_, two = position(other.bodies[i]) - other.origin_;
            largest = std::fmax(largest, length(one - two));
            largest = std::fmax(
                largest, length(vec(dBodyGetLinearVel(bodies[i])) - vec(dBodyGetLinearVel(other.bodies[i]))));
        }
        return largest;
    }

  private:
    V3 origin_;
};

// Sweeps end before they have converged, and rounding decides whether a corner at a gap of zero is in them.
class LargeWorld : public testing::TestWithParam<Stepper> {
  protected:
    static double bound() { return GetParam() == Stepper::kExact ? tol(1e-6, 2e-2) : 2e-2; }
};

TEST_P(LargeWorld, at_a_thousand_kilometres_nothing_is_different)
{
    if (kSingle) GTEST_SKIP() << "floats know a place there to 6 cm";
    Playground here(GetParam(), {}), far(GetParam(), {1e6, -1e6, 0});
    for (int i = 0; i < 120; ++i) {
        here.run(1), far.run(1);
        ASSERT_LT(here.apart(far), bound()) << i;
    }
}

// All places are in the binade of 2^20 before and after: the sums are exact.
TEST_P(LargeWorld, a_shift_by_exact_sums_keeps_every_bit)
{
    if (kSingle) GTEST_SKIP() << "sums of floats are rounded there";
    const V3 origin{1310720, 1310720, 0};
    Playground stays(GetParam(), origin), moves(GetParam(), origin);
    for (int i = 0; i < 120; ++i) {
        if (i == 20) moves.shift({8192, -131072, 0});
        if (i == 70) moves.shift({-1024, 2048, 0});
        stays.run(1), moves.run(1);
        ASSERT_EQ(stays.apart(moves), 0) << i;
    }
}

TEST_P(LargeWorld, any_shift_changes_nothing_but_rounding)
{
    Playground stays(GetParam(), {}), moves(GetParam(), {});
    for (int i = 0; i < 60; ++i) {
        if (i == 20) moves.shift({3.7, -12.9, 1.3});
        stays.run(1), moves.run(1);
        ASSERT_LT(stays.apart(moves), bound()) << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Steppers, LargeWorld, testing::ValuesIn(kSteppers), case_name);

TEST(ShiftOrigin, moves_anchors_planes_fluids_and_contacts)
{
    Playground sim(Stepper::kExact, {});
    sim.run(10);
    const dWorldContact before = sim.all_contacts().at(0);
    const dJointID hinge = dBodyGetJoint(sim.bodies[6], 0);
    dVector3 anchor;
    dJointGetHingeAnchor2(hinge, anchor);
    const dFluidID fluid = dFluidCreate(sim.world);
    ASSERT_NE(fluid, nullptr);
    const V3 held = vec(anchor);
    sim.shift({100, 200, 50});
    dJointGetHingeAnchor2(hinge, anchor);
    EXPECT_NEAR(length(vec(anchor) - held + V3{100, 200, 50}), 0, tol(1e-12, 1e-4));
    const dWorldContact after = sim.all_contacts().at(0);
    EXPECT_NEAR(length(vec(after.pos) - vec(before.pos) + V3{100, 200, 50}), 0, tol(1e-12, 1e-4));
}

TEST(ShiftOrigin, is_refused_where_it_would_break_something)
{
    Playground sim(Stepper::kExact, {});
    const V3 was = position(sim.bodies[0]);
    dSetMessageHandler([](int, const char*, va_list) {});
    const dVector3 no_number = {dInfinity, 0, 0}, up = {0, 0, 1};
    EXPECT_EQ(dWorldShiftOrigin(sim.world, nullptr, no_number), 0);
    EXPECT_EQ(dWorldShiftOrigin(sim.world, nullptr, nullptr), 0);
    EXPECT_EQ(dWorldShiftOrigin(nullptr, nullptr, up), 0);
    dJointAttach(dJointCreatePlane2D(sim.world, nullptr), sim.bodies[0], nullptr);
    EXPECT_EQ(dWorldShiftOrigin(sim.world, nullptr, up), 0);
    EXPECT_EQ(length(position(sim.bodies[0]) - was), 0);
    dSetMessageHandler(nullptr);
}

}  // namespace
}  // namespace epode::physics
