// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "vehicles/update.h"

#include "collide/pose_hash.h"
#include "dynamics/world.h"
#include "query/candidates.h"
#include "step/common/link.h"
#include "vehicles/lean.h"
#include "vehicles/steering.h"
#include "vehicles/wheel_forces.h"

namespace epode {
namespace {

bool has_moved_under(const VehicleWheel& wheel)
{
    if (!wheel.on_ground) return false;
    Geom* const geom = from_handle<Geom>(wheel.ground);
    return !geom || pose_hash(*geom) != wheel.ground_pose;
}

// Finds all contacts. Functions of the program may be called: heights.
bool find_contacts(Body& body, Space& space, WheelContact* contacts)
{
    WheelCaster caster(body, space);
    if (!caster.collect()) return false;
    const bool called = may_call_program(caster.candidates().span(), QueryFilter{});
    const CandidateLock lock(called ? &space : nullptr, caster.candidates());
    const CopyMark mark(*body.world);
    for (int i = 0; i < body.vehicle->wheel_count; ++i) contacts[i] = caster.under(body.vehicle->wheels[i]);
    return true;
}

void remember_ground(VehicleWheel& wheel, const WheelContact& contact)
{
    wheel.ground = contact.geom ? to_handle(contact.geom) : nullptr;
    wheel.ground_side = contact.geom && contact.geom->type->number == dTriMeshClass ? contact.side : -1;
    wheel.ground_pos = contact.pos, wheel.ground_normal = contact.normal;
    wheel.ground_pose = contact.geom ? pose_hash(*contact.geom) : 0;
}

}  // namespace

bool keeps_sleeping(const Body& body)
{
    if (!body.disabled) return false;
    if (!body.auto_disable) return true;  // the program has disabled it
    const Vehicle& v = *body.vehicle;
    if (v.controls.throttle > 0 && v.gear != 0) return false;
    for (const VehicleWheel& wheel : v.all_wheels())
        if (has_moved_under(wheel)) return false;
    return true;
}

bool update_vehicle(Body& body, Space* space, Real h)
{
    if (keeps_sleeping(body)) return true;
    Vehicle& vehicle = *body.vehicle;
    WheelContact contacts[dVehicleMaxWheels];
    if (space && !find_contacts(body, *space, contacts)) return false;
    if (body.disabled) wake(body);
    steer(vehicle, h);
    change_gears(vehicle, h);
    WheelForces forces(body, h);
    for (int i = 0; i < vehicle.wheel_count; ++i) forces.stand(i, contacts[i]);
    if (vehicle.settings.kind == dVehicleBike) forces.add_lean(lean_moment(body, forces, h));
    forces.solve();
    forces.apply();
    for (int i = 0; i < vehicle.wheel_count; ++i) remember_ground(vehicle.wheels[i], contacts[i]);
    vehicle.speed = dot(body.velocity(), forces.frame().forward);
    vehicle.lean = lean_of(body, forces.frame());
    return true;
}

}  // namespace epode
