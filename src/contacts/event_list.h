// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The events of one step (ode/events.h). Memory for `capacity` of them is reserved when the settings are made,
// so that a step never asks for any. Where the list is full, events count as lost; since persist events are
// many and say the least, another event takes the place of one of them. The order is by kind and then by the
// serial numbers of the objects, which no thread, space or tree decides.
#pragma once

#include "base/array.h"
#include "math/vec.h"
#include "ode/events.h"

namespace epode {

inline constexpr dEventSettings kDefaultEventSettings{
    sizeof(dEventSettings), (1u << (dEventJointBreak + 1)) - 1 - (1u << dEventContactPersist), 1024, 0, 0};

class EventList {
  public:
    struct Record {
        dEvent event;
        std::uint64_t first, second;  // serial numbers
    };

    // No kinds: the list is off. False: out of memory, and nothing has changed.
    [[nodiscard]] bool set(const dEventSettings& settings)
    {
        Array<Record> records;
        if (settings.kinds && !records.reserve(settings.capacity)) return false;
        settings_ = settings;
        records_.swap(records);
        clear();
        return true;
    }
    const dEventSettings& settings() const { return settings_; }
    bool wants(dEventKind kind) const { return settings_.kinds >> kind & 1; }
    bool wants_contacts() const { return settings_.kinds & 7u; }
    bool wants_sensors() const { return settings_.kinds >> dEventSensorBegin & 3; }
    bool wants_any() const { return settings_.kinds != 0; }

    void clear()
    {
        records_.clear();
        lost_ = persists_begin_ = persists_end_ = 0;
    }
    void add(const Record& record);
    void lose() { ++lost_; }
    void shift(Vec3 by)
    {
        for (Record& record : records_) store(record.event.pos, load(record.event.pos) + by);
    }
    void sort();

    int lost() const { return lost_; }
    std::span<const Record> records() const { return records_.span(); }

  private:
    dEventSettings settings_{sizeof(dEventSettings), 0, 1, 0, 0};
    Array<Record> records_;
    int persists_begin_ = 0, persists_end_ = 0;  // places of persist events, which are added in one go
    int lost_ = 0;
};

}  // namespace epode
