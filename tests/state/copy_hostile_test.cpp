// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Files that are no worlds, and clones and files without memory: refused, with nothing left behind.
#include <unistd.h>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <utility>

#include "../effort.h"
#include "checksum.h"
#include "copy_scene.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"  // transforms are part of the interface

namespace epode::states {
namespace {

constexpr std::size_t kHeader = 32;

void seal(Bytes& file)
{
    std::uint64_t structure;
    std::memcpy(&structure, &file[8], 8);
    const std::uint64_t content = file.size() - kHeader;
    structure = std::min(structure, content);
    const std::uint64_t state = content - structure, sum = checksum(&file[kHeader], content);
    std::memcpy(&file[8], &structure, 8), std::memcpy(&file[16], &state, 8), std::memcpy(&file[24], &sum, 8);
}

dWorldID load(const Bytes& file, dSpaceID* space = nullptr)
{
    return dWorldLoadFromBuffer(file.data(), file.size(), space);
}

void expect_refused(const Bytes& file, const char* text)
{
    const int before = Messages::count();
    EXPECT_EQ(load(file), nullptr) << text;
    EXPECT_EQ(Messages::count(), before + 1);
    EXPECT_NE(Messages::last().find(text), std::string::npos) << Messages::last();
}

// A geom's count of changes comes back to what it was when its shape was last looked at: the shape is another one all the same.
TEST(WorldFiles, have_no_height_field_that_is_gone)
{
    const Messages messages;
    const unsigned char heights[4] = {0, 1, 2, 3};
    const dHeightfieldDataID field = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildByte(field, heights, 1, 1, 1, 2, 2, 1, 0, 1, 0);
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    const dGeomID geom = dCreateHeightfield(space, field, 1), held = dCreateHeightfield(nullptr, field, 1);
    const dGeomID transform = dCreateGeomTransform(space);
    dGeomTransformSetCleanup(transform, 1);
    dGeomTransformSetGeom(transform, held);
    const dWorldID world = dWorldCreate();
    dWorldSetContactSpace(world, space);
    EXPECT_GT(dWorldGetStateSize(world), 0u);
    for (int again = 0; again < 3; ++again) {
        dGeomHeightfieldSetHeightfieldData(geom, field);
        if (again == 0) dGeomHeightfieldDataDestroy(field);
        const Bytes file = file_of(world, space);
        dSpaceID copies = nullptr;
        const dWorldID copy = load(file, &copies);
        ASSERT_NE(copy, nullptr) << Messages::last();
        dWorldDestroy(copy), dSpaceDestroy(copies);
    }
    dWorldDestroy(world), dSpaceDestroy(space);
}

// What is remembered of a transform's shape is forgotten where the rules of what it holds change.
TEST(WorldFiles, have_the_bits_of_what_a_transform_holds)
{
    const Messages messages;
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    const dGeomID held = dCreateSphere(nullptr, 1), transform = dCreateGeomTransform(nullptr);
    dGeomTransformSetCleanup(transform, 1);
    dGeomTransformSetGeom(transform, held);
    dGeomSetBody(transform, body);
    EXPECT_GT(dWorldGetStateSize(world), 0u);
    dGeomSetCategoryBits(held, 3);
    const Bytes file = file_of(world, nullptr);
    const dWorldID copy = load(file);
    ASSERT_NE(copy, nullptr) << Messages::last();
    dBodyID its_body = nullptr;
    ASSERT_EQ(dWorldGetBodies(copy, &its_body, 1), 1);
    const dGeomID its = dBodyGetFirstGeom(its_body);
    EXPECT_EQ(dGeomGetCategoryBits(dGeomTransformGetGeom(its)), 3ul);
    dGeomDestroy(its), dGeomDestroy(transform);
    dWorldDestroy(copy), dWorldDestroy(world);
}

TEST(WorldFileRefusals, name_the_first_fault)
{
    const Messages messages;
    RichScene scene({.piles = 1});
    const Bytes file = file_of(scene.world, scene.space);
    Bytes other = file;
    other[0] ^= 1;
    expect_refused(other, "these bytes are no world");
    other = file, other[4] = 9;
    expect_refused(other, "a world of version 9; this library reads versions up to 6");
    other = file, other[6] = sizeof(dReal) == 8 ? 4 : 8;
    expect_refused(other, "a world with numbers of");
    other = file, other[file.size() / 2] ^= 4;
    expect_refused(other, "checksum");
    other.resize(file.size() - 8);
    expect_refused(other, "of which");
    other.resize(10);
    expect_refused(other, "10 bytes are no world");
    other = file, other[kHeader] = other[kHeader + 7] = 0xff, other[kHeader + 6] = 0xff, seal(other);
    expect_refused(other, "not finite");
    dSpaceID space = reinterpret_cast<dSpaceID>(scene.grounds[0]);
    EXPECT_EQ(dWorldClone(scene.world, &space, nullptr, 0), nullptr);
    EXPECT_NE(Messages::last().find("not a space"), std::string::npos) << Messages::last();
    const dSpaceID elsewhere = dSimpleSpaceCreate(nullptr);
    space = elsewhere;
    EXPECT_EQ(dWorldClone(scene.world, &space, nullptr, 0), nullptr);
    EXPECT_EQ(space, elsewhere);
    EXPECT_NE(Messages::last().find("contact space"), std::string::npos) << Messages::last();
    dSpaceDestroy(elsewhere);
}

void try_in_step(dBodyID body)
{
    const dWorldID world = dBodyGetWorld(body);
    EXPECT_EQ(dWorldClone(world, nullptr, nullptr, 0), nullptr);
    EXPECT_EQ(dWorldCountHandles(world, nullptr), 0);
    EXPECT_EQ(dWorldSaveToBuffer(world, nullptr, nullptr, 0), 0u);
    EXPECT_EQ(dWorldSave(world, nullptr, "never"), 0);
    EXPECT_NE(Messages::last().find("during a step"), std::string::npos);
}

TEST(WorldFileRefusals, during_a_step)
{
    const Messages messages;
    Scene scene({.piles = 1});
    dBodySetMovedCallback(scene.bodies[0], try_in_step);
    scene.step();
    EXPECT_EQ(Messages::count(), 4);
}

// What a height function tries while its world is saved or restored.
struct Hills {
    Hills()
    {
        heights = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildCallback(heights, this, height, 8, 8, 4, 4, 1, 0, 1, 0);
        dGeomHeightfieldDataSetBounds(heights, -1, 1);
        field = dCreateHeightfield(space, heights, 1);
        dWorldSetContactSpace(world, space);
        for (dBodyID& b : body) b = dBodyCreate(world);
        dGeomSetBody(ball, body[0]);
        dJointAttach(joint, body[0], body[1]);
        dGeomSetSensor(ball, 1);
        dEventSettings events;
        dEventSettingsInit(&events, sizeof events);
        events.kinds = ~0u >> (32 - 6);
        dWorldSetEventSettings(world, &events);
        dWorldSetHistory(world, 4);
        for (int i = 0; i < 2; ++i) dWorldStepHybrid(world, dReal(0.01));
    }
    ~Hills()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
        dGeomHeightfieldDataDestroy(heights);
    }
    static dReal height(void* user, int, int)
    {
        Hills& h = *static_cast<Hills*>(user);
        if (!std::exchange(h.acts, false)) return 0;
        const int before = Messages::count();
        dWorldDestroy(h.world);
        dBodyDestroy(h.body[0]), dJointDestroy(h.joint), dJointAttach(h.joint, h.body[1], h.body[0]);
        EXPECT_EQ(dWorldStep(h.world, dReal(0.01)) + dWorldStepFast1(h.world, dReal(0.01), 4), 0);
        EXPECT_EQ(dWorldSaveToBuffer(h.world, nullptr, nullptr, 0), 0u);
        EXPECT_EQ(dWorldRollBack(h.world, 1), 0);
        EXPECT_EQ(dWorldSetHistory(h.world, 0), 0);
        EXPECT_EQ(Messages::count(), before + 9) << Messages::last();
        EXPECT_NE(Messages::last().find("while the world is saved, copied or restored"), std::string::npos);
        for (int i = 0; i < 200; ++i) dBodyCreate(h.world);
        dBodySetPosition(h.body[1], 5, 5, 5);
        h.acted = true;
        return 0;
    }

    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dHeightfieldDataID heights;
    dGeomID field, ball = dCreateSphere(space, 1);
    dBodyID body[2];
    dJointID joint = dJointCreateBall(world, nullptr);
    bool acts = false, acted = false;
};

TEST(HeightFunctions, cannot_tear_a_file)
{
    const Messages messages;
    Hills hills;
    Bytes file(1 << 20);
    hills.acts = true;
    file.resize(dWorldSaveToBuffer(hills.world, nullptr, file.data(), file.size()));
    EXPECT_TRUE(hills.acted);
    dSpaceID space = nullptr;
    const dWorldID loaded = load(file, &space);
    ASSERT_NE(loaded, nullptr) << Messages::last();
    EXPECT_EQ(dWorldGetBodies(loaded, nullptr, 0), 202) << "those that the function has made";
    dBodyID bodies[2];
    dWorldGetBodies(loaded, bodies, 2);
    EXPECT_EQ(dBodyGetPosition(bodies[1])[0], 5) << "where the function has put it";
    dWorldDestroy(loaded);
    dSpaceDestroy(space);
}

TEST(HeightFunctions, cannot_change_a_world_that_is_restored)
{
    const Messages messages;
    Hills hills;
    Bytes state(dWorldGetStateSize(hills.world));
    dWorldGetState(hills.world, state.data(), state.size());
    hills.acts = true;
    EXPECT_EQ(dWorldSetState(hills.world, state.data(), state.size()), 1) << Messages::last();
    EXPECT_TRUE(hills.acted);
}

TEST(HeightFunctions, cannot_change_a_world_that_is_rolled_back)
{
    const Messages messages;
    Hills hills;
    hills.acts = true;
    EXPECT_EQ(dWorldRollBack(hills.world, 1), 1) << Messages::last();
    EXPECT_TRUE(hills.acted);
    dWorldStepHybrid(hills.world, dReal(0.01));
}

TEST(HeightFunctions, are_not_called_by_clones)
{
    const Messages messages;
    Hills hills;
    dSpaceID space = hills.space;
    hills.acts = true;
    const dWorldID clone = dWorldClone(hills.world, &space, nullptr, 0);
    ASSERT_NE(clone, nullptr) << Messages::last();
    EXPECT_FALSE(hills.acted);
    hills.acts = false;
    dWorldDestroy(clone);
    dSpaceDestroy(space);
}

TEST(WorldFileRefusals, a_body_of_another_world)
{
    const Messages messages;
    const Scene scene({.piles = 1});
    const dWorldID other = dWorldCreate();
    const dGeomID stranger = dCreateSphere(scene.space, 1);
    dGeomSetBody(stranger, dBodyCreate(other));
    dSpaceID space = scene.space;
    EXPECT_EQ(dWorldSaveToBuffer(scene.world, scene.space, nullptr, 0), 0u);
    EXPECT_NE(Messages::last().find("on a body of another world"), std::string::npos) << Messages::last();
    EXPECT_EQ(dWorldSave(scene.world, scene.space, "never"), 0);
    EXPECT_EQ(dWorldClone(scene.world, &space, nullptr, 0), nullptr);
    EXPECT_EQ(dWorldCountHandles(scene.world, scene.space), 0);
    EXPECT_EQ(Messages::count(), 4);
    EXPECT_NE(Messages::last().find("on a body of another world"), std::string::npos) << Messages::last();
    dGeomDestroy(stranger);
    EXPECT_FALSE(file_of(scene.world, scene.space).empty());
    dWorldDestroy(other);
}

void destroy(dWorldID world, dSpaceID space)
{
    const Running running{world, space, dJointGroupCreate(0), Stepper::kSubsteps, true};
    for (int i = 0; i < 2; ++i) running.step();
    dJointGroupDestroy(running.contacts);
    dWorldDestroy(world);
    if (space) dSpaceDestroy(space);
}

void mutate(Bytes& file, std::mt19937& random)
{
    const auto place = [&] { return kHeader + random() % (file.size() - kHeader); };
    switch (random() % 5) {
        case 0:
            file[place()] ^= static_cast<unsigned char>(1u << random() % 8);
            break;
        case 1:
            file[place()] = static_cast<unsigned char>(random());
            break;
        case 2: {
            const std::uint32_t words[] = {
                0, ~0u, 1, 0x7fffffff, 0x80000000, 0x7ff00000, std::uint32_t(random())};
            std::memcpy(&file[std::min(place(), file.size() - 4)], &words[random() % 7], 4);
            break;
        }
        case 3:
            file.resize(file.size() - 8 * (random() % 4));
            break;
        default: {
            const std::size_t from = place(), to = place();
            std::memmove(&file[to], &file[from], std::min(file.size() - std::max(from, to), std::size_t(24)));
        }
    }
}

int mutations()
{
    const char* wanted = std::getenv("EPODE_STATE_MUTATIONS");
    return wanted ? std::atoi(wanted) / 4 : tests::effort(1500);
}

// Changed bytes under a right checksum: somebody wants to do harm.
TEST(HostileWorldFiles, are_refused_or_taken_without_harm)
{
    const Messages messages;
    std::mt19937 random(11);
    RichScene scene({.stepper = Stepper::kSubsteps, .piles = 2});
    scene.steps(20);
    const Bytes good = file_of(scene.world, scene.space);
    int taken = 0, refused = 0;
    for (int i = 0; i < mutations(); ++i) {
        Bytes file = good;
        mutate(file, random);
        seal(file);
        dSpaceID space = nullptr;
        const int before = Messages::count();
        if (const dWorldID world = load(file, &space)) {
            destroy(world, space);
            ++taken;
        } else {
            ++refused;
            ASSERT_EQ(Messages::count(), before + 1);
        }
    }
    EXPECT_GT(taken, mutations() / 20);
    EXPECT_GT(refused, mutations() / 20);
    EXPECT_TRUE(file_of(scene.world, scene.space) == good);
}

// Of memory: what is allowed, what is in use.
long g_left = -1, g_live = 0, g_taken = 0;

void* alloc(dsizeint size)
{
    if (g_left == 0) return nullptr;
    if (g_left > 0) --g_left;
    ++g_live, g_taken += long(size);
    return std::malloc(size);
}

void* grow(void* block, dsizeint, dsizeint size)
{
    if (g_left == 0) return nullptr;
    if (g_left > 0) --g_left;
    return std::realloc(block, size);
}

void give(void* block, dsizeint)
{
    if (block) --g_live;
    std::free(block);
}

// Calls it with more and more allocations that succeed, until it does. Pools keep the memory of their
// objects, so what is in use is compared with what was when the same objects had been there before.
template <typename Make>
void expect_clean_failures(const RichScene& scene, Make&& make)
{
    const Bytes before = file_of(scene.world, scene.space);
    ASSERT_TRUE(make());  // pools are filled now
    int failures = 0;
    for (long allowed = 0; allowed < 4000; ++allowed) {
        const long live = g_live;
        g_left = allowed;
        const bool made = make();
        g_left = -1;
        if (made) break;
        ++failures;
        ASSERT_NE(Messages::last().find("out of memory"), std::string::npos) << Messages::last();
        ASSERT_EQ(g_live, live) << "after " << allowed << " allocations";
    }
    EXPECT_GT(failures, 10);
    EXPECT_TRUE(file_of(scene.world, scene.space) == before);
}

// A world whose new bodies would average over a million steps: the bodies that it has do not.
// Geoms in a file are named by numbers. Whatever number stands for whichever, none comes to hold itself.
TEST(HostileWorldFiles, name_any_geom_for_another)
{
    const Messages messages;
    const dWorldID world = dWorldCreate();
    dSpaceID space = dSimpleSpaceCreate(nullptr);
    dGeomID held = dCreateSphere(nullptr, 1);
    for (int i = 0; i < 3; ++i) {
        const dGeomID transform = dCreateGeomTransform(i == 2 ? space : nullptr);
        dGeomTransformSetCleanup(transform, 1);
        dGeomTransformSetGeom(transform, held);
        held = transform;
    }
    dSpaceAdd(space, (dGeomID)dSimpleSpaceCreate(nullptr));
    const Bytes file = file_of(world, space);
    dWorldDestroy(world), dSpaceDestroy(space);
    int taken = 0, refused = 0;
    for (std::size_t at = kHeader; at + 4 <= file.size(); ++at)
        for (std::uint32_t number = 0; number < 7; ++number) {
            Bytes other = file;
            std::memcpy(&other[at], &number, 4);
            seal(other);
            space = nullptr;
            const dWorldID loaded = load(other, &space);
            loaded ? ++taken : ++refused;
            if (loaded) dWorldDestroy(loaded);
            if (space) dSpaceDestroy(space);
        }
    EXPECT_GT(taken, 100);
    EXPECT_GT(refused, 100);
}

TEST(CopiesWithoutMemory, take_none_for_averages_that_no_body_has)
{
    const Messages messages;
    Scene scene({.piles = 1});
    dWorldSetAutoDisableAverageSamplesCount(scene.world, 1000000);
    const Bytes file = file_of(scene.world, scene.space);
    dSetAllocHandler(&alloc), dSetReallocHandler(&grow), dSetFreeHandler(&give);
    g_taken = 0;
    dSpaceID space = nullptr;
    const dWorldID world = load(file, &space);
    ASSERT_TRUE(world) << Messages::last();
    EXPECT_LT(g_taken, 2000000);
    EXPECT_EQ(dWorldGetAutoDisableAverageSamplesCount(world), 1000000);
    Copy(scene, world, space, true);
    dSetAllocHandler(nullptr), dSetReallocHandler(nullptr), dSetFreeHandler(nullptr);
}

TEST(CopiesWithoutMemory, leave_nothing_behind)
{
    dSetAllocHandler(&alloc), dSetReallocHandler(&grow), dSetFreeHandler(&give);
    {
        const Messages messages;
        RichScene scene({.stepper = Stepper::kSubsteps, .piles = 1});
        scene.steps(10);
        const Bytes file = file_of(scene.world, scene.space);
        expect_clean_failures(scene, [&] {
            std::vector<dHandlePair> table(400);
            dSpaceID space = scene.space;
            const dWorldID world = dWorldClone(scene.world, &space, table.data(), 400);
            if (!world) return false;
            const Copy whole(scene, world, space, false);
            return true;
        });
        expect_clean_failures(scene, [&] {
            dSpaceID space = nullptr;
            const dWorldID world = load(file, &space);
            if (!world) return false;
            const Copy whole(scene, world, space, true);
            return true;
        });
        expect_clean_failures(
            scene, [&] { return dWorldSaveToBuffer(scene.world, scene.space, nullptr, 0) == file.size(); });
    }
    dSetAllocHandler(nullptr), dSetReallocHandler(nullptr), dSetFreeHandler(nullptr);
}

#if !defined(__wasm__)  // its C++ library knows no files
// Of a path: what is there stays as it is, and nothing else comes to be.
TEST(CopiesWithoutMemory, leave_files_as_they_are)
{
    const std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) / ("epode_memory_" + std::to_string(::getpid()));
    std::filesystem::create_directory(folder);
    const std::string path = (folder / "world.epw").string();
    const auto put = [&](const char* text) { std::ofstream(path) << text; };
    const auto is = [&](const char* text) {
        std::ostringstream content;
        content << std::ifstream(path).rdbuf();
        const auto files = std::filesystem::directory_iterator(folder);
        return content.str() == text && std::distance(begin(files), end(files)) == 1;
    };
    dSetAllocHandler(&alloc), dSetReallocHandler(&grow), dSetFreeHandler(&give);
    {
        const Messages messages;
        RichScene scene({.stepper = Stepper::kSubsteps, .piles = 1});
        scene.steps(10);
        expect_clean_failures(scene, [&] {
            put("another file");
            if (dWorldSave(scene.world, scene.space, path.c_str()) == 1) return true;
            EXPECT_TRUE(is("another file"));
            return false;
        });
        expect_clean_failures(scene, [&] {
            dSpaceID space = nullptr;
            const dWorldID world = dWorldLoad(path.c_str(), &space);
            if (!world) return false;
            const Copy whole(scene, world, space, true);
            return true;
        });
    }
    std::filesystem::remove_all(folder);
    dSetAllocHandler(nullptr), dSetReallocHandler(nullptr), dSetFreeHandler(nullptr);
}
#endif

}  // namespace
}  // namespace epode::states
