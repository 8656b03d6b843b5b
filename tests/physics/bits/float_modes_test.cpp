// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A host may round upwards, flush denormals or have exceptions trap: steps leave the same bits, on any number
// of threads, and the host finds its modes and flags as they were.
#include "float_modes.h"
#include "scenes.h"
#include "world_contacts.h"

#include <limits>

namespace epode::physics {
namespace {

#ifdef EPODE_HAS_FLOAT_MODES

constexpr int kSteppers4 = 4;
const char* const kStepperNames[kSteppers4] = {"exact", "quick", "fast", "hybrid"};

int step_by(int stepper, dWorldID world)
{
    switch (stepper) {
        case 0:
            return dWorldStep(world, dReal(0.01));
        case 1:
            return dWorldQuickStep(world, dReal(0.01));
        case 2:
            return dWorldStepFast1(world, dReal(0.01), 4);
        default:
            return dWorldStepHybrid(world, dReal(0.01));
    }
}

constexpr FloatMode kUsual{"usual", kUsualControl};

struct Outcome {
    std::uint64_t hash;
    bool kept;  // the host's registers
    bool operator==(const Outcome&) const = default;
};

// Contacts by the program and then by the world, a scene of each kind.
Outcome run(const FloatMode& mode, Scene scene, int stepper, int threads)
{
    Sim sim;
    dWorldSetStepThreads(sim.world, threads);
    build(sim, scene, 4);
    bool kept = true;
    for (int i = 0; i < 30; ++i) {
        const HostMode host(mode, kept, Keeps::kModes);
        sim.collide();
        step_by(stepper, sim.world);
    }
    dJointGroupEmpty(sim.contacts);
    dWorldSetContactSpace(sim.world, sim.space);
    for (int i = 0; i < 30; ++i) {
        const HostMode host(mode, kept);
        step_by(stepper, sim.world);
    }
    return {hash_state(sim), kept};
}

TEST(FloatModes, steps_leave_the_same_bits_in_all_of_them)
{
    for (Scene scene : kScenes)
        for (int stepper = 0; stepper < kSteppers4; ++stepper) {
            const Outcome alone = run(kUsual, scene, stepper, 1);
            for (const FloatMode& mode : kFloatModes)
                for (int threads = 1; threads <= 3; ++threads) {
                    const Outcome got = run(mode, scene, stepper, threads);
                    const std::string where = std::string(name_of(scene)) + ' ' + kStepperNames[stepper] +
                                              ' ' + mode.name + ' ' + std::to_string(threads);
                    EXPECT_EQ(got.hash, alone.hash) << where;
                    EXPECT_TRUE(got.kept) << where;
                }
        }
}

// Poses and boxes are computed when somebody asks: what a host reads is what the next step goes by.
TEST(FloatModes, what_is_read_in_them_is_what_steps_go_by)
{
    const auto state = [](const FloatMode& mode, bool& kept) {
        Sim sim;
        sim.gravity(0, 0, -9.81);
        sim.ground();
        const dBodyID body = sim.box({0.1, 0.2, 0.9}, {0.7, 0.3, 0.9}, 3);
        const dGeomID geom = dBodyGetFirstGeom(body);
        const dQuaternion turn = {1, 2, 3, 5}, tilt = {3, 1, 1, 2};
        dGeomSetOffsetPosition(geom, dReal(0.1), dReal(0.3), dReal(-0.1));
        dGeomSetOffsetQuaternion(geom, tilt);
        dBodySetQuaternion(body, turn);
        for (int i = 0; i < 40; ++i) {
            {
                const HostMode host(mode, kept);
                dReal box[6];
                dQuaternion q;
                dGeomGetPosition(geom);
                dGeomGetAABB(geom, box);
                dGeomGetQuaternion(geom, q);
            }
            sim.step(0.01);
        }
        return hash_state(sim);
    };
    bool kept = true;
    const std::uint64_t usual = state(kUsual, kept = true);
    kept = true;
    for (const FloatMode& mode : kFloatModes) EXPECT_EQ(state(mode, kept), usual) << mode.name;
    EXPECT_TRUE(kept);
}

TEST(FloatModes, batches_leave_the_same_bits_in_all_of_them)
{
    const auto run_batch = [](const FloatMode& mode, int stepper, int threads) {
        Sim sims[4];
        dWorldID worlds[4];
        bool kept = true;
        for (int i = 0; i < 4; ++i) {
            build(sims[i], kScenes[i % 3], std::uint32_t(i));
            dWorldSetContactSpace(sims[i].world, sims[i].space);
            worlds[i] = sims[i].world;
        }
        {
            const HostMode host(mode, kept);
            dWorldsStep(worlds, 4, dReal(0.01), stepper, 4, 20, threads, nullptr);
        }
        std::uint64_t all = 0;
        for (const Sim& sim : sims) all = all * 31 + hash_state(sim);
        return Outcome{all, kept};
    };
    for (int stepper : {int(dStepperExact), int(dStepperQuick), int(dStepperSubsteps)}) {
        const Outcome alone = run_batch(kUsual, stepper, 1);
        EXPECT_EQ(run_batch(kEverythingTraps, stepper, 3), (Outcome{alone.hash, true}));
        for (const FloatMode& mode : kFloatModes)
            for (int threads = 1; threads <= 3; ++threads)
                EXPECT_EQ(run_batch(mode, stepper, threads), (Outcome{alone.hash, true}))
                    << mode.name << ' ' << threads;
    }
}

// Denormal numbers that matter: a force that is one moves a body that is light enough, and a place may be
// one.
TEST(FloatModes, denormal_forces_move_light_bodies)
{
    using Limits = std::numeric_limits<dReal>;
    for (int stepper = 0; stepper < kSteppers4; ++stepper)
        for (const FloatMode& mode : kFloatModes) {
            Sim sim;
            const dReal tiny = Limits::min();
            const dBodyID body = sim.body({}, 1, 1), drifting = sim.body({5, 0, 0}, 1, 1);
            dMass light;
            dMassSetParameters(&light, 8 * tiny, 0, 0, 0, 1, 1, 1, 0, 0, 0);
            dBodySetMass(body, &light);
            dBodySetPosition(drifting, 0, 5, 0);
            dBodySetLinearVel(drifting, 10 * tiny, 0, 0);
            bool kept = true, moved = true;
            for (int i = 0; i < 20; ++i) {
                dBodyAddForce(body, tiny / 2, 0, 0);
                const HostMode host(mode, kept);
                moved = step_by(stepper, sim.world) && moved;
            }
            EXPECT_TRUE(moved && kept) << kStepperNames[stepper] << ' ' << mode.name;
            EXPECT_NEAR(double(dBodyGetLinearVel(body)[0]), 20 * 0.01 / 16, 1e-6)
                << kStepperNames[stepper] << ' ' << mode.name;
            EXPECT_NEAR(double(dBodyGetPosition(drifting)[0] / tiny), 2, 1e-3)
                << kStepperNames[stepper] << ' ' << mode.name;
        }
}

// What is refused is refused: a number that is none must not trap in the check.
TEST(FloatModes, bad_numbers_are_refused_where_they_would_trap)
{
    const Messages messages;
    Sim sim;
    const dBodyID body = sim.body({});
    const dGeomID ball = dCreateSphere(sim.space, 1);
    const dReal nan = std::numeric_limits<dReal>::quiet_NaN();
    for (const FloatMode& mode : kFloatModes) {
        bool kept = true;
        int refused = 0;
        {
            const HostMode host(mode, kept);
            refused += dWorldStep(sim.world, nan) == 0;
            refused += dWorldQuickStep(sim.world, nan) == 0;
            refused += dWorldStepFast1(sim.world, nan, 3) == 0;
            refused += dWorldStepHybrid(sim.world, nan) == 0;
            dBodySetPosition(body, nan, 0, 0);
            dBodyAddForce(body, 0, nan, 0);
            dGeomSetPosition(ball, 0, 0, nan);
            dMass mass;
            dMassSetBox(&mass, nan, 1, 1, 1);
        }
        EXPECT_EQ(refused, 4) << mode.name;
        EXPECT_TRUE(kept) << mode.name;
    }
    EXPECT_EQ(messages.count(), 8 * int(std::size(kFloatModes)));
}

#endif

}  // namespace
}  // namespace epode::physics
