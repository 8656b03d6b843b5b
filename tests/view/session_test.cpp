// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What can be done to a run that is being looked at, without a window.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>

#include "record/file/hash.h"
#include "record/file/writer.h"
#include "scenes/extensions.h"
#include "view/session/islands.h"
#include "view/session/live.h"
#include "view/session/playback.h"

namespace epode::view {
namespace {

using scenes::Stepper;

class ViewSession : public testing::Test {
  protected:
    static LiveOptions options_of(const scenes::Recipe& recipe)
    {
        LiveOptions options;
        options.stepper = recipe.stepper;
        options.dt = recipe.dt;
        return options;
    }
    static std::unique_ptr<Live> open(const char* name)
    {
        const scenes::Recipe& recipe = *scenes::find_recipe(name);
        return std::make_unique<Live>(recipe, options_of(recipe));
    }
    static void steps(Session& session, int count)
    {
        for (int i = 0; i < count; ++i) ASSERT_TRUE(session.step());
    }
    // What the library itself says of the bodies, not the stage.
    static std::vector<record::BodyState> bodies_of(const Live& live)
    {
        std::vector<record::BodyState> states;
        for (dBodyID body : live.scene().bodies()) states.push_back(record::state_of(body));
        return states;
    }
    static const record::BodyState& body(const Session& session, size_t number)
    {
        return *session.moment().bodies[number];
    }
    // Positions and velocities to the bit, turns too but for a last bit or two of a few.
    static void expect_back(const std::vector<record::BodyState>& now,
                            const std::vector<record::BodyState>& was)
    {
        ASSERT_EQ(now.size(), was.size());
        size_t turned = 0;
        for (size_t i = 0; i < now.size(); ++i) {
            ASSERT_EQ(now[i].pose.pos, was[i].pose.pos);
            ASSERT_EQ(now[i].linear, was[i].linear);
            ASSERT_EQ(now[i].angular, was[i].angular);
            turned += now[i].pose.turn != was[i].pose.turn;
            for (size_t k = 0; k < 4; ++k)
                ASSERT_NEAR(now[i].pose.turn[k], was[i].pose.turn[k],
                            4 * double(std::numeric_limits<dReal>::epsilon()));
        }
        ASSERT_LE(turned, now.size() / 20);
    }
    static double apart(const std::vector<record::BodyState>& a, const std::vector<record::BodyState>& b)
    {
        double largest = 0;
        for (size_t i = 0; i < a.size(); ++i)
            largest = std::max(largest, scenes::length(vec(a[i].pose.pos) - vec(b[i].pose.pos)));
        return largest;
    }
    scenes::Runtime runtime_;
};

TEST_F(ViewSession, looks_for_causes_of_failure_when_asked_and_forgets_them_in_a_jump)
{
    const scenes::Recipe& recipe = *scenes::find_recipe("tops");
    LiveOptions options = options_of(recipe);
    options.dt = 0.1;  // tops rotate too far in that
    Live live(recipe, options);
    steps(live, 5);
    EXPECT_TRUE(live.causes().empty());
    live.options.diagnose = true;
    steps(live, 5);
    ASSERT_FALSE(live.causes().empty());
    EXPECT_GE(live.causes()[0].severity, 1);
    EXPECT_GE(live.causes()[0].body, 0);
    EXPECT_NE(live.causes()[0].text.find("rotates"), std::string::npos) << live.causes()[0].text;
    EXPECT_TRUE(live.seek(6));
    EXPECT_TRUE(live.causes().empty());
    steps(live, 1);
    EXPECT_FALSE(live.causes().empty());
}

TEST_F(ViewSession, steps_and_goes_back_to_the_same_bits)
{
    for (const char* name : {"ragdolls", "wall", "buggy"}) {
        auto live = open(name);
        std::vector<std::vector<record::BodyState>> seen{bodies_of(*live)};
        for (int i = 0; i < 40; ++i) {
            steps(*live, 1);
            seen.push_back(bodies_of(*live));
        }
        EXPECT_EQ(live->now(), 40u);
        EXPECT_FALSE(seen[40] == seen[39]) << name;
        for (size_t i = 40; i-- > 0;) {
            ASSERT_TRUE(live->step_back());
            ASSERT_EQ(live->now(), i);
            ASSERT_NO_FATAL_FAILURE(expect_back(bodies_of(*live), seen[i])) << name << " state " << i;
        }
        EXPECT_FALSE(live->step_back()) << "before the first state there is none";
        EXPECT_EQ(live->scene().time(), 0);
    }
}

TEST_F(ViewSession, the_same_steps_follow_again_after_going_back)
{
    for (const char* name : {"fourbar", "chain", "pendulum"}) {
        for (Stepper stepper : {Stepper::kExact, Stepper::kQuick}) {
            auto live = open(name);
            live->options.stepper = stepper;
            scenes::set_warm_starting(live->scene().world(), 0);  // its memory is not brought back
            steps(*live, 30);
            const auto there = bodies_of(*live);
            const double time = live->scene().time();
            ASSERT_TRUE(live->seek(10));
            EXPECT_GT(apart(bodies_of(*live), there), 1e-3);
            steps(*live, 20);
            // Nor is what joints bore in the last step, by which sweeps raise inertias (step/island/positions/tension).
            const double near = sizeof(dReal) != 8 ? 1e-3 : stepper == Stepper::kQuick ? 1e-7 : 1e-10;
            EXPECT_LT(apart(bodies_of(*live), there), near) << name << " " << scenes::name_of(stepper);
            EXPECT_EQ(live->scene().time(), time);
        }
    }
}

TEST_F(ViewSession, what_a_scene_does_by_the_clock_goes_back_with_it)
{
    auto live = open("buggy");
    live->options.stepper = Stepper::kExact;
    steps(*live, 100);
    const Vec there = vec(body(*live, 0).pose.pos);
    ASSERT_TRUE(live->seek(60));
    EXPECT_NEAR(live->scene().time(), 60 * live->options.dt, 1e-4);
    steps(*live, 40);
    EXPECT_NEAR(scenes::length(vec(body(*live, 0).pose.pos) - there), 0, 1e-4);
}

TEST_F(ViewSession, a_step_from_an_earlier_state_forgets_the_old_future)
{
    auto live = open("chain");
    steps(*live, 20);
    ASSERT_TRUE(live->seek(5));
    EXPECT_EQ(live->stage().last(), 20u);
    live->options.dt *= 0.5;
    steps(*live, 1);
    EXPECT_EQ(live->stage().last(), 6u);
    EXPECT_FALSE(live->seek(7));
    EXPECT_EQ(live->now(), 6u);
}

TEST_F(ViewSession, restart_begins_the_same_run_again)
{
    auto live = open("ragdolls");
    steps(*live, 25);
    const auto there = bodies_of(*live);
    live->restart();
    EXPECT_EQ(live->now(), 0u);
    EXPECT_EQ(live->scene().time(), 0);
    steps(*live, 25);
    EXPECT_TRUE(bodies_of(*live) == there);
}

TEST_F(ViewSession, time_passes_by_the_clock_and_its_factor)
{
    auto live = open("pendulum");
    const double dt = live->options.dt;
    for (int i = 0; i < 50; ++i) live->pass(0.02, 10);
    EXPECT_NEAR(live->scene().time(), 1, 1.01 * dt);
    live->faster();
    for (int i = 0; i < 50; ++i) live->pass(0.02, 10);
    EXPECT_NEAR(live->scene().time(), 3, 2.01 * dt);
    live->slower();
    live->slower();
    for (int i = 0; i < 50; ++i) live->pass(0.02, 10);
    EXPECT_NEAR(live->scene().time(), 3.5, 3.01 * dt);
    live->paused = true;
    const size_t now = live->now();
    live->pass(5, 10);
    EXPECT_EQ(live->now(), now);
    live->paused = false;
    live->pass(dt, 10);
    EXPECT_LE(live->now(), now + 2) << "time that passed during the pause is not made up for";
}

TEST_F(ViewSession, a_scene_too_heavy_falls_behind)
{
    auto live = open("pile");
    live->pass(1000, 0.02);
    EXPECT_GE(live->now(), 1u);
    EXPECT_LT(live->scene().time(), 100);
}

TEST_F(ViewSession, only_so_many_bytes_of_states_are_kept)
{
    const scenes::Recipe& recipe = *scenes::find_recipe("wall");
    LiveOptions options = options_of(recipe);
    options.memory = 200'000;
    Live live(recipe, options);
    steps(live, 60);
    EXPECT_GT(live.stage().first(), 0u);
    EXPECT_EQ(live.stage().last(), 60u);
    EXPECT_FALSE(live.seek(0));
    ASSERT_TRUE(live.seek(live.stage().first()));
    EXPECT_FALSE(live.step_back());
    EXPECT_NEAR(live.scene().time(), double(live.now()) * options.dt, 1e-5);
}

// Rays from outside at every body of a scene: what is met lies no farther than the body's middle, and a
// second look, by triangles of the same state, agrees.
TEST_F(ViewSession, a_ray_meets_what_it_is_aimed_at)
{
    auto live = open("wall");
    const Moment now = live->moment();
    int own = 0;
    for (size_t i = 0; i < now.bodies.size(); i += 7) {
        const Vec at = vec(now.bodies[i]->pose.pos), eye{at.x, at.y - 30, at.z + 0.01};
        const auto hit = live->pick(eye, at - eye);
        ASSERT_TRUE(hit);
        EXPECT_LE(hit->distance, scenes::length(at - eye));
        own += hit->body == std::int32_t(i);
    }
    EXPECT_GT(own, int(now.bodies.size()) / 14) << "bricks in front are met themselves";
    EXPECT_FALSE(live->pick({0, 0, 50}, {0, 0, 1}));
    const auto ground = live->pick({100, 100, 5}, {0, 0, -1});
    ASSERT_TRUE(ground);
    EXPECT_EQ(ground->body, record::kNobody);
    EXPECT_NEAR(ground->point.z, 0, 1e-5);
}

TEST_F(ViewSession, a_pulled_body_comes_to_where_it_is_pulled)
{
    for (Stepper stepper : {Stepper::kExact, Stepper::kQuick}) {
        auto live = open("wall");
        live->options.stepper = stepper;
        const auto top = std::int32_t(live->stage().bodies().size() - 1);
        const Vec from = vec(body(*live, size_t(top)).pose.pos), goal = from + Vec{0, -1.5, 1};
        live->grab(top, from + Vec{0.05, 0, 0.02});
        EXPECT_NEAR(scenes::length(live->hook() - (from + Vec{0.05, 0, 0.02})), 0, 1e-5);
        live->pull_to(goal);
        for (int i = 0; i < int(3 / live->options.dt); ++i) ASSERT_TRUE(live->step());
        // It hangs below by g / w^2 times how much lighter than the body the point is.
        EXPECT_LT(scenes::length(live->hook() - goal), 0.4) << scenes::name_of(stepper);
        EXPECT_LT(scenes::length(vec(body(*live, size_t(top)).linear)), 0.5);
        live->release();
        for (int i = 0; i < int(0.2 / live->options.dt); ++i) ASSERT_TRUE(live->step());
        EXPECT_LT(body(*live, size_t(top)).linear[2], -1) << "let go, it falls";
    }
}

TEST_F(ViewSession, a_push_gives_the_momentum_it_says)
{
    auto live = open("satellite");
    const Vec at = vec(body(*live, 0).pose.pos);
    const double mass = live->stage().bodies()[0].mass;
    const auto without = [&] {
        steps(*live, 1);
        const Vec v = vec(body(*live, 0).linear);
        live->seek(0);
        return v;
    }();
    live->push(0, at, {2 * mass, 0, 0});
    steps(*live, 1);
    double momentum = 0;
    for (size_t i = 0; i < live->stage().bodies().size(); ++i)
        momentum += live->stage().bodies()[i].mass * body(*live, i).linear[0];
    live->seek(0);
    double before = 0;
    for (size_t i = 0; i < live->stage().bodies().size(); ++i)
        before += live->stage().bodies()[i].mass * body(*live, i).linear[0];
    EXPECT_NEAR(momentum - before, 2 * mass, 1e-3 * mass);
    EXPECT_TRUE(std::isfinite(without.x));
}

TEST_F(ViewSession, steppers_iterations_and_threads_change_while_it_runs)
{
    auto live = open("ragdolls");
    for (Stepper stepper : {Stepper::kExact, Stepper::kFast, Stepper::kQuick}) {
        if (!scenes::available(stepper)) continue;
        live->options.stepper = stepper;
        for (int iterations : {0, 3, 30}) {
            live->options.iterations = iterations;
            live->options.threads = 1 + iterations % 2;
            steps(*live, 4);
        }
    }
    EXPECT_LT(live->state().step.joint_error, 0.05);
    live->restart();
    steps(*live, 20);
    ASSERT_TRUE(live->seek(10));
    live->options.stepper = Stepper::kQuick;
    live->options.iterations = 1;
    steps(*live, 10);
    const auto rough = bodies_of(*live);
    ASSERT_TRUE(live->seek(10));
    live->options.stepper = Stepper::kExact;
    steps(*live, 10);
    EXPECT_FALSE(bodies_of(*live) == rough) << "the choice is not obeyed";
}

TEST_F(ViewSession, limits_are_where_the_joint_is)
{
    auto live = open("ragdolls");
    int turning = 0;
    for (std::uint32_t i = 0; i < live->stage().joints().size(); ++i) {
        for (const record::Limit& limit : live->limits(i)) {
            EXPECT_LT(limit.stop.low, limit.stop.high);
            EXPECT_GE(limit.value, limit.stop.low - 0.01);
            EXPECT_LE(limit.value, limit.stop.high + 0.01);
            turning += limit.stop.turns;
        }
    }
    EXPECT_EQ(turning, 6 * (5 * 2 + 4)) << "universal joints have two each, hinges one";
}

TEST_F(ViewSession, a_ball_is_shot_and_flies)
{
    auto live = open("pendulum");
    steps(*live, 3);
    const size_t before = live->stage().bodies().size();
    live->shoot({5, 0, 5}, {0, 3, 0}, 0.2, 7);
    EXPECT_EQ(live->stage().bodies().size(), before) << "it is there from the next step on";
    steps(*live, 10);
    ASSERT_EQ(live->stage().bodies().size(), before + 1);
    EXPECT_EQ(live->stage().bodies().back().mass, 7);
    EXPECT_NEAR(body(*live, before).pose.pos[1], 10 * live->options.dt * 3, 1e-6);
    EXPECT_LT(body(*live, before).pose.pos[2], 5);
    ASSERT_EQ(live->moment().geoms.back().body, std::int32_t(before));
    const auto flown = bodies_of(*live);
    ASSERT_TRUE(live->seek(8));
    ASSERT_TRUE(live->seek(13));
    expect_back(bodies_of(*live), flown);
    live->restart();
    EXPECT_EQ(live->stage().bodies().size(), before);
}

TEST_F(ViewSession, back_before_the_shot_there_is_no_ball)
{
    auto shot = open("wall"), calm = open("wall");
    for (Live* live : {shot.get(), calm.get()}) live->options.stepper = Stepper::kExact;
    steps(*shot, 4);
    steps(*calm, 4);
    const size_t ball = shot->stage().bodies().size();
    shot->shoot({-1, 0, 0.8}, {20, 0, 0}, 0.2, 50);
    steps(*shot, 12);
    ASSERT_TRUE(shot->moment().bodies[ball]);
    ASSERT_TRUE(shot->seek(4));
    EXPECT_FALSE(shot->moment().bodies[ball]);
    steps(*shot, 12);
    steps(*calm, 12);
    EXPECT_FALSE(shot->moment().bodies[ball]) << "a future without the ball";
    for (size_t i = 0; i < ball; ++i) {
        EXPECT_LT(scenes::length(vec(body(*shot, i).pose.pos) - vec(body(*calm, i).pose.pos)), 1e-6) << i;
    }
    EXPECT_EQ(shot->moment().step->contacts.size(), calm->moment().step->contacts.size());
    shot->shoot({-1, 0, 0.8}, {20, 0, 0}, 0.2, 50);
    steps(*shot, 2);
    EXPECT_TRUE(shot->moment().bodies[ball + 1]);
}

TEST_F(ViewSession, islands_are_what_hangs_together)
{
    auto live = open("ragdolls");
    const auto island = islands(live->stage(), live->moment());
    for (size_t i = 0; i < island.size(); ++i) EXPECT_EQ(island[i], i / 11 * 11);
}

class ViewPlayback : public ViewSession {
  protected:
    // A file of its own: tests run side by side.
    void SetUp() override
    {
        const testing::TestInfo& test = *testing::UnitTest::GetInstance()->current_test_info();
        path_ = testing::TempDir() + "view_playback_" + test.name() + ".epr";
    }
    void TearDown() override { std::remove(path_.c_str()); }

