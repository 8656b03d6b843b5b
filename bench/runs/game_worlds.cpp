// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "bench/runs/game_worlds.h"

#include <ode/ragdoll.h>

#include <cmath>

namespace epode::bench {
namespace {

constexpr int kGame = 1;  // of dDefaults
using SetSpace = void (*)(dWorldID, dSpaceID);

}  // namespace

GameWorld::GameWorld(int stepper)
{
    find<SetNumber>("dWorldUseDefaults")(world, kGame);
    find<SetNumber>("dWorldSetStepThreads")(world, 1);
    find<SetNumber>("dWorldSetHybridStepper")(world, stepper);
    find<SetSpace>("dWorldSetContactSpace")(world, space);
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    dCreatePlane(space, 0, 0, 1, 0);
}

double GameWorld::random(double low, double high)
{
    state_ = state_ * 1664525u + 1013904223u;
    return low + (high - low) * double(state_ >> 8) / 16777216.0;
}

dBodyID GameWorld::add(dGeomID geom, const dMass& mass, double x, double y, double z)
{
    const dBodyID body = dBodyCreate(world);
    dBodySetMass(body, &mass);
    dGeomSetBody(geom, body);
    dBodySetPosition(body, dReal(x), dReal(y), dReal(z));
    return body;
}

dBodyID GameWorld::box(double x, double y, double z, double a, double b, double c, double density)
{
    dMass mass;
    dMassSetBox(&mass, dReal(density), dReal(a), dReal(b), dReal(c));
    return add(dCreateBox(space, dReal(a), dReal(b), dReal(c)), mass, x, y, z);
}

dBodyID GameWorld::capsule(double x, double y, double z, double radius, double length, int along)
{
    dMass mass;
    dMassSetCapsule(&mass, 1000, 3, dReal(radius), dReal(length));
    const dBodyID body = add(dCreateCapsule(space, dReal(radius), dReal(length)), mass, x, y, z);
    dMatrix3 R;
    dRFromAxisAndAngle(R, 0, 1, 0, along == 3 ? 0 : dReal(1.5707963267948966));
    dBodySetRotation(body, R);
    return body;
}

void GameWorld::ball(dBodyID a, dBodyID b, double x, double y, double z)
{
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, a, b);
    dJointSetBallAnchor(joint, dReal(x), dReal(y), dReal(z));
}

void GameWorld::hinge(dBodyID a, dBodyID b, double x, double y, double z, double ax, double ay)
{
    const dJointID joint = dJointCreateHinge(world, nullptr);
    dJointAttach(joint, a, b);
    dJointSetHingeAnchor(joint, dReal(x), dReal(y), dReal(z));
    dJointSetHingeAxis(joint, dReal(ax), dReal(ay), 0);
    dJointSetHingeParam(joint, dParamLoStop, dReal(-0.1));
    dJointSetHingeParam(joint, dParamHiStop, 2);
}

