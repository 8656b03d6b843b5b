// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chaotic mechanisms keep their energy, or lose some, and stay together.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

// Two bars of 2 m, the second across, on a hinge and a ball joint.
void swing(Run& run)
{
    Stage stage(run);
    const dBodyID first = stage.bar({2, 0.2, 0.2}, 2, {1, 0, 5}),
                  second = stage.bar({0.2, 2, 0.2}, 2, {2, 1, 5});
    const dJointID hinge = stage.hinge(first, nullptr, {0, 0, 5}, kY),
                   ball = stage.ball_joint(first, second, {2, 0, 5});
    const double scale = 2 * kGravity * 2, start = energy(stage);
    const bool is_short = run.setting.step_size == 2;
    double time = 0;
    stage.advance(is_short ? 30 : 300, [&] {
        const double change = 100 * (energy(stage) - start) / scale;
        time += stage.h;
        run.record("gain", change);
        if (time < 30) run.record("loss", -change);
        run.record("gap", 1000 * std::max(gap(hinge), gap(ball)));
    });
}

// (w h)^2/2 of the lever of a metre; the bars reach 25 rad/s.
double gap_bound(const Setting& setting) { return 1000 * std::pow(25 * setting.h(), 2) / 2; }
double swept_gap_bound(const Setting& setting) { return std::max(20.0, gap_bound(setting)); }
double gain_bound(const Setting& setting) { return setting.step_size == 2 ? 2 : 1; }
double loss_bound(const Setting& setting) { return setting.step_size == 2 ? 2 : 50; }

// Random trees of bars on balls, hinges and universal joints swing from the world.
struct Tree {
    Stage stage;
    double size = 0;  // sum of m g r

    Tree(const Run& run, std::uint32_t seed) : stage(run)
    {
        Lcg random(seed);
        std::vector<dBodyID> links;
        const int count = 4 + random.below(9);
        for (int i = 0; i < count; ++i) {
            const dBodyID parent = links.empty() ? nullptr : links[size_t(random.below(int(links.size())))];
            const Turn turned = random.any_turn();
            const double side = random.uniform(0.2, 0.6), mass = std::pow(10.0, random.uniform(-1, 1));
            const Vec anchor = parent ? position(parent) + rotate(orientation(parent), {0.2, 0, 0}) : Vec{};
            links.push_back(
                stage.bar({2 * side, 0.1, 0.06}, mass, anchor + rotate(turned, {side, 0, 0}), turned));
            join(links.back(), parent, anchor, turned, random.below(3));
            size += mass * kGravity * length(position(links.back()));
        }
    }
    void join(dBodyID link, dBodyID parent, Vec anchor, Turn turned, int kind)
    {
        const Vec x = rotate(turned, kY), y = rotate(turned, kZ);
        if (kind == 0) {
            stage.ball_joint(link, parent, anchor);
        } else if (kind == 1) {
            stage.hinge(link, parent, anchor, x);
        } else {
            const dJointID joint = dJointCreateUniversal(stage.world, nullptr);
            dJointAttach(joint, link, parent);
            dJointSetUniversalAnchor(joint, anchor.x, anchor.y, anchor.z);
            dJointSetUniversalAxis1(joint, x.x, x.y, x.z);
            dJointSetUniversalAxis2(joint, y.x, y.y, y.z);
        }
    }
};

void swing_trees(Run& run)
{
    for (std::uint32_t seed = 0; seed < 12; ++seed) {
        Tree tree(run, 780 + seed);
        const double start = energy(tree.stage);
        tree.stage.advance(4, [&] { run.record("gain", 100 * (energy(tree.stage) - start) / tree.size); });
    }
}

}  // namespace

extern const Scene kDoublePendulum{
    "Machines",
    "double_pendulum",
    "two bars of 2 m on a hinge and a ball joint, 300 s, in steps of 1 ms 30 s (C23)",
    {{"gain", "gain of energy, of m g L", "%", &gain_bound},
     {"loss", "loss in the first 30 s", "%", &loss_bound},
     {"gap",
      "opening of a joint",
      "mm",
      2,
      {{kSweeps | Method::kSubsteps, &swept_gap_bound, "Sweeps leave errors in joints (guide/steppers.md)"},
       {kAll & ~set_of(Method::kRobot), &gap_bound,
        "Without projection joints open by (w h)^2/2 of the lever (guide/stability.md)"}}}},
    &swing};

extern const Scene kTrees{
    "Machines",
    "trees",
    "twelve random trees of 4 to 12 bars on ball joints, hinges and universal joints swing, 4 s",
    {{"gain", "gain of energy, of the sum of m g r", "%", 1}},
    &swing_trees};

}  // namespace epode::trials
