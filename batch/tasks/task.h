// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a vector of environments asks of a batch, as data: a new task is a few lines of it. All numbers are those of one copy.
#pragma once

#include <array>
#include <limits>
#include <vector>

#include "batch/batch.h"

namespace epode::batch {

constexpr double kUnbounded = std::numeric_limits<double>::infinity();

// Numbers next to each other, less others of the same quantity if `minus` is not below 0, and less commands if `command` is not:
// clip(scale (f(x) - offset), low, high).
struct Piece {
    // kActionChange: from the last step's action; kCommand: what the episode asks for; kDirection: a direction of the world; kRow: of the
    // curriculum; kHeight: of a link's origin above the ground at places around it.
    enum class Source { kQuantity, kAction, kPoint, kActionChange, kCommand, kDirection, kRow, kHeight };
    enum class Function { kNone, kSine, kCosine };
    Source source = Source::kQuantity;
    Quantity quantity = Quantity::kPositions;
    int first = 0, count = 0, minus = -1, command = -1;
    Function function = Function::kNone;
    double offset = 0, scale = 1, low = -kUnbounded, high = kUnbounded;
    int link = 0;  // of a point, whose numbers are x, y, z,
    double point[3] = {
        0, 0,
        0};  // in the axes of its link; or the direction in the world's, whose numbers are in its link's
    int axes_of = -1;  // of a quantity's vector, the link in whose axes its numbers are; -1: the world's
    std::vector<std::array<double, 2>>
        places;  // of heights: from the link's origin, x where the link's x heads
};

// clip(weight f(x), low, high), of the numbers x of a piece; kGaussian: exp(-x.x / width).
struct Term {
    enum class Kind { kConstant, kHealthy, kRate, kSum, kSquares, kLength, kGaussian };
    Kind kind = Kind::kConstant;
    Piece piece;
    double weight = 1, low = -kUnbounded, high = kUnbounded, width = 1;
    int column = -1;        // of the infos, to which it is added
    bool is_reward = true;  // else only an info
    bool at_reset = false;  // an info after resets, too
    int rate = -1;          // which of the rates it is
};

// Out of it a copy is not healthy.
struct Range {
    Piece piece;
    double low = -kUnbounded, high = kUnbounded;
    bool is_open = false;  // low and high are outside
};

// Coordinates or velocities at the begin of an episode: the reference (if relative) plus what is drawn, again until the length of all
// of them is within bounds.
struct Start {
    bool is_velocity = false, is_normal = false, is_relative = true;
    int first = 0;
    std::vector<double> low, high;  // normal: mean and deviation
    double min_length = -1, max_length = kUnbounded;
};

// A parameter of the model that each episode draws: one number for all of them or one for each, in place of the model's or times it.
struct Draw {
    Parameter parameter = Parameter::kFrictions;
    bool is_normal = false, scales = false, is_each = false;
    double low = 0, high = 0;  // normal: mean and deviation
};

// What is asked of a copy, as numbers between low and high: drawn when an episode begins and every so many steps, 0: never again. All
// are 0 in that share of draws.
struct Commands {
    std::vector<double> low, high;
    int steps = 0;
    double none = 0;
};

// A landscape of fields, in rows of equal difficulty: rows count along x, of a spacing each, columns along y. An episode begins on a
// field of its copy's row (Parameter::kTerrain), in any column: a row higher if the last one led farther than `up` from its begin, a
// row lower if not as far as `down`; whoever passes the last row begins in any. The first is below `first_rows`.
struct Curriculum {
    int rows = 0, columns = 0, first_rows = 1;  // 0: there is none
    double spacing = 0, up = 0, down = 0;       // m
};

struct Task {
    std::vector<Piece> observation;
    std::vector<Term> terms;
    std::vector<Range> healthy;
    std::vector<Start> starts;
    std::vector<Draw> draws;
    Commands commands;
    Curriculum curriculum;
    std::vector<double> noise;  // deviations of the observation's numbers; empty: none
    std::vector<double>
        choices;  // of discrete actions the controls, side by side; empty: actions are controls
    int columns = 0, frame_skip = 1, time_limit = 0;  // 0: none
    bool terminates = true;                           // where it is not healthy

    int observation_size() const
    {
        int sum = 0;
        for (const Piece& piece : observation) sum += piece.count;
        return sum;
    }
};

}  // namespace epode::batch
