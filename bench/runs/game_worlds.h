// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds as games make them, set up by the game preset, with world-managed contacts on a plane, bodies that fall asleep, one thread.
// Names of our library only are asked for at run time.
#pragma once

#include <dlfcn.h>
#include <ode/ode.h>

#include <cstdint>
#include <vector>

namespace epode::bench {

template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}
using SetNumber = void (*)(dWorldID, int);
using MakeStep = int (*)(dWorldID, dReal);

class GameWorld {
  public:
    explicit GameWorld(int stepper);  // of dStepper
    GameWorld(const GameWorld&) = delete;
    GameWorld& operator=(const GameWorld&) = delete;
    ~GameWorld() { dSpaceDestroy(space), dWorldDestroy(world); }

    double random(double low, double high);
    dBodyID add(dGeomID geom, const dMass& mass, double x, double y, double z);
    dBodyID box(double x, double y, double z, double a, double b, double c, double density);
    dBodyID capsule(double x, double y, double z, double radius, double length, int along);
    void ball(dBodyID a, dBodyID b, double x, double y, double z);
    void hinge(dBodyID a, dBodyID b, double x, double y, double z, double ax, double ay);

    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);

  private:
    std::uint32_t state_ = 1;
};

struct GameWorldRecipe {
    const char* name;
    void (*build)(GameWorld&, int);
    int count;
    bool large = false;
};
const std::vector<GameWorldRecipe>& game_worlds();

}  // namespace epode::bench
