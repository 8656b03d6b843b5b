// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// reference_pairs: dCollide of every pair of {sphere, box, capsule, cylinder, convex, cone, ellipsoid,
// tapered capsule, plane} in random poses compared with a reference that knows the solids by their support points
// alone. A third of the poses is drawn freely, the rest brought together until they are apart, or overlap, by
// 1e-8 to 0.1. Printed for each pair, as parts of the solids' size:
//   wrong    hit where the reference is apart, or miss where it overlaps, by more than --touch
//   deeper   the most by which a depth exceeds the reference's (whose search gives an upper bound, too)
//   left     the most overlap that is left when the first solid is moved by depth along the normal
// Exit status 1 when there is a wrong answer or a figure is above its limit.
//   reference_pairs [--poses N] [--directions N] [--pair KIND KIND] [--seed N]
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <string>

#include "measure.h"

namespace {

using namespace epode::reference;

constexpr bool kSingle = sizeof(dReal) == 4;
constexpr double kTouch = kSingle ? 1e-4 : 1e-6;  // where hit or miss is open
constexpr double kDeeper = 1e-3;
constexpr double kLeft = kSingle ? 1e-3 : 2e-5;  // a manifold's own tolerance

struct Options {
    int poses = 200, directions = 20000;
    unsigned seed = 1;
    std::string first, second;
};

struct Table {
    int hits = 0, wrong = 0;
    double deeper = -1, left = -1, mean = 0;
};

// Brings the solids together or apart so that about `gap` is between them.
void approach(Solid& a, const Solid& b, double gap)
{
    Point way{};
    for (int k = 0; k < 3; ++k) {
        const double apart = distance(a, b, way);
        if (!(apart > 0)) return;
        a.move(sum({0, 0, 0}, gap - apart, way));
        if (gap < 0) return;
    }
}

void draw(Solid& a, Solid& b, Dice& dice)
{
    const Point from = {dice.in(-2, 2), dice.in(-2, 2), dice.in(-2, 2)};
    b.place(from, dice);
    const double reach = a.reach() + b.reach();
    const bool near = dice.in(0, 3) > 1;
    if (b.is_plane()) {
        const double up = b.distance() + (near ? a.reach() * 1.01 : a.reach() * dice.in(-0.5, 1));
        const Point aside = {dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1)};
        a.place(sum(aside, up - dot(aside, b.normal()), b.normal()), dice);
    } else {
        a.place(sum(from, reach * (near ? 1.01 : dice.in(0, 1.05)), dice.direction()), dice);
    }
    if (near) approach(a, b, std::copysign(std::pow(10, dice.in(-8, -1)), dice.in(-1, 1)));
}

// Both orders of the two are asked; they must say the same.
int collide(const Solid& a, const Solid& b, dContactGeom* found, bool turned)
{
    if (!turned) return dCollide(a.geom(), b.geom(), 8, found, sizeof(dContactGeom));
    const int n = dCollide(b.geom(), a.geom(), 8, found, sizeof(dContactGeom));
    for (int i = 0; i < n; ++i)
        for (int k = 0; k < 3; ++k) found[i].normal[k] = -found[i].normal[k];
    return n;
}

// Box on box takes a face's normal unless an edge's is better by a twentieth, and its points of two edges may
// tell that much less.
double allowed(const std::string& first, const std::string& second, double depth)
{
    return first == "box" && second == "box" ? 0.06 * depth : 0;
}

// The first few; later ones are counted only.
void complain(const char* what, int pose, double ours, double reference)
{
    static int said = 0;
    if (++said > 40) return;
    std::printf("  pose %d: %s, depth %.9g, reference %.9g\n", pose, what, ours, reference);
}

Table run(const std::string& first, const std::string& second, const Options& options)
{
    Table table;
    Dice dice(options.seed * 1000003u + first.size() * 31 + second.size() * 7 +
              unsigned(first[2] * 3 + second[2]));
    for (int i = 0; i < options.poses; ++i) {
        Solid a(first, dice), b(second, dice);
        draw(a, b, dice);
        const double size = a.reach() + b.reach();
        dContactGeom found[8];
        const int n = collide(a, b, found, i % 2 == 1);
        Point way;
        const double apart = distance(a, b, way);
        if (apart > 0) {
            if (n > 0 && apart > kTouch)
                ++table.wrong, complain("hit while apart", i, double(found[0].depth), -apart);
            if (n == 0) continue;
        }
        const Overlap least = apart > 0 ? Overlap{-apart, way} : least_overlap(a, b, options.directions);
        if (n == 0) {
            if (least.depth > kTouch) ++table.wrong, complain("missed", i, 0, least.depth);
            continue;
        }
        ++table.hits;
        double depth = 0;
        for (int k = 0; k < n; ++k) depth = std::fmax(depth, double(found[k].depth));
        const Point normal = {double(found[0].normal[0]), double(found[0].normal[1]),
                              double(found[0].normal[2])};
        const double deeper = (depth - std::fmax(least.depth, 0) - allowed(first, second, depth)) / size;
        const double left = (overlap_along(a, b, normal) - depth - allowed(first, second, depth)) / size;
        if (deeper > kDeeper) complain("too deep", i, depth, least.depth);
        if (left > kLeft) complain("does not part", i, depth, overlap_along(a, b, normal));
        table.deeper = std::fmax(table.deeper, deeper), table.left = std::fmax(table.left, left);
        table.mean += std::fabs(deeper);
    }
    return table;
}

bool parse(int argc, char** argv, Options& options)
{
    for (int i = 1; i < argc; ++i) {
        const auto is = [&](const char* name, int more) {
            return !std::strcmp(argv[i], name) && i + more < argc;
        };
        if (is("--poses", 1))
            options.poses = std::atoi(argv[++i]);
        else if (is("--directions", 1))
            options.directions = std::atoi(argv[++i]);
        else if (is("--seed", 1))
            options.seed = unsigned(std::atoi(argv[++i]));
        else if (is("--pair", 2))
            options.first = argv[i + 1], options.second = argv[i + 2], i += 2;
        else
            return false;
    }
    return options.poses > 0 && options.directions > 99;
}

}  // namespace

int main(int argc, char** argv)
{
    Options options;
    if (!parse(argc, argv, options)) {
        std::fputs("usage: reference_pairs [--poses N] [--directions N] [--pair KIND KIND] [--seed N]\n",
                   stderr);
        return 2;
    }
    dInitODE();
    std::printf("%-20s%8s%8s%8s%12s%12s%12s\n", "pair", "poses", "hits", "wrong", "deeper", "mean", "left");
    bool good = true;
    int pairs = 0;
    for (std::size_t i = 0; i < std::size(kKinds); ++i)
        for (std::size_t j = i; j < std::size(kKinds); ++j) {
            const std::string first = kKinds[i], second = kKinds[j];
            if (first == "plane" ||
                (!options.first.empty() && (first != options.first || second != options.second)))
                continue;
            const Table t = run(first, second, options);
            std::printf("%-20s%8d%8d%8d%12.1e%12.1e%12.1e\n", (first + "-" + second).c_str(), options.poses,
                        t.hits, t.wrong, t.deeper, t.hits ? t.mean / t.hits : 0, t.left);
            std::fflush(stdout);
            good =
                good && t.wrong == 0 && t.deeper <= kDeeper && t.left <= kLeft && t.hits > options.poses / 8;
            ++pairs;
        }
    dCloseODE();
    return good && pairs > 0 ? 0 : 1;
}
