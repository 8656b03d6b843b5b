// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One step of a group: as many copies as a register has lanes, their rows of numbers one behind the other in memory (group.h). A copy
// whose velocities or positions are no longer finite, or beyond what the next step can square, keeps its last state and is flagged; it
// is not stepped again before it is reset.
#pragma once

#include "batch/lanes/group.h"
#include "batch/lanes/integrate.h"
#include "batch/lanes/loops.h"
#include "batch/lanes/mass.h"
#include "batch/lanes/medium.h"
#include "batch/lanes/rows.h"
#include "batch/lanes/solve.h"

namespace epode::batch {
namespace {

template <typename P>
EPODE_LANEWISE P* rows_at(typename P::Number* group, int row)
{
    return reinterpret_cast<P*>(group + row * P::kLanes);
}

// Angular velocities of floating bases from their links' axes to the world's, or back.
template <typename P>
void turn_rates(const ModelView& model, const P* q, bool to_world, P* v)
{
    for (const BatchJoint& joint : model.joints) {
        if (joint.kind != JointKind::kFree) continue;
        const P *at = q + joint.position + 3, sign(to_world ? 1 : -1);
        P* w = v + joint.dof + 3;
        const Vec3Of<P> out =
            rotated(Vec4Of<P>{at[0], sign * at[1], sign * at[2], sign * at[3]}, Vec3Of<P>{w[0], w[1], w[2]});
        w[0] = out.x, w[1] = out.y, w[2] = out.z;
    }
}

template <typename P, bool own>
struct Step {
    using T = typename P::Number;
    const ModelView& model;
    const StepOptions& options;
    Numbers<P, own> numbers;
    Work<P>& work;

    void take(T* group) const
    {
        const GroupLayout at(model);
        prepare(group);
        Solve<P>{model, options, work}.find();
        const Loops<P, own> loops{model, numbers, options, rows_at<P>(group, at.q), work};
        if (model.loop_rows > 0) loops.find_impulses();
        find_velocity(model, work, work.z, work.v);
        if (model.loop_rows > 0) loops.close();
        finish(group, at, rows_at<P>(group, at.q), rows_at<P>(group, at.v), rows_at<P>(group, at.forces),
               P(T(options.h)));
    }

    // All but the solve: z under the impulses of the last step, and the rows (of those that act, see Rows).
    void prepare(T* group, const int* acting = nullptr) const
    {
        const GroupLayout at(model);
        P *q = rows_at<P>(group, at.q), *v = rows_at<P>(group, at.v), *forces = rows_at<P>(group, at.forces);
        const P h(T(options.h));
        Motion<P, own>{model, numbers, q, v, work}.find();
        if (model.boxes.size() > 0) Medium<P, own>{model, numbers, h, work}.find();
        Drives<P, own>{model,
                       numbers,
                       q,
                       v,
                       rows_at<P>(group, at.control),
                       rows_at<P>(group, at.applied),
                       rows_at<P>(group, at.activations),
                       h,
                       work}
            .find();
        find_mass(model, work);
        factor(model, work);
        find_free_motion(model, v, h, work);
        Rows<P, own>{model, numbers, options, q, v, forces, work, acting}.find();
    }

    // 0 where it has gone bad, now or before; q: the positions after the step.
    P goodness(const P& bad, const P* q) const
    {
        const P most(T(sizeof(T) == 4 ? 1e15 : 1e60)), zero(0);
        P good = if_positive(bad, zero, P(1));
        for (int i = 0; i < model.velocities; ++i)
            good = if_greater(most, magnitude_or_nan(work.v[i]), good, zero);
        for (int i = 0; i < model.positions; ++i) good = if_greater(most, magnitude_or_nan(q[i]), good, zero);
        return good;
    }

    static P magnitude_or_nan(const P& x) { return x * if_greater(P(0), x, P(-1), P(1)); }

    void finish(T* group, const GroupLayout& at, P* q, P* v, P* forces, const P& h) const
    {
        P &bad = *rows_at<P>(group, at.bad), *before = rows_at<P>(group, at.before),
          *before_v = rows_at<P>(group, at.before_v);
        const P zero(0), rate(T(1 / options.h));
        for (int i = 0; i < model.positions; ++i) before[i] = q[i];
        for (int i = 0; i < model.velocities; ++i) before_v[i] = v[i];
        integrate(model, work.moving, h, q);
        const P good = goodness(bad, q);
        P* accelerations = rows_at<P>(group, at.accelerations);
        for (int i = 0; i < model.accelerations; ++i)
            accelerations[i] = if_positive(good, rate * (work.v[i] - v[i]) + zero, zero);
        // Plus zero: a zero has one sign, whatever the neighbours' rows were.
        for (int i = 0; i < model.velocities; ++i) v[i] = if_positive(good, work.v[i] + zero, v[i]);
        for (int i = 0; i < model.positions; ++i) q[i] = if_positive(good, q[i] + zero, before[i]);
        for (int i = 0; i < model.impulses(); ++i)
            forces[i] = if_positive(good, rate * work.impulses[i] + zero, zero);
        P* activations = rows_at<P>(group, at.activations);
        for (int i = 0; i < model.filters; ++i)
            activations[i] = if_positive(good, work.activations[i] + zero, activations[i]);
        bad = if_positive(good, zero, P(1));
        *rows_at<P>(group, at.residual) = work.worst, *rows_at<P>(group, at.sweeps) = work.sweeps;
    }
};

}  // namespace
}  // namespace epode::batch
