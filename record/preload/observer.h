// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Between the two halves of the recorder for any program. The hooks (hooks.cpp, setters.cpp) are preloaded
// and know no library; the observer (observer.cpp) is loaded by the first hook, when the program's own libode
// is there, and is notified of what happens. One file of both would have to bring a libode along, and might bring
// another one than the program's.
#pragma once

#include <ode/ode.h>

namespace epode::record {

// An argument of a call.
struct Given {
    enum Kind { kWorld, kBody, kJoint, kNumber, kInteger, kNumbers, kMass } kind;
    const void* handle = nullptr;
    double number = 0;
    int integer = 0;
    const dReal* numbers = nullptr;
    int count = 0;
    const dMass* mass = nullptr;
};

// How a world was stepped.
struct StepMade {
    const char* name;
    dReal dt;
    int substeps;                                // of dWorldStepFast1; -1: it has none
    int stepper = 0, iterations = 0, steps = 1;  // of dWorldsStep
    double ms = 0;
};

struct Observer {
    void (*body_made)(dWorldID, dBodyID);
    void (*body_gone)(dBodyID);
    void (*geom_made)(dGeomID);
    void (*geom_gone)(dGeomID);  // of a space: with what it destroys
    void (*joint_made)(dWorldID, dJointID, dJointGroupID, const char* name);
    void (*joint_gone)(dJointID);
    void (*group_emptied)(dJointGroupID);
    void (*contact_made)(dWorldID, dJointID, dJointGroupID, const dContact*);
    // Something that changes what steps compute from; the first argument tells which world's. Without
    // arguments it concerns them all and cannot be done again from a recording.
    void (*called)(const char* name, const Given*, int count);
    void (*before_step)(dWorldID);
    void (*after_step)(dWorldID, const StepMade*);
    void (*world_gone)(dWorldID);
};

// What the observer's library exports, by this name.
using GetObserver = const Observer* (*)();
constexpr const char* kObserverFunction = "epode_recorder_observer";
constexpr const char* kObserverFile = "libepode_observer.so";

}  // namespace epode::record
