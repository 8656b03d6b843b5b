// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every pair of convex solids in random poses, with the opinion of another library compared with the library's
// distance. Nobody is judge: reference_pairs is. What is counted:
//   wrong    the two disagree on whether the solids meet although the library's distance is beyond 1e-4 of
//            the size
//   agree    the share of hits where the depths agree within a thousandth of the size
//   refuted  hits where the other's depth is less, but not enough to part the solids along its own direction,
//            by their farthest points: there it is wrong (its polytope stops early, mostly on round solids)
//   deeper   how much deeper than the other's the library's depth is at most, as a part of the size,
//   elsewhere silent   the other says that they meet, but not how deep
// second_opinion [POSES [LIBRARY]]: exit status 1 if more are wrong than the other is known to miss, or
// deeper by more than a thousandth.
#include <ode/ext.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <iterator>

#include "opinion.h"

namespace {

using epode::reference::Dice;
using epode::reference::dot;
using epode::reference::NamedOpinion;
using epode::reference::Opinion;
using epode::reference::Point;
using epode::reference::Solid;
using epode::reference::sum;
using epode::reference::Verdict;

constexpr double kTouch = 1e-4, kDeeper = 1e-3;

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

void compare(const Solid& a, const Solid& b, Opinion ask, Tally& tally)
{
    const double size = a.reach() + b.reach();
    dQueryDistance ours{};
    if (!dGeomGetDistance(a.geom(), b.geom(), dInfinity, &ours)) {
        ++tally.wrong;
        return;
    }
    const Verdict theirs = ask(a, b);
    if (std::fabs(double(ours.distance)) > kTouch * size && theirs.meet != (ours.distance < 0)) ++tally.wrong;
    if (!theirs.meet || ours.distance >= 0) return;
    ++tally.hits;
    if (theirs.silent) {
        ++tally.silent;
        return;
    }
    const double deeper = (-double(ours.distance) - theirs.depth) / size;
    tally.agree += std::fabs(deeper) < kDeeper;
    if (deeper > kDeeper && way_out(a, b, theirs.way) > theirs.depth + kDeeper * size)
        ++tally.refuted;
    else
        tally.deeper = std::fmax(tally.deeper, deeper);
}

Tally run(const char* first, const char* second, Opinion ask, int poses)
{
    Tally tally;
    Dice dice(std::uint64_t(first[0]) * 1000003u + std::uint64_t(second[2]) * 31u + std::uint64_t(second[0]));
    for (int i = 0; i < poses; ++i) {
        Solid a(first, dice), b(second, dice);
        b.place({dice.in(-5, 5), dice.in(-5, 5), dice.in(-5, 5)}, dice);
        a.place(sum(b.position(), (a.reach() + b.reach()) * dice.in(0.05, 1), dice.direction()), dice);
        compare(a, b, ask, tally);
    }
    return tally;
}

bool compare_all(const NamedOpinion& opinion, int poses)
{
    std::printf("%-20s%8s%8s%8s%9s%9s%8s%12s\n", opinion.name, "poses", "hits", "wrong", "agree", "refuted",
                "silent", "deeper");
    bool good = true;
    const auto& kinds = epode::reference::kKinds;
    for (std::size_t i = 0; i + 1 < std::size(kinds); ++i)  // planes have no farthest point
        for (std::size_t j = i; j + 1 < std::size(kinds); ++j) {
            if (std::strcmp(kinds[i], opinion.absent) == 0 || std::strcmp(kinds[j], opinion.absent) == 0)
                continue;
            const Tally t = run(kinds[i], kinds[j], opinion.ask, poses);
            std::printf("%-20s%8d%8d%8d%8.2f%%%9d%8d%12.1e\n",
                        (std::string(kinds[i]) + "-" + kinds[j]).c_str(), poses, t.hits, t.wrong,
                        t.hits > t.silent ? 100.0 * t.agree / (t.hits - t.silent) : 0.0, t.refuted, t.silent,
                        t.deeper);
            std::fflush(stdout);
            good = good && t.wrong <= opinion.misses * poses / 10000 && t.deeper <= kDeeper &&
                   t.hits > poses / 8;
        }
    return good;
}

}  // namespace

int main(int argc, char** argv)
{
    const int poses = argc > 1 ? std::atoi(argv[1]) : 200;
    dInitODE();
    bool good = poses > 0, asked = false;
    for (const NamedOpinion& opinion : epode::reference::kOpinions) {
        if (argc > 2 && std::strcmp(argv[2], opinion.name) != 0) continue;
        asked = true;
        good = compare_all(opinion, poses) && good;
    }
    dCloseODE();
    return good && asked ? 0 : 1;
}
