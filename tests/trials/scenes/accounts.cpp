// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a world reports explains what it did: contact forces the change of momentum and angular momentum, the ledger's shares the
// change of energy, with their signs.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kEdge = 0.4, kMass = 2, kMoment = kMass * kEdge * kEdge / 6;

// A cube has one moment in all directions, so that its angular momentum is I w whichever way it lies, and nothing gyroscopic acts.
struct Tumbler {
    dBodyID body;
    Vec v, w, x, force, torque;
    double unexplained = 0, unexplained_turn = 0, change = 0, turn = 0;

    void feel(const Touch& touch, double sign)
    {
        force = force + sign * touch.force;
        torque = torque + sign * trials::cross(touch.pos - x, touch.force);
    }
    void compare(double h)
    {
        if (!dBodyIsEnabled(body)) return;  // what falls asleep loses its velocity without a force
        const Vec moved = kMass * (velocity(body) - v), turned = kMoment * (spin(body) - w);
        unexplained = std::max(unexplained, length(moved - h * (force + kMass * Vec{0, 0, -kGravity})));
        unexplained_turn = std::max(unexplained_turn, length(turned - h * torque));
        change = std::max(change, length(moved));
        turn = std::max(turn, length(turned));
    }
    void remember() { v = velocity(body), w = spin(body), x = position(body), force = torque = {}; }
};

// Two cubes tumble onto the floor and each other.
void explain_momentum(Run& run)
{
    for (int drop = 0; drop < 3; ++drop) {
        Stage stage(run);
        stage.want_touches();
        stage.floor();
        std::vector<Tumbler> cubes(2);
        for (int i = 0; i < 2; ++i) {
            cubes[size_t(i)].body = stage.box({kEdge, kEdge, kEdge}, kMass, {0.1 * i, 0, 0.6 + 0.8 * i},
                                              turn({1, 0.3 + drop, 0.2 + i}, 0.7));
            set_velocity(cubes[size_t(i)].body, {0.3, 0.3 * i, 0}, {3, -2, 5});
            cubes[size_t(i)].remember();
        }
        stage.advance(1.5, [&] {
            for (const Touch& touch : stage.touches()) {
                for (Tumbler& cube : cubes) {
                    if (cube.body == touch.body1) cube.feel(touch, 1);
                    if (cube.body == touch.body2) cube.feel(touch, -1);
                }
            }
            for (Tumbler& cube : cubes) {
                cube.compare(stage.h);
                cube.remember();
            }
        });
        for (const Tumbler& cube : cubes) {
            run.record("momentum", 100 * cube.unexplained / cube.change);
            run.record("angular", 100 * cube.unexplained_turn / cube.turn);
        }
    }
}

void keep_ledger(Run& run)
{
    for (int drop = 0; drop < 6; ++drop) {
        Stage stage(run);
        dWorldSetEnergyLedgerMode(stage.world, 1);
        stage.floor();
        const dBodyID box = stage.box({0.3, 0.2, 0.4}, 1, {0, 0, 1}, turn({1, 0.3 + drop, 0.2}, 0.7));
        set_velocity(box, {0.5 * drop, 0, 0}, {3, -2, 5});
        double friction = 0, impacts = 0, closes = 0, kinetic = 0;
        stage.advance(2.5, [&] {
            dEnergyLedger ledger{};
            ledger.struct_size = sizeof ledger;
            dWorldGetEnergyLedger(stage.world, &ledger);
            friction = std::max(friction, ledger.friction);
            impacts = std::max(impacts, ledger.impacts);
            kinetic = std::max(kinetic, ledger.kinetic_before);
            const double sum = ledger.gravity + ledger.forces + ledger.drives + ledger.friction +
                               ledger.impacts + ledger.joints + ledger.damping + ledger.correction +
                               ledger.integration;
            closes = std::max(closes, std::fabs(ledger.kinetic_after - ledger.kinetic_before - sum));
        });
        run.record("friction", 100 * friction / kinetic);
        run.record("impacts", 100 * impacts / kinetic);
        run.record("closes", 100 * closes / kinetic);
    }
}

}  // namespace

extern const Scene kContactForces{
    "States and events",
    "contact_forces",
    "two cubes tumble onto a floor and each other: contact forces times h against the change of momentum",
    {{"momentum", "change that they do not explain, of the largest", "%", 0.1},
     {"angular", "the same of the angular momentum", "%", 1}},
    &explain_momentum};

extern const Scene kLedger{
    "States and events",
    "ledger",
    "the energy ledger of six boxes that tumble onto a floor",
    {{"friction", "largest gain by friction in a step, of the kinetic energy", "%", 0.01},
     {"impacts", "largest gain by impacts in a step", "%", 0.01},
     {"closes", "what the shares leave over", "%", 1e-6}},
    &keep_ledger};

}  // namespace epode::trials
