// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a joint sees of a step: the numbers of the world it may need, a place to write up to six rows, and a
// place for forces that it applies outright (a motor that works against its own stop, for instance).
#pragma once

#include "base/check.h"
#include "rows/row.h"

namespace epode {

struct StepInfo {
    Real h = 0;    // step size, s
    Real fps = 0;  // 1/h
    Real erp = 0;  // of the world
    Real cfm = 0;  // of the world
    Real contact_layer = 0;     // depth that contacts are allowed to keep, m
    Real contact_max_vel = kInf;  // cap of a contact's correcting velocity, m/s
    bool inner = false;           // an inner pose of a step already begun: row counts must not change
};

class RowWriter {
  public:
    RowWriter(Row* rows, const StepInfo& info) : rows_(rows), info_(info) {}

    const StepInfo& info() const { return info_; }
    int count() const { return count_; }

    // A fresh row with the world's ERP and CFM, no Jacobian, no bounds.
    Row& row(RowKind kind = RowKind::kLock)
    {
        EPODE_ASSERT(count_ < kMaxJointRows);
        Row& r = rows_[count_++];
        r = Row{};
        r.erp = info_.erp;
        r.cfm = info_.cfm;
        r.kind = kind;
        return r;
    }

    // Force and torque (about its centre) on the body at node 0 or 1 during this step.
    void apply(int node, Vec3 force, Vec3 torque)
    {
        force_[node] += force;
        torque_[node] += torque;
        applied_ = true;
    }

    bool applied() const { return applied_; }
    Vec3 force(int node) const { return force_[node]; }
    Vec3 torque(int node) const { return torque_[node]; }

  private:
    Row* rows_;
    const StepInfo& info_;
    int count_ = 0;
    bool applied_ = false;
    Vec3 force_[2], torque_[2];
};

}  // namespace epode
