// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Lengths follow the scene. A force is drawn as long as `size` for twice the mean weight of a body, up to six
// sizes: an impact would else run out of the picture.
// Stops of a turning joint are the ends of an arc about its axis, zero lying at a direction fixed to the body
// that the axis is not fixed to; a grey needle shows the joint's angle between them.
#include "view/overlays.h"

#include <algorithm>
#include <cmath>

namespace epode::view {

namespace {

constexpr double kGravity = 9.81;

const record::BodyState* state_of(const Moment& now, std::int32_t body)
{
    return body >= 0 && size_t(body) < now.bodies.size() ? now.bodies[size_t(body)] : nullptr;
}

Vec in_world(const Moment& now, std::int32_t body, Vec point)
{
    const record::BodyState* state = state_of(now, body);
    return state ? place(state->pose, point) : point;
}

Vec turned(const Moment& now, std::int32_t body, Vec v)
{
    const record::BodyState* state = state_of(now, body);
    return state ? scenes::rotate(turn_of(state->pose.turn), v) : v;
}

// Where the joint is: its first anchor, or between the bodies.
Vec center_of(const record::Joint& joint, const Moment& now)
{
    for (size_t i = 0; i < 2; ++i) {
        if (joint.has_anchor[i]) return in_world(now, joint.body[i], vec(joint.anchor[i]));
    }
    Vec sum;
    int count = 0;
    for (std::int32_t body : joint.body) {
        if (const record::BodyState* state = state_of(now, body)) {
            sum = sum + vec(state->pose.pos);
            ++count;
        }
    }
    return count > 0 ? (1.0 / count) * sum : sum;
}

Vec zero_of(const Moment& now, std::int32_t body, Vec axis)
{
    const record::BodyState* state = state_of(now, body);
    if (!state) return across(axis);
    const Turn q = turn_of(state->pose.turn);
    return scenes::rotate(q, across(scenes::rotate(scenes::inverse(q), axis)));
}

// Ends that are not there are drawn half a turn or two sizes away.
void draw_limit(const record::Limit& limit, Vec center, Vec axis, Vec zero, double size, Lines& lines)
{
    const double far = limit.stop.turns ? scenes::kPi : 2 * size;
    const double low = std::clamp(limit.stop.low, -far, far), high = std::clamp(limit.stop.high, -far, far);
    if (!limit.stop.turns) {
        const Vec from = center - limit.value * axis, side = across(axis);
        lines.line(from + low * axis, from + high * axis, kRed);
        for (double end : {low, high})
            lines.line(from + end * axis - (0.2 * size) * side, from + end * axis + (0.2 * size) * side,
                       kRed);
        return;
    }
    lines.arc(center, axis, zero, size, low, high, kRed);
    const Vec y = scenes::cross(axis, zero);
    lines.line(
        center,
        center + (1.15 * size * std::cos(limit.value)) * zero + (1.15 * size * std::sin(limit.value)) * y,
        kGray);
}

double mean_weight(const Stage& stage)
{
    double sum = 0;
    int count = 0;
    for (const record::Body& body : stage.bodies()) {
        if (!body.kinematic && body.mass > 0) sum += body.mass, ++count;
    }
    return count > 0 ? kGravity * sum / count : kGravity;
}

}  // namespace

double fitting_size(const Stage& stage, const Moment& now)
{
    double sum = 0;
    int count = 0;
    for (const Moment::PlacedGeom& geom : now.geoms) {
        Vec low, high;
        if (geom.body == record::kNobody) continue;
        if (!box_around(stage.shapes()[stage.geoms()[geom.number].shape], geom.world, low, high)) continue;
        const double length = scenes::length(high - low);
        if (std::isfinite(length)) sum += length, ++count;
    }
    return count > 0 ? 0.3 * sum / count : 0.3;
}

void draw_body_axes(const Stage& stage, const Moment& now, double size, Lines& lines)
{
    for (size_t i = 0; i < stage.bodies().size(); ++i) {
        if (!now.bodies[i]) continue;
        const record::Pose& pose = now.bodies[i]->pose;
        const Turn q = turn_of(pose.turn);
        lines.arrow(vec(pose.pos), size * scenes::rotate(q, scenes::kX), kRed);
        lines.arrow(vec(pose.pos), size * scenes::rotate(q, scenes::kY), kGreen);
        lines.arrow(vec(pose.pos), size * scenes::rotate(q, scenes::kZ), kBlue);
    }
}

void draw_joints(const Session& session, const Moment& now, const Switches& switches, double size,
                 Lines& lines)
{
    const Stage& stage = session.stage();
    for (std::uint32_t number : now.joints) {
        const record::Joint& joint = stage.joints()[number];
        const Vec center = center_of(joint, now);
        for (size_t i = 0; i < 2 && switches.joints; ++i) {
            const record::BodyState* state = state_of(now, joint.body[i]);
            if (!state) continue;
            const Vec anchor =
                joint.has_anchor[i] ? in_world(now, joint.body[i], vec(joint.anchor[i])) : center;
            lines.line(anchor, vec(state->pose.pos), kDark);
            if (joint.has_anchor[i]) lines.cross(anchor, 0.12 * size, kOrange);
        }
        for (size_t i = 0; i < 2 && switches.joint_axes; ++i) {
            if (!joint.has_axis[i]) continue;
            const Vec axis = unit(turned(now, joint.body[i], vec(joint.axis[i])));
            lines.arrow(center - (0.5 * size) * axis, size * axis, i == 0 ? kMagenta : kBlue);
        }
        if (!switches.limits) continue;
        for (const record::Limit& limit : session.limits(number)) {
            const auto k = size_t(limit.stop.axis);
            if (!joint.has_axis[k]) continue;
            const Vec axis = unit(turned(now, joint.body[k], vec(joint.axis[k])));
            draw_limit(limit, center, axis, zero_of(now, joint.body[1 - k], axis), 0.8 * size, lines);
        }
    }
}

void draw_contacts(const Stage& stage, const Moment& now, const Switches& switches, double size, Lines& lines)
{
    const double per_newton = double(switches.arrows) * size / (2 * mean_weight(stage));
    for (const record::Contact& contact : now.step->contacts) {
        const Vec at = vec(contact.pos), normal = vec(contact.normal), force = vec(contact.force);
        lines.cross(at, 0.08 * size, kRed);
        const double n = scenes::length(force);
        if (!switches.forces || !now.step->has_forces || !(n > 0))
            lines.line(at, at + (0.35 * size) * normal, kGreen);
        else
            lines.arrow(at, std::min(per_newton, 6 * size / n) * force, kYellow);
    }
}

void draw_boxes(const Stage& stage, const Moment& now, Lines& lines)
{
    for (const Moment::PlacedGeom& geom : now.geoms) {
        Vec low, high;
        if (geom.body != record::kNobody &&
            box_around(stage.shapes()[stage.geoms()[geom.number].shape], geom.world, low, high))
            lines.box(low, high, kGray);
    }
}

}  // namespace epode::view
