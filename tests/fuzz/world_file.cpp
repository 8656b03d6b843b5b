// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldLoadFromBuffer on any bytes: refused, or a world that is destroyed, of which one in 16 steps before.
#include <algorithm>
#include <set>

#include "meter.h"
#include "world.h"

namespace {

using namespace epode::fuzz;

bool make_seeds()
{
    dInitODE2(0), be_silent(), meter_library();
    for (const bool world_contacts : {true, false}) {
        const World w = make_world(world_contacts);
        for (int i = 0; i < 40; ++i) w.step();
        Bytes file(dWorldSaveToBuffer(w.world, w.space, nullptr, 0));
        dWorldSaveToBuffer(w.world, w.space, file.data(), file.size());
        keep_seed(world_contacts ? "managed" : "joints", 0, file);
        dWorldDestroy(w.world), dSpaceDestroy(w.space), dJointGroupDestroy(w.contacts);
    }
    return true;
}

// Meshes that files bring are the program's.
void destroy(dWorldID world, dSpaceID space)
{
    std::set<dTriMeshDataID> meshes;
    std::set<dHeightfieldDataID> fields;
    for (int i = 0; space && i < dSpaceGetNumGeoms(space); ++i) {
        const dGeomID geom = dSpaceGetGeom(space, i);
        if (dGeomGetClass(geom) == dTriMeshClass) meshes.insert(dGeomTriMeshGetData(geom));
        if (dGeomGetClass(geom) == dHeightfieldClass) fields.insert(dGeomHeightfieldGetHeightfieldData(geom));
    }
    std::vector<dBodyID> bodies(std::size_t(dWorldGetBodies(world, nullptr, 0)));
    dWorldGetBodies(world, bodies.data(), int(bodies.size()));
    for (const dBodyID body : bodies)
        while (const dGeomID geom = dBodyGetFirstGeom(body)) dGeomDestroy(geom);
    dWorldDestroy(world);
    if (space) dSpaceDestroy(space);
    for (const dTriMeshDataID mesh : meshes)
        if (mesh) dGeomTriMeshDataDestroy(mesh);
    for (const dHeightfieldDataID field : fields) dGeomHeightfieldDataDestroy(field);
}

// What was loaded goes on in every stepper, and what is saved after that can be loaded.
void go_on(dWorldID world, dSpaceID space)
{
    constexpr dReal kStep = dReal(0.01);
    dWorldSetStepThreads(world, 1);  // else it would be threads that take the time
    dWorldStepFast1(world, kStep, 4);
    dWorldQuickStep(world, kStep);
    dWorldStepHybrid(world, kStep);
    dWorldStep(world, kStep);
    Bytes again(dWorldSaveToBuffer(world, space, nullptr, 0));
    if (dWorldSaveToBuffer(world, space, again.data(), again.size()) != again.size() || again.empty()) return;
    dSpaceID its = nullptr;
    const dWorldID copy = dWorldLoadFromBuffer(again.data(), again.size(), &its);
    if (!copy) std::abort();
    destroy(copy, its);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    static const bool ready = make_seeds();
    (void)ready;
    constexpr std::size_t kHeader = 32;
    bool steps = false;
    Bytes file(data, data + size);
    if (size > kHeader) {
        std::uint64_t structure;
        std::memcpy(&structure, &file[8], 8);
        structure = std::min<std::uint64_t>(structure, size - kHeader);
        put(file, 8, structure), put(file, 16, std::uint64_t(size - kHeader - structure));
        const std::uint64_t sum = epode::states::checksum(&file[kHeader], size - kHeader);
        put(file, 24, sum);
        steps = sum % 16 == 0;
    }
    dSpaceID space = nullptr;
    const auto load = [&] {
        const Meter meter(size);
        return dWorldLoadFromBuffer(file.data(), file.size(), &space);
    };
    const dWorldID world = load();
    if (!world) return 0;
    if (steps) go_on(world, space);
    destroy(world, space);
    return 0;
}
