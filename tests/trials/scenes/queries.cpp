// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays and shape casts against what exact geometry says, in place and after a rotation and translation of everything.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

struct Pose {
    Turn turned;
    Vec moved;
    Vec point(Vec p) const { return rotate(turned, p) + moved; }
    Vec direction(Vec d) const { return rotate(turned, d); }
};

void set_pose(dGeomID geom, Vec at, Turn q)
{
    dGeomSetPosition(geom, at.x, at.y, at.z);
    const dQuaternion turned = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dGeomSetQuaternion(geom, turned);
}

std::vector<Pose> poses()
{
    Lcg random(9);
    return {{{}, {}}, {random.any_turn(), {10, -4, 2}}};
}

// A ray against a cylinder of radius 3 and length 4; distance below 0: a miss.
struct Ray {
    Vec from, along;
    double distance;
    Vec normal;
};

const double kDiagonal = 1 / std::sqrt(2.0), kTilted = 1 / std::sqrt(3.0);
const Ray kRays[] = {
    // From inside all directions hit the far wall (ode/queries.h).
    {{}, kZ, 2, {0, 0, -1}},
    {{}, -1 * kZ, 2, kZ},
    {{}, kX, 3, {-1, 0, 0}},
    {{}, {kTilted, kTilted, kTilted}, 2 / kTilted, {0, 0, -1}},
    {{2.999, 0, 10}, -1 * kZ, 8, kZ},
    {{3.001, 0, 10}, -1 * kZ, -1, {}},
    {{0, 0, 10}, -1 * kZ, 8, kZ},
    {{10, 0, 1.999}, -1 * kX, 7, kX},
    {{10, 0, 2.001}, -1 * kX, -1, {}},
    // The rim, moved by a millionth to either side.
    {{10, 0, 9 + 1e-6}, {-kDiagonal, 0, -kDiagonal}, (7 + 1e-6) / kDiagonal, kZ},
    {{10, 0, 9 - 1e-6}, {-kDiagonal, 0, -kDiagonal}, 7 / kDiagonal, kX},
    {{-10, 3 + 1e-6, 0}, kX, -1, {}},
    {{-10, 0, 0}, kX, 7, -1 * kX},
};

void cast_rays(Run& run)
{
    for (const char* law : {"hits", "distance", "normal"}) run.record(law, 0);
    for (const Pose& pose : poses()) {
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        const dGeomID cylinder = dCreateCylinder(space, 3, 4);
        set_pose(cylinder, pose.moved, pose.turned);
        for (const Ray& ray : kRays) {
            const Vec o = pose.point(ray.from), d = pose.direction(ray.along);
            const dVector3 origin = {dReal(o.x), dReal(o.y), dReal(o.z)},
                           direction = {dReal(d.x), dReal(d.y), dReal(d.z)};
            dQueryHit hit;
            const bool is_hit = dSpaceRayClosest(space, origin, direction, 20, nullptr, &hit);
            run.record("hits", is_hit == (ray.distance > 0) ? 0 : 1);
            if (!is_hit || ray.distance < 0) continue;
            run.record("distance", std::fabs(hit.distance - ray.distance));
            run.record("normal", length(vec(hit.normal) - pose.direction(ray.normal)));
        }
        dSpaceDestroy(space);
    }
}

// A capsule of radius 0.3 and length 1.8 flies 5 m at a bar whose face is 2.9 m away.
enum class Bar { kMesh, kBox, kHull };
constexpr double kRadius = 0.3, kHalf = 0.9;
const Vec kBar{0.2, 2, 0.2};

// Travel until the capsule touches a bar at height z, with its faces at z -+ 0.1.
double travel(double z)
{
    const double above = std::max(std::fabs(z) - 0.1 - kHalf, 0.0);
    return above >= kRadius ? -1 : 2.9 - std::sqrt(kRadius * kRadius - above * above);
}

dGeomID make_bar(Stage& stage, Bar kind)
{
    if (kind == Bar::kMesh) return box_mesh(stage, kBar, {});
    if (kind == Bar::kBox) return stage.block(kBar, {});
    std::vector<dReal> corners;
    for (int i = 0; i < 8; ++i)
        for (double c :
             {(i & 1 ? 0.5 : -0.5) * kBar.x, (i & 2 ? 0.5 : -0.5) * kBar.y, (i & 4 ? 0.5 : -0.5) * kBar.z})
            corners.push_back(c);
    return stage.place(dCreateConvexHull(stage.space, corners.data(), 8, 0));
}

void cast_capsule(Run& run, Bar kind, const Pose& pose)
{
    Stage stage(run);
    const dGeomID bar = make_bar(stage, kind), capsule = dCreateCapsule(nullptr, kRadius, 2 * kHalf);
    const Vec m = pose.direction({5, 0, 0});
    const dVector3 motion = {dReal(m.x), dReal(m.y), dReal(m.z)};
    const auto cast = [&](Vec at, Turn own, double right) {
        set_pose(capsule, pose.moved, pose.turned * own);
        set_pose(bar, pose.point(at), pose.turned);
        dQueryHit hit;
        const bool is_hit = dGeomCast(capsule, motion, bar, &hit);
        run.record("hits", is_hit == (right >= 0) ? 0 : 1);
        if (!is_hit || right < 0) return;
        run.record("travel", 1e6 * std::fabs(hit.distance - right));
        run.record("against", dot(vec(hit.normal), m) < 0 ? 0 : 1);
        if (std::fabs(at.z) <= 0.8)
            run.record("normal", length(vec(hit.normal) - pose.direction({-1, 0, 0})));
    };
    for (double z : {-1.5, -1.15, -1.0, -0.5, 0.0, 0.5, 1.0, 1.15, 1.5}) cast({3, 0, z}, {}, travel(z));
    cast({3, 0, 0}, turn(kY, kPi / 2), 2.9 - kHalf - kRadius);
    dGeomDestroy(capsule);
}

void cast_capsules(Run& run)
{
    for (const char* law : {"hits", "travel", "normal", "against"}) run.record(law, 0);
    for (const Pose& pose : poses())
        for (Bar kind : {Bar::kMesh, Bar::kBox, Bar::kHull}) cast_capsule(run, kind, pose);
}

}  // namespace

extern const Scene kRaysAtCylinder{
    "Queries",
    "rays_at_cylinder",
    "rays from inside, grazing and at the rim of a cylinder, also turned and moved (C15)",
    {{"hits", "hits and misses that are wrong", "1", 0},
     {"distance", "error of the distance", "m", 1e-9},
     {"normal", "error of the normal", "1", 1e-6}},
    &cast_rays,
    true};

extern const Scene kCapsuleCasts{
    "Queries",
    "capsule_casts",
    "a capsule is cast at a bar of triangles, a box and a hull at nine heights (C18)",
    {{"hits", "hits and misses that are wrong", "1", 0},
     {"travel", "error of the travel", "um", 10},
     {"normal", "error of the normal where the side hits", "1", 1e-3},
     {"against", "normals that are not against the motion", "1", 0}},
    &cast_capsules,
    true};

}  // namespace epode::trials
