// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms and pairs of them. What two shapes overlap by is found by trying directions.
#include <algorithm>
#include <initializer_list>
#include <vector>

#include "difference.h"

namespace differences {
namespace {

constexpr int kCapacity = 16;

struct Contacts {
    dContactGeom at[kCapacity] = {};
    int count;
    Contacts(dGeomID a, dGeomID b, int capacity = kCapacity)
        : count(dCollide(a, b, capacity, at, sizeof(dContactGeom)))
    {}
    double deepest() const
    {
        double deepest = 0;
        for (int i = 0; i < count; ++i) deepest = std::fmax(deepest, at[i].depth);
        return deepest;
    }
};

// How far a box, capsule or cylinder reaches along d from its middle.
double reach(dGeomID g, const double* d)
{
    const dReal* R = dGeomGetRotation(g);
    double local[3];
    for (int k = 0; k < 3; ++k) local[k] = R[k] * d[0] + R[4 + k] * d[1] + R[8 + k] * d[2];
    dReal radius = 0, length = 0;
    if (dGeomGetClass(g) == dBoxClass) {
        dVector3 side;
        dGeomBoxGetLengths(g, side);
        return 0.5 * (side[0] * std::fabs(local[0]) + side[1] * std::fabs(local[1]) +
                      side[2] * std::fabs(local[2]));
    }
    if (dGeomGetClass(g) == dCapsuleClass) {
        dGeomCapsuleGetParams(g, &radius, &length);
        return radius + 0.5 * length * std::fabs(local[2]);
    }
    dGeomCylinderGetParams(g, &radius, &length);
    return radius * std::hypot(local[0], local[1]) + 0.5 * length * std::fabs(local[2]);
}

double overlap(dGeomID a, dGeomID b, const double* d)
{
    const dReal *p = dGeomGetPosition(a), *q = dGeomGetPosition(b);
    double between = 0;
    for (int k = 0; k < 3; ++k) between += (q[k] - p[k]) * d[k];
    return reach(a, d) + reach(b, d) - std::fabs(between);
}

// No more than this parts them: the least over many directions.
double enough(dGeomID a, dGeomID b, Dice& dice)
{
    double least = 1e9;
    for (int i = 0; i < 4000; ++i) {
        double d[3] = {dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1)};
        const double n = size(d);
        if (n < 0.1 || n > 1) continue;
        for (double& x : d) x /= n;
        least = std::fmin(least, overlap(a, b, d));
    }
    return least;
}

// The share of poses in which the depth is a tenth more than would do.
double too_deep(dGeomID a, dGeomID b)
{
    Dice dice;
    int met = 0, deeper = 0;
    for (int i = 0; i < 200; ++i) {
        turn_at_random(a, dice), turn_at_random(b, dice);
        dGeomSetPosition(b, dice.in(-0.5, 0.5), dice.in(-0.5, 0.5), dice.in(-0.5, 0.5));
        const Contacts contacts(a, b);
        if (contacts.count == 0) continue;
        ++met;
        deeper += contacts.deepest() > 1.1 * enough(a, b, dice) + 1e-6;
    }
    return double(deeper) / met;
}

DIFFERENCE(C22, capsule, "a capsule deep in a box needs no more than its depth to leave it")
{
    const double share = too_deep(dCreateBox(nullptr, 1, 1.5, 2), dCreateCapsule(nullptr, 0.2, 1));
    note("too deep", share);
    return share < 0.01;
}

DIFFERENCE(C22, cylinders, "nor do two cylinders")
{
    const double share = too_deep(dCreateCylinder(nullptr, 0.5, 1.5), dCreateCylinder(nullptr, 0.2, 1));
    note("too deep", share);
    return share < 0.01;
}

DIFFERENCE(C24, leaning,
           "a box that leans by half a degree on a plane, four corners in it, rests on all four")
{
    const dGeomID box = dCreateBox(nullptr, 1, 1, 1), plane = dCreatePlane(nullptr, 0, 0, 1, 0);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 0.4, 0, 0.01);
    dGeomSetRotation(box, R);
    dGeomSetPosition(box, 0, 0, 0.48);
    const dGeomID cylinder = dCreateCylinder(nullptr, 0.5, 1);
    dGeomSetRotation(cylinder, R);
    dGeomSetPosition(cylinder, 0, 0, 0.48);
    note("box", Contacts(box, plane).count), note("cylinder", Contacts(cylinder, plane).count);
    return Contacts(box, plane).count == 4 && Contacts(cylinder, plane).count >= 3;
}

