// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A recording in memory: what it receives, with the steps between which each object lived.
#include "record/file/recording.h"

namespace epode::record {

namespace {

Life from_now(const std::vector<Step>& steps) { return {std::uint32_t(steps.size()), UINT32_MAX}; }

}  // namespace

std::vector<std::uint32_t> Recording::living(size_t step) const
{
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t i = 0; i < bodies.size(); ++i) {
        if (body_lives[i].at(step)) numbers.push_back(i);
    }
    return numbers;
}

std::string Recording::about_value(const std::string& key) const
{
    const auto found = about.find(key);
    return found == about.end() ? std::string() : found->second;
}

void Recording::body(const Body& body)
{
    bodies.push_back(body);
    body_lives.push_back(from_now(steps));
}

void Recording::geom(const Geom& geom)
{
    geoms.push_back(geom);
    geom_lives.push_back(from_now(steps));
}

void Recording::joint(const Joint& joint)
{
    joints.push_back(joint);
    joint_lives.push_back(from_now(steps));
}

void Recording::gone(ObjectKind kind, std::uint32_t number)
{
    auto& lives = kind == ObjectKind::kBody   ? body_lives
                  : kind == ObjectKind::kGeom ? geom_lives
                                              : joint_lives;
    if (number < lives.size()) lives[number].died = std::uint32_t(steps.size());
}

void Recording::moved(std::uint32_t geom, std::int32_t body, const Pose& pose)
{
    moves.push_back({std::uint32_t(steps.size()), geom, body, pose});
}

const char* name_of(ShapeKind kind)
{
    static const char* const kNames[] = {"unknown", "sphere", "box",    "capsule", "cylinder",
                                         "plane",   "ray",    "convex", "mesh",    "height field"};
    return kNames[std::uint32_t(kind)];
}

}  // namespace epode::record
