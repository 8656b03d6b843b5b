// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The preloaded half of the recorder for any program: functions with the names of ODE's, each of which calls
// the real one of the libode that the program loaded and tells the observer. It depends on no libode itself,
// so that it can be put before any program; where the observer cannot be loaded, the program runs as if
// nothing were there.
//   EPODE_RECORD          the file to write
//   EPODE_RECORD_STEPPER  exact, quick, fast or hybrid: step with this one, whatever the program calls
// A program that finds ODE's functions by dlsym from a handle of its own (ctypes) passes by all this.
#include <dlfcn.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "record/file/calls.h"
#include "record/preload/real.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace epode::record {

namespace {

constexpr const char* kLibrary = sizeof(dReal) == 8 ? "libode.so.8" : "libode_single.so.8";

const Observer* load_observer()
{
    Dl_info here;
    if (!dladdr(reinterpret_cast<void*>(&load_observer), &here)) return nullptr;
    std::string path = here.dli_fname;
    const size_t slash = path.rfind('/');
    path.resize(slash == std::string::npos ? 0 : slash + 1);
    path.append(kObserverFile);
    void* handle = dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL);
    const auto get = handle ? reinterpret_cast<GetObserver>(dlsym(handle, kObserverFunction)) : nullptr;
    if (!get) std::fprintf(stderr, "epode recorder: nothing is recorded: %s\n", dlerror());
    return get ? get() : nullptr;
}

}  // namespace

thread_local int Outermost::depth_ = 0;

// The program's own library: loaded already, whatever the scope in which it is.
void* find_real(const char* name)
{
    static void* const library = dlopen(kLibrary, RTLD_LAZY | RTLD_NOLOAD);
    void* found = library ? dlsym(library, name) : nullptr;
    return found ? found : dlsym(RTLD_NEXT, name);
}

const Observer* observer()
{
    static const Observer* const loaded = secure_getenv("EPODE_RECORD") ? load_observer() : nullptr;
    return loaded;
}

}  // namespace epode::record

namespace {

using namespace epode::record;

// Steps with the stepper that was asked for instead of the program's own, and says so; false where there is
// none.
bool other_step(dWorldID world, StepMade& made, int& ok)
{
    using Step = int (*)(dWorldID, dReal);
    using StepFast = int (*)(dWorldID, dReal, int);
    static const char* const wanted = secure_getenv("EPODE_RECORD_STEPPER");
    if (!wanted) return false;
    if (std::strcmp(wanted, "fast") == 0) {
        static const auto fast = find<StepFast>("dWorldStepFast1");
        if (!fast) return false;
        ok = fast(world, made.dt, kFastSteps);
        made.name = "dWorldStepFast1";
        made.substeps = kFastSteps;
        return true;
    }
    static const char* const name = std::strcmp(wanted, "exact") == 0    ? "dWorldStep"
                                    : std::strcmp(wanted, "quick") == 0  ? "dWorldQuickStep"
                                    : std::strcmp(wanted, "hybrid") == 0 ? "dWorldStepHybrid"
                                                                         : "";
    static const auto step = find<Step>(name);
    if (!step) return false;
    ok = step(world, made.dt);
    made.name = name;
    made.substeps = -1;
    return true;
}

template <class Real>
int watched_step(dWorldID world, StepMade made, Real real)
{
    const Outermost outermost;
    notify(&Observer::before_step, world);
    const auto start = std::chrono::steady_clock::now();
    int ok = 0;
    if (!other_step(world, made, ok)) ok = real();
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
    made.ms = spent.count();
    notify(&Observer::after_step, world, static_cast<const StepMade*>(&made));
    return ok;
}

// Many worlds with another stepper: one after the other.
bool other_steps(const dWorldID* worlds, int count, dReal dt, int steps, int* made)
{
    if (!secure_getenv("EPODE_RECORD_STEPPER")) return false;
    for (int i = 0; i < count; ++i) {
        int done = 0;
        for (int ok = 1; done < steps && ok; done += ok) ok = dWorldStep(worlds[i], dt);
        if (made) made[i] = done;
    }
    return true;
}

dGeomID made(dGeomID geom)
{
    if (geom) notify(&Observer::geom_made, geom);
    return geom;
}

}  // namespace

