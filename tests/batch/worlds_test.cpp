// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The same physics by two derivations: from a state at rest, with joints closed, a step of a batch (generalised coordinates, sweeps)
// and one of dWorldStep (bodies with joint constraints, active sets) have the same joint velocities, whatever touches. With velocities
// they differ to first order in h, and that difference falls with it.
#include "models.h"

#include <ode/ext.h>

#include <algorithm>

namespace epode::tests {
namespace {

constexpr dReal kBack = dReal(0.1);  // m/s, of overlaps

class BatchAndWorld : public testing::Test {
  protected:
    BatchAndWorld()
    {
        dInitODE2(0);
        model = model_of(kWalker);
    }
    ~BatchAndWorld() override
    {
        dRobotModelDestroy(model);
        dCloseODE();
    }

    struct State {
        std::vector<double> q, v, control;
    };

    // Every sphere that overlaps the floor touches it in one point midway, as in a batch.
    static void touch(void* data, dGeomID a, dGeomID b)
    {
        auto& contacts = *static_cast<std::pair<dWorldID, dJointGroupID>*>(data);
        if (dGeomGetClass(a) == dPlaneClass) std::swap(a, b);
        dContact contact{};
        if (dGeomGetClass(b) != dPlaneClass || dCollide(a, b, 1, &contact.geom, sizeof contact.geom) == 0)
            return;
        if (dGeomGetClass(a) != dSphereClass) only_feet = false;
        for (int k = 0; k < 3; ++k) contact.geom.pos[k] += contact.geom.normal[k] * contact.geom.depth / 2;
        contact.surface.mu = dReal(mu), contact.surface.mode = dContactApprox1;
        dJointAttach(dJointCreateContact(contacts.first, contacts.second, &contact),
                     dGeomGetBody(contact.geom.g1), dGeomGetBody(contact.geom.g2));
    }

    std::vector<dReal> step_of_world(const State& state, dReal h) const
    {
        const dWorldID world = dWorldCreate();
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        const dJointGroupID group = dJointGroupCreate(0);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetERP(world, dReal(0.2)), dWorldSetCFM(world, 0),
            dWorldSetContactMaxCorrectingVel(world, kBack);
        dWorldSetFrictionCone(world, 1);
        const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
        const auto q = reals_of(state.q), v = reals_of(state.v);
        dRobotSetPositions(robot, q.data(), int(q.size())),
            dRobotSetVelocities(robot, v.data(), int(v.size()));
        for (size_t i = 0; i < state.control.size(); ++i)
            dRobotSetControl(robot, int(i), dReal(state.control[i]));
        std::pair<dWorldID, dJointGroupID> contacts{world, group};
        dSpaceCollide(space, &contacts, touch);
        dWorldStep(world, h);
        std::vector<dReal> out(v.size());
        dRobotGetVelocities(robot, out.data(), int(out.size()));
        dRobotDestroy(robot), dJointGroupDestroy(group), dSpaceDestroy(space), dWorldDestroy(world);
        return out;
    }

    std::vector<double> step_of_batch(const State& state, dReal h) const
    {
        dBatchOptions options;
        dBatchOptionsInit(&options, sizeof options);
        options.doubles = 1, options.threads = 1, options.stepsize = h, options.tolerance = dReal(1e-12),
        options.max_sweeps = 20000;
        options.reach = 0, options.max_correction = kBack;
        const dBatchID batch = dBatchCreate(model, 1, &options);
        dBatchWrite(batch, dBatchPositions, 0, 1, state.q.data()),
            dBatchWrite(batch, dBatchVelocities, 0, 1, state.v.data());
        dBatchWrite(batch, dBatchControls, 0, 1, state.control.data());
        dBatchStep(batch, 1);
        std::vector<double> out(state.v.size());
        dBatchRead(batch, dBatchVelocities, 0, 1, out.data());
        double residual = 1;
        dBatchRead(batch, dBatchResidual, 0, 1, &residual);
        EXPECT_LT(residual, 1e-9);
        dBatchDestroy(batch);
        return out;
    }

    double difference(const State& state, dReal h) const
    {
        const auto one = step_of_world(state, h);
        const auto two = step_of_batch(state, h);
        double worst = 0;
        for (size_t i = 0; i < one.size(); ++i) worst = std::max(worst, std::fabs(double(one[i]) - two[i]));
        return worst;
    }

    // Upright, its feet about the floor, in it or above.
    State any(Dice& dice, double speed) const
    {
        State out{any_positions(model, dice), dice.many(14, -speed, speed), dice.many(5, -1, 1)};
        const double x = dice.between(-0.2, 0.2), y = dice.between(-0.2, 0.2);
        const double length = std::sqrt(1 + x * x + y * y);
        out.q[2] = dice.between(0.4, 0.5), out.q[3] = 1 / length, out.q[4] = x / length,
        out.q[5] = y / length, out.q[6] = 0;
        return out;
    }

    double worst_from_rest(double friction)
    {
        std::string text = kWalker;
        for (size_t at; (at = text.find("friction=\"0.7\"")) != std::string::npos;)
            text.replace(at, 14, friction > 0 ? "friction=\".70\"" : "friction=\".00\"");
        dRobotModelDestroy(model);
        model = model_of(text.c_str()), mu = friction;
        Dice dice(3);
        double worst = 0;
        for (int i = 0; i < 300; ++i) {
            const State state = any(dice, 0);
            only_feet = true;
            const double its = difference(state, dReal(1e-4));
            if (only_feet) worst = std::max(worst, its), differences.push_back(its);
        }
        EXPECT_GT(differences.size(), 250u);
        return worst;
    }

    dRobotModelID model;
    std::vector<double> differences;
    static inline double mu = 0.7;
    static inline bool only_feet = true;  // touch the floor, and nothing else
};

// Joint velocities are read where bodies have moved to: a short step, or that would be a difference of h^2 v^3.
TEST_F(BatchAndWorld, step_from_rest_alike_without_friction)
{
    EXPECT_LT(worst_from_rest(0), sizeof(dReal) == 8 ? 1e-9 : 5e-3);
}

// Both end their search for the cone's solution by tolerances of their own: dWorldStep's leaves 1e-8 m/s. Coulomb's law may have
// several solutions (one state of these 300, with a residual below 1e-9 in the batch): a hundredth may differ.
TEST_F(BatchAndWorld, step_from_rest_alike_with_friction)
{
    worst_from_rest(0.7);
    const double bound = sizeof(dReal) == 8 ? 1e-6 : 5e-3;
    EXPECT_LE(std::count_if(differences.begin(), differences.end(), [&](double x) { return !(x < bound); }),
              3);
}

TEST_F(BatchAndWorld, differ_in_motion_to_first_order)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    Dice dice(4);
    for (int i = 0; i < 5; ++i) {
        State state = any(dice, 1);
        state.q[2] += 2;  // in flight
        const double coarse = difference(state, dReal(1e-3)), fine = difference(state, dReal(5e-4));
        EXPECT_LT(coarse, 0.02);
        EXPECT_LT(fine, 0.6 * coarse);
    }
}

}  // namespace
}  // namespace epode::tests
