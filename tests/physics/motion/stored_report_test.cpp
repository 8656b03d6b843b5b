// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The reported residual is that of the velocities which the program reads, in either precision: random trees of ball
// joints, far from the origin and fast, with what is off computed from outside in double,
//
//   off = max |J v + CFM f - ERP/h gap| / scale,   scale = max max(|c - J v*|, sum |J_k v*_k| / 1000),
//
// of QuickStep with |c| in the place of the last sum; f the joint's force, v* the velocity after gravity and before the
// joints, the pose that of the step's beginning.
#include <algorithm>
#include <vector>

#include "rig.h"

namespace epode::physics::stored_report {
namespace {

constexpr double kH = 0.01, kErp = 0.2, kCfm = tol(1e-8, 2e-5), kGravity = 10;

V3 turn(dBodyID body, V3 a)
{
    const dReal* R = dBodyGetRotation(body);
    return {dot(vec(R), a), dot(vec(R + 4), a), dot(vec(R + 8), a)};
}

struct Link {
    dBodyID body[2];
    V3 anchor[2];  // in their frames
    dJointFeedback feedback;
    V3 arm[2], target, fall;  // at the beginning of a step: to the middle of the gap; c; c - J v*
    double size[3];           // sum |J_k v*_k| of each row
};

double of(V3 a, int i) { return i == 0 ? a.x : i == 1 ? a.y : a.z; }

class RandomTree {
  public:
    RandomTree(std::uint32_t seed, Stepper stepper) : sim_(stepper), random_(seed)
    {
        dWorldSetERP(sim_.world, real(kErp)), dWorldSetCFM(sim_.world, real(kCfm));
        dWorldSetStepReportMode(sim_.world, 1);
        dWorldSetQuickStepNumIterations(sim_.world, 200);
        sim_.gravity(0, 0, -kGravity);
        const int count = 2 + int(random_.uniform(0, 10));
        links_.resize(std::size_t(count - 1));
        for (int i = 0; i < count; ++i) add(i);
    }

    // The program's own view of the step that it has made.
    double step()
    {
        for (Link& link : links_) begin(link);
        EXPECT_EQ(sim_.advance(kH), 1);
        double off = 0, scale = 0;
        for (const Link& link : links_) add_off(link, off, scale);
        rounding_ = 4e3 * kEpsilon + kErp / kH * 4 * kEpsilon * length(position(sim_.bodies[0])) / scale;
        return off / scale;
    }

    // What single digits of the equations, and of the points that a joint holds together, change in it.
    double rounding() const { return rounding_; }
    // Sweeps add to velocities thousands of times, so these are not quite those of the impulses, which are in the
    // report too.
    double share() const { return sim_.stepper == Stepper::kExact ? 1e-4 : tol(1e-4, 0.1); }
    double of_impulses() const { return sim_.stepper == Stepper::kExact ? 0 : tol(1e-10, 0.05); }
    double reported() const { return sim_.report().residual; }
    bool raises() const { return sim_.report().raised_bodies > 0; }
    void move(V3 by)
    {
        for (dBodyID b : sim_.bodies) place(b, position(b) + by);
    }
    void speed_up(double v, double w)
    {
        const V3 all = random_.point(v);
        for (dBodyID b : sim_.bodies) velocity(b, all + random_.point(1), random_.point(w));
    }

  private:
    // At multiples of 1/64 m, so that anchors in the bodies' frames are exact.
    V3 place_at_random()
    {
        const auto coordinate = [&] { return std::floor(random_.uniform(-64, 64)) / 64; };
        const double x = coordinate(), y = coordinate();
        return {x, y, coordinate()};
    }

