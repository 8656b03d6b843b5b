// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions of the program that do not return: every kind of callback leaves the library by a C++ exception or by
// longjmp, itself or by the handler of a refusal. Nothing stays locked, held or half done: the same scene has the same
// pairs and contacts afterwards, is stepped, and goes without a refusal. The program goes on where it has landed or
// deeper, on stack that looks like what it has left.
#include <gtest/gtest.h>

#include <csetjmp>
#include <cstdio>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include <ode/ext.h>
#include <ode/ode.h>
#if defined(__SANITIZE_ADDRESS__)
#include <sanitizer/lsan_interface.h>
#endif

namespace {

enum class Way { kThrow, kJump, kThrowInHandler, kJumpInHandler };

int g_refusals = 0;
std::string g_text;
bool g_armed = false, g_left = false;
Way g_way;
std::jmp_buf g_landing;

[[noreturn]] void leave()
{
    g_armed = false, g_left = true;
    if (g_way == Way::kThrow || g_way == Way::kThrowInHandler) throw 1;
    std::longjmp(g_landing, 1);
}

void receive(int, const char* format, va_list arguments)
{
    char text[300];
    std::vsnprintf(text, sizeof text, format, arguments);
    if (g_armed) leave();
    g_text = text;
    ++g_refusals;
}

void act()
{
    if (!g_armed) return;
    if (g_way == Way::kThrow || g_way == Way::kJump) leave();
    dBodyEnable(nullptr);  // is refused
}

void near_callback(void* count, dGeomID, dGeomID)
{
    if (count) ++*static_cast<int*>(count);
    act();
}
void moved(dBodyID) { act(); }
int filter(void*, dGeomID, dGeomID) { return act(), 1; }
int asked(void*, dGeomID) { return act(), 1; }
dReal height(void*, int, int) { return act(), dReal(0); }
int triangle(dGeomID, dGeomID, int) { return act(), 1; }
void triangles(dGeomID, dGeomID, const int*, int) { act(); }
int ray_hits(dGeomID, dGeomID, int, dReal, dReal) { return act(), 1; }
int merged(dGeomID, int, int) { return act(), 0; }
int collide_user(dGeomID, dGeomID, int, dContactGeom*, int) { return act(), 0; }
void seen(void*, dManifold*) { act(); }
dReal surface(void*, const dVector3, dReal) { return act(), dReal(0); }
void current(void*, const dVector3, dReal, dVector3 velocity)
{
    for (int i = 0; i < 3; ++i) velocity[i] = 0;
    act();
}
int lets_pass(void*, dGeomID, dGeomID, const dVector3) { return act(), 1; }
bool g_offers = false;  // the function that offers a collider leaves
dColliderFn* collider_for(int) { return g_offers ? act() : void(), collide_user; }
void user_box(dGeomID geom, dReal box[6])
{
    act();
    const dReal* at = dGeomGetPosition(geom);
    for (int i = 0; i < 6; ++i) box[i] = at[i / 2] + (i % 2 ? 1 : -1);
}
bool g_tests = false;
int test_box(dGeomID, dGeomID, dReal*) { return g_tests ? act() : void(), 1; }
bool g_mourns = false;
void user_end(dGeomID) { g_mourns ? act() : void(); }

struct Scene {
    Scene()
    {
        dInitODE2(0);
        dSetDebugHandler(receive);
        dSetMessageHandler(receive);
        g_armed = g_left = g_offers = g_tests = g_mourns = false;
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, -10, 0);
        for (int i = 0; i < 3; ++i) add_ball(i);
        const dGeomClass description = {8, collider_for, user_box, test_box, user_end};
        user = dCreateGeom(dCreateGeomClass(&description));
        dSpaceAdd(space, user);
        heights = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildCallback(heights, nullptr, height, 8, 8, 4, 4, 1, 0, 1, 0);
        dGeomHeightfieldDataSetBounds(heights, -1, 1);
        field = dCreateHeightfield(space, heights, 1);
        lone = dCreateSphere(nullptr, 1);
        add_mesh();
        g_refusals = 0;
    }

    ~Scene()
    {
        if (user && !dGeomGetSpace(user)) dGeomDestroy(user);
        dSpaceDestroy(space);
        dWorldDestroy(world);
        for (dGeomID geom : {lone, mesh}) dGeomDestroy(geom);
        dGeomHeightfieldDataDestroy(heights);
        dGeomTriMeshDataDestroy(triangles_of_mesh);
        EXPECT_EQ(g_refusals, 0) << g_text;
        dSetDebugHandler(nullptr);
        dSetMessageHandler(nullptr);
        dCloseODE();
    }

