// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A bowl of triangles catches thirty balls, boxes and capsules: all stay in it, none falls through, all come
// to rest.
#include <cmath>
#include <vector>

#include "stage.h"

constexpr int kRings = 10, kSides = 32, kBodies = 30;
static dGeomID solids[kBodies];
static std::vector<float> vertices;
static std::vector<dTriIndex> triangles;

static double height(double r) { return 0.1 + 0.35 * r * r; }

static void make_bowl()
{
    for (int ring = 0; ring <= kRings; ++ring) {
        for (int side = 0; side < kSides; ++side) {
            const double r = 0.02 + 0.2 * ring, turn = 2 * M_PI * side / kSides;
            for (const double x : {r * std::cos(turn), r * std::sin(turn), height(r)})
                vertices.push_back(static_cast<float>(x));
        }
    }
    const auto corner = [](int ring, int side) {
        return static_cast<dTriIndex>(ring * kSides + side % kSides);
    };
    for (int ring = 0; ring < kRings; ++ring) {
        for (int side = 0; side < kSides; ++side) {
            for (const dTriIndex i : {corner(ring, side), corner(ring + 1, side), corner(ring + 1, side + 1),
                                      corner(ring, side), corner(ring + 1, side + 1), corner(ring, side + 1)})
                triangles.push_back(i);
        }
    }
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(data, vertices.data(), 3 * sizeof(float),
                                static_cast<int>(vertices.size() / 3), triangles.data(),
                                static_cast<int>(triangles.size()), 3 * sizeof(dTriIndex));
    demo::paint(demo::draw(dCreateTriMesh(demo::space, data, nullptr, nullptr, nullptr)), 0.75f, 0.85f,
                0.95f);
}

static void build()
{
    make_bowl();
    demo::friction = 0.6;
    for (int i = 0; i < kBodies; ++i) {
        const double x = 0.45 * (i % 3 - 1), y = 0.45 * (i / 3 % 3 - 1), z = 1.6 + 0.4 * (i / 9);
        solids[i] = i % 3 == 0   ? demo::sphere(x, y, z, 0.15)
                    : i % 3 == 1 ? demo::box(x, y, z, 0.25, 0.25, 0.2)
                                 : demo::capsule(x, y, z, 0.1, 0.2);
        dBodySetAngularDamping(demo::body(solids[i]), 0.01);
    }
}

static void judge()
{
    for (int i = 0; i < kBodies; ++i) {
        const dReal *p = demo::place(solids[i]), *v = dBodyGetLinearVel(demo::body(solids[i]));
        const double r = std::hypot(p[0], p[1]);
        demo::claim(r < 2, "thing %d left the bowl: %g m", i, r);
        demo::claim(p[2] > height(r), "thing %d is under the bowl", i);
        demo::claim(std::sqrt(dCalcVectorDot3(v, v)) < 0.3, "thing %d moves at %g m/s", i,
                    std::sqrt(dCalcVectorDot3(v, v)));
    }
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0, -4.2f, 3.4f}, {90, -33, 0}, 6, build, judge});
}
