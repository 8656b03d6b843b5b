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

constexpr Golden kGolden[2][8] = {{{0x357853af5f3e8a0f, 0x15d8302b97ba88c7},
                                   {0xe05d1ba6d287604c, 0x3fa5d91f0dacda74},
                                   {0x58a02f1cac5407a2, 0x86660d02beab13eb},
                                   {0x7f49a401ab7d3eb0, 0x4196658b1e735995},
                                   {0x24086652d3f05001, 0xd0e3900b068f371b},
                                   {0xd10e4193131c6694, 0x9008f935f1b0ce4d},
                                   {0x67bacff6c1a6190c, 0x4ed71faa7e112214},
                                   {0x7988c4a09d623dfe, 0x233a5f325fa8a00d}},
                                  {{0x5bd7820f4a5c8cb0, 0x3902e627b17d1673},
                                   {0xad047417bd0e6c07, 0x5877d84cef7e2911},
                                   {0x1bc18893bb169c8d, 0x74bd079bbdc43b77},
                                   {0x79860f8a2db02494, 0xa108796d30ec758b},
                                   {0xfcededce350817e9, 0xdf8fe72d3cb6d598},
                                   {0x7b490f75813de36c, 0x65d786e4db354897},
                                   {0x0411f549551f6618, 0x8d633525ad94c354},
                                   {0xab5186cbbddcfbb5, 0xb46d4e5f707b2430}}};

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
