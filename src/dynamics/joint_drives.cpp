// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/joint_drives.h"

#include <new>

#include "base/memory.h"
#include "base/objects/structure_edition.h"
#include "dynamics/world.h"

namespace epode {

JointDrives* take_drives(LastingJoint& joint)
{
    if (joint.drives) return joint.drives;
    void* const memory = allocate(sizeof(JointDrives));
    if (!memory) return nullptr;
    joint.drives = new (memory) JointDrives;
    joint.driven = true;
    note_structure_changed();
    if (joint.world) ++joint.world->driven_joints;
    return joint.drives;
}

LastingJoint::~LastingJoint()
{
    if (drives) release(drives, sizeof *drives);
}

}  // namespace epode
