// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Between the two halves of the recorder for any program. The hooks (hooks.cpp) are preloaded and know no
// library; the observer (observer.cpp) is loaded by the first hook, when the program's own libode is there,
// and is told what happens. One file of both would have to bring a libode along, and might bring another one
// than the program's.
#pragma once

#include <ode/ode.h>

namespace epode::record {

struct Observer {
    void (*body_made)(dWorldID, dBodyID);
    void (*body_gone)(dBodyID);
    void (*geom_made)(dGeomID);
    void (*geom_gone)(dGeomID);  // of a space: with what it destroys
    void (*joint_made)(dWorldID, dJointID, dJointGroupID);
    void (*joint_gone)(dJointID);
    void (*group_emptied)(dJointGroupID);
    void (*contact_made)(dWorldID, const dContact*);
    void (*before_step)(dWorldID);
    void (*after_step)(dWorldID, dReal dt, double ms);
    void (*world_gone)(dWorldID);
};

// What the observer's library exports, by this name.
using GetObserver = const Observer* (*)();
constexpr const char* kObserverFunction = "epode_recorder_observer";
constexpr const char* kObserverFile = "libepode_observer.so";

}  // namespace epode::record
