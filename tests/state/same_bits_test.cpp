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
    {{0xdb3913f504487713, 0xcee069a4b0d64252},
     {0x4e95b8b3deac5511, 0x68149e02fd247518},
     {0x19c5f23d23913e48, 0x9ea9d6a747f9804c},
     {0xfb03d49c3abb15de, 0xdf9a63f26c53c8cd},
     {0xb6d6280819aa1fcb, 0x501875c6b0c672bf},
     {0xbf808c970fa32d19, 0xc3b7e413a1640b40},
     {0x4dcc749550846fdf, 0x7c1e942319ef0eba},
     {0xf8c3752cd41473c6, 0x6d82db47ca8829fe}},
    {{0xaac7a6dca6a7b4f5, 0x5e0afbbd951cc52d},
     {0x362a5bc67ddc4456, 0xcc1e012ded17fe47},
     {0x75f627b0eca24988, 0x5c6095efb373c75c},
     {0xedda81ab890c9d80, 0x48676efb9d70dcfe},
     {0x05778e17d9fdd2d0, 0x09cc6c957ce07daa},
     {0x9e182f2fdfa90b77, 0xcaff227ef963814f},
     {0x4524df183764e66a, 0x074e5a99261fbadf},
     {0xa45ee51ed0bfb8c0, 0x45209a98fa84d681}},
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
