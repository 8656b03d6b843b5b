// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world that is given its state back goes on as it did: the states of later steps, which hold all that
// steps read, have the same bytes. So does another world of the same structure, on any number of threads.
#include "../effort.h"
#include "scene.h"

namespace epode::states {
namespace {

std::string describe(const Setting& s, int at)
{
    return std::string(name_of(s.stepper)) + (s.world_contacts ? " managed" : " ODE's way") + " from step " +
           std::to_string(at);
}

std::vector<Setting> settings()
{
    std::vector<Setting> all;
    for (const Stepper stepper : kSteppers)
        for (const bool world_contacts : {true, false})
            all.push_back({.stepper = stepper, .world_contacts = world_contacts});
    all.push_back({.exact_rotation = true});
    all.push_back({.stepper = Stepper::kSubsteps, .sleeps = false});
    all.push_back({.stepper = Stepper::kSubsteps, .joints = false, .piles = 40});
    if (!tests::kSanitized) return all;
    return {all[0], all[3], all[4], all[7]};  // each stepper once, both ways of contacts
}

TEST(State, goes_on_with_the_same_bits)
{
    const Messages messages;
    for (const Setting& setting : settings()) {
        Scene scene(setting), other(setting);
        for (const int at : {0, 1, 40, 150, 400}) {
            scene.steps(at == 0 ? 0 : at == 1 ? 1 : at == 40 ? 39 : at == 150 ? 110 : 250);
            const Bytes begin = scene.save();
            std::vector<Bytes> later;
            for (const int n : {1, 2, 17}) scene.steps(n), later.push_back(scene.save());
            for (Scene* s : {&scene, &other}) {
                ASSERT_TRUE(s->load(begin)) << describe(setting, at) << ": " << Messages::last();
                ASSERT_EQ(difference(s->save(), begin), "")
                    << describe(setting, at) << ": not the same again";
                std::size_t k = 0;
                for (const int n : {1, 2, 17}) {
                    s->steps(n);
                    ASSERT_EQ(difference(s->save(), later[k++]), "")
                        << describe(setting, at) << " after " << n << (s == &other ? ", another world" : "");
                }
            }
            ASSERT_TRUE(scene.load(begin));
        }
        EXPECT_TRUE(!setting.sleeps || scene.asleep() > 5) << describe(setting, 400);
    }
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

TEST(State, goes_on_with_the_same_bits_on_any_number_of_threads)
{
    for (const Stepper stepper : kSteppers) {
        Scene one({.stepper = stepper, .piles = 60});
        one.steps(60);
        const Bytes begin = one.save();
        one.steps(25);
        const Bytes end = one.save();
        for (const int threads : {2, 3, 8}) {
            if (tests::kSanitized && threads > 2) break;
            Scene many({.stepper = stepper, .piles = 60, .threads = threads});
            ASSERT_TRUE(many.load(begin));
            many.steps(25);
            ASSERT_EQ(difference(many.save(), end), "") << name_of(stepper) << ' ' << threads;
        }
    }
}

}  // namespace
}  // namespace epode::states
