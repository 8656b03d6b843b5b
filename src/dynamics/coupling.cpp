// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/coupling.h"

#include <algorithm>

#include "dynamics/active.h"
#include "dynamics/world.h"

namespace epode {
namespace {

void remove(Array<CouplingJoint*>& all, const CouplingJoint* one)
{
    CouplingJoint** const end = std::remove(all.begin(), all.end(), one);
    all.truncate(int(end - all.begin()));
}

void empty_places_of(const Joint& member, CouplingJoint& coupling)
{
    for (CoupledAxis& place : coupling.member)
        if (place.joint == &member) {
            place = {};
            coupling.disabled = true;
            forget_impulses(coupling);
        }
}

}  // namespace

bool acts(const CouplingJoint& coupling)
{
    if (coupling.disabled) return false;
    bool whole = true, moves = false;
    for_each_member(coupling, [&](const CoupledAxis& member) {
        whole = whole && member.joint->attached() && !member.joint->disabled;
    });
    for_each_body(coupling, [&](const Body& body) { moves = moves || !body.kinematic(); });
    return whole && moves;
}

bool list_coupling(CouplingJoint& coupling)
{
    Array<CouplingJoint*>& all = coupling.world->couplings;
    return std::find(all.begin(), all.end(), &coupling) != all.end() || all.push(&coupling);
}

void leave_couplings(Joint& joint)
{
    if (is_coupling(joint)) {
        remove(joint.world->couplings, &coupling_of(joint));
        for (CoupledAxis& place : coupling_of(joint).member) place = {};
    } else if (joint.coupled) {
        for (CouplingJoint* coupling : joint.world->couplings) empty_places_of(joint, *coupling);
    }
}

void activate_couplings(World& world)
{
    for (CouplingJoint* coupling : world.couplings) {
        bool active = false;
        for_each_body(*coupling, [&](const Body& body) { active = active || is_active(body); });
        if (active) world.joints.activate(*coupling);
    }
}

}  // namespace epode
