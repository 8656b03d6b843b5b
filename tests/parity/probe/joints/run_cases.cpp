// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Runs of 100 steps that are not chaotic, so that rounding does not grow: pendulum, chain of eight links,
// slider running into its stop, motor hinge, sliding boxes, a settled stack and pyramid, a buggy on the
// plane.
#include "case_list.h"

#include <vector>

namespace parity {
namespace {

struct World {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dJointGroupID contacts = dJointGroupCreate(0);
    int mode = dContactApprox1;
    double mu = 0.5;

    World() { dWorldSetGravity(world, 0, 0, -9.81); }
    ~World()
    {
        dJointGroupDestroy(contacts);
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;
};

void near(void* data, dGeomID a, dGeomID b)
{
    World& w = *static_cast<World*>(data);
    dContact found[16] = {};
    const dBodyID first = dGeomGetBody(a), second = dGeomGetBody(b);
    if (first != nullptr && second != nullptr && dAreConnectedExcluding(first, second, dJointTypeContact)) {
        return;
    }
    const int count = dCollide(a, b, 16, &found[0].geom, sizeof(dContact));
    for (int i = 0; i < count; ++i) {
        found[i].surface.mode = w.mode;
        found[i].surface.mu = w.mu;
        dJointAttach(dJointCreateContact(w.world, w.contacts, &found[i]), first, second);
    }
}

void run(World& w, int steps, double step_size)
{
    for (int i = 0; i < steps; ++i) {
        dSpaceCollide(w.space, &w, &near);
        dWorldStep(w.world, step_size);
        dJointGroupEmpty(w.contacts);
    }
}

dBodyID add_body(World& w, double x, double y, double z)
{
    const dBodyID body = dBodyCreate(w.world);
    dMass mass;
    dMassSetBoxTotal(&mass, 1, 0.3, 0.4, 0.5);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, x, y, z);
    return body;
}

dBodyID add_box(World& w, double side_x, double side_y, double side_z, double x, double y, double z)
{
    const dBodyID body = dBodyCreate(w.world);
    dMass mass;
    dMassSetBox(&mass, 1, side_x, side_y, side_z);
    dBodySetMass(body, &mass);
    dBodySetPosition(body, x, y, z);
    dGeomSetBody(dCreateBox(w.space, side_x, side_y, side_z), body);
    return body;
}

void put_all(Output& out, const std::vector<dBodyID>& bodies)
{
    for (std::size_t i = 0; i < bodies.size(); ++i) { out.put_body("body" + std::to_string(i), bodies[i]); }
}

PARITY_CASE(run_pendulum)
{
    World w;
    const dBodyID body = add_body(w, 1, 0, 0);
    const dJointID hinge = dJointCreateHinge(w.world, nullptr);
    dJointAttach(hinge, body, nullptr);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    run(w, 100, 0.01);
    put_all(out, {body});
    out.put("angle", {dJointGetHingeAngle(hinge), dJointGetHingeAngleRate(hinge)});
}

PARITY_CASE(run_chain)
{
    World w;
    std::vector<dBodyID> links;
    for (int i = 0; i < 8; ++i) {
        links.push_back(add_body(w, i + 0.5, 0, 0));
        const dJointID ball = dJointCreateBall(w.world, nullptr);
        dJointAttach(ball, links.back(), i == 0 ? nullptr : links[static_cast<std::size_t>(i - 1)]);
        dJointSetBallAnchor(ball, i, 0, 0);
    }
    run(w, 100, 0.005);
    put_all(out, links);
}

PARITY_CASE(run_slider_on_stop)
{
    World w;
    const dBodyID body = add_body(w, 0, 0, 2);
    const dJointID slider = dJointCreateSlider(w.world, nullptr);
    dJointAttach(slider, body, nullptr);
    dJointSetSliderAxis(slider, 0.6, 0, 0.8);
    dJointSetSliderParam(slider, dParamLoStop, -0.5);
    dJointSetSliderParam(slider, dParamHiStop, 0.5);
    dJointSetSliderParam(slider, dParamBounce, 0.4);
    run(w, 100, 0.01);
    put_all(out, {body});
    out.put("position", {dJointGetSliderPosition(slider), dJointGetSliderPositionRate(slider)});
}

PARITY_CASE(run_motor_hinge)
{
    World w;
    const dBodyID base = add_body(w, 0, 0, 0), arm = add_body(w, 1, 0, 0);
    const dJointID hold = dJointCreateFixed(w.world, nullptr), hinge = dJointCreateHinge(w.world, nullptr);
    dJointAttach(hold, base, nullptr);
    dJointSetFixed(hold);
    dJointAttach(hinge, base, arm);
    dJointSetHingeAnchor(hinge, 0.2, 0, 0);
    dJointSetHingeAxis(hinge, 0, 0, 1);
    dJointSetHingeParam(hinge, dParamVel, 2);
    dJointSetHingeParam(hinge, dParamFMax, 5);
    dJointSetHingeParam(hinge, dParamLoStop, -1.5);
    dJointSetHingeParam(hinge, dParamHiStop, 1.5);
    run(w, 100, 0.01);
    put_all(out, {base, arm});
    out.put("angle", {dJointGetHingeAngle(hinge), dJointGetHingeAngleRate(hinge)});
}

void run_sliding_box(Output& out, int mode, double mu)
{
    World w;
    w.mode = mode;
    w.mu = mu;
    dCreatePlane(w.space, 0, 0, 1, 0);
    const dBodyID box = add_box(w, 1, 0.8, 0.6, 0, 0, 0.2995);
    dBodySetLinearVel(box, 3, 1, 0);
    dWorldSetCFM(w.world, 1e-6);
    run(w, 100, 0.01);
    put_all(out, {box});
}

PARITY_CASE(run_sliding_box)
{
    out.open_block("force-limit");
    run_sliding_box(out, dContactApprox0, 0.3);
    out.open_block("coulomb");
    run_sliding_box(out, dContactApprox1, 0.3);
    out.open_block("ice");
    run_sliding_box(out, dContactApprox1, 0);
}

// How much a stack starts pressed together per box: from exact touching the original's LCP solver gives up in
// the first steps ("s <= 0") and boxes creep away, which is no reference.
constexpr double kPressed = 1e-3;

double stack_height(int level) { return 0.25 + 0.5 * level - kPressed * (2 * level + 1); }

void run_stack(Output& out, double softness)
{
    World w;
    dWorldSetCFM(w.world, softness);
    dCreatePlane(w.space, 0, 0, 1, 0);
    std::vector<dBodyID> boxes;
    for (int i = 0; i < 5; ++i) { boxes.push_back(add_box(w, 1, 1, 0.5, 0, 0, stack_height(i))); }
    run(w, 100, 0.01);
    put_all(out, boxes);
}

PARITY_CASE(run_stack)
{
    out.open_block("soft");
    run_stack(out, 1e-2);
    out.open_block("hard");
    run_stack(out, 1e-5);
}

void run_pyramid(Output& out, double softness)
{
    World w;
    dWorldSetCFM(w.world, softness);
    dCreatePlane(w.space, 0, 0, 1, 0);
    std::vector<dBodyID> boxes;
    for (int row = 0; row < 4; ++row) {
        for (int i = 0; i < 4 - row; ++i) {
            boxes.push_back(add_box(w, 1, 0.5, 0.5, (i + 0.5 * row) * 1.1, 0, stack_height(row)));
        }
    }
    run(w, 100, 0.01);
    put_all(out, boxes);
}

PARITY_CASE(run_pyramid)
{
    out.open_block("soft");
    run_pyramid(out, 1e-2);
    out.open_block("hard");
    run_pyramid(out, 1e-5);
}

PARITY_CASE(run_spheres)
{
    World w;
    dCreatePlane(w.space, 0, 0, 1, 0);
    std::vector<dBodyID> balls;
    for (int i = 0; i < 4; ++i) {
        balls.push_back(dBodyCreate(w.world));
        dBodySetPosition(balls.back(), 2.0 * i, 0, 0.5 + 0.1 * i);
        dBodySetLinearVel(balls.back(), 0, 1.0 + i, 0);
        dGeomSetBody(dCreateSphere(w.space, 0.5), balls.back());
    }
    run(w, 100, 0.01);
    put_all(out, balls);
}

PARITY_CASE(run_buggy)
{
    World w;
    dCreatePlane(w.space, 0, 0, 1, 0);
    dWorldSetCFM(w.world, 1e-6);
    const dBodyID chassis = add_box(w, 1.4, 0.6, 0.2, 0, 0, 0.45);
    std::vector<dBodyID> bodies = {chassis};
    const double place[4][2] = {{0.5, 0.4}, {0.5, -0.4}, {-0.5, 0.4}, {-0.5, -0.4}};
    for (int i = 0; i < 4; ++i) {
        const dBodyID wheel = dBodyCreate(w.world);
        dMass mass;
        dMassSetSphere(&mass, 1, 0.25);
        dBodySetMass(wheel, &mass);
        dBodySetPosition(wheel, place[i][0], place[i][1], 0.25);
        dGeomSetBody(dCreateSphere(w.space, 0.25), wheel);
        const dJointID joint = dJointCreateHinge2(w.world, nullptr);
        const dVector3 up = {0, 0, 1, 0}, axle = {0, 1, 0, 0};
        dJointAttach(joint, chassis, wheel);
        dJointSetHinge2Anchor(joint, place[i][0], place[i][1], 0.25);
        dJointSetHinge2Axes(joint, up, axle);
        dJointSetHinge2Param(joint, dParamSuspensionERP, 0.4);
        dJointSetHinge2Param(joint, dParamSuspensionCFM, 0.01);
        dJointSetHinge2Param(joint, dParamLoStop, 0);
        dJointSetHinge2Param(joint, dParamHiStop, 0);
        dJointSetHinge2Param(joint, dParamVel2, -4);
        dJointSetHinge2Param(joint, dParamFMax2, 0.2);
        bodies.push_back(wheel);
    }
    run(w, 100, 0.01);
    put_all(out, bodies);
}

}  // namespace
}  // namespace parity
