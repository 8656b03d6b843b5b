// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The depth of two boxes against brute force over all 15 axes: moved apart along the normal by a little less
// than the depth they still overlap, by a little more they do not, whichever axis was chosen. An edge's depth
// is the least translation; a face's is within the handicap that keeps edges from winning by a hair.
#include "geometry/overlap/box_box.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../../effort.h"
#include "ode/ode.h"

namespace {

using namespace epode;

constexpr double kPart = kSingle ? 1e-4 : 1e-6;   // of a depth
constexpr double kRound = kSingle ? 1e-5 : 1e-9;  // metres
constexpr double kTie = 1e-5;  // of a manifold's width: deeper by less is no reason to take another point

struct Dice {
    std::mt19937_64 engine{15};
    double in(double low, double high) { return low + (high - low) * (double(engine() >> 11) * 0x1p-53); }
};

struct Placed {
    dVector3 p = {}, side = {};
    dMatrix3 R = {};

    double axis(int i, int k) const { return double(R[4 * k + i]); }
    double half(const double* n) const
    {
        double sum = 0;
        for (int i = 0; i < 3; ++i)
            sum += double(side[i]) / 2 * std::fabs(axis(i, 0) * n[0] + axis(i, 1) * n[1] + axis(i, 2) * n[2]);
        return sum;
    }
};

double overlap_along(const Placed& a, const Placed& b, double* n)
{
    const double length = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (length < 1e-5) return 1e300;
    double gap = 0;
    for (int k = 0; k < 3; ++k) n[k] /= length, gap += n[k] * (double(b.p[k]) - double(a.p[k]));
    return a.half(n) + b.half(n) - std::fabs(gap);
}

// The least overlap of all axes: how far two boxes must move to part; negative when they are apart.
double least_overlap(const Placed& a, const Placed& b)
{
    double least = 1e300;
    for (int i = 0; i < 3; ++i) {
        double of_a[3] = {a.axis(i, 0), a.axis(i, 1), a.axis(i, 2)},
               of_b[3] = {b.axis(i, 0), b.axis(i, 1), b.axis(i, 2)};
        least = std::min({least, overlap_along(a, b, of_a), overlap_along(a, b, of_b)});
        for (int j = 0; j < 3; ++j) {
            double n[3];
            for (int k = 0, l = 1, m = 2; k < 3; l = m, m = k, ++k)
                n[k] = a.axis(i, l) * b.axis(j, m) - a.axis(i, m) * b.axis(j, l);
            least = std::min(least, overlap_along(a, b, n));
        }
    }
    return least;
}

Placed moved(Placed b, const dVector3 normal, double way)
{
    for (int k = 0; k < 3; ++k) b.p[k] += dReal(way * double(normal[k]));
    return b;
}

// `lean`: how far the second is turned from the first, as a tangent; 0 for any rotation.
void draw(Dice& dice, double lean, Placed& a, Placed& b)
{
    for (Placed* box : {&a, &b}) {
        for (int k = 0; k < 3; ++k) {
            box->p[k] = dReal(dice.in(-1, 1));
            box->side[k] = dReal(dice.in(0.2, 1.2));
        }
        dQuaternion q;
        for (dReal& c : q) c = dReal(dice.in(-1, 1));
        dNormalize4(q);
        dRfromQ(box->R, q);
    }
    if (!(lean > 0)) return;
    dQuaternion q = {1, dReal(lean * dice.in(-1, 1)), dReal(lean * dice.in(-1, 1)),
                     dReal(lean * dice.in(-1, 1))};
    dNormalize4(q);
    dMatrix3 turn;
    dRfromQ(turn, q);
    dMultiply0(b.R, turn, a.R, 3, 3, 3);
}

class BoxBoxDepth : public testing::TestWithParam<double> {
  protected:
    BoxBoxDepth() { dInitODE2(0); }
    ~BoxBoxDepth() override { dCloseODE(); }

    // True where the boxes touch.
    bool judge_helper(const Placed& a, const Placed& b);
    void judge_geoms(const Placed& a, const Placed& b);

    dVector3 normal_;
    dReal depth_ = 0;
    int code_ = 0;
};

bool BoxBoxDepth::judge_helper(const Placed& a, const Placed& b)
{
    dContactGeom contacts[8];
    const double least = least_overlap(a, b);
    const bool hit =
        dBoxBox(a.p, a.R, a.side, b.p, b.R, b.side, normal_, &depth_, &code_, 8, contacts, sizeof *contacts);
    EXPECT_TRUE(hit == (least > 0) || std::fabs(least) <= kRound);
    if (!hit) return false;
    const double depth = double(depth_), size = std::max({a.side[0], a.side[1], a.side[2]}) / 2.0 +
                                                std::max({b.side[0], b.side[1], b.side[2]}) / 2.0;
    EXPECT_GT(least_overlap(a, moved(b, normal_, depth * (1 - kPart) - kRound)), 0) << "code " << code_;
    EXPECT_LT(least_overlap(a, moved(b, normal_, depth * (1 + kPart) + kRound)), 0) << "code " << code_;
    EXPECT_GE(depth, least * (1 - kPart) - kRound);
    EXPECT_TRUE(code_ <= 6 || depth <= least * (1 + kPart) + kRound);
    EXPECT_LE(depth, least * double(kEdgeHandicap) + 2.1e-5 * size + kRound);
    return true;
}

// dCollide has the same normal and the same deepest point, or one as deep to the tie.
void BoxBoxDepth::judge_geoms(const Placed& a, const Placed& b)
{
    dGeomID geoms[2];
    for (int i = 0; i < 2; ++i) {
        const Placed& from = i ? b : a;
        geoms[i] = dCreateBox(nullptr, from.side[0], from.side[1], from.side[2]);
        dGeomSetPosition(geoms[i], from.p[0], from.p[1], from.p[2]);
        dGeomSetRotation(geoms[i], from.R);
    }
    dContactGeom contacts[8];
    const int count = dCollide(geoms[0], geoms[1], 8, contacts, sizeof *contacts);
    ASSERT_GT(count, 0);
    double deepest = 0;
    for (int i = 0; i < count; ++i) deepest = std::max(deepest, double(contacts[i].depth));
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(contacts[0].normal[k], -normal_[k], kRound);
    EXPECT_LE(deepest, double(depth_) + kRound);
    EXPECT_GE(deepest, double(depth_) - kTie * 2.1 - kRound);
    for (dGeomID geom : geoms) dGeomDestroy(geom);
}

TEST_P(BoxBoxDepth, is_what_parts_the_boxes_along_the_normal)
{
    Dice dice;
    int hits = 0;
    for (int i = 0; i < tests::effort(40000) && !HasFailure(); ++i) {
        Placed a, b;
        draw(dice, GetParam(), a, b);
        if (!judge_helper(a, b)) continue;
        ++hits;
        judge_geoms(a, b);
    }
    EXPECT_GT(hits, tests::effort(40000) / 8);
}

INSTANTIATE_TEST_SUITE_P(Turned, BoxBoxDepth, testing::Values(0.0, 0.3, 0.03, 3e-3, 1e-4));

}  // namespace