    // The scene's own run, written by the same recorder as \`epode record\`.
    void write(int count)
    {
        record::FileWriter writer;
        ASSERT_TRUE(writer.open(path_)) << path_;
        auto live = open("wall");
        record::Recorder recorder(writer);
        for (dBodyID b : live->scene().bodies()) recorder.add(b);
        for (dGeomID g : live->scene().geoms()) recorder.add(g);
        for (int i = 0; i <= count; ++i) {
            if (i > 0) steps(*live, 1);
            record::StepFigures figures;
            figures.time = live->scene().time();
            recorder.step(figures, {}, false);
            hits_.push_back(live->pick({0.3, -20, 1.1}, {0, 1, 0}));
            states_.push_back(bodies_of(*live));
        }
        ASSERT_TRUE(writer.close());
    }
    std::string path_;
    std::vector<std::optional<Hit>> hits_;
    std::vector<std::vector<record::BodyState>> states_;
};

TEST_F(ViewPlayback, plays_what_was_recorded_and_picks_by_its_triangles)
{
    write(12);
    std::string problem;
    auto playback = Playback::open(path_, problem);
    ASSERT_TRUE(playback) << problem;
    EXPECT_FALSE(playback->live());
    for (size_t i = 0; i < states_.size(); ++i) {
        ASSERT_TRUE(playback->seek(i));
        EXPECT_TRUE(playback->state().step.bodies == states_[i]);
        const auto hit = playback->pick({0.3, -20, 1.1}, {0, 1, 0});
        ASSERT_EQ(bool(hit), bool(hits_[i]));
        if (!hit) continue;
        EXPECT_EQ(hit->body, hits_[i]->body);
        EXPECT_NEAR(hit->distance, hits_[i]->distance, 0.02) << "round shapes have corners";
    }
    EXPECT_FALSE(playback->step()) << "it has ended";
    EXPECT_TRUE(playback->step_back());
    playback->restart();
    EXPECT_EQ(playback->now(), 0u);
    playback->pass(1e3, 10);
    EXPECT_EQ(playback->now(), 12u);
}

TEST_F(ViewPlayback, has_the_limits_of_joints)
{
    record::FileWriter writer;
    ASSERT_TRUE(writer.open(path_)) << path_;
    auto live = open("ragdolls");
    record::Recorder recorder(writer);
    for (dBodyID b : live->scene().bodies()) recorder.add(b);
    for (const auto& joint : live->scene().joints()) recorder.add(joint.joint);
    std::vector<std::vector<record::Limit>> recorded;
    for (int i = 0; i < 4; ++i) {
        if (i == 2) dJointSetHingeParam(live->scene().joints().back().joint, dParamHiStop, 0.5);
        steps(*live, 1);
        recorder.step({}, {}, false);
        recorded.push_back(live->state().step.limits);
    }
    ASSERT_TRUE(writer.close());
    std::string problem;
    auto playback = Playback::open(path_, problem);
    ASSERT_TRUE(playback) << problem;
    for (size_t i = 0; i < recorded.size(); ++i) {
        ASSERT_TRUE(playback->seek(i));
        const auto& limits = playback->state().step.limits;
        ASSERT_EQ(limits.size(), recorded[i].size());
        for (size_t k = 0; k < limits.size(); ++k) {
            EXPECT_EQ(limits[k].stop, recorded[i][k].stop);
            EXPECT_EQ(limits[k].value, recorded[i][k].value);
        }
    }
    EXPECT_FALSE(recorded[1].back().stop == recorded[2].back().stop) << "the last joint is no hinge";
    const std::uint32_t joint = recorded[3].back().stop.joint;
    EXPECT_EQ(playback->limits(joint).back().value, recorded[3].back().value);
}

TEST_F(ViewPlayback, refuses_what_is_no_recording)
{
    std::ofstream(path_) << "no recording";
    std::string problem;
    EXPECT_FALSE(Playback::open(path_, problem));
    EXPECT_FALSE(problem.empty());
    problem.clear();
    EXPECT_FALSE(Playback::open(path_ + ".absent", problem));
    EXPECT_FALSE(problem.empty());
}

}  // namespace
}  // namespace epode::view
