// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/island_step.h"

#include <algorithm>
#include <optional>

#include "dynamics/exact_spin.h"
#include "dynamics/integrate.h"
#include "joints/breaking.h"
#include "solve/common/work_meter.h"
#include "step/island/blows.h"
#include "step/island/divergence.h"
#include "step/island/energy_ledger.h"
#include "step/island/exact_substeps.h"
#include "step/island/free_flight.h"
#include "step/island/positions/shake.h"
#include "step/island/positions/stops.h"
#include "step/island/positions/tension.h"
#include "step/island/problem/assemble.h"
#include "step/island/problem/default_softness.h"
#include "step/island/problem/joint_memory.h"
#include "step/island/problem/manifold_rows.h"
#include "step/island/report.h"
#include "step/island/strain.h"
#include "step/island/substeps.h"
#include "step/island/write_back.h"

namespace epode {
namespace {

// Are its velocities such as a program may set?
bool keeps_numbers(const Body& body) { return usable(body.lvel, 3) && usable(body.avel, 3); }

void contain(std::span<Body* const> bodies, std::span<Joint* const> joints)
{
    for (Joint* joint : joints) {
        joint->impulse_rows = 0;
        if (joint->driven) forget_load(*joint);
    }
    for (Body* body : bodies) {
        body->spin_excess = {};
        if (!keeps_numbers(*body)) store(body->lvel, {}), store(body->avel, {});
    }
}

constexpr int kManyIterations = 1000;   // from here on no more for settling islands
constexpr std::size_t kFewBodies = 64;  // of a diverging island that is solved exactly

template <typename T>
std::span<T> slice(std::span<T> all, int from, int to)
{
    return all.subspan(std::size_t(from), std::size_t(to - from));
}

class IslandStep {
  public:
    IslandStep(const StepContext& context, std::span<const Island> members, IslandPlace place,
               std::span<dEnergyLedger> ledgers, Arena& arena)
        : context_(context),
          world_(context.world),
          place_(place),
          arena_(arena),
          exact_(&context.solver == &kDirect),
          ledger_(world_, members, ledgers),
          exact_substeps_(world_, work_.island, context.undo, context.h, world_.exact_substeps, ledger_,
                          arena)
    {
        work_.island = joined(members);
        work_.members = members;
        if (context.solver.substeps) factor_ = substep_factor(work_.island);
    }

