// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/ahead/pair_separation.h"

#include <cmath>

#include "collide/solid_type.h"
#include "geometry/overlap/separating_direction.h"

namespace epode {
namespace {

constexpr Real kSteps = 32767;  // of a coordinate, either way
constexpr Real kHair = kSingle ? Real(1e-4) : Real(1e-6);
constexpr Real kLargestTurn = Real(0.5);

// How far the geom without its rounding reaches from its place along d, of about length 1, in its own frame.
Real core_reach(const Geom& geom, Vec3 d) { return geom.type->solid->core_reach(geom, d); }
CoreSize core_size(const Geom& geom) { return geom.type->solid->core_size(geom); }

// How far a geom may turn in a step.
struct StepRotation {
    Vec3 spin;            // angle of the step
    Real angle;           // its size
    Real arm, aside = 0;  // of the farthest point and of the geom's place from the body's centre

    StepRotation(const Pose& pose, Real size, const SpeculativeMotion& soon, const Body* body)
    {
        if (body) spin = soon.h * body->angular_velocity(), aside = length(pose.p - body->position());
        angle = length(spin);
        arm = size + aside;
    }
    Real max_shift() const { return angle * arm; }
    // What reach_turned() may be wrong by.
    Real rest() const { return angle * angle * arm + angle * aside; }
};

// Along n after the turn.
Real reach_turned(const Geom& geom, const Mat3& R, Vec3 n, Vec3 spin)
{
    return core_reach(geom, transposed_times(R, n - cross(spin, n)));
}

// The lower half of the octahedron is folded over the edges of the upper one.
Vec3 folded(Real x, Real y, Real z)
{
    const Real over = z < 0 ? -z : Real(0);
    return {x - std::copysign(over, x), y - std::copysign(over, y), z};
}

}  // namespace

std::uint32_t pack_direction(Vec3 n)
{
    const Real sum = std::fabs(n.x) + std::fabs(n.y) + std::fabs(n.z);
    if (!(sum > 0)) return 0;
    Real x = n.x / sum, y = n.y / sum;
    if (n.z < 0) {
        const Real was = x;
        x = std::copysign(1 - std::fabs(y), x), y = std::copysign(1 - std::fabs(was), y);
    }
    const auto steps = [](Real t) { return std::uint32_t(t * kSteps + (kSteps + 1) + Real(0.5)); };
    return steps(x) << 16 | steps(y);
}

Vec3 unpack_direction(std::uint32_t code)
{
    const auto coordinate = [](std::uint32_t steps) { return Real(int(steps)) - (kSteps + 1); };
    const Real x = coordinate(code >> 16), y = coordinate(code & 0xffff);
    const Vec3 n = folded(x, y, kSteps - std::fabs(x) - std::fabs(y));
    return (1 / length(n)) * n;
}

PairSeparation::PairSeparation(const Geom& g1, const Geom& g2) : g1_(g1), g2_(g2)
{
    const CoreSize one = core_size(g1), two = core_size(g2);
    size1_ = one.farthest, size2_ = two.farthest;
    rounding_ = one.radius + two.radius;
    hair_ = kHair * (size1_ + size2_ + rounding_);
}

Vec3 PairSeparation::find(const Pose& pose1, const Pose& pose2, Vec3 guess) const
{
    return separating_direction(solid_view(g1_, pose1), solid_view(g2_, pose2), guess, hair_);
}

Real PairSeparation::gap(const Pose& pose1, const Pose& pose2, Vec3 n) const
{
    return dot(n, pose1.p - pose2.p) - core_reach(g1_, transposed_times(pose1.R, -n)) -
           core_reach(g2_, transposed_times(pose2.R, n)) - rounding_;
}

bool PairSeparation::lasts(const Pose& pose1, const Pose& pose2, Vec3 n, Real gap,
                           const SpeculativeMotion& soon, const Body* body1, const Body* body2) const
{
    const StepRotation one(pose1, size1_, soon, body1), two(pose2, size2_, soon, body2);
    const Real moved = soon.h * dot(n, soon.velocity(body1) - soon.velocity(body2));
    if (gap + moved - one.max_shift() - two.max_shift() > hair_) return true;
    if (one.angle > kLargestTurn || two.angle > kLargestTurn) return false;
    const Real apart = dot(n, pose1.p - pose2.p) + moved - rounding_ - one.rest() - two.rest();
    return apart - reach_turned(g1_, pose1.R, -n, one.spin) - reach_turned(g2_, pose2.R, n, two.spin) > hair_;
}

}  // namespace epode
