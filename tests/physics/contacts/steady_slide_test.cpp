// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A ball that is dragged along the ground at a constant speed, with 50 times its weight on it, carries this weight in
// every step and rubs with mu times it, whatever mu is: impulses that a step leaves begin the next one although
// friction is larger than they are, because it ends no slip.
#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kDragged = 2, kBelow = 1, kOnTop = 50;

class Dragged : public WorldContactsSim {
  public:
    explicit Dragged(double mu) : WorldContactsSim(Stepper::kFast)
    {
        substeps = 4;
        set_material(floor_ = ground(), mu);
        carriage_ = body({0, 0, 3});
        dBodySetKinematic(carriage_);
        velocity(carriage_, {kDragged, 0, 0});
        drag(ball_ = sphere({0, 0, 0.5}, 0.5, kBelow), mu);
        drag(sphere({0, 0, 1.5}, 0.5, kOnTop), mu);
    }

    // Up and down as it likes.
    void drag(dBodyID body, double mu)
    {
        velocity(body, {kDragged, 0, 0});
        set_material(geom_of(body), mu);
        const dJointID slider = dJointCreateSlider(world, nullptr);
        dJointAttach(slider, body, carriage_);
        dJointSetSliderAxis(slider, 0, 0, 1);
    }

    double height() const { return position(ball_).z; }
    dWorldContact of_ground() const
    {
        for (const dWorldContact& c : all_contacts())
            if (c.g1 == floor_ || c.g2 == floor_) return c;
        ADD_FAILURE() << "nothing touches the ground";
        return {};
    }

  private:
    dGeomID floor_;
    dBodyID carriage_, ball_;
};

class SteadySlide : public testing::TestWithParam<double> {};

TEST_P(SteadySlide, is_as_deep_and_rubs_as_much_in_every_step)
{
    constexpr double load = (kBelow + kOnTop) * 9.81;
    Dragged dragged(GetParam());
    dragged.run(120);
    const double height = dragged.height();
    for (int i = 0; i < 60; ++i) {
        dragged.run(1);
        EXPECT_NEAR(dragged.height(), height, tol(1e-5, 1e-4)) << i;
        const dWorldContact c = dragged.of_ground();
        EXPECT_NEAR(c.normal_force, load, tol(1e-3, 5e-3) * load) << i;
        EXPECT_NEAR(length(vec(c.friction_force)), GetParam() * load, tol(2e-3, 1e-2) * GetParam() * load)
            << i;
    }
}

INSTANTIATE_TEST_SUITE_P(Coefficients, SteadySlide, testing::Values(0.5, 1.01, 1.5, 2, 3, 5, 10));

}  // namespace
}  // namespace epode::physics
