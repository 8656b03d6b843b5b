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
};

}  // namespace

std::span<const Phase> phases() { return kPhases; }

}  // namespace hostile
