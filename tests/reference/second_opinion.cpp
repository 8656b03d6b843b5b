// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every pair of convex solids in random poses, with libccd's opinion (GJK for whether they meet, its
// expanding polytope for how deep) beside the library's distance. libccd sees the solids by their farthest
// points only, as tests/reference has them. It is no judge: reference_pairs is. What is counted:
//   wrong    the two disagree on whether the solids meet although the library's distance is beyond 1e-4 of
//            the size; libccd works to 1e-6 here
//   agree    the share of hits where the depths agree within a thousandth of the size
//   refuted  hits where libccd's depth is less, but not enough to part the solids along its own direction, by
//            their farthest points: there libccd is wrong (its polytope stops early, mostly on round solids)
//   deeper   how much deeper than libccd's the library's depth is at most, as a part of the size, elsewhere
// second_opinion [POSES]: exit status 1 if more than one in ten thousand is wrong (libccd misses that many
// spheres), or deeper by more than a thousandth.
#include <ccd/ccd.h>
#include <ode/ext.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iterator>

#include "solid.h"

namespace {

using epode::reference::Dice;
using epode::reference::dot;
using epode::reference::Point;
using epode::reference::Solid;
using epode::reference::sum;

constexpr double kTouch = 1e-4, kDeeper = 1e-3;

void farthest(const void* solid, const ccd_vec3_t* direction, ccd_vec3_t* out)
{
    const Point p = static_cast<const Solid*>(solid)->support(
        {double(direction->v[0]), double(direction->v[1]), double(direction->v[2])});
    ccdVec3Set(out, ccd_real_t(p[0]), ccd_real_t(p[1]), ccd_real_t(p[2]));
}

void middle(const void* solid, ccd_vec3_t* out)
{
    const Point p = static_cast<const Solid*>(solid)->position();
    ccdVec3Set(out, ccd_real_t(p[0]), ccd_real_t(p[1]), ccd_real_t(p[2]));
}

// How far one must be moved along n, one way or the other, until they are apart.
double way_out(const Solid& a, const Solid& b, const Point& n)
{
    const Point back = {-n[0], -n[1], -n[2]};
    const double to_front = dot(n, a.support(n)) - dot(n, b.support(back));
    const double to_back = dot(n, b.support(n)) - dot(n, a.support(back));
    return std::fmin(to_front, to_back);
}

struct Tally {
    int hits = 0, wrong = 0, agree = 0, silent = 0, refuted = 0;
    double deeper = 0;
};

void compare(const Solid& a, const Solid& b, const ccd_t& ccd, Tally& tally)
{
    const double size = a.reach() + b.reach();
    dQueryDistance ours{};
    if (!dGeomGetDistance(a.geom(), b.geom(), dInfinity, &ours)) {
        ++tally.wrong;
        return;
    }
    const bool meet = ccdGJKIntersect(&a, &b, &ccd) != 0;
    if (std::fabs(double(ours.distance)) > kTouch * size && meet != (ours.distance < 0)) ++tally.wrong;
    if (!meet || ours.distance >= 0) return;
    ++tally.hits;
    ccd_real_t depth = 0;
    ccd_vec3_t way, place;
    if (ccdGJKPenetration(&a, &b, &ccd, &depth, &way, &place) != 0) {
        ++tally.silent;
        return;
    }
    const double deeper = (-double(ours.distance) - double(depth)) / size;
    tally.agree += std::fabs(deeper) < kDeeper;
    const Point n = {double(way.v[0]), double(way.v[1]), double(way.v[2])};
    if (deeper > kDeeper && way_out(a, b, n) > double(depth) + kDeeper * size)
        ++tally.refuted;
    else
        tally.deeper = std::fmax(tally.deeper, deeper);
}

Tally run(const char* first, const char* second, int poses)
{
    Tally tally;
    Dice dice(std::uint64_t(first[0]) * 1000003u + std::uint64_t(second[2]) * 31u + std::uint64_t(second[0]));
    ccd_t ccd;
    CCD_INIT(&ccd);
    ccd.support1 = ccd.support2 = farthest;
    ccd.center1 = ccd.center2 = middle;
    ccd.max_iterations = 500;
    ccd.epa_tolerance = ccd_real_t(1e-6);
    for (int i = 0; i < poses; ++i) {
        Solid a(first, dice), b(second, dice);
        b.place({dice.in(-5, 5), dice.in(-5, 5), dice.in(-5, 5)}, dice);
        a.place(sum(b.position(), (a.reach() + b.reach()) * dice.in(0.05, 1), dice.direction()), dice);
        compare(a, b, ccd, tally);
    }
    return tally;
}

}  // namespace

int main(int argc, char** argv)
{
    const int poses = argc > 1 ? std::atoi(argv[1]) : 200;
    dInitODE();
    std::printf("%-20s%8s%8s%8s%9s%9s%8s%12s\n", "pair", "poses", "hits", "wrong", "agree", "refuted",
                "silent", "deeper");
    bool good = poses > 0;
    const auto& kinds = epode::reference::kKinds;
    for (std::size_t i = 0; i + 1 < std::size(kinds); ++i)  // planes have no farthest point
        for (std::size_t j = i; j + 1 < std::size(kinds); ++j) {
            const Tally t = run(kinds[i], kinds[j], poses);
            std::printf("%-20s%8d%8d%8d%8.2f%%%9d%8d%12.1e\n",
                        (std::string(kinds[i]) + "-" + kinds[j]).c_str(), poses, t.hits, t.wrong,
                        t.hits > t.silent ? 100.0 * t.agree / (t.hits - t.silent) : 0.0, t.refuted, t.silent,
                        t.deeper);
            std::fflush(stdout);
            good = good && t.wrong <= poses / 10000 && t.deeper <= kDeeper && t.hits > poses / 8;
        }
    dCloseODE();
    return good ? 0 : 1;
}
