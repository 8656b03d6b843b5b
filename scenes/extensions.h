// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What Epode's library has beyond ODE's, found at run time: a program built with this runs on any libode.so.8
// and says what is missing. dlsym rather than weak symbols: a weak reference is settled when the program is
// linked, and then it no longer starts on the other library.
#pragma once

#include <ode/ode.h>

#include <optional>
#include <string>
#include <vector>

namespace epode::scenes {

struct StepReport {
    double residual =
        0;  // worst error of the step's complementarity problem over its islands, 0: solved exactly
    int islands = 0, bodies = 0, joints = 0, rows = 0;
    int iterations = 0, fallbacks = 0, contained_islands = 0;
};

// Water below z = 0; false where the library has none.
bool add_water(dWorldID world);

bool has_step_fast();
// dWorldStepFast1; 0 where the library has none.
int step_fast(dWorldID world, dReal dt, int substeps);
bool has_step_hybrid();
// dWorldStepHybrid; 0 where the library has none.
int step_hybrid(dWorldID world, dReal dt, int substeps);

// World-managed contacts (ode/contacts.h).
struct WorldContact {
    dGeomID geom1, geom2;
    double pos[3], normal[3];  // the normal points into geom1
    double depth;              // at the step's beginning; below 0: still apart then
    double normal_force;       // along the normal, N
    double friction_force[3];  // on geom1, N
};
bool has_world_contacts();
void set_contact_space(dWorldID world, dSpaceID space);
// Friction and bounce of contact joints with that surface, as a material.
void set_material(dGeomID geom, const dSurfaceParameters& surface);
std::vector<WorldContact> world_contacts(dWorldID world);

// Shapes beyond ODE's, with the mass of water; 0 where the library has none.
dGeomID create_cone(dSpaceID space, double radius, double length, dMass& mass);
dGeomID create_ellipsoid(dSpaceID space, double rx, double ry, double rz, dMass& mass);
dGeomID create_tapered_capsule(dSpaceID space, double r1, double r2, double length, dMass& mass);

// The surface of a convex geom in its frame, 9 reals a triangle; none where the library does not tell.
std::vector<dReal> triangles_of(dGeomID geom);

// Residuals cost time, so a world reports only when asked to. False where the library cannot.
bool request_step_report(dWorldID world, bool on);
std::optional<StepReport> step_report(dWorldID world);

// Whether steps look for what makes simulations fail. False where the library cannot.
bool set_diagnosis(dWorldID world, bool on);
// What they have found, the most severe first, at most so many.
struct Accusation {
    int severity;  // 0: a note, 1: a warning, 2: an error
    dBodyID body, other;
    std::string text;
};
std::vector<Accusation> diagnosis(dWorldID world, std::size_t max_count);

// How much of the last step's forces a step starts from, 0 ... 1. False where the library always starts cold.
bool set_warm_starting(dWorldID world, double factor);

// How often joints are closed after each step, at most; 0: never. False where the library cannot.
bool set_step_projection(dWorldID world, int iterations);

// How dWorldStep turns bodies, and into how many parts it divides its step. False where the library cannot.
bool set_exact_rotation(dWorldID world, bool on);
bool set_exact_substeps(dWorldID world, int parts);

// How many threads a world's steps use. False where the library cannot.
bool has_step_threads();
bool set_step_threads(dWorldID world, int threads);

// Worlds in files (ode/world_file.h). False or null after a message of the library.
bool has_world_files();
bool save_world(dWorldID world, dSpaceID space, const std::string& path);
dWorldID load_world(const std::string& path, dSpaceID& space);
dSpaceID contact_space(dWorldID world);  // null: none
std::vector<dBodyID> bodies_of(dWorldID world);
int joint_count(dWorldID world);

// The file of the libode that this process runs on, "statically linked" when there is none.
std::string loaded_library();
// Whose it is: "Epode", or "ODE" for the original.
const char* loaded_library_kind();

}  // namespace epode::scenes
