// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The list of geom classes as types, and what the C functions of a class stand on: checked access and
// creation. A list and not self-registration: no order of static initialisation, and no linker may drop a
// class.
#pragma once

#include "base/check.h"
#include "base/objects/pool.h"
#include "collide/geom.h"
#include "collide/shape_stream.h"
#include "collide/shared_solid.h"
#include "collide/space.h"
#include "collide/surfaces/heightfield.h"
#include "collide/surfaces/trimesh.h"
#include "collide/transform.h"
#include "ode/shapes.h"

namespace epode {

struct MassProperties;  // geometry/inertia.h

struct ConvexGeom : ShapeGeom<Convex> {
    using ShapeGeom<Convex>::ShapeGeom;
    void take(SharedSolid& made)
    {
        solid = static_cast<SharedSolid&&>(made);
        shape.solid = solid.get();
    }
    SharedSolid solid;
};

template <typename Name>
struct GeomTraits;

#define GEOM_TYPE(Name, Number, Object, Refusal) struct Name;
#include "collide/types/geom_types.inc"
#undef GEOM_TYPE

#define GEOM_TYPE(Name, Number, Object, Refusal)               \
    extern const GeomType k##Name##Type;                       \
    template <>                                                \
    struct GeomTraits<Name> {                                  \
        using Type = Object;                                   \
        static constexpr int kNumber = Number;                 \
        static constexpr const char* kRefusal = Refusal;       \
        static const GeomType& get() { return k##Name##Type; } \
    };
#include "collide/types/geom_types.inc"
#undef GEOM_TYPE

// Above every class's number, of the program's classes too.
inline constexpr int kGeomClasses = [] {
    int count = dGeomNumClasses;
#define GEOM_TYPE(Name, Number, Object, Refusal) count = Number < count ? count : Number + 1;
#include "collide/types/geom_types.inc"
#undef GEOM_TYPE
    return count;
}();

// The type with this number, or null; user classes included.
const GeomType* geom_type(int number);

// Null unless the handle names a live geom of this class.
template <typename Name>
typename GeomTraits<Name>::Type* geom_as(dGeomID id)
{
    Geom* geom = from_handle<Geom>(id);
    const bool fits = !kChecked || (geom && geom->type->number == GeomTraits<Name>::kNumber);
    return fits ? static_cast<typename GeomTraits<Name>::Type*>(geom) : nullptr;
}

template <typename Object>
void destroy_pooled(Geom* geom)
{
    Pool<Object>::destroy(static_cast<Object*>(geom));
}

template <typename Object>
Geom* create_pooled(const GeomType& type)
{
    return Pool<Object>::create(type);
}

// A new geom in `space` (or none); null, after a refusal on behalf of the C function `caller`, when memory is
// exhausted. `space` has been checked.
template <typename Name>
typename GeomTraits<Name>::Type* create_geom(dSpaceID space, const char* caller = __builtin_FUNCTION())
{
    using Object = typename GeomTraits<Name>::Type;
    Object* geom = Pool<Object>::create(GeomTraits<Name>::get());
    if (geom && (!space || add_geom(*space_from(space), *geom))) return geom;
    if (geom) destroy_geom(*geom);
    refuse_for(caller, kOutOfMemory);
    return nullptr;
}

template <typename Shape>
dGeomID create_shape(dSpaceID space, const Shape& shape, const char* caller = __builtin_FUNCTION())
{
    auto* geom = create_geom<Shape>(space, caller);
    if (geom) geom->shape = shape;
    return to_handle<Geom>(geom);
}

// Usable numbers into a dMass; of those that belong to no rigid body dMassCheck's message speaks.
void put_mass(dMass* m, const MassProperties& p);

// The geom and all that would die with it may be touched now.
bool may_destroy(const Geom& geom);

}  // namespace epode

// ---- argument checks of C functions; what follows them is the value returned when refused ----

#define EPODE_LOCKED_TEXT "Invalid operation for locked space"

// `geom`: the live geom behind the handle, of any class or of one.
#define EPODE_GEOM(geom, id, ...)                                  \
    ::epode::Geom* geom = ::epode::from_handle<::epode::Geom>(id); \
    EPODE_USER(geom __VA_OPT__(, ) __VA_ARGS__)
#define EPODE_GEOM_AS(Name, geom, id, ...)   \
    auto* geom = ::epode::geom_as<Name>(id); \
    EPODE_USER_SAY(geom, ::epode::GeomTraits<Name>::kRefusal __VA_OPT__(, ) __VA_ARGS__)
#define EPODE_SPACE(space, id, ...)                  \
    ::epode::Space* space = ::epode::space_from(id); \
    EPODE_USER_SAY(space, "argument not a space" __VA_OPT__(, ) __VA_ARGS__)
#define EPODE_PLACEABLE(geom, ...) \
    EPODE_USER_SAY((geom)->type->placeable, "geom must be placeable" __VA_OPT__(, ) __VA_ARGS__)
#define EPODE_UNLOCKED(geom, ...) \
    EPODE_USER_SAY(!::epode::in_locked_space(*(geom)), EPODE_LOCKED_TEXT __VA_OPT__(, ) __VA_ARGS__)

// The space argument of a create function: null, or a space that takes members now.
#define EPODE_PARENT_SPACE(id, result)                                                \
    EPODE_USER_SAY(!(id) || ::epode::space_from(id), "argument not a space", result); \
    EPODE_USER_SAY(!(id) || accepts_geoms(*::epode::space_from(id)), EPODE_LOCKED_TEXT, result)