    // False: out of memory, or a solution that is not finite in an island without parts.
    bool solve(const Tasks& tasks, std::span<dIslandStepReport> reports)
    {
        if (has_exact_substeps() && !exact_substeps_.begin()) return false;
        if (ledger_.wanted() && !begin_ledger()) return false;
        const Real h = has_exact_substeps() ? exact_substeps_.substep() : context_.h;
        if (!assemble(world_, h, context_.solver, tasks, arena_, work_, &context_.undo)) return false;
        limit_default_softness(world_, inner_step(), work_.system);
        work_.system.manifold_friction = world_.manifold_friction && context_.solver.cones;
        if (has_exact_substeps()) exact_substeps_.map(work_.system);
        for (std::size_t i = 0; i < reports.size(); ++i) report_errors(work_, int(i), reports[i]);
        if (watches_strain() && !strain_.begin(world_, work_, arena_)) return false;
        raise_inertias(reports);
        if (projects())
            leave_depth_to_projection(world_, work_);
        else if (!context_.solver.substeps && !has_exact_substeps())
            closes_stops_ = leave_stops_to_poses(world_, work_.system);
        SolverSettings settings;
        settings.iterations = iterations();
        settings.swept_iterations = swept_iterations();
        settings.w = world_.quick_w;
        settings.seed = world_.step_count * 0x9e3779b97f4a7c15u + std::uint64_t(place_.draw);
        settings.want_residual = !reports.empty();
        settings.contact_manifolds = context_.manages_contacts;
        settings.part_residuals = arena_.take<Real>(int(reports.size()));
        if (arena_.failed()) return false;
        std::fill(settings.part_residuals.begin(), settings.part_residuals.end(), Real(0));
        settings.tasks = tasks;
        settings.substep_ends = substep_ends_;
        settings.symbolic_cache = &context_.symbolic_cache;
        if (IslandMethod* method = exact_method())
            work_meter_.limit = method->max_work, settings.work = &work_meter_;
        if (projects()) settings.refine_above = 1e-9;  // the projection corrects smaller errors of position
        if (context_.solver.substeps && !blows_.begin(work_.system, arena_)) return false;
        set_aside_ = arena_.take_zeroed<bool>(work_.system.worlds());
        if (arena_.failed()) return false;
        load_warm_start(world_.warm_starting);
        std::optional<SubstepModel> model;
        Substeps callbacks;
        if (context_.solver.substeps) {
            std::span<const BorneForce> borne;
            if (iterations() > 1)
                borne = kick_by_prompt_forces(world_, work_, context_.h, warm_share(), arena_);
            model.emplace(work_, world_, step_info(world_, context_.h), raised_ > 0, borne, tasks);
            if (!model->prepare(arena_)) return false;
            callbacks = model->callbacks(), settings.substeps = &callbacks;
        }
        if (has_exact_substeps()) exact_substeps_.kick(work_, warm_share());
        SolveReport solved;
        bool sane = context_.solver.solve(work_.system, settings, arena_, solved);
        substeps_ = std::max(1, solved.iterations / 2);
        if (IslandMethod* method = exact_method())
            method->work = work_meter_.spent, method->gave_up = solved.gave_up;
        factorisations_ = solved.factorisations;
        if (gave_up()) return false;
        if (sane && !has_parts()) sane = sound(work_.system, 0, tasks);
        if (sane && has_exact_substeps())
            sane = exact_substeps_.run(work_, raised_ > 0, settings, solved, projected_);
        for (std::size_t i = 0; i < reports.size(); ++i) {
            if (has_parts()) solved.residual = settings.part_residuals[i];
            report_solution(work_, solved, reports[i]);
        }
        if (sane && raised_ > 0 && knows_forces()) report_raised(work_.system, plain_, arena_, reports);
        return sane;
    }

    // An exact solution would have taken more work than it may: nothing is solved.
    int factorisations() const { return factorisations_; }
    bool gave_up() const { return exact_method() && exact_method()->gave_up; }

    void accept(const Tasks& tasks, std::span<dIslandStepReport> reports)
    {
        for (int part = 0; part < work_.system.worlds(); ++part)
            if ((has_parts() && !sound(work_.system, part)) || diverged(part, tasks))
                set_aside(part, reports);
            else if (context_.solver.substeps && is_free(part))
                fly_freely(part);
        if (!has_exact_substeps()) {
            if (ledger_.wanted()) add_to_ledger();
            write_back(work_, tasks);
        }
        if (ledger_.wanted()) add_forces_to_ledger();
        remember_contacts();
        note_mean_forces();
        if (!context_.solver.contact_manifolds) store_manifold_impulses(work_, solutions());
        if (watches_strain()) strain_.end(world_, work_, methods());
        if (context_.solver.substeps) return;  // the substeps have moved the poses
        if (!has_exact_substeps()) {
            if (projects())
                advance_and_project(tasks);
            else
                advance_poses(world_, work_, context_.h);
            if (closes_stops_) bring_back_from_stops(tasks);
        }
        for (dIslandStepReport& report : reports)
            if (projects()) report_projection(projected_, report);
    }

    void refuse(std::span<dIslandStepReport> reports)
    {
        has_exact_substeps() ? exact_substeps_.undo() : context_.undo.restore_poses(work_.island.bodies);
        contain(work_.island.bodies, work_.joints);
        context_.runaways.add(*work_.island.bodies.front());
        if (ledger_.wanted()) ledger_.forget();
        for (ManifoldEdge* edge : work_.island.manifolds) clear_impulses(*edge->manifold);
        advance_poses(world_, work_, context_.h);
        for (dIslandStepReport& report : reports) report.contained = true;
    }

    void end_ledger()
    {
        if (ledger_.wanted()) ledger_.end();
    }

