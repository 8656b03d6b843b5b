// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Chunks to things. Frame walks the chunks, Decoder turns payloads into things and checks that they fit what
// came before.
#include "record/file/reader.h"

#include <cerrno>
#include <cmath>
#include <cstdio>
#include <cstring>
#include <span>

#include "record/file/bytes.h"
#include "record/file/format.h"

namespace epode::record {

namespace {

constexpr size_t kBodyBytes = 13 * 8 + 1;
constexpr size_t kContactBytes = 2 * 4 + 7 * 4;
constexpr size_t kForceBytes = 3 * 4;

template <class Values>
bool finite(const Values& values)
{
    for (double value : values) {
        if (!std::isfinite(value)) return false;
    }
    return true;
}

Pose get_pose(ByteReader& in)
{
    Pose pose;
    in.f64s(pose.pos);
    in.f64s(pose.turn);
    return pose;
}

// What a chunk may refer to is what came before it.
class Decoder {
  public:
    explicit Decoder(Sink& sink) : sink_(sink) {}

    // "" when the payload was sound.
    std::string decode(std::uint32_t tag, ByteReader& in)
    {
        if (tag == kInfoTag) return info(in);
        if (tag == kShapeTag) return shape(in);
        if (tag == kBodyTag) return body(in);
        if (tag == kGeomTag) return geom(in);
        if (tag == kJointTag) return joint(in);
        if (tag == kGoneTag) return gone(in);
        if (tag == kMovedTag) return moved(in);
        if (tag == kCallTag) return calls(in);
        if (tag == kStopTag) return stops(in);
        if (tag == kLimitTag) return limits(in);
        if (tag == kStepTag) return step(in);
        if (tag == kDoneTag) return done(in);
        return "a chunk of unknown kind";
    }
    bool is_done() const { return done_; }
    std::uint64_t steps() const { return steps_; }

  private:
    struct Count {
        std::vector<bool> alive;
        size_t living = 0;
        void add()
        {
            alive.push_back(true);
            ++living;
        }
        bool remove(std::uint32_t number)
        {
            if (number >= alive.size() || !alive[number]) return false;
            alive[number] = false;
            --living;
            return true;
        }
    };

    bool is_body(std::int32_t body) const
    {
        return body == kNobody || (body >= 0 && size_t(body) < bodies_.alive.size());
    }

    std::string info(ByteReader& in)
    {
        Info info;
        for (size_t left = in.count(8); left > 0; --left) {
            const std::string key = in.text();
            info[key] = in.text();
        }
        if (!in.finished()) return "information of a wrong length";
        sink_.info(info);
        return {};
    }

    std::string shape(ByteReader& in)
    {
        Shape shape;
        const std::uint32_t kind = in.u32();
        if (kind > std::uint32_t(ShapeKind::kLast)) return "a shape of unknown kind";
        shape.kind = ShapeKind(kind);
        in.f64s(shape.size);
        shape.vertices.resize(in.count(24));
        for (auto& vertex : shape.vertices) in.f64s(vertex);
        shape.triangles.resize(in.count(12));
        for (auto& triangle : shape.triangles) {
            for (std::uint32_t& corner : triangle) corner = in.u32();
        }
        if (!in.finished()) return "a shape of a wrong length";
        bool sound = finite(shape.size);
        for (const auto& vertex : shape.vertices) sound = sound && finite(vertex);
        for (const auto& triangle : shape.triangles) {
            for (std::uint32_t corner : triangle) sound = sound && corner < shape.vertices.size();
        }
        if (!sound) return "a shape with a size that is not finite or a corner that does not exist";
        sink_.shape(shape);
        ++shapes_;
        return {};
    }

    std::string body(ByteReader& in)
    {
        Body body;
        body.mass = in.f64();
        body.kinematic = in.u8() != 0;
        if (!in.finished()) return "a body of a wrong length";
        sink_.body(body);
        bodies_.add();
        return {};
    }

    std::string geom(ByteReader& in)
    {
        Geom geom;
        geom.shape = in.u32();
        geom.body = in.i32();
        geom.pose = get_pose(in);
        if (!in.finished()) return "a geom of a wrong length";
        if (geom.shape >= shapes_ || !is_body(geom.body))
            return "a geom of a shape or body that does not exist";
        sink_.geom(geom);
        geoms_.add();
        return {};
    }

