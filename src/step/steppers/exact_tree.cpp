// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/steppers/exact_tree.h"

#include <algorithm>

#include "step/island/positions/position_rows.h"
#include "step/island/positions/tension.h"
#include "step/island/report.h"
#include "step/island/tree/tree_motion.h"
#include "step/island/warm_start.h"
#include "step/island/write_back.h"

namespace epode {
namespace {

LinkJoint kind_of(const Joint& joint)
{
    switch (joint.type->number) {
        case dJointTypeBall:
            return LinkJoint::kBall;
        case dJointTypeHinge:
            return LinkJoint::kHinge;
        case dJointTypeSlider:
            return LinkJoint::kSlider;
        case dJointTypeFixed:
            return LinkJoint::kFixed;
        default:
            return LinkJoint::kNone;
    }
}

// Work is counted for rows in bodies only, which give up where it becomes too much.
bool has_budget(const IslandRun& run)
{
    return !run.methods().empty() && run.methods().front().max_work < kInf;
}

bool touches(const Island& island) { return !island.manifolds.empty() || island.plain_contacts > 0; }

bool is_still(const RowSystem& system, int body)
{
    if (body < 0 || system.bodies[std::size_t(body)].inv_mass > 0) return true;
    const SolverBody& its = system.bodies[std::size_t(body)];
    return its.v == Vec3{} && its.w == Vec3{};
}

bool is_rigid_and_closed(const Row& row, Real arms, Real tolerance)
{
    const bool rigid = row.kind == RowKind::kLock && row.lo == -kInf && row.hi == kInf && !row.drive &&
                       !row.given && row.cfm <= kDefaultCfm;
    const bool turns = row.lin1 == Vec3{};
    return rigid && std::fabs(row.error) <= (turns ? tolerance : tolerance * arms);
}

class TreeRun {
  public:
    explicit TreeRun(IslandRun& run) : run_(run), work_(run.work), system_(run.work.system), arena_(run.arena)
    {}

    TreeOutcome step()
    {
        Arena::Scope scope(arena_);
        if (!choose_kinds()) return failed(TreeOutcome::kNotInTree);
        const auto centres = arena_.take<Vec3>(int(system_.bodies.size()));
        if (arena_.failed()) return TreeOutcome::kNoMemory;
        for (std::size_t i = 0; i < centres.size(); ++i) centres[i] = work_.island.bodies[i]->position();
        if (!tree_.build(system_, centres, kinds_, arena_)) return TreeOutcome::kNoMemory;
        if (!tree_.fits()) return TreeOutcome::kNotInTree;
        if (!closing_.begin(run_.world, work_, tree_, arena_)) return TreeOutcome::kNoMemory;
        if (closing_.size() > rows_of_branches()) return TreeOutcome::kNotInTree;
        if (!motion_.begin(run_.world, work_, tree_, solve_, closing_, arena_)) return TreeOutcome::kNoMemory;
        if (motion_.is_too_long()) return TreeOutcome::kNotInTree;
        if (!solve_.prepare(system_, tree_, closing_.flags(), most_rows(), arena_))
            return TreeOutcome::kNoMemory;
        if (!solve_.fits()) return TreeOutcome::kNotInTree;
        if (!resolves_swings()) return failed(TreeOutcome::kNotInTree);
        SolveReport report;
        if (!solve_.solve(report)) return TreeOutcome::kNotInTree;
        if (!motion_.find_way()) return failed(TreeOutcome::kNotInTree);
        report.method = dIslandMethodJointCoordinates;
        run_.solved = report;
        return finish();
    }

  private:
    TreeOutcome failed(TreeOutcome otherwise) const
    {
        return arena_.failed() ? TreeOutcome::kNoMemory : otherwise;
    }

    // Does the step follow light links under tension (positions/tension.h)? What they turn with counts.
    bool resolves_swings()
    {
        Arena::Scope scope(arena_);
        const std::span<const Swing> swings = find_swings(work_, system_.h, kResolvedExactly, arena_);
        if (swings.empty()) return !arena_.failed();
        const auto of_links = arena_.take<Sym3>(int(tree_.links().size()));
        if (arena_.failed()) return false;
        for (std::size_t i = 0; i < of_links.size(); ++i) {
            const Swing& swing = swings[std::size_t(tree_.link(int(i)).body)];
            of_links[i] = swing.is_link() ? swing.S : Sym3{};
        }
        return solve_.resolves(of_links, double(kResolvedExactly));
    }

