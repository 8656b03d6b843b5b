// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Points of pairs without a closed form. In lanes a bound decides which copies are near: the ball about one shape against the box about
// the other, and how far their points may approach in two steps. Those copies are asked for one by one (asked_pairs.h); the others'
// points are far.
#pragma once

#include "batch/lanes/motion.h"

namespace epode::batch {
namespace {

template <typename P>
struct Asked {
    using T = typename P::Number;
    const ModelView& model;
    const StepOptions& options;
    Work<P>& work;

    void find(const BatchPair& pair, const Placed<P>& a, const Placed<P>& b) const
    {
        const AskedPair& its = model.asked[pair.asked];
        const P reach = reach_of(pair, its, a), gap = least_gap(its, a, b);
        const P near = if_greater(reach, gap, P(1), P(0));
        for (int k = 0; k < pair.slots; ++k) {
            work.gaps[k] = P(T(kFar)), work.points[k] = {P(0), P(0), P(0)};
            work.normals[k] = {P(0), P(0), P(1)};
        }
        if (!any_positive(near)) return;
        for (int lane = 0; lane < P::kLanes; ++lane)
            if (near[lane] > 0) ask(pair, a, b, double(reach[lane]), lane);
    }

    static P norm(const Vec3Of<P>& x) { return square_root(dot(x, x)); }
    static Vec3Of<P> vec(const double* x) { return {P(T(x[0])), P(T(x[1])), P(T(x[2]))}; }
    static Vec3Of<P> centre(const AskedPair& its, const Placed<P>& a) { return a.at + a.r * vec(its.ball); }

    P least_gap(const AskedPair& its, const Placed<P>& a, const Placed<P>& b) const
    {
        const P radius(T(its.radius)), zero(0);
        const Vec3Of<P> local = transposed_times(b.r, centre(its, a) - b.at) - vec(its.middle),
                        half = vec(its.half);
        if (its.is_plane) return local.z - radius;
        const Vec3Of<P> out{at_least(zero, magnitude(local.x) - half.x),
                            at_least(zero, magnitude(local.y) - half.y),
                            at_least(zero, magnitude(local.z) - half.z)};
        return norm(out) - radius;
    }

    // Points of a move against b by no more than the ball's centre does and their turning about it.
    P reach_of(const BatchPair& pair, const AskedPair& its, const Placed<P>& a) const
    {
        const Support& support = model.supports[pair.support];
        const Spatial<P>&one = work.link[model.shapes[pair.shape_a].link].velocity,
              &two = work.link[model.shapes[pair.shape_b].link].velocity;
        const Vec3Of<P> at = centre(its, a);
        Vec3Of<P> apart{P(0), P(0), P(0)};
        P turn(0);
        if (support.of_a > 0) apart = one.v + cross(one.w, at), turn = norm(one.w);
        if (support.of_b > 0) {
            const Vec3Of<P> there = at - (work.origin[support.tree_b] - work.origin[support.tree_a]);
            apart = apart - (two.v + cross(two.w, there)), turn = turn + norm(two.w);
        }
        return P(T(options.reach)) + P(T(2 * options.h)) * (norm(apart) + P(T(its.radius)) * turn);
    }

    static AskedPose pose_of(const Placed<P>& its, int lane)
    {
        const auto one = [&](const P& x) { return double(x[lane]); };
        const Vec3Of<P>* rows[] = {&its.r.row0, &its.r.row1, &its.r.row2};
        AskedPose out{{one(its.at.x), one(its.at.y), one(its.at.z)}, {}};
        for (int k = 0; k < 3; ++k)
            out.turn[3 * k] = one(rows[k]->x), out.turn[3 * k + 1] = one(rows[k]->y),
                         out.turn[3 * k + 2] = one(rows[k]->z);
        return out;
    }

    void ask(const BatchPair& pair, const Placed<P>& a, const Placed<P>& b, double reach, int lane) const
    {
        AskedPoint found[Work<P>::kMostPoints];
        const double layer = options.reach < kLayer ? options.reach : kLayer;
        const int count = work.asker.ask(work.asker.context, pair.asked, pose_of(a, lane), pose_of(b, lane),
                                         reach, layer, pair.slots, found);
        for (int k = 0; k < count; ++k) {
            const AskedPoint& its = found[k];
            work.gaps[k].set(lane, T(its.gap));
            put(work.points[k], its.point, lane), put(work.normals[k], its.normal, lane);
        }
    }

    static void put(Vec3Of<P>& to, const double* from, int lane)
    {
        to.x.set(lane, T(from[0])), to.y.set(lane, T(from[1])), to.z.set(lane, T(from[2]));
    }

    static constexpr double kFar = 1e6, kLayer = 0.001;  // m
};

}  // namespace
}  // namespace epode::batch
