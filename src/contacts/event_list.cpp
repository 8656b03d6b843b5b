// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/event_list.h"

#include <algorithm>
#include <tuple>

namespace epode {

void EventList::add(const Record& record)
{
    const bool persists = record.event.kind == dEventContactPersist;
    if (records_.size() < settings_.capacity) {
        if (persists && persists_begin_ == persists_end_) persists_begin_ = persists_end_ = records_.size();
        if (persists) ++persists_end_;
        (void)records_.push(record);  // has been reserved
        return;
    }
    ++lost_;
    if (!persists && persists_begin_ < persists_end_) records_[--persists_end_] = record;
}

void EventList::sort()
{
    std::sort(records_.begin(), records_.end(), [](const Record& a, const Record& b) {
        return std::tie(a.event.kind, a.first, a.second) < std::tie(b.event.kind, b.first, b.second);
    });
    persists_begin_ = persists_end_ = 0;
}

}  // namespace epode
