// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See same_model.h.
#include "same_model.h"

#include <algorithm>
#include <cmath>

namespace epode::robots {

namespace {

constexpr double kTolerance = 1e-9, kUnlimited = 1e9;

class Comparison {
  public:
    void same(const std::string& what, double a, double b)
    {
        const bool are_none = (a >= kUnlimited && b >= kUnlimited) || (a <= -kUnlimited && b <= -kUnlimited);
        if (are_none || std::fabs(a - b) <= kTolerance * std::max({1.0, std::fabs(a), std::fabs(b)})) return;
        found.push_back(what + ": " + std::to_string(a) + ", " + std::to_string(b));
    }
    void same(const std::string& what, const std::string& a, const std::string& b)
    {
        if (a != b) found.push_back(what + ": '" + a + "', '" + b + "'");
    }
    void same(const std::string& what, Vec a, Vec b)
    {
        for (int i = 0; i < 3; ++i) same(what, a[i], b[i]);
    }
    void same(const std::string& what, const Pose& a, const Pose& b)
    {
        same(what + " position", a.p, b.p);
        const Quat turn = conjugate(a.q) * b.q;
        same(what + " rotation", Vec{turn.x, turn.y, turn.z}, Vec{});
    }
    // Lists of another length have no elements to compare.
    template <class List, class Action>
    void each(const std::string& what, const List& a, const List& b, Action&& action)
    {
        same("number of " + what, double(a.size()), double(b.size()));
        for (size_t i = 0; a.size() == b.size() && i < a.size(); ++i)
            action(what + " " + std::to_string(i), a[i], b[i]);
    }
    std::vector<std::string> found;
};

bool is_mesh(const Shape& shape) { return shape.mesh >= 0; }

class Models : Comparison {
  public:
    Models(const RobotModel& a, const RobotModel& b) : a_(a), b_(b) {}
    std::vector<std::string> compare()
    {
        each("links", a_.links, b_.links,
             [&](const std::string& what, const Link& a, const Link& b) { link(what, a, b); });
        each("joints", a_.joints, b_.joints,
             [&](const std::string& what, const Joint& a, const Joint& b) { joint(what, a, b); });
        each("frames", named(a_.frames), named(b_.frames),
             [&](const std::string& what, const Frame& a, const Frame& b) {
                 same(what, a.name, b.name), same(what, a.link, b.link), same(what, a.pose, b.pose);
             });
        zones();
        relations();
        actuators();
        same("gravity", a_.gravity, b_.gravity);
        same("density", a_.medium.density, b_.medium.density);
        same("viscosity", a_.medium.viscosity, b_.medium.viscosity);
        same("wind", a_.medium.wind, b_.medium.wind);
        return found;
    }

  private:
    static std::vector<Frame> named(std::vector<Frame> frames)
    {
        std::erase_if(frames, [](const Frame& frame) { return frame.name.empty(); });
        std::stable_sort(frames.begin(), frames.end(),
                         [](const Frame& x, const Frame& y) { return x.name < y.name; });
        return frames;
    }

    // URDF has no words for them.
    void zones()
    {
        if (a_.format != b_.format) return;
        each("zones", named(a_.frames), named(b_.frames),
             [&](const std::string& what, const Frame& a, const Frame& b) {
                 same(what + " zone", int(a.zone), int(b.zone)), same(what + " zone's size", a.size, b.size);
             });
        same("magnetic", a_.magnetic, b_.magnetic);
    }

    void link(const std::string& what, const Link& a, const Link& b)
    {
        same(what + " parent", a.parent, b.parent), same(what + " mass", a.mass, b.mass);
        same(what + " pose", a.pose, b.pose);
        if (!a.name.empty()) same(what, a.name, b.name);
        if (a.mass > 0) same(what + " centre", a.centre, b.centre);
        for (size_t i = 0; i < 3 && a.mass > 0; ++i)
            for (size_t k = 0; k < 3; ++k) {
                const double size = std::max(1e-12, a.inertia[0][0] + a.inertia[1][1] + a.inertia[2][2]);
                same(what + " inertia", a.inertia[i][k] / size, b.inertia[i][k] / size);
            }
        each(what + " boxes", a.boxes, b.boxes,
             [&](const std::string& its, const FluidBox& x, const FluidBox& y) {
                 same(its, x.pose, y.pose), same(its + " half", x.half, y.half);
             });
        each(what + " shapes", a.shapes, b.shapes,
             [&](const std::string& its, const Shape& x, const Shape& y) {
                 shape(its, x, y);
                 same(its + " friction", x.friction, y.friction),
                     same(its + " torsional friction", x.torsional_friction, y.torsional_friction),
                     same(its + " rolling friction", x.rolling_friction, y.rolling_friction),
                     same(its + " dimensions", x.dimensions, y.dimensions);
                 softness(its, x.softness, y.softness);
                 same(its + " category", x.category, y.category),
                     same(its + " collide", x.collide, y.collide);
             });
        each(what + " visuals", a.visuals, b.visuals,
             [&](const std::string& its, const Shape& x, const Shape& y) {
                 shape(its, x, y);
                 for (int i = 0; i < 4; ++i) same(its + " color", double(x.color[i]), double(y.color[i]));
             });
    }

