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

constexpr Golden kGolden[2][8] = {{{0xf4921cda4a2a44d4, 0x05167d64594ef010},
                                   {0x58748c6919e309cf, 0xab5f42f791f8d286},
                                   {0xd4cf611bf90ad729, 0xd27906bd76238531},
                                   {0xc29ada563f66109b, 0xe83d8f57ca36e16b},
                                   {0xaa1b0cfec745f5a2, 0x93622ea96bccec01},
                                   {0x66309071f8ab889a, 0xd50c7ba17760791a},
                                   {0x5707b3c78ef9320d, 0x35a23944ab40cca3},
                                   {0x011d411dc67929d1, 0x6e76d58047887390}},
                                  {{0x65eb63c107c518ad, 0x2cc754064ede76b1},
                                   {0x24068d7df1f37e1e, 0x103166855b401a50},
                                   {0xed5b53b0b354decb, 0x25bccd4c435d6c13},
                                   {0xfaebb2b9c22d17f8, 0x6b1d147029e3e83a},
                                   {0x9d04ac7775c4870e, 0x03b43bec3a3d2901},
                                   {0x00f26b42465d364d, 0x37b47ef02ea88e60},
                                   {0xff650b7095d1f8b5, 0x851c836148000498},
                                   {0xb7796e46ea23771a, 0x66c916ddafa8413e}}};

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
