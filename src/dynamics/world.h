// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world: its parameters, its bodies and joints in ODE's order (newest first), and the memory of its steps:
// `memory` is scratch, `step_state` what survives from one step to the next.
// `step_state` belongs to step/, the only folder that knows what survives from one step to the next.
#pragma once

#include "base/call_guard.h"
#include "base/objects/handle.h"
#include "base/objects/roster.h"
#include "base/step_memory.h"
#include "dynamics/body.h"
#include "dynamics/joint.h"
#include "ode/defaults.h"
#include "ode/report.h"
#include "ode/steppers.h"
#include "ode/threading.h"

namespace epode {

struct CouplingJoint;
struct Fluid;
struct StepState;

// Softness that only keeps redundant joints solvable.
inline constexpr Real kDefaultCfm = kSingle ? Real(1e-5) : Real(1e-10);

// What the library is doing with a world while it may call functions of the program.
enum class Busy : std::uint8_t { kNo, kStep, kCopy, kEnd };

struct World : Tagged {
    World();
    ~World();

    Roster<Body, 1> bodies;  // which of them are active: dynamics/active
    Roster<Joint, 2> joints;
    Array<Body*> reached;           // that are to become active, during a step
    std::uint64_t bodies_made = 0;  // gives each body its serial
    // Changes whenever a joint that is no contact is attached or detached.
    std::uint64_t connections_version = 0;
    int driven_joints = 0;  // that have JointDrives
    Array<CouplingJoint*> couplings;
    Array<Fluid*> fluids;          // the oldest first
    Body* first_forced = nullptr;  // bodies that are asleep with forces: dynamics/sleep/sleeping_forces

    Vec3 gravity;
    Real erp = Real(0.2);
    Real cfm = kDefaultCfm;
    Real contact_max_vel = kInf;
    Real contact_layer = 0;
    int quick_iterations = 20;
    Real quick_w = Real(1.3);
    bool friction_cone = false;      // friction of contact joints, where the solver sweeps
    bool manifold_friction = false;  // one for the points of a manifold, where the solver sweeps
    Real warm_starting = 1;          // times the solver's own share of the last impulses
    int auto_enable_depth = 3;       // of the 0.039 guide; stored, never used by it either
    bool exact_rotation = false;     // of dWorldStep and dWorldQuickStep
    int exact_substeps = 1;          // of dWorldStep
    bool joint_coordinates = false;  // in dWorldStep, of islands of trees
    int projection_iterations = 0;   // of positions after dWorldStep; 0: none
    Real projection_tolerance = kSingle ? Real(1e-3) : Real(1e-4);
    int hybrid_stepper = 0;            // of islands without requests (dStepper); 0: by the model
    int hybrid_substeps = 4;           // where hybrid steps have them
    Real hybrid_budget = 1;            // of exact solutions in a hybrid step: times what substeps would take
    unsigned islands_max_threads = 0;  // 0: unlimited
    int step_threads = 1;              // 0: one per processor; not looked at while `threading` is set
    dThreadingImplementationID threading = nullptr;
    dThreadingFunctionsInfo threading_functions{};

    int behaviour = dBehaviour1;  // a dBehaviour
    bool acts_as_ode() const { return behaviour < dBehaviour1; }
    bool manages_contacts = false;    // has been given a contact space
    std::uint64_t last_put_down = 0;  // the greatest Body::put_down
    // Steps that find contacts know what lies on what, and what sleeps wakes when its support changes. With
    // contact joints the program knows, and ODE leaves it to the program.
    bool wakes_sleepers() const { return manages_contacts && !acts_as_ode(); }

    // Seeds of new bodies.
    bool auto_disable = false;
    bool watches_bodies = false;  // a body has had `auto_disable`; else none is checked
    SleepRule sleep;
    DampingRule damping;
    Real max_angular_speed = kInf;

    void* data = nullptr;
    std::uint64_t step_count = 0;
    Busy busy =
        Busy::kNo;  // calls that would change what a step or a walk is reading are refused; mark_busy()
    bool report_wanted = false;
    bool report_made = false;  // a step has been made since it was wanted
    dWorldStepReport report{};

    StepMemory* memory = nullptr;  // perhaps shared with other worlds; null: none yet
    StepState* step_state = nullptr;
    void (*free_step_state)(StepState*) = nullptr;
};

template <>
struct HandleOf<World> {
    using Id = dWorldID;
    static constexpr Tag kTag = Tag::kWorld;
};

void mark_busy(World& world, Busy busy);
bool any_world_busy();  // of this process
// If no function of the program has left what kept it busy. Not gnu::cold: GCC 12 then takes all that follows is_busy for cold.
bool still_busy(const World& world);
inline bool is_busy(const World& world)
{
    if (world.busy == Busy::kNo) [[likely]]
        return false;
    return still_busy(world);
}
inline bool is_busy(const Joint& joint) { return joint.world && is_busy(*joint.world); }
// Marks a world that is saved, copied or restored: height functions and sensors' shapes may call the program.
class CopyMark {
  public:
    explicit CopyMark(World& world) : guard_(unmark, &world) { mark_busy(world, Busy::kCopy); }

  private:
    static void unmark(void* world, const void*, std::size_t)
    {
        mark_busy(*static_cast<World*>(world), Busy::kNo);
    }
    CallGuard guard_;
};
// Why the call is refused.
const char* busy_text(const World& world);

}  // namespace epode

// The world of a public function's argument w, or the call is refused with the given result. In namespace epode.
#define EPODE_WORLD_OR(...)               \
    World* world = from_handle<World>(w); \
    EPODE_USER(world __VA_OPT__(, ) __VA_ARGS__)
