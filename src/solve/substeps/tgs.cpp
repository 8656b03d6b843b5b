// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldStepFast1: n substeps of hs = h/n instead of n sweeps over one large step (TGS; Macklin, Storey et
// al., "Small Steps in Physics Simulation", 2019). Per substep:
//
//   v += hs M^-1 f;  v += M^-1 J^T p          forces, and the impulses of the substep before (warm start)
//   solve contacts, then joints as blocks     J v + C p = c, correcting position errors
//   x += hs v
//   solve joints, then contacts, without it   relax: removes the velocity that the correction added
//
// After the last substep, what approached fast and carried load rebounds (solve/substeps/impacts/restitution.h). Errors of joints
// are measured at every pose, so mass ratios that would need hundreds of sweeps settle in ten substeps; on
// regular stacks there is no gain. The impulse of a step is the sum over its substeps; the next step starts
// from its n-th part. The reported residual is that of the last substep after its correcting solve, because
// for the whole step no single problem exists. Contact manifolds are solved in float lanes in the same passes;
// their rows are not judged, but v* contains what their impulses have done to the bodies.
//
// The second solver here differs in one thing: all joints of the island are one block that is solved exactly
// (solve/substeps/joint_network), before and after the contacts of each pass. An articulated body in a pile
// keeps its joints together, and only contacts iterate. Where the factor would fill in, the first solver is
// used.
#include <algorithm>

#include "rows/wrench.h"
#include "solve/common/residual.h"
#include "solve/joints/joint_lanes.h"
#include "solve/solver.h"
#include "solve/substeps/impacts/restitution.h"
#include "solve/substeps/joint_network.h"
#include "solve/substeps/manifold_set.h"
#include "solve/substeps/manifold_steps.h"
#include "solve/substeps/substep_contacts.h"

namespace epode {
namespace {

// Joints: JointLanes or JointNetwork.
template <typename Joints>
class SubstepSolver {
  public:
    SubstepSolver(RowSystem& system, const Substeps& model, int n, Joints& joints)
        : system_(system), model_(model), step_{system.h / Real(n), n}, joints_(joints)
    {}

    bool prepare(const SolverSettings& settings, Arena& arena)
    {
        // Converts numbers of the whole step to those of a substep.
        const Real share = Real(1) / Real(step_.n);
        for (RowNumbers& n : system_.numbers) {
            n.p *= share;
            if (n.parent < 0) n.lo *= share, n.hi *= share;
        }
        ends_ = settings.substep_ends;
        velocities_ = take_velocities(system_, arena);
        if (velocities_.empty() || !joints_.pack(system_, arena)) return false;
        load_velocities(system_, velocities_);
        if (!joints_.follow(system_, step_, velocities_, arena)) return false;
        if (!contacts_.prepare(system_, step_, settings.seed, arena)) return false;
        if (!manifolds_.prepare(system_, step_, settings.tasks, arena)) return false;
        if (settings.want_residual) {
            before_ = arena.take<SolverBody>(int(system_.bodies.size()));
            lo_ = arena.take<Real>(int(system_.numbers.size()));
            hi_ = arena.take<Real>(int(system_.numbers.size()));
        }
        if ((settings.want_residual || !system_.wrenches.empty()) && !take_scratch(arena)) return false;
        if (!expect_rebounds(arena)) return false;
        for (RowNumbers& n : system_.numbers) n.p = 0;  // from here on the sum
        return !arena.failed();
    }

    bool run(const SolverSettings& settings, Arena& arena, SolveReport& report)
    {
        joints_.turn(system_);
        for (int i = 0; i < step_.n; ++i) {
            const bool last = i == step_.n - 1;
            correct(i > 0, last);
            if (last && !before_.empty() && !measure(settings, arena, report)) return false;
            move();
            relax(last);
        }
        joints_.store_sums(system_.numbers);
        store_velocities(velocities_, system_);
        model_.settle(model_.model, system_);
        add_contact_wrenches();
        model_.gather_contacts(model_.model, system_);
        manifolds_.store_impulses(system_.contact_manifolds);
        return rebound(arena);
    }

  private:
    // Rows and numbers for joints to describe themselves in.
    bool take_scratch(Arena& arena)
    {
        described_ = arena.take<RowNumbers>(int(system_.numbers.size()));
        rows_ = arena.take<Row>(int(system_.rows.size()));
        summed_ = arena.take_zeroed<Real>(int(system_.rows.size()));
        if (arena.failed()) return false;
        std::copy(system_.numbers.begin(), system_.numbers.end(), described_.begin());
        std::copy(system_.rows.begin(), system_.rows.end(), rows_.begin());
        return true;
    }

