// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Without constraints a step obeys M (v+ - v) / h + c = tau: inverse dynamics (robots/kinematics, another derivation) of a step's
// acceleration are the forces that acted, springs, dampers and servos at the step's end.
#include "models.h"

namespace epode::tests {
namespace {

constexpr double kH = 1e-3;

struct Joint {
    int position, velocity;
    bool is_scalar;
};

std::vector<Joint> joints_of(dRobotModelID model)
{
    std::vector<dRobotJoint> joints(size_t(dRobotModelGetJoints(model, nullptr, 0)));
    dRobotModelGetJoints(model, joints.data(), int(joints.size()));
    std::vector<Joint> out;
    int velocity = 0;
    for (const dRobotJoint& joint : joints) {
        const bool is_scalar = joint.kind == dRobotHinge || joint.kind == dRobotSlide;
        out.push_back({joint.position, velocity, is_scalar});
        velocity += is_scalar ? 1 : joint.kind == dRobotBall ? 3 : 6;
    }
    return out;
}

// Springs and dampers of the model, by joint, and what its actuators add: written down from its text.
struct Passive {
    const char* joint;
    double stiffness, rest, damping;
};

template <typename T>
void expect_equation_of_motion(const char* text, const std::vector<Passive>& passive, double tolerance)
{
    const dRobotModelID model = model_of(text);
    ASSERT_TRUE(model && !dRobotModelHasErrors(model));
    constexpr int kCopies = 40;
    Copies<T> copies(model, kCopies, dReal(kH));
    ASSERT_TRUE(copies.id);
    const int nq = copies.size(dBatchPositions), nv = copies.size(dBatchVelocities);
    const auto joints = joints_of(model);
    Dice dice(5);
    for (int i = 0; i < kCopies; ++i) {
        auto q = any_positions(model, dice), v = dice.many(nv, -2, 2), f = dice.many(nv, -1, 1);
        for (const Joint& joint : joints)
            if (!joint.is_scalar && joint.velocity + 6 <= nv && joint.position == 0)
                q[2] += 9;  // above the floor
        copies.write_one(dBatchPositions, i, {q.begin(), q.end()});
        copies.write_one(dBatchVelocities, i, {v.begin(), v.end()});
        copies.write_one(dBatchAppliedForces, i, {f.begin(), f.end()});
    }
    const auto q = copies.read(dBatchPositions), v = copies.read(dBatchVelocities),
               f = copies.read(dBatchAppliedForces);
    ASSERT_EQ(dBatchStep(copies.id, 1), 1);
    const auto next = copies.read(dBatchVelocities);
    double worst = 0, largest = 0;
    for (int i = 0; i < kCopies; ++i) {
        std::vector<dReal> qi(q.begin() + i * nq, q.begin() + (i + 1) * nq),
            vi(v.begin() + i * nv, v.begin() + (i + 1) * nv), a, out(size_t(nv), 0);
        for (int k = 0; k < nv; ++k)
            a.push_back(dReal((double(next[size_t(i * nv + k)]) - double(v[size_t(i * nv + k)])) / kH));
        ASSERT_EQ(dRobotModelGetInverseDynamics(model, qi.data(), vi.data(), a.data(), out.data(), nv), nv);
        std::vector<double> wanted(f.begin() + i * nv, f.begin() + (i + 1) * nv);
        for (const Passive& p : passive) {
            const Joint& joint = joints[size_t(dRobotModelFindJoint(model, p.joint))];
            const double w = double(next[size_t(i * nv + joint.velocity)]),
                         end = double(qi[size_t(joint.position)]) + kH * w;
            wanted[size_t(joint.velocity)] += p.stiffness * (p.rest - end) - p.damping * w;
        }
        for (int k = 0; k < nv; ++k) {
            worst = std::max(worst, std::fabs(double(out[size_t(k)]) - wanted[size_t(k)]));
            largest = std::max(largest, std::fabs(double(out[size_t(k)])));
        }
    }
    EXPECT_LT(worst, tolerance * largest);
    EXPECT_GT(largest, 1);
    dRobotModelDestroy(model);
}

const std::vector<Passive> kOfWalker = {{"a1", 0, 0, 0.3}, {"a2", 0, 0, 0.3}, {"b1", 0, 0, 0.3},
                                        {"b2", 0, 0, 0.3}, {"c1", 0, 0, 0.3}, {"c2", 0, 0, 0.3},
                                        {"d1", 0, 0, 0.3}, {"d2", 0, 0, 0.3}};
// Position and velocity servos ask for 0 here.
const std::vector<Passive> kOfMixed = {
    {"rail", 3, 0.1, 0.4}, {"u", 20, 0, 0}, {"v", 0, 0, 0.05 + 0.4}, {"t", 2, 0, 0.1}};

TEST(BatchFreeMotion, a_walkers_step_obeys_the_equation_of_motion)
{
    expect_equation_of_motion<double>(kWalker, kOfWalker, 1e-11);
}
TEST(BatchFreeMotion, so_does_one_with_every_kind_of_joint)
{
    expect_equation_of_motion<double>(kMixed, kOfMixed, 1e-11);
}
TEST(BatchFreeMotion, in_floats_too) { expect_equation_of_motion<float>(kWalker, kOfWalker, 2e-3); }

// A tree without dampers and gravity in its floating base: momentum stays, energy to first order in h.
TEST(BatchFreeMotion, energy_of_a_passive_tree_converges_with_the_step)
{
    const std::string text = R"(<mujoco><option gravity="0 0 0"/><worldbody><body pos="0 0 1"><freejoint/>
<inertial pos="0.1 0 0" mass="1" diaginertia="0.01 0.02 0.03"/><body pos="0.2 0 0"><joint axis="0 1 0"/>
<inertial pos="0.2 0 0" mass="0.5" diaginertia="0.002 0.01 0.01"/><body pos="0.4 0 0"><joint axis="0 0 1"/>
<inertial pos="0.1 0 0" mass="0.3" diaginertia="0.001 0.003 0.003"/></body></body></body></worldbody></mujoco>)";
    const dRobotModelID model = model_of(text.c_str());
    const auto energy = [&](Copies<double>& copies) {
        const auto q = reals_of(copies.read(dBatchPositions));
        const auto v = copies.read(dBatchVelocities);
        const size_t nv = v.size();
        std::vector<dReal> m(nv * nv);
        dRobotModelGetMassMatrix(model, q.data(), m.data(), int(m.size()));
        double sum = 0;
        for (size_t i = 0; i < nv; ++i)
            for (size_t k = 0; k < nv; ++k) sum += 0.5 * v[i] * double(m[i * nv + k]) * v[k];
        return sum;
    };
    double last = 0;
    for (const double h : {0.004, 0.002, 0.001}) {
        Copies<double> copies(model, 1, dReal(h));
        copies.write(dBatchVelocities, {0.1, 0.2, 0.3, 1, 2, -1, 3, -2});
        const double before = energy(copies);
        dBatchStep(copies.id, int(std::lround(1 / h)));
        const double drift = std::fabs(energy(copies) - before) / before;
        EXPECT_LT(drift, 10 * h);
        if (last > 0) { EXPECT_LT(drift, 0.7 * last); }
        last = drift;
    }
    dRobotModelDestroy(model);
}

}  // namespace
}  // namespace epode::tests
