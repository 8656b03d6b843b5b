// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Which shapes may touch: what a world made of the model would let touch (robots/build.cpp).
#include "batch/model/pairs.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "batch/model/loops.h"
#include "robots/pairs.h"
#include "robots/shape_geom.h"

namespace epode::batch {

using namespace robots;

namespace {

struct Kind {
    PointKind kind;
    bool is_swapped;
};

// The pairs that have closed forms.
std::optional<Kind> closed_form(ShapeKind a, ShapeKind b)
{
    static constexpr struct {
        ShapeKind a, b;
        PointKind kind;
    } kKinds[] = {{ShapeKind::kSphere, ShapeKind::kPlane, PointKind::kSpherePlane},
                  {ShapeKind::kCapsule, ShapeKind::kPlane, PointKind::kCapsulePlane},
                  {ShapeKind::kBox, ShapeKind::kPlane, PointKind::kBoxPlane},
                  {ShapeKind::kCylinder, ShapeKind::kPlane, PointKind::kCylinderPlane},
                  {ShapeKind::kEllipsoid, ShapeKind::kPlane, PointKind::kEllipsoidPlane},
                  {ShapeKind::kSphere, ShapeKind::kSphere, PointKind::kSphereSphere},
                  {ShapeKind::kSphere, ShapeKind::kCapsule, PointKind::kSphereCapsule},
                  {ShapeKind::kCapsule, ShapeKind::kCapsule, PointKind::kCapsuleCapsule},
                  {ShapeKind::kSphere, ShapeKind::kBox, PointKind::kSphereBox}};
    for (const auto& its : kKinds) {
        if (its.a == a && its.b == b) return Kind{its.kind, false};
        if (its.a == b && its.b == a) return Kind{its.kind, true};
    }
    return {};
}

struct Touching {  // a shape of a model, or one hull of it
    int number = 0;
    const Shape* shape = nullptr;
    int link = 0, part = 0;
};

class Pairs {
  public:
    Pairs(BatchModel& out, const Prepared& prepared)
        : out_(out), prepared_(prepared), model_(prepared.model())
    {
        int number = 0;
        for (size_t i = 0; i < model_.links.size(); ++i)
            for (const Shape& shape : model_.links[i].shapes) {
                for (int part = 0; part < parts_of(prepared_, shape); ++part)
                    shapes_.push_back({number, &shape, int(i), part});
                ++number;
            }
        for (const auto& pair : model_.excluded) exclude(pair[0], pair[1]);
        for (const auto& pair : model_.excluded_still) still_.insert(pair);
        for (const auto& pair : prepared.overlapping()) exclude(pair[0], pair[1]);
        for (const Closure& loop : model_.closures)
            if (loop.link1 != 0 && loop.link2 != 0) exclude(loop.link1, loop.link2);
    }

    void make()
    {
        for (size_t i = 0; i < shapes_.size(); ++i)
            for (size_t k = i + 1; k < shapes_.size(); ++k) {
                if (!may_touch(shapes_[i], shapes_[k])) continue;
                const Kind kind = kind_of(shapes_[i], shapes_[k]);
                kind.is_swapped ? add(kind.kind, shapes_[k], shapes_[i])
                                : add(kind.kind, shapes_[i], shapes_[k]);
            }
    }

  private:
    static AskedShape asked(const Touching& its) { return {its.number, its.shape, its.part}; }

    Kind kind_of(const Touching& a, const Touching& b) const
    {
        if (const auto known = closed_form(a.shape->kind, b.shape->kind)) return *known;
        return {PointKind::kAsked, out_.asked.rank(asked(a)) > out_.asked.rank(asked(b))};
    }

    void exclude(int one, int two) { excluded_.insert({std::min(one, two), std::max(one, two)}); }
    bool stands_still(int link) const { return out_.links[size_t(link)].last_dof < 0; }

    // The link that one is part of, where fixed links have been kept.
    int carrier_of(int link) const
    {
        while (link > 0 && model_.links[size_t(link)].joints.empty())
            link = model_.links[size_t(link)].parent;
        return link;
    }

    bool are_connected(int one, int two) const
    {
        const auto [parent, child] = std::minmax({carrier_of(one), carrier_of(two)});
        if (parent == child) return true;
        if (carrier_of(model_.links[size_t(child)].parent) != parent) return false;
        return parent != 0 ||
               !model_
                    .touches_itself;  // what is jointed to the world may touch its shapes (robots/build.cpp)
    }

    bool may_touch(const Touching& a, const Touching& b) const
    {
        if (a.link == b.link || (stands_still(a.link) && stands_still(b.link))) return false;
        const bool wanted = (a.shape->category & b.shape->collide) ||
                            (b.shape->category & a.shape->collide) || pair_of(model_, *a.shape, *b.shape);
        if (!wanted || are_connected(a.link, b.link)) return false;
        if (still_.count({b.link, a.shape->still}) || still_.count({a.link, b.shape->still})) return false;
        return !excluded_.count({std::min(a.link, b.link), std::max(a.link, b.link)});
    }

