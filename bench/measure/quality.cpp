// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See quality.h. Pairs are found by sweeping bounding boxes along x: slow and simple, outside all timing. A
// state that is not finite is counted and judged no further.
#include "bench/measure/quality.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "bench/measure/overlap.h"

namespace epode::bench {

namespace {

bool finite(Vec v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

bool usable(const BodyState& s)
{
    const Turn q = s.turn;
    return finite(s.pos) && finite(s.linear) && finite(s.angular) && std::isfinite(q.w + q.x + q.y + q.z);
}

struct Item {
    int body;
    Placed placed;
    Bounds box;
};

std::vector<Item> place_parts(const SceneData& scene, const State& state)
{
    std::vector<Item> items;
    for (int i = 0; i < int(scene.bodies.size()); ++i) {
        if (!scene.bodies[size_t(i)].collides) continue;
        const BodyState& at = state[size_t(i)];
        for (const PartData& part : scene.bodies[size_t(i)].parts) {
            const ShapeData& shape = scene.shapes[size_t(part.shape)];
            if (shape.kind == ShapeKind::kMesh) continue;
            const Placed placed{&shape, at.pos + rotate(at.turn, part.offset), at.turn * part.turn};
            items.push_back({i, placed, bounds(placed)});
        }
    }
    std::sort(items.begin(), items.end(),
              [](const Item& a, const Item& b) { return a.box.low.x < b.box.low.x; });
    return items;
}

bool meet(const Bounds& a, const Bounds& b)
{
    return a.low.y <= b.high.y && b.low.y <= a.high.y && a.low.z <= b.high.z && b.low.z <= a.high.z;
}

class Penetration {
  public:
    Penetration(const SceneData& scene, Quality& quality) : scene_(scene), quality_(quality)
    {
        for (const JointData& joint : scene.joints) joined_.insert(std::minmax(joint.body1, joint.body2));
    }

    void add_pairs(const std::vector<Item>& items)
    {
        for (size_t i = 0; i < items.size(); ++i) {
            for (size_t j = i + 1; j < items.size() && items[j].box.low.x <= items[i].box.high.x; ++j) {
                if (meet(items[i].box, items[j].box) && may_touch(items[i].body, items[j].body))
                    add(overlap(items[i].placed, items[j].placed));
            }
        }
    }

    void add_terrain(const std::vector<Item>& items)
    {
        for (const Item& item : items) add(overlap(item.placed, *scene_.terrain));
    }

    void finish()
    {
        if (quality_.overlaps > 0) quality_.penetration_mean = sum_ / quality_.overlaps;
    }

  private:
    bool may_touch(int i, int j) const
    {
        const BodyData &a = scene_.bodies[size_t(i)], &b = scene_.bodies[size_t(j)];
        if (a.motion != Motion::kDynamic && b.motion != Motion::kDynamic) return false;
        if (i == j || (a.group != 0 && a.group == b.group)) return false;
        return !joined_.contains(std::minmax(i, j));
    }

    void add(double depth)
    {
        if (depth <= 0) return;
        ++quality_.overlaps;
        sum_ += depth;
        quality_.penetration_max = std::max(quality_.penetration_max, depth);
    }

    const SceneData& scene_;
    Quality& quality_;
    std::set<std::pair<int, int>> joined_;
    double sum_ = 0;
};

Vec moved(const BodyData& body, const BodyState& now, Vec world_point)
{
    return now.pos + rotate(now.turn * inverse(body.turn), world_point - body.pos);
}

double joint_error(const SceneData& scene, const State& state, const JointData& joint)
{
    const BodyData &a = scene.bodies[size_t(joint.body1)], &b = scene.bodies[size_t(joint.body2)];
    const BodyState &now_a = state[size_t(joint.body1)], &now_b = state[size_t(joint.body2)];
    Vec gap = moved(a, now_a, joint.anchor) - moved(b, now_b, joint.anchor);
    if (joint.kind == JointKind::kHinge2) {
        const Vec axis = rotate(now_a.turn * inverse(a.turn), joint.axis1);
        gap = gap - dot(gap, axis) * axis;
    }
    return length(gap);
}

void judge_joints(const SceneData& scene, const State& state, Quality& quality)
{
    for (const JointData& joint : scene.joints) {
        const double error = joint_error(scene, state, joint) / scene.link;
        quality.joint_error_max = std::max(quality.joint_error_max, error);
        quality.joint_error_mean += error / double(scene.joints.size());
    }
}

void judge_motion(const SceneData& scene, const State& state, Quality& quality)
{
    double mass = 0, twice_kinetic = 0, raised = 0;
    int standing = 0;
    for (size_t i = 0; i < scene.bodies.size(); ++i) {
        const BodyData& body = scene.bodies[i];
        if (body.motion != Motion::kDynamic) continue;
        const BodyState& now = state[i];
        const Vec w = rotate(inverse(now.turn), now.angular), w0 = rotate(inverse(body.turn), body.angular);
        const auto spin = [&](Vec v) {
            return dot({body.inertia.x * v.x, body.inertia.y * v.y, body.inertia.z * v.z}, v);
        };
        mass += body.mass;
        twice_kinetic += body.mass * dot(now.linear, now.linear) + spin(w);
        raised += body.mass * (now.pos.z - body.pos.z) -
                  (body.mass * dot(body.linear, body.linear) + spin(w0)) / (2 * scene.gravity);
        if (body.rest) {
            const double drift = length(now.pos - *body.rest);
            ++standing;
            quality.drift_mean += drift;
            quality.drift_max = std::max(quality.drift_max, drift);
        }
        const bool under = scene.terrain && now.pos.z < scene.terrain->at(now.pos.x, now.pos.y);
        quality.lost += under || now.pos.z < scene.lost_below - (scene.terrain ? 10 : 0);
    }
    if (standing > 0) quality.drift_mean /= standing;
    if (mass > 0) {
        quality.speed = std::sqrt(twice_kinetic / mass);
        quality.energy = raised / mass + twice_kinetic / (2 * mass * scene.gravity);
    }
}

}  // namespace

Quality judge(const SceneData& scene, const State& state)
{
    Quality quality;
    quality.not_finite =
        int(std::count_if(state.begin(), state.end(), [](const BodyState& s) { return !usable(s); }));
    if (quality.not_finite > 0) return quality;
    const std::vector<Item> items = place_parts(scene, state);
    Penetration penetration(scene, quality);
    penetration.add_pairs(items);
    if (scene.terrain) penetration.add_terrain(items);
    penetration.finish();
    judge_joints(scene, state, quality);
    judge_motion(scene, state, quality);
    return quality;
}

}  // namespace epode::bench
