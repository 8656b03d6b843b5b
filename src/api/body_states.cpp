// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States of many bodies as one array. All handles and numbers are judged before the first is written; then
// bodies are fetched ahead and copied. Reading costs what the cache lines of the bodies cost: the one with the tag, and
// those with the fields. So only these are fetched, and a loop of its own reads each of the usual sets of fields.
#include "base/check.h"
#include "base/float_environment.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "dynamics/world.h"
#include "ode/state.h"
#include "step/common/link.h"

using namespace epode;

namespace {

constexpr unsigned kFields = 2 * dStateEnabled - 1;
constexpr int kAhead = 16;
constexpr unsigned kPose = dStatePosition | dStateQuaternion,
                   kVelocities = dStateLinearVel | dStateAngularVel;

// How many numbers a row has.
int width_of(unsigned fields)
{
    int width = fields & dStateEnabled ? 1 : 0;
    if (fields & dStateQuaternion) width += 4;
    for (const unsigned field :
         {dStatePosition, dStateLinearVel, dStateAngularVel, dStateForce, dStateTorque})
        if (fields & field) width += 3;
    return width;
}

// The number of reals from row to row, or 0: the arguments are bad.
int rows_apart(const void* bodies, int count, unsigned fields, const void* rows, int stride)
{
    if (count < 0 || (count > 0 && (!bodies || !rows)) || fields == 0 || (fields & ~kFields)) return 0;
    const int width = width_of(fields);
    if (stride == 0) return width;
    return stride >= width ? stride : 0;
}

// all_live has looked at the tag, whose cache line is not needed again.
Body* known(dBodyID body) { return from_judged_handle<Body>(body); }

bool all_live(const dBodyID* bodies, int count)
{
    for (int i = 0; i < count; ++i) {
        if (i + kAhead < count) prefetch<1>(bodies[i + kAhead]);
        if (!from_handle<Body>(bodies[i])) return false;
    }
    return true;
}

void copy(const Real (&from)[4], int count, Real*& to)
{
    std::memcpy(to, from, sizeof(Real) * std::size_t(count));
    to += count;
}

void get(const Body& body, unsigned fields, Real* to)
{
    if (fields & dStatePosition) copy(body.pos, 3, to);
    if (fields & dStateQuaternion) copy(body.q, 4, to);
    if (fields & dStateLinearVel) copy(body.lvel, 3, to);
    if (fields & dStateAngularVel) copy(body.avel, 3, to);
    if (fields & dStateForce) copy(body.facc, 3, to);
    if (fields & dStateTorque) copy(body.tacc, 3, to);
    if (fields & dStateEnabled) *to = body.disabled ? 0 : 1;
}

// The lines with the fields, from that of the position on: position and quaternion share the first, velocities and the force
// are in the third and fourth, the torque is in the fifth; the second has the rotation alone.
template <bool kHasPose, bool kHasMore>
void fetch(const dBodyID* bodies, int i, int count)
{
    if (i + kAhead >= count) return;
    const auto* first = reinterpret_cast<const char*>(known(bodies[i + kAhead])->pos);
    if constexpr (kHasPose) prefetch<1>(first);
    if constexpr (kHasMore) prefetch<2>(first + 2 * kCacheLine);
}

template <bool kHasPose, bool kHasMore>
void get_rows(const dBodyID* bodies, int count, unsigned fields, Real* out, std::ptrdiff_t apart)
{
    for (int i = 0; i < count; ++i, out += apart) {
        fetch<kHasPose, kHasMore>(bodies, i, count);
        get(*known(bodies[i]), fields, out);
    }
}

template <unsigned kKnown>
void get_known(const dBodyID* bodies, int count, Real* out, std::ptrdiff_t apart)
{
    get_rows<(kKnown & kPose) != 0, (kKnown & ~kPose) != 0>(bodies, count, kKnown, out, apart);
}

bool may_set(unsigned fields, const Real* from)
{
    if (!usable(from, width_of(fields))) return false;
    if (!(fields & dStateQuaternion)) return true;
    Quat q = load_quat(from + (fields & dStatePosition ? 3 : 0));
    return normalize(q);
}

void take(Real (&to)[4], const Real*& from)
{
    store(to, load(from));
    from += 3;
}

// The pose that a body has is no move, as in dBodySetPosition: nothing wakes.
void set_pose(Body& body, unsigned fields, const Real*& from)
{
    const Vec3 place = body.position();
    const Quat orientation = body.orientation();
    if (fields & dStatePosition) take(body.pos, from);
    if (fields & dStateQuaternion) {
        Quat q = load_quat(from);
        if (!(q == orientation)) {  // to normalise its own might change the last digit
            (void)normalize(q);
            set_orientation(body, q);
        }
        note_turned(body, orientation);
        from += 4;
    }
    const bool same = body.position() == place && body.orientation() == orientation;
    same ? body_stepped(body) : body_moved(body);
}

void set(Body& body, unsigned fields, const Real* from)
{
    if (fields & kPose) set_pose(body, fields, from);
    if (fields & dStateLinearVel) take(body.lvel, from);
    if (fields & dStateAngularVel) take(body.avel, from), body.spin_excess = {};
    if (fields & kVelocities) wake_if_driven(body);
    if (fields & dStateForce) take(body.facc, from);
    if (fields & dStateTorque) take(body.tacc, from);
    if (fields & (dStateForce | dStateTorque)) note_forces(body);
    if (fields & dStateEnabled) *from != 0 ? wake(body) : disable(body);
}

}  // namespace

