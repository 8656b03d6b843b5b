// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Meshes and height fields: rays, arrays and data that change or go away, masses, peaks.
#include <cstring>
#include <vector>

#include "difference.h"

namespace differences {
namespace {

// Two squares of two triangles each, side 2, at heights 0 and 1 (the first listed is the lower).
struct Floors {
    std::vector<double> points;
    std::vector<dTriIndex> corners;
    dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomID mesh;

    explicit Floors(double x = 0, int floors = 2)
    {
        for (int k = 0; k < floors; ++k) {
            for (const double y : {-1, 1})
                for (const double side : {-1, 1}) points.insert(points.end(), {x + side, y, double(k)});
            for (const int i : {0, 1, 3, 0, 3, 2}) corners.push_back(dTriIndex(4 * k + i));
        }
        dGeomTriMeshDataBuildDouble(data, points.data(), 3 * sizeof(double), int(points.size() / 3),
                                    corners.data(), int(corners.size()), 3 * sizeof(dTriIndex));
        mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr);
    }
};

dGeomID ray_down(double x = 0.3, double y = 0.2, double z = 5)
{
    const dGeomID ray = dCreateRay(nullptr, 10);
    dGeomRaySet(ray, x, y, z, 0, 0, -1);
    return ray;
}

int refuse_upper(dGeomID, dGeomID, int triangle, dReal, dReal) { return triangle < 2; }

DIFFERENCE(C32, next, "a closest hit that the program rejects leaves the next one")
{
    const Floors floors;
    const dGeomID ray = ray_down();
    dGeomRaySetClosestHit(ray, 1);
    dGeomTriMeshSetRayCallback(floors.mesh, &refuse_upper);
    dContactGeom c[4];
    const int count = dCollide(ray, floors.mesh, 4, c, sizeof(c[0]));
    note("count", count);
    return count == 1 && near(c[0].depth, 5, 1e-6);
}

DIFFERENCE(C33, precision, "a vertex is where its double says, a kilometre from the origin too")
{
    const Floors floors(1000.1);
    dVector3 v;
    dGeomTriMeshGetTriangle(floors.mesh, 0, &v, nullptr, nullptr);
    note("off", v[0] - 999.1);
    return near(v[0], 999.1, 1e-9);
}

DIFFERENCE(C34, update, "a mesh whose vertices have been updated is met where they are")
{
    Floors floors;
    dReal bounds[6];
    dGeomGetAABB(floors.mesh, bounds);
    for (std::size_t i = 2; i < floors.points.size(); i += 3) floors.points[i] += 4;
    dGeomTriMeshDataUpdate(floors.data);
    dGeomGetAABB(floors.mesh, bounds);
    note("top", bounds[5]);
    return near(bounds[5], 5, 1e-6);
}

DIFFERENCE(C39, number, "a contact made of two triangles has the number of one")
{
    const Floors floors(0, 1);
    const dGeomID ball = dCreateSphere(nullptr, 0.3);
    dGeomSetPosition(ball, 0, 0, 0.2);
    int option = 3, length = sizeof(option);
    dGeomLowLevelControl(floors.mesh, 1, 1, &option, &length);
    dContactGeom c[4];
    const int count = dCollide(ball, floors.mesh, 4, c, sizeof(c[0]));
    note("count", count), note("number", c[0].side2);
    return count == 1 && c[0].side2 >= 0;
}

DIFFERENCE(C31, inertia, "the inertia of a mesh off the origin is that of the same solid moved there")
{
    std::vector<double> p;
    for (int i = 0; i < 8; ++i) p.insert(p.end(), {3.0 + (i & 1), double(i >> 1 & 1), double(i >> 2 & 1)});
    std::vector<dTriIndex> t = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, p.data(), 3 * sizeof(double), 8, t.data(), 36, 3 * sizeof(dTriIndex));
    dMass mass, box;
    dMassSetTrimesh(&mass, 1, dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr));
    dMassSetBox(&box, 1, 1, 1, 1);
    dMassTranslate(&box, 3.5, 0.5, 0.5);
    note("mesh", mass.I[5]), note("box", box.I[5]);
    return near(mass.I[5], box.I[5], 1e-6);
}

