// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Lengths of tendons and what changes them. A fixed one's is the sum of its terms. A spatial one's path is straight from point to point
// and on surfaces between (wrap.h): since such a way is the shortest, only the motion of the ends u of its straight pieces along
// them changes its length,
//     L = sum (|p2 - p1| + arcs) / divisor,    dL/dt = sum u . (v2 - v1) / divisor,
// and a force f along L acts with f u / divisor on the links at those ends.
#pragma once

#include <span>

#include "robots/model.h"

namespace epode::robots {

// A straight piece between points of two links.
struct Piece {
    int link1 = 0, link2 = 0;
    Vec p1, p2;     // in the axes of the links' poses that the path was made with
    Vec direction;  // from p1 to p2, over the divisor; 0 where they are the same point
};

struct Path {
    double length = 0;
    std::vector<Piece> pieces;
};

Path path_of(const Tendon& tendon, const std::vector<Pose>& poses);

std::vector<double> tendon_lengths(const RobotModel& model, const std::vector<double>& positions);
// dL/ds, s being the velocities: a row of each of these tendons, or of all.
std::vector<double> tendon_moments(const RobotModel& model, const std::vector<double>& positions,
                                   std::span<const int> tendons);
std::vector<double> tendon_jacobian(const RobotModel& model, const std::vector<double>& positions);

}  // namespace epode::robots