    // The islands that are to be solved again.
    std::span<const bool> set_aside() const { return set_aside_; }
    // May what has diverged be solved in another way?
    bool may_try_again() const
    {
        if (exact_ || world_.acts_as_ode()) return false;
        return context_.diverged == 0 || (context_.diverged == 1 && work_.island.bodies.size() <= kFewBodies);
    }

  private:
    // Of bodies whose loads the step is too long for. `plain_`: the bodies as they are, where reports are wanted.
    void raise_inertias(std::span<dIslandStepReport> reports)
    {
        if (world_.acts_as_ode()) return;
        std::span<bool> marks;
        if (!reports.empty()) {
            plain_ = arena_.take<SolverBody>(int(work_.system.bodies.size()));
            marks = arena_.take_zeroed<bool>(int(plain_.size()));
            if (arena_.failed()) return;
            std::copy(work_.system.bodies.begin(), work_.system.bodies.end(), plain_.begin());
        }
        const bool solves_joints = exact_ || context_.solver.substeps;
        raised_ = add_tension(work_, work_.system.bodies, inner_step(),
                              solves_joints ? kResolvedExactly : kResolvedBySweeps, arena_, marks);
        std::size_t i = 0;
        for (std::size_t m = 0; m < reports.size(); ++m)
            for (std::size_t end = i + work_.members[m].bodies.size(); i < end; ++i)
                reports[m].raised_bodies += marks[i];
    }

    // Do the solver's bodies begin with the velocities after all forces?
    bool knows_forces() const { return !context_.solver.substeps && !has_exact_substeps(); }

    // False: out of memory.
    bool begin_ledger()
    {
        if (context_.solver.substeps)
            substep_ends_ = arena_.take_zeroed<Velocity>(int(work_.island.bodies.size()));
        return ledger_.begin(arena_) && !arena_.failed();
    }

    void add_to_ledger()
    {
        const bool relaxed = context_.solver.substeps;
        for (int part = 0; part < work_.system.worlds(); ++part) {
            if (has_parts() && !sound(work_.system, part)) continue;
            ledger_.add_solution(work_, part, relaxed);
            if (relaxed && !is_free(part))
                ledger_.add_relaxed_corrections(part, substep_ends_, context_.h / Real(substeps_));
        }
    }

    void add_forces_to_ledger()
    {
        for (int part = 0; part < work_.system.worlds(); ++part)
            if (!has_parts() || sound(work_.system, part)) ledger_.add_forces(part, context_.h);
    }

    void advance_and_project(const Tasks& tasks)
    {
        SymbolicCache& cache = context_.symbolic_cache;
        if (raised_ > 0)
            advance_poses(world_, work_, context_.h);
        else if (advance_closing(world_, work_, tasks, cache, arena_))
            write_joints_again(work_);
        if (ledger_.wanted()) ledger_.begin_correction();
        projected_ = project_poses(world_, work_, tasks, cache, arena_);
        if (ledger_.wanted()) ledger_.end_correction();
    }

    void bring_back_from_stops(const Tasks& tasks)
    {
        if (ledger_.wanted()) ledger_.begin_correction();
        close_stops(world_, work_, context_.solver, tasks, arena_);
        if (ledger_.wanted()) ledger_.end_correction();
    }

    int iterations() const
    {
        const int n = context_.iterations, factor = context_.solver.settling_factor;
        if (sweeps_joints()) return swept_iterations();
        return work_.island.settles() && n < kManyIterations ? n * factor : n;
    }
    int swept_iterations() const { return context_.iterations * factor_; }
    Real warm_share() const { return world_.warm_starting * context_.solver.warm_share; }
    // What joints leave open in substeps depends on their number: with another one they would jerk.
    bool sweeps_joints() const { return &context_.solver == &kTgs && has_lasting_joints(work_.island); }
    bool projects() const { return exact_ && world_.projection_iterations > 0; }
    // What the impulses that joints remember are divided by to be forces.
    Real inner_step() const
    {
        return context_.solver.substeps ? context_.h / Real(std::max(1, iterations())) : work_.system.h;
    }
    // Impulses of the system's step are those of so many parts of the whole one.
    Real solutions() const { return has_exact_substeps() ? Real(world_.exact_substeps) : Real(1); }
    bool has_exact_substeps() const { return exact_ && world_.exact_substeps > 1; }
    bool watches_strain() const { return context_.solver.substeps && !context_.methods.empty(); }
    std::span<IslandMethod> methods() const
    {
        return context_.methods.subspan(std::size_t(place_.first_island), work_.members.size());
    }
    // Of an exact solution whose work counts.
    IslandMethod* exact_method() const
    {
        return exact_ && !context_.methods.empty() && !has_exact_substeps() ? &methods().front() : nullptr;
    }
    bool has_parts() const { return !work_.system.parts.empty(); }

