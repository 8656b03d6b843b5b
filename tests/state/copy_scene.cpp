// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
// Geom transforms are deprecated, and must still be copied.
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#include "copy_scene.h"

#include <cmath>
#include <cstdio>
#include <set>

namespace epode::states {
namespace {

constexpr dReal kCorners[8][4] = {{-1, -1, -1, 0}, {1, -1, -1, 0}, {1, 1, -1, 0}, {-1, 1, -1, 0},
                                  {-1, -1, 1, 0},  {1, -1, 1, 0},  {1, 1, 1, 0},  {-1, 1, 1, 0}};
constexpr dTriIndex kFaces[12][3] = {{0, 2, 1}, {0, 3, 2}, {4, 5, 6}, {4, 6, 7}, {0, 1, 5}, {0, 5, 4},
                                     {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}};

dReal wave(void*, int i, int j) { return dReal((i * 7 + j * 3) % 5) / 8; }

// Of a space and the spaces in it.
void gather(dSpaceID space, std::vector<dGeomID>& out)
{
    for (int i = 0; i < dSpaceGetNumGeoms(space); ++i) {
        const dGeomID geom = dSpaceGetGeom(space, i);
        out.push_back(geom);
        if (dGeomIsSpace(geom)) gather(reinterpret_cast<dSpaceID>(geom), out);
    }
}

}  // namespace

RichScene::RichScene(const Setting& s) : Scene(s)
{
    add_solids();
    add_surfaces();
    add_spaces();
    add_drives();
}

RichScene::~RichScene()
{
    dJointGroupDestroy(group_);
    dGeomTriMeshDataDestroy(block_);
    dGeomHeightfieldDataDestroy(hills_), dGeomHeightfieldDataDestroy(waves_);
}

void RichScene::add_solid(dGeomID geom, int i)
{
    const dBodyID body = dBodyCreate(world);
    dMass mass;
    dMassSetSphereTotal(&mass, 1 + dReal(0.25) * dReal(i), dReal(0.4));
    dBodySetMass(body, &mass);
    dBodySetPosition(body, -9 + dReal(1.1) * dReal(i), 12, dReal(1.1) + dReal(0.1) * dReal(i % 3));
    dGeomSetBody(geom, body);
    if (i % 3 == 0) dGeomSetOffsetPosition(geom, dReal(0.03), 0, dReal(0.02));
    if (i % 2) dBodySetLinearDamping(body, dReal(0.01)), dBodySetMaxAngularSpeed(body, 30);
    dBodySetAngularVel(body, 1, dReal(i), 0);
    dMaterial material;
    dMaterialInit(&material, sizeof material);
    material.friction = dReal(0.1) * dReal(i), material.bounce = dReal(0.3), material.bounce_speed = 0;
    if (i % 4 == 1) dGeomSetMaterial(geom, &material);
    bodies.push_back(body);
}

void RichScene::add_solids()
{
    const dReal r = dReal(0.4);
    dReal points[12][3];
    for (int i = 0; i < 12; ++i) {
        const double a = i, b = i * i;
        points[i][0] = dReal(0.5 * std::sin(a)), points[i][1] = dReal(0.5 * std::cos(a)),
        points[i][2] = dReal(0.4 * std::sin(b));
    }
    block_ = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(block_, kCorners[0], 8, kFaces[0], 36);
    add_solid(dCreateCone(space, r, 1), 0);
    add_solid(dCreateEllipsoid(space, r, dReal(0.3), dReal(0.5)), 1);
    add_solid(dCreateTaperedCapsule(space, dReal(0.2), dReal(0.4), dReal(0.5)), 2);
    for (int i = 3; i < 6; ++i) add_solid(dCreateConvexHull(space, points[0], 12, 0), i);
    for (int i = 6; i < 8; ++i) {
        const dGeomID mesh = dCreateTriMesh(space, block_, nullptr, nullptr, nullptr);
        dGeomTriMeshSetSolid(mesh, 1);
        add_solid(mesh, i);
    }
    const dGeomID transform = dCreateGeomTransform(space), inner = dCreateBox(nullptr, r, r, r);
    dGeomSetPosition(inner, dReal(0.1), 0, 0);
    dGeomTransformSetCleanup(transform, 1);
    dGeomTransformSetGeom(transform, inner);
    add_solid(transform, 8);
    add_solid(dCreateSphere(nullptr, r), 9);  // in no space
    add_solid(dCreateCylinder(space, r, 1), 10);
    dGeomSetCategoryBits(dBodyGetFirstGeom(bodies.back()), 6);
    dGeomSetCollideBits(dBodyGetFirstGeom(bodies.back()), 0xffff);
    dGeomSetBody(dCreateBox(space, r, 1, r), bodies.back());
    sensor = dCreateSphere(space, 1);
    dGeomSetPosition(sensor, -7, 12, 1), dGeomSetSensor(sensor, 1);
    dGeomRaySet(dCreateRay(space, 5), -9, 12, 4, 0, 0, -1);
}

void RichScene::add_surfaces()
{
    for (int i = 0; i < 81; ++i) heights_[i] = static_cast<unsigned char>(i * 37 % 11);
    hills_ = dGeomHeightfieldDataCreate(), waves_ = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildByte(hills_, heights_, 0, 30, 8, 9, 9, dReal(0.05), 0, 1, 0);
    dGeomHeightfieldDataSetHole(hills_, 1, 1, 1);
    dGeomHeightfieldDataBuildCallback(waves_, nullptr, wave, 4, 4, 6, 6, 1, 0, 1, 1);
    dGeomHeightfieldDataSetBounds(waves_, 0, 1);
    dMatrix3 up;
    dRFromAxisAndAngle(up, 1, 0, 0, dReal(1.5707963267948966));
    for (const dHeightfieldDataID field : {hills_, hills_, waves_}) {
        const dGeomID geom = dCreateHeightfield(space, field, 1);
        dGeomSetRotation(geom, up);
        dGeomSetPosition(geom, field == waves_ ? 300 : 0, 14, dReal(0.1));
        grounds.push_back(geom);
    }
    dCreateHeightfield(space, waves_, 0);
    dGeomDisable(dSpaceGetGeom(space, 0));
    dCreateTriMesh(space, nullptr, nullptr, nullptr, nullptr);
}

void RichScene::add_spaces()
{
    const dVector3 centre = {0, 0, 0}, extents = {50, 50, 50};
    const dSpaceID deep = dQuadTreeSpaceCreate(space, centre, extents, 3), empty = dSimpleSpaceCreate(deep);
    const dSpaceID sweep = dSweepAndPruneSpaceCreate(space, dSAP_AXES_XYZ), hash = dHashSpaceCreate(sweep);
    dHashSpaceSetLevels(hash, -2, 6), dSpaceSetSublevel(hash, 2), dSpaceSetCleanup(empty, 0);
    add_solid(dCreateBox(deep, dReal(0.5), dReal(0.6), dReal(0.7)), 12);
    add_solid(dCreateCapsule(hash, dReal(0.3), dReal(0.5)), 13);
    dSpaceRemove(space, grounds[0]), dSpaceAdd(space, grounds[0]);
}

void RichScene::add_drives()
{
    dDrive drive;
    dDriveInit(&drive, sizeof drive);
    drive.stiffness = 40, drive.damping = 3, drive.target = dReal(0.3), drive.armature = dReal(0.01);
    const std::size_t a = bodies.size() - 3;
    const dJointID one = dJointCreateHinge(world, nullptr), two = dJointCreateHinge(world, group_),
                   both = dJointCreateCoupling(world, nullptr), three = dJointCreateBall(world, nullptr);
    dJointAttach(two, nullptr, bodies[a + 1]), dJointAttach(one, bodies[a], nullptr);
    dJointAttach(three, bodies[a + 2], bodies[a]);
    dJointSetDrive(one, 0, &drive);
    dJointSetBreakLimits(three, 4000, 4000);
    dJointSetCouplingAxis(both, 0, one, 0, 1), dJointSetCouplingAxis(both, 1, two, 0, dReal(-0.5));
    dJointSetCouplingParam(both, dParamLoStop, dReal(-0.01));
    dJointSetStopSpring(both, 0, 900, 20);
    dJointSetHingeParam(one, dParamHiStop, dReal(0.2)), dJointSetStopSpring(one, 0, 300, 5);
    dJointSetSpring(three, 5000, 40);
    drive.target = 0, drive.force = dReal(0.5), drive.force_limit = 6;
    dJointSetDrive(both, 0, &drive), dJointSetAxisContinuous(two, 0, 1);
    for (const dJointID joint : {one, two, both, three}) joints.push_back(joint);
}

Copy::Copy(const Scene& scene, dWorldID world, dSpaceID space, bool owns_meshes)
    : running{world, space, dJointGroupCreate(0), scene.setting.stepper, scene.setting.world_contacts},
      owns_meshes_(owns_meshes)
{}

Copy::Copy(Copy&& other) noexcept : running(other.running), owns_meshes_(other.owns_meshes_)
{
    other.running.world = nullptr;
}

Copy Copy::cloned(const Scene& scene)
{
    dSpaceID space = scene.space;
    const dWorldID world = dWorldClone(scene.world, &space, nullptr, 0);
    EXPECT_TRUE(world) << Messages::last();
    return {scene, world, space, false};
}

Copy Copy::loaded(const Scene& scene)
{
    const Bytes file = file_of(scene.world, scene.space);
    dSpaceID space = nullptr;
    const dWorldID world = dWorldLoadFromBuffer(file.data(), file.size(), &space);
    EXPECT_TRUE(world) << Messages::last();
    return {scene, world, space, true};
}

Copy::~Copy()
{
    if (!running.world) return;
    std::vector<dGeomID> geoms, loose;
    std::set<dTriMeshDataID> meshes;
    std::set<dHeightfieldDataID> fields;
    gather(running.space, geoms);
    std::vector<dBodyID> bodies(std::size_t(dWorldGetBodies(running.world, nullptr, 0)));
    dWorldGetBodies(running.world, bodies.data(), int(bodies.size()));
    for (const dBodyID body : bodies)
        for (dGeomID geom = dBodyGetFirstGeom(body); geom; geom = dBodyGetNextGeom(geom))
            if (!dGeomGetSpace(geom)) loose.push_back(geom);
    for (const dGeomID geom : owns_meshes_ ? geoms : std::vector<dGeomID>()) {
        if (dGeomGetClass(geom) == dTriMeshClass) meshes.insert(dGeomTriMeshGetData(geom));
        if (dGeomGetClass(geom) == dHeightfieldClass) fields.insert(dGeomHeightfieldGetHeightfieldData(geom));
    }
    dJointGroupDestroy(running.contacts);
    dWorldDestroy(running.world);
    for (const dGeomID geom : loose) dGeomDestroy(geom);
    dSpaceDestroy(running.space);
    for (const dTriMeshDataID mesh : meshes)
        if (mesh) dGeomTriMeshDataDestroy(mesh);
    for (const dHeightfieldDataID field : fields) dGeomHeightfieldDataDestroy(field);
}

std::string text_of(dWorldID world)
{
    std::FILE* const file = std::tmpfile();
    dWorldExportDIF(world, file, "w");
    std::string text(std::size_t(std::ftell(file)), ' ');
    std::rewind(file);
    EXPECT_EQ(std::fread(text.data(), 1, text.size(), file), text.size());
    std::fclose(file);
    return text;
}

Bytes file_of(dWorldID world, dSpaceID space)
{
    Bytes file(dWorldSaveToBuffer(world, space, nullptr, 0));
    EXPECT_EQ(dWorldSaveToBuffer(world, space, file.data(), file.size()), file.size()) << Messages::last();
    return file;
}

}  // namespace epode::states
