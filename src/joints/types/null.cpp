// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Null: no rows, J has no line. It only connects two bodies, for islands and dAreConnected.
#include "joints/registry.h"

namespace epode {

struct Null : LastingJoint {
    static constexpr int kMaxRows = 0;
    static constexpr const char* kDifName = "null_joint";
    Null(const JointType& t, World& w) : LastingJoint(t, w) {}
    void emit(RowWriter&) const {}
    void structure(StructureStream&) {}
    void describe(DifWriter&) const {}
};

JOINT_DEFINE(Null);

}  // namespace epode

extern "C" dJointID dJointCreateNull(dWorldID w, dJointGroupID g)
{
    return epode::create_joint<epode::Null>(w, g);
}
