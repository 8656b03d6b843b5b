// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms and spaces in the structure of a world.
#include "base/check.h"
#include "collide/character.h"
#include "collide/types/registry.h"
#include "state/object_structure.h"
#include "state/world_structure.h"
#include "step/common/link.h"
#include "step/step.h"

namespace epode {
namespace {

constexpr std::size_t kGeomBytes = 32, kGeomNameBytes = 5;

ContactWorld* contacts_of(World& world)
{
    return world.step_state ? &world.step_state->world_contacts : nullptr;
}

}  // namespace

bool WorldStructure::gather_geoms()
{
    if (space_ && !gather_space(*space_)) return false;
    const ContactWorld* const contacts = contacts_of(*world_);
    const Space* const in_contact = contacts ? contacts->live_space() : nullptr;
    if (!stream_.demand(!in_contact || stream_.find(*in_contact) >= 0,
                        "the contact space of the world is not in the space to be copied"))
        return false;
    for (Body* body : bodies_) for_each_geom(*body, [&](Geom& geom) { (void)gather_geom(geom); });
    return !stream_.failed();
}

bool WorldStructure::gather_space(Space& space)
{
    if (!stream_.add(space)) return false;
    for (Geom* geom : space.geoms) {
        if (!geom) continue;
        const bool done = is_space(*geom) ? gather_space(static_cast<Space&>(*geom)) : gather_geom(*geom);
        if (!done) return false;
    }
    return true;
}

// What a transform holds comes before it.
bool WorldStructure::gather_geom(Geom& geom)
{
    if (stream_.failed()) return false;
    if (stream_.find(geom) >= 0) return true;
    const Body* const body = body_of(geom);
    if (!stream_.demand(!body || body->world == world_, "a geom in its space is on a body of another world"))
        return false;
    if (!geom.type->structure) {
        stream_.fail("a geom is of class %d, which the program has made: it cannot be copied",
                     geom.type->number);
        return false;
    }
    if (const TransformGeom* transform = as_transform(geom))
        if (transform->inner && !gather_geom(*transform->inner)) return false;
    return stream_.add(geom);
}

void WorldStructure::visit_geoms()
{
    const int count = stream_.count(int(stream_.geoms().size()), kGeomBytes, "geoms");
    for (int i = 0; i < count && !stream_.failed(); ++i) {
        if (stream_.saves())
            save_geom(*stream_.geoms()[std::size_t(i)]);
        else if (!load_geom())
            return;
    }
    bool has_space = space_ != nullptr;
    stream_.flag(has_space);
    if (stream_.saves() || !has_space || stream_.failed()) return;
    const bool first = count > 0 && is_space(*stream_.geoms()[0]);
    if (stream_.demand(first, "its first geom is no space")) space_ = static_cast<Space*>(stream_.geoms()[0]);
}

// A space that is not copied is left out.
void WorldStructure::save_geom(Geom& geom)
{
    int number = geom.type->number;
    Geom* parent = geom.space && stream_.find(*geom.space) >= 0 ? geom.space : nullptr;
    stream_.number(number), stream_.geom(parent);
    structure_of_geom(geom, stream_);
    geom.type->structure(geom, stream_);
    structure_of_character(geom, stream_);
}

bool WorldStructure::load_geom()
{
    int number = 0;
    Geom* parent = nullptr;
    stream_.number(number), stream_.geom(parent);
    const GeomType* const type = geom_type(number);
    if (!type || !type->create) stream_.fail("a geom in it has an unknown class, %d", number);
    if (stream_.failed()) return false;
    Geom* const geom = type->create(*type);
    if (!stream_.demand(geom, kOutOfMemory)) return false;
    if (!stream_.add(*geom)) {
        destroy_geom(*geom);
        return false;
    }
    structure_of_geom(*geom, stream_);
    if (!stream_.failed()) type->structure(*geom, stream_);
    if (!stream_.failed() && !stream_.is_older_than(4)) structure_of_character(*geom, stream_);
    return !stream_.failed() && (!parent || put_into(*parent, *geom));
}

bool WorldStructure::put_into(Geom& parent, Geom& geom)
{
    if (!stream_.demand(is_space(parent), "a geom in it lies in a geom that is no space")) return false;
    Space& space = static_cast<Space&>(parent);
    const bool fits = !is_space(geom) || nesting_fits(space, static_cast<Space&>(geom));
    return stream_.demand(fits, "spaces in it are nested too deeply") &&
           stream_.demand(add_geom(space, geom), kOutOfMemory);
}

// The oldest first: the body lists the newest first.
void WorldStructure::visit_geoms_of_bodies()
{
    Array<Geom*> all;
    for (Body* body : bodies_) {
        all.clear();
        bool has_memory = true;
        if (stream_.saves())
            for_each_geom(*body, [&](Geom& geom) { has_memory = all.push(&geom) && has_memory; });
        if (!stream_.demand(has_memory, kOutOfMemory)) return;
        const int count = stream_.count(all.size(), kGeomNameBytes, "geoms of a body");
        for (int i = count; i-- > 0 && !stream_.failed();)
            visit_geom_of_body(*body, stream_.saves() ? all[i] : nullptr);
    }
}

void WorldStructure::visit_geom_of_body(Body& body, Geom* geom)
{
    bool shifted = geom && geom->offset;
    stream_.geom(geom), stream_.flag(shifted);
    if (stream_.loads()) {
        const bool fits = geom && geom->type->placeable && !geom->body.id && !geom->holders;
        if (!stream_.demand(fits, "a body in it has a geom that it cannot have")) return;
        attach_geom(*geom, &body);
        if (shifted && !stream_.demand(ensure_offset(*geom), kOutOfMemory)) return;
    }
    if (shifted) structure_of_pose(geom->offset->position, geom->offset->rotation, stream_);
}

void WorldStructure::visit_contacts()
{
    const ContactWorld* const from = stream_.saves() ? contacts_of(*world_) : nullptr;
    Geom* space = from ? from->live_space() : nullptr;
    dContactFilter* filter = from ? from->filter : nullptr;
    void* data = from ? from->filter_data : nullptr;
    stream_.geom(space), stream_.pointer(filter), stream_.pointer(data);
    dManifoldFunction* function = from ? from->function : nullptr;
    void* function_data = from ? from->function_data : nullptr;
    static char yes;  // its address: the function is called by any thread
    char* on_threads = from && from->function_on_threads ? &yes : nullptr;
    stream_.pointer(function), stream_.pointer(function_data), stream_.pointer(on_threads);
    if (stream_.saves() || stream_.failed() || (!space && !filter && !function)) return;
    if (!stream_.demand(!space || is_space(*space), "its contact space is a geom that is no space")) return;
    StepState* const kept = step_state(*world_);
    if (!stream_.demand(kept, kOutOfMemory)) return;
    kept->world_contacts.space = space ? id_of(static_cast<Space*>(space)) : nullptr;
    world_->manages_contacts = space != nullptr;
    kept->world_contacts.filter = filter, kept->world_contacts.filter_data = data;
    kept->world_contacts.function = function, kept->world_contacts.function_data = function_data;
    kept->world_contacts.function_on_threads = on_threads != nullptr;
}

// Transforms first let go what they hold, so that each geom is destroyed once.
void WorldStructure::discard_geoms()
{
    const std::span<Geom* const> all = stream_.geoms();
    for (Geom* geom : all)
        if (TransformGeom* transform = as_transform(*geom)) set_transform_geom(*transform, nullptr);
    for (Geom* geom : all)
        if (is_space(*geom)) static_cast<Space*>(geom)->cleanup = false;
    for (std::size_t i = all.size(); i-- > 0;) destroy_geom(*all[i]);
}

}  // namespace epode
