// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Derivatives of a step: closed forms of small machines; exact ones are central differences away from changes of the active set, in
// flight, standing, sliding and at limits; Jacobians are those of robots/kinematics, another derivation.
#include "golden/golden.h"
#include "models.h"

#include <cstdarg>

namespace epode::tests {
namespace {

constexpr double kDerivativeStep = 0.004;

struct Linear {
    std::vector<double> a, b;
};

template <typename T>
Linear linear_of(Copies<T>& copies, int method, int first = 0, int count = 1, dReal distance = 0)
{
    const int n = dBatchGetTangentSize(copies.id), controls = copies.size(dBatchControls);
    std::vector<T> a(size_t(count * n * n)), b(size_t(count * n * controls));
    EXPECT_EQ(dBatchLinearise(copies.id, method, distance, first, count, a.data(), b.data()), 1);
    return {{a.begin(), a.end()}, {b.begin(), b.end()}};
}

std::vector<double> over(Copies<double>& copies, int method, int parameter, dReal distance = 0)
{
    std::vector<double> out(
        size_t(dBatchGetTangentSize(copies.id) * dBatchGetParameterSize(copies.id, parameter)));
    EXPECT_EQ(dBatchLineariseParameter(copies.id, method, distance, parameter, 0, 1, out.data()), 1);
    return out;
}

double apart(const std::vector<double>& a, const std::vector<double>& b)
{
    EXPECT_EQ(a.size(), b.size());
    double worst = 0, largest = 1;
    for (size_t i = 0; i < a.size(); ++i) {
        EXPECT_TRUE(std::isfinite(a[i]) && std::isfinite(b[i]));
        worst = std::max(worst, std::fabs(a[i] - b[i])), largest = std::max(largest, std::fabs(b[i]));
    }
    return worst / largest;
}

// m v+ = m v + h (g u - k (q + h v+) - d v+), with a filter of time T before u: act+ = act + h / T (u - act).
const char* const kSlider =
    R"(<mujoco><worldbody><body><joint name="s" type="slide" axis="1 0 0" stiffness="30" damping="2"/>
<geom size="0.1" mass="1.5"/></body></worldbody><actuator><general joint="s" gear="4" dyntype="filter" dynprm="0.05"/></actuator></mujoco>)";

TEST(BatchDerivatives, of_a_slider_are_its_closed_form)
{
    const dRobotModelID model = model_of(kSlider);
    Copies<double> copies(model, 1, dReal(kDerivativeStep));
    copies.write(dBatchPositions, {0.3}), copies.write(dBatchVelocities, {-0.2}),
        copies.write(dBatchControls, {0.7});
    copies.write(dBatchActivations, {0.1});
    const double m = 1.5, k = 30, d = 2, h = kDerivativeStep, g = 4, inertia = m + h * d + h * h * k;
    const double vq = -h * k / inertia, vv = m / inertia, va = h * g / inertia;
    const std::vector<double> a = {1 + h * vq, h * vv, h * va, vq, vv, va, 0, 0, 1 - h / 0.05},
                              b = {0, 0, h / 0.05};
    const double tolerance = sizeof(dReal) == 8 ? 1e-10 : 1e-6;
    for (const int method : {dBatchDifferences, dBatchExact}) {
        const Linear its = linear_of(copies, method);
        EXPECT_LT(apart(its.a, a), tolerance);
        EXPECT_LT(apart(its.b, b), tolerance);
        const double next = (m * -0.2 + h * (g * 0.1 - k * 0.3)) / inertia;
        const double dm = (-0.2 - next) / inertia, dk = (-h * 0.3 - h * h * next) / inertia,
                     dd = -h * next / inertia;
        EXPECT_LT(apart(over(copies, method, dBatchMasses), {0, h * dm, 0, dm, 0, 0}), tolerance);
        EXPECT_LT(apart(over(copies, method, dBatchStiffnesses), {h * dk, dk, 0}), tolerance);
        EXPECT_LT(apart(over(copies, method, dBatchDampings), {h * dd, dd, 0}), tolerance);
        const double dg = h * g * 0.1 / inertia;  // of a gain of 1
        EXPECT_LT(apart(over(copies, method, dBatchGains), {h * dg, dg, 0}), tolerance);
    }
    dRobotModelDestroy(model);
}

// A free body: turns along, rates by the gyroscopic term; the angular velocity stays the link's when it is turned.
TEST(BatchDerivatives, of_a_turning_body_keep_its_own_axes)
{
    const dRobotModelID model = model_of(R"(<mujoco><option gravity="0 0 0"/><worldbody><body><freejoint/>
<inertial pos="0 0 0" mass="1" diaginertia="0.02 0.02 0.02"/></body></worldbody></mujoco>)");
    Copies<double> copies(model, 1, dReal(kDerivativeStep));
    copies.write(dBatchPositions, {1, 2, 3, 0.5, 0.5, -0.5, 0.5});
    copies.write(dBatchVelocities, {1, 0, 0, 0.3, -2, 1});
    // A ball: w stays in the world, so exp(h w) turns what the state's tangent turns: R* exp(h w)* ... = exp(-h w_link) of it.
    for (const int method : {dBatchDifferences, dBatchExact}) {
        const Linear its = linear_of(copies, method);
        const double w[3] = {0.3, -2, 1}, rate = std::sqrt(0.09 + 4 + 1), angle = kDerivativeStep * rate,
                     s = std::sin(angle), c = std::cos(angle);
        double u[3], worst = 0;
        for (int k = 0; k < 3; ++k) u[k] = w[k] / rate;
        const double cross[3][3] = {{0, -u[2], u[1]}, {u[2], 0, -u[0]}, {-u[1], u[0], 0}};
        for (int i = 0; i < 3; ++i)
            for (int k = 0; k < 3; ++k) {
                const double turned = (i == k ? c : 0) - s * cross[i][k] + (1 - c) * u[i] * u[k];
                worst = std::max(worst, std::fabs(its.a[size_t((3 + i) * 12 + 3 + k)] - turned));
            }
        EXPECT_LT(worst, sizeof(dReal) == 8 ? 1e-9 : 1e-6);
    }
    dRobotModelDestroy(model);
}

// A block that slides on the floor: v+ = v - mu g h along its motion, whatever its mass, and across it the direction turns.
TEST(BatchDerivatives, of_a_sliding_block_follow_the_cone)
{
    const dRobotModelID model = model_of(
        R"(<mujoco><option gravity="0 0 -10"/><worldbody><geom type="plane" size="9 9 1" friction="0.5"/>
<body pos="0 0 0.0999"><joint type="slide" axis="1 0 0"/><joint type="slide" axis="0 1 0"/><joint type="slide" axis="0 0 1"/>
<geom size="0.1" mass="3" friction="0.5"/></body></worldbody></mujoco>)");
    Copies<double> copies(model, 1, dReal(kDerivativeStep), 0, 1, 200, 0);  // overlaps stay
    copies.write(dBatchVelocities, {2, 0, 0});
    for (const int method : {dBatchDifferences, dBatchExact}) {
        const Linear its = linear_of(copies, method);
        const double loss = 0.5 * 10 * kDerivativeStep, tolerance = sizeof(dReal) == 8 ? 1e-7 : 1e-4;
        EXPECT_NEAR(its.a[size_t(3 * 6 + 3)], 1, tolerance);
        // Of v = (2, e) the loss has the direction of v+, which is that of v.
        EXPECT_NEAR(its.a[size_t(4 * 6 + 4)], 1 - loss / 2, tolerance);
        const auto friction = over(copies, method, dBatchFrictions),
                   mass = over(copies, method, dBatchMasses);
        EXPECT_NEAR(friction[3], -10 * kDerivativeStep, tolerance);
        EXPECT_NEAR(friction[0], -10 * kDerivativeStep * kDerivativeStep, tolerance);
        EXPECT_NEAR(mass[size_t(3 * 2 + 1)], 0, tolerance);
        EXPECT_NEAR(over(copies, method, dBatchGravity)[size_t(3 * 3 + 2)], 0.5 * kDerivativeStep, tolerance);
    }
    dRobotModelDestroy(model);
}

// Of central differences at a distance and at half of it, without their error of second order.
std::vector<double> extrapolated(std::vector<double> far, const std::vector<double>& near)
{
    for (size_t i = 0; i < far.size(); ++i) far[i] = (4 * near[i] - far[i]) / 3;
    return far;
}

void expect_exact_as_differences(const char* text, const std::vector<double>& q, const std::vector<double>& v,
                                 const std::vector<double>& controls, double tolerance)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "models and states pass through dReal";
    const dRobotModelID model = model_of(text);
    Copies<double> copies(model, 1, dReal(kDerivativeStep));
    copies.write(dBatchPositions, q), copies.write(dBatchVelocities, v),
        copies.write(dBatchControls, controls);
    const dReal far = dReal(1.0 / 131072), near = far / 2;
    const Linear one = linear_of(copies, dBatchExact),
                 other = linear_of(copies, dBatchDifferences, 0, 1, far),
                 third = linear_of(copies, dBatchDifferences, 0, 1, near);
    EXPECT_LT(apart(one.a, extrapolated(other.a, third.a)), tolerance);
    EXPECT_LT(apart(one.b, extrapolated(other.b, third.b)), tolerance);
    for (int parameter = dBatchGravity; parameter <= dBatchTerrain; ++parameter) {
        const auto differences = extrapolated(over(copies, dBatchDifferences, parameter, far),
                                              over(copies, dBatchDifferences, parameter, near));
        // Numbers that are 0 have a sixteenth of the way, and more of the solver's rounding for it.
        EXPECT_LT(apart(over(copies, dBatchExact, parameter), differences), 5 * tolerance) << parameter;
    }
    EXPECT_EQ(copies.read(dBatchPositions), q);
    dRobotModelDestroy(model);
}

