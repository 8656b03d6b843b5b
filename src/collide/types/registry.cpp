// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The table of types by number.
#include "collide/types/registry.h"

#include "collide/user_class.h"
#include "geometry/inertia.h"
#include "ode/mass.h"

namespace epode {

const GeomType* geom_type(int number)
{
    switch (number) {
#define GEOM_TYPE(Name, Number, Object, Refusal) \
    case Number:                                 \
        return &k##Name##Type;
#include "collide/types/geom_types.inc"
#undef GEOM_TYPE
        default:
            return user_type(number);
    }
}

namespace {

// The geom or one that would die with it is relied on.
bool in_use(const Geom& geom)
{
    if (is_dying(geom) || is_held(geom)) return true;
    if (const TransformGeom* transform = as_transform(const_cast<Geom&>(geom)))
        return transform->inner && transform->cleanup && in_use(*transform->inner);
    if (!is_space(geom)) return false;
    const Space& space = static_cast<const Space&>(geom);
    if (is_locked(space)) return true;
    if (!space.cleanup) return false;
    for (const Geom* m : space.geoms)
        if (m && in_use(*m)) return true;
    return false;
}

}  // namespace

void put_mass(dMass* m, const MassProperties& p)
{
    m->mass = p.mass;
    store(m->c, p.center);
    m->c[3] = 0;
    store_mat(m->I, full(p.inertia));
    (void)dMassCheck(m);
}

bool may_destroy(const Geom& geom) { return !in_locked_space(geom) && !in_use(geom); }

}  // namespace epode
