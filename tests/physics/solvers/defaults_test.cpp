// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldUseDefaults: a game and a robot of a program that sets nothing else; ODE's values again; what
// dDefaultsText lists is what is set; bad presets.
#include <algorithm>
#include <cstring>

#include "scenes.h"

namespace epode::physics {
namespace {

// All parameters that a preset may set, in the order of dDefaultsText.
std::vector<double> read(dWorldID w)
{
    return {double(dWorldGetHybridStepper(w)),
            double(dWorldGetHybridSubsteps(w)),
            double(dWorldGetHybridBudget(w)),
            double(dWorldGetExactSubsteps(w)),
            double(dWorldGetExactRotation(w)),
            double(dWorldGetJointCoordinates(w)),
            double(dWorldGetStepProjection(w)),
            double(dWorldGetStepProjectionTolerance(w)),
            double(dWorldGetStepWarmStarting(w)),
            double(dWorldGetFrictionCone(w)),
            double(dWorldGetManifoldFriction(w)),
            double(dWorldGetStepThreads(w)),
            double(dWorldGetQuickStepNumIterations(w)),
            double(dWorldGetQuickStepW(w)),
            double(dWorldGetERP(w)),
            double(dWorldGetCFM(w)),
            double(dWorldGetContactMaxCorrectingVel(w)),
            double(dWorldGetContactSurfaceLayer(w)),
            double(dWorldGetAutoDisableFlag(w)),
            double(dWorldGetAutoDisableLinearThreshold(w)),
            double(dWorldGetAutoDisableAngularThreshold(w)),
            double(dWorldGetAutoDisableSteps(w)),
            double(dWorldGetAutoDisableTime(w)),
            double(dWorldGetAutoDisableAverageSamplesCount(w)),
            double(dWorldGetLinearDamping(w)),
            double(dWorldGetAngularDamping(w)),
            double(dWorldGetLinearDampingThreshold(w)),
            double(dWorldGetAngularDampingThreshold(w)),
            double(dWorldGetMaxAngularSpeed(w))};
}

std::string text_of(int preset)
{
    std::string text(std::size_t(dDefaultsText(preset, nullptr, 0)) + 1, '?');
    dDefaultsText(preset, &text[0], int(text.size()));
    EXPECT_EQ(text.back(), 0);
    text.pop_back();
    return text;
}

// ---- a game

struct Game : Sim {
    Game()
    {
        dWorldUseDefaults(world, dDefaultsGame);
        dWorldSetContactSpace(world, space);
        gravity(0, 0, -9.81);
        ground();
    }

    void run(double seconds)
    {
        for (int i = 0; i < int(seconds * 60); ++i) ASSERT_EQ(dWorldStepHybrid(world, real(1.0 / 60)), 1);
    }

    int awake() const
    {
        return int(std::count_if(bodies.begin(), bodies.end(), [](dBodyID b) { return dBodyIsEnabled(b); }));
    }
};

TEST(Defaults, a_game_has_a_tower_that_stands_and_a_pile_that_sleeps)
{
    Game game;
    for (int i = 0; i < 20; ++i) game.box({0, 0, 0.5 + i}, {1, 1, 1}, 100);
    Random random(4);
    for (int i = 0; i < 60; ++i) {
        const V3 at = random.point(1);
        game.box(V3{10, 0, 1 + 0.4 * i} + at, {0.5, 0.6, 0.7}, 20);
    }
    game.run(20);
    EXPECT_NEAR(position(game.bodies[19]).z, 19.5, tol(0.05, 0.1));
    EXPECT_EQ(game.awake(), 0);
}

// In ODE's way, with contact joints and dWorldQuickStep.
TEST(Defaults, a_game_does_not_throw_what_was_built_in_the_ground)
{
    const auto fastest = [](int preset) {
        Sim sim(Stepper::kQuick);
        dWorldUseDefaults(sim.world, preset);
        sim.gravity(0, 0, -9.81);
        sim.ground();
        const dBodyID box = sim.box({0, 0, 0.1}, {1, 1, 1}, 10);
        double speed = 0;  // upwards
        for (int i = 0; i < 60; ++i) {
            sim.step(1.0 / 60);
            speed = std::max(speed, velocity(box).z);
        }
        return speed;
    };
    EXPECT_LT(fastest(dDefaultsGame), 1.1);
    EXPECT_GT(fastest(dDefaultsOde), 3);
}

// ---- a robot

// An arm of six links whose servos hold it level, and swing it.
struct Arm : Sim {
    std::vector<dJointID> hinges;