    void shape(const std::string& what, const Shape& a, const Shape& b)
    {
        same(what + " kind", name_of(a.kind), name_of(b.kind));
        same(what + " pose", a.pose, b.pose);
        if (a.kind != ShapeKind::kPlane && a.field < 0 && !is_mesh(a)) same(what + " size", a.size, b.size);
        if (a.field >= 0 && b.field >= 0) field(what, a_.fields[size_t(a.field)], b_.fields[size_t(b.field)]);
        if (!is_mesh(a) || !is_mesh(b)) return;
        const Mesh &one = a_.meshes[size_t(a.mesh)], &two = b_.meshes[size_t(b.mesh)];
        same(what + " mesh", one.path, two.path), same(what + " scale", one.scale, two.scale);
    }

    void field(const std::string& what, const HeightField& a, const HeightField& b)
    {
        same(what + " file", a.path, b.path);
        same(what + " sides", Vec{a.half_x, a.half_y, a.top}, Vec{b.half_x, b.half_y, b.top});
        same(what + " base", a.base, b.base);
        same(what + " rows", a.rows, b.rows), same(what + " columns", a.columns, b.columns);
        each(what + " samples", a.samples, b.samples,
             [&](const std::string& its, double x, double y) { same(its, x, y); });
    }

    void softness(const std::string& what, const Softness& a, const Softness& b)
    {
        same(what + " softness", a.stated, b.stated);
        same(what + " time", a.time, b.time), same(what + " ratio", a.ratio, b.ratio);
        same(what + " impedance", a.low, b.low), same(what + " impedance", a.high, b.high);
        same(what + " width", a.width, b.width), same(what + " middle", a.middle, b.middle);
        same(what + " power", a.power, b.power);
    }

    void joint(const std::string& what, const Joint& a, const Joint& b)
    {
        softness(what, a.stop_softness, b.stop_softness);
        if (!a.name.empty()) same(what, a.name, b.name);
        same(what + " kind", name_of(a.kind), name_of(b.kind)), same(what + " link", a.link, b.link);
        same(what + " stiffness", a.stiffness, b.stiffness);
        same(what + " damping", a.damping, b.damping), same(what + " armature", a.armature, b.armature);
        same(what + " friction", a.friction, b.friction);
        if (a.kind == JointKind::kFree) return;
        same(what + " axis", a.axis, b.axis), same(what + " anchor", a.anchor, b.anchor);
        same(what + " reference", a.reference, b.reference), same(what + " limited", a.limited, b.limited);
        same(what + " low", a.low, b.low), same(what + " high", a.high, b.high);
        same(what + " max force", a.max_force, b.max_force),
            same(what + " max velocity", a.max_velocity, b.max_velocity);
        same(what + " rest", a.spring_reference, b.spring_reference);
    }

    // URDF has no order of these.
    static std::vector<std::array<int, 2>> sorted(std::vector<std::array<int, 2>> pairs)
    {
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }
    static std::vector<Coupling> by_follower(std::vector<Coupling> couplings)
    {
        std::stable_sort(couplings.begin(), couplings.end(), [](const Coupling& x, const Coupling& y) {
            return x.terms[0].joint < y.terms[0].joint;
        });
        return couplings;
    }

    void terms(const std::string& what, const std::vector<Coupling::Term>& a,
               const std::vector<Coupling::Term>& b)
    {
        each(what + " terms", a, b,
             [&](const std::string& its, const Coupling::Term& x, const Coupling::Term& y) {
                 same(its, x.joint, y.joint), same(its + " factor", x.factor, y.factor);
             });
    }

    void part(const std::string& what, const PathPart& a, const PathPart& b)
    {
        same(what + " kind", int(a.kind), int(b.kind)), same(what + " link", a.link, b.link);
        same(what + " pose", a.pose, b.pose), same(what + " radius", a.radius, b.radius);
        same(what + " side's link", a.side_link, b.side_link), same(what + " side", a.side, b.side);
        same(what + " divisor", a.divisor, b.divisor);
    }

