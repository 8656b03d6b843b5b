// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies in still water and in currents: draughts, periods, stability, terminal velocities, energy, sleep.
#include <algorithm>
#include <functional>
#include <random>
#include <vector>

#include "pool.h"

namespace epode::physics {
namespace {

// A root of a rising function.
double root(const std::function<double(double)>& f, double low, double high)
{
    for (int i = 0; i < 100; ++i) {
        const double middle = (low + high) / 2;
        (f(middle) < 0 ? low : high) = middle;
    }
    return (low + high) / 2;
}

class Draught : public testing::TestWithParam<double> {
  protected:
    Draught() { pool.drag(1, 2000, 1); }
    // Settles; the height that it has then.
    double settled(dBodyID body)
    {
        pool.run(40, GetParam());
        return height(body);
    }
    Pool pool;
};

TEST_P(Draught, of_a_box_is_its_density)
{
    EXPECT_NEAR(settled(pool.box(1, 1, 0.5, 600, 0.1)), 0.25 - 0.3, tol(1e-6, 1e-4));
}

TEST_P(Draught, of_a_ball_is_the_root_of_a_cubic)
{
    const double r = 0.5, d = 0.3;
    const double depth = root([&](double t) { return (3 * r - t) * t * t - 4 * r * r * r * d; }, 0, 2 * r);
    EXPECT_NEAR(settled(pool.ball(r, 1000 * d, 0.2)), r - depth, tol(1e-6, 1e-4));
}

TEST_P(Draught, of_a_lying_cylinder_is_that_of_its_segment)
{
    dMass m;
    dMassSetCylinder(&m, 400, 3, real(0.5), 2);
    const dBodyID body = pool.body(dCreateCylinder(pool.space, real(0.5), 2), m, 0.1);
    dQuaternion q;
    dQFromAxisAndAngle(q, 1, 0, 0, real(kPi / 2));
    dBodySetQuaternion(body, q);
    const double t =
        root([](double s) { return kPi / 2 + s * std::sqrt(1 - s * s) + std::asin(s) - 0.4 * kPi; }, -1, 1);
    EXPECT_NEAR(settled(body), -0.5 * t, tol(1e-6, 1e-4));
}

TEST_P(Draught, of_a_lying_capsule_is_that_of_a_ball_and_a_cylinder)
{
    const double r = 0.4, L = 1;
    dMass m;
    dMassSetCapsule(&m, 500, 1, real(r), real(L));
    const dBodyID body = pool.body(dCreateCapsule(pool.space, real(r), real(L)), m, 0.1);
    dQuaternion q;
    dQFromAxisAndAngle(q, 0, 1, 0, real(kPi / 2));
    dBodySetQuaternion(body, q);
    const double half = 0.5 * (4.0 / 3 * kPi * r * r * r + kPi * r * r * L);
    const auto under = [&](double t) {
        const double s = t / r;
        return kPi * (r + t) * (r + t) * (2 * r - t) / 3 +
               L * r * r * (kPi / 2 + s * std::sqrt(1 - s * s) + std::asin(s));
    };
    EXPECT_NEAR(settled(body), -root([&](double t) { return under(t) - half; }, -r, r), tol(1e-6, 1e-4));
}

INSTANTIATE_TEST_SUITE_P(, Draught, testing::Values(1.0 / 120, 1.0 / 60, 1.0 / 30),
                         [](const auto& one) { return std::to_string(int(1 / one.param + 0.5)) + "_Hz"; });

// Seconds between passages of zero in one direction.
double period(const std::function<double()>& value, const std::function<void()>& step, double h)
{
    double first = -1, last = -1, before = value();
    int turns = 0;
    for (int i = 1; i < 100000 && turns < 5; ++i) {
        step();
        const double now = value();
        if (before < 0 && now >= 0) {
            last = h * (i - now / (now - before));
            if (first < 0)
                first = last;
            else
                ++turns;
        }
        before = now;
    }
    return (last - first) / turns;
}

TEST(Floating, box_heaves_with_the_period_of_its_waterplane)
{
    for (const double h : {1.0 / 240, 1.0 / 60, 1.0 / 30}) {
        Pool pool;
        const dBodyID box = pool.box(2, 1, 0.6, 500, 0.05);
        const double expected = 2 * kPi * std::sqrt(0.3 / kG);  // draught 0.3
        const double T =
            period([&] { return height(box); }, [&] { dWorldQuickStep(pool.world, real(h)); }, h);
        EXPECT_NEAR(T, expected, 0.01 * expected) << h;
    }
}

TEST(Floating, box_rolls_with_the_period_of_its_metacentric_height)
{
    for (const double h : {1.0 / 240, 1.0 / 60, 1.0 / 30}) {
        Pool pool;
        const double B = 1.6, H = 0.6, D = 0.3, L = 3;
        const dBodyID box = pool.box(L, B, H, 500, 0);
        dQuaternion q;
        dQFromAxisAndAngle(q, 1, 0, 0, real(0.02));
        dBodySetQuaternion(box, q);
        const double GM = D / 2 + B * B / (12 * D) - H / 2;
        const double expected = 2 * kPi * std::sqrt((B * B + H * H) / 12 / (kG * GM));
        const auto roll = [&] { return -double(dBodyGetQuaternion(box)[1]); };
        const double T = period(
            roll, [&] { dWorldQuickStep(pool.world, real(h)); }, h);
        EXPECT_NEAR(T, expected, 0.01 * expected) << h;
    }
}

// ---- the stability of a ship ----

using Section = std::vector<std::pair<double, double>>;  // y, z, counter-clockwise

// Of a boat with a keel, about its centre of mass.
Section hull_section(double KG)
{
    Section s = {{0, 0}, {1, 0.4}, {1.1, 1.2}, {-1.1, 1.2}, {-1, 0.4}};
    for (auto& p : s) p.second -= KG;
    return s;
}

struct Area {
    double area, y;
};

// Of the section, heeled, that lies below z = level: sums over its edges, which are cut there.
Area heeled_area(const Section& section, double heel, double level)
{
    Section turned, cut;
    for (const auto& [y, z] : section)
        turned.emplace_back(y * std::cos(heel) - z * std::sin(heel), y * std::sin(heel) + z * std::cos(heel));
    for (std::size_t i = 0; i < turned.size(); ++i) {
        const auto a = turned[i], b = turned[(i + 1) % turned.size()];
        if (a.second <= level) cut.push_back(a);
        if ((a.second <= level) != (b.second <= level)) {
            const double t = (level - a.second) / (b.second - a.second);
            cut.emplace_back(a.first + t * (b.first - a.first), level);
        }
    }
    double area = 0, moment = 0;
    for (std::size_t i = 0; i < cut.size(); ++i) {
        const auto a = cut[i], b = cut[(i + 1) % cut.size()];
        const double c = a.first * b.second - b.first * a.second;
        area += c / 2, moment += (a.first + b.first) * c / 6;
    }
    return {area, area > 0 ? moment / area : 0};
}

struct Ship {
    Section section;
    double displaced;  // area

