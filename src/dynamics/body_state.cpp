// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/body_state.h"

#include <algorithm>
#include <cmath>

#include "base/streams/little_endian.h"
#include "dynamics/active.h"
#include "dynamics/sleep/sleeping_forces.h"
#include "math/rotation.h"

namespace epode {
namespace {

enum Bit : std::uint16_t {
    kDisabled = 1 << 0,
    kActive = 1 << 1,
    kPatched = 1 << 2,
    kDriven = 1 << 3,
    kGravity = 1 << 4,
    kGyroscopic = 1 << 5,
    kFiniteRotation = 1 << 6,
    kAutoDisable = 1 << 7,
    // There are numbers of:
    kMatrix = 1 << 8,
    kVelocity = 1 << 9,
    kForce = 1 << 10,
    kSpin = 1 << 11,
    kFiniteAxis = 1 << 12,
    kHybrid = 1 << 13,
    kWatch = 1 << 14,
    kCounts = 1 << 15,
};

// Most bodies have pose and velocities alone: numbers in one run.
constexpr unsigned kSpecial = kMatrix | kForce | kSpin | kFiniteAxis | kHybrid | kWatch | kCounts;
constexpr int kPoseNumbers = 7, kMotionNumbers = 13;

std::size_t plain_bytes(std::uint16_t bits)
{
    return sizeof(Real) * std::size_t(bits & kVelocity ? kMotionNumbers : kPoseNumbers);
}

using Bits = std::conditional_t<kSingle, std::uint32_t, std::uint64_t>;
constexpr int kMantissa = kSingle ? 23 : 52;
constexpr Bits kOne = Bits(1) << kMantissa, kSign = Bits(1) << (8 * sizeof(Real) - 1);
constexpr Bits kExponent = kSign - kOne;

// An exponent of all ones carries into the sign.
bool all_finite(const std::byte* from, int count)
{
    Bits carry = 0;
    for (int i = 0; i < count; ++i) {
        const Bits bits = get_little<Bits>(from, std::size_t(i));
        carry |= (bits & kExponent) + kOne;
    }
    return !(carry & kSign);
}

// To the last bit: -0 is something.
bool all_zero(const Real* values)
{
    const auto bits = [&](int i) { return std::bit_cast<Bits>(values[i]); };
    return (bits(0) | bits(1) | bits(2)) == 0;
}

bool all_zero(Vec3 v) { return all_zero(&v.x); }

Bits differing(const Real* row, Vec3 v)
{
    const auto bits = [](Real a, Real b) { return std::bit_cast<Bits>(a) ^ std::bit_cast<Bits>(b); };
    return bits(row[0], v.x) | bits(row[1], v.y) | bits(row[2], v.z);
}

bool is_matrix_of_quaternion(const Body& body)
{
    const Mat3 m = to_matrix(body.orientation());
    return (differing(body.R, m.row0) | differing(body.R + 4, m.row1) | differing(body.R + 8, m.row2)) == 0;
}

bool is_new(const Stillness& window)
{
    const Vec3 turn = window.orientation.vec();
    return window.time == 0 && !window.still && all_zero(window.position) && all_zero(turn);
}

// What most bodies have left of idle steps and time: states leave it out. Fixed, those of a new world, so that a state does not
// depend on settings of the day, which are none of it; those before format 8 did.
struct UsualCounts {
    UsualCounts(const Body& body, const StateStream& stream)
        : steps(stream.format() < 8 ? body.sleep.steps : 10), time(stream.format() < 8 ? body.sleep.time : 0)
    {}
    int steps;
    Real time;
};

bool has_been_watched(const Body& body)
{
    return body.auto_disable || (body.world->watches_bodies &&
                                 (body.sample_next > 0 || body.samples_ready || body.settling_time > 0 ||
                                  !is_new(body.short_window) || !is_new(body.long_window)));
}

bool has_counts(const Body& body, const UsualCounts& usual)
{
    return body.idle_steps_left != usual.steps || body.idle_time_left != usual.time;
}

void vector(Vec3& v, StateStream& stream) { stream.reals(&v.x, 3); }

enum WatchBit : std::uint32_t {
    kSamplesReady = 1,
    kShortStill = 2,
    kLongStill = 4,
    kShortHere = 8,
    kLongHere = 16,
};

// Does the window begin with the body's pose? So it does from falling asleep on.
bool begins_here(const Body& body, const Stillness& w)
{
    return std::memcmp(&w.position.x, body.pos, sizeof w.position) == 0 &&
           std::memcmp(&w.orientation.w, body.q, sizeof w.orientation) == 0;
}

void window(const Body& body, Stillness& w, bool here, StateStream& stream)
{
    if (!here) {
        vector(w.position, stream);
        stream.reals(&w.orientation.w, 4);
    } else if (stream.stores()) {
        w.position = body.position(), w.orientation = body.orientation();
    }
}

// With one sample the ring holds nothing that is read before it is written.
void samples(Body& body, StateStream& stream)
{
    const auto count = std::uint32_t(body.sleep.samples);
    if (stream.word(count) != count) {
        stream.demand(stream.saves(), "a body averages over another number of samples than in the state");
        return;
    }
    const std::uint32_t next =
        stream.index(std::uint32_t(body.sample_next), count < 1 ? 1 : count, "a sample of no body");
    if (stream.stores()) body.sample_next = int(next);
    for (int i = 0; count > 1 && i < int(count); ++i)
        vector(body.sample_v[i], stream), vector(body.sample_w[i], stream);
}

void watch_state(Body& body, StateStream& stream)
{
    Stillness &brief = body.short_window, &lasting = body.long_window;
    const std::uint32_t own = (body.samples_ready ? kSamplesReady : 0u) | (brief.still ? kShortStill : 0u) |
                              (lasting.still ? kLongStill : 0u) |
                              (begins_here(body, brief) ? kShortHere : 0u) |
                              (begins_here(body, lasting) ? kLongHere : 0u);
    const std::uint32_t bits =
        stream.unusual({StateStream::computed(body.idle_time_left, UsualCounts(body, stream).time, true),
                        StateStream::computed(body.settling_time, 0), StateStream::computed(brief.time, 0),
                        StateStream::computed(lasting.time, 0)},
                       own);
    const auto steps = int(stream.word(std::uint32_t(body.idle_steps_left)));
    if (stream.stores()) body.world->watches_bodies = true;
    window(body, brief, bits & kShortHere, stream);
    window(body, lasting, bits & kLongHere, stream);
    samples(body, stream);
    if (!stream.stores()) return;
    body.idle_steps_left = steps;
    body.samples_ready = bits & kSamplesReady;
    brief.still = bits & kShortStill, lasting.still = bits & kLongStill;
}

// Of a body that no step watches, but with settings of the program.
void counts(Body& body, StateStream& stream)
{
    const auto steps = int(stream.word(std::uint32_t(body.idle_steps_left)));
    stream.reals(&body.idle_time_left, 1, true);
    if (stream.stores()) body.idle_steps_left = steps;
}

// Of a body that no step has watched.
void forget_watch(Body& body, const UsualCounts& usual)
{
    if (body.idle_steps_left != usual.steps) body.idle_steps_left = usual.steps;
    if (body.idle_time_left != usual.time) body.idle_time_left = usual.time;
    if (!body.world->watches_bodies) return;
    body.sample_next = 0, body.samples_ready = false;
    body.short_window = body.long_window = Stillness{};
    body.settling_time = 0;
}

bool is_unit(const Quat& q) { return std::fabs(q.w * q.w + length2(q.vec()) - 1) < kUnitTolerance; }

constexpr const char* kNoUnit = "an orientation of the state is no unit quaternion";

struct Orientation {
    Real q[4], R[12];
};

bool is_sound(const Orientation& o, std::uint16_t bits, StateStream& stream)
{
    return stream.demand(is_unit(load_quat(o.q)), kNoUnit) &&
           (!(bits & kMatrix) || stream.demand(is_rotation(load_mat(o.R), kUnitTolerance),
                                               "a matrix of the state is no rotation"));
}

// What is loaded goes through a copy, to be judged as a whole.
void orientation(Body& body, std::uint16_t bits, StateStream& stream)
{
    Orientation o{};
    std::memcpy(o.q, body.q, sizeof o.q), std::memcpy(o.R, body.R, sizeof o.R);
    {
        const StateStream::IntoCopies into(stream);
        stream.reals(o.q, 4);
        for (int row = 0; (bits & kMatrix) && row < 3; ++row) stream.reals(o.R + 4 * row, 3);
    }
    if (stream.failed() || (!stream.is_checked() && !is_sound(o, bits, stream)) || !stream.stores()) return;
    if (!(bits & kMatrix)) store_mat(o.R, to_matrix(load_quat(o.q)));
    std::memcpy(body.q, o.q, sizeof o.q), std::memcpy(body.R, o.R, sizeof o.R);
}

// True: it becomes another one.
bool pose(Body& body, std::uint16_t bits, StateStream& stream)
{
    if (stream.saves()) {
        stream.reals(body.pos, 3), stream.reals(body.q, 4);
        for (int row = 0; (bits & kMatrix) && row < 3; ++row) stream.reals(body.R + 4 * row, 3);
        return false;
    }
    Real position[4];
    Orientation o;
    std::memcpy(position, body.pos, sizeof position);
    std::memcpy(o.q, body.q, sizeof o.q), std::memcpy(o.R, body.R, sizeof o.R);
    stream.reals(body.pos, 3);
    orientation(body, bits, stream);
    return std::memcmp(position, body.pos, sizeof position) != 0 ||
           std::memcmp(o.q, body.q, sizeof o.q) != 0 || std::memcmp(o.R, body.R, sizeof o.R) != 0;
}

// Reads before it writes: a line of the cache that stays as it is need not go back to memory.
void clear(Real* values)
{
    if (!all_zero(values)) values[0] = values[1] = values[2] = 0;
}

void take_bits(Body& body, std::uint16_t bits, const StateStream& stream)
{
    if (const bool driven = bits & kDriven; driven != body.driven)
        driven ? set_kinematic(body) : set_dynamic(body);
    body.disabled = bits & kDisabled;
    body.had_manifolds = bits & kPatched;
    body.gravity = bits & kGravity;
    body.gyroscopic = bits & kGyroscopic;
    body.finite_rotation = bits & kFiniteRotation;
    watch(body, bits & kAutoDisable);
    bits& kActive ? body.world->bodies.activate(body) : body.world->bodies.deactivate(body);
    if (!(bits & kVelocity)) clear(body.lvel), clear(body.avel);
    if (!(bits & kForce)) clear(body.facc), clear(body.tacc);
    if (!(bits & kSpin)) clear(&body.spin_excess.x);
    if (!(bits & kFiniteAxis)) clear(&body.finite_axis.x);
    if (!(bits & kHybrid) && body.hybrid.remembers()) body.hybrid = {.requested = body.hybrid.requested};
    if (!(bits & kWatch)) forget_watch(body, UsualCounts(body, stream));
}

void hybrid(Body& body, StateStream& stream)
{
    HybridState& h = body.hybrid;
    // Work 16 bits, exact 1, half of apart 2, refused 5, the other half 2, strained 6.
    const std::uint32_t word =
        stream.word(std::uint32_t(h.work) << 16 | std::uint32_t(h.was_exact) << 15 | (h.apart >> 2u) << 13 |
                    std::uint32_t(h.refused) << 8 | (h.apart & 3u) << 6 | h.strained);
    if (!stream.stores()) return;
    const bool old = stream.format() < 6;  // with factorisations instead of work
    h.was_exact = word >> (old ? 8 : 15) & 1;
    h.strained = std::uint8_t(old ? word >> 16 : word & 63);
    h.refused = std::uint8_t(old ? 0 : word >> 8 & 31), h.work = std::uint16_t(old ? 0 : word >> 16);
    h.apart = std::uint8_t(old ? 0 : (word >> 13 & 3) << 2 | (word >> 6 & 3));
}

std::uint16_t bits_of(const Body& body, const StateStream& stream)
{
    const auto bit = [](bool on, Bit b) { return on ? unsigned(b) : 0u; };
    const bool watched = has_been_watched(body);
    return std::uint16_t(
        bit(body.disabled, kDisabled) | bit(is_active(body), kActive) | bit(body.had_manifolds, kPatched) |
        bit(body.driven, kDriven) | bit(body.gravity, kGravity) | bit(body.gyroscopic, kGyroscopic) |
        bit(body.finite_rotation, kFiniteRotation) | bit(body.auto_disable, kAutoDisable) |
        bit(!is_matrix_of_quaternion(body), kMatrix) |
        bit(!all_zero(body.lvel) || !all_zero(body.avel), kVelocity) |
        bit(!all_zero(body.facc) || !all_zero(body.tacc), kForce) | bit(!all_zero(body.spin_excess), kSpin) |
        bit(!all_zero(body.finite_axis), kFiniteAxis) | bit(body.hybrid.remembers(), kHybrid) |
        bit(watched, kWatch) | bit(!watched && has_counts(body, UsualCounts(body, stream)), kCounts));
}

void save_plain(const Body& body, std::uint16_t bits, StateStream& stream)
{
    std::byte* const to = stream.block(plain_bytes(bits));
    if (!to) return;
    // Each at once from where it is: what is put together elsewhere first has to arrive there.
    copy_little<sizeof(Real)>(to, body.pos, 3);
    copy_little<sizeof(Real)>(to + 3 * sizeof(Real), body.q, 4);
    if (!(bits & kVelocity)) return;
    copy_little<sizeof(Real)>(to + 7 * sizeof(Real), body.lvel, 3);
    copy_little<sizeof(Real)>(to + 10 * sizeof(Real), body.avel, 3);
}

Real number_at(const std::byte* from, int i) { return get_little<Real>(from, std::size_t(i)); }

Vec3 vector_at(const std::byte* from, int i)
{
    return {number_at(from, i), number_at(from, i + 1), number_at(from, i + 2)};
}

Quat quaternion_at(const std::byte* from, int i)
{
    return {number_at(from, i), number_at(from, i + 1), number_at(from, i + 2), number_at(from, i + 3)};
}

void check_plain(std::uint16_t bits, StateStream& stream)
{
    const std::byte* const from = stream.block(plain_bytes(bits));
    if (!from) return;
    (void)(stream.demand(all_finite(from, bits & kVelocity ? kMotionNumbers : kPoseNumbers),
                         StateStream::kBadNumber) &&
           stream.demand(is_unit(quaternion_at(from, 3)), kNoUnit));
}

bool take_plain(Body& body, std::uint16_t bits, StateStream& stream)
{
    const std::byte* const from = stream.block(plain_bytes(bits));
    const Vec3 p = vector_at(from, 0);
    const Quat q = quaternion_at(from, 3);
    const Mat3 m = to_matrix(q);
    const Bits differs = differing(body.pos, p) | differing(body.q + 1, q.vec()) |
                         (std::bit_cast<Bits>(body.q[0]) ^ std::bit_cast<Bits>(q.w)) |
                         differing(body.R, m.row0) | differing(body.R + 4, m.row1) |
                         differing(body.R + 8, m.row2);
    if (differs != 0) store(body.pos, p), store_quat(body.q, q), store_mat(body.R, m);
    if (bits & kVelocity) store(body.lvel, vector_at(from, 7)), store(body.avel, vector_at(from, 10));
    return differs != 0;
}

bool special(Body& body, std::uint16_t bits, StateStream& stream)
{
    const bool moves = pose(body, bits, stream);
    if (bits & kVelocity) stream.reals(body.lvel, 3), stream.reals(body.avel, 3);
    if (bits & kForce) {
        stream.reals(body.facc, 3), stream.reals(body.tacc, 3);
        if (stream.stores()) note_forces(body);
    }
    if (bits & kSpin) vector(body.spin_excess, stream);
    if (bits & kFiniteAxis) vector(body.finite_axis, stream);
    if (bits & kHybrid) hybrid(body, stream);
    if (bits & kWatch) watch_state(body, stream);
    if (bits & kCounts) counts(body, stream);
    return moves;
}

}  // namespace

std::uint16_t save_state(Body& body, StateStream& stream)
{
    const std::uint16_t bits = bits_of(body, stream);
    if (bits & kSpecial)
        special(body, bits, stream);
    else
        save_plain(body, bits, stream);
    return bits;
}

bool load_state(Body& body, std::uint16_t bits, StateStream& stream)
{
    if (stream.stores()) take_bits(body, bits, stream);
    if (bits & kSpecial) return special(body, bits, stream);
    if (stream.stores()) return take_plain(body, bits, stream);
    check_plain(bits, stream);
    return false;
}

}  // namespace epode
