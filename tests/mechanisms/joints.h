// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints with random geometry, stops, motors and softness, between two bodies in their present poses: closed
// where they are made. The second body may be null, except for a hinge-2.
#pragma once

#include <ode/ode.h>

#include <string>

#include "parity/probe/random.h"

namespace epode::mechanisms {

enum Kind {
    kBall,
    kHinge,
    kSlider,
    kUniversal,
    kHinge2,
    kFixed,
    kUserMotor,
    kEulerMotor,
    kLinearMotor,
    kPlane2D,
    kFirstKinds,  // up to here: the joints of mechanisms below kAllJoints
    kPR = kFirstKinds,
    kPU,
    kPiston,
    kDBall,
    kDHinge,
    kKinds
};

const char* name_of(int kind);

double log_uniform(parity::Random& random, double low, double high);

// Draws the same numbers whether it makes the joint or not.
void make_joint(int kind, dWorldID world, parity::Random& random, dBodyID a, dBodyID b, bool make,
                std::string& text);

}  // namespace epode::mechanisms
