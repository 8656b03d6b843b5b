// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The stage of all demos. Contacts are ODE's way: a callback makes joints of the points where two geoms
// touch, unless their bodies hang together by a joint already.
#include "stage.h"

#include <ode/ext.h>

#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <deque>
#include <vector>

namespace demo {

dWorldID world = nullptr;
dSpaceID space = nullptr;
dReal friction = 1, bounce = 0;

namespace {

struct Paint {
    float r, g, b;
    int texture;
};

const Plan* plan = nullptr;
dJointGroupID contacts = nullptr;
std::vector<dGeomID> drawn;
std::deque<Paint> paints;
long steps = 0;
bool judged = false, failed = false;

constexpr Paint kPalette[] = {{0.90f, 0.45f, 0.33f, DS_WOOD}, {0.95f, 0.78f, 0.50f, DS_WOOD},
                              {0.30f, 0.62f, 0.68f, DS_NONE}, {0.93f, 0.89f, 0.82f, DS_NONE},
                              {0.60f, 0.74f, 0.54f, DS_NONE}, {0.36f, 0.50f, 0.70f, DS_NONE}};

dGeomID with_body(dGeomID geom, const dMass& mass, double x, double y, double z)
{
    const dBodyID made = dBodyCreate(world);
    dBodySetMass(made, &mass);
    dGeomSetBody(geom, made);
    dBodySetPosition(made, x, y, z);
    return draw(geom);
}

void touch(void*, dGeomID a, dGeomID b)
{
    constexpr int kCapacity = 32;
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
        dSpaceCollide2(a, b, nullptr, touch);
        return;
    }
    const dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    if (!first && !second) return;
    if (first && second && dAreConnectedExcluding(first, second, dJointTypeContact)) return;
    dContact points[kCapacity] = {};
    const int count = dCollide(a, b, kCapacity, &points[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        points[i].surface.mode = dContactApprox1 | (bounce > 0 ? dContactBounce : 0);
        points[i].surface.mu = friction;
        points[i].surface.bounce = bounce;
        points[i].surface.bounce_vel = 0.1;
        if (plan->surface) plan->surface(a, b, &points[i]);
        dJointAttach(dJointCreateContact(world, contacts, &points[i]), first, second);
    }
}

void draw_mesh(dGeomID geom)
{
    const int count = dGeomTriMeshGetTriangleCount(geom);
    const dReal none[3] = {0, 0, 0}, upright[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    for (int i = 0; i < count; ++i) {
        dVector3 v0, v1, v2;
        dGeomTriMeshGetTriangle(geom, i, &v0, &v1, &v2);
        dsDrawTriangle(none, upright, v0, v1, v2, 1);
    }
}

void draw_convex(dGeomID geom)
{
    std::vector<dReal> points(3 * size_t(dGeomConvexGetPoints(geom, nullptr, 0)));
    std::vector<unsigned> polygons(size_t(dGeomConvexGetPolygons(geom, nullptr, 0)));
    std::vector<dReal> planes(4 * size_t(dGeomConvexGetPlanes(geom, nullptr, 0)));
    dGeomConvexGetPoints(geom, points.data(), int(points.size() / 3));
    dGeomConvexGetPolygons(geom, polygons.data(), int(polygons.size()));
    dGeomConvexGetPlanes(geom, planes.data(), int(planes.size() / 4));
    dsDrawConvex(dGeomGetPosition(geom), dGeomGetRotation(geom), planes.data(), unsigned(planes.size() / 4),
                 points.data(), unsigned(points.size() / 3), polygons.data());
}

// Of cones, ellipsoids and what else is convex and no class of ODE's.
void draw_triangles(dGeomID geom)
{
    constexpr int kSegments = 24;
    std::vector<dReal> corners(9 * size_t(dGeomGetTriangles(geom, kSegments, nullptr, 0)));
    dGeomGetTriangles(geom, kSegments, corners.data(), int(corners.size() / 9));
    for (size_t k = 0; k < corners.size(); k += 9)
        dsDrawTriangle(dGeomGetPosition(geom), dGeomGetRotation(geom), &corners[k], &corners[k + 3],
                       &corners[k + 6], 1);
}

void draw_one(dGeomID geom)
{
    if (const auto* look = static_cast<const Paint*>(dGeomGetData(geom))) {
        dsSetTexture(look->texture);
        dsSetColor(look->r, look->g, look->b);
    }
    if (dGeomGetClass(geom) == dTriMeshClass) return draw_mesh(geom);
    if (dGeomGetClass(geom) == dConvexClass) return draw_convex(geom);
    if (dGeomGetClass(geom) >= dGeomNumClasses) return draw_triangles(geom);
    const dReal *pos = dGeomGetPosition(geom), *R = dGeomGetRotation(geom);
    dReal radius = 0, length = 0;
    dVector3 sides;
    switch (dGeomGetClass(geom)) {
        case dBoxClass:
            dGeomBoxGetLengths(geom, sides);
            dsDrawBox(pos, R, sides);
            break;
        case dSphereClass:
            dsDrawSphere(pos, R, static_cast<float>(dGeomSphereGetRadius(geom)));
            break;
        case dCapsuleClass:
            dGeomCapsuleGetParams(geom, &radius, &length);
            dsDrawCapsule(pos, R, static_cast<float>(length), static_cast<float>(radius));
            break;
        case dCylinderClass:
            dGeomCylinderGetParams(geom, &radius, &length);
            dsDrawCylinder(pos, R, static_cast<float>(length), static_cast<float>(radius));
            break;
        default:
            break;  // a demo draws what is its own
    }
}

bool is_set(const char* name) { return std::getenv(name) && *std::getenv(name); }

bool has_window()
{
    if (is_set("EPODE_GL")) return std::strcmp(std::getenv("EPODE_GL"), "egl") != 0;
    return is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
}

void begin() { dsSetViewpoint(plan->eye, plan->look); }

double step_size() { return 1.0 / 60 / plan->steps_a_frame; }

void step_world()
{
    if (plan->every_step) plan->every_step(static_cast<double>(steps) * step_size());
    if (!plan->world_contacts) dSpaceCollide(space, nullptr, touch);
    dWorldStep(world, step_size());
    dJointGroupEmpty(contacts);
    ++steps;
}

void frame(int paused)
{
    for (int i = 0; i < plan->steps_a_frame && !paused; ++i) step_world();
    for (const dGeomID geom : drawn) draw_one(geom);
    if (judged || static_cast<double>(steps) * step_size() < plan->seconds - 0.5 * step_size()) return;
    judged = true;
    plan->judge();
    std::fprintf(stderr, failed ? "the demo does not do what it claims\n" : "all claims hold\n");
    if (!has_window()) dsStop();
}

void end()
{
    if (!judged) std::fprintf(stderr, "ended before the verdict\n");
}

}  // namespace

dGeomID draw(dGeomID geom)
{
    const Paint& next = kPalette[drawn.size() % (sizeof kPalette / sizeof kPalette[0])];
    drawn.push_back(geom);
    return paint(geom, next.r, next.g, next.b, next.texture);
}

dGeomID paint(dGeomID geom, float r, float g, float b, int texture)
{
    paints.push_back({r, g, b, texture});
    dGeomSetData(geom, &paints.back());
    return geom;
}

dGeomID box(double x, double y, double z, double sx, double sy, double sz, double density)
{
    dMass mass;
    dMassSetBox(&mass, density, sx, sy, sz);
    return with_body(dCreateBox(space, sx, sy, sz), mass, x, y, z);
}

dGeomID sphere(double x, double y, double z, double radius, double density)
{
    dMass mass;
    dMassSetSphere(&mass, density, radius);
    return with_body(dCreateSphere(space, radius), mass, x, y, z);
}

dGeomID capsule(double x, double y, double z, double radius, double length, double density)
{
    dMass mass;
    dMassSetCapsule(&mass, density, 3, radius, length);
    return with_body(dCreateCapsule(space, radius, length), mass, x, y, z);
}

dGeomID cylinder(double x, double y, double z, double radius, double length, double density)
{
    dMass mass;
    dMassSetCylinder(&mass, density, 3, radius, length);
    return with_body(dCreateCylinder(space, radius, length), mass, x, y, z);
}

dBodyID body(dGeomID geom) { return dGeomGetBody(geom); }
const dReal* place(dGeomID geom) { return dGeomGetPosition(geom); }

void claim(bool holds, const char* format, ...)
{
    if (holds) return;
    failed = true;
    std::va_list values;
    va_start(values, format);
    std::fputs("does not hold: ", stderr);
    std::vfprintf(stderr, format, values);
    std::fputc('\n', stderr);
    va_end(values);
}

bool near(double a, double b, double tolerance) { return std::fabs(a - b) <= tolerance; }

int run(int argc, char** argv, const Plan& what)
{
    plan = &what;
    dInitODE2(0);
    world = dWorldCreate();
    space = dHashSpaceCreate(nullptr);
    contacts = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, -9.81);
    dCreatePlane(space, 0, 0, 1, 0);
    if (plan->world_contacts) dWorldSetContactSpace(world, space);
    plan->build();
    dsFunctions functions = {DS_VERSION, begin, frame, plan->key, end, nullptr};
    dsSimulationLoop(argc, argv, 800, 500, &functions);
    const bool fine = judged && !failed;
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(world);
    dCloseODE();
    return fine ? 0 : 1;
}

}  // namespace demo
