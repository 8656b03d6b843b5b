/* SPDX-License-Identifier: BSD-3-Clause */
/* Copyright (c) 2026 The Epode authors
 *
 * What a random sequence does in more than one call. Plain C: the text of this file stands at the head of
 * every program that a failed sequence is written down as, so that the program needs nothing else. */
#include <ode/ext.h>
#include <ode/ode.h>
#include <string.h>

#ifdef __cplusplus
#define TOOL inline
#else
#define TOOL static
#endif

enum { kMaxMade = 16, kMaxFeedback = 64 };
TOOL dJointID made[kMaxMade]; /* by the last call of meet() */
TOOL int made_count;
TOOL dJointFeedback feedback[kMaxFeedback];
TOOL const double kHeights[16] = {0, 0.3, 0.1, 0, 0.2, 0.5, 0.4, 0.1, 0, 0.6, 0.2, 0.3, 0.1, 0, 0.2, 0};

/* Contacts of two geoms become joints between their bodies, where these belong to `w`. */
TOOL void meet(dWorldID w, dJointGroupID group, dGeomID a, dGeomID b, int capacity, int mode)
{
    dContact contact[kMaxMade];
    dBodyID b1 = dGeomGetBody(a), b2 = dGeomGetBody(b);
    int i, n = dCollide(a, b, capacity < kMaxMade ? capacity : (int)kMaxMade, &contact[0].geom,
                        sizeof contact[0]);
    made_count = 0;
    if ((b1 && dBodyGetWorld(b1) != w) || (b2 && dBodyGetWorld(b2) != w) || b1 == b2) return;
    for (i = 0; i < n; ++i) {
        memset(&contact[i].surface, 0, sizeof contact[i].surface);
        contact[i].surface.mode = mode;
        contact[i].surface.mu = (dReal)0.5;
        contact[i].surface.bounce = (dReal)0.3;
        contact[i].surface.soft_erp = (dReal)0.5;
        contact[i].surface.soft_cfm = (dReal)1e-4;
        made[made_count] = dJointCreateContact(w, group, &contact[i]);
        if (!made[made_count]) return;
        dJointAttach(made[made_count], b1, b2);
        ++made_count;
    }
}

TOOL void set_mass(dBodyID body, dReal density, dReal x, dReal y, dReal z)
{
    dMass m;
    dMassSetBox(&m, density, x, y, z);
    dBodySetMass(body, &m);
}

TOOL void build_heights(dHeightfieldDataID data, int copy, dReal width, int wrap)
{
    dGeomHeightfieldDataBuildDouble(data, kHeights, copy, width, width, 4, 4, 1, 0, 1, wrap);
}

/* A roof of three by three corners, a tetrahedron, and what no mesh should be: flat, doubled, torn. */
enum { kMeshes = 3, kCorners = 9 };
TOOL dReal corners[kMeshes][kCorners][3] = {
    {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1, 0}, {1, 1, 1}, {2, 1, 0}, {0, 2, 0}, {1, 2, 0}, {2, 2, 0}},
    {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
    {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}, {0, 1, 0}, {2, 2, 2}}};
TOOL const dTriIndex triangles[kMeshes][8][3] = {
    {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}, {3, 4, 7}, {3, 7, 6}, {4, 5, 8}, {4, 8, 7}},
    {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}},
    {{0, 1, 3}, {0, 1, 2}, {3, 1, 0}, {0, 0, 0}, {0, 2, 4}}};

TOOL void build_mesh(dTriMeshDataID data, int which)
{
    static const int vertex_count[kMeshes] = {9, 4, 5}, triangle_count[kMeshes] = {8, 4, 5};
    if (sizeof(dReal) == sizeof(double))
        dGeomTriMeshDataBuildDouble(data, corners[which], sizeof corners[0][0], vertex_count[which],
                                    triangles[which], 3 * triangle_count[which], sizeof triangles[0][0]);
    else
        dGeomTriMeshDataBuildSingle(data, corners[which], sizeof corners[0][0], vertex_count[which],
                                    triangles[which], 3 * triangle_count[which], sizeof triangles[0][0]);
}

