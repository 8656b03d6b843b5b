// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/forces/fluid.h"

#include "base/objects/pool.h"
#include "dynamics/world.h"

namespace epode {

Fluid* create_fluid(World& world)
{
    Fluid* const fluid = Pool<Fluid>::create(world);
    if (!fluid || world.fluids.push(fluid)) return fluid;
    Pool<Fluid>::destroy(fluid);
    return nullptr;
}

void destroy_fluid(Fluid& fluid)
{
    Array<Fluid*>& all = fluid.world->fluids;
    int kept = 0;
    for (Fluid* one : all)
        if (one != &fluid) all[kept++] = one;
    all.truncate(kept);
    Pool<Fluid>::destroy(&fluid);
}

}  // namespace epode
