// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The events of a world's steps (ode/events.h), from their three sources: pairs of world-managed contacts, joints
// that break, and sensors. A step lists them when it has been made and can no longer be taken back; sensors
// when geoms have been moved, after the callbacks.
#pragma once

#include "contacts/contact_world.h"
#include "step/sensors.h"

namespace epode {

class WorldEvents {
  public:
    // False: out of memory, and nothing has changed.
    [[nodiscard]] bool set(const dEventSettings& settings)
    {
        if (!list_.set(settings)) return false;
        sensors_.clear();
        return true;
    }
    const EventList& list() const { return list_; }
    void shift(Vec3 by) { list_.shift(by); }
    void lose() { list_.lose(); }  // the step was left by a function of the program

    // `contacts`: null if the step had nothing to do with them.
    void begin_step(const World& world, const ContactWorld* contacts);
    void end_step(const World& world, Space* space, CutShort& cut_short);
    // The world has been given a state.
    void restart(const World& world, Space* space);

  private:
    void list_breaks(const World& world);

    EventList list_;
    Sensors sensors_;
};

}  // namespace epode