/* Moves a corner of all meshes that were built of this shape; each shows it at its next update. */
TOOL void move_corner(int which, int corner, double x, double y, double z)
{
    corners[which][corner][0] = (dReal)x;
    corners[which][corner][1] = (dReal)y;
    corners[which][corner][2] = (dReal)z;
}

/* A wedge, as the faces of a convex geom or by its points alone. */
TOOL const dReal kWedge[6][3] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {0, 1, 1}};
TOOL const dReal kWedgePlanes[5][4] = {
    {0, 0, -1, 0},
    {-1, 0, 0, 0},
    {0, -1, 0, 0},
    {0, 1, 0, 1},
    {(dReal)0.70710678118654752, 0, (dReal)0.70710678118654752, (dReal)0.70710678118654752}};
TOOL const unsigned kWedgeFaces[] = {4, 0, 3, 2, 1, 4, 0, 4, 5, 3, 3, 0, 1, 4, 3, 2, 3, 5, 4, 1, 2, 5, 4};

TOOL dGeomID create_wedge(dSpaceID space)
{
    return dCreateConvex(space, kWedgePlanes[0], 5, kWedge[0], 6, kWedgeFaces);
}

TOOL dGeomID create_hull(dSpaceID space, int points)
{
    return dCreateConvexHull(space, kWedge[0], (unsigned)points, 0);
}

TOOL void set_hull(dGeomID convex, int points) { dGeomSetConvexHull(convex, kWedge[0], (unsigned)points, 0); }

TOOL void watch(dJointID joint, int index) { dJointSetFeedback(joint, index < 0 ? 0 : &feedback[index]); }

/* ---- states ---- */

enum { kStates = 4, kStateBytes = 1 << 20 };
TOOL unsigned char kept[kStates][kStateBytes], scratch[3][kStateBytes];
TOOL size_t kept_size[kStates];

TOOL size_t write_state(dWorldID w, unsigned char* to)
{
    size_t size = dWorldGetStateSize(w);
    return size <= kStateBytes && dWorldGetState(w, to, kStateBytes) ? size : 0;
}

TOOL void keep_state(dWorldID w, int slot) { kept_size[slot] = write_state(w, kept[slot]); }

/* 1: taken, and the world has it; 0: refused; -1: taken, and the world has another one. */
TOOL int use_state(dWorldID w, int slot)
{
    if (!dWorldSetState(w, kept[slot], kept_size[slot])) return 0;
    return write_state(w, scratch[0]) == kept_size[slot] && !memcmp(scratch[0], kept[slot], kept_size[slot])
               ? 1
               : -1;
}

/* The world's state as what has changed since a kept one: the world stays as it is. -1: it does not. */
TOOL int go_by_delta(dWorldID w, int slot)
{
    size_t before = write_state(w, scratch[0]);
    size_t delta = dWorldGetStateDelta(w, kept[slot], kept_size[slot], scratch[1], kStateBytes);
    if (!before || !delta || delta > kStateBytes) return 0;
    if (!dWorldSetStateDelta(w, kept[slot], kept_size[slot], scratch[1], delta)) return -1;
    return write_state(w, scratch[2]) == before && !memcmp(scratch[0], scratch[2], before) ? 1 : -1;
}

TOOL int step_by(dWorldID w, int how, dReal h)
{
    switch (how) {
        case 0:
            return dWorldStep(w, h);
        case 1:
            return dWorldQuickStep(w, h);
        case 2:
            return dWorldStepFast1(w, h, 3);
        default:
            return dWorldStepHybrid(w, h);
    }
}

