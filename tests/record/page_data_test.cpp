// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a page is given says what the recording says, as closely as its packing promises; the browser's side
// is page_test.mjs.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "record/file/bytes.h"
#include "record/output/csv.h"
#include "record/output/page_data.h"
#include "sample.h"
#include "tests/comma_locale.h"

namespace epode::record {
namespace {

using nlohmann::json;

template <class Value>
std::vector<Value> values(const PageData& data, const json& place)
{
    std::vector<Value> out(place[1].get<size_t>());
    EXPECT_EQ(place[0].get<size_t>() % 4, 0u);
    const size_t end = place[0].get<size_t>() + out.size() * sizeof(Value);
    EXPECT_LE(end, data.block.size());
    if (end <= data.block.size() && !out.empty())
        std::memcpy(out.data(), data.block.data() + place[0].get<size_t>(), out.size() * sizeof(Value));
    return out;
}

TEST(PageData, lists_the_causes_of_failure_that_were_added_at_the_end)
{
    Recording recording = sample_recording();
    const size_t settings = recording.about.size();
    recording.info({{"diagnosis 1", "error: it broke [body 1]"}, {"diagnosis 2", "note: it creaked"}});
    EXPECT_EQ(recording.about.size(), settings + 2);
    const json head = json::parse(make_page_data(recording, 1000).head, nullptr, false);
    ASSERT_EQ(head["diagnosis"].size(), 2u);
    EXPECT_EQ(head["diagnosis"][0], "error: it broke [body 1]");
    EXPECT_EQ(head["diagnosis"][1], "note: it creaked");
}

TEST(PageData, has_bodies_where_the_recording_has_them)
{
    const Recording recording = sample_recording();
    const PageData data = make_page_data(recording, 1000);
    const json head = json::parse(data.head, nullptr, false);
    ASSERT_FALSE(head.is_discarded());
    EXPECT_EQ(head["about"]["strange"], "a \"quoted\"\nline");
    EXPECT_TRUE(head["diagnosis"].is_array() && head["diagnosis"].empty());
    const auto numbers = values<std::int32_t>(data, head["carriers"]["numbers"]);
    const auto frames = values<float>(data, head["carriers"]["frames"]);
    const auto positions = values<std::uint16_t>(data, head["carriers"]["positions"]);
    const auto turns = values<std::int16_t>(data, head["carriers"]["turns"]);
    for (size_t step = 0; step < recording.steps.size(); ++step) {
        const auto living = recording.living(step);
        for (size_t i = 0; i < living.size(); ++i) {
            const size_t carrier = living[i];
            EXPECT_EQ(numbers[4 * carrier], std::int32_t(carrier));
            const long first = numbers[4 * carrier + 1], count = numbers[4 * carrier + 2];
            const size_t key =
                size_t(numbers[4 * carrier + 3] + std::clamp(long(step) - first, 0l, count - 1));
            const Pose& pose = recording.steps[step].bodies[i].pose;
            double dot = 0;
            for (size_t k = 0; k < 3; ++k) {
                const double extent = frames[6 * carrier + 3 + k];
                const double value = frames[6 * carrier + k] + extent * positions[3 * key + k] / 65535;
                EXPECT_NEAR(value, pose.pos[k], extent / 131070 + 1e-6) << step << " " << carrier;
            }
            for (size_t k = 0; k < 4; ++k) dot += turns[4 * key + k] / 32767.0 * pose.turn[k];
            EXPECT_NEAR(std::abs(dot), 1, 1e-4);
        }
    }
    EXPECT_EQ(head["carriers"]["lives"].dump(), "[[0,0,1,3,0],[2,0,0,2,1]]");
    const auto hashes = values<std::uint32_t>(data, head["hashes"]);
    EXPECT_EQ(hashes[6] | std::uint64_t(hashes[7]) << 32, recording.steps[3].hash);
}

TEST(PageData, has_contacts_with_their_forces)
{
    const PageData data = make_page_data(sample_recording(), 1000);
    const json contacts = json::parse(data.head, nullptr, false)["contacts"];
    EXPECT_EQ(contacts["stride"], 1);
    EXPECT_EQ(contacts["counts"].dump(), "[2,2,2,2]");
    EXPECT_EQ(values<std::uint32_t>(data, contacts["starts"]), (std::vector<std::uint32_t>{0, 2, 4, 6, 8}));
    EXPECT_FLOAT_EQ(contacts["force"].get<float>(), 7);
    const auto forces = values<std::uint16_t>(data, contacts["forces"]);
    EXPECT_EQ(forces[2], 65535);
    EXPECT_NEAR(forces[3], 65535 * 2 / 7.0, 1);
    EXPECT_EQ(forces[0], 0);
}

// Many contacts are shown in fewer moments, and the block stays small.
TEST(PageData, keeps_to_its_budget_of_contacts)
{
    Recording recording = sample_recording();
    for (Step& step : recording.steps) step.contacts.resize(100'000, step.contacts[0]);
    const PageData data = make_page_data(recording, 1000);
    const json contacts = json::parse(data.head, nullptr, false)["contacts"];
    EXPECT_EQ(contacts["stride"], 3);
    EXPECT_EQ(values<std::uint32_t>(data, contacts["starts"]).size(), 3u);
    EXPECT_LT(data.block.size(), size_t(5) << 20);
}

TEST(PageData, of_a_run_that_went_wrong_is_sound)
{
    Recording recording = sample_recording();
    recording.steps[1].bodies[0].pose.pos[1] = NAN;
    recording.steps[2].bodies[1].pose.turn = {NAN, 0, 0, 0};
    recording.steps[3].contacts[0].pos[0] = NAN;
    recording.steps[3].contacts[1].force[1] = INFINITY;
    recording.steps[3].kinetic = NAN;
    const PageData data = make_page_data(recording, 1000);
    EXPECT_FALSE(json::parse(data.head, nullptr, false).is_discarded());
    EXPECT_FALSE(json::parse(make_page_data(Recording{}, 30).head, nullptr, false).is_discarded());
}

TEST(Texts, have_points_where_the_locale_of_the_program_has_commas)
{
    std::string problem;
    const auto texts = [&] {
        const std::string path = testing::TempDir() + "/epode_locale.csv";
        EXPECT_TRUE(write_csv(sample_recording(), path, problem)) << problem;
        std::ostringstream table;
        table << std::ifstream(path).rdbuf();
        std::remove(path.c_str());
        return table.str() + make_page_data(sample_recording(), 1000).head;
    };
    const std::string wanted = texts();
    const CommaLocale locale;
    if (!locale.is_there()) GTEST_SKIP() << "localedef makes no de_DE.UTF-8";
    EXPECT_EQ(texts(), wanted);
}

TEST(Tables, have_a_line_for_each_body_of_each_state)
{
    std::string problem;
    const std::string path = scratch("table.csv");
    ASSERT_TRUE(write_csv(sample_recording(), path, problem)) << problem;
    const auto bytes = read_all(path);
    EXPECT_EQ(std::count(bytes.begin(), bytes.end(), '\n'), 1 + 2 + 2 + 3 + 2);
    EXPECT_FALSE(write_csv(sample_recording(), scratch("absent/table.csv"), problem));
    EXPECT_FALSE(problem.empty());
}

}  // namespace
}  // namespace epode::record
