// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Pairs of shapes whose points have no closed form: what lanes need to know which copies may touch, and the shapes that the library's own
// pair functions are asked about.
#pragma once

#include <memory>
#include <vector>

#include "robots/build.h"

namespace epode::batch {

// A shape, or one hull of a mesh that has several.
struct AskedShape {
    int number = 0;  // among the model's shapes
    const robots::Shape* shape = nullptr;
    int part = 0;
};

// One shape lies within a ball, the other within a box, each in its own axes; a plane has no box.
struct AskedPair {
    int shape_a = 0, shape_b = 0;  // in AskedPairs
    bool is_plane = false, is_landscape = false;
    double ball[3] = {}, radius = 0;
    double middle[3] = {}, half[3] = {};
};

struct AskedPairs {
    std::shared_ptr<const robots::Prepared> prepared;  // which has the shapes
    std::vector<AskedShape> shapes;
    std::vector<AskedPair> pairs;
    // A new pair; returns its number.
    int add(const AskedShape& a, const AskedShape& b);
    // Whether a shape is best the second of a pair: planes and landscapes always, else the larger one.
    double rank(const AskedShape& its) const;
};

// At most, of a pair.
int asked_points(const robots::Shape& a, const robots::Shape& b);

// One copy's, in axes that both poses share. The normal points from b to a; 0 or fewer: an overlap.
struct AskedPoint {
    double gap, point[3], normal[3];
};
struct AskedPose {
    double at[3], turn[9];  // row by row
};

// Whom the kernels of one thread ask: points nearer than `reach`, at most `most`. Returns how many.
struct Asker {
    void* context = nullptr;
    int (*ask)(void* context, int pair, const AskedPose& a, const AskedPose& b, double reach, double layer,
               int most, AskedPoint* out) = nullptr;
};

}  // namespace epode::batch
