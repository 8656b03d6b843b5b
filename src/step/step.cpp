// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The pipeline: sleep, islands, then each island from forces to poses. An island whose answer is not a number
// is contained: it keeps its velocities, its constraints exert nothing, and the report counts it; the others
// never notice.
#include "step/step.h"

#include <algorithm>
#include <new>

#include "dynamics/integrate.h"
#include "dynamics/island.h"
#include "dynamics/sleep.h"
#include "step/assemble.h"
#include "step/link.h"
#include "step/substeps.h"
#include "step/write_back.h"

namespace epode {
namespace {

// Solvers that iterate start from the impulses of the last step.
void load_warm_start(Real share, ContactCache& contacts, IslandWork& work)
{
    for (std::size_t k = 0; k < work.joints.size(); ++k) {
        const Joint& joint = *work.joints[k];
        const RowBlock& block = work.system.blocks[k];
        if (block.contact) {
            work.tickets[k] = contacts.load(joint, block, work.system, share);
        } else if (joint.impulse_rows == block.count) {
            for (int i = 0; i < block.count; ++i)
                work.system.numbers[std::size_t(block.first + i)].p = share * joint.impulse[i];
        }
    }
}

struct SavedPose {
    Real pos[4], q[4], R[12];
};

// Poses before inner steps, so that a failed island can be put back.
std::span<SavedPose> save_poses(const Island& island, Arena& arena)
{
    auto saved = arena.take<SavedPose>(int(island.bodies.size()));
    for (std::size_t i = 0; i < saved.size(); ++i) {
        const Body& b = *island.bodies[i];
        std::copy(b.pos, b.pos + 4, saved[i].pos);
        std::copy(b.q, b.q + 4, saved[i].q);
        std::copy(b.R, b.R + 12, saved[i].R);
    }
    return saved;
}

void restore_poses(const Island& island, std::span<const SavedPose> saved)
{
    for (std::size_t i = 0; i < saved.size(); ++i) {
        Body& b = *island.bodies[i];
        std::copy(saved[i].pos, saved[i].pos + 4, b.pos);
        std::copy(saved[i].q, saved[i].q + 4, b.q);
        std::copy(saved[i].R, saved[i].R + 12, b.R);
    }
}

void contain(IslandWork& work)
{
    for (Joint* joint : work.joints) joint->impulse_rows = 0;
    for (Body* body : work.island.bodies)
        if (!usable(body->lvel, 3) || !usable(body->avel, 3)) {
            store(body->lvel, {});
            store(body->avel, {});
        }
}

// Poses, callbacks, damping, accumulators: body by body.
void finish_bodies(const Island& island, bool poses_done, Real h)
{
    for (Body* body : island.bodies) {
        if (!poses_done) advance_pose(*body, h);
        body_moved(*body);
        if (body->moved) body->moved(to_handle(body));
        damp(*body);
        store(body->facc, {});
        store(body->tacc, {});
    }
}

void add_to_report(dWorldStepReport& total, const IslandWork& work, const SolveReport& one, bool contained)
{
    ++total.islands;
    total.bodies += int(work.island.bodies.size());
    total.joints += int(work.joints.size());
    total.rows += int(work.system.rows.size());
    total.residual = std::max(total.residual, double(one.residual));
    total.iterations += one.iterations;
    total.fallbacks += one.fallback;
    total.contained_islands += contained;
}

struct StepContext {
    World& world;
    const Solver& solver;
    Real h;
    SolverSettings settings;
    ContactCache& contacts;
};

void step_island(const StepContext& context, const Island& island)
{
    World& world = context.world;
    const bool inner = context.solver.substeps;
    Arena::Scope scope(world.arena);
    IslandWork work;
    SolveReport report;
    SolverSettings settings = context.settings;
    std::span<SavedPose> saved;
    bool solved = assemble(world, island, context.h, context.solver, world.arena, work);
    SubstepModel model{work, step_info(world, context.h)};
    if (solved) {
        model.info.inner = true;
        const Substeps callbacks = model.callbacks();
        settings.substeps = inner ? &callbacks : nullptr;
        for (int& ticket : work.tickets) ticket = -1;
        load_warm_start(world.warm_starting * context.solver.warm_share, context.contacts, work);
        if (inner) saved = save_poses(island, world.arena);
        solved = context.solver.solve(work.system, settings, world.arena, report) && sound(work.system);
    }
    if (solved) {
        write_back(work);
        for (std::size_t k = 0; k < work.joints.size(); ++k)
            if (work.system.blocks[k].contact)
                context.contacts.remember(work.tickets[k], work.system.blocks[k], work.system);
    } else {
        restore_poses(island, saved);
        contain(work);
    }
    finish_bodies(island, inner && solved, context.h);
    if (world.report_wanted) add_to_report(world.report, work, report, !solved);
}

StepState* state_of(World& world)
{
    if (!world.step_state) {
        void* memory = allocate(sizeof(StepState));
        if (!memory) return nullptr;
        world.step_state = new (memory) StepState;
        world.free_step_state = [](StepState* s) {
            s->~StepState();
            release(s, sizeof(StepState));
        };
    }
    return world.step_state;
}

}  // namespace

bool step_world(World& world, const Solver& solver, Real h, int iterations)
{
    StepState* state = state_of(world);
    if (!state) return false;
    world.arena.reset();
    ++world.step_count;
    auto_disable(world, h);
    std::span<Island> islands;
    if (!find_islands(world, world.arena, islands)) return false;

    world.stepping = true;
    world.report = {};
    state->contacts.begin(world.joint_count);
    StepContext context{world, solver, h, {}, state->contacts};
    context.settings.iterations = iterations;
    context.settings.w = world.quick_w;
    context.settings.want_residual = world.report_wanted;
    for (std::size_t i = 0; i < islands.size(); ++i) {
        context.settings.seed = world.step_count * 0x9e3779b97f4a7c15u + i;
        step_island(context, islands[i]);
    }
    state->contacts.end();
    world.report_made = true;
    world.stepping = false;
    return true;
}

}  // namespace epode
