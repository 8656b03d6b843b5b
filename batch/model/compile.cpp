// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See batch_model.h. Links, joints and dofs keep the order of the model, in which parents come before children.
#include <algorithm>

#include "batch/model/batch_model.h"
#include "batch/model/loops.h"
#include "batch/model/pairs.h"
#include "batch/model/refusal.h"
#include "batch/model/sensors.h"
#include "batch/model/sums.h"
#include "robots/inertia.h"
#include "robots/kinematics.h"

namespace epode::batch {

using namespace robots;

namespace {

int add(std::vector<double>& numbers, std::initializer_list<double> values)
{
    numbers.insert(numbers.end(), values);
    return int(numbers.size() - values.size());
}

// Bounds that none reaches, so that arithmetic on them stays finite.
constexpr double kFar = 1e30;
double within_far(double x) { return std::clamp(x, -kFar, kFar); }

Matrix usable_inertia(const Link& link)
{
    if (!(link.mass > 0)) return {};
    return fault_of(link.inertia).empty() ? link.inertia : mended(link.inertia, link.mass);
}

void add_link(BatchModel& out, const Link& link)
{
    BatchLink its;
    its.parent = std::max(0, link.parent), its.joints = int(link.joints.size());
    its.is_weightless = link.is_weightless;
    const Pose& at = link.pose;
    its.is_turned = at.q.x != 0 || at.q.y != 0 || at.q.z != 0;
    const Matrix i = usable_inertia(link);
    its.first = add(out.numbers,
                    {at.p.x, at.p.y, at.p.z, at.q.w, at.q.x, at.q.y, at.q.z, link.mass, link.centre.x,
                     link.centre.y, link.centre.z, i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]});
    out.links.push_back(its);
}

void add_joint(BatchModel& out, const Joint& joint)
{
    BatchJoint its;
    its.kind = joint.kind, its.link = joint.link, its.position = joint.position,
    its.dof = int(out.dofs.size());
    its.is_at_origin = joint.anchor.x == 0 && joint.anchor.y == 0 && joint.anchor.z == 0;
    const Vec axis = (1 / length(joint.axis)) * joint.axis;
    its.first = add(out.numbers, {axis.x, axis.y, axis.z, joint.anchor.x, joint.anchor.y, joint.anchor.z,
                                  joint.reference});
    out.joints.push_back(its);
}

// The dof before the joint's first one: of the joint before it, or of its link's parent.
int dof_before(const BatchModel& out, int link) { return out.links[size_t(link)].last_dof; }

void add_dof(BatchModel& out, const Joint& joint, const Spring& stop)
{
    Dof its;
    its.link = joint.link, its.joint = int(out.joints.size()) - 1;
    its.is_scalar = joint.is_scalar();
    its.is_limited = its.is_scalar && joint.limited, its.has_friction = joint.friction > 0;
    const int before = dof_before(out, joint.link);
    its.depth = before < 0 ? 0 : out.dofs[size_t(before)].depth + 1;
    its.chain = int(out.chains.size());
    for (int i = 0; i < its.depth; ++i)
        out.chains.push_back(out.chains[size_t(out.dofs[size_t(before)].chain + i)]);
    out.chains.push_back(int(out.dofs.size()));
    its.row = out.entries, out.entries += its.depth + 1;
    const double limit = joint.max_force > 0 ? joint.max_force : kFar;
    its.first = add(out.numbers, {joint.armature, joint.damping, joint.stiffness, joint.spring_reference,
                                  joint.friction, within_far(joint.low), within_far(joint.high),
                                  stop.stiffness, stop.damping, within_far(limit)});
    if (its.is_limited) its.limit = out.limits++;
    if (its.has_friction) its.dry = out.dry++;
    out.links[size_t(joint.link)].last_dof = int(out.dofs.size());
    out.dofs.push_back(its);
}

void add_joints_of(BatchModel& out, const Prepared& prepared, int number)
{
    const RobotModel& model = prepared.model();
    BatchLink& link = out.links[size_t(number)];
    link.last_dof = out.links[size_t(link.parent)].last_dof;
    link.tree = link.parent == 0 ? out.trees++ : out.links[size_t(link.parent)].tree;
    link.first_joint = int(out.joints.size());
    for (int joint : model.links[size_t(number)].joints) {
        const Joint& its = model.joints[size_t(joint)];
        add_joint(out, its);
        const Spring stop = its.limited ? prepared.springs().of_limit(model, joint) : Spring{};
        for (int i = 0; i < velocities_of(its); ++i) add_dof(out, its, stop);
    }
}

// Coefficients of robots/fluid.h.
void add_box(BatchModel& out, int link, const FluidBox& box, const Medium& medium)
{
    const Pose& at = box.pose;
    const Vec r = box.half;
    const double mean = (r.x + r.y + r.z) / 3, viscosity = kPi * medium.viscosity;
    BatchBox its{link, add(out.numbers, {at.p.x, at.p.y, at.p.z, at.q.w, at.q.x, at.q.y, at.q.z})};
    add(out.numbers, {box.mass, box.mass, box.mass});
    for (int i = 0; i < 3; ++i) add(out.numbers, {2 * medium.density * r[(i + 1) % 3] * r[(i + 2) % 3]});
    const double slow = 6 * viscosity * mean;
    add(out.numbers, {slow, slow, slow, box.moments.x, box.moments.y, box.moments.z});
    for (int i = 0; i < 3; ++i) {
        const double j = r[(i + 1) % 3] * r[(i + 1) % 3], k = r[(i + 2) % 3] * r[(i + 2) % 3];
        add(out.numbers, {medium.density * r[i] * (j * j + k * k) / 2});
    }
    const double spin = 8 * viscosity * mean * mean * mean;
    add(out.numbers, {spin, spin, spin});
    out.boxes.push_back(its);
}

void add_medium(BatchModel& out, const RobotModel& model)
{
    const Vec wind = model.medium.wind;
    out.wind = add(out.numbers, {wind.x, wind.y, wind.z});
    for (size_t i = 1; i < model.links.size(); ++i)
        for (const FluidBox& box : model.links[i].boxes)
            if (out.links[i].last_dof >= 0) add_box(out, int(i), box, model.medium);
}

// Joints are made link by link: the model's own order, or the batch would number them otherwise.
bool is_in_order(const RobotModel& model)
{
    int next = 0;
    for (const Link& link : model.links)
        for (int joint : link.joints)
            if (joint != next++) return false;
    return true;
}

void add_filter(BatchModel& out, const Activation& filter, BatchActuator& its)
{
    if (filter.kind == Activation::Kind::kNone) return;
    its.kind = filter.kind, its.is_early = filter.is_early, its.filter = out.filters++;
    its.filter_first = add(out.numbers, {filter.time, within_far(filter.low), within_far(filter.high)});
}

void add_actuator(BatchModel& out, const Actuator& a, const std::vector<int>& sums)
{
    BatchActuator its;
    add_filter(out, a.filter, its);
    if (a.joint >= 0) {
        const BatchJoint& joint = out.joints[size_t(a.joint)];
        its.dof = joint.dof, its.position = joint.position;
    } else {
        its.sum = sums[size_t(a.tendon)];
    }
    its.is_servo = a.bias_position != 0 || a.bias_velocity != 0;
    its.first = add(out.numbers, {a.gear, a.gain, a.bias, a.bias_position, a.bias_velocity, within_far(a.low),
                                  within_far(a.high), within_far(a.force_low), within_far(a.force_high)});
    out.actuators.push_back(its);
    if (its.sum >= 0) return;
    // A servo whose force is limited is a row of its own where it may reach its limit.
    Dof& dof = out.dofs[size_t(its.dof)];
    const double limit = std::fabs(a.gear) * std::max(-a.force_low, a.force_high);
    double& stated = out.numbers[size_t(dof.first + dof_number::kForceLimit)];
    if (!its.is_servo) return;
    stated = std::min(stated, within_far(limit));
    if (stated < kFar && dof.servo < 0) dof.servo = out.servos++;
}

void add_shapes(BatchModel& out, const RobotModel& model)
{
    for (size_t i = 0; i < model.links.size(); ++i)
        for (const Shape& shape : model.links[i].shapes) {
            BatchShape its;
            const Pose& at = shape.pose;
            its.link = int(i), its.is_turned = at.q.x != 0 || at.q.y != 0 || at.q.z != 0;
            its.first = add(out.numbers, {at.p.x, at.p.y, at.p.z, at.q.w, at.q.x, at.q.y, at.q.z,
                                          shape.size.x, shape.size.y, shape.size.z});
            out.shapes.push_back(its);
        }
}

}  // namespace

