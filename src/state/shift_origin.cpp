// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "state/shift_origin.h"

#include "base/objects/structure_edition.h"
#include "collide/character.h"
#include "collide/pose_hash.h"
#include "collide/types/registry.h"
#include "dynamics/forces/fluid.h"
#include "dynamics/forces/vehicle.h"
#include "state/world_archive.h"
#include "step/common/link.h"
#include "step/step.h"

namespace epode {
namespace {

// Of the space, at any depth, until visit() returns false; no spaces.
template <typename Visit>
bool each_geom(Space& space, Visit&& visit)
{
    for (Geom* geom : space.geoms) {
        if (!geom) continue;
        if (is_space(*geom) ? !each_geom(static_cast<Space&>(*geom), visit) : !visit(*geom)) return false;
    }
    return true;
}

bool can_be(Vec3 place) { return usable(place.x) && usable(place.y) && usable(place.z); }
bool is_plane(const Geom& geom) { return geom.type->number == dPlaneClass; }
Plane& plane_of(Geom& geom) { return static_cast<ShapeGeom<Plane>&>(geom).shape; }

class OriginShift {
  public:
    OriginShift(World& world, Space* space, Vec3 by) : world_(world), space_(space), by_(by) {}

    const char* fault() const
    {
        if (space_ && any_locked(*space_)) return "a space cannot move while it is being collided";
        for (const Body& body : world_.bodies)
            if (!can_be(body.position() + by_)) return kFar;
        for (const Joint& joint : world_.joints)
            if (joint.type->number == dJointTypePlane2D && by_.z != 0)
                return "a plane joint holds its body at z = 0 (accepted: offsets with z = 0)";
        const char* wrong = nullptr;
        if (space_) each_geom(*space_, [&](Geom& geom) { return !(wrong = fault_of(geom)); });
        return wrong;
    }

    void run()
    {
        for_wheels_on_ground([](VehicleWheel& wheel, Geom& ground) {
            if (wheel.ground_pose != pose_hash(ground))
                wheel.ground_pose = 0;  // it has moved: noticed by the next step
        });
        for (Body& body : world_.bodies) shift(body);
        for (Joint& joint : world_.joints)
            if (joint.type->shift) joint.type->shift(joint, by_);
        shift_volumes();
        if (space_)
            each_geom(*space_, [&](Geom& geom) {
                shift(geom);
                return true;
            });
        for (Fluid* fluid : world_.fluids) fluid->offset += dot(fluid->normal, by_);
        for_wheels_on_ground([](VehicleWheel& wheel, Geom& ground) {
            if (wheel.ground_pose != 0) wheel.ground_pose = pose_hash(ground);
        });
        if (StepState* const state = world_.step_state)
            state->world_contacts.shift(by_), state->events.shift(by_);
        note_structure_changed();  // planes, and points of joints, are part of it
    }

  private:
    static constexpr const char* kFar = "a coordinate would be no usable number (accepted: a smaller offset)";

    const char* fault_of(const Geom& geom) const
    {
        const Body* const body = body_of(geom);
        if (body && body->world != &world_) return "a geom in the space is on a body of another world";
        return can_be(load(geom.position) + by_) ? nullptr : kFar;
    }

    template <typename Use>
    void for_wheels_on_ground(Use&& use) const
    {
        for (Body& body : world_.bodies) {
            if (!body.vehicle) continue;
            for (VehicleWheel& wheel : body.vehicle->all_wheels())
                if (Geom* const ground = from_handle<Geom>(wheel.ground); ground && wheel.on_ground)
                    use(wheel, *ground);
        }
    }

    void shift(Body& body) const
    {
        store(body.pos, body.position() + by_);
        for (Stillness* window : {&body.short_window, &body.long_window}) window->position += by_;
        if (body.vehicle)
            for (VehicleWheel& wheel : body.vehicle->all_wheels()) wheel.ground_pos += by_;
        for_each_geom(body, [&](Geom& geom) {
            shift_character(geom);
            mark_stepped(geom);
        });
    }

    void shift_character(Geom& geom) const
    {
        if (Character* const character = geom.character)
            character->ground_pos += by_, character->ground_pose.p += by_;
    }

    // Of one that has no body; its shape moves if it has no place.
    void shift(Geom& geom) const
    {
        if (body_of(geom)) return;
        shift_character(geom);
        if (is_plane(geom)) {
            Plane& plane = plane_of(geom);
            plane.d += dot(plane.normal, by_), geom.hashed_changes = ~0u;
        } else if (geom.type->placeable) {
            store(geom.own_position, load(geom.own_position) + by_);
        }
        mark_stepped(geom);
    }

    // Volumes of fluids that are in no space.
    void shift_volumes() const
    {
        for (int i = 0; i < world_.fluids.size(); ++i) {
            Geom* const volume = volume_of(i);
            bool is_first = volume && !volume->space;
            for (int k = 0; k < i; ++k) is_first = is_first && volume_of(k) != volume;
            if (is_first) shift(*volume);
        }
    }
    Geom* volume_of(int i) const { return from_handle<Geom>(world_.fluids[i]->volume); }

    World& world_;
    Space* space_;
    Vec3 by_;
};

}  // namespace

const char* shift_origin(World& world, Space* space, Vec3 by)
{
    OriginShift shift(world, space, by);
    if (const char* const wrong = shift.fault()) return wrong;
    shift.run();
    if (History* const history = history_of(world)) {
        if (!history->set_frames(history->frames())) return kOutOfMemory;
    }
    return nullptr;
}

}  // namespace epode
