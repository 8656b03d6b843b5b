// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See recorder.h. Maps by address are only looked things up in, never walked: a recording does not depend on
// where the library put its objects.
#include "record/watch/recorder.h"

#include <algorithm>

#include "record/file/hash.h"
#include "record/watch/joints.h"
#include "record/watch/limits.h"
#include "record/watch/shapes.h"

namespace epode::record {

namespace {

template <size_t n>
void copy(std::array<double, n>& to, const dReal* from)
{
    for (size_t i = 0; i < n; ++i) to[i] = double(from[i]);
}

std::array<dBodyID, 2> bodies_of(dJointID joint)
{
    return {dJointGetBody(joint, 0), dJointGetBody(joint, 1)};
}

}  // namespace

BodyState state_of(dBodyID body)
{
    BodyState state;
    copy(state.pose.pos, dBodyGetPosition(body));
    copy(state.pose.turn, dBodyGetQuaternion(body));
    copy(state.linear, dBodyGetLinearVel(body));
    copy(state.angular, dBodyGetAngularVel(body));
    return state;
}

template <class Id>
void Recorder::Numbers<Id>::add(Id id)
{
    number[id] = next++;
    living.push_back(id);
}

template <class Id>
bool Recorder::Numbers<Id>::remove(Id id, std::uint32_t& was)
{
    const auto found = number.find(id);
    if (found == number.end()) return false;
    was = found->second;
    number.erase(found);
    living.erase(std::find(living.begin(), living.end(), id));
    return true;
}

std::int32_t Recorder::number_of(dBodyID body) const
{
    const auto found = bodies_.number.find(body);
    return found == bodies_.number.end() ? kNobody : std::int32_t(found->second);
}

std::uint32_t Recorder::number_of(dGeomID geom) const
{
    const auto found = geoms_.number.find(geom);
    return found == geoms_.number.end() ? kNoGeom : found->second;
}

void Recorder::add(dBodyID body)
{
    if (bodies_.number.contains(body)) return;
    dMass mass;
    dBodyGetMass(body, &mass);
    sink_.body({double(mass.mass), dBodyIsKinematic(body) != 0});
    bodies_.add(body);
}

std::uint32_t Recorder::shape_number(dGeomID geom)
{
    const bool is_mesh = dGeomGetClass(geom) == dTriMeshClass;
    dTriMeshDataID data = is_mesh ? dGeomTriMeshGetTriMeshDataID(geom) : nullptr;
    if (is_mesh) {
        const auto known = mesh_shapes_.find(data);
        if (known != mesh_shapes_.end()) return known->second;
    }
    const Shape shape = shape_of(geom);
    const auto key = std::make_pair(std::uint32_t(shape.kind), shape.size);
    const bool simple = shape.kind != ShapeKind::kUnknown && shape.kind < ShapeKind::kConvex;
    if (simple) {
        const auto known = simple_shapes_.find(key);
        if (known != simple_shapes_.end()) return known->second;
        simple_shapes_[key] = next_shape_;
    }
    if (is_mesh) mesh_shapes_[data] = next_shape_;
    sink_.shape(shape);
    return next_shape_++;
}

void Recorder::add(dGeomID geom)
{
    if (geoms_.number.contains(geom) || dGeomIsSpace(geom)) return;
    Geom out;
    out.shape = shape_number(geom);
    out.body = number_of(dGeomGetBody(geom));
    out.pose = pose_of(geom);
    sink_.geom(out);
    geoms_.add(geom);
    places_[geom] = place_of(geom);
}

void Recorder::send_joint(dJointID joint)
{
    Joint out = joint_of(joint);
    attached_[joint] = bodies_of(joint);
    for (size_t i = 0; i < 2; ++i) out.body[i] = number_of(attached_[joint][i]);
    sink_.joint(out);
    joints_.add(joint);
}

void Recorder::add(dJointID joint)
{
    if (!joints_.number.contains(joint)) send_joint(joint);
}

void Recorder::remove(dBodyID body)
{
    std::uint32_t number = 0;
    if (bodies_.remove(body, number)) sink_.gone(ObjectKind::kBody, number);
}

void Recorder::remove(dGeomID geom)
{
    std::uint32_t number = 0;
    if (!geoms_.remove(geom, number)) return;
    places_.erase(geom);
    sink_.gone(ObjectKind::kGeom, number);
}

void Recorder::remove(dJointID joint)
{
    std::uint32_t number = 0;
    if (!joints_.remove(joint, number)) return;
    attached_.erase(joint);
    sink_.gone(ObjectKind::kJoint, number);
}

Recorder::Place Recorder::place_of(dGeomID geom)
{
    Place place;
    place.body = dGeomGetBody(geom);
    const bool offset = place.body && dGeomIsOffset(geom);
    if (dGeomGetClass(geom) == dPlaneClass || (place.body && !offset)) return place;
    std::copy_n(offset ? dGeomGetOffsetPosition(geom) : dGeomGetPosition(geom), 3, place.pos);
    std::copy_n(offset ? dGeomGetOffsetRotation(geom) : dGeomGetRotation(geom), 12, place.rot);
    return place;
}

void Recorder::send_moves()
{
    for (dGeomID geom : geoms_.living) {
        const Place now = place_of(geom);
        Place& before = places_[geom];
        if (now == before) continue;
        before = now;
        sink_.moved(number_of(geom), number_of(now.body), pose_of(geom));
    }
    // A joint that was attached to other bodies is another joint.
    const std::vector<dJointID> joints = joints_.living;
    for (dJointID joint : joints) {
        if (attached_[joint] == bodies_of(joint)) continue;
        remove(joint);
        send_joint(joint);
    }
}

void Recorder::step(const StepFigures& figures, const std::vector<ContactSeen>& contacts, bool with_forces)
{
    send_moves();
    step_.time = figures.time;
    step_.dt = figures.dt;
    step_.kinetic = figures.kinetic;
    step_.potential = figures.potential;
    step_.joint_error = figures.joint_error;
    step_.ms = figures.ms;
    step_.has_forces = with_forces;
    step_.bodies.clear();
    step_.asleep.clear();
    for (dBodyID body : bodies_.living) {
        step_.bodies.push_back(state_of(body));
        step_.asleep.push_back(dBodyIsEnabled(body) ? 0 : 1);
    }
    step_.hash = hash_states(step_.bodies);
    step_.limits.clear();
    for (dJointID joint : joints_.living) add_limits(joint, joints_.number[joint], step_.limits);
    step_.contacts.clear();
    // Contacts of one pair come one after the other.
    dGeomID last[2] = {nullptr, nullptr};
    std::uint32_t number[2] = {kNoGeom, kNoGeom};
    step_.contacts.reserve(contacts.size());
    for (const ContactSeen& seen : contacts) {
        Contact contact;
        for (size_t i = 0; i < 2; ++i) {
            if (seen.geom[i] != last[i]) number[i] = number_of(last[i] = seen.geom[i]);
            contact.geom[i] = number[i];
        }
        for (size_t i = 0; i < 3; ++i) {
            contact.pos[i] = float(seen.pos[i]);
            contact.normal[i] = float(seen.normal[i]);
            contact.force[i] = float(seen.force[i]);
        }
        contact.depth = float(seen.depth);
        step_.contacts.push_back(contact);
    }
    sink_.step(step_);
}

}  // namespace epode::record
