// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/positions/shake.h"

#include "dynamics/exact_spin.h"
#include "dynamics/integrate.h"
#include "joints/drive_rows.h"
#include "rows/policy.h"
#include "solve/exact/equalities.h"
#include "solve/solver.h"
#include "step/island/positions/position_rows.h"
#include "step/island/positions/solved_motion.h"

namespace epode {
namespace {

constexpr int kMaxIterations = 8;
constexpr Real kEnough = Real(1e-3);       // of the projection's tolerance
constexpr Real kGain = Real(0.25);         // of the sum of squares, that an iteration must reach
constexpr Real kLongestTurn = Real(0.02);  // opening relative to the lever, about (w h)^2/2
constexpr double kClosingGain = 0.1;       // of the kinetic energy
constexpr double kHarmless = 0.1;          // m/s, of all bodies
constexpr Real kSticks = Real(0.999);      // of its bound: friction that does not slide

bool is_free(const IslandWork& work) { return work.system.rows.empty() && work.contacts.empty(); }

void advance(const World& world, Body& body, Real h, bool free)
{
    turns_exactly(world, body) ? advance_pose_exactly(body, h, free || is_unattached(body))
                               : advance_pose(body, h);
}

class Shake {
  public:
    Shake(const World& world, IslandWork& work, const Tasks& tasks, SymbolicCache& symbolic_cache,
          Arena& arena)
        : world_(world),
          work_(work),
          tasks_(tasks),
          symbolic_cache_(symbolic_cache),
          arena_(arena),
          info_(step_info(world, work.system.h))
    {
        info_.inner = true;
    }

    // Before the poses are advanced. False: out of memory, or there is nothing to close.
    bool begin()
    {
        const int rows = int(work_.system.rows.size()), bodies = int(work_.system.bodies.size());
        system_.rows = arena_.take<Row>(rows), system_.numbers = arena_.take<RowNumbers>(rows);
        system_.blocks = arena_.take<RowBlock>(int(work_.system.blocks.size()));
        system_.bodies = arena_.take<SolverBody>(bodies);
        sources_ = arena_.take<int>(rows), closed_ = arena_.take<Closed>(rows);
        starts_ = arena_.take<Start>(bodies), solved_ = arena_.take<Real>(rows);
        if (arena_.failed()) return false;
        choose_rows();
        save_starts();
        return !closed_.empty();
    }

    bool run()
    {
        bool changed = false;
        const SolvedMotion solved = solved_motion(work_);
        save_solution();
        go();
        for (int i = 0; i < kMaxIterations && worst_ <= kLongestTurn && (i == 0 || !is_enough()); ++i) {
            const Real merit = merit_;
            if (!correct()) break;
            go_on(1);
            if (!(merit_ < kGain * merit)) {
                go_on(-1);
                break;
            }
            changed = true;
        }
        if (!changed) return false;
        if (throws(solved)) return take_back(), false;
        hold_velocities();
        if (throws(solved)) return take_back(), false;
        return true;
    }

  private:
    struct Start {
        Vec3 x;
        Quat q;
        Mat3 R;
        Vec3 excess;
        Vec3 v, w;  // of the solution
    };
    struct Closed {  // a row that holds a joint
        std::size_t block;
        int place;  // in the block
        int row;    // of the correction
        Real per_arm;
        Real expected;  // error at the end, to first order in the motion
        Real excess;    // of the error over that
    };

    Body& body(std::size_t i) const { return *work_.island.bodies[i]; }

    bool throws(const SolvedMotion& solved) const
    {
        return solved_motion(work_).energy >
               (1 + kClosingGain) * solved.energy + solved.mass * kHarmless * kHarmless;
    }
    bool is_enough() const { return worst_ <= kEnough * world_.projection_tolerance; }

