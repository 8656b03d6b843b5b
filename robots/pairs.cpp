// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See pairs.h.
#include "robots/pairs.h"

#include <algorithm>

namespace epode::robots {

namespace {

constexpr int kFirstBit = 32, kBits = int(sizeof(unsigned long)) * 8, kMostKinds = 255;

bool touch_by_bits(const Shape& a, const Shape& b)
{
    return (a.category & b.collide) || (b.category & a.collide);
}

// The link that one is part of.
int carrier_of(const RobotModel& model, int link)
{
    while (link > 0 && model.links[size_t(link)].joints.empty()) link = model.links[size_t(link)].parent;
    return link;
}

}  // namespace

const Shape* shape_named(const RobotModel& model, const std::string& name, int& link)
{
    for (link = 0; link < int(model.links.size()); ++link)
        for (const Shape& shape : model.links[size_t(link)].shapes)
            if (!name.empty() && shape.name == name) return &shape;
    return nullptr;
}

const ShapePair* pair_of(const RobotModel& model, const Shape& one, const Shape& two)
{
    for (const ShapePair& pair : model.pairs)
        if ((pair.shape1 == one.name && pair.shape2 == two.name) ||
            (pair.shape1 == two.name && pair.shape2 == one.name))
            return &pair;
    return nullptr;
}

bool are_kept_apart(const RobotModel& model, int one, int two)
{
    const auto [parent, child] = std::minmax({carrier_of(model, one), carrier_of(model, two)});
    if (parent == child) return true;
    if (parent > 0 && carrier_of(model, model.links[size_t(child)].parent) == parent) return true;
    return std::any_of(model.excluded.begin(), model.excluded.end(), [&](const auto& pair) {
        return (pair[0] == one && pair[1] == two) || (pair[0] == two && pair[1] == one);
    });
}

PairMaterials::PairMaterials(const RobotModel& model)
{
    std::map<std::string, int> counts;
    for (const ShapePair& pair : model.pairs) ++counts[pair.shape1], ++counts[pair.shape2];
    int kinds = 0, bits = kFirstBit;
    for (size_t i = 0; i < model.pairs.size(); ++i) {
        const ShapePair& pair = model.pairs[i];
        int link = 0;
        const Shape* holder = shape_named(model, pair.shape1, link);
        const Shape* partner = shape_named(model, pair.shape2, link);
        if (!holder || !partner) continue;
        if (counts[pair.shape2] > counts[pair.shape1]) std::swap(holder, partner);
        PairRules &its = rules_[holder], &other = rules_[partner];
        const bool has_bit = touch_by_bits(*holder, *partner) || its.category != 0 || bits < kBits;
        if (!has_bit || (other.kind == 0 && kinds == kMostKinds)) {
            ++left_out_;
            continue;
        }
        if (other.kind == 0) other.kind = ++kinds;
        its.materials.push_back({other.kind, int(i)});
        if (touch_by_bits(*holder, *partner)) continue;
        if (its.category == 0) its.category = 1ul << bits++;
        other.collide |= its.category;
    }
}

const PairRules* PairMaterials::of(const Shape& shape) const
{
    const auto found = rules_.find(&shape);
    return found == rules_.end() ? nullptr : &found->second;
}

}  // namespace epode::robots
