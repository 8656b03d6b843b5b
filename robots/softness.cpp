// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "robots/softness.h"

#include <algorithm>
#include <cmath>

#include "robots/kinematics.h"
#include "robots/mass_factor.h"

namespace epode::robots {

namespace {

constexpr double kLeastImpedance = 1e-4, kMostImpedance = 0.9999;  // what MuJoCo clamps to

// Between 0 and 1 as x is: x^p scaled up to the middle, its mirror image from there on.
double sigmoid(double x, double middle, double power)
{
    if (x >= 1) return 1;
    if (x <= middle) return std::pow(x, power) / std::pow(middle, power - 1);
    return 1 - std::pow(1 - x, power) / std::pow(1 - middle, power - 1);
}

double impedance(const Softness& s, double r)
{
    const double x = s.width > 0 ? r / s.width : 1;
    const double d =
        s.low + (s.high - s.low) * sigmoid(x, std::clamp(s.middle, 1e-4, 0.9999), std::max(1.0, s.power));
    return std::clamp(d, kLeastImpedance, kMostImpedance);
}

Spring spring_at(const Softness& s, double inverse_mass, double r)
{
    const double d = impedance(s, r), largest = std::clamp(s.high, kLeastImpedance, kMostImpedance);
    const double regular = inverse_mass * (1 - d) / d;
    const bool direct = s.time <= 0;
    const double k = direct ? -s.time * d / (largest * largest) : d / std::pow(largest * s.time * s.ratio, 2);
    const double b = direct ? -s.ratio / largest : 2 / (largest * s.time);
    return {k / regular, b / regular};
}

bool is_soft(const RobotModel& model)
{
    const auto shape_is = [](const Shape& shape) { return shape.softness.stated; };
    for (const Link& link : model.links)
        if (std::any_of(link.shapes.begin(), link.shapes.end(), shape_is)) return true;
    for (const ShapePair& pair : model.pairs)
        if (pair.softness.stated) return true;
    return std::any_of(model.joints.begin(), model.joints.end(),
                       [](const Joint& joint) { return joint.stop_softness.stated; });
}

}  // namespace

Spring spring_of(const Softness& softness, double inverse_mass, double load)
{
    if (!softness.stated || !(inverse_mass > 0) || !(load > 0)) return {};
    double low = 0, high = 1e-9;
    const auto carries = [&](double r) { return spring_at(softness, inverse_mass, r).stiffness * r >= load; };
    while (!carries(high) && high < 1e3) high *= 2;
    for (int i = 0; i < 60; ++i) (carries((low + high) / 2) ? high : low) = (low + high) / 2;
    const Spring spring = spring_at(softness, inverse_mass, high);
    return std::isfinite(spring.stiffness) && std::isfinite(spring.damping) && spring.damping >= 0 ? spring
                                                                                                   : Spring{};
}

Springs::Springs(const RobotModel& model)
{
    if (model.has_errors() || !is_soft(model)) return;
    const std::vector<double> positions = reference_positions(model);
    const MassFactor masses(model);
    const size_t n = masses.size();
    if (!masses.is_good()) return;
    carried_.resize(model.links.size());
    for (size_t i = model.links.size(); i-- > 1;) {
        carried_[i] += model.links[i].mass;
        carried_[size_t(model.links[i].parent)] += carried_[i];
    }
    weight_ = carried_[0] * length(model.gravity);
    for (size_t i = 0; i < model.links.size(); ++i) {
        const std::vector<double> j = jacobian(model, positions, int(i), model.links[i].centre);
        double sum = 0;
        for (size_t row = 0; row < 3; ++row) sum += masses.inverse_mass(&j[row * n]);
        of_links_.push_back(sum / 3);
    }
    std::vector<double> unit(n);
    for (size_t i = 0; i < n; ++i) {
        unit.assign(n, 0), unit[i] = 1;
        of_velocities_.push_back(masses.inverse_mass(unit.data()));
    }
}

Spring Springs::of_shape(int link, const Shape& shape) const
{
    if (of_links_.empty()) return {};
    return spring_of(shape.softness, of_links_[size_t(link)], weight_ / 2);
}

Spring Springs::of_pair(int link1, int link2, const Softness& softness) const
{
    if (of_links_.empty()) return {};
    return spring_of(softness, of_links_[size_t(link1)] + of_links_[size_t(link2)], weight_ / 2);
}

Spring Springs::of_limit(const RobotModel& model, int joint) const
{
    const Joint& its = model.joints[size_t(joint)];
    if (of_velocities_.empty() || its.kind == JointKind::kFree) return {};
    const double inverse = of_velocities_[size_t(velocity_of(model, joint))],
                 mass = carried_[size_t(its.link)];
    const bool turns = its.kind != JointKind::kSlide;
    const double radius = turns && mass > 0 ? 1 / std::sqrt(inverse * mass) : 1;
    return spring_of(its.stop_softness, inverse, weight_ / 2 * radius);
}

}  // namespace epode::robots
