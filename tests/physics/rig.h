// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the physics tests are written with: vectors in double whatever dReal is, a world with a space that
// collides and steps in one call, bodies in one call, momentum and energy, a counter of messages.
// Black box: only the public headers. Tolerances are given as a pair, one for each precision of dReal.
#pragma once

#include <gtest/gtest.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace epode::physics {

inline constexpr bool kSingle = sizeof(dReal) == 4;
inline constexpr double kEpsilon = kSingle ? 1.1920929e-7 : 2.220446049250313e-16;
inline constexpr double kPi = 3.14159265358979323846;
// A tolerance: in double precision, in single precision.
constexpr double tol(double in_double, double in_single) { return kSingle ? in_single : in_double; }
constexpr dReal real(double x) { return dReal(x); }

struct V3 {
    double x = 0, y = 0, z = 0;
};
inline V3 vec(const dReal* p) { return {double(p[0]), double(p[1]), double(p[2])}; }
inline V3 operator+(V3 a, V3 b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline V3 operator-(V3 a, V3 b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline V3 operator*(double s, V3 a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(V3 a, V3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline V3 cross(V3 a, V3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }
inline double length(V3 a) { return std::sqrt(dot(a, a)); }

// The same numbers on every machine: x' = 1664525 x + 1013904223 mod 2^32, high bits used.
class Random {
  public:
    explicit Random(std::uint32_t seed) : state_(seed * 2654435761u + 1u) {}
    double uniform(double low, double high);
    V3 point(double size);
    void quaternion(dQuaternion q);

  private:
    std::uint32_t state_;
};

enum class Stepper { kExact, kQuick, kFast };
inline constexpr Stepper kSteppers[] = {Stepper::kExact, Stepper::kQuick, Stepper::kFast};
const char* name_of(Stepper stepper);
// Names the instances of a suite that runs once per stepper.
inline std::string case_name(const testing::TestParamInfo<Stepper>& info) { return name_of(info.param); }

// A world and its space. Every pair that touches gets up to eight contacts with `surface`, unless a joint
// other than a contact connects the two bodies.
class Sim {
  public:
    explicit Sim(Stepper stepper = Stepper::kExact);
    ~Sim();
    Sim(const Sim&) = delete;
    Sim& operator=(const Sim&) = delete;

    void gravity(double x, double y, double z) { dWorldSetGravity(world, real(x), real(y), real(z)); }
    // A ball's mass is spread evenly; `inertia` 0 leaves that of its shape.
    dBodyID body(V3 at, double mass = 1, double inertia = 1);
    dBodyID box(V3 at, V3 size, double mass);
    dBodyID sphere(V3 at, double radius, double mass);
    dBodyID capsule(V3 at, double radius, double length, double mass);
    dBodyID cylinder(V3 at, double radius, double length, double mass);
    dGeomID ground(double height = 0);
    // Without collision, with the stepper of this Sim.
    int advance(double h);
    // Contacts of the last step go, new ones are found, the world is stepped.
    int step(double h);
    void steps(int count, double h);
    void collide();
    dWorldStepReport report() const;

    Stepper stepper;
    int substeps = 10;  // of dWorldStepFast1
    dWorldID world;
    dSpaceID space;
    dJointGroupID contacts;
    dSurfaceParameters surface{};
    int contact_count = 0;
    std::vector<dBodyID> bodies;

  private:
    static void near(void* self, dGeomID a, dGeomID b);
    dBodyID shaped(V3 at, dGeomID geom, const dMass& mass);
};

void place(dBodyID body, V3 at);
void velocity(dBodyID body, V3 linear, V3 angular = {});
inline V3 position(dBodyID b) { return vec(dBodyGetPosition(b)); }
inline V3 velocity(dBodyID b) { return vec(dBodyGetLinearVel(b)); }
inline V3 spin(dBodyID b) { return vec(dBodyGetAngularVel(b)); }
// I w in world axes.
V3 spin_momentum(dBodyID body);
double kinetic_energy(dBodyID body);

V3 momentum(const Sim& sim);
V3 angular_momentum(const Sim& sim);  // about the origin
double energy(const Sim& sim);        // kinetic, and potential in the world's gravity

// A contact made by hand: at `at`, normal `n` into body 1, depth, between a body and the world or a second
// body.
dContact make_contact(V3 at, V3 n, double depth);

// FNV-1a over the bits of all positions, orientations and velocities.
std::uint64_t hash_state(const Sim& sim);
std::uint64_t hash_reals(const dReal* values, int count, std::uint64_t seed);
// All of them finite?
bool finite_state(const Sim& sim);

// Counts what is said on the message, debug and error channels while it lives.
class Messages {
  public:
    Messages();
    ~Messages();
    Messages(const Messages&) = delete;
    Messages& operator=(const Messages&) = delete;
    int count() const;
    std::string last() const;
    void clear();
};

}  // namespace epode::physics
