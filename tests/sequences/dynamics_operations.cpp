// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Operations on worlds, bodies, joints and groups.
#include "attempt.h"

namespace epode::sequences {
namespace {

constexpr std::size_t kMostWorlds = 3, kMostBodies = 40, kMostJoints = 80, kMostGroups = 4;

// Where moved callbacks go: bodies carry no pointer to the player.
Player* g_player = nullptr;

void moved_c(dBodyID) { g_player->moved(); }

}  // namespace

#define CREATED(Name) dJointType##Name, "dJointCreate" #Name, dJointCreate##Name
#define SET_BY(Name, what) "dJointSet" #Name #what
// A type with parameters and three vectors in world coordinates.
#define VECTORS(Name, A, B, C, needs_two)                                           \
    {                                                                               \
        CREATED(Name), SET_BY(Name, Param), dJointSet##Name##Param,                 \
            {SET_BY(Name, A), SET_BY(Name, B), SET_BY(Name, C)},                    \
            {dJointSet##Name##A, dJointSet##Name##B, dJointSet##Name##C}, needs_two \
    }
#define PLAIN(Name)                                    \
    {                                                  \
        CREATED(Name), nullptr, nullptr, {}, {}, false \
    }

const JointKind kJointKinds[] = {
    VECTORS(Ball, Anchor, Anchor, Anchor2, false),
    VECTORS(Hinge, Anchor, Axis, Axis, false),
    VECTORS(Slider, Axis, Axis, Axis, false),
    VECTORS(Universal, Anchor, Axis1, Axis2, false),
    VECTORS(Hinge2, Anchor, Anchor, Anchor, true),
    VECTORS(PR, Anchor, Axis1, Axis2, false),
    VECTORS(PU, Anchor, Axis1, Axis3, false),
    VECTORS(Piston, Anchor, Axis, Axis, false),
    VECTORS(DBall, Anchor1, Anchor2, Anchor1, false),
    VECTORS(DHinge, Anchor1, Anchor2, Axis, false),
    VECTORS(Transmission, Axis, Axis1, Axis2, true),
    PLAIN(Fixed),
    PLAIN(AMotor),
    PLAIN(LMotor),
    PLAIN(Plane2D),
    PLAIN(Null),
    PLAIN(Coupling),
};
const int kJointKindCount = int(std::size(kJointKinds));

// ---- worlds ----

void Player::create_world(Dice&)
{
    if (model.worlds.living().size() >= kMostWorlds) return;
    const dWorldID id = script.make("w", model.worlds.made(), "", "dWorldCreate", dWorldCreate);
    if (!id) return fail("no world");
    World& world = model.worlds.add(id);
    CALL(dWorldSetGravity, &world, 0.0, 0.0, -9.81);
    CALL(dWorldSetStepReportMode, &world, 1);
}

void Player::destroy_world(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world) return;
    if (ATTEMPT(true, dWorldDestroy, world)) model.kill(*world);
}

void Player::tune_world(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world) return;
    switch (dice.below(18)) {
        case 0:
            ATTEMPT(true, dWorldSetERP, world, dice.between(0, 1));
            break;
        case 1:
            ATTEMPT(true, dWorldSetCFM, world, dice.between(0, 0.01));
            break;
        case 2:
            ATTEMPT(true, dWorldSetAutoDisableFlag, world, dice.below(2));
            break;
        case 3:
            ATTEMPT(true, dWorldSetLinearDamping, world, dice.between(0, 0.1));
            break;
        case 4:
            ATTEMPT(true, dWorldSetAngularDamping, world, dice.between(0, 0.1));
            break;
        case 5:
            ATTEMPT(true, dWorldSetQuickStepNumIterations, world, dice.below(30));
            break;
        case 6:
            ATTEMPT(true, dWorldSetStepThreads, world, 1 + dice.below(3));
            break;
        case 7:
            ATTEMPT(true, dWorldSetExactSubsteps, world, 1 + dice.below(3));
            break;
        case 8:
            ATTEMPT(true, dWorldSetStepProjection, world, dice.below(3));
            break;
        case 9:
            ATTEMPT(true, dWorldSetExactRotation, world, dice.below(2));
            break;
        case 10:
            ATTEMPT(true, dWorldSetStepReportMode, world, dice.below(2));
            break;
        case 11:
            ATTEMPT(true, dWorldSetMaxAngularSpeed, world, dice.between(1, 100));
            break;
        case 12:
            ATTEMPT(true, dWorldSetContactMaxCorrectingVel, world, dice.between(0.1, 10));
            break;
        case 13:
            ATTEMPT(true, dWorldSetStepWarmStarting, world, dice.between(0, 1));
            break;
        case 14:
            ATTEMPT(true, dWorldSetAutoDisableAverageSamplesCount, world, unsigned(dice.below(20)));
            break;
        case 15:
            ATTEMPT(true, dWorldSetFrictionCone, world, dice.below(2));
            break;
        case 16:
            ATTEMPT(true, dWorldSetManifoldFriction, world, dice.below(2));
            break;
        default:
            ATTEMPT(false, dWorldSetERP, world, 1e300 * 1e300);
            break;
    }
}

