// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The cross of a Cardan joint: axis a1 fixed in body 1, a2 fixed in body 2, perpendicular to each other.
//   -a1.a2 = 0       J = [ 0, n, 0, -n ],  n = a1 x a2 / |a1 x a2|
// Angles are those of a cross whose arms are a1 and a2: angle 1 turns body 1 against the cross about a1,
// angle 2 the cross against body 2 about a2. Quaternions against a frame on the arms instead of the angle
// between two planes: exact to rounding all around. Universal and PU joints have it in common.
#pragma once

#include "base/streams/structure_stream.h"
#include "joints/describe.h"
#include "joints/reading.h"

namespace epode {

struct Cross {
    Vec3 local[2];  // each in its own body
    Quat zero[2];
    // What the rotation of body i against the cross follows from.
    struct Turn {
        Mat3 R1, R2;
        Quat own, zero;
        Vec3 arm1, arm2;
    };
    Reading<Turn, Real> turn[2] = {};

    Vec3 axis(const Joint& j, int i) const { return direction_to_world(j.node[i].body, local[i]); }
    Real angle(const Joint& j, int i) const { return i == 0 ? body_angle(j, 0) : -body_angle(j, 1); }
    Real rate(const Joint& j, int i) const { return dot(axis(j, i), relative_angular_velocity(j)); }
    // From now on the angles read these.
    void set_zero(const Joint& j, Real reading1 = 0, Real reading2 = 0);
    // set_zero() must follow.
    void set_axis(const Joint& j, int i, Vec3 unit) { local[i] = direction_to_local(j.node[i].body, unit); }
    void describe_axes(DifWriter& out) const
    {
        for (int i = 0; i < 2; ++i) epode::describe(out, "axis", local[i], i + 1);
    }
    void describe_zero(DifWriter& out) const
    {
        for (int i = 0; i < 2; ++i) epode::describe(out, "qrel", zero[i], i + 1);
    }
    void lock_right_angle(const Joint& j, RowWriter& out) const;
    void structure(StructureStream& stream)
    {
        for (int i = 0; i < 2; ++i) stream.vector(local[i]), stream.quaternion(zero[i]);
    }

  private:
    Quat orientation(const Joint& j, int i) const;
    Real body_angle(const Joint& j, int i) const;
};

}  // namespace epode
