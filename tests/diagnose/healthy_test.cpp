// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Scenes that are well: nothing above a note. Diagnosing them moves no bit.
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <algorithm>
#include <cstring>

#include "scenes/scene.h"

namespace {

using namespace epode::scenes;

class Healthy : public testing::TestWithParam<const Recipe*> {};

void step(Scene& scene, Stepper stepper)
{
    const double dt = scene.recipe().dt;
    const int steps = std::min(int(scene.recipe().seconds / dt), 200);
    for (int i = 0; i < steps; ++i) ASSERT_TRUE(scene.step(stepper, dt));
}

void expect_no_accusation(Scene& scene)
{
    dDiagnosis all[64];
    const int count = dWorldDiagnose(scene.world(), all, 64);
    for (int i = 0; i < count; ++i) {
        char text[512];
        dDiagnosisText(&all[i], text, sizeof text);
        EXPECT_LE(all[i].severity, dSeverityNote) << text;
    }
}

TEST_P(Healthy, in_odes_way)
{
    Runtime runtime;
    Scene scene(*GetParam());
    dWorldSetDiagnosisMode(scene.world(), 1);
    step(scene, GetParam()->stepper);
    expect_no_accusation(scene);
}

TEST_P(Healthy, as_recommended_with_the_same_bits)
{
    Runtime runtime;
    std::vector<dReal> positions[2];
    for (int diagnosed = 0; diagnosed < 2; ++diagnosed) {
        Scene scene(*GetParam());
        std::string problem;
        const Setting setting = recommended(*GetParam());
        if (setting.world_contacts) scene.manage_contacts(problem);
        dWorldSetDiagnosisMode(scene.world(), diagnosed);
        step(scene, setting.stepper);
        if (diagnosed) expect_no_accusation(scene);
        for (dBodyID body : scene.bodies())
            positions[diagnosed].insert(positions[diagnosed].end(), dBodyGetPosition(body),
                                        dBodyGetPosition(body) + 3);
    }
    EXPECT_EQ(positions[0], positions[1]);
}

std::string test_name(const testing::TestParamInfo<const Recipe*>& scene)
{
    std::string name = scene.param->name;
    std::replace(name.begin(), name.end(), '-', '_');
    return name;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Healthy, testing::ValuesIn(all_recipes()), test_name);

}  // namespace
