// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs whose own work is a few dozen instructions (PAIR_AT_ONCE in collide/pairs/pairs.inc) would spend most
// of their time in dispatch: copying poses, passing a sink, one more call. For these pairs one function goes
// from two geoms to the client's array. It is compiled together with the pair function and reads only what it
// needs of the poses. The pair function itself is pure,
// for geoms in transforms and queries.
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