    void add(PointKind kind, const Touching& a, const Touching& b)
    {
        BatchPair pair;
        pair.kind = kind, pair.shape_a = a.number, pair.shape_b = b.number;
        const bool is_asked = kind == PointKind::kAsked;
        if (is_asked) pair.asked = out_.asked.add(asked(a), asked(b));
        pair.slots = is_asked ? asked_points(*a.shape, *b.shape) : points_of(kind);
        pair.first_slot = out_.slots, out_.slots += pair.slots;
        pair.support = support_of(a.link, b.link);
        pair.is_upright = b.shape->kind == ShapeKind::kPlane && is_upright(b);
        const int first = a.shape->priority, second = b.shape->priority;
        const ShapePair* const own = pair_of(model_, *a.shape, *b.shape);
        const int dimensions = own              ? own->dimensions
                               : first > second ? a.shape->dimensions
                               : second > first ? b.shape->dimensions
                                                : std::max(a.shape->dimensions, b.shape->dimensions);
        pair.rolls = dimensions >= 6;
        if (dimensions >= 4) pair.first_turn = out_.turns, out_.turns += pair.slots;
        const auto combined = [&](double one, double two) {
            if (first != second) return first > second ? one : two;
            return model_.largest_friction ? std::max(one, two) : std::sqrt(one * two);
        };
        const double friction = own ? own->friction : combined(a.shape->friction, b.shape->friction);
        const double torsion = own ? own->torsional_friction
                                   : combined(a.shape->torsional_friction, b.shape->torsional_friction);
        const double rolling =
            own ? own->rolling_friction : combined(a.shape->rolling_friction, b.shape->rolling_friction);
        const Spring spring = own ? prepared_.springs().of_pair(a.link, b.link, own->softness)
                                  : in_series(prepared_.springs().of_shape(a.link, *a.shape),
                                              prepared_.springs().of_shape(b.link, *b.shape));
        pair.first = int(out_.numbers.size());
        out_.numbers.insert(out_.numbers.end(), {friction, spring.stiffness, spring.damping,
                                                 dimensions >= 4 ? torsion : 0, pair.rolls ? rolling : 0});
        out_.pairs.push_back(pair);
    }

    bool is_upright(const Touching& plane) const
    {
        const Pose& at = plane.shape->pose;
        const Link& link = model_.links[size_t(plane.link)];
        const auto is_none = [](Quat q) { return q.x == 0 && q.y == 0; };
        return plane.link == 0 ? is_none(at.q) : link.parent == 0 && is_none(at.q) && is_none(link.pose.q);
    }

    // Compliances add, and their damping times as shares of them (src/contacts/material.cpp).
    static Spring in_series(const Spring& a, const Spring& b)
    {
        const auto compliance = [](const Spring& s) { return s.stiffness > 0 ? 1 / s.stiffness : 0; };
        const auto time = [](const Spring& s) { return s.stiffness > 0 ? s.damping / s.stiffness : 0; };
        const double sum = compliance(a) + compliance(b);
        if (!(sum > 0)) return {};
        const double mean = (compliance(a) * time(a) + compliance(b) * time(b)) / sum;
        return {1 / sum, mean / sum};
    }

    std::vector<int> chain_of(int link) const
    {
        const int last = out_.links[size_t(link)].last_dof;
        if (last < 0) return {};
        const Dof& dof = out_.dofs[size_t(last)];
        return {out_.chains.begin() + dof.chain, out_.chains.begin() + dof.chain + dof.depth + 1};
    }

    int support_of(int a, int b)
    {
        const auto known = supports_.find({a, b});
        if (known != supports_.end()) return known->second;
        const std::vector<int> one = chain_of(a), two = chain_of(b);
        const auto common = std::mismatch(one.begin(), one.end(), two.begin(), two.end());
        Support its;
        its.first = int(out_.support_dofs.size());
        its.common = int(common.first - one.begin());
        its.of_a = int(one.end() - common.first), its.of_b = int(two.end() - common.second);
        its.tree_a = tree_of(a), its.tree_b = tree_of(b);
        std::vector<int> dofs = one;
        dofs.insert(dofs.end(), common.second, two.end());
        dofs = widened(out_, dofs);
        its.width = int(dofs.size()), its.places = add_places(out_, dofs);
        out_.support_dofs.insert(out_.support_dofs.end(), dofs.begin(), dofs.end());
        out_.supports.push_back(its);
        return supports_[{a, b}] = int(out_.supports.size()) - 1;
    }

    int tree_of(int link) const { return out_.links[size_t(link)].tree; }

    BatchModel& out_;
    const Prepared& prepared_;
    const RobotModel& model_;
    std::vector<Touching> shapes_;
    std::set<std::array<int, 2>> excluded_,
        still_;  // the latter: links, and the parts of the world that they do not touch
    std::map<std::array<int, 2>, int> supports_;
};

}  // namespace

void add_pairs(BatchModel& out, const Prepared& prepared) { Pairs(out, prepared).make(); }

}  // namespace epode::batch
