// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What stands by friction on a slope stands still, however its parts are joined.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

enum class Legs { kGeoms, kFixed, kHinges };

dBodyID build(Stage& stage, Legs legs)
{
    const dBodyID top = stage.box({0.5, 0.5, 0.1}, 10, {0, 0, 0.25});
    for (int i = 0; i < 3; ++i) {
        const Vec at = rotate(turn(kZ, i * 2 * kPi / 3), {0.25, 0, 0}) + 0.1 * kZ;
        if (legs == Legs::kGeoms) {
            const dGeomID geom = dCreateSphere(stage.space, 0.1);
            dGeomSetBody(geom, top);
            dGeomSetMaterial(geom, &stage.surface);
            dGeomSetOffsetPosition(geom, at.x, at.y, at.z - 0.25);
            continue;
        }
        const dBodyID ball = stage.ball(0.1, 1, at);
        if (legs == Legs::kFixed) {
            stage.fix(ball, top);
        } else {
            const dJointID hinge = stage.hinge(ball, top, at, kY);
            dJointSetHingeParam(hinge, dParamFMax, 100);
        }
    }
    return top;
}

void stand(Run& run)
{
    for (Legs legs : {Legs::kGeoms, Legs::kFixed, Legs::kHinges}) {
        Stage stage(run, {1.5, 0, -9.7});
        stage.surface.friction = 1;
        stage.floor();
        const dBodyID top = build(stage, legs);
        stage.advance(1);
        const Vec start = position(top);
        const Turn turned = orientation(top);
        stage.advance(19);
        const Turn since = orientation(top) * inverse(turned);
        run.record("moved", 1000 * length(position(top) - start));
        run.record("turned", degrees(2 * std::asin(std::min(1.0, length({since.x, since.y, since.z})))));
        run.record("speed", length(velocity(top)));
    }
}

// A car in the preset of its method drives straight ahead: it is its own mirror image.
struct Car {
    dBodyID chassis, wheel[4];
    dJointID joint[4];
};

Car build_car(Stage& stage)
{
    Car car;
    stage.surface.friction = 1;
    stage.floor();
    car.chassis = stage.bar({4.2, 1.6, 0.5}, 1200, {0, 0, 1});
    for (int i = 0; i < 4; ++i) {
        const Vec at{i < 2 ? 1.35 : -1.35, i % 2 ? 0.9 : -0.9, 0.33};
        car.wheel[i] = stage.ball(0.33, 20, at);
        dBodySetFiniteRotationMode(car.wheel[i], 1);
        car.joint[i] = dJointCreateHinge2(stage.world, nullptr);
        dJointAttach(car.joint[i], car.chassis, car.wheel[i]);
        dJointSetHinge2Anchor(car.joint[i], at.x, at.y, at.z);
        const dReal up[3] = {0, 0, 1}, axle[3] = {0, 1, 0};
        dJointSetHinge2Axes(car.joint[i], up, axle);
        dJointSetSpring(car.joint[i], 45000, 4000);
        for (int stop : {dParamLoStop, dParamHiStop})
            dJointSetHinge2Param(car.joint[i], stop, i < 2 ? (stop == dParamLoStop ? -0.5 : 0.5) : 0);
        if (i < 2) {
            dDrive drive;
            dDriveInit(&drive, sizeof drive);
            drive.stiffness = 20000;
            drive.damping = 500;
            dJointSetDrive(car.joint[i], 0, &drive);
        } else {
            dJointSetHinge2Param(car.joint[i], dParamVel2, -40 / 0.33);
            dJointSetHinge2Param(car.joint[i], dParamFMax2, 600);
        }
    }
    return car;
}

void drive(Run& run)
{
    Stage stage(run);
    const Car car = build_car(stage);
    stage.advance(
        20, [&] { run.record("steering", degrees(std::fabs(dJointGetAxisPosition(car.joint[0], 0)))); });
    run.record("aside", std::fabs(position(car.chassis).y));
    run.record("speed", 100 * std::fabs(velocity(car.chassis).x / 40 - 1));
}

}  // namespace

extern const Scene kStand{"Rest",
                          "stand",
                          "a table on three balls, of one body, on fixed joints and on held hinges, on a "
                          "slope of 9 degrees, 20 s (C14)",
                          {{"moved",
                            "way from 1 s on",
                            "mm",
                            0.5,
                            {{kSweeps | Method::kSubsteps, 5, "Sweeps do not converge (guide/steppers.md)"}}},
                           {"turned", "turn from 1 s on", "degrees", 0.05},
                           {"speed", "speed at the end", "m/s", 1e-3}},
                          &stand};

extern const Scene kCar{
    "Machines",
    "car",
    "a car on hinge-2 wheels with springs, drives and steering at 0 goes straight ahead at 40 m/s, 20 s",
    {{"aside", "way aside", "m", 0.1},
     {"steering", "largest angle of a steered wheel", "degrees", 0.1},
     {"speed", "speed at the end, off 40 m/s", "%", 2}},
    &drive};

}  // namespace epode::trials
