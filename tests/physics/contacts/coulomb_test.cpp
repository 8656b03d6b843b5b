// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dWorldStep with dWorldSetFrictionCone(world, 1): friction is bounded by the normal forces that act, where ODE
// bounds it by those that would act without friction. Structures that friction carries tell the two apart:
// a ladder against a wall, an arch of loose stones, a rope around a post. Contact joints and
// world-managed contacts; the closed forms are Coulomb's.
#include <algorithm>
#include <array>
#include <utility>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81;

enum class Way { kJoints, kWorld };

// Friction in a cone, exact unless told otherwise; each geom has its own coefficient, the geometric mean of a pair counts.
class CoulombSim : public Sim {
  public:
    explicit CoulombSim(Way way, int cone = 1) : Sim(Stepper::kExact), way_(way)
    {
        gravity(0, 0, -kG);
        dWorldSetFrictionCone(world, cone);
        dWorldSetStepReportMode(world, 1);
        if (way == Way::kWorld) dWorldSetContactSpace(world, space);
    }

    // One coefficient for contact joints; geoms made so far have it, too.
    void friction(double mu)
    {
        surface.mu = real(mu);
        for (int i = 0; i < dSpaceGetNumGeoms(space); ++i) friction(dSpaceGetGeom(space, i), mu);
    }
    void friction(dGeomID geom, double mu)
    {
        dMaterial material;
        dMaterialInit(&material, sizeof material);
        material.friction = real(mu);
        dGeomSetMaterial(geom, &material);
    }
    void run(double seconds, double h)
    {
        const int count = int(seconds / h + 0.5);
        for (int i = 0; i < count; ++i) {
            way_ == Way::kWorld ? advance(h) : step(h);
            worst = std::max(worst, report().friction_error),
            residual = std::max(residual, report().residual);
        }
    }

    double worst = 0, residual = 0;  // over all steps

  private:
    Way way_;
};

class Coulomb : public testing::TestWithParam<Way> {};
std::string way_name(const testing::TestParamInfo<Way>& info)
{
    return info.param == Way::kJoints ? "joints" : "world_contacts";
}
INSTANTIATE_TEST_SUITE_P(Ways, Coulomb, testing::Values(Way::kJoints, Way::kWorld), way_name);

// A ladder of length 2 m between floor and wall with the same friction mu at both ends stands up to the angle from the floor with
// tan = (1 - mu^2) / (2 mu).
double fall_of_ladder(Way way, double times_tan, int cone, int substeps = 1)
{
    constexpr double kMu = 0.5, kLength = 2, kRadius = 0.02;
    const double angle = std::atan(times_tan * (1 - kMu * kMu) / (2 * kMu));
    const double across = kLength * std::cos(angle), up = kLength * std::sin(angle);
    CoulombSim sim(way, cone);
    sim.ground();
    dCreatePlane(sim.space, -1, 0, 0, -real(across));
    const dBodyID ladder = sim.capsule({across / 2 - kRadius, 0, up / 2 + kRadius}, kRadius, kLength, 5);
    dQuaternion turn;
    dQFromAxisAndAngle(turn, 0, 1, 0, real(kPi / 2 - angle));
    dBodySetQuaternion(ladder, turn);
    sim.friction(kMu);
    dWorldSetExactSubsteps(sim.world, substeps);
    const double z = position(ladder).z;
    sim.run(1.5, 1.0 / 120);
    return z - position(ladder).z;
}

TEST_P(Coulomb, lets_a_ladder_stand_where_it_stands)
{
    EXPECT_LT(fall_of_ladder(GetParam(), 1.05, 1), 2e-3);
    EXPECT_GT(fall_of_ladder(GetParam(), 0.9, 1), 0.1);
}

TEST_P(Coulomb, lets_a_ladder_stand_in_exact_substeps_too)
{
    EXPECT_LT(fall_of_ladder(GetParam(), 1.05, 1, 3), 2e-3);
    EXPECT_GT(fall_of_ladder(GetParam(), 0.9, 1, 3), 0.1);
}

