// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dJointSetHingeAxisOffset over a grid of turns, offsets and attachments: what the angle reads at once, after
// other setters, after a further turn and after an attachment, and what stops and motor make of the moved
// zero.
#include "rig.h"

namespace parity {
namespace {

struct Offset {
    double turned, given;
    Attach attach;
    bool leaning;  // bodies that share a pose which is not that of the world
};

std::string name_of(const Offset& o)
{
    const auto text = [](double x) { return std::to_string(static_cast<int>(1000 * x)); };
    return std::string(attach_name(o.attach)) + (o.leaning ? "-leaning/" : "/") + text(o.turned) + "/" +
           text(o.given);
}

template <typename Use>
void each_offset(const Use& use)
{
    for (const Attach attach : all_attachments())
        for (const bool leaning : {false, true})
            for (const double turned : {0.0, 0.5, 1.5708, -0.7, 2.5, -3.0})
                for (const double given : {0.0, 0.23, -1.5708, 0.9, 2.9, 4.0})
                    use(Offset{turned, given, attach, leaning});
}

// A hinge about z, the first body turned about it since.
dJointID make(const Rig& rig, const Offset& o)
{
    const dQuaternion upright = {1, 0, 0, 0}, leaning = {0.5, 0.5, -0.5, 0.5};
    for (const dBodyID body : {rig.a(), rig.b()})
        if (body != nullptr) { dBodySetQuaternion(body, o.leaning ? leaning : upright); }
    const dJointID joint = dJointCreateHinge(rig.world(), nullptr);
    rig.attach(joint);
    dJointSetHingeAnchor(joint, 0.1, 0.2, 0.3);
    dJointSetHingeAxis(joint, 0, 0, 1);
    turn(rig.a(), {0, 0, 1}, o.turned);
    dJointSetHingeAxisOffset(joint, 0, 0, 1, o.given);
    return joint;
}

PARITY_CASE(joint_hinge_offset)
{
    each_offset([&](const Offset& o) {
        out.open_block(name_of(o));
        const Rig rig(rng, o.attach);
        const dJointID joint = make(rig, o);
        const auto put = [&](const char* when) {
            out.put(std::string(when) + ".angles", {dJointGetHingeAngle(joint)});
        };
        put("set");
        turn(rig.a(), {0, 0, 1}, 0.4);
        put("turned");
        dJointSetHingeAxisOffset(joint, 0, 0, 2, o.given);
        put("again");
        turn(rig.a(), {0.6, 0, 0.8}, -0.3);
        put("off-axis");
        dJointSetHingeAxisOffset(joint, 0.1, -0.2, 0.9, o.given);
        put("other-axis");
        dJointSetHingeAnchor(joint, 0.3, 0.1, 0);
        put("anchor");
        dJointSetHingeAxisOffset(joint, 0, 0, 1, o.given);
        dJointSetHingeAxis(joint, 0, 0, 1);
        put("axis");
        dJointSetHingeAxisOffset(joint, 0, 0, 1, o.given);
        rig.attach(joint);
        put("attached");
    });
}

// Stops and motor count from the zero that the offset has left.
PARITY_CASE(step_hinge_offset)
{
    each_offset([&](const Offset& o) {
        Rig rig(rng, o.attach);
        for (const double stop : {-0.6, 0.3, 1.1}) {
            out.open_block(name_of(o) + "/" + std::to_string(static_cast<int>(1000 * stop)));
            const dJointID joint = make(rig, o);
            dJointSetHingeParam(joint, dParamLoStop, stop - 0.4);
            dJointSetHingeParam(joint, dParamHiStop, stop);
            dJointSetHingeParam(joint, dParamVel, 0.7);
            dJointSetHingeParam(joint, dParamFMax, 2);
            rig.push(rng, 0.5);
            dWorldStep(rig.world(), rig.step_size());
            rig.put_bodies(out, "after");
            out.put("after.angle", {dJointGetHingeAngle(joint)});
            dJointDestroy(joint);
        }
    });
}

}  // namespace
}  // namespace parity
