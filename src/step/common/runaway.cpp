// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/common/runaway.h"

#include "base/messages.h"
#include "dynamics/world.h"

namespace epode {

void Runaways::add(const Body& body)
{
    std::uint64_t known = oldest_.load(std::memory_order_relaxed);
    while (body.serial < known &&
           !oldest_.compare_exchange_weak(known, body.serial, std::memory_order_relaxed)) {}
}

void Runaways::send(const World& world)
{
    const std::uint64_t serial = oldest_.load(std::memory_order_relaxed);
    const Body* its = nullptr;
    int older = 0;
    for (const Body& body : world.bodies) {
        if (body.serial == serial) its = &body;
        older += body.serial < serial;
    }
    if (!its) return;
    reported_ = true;
    note(0,
         "step %llu: body %d (of %d, in order of creation) moves at %.3g m/s and %.3g rad/s%s; no simulation "
         "is "
         "meant beyond %.0e. Steps go on; dWorldDiagnose looks for causes",
         static_cast<unsigned long long>(world.step_count), older, world.bodies.count(),
         double(length(its->velocity())), double(length(its->angular_velocity())),
         runs_away(*its) ? "" : ", after numbers of its island were no longer finite", double(kRunawaySpeed));
}

}  // namespace epode