    void add_ball(int i)
    {
        body[i] = dBodyCreate(world);
        ball[i] = dCreateSphere(space, 1);
        dGeomSetBody(ball[i], body[i]);
        dBodySetPosition(body[i], dReal(0.5 * i), dReal(0.9), 0);
    }

    void add_mesh()
    {
        static const double corners[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1};
        static const unsigned faces[12] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
        triangles_of_mesh = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildDouble(triangles_of_mesh, corners, 3 * sizeof(double), 4, faces, 12,
                                    3 * sizeof(unsigned));
        mesh = dCreateTriMesh(nullptr, triangles_of_mesh, nullptr, nullptr, nullptr);
    }

    void manage_contacts() { dWorldSetContactSpace(world, space); }

    int pairs() const
    {
        int count = 0;
        dSpaceCollide(space, &count, near_callback);
        return count;
    }

    dWorldID world;
    dSpaceID space;
    dBodyID body[3];
    dGeomID ball[3], user, field, lone, mesh, character = nullptr;
    dHeightfieldDataID heights;
    dTriMeshDataID triangles_of_mesh;
};

// What is done where the callback comes; and what prepares for it.
enum class After { kSame, kNotCalled, kFewer };  // pairs: as after the call, as without it, fewer geoms
struct Kind {
    const char* name;
    void (*call)(Scene&);
    void (*prepare)(Scene&) = nullptr;
    After after = After::kSame;
};

dContactGeom g_contacts[64];
void collide(dGeomID a, dGeomID b) { dCollide(a, b, 64, g_contacts, sizeof g_contacts[0]); }

const dVector3 kFrom = {0, 20, 0}, kDown = {0, -1, 0}, kFall = {0, -40, 0};
dQueryFilter asking()
{
    dQueryFilter f;
    dQueryFilterInit(&f, sizeof f);
    f.callback = asked;
    return f;
}
template <typename Call>
void query(Call&& call)
{
    const dQueryFilter f = asking();
    dQueryHit hits[8];
    call(&f, hits);
}

void make_sensor(Scene& s)
{
    s.manage_contacts();
    dGeomSetSensor(s.ball[0], 1);
    dEventSettings settings;
    dEventSettingsInit(&settings, sizeof settings);
    settings.kinds = ~0u >> (32 - 6);
    dWorldSetEventSettings(s.world, &settings);
}
void fly(Scene& s)
{
    dGeomSetContinuous(s.ball[2], dContinuousOn);
    dBodySetPosition(s.body[2], 0, 30, 0);
    dBodySetLinearVel(s.body[2], 0, -2500, 0);
}
void wrap(Scene& s)
{
    dSpaceRemove(s.space, s.user);
    const dGeomID around = dCreateGeomTransform(s.space);
    dGeomTransformSetGeom(around, s.user);
    dGeomTransformSetCleanup(around, 1);
    dGeomSetPosition(around, 0, dReal(0.3), 0);
}
void flood(Scene& s, dFluidSurface* of_surface, dFluidCurrent* of_current)
{
    const dFluidID fluid = dFluidCreate(s.world);
    dFluidSetPlane(fluid, 0, 1, 0, 1);
    if (of_surface) dFluidSetSurface(fluid, of_surface, nullptr);
    dFluidSetCurrentFunction(fluid, of_current, nullptr);
}
void ask_what_is_submerged(Scene& s, bool body)
{
    dReal volume;
    const dFluidID fluid = dWorldGetFluid(s.world, 0);
    body ? dFluidGetSubmergedBody(fluid, s.body[0], &volume, nullptr)
         : dFluidGetSubmerged(fluid, s.ball[0], &volume, nullptr);
}
void make_character(Scene& s)
{
    dCharacterSettings settings;
    dCharacterSettingsInit(&settings, sizeof settings);
    settings.filter = lets_pass;
    s.character = dCharacterCreate(s.space, &settings);
    dCharacterSetPosition(s.character, -3, dReal(0.9), 0);
}
const dVector3 kRun = {200, 0, 0};
void show_manifolds(Scene& s)
{
    s.manage_contacts();
    dWorldSetManifoldFunction(s.world, seen, nullptr, 0);
}
void run_away(Scene& s) { dBodySetLinearVel(dBodyCreate(s.world), dReal(1e11), 0, 0); }
void nest(Scene& s)
{
    const dSpaceID inner = dSimpleSpaceCreate(s.space);
    dSpaceRemove(s.space, s.user);
    dSpaceAdd(inner, s.user);
}