    double level(double heel) const
    {
        return root([&](double z) { return heeled_area(section, heel, z).area - displaced; }, -3, 3);
    }
    // The side y < 0 goes down: the righting arm is that of buoyancy at -y.
    double arm(double heel) const { return -heeled_area(section, heel, level(heel)).y; }
    double vanishing_stability() const
    {
        double heel = 0.05;
        while (arm(heel) > 0 && heel < kPi) heel += 0.01;
        return root([&](double a) { return -arm(a); }, heel - 0.01, heel);
    }
};

// Whether a ship that is let go at that heel comes upright.
bool comes_upright(const Ship& ship, double heel)
{
    constexpr double kLength = 5;
    Pool pool;
    pool.drag(0, 1500, 1);
    std::vector<dReal> points;
    for (const double x : {-kLength / 2, kLength / 2})
        for (const auto& [y, z] : ship.section) points.insert(points.end(), {real(x), real(y), real(z)});
    dMass m;
    dMassSetBoxTotal(&m, real(kWaterDensity * kLength * ship.displaced), real(kLength), 2, 1);
    const dBodyID body = pool.body(dCreateConvexHull(pool.space, points.data(), int(points.size() / 3), 0), m,
                                   -ship.level(heel));
    dQuaternion q;
    dQFromAxisAndAngle(q, 1, 0, 0, real(heel));
    dBodySetQuaternion(body, q);
    pool.run(60, 1.0 / 60);
    return dBodyGetRotation(body)[10] > real(0.9);
}

TEST(Floating, ship_capsizes_beyond_its_angle_of_vanishing_stability)
{
    for (const double KG : {0.5, 0.65}) {
        const Ship ship{hull_section(KG), 1.0};
        const double angle = ship.vanishing_stability();
        EXPECT_GT(angle, 0.5);
        EXPECT_LT(angle, 2.5);
        constexpr double kClose = 0.5 * kPi / 180;
        EXPECT_TRUE(comes_upright(ship, angle - kClose)) << KG << ' ' << angle;
        EXPECT_FALSE(comes_upright(ship, angle + kClose)) << KG << ' ' << angle;
    }
}

// ---- drag ----

// rho/2 C pi r^2 v^2 = (m - rho V) g, whatever the step: also in one that is longer than the fall takes to settle.
TEST(Floating, ball_sinks_at_its_terminal_velocity)
{
    for (const double h : {1.0 / 240, 1.0 / 60, 0.5}) {
        Pool pool;
        pool.drag(0.47, 0, 0);
        const double r = 0.1, density = 7800;
        const dBodyID ball = pool.ball(r, density, -10);
        pool.run(20, h);
        const double expected = std::sqrt(8 * (density / kWaterDensity - 1) * kG * r / (3 * 0.47));
        EXPECT_NEAR(-double(dBodyGetLinearVel(ball)[2]), expected, tol(1e-9, 1e-3) * expected) << h;
    }
}

TEST(Floating, body_drifts_with_the_current)
{
    Pool pool;
    dFluidSettings s;
    dFluidSettingsInit(&s, sizeof s);
    s.current[0] = 2, s.current[1] = -1;
    dFluidSetSettings(pool.fluid, &s);
    const dBodyID box = pool.box(1, 1, 0.5, 600, 0);
    pool.run(60, 1.0 / 60);
    const dReal* v = dBodyGetLinearVel(box);
    EXPECT_NEAR(double(v[0]), 2, 1e-3);
    EXPECT_NEAR(double(v[1]), -1, 1e-3);
}

// However strong the drag and long the step.
TEST(Floating, drag_never_reverses_a_velocity)
{
    for (const double drag : {1.0, 1e3, 1e9})
        for (const double h : {0.001, 0.1, 10.0}) {
            Pool pool;
            dWorldSetGravity(pool.world, 0, 0, 0);
            pool.drag(drag, drag, drag);
            const dBodyID ball = pool.ball(0.3, 500, -5);
            dBodySetLinearVel(ball, 3, 0, 0), dBodySetAngularVel(ball, 0, 5, 0);
            double v = 3, w = 5;
            const double rounding = tol(1e-12, 2 * kEpsilon * w);  // into the axes of the body and back
            for (int i = 0; i < 20; ++i) {
                dWorldQuickStep(pool.world, real(h));
                const double v1 = double(dBodyGetLinearVel(ball)[0]),
                             w1 = double(dBodyGetAngularVel(ball)[1]);
                EXPECT_TRUE(v1 >= 0 && v1 <= v && w1 >= -rounding && w1 <= w + rounding) << v1 << ' ' << w1;
                v = v1, w = w1;
                dBodySetPosition(ball, 0, 0, -5);
            }
        }
}

// Solids of random shape dropped into water from random poses: their energy with the potentials of weight and water, rho g times the
// depth of what is displaced, is highest at the beginning; it is taken between two steps, where semi-implicit Euler keeps it.
TEST(Floating, still_water_gives_no_energy)
{
    Random random(3);
    for (int trial = 0; trial < 40; ++trial) {
        Pool pool;
        pool.drag(0.5, 50, 0.5);
        const double a = random.uniform(0.1, 1), b = random.uniform(0.1, 1), c = random.uniform(0.1, 1);
        const double density = random.uniform(50, 900), h = random.uniform(0.002, 0.017);
        const dBodyID body = trial % 2 ? pool.box(a, b, c, density, random.uniform(-2, 3))
                                       : pool.ball(a / 2, density, random.uniform(-2, 3));
        dQuaternion q;
        random.quaternion(q);
        dBodySetQuaternion(body, q);
        dMass m;
        dBodyGetMass(body, &m);
        const auto potential = [&] {
            dReal volume;
            dVector3 centre;
            dFluidGetSubmergedBody(pool.fluid, body, &volume, centre);
            return kG * (double(m.mass) * height(body) - kWaterDensity * double(volume) * double(centre[2]));
        };
        const auto kinetic = [&] {
            const dReal *v = dBodyGetLinearVel(body), *w = dBodyGetAngularVel(body);
            dVector3 local;
            dBodyVectorFromWorld(body, w[0], w[1], w[2], local);
            double sum = double(m.mass) * dot(vec(v), vec(v));
            for (int i = 0; i < 3; ++i) sum += double(m.I[5 * i]) * double(local[i]) * double(local[i]);
            return sum / 2;
        };
        const double size = double(m.mass) * kG * std::max({a, b, c});
        double highest = 1e300, before = 0;
        for (int i = 0; i < int(10 / h); ++i) {
            const double V = potential();
            ASSERT_EQ(dWorldQuickStep(pool.world, real(h)), 1);
            const double now = kinetic(), total = V + (now + before + 2 * std::sqrt(now * before)) / 4;
            before = now;
            ASSERT_LT(total, highest + 0.02 * size) << trial << " step " << i;
            highest = std::min(highest, i == 0 ? total : total + 0.1 * size);
        }
        EXPECT_LT(before, 5e-2 * size) << trial;
    }
}

// Foam a millimetre deep in the water: its own frequency is far above what a step can follow.
TEST(Floating, light_plate_stays_quiet)
{
    Pool pool;
    pool.drag(1, 50, 1);
    const dBodyID plate = pool.box(0.5, 0.5, 0.02, 20, 0.02);
    pool.run(10, 1.0 / 30);
    EXPECT_NEAR(height(plate), 0.01 - 0.0004, 1e-4);
    EXPECT_LT(std::fabs(double(dBodyGetLinearVel(plate)[2])), 0.01);
}

// ---- sleep ----

class AsleepInWater : public testing::TestWithParam<int> {};

TEST_P(AsleepInWater, floats_until_the_fluid_changes)
{
    Pool pool;
    if (GetParam() != dDefaultsOde) {
        dWorldUseDefaults(pool.world, GetParam());
        dWorldSetContactSpace(pool.world, pool.space);
    }
    dWorldSetGravity(pool.world, 0, 0, real(-kG));
    dWorldSetAutoDisableFlag(pool.world, 1);
    pool.drag(1, 1000, 1);
    const dBodyID box = pool.box(1, 1, 0.5, 600, 0.1);
    const auto step = [&] {
        return GetParam() == dDefaultsOde ? dWorldQuickStep(pool.world, real(1.0 / 60))
                                          : dWorldStepHybrid(pool.world, real(1.0 / 60));
    };
    for (int i = 0; i < 1800; ++i) ASSERT_EQ(step(), 1);
    EXPECT_EQ(dBodyIsEnabled(box), 0);
    EXPECT_NEAR(height(box), -0.05, 2e-3);
    dFluidSetPlane(pool.fluid, 0, 0, 1, real(0.3));
    EXPECT_EQ(dBodyIsEnabled(box), 1);
    for (int i = 0; i < 1800; ++i) ASSERT_EQ(step(), 1);
    EXPECT_EQ(dBodyIsEnabled(box), 0);
    EXPECT_NEAR(height(box), 0.25, 2e-3);
}

INSTANTIATE_TEST_SUITE_P(, AsleepInWater, testing::Values(int(dDefaultsOde), int(dDefaultsGame)),
                         [](const auto& one) { return one.param == dDefaultsOde ? "ode" : "game"; });

// The weight of a body in water is what the bottom bears.
TEST(Floating, sunken_box_rests_on_the_bottom_and_floats_up_in_brine)
{
    Pool pool;
    dWorldSetContactSpace(pool.world, pool.space);
    dCreatePlane(pool.space, 0, 0, 1, -2);
    dFluidSettings s;
    dFluidSettingsInit(&s, sizeof s);
    dFluidSetSettings(pool.fluid, &s);
    const dBodyID box = pool.box(1, 1, 1, 1050, -1.3);
    for (int i = 0; i < 300; ++i) dWorldStepFast1(pool.world, real(1.0 / 60), 4);
    EXPECT_NEAR(height(box), -1.5, 1e-3);
    dWorldContact contacts[8];
    double sum = 0;
    for (int i = 0, n = dWorldGetContacts(pool.world, contacts, 8); i < n; ++i)
        sum += double(contacts[i].normal_force);
    EXPECT_NEAR(sum, 50 * kG, 0.02 * 50 * kG);
    s.density = 1200;
    dFluidSetSettings(pool.fluid, &s);
    for (int i = 0; i < 1800; ++i) dWorldStepFast1(pool.world, real(1.0 / 60), 4);
    EXPECT_NEAR(height(box), 0.5 - 1050.0 / 1200, 0.02);
}

// A pool that reaches from x = 0 to 4: what lies in it floats, what lies outside falls.
TEST(Floating, volume_restricts_the_fluid)
{
    Pool pool;
    const dGeomID volume = dCreateBox(nullptr, 4, 4, 4);
    dGeomSetPosition(volume, 2, 0, -2);
    dFluidSetVolume(pool.fluid, volume);
    pool.drag(1, 1000, 1);
    const dBodyID in = pool.box(1, 1, 1, 500, -1), out = pool.box(1, 1, 1, 500, -1);
    dBodySetPosition(in, 2, 0, -1), dBodySetPosition(out, -2, 0, -1);
    pool.run(10, 1.0 / 60);
    EXPECT_NEAR(height(in), 0, 1e-3);
    EXPECT_LT(height(out), -400);
    dGeomDestroy(volume);
    EXPECT_EQ(dFluidGetVolume(pool.fluid), nullptr);
    EXPECT_EQ(dFluidGetSubmergedBody(pool.fluid, in, nullptr, nullptr), 0);
}

// ---- waves ----

dReal standing_wave(void* data, const dVector3 place, dReal time)
{
    return *static_cast<const dReal*>(data) * std::sin(place[0]) * (time < 0 ? 1 : 1);
}

// The mean of a sine over a long box: Gauss' four places are wrong by (k e)^4 / 270 of the wave's height.
TEST(Floating, surface_function_lifts_by_its_mean_over_the_geom)
{
    Pool pool;
    dReal amplitude = real(0.1);
    dFluidSetSurface(pool.fluid, standing_wave, &amplitude);
    const double e = 1, x = kPi / 2;
    const dGeomID box = dCreateBox(pool.space, real(2 * e), 1, 2);
    dGeomSetPosition(box, real(x), 0, 0);
    dReal volume;
    dFluidGetSubmerged(pool.fluid, box, &volume, nullptr);
    const double mean = 0.1 * std::sin(e) / e;
    EXPECT_NEAR(double(volume), 2 * e * (1 + mean), 2 * e * 0.1 * std::pow(e, 4) / 270 * 1.1);
}

// A current that turns: velocities of a whirl.
void whirl(void*, const dVector3 place, dReal, dVector3 velocity)
{
    velocity[0] = -place[1], velocity[1] = place[0];
}

TEST(Floating, current_function_carries_bodies_around)
{
    Pool pool;
    pool.drag(0, 1e5, 0);
    dFluidSetCurrentFunction(pool.fluid, whirl, nullptr);
    const dBodyID ball = pool.ball(0.2, 1000, -1);
    dBodySetPosition(ball, 1, 0, -1);
    pool.run(kPi / 2, 1.0 / 240);
    EXPECT_NEAR(double(dBodyGetPosition(ball)[0]), 0, 0.05);
    EXPECT_NEAR(double(dBodyGetPosition(ball)[1]), 1, 0.05);
    EXPECT_NEAR(double(dFluidGetTime(pool.fluid)), 377.0 / 240, 1e-3);
}

}  // namespace
}  // namespace epode::physics
