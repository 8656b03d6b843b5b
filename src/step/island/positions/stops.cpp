// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/positions/stops.h"

#include <algorithm>
#include <cmath>

#include "dynamics/integrate.h"
#include "rows/policy.h"
#include "step/island/positions/position_rows.h"

namespace epode {
namespace {

constexpr Real kLongestArm = 10;  // m, with which a body moves as fast as stops close
constexpr Real kSlow = kSingle ? Real(1e-4) : Real(1e-5);  // m/s or rad/s

bool is_motor(const Row& row) { return row.kind == RowKind::kLimit && row.lo != 0 && row.hi != 0; }

// The displacement that a row asks for; 0 of one that has only to hold.
Real closing(const World& world, const Row& row, Real h)
{
    const bool stop = row.kind == RowKind::kLimit;
    const bool beyond = (row.lo == 0 && row.error > 0) || (row.hi == 0 && row.error < 0);
    if (!stop || !beyond || row.given) return 0;
    const Real share = row.erp * row.error, limit = std::max(world.contact_max_vel, Real(0)) * h;
    return std::fabs(share) > kSlow * h ? std::clamp(share, -limit, limit) : 0;
}

class StopSystem {
  public:
    StopSystem(const World& world, const IslandWork& work, Arena& arena)
        : world_(world), work_(work), arena_(arena)
    {}

    // False: out of memory.
    bool prepare()
    {
        const RowSystem& from = work_.system;
        system_.rows = arena_.take<Row>(int(from.rows.size()));
        system_.numbers = arena_.take<RowNumbers>(int(from.rows.size()));
        system_.blocks = arena_.take<RowBlock>(int(from.blocks.size()));
        system_.bodies = arena_.take<SolverBody>(int(from.bodies.size()));
        parts_ = arena_.take<SystemPart>(int(from.parts.size()));
        system_.terms = from.terms;
        system_.h = 1;
        if (arena_.failed()) return false;
        std::copy(from.bodies.begin(), from.bodies.end(), system_.bodies.begin());
        for (SolverBody& body : system_.bodies) body.v = body.w = {};
        choose_rows();
        return true;
    }

    bool solve(SolveStops way, const Tasks& tasks) { return way(system_, world_, tasks, arena_); }

    // Islands that are stepped together know nothing of each other.
    void move() const
    {
        for (int part = 0; part < work_.system.worlds(); ++part)
            move(std::size_t(work_.system.begin_of(part).bodies),
                 std::size_t(work_.system.end_of(part).bodies));
    }

  private:
    // A body that is moved is not idle, whatever its velocity.
    void move(std::size_t from, std::size_t to) const
    {
        const auto bodies = system_.bodies.subspan(from, to - from);
        const Real share = std::min(largest_share(bodies), share_of_way(bodies));
        for (std::size_t i = from; i < to; ++i) {
            Body& body = *work_.island.bodies[i];
            const SolverBody& s = system_.bodies[i];
            if (body.kinematic() || !(share > 0)) continue;
            store(body.pos, body.position() + share * s.v);
            Quat q = turn_exactly(body.orientation(), s.w, share);
            if (normalize(q)) set_orientation(body, q);
            body.idle_steps_left = body.sleep.steps, body.idle_time_left = body.sleep.time;
        }
    }

    // Near a dead centre what closes a stop by 1 mm moves levers by a thousand times as much.
    Real share_of_way(std::span<const SolverBody> displacement) const
    {
        const Real limit = kLongestArm * world_.contact_max_vel * work_.system.h;
        Real longest = 0;
        for (const SolverBody& s : displacement) longest = std::max(longest, length(s.v));
        return longest > limit ? limit / longest : 1;
    }

    void choose_rows()
    {
        int rows = 0, blocks = 0;
        const RowSystem& from = work_.system;
        for (int part = 0; part < from.worlds(); ++part) {
            for (int i = from.begin_of(part).blocks; i < from.end_of(part).blocks; ++i)
                choose_rows_of(from.blocks[std::size_t(i)], rows, blocks);
            if (!parts_.empty()) parts_[std::size_t(part)] = {from.end_of(part).bodies, blocks, 0, 0};
        }
        system_.rows = system_.rows.first(std::size_t(rows));
        system_.numbers = system_.numbers.first(std::size_t(rows));
        system_.blocks = system_.blocks.first(std::size_t(blocks));
        system_.parts = parts_;
    }

    void choose_rows_of(const RowBlock& block, int& rows, int& blocks)
    {
        const int first = rows;
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = work_.system.rows[std::size_t(i)];
            if (row.kind == RowKind::kFriction || is_motor(row) || is_spring(row, block, work_.system))
                continue;
            system_.rows[std::size_t(rows)] = row;
            RowNumbers& n = system_.numbers[std::size_t(rows++)];
            n = {};
            n.c = closing(world_, row, work_.system.h);
            n.C = kSoftness * inverse_effective_mass(work_.system, block, row, work_.system.bodies);
            if (row.lo == 0) n.lo = 0;
            if (row.hi == 0) n.hi = 0;
        }
        if (rows == first) return;
        RowBlock& to = system_.blocks[std::size_t(blocks++)];
        to = {first, rows - first, block.body1, block.body2, block.contact, block.arms};
        to.first_term = block.first_term, to.term_count = block.term_count;
    }

    const World& world_;
    const IslandWork& work_;
    Arena& arena_;
    std::span<SystemPart> parts_;
    RowSystem system_;
};

}  // namespace

bool leave_stops_to_poses(const World& world, RowSystem& system)
{
    if (world.acts_as_ode() || !(world.contact_max_vel < kInf)) return false;
    bool any = false;
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = system.rows[std::size_t(i)];
            if (row.kind != RowKind::kLimit || closing(world, row, system.h) == 0) continue;
            if (is_spring(row, block, system)) continue;
            system.numbers[std::size_t(i)].c = wanted_velocity(row, 0);
            any = true;
        }
    return any;
}

void close_stops(const World& world, const IslandWork& work, SolveStops solve, const Tasks& tasks,
                 Arena& arena)
{
    Arena::Scope scope(arena);
    StopSystem stops(world, work, arena);
    if (stops.prepare() && stops.solve(solve, tasks)) stops.move();
}

}  // namespace epode
