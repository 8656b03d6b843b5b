// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Newton's method on the position errors e(x) of the rows that hold positions, in the metric of the masses:
//
//   minimise  dx^T M dx / 2   subject to   J(x) dx = e(x),   or >= e with a force >= 0 for stops and contacts
//   x <- x + a dx,  turns by the exponential map,  a = 1 (less, if dx is far more than e asks for), or halved until sum (e/l)^2 falls
//
// which is the box problem of a step with v* = 0, c = e, so the exact solver solves it, redundant and
// one-sided rows included; rows that contradict each other it leaves at their least squares. M contains the
// joints' tension (step/island/positions/tension): with the bare masses the metric would rather fold light links than move the
// load by what their shortening needs, and Newton's steps do not get there. l is a row's lever, so a
// tolerance is relative. No accepted step makes the errors worse; what is not accepted is taken back.
//
// Which rows: equalities and stops of joints, contact normals; not motors, friction, and what is a spring
// (its softness more than a thousandth of the row's inverse_mass). Errors are read from the joints at every
// pose; contacts, and rows whose error does not answer to the pose (Plane2D's rates, angles that the client
// hands in), follow the motion to first order: e <- e - J dx. What is beyond a stop or inside a contact is
// removed here and not by velocities, which would outlive the depth and throw the body off ("split impulses",
// Guendelman, Bridson & Fedkiw, 2003). Contacts lose their ERP's share of the depth in a step: all at once, a
// pile that is wedged pushes itself apart for ever. They keep half the tolerance, so that they are found
// again.
//
// Joints are closed by the impulses of the step itself (step/island/positions/shake.h). Here their rows only hold them while bodies are parted;
// where SHAKE leaves a joint open by more than kLongestTurn of its levers, these poses close it.
//
// Rotors of drives are part of M: each is a row that holds nothing, J dx + p/I = 0.
#include "step/island/positions/projection.h"

#include <algorithm>
#include <cmath>

#include "dynamics/integrate.h"
#include "joints/drive_rows.h"
#include "rows/policy.h"
#include "solve/exact/equalities.h"
#include "solve/solver.h"
#include "step/island/positions/asked.h"
#include "step/island/positions/free_momentum.h"
#include "step/island/positions/position_rows.h"
#include "step/island/positions/solved_motion.h"
#include "step/island/positions/tension.h"

namespace epode {
namespace {

constexpr Real kSpringShare = Real(1e-3);  // of the inverse_mass, above which softness is meant
constexpr Real kLongTurn = Real(0.03);     // opening relative to the lever, about (w h)^2/2
constexpr Real kReach = Real(0.05);        // of the lever, how far rows of contacts hold as they are
constexpr int kMaxHalvings = 5;
constexpr Real kSofter = 1000, kSoftest = Real(2e-3);  // in steps from kSoftness on
constexpr Real kClosed = Real(0.01);                   // of the tolerance, a gap that is none

// What a row of the projection needs besides its Row in the system.
struct Hold {
    int source;        // row of the step
    Real error;        // J dx = error
    Real per_arm;      // 1/l
    bool follows;      // the motion, as the pose does not determine its error
    Real inertia = 0;  // of a rotor, which holds nothing: J dx + p/inertia = 0 is its share of the metric
};

// Blocks of joints between two bodies at most.
bool has_equalities(const RowBlock& block) { return !block.contact && block.term_count == 0; }

bool has_rotor(const Row& row) { return row.drive && row.drive->inertia > 0; }

struct PoseBefore {
    Vec3 p;
    Quat q;
};

class Projection {
  public:
    Projection(const World& world, const IslandWork& work, SymbolicCache& symbolic_cache, Arena& arena)
        : world_(world),
          work_(work),
          symbolic_cache_(symbolic_cache),
          arena_(arena),
          info_(step_info(world, work.system.h))
    {
        info_.inner = true;
    }

    // False: out of memory, or nothing to hold.
    bool prepare()
    {
        const int rows = int(work_.system.rows.size()), blocks = int(work_.system.blocks.size());
        const int bodies = int(work_.system.bodies.size());
        holds_ = arena_.take<Hold>(rows);
        before_ = arena_.take<Hold>(rows);
        system_.rows = arena_.take<Row>(rows);
        system_.numbers = arena_.take<RowNumbers>(rows);
        system_.blocks = arena_.take<RowBlock>(blocks);
        from_ = arena_.take<int>(blocks);
        system_.bodies = arena_.take<SolverBody>(bodies);
        poses_ = arena_.take<PoseBefore>(bodies);
        system_.terms = arena_.take<WideTerm>(int(work_.system.terms.size()));
        system_.h = 1;
        if (arena_.failed()) return false;
        std::copy(work_.system.terms.begin(), work_.system.terms.end(), system_.terms.begin());
        choose_rows();
        return !system_.rows.empty();
    }