std::vector<double> reference_of(const char* text)
{
    const dRobotModelID model = model_of(text);
    std::vector<dReal> q(size_t(dRobotModelGetNumPositions(model)));
    dRobotModelGetReference(model, q.data(), int(q.size()));
    dRobotModelDestroy(model);
    return {q.begin(), q.end()};
}

TEST(BatchDerivatives, that_are_exact_are_differences_in_flight)
{
    Dice dice(3);
    const dRobotModelID model = model_of(kMixed);
    auto q = any_positions(model, dice);
    dRobotModelDestroy(model);
    expect_exact_as_differences(kMixed, q, dice.many(15 - 1, -1, 1), dice.many(3, -1, 1), 1e-8);
}

// Feet 1 mm deep: standing.
TEST(BatchDerivatives, that_are_exact_are_differences_on_four_feet)
{
    auto q = reference_of(kWalker);
    q[2] = 0.509;
    Dice dice(1);
    expect_exact_as_differences(kWalker, q, std::vector<double>(14, 0), dice.many(5, -0.2, 0.2), 1e-6);
}

TEST(BatchDerivatives, that_are_exact_are_differences_where_feet_slide)
{
    auto q = reference_of(kWalker);
    q[2] = 0.509;
    std::vector<double> v(14, 0);
    v[0] = 1.5, v[1] = -0.4;
    Dice dice(2);
    expect_exact_as_differences(kWalker, q, v, dice.many(5, -0.2, 0.2), 1e-6);
}

