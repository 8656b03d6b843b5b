// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What one step of a group of copies computes, a pack (one number of each copy) for every number. Spatial vectors are in the world's
// axes about O, the origin of their tree: of a floating one the place of its root link, of a fixed one where that stands at the
// reference. Composites then only add.
//   S   motion of a dof at unit velocity         V   velocity of a link          A   its acceleration with vdot = 0, gravity taken off
//   I   inertia of a link, m, h = m c, J about O     (after composition: of the link with all that hangs on it)
//   f   force on a link, then on its subtree
//   M   mass matrix, with armature and implicit dampers on its diagonal; in place of it then L and D with M = L' D L
//   z   D^1/2 L v, in which every constraint's row is y = D^-1/2 L^-T J', so that J v = y.z
#pragma once

#include <cstddef>
#include <type_traits>

#include "batch/lanes/options.h"
#include "batch/model/model_view.h"
#include "simd/pack.h"
#include "simd/pack_algebra.h"

namespace epode::batch {
namespace {

template <typename P>
struct Spatial {
    Vec3Of<P> w, v;  // angular, linear; of a force the torque and the force
};

template <typename P>
EPODE_LANEWISE Spatial<P> operator+(const Spatial<P>& a, const Spatial<P>& b)
{
    return {a.w + b.w, a.v + b.v};
}

template <typename P>
EPODE_LANEWISE Spatial<P> operator*(const P& s, const Spatial<P>& a)
{
    return {s * a.w, s * a.v};
}

template <typename P>
EPODE_LANEWISE P dot(const Spatial<P>& a, const Spatial<P>& b)
{
    return dot(a.w, b.w) + dot(a.v, b.v);
}

template <typename P>
struct Inertia {
    P m;
    Vec3Of<P> h;
    Sym3Of<P> j;
};

// Momentum of a motion, force of an acceleration.
template <typename P>
EPODE_LANEWISE Spatial<P> operator*(const Inertia<P>& i, const Spatial<P>& a)
{
    return {i.j * a.w + cross(i.h, a.v), i.m * a.v - cross(i.h, a.w)};
}

template <typename P>
struct LinkWork {
    Vec4Of<P> q;
    Mat3Of<P> r;
    Vec3Of<P> p;  // of the link's origin, from O
    Spatial<P> velocity, acceleration, force;
    Inertia<P> inertia;
};

template <typename P>
struct Placed {  // a shape, from its own tree's O
    Vec3Of<P> at;
    Mat3Of<P> r;
    P x, y, z;  // sizes

    EPODE_LANEWISE Vec3Of<P> axis() const { return {r.row0.z, r.row1.z, r.row2.z}; }
};

// Two directions whose impulses stay within a disc: what they do to one another.
template <typename P>
struct Disc {
    P a, b, c, e;     // the block y.y of the two; its largest eigenvalue, 0 in copies that are far
    P inverse, step;  // 1 / (a c - b^2), 1 / e
};

// A contact that is near in some copy.
template <typename P>
struct ContactRow {
    const Support* support;
    P* y;                          // of normal and two tangents, one behind the other along the support
    P* impulse;                    // three
    P bias, soft, mass, friction;  // J v + soft impulse >= bias; 1 / mass = 1 / (y.y + soft)
    P d, n1, n2;                   // y.y + soft; normal times tangents
    Disc<P> tangents;
    P* shares;     // what loops have taken of the three y (loops.h); null: nothing
    P gap, slope;  // of the bias (singles.h)
};

// Friction of a contact against turning about its normal and rolling about its tangents: torques that lengths times its normal force
// bound, the former by itself, the latter in a disc.
template <typename P>
struct TurnRow {
    const Support* support;
    P* y;
    const P* normal;              // impulse
    P* impulse;                   // three
    P torsion, rolling, d, mass;  // the lengths; y.y of the normal, 0 in copies that are far, and 1 / it
    Disc<P> tangents;
    P* shares;
    bool rolls;
};

// A row of one direction: a limit, dry friction, a limited servo, a sum of coordinates.
template <typename P>
struct SingleRow {
    const P* y;
    P* const* z;  // of the dofs that it moves, as many as its width
    int width;
    P* impulse;
    P sign, bias, soft, d, mass, low, high;
    const P* shares;
    P gap, slope;  // of the bias (singles.h), where it has one
    bool has_gap;
};

// What a limited servo of a dof asks for: force - gain v+, gain = d + h k. Where a row is wanted, wanted is 1.
template <typename P>
struct ServoWork {
    P force, gain, wanted;
};

// A weighted sum of coordinates, and what springs and servos on it ask for.
template <typename P>
struct SumWork {
    P length;
    ServoWork<P> drive;
    P slope;  // of a bent coupling's polynomial
};

// All of it lies in one block of memory: laid out once to find its size, and once for good, for all steps.
template <typename P>
struct Work {
    using T = typename P::Number;

