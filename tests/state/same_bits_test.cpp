// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States are the same bytes on every machine: golden hashes after some steps, and after more that start from
// what was saved. CTest runs this with each set of instructions (EPODE_KERNELS), other builds with other
// compilers. A change of results or of the format moves them.
#include "golden/golden.h"
#include "scene.h"

namespace epode::states {
namespace {

std::uint64_t fnv(const Bytes& bytes)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
    return hash;
}

class SameBits : public testing::TestWithParam<int> {};

TEST_P(SameBits, on_every_machine_and_any_number_of_threads)
{
    const int index = GetParam();
    const std::string name = std::string("state/") + name_of(kSteppers[index % 4]) +
                             (index < 4 ? "/world_contacts/" : "/contact_joints/"),
                      precision = sizeof(dReal) == 4 ? "/single" : "/double";
    for (const int threads : {1, 3}) {
        const Setting setting{
            .stepper = kSteppers[index % 4], .world_contacts = index < 4, .piles = 20, .threads = threads};
        Scene scene(setting), other(setting);
        scene.steps(90);
        const Bytes saved = scene.save();
        ASSERT_TRUE(other.load(saved));
        ASSERT_EQ(dWorldSetHistory(other.world, 40), 1);
        other.steps(40);
        const Bytes later = other.save();
        ASSERT_EQ(dWorldRollBack(other.world, 40), 1);
        EXPECT_EQ(difference(other.save(), saved), "");
        other.steps(40);
        EXPECT_EQ(difference(other.save(), later), "");
        EXPECT_TRUE(golden::is_golden(name + "saved" + precision, fnv(saved))) << threads;
        EXPECT_TRUE(golden::is_golden(name + "later" + precision, fnv(later))) << threads;
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, SameBits, testing::Range(0, 8));

}  // namespace
}  // namespace epode::states
