// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The life of a scene and one step of it. Contacts use friction that scales with the normal force
// (dContactApprox1), as real friction does. Pairs that a joint connects are left out: their overlap is meant.
#include "scenes/scene.h"

#include <algorithm>
#include <chrono>

#include "scenes/characters.h"
#include "scenes/extensions.h"

namespace epode::scenes {

namespace {

constexpr int kMaxContactsPerPair = 32;
constexpr int kDefaultSweeps = 20;
constexpr int kDefaultSubsteps = 4;

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::time_point from, Clock::time_point to)
{
    return std::chrono::duration<double, std::milli>(to - from).count();
}

bool moves(dBodyID body) { return body && dBodyIsEnabled(body); }

}  // namespace

const char* name_of(Stepper stepper)
{
    switch (stepper) {
        case Stepper::kExact:
            return "exact";
        case Stepper::kQuick:
            return "quick";
        case Stepper::kFast:
            return "fast";
        case Stepper::kHybrid:
            return "hybrid";
    }
    return "";
}

bool stepper_named(const std::string& name, Stepper& stepper)
{
    for (Stepper candidate : kSteppers) {
        if (name == name_of(candidate)) {
            stepper = candidate;
            return true;
        }
    }
    return false;
}

std::string no_such_stepper(const std::string& name)
{
    return "there is no stepper '" + name + "'. Steppers: exact quick fast hybrid";
}

bool available(Stepper stepper)
{
    if (stepper == Stepper::kHybrid) return has_step_hybrid();
    return stepper != Stepper::kFast || has_step_fast();
}

Setting recommended(const Recipe& recipe)
{
    const bool game = recipe.stepper == Stepper::kQuick && has_world_contacts() && has_step_fast();
    return game ? Setting{Stepper::kFast, true} : Setting{recipe.stepper, false};
}

Runtime::Runtime()
{
    dInitODE2(0);
    dAllocateODEDataForThread(dAllocateMaskAll);
}

Runtime::~Runtime() { dCloseODE(); }

Scene::Scene(const Recipe& recipe, std::uint32_t seed)
    : recipe_(recipe),
      seed_(seed),
      world_(dWorldCreate()),
      space_(dHashSpaceCreate(nullptr)),
      contact_group_(dJointGroupCreate(0))
{
    dHashSpaceSetLevels(space_, -3, 5);
    dWorldSetGravity(world_, 0, 0, dReal(-9.81));
    surface.mode = dContactApprox1;
    surface.mu = dReal(0.6);
    recipe.build(*this);
    if (tracked.empty() && !bodies_.empty()) tracked.push_back(bodies_.front());
}

