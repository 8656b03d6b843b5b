// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Functions of the program find its own floating-point modes when the library calls them, may call it back,
// and flags that they raise are found after the call.
#include "float_modes.h"
#include "rig.h"

#include <cstdarg>
#include <cstdlib>
#include <map>

namespace epode::physics {
namespace {

#ifdef EPODE_HAS_FLOAT_MODES

// Calls of each function, and whether each one found `expected` on the thread that called the library.
struct Seen {
    std::uint64_t expected = kUsualControl;
    bool on = false;
    std::map<std::string, int> calls, wrong;
};
Seen g_seen;

void note(const char* who)
{
    if (!g_seen.on) return;
    const FloatRegisters now = float_registers();
    set_float_registers({kUsualControl, 0});  // the notes' own arithmetic
    ++g_seen.calls[who];
    if (now.control != g_seen.expected) ++g_seen.wrong[who];
    set_float_registers(now);
}

void near(void* data, dGeomID a, dGeomID b)
{
    note("near");
    Sim& sim = *static_cast<Sim*>(data);
    dContact contact{};
    contact.surface.mu = 1;
    if (dCollide(a, b, 1, &contact.geom, sizeof contact) > 0)
        dJointAttach(dJointCreateContact(sim.world, sim.contacts, &contact), dGeomGetBody(a),
                     dGeomGetBody(b));
    note("near, after a call of its own");
}

void moved(dBodyID) { note("moved"); }
int filter(void*, dGeomID, dGeomID) { return note("filter"), 1; }
int triangle(dGeomID, dGeomID, int) { return note("triangle"), 1; }
void triangles(dGeomID, dGeomID, const int*, int) { note("triangles"); }
int ray_triangle(dGeomID, dGeomID, int, dReal, dReal) { return note("ray_triangle"), 1; }
dReal height(void*, int, int) { return note("height"), 0; }
int user_collide(dGeomID, dGeomID, int, dContactGeom*, int) { return note("user_collide"), 0; }
dColliderFn* user_collider(int) { return note("user_collider"), user_collide; }
void user_aabb(dGeomID, dReal box[6])
{
    note("user_aabb");
    for (int i = 0; i < 6; ++i) box[i] = i % 2 ? 1 : -1;
}
int user_aabb_test(dGeomID, dGeomID, dReal*) { return note("user_aabb_test"), 1; }
void message(int, const char*, va_list) { note("message"); }
void* take_memory(dsizeint size) { return note("memory"), std::malloc(size); }
void* change_memory(void* p, dsizeint, dsizeint size) { return note("memory"), std::realloc(p, size); }
void give_memory(void* p, dsizeint) { note("memory"), std::free(p); }

// A threading implementation of the program: ours, with a note on the functions that steps call.
struct Crew {
    Crew()
    {
        table = *dThreadingImplementationGetFunctions(impl);
        table.post_call = [](dThreadingImplementationID id, int* fault, dCallReleaseeID* name,
                             ddependencycount_t count, dCallReleaseeID after, dCallWaitID wait,
                             dThreadedCallFunction* function, void* context, dcallindex_t index,
                             const char* text) {
            note("post_call");
            dThreadingImplementationGetFunctions(id)->post_call(id, fault, name, count, after, wait, function,
                                                                context, index, text);
        };
        table.wait_call = [](dThreadingImplementationID id, int* status, dCallWaitID wait,
                             const dThreadedWaitTime* limit, const char* text) {
            note("wait_call");
            dThreadingImplementationGetFunctions(id)->wait_call(id, status, wait, limit, text);
        };
    }
    ~Crew() { dThreadingFreeImplementation(impl); }
    Crew(const Crew&) = delete;
    Crew& operator=(const Crew&) = delete;
    dThreadingImplementationID impl = dThreadingAllocateSelfThreadedImplementation();
    dThreadingFunctionsInfo table;
};

// What calls everything there is, in the mode.
std::uint64_t run(const FloatMode& mode, bool& kept)
{
    g_seen = {};
    g_seen.expected = mode.control;
    Crew crew;
    Sim sim;
    sim.gravity(0, 0, -9.81);
    dWorldSetStepThreadingImplementation(sim.world, &crew.table, crew.impl);
    const float corners[9] = {-9, -9, 0, 9, -9, 0, 0, 9, 0};
    const dTriIndex faces[3] = {0, 1, 2};
    const dTriMeshDataID mesh = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(mesh, corners, 3 * sizeof(float), 3, faces, 3, 3 * sizeof(dTriIndex));
    const dGeomID floor = dCreateTriMesh(sim.space, mesh, triangle, triangles, ray_triangle);
    const dHeightfieldDataID field = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildCallback(field, nullptr, height, 9, 9, 10, 10, 1, 0, 1, 0);
    const dGeomID hills = dCreateHeightfield(sim.space, field, 1), ray = dCreateRay(nullptr, 5);
    const dReal up[12] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};
    dGeomSetRotation(hills, up);
    static const int kClass = [] {
        dGeomClass description{};
        description.collider = user_collider;
        description.aabb = user_aabb;
        description.aabb_test = user_aabb_test;
        return dCreateGeomClass(&description);
    }();
    const dGeomID own = dCreateGeom(kClass);
    dSpaceAdd(sim.space, own);
    for (int i = 0; i < 6; ++i) dBodySetMovedCallback(sim.box({1.5 * i - 4, 0.1, 0.48}, {1, 1, 1}, 1), moved);
    dGeomSetPosition(ray, 1, 0, 2);
    const dReal down[12] = {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0};
    dGeomSetRotation(ray, down);
    dContactGeom hit{};
    dMass mass{};
    g_seen.on = true;
    const auto in_mode = [&] {
        const HostMode host(mode, kept, Keeps::kModes);
        for (int i = 0; i < 5; ++i) {
            dJointGroupEmpty(sim.contacts);
            dSpaceCollide(sim.space, &sim, near);
            dWorldStep(sim.world, dReal(0.01));
        }
        dCollide(ray, floor, 1, &hit, sizeof hit);
        dMassSetParameters(&mass, 1, 0, 0, 0, -1, 1, 1, 0, 0, 0);  // a message from inside
        dJointGroupEmpty(sim.contacts);
        dWorldSetContactSpace(sim.world, sim.space);
        dWorldSetContactFilter(sim.world, filter, nullptr);
        for (int i = 0; i < 5; ++i) dWorldStepFast1(sim.world, dReal(0.01), 3);
    };
    in_mode();
    g_seen.on = false;
    const std::uint64_t hash = hash_state(sim);
    dGeomDestroy(ray);
    dGeomDestroy(hills);
    dGeomDestroy(floor);
    dGeomTriMeshDataDestroy(mesh);
    dGeomHeightfieldDataDestroy(field);
    return hash;
}

const char* const kFunctions[] = {"near",           "near, after a call of its own",
                                  "moved",          "filter",
                                  "triangle",       "triangles",
                                  "ray_triangle",   "height",
                                  "user_collide",   "user_aabb",
                                  "user_aabb_test", "memory",
                                  "message",        "post_call",
                                  "wait_call"};

TEST(FloatModes, functions_of_the_program_find_its_own)
{
    dSetMessageHandler(message);
    dSetDebugHandler(message);
    bool kept = true;
    dSetAllocHandler(take_memory);
    dSetReallocHandler(change_memory);
    dSetFreeHandler(give_memory);
    const std::uint64_t usual = run({"usual", kUsualControl}, kept);
    for (const FloatMode& mode : kFloatModes) {
        EXPECT_EQ(run(mode, kept), usual) << mode.name;
        for (const char* function : kFunctions) {
            EXPECT_GT(g_seen.calls[function], 0) << function;
            EXPECT_EQ(g_seen.wrong[function], 0)
                << function << " of " << g_seen.calls[function] << ' ' << mode.name;
        }
    }
    EXPECT_TRUE(kept);
    dSetAllocHandler(nullptr);
    dSetReallocHandler(nullptr);
    dSetFreeHandler(nullptr);
    dSetMessageHandler(nullptr);
    dSetDebugHandler(nullptr);
}

// What a near callback raises is found after the call; what the library raises is not.
TEST(FloatModes, flags_that_the_program_raises_are_kept)
{
    Sim sim;
    sim.box({0, 0, 0}, {1, 1, 1}, 1);
    sim.box({0.3, 0.4, 0.5}, {1, 1, 1}, 1);
    const auto raise = [](void*, dGeomID, dGeomID) {
        FloatRegisters now = float_registers();
        now.flags |= 2;
        set_float_registers(now);
    };
    const FloatRegisters before = float_registers();
    FloatRegisters after;
    for (const FloatMode& mode : kFloatModes) {
        set_float_registers({mode.control, 0});
        dSpaceCollide(sim.space, nullptr, raise);
        after = float_registers();
        set_float_registers(before);
        EXPECT_EQ(after, (FloatRegisters{mode.control, 2})) << mode.name;
    }
}

#endif

}  // namespace
}  // namespace epode::physics
