// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
//   box     one box on the ground, 4 contacts
//   chain   links on ball joints from the world, 3 rows a link; heavy: the last one weighs 100 others
//   ladder  two rails and rungs on parallel hinges: a closed loop a rung, 20 rows for its 18 freedoms
//   wall    bricks in running bond, as many courses as bricks in one; 4 contacts where two overlap. Every
//           brick has a velocity of its own, so that about half of the contacts part and most others slide
//   pile    boxes caught while they fall into a heap, from a file (pile.h)
#include "bench/problem_list.h"

#include <algorithm>

#include "bench/pile.h"

namespace epode::bench {

namespace {

using namespace scenes;

constexpr double kDensity = 1000;
constexpr double kOverlap = 0.001;  // depth of the contacts of box and wall
constexpr double kMovingSpread = 0.5;

dMass box_mass(Vec size)
{
    dMass mass;
    dMassSetBox(&mass, dReal(kDensity), dReal(size.x), dReal(size.y), dReal(size.z));
    return mass;
}

// Four contacts at the corners of a horizontal rectangle, pushing body1 up.
void add_footing(Problem& problem, int body1, int body2, double left, double right, double half_y, double z)
{
    for (double x : {left, right}) {
        for (double y : {-half_y, half_y}) problem.add_contact({body1, body2, {x, y, z}, kZ, kOverlap});
    }
}

bool build_box(Problem& problem, int)
{
    const Vec size{1, 1, 0.5};
    const int box = problem.add_body(box_mass(size), {0, 0, size.z / 2 - kOverlap});
    add_footing(problem, box, kStatic, -size.x / 2, size.x / 2, size.y / 2, 0);
    problem.set_spread(kMovingSpread);
    return true;
}

// A zigzag, so that no direction is special.
bool add_links(Problem& problem, int count, double last_mass)
{
    const double radius = 0.05, pitch = 0.3, slope = 0.15;
    Vec joint{0, 0, 0};
    int previous = kStatic;
    for (int i = 0; i < count; ++i) {
        const Turn q = turn(kY, kPi / 2 + (i % 2 ? slope : -slope));
        const Vec half = rotate(q, (pitch / 2) * kZ);
        dMass mass;
        dMassSetCapsule(&mass, dReal(kDensity), 3, dReal(radius), dReal(pitch - 2 * radius));
        if (i == count - 1) dMassAdjust(&mass, dReal(last_mass * mass.mass));
        const int link = problem.add_body(mass, joint + half, q);
        problem.add_ball(link, previous, joint);
        joint = joint + 2.0 * half;
        previous = link;
    }
    return true;
}

bool build_chain(Problem& problem, int count) { return add_links(problem, count, 1); }
bool build_heavy_chain(Problem& problem, int count) { return add_links(problem, count, 100); }

bool build_ladder(Problem& problem, int loops)
{
    const double height = 0.5, width = 1;
    const dMass rail = box_mass({0.1, 0.1, height}), rung = box_mass({width, 0.1, 0.1});
    int below[2] = {kStatic, kStatic};
    for (int i = 0; i < loops; ++i) {
        const double z = i * height;
        int side[2];
        for (int k = 0; k < 2; ++k) {
            side[k] = problem.add_body(rail, {k * width, 0, z + height / 2});
            problem.add_hinge(side[k], below[k], {k * width, 0, z}, kY);
        }
        const int across = problem.add_body(rung, {width / 2, 0, z + height});
        for (int k = 0; k < 2; ++k) {
            problem.add_hinge(across, side[k], {k * width, 0, z + height}, kY);
            below[k] = side[k];
        }
    }
    return true;
}

bool build_wall(Problem& problem, int across)
{
    const Vec size{1, 0.5, 0.5};
    const double pitch_x = 1.05, pitch_z = size.z - kOverlap, half_x = size.x / 2, half_y = size.y / 2;
    const auto middle = [&](int course, int i) { return pitch_x * (i + (course % 2 ? 0.5 : 0.0)); };
    for (int course = 0; course < across; ++course) {
        const double base = course * pitch_z - kOverlap;
        for (int i = 0; i < across; ++i) {
            const double x = middle(course, i);
            const int brick = problem.add_body(box_mass(size), {x, 0, base + size.z / 2});
            if (course == 0) add_footing(problem, brick, kStatic, x - half_x, x + half_x, half_y, 0);
            for (int k = 0; course > 0 && k < across; ++k) {
                const double under = middle(course - 1, k);
                const double left = std::max(x, under) - half_x, right = std::min(x, under) + half_x;
                if (left < right)
                    add_footing(problem, brick, (course - 1) * across + k, left, right, half_y, base);
            }
        }
    }
    problem.set_spread(kMovingSpread);
    return true;
}

}  // namespace

const std::vector<ProblemRecipe>& all_problems()
{
    static const std::vector<ProblemRecipe> list = {
        {"box", build_box, 1},
        {"chain-8", build_chain, 8},
        {"pile-20", load_pile, 20},
        {"chain-32-heavy", build_heavy_chain, 32},
        {"chain-100", build_chain, 100},
        {"wall-16", build_wall, 4},
        {"chain-400", build_chain, 400},
        {"ladder-64", build_ladder, 64},
        {"wall-49", build_wall, 7},
        {"pile-100", load_pile, 100},
        {"chain-800", build_chain, 800},
        {"wall-1024", build_wall, 32},
        {"chain-4096", build_chain, 4096},
    };
    return list;
}

const ProblemRecipe* find_problem(const std::string& name)
{
    for (const ProblemRecipe& recipe : all_problems()) {
        if (name == recipe.name) return &recipe;
    }
    return nullptr;
}

}  // namespace epode::bench