    std::string joint(ByteReader& in)
    {
        Joint joint;
        joint.type = in.u32();
        for (std::int32_t& body : joint.body) body = in.i32();
        for (size_t i = 0; i < 2; ++i) {
            joint.has_anchor[i] = in.u8() != 0;
            in.f64s(joint.anchor[i]);
            joint.has_axis[i] = in.u8() != 0;
            in.f64s(joint.axis[i]);
        }
        if (!in.finished()) return "a joint of a wrong length";
        if (!is_body(joint.body[0]) || !is_body(joint.body[1]))
            return "a joint of a body that does not exist";
        sink_.joint(joint);
        joints_.add();
        return {};
    }

    std::string gone(ByteReader& in)
    {
        const std::uint32_t kind = in.u32(), number = in.u32();
        if (!in.finished() || kind > std::uint32_t(ObjectKind::kLast)) return "an end of nothing";
        Count& count = ObjectKind(kind) == ObjectKind::kBody   ? bodies_
                       : ObjectKind(kind) == ObjectKind::kGeom ? geoms_
                                                               : joints_;
        if (!count.remove(number)) return "the end of something that does not live";
        sink_.gone(ObjectKind(kind), number);
        return {};
    }

    std::string moved(ByteReader& in)
    {
        const std::uint32_t geom = in.u32();
        const std::int32_t body = in.i32();
        const Pose pose = get_pose(in);
        if (!in.finished()) return "a move of a wrong length";
        if (geom >= geoms_.alive.size() || !is_body(body))
            return "a move of a geom or body that does not exist";
        sink_.moved(geom, body, pose);
        return {};
    }

    std::string step(ByteReader& in)
    {
        Step step;
        for (double* value :
             {&step.time, &step.dt, &step.kinetic, &step.potential, &step.joint_error, &step.ms})
            *value = in.f64();
        step.hash = in.u64();
        step.bodies.resize(in.count(kBodyBytes));
        step.asleep.resize(step.bodies.size());
        for (size_t i = 0; i < step.bodies.size(); ++i) {
            step.bodies[i].pose = get_pose(in);
            in.f64s(step.bodies[i].linear);
            in.f64s(step.bodies[i].angular);
            step.asleep[i] = in.u8();
        }
        step.has_forces = in.u8() != 0;
        step.contacts.resize(in.count(kContactBytes + (step.has_forces ? kForceBytes : 0)));
        bool sound = true;
        for (Contact& contact : step.contacts) sound = get_contact(in, step.has_forces, contact) && sound;
        if (!in.finished()) return "a step of a wrong length";
        if (step.bodies.size() != bodies_.living) return "a step of more or fewer bodies than live";
        if (!sound) return "a contact of a geom that does not exist";
        step.limits.swap(limits_);
        limits_.clear();
        sink_.step(step);
        ++steps_;
        return {};
    }

    std::string calls(ByteReader& in)
    {
        CallBlock block;
        for (size_t left = in.count(4); left > 0; --left) block.new_names.push_back(in.text());
        names_ += std::uint32_t(block.new_names.size());
        block.count = in.u32();
        if (in.failed()) return "calls of a wrong length";
        block.bytes = in.rest();
        if (!sound(block, names_)) return "calls that are none";
        sink_.calls(block);
        return {};
    }

    std::string stops(ByteReader& in)
    {
        stops_.resize(in.count(4 + 2 + 16));
        bool sound = true;
        for (Limit& limit : stops_) {
            Stop& stop = limit.stop;
            stop.joint = in.u32();
            stop.turns = in.u8() != 0;
            stop.axis = in.u8();
            stop.low = in.f64();
            stop.high = in.f64();
            sound = sound && stop.joint < joints_.alive.size() && stop.axis < 2 && stop.low <= stop.high;
        }
        if (!in.finished()) return "stops of a wrong length";
        return sound ? "" : "a stop of a joint that does not exist, or one that ends before it begins";
    }

    // Of the step that follows.
    std::string limits(ByteReader& in)
    {
        const size_t count = in.count(8);
        limits_ = stops_;
        if (count != limits_.size()) return "values of another number of stops";
        for (Limit& limit : limits_) limit.value = in.f64();
        return in.finished() ? "" : "values of stops of a wrong length";
    }