DIFFERENCE(C25, missed, "a box and a cylinder whose middle is in it touch")
{
    Dice dice;
    int missed = 0;
    for (int i = 0; i < 1000; ++i) {
        const double x = dice.in(0.2, 1), y = dice.in(0.2, 1), z = dice.in(0.2, 1);
        const dGeomID box = dCreateBox(nullptr, 2 * x, 2 * y, 2 * z);
        const dGeomID cylinder = dCreateCylinder(nullptr, dice.in(0.2, 0.7), dice.in(0.3, 2));
        turn_at_random(cylinder, dice);
        dGeomSetPosition(cylinder, dice.in(-x, x), dice.in(-y, y), dice.in(-z, z));
        missed += Contacts(box, cylinder).count == 0;
    }
    note("missed", missed);
    return missed == 0;
}

DIFFERENCE(C26, inside, "a long ray that starts in a capsule hits it")
{
    Dice dice;
    int missed = 0;
    for (int i = 0; i < 2000; ++i) {
        const double radius = dice.in(0.2, 0.7), half = dice.in(0.2, 1);
        const dGeomID capsule = dCreateCapsule(nullptr, radius, 2 * half), ray = dCreateRay(nullptr, 10);
        const double end = half + 0.6 * radius;
        const double p[3] = {dice.in(-0.5, 0.5) * radius, dice.in(-0.5, 0.5) * radius, dice.in(-end, end)};
        dGeomRaySet(ray, p[0], p[1], p[2], dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1));
        missed += Contacts(ray, capsule).count == 0;
    }
    note("missed", missed);
    return missed == 0;
}

DIFFERENCE(C1, quaternion, "a geom with an offset has the quaternion that was set")
{
    const World world;
    const dGeomID g = dCreateBox(nullptr, 1, 1, 1);
    dGeomSetBody(g, world.body());
    dQuaternion offset, wanted, got;
    dQFromAxisAndAngle(offset, 1, 0, 0, 0.5);
    dQFromAxisAndAngle(wanted, 0, 0, 1, 0.8);
    dGeomSetOffsetQuaternion(g, offset);
    dGeomSetQuaternion(g, wanted);
    dGeomGetQuaternion(g, got);
    const double alike = got[0] * wanted[0] + got[1] * wanted[1] + got[2] * wanted[2] + got[3] * wanted[3];
    note("alike", alike);
    return near(std::fabs(alike), 1, 1e-9);
}

DIFFERENCE(C6, outside, "the point depth outside a box is the distance from it")
{
    const double depth = dGeomBoxPointDepth(dCreateBox(nullptr, 2, 2, 2), 5, 0, 0);
    note("depth", depth);
    return near(depth, -4, 1e-9);
}

void count_pair(void* count, dGeomID, dGeomID) { ++*static_cast<int*>(count); }

DIFFERENCE(C9, disabled, "a disabled geom meets nothing, whichever of two spaces has fewer members")
{
    int counts[2];
    for (int k = 0; k < 2; ++k) {
        const dSpaceID a = dSimpleSpaceCreate(nullptr), b = dSimpleSpaceCreate(nullptr);
        const dGeomID off = dCreateSphere(a, 1);
        for (int i = 0; i < 3; ++i) dGeomSetPosition(dCreateSphere(k ? a : b, 1), k ? 10 : 0, 0, 0);
        dCreateSphere(b, 1);
        dGeomDisable(off);
        counts[k] = 0;
        dSpaceCollide2(dGeomID(a), dGeomID(b), &counts[k], &count_pair);
        note("pairs", counts[k]);
    }
    return counts[0] == 0 && counts[1] == 0;
}

// ---- convexes ----

const dReal kPlanes[] = {1,  0, 0, 0.5, 0, 1,  0, 0.5, 0, 0, 1,  0.5,
                         -1, 0, 0, 0.5, 0, -1, 0, 0.5, 0, 0, -1, 0.5};
const dReal kPoints[] = {0.5, 0.5, 0.5,  -0.5, 0.5, 0.5,  0.5, -0.5, 0.5,  -0.5, -0.5, 0.5,
                         0.5, 0.5, -0.5, -0.5, 0.5, -0.5, 0.5, -0.5, -0.5, -0.5, -0.5, -0.5};
const unsigned kFaces[] = {4, 0, 2, 6, 4, 4, 1, 0, 4, 5, 4, 0, 1, 3, 2,
                           4, 3, 1, 5, 7, 4, 2, 3, 7, 6, 4, 5, 4, 6, 7};

