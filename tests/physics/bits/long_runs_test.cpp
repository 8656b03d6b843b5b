// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Five scenes, 500 steps, three steppers, contacts by the program and by the world: the bits at the end are
// these, on any number of threads (EPODE_TEST_THREADS, default 3), with any kernels (EPODE_KERNELS) and from
// any compiler; scripts/nightly goes through all of that.
#include <cstdlib>

#include "golden/golden.h"
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

class LongRuns : public testing::TestWithParam<int> {};

TEST_P(LongRuns, end_with_these_bits)
{
    if (kSingle) GTEST_SKIP() << "the table is that of double precision";
    if (kSlowed) GTEST_SKIP() << "takes minutes under a sanitizer; shorter runs are watched";
    const int scene = GetParam();
    for (const bool world_contacts : {false, true})
        for (const Stepper stepper : kSteppers) {
            const std::string name = std::string("physics/long_runs/") + kNames[scene] + '/' +
                                     name_of(stepper) + (world_contacts ? "/world_contacts" : "");
            EXPECT_TRUE(golden::is_golden(name, run(scene, stepper, world_contacts)));
        }
}

INSTANTIATE_TEST_SUITE_P(Scenes, LongRuns, testing::Range(0, kLongScenes),
                         [](const auto& scene) { return std::string(kNames[scene.param]); });

}  // namespace
}  // namespace epode::physics