    ProjectionReport run(const Tasks& tasks)
    {
        ProjectionReport report;
        measure();
        while (worst_ > world_.projection_tolerance && report.iterations < world_.projection_iterations) {
            ++report.iterations;
            if (!improve(tasks)) break;
        }
        report.error = double(worst_);
        report.open = worst_ > world_.projection_tolerance;
        return report;
    }

  private:
    const SolverBody& step_body(int i) const { return work_.system.bodies[std::size_t(i)]; }
    const Row& step_row(const Hold& hold) const { return work_.system.rows[std::size_t(hold.source)]; }
    Body& body(std::size_t i) const { return *work_.island.bodies[i]; }

    void choose_rows()
    {
        int rows = 0, blocks = 0;
        Row now[kMaxBlockRows];
        for (std::size_t k = 0; k < work_.system.blocks.size(); ++k) {
            const RowBlock& block = work_.system.blocks[k];
            RowWriter out(now, info_);
            if (!block.contact) emit_joint(*work_.joints[k], out);
            const int first = rows;
            choose_rows_of(int(k), {now, std::size_t(out.count())}, rows);
            if (rows == first) continue;
            from_[std::size_t(blocks)] = int(k);
            RowBlock& to = system_.blocks[std::size_t(blocks++)];
            to = {first, rows - first, block.body1, block.body2, block.contact, block.arms};
            to.first_term = block.first_term, to.term_count = block.term_count;
        }
        system_.rows = system_.rows.first(std::size_t(rows));
        system_.numbers = system_.numbers.first(std::size_t(rows));
        system_.blocks = system_.blocks.first(std::size_t(blocks));
        holds_ = holds_.first(std::size_t(rows));
    }

    // Of block k; `now`: its rows at the present pose, if it is a joint's.
    void choose_rows_of(int k, std::span<const Row> now, int& rows)
    {
        const RowBlock& block = work_.system.blocks[std::size_t(k)];
        const Real per_arm = 1 / longest_arm(work_, block);
        for (int i = 0; i < block.count; ++i) {
            const Row& row = work_.system.rows[std::size_t(block.first + i)];
            const bool is_new = std::size_t(i) < now.size();
            Hold& hold = holds_[std::size_t(rows)];
            if (has_rotor(row) && has_equalities(block)) {
                hold = {block.first + i, 0, 0, false, row.drive->inertia};
            } else if (holds_position(row, block)) {
                const bool follows = !is_new || row.given;
                const bool turns = row.lin1 == Vec3{} && row.lin2 == Vec3{};
                hold = {block.first + i, 0, turns ? Real(1) : per_arm, follows};
                hold.error = follows ? row.error - motion(row, block) : now[std::size_t(i)].error;
                one_sided_ |= row.lo == 0 || row.hi == 0;
                if (row.kind == RowKind::kNormal) aim_at_depth(row, k, per_arm, hold);
            } else {
                continue;
            }
            system_.rows[std::size_t(rows++)] = is_new ? now[std::size_t(i)] : row;
        }
    }

    void aim_at_depth(const Row& normal, int block, Real per_arm, Hold& hold) const
    {
        // An open point of a manifold has its gap as a velocity (step/island/problem/manifold_rows).
        if (std::size_t(block) >= work_.joints.size())
            hold.error += work_.system.h * std::min(normal.speed, Real(0));
        hold.error -= world_.projection_tolerance / 2 / per_arm;
        const Real share = std::min(normal.erp, Real(1));
        // The tolerance is one of the depth, not of the share that this step removes.
        if (hold.error > 0 && share > 0) hold.error *= share, hold.per_arm /= share;
        if (!(share > 0)) hold.error = std::min(hold.error, Real(0));
    }

    bool holds_position(const Row& row, const RowBlock& block) const
    {
        if (row.kind == RowKind::kFriction) return false;
        if (row.kind == RowKind::kLimit && row.lo != 0 && row.hi != 0) return false;  // a motor
        return !is_spring(row, block, work_.system);
    }

