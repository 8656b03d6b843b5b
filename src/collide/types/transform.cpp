// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The geom transform. The geom inside remembers who holds it (a list, since several transforms may hold one
// geom), so that neither can outlive the other unnoticed, and so that a change of it moves the transforms.
#include "collide/transform.h"
#include "collide/describe.h"

#include <algorithm>

#include "collide/collide.h"
#include "collide/surfaces/height_function.h"
#include "collide/types/registry.h"

namespace epode {
namespace {

Aabb aabb(Geom& geom)
{
    TransformGeom& transform = static_cast<TransformGeom&>(geom);
    if (!transform.inner) return {};
    Geom& inner = *transform.inner;
    const PlacedElsewhere placed(inner, pose_of(transform) * pose_of(inner), may_call_program(inner));
    return inner.type->aabb(inner);
}

bool zero_sized(const Geom& geom)
{
    const Geom* inner = static_cast<const TransformGeom&>(geom).inner;
    return inner && inner->type->zero_sized && inner->type->zero_sized(*inner);
}

// What it held before goes last: its class's function may change anything, this transform included.
void hold(TransformGeom& transform, Geom* inner)
{
    Geom* const old = transform.inner;
    const bool cleanup = transform.cleanup;
    set_transform_geom(transform, inner);
    if (old && cleanup) destroy_geom(*old);
}

void destroy(Geom* geom)
{
    TransformGeom* transform = static_cast<TransformGeom*>(geom);
    while (transform->inner) hold(*transform, nullptr);
    Pool<TransformGeom>::destroy(transform);
}

// How many transforms stand in line below, the geom included; above, in the longest line, likewise.
int line_below(const Geom& geom)
{
    int count = 0;
    for (const Geom* g = &geom; g && g->type == &kTransformType;
         g = static_cast<const TransformGeom*>(g)->inner)
        ++count;
    return count;
}

int line_above(const TransformGeom& transform)
{
    int highest = 0;
    for (const TransformGeom* h = transform.holders; h; h = h->next_holder)
        highest = std::max(highest, line_above(*h));
    return highest + 1;
}

// Whether `transform` would come to hold itself.
bool holds(Geom& geom, const TransformGeom& transform)
{
    for (Geom* g = &geom; g;) {
        if (g == &transform) return true;
        TransformGeom* next = as_transform(*g);
        g = next ? next->inner : nullptr;
    }
    return false;
}

void describe_transform(const Geom& geom, DifWriter& out)
{
    const Geom* inner = static_cast<const TransformGeom&>(geom).inner;
    out.text("type", "transform");
    if (!inner) return;
    out.open("geom");
    describe(out, *inner);
    out.close();
}

void fingerprint(const Geom& geom, ContentHash& hash)
{
    if (Geom* inner = static_cast<const TransformGeom&>(geom).inner) hash.add(shape_hash(*inner));
}

void structure(Geom& geom, ShapeStream& stream)
{
    TransformGeom& transform = static_cast<TransformGeom&>(geom);
    Geom* inner = transform.inner;
    stream.geom(inner);
    stream.number(transform.cleanup), stream.number(transform.info);
    if (stream.saves() || !inner || stream.failed()) return;
    const bool fits = inner->type->placeable && !inner->space && !holds(*inner, transform) &&
                      line_below(*inner) + line_above(transform) <= kMostNested;
    if (stream.demand(fits, "a geom transform in it holds a geom that it cannot hold"))
        set_transform_geom(transform, inner);
}

// Whether `geom` goes when `transform` lets go what it holds.
bool dies_with(const Geom& geom, const TransformGeom& transform)
{
    const TransformGeom* t = &transform;
    while (t && t->inner && t->cleanup) {
        if (t->inner == &geom) return true;
        t = as_transform(*t->inner);
    }
    return false;
}

bool may_let_go(const TransformGeom& transform)
{
    if (is_held(transform)) return false;
    return !transform.inner || !transform.cleanup || may_destroy(*transform.inner);
}

}  // namespace

const GeomType kTransformType = {.number = dGeomTransformClass,
                                 .aabb = aabb,
                                 .zero_sized = zero_sized,
                                 .destroy = destroy,
                                 .describe = describe_transform,
                                 .fingerprint = fingerprint,
                                 .create = create_pooled<TransformGeom>,
                                 .structure = structure};

TransformGeom* as_transform(Geom& geom)
{
    return geom.type == &kTransformType ? static_cast<TransformGeom*>(&geom) : nullptr;
}

void set_transform_geom(TransformGeom& transform, Geom* inner)
{
    if (transform.inner) {
        TransformGeom** link = &transform.inner->holders;
        while (*link != &transform) link = &(*link)->next_holder;
        *link = transform.next_holder;
    }
    transform.inner = inner;
    transform.next_holder = nullptr;
    if (inner) {
        transform.next_holder = inner->holders;
        inner->holders = &transform;
    }
    mark_changed(transform);
}

PlacedElsewhere::PlacedElsewhere(Geom& geom, const Pose& pose, bool called)
    : geom_(geom),
      old_position_(geom.position),
      old_rotation_(geom.rotation),
      old_box_(geom.box),
      old_stale_(geom.box_stale),
      own_(called ? static_cast<Place*>(allocate(sizeof(Place))) : nullptr),
      guard_(own_ ? put_back : nullptr, &geom, own_)
{
    Place& place = own_ ? *own_ : here_;
    store(place.position, pose.p);
    place.position[3] = 0;
    store_mat(place.rotation, pose.R);
    geom.position = place.position;
    geom.rotation = place.rotation;
    geom.box_stale = true;
}

PlacedElsewhere::~PlacedElsewhere()
{
    if (own_ && !guard_.end()) return;
    geom_.position = old_position_;
    geom_.rotation = old_rotation_;
    geom_.box = old_box_;
    geom_.box_stale = old_stale_;
    release(own_, sizeof(Place));
}

// A function of the program has left what had placed it.
void PlacedElsewhere::put_back(void* id, const void* place, std::size_t)
{
    Geom& geom = *static_cast<Geom*>(id);
    const bool shared = geom.body.id && !geom.offset;
    geom.position = shared ? geom.body.position : geom.own_position;
    geom.rotation = shared ? geom.body.rotation : geom.own_rotation;
    geom.box_stale = true;
    release(const_cast<void*>(place), sizeof(Place));
}

}  // namespace epode

