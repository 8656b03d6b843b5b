// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/schedule.h"

#include "step/island/strain.h"
#include "step/steppers/stepper.h"

namespace epode {
namespace {

constexpr int kParcel = 128;  // least weight of a parcel but the last

int weight(const Island& island)
{
    return int(island.joints.size() + island.bodies.size() + island.manifolds.size());
}

const Stepper& stepper_of(const StepContext& context, std::size_t island)
{
    return context.methods.empty() ? context.stepper : *context.methods[island].stepper;
}

int iterations_of(const StepContext& context, std::size_t island)
{
    return context.methods.empty() ? context.iterations : context.methods[island].iterations;
}

Sharing sharing_of(const Stepper& stepper, const StepContext& context)
{
    return stepper.sharing ? stepper.sharing(context.manages_contacts) : Sharing::kFree;
}

bool is_large(const Stepper& stepper, const Island& island)
{
    return stepper.is_large && stepper.is_large(island);
}

// Has it nothing to solve? Substeps within an exact step know one island.
bool is_free(const World& world, const Island& island)
{
    return island.joints.empty() && island.manifolds.empty() && world.exact_substeps <= 1;
}

}  // namespace

bool Schedule::may_join(const StepContext& context, std::span<const Island> islands, std::size_t i) const
{
    const Island &before = islands[i - 1], &island = islands[i];
    const Stepper& stepper = stepper_of(context, i);
    if (&stepper != &stepper_of(context, i - 1) || island.settles() != before.settles()) return false;
    // All workers sweep over a large island together; each of the others has one worker.
    if (is_large(stepper, before) || is_large(stepper, island)) return false;
    const bool joints = !island.joints.empty(), alike = joints == !before.joints.empty();
    switch (sharing_of(stepper, context)) {
        case Sharing::kAll:
            return true;
        case Sharing::kAlike:
            return alike && substep_factor(before) == substep_factor(island);
        case Sharing::kWithoutJoints:
            return alike && !joints;
        case Sharing::kFree:
            break;
    }
    return is_free(context.world, before) && is_free(context.world, island);
}

bool Schedule::make(const StepContext& context, std::span<const Island> islands, Arena& arena)
{
    const int count = int(islands.size());
    groups_ = arena.take<IslandGroup>(count);
    large_ = arena.take<bool>(count);
    parcels_ = arena.take<int>(count + 1);
    if (arena.failed()) return false;
    std::size_t made = 0;
    for (std::size_t i = 0; i < islands.size(); ++i) {
        const int joints = int(islands[i].joints.size()), w = weight(islands[i]);
        const Stepper& stepper = stepper_of(context, i);
        const bool joins =
            made > 0 && may_join(context, islands, i) && groups_[made - 1].weight + w <= stepper.max_weight;
        if (!joins) {
            // What is grouped must not change the numbers of others.
            const bool shares = sharing_of(stepper, context) != Sharing::kFree;
            groups_[made] = {&stepper, iterations_of(context, i),   int(i), 0,
                             0,        shares ? int(made) : int(i), joints_};
            large_[made++] = is_large(stepper, islands[i]);
        }
        IslandGroup& group = groups_[made - 1];
        ++group.count, group.weight += w;
        joints_ += joints;
    }
    groups_ = groups_.first(made);
    return true;
}

int Schedule::cut_parcels(bool alone)
{
    int count = 0, load = kParcel;
    for (std::size_t i = 0; i < groups_.size(); ++i) {
        if (large_[i] && !alone) continue;
        if (load >= kParcel) parcels_[std::size_t(count++)] = int(i), load = 0;
        load += groups_[i].weight;
    }
    parcels_[std::size_t(count)] = int(groups_.size());
    return count;
}

}  // namespace epode
