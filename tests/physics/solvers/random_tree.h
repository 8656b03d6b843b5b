// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Random mechanisms in a world of the robot preset, and what the tests of joint coordinates ask of them.
#pragma once

#include <ode/defaults.h>
#include <ode/report.h>

#include <algorithm>
#include <vector>

#include "rig.h"

namespace epode::physics {

inline constexpr double kGravity = 9.81;

// In which two methods are compared: what they differ by is of second order in it. In floats the gap of a joint, four roundings of places at 2
// to 4 m, is a velocity of ERP (0.2) of it over h, at arms of 0.1 m, and a force over h^2; with what is of second order (5e-5 at 5 ms) it
// is least where h^3 is some rounding.
inline constexpr double kShortStep = kSingle ? 5e-3 : 1e-4;
inline constexpr double kGapVelocity = 5e-5 + 0.2 * 4 * kEpsilon / kShortStep / 0.1;

// A tree of bodies on joints of four types, of which some are driven, have a motor or lie beyond a stop.
class RandomTree {
  public:
    RandomTree(std::uint32_t seed, bool in_joints, bool free, bool active = true, int bodies = 9)
        : random_(seed)
    {
        dWorldUseDefaults(sim_.world, dDefaultsRobot);
        dWorldSetGravity(sim_.world, 0, 0, real(-kGravity));
        dWorldSetJointCoordinates(sim_.world, in_joints ? 1 : 0);
        dWorldSetStepReportMode(sim_.world, 1);
        bodies_.push_back(make_body({0, 0, 2}));
        if (!free) connect(nullptr, bodies_[0], 0, active);
        for (int i = 1; i < bodies; ++i) {
            const dBodyID parent = bodies_[std::size_t(random_.uniform(0, i))];
            const V3 at = vec(dBodyGetPosition(parent)) + random_.point(0.4);
            bodies_.push_back(make_body(at));
            connect(parent, bodies_.back(), i, active);
        }
    }

    dBodyID make_body(V3 at)
    {
        const dBodyID body = sim_.body(at, random_.uniform(0.5, 2), 0);
        dMass mass;
        dMassSetBoxTotal(&mass, real(random_.uniform(0.5, 2)), real(random_.uniform(0.1, 0.5)),
                         real(random_.uniform(0.1, 0.5)), real(random_.uniform(0.1, 0.5)));
        dBodySetMass(body, &mass);
        dQuaternion q;
        random_.quaternion(q);
        dBodySetQuaternion(body, q);
        return body;
    }

    void connect(dBodyID parent, dBodyID child, int i, bool active)
    {
        const V3 anchor = vec(dBodyGetPosition(child)) + random_.point(0.2), axis = random_.point(1);
        const bool turned = random_.uniform(0, 1) < 0.5;
        dJointID joint;
        const auto attach = [&](dJointID j) {
            turned ? dJointAttach(j, parent, child) : dJointAttach(j, child, parent);
        };
        switch (i % 4) {
            case 0:
                attach(joint = dJointCreateBall(sim_.world, nullptr));
                dJointSetBallAnchor(joint, real(anchor.x), real(anchor.y), real(anchor.z));
                break;
            case 1:
            case 2:
                attach(joint = dJointCreateHinge(sim_.world, nullptr));
                dJointSetHingeAnchor(joint, real(anchor.x), real(anchor.y), real(anchor.z));
                dJointSetHingeAxis(joint, real(axis.x), real(axis.y), real(axis.z));
                break;
            default:
                if (i == 7) {
                    attach(joint = dJointCreateFixed(sim_.world, nullptr));
                    dJointSetFixed(joint);
                    break;
                }
                attach(joint = dJointCreateSlider(sim_.world, nullptr));
                dJointSetSliderAxis(joint, real(axis.x), real(axis.y), real(axis.z));
        }
        if (active) drive(joint, i);
        joints_.push_back(joint);
        feedbacks_.emplace_back();
    }

    void drive(dJointID joint, int i)
    {
        const int type = dJointGetType(joint);
        if (type != dJointTypeHinge && type != dJointTypeSlider) return;
        const auto set = [&](int parameter, double value) {
            type == dJointTypeHinge ? dJointSetHingeParam(joint, parameter, real(value))
                                    : dJointSetSliderParam(joint, parameter, real(value));
        };
        if (i % 3 == 0) {
            set(dParamVel, random_.uniform(-1e-3, 1e-3)), set(dParamFMax, random_.uniform(0.1, 3));
        } else if (i % 3 == 1) {
            set(dParamHiStop, 0.5), set(dParamLoStop, 0);
        }
        if (i % 2 == 0) return;
        dDrive servo;
        dDriveInit(&servo, sizeof servo);
        servo.armature = real(random_.uniform(0, 0.1)), servo.damping = real(random_.uniform(0, 1));
        servo.stiffness = real(random_.uniform(0, 10)), servo.target = real(0.3);
        if (i % 4 == 1) servo.force_limit = real(random_.uniform(0.1, 1)), servo.friction = real(0.1);
        dJointSetDrive(joint, 0, &servo);
    }

    void watch_forces()
    {
        for (std::size_t i = 0; i < joints_.size(); ++i) dJointSetFeedback(joints_[i], &feedbacks_[i]);
    }

    double kinetic_and_weight() const
    {
        double sum = 0;
        for (const dBodyID b : bodies_) {
            dMass mass;
            dBodyGetMass(b, &mass);
            const V3 v = vec(dBodyGetLinearVel(b)), w = vec(dBodyGetAngularVel(b));
            const dReal* const R = dBodyGetRotation(b);
            double local[3], turning = 0;
            for (int k = 0; k < 3; ++k)
                local[k] = double(R[k]) * w.x + double(R[4 + k]) * w.y + double(R[8 + k]) * w.z;
            for (int k = 0; k < 3; ++k)
                for (int l = 0; l < 3; ++l) turning += local[k] * double(mass.I[4 * k + l]) * local[l];
            sum += 0.5 * double(mass.mass) * dot(v, v) + 0.5 * turning +
                   double(mass.mass) * kGravity * vec(dBodyGetPosition(b)).z;
        }
        return sum;
    }

    Sim sim_;
    Random random_;
    std::vector<dBodyID> bodies_;
    std::vector<dJointID> joints_;
    std::vector<dJointFeedback> feedbacks_;
};

inline int method_of(dWorldID world)
{
    dIslandStepReport report;
    report.struct_size = sizeof report;
    return dWorldGetIslandStepReport(world, 0, &report) ? report.method : -1;
}

inline double joint_error(dWorldID world)
{
    dWorldStepReport report;
    report.struct_size = sizeof report;
    dWorldGetStepReport(world, &report);
    return std::max(report.joint_error, report.joint_angle_error);
}

inline double worst_difference(const RandomTree& a, const RandomTree& b)
{
    double worst = 0;
    for (std::size_t i = 0; i < a.bodies_.size(); ++i) {
        worst = std::max(worst,
                         length(vec(dBodyGetLinearVel(a.bodies_[i])) - vec(dBodyGetLinearVel(b.bodies_[i]))));
        worst = std::max(
            worst, length(vec(dBodyGetAngularVel(a.bodies_[i])) - vec(dBodyGetAngularVel(b.bodies_[i]))));
    }
    return worst;
}

}  // namespace epode::physics
