// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A random mechanism, a function of its number alone: 2 to 20 bodies of masses 1e-3 ... 1e3 kg (log-uniform)
// and principal inertias up to 1:100, hung on each other and on the world by joints of every type; loops and
// duplicates of joints, all closed at the start; stops, motors; points that touch a ground and round bodies
// that touch each other, with every kind of surface; CFM 0 and 1e-10 ... 1e-3, ERP 0 ... 0.8, h 1/1000 ...
// 1/30. No thought is given to whether it can move: many are locked several times over, which is the point.
//
// Only <ode/*.h>: the same text runs on any libode. Drawing never depends on the library, so that the same
// number means the same mechanism everywhere. `without` leaves parts out without changing the others: what a
// failing case is minimised with.
#pragma once

#include <ode/ode.h>

#include <string>
#include <vector>

#include "parity/probe/random.h"

namespace epode::mechanisms {

struct BodyState {
    dReal pos[3], q[4], v[3], w[3];
};

// From this number on joints are drawn from all types but the transmission, below it from those that were
// there first: so the numbers of failed mechanisms keep their meaning.
constexpr int kAllJoints = 100000;

struct Limits {
    int least_bodies = 2, most_bodies = 20;
    bool zero_cfm = true;  // may draw CFM = 0
};

class Mechanism {
  public:
    explicit Mechanism(int number, const Limits& limits = {}, std::vector<bool> without = {});
    ~Mechanism();
    Mechanism(const Mechanism&) = delete;
    Mechanism& operator=(const Mechanism&) = delete;

    // Contacts of the last step go, those of the present poses come.
    void collide();
    int step() { return dWorldStep(world, dReal(h)); }

    std::vector<BodyState> state() const;
    void put(const std::vector<BodyState>& state);
    bool finite() const;
    std::string summary() const;

    dWorldID world;
    double h = 0, cfm = 0, erp = 0;
    std::vector<dBodyID> bodies;
    std::vector<double> mass;
    std::vector<std::string> parts;  // one line each: what it is; a part is a joint or a source of contacts
    int contact_count = 0;

  private:
    struct Foot {
        int part, body;
        dReal at[3];  // in the body
    };
    struct Ball {
        int part, body;
        double radius;
    };

    void add_bodies(const Limits& limits);
    void add_joints();
    void add_touching();
    void add_joint(int child, int parent, int kind, bool again);
    bool begin_part(const std::string& what);
    bool joined(int a, int b) const;
    void touch_ground();
    void touch_each_other();
    void contact(const dReal* at, const dReal* normal, double depth, dBodyID a, dBodyID b);
    void draw_surface();

    parity::Random random_;
    int kinds_;
    std::vector<bool> without_;
    std::vector<bool> flat_;  // held by a plane2d joint: starts at z = 0
    std::vector<Foot> feet_;
    std::vector<Ball> balls_;
    std::vector<std::pair<int, int>> pairs_;  // joined
    dJointGroupID contacts_;
    dSurfaceParameters surface_{};
    double ground_ = 0;
};

}  // namespace epode::mechanisms
