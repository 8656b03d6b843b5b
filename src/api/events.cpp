// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Events and sensors, as C functions.
#include "ode/events.h"

#include "base/objects/struct_size.h"
#include "collide/types/registry.h"
#include "step/step.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dEventSettings> = offsetof(dEventSettings, capacity);

}  // namespace epode

using namespace epode;

namespace {

constexpr int kMaxCapacity = 1 << 20;
constexpr unsigned kAllKinds = (1u << (dEventJointBreak + 1)) - 1;

// What is wrong with the settings, in words; null: nothing.
const char* fault_in(const dEventSettings& s)
{
    if (s.kinds & ~kAllKinds) return "kinds must be a sum of 1 << dEventKind";
    if (s.capacity < 1 || s.capacity > kMaxCapacity) return "capacity must be 1 ... 1048576";
    if (!usable(s.min_impulse) || !(s.min_impulse >= 0)) return "min_impulse must be 0 or more, and finite";
    if (!usable(s.min_approach_speed) || !(s.min_approach_speed >= 0))
        return "min_approach_speed must be 0 or more, and finite";
    return nullptr;
}

const EventList* events_of(const World& world)
{
    return world.step_state ? &world.step_state->events.list() : nullptr;
}

// With what no longer exists marked.
dEvent marked(const dEvent& event)
{
    dEvent out = event;
    out.gone = 0;
    if (event.g1 && !from_handle<Geom>(event.g1)) out.gone |= dEventGoneG1;
    if (event.g2 && !from_handle<Geom>(event.g2)) out.gone |= dEventGoneG2;
    if (event.joint && !from_handle<Joint>(event.joint)) out.gone |= dEventGoneJoint;
    return out;
}

}  // namespace

extern "C" {

int dEventSettingsInit(dEventSettings* settings, unsigned struct_size)
{
    EPODE_SIZED_AS(settings, struct_size, 0);
    copy_sized(kDefaultEventSettings, settings, struct_size);
    return 1;
}

int dWorldSetEventSettings(dWorldID w, const dEventSettings* settings)
{
    EPODE_WORLD_OR(0);
    EPODE_USER_SAY(!in_step(*world), busy_text(*world), 0);
    dEventSettings whole = kDefaultEventSettings;
    whole.kinds = 0;
    if (settings) {
        EPODE_SIZED(settings, 0);
        whole = completed(*settings, kDefaultEventSettings);
        const char* const fault = fault_in(whole);
        EPODE_USER_SAY(!fault, fault, 0);
    }
    StepState* const state = step_state(*world);
    EPODE_USER_SAY(state && state->events.set(whole), kOutOfMemory, 0);
    return 1;
}

int dWorldGetEventSettings(dWorldID w, dEventSettings* settings)
{
    EPODE_WORLD_OR(0);
    EPODE_SIZED(settings, 0);
    const EventList* const list = events_of(*world);
    const bool on = list && list->wants_any();
    copy_sized(on ? list->settings() : kDefaultEventSettings, settings, settings->struct_size);
    return on;
}

int dWorldGetEvents(dWorldID w, dEvent* events, int capacity)
{
    EPODE_WORLD_OR(0);
    EPODE_USER(capacity >= 0 && (events || capacity == 0), 0);
    const EventList* const list = events_of(*world);
    if (!list) return 0;
    int count = 0;
    for (const EventList::Record& record : list->records())
        if (count++ < capacity) events[count - 1] = marked(record.event);
    return count;
}

int dWorldGetLostEvents(dWorldID w)
{
    EPODE_WORLD_OR(0);
    const EventList* const list = events_of(*world);
    return list ? list->lost() : 0;
}

void dGeomSetSensor(dGeomID id, int mode)
{
    EPODE_GEOM(geom, id);
    EPODE_USER_SAY(!is_space(*geom), "argument must not be a space");
    EPODE_USER(mode == 0 || mode == 1);
    EPODE_UNLOCKED(geom);
    set_sensor(*geom, mode != 0);
}

int dGeomGetSensor(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    return geom->sensor;
}

}  // extern "C"
