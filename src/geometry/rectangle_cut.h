// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The part of a parallelogram over a rectangle, |x| <= half_x and |y| <= half_y; z goes along. Its corners
// are at most eight of twelve: where each side of the parallelogram enters the rectangle (or begins inside),
// where it leaves (Liang and Barsky 1984), and corners of the rectangle over the parallelogram. All twelve
// are computed side by side, without a branch; cutting side after side (Sutherland and Hodgman,
// geometry/clip.h) is as exact, and four times as long a way.
#pragma once

#include "math/vec.h"

namespace epode {

// centre + s u + t v, |s| and |t| at most 1.
struct Parallelogram {
    Vec3 centre, u, v;
};

struct CutPoints {
    static constexpr int kMax = 12;
    union {
        alignas(16) Real at[3][kMax];  // x, y, z; in a union: left unwritten until computed
    };
    unsigned there = 0;       // a bit for each
    bool may_repeat = false;  // corners of the one lie on sides of the other: two of the points may be one
    CutPoints() {}
};

// Nearer than `slack` to a side is on it.
void cut_by_rectangle(const Parallelogram& face, Real half_x, Real half_y, Real slack, CutPoints& out);

}  // namespace epode
