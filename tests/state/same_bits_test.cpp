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
    {{0x548e04cc554656ff, 0xc0a74135c3ddab91},
     {0xfbcf709b030713a7, 0xe56360b27ffdf6a2},
     {0xd54b7c62e94da055, 0x9aeaa0f02c07469b},
     {0xe6de8f7e49e0f0a1, 0x4227b35a2427335c},
     {0x67f5ea6a860aa940, 0xb5a9262d68bb8680},
     {0x65b32fa82cd2d782, 0x34f74b1785a8dba6},
     {0x509ef1e230e706af, 0xe6fcb02311737342},
     {0xe32a5a1f25f5aaaa, 0x99eed8c134f4f045}},
    {{0xec18b862bcdf8e95, 0x62f01e2b894ac02f},
     {0x40ce28ac1020e5e6, 0xd9b9e353ba5bfe2b},
     {0x208ad923b7707980, 0xc407bc9f80b7af8e},
     {0xea40b4d6a0751ddb, 0x7e74c3d8de8eea85},
     {0x02ccf209e8c8db5c, 0x4d83af37ee0b9591},
     {0x4f96f02b050dc679, 0xba7d4b7e31321f53},
     {0x4b7d68f42f214443, 0xf51c3878c6d50fc2},
     {0xd32313e7dca9d0ab, 0x4f6957e117039117}},
};

class SameBits : public testing::TestWithParam<int> {};

TEST_P(SameBits, on_every_machine_and_any_number_of_threads)
{
    const int index = GetParam();
    const Golden& golden = kGolden[sizeof(dReal) == 4][index];
    for (const int threads : {1, 3}) {
        const Setting setting{
            .stepper = kSteppers[index % 4], .managed = index < 4, .piles = 20, .threads = threads};
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
