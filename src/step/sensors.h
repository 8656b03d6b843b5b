// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What overlaps the sensors of a world. Let O(t) be the set of pairs (sensor, other geom) that overlap at the
// end of step t; then O(t) - O(t-1) have begun and O(t-1) - O(t) have ended. O is a function of poses and
// shapes alone. So sleeping bodies need no special care, nothing of it has to be in states of the world, and
// where nothing in the space has changed O stays as it is. The alternative, sensors as pairs of world-managed
// contacts, would look at the beginning of steps, miss pairs without a moving body and wake what lies in them.
#pragma once

#include <cstdint>

#include "collide/space.h"
#include "contacts/event_list.h"
#include "dynamics/world.h"
#include "step/common/cut_short.h"

namespace epode {

class Sensors {
  public:
    // The overlaps now, in the space of the world (null: none); events about what has changed go to `out`.
    // False: out of memory, and the overlaps are those of before.
    [[nodiscard]] bool update(const World& world, Space* space, CutShort& cut_short, EventList& out);
    // The same without events.
    [[nodiscard]] bool restart(const World& world, Space* space);
    void clear()
    {
        overlaps_.clear(), sensors_.clear();
        space_ = nullptr, structure_ = 0;
    }

  private:
    struct Overlap {
        std::uint64_t sensor_serial, other_serial;
        dGeomID sensor, other;

        bool before(const Overlap& o) const
        {
            return sensor_serial != o.sensor_serial ? sensor_serial < o.sensor_serial
                                                    : other_serial < o.other_serial;
        }
    };

    [[nodiscard]] bool find(const World& world, Space* space, CutShort& cut_short);
    [[nodiscard]] bool list_sensors(Space& space);
    [[nodiscard]] bool look_around(const World& world, Space& space, Geom& sensor, CutShort& cut_short);
    void report_changes(EventList& out) const;

    Array<Overlap> overlaps_, found_;  // of the last step, of this one; sorted
    Array<Geom*> sensors_, near_;
    const Space* space_ = nullptr;
    std::uint64_t structure_ = 0;  // the edition in which sensors_ were listed
    std::uint64_t edition_ = 0;    // of the space, when found_ was made
};

}  // namespace epode
