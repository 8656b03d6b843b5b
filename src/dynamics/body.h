// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The body that the user holds. Its first block is visible through the ABI: clients keep the pointers that
// dBodyGetPosition and its sisters return, so the address and ODE's padded layout never change. Solvers work
// on their own copy (rows/row_system.h).
//
//   x' = v,  m v' = f;   I w' = t - w x I w, I = R I_body R^T;   q' = 1/2 (0, w) q
#pragma once

#include "base/array.h"
#include "base/objects/handle.h"
#include "math/pose.h"
#include "ode/mass.h"
#include "ode/objects.h"

namespace epode {

struct World;
struct Joint;
struct JointNode;
struct ManifoldEdge;
struct Vehicle;
struct Body;

// When a body may fall asleep; thresholds are kept squared, as they are compared.
struct SleepRule {
    Real linear_threshold2 = Real(0.01) * Real(0.01);
    Real angular_threshold2 = Real(0.01) * Real(0.01);
    int steps = 10;
    Real time = 0;
    int samples = 1;
};

// Where a body was when a window of time began, and whether it stayed nearby for the whole window before.
struct Stillness {
    Vec3 position;
    Quat orientation;
    Real time = 0;  // since then
    bool still = false;
};

// In the list of bodies that are asleep with forces (dynamics/sleep/sleeping_forces).
struct ForcedLink {
    Body* next = nullptr;
    Body** from = nullptr;  // what points to the body; null: it is in no list
};

struct DampingRule {
    Real linear_scale = 0, angular_scale = 0;
    Real linear_threshold2 = Real(0.01) * Real(0.01);
    Real angular_threshold2 = Real(0.01) * Real(0.01);
};

// What fluids (src/fluid) have done to a body in the last step in which it was awake.
struct BodyInFluid {
    bool wet = false;
    bool floats = false;    // nearly balanced: it may fall asleep with nothing but the fluid under it
    bool restless = false;  // in one that moves by functions of the program: it may not
    Vec3 force, torque;
};

// What a body contributes to the choice of its island's solver (step/hybrid).
struct HybridState {
    std::uint8_t requested = 0;  // stepper (dStepper); 0: none
    bool was_exact = false;
    std::uint16_t work = 0;     // of the last exact step, microseconds; 0: unknown
    std::uint8_t strained = 0;  // steps for which its joints stay exact in substeps
    std::uint8_t refused = 0;   // steps for which the island is not solved exactly: it took too much work
    std::uint8_t apart = 0;     // steps with wide gaps in its joints, less those with none; up to 15

    bool remembers() const { return was_exact || work > 0 || strained > 0 || refused > 0 || apart > 0; }
};

struct Body : Numbered {
    explicit Body(World& world);
    ~Body();

    // ---- all that walks over the world's bodies look at: one line of the cache, with the tag ----
    World* world;
    int place = -1;                   // in the world's roster
    bool has_moved_callback = false;  // `moved` is to be called after a step
    bool gravity = true;
    bool gyroscopic = true;
    bool finite_rotation = false;
    JointNode* joints = nullptr;        // most recently attached first
    ManifoldEdge* manifolds = nullptr;  // world-managed contacts, during a step
    dxGeom* first_geom = nullptr;       // list of geoms; only step/common/link.cpp looks inside
    int island_index = -1;              // place in its island during a step, else below 0
    bool disabled = false;
    bool auto_disable = false;
    bool had_manifolds = false;  // by world-managed contacts, in the last step
    bool driven = false;         // kinematic: forces do not move it

    // ---- visible through the ABI ----
    alignas(kCacheLine) Real pos[4] = {};
    Real q[4] = {1, 0, 0, 0};
    Real R[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    Real lvel[4] = {};
    Real avel[4] = {};
    Real facc[4] = {};  // force and torque accumulators, world frame
    Real tacc[4] = {};

    // ---- read once a step, up to the number that is the mass ----
    DampingRule damping;
    Real inv_mass = 1;          // 0: kinematic
    Sym3 inertia{1, 1, 1};      // body frame, about the centre
    Sym3 inv_inertia{1, 1, 1};  // 0: kinematic
    Real max_angular_speed = kInf;
    JointNode* lasting = nullptr;  // the first of `joints` that is no contact
    dMass mass;                    // as the user gave it, kept while kinematic

    // ---- rest ----
    void (*moved)(dBodyID) = nullptr;
    // With exact rotation: angular momentum, body frame, that the angular velocity does not show
    // (dynamics/exact_spin.cpp). Else zero, as at the end of a step of a body on nothing.
    Vec3 spin_excess;
    Vec3 finite_axis;  // zero: none
    HybridState hybrid;
    void* data = nullptr;
    SleepRule sleep;
    int idle_steps_left = 0;
    Real idle_time_left = 0;
    Array<Vec3> sample_v, sample_w;  // rings of sleep.samples velocities
    int sample_next = 0;
    bool samples_ready = false;
    Stillness short_window, long_window;  // dynamics/sleep/sleep
    Real settling_time =
        0;  // that its island has been settling without falling asleep (dynamics/sleep/settle)
    std::uint64_t mass_hash = 0;  // tells `mass` from others
    std::uint64_t put_down = 0;   // when the program has disabled it: a number as of disturbances
    ForcedLink forced;
    BodyInFluid fluid;
    Vehicle* vehicle = nullptr;  // what makes it one (dynamics/forces/vehicle.h); null: it is none

    Pose pose() const { return load_pose(pos, R); }
    Vec3 position() const { return load(pos); }
    Mat3 rotation() const { return load_mat(R); }
    Quat orientation() const { return load_quat(q); }
    Vec3 velocity() const { return load(lvel); }
    Vec3 angular_velocity() const { return load(avel); }
    bool kinematic() const { return driven; }  // then inverse mass and inertia are zero
    Vec3 point_velocity(Vec3 point) const
    {
        return velocity() + cross(angular_velocity(), point - position());
    }
};

template <>
struct HandleOf<Body> {
    using Id = dBodyID;
    static constexpr Tag kTag = Tag::kBody;
};

Body* create_body(World& world);
void destroy_body(Body& body);  // its joints are detached; geoms are the caller's business (step/common/link)

void set_orientation(Body& body, Quat unit);   // writes q and R
bool set_mass(Body& body, const dMass& mass);  // false: not positive definite or off-centre, nothing changed
void set_kinematic(Body& body);
void set_dynamic(Body& body);
void watch(Body& body, bool on);                           // sets `auto_disable`, no more
[[nodiscard]] bool set_auto_disable(Body& body, bool on);  // false: no memory, nothing changed
[[nodiscard]] bool set_sleep_samples(Body& body, int samples);
void enable(Body& body);            // clears `disabled`
void wake(Body& body);              // and reloads the idle counters
void forget_stillness(Body& body);  // where it has stayed within its windows so far
// May it have fallen asleep, in a world that wakes sleepers? Then this wakes it, because something has happened
// to what it rests on, hangs from or is moved by.
bool is_sleeper(const Body& body);
void wake_sleeper(Body& body);
void wake_if_driven(Body& body);  // a kinematic one that has been given a velocity

}  // namespace epode
