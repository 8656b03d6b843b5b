// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots as learners have them, as plain data: a tree of links, no link turned against another at the start.
// The sizes are those of Gymnasium's Ant, HalfCheetah and Humanoid, so that MuJoCo can step the same machines
// (bench/robots); with them the smallest worlds, whose step is nearly all fixed cost.
#pragma once

#include <array>
#include <span>
#include <vector>

namespace epode::bench {

using Point = std::array<double, 3>;

// A capsule; a sphere where both ends are one point; a box with these half edges where the radius is 0.
struct LinkShape {
    Point from, to;
    double radius;
};

// A hinge, from `low` to `high` (rad; equal: without stops), with the drive on it and the largest torque of
// its motor, N m.
struct LinkAxis {
    Point axis;
    double low, high;
    double armature, damping, stiffness, torque;
};

struct Link {
    int parent;                  // -1: free
    Point origin;                // in the parent's frame
    Point anchor;                // of the joint, in its own frame
    std::vector<LinkAxis> axes;  // one: a hinge; two: a universal joint; three: a ball with an angular motor
    std::vector<LinkShape> shapes;
};

struct MechanismModel {
    const char* name;
    double h, density, friction;
    double height;       // of the first link's origin, along z, or along y in a planar model
    bool ground;         // there is a plane at height 0
    bool planar;         // the first link stays in the plane z = 0
    bool self_contacts;  // links touch each other
    std::vector<Link> links;
};

std::span<const MechanismModel> mechanism_models();

}  // namespace epode::bench
