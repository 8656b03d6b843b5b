// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scene.h"

#include <cstdio>
#include <cstdlib>

#include "table.h"

namespace hostile {

Hooks g_hooks;

void near_nothing(void*, dGeomID, dGeomID) { g_hooks.near.run(); }
void moved_nothing(dBodyID) { g_hooks.moved.run(); }
void same_manifold(void*, dManifold*) {}

dReal flat_sea(void*, const dVector3, dReal) { return 0; }

void no_current(void*, const dVector3, dReal, dVector3) {}

dReal flat_height(void*, int, int)
{
    g_hooks.height.run();
    return 0;
}
int any_pair(void*, dGeomID, dGeomID) { return 1; }

int any_triangle(dGeomID, dGeomID, int)
{
    g_hooks.mesh.run();
    return 1;
}
void any_triangles(dGeomID, dGeomID, const int*, int) { g_hooks.mesh.run(); }
int any_hit(dGeomID, dGeomID, int, dReal, dReal)
{
    g_hooks.mesh.run();
    return 1;
}
int first_triangle(dGeomID, int first, int) { return first; }
int no_contacts(dGeomID, dGeomID, int, dContactGeom*, int)
{
    g_hooks.collider.run();
    return 0;
}

namespace {

dColliderFn* offer_collider(int) { return no_contacts; }

void unit_box(dGeomID geom, dReal box[6])
{
    const dReal* p = dGeomGetPosition(geom);
    for (int i = 0; i < 3; ++i) {
        box[2 * i] = p[i] - REAL(0.5);
        box[2 * i + 1] = p[i] + REAL(0.5);
    }
    g_hooks.box.run();
}

int always_near(dGeomID, dGeomID, dReal*)
{
    g_hooks.box_test.run();
    return 1;
}

void at_end(dGeomID) { g_hooks.end.run(); }

// ---- memory ----

long g_blocks = 0;
constexpr std::size_t kTooMuch = std::size_t(1) << 28;

void* counted_alloc(dsizeint size)
{
    void* p = size > kTooMuch ? nullptr : std::malloc(size);
    if (p) ++g_blocks;
    return p;
}
// As that of the C library: without a block it gives one, to nothing it frees.
void* counted_realloc(void* old, dsizeint, dsizeint size)
{
    if (size > kTooMuch) return nullptr;
    if (!old) return counted_alloc(size);
    if (size > 0) return std::realloc(old, size);
    --g_blocks;
    std::free(old);
    return nullptr;
}
void counted_free(void* p, dsizeint)
{
    --g_blocks;
    std::free(p);
}

// ---- messages ----

Messages g_messages;

void keep_refusal(int number, const char* format, va_list arguments)
{
    g_hooks.message.run();
    ++g_messages.refusals;
    if (number != d_ERR_UASSERT) g_messages.odd = true;
    std::vsnprintf(g_messages.text, sizeof g_messages.text, format, arguments);
}
void ignore(int, const char*, va_list) {}

// ---- parts of the scene ----

constexpr int kBodies = 10;

dContact contact_between(dReal x)
{
    dContact c{};
    c.surface.mode = dContactBounce | dContactApprox1;
    c.surface.mu = 1;
    c.surface.bounce = REAL(0.5);
    c.geom.pos[0] = x;
    c.geom.normal[2] = 1;
    c.geom.depth = REAL(0.01);
    return c;
}

}  // namespace

const Solid kCube = {
    {1, 0, 0, 1, -1, 0, 0, 1, 0, 1, 0, 1, 0, -1, 0, 1, 0, 0, 1, 1, 0, 0, -1, 1},
    {-1, -1, -1, 1, -1, -1, -1, 1, -1, 1, 1, -1, -1, -1, 1, 1, -1, 1, -1, 1, 1, 1, 1, 1},
    {4, 1, 3, 7, 5, 4, 0, 4, 6, 2, 4, 2, 6, 7, 3, 4, 0, 1, 5, 4, 4, 4, 5, 7, 6, 4, 0, 2, 3, 1}};

const Mesh kTetrahedron = {{0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0},
                           {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3}};

const dGeomClass kUserClass = {8, offer_collider, unit_box, always_near, at_end};

Messages& messages() { return g_messages; }
long blocks_held() { return g_blocks; }
void forget_blocks(long held) { g_blocks = held; }

void restore_handlers()
{
    dSetErrorHandler(ignore);
    dSetDebugHandler(keep_refusal);
    dSetMessageHandler(ignore);
    dSetAllocHandler(counted_alloc);
    dSetReallocHandler(counted_realloc);
    dSetFreeHandler(counted_free);
}

void reset_process()
{
    restore_handlers();
    // Closed until it refuses, so that classes and overrides are forgotten whatever has been opened.
    for (g_messages = {}; g_messages.refusals == 0;) dCloseODE();
    dInitODE2(0);
    dAllocateODEDataForThread(unsigned(dAllocateMaskAll));
    dCreateGeomClass(&kUserClass);
    dRandSetSeed(0);
    g_messages = {};
}

void Scene::build_bodies()
{
    for (int i = 0; i < kBodies; ++i) {
        const dBodyID body = dBodyCreate(world);
        dMass mass;
        dMassSetBoxTotal(&mass, dReal(1 + i), 1, dReal(0.5), dReal(0.3));
        dBodySetMass(body, &mass);
        dBodySetPosition(body, dReal(i), 0, 2);
        dBodySetAngularVel(body, dReal(0.1), dReal(0.2), dReal(0.3));
        dBodySetMovedCallback(body, moved_nothing);
        add(Kind::kBody, body);
    }
    const auto body = [&](int i) { return static_cast<dBodyID>(live[int(Kind::kBody)][std::size_t(i)]); };
    first_body = body(0);
    dBodySetKinematic(body(7));
    dBodyDisable(body(8));
    dBodySetAutoDisableFlag(body(6), 1);
    dBodySetFiniteRotationMode(body(5), 1);
    dBodySetDamping(body(4), dReal(0.1), dReal(0.1));
}

void Scene::build_joints()
{
    const auto body = [&](int i) { return static_cast<dBodyID>(live[int(Kind::kBody)][std::size_t(i)]); };
    int k = 0;
    for (CreateJoint create : joint_makers()) {
        const dJointID inner = create(world, nullptr), outer = create(world, nullptr);
        // A coupling has no bodies; hinge-2 and transmission refuse a single body and stay loose.
        const bool takes_bodies = create != dJointCreateCoupling;
        if (takes_bodies) dJointAttach(inner, body(k % 7), body(k % 7 + 1));
        const bool takes_one =
            takes_bodies && create != dJointCreateTransmission && create != dJointCreateHinge2;
        if (k % 3 == 0 && takes_one) dJointAttach(outer, body(k % 7), nullptr);
        if (k % 3 == 1 && takes_one) dJointAttach(outer, nullptr, body(k % 7));
        add(Kind::kJoint, inner);
        add(Kind::kJoint, outer);
        ++k;
    }
    // The first of the two of a type, or the second.
    const auto joint = [&](dJointType type, int which = 0) {
        for (void* p : live[int(Kind::kJoint)]) {
            const dJointID candidate = static_cast<dJointID>(p);
            if (dJointGetType(candidate) == type && which-- == 0) return candidate;
        }
        std::abort();
    };
    const dJointID hinge = joint(dJointTypeHinge);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    dJointSetHingeParam(hinge, dParamHiStop, 1);
    dJointSetHingeParam(hinge, dParamLoStop, -1);
    dJointSetSliderParam(joint(dJointTypeSlider), dParamFMax, 1);
    dJointSetTransmissionMode(joint(dJointTypeTransmission, 1), dTransmissionChainDrive);
    dJointSetAMotorNumAxes(joint(dJointTypeAMotor), 3);
    dJointSetCouplingAxis(joint(dJointTypeCoupling), 0, hinge, 0, 1);
    dJointSetCouplingAxis(joint(dJointTypeCoupling), 1, joint(dJointTypeSlider), 0, -2);
    dJointSetLMotorNumAxes(joint(dJointTypeLMotor), 3);
}

void Scene::build_geoms()
{
    const auto body = [&](int i) { return static_cast<dBodyID>(live[int(Kind::kBody)][std::size_t(i)]); };
    space = dHashSpaceCreate(nullptr);
    const dVector3 center = {0, 0, 0, 0}, extents = {10, 10, 10, 0};
    const dSpaceID spaces[] = {space, dSimpleSpaceCreate(space),
                               dSweepAndPruneSpaceCreate(space, dSAP_AXES_XYZ),
                               dQuadTreeSpaceCreate(space, center, extents, 3), dSimpleSpaceCreate(nullptr)};
    for (dSpaceID s : spaces) add(Kind::kSpace, s);
    dGeomID geoms[] = {
        dCreateSphere(space, 1),
        dCreateBox(spaces[1], 1, 1, 1),
        dCreateCapsule(spaces[2], 1, 1),
        dCreateCylinder(spaces[3], 1, 1),
        dCreateRay(space, 5),
        dCreatePlane(space, 0, 0, 1, 0),
        dCreateGeomTransform(spaces[1]),
        dCreateGeom(dFirstUserClass),
        dCreateSphere(nullptr, 1),
        dCreateBox(spaces[4], 1, 1, 1),
        dCreateGeom(dFirstUserClass),
        dCreateSphere(spaces[4], 1),
        dCreateBox(nullptr, 1, 1, 1),
        dCreateConvex(spaces[1], kCube.planes.data(), 6, kCube.points.data(), 8, kCube.faces.data()),
        dCreateCone(spaces[2], 1, 2),
        dCreateEllipsoid(spaces[3], 1, dReal(0.5), 2),
        dCreateTaperedCapsule(space, 1, dReal(0.5), 1),
        dCharacterCreate(space, nullptr),
        dCharacterCreate(spaces[2], nullptr)};
    for (dGeomID g : geoms) add(Kind::kGeom, g);
    for (int i = 0; i < 4; ++i) dGeomSetBody(geoms[i], body(i));
    dGeomSetOffsetPosition(geoms[1], 0, 0, dReal(0.5));
    dGeomSetPosition(geoms[4], 0, 0, 5);
    dGeomTransformSetGeom(geoms[6], geoms[12]);
    dGeomTransformSetCleanup(geoms[6], 1);
    dSpaceAdd(space, geoms[7]);
    dGeomSetPosition(geoms[7], 1, 0, 2);
    dGeomSetPosition(geoms[10], 0, 0, 1);
    dGeomSetBody(geoms[13], body(4));
    for (const int i : {1, 4}) {
        dVehicleCreate(body(i), nullptr);
        dVehicleAddWheel(body(i), nullptr);
    }
    user_geom = geoms[7];
    tested_geom = geoms[10];
    probe = geoms[8];
}

void Scene::build_heights()
{
    static const double kHeights[9] = {0, 1, 0, 1, 2, 1, 0, 1, 0};
    const dHeightfieldDataID array = dGeomHeightfieldDataCreate(), made = dGeomHeightfieldDataCreate(),
                             empty = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(array, kHeights, 1, 4, 4, 3, 3, 1, 0, 1, 0);
    dGeomHeightfieldDataBuildCallback(made, nullptr, flat_height, 4, 4, 3, 3, 1, 0, 1, 0);
    for (dHeightfieldDataID d : {array, made, empty}) add(Kind::kHeightfieldData, d);
    add(Kind::kGeom, dCreateHeightfield(space, array, 1));
    high_ground = dCreateHeightfield(space, made, 0);
    add(Kind::kGeom, high_ground);
    const dFluidID lake = dFluidCreate(world), current = dFluidCreate(world);
    dFluidSetCurrentFunction(current, no_current, nullptr);
    add(Kind::kFluid, lake), add(Kind::kFluid, current);
}

void Scene::build_meshes()
{
    const auto body = [&](int i) { return static_cast<dBodyID>(live[int(Kind::kBody)][std::size_t(i)]); };
    const dTriMeshDataID data = dGeomTriMeshDataCreate(), empty = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildDouble(data, kTetrahedron.vertices.data(), 4 * sizeof(double), 4,
                                kTetrahedron.corners.data(), 12, 3 * sizeof(unsigned));
    add(Kind::kTriMeshData, data);
    add(Kind::kTriMeshData, empty);
    mesh = dCreateTriMesh(space, data, any_triangle, any_triangles, any_hit);
    const dGeomID moving = dCreateTriMesh(space, data, nullptr, nullptr, nullptr);
    dGeomSetBody(moving, body(5));
    add(Kind::kGeom, mesh);
    add(Kind::kGeom, moving);
    add(Kind::kGeom, dCreateTriMesh(space, nullptr, nullptr, nullptr, nullptr));
}

void Scene::build_contacts()
{
    contacts = dJointGroupCreate(0);
    const dJointGroupID empty = dJointGroupCreate(0);
    add(Kind::kGroup, contacts);
    add(Kind::kGroup, empty);
    for (int i = 0; i < 2; ++i) {
        const dContact c = contact_between(dReal(i));
        const dJointID joint = dJointCreateContact(world, contacts, &c);
        dJointAttach(joint, static_cast<dBodyID>(live[int(Kind::kBody)][std::size_t(i)]), nullptr);
        add(Kind::kJoint, joint);
    }
}

void Scene::build_foreign()
{
    const dWorldID other = dWorldCreate();
    const dBodyID body = dBodyCreate(other);
    const dJointID ball = dJointCreateBall(other, nullptr);
    dJointAttach(ball, body, nullptr);
    (void)dWorldSetHistory(other, 2);  // its steps can be taken back
    (void)dWorldStep(other, dReal(0.01));
    add(Kind::kWorld, other);
    add(Kind::kBody, body);
    add(Kind::kJoint, ball);
}

// The implementation with threads has been shut down: else whoever serves it would never come back.
void Scene::build_threading()
{
    const dThreadingImplementationID own = dThreadingAllocateSelfThreadedImplementation(),
                                     shared = dThreadingAllocateMultiThreadedImplementation();
    dThreadingImplementationShutdownProcessing(shared);
    const dCooperativeID cooperative = dCooperativeCreate(nullptr, nullptr);
    const dResourceRequirementsID needs = dResourceRequirementsCreate(cooperative);
    dEstimateCooperativelyFactorLDLTResourceRequirements(needs, 1, 8);
    dEstimateCooperativelySolveLDLTResourceRequirements(needs, 1, 8);
    dEstimateCooperativelyScaleVectorResourceRequirements(needs, 1, 8);
    add(Kind::kThreading, own);
    add(Kind::kThreading, shared);
    if (with_threads)
        add(Kind::kThreadPool, dThreadingAllocateThreadPool(1, 0, dAllocateFlagBasicData, nullptr));
    add(Kind::kCooperative, cooperative);
    add(Kind::kRequirements, needs);
    add(Kind::kContainer, dResourceContainerAcquire(needs));
}

void Scene::tear_down_threading()
{
    for (void* c : live[int(Kind::kContainer)])
        dResourceContainerDestroy(static_cast<dResourceContainerID>(c));
    for (void* r : live[int(Kind::kRequirements)])
        dResourceRequirementsDestroy(static_cast<dResourceRequirementsID>(r));
    for (void* c : live[int(Kind::kCooperative)]) dCooperativeDestroy(static_cast<dCooperativeID>(c));
    for (void* t : live[int(Kind::kThreading)])
        dThreadingImplementationShutdownProcessing(static_cast<dThreadingImplementationID>(t));
    for (void* p : live[int(Kind::kThreadPool)])
        dThreadingFreeThreadPool(static_cast<dThreadingThreadPoolID>(p));
    for (void* t : live[int(Kind::kThreading)])
        dThreadingFreeImplementation(static_cast<dThreadingImplementationID>(t));
}

void Scene::kill_one_of_each()
{
    const dWorldID w = dWorldCreate();
    const dBodyID b = dBodyCreate(world);
    const dJointID j = dJointCreateHinge(world, nullptr);
    const dJointGroupID g = dJointGroupCreate(0);
    const dGeomID geom = dCreateSphere(nullptr, 1);
    const dSpaceID s = dHashSpaceCreate(nullptr);
    const dHeightfieldDataID h = dGeomHeightfieldDataCreate();
    const dTriMeshDataID m = dGeomTriMeshDataCreate();
    const dFluidID f = dFluidCreate(world);
    const dThreadingImplementationID t = dThreadingAllocateSelfThreadedImplementation();
    const dCooperativeID c = dCooperativeCreate(nullptr, nullptr);
    const dResourceRequirementsID r = dResourceRequirementsCreate(c);
    const dResourceContainerID k = dResourceContainerAcquire(r);
    dead = {w, b, j, g, geom, s, h, f, t, g, c, r, k, m};
    dResourceContainerDestroy(k);
    dResourceRequirementsDestroy(r);
    dCooperativeDestroy(c);
    dThreadingFreeImplementation(t);
    dWorldDestroy(w);
    dBodyDestroy(b);
    dJointDestroy(j);
    dJointGroupDestroy(g);
    dGeomDestroy(geom);
    dSpaceDestroy(s);
    dGeomHeightfieldDataDestroy(h);
    dGeomTriMeshDataDestroy(m);
    dFluidDestroy(f);
}

void Scene::build()
{
    for (auto& list : live) list.clear();
    world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    add(Kind::kWorld, world);
    build_bodies();
    build_joints();
    build_geoms();
    build_heights();
    build_meshes();
    build_contacts();
    build_foreign();
    build_threading();
    kill_one_of_each();
}

// Groups before worlds, spaces before geoms; what a call has destroyed already is refused again. What it has
// made beyond the scene is found in the worlds and spaces that it was put into, or by the caller.
void Scene::tear_down()
{
    g_hooks = {};
    for (void* g : live[int(Kind::kGroup)]) dJointGroupDestroy(static_cast<dJointGroupID>(g));
    for (void* w : live[int(Kind::kWorld)]) dWorldDestroy(static_cast<dWorldID>(w));
    for (void* s : live[int(Kind::kSpace)]) {
        dSpaceSetCleanup(static_cast<dSpaceID>(s), 1);
        dSpaceDestroy(static_cast<dSpaceID>(s));
    }
    for (void* g : live[int(Kind::kGeom)]) dGeomDestroy(static_cast<dGeomID>(g));
    for (void* h : live[int(Kind::kHeightfieldData)])
        dGeomHeightfieldDataDestroy(static_cast<dHeightfieldDataID>(h));
    for (void* m : live[int(Kind::kTriMeshData)]) dGeomTriMeshDataDestroy(static_cast<dTriMeshDataID>(m));
    tear_down_threading();
}

}  // namespace hostile
