// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What makes a geom a character: its settings, and what one move leaves for the next (ode/character.h). It
// belongs to the geom and goes where the geom goes: states, histories, clones and files. How it moves is in
// src/characters, which knows bodies.
#pragma once

#include "collide/geom.h"
#include "ode/character.h"

namespace epode {

class StructureStream;
class StateStream;

struct Character {
    dCharacterSettings settings{};
    Vec3 up{0, 0, 1};  // unit

    // ---- what the last move has left ----
    Vec3 velocity;   // how it has really moved
    Vec3 momentum;   // of dCharacterWalk: the velocity that it takes into the air
    Vec3 inherited;  // in the air, of dCharacterWalk: of what it has jumped from, without the part along up
                     // on ground: the way that climbing has gone beyond what was asked for, m
    Vec3 ground_pos, ground_normal, ground_velocity;
    Pose ground_pose;  // of the ground's geom then
    Vec3 carried;      // by the ground
    Real turn = 0, climbed = 0, overlap = 0;
    dGeomID ground = nullptr;  // perhaps destroyed since
    int ground_side = -1;
    std::uint8_t state = 0;  // a dCharacterState
    bool hit_wall = false, hit_ceiling = false;
    bool launched = false;  // the program has given it a velocity that leads off the ground
};

extern const dCharacterSettings kDefaultCharacter;
// Null: good; else what is refused.
const char* fault_of(const dCharacterSettings& settings);

// Half the extent along its own z axis, and whether the shape can have a height.
Real half_height(const Geom& geom);
bool fits_height(const dCharacterSettings& settings, Real height);
void set_shape_height(Geom& geom, Real height);

// False: out of memory.
[[nodiscard]] bool make_character(Geom& geom, const dCharacterSettings& settings);
void drop_character(Geom& geom);

// Its part of a geom's structure, after the other parts.
void structure_of_character(Geom& geom, StructureStream& stream);
// And of a state: the height, and all that the last move has left but the ground's geom.
void state_of_character(Geom& geom, StateStream& stream);
// What distinguishes its shape where the height may change.
void add_shape_of_character(const Geom& geom, ContentHash& hash);

}  // namespace epode