// ---- bodies ----

void Player::create_body(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world || model.bodies.living().size() >= kMostBodies) return;
    const dBodyID id = script.make("b", model.bodies.made(), "", "dBodyCreate", dBodyCreate, world);
    if (!id) return fail("no body");
    Body& body = model.born_body(id, *world);
    CALL(dBodySetPosition, &body, dice.between(-2, 2), dice.between(-2, 2), dice.between(0, 3));
    CALL(set_mass, &body, dice.between(0.1, 10), dice.between(0.1, 1), dice.between(0.1, 1), 0.5);
}

void Player::destroy_body(Dice& dice)
{
    Body* body = any(model.bodies.living(), dice);
    if (!body) return;
    if (ATTEMPT(true, dBodyDestroy, body)) model.kill(*body);
}

void Player::place_body(Dice& dice)
{
    Body* body = any(model.bodies.living(), dice);
    if (!body) return;
    const double x = dice.between(-2, 2), y = dice.between(-2, 2), z = dice.between(-0.5, 3);
    switch (dice.below(4)) {
        case 0:
            ATTEMPT(true, dBodySetPosition, body, x, y, z);
            break;
        case 1: {
            const Four q{{dReal(x), dReal(y), dReal(z), dReal(0.3)}};
            ATTEMPT(true, dBodySetQuaternion, body, q);
            break;
        }
        case 2: {
            dMatrix3 R;
            dRFromEulerAngles(R, dReal(x), dReal(y), dReal(z));
            Four m;
            std::copy(R, R + 12, m.v);
            m.count = 12;
            ATTEMPT(true, dBodySetRotation, body, m);
            break;
        }
        default:
            ATTEMPT(false, dBodySetPosition, body, x, 1e300 * 1e300, z);
            break;
    }
}

void Player::push_body(Dice& dice)
{
    Body* body = any(model.bodies.living(), dice);
    if (!body) return;
    const double size = dice.chance(2) ? 1e9 : 10;
    const double x = dice.between(-size, size), y = dice.between(-size, size), z = dice.between(-size, size);
    switch (dice.below(8)) {
        case 0:
            ATTEMPT(true, dBodyAddForce, body, x, y, z);
            break;
        case 1:
            ATTEMPT(true, dBodyAddTorque, body, x, y, z);
            break;
        case 2:
            ATTEMPT(true, dBodyAddRelForceAtRelPos, body, x, y, z, 0.1, 0.2, 0.3);
            break;
        case 3:
            ATTEMPT(true, dBodySetLinearVel, body, x, y, z);
            break;
        case 4:
            ATTEMPT(true, dBodySetAngularVel, body, x, y, z);
            break;
        case 5:
            ATTEMPT(true, dBodySetForce, body, x, y, z);
            break;
        case 6:
            ATTEMPT(true, dBodyAddForceAtPos, body, x, y, z, 1.0, 0.0, 0.0);
            break;
        default:
            ATTEMPT(true, dBodySetTorque, body, x, y, z);
            break;
    }
}

