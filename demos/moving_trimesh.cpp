// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A car's ramp of triangles on a body of its own: a wedge that is a mesh slides on the floor when a ball runs
// up it, and what the ball loses in momentum the wedge has.
#include "stage.h"

static const float vertices[] = {-1, -0.5f, 0, 1, -0.5f, 0,    1, 0.5f, 0,
                                 -1, 0.5f,  0, 1, -0.5f, 0.8f, 1, 0.5f, 0.8f};
static const dTriIndex triangles[] = {0, 2, 1, 0, 3, 2, 0, 1, 4, 3, 5, 2, 1, 2, 5, 1, 5, 4, 0, 4, 5, 0, 5, 3};
static dGeomID wedge, ball;
static double highest = 0;

static void build()
{
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(data, vertices, 3 * sizeof(float), 6, triangles, 24, 3 * sizeof(dTriIndex));
    wedge = demo::paint(demo::draw(dCreateTriMesh(demo::space, data, nullptr, nullptr, nullptr)), 0.9f, 0.7f,
                        0.4f);
    dMass mass;
    dMassSetTrimesh(&mass, 500, wedge);
    dGeomSetPosition(wedge, 0, 0, 0);
    const dReal middle[3] = {mass.c[0], mass.c[1], mass.c[2]};
    dMassTranslate(&mass, -middle[0], -middle[1], -middle[2]);
    const dBodyID body = dBodyCreate(demo::world);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, middle[0], middle[1], middle[2]);
    dGeomSetBody(wedge, body);
    dGeomSetOffsetPosition(wedge, -middle[0], -middle[1], -middle[2]);
    demo::friction = 0;
    demo::paint(ball = demo::sphere(-2.5, 0, 0.25, 0.25, 4000), 0.3f, 0.35f, 0.5f);
    dBodySetLinearVel(demo::body(ball), 4, 0, 0);
}

static void watch(double) { highest = std::fmax(highest, demo::place(ball)[2]); }

static void judge()
{
    dMass of_wedge, of_ball;
    dBodyGetMass(demo::body(wedge), &of_wedge);
    dBodyGetMass(demo::body(ball), &of_ball);
    const double v = dBodyGetLinearVel(demo::body(wedge))[0], u = dBodyGetLinearVel(demo::body(ball))[0];
    demo::claim(demo::near(of_wedge.mass, 400, 1), "the wedge weighs %g kg", of_wedge.mass);
    const double before = 4 * of_ball.mass, after = of_wedge.mass * v + of_ball.mass * u;
    demo::claim(demo::near(after, before, 0.02 * before), "momentum went from %g to %g", before, after);
    demo::claim(v > 1, "the wedge slides at %g m/s", v);
    demo::claim(highest > 0.35, "the ball came no higher than %g m", highest);
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0.6f, -4.2f, 1.8f}, {97, -16, 0}, 1.2, build, judge, watch});
}
