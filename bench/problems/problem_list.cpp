// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
//   box, stack  boxes on the ground and on each other, 4 contacts and 12 rows each
//   rest        a stack at rest: every step finds the state and the impulses of the last
//   chain       links on ball joints from the world, 3 rows a link; heavy: the last one weighs 100 others
//   ladder      two rails and rungs on parallel hinges: a closed loop a rung, 20 rows for its 18 freedoms
//   wall        bricks in running bond; 4 contacts where two overlap. Every brick has a velocity of its own,
//               so that about half of the contacts part and most others slide
//   gable       a wall of which every course is a brick shorter, at small velocities
//   pile        boxes caught while they fall into a pile, from a file (pile.h)
#include "bench/problems/problem_list.h"

#include <fmt/format.h>

#include <algorithm>

#include "bench/problems/pile.h"

namespace epode::bench {

namespace {

using namespace scenes;

constexpr double kDensity = 1000;
constexpr double kOverlap = 0.001;  // depth of the contacts of boxes and bricks
constexpr double kMovingSpread = 0.5;
constexpr int kRowsPerWorld = 600;

dMass box_mass(Vec size)
{
    dMass mass;
    dMassSetBox(&mass, dReal(kDensity), dReal(size.x), dReal(size.y), dReal(size.z));
    return mass;
}

// Four contacts at the corners of a horizontal rectangle, pushing body1 up.
void add_footing(Problem& problem, int body1, int body2, double left, double right, Vec middle, double half_y)
{
    for (double x : {left, right}) {
        for (double y : {middle.y - half_y, middle.y + half_y})
            problem.add_contact({body1, body2, {x, y, middle.z}, kZ, kOverlap});
    }
}

bool add_stack(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    const Vec size{1, 1, 0.5};
    const double pitch = size.z - kOverlap;
    int under = kStatic;
    for (int i = 0; i < recipe.size; ++i) {
        const Vec base = at + (i * pitch) * kZ;
        const int box = problem.add_body(box_mass(size), base + (size.z / 2 - kOverlap) * kZ);
        add_footing(problem, box, under, at.x - size.x / 2, at.x + size.x / 2, base, size.y / 2);
        under = box;
    }
    return true;
}

// Every step begins with what the last one ended with: its impulses are this one's.
bool add_resting_stack(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    problem.set_spread(0);
    return add_stack(problem, recipe, at);
}

bool add_moving_box(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    problem.set_spread(kMovingSpread);
    return add_stack(problem, recipe, at);
}

// A zigzag, so that no direction is special.
void add_links(Problem& problem, int count, double last_mass, Vec joint)
{
    const double radius = 0.05, pitch = 0.3, slope = 0.15;
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
}

bool add_chain(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    add_links(problem, recipe.size, 1, at);
    return true;
}

bool add_heavy_chain(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    add_links(problem, recipe.size, 100, at);
    return true;
}

bool add_ladder(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    const double height = 0.5, width = 1;
    const dMass rail = box_mass({0.1, 0.1, height}), rung = box_mass({width, 0.1, 0.1});
    int below[2] = {kStatic, kStatic};
    for (int i = 0; i < recipe.size; ++i) {
        const Vec base = at + (i * height) * kZ, top = base + height * kZ;
        int side[2];
        for (int k = 0; k < 2; ++k) {
            side[k] = problem.add_body(rail, base + Vec{k * width, 0, height / 2});
            problem.add_hinge(side[k], below[k], base + (k * width) * kX, kY);
        }
        const int across = problem.add_body(rung, top + (width / 2) * kX);
        for (int k = 0; k < 2; ++k) {
            problem.add_hinge(across, side[k], top + (k * width) * kX, kY);
            below[k] = side[k];
        }
    }
    return true;
}

struct Brick {
    int body;
    double x;  // of its middle
};

// One course upon another; `under` empty: upon the ground.
std::vector<Brick> add_course(Problem& problem, const std::vector<Brick>& under, int count, Vec first)
{
    const Vec size{1, 0.5, 0.5};
    const double pitch = 1.05, half_x = size.x / 2, half_y = size.y / 2;
    std::vector<Brick> course;
    for (int i = 0; i < count; ++i) {
        const double x = first.x + pitch * i;
        const int body = problem.add_body(box_mass(size), {x, first.y, first.z + size.z / 2 - kOverlap});
        course.push_back({body, x});
        if (under.empty()) add_footing(problem, body, kStatic, x - half_x, x + half_x, first, half_y);
        for (const Brick& brick : under) {
            const double left = std::max(x, brick.x) - half_x, right = std::min(x, brick.x) + half_x;
            if (left < right) add_footing(problem, body, brick.body, left, right, first, half_y);
        }
    }
    return course;
}

void add_courses(Problem& problem, const ProblemRecipe& recipe, Vec at, bool gable)
{
    const double half_pitch = 0.525, pitch_z = 0.5 - kOverlap;
    std::vector<Brick> under;
    for (int i = 0; i < recipe.height; ++i) {
        const double shift = half_pitch * (gable ? i : i % 2);
        under = add_course(problem, under, recipe.size - (gable ? i : 0), at + Vec{shift, 0, i * pitch_z});
    }
}

bool add_gable(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    add_courses(problem, recipe, at, true);
    return true;
}

bool add_moving_wall(Problem& problem, const ProblemRecipe& recipe, Vec at)
{
    add_courses(problem, recipe, at, false);
    problem.set_spread(kMovingSpread);
    return true;
}

bool add_pile(Problem& problem, const ProblemRecipe& recipe, Vec) { return load_pile(problem, recipe.size); }

void append_sizes(std::vector<ProblemRecipe>& list)
{
    const auto append = [&](const char* kind, int rows, auto add, int size, int height) {
        const int copies = std::max(1, kRowsPerWorld / rows);
        list.push_back({fmt::format("size-{}-{}", kind, rows), add, size, height, copies});
    };
    for (int links : {4, 8, 20, 32, 50, 67, 100}) append("chain", 3 * links, add_chain, links, 1);
    for (int boxes : {1, 2, 5, 8, 13, 17, 25}) append("stack", 12 * boxes, add_stack, boxes, 1);
    for (int boxes : {1, 2, 3, 5}) append("rest", 12 * boxes, add_resting_stack, boxes, 1);
    append("gable", 48, add_gable, 2, 2);
    append("gable", 84, add_gable, 3, 2);
    append("gable", 108, add_gable, 3, 3);
    append("gable", 168, add_gable, 4, 3);
    append("gable", 192, add_gable, 4, 4);
    append("gable", 288, add_gable, 6, 3);
}

}  // namespace

const std::vector<ProblemRecipe>& all_problems()
{
    static const std::vector<ProblemRecipe> list = [] {
        std::vector<ProblemRecipe> problems = {
            {"box", add_moving_box, 1},         {"chain-8", add_chain, 8},
            {"pile-20", add_pile, 20},          {"chain-32-heavy", add_heavy_chain, 32},
            {"chain-100", add_chain, 100},      {"wall-16", add_moving_wall, 4, 4},
            {"chain-400", add_chain, 400},      {"ladder-64", add_ladder, 64},
            {"wall-49", add_moving_wall, 7, 7}, {"pile-100", add_pile, 100},
            {"chain-800", add_chain, 800},      {"wall-1024", add_moving_wall, 32, 32},
            {"chain-4096", add_chain, 4096},
        };
        append_sizes(problems);
        return problems;
    }();
    return list;
}

const ProblemRecipe* find_problem(const std::string& name)
{
    for (const ProblemRecipe& recipe : all_problems()) {
        if (name == recipe.name) return &recipe;
    }
    return nullptr;
}

bool build_problem(Problem& problem, const ProblemRecipe& recipe)
{
    for (int i = 0; i < recipe.copies; ++i) {
        if (!recipe.add(problem, recipe, {0, 2.0 * i, 0})) return false;
    }
    return true;
}

}  // namespace epode::bench
