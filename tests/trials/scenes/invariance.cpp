// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Laws do not know where a scene is, how it is turned, in which order it was made, or what else the world has.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

// A pile of two, a box that tumbles, a ball that rolls, a pendulum of two, a cylinder, at a place and turned.
struct Mixed {
    static constexpr int kBodies = 7;
    Vec origin;
    Turn q;
    dBodyID bodies[kBodies];

    Vec at(double x, double y, double z) const { return origin + rotate(q, {x, y, z}); }
    void make(Stage& stage, int i)
    {
        dBodyID& b = bodies[i];
        if (i < 2) b = stage.box({0.5, 0.5, 0.5}, 5, at(0, 0, 0.25 + 0.5 * i), q);
        if (i == 2) b = stage.box({0.6, 0.3, 0.2}, 3, at(-1.5, 0.3, 0.6), q * turn({1, 2, 3}, 0.5));
        if (i == 3) b = stage.ball(0.2, 2, at(1.6, 0, 0.2));
        if (i == 4) b = stage.bar({0.05, 0.05, 0.5}, 1, at(-0.8, 0, 1.75), q);
        if (i == 5) b = stage.capsule(0.1, 0.3, 2, at(-0.8, 0, 1.25), q);
        if (i == 6) b = stage.cylinder(0.2, 0.4, 4, at(1, 1, 0.2), q);
    }
    void join(Stage& stage, bool upper)
    {
        if (upper)
            stage.hinge(bodies[4], nullptr, at(-0.8, 0, 2), rotate(q, kY));
        else
            stage.ball_joint(bodies[5], bodies[4], at(-0.8, 0, 1.5));
    }
    void build(Stage& stage, bool reversed = false)
    {
        stage.block({20, 20, 1}, at(0, 0, -0.5), q);
        for (int k = 0; k < kBodies; ++k) make(stage, reversed ? kBodies - 1 - k : k);
        for (bool upper : {true, false}) join(stage, upper != reversed);
        set_velocity(bodies[2], rotate(q, {1, 0, 0}), rotate(q, {1, 3, 2}));
        set_velocity(bodies[3], rotate(q, {-2, 0.1, 0}));
        set_velocity(bodies[5], rotate(q, {1, 0, 0}));
    }
    Vec local(int i) const { return rotate(inverse(q), position(bodies[i]) - origin); }
};

void compare(Run& run, const char* law, Stage& one, const Mixed& first, Stage& two, const Mixed& second)
{
    for (int i = one.steps_in(0.5); i-- > 0;) one.step(), two.step();
    for (int i = 0; i < Mixed::kBodies; ++i) run.record(law, 1000 * length(first.local(i) - second.local(i)));
}

void run_same(Run& run)
{
    const auto against = [&](const char* law, Mixed other, Vec gravity, bool reversed, bool copy) {
        Stage one(run), two(run.setting, gravity);
        Mixed plain{{}, {}, {}}, aside{{60, 0, 0}, {}, {}};
        plain.build(one), other.build(two, reversed);
        if (copy) aside.build(two);
        compare(run, law, one, plain, two, other);
    };
    const Vec down{0, 0, -kGravity};
    const Turn lying = turn(kX, kPi / 2);
    against("place", {{1000, -2000, 0}, {}, {}}, down, false, false);
    against("heading", {{}, turn(kZ, 37 * kPi / 180), {}}, down, false, false);
    against("gravity", {{}, lying, {}}, rotate(lying, down), false, false);
    against("order", {{}, {}, {}}, down, true, false);
    against("copy", {{}, {}, {}}, down, false, true);
}

// Motors inside of a body that floats: reaction wheels, a chain that wriggles, a man who walks along a boat.
void run_inner_motors(Run& run)
{
    {
        Stage stage(run.setting, {});
        dBodyID last = nullptr;
        std::vector<dJointID> hinges;
        for (int i = 0; i < 5; ++i) {
            const dBodyID bar = stage.bar({0.5, 0.1, 0.1}, 1, {0.5 * i, 0, 0});
            if (last) hinges.push_back(stage.hinge(bar, last, {0.5 * i - 0.25, 0, 0}, i % 2 ? kZ : kY));
            last = bar;
        }
        for (dJointID hinge : hinges) dJointSetHingeParam(hinge, dParamFMax, 20);
        double time = 0;
        stage.advance(5, [&] {
            time += stage.h;
            for (size_t i = 0; i < hinges.size(); ++i)
                dJointSetHingeParam(hinges[i], dParamVel, dReal(4 * std::sin(4 * time + double(i))));
            run.record("swimmer", 100 * length(angular_momentum(stage)));  // m L^2 w = 1 kg m^2/s
            run.record("momentum", length(momentum(stage)));
        });
    }
    Stage stage(run);
    stage.surface.friction = 0;
    stage.floor();
    const dBodyID boat = stage.box({4, 1, 0.4}, 200, {0, 0, 0.2}),
                  man = stage.bar({0.4, 0.4, 1.6}, 80, {-1.5, 0, 1.2});
    const dJointID legs = dJointCreateSlider(stage.world, nullptr);
    dJointAttach(legs, man, boat);
    dJointSetSliderAxis(legs, 1, 0, 0);
    dJointSetSliderParam(legs, dParamFMax, 400);
    stage.advance(6, [&] {
        const double left = 1.5 - (position(man).x - position(boat).x);
        dJointSetSliderParam(legs, dParamVel, dReal(std::clamp(3 * left, -1.0, 1.0)));
    });
    const double walked = position(man).x - position(boat).x + 1.5;
    run.record("boat", 1000 * std::fabs(-position(boat).x - walked * 80 / 280));
}

double swimmer_bound(const Setting& setting) { return setting.step_size == 0 ? 2 : 0.5; }

}  // namespace

extern const Scene kSame{
    "States and events",
    "same",
    "a mixed scene for 0.5 s: elsewhere, turned, under gravity along y, made in reverse, with a copy 60 m "
    "away",
    {{"place", "difference at (1000, -2000, 0)", "mm", 0.01},
     {"heading",
      "difference when turned by 37 degrees",
      "mm",
      2,
      {{kCallback, 20, "The bound of friction is a pyramid in ODE's way (guide/contacts.md)"}}},
     {"gravity", "difference when gravity and all are turned by 90 degrees", "mm", 0.5},
     {"order", "difference when made in reverse order", "mm", 2},
     {"copy",
      "difference when it is not alone",
      "mm",
      0.01,
      {{kSweeps, 2, "Random orders of sweeps are those of the island's number (architecture.md)"}}}},
    &run_same};

extern const Scene kInnerMotors{
    "Free motion",
    "inner_motors",
    "five bars on motors wriggle in empty space, 5 s; a man of 80 kg walks along a boat of 200 kg on ice",
    {{"swimmer", "angular momentum, of m L^2 w", "%", &swimmer_bound},
     {"momentum", "momentum", "N s", 1e-6},
     {"boat", "way of the boat, off m L / (m + M)", "mm", 1}},
    &run_inner_motors};

}  // namespace epode::trials