    // J times the step's displacement.
    Real motion(const Row& row, const RowBlock& block) const
    {
        if (block.term_count > 0) {
            Real rate = 0;
            for (const WideTerm& term : terms_of(work_.system, block)) {
                const Body& b = body(std::size_t(term.body));
                rate += dot(term.lin, b.velocity()) + dot(term.ang, b.angular_velocity());
            }
            return work_.system.h * rate;
        }
        const Body& a = body(std::size_t(block.body1));
        Real s = dot(row.lin1, a.velocity()) + dot(row.ang1, a.angular_velocity());
        if (block.body2 >= 0) {
            const Body& b = body(std::size_t(block.body2));
            s += dot(row.lin2, b.velocity()) + dot(row.ang2, b.angular_velocity());
        }
        return work_.system.h * s;
    }

    void measure()
    {
        worst_ = merit_ = 0;
        for (const Hold& hold : holds_) {
            const Real e = to_close(hold) * hold.per_arm;
            worst_ = std::max(worst_, e);
            merit_ += e * e;
        }
    }

    Real to_close(const Hold& hold) const
    {
        const Row& row = step_row(hold);
        const Real e = hold.error;
        return row.lo == 0 ? std::max(e, Real(0)) : row.hi == 0 ? std::max(-e, Real(0)) : std::fabs(e);
    }

    // Of a Newton step: that with which m d^2 is at most twice what all errors could ask of all bodies at once (asked.h). What is
    // wedged would be carried away for them.
    Real share_that_errors_ask_for() const
    {
        Asked asked;
        for (const Hold& hold : holds_) asked.add(step_row(hold), double(to_close(hold)));
        double moved = 0;
        for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
            const SolverBody& s = system_.bodies[i];
            if (!moves_by_itself(s))
                moved += 2 * kinetic_of(body(i), s.v, transposed_times(body(i).rotation(), s.w));
        }
        const double allowed = 2 * energy_of(asked, work_, 0);
        return moved > allowed ? Real(std::sqrt(allowed / moved)) : Real(1);
    }

    // One Newton step; false: none that makes the errors smaller.
    bool improve(const Tasks& tasks)
    {
        Arena::Scope scope(arena_);
        load_bodies();
        if (!solve_within_reach(tasks)) return false;
        const Real merit = merit_;
        Real share = std::min(largest_share(system_.bodies), share_that_errors_ask_for());
        if (!(share > 0)) return false;  // no pose has moved: 0 * NaN would move them
        std::copy(holds_.begin(), holds_.end(), before_.begin());
        for (int k = 0; k <= kMaxHalvings; ++k, share /= 2) {
            move(share);
            if (merit_ < merit) return true;
        }
        move(0);
        return false;
    }

    // Contacts that contradict each other, a crate between two rams, agree in the far distance where their normals differ by
    // rounding: softer rows do not look so far (Levenberg and Marquardt), and leave the least squares.
    bool solve_within_reach(const Tasks& tasks)
    {
        for (softness_ = kSoftness; softness_ <= kSoftest; softness_ *= kSofter) {
            load_numbers();
            if (!solve(tasks)) return false;
            if (is_within_reach()) return true;
            load_bodies();
        }
        return false;
    }

    // Contacts follow the motion to first order, a share of the lever; what lies on others moves by the errors of all.
    bool is_within_reach() const
    {
        Real errors = 0;
        for (const Hold& hold : holds_) errors += hold.follows ? std::fabs(hold.error) : 0;
        for (std::size_t k = 0; k < system_.blocks.size(); ++k) {
            const RowBlock& block = system_.blocks[k];
            if (!block.contact) continue;
            const Real reach =
                kReach * longest_arm(work_, work_.system.blocks[std::size_t(from_[k])]) + errors;
            for (const int at : {block.body1, block.body2})
                if (at >= 0 && length(system_.bodies[std::size_t(at)].v) > reach) return false;
        }
        return true;
    }

    bool solve(const Tasks& tasks)
    {
        const bool small = system_.rows.size() <= kFewRows;
        if (!one_sided_ && !small) return solve_equalities(system_, &symbolic_cache_, arena_);
        ExactSettings settings;
        settings.tasks = tasks;
        settings.symbolic_cache = &symbolic_cache_;
        SolveReport report;
        return solve_exactly(system_, settings, arena_, report);
    }