    bool expect_rebounds(Arena& arena)
    {
        const bool rows = contacts_.may_rebound(system_);
        if (!rows && !manifolds_.may_rebound()) return true;
        const auto by_forces = arena.take<Velocity>(int(velocities_.size()));
        if (arena.failed()) return false;
        std::copy(velocities_.begin(), velocities_.end(), by_forces.begin());
        model_.apply_forces(model_.model, by_forces.data(), step_.hs);
        for (std::size_t i = 0; i < by_forces.size(); ++i)
            by_forces[i].v -= velocities_[i].v, by_forces[i].w -= velocities_[i].w;
        for (int part = 0; part < system_.worlds(); ++part)
            if (hangs(part))
                for (int i = system_.begin_of(part).bodies; i < system_.end_of(part).bodies; ++i)
                    by_forces[std::size_t(i)] = {};
        manifolds_.expect_impacts(system_, by_forces);
        return !rows || contacts_.expect_rebounds(system_, velocities_, by_forces, arena);
    }

    // Do its joints hold it, so that forces do not tell how it falls?
    bool hangs(int part) const
    {
        const auto fixed = [&](int body) {
            return body < 0 || !(system_.bodies[std::size_t(body)].inv_mass > 0);
        };
        const auto first = system_.blocks.begin() + system_.begin_of(part).blocks;
        const auto last = system_.blocks.begin() + system_.end_of(part).blocks;
        return std::any_of(first, last, [&](const RowBlock& block) {
            return !block.contact && (block.term_count > 0 || fixed(block.body1) || fixed(block.body2));
        });
    }

    void correct(bool moved, bool last)
    {
        if (moved) model_.refresh(model_.model, system_, velocities_.data());
        model_.apply_forces(model_.model, velocities_.data(), step_.hs);
        if (last && !before_.empty()) save_bodies();
        joints_.load_substep(system_, step_);
        joints_.apply_impulses(velocities_);
        contacts_.apply_impulses(velocities_);
        manifolds_.apply_impulses(velocities_);
        if (Joints::kHasBothEnds) joints_.sweep(velocities_, {1, false});
        contacts_.sweep(velocities_, false);
        manifolds_.correct(velocities_);
        joints_.sweep(velocities_, {1, false});  // the velocities that poses follow
    }

    void save_bodies()
    {
        store_velocities(velocities_, system_);
        model_.settle(model_.model, system_);
        std::copy(system_.bodies.begin(), system_.bodies.end(), before_.begin());
    }

    void move()
    {
        contacts_.follow_motion(velocities_);
        manifolds_.follow_motion(velocities_);
        add_joint_wrenches();
        model_.advance(model_.model, system_, velocities_.data(), step_.hs);
        joints_.turn(system_);
    }

    void relax(bool last)
    {
        joints_.sweep(velocities_, {1, true});
        contacts_.sweep(velocities_, true);
        manifolds_.relax(velocities_);
        if (Joints::kHasBothEnds) joints_.sweep(velocities_, {1, true});
        add(ends_, velocities_.first(ends_.size()));
        if (last) joints_.apply_restitution(system_, velocities_);
        add_joint_wrenches();
        joints_.sum_impulses();
        contacts_.add_impulses(system_.numbers);
        std::fill(summed_.begin(), summed_.end(), Real(0));
    }

    // What joints have exerted since this was called last in the substep, where they are now: before poses
    // change and when the substep ends. Rows that are followed have a pose of their own, the others that of
    // the system.
    void add_joint_wrenches()
    {
        if (system_.wrenches.empty()) return;
        joints_.describe(described_, rows_);
        for (const RowBlock& block : system_.blocks) {
            if (block.wrench < 0 || block.contact) continue;
            for (int i = block.first; i < block.first + block.count; ++i) {
                const auto at = std::size_t(i);
                add_wrench(block, i, block.followed ? rows_[at] : system_.rows[at],
                           described_[at].p - summed_[at]);
                summed_[at] = described_[at].p;
            }
        }
    }

    // Once, with the sums: their arms do not change.
    void add_contact_wrenches()
    {
        for (const RowBlock& block : system_.blocks) {
            if (block.wrench < 0 || !block.contact) continue;
            for (int i = block.first; i < block.first + block.count; ++i)
                add_wrench(block, i, system_.rows[std::size_t(i)], system_.numbers[std::size_t(i)].p);
        }
    }

    void add_wrench(const RowBlock& block, int i, const Row& row, Real p)
    {
        system_.wrenches[std::size_t(block.wrench)].add(block, i, row, p);
    }

    bool rebound(Arena& arena)
    {
        std::span<float> rebounds;
        if (!manifolds_.find_rebounds(system_.contact_manifolds, arena, rebounds)) return false;
        contacts_.correct_rebounds(system_);
        Restitution restitution(system_, rebounds);
        if (!restitution.any()) return true;
        if (rows_.empty() && !take_scratch(arena)) return false;
        joints_.describe(described_, rows_);
        return restitution.apply(rows_, arena);
    }