TEST(BatchDerivatives, that_are_exact_are_differences_at_limits)
{
    auto q = reference_of(kWalker);
    q[2] = 2, q[7] = 1.201, q[10] = -1.2005;
    std::vector<double> v(14, 0);
    v[6] = 1, v[9] = -0.5, v[8] = 0.3;
    expect_exact_as_differences(kWalker, q, v, {0.5, -0.5, 0.2, 0.1, 0}, 1e-6);
}

// A box of four corners is overdetermined: its rows are of a lower rank than there are.
TEST(BatchDerivatives, that_are_exact_are_differences_of_a_box_that_lies)
{
    const char* const text =
        R"(<mujoco><worldbody><geom type="plane" size="9 9 1" friction="0.6"/><body pos="0 0 0.0995"><freejoint/>
<geom type="box" size="0.2 0.15 0.1" mass="2" friction="0.6"/><body pos="0 0 0.2"><joint name="j" axis="0 1 0" damping="0.1"/>
<geom size="0.05" pos="0 0 0.2" mass="0.5" contype="0" conaffinity="0"/></body></body></worldbody>
<actuator><motor joint="j" gear="2"/></actuator></mujoco>)";
    expect_exact_as_differences(text, reference_of(text), {0, 0, 0, 0, 0, 0, 0.1}, {0.3}, 1e-6);
}

