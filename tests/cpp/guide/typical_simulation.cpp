// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The guide's "typical simulation" in C++: a world, bodies, geoms on them, a space, a contact joint for every
// contact, all contacts in one group that is emptied after each step. A box, a ball, a capsule and a cylinder
// fall on the ground and must lie there at the height that their shape gives, at rest; and one thrown along
// the ground must stop after v^2 / (2 mu g).
#include <ode/ode.h>

#include "check.h"

namespace {

const dReal kGravity = REAL(9.81), kStep = REAL(0.005), kMu = REAL(0.5);

struct Scene {
    dWorld world;
    dSimpleSpace space;
    dJointGroup contacts;
    Scene()
    {
        space.setCleanup(0);  // each geom below has an owner of its own
        world.setGravity(0, 0, -kGravity);
    }
};

/** A body with a shape. */
template <class Shape>
struct Thing {
    dBody body;
    Shape shape;
    Thing(Scene& scene, const dMass& mass, dReal x, dReal z) : body(scene.world)
    {
        body.setMass(mass);
        body.setPosition(x, 0, z);
    }
    void wear(Scene& scene)
    {
        scene.space.add(shape);
        shape.setBody(body);
    }
};

void near_callback(void* data, dGeomID a, dGeomID b)
{
    Scene& scene = *static_cast<Scene*>(data);
    dContact contact[8];
    const int count = dCollide(a, b, 8, &contact[0].geom, sizeof contact[0]);
    for (int i = 0; i < count; ++i) {
        contact[i].surface.mode = dContactApprox1;
        contact[i].surface.mu = kMu;
        dContactJoint joint(scene.world, scene.contacts, &contact[i]);
        joint.attach(dGeomGetBody(a), dGeomGetBody(b));
    }
}

void run(Scene& scene, double seconds)
{
    for (int i = 0; i < int(seconds / kStep); ++i) {
        scene.space.collide(&scene, near_callback);
        scene.world.step(kStep);
        scene.contacts.empty();
    }
}

dReal speed(const dBody& body)
{
    const dReal* v = body.getLinearVel();
    return dSqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
}

void lie_on_the_ground()
{
    Scene scene;
    dPlane ground(scene.space, 0, 0, 1, 0);
    dMass mass;
    mass.setBox(1000, REAL(0.4), REAL(0.5), REAL(0.3));
    Thing<dBox> box(scene, mass, 0, REAL(0.5));
    box.shape.create(0, REAL(0.4), REAL(0.5), REAL(0.3));
    mass.setSphere(1000, REAL(0.25));
    Thing<dSphere> ball(scene, mass, 2, REAL(0.5));
    ball.shape.create(0, REAL(0.25));
    mass.setCylinder(1000, 3, REAL(0.3), REAL(0.4));
    Thing<dCylinder> drum(scene, mass, 4, REAL(0.4));
    drum.shape.create(0, REAL(0.3), REAL(0.4));
    mass.setCapsule(1000, 3, REAL(0.2), REAL(0.6));
    Thing<dCapsule> pill(scene, mass, 6, REAL(0.5));
    pill.shape.create(0, REAL(0.2), REAL(0.6));
    dQuaternion lying;
    dQFromAxisAndAngle(lying, 0, 1, 0, REAL(M_PI) / 2);
    pill.body.setQuaternion(lying);
    box.wear(scene);
    ball.wear(scene);
    drum.wear(scene);
    pill.wear(scene);

    run(scene, 3);
    expect_close("box lies at half its height, m", box.body.getPosition()[2], 0.15, 1e-3);
    expect_close("ball lies at its radius, m", ball.body.getPosition()[2], 0.25, 1e-3);
    expect_close("drum stands at half its length, m", drum.body.getPosition()[2], 0.2, 1e-3);
    expect_close("pill lies at its radius, m", pill.body.getPosition()[2], 0.2, 1e-3);
    expect_close("box is at rest, m/s", speed(box.body), 0, 1e-3);
    expect_close("drum is at rest, m/s", speed(drum.body), 0, 1e-3);
}

void slide_and_stop()
{
    Scene scene;
    dPlane ground(scene.space, 0, 0, 1, 0);
    dMass mass;
    mass.setBoxTotal(2, 1, 1, REAL(0.2));
    Thing<dBox> sledge(scene, mass, 0, REAL(0.1));
    sledge.shape.create(0, 1, 1, REAL(0.2));
    sledge.wear(scene);
    run(scene, 0.5);
    const dReal start = sledge.body.getPosition()[0], thrown = 3;
    sledge.body.setLinearVel(thrown, 0, 0);
    run(scene, 2);
    const double wanted = thrown * thrown / (2 * kMu * kGravity);
    expect_close("sledge stops after v^2 / (2 mu g), m", sledge.body.getPosition()[0] - start, wanted,
                 0.02 * wanted);
    expect_close("sledge has stopped, m/s", speed(sledge.body), 0, 1e-3);
}

}  // namespace

int main()
{
    dInitODE();
    lie_on_the_ground();
    slide_and_stop();
    dCloseODE();
    return 0;
}
