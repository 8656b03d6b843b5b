// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every pair of the members in three sets of poses that depend on seeds alone, not on a library's answers:
//   resting  the first stands upright on the second, turned about the vertical and moved a little, sunk in by
//            1 mm at most: what a solver sees most
//   tumbled  any rotation, centres 0.45 to 1 of the sum of the reaches apart: hits of all depths, and misses
//   apart    the same, 1.0 to 1.2: boxes that overlap without a touch, what a broad phase lets through
// A ray starts where the first solid would stand and points down (resting) or about at the other's middle.
// One pass over all poses is timed, the quickest of some rounds counts, and the sets alternate between
// solids, so that no branch is learnt from one pose.
#include "bench/pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <memory>

#include "bench/pair_members.h"

namespace epode::bench {

namespace {

enum class Poses { kResting, kTumbled, kApart };

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

Placed place(const PairMember& a, const PairMember& b, Poses poses, PairDice& dice)
{
    Placed p = {};
    if (poses == Poses::kResting) {
        yaw(dice, p.q[0]), yaw(dice, p.q[1]);
        if (a.is_ray()) p.q[0][0] = p.q[0][3] = 0, p.q[0][1] = 1, p.q[0][2] = 0;
        p.x[0][0] = dice.in(-0.08, 0.08), p.x[0][1] = dice.in(-0.08, 0.08);
        p.x[0][2] = a.is_ray() ? 1 : a.top() + b.top() - dice.in(0, 0.001);
        return p;
    }
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

struct Result {
    double ns = 1e300;
    int hits = 0, contacts = 0;
};

// A geom for each pose: placing it is not timed, nor is the first look at its rotation and box.
Result measure(const std::string& first, const std::string& second, Poses poses, const PairOptions& options)
{
    PairDice dice(17);
    std::vector<std::unique_ptr<PairMember>> a, b;
    for (int i = 0; i < options.poses; ++i) {
        a.push_back(std::make_unique<PairMember>(first)), b.push_back(std::make_unique<PairMember>(second));
        const Placed p = place(*a.back(), *b.back(), poses, dice);
        put(a.back()->geom(), p.q[0], p.x[0]);
        if (!b.back()->is_plane()) put(b.back()->geom(), p.q[1], p.x[1]);
        dReal box[6];
        dGeomGetAABB(a.back()->geom(), box), dGeomGetAABB(b.back()->geom(), box);
    }
    Result result;
    for (int round = 0; round < options.rounds; ++round) {
        result.hits = result.contacts = 0;
        const auto start = std::chrono::steady_clock::now();
        for (std::size_t i = 0; i < a.size(); ++i) {
            dContactGeom found[8];
            const int n = dCollide(a[i]->geom(), b[i]->geom(), 8, found, sizeof(dContactGeom));
            result.hits += n > 0 ? 1 : 0, result.contacts += n;
        }
        const std::chrono::duration<double, std::nano> time = std::chrono::steady_clock::now() - start;
        result.ns = std::min(result.ns, time.count() / options.poses);
    }
    return result;
}

const char* name_of(Poses poses)
{
    return poses == Poses::kResting ? "resting" : poses == Poses::kTumbled ? "tumbled" : "apart";
}

// A plane is always the second, a ray the first; neither meets its like.
bool ordered(std::string& first, std::string& second)
{
    if (first == "plane" || second == "ray") std::swap(first, second);
    return first != "plane" && second != "ray" && !(first == "ray" && second == "ray");
}

}  // namespace

int bench_pairs(const PairOptions& options)
{
    for (const std::string& asked : {options.first, options.second})
        if (!asked.empty() &&
            std::find(std::begin(kMembers), std::end(kMembers), asked) == std::end(kMembers)) {
            fmt::print(stderr, "epode_bench: no member of a pair is called {}\n", asked);
            return 2;
        }
    for (auto i = std::begin(kMembers); i != std::end(kMembers); ++i)
        for (auto j = i; j != std::end(kMembers); ++j) {
            std::string first = *i, second = *j;
            const auto is = [&](const std::string& name) {
                return name.empty() || first == name || second == name;
            };
            const bool twice = options.first == options.second && !options.first.empty();
            if (!is(options.first) || !is(options.second) || (twice && first != second) ||
                !ordered(first, second))
                continue;
            for (const Poses poses : {Poses::kResting, Poses::kTumbled, Poses::kApart}) {
                if (!options.set.empty() && options.set != name_of(poses)) continue;
                const Result r = measure(first, second, poses, options);
                fmt::print("{} {} {} {:.1f} {:.3f} {:.3f}\n", first, second, name_of(poses), r.ns,
                           double(r.hits) / options.poses, r.hits ? double(r.contacts) / r.hits : 0.0);
            }
        }
    return 0;
}

}  // namespace epode::bench
