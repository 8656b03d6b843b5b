// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bad input is refused, or acts as if what is bad were not there.
#include "measure.h"
#include "surfaces.h"

#include <algorithm>

namespace epode::trials {

namespace {

// A level floor with degenerate triangles among its good ones. The middle of each, where bodies are put.
struct BadFloor {
    std::vector<Vec> corners, places;
    std::vector<dTriIndex> indices;

    BadFloor()
    {
        constexpr int kCells = 20;
        const auto at = [&](int i, int j) { return dTriIndex(i * (kCells + 1) + j); };
        for (int i = 0; i <= kCells; ++i) {
            for (int j = 0; j <= kCells; ++j) {
                corners.push_back({0.5 * i - 5, 0.5 * j - 5, 0});
                if (i == kCells || j == kCells) continue;
                indices.insert(indices.end(), {at(i, j), at(i + 1, j), at(i, j + 1), at(i, j + 1),
                                               at(i + 1, j), at(i + 1, j + 1)});
            }
        }
        add({-4, -4, 0}, {-4, -4, 0}, {-3.5, -4, 0});     // two corners are one
        add({-2, -4, 0}, {-1.75, -4, 0}, {-1.5, -4, 0});  // on a line
        add({0, -4, 0}, {0.5, -4, 0}, {0, -3.5, 0});      // there twice
        add({2, -4, 0}, {2, -3.5, 0}, {2.5, -4, 0});      // the other way round
        add({-4, 0, 0}, {-3.5, 0, 0}, {-3.5, 1e-9, 0});   // a needle
        add({0, 0, 0}, {1e6, 0, 0}, {0, 1e-3, 0});        // a thousand kilometres long
        places.push_back({3.1, 0.2, 0});
        places.push_back({-2, 3, 0});
        places.push_back({2.25, 3.25, 0});
    }
    void add(Vec a, Vec b, Vec c)
    {
        for (const Vec& corner : {a, b, c}) {
            indices.push_back(dTriIndex(corners.size()));
            corners.push_back(corner);
        }
        places.push_back(length(b - a) > 10 ? Vec{0.3, 1e-4, 0} : (1.0 / 3) * (a + b + c));
    }
};

dBodyID add_solid(Stage& stage, int kind, Vec at)
{
    if (kind == 0) return stage.ball(0.15, 1, at + 0.25 * kZ);
    if (kind == 1) return stage.box({0.3, 0.3, 0.3}, 1, at + 0.25 * kZ);
    if (kind == 2) return stage.capsule(0.1, 0.1, 1, at + 0.25 * kZ);
    if (kind == 3) return stage.cylinder(0.15, 0.3, 1, at + 0.25 * kZ);
    const dReal corners[] = {-0.15, -0.15, -0.15, 0.15, -0.15, -0.15, -0.15, 0.15, -0.15, 0.15, 0.15, -0.15,
                             -0.15, -0.15, 0.15,  0.15, -0.15, 0.15,  -0.15, 0.15, 0.15,  0.15, 0.15, 0.15};
    dMass mass;
    dMassSetBoxTotal(&mass, 1, 0.3, 0.3, 0.3);
    return stage.body(dCreateConvexHull(stage.space, corners, 8, 0), mass, at + 0.25 * kZ);
}

void lie_on_bad_floor(Run& run)
{
    for (int kind = 0; kind < 5; ++kind) {
        Stage stage(run);
        const BadFloor floor;
        mesh(stage, floor.corners, floor.indices);
        std::vector<dBodyID> bodies;
        for (const Vec& place : floor.places) bodies.push_back(add_solid(stage, kind, place));
        stage.advance(2);
        for (size_t i = 0; i < bodies.size(); ++i) {
            const Vec at = position(bodies[i]);
            run.record("height", 1000 * std::max(at.z - 0.15, 0.15 - at.z - stage.layer()));
            run.record("moved", 1000 * across(at - floor.places[i]));
            const dVector3 from = {dReal(floor.places[i].x), dReal(floor.places[i].y), 3}, down = {0, 0, -1};
            dQueryFilter filter;
            dQueryFilterInit(&filter, sizeof filter);
            filter.skip_body = bodies[i];
            dQueryHit hit;
            const bool is_hit = dSpaceRayClosest(stage.space, from, down, 5, &filter, &hit);
            run.record("ray", is_hit ? 1000 * std::fabs(3 - hit.distance) : HUGE_VAL);
        }
    }
}

// What a call does with a bad number: 1 if the value got through.
const double kBad[] = {NAN, -1, HUGE_VAL};

int accepted_masses()
{
    const dWorldID world = dWorldCreate();
    const dBodyID body = dBodyCreate(world);
    int accepted = 0;
    const auto offer = [&](double mass, double x, double y, double z) {
        dMass bad, now;
        dMassSetZero(&bad);
        bad.mass = mass, bad.I[0] = x, bad.I[5] = y, bad.I[10] = z;
        dBodySetMass(body, &bad);
        dBodyGetMass(body, &now);
        // What was refused leaves a mass and moments of 1. A comparison that NaN passes.
        accepted += now.mass == 1 && now.I[0] != x ? 0 : 1;
    };
    for (double bad : kBad) offer(bad, 0.5, 0.5, 0.5);
    offer(0, 0.5, 0.5, 0.5);
    for (double bad : kBad) offer(1, bad, 0.5, 0.5);
    offer(1, 0, 0.5, 0.5);
    offer(1, 0.7, 0.7, 2);  // no body has it: a moment is at most the sum of the others
    dWorldDestroy(world);
    return accepted;
}

int accepted_materials()
{
    const dGeomID geom = dCreateSphere(nullptr, 1);
    int accepted = 0;
    for (double bad : kBad) {
        dMaterial material;
        dMaterialInit(&material, sizeof material);
        if (material.friction = bad; bad != HUGE_VAL)
            accepted += dGeomSetMaterial(geom, &material);  // infinite friction is one
        dMaterialInit(&material, sizeof material);
        material.bounce = bad;
        accepted += dGeomSetMaterial(geom, &material);
        dMaterialInit(&material, sizeof material);
        material.compliance = bad;
        accepted += dGeomSetMaterial(geom, &material);
    }
    dGeomDestroy(geom);
    return accepted;
}

// Meshes that name corners which are not there or not finite must not be hit by anything that is not finite.
int wild_hits()
{
    int wild = 0;
    for (double bad : {double(NAN), HUGE_VAL, 1e30}) {
        const std::vector<Vec> corners = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {bad, 0, 0}};
        const dGeomID geom =
            dCreateTriMesh(nullptr, mesh_data(corners, {0, 1, 2, 0, 1, 3}), nullptr, nullptr, nullptr);
        const dGeomID ball = dCreateSphere(nullptr, 0.2);
        dGeomSetPosition(ball, 0.2, 0.2, 0.1);
        dContactGeom contacts[8];
        const int count = geom ? dCollide(ball, geom, 8, contacts, sizeof contacts[0]) : 0;
        for (int i = 0; i < count; ++i)
            wild += std::isfinite(contacts[i].depth) && contacts[i].depth < 1 ? 0 : 1;
        dGeomDestroy(ball);
        if (geom) dGeomDestroy(geom);
    }
    const dTriMeshDataID data = mesh_data({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {0, 1, 7});
    const dGeomID geom = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    if (geom) dGeomDestroy(geom);
    return wild;
}

// Hulls of points on a plane or a line, of many points, of points that are not finite.
int wild_hulls()
{
    Lcg random(13);
    std::vector<std::vector<dReal>> sets = {{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0},
                                            {0, 0, 0, 1, 0, 0, 2, 0, 0},
                                            std::vector<dReal>(24, 0.5),
                                            {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, dReal(NAN)}};
    std::vector<dReal> ball;
    for (int i = 0; i < 2000; ++i) {
        const Vec p = rotate(random.any_turn(), kX);
        ball.insert(ball.end(), {dReal(p.x), dReal(p.y), dReal(p.z)});
    }
    sets.push_back(ball);
    int wild = 0;
    for (const std::vector<dReal>& points : sets) {
        const dGeomID hull = dCreateConvexHull(nullptr, points.data(), unsigned(points.size() / 3), 0);
        if (!hull) continue;
        dReal box[6];
        dGeomGetAABB(hull, box);
        for (dReal side : box) wild += std::isfinite(side) ? 0 : 1;
        dGeomDestroy(hull);
    }
    return wild;
}

void offer_bad_input(Run& run)
{
    run.record("masses", accepted_masses());
    run.record("materials", accepted_materials());
    run.record("meshes", wild_hits());
    run.record("hulls", wild_hulls());
}

}  // namespace

extern const Scene kBadFloor{
    "Surfaces",
    "bad_floor",
    "five solids on a floor with degenerate, doubled, turned and endless triangles, 2 s (C16)",
    {{"height", "height, off that of rest", "mm", 1},
     {"moved", "way along the floor", "mm", 5},
     {"ray", "height that a ray finds", "mm", 0.001}},
    &lie_on_bad_floor};

extern const Scene kBadInput{
    "Queries",
    "bad_input",
    "masses, inertias, materials, meshes and hulls with numbers that cannot be (C16)",
    {{"masses", "masses and inertias that were accepted", "1", 0},
     {"materials", "materials that were accepted", "1", 0},
     {"meshes", "contacts that are not finite", "1", 0},
     {"hulls", "bounds that are not finite", "1", 0}},
    &offer_bad_input,
    true};

}  // namespace epode::trials