// Dry friction that slips and one that holds, a servo at its limit, a coupling.
TEST(BatchDerivatives, that_are_exact_are_differences_of_single_rows)
{
    const char* const text =
        R"(<mujoco><compiler angle="radian"/><worldbody><body><joint name="a" axis="0 1 0" frictionloss="0.4"/>
<geom type="capsule" fromto="0 0 0 0 0 -0.4" size="0.03" mass="1"/><body pos="0 0 -0.4"><joint name="b" axis="0 1 0" frictionloss="5"/>
<geom type="capsule" fromto="0 0 0 0.3 0 0" size="0.03" mass="0.6"/><body pos="0.3 0 0"><joint name="c" axis="0 0 1"/>
<geom type="capsule" fromto="0 0 0 0.2 0 0" size="0.02" mass="0.3"/><body pos="0.2 0 0"><joint name="d" axis="1 0 0" damping="0.02"/>
<geom size="0.03" pos="0 0.05 0" mass="0.2"/></body></body></body></body></worldbody>
<equality><joint joint1="d" joint2="c" polycoef="0 0.7 0 0 0"/></equality>
<actuator><position joint="c" kp="40" forcerange="-2 2"/><position joint="a" kp="3" forcerange="-50 50"/></actuator></mujoco>)";
    expect_exact_as_differences(text, {0.4, 0.3, 0.2, 0.15}, {1.2, 0, 0.1, 0.07}, {0.9, 0.3}, 1e-6);
}

TEST(BatchDerivatives, of_controls_end_with_their_range)
{
    const dRobotModelID model = model_of(kWalker);
    Copies<double> copies(model, 3, dReal(kDerivativeStep));
    std::vector<double> q = copies.read(dBatchPositions);
    for (int i = 0; i < 3; ++i) q[size_t(i * 15 + 2)] = 3;
    copies.write(dBatchPositions, q);
    copies.write(dBatchControls, {0, 0, 0, 0, 0, 1, 1, 1, 1, 1, 1.5, 1.5, 1.5, 1.5, 1.5});
    const Linear its = linear_of(copies, dBatchDifferences, 0, 3);
    const size_t size = 28 * 5;
    double largest = 0;
    for (size_t i = 0; i < size; ++i) {
        EXPECT_NEAR(its.b[i], its.b[size + i], 1e-6);
        EXPECT_EQ(its.b[2 * size + i], 0);
        largest = std::max(largest, its.b[i]);
    }
    EXPECT_GT(largest, 0.1);
    dRobotModelDestroy(model);
}

