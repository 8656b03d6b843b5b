// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See scenes.h. The machine is one row of bodies 1 m apart, each joined to the one before; the first hangs on
// the world; motors keep it busy, the ground is there for its end.
#include "scenes.h"

namespace epode::physics {
namespace {

void build_pile(Sim& sim, Random& random)
{
    sim.ground();
    for (int i = 0; i < 40; ++i) {
        const V3 at{random.uniform(-1, 1), random.uniform(-1, 1), 0.4 + 0.12 * i};
        dBodyID b = i % 4 == 0   ? sim.box(at, {0.5, 0.4, 0.3}, 2)
                    : i % 4 == 1 ? sim.sphere(at, 0.25, 1)
                    : i % 4 == 2 ? sim.capsule(at, 0.15, 0.4, 1)
                                 : sim.cylinder(at, 0.2, 0.4, 1.5);
        dQuaternion q;
        random.quaternion(q);
        dBodySetQuaternion(b, q);
    }
}

dJointID create(Sim& sim, int kind)
{
    switch (kind) {
        case 0:
            return dJointCreateHinge(sim.world, nullptr);
        case 1:
            return dJointCreateBall(sim.world, nullptr);
        case 2:
            return dJointCreateSlider(sim.world, nullptr);
        case 3:
            return dJointCreateUniversal(sim.world, nullptr);
        case 4:
            return dJointCreateHinge2(sim.world, nullptr);
        case 5:
            return dJointCreateFixed(sim.world, nullptr);
        default:
            return dJointCreateAMotor(sim.world, nullptr);
    }
}

void set_up(dJointID j, dReal x)
{
    const dVector3 up{0, 0, 1, 0}, side{0, 1, 0, 0};
    switch (dJointGetType(j)) {
        case dJointTypeHinge:
            dJointSetHingeAnchor(j, x, 0, 4);
            dJointSetHingeAxis(j, 0, 1, real(0.25));
            dJointSetHingeParam(j, dParamVel, 2);
            dJointSetHingeParam(j, dParamFMax, 30);
            dJointSetHingeParam(j, dParamLoStop, -1);
            dJointSetHingeParam(j, dParamHiStop, 1);
            break;
        case dJointTypeBall:
            dJointSetBallAnchor(j, x, 0, 4);
            break;
        case dJointTypeSlider:
            dJointSetSliderAxis(j, 1, real(0.5), 0);
            dJointSetSliderParam(j, dParamLoStop, real(-0.2));
            dJointSetSliderParam(j, dParamHiStop, real(0.2));
            dJointSetSliderParam(j, dParamBounce, real(0.5));
            break;
        case dJointTypeUniversal:
            dJointSetUniversalAnchor(j, x, 0, 4);
            dJointSetUniversalAxis1(j, 0, 1, 0);
            dJointSetUniversalAxis2(j, 0, 0, 1);
            dJointSetUniversalParam(j, dParamVel2, 1);
            dJointSetUniversalParam(j, dParamFMax2, 5);
            break;
        case dJointTypeHinge2:
            dJointSetHinge2Anchor(j, x, 0, 4);
            dJointSetHinge2Axes(j, up, side);
            dJointSetHinge2Param(j, dParamSuspensionERP, real(0.4));
            dJointSetHinge2Param(j, dParamSuspensionCFM, real(0.001));
            break;
        case dJointTypeFixed:
            dJointSetFixed(j);
            break;
        default:
            dJointSetAMotorMode(j, dAMotorEuler);
            dJointSetAMotorAxis(j, 0, 1, 1, 0, 0);
            dJointSetAMotorAxis(j, 2, 2, 0, 0, 1);
            dJointSetAMotorParam(j, dParamFMax, 3);
            break;
    }
}

void build_machine(Sim& sim, Random& random)
{
    sim.ground();
    dBodyID before = nullptr;
    for (int i = 0; i < 14; ++i) {
        dBodyID b = sim.box({i + 0.5, 0, 4}, {0.8, 0.2, 0.2}, random.uniform(0.5, 2));
        const int kind = i % 7;
        dJointID j = create(sim, kind);
        dJointAttach(j, b, before);
        set_up(j, real(i));
        if (kind == 6) {  // an angular motor alone holds nothing together
            dJointID ball = create(sim, 1);
            dJointAttach(ball, b, before);
            set_up(ball, real(i));
        }
        before = b;
    }
}

void build_wall(Sim& sim, Random& random)
{
    sim.ground();
    for (int row = 0; row < 6; ++row)
        for (int i = 0; i < 5; ++i)
            sim.box({i * 0.42 + 0.2 * (row % 2), 0, 0.1 + 0.2 * row}, {0.4, 0.2, 0.2}, 1);
    dBodyID ball = sim.sphere({0.9, -1.5, 0.5}, 0.2, 5);
    velocity(ball, {random.uniform(-0.5, 0.5), 12, 1});
}

}  // namespace

const char* name_of(Scene scene)
{
    return scene == Scene::kPile ? "pile" : scene == Scene::kMachine ? "machine" : "wall";
}

int steps_of(Scene scene) { return scene == Scene::kMachine ? 300 : 150; }

void build(Sim& sim, Scene scene, std::uint32_t seed)
{
    Random random(seed);
    sim.gravity(0, 0, -9.81);
    sim.surface.mode |= dContactBounce;
    sim.surface.bounce = real(0.2);
    sim.surface.bounce_vel = real(0.5);
    switch (scene) {
        case Scene::kPile:
            return build_pile(sim, random);
        case Scene::kMachine:
            return build_machine(sim, random);
        case Scene::kWall:
            return build_wall(sim, random);
    }
}

}  // namespace epode::physics
