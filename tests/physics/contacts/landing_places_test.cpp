// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where two touch that were apart when the step began: friction has the arm of the place where they meet, whatever the
// floor is, and events name it.
#include "../mesh_floors.h"
#include "../world_contacts.h"

namespace epode::physics {
namespace {

constexpr Floor kFloors[] = {Floor::kPlane, Floor::kBox,       Floor::kMesh,
                             Floor::kRidge, Floor::kTwoMeshes, Floor::kField};

dBodyID rough_ball(Sim& sim, V3 at, double radius)
{
    const dBodyID ball = sim.sphere(at, radius, 1);
    set_material(geom_of(ball), 10);
    return ball;
}

// A ball that lands at 2.4 m/s and does not slip rolls with 5/7 of its speed. (On a box it kept 0.32 of it at 5 cm, and
// nothing at 2 cm: the place was on the box when the ball had sunk in by a whole step, so over the ball's middle.)
TEST(LandingPlaces, make_a_ball_roll)
{
    for (const Stepper stepper : kSteppers)
        for (const Floor floor : kFloors)
            for (const double h : {1.0 / 60, 1.0 / 240, 1e-3})
                for (const double radius : {0.05, 0.3}) {
                    SCOPED_TRACE(testing::Message() << name_of(stepper) << ", " << name_of(floor) << ", h "
                                                    << h << ", r " << radius);
                    WorldContactsSim sim(stepper);
                    const FlatGround ground(sim, floor, 20, 1);
                    const dBodyID ball = rough_ball(sim, {0.5, -0.37, radius + 0.3}, radius);
                    velocity(ball, {2, 0, 0});
                    for (int i = 0; i < int(0.5 / h); ++i) sim.advance(h);
                    EXPECT_NEAR(velocity(ball).x, 10.0 / 7, 0.01);
                    EXPECT_NEAR(spin(ball).y * radius, 10.0 / 7, 0.01);
                }
}

// The event that says that they touch says where: on the floor. (It was 14 to 41 mm above.)
TEST(LandingPlaces, are_those_of_events)
{
    for (const Stepper stepper : kSteppers)
        for (const Floor floor : kFloors)
            for (const bool box : {false, true}) {
                SCOPED_TRACE(testing::Message()
                             << name_of(stepper) << ", " << name_of(floor) << ", box " << box);
                WorldContactsSim sim(stepper);
                const FlatGround ground(sim, floor, 20, 1);
                dEventSettings settings;
                dEventSettingsInit(&settings, sizeof settings);
                ASSERT_EQ(dWorldSetEventSettings(sim.world, &settings), 1);
                const dBodyID body = box ? sim.box({0.5, -0.37, 0.6}, {0.6, 0.6, 0.6}, 1)
                                         : sim.sphere({0.5, -0.37, 0.6}, 0.3, 1);
                velocity(body, {2, 0, 0});
                dEvent event{};
                for (int i = 0; i < 60 && dWorldGetEvents(sim.world, &event, 1) == 0; ++i) sim.advance(kH);
                ASSERT_EQ(event.kind, dEventContactBegin);
                EXPECT_GT(event.impulse, 0.5);
                // A floor that brakes the box tilts it by 0.3 degrees within the step.
                EXPECT_NEAR(double(event.pos[2]), 0, box ? 3e-3 : 2e-3);
                EXPECT_NEAR(double(event.pos[0]), position(body).x, box ? 0.3 : 2e-3);
            }
}

}  // namespace
}  // namespace epode::physics
