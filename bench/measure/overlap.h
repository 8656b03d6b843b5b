// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// How far two placed convex shapes overlap, without any engine: the least over unit vectors d of
//   f(d) = max over a in A of a.d - min over b in B of b.d ,
// which is the shortest way to move them apart; not above zero, and then no measure, when they are apart.
// Tried are the directions that can be least for boxes and hulls (face normals, products of the edges of two
// boxes) and the line of the centres; for all but two boxes the best of them is then improved by walking over
// the sphere in steps that shrink to 1e-5 rad. dCollide of the library at hand was the alternative: it would
// judge itself.
#pragma once

#include "bench/scenes/drive.h"

namespace epode::bench {

struct Placed {
    const ShapeData* shape;
    Vec pos;
    Turn turn;
};

double overlap(const Placed& a, const Placed& b);

// The point of the shape that lies farthest along d.
Vec support(const Placed& placed, Vec d);

// How deep the shape reaches below the terrain, measured along the terrain's normal, at its own extreme
// points in 26 directions.
double overlap(const Placed& placed, const Terrain& terrain);

struct Bounds {
    Vec low, high;
};
Bounds bounds(const Placed& placed);

}  // namespace epode::bench
