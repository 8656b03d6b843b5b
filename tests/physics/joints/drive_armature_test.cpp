// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Armatures on joints with several axes, against chains of hinges and sliders that do the same: small bodies of 1 mg
// stand between them. Both move in space, so that every axis is turned by others; steps of h and h/2 are
// extrapolated to h = 0, where the two are the same mechanism.
#include <array>

#include "drive_ways.h"

namespace epode::physics {
namespace {

struct Link {
    bool slides;
    V3 axis;
    int joint_axis;  // of the joint that the chain stands for
};

struct Mechanism {
    const char* name;
    std::vector<Link> links;  // from the first body to the second one
    dJointID (*make)(dWorldID, dBodyID, dBodyID);
};

const V3 kU{0.6, 0.48, 0.64}, kV{0, -0.8, 0.6}, kW{0.8, -0.36, -0.48};  // w = u x v
const V3 kAnchor{0.1, -0.2, 0.15};

void attach(dJointID joint, dBodyID a, dBodyID b) { dJointAttach(joint, a, b); }

template <class Set>
void set_axis(Set set, dJointID joint, V3 axis)
{
    set(joint, real(axis.x), real(axis.y), real(axis.z));
}

dJointID make_universal(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID joint = dJointCreateUniversal(world, nullptr);
    attach(joint, a, b);
    set_axis(dJointSetUniversalAnchor, joint, kAnchor);
    set_axis(dJointSetUniversalAxis1, joint, kU), set_axis(dJointSetUniversalAxis2, joint, kV);
    return joint;
}

dJointID make_hinge2(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID joint = dJointCreateHinge2(world, nullptr);
    const dVector3 u{real(kU.x), real(kU.y), real(kU.z)}, v{real(kV.x), real(kV.y), real(kV.z)};
    attach(joint, a, b);
    set_axis(dJointSetHinge2Anchor, joint, kAnchor);
    dJointSetHinge2Axes(joint, u, v);
    dJointSetHinge2Param(joint, dParamSuspensionERP, real(0.2)),
        dJointSetHinge2Param(joint, dParamSuspensionCFM, 0);
    return joint;
}

dJointID make_piston(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID joint = dJointCreatePiston(world, nullptr);
    attach(joint, a, b);
    set_axis(dJointSetPistonAnchor, joint, kAnchor), set_axis(dJointSetPistonAxis, joint, kU);
    return joint;
}

dJointID make_pr(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID joint = dJointCreatePR(world, nullptr);
    attach(joint, a, b);
    set_axis(dJointSetPRAnchor, joint, kAnchor);
    set_axis(dJointSetPRAxis1, joint, kU), set_axis(dJointSetPRAxis2, joint, kV);
    return joint;
}

dJointID make_pu(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID joint = dJointCreatePU(world, nullptr);
    attach(joint, a, b);
    set_axis(dJointSetPUAnchor, joint, kAnchor);
    set_axis(dJointSetPUAxis1, joint, kU), set_axis(dJointSetPUAxis2, joint, kV);
    set_axis(dJointSetPUAxis3, joint, kW);
    return joint;
}

dJointID make_shoulder(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID ball = dJointCreateBall(world, nullptr), joint = dJointCreateAMotor(world, nullptr);
    attach(ball, a, b), attach(joint, a, b);
    set_axis(dJointSetBallAnchor, ball, kAnchor);
    dJointSetAMotorMode(joint, dAMotorEuler);
    dJointSetAMotorAxis(joint, 0, 1, real(kU.x), real(kU.y), real(kU.z));
    dJointSetAMotorAxis(joint, 2, 2, real(kV.x), real(kV.y), real(kV.z));
    return joint;
}

const Mechanism kMechanisms[] = {
    {"universal", {{false, kU, 0}, {false, kV, 1}}, make_universal},
    {"hinge2", {{false, kU, 0}, {false, kV, 1}}, make_hinge2},
    {"piston", {{true, kU, 0}, {false, kU, 1}}, make_piston},
    {"pr", {{true, kU, 0}, {false, kV, 1}}, make_pr},
    {"pu", {{true, kW, 2}, {false, kU, 0}, {false, kV, 1}}, make_pu},
    {"shoulder", {{false, kU, 0}, {false, kW, 1}, {false, kV, 2}}, make_shoulder},
};

// All turns about the origin, and each link of the chain moves at a rate of its own.
class Pair {
  public:
    Pair(const Mechanism& mechanism, bool is_chain) : mechanism_(mechanism)
    {
        dWorldSetCFM(sim_.world, 0);
        first_ = sim_.body({0.2, -0.1, 0.5}, 2, 0.3), second_ = sim_.body({-0.1, 0.3, -0.4}, 1, 0.2);
        move(first_, 0), move(second_, mechanism.links.size());
        is_chain ? add_chain() : add_joint();
    }

