// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scene.h"

#include <cstdarg>
#include <cstdio>
#include <cstring>

namespace epode::states {
namespace {

constexpr dReal kH = dReal(1) / 60;

std::string g_last;
int g_count = 0;

void receive(int, const char* format, va_list arguments)
{
    char text[400];
    std::vsnprintf(text, sizeof text, format, arguments);
    // Scenes of arbitrary numbers may run away; that is said, and nothing is refused.
    if (!std::strstr(text, "no simulation is meant beyond")) g_last = text, ++g_count;
}

void touch(void* data, dGeomID a, dGeomID b)
{
    const auto& scene = *static_cast<const Running*>(data);
    if (dGeomIsSpace(a) || dGeomIsSpace(b)) return;
    const dBodyID body1 = dGeomGetBody(a), body2 = dGeomGetBody(b);
    if (body1 && body2 && dAreConnectedExcluding(body1, body2, dJointTypeContact)) return;
    dContact contact[4];
    const int count = dCollide(a, b, 4, &contact[0].geom, sizeof contact[0]);
    for (int i = 0; i < count; ++i) {
        contact[i].surface.mode = dContactApprox1;
        contact[i].surface.mu = dReal(0.7);
        dJointAttach(dJointCreateContact(scene.world, scene.contacts, &contact[i]), body1, body2);
    }
}

}  // namespace

const char* name_of(Stepper stepper)
{
    constexpr const char* kNames[] = {"exact", "quick", "small_steps", "hybrid"};
    return kNames[int(stepper)];
}

Scene::Scene(const Setting& s)
    : setting(s), world(dWorldCreate()), space(dHashSpaceCreate(nullptr)), contacts(dJointGroupCreate(0))
{
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    dWorldSetStepThreads(world, s.threads);
    if (s.exact_rotation) dWorldSetExactRotation(world, 1);
    if (s.world_contacts) dWorldSetContactSpace(world, space);
    if (s.sleeps) {
        dWorldSetAutoDisableFlag(world, 1);
        dWorldSetAutoDisableSteps(world, 4);
        dWorldSetAutoDisableLinearThreshold(world, dReal(0.05));
        dWorldSetAutoDisableAngularThreshold(world, dReal(0.05));
        dWorldSetAutoDisableAverageSamplesCount(world, 3);
    }
    add_grounds();
    for (int i = 0; i < s.piles; ++i) add_pile(i);
    const dBodyID bullet = add(1, -8, dReal(0.3), dReal(1.2));
    dGeomSetContinuous(dBodyGetFirstGeom(bullet), dContinuousOn);
    dBodySetLinearVel(bullet, 60, 0, dReal(0.5));
    if (s.joints) add_joints();
}

Scene::~Scene()
{
    dJointGroupDestroy(contacts);
    dWorldDestroy(world);
    dSpaceDestroy(space);
    dGeomTriMeshDataDestroy(mesh_);
}

void Scene::add_grounds()
{
    grounds.push_back(dCreatePlane(space, 0, 0, 1, 0));
    grounds.push_back(dCreateBox(space, 6, 40, 1));
    dGeomSetPosition(grounds[1], 11, 0, dReal(-0.3));
    static const dReal corners[4][4] = {{-20, -9, 0, 0}, {20, -9, 0, 0}, {20, -3, 0, 0}, {-20, -3, 0, 0}};
    static const dTriIndex faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
    mesh_ = dGeomTriMeshDataCreate();
#ifdef dIDEDOUBLE
    dGeomTriMeshDataBuildDouble(mesh_, corners, sizeof corners[0], 4, faces, 6, sizeof faces[0]);
#else
    dGeomTriMeshDataBuildSingle(mesh_, corners, sizeof corners[0], 4, faces, 6, sizeof faces[0]);
#endif
    grounds.push_back(dCreateTriMesh(space, mesh_, nullptr, nullptr, nullptr));
    dGeomSetPosition(grounds[2], 0, 0, dReal(0.02));
}

dBodyID Scene::add(int kind, dReal x, dReal y, dReal z)
{
    const dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetBox(&mass, kind == 0 ? 2000 : 500, 1, dReal(0.9), dReal(0.8));
    dBodySetMass(body, &mass);
    dBodySetPosition(body, x, y, z);
    const dGeomID geom = kind == 0   ? dCreateBox(space, 1, dReal(0.9), dReal(0.8))
                         : kind == 1 ? dCreateSphere(space, dReal(0.4))
                         : kind == 2 ? dCreateCapsule(space, dReal(0.3), dReal(0.5))
                         : kind == 3 ? dCreateCylinder(space, dReal(0.45), dReal(0.8))
                                     : dCreateBox(space, dReal(0.8), dReal(0.8), dReal(0.8));
    dGeomSetBody(geom, body);
    if (kind == 4) dGeomSetOffsetPosition(geom, dReal(0.05), 0, 0);
    bodies.push_back(body);
    return body;
}

void Scene::add_pile(int i)
{
    const dReal x = dReal(i % 3) * 4, y = dReal(i / 3) * 3 - 5;
    for (int k = 0; k < 3; ++k)
        add((i + 2 * k) % 5, x + dReal(0.05) * dReal(k), y, dReal(0.6) + dReal(0.95) * dReal(k));
}

template <typename Set>
dJointID Scene::join(dJointID joint, int a, int b, Set&& set)
{
    dJointAttach(joint, bodies[std::size_t(a)], b < 0 ? nullptr : bodies[std::size_t(b)]);
    set(joint);
    joints.push_back(joint);
    return joint;
}

// A chain of bodies high above, each hung on the one before by another type.
void Scene::add_joints()
{
    const int first = int(bodies.size());
    constexpr int kTypes = 16;
    const auto x = [](int i) { return dReal(-30) + dReal(1.5) * dReal(i); };
    for (int i = 0; i <= kTypes; ++i) {
        const dBodyID body = add(i % 5, x(i), 12, 9);
        dBodySetAutoDisableFlag(body, 0);
        if (i % 4 == 1) dBodySetFiniteRotationMode(body, 1);
    }
    const auto a = [&](int i) { return first + i; };
    const auto middle = [&](int i) { return x(i) + dReal(0.75); };
    join(dJointCreateBall(world, nullptr), a(0), -1,
         [&](dJointID j) { dJointSetBallAnchor(j, x(0) - 1, 12, 9); });
    join(dJointCreateHinge(world, nullptr), a(0), a(1), [&](dJointID j) {
        dJointSetHingeAnchor(j, middle(0), 12, 9), dJointSetHingeAxis(j, 0, 1, 0);
        dJointSetHingeParam(j, dParamLoStop, dReal(-0.3)), dJointSetHingeParam(j, dParamHiStop, dReal(0.3));
        dJointSetHingeParam(j, dParamBounce, dReal(0.4));
    });
    join(dJointCreateSlider(world, nullptr), a(1), a(2), [&](dJointID j) {
        dJointSetSliderAxis(j, 1, 0, 0);
        dJointSetSliderParam(j, dParamVel, dReal(0.3)), dJointSetSliderParam(j, dParamFMax, 500);
        dJointSetSliderParam(j, dParamLoStop, -1), dJointSetSliderParam(j, dParamHiStop, 1);
    });
    join(dJointCreateUniversal(world, nullptr), a(2), a(3), [&](dJointID j) {
        dJointSetUniversalAnchor(j, middle(2), 12, 9);
        dJointSetUniversalAxis1(j, 0, 1, 0), dJointSetUniversalAxis2(j, 0, 0, 1);
    });
    join(dJointCreateHinge2(world, nullptr), a(3), a(4), [&](dJointID j) {
        const dVector3 up = {0, 0, 1}, side = {0, 1, 0};
        dJointSetHinge2Anchor(j, middle(3), 12, 9), dJointSetHinge2Axes(j, up, side);
        dJointSetHinge2Param(j, dParamSuspensionERP, dReal(0.4));
    });
    join(dJointCreateFixed(world, nullptr), a(4), a(5), [](dJointID j) { dJointSetFixed(j); });
    join(dJointCreatePR(world, nullptr), a(5), a(6), [&](dJointID j) {
        dJointSetPRAnchor(j, middle(5), 12, 9);
        dJointSetPRAxis1(j, 1, 0, 0), dJointSetPRAxis2(j, 0, 1, 0);
        dJointSetPRParam(j, dParamLoStop, dReal(-0.5)), dJointSetPRParam(j, dParamHiStop, dReal(0.5));
    });
    join(dJointCreatePU(world, nullptr), a(6), a(7), [&](dJointID j) {
        dJointSetPUAnchor(j, middle(6), 12, 9);
        dJointSetPUAxis1(j, 0, 1, 0), dJointSetPUAxis2(j, 0, 0, 1), dJointSetPUAxis3(j, 1, 0, 0);
        dJointSetPUParam(j, dParamLoStop3, dReal(-0.5)), dJointSetPUParam(j, dParamHiStop3, dReal(0.5));
    });
    join(dJointCreatePiston(world, nullptr), a(7), a(8), [&](dJointID j) {
        dJointSetPistonAnchor(j, middle(7), 12, 9), dJointSetPistonAxis(j, 1, 0, 0);
        dJointSetPistonParam(j, dParamLoStop, dReal(-0.5)), dJointSetPistonParam(j, dParamHiStop, dReal(0.5));
    });
    join(dJointCreateDBall(world, nullptr), a(8), a(9),
         [&](dJointID j) { dJointSetDBallAnchor1(j, x(8), 12, 9), dJointSetDBallAnchor2(j, x(9), 12, 9); });
    join(dJointCreateDHinge(world, nullptr), a(9), a(10), [&](dJointID j) {
        dJointSetDHingeAxis(j, 0, 1, 0);
        dJointSetDHingeAnchor1(j, x(9), 12, 9), dJointSetDHingeAnchor2(j, x(10), 12, 9);
    });
    join(dJointCreateBall(world, nullptr), a(10), a(11),
         [&](dJointID j) { dJointSetBallAnchor(j, middle(10), 12, 9); });
    for (const int mode : {dAMotorUser, dAMotorEuler})
        join(dJointCreateAMotor(world, nullptr), a(10), a(11), [&](dJointID j) {
            dJointSetAMotorMode(j, mode);
            dJointSetAMotorNumAxes(j, 3);
            dJointSetAMotorAxis(j, 0, 1, 0, 1, 0);
            if (mode == dAMotorUser) dJointSetAMotorAxis(j, 1, 0, 1, 0, 0);
            dJointSetAMotorAxis(j, 2, 2, 0, 0, 1);
            dJointSetAMotorParam(j, dParamVel, dReal(0.2)), dJointSetAMotorParam(j, dParamFMax, 40);
        });
    join(dJointCreateLMotor(world, nullptr), a(12), -1, [&](dJointID j) {
        dJointSetLMotorNumAxes(j, 2);
        dJointSetLMotorAxis(j, 0, 0, 1, 0, 0), dJointSetLMotorAxis(j, 1, 1, 0, 0, 1);
        dJointSetLMotorParam(j, dParamVel, dReal(0.1)), dJointSetLMotorParam(j, dParamFMax, 3000);
        dJointSetLMotorParam(j, dParamFMax2, 9000);
    });
    dBodySetPosition(bodies[std::size_t(a(13))], x(13), 20, 0);
    join(dJointCreatePlane2D(world, nullptr), a(13), -1, [](dJointID j) {
        dJointSetPlane2DXParam(j, dParamVel, 1), dJointSetPlane2DXParam(j, dParamFMax, 100);
    });
    for (const int i : {14, 15})
        join(dJointCreateHinge(world, nullptr), a(i), -1, [&](dJointID j) {
            dJointSetHingeAnchor(j, x(i), 12, 9), dJointSetHingeAxis(j, 0, 0, 1);
            if (i == 14) dJointSetHingeParam(j, dParamVel, 4), dJointSetHingeParam(j, dParamFMax, 200);
        });
    join(dJointCreateTransmission(world, nullptr), a(14), a(15), [&](dJointID j) {
        dJointSetTransmissionMode(j, dTransmissionParallelAxes);
        dJointSetTransmissionAnchor1(j, x(14), 12, 9), dJointSetTransmissionAnchor2(j, x(15), 12, 9);
        dJointSetTransmissionAxis(j, 0, 0, 1), dJointSetTransmissionRatio(j, 2);
        dJointSetTransmissionBacklash(j, dReal(0.02));
    });
    join(dJointCreateNull(world, nullptr), a(16), -1, [](dJointID) {});
}

void step_with(Stepper stepper, dWorldID world, dReal h, int substeps)
{
    switch (stepper) {
        case Stepper::kExact:
            dWorldStep(world, h);
            break;
        case Stepper::kQuick:
            dWorldQuickStep(world, h);
            break;
        case Stepper::kSubsteps:
            dWorldStepFast1(world, h, substeps);
            break;
        case Stepper::kHybrid:
            dWorldStepHybrid(world, h);
            break;
    }
}

void Scene::step() { running().step(); }

void Running::step() const
{
    if (!world_contacts) dSpaceCollide(space, const_cast<Running*>(this), touch);
    step_with(stepper, world, kH, 4);
    dJointGroupEmpty(contacts);
}

Bytes state_of(dWorldID world)
{
    Bytes state(dWorldGetStateSize(world));
    EXPECT_EQ(dWorldGetState(world, state.data(), state.size()), 1) << Messages::last();
    return state;
}

int Scene::asleep() const
{
    int count = 0;
    for (const dBodyID body : bodies) count += !dBodyIsEnabled(body);
    return count;
}

std::string difference(const Bytes& a, const Bytes& b)
{
    if (a == b) return "";
    std::size_t i = 0;
    while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
    if (i >= 16 && i < 24) {  // the checksum
        i = 24;
        while (i < a.size() && i < b.size() && a[i] == b[i]) ++i;
    }
    return std::to_string(a.size()) + " and " + std::to_string(b.size()) + " bytes, from byte " +
           std::to_string(i);
}

Messages::Messages()
{
    g_last.clear(), g_count = 0;
    dSetDebugHandler(receive), dSetMessageHandler(receive), dSetErrorHandler(receive);
}

Messages::~Messages() { dSetDebugHandler(nullptr), dSetMessageHandler(nullptr), dSetErrorHandler(nullptr); }

std::string Messages::last() { return g_last; }
int Messages::count() { return g_count; }

}  // namespace epode::states
