// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// After every operation the library's own books must agree (src/step/validate.h): what a program can see may
// still be right when a list inside is broken already.
#include "player.h"
#include "step/validate.h"

namespace epode::sequences {

void Player::check_invariants()
{
    for (const World* world : model.worlds.living())
        if (const char* found = fault_of(*from_handle<epode::World>(world->id)))
            return fail("w[%d]: %s", world->number, found);
    for (const Geom* geom : model.geoms.living())
        if (const Space* space = geom->is_space ? space_from(reinterpret_cast<dSpaceID>(geom->id)) : nullptr)
            if (const char* found = fault_of(*space)) return fail("g[%d]: %s", geom->number, found);
}

}  // namespace epode::sequences