void Player::tune_body(Dice& dice)
{
    Body* body = any(model.bodies.living(), dice);
    if (!body) return;
    switch (dice.below(12)) {
        case 0:
            if (ATTEMPT(true, dBodySetKinematic, body)) body->kinematic = true;
            break;
        case 1:
        case 2:
            if (ATTEMPT(true, dBodySetDynamic, body)) body->kinematic = false;
            break;
        case 3:
            ATTEMPT(true, dBodySetGravityMode, body, dice.below(2));
            break;
        case 4:
            ATTEMPT(true, dBodySetGyroscopicMode, body, dice.below(2));
            break;
        case 5:
            ATTEMPT(true, dBodySetFiniteRotationMode, body, dice.below(2));
            break;
        case 6:
            ATTEMPT(true, dBodySetFiniteRotationAxis, body, dice.between(-1, 1), 0.0, dice.between(-1, 1));
            break;
        case 7:
            if (ATTEMPT(true, set_mass, body, dice.between(0.1, 100), 0.5, dice.between(0.1, 1), 0.5))
                body->kinematic = false;
            break;
        case 8:
            ATTEMPT(false, set_mass, body, -1.0, 1.0, 1.0, 1.0);
            break;
        case 9:
            ATTEMPT(true, dBodySetLinearDamping, body, dice.between(0, 0.2));
            break;
        case 10: {
            g_player = this;
            const bool on = dice.chance(60);
            const Named<void (*)(dBodyID)> callback{on ? "moved" : "0", on ? &moved_c : nullptr};
            ATTEMPT(true, dBodySetMovedCallback, body, callback);
            break;
        }
        default:
            ATTEMPT(true, dBodySetMaxAngularSpeed, body, dice.between(0.1, 50));
            break;
    }
}

void Player::sleep_body(Dice& dice)
{
    Body* body = any(model.bodies.living(), dice);
    if (!body) return;
    switch (dice.below(6)) {
        case 0:
            ATTEMPT(true, dBodyDisable, body);
            break;
        case 1:
            ATTEMPT(true, dBodyEnable, body);
            break;
        case 2:
            ATTEMPT(true, dBodySetAutoDisableFlag, body, dice.below(2));
            break;
        case 3:
            ATTEMPT(true, dBodySetAutoDisableSteps, body, dice.below(10));
            break;
        case 4:
            ATTEMPT(true, dBodySetAutoDisableAverageSamplesCount, body, unsigned(dice.below(30)));
            break;
        default:
            ATTEMPT(true, dBodySetAutoDisableDefaults, body);
            break;
    }
}

// ---- joints ----

void Player::create_joint(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world || model.joints.living().size() >= kMostJoints) return;
    Group* group = dice.chance(40) ? any(model.groups.living(), dice) : nullptr;
    const int kind = dice.below(kJointKindCount);
    const JointKind& k = kJointKinds[kind];
    const dJointID id = script.make("j", model.joints.made(), "", k.create_name, k.create, world, group);
    if (!id) return fail("no joint");
    Joint& joint = model.born_joint(id, *world, group, kind);
    if (world->bodies.empty() || k.type == dJointTypeCoupling) return;
    Body* a = any(world->bodies, dice);
    Body* b = any(world->bodies, dice);
    if (a == b) b = nullptr;
    if (k.needs_two && !b) return;
    if (ATTEMPT(true, dJointAttach, &joint, a, b)) model.attach(joint, a, b);
}