    void add(int i)
    {
        const double mass = std::pow(10, random_.uniform(-1, 1));
        const dBodyID body = sim_.body(place_at_random(), mass, mass * random_.uniform(0.05, 0.5));
        if (i == 0) return;
        Link& link = links_[std::size_t(i - 1)];
        const V3 at = place_at_random();
        link.body[0] = sim_.bodies[std::size_t(random_.uniform(0, i - 1e-6))], link.body[1] = body;
        for (int k = 0; k < 2; ++k) link.anchor[k] = at - position(link.body[k]);
        const dJointID joint = dJointCreateBall(sim_.world, nullptr);
        dJointAttach(joint, link.body[0], link.body[1]);
        dJointSetBallAnchor(joint, real(at.x), real(at.y), real(at.z));
        dJointSetFeedback(joint, &link.feedback);
    }

    void begin(Link& link) const
    {
        V3 gap = position(link.body[0]) - position(link.body[1]);
        for (int k = 0; k < 2; ++k) {
            link.arm[k] = turn(link.body[k], link.anchor[k]);
            gap = gap + (k == 0 ? 1.0 : -1.0) * link.arm[k];
        }
        for (int k = 0; k < 2; ++k) link.arm[k] = link.arm[k] + (k == 0 ? -0.5 : 0.5) * gap;
        link.fall = {};
        std::fill_n(link.size, 3, 0);
        for (int k = 0; k < 2; ++k) {
            const double sign = k == 0 ? 1 : -1;
            const dBodyID body = link.body[k];
            const V3 v = velocity(body) - V3{0, 0, kGravity * kH}, w = spin(body), r = link.arm[k];
            link.fall = link.fall - sign * (v + cross(w, r));
            const double turning[3] = {w.y * r.z - w.z * r.y, w.z * r.x - w.x * r.z, w.x * r.y - w.y * r.x};
            for (int i = 0; i < 3; ++i) link.size[i] += std::fabs(of(v, i)) + std::fabs(turning[i]);
        }
        link.target = -kErp / kH * gap;
        link.fall = link.fall + link.target;
    }

    void add_off(const Link& link, double& off, double& scale) const
    {
        V3 w = kCfm * vec(link.feedback.f1) - link.target;
        for (int k = 0; k < 2; ++k)
            w = w + (k == 0 ? 1.0 : -1.0) * (velocity(link.body[k]) + cross(spin(link.body[k]), link.arm[k]));
        for (int i = 0; i < 3; ++i) {
            off = std::max(off, std::fabs(of(w, i)));
            const double other =
                sim_.stepper == Stepper::kExact ? 1e-3 * link.size[i] : std::fabs(of(link.target, i));
            scale = std::max({scale, std::fabs(of(link.fall, i)), other});
        }
    }

    Sim sim_;
    Random random_;
    double rounding_ = 0;
    std::vector<Link> links_;
};

class StoredReport : public testing::TestWithParam<Stepper> {};

TEST_P(StoredReport, is_of_the_velocities_that_the_program_reads)
{
    double largest = 0;
    int compared = 0;
    for (std::uint32_t seed = 1; seed <= 100; ++seed) {
        RandomTree tree(seed, GetParam());
        if (seed % 2) tree.move({100, -300, 50});
        tree.speed_up(seed % 3 == 0 ? 300 : 0, seed % 5 == 0 ? 30 : 3);
        for (int i = 0; i < 30; ++i) {
            const double off = tree.step(), reported = tree.reported();
            if (tree.raises()) continue;  // its equations are others
            const double small = tree.share() * off + tree.rounding();
            ASSERT_GT(reported, off - small) << "tree " << seed << ", step " << i;
            ASSERT_LT(reported, off + small + tree.of_impulses()) << "tree " << seed << ", step " << i;
            if (seed % 2 == 0) largest = std::max(largest, off);  // far away poses lack digits
            ++compared;
        }
    }
    EXPECT_GT(compared, 2800);
    if (GetParam() != Stepper::kExact) return;
    EXPECT_LT(largest, tol(1e-9, 1e-3));
}

INSTANTIATE_TEST_SUITE_P(Steppers, StoredReport, testing::Values(Stepper::kExact, Stepper::kQuick),
                         [](const auto& chosen) { return name_of(chosen.param); });

}  // namespace
}  // namespace epode::physics::stored_report