    bool is_free(int part) const
    {
        const SystemPart from = work_.system.begin_of(part), to = work_.system.end_of(part);
        return from.blocks == to.blocks && from.joint_manifolds == to.joint_manifolds &&
               from.contact_manifolds == to.contact_manifolds;
    }

    void fly_freely(int part)
    {
        const SystemPart from = work_.system.begin_of(part), to = work_.system.end_of(part);
        for (int i = from.bodies; i < to.bodies; ++i) {
            Body& body = *work_.island.bodies[std::size_t(i)];
            if (!flies_by_itself(world_, body, context_.manages_contacts)) continue;
            const Vec3 v = body.velocity(), w = body.angular_velocity();
            context_.undo.restore_poses(slice(work_.island.bodies, i, i + 1));
            fly(world_, body, context_.h, std::max(1, iterations()));
            if (!keeps_numbers(body)) {  // gyroscopic torque grows with the square of a spin
                context_.undo.restore_poses(slice(work_.island.bodies, i, i + 1));
                store(body.lvel, v), store(body.avel, w);
            }
            load_velocity(body, work_.system.bodies[std::size_t(i)]);
        }
    }

    bool diverged(int part, const Tasks& tasks) const
    {
        return !exact_ && !world_.acts_as_ode() && !is_free(part) &&
               has_diverged(work_, part, context_.h, tasks, arena_);
    }

    void set_aside(int part, std::span<dIslandStepReport> reports)
    {
        contain_part(part);
        if (may_try_again())
            set_aside_[std::size_t(part)] = true;
        else
            report_contained(part, reports);
    }

    void report_contained(int part, std::span<dIslandStepReport> reports) const
    {
        context_.runaways.add(*work_.island.bodies[std::size_t(work_.system.begin_of(part).bodies)]);
        if (!reports.empty()) reports[std::size_t(part)].contained = true;
    }

    // A part whose solution is not finite must not affect the others: its bodies keep their velocities, and
    // its constraints exert nothing.
    void contain_part(int part)
    {
        RowSystem& system = work_.system;
        const SystemPart from = system.begin_of(part), to = system.end_of(part);
        contain(slice(work_.island.bodies, from.bodies, to.bodies), {});
        for (auto i = std::size_t(from.bodies); i < std::size_t(to.bodies); ++i)
            load_velocity(*work_.island.bodies[i], system.bodies[i]);
        for (const RowBlock& block : slice(system.blocks, from.blocks, to.blocks))
            for (int i = block.first; i < block.first + block.count; ++i)
                system.numbers[std::size_t(i)].p = 0;
        for (const JointManifold& m :
             slice(system.joint_contacts.manifolds, from.joint_manifolds, to.joint_manifolds))
            for (JointManifoldPoint& point : points_of(m))
                for (Real& p : point.p) p = 0;
        for (ContactManifold* manifold :
             slice(system.contact_manifolds, from.contact_manifolds, to.contact_manifolds))
            clear_impulses(*manifold);
        if (context_.solver.substeps) {
            // The substeps have moved the bodies.
            const auto bodies = slice(work_.island.bodies, from.bodies, to.bodies);
            context_.undo.restore_poses(bodies);
            for (Body* body : bodies) advance_pose(*body, context_.h);
        }
    }
    // Tickets in the contact cache: points of manifolds first, then contacts that are rows.
    int ticket_of_point(int point) const { return place_.first_contact + point; }
    int ticket_of_block(std::size_t block) const
    {
        return place_.first_contact + int(work_.contacts.size() + block);
    }

