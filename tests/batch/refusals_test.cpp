// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is refused changes nothing and names what is wanted; what goes bad stays alone.
#include "models.h"

#include <cstdarg>
#include <limits>

namespace epode::tests {
namespace {

std::string g_said;
void note(int, const char* format, va_list arguments)
{
    char text[500];
    std::vsnprintf(text, sizeof text, format, arguments);
    g_said = text;
}

class BatchRefusals : public testing::Test {
  protected:
    BatchRefusals() { dSetMessageHandler(note); }
    ~BatchRefusals() override { dSetMessageHandler(nullptr); }
    void expect_refused(const char* text, const char* named)
    {
        const dRobotModelID model = model_of(text);
        g_said.clear();
        EXPECT_EQ(dBatchCreate(model, 1, nullptr), nullptr);
        EXPECT_NE(g_said.find(named), std::string::npos) << g_said;
        dRobotModelDestroy(model);
    }
};

TEST_F(BatchRefusals, name_the_element_that_a_batch_does_not_have)
{
    expect_refused(
        "<mujoco><worldbody><site name='s'/><body><joint name='j'/><geom size='.1'/><site name='t' pos='1 0 "
        "0'/></body></worldbody>"
        "<tendon><spatial name='rope' stiffness='1'><site site='s'/><site "
        "site='t'/></spatial></tendon></mujoco>",
        "'rope'");
    expect_refused(
        "<mujoco><worldbody><body><joint name='j'/><geom size='.1'/></body></worldbody>"
        "<tendon><fixed name='none'><joint joint='j' coef='0'/></fixed></tendon></mujoco>",
        "'none'");
    expect_refused("<mujoco><worldbody><geom size='.1'/></worldbody></mujoco>", "nothing");
    const std::string slide =
        "<mujoco><worldbody><site name='s'/><body name='b'><joint name='j'/><geom size='.1'/><site "
        "name='t' pos='1 0 0'/></body></worldbody>";
    for (const char* actuator :
         {"<motor name='thruster' site='t'/>", "<adhesion name='thruster' body='b' ctrlrange='0 1'/>",
          "<motor name='thruster' cranksite='t' slidersite='s' cranklength='2'/>"})
        expect_refused((slide + "<actuator>" + actuator + "</actuator></mujoco>").c_str(), "'thruster'");
    expect_refused((slide + "<tendon><spatial name='rope'><site site='s'/><site site='t'/></spatial></tendon>"
                            "<equality><tendon name='tie' tendon1='rope'/></equality></mujoco>")
                       .c_str(),
                   "'tie'");
    for (const char* words : {"frictionloss='1'", "armature='1'"})
        expect_refused((slide + "<tendon><fixed name='drum' " + words +
                        "><joint joint='j' coef='1'/></fixed></tendon></mujoco>")
                           .c_str(),
                       "'drum'");
}

TEST_F(BatchRefusals, leave_everything_as_it_was)
{
    const dRobotModelID model = model_of(kWalker);
    EXPECT_EQ(dBatchCreate(model, 0, nullptr), nullptr);
    EXPECT_EQ(dBatchCreate(nullptr, 1, nullptr), nullptr);
    Copies<double> copies(model, 2, dReal(0.004));
    const auto before = copies.read(dBatchPositions);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<double> q(before), c(10, 0);
    q[16] = nan, c[9] = nan;
    EXPECT_EQ(dBatchWrite(copies.id, dBatchPositions, 0, 2, q.data()), 0);
    EXPECT_EQ(dBatchWrite(copies.id, dBatchControls, 0, 2, c.data()), 0);
    EXPECT_EQ(dBatchWrite(copies.id, dBatchPositions, 1, 2, before.data()), 0);
    EXPECT_EQ(dBatchWrite(copies.id, dBatchBad, 0, 2, before.data()), 0);
    q = before, q[3] = q[4] = q[5] = q[6] = 0;
    EXPECT_EQ(dBatchWrite(copies.id, dBatchPositions, 0, 2, q.data()), 0);
    EXPECT_EQ(dBatchRead(copies.id, 99, 0, 1, q.data()), 0);
    EXPECT_EQ(dBatchStep(copies.id, -1), 0);
    EXPECT_EQ(dBatchBind(copies.id, dBatchControls, c.data()), 1);
    c[3] = nan;
    EXPECT_EQ(dBatchStep(copies.id, 1), 0);
    EXPECT_EQ(copies.read(dBatchPositions), before);
    dRobotModelDestroy(model);
}

TEST_F(BatchRefusals, copies_that_go_bad_are_flagged_and_stay_alone)
{
    const dRobotModelID model = model_of(kWalker);
    Copies<float> copies(model, 9, dReal(0.004)), good(model, 9, dReal(0.004));
    std::vector<float> wild(14, 0);
    for (float& x : wild) x = 9e14f;
    copies.write_one(dBatchVelocities, 4, wild);
    dBatchStep(copies.id, 50), dBatchStep(good.id, 50);
    EXPECT_EQ(dBatchCountBad(copies.id), 1);
    EXPECT_EQ(copies.read(dBatchBad), (std::vector<float>{0, 0, 0, 0, 1, 0, 0, 0, 0}));
    EXPECT_EQ(copies.read(dBatchPositions, 3, 1), good.read(dBatchPositions, 3, 1));
    for (const float x : copies.read(dBatchPositions)) EXPECT_TRUE(std::isfinite(x));
    const unsigned char mask[9] = {0, 0, 0, 0, 1, 0, 0, 0, 0};
    EXPECT_EQ(dBatchReset(copies.id, mask), 1);
    EXPECT_EQ(dBatchCountBad(copies.id), 0);
    dBatchStep(copies.id, 50);
    EXPECT_EQ(copies.read(dBatchPositions, 4, 1), good.read(dBatchPositions, 4, 1));
    dRobotModelDestroy(model);
}

// Faster than its turns can be told: the copy is bad, and what is read of it is its last state.
TEST_F(BatchRefusals, what_turns_too_fast_keeps_its_last_state)
{
    const dRobotModelID model = model_of(
        R"(<mujoco><worldbody><body><freejoint/><geom size=".1" contype="0" conaffinity="0"/></body></worldbody></mujoco>)");
    Copies<float> copies(model, 14, dReal(0.01));
    for (int i = 0; i < 14; ++i)
        copies.write_one(dBatchVelocities, i, {0, 0, 0, std::pow(10.0f, float(i + 1)), 2, 3});
    dBatchStep(copies.id, 20);
    for (const dBatchQuantity quantity : {dBatchPositions, dBatchVelocities, dBatchLinkPositions})
        for (const float x : copies.read(quantity)) EXPECT_TRUE(std::isfinite(x));
    EXPECT_GT(dBatchCountBad(copies.id), 0);
    dRobotModelDestroy(model);
}

TEST_F(BatchRefusals, bound_arrays_live)
{
    const dRobotModelID model = model_of(kWalker);
    Copies<float> copies(model, 3, dReal(0.004)), other(model, 3, dReal(0.004));
    std::vector<float> q(3 * 15), c(3 * 5, 0.5f);
    EXPECT_EQ(dBatchBind(copies.id, dBatchPositions, q.data()), 1);
    EXPECT_EQ(q, other.read(dBatchPositions));
    q[2] = 0.8f;
    dBatchStep(copies.id, 3);
    auto moved = other.read(dBatchPositions);
    moved[2] = 0.8f;
    other.write(dBatchPositions, moved);
    dBatchStep(other.id, 3);
    EXPECT_EQ(q, other.read(dBatchPositions));
    EXPECT_EQ(dBatchBind(copies.id, dBatchPositions, nullptr), 1);
    dRobotModelDestroy(model);
}

}  // namespace
}  // namespace epode::tests
