// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "phases.h"

#include <cstdlib>

namespace hostile {
namespace {

constexpr dReal kStep = REAL(0.01);

void collide_with(dGeomID geom, Scene& scene)
{
    dContactGeom contacts[4];
    dCollide(geom, scene.probe, 4, contacts, sizeof contacts[0]);
}

void step(Scene& scene) { dWorldStep(scene.world, kStep); }

void walk(Scene& scene, bool) { dSpaceCollide(scene.space, nullptr, near_nothing); }

void find_boxes(Scene& scene, bool by_space)
{
    dGeomMoved(scene.user_geom);
    dGeomMoved(scene.tested_geom);
    if (by_space) return dSpaceClean(scene.space);
    dReal box[6];
    dGeomGetAABB(scene.tested_geom, box);
}

void test_boxes(Scene& scene, bool)
{
    dSpaceCollide2(reinterpret_cast<dGeomID>(scene.space), scene.tested_geom, nullptr, near_nothing);
}

void end(Scene& scene, bool other) { dGeomDestroy(other ? scene.user_geom : scene.tested_geom); }

// ---- filters ----

int keep_pair(void*, dGeomID, dGeomID)
{
    g_hooks.contact_filter.run();
    return 1;
}

void filter_contacts(Scene& scene, bool)
{
    dWorldSetContactSpace(scene.world, scene.space);
    dWorldSetContactFilter(scene.world, keep_pair, nullptr);
    step(scene);
}

int keep_geom(void*, dGeomID)
{
    g_hooks.query_filter.run();
    return 1;
}

void filter_query(Scene& scene, bool by_ray)
{
    const dVector3 from = {0, 0, 9, 0}, down = {0, 0, -1, 0};
    dQueryFilter asked;
    dQueryFilterInit(&asked, sizeof asked);
    asked.callback = keep_geom;
    dQueryHit hit;
    dGeomID found[8];
    if (by_ray)
        dSpaceRayClosest(scene.space, from, down, 20, &asked, &hit);
    else
        dSpaceOverlap(scene.space, scene.probe, &asked, found, 8);
}

// ---- handlers ----

// What a near callback must not do.
void near_refused(void*, dGeomID geom, dGeomID) { dGeomDestroy(geom); }

void refuse(Scene& scene, bool in_walk)
{
    if (in_walk) return dSpaceCollide(scene.space, nullptr, near_refused);
    dWorldSetERP(scene.world, -dInfinity);
}

int no_override(dGeomID, dGeomID, int, dContactGeom*, int)
{
    g_hooks.override_collider.run();
    return 0;
}

// Of a pair that no other phase needs: an override without a function leaves the two without contacts.
void collide_overridden(Scene& scene, bool)
{
    const dGeomID floor = dCreatePlane(nullptr, 0, 0, 1, 0);
    dSetColliderOverride(dSphereClass, dPlaneClass, no_override);
    collide_with(floor, scene);
    dSetColliderOverride(dSphereClass, dPlaneClass, nullptr);
    dGeomDestroy(floor);
}

// ---- what a step asks the program for ----

void* step_block(dsizeint size)
{
    g_hooks.step_memory.run();
    return std::malloc(size);
}
void free_block(void* block, dsizeint) { std::free(block); }

void ask_for_memory(Scene& scene, bool)
{
    const dWorldStepMemoryFunctionsInfo functions = {sizeof functions, step_block, nullptr, free_block};
    dWorldSetStepMemoryManager(scene.world, &functions);
    step(scene);
}

dThreadingFunctionsInfo g_functions;
unsigned count_threads(dThreadingImplementationID implementation)
{
    g_hooks.threading.run();
    return g_functions.retrieve_thread_count(implementation);
}

// Of an implementation that no call knows.
void ask_for_threads(Scene& scene, bool)
{
    const dThreadingImplementationID own = dThreadingAllocateSelfThreadedImplementation();
    g_functions = *dThreadingImplementationGetFunctions(own);
    dThreadingFunctionsInfo functions = g_functions;
    functions.retrieve_thread_count = count_threads;
    dWorldSetStepThreadingImplementation(scene.world, &functions, own);
    step(scene);
    dWorldSetStepThreadingImplementation(scene.world, nullptr, nullptr);
    dThreadingFreeImplementation(own);
}

// ---- fluids, manifolds, characters ----

dReal surface(void*, const dVector3, dReal)
{
    g_hooks.fluid.run();
    return 0;
}

void float_geoms(Scene& scene, bool asked)
{
    const dFluidID fluid = dFluidCreate(scene.world);
    dFluidSetSurface(fluid, surface, nullptr);
    if (!asked) return step(scene);
    dFluidGetSubmerged(fluid, scene.probe, nullptr, nullptr);
}

void flow(void*, const dVector3, dReal, dVector3 velocity)
{
    velocity[0] = velocity[1] = velocity[2] = 0;
    g_hooks.fluid.run();
}

dBodyID put_ball(Scene& scene, dReal z)
{
    const dBodyID body = dBodyCreate(scene.world);
    dGeomSetBody(dCreateSphere(scene.space, 1), body);
    dBodySetPosition(body, 40, 40, z);
    return body;
}

void drag_geoms(Scene& scene, bool)
{
    const dFluidID fluid = dFluidCreate(scene.world);
    dFluidSetPlane(fluid, 0, 0, 1, 100);
    dFluidSetCurrentFunction(fluid, flow, nullptr);
    put_ball(scene, 0);
    step(scene);
}

void see_manifold(void*, dManifold*) { g_hooks.manifold.run(); }

void show_manifolds(Scene& scene, bool)
{
    dWorldSetContactSpace(scene.world, scene.space);
    dWorldSetManifoldFunction(scene.world, see_manifold, nullptr, 0);
    put_ball(scene, 0), put_ball(scene, REAL(1.9));
    step(scene);
}

int let_pass(void*, dGeomID, dGeomID, const dVector3)
{
    g_hooks.character_filter.run();
    return 1;
}

void move_character(Scene& scene, bool walks)
{
    dCharacterSettings settings;
    dCharacterSettingsInit(&settings, sizeof settings);
    settings.filter = let_pass;
    const dGeomID character = dCharacterCreate(scene.space, &settings);
    put_ball(scene, 0);
    dCharacterSetPosition(character, REAL(41.5), 40, 0);
    const dVector3 velocity = {-1, 0, 0, 0};
    walks ? dCharacterWalk(character, velocity, 0, kStep) : dCharacterMove(character, velocity, kStep);
}

constexpr Phase kPhases[] = {
    {" inside a near callback", &Hooks::near, walk},
    {" inside a moved callback", &Hooks::moved, [](Scene& scene, bool) { step(scene); }},
    {" inside a box function", &Hooks::box, find_boxes},
    {" inside a box test", &Hooks::box_test, test_boxes},
    {" inside a collider", &Hooks::collider,
     [](Scene& scene, bool) { collide_with(scene.tested_geom, scene); }},
    {" inside a height function", &Hooks::height,
     [](Scene& scene, bool) { collide_with(scene.high_ground, scene); }},
    {" inside a triangle function", &Hooks::mesh,
     [](Scene& scene, bool) { collide_with(scene.mesh, scene); }},
    {" inside a destructor function", &Hooks::end, end},
    {" inside a contact filter", &Hooks::contact_filter, filter_contacts},
    {" inside a query's filter", &Hooks::query_filter, filter_query},
    {" inside a message handler", &Hooks::message, refuse},
    {" inside an overriding collider", &Hooks::override_collider, collide_overridden},
    {" inside a function for a step's memory", &Hooks::step_memory, ask_for_memory},
    {" inside a threading function", &Hooks::threading, ask_for_threads},
    {" inside the surface of a fluid", &Hooks::fluid, float_geoms},
    {" inside the current of a fluid", &Hooks::fluid, drag_geoms},
    {" inside a function of manifolds", &Hooks::manifold, show_manifolds},
    {" inside a character's filter", &Hooks::character_filter, move_character},
};

}  // namespace

std::span<const Phase> phases() { return kPhases; }

}  // namespace hostile