/* Steps that are taken back leave nothing. -1: they do. */
TOOL int take_back(dWorldID w, int how, dReal h, int steps)
{
    size_t before = write_state(w, scratch[0]);
    int i, good = 1;
    if (!before || !dWorldSetHistory(w, steps)) return 0;
    for (i = 0; i < steps; ++i) good = good && step_by(w, how, h);
    if (good && dWorldRollBack(w, steps))
        good = write_state(w, scratch[1]) == before && !memcmp(scratch[0], scratch[1], before) ? 1 : -1;
    dWorldSetHistory(w, 0);
    return good;
}

/* ---- copies ---- */

enum { kMostData = 64 };
TOOL void* data_of[2][kMostData]; /* meshes and height fields of a loaded world */
TOOL int data_count[2];

TOOL void remember_data(int kind, void* data)
{
    int i;
    for (i = 0; i < data_count[kind]; ++i)
        if (data_of[kind][i] == data) return;
    if (data && data_count[kind] < kMostData) data_of[kind][data_count[kind]++] = data;
}

TOOL void destroy_tree(dGeomID geom)
{
    dGeomID inner = 0;
    if (dGeomIsSpace(geom))
        while (dSpaceGetNumGeoms((dSpaceID)geom) > 0) destroy_tree(dSpaceGetGeom((dSpaceID)geom, 0));
    else if (dGeomGetClass(geom) == dTriMeshClass)
        remember_data(0, dGeomTriMeshGetData(geom));
    else if (dGeomGetClass(geom) == dHeightfieldClass)
        remember_data(1, dGeomHeightfieldGetHeightfieldData(geom));
    else if (dGeomGetClass(geom) == dGeomTransformClass) {
        inner = dGeomTransformGetGeom(geom);
        dGeomTransformSetCleanup(geom, 0);
    }
    dGeomDestroy(geom);
    if (inner) destroy_tree(inner);
}

TOOL void destroy_copy(dWorldID w, dSpaceID space, int owns_data)
{
    enum { kMostBodies = 256 };
    dBodyID bodies[kMostBodies];
    int i, n = dWorldGetBodies(w, bodies, kMostBodies);
    data_count[0] = data_count[1] = 0;
    if (space) destroy_tree((dGeomID)space);
    for (i = 0; i < n && i < kMostBodies; ++i)
        while (dBodyGetFirstGeom(bodies[i])) destroy_tree(dBodyGetFirstGeom(bodies[i]));
    dWorldDestroy(w);
    for (i = 0; owns_data && i < data_count[0]; ++i) dGeomTriMeshDataDestroy((dTriMeshDataID)data_of[0][i]);
    for (i = 0; owns_data && i < data_count[1]; ++i)
        dGeomHeightfieldDataDestroy((dHeightfieldDataID)data_of[1][i]);
}

/* A copy of the world by a clone or a file goes on as the world would. -1: what was saved cannot be loaded; -2: it has another state. */
TOOL int step_copy(dWorldID w, dSpaceID space, int by_file, int how, dReal h)
{
    dSpaceID its = space;
    dWorldID copy;
    size_t size = 0, state;
    int good = 1;
    if (by_file) {
        size = dWorldSaveToBuffer(w, space, scratch[0], kStateBytes);
        if (!size || size > kStateBytes) return 0;
        copy = dWorldLoadFromBuffer(scratch[0], size, &its);
        if (!copy) return -1;
    } else {
        copy = dWorldClone(w, &its, 0, 0);
        if (!copy) return 0;
    }
    state = write_state(w, scratch[1]);
    if (write_state(copy, scratch[2]) != state || memcmp(scratch[1], scratch[2], state)) good = -2;
    step_by(copy, how, h);
    destroy_copy(copy, its, by_file);
    return good;
}

/* ---- what joints, geoms and worlds have beyond ODE's ---- */

TOOL int drive(dJointID joint, int axis, dReal stiffness, dReal damping, dReal target, dReal limit)
{
    dDrive its;
    dDriveInit(&its, sizeof its);
    its.stiffness = stiffness, its.damping = damping, its.target = target, its.force_limit = limit;
    its.armature = damping / 10, its.friction = target > 0 ? target : 0;
    return dJointSetDrive(joint, axis, stiffness > 0 ? &its : 0);
}

