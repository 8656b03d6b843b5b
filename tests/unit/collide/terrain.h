// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A height field for tests, with the facets written out once more, independently of the library, for brute
// force.
#pragma once

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "../math/random_numbers.h"
#include "ode/ode.h"

namespace epode::test {

using HeightOf = std::function<Real(int, int)>;

struct Tri {
    Vec3 a, b, c;
    Vec3 normal() const
    {
        const Vec3 n = normalized_or(cross(b - a, c - a), {0, 1, 0});
        return n.y < 0 ? -n : n;
    }
};

struct Found {
    Vec3 pos, normal;
    Real depth;
};

// nx x nz samples over width x depth, in a geom at the origin.
struct Ground {
    int nx, nz;
    Real width, depth;
    std::vector<double> heights;
    dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomID geom;

    Ground(int samples_x, int samples_z, Real w, Real d, const HeightOf& height, bool wrap = false)
        : nx(samples_x), nz(samples_z), width(w), depth(d)
    {
        dInitODE();
        for (int j = 0; j < nz; ++j)
            for (int i = 0; i < nx; ++i) heights.push_back(height(i, j));
        dGeomHeightfieldDataBuildDouble(data, heights.data(), 0, w, d, nx, nz, 1, 0, 1, wrap);
        geom = dCreateHeightfield(nullptr, data, 1);
    }
    ~Ground()
    {
        dGeomDestroy(geom);
        dGeomHeightfieldDataDestroy(data);
        dCloseODE();
    }
    Vec3 at(int i, int j) const
    {
        return {-width / 2 + Real(i) * width / Real(nx - 1), Real(heights[std::size_t(i + j * nx)]),
                -depth / 2 + Real(j) * depth / Real(nz - 1)};
    }
    std::vector<Tri> triangles() const
    {
        std::vector<Tri> all;
        for (int j = 0; j + 1 < nz; ++j)
            for (int i = 0; i + 1 < nx; ++i) {
                all.push_back({at(i, j), at(i + 1, j), at(i, j + 1)});
                all.push_back({at(i + 1, j + 1), at(i + 1, j), at(i, j + 1)});
            }
        return all;
    }
    Real surface(Real x, Real z) const
    {
        const Real u = (x + width / 2) / width * Real(nx - 1), v = (z + depth / 2) / depth * Real(nz - 1);
        int i = int(std::floor(u)), j = int(std::floor(v));
        i = i < 0 ? 0 : i > nx - 2 ? nx - 2 : i;
        j = j < 0 ? 0 : j > nz - 2 ? nz - 2 : j;
        const Real fx = u - Real(i), fz = v - Real(j);
        const Real a = at(i, j).y, b = at(i + 1, j).y, c = at(i, j + 1).y, d = at(i + 1, j + 1).y;
        return fx + fz < 1 ? a + (b - a) * fx + (c - a) * fz : d + (c - d) * (1 - fx) + (b - d) * (1 - fz);
    }
};

inline std::vector<Found> contacts(dGeomID a, dGeomID b, int capacity = 64)
{
    std::vector<dContactGeom> raw(std::size_t(capacity) + 1);
    raw.back().depth = -77;
    const int n = dCollide(a, b, capacity, raw.data(), sizeof(dContactGeom));
    EXPECT_LE(n, capacity);
    EXPECT_EQ(raw.back().depth, -77) << "wrote beyond its capacity";
    std::vector<Found> out;
    for (int k = 0; k < n; ++k) {
        const dContactGeom& c = raw[std::size_t(k)];
        EXPECT_EQ(c.g1, a);
        EXPECT_EQ(c.g2, b);
        EXPECT_NEAR(length(load(c.normal)), 1, 1e-6);
        EXPECT_GE(c.depth, 0);
        out.push_back({load(c.pos), load(c.normal), c.depth});
    }
    return out;
}

inline Real deepest(const std::vector<Found>& all)
{
    Real largest = -1;
    for (const Found& f : all) largest = f.depth > largest ? f.depth : largest;
    return largest;
}

inline void place(dGeomID g, Vec3 p, const Mat3& R = Mat3::identity())
{
    dMatrix3 m;
    store_mat(m, R);
    dGeomSetPosition(g, p.x, p.y, p.z);
    dGeomSetRotation(g, m);
}

// Sphere, box, capsule, cylinder of a size.
inline std::vector<dGeomID> solids(Real s)
{
    return {dCreateSphere(nullptr, s), dCreateBox(nullptr, 2 * s, s, Real(1.5) * s),
            dCreateCapsule(nullptr, Real(0.5) * s, s), dCreateCylinder(nullptr, Real(0.7) * s, s)};
}

// Farthest point of a solid made by solids(), by class.
inline Vec3 farthest(dGeomID g, Vec3 direction)
{
    const Pose pose = load_pose(dGeomGetPosition(g), dGeomGetRotation(g));
    const Vec3 d = transposed_times(pose.R, direction);
    Real r = 0, l = 0;
    switch (dGeomGetClass(g)) {
        case dSphereClass:
            return pose.p + dGeomSphereGetRadius(g) * direction;
        case dBoxClass: {
            dVector3 s;
            dGeomBoxGetLengths(g, s);
            return pose.to_world({d.x < 0 ? -s[0] / 2 : s[0] / 2, d.y < 0 ? -s[1] / 2 : s[1] / 2,
                                  d.z < 0 ? -s[2] / 2 : s[2] / 2});
        }
        case dCapsuleClass:
            dGeomCapsuleGetParams(g, &r, &l);
            return pose.to_world(Vec3{0, 0, d.z < 0 ? -l / 2 : l / 2} + r * d);
        default: {
            dGeomCylinderGetParams(g, &r, &l);
            const Real rho = std::sqrt(d.x * d.x + d.y * d.y);
            return pose.to_world(
                {rho > 0 ? r * d.x / rho : 0, rho > 0 ? r * d.y / rho : 0, d.z < 0 ? -l / 2 : l / 2});
        }
    }
}

// How far the lowest of many surface points of the solid is under the ground; negative: above.
inline Real sunk(const Ground& ground, dGeomID g)
{
    Real largest = -kInf;
    RandomNumbers dice(99);
    for (int k = 0; k < 4000; ++k) {
        const Vec3 p = farthest(g, dice.direction());
        const Real under = ground.surface(p.x, p.z) - p.y;
        largest = under > largest ? under : largest;
    }
    return largest;
}

}  // namespace epode::test
