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

constexpr Golden kGolden[2][8] = {{{0x1f7fba8718db835e, 0x23d270493dbf1cde},
                                   {0xfd3d859e5686b9e1, 0x294ec6242694c221},
                                   {0x7dd6a6babdf0aabf, 0xf5b34ef8dc15366e},
                                   {0x2ed00dfdc7f2a7b9, 0xe8a89aa102d8159c},
                                   {0xbb373b17c1917848, 0x61e56455d813a82a},
                                   {0x42cfe3509fde1949, 0x55eb9608f89022d8},
                                   {0xb614de0cbce498f5, 0x29314059a89bec85},
                                   {0xcb85957d4a7de7eb, 0xf61845e3403272f8}},
                                  {{0x64c2d39453277569, 0x492c57956792288e},
                                   {0x6cee88ba47eb9c17, 0xb84127e7c64b3b49},
                                   {0x862ecdb546eaeaf5, 0x037507546c72a2dc},
                                   {0xa0b53d02da29f1f7, 0xa51ba8b0690c20ad},
                                   {0x1da17587b31853d6, 0xaf1bcefa47a6e115},
                                   {0xc270a2fdcb9ffd40, 0xb400a41fa912358d},
                                   {0xd4f78c3d7320ec8d, 0x892884d0b0de6fca},
                                   {0x42d973ddddf55eda, 0x683b985664964037}}};

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
