// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a joint sees of a step: the numbers of the world that it may need, a place for its rows (up to six of
// its own and those of its drives), and a place for forces that it applies directly (for instance a motor
// that works against its own stop).
#pragma once

#include <span>

#include "base/check.h"
#include "rows/row.h"

namespace epode {

struct StepInfo {
    Real h = 0;                   // step size, s
    Real fps = 0;                 // 1/h
    Real erp = 0;                 // of the world
    Real cfm = 0;                 // of the world
    Real contact_layer = 0;       // depth that contacts may keep, m
    Real touching_depth = 0;      // that contacts of several points keep, beyond rounding, m
    Real contact_max_vel = kInf;  // limit of a contact's correcting velocity, m/s
    Real least_correction = 0;    // of world-managed contacts that are rows: slower ones are left out, m/s
    Real correction = 1;          // share of the errors of positions that contacts without rows correct
    bool cone = false;            // friction of contact joints is bounded by an ellipse, not a box
    bool friction_along_slip = false;  // of world-managed contacts: the first direction
    bool inner = false;  // a pose within a step that has begun: the number of rows must not change
};

// Of a joint's bodies, zero for the world; of a coupling's, in the order of its terms.
struct BodyMotion {
    Vec3 v, w;
};

struct Body;

// The part of a coupling's Jacobian that belongs to one body.
struct BodyTerm {
    Body* body;
    Vec3 lin, ang;
};

// Of a coupling: two per axis.
inline constexpr int kMaxBodyTerms = 16;

class RowWriter {
  public:
    RowWriter(Row* rows, const StepInfo& info) : rows_(rows), info_(info) {}

    const StepInfo& info() const { return info_; }
    int count() const { return count_; }

    // A new row with the world's ERP and CFM and no bounds.
    Row& row(const Jacobian& J, Real error = 0, RowKind kind = RowKind::kLock)
    {
        EPODE_ASSERT(count_ < kMaxBlockRows);
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
        r.has_restitution = r.soft = r.given = false;
        r.drive = nullptr;
        return r;
    }

    // The program, and not the pose, determines the errors of the rows that are written.
    void mark_given()
    {
        for (int i = 0; i < count_; ++i) rows_[i].given = true;
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
    // Rows that need more than a pose have no form: the joint is asked for them in every substep.
    RowForm form() const { return every_substep_ ? RowForm::kFree : form_; }
    void emit_every_substep() { every_substep_ = true; }
    bool holds_point() const { return form_ == RowForm::kPoint; }

    // Velocities at an inner pose, where the bodies still have those of the beginning of the step; else null.
    const BodyMotion* motion() const { return motion_; }
    void set_motion(const BodyMotion* motion) { motion_ = motion; }

    // All rows, written and to come, have this Jacobian, over any number of bodies, instead of their own. The
    // terms belong to the joint.
    void couple(std::span<const BodyTerm> terms)
    {
        EPODE_ASSERT(count_ == 0 && terms.size() <= kMaxBodyTerms);
        terms_ = terms;
    }
    std::span<const BodyTerm> terms() const { return terms_; }

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
    bool every_substep_ = false;
    const BodyMotion* motion_ = nullptr;
    std::span<const BodyTerm> terms_;
};

}  // namespace epode