    void choose_rows()
    {
        system_.h = work_.system.h, system_.terms = work_.system.terms;
        std::size_t count = 0, blocks = 0, closed = 0;
        for (std::size_t k = 0; k < work_.system.blocks.size(); ++k) {
            const RowBlock& block = work_.system.blocks[k];
            const std::size_t first = count;
            const Real per_arm = 1 / longest_arm(work_, block);
            for (int i = 0; i < block.count; ++i) {
                const auto source = std::size_t(block.first + i);
                const Row& row = work_.system.rows[source];
                if (!acts(work_.system.numbers[source])) continue;
                if (is_closed(row, block, work_.system))
                    closed_[closed++] = {
                        k, i, int(count), turns_only(row) ? Real(1) : per_arm, expected_error(row, block), 0};
                sources_[count] = int(source), system_.rows[count] = row;
                system_.numbers[count] = {}, system_.numbers[count].C = work_.system.numbers[source].C;
                ++count;
            }
            if (count == first) continue;
            RowBlock& to = system_.blocks[blocks++];
            to = block, to.first = int(first), to.count = int(count - first), to.coulomb = false;
        }
        system_.rows = system_.rows.first(count), system_.numbers = system_.numbers.first(count);
        system_.blocks = system_.blocks.first(blocks), closed_ = closed_.first(closed);
    }

    Real expected_error(const Row& row, const RowBlock& block) const
    {
        return row.error - system_.h * row_velocity(work_.system, block, row, work_.system.bodies);
    }

    bool acts(const RowNumbers& n) const
    {
        if (n.parent < 0) return n.p > n.lo && n.p < n.hi;
        return std::fabs(n.p) < kSticks * n.hi * work_.system.numbers[std::size_t(n.parent)].p;
    }

    void save_starts()
    {
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            const Body& b = body(i);
            starts_[i] = {b.position(), b.orientation(), b.rotation(), b.spin_excess, {}, {}};
        }
    }

    void save_solution()
    {
        for (std::size_t i = 0; i < starts_.size(); ++i)
            starts_[i].v = work_.system.bodies[i].v, starts_[i].w = work_.system.bodies[i].w;
        for (std::size_t i = 0; i < system_.numbers.size(); ++i)
            solved_[i] = work_.system.numbers[std::size_t(sources_[i])].p;
    }

    // Near a dead centre levers would have to fly to close.
    void take_back()
    {
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            SolverBody& to = work_.system.bodies[i];
            to.v = starts_[i].v, to.w = starts_[i].w;
            store(body(i).lvel, to.v), store(body(i).avel, to.w);
        }
        for (std::size_t i = 0; i < system_.numbers.size(); ++i)
            work_.system.numbers[std::size_t(sources_[i])].p = solved_[i];
        go();
    }

    // From the beginning with the present velocities.
    void go()
    {
        const bool free = is_free(work_);
        for (std::size_t i = 0; i < starts_.size(); ++i) {
            Body& b = body(i);
            store(b.pos, starts_[i].x), store_quat(b.q, starts_[i].q), store_mat(b.R, starts_[i].R);
            b.spin_excess = starts_[i].excess;
            advance(world_, b, system_.h, free);
        }
        measure();
    }

    void go_on(Real sign)
    {
        apply(sign);
        go();
    }

    void measure()
    {
        worst_ = merit_ = 0;
        for (Closed& row : closed_) row.excess = 0;
        for_closed([&](Closed& row, const Row& now) {
            row.excess = now.error - row.expected;
            const Real e = std::fabs(row.excess) * row.per_arm;
            worst_ = std::max(worst_, e), merit_ += e * e;
        });
    }

    // f(closed, the row as its joint has it at the present poses).
    template <typename F>
    void for_closed(F&& f)
    {
        Row now[kMaxBlockRows];
        std::size_t emitted = work_.system.blocks.size();
        int count = 0;
        for (Closed& row : closed_) {
            if (row.block != emitted) {
                RowWriter out(now, info_);
                emit_joint(*work_.joints[row.block], out);
                emitted = row.block, count = out.count();
            }
            if (row.place < count) f(row, now[row.place]);
        }
    }

