// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Five scenes, 500 steps, three steppers, contacts by the program and by the world: the bits at the end are
// these, on any number of threads (EPODE_TEST_THREADS, default 3), with any kernels (EPODE_KERNELS) and from
// any compiler; scripts/nightly goes through all of that. After a change of the mathematics that is meant,
// the failing tests print what to put here.
#include <cstdio>
#include <cstdlib>

#include "scenes.h"

namespace epode::physics {
namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSlowed = true;
#else
constexpr bool kSlowed = false;
#endif

constexpr int kLongScenes = 5, kSteps = 500;
const char* const kNames[kLongScenes] = {"pile", "machine", "wall", "figures", "hills"};

// Capsules on balls and hinges, thrown on each other.
void build_figures(Sim& sim)
{
    sim.ground();
    Random random(17);
    for (int figure = 0; figure < 8; ++figure) {
        const V3 at{0.3 * (figure % 3), 0.2 * (figure % 2), 0.5 + 0.7 * figure};
        dBodyID before = sim.capsule(at, 0.12, 0.3, 3);
        for (int limb = 0; limb < 4; ++limb) {
            const double x = at.x + 0.35 * (limb + 1);
            const dBodyID body = sim.capsule({x, at.y, at.z}, 0.08, 0.2, 1);
            const dJointID joint =
                limb % 2 ? dJointCreateHinge(sim.world, nullptr) : dJointCreateBall(sim.world, nullptr);
            dJointAttach(joint, before, body);
            if (limb % 2) {
                dJointSetHingeAnchor(joint, real(x - 0.17), real(at.y), real(at.z));
                dJointSetHingeAxis(joint, 0, 1, 0);
                dJointSetHingeParam(joint, dParamLoStop, -1);
                dJointSetHingeParam(joint, dParamHiStop, 1);
            } else {
                dJointSetBallAnchor(joint, real(x - 0.17), real(at.y), real(at.z));
            }
            const V3 spin = random.point(2), way = random.point(1);  // in this order with every compiler
            velocity(body, way, spin);
            before = body;
        }
    }
}

// Heights of whole numbers of millimetres.
dReal hill(void*, int x, int z) { return real(0.001 * double((x * x * 7 + z * z * 5 + x * z * 3) % 400)); }

struct HillData {
    dHeightfieldDataID id = dGeomHeightfieldDataCreate();
    HillData() { dGeomHeightfieldDataBuildCallback(id, nullptr, hill, 12, 12, 24, 24, 1, 0, 1, 0); }
    HillData(const HillData&) = delete;
    HillData& operator=(const HillData&) = delete;
    ~HillData() { dGeomHeightfieldDataDestroy(id); }
};

void build_hills(Sim& sim, const HillData& data)
{
    const dGeomID field = dCreateHeightfield(sim.space, data.id, 1);
    const dReal up[12] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};  // y of the field is z of the world
    dGeomSetRotation(field, up);
    Random random(23);
    for (int i = 0; i < 24; ++i) {
        const V3 at{random.uniform(-3, 3), random.uniform(-3, 3), 1 + 0.2 * i};
        if (i % 4 == 0) sim.box(at, {0.5, 0.4, 0.3}, 1);
        if (i % 4 == 1) sim.sphere(at, 0.25, 1);
        if (i % 4 == 2) sim.capsule(at, 0.15, 0.4, 1);
        if (i % 4 == 3) sim.cylinder(at, 0.2, 0.4, 1);
    }
}

void build_long(Sim& sim, int scene, const HillData& hills)
{
    if (scene < 3) return build(sim, kScenes[scene]);
    sim.gravity(0, 0, -9.81);
    scene == 3 ? build_figures(sim) : build_hills(sim, hills);
}

int wanted_threads()
{
    const char* wanted = std::getenv("EPODE_TEST_THREADS");
    return wanted ? std::atoi(wanted) : 3;
}

std::uint64_t run(int scene, Stepper stepper, bool world_contacts)
{
    const HillData hills;  // outlives the world's geoms
    Sim sim(stepper);
    sim.substeps = 5;
    dWorldSetStepThreads(sim.world, wanted_threads());
    build_long(sim, scene, hills);
    if (world_contacts) dWorldSetContactSpace(sim.world, sim.space);
    for (int i = 0; i < kSteps; ++i) world_contacts ? sim.advance(0.01) : sim.step(0.01);
    EXPECT_TRUE(finite_state(sim));
    return hash_state(sim);
}

// Of each scene: exact, quick, fast in ODE's way, and the same with world-managed contacts.
constexpr std::uint64_t kGolden[kLongScenes][6] = {
    {0xe39dbf8c18e3311eu, 0x57c3936dadcca626u, 0x5f6351861e830b3du, 0x79a5ff5a4cb5cd5au, 0x277aeee4f37e75d0u,
     0x1f31b4fa4dfef465u},
    {0x7dbdf1b17f3f3468u, 0x759559af14e6837du, 0x3406139ca1cad730u, 0xfa26f86fa15556d7u, 0x3322cd691d6c6a27u,
     0xcb496a0bbb38f258u},
    {0xe0dddcddc477eb9cu, 0x73b4f671adc0e19fu, 0x190c4a65718c9678u, 0x2094c266dcfcf12bu, 0x0d51440aa6c69444u,
     0xeff65416d6ada85fu},
    {0xea268dd3ec043070u, 0x0cc91adf31b34e73u, 0xcae10c485eb4ef39u, 0x8c413440b07dcbddu, 0xeee2f8879a2e7aebu,
     0x0eb74350f025fa4eu},
    {0x16c5b403462cb0bdu, 0xf6ec91e959729a5au, 0xc507aa95e4cb0497u, 0x5d4baafe00f9c562u, 0x395be0f52591cdc9u,
     0x1cacec099b168053u}};

class LongRuns : public testing::TestWithParam<int> {};

TEST_P(LongRuns, end_with_these_bits)
{
    if (kSingle) GTEST_SKIP() << "the table is that of double precision";
    if (kSlowed) GTEST_SKIP() << "takes minutes under a sanitizer; shorter runs are watched";
    const int scene = GetParam();
    std::string now;
    bool same = true;
    for (std::size_t k = 0; k < 6; ++k) {
        const std::uint64_t got = run(scene, kSteppers[k % 3], k >= 3);
        char text[32];
        std::snprintf(text, sizeof text, "%s0x%016llxu", k ? ", " : "", static_cast<unsigned long long>(got));
        now += text;
        same = same && got == kGolden[scene][k];
    }
    EXPECT_TRUE(same) << kNames[scene] << " now: {" << now << "}";
}

INSTANTIATE_TEST_SUITE_P(Scenes, LongRuns, testing::Range(0, kLongScenes),
                         [](const auto& scene) { return std::string(kNames[scene.param]); });

}  // namespace
}  // namespace epode::physics
