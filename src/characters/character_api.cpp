// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Characters as C functions.
#include "base/float_environment.h"
#include "base/objects/struct_size.h"
#include "characters/posture.h"
#include "characters/walk.h"
#include "collide/types/registry.h"
#include "math/rotation.h"
#include "query/candidates.h"

namespace epode {

template <>
inline constexpr std::size_t kSmallestSize<dCharacterSettings> = offsetof(dCharacterSettings, radius);
template <>
inline constexpr std::size_t kSmallestSize<dCharacterReport> = offsetof(dCharacterReport, velocity);

namespace {

constexpr Real kFastest = 1e4;

Geom* character_from(dGeomID id)
{
    Geom* const geom = from_handle<Geom>(id);
    return geom && geom->character ? geom : nullptr;
}

constexpr const char* kNoCharacter = "argument not a character";

// Null: the character may move; else why not.
const char* fault_of_move(const Geom& geom, const Vec3& velocity, Real h)
{
    if (!(usable(h) && h > 0 && h <= 1)) return "h (accepted: above 0, at most 1 s)";
    if (!(usable(velocity.x) && usable(velocity.y) && usable(velocity.z) && length(velocity) <= kFastest))
        return "velocity (accepted: at most 1e4 m/s)";
    if (!geom.space) return "the character is in no space";
    if (in_locked_space(geom)) return EPODE_LOCKED_TEXT;
    return geom.body.id ? "the character is on a body" : nullptr;
}

// Settings whose shape is the one that the character has.
bool same_shape(const dCharacterSettings& a, const dCharacterSettings& b)
{
    return a.shape == b.shape && a.radius == b.radius && a.height == b.height && load(a.up) == load(b.up);
}

dGeomID create_shape_for(dSpaceID space, const dCharacterSettings& s)
{
    if (s.shape == dBoxClass) return dCreateBox(space, 2 * s.radius, 2 * s.radius, s.height);
    if (s.shape == dCylinderClass) return dCreateCylinder(space, s.radius, s.height);
    return dCreateCapsule(space, s.radius, s.height - 2 * s.radius);
}

void set_upright(Geom& geom)
{
    const Vec3 up = geom.character->up;
    Mat3 R;
    if (up == Vec3{0, 0, 1} || !rotation_from_z_axis(up, R)) return;
    store_mat(geom.own_rotation, R);
}

dCharacterReport report_of(const Character& c)
{
    dCharacterReport out{};
    out.state = c.state;
    store(out.velocity, c.velocity);
    const bool lives = from_handle<Geom>(c.ground);
    out.ground = lives ? c.ground : nullptr;
    out.ground_side = lives ? c.ground_side : -1;
    store(out.ground_pos, c.ground_pos), store(out.ground_normal, c.ground_normal);
    store(out.ground_velocity, c.ground_velocity);
    out.turn = c.turn, out.climbed = c.climbed, out.overlap = c.overlap;
    out.hit_wall = c.hit_wall, out.hit_ceiling = c.hit_ceiling;
    return out;
}

}  // namespace
}  // namespace epode

#define EPODE_CHARACTER(geom, id, ...)                 \
    ::epode::Geom* geom = ::epode::character_from(id); \
    EPODE_USER_SAY(geom, ::epode::kNoCharacter __VA_OPT__(, ) __VA_ARGS__)

using namespace epode;

extern "C" int dCharacterSettingsInit(dCharacterSettings* settings, unsigned struct_size)
{
    EPODE_SIZED_AS(settings, struct_size, 0);
    copy_sized(kDefaultCharacter, settings, struct_size);
    return 1;
}

extern "C" dGeomID dCharacterCreate(dSpaceID space, const dCharacterSettings* settings)
{
    const FloatEnvironment floats;
    dCharacterSettings whole = kDefaultCharacter;
    if (settings) {
        EPODE_SIZED(settings, nullptr);
        whole = completed(*settings, kDefaultCharacter);
    }
    const char* const fault = fault_of(whole);
    EPODE_USER_SAY(!fault, fault, nullptr);
    EPODE_USER(space, nullptr);
    EPODE_PARENT_SPACE(space, nullptr);
    const dGeomID id = create_shape_for(space, whole);
    if (!id) return nullptr;
    Geom& geom = *from_handle<Geom>(id);
    if (!make_character(geom, whole)) {
        destroy_geom(geom);
        EPODE_USER_SAY(false, kOutOfMemory, nullptr);
    }
    set_upright(geom);
    put_foot(geom, {});
    return id;
}

extern "C" int dGeomIsCharacter(dGeomID id)
{
    EPODE_GEOM(geom, id, 0);
    return geom->character != nullptr;
}

