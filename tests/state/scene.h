// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world with some of everything that a step remembers: piles of all shapes that come to rest and sleep, a
// mesh and a box as ground, a fast body that is continuous, a chain of joints of every type with motors and
// stops, gears. The same calls build the same structure, in any world.
#pragma once

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cstring>
#include <random>
#include <string>
#include <vector>

namespace epode::states {

enum class Stepper { kExact, kQuick, kSubsteps, kHybrid };
inline constexpr Stepper kSteppers[] = {Stepper::kExact, Stepper::kQuick, Stepper::kSubsteps,
                                        Stepper::kHybrid};
const char* name_of(Stepper stepper);
void step_with(Stepper stepper, dWorldID world, dReal h, int substeps);

struct Setting {
    Stepper stepper = Stepper::kExact;
    bool world_contacts = true;  // world-managed contacts, or in ODE's way
    bool joints = true;
    bool sleeps = true;
    bool exact_rotation = false;
    int piles = 9;
    int threads = 1;
};

using Bytes = std::vector<unsigned char>;

// What it takes to step a world, a copy of a scene's too.
struct Running {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    Stepper stepper;
    bool world_contacts;
    void step() const;  // contact joints are gone afterwards
};

Bytes state_of(dWorldID world);

class Scene {
  public:
    explicit Scene(const Setting& setting);
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    void step();  // contact joints are gone afterwards
    void steps(int count)
    {
        for (int i = 0; i < count; ++i) step();
    }

    Running running() const { return {world, space, contacts, setting.stepper, setting.world_contacts}; }
    Bytes save() const { return state_of(world); }
    bool load(const Bytes& state) const { return dWorldSetState(world, state.data(), state.size()) == 1; }

    int asleep() const;

    const Setting setting;
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    std::vector<dBodyID> bodies;
    std::vector<dJointID> joints;
    std::vector<dGeomID> grounds;

  private:
    dBodyID add(int kind, dReal x, dReal y, dReal z);
    void add_pile(int i);
    void add_joints();
    void add_grounds();
    template <typename Set>
    dJointID join(dJointID joint, int a, int b, Set&& set);

    dTriMeshDataID mesh_ = nullptr;
};

// How far states agree, or "" if they do throughout.
std::string difference(const Bytes& a, const Bytes& b);

// The last message of the debug channel, while it lives.
class Messages {
  public:
    Messages();
    ~Messages();
    Messages(const Messages&) = delete;
    Messages& operator=(const Messages&) = delete;
    static std::string last();
    static int count();
};

}  // namespace epode::states
