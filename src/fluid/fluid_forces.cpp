// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "fluid/fluid_forces.h"

#include <algorithm>

#include "base/check.h"
#include "fluid/water_level.h"
#include "math/cholesky.h"

namespace epode {
namespace {

constexpr int kStride = padded(6);
constexpr Real kBalanceTime = Real(0.5);  // s in which what floats may not leave rest

// Symmetric, of linear and angular velocity; only the lower triangle is kept.
struct Matrix6 {
    Real at[6 * kStride] = {};

    void add(int i, int j, Real x) { at[i * kStride + j] += x; }
    void add_angular(const Sym3& s)
    {
        add(3, 3, s.xx), add(4, 4, s.yy), add(5, 5, s.zz);
        add(4, 3, s.xy), add(5, 3, s.xz), add(5, 4, s.yz);
    }
    // k J^T P J, J = (1, -[r]), P symmetric.
    void add_at(Vec3 r, const Sym3& p)
    {
        const Mat3 P = full(p), turned = skew(r) * P, moment = turned * transpose(skew(r));
        for (int i = 0; i < 3; ++i)
            for (int j = 0; j < 3; ++j) {
                if (j <= i) add(i, j, P.row(i)[j]), add(3 + i, 3 + j, moment.row(i)[j]);
                add(3 + i, j, turned.row(i)[j]);
            }
    }
    void add(const Matrix6& other, Real k)
    {
        for (int i = 0; i < 6 * kStride; ++i) at[i] += k * other.at[i];
    }
    // Of the full matrix with x.
    void multiply(const Real (&x)[6], Real (&out)[6]) const
    {
        for (int i = 0; i < 6; ++i) {
            out[i] = 0;
            for (int j = 0; j < 6; ++j) out[i] += at[i >= j ? i * kStride + j : j * kStride + i] * x[j];
        }
    }
};

class BodyForces {
  public:
    BodyForces(const World& world, const Body& body, Real h)
        : body_(body),
          h_(h),
          gravity_(body.gravity ? world.gravity : Vec3{}),
          inertia_(rotate(body.rotation(), body.inertia))
    {}

    void add(const Fluid& fluid, Geom& geom)
    {
        FloatingGeom floating;
        const GeomHold hold(geom, fluid.has_functions());
        if (!floating.take(geom)) return;
        const WaterPlane level = level_at(fluid, floating);
        const Immersed part = floating.under(in_frame(level, floating.pose()));
        if (!(part.volume > 0)) return;
        const Vec3 centre = floating.pose().to_world(part.centre());
        if (!holds(fluid, centre)) return;
        wet_ = true, restless_ = restless_ || fluid.has_functions();
        add_buoyancy(fluid, floating, level, part.volume, centre);
        add_drag(fluid, floating, part.volume, centre);
    }

    BodyInFluid result()
    {
        BodyInFluid out;
        if (!wet_) return out;
        out.wet = true, out.restless = restless_;
        const bool held = body_.joints || body_.manifolds;
        Real change[6];
        const Vec3 p = held ? Vec3{} : load(body_.facc) + body_.mass.mass * gravity_;
        const Vec3 q = held ? Vec3{} : load(body_.tacc);
        if (!velocity_change(held ? Vec3{} : p + buoyancy_, held ? Vec3{} : q + moment_, change)) return out;
        const Vec3 dv{change[0], change[1], change[2]}, dw{change[3], change[4], change[5]};
        out.force = (body_.mass.mass / h_) * dv - p, out.torque = (Real(1) / h_) * (inertia_ * dw) - q;
        if (held) out.force += buoyancy_, out.torque += moment_;
        if (!usable(&out.force.x, 3) || !usable(&out.torque.x, 3)) out.force = out.torque = {};
        out.floats = !restless_ && is_balanced(out);
        return out;
    }

  private:
    void add_buoyancy(const Fluid& fluid, const FloatingGeom& geom, const WaterPlane& level, Real volume,
                      Vec3 centre)
    {
        const Real weight = fluid.settings.density * std::max(Real(0), -dot(gravity_, level.normal));
        const Vec3 force = (weight * volume) * level.normal, r = centre - body_.position();
        buoyancy_ += force, moment_ += cross(r, force);
        const WaterPlane local = in_frame(level, geom.pose());
        // What is near enough to reach the surface within the step counts as cut by it.
        const Real near =
            h_ * std::fabs(dot(body_.point_velocity(centre), level.normal)) + h_ * h_ * length(gravity_);
        if (std::fabs(local.height(geom.middle())) >= dot(abs(local.normal), geom.half_extent()) + near)
            return;
        // The waterplane is at most the shadow along its normal, and reaches as far as the geom.
        const Real k = weight * geom.shadow(local.normal), turn = k * length2(geom.half_extent()) / 4;
        const Vec3 n = level.normal;
        stiffness_.add_at(
            r, {k * n.x * n.x, k * n.y * n.y, k * n.z * n.z, k * n.x * n.y, k * n.x * n.z, k * n.y * n.z});
        stiffness_.add_angular({turn * (1 - n.x * n.x), turn * (1 - n.y * n.y), turn * (1 - n.z * n.z),
                                -turn * n.x * n.y, -turn * n.x * n.z, -turn * n.y * n.z});
    }

