// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world that lives long: shapes of every kind on a plane, a landscape and a mesh, chains, levers far longer than their radius of
// gyration, drives. Nothing in it makes energy, but what is dropped into it.
#pragma once

#include <ode/ext.h>
#include <ode/ode.h>

#include <cstdint>
#include <random>
#include <string>
#include <vector>

namespace epode::soak {

using Bytes = std::vector<unsigned char>;

// Each step by another stepper and of another size, in ODE's defaults with settings that change; or as a preset is meant: by
// dWorldStepHybrid, each of this size.
struct Habit {
    bool has_preset = false;
    int preset = dDefaultsOde;
    double size = 1.0 / 60;
};

class SoakedWorld {
  public:
    explicit SoakedWorld(std::uint64_t seed, const Habit& habit = {});
    ~SoakedWorld();
    SoakedWorld(const SoakedWorld&) = delete;
    SoakedWorld& operator=(const SoakedWorld&) = delete;

    // One step by a stepper chosen at random, in one of 8 by a copy, too. Empty, or what is wrong.
    std::string step();
    void change();  // something of the world's settings, bodies or joints

    long steps = 0, copies = 0, files = 0, states = 0, contained = 0;
    long by_stepper[4] = {};
    double largest_gain = 0;  // of energy in a step, J
    double fastest = 0;       // m/s

  private:
    struct Step {
        int stepper;
        dReal size;
        int substeps;
        int operator()(dWorldID world) const;
    };
    Step next_step();
    int below(int n) { return int(random_() % std::uint64_t(n)); }
    double between(double low, double high)
    {
        return low + (high - low) * double(random_() >> 11) / double(1ull << 53);
    }
    void make_ground();
    dGeomID make_shape(dMass& mass);
    void drop();  // a body, in place of the oldest
    void tie();   // the newest two
    void tune();
    Bytes state_of(dWorldID world) const;
    std::string roll_back(const Step& step);
    std::string follow_copy(const Step& step, const Bytes& before);
    std::string judge(const Step& step);

    const Habit habit_;
    std::mt19937_64 random_;
    dWorldID world_;
    dSpaceID space_;
    dTriMeshDataID mesh_;
    dHeightfieldDataID field_;
    std::vector<dBodyID> bodies_;
};

}  // namespace epode::soak
