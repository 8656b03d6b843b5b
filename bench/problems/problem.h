// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A constraint problem that any library sees with the same numbers: bodies in a given state, joints, and
// contacts given outright instead of found by a collider, since two libraries need not find the same points.
// Before each step every body is put back to its start with its velocity of the start plus a draw from a
// generator of our own, and the contact joints are created again as a program would make them; then one
// dWorldStep is timed, nothing else. Contacts kept from step to step were the alternative: no program does
// so.
#pragma once

#include <ode/ode.h>

#include <cstdint>
#include <vector>

#include "scenes/build.h"

namespace epode::bench {

constexpr double kProblemDt = 0.01;
constexpr int kStatic = -1;

struct BatchPoint {
    int body1 = 0, body2 = kStatic;  // by order of creation
    scenes::Vec pos, normal;         // into body1
    double depth = 0;
};

class Problem {
  public:
    Problem();
    ~Problem();
    Problem(const Problem&) = delete;
    Problem& operator=(const Problem&) = delete;

    int add_body(const dMass& mass, scenes::Vec pos, scenes::Turn turn = {}, scenes::Vec linear = {},
                 scenes::Vec angular = {});
    void add_contact(const BatchPoint& contact) { contacts_.push_back(contact); }
    // The second body may be kStatic.
    void add_ball(int body1, int body2, scenes::Vec anchor);
    void add_hinge(int body1, int body2, scenes::Vec anchor, scenes::Vec axis);

    // Draws are uniform in -spread ... spread, m/s and rad/s.
    void set_spread(double spread) { spread_ = spread; }

    // State number `draw`: 0 is the first; equal numbers give equal states.
    void prepare(std::uint32_t draw);
    // One dWorldStep from the prepared state; its milliseconds of one processor.
    double step();

    dWorldID world() const { return world_; }
    const std::vector<dBodyID>& bodies() const { return bodies_; }
    int rows() const { return joint_rows_ + 3 * int(contacts_.size()); }

  private:
    struct State {
        scenes::Vec pos;
        scenes::Turn turn;
        scenes::Vec linear, angular;
    };

    dBodyID body(int index) const { return index == kStatic ? nullptr : bodies_[size_t(index)]; }
    void make_contact(const BatchPoint& point);

    dWorldID world_;
    dJointGroupID contact_group_;
    std::vector<dBodyID> bodies_;
    std::vector<State> start_;
    std::vector<BatchPoint> contacts_;
    double spread_ = 0.05;
    int joint_rows_ = 0;
};

}  // namespace epode::bench
