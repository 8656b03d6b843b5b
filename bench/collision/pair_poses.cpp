// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where members of pairs are put: see pair_poses.h.
#include "bench/collision/pair_poses.h"

#include <cmath>
#include <utility>

namespace epode::bench {

namespace {

struct Placed {
    dQuaternion q[2];
    double x[2][3];
};

void direction(PairDice& dice, double out[3])
{
    for (;;) {
        double n2 = 0;
        for (int i = 0; i < 3; ++i) out[i] = dice.in(-1, 1), n2 += out[i] * out[i];
        if (n2 > 1 || n2 < 0.01) continue;
        for (int i = 0; i < 3; ++i) out[i] /= std::sqrt(n2);
        return;
    }
}

void any_rotation(PairDice& dice, dQuaternion q)
{
    double v[4], n2;
    do {
        n2 = 0;
        for (double& c : v) c = dice.in(-1, 1), n2 += c * c;
    } while (n2 > 1 || n2 < 0.01);
    for (int i = 0; i < 4; ++i) q[i] = dReal(v[i] / std::sqrt(n2));
}

void yaw(PairDice& dice, dQuaternion q)
{
    const double half = dice.in(0, 3.14159265358979323846);
    q[0] = dReal(std::cos(half)), q[1] = q[2] = 0, q[3] = dReal(std::sin(half));
}

// The rotation that takes z to -d: of a ray from x to the origin, d being x's direction.
void look_back(const double d[3], dQuaternion q)
{
    double v[4] = {1 - d[2], d[1], -d[0], 0};  // 1 + z . m, z x m for m = -d
    double n = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(n > 1e-9)) v[0] = 0, v[1] = n = 1;
    for (int i = 0; i < 4; ++i) q[i] = dReal(v[i] / n);
}

Placed upright(const PairShape& a, const PairShape& b, PairDice& dice)
{
    Placed p = {};
    yaw(dice, p.q[0]), yaw(dice, p.q[1]);
    if (a.is_ray()) p.q[0][0] = p.q[0][3] = 0, p.q[0][1] = 1, p.q[0][2] = 0;
    const double about = b.is_ground() ? 5 : 0.08, sunk = b.is_ground() ? 0.05 : 0.001;
    p.x[0][0] = dice.in(-about, about), p.x[0][1] = dice.in(-about, about);
    const double foot = b.height(p.x[0][0], p.x[0][1]);
    p.x[0][2] = a.is_ray() ? (b.is_ground() ? foot : 0) + 1 : a.top() + foot - dice.in(0, sunk);
    return p;
}

// Over any place of a ground, and turned any way.
Placed over_ground(const PairShape& a, const PairShape& b, Poses poses, PairDice& dice)
{
    Placed p = {};
    any_rotation(dice, p.q[0]);
    p.x[0][0] = dice.in(-5, 5), p.x[0][1] = dice.in(-5, 5);
    const double up = poses == Poses::kTumbled ? dice.in(0.2, 1) : dice.in(1, 1.2);
    p.x[0][2] = b.height(p.x[0][0], p.x[0][1]) + up * a.reach();
    return p;
}

Placed place(const PairShape& a, const PairShape& b, Poses poses, PairDice& dice)
{
    if (poses == Poses::kResting) return upright(a, b, dice);
    if (b.is_ground()) return over_ground(a, b, poses, dice);
    Placed p = {};
    any_rotation(dice, p.q[0]), any_rotation(dice, p.q[1]);
    double d[3];
    direction(dice, d);
    if (b.is_plane()) d[0] = d[1] = 0, d[2] = 1;
    const double reach = a.is_ray() ? b.reach() + 1 : a.reach() + b.reach();
    const double apart =
        reach * (poses == Poses::kTumbled ? dice.in(b.is_plane() ? 0 : 0.45, 1) : dice.in(1, 1.2));
    for (int i = 0; i < 3; ++i) p.x[0][i] = apart * d[i];
    if (a.is_ray() && poses == Poses::kTumbled && !b.is_plane()) {
        look_back(d, p.q[0]);
        for (double& x : p.x[1]) x = dice.in(-0.2, 0.2);
    }
    return p;
}

void put(dGeomID geom, const dQuaternion q, const double x[3])
{
    dGeomSetQuaternion(geom, q);
    dGeomSetPosition(geom, dReal(x[0]), dReal(x[1]), dReal(x[2]));
}

bool goes_second(const std::string& kind) { return kind == "plane" || kind == "ground" || kind == "field"; }

}  // namespace

const char* name_of(Poses poses)
{
    return poses == Poses::kResting ? "resting" : poses == Poses::kTumbled ? "tumbled" : "apart";
}

bool put_in_order(std::string& first, std::string& second)
{
    const bool turned = (goes_second(first) && !goes_second(second)) ||
                        (second.starts_with("ray") && !first.starts_with("ray"));
    if (turned) std::swap(first, second);
    return turned;
}

PosedPairs::PosedPairs(std::string first, std::string second) : kinds_{std::move(first), std::move(second)} {}

const PairShape& PosedPairs::next_second()
{
    if (b_.empty() || !b_.back()->is_fixed()) b_.push_back(std::make_unique<PairShape>(kinds_[1]));
    at_.push_back(b_.size() - 1);
    return *b_.back();
}

void PosedPairs::add(Poses poses, int count)
{
    PairDice dice(17);
    for (int i = 0; i < count; ++i) {
        a_.push_back(std::make_unique<PairShape>(kinds_[0]));
        const PairShape &a = *a_.back(), &b = next_second();
        const Placed p = place(a, b, poses, dice);
        if (!a.is_fixed()) put(a.geom(), p.q[0], p.x[0]);
        if (!b.is_fixed()) put(b.geom(), p.q[1], p.x[1]);
        dReal box[6];
        dGeomGetAABB(a.geom(), box), dGeomGetAABB(b.geom(), box);
    }
}

}  // namespace epode::bench
