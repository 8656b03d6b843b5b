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