    // Every solver may start from the impulses of the last step. `wanted`: times its own share of them.
    void load_warm_start(Real wanted)
    {
        RowSystem& system = work_.system;
        const Real share = wanted * context_.solver.warm_share;
        if (!context_.solver.contact_manifolds) load_manifold_impulses(work_, share / solutions());
        for (const JointManifold& m : system.joint_contacts.manifolds)
            load_contact(ticket_of_point(m.first), m, points_of(m), share);
        for (std::size_t k = 0; k < work_.joints.size(); ++k) {
            const RowBlock& block = system.blocks[k];
            RowNumbers* numbers = &system.numbers[std::size_t(block.first)];
            if (!block.contact) {
                load_memory(lasting(*work_.joints[k]), block, system, context_.solver, wanted,
                            std::max(1, iterations()));
                continue;
            }
            JointManifoldPoint point{block.arms.r1, 0, 0, 0, {}};
            load_contact(ticket_of_block(k), manifold_of(block), {&point, 1}, share);
            for (int i = 0; i < std::min(block.count, 3); ++i) numbers[i].p = point.p[i];
        }
    }

    void load_contact(int ticket, const JointManifold& m, std::span<JointManifoldPoint> points, Real share)
    {
        if (context_.diverged > 0) return;  // they are noted
        const auto& bodies = work_.island.bodies;
        const Body* body2 = m.body2 >= 0 ? bodies[std::size_t(m.body2)] : nullptr;
        context_.contacts.load(place_.index, ticket, *bodies[std::size_t(m.body1)], body2, m, points, share,
                               work_.system.h);
    }

    void note_mean_forces()
    {
        for (std::size_t k = 0; k < work_.joints.size(); ++k)
            if (!work_.system.blocks[k].contact)
                note_mean_force(lasting(*work_.joints[k]), work_.system.blocks[k], work_.system, context_.h);
    }

    void remember_contacts()
    {
        if (context_.diverged > 0) return;
        const RowSystem& system = work_.system;
        for (const JointManifold& m : system.joint_contacts.manifolds)
            if (!blows_.struck(system, m))
                context_.contacts.remember(ticket_of_point(m.first), m, points_of(m), solutions());
        for (std::size_t k = 0; k < work_.joints.size(); ++k) {
            const RowBlock& block = system.blocks[k];
            if (!block.contact || blows_.struck(system, k)) continue;
            JointManifoldPoint point{};
            for (int i = 0; i < std::min(block.count, 3); ++i)
                point.p[i] = system.numbers[std::size_t(block.first + i)].p;
            context_.contacts.remember(ticket_of_block(k), manifold_of(block), {&point, 1}, solutions());
        }
    }

    std::span<JointManifoldPoint> points_of(const JointManifold& m) const
    {
        return work_.system.joint_contacts.points.subspan(std::size_t(m.first), std::size_t(m.count));
    }

    // Directions and bodies of a contact that is rows: the first row has the normal; the linear parts of the
    // others are tangents or zero.
    JointManifold manifold_of(const RowBlock& block) const
    {
        const Row* rows = &work_.system.rows[std::size_t(block.first)];
        JointManifold m{};
        m.n = rows[0].lin1;
        if (block.count > 1) m.t1 = rows[1].lin1;
        if (block.count > 2) m.t2 = rows[2].lin1;
        m.body1 = block.body1, m.body2 = block.body2;
        return m;
    }

