// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One line per joint type: how to make one, give it its geometry, set its parameters and read all it tells.
// Cases that ask the same of every type walk this table; what is peculiar to one type stands in its own
// step_* file. Readings that differ on purpose (PR and PU position rates, differences.tsv D15) are left out.
#pragma once

#include "limit_states.h"

#include <vector>

namespace parity {

// Where a joint is put: an anchor, three unit vectors of a right-handed frame and a direction of its own.
struct JointPlace {
    Vec3 p, n, m, k, s;
};

JointPlace random_place(Random& random);

struct JointKind {
    const char* name;
    dJointID (*create)(dWorldID, dJointGroupID);
    void (*place)(dJointID, const JointPlace&);
    void (*read)(Output&, const std::string& key, dJointID);
    SetParam set;  // null where the type has no parameters
    GetParam get;
    bool two_bodies;  // cannot be attached to the world
    // The angles about these axes are readings of the type; null where it has none.
    Get3 first_axis, second_axis;
};

const std::vector<JointKind>& every_joint();

// Geometry of a kind at a random place.
void place_at_random(const JointKind& kind, dJointID joint, Random& random);

const std::vector<Attach>& attachments_of(const JointKind& kind);

}  // namespace parity
