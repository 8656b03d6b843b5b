// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "dynamics/body_state.h"

#include <algorithm>
#include <cmath>

#include "dynamics/active.h"

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
};

using Bits = std::conditional_t<kSingle, std::uint32_t, std::uint64_t>;

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

bool has_been_watched(const Body& body)
{
    return body.auto_disable || body.idle_steps_left != body.sleep.steps ||
           body.idle_time_left != body.sleep.time || body.sample_next > 0 || body.samples_ready ||
           body.settling_time > 0 || !is_new(body.short_window) || !is_new(body.long_window);
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
    const std::uint32_t bits = stream.unusual({{&body.idle_time_left, body.sleep.time, true},
                                               {&body.settling_time, 0},
                                               {&brief.time, 0},
                                               {&lasting.time, 0}},
                                              own);
    const auto steps = int(stream.word(std::uint32_t(body.idle_steps_left)));
    window(body, brief, bits & kShortHere, stream);
    window(body, lasting, bits & kLongHere, stream);
    samples(body, stream);
    if (!stream.stores()) return;
    body.idle_steps_left = steps;
    body.samples_ready = bits & kSamplesReady;
    brief.still = bits & kShortStill, lasting.still = bits & kLongStill;
}

// Of a body that no step has watched.
void forget_watch(Body& body)
{
    body.idle_steps_left = body.sleep.steps, body.idle_time_left = body.sleep.time;
    body.sample_next = 0, body.samples_ready = false;
    body.short_window = body.long_window = Stillness{};
    body.settling_time = 0;
}

// Of what a state brings. A contact's normal is that of the state, turned by R: together they stay within what a step allows (1e-3).
constexpr Real kUnitTolerance = Real(1e-4);

bool is_rotation(const Real* R)
{
    const Mat3 m = load_mat(R), product = m * transpose(m);
    Real error = 0;
    for (int row = 0; row < 3; ++row)
        for (int column = 0; column < 3; ++column)
            error = std::max(error, std::fabs(product.row(row)[column] - Real(row == column)));
    return error < kUnitTolerance;
}

struct Orientation {
    Real q[4], R[12];
};

bool is_sound(const Orientation& o, std::uint16_t bits, StateStream& stream)
{
    const Quat unit = load_quat(o.q);
    const Real norm2 = unit.w * unit.w + length2(unit.vec());
    return stream.demand(std::fabs(norm2 - 1) < kUnitTolerance,
                         "an orientation of the state is no unit quaternion") &&
           (!(bits & kMatrix) || stream.demand(is_rotation(o.R), "a matrix of the state is no rotation"));
}

// What is loaded goes through a copy, to be judged as a whole.
void orientation(Body& body, std::uint16_t bits, StateStream& stream)
{
    Orientation o{};
    std::memcpy(o.q, body.q, sizeof o.q), std::memcpy(o.R, body.R, sizeof o.R);
    const StateStream::Mode mode = stream.mode();
    stream.set_mode(StateStream::Mode::kRead);
    stream.reals(o.q, 4);
    for (int row = 0; (bits & kMatrix) && row < 3; ++row) stream.reals(o.R + 4 * row, 3);
    stream.set_mode(mode);
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

void clear(Real (&values)[4]) { store(values, {}); }

void take_bits(Body& body, std::uint16_t bits)
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
    if (!(bits & kSpin)) body.spin_excess = {};
    if (!(bits & kFiniteAxis)) body.finite_axis = {};
    if (!(bits & kHybrid)) body.hybrid.was_exact = false, body.hybrid.factorisations = 0;
    if (!(bits & kWatch)) forget_watch(body);
}

void hybrid(Body& body, StateStream& stream)
{
    const std::uint32_t word =
        stream.word(std::uint32_t(body.hybrid.was_exact) << 8 | body.hybrid.factorisations);
    if (!stream.stores()) return;
    body.hybrid.was_exact = word >> 8 & 1;
    body.hybrid.factorisations = std::uint8_t(word);
}

}  // namespace

std::uint16_t state_bits(const Body& body)
{
    const auto bit = [](bool on, Bit b) { return on ? unsigned(b) : 0u; };
    return std::uint16_t(
        bit(body.disabled, kDisabled) | bit(is_active(body), kActive) | bit(body.had_manifolds, kPatched) |
        bit(body.driven, kDriven) | bit(body.gravity, kGravity) | bit(body.gyroscopic, kGyroscopic) |
        bit(body.finite_rotation, kFiniteRotation) | bit(body.auto_disable, kAutoDisable) |
        bit(!is_matrix_of_quaternion(body), kMatrix) |
        bit(!all_zero(body.lvel) || !all_zero(body.avel), kVelocity) |
        bit(!all_zero(body.facc) || !all_zero(body.tacc), kForce) | bit(!all_zero(body.spin_excess), kSpin) |
        bit(!all_zero(body.finite_axis), kFiniteAxis) |
        bit(body.hybrid.was_exact || body.hybrid.factorisations > 0, kHybrid) |
        bit(has_been_watched(body), kWatch));
}

bool state(Body& body, std::uint16_t bits, StateStream& stream)
{
    if (stream.stores()) take_bits(body, bits);
    const bool moves = pose(body, bits, stream);
    if (bits & kVelocity) stream.reals(body.lvel, 3), stream.reals(body.avel, 3);
    if (bits & kForce) stream.reals(body.facc, 3), stream.reals(body.tacc, 3);
    if (bits & kSpin) vector(body.spin_excess, stream);
    if (bits & kFiniteAxis) vector(body.finite_axis, stream);
    if (bits & kHybrid) hybrid(body, stream);
    if (bits & kWatch) watch_state(body, stream);
    return moves;
}

}  // namespace epode
