// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Stops and motors of Euler angles where the outer axes are nearly parallel: two bodies on a ball joint with an angular motor.
#include <algorithm>
#include <cmath>

#include "scenes.h"

namespace epode::physics {
namespace {

using Step = int (*)(dWorldID, dReal);
enum Number { kExact, kQuick, kSubsteps, kHybrid, kExactJoints };
struct Way {
    Number number;
    Step step;
};
int step_in_substeps(dWorldID world, dReal h) { return dWorldStepFast1(world, h, 4); }
int step_with_exact_joints(dWorldID world, dReal h)
{
    dWorldSetHybridStepper(world, dStepperSubstepsExactJoints);
    return dWorldStepHybrid(world, h);
}
constexpr Way kWays[] = {{kExact, dWorldStep},
                         {kQuick, dWorldQuickStep},
                         {kSubsteps, step_in_substeps},
                         {kHybrid, dWorldStepHybrid},
                         {kExactJoints, step_with_exact_joints}};
constexpr int kPairs = 40;
constexpr double kMass = 1, kInertia = 0.1, kArm = 0.5,
                 kFastest = 12.3;  // the spins of both bodies in one, rad/s
constexpr int kPresets[] = {dDefaultsOde, dDefaultsGame, dDefaultsRobot};

struct Pair {
    Pair(Sim& sim, double x, double y, double z)
    {
        a = sim.body({0, 0, 0}, kMass, kInertia), b = sim.body({0, 0, 1}, kMass, kInertia);
        ball = dJointCreateBall(sim.world, nullptr);
        dJointAttach(ball, a, b);
        dJointSetBallAnchor(ball, 0, 0, real(kArm));
        motor = dJointCreateAMotor(sim.world, nullptr);
        dJointAttach(motor, a, b);
        dJointSetAMotorMode(motor, dAMotorEuler);
        dJointSetAMotorAxis(motor, 0, 1, 1, 0, 0);
        dJointSetAMotorAxis(motor, 2, 2, 0, 0, 1);
        turn(x, y, z);
    }
    // Body 1 by these angles about x, y, z, on its ball.
    void turn(double x, double y, double z)
    {
        dMatrix3 X, Y, Z, YX, R;
        dRFromAxisAndAngle(X, 1, 0, 0, real(x));
        dRFromAxisAndAngle(Y, 0, 1, 0, real(y));
        dRFromAxisAndAngle(Z, 0, 0, 1, real(z));
        dMultiply0(YX, Y, X, 3, 3, 3), dMultiply0(R, Z, YX, 3, 3, 3);
        dBodySetRotation(a, R);
        dVector3 arm;
        dBodyVectorToWorld(a, 0, 0, real(kArm), arm);
        place(a, V3{0, 0, kArm} - vec(arm));
    }
    void set(int parameter, double value)
    {
        for (const int group : {0, int(dParamGroup2), int(dParamGroup3)})
            dJointSetAMotorParam(motor, parameter + group, real(value));
    }
    double gap() const
    {
        dVector3 p, q;
        dJointGetBallAnchor(ball, p), dJointGetBallAnchor2(ball, q);
        return length(vec(p) - vec(q));
    }

    dBodyID a, b;
    dJointID ball, motor;
};

// Both bodies about their centres, which are what stops and motors move here.
double energy(const Pair& pair)
{
    double sum = 0;
    for (const dBodyID body : {pair.a, pair.b}) {
        const V3 v = vec(dBodyGetLinearVel(body)), w = vec(dBodyGetAngularVel(body));
        sum += 0.5 * (kMass * dot(v, v) + kInertia * dot(w, w));
    }
    return sum;
}

struct Worst {
    double gap = 0, spin = 0, gain = 0;
};

// Pairs near lock with random spins, for half a second.
template <typename SetUp>
Worst worst_of_pairs(const Way& way, int preset, double h, SetUp set_up)
{
    Worst worst;
    Random random(11);
    for (int number = 0; number < kPairs; ++number) {
        Sim sim;
        dWorldUseDefaults(sim.world, preset);
        sim.gravity(0, 0, 0);
        const double x = random.uniform(-1, 1), y = random.uniform(1.5, 1.64), z = random.uniform(-1, 1);
        Pair pair(sim, x, y, z);
        set_up(pair);
        velocity(pair.a, {}, random.point(5)), velocity(pair.b, {}, random.point(5));
        const double before = energy(pair);
        for (int i = 0; i < 0.5 / h; ++i) {
            way.step(sim.world, real(h));
            worst.gap = std::max(worst.gap, pair.gap());
            worst.gain = std::max(worst.gain, energy(pair) / before);
            for (const dBodyID body : {pair.a, pair.b})
                worst.spin = std::max(worst.spin, length(vec(dBodyGetAngularVel(body))));
        }
    }
    return worst;
}

void set_stops(Pair& pair) { pair.set(dParamLoStop, -0.5), pair.set(dParamHiStop, 0.5); }
void set_motors(Pair& pair) { pair.set(dParamVel, 3), pair.set(dParamFMax, 2); }

// ERP asks each of the two stops for at most 0.2 e/h, e <= pi - 0.5, and of the angle for twice that between lock and where it is a
// coordinate of its own; each body has half of the sum. It turns by that about its centre in a straight step, and opens the ball
// by 1 - cos(1.06) of its arm. (Asked along rows that are nearly opposite, the two stops were a hundred metres and 60,000 rad/s.)
constexpr double kTurn = 2 * 0.2 * (M_PI - 0.5), kOpened = 2 * kArm * (1 - 0.489);

// In the presets poses bring joints back, and exact joints of substeps leave no velocity of it: what hits a stop loses energy.
bool keeps_energy(const Way& way, int preset)
{
    return way.number == kExactJoints || (preset != dDefaultsOde && way.number != kSubsteps);
}

TEST(GimbalLock, stops_tear_nothing)
{
    for (const int preset : kPresets)
        for (const Way& way : kWays)
            for (const double h : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
                const Worst worst = worst_of_pairs(way, preset, h, set_stops);
                const bool keeps = keeps_energy(way, preset);
                EXPECT_LT(worst.gap, keeps ? 0.12 * kOpened : kOpened)
                    << way.number << ' ' << preset << ' ' << 1 / h;
                EXPECT_LT(worst.spin, kFastest + kTurn / h) << way.number << ' ' << preset << ' ' << 1 / h;
                EXPECT_LT(keeps ? worst.gain : 0, 1) << way.number << ' ' << preset << ' ' << 1 / h;
            }
}

// Of 2 N m and 3 rad/s about each axis. A straight step opens the ball by (w h)^2/2 of its arms.
TEST(GimbalLock, motors_tear_nothing)
{
    for (const int preset : kPresets)
        for (const Way& way : kWays) {
            const Worst worst = worst_of_pairs(way, preset, 1.0 / 60, set_motors);
            EXPECT_LT(worst.gap, kArm * std::pow(kFastest / 60, 2)) << way.number << ' ' << preset;
            EXPECT_LT(worst.spin, kFastest) << way.number << ' ' << preset;
        }
}

}  // namespace
}  // namespace epode::physics
