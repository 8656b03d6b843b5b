// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A benchmark scene as plain data, so that one generator serves every engine: no handle, no engine's type, no
// function of the running time but `driven` (drive.h). SI units, z up; poses are those of centres of mass. An
// engine reads it in engines/, or from JSON (export.h) outside this program; measure/ judges every engine's
// answer from this data alone. Scenes built by calls of ode/*.h, as in scenes/, were the alternative: no peer
// can read those.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "bench/scenes/terrain.h"
#include "scenes/vectors.h"

namespace epode::bench {

using scenes::Turn;
using scenes::Vec;

enum class ShapeKind { kSphere, kBox, kCapsule, kCylinder, kHull, kMesh };

struct ShapeData {
    ShapeKind kind = ShapeKind::kSphere;
    // box: full sides; sphere: radius in x; capsule and cylinder: radius in x, length along local z in y,
    // without the capsule's caps.
    Vec size;
    std::vector<Vec> points;                    // hull and mesh
    std::vector<std::array<int, 3>> triangles;  // of a hull outwards counterclockwise, of a mesh upwards
};

struct PartData {
    int shape = 0;
    Vec offset;
    Turn turn;
};

enum class Motion { kFixed, kDynamic, kDriven };

// Where a driven body is at any time: it spins about its centre and goes round a vertical axis.
struct DriveData {
    Vec spin;  // rad/s
    Vec axis_point;
    double orbit = 0;  // rad/s about z through axis_point
};

struct BodyData {
    Motion motion = Motion::kDynamic;
    std::vector<PartData> parts;  // a dynamic body has one, at its centre
    double mass = 0;
    Vec inertia;  // about the body's axes, kg m2; products of inertia of hulls are dropped for everybody
    Vec pos;
    Turn turn;
    Vec linear, angular;
    DriveData drive;
    bool collides = true;
    int group = 0;            // bodies of one group that is not 0 pass through one another
    std::optional<Vec> rest;  // where it should be at the end, if it should stand still
};

enum class JointKind { kBall, kHinge, kHinge2 };

struct JointData {
    JointKind kind = JointKind::kBall;
    int body1 = 0, body2 = 0;  // the pair does not collide
    Vec anchor;                // world, at the start, as the axes are
    Vec axis1, axis2;  // hinge: axis1; hinge2: axis1 steers (locked) and springs, axis2 is the wheel's
    double low = 0, high = 0;           // stops of a hinge, rad; none where low >= high
    double stiffness = 0, damping = 0;  // suspension of a hinge2 along axis1, N/m and N s/m
    double speed = 0, torque = 0;       // motor of a hinge2 about axis2, rad/s and N m at most
};

struct RayData {
    Vec from, to;
};

enum class Task { kSimulate, kRays, kBroadPhase };

struct SceneData {
    std::string name;
    int size = 0;
    Task task = Task::kSimulate;
    int steps = 0;
    double dt = 1.0 / 60, gravity = 9.81, friction = 0.6;
    bool exact = false;  // ODE: dWorldStep instead of dWorldQuickStep
    std::vector<ShapeData> shapes;
    std::vector<BodyData> bodies;
    std::vector<JointData> joints;
    std::vector<RayData> rays;
    std::optional<Terrain> terrain;  // also a shape, of a body of its own
    double lost_below = -2;          // a body whose centre is lower has fallen through
    double link = 1;                 // joint errors are measured in this length, m
    double cube_side = 0;            // broad phase: bodies fly in a cube of this side around the origin
};

}  // namespace epode::bench