// The reason for all this: as in ODE, limits from the solution without friction let it fall.
TEST_P(Coulomb, is_not_what_the_default_does_with_the_ladder)
{
    EXPECT_GT(fall_of_ladder(GetParam(), 1.05, 0), 0.1);
}

// Corners of one of `count` stones of a half ring.
struct Stone {
    V3 centre;
    std::array<dReal, 24> corners;
    std::array<dReal, 24> planes;
};

constexpr unsigned kFaces[] = {4, 1, 3, 2, 0, 4, 6, 7, 5, 4, 4, 4, 5, 1, 0,
                               4, 3, 7, 6, 2, 4, 2, 6, 4, 0, 4, 5, 7, 3, 1};

Stone stone(int i, int count, double inner, double outer)
{
    std::array<V3, 8> at;
    Stone out{};
    for (std::size_t v = 0; v < 8; ++v) {
        const double a = kPi * (i + (v & 4 ? 1 : 0)) / count, r = v & 2 ? outer : inner,
                     y = v & 1 ? 0.3 : -0.3;
        at[v] = {r * std::cos(a), y, r * std::sin(a)};
        out.centre = out.centre + 0.125 * at[v];
    }
    for (std::size_t v = 0; v < 8; ++v) {
        const V3 p = at[v] - out.centre;
        out.corners[3 * v] = real(p.x), out.corners[3 * v + 1] = real(p.y),
                        out.corners[3 * v + 2] = real(p.z);
    }
    for (std::size_t f = 0; f < 6; ++f) {
        const V3 a = at[kFaces[5 * f + 1]], b = at[kFaces[5 * f + 2]], c = at[kFaces[5 * f + 3]];
        V3 n = cross(b - a, c - a);
        n = (1 / length(n)) * n;
        const double d = dot(n, a - out.centre);
        EXPECT_GT(d, 0) << "face " << f << " looks inwards";
        out.planes[4 * f] = real(n.x), out.planes[4 * f + 1] = real(n.y), out.planes[4 * f + 2] = real(n.z);
        out.planes[4 * f + 3] = real(d);
    }
    return out;
}

// A half ring of loose stones stands when it is thicker than 10.75 % of its mean radius (Couplet, Heyman): this has 26 %.
TEST_P(Coulomb, carries_an_arch_of_loose_stones)
{
    constexpr int kStones = 11;
    CoulombSim sim(GetParam());
    sim.ground();
    std::array<Stone, kStones> stones;
    for (int i = 0; i < kStones; ++i) {
        Stone& s = stones[std::size_t(i)] = stone(i, kStones, 1, 1.3);
        const dBodyID body = sim.body(s.centre, 10);
        dMass mass;
        dMassSetBoxTotal(&mass, 10, real(0.3), real(0.6), real(0.33));
        dBodySetMass(body, &mass);
        dGeomSetBody(dCreateConvex(sim.space, s.planes.data(), 6, s.corners.data(), 8, kFaces), body);
    }
    sim.friction(0.7);
    const double keystone = position(sim.bodies[kStones / 2]).z;
    sim.run(4, 1.0 / 120);
    EXPECT_NEAR(position(sim.bodies[kStones / 2]).z, keystone, 4e-3);
    EXPECT_LT(length(velocity(sim.bodies[kStones / 2])), 1e-3);
    EXPECT_LT(sim.worst, tol(1e-6, 1e-4));
}

// A block pressed against a wall by a force F is held up to m g = mu F, whichever way "up" is in the plane of its contacts.
TEST_P(Coulomb, holds_a_block_at_a_wall_in_every_direction_up_to_mu_f)
{
    constexpr double kMu = 0.5, kMass = 2;
    for (int k = 0; k < 6; ++k)
        for (const double share : {0.97, 1.03}) {
            const double a = 0.2 + k * kPi / 3.7;
            CoulombSim sim(GetParam());
            sim.ground();
            const dBodyID block = sim.box({0, 0, 0.1}, {1, 1, 0.2}, kMass);
            sim.friction(kMu);
            sim.gravity(kG * std::cos(a), kG * std::sin(a), -kG / (kMu * share));
            sim.run(1, 1.0 / 100);
            const double slid = std::hypot(position(block).x, position(block).y);
            const double expected = share < 1 ? 0 : 0.5 * kG * (1 - 1 / share);
            EXPECT_NEAR(slid, expected, tol(1e-4, 5e-4) + 0.02 * expected) << k;  // floats yield by their CFM
            EXPECT_LT(sim.worst, tol(1e-7, 1e-4)) << k;
            EXPECT_LE(sim.residual, tol(1e-9, 1e-5)) << k;
        }
}