    std::array<double, 6> speeds_after(double time, double h)
    {
        for (int i = 0, n = int(time / h + 0.5); i < n; ++i) dWorldStep(sim_.world, real(h));
        const V3 v = velocity(second_), w = spin(second_);
        return {v.x, v.y, v.z, w.x, w.y, w.z};
    }

  private:
    void move(dBodyID body, std::size_t links)
    {
        constexpr double kRates[] = {1.3, -1.7, 0.9};
        const V3 x = position(body);
        V3 w{0.8, -1.5, 1.1}, v = cross(w, x);
        for (std::size_t i = 0; i < links; ++i) {
            const Link& link = mechanism_.links[i];
            v = v + kRates[i] * (link.slides ? link.axis : cross(link.axis, x - kAnchor));
            if (!link.slides) w = w + kRates[i] * link.axis;
        }
        velocity(body, v, w);
    }

    static void drive(dJointID joint, int axis, std::size_t link)
    {
        dDrive drive = no_drive();
        drive.armature = real(0.5 + 0.4 * double(link)), drive.stiffness = 5, drive.damping = real(0.3);
        ASSERT_EQ(dJointSetDrive(joint, axis, &drive), 1);
    }

    void add_joint()
    {
        const dJointID joint = mechanism_.make(sim_.world, first_, second_);
        for (std::size_t i = 0; i < mechanism_.links.size(); ++i)
            drive(joint, mechanism_.links[i].joint_axis, i);
    }

    void add_chain()
    {
        dBodyID last = first_;
        for (std::size_t i = 0; i < mechanism_.links.size(); ++i) {
            const Link& link = mechanism_.links[i];
            const bool ends = i + 1 == mechanism_.links.size();
            const dBodyID next = ends ? second_ : sim_.body(kAnchor, 1e-6, 1e-7);
            if (!ends) move(next, i + 1);
            const dJointID joint = link.slides ? dJointCreateSlider(sim_.world, nullptr)
                                               : dJointCreateHinge(sim_.world, nullptr);
            attach(joint, last, next);
            if (!link.slides) set_axis(dJointSetHingeAnchor, joint, kAnchor);
            set_axis(link.slides ? dJointSetSliderAxis : dJointSetHingeAxis, joint, link.axis);
            drive(joint, 0, i);
            last = next;
        }
    }

    const Mechanism& mechanism_;
    Sim sim_;
    dBodyID first_, second_;
};

TEST(Armature, of_several_axes_is_that_of_a_chain)
{
    if (sizeof(dReal) < 8) GTEST_SKIP() << "bodies of 1 mg next to 1 kg are for doubles";
    for (const Mechanism& mechanism : kMechanisms) {
        SCOPED_TRACE(mechanism.name);
        std::array<std::array<double, 6>, 2> limit;
        for (const bool is_chain : {false, true}) {
            const auto coarse = Pair(mechanism, is_chain).speeds_after(0.2, 5e-4);
            const auto fine = Pair(mechanism, is_chain).speeds_after(0.2, 2.5e-4);
            for (std::size_t i = 0; i < 6; ++i) limit[is_chain][i] = 2 * fine[i] - coarse[i];
        }
        for (std::size_t i = 0; i < 6; ++i) EXPECT_NEAR(limit[0][i], limit[1][i], 1e-4) << i;
    }
}

}  // namespace
}  // namespace epode::physics
