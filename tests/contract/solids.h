// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A geom of each class of convex solids for contracts (solids.inc).
#pragma once

#include "collide/types/registry.h"
#include "ode/ext.h"

namespace epode::tests {

// Off its origin, and without symmetry.
inline dGeomID wedge()
{
    static const dReal points[] = {1, 0, 0, 2, 0, 0, 1, 3, 0, 2, 2, 0, 1, 0, Real(1.5), Real(1.8), 2, 1};
    return dCreateConvexHull(nullptr, points, 6, 0);
}

// Null: the class is new, and a line is missing in solids.inc.
inline dGeomID make_solid(int number)
{
    switch (number) {
#define SOLID(Number, made) \
    case Number:            \
        return made;
#include "solids.inc"
#undef SOLID
        default:
            return nullptr;
    }
}

}  // namespace epode::tests
