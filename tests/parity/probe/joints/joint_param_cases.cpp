// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every parameter number of every joint type, known or not, in all groups: what setting it changes.
//
// One number is set on a fresh joint, then all numbers of four groups are read. The record names those whose
// reading has changed and the value read, so that a parameter that is ignored, clamped, or lands in a
// neighbour shows as text. The plane-2D joint has setters only; what they do shows in a step (step_plane2d).
#include "every_joint.h"

#include <cstdio>

namespace parity {
namespace {

constexpr int kNumbers = 20;  // dParamsInGroup and a few beyond
constexpr int kGroups = 4;

std::vector<dReal> read_all(const JointKind& kind, dJointID joint, int groups)
{
    std::vector<dReal> values;
    for (int group = 0; group < groups; ++group) {
        for (int i = 0; i < kNumbers; ++i) { values.push_back(kind.get(joint, group * dParamGroup + i)); }
    }
    return values;
}

std::string changes(const std::vector<dReal>& before, const std::vector<dReal>& after)
{
    std::string text = "=";
    for (std::size_t i = 0; i < before.size(); ++i) {
        if (before[i] == after[i]) { continue; }
        char words[64];
        std::snprintf(words, sizeof words, "%d.%d:%.17g;", static_cast<int>(i) / kNumbers,
                      static_cast<int>(i) % kNumbers, after[i]);
        text += words;
    }
    return text;
}

// On a fourth group the original's angular motor ends the program, and its linear motor takes it for the
// third (differences.tsv, D42).
int groups_of(const JointKind& kind)
{
    return kind.set == &dJointSetAMotorParam || kind.set == &dJointSetLMotorParam ? 3 : kGroups;
}

void put_changes(Output& out, const JointKind& kind, const Rig& rig, Random& random, int number, double value)
{
    const dJointID joint = kind.create(rig.world(), nullptr);
    rig.attach(joint);
    kind.place(joint, random_place(random));
    const std::vector<dReal> before = read_all(kind, joint, groups_of(kind));
    kind.set(joint, number, value);
    char key[32];
    std::snprintf(key, sizeof key, "%d.%d", number / dParamGroup, number % dParamGroup);
    out.put_text(key, changes(before, read_all(kind, joint, groups_of(kind))));
    dJointDestroy(joint);
}

PARITY_CASE(joint_parameters)
{
    static const double values[] = {0.37, -0.42, 0.0, 2.5, 1.0, -4.0};
    for (const JointKind& kind : every_joint()) {
        if (kind.set == nullptr) { continue; }
        const Rig rig(rng, Attach::kAB);
        for (const double value : values) {
            char name[64];
            std::snprintf(name, sizeof name, "%s/%g", kind.name, value);
            out.open_block(name);
            for (int group = 0; group < groups_of(kind); ++group) {
                for (int i = 0; i < kNumbers; ++i) {
                    put_changes(out, kind, rig, rng, group * dParamGroup + i, value);
                }
            }
        }
    }
}

// What a fresh joint reads, in worlds of different ERP and CFM: both are taken over at creation.
PARITY_CASE(joint_parameter_defaults)
{
    for (const JointKind& kind : every_joint()) {
        if (kind.get == nullptr) { continue; }
        for (int trial = 0; trial < 3; ++trial) {
            out.open_block(std::string(kind.name) + "/t" + std::to_string(trial));
            const Rig rig(rng, Attach::kAB);
            const dJointID joint = kind.create(rig.world(), nullptr);
            dWorldSetERP(rig.world(), 0.77);
            dWorldSetCFM(rig.world(), 0.55);
            const std::vector<dReal> values = read_all(kind, joint, groups_of(kind));
            out.put("values", values.data(), static_cast<int>(values.size()));
        }
    }
}

// The last of a sequence of settings holds, whatever came between.
PARITY_CASE(joint_parameter_sequences)
{
    for (const JointKind& kind : every_joint()) {
        if (kind.set == nullptr) { continue; }
        for (int trial = 0; trial < 5; ++trial) {
            out.open_block(std::string(kind.name) + "/t" + std::to_string(trial));
            const Rig rig(rng, Attach::kAB);
            const dJointID joint = kind.create(rig.world(), nullptr);
            rig.attach(joint);
            for (int i = 0; i < 200; ++i) {
                kind.set(joint, rng.below(groups_of(kind)) * dParamGroup + rng.below(kNumbers),
                         rng.range(-2, 2));
            }
            const std::vector<dReal> values = read_all(kind, joint, groups_of(kind));
            out.put("values", values.data(), static_cast<int>(values.size()));
        }
    }
}

}  // namespace
}  // namespace parity
