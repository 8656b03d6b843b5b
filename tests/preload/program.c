/* SPDX-License-Identifier: BSD-3-Clause
   Copyright (c) 2026 The Epode authors

   A program that knows nothing of being recorded. It makes and destroys bodies, geoms and joints between steps, in two
   worlds, and prints after each step of the first the hash of its states, by the definition in docs/recording.md: what
   the recording must say too. With the name of a signal it ends by that. */
#include <ode/ode.h>
#include <signal.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>

enum { kBodies = 6 };
static dWorldID world, other_world;
static dSpaceID space;
static dJointGroupID contacts;
static dBodyID body[kBodies + 1];
static int count = kBodies;

static uint64_t mix(uint64_t hash, const dReal* values, int n)
{
    for (int i = 0; i < n; ++i) {
        const double wide = (double)values[i];
        uint64_t word;
        memcpy(&word, &wide, sizeof word);
        hash = (hash ^ word) * 1099511628211ull;
        hash ^= hash >> 32;
    }
    return hash;
}

static void print_hash(int step)
{
    uint64_t hash = 14695981039346656037ull;
    for (int i = 0; i < count; ++i) {
        hash = mix(hash, dBodyGetPosition(body[i]), 3);
        hash = mix(hash, dBodyGetQuaternion(body[i]), 4);
        hash = mix(hash, dBodyGetLinearVel(body[i]), 3);
        hash = mix(hash, dBodyGetAngularVel(body[i]), 3);
    }
    printf("%d %016llx\n", step, (unsigned long long)hash);
}

static void near_callback(void* data, dGeomID a, dGeomID b)
{
    dContact contact[4];
    (void)data;
    memset(contact, 0, sizeof contact);
    const int n = dCollide(a, b, 4, &contact[0].geom, sizeof(dContact));
    for (int i = 0; i < n; ++i) {
        contact[i].surface.mu = (dReal)0.5;
        dJointAttach(dJointCreateContact(world, contacts, &contact[i]), dGeomGetBody(a), dGeomGetBody(b));
    }
}

static dBodyID box_at(dReal x, dReal z)
{
    dBodyID made = dBodyCreate(world);
    dMass mass;
    dMassSetBox(&mass, 1, 1, 1, 1);
    dBodySetMass(made, &mass);
    dBodySetPosition(made, x, 0, z);
    dGeomSetBody(dCreateBox(space, 1, 1, 1), made);
    return made;
}

static void step(int i)
{
    dSpaceCollide(space, 0, near_callback);
    if (i % 2) {
        dWorldStep(world, (dReal)0.01);
    } else {
        dWorldQuickStep(world, (dReal)0.01);
    }
    dJointGroupEmpty(contacts);
    print_hash(i);
}

/* Ends the program as Ctrl+C (INT), kill (TERM) or a crash (KILL) would. */
static void end_by(const char* name)
{
    int number = strcmp(name, "INT") == 0 ? SIGINT : strcmp(name, "TERM") == 0 ? SIGTERM : SIGKILL;
    signal(number, SIG_DFL);
    raise(number);
}

int main(int argc, char** argv)
{
    dInitODE2(0);
    world = dWorldCreate();
    other_world = dWorldCreate();
    space = dHashSpaceCreate(0);
    contacts = dJointGroupCreate(0);
    dWorldSetGravity(world, 0, 0, (dReal)-9.81);
    dCreatePlane(space, 0, 0, 1, 0);
    for (int i = 0; i < kBodies; ++i) body[i] = box_at((dReal)0.3 * i, (dReal)(1 + 1.1 * i));
    dJointID hinge = dJointCreateHinge(world, 0);
    dJointAttach(hinge, body[0], body[1]);
    dJointSetHingeAnchor(hinge, 0, 0, 1);
    dBodyID alone = dBodyCreate(other_world);
    dBodySetLinearVel(alone, 1, 0, 0);
    print_hash(0);
    for (int i = 1; i <= 20; ++i) step(i);

    dJointDestroy(hinge);
    dGeomDestroy(dBodyGetFirstGeom(body[2]));
    dBodyDestroy(body[2]);
    memmove(&body[2], &body[3], sizeof(dBodyID) * (kBodies - 3));
    body[kBodies - 1] = box_at(4, 3);
    for (int i = 21; i <= 40; ++i) step(i);

    dGeomID wall = dCreateSphere(space, 1);
    dGeomSetPosition(wall, 0, 0, (dReal)0.2);
    for (int i = 41; i <= 60; ++i) {
        step(i);
        dWorldStep(other_world, (dReal)0.02);
        dGeomSetPosition(wall, (dReal)(0.01 * i), 0, (dReal)0.2);
    }
    if (argc > 1) end_by(argv[1]);
    dJointGroupDestroy(contacts);
    dSpaceDestroy(space);
    dWorldDestroy(other_world);
    dWorldDestroy(world);
    dCloseODE();
    return 0;
}