    LinkWork<P>* link;
    Spatial<P>* s;      // of each dof
    Vec3Of<P>* origin;  // O of each tree, in the world; one more, the world's own
    P *m, *d, *root;    // L below its diagonal, along chains; D^-1; D^-1/2
    P *torque, *added;  // of dofs; what joins M's diagonal
    ServoWork<P>* servos;
    SumWork<P>* sums;
    P *sum_y, *scattered;  // y of sums; a number of each dof
    P** sum_z;
    bool* sum_ready;  // whose y is known
    P* activations;   // of filters, after the step
    P *z, *v;
    P **chain_z, **support_z;   // where z of the dofs of chains and supports is
    Placed<P>* placed;          // shapes
    P *before, *last, *change;  // of extrapolation (solve.h)
    P* rows;
    P* columns;  // y of single dofs, along their chains
    bool* has_column;
    ContactRow<P>* contacts;
    TurnRow<P>* turns;
    SingleRow<P>* singles;
    P *impulses, *last_impulses;
    // Of loops (loops.h): E, R, 1 / its diagonal, what E has taken of z, how
    // velocities back are damped and those along E; y of dofs that they widen, and what
    // they have taken of all rows.
    P *loop_y, *loop_r, *loop_inverse, *loop_taken, *loop_gain, *loop_back, *wide_y, *shares;
    Vec3Of<P>* loop_axes;  // of rows, in the world
    bool* has_wide;
    P *moved, *moving;  // how positions move: so, or as v
    P* gaps;            // of a pair's points
    Vec3Of<P>*points, *normals;
    Asker asker;
    int contact_count, turn_count, single_count, row_end;
    P worst, sweeps;  // residual at the end, sweeps taken

    EPODE_LANEWISE std::size_t lay_out(const ModelView& model, char* memory)
    {
        std::size_t end = 0;
        const auto place = [&](auto*& to, int count) EPODE_INLINE_LAMBDA {
            using X = std::remove_reference_t<decltype(*to)>;
            to = reinterpret_cast<X*>(memory + end);
            end += (std::size_t(count) * sizeof(X) + 63) / 64 * 64;
        };
        const int dofs = model.dofs.size(), impulse_count = model.impulses();
        place(link, model.links.size()), place(s, dofs), place(origin, model.trees + 1);
        place(m, model.entries), place(d, dofs), place(root, dofs), place(torque, dofs), place(added, dofs);
        place(servos, model.servos), place(z, dofs), place(v, dofs), place(chain_z, model.chains.size()),
            place(support_z, model.support_dofs.size());
        place(placed, model.shapes.size()), place(before, dofs), place(last, dofs), place(change, dofs);
        int widest = 0;
        for (const BatchPair& pair : model.pairs)
            widest += (pair.first_turn < 0 ? 3 : 6) * pair.slots * model.supports[pair.support].width;
        place(rows, widest), place(columns, model.entries), place(has_column, dofs);
        place(contacts, model.slots), place(turns, model.turns),
            place(singles, model.limits + model.dry + model.servos + model.sum_rows);
        place(sums, model.sums.size()), place(sum_y, model.sum_dofs.size()), place(scattered, dofs),
            place(sum_z, model.sum_dofs.size()), place(sum_ready, model.sums.size());
        place(activations, model.filters);
        const int rows_of_loops = model.loop_rows, held = rows_of_loops > 0 ? dofs : 0;
        place(loop_y, rows_of_loops * model.loop_dofs.size()), place(loop_r, rows_of_loops * rows_of_loops),
            place(loop_inverse, rows_of_loops), place(loop_taken, rows_of_loops),
            place(loop_gain, rows_of_loops), place(loop_back, rows_of_loops), place(loop_axes, rows_of_loops),
            place(moved, held), place(wide_y, model.wide), place(has_wide, held);
        place(shares, rows_of_loops * (dofs + model.sums.size() + 3 * (model.slots + model.turns)));
        moving = rows_of_loops > 0 ? moved : v;
        place(impulses, impulse_count), place(last_impulses, impulse_count);
        place(gaps, kMostPoints), place(points, kMostPoints), place(normals, kMostPoints);
        return end;
    }

    // Once laid out.
    EPODE_LANEWISE void point(const ModelView& model)
    {
        for (int i = 0; i < model.chains.size(); ++i) chain_z[i] = z + model.chains[i];
        for (int i = 0; i < model.support_dofs.size(); ++i) support_z[i] = z + model.support_dofs[i];
        for (int i = 0; i < model.sum_dofs.size(); ++i) sum_z[i] = z + model.sum_dofs[i];
    }

    static constexpr int kMostPoints = 8;  // of a pair
};

// Numbers of the model: those that all copies share, or rows of lanes of their own.
template <typename P, bool own>
struct Numbers {
    const typename P::Number* at;
    EPODE_LANEWISE P operator[](int i) const
    {
        if constexpr (!own) return P(at[i]);
        P out;
        __builtin_memcpy(&out, at + i * P::kLanes, sizeof out);
        return out;
    }
    EPODE_LANEWISE Vec3Of<P> vec(int i) const { return {(*this)[i], (*this)[i + 1], (*this)[i + 2]}; }
    EPODE_LANEWISE Vec4Of<P> quat(int i) const
    {
        return {(*this)[i], (*this)[i + 1], (*this)[i + 2], (*this)[i + 3]};
    }
};

}  // namespace
}  // namespace epode::batch
