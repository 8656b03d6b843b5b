// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See animation.h. States are walked once, in order; for each moment a geom's place follows from the moves so
// far.
#include "record/output/animation.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace epode::record {

namespace {

// Every carrier has a pose at every moment, there or not: more of them than the file has states, by so much,
// would take memory out of all proportion to the file.
constexpr double kFewPoses = 1e6, kMostWaste = 32;

Quat product(const Quat& a, const Quat& b)
{
    return {a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
            a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
            a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
            a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0]};
}

Vec3 turned(const Quat& q, const Vec3& v)
{
    // v + 2 w (u x v) + 2 u x (u x v), u the vector part of q.
    const auto cross = [](const Vec3& a, const Vec3& b) {
        return Vec3{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
    };
    const Vec3 u = {q[1], q[2], q[3]}, t = cross(u, v), tt = cross(u, t);
    Vec3 out;
    for (size_t i = 0; i < 3; ++i) out[i] = v[i] + 2 * q[0] * t[i] + 2 * tt[i];
    return out;
}

bool usable(const Pose& pose)
{
    double sum = 0;
    for (double value : pose.turn) sum += value * value;
    for (double value : pose.pos) {
        if (!(std::abs(value) < 1e30)) return false;
    }
    return sum > 1e-12 && sum < 1e12;
}

Pose normalized(Pose pose)
{
    const Quat& q = pose.turn;
    const double length = std::sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
    for (double& value : pose.turn) value /= length;
    return pose;
}

// To the end of the poses: sound, and on the same side as the one before.
void append(std::vector<Pose>& poses, const Pose& given)
{
    const Pose before = poses.empty() ? Pose{} : poses.back();
    Pose pose = usable(given) ? normalized(given) : before;
    double side = 0;
    for (size_t i = 0; i < 4; ++i) side += pose.turn[i] * before.turn[i];
    if (side < 0) {
        for (double& value : pose.turn) value = -value;
    }
    poses.push_back(pose);
}

void choose_moments(const Recording& recording, double fps, Animation& out)
{
    const size_t count = recording.steps.size();
    for (size_t i = 0; i < count; ++i) {
        const double time = recording.steps[i].time;
        const bool rises = out.times.empty() || float(time) > out.times.back();
        const bool due =
            out.times.empty() || time >= recording.steps[out.steps.back()].time + (1 - 1e-6) / fps;
        if (!rises || !std::isfinite(float(time))) continue;
        if (due || i + 1 == count) {
            out.steps.push_back(i);
            out.times.push_back(float(time));
        }
    }
}

// Where everything is in one state.
class Stage {
  public:
    explicit Stage(const Recording& recording) : recording_(recording), places_(recording.geoms) {}

    void go_to(size_t step)
    {
        for (; move_ < recording_.moves.size() && recording_.moves[move_].step <= step; ++move_) {
            const Move& move = recording_.moves[move_];
            places_[move.geom].body = move.body;
            places_[move.geom].pose = move.pose;
        }
        bodies_.assign(recording_.bodies.size(), nullptr);
        const auto numbers = recording_.living(step);
        for (size_t i = 0; i < numbers.size(); ++i) bodies_[numbers[i]] = &recording_.steps[step].bodies[i];
    }
    const BodyState* body(std::int32_t number) const { return bodies_[size_t(number)]; }
    // Of a geom in the world; null where its body is gone.
    bool pose(std::uint32_t geom, Pose& out) const
    {
        const Geom& place = places_[geom];
        if (place.body != kNobody && !body(place.body)) return false;
        out = place.body == kNobody ? place.pose : compose(body(place.body)->pose, place.pose);
        return true;
    }

  private:
    const Recording& recording_;
    std::vector<Geom> places_;
    std::vector<const BodyState*> bodies_;
    size_t move_ = 0;
};

// A sphere, box or cylinder is a unit one scaled, a capsule one of unit radius.
Shape unit_of(const Shape& shape, Vec3& scale)
{
    const auto& size = shape.size;
    Shape unit{shape.kind, {1, 0, 0, 0}, {}, {}};
    switch (shape.kind) {
        case ShapeKind::kSphere:
            scale = {size[0], size[0], size[0]};
            return unit;
        case ShapeKind::kBox:
            scale = {size[0], size[1], size[2]};
            unit.size = {1, 1, 1, 0};
            return unit;
        case ShapeKind::kCylinder:
            scale = {size[0], size[0], size[1]};
            unit.size = {1, 1, 0, 0};
            return unit;
        case ShapeKind::kCapsule:
            if (!(size[0] > 0)) return shape;
            scale = {size[0], size[0], size[0]};
            unit.size = {1, size[1] / size[0], 0, 0};
            return unit;
        default:
            return shape;
    }
}

// The solid of each shape, and its scale.
struct Look {
    std::uint32_t solid;
    Vec3 scale;
};

std::vector<Look> find_solids(const Recording& recording, std::vector<Shape>& solids)
{
    std::map<std::pair<ShapeKind, std::array<double, 4>>, std::uint32_t> known;
    std::vector<Look> looks;
    for (const Shape& shape : recording.shapes) {
        Look look{std::uint32_t(solids.size()), {1, 1, 1}};
        const Shape unit = unit_of(shape, look.scale);
        const bool simple = unit.triangles.empty();
        const auto found = known.find({unit.kind, unit.size});
        if (simple && found != known.end()) {
            look.solid = found->second;
        } else {
            if (simple) known[{unit.kind, unit.size}] = look.solid;
            solids.push_back(unit);
        }
        looks.push_back(look);
    }
    return looks;
}

// Who carries each geom: its body, or itself if it moved or does not live all the time.
void cast_parts(const Recording& recording, Animation& out)
{
    for (size_t i = 0; i < recording.bodies.size(); ++i) {
        out.carriers.emplace_back();
        out.carriers.back().body = std::int32_t(i);
    }
    const std::vector<Look> looks = find_solids(recording, out.solids);
    std::vector<bool> moved(recording.geoms.size(), false);
    for (const Move& move : recording.moves) moved[move.geom] = true;
    for (std::uint32_t i = 0; i < recording.geoms.size(); ++i) {
        const Geom& geom = recording.geoms[i];
        const Look& look = looks[geom.shape];
        Part part{i, look.solid, look.scale, geom.body, geom.pose, geom.body};
        const Life& life = recording.geom_lives[i];
        const Life whole = geom.body == kNobody ? Life{} : recording.body_lives[size_t(geom.body)];
        if (moved[i] || life.born != whole.born || life.died < whole.died) {
            part.carrier = std::int32_t(out.carriers.size());
            part.pose = {};
            out.carriers.emplace_back();
        }
        part.pose = usable(part.pose) ? normalized(part.pose) : Pose{};
        out.parts.push_back(part);
    }
}

void add_moment(Carrier& carrier, const Pose* pose)
{
    // Before a life nothing is known; the first pose of it is filled in by finish().
    carrier.alive.push_back(pose != nullptr);
    if (pose) {
        append(carrier.poses, *pose);
    } else {
        carrier.poses.push_back(carrier.poses.empty() ? Pose{} : carrier.poses.back());
    }
}

void finish(Carrier& carrier)
{
    const auto first = std::find(carrier.alive.begin(), carrier.alive.end(), 1);
    const auto at = size_t(first - carrier.alive.begin());
    if (at < carrier.poses.size()) std::fill_n(carrier.poses.begin(), at, carrier.poses[at]);
    for (size_t i = 0; i < carrier.poses.size(); ++i) {
        carrier.always_alive = carrier.always_alive && carrier.alive[i];
        carrier.moves = carrier.moves || carrier.poses[i].pos != carrier.poses[0].pos ||
                        carrier.poses[i].turn != carrier.poses[0].turn;
    }
}

}  // namespace

