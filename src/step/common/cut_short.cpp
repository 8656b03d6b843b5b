// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/common/cut_short.h"

#include "base/messages.h"
#include "query/effort.h"

namespace epode {

void CutShort::add(const Geom& a, const Geom& b, const char* by)
{
    if (by_) return;
    by_ = by;
    classes_[0] = a.type->number, classes_[1] = b.type->number;
}

void CutShort::send(const World& world)
{
    reported_ = true;
    note(0,
         "step %llu: %s has looked at a part of a pair of geoms, of classes %d and %d: one covers more of "
         "the other "
         "than %lld cells of a height field. Steps go on",
         static_cast<unsigned long long>(world.step_count), by_, classes_[0], classes_[1],
         static_cast<long long>(Effort::kCells));
}

}  // namespace epode