dGeomID cube() { return dCreateConvex(nullptr, kPlanes, 6, kPoints, 8, kFaces); }

DIFFERENCE(C28, below, "a convex wholly below a plane is pushed out")
{
    const dGeomID convex = cube();
    dGeomSetPosition(convex, 0, 0, -3);
    return Contacts(convex, dCreatePlane(nullptr, 0, 0, 1, 0)).count > 0;
}

DIFFERENCE(C29, slant, "a slanting ray hits a convex cube where it hits the box of its size")
{
    const dGeomID convex = cube(), box = dCreateBox(nullptr, 1, 1, 1), ray = dCreateRay(nullptr, 10);
    dGeomRaySet(ray, 2, 0.2, 2, -1, 0, -1.2);
    const Contacts one(ray, convex), other(ray, box);
    note("convex", one.count ? one.at[0].depth : -1), note("box", other.at[0].depth);
    return one.count == 1 && near(one.at[0].depth, other.at[0].depth, 1e-9);
}

DIFFERENCE(C30, apart, "a convex and a cylinder that are apart have no contact")
{
    Dice dice;
    int wrong = 0;
    for (int i = 0; i < 20000; ++i) {
        dReal planes[24], points[24], side[3] = {dice.in(0.2, 2), dice.in(0.2, 2), dice.in(0.2, 2)};
        for (int k = 0; k < 24; ++k) points[k] = kPoints[k] * side[k % 3];
        for (int k = 0; k < 24; ++k) planes[k] = k % 4 == 3 ? kPlanes[k] * side[k / 4 % 3] : kPlanes[k];
        const dGeomID convex = dCreateConvex(nullptr, planes, 6, points, 8, kFaces);
        const dGeomID box = dCreateBox(nullptr, side[0], side[1], side[2]);
        const dGeomID cylinder = dCreateCylinder(nullptr, dice.in(0.2, 0.7), dice.in(0.3, 2));
        turn_at_random(convex, dice), turn_at_random(cylinder, dice);
        dGeomSetRotation(box, dGeomGetRotation(convex));
        double d[3] = {dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1)};
        const double n = size(d);
        if (n < 0.1) continue;
        for (double& x : d) x /= n;
        const double away = reach(box, d) + reach(cylinder, d) + 0.0005;
        double aside[3] = {dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1)};
        const double along = aside[0] * d[0] + aside[1] * d[1] + aside[2] * d[2];
        for (int k = 0; k < 3; ++k) aside[k] += (away - along) * d[k];
        dGeomSetPosition(cylinder, aside[0], aside[1], aside[2]);
        wrong += Contacts(convex, cylinder).count > 0;
        for (const dGeomID g : {convex, box, cylinder}) dGeomDestroy(g);
    }
    note("wrong", wrong);
    return wrong == 0;
}

DIFFERENCE(C40, parts, "boxes that touch still do when moved apart by 0.96 of the depth of dBoxBox")
{
    Dice dice;
    int touching = 0, wrong = 0;
    for (int i = 0; i < 100000; ++i) {
        const dGeomID a = dCreateBox(nullptr, 1, 1, 1), b = dCreateBox(nullptr, 1, 1, 1);
        turn_at_random(a, dice), turn_at_random(b, dice);
        const dVector3 here = {0, 0, 0, 0}, side1 = {dice.in(0.1, 2), dice.in(0.1, 2), dice.in(0.1, 2), 0},
                       side2 = {dice.in(0.1, 2), dice.in(0.1, 2), dice.in(0.1, 2), 0};
        dVector3 there = {dice.in(-1, 1), dice.in(-1, 1), dice.in(-1, 1), 0}, normal;
        dReal depth = 0;
        int code = 0;
        dContactGeom contacts[8];
        if (dBoxBox(here, dGeomGetRotation(a), side1, there, dGeomGetRotation(b), side2, normal, &depth,
                    &code, 8, contacts, sizeof(dContactGeom))) {
            ++touching;
            for (int k = 0; k < 3; ++k) there[k] += 0.96 * depth * normal[k];
            wrong += !dBoxTouchesBox(here, dGeomGetRotation(a), side1, there, dGeomGetRotation(b), side2);
        }
        dGeomDestroy(a), dGeomDestroy(b);
    }
    note("touching", touching), note("wrong", wrong);
    return touching > 1000 && wrong == 0;
}

