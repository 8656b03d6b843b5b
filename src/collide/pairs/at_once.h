// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs whose own work is a few dozen instructions (PAIR_AT_ONCE in collide/pairs/pairs.inc) would spend most
// of their time on the way: poses copied, a sink handed along, one call more. For these the way from two
// geoms to the client's array is a function of its own, made where the pair function is and of one piece with
// it; what of the poses it does not need is not read. The pair function itself stays as pure as the others,
// for geoms in transforms and for queries.
#pragma once

#include "collide/collide.h"
#include "collide/pairs/pairs.h"

namespace epode {

#define PAIR(First, Second, function)
#define PAIR_AT_ONCE(First, Second, function) void function##_at_once(Geom& a, Geom& b, ContactArray& out);
#include "collide/pairs/pairs.inc"
#undef PAIR

}  // namespace epode

#define EPODE_AT_ONCE(First, Second, function)                                                      \
    [[gnu::flatten]] void function##_at_once(Geom& a, Geom& b, ContactArray& out)                   \
    {                                                                                               \
        ContactSink sink(out.at(out.count), out.stride, out.capacity - out.count, out.unimportant); \
        sink.name(to_handle(&a), to_handle(&b));                                                    \
        sink.reach(out.margin);                                                                     \
        sink.report_to_program(out.to_program);                                                     \
        function(static_cast<const ShapeGeom<First>&>(a).shape, pose_of(a),                         \
                 static_cast<const ShapeGeom<Second>&>(b).shape, pose_of(b), sink);                 \
        out.count += sink.count();                                                                  \
    }