TOOL int list_events(dWorldID w, int kinds)
{
    dEventSettings its;
    dEventSettingsInit(&its, sizeof its);
    its.kinds = (unsigned)kinds, its.capacity = 16;
    return dWorldSetEventSettings(w, kinds ? &its : 0);
}

TOOL void read_lists(dWorldID w)
{
    dEvent events[8];
    dContactEvent pairs[8];
    dWorldContact contacts[8];
    dJointID broken[8];
    dWorldGetEvents(w, events, 8);
    dWorldGetContactEvents(w, pairs, 8);
    dWorldGetContacts(w, contacts, 8);
    dWorldGetBrokenJoints(w, broken, 8);
}

TOOL int coat(dGeomID geom, dReal friction, dReal bounce, dReal compliance)
{
    dMaterial its;
    dMaterialInit(&its, sizeof its);
    its.friction = friction, its.bounce = bounce, its.compliance = compliance, its.damping_time = compliance;
    return dGeomSetMaterial(geom, &its);
}

TOOL int choosy(void* data, dGeomID a, dGeomID b)
{
    return data == 0 && (dGeomGetClass(a) + dGeomGetClass(b)) % 3 != 0;
}

TOOL void filter_contacts(dWorldID w, int on) { dWorldSetContactFilter(w, on ? choosy : 0, 0); }

/* Asks what lies along a line, near a geom or in the way of one. Below 0: the answer is no number. */
TOOL int ask(dSpaceID space, dGeomID geom, dGeomID other, int what, dReal x, dReal y, dReal z)
{
    dVector3 from = {0, 0, 3, 0}, way;
    dReal lengths[2] = {5, 50}, starts[6] = {0, 0, 3, 1, 1, 1}, ways[6];
    dQueryHit hits[8];
    dQueryDistance near_by;
    dGeomID geoms[8];
    int i, n = 0;
    way[0] = x, way[1] = y, way[2] = z, way[3] = 0;
    for (i = 0; i < 6; ++i) ways[i] = way[i % 3];
    switch (what) {
        case 0:
            n = dSpaceRayClosest(space, from, way, 20, 0, hits);
            break;
        case 1:
            n = dSpaceRayAll(space, from, way, 20, 0, hits, 8);
            break;
        case 2:
            dSpaceRayBatch(space, 2, starts, ways, lengths, 0, hits, 2);
            break;
        case 3:
            dSpaceOverlap(space, geom, 0, geoms, 8);
            break;
        case 4:
            return dGeomGetDistance(geom, other, 10, &near_by) && near_by.distance != near_by.distance ? -4
                                                                                                       : 1;
        case 5:
            n = dGeomCast(geom, way, other, hits);
            break;
        default:
            n = dSpaceCast(space, geom, way, 0, hits);
            break;
    }
    for (i = 0; i < n && i < 8; ++i)
        if (hits[i].geom && !(hits[i].distance >= 0 && hits[i].distance < 1e9)) return -1 - what;
    return 1;
}

/* ---- impulses, fluids, vehicles, characters, manifolds ---- */

TOOL void strike(dBodyID body, int how, dReal x, dReal y, dReal z)
{
    dVector3 v, at;
    v[0] = x, v[1] = y, v[2] = z, v[3] = 0;
    memcpy(at, dBodyGetPosition(body), sizeof at);
    at[0] += (dReal)0.1;
    switch (how) {
        case 0:
            dBodyApplyImpulse(body, v, at);
            break;
        case 1:
            dBodyApplyAngularImpulse(body, v);
            break;
        case 2:
            dBodyApplyForce(body, v, at);
            break;
        case 3:
            dBodyApplyTorque(body, v);
            break;
        default:
            dBodySetVelocities(body, v, v, how % 2);
            break;
    }
}

TOOL void blast(dSpaceID space, dReal x, dReal y, dReal impulse, int falloff, int occlusion)
{
    dVector3 centre = {0, 0, 0, 0};
    centre[0] = x, centre[1] = y;
    dSpaceApplyRadialImpulse(space, centre, 2, impulse, falloff, occlusion, 0);
}

