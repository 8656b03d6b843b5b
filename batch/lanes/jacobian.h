// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Jacobians of a point of a link: column d is what a unit velocity of dof d makes of it,
//     linear S_v + S_w x p,     angular S_w,     p the point from O, of the dofs of the link's chain; 0 of all others.
// Angular velocities of floating bases are seen in their links' axes, w_world = R w, so those three columns are multiplied by R.
#pragma once

#include "batch/lanes/motion.h"

namespace epode::batch {
namespace {

template <typename P>
struct Jacobian {
    const ModelView& model;
    const Work<P>& work;  // once its motion is found
    P* out;               // six rows, linear then angular, of as many numbers as there are dofs

    P& at(int row, int dof) const { return out[row * model.velocities + dof]; }

    void find(int link, const Vec3Of<P>& point_local) const
    {
        for (int i = 0; i < 6 * model.velocities; ++i) out[i] = P(0);
        const LinkWork<P>& its = work.link[link];
        const Vec3Of<P> point = its.p + its.r * point_local;
        for (int d = model.links[link].last_dof, k = d < 0 ? -1 : model.dofs[d].depth; k >= 0; --k)
            put_column(model.chains[model.dofs[d].chain + k], point);
        for (const BatchJoint& joint : model.joints)
            if (joint.kind == JointKind::kFree)
                for (int row = 0; row < 6; ++row) turn(joint, row);
    }

    EPODE_LANEWISE void put_column(int dof, const Vec3Of<P>& point) const
    {
        const Spatial<P>& s = work.s[dof];
        const Vec3Of<P> linear = s.v + cross(s.w, point);
        at(0, dof) = linear.x, at(1, dof) = linear.y, at(2, dof) = linear.z;
        at(3, dof) = s.w.x, at(4, dof) = s.w.y, at(5, dof) = s.w.z;
    }

    EPODE_LANEWISE void turn(const BatchJoint& joint, int row) const
    {
        P* its = &at(row, joint.dof + 3);
        const Vec3Of<P> turned = transposed_times(work.link[joint.link].r, Vec3Of<P>{its[0], its[1], its[2]});
        its[0] = turned.x, its[1] = turned.y, its[2] = turned.z;
    }
};

}  // namespace
}  // namespace epode::batch
