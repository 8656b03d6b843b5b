// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See fluid.h.
#include "robots/fluid.h"

#include <algorithm>

#include "robots/kinematics.h"

namespace epode::robots {

namespace {

constexpr double kLeastMass = 1e-15;

double half_side(double mass, double own, double one, double two)
{
    return std::sqrt(std::max(0.0, 1.5 * (one + two - own) / mass));
}

// -c v, at most what stops the inertia within a step.
double resisted(double c, double v, double inertia, double h)
{
    return h > 0 && inertia > 0 ? -std::min(c, inertia / h) * v : -c * v;
}

}  // namespace

void make_fluid_boxes(RobotModel& model)
{
    if (!model.medium.acts()) return;
    for (size_t i = 1; i < model.links.size(); ++i) {
        Link& link = model.links[i];
        if (!(link.mass > kLeastMass)) continue;
        const auto [q, moments] = principal_axes(link.inertia, link.inertia_axes);
        const double m = link.mass, x = moments.x, y = moments.y, z = moments.z;
        link.boxes.push_back({{link.centre, q},
                              m,
                              moments,
                              {half_side(m, x, y, z), half_side(m, y, z, x), half_side(m, z, x, y)}});
    }
}

FluidForce fluid_force(const FluidBox& box, const Medium& medium, Vec v, Vec w, double h)
{
    const Vec r = box.half;
    const double mean = (r.x + r.y + r.z) / 3, viscosity = kPi * medium.viscosity;
    FluidForce out;
    for (int i = 0; i < 3; ++i) {
        const double rj = r[(i + 1) % 3], rk = r[(i + 2) % 3];
        const double drag = 2 * medium.density * rj * rk * std::fabs(v[i]) + 6 * viscosity * mean;
        const double spin =
            medium.density * r[i] * (rj * rj * rj * rj + rk * rk * rk * rk) * std::fabs(w[i]) / 2 +
            8 * viscosity * mean * mean * mean;
        out.force[i] = resisted(drag, v[i], box.mass, h);
        out.torque[i] = resisted(spin, w[i], box.moments[i], h);
    }
    return out;
}

std::vector<double> fluid_forces(const RobotModel& model, const std::vector<double>& positions,
                                 const std::vector<double>& velocities)
{
    const size_t n = size_t(number_of_velocities(model));
    std::vector<double> out(n, 0);
    const std::vector<Pose> poses = forward_kinematics(model, positions);
    for (size_t i = 1; i < model.links.size(); ++i)
        for (const FluidBox& box : model.links[i].boxes) {
            const std::vector<double> j = jacobian(model, positions, int(i), box.pose.p);
            double motion[6] = {};
            for (size_t row = 0; row < 6; ++row)
                for (size_t k = 0; k < n; ++k) motion[row] += j[row * n + k] * velocities[k];
            const Quat q = (poses[i] * box.pose).q, back = conjugate(q);
            const Vec v = Vec{motion[0], motion[1], motion[2]} - model.medium.wind;
            const FluidForce its = fluid_force(box, model.medium, rotate(back, v),
                                               rotate(back, {motion[3], motion[4], motion[5]}), 0);
            const Vec force = rotate(q, its.force), torque = rotate(q, its.torque);
            for (size_t k = 0; k < n; ++k)
                for (int axis = 0; axis < 3; ++axis)
                    out[k] +=
                        j[size_t(axis) * n + k] * force[axis] + j[size_t(axis + 3) * n + k] * torque[axis];
        }
    return out;
}

}  // namespace epode::robots