TOOL dReal waves(void* data, const dVector3 pos, dReal time)
{
    dReal x = pos[0] + pos[1] / 2 + time;
    (void)data;
    return (x - (int)x) / 10;
}

/* A fluid more, one that another is made of, or one less. */
TOOL void pour(dWorldID w, int how, dReal height, dGeomID volume)
{
    dFluidSettings its;
    dFluidID fluid = dWorldGetFluid(w, 0);
    if (!fluid || (how == 0 && dWorldGetNumFluids(w) < 3)) fluid = dFluidCreate(w);
    if (how == 1) dFluidDestroy(fluid);
    if (how == 1) return;
    dFluidSettingsInit(&its, sizeof its);
    its.density = 500 + 500 * height, its.current[0] = height;
    if (how == 2) dFluidSetSettings(fluid, &its);
    if (how == 3) dFluidSetSurface(fluid, height > 0 ? waves : 0, 0);
    if (how == 4) dFluidSetVolume(fluid, volume);
    dFluidSetPlane(fluid, 0, height / 10, 1, height);
}

/* The body becomes a vehicle, gets wheels, is driven. */
TOOL void drive_vehicle(dBodyID body, int how, dReal throttle, dReal steer, dReal h)
{
    dVehicleControls its = {sizeof its, 0, 0, 0, 0, 0};
    dVehicleWheel wheel;
    if (!dBodyIsVehicle(body)) dVehicleCreate(body, 0);
    if (!dBodyIsVehicle(body)) return;
    if (how == 0 && dVehicleGetNumWheels(body) < 6) {
        dVehicleWheelInit(&wheel, sizeof wheel);
        wheel.cast = 1 + dVehicleGetNumWheels(body) % 3;
        dVehicleAddWheel(body, &wheel);
    }
    if (how == 1) dVehicleSetGear(body, (int)(3 * steer));
    its.throttle = throttle < 0 ? 0 : throttle, its.brake = throttle < 0 ? -throttle : 0, its.steer = steer;
    dVehicleSetControls(body, &its);
    dVehicleUpdate(body, h);
}

/* A character walks through the space, and is gone. */
TOOL int stroll(dSpaceID space, dReal x, dReal y, dReal h, int shape)
{
    static const int kinds[3] = {dCapsuleClass, dCylinderClass, dBoxClass};
    dCharacterSettings its;
    dVector3 velocity, feet;
    dGeomID character;
    int i, good;
    dCharacterSettingsInit(&its, sizeof its);
    its.shape = kinds[shape % 3];
    character = dCharacterCreate(space, &its);
    if (!character) return 0;
    dCharacterSetPosition(character, 2 * x, 2 * y, 1);
    velocity[0] = x, velocity[1] = y, velocity[2] = 0, velocity[3] = 0;
    for (i = 0; i < 3; ++i) dCharacterWalk(character, velocity, i == 1 ? (dReal)3 : 0, h);
    good = dCharacterGetPosition(character, feet) && feet[0] == feet[0] && feet[2] == feet[2] ? 1 : -1;
    dGeomDestroy(character);
    return good;
}

TOOL void look_at_manifold(void* data, dManifold* its)
{
    (void)data;
    if (its->count == 1) its->friction = 0;
    if (its->count == 3) its->accept = 0;
    its->bounce = (dReal)0.5, its->surface_velocity[0] = (dReal)0.1;
}

TOOL void look_at_manifolds(dWorldID w, int on, int threads)
{
    dWorldSetManifoldFunction(w, on ? look_at_manifold : 0, 0, threads);
}

/* Several worlds at once. */
TOOL dWorldID chosen[3];
TOOL void choose(int i, dWorldID w) { chosen[i] = w; }
TOOL int step_chosen(int count, dReal h, int stepper, int steps, int threads)
{
    return dWorldsStep(chosen, count, h, stepper, 4, steps, threads, 0);
}
