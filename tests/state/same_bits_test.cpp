// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States are the same bytes on every machine: hashes as literals, after some steps, and after more that start
// from what was saved. CTest runs this with each set of instructions (EPODE_KERNELS), other builds with other
// compilers. A change of results or of the format changes them: print the new ones with
// EPODE_PRINT_HASHES=1, and say why in the commit.
#include <cinttypes>
#include <cstdio>
#include <cstdlib>

#include "scene.h"

namespace epode::states {
namespace {

std::uint64_t fnv(const Bytes& bytes)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (const unsigned char byte : bytes) hash = (hash ^ byte) * 0x100000001b3u;
    return hash;
}

struct Golden {
    std::uint64_t saved, later;
};

constexpr Golden kGolden[2][8] = {
    {{0xd98243acf4b3d4a6, 0xef75b8b512267fa8},
     {0xfbcf709b030713a7, 0xe56360b27ffdf6a2},
     {0xc0583c03a8e89826, 0x88d0cf1932967910},
     {0x9ddab1337c824688, 0x6897307b43320330},
     {0xce04823d9cfd8a77, 0xc1eefea7890aa431},
     {0x9c029b6c23d309b1, 0x128765de9ec896a2},
     {0x14bd25456457ee8f, 0x241bbd8ffb3e1a7e},
     {0x5c394fcd09668bcf, 0x5b30dc017c4d52f1}},
    {{0x1fba6016a9fc344d, 0x66a0fbe54834251d},
     {0xec296d43939069d4, 0xd3c2efa8a0dd9422},
     {0x163480238bc6da46, 0x0e7b526c318d9c1e},
     {0x4bed81bdf71f2e36, 0x908b95e31d9c1082},
     {0x8adc3e990dfa9368, 0x9ba45e091567b610},
     {0xd237c1c025e4b6aa, 0x2f036e279ff80f72},
     {0xf74abaf31007bfa0, 0x39e2f1a1220e1ff3},
     {0x00f376b7b291a901, 0x805fb268b556a9b9}},
};

class SameBits : public testing::TestWithParam<int> {};

TEST_P(SameBits, on_every_machine_and_any_number_of_threads)
{
    const int index = GetParam();
    const Golden& golden = kGolden[sizeof(dReal) == 4][index];
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
        if (std::getenv("EPODE_PRINT_HASHES"))
            std::printf("HASH {0x%016" PRIx64 ", 0x%016" PRIx64 "},\n", fnv(saved), fnv(later));
        EXPECT_EQ(fnv(saved), golden.saved) << threads;
        EXPECT_EQ(fnv(later), golden.later) << threads;
    }
}

INSTANTIATE_TEST_SUITE_P(Settings, SameBits, testing::Range(0, 8));

}  // namespace
}  // namespace epode::states
