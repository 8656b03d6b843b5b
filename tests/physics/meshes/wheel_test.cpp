// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A cylinder as a wheel, on every ground that is the plane z = 0: it rolls ten metres and keeps its line; set
// down with a spin w it slides until it rolls at w r/3 (a disc: I = m r^2/2, its angular momentum about the
// contact line is kept); tilted on its edge by less than atan(b / 2r) it falls back onto its rim, by more it
// topples (b: its width), the centre of mass above the edge being the border.
#include <memory>

#include "mesh_floors.h"

namespace epode::physics {
namespace {

constexpr double kRadius = 0.3, kStep = 0.005;

struct Track {
    Sim sim;
    std::unique_ptr<FlatGround> ground;

    Track(Stepper stepper, Floor floor) : sim(stepper)
    {
        sim.gravity(0, 0, -9.81);
        sim.surface.mode = dContactApprox1;
        sim.surface.mu = 1;
        if (stepper != Stepper::kExact) dWorldSetContactSurfaceLayer(sim.world, real(1e-4));
        ground = std::make_unique<FlatGround>(sim, floor, 60, 0.41);
    }
    // Upright, to roll along x, tilted from the vertical about x.
    dBodyID wheel(double width, double tilt = 0)
    {
        const double up = kRadius * std::cos(tilt) + width / 2 * std::sin(tilt);
        const dBodyID body = sim.cylinder({-5.013, 0.017, up}, kRadius, width, 1);
        dMatrix3 R;
        dRFromAxisAndAngle(R, 1, 0, 0, real(kPi / 2 + tilt));
        dBodySetRotation(body, R);
        return body;
    }
};

struct Wheel : testing::TestWithParam<std::tuple<Stepper, Floor>> {
    Track track{std::get<0>(GetParam()), std::get<1>(GetParam())};
    bool exact = std::get<0>(GetParam()) == Stepper::kExact;
};

TEST_P(Wheel, keeps_its_line_for_ten_metres)
{
    const double speed = 2;
    const dBodyID body = track.wheel(0.5);
    velocity(body, {speed, 0, 0}, {0, speed / kRadius, 0});
    const V3 from = position(body);
    double off = 0, hop = 0, turned = 0;
    for (int i = 0; i < int(std::lround(10 / speed / kStep)); ++i) {
        track.sim.step(kStep);
        const V3 at = position(body);
        off = std::max(off, std::fabs(at.y - from.y)), hop = std::max(hop, std::fabs(at.z - from.z));
        const dReal* R = dBodyGetRotation(body);
        turned = std::max(turned, std::fabs(double(R[2])));
    }
    EXPECT_NEAR(position(body).x - from.x, 10, exact ? 1e-3 : 2e-2);
    EXPECT_LT(off, 1e-3);
    EXPECT_LT(hop, 1e-3);
    EXPECT_LT(turned, 1e-3) << "the axle stays across";
    RecordProperty("off", std::to_string(off));
}

TEST_P(Wheel, set_down_with_a_spin_comes_to_roll_at_a_third_of_it)
{
    const double spin_rate = 9;
    const dBodyID body = track.wheel(0.5);
    velocity(body, {}, {0, spin_rate, 0});
    track.sim.steps(int(1.5 / kStep), kStep);
    const double rolls = spin_rate * kRadius / 3;
    EXPECT_NEAR(velocity(body).x, rolls, 0.01 * rolls);
    EXPECT_NEAR(spin(body).y * kRadius, rolls, 0.01 * rolls);
}

TEST_P(Wheel, stands_until_its_weight_is_beyond_its_edge)
{
    const double width = 0.12, border = std::atan(width / 2 / kRadius);
    for (const double share : {0.9, 1.1}) {
        Track again(std::get<0>(GetParam()), std::get<1>(GetParam()));
        const dBodyID body = again.wheel(width, share * border);
        again.sim.steps(int(4 / kStep), kStep);
        const double height = share < 1 ? kRadius : width / 2;
        EXPECT_NEAR(position(body).z, height, 2e-3) << share;
    }
}

std::string wheel_name(const testing::TestParamInfo<std::tuple<Stepper, Floor>>& info)
{
    std::string name =
        std::string(name_of(std::get<0>(info.param))) + "_on_" + name_of(std::get<1>(info.param));
    for (char& c : name) c = c == ' ' ? '_' : c;
    return name;
}

INSTANTIATE_TEST_SUITE_P(Grounds, Wheel,
                         testing::Combine(testing::Values(Stepper::kExact, Stepper::kQuick),
                                          testing::Values(Floor::kPlane, Floor::kBox, Floor::kMesh,
                                                          Floor::kTwoMeshes, Floor::kField)),
                         wheel_name);

}  // namespace
}  // namespace epode::physics
