// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Hooks of the calls that change what a step computes from (record/file/calls.inc), and of two that a recording
// can only say to have been there. A geom that is put elsewhere takes its body along: told as what the body
// got.
#include "record/preload/real.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace {

using namespace epode::record;

Given given(dWorldID world, int) { return {Given::kWorld, world}; }
Given given(dBodyID body, int) { return {Given::kBody, body}; }
Given given(dJointID joint, int) { return {Given::kJoint, joint}; }
Given given(dReal number, int) { return {Given::kNumber, nullptr, double(number)}; }
Given given(int integer, int) { return {Given::kInteger, nullptr, 0, integer}; }
Given given(unsigned integer, int) { return {Given::kInteger, nullptr, 0, int(integer)}; }
Given given(const dReal* numbers, int count) { return {Given::kNumbers, nullptr, 0, 0, numbers, count}; }
Given given(const dMass* mass, int) { return {Given::kMass, nullptr, 0, 0, nullptr, 0, mass}; }

template <class... Arguments>
void called(const char* name, int count, Arguments... arguments)
{
    const Given all[] = {given(arguments, count)...};
    notify(&Observer::called, name, static_cast<const Given*>(all), int(sizeof...(arguments)));
}

// Where the body is now, after it was moved by its geom.
void body_was_moved(dGeomID geom)
{
    static const auto body_of = find<decltype(&dGeomGetBody)>("dGeomGetBody");
    static const auto position = find<decltype(&dBodyGetPosition)>("dBodyGetPosition");
    if (dBodyID body = body_of(geom)) {
        const dReal* at = position(body);
        called("dBodySetPosition", 0, body, at[0], at[1], at[2]);
    }
}

// Its rotation: as it was given where the geom sits on the body without offset, so that it comes out the same
// to the bit; else what the body has now.
void body_was_turned(dGeomID geom, const char* name, const dReal* turn, int count)
{
    static const auto body_of = find<decltype(&dGeomGetBody)>("dGeomGetBody");
    static const auto is_offset = find<decltype(&dGeomIsOffset)>("dGeomIsOffset");
    static const auto quaternion = find<decltype(&dBodyGetQuaternion)>("dBodyGetQuaternion");
    dBodyID body = body_of(geom);
    if (!body) return;
    if (is_offset(geom)) {
        called("dBodySetQuaternion", 4, body, quaternion(body));
    } else {
        called(name, count, body, turn);
    }
    body_was_moved(geom);
}

void beyond(const char* name) { notify(&Observer::called, name, static_cast<const Given*>(nullptr), 0); }

}  // namespace

#define EPODE_UNPACK(...) __VA_ARGS__
#define CALL(name, count, parameters, arguments)                     \
    void name parameters                                             \
    {                                                                \
        EPODE_REAL_VOID(name);                                       \
        const Outermost outermost;                                   \
        real arguments;                                              \
        change(#name " in a moved callback");                        \
        if (outermost) called(#name, count, EPODE_UNPACK arguments); \
    }

extern "C" {

#include "record/file/calls.inc"

void dGeomSetPosition(dGeomID geom, dReal x, dReal y, dReal z)
{
    EPODE_REAL_VOID(dGeomSetPosition);
    change("dGeomSetPosition in a moved callback");
    const Outermost outermost;
    real(geom, x, y, z);
    if (outermost) body_was_moved(geom);
}

void dGeomSetRotation(dGeomID geom, const dReal* turn)
{
    EPODE_REAL_VOID(dGeomSetRotation);
    change("dGeomSetRotation in a moved callback");
    const Outermost outermost;
    real(geom, turn);
    if (outermost) body_was_turned(geom, "dBodySetRotation", turn, 12);
}

void dGeomSetQuaternion(dGeomID geom, const dReal* turn)
{
    EPODE_REAL_VOID(dGeomSetQuaternion);
    change("dGeomSetQuaternion in a moved callback");
    const Outermost outermost;
    real(geom, turn);
    if (outermost) body_was_turned(geom, "dBodySetQuaternion", turn, 4);
}

void dWorldSetContactSpace(dWorldID world, dSpaceID space)
{
    EPODE_REAL_VOID(dWorldSetContactSpace);
    real(world, space);
    if (space) beyond("dWorldSetContactSpace");
}

void dGeomSetContinuous(dGeomID geom, int mode)
{
    EPODE_REAL_VOID(dGeomSetContinuous);
    real(geom, mode);
    if (mode) beyond("dGeomSetContinuous");
}

}  // extern "C"
