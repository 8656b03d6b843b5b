// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Clones and files of worlds, as C functions.
#include "ode/world_file.h"

#include "base/check.h"
#include "base/float_environment.h"
#include "base/streams/whole_file.h"
#include "state/shift_origin.h"
#include "state/world_copy.h"
#include "step/step.h"

using namespace epode;

namespace {

constexpr std::size_t kText = 240;

// The outermost space to be copied: the one that is given, or that of the contacts, or none.
Space* space_of(const World& world, dSpaceID given)
{
    if (given) return space_from(given);
    return world.step_state ? world.step_state->world_contacts.live_space() : nullptr;
}

dWorldID handles_of(const WorldCopy& copy, dSpaceID* space)
{
    if (space) *space = id_of(copy.space);
    return to_handle(copy.world);
}

}  // namespace

#define IDLE_WORLD_AND_SPACE_OR(result)                                  \
    World* const world = from_handle<World>(w);                          \
    EPODE_USER(world, result);                                           \
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), result);         \
    EPODE_USER_SAY(!s || space_from(s), "argument not a space", result); \
    Space* const space = space_of(*world, s);                            \
    [[maybe_unused]] char text[kText]

extern "C" {

dWorldID dWorldClone(dWorldID w, dSpaceID* from, dHandlePair* table, int capacity)
{
    const FloatEnvironment floats;
    const dSpaceID s = from ? *from : nullptr;
    IDLE_WORLD_AND_SPACE_OR(nullptr);
    EPODE_USER(capacity >= 0 && (table || capacity == 0), nullptr);
    WorldCopy copy;
    const char* const wrong = clone_world(*world, space, copy, {table, capacity}, text, sizeof text);
    EPODE_USER_SAY(!wrong, wrong, nullptr);
    return handles_of(copy, from);
}

int dWorldShiftOrigin(dWorldID w, dSpaceID s, const dVector3 offset)
{
    const FloatEnvironment floats;
    World* const world = from_handle<World>(w);
    EPODE_USER(world && offset && usable(offset, 3), 0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    EPODE_USER_SAY(!s || space_from(s), "argument not a space", 0);
    const char* const wrong = shift_origin(*world, space_of(*world, s), -load(offset));
    EPODE_USER_SAY(!wrong, wrong, 0);
    return 1;
}

int dWorldCountHandles(dWorldID w, dSpaceID s)
{
    IDLE_WORLD_AND_SPACE_OR(0);
    const int count = count_handles(*world, space, text, sizeof text);
    EPODE_USER_SAY(count > 0, text, 0);
    return count;
}

int dWorldSave(dWorldID w, dSpaceID s, const char* path)
{
    const FloatEnvironment floats;
    IDLE_WORLD_AND_SPACE_OR(0);
    EPODE_USER(path, 0);
    Array<std::byte> bytes;
    const char* wrong = save_world(*world, space, bytes, text, sizeof text);
    if (!wrong) wrong = write_file(path, bytes.span(), text, sizeof text);
    EPODE_USER_SAY(!wrong, wrong, 0);
    return 1;
}

size_t dWorldSaveToBuffer(dWorldID w, dSpaceID s, void* buffer, size_t capacity)
{
    const FloatEnvironment floats;
    IDLE_WORLD_AND_SPACE_OR(0);
    EPODE_USER(buffer || capacity == 0, 0);
    Array<std::byte> bytes;
    const char* const wrong = save_world(*world, space, bytes, text, sizeof text);
    EPODE_USER_SAY(!wrong, wrong, 0);
    const auto size = std::size_t(bytes.size());
    if (size <= capacity) std::memcpy(buffer, bytes.data(), size);
    return size;
}

dWorldID dWorldLoad(const char* path, dSpaceID* space)
{
    const FloatEnvironment floats;
    EPODE_USER(path, nullptr);
    Array<std::byte> bytes;
    WorldCopy copy;
    char text[kText];
    const char* wrong = read_file(path, bytes, text, sizeof text);
    if (!wrong) wrong = load_world(bytes.span(), copy, text, sizeof text);
    EPODE_USER_SAY(!wrong, wrong, nullptr);
    return handles_of(copy, space);
}

dWorldID dWorldLoadFromBuffer(const void* buffer, size_t size, dSpaceID* space)
{
    const FloatEnvironment floats;
    EPODE_USER(buffer, nullptr);
    WorldCopy copy;
    char text[kText];
    const char* const wrong =
        load_world({static_cast<const std::byte*>(buffer), size}, copy, text, sizeof text);
    EPODE_USER_SAY(!wrong, wrong, nullptr);
    return handles_of(copy, space);
}

}  // extern "C"