Pose compose(const Pose& a, const Pose& b)
{
    Pose out;
    out.turn = product(a.turn, b.turn);
    out.pos = turned(a.turn, b.pos);
    for (size_t i = 0; i < 3; ++i) out.pos[i] += a.pos[i];
    return out;
}

bool can_animate(const Recording& recording, double fps, std::string& problem)
{
    Animation empty;
    choose_moments(recording, fps, empty);
    cast_parts(recording, empty);
    double states = 0;
    for (const Step& step : recording.steps) states += double(step.bodies.size());
    const double poses = double(empty.carriers.size()) * double(empty.times.size());
    if (poses <= kFewPoses + kMostWaste * states) return true;
    problem = std::to_string(empty.carriers.size()) + " bodies that mostly are not there, at " +
              std::to_string(empty.times.size()) + " moments, are too many; take fewer moments (--fps)";
    return false;
}

Animation make_animation(const Recording& recording, double fps)
{
    Animation out;
    choose_moments(recording, fps, out);
    cast_parts(recording, out);
    Stage stage(recording);
    for (size_t step : out.steps) {
        stage.go_to(step);
        for (Carrier& carrier : out.carriers) {
            if (carrier.body == kNobody) continue;
            const BodyState* state = stage.body(carrier.body);
            add_moment(carrier, state ? &state->pose : nullptr);
            for (double value : carrier.poses.back().pos) out.reach = std::max(out.reach, std::abs(value));
        }
        for (const Part& part : out.parts) {
            if (part.carrier == kNoCarrier || out.carriers[size_t(part.carrier)].body != kNobody) continue;
            Pose pose;
            const bool there = recording.geom_lives[part.geom].at(step) && stage.pose(part.geom, pose);
            add_moment(out.carriers[size_t(part.carrier)], there ? &pose : nullptr);
        }
    }
    for (Carrier& carrier : out.carriers) finish(carrier);
    return out;
}

}  // namespace epode::record
