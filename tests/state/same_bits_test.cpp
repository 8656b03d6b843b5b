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

constexpr Golden kGolden[2][8] = {{{0x29261280a5570601, 0xc8c5fc5ad9bbd44d},
                                   {0x466bb9aa7ff3f5f7, 0x55e8fad8ce2635e5},
                                   {0x7924e432361e3357, 0x4e42e2d845ba4803},
                                   {0x239c6ca034d41c05, 0xefd6f78b114bcdbd},
                                   {0xb08a8440b868643a, 0x82fcc666b3ef1054},
                                   {0x394926bfe46a1928, 0xd2f1fafc52c644e0},
                                   {0xc813878c5d14de0d, 0x63e536918b9af4b5},
                                   {0x3bc3ffdcc7710042, 0x55f9ac85dff37357}},
                                  {{0x65eb63c107c518ad, 0x3fc8aa80a5deb298},
                                   {0x24068d7df1f37e1e, 0x103166855b401a50},
                                   {0xa8940c956becddfd, 0xc8b4ebecd06fc319},
                                   {0x47db9e32c97297b5, 0xb0986ded33bf930b},
                                   {0x9d04ac7775c4870e, 0x728e63052d823f35},
                                   {0x00f26b42465d364d, 0xeee240e2cd838fb2},
                                   {0x6d614bb4b762f82d, 0x6bfb8a68596f00ac},
                                   {0x512450bc341d859e, 0x577f5f4833c2a183}}};

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
