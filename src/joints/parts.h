// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pieces that joints are made of. x1, R1, v1, w1: position, rotation and velocities of the body at node
// 0; likewise 2, which may be missing: then its frame is the world's. Every error is written so that, with
// the rows before it satisfied,  d(error)/dt = -J v:  a stepper that asks for J v = (erp/h) error removes it.
//
//   point row along d         J = [ d,  r1 x d,  -d,  -(r2 x d) ]
//   angular row about d       J = [ 0,  d,        0,  -d ]
//   sliding row along d       J = [ d,  a,       -d,   a ],   a = 1/2 (x2 - x1) x d
//
// The torque arm of the sliding row splits the couple of the two forces evenly, so no angular momentum is
// made.
#pragma once

#include "dynamics/joint.h"
#include "math/pose.h"
#include "rows/row_writer.h"

namespace epode {

struct World;

// ---- frames; no body means the world ----
inline Vec3 point_to_world(const Body* b, Vec3 p) { return b ? b->pose().to_world(p) : p; }
inline Vec3 point_to_local(const Body* b, Vec3 p) { return b ? b->pose().to_local(p) : p; }
inline Vec3 direction_to_world(const Body* b, Vec3 d) { return b ? b->rotation() * d : d; }
inline Vec3 direction_to_local(const Body* b, Vec3 d) { return b ? transposed_times(b->rotation(), d) : d; }
inline Quat orientation_of(const Body* b) { return b ? b->orientation() : Quat{}; }
inline Mat3 rotation_of(const Body* b) { return b ? b->rotation() : Mat3::identity(); }

// Place in `node` of the body that the user calls `user_index`.
inline int node_of(const Joint& j, int user_index) { return j.reverse ? 1 - user_index : user_index; }

// A point fixed in both bodies.
struct AnchorPair {
    Vec3 local[2];
    void set(const Joint& j, Vec3 world_point);
    Vec3 world(const Joint& j, int node) const { return point_to_world(j.node[node].body, local[node]); }
    Vec3 of_user(const Joint& j, int user_index) const { return world(j, node_of(j, user_index)); }
    void reattach(const Joint& j) { set(j, of_user(j, 0)); }
    void shift(const Joint& j, Vec3 by)  // of the world
    {
        for (int i = 0; i < 2; ++i)
            if (!j.node[i].body) local[i] += by;
    }
    void structure(StructureStream& stream);
};

// A direction fixed in both bodies.
struct AxisPair {
    Vec3 local[2];
    void set(const Joint& j, Vec3 unit);
    Vec3 world(const Joint& j, int node) const { return direction_to_world(j.node[node].body, local[node]); }
    void reattach(const Joint& j) { set(j, world(j, 0)); }
    void structure(StructureStream& stream);
};

// Of a motor: how many axes there are, the frames in which they are fixed (0 world, 1 and 2 the bodies), and
// the axes there.
void structure_of_axes(StructureStream& stream, int& count, int (&frame)[3], Vec3 (&axis)[3]);

// A spring and damper in physical units, in the place of ERP and CFM.
struct Spring {
    RowDrive drive;
    bool acts = false;  // its stiffness and damping are not both 0

    // To so many rows from this one on.
    void apply_to(RowWriter& out, Row& first, int count = 1) const
    {
        if (acts) [[unlikely]]
            take(out, &first, count);
    }

  private:
    void take(RowWriter& out, Row* rows, int count) const;
};

// ERP and CFM that belong to the joint itself; the world's at its creation until the client sets them.
struct OwnSoftness {
    explicit OwnSoftness(const World& world);
    Real erp, cfm;
    bool chosen = false;
    Spring spring;  // takes their place
    bool set(int param, Real value);
    bool get(int param, Real& value) const;
    void state(const World& world, StateStream& stream);
    // What most joints have: states leave it out. Fixed, so that a state does not depend on the world's values of the
    // day; those before format 7 did.
    struct Usual {
        Usual(const World& world, const StateStream& stream);
        Real erp, cfm;
    };
    void apply_to(Row& row) const { row.erp = erp, row.cfm = cfm, row.soft = chosen; }
    void apply_to(RowWriter& out, Row& row) const { apply_to(row), spring.apply_to(out, row); }
};

// ---- relative motion ----
Vec3 relative_velocity(const Joint& j);          // v1 - v2
Vec3 relative_angular_velocity(const Joint& j);  // w1 - w2
Quat relative_orientation(const Joint& j);       // q1^-1 q2

// Rotation of frame 1 against frame 2 about a unit axis given in frame 1, in [-pi, pi]; zero where
// q1^-1 q2 = zero.
Real hinge_angle(Quat q1, Quat q2, Quat zero, Vec3 axis_local);
// The zero for which hinge_angle reads `angle` now.
Quat hinge_zero(Quat q1, Quat q2, Vec3 axis_local, Real angle = 0);

// Any unit vector perpendicular to the unit vector n.
inline Vec3 some_perpendicular(Vec3 n)
{
    Vec3 p, q;
    plane_space(n, p, q);
    return p;
}

// ---- rows ----
inline Jacobian point_jacobian(const Joint& j, Vec3 d, Vec3 r1, Vec3 r2)
{
    if (!j.body2()) return {d, cross(r1, d), {}, {}};
    return {d, cross(r1, d), -d, cross(d, r2)};
}
inline Jacobian angular_jacobian(const Joint& j, Vec3 d) { return {{}, d, {}, j.body2() ? -d : Vec3{}}; }
Jacobian sliding_jacobian(const Joint& j, Vec3 d);
inline AxisCarrier carrier_of(int node) { return node == 0 ? AxisCarrier::kBody1 : AxisCarrier::kBody2; }
// An angle about an axis, which J takes once, among others that J leaves out.
inline JointAxis angle_among(const Jacobian& J, Real angle, bool turns, AxisCarrier carrier, Vec3 axis)
{
    return {J, angle, turns, false, {}, {}, carrier, axis};
}
Real rate_along(const Joint& j, const Jacobian& row);  // J v

// Three rows: the anchors coincide.
void lock_point(const Joint& j, RowWriter& out, const AnchorPair& anchor, const OwnSoftness* own = nullptr);
// Three rows: q1^-1 q2 = zero. A zero quaternion (never set) locks the rates only.
void lock_orientation(const Joint& j, RowWriter& out, Quat zero);
// Two rows: the axes stay parallel.
void lock_axis(const Joint& j, RowWriter& out, const AxisPair& axis);

// ---- anchors that may part along a line of body 1 (PR, PU, piston) ----
// The row along a direction d of body 1 at body 2's anchor: the material points that are there now move
// alike. With d turning with body 1, this is minus the exact rate of  d.(anchor 2 - anchor 1)  however far
// they parted.
Jacobian separated_jacobian(const Joint& j, const AnchorPair& anchor, Vec3 d);
// The axis along d, with its position  d.(anchor 1 - anchor 2).
JointAxis separated_axis(const Joint& j, const AnchorPair& anchor, Vec3 d, Real position);
// One row: the anchors stay level along d.
void lock_level(const Joint& j, RowWriter& out, const AnchorPair& anchor, Vec3 d);

// ---- forces that a client adds ----
void add_torque(Joint& j, Vec3 torque);        // on body 1, the opposite on body 2
void add_sliding_force(Joint& j, Vec3 force);  // likewise at the centres, the couple split evenly
// Likewise, each at its own anchor; against the world at the centre, the joint taking the couple.
void add_force_at(Joint& j, const AnchorPair& anchor, Vec3 force);

}  // namespace epode
