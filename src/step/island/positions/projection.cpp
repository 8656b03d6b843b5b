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
// Which rows, and how their errors are read: held_rows.h. What is beyond a stop or inside a contact is removed here and not by velocities,
// which would outlive the depth and throw the body off ("split impulses", Guendelman, Bridson & Fedkiw, 2003).
//
// Joints are closed by the impulses of the step itself (step/island/positions/shake.h). Here their rows only hold them while bodies are parted;
// where SHAKE leaves a joint open by more than kLongestTurn of its levers, these poses close it.
#include "step/island/positions/projection.h"

#include <algorithm>
#include <cmath>

#include "dynamics/integrate.h"
#include "rows/policy.h"
#include "solve/exact/equalities.h"
#include "solve/solver.h"
#include "step/island/positions/free_momentum.h"
#include "step/island/positions/held_rows.h"
#include "step/island/positions/position_rows.h"
#include "step/island/positions/solved_motion.h"
#include "step/island/positions/tension.h"

namespace epode {
namespace {

constexpr Real kReach = Real(0.05);  // of the lever, how far rows of contacts hold as they are
constexpr int kMaxHalvings = 5;
constexpr Real kSofter = 1000, kSoftest = Real(2e-3);  // in steps from kSoftness on
constexpr Real kClosed = Real(0.01);                   // of the tolerance, a gap that is none

struct PoseBefore {
    Vec3 p;
    Quat q;
};

class Projection {
  public:
    Projection(const World& world, const IslandWork& work, SymbolicCache& symbolic_cache, Arena& arena)
        : world_(world), work_(work), symbolic_cache_(symbolic_cache), arena_(arena), held_(world, work)
    {}

    // False: out of memory, or nothing to hold.
    bool prepare()
    {
        const int bodies = int(work_.system.bodies.size());
        system_.bodies = arena_.take<SolverBody>(bodies), poses_ = arena_.take<PoseBefore>(bodies);
        system_.h = 1;
        return held_.choose(arena_, system_) && !arena_.failed();
    }

    ProjectionReport run(const Tasks& tasks)
    {
        ProjectionReport report;
        while (held_.worst() > world_.projection_tolerance &&
               report.iterations < world_.projection_iterations) {
            ++report.iterations;
            if (!improve(tasks)) break;
        }
        report.error = double(held_.worst());
        report.open = held_.worst() > world_.projection_tolerance;
        return report;
    }

  private:
    Body& body(std::size_t i) const { return *work_.island.bodies[i]; }

    // Of a Newton step: that with which m d^2 is at most twice what all errors could ask of all bodies at once (asked.h), and what joints
    // ask at most that of kCorrecting. What is wedged would be carried away for them.
    Real share_that_errors_ask_for() const
    {
        double moved = 0, mass = 0;
        for (std::size_t i = 0; i < system_.bodies.size(); ++i) {
            const SolverBody& s = system_.bodies[i];
            if (moves_by_itself(s)) continue;
            moved += 2 * kinetic_of(body(i), s.v, transposed_times(body(i).rotation(), s.w));
            mass += double(body(i).mass.mass);
        }
        const double furthest = double(kCorrecting * work_.system.h);
        const double allowed =
            2 * energy_of(held_.asked(true), work_, 0) +
            std::min(2 * energy_of(held_.asked(false), work_, 0), mass * furthest * furthest);
        return moved > allowed ? Real(std::sqrt(allowed / moved)) : Real(1);
    }

    // One Newton step; false: none that makes the errors smaller.
    bool improve(const Tasks& tasks)
    {
        Arena::Scope scope(arena_);
        load_bodies();
        Real share = solve_within_reach(tasks);
        if (!(share > 0)) return false;
        const Real merit = held_.merit();
        share = std::min({share, largest_share(system_.bodies), share_that_errors_ask_for()});
        if (!(share > 0)) return false;  // no pose has moved: 0 * NaN would move them
        held_.begin();
        for (int k = 0; k <= kMaxHalvings; ++k, share /= 2) {
            move(share);
            if (held_.merit() < merit) return true;
        }
        move(0);
        return false;
    }

    // Contacts that contradict each other, a crate between two rams, agree in the far distance where their normals differ by
    // rounding: softer rows do not look so far (Levenberg and Marquardt), and leave the least squares. What is far beyond a stop, and takes along
    // what stands on it, goes there by as much as contacts reach in a step. Returns the share of the solution that is within reach; 0: none.
    Real solve_within_reach(const Tasks& tasks)
    {
        for (Real softness = kSoftness;; softness *= kSofter) {
            held_.load_numbers(system_, softness);
            if (!solve(tasks)) return 0;
            const Real share = share_within_reach();
            if (share >= 1 || softness * kSofter > kSoftest) return share;
            load_bodies();
        }
    }

    // Contacts follow the motion to first order, a share of the lever; what lies on others moves by the errors of all.
    Real share_within_reach() const
    {
        const Real errors = held_.followed_errors();
        Real share = 1;
        for (std::size_t k = 0; k < system_.blocks.size(); ++k) {
            const RowBlock& block = system_.blocks[k];
            if (!block.contact) continue;
            const Real reach = kReach * longest_arm(work_, held_.source_of(k)) + errors;
            for (const int at : {block.body1, block.body2})
                if (at >= 0) share = within(share, reach, length(system_.bodies[std::size_t(at)].v));
        }
        return share;
    }
    static Real within(Real share, Real reach, Real way) { return share * way > reach ? reach / way : share; }

    bool solve(const Tasks& tasks)
    {
        const bool small = system_.rows.size() <= kFewRows;
        if (!held_.one_sided() && !small) return solve_equalities(system_, &symbolic_cache_, arena_);
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
        held_.follow(system_, share);
    }

    const World& world_;
    const IslandWork& work_;
    SymbolicCache& symbolic_cache_;
    Arena& arena_;
    HeldRows held_;
    RowSystem system_;  // of one Newton step
    std::span<PoseBefore> poses_;
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