    bool measure(const SolverSettings& settings, Arena& arena, SolveReport& report)
    {
        std::copy(system_.rows.begin(), system_.rows.end(), rows_.begin());
        joints_.describe(described_, rows_);
        contacts_.describe(described_);
        RowSystem one = system_;
        one.numbers = described_, one.rows = rows_;
        one.frictions = contacts_.manifold_frictions(arena);
        const RowSystem all = one;
        manifolds_.apply_impulses(before_);
        present_bounds(one, lo_, hi_);
        report.residual = natural_residual(one, before_, lo_, hi_, arena);
        for (int part = 0; part < int(system_.parts.size()) && report.residual >= 0; ++part) {
            const int from = system_.begin_of(part).blocks, to = system_.end_of(part).blocks;
            one.blocks = system_.blocks.subspan(std::size_t(from), std::size_t(to - from));
            one.frictions = frictions_of(all, part);
            settings.part_residuals[std::size_t(part)] = natural_residual(one, before_, lo_, hi_, arena);
        }
        return report.residual >= 0;
    }

    RowSystem& system_;
    const Substeps& model_;
    const Substep step_;
    Joints& joints_;
    SubstepContacts contacts_;
    ManifoldSet manifolds_;
    std::span<Velocity> velocities_;
    std::span<Velocity> ends_;      // only when they are wanted
    std::span<SolverBody> before_;  // only when the residual is wanted
    std::span<RowNumbers> described_;
    std::span<Row> rows_;
    std::span<Real> summed_;  // impulses of the substep that the wrenches contain
    std::span<Real> lo_, hi_;
};

// Solves a system without rows. False: there are rows.
bool solve_without_rows(RowSystem& system, const SolverSettings& settings, Arena& arena, int n, bool& solved)
{
    if (!system.rows.empty()) return false;
    solved = true;
    const Substeps& model = *settings.substeps;
    if (settings.contact_manifolds) {
        solved = solve_manifolds(system, settings, arena);
        return true;
    }
    Arena::Scope scope(arena);
    const auto velocities = take_velocities(system, arena);
    solved = !arena.failed();
    if (!solved) return true;
    load_velocities(system, velocities);
    for (int i = 0; i < n; ++i) {  // free bodies take substeps too, which improves their rotation
        model.apply_forces(model.model, velocities.data(), system.h / Real(n));
        model.advance(model.model, system, velocities.data(), system.h / Real(n));
    }
    store_velocities(velocities, system);
    model.settle(model.model, system);
    return true;
}

template <typename Joints>
bool run(RowSystem& system, const SolverSettings& settings, int n, Joints& joints, Arena& arena,
         SolveReport& report)
{
    SubstepSolver<Joints> steps(system, *settings.substeps, n, joints);
    return steps.prepare(settings, arena) && steps.run(settings, arena, report);
}

bool solve_tgs(RowSystem& system, const SolverSettings& settings, Arena& arena, SolveReport& report)
{
    const int n = std::max(1, settings.iterations);
    report.method = dIslandMethodSubsteps;
    report.iterations = 2 * n;
    bool solved;
    if (solve_without_rows(system, settings, arena, n, solved)) return solved;
    Arena::Scope scope(arena);
    JointLanes joints(n);
    return run(system, settings, n, joints, arena, report);
}

bool solve_network(RowSystem& system, const SolverSettings& settings, Arena& arena, SolveReport& report)
{
    const int n = std::max(1, settings.iterations);
    bool solved;
    report.method = dIslandMethodSubsteps;
    report.iterations = 2 * n;
    if (solve_without_rows(system, settings, arena, n, solved)) return solved;
    Arena::Scope scope(arena);
    JointNetwork joints;
    if (!joints.analyse(system, settings.symbolic_cache, arena)) return false;
    if (!joints.worth()) {
        SolverSettings swept = settings;
        swept.iterations = settings.swept_iterations;
        return solve_tgs(system, swept, arena, report);
    }
    report.method = dIslandMethodSubstepsExactJoints;
    solved = run(system, settings, n, joints, arena, report);
    report.factorisations = joints.factorisations();
    return solved;
}

}  // namespace

const Solver kTgs{.name = "tgs",
                  .substeps = true,
                  .cones = true,
                  .contact_manifolds = true,
                  .warm_share = Real(0.9),
                  .settling_factor = 4,
                  .solve = solve_tgs};
const Solver kNetwork{.name = "network",
                      .substeps = true,
                      .cones = true,
                      .contact_manifolds = true,
                      .warm_share = Real(0.9),
                      .settling_factor = 4,
                      .solve = solve_network};

}  // namespace epode