    // Such rows do not yield.
    int bounded_rows() const
    {
        return int(std::count_if(system_.numbers.begin(), system_.numbers.end(),
                                 [](const RowNumbers& n) { return n.bounded(); }));
    }

    // Besides those of joints: they make a dense problem.
    int most_rows() const { return has_budget(run_) ? kFewRows : TreeSolve::kMaxRows; }

    // That joint coordinates leave out.
    int rows_of_branches() const
    {
        int sum = 0;
        for (const TreeLink& link : tree_.links()) sum += lock_rows(link.joint);
        return sum;
    }

    bool choose_kinds()
    {
        if (bounded_rows() > most_rows()) return false;
        for (const Body* body : work_.island.bodies) {
            if (body->max_angular_speed < kInf || !(body->finite_axis == Vec3{})) return false;
            if (!body->gyroscopic && !isotropic(body->inertia)) return false;
        }
        kinds_ = arena_.take<LinkJoint>(int(work_.joints.size()));
        if (arena_.failed()) return false;
        bool any = false;
        for (std::size_t k = 0; k < kinds_.size(); ++k) {
            if (!is_held_by_still_bodies(system_.blocks[k])) return false;
            kinds_[k] = kind_of(*work_.joints[k]);
            if (!is_of_kind(system_.blocks[k], kinds_[k])) kinds_[k] = LinkJoint::kNone;
            any |= kinds_[k] != LinkJoint::kNone;
        }
        return any;
    }

    // What a kinematic body that moves holds would have to move with it.
    bool is_held_by_still_bodies(const RowBlock& block) const
    {
        if (block.term_count > 0 || (is_still(system_, block.body1) && is_still(system_, block.body2)))
            return true;
        const auto rows = system_.rows.subspan(std::size_t(block.first), std::size_t(block.count));
        return std::none_of(rows.begin(), rows.end(), is_equality);
    }

    // Do its first rows hold the joint?
    bool is_of_kind(const RowBlock& block, LinkJoint kind) const
    {
        const Real arms = length(block.arms.r1) + length(block.arms.r2) + kLeastArm;
        for (int i = 0; i < std::min(block.count, lock_rows(kind)); ++i)
            if (!is_rigid_and_closed(system_.rows[std::size_t(block.first + i)], arms,
                                     run_.world.projection_tolerance))
                return false;
        return block.count >= lock_rows(kind);
    }

    TreeOutcome finish()
    {
        motion_.advance();
        ProjectionReport projected;
        if (run_.world.projection_iterations > 0) run_.correct_poses([&] { projected = motion_.project(); });
        if (!motion_.settle_velocities()) return TreeOutcome::kNoMemory;
        run_.report_solution();
        if (!run_.is_sound()) return TreeOutcome::kRefused;
        run_.add_solution_to_ledger(false);
        write_back(work_, run_.tasks);
        run_.add_forces_to_ledger();
        keep_impulses(run_, {});
        if (run_.world.projection_iterations > 0)
            for (dIslandStepReport& report : run_.reports) report_projection(projected, report);
        return TreeOutcome::kMade;
    }

    static constexpr Real kLeastArm = Real(0.01);  // m
    static constexpr int kFewRows = 24;            // with a budget

    IslandRun& run_;
    IslandWork& work_;
    RowSystem& system_;
    Arena& arena_;
    std::span<LinkJoint> kinds_;
    JointTree tree_;
    ClosingRows closing_;
    TreeSolve solve_;
    TreeMotion motion_;
};

}  // namespace

bool may_be_tree(const IslandRun& run)
{
    return run.world.joint_coordinates && !run.world.acts_as_ode() && !run.work.island.joints.empty() &&
           !(has_budget(run) &&
             (touches(run.work.island) || int(run.work.island.bodies.size()) > kFewTreeBodies));
}

TreeOutcome step_in_tree(IslandRun& run)
{
    const RowSystem& system = run.work.system;
    if (run.has_parts() || !system.joint_contacts.manifolds.empty() || !system.contact_manifolds.empty() ||
        run.work.joints.empty())
        return TreeOutcome::kNotInTree;
    return TreeRun(run).step();
}

}  // namespace epode
