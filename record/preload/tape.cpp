// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See tape.h.
#include "record/preload/tape.h"

namespace epode::record {

namespace {

template <class Id>
std::int32_t number_of(const std::map<Id, std::int32_t>& numbers, Id id)
{
    const auto found = numbers.find(id);
    return found == numbers.end() ? -1 : found->second;
}

}  // namespace

Argument WorldTape::group(dJointGroupID group)
{
    if (!group) return Argument::of(ArgumentKind::kGroup, -1);
    const auto [known, is_new] = groups_.try_emplace(group, std::int32_t(groups_.size()));
    return Argument::of(ArgumentKind::kGroup, known->second);
}

Argument WorldTape::argument(const Given& given)
{
    switch (given.kind) {
        case Given::kBody:
            return Argument::of(ArgumentKind::kBody,
                                number_of(bodies_, static_cast<dBodyID>(const_cast<void*>(given.handle))));
        case Given::kJoint:
            return Argument::of(ArgumentKind::kJoint,
                                number_of(joints_, static_cast<dJointID>(const_cast<void*>(given.handle))));
        case Given::kNumber:
            return Argument::of(given.number);
        case Given::kInteger:
            return Argument::of(given.integer);
        case Given::kNumbers: {
            std::vector<double> numbers;
            for (int i = 0; given.numbers && i < given.count; ++i)
                numbers.push_back(double(given.numbers[i]));
            return Argument::of(std::move(numbers));
        }
        case Given::kMass:
            return Argument::of(given.mass ? numbers_of(*given.mass) : std::vector<double>());
        default:
            return Argument::world();
    }
}

void WorldTape::body_made(dBodyID body)
{
    bodies_[body] = body_count_++;
    tape_.add("dBodyCreate", {Argument::world()});
}

void WorldTape::joint_made(const char* name, dJointID joint, dJointGroupID in)
{
    joints_[joint] = joint_count_++;
    tape_.add(name, {Argument::world(), group(in)});
}

void WorldTape::contact_made(dJointID joint, dJointGroupID in, const dContact& contact)
{
    joints_[joint] = joint_count_++;
    tape_.add("dJointCreateContact", {Argument::world(), group(in), Argument::of(numbers_of(contact))});
}

void WorldTape::group_emptied(dJointGroupID group)
{
    const auto found = groups_.find(group);
    if (found != groups_.end())
        tape_.add("dJointGroupEmpty", {Argument::of(ArgumentKind::kGroup, found->second)});
}

void WorldTape::called(const char* name, const Given* given, int count)
{
    std::vector<Argument> arguments;
    for (int i = 0; i < count; ++i) arguments.push_back(argument(given[i]));
    tape_.add(name, arguments);
}

void WorldTape::stepped(const char* name, double dt, int substeps)
{
    std::vector<Argument> arguments{Argument::world(), Argument::of(dt)};
    if (substeps >= 0) arguments.push_back(Argument::of(substeps));
    tape_.add(name, arguments);
}

void WorldTape::stepped_many(double dt, int stepper, int iterations, int steps)
{
    tape_.add("dWorldsStep", {Argument::world(), Argument::of(dt), Argument::of(stepper),
                              Argument::of(iterations), Argument::of(steps)});
}

}  // namespace epode::record