const Kind kKinds[] = {
    {"near", [](Scene& s) { (void)s.pairs(); }},
    {"near_of_two", [](Scene& s) { dSpaceCollide2(s.lone, (dGeomID)s.space, nullptr, near_callback); }},
    {"box", [](Scene& s) { dGeomGetAABB(s.user, g_contacts[0].pos); },
     [](Scene& s) { dGeomSetPosition(s.user, 0, 1, 0); }},
    {"box_in_space", [](Scene& s) { dSpaceClean(s.space); },
     [](Scene& s) {
         (void)s.pairs();
         dGeomSetPosition(s.user, 0, 1, 0);
         dBodySetPosition(s.body[2], 1, dReal(0.7), 0);
     }},
    {"box_in_nested_space", [](Scene& s) { dSpaceClean(s.space); }, nest},
    {"box_in_ray",
     [](Scene& s) {
         dQueryHit h;
         dSpaceRayClosest(s.space, kFrom, kDown, 50, nullptr, &h);
     },
     nest},
    {"box_test", [](Scene& s) { (void)s.pairs(); }, [](Scene&) { g_tests = true; }},
    {"collider", [](Scene& s) { collide(s.user, s.lone); }},
    {"collider_offered", [](Scene& s) { collide(s.user, s.lone); }, [](Scene&) { g_offers = true; }},
    {"collider_in_transform", [](Scene& s) { collide(dSpaceGetGeom(s.space, 0), s.lone); }, wrap},
    {"height", [](Scene& s) { collide(s.field, s.lone); }},
    {"height_of_a_ray",
     [](Scene& s) {
         dQueryHit h;
         dSpaceRayClosest(s.space, kFrom, kDown, 50, nullptr, &h);
     }},
    {"height_of_a_distance",
     [](Scene& s) {
         dQueryDistance d;
         dGeomGetDistance(s.field, s.lone, 10, &d);
     }},
    {"height_of_a_cast",
     [](Scene& s) {
         dQueryHit h;
         dGeomCast(s.lone, kFall, s.field, &h);
     },
     [](Scene& s) { dGeomSetPosition(s.lone, 0, 20, 0); }},
    {"height_of_a_file", [](Scene& s) { (void)dWorldSaveToBuffer(s.world, s.space, nullptr, 0); },
     [](Scene& s) { dSpaceRemove(s.space, s.user); }},
    {"triangle", [](Scene& s) { collide(s.mesh, s.lone); },
     [](Scene& s) { dGeomTriMeshSetCallback(s.mesh, triangle); }},
    {"triangles", [](Scene& s) { collide(s.mesh, s.lone); },
     [](Scene& s) { dGeomTriMeshSetArrayCallback(s.mesh, triangles); }},
    {"triangle_of_a_ray",
     [](Scene& s) {
         const dGeomID ray = dCreateRay(s.space, 5);
         dGeomRaySet(ray, dReal(0.1), dReal(0.2), 3, 0, 0, -1);
         collide(s.mesh, ray);
     },
     [](Scene& s) { dGeomTriMeshSetRayCallback(s.mesh, ray_hits); }},
    {"triangles_merged", [](Scene& s) { collide(s.mesh, s.lone); },
     [](Scene& s) {  // over an edge
         dGeomSetPosition(s.lone, dReal(0.5), dReal(-0.6), dReal(-0.6));
         dGeomTriMeshSetTriMergeCallback(s.mesh, merged);
     }},
    {"query_closest",
     [](Scene& s) { query([&](auto* f, auto* h) { dSpaceRayClosest(s.space, kFrom, kDown, 50, f, h); }); }},
    {"query_all",
     [](Scene& s) { query([&](auto* f, auto* h) { dSpaceRayAll(s.space, kFrom, kDown, 50, f, h, 8); }); }},
    {"query_batch",
     [](Scene& s) {
         const dReal length = 50;
         query([&](auto* f, auto* h) { dSpaceRayBatch(s.space, 1, kFrom, kDown, &length, f, h, 1); });
     }},
    {"query_cast",
     [](Scene& s) { query([&](auto* f, auto* h) { dSpaceCast(s.space, s.lone, kFall, f, h); }); }},
    {"query_overlap",
     [](Scene& s) {
         const dQueryFilter f = asking();
         dGeomID found[8];
         dSpaceOverlap(s.space, s.lone, &f, found, 8);
     }},
    {"filter_exact", [](Scene& s) { dWorldStep(s.world, dReal(0.01)); },
     [](Scene& s) { s.manage_contacts(), dWorldSetContactFilter(s.world, filter, nullptr); }},
    {"filter_hybrid", [](Scene& s) { dWorldStepHybrid(s.world, dReal(0.01)); },
     [](Scene& s) { s.manage_contacts(), dWorldSetContactFilter(s.world, filter, nullptr); }},
    {"collider_in_step", [](Scene& s) { dWorldStepFast1(s.world, dReal(0.01), 4); },
     [](Scene& s) {
         s.manage_contacts();
         (void)s.pairs();
         dGeomDestroy(s.field);
         dGeomSetPosition(s.user, 0, dReal(-0.5), 0);
         dSpaceClean(s.space);
     }},
    {"height_in_step", [](Scene& s) { dWorldStepHybrid(s.world, dReal(0.01)); },
     [](Scene& s) { s.manage_contacts(); }},
    {"height_on_a_continuous_way", [](Scene& s) { dWorldStep(s.world, dReal(0.01)); }, fly},
    {"height_of_a_sensor", [](Scene& s) { dWorldStepFast1(s.world, dReal(0.01), 2); }, make_sensor},
    {"moved_exact", [](Scene& s) { dWorldStep(s.world, dReal(0.01)); },
     [](Scene& s) { dBodySetMovedCallback(s.body[1], moved); }},
    {"moved_quick", [](Scene& s) { dWorldQuickStep(s.world, dReal(0.01)); },
     [](Scene& s) { dBodySetMovedCallback(s.body[1], moved); }},
    {"moved_substeps", [](Scene& s) { dWorldStepFast1(s.world, dReal(0.01), 4); },
     [](Scene& s) { s.manage_contacts(), dBodySetMovedCallback(s.body[0], moved); }},
    {"moved_hybrid", [](Scene& s) { dWorldStepHybrid(s.world, dReal(0.01)); },
     [](Scene& s) { dBodySetMovedCallback(s.body[2], moved); }},
    {"moved_in_many_worlds",
     [](Scene& s) { dWorldsStep(&s.world, 1, dReal(0.01), dStepperSubsteps, 4, 3, 1, nullptr); },
     [](Scene& s) { dBodySetMovedCallback(s.body[0], moved); }},
    {"manifold_exact", [](Scene& s) { dWorldStep(s.world, dReal(0.01)); }, show_manifolds},
    {"manifold_quick", [](Scene& s) { dWorldQuickStep(s.world, dReal(0.01)); }, show_manifolds},
    {"manifold_substeps", [](Scene& s) { dWorldStepFast1(s.world, dReal(0.01), 4); }, show_manifolds},
    {"manifold_hybrid", [](Scene& s) { dWorldStepHybrid(s.world, dReal(0.01)); }, show_manifolds},
    {"surface_exact", [](Scene& s) { dWorldStep(s.world, dReal(0.01)); },
     [](Scene& s) { flood(s, surface, nullptr); }},
    {"surface_substeps", [](Scene& s) { dWorldStepFast1(s.world, dReal(0.01), 4); },
     [](Scene& s) { flood(s, surface, nullptr); }},
    {"surface_of_a_geom", [](Scene& s) { ask_what_is_submerged(s, false); },
     [](Scene& s) { flood(s, surface, nullptr); }},
    {"surface_of_a_body", [](Scene& s) { ask_what_is_submerged(s, true); },
     [](Scene& s) { flood(s, surface, nullptr); }},
    {"current_exact", [](Scene& s) { dWorldStep(s.world, dReal(0.01)); },
     [](Scene& s) { flood(s, nullptr, current); }},
    {"current_hybrid", [](Scene& s) { dWorldStepHybrid(s.world, dReal(0.01)); },
     [](Scene& s) { flood(s, nullptr, current); }},
    {"character_moves", [](Scene& s) { dCharacterMove(s.character, kRun, dReal(0.01)); }, make_character},
    {"character_walks", [](Scene& s) { dCharacterWalk(s.character, kRun, 0, dReal(0.01)); }, make_character},
    {"collider_in_place_of_ours", [](Scene& s) { collide(s.ball[0], s.lone); },
     [](Scene&) { dSetColliderOverride(dSphereClass, dSphereClass, collide_user); }},
    {"message_of_a_step", [](Scene& s) { dWorldStep(s.world, dReal(0.01)); }, run_away, After::kNotCalled},
    {"message_of_a_substep", [](Scene& s) { dWorldStepFast1(s.world, dReal(0.01), 4); }, run_away,
     After::kNotCalled},
    {"end", [](Scene& s) { dGeomDestroy(s.user); }, [](Scene&) { g_mourns = true; }, After::kNotCalled},
    {"end_with_its_space", [](Scene& s) { dSpaceDestroy(s.space); }, [](Scene&) { g_mourns = true; },
     After::kFewer},
};

