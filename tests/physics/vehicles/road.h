// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world with gravity, a flat road and vehicles, for tests of vehicles. x is forward, z up. The car weighs 1,200 kg
// and has its centre of mass in the middle of four wheels, the rear ones driven; its tyres lose nothing in slip and
// with load, and nothing else brakes it, so that closed forms are exact.
#pragma once

#include <gtest/gtest.h>
#include <ode/compatibility.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

namespace epode::vehicles {

constexpr double kG = 9.81, kMass = 1200, kBase = 2.6, kTrack = 1.5, kRadius = 0.33, kHub = -0.4;

struct Wheels {
    double front = kBase / 2, rear = -kBase / 2;
    dVehicleWheel like{};  // all of them, but for place, axle, steer and drive
    Wheels()
    {
        dVehicleWheelInit(&like, sizeof like);
        like.radius = dReal(kRadius);
        like.load_sensitivity = like.rolling_resistance = 0;
        like.sliding = 1;
        like.friction_x = like.friction_y = 1;
    }
};

inline dVehicleSettings plain_settings()
{
    dVehicleSettings s;
    dVehicleSettingsInit(&s, sizeof s);
    s.drag = 0;
    s.automatic = 0;
    return s;
}

struct Road {
    explicit Road(double slope = 0, int defaults = 0)
    {
        dInitODE();
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        if (defaults) dWorldUseDefaults(world, defaults);
        dWorldSetGravity(world, dReal(-kG * std::sin(slope)), 0, dReal(-kG * std::cos(slope)));
        dWorldSetContactSpace(world, space);
    }
    ~Road()
    {
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    Road(const Road&) = delete;
    Road& operator=(const Road&) = delete;

    void flat() const { dCreatePlane(space, 0, 0, 1, 0); }
    // At rest, or moving forward with the wheels rolling.
    dBodyID chassis(double z, double speed = 0, double mass = kMass) const
    {
        const dBodyID body = dBodyCreate(world);
        dMass m;
        dMassSetBoxTotal(&m, dReal(mass), dReal(4), dReal(1.6), dReal(0.6));
        dBodySetMass(body, &m);
        dGeomSetBody(dCreateBox(space, 4, dReal(1.6), dReal(0.4)), body);
        dBodySetPosition(body, 0, 0, dReal(z));
        dBodySetLinearVel(body, dReal(speed), 0, 0);
        return body;
    }
    // Where it rests on its springs.
    static double height(const dVehicleWheel& w, double mass = kMass)
    {
        return kRadius - kHub - mass * kG / (4 * w.stiffness);
    }
    dBodyID car(const Wheels& wheels = {}, const dVehicleSettings& s = plain_settings(),
                double speed = 0) const
    {
        const dBodyID body = chassis(height(wheels.like), speed);
        EXPECT_EQ(dVehicleCreate(body, &s), 1);
        for (int i = 0; i < 4; ++i) {
            dVehicleWheel w = wheels.like;
            w.position[0] = dReal(i < 2 ? wheels.front : wheels.rear);
            w.position[1] = dReal(i % 2 ? -kTrack / 2 : kTrack / 2);
            w.position[2] = dReal(kHub);
            w.axle = i / 2;
            if (w.steer == 0) w.steer = dReal(i < 2);
            if (w.drive == 0) w.drive = dReal(i >= 2);
            EXPECT_EQ(dVehicleAddWheel(body, &w), i + 1);
        }
        return body;
    }
    void run(dBodyID car, double seconds, double h) const
    {
        for (int i = int(seconds / h + 0.5); i-- > 0;) {
            dVehicleUpdate(car, dReal(h));
            dWorldStep(world, dReal(h));
        }
    }

    dWorldID world;
    dSpaceID space;
};

inline dVehicleControls no_controls()
{
    dVehicleControls c{};
    c.struct_size = sizeof c;
    return c;
}
inline void drive(dBodyID car, double throttle, double brake = 0, double steer = 0, double handbrake = 0,
                  double clutch = 0)
{
    dVehicleControls c = no_controls();
    c.throttle = dReal(throttle), c.brake = dReal(brake), c.steer = dReal(steer);
    c.handbrake = dReal(handbrake), c.clutch = dReal(clutch);
    EXPECT_EQ(dVehicleSetControls(car, &c), 1);
}
inline dVehicleReport report(dBodyID car)
{
    dVehicleReport r{};
    r.struct_size = sizeof r;
    EXPECT_EQ(dVehicleGetReport(car, &r), 1);
    return r;
}
inline dVehicleWheelReport wheel(dBodyID car, int i)
{
    dVehicleWheelReport r{};
    r.struct_size = sizeof r;
    EXPECT_EQ(dVehicleGetWheelReport(car, i, &r), 1);
    return r;
}
inline double speed(dBodyID car) { return std::hypot(dBodyGetLinearVel(car)[0], dBodyGetLinearVel(car)[1]); }
inline double x_of(dBodyID car) { return dBodyGetPosition(car)[0]; }
inline double z_of(dBodyID car) { return dBodyGetPosition(car)[2]; }

// One of the four steppers.
constexpr int kSteppers = 4;
inline void step_by(dWorldID world, double h, int stepper)
{
    switch (stepper) {
        case 0:
            dWorldStep(world, dReal(h));
            break;
        case 1:
            dWorldQuickStep(world, dReal(h));
            break;
        case 2:
            dWorldStepFast1(world, dReal(h), 4);
            break;
        default:
            dWorldStepHybrid(world, dReal(h));
    }
}

// Each test of motion at three sizes of the step.
class EveryStep : public testing::TestWithParam<double> {
  protected:
    double h() const { return GetParam(); }
};
inline const auto kSteps = testing::Values(1.0 / 60, 1.0 / 240, 1.0 / 1000);
inline std::string step_name(const testing::TestParamInfo<double>& info)
{
    return std::to_string(int(1 / info.param + 0.5)) + "_hz";
}

}  // namespace epode::vehicles
