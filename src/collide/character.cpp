// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Settings and memory of characters: checks, birth and death, bytes of states and files.
#include "collide/character.h"

#include <algorithm>
#include <new>

#include "base/check.h"
#include "base/memory.h"
#include "base/objects/structure_edition.h"
#include "base/streams/content_hash.h"
#include "base/streams/state_stream.h"
#include "base/streams/structure_stream.h"
#include "collide/space.h"

namespace epode {
namespace {

bool in_range(Real x, Real low, Real high) { return usable(x) && x >= low && x <= high; }

constexpr std::uint64_t kMark = 0x72616863;  // "char"
constexpr Real kFarthest = 1e6, kStrongest = 1e12;

const char* fault_of_size(const dCharacterSettings& s)
{
    if (s.shape != dCapsuleClass && s.shape != dCylinderClass && s.shape != dBoxClass)
        return "shape (accepted: dCapsuleClass, dCylinderClass, dBoxClass)";
    if (!in_range(s.radius, 0, kFarthest) || s.radius == 0)
        return "radius (accepted: above 0, at most 1e6 m)";
    if (!usable(s.height) || !fits_height(s, s.height))
        return "height (accepted: above 0, at most 1e6 m; of a capsule at least 2 radius)";
    if (!in_range(s.skin, 0, s.radius / 4) || s.skin == 0)
        return "skin (accepted: above 0, at most radius / 4)";
    Vec3 up = load(s.up);
    const bool direction = usable(up.x) && usable(up.y) && usable(up.z) && normalize(up);
    return direction ? nullptr : "up (accepted: finite, of any length but 0)";
}

void visit_numbers(Character& c, StructureStream& stream)
{
    dCharacterSettings& s = c.settings;
    stream.number(s.shape);
    stream.reals(s.up, 3);
    for (Real* number : {&s.radius, &s.height, &s.gravity, &s.skin, &s.slope_limit, &s.step_height,
                         &s.stick_distance, &s.mass, &s.max_force, &s.air_acceleration})
        stream.real(*number);
    stream.pointer(s.filter), stream.pointer(s.data);
}

template <typename Visit>
void each_vector(Character& c, Visit&& visit)
{
    for (Vec3* v :
         {&c.velocity, &c.momentum, &c.inherited, &c.ground_pos, &c.ground_normal, &c.ground_velocity,
          &c.carried, &c.ground_pose.p, &c.ground_pose.R.row0, &c.ground_pose.R.row1, &c.ground_pose.R.row2})
        visit(*v);
}

template <typename Shape>
Real& half_length(Geom& geom)
{
    return static_cast<ShapeGeom<Shape>&>(geom).shape.half_length;
}

}  // namespace

const dCharacterSettings kDefaultCharacter = {.struct_size = sizeof(dCharacterSettings),
                                              .shape = dCapsuleClass,
                                              .radius = Real(0.3),
                                              .height = Real(1.8),
                                              .up = {0, 0, 1},
                                              .gravity = Real(9.81),
                                              .skin = Real(0.01),
                                              .slope_limit = Real(0.87),
                                              .step_height = Real(0.3),
                                              .stick_distance = Real(0.3),
                                              .mass = 70,
                                              .max_force = 500,
                                              .air_acceleration = 10,
                                              .filter = nullptr,
                                              .data = nullptr};

const char* fault_of(const dCharacterSettings& s)
{
    if (const char* wrong = fault_of_size(s)) return wrong;
    if (!in_range(s.gravity, 0, kFarthest)) return "gravity (accepted: 0 ... 1e6 m/s^2)";
    if (!in_range(s.slope_limit, 0, Real(1.5))) return "slope_limit (accepted: 0 ... 1.5 rad)";
    if (!in_range(s.step_height, 0, kFarthest)) return "step_height (accepted: 0 ... 1e6 m)";
    if (!in_range(s.stick_distance, 0, kFarthest)) return "stick_distance (accepted: 0 ... 1e6 m)";
    if (!in_range(s.mass, 0, kStrongest)) return "mass (accepted: 0 ... 1e12 kg)";
    if (!in_range(s.max_force, 0, kStrongest)) return "max_force (accepted: 0 ... 1e12 N)";
    if (!in_range(s.air_acceleration, 0, kFarthest)) return "air_acceleration (accepted: 0 ... 1e6 m/s^2)";
    return nullptr;
}

Real half_height(const Geom& geom)
{
    auto& g = const_cast<Geom&>(geom);
    if (g.type->number == dBoxClass) return static_cast<ShapeGeom<Box>&>(g).shape.half.z;
    if (g.type->number == dCylinderClass) return half_length<Cylinder>(g);
    return half_length<Capsule>(g) + static_cast<ShapeGeom<Capsule>&>(g).shape.radius;
}

bool fits_height(const dCharacterSettings& settings, Real height)
{
    if (!(height > 0) || height > kFarthest) return false;
    return settings.shape != dCapsuleClass || height >= 2 * settings.radius;
}

void set_shape_height(Geom& geom, Real height)
{
    if (geom.type->number == dBoxClass)
        static_cast<ShapeGeom<Box>&>(geom).shape.half.z = height / 2;
    else if (geom.type->number == dCylinderClass)
        half_length<Cylinder>(geom) = height / 2;
    else
        half_length<Capsule>(geom) =
            std::max(height / 2 - static_cast<ShapeGeom<Capsule>&>(geom).shape.radius, Real(0));
}

bool make_character(Geom& geom, const dCharacterSettings& settings)
{
    void* const memory = allocate(sizeof(Character));
    if (!memory) return false;
    geom.character = new (memory) Character;
    geom.character->settings = settings;
    geom.character->up = normalized_or(load(settings.up), {0, 0, 1});
    mark_changed(geom);  // its shape has another hash
    note_rules_changed(geom);
    note_structure_changed();
    return true;
}

void drop_character(Geom& geom)
{
    if (geom.character) release(geom.character, sizeof(Character));
    geom.character = nullptr;
}

void structure_of_character(Geom& geom, StructureStream& stream)
{
    bool has = geom.character != nullptr;
    stream.flag(has);
    if (!has || stream.failed()) return;
    Character copy = geom.character ? *geom.character : Character{};
    visit_numbers(copy, stream);
    if (stream.saves() || stream.failed()) return;
    copy.settings.struct_size = sizeof(dCharacterSettings);
    const bool good = !fault_of(copy.settings) && geom.type->number == copy.settings.shape;
    if (!stream.demand(good, "a character in it has settings that it cannot have")) return;
    stream.demand(make_character(geom, copy.settings), kOutOfMemory);
}

void add_shape_of_character(const Geom& geom, ContentHash& hash)
{
    const dCharacterSettings& s = geom.character->settings;
    hash.add(kMark), hash.add(std::uint64_t(s.shape)), hash.add(&s.radius, 1);
}

void state_of_character(Geom& geom, StateStream& stream)
{
    Character c = *geom.character;
    {
        const StateStream::IntoCopies into(stream);
        stream.reals(&c.settings.height, 1);
        each_vector(c, [&](Vec3& v) { stream.reals(&v.x, 3); });
        stream.reals(&c.turn, 1), stream.reals(&c.climbed, 1), stream.reals(&c.overlap, 1);
    }
    const std::uint32_t bits =
        stream.word(std::uint32_t(c.state) | std::uint32_t(c.hit_wall) << 4 |
                    std::uint32_t(c.hit_ceiling) << 5 | std::uint32_t(c.launched) << 6);
    c.ground_side = int(stream.word(std::uint32_t(c.ground_side)));
    const bool good = bits < 128 && (bits & 15) <= dCharacterOnGround && !fault_of(c.settings);
    if (!stream.demand(good, "a character of the state has a state or a height that it cannot have")) return;
    c.state = std::uint8_t(bits & 15);
    c.hit_wall = bits >> 4 & 1, c.hit_ceiling = bits >> 5 & 1, c.launched = bits >> 6 & 1;
    if (!stream.stores()) return;
    if (c.settings.height != geom.character->settings.height) {
        set_shape_height(geom, c.settings.height);
        mark_changed(geom);
    }
    c.ground = geom.character->ground;
    *geom.character = c;
}

}  // namespace epode
