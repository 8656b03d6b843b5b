// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The step, compiled for one kind of machine and number: see step.h for what it does.
#pragma once

#include <cstddef>

#include "batch/lanes/active.h"
#include "batch/lanes/options.h"
#include "batch/model/model_view.h"

namespace epode::batch {

template <typename T>
struct Kernels {
    int lanes;
    // Bytes that a thread needs to step groups of the model, at a multiple of 64.
    std::size_t (*work_size)(const ModelView&);
    // Makes that memory ready, once.
    void (*make_work)(const ModelView&, const Asker&, void* work);
    // numbers: of the model, shared; or, if they are the copies' own, rows of lanes.
    void (*step)(const ModelView&, const StepOptions&, const T* numbers, bool own, T* group, void* work);
    // Writes observations (observed.h) of a group, kOfState, kOfStep, kOfSensors or several.
    void (*observe)(const ModelView&, const StepOptions&, const T* numbers, bool own, T* group, void* work,
                    int what, T* rows);
    // Writes jacobians of a point of a link, rows of 6 times as many numbers as there are velocities.
    void (*jacobian)(const ModelView&, const T* numbers, bool own, T* group, void* work, int link,
                     const double* point, T* rows);
    // Of sensitivity.h: derivatives along the columns of two groups that stand apart, by steps, or at an active set;
    // and the rows of a solved step. Both use up the groups.
    void (*differentiate)(const ModelView&, const StepOptions&, const Apart<T>&, const ActiveSet<T>* active,
                          void* work);
    int (*respond)(const ModelView&, const StepOptions&, const T* numbers, T* group, void* work,
                   FoundRow<T>* rows, T* y, T* response);
};

// The best that this machine runs (EPODE_KERNELS may limit it).
template <typename T>
const Kernels<T>& best_kernels();

}  // namespace epode::batch
