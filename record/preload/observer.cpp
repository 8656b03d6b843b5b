// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Watches every world of a program and writes one recording each: the file that EPODE_RECORD names, then the
// same with -2, -3 ... before the ending. New things wait until the next step, when the program has set them
// up. Static geoms belong to no world and are in every recording. All calls come under one lock; calls that
// the observer's own questions cause (a ray made to sample a height field) are not for it.
#include "record/preload/observer.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "record/figures.h"
#include "record/recorder.h"
#include "record/writer.h"

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
    std::vector<ContactSeen> contacts;
};

std::map<dWorldID, std::unique_ptr<Watch>> watches;
std::vector<dGeomID> geoms;         // of all worlds, in order of making
std::vector<JointMade> in_a_group;  // not contacts
int files = 0;

std::string next_path()
{
    const char* said = std::getenv("EPODE_RECORD");
    std::string path = said && *said ? said : "recording.epr";
    if (++files == 1) return path;
    const size_t dot = path.rfind('.'), slash = path.rfind('/');
    const size_t at =
        dot == std::string::npos || (slash != std::string::npos && dot < slash) ? path.size() : dot;
    return path.insert(at, std::string("-").append(std::to_string(files)));
}

Watch& watch_of(dWorldID world)
{
    std::unique_ptr<Watch>& watch = watches[world];
    if (watch) return *watch;
    watch = std::make_unique<Watch>();
    watch->new_geoms = geoms;
    watch->path = next_path();
    if (!watch->writer.open(watch->path)) {
        std::fprintf(stderr, "epode recorder: cannot write '%s': %s\n", watch->path.c_str(),
                     watch->writer.problem().c_str());
    }
    return *watch;
}

template <class Id>
void forget(std::vector<Id>& ids, Id id)
{
    ids.erase(std::remove(ids.begin(), ids.end(), id), ids.end());
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

Info about()
{
    std::string program = "unknown";
    if (std::FILE* file = std::fopen("/proc/self/comm", "r")) {
        char name[64] = "";
        if (std::fgets(name, sizeof name, file)) program = name;
        std::fclose(file);
    }
    while (!program.empty() && program.back() == '\n') program.pop_back();
    const char* stepper = std::getenv("EPODE_RECORD_STEPPER");
    return {{"source", "program"},
            {"program", program},
            {"stepper", stepper && *stepper ? stepper : "the program's own"},
            {"precision", sizeof(dReal) == 8 ? "double" : "single"}};
}

void flush(dWorldID world, Watch& watch)
{
    if (!watch.begun) watch.writer.info(about());
    for (dBodyID body : watch.new_bodies) watch.recorder.add(body);
    std::vector<dGeomID> of_others;
    for (dGeomID geom : watch.new_geoms) {
        if (dGeomGetClass(geom) == dRayClass) continue;  // a question, not a thing
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

void sample(dWorldID world, Watch& watch, double dt, double ms)
{
    flush(world, watch);
    StepFigures figures;
    measure(world, watch.recorder.bodies(), watch.recorder.joints(), figures);
    figures.time = watch.time;
    figures.dt = dt;
    figures.ms = ms;
    watch.recorder.step(figures, watch.contacts, false);
    watch.contacts.clear();
    watch.begun = true;
}

void body_made(dWorldID world, dBodyID body)
{
    observed([&] { watch_of(world).new_bodies.push_back(body); });
}

void body_gone(dBodyID body)
{
    observed([&] {
        for (auto& [world, watch] : watches) {
            forget(watch->new_bodies, body);
            watch->recorder.remove(body);
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
    forget(geoms, geom);
    for (auto& [world, watch] : watches) {
        forget(watch->new_geoms, geom);
        watch->recorder.remove(geom);
    }
}

void geom_gone(dGeomID geom)
{
    observed([&] { forget_geom(geom); });
}

void joint_made(dWorldID world, dJointID joint, dJointGroupID group)
{
    observed([&] {
        watch_of(world).new_joints.push_back(joint);
        if (group) in_a_group.push_back({joint, group});
    });
}

void forget_joint(dJointID joint)
{
    for (auto& [world, watch] : watches) {
        forget(watch->new_joints, joint);
        watch->recorder.remove(joint);
    }
}

void joint_gone(dJointID joint)
{
    observed([&] {
        forget_joint(joint);
        std::erase_if(in_a_group, [&](const JointMade& made) { return made.joint == joint; });
    });
}

void group_emptied(dJointGroupID group)
{
    observed([&] {
        for (const JointMade& made : in_a_group) {
            if (made.group == group) forget_joint(made.joint);
        }
        std::erase_if(in_a_group, [&](const JointMade& made) { return made.group == group; });
    });
}

void contact_made(dWorldID world, const dContact* contact)
{
    observed([&] {
        const dContactGeom& g = contact->geom;
        ContactSeen seen{{g.g1, g.g2},
                         {double(g.pos[0]), double(g.pos[1]), double(g.pos[2])},
                         {double(g.normal[0]), double(g.normal[1]), double(g.normal[2])},
                         double(g.depth),
                         {0, 0, 0}};
        watch_of(world).contacts.push_back(seen);
    });
}

// The state before the first step is the first of the recording.
void before_step(dWorldID world)
{
    observed([&] {
        Watch& watch = watch_of(world);
        if (watch.begun) return;
        std::vector<ContactSeen> contacts;
        contacts.swap(watch.contacts);
        sample(world, watch, 0, 0);
        watch.contacts.swap(contacts);
    });
}

void after_step(dWorldID world, dReal dt, double ms)
{
    observed([&] {
        Watch& watch = watch_of(world);
        watch.time += double(dt);
        sample(world, watch, double(dt), ms);
    });
}

void finish(Watch& watch)
{
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

constexpr Observer kObserver = {body_made,     body_gone,    geom_made,   geom_gone,  joint_made, joint_gone,
                                group_emptied, contact_made, before_step, after_step, world_gone};

}  // namespace

}  // namespace epode::record

extern "C" __attribute__((visibility("default"))) const epode::record::Observer* epode_recorder_observer()
{
    return &epode::record::kObserver;
}
