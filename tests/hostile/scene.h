// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The world in which hostile calls are made: bodies of every sort, every type of joint twice (between two
// bodies; and against the world, turned round, or attached to nothing), every class of geom, spaces in a
// space, contacts, heights from an array and from a function. Next to it a second world, and of each kind of
// object one that has been destroyed. Built again whenever a call has changed something.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "table.h"

namespace hostile {

inline constexpr int kHandleKinds = int(Kind::kTriMeshData) + 1;
inline bool is_handle(Kind kind) { return int(kind) < kHandleKinds; }

// Functions of the program that behave.
void near_nothing(void*, dGeomID, dGeomID);
dReal flat_height(void*, int, int);
void same_manifold(void*, dManifold*);
dReal flat_sea(void*, const dVector3, dReal);
void no_current(void*, const dVector3, dReal, dVector3);
int no_contacts(dGeomID, dGeomID, int, dContactGeom*, int);
void moved_nothing(dBodyID);
int any_triangle(dGeomID, dGeomID, int);
int any_pair(void*, dGeomID, dGeomID);
void any_triangles(dGeomID, dGeomID, const int*, int);
int any_hit(dGeomID, dGeomID, int, dReal, dReal);
int first_triangle(dGeomID, int, int);
// Functions of the user class; the hooks let a test act inside them (phases.cpp).
extern const dGeomClass kUserClass;

// A convex solid as dCreateConvex takes it, with room for eight corners a face.
struct Solid {
    std::array<dReal, 24> planes, points;
    std::array<unsigned, 54> faces;
};
extern const Solid kCube;

// A tetrahedron as the functions dGeomTriMeshDataBuild... take it, four numbers a vertex.
struct Mesh {
    std::array<double, 16> vertices;
    std::array<unsigned, 16> corners;
};
extern const Mesh kTetrahedron;

// Called once, where it is set, from inside a function of the program that the library calls.
struct Hook {
    void (*function)(void*) = nullptr;
    void* context = nullptr;
    void run()
    {
        if (!function) return;
        void (*const once)(void*) = function;
        function = nullptr;
        once(context);
    }
};
struct Hooks {
    Hook near, moved, box, box_test, collider, height, mesh, end, contact_filter, query_filter, message,
        override_collider, step_memory, threading, fluid, manifold, character_filter;
};
extern Hooks g_hooks;

struct Scene {
    Scene() = default;
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    void build();
    bool with_threads = false;  // a thread takes longer to make than all the rest
    void tear_down();           // whatever has been done to it

    // Live objects by kind, and the destroyed one of each.
    std::array<std::vector<void*>, kHandleKinds> live;
    std::array<void*, kHandleKinds> dead{};

    dWorldID world = nullptr;
    dSpaceID space = nullptr;
    dGeomID user_geom = nullptr, tested_geom = nullptr, high_ground = nullptr, mesh = nullptr,
            probe = nullptr;
    dBodyID first_body = nullptr;
    dJointGroupID contacts = nullptr;

  private:
    void build_bodies();
    void build_joints();
    void build_geoms();
    void build_heights();
    void build_meshes();
    void build_contacts();
    void build_foreign();
    void build_threading();
    void tear_down_threading();
    void kill_one_of_each();
    void add(Kind kind, void* handle) { live[std::size_t(kind)].push_back(handle); }
};

// Puts what belongs to the process back: handlers; and, while no scene stands, since the last dCloseODE makes
// an end of handles that have been destroyed, classes, overrides and the count of dInitODE.
void restore_handlers();
void reset_process();

// Memory that the library holds now, in blocks: it goes through handlers of this test.
long blocks_held();
// The count is what it was: what came and went in between did so by two kinds of handlers.
void forget_blocks(long held);

// What the library has said since the last `take`.
struct Messages {
    int refusals = 0;     // through the debug handler
    bool odd = false;     // not with d_ERR_UASSERT
    char text[240] = {};  // of the last one
};
Messages& messages();

}  // namespace hostile
