// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The rules that a body follows: enabling and auto-disabling, damping, speed caps, gravity, how it turns.
// Includes the names that the 0.039 guide gives to auto-disabling.
#include <cmath>

#include "api/body_handle.h"
#include "ode/ode.h"
#include "step/common/link.h"
#include "step/steppers/stepper.h"

using namespace epode;

namespace {

// A copy of the world's damping or sleeping rules, as a new body would get it.
bool take_sleep_rule(Body& body)
{
    const World& world = *body.world;
    if (!set_sleep_samples(body, world.sleep.samples)) return false;
    body.sleep = world.sleep;
    watch(body, world.auto_disable);
    if (!world.auto_disable) enable(body);
    return true;
}

}  // namespace

extern "C" {

// A number of the body with a condition on new values.
#define BODY_NUMBER(Type, Name, member, condition) \
    void dBodySet##Name(dBodyID b, Type value)     \
    {                                              \
        BODY_OR();                                 \
        EPODE_USER(condition);                     \
        body->member = value;                      \
    }                                              \
    Type dBodyGet##Name(dBodyID b)                 \
    {                                              \
        BODY_OR(0);                                \
        return body->member;                       \
    }

BODY_NUMBER(int, AutoDisableSteps, sleep.steps, true)
BODY_NUMBER(dReal, AutoDisableTime, sleep.time, usable_or_infinite(value))
BODY_NUMBER(int, HybridStepper, hybrid.requested, is_stepper(value))
BODY_NUMBER(dReal, LinearDamping, damping.linear_scale, usable(value))
BODY_NUMBER(dReal, AngularDamping, damping.angular_scale, usable(value))
BODY_NUMBER(dReal, MaxAngularSpeed, max_angular_speed, value >= 0)

// A threshold, kept squared.
#define BODY_THRESHOLD(Name, member)            \
    void dBodySet##Name(dBodyID b, dReal value) \
    {                                           \
        BODY_OR();                              \
        EPODE_USER(usable_or_infinite(value));  \
        body->member = value * value;           \
    }                                           \
    dReal dBodyGet##Name(dBodyID b)             \
    {                                           \
        BODY_OR(0);                             \
        return std::sqrt(body->member);         \
    }

BODY_THRESHOLD(AutoDisableLinearThreshold, sleep.linear_threshold2)
BODY_THRESHOLD(AutoDisableAngularThreshold, sleep.angular_threshold2)
BODY_THRESHOLD(LinearDampingThreshold, damping.linear_threshold2)
BODY_THRESHOLD(AngularDampingThreshold, damping.angular_threshold2)

// A yes or no.
#define BODY_SWITCH(Name, member)             \
    void dBodySet##Name(dBodyID b, int value) \
    {                                         \
        BODY_OR();                            \
        body->member = value != 0;            \
    }                                         \
    int dBodyGet##Name(dBodyID b)             \
    {                                         \
        BODY_OR(0);                           \
        return body->member;                  \
    }

BODY_SWITCH(GravityMode, gravity)
BODY_SWITCH(GyroscopicMode, gyroscopic)
BODY_SWITCH(FiniteRotationMode, finite_rotation)

void dBodyEnable(dBodyID b)
{
    BODY_OR();
    wake(*body);
}

void dBodyDisable(dBodyID b)
{
    BODY_OR();
    disable(*body);
}

int dBodyIsEnabled(dBodyID b)
{
    BODY_OR(0);
    return !body->disabled;
}

void dBodySetAutoDisableAverageSamplesCount(dBodyID b, unsigned int count)
{
    BODY_OR();
    EPODE_USER(count <= 1u << 20);
    EPODE_USER_SAY(set_sleep_samples(*body, int(count)), kOutOfMemory);
}

int dBodyGetAutoDisableAverageSamplesCount(dBodyID b)
{
    BODY_OR(0);
    return body->sleep.samples;
}

void dBodySetAutoDisableFlag(dBodyID b, int on)
{
    BODY_OR();
    EPODE_USER_SAY(set_auto_disable(*body, on != 0), kOutOfMemory);
}

int dBodyGetAutoDisableFlag(dBodyID b)
{
    BODY_OR(0);
    return body->auto_disable;
}

void dBodySetAutoDisableDefaults(dBodyID b)
{
    BODY_OR();
    EPODE_USER_SAY(take_sleep_rule(*body), kOutOfMemory);
}

void dBodySetDampingDefaults(dBodyID b)
{
    BODY_OR();
    body->damping = body->world->damping;
}

void dBodySetDamping(dBodyID b, dReal linear, dReal angular)
{
    BODY_OR();
    EPODE_USER(usable(linear) && usable(angular));
    body->damping.linear_scale = linear;
    body->damping.angular_scale = angular;
}

void dBodySetFiniteRotationAxis(dBodyID b, dReal x, dReal y, dReal z)
{
    BODY_OR();
    USABLE3(x, y, z);
    body->finite_axis = normalized_or({x, y, z}, {});
}

void dBodyGetFiniteRotationAxis(dBodyID b, dVector3 result)
{
    BODY_OR();
    EPODE_USER(result);
    store(result, body->finite_axis);
}

// ---- names of the 0.039 guide ----

void dBodySetAutoDisableThresholdSF1(dBodyID b, dReal threshold)
{
    BODY_OR();
    EPODE_USER(usable_or_infinite(threshold));
    body->sleep.linear_threshold2 = body->sleep.angular_threshold2 = threshold * threshold;
}

dReal dBodyGetAutoDisableThresholdSF1(dBodyID b)
{
    BODY_OR(0);
    return std::sqrt(body->sleep.linear_threshold2);
}

BODY_NUMBER(int, AutoDisableStepsSF1, sleep.steps, true)

void dBodySetAutoDisableSF1(dBodyID b, int on)
{
    BODY_OR();
    EPODE_USER_SAY(set_auto_disable(*body, on != 0), kOutOfMemory);
}

int dBodyGetAutoDisableSF1(dBodyID b)
{
    BODY_OR(0);
    return body->auto_disable;
}

}  // extern "C"