// A plate that slides and spins on its corners stops sliding and spinning at the same moment; while it turns, friction
// opposes each point's own slip: force and torque are less than mu N and mu N r.
TEST_P(Coulomb, stops_sliding_and_spinning_together)
{
    CoulombSim sim(GetParam());
    sim.ground();
    const dBodyID body = sim.box({0, 0, 0.05}, {1, 1, 0.1}, 1);
    sim.friction(0.3);
    sim.run(0.2, 1.0 / 200);
    velocity(body, {2, 1, 0}, {0, 0, 3});
    double ended_sliding = -1, ended_spinning = -1;
    for (double t = 0; t < 2; t += 1.0 / 200) {
        sim.run(1.0 / 200, 1.0 / 200);
        if (ended_sliding < 0 && length(velocity(body)) < 0.02) ended_sliding = t;
        if (ended_spinning < 0 && std::fabs(spin(body).z) < 0.02) ended_spinning = t;
    }
    EXPECT_NEAR(ended_sliding, ended_spinning, 0.05);
    EXPECT_GT(ended_sliding, std::sqrt(5.0) / (0.3 * kG));  // sliding alone takes that long
}

// Of two balls on a cord around a post, mu = 0.4: the heavier sinks when it weighs more than exp(mu pi) = 3.5 times the
// lighter.
double sink_of_cord(Way way, double ratio, int cone)
{
    constexpr double kPost = 0.5, kCord = 0.02, kLink = 0.12, kMu = 0.4;
    constexpr int kLinks = 30;
    CoulombSim sim(way, cone);
    const dGeomID post = dCreateCylinder(sim.space, real(kPost), 1);
    dMatrix3 turn;
    dRFromAxisAndAngle(turn, 1, 0, 0, real(kPi / 2));
    dGeomSetRotation(post, turn);
    const double r = kPost + kCord, quarter = r * kPi / 2;
    for (int i = 0; i < kLinks; ++i) {
        const double s = (i - kLinks / 2 + 0.5) * kLink,
                     over = std::copysign(std::max(std::fabs(s) - quarter, 0.0), s);
        const double a = (s - over) / r;
        const bool end = i == 0 || i == kLinks - 1;
        const double mass = i == 0 ? 1 : end ? ratio : 0.01;
        const dBodyID link =
            sim.capsule({r * std::sin(a), 0, r * std::cos(a) - std::fabs(over)}, kCord, 0.8 * kLink, mass);
        dQuaternion q;
        dQFromAxisAndAngle(q, 0, 1, 0, real(a + kPi / 2));
        dBodySetQuaternion(link, q);
        if (i == 0) continue;
        const dBodyID before = sim.bodies[std::size_t(i - 1)];
        const dJointID joint = dJointCreateBall(sim.world, nullptr);
        dJointAttach(joint, before, link);
        const V3 anchor = 0.5 * (position(before) + position(link));
        dJointSetBallAnchor(joint, real(anchor.x), real(anchor.y), real(anchor.z));
    }
    sim.friction(kMu);
    const double z = position(sim.bodies.back()).z;
    sim.run(1, 1.0 / 240);
    return z - position(sim.bodies.back()).z;
}

TEST_P(Coulomb, holds_a_cord_around_a_post_as_euler_says)
{
    EXPECT_LT(sink_of_cord(GetParam(), 2.6, 1), 0.1);
    EXPECT_GT(sink_of_cord(GetParam(), 4.6, 1), 0.2);
}

}  // namespace
}  // namespace epode::physics
