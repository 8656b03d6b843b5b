// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What all joint types have in common: type, data, bodies, enabling, feedback, geometry set before, after and
// without attachment, re-attachment in every order, groups, and what the end of a body or world leaves.
#include "every_joint.h"

namespace parity {
namespace {

double flag(bool value) { return value ? 1.0 : 0.0; }

void put_links(Output& out, const std::string& key, const Rig& rig, dJointID joint)
{
    const auto which = [&](int i) {
        const dBodyID body = dJointGetBody(joint, i);
        return body == nullptr ? 0.0 : body == rig.a() ? 1.0 : 2.0;
    };
    out.put(key + ".links", {static_cast<double>(dJointGetNumBodies(joint)), which(0), which(1), which(2),
                             static_cast<double>(dBodyGetNumJoints(rig.a())),
                             rig.b() == nullptr ? -1.0 : static_cast<double>(dBodyGetNumJoints(rig.b()))});
}

PARITY_CASE(joint_common)
{
    for (const JointKind& kind : every_joint()) {
        for (const Attach attach : attachments_of(kind)) {
            out.open_block(std::string(kind.name) + "/" + attach_name(attach));
            const Rig rig(rng, attach);
            int mark = 0;
            const dJointID joint = kind.create(rig.world(), nullptr);
            out.put("fresh.type", {static_cast<double>(dJointGetType(joint))});
            out.put("fresh.flags", {flag(dJointGetData(joint) == nullptr), flag(dJointIsEnabled(joint) != 0),
                                    flag(dJointGetFeedback(joint) == nullptr)});
            put_links(out, "fresh", rig, joint);
            rig.attach(joint);
            put_links(out, "attached", rig, joint);
            dJointFeedback feedback = {};
            dJointSetData(joint, &mark);
            dJointSetFeedback(joint, &feedback);
            dJointDisable(joint);
            out.put("set.flags", {flag(dJointGetData(joint) == &mark), flag(dJointIsEnabled(joint) != 0),
                                  flag(dJointGetFeedback(joint) == &feedback)});
            out.put("set.connected",
                    {static_cast<double>(dAreConnected(rig.a(), rig.b())),
                     static_cast<double>(dAreConnectedExcluding(rig.a(), rig.b(), dJointGetType(joint))),
                     static_cast<double>(dAreConnectedExcluding(rig.a(), rig.b(), dJointTypeNone))});
            dJointEnable(joint);
            out.put("enabled.flags", {flag(dJointIsEnabled(joint) != 0)});
            dJointAttach(joint, nullptr, nullptr);
            put_links(out, "detached", rig, joint);
            dJointDestroy(joint);
        }
    }
}

// Feedback is written by a step or not at all: a disabled joint, one without rows, the side of the world and
// a joint whose bodies sleep keep what the caller had there.
PARITY_CASE(joint_feedback_untouched)
{
    for (const JointKind& kind : every_joint()) {
        for (const Attach attach : attachments_of(kind)) {
            for (int state = 0; state < 4; ++state) {
                out.open_block(std::string(kind.name) + "/" + attach_name(attach) + "/s" +
                               std::to_string(state));
                const Rig rig(rng, attach);
                const dJointID joint = kind.create(rig.world(), nullptr);
                rig.attach(joint);
                place_at_random(kind, joint, rng);
                dJointFeedback f;
                for (dReal* v : {f.f1, f.t1, f.f2, f.t2}) { v[0] = v[1] = v[2] = 7; }
                dJointSetFeedback(joint, &f);
                if (state == 1) { dJointDisable(joint); }
                if (state == 2) {
                    dBodyDisable(rig.a());
                    if (rig.b() != nullptr) { dBodyDisable(rig.b()); }
                }
                if (state == 3) { dJointSetFeedback(joint, nullptr); }
                dWorldSetGravity(rig.world(), 0, 0, 0);
                dWorldStep(rig.world(), 0.01);
                const auto untouched = [](const dReal* v) {
                    return flag(v[0] == 7 && v[1] == 7 && v[2] == 7);
                };
                out.put("untouched", {untouched(f.f1), untouched(f.t1), untouched(f.f2), untouched(f.t2)});
            }
        }
    }
}

// Geometry is set after attaching. Set before, it is lost or kept as the type has it; both libraries agree
// on which. (The motors and the slider of the original read through a body that is not there.)
bool bears_no_body(const JointKind& kind)
{
    const std::string name = kind.name;
    return name != "slider" && !name.starts_with("amotor") && name != "lmotor" && name != "pr" &&
           name != "pu" && name != "piston" && name != "dhinge" && name != "hinge2" && name != "fixed" &&
           name != "plane2d" && name != "transmission" && name != "universal" && name != "hinge";
}

PARITY_CASE(joint_placed_before)
{
    for (const JointKind& kind : every_joint()) {
        if (!bears_no_body(kind)) { continue; }
        for (const Attach attach : attachments_of(kind)) {
            out.open_block(std::string(kind.name) + "/" + attach_name(attach));
            const Rig rig(rng, attach);
            const dJointID joint = kind.create(rig.world(), nullptr);
            kind.read(out, "fresh", joint);
            place_at_random(kind, joint, rng);
            kind.read(out, "placed", joint);
            rig.attach(joint);
            kind.read(out, "attached", joint);
        }
    }
}

void attach_some_way(const JointKind& kind, const Rig& rig, dJointID joint, int way)
{
    const dBodyID a = rig.a(), b = rig.b();
    const dBodyID first[] = {a, b, a, nullptr, b, nullptr}, second[] = {b, a, nullptr, a, nullptr, b};
    const int choice = kind.two_bodies ? way % 2 : way;
    dJointAttach(joint, first[choice], second[choice]);
}

// Every way of attaching after every other, with and without setting the geometry, then one step.
PARITY_CASE(joint_attached_again)
{
    for (const JointKind& kind : every_joint()) {
        const int ways = kind.two_bodies ? 2 : 6;
        for (int from = 0; from < ways; ++from) {
            for (int to = 0; to < ways; ++to) {
                out.open_block(std::string(kind.name) + "/" + std::to_string(from) + std::to_string(to));
                Rig rig(rng, Attach::kAB);
                const dJointID joint = kind.create(rig.world(), nullptr);
                attach_some_way(kind, rig, joint, from);
                kind.read(out, "fresh", joint);
                place_at_random(kind, joint, rng);
                kind.read(out, "placed", joint);
                set_random_pose(rig.a(), rng, 1.0);
                set_random_pose(rig.b(), rng, 1.0);
                attach_some_way(kind, rig, joint, to);
                kind.read(out, "again", joint);
                put_links(out, "again", rig, joint);
            }
        }
    }
}

// A group ends its joints, one by one destruction does not; a world that ends leaves them in the group.
PARITY_CASE(joint_groups)
{
    for (const JointKind& kind : every_joint()) {
        out.open_block(kind.name);
        const dJointGroupID group = dJointGroupCreate(0);
        {
            const Rig rig(rng, Attach::kAB);
            const dJointID grouped = kind.create(rig.world(), group),
                           single = kind.create(rig.world(), nullptr);
            rig.attach(grouped);
            rig.attach(single);
            put_links(out, "both", rig, grouped);
            dJointDestroy(grouped);
            put_links(out, "destroyed", rig, grouped);
            dJointGroupEmpty(group);
            put_links(out, "emptied", rig, single);
            dJointGroupEmpty(group);
            for (int i = 0; i < 5; ++i) { rig.attach(kind.create(rig.world(), group)); }
            put_links(out, "refilled", rig, single);
            dJointDestroy(single);
            put_links(out, "single", rig, dBodyGetJoint(rig.a(), 0));
            dJointFeedback feedback = {};
            dJointSetFeedback(dBodyGetJoint(rig.a(), 0), &feedback);
            dBodyDestroy(rig.b());
            out.put("body.links", {static_cast<double>(dBodyGetNumJoints(rig.a()))});
        }
        dJointGroupEmpty(group);
        dJointGroupDestroy(group);
    }
}

// Queries on pairs of bodies with joints of several types between them, disabled ones among them.
PARITY_CASE(joint_connections)
{
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const Rig rig(rng, Attach::kAB);
        const dBodyID bodies[] = {rig.a(), rig.b(), nullptr};
        std::vector<dJointID> joints;
        for (int i = 0; i < 12; ++i) {
            const JointKind& kind = every_joint()[static_cast<std::size_t>(rng.below(17))];
            const dJointID joint = kind.create(rig.world(), nullptr);
            const int way = rng.below(4);
            attach_some_way(kind, rig, joint, way);
            if (rng.unit() < 0.2) { dJointDisable(joint); }
            joints.push_back(joint);
        }
        const auto index = [&](dJointID joint) {
            for (std::size_t i = 0; i < joints.size(); ++i) {
                if (joints[i] == joint) { return static_cast<double>(i); }
            }
            return -1.0;
        };
        for (int i = 0; i < 2; ++i) {
            for (int k = 0; k < dBodyGetNumJoints(bodies[i]); ++k) {
                out.put("joint" + std::to_string(i) + "." + std::to_string(k),
                        {index(dBodyGetJoint(bodies[i], k))});
            }
            out.put("beyond" + std::to_string(i),
                    {flag(dBodyGetJoint(bodies[i], dBodyGetNumJoints(bodies[i])) == nullptr),
                     flag(dBodyGetJoint(bodies[i], -1) == nullptr)});
            for (int k = 0; k < 3; ++k) {
                if (i == k) { continue; }
                const std::string key = std::to_string(i) + std::to_string(k);
                dJointID found[12] = {};
                const int count = dConnectingJointList(bodies[i], bodies[k], found);
                out.put("first" + key, {index(dConnectingJoint(bodies[i], bodies[k])),
                                        index(dConnectingJoint(bodies[k], bodies[i]))});
                for (int n = 0; n < count; ++n) { out.put("list" + key, {index(found[n])}); }
                for (int type = dJointTypeNone; type <= dJointTypeTransmission; ++type) {
                    out.put("excluding" + key,
                            {static_cast<double>(dAreConnectedExcluding(bodies[i], bodies[k], type))});
                }
                out.put("connected" + key, {static_cast<double>(dAreConnected(bodies[i], bodies[k]))});
            }
        }
    }
}

}  // namespace
}  // namespace parity
