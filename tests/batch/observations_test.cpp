// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Observations of copies: laws that they keep, and that they cost a step nothing.
#include <algorithm>

#include "models.h"

namespace epode::tests {
namespace {

double seen(const Copies<double>& copies, int quantity, int copy, int number)
{
    return copies.read(quantity, copy, 1)[size_t(number)];
}

TEST(BatchObservations, links_of_a_standing_robot_carry_its_weight)
{
    dRobotModelID model = model_of(kWalker);
    Copies<double> copies(model, 3, 0.002, 1e-10);
    dBatchStep(copies.id, 2000);
    const std::vector<double> forces = copies.read(dBatchLinkForces, 1, 1),
                              along = copies.read(dBatchVelocityConstraintForces, 1, 1);
    double up = 0, mass = 0;
    for (size_t i = 0; i < forces.size(); i += 6) up += forces[i + 5];
    const std::vector<double> inertias = copies.read(dBatchLinkInertias, 1, 1);
    for (size_t i = 0; i < inertias.size(); i += 10) mass += inertias[i + 9];
    EXPECT_NEAR(mass, 7.2, 1e-12);
    EXPECT_NEAR(up, mass * 9.81, 1e-3 * mass * 9.81);
    EXPECT_NEAR(along[2], up, 1e-9 * up);
    dRobotModelDestroy(model);
}

// C moves as the momentum says: sum m (v + w x d) = m d/dt C.
TEST(BatchObservations, velocities_and_inertias_agree_with_how_the_centre_moves)
{
    dRobotModelID model = model_of(kMixed);
    const double h = 1e-6;
    Copies<double> copies(model, 1, h, 1e-10);
    std::vector<double> v = copies.read(dBatchVelocities);
    for (size_t i = 0; i < v.size(); ++i) v[i] = 0.3 + 0.1 * double(i);
    copies.write(dBatchVelocities, v);
    dBatchStep(copies.id, 1);
    const std::vector<double> before = copies.read(dBatchCentreOfMass),
                              inertias = copies.read(dBatchLinkInertias),
                              velocities = copies.read(dBatchLinkVelocities);
    dBatchStep(copies.id, 1);
    const std::vector<double> after = copies.read(dBatchCentreOfMass);
    double p[3] = {0, 0, 0}, mass = 0;
    for (size_t i = 0; i < inertias.size() / 10; ++i) {
        const double *w = &velocities[6 * i], *u = w + 3, *md = &inertias[10 * i + 6],
                     m = inertias[10 * i + 9];
        mass += m;
        for (int k = 0; k < 3; ++k)
            p[k] += m * u[k] + w[(k + 1) % 3] * md[(k + 2) % 3] - w[(k + 2) % 3] * md[(k + 1) % 3];
    }
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(p[k] / mass, (after[size_t(k)] - before[size_t(k)]) / h, 1e-4);
    dRobotModelDestroy(model);
}

TEST(BatchObservations, bound_ones_follow_steps_and_resets_and_leave_the_bits)
{
    dRobotModelID model = model_of(kWalker);
    Copies<double> copies(model, 5, 0.004), plain(model, 5, 0.004);
    std::vector<double> places(size_t(5 * copies.size(dBatchLinkPositions))),
        forces(size_t(5 * copies.size(dBatchLinkForces)));
    dBatchBind(copies.id, dBatchLinkPositions, places.data());
    dBatchBind(copies.id, dBatchLinkForces, forces.data());
    for (int i = 0; i < 60; ++i) {
        dBatchStep(copies.id, 3), dBatchStep(plain.id, 3);
        ASSERT_EQ(places, copies.read(dBatchLinkPositions));
        ASSERT_EQ(forces, copies.read(dBatchLinkForces));
    }
    EXPECT_EQ(copies.read(dBatchPositions), plain.read(dBatchPositions));
    EXPECT_NE(*std::max_element(forces.begin(), forces.end()), 0);
    dBatchReset(copies.id, nullptr);
    EXPECT_EQ(*std::max_element(forces.begin(), forces.end()), 0);
    EXPECT_EQ(places[5], 0.55);
    EXPECT_EQ(seen(copies, dBatchLinkQuaternions, 4, 0), 1);
    dRobotModelDestroy(model);
}

// A cube that falls askew onto what lies below it: pairs whose points the library finds.
std::string cube_over(const char* lower)
{
    return std::string(
               "<mujoco><asset><mesh name='slab' vertex='-1 -1 -.1 1 -1 -.1 -1 1 -.1 1 1 -.1 -1 -1 .1 1 -1 "
               ".1 -1 1 .1 1 1 .1'/>"
               "<hfield name='hills' nrow='3' ncol='3' size='2 2 .2 .5' elevation='0 .2 0 .2 1 .2 0 .2 "
               "0'/></asset>"
               "<worldbody><geom pos='0 0 -.1' ") +
           lower +
           "/><body pos='0 0 .5'><freejoint/><geom type='box' size='.1 .1 .1' "
           "mass='1'/></body></worldbody></mujoco>";
}

struct Moving {
    double v[3], w[3];  // in the world's axes
};

Moving moving(const Copies<double>& copies)
{
    const auto its = copies.read(dBatchLinkVelocities);
    Moving out;
    std::copy_n(&its[6], 3, out.w), std::copy_n(&its[9], 3, out.v);
    return out;
}

TEST(BatchObservations, forces_of_asked_pairs_are_what_changed_the_velocities)
{
    dInitODE2(0);
    for (const char* lower :
         {"type='box' size='1 1 .1'", "type='mesh' mesh='slab'", "type='hfield' hfield='hills'"}) {
        const dRobotModelID model = model_of(cube_over(lower).c_str());
        const double h = 0.004, inertia = 0.04 / 6;
        Copies<double> copies(model, 1, h, 1e-12, 1, 5000);
        copies.write(dBatchPositions, {0, 0, 0.5, 0.9, 0.3, 0.2, 0.1});
        copies.write(dBatchVelocities, {0.3, 0.1, -3, 1, 2, -1});
        int touching = 0;
        for (int i = 0; i < 400; ++i) {
            const Moving was = moving(copies);
            dBatchStep(copies.id, 1);
            const Moving now = moving(copies);
            const auto forces = copies.read(dBatchLinkForces);
            const double bound = 1e-9 * (1 + std::fabs(forces[11]));
            for (int k = 0; k < 3; ++k) {
                ASSERT_NEAR(forces[size_t(9 + k)], (now.v[k] - was.v[k]) / h + (k == 2 ? 9.81 : 0), bound)
                    << lower << i;
                ASSERT_NEAR(forces[size_t(6 + k)], inertia * (now.w[k] - was.w[k]) / h, bound) << lower << i;
            }
            touching += forces[11] != 0;
        }
        EXPECT_GT(touching, 100) << lower;
        EXPECT_LT(touching, 400) << lower;
        dRobotModelDestroy(model);
    }
    dCloseODE();
}

// They are the last step's, whatever is written afterwards: where it was near depends on how fast that step began.
TEST(BatchObservations, of_a_step_stay_when_velocities_are_written)
{
    dInitODE2(0);
    const dRobotModelID model = model_of(cube_over("type='box' size='1 1 .1'").c_str());
    Copies<double> copies(model, 1, 0.004, 1e-12, 1, 5000);
    copies.write(dBatchPositions, {0, 0, 0.115, 1, 0, 0, 0});
    copies.write(dBatchVelocities, {0, 0, -5, 0, 0, 0});
    dBatchStep(copies.id, 1);
    const auto forces = copies.read(dBatchLinkForces), along = copies.read(dBatchVelocityConstraintForces);
    EXPECT_NEAR(forces[11], (5 - 0.015 / 0.004) / 0.004 + 9.81, 1e-6);
    copies.write(dBatchVelocities, std::vector<double>(6, 0));
    EXPECT_EQ(copies.read(dBatchLinkForces), forces);
    EXPECT_EQ(copies.read(dBatchVelocityConstraintForces), along);
    dRobotModelDestroy(model);
    dCloseODE();
}

TEST(BatchObservations, cannot_be_written)
{
    dRobotModelID model = model_of(kWalker);
    Copies<double> copies(model, 1, 0.004);
    std::vector<double> places = copies.read(dBatchLinkPositions);
    EXPECT_EQ(dBatchWrite(copies.id, dBatchLinkPositions, 0, 1, places.data()), 0);
    EXPECT_EQ(dBatchGetSize(copies.id, dBatchVelocityConstraintForces + 1), 0);
    dRobotModelDestroy(model);
}

}  // namespace
}  // namespace epode::tests
