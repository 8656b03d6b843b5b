// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dMass through the public functions: values, messages in ODE's words, refusals that change nothing.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <functional>
#include <limits>

#include "message_recorder.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // the old names are tested too

namespace {

constexpr dReal kNan = std::numeric_limits<dReal>::quiet_NaN();
constexpr dReal kBig = std::numeric_limits<dReal>::infinity();
constexpr dReal kTolerance = 32 * std::numeric_limits<dReal>::epsilon();

void expect_diagonal(const dMass& m, double mass, double xx, double yy, double zz)
{
    EXPECT_NEAR(m.mass, mass, kTolerance * std::fabs(mass));
    const double expected[12] = {xx, 0, 0, 0, 0, yy, 0, 0, 0, 0, zz, 0};
    for (int i = 0; i < 12; ++i) EXPECT_NEAR(m.I[i], expected[i], kTolerance * (xx + yy + zz)) << i;
    for (int i = 0; i < 4; ++i) EXPECT_EQ(m.c[i], 0);
}

TEST(MassApi, shapes_have_their_closed_forms)
{
    MessageRecorder messages;
    const double pi = 3.14159265358979323846;
    dMass m;
    dMassSetSphere(&m, 3, 2);
    expect_diagonal(m, 32 * pi, 51.2 * pi, 51.2 * pi, 51.2 * pi);
    dMassSetSphereTotal(&m, 5, 2);
    expect_diagonal(m, 5, 8, 8, 8);
    dMassSetBox(&m, 2, 1, 2, 3);
    expect_diagonal(m, 12, 13, 10, 5);
    dMassSetBoxTotal(&m, 1, 1, 2, 3);
    expect_diagonal(m, 1, 13.0 / 12, 10.0 / 12, 5.0 / 12);
    dMassSetCylinder(&m, 1, 1, 2, 3);
    expect_diagonal(m, 12 * pi, 24 * pi, 21 * pi, 21 * pi);
    dMassSetCylinderTotal(&m, 2, 2, 1, 3);
    expect_diagonal(m, 2, 2, 1, 2);
    dMassSetCapsule(&m, 1, 3, 1, 2);
    expect_diagonal(m, 10.471975511965978, 12.671090369478832, 12.671090369478832, 4.8171087355043491);
    dMassSetCapsuleTotal(&m, 2, 1, 1, 3);
    expect_diagonal(m, 2, 0.93846153846153846, 3.7076923076923077, 3.7076923076923077);
    dMass same;
    dMassSetCappedCylinderTotal(&same, 2, 1, 1, 3);
    EXPECT_EQ(std::memcmp(&m, &same, sizeof m), 0);
    EXPECT_EQ(messages.take(), "");
}

TEST(MassApi, parameters_translation_rotation_and_sum)
{
    MessageRecorder messages;
    dMass m;
    dMassSetParameters(&m, 2, 0, 0, 0, 3, 4, 5, dReal(0.1), dReal(0.2), dReal(0.3));
    const dReal I[12] = {3,          dReal(0.1), dReal(0.2), 0,          dReal(0.1), 4,
                         dReal(0.3), 0,          dReal(0.2), dReal(0.3), 5,          0};
    for (int i = 0; i < 12; ++i) EXPECT_EQ(m.I[i], I[i]);
    EXPECT_EQ(dMassCheck(&m), 1);

    dMassSetBox(&m, 1, 1, 2, 3);
    dMassTranslate(&m, 1, 2, 3);
    const double moved[12] = {84.5, -12, -18, 0, -12, 65, -36, 0, -18, -36, 32.5, 0};
    for (int i = 0; i < 12; ++i) EXPECT_NEAR(m.I[i], moved[i], 100 * kTolerance);
    dMatrix3 quarter;  // about z: x to y
    dRFromAxisAndAngle(quarter, 0, 0, 1, dReal(1.5707963267948966));
    dMassRotate(&m, quarter);
    EXPECT_NEAR(m.c[0], -2, kTolerance);
    EXPECT_NEAR(m.c[1], 1, kTolerance);
    EXPECT_NEAR(m.I[0], 65, 100 * kTolerance);
    dMassAdjust(&m, 12);
    EXPECT_EQ(m.mass, 12);
    EXPECT_NEAR(m.I[0], 130, 200 * kTolerance);

    dMass sum, part;
    dMassSetZero(&sum);
    dMassSetSphereTotal(&part, 1, 1);
    dMassTranslate(&part, 3, 0, 0);
    dMassAdd(&sum, &part);
    dMassTranslate(&part, -4, 0, 0);
    dMassAdjust(&part, 3);
    dMassAdd(&sum, &part);
    EXPECT_EQ(sum.mass, 4);
    EXPECT_NEAR(sum.c[0], 0, kTolerance);
    EXPECT_NEAR(sum.I[5], 4 * 0.4 + 9 + 3, 20 * kTolerance);
    EXPECT_EQ(messages.take(), "");
}

TEST(MassApi, numbers_of_no_body_are_stored_and_commented_upon)
{
    MessageRecorder messages;
    dMass m;
    dMassSetSphere(&m, -1, 1);
    EXPECT_LT(m.mass, 0);
    EXPECT_EQ(messages.take(), "2: mass must be > 0 in dMassCheck()");
    dMassSetBoxTotal(&m, 1, 1, 0, 0);
    EXPECT_EQ(messages.take(), "2: inertia must be positive definite in dMassCheck()");
    dMassSetParameters(&m, 1, 1, 0, 0, 1, 1, 1, 0, 0, 0);
    EXPECT_EQ(messages.take(), "2: center of mass inconsistent with mass parameters in dMassCheck()");
    EXPECT_EQ(dMassCheck(&m), 0);
    EXPECT_NE(messages.take(), "");
}

TEST(MassApi, bad_arguments_are_refused_once_and_change_nothing)
{
    MessageRecorder messages;
    dMatrix3 bad_rotation = {kNan};
    const std::vector<std::pair<std::string, std::function<void(dMass*)>>> calls = {
        {"dMassSetSphere", [](dMass* m) { dMassSetSphere(m, kNan, 1); }},
        {"dMassSetSphere", [](dMass* m) { dMassSetSphere(m, 1, kBig); }},
        {"dMassSetSphereTotal", [](dMass* m) { dMassSetSphereTotal(m, 1, kNan); }},
        {"dMassSetBox", [](dMass* m) { dMassSetBox(m, 1, 1, kNan, 1); }},
        {"dMassSetBoxTotal", [](dMass* m) { dMassSetBoxTotal(m, kBig, 1, 1, 1); }},
        {"dMassSetCylinder", [](dMass* m) { dMassSetCylinder(m, 1, 3, 1, kNan); }},
        {"dMassSetCylinderTotal", [](dMass* m) { dMassSetCylinderTotal(m, 1, 3, kNan, 1); }},
        {"dMassSetCapsule", [](dMass* m) { dMassSetCapsule(m, 1, 3, 1, kNan); }},
        {"dMassSetCapsuleTotal", [](dMass* m) { dMassSetCapsuleTotal(m, 1, 3, 0, 0); }},
        {"dMassSetParameters", [](dMass* m) { dMassSetParameters(m, 1, 0, 0, kNan, 1, 1, 1, 0, 0, 0); }},
        {"dMassAdjust", [](dMass* m) { dMassAdjust(m, kNan); }},
        {"dMassTranslate", [](dMass* m) { dMassTranslate(m, 0, kBig, 0); }},
        {"dMassRotate", [&](dMass* m) { dMassRotate(m, bad_rotation); }},
        {"dMassRotate", [](dMass* m) { dMassRotate(m, nullptr); }},
        {"dMassAdd", [](dMass* m) { dMassAdd(m, nullptr); }},
    };
    for (const auto& [name, call] : calls) {
        dMass m;
        dMassSetBox(&m, 1, 1, 2, 3);
        const dMass before = m;
        call(&m);
        EXPECT_EQ(messages.take(), "2: Bad argument(s) in " + name + "()");
        EXPECT_EQ(std::memcmp(&m, &before, sizeof m), 0) << name;
        call(nullptr);
        EXPECT_EQ(messages.take(), "2: Bad argument(s) in " + name + "()") << "null";
    }
    dMass zero;
    dMassSetZero(&zero);
    dMassAdjust(&zero, 1);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dMassAdjust()") << "nothing to scale";
    EXPECT_EQ(dMassCheck(nullptr), 0);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dMassCheck()");
    dMassSetZero(nullptr);
    EXPECT_EQ(messages.take(), "2: Bad argument(s) in dMassSetZero()");
}

TEST(MassApi, directions_are_one_to_three)
{
    MessageRecorder messages;
    for (int direction : {-1, 0, 4, 1000}) {
        dMass m;
        dMassSetZero(&m);
        dMassSetCapsule(&m, 1, direction, 1, 1);
        EXPECT_EQ(messages.take(), "2: bad direction number in dMassSetCapsule()");
        dMassSetCapsuleTotal(&m, 1, direction, 1, 1);
        EXPECT_EQ(messages.take(), "2: bad direction number in dMassSetCapsuleTotal()");
        dMassSetCylinder(&m, 1, direction, 1, 1);
        EXPECT_EQ(messages.take(), "2: bad direction number in dMassSetCylinder()");
        dMassSetCylinderTotal(&m, 1, direction, 1, 1);
        EXPECT_EQ(messages.take(), "2: bad direction number in dMassSetCylinderTotal()");
        EXPECT_EQ(m.mass, 0);
    }
}

}  // namespace
