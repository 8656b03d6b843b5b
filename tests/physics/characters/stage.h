// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world with gravity, a space of its contacts and one character, for tests of characters. z is up.
#pragma once

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <vector>

namespace epode::characters {

#ifdef dIDEDOUBLE
constexpr double kRounding = 1e-9;
#else
constexpr double kRounding = 1e-4;
#endif
constexpr double kGravity = 9.81;

struct V {
    double x = 0, y = 0, z = 0;
};
inline V operator-(V a, V b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline double norm(V a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

struct Stage {
    explicit Stage(int defaults = 0)
    {
        dInitODE();
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        if (defaults) dWorldUseDefaults(world, defaults);
        dWorldSetGravity(world, 0, 0, dReal(-kGravity));
        dWorldSetContactSpace(world, space);
    }
    ~Stage()
    {
        dSpaceDestroy(space);
        dWorldDestroy(world);
        for (const dTriMeshDataID data : meshes) dGeomTriMeshDataDestroy(data);
        dCloseODE();
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    static dCharacterSettings usual()
    {
        dCharacterSettings s;
        dCharacterSettingsInit(&s, sizeof s);
        return s;
    }
    dGeomID add(V feet, const dCharacterSettings& s = usual()) const
    {
        const dGeomID c = dCharacterCreate(space, &s);
        dCharacterSetPosition(c, dReal(feet.x), dReal(feet.y), dReal(feet.z));
        return c;
    }
    dGeomID floor() const { return dCreatePlane(space, 0, 0, 1, 0); }
    dGeomID box(V centre, V size) const
    {
        const dGeomID g = dCreateBox(space, dReal(size.x), dReal(size.y), dReal(size.z));
        dGeomSetPosition(g, dReal(centre.x), dReal(centre.y), dReal(centre.z));
        return g;
    }
    dBodyID heavy_box(V centre, V size, double mass) const
    {
        const dBodyID body = dBodyCreate(world);
        dMass m;
        dMassSetBoxTotal(&m, dReal(mass), dReal(size.x), dReal(size.y), dReal(size.z));
        dBodySetMass(body, &m);
        dGeomSetBody(box({}, size), body);
        dBodySetPosition(body, dReal(centre.x), dReal(centre.y), dReal(centre.z));
        return body;
    }
    // A square of side `size` about the origin, of n x n cells of two triangles, with the height z(x, y).
    template <typename Height>
    dGeomID grid(int n, double size, Height&& z)
    {
        std::vector<float> points;
        std::vector<dTriIndex> corners;
        for (int i = 0; i <= n; ++i)
            for (int j = 0; j <= n; ++j) {
                const double x = size * (double(i) / n - 0.5), y = size * (double(j) / n - 0.5);
                for (const double c : {x, y, double(z(x, y))}) points.push_back(float(c));
            }
        for (int i = 0; i < n; ++i)
            for (int j = 0; j < n; ++j) {
                const auto a = dTriIndex(i * (n + 1) + j), b = a + dTriIndex(n + 1);
                for (const dTriIndex corner : {a, b, a + 1, a + 1, b, b + 1}) corners.push_back(corner);
            }
        const dTriMeshDataID data = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSingle(data, points.data(), 3 * sizeof(float), int(points.size() / 3),
                                    corners.data(), int(corners.size()), 3 * sizeof(dTriIndex));
        meshes.push_back(data);
        kept.push_back(std::move(points)), kept_corners.push_back(std::move(corners));
        return dCreateTriMesh(space, data, nullptr, nullptr, nullptr);
    }

    dWorldID world;
    dSpaceID space;
    std::vector<dTriMeshDataID> meshes;
    std::vector<std::vector<float>> kept;
    std::vector<std::vector<dTriIndex>> kept_corners;
};

inline V feet(dGeomID c)
{
    dVector3 p;
    EXPECT_EQ(dCharacterGetPosition(c, p), 1);
    return {p[0], p[1], p[2]};
}
inline V velocity(dGeomID c)
{
    dVector3 v;
    EXPECT_EQ(dCharacterGetVelocity(c, v), 1);
    return {v[0], v[1], v[2]};
}
inline int move(dGeomID c, V v, double h)
{
    const dVector3 u = {dReal(v.x), dReal(v.y), dReal(v.z)};
    return dCharacterMove(c, u, dReal(h));
}
inline int walk(dGeomID c, V v, double jump, double h)
{
    const dVector3 u = {dReal(v.x), dReal(v.y), dReal(v.z)};
    return dCharacterWalk(c, u, dReal(jump), dReal(h));
}
inline dCharacterReport report(dGeomID c)
{
    dCharacterReport r;
    r.struct_size = sizeof r;
    EXPECT_EQ(dCharacterGetReport(c, &r), 1);
    return r;
}

// Each test of motion at three sizes of the step, with each shape.
struct Case {
    double h;
    int shape;
};
class EveryCharacter : public testing::TestWithParam<Case> {
  protected:
    double h() const { return GetParam().h; }
    dCharacterSettings settings() const
    {
        dCharacterSettings s = Stage::usual();
        s.shape = GetParam().shape;
        return s;
    }
};
inline std::vector<Case> cases()
{
    std::vector<Case> all;
    for (const double h : {1.0 / 30, 1.0 / 60, 1.0 / 240})
        for (const int shape : {int(dCapsuleClass), int(dCylinderClass), int(dBoxClass)})
            all.push_back({h, shape});
    return all;
}
inline std::string case_name(const testing::TestParamInfo<Case>& info)
{
    const char* const shape = info.param.shape == dCapsuleClass    ? "capsule"
                              : info.param.shape == dCylinderClass ? "cylinder"
                                                                   : "box";
    return std::string(shape) + "_" + std::to_string(int(1 / info.param.h + 0.5)) + "_hz";
}

}  // namespace epode::characters