    bool correct()
    {
        Arena::Scope scope(arena_);
        for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
            system_.bodies[i] = work_.system.bodies[i];
            system_.bodies[i].v = system_.bodies[i].w = {};
        }
        for (RowNumbers& n : system_.numbers) n.c = n.p = 0;
        for (const Closed& row : closed_) system_.numbers[std::size_t(row.row)].c = row.excess / system_.h;
        return solve();
    }

    bool solve()
    {
        if (system_.rows.size() > kFewRows) return solve_equalities(system_, &symbolic_cache_, arena_);
        ExactSettings settings;
        settings.tasks = tasks_;
        settings.symbolic_cache = &symbolic_cache_;
        SolveReport report;
        return solve_exactly(system_, settings, arena_, report);
    }

    // J(x') v = what the rows want, at the poses that have been reached.
    void hold_velocities()
    {
        Arena::Scope scope(arena_);
        const auto seen = arena_.take<SolverBody>(int(system_.bodies.size()));
        if (arena_.failed()) return;
        for (std::size_t i = 0; i < seen.size(); ++i) {
            const Body& b = body(i);
            SolverBody& s = system_.bodies[i];
            s = seen[i] = work_.system.bodies[i];
            s.v = s.w = {};
            if (b.kinematic()) continue;
            s.inertia = rotate(b.rotation(), b.inertia), s.inv_inertia = rotate(b.rotation(), b.inv_inertia);
            seen[i].w += Real(0.5) * (b.rotation() * (b.inv_inertia * b.spin_excess));
        }
        // Rows have their Jacobians of the end, which arms and forms of the beginning do not describe.
        for (RowBlock& block : system_.blocks) block.form = RowForm::kFree, block.point = false;
        for (RowNumbers& n : system_.numbers) n.c = n.p = 0;
        for_closed([&](Closed& closed, const Row& now) {
            const RowBlock& block = work_.system.blocks[closed.block];
            if (block.term_count > 0) return;
            Row& row = system_.rows[std::size_t(closed.row)];
            static_cast<Jacobian&>(row) = now;
            system_.numbers[std::size_t(closed.row)].c =
                wanted_velocity(row, 0) - row_velocity(work_.system, block, row, seen);
        });
        if (solve()) apply(1);
    }

    void apply(Real sign)
    {
        for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
            SolverBody& to = work_.system.bodies[i];
            to.v += sign * system_.bodies[i].v, to.w += sign * system_.bodies[i].w;
            store(body(i).lvel, to.v), store(body(i).avel, to.w);
        }
        for (std::size_t i = 0; i < system_.numbers.size(); ++i)
            work_.system.numbers[std::size_t(sources_[i])].p += sign * system_.numbers[i].p;
    }

    const World& world_;
    IslandWork& work_;
    const Tasks& tasks_;
    SymbolicCache& symbolic_cache_;
    Arena& arena_;
    StepInfo info_;
    RowSystem system_;        // of a correction
    std::span<int> sources_;  // rows of the step, parallel to its rows
    std::span<Closed> closed_;
    std::span<Start> starts_;
    std::span<Real> solved_;      // impulses, parallel to sources_
    Real worst_ = 0, merit_ = 0;  // largest e'/l, sum of its squares
};

}  // namespace

void advance_poses(const World& world, const IslandWork& work, Real h)
{
    const bool free = is_free(work);
    for (Body* body : work.island.bodies) advance(world, *body, h, free);
}

bool advance_closing(const World& world, IslandWork& work, const Tasks& tasks, SymbolicCache& symbolic_cache,
                     Arena& arena)
{
    Arena::Scope scope(arena);
    Shake shake(world, work, tasks, symbolic_cache, arena);
    if (shake.begin()) return shake.run();
    advance_poses(world, work, work.system.h);
    return false;
}

}  // namespace epode
