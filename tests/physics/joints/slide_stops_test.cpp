// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Stops and motors of slides whose bodies hang off them: on a PR joint a body swings about a line that its
// centre is not on. A stop is where the anchor is, and does no work on what swings; a motor moves the anchor,
// not the centre.
#include <algorithm>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81, kStop = 0.3, kArm = 0.4;

// The anchor slides along x and carries, at the end of an arm, a body that turns about y. The slide is the
// world's, or that of a carriage on rails of the world.
struct Swing {
    Swing(Stepper stepper, bool carriage) : sim(stepper)
    {
        sim.gravity(2, 0, -kG);
        bob = sim.body({0.2, 0, -kArm}, 1.5, 0.02);
        rail = carriage ? sim.body({-0.5, 0.3, 0.2}, 3, 0.5) : nullptr;
        if (rail) {
            const dJointID fixed = dJointCreateFixed(sim.world, nullptr);
            dJointAttach(fixed, rail, nullptr), dJointSetFixed(fixed);
        }
        // Body 1 has the slide.
        pr = dJointCreatePR(sim.world, nullptr);
        rail ? dJointAttach(pr, rail, bob) : dJointAttach(pr, nullptr, bob);
        dJointSetPRAnchor(pr, 0, 0, 0);
        dJointSetPRAxis1(pr, 1, 0, 0);
        dJointSetPRAxis2(pr, 0, 1, 0);
        sim.substeps = 8;
    }
    double total() const
    {
        const V3 at = position(bob);
        return kinetic_energy(bob) + 1.5 * (kG * at.z - 2 * at.x);
    }
    double place() const { return double(dJointGetPRPosition(pr)); }

    Sim sim;
    dBodyID bob, rail;
    dJointID pr;
};

class SlideStops : public testing::TestWithParam<std::tuple<Stepper, bool>> {
  protected:
    Swing swing{std::get<0>(GetParam()), std::get<1>(GetParam())};
};

TEST_P(SlideStops, hold_the_anchor_of_what_swings_and_do_no_work)
{
    dJointSetPRParam(swing.pr, dParamLoStop, -real(kStop));
    dJointSetPRParam(swing.pr, dParamHiStop, real(kStop));
    const double start = swing.total();
    double farthest = 0;
    for (int i = 0; i < 5000; ++i) {
        swing.sim.advance(0.002);
        // What a first-order step and the correction of the stop may add; those of ODE add without limit (D45).
        ASSERT_LT(swing.total(), start + 0.9) << "step " << i;
        farthest = std::max(farthest, std::fabs(swing.place()));
        ASSERT_LT(farthest, kStop + 0.03) << "step " << i;
    }
    EXPECT_GT(farthest, 0.99 * kStop);
}

TEST_P(SlideStops, a_motor_moves_the_anchor_while_the_body_swings)
{
    dJointSetPRParam(swing.pr, dParamVel, real(0.25));
    dJointSetPRParam(swing.pr, dParamFMax, 500);
    const double before = swing.place();
    for (int i = 0; i < 1000; ++i) {
        swing.sim.advance(0.002);
        ASSERT_NEAR(std::fabs(swing.place() - before), 0.25 * 0.002 * (i + 1), 5e-3) << "step " << i;
    }
}

INSTANTIATE_TEST_SUITE_P(All, SlideStops, testing::Combine(testing::ValuesIn(kSteppers), testing::Bool()),
                         [](const auto& of) {
                             return std::string(name_of(std::get<0>(of.param))) +
                                    (std::get<1>(of.param) ? "_carriage" : "_world");
                         });

}  // namespace
}  // namespace epode::physics