template <typename T>
std::uint64_t hash_of_derivatives(int threads, int lead)
{
    const dRobotModelID model = model_of(kWalker);
    constexpr int kCopies = 9;
    Copies<T> copies(model, lead + kCopies, dReal(kDerivativeStep), 0, threads);
    for (int i = 0; i < kCopies; ++i) {
        Dice dice(unsigned(40 + i));
        auto q = any_positions(model, dice), v = dice.many(14, -1, 1), c = dice.many(5, -1, 1);
        q[2] = 0.45;
        copies.write_one(dBatchPositions, lead + i, {q.begin(), q.end()});
        copies.write_one(dBatchVelocities, lead + i, {v.begin(), v.end()});
        copies.write_one(dBatchControls, lead + i, {c.begin(), c.end()});
    }
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const int method : {dBatchDifferences, dBatchExact}) {
        const Linear its = linear_of(copies, method, lead, kCopies);
        for (const double x : its.a) hash = hashed(hash, T(x));
        for (const double x : its.b) hash = hashed(hash, T(x));
    }
    dRobotModelDestroy(model);
    return hash;
}

TEST(BatchDerivatives, have_bits_that_depend_neither_on_threads_nor_on_places)
{
    EXPECT_EQ(hash_of_derivatives<double>(1, 0), hash_of_derivatives<double>(3, 5));
    EXPECT_EQ(hash_of_derivatives<float>(1, 0), hash_of_derivatives<float>(3, 5));
}

TEST(BatchDerivatives, are_golden)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "step sizes and states pass through dReal";
    EXPECT_TRUE(golden::is_golden("batch/derivatives/double", hash_of_derivatives<double>(1, 0)));
    EXPECT_TRUE(golden::is_golden("batch/derivatives/float", hash_of_derivatives<float>(1, 0)));
}

// With numbers of its own a copy has the derivatives of the model that has them.
TEST(BatchDerivatives, are_of_each_copys_own_numbers)
{
    const dRobotModelID model = model_of(kSlider);
    Copies<double> copies(model, 3, dReal(kDerivativeStep));
    const double mass[2] = {0, 6};
    EXPECT_EQ(dBatchWriteParameter(copies.id, dBatchMasses, 1, 1, mass), 1);
    const Linear its = linear_of(copies, dBatchExact, 0, 3);
    EXPECT_NEAR(its.a[4], 1.5 / (1.5 + 2 * kDerivativeStep + 30 * kDerivativeStep * kDerivativeStep), 1e-6);
    EXPECT_NEAR(its.a[9 + 4], 6 / (6 + 2 * kDerivativeStep + 30 * kDerivativeStep * kDerivativeStep), 1e-6);
    EXPECT_EQ(its.a[4], its.a[18 + 4]);
    dRobotModelDestroy(model);
}

TEST(BatchDerivatives, of_bad_copies_are_no_numbers)
{
    const dRobotModelID model = model_of(kWalker);
    Copies<float> copies(model, 2, dReal(kDerivativeStep));
    copies.write_one(dBatchVelocities, 1, std::vector<float>(14, 9e14f));
    dBatchStep(copies.id, 50);
    ASSERT_EQ(dBatchCountBad(copies.id), 1);
    for (const int method : {dBatchDifferences, dBatchExact}) {
        const Linear its = linear_of(copies, method, 0, 2);
        EXPECT_TRUE(std::isfinite(its.a[0]) && std::isnan(its.a[28 * 28]) && std::isnan(its.b[28 * 5]));
    }
    dRobotModelDestroy(model);
}