void Player::attach_joint(Dice& dice)
{
    Joint* joint = any(model.joints.living(), dice);
    if (!joint) return;
    Body* pair[2];
    for (Body*& body : pair) body = dice.chance(80) ? any(model.bodies.living(), dice) : nullptr;
    bool legal = !pair[0] || pair[0] != pair[1];
    for (Body* body : pair) legal = legal && (!body || body->world == joint->world);
    if (joint->kind >= 0 && kJointKinds[joint->kind].needs_two) legal = legal && !pair[0] == !pair[1];
    if (joint->kind >= 0 && kJointKinds[joint->kind].type == dJointTypeCoupling) legal = false;
    if (ATTEMPT(legal, dJointAttach, joint, pair[0], pair[1])) model.attach(*joint, pair[0], pair[1]);
}

void Player::tune_joint(Dice& dice)
{
    Joint* joint = any(model.joints.living(), dice);
    if (!joint) return;
    const JointKind* kind = joint->kind >= 0 ? &kJointKinds[joint->kind] : nullptr;
    const double x = dice.between(-1, 1), y = dice.between(-1, 1), z = dice.between(0.1, 1);
    const int before = script.refusals;
    switch (dice.below(5)) {
        case 0:
            if (ATTEMPT(true, dJointDisable, joint)) joint->disabled = true;
            break;
        case 1:
            if (ATTEMPT(true, dJointEnable, joint)) joint->disabled = false;
            break;
        case 2:
            // Parallel axes and the like may be refused: only the books are compared.
            if (const int p = dice.below(3); kind && kind->place[p])
                script.call(kind->place_name[p], kind->place[p], joint, x, y, z);
            break;
        default:
            if (kind && kind->set) {
                const int parameter = dice.below(dParamStopCFM + 1) + 0x100 * dice.below(3);
                script.call(kind->set_name, kind->set, joint, parameter, 3 * x);
            }
            break;
    }
    if (script.refusals != before) ++refused;
}

void Player::watch_joint(Dice& dice)
{
    Joint* joint = any(model.joints.living(), dice);
    if (joint) ATTEMPT(true, watch, joint, dice.below(kMaxFeedback + 1) - 1);
}

void Player::destroy_joint(Dice& dice)
{
    Joint* joint = any(model.joints.living(), dice);
    if (!joint) return;
    if (ATTEMPT(true, dJointDestroy, joint) && !joint->group) model.kill(*joint);
}

void Player::use_group(Dice& dice)
{
    Group* group = any(model.groups.living(), dice);
    if (!group || (dice.chance(20) && model.groups.living().size() < kMostGroups)) {
        const dJointGroupID id =
            script.make("g", model.groups.made(), "", "dJointGroupCreate", dJointGroupCreate, 0);
        if (!id) return fail("no group");
        model.groups.add(id);
    } else if (dice.chance(20)) {
        if (ATTEMPT(true, dJointGroupDestroy, group)) model.kill(*group);
    } else {
        if (ATTEMPT(true, dJointGroupEmpty, group)) model.empty(*group);
    }
}

// ---- steps ----

void Player::step(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world) return;
    static constexpr double kSizes[] = {0.001, 0.01, 0.02, 0.1};
    const double h = kSizes[dice.below(4)];
    Dice inner(dice.next());
    Dice* const outer = moved_dice_;
    moved_dice_ = &inner;
    const int before = script.refusals, free = freedom_;
    int made_it = 0;
    switch (dice.below(4)) {
        case 0:
            made_it = CALL(dWorldStep, world, h);
            break;
        case 1:
            made_it = CALL(dWorldStepHybrid, world, h);
            break;
        case 2:
            made_it = CALL(dWorldQuickStep, world, h);
            break;
        default:
            made_it = CALL(dWorldStepFast1, world, h, 1 + dice.below(6));
            break;
    }
    moved_dice_ = outer;
    if (!in_callback()) {
        if (script.refusals == before && !made_it) fail("a step was not made");
        if (freedom_ == free) check_islands(*world);
    }
    for (Joint* joint : world->joints)  // one that breaks has acted
        if (dJointIsBroken(joint->id)) joint->disabled = true;
}

}  // namespace epode::sequences