    void add_drag(const Fluid& fluid, const FloatingGeom& geom, Real volume, Vec3 centre)
    {
        const dFluidSettings& s = fluid.settings;
        if (s.drag == 0 && s.linear_drag == 0 && s.angular_drag == 0) return;
        const Real whole = geom.whole().volume;
        const Real share = whole > volume ? volume / whole : Real(1);
        const Vec3 current = current_at(fluid, centre), r = centre - body_.position();
        const Vec3 u = body_.point_velocity(centre) - current;
        const Real speed = length(u);
        const Vec3 along = normalized_or(transposed_times(geom.pose().R, u), {0, 0, 1});
        const Real k = (s.density / 2 * s.drag * speed + s.linear_drag) * share * geom.shadow(along);
        drag_.add_at(r, {k, k, k, 0, 0, 0});
        const Vec3 carried = k * current, turned = cross(r, carried);
        for (int i = 0; i < 3; ++i) carried_[i] += carried[i], carried_[3 + i] += turned[i];
        drag_.add_angular(rotate(geom.pose().R, turning(s, geom, share)));
    }

    Sym3 turning(const dFluidSettings& s, const FloatingGeom& geom, Real share) const
    {
        const Vec3 d = 2 * geom.half_extent(),
                   w = abs(transposed_times(geom.pose().R, body_.angular_velocity()));
        const Vec3 d3 = scale(d, scale(d, d)), d4 = scale(d3, d);
        const auto about = [&](int i, int j, int k) {
            return s.angular_drag * share * d[i] *
                   (s.density / 64 * (d4[j] + d4[k]) * w[i] + s.linear_drag / 12 * (d3[j] + d3[k]));
        };
        return {about(0, 1, 2), about(1, 2, 0), about(2, 0, 1), 0, 0, 0};
    }

    // A bound of (w h)^2: the trace of h^2 M^-1 K, with the rotation in the body's frame.
    Real stiffness_ratio() const
    {
        const auto k = [&](int i) { return stiffness_.at[i * kStride + i]; };
        const Sym3 I = rotate(body_.rotation(), body_.inv_inertia);
        const Sym3 turning{k(3),
                           k(4),
                           k(5),
                           stiffness_.at[4 * kStride + 3],
                           stiffness_.at[5 * kStride + 3],
                           stiffness_.at[5 * kStride + 4]};
        const Real turned = I.xx * turning.xx + I.yy * turning.yy + I.zz * turning.zz +
                            2 * (I.xy * turning.xy + I.xz * turning.xz + I.yz * turning.yz);
        return h_ * h_ * ((k(0) + k(1) + k(2)) * body_.inv_mass + turned);
    }

    // (M + h (C + h beta K)) (v+ - v) = h (f - (C + h beta K) v + C u_fluid); false: not finite.
    bool velocity_change(Vec3 f, Vec3 t, Real (&change)[6]) const
    {
        Matrix6 A;
        const Real m = body_.mass.mass;
        for (int i = 0; i < 3; ++i) A.add(i, i, m);
        A.add_angular(inertia_);
        const Real ratio = stiffness_ratio();
        Matrix6 damping = drag_;
        if (ratio > 2) damping.add(stiffness_, h_ * (1 - 2 / ratio));
        A.add(damping, h_);
        const Vec3 v = body_.velocity(), w = body_.angular_velocity();
        const Real before[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
        Real dragged[6];
        damping.multiply(before, dragged);
        for (int i = 0; i < 3; ++i) {
            change[i] = h_ * (f[i] - dragged[i] + carried_[i]);
            change[3 + i] = h_ * (t[i] - dragged[3 + i] + carried_[3 + i]);
        }
        if (!usable(A.at, 6 * kStride) || !usable(change, 6) || !factor_cholesky(A.at, 6)) return false;
        solve_cholesky(A.at, change, 6);
        return usable(change, 6);
    }

    // Would its acceleration leave it below the thresholds of sleep for some time?
    bool is_balanced(const BodyInFluid& fluid) const
    {
        const Vec3 a = body_.inv_mass * (load(body_.facc) + fluid.force) + gravity_;
        const Vec3 b = rotate(body_.rotation(), body_.inv_inertia) * (load(body_.tacc) + fluid.torque);
        constexpr Real kT2 = kBalanceTime * kBalanceTime;
        return length2(a) * kT2 <= body_.sleep.linear_threshold2 &&
               length2(b) * kT2 <= body_.sleep.angular_threshold2;
    }

    const Body& body_;
    Real h_;
    Vec3 gravity_;
    Sym3 inertia_;
    bool wet_ = false, restless_ = false;
    Vec3 buoyancy_, moment_;
    Real carried_[6] = {};  // C u_fluid
    Matrix6 drag_, stiffness_;
};

}  // namespace

BodyInFluid fluid_forces(const World& world, const Body& body, Real h)
{
    if (body.kinematic() || !body.first_geom) return {};
    BodyForces forces(world, body, h);
    for (const Fluid* fluid : world.fluids)
        for_each_geom_from(body.first_geom, [&](Geom& geom) { forces.add(*fluid, geom); });
    return forces.result();
}

}  // namespace epode
