// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which geoms a query finds: dQueryFilter (ode/queries.h) in whole. Bits and the body to skip are looked at
// before a geom's shape; the program's callback is asked last, for what has been met, so that it is called
// seldom. Who has a callback asks all candidates in order of joining, not in that of a tree, so that what the
// program hears depends on its calls alone.
#pragma once

#include "collide/geom.h"
#include "ode/queries.h"

namespace epode {

struct QueryFilter {
    unsigned long category = ~0ul, collide = ~0ul;
    dBodyID skip_body = nullptr;
    dQueryCallback* callback = nullptr;
    void* data = nullptr;

    bool admits(const Geom& geom) const
    {
        const bool agree = (category & geom.collide) != 0 || (geom.category & collide) != 0;
        return agree && !(skip_body && geom.body.id == skip_body);
    }

    // `named`: what the result would name. Calls the program.
    bool keeps(dGeomID named) const;
};

// What the program has given into `filter`, which stays as it is for null. False: refused, in the name of the
// C function `caller`.
[[nodiscard]] bool read_filter(const dQueryFilter* given, const char* caller, QueryFilter& filter);

}  // namespace epode
