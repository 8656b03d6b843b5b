// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The table of types by number.
#include "collide/registry.h"

#include "collide/user_class.h"

namespace epode {

const GeomType* geom_type(int number)
{
    switch (number) {
#define GEOM_TYPE(Name, Number, Object, Refusal) \
    case Number:                                 \
        return &k##Name##Type;
#include "collide/geom_types.inc"
#undef GEOM_TYPE
        default:
            return user_type(number);
    }
}

namespace {

bool locked_inside(const Space& space)
{
    if (space.locks > 0) return true;
    if (!space.cleanup) return false;
    for (const Geom* m : space.members)
        if (m && is_space(*m) && locked_inside(static_cast<const Space&>(*m))) return true;
    return false;
}

}  // namespace

bool may_destroy(const Geom& geom)
{
    return !in_locked_space(geom) && !(is_space(geom) && locked_inside(static_cast<const Space&>(geom)));
}

}  // namespace epode
