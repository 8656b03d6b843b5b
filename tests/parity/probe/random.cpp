// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See random.h. Directions are drawn by rejection from the unit ball, which needs no sin or cos: the
// inputs of both runs must be the same bits, and the fewer libm calls they pass through the better.
#include "random.h"

#include <cmath>

namespace parity {

Random::Random(std::string_view seed_text) : state_(1469598103934665603ull)
{
    for (const char c : seed_text) { state_ = (state_ ^ static_cast<unsigned char>(c)) * 1099511628211ull; }
    unit();
}

double Random::unit()
{
    state_ = state_ * 6364136223846793005ull + 1442695040888963407ull;
    return static_cast<double>(state_ >> 11) * 0x1p-53;
}

double Random::range(double low, double high) { return low + (high - low) * unit(); }

int Random::below(int count) { return static_cast<int>(unit() * count); }

double Random::sign() { return unit() < 0.5 ? -1.0 : 1.0; }

Vec3 Random::in_cube(double half_side)
{
    const double x = range(-half_side, half_side);
    const double y = range(-half_side, half_side);
    const double z = range(-half_side, half_side);
    return {x, y, z};
}

Vec3 Random::direction()
{
    for (;;) {
        const Vec3 v = in_cube(1.0);
        const double square = v.x * v.x + v.y * v.y + v.z * v.z;
        if (square > 0.01 && square <= 1.0) {
            const double scale = 1.0 / std::sqrt(square);
            return {v.x * scale, v.y * scale, v.z * scale};
        }
    }
}

Quat Random::rotation(double max_angle)
{
    const Vec3 axis = direction();
    const double half = 0.5 * range(-max_angle, max_angle);
    const double s = std::sin(half);
    return {std::cos(half), axis.x * s, axis.y * s, axis.z * s};
}

Quat multiply(const Quat& a, const Quat& b)
{
    return {a.w * b.w - a.x * b.x - a.y * b.y - a.z * b.z, a.w * b.x + a.x * b.w + a.y * b.z - a.z * b.y,
            a.w * b.y - a.x * b.z + a.y * b.w + a.z * b.x, a.w * b.z + a.x * b.y - a.y * b.x + a.z * b.w};
}

Vec3 rotate(const Quat& q, const Vec3& v)
{
    const Vec3 t{2 * (q.y * v.z - q.z * v.y), 2 * (q.z * v.x - q.x * v.z), 2 * (q.x * v.y - q.y * v.x)};
    return {v.x + q.w * t.x + q.y * t.z - q.z * t.y, v.y + q.w * t.y + q.z * t.x - q.x * t.z,
            v.z + q.w * t.z + q.x * t.y - q.y * t.x};
}

Vec3 perpendicular_to(const Vec3& n, Random& random)
{
    const Vec3 d = random.direction();
    const Vec3 c{n.y * d.z - n.z * d.y, n.z * d.x - n.x * d.z, n.x * d.y - n.y * d.x};
    const double length = std::sqrt(c.x * c.x + c.y * c.y + c.z * c.z);
    if (length < 0.1) { return perpendicular_to(n, random); }
    return {c.x / length, c.y / length, c.z / length};
}

}  // namespace parity
