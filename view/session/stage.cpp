// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Moves are few (a program puts a static geom elsewhere), so the geoms of a moment are found by walking all
// moves up to it.
#include "view/session/stage.h"

namespace epode::view {

namespace {

size_t bytes_of(const record::Step& step)
{
    return sizeof(State) + step.bodies.size() * (sizeof(record::BodyState) + 1) +
           step.contacts.size() * sizeof(record::Contact) + step.limits.size() * sizeof(record::Limit);
}

}  // namespace

void Stage::body(const record::Body& body)
{
    bodies_.push_back(body);
    body_lives_.push_back({next(), UINT32_MAX});
}

void Stage::geom(const record::Geom& geom)
{
    geoms_.push_back(geom);
    geom_lives_.push_back({next(), UINT32_MAX});
}

void Stage::joint(const record::Joint& joint)
{
    joints_.push_back(joint);
    joint_lives_.push_back({next(), UINT32_MAX});
}

void Stage::gone(record::ObjectKind kind, std::uint32_t number)
{
    auto& lives = kind == record::ObjectKind::kBody   ? body_lives_
                  : kind == record::ObjectKind::kGeom ? geom_lives_
                                                      : joint_lives_;
    if (number < lives.size()) lives[number].died = next();
}

void Stage::moved(std::uint32_t geom, std::int32_t body, const record::Pose& pose)
{
    if (geom < geoms_.size()) moves_.push_back({next(), geom, body, pose});
}

void Stage::step(const record::Step& step)
{
    states_.push_back({step, {}, 0});
    bytes_ += bytes_of(step);
    while (most_bytes_ > 0 && bytes_ > most_bytes_ && states_.size() > 2) {
        bytes_ -= bytes_of(states_.front().step);
        states_.pop_front();
        ++first_;
    }
}

void Stage::cut_after(size_t number)
{
    while (!states_.empty() && last() > number) {
        bytes_ -= bytes_of(states_.back().step);
        states_.pop_back();
    }
    while (!moves_.empty() && moves_.back().step > number) moves_.pop_back();
}

Moment Stage::moment(size_t number) const
{
    Moment now;
    now.step = &at(number).step;
    now.bodies.resize(bodies_.size(), nullptr);
    now.asleep.resize(bodies_.size(), false);
    size_t place_in_state = 0;
    for (size_t i = 0; i < bodies_.size(); ++i) {
        if (!body_lives_[i].at(number) || place_in_state >= now.step->bodies.size()) continue;
        now.bodies[i] = &now.step->bodies[place_in_state];
        now.asleep[i] = place_in_state < now.step->asleep.size() && now.step->asleep[place_in_state] != 0;
        ++place_in_state;
    }
    std::vector<record::Geom> placed = geoms_;
    for (const record::Move& move : moves_) {
        if (move.step > number) continue;
        placed[move.geom].body = move.body;
        placed[move.geom].pose = move.pose;
    }
    for (std::uint32_t i = 0; i < placed.size(); ++i) {
        if (!geom_lives_[i].at(number)) continue;
        const record::Geom& geom = placed[i];
        if (geom.body == record::kNobody) {
            now.geoms.push_back({i, geom.body, geom.pose});
            continue;
        }
        const record::BodyState* body =
            size_t(geom.body) < now.bodies.size() ? now.bodies[size_t(geom.body)] : nullptr;
        if (!body) continue;
        const Vec pos = view::place(body->pose, vec(geom.pose.pos));
        const Turn q = turn_of(body->pose.turn) * turn_of(geom.pose.turn);
        now.geoms.push_back({i, geom.body, {{pos.x, pos.y, pos.z}, {q.w, q.x, q.y, q.z}}});
    }
    for (std::uint32_t i = 0; i < joints_.size(); ++i) {
        if (joint_lives_[i].at(number)) now.joints.push_back(i);
    }
    return now;
}

}  // namespace epode::view
