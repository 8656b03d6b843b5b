// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every kind of shape, a body, geom and joint that go, a geom that moves, contacts with and without forces, a
// stop, a call.
#include "sample.h"

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "record/file/hash.h"
#include "record/file/writer.h"

namespace epode::record {

namespace {

// The folder lives as long as the program.
struct Folder {
    std::filesystem::path path;
    Folder()
    {
        std::string name = (std::filesystem::temp_directory_path() / "epode_record_XXXXXX").string();
        path = mkdtemp(name.data());
    }
    ~Folder() { std::filesystem::remove_all(path); }
};

void add_state(Recording& recording, size_t bodies, bool forces)
{
    Step step;
    const double t = double(recording.steps.size());
    step.time = 0.01 * t;
    step.dt = t > 0 ? 0.01 : 0;
    step.kinetic = 3 + t;
    step.potential = -t;
    step.joint_error = 1e-6 * t;
    step.ms = 0.25;
    for (size_t i = 0; i < bodies; ++i) {
        BodyState body;
        const double angle = 0.3 * t + double(i);
        body.pose.pos = {0.1 * t, double(i), 1.0 / 3};
        body.pose.turn = {std::cos(angle / 2), 0, std::sin(angle / 2), 0};
        body.linear = {10, 0, 0};
        body.angular = {0, 30, 0};
        step.bodies.push_back(body);
        step.asleep.push_back(std::uint8_t(i == 1));
    }
    step.has_forces = forces;
    step.contacts.push_back({{0, 1}, {1, 2, 3}, {0, 0, 1}, 0.5f, {0, 0, forces ? 7.f : 0.f}});
    step.contacts.push_back({{1, kNoGeom}, {1, 2, 3}, {0, 1, 0}, 0.25f, {0, forces ? 2.f : 0.f, 0}});
    if (recording.steps.size() < 3) step.limits.push_back({{0, true, 1, -0.5, 1}, 0.1 * t});
    step.hash = hash_states(step.bodies);
    recording.step(step);
}

}  // namespace

Recording sample_recording()
{
    Recording recording;
    recording.info({{"source", "test"}, {"scene", "none"}, {"strange", "a \"quoted\"\nline"}});
    recording.shape({ShapeKind::kPlane, {0, 0, 1, 0}, {}, {}});
    recording.shape({ShapeKind::kSphere, {0.5, 0, 0, 0}, {}, {}});
    recording.shape({ShapeKind::kBox, {1, 2, 3, 0}, {}, {}});
    recording.shape({ShapeKind::kCapsule, {0.2, 1, 0, 0}, {}, {}});
    recording.shape({ShapeKind::kCylinder, {0.3, 1.5, 0, 0}, {}, {}});
    recording.shape({ShapeKind::kMesh,
                     {0, 0, 0, 0},
                     {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                     {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}});
    recording.body({2, false});
    recording.body({5, true});
    recording.geom({0, kNobody, {}});
    recording.geom({1, 0, {{0, 0, 0.25}, {1, 0, 0, 0}}});
    recording.geom({2, 1, {}});
    recording.geom({5, kNobody, {{4, 5, 6}, {0.6, 0.8, 0, 0}}});
    recording.joint({2, {0, 1}, {1, 1}, {Vec3{0, 0, 1}, Vec3{0, 0, -1}}, {1, 0}, {Vec3{0, 1, 0}, Vec3{}}});
    CallTape tape;
    tape.add("dBodyCreate", {Argument::world()});
    recording.calls(tape.take());
    add_state(recording, 2, false);
    recording.moved(3, kNobody, {{4, 5, 7}, {1, 0, 0, 0}});
    add_state(recording, 2, true);
    recording.body({1, false});
    recording.geom({3, 2, {}});
    recording.geom({4, 2, {{1, 0, 0}, {1, 0, 0, 0}}});
    add_state(recording, 3, true);
    recording.gone(ObjectKind::kJoint, 0);
    recording.gone(ObjectKind::kGeom, 1);
    recording.gone(ObjectKind::kBody, 0);
    add_state(recording, 2, false);
    return recording;
}

std::string scratch(const std::string& name)
{
    static const Folder folder;
    return (folder.path / name).string();
}

std::vector<std::uint8_t> read_all(const std::string& path)
{
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

std::vector<std::uint8_t> bytes_of(const Recording& recording)
{
    const std::string path = scratch("sample.epr");
    std::string problem;
    EXPECT_TRUE(write_file(recording, path, problem)) << problem;
    return read_all(path);
}

}  // namespace epode::record
