// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Joints as the kernels read them, kLanes side by side: joints of one form, with equal numbers of rows and of
// bounded rows, none of which shares a dynamic body with another. Their numbers follow each other as Lanes or
// FloatLanes, in the order of JointLayout. A ball joint needs 280 bytes in doubles and half of that in
// floats, where three rows with their Jacobians and M^-1 J^T take 600: in a net of joints that no longer fits
// the caches, a sweep is as fast as the numbers arrive.
#pragma once

#include "rows/row.h"
#include "simd/lanes.h"
#include "simd/lanewise.h"

namespace epode {

static_assert(kLanes == kFloatLanes);  // batches are the same in both

struct JointBatch {
    RowForm form;
    int rows, bounded;                 // the last `bounded` rows have bounds
    int count;                         // joints; the lanes after them are empty
    int at;                            // the first of its numbers
    int facts;                         // the first of its facts; -1: rows are evaluated by the joints
    bool has_restitution;              // with facts: true if some of its rows may
    int body1[kLanes], body2[kLanes];  // into the velocities
};

// Where the numbers of a batch are.
struct JointLayout {
    int arms, directions, axes;  // r1 and r2; three vectors of a turned point; one vector per row after it
    int matrix;                  // lower triangle, row by row: see joint_kernels.inc
    int C, c, p;                 // per row
    int lo, hi;                  // per bounded row
    int relaxed;                 // per row: c of relaxing sweeps
    int sum;                     // per row: sum of p over the earlier substeps
    int size;

    static constexpr int kInvMass = 0, kInvInertia = 2, kGeometry = 14;  // two masses, two tensors of six

    EPODE_LANEWISE constexpr JointLayout(RowForm form, int rows, int bounded)
        : arms(kGeometry),
          directions(kGeometry + 6),
          axes(directions + (form == RowForm::kTurned ? 9 : 0)),
          matrix(form == RowForm::kFree ? kGeometry + 12 * rows : axes + 3 * (rows - 3)),
          C(matrix + rows * (rows + 1) / 2),
          c(C + rows),
          p(c + rows),
          lo(p + rows),
          hi(lo + bounded),
          relaxed(hi + bounded),
          sum(relaxed + rows),
          size(sum + rows)
    {}
    EPODE_LANEWISE explicit constexpr JointLayout(const JointBatch& b)
        : JointLayout(b.form, b.rows, b.bounded)
    {}

    // Twelve numbers of a row of free form.
    EPODE_LANEWISE static constexpr int jacobian(int row) { return kGeometry + 12 * row; }
    EPODE_LANEWISE constexpr int entry(int i, int j) const
    {
        return matrix + (i >= j ? i * (i + 1) / 2 + j : j * (j + 1) / 2 + i);
    }
};

// The facts of a batch that is followed (solve/joints/joint_follow.inc), of a point form.
struct FactLayout {
    int anchors, directions, axes;  // in the bodies' frames; directions and axes in that of the guide
    int apart;                      // orientation of the other body seen from the guide, at the beginning
    int side;                       // 1: body 1 is the guide, -1: body 2
    int gap;                        // between the anchors, where the geometry is
    int start;                      // per row: its error at the beginning
    int rate, speed;                // c = rate * error + speed
    int keeps;                      // 1: relaxing sweeps aim at c too, else at speed
    int made;                       // orientations of both bodies when the matrix was made; zero: never
    int slack;  // how far they may be from these before it is recomputed: 1 - cos of half the angle
    int size;

    EPODE_LANEWISE constexpr FactLayout(RowForm form, int rows)
        : anchors(0),
          directions(6),
          axes(directions + (form == RowForm::kTurned ? 9 : 0)),
          apart(axes + 3 * (rows - 3)),
          side(apart + 4),
          gap(side + 1),
          start(gap + 3),
          rate(start + rows),
          speed(rate + rows),
          keeps(speed + rows),
          made(keeps + rows),
          slack(made + 8),
          size(slack + 1)
    {}
    EPODE_LANEWISE explicit constexpr FactLayout(const JointBatch& b) : FactLayout(b.form, b.rows) {}
};

}  // namespace epode
