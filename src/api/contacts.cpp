// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of world-managed contacts.
#include "ode/contacts.h"

#include <algorithm>

#include "base/objects/structure_edition.h"
#include "collide/types/registry.h"
#include "contacts/material.h"
#include "dynamics/world.h"
#include "step/step.h"

using namespace epode;

namespace {

const ContactWorld* world_contacts(const World& world)
{
    return world.step_state ? &world.step_state->world_contacts : nullptr;
}

bool has_faces(const Geom& geom)
{
    return geom.type->number == dTriMeshClass || geom.type->number == dHeightfieldClass;
}

}  // namespace

extern "C" {

void dWorldSetContactSpace(dWorldID w, dSpaceID s)
{
    EPODE_WORLD_OR();
    EPODE_USER_SAY(!in_step(*world), busy_text(*world));
    EPODE_USER_SAY(!s || space_from(s), "argument not a space");
    StepState* state = step_state(*world);
    EPODE_USER_SAY(state, "out of memory");
    if (state->world_contacts.space == s) return;
    state->world_contacts.forget();
    state->world_contacts.space = s;
    world->manages_contacts = s != nullptr;
    note_structure_changed();
}

dSpaceID dWorldGetContactSpace(dWorldID w)
{
    EPODE_WORLD_OR(nullptr);
    const ContactWorld* contacts = world_contacts(*world);
    return contacts && contacts->live_space() ? contacts->space : nullptr;
}

void dWorldSetContactFilter(dWorldID w, dContactFilter* filter, void* data)
{
    EPODE_WORLD_OR();
    EPODE_USER_SAY(!in_step(*world), busy_text(*world));
    StepState* state = step_state(*world);
    EPODE_USER_SAY(state, "out of memory");
    state->world_contacts.filter = filter;
    state->world_contacts.filter_data = data;
}

void dWorldSetManifoldFunction(dWorldID w, dManifoldFunction* function, void* data, int threads)
{
    EPODE_WORLD_OR();
    EPODE_USER_SAY(!in_step(*world), busy_text(*world));
    EPODE_USER(threads == 0 || threads == 1);
    StepState* state = step_state(*world);
    EPODE_USER_SAY(state, "out of memory");
    ContactWorld& contacts = state->world_contacts;
    contacts.function = function, contacts.function_data = data;
    contacts.function_on_threads = threads == 1;
}

int dGeomSetMaterial(dGeomID g, const dMaterial* material)
{
    EPODE_GEOM(geom, g, 0);
    dMaterial whole = kDefaultMaterial;
    if (material) {
        EPODE_SIZED(material, 0);
        whole = completed(*material, kDefaultMaterial);
        EPODE_USER(usable_material(whole), 0);
    }
    EPODE_USER_SAY(set_material(*geom, material ? &whole : nullptr), "out of memory", 0);
    return 1;
}

int dGeomGetMaterial(dGeomID g, dMaterial* material)
{
    EPODE_GEOM(geom, g, 0);
    EPODE_SIZED(material, 0);
    copy_sized(material_of(*geom), material, material->struct_size);
    return 1;
}

int dMaterialInit(dMaterial* material, unsigned struct_size)
{
    EPODE_SIZED_AS(material, struct_size, 0);
    copy_sized(kDefaultMaterial, material, struct_size);
    return 1;
}

int dGeomSetFaceMaterial(dGeomID g, int number, const dMaterial* material)
{
    EPODE_GEOM(geom, g, 0);
    EPODE_USER(number >= 1 && number <= kMostFaceMaterials, 0);
    dMaterial whole = kDefaultMaterial;
    if (material) {
        EPODE_SIZED(material, 0);
        whole = completed(*material, kDefaultMaterial);
        EPODE_USER(usable_material(whole), 0);
    }
    EPODE_USER_SAY(set_face_material(*geom, number, material ? &whole : nullptr), "out of memory", 0);
    return 1;
}

int dGeomGetFaceMaterial(dGeomID g, int number, dMaterial* material)
{
    EPODE_GEOM(geom, g, 0);
    EPODE_USER(number >= 1 && number <= kMostFaceMaterials, 0);
    EPODE_SIZED(material, 0);
    copy_sized(face_material(*geom, number), material, material->struct_size);
    return 1;
}

int dGeomSetFaceMaterialNumbers(dGeomID g, const unsigned char* numbers, int count)
{
    EPODE_GEOM(geom, g, 0);
    EPODE_USER_SAY(has_faces(*geom), "argument not a mesh or a height field", 0);
    EPODE_USER(count >= 0 && (numbers || count == 0), 0);
    EPODE_USER_SAY(count == 0 || count == face_count(*geom), "not a number for each face", 0);
    EPODE_USER_SAY(set_face_numbers(*geom, {numbers, std::size_t(count)}), "out of memory", 0);
    return 1;
}

int dGeomGetFaceMaterialNumbers(dGeomID g, unsigned char* numbers, int capacity)
{
    EPODE_GEOM(geom, g, 0);
    EPODE_USER_SAY(has_faces(*geom), "argument not a mesh or a height field", 0);
    EPODE_USER(capacity >= 0 && (numbers || capacity == 0), 0);
    const auto all = face_numbers(*geom);
    std::copy_n(all.begin(), std::min(all.size(), std::size_t(capacity)), numbers);
    return int(all.size());
}

int dWorldGetContactEvents(dWorldID w, dContactEvent* events, int capacity)
{
    EPODE_WORLD_OR(0);
    EPODE_USER(capacity >= 0 && (events || capacity == 0), 0);
    const ContactWorld* contacts = world_contacts(*world);
    return contacts ? contacts->events(events, capacity) : 0;
}

int dWorldGetContacts(dWorldID w, dWorldContact* out, int capacity)
{
    EPODE_WORLD_OR(0);
    EPODE_USER(capacity >= 0 && (out || capacity == 0), 0);
    const ContactWorld* contacts = world_contacts(*world);
    return contacts ? contacts->contacts(out, capacity) : 0;
}

}  // extern "C"
