// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "step/island/positions/free_momentum.h"

#include <algorithm>

#include "math/cholesky.h"

namespace epode {
namespace {

bool holds_itself(const IslandWork& work)
{
    const auto joins_two = [](const RowBlock& block) { return block.term_count == 0 && block.body2 >= 0; };
    const auto moves = [](const Body* body) { return !body->kinematic(); };
    const RowSystem& system = work.system;
    return std::all_of(system.blocks.begin(), system.blocks.end(), joins_two) &&
           std::all_of(work.island.bodies.begin(), work.island.bodies.end(), moves);
}

Vec3 centre_of(const IslandWork& work)
{
    Real mass = 0;
    Vec3 sum;
    for (const Body* body : work.island.bodies)
        mass += body->mass.mass, sum += body->mass.mass * body->position();
    return (1 / mass) * sum;
}

// About the centre. Linear momentum needs no share of it: the arms' sum is 0.
Vec3 momentum_of(const IslandWork& work, Vec3 centre)
{
    Vec3 sum;
    for (const Body* body : work.island.bodies) {
        const Mat3 R = body->rotation();
        sum += cross(body->position() - centre, body->mass.mass * body->velocity()) +
               R * (body->inertia * transposed_times(R, body->angular_velocity()) + body->spin_excess);
    }
    return sum;
}

Mat3 inertia_of(const IslandWork& work, Vec3 centre)
{
    Sym3 sum{0, 0, 0};
    for (const Body* body : work.island.bodies) {
        const Sym3 own = rotate(body->rotation(), body->inertia);
        const Vec3 r = body->position() - centre;
        const Real m = body->mass.mass, r2 = length2(r);
        sum.xx += own.xx + m * (r2 - r.x * r.x), sum.yy += own.yy + m * (r2 - r.y * r.y);
        sum.zz += own.zz + m * (r2 - r.z * r.z), sum.xy += own.xy - m * r.x * r.y;
        sum.xz += own.xz - m * r.x * r.z, sum.yz += own.yz - m * r.y * r.z;
    }
    return full(sum);
}

}  // namespace

FreeMomentum::FreeMomentum(const IslandWork& work)
    : work_(work), free_(holds_itself(work)), L_(free_ ? momentum_of(work, centre_of(work)) : Vec3{})
{}

void FreeMomentum::restore() const
{
    if (!free_) return;
    const Vec3 centre = centre_of(work_);
    Mat3 inverse;
    if (!invert(inertia_of(work_, centre), inverse)) return;
    const Vec3 dw = inverse * (L_ - momentum_of(work_, centre));
    if (!usable(length(dw))) return;
    for (std::size_t i = 0; i < work_.island.bodies.size(); ++i) {
        Body& body = *work_.island.bodies[i];
        SolverBody& solved = work_.system.bodies[i];
        const Vec3 dv = cross(dw, body.position() - centre);
        store(body.lvel, body.velocity() + dv), store(body.avel, body.angular_velocity() + dw);
        solved.v += dv, solved.w += dw;
    }
}

}  // namespace epode
