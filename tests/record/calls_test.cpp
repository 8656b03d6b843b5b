// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Calls in recordings: they come back as they went in, and what is no call, or asks for nonsense, neither
// reaches the library nor stops the program.
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cstdarg>
#include <random>

#include "record/file/calls.h"
#include "record/file/reader.h"
#include "record/file/writer.h"
#include "record/rerun/rerun.h"

namespace epode::record {
namespace {

void say_nothing(int, const char*, std::va_list) {}

// The library's refusals are not to be read here.
struct Quiet {
    dMessageFunction* error = dGetErrorHandler();
    dMessageFunction* debug = dGetDebugHandler();
    dMessageFunction* message = dGetMessageHandler();
    Quiet()
    {
        dSetErrorHandler(say_nothing);
        dSetDebugHandler(say_nothing);
        dSetMessageHandler(say_nothing);
    }
    ~Quiet()
    {
        dSetErrorHandler(error);
        dSetDebugHandler(debug);
        dSetMessageHandler(message);
    }
};

dContact full_contact(int mode)
{
    dContact contact{};
    contact.surface = {mode, 0.5, 0.4, 0.01, 0.02, 0.03, 0.1, 0.2, 0.3, 1e-5, 1, 2, 3, 4, 5};
    contact.geom.depth = 0.001;
    contact.geom.normal[2] = 1;
    contact.geom.pos[0] = 7;
    contact.fdir1[0] = 1;
    return contact;
}

TEST(Calls, a_contact_comes_back_with_all_that_its_mode_asks_for)
{
    for (int mode = 0; mode < 0x8000; ++mode) {
        const std::vector<double> numbers = numbers_of(full_contact(mode));
        dContact back;
        ASSERT_TRUE(from_numbers(numbers, back)) << mode;
        EXPECT_EQ(back.surface.mode, mode);
        EXPECT_EQ(back.surface.mu, dReal(0.5));
        EXPECT_EQ(back.surface.slip2, mode & dContactSlip2 ? dReal(5) : dReal(0));
        EXPECT_EQ(back.surface.bounce_vel, mode & dContactBounce ? dReal(0.2) : dReal(0));
        EXPECT_EQ(back.fdir1[0], mode & dContactFDir1 ? dReal(1) : dReal(0));
        EXPECT_EQ(numbers_of(back), numbers);
        std::vector<double> shorter = numbers;
        shorter.pop_back();
        EXPECT_FALSE(from_numbers(shorter, back));
    }
}

// A ball that falls, is pushed, and hangs on a joint from the third step on.
Recording ball()
{
    using enum ArgumentKind;
    Recording recording;
    recording.about = {{"source", "program"}, {"precision", kPrecision}};
    CallTape tape;
    tape.add("dWorldSetGravity",
             {Argument::world(), Argument::of(0.0), Argument::of(0.0), Argument::of(-9.81)});
    tape.add("dBodyCreate", {Argument::world()});
    tape.add("dBodySetQuaternion", {Argument::of(kBody, 0), Argument::of(std::vector<double>{1, 0, 0, 0})});
    recording.body({1, false});
    for (int i = 0; i < 5; ++i) {
        recording.calls(tape.take());
        Step step;
        step.bodies.emplace_back();
        step.asleep.push_back(0);
        recording.step(step);
        if (i == 2) {
            tape.add("dJointCreateBall", {Argument::world(), Argument::of(kGroup, 0)});
            tape.add("dJointAttach",
                     {Argument::of(kJoint, 0), Argument::of(kBody, 0), Argument::of(kBody, -1)});
            tape.add("dJointSetBallAnchor",
                     {Argument::of(kJoint, 0), Argument::of(0.0), Argument::of(0.0), Argument::of(1.0)});
        }
        dContact contact = full_contact(dContactBounce);
        contact.geom.pos[2] = -1;
        tape.add("dJointCreateContact",
                 {Argument::world(), Argument::of(kGroup, 1), Argument::of(numbers_of(contact))});
        tape.add("dBodyAddForce",
                 {Argument::of(kBody, 0), Argument::of(1.0), Argument::of(0.0), Argument::of(0.0)});
        tape.add("dWorldStepFast1", {Argument::world(), Argument::of(0.01), Argument::of(2)});
        tape.add("dJointGroupEmpty", {Argument::of(kGroup, 1)});
    }
    return recording;
}

TEST(Calls, are_made_again)
{
    Recording now;
    const Recording was = ball();
    Rerun rerun(was, {});
    ASSERT_TRUE(rerun.run(now, [](size_t) { return true; })) << rerun.problem();
    ASSERT_EQ(now.steps.size(), 5u);
    const Vec3& velocity = now.steps[2].bodies[0].linear;
    EXPECT_NEAR(velocity[0], 0.02, 1e-9);
    EXPECT_NEAR(velocity[2], -9.81 * 0.02, 1e-6);
    ASSERT_EQ(now.joints.size(), 1u);
    EXPECT_EQ(now.joints[0].type, std::uint32_t(dJointTypeBall));
}

TEST(Calls, go_through_a_file)
{
    const Recording was = ball();
    const std::string path = ::testing::TempDir() + "calls_test.epr";
    std::string problem;
    ASSERT_TRUE(write_file(was, path, problem)) << problem;
    Recording got;
    const ReadResult result = read_file(path, got);
    ASSERT_TRUE(result.whole()) << result.problem;
    ASSERT_EQ(got.calls_made.size(), was.calls_made.size());
    for (size_t i = 0; i < got.calls_made.size(); ++i) {
        EXPECT_EQ(got.calls_made[i].step, was.calls_made[i].step);
        EXPECT_EQ(got.calls_made[i].block.bytes, was.calls_made[i].block.bytes);
        EXPECT_EQ(got.calls_made[i].block.new_names, was.calls_made[i].block.new_names);
    }
}

TEST(Calls, that_are_none_are_not_sound)
{
    CallTape tape;
    tape.add("dBodyCreate", {Argument::world(), Argument::of(std::vector<double>{1, 2})});
    const CallBlock whole = tape.take();
    EXPECT_TRUE(sound(whole, 1));
    EXPECT_FALSE(sound(whole, 0));
    for (size_t cut = 1; cut < whole.bytes.size(); ++cut) {
        CallBlock block = whole;
        block.bytes.resize(cut);
        EXPECT_FALSE(sound(block, 1)) << cut;
    }
    CallBlock kind = whole;
    kind.bytes[5] = 77;
    EXPECT_FALSE(sound(kind, 1));
    CallBlock last = whole;
    last.bytes = {0, 0, 0, 0, 1, 77};
    last.count = 0;
    EXPECT_FALSE(sound(last, 1));
}

// One byte after the other is changed; whatever comes of it, it ends, and the library refuses what makes no
// sense.
TEST(Calls, that_are_damaged_do_no_harm)
{
    const Quiet quiet;
    const Recording was = ball();
    std::mt19937 random(5);
    int refused = 0, whole = 0;
    for (size_t block = 0; block < was.calls_made.size(); ++block) {
        for (size_t at = 0; at < was.calls_made[block].block.bytes.size(); ++at) {
            Recording damaged = was;
            damaged.calls_made[block].block.bytes[at] = std::uint8_t(random());
            Recording now;
            Rerun rerun(damaged, {});
            (rerun.run(now, [](size_t) { return true; }) ? whole : refused) += 1;
        }
    }
    EXPECT_GT(refused, 100);
    EXPECT_GT(whole, 100);
}

// Why a recording of this call alone is refused.
std::string problem_of(const char* name, const std::vector<Argument>& arguments)
{
    Recording recording = ball();
    CallTape tape;
    tape.add("dBodyCreate", {Argument::world()});
    tape.add(name, arguments);
    recording.calls_made.resize(1);
    recording.calls_made[0].block = tape.take();
    Recording now;
    Rerun rerun(recording, {});
    return rerun.run(now, [](size_t) { return true; }) ? std::string() : rerun.problem();
}

TEST(Calls, of_unknown_functions_or_other_arguments_are_refused_by_name)
{
    EXPECT_NE(problem_of("system", {Argument::world()}).find("system"), std::string::npos);
    EXPECT_NE(problem_of("dJointCreate", {Argument::world(), Argument::of(ArgumentKind::kGroup, 0)}), "");
    EXPECT_NE(problem_of("dWorldSetERP", {Argument::world()}).find("dWorldSetERP"), std::string::npos);
    EXPECT_NE(problem_of("dWorldSetERP", {Argument::world(), Argument::of(1)}), "");
    EXPECT_NE(problem_of("dWorldSetContactSpace", {}).find("cannot do again"), std::string::npos);
    EXPECT_EQ(problem_of("dWorldSetERP", {Argument::world(), Argument::of(0.3)}), "");
    EXPECT_EQ(problem_of("dBodyEnable", {Argument::of(ArgumentKind::kBody, 12)}), "");
    // It would take a contact from wherever its third argument is.
    EXPECT_NE(problem_of("dJointCreateContact", {Argument::world(), Argument::of(ArgumentKind::kGroup, -1)}),
              "");
}

TEST(Calls, that_ask_for_absurdly_much_are_refused)
{
    const Quiet quiet;
    const Argument world = Argument::world(), body = Argument::of(ArgumentKind::kBody, 0),
                   dt = Argument::of(0.001);
    const auto many = [&](int stepper, int small, int steps) {
        return problem_of("dWorldsStep",
                          {world, dt, Argument::of(stepper), Argument::of(small), Argument::of(steps)});
    };
    for (int count : {10000001, 2000000000})
        EXPECT_NE(problem_of("dWorldSetQuickStepNumIterations", {world, Argument::of(count)}).find("absurd"),
                  std::string::npos);
    for (int count : {10001, 1 << 20, -1}) {
        EXPECT_NE(problem_of("dBodySetAutoDisableAverageSamplesCount", {body, Argument::of(count)}), "");
        EXPECT_NE(problem_of("dWorldSetAutoDisableAverageSamplesCount", {world, Argument::of(count)}), "");
    }
    EXPECT_NE(problem_of("dWorldStepFast1", {world, dt, Argument::of(10001)}).find("absurd"),
              std::string::npos);
    EXPECT_NE(many(dStepperSubsteps, 10000, 10000).find("absurd"), std::string::npos);
    EXPECT_NE(many(dStepperSubsteps, 4, 10001).find("absurd"), std::string::npos);
    // What a program may well ask for.
    EXPECT_EQ(problem_of("dWorldSetQuickStepNumIterations", {world, Argument::of(1000)}), "");
    EXPECT_EQ(problem_of("dBodySetAutoDisableAverageSamplesCount", {body, Argument::of(100)}), "");
    EXPECT_EQ(many(dStepperSubsteps, 20, 10), "");
}

// Bodies times the samples of each: a few bytes would else ask for gigabytes.
TEST(Calls, that_ask_for_absurdly_many_samples_together_are_refused)
{
    Recording recording = ball();
    CallTape tape;
    tape.add("dWorldSetAutoDisableAverageSamplesCount", {Argument::world(), Argument::of(10000)});
    for (int i = 0; i < 200; ++i) tape.add("dBodyCreate", {Argument::world()});
    recording.calls_made.resize(1);
    recording.calls_made[0].block = tape.take();
    Recording now;
    Rerun rerun(recording, {});
    EXPECT_FALSE(rerun.run(now, [](size_t) { return true; }));
    EXPECT_NE(rerun.problem().find("absurdly many samples"), std::string::npos) << rerun.problem();
}

// Sweeps of each step times steps.
TEST(Calls, that_ask_for_absurdly_much_together_are_refused)
{
    Recording recording = ball();
    CallTape tape;
    tape.add("dWorldSetQuickStepNumIterations", {Argument::world(), Argument::of(100000)});
    tape.add("dWorldsStep", {Argument::world(), Argument::of(0.001), Argument::of(dStepperQuick),
                             Argument::of(1), Argument::of(10000)});
    recording.calls_made.resize(1);
    recording.calls_made[0].block = tape.take();
    Recording now;
    Rerun rerun(recording, {});
    EXPECT_FALSE(rerun.run(now, [](size_t) { return true; }));
    EXPECT_NE(rerun.problem().find("absurd"), std::string::npos);
}

}  // namespace
}  // namespace epode::record
