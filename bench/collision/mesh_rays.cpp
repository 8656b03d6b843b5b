// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Three meshes: a terrain (a grid of bumps, met from above and sideways), a ball with a rough surface
// (closed, met through its middle) and a soup (small triangles anywhere). Rays run between random points of a
// box around the mesh; misses start above it and run away.
#include "bench/collision/mesh_rays.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include <ode/ode.h>

namespace epode::bench {

namespace {

constexpr double kPi = 3.14159265358979323846;

struct Point {
    double x, y, z;
};

struct Surface {
    std::vector<float> vertices;
    std::vector<dTriIndex> indices;
    void vertex(Point p)
    {
        for (const double x : {p.x, p.y, p.z}) vertices.push_back(float(x));
    }
    void triangle(int a, int b, int c)
    {
        for (const int i : {a, b, c}) indices.push_back(dTriIndex(i));
    }
    int triangles() const { return int(indices.size() / 3); }
};

class Numbers {
  public:
    double unit()
    {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return double(state_ >> 11) / 9007199254740992.0;
    }
    Point point() { return {2 * unit() - 1, 2 * unit() - 1, 2 * unit() - 1}; }

  private:
    std::uint64_t state_ = 12345;
};

// Points of a grid of n x n squares, (u, v) in 0 ... 1.
template <typename Place>
Surface grid(int n, Place&& place)
{
    Surface s;
    for (int j = 0; j <= n; ++j)
        for (int i = 0; i <= n; ++i) s.vertex(place(double(i) / n, double(j) / n));
    for (int j = 0; j < n; ++j)
        for (int i = 0; i < n; ++i) {
            const int a = j * (n + 1) + i, b = a + 1, c = a + n + 1, d = c + 1;
            s.triangle(a, b, d);
            s.triangle(a, d, c);
        }
    return s;
}

Surface soup(int count)
{
    Numbers numbers;
    Surface s;
    const double size = 1.5 / std::cbrt(double(count));
    for (int t = 0; t < count; ++t) {
        const Point at = numbers.point();
        for (int k = 0; k < 3; ++k) {
            const Point p = numbers.point();
            s.vertex({at.x + size * p.x, at.y + size * p.y, at.z + size * p.z});
        }
        s.triangle(3 * t, 3 * t + 1, 3 * t + 2);
    }
    return s;
}

Surface surface(const MeshRayOptions& options)
{
    const int n = std::max(1, int(std::lround(std::sqrt(options.triangles / 2.0))));
    if (options.mesh == "soup") return soup(options.triangles);
    if (options.mesh == "ball")
        return grid(n, [](double u, double v) {
            const double a = 2 * kPi * u, b = kPi * v, r = 0.9 + 0.05 * std::sin(40 * a) * std::sin(30 * b);
            return Point{r * std::sin(b) * std::cos(a), r * std::sin(b) * std::sin(a), r * std::cos(b)};
        });
    return grid(n, [](double u, double v) {
        return Point{2 * u - 1, 2 * v - 1,
                     0.1 * std::sin(25 * u) * std::cos(31 * v) + 0.01 * std::sin(400 * u * v)};
    });
}

struct Shot {
    Point from, to;
};

struct Outcome {
    double nanoseconds = 0;
    long hits = 0;
    double depths = 0;
};

Outcome shoot(dGeomID mesh, const std::vector<Shot>& shots, bool closest)
{
    const dGeomID ray = dCreateRay(nullptr, 10);
    dGeomRaySetClosestHit(ray, closest);
    Outcome out;
    dContactGeom hits[16];
    const auto start = std::chrono::steady_clock::now();
    for (const Shot& s : shots) {
        dGeomRaySet(ray, dReal(s.from.x), dReal(s.from.y), dReal(s.from.z), dReal(s.to.x - s.from.x),
                    dReal(s.to.y - s.from.y), dReal(s.to.z - s.from.z));
        const int count = dCollide(ray, mesh, 16, hits, sizeof(dContactGeom));
        out.hits += count;
        for (int i = 0; i < count; ++i) out.depths += double(hits[i].depth);
    }
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - start;
    out.nanoseconds = took.count() * 1e9 / double(shots.size());
    dGeomDestroy(ray);
    return out;
}

void keep_least(Outcome& best, const Outcome& one)
{
    const double least =
        best.hits || best.nanoseconds > 0 ? std::min(best.nanoseconds, one.nanoseconds) : one.nanoseconds;
    best = one;
    best.nanoseconds = least;
}

}  // namespace

int bench_mesh_rays(const MeshRayOptions& options)
{
    const Surface s = surface(options);
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    const auto start = std::chrono::steady_clock::now();
    dGeomTriMeshDataBuildSingle(data, s.vertices.data(), 3 * int(sizeof(float)), int(s.vertices.size() / 3),
                                s.indices.data(), int(s.indices.size()), 3 * int(sizeof(dTriIndex)));
    const std::chrono::duration<double, std::milli> built = std::chrono::steady_clock::now() - start;
    const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);

    Numbers numbers;
    std::vector<Shot> through(static_cast<std::size_t>(options.rays)), past = through;
    for (std::size_t i = 0; i < through.size(); ++i) {
        const Point a = numbers.point(), b = numbers.point();
        through[i] = {{1.2 * a.x, 1.2 * a.y, 0.5 + 0.7 * std::fabs(a.z)}, {b.x, b.y, 0.3 * b.z}};
        past[i] = {{a.x, a.y, 1.2}, {b.x, b.y, 3}};
    }
    Outcome closest, all, misses;
    for (int i = 0; i < options.repeat; ++i) {
        keep_least(closest, shoot(mesh, through, true));
        keep_least(all, shoot(mesh, through, false));
        keep_least(misses, shoot(mesh, past, true));
    }
    std::printf("%d %.2f %.1f %.1f %.1f %ld %ld %.9g %.9g\n", s.triangles(), built.count(),
                closest.nanoseconds, all.nanoseconds, misses.nanoseconds, closest.hits, all.hits,
                closest.depths, all.depths);
    dGeomDestroy(mesh);
    dGeomTriMeshDataDestroy(data);
    return misses.hits == 0 ? 0 : 1;
}

}  // namespace epode::bench
