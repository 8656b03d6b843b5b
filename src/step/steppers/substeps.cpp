// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldStepFast1: n substeps with one collision (substep_loop.h, manifold_substeps.h). Joints are swept, or all of an island are one
// block that is solved exactly (solve/substeps/joint_network.h). Where the factor of the block would fill in, they are
// swept after all. Substeps lose properties of free motion, which are restored (island/free_flight.h), and of forces
// of the program (island/prompt_forces.h).
#include <algorithm>
#include <optional>

#include "dynamics/integrate.h"
#include "step/island/containment.h"
#include "step/island/free_flight.h"
#include "step/island/positions/tension.h"
#include "step/island/strain.h"
#include "step/island/warm_start.h"
#include "step/island/write_back.h"
#include "step/steppers/hybrid.h"
#include "step/steppers/manifold_substeps.h"
#include "step/steppers/stepper.h"
#include "step/steppers/substep_loop.h"

namespace epode {
namespace {

constexpr int kLargeManifolds = 256;  // of an island whose sweeps all workers make together
// Sweeps over manifolds read more memory for each and read it more often than those over rows.
constexpr int kMaxWeight = 512;
constexpr Real kWarmShare = Real(0.9);
constexpr int kSettlingFactor = 4, kSettlingIfExact = 2;
constexpr ProblemForm kForm{
    .contact_manifolds = true, .cones = true, .keeps_depth = true, .has_substeps = true};

// Do joints hold it to what cannot move? Others carry no loads while they come to rest.
bool is_held(const Island& island)
{
    const auto fixed = [](const Body* body) { return !body || body->kinematic(); };
    return std::any_of(island.joints.begin(), island.joints.end(), [&](const Joint* joint) {
        return !is_contact(*joint) && (fixed(joint->body1()) || fixed(joint->body2()));
    });
}

class SubstepRun {
  public:
    SubstepRun(IslandRun& run, bool exact_joints)
        : run_(run), system_(run.work.system), exact_joints_(exact_joints), n_(count())
    {}

    Outcome step()
    {
        if (!begin()) return Outcome::kNoMemory;
        load_fitting_start(run_, warm_start());
        std::span<const BorneForce> borne;
        if (n_ > 1)
            borne = kick_by_prompt_forces(run_.world, run_.work, run_.context.h,
                                          run_.world.warm_starting * kWarmShare, run_.arena);
        SubstepModel model(run_.work, run_.world, step_info(run_.world, run_.context.h), run_.raised > 0,
                           borne, run_.tasks);
        if (!model.prepare(run_.arena)) return Outcome::kNoMemory;
        const bool sane = solve(model) && run_.is_sound();
        if (run_.arena.failed()) return Outcome::kNoMemory;
        run_.report_solution();
        if (!sane) return Outcome::kRefused;
        contain_unsound(run_, true, [this](int part, bool contained) {
            if (contained)
                put_back(part);
            else if (run_.is_free(part))
                fly_freely(part);
        });
        add_to_ledger();
        write_back(run_.work, run_.tasks);
        run_.add_forces_to_ledger();
        keep_impulses(run_, warm_start(), blows_);
        if (!run_.methods().empty()) strain_.end(run_.world, run_.work, run_.methods());
        return Outcome::kMade;
    }

  private:
    // What swept joints leave open depends on the number of substeps: with another one they would jerk. It is what the
    // program asked for, whether the island settles or not, unless gaps stay wide.
    int count() const
    {
        const bool sweeps_joints = !exact_joints_ && has_lasting_joints(run_.work.island);
        if (sweeps_joints) return swept();
        if (exact_joints_ && !is_held(run_.work.island)) return std::max(1, run_.context.iterations);
        return std::max(1, run_.settling_iterations(exact_joints_ ? kSettlingIfExact : kSettlingFactor));
    }
    int swept() const { return std::max(1, run_.context.iterations * substep_factor(run_.work.island)); }

    WarmStart warm_start() const { return {.share = kWarmShare, .substeps = n_, .has_manifold_rows = false}; }

    bool begin()
    {
        if (!run_.begin(kForm, run_.context.h, n_)) return false;
        if (run_.ledger.wanted()) ends_ = run_.arena.take_zeroed<Velocity>(int(system_.bodies.size()));
        if (!run_.methods().empty() && !strain_.begin(run_.world, run_.work, run_.arena)) return false;
        return run_.raise_inertias(run_.context.h / Real(n_), kResolvedExactly) &&
               blows_.begin(system_, run_.arena);
    }

    // False: out of memory, or not finite.
    bool solve(SubstepModel& model)
    {
        run_.solved.method = dIslandMethodSubsteps;
        run_.solved.iterations = 2 * n_;
        if (!system_.rows.empty()) return solve_rows(model);
        if (run_.context.manages_contacts)
            return make_manifold_substeps(system_, model, n_, run_.tasks, ends_, run_.arena);
        return make_free_substeps(model);
    }

