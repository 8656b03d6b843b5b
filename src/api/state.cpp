// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States of worlds, as C functions.
#include "ode/state.h"

#include <cstdio>

#include "base/check.h"
#include "base/float_environment.h"
#include "state/delta.h"
#include "state/state_header.h"
#include "state/world_archive.h"
#include "step/common/link.h"

using namespace epode;

namespace {

std::span<const std::byte> bytes(const void* data, std::size_t size)
{
    return {static_cast<const std::byte*>(data), size};
}

constexpr int kMaxHistory = 100000;  // frames

// What sensors overlap is found again, for which functions of the program may be called.
template <typename Call>
const char* marked(World& world, Call&& call)
{
    const CopyMark mark(world);
    return call();
}

}  // namespace

#define IDLE_WORLD_OR(result)                   \
    World* const world = from_handle<World>(w); \
    EPODE_USER(world, result);                  \
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), result)

// The lists of the world that a state is saved with.
#define STATE_OR(result)                              \
    WorldArchive* const archive = archive_of(*world); \
    EPODE_USER_SAY(archive, kOutOfMemory, result);    \
    WorldState& state = archive->state

extern "C" {

size_t dWorldGetStateSize(dWorldID w)
{
    const FloatEnvironment floats;
    IDLE_WORLD_OR(0);
    STATE_OR(0);
    EPODE_USER_SAY(state.prepare() && state.write(Seal::kUnsealed), kOutOfMemory, 0);
    return state.written().size();
}

int dWorldGetState(dWorldID w, void* buffer, size_t size)
{
    const FloatEnvironment floats;
    IDLE_WORLD_OR(0);
    EPODE_USER(buffer, 0);
    STATE_OR(0);
    EPODE_USER_SAY(state.prepare() && state.write(Seal::kUnsealed), kOutOfMemory, 0);
    EPODE_USER_SAY(state.written().size() <= size, "the buffer is smaller than dWorldGetStateSize() says", 0);
    copy_sealed(buffer, state.written());
    return 1;
}

int dWorldSetState(dWorldID w, const void* buffer, size_t size)
{
    const FloatEnvironment floats;
    IDLE_WORLD_OR(0);
    EPODE_USER(buffer, 0);
    STATE_OR(0);
    EPODE_USER_SAY(state.prepare(), kOutOfMemory, 0);
    EPODE_USER_SAY(!state.is_locked(), EPODE_LOCKED_TEXT, 0);
    const char* const wrong =
        marked(*world, [&] { return state.set(static_cast<const std::byte*>(buffer), size); });
    EPODE_USER_SAY(!wrong, wrong, 0);
    return 1;
}

size_t dWorldGetStateDelta(dWorldID w, const void* base, size_t base_size, void* out, size_t capacity)
{
    const FloatEnvironment floats;
    IDLE_WORLD_OR(0);
    EPODE_USER(base && (out || capacity == 0), 0);
    STATE_OR(0);
    EPODE_USER_SAY(state.prepare() && state.write(Seal::kSealed), kOutOfMemory, 0);
    const char* const wrong = state.check(static_cast<const std::byte*>(base), base_size);
    EPODE_USER_SAY(!wrong, wrong, 0);
    Array<std::uint32_t> delta;
    EPODE_USER_SAY(write_delta(bytes(base, base_size), state.written(), delta), kOutOfMemory, 0);
    const std::size_t needed = 4 * std::size_t(delta.size());
    if (out && needed <= capacity) std::memcpy(out, delta.data(), needed);
    return needed;
}

int dWorldSetStateDelta(dWorldID w, const void* base, size_t base_size, const void* delta, size_t delta_size)
{
    const FloatEnvironment floats;
    IDLE_WORLD_OR(0);
    EPODE_USER(base && delta, 0);
    Array<std::uint32_t> whole;
    char text[200];
    const char* wrong =
        read_delta(bytes(base, base_size), bytes(delta, delta_size), whole, text, sizeof text);
    EPODE_USER_SAY(!wrong, wrong, 0);
    STATE_OR(0);
    EPODE_USER_SAY(state.prepare(), kOutOfMemory, 0);
    EPODE_USER_SAY(!state.is_locked(), EPODE_LOCKED_TEXT, 0);
    const auto* const restored = reinterpret_cast<const std::byte*>(whole.data());
    wrong = marked(*world, [&] { return state.set(restored, 4 * std::size_t(whole.size())); });
    EPODE_USER_SAY(!wrong, wrong, 0);
    return 1;
}

// ---- history ----

int dWorldSetHistory(dWorldID w, int frames)
{
    const FloatEnvironment floats;
    IDLE_WORLD_OR(0);
    EPODE_USER(frames >= 0 && frames <= kMaxHistory, 0);
    if (frames == 0 && !history_of(*world)) return 1;
    WorldArchive* const archive = archive_of(*world);
    EPODE_USER_SAY(archive && archive->history.set_frames(frames), kOutOfMemory, 0);
    return 1;
}

int dWorldGetHistory(dWorldID w)
{
    IDLE_WORLD_OR(0);
    const History* history = history_of(*world);
    return history ? history->frames() : 0;
}

int dWorldGetHistoryFrames(dWorldID w)
{
    IDLE_WORLD_OR(0);
    const History* history = history_of(*world);
    return history ? history->available() : 0;
}

size_t dWorldGetHistorySize(dWorldID w)
{
    IDLE_WORLD_OR(0);
    const History* history = history_of(*world);
    return history ? history->bytes() : 0;
}

int dWorldRollBack(dWorldID w, int frames)
{
    const FloatEnvironment floats;
    IDLE_WORLD_OR(0);
    History* const history = history_of(*world);
    EPODE_USER_SAY(history && history->has_frames(), "the world has no history: dWorldSetHistory", 0);
    char text[120];
    std::snprintf(text, sizeof text, "cannot take back %d steps: the history has 0 to %d", frames,
                  history->available());
    EPODE_USER_SAY(frames >= 0 && frames <= history->available(), text, 0);
    WorldState& state = archive_of(*world)->state;  // is there if a history is
    EPODE_USER_SAY(state.prepare(), kOutOfMemory, 0);
    EPODE_USER_SAY(!state.is_locked(), EPODE_LOCKED_TEXT, 0);
    const char* const wrong = marked(*world, [&] { return history->roll_back(frames); });
    EPODE_USER_SAY(!wrong, wrong, 0);
    return 1;
}

}  // extern "C"