namespace {

// Pieces of 5 to 30 cm that fly apart, boxes and balls, of unequal mass.
void build_debris(GameWorld& s, int count)
{
    const int side = int(std::ceil(std::sqrt(count / 4.0)));
    for (int i = 0; i < count; ++i) {
        const double size = s.random(0.05, 0.3);
        const double x = i / 4 % side * 0.45 + s.random(-0.05, 0.05), z = 0.3 + i % 4 * 0.4;
        const double y = i / 4 / side * 0.45 + s.random(-0.05, 0.05);
        dMass mass;
        dMassSetSphere(&mass, 2000, dReal(size / 2));
        const dBodyID body =
            i % 3 ? s.box(x, y, z, size, s.random(0.05, 0.3), s.random(0.05, 0.3), s.random(300, 3000))
                  : s.add(dCreateSphere(s.space, dReal(size / 2)), mass, x, y, z);
        const double v[3] = {s.random(-2, 2), s.random(-2, 2), s.random(-1, 3)};
        dBodySetLinearVel(body, dReal(v[0]), dReal(v[1]), dReal(v[2]));
        const double w[3] = {s.random(-5, 5), s.random(-5, 5), s.random(-5, 5)};
        dBodySetAngularVel(body, dReal(w[0]), dReal(w[1]), dReal(w[2]));
    }
}

// Eleven bodies.
void add_figure(GameWorld& s, double x, double y, double z)
{
    const dBodyID pelvis = s.box(x, y, z + 1, 0.3, 0.2, 0.2, 1000),
                  chest = s.box(x, y, z + 1.35, 0.36, 0.22, 0.4, 1000);
    const dBodyID head = s.capsule(x, y, z + 1.75, 0.1, 0.08, 3);
    s.ball(pelvis, chest, x, y, z + 1.12);
    s.ball(chest, head, x, y, z + 1.6);
    for (int side = -1; side <= 1; side += 2) {
        const dBodyID upper = s.capsule(x + side * 0.35, y, z + 1.5, 0.05, 0.22, 1);
        const dBodyID lower = s.capsule(x + side * 0.65, y, z + 1.5, 0.045, 0.2, 1);
        s.ball(chest, upper, x + side * 0.2, y, z + 1.5);
        s.hinge(upper, lower, x + side * 0.5, y, z + 1.5, 0, 1);
        const dBodyID thigh = s.capsule(x + side * 0.1, y, z + 0.7, 0.075, 0.3, 3);
        const dBodyID shin = s.capsule(x + side * 0.1, y, z + 0.27, 0.06, 0.3, 3);
        s.ball(pelvis, thigh, x + side * 0.1, y, z + 0.92);
        s.hinge(thigh, shin, x + side * 0.1, y, z + 0.48, 1, 0);
    }
}

void build_figures(GameWorld& s, int count)
{
    for (int i = 0; i < count; ++i)
        add_figure(s, i % 6 + s.random(-0.1, 0.1), i / 6 * 0.7 + s.random(-0.1, 0.1), 0.3 + i % 3 * 0.3);
}

void build_figure_pile(GameWorld& s, int count)
{
    for (int i = 0; i < count; ++i)
        add_figure(s, i % 3 * 0.6 + s.random(-0.1, 0.1), i / 3 % 3 * 0.5 + s.random(-0.1, 0.1),
                   0.3 + i / 9 * 2.2);
}

// Figures of 16 bones with stops and dry friction on every axis, dropped on each other in four layers.
void build_humans(GameWorld& s, int count)
{
    const auto make_human = find<decltype(&dBonesMakeHuman)>("dBonesMakeHuman");
    const auto create = find<decltype(&dRagdollCreate)>("dRagdollCreate");
    dBone bones[dRagdollMaxBones];
    dBodyID bodies[dRagdollMaxBones];
    const int bone_count = make_human(bones, dRagdollMaxBones, dReal(1.8), 75);
    int side = 1;
    while (side * side * 4 < count) ++side;
    for (int i = 0; i < count; ++i) {
        const dVector3 place = {dReal(i % side), dReal(i / side % side),
                                dReal(0.5 + 2.2 * (i / (side * side)))};
        dQuaternion turn;
        dQFromAxisAndAngle(turn, dReal(0.3 + 0.1 * i), 1, dReal(0.2 * i), dReal(0.3 + 0.77 * i));
        create(s.world, s.space, bones, bone_count, place, turn, bodies);
    }
}

void build_stacks(GameWorld& s, int count)
{
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 10; ++k) s.box(i % 10 * 0.55, i / 10 * 0.55, 0.26 + k * 0.51, 0.5, 0.5, 0.5, 160);
}

void build_towers(GameWorld& s, int count)
{
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 20; ++k) s.box(i % 10 * 1.5, i / 10 * 1.5, 0.5 + k, 1, 1, 1, 100);
}

}  // namespace

const std::vector<GameWorldRecipe>& game_worlds()
{
    static const std::vector<GameWorldRecipe> kAll = {{"debris", build_debris, 500},
                                                      {"debris", build_debris, 2000},
                                                      {"debris", build_debris, 10000, true},
                                                      {"ragdolls", build_figures, 30},
                                                      {"ragdolls in a pile", build_figure_pile, 30},
                                                      {"humans in a pile", build_humans, 20},
                                                      {"stacks of 10 crates", build_stacks, 100},
                                                      {"towers of 20 boxes", build_towers, 10}};
    return kAll;
}

}  // namespace epode::bench
