// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The guide's chapter on the contact joint in C++: bounce, a moving surface (conveyor belt), force-dependent
// slip, the two friction models, rays and the user's data; each against its closed form.
#include <ode/ode.h>

#include "check.h"

namespace {

const dReal kGravity = REAL(9.81), kStep = REAL(0.002);

/** One body on the ground, with the surface that a test wants. */
struct Scene {
    dWorld world;
    dQuadTreeSpace space;
    dJointGroup contacts;
    dPlane ground;
    dBody body;
    dSurfaceParameters surface;

    static const dReal* region()
    {
        static const dVector3 kRegion = {10, 10, 10, 0};
        return kRegion;
    }
    static const dReal* origin()
    {
        static const dVector3 kOrigin = {0, 0, 0, 0};
        return kOrigin;
    }
    Scene() : space(origin(), region(), 4), ground(space, 0, 0, 1, 0), body(world)
    {
        space.setCleanup(0);
        world.setGravity(0, 0, -kGravity);
        surface.mode = 0;
        surface.mu = 0;
    }
    static void near_callback(void* data, dGeomID a, dGeomID b)
    {
        Scene& scene = *static_cast<Scene*>(data);
        dContact contact[4];
        const int count = dCollide(a, b, 4, &contact[0].geom, sizeof contact[0]);
        for (int i = 0; i < count; ++i) {
            contact[i].surface = scene.surface;
            contact[i].fdir1[0] = 1;
            contact[i].fdir1[1] = contact[i].fdir1[2] = 0;
            dContactJoint joint(scene.world, scene.contacts, &contact[i]);
            joint.attach(dGeomGetBody(a), dGeomGetBody(b));
        }
    }
    void step()
    {
        space.collide(this, near_callback);
        world.step(kStep);
        contacts.empty();
    }
    void run(double seconds)
    {
        for (int i = 0; i < int(seconds / kStep + 0.5); ++i) step();
    }

  private:
    Scene(const Scene&);
    void operator=(const Scene&);
};

void bounce()
{
    Scene scene;
    dSphere ball(scene.space, REAL(0.5));
    ball.setBody(scene.body);
    scene.body.setPosition(0, 0, REAL(1.5));
    scene.surface.mode = dContactBounce;
    scene.surface.bounce = REAL(0.8);
    scene.surface.bounce_vel = REAL(0.1);
    while (scene.body.getLinearVel()[2] <= 0) scene.step();
    dReal top = 0;
    for (int i = 0; i < 500; ++i) {
        scene.step();
        top = dMax(top, scene.body.getPosition()[2]);
    }
    expect_close("a ball bounces to e^2 of its height, m", top - 0.5, 0.64, 0.02);
}

void ride_a_belt()
{
    Scene scene;
    dBox box(scene.space, 1, 1, REAL(0.5));
    box.setBody(scene.body);
    scene.body.setPosition(0, 0, REAL(0.25));
    scene.surface.mode = dContactFDir1 | dContactMotion1 | dContactApprox1;
    scene.surface.mu = REAL(0.4);
    scene.surface.motion1 = 2;
    scene.run(0.25);
    expect_close("the belt pulls with mu g, m/s", std::fabs(scene.body.getLinearVel()[0]),
                 0.4 * kGravity * 0.25, 0.03);
    scene.run(1);
    expect_close("until the box rides with it, m/s", std::fabs(scene.body.getLinearVel()[0]), 2, 0.01);
}

void slip()
{
    Scene scene;
    dBox box(scene.space, 1, 1, REAL(0.5));
    box.setBody(scene.body);
    scene.body.setPosition(0, 0, REAL(0.25));
    scene.surface.mode = dContactFDir1 | dContactSlip1;
    scene.surface.mu = dInfinity;
    scene.surface.slip1 = REAL(0.2);
    for (int i = 0; i < 1500; ++i) {
        scene.body.addForceAtRelPos(3, 0, 0, 0, 0, REAL(-0.25));
        scene.step();
    }
    // Four corners share the force, each slips at slip1 times its share.
    expect_close("force-dependent slip moves it at k f, m/s", scene.body.getLinearVel()[0], 0.2 * 3 / 4,
                 0.01);
}

void friction_models()
{
    Scene scene;
    dSphere ball(scene.space, REAL(0.5));
    ball.setBody(scene.body);
    scene.body.setPosition(0, 0, REAL(0.5));
    scene.surface.mode = 0;
    scene.surface.mu = 2;
    scene.run(0.1);
    scene.body.setLinearVel(5, 0, 0);
    scene.run(0.1);
    expect_close("without Approx1 mu is a force, m/s", 5 - scene.body.getLinearVel()[0], 2 * 0.1, 0.01);
    scene.surface.mode = dContactApprox1;
    scene.surface.mu = REAL(0.1);
    const dReal before = scene.body.getLinearVel()[0];
    scene.run(0.1);
    expect_close("with it a coefficient, m/s", before - scene.body.getLinearVel()[0], 0.1 * kGravity * 0.1,
                 0.01);
}

void look_along_a_ray()
{
    dSphere ball(1);
    ball.setPosition(0, 0, 5);
    dRay ray(10);
    ray.set(0, 0, 0, 0, 0, 2);
    dContactGeom hit;
    expect("the ray hits the ball", dCollide(ray, ball, 1, &hit, sizeof hit) == 1);
    expect_close("at its near side, m", hit.depth, 4, 1e-5);
    dVector3 start, dir;
    ray.get(start, dir);
    expect_close("a direction comes back as a unit vector", dir[2], 1, 1e-6);
    int mark = 0;
    ball.setData(&mark);
    expect("geoms keep the program's data", dGeomGetData(hit.g2) == &mark || dGeomGetData(hit.g1) == &mark);
}

}  // namespace

int main()
{
    dInitODE();
    bounce();
    ride_a_belt();
    slip();
    friction_models();
    look_along_a_ray();
    dCloseODE();
    return 0;
}
