// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From the leaves inwards: composite inertias and the forces on subtrees, so the mass matrix M_dk = S_k.(I S_d) along the chain of d
// and the bias c_d = S_d.f; then M = L' D L in place. Rows of chains are prefixes of one another, so both are loops over neighbours.
// Source: Featherstone, chapters 6 and 8.
#pragma once

#include "batch/lanes/work.h"

namespace epode::batch {
namespace {

template <typename P>
void gather_subtrees(const ModelView& model, Work<P>& work)
{
    for (int i = model.links.size(); i-- > 1;) {
        const BatchLink& link = model.links[i];
        if (link.parent == 0) continue;
        const LinkWork<P>& its = work.link[i];
        LinkWork<P>& parent = work.link[link.parent];
        parent.force = parent.force + its.force;
        Inertia<P>& sum = parent.inertia;
        const Inertia<P>& one = its.inertia;
        sum.m = sum.m + one.m, sum.h = sum.h + one.h;
        sum.j = {sum.j.xx + one.j.xx, sum.j.yy + one.j.yy, sum.j.zz + one.j.zz,
                 sum.j.xy + one.j.xy, sum.j.xz + one.j.xz, sum.j.yz + one.j.yz};
    }
}

// Six dofs of a floating base begin a chain: their motions are the world's axes, so their products are components.
template <typename P>
bool begins_afloat(const ModelView& model, const Dof& dof)
{
    return model.joints[model.dofs[model.chains[dof.chain]].joint].kind == JointKind::kFree;
}

template <typename P>
void fill_row(const ModelView& model, const Dof& dof, int number, Work<P>& work)
{
    const LinkWork<P>& link = work.link[dof.link];
    const Spatial<P> f = link.inertia * work.s[number];
    P* row = work.m + dof.row;
    const int* chain = model.chains.first + dof.chain;
    int k = 0;
    if (begins_afloat<P>(model, dof)) {
        const P parts[6] = {f.v.x, f.v.y, f.v.z, f.w.x, f.w.y, f.w.z};
        for (; k < 6 && k <= dof.depth; ++k) row[k] = parts[k];
    }
    for (; k <= dof.depth; ++k) row[k] = dot(work.s[chain[k]], f);
    row[dof.depth] = row[dof.depth] + work.added[number];
    work.torque[number] = work.torque[number] - dot(work.s[number], link.force);
}

template <typename P>
void find_mass(const ModelView& model, Work<P>& work)
{
    gather_subtrees(model, work);
    for (int i = 0; i < model.dofs.size(); ++i) fill_row(model, model.dofs[i], i, work);
}

template <typename P>
void factor(const ModelView& model, Work<P>& work)
{
    for (int i = model.dofs.size(); i-- > 0;) {
        const Dof& dof = model.dofs[i];
        P* row = work.m + dof.row;
        const int* chain = model.chains.first + dof.chain;
        const P inverse = P(1) / row[dof.depth];
        work.d[i] = inverse, work.root[i] = square_root(inverse);
        for (int k = dof.depth; k-- > 0;) {
            const P a = row[k] * inverse;
            P* above = work.m + model.dofs[chain[k]].row;
            for (int l = 0; l <= k; ++l) above[l] = above[l] - a * row[l];
            row[k] = a;
        }
    }
}

// x = L^-T x, in place: all dofs.
template <typename P>
void carry_down(const ModelView& model, const Work<P>& work, P* x)
{
    for (int i = model.dofs.size(); i-- > 0;) {
        const Dof& dof = model.dofs[i];
        const int* chain = model.chains.first + dof.chain;
        for (int k = 0; k < dof.depth; ++k) x[chain[k]] = x[chain[k]] - work.m[dof.row + k] * x[i];
    }
}

// z = D^1/2 L v + h D^-1/2 L^-T torque.
template <typename P>
void find_free_motion(const ModelView& model, const P* v, const P& h, Work<P>& work)
{
    carry_down(model, work, work.torque);
    for (int i = 0; i < model.dofs.size(); ++i) {
        const Dof& dof = model.dofs[i];
        const int* chain = model.chains.first + dof.chain;
        P sum = v[i];
        for (int k = 0; k < dof.depth; ++k) sum = sum + work.m[dof.row + k] * v[chain[k]];
        work.z[i] = sum * (P(1) / work.root[i]) + h * (work.root[i] * work.torque[i]);
    }
}

// v = L^-1 D^-1/2 z.
template <typename P>
void find_velocity(const ModelView& model, const Work<P>& work, const P* z, P* v)
{
    for (int i = 0; i < model.dofs.size(); ++i) {
        const Dof& dof = model.dofs[i];
        const int* chain = model.chains.first + dof.chain;
        P sum = z[i] * work.root[i];
        for (int k = 0; k < dof.depth; ++k) sum = sum - work.m[dof.row + k] * v[chain[k]];
        v[i] = sum;
    }
}

}  // namespace
}  // namespace epode::batch
