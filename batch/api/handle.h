// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What the C functions of batches share: what a handle names, and which arguments are of it.
#pragma once

#include "batch/batch.h"
#include "epode/batch.h"
#include "robots/api.h"

struct dxBatch {
    std::unique_ptr<epode::batch::AnyBatch> batch;
};

namespace epode::batch {

using robots::check;
using robots::guarded;

inline AnyBatch* alive(dBatchID batch)
{
    dxBatch* its = robots::Handles<dxBatch>::all().find(batch);
    return its ? its->batch.get() : nullptr;
}

inline bool are_copies(const AnyBatch* batch, int first, int count)
{
    return batch && first >= 0 && count >= 0 && first <= batch->copies() - count;
}
inline bool is_parameter(int parameter) { return parameter >= 0 && parameter < int(Parameter::kCount); }

}  // namespace epode::batch