    void relations()
    {
        each("couplings", by_follower(a_.couplings), by_follower(b_.couplings),
             [&](const std::string& what, const Coupling& a, const Coupling& b) {
                 terms(what, a.terms, b.terms), same(what + " offset", a.offset, b.offset);
                 each(what + " polynomial", a.polynomial, b.polynomial,
                      [&](const std::string& its, double x, double y) { same(its, x, y); });
             });
        each("ties", a_.ties, b_.ties, [&](const std::string& what, const Tie& a, const Tie& b) {
            same(what, a.name, b.name), same(what + " first", a.tendon1, b.tendon1),
                same(what + " second", a.tendon2, b.tendon2);
            for (size_t i = 0; i < a.curve.size(); ++i) same(what + " curve", a.curve[i], b.curve[i]);
            same(what + " rest", a.rest1, b.rest1), same(what + " rest", a.rest2, b.rest2);
        });
        each("closures", a_.closures, b_.closures,
             [&](const std::string& what, const Closure& a, const Closure& b) {
                 same(what + " weld", a.weld, b.weld), same(what + " link", a.link1, b.link1),
                     same(what + " link", a.link2, b.link2);
                 same(what + " pose", a.pose1, b.pose1), same(what + " pose", a.pose2, b.pose2);
             });
        each("tendons", a_.tendons, b_.tendons,
             [&](const std::string& what, const Tendon& a, const Tendon& b) {
                 terms(what, a.terms, b.terms), same(what + " low", a.low, b.low),
                     same(what + " high", a.high, b.high);
                 same(what + " stiffness", a.stiffness, b.stiffness),
                     same(what + " damping", a.damping, b.damping);
                 same(what + " friction", a.friction, b.friction),
                     same(what + " armature", a.armature, b.armature);
                 same(what + " has a rest", a.has_rest, b.has_rest), same(what + " rest", a.rest, b.rest);
                 same(what + " rest", a.rest_high, b.rest_high);
                 each(what + " path", a.path, b.path,
                      [&](const std::string& its, const PathPart& x, const PathPart& y) { part(its, x, y); });
             });
        each("sensors", a_.sensors, b_.sensors,
             [&](const std::string& what, const Sensor& a, const Sensor& b) {
                 same(what, a.name, b.name), same(what + " kind", a.kind, b.kind);
                 same(what + " object", a.object, b.object),
                     same(what + " reference", a.reference, b.reference);
                 same(what + " cutoff", a.cutoff, b.cutoff);
                 same(what + " is on the child", a.is_on_child, b.is_on_child);
             });
        each("excluded", sorted(a_.excluded), sorted(b_.excluded),
             [&](const std::string& what, const auto& a, const auto& b) {
                 same(what, a[0], b[0]), same(what, a[1], b[1]);
             });
        each("pairs", a_.pairs, b_.pairs,
             [&](const std::string& what, const ShapePair& a, const ShapePair& b) {
                 same(what, a.name, b.name), same(what, a.shape1, b.shape1), same(what, a.shape2, b.shape2);
                 same(what + " friction", a.friction, b.friction);
                 same(what + " torsional friction", a.torsional_friction, b.torsional_friction);
                 same(what + " rolling friction", a.rolling_friction, b.rolling_friction);
                 same(what + " dimensions", a.dimensions, b.dimensions),
                     softness(what, a.softness, b.softness);
             });
        each("starts", a_.starts, b_.starts, [&](const std::string& what, const Start& a, const Start& b) {
            same(what, a.name, b.name);
            each(what, a.positions, b.positions,
                 [&](const std::string& its, double x, double y) { same(its, x, y); });
            each(what, a.controls, b.controls,
                 [&](const std::string& its, double x, double y) { same(its, x, y); });
        });
    }

    void actuators()
    {
        each("actuators", a_.actuators, b_.actuators,
             [&](const std::string& what, const Actuator& a, const Actuator& b) {
                 if (!a.name.empty()) same(what, a.name, b.name);
                 same(what + " joint", a.joint, b.joint), same(what + " tendon", a.tendon, b.tendon);
                 const SiteWrench &x = a.wrench, &y = b.wrench;
                 same(what + " rod", x.rod, y.rod);
                 same(what + " site's link", x.link, y.link), same(what + " site", x.pose, y.pose);
                 same(what + " reference's link", x.reference_link, y.reference_link);
                 same(what + " reference", x.reference, y.reference);
                 same(what + " force", x.force, y.force), same(what + " torque", x.torque, y.torque);
                 same(what + " adhesive link", a.adhesive_link, b.adhesive_link);
                 same(what + " gear", a.gear, b.gear), same(what + " gain", a.gain, b.gain),
                     same(what + " bias", a.bias, b.bias);
                 same(what + " bias of position", a.bias_position, b.bias_position);
                 same(what + " bias of velocity", a.bias_velocity, b.bias_velocity);
                 same(what + " low", a.low, b.low), same(what + " high", a.high, b.high);
                 same(what + " force", a.force_low, b.force_low),
                     same(what + " force", a.force_high, b.force_high);
                 same(what + " filter", int(a.filter.kind), int(b.filter.kind));
                 same(what + " filter's time", a.filter.time, b.filter.time);
                 same(what + " filter's range", a.filter.low, b.filter.low),
                     same(what + " filter's range", a.filter.high, b.filter.high);
                 each(what + " activation", a.activation, b.activation,
                      [&](const std::string& its, const auto& one, const auto& other) {
                          same(its, one[0], other[0]), same(its, one[1], other[1]);
                      });
             });
    }

    const RobotModel &a_, &b_;
};

}  // namespace

std::vector<std::string> differences(const RobotModel& a, const RobotModel& b)
{
    return Models(a, b).compare();
}

}  // namespace epode::robots