using namespace epode;

extern "C" dGeomID dCreateGeomTransform(dSpaceID space)
{
    EPODE_PARENT_SPACE(space, nullptr);
    return to_handle<Geom>(create_geom<Transform>(space));
}

extern "C" void dGeomTransformSetGeom(dGeomID transform, dGeomID obj)
{
    EPODE_GEOM_AS(Transform, holder, transform);
    Geom* inner = from_handle<Geom>(obj);
    EPODE_USER(!obj || inner);
    EPODE_OUTSIDE_HEIGHT_FUNCTION();
    EPODE_UNLOCKED(holder);
    if (inner == holder->inner) return;
    EPODE_USER_SAY(may_let_go(*holder), "Invalid operation during a collision");
    if (inner) {
        EPODE_PLACEABLE(inner);
        EPODE_USER(!holds(*inner, *holder));
        EPODE_USER_SAY(!dies_with(*inner, *holder), "the geom would die with the one that it replaces");
        EPODE_USER_SAY(line_below(*inner) + line_above(*holder) <= kMostNested,
                       "geom transforms are nested too deeply");
        EPODE_USER_SAY(!inner->space, "GeomTransform encapsulated object must not be in a space");
        EPODE_USER_SAY(!inner->body.id, "GeomTransform encapsulated object must not be attached to a body");
    }
    EPODE_USER_SAY(!holder->cleanup || !holder->inner || may_destroy(*holder->inner), EPODE_LOCKED_TEXT);
    hold(*holder, inner);
}

extern "C" dGeomID dGeomTransformGetGeom(dGeomID transform)
{
    EPODE_GEOM_AS(Transform, holder, transform, nullptr);
    return to_handle<Geom>(holder->inner);
}

extern "C" void dGeomTransformSetCleanup(dGeomID transform, int mode)
{
    EPODE_GEOM_AS(Transform, holder, transform);
    holder->cleanup = mode;
}

extern "C" int dGeomTransformGetCleanup(dGeomID transform)
{
    EPODE_GEOM_AS(Transform, holder, transform, 0);
    return holder->cleanup;
}

extern "C" void dGeomTransformSetInfo(dGeomID transform, int mode)
{
    EPODE_GEOM_AS(Transform, holder, transform);
    holder->info = mode;
}

extern "C" int dGeomTransformGetInfo(dGeomID transform)
{
    EPODE_GEOM_AS(Transform, holder, transform, 0);
    return holder->info;
}
