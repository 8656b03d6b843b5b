// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which geoms a query finds, as dQueryFilter (ode/queries.h) defines. Bits and the body to skip are tested
// before a geom's shape. The program's callback runs last, for geoms that were hit, so that it is called
// seldom. With a callback, all candidates are tested in order of insertion, not in tree order: the calls that
// the program receives depend only on its own calls.
#pragma once

#include "collide/geom.h"
#include "ode/queries.h"

namespace epode {

struct QueryFilter {
    unsigned long category = ~0ul, collide = ~0ul;
    dBodyID skip_body = nullptr;
    dQueryCallback* callback = nullptr;
    void* data = nullptr;
    bool skips_overlaps = false;  // casts of shapes alone

    bool admits(const Geom& geom) const
    {
        const bool agree = (category & geom.collide) != 0 || (geom.category & collide) != 0;
        return agree && !(skip_body && geom.body.id == skip_body);
    }

    // `named`: the geom that the result would name. Calls the program's callback.
    bool keeps(dGeomID named) const;
};

// Reads the program's filter into `filter`, which keeps its values for null. False: refused, with an error in
// the name of the C function `caller`.
[[nodiscard]] bool read_filter(const dQueryFilter* given, const char* caller, QueryFilter& filter);

}  // namespace epode