    explicit Arm(int preset)
    {
        dWorldUseDefaults(world, preset);
        gravity(0, 0, -9.81);
        for (int i = 0; i < 6; ++i) {
            const dBodyID before = i ? bodies.back() : nullptr;
            const dBodyID link = box({0.15 + 0.3 * i, 0, 0}, {0.3, 0.08, 0.06}, 3 - 0.4 * i);
            const dJointID hinge = dJointCreateHinge(world, nullptr);
            dJointAttach(hinge, link, before);
            dJointSetHingeAnchor(hinge, real(0.3 * i), 0, 0);
            dJointSetHingeAxis(hinge, 0, i % 2 ? 1 : real(0.6), i % 2 ? 0 : real(0.8));
            hinges.push_back(hinge);
        }
    }

    void aim(double angle)
    {
        for (dJointID hinge : hinges) {
            dDrive servo;
            dDriveInit(&servo, sizeof servo);
            servo.stiffness = 2000, servo.damping = 60, servo.target = real(angle);
            dJointSetDrive(hinge, 0, &servo);
        }
    }

    double gap() const
    {
        double worst = 0;
        for (dJointID hinge : hinges) {
            dVector3 a, b;
            dJointGetHingeAnchor(hinge, a);
            dJointGetHingeAnchor2(hinge, b);
            worst = std::max(worst, length(vec(a) - vec(b)));
        }
        return worst;
    }
};

TEST(Defaults, a_robot_follows_its_servos_with_closed_joints)
{
    Arm arm(dDefaultsRobot);
    double worst = 0;
    for (int i = 0; i < 3000; ++i) {
        arm.aim(i < 1000 ? -0.3e-3 * i : std::min(0.3, -0.3 + 0.6e-3 * (i - 1000)));
        ASSERT_EQ(dWorldStepHybrid(arm.world, real(0.002)), 1);
        worst = std::max(worst, arm.gap());
    }
    EXPECT_LT(worst, 1e-3);
    for (dJointID hinge : arm.hinges) EXPECT_NEAR(dJointGetHingeAngle(hinge), 0.3, 0.1);
    for (dBodyID b : arm.bodies) EXPECT_TRUE(dBodyIsEnabled(b));
}

TEST(Defaults, a_robot_is_solved_exactly_whatever_its_island)
{
    Arm arm(dDefaultsRobot);
    dWorldSetStepReportMode(arm.world, 1);
    dWorldStepHybrid(arm.world, real(0.002));
    dIslandStepReport island{};
    island.struct_size = sizeof island;
    ASSERT_EQ(dWorldGetIslandStepReport(arm.world, 0, &island), 1);
    EXPECT_EQ(island.method, dIslandMethodJointCoordinates);
    EXPECT_LT(arm.report().residual, 1e-9 * (kSingle ? 1e5 : 1));
}

// A body keeps what it had when it was created, in a preset too.
TEST(Defaults, bodies_that_were_there_before_keep_their_own)
{
    Sim sim;
    const dBodyID early = sim.body({0, 0, 0});
    dWorldUseDefaults(sim.world, dDefaultsGame);
    EXPECT_FALSE(dBodyGetAutoDisableFlag(early));
    EXPECT_TRUE(dBodyGetAutoDisableFlag(sim.body({1, 0, 0})));
}

// ---- ODE's values

TEST(Defaults, ode_restores_every_value_of_a_new_world)
{
    for (int preset : {dDefaultsOde, dDefaultsGame, dDefaultsRobot}) {
        Sim fresh, other;
        const std::vector<double> before = read(fresh.world);
        dWorldUseDefaults(other.world, preset);
        EXPECT_EQ(read(other.world) == before, preset == dDefaultsOde) << preset;
        dWorldUseDefaults(other.world, dDefaultsOde);
        EXPECT_EQ(read(other.world), before) << preset;
    }
}

TEST(Defaults, a_world_that_is_back_at_ode_steps_with_the_bits_of_a_new_one)
{
    for (Scene scene : kScenes)
        for (Stepper stepper : kSteppers) {
            std::uint64_t hash[3];
            for (int preset = 0; preset < 3; ++preset) {
                Sim sim(stepper);
                if (preset) dWorldUseDefaults(sim.world, preset);
                if (preset) dWorldUseDefaults(sim.world, dDefaultsOde);
                build(sim, scene);
                sim.steps(60, 0.01);
                hash[preset] = hash_state(sim);
            }
            EXPECT_EQ(hash[1], hash[0]) << name_of(scene) << ' ' << name_of(stepper);
            EXPECT_EQ(hash[2], hash[0]) << name_of(scene) << ' ' << name_of(stepper);
        }
}

TEST(Defaults, leave_alone_what_a_world_has)
{
    Sim sim;
    sim.gravity(1, 2, 3);
    dWorldSetContactSpace(sim.world, sim.space);
    dWorldSetStepReportMode(sim.world, 1);
    for (int preset : {dDefaultsGame, dDefaultsRobot, dDefaultsOde}) {
        EXPECT_EQ(dWorldUseDefaults(sim.world, preset), 1);
        dVector3 g;
        dWorldGetGravity(sim.world, g);
        EXPECT_EQ(length(vec(g) - V3{1, 2, 3}), 0);
        EXPECT_EQ(dWorldGetContactSpace(sim.world), sim.space);
        EXPECT_EQ(dWorldGetStepReportMode(sim.world), 1);
    }
}

// ---- the text

// The value that a line of the text sets.
double value_in(const std::string& line)
{
    const std::string value = line.substr(line.find(", ") + 2);
    if (value.compare(0, 9, "dInfinity") == 0) return double(dInfinity);
    if (value.compare(0, 13, "dStepperExact") == 0) return dStepperExact;
    if (value.compare(0, 14, "dStepperHybrid") == 0) return dStepperHybrid;
    return std::stod(value);
}

TEST(Defaults, the_text_lists_what_is_set)
{
    for (int preset : {dDefaultsOde, dDefaultsGame, dDefaultsRobot}) {
        Sim sim;
        dWorldUseDefaults(sim.world, preset);
        const std::vector<double> set = read(sim.world);
        const std::string text = text_of(preset);
        std::size_t at = 0;
        for (double value : set) {
            const std::size_t end = text.find('\n', at);
            ASSERT_NE(end, std::string::npos);
            const std::string line = text.substr(at, end - at);
            EXPECT_EQ(line.compare(0, 9, "dWorldSet"), 0) << line;
            EXPECT_EQ(dReal(value_in(line)), dReal(value)) << line;
            at = end + 1;
        }
        EXPECT_EQ(at, text.size());
    }
}

TEST(Defaults, the_text_is_cut_off_where_it_does_not_fit)
{
    const std::string whole = text_of(dDefaultsGame);
    char little[12] = "???????????";
    EXPECT_EQ(dDefaultsText(dDefaultsGame, little, 10), int(whole.size()));
    EXPECT_EQ(std::string(little), whole.substr(0, 9));
    EXPECT_EQ(little[10], '?');
    char one = '?';
    EXPECT_EQ(dDefaultsText(dDefaultsGame, &one, 1), int(whole.size()));
    EXPECT_EQ(one, 0);
}

// ---- bad calls

TEST(Defaults, an_unknown_preset_is_refused_and_changes_nothing)
{
    Sim sim;
    dWorldUseDefaults(sim.world, dDefaultsGame);
    const std::vector<double> before = read(sim.world);
    Messages messages;
    for (int preset : {-1, 3, 1000}) {
        EXPECT_EQ(dWorldUseDefaults(sim.world, preset), 0);
        char text[8] = "as was";
        EXPECT_EQ(dDefaultsText(preset, text, sizeof text), 0);
        EXPECT_STREQ(text, "as was");
    }
    EXPECT_EQ(messages.count(), 6);
    EXPECT_NE(messages.last().find("preset"), std::string::npos) << messages.last();
    EXPECT_EQ(dWorldUseDefaults(nullptr, dDefaultsGame), 0);
    EXPECT_EQ(dDefaultsText(dDefaultsGame, nullptr, 5), 0);
    char text[8];
    EXPECT_EQ(dDefaultsText(dDefaultsGame, text, -1), 0);
    EXPECT_EQ(messages.count(), 9);
    EXPECT_EQ(read(sim.world), before);
}

}  // namespace
}  // namespace epode::physics
