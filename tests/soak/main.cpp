// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// stepper_soak [--seconds N] [--seed S] [--worlds N] [--steps N] [--preset game|robot] [--size H]
// One world after the other, each for some ten thousand steps, of which each is by another stepper, of another size, and between
// which settings, bodies and joints change; or all steps are those of a preset, of one size. The first thing that is wrong ends it.
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <string>

#include "soaked_world.h"

namespace {

struct Soak {
    long seconds = 3600, worlds = 1000000, steps = 20000;
    std::uint64_t seed = 1;
    epode::soak::Habit habit;
};

void read_preset(const std::string& name, epode::soak::Habit& habit)
{
    habit.has_preset = true;
    habit.preset = name == "robot" ? dDefaultsRobot : dDefaultsGame;
}

Soak read(int count, char** words)
{
    Soak its;
    for (int i = 1; i + 1 < count; i += 2) {
        const std::string word = words[i];
        if (word == "--seconds") its.seconds = std::atol(words[i + 1]);
        if (word == "--worlds") its.worlds = std::atol(words[i + 1]);
        if (word == "--steps") its.steps = std::atol(words[i + 1]);
        if (word == "--seed") its.seed = std::strtoull(words[i + 1], nullptr, 10);
        if (word == "--preset") read_preset(words[i + 1], its.habit);
        if (word == "--size") its.habit.size = std::atof(words[i + 1]);
    }
    return its;
}

// False: something is wrong.
bool live(std::uint64_t seed, const Soak& soak, std::time_t end)
{
    epode::soak::SoakedWorld world(seed, soak.habit);
    std::string wrong;
    for (long i = 0; i < soak.steps && wrong.empty() && std::time(nullptr) < end; ++i) {
        if (i % 25 == 0) world.change();
        wrong = world.step();
    }
    std::printf(
        "seed %llu: %ld steps (%ld exact, %ld hybrid, %ld quick, %ld in substeps), %ld again, %ld clones, "
        "%ld files, "
        "gain at most %.3g J, at most %.3g m/s, %ld contained\n",
        (unsigned long long)seed, world.steps, world.by_stepper[0], world.by_stepper[1], world.by_stepper[2],
        world.by_stepper[3], world.states, world.copies, world.files, world.largest_gain, world.fastest,
        world.contained);
    if (!wrong.empty()) std::printf("step %ld: %s\n", world.steps, wrong.c_str());
    std::fflush(stdout);
    return wrong.empty();
}

}  // namespace

int main(int count, char** words)
{
    const Soak soak = read(count, words);
    const std::time_t end = std::time(nullptr) + soak.seconds;
    dInitODE2(0);
    bool good = true;
    for (long i = 0; good && i < soak.worlds && std::time(nullptr) < end; ++i)
        good = live(soak.seed + std::uint64_t(i), soak, end);
    dCloseODE();
    return good ? 0 : 1;
}
