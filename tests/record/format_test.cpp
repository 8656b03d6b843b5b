// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What is written is read back whole; what is broken in any one place is refused and named, and nothing that
// a file may say makes the reader leave its memory (this test runs under the address sanitizer).
#include <gtest/gtest.h>

#include <cmath>

#include "record/file/bytes.h"
#include "record/file/file_end.h"
#include "record/file/format.h"
#include "record/file/hash.h"
#include "record/file/reader.h"
#include "record/file/writer.h"
#include "record/output/animation.h"
#include "record/output/glb.h"
#include "record/output/page_data.h"
#include "sample.h"

namespace epode::record {
namespace {

// Uses whatever it receives, the way an honest listener would: by index.
class Listener : public Recording {
  public:
    void geom(const Geom& geom) override
    {
        touched += shapes.at(geom.shape).vertices.size();
        Recording::geom(geom);
    }
    void step(const Step& step) override
    {
        EXPECT_EQ(step.bodies.size(), living(steps.size()).size());
        EXPECT_EQ(step.bodies.size(), step.asleep.size());
        for (const Contact& contact : step.contacts) {
            for (std::uint32_t geom : contact.geom) touched += geom == kNoGeom ? 0 : geoms.at(geom).shape;
        }
        Recording::step(step);
    }
    void moved(std::uint32_t geom, std::int32_t body, const Pose& pose) override
    {
        touched += geoms.at(geom).shape + (body == kNobody ? 0 : bodies.at(size_t(body)).kinematic);
        Recording::moved(geom, body, pose);
    }
    size_t touched = 0;
};

struct Chunk {
    size_t at, size;  // of the payload
};

std::vector<Chunk> chunks_of(const std::vector<std::uint8_t>& bytes)
{
    std::vector<Chunk> chunks;
    for (size_t at = kFileHead; at < bytes.size();) {
        ByteReader head(bytes.data() + at + 4, 8);
        const size_t size = size_t(head.u64());
        chunks.push_back({at + kChunkHead, size});
        at += kChunkHead + size + kChunkTail;
    }
    return chunks;
}

void sign(std::vector<std::uint8_t>& bytes, const Chunk& chunk)
{
    const std::uint32_t crc = crc32(bytes.data() + chunk.at - kChunkHead, kChunkHead + chunk.size);
    for (size_t i = 0; i < 4; ++i) bytes[chunk.at + chunk.size + i] = std::uint8_t(crc >> (8 * i));
}

TEST(Recordings, are_read_as_they_were_written)
{
    const Recording wrote = sample_recording();
    const auto bytes = bytes_of(wrote);
    Listener got;
    const ReadResult result = read_bytes(bytes.data(), bytes.size(), got);
    ASSERT_TRUE(result.whole()) << result.problem;
    EXPECT_EQ(got.about, wrote.about);
    EXPECT_EQ(got.shapes, wrote.shapes);
    ASSERT_EQ(got.steps.size(), wrote.steps.size());
    EXPECT_EQ(got.joint_lives.at(0).died, 3u);
    EXPECT_EQ(got.body_lives.at(2).born, 2u);
    EXPECT_EQ(got.living(3), (std::vector<std::uint32_t>{1, 2}));
    EXPECT_EQ(got.moves.at(0).step, 1u);
    // All of it, as the writer would write it again.
    EXPECT_EQ(bytes_of(got), bytes);
}

TEST(Recordings, that_break_off_anywhere_say_so)
{
    const auto bytes = bytes_of(sample_recording());
    for (size_t size = 0; size < bytes.size(); ++size) {
        const std::vector<std::uint8_t> cut(bytes.begin(), bytes.begin() + long(size));
        Listener got;
        const ReadResult result = read_bytes(cut.data(), cut.size(), got);
        EXPECT_EQ(result.damage, size < kFileHead ? Damage::kUnreadable : Damage::kBreaksOff) << size;
        EXPECT_FALSE(result.problem.empty());
        EXPECT_LE(got.steps.size(), 4u);
    }
}

TEST(Recordings, with_a_flipped_bit_anywhere_are_refused)
{
    const auto bytes = bytes_of(sample_recording());
    for (size_t at = 0; at < bytes.size(); ++at) {
        for (int bit = 0; bit < 8; ++bit) {
            auto broken = bytes;
            broken[at] ^= std::uint8_t(1 << bit);
            Listener got;
            const ReadResult result = read_bytes(broken.data(), broken.size(), got);
            EXPECT_EQ(result.damage, at < kFileHead ? Damage::kUnreadable : Damage::kBroken)
                << "byte " << at << " bit " << bit;
            EXPECT_FALSE(result.problem.empty());
        }
    }
}

// Wrong values behind a right checksum: made on purpose, or by another program. They may be read or refused,
// not believed: the listener indexes with what it receives, and so does whoever makes a page of it.
TEST(Recordings, with_a_wrong_value_and_a_right_checksum_do_no_harm)
{
    const auto bytes = bytes_of(sample_recording());
    int refused = 0, accepted = 0;
    for (const Chunk& chunk : chunks_of(bytes)) {
        for (size_t at = chunk.at; at < chunk.at + chunk.size; ++at) {
            for (const std::uint8_t value : {0, 1, 0x7f, 0x80, 0xff}) {
                if (bytes[at] == value) continue;
                auto broken = bytes;
                broken[at] = value;
                sign(broken, chunk);
                Listener got;
                const bool whole = read_bytes(broken.data(), broken.size(), got).whole();
                (whole ? accepted : refused) += 1;
                if (whole && value == 0xff) got.touched += make_page_data(got, 30).block.size();
            }
        }
    }
    EXPECT_GT(refused, 100);   // counts and numbers of things
    EXPECT_GT(accepted, 100);  // poses
}

TEST(Recordings, with_a_stop_that_ends_before_it_begins_are_refused)
{
    for (const double low : {1.5, double(NAN)}) {
        Recording wrong = sample_recording();
        wrong.steps[0].limits[0].stop.low = low;
        const auto bytes = bytes_of(wrong);
        Recording got;
        const ReadResult result = read_bytes(bytes.data(), bytes.size(), got);
        EXPECT_EQ(result.damage, Damage::kBroken);
        EXPECT_NE(result.problem.find("a stop"), std::string::npos) << result.problem;
    }
}

TEST(Recordings, of_another_version_or_of_something_else_are_refused_by_name)
{
    auto bytes = bytes_of(sample_recording());
    Recording got;
    bytes[8] = 9;
    EXPECT_NE(read_bytes(bytes.data(), bytes.size(), got).problem.find("version 9"), std::string::npos);
    bytes[0] = 'X';
    EXPECT_NE(read_bytes(bytes.data(), bytes.size(), got).problem.find("not a recording"), std::string::npos);
    EXPECT_EQ(read_file(scratch("absent.epr"), got).damage, Damage::kUnreadable);
    EXPECT_EQ(read_file(scratch("."), got).damage, Damage::kUnreadable);
}

// A file that never ends is not read to its end.
TEST(Recordings, are_known_by_their_first_bytes)
{
    Recording got;
    const ReadResult result = read_file("/dev/zero", got);
    EXPECT_EQ(result.damage, Damage::kUnreadable);
    EXPECT_NE(result.problem.find("not a recording"), std::string::npos) << result.problem;
}

// What a signal cut off anywhere becomes whole at the last state before, and says how many those are.
TEST(Recordings, that_break_off_anywhere_can_be_completed)
{
    const Recording original = sample_recording();
    const auto bytes = bytes_of(original);
    const std::string path = scratch("cut.epr");
    std::uint64_t largest = 0;
    for (size_t size = kFileHead; size <= bytes.size(); size += 13) {
        std::FILE* file = std::fopen(path.c_str(), "wb");
        std::fwrite(bytes.data(), 1, size, file);
        std::fclose(file);
        FileEnd end;
        std::string problem;
        ASSERT_TRUE(find_end(path, end, problem)) << problem;
        EXPECT_FALSE(end.complete);
        ASSERT_TRUE(complete_file(path, end, problem)) << problem;
        Listener got;
        const ReadResult result = read_file(path, got);
        EXPECT_TRUE(result.whole()) << size << ": " << result.problem;
        EXPECT_EQ(got.steps.size(), end.states);
        EXPECT_GE(end.states, largest);
        largest = end.states;
        EXPECT_TRUE(got.about.empty() || end.about == original.about);
    }
    EXPECT_EQ(largest, original.steps.size());
}

TEST(Recordings, that_are_no_files_have_no_end)
{
    FileEnd end;
    std::string problem;
    EXPECT_FALSE(find_end(scratch("absent.epr"), end, problem));
    EXPECT_FALSE(find_end("/dev/zero", end, problem));
    EXPECT_NE(problem.find("not a recording"), std::string::npos) << problem;
}

// Bodies that come and go at once, at as many moments: poses would be their product.
TEST(Recordings, of_bodies_that_are_hardly_there_make_no_animation)
{
    Recording recording;
    for (std::uint32_t i = 0; i < 20000; ++i) {
        recording.body({1, false});
        recording.gone(ObjectKind::kBody, i);
        Step step;
        step.time = 0.1 * i;
        recording.step(step);
    }
    std::string problem;
    EXPECT_FALSE(can_animate(recording, 30, problem));
    EXPECT_NE(problem.find("--fps"), std::string::npos) << problem;
    EXPECT_FALSE(write_glb(recording, scratch("hardly.glb"), 30, problem));
    EXPECT_TRUE(can_animate(recording, 0.01, problem));
    EXPECT_TRUE(can_animate(sample_recording(), 30, problem));
}

TEST(Recordings, end_where_they_say)
{
    auto bytes = bytes_of(sample_recording());
    bytes.push_back(0);
    Recording got;
    EXPECT_EQ(read_bytes(bytes.data(), bytes.size(), got).damage, Damage::kBroken);
}

TEST(RecordingHash, is_what_its_definition_says)
{
    EXPECT_EQ(hash_states({}), 14695981039346656037ull);
    BodyState body;
    body.pose.pos = {1, 2, 3};
    body.linear = {-0.5, 0, 0};
    std::uint64_t expected = 14695981039346656037ull;
    for (double value : {1., 2., 3., 1., 0., 0., 0., -0.5, 0., 0., 0., 0., 0.}) {
        std::uint64_t y = (expected ^ std::bit_cast<std::uint64_t>(value)) * 1099511628211ull;
        expected = y ^ (y >> 32);
    }
    EXPECT_EQ(hash_states({body}), expected);
    EXPECT_EQ(as_text(0x12ab), "00000000000012ab");
}

TEST(RecordingHash, changes_with_the_last_bit_of_any_number)
{
    BodyState body;
    const std::uint64_t before = hash_states({body, body});
    for (int i = 0; i < 13; ++i) {
        BodyState other = body;
        double& value = i < 3    ? other.pose.pos[size_t(i)]
                        : i < 7  ? other.pose.turn[size_t(i - 3)]
                        : i < 10 ? other.linear[size_t(i - 7)]
                                 : other.angular[size_t(i - 10)];
        value = std::nextafter(value, 9);
        EXPECT_NE(hash_states({other, body}), before);
        EXPECT_NE(hash_states({body, other}), before);
        EXPECT_NE(hash_states({body, other}), hash_states({other, body}));
    }
}

// The checksum of "123456789" that every description of this CRC gives.
TEST(RecordingChecksum, is_crc_32)
{
    const char* text = "123456789";
    EXPECT_EQ(crc32(reinterpret_cast<const std::uint8_t*>(text), 9), 0xCBF43926u);
    std::vector<std::uint8_t> many(100);
    for (size_t i = 0; i < many.size(); ++i) many[i] = std::uint8_t(i * 37);
    const std::uint32_t whole = crc32(many.data(), many.size());
    for (size_t cut = 0; cut <= many.size(); ++cut)
        EXPECT_EQ(crc32(many.data() + cut, many.size() - cut, crc32(many.data(), cut)), whole);
}

}  // namespace
}  // namespace epode::record
