// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a joint sees of a step: the numbers of the world that it may need, a place for up to six rows, and a
// place for forces that it applies directly (for instance a motor that works against its own stop).
#pragma once

#include "base/check.h"
#include "rows/row.h"

namespace epode {

struct StepInfo {
    Real h = 0;                   // step size, s
    Real fps = 0;                 // 1/h
    Real erp = 0;                 // of the world
    Real cfm = 0;                 // of the world
    Real contact_layer = 0;       // depth that contacts may keep, m
    Real contact_max_vel = kInf;  // limit of a contact's correcting velocity, m/s
    bool inner = false;           // a pose within a step that has begun: the number of rows must not change
};

class RowWriter {
  public:
    RowWriter(Row* rows, const StepInfo& info) : rows_(rows), info_(info) {}

    const StepInfo& info() const { return info_; }
    int count() const { return count_; }

    // A new row with the world's ERP and CFM and no bounds.
    Row& row(const Jacobian& J, Real error = 0, RowKind kind = RowKind::kLock)
    {
        EPODE_ASSERT(count_ < kMaxJointRows);
        Row& r = rows_[count_++];
        static_cast<Jacobian&>(r) = J;
        r.error = error;
        r.erp = info_.erp;
        r.cfm = info_.cfm;
        r.speed = 0;
        r.cap = kInf;
        r.restitution_velocity = 0;
        r.lo = -kInf, r.hi = kInf;
        r.parent = -1;
        r.kind = kind;
        r.has_restitution = r.soft = false;
        return r;
    }

    // All rows, written and to come, belong to one contact point: J = [d, r1 x d, -d, -(r2 x d)] for normal
    // and tangents. Solvers that pack contacts need the arms and not the products.
    void contact_at(Vec3 r1, Vec3 r2) { arms_ = {r1, r2}; }
    const ContactArms& arms() const { return arms_; }

    // The first three rows and those after them have this form (rows/row.h), with these arms.
    void point_at(Vec3 r1, Vec3 r2, RowForm form)
    {
        EPODE_ASSERT(count_ == 0);
        arms_ = {r1, r2};
        form_ = form;
    }
    RowForm form() const { return form_; }

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
    ContactArms arms_;
    RowForm form_ = RowForm::kFree;
};

}  // namespace epode
