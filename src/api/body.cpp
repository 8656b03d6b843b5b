// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies: life, pose, velocity, mass, forces, frames, joints. What decides when they sleep, damp and turn is
// in body_rules.cpp.
#include "api/body_handle.h"
#include "base/float_environment.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "math/rotation.h"
#include "ode/ode.h"
#include "state/world_archive.h"
#include "step/common/link.h"
#include "step/step.h"

using namespace epode;

namespace {

Vec3 world_arm(const Body& body, Vec3 relative) { return body.rotation() * relative; }

// Force f and torque about the centre by an arm.
void push(Body& body, Vec3 f, Vec3 arm)
{
    store(body.facc, load(body.facc) + f);
    store(body.tacc, load(body.tacc) + cross(arm, f));
    note_forces(body);
}

void twist(Body& body, Vec3 t)
{
    store(body.tacc, load(body.tacc) + t);
    note_forces(body);
}

// Has a step of its world chosen what it does with its bodies, and not yet done it? From inside a contact filter, a
// collider or a threading function.
bool is_being_stepped(const Body& body)
{
    const StepState* const step = body.world->step_state;
    return is_busy(*body.world) && step && step->underway.memory && !step->underway.made;
}

constexpr const char* kDuringStep = "a body cannot become kinematic or dynamic while its world is stepped";

}  // namespace

