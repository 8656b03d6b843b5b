// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The contacts that a program made for a step, and the forces that the step gave them.
#pragma once

#include <ode/ode.h>

#include <vector>

#include "record/watch/recorder.h"

namespace epode::record {

class ContactForces {
  public:
    void add(dJointID joint, dJointGroupID group, const dContactGeom& geom);
    // Destroyed before the step: it stays among the contacts, without a force.
    void forget(dJointID joint);
    void forget(dJointGroupID group);

    // Before and after the step.
    void ask();
    std::vector<ContactSeen> take();

  private:
    struct Made {
        dJointID joint;  // null: gone
        dJointGroupID group;
        bool ours = false;  // the feedback
    };
    std::vector<ContactSeen> seen_;
    std::vector<Made> made_;
    std::vector<dJointFeedback> feedback_;
};

}  // namespace epode::record
