// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Random inputs of the parity probe.
//
// Knuth's 64-bit linear congruential generator, s <- 6364136223846793005 s + 1442695040888963407, of
// which the upper 53 bits make a number in [0,1). The probe never draws from dRand: that generator belongs
// to the library under test and is itself compared. <random> is avoided because its distributions differ
// between standard libraries, and a record file must be reproducible anywhere.
#pragma once

#include <cstdint>
#include <string_view>

namespace parity {

struct Vec3 {
    double x, y, z;
};

struct Quat {
    double w, x, y, z;
};

class Random {
  public:
    explicit Random(std::string_view seed_text);

    double unit();                          // in [0,1)
    double range(double low, double high);  // in [low,high)
    int below(int count);                   // 0 .. count-1
    double sign();                          // -1 or +1

    Vec3 in_cube(double half_side);
    Vec3 direction();                 // unit vector, uniform on the sphere
    Quat rotation(double max_angle);  // about a random axis, |angle| <= max_angle

  private:
    std::uint64_t state_;
};

Quat multiply(const Quat& a, const Quat& b);
Vec3 rotate(const Quat& q, const Vec3& v);

// A unit vector perpendicular to the unit vector n.
Vec3 perpendicular_to(const Vec3& n, Random& random);

}  // namespace parity