#define EPODE_JOINT(Type)                                                                    \
    dJointID dJointCreate##Type(dWorldID world, dJointGroupID group)                         \
    {                                                                                        \
        EPODE_REAL(dJointCreate##Type);                                                      \
        change("dJointCreate" #Type " in a moved callback");                                 \
        dJointID joint = real(world, group);                                                 \
        if (joint) notify(&Observer::joint_made, world, joint, group, "dJointCreate" #Type); \
        return joint;                                                                        \
    }

extern "C" {

int dWorldStep(dWorldID world, dReal dt)
{
    EPODE_REAL(dWorldStep);
    return watched_step(world, {"dWorldStep", dt, -1}, [&] { return real(world, dt); });
}

int dWorldQuickStep(dWorldID world, dReal dt)
{
    EPODE_REAL(dWorldQuickStep);
    return watched_step(world, {"dWorldQuickStep", dt, -1}, [&] { return real(world, dt); });
}

int dWorldStepFast1(dWorldID world, dReal dt, int steps)
{
    EPODE_REAL(dWorldStepFast1);
    return watched_step(world, {"dWorldStepFast1", dt, steps}, [&] { return real(world, dt, steps); });
}

// Only the state after the last of its steps is seen.
int dWorldsStep(const dWorldID* worlds, int count, dReal dt, int stepper, int iterations, int steps,
                int threads, int* made)
{
    EPODE_REAL(dWorldsStep);
    if (!worlds || count <= 0 || !observer())
        return real(worlds, count, dt, stepper, iterations, steps, threads, made);
    if (other_steps(worlds, count, dt, steps, made)) return count;
    const Outermost outermost;
    for (int i = 0; i < count; ++i) notify(&Observer::before_step, worlds[i]);
    const auto start = std::chrono::steady_clock::now();
    const int ok = real(worlds, count, dt, stepper, iterations, steps, threads, made);
    const std::chrono::duration<double, std::milli> spent = std::chrono::steady_clock::now() - start;
    const StepMade step{"dWorldsStep", dt, -1, stepper, iterations, steps, spent.count() / count};
    for (int i = 0; i < count; ++i) notify(&Observer::after_step, worlds[i], &step);
    return ok;
}

int dWorldStepHybrid(dWorldID world, dReal dt)
{
    EPODE_REAL(dWorldStepHybrid);
    return watched_step(world, {"dWorldStepHybrid", dt, -1}, [&] { return real(world, dt); });
}

void dWorldDestroy(dWorldID world)
{
    EPODE_REAL_VOID(dWorldDestroy);
    notify(&Observer::world_gone, world);
    real(world);
}

dBodyID dBodyCreate(dWorldID world)
{
    EPODE_REAL(dBodyCreate);
    change("dBodyCreate in a moved callback");
    dBodyID body = real(world);
    if (body) notify(&Observer::body_made, world, body);
    return body;
}

void dBodyDestroy(dBodyID body)
{
    EPODE_REAL_VOID(dBodyDestroy);
    change("dBodyDestroy in a moved callback");
    notify(&Observer::body_gone, body);
    real(body);
}

EPODE_JOINT(Ball)
EPODE_JOINT(Hinge)
EPODE_JOINT(Slider)
EPODE_JOINT(Hinge2)
EPODE_JOINT(Universal)
EPODE_JOINT(Fixed)
EPODE_JOINT(Null)
EPODE_JOINT(AMotor)
EPODE_JOINT(LMotor)
EPODE_JOINT(Plane2D)
EPODE_JOINT(PR)
EPODE_JOINT(PU)
EPODE_JOINT(Piston)
EPODE_JOINT(DBall)
EPODE_JOINT(DHinge)
EPODE_JOINT(Transmission)

dJointID dJointCreateContact(dWorldID world, dJointGroupID group, const dContact* contact)
{
    EPODE_REAL(dJointCreateContact);
    change("dJointCreateContact in a moved callback");
    dJointID joint = real(world, group, contact);
    if (joint) notify(&Observer::contact_made, world, joint, group, contact);
    return joint;
}

void dJointDestroy(dJointID joint)
{
    EPODE_REAL_VOID(dJointDestroy);
    change("dJointDestroy in a moved callback");
    notify(&Observer::joint_gone, joint);
    real(joint);
}

void dJointGroupEmpty(dJointGroupID group)
{
    EPODE_REAL_VOID(dJointGroupEmpty);
    change("dJointGroupEmpty in a moved callback");
    notify(&Observer::group_emptied, group);
    real(group);
}

void dJointGroupDestroy(dJointGroupID group)
{
    EPODE_REAL_VOID(dJointGroupDestroy);
    change("dJointGroupDestroy in a moved callback");
    notify(&Observer::group_emptied, group);
    real(group);
}

dGeomID dCreateSphere(dSpaceID space, dReal radius)
{
    EPODE_REAL(dCreateSphere);
    return made(real(space, radius));
}

dGeomID dCreateBox(dSpaceID space, dReal x, dReal y, dReal z)
{
    EPODE_REAL(dCreateBox);
    return made(real(space, x, y, z));
}

dGeomID dCreateCapsule(dSpaceID space, dReal radius, dReal length)
{
    EPODE_REAL(dCreateCapsule);
    return made(real(space, radius, length));
}

dGeomID dCreateCylinder(dSpaceID space, dReal radius, dReal length)
{
    EPODE_REAL(dCreateCylinder);
    return made(real(space, radius, length));
}

dGeomID dCreatePlane(dSpaceID space, dReal a, dReal b, dReal c, dReal d)
{
    EPODE_REAL(dCreatePlane);
    return made(real(space, a, b, c, d));
}

dGeomID dCreateConvex(dSpaceID space, const dReal* planes, unsigned int plane_count, const dReal* points,
                      unsigned int point_count, const unsigned int* polygons)
{
    EPODE_REAL(dCreateConvex);
    return made(real(space, planes, plane_count, points, point_count, polygons));
}

dGeomID dCreateConvexHull(dSpaceID space, const dReal* points, unsigned int point_count,
                          unsigned int max_vertices)
{
    EPODE_REAL(dCreateConvexHull);
    return made(real(space, points, point_count, max_vertices));
}

dGeomID dCreateTriMesh(dSpaceID space, dTriMeshDataID data, dTriCallback* callback, dTriArrayCallback* arrays,
                       dTriRayCallback* rays)
{
    EPODE_REAL(dCreateTriMesh);
    return made(real(space, data, callback, arrays, rays));
}

dGeomID dCreateHeightfield(dSpaceID space, dHeightfieldDataID data, int placeable)
{
    EPODE_REAL(dCreateHeightfield);
    return made(real(space, data, placeable));
}

dGeomID dCreateGeomTransform(dSpaceID space)
{
    EPODE_REAL(dCreateGeomTransform);
    return made(real(space));
}

// A geom inside a transform is the transform's look and nothing by itself.
void dGeomTransformSetGeom(dGeomID transform, dGeomID geom)
{
    EPODE_REAL_VOID(dGeomTransformSetGeom);
    if (geom) notify(&Observer::geom_gone, geom);
    real(transform, geom);
}

void dGeomDestroy(dGeomID geom)
{
    EPODE_REAL_VOID(dGeomDestroy);
    notify(&Observer::geom_gone, geom);
    real(geom);
}

void dSpaceDestroy(dSpaceID space)
{
    EPODE_REAL_VOID(dSpaceDestroy);
    notify(&Observer::geom_gone, reinterpret_cast<dGeomID>(space));
    real(space);
}

}  // extern "C"