int points_of(PointKind kind)
{
    switch (kind) {
        case PointKind::kBoxPlane:
            return 8;
        case PointKind::kCylinderPlane:
            return 4;
        case PointKind::kCapsulePlane:
            return 2;
        default:
            return 1;
    }
}

bool compile(const std::shared_ptr<const Prepared>& shared, BatchModel& out, std::string& refusal)
{
    const Prepared& prepared = *shared;
    const RobotModel& model = prepared.model();
    out = BatchModel{};
    out.asked.prepared = shared;
    refusal = refusal_of(model);
    if (refusal.empty() && !is_in_order(model))
        refusal = "the joints do not stand in the order of their links";
    if (!refusal.empty()) return false;
    out.name = model.name;
    out.gravity = add(out.numbers, {model.gravity.x, model.gravity.y, model.gravity.z});
    out.terrain = add(out.numbers, {0, 0, 0});
    for (const Link& link : model.links) add_link(out, link);
    for (size_t i = 1; i < model.links.size(); ++i) add_joints_of(out, prepared, int(i));
    add_loops(out, model);
    const std::vector<int> sums = add_sums(out, prepared);
    for (const Actuator& actuator : model.actuators) add_actuator(out, actuator, sums);
    add_shapes(out, model);
    add_sensors(out, model, sums);
    add_medium(out, model);
    out.reference = reference_positions(model);
    out.positions = model.coordinates, out.velocities = int(out.dofs.size()),
    out.controls = int(out.actuators.size());
    add_pairs(out, prepared);
    widen_dofs(out);
    return true;
}

}  // namespace epode::batch
