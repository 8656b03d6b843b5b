// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A small world with much of what states and files have: a pile on a plane and a mesh, most of it at rest, a
// hinge with a drive, a slider with a motor, a coupling; a character that walks, water. With contacts of its own, or in ODE's way.
#pragma once

#include "seal.h"

namespace epode::fuzz {

struct World {
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    bool world_contacts;
    dGeomID character = nullptr;

    void step() const
    {
        const dVector3 walk = {1, 0, 0};
        dCharacterWalk(character, walk, 0, dReal(0.01));
        if (!world_contacts) dSpaceCollide(space, const_cast<World*>(this), touch);
        world_contacts ? dWorldStepFast1(world, dReal(0.01), 4) : dWorldQuickStep(world, dReal(0.01));
        dJointGroupEmpty(contacts);
    }

  private:
    static void touch(void* data, dGeomID a, dGeomID b)
    {
        const World& w = *static_cast<World*>(data);
        dContact contact[2] = {};
        for (int i = 0, n = dCollide(a, b, 2, &contact[0].geom, sizeof contact[0]); i < n; ++i) {
            contact[i].surface.mu = 1;
            dJointAttach(dJointCreateContact(w.world, w.contacts, &contact[i]), dGeomGetBody(a),
                         dGeomGetBody(b));
        }
    }
};

inline dGeomID make_mesh(dSpaceID space)
{
    static const float corners[4][3] = {{-9, -9, 0}, {9, -9, 0}, {9, 9, 0}, {-9, 9, 0}};
    static const dTriIndex faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
    const dTriMeshDataID mesh = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSingle(mesh, corners, sizeof corners[0], 4, faces, 6, sizeof faces[0]);
    return dCreateTriMesh(space, mesh, nullptr, nullptr, nullptr);
}

inline void add_joints(dWorldID world, const dBodyID (&body)[5])
{
    const dJointID hinge = dJointCreateHinge(world, nullptr), slider = dJointCreateSlider(world, nullptr),
                   coupling = dJointCreateCoupling(world, nullptr);
    dJointAttach(hinge, body[3], body[2]), dJointAttach(slider, body[4], nullptr);
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    drive.stiffness = 50, drive.damping = 2;
    dJointSetDrive(hinge, 0, &drive), dJointSetBreakLimits(hinge, 900, 900);
    dJointSetSliderParam(slider, dParamVel, 1), dJointSetSliderParam(slider, dParamFMax, 20);
    dJointSetCouplingAxis(coupling, 0, hinge, 0, 1),
        dJointSetCouplingAxis(coupling, 1, slider, 0, dReal(0.1));
}

inline dGeomID make_character(dSpaceID space)
{
    dCharacterSettings settings;
    dCharacterSettingsInit(&settings, sizeof settings);
    const dGeomID character = dCharacterCreate(space, &settings);
    dCharacterSetPosition(character, -5, 3, 0);
    return character;
}

inline World make_world(bool world_contacts)
{
    World w{dWorldCreate(), dHashSpaceCreate(nullptr), dJointGroupCreate(0), world_contacts};
    dWorldSetGravity(w.world, 0, 0, -10), dWorldSetAutoDisableFlag(w.world, 1);
    if (world_contacts) dWorldSetContactSpace(w.world, w.space);
    dCreatePlane(w.space, 0, 0, 1, 0), make_mesh(w.space);
    dBodyID body[5];
    for (int i = 0; i < 5; ++i) {
        body[i] = dBodyCreate(w.world);
        dBodySetPosition(body[i], i / 3, 0, dReal(0.45) + dReal(0.95) * (i % 3));
        dGeomSetBody(i % 2 ? dCreateSphere(w.space, dReal(0.5)) : dCreateBox(w.space, 1, 1, 1), body[i]);
    }
    add_joints(w.world, body);
    dFluidSetPlane(dFluidCreate(w.world), 0, 0, 1, dReal(0.1));
    w.character = make_character(w.space);
    return w;
}

}  // namespace epode::fuzz