    bool get_contact(ByteReader& in, bool with_force, Contact& contact) const
    {
        for (std::uint32_t& geom : contact.geom) geom = in.u32();
        for (float& value : contact.pos) value = in.f32();
        for (float& value : contact.normal) value = in.f32();
        contact.depth = in.f32();
        if (with_force) {
            for (float& value : contact.force) value = in.f32();
        }
        return is_geom(contact.geom[0]) && is_geom(contact.geom[1]);
    }
    bool is_geom(std::uint32_t geom) const { return geom == kNoGeom || geom < geoms_.alive.size(); }

    std::string done(ByteReader& in)
    {
        const std::uint64_t said = in.u64();
        if (!in.finished() || said != steps_) return "another number of steps than the file says";
        done_ = true;
        return {};
    }

    Sink& sink_;
    size_t shapes_ = 0;
    std::uint32_t names_ = 0;
    std::vector<Limit> stops_, limits_;  // limits_: of the step to come
    Count bodies_, geoms_, joints_;
    std::uint64_t steps_ = 0;
    bool done_ = false;
};

ReadResult unreadable(std::string problem) { return {Damage::kUnreadable, std::move(problem)}; }

ReadResult breaks_off(const Decoder& decoder)
{
    return {Damage::kBreaksOff,
            "the recording breaks off after " + std::to_string(decoder.steps()) + " whole states"};
}

ReadResult broken(size_t at, const std::string& why)
{
    return {Damage::kBroken, "the recording is broken at byte " + std::to_string(at) + ": " + why};
}

ReadResult read_chunks(const std::uint8_t* bytes, size_t size, Decoder& decoder)
{
    size_t at = kFileHead;
    while (at < size) {
        if (decoder.is_done()) return broken(at, "something follows the end");
        if (size - at < kChunkHead) return breaks_off(decoder);
        ByteReader head(bytes + at, kChunkHead);
        const std::uint32_t tag = head.u32();
        const std::uint64_t length = head.u64();
        if (head.u32() != crc32(bytes + at, kChunkHead - 4)) return broken(at, "a checksum does not fit");
        if (size - at - kChunkHead < kChunkTail || length > size - at - kChunkHead - kChunkTail)
            return breaks_off(decoder);
        const size_t checked = kChunkHead + size_t(length);
        ByteReader tail(bytes + at + checked, kChunkTail);
        if (tail.u32() != crc32(bytes + at, checked)) return broken(at, "a checksum does not fit");
        ByteReader payload(bytes + at + kChunkHead, size_t(length));
        const std::string problem = decoder.decode(tag, payload);
        if (!problem.empty()) return broken(at, problem);
        at += checked + kChunkTail;
    }
    if (!decoder.is_done()) return breaks_off(decoder);
    return {};
}

bool is_recording(std::span<const std::uint8_t> bytes)
{
    return bytes.size() >= kFileHead && std::memcmp(bytes.data(), kMark, sizeof kMark) == 0;
}

}  // namespace

ReadResult read_bytes(const std::uint8_t* bytes, size_t size, Sink& sink)
{
    if (!is_recording({bytes, size})) return unreadable("this is not a recording of epode");
    ByteReader version(bytes + sizeof kMark, 4);
    const std::uint32_t said = version.u32();
    if (said < kOldestVersion || said > kVersion)
        return unreadable("the recording has version " + std::to_string(said) + ", this program reads " +
                          std::to_string(kOldestVersion) + " to " + std::to_string(kVersion));
    Decoder decoder(sink);
    return read_chunks(bytes, size, decoder);
}

ReadResult read_file(const std::string& path, Sink& sink)
{
    std::FILE* file = std::fopen(path.c_str(), "rb");
    if (!file) return unreadable(std::strerror(errno));
    // The head first: a device that never ends is not read to its end.
    std::vector<std::uint8_t> bytes(kFileHead);
    bytes.resize(std::fread(bytes.data(), 1, kFileHead, file));
    constexpr size_t kPiece = size_t(1) << 20;
    for (size_t got = is_recording(bytes) ? kPiece : 0; got == kPiece;) {
        bytes.resize(bytes.size() + kPiece);
        got = std::fread(bytes.data() + bytes.size() - kPiece, 1, kPiece, file);
        bytes.resize(bytes.size() - kPiece + got);
    }
    const bool failed = std::ferror(file) != 0;
    const int reason = errno;
    std::fclose(file);
    if (failed) return unreadable(std::strerror(reason));
    return read_bytes(bytes.data(), bytes.size(), sink);
}

}  // namespace epode::record