// Comes back here, however the call ends.
[[gnu::noinline]] void call_and_land(const Kind& kind, Scene& scene, Way way)
{
    g_way = way, g_armed = true;
    if (way == Way::kThrow || way == Way::kThrowInHandler) {
        try {
            kind.call(scene);
        } catch (int) {}
    } else if (setjmp(g_landing) == 0) {
        kind.call(scene);
    }
    g_armed = false;
}

// With a frame as large as that, in which nothing has been written.
[[gnu::noinline]] void deeper(int bytes, const std::function<void()>& work)
{
    volatile char* frame = static_cast<volatile char*>(__builtin_alloca(std::size_t(bytes)));
    frame[0] = 0;
    work();
    frame[bytes - 1] = 0;
}

struct Case {
    Kind kind;
    Way way;
    int depth;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.kind.name; }

class Escapes : public ::testing::TestWithParam<Case> {};

void arrange(const Scene& scene)
{
    for (int i = 0; i < 3; ++i) dBodySetPosition(scene.body[i], dReal(0.5 * i), dReal(0.9), 0);
    dGeomSetPosition(scene.user, 0, 0, 0);
    if (scene.character) dCharacterSetPosition(scene.character, -3, dReal(0.9), 0);
}

// In a scene like it in which the call has returned.
int pairs_of_twin(const Kind& kind)
{
    Scene twin;
    if (kind.prepare) kind.prepare(twin);
    if (kind.after == After::kSame) kind.call(twin);
    arrange(twin);
    return twin.pairs();
}

