// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldQuickStep run to its end. Its iterates are its own (ours starts warm and draws nothing from dRand),
// its limit is the solution of the same equations: with 4,000 iterations from rest both libraries arrive
// there, and bodies and feedback are compared to 1e-9. Of contacts, friction limits follow the present normal
// force, so the limit differs from that of dWorldStep and is compared as well. One iteration of one row is
// the exact answer, and zero iterations are none.
#include "joints/every_joint.h"

namespace parity {
namespace {

void put_feedback(Output& out, const std::string& key, const dJointFeedback& f)
{
    out.put(key + ".f1", f.f1, 3);
    out.put(key + ".t1", f.t1, 3);
    out.put(key + ".f2", f.f2, 3);
    out.put(key + ".t2", f.t2, 3);
}

// PR, PU and piston are left as they were placed: off their lines the original's forces are its own
// (differences.tsv, D10, D11, D34, D35). So is the transmission (D36).
bool may_be_disturbed(const JointKind& kind)
{
    const std::string name = kind.name;
    return name != "pr" && name != "pu" && name != "piston" && name != "transmission";
}

bool may_be_reversed(const JointKind& kind)
{
    const std::string name = kind.name;
    return name != "pr" && name != "pu" && name != "piston";
}

struct Trial {
    Trial(const JointKind& kind, Attach attach, Random& random)
        : rig(random, attach), joint(kind.create(rig.world(), nullptr))
    {
        rig.attach(joint);
        place_at_random(kind, joint, random);
        if (may_be_disturbed(kind)) { rig.disturb(random, 0.02, 0.1); }
        rig.push(random, 1.0);
        dWorldSetCFM(rig.world(), 1e-5);
        dJointSetFeedback(joint, &feedback);
    }
    Rig rig;
    dJointID joint;
    dJointFeedback feedback = {};
};

PARITY_CASE(quick_converged)
{
    for (const JointKind& kind : every_joint()) {
        for (const Attach attach : attachments_of(kind)) {
            if (attach == Attach::kOA && !may_be_reversed(kind)) { continue; }
            for (int pose = 0; pose < 5; ++pose) {
                out.open_block(std::string(kind.name) + "/" + attach_name(attach) + "/p" +
                               std::to_string(pose));
                Trial trial(kind, attach, rng);
                dWorldSetQuickStepNumIterations(trial.rig.world(), 4000);
                if (pose == 1) { dWorldSetQuickStepW(trial.rig.world(), 1.0); }
                dWorldQuickStep(trial.rig.world(), trial.rig.step_size());
                trial.rig.put_bodies(out, "after");
                put_feedback(out, "after", trial.feedback);
            }
        }
    }
}

// Limits and motors of one axis, in QuickStep.
PARITY_CASE(quick_limits)
{
    for (const JointKind& kind : every_joint()) {
        const std::string name = kind.name;
        if (name != "hinge" && name != "slider" && name != "universal") { continue; }
        for (const JointVariant& variant : limit_variants(kind.set, 0, "")) {
            for (const Attach attach : attachments_of(kind)) {
                out.open_block(name + "-" + variant.name + "/" + attach_name(attach));
                Trial trial(kind, attach, rng);
                variant.set(trial.joint, rng);
                dWorldSetQuickStepNumIterations(trial.rig.world(), 4000);
                dWorldQuickStep(trial.rig.world(), trial.rig.step_size());
                trial.rig.put_bodies(out, "after");
                put_feedback(out, "after", trial.feedback);
            }
        }
    }
}

// A single row is solved by its first visit, if W does not overshoot; without iterations nothing holds.
PARITY_CASE(quick_few_iterations)
{
    for (const JointKind& kind : every_joint()) {
        const std::string name = kind.name;
        for (const int iterations : {0, 1}) {
            if (iterations == 1 && name != "dball" && name != "transmission") { continue; }
            for (const Attach attach : attachments_of(kind)) {
                out.open_block(name + std::to_string(iterations) + "/" + attach_name(attach));
                Trial trial(kind, attach, rng);
                dWorldSetQuickStepNumIterations(trial.rig.world(), iterations);
                dWorldSetQuickStepW(trial.rig.world(), 1.0);
                dWorldQuickStep(trial.rig.world(), trial.rig.step_size());
                trial.rig.put_bodies(out, "after");
                put_feedback(out, "after", trial.feedback);
            }
        }
    }
}

}  // namespace
}  // namespace parity