    const StepContext& context_;
    World& world_;
    IslandPlace place_;
    Arena& arena_;
    IslandWork work_;
    const bool exact_;
    EnergyLedger ledger_;
    std::span<Velocity> substep_ends_;  // if there is a ledger
    ExactSubsteps exact_substeps_;
    StrainWatch strain_;
    Blows blows_;
    std::span<bool> set_aside_;  // of each part
    WorkMeter work_meter_{};
    int factorisations_ = 0;
    int factor_ = 1;    // of its substeps
    int substeps_ = 1;  // if the solver has any
    ProjectionReport projected_;
    bool closes_stops_ = false;
    int raised_ = 0;  // bodies whose inertia is
    std::span<SolverBody> plain_;
};

}  // namespace

Island joined(std::span<const Island> islands)
{
    const auto all = [&](auto Island::*items) {
        const auto &first = islands.front().*items, &last = islands.back().*items;
        return std::span(first.data(), last.data() + last.size());
    };
    Island sum{all(&Island::bodies), all(&Island::joints), all(&Island::manifolds)};
    for (const Island& island : islands) {
        sum.plain_contacts += island.plain_contacts;
        sum.feedback = sum.feedback || island.feedback;
        sum.impulses = sum.impulses || island.impulses;
        sum.kept_depth = std::max(sum.kept_depth, island.kept_depth);
    }
    return sum;
}

namespace {

StepContext with_fallback(const StepContext& c, IslandPlace place)
{
    const IslandMethod& method = c.methods[std::size_t(place.first_island)];
    return {.world = c.world,
            .solver = *method.fallback,
            .h = c.h,
            .iterations = method.fallback_iterations,
            .contacts = c.contacts,
            .symbolic_cache = c.symbolic_cache,
            .undo = c.undo,
            .runaways = c.runaways,
            .manages_contacts = c.manages_contacts,
            .methods = c.methods};
}

// After the first divergence by the same solver, after the second exactly.
StepContext without_impulses(const StepContext& c)
{
    return {.world = c.world,
            .solver = c.diverged == 0 ? c.solver : kDirect,
            .h = c.h,
            .iterations = c.iterations,
            .contacts = c.contacts,
            .symbolic_cache = c.symbolic_cache,
            .undo = c.undo,
            .runaways = c.runaways,
            .manages_contacts = c.manages_contacts,
            .methods = c.diverged == 0 ? c.methods : std::span<IslandMethod>(),
            .diverged = c.diverged + 1};
}

void forget_impulses(const Island& island)
{
    for (Joint* joint : island.joints) {
        joint->impulse_rows = 0;
        if (joint->driven) forget_load(*joint);
    }
    for (ManifoldEdge* edge : island.manifolds) clear_impulses(*edge->manifold);
}

// False: out of memory.
bool solve_again(const StepContext& context, const Island& island, IslandPlace place, const Tasks& tasks,
                 Arena& arena, const IslandRecords& records)
{
    context.undo.restore_bodies(island.bodies);
    forget_impulses(island);
    if (!step_islands(without_impulses(context), {&island, 1}, place, tasks, arena, records)) return false;
    for (dIslandStepReport& report : records.reports) report.fallback = true;
    return true;
}

}  // namespace

bool step_islands(const StepContext& context, std::span<const Island> islands, IslandPlace place,
                  const Tasks& tasks, Arena& arena, const IslandRecords& records)
{
    Arena::Scope scope(arena);
    const std::span<dIslandStepReport> reports = records.reports;
    for (std::size_t i = 0; i < reports.size(); ++i) begin_report(context.world, islands[i], reports[i]);
    IslandStep step(context, islands, place, records.ledgers, arena);
    const bool solved = step.solve(tasks, reports);
    if (arena.failed()) return false;
    if (step.gave_up()) {
        context.undo.restore_bodies(joined(islands).bodies);
        context.contacts.begin_again(place.index);
        if (!step_islands(with_fallback(context, place), islands, place, tasks, arena, records)) return false;
        if (!reports.empty()) reports[0].factorisations += step.factorisations();
        return true;
    }
    if (!solved && step.may_try_again())
        return solve_again(context, islands.front(), place, tasks, arena, records);
    solved ? step.accept(tasks, reports) : step.refuse(reports);
    step.end_ledger();
    for (std::size_t i = 0; i < reports.size(); ++i) end_report(context.world, islands[i], reports[i]);
    for (std::size_t i = 0; i < step.set_aside().size(); ++i) {
        if (!step.set_aside()[i]) continue;
        const IslandPlace own{place.index, place.draw, place.first_contact, place.first_island + int(i)};
        const auto part = [i](auto all) { return all.empty() ? all : all.subspan(i, 1); };
        if (!solve_again(context, islands[i], own, tasks, arena, {part(reports), part(records.ledgers)}))
            return false;
    }
    return !arena.failed();
}

}  // namespace epode
