// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Meshes for tests.
#pragma once

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "../math/random_numbers.h"
#include "base/check.h"
#include "geometry/triangle_mesh.h"

namespace epode {

struct Figure {
    std::vector<Vec3> vertices;
    std::vector<MeshCorners> triangles;
};

inline TriangleMesh make_mesh(const Figure& figure, Real grain = kEpsilon)
{
    Array<Vec3> vertices;
    Array<MeshCorners> triangles;
    for (const Vec3 v : figure.vertices) (void)vertices.push(v);
    for (const MeshCorners& c : figure.triangles) (void)triangles.push(c);
    TriangleMesh mesh;
    EXPECT_TRUE(mesh.build(vertices, triangles, grain));
    return mesh;
}

// The unit cube about the origin, counter-clockwise seen from outside.
inline Figure cube()
{
    Figure f;
    for (int i = 0; i < 8; ++i)
        f.vertices.push_back(
            {Real(i & 1) - Real(0.5), Real(i >> 1 & 1) - Real(0.5), Real(i >> 2) - Real(0.5)});
    const int quads[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                             {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    for (const auto& q : quads) {
        f.triangles.push_back({{q[0], q[1], q[2]}});
        f.triangles.push_back({{q[0], q[2], q[3]}});
    }
    return f;
}

// nx x ny unit squares in the plane z = tilt x.
inline Figure flat_grid(int nx, int ny, Real tilt)
{
    Figure f;
    for (int j = 0; j <= ny; ++j)
        for (int i = 0; i <= nx; ++i) f.vertices.push_back({Real(i), Real(j), tilt * Real(i)});
    for (int j = 0; j < ny; ++j)
        for (int i = 0; i < nx; ++i) {
            const int a = j * (nx + 1) + i, b = a + 1, c = a + nx + 1, d = c + 1;
            f.triangles.push_back({{a, b, d}});
            f.triangles.push_back({{a, d, c}});
        }
    return f;
}

inline bool on_border(const Figure& grid, Vec3 v)
{
    const Vec3 far = grid.vertices.back();
    return v.x == 0 || v.y == 0 || v.x == far.x || v.y == far.y;
}

// Every triangle with vertices of its own.
inline Figure separate(const Figure& figure)
{
    Figure f;
    for (const MeshCorners& c : figure.triangles) {
        const int n = int(f.vertices.size());
        for (const int i : c.at) f.vertices.push_back(figure.vertices[std::size_t(i)]);
        f.triangles.push_back({{n, n + 1, n + 2}});
    }
    return f;
}

inline Figure reversed(Figure figure)
{
    for (MeshCorners& c : figure.triangles) std::swap(c.at[1], c.at[2]);
    return figure;
}

// Triangles of about the given size, anywhere within `spread` of the origin.
inline Figure random_soup(RandomNumbers& random, int count, Real spread, Real size)
{
    Figure f;
    for (int t = 0; t < count; ++t) {
        const Vec3 centre = spread * random.vec();
        for (int k = 0; k < 3; ++k) f.vertices.push_back(centre + size * random.vec());
        f.triangles.push_back({{3 * t, 3 * t + 1, 3 * t + 2}});
    }
    return f;
}

}  // namespace epode