    void load_bodies()
    {
        for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
            const Body& b = body(i);
            poses_[i] = {b.position(), b.orientation()};
            SolverBody& s = system_.bodies[i];
            s = work_.system.bodies[i];
            s.v = s.w = {};
            if (b.kinematic()) continue;
            s.inertia = rotate(b.rotation(), b.inertia);
            s.inv_inertia = rotate(b.rotation(), b.inv_inertia);
        }
        add_tension(work_, system_.bodies, work_.system.h, kResolvedExactly, arena_);
    }

    void load_numbers()
    {
        for (const RowBlock& block : system_.blocks)
            for (int i = block.first; i < block.first + block.count; ++i) {
                const Row& row = system_.rows[std::size_t(i)];
                const Row& bounds = step_row(holds_[std::size_t(i)]);
                RowNumbers& n = system_.numbers[std::size_t(i)];
                n = {};
                const Hold& hold = holds_[std::size_t(i)];
                n.c = hold.error;
                n.C = hold.inertia > 0
                          ? 1 / hold.inertia
                          : softness_ * inverse_effective_mass(system_, block, row, system_.bodies);
                if (bounds.lo == 0) n.lo = 0;
                if (bounds.hi == 0) n.hi = 0;
            }
    }

    // Poses and errors after that share of the step.
    void move(Real share)
    {
        for (std::size_t i = 0; i < poses_.size(); ++i) {
            Body& b = body(i);
            if (b.kinematic()) continue;
            const SolverBody& s = system_.bodies[i];
            store(b.pos, poses_[i].p + share * s.v);
            Quat q = turn_exactly(poses_[i].q, s.w, share);
            if (normalize(q)) set_orientation(b, q);
        }
        for (std::size_t k = 0; k < system_.blocks.size(); ++k) update(k, share);
        measure();
    }

    void update(std::size_t k, Real share)
    {
        const RowBlock& block = system_.blocks[k];
        Row now[kMaxBlockRows];
        RowWriter out(now, info_);
        if (!block.contact) emit_joint(*work_.joints[std::size_t(from_[k])], out);
        if (block.term_count > 0) place_terms(out.terms(), system_, block);
        const int base = work_.system.blocks[std::size_t(from_[k])].first;
        for (int i = block.first; i < block.first + block.count; ++i) {
            Hold& hold = holds_[std::size_t(i)];
            Row& row = system_.rows[std::size_t(i)];
            if (hold.follows) {
                hold.error =
                    before_[std::size_t(i)].error - share * row_velocity(system_, block, row, system_.bodies);
            } else if (const int at = hold.source - base; at < out.count()) {
                if (!(hold.inertia > 0)) hold.error = now[at].error;
                static_cast<Jacobian&>(row) = now[at];
            }
        }
    }

    const World& world_;
    const IslandWork& work_;
    SymbolicCache& symbolic_cache_;
    Arena& arena_;
    StepInfo info_;
    RowSystem system_;                // of one Newton step
    std::span<Hold> holds_, before_;  // parallel to its rows
    std::span<int> from_;             // block of the step that a block is of
    std::span<PoseBefore> poses_;
    bool one_sided_ = false;
    Real softness_ = kSoftness;   // of the inverse effective mass
    Real worst_ = 0, merit_ = 0;  // largest e/l, sum of its squares
};

// Of hard contacts that carry one thing together the one with the least gap would have all of the load, by a nanometre. Wider gaps
// must close: a ball that rolls down a bowl follows it through them.
bool is_closed(const Row& normal, const RowBlock& block, const World& world, const IslandWork& work)
{
    return -normal.speed * work.system.h <= kClosed * world.projection_tolerance * longest_arm(work, block);
}

}  // namespace

void leave_depth_to_projection(const World& world, const IslandWork& work)
{
    const RowSystem& system = work.system;
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = system.rows[std::size_t(i)];
            const bool beyond = (row.lo == 0 && row.error > 0) || (row.hi == 0 && row.error < 0);
            Real& c = system.numbers[std::size_t(i)].c;
            if (beyond && !is_spring(row, block, system))
                c = wanted_velocity(row, 0);
            else if (c < 0 && row.kind == RowKind::kNormal && is_closed(row, block, world, work))
                c = 0;
        }
}

ProjectionReport project_poses(const World& world, const IslandWork& work, const Tasks& tasks,
                               SymbolicCache& symbolic_cache, Arena& arena)
{
    Arena::Scope scope(arena);
    Projection projection(world, work, symbolic_cache, arena);
    if (!projection.prepare()) return {};
    const FreeMomentum momentum(work);
    const ProjectionReport report = projection.run(tasks);
    if (report.iterations > 0) momentum.restore();
    return report;
}

}  // namespace epode
