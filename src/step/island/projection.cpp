// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Newton's method on the position errors e(x) of the rows that hold positions, in the metric of the masses:
//
//   minimise  dx^T M dx / 2   subject to   J(x) dx = e(x),   or >= e with a force >= 0 for stops and contacts
//   x <- x + a dx,  turns by the exponential map,  a = 1, or halved until sum (e/l)^2 falls
//
// which is the box problem of a step with v* = 0, c = e, so the exact solver solves it, redundant and
// one-sided rows included; rows that contradict each other it leaves at their least squares. M contains the
// joints' tension (step/island/tension): with the bare masses the metric would rather fold light links than move the
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
// The next step's solve projects the velocities onto the constraints of the corrected pose, and that takes
// energy: of a spin w the share (w h)^2, from a pendulum 30 % in 20 s with steps of 5 ms. So the velocities take
// the impulses of the projection, too, along the rows J0 of the step (SHAKE, Ryckaert, Ciccotti & Berendsen,
// J. Comp. Phys. 23, 1977):
//
//   v <- v + s M^-1 J0^T mu/h,     mu: of the equalities of joints, summed over Newton's steps
//
// With s = 1 energy grows without bound once a load of a hundred links shakes the chain. Therefore s is such
// that no more comes back than these rows have taken in this step, and 0 where SHAKE has no business: joints
// that the step opened by more than kLongTurn of their levers, and raised masses (tension). Rejected: mu along
// the new rows, which the next solve takes away again.
//
// Rotors of drives are part of M: each is a row that holds nothing, J dx + p/I = 0.
#include "step/island/projection.h"

#include <algorithm>
#include <cmath>

#include "dynamics/integrate.h"
#include "joints/drive_rows.h"
#include "rows/policy.h"
#include "solve/exact/equalities.h"
#include "step/island/tension.h"

namespace epode {
namespace {

constexpr Real kSpringShare = Real(1e-3);            // of the inverse_mass, above which softness is meant
constexpr double kSoftness = kSingle ? 1e-6 : 1e-9;  // of the inverse_mass, for redundant rows
constexpr Real kLargestTurn = 1;                     // rad, of one Newton step
constexpr Real kLongTurn = Real(0.03);               // opening relative to the lever, about (w h)^2/2
constexpr int kRotorSweeps = 20;
constexpr Real kRotorChange = Real(1e-4);  // of the largest impulse: enough sweeps
constexpr std::size_t kFewRows = 64;
constexpr int kMaxHalvings = 5;

// What a row of the projection needs besides its Row in the system.
struct Hold {
    int source;        // row of the step
    Real error;        // J dx = error
    Real per_arm;      // 1/l
    bool follows;      // the motion, as the pose does not determine its error
    Real inertia = 0;  // of a rotor, which holds nothing: J dx + p/inertia = 0 is its share of the metric
    Real freedom = 0;  // inverse effective mass at a rotor
};

bool is_spring(const Row& row, const RowBlock& block, const RowSystem& system)
{
    if (row.drive) return true;
    return row.cfm / system.h > kSpringShare * inverse_effective_mass(system, block, row, system.bodies);
}

// Holds a joint together, and nothing else.
bool is_equality(const Row& row)
{
    return row.kind == RowKind::kLock && row.lo == -kInf && row.hi == kInf && !row.drive;
}

// Blocks of joints between two bodies at most.
bool has_equalities(const RowBlock& block) { return !block.contact && block.term_count == 0; }

bool has_rotor(const Row& row) { return row.drive && row.drive->inertia > 0; }

// What the joints' equalities have taken of the energy of motion in the step.
Real lost_to_joints(const IslandWork& work, std::span<const Velocity> starts)
{
    Real taken = 0;
    for (const RowBlock& block : work.system.blocks)
        for (int i = block.first; has_equalities(block) && i < block.first + block.count; ++i) {
            const Row& row = work.system.rows[std::size_t(i)];
            if (!is_equality(row)) continue;
            const auto rate = [&](int body, Vec3 lin, Vec3 ang) {
                if (body < 0) return Real(0);
                const Velocity& start = starts[std::size_t(body)];
                const SolverBody& end = work.system.bodies[std::size_t(body)];
                return dot(lin, start.v + end.v) + dot(ang, start.w + end.w);
            };
            const Real u = rate(block.body1, row.lin1, row.ang1) + rate(block.body2, row.lin2, row.ang2);
            taken -= work.system.numbers[std::size_t(i)].p * u / 2;
        }
    return taken;
}

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
        impulses_ = arena_.take_zeroed<Real>(rows);
        change_ = arena_.take<SolverBody>(bodies);
        turning_ = arena_.take_zeroed<Real>(rows);
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
        opened_ = worst_;
        while (worst_ > world_.projection_tolerance && report.iterations < world_.projection_iterations) {
            ++report.iterations;
            if (!improve(tasks)) break;
        }
        report.error = double(worst_);
        report.open = worst_ > world_.projection_tolerance;
        return report;
    }

