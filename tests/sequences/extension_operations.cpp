// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Operations on what ODE does not have: states, clones and files, world-managed contacts, drives, couplings, events,
// sensors, continuous geoms, queries, presets, many worlds at once. Whether a call is legal often follows from more than the
// model knows, so the library's answer is taken (TRY), and its promises about the answer are compared: a state that was taken is there,
// steps that were taken back leave nothing, what was saved can be loaded.
#include "attempt.h"

namespace epode::sequences {

// ---- states ----

// What a state changes of what the model knows.
void Player::learn(World& world)
{
    for (Body* body : world.bodies) body->kinematic = dBodyIsKinematic(body->id);
    for (Joint* joint : world.joints) joint->disabled = !dJointIsEnabled(joint->id);
}

void Player::use_states(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world) return;
    const int slot = dice.below(kStates), how = dice.below(4);
    const double h = dice.between(0.001, 0.03);
    const int freedom = freedom_;
    int result = 1;
    switch (dice.below(4)) {
        case 0:
            TRY(keep_state, world, slot);
            break;
        case 1:
            result = TRY(use_state, world, slot);
            break;
        case 2:
            result = TRY(go_by_delta, world, slot);
            break;
        default:
            // A history knows no contact joints: they go with the steps that are taken back.
            if (std::any_of(world->joints.begin(), world->joints.end(),
                            [](Joint* joint) { return joint->kind < 0; }))
                return;
            freedom_ = 0;  // what callbacks make would be taken back, too
            result = TRY(take_back, world, how, h, 1 + dice.below(4));
            freedom_ = freedom;
            break;
    }
    learn(*world);
    // A space that is being collided lets no state move its geoms.
    if (result < 0 && !(in_callback() && refused_last()))
        fail("w[%d]: a state is not what it was", world->number);
}

void Player::copy_world(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world) return;
    const AsSpace space{world->contacts && world->contacts->alive ? nullptr
                        : dice.chance(70)                         ? any_space(dice)
                                                                  : nullptr};
    const int freedom = freedom_;
    freedom_ = 0;  // the copy has the callbacks
    const int by_file = dice.below(2), result = TRY(step_copy, world, space, by_file, dice.below(4), 0.01);
    freedom_ = freedom;
    if (result == -1) fail("w[%d]: what was saved cannot be loaded", world->number);
    // A file has no filter, which remembers what it was asked.
    if (result == -2 && !(by_file && world->filtered))
        fail("w[%d]: its copy has another state", world->number);
}

// ---- worlds ----

void Player::extend_world(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world) return;
    switch (dice.below(9)) {
        case 0:
        case 1: {
            Geom* space = dice.chance(80) ? any_space(dice) : nullptr;
            if (TRY(dWorldSetContactSpace, world, AsSpace{space}); !refused_last())
                world->contacts = space, world->plain = false;
            break;
        }
        case 2:
            ATTEMPT(true, dWorldUseDefaults, world, dice.below(3));
            break;
        case 3:
            ATTEMPT(true, list_events, world, dice.below(64));
            break;
        case 4:
            TRY(read_lists, world);
            break;
        case 5:
            if (ATTEMPT(true, filter_contacts, world, dice.below(2))) world->filtered = true;
            break;
        case 6:
            ATTEMPT(true, dWorldSetHybridSubsteps, world, 1 + dice.below(6));
            break;
        case 7:
            ATTEMPT(true, dWorldSetEnergyLedgerMode, world, dice.below(2));
            break;
        default:
            ATTEMPT(true, dWorldSetDiagnosisMode, world, dice.below(2));
            break;
    }
}

void Player::step_worlds(Dice& dice)
{
    int count = 0;
    for (World* world : model.worlds.living()) CALL(choose, count++, world);
    if (count == 0) return;
    Dice inner(dice.next());
    Dice* const outer = moved_dice_;
    moved_dice_ = &inner;
    TRY(step_chosen, count, dice.between(0.001, 0.02), dice.below(5), 1 + dice.below(2), 1 + dice.below(3));
    moved_dice_ = outer;
    for (World* world : model.worlds.living()) learn(*world);
}

// ---- joints and geoms ----

void Player::extend_joint(Dice& dice)
{
    Joint* joint = any(model.joints.living(), dice);
    if (!joint) return;
    const int axis = dice.below(4) - 1;
    const double k = dice.chance(80) ? dice.between(0, 1e4) : 0, d = dice.between(0, 100),
                 x = dice.between(-3, 3);
    switch (dice.below(7)) {
        case 0:
        case 1:
            TRY(drive, joint, axis, k, d, x, dice.chance(50) ? 10 * d : 0);
            break;
        case 2:
            TRY(dJointSetSpring, joint, k, d);
            break;
        case 3:
            TRY(dJointSetStopSpring, joint, axis, k, d);
            break;
        case 4:
            TRY(dJointSetBreakLimits, joint, k, d);
            break;
        case 5:
            TRY(dJointSetAxisContinuous, joint, axis, dice.below(2));
            break;
        default:
            TRY(dJointSetAxisTurn, joint, axis, x);
            break;
    }
}

void Player::couple(Dice& dice)
{
    std::vector<Joint*> couplings;
    for (Joint* joint : model.joints.living())
        if (joint->kind >= 0 && kJointKinds[joint->kind].type == dJointTypeCoupling)
            couplings.push_back(joint);
    Joint* coupling = any(couplings, dice);
    Joint* joint = dice.chance(85) ? any(model.joints.living(), dice) : nullptr;
    if (!coupling) return;
    if (dice.chance(25)) {
        TRY(dJointSetCouplingParam, coupling, dice.chance(50) ? int(dParamLoStop) : int(dParamHiStop),
            dice.between(-2, 2));
        return;
    }
    if (coupling->world) coupling->world->plain = false;  // its joints' bodies are one island
    TRY(dJointSetCouplingAxis, coupling, dice.below(dMaxCouplingAxes + 1), joint, dice.below(3),
        dice.between(-2, 2));
}

void Player::extend_geom(Dice& dice)
{
    Geom* geom = any(model.geoms.living(), dice);
    if (!geom) return;
    switch (dice.below(3)) {
        case 0:
            TRY(dGeomSetSensor, geom, dice.below(2));
            break;
        case 1:
            TRY(dGeomSetContinuous, geom, dice.below(3));
            break;
        default:
            TRY(coat, geom, dice.between(0, 2), dice.between(0, 1), dice.chance(30) ? 1e-4 : 0);
            break;
    }
}

void Player::ask_space(Dice& dice)
{
    Geom *space = any_space(dice), *geom = any_shape(dice), *other = any(model.geoms.living(), dice);
    if (!space || !geom || !other) return;
    const AsSpace in{space};
    const int result = TRY(ask, in, geom, other, dice.below(7), dice.between(-3, 3), dice.between(-3, 3),
                           dice.between(-3, 3));
    if (result < 0)
        fail("o[%d], o[%d], o[%d]: answer %d is no number", space->number, geom->number, other->number,
             result);
}

}  // namespace epode::sequences