void go_on(Scene& scene, int pairs)
{
    if (pairs >= 0) {
        arrange(scene);
        EXPECT_EQ(g_refusals, 0) << g_text;
        EXPECT_EQ(scene.pairs(), pairs);
    }
    for (int i = 0; i < 2; ++i) {
        EXPECT_EQ(dWorldStep(scene.world, dReal(0.01)), 1) << g_text;
        EXPECT_EQ(dWorldQuickStep(scene.world, dReal(0.01)), 1);
        EXPECT_EQ(dWorldStepFast1(scene.world, dReal(0.01), 4), 1);
        EXPECT_EQ(dWorldStepHybrid(scene.world, dReal(0.01)), 1);
    }
    if (scene.character) { EXPECT_GT(dCharacterMove(scene.character, kRun, dReal(0.01)), 0); }
    std::vector<char> state(dWorldGetStateSize(scene.world));
    EXPECT_EQ(dWorldGetState(scene.world, state.data(), state.size()), 1);
    EXPECT_EQ(dWorldSetState(scene.world, state.data(), state.size()), 1) << g_text;
    dBodyDestroy(scene.body[1]);
    EXPECT_EQ(g_refusals, 0) << g_text;
}

// What a call that is left had taken for itself alone is not given back (docs/errors.md).
struct WithoutLeakCheck {
#if defined(__SANITIZE_ADDRESS__)
    WithoutLeakCheck() { __lsan_disable(); }
    ~WithoutLeakCheck() { __lsan_enable(); }
#endif
};

TEST_P(Escapes, leave_nothing_behind)
{
    const auto [kind, way, depth] = GetParam();
    const int pairs = kind.after == After::kFewer ? -1 : pairs_of_twin(kind);
    Scene scene;
    if (kind.prepare) kind.prepare(scene);
    g_refusals = 0;
    {
        [[maybe_unused]] const WithoutLeakCheck without;
        deeper(depth > 0 ? 64 : 5000, [&, &k = kind, w = way] { call_and_land(k, scene, w); });
    }
    ASSERT_TRUE(g_left) << "the callback did not come";
    g_tests = g_offers = g_mourns = false;
    deeper(depth > 0 ? depth : 64, [&] { go_on(scene, pairs); });
}

std::vector<Case> all_cases()
{
    std::vector<Case> all;
    for (const Kind& kind : kKinds)
        for (Way way : {Way::kThrow, Way::kJump, Way::kThrowInHandler, Way::kJumpInHandler})
            for (int depth : {0, 300, 20000}) all.push_back({kind, way, depth});
    return all;
}
std::string name_of(const ::testing::TestParamInfo<Case>& info)
{
    constexpr const char* kWays[] = {"throws", "jumps", "handler_throws", "handler_jumps"};
    return std::string(info.param.kind.name) + "_" + kWays[int(info.param.way)] + "_" +
           std::to_string(info.param.depth);
}
INSTANTIATE_TEST_SUITE_P(Callbacks, Escapes, ::testing::ValuesIn(all_cases()), name_of);

}  // namespace
