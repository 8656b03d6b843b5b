// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A rod of a given length between a point of body 1 and a point of body 2, which pulls and pushes.
//   C(x) = length - |g| = 0,             g = x1 + R1 s1 - x2 - R2 s2
//   J    = [ d, r1 x d, -d, -(r2 x d) ]  d = g / |g|
// Points in one place have no direction: then the rod lies along their relative velocity, or along x. DBall
// and DHinge have it in common. Unlike other anchors, its ends may be given before there are bodies: the
// numbers are then those of the frames to come.
#pragma once

#include "base/streams/structure_stream.h"
#include "joints/describe.h"

namespace epode {

struct Rod {
    explicit Rod(const World& world) : softness(world) {}

    AnchorPair end;
    Real length = 0;
    OwnSoftness softness;

    // The present distance is the one to keep.
    void measure(const Joint& j);
    void set_user_end(const Joint& j, int user_index, Vec3 point);
    void describe(DifWriter& out) const
    {
        epode::describe(out, end);
        out.real("distance", length);
        epode::describe(out, softness);
    }
    void lock(const Joint& j, RowWriter& out) const;
    void shift(const Joint& j, Vec3 by)
    {
        if (j.attached()) end.shift(j, by);
    }
    void structure(StructureStream& stream) { end.structure(stream), stream.real(length); }
};

}  // namespace epode