Scene::~Scene()
{
    dJointGroupDestroy(contact_group_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
}

void Scene::add_joint(dJointID joint)
{
    JointRecord record{joint, {0, 0, 0}};
    dBodyID body1 = dJointGetBody(joint, 0), body2 = dJointGetBody(joint, 1);
    if (body1) {
        const dReal* origin = body2 ? dBodyGetPosition(body2) : nullptr;
        dVector3 local;
        dBodyGetPosRelPoint(body1, origin ? origin[0] : 0, origin ? origin[1] : 0, origin ? origin[2] : 0,
                            local);
        std::copy_n(local, 3, record.reference);
    }
    joints_.push_back(record);
}

void Scene::near_callback(void* scene, dGeomID geom1, dGeomID geom2)
{
    static_cast<Scene*>(scene)->collide_pair(geom1, geom2);
}

void Scene::collide_pair(dGeomID geom1, dGeomID geom2)
{
    if (dGeomIsSpace(geom1) || dGeomIsSpace(geom2)) {
        dSpaceCollide2(geom1, geom2, this, &near_callback);
        return;
    }
    dBodyID body1 = dGeomGetBody(geom1), body2 = dGeomGetBody(geom2);
    if (!moves(body1) && !moves(body2)) return;
    if (is_character(geom1) || is_character(geom2)) return;
    if (body1 && body2 && dAreConnectedExcluding(body1, body2, dJointTypeContact)) return;

    dContact contact[kMaxContactsPerPair];
    const int wanted = std::clamp(contacts_per_pair, 1, kMaxContactsPerPair);
    const int count = dCollide(geom1, geom2, wanted, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        contact[i].surface = surface;
        if (!on_contact || on_contact(geom1, geom2, contact[i])) make_contact(body1, body2, contact[i]);
    }
}

void Scene::make_contact(dBodyID body1, dBodyID body2, dContact& contact)
{
    const dContactGeom& g = contact.geom;
    for (int copy = 0; copy < contact_copies; ++copy) {
        dJointID joint = dJointCreateContact(world_, contact_group_, &contact);
        dJointAttach(joint, body1, body2);
        contacts_.push_back({g.g1,
                             g.g2,
                             {g.pos[0], g.pos[1], g.pos[2]},
                             {g.normal[0], g.normal[1], g.normal[2]},
                             g.depth,
                             {}});
        if (want_forces_) dJointSetFeedback(joint, &feedback_.emplace_back());
    }
}

// Where one body is attached the library writes the force on it as the first, whichever geom it belongs to;
// what a static geom1 would feel is the opposite.
void Scene::read_forces()
{
    for (size_t i = 0; i < feedback_.size(); ++i) {
        const double sign = dGeomGetBody(contacts_[i].geom1) ? 1 : -1;
        for (int k = 0; k < 3; ++k) contacts_[i].force[k] = sign * double(feedback_[i].f1[k]);
    }
}

int Scene::advance(Stepper stepper, double dt)
{
    const dReal h = dReal(dt);
    if (stepper == Stepper::kExact) return dWorldStep(world_, h);
    const int substeps = iterations_ > 0 ? iterations_ : kDefaultSubsteps;
    if (stepper == Stepper::kFast) return step_fast(world_, h, substeps);
    if (stepper == Stepper::kHybrid) return step_hybrid(world_, h, substeps);
    dWorldSetQuickStepNumIterations(world_, iterations_ > 0 ? iterations_ : kDefaultSweeps);
    return dWorldQuickStep(world_, h);
}

bool Scene::manage_contacts(std::string& problem)
{
    if (!has_world_contacts()) problem = loaded_library() + " has no world-managed contacts";
    if (contact_copies != 1 || on_contact)
        problem =
            std::string("the scene '") + recipe_.name +
            "' makes contacts of its own, which the world would not: it cannot be run with --world-contacts";
    if (!problem.empty()) return false;
    set_contact_space(world_, space_);
    world_contacts_ = true;
    return true;
}

void Scene::step_precisely(int parts)
{
    parts_ = set_exact_rotation(world_, true) && set_exact_substeps(world_, parts) ? parts : 0;
}

void Scene::set_materials()
{
    for (; materials_ < geoms_.size(); ++materials_) set_material(geoms_[materials_], surface);
}

void Scene::read_world_contacts()
{
    contacts_.clear();
    for (const WorldContact& from : world_contacts(world_)) {
        ContactRecord& to = contacts_.emplace_back();
        to.geom1 = from.geom1;
        to.geom2 = from.geom2;
        to.depth = from.depth;
        for (int k = 0; k < 3; ++k) {
            to.pos[k] = from.pos[k];
            to.normal[k] = from.normal[k];
            to.force[k] = from.normal_force * from.normal[k] + from.friction_force[k];
        }
    }
}

bool Scene::step(Stepper stepper, double dt)
{
    for (auto& hook : hooks_) hook(time_, dt);
    contacts_.clear();
    feedback_.clear();
    if (world_contacts_) set_materials();

    const auto start = Clock::now();
    if (!world_contacts_) dSpaceCollide(space_, this, &near_callback);
    const auto collided = Clock::now();
    const int ok = advance(stepper, dt);
    const auto stepped = Clock::now();
    if (world_contacts_) {
        read_world_contacts();
    } else {
        read_forces();
        dJointGroupEmpty(contact_group_);
    }
    const auto emptied = Clock::now();

    times_ = {milliseconds(start, collided), milliseconds(collided, stepped), milliseconds(stepped, emptied)};
    time_ += dt;
    return ok != 0;
}

}  // namespace epode::scenes
