// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What still air or water takes from links, each as boxes that have its inertia (robots/fluid.h has the law): along the box's axes a
// force -c v, c = quadratic |v| + linear, but at most what stops its mass within the step; and so of its turning.
#pragma once

#include "batch/lanes/motion.h"

namespace epode::batch {
namespace {

template <typename P, bool own>
struct Medium {
    using T = typename P::Number;
    const ModelView& model;
    Numbers<P, own> numbers;
    P h;
    Work<P>& work;

    void find() const
    {
        const Vec3Of<P> wind = numbers.vec(model.wind);
        for (const BatchBox& box : model.boxes) resist(box, wind);
    }

    // Taken off what accelerates the link.
    void resist(const BatchBox& box, const Vec3Of<P>& wind) const
    {
        LinkWork<P>& link = work.link[box.link];
        const Mat3Of<P> r = matrix_of(link.q * numbers.quat(box.first + box_number::kTurn));
        const Vec3Of<P> at = link.p + link.r * numbers.vec(box.first + box_number::kPlace);
        const Vec3Of<P> v = transposed_times(r, link.velocity.v + cross(link.velocity.w, at) - wind);
        const Vec3Of<P> w = transposed_times(r, link.velocity.w);
        const Vec3Of<P> force = r * resisted(box.first, v),
                        torque = r * resisted(box.first + box_number::kSpin, w);
        link.force.v = link.force.v + force;
        link.force.w = link.force.w + torque + cross(at, force);
    }

    // c v of three axes, whose inertias, quadratic and linear coefficients stand one behind the other.
    Vec3Of<P> resisted(int first, const Vec3Of<P>& v) const
    {
        const auto axis = [&](int k, const P& x) {
            const P most = numbers[first + box_number::kInertias + k] / h;
            const P c = numbers[first + box_number::kQuadratic + k] * magnitude(x) +
                        numbers[first + box_number::kLinear + k];
            return at_most(c, most) * x;
        };
        return {axis(0, v.x), axis(1, v.y), axis(2, v.z)};
    }
};

}  // namespace
}  // namespace epode::batch