extern "C" int dCharacterSetSettings(dGeomID id, const dCharacterSettings* settings)
{
    const FloatEnvironment floats;
    EPODE_CHARACTER(geom, id, 0);
    EPODE_SIZED(settings, 0);
    Character& c = *geom->character;
    const dCharacterSettings whole = completed(*settings, c.settings);
    const char* const fault = fault_of(whole);
    EPODE_USER_SAY(!fault, fault, 0);
    EPODE_USER_SAY(same_shape(whole, c.settings), "another shape, radius, height or up (accepted: its own)",
                   0);
    EPODE_UNLOCKED(geom, 0);
    const Vec3 foot = foot_of(*geom);
    const bool moves = whole.skin != c.settings.skin;
    c.settings = whole;
    if (moves) put_foot(*geom, foot);
    return 1;
}

extern "C" int dCharacterGetSettings(dGeomID id, dCharacterSettings* settings)
{
    EPODE_CHARACTER(geom, id, 0);
    EPODE_SIZED(settings, 0);
    copy_sized(geom->character->settings, settings, settings->struct_size);
    return 1;
}

extern "C" int dCharacterSetHeight(dGeomID id, dReal height)
{
    const FloatEnvironment floats;
    EPODE_CHARACTER(geom, id, 0);
    EPODE_USER_SAY(usable(height) && fits_height(geom->character->settings, height),
                   "height (accepted: above 0, at most 1e6 m; of a capsule at least 2 radius)", 0);
    EPODE_UNLOCKED(geom, 0);
    EPODE_USER_SAY(!geom->body.id, "the character is on a body", 0);
    if (geom->space) clean_while_held(*geom->space, *geom);
    return change_height(*geom, height);
}

extern "C" void dCharacterSetPosition(dGeomID id, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_CHARACTER(geom, id);
    EPODE_USER(usable(x) && usable(y) && usable(z));
    EPODE_UNLOCKED(geom);
    EPODE_USER_SAY(!geom->body.id, "the character is on a body");
    put_foot(*geom, {x, y, z});
    forget_ground(*geom->character);
}

extern "C" int dCharacterGetPosition(dGeomID id, dVector3 feet)
{
    const FloatEnvironment floats;
    EPODE_CHARACTER(geom, id, 0);
    EPODE_USER(feet, 0);
    refresh_pose(*geom);
    store(feet, foot_of(*geom));
    return 1;
}

extern "C" int dCharacterMove(dGeomID id, const dVector3 velocity, dReal h)
{
    const FloatEnvironment floats;
    EPODE_CHARACTER(geom, id, 0);
    EPODE_USER(velocity, 0);
    const char* const fault = fault_of_move(*geom, load(velocity), h);
    EPODE_USER_SAY(!fault, fault, 0);
    clean_while_held(*geom->space, *geom);
    EPODE_USER_SAY(move(*geom, load(velocity), h), kOutOfMemory, 0);
    return geom->character->state;
}

extern "C" int dCharacterWalk(dGeomID id, const dVector3 velocity, dReal jump_speed, dReal h)
{
    const FloatEnvironment floats;
    EPODE_CHARACTER(geom, id, 0);
    EPODE_USER(velocity, 0);
    EPODE_USER_SAY(usable(jump_speed) && jump_speed >= 0 && jump_speed <= kFastest,
                   "jump_speed (accepted: 0 ... 1e4 m/s)", 0);
    const char* const fault = fault_of_move(*geom, load(velocity), h);
    EPODE_USER_SAY(!fault, fault, 0);
    clean_while_held(*geom->space, *geom);
    EPODE_USER_SAY(walk(*geom, load(velocity), jump_speed, h), kOutOfMemory, 0);
    return geom->character->state;
}

extern "C" void dCharacterSetVelocity(dGeomID id, const dVector3 velocity)
{
    const FloatEnvironment floats;
    EPODE_CHARACTER(geom, id);
    EPODE_USER(velocity && usable(velocity, 3) && length(load(velocity)) <= kFastest);
    Character& c = *geom->character;
    c.velocity = c.momentum = load(velocity);
    c.inherited = {};
    c.launched = dot(c.velocity, c.up) > 0;
}

extern "C" int dCharacterGetVelocity(dGeomID id, dVector3 velocity)
{
    EPODE_CHARACTER(geom, id, 0);
    EPODE_USER(velocity, 0);
    store(velocity, geom->character->velocity);
    return 1;
}

extern "C" int dCharacterGetReport(dGeomID id, dCharacterReport* report)
{
    EPODE_CHARACTER(geom, id, 0);
    EPODE_SIZED(report, 0);
    const dCharacterReport now = report_of(*geom->character);
    copy_sized(now, report, report->struct_size);
    return 1;
}
