// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Structures that stand or hang still, with feedback on their joints: what the tests of switches between methods
// and of loads are about.
#pragma once

#include <algorithm>
#include <deque>

#include "rig.h"

namespace epode::physics {

class Structure : public Sim {
  public:
    Structure() { gravity(0, 0, -9.81); }

    dJointID fix(dBodyID a, dBodyID b)
    {
        const dJointID joint = dJointCreateFixed(world, nullptr);
        dJointAttach(joint, a, b);
        dJointSetFixed(joint);
        return watch(joint);
    }
    dJointID hinge(dBodyID a, dBodyID b, V3 at)
    {
        const dJointID joint = dJointCreateHinge(world, nullptr);
        dJointAttach(joint, a, b);
        dJointSetHingeAnchor(joint, real(at.x), real(at.y), real(at.z));
        dJointSetHingeAxis(joint, 0, 1, 0);
        return watch(joint);
    }

    // The forces of the joints on their first bodies.
    std::vector<V3> forces() const
    {
        std::vector<V3> out;
        for (const dJointFeedback& f : feedback_) out.push_back(vec(f.f1));
        return out;
    }
    double largest_force() const
    {
        double largest = 0;
        for (const V3& f : forces()) largest = std::max(largest, length(f));
        return largest;
    }
    double fastest() const
    {
        double v = 0;
        for (dBodyID b : bodies) v = std::max(v, length(velocity(b)));
        return v;
    }

    std::vector<dJointID> joints;

  private:
    dJointID watch(dJointID joint)
    {
        feedback_.emplace_back();
        dJointSetFeedback(joint, &feedback_.back());
        joints.push_back(joint);
        return joint;
    }
    std::deque<dJointFeedback> feedback_;  // must not move
};

// Bricks on fixed joints, each to its neighbours and to those below, the lowest also to the world.
inline void build_wall(Structure& s, int rows, int columns)
{
    const std::vector<dBodyID> row(std::size_t(columns), nullptr);
    std::vector<std::vector<dBodyID>> b(std::size_t(rows), row);
    const auto at = [&](int r, int i) -> dBodyID& { return b[std::size_t(r)][std::size_t(i)]; };
    for (int r = 0; r < rows; ++r)
        for (int i = 0; i < columns; ++i)
            at(r, i) = s.box({(i + (r % 2 ? 0.5 : 0)) * 0.5, 0, 0.125 + r * 0.25}, {0.5, 0.25, 0.25}, 60);
    for (int r = 0; r < rows; ++r)
        for (int i = 0; i < columns; ++i) {
            if (i < columns - 1) s.fix(at(r, i), at(r, i + 1));
            if (r == 0) s.fix(at(r, i), nullptr);
            if (r == rows - 1) continue;
            s.fix(at(r, i), at(r + 1, i));
            const int k = r % 2 ? i + 1 : i - 1;
            if (k >= 0 && k < columns) s.fix(at(r, i), at(r + 1, k));
        }
}

// Planks from one bank to the other, on fixed joints.
inline void build_bridge(Structure& s, int planks)
{
    dBodyID last = nullptr;
    for (int i = 0; i < planks; ++i) {
        const dBodyID plank = s.box({0.5 * i, 0, 3}, {0.48, 1, 0.1}, 20);
        last ? s.fix(last, plank) : s.fix(plank, nullptr);
        last = plank;
    }
    s.fix(last, nullptr);
}

// The same on hinges, hanging in the shape that a cable with equal spans has: the polygon of its forces.
inline void build_hanging_bridge(Structure& s, int planks)
{
    const double span = 0.5, pull = 20 * 9.81 * planks;  // the horizontal force
    double x = 0, z = 5;
    dBodyID last = nullptr;
    for (int i = 0; i < planks; ++i) {
        const double slope = (i - (planks - 1) / 2.0) * 20 * 9.81 / pull;
        const double dx = span / std::sqrt(1 + slope * slope), dz = slope * dx;
        const dBodyID plank = s.box({x + dx / 2, 0, z + dz / 2}, {0.4, 1, 0.1}, 20);
        last ? s.hinge(last, plank, {x, 0, z}) : s.hinge(plank, nullptr, {x, 0, z});
        last = plank, x += dx, z += dz;
    }
    s.hinge(last, nullptr, {x, 0, z});
}

// A mast, an arm on a hinge, a strut that holds it, and a load.
inline void build_crane(Structure& s)
{
    const dBodyID mast = s.box({0, 0, 2.5}, {0.4, 0.4, 5}, 500), arm = s.box({2, 0, 5.1}, {4, 0.3, 0.3}, 200);
    const dBodyID strut = s.box({1.2, 0, 4.1}, {0.1, 0.1, 2}, 20),
                  load = s.box({4, 0, 4}, {0.5, 0.5, 0.5}, 400);
    s.fix(mast, nullptr);
    s.hinge(mast, arm, {0, 0, 5.1});
    s.hinge(mast, strut, {0.2, 0, 3.2});
    s.hinge(strut, arm, {2, 0, 5});
    s.hinge(arm, load, {4, 0, 5});
}

}  // namespace epode::physics
