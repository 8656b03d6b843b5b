// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Masses: a capsule is a cylinder and a sphere cut in two, whose halves stand off the middle; I of a half
// sphere about its flat side's middle is that of the sphere, 2/5 m r^2, and its centre is 3/8 r away.
#include "bench/scenes/words.h"

#include <utility>

namespace epode::bench {

namespace {

using scenes::kPi;

struct Weight {
    double mass;
    Vec inertia;
};

Weight cylinder_weight(double r, double l)
{
    const double mass = kPi * r * r * l, across = mass * (3 * r * r + l * l) / 12;
    return {mass, {across, across, mass * r * r / 2}};
}

Weight capsule_weight(double r, double l)
{
    const Weight middle = cylinder_weight(r, l);
    const double caps = 4.0 / 3 * kPi * r * r * r;
    const double across = caps * (0.4 * r * r + l * l / 4 + 3 * r * l / 8);
    return {middle.mass + caps, middle.inertia + Vec{across, across, 0.4 * caps * r * r}};
}

Weight box_weight(Vec s)
{
    const double mass = s.x * s.y * s.z;
    return {mass, (mass / 12) * Vec{s.y * s.y + s.z * s.z, s.x * s.x + s.z * s.z, s.x * s.x + s.y * s.y}};
}

Weight hull_weight(const ShapeData& hull)
{
    const Solid solid = integrate(hull);
    const Vec s = solid.second;
    return {solid.volume, {s.y + s.z, s.x + s.z, s.x + s.y}};
}

Weight weight(const ShapeData& shape)  // at density 1
{
    const double r = shape.size.x;
    switch (shape.kind) {
        case ShapeKind::kSphere: {
            const double mass = 4.0 / 3 * kPi * r * r * r, i = 0.4 * mass * r * r;
            return {mass, {i, i, i}};
        }
        case ShapeKind::kBox:
            return box_weight(shape.size);
        case ShapeKind::kCapsule:
            return capsule_weight(r, shape.size.y);
        case ShapeKind::kCylinder:
            return cylinder_weight(r, shape.size.y);
        case ShapeKind::kHull:
            return hull_weight(shape);
        case ShapeKind::kMesh:
            break;
    }
    return {0, {}};
}

ShapeData round(ShapeKind kind, double radius, double length) { return {kind, {radius, length, 0}, {}, {}}; }

ShapeData mesh_of(const Terrain& terrain)
{
    ShapeData mesh{ShapeKind::kMesh, {}, {}, {}};
    const int across = terrain.cells + 1;
    for (int j = 0; j < across; ++j) {
        for (int i = 0; i < across; ++i)
            mesh.points.push_back({terrain.coordinate(i), terrain.coordinate(j), terrain.vertex(i, j)});
    }
    for (int j = 0; j < terrain.cells; ++j) {
        for (int i = 0; i < terrain.cells; ++i) {
            const int low = j * across + i, high = low + across + 1;
            mesh.triangles.push_back({low, low + 1, high});
            mesh.triangles.push_back({low, high, high - 1});
        }
    }
    return mesh;
}

}  // namespace

ShapeData sphere(double radius) { return round(ShapeKind::kSphere, radius, 0); }
ShapeData box(Vec sides) { return {ShapeKind::kBox, sides, {}, {}}; }
ShapeData capsule(double radius, double length) { return round(ShapeKind::kCapsule, radius, length); }
ShapeData cylinder(double radius, double length) { return round(ShapeKind::kCylinder, radius, length); }

int add_shape(SceneData& scene, ShapeData shape)
{
    scene.shapes.push_back(std::move(shape));
    return int(scene.shapes.size()) - 1;
}

int add_body(SceneData& scene, int shape, Vec pos, Turn turn, double density)
{
    const Weight unit = weight(scene.shapes[size_t(shape)]);
    BodyData body;
    body.parts = {{shape, {}, {}}};
    body.mass = density * unit.mass;
    body.inertia = density * unit.inertia;
    body.pos = pos;
    body.turn = turn;
    scene.bodies.push_back(body);
    return int(scene.bodies.size()) - 1;
}

int add_static(SceneData& scene, int shape, Vec pos, Turn turn)
{
    BodyData body;
    body.motion = Motion::kFixed;
    body.parts = {{shape, {}, {}}};
    body.pos = pos;
    body.turn = turn;
    scene.bodies.push_back(body);
    return int(scene.bodies.size()) - 1;
}

void set_mass(BodyData& body, double mass)
{
    body.inertia = (mass / body.mass) * body.inertia;
    body.mass = mass;
}

void add_floor(SceneData& scene, double half)
{
    add_static(scene, add_shape(scene, box({2 * half, 2 * half, 2})), {0, 0, -1});
}

void add_pit(SceneData& scene, double side, double height)
{
    const double out = side / 2 + 1;
    add_floor(scene, out + 1);
    const int along_x = add_shape(scene, box({side + 4, 2, height}));
    const int along_y = add_shape(scene, box({2, side + 4, height}));
    for (double sign : {-1.0, 1.0}) {
        add_static(scene, along_x, {0, sign * out, height / 2});
        add_static(scene, along_y, {sign * out, 0, height / 2});
    }
}

void add_terrain(SceneData& scene, Terrain terrain)
{
    add_static(scene, add_shape(scene, mesh_of(terrain)), {});
    scene.terrain = std::move(terrain);
}

int add_ball(SceneData& scene, int body1, int body2, Vec anchor)
{
    JointData joint;
    joint.body1 = body1;
    joint.body2 = body2;
    joint.anchor = anchor;
    scene.joints.push_back(joint);
    return int(scene.joints.size()) - 1;
}

int add_hinge(SceneData& scene, int body1, int body2, Vec anchor, Vec axis, double low, double high)
{
    const int number = add_ball(scene, body1, body2, anchor);
    JointData& joint = scene.joints.back();
    joint.kind = JointKind::kHinge;
    joint.axis1 = axis;
    joint.low = low;
    joint.high = high;
    return number;
}

std::vector<int> add_mixed_shapes(SceneData& scene, bool hulls, Lcg& random)
{
    constexpr int kOfEach = 8;
    std::vector<int> shapes;
    const auto size = [&] { return random.uniform(0.5, 1.0); };
    for (int i = 0; i < kOfEach; ++i) {
        shapes.push_back(add_shape(scene, sphere(size() / 2)));
        shapes.push_back(add_shape(scene, box({size(), size(), size()})));
        shapes.push_back(add_shape(scene, capsule(size() / 3, size() / 2)));
        shapes.push_back(add_shape(scene, cylinder(size() / 2, size())));
        if (hulls) shapes.push_back(add_shape(scene, make_hull(random_points(20, size() / 1.7, random))));
    }
    return shapes;
}

}  // namespace epode::bench
