// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Inner steps move the real bodies: joints read their poses from there, and after the last inner step nothing
// is left to integrate.
#include "step/substeps.h"

#include "base/ahead.h"
#include "dynamics/integrate.h"

namespace epode {
namespace {

SubstepModel& model_of(void* p) { return *static_cast<SubstepModel*>(p); }

void apply_forces(void* p, RowSystem& system, Real h)
{
    SubstepModel& model = model_of(p);
    for (std::size_t i = 0; i < system.bodies.size(); ++i)
        add_forces(*model.work.island.bodies[i], h, system.bodies[i]);
}

void advance(void* p, RowSystem& system, Real h)
{
    SubstepModel& model = model_of(p);
    constexpr int kLines = 10;  // of a body
    for_each_fetched<kLines>(std::span<Body* const>(model.work.island.bodies),
                             [&](std::size_t i, Body& body) {
                                 SolverBody& s = system.bodies[i];
                                 const Vec3 v0 = body.velocity(), w0 = body.angular_velocity();
                                 store(body.lvel, s.v);
                                 store(body.avel, s.w);
                                 advance_pose(body, h);
                                 s.w = body.angular_velocity();  // may have been capped
                                 load_inertia(body, s);
                                 // The body's own velocity stays that of the beginning of the step until the
                                 // step is accepted.
                                 store(body.lvel, v0);
                                 store(body.avel, w0);
                             });
}

void refresh(void* p, RowSystem& system)
{
    SubstepModel& model = model_of(p);
    Row rows[kMaxJointRows];
    for (std::size_t k = 0; k < system.blocks.size(); ++k) {
        RowBlock& block = system.blocks[k];
        if (block.contact) continue;  // the solver follows their gaps itself
        RowWriter out(rows, model.info);
        model.work.joints[k]->type->emit(*model.work.joints[k], out);
        block.arms = out.arms();
        for (int i = 0; i < block.count && i < out.count(); ++i) {
            Row& row = system.rows[std::size_t(block.first + i)];
            // Decided at the beginning of the step, by the velocities of then.
            const bool rebounds = row.rebounds;
            const Real rebound = row.rebound;
            row = rows[i];
            row.rebounds = rebounds;
            row.rebound = rebound;
        }
    }
}

void gather_contacts(void* p, RowSystem& system)
{
    for (RowBlock& block : system.blocks)
        if (block.contact)
            gather_contact(model_of(p).work.island, block,
                           system.rows.subspan(std::size_t(block.first), std::size_t(block.count)));
}

}  // namespace

void gather_contact(const Island& island, RowBlock& block, std::span<Row> rows)
{
    if (block.body2 < 0) return;
    const Vec3 x1 = island.bodies[std::size_t(block.body1)]->position();
    const Vec3 x2 = island.bodies[std::size_t(block.body2)]->position();
    const Vec3 half_gap = Real(0.5) * ((x2 + block.arms.r2) - (x1 + block.arms.r1));
    block.arms.r1 += half_gap;
    block.arms.r2 -= half_gap;
    for (Row& row : rows) {
        if (row.lin1 == Vec3{}) continue;  // rolling rows have no arm
        row.ang1 = cross(block.arms.r1, row.lin1);
        row.ang2 = cross(block.arms.r2, row.lin2);
    }
}

Substeps SubstepModel::callbacks() { return {this, apply_forces, advance, refresh, gather_contacts}; }

}  // namespace epode
