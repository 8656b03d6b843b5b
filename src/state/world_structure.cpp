// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// World, bodies, joints and what is attached to what; geoms are in world_structure_geoms.cpp. Joints are not
// attached by attach(): their types would take anchors and axes from the bodies again.
#include "state/world_structure.h"

#include <algorithm>
#include <utility>

#include "base/check.h"
#include "base/objects/structure_edition.h"
#include "dynamics/forces/fluid.h"
#include "dynamics/forces/vehicle.h"
#include "dynamics/joint_drives.h"
#include "fluid/floating_geom.h"
#include "joints/drive_rows.h"
#include "joints/registry.h"
#include "state/object_structure.h"
#include "step/common/link.h"

namespace epode {
namespace {

// What records of objects have at least, in bytes.
constexpr std::size_t kBodyBytes = 20 * sizeof(Real), kJointBytes = 6, kNameBytes = 4,
                      kFluidBytes = 12 * sizeof(Real);

bool append(JointNode& node, Body& body, JointNode* last)
{
    if (node.body) return false;
    node.body = &body;
    node.prev = last, node.next = nullptr;
    (last ? last->next : body.joints) = &node;
    if (!body.lasting && !is_contact(*node.joint)) body.lasting = &node;
    return true;
}

// A joint that has lost its bodies, or was attached to (0, 0), may be reversed still.
bool is_sound(const Joint& joint)
{
    const Body *a = joint.body1(), *b = joint.body2();
    if (!a) return !b;
    return a != b && !(joint.reverse && b) && (b || !joint.type->needs_two_bodies);
}

}  // namespace

bool WorldStructure::gather()
{
    int body = world_->bodies.count(), joint = world_->joints.count();
    const bool has_memory =
        bodies_.resize(body) && joints_.resize(joint) && numbers_.resize(world_->joints.places());
    if (!stream_.demand(has_memory, kOutOfMemory)) return false;
    for (Body& one : world_->bodies) bodies_[--body] = &one;
    for (Joint& one : world_->joints) numbers_[one.place] = --joint, joints_[joint] = &one;
    return gather_geoms();
}

World* WorldStructure::load()
{
    world_ = Pool<World>::create();
    if (!stream_.demand(world_, kOutOfMemory)) return nullptr;
    visit();
    note_structure_changed();
    ++world_->connections_version;
    if (!stream_.failed()) return world_;
    discard();
    return nullptr;
}

void WorldStructure::visit()
{
    structure_of_settings(*world_, stream_);
    visit_bodies();
    visit_joints();
    visit_couplings();
    visit_links();
    visit_geoms();
    visit_geoms_of_bodies();
    visit_contacts();
    if (stream_.is_older_than(5)) return;
    visit_fluids();
    visit_vehicles();
}

void WorldStructure::discard()
{
    discard_geoms();
    Pool<World>::destroy(world_);
    stream_.destroy_shared();
    world_ = nullptr;
}

// Functions are of the process: a file has none.
void WorldStructure::visit_fluids()
{
    const int count = stream_.count(world_->fluids.size(), kFluidBytes, "fluids");
    for (int i = 0; i < count && !stream_.failed(); ++i) {
        Fluid* const fluid = stream_.saves() ? world_->fluids[i] : create_fluid(*world_);
        if (!stream_.demand(fluid, kOutOfMemory)) return;
        dFluidSettings& s = fluid->settings;
        for (Real* number : {&s.density, &s.drag, &s.linear_drag, &s.angular_drag})
            stream_.real(*number, StructureStream::kFinite, 0);
        stream_.reals(s.current, 3);
        stream_.vector(fluid->normal), stream_.real(fluid->offset), stream_.real(fluid->time);
        stream_.pointer(fluid->surface), stream_.pointer(fluid->surface_data);
        stream_.pointer(fluid->current), stream_.pointer(fluid->current_data);
        Geom* volume = stream_.saves() ? from_handle<Geom>(fluid->volume) : nullptr;
        if (stream_.saves() && fluid->volume && !volume)
            return stream_.fail("the volume of fluid %d has been destroyed", i);
        if (volume && stream_.saves() && stream_.find(*volume) < 0)
            return stream_.fail("the volume of fluid %d is a geom that is not saved with the world", i);
        stream_.geom(volume);
        if (stream_.saves() || stream_.failed()) continue;
        fluid->volume = volume ? to_handle(volume) : nullptr;
        const bool sound =
            within(length2(fluid->normal) - 1, Real(1e-3)) && (!volume || bounds_fluids(*volume));
        if (!stream_.demand(sound, "a fluid in it has a plane or a volume that it cannot have")) return;
    }
}

void WorldStructure::visit_bodies()
{
    const int count = stream_.count(bodies_.size(), kBodyBytes, "bodies");
    if (stream_.loads() && !stream_.demand(bodies_.reserve(count), kOutOfMemory)) return;
    for (int i = 0; i < count && !stream_.failed(); ++i)
        if (stream_.saves() || load_body()) structure_of_body(*bodies_[i], stream_);
}

// Without the memory that new bodies of this world have for averages: each of the file brings its own.
bool WorldStructure::load_body()
{
    const int samples = std::exchange(world_->sleep.samples, 1);
    Body* const body = create_body(*world_);
    world_->sleep.samples = samples;
    return stream_.demand(body && bodies_.push(body), kOutOfMemory);
}

void WorldStructure::visit_joints()
{
    const int count = stream_.count(joints_.size(), kJointBytes, "joints");
    if (stream_.loads() && !stream_.demand(joints_.reserve(count), kOutOfMemory)) return;
    for (int i = 0; i < count && !stream_.failed(); ++i) {
        Joint* joint = stream_.saves() ? joints_[i] : nullptr;
        int number = joint ? joint->type->number : 0;
        stream_.number(number);
        if (joint)
            joint->type->structure(*joint, stream_);
        else if (!(joint = load_joint(number)))
            return;
        visit_switches(*joint);
    }
}

Joint* WorldStructure::load_joint(int number)
{
    const JointType* const type = joint_type(number);
    if (!type) stream_.fail("joint %d in it has an unknown type, %d", joints_.size(), number);
    if (stream_.failed()) return nullptr;
    Joint* const joint = type->make(*world_, stream_);
    if (!stream_.demand(joint, kOutOfMemory)) return nullptr;
    if (!link_into_world(*joint, nullptr)) {
        type->destroy(*joint);
        stream_.fail("%s", kOutOfMemory);
        return nullptr;
    }
    (void)joints_.push(joint);  // has been reserved
    return joint;
}

void WorldStructure::visit_switches(Joint& joint)
{
    bool reverse = joint.reverse, driven = joint.driven, coupled = joint.coupled;
    stream_.flag(reverse), stream_.flag(driven), stream_.flag(coupled);
    stream_.pointer(joint.data);
    if (stream_.saves()) return;
    joint.reverse = reverse, joint.coupled = coupled;
    if (!driven) return;
    if (stream_.demand(!is_contact(joint), "a contact joint in it has drives"))
        stream_.demand(take_drives(static_cast<LastingJoint&>(joint)), kOutOfMemory);
}

// In the order of the world's list, on which steps depend.
void WorldStructure::visit_couplings()
{
    const int count = stream_.count(world_->couplings.size(), kNameBytes, "couplings");
    for (int i = 0; i < count && !stream_.failed(); ++i) {
        Joint* joint = stream_.saves() ? world_->couplings[i] : nullptr;
        visit_name(joint);
        if (!stream_.demand(joint && is_coupling(*joint), "a coupling in it is none")) return;
        CouplingJoint& coupling = coupling_of(*joint);
        if (stream_.loads() && !stream_.demand(list_coupling(coupling), kOutOfMemory)) return;
        for (CoupledAxis& member : coupling.member) visit_member(coupling, member);
    }
}

// Of one whose factors move the axes have numbers from kMoves on.
void WorldStructure::visit_member(CouplingJoint& coupling, CoupledAxis& member)
{
    constexpr int kMoves = 64;
    CoupledAxis m = member;
    visit_name(m.joint);
    if (!m.joint) return;
    if (coupling.moves && stream_.saves()) m.axis += kMoves;
    stream_.number(m.axis), stream_.real(m.factor);
    if (stream_.loads() && m.axis >= kMoves) m.axis -= kMoves, coupling.moves = true;
    if (stream_.saves() || stream_.failed()) return;
    const bool fits = !is_coupling(*m.joint) && m.joint->coupled && m.axis >= 0 &&
                      m.axis < axis_count(*m.joint) && usable(m.factor) && m.factor != 0;
    if (stream_.demand(fits, "a coupling in it has an axis that it cannot have")) member = m;
}

void WorldStructure::visit_name(Joint*& joint)
{
    std::uint32_t name = stream_.saves() && joint ? std::uint32_t(number_of(*joint)) + 1 : 0;
    stream_.number(name, std::uint32_t(0), std::uint32_t(joints_.size()) + 1, "a joint in it is not there");
    if (stream_.loads()) joint = name > 0 ? joints_[int(name) - 1] : nullptr;
}

// Bodies that are vehicles, by number.
void WorldStructure::visit_vehicles()
{
    const auto is_vehicle = [](const Body* body) { return body->vehicle != nullptr; };
    const auto all = bodies_.span();
    int count = stream_.saves() ? int(std::count_if(all.begin(), all.end(), is_vehicle)) : 0;
    count = stream_.count(count, kNameBytes, "vehicles");
    int next = 0;
    for (int i = 0; i < count && !stream_.failed(); ++i) {
        if (stream_.saves())
            while (!is_vehicle(bodies_[next])) ++next;
        stream_.number(next, 0, bodies_.size(), "a vehicle in it is no body, or is twice");
        if (stream_.failed() ||
            !stream_.demand(stream_.saves() || !bodies_[next]->vehicle, "a vehicle in it is twice"))
            return;
        structure_of_vehicle(*bodies_[next++], stream_);
    }
}

void WorldStructure::visit_links()
{
    for (Body* body : bodies_) {
        int count = 0;
        if (stream_.saves())
            for (JointNode* n = body->joints; n; n = n->next) ++count;
        count = stream_.count(count, kNameBytes, "joints of a body");
        stream_.saves() ? save_links(*body) : load_links(*body, count);
        if (stream_.failed()) return;
    }
    if (stream_.saves()) return;
    for (int i = 0; i < joints_.size(); ++i) {
        if (!is_sound(*joints_[i])) return stream_.fail("joint %d in it has bodies that it cannot have", i);
        if (joints_[i]->attached() && !is_contact(*joints_[i]))
            ++static_cast<LastingJoint*>(joints_[i])->attachments;
    }
}

// Twice the joint's number, and which node of it.
void WorldStructure::save_links(const Body& body)
{
    for (JointNode* n = body.joints; n; n = n->next) {
        std::uint32_t name = 2 * std::uint32_t(number_of(*n->joint)) + (n == &n->joint->node[1]);
        stream_.number(name);
    }
}

void WorldStructure::load_links(Body& body, int count)
{
    constexpr const char* kAbsent = "a joint of a body in it is not there, or is twice";
    JointNode* last = nullptr;
    for (int i = 0; i < count; ++i) {
        std::uint32_t name = 0;
        stream_.number(name, std::uint32_t(0), 2 * std::uint32_t(joints_.size()), kAbsent);
        if (stream_.failed()) return;
        JointNode& node = joints_[int(name / 2)]->node[name % 2];
        if (!stream_.demand(append(node, body, last), kAbsent)) return;
        last = &node;
    }
}

}  // namespace epode
