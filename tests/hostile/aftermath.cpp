// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "aftermath.h"

#include <cstring>
#include <vector>

namespace hostile {
namespace {

bool begins(const char* text, const char* with) { return std::strncmp(text, with, std::strlen(with)) == 0; }
bool contains(const char* text, const char* part) { return std::strstr(text, part) != nullptr; }

constexpr dsizeint kBlock = 64;  // of Kind::kBlock

// dRealloc that gave nothing, where something was wanted, has left the old block as it was.
void free_memory(const Function& f, const Value* arguments, const Result& result)
{
    void* made = const_cast<void*>(result.pointer);
    if (contains(f.name, "dRealloc")) {
        const bool kept = !made && arguments[2].integer != 0;
        dFree(kept ? arguments[0].pointer : made, kBlock);
    } else if (begins(f.name, "dAlloc") && result.type == Result::Type::kPointer) {
        dFree(made, kBlock);
    }
}

// A clone, its space, and geoms of its bodies that are in none.
void destroy_clone(void* made, const void* space_pointer)
{
    const auto world = static_cast<dWorldID>(made);
    const dSpaceID space =
        space_pointer ? *static_cast<const dSpaceID*>(space_pointer) : dWorldGetContactSpace(world);
    std::vector<dGeomID> loose;
    std::vector<dBodyID> bodies(std::size_t(dWorldGetBodies(world, nullptr, 0)));
    dWorldGetBodies(world, bodies.data(), int(bodies.size()));
    for (const dBodyID body : bodies)
        for (dGeomID geom = dBodyGetFirstGeom(body); geom; geom = dBodyGetNextGeom(geom))
            if (!dGeomGetSpace(geom)) loose.push_back(geom);
    dWorldDestroy(world);
    for (const dGeomID geom : loose) dGeomDestroy(geom);
    if (space) dSpaceDestroy(space);
}

// Geoms in no space of the bodies that a figure or a rope is made of.
void destroy_loose_geoms(const dBodyID* bodies, int count)
{
    for (int i = 0; i < count; ++i)
        for (dGeomID geom = dBodyGetFirstGeom(bodies[i]), next; geom; geom = next) {
            next = dBodyGetNextGeom(geom);
            if (!dGeomGetSpace(geom)) dGeomDestroy(geom);
        }
}

// Which function takes back what those whose names contain `part` make.
struct Maker {
    const char* part;
    void (*take_back)(void*);
};

template <auto function, typename Handle>
void with(void* made)
{
    function(static_cast<Handle>(made));
}

// The first that fits.
constexpr Maker kMakers[] = {
    {"ThreadingAllocateThreadPool", with<dThreadingFreeThreadPool, dThreadingThreadPoolID>},
    {"ThreadingAllocate", with<dThreadingFreeImplementation, dThreadingImplementationID>},
    {"CooperativeCreate", with<dCooperativeDestroy, dCooperativeID>},
    {"ResourceRequirementsC", with<dResourceRequirementsDestroy, dResourceRequirementsID>},
    {"ResourceContainerAcquire", with<dResourceContainerDestroy, dResourceContainerID>},
    {"WorldLoad", with<dWorldDestroy, dWorldID>},
    {"WorldCreate", with<dWorldDestroy, dWorldID>},
    {"JointGroupCreate", with<dJointGroupDestroy, dJointGroupID>},
    {"SpaceCreate", with<dSpaceDestroy, dSpaceID>},
    {"HeightfieldDataCreate", with<dGeomHeightfieldDataDestroy, dHeightfieldDataID>},
    {"TriMeshDataCreate", with<dGeomTriMeshDataDestroy, dTriMeshDataID>},
    {"dCreate", with<dGeomDestroy, dGeomID>}};

}  // namespace

bool is_global(const Function& f)
{
    for (const char* name : {"dExternal", "dInit", "dClose", "dSet", "dAllocateODE", "dCleanup",
                             "dCreateGeomClass", "dRand", "dMakeRandom", "dThreading"})
        if (begins(f.name, name)) return true;
    return false;
}

bool is_hidden(const Function& f)
{
    for (const char* part : {"Destroy", "dCooper", "dResource", "dEstimate", "dWorldSetStep", "dWorldUse",
                             "MovedCallback", "TriMeshData"})
        if (contains(f.name, part)) return true;
    return false;
}

bool uses_threads(const Function& f)
{
    for (const Parameter& p : f.all())
        if (p.kind == Kind::kThreadPool || p.kind == Kind::kThreadCount) return true;
    return false;
}

void give_back(const Function& f, const Value* arguments, const Result& result)
{
    free_memory(f, arguments, result);
    const int bodies = std::strcmp(f.name, "dRagdollCreate") == 0 ? 6
                       : std::strcmp(f.name, "dRopeCreate") == 0  ? 7
                                                                  : -1;
    if (bodies >= 0)
        destroy_loose_geoms(static_cast<const dBodyID*>(arguments[bodies].pointer), int(result.integer));
    if (!result.pointer) return;
    if (contains(f.name, "WorldClone"))
        return destroy_clone(const_cast<void*>(result.pointer), arguments[1].pointer);
    for (const Maker& maker : kMakers)
        if (contains(f.name, maker.part)) return maker.take_back(const_cast<void*>(result.pointer));
}

}  // namespace hostile
