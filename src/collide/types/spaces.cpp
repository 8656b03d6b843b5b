// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The four classes of spaces and the functions of a single class. What is special to a class of the original
// is advice on its own data structure; it is checked and kept, and the broadphase needs none of it.
#include "collide/types/registry.h"

namespace epode {
namespace {

void structure(Geom& geom, ShapeStream& stream)
{
    Space& space = static_cast<Space&>(geom);
    stream.flag(space.cleanup);
    stream.number(space.sublevel), stream.number(space.min_level), stream.number(space.max_level);
}

constexpr GeomType space_type(int number)
{
    return {.number = number,
            .placeable = false,
            .aabb = space_aabb,
            .destroy = destroy_pooled<Space>,
            .create = create_pooled<Space>,
            .structure = structure};
}

constexpr const char* kTooDeep = "spaces are nested too deeply";

template <typename Name>
dSpaceID create_space(dSpaceID parent, const char* caller = __builtin_FUNCTION())
{
    return id_of(create_geom<Name>(parent, caller));
}

// A new space inside the parent would not be nested too deeply.
bool fits_in(dSpaceID parent)
{
    int above = 0;
    for (const Geom* g = space_from(parent); g; g = g->space) ++above;
    return above < kMostNested;
}

// Three different axes, two bits each.
bool legal_axes(int order)
{
    const int a = order & 3, b = (order >> 2) & 3, c = (order >> 4) & 3;
    return order >> 6 == 0 && a < 3 && b < 3 && c < 3 && a != b && b != c && a != c;
}

}  // namespace

const GeomType kSimpleSpaceType = space_type(dSimpleSpaceClass);
const GeomType kHashSpaceType = space_type(dHashSpaceClass);
const GeomType kSweepAndPruneSpaceType = space_type(dSweepAndPruneSpaceClass);
const GeomType kQuadTreeSpaceType = space_type(dQuadTreeSpaceClass);

}  // namespace epode

using namespace epode;

extern "C" dSpaceID dSimpleSpaceCreate(dSpaceID space)
{
    EPODE_PARENT_SPACE(space, nullptr);
    EPODE_USER_SAY(fits_in(space), kTooDeep, nullptr);
    return create_space<SimpleSpace>(space);
}

extern "C" dSpaceID dHashSpaceCreate(dSpaceID space)
{
    EPODE_PARENT_SPACE(space, nullptr);
    EPODE_USER_SAY(fits_in(space), kTooDeep, nullptr);
    return create_space<HashSpace>(space);
}

extern "C" dSpaceID dSweepAndPruneSpaceCreate(dSpaceID space, int axisorder)
{
    EPODE_USER(legal_axes(axisorder), nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    EPODE_USER_SAY(fits_in(space), kTooDeep, nullptr);
    return create_space<SweepAndPruneSpace>(space);
}

extern "C" dSpaceID dQuadTreeSpaceCreate(dSpaceID space, const dVector3 Center, const dVector3 Extents,
                                         int Depth)
{
    EPODE_USER(Center && Extents && usable(Center, 3) && usable(Extents, 3) && Depth >= 0, nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    EPODE_USER_SAY(fits_in(space), kTooDeep, nullptr);
    return create_space<QuadTreeSpace>(space);
}

extern "C" void dHashSpaceSetLevels(dSpaceID space, int minlevel, int maxlevel)
{
    EPODE_GEOM_AS(HashSpace, hash, reinterpret_cast<dGeomID>(space));
    EPODE_USER_SAY(minlevel <= maxlevel, "must have minlevel <= maxlevel");
    hash->min_level = minlevel;
    hash->max_level = maxlevel;
}

extern "C" void dHashSpaceGetLevels(dSpaceID space, int* minlevel, int* maxlevel)
{
    EPODE_GEOM_AS(HashSpace, hash, reinterpret_cast<dGeomID>(space));
    if (minlevel) *minlevel = hash->min_level;
    if (maxlevel) *maxlevel = hash->max_level;
}
