// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/parking.h"

#include "base/objects/pool.h"

namespace epode {

int Parking::find(const void* object) const
{
    for (int i = parked_.size(); i-- > 0;)
        if (parked_.data()[i].object == object) return i;
    return -1;
}

bool Parking::reserve_groups()
{
    returned_.clear();
    if (!returned_.reserve(parked_.size())) return false;
    for (const Entry& entry : parked_)
        if (JointGroup* group = from_handle<JointGroup>(entry.group))
            if (!group->joints.reserve(group->joints.size() + parked_.size())) return false;
    return true;
}

void Parking::enter_groups()
{
    for (const Returned& r : returned_) {
        JointGroup* const group = from_handle<JointGroup>(r.group);
        r.joint->grouped = group && group->joints.push(r.joint);
    }
    returned_.clear();
}

void Parking::destroy_before(std::uint64_t frame)
{
    for (int i = parked_.size(); i-- > 0;)
        if (parked_[i].last < frame) {
            const Entry entry = parked_[i];
            parked_.remove_swap(i);
            destroy(entry);
        }
}

void Parking::forget_after(std::uint64_t frame)
{
    for (Entry& entry : parked_) entry.last = entry.last < frame ? entry.last : frame;
}

// A joint that a group still holds stays there, without world and bodies, until the group is emptied.
void Parking::destroy(const Entry& entry)
{
    switch (entry.kind) {
        case Kind::kBody:
            return Pool<Body>::destroy(static_cast<Body*>(entry.object));
        case Kind::kJoint: {
            auto& joint = *static_cast<Joint*>(entry.object);
            joint.tag = HandleOf<Joint>::kTag;
            if (!joint.grouped) joint.type->destroy(joint);
            return;
        }
        case Kind::kGeom: {
            auto& geom = *static_cast<Geom*>(entry.object);
            geom.tag = HandleOf<Geom>::kTag;
            return destroy_geom(geom);
        }
    }
}

}  // namespace epode