extern "C" {

dBodyID dBodyCreate(dWorldID w)
{
    World* world = from_handle<World>(w);
    EPODE_USER(world, nullptr);
    const Body* body = create_body(*world);
    EPODE_USER_SAY(body, kOutOfMemory, nullptr);
    return to_handle(body);
}

void dBodyDestroy(dBodyID b)
{
    BODY_OR();
    EPODE_USER_SAY(!is_busy(*body->world), busy_text(*body->world));
    if (keep_for_history(*body)) return;
    release_geoms(*body);
    destroy_body(*body);
}

dWorldID dBodyGetWorld(dBodyID b)
{
    BODY_OR(nullptr);
    return to_handle(body->world);
}

void dBodySetData(dBodyID b, void* data)
{
    BODY_OR();
    body->data = data;
}

void* dBodyGetData(dBodyID b)
{
    BODY_OR(nullptr);
    return body->data;
}

// ---- pose and velocity ----

void dBodySetPosition(dBodyID b, dReal x, dReal y, dReal z)
{
    BODY_OR();
    USABLE3(x, y, z);
    EPODE_USER_SAY(!in_locked_space(*body), "Invalid operation for locked space");
    place_body(*body, {x, y, z});
}

void dBodySetRotation(dBodyID b, const dMatrix3 R)
{
    BODY_OR();
    EPODE_USER(R && fits(*body, usable(R, 3) && usable(R + 4, 3) && usable(R + 8, 3)));
    Mat3 clean = load_mat(R);
    EPODE_USER(orthonormalize(clean));
    EPODE_USER_SAY(!in_locked_space(*body), "Invalid operation for locked space");
    Quat q = to_quat(clean);
    normalize(q);
    orient_body(*body, q, clean);
}

void dBodySetQuaternion(dBodyID b, const dQuaternion q)
{
    BODY_OR();
    EPODE_USER(q && fits(*body, usable(q, 4)));
    Quat unit = load_quat(q);
    EPODE_USER(unit == body->orientation() || normalize(unit));
    EPODE_USER_SAY(!in_locked_space(*body), "Invalid operation for locked space");
    orient_body(*body, unit, to_matrix(unit));
}

// A vector of the body, and what else setting it means.
#define BODY_VECTOR(Name, member, ...)                        \
    void dBodySet##Name(dBodyID b, dReal x, dReal y, dReal z) \
    {                                                         \
        BODY_OR();                                            \
        USABLE3(x, y, z);                                     \
        store(body->member, {x, y, z});                       \
        __VA_ARGS__;                                          \
    }                                                         \
    const dReal* dBodyGet##Name(dBodyID b)                    \
    {                                                         \
        BODY_OR(nullptr);                                     \
        return body->member;                                  \
    }

BODY_VECTOR(LinearVel, lvel, wake_if_driven(*body))
BODY_VECTOR(AngularVel, avel, body->spin_excess = Vec3(), wake_if_driven(*body))
BODY_VECTOR(Force, facc, note_forces(*body))
BODY_VECTOR(Torque, tacc, note_forces(*body))

const dReal* dBodyGetPosition(dBodyID b)
{
    BODY_OR(nullptr);
    return body->pos;
}

const dReal* dBodyGetRotation(dBodyID b)
{
    BODY_OR(nullptr);
    return body->R;
}

const dReal* dBodyGetQuaternion(dBodyID b)
{
    BODY_OR(nullptr);
    return body->q;
}

void dBodyCopyPosition(dBodyID b, dVector3 pos)
{
    BODY_OR();
    EPODE_USER(pos);
    store(pos, body->position());
}

void dBodyCopyRotation(dBodyID b, dMatrix3 R)
{
    BODY_OR();
    EPODE_USER(R);
    store_mat(R, body->rotation());
}

void dBodyCopyQuaternion(dBodyID b, dQuaternion q)
{
    BODY_OR();
    EPODE_USER(q);
    store_quat(q, body->orientation());
}

// ---- mass ----

void dBodySetMass(dBodyID b, const dMass* mass)
{
    const FloatEnvironment floats;
    BODY_OR();
    EPODE_USER(mass);
    EPODE_USER_SAY(!body->kinematic() || !is_being_stepped(*body), kDuringStep);
    EPODE_USER_SAY(max_component(abs(load(mass->c))) <= kEpsilon, "The centre of mass must be at the origin");
    EPODE_USER_SAY(set_mass(*body, *mass), "The mass must be positive and its inertia positive definite");
}

void dBodyGetMass(dBodyID b, dMass* mass)
{
    BODY_OR();
    EPODE_USER(mass);
    *mass = body->mass;
}

void dBodySetDynamic(dBodyID b)
{
    BODY_OR();
    EPODE_USER_SAY(!is_being_stepped(*body), kDuringStep);
    set_dynamic(*body);
    wake_sleeper(*body);
}

void dBodySetKinematic(dBodyID b)
{
    BODY_OR();
    EPODE_USER_SAY(!is_being_stepped(*body), kDuringStep);
    set_kinematic(*body);
    wake_sleeper(*body);
}

int dBodyIsKinematic(dBodyID b)
{
    BODY_OR(0);
    return body->kinematic();
}

// ---- forces ----

void dBodyAddForce(dBodyID b, dReal fx, dReal fy, dReal fz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    push(*body, {fx, fy, fz}, {});
}

void dBodyAddTorque(dBodyID b, dReal fx, dReal fy, dReal fz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    twist(*body, {fx, fy, fz});
}

void dBodyAddRelForce(dBodyID b, dReal fx, dReal fy, dReal fz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    push(*body, world_arm(*body, {fx, fy, fz}), {});
}

void dBodyAddRelTorque(dBodyID b, dReal fx, dReal fy, dReal fz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    twist(*body, world_arm(*body, {fx, fy, fz}));
}

void dBodyAddForceAtPos(dBodyID b, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    USABLE3(px, py, pz);
    push(*body, {fx, fy, fz}, Vec3{px, py, pz} - body->position());
}

void dBodyAddForceAtRelPos(dBodyID b, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    USABLE3(px, py, pz);
    push(*body, {fx, fy, fz}, world_arm(*body, {px, py, pz}));
}

void dBodyAddRelForceAtPos(dBodyID b, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    USABLE3(px, py, pz);
    push(*body, world_arm(*body, {fx, fy, fz}), Vec3{px, py, pz} - body->position());
}

void dBodyAddRelForceAtRelPos(dBodyID b, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz)
{
    BODY_OR();
    USABLE3(fx, fy, fz);
    USABLE3(px, py, pz);
    push(*body, world_arm(*body, {fx, fy, fz}), world_arm(*body, {px, py, pz}));
}

// ---- frames ----

#define BODY_TRANSFORM(Name, expression)                                       \
    void dBody##Name(dBodyID b, dReal px, dReal py, dReal pz, dVector3 result) \
    {                                                                          \
        BODY_OR();                                                             \
        EPODE_USER(result);                                                    \
        USABLE3(px, py, pz);                                                   \
        const Vec3 p{px, py, pz};                                              \
        store(result, expression);                                             \
    }

BODY_TRANSFORM(GetRelPointPos, body->pose().to_world(p))
BODY_TRANSFORM(GetRelPointVel, body->velocity() + cross(body->angular_velocity(), world_arm(*body, p)))
BODY_TRANSFORM(GetPointVel, body->point_velocity(p))
BODY_TRANSFORM(GetPosRelPoint, body->pose().to_local(p))
BODY_TRANSFORM(VectorToWorld, world_arm(*body, p))
BODY_TRANSFORM(VectorFromWorld, transposed_times(body->rotation(), p))

// ---- joints ----

int dBodyGetNumJoints(dBodyID b)
{
    BODY_OR(0);
    int count = 0;
    for (JointNode* n = body->joints; n; n = n->next) ++count;
    return count;
}

dJointID dBodyGetJoint(dBodyID b, int index)
{
    BODY_OR(nullptr);
    JointNode* n = index < 0 ? nullptr : body->joints;
    for (int i = 0; n && i < index; ++i) n = n->next;
    return n ? to_handle(n->joint) : nullptr;
}

void dBodySetMovedCallback(dBodyID b, void (*callback)(dBodyID))
{
    BODY_OR();
    body->moved = callback, body->has_moved_callback = callback != nullptr;
}

}  // extern "C"
