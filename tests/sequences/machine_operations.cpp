// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Operations on impulses, fluids, vehicles, characters, functions of manifolds and joint coordinates. As in extension_operations.cpp the
// library's answer is taken.
#include "attempt.h"

namespace epode::sequences {

void Player::strike_body(Dice& dice)
{
    const double x = dice.between(-10, 10), y = dice.between(-10, 10), z = dice.between(-10, 10);
    if (Geom* space = dice.chance(20) ? any_space(dice) : nullptr) {
        TRY(blast, AsSpace{space}, x / 5, y / 5, z, dice.below(3), dice.below(2));
        return;
    }
    Body* body = any(model.bodies.living(), dice);
    if (body) TRY(strike, body, dice.below(6), x, y, z);
}

void Player::wet_world(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    Geom* volume = dice.chance(70) ? any_shape(dice) : nullptr;
    if (world) TRY(pour, world, dice.below(6), dice.between(-1, 1), volume);
}

void Player::drive_body(Dice& dice)
{
    Body* body = any(model.bodies.living(), dice);
    if (!body) return;
    body->world->plain = false;  // wheels tie it to what they stand on
    TRY(drive_vehicle, body, dice.below(4), dice.between(-1, 1), dice.between(-1, 1),
        dice.between(0.001, 0.02));
    learn(*body->world);
}

void Player::walk_through(Dice& dice)
{
    Geom* space = any_space(dice);
    if (!space) return;
    if (TRY(stroll, AsSpace{space}, dice.between(-2, 2), dice.between(-2, 2), dice.between(0.001, 0.03),
            dice.below(3)) < 0)
        fail("o[%d]: a character is at no place", space->number);
}

void Player::shape_contacts(Dice& dice)
{
    World* world = any(model.worlds.living(), dice);
    if (!world) return;
    if (dice.chance(40)) {
        ATTEMPT(true, dWorldSetJointCoordinates, world, dice.below(2));
    } else {
        TRY(look_at_manifolds, world, dice.below(2), dice.below(2));
        world->filtered = true;  // a file has no functions
    }
}

}  // namespace epode::sequences
