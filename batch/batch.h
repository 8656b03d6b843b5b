// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A batch: n copies of a model, in groups of as many as a register of this machine has lanes. Lanes of the last group that no copy
// uses hold copies at the reference, which nobody sees.
#pragma once

#include <functional>
#include <memory>
#include <vector>

#include "batch/crew.h"
#include "batch/derivatives/request.h"
#include "batch/lanes/group.h"
#include "batch/lanes/kernels.h"
#include "batch/rays.h"

namespace epode::batch {

// What of a copy can be read; positions, velocities, controls, applied forces and activations can be written too.
enum class Quantity {
    kPositions,
    kVelocities,
    kControls,
    kApplied,
    kForces,
    kBad,
    kResidual,
    kSweeps,
    kActivations,
    // Observations (lanes/observe.h), for which nothing is kept.
    kLinkPositions,
    kLinkTurns,
    kLinkVelocities,
    kLinkInertias,
    kLinkForces,
    kCentre,
    kActuatorForces,
    kConstraintForces,
    kSensors,
    kCount
};
constexpr bool is_observed(Quantity quantity) { return quantity >= Quantity::kLinkPositions; }

class AnyBatch {
  public:
    virtual ~AnyBatch() = default;
    const BatchModel& model() const { return model_; }
    int copies() const { return copies_; }
    StepOptions& options() { return options_; }
    int size_of(Quantity quantity) const;

    virtual int number_size() const = 0;
    virtual int threads() const = 0;
    // `count` copies from `first` on, (count, size), in the batch's own numbers.
    virtual void read(Quantity quantity, int first, int count, void* to) const = 0;
    // False: a number that is not finite or, of a quaternion, no turn; nothing changes then.
    virtual bool write(Quantity quantity, int first, int count, const void* from) = 0;
    // Arrays (n, size) that every step reads before (what can be written) and writes after; null: none.
    virtual void bind(Quantity quantity, void* array) = 0;
    // The same, but never read: what steps write for others than the user, who binds.
    virtual void watch(Quantity quantity, void* array) = 0;
    // Of copies of one group, in the thread that has stepped them, once arrays are written: visit(first, count, worker). It may read,
    // write and reset those copies, and must then refresh them.
    using Visit = std::function<void(int, int, int)>;
    // False: a bound array has numbers that cannot be; nothing has changed.
    virtual bool step(int steps, const Visit* visit = nullptr) = 0;
    // To the reference at rest, no controls, no forces, good again: where mask (n) is not 0; null: all.
    virtual void reset(const unsigned char* mask) = 0;
    virtual void reset_copy(int copy) = 0;
    // Writes arrays of those copies, of whole groups.
    virtual void refresh(int first, int count, int worker) = 0;
    virtual int bad() const = 0;  // how many
    // Of each of `count` copies from `first` on: ranges (count, rays), infinite where nothing is hit; shapes, the same, or null.
    virtual void cast(const Rays& rays, int first, int count, void* ranges, int* shapes) = 0;
    // (count, size) as above. Once one has been written, every copy has numbers of its own. False: a number that cannot be.
    virtual void read(Parameter parameter, int first, int count, void* to) const = 0;
    virtual bool write(Parameter parameter, int first, int count, const void* from) = 0;
    // (copies, 6, velocities): of a point of a link.
    virtual void jacobian(int link, const double* point, const std::vector<int>& copies, void* to) = 0;
    // Of a step of each copy, which moves none: (copies, tangents, columns) a block. Of bad copies: not a number.
    virtual void differentiate(const std::vector<int>& copies, const DerivativeOptions& how,
                               const std::vector<ColumnBlock>& blocks) = 0;
    // Rows of loops, and of friction against turning, have differences alone.
    bool has_exact_derivatives() const { return model_.loop_rows == 0 && model_.turns == 0; }
    // Of a state, tangents of positions and of velocities, and activations.
    int tangents() const { return 2 * model_.velocities + model_.filters; }

  protected:
    AnyBatch(BatchModel model, int copies) : model_(std::move(model)), copies_(copies) {}
    BatchModel model_;
    int copies_;
    StepOptions options_;
};

// Throws std::bad_alloc.
std::unique_ptr<AnyBatch> make_batch(BatchModel model, int copies, bool doubles, int threads,
                                     bool is_pinned = false);

}  // namespace epode::batch
