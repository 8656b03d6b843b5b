// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See wrench.h.
#include "robots/wrench.h"

#include <cmath>

namespace epode::robots {

namespace {

// The last link that both hang on, themselves counted.
int common_link(const RobotModel& model, int one, int two)
{
    while (one != two) (one > two ? one : two) = model.links[size_t(one > two ? one : two)].parent;
    return one;
}

Vec rotation_vector(Quat q)
{
    const Vec axis{q.x, q.y, q.z};
    const double sine = length(axis);
    if (sine < 1e-15) return {};
    const double angle = 2 * std::atan2(sine, q.w);
    return ((angle > kPi ? angle - 2 * kPi : angle) / sine) * axis;
}

Pose placed(int link, const Pose& at, const std::vector<Pose>& poses) { return poses[size_t(link)] * at; }

struct Crank {
    double length = 0;
    Vec along, across;  // the derivatives of the length by w and by a
};

Crank crank_of(double rod, Vec w, Vec a)
{
    const double along = dot(a, w), square = along * along + rod * rod - dot(w, w);
    if (!(square > 0)) return {along, a, w};
    const double d = std::sqrt(square), share = 1 - along / d;
    return {along - d, share * a + (1 / d) * w, share * w};
}

Vec axis_of(const Pose& slider) { return rotate(slider.q, {0, 0, 1}); }

}  // namespace

std::vector<LinkLoad> loads_of(const RobotModel& model, const SiteWrench& wrench,
                               const std::vector<Pose>& poses)
{
    const Pose site = placed(wrench.link, wrench.pose, poses);
    if (wrench.reference_link < 0)
        return {{wrench.link, site.p, rotate(site.q, wrench.force), rotate(site.q, wrench.torque)}};
    const Pose from = placed(wrench.reference_link, wrench.reference, poses);
    if (wrench.is_crank()) {
        const Vec a = axis_of(from);
        const Crank its = crank_of(wrench.rod, site.p - from.p, a);
        const double gear = wrench.force.x;
        return {{wrench.link, site.p, gear * its.along, {}},
                {wrench.reference_link, from.p, -gear * its.along, gear * cross(a, its.across)}};
    }
    const Vec f = rotate(from.q, wrench.force), t = rotate(from.q, wrench.torque);
    const int common = common_link(model, wrench.link, wrench.reference_link);
    return {{wrench.link, site.p, f, t},
            {wrench.reference_link, from.p, -f, -t},
            {common, from.p, {}, -cross(site.p - from.p, f)}};
}

double length_of(const SiteWrench& wrench, const std::vector<Pose>& poses)
{
    if (wrench.reference_link < 0) return 0;
    const Pose from = placed(wrench.reference_link, wrench.reference, poses),
               site = placed(wrench.link, wrench.pose, poses);
    if (wrench.is_crank())
        return wrench.force.x * crank_of(wrench.rod, site.p - from.p, axis_of(from)).length;
    const Pose at = inverse(from) * site;
    return dot(wrench.force, at.p) + dot(wrench.torque, rotation_vector(at.q));
}

std::vector<double> wrench_moments(const RobotModel& model, const std::vector<double>& positions,
                                   const SiteWrench& wrench)
{
    PointForces forces(model, positions);
    for (const LinkLoad& load : loads_of(model, wrench, forces.poses())) {
        forces.add(load.link, load.point, load.force);
        forces.add_torque(load.link, load.torque);
    }
    return forces.along_velocities();
}

}  // namespace epode::robots