    bool solve_rows(SubstepModel& model)
    {
        Arena::Scope scope(run_.arena);
        JointNetwork network;
        if (exact_joints_ && !network.analyse(system_, &run_.context.symbolic_cache, run_.arena))
            return false;
        if (network.worth()) {
            run_.solved.method = dIslandMethodSubstepsExactJoints;
            const bool solved = solve_with(network, model);
            run_.solved.factorisations = network.factorisations();
            return solved;
        }
        if (exact_joints_) solved_substeps_ = swept();
        JointLanes lanes(solved_substeps_);
        return solve_with(lanes, model);
    }

    template <typename Joints>
    bool solve_with(Joints& joints, SubstepModel& model)
    {
        run_.solved.iterations = 2 * solved_substeps_;
        const SubstepSettings settings{.seed = run_.seed(),
                                       .want_residual = !run_.reports.empty(),
                                       .part_residuals = run_.part_residuals,
                                       .tasks = run_.tasks};
        SubstepSolver<Joints> solver(system_, solved_substeps_, joints);
        return solver.prepare(settings, run_.arena) &&
               make_substeps(solver, model, ends_, run_.arena, run_.solved);
    }

    // Free bodies take substeps too, which improves their rotation.
    bool make_free_substeps(SubstepModel& model)
    {
        Arena::Scope scope(run_.arena);
        const auto velocities = take_velocities(system_, run_.arena);
        if (run_.arena.failed()) return false;
        load_velocities(system_, velocities);
        for (int i = 0; i < n_; ++i) {
            model.apply_forces(velocities, system_.h / Real(n_));
            model.advance(velocities, system_.h / Real(n_));
        }
        store_velocities(velocities, system_);
        model.settle();
        return true;
    }

    // The substeps have moved the bodies.
    void put_back(int part)
    {
        run_.context.undo.restore_poses(run_.bodies_of(part));
        for (Body* body : run_.bodies_of(part)) advance_pose(*body, run_.context.h);
    }

    void fly_freely(int part)
    {
        const std::span<Body* const> bodies = run_.bodies_of(part);
        const auto first = std::size_t(system_.begin_of(part).bodies);
        for (std::size_t i = 0; i < bodies.size(); ++i) {
            if (!flies_by_itself(run_.world, *bodies[i], run_.context.manages_contacts)) continue;
            fly_body(bodies.subspan(i, 1));
            load_velocity(*bodies[i], system_.bodies[first + i]);
        }
    }

    // `one`: a body.
    void fly_body(std::span<Body* const> one)
    {
        Body& body = *one.front();
        const Vec3 v = body.velocity(), w = body.angular_velocity();
        run_.context.undo.restore_poses(one);
        fly(run_.world, body, run_.context.h, n_);
        if (keeps_numbers(body)) return;
        run_.context.undo.restore_poses(one);  // gyroscopic torque grows with the square of a spin
        store(body.lvel, v), store(body.avel, w);
    }

    void add_to_ledger()
    {
        run_.add_solution_to_ledger(true);
        if (!run_.ledger.wanted()) return;
        for (int part = 0; part < system_.worlds(); ++part)
            if (run_.is_sound(part) && !run_.is_free(part))
                run_.ledger.add_relaxed_corrections(part, ends_, run_.context.h / Real(solved_substeps_));
    }

    IslandRun& run_;
    RowSystem& system_;
    const bool exact_joints_;
    const int n_;
    int solved_substeps_ = n_;
    StrainWatch strain_;  // only where methods are noted
    Blows blows_;
    std::span<Velocity> ends_;  // if there is a ledger
};

Outcome step_in_substeps(IslandRun& run) { return SubstepRun(run, false).step(); }
Outcome step_with_exact_joints(IslandRun& run) { return SubstepRun(run, true).step(); }

bool has_many_manifolds(const Island& island) { return int(island.manifolds.size()) >= kLargeManifolds; }

// Islands of the world's substeps whose joints sweeps do not hold take exact joints.
bool choose_where_strained(const StepContext& context, std::span<const Island> islands, Arena&,
                           std::span<IslandMethod> methods)
{
    for (std::size_t i = 0; i < methods.size(); ++i)
        methods[i] = {&stepper_for_strain(kSubsteps, islands[i]), context.iterations};
    return true;
}

}  // namespace

const Stepper kSubsteps{.name = "substeps",
                        .step = step_in_substeps,
                        .sharing = [](bool) { return Sharing::kAlike; },
                        .max_weight = kMaxWeight,
                        .is_large = has_many_manifolds,
                        .has_substeps = true,
                        .iterates = true,
                        .for_strained = &kSubstepsExactJoints,
                        .choose = choose_where_strained,
                        .remember = remember_strain};

// The joints of one island are factorised at a time.
const Stepper kSubstepsExactJoints{.name = "substeps with exact joints",
                                   .step = step_with_exact_joints,
                                   .sharing = [](bool) { return Sharing::kWithoutJoints; },
                                   .max_weight = kMaxWeight,
                                   .is_large = has_many_manifolds,
                                   .has_substeps = true,
                                   .iterates = true};

}  // namespace epode
