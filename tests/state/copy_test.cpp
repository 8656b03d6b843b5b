// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A clone and what is loaded from a file go on with the bits of the original, on every stepper, and describe
// themselves in the same words.
#include <cstdio>
#include <filesystem>
#include <fstream>

#if !defined(_WIN32)
#include <unistd.h>
#endif

#include "copy_scene.h"

namespace epode::states {
namespace {

struct Case {
    Setting setting;
    bool file;
};

class Copies : public testing::TestWithParam<Case> {};

TEST_P(Copies, go_on_with_the_same_bits)
{
    const Messages messages;
    RichScene scene(GetParam().setting);
    for (const int before : {0, 40, 60}) {
        scene.steps(before);
        const Copy copy = GetParam().file ? Copy::loaded(scene) : Copy::cloned(scene);
        ASSERT_TRUE(copy.running.world);
        EXPECT_EQ(text_of(copy.running.world), text_of(scene.world));
        ASSERT_EQ(difference(state_of(copy.running.world), scene.save()), "") << "after " << before;
        const Bytes start = scene.save();
        for (int i = 0; i < 40; ++i) {
            scene.step(), copy.running.step();
            ASSERT_EQ(difference(state_of(copy.running.world), scene.save()), "") << before << ", step " << i;
        }
        ASSERT_TRUE(scene.load(start)) << Messages::last();
    }
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

std::vector<Case> cases()
{
    std::vector<Case> all;
    for (const Stepper stepper : kSteppers)
        for (const bool world_contacts : {true, false})
            for (const bool file : {true, false})
                all.push_back({{.stepper = stepper, .world_contacts = world_contacts, .piles = 4}, file});
    all.push_back({{.stepper = Stepper::kQuick, .exact_rotation = true, .piles = 2, .threads = 3}, true});
    return all;
}

INSTANTIATE_TEST_SUITE_P(Settings, Copies, testing::ValuesIn(cases()), [](const auto& one) {
    const Case& c = one.param;
    return std::string(name_of(c.setting.stepper)) +
           (c.setting.world_contacts ? "_world_contacts" : "_joints") + (c.file ? "_file" : "_clone") +
           (c.setting.threads > 1 ? "_threads" : "");
});

// A copy of a copy is the same file: nothing gets lost on the way.
TEST(Files, of_copies_have_the_same_bytes)
{
    const Messages messages;
    RichScene scene({.stepper = Stepper::kSubsteps});
    scene.steps(30);
    const Bytes file = file_of(scene.world, scene.space);
    const Copy loaded = Copy::loaded(scene), clone = Copy::cloned(scene);
    EXPECT_EQ(difference(file_of(loaded.running.world, loaded.running.space), file), "");
    EXPECT_EQ(difference(file_of(clone.running.world, clone.running.space), file), "");
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

TEST(Clones, have_a_table_of_handles_and_share_meshes_and_user_data)
{
    RichScene scene({.piles = 1});
    int mine = 0;
    dBodySetData(scene.bodies[2], &mine);
    std::vector<dHandlePair> table(std::size_t(dWorldCountHandles(scene.world, scene.space)));
    dSpaceID space = scene.space;
    const dWorldID clone = dWorldClone(scene.world, &space, table.data(), int(table.size()));
    ASSERT_EQ(table[0].original, scene.world);
    ASSERT_EQ(table[0].copy, clone);
    const auto copy_of = [&](void* original) -> void* {
        for (const dHandlePair& pair : table)
            if (pair.original == original) return pair.copy;
        return nullptr;
    };
    const auto body = static_cast<dBodyID>(copy_of(scene.bodies[2]));
    ASSERT_TRUE(body);
    EXPECT_EQ(dBodyGetWorld(body), clone);
    EXPECT_EQ(dBodyGetData(body), &mine);
    EXPECT_EQ(copy_of(dBodyGetFirstGeom(scene.bodies[2])), dBodyGetFirstGeom(body));
    for (const dJointID joint : scene.joints) EXPECT_TRUE(copy_of(joint));
    EXPECT_EQ(dGeomTriMeshGetData(static_cast<dGeomID>(copy_of(scene.grounds[2]))),
              dGeomTriMeshGetData(scene.grounds[2]));
    EXPECT_EQ(dGeomGetSensor(static_cast<dGeomID>(copy_of(scene.sensor))), 1);
    EXPECT_EQ(copy_of(scene.space), space);
    EXPECT_EQ(dWorldGetContactSpace(clone), space);
    dWorldDestroy(clone), dSpaceDestroy(space);
    scene.steps(2);
}

TEST(Clones, have_the_behaviour_of_the_original)
{
    RichScene scene({.stepper = Stepper::kQuick, .piles = 1});
    dWorldSetBehaviour(scene.world, dBehaviour016);
    EXPECT_EQ(dWorldGetBehaviour(Copy::cloned(scene).running.world), dBehaviour016);
    EXPECT_EQ(dWorldGetBehaviour(Copy::loaded(scene).running.world), dBehaviour016);
}

// dJointAttach(joint, 0, 0) and a destroyed body leave a joint reversed that has no bodies.
TEST(Clones, have_joints_that_have_lost_their_bodies)
{
    const Messages messages;
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    for (int i = 0; i < 3; ++i) {
        const dJointID joint = dJointCreateHinge(world, nullptr);
        dJointAttach(joint, i == 1 ? body : nullptr, i == 2 ? body : nullptr);
        if (i == 1) dJointAttach(joint, nullptr, nullptr);
    }
    dBodyDestroy(body);
    Bytes state(dWorldGetStateSize(world)), file = file_of(world, nullptr);
    ASSERT_EQ(dWorldGetState(world, state.data(), state.size()), 1);
    for (const dWorldID copy :
         {dWorldClone(world, nullptr, nullptr, 0), dWorldLoadFromBuffer(file.data(), file.size(), nullptr)}) {
        ASSERT_TRUE(copy) << Messages::last();
        EXPECT_EQ(difference(state_of(copy), state), "");
        EXPECT_EQ(file_of(copy, nullptr), file);
        dWorldDestroy(copy);
    }
    dWorldDestroy(world);
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

TEST(Files, are_written_whole_and_read_again)
{
    const Messages messages;
    RichScene scene({.stepper = Stepper::kQuick, .piles = 1});
    const std::string path = testing::TempDir() + "epode_world_file_test.epw";
    ASSERT_EQ(dWorldSave(scene.world, scene.space, path.c_str()), 1) << Messages::last();
    ASSERT_EQ(dWorldSave(scene.world, 0, path.c_str()), 1) << "over the old one";
    dSpaceID space = nullptr;
    const dWorldID world = dWorldLoad(path.c_str(), &space);
    ASSERT_TRUE(world) << Messages::last();
    EXPECT_EQ(difference(state_of(world), scene.save()), "");
    EXPECT_EQ(dWorldGetContactSpace(world), space);
    dWorldDestroy(world), dSpaceDestroy(space);
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
#if !defined(_WIN32) && !defined(__wasm__)
    const std::string link = path + ".link";
    (void)std::remove(link.c_str());
    ASSERT_EQ(::symlink(path.c_str(), link.c_str()), 0);
    std::ofstream(path) << "older";
    EXPECT_EQ(dWorldSave(scene.world, scene.space, link.c_str()), 1);
    EXPECT_TRUE(std::filesystem::is_symlink(link)) << "a link stays one";
    EXPECT_GT(std::filesystem::file_size(path), 100u) << "what it leads to is written";
    std::remove(link.c_str());
#endif
    EXPECT_EQ(dWorldSave(scene.world, 0, "/nowhere/at/all"), 0);
    EXPECT_NE(Messages::last().find("No such file"), std::string::npos) << Messages::last();
    EXPECT_EQ(dWorldLoad("/nowhere/at/all", nullptr), nullptr);
    EXPECT_EQ(dWorldLoad("/dev/zero", nullptr), nullptr);
    EXPECT_NE(Messages::last().find("regular file"), std::string::npos) << Messages::last();
    std::remove(path.c_str());
}

}  // namespace
}  // namespace epode::states