    // True: velocities have changed, and impulses of the step with them.
    bool turn_velocities(std::span<const Velocity> starts)
    {
        if (!(opened_ <= kLongTurn)) return false;
        const Real lost = lost_to_joints(work_, starts);
        if (!(lost > 0)) return false;
        set_change();
        const Real s = share_within(lost);
        if (!(s > 0)) return false;
        for (std::size_t i = 0; i < change_.size(); ++i) {
            SolverBody& end = work_.system.bodies[i];
            end.v += s * change_[i].v, end.w += s * change_[i].w;
            store(body(i).lvel, end.v), store(body(i).avel, end.w);
        }
        for (std::size_t i = 0; i < holds_.size(); ++i)
            work_.system.numbers[std::size_t(holds_[i].source)].p += s * turning_[i];
        return true;
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
            const Real per_arm = 1 / longest_arm(block);
            for (int i = 0; i < block.count; ++i) {
                const Row& row = work_.system.rows[std::size_t(block.first + i)];
                if (has_rotor(row) && has_equalities(block)) {
                    holds_[std::size_t(rows)] = {block.first + i, 0, 0, false, row.drive->inertia};
                    system_.rows[std::size_t(rows++)] = i < out.count() ? now[i] : row;
                    continue;
                }
                if (!holds_position(row, block)) continue;
                const bool follows = i >= out.count() || now[i].error == row.error;
                const bool turns = row.lin1 == Vec3{} && row.lin2 == Vec3{};
                Hold& hold = holds_[std::size_t(rows)];
                hold = {block.first + i, 0, turns ? Real(1) : per_arm, follows};
                hold.error = follows ? row.error - motion(row, block) : now[i].error;
                one_sided_ |= row.lo == 0 || row.hi == 0;
                if (row.kind == RowKind::kNormal) {
                    // An open point of a manifold has its gap as a velocity (step/island/manifold_rows).
                    if (k >= work_.joints.size()) hold.error += work_.system.h * std::min(row.speed, Real(0));
                    hold.error -= world_.projection_tolerance / 2 / per_arm;
                    const Real share = std::min(row.erp, Real(1));
                    // The tolerance is one of the depth, not of the share that this step removes.
                    if (hold.error > 0 && share > 0) hold.error *= share, hold.per_arm /= share;
                    if (!(share > 0)) hold.error = std::min(hold.error, Real(0));
                }
                system_.rows[std::size_t(rows++)] = i < out.count() ? now[i] : row;
            }
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

    bool holds_position(const Row& row, const RowBlock& block) const
    {
        if (row.kind == RowKind::kFriction) return false;
        if (row.kind == RowKind::kLimit && row.lo != 0 && row.hi != 0) return false;  // a motor
        return !is_spring(row, block, work_.system);
    }

    // The longest lever arm of the block's rows, but not less than its bodies' radius of gyration.
    Real longest_arm(const RowBlock& block) const
    {
        Real longest = 0;
        for (int k = 0; k < 2; ++k) {
            const int at = k == 0 ? block.body1 : block.body2;
            if (at < 0 || body(std::size_t(at)).kinematic()) continue;
            const Body& b = body(std::size_t(at));
            const Real largest = std::max(b.inertia.xx, std::max(b.inertia.yy, b.inertia.zz));
            longest = std::max(longest, std::sqrt(largest * b.inv_mass));
            for (int i = block.first; i < block.first + block.count; ++i) {
                const Row& row = work_.system.rows[std::size_t(i)];
                if (!(row.lin1 == Vec3{})) longest = std::max(longest, length(k == 0 ? row.ang1 : row.ang2));
            }
        }
        return longest > 0 ? longest : 1;
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
            const Row& row = step_row(hold);
            Real e = hold.error;
            e = row.lo == 0 ? std::max(e, Real(0)) : row.hi == 0 ? std::max(-e, Real(0)) : std::fabs(e);
            e *= hold.per_arm;
            worst_ = std::max(worst_, e);
            merit_ += e * e;
        }
    }

    // One Newton step; false: none that makes the errors smaller.
    bool improve(const Tasks& tasks)
    {
        Arena::Scope scope(arena_);
        load_bodies();
        load_numbers();
        if (!solve(tasks)) return false;
        const Real merit = merit_;
        Real share = first_share();
        if (!(share > 0)) return false;  // no pose has moved: 0 * NaN would move them
        std::copy(holds_.begin(), holds_.end(), before_.begin());
        for (int k = 0; k <= kMaxHalvings; ++k, share /= 2) {
            move(share);
            if (merit_ < merit) return note_impulses(share), true;
        }
        move(0);
        return false;
    }

    bool solve(const Tasks& tasks)
    {
        const bool small = system_.rows.size() <= kFewRows;  // kDirect has a shorter way
        if (!one_sided_ && !small) return solve_equalities(system_, &symbolic_cache_, arena_);
        SolverSettings settings;
        settings.tasks = tasks;
        settings.symbolic_cache = &symbolic_cache_;
        SolveReport report;
        return kDirect.solve(system_, settings, arena_, report);
    }

    void note_impulses(Real share)
    {
        for (std::size_t i = 0; i < holds_.size(); ++i) impulses_[i] += share * system_.numbers[i].p;
    }

