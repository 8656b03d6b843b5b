// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Watches every world of a program and writes one recording each: the file that EPODE_RECORD names, then the
// same with -2, -3 ... before the ending. New things wait until the next step, when the program has set them
// up. Static geoms belong to no world and are in every recording. All calls come under one lock; calls that
// the observer's own queries cause (a ray made to sample a height field) are not for it. Forces of contacts
// are asked for by a feedback of our own where the program has none, for the time of the step.
#include "record/preload/observer.h"

#include <dlfcn.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "record/file/file_names.h"
#include "record/file/writer.h"
#include "record/preload/contact_forces.h"
#include "record/preload/tape.h"
#include "record/watch/figures.h"
#include "record/watch/recorder.h"

namespace epode::record {

namespace {

std::recursive_mutex lock;
thread_local bool inside = false;

struct JointMade {
    dJointID joint;
    dJointGroupID group;
};

// One world's recording.
struct Watch {
    FileWriter writer;
    Recorder recorder{writer};
    std::string path;
    double time = 0;
    bool begun = false;
    std::vector<dBodyID> new_bodies;
    std::vector<dJointID> new_joints;
    std::vector<dGeomID> new_geoms;
    ContactForces contacts;  // made since the last step
    WorldTape tape;
};

std::map<dWorldID, std::unique_ptr<Watch>> watches;
std::vector<dGeomID> geoms;         // of all worlds, in order of making
std::vector<JointMade> in_a_group;  // not contacts
std::vector<const char*> beyond;    // what no recording can do again
int files = 0;

std::string next_path()
{
    const char* said = secure_getenv("EPODE_RECORD");
    return numbered_path(said && *said ? said : "recording.epr", ++files);
}

Watch& watch_of(dWorldID world)
{
    std::unique_ptr<Watch>& watch = watches[world];
    if (watch) return *watch;
    watch = std::make_unique<Watch>();
    watch->new_geoms = geoms;
    for (const char* name : beyond) watch->tape.called(name, nullptr, 0);
    return *watch;
}

// Files are numbered in the order in which worlds get bodies or are stepped.
void open(Watch& watch)
{
    if (!watch.path.empty()) return;
    watch.path = next_path();
    if (!watch.writer.open(watch.path)) {
        std::fprintf(stderr, "epode recorder: cannot write '%s': %s\n", watch.path.c_str(),
                     watch.writer.problem().c_str());
    }
}

// Everything that happens runs through this.
template <class Action>
void observed(Action action)
{
    if (inside) return;
    inside = true;
    {
        const std::lock_guard guard(lock);
        action();
    }
    inside = false;
}

// The libode that the program runs on, by a function that no hook stands for.
std::string library_file()
{
    Dl_info info;
    const bool found = dladdr(reinterpret_cast<void*>(&dWorldGetGravity), &info) && info.dli_fname;
    return found ? info.dli_fname : "";
}

std::string library()
{
    std::error_code error;
    const auto path = std::filesystem::canonical(library_file(), error);
    return path.empty() ? "unknown" : path.string();
}

// Asked of that library alone: in the process at large the hooks have every name.
const char* library_kind()
{
    void* handle = dlopen(library_file().c_str(), RTLD_LAZY | RTLD_NOLOAD);
    if (!handle) return "unknown";
    const char* kind = dlsym(handle, "dWorldGetStepReport") ? "Epode" : "ODE";
    dlclose(handle);
    return kind;
}

Info about()
{
    std::string program = "unknown";
    if (std::FILE* file = std::fopen("/proc/self/comm", "r")) {
        char name[64] = "";
        if (std::fgets(name, sizeof name, file)) program = name;
        std::fclose(file);
    }
    while (!program.empty() && program.back() == '\n') program.pop_back();
    const char* stepper = secure_getenv("EPODE_RECORD_STEPPER");
    return {{"source", "program"},
            {"program", program},
            {"stepper", stepper && *stepper ? stepper : "the program's own"},
            {"precision", kPrecision},
            {"library", library()},
            {"library_kind", library_kind()},
            {"library_configuration", dGetConfiguration()}};
}

void flush(dWorldID world, Watch& watch)
{
    if (!watch.begun) watch.writer.info(about());
    for (dBodyID body : watch.new_bodies) watch.recorder.add(body);
    std::vector<dGeomID> of_others;
    for (dGeomID geom : watch.new_geoms) {
        if (dGeomGetClass(geom) == dRayClass) continue;  // a query, not an object
        dBodyID body = dGeomGetBody(geom);
        if (!body || dBodyGetWorld(body) == world) {
            watch.recorder.add(geom);
        } else {
            of_others.push_back(geom);
        }
    }
    for (dJointID joint : watch.new_joints) watch.recorder.add(joint);
    watch.new_bodies.clear();
    watch.new_geoms = of_others;
    watch.new_joints.clear();
}

void sample(dWorldID world, Watch& watch, const std::vector<ContactSeen>& contacts, double dt, double ms)
{
    flush(world, watch);
    if (!watch.tape.empty()) watch.writer.calls(watch.tape.take());
    StepFigures figures;
    measure(world, watch.recorder.bodies(), watch.recorder.joints(), figures);
    figures.time = watch.time;
    figures.dt = dt;
    figures.ms = ms;
    watch.recorder.step(figures, contacts, true);
    watch.begun = true;
}

void body_made(dWorldID world, dBodyID body)
{
    observed([&] {
        Watch& watch = watch_of(world);
        open(watch);
        watch.new_bodies.push_back(body);
        watch.tape.body_made(body);
    });
}

void body_gone(dBodyID body)
{
    observed([&] {
        for (auto& [world, watch] : watches) {
            std::erase(watch->new_bodies, body);
            watch->recorder.remove(body);
            watch->tape.body_gone(body);
        }
    });
}

void geom_made(dGeomID geom)
{
    observed([&] {
        geoms.push_back(geom);
        for (auto& [world, watch] : watches) watch->new_geoms.push_back(geom);
    });
}

void forget_geom(dGeomID geom)
{
    if (dGeomIsSpace(geom)) {
        dSpaceID space = reinterpret_cast<dSpaceID>(geom);
        if (!dSpaceGetCleanup(space)) return;
        for (int i = 0; i < dSpaceGetNumGeoms(space); ++i) forget_geom(dSpaceGetGeom(space, i));
        return;
    }
    std::erase(geoms, geom);
    for (auto& [world, watch] : watches) {
        std::erase(watch->new_geoms, geom);
        watch->recorder.remove(geom);
    }
}

void geom_gone(dGeomID geom)
{
    observed([&] { forget_geom(geom); });
}

void joint_made(dWorldID world, dJointID joint, dJointGroupID group, const char* name)
{
    observed([&] {
        Watch& watch = watch_of(world);
        watch.new_joints.push_back(joint);
        watch.tape.joint_made(name, joint, group);
        if (group) in_a_group.push_back({joint, group});
    });
}

void forget_joint(dJointID joint)
{
    for (auto& [world, watch] : watches) {
        std::erase(watch->new_joints, joint);
        watch->recorder.remove(joint);
    }
}

void joint_gone(dJointID joint)
{
    observed([&] {
        forget_joint(joint);
        for (auto& [world, watch] : watches) {
            watch->contacts.forget(joint);
            watch->tape.joint_gone(joint);
        }
        std::erase_if(in_a_group, [&](const JointMade& made) { return made.joint == joint; });
    });
}

void group_emptied(dJointGroupID group)
{
    observed([&] {
        for (auto& [world, watch] : watches) {
            watch->contacts.forget(group);
            watch->tape.group_emptied(group);
        }
        for (const JointMade& made : in_a_group) {
            if (made.group == group) forget_joint(made.joint);
        }
        std::erase_if(in_a_group, [&](const JointMade& made) { return made.group == group; });
    });
}

void contact_made(dWorldID world, dJointID joint, dJointGroupID group, const dContact* contact)
{
    observed([&] {
        Watch& watch = watch_of(world);
        watch.contacts.add(joint, group, contact->geom);
        watch.tape.contact_made(joint, group, *contact);
    });
}

dWorldID world_of(const Given& given)
{
    void* handle = const_cast<void*>(given.handle);
    if (given.kind == Given::kWorld) return static_cast<dWorldID>(handle);
    if (given.kind == Given::kBody && handle) return dBodyGetWorld(static_cast<dBodyID>(handle));
    for (auto& [world, watch] : watches) {
        if (given.kind == Given::kJoint && watch->tape.knows(static_cast<dJointID>(handle))) return world;
    }
    return nullptr;
}

void called(const char* name, const Given* given, int count)
{
    observed([&] {
        if (count == 0) {
            if (std::find(beyond.begin(), beyond.end(), name) != beyond.end()) return;
            beyond.push_back(name);
            for (auto& [world, watch] : watches) watch->tape.called(name, nullptr, 0);
        } else if (dWorldID world = world_of(given[0])) {
            watch_of(world).tape.called(name, given, count);
        }
    });
}

// The state before the first step is the first of the recording.
void before_step(dWorldID world)
{
    observed([&] {
        Watch& watch = watch_of(world);
        open(watch);
        if (!watch.begun) sample(world, watch, {}, 0, 0);
        watch.contacts.ask();
    });
}

void after_step(dWorldID world, const StepMade* made)
{
    observed([&] {
        Watch& watch = watch_of(world);
        const double dt = double(made->dt) * made->steps;
        watch.time += dt;
        if (std::strcmp(made->name, "dWorldsStep") == 0) {
            watch.tape.stepped_many(double(made->dt), made->stepper, made->iterations, made->steps);
        } else {
            watch.tape.stepped(made->name, double(made->dt), made->substeps);
        }
        sample(world, watch, watch.contacts.take(), dt, made->ms);
    });
}

void finish(Watch& watch)
{
    if (watch.path.empty()) return;
    if (!watch.begun) watch.writer.info(about());
    if (!watch.writer.close())
        std::fprintf(stderr, "epode recorder: cannot write '%s': %s\n", watch.path.c_str(),
                     watch.writer.problem().c_str());
}

void world_gone(dWorldID world)
{
    observed([&] {
        const auto found = watches.find(world);
        if (found == watches.end()) return;
        finish(*found->second);
        watches.erase(found);
    });
}

// A program that ends without destroying its worlds.
struct AtExit {
    ~AtExit()
    {
        for (auto& [world, watch] : watches) finish(*watch);
        watches.clear();
    }
} at_exit;

constexpr Observer kObserver = {body_made,     body_gone,    geom_made, geom_gone,   joint_made, joint_gone,
                                group_emptied, contact_made, called,    before_step, after_step, world_gone};

}  // namespace

}  // namespace epode::record

extern "C" __attribute__((visibility("default"))) const epode::record::Observer* epode_recorder_observer()
{
    return &epode::record::kObserver;
}
