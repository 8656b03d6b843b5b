// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Assemblies in empty space, held together by joints: forces between bodies change neither the momentum nor the
// angular momentum of the whole, and rigid joints do no work.
#include "energy_kept.h"

#include <algorithm>

namespace epode::trials {

namespace {

// Two boxes on two ball joints, which make a hinge of them, turn about a common centre.
void build_pair(Stage& stage, double rate)
{
    dBodyID body[2];
    for (int i = 0; i < 2; ++i) body[i] = stage.bar({0.4, 0.1, 0.1}, 1, {0.45 * i - 0.225, 0, 0});
    for (double y : {-0.05, 0.05}) stage.ball_joint(body[0], body[1], {0, y, 0});
    for (int i = 0; i < 2; ++i) {
        const double side = i ? 1 : -1;
        const Vec w{0, 0.5 * side, rate};
        set_velocity(body[i], cross(w, {0.225 * side, 0, 0}), w);
    }
    stage.step();
}

double pair_error(Stage& stage)
{
    build_pair(stage, 5);
    return energy_error(stage, 5, kinetic_energy(stage));
}

// Exact rotation alone is of second order here.
double pair_bound(const Setting& setting) { return 100 * 25 * 25 * setting.h() * setting.h() + 0.01; }

void tumble(Run& run)
{
    record_energy(run, &pair_error, {});
    for (double rate : {5.0, 20.0}) {
        Stage stage(run, {});
        build_pair(stage, rate);
        const Vec start = angular_momentum(stage);
        stage.advance(5, [&] {
            run.record("momentum", 100 * length(angular_momentum(stage) - start) / length(start));
        });
    }
}

std::vector<Law> tumble_laws()
{
    std::vector<Law> laws = energy_laws(&pair_bound);
    laws.push_back({"momentum", "change of the angular momentum, also at 20 rad/s", "%", 0.1});
    return laws;
}

// A universal and a ball joint between two bodies that are given velocities the joints do not allow.
void seize(Run& run)
{
    Lcg random(3);
    const auto any = [&] { return Vec{random.uniform(-4, 4), random.uniform(-4, 4), random.uniform(-4, 4)}; };
    Stage stage(run, {});
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, 0.01, 0.03, 0.02, 0, 0, 0);
    const dBodyID a = stage.part(mass, {}), b = stage.part(mass, {1, 0.5, 0.2});
    for (dBodyID body : {a, b}) dBodySetGyroscopicMode(body, 0);
    const dJointID joint = dJointCreateUniversal(stage.world, nullptr);
    dJointAttach(joint, a, b);
    dJointSetUniversalAnchor(joint, 0.3, 0.2, 0.1);
    dJointSetUniversalAxis1(joint, 1, 0, 0);
    dJointSetUniversalAxis2(joint, 0, 1, 0);
    stage.ball_joint(a, b, {0.9, 0.2, 0.4});
    for (int i = 0; i < 8; ++i) {
        set_velocity(a, any(), any());
        set_velocity(b, any(), any());
        // Both with the poses at which the step is solved.
        const Vec before = angular_momentum(stage), linear = momentum(stage), at_a = position(a),
                  at_b = position(b);
        const Turn turned_a = orientation(a), turned_b = orientation(b);
        stage.step();
        const Vec after = angular_momentum(a, at_a, turned_a) + angular_momentum(b, at_b, turned_b);
        run.record("momentum", 100 * length(after - before) / length(before));
        run.record("linear", 100 * length(momentum(stage) - linear) / length(linear));
    }
}

// Substeps are solved at poses in between: off by what the bodies turn in a step.
double inner_bound(const Setting& setting) { return 100 * 4 * setting.h(); }
// So is the second half of a projected step, at the poses of its end: of second order.
double end_bound(const Setting& setting) { return 2000 * setting.h() * setting.h(); }

}  // namespace

extern const Scene kTumblingPair{"Free motion", "tumbling_pair",
                                 "two boxes on two ball joints tumble in empty space at 5 rad/s, 5 s",
                                 tumble_laws(), &tumble};

extern const Scene kSeizedPair{
    "Free motion",
    "seized_pair",
    "two free bodies on a universal and a ball joint are given velocities that the joints do not allow, "
    "eight times",
    {{"momentum",
      "change of the angular momentum in a step",
      "%",
      1e-4,
      {{set_of(Method::kSubsteps), &inner_bound, "Substeps move the bodies in between (guide/steppers.md)"},
       {set_of(Method::kRobot), &end_bound,
        "Velocities are made to fit the poses of the end (guide/options.md)"}}},
     {"linear", "change of the momentum", "%", 1e-6}},
    &seize};

}  // namespace epode::trials
