// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A .glb is read back by another JSON reader than the one that wrote it: its frame is as glTF says, and
// walking its nodes puts every geom where the recording has it, at the end and in between.
#include <gtest/gtest.h>
#include <ode/ode.h>

#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "record/file/bytes.h"
#include "record/output/animation.h"
#include "record/output/glb.h"
#include "record/watch/recorder.h"
#include "sample.h"

namespace epode::record {
namespace {

using nlohmann::json;

struct Glb {
    json tree;
    std::vector<std::uint8_t> data;

    std::vector<float> values(size_t accessor) const
    {
        const json& a = tree["accessors"][accessor];
        const json& view = tree["bufferViews"][a["bufferView"].get<size_t>()];
        const size_t width = a["type"] == "SCALAR" ? 1 : a["type"] == "VEC3" ? 3 : 4;
        std::vector<float> out(a["count"].get<size_t>() * width);
        std::memcpy(out.data(), data.data() + view["byteOffset"].get<size_t>(), 4 * out.size());
        return out;
    }
};

Glb read_glb(const Recording& recording, double fps)
{
    const std::string path = scratch("test.glb");
    std::string problem;
    EXPECT_TRUE(write_glb(recording, path, fps, problem)) << problem;
    const auto bytes = read_all(path);
    Glb glb;
    ByteReader in(bytes.data(), bytes.size());
    EXPECT_EQ(in.u32(), 0x46546C67u);
    EXPECT_EQ(in.u32(), 2u);
    EXPECT_EQ(in.u32(), bytes.size());
    const size_t text = in.u32();
    EXPECT_EQ(in.u32(), 0x4E4F534Au);
    glb.tree = json::parse(bytes.begin() + 20, bytes.begin() + 20 + long(text), nullptr, false);
    EXPECT_FALSE(glb.tree.is_discarded());
    EXPECT_EQ(text % 4, 0u);
    const size_t data = 20 + text;
    ByteReader chunk(bytes.data() + data, bytes.size() - data);
    EXPECT_EQ(chunk.u32() + data + 8, bytes.size());
    EXPECT_EQ(chunk.u32(), 0x004E4942u);
    glb.data.assign(bytes.begin() + long(data) + 8, bytes.end());
    return glb;
}

// The pose of a node in its parent's frame at a key of its tracks, or as it stands where it has none.
Pose node_pose(const Glb& glb, size_t node, size_t key)
{
    const json& n = glb.tree["nodes"][node];
    std::vector<float> pos = n.value("translation", std::vector<float>{0, 0, 0});
    std::vector<float> turn = n.value("rotation", std::vector<float>{0, 0, 0, 1});
    if (glb.tree.contains("animations")) {
        const json& animation = glb.tree["animations"][0];
        for (const json& channel : animation["channels"]) {
            if (channel["target"]["node"] != node) continue;
            const auto values =
                glb.values(animation["samplers"][channel["sampler"].get<size_t>()]["output"].get<size_t>());
            if (channel["target"]["path"] == "translation")
                pos.assign(&values[3 * key], &values[3 * key] + 3);
            if (channel["target"]["path"] == "rotation") turn.assign(&values[4 * key], &values[4 * key] + 4);
        }
    }
    return {{pos[0], pos[1], pos[2]}, {turn[3], turn[0], turn[1], turn[2]}};
}

size_t parent_of(const Glb& glb, size_t node)
{
    for (size_t i = 0; i < glb.tree["nodes"].size(); ++i) {
        for (const json& child : glb.tree["nodes"][i].value("children", json::array())) {
            if (child == node) return i;
        }
    }
    return SIZE_MAX;
}

Pose world_pose(const Glb& glb, size_t node, size_t key)
{
    Pose pose = node_pose(glb, node, key);
    for (size_t up = parent_of(glb, node); up != SIZE_MAX; up = parent_of(glb, up))
        pose = compose(node_pose(glb, up, key), pose);
    return pose;
}

size_t node_named(const Glb& glb, const std::string& name)
{
    for (size_t i = 0; i < glb.tree["nodes"].size(); ++i) {
        if (glb.tree["nodes"][i]["name"] == name) return i;
    }
    ADD_FAILURE() << "no node " << name;
    return 0;
}

void expect_same(const Pose& got, const Pose& wanted)
{
    double dot = 0;
    for (size_t i = 0; i < 4; ++i) dot += got.turn[i] * wanted.turn[i];
    EXPECT_NEAR(std::abs(dot), 1, 1e-6);
    for (size_t i = 0; i < 3; ++i)
        EXPECT_NEAR(got.pos[i], wanted.pos[i], 1e-6 * (1 + std::abs(wanted.pos[i])));
}

// z up to y up: (x, y, z) -> (x, z, -y).
const Pose kRoot = {{0, 0, 0}, {std::sqrt(0.5), -std::sqrt(0.5), 0, 0}};

TEST(Glb, puts_z_up_to_y_up)
{
    const Glb glb = read_glb(sample_recording(), 1000);
    const Pose up = compose(node_pose(glb, 0, 0), {{1, 2, 3}, {1, 0, 0, 0}});
    EXPECT_NEAR(up.pos[0], 1, 1e-6);
    EXPECT_NEAR(up.pos[1], 3, 1e-6);
    EXPECT_NEAR(up.pos[2], -2, 1e-6);
}

TEST(Glb, has_bodies_where_the_recording_has_them)
{
    const Recording recording = sample_recording();
    const Glb glb = read_glb(recording, 1000);
    for (size_t step = 0; step < recording.steps.size(); ++step) {
        const auto numbers = recording.living(step);
        for (size_t i = 0; i < numbers.size(); ++i) {
            const size_t node = node_named(glb, "body " + std::to_string(numbers[i]));
            expect_same(world_pose(glb, node, step), compose(kRoot, recording.steps[step].bodies[i].pose));
        }
    }
    // The geom with an offset, and the one that was moved by hand in step 1.
    const Pose offset = {{0, 0, 0.25}, {1, 0, 0, 0}};
    expect_same(world_pose(glb, node_named(glb, "geom 1"), 1),
                compose(kRoot, compose(recording.steps[1].bodies[0].pose, offset)));
    expect_same(world_pose(glb, node_named(glb, "geom 3"), 0), compose(kRoot, {{4, 5, 6}, {0.6, 0.8, 0, 0}}));
    expect_same(world_pose(glb, node_named(glb, "geom 3"), 3), compose(kRoot, {{4, 5, 7}, {1, 0, 0, 0}}));
}

TEST(Glb, hides_what_does_not_live)
{
    const Glb glb = read_glb(sample_recording(), 1000);
    const json& animation = glb.tree["animations"][0];
    std::map<std::string, std::vector<float>> scales;
    for (const json& channel : animation["channels"]) {
        if (channel["target"]["path"] != "scale") continue;
        const json& sampler = animation["samplers"][channel["sampler"].get<size_t>()];
        EXPECT_EQ(sampler["interpolation"], "STEP");
        const auto values = glb.values(sampler["output"].get<size_t>());
        std::vector<float>& each = scales[glb.tree["nodes"][channel["target"]["node"].get<size_t>()]["name"]];
        for (size_t i = 0; i < values.size(); i += 3) each.push_back(values[i]);
    }
    EXPECT_EQ(scales["body 0"], (std::vector<float>{1, 1, 1, 0}));
    EXPECT_EQ(scales["body 2"], (std::vector<float>{0, 0, 1, 1}));
    EXPECT_FALSE(scales.contains("body 1"));
}

TEST(Glb, ends_in_the_last_state_whatever_the_rate)
{
    dInitODE2(0);
    dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    dBodyID body = dBodyCreate(world);
    dGeomID geom = dCreateCapsule(nullptr, dReal(0.2), 1);
    dGeomSetBody(geom, body);
    dBodySetAngularVel(body, 3, 7, -5);
    Recording recording;
    Recorder recorder(recording);
    recorder.add(body);
    recorder.add(geom);
    for (int i = 0; i <= 101; ++i) {
        recorder.step({0.01 * i, 0.01, 0, 0, 0, 0}, {}, false);
        dWorldStep(world, dReal(0.01));
    }
    for (double fps : {7.0, 30.0, 1000.0}) {
        const Glb glb = read_glb(recording, fps);
        const size_t keys =
            glb.values(glb.tree["animations"][0]["samplers"][0]["input"].get<size_t>()).size();
        EXPECT_NEAR(double(keys), std::min(102.0, 1.01 * fps), 1 + 0.15 * fps);
        expect_same(world_pose(glb, node_named(glb, "body 0"), keys - 1),
                    compose(kRoot, recording.steps.back().bodies[0].pose));
    }
    dGeomDestroy(geom);
    dWorldDestroy(world);
    dCloseODE();
}

// A run that went wrong is wanted most of all: NaN and infinities become the last pose that was one.
TEST(Glb, of_a_run_that_went_wrong_is_finite)
{
    Recording recording = sample_recording();
    recording.steps[1].bodies[0].pose.pos[1] = NAN;
    recording.steps[2].bodies[1].pose.turn = {0, 0, 0, 0};
    recording.steps[3].bodies[0].pose.pos[2] = HUGE_VAL;
    const Glb glb = read_glb(recording, 1000);
    for (const json& sampler : glb.tree["animations"][0]["samplers"]) {
        for (float value : glb.values(sampler["output"].get<size_t>())) EXPECT_TRUE(std::isfinite(value));
    }
    expect_same(world_pose(glb, node_named(glb, "body 0"), 1),
                compose(kRoot, recording.steps[0].bodies[0].pose));
}

TEST(Glb, without_anything_is_still_one)
{
    Recording recording;
    recording.info({});
    const std::string path = scratch("empty.glb");
    std::string problem;
    EXPECT_TRUE(write_glb(recording, path, 30, problem)) << problem;
    const auto bytes = read_all(path);
    const json tree = json::parse(bytes.begin() + 20, bytes.end(), nullptr, false);
    ASSERT_FALSE(tree.is_discarded());
    EXPECT_EQ(tree["nodes"].size(), 1u);
}

}  // namespace
}  // namespace epode::record
