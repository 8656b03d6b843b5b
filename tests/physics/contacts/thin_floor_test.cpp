// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Dice of 16 mm fall at 2 m/s on a board of 20 mm, in steps of 1/60 s: they end a step nearer to its far side, and met the near one on
// their way. (25 of 27 fell through.)
#include "world_contacts.h"

namespace epode::physics {
namespace {

class ThinFloor : public testing::TestWithParam<Stepper> {};

TEST_P(ThinFloor, holds_dice)
{
    WorldContactsSim sim(GetParam());
    dWorldSetContactSurfaceLayer(sim.world, 0);
    const dGeomID board = dCreateBox(sim.space, 2, 2, real(0.02));
    dGeomSetPosition(board, 0, 0, real(-0.01));
    set_material(board, 0.4, 0.3);
    Random random(9);
    for (int i = 0; i < 27; ++i) {
        const V3 at{(i % 3 - 1) * 0.05, (i / 3 % 3 - 1) * 0.05, 0.1 + 0.03 * (i / 9)};
        const dBodyID die = sim.box(at, {0.016, 0.016, 0.016}, 0.008);
        set_material(geom_of(die), 0.4, 0.3);
        dQuaternion q;
        random.quaternion(q);
        dBodySetQuaternion(die, q);
        velocity(die, {random.uniform(-0.5, 0.5), random.uniform(-0.5, 0.5), -1}, random.point(20));
    }
    sim.run(120);
    for (const dBodyID die : sim.bodies) EXPECT_GT(position(die).z, 0.007);
}

INSTANTIATE_TEST_SUITE_P(Steppers, ThinFloor, testing::ValuesIn(kSteppers), case_name);

}  // namespace
}  // namespace epode::physics
