// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A scene of constant size that has warmed up asks for no memory: nested spaces of all classes, rays,
// transforms and a height field are collided, contacts made and forgotten, the world stepped, on one thread
// and on three.
#include "heap.h"

namespace epode::memory {
namespace {

struct Scene {
    dWorldID world = dWorldCreate();
    dSpaceID outer = dHashSpaceCreate(nullptr);
    std::vector<dSpaceID> inner;
    dJointGroupID contacts = dJointGroupCreate(0);
    dHeightfieldDataID field = dGeomHeightfieldDataCreate();
    dGeomID ray = nullptr;
    std::vector<dBodyID> bodies;
    int met = 0;

    explicit Scene(int threads)
    {
        static const double heights[16] = {0, 0.1, 0, 0, 0.1, 0.2, 0.1, 0, 0, 0.1, 0, 0, 0, 0, 0, 0};
        const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetStepThreads(world, threads);
        inner = {dSimpleSpaceCreate(outer), dSweepAndPruneSpaceCreate(outer, dSAP_AXES_XYZ),
                 dQuadTreeSpaceCreate(outer, centre, extents, 3)};
        inner.push_back(dHashSpaceCreate(inner[0]));
        dCreatePlane(outer, 0, 0, 1, 0);
        dGeomHeightfieldDataBuildDouble(field, heights, 1, 3, 3, 4, 4, dReal(0.1), 0, 1, 0);
        const dMatrix3 upright = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0};  // height fields have their y up
        dGeomID terrain = dCreateHeightfield(outer, field, 1);
        dGeomSetRotation(terrain, upright);
        ray = dCreateRay(nullptr, 10);
        dGeomRaySet(ray, -5, 0, dReal(0.3), 1, 0, 0);
        for (int i = 0; i < 36; ++i) add_body(i);
    }
    ~Scene()
    {
        dWorldDestroy(world);
        dSpaceDestroy(outer);
        dGeomDestroy(ray);
        dJointGroupDestroy(contacts);
        dGeomHeightfieldDataDestroy(field);
    }

    void add_body(int i)
    {
        dBodyID body = dBodyCreate(world);
        dBodySetPosition(body, dReal(0.5 * (i % 6) - 1), dReal(0.5 * (i / 6 % 3)),
                         dReal(0.4 + 0.5 * (i / 18)));
        dSpaceID space = inner[std::size_t(i) % inner.size()];
        dGeomID geom = nullptr;
        switch (i % 4) {
            case 0:
                geom = dCreateBox(space, dReal(0.4), dReal(0.4), dReal(0.4));
                break;
            case 1:
                geom = dCreateSphere(space, dReal(0.2));
                break;
            case 2:
                geom = dCreateCapsule(space, dReal(0.15), dReal(0.2));
                break;
            default:
                geom = dCreateGeomTransform(space);
                dGeomTransformSetCleanup(geom, 1);
                dGeomTransformSetGeom(geom, dCreateCylinder(nullptr, dReal(0.2), dReal(0.3)));
        }
        dGeomSetBody(geom, body);
        bodies.push_back(body);
    }

    static void near(void* self, dGeomID a, dGeomID b)
    {
        Scene& s = *static_cast<Scene*>(self);
        if (dGeomIsSpace(a) || dGeomIsSpace(b)) {
            dSpaceCollide2(a, b, self, &near);
            return;
        }
        dContact contact[6];
        const int n = dCollide(a, b, 6, &contact[0].geom, sizeof contact[0]);
        s.met += n;
        dBodyID one = dGeomGetBody(a), two = dGeomGetBody(b);
        if (!one && !two) return;
        for (int i = 0; i < n; ++i) {
            contact[i].surface = {};
            contact[i].surface.mu = 1;
            contact[i].surface.mode = dContactApprox1 | dContactSoftCFM;
            contact[i].surface.soft_cfm = dReal(1e-5);
            dJointAttach(dJointCreateContact(s.world, s.contacts, &contact[i]), one, two);
        }
    }

    void step_once(Stepper stepper)
    {
        met = 0;
        dSpaceCollide(outer, this, &near);
        for (dSpaceID s : inner) dSpaceCollide(s, this, &near);
        dSpaceCollide2(ray, reinterpret_cast<dGeomID>(outer), this, &near);
        EXPECT_EQ(step(world, stepper, dReal(0.005)), 1);
        dJointGroupEmpty(contacts);
    }
};

TEST(Warm, a_settled_scene_asks_for_no_memory)
{
    for (Stepper stepper : kSteppers)
        for (int threads : {1, 3}) {
            const Library library;
            Scene scene(threads);
            for (int i = 0; i < 400; ++i) scene.step_once(stepper);
            EXPECT_GT(Heap::asked(), 50) << "the handlers are in use";
            Heap::count();
            for (int i = 0; i < 100; ++i) scene.step_once(stepper);
            EXPECT_EQ(Heap::asked(), 0) << "stepper " << int(stepper) << ", " << threads << " threads";
            EXPECT_GT(scene.met, 15);
        }
}

// A block with a mesh for a hull, in many poses on rough ground with a hole: nothing is allocated.
TEST(Warm, a_mesh_on_a_height_field_asks_for_no_memory)
{
    const Library library;
    double heights[81];
    for (int k = 0; k < 81; ++k) heights[k] = 0.1 * (k * 7 % 5);
    dHeightfieldDataID field = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(field, heights, 1, 4, 4, 9, 9, 1, 0, 1, 0);
    dGeomHeightfieldDataSetHole(field, 5, 4, 1);
    dGeomID ground = dCreateHeightfield(nullptr, field, 1);
    static const dTriIndex sides[] = {0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                                      2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5};
    dReal corners[32] = {};
    for (int k = 0; k < 8; ++k)
        for (int x = 0; x < 3; ++x) corners[4 * k + x] = dReal(k >> x & 1 ? 0.3 : -0.3);
    dTriMeshDataID block = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(block, corners, 8, sides, 36);
    dGeomID mesh = dCreateTriMesh(nullptr, block, nullptr, nullptr, nullptr);
    Heap::count();
    int met = 0;
    for (int k = 0; k < 400; ++k) {
        dMatrix3 R;
        dRFromAxisAndAngle(R, 1, dReal(0.01 * k), dReal(0.3), dReal(0.1 * k));
        dGeomSetRotation(mesh, R);
        dGeomSetPosition(mesh, dReal(-1.5 + 0.0075 * k), dReal(0.1 + 0.05 * (k % 10)), dReal(0.1));
        dContactGeom contact[16];
        met += dCollide(mesh, ground, 16, contact, sizeof contact[0]) > 0;
    }
    EXPECT_EQ(Heap::asked(), 0);
    EXPECT_GT(met, 300);
    dGeomDestroy(mesh);
    dGeomTriMeshDataDestroy(block);
    dGeomDestroy(ground);
    dGeomHeightfieldDataDestroy(field);
}

}  // namespace
}  // namespace epode::memory
