// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Friction of world-managed contacts is the same in every direction, in all steppers and without the
// cone: what slides comes to rest after v^2 / (2 mu g), straight on; what is pushed, or lies on a slope, gives
// way at mu N; and what slides and spins follows Coulomb's law at each of its four corners, integrated here
// with steps of 5 us. (With the axes of ODE's contacts a box of 3 m/s and mu = 0.4 stopped after 0.81 m
// instead of 1.15, and 0.08 rad aside.)
#include <algorithm>
#include <cmath>

#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kMu = 0.5, kG = 9.81, kMass = 5, kEdge = 0.6, kHigh = 0.1;
constexpr double kFine = 1.0 / 120;

enum class SlipStepper { kExact, kQuick, kSmall, kHybrid };

class Slab {
  public:
    // Gravity leans towards the azimuth by `slope`, rad.
    Slab(SlipStepper stepper, double slope = 0, double azimuth = 0) : stepper_(stepper)
    {
        dWorldSetGravity(world_, real(kG * std::sin(slope) * std::cos(azimuth)),
                         real(kG * std::sin(slope) * std::sin(azimuth)), real(-kG * std::cos(slope)));
        dWorldSetContactSpace(world_, space_);
        const dGeomID floor = dCreatePlane(space_, 0, 0, 1, 0);
        const dGeomID geom = dCreateBox(space_, real(kEdge), real(kEdge), real(kHigh));
        set_material(floor, kMu), set_material(geom, kMu);
        body = dBodyCreate(world_);
        dMass mass;
        dMassSetBoxTotal(&mass, real(kMass), real(kEdge), real(kEdge), real(kHigh));
        dBodySetMass(body, &mass);
        dGeomSetBody(geom, body);
        dBodySetPosition(body, 0, 0, real(kHigh / 2));
    }
    Slab(const Slab&) = delete;
    Slab& operator=(const Slab&) = delete;
    ~Slab()
    {
        dWorldDestroy(world_);
        dSpaceDestroy(space_);
    }

    void step(double h)
    {
        switch (stepper_) {
            case SlipStepper::kExact:
                dWorldStep(world_, real(h));
                break;
            case SlipStepper::kQuick:
                dWorldQuickStep(world_, real(h));
                break;
            case SlipStepper::kSmall:
                dWorldStepFast1(world_, real(h), 4);
                break;
            case SlipStepper::kHybrid:
                dWorldStepHybrid(world_, real(h));
                break;
        }
    }
    double speed() const
    {
        return std::hypot(double(vec(dBodyGetLinearVel(body)).x), vec(dBodyGetLinearVel(body)).y);
    }

    dBodyID body;

  private:
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    SlipStepper stepper_;
};

constexpr double kAzimuths[] = {0, 0.3, 0.7, 0.785398, 1.2, 2.5, -1.9};

class FrictionAlongSlip : public testing::TestWithParam<SlipStepper> {};

TEST_P(FrictionAlongSlip, brakes_by_mu_g_straight_on)
{
    const double v = 3, way = v * v / (2 * kMu * kG);
    for (const double a : kAzimuths) {
        Slab slab(GetParam());
        dBodySetLinearVel(slab.body, real(v * std::cos(a)), real(v * std::sin(a)), 0);
        for (int i = 0; i < 200; ++i) slab.step(kFine);
        const V3 p = vec(dBodyGetPosition(slab.body));
        // A first-order step stops up to h v / 2 early.
        EXPECT_NEAR(std::hypot(p.x, p.y), way, 0.55 * kFine * v) << a;
        EXPECT_NEAR(p.y * std::cos(a) - p.x * std::sin(a), 0, tol(1e-4, 1e-3)) << a;
        EXPECT_NEAR(double(dBodyGetQuaternion(slab.body)[3]), 0, tol(1e-4, 1e-3)) << a;
    }
}

TEST_P(FrictionAlongSlip, gives_way_to_mu_n)
{
    for (const double a : kAzimuths)
        for (const double share : {0.98, 1.02}) {
            Slab pushed(GetParam()), leaning(GetParam(), std::atan(kMu * share), a);
            const double force = share * kMu * kMass * kG;
            for (int i = 0; i < 90; ++i) {
                dBodyAddForce(pushed.body, real(force * std::cos(a)), real(force * std::sin(a)), 0);
                pushed.step(1.0 / 60), leaning.step(1.0 / 60);
            }
            const double gained = std::max(0.0, 1.5 * (share - 1) * kMu * kG), off = 0.003 * kMu * kG;
            EXPECT_NEAR(pushed.speed(), gained, off) << a << ' ' << share;
            EXPECT_NEAR(leaning.speed(), gained * std::cos(std::atan(kMu * share)), off) << a << ' ' << share;
        }
}

// A slab on its corners, each with a quarter of the weight.
struct Spinner {
    double vx, vy, w, angle = 0;

    void run(double time)
    {
        const double inertia = kMass * (kEdge * kEdge + kEdge * kEdge) / 12, dt = 5e-6;
        for (int i = 0, n = int(time / dt); i < n; ++i) {
            double fx = 0, fy = 0, torque = 0;
            for (int corner = 0; corner < 4; ++corner) {
                const double x = (corner & 1 ? 0.5 : -0.5) * kEdge, y = (corner & 2 ? 0.5 : -0.5) * kEdge;
                const double rx = std::cos(angle) * x - std::sin(angle) * y;
                const double ry = std::sin(angle) * x + std::cos(angle) * y;
                const double ux = vx - w * ry, uy = vy + w * rx, u = std::hypot(ux, uy);
                const double f = kMu * kMass * kG / 4 / u;
                fx -= f * ux, fy -= f * uy, torque -= f * (rx * uy - ry * ux);
            }
            vx += dt * fx / kMass, vy += dt * fy / kMass, w += dt * torque / inertia, angle += dt * w;
        }
    }
};

TEST_P(FrictionAlongSlip, brakes_each_corner_of_what_spins)
{
    Slab slab(GetParam());
    for (int i = 0; i < 20; ++i) slab.step(kFine);
    Spinner reference{1, 0.6, 20};
    dBodySetLinearVel(slab.body, real(reference.vx), real(reference.vy), 0);
    dBodySetAngularVel(slab.body, 0, 0, real(reference.w));
    const double before = std::hypot(reference.vx, reference.vy);
    reference.run(12 * kFine);
    for (int i = 0; i < 12; ++i) slab.step(kFine);
    const V3 v = vec(dBodyGetLinearVel(slab.body));
    EXPECT_NEAR(v.x, reference.vx, 0.02 * before);
    EXPECT_NEAR(v.y, reference.vy, 0.02 * before);
    EXPECT_NEAR(double(dBodyGetAngularVel(slab.body)[2]), reference.w, 0.01 * 20);
}

std::string slip_name(const testing::TestParamInfo<SlipStepper>& info)
{
    const char* const names[] = {"exact", "quick", "small", "hybrid"};
    return names[int(info.param)];
}

INSTANTIATE_TEST_SUITE_P(Steppers, FrictionAlongSlip,
                         testing::Values(SlipStepper::kExact, SlipStepper::kQuick, SlipStepper::kSmall,
                                         SlipStepper::kHybrid),
                         slip_name);

}  // namespace
}  // namespace epode::physics
