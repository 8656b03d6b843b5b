// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The moving side of a built robot: coordinates, and one drive on each axis for all that acts there. With ODE's position
// p = q - r, the passive spring and damper (k0, q0, d0), a program's servo (ks, qs, ds) and actuators with gear g,
// gain G, bias b0, bp, bv at a control u,
//     force = k0 (q0 - q) - d0 w + ks (qs - q) - ds w + sum g (G u + b0 - bp g q - bv g w)
//           = k (t - p) - d w,   k = k0 + ks + sum g^2 bp,   d = d0 + ds + sum g^2 bv,
//     k t = k0 (q0 - r) + ks (qs - r) + sum g (G u + b0 - bp g r);
// where k is 0 that sum is the drive's force.
#include <ode/ext.h>

#include <algorithm>

#include "robots/body_poses.h"
#include "robots/build.h"
#include "robots/fluid.h"
#include "robots/kinematics.h"

namespace epode::robots {

namespace {

void stop_at(dBodyID body, const Pose& pose)
{
    set_pose(body, pose);
    if (dBodyIsKinematic(body)) return;
    dBodySetLinearVel(body, 0, 0, 0);
    dBodySetAngularVel(body, 0, 0, 0);
}

}  // namespace

// A motor's force is clamped here, once; a servo's by the drive's own limit.
double Robot::clamped_force(size_t number) const
{
    const Actuator& a = model().actuators[number];
    const double force = a.muscle.acts ? pulls_[number] : a.gain * inputs_[number] + a.bias;
    return slope_of(number).is_servo() ? force : std::clamp(force, a.force_low, a.force_high);
}

// Small bodies stand where the joints before them have taken their link: the later ones are at the reference.
std::vector<double> Robot::held(const Small& small, std::vector<double> positions) const
{
    const Link& link = model().links[size_t(small.link)];
    const std::vector<double> reference = reference_positions(model());
    for (size_t k = small.joints_before; k < link.joints.size(); ++k) {
        const Joint& joint = model().joints[size_t(link.joints[k])];
        std::copy_n(&reference[size_t(joint.position)], joint.coordinates(),
                    &positions[size_t(joint.position)]);
    }
    return positions;
}

Pose Robot::frame_of(int link) const
{
    const int mover = movers_[size_t(link)];
    if (mover == 0) return placement_;
    const Link& its = model().links[size_t(mover)];
    return pose_of(body(mover)) * Pose{-its.centre, {}} * inverse(its.pose);
}

Pose Robot::link_pose(int link) const
{
    const dBodyID its = body(link);
    return its ? pose_of(its) * Pose{-model().links[size_t(link)].centre, {}} : placement_;
}

bool Robot::set_mocap(int link, const Pose& pose)
{
    if (link <= 0 || link >= int(bodies_.size()) || !model().links[size_t(link)].is_mocap) return false;
    const dBodyID its = body(link);
    set_pose(its, pose * Pose{model().links[size_t(link)].centre, {}});
    for (int i = 0; i < dBodyGetNumJoints(its); ++i)
        for (int side = 0; side < 2; ++side)
            if (const dBodyID other = dJointGetBody(dBodyGetJoint(its, i), side);
                other && !dBodyIsKinematic(other))
                dBodyEnable(other);
    return true;
}

void Robot::set_positions(const std::vector<double>& positions)
{
    if (positions.size() != size_t(model().coordinates)) return;
    pasts_.assign(pasts_.size(), {});
    holds_.assign(holds_.size(), 0);
    const std::vector<Pose> poses = forward_kinematics(model(), positions);
    for (size_t i = 1; i < poses.size(); ++i)
        if (bodies_[i] && !model().links[i].is_mocap)
            stop_at(bodies_[i], frame_of(int(i)) * poses[i] * Pose{model().links[i].centre, {}});
    for (const Small& small : small_) {
        const Pose pose = forward_kinematics(model(), held(small, positions))[size_t(small.link)];
        stop_at(small.body, frame_of(small.link) * pose * Pose{model().links[size_t(small.link)].centre, {}});
    }
    for (size_t i = 0; i < joints_.size(); ++i) {  // where all bodies are
        const Joint& joint = model().joints[i];
        const double position = positions[size_t(joint.position)] - joint.reference;
        if (joints_[i] && joint.kind == JointKind::kHinge) dJointSetAxisTurn(joints_[i], 0, dReal(position));
    }
    lay_tangents(positions);
}

std::vector<double> Robot::positions() const
{
    std::vector<double> q(size_t(model().coordinates), 0);
    const auto link_pose = [&](int link) {
        const dBodyID its = body(link);
        if (!its) return placement_ * Pose{};
        return pose_of(its) * Pose{-model().links[size_t(link)].centre, {}};
    };
    for (size_t i = 0; i < model().joints.size(); ++i) {
        const Joint& joint = model().joints[i];
        double* its = &q[size_t(joint.position)];
        if (joint.is_scalar()) {
            if (joints_[i]) its[0] = double(dJointGetAxisPosition(joints_[i], 0)) + joint.reference;
        } else if (joint.kind == JointKind::kFree) {
            const Pose pose = inverse(placement_) * link_pose(joint.link);
            const double values[7] = {pose.p.x, pose.p.y, pose.p.z, pose.q.w, pose.q.x, pose.q.y, pose.q.z};
            std::copy_n(values, 7, its);
        } else {
            const Link& link = model().links[size_t(joint.link)];
            const Quat turn = conjugate((link_pose(link.parent) * link.pose).q) * link_pose(joint.link).q;
            its[0] = turn.w, its[1] = turn.x, its[2] = turn.y, its[3] = turn.z;
        }
    }
    return q;
}

Robot::Motion Robot::motion_of(const std::vector<double>& positions,
                               const std::vector<double>& velocities) const
{
    return {forward_kinematics(model(), positions), link_velocities(model(), positions, velocities)};
}

void Robot::set_velocity(dBodyID its, int number, const Motion& motion) const
{
    const Link& link = model().links[size_t(number)];
    const LinkVelocity v = motion.velocities[size_t(number)];
    const Quat turn = motion.poses[size_t(number)].q;
    const Quat its_frame = frame_of(number).q;
    const Vec w = rotate(its_frame, v.angular);
    const Vec c = rotate(its_frame, v.linear + cross(v.angular, rotate(turn, link.centre)));
    dBodySetLinearVel(its, dReal(c.x), dReal(c.y), dReal(c.z));
    dBodySetAngularVel(its, dReal(w.x), dReal(w.y), dReal(w.z));
}

// A small body moves as its link would if the joints after it stood still.
void Robot::set_velocities(const std::vector<double>& velocities)
{
    if (velocities.size() != size_t(number_of_velocities(model()))) return;
    for (Past& past : pasts_) past.is_known = false;
    const std::vector<double> q = positions();
    const Motion motion = motion_of(q, velocities);
    for (size_t i = 1; i < bodies_.size(); ++i)
        if (bodies_[i] && !model().links[i].is_mocap) set_velocity(bodies_[i], int(i), motion);
    for (const Small& small : small_) {
        const Link& link = model().links[size_t(small.link)];
        std::vector<double> partial = velocities;
        for (size_t k = small.joints_before; k < link.joints.size(); ++k) {
            size_t first = 0;
            for (int j = 0; j < link.joints[k]; ++j)
                first += size_t(velocities_of(model().joints[size_t(j)]));
            std::fill_n(&partial[first], velocities_of(model().joints[size_t(link.joints[k])]), 0.0);
        }
        set_velocity(small.body, small.link, motion_of(held(small, q), partial));
    }
}

std::vector<double> Robot::velocities() const
{
    std::vector<double> out;
    const auto add = [&](Vec v) { out.insert(out.end(), {v.x, v.y, v.z}); };
    for (size_t i = 0; i < model().joints.size(); ++i) {
        const Joint& joint = model().joints[i];
        if (joint.is_scalar()) {
            out.push_back(joints_[i] ? double(dJointGetAxisRate(joints_[i], 0)) : 0);
            continue;
        }
        const Link& link = model().links[size_t(joint.link)];
        const dBodyID its = body(joint.link), parent = body(link.parent);
        Vec angular = vec_of(dBodyGetAngularVel(its));
        const Pose at = pose_of(its);
        if (joint.kind == JointKind::kFree) {
            const Vec linear = vec_of(dBodyGetLinearVel(its)) - cross(angular, rotate(at.q, link.centre));
            add(rotate(conjugate(placement_.q), linear));
        } else if (parent) {
            angular = angular - vec_of(dBodyGetAngularVel(parent));
        }
        add(rotate(conjugate(at.q), angular));
    }
    return out;
}

void Robot::set_servo(int joint, const Servo& servo)
{
    servos_[size_t(joint)] = servo;
    set_joint_drive(joint);
}

void Robot::set_joint_drive(int number)
{
    const Joint& joint = model().joints[size_t(number)];
    const Servo& servo = servos_[size_t(number)];
    if (joint.kind == JointKind::kBall) return set_turn_drive(number);
    if (!joint.is_scalar()) return;
    const double limit = servo.stiffness > 0 || servo.damping > 0 ? joint.max_force : kInfinity;
    const double largest = joint.max_force > 0 ? joint.max_force : kInfinity;
    set_drive({joints_[size_t(number)], joint.reference, joint.stiffness, joint.spring_reference,
               joint.damping, joint.armature, joint.friction},
              servo, limit, largest, prepared_->actuators_of_joint(number));
}

// Of a ball: a drive along each of the link's axes. With the rotation vector r an actuator with the gear g exerts
// g (G u + b0 - bp g.r - bv g.w); of one with bp or bv g has one component alone.
void Robot::set_turn_drive(int number)
{
    const dJointID its = turns_[size_t(number)];
    if (!its) return;
    const Joint& joint = model().joints[size_t(number)];
    for (int axis = 0; axis < 3; ++axis) {
        double k = 0, d = 0, force = 0, limit = kInfinity;
        for (int i : prepared_->actuators_of_joint(number)) {
            const Actuator& a = model().actuators[size_t(i)];
            const double g = a.direction[axis];
            if (g == 0) continue;
            const Slope slope = slope_of(size_t(i));
            k += g * g * slope.position, d += g * g * slope.velocity;
            force += g * clamped_force(size_t(i));
            if (slope.is_servo())
                limit = std::min(limit, std::fabs(g) * std::max(-a.force_low, a.force_high));
        }
        dDrive drive;
        dDriveInit(&drive, sizeof drive);
        k += joint.stiffness;
        drive.stiffness = dReal(std::max(0.0, k)), drive.damping = dReal(std::max(0.0, d) + joint.damping);
        drive.armature = dReal(joint.armature), drive.friction = dReal(joint.friction);
        drive.target = dReal(k > 0 ? force / k : 0), drive.force = dReal(k > 0 ? 0 : force);
        if (limit > 0 && limit < kInfinity) drive.force_limit = dReal(limit);
        dJointSetDrive(its, axis, &drive);
    }
}

void Robot::set_drives()
{
    for (size_t i = 0; i < model().joints.size(); ++i) set_joint_drive(int(i));
    for (size_t i = 0; i < model().tendons.size(); ++i) set_tendon_drive(int(i));
}

void Robot::set_tendon_drive(int number)
{
    const Tendon& tendon = model().tendons[size_t(number)];
    double r = 0;
    for (const Coupling::Term& term : tendon.terms)
        r += term.factor * model().joints[size_t(term.joint)].reference;
    set_drive({tendons_[size_t(number)], r, tendon.stiffness, prepared_->rests()[size_t(number)][0],
               tendon.damping, tendon.armature, tendon.friction},
              {}, kInfinity, kInfinity, prepared_->actuators_of_tendon(number));
}

int Robot::add_lifts() const
{
    int count = 0;
    dVector3 g;
    dWorldGetGravity(world_, g);
    for (size_t i = 1; i < bodies_.size(); ++i) {
        const dBodyID its = bodies_[i];
        const Link& link = model().links[i];
        if (link.lifts.empty() || !its || !dBodyIsEnabled(its) || dBodyIsKinematic(its)) continue;
        const Pose at = pose_of(its) * Pose{-link.centre, {}};
        for (const Lift& lift : link.lifts) {
            const Vec force = (-lift.share * lift.mass) * vec_of(g);
            add_force(its, force, cross(at * lift.centre - vec_of(dBodyGetPosition(its)), force));
            ++count;
        }
    }
    return count;
}

// Added to what the program's own forces have gathered. Bodies that sleep or are moved by the program have none.
int Robot::add_fluid_forces(double stepsize)
{
    int count = 0;
    const Vec wind = rotate(placement_.q, model().medium.wind);
    for (size_t i = 1; i < bodies_.size(); ++i) {
        const dBodyID its = bodies_[i];
        if (!its || !dBodyIsEnabled(its) || dBodyIsKinematic(its)) continue;
        for (const FluidBox& box : model().links[i].boxes) {
            const Pose at = pose_of(its) * Pose{-model().links[i].centre, {}} * box.pose;
            const Quat back = conjugate(at.q);
            const Vec w = vec_of(dBodyGetAngularVel(its)), arm = at.p - vec_of(dBodyGetPosition(its));
            const Vec v = vec_of(dBodyGetLinearVel(its)) + cross(w, arm) - wind;
            const FluidForce felt =
                fluid_force(box, model().medium, rotate(back, v), rotate(back, w), stepsize);
            const Vec force = rotate(at.q, felt.force);
            const Vec torque = rotate(at.q, felt.torque) + cross(arm, force);
            add_force(its, force, torque);
            ++count;
        }
    }
    return count;
}

void Robot::set_drive(const Passive& passive, const Servo& servo, double limit, double largest,
                      const std::vector<int>& actuators)
{
    if (!passive.id) return;
    const double r = passive.reference;
    double k = passive.stiffness + servo.stiffness, d = passive.damping + servo.damping;
    double sum = passive.stiffness * (passive.rest - r) + servo.stiffness * (servo.target - r), motors = 0;
    for (int i : actuators) {
        const Actuator& a = model().actuators[size_t(i)];
        const double g = a.gear;
        const Slope slope = slope_of(size_t(i));
        k += g * g * slope.position, d += g * g * slope.velocity;
        const bool is_servo = slope.is_servo();
        (is_servo ? sum : motors) += g * (clamped_force(size_t(i)) - slope.position * g * r);
        if (is_servo) limit = std::min({limit, largest, std::fabs(g) * std::max(-a.force_low, a.force_high)});
    }
    sum += std::clamp(motors, -largest, largest);
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    const bool acts = k > 0 || d > 0 || sum != 0 || passive.armature > 0 || passive.friction > 0;
    if (!acts && !dJointGetDrive(passive.id, 0, &drive)) return;
    drive.stiffness = dReal(std::max(0.0, k)), drive.damping = dReal(std::max(0.0, d));
    drive.armature = dReal(passive.armature), drive.friction = dReal(passive.friction);
    drive.target = dReal(k > 0 ? sum / k : 0), drive.force = dReal(k > 0 ? 0 : sum);
    if (limit > 0 && limit < kInfinity) drive.force_limit = dReal(limit);
    dJointSetDrive(passive.id, 0, acts ? &drive : nullptr);
}

}  // namespace epode::robots
