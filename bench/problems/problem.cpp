// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See problem.h. Friction scales with the normal force (dContactApprox1), so that the problem is the two
// convex ones of the exact stepper: normals first, then everything within limits taken from them.
#include "bench/problems/problem.h"

#include <chrono>
#include <ctime>

namespace epode::bench {

namespace {

using namespace scenes;

constexpr double kFriction = 0.6;
// On a busy machine a long step is interrupted, so processor time is reported for it: of all threads together,
// which is the same on an idle machine when there is one. To ask for it takes a quarter of a microsecond, too
// much for short steps; those are seldom interrupted.
constexpr double kShortStep = 0.2;

double cpu_milliseconds()
{
    timespec now{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
    return 1e3 * double(now.tv_sec) + 1e-6 * double(now.tv_nsec);
}

}  // namespace

Problem::Problem() : world_(dWorldCreate()), contact_group_(dJointGroupCreate(0))
{
    dWorldSetGravity(world_, 0, 0, dReal(-9.81));
}

Problem::~Problem()
{
    dJointGroupDestroy(contact_group_);
    dWorldDestroy(world_);
}

int Problem::add_body(const dMass& mass, Vec pos, Turn turn, Vec linear, Vec angular)
{
    dBodyID body = dBodyCreate(world_);
    dBodySetMass(body, &mass);
    bodies_.push_back(body);
    start_.push_back({pos, turn, linear, angular});
    dBodySetPosition(body, dReal(pos.x), dReal(pos.y), dReal(pos.z));
    const dQuaternion q = {dReal(turn.w), dReal(turn.x), dReal(turn.y), dReal(turn.z)};
    dBodySetQuaternion(body, q);
    return int(bodies_.size()) - 1;
}

void Problem::add_ball(int body1, int body2, Vec anchor)
{
    dJointID joint = dJointCreateBall(world_, nullptr);
    dJointAttach(joint, body(body1), body(body2));
    dJointSetBallAnchor(joint, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
    joint_rows_ += 3;
}

void Problem::add_hinge(int body1, int body2, Vec anchor, Vec axis)
{
    dJointID joint = dJointCreateHinge(world_, nullptr);
    dJointAttach(joint, body(body1), body(body2));
    dJointSetHingeAnchor(joint, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
    dJointSetHingeAxis(joint, dReal(axis.x), dReal(axis.y), dReal(axis.z));
    joint_rows_ += 5;
}

void Problem::make_contact(const BatchPoint& point)
{
    dContact contact{};
    contact.surface.mode = dContactApprox1;
    contact.surface.mu = dReal(kFriction);
    const double pos[3] = {point.pos.x, point.pos.y, point.pos.z};
    const double normal[3] = {point.normal.x, point.normal.y, point.normal.z};
    for (int k = 0; k < 3; ++k) {
        contact.geom.pos[k] = dReal(pos[k]);
        contact.geom.normal[k] = dReal(normal[k]);
    }
    contact.geom.depth = dReal(point.depth);
    dJointAttach(dJointCreateContact(world_, contact_group_, &contact), body(point.body1), body(point.body2));
}

void Problem::prepare(std::uint32_t draw)
{
    Lcg random(draw + 1);
    const auto shake = [&](Vec v) {
        const double x = random.uniform(-spread_, spread_), y = random.uniform(-spread_, spread_);
        return v + Vec{x, y, random.uniform(-spread_, spread_)};
    };
    dJointGroupEmpty(contact_group_);
    for (size_t i = 0; i < bodies_.size(); ++i) {
        const State& s = start_[i];
        const dQuaternion q = {dReal(s.turn.w), dReal(s.turn.x), dReal(s.turn.y), dReal(s.turn.z)};
        dBodySetPosition(bodies_[i], dReal(s.pos.x), dReal(s.pos.y), dReal(s.pos.z));
        dBodySetQuaternion(bodies_[i], q);
        const Vec linear = shake(s.linear);
        set_velocity(bodies_[i], linear, shake(s.angular));
    }
    for (const BatchPoint& point : contacts_) make_contact(point);
}

double Problem::step()
{
    using Clock = std::chrono::steady_clock;
    const double cpu_start = cpu_milliseconds();
    const auto start = Clock::now();
    dWorldStep(world_, dReal(kProblemDt));
    const double wall = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
    return wall < kShortStep ? wall : cpu_milliseconds() - cpu_start;
}

}  // namespace epode::bench
