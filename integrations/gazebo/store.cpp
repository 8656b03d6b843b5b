// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See store.h.
#include "integrations/gazebo/store.h"

#include <cstdarg>
#include <cstdio>

namespace epode::gazebo {

namespace {

// What the library refuses, as Gazebo prints errors.
void print_refusal(int, const char* text, va_list arguments)
{
    char line[512];
    std::vsnprintf(line, sizeof line, text, arguments);
    EPODE_GAZEBO_ERROR << line << "\n";
}

}  // namespace

Store::Store()
{
    dInitODE2(0);
    dSetMessageHandler(print_refusal);
}

Store::~Store()
{
    worlds_.clear();
    entities_.clear();
}

Identity Store::InitiateEngine(std::size_t engine)
{
    return engine == 0 ? GenerateIdentity(0) : GenerateInvalidId();
}

Identity Store::identity_of(const Entity* entity) const
{
    if (!entity) return GenerateInvalidId();
    const auto found = entities_.find(entity->id);
    return found == entities_.end() ? GenerateInvalidId() : GenerateIdentity(entity->id, found->second);
}

Entity* Store::find(std::size_t id) const
{
    const auto found = entities_.find(id);
    return found == entities_.end() ? nullptr : found->second.get();
}

void Store::forget(Entity& entity)
{
    entity.is_removed = true;
    entities_.erase(entity.id);
}

}  // namespace epode::gazebo
