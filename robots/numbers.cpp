// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See numbers.h.
#include "robots/numbers.h"

#include <algorithm>
#include <charconv>
#include <limits>

namespace epode::robots {

namespace {

bool fits(double value) { return std::fabs(value) <= kMaxNumber; }  // false for NaN
bool fits(const Vec& v) { return fits(v.x) && fits(v.y) && fits(v.z); }
bool fits(const Quat& q) { return fits(q.w) && fits(q.x) && fits(q.y) && fits(q.z); }
bool fits(const Pose& pose) { return fits(pose.p) && fits(pose.q); }
bool fits(const Softness& s)
{
    return fits(s.time) && fits(s.ratio) && fits(s.low) && fits(s.high) && fits(s.width) && fits(s.middle) &&
           fits(s.power);
}
bool fits(const Shape& s)
{
    return fits(s.pose) && fits(s.size) && fits(s.friction) && fits(s.torsional_friction) &&
           fits(s.rolling_friction) && fits(s.softness);
}
bool fits(const FluidBox& box)
{
    return fits(box.pose) && fits(box.mass) && fits(box.moments) && fits(box.half);
}
bool fits(const Coupling::Term& term) { return fits(term.factor); }
bool fits(const PathPart& part)
{
    return fits(part.pose) && fits(part.radius) && fits(part.side) && fits(part.divisor);
}

template <typename Items>
bool all_fit(const Items& items)
{
    return std::all_of(items.begin(), items.end(), [](const auto& item) { return fits(item); });
}

bool fits(const Link& link)
{
    return fits(link.pose) && all_fit(link.shapes) && all_fit(link.visuals) && all_fit(link.boxes);
}
bool fits(const Joint& j)
{
    return fits(j.axis) && fits(j.anchor) && fits(j.reference) && fits(j.stiffness) &&
           fits(j.spring_reference) && fits(j.damping) && fits(j.armature) && fits(j.friction) &&
           fits(j.stop_softness);
}
bool fits(const Coupling& c)
{
    return all_fit(c.terms) && fits(c.offset) && all_fit(c.polynomial) && fits(c.ratio);
}
bool fits(const Tie& tie) { return all_fit(tie.curve) && fits(tie.rest1) && fits(tie.rest2); }
bool fits(const Closure& closure) { return fits(closure.pose1) && fits(closure.pose2); }
bool fits(const Tendon& t)
{
    return all_fit(t.terms) && all_fit(t.path) && fits(t.stiffness) && fits(t.damping) && fits(t.friction) &&
           fits(t.armature) && fits(t.rest) && fits(t.rest_high);
}
bool fits(const Actuator& a)
{
    return fits(a.gear) && fits(a.gain) && fits(a.bias) && fits(a.bias_position) && fits(a.bias_velocity) &&
           fits(a.filter.time) && fits(a.wrench.pose) && fits(a.wrench.reference) && fits(a.wrench.force) &&
           fits(a.wrench.torque) && fits(a.wrench.rod);
}
bool fits(const ShapePair& p) { return fits(p.friction) && fits(p.rolling_friction); }
bool fits(const Frame& frame) { return fits(frame.pose) && fits(frame.size); }
bool fits(const Start& start) { return all_fit(start.positions) && all_fit(start.controls); }
bool fits(const Mesh& mesh) { return all_fit(mesh.vertices); }
bool fits(const HeightField& f) { return fits(f.half_x) && fits(f.half_y) && fits(f.top) && fits(f.base); }

template <typename Item>
int line_of(const Item& item)
{
    if constexpr (requires { item.line; })
        return item.line;
    else
        return 0;
}

void refuse(RobotModel& model, int line, const std::string& what)
{
    model.report.push_back(
        {Note::kError, model.path, line, what + " has a number beyond " + max_number_text()});
}

template <typename Items>
void judge(RobotModel& model, const Items& items, const char* kind, std::string Items::value_type::*name)
{
    for (const auto& item : items)
        if (!fits(item)) refuse(model, line_of(item), std::string(kind) + " '" + item.*name + "'");
}

void open(double& low, double& high)
{
    if (low < -kMaxNumber) low = -kInfinity;
    if (high > kMaxNumber) high = kInfinity;
}

void open_limits(RobotModel& model)
{
    for (Joint& joint : model.joints) {
        open(joint.low, joint.high);
        double none = 0;
        open(none, joint.max_force), open(none, joint.max_velocity);
    }
    for (Tendon& tendon : model.tendons) open(tendon.low, tendon.high);
    for (Actuator& actuator : model.actuators) {
        open(actuator.low, actuator.high), open(actuator.force_low, actuator.force_high);
        open(actuator.filter.low, actuator.filter.high);
    }
}

}  // namespace

std::string text_of(double value)
{
    constexpr double kLargest = std::numeric_limits<double>::max();
    char buffer[32];
    const auto [end, error] =
        std::to_chars(buffer, buffer + sizeof buffer, std::clamp(value, -kLargest, kLargest));
    return error == std::errc() ? std::string(buffer, end) : "0";
}

const char* max_number_text() { return sizeof(dReal) == 8 ? "1e30" : "1e9"; }

void judge_numbers(RobotModel& model)
{
    open_limits(model);
    judge(model, model.links, "link", &Link::name);
    judge(model, model.joints, "joint", &Joint::name);
    judge(model, model.couplings, "coupling", &Coupling::name);
    judge(model, model.closures, "closure", &Closure::name);
    judge(model, model.ties, "equality of tendons", &Tie::name);
    judge(model, model.tendons, "tendon", &Tendon::name);
    judge(model, model.actuators, "actuator", &Actuator::name);
    judge(model, model.pairs, "pair", &ShapePair::name);
    judge(model, model.frames, "frame", &Frame::name);
    for (const Camera& camera : model.cameras)
        if (!fits(camera.frame)) refuse(model, 0, "camera '" + camera.frame.name + "'");
    judge(model, model.starts, "start", &Start::name);
    judge(model, model.meshes, "mesh", &Mesh::path);
    judge(model, model.fields, "height field", &HeightField::path);
    const Medium& medium = model.medium;
    if (!fits(model.stepsize)) refuse(model, 0, "the time of a step");
    if (!fits(model.gravity) || !fits(medium.density) || !fits(medium.viscosity) || !fits(medium.wind))
        refuse(model, 0, "gravity or the medium");
}

}  // namespace epode::robots
