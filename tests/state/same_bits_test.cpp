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

constexpr Golden kGolden[2][8] = {{{0xcfc47b9c733600f0, 0xc8940ca83bd403a6},
                                   {0xb85c18613425843f, 0xf46f9c49a2fd4d1e},
                                   {0xfabf6fa2ab9b32e1, 0x5faef3141c78ca8c},
                                   {0x2b1efdc9fac97e50, 0xd8785d3a866dec13},
                                   {0x9e32cb793f0a3e97, 0x65262967224a638a},
                                   {0x11046c466e1c64ce, 0xb0cabd691799d7e0},
                                   {0xe5e9bd66e4a0b7bc, 0x0ae621bc36418722},
                                   {0x9ff530a8bbe41f8f, 0xe937b13066b36fff}},
                                  {{0xc678c118729565cd, 0xc5bc5b7d8ccabeba},
                                   {0x74a1928343a38b85, 0xdfbbb18ada7af84a},
                                   {0x738a0faf7551a6a6, 0x63c5342c84192de6},
                                   {0xeceba0cf7971710c, 0x1a7f96670167c552},
                                   {0xa9996e33eb444bdd, 0x872b0268b74e7820},
                                   {0xb77863eadffd0ea2, 0xa58fab2a6a969838},
                                   {0xa7941f05cefc51a1, 0x944bb845b0875afc},
                                   {0xbaebfb9a85f6ceba, 0xe0f6c1a3399425aa}}};

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