extern "C" {

int dBodiesGetStates(const dBodyID* bodies, int count, unsigned fields, dReal* out, int stride)
{
    const int apart = rows_apart(bodies, count, fields, out, stride);
    EPODE_USER(apart > 0 && all_live(bodies, count), 0);
    switch (fields) {
        case dStatePosition:
            get_known<dStatePosition>(bodies, count, out, apart);
            break;
        case dStateQuaternion:
            get_known<dStateQuaternion>(bodies, count, out, apart);
            break;
        case kPose:
            get_known<kPose>(bodies, count, out, apart);
            break;
        case kVelocities:
            get_known<kVelocities>(bodies, count, out, apart);
            break;
        case kPose | kVelocities:
            get_known<kPose | kVelocities>(bodies, count, out, apart);
            break;
        default:
            get_rows<true, true>(bodies, count, fields, out, apart);
    }
    return 1;
}

int dBodiesSetStates(const dBodyID* bodies, int count, unsigned fields, const dReal* in, int stride)
{
    const FloatEnvironment floats;
    const int apart = rows_apart(bodies, count, fields, in, stride);
    EPODE_USER(apart > 0 && all_live(bodies, count), 0);
    const bool moves = fields & (dStatePosition | dStateQuaternion);
    for (int i = 0; i < count; ++i) {
        const Body& body = *from_handle<Body>(bodies[i]);
        EPODE_USER(may_set(fields, in + std::ptrdiff_t(apart) * i), 0);
        EPODE_USER_SAY(!moves || !in_locked_space(body), "Invalid operation for locked space", 0);
    }
    for (int i = 0; i < count; ++i) {
        fetch<true, true>(bodies, i, count);
        set(*known(bodies[i]), fields, in + std::ptrdiff_t(apart) * i);
    }
    return 1;
}

int dWorldGetBodies(dWorldID w, dBodyID* bodies, int capacity)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world && capacity >= 0 && (bodies || capacity == 0), 0);
    int number = world->bodies.count();
    for (const Body& body : world->bodies)
        if (--number < capacity) bodies[number] = to_handle(&body);
    return world->bodies.count();
}

int dWorldGetJoints(dWorldID w, dJointID* joints, int capacity)
{
    const World* const world = from_handle<World>(w);
    EPODE_USER(world && capacity >= 0 && (joints || capacity == 0), 0);
    int number = world->joints.count();
    for (const Joint& joint : world->joints)
        if (--number < capacity) joints[number] = to_handle(&joint);
    return world->joints.count();
}

}  // extern "C"