    // f(block, row of the projection, row of the step) for those that are such.
    template <typename F>
    void for_rows(bool (*wanted)(const Row&), F&& f) const
    {
        for (const RowBlock& block : system_.blocks)
            for (int i = block.first; has_equalities(block) && i < block.first + block.count; ++i)
                if (const Row& row = step_row(holds_[std::size_t(i)]); wanted(row))
                    f(block, std::size_t(i), row);
    }

    // dv = M^-1 J0^T mu/h, where each rotor resists by I J dv: by Gauss-Seidel.
    void set_change()
    {
        std::copy(work_.system.bodies.begin(), work_.system.bodies.end(), change_.begin());
        for (SolverBody& body : change_) body.v = body.w = {};
        for_rows(&is_equality, [&](const RowBlock& block, std::size_t i, const Row& row) {
            turn(block, i, row, impulses_[i] / work_.system.h);
        });
        Real largest = 0, change = kInf;
        for_rows(&has_rotor, [&](const RowBlock& block, std::size_t i, const Row& row) {
            holds_[i].freedom = inverse_effective_mass(system_, block, row, change_);
        });
        for (int sweep = 0; sweep < kRotorSweeps && change > kRotorChange * largest; ++sweep) {
            change = 0;
            for_rows(&has_rotor, [&](const RowBlock& block, std::size_t i, const Row& row) {
                const Real I = holds_[i].inertia, u = row_velocity(system_, block, row, change_);
                const Real p = -(I * u + turning_[i]) / (1 + I * holds_[i].freedom);
                turn(block, i, row, p);
                change = std::max(change, std::fabs(p)), largest = std::max(largest, std::fabs(turning_[i]));
            });
        }
    }

    void turn(const RowBlock& block, std::size_t i, const Row& row, Real p)
    {
        turning_[i] += p;
        apply_impulse(system_, block, row, p, change_);
    }

    // The largest share of the change, up to 1, that raises the energy by no more than that:
    //   s a + s^2 b/2 <= energy,   a = v.M dv,  b = dv.M dv,  with rotors in M
    Real share_within(Real energy) const
    {
        Real a = 0, b = 0;
        for (std::size_t i = 0; i < change_.size(); ++i) {
            const SolverBody &dv = change_[i], &end = work_.system.bodies[i];
            const Vec3 P = dv.mass * dv.v, L = dv.inertia * dv.w;
            a += dot(P, end.v) + dot(L, end.w);
            b += dot(P, dv.v) + dot(L, dv.w);
        }
        for_rows(&has_rotor, [&](const RowBlock& block, std::size_t i, const Row& row) {
            const Real u = row_velocity(system_, block, row, change_);
            a += holds_[i].inertia * u * row_velocity(system_, block, row, work_.system.bodies);
            b += holds_[i].inertia * u * u;
        });
        if (!usable(a) || !usable(b)) return 0;
        if (a + b / 2 <= energy) return 1;
        return std::min(Real(1), 2 * energy / (a + std::sqrt(a * a + 2 * b * energy)));
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
        add_tension(work_, system_.bodies, work_.system.h, arena_);
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
                          : Real(kSoftness) * inverse_effective_mass(system_, block, row, system_.bodies);
                if (bounds.lo == 0) n.lo = 0;
                if (bounds.hi == 0) n.hi = 0;
            }
    }

    // The share of the step with which no body turns further than kLargestTurn; 0: the step is not finite.
    Real first_share() const
    {
        Real largest = 0;
        for (const SolverBody& s : system_.bodies) {
            const Real turn = length(s.w), way = length(s.v);
            if (!usable(turn) || !usable(way)) return 0;
            largest = std::max(largest, turn);
        }
        return largest > kLargestTurn ? kLargestTurn / largest : 1;
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
    std::span<Real> impulses_;      // of the rows, of all steps
    std::span<SolverBody> change_;  // of the bodies' velocities, with s = 1
    std::span<Real> turning_;       // impulses of the rows that make it
    Real opened_ = 0;               // worst_ at the beginning
    bool one_sided_ = false;
    Real worst_ = 0, merit_ = 0;  // largest e/l, sum of its squares
};

}  // namespace

void leave_depth_to_projection(RowSystem& system)
{
    for (const RowBlock& block : system.blocks)
        for (int i = block.first; i < block.first + block.count; ++i) {
            const Row& row = system.rows[std::size_t(i)];
            const bool beyond = (row.lo == 0 && row.error > 0) || (row.hi == 0 && row.error < 0);
            if (beyond && !is_spring(row, block, system))
                system.numbers[std::size_t(i)].c = wanted_velocity(row, 0);
        }
}

ProjectionReport project_poses(const World& world, const IslandWork& work, const Tasks& tasks,
                               SymbolicCache& symbolic_cache, Arena& arena, std::span<const Velocity> starts)
{
    Arena::Scope scope(arena);
    Projection projection(world, work, symbolic_cache, arena);
    if (!projection.prepare()) return {};
    ProjectionReport report = projection.run(tasks);
    report.turned = report.iterations > 0 && !starts.empty() && projection.turn_velocities(starts);
    return report;
}

}  // namespace epode
