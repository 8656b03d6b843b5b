// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the public interface tells of a joint: its bodies, the points and axes that hold it, each brought into
// the frame of the body it is fixed to, so that a viewer needs nothing but the bodies' poses to draw it
// later.
#pragma once

#include <ode/ode.h>

#include "record/file/recording.h"

namespace epode::record {

// Everything but the numbers of the bodies.
Joint joint_of(dJointID joint);
// The distance by which the joint's two anchors part now; along the axis where the joint slides there. 0 for
// joints without two anchors.
double joint_gap(dJointID joint);

}  // namespace epode::record