DIFFERENCE(G4, gone, "a mesh whose data are destroyed has no triangles left")
{
    const Floors floors;
    dGeomTriMeshDataDestroy(floors.data);
    std::vector<char> other(100000, 'x');
    dContactGeom c[4];
    return dCollide(ray_down(), floors.mesh, 4, c, sizeof(c[0])) == 0;
}

DIFFERENCE(G5, arrays, "a mesh keeps its shape when the arrays that it was made of are gone")
{
    Floors floors(0, 1);
    std::fill(floors.points.begin(), floors.points.end(), 0);
    dContactGeom c[4];
    return dCollide(ray_down(), floors.mesh, 4, c, sizeof(c[0])) == 1;
}

DIFFERENCE(G6, nearest, "of the hits of a ray for which there is room for one, the nearest is kept")
{
    const Floors floors(0, 5);
    const dGeomID down = ray_down(), up = dCreateRay(nullptr, 10);
    dGeomRaySet(up, 0.3, 0.2, -1, 0, 0, 1);
    dContactGeom c[2];
    const int count = dCollide(down, floors.mesh, 1, &c[0], sizeof(c[0])) +
                      dCollide(up, floors.mesh, 1, &c[1], sizeof(c[0]));
    note("down", c[0].depth), note("up", c[1].depth);
    return count == 2 && near(c[0].depth, 1, 1e-6) && near(c[1].depth, 1, 1e-6);
}

// A ball next to a ridge: what pushes it goes through its middle.
DIFFERENCE(G10, ridge, "a ball on a mesh's ridge is pushed through its middle")
{
    const std::vector<double> p = {-1, -5, -1, -1, 5, -1, 0, -5, 0, 0, 5, 0, 1, -5, -1, 1, 5, -1};
    const std::vector<dTriIndex> t = {0, 2, 1, 1, 2, 3, 2, 4, 3, 3, 4, 5};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, p.data(), 3 * sizeof(double), 6, t.data(), 12, 3 * sizeof(dTriIndex));
    const dGeomID mesh = dCreateTriMesh(nullptr, data, nullptr, nullptr, nullptr),
                  ball = dCreateSphere(nullptr, 0.5);
    dGeomSetPosition(ball, 0.1, 0.33, 0.4);
    dContactGeom c[4];
    const int count = dCollide(ball, mesh, 4, c, sizeof(c[0]));
    double worst = count ? 0 : 1;
    for (int i = 0; i < count; ++i) {
        const double x = 0.1 - c[i].pos[0], z = 0.4 - c[i].pos[2];
        worst = std::fmax(worst, std::fabs(x * c[i].normal[2] - z * c[i].normal[0]));
    }
    note("lever", worst);
    return worst < 1e-6;
}

// ---- height fields ----

const double kPeak[9] = {0, 0, 0, 0, 1, 0, 0, 0, 0};

dGeomID field(const double* heights, bool wrap)
{
    const dHeightfieldDataID data = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(data, heights, 0, 4, 4, 3, 3, 1, 0, 0, wrap);
    return dCreateHeightfield(nullptr, data, 1);
}

DIFFERENCE(C27, bounds,
           "the bounding box of a height field holds it, wherever it stands and however it is turned")
{
    const dGeomID g = field(kPeak, false);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 0, 0, 1, M_PI / 4);
    dGeomSetRotation(g, R);
    dGeomSetPosition(g, 0, 10, 0);
    dReal bounds[6];
    dGeomGetAABB(g, bounds);  // corners (+-2, 0..1), turned by 45 degrees
    note("low", bounds[2]), note("high", bounds[3]);
    return near(bounds[2], 10 - std::sqrt(2.0), 1e-6) && near(bounds[3], 10 + 3 / std::sqrt(2.0), 1e-6);
}

DIFFERENCE(G12, peak, "a ball on the very peak of a height field touches it")
{
    const dGeomID g = field(kPeak, false), ball = dCreateSphere(nullptr, 0.2);
    dGeomSetPosition(ball, 0, 1.15, 0);
    dContactGeom c[4];
    const int count = dCollide(ball, g, 4, c, sizeof(c[0]));
    note("count", count);
    return count > 0;
}

}  // namespace
}  // namespace differences
