// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The guide's car in C++: a chassis on four hinge-2 wheels, steered and driven by the front wheels'
// parameters, with the suspension of dParamSuspensionERP and CFM, on a plane with tyre slip. It must settle
// on its springs, reach the speed of its wheels, drive straight, and turn when it is steered.
#include <ode/ode.h>

#include "check.h"

namespace {

const dReal kRadius = REAL(0.2), kStep = REAL(0.01);

struct Buggy {
    dWorld world;
    dHashSpace space;
    dJointGroup contacts;
    dBody chassis, wheel[4];
    dBox box;
    dSphere tyre[4];
    dHinge2Joint axle[4];
    dPlane ground;

    Buggy() : chassis(world), ground(space, 0, 0, 1, 0)
    {
        space.setCleanup(0);
        world.setGravity(0, 0, REAL(-9.81));
        dMass mass;
        mass.setBoxTotal(20, REAL(1.4), REAL(0.8), REAL(0.2));
        chassis.setMass(mass);
        chassis.setPosition(0, 0, REAL(0.35));
        box.create(space, REAL(1.4), REAL(0.8), REAL(0.2));
        box.setBody(chassis);
        for (int i = 0; i < 4; ++i)
            add_wheel(i, i < 2 ? REAL(0.6) : REAL(-0.6), i % 2 ? REAL(0.5) : REAL(-0.5));
    }

    void add_wheel(int i, dReal x, dReal y)
    {
        const dReal up[3] = {0, 0, 1}, across[3] = {0, 1, 0};
        dMass mass;
        mass.setSphereTotal(1, kRadius);
        wheel[i].create(world);
        wheel[i].setMass(mass);
        wheel[i].setPosition(x, y, REAL(0.2));
        tyre[i].create(space, kRadius);
        tyre[i].setBody(wheel[i]);
        axle[i].create(world);
        axle[i].attach(chassis, wheel[i]);
        axle[i].setAnchor(wheel[i].getPosition());
        axle[i].setAxes(up, across);
        const dReal kp = 2000, kd = 100;
        axle[i].setParam(dParamSuspensionERP, kStep * kp / (kStep * kp + kd));
        axle[i].setParam(dParamSuspensionCFM, 1 / (kStep * kp + kd));
        steer(i, 0);
    }

    void steer(int i, dReal angle)
    {
        axle[i].setParam(dParamLoStop, angle);
        axle[i].setParam(dParamHiStop, angle);
        axle[i].setParam(dParamLoStop, angle);
        axle[i].setParam(dParamStopERP, REAL(0.8));
    }

    void drive(dReal speed, dReal torque)
    {
        for (int i = 0; i < 2; ++i) {
            axle[i].setParam(dParamVel2, -speed / kRadius);
            axle[i].setParam(dParamFMax2, torque);
        }
    }

    static void near_callback(void* data, dGeomID a, dGeomID b)
    {
        Buggy& buggy = *static_cast<Buggy*>(data);
        if (a != buggy.ground.id() && b != buggy.ground.id()) return;
        dContact contact[4];
        const int count = dCollide(a, b, 4, &contact[0].geom, sizeof contact[0]);
        for (int i = 0; i < count; ++i) {
            contact[i].surface.mode = dContactSlip1 | dContactSlip2 | dContactApprox1;
            contact[i].surface.mu = 2;
            contact[i].surface.slip1 = contact[i].surface.slip2 = REAL(0.001);
            dContactJoint joint(buggy.world, buggy.contacts, &contact[i]);
            joint.attach(dGeomGetBody(a), dGeomGetBody(b));
        }
    }

    void run(double seconds)
    {
        for (int i = 0; i < int(seconds / kStep + 0.5); ++i) {
            space.collide(this, near_callback);
            world.step(kStep);
            contacts.clear();
        }
    }

  private:
    Buggy(const Buggy&);
    void operator=(const Buggy&);
};

}  // namespace

int main()
{
    dInitODE();
    {
        Buggy buggy;
        buggy.run(2);
        expect_close("the springs give by m g / (4 kp), m", 0.35 - buggy.chassis.getPosition()[2],
                     20 * 9.81 / 8000, 3e-3);
        expect("the wheels carry it", buggy.chassis.isConnectedTo(buggy.wheel[0]));

        buggy.drive(3, 10);
        buggy.run(5);
        expect_close("it reaches the speed of its wheels, m/s", buggy.chassis.getLinearVel()[0], 3, 0.05);
        expect_close("and drives straight, m", buggy.chassis.getPosition()[1], 0, 0.05);
        expect("forwards", buggy.chassis.getPosition()[0] > 8);
        expect_close("steering angle reads what is set, rad", buggy.axle[0].getAngle1(), 0, 0.01);

        buggy.steer(0, REAL(0.3));
        buggy.steer(1, REAL(0.3));
        buggy.run(2);
        expect("steered, it turns", std::fabs(buggy.chassis.getAngularVel()[2]) > 0.3);
        expect_close("by the angle set, rad", buggy.axle[0].getAngle1(), 0.3, 0.02);
    }
    dCloseODE();
    return 0;
}