DIFFERENCE(C37, scaled, "a quaternion of another length does not scale a geom")
{
    const dGeomID box = dCreateBox(nullptr, 1, 1, 1);
    const dQuaternion q = {2, 2, 0, 0};
    dGeomSetQuaternion(box, q);
    dReal bounds[6];
    dGeomGetAABB(box, bounds);
    note("height", bounds[5] - bounds[4]);
    return near(bounds[5] - bounds[4], 1, 1e-9);
}

DIFFERENCE(C38, diagonal, "a space reports few of the geoms near a diagonal ray")
{
    const dSpaceID space = dHashSpaceCreate(nullptr);
    for (int x = 0; x < 20; ++x)
        for (int y = 0; y < 20; ++y) dGeomSetPosition(dCreateSphere(space, 0.3), x, y, 0);
    const dGeomID ray = dCreateRay(nullptr, 30);
    dGeomRaySet(ray, -1, -1, 0, 1, 1, 0);
    int pairs = 0;
    dSpaceCollide2(ray, dGeomID(space), &pairs, &count_pair);
    note("pairs", pairs);
    return pairs >= 20 && pairs < 100;
}

// ---- spaces ----

DIFFERENCE(G1, loop, "a loop over a space that moves its geoms meets each once")
{
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    std::vector<dGeomID> met;
    for (int i = 0; i < 10; ++i) dCreateSphere(space, 1);
    dSpaceClean(space);
    for (int i = 0; i < 10; ++i) {
        met.push_back(dSpaceGetGeom(space, i));
        dGeomSetPosition(met.back(), i, 0, 0);
    }
    std::sort(met.begin(), met.end());
    return std::unique(met.begin(), met.end()) == met.end();
}

DIFFERENCE(G2, bounds, "the bounding box of a sweep-and-prune space is that of its members")
{
    const dSpaceID space = dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    dCreateSphere(space, 1);
    dReal bounds[6];
    dGeomGetAABB(dGeomID(space), bounds);
    return near(bounds[1] - bounds[0], 2, 1e-9);
}

DIFFERENCE(G3, member, "a quadtree's members can be counted through")
{
    const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
    const dSpaceID space = dQuadTreeSpaceCreate(nullptr, centre, extents, 3);
    const dGeomID sphere = dCreateSphere(space, 1);
    return dSpaceGetGeom(space, 0) == sphere;
}

DIFFERENCE(G8, itself, "a space never reports a geom with itself")
{
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    const dGeomID sphere = dCreateSphere(space, 1);
    int pairs = 0;
    dSpaceCollide2(sphere, dGeomID(space), &pairs, &count_pair);
    return pairs == 0;
}

DIFFERENCE(G7, ray, "a ray that was set has a rotation")
{
    const dGeomID ray = dCreateRay(nullptr, 1);
    dGeomRaySet(ray, 0, 0, 0, 1, 1, 0);
    const dReal* R = dGeomGetRotation(ray);
    const double slant = R[0] * R[2] + R[4] * R[6] + R[8] * R[10];
    note("column 0 . column 2", slant);
    return near(slant, 0, 1e-9);
}

DIFFERENCE(G9, arrays, "a convex keeps its shape when the arrays that it was made of are gone")
{
    std::vector<dReal> planes(kPlanes, kPlanes + 24), points(kPoints, kPoints + 24);
    const dGeomID convex = dCreateConvex(nullptr, planes.data(), 6, points.data(), 8, kFaces);
    const dGeomID plane = dCreatePlane(nullptr, 0, 0, 1, -0.4);
    std::fill(points.begin(), points.end(), 0);
    return Contacts(convex, plane).count == 4;
}

DIFFERENCE(G11, moved, "a convex that is set again has the bounding box of its new shape")
{
    const dSpaceID space = dSimpleSpaceCreate(nullptr);
    const dGeomID convex = cube();
    dSpaceAdd(space, convex);
    dSpaceClean(space);
    static dReal planes[24], points[24];
    for (int i = 0; i < 24; ++i)
        planes[i] = i % 4 == 3 ? 4 * kPlanes[i] : kPlanes[i], points[i] = 4 * kPoints[i];
    dGeomSetConvex(convex, planes, 6, points, 8, kFaces);
    dReal bounds[6];
    dGeomGetAABB(convex, bounds);
    note("height", bounds[5] - bounds[4]);
    return near(bounds[5] - bounds[4], 4, 1e-9);
}

}  // namespace
}  // namespace differences
