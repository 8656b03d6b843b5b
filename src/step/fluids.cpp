// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/fluids.h"

#include <algorithm>

#include "dynamics/forces/fluid.h"
#include "fluid/fluid_forces.h"
#include "fluid/water_level.h"

namespace epode {
namespace {

// Poses that are computed when first asked for would be so by several threads.
void refresh_volumes(const World& world)
{
    for (const Fluid* fluid : world.fluids)
        if (Geom* volume = from_handle<Geom>(fluid->volume)) (void)pose_of(*volume);
}

bool would_be_wet(const World& world, const Body& body)
{
    bool wet = false;
    for (const Fluid* fluid : world.fluids)
        for_each_geom_from(body.first_geom, [&](Geom& geom) {
            FloatingGeom floating;
            if (wet || !floating.take(geom)) return;
            const WaterPlane flat{fluid->normal, fluid->offset};
            wet = fluid->surface || floating.under(in_frame(flat, floating.pose())).volume > 0;
        });
    return wet;
}

}  // namespace

bool fluids_call_program(const World& world)
{
    return std::any_of(world.fluids.begin(), world.fluids.end(),
                       [](const Fluid* f) { return f->has_functions(); });
}

bool apply_fluids(World& world, Real h, const Tasks& tasks, StepUndo& undo, Arena& arena)
{
    const std::span<Body* const> bodies = undo.bodies();
    const auto wet = [](const Body* body) { return body->fluid.wet; };
    if (bodies.empty() || (world.fluids.empty() && std::none_of(bodies.begin(), bodies.end(), wet)))
        return true;
    const auto found = arena.take<BodyInFluid>(int(bodies.size()));
    if (arena.failed() || !undo.save_fluids(arena)) return false;
    refresh_volumes(world);
    const Tasks alone(1);
    (fluids_call_program(world) ? alone : tasks).in_ranges(int(bodies.size()), 64, [&](int begin, int end) {
        for (int i = begin; i < end; ++i)
            found[std::size_t(i)] = fluid_forces(world, *bodies[std::size_t(i)], h);
    });
    undo.mark_fluids();
    for (std::size_t i = 0; i < bodies.size(); ++i) {
        Body& body = *bodies[i];
        body.fluid = found[i];
        if (!found[i].wet) continue;
        store(body.facc, load(body.facc) + found[i].force);
        store(body.tacc, load(body.tacc) + found[i].torque);
    }
    return true;
}

void advance_fluids(World& world, Real h)
{
    for (Fluid* fluid : world.fluids)
        if (usable(fluid->time + h)) fluid->time += h;
}

void wake_in_fluids(World& world)
{
    for (Body& body : world.bodies)
        if (body.disabled && body.auto_disable && (body.fluid.wet || would_be_wet(world, body))) wake(body);
}

}  // namespace epode