TEST(BatchDerivatives, refuse_what_cannot_be)
{
    const dRobotModelID model = model_of(kWalker);
    Copies<double> copies(model, 2, dReal(kDerivativeStep));
    std::vector<double> a(2 * 28 * 28, 7), b(2 * 28 * 5, 7);
    const dReal far[3] = {0, dReal(1e12), 0};
    dSetMessageHandler([](int, const char*, va_list) {});
    EXPECT_EQ(dBatchLinearise(copies.id, 2, 0, 0, 2, a.data(), b.data()), 0);
    EXPECT_EQ(dBatchLinearise(copies.id, dBatchExact, -1, 0, 2, a.data(), b.data()), 0);
    EXPECT_EQ(dBatchLinearise(copies.id, dBatchExact, 2, 0, 2, a.data(), b.data()), 0);
    EXPECT_EQ(dBatchLinearise(copies.id, dBatchExact, 0, 1, 2, a.data(), b.data()), 0);
    EXPECT_EQ(dBatchLinearise(copies.id, dBatchExact, 0, 0, 2, a.data(), nullptr), 0);
    EXPECT_EQ(dBatchLineariseParameter(copies.id, dBatchExact, 0, dBatchRollingFrictions + 1, 0, 1, a.data()),
              0);
    EXPECT_EQ(dBatchJacobian(copies.id, 10, nullptr, 0, 1, a.data()), 0);
    EXPECT_EQ(dBatchJacobian(copies.id, -1, nullptr, 0, 1, a.data()), 0);
    EXPECT_EQ(dBatchJacobian(copies.id, 1, far, 0, 1, a.data()), 0);
    EXPECT_EQ(dBatchGetTangentSize(nullptr), 0);
    const dRobotModelID rolling = model_of(
        R"(<mujoco><worldbody><geom type="plane" size="9 9 1"/><body pos="0 0 .1"><freejoint/><geom size=".1" mass="1" condim="6"/></body></worldbody></mujoco>)");
    Copies<double> balls(rolling, 1, dReal(kDerivativeStep));
    EXPECT_EQ(dBatchLinearise(balls.id, dBatchExact, 0, 0, 1, a.data(), nullptr), 0);
    dSetMessageHandler(nullptr);
    for (const double x : a) EXPECT_EQ(x, 7);
    EXPECT_EQ(dBatchLinearise(balls.id, dBatchDifferences, 0, 0, 1, a.data(), nullptr), 1);
    EXPECT_NE(a[0], 7);
    dRobotModelDestroy(model), dRobotModelDestroy(rolling);
}

template <typename T>
void expect_jacobians(const char* text, double tolerance)
{
    const dRobotModelID model = model_of(text);
    constexpr int kCopies = 11;
    Copies<T> copies(model, kCopies, dReal(kDerivativeStep));
    Dice dice(8);
    for (int i = 0; i < kCopies; ++i) {
        const auto q = any_positions(model, dice);
        copies.write_one(dBatchPositions, i, {q.begin(), q.end()});
    }
    const int nq = copies.size(dBatchPositions), nv = copies.size(dBatchVelocities),
              links = copies.size(dBatchLinkPositions) / 3;
    const auto q = copies.read(dBatchPositions);
    const dReal point[3] = {dReal(0.1), dReal(-0.2), dReal(0.3)};
    for (int link = 0; link < links; ++link) {
        std::vector<T> ours(size_t(kCopies * 6 * nv));
        ASSERT_EQ(dBatchJacobian(copies.id, link, point, 0, kCopies, ours.data()), 1);
        for (int i = 0; i < kCopies; ++i) {
            const std::vector<dReal> at(q.begin() + i * nq, q.begin() + (i + 1) * nq);
            std::vector<dReal> wanted(size_t(6 * nv));
            ASSERT_EQ(dRobotModelGetJacobian(model, at.data(), link, point, wanted.data(), 6 * nv), 6 * nv);
            for (int k = 0; k < 6 * nv; ++k)
                ASSERT_NEAR(double(ours[size_t(i * 6 * nv + k)]), double(wanted[size_t(k)]), tolerance)
                    << link << " " << k;
        }
    }
    dRobotModelDestroy(model);
}

TEST(BatchJacobians, are_those_of_the_model)
{
    const double tolerance = sizeof(dReal) == 8 ? 1e-13 : 1e-5;
    expect_jacobians<double>(kWalker, tolerance), expect_jacobians<double>(kMixed, tolerance);
    expect_jacobians<float>(kMixed, 3e-6);
}

}  // namespace
}  // namespace epode::tests
