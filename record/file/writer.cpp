// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Payloads as docs/recording.md tells them; reader.cpp is the mirror of this file.
#include "record/file/writer.h"

#include <cerrno>
#include <cstring>

#include "record/file/format.h"

namespace epode::record {

namespace {

void put_pose(ByteWriter& out, const Pose& pose)
{
    out.f64s(pose.pos);
    out.f64s(pose.turn);
}

void put_contact(ByteWriter& out, const Contact& contact, bool with_force)
{
    for (std::uint32_t geom : contact.geom) out.u32(geom);
    for (float value : contact.pos) out.f32(value);
    for (float value : contact.normal) out.f32(value);
    out.f32(contact.depth);
    if (!with_force) return;
    for (float value : contact.force) out.f32(value);
}

}  // namespace

FileWriter::~FileWriter()
{
    if (file_) std::fclose(file_);
}

bool FileWriter::open(const std::string& path)
{
    file_ = std::fopen(path.c_str(), "wb");
    if (!file_) {
        problem_ = std::strerror(errno);
        return false;
    }
    frame_.clear();
    for (char letter : kMark) frame_.u8(std::uint8_t(letter));
    frame_.u32(kVersion);
    put(frame_.bytes());
    return problem_.empty();
}

bool FileWriter::close()
{
    if (!file_) return problem_.empty();
    payload_.clear();
    payload_.u64(steps_);
    chunk(kDoneTag);
    if (std::fclose(file_) != 0 && problem_.empty()) problem_ = std::strerror(errno);
    file_ = nullptr;
    return problem_.empty();
}

void FileWriter::put(const std::vector<std::uint8_t>& bytes)
{
    if (!file_ || !problem_.empty()) return;
    if (std::fwrite(bytes.data(), 1, bytes.size(), file_) != bytes.size())
        problem_ = errno ? std::strerror(errno) : "write error";
}

void FileWriter::chunk(std::uint32_t tag)
{
    frame_.clear();
    frame_.u32(tag);
    frame_.u64(payload_.bytes().size());
    frame_.u32(crc32(frame_.bytes().data(), frame_.bytes().size()));
    const std::uint32_t head = crc32(frame_.bytes().data(), frame_.bytes().size());
    const std::uint32_t crc = crc32(payload_.bytes().data(), payload_.bytes().size(), head);
    put(frame_.bytes());
    put(payload_.bytes());
    frame_.clear();
    frame_.u32(crc);
    put(frame_.bytes());
    payload_.clear();
}

void FileWriter::info(const Info& info)
{
    payload_.u32(std::uint32_t(info.size()));
    for (const auto& [key, value] : info) {
        payload_.text(key);
        payload_.text(value);
    }
    chunk(kInfoTag);
}

void FileWriter::shape(const Shape& shape)
{
    payload_.u32(std::uint32_t(shape.kind));
    payload_.f64s(shape.size);
    payload_.u32(std::uint32_t(shape.vertices.size()));
    for (const auto& vertex : shape.vertices) payload_.f64s(vertex);
    payload_.u32(std::uint32_t(shape.triangles.size()));
    for (const auto& triangle : shape.triangles) {
        for (std::uint32_t corner : triangle) payload_.u32(corner);
    }
    chunk(kShapeTag);
}

void FileWriter::body(const Body& body)
{
    payload_.f64(body.mass);
    payload_.u8(body.kinematic);
    chunk(kBodyTag);
}

void FileWriter::geom(const Geom& geom)
{
    payload_.u32(geom.shape);
    payload_.i32(geom.body);
    put_pose(payload_, geom.pose);
    chunk(kGeomTag);
}

void FileWriter::joint(const Joint& joint)
{
    payload_.u32(joint.type);
    for (std::int32_t body : joint.body) payload_.i32(body);
    for (size_t i = 0; i < 2; ++i) {
        payload_.u8(joint.has_anchor[i]);
        payload_.f64s(joint.anchor[i]);
        payload_.u8(joint.has_axis[i]);
        payload_.f64s(joint.axis[i]);
    }
    chunk(kJointTag);
}

void FileWriter::gone(ObjectKind kind, std::uint32_t number)
{
    payload_.u32(std::uint32_t(kind));
    payload_.u32(number);
    chunk(kGoneTag);
}

void FileWriter::moved(std::uint32_t geom, std::int32_t body, const Pose& pose)
{
    payload_.u32(geom);
    payload_.i32(body);
    put_pose(payload_, pose);
    chunk(kMovedTag);
}

void FileWriter::calls(const CallBlock& block)
{
    payload_.u32(std::uint32_t(block.new_names.size()));
    for (const std::string& name : block.new_names) payload_.text(name);
    payload_.u32(block.count);
    payload_.append(block.bytes);
    chunk(kCallTag);
}

// Stops when they are others than before, values before every step.
void FileWriter::limits(const std::vector<Limit>& limits)
{
    std::vector<Stop> stops;
    for (const Limit& limit : limits) stops.push_back(limit.stop);
    if (stops != stops_) {
        stops_ = stops;
        payload_.u32(std::uint32_t(stops.size()));
        for (const Stop& stop : stops) {
            payload_.u32(stop.joint);
            payload_.u8(stop.turns);
            payload_.u8(stop.axis);
            payload_.f64(stop.low);
            payload_.f64(stop.high);
        }
        chunk(kStopTag);
    }
    if (limits.empty()) return;
    payload_.u32(std::uint32_t(limits.size()));
    for (const Limit& limit : limits) payload_.f64(limit.value);
    chunk(kLimitTag);
}

void FileWriter::step(const Step& step)
{
    limits(step.limits);
    for (double value : {step.time, step.dt, step.kinetic, step.potential, step.joint_error, step.ms})
        payload_.f64(value);
    payload_.u64(step.hash);
    payload_.u32(std::uint32_t(step.bodies.size()));
    for (size_t i = 0; i < step.bodies.size(); ++i) {
        put_pose(payload_, step.bodies[i].pose);
        payload_.f64s(step.bodies[i].linear);
        payload_.f64s(step.bodies[i].angular);
        payload_.u8(step.asleep[i]);
    }
    payload_.u8(step.has_forces);
    payload_.u32(std::uint32_t(step.contacts.size()));
    for (const Contact& contact : step.contacts) put_contact(payload_, contact, step.has_forces);
    chunk(kStepTag);
    ++steps_;
}

void send_all(const Recording& recording, Sink& sink)
{
    sink.info(recording.about);
    for (const Shape& shape : recording.shapes) sink.shape(shape);
    size_t body = 0, geom = 0, joint = 0, move = 0, calls = 0;
    const auto send_ends = [&](ObjectKind kind, const std::vector<Life>& lives, size_t step) {
        for (std::uint32_t i = 0; i < lives.size(); ++i) {
            if (lives[i].died == step) sink.gone(kind, i);
        }
    };
    for (size_t step = 0; step <= recording.steps.size(); ++step) {
        for (; body < recording.bodies.size() && recording.body_lives[body].born <= step; ++body)
            sink.body(recording.bodies[body]);
        for (; geom < recording.geoms.size() && recording.geom_lives[geom].born <= step; ++geom)
            sink.geom(recording.geoms[geom]);
        for (; joint < recording.joints.size() && recording.joint_lives[joint].born <= step; ++joint)
            sink.joint(recording.joints[joint]);
        for (; move < recording.moves.size() && recording.moves[move].step <= step; ++move)
            sink.moved(recording.moves[move].geom, recording.moves[move].body, recording.moves[move].pose);
        send_ends(ObjectKind::kJoint, recording.joint_lives, step);
        send_ends(ObjectKind::kGeom, recording.geom_lives, step);
        send_ends(ObjectKind::kBody, recording.body_lives, step);
        for (; calls < recording.calls_made.size() && recording.calls_made[calls].step <= step; ++calls)
            sink.calls(recording.calls_made[calls].block);
        if (step < recording.steps.size()) sink.step(recording.steps[step]);
    }
}

bool write_file(const Recording& recording, const std::string& path, std::string& problem)
{
    FileWriter writer;
    if (writer.open(path)) {
        send_all(recording, writer);
        if (writer.close()) return true;
    }
    problem = writer.problem();
    return false;
}

}  // namespace epode::record
