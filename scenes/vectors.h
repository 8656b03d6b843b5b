// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Vectors, rotations and random numbers of scenes, free of any engine, so that what is described with them
// can be handed to every engine. A rotation is a unit quaternion (w, x, y, z); a*b turns by b first. Made
// with the C library's sine, not with a libode's, so that a scene starts from the same bits whichever one it
// runs on.
#pragma once

#include <cmath>
#include <cstdint>

namespace epode::scenes {

struct Vec {
    double x = 0, y = 0, z = 0;
};
// Of three numbers in a row, dReals or doubles.
template <class Number>
Vec vec(const Number* v)
{
    return {double(v[0]), double(v[1]), double(v[2])};
}
inline Vec operator+(Vec a, Vec b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
inline Vec operator-(Vec a, Vec b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
inline Vec operator*(double s, Vec a) { return {s * a.x, s * a.y, s * a.z}; }
inline double dot(Vec a, Vec b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
inline double length(Vec a) { return std::sqrt(dot(a, a)); }
inline Vec cross(Vec a, Vec b)
{
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

struct Turn {
    double w = 1, x = 0, y = 0, z = 0;  // unit quaternion
};
Turn turn(Vec axis, double angle);  // axis of any length but zero
Turn operator*(Turn a, Turn b);     // b first
Vec rotate(Turn q, Vec v);
inline Turn inverse(Turn q) { return {q.w, -q.x, -q.y, -q.z}; }

constexpr Vec kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};
constexpr double kPi = 3.14159265358979323846;

// x' = 1664525 x + 1013904223 mod 2^32 (Numerical Recipes): few lines, the same numbers everywhere; the high
// bits are used.
class Lcg {
  public:
    explicit Lcg(std::uint32_t seed) : state_(seed * 2654435761u + 1u) {}
    std::uint32_t next() { return state_ = state_ * 1664525u + 1013904223u; }
    double uniform(double low, double high) { return low + (high - low) * (next() >> 8) / 16777216.0; }
    int below(int count) { return int((std::uint64_t(next() >> 8) * unsigned(count)) >> 24); }
    Turn any_turn() { return turn({uniform(-1, 1), uniform(-1, 1), uniform(0.1, 1)}, uniform(-kPi, kPi)); }

  private:
    std::uint32_t state_;
};

}  // namespace epode::scenes
