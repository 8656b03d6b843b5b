// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Events as a game uses them: the impact of a ball in every stepper, the weight of a stack, thresholds, ends of
// what was destroyed, sensors of every kind, breaks; one order whatever the threads; the same after a state.
#include <algorithm>
#include <functional>
#include <map>

#include "world_contacts.h"

namespace epode::physics {
namespace {

constexpr double kG = 9.81;
constexpr unsigned kAllKinds = 63;
constexpr dStepper kWays[] = {dStepperExact, dStepperQuick, dStepperSubsteps, dStepperHybrid};

class EventWorld {
  public:
    explicit EventWorld(dStepper stepper = dStepperSubsteps, unsigned kinds = 0) : way(stepper)
    {
        dWorldSetGravity(world, 0, 0, real(-kG));
        dWorldSetContactSpace(world, space);
        dEventSettings settings;
        dEventSettingsInit(&settings, sizeof settings);
        if (kinds) settings.kinds = kinds;
        set(settings);
    }
    ~EventWorld()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }
    EventWorld(const EventWorld&) = delete;
    EventWorld& operator=(const EventWorld&) = delete;

    void set(const dEventSettings& settings) const { ASSERT_EQ(dWorldSetEventSettings(world, &settings), 1); }
    dEventSettings settings() const
    {
        dEventSettings s;
        s.struct_size = sizeof s;
        dWorldGetEventSettings(world, &s);
        return s;
    }

    dBodyID ball(V3 at, double radius = 0.1, double mass = 2) const
    {
        dMass m;
        dMassSetSphereTotal(&m, real(mass), real(radius));
        return add(dCreateSphere(space, real(radius)), m, at);
    }
    dBodyID box(V3 at, double side = 1, double mass = 2) const
    {
        dMass m;
        dMassSetBoxTotal(&m, real(mass), real(side), real(side), real(side));
        return add(dCreateBox(space, real(side), real(side), real(side)), m, at);
    }
    dGeomID ground() const { return dCreatePlane(space, 0, 0, 1, 0); }
    dGeomID gate(V3 at, V3 size) const
    {
        const dGeomID geom = dCreateBox(space, real(size.x), real(size.y), real(size.z));
        dGeomSetPosition(geom, real(at.x), real(at.y), real(at.z));
        dGeomSetSensor(geom, 1);
        return geom;
    }

    void step() const
    {
        const dReal h = real(kH);
        const int made = way == dStepperExact      ? dWorldStep(world, h)
                         : way == dStepperQuick    ? dWorldQuickStep(world, h)
                         : way == dStepperSubsteps ? dWorldStepFast1(world, h, 4)
                                                   : dWorldStepHybrid(world, h);
        ASSERT_EQ(made, 1);
    }
    std::vector<dEvent> events() const
    {
        std::vector<dEvent> out(std::size_t(dWorldGetEvents(world, nullptr, 0)));
        EXPECT_EQ(dWorldGetEvents(world, out.data(), int(out.size())), int(out.size()));
        return out;
    }
    int count(int kind) const
    {
        const auto all = events();
        return int(std::count_if(all.begin(), all.end(), [&](const dEvent& e) { return e.kind == kind; }));
    }
    // Steps until there is such an event, at most so often.
    bool wait_for(int kind, dEvent& event, int steps = 200) const
    {
        for (int i = 0; i < steps; ++i) {
            step();
            for (const dEvent& e : events())
                if (e.kind == kind) {
                    event = e;
                    return true;
                }
        }
        return false;
    }

    dStepper way;
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);

  private:
    dBodyID add(dGeomID geom, const dMass& mass, V3 at) const
    {
        const dBodyID body = dBodyCreate(world);
        dBodySetMass(body, &mass);
        dGeomSetBody(geom, body);
        place(body, at);
        return body;
    }
};

class Impact : public testing::TestWithParam<int> {
  protected:
    dStepper way() const { return kWays[GetParam()]; }
};
INSTANTIATE_TEST_SUITE_P(Steppers, Impact, testing::Range(0, 4));

// The momentum of the step, and the closed form of a fall from one metre with restitution 0.5.
TEST_P(Impact, of_a_bouncing_ball_has_its_speed_and_impulse)
{
    EventWorld sim(way());
    set_material(sim.ground(), 0.6, 0.5);
    const double mass = 2;
    const dBodyID ball = sim.ball({0, 0, 1.1}, 0.1, mass);
    set_material(geom_of(ball), 0.6, 0.5);
    V3 before;
    for (int i = 0; i < 100 && sim.count(dEventContactBegin) == 0; ++i) before = velocity(ball), sim.step();
    const auto events = sim.events();
    ASSERT_EQ(events.size(), 1u);
    const dEvent& hit = events[0];
    EXPECT_EQ(hit.g1, geom_of(ball));
    EXPECT_EQ(hit.gone, 0);
    EXPECT_NEAR(hit.normal[2], 1, 1e-6);
    EXPECT_NEAR(hit.pos[2], 0, 2 * kG * kH);  // where the ball was when the step began, less its way
    EXPECT_NEAR(hit.approach_speed, -before.z, 1e-5);
    EXPECT_NEAR(hit.approach_speed, std::sqrt(2 * kG * 1), 1.5 * kG * kH);  // falls in steps; one to go
    EXPECT_NEAR(hit.impulse, mass * (velocity(ball).z - before.z + kG * kH), 1e-3);
    EXPECT_NEAR(hit.impulse, 1.5 * mass * std::sqrt(2 * kG * 1), 1.5 * mass * 2 * kG * kH);
    EXPECT_EQ(sim.count(dEventContactPersist), 0);
    dEvent end;
    EXPECT_TRUE(sim.wait_for(dEventContactEnd, end, 5));
    EXPECT_EQ(end.g1, hit.g1);
    EXPECT_EQ(end.impulse, 0);
}

TEST_P(Impact, impulses_of_a_resting_stack_carry_its_weight)
{
    EventWorld sim(way(), kAllKinds);
    const dGeomID floor = sim.ground();
    for (int i = 0; i < 4; ++i) sim.box({0, 0, 0.5 + i}, 1, 3);
    for (int i = 0; i < 120; ++i) sim.step();
    double on_floor = 0, all = 0;
    for (int i = 0; i < 60; ++i) {
        sim.step();
        EXPECT_EQ(sim.count(dEventContactPersist), 4);
        for (const dEvent& e : sim.events()) {
            all += e.impulse;
            if (e.g2 == floor) on_floor += e.impulse;
        }
    }
    const double weight = 4 * 3 * kG;  // for one second
    EXPECT_NEAR(on_floor, weight, 0.005 * weight);
    EXPECT_NEAR(all, weight * (1 + 0.75 + 0.5 + 0.25), 0.005 * 2.5 * weight);
}

TEST_P(Impact, begins_once_and_ends_once)
{
    EventWorld sim(way());
    const dGeomID floor = sim.ground();
    const dBodyID box = sim.box({0, 0, 0.7});
    int begins = 0, ends = 0;
    const auto run = [&](int steps) {
        for (int i = 0; i < steps; ++i) {
            sim.step();
            begins += sim.count(dEventContactBegin), ends += sim.count(dEventContactEnd);
            EXPECT_EQ(sim.count(dEventContactPersist), 0);
        }
    };
    run(120);
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(ends, 0);
    place(box, {0, 0, 5});
    run(1);
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(ends, 1);
    dGeomDestroy(floor);
    run(60);
    EXPECT_EQ(begins, 1);
    EXPECT_EQ(ends, 1);
}

TEST(Events, are_not_listed_unless_wanted)
{
    EventWorld sim;
    ASSERT_EQ(dWorldSetEventSettings(sim.world, nullptr), 1);
    sim.ground();
    sim.box({0, 0, 0.5});
    for (int i = 0; i < 5; ++i) {
        sim.step();
        EXPECT_EQ(sim.events().size(), 0u);
    }
    dEventSettings s;
    s.struct_size = sizeof s;
    EXPECT_EQ(dWorldGetEventSettings(sim.world, &s), 0);
    EXPECT_EQ(s.kinds, kAllKinds - (1u << dEventContactPersist));
}

TEST(Events, leave_out_what_is_below_the_thresholds)
{
    const auto begins = [](dReal speed, dReal impulse) {
        EventWorld sim;
        dEventSettings s = sim.settings();
        s.min_approach_speed = speed, s.min_impulse = impulse;
        sim.set(s);
        sim.ground();
        sim.ball({0, 0, 1.1});   // 4.4 m/s, 8.9 N s
        sim.ball({1, 0, 0.11});  // 0.4 m/s, 0.9 N s
        int count = 0;
        for (int i = 0; i < 40; ++i) sim.step(), count += sim.count(dEventContactBegin);
        return count;
    };
    EXPECT_EQ(begins(0, 0), 2);
    EXPECT_EQ(begins(2, 0), 1);
    EXPECT_EQ(begins(0, 3), 1);
    EXPECT_EQ(begins(10, 0), 0);
    EXPECT_EQ(begins(0, 30), 0);
}

TEST(Events, of_ends_report_that_an_object_is_gone)
{
    EventWorld sim;
    sim.ground();
    const dBodyID box = sim.box({0, 0, 0.5});
    const dGeomID geom = geom_of(box);
    sim.step();
    ASSERT_EQ(sim.count(dEventContactBegin), 1);
    dGeomDestroy(geom);
    EXPECT_EQ(sim.events()[0].gone, dEventGoneG1);
    sim.step();
    const auto events = sim.events();
    ASSERT_EQ(events.size(), 1u);
    EXPECT_EQ(events[0].kind, dEventContactEnd);
    EXPECT_EQ(events[0].g1, geom);
    EXPECT_EQ(events[0].gone, dEventGoneG1);
    const Messages messages;
    EXPECT_EQ(dGeomGetBody(events[0].g1), nullptr);
    EXPECT_EQ(messages.count(), 1);
}

TEST(Events, count_what_is_lost_and_keep_the_more_important)
{
    EventWorld sim(dStepperSubsteps, kAllKinds);
    dEventSettings s = sim.settings();
    s.capacity = 5;
    sim.set(s);
    sim.ground();
    for (int i = 0; i < 8; ++i) sim.box({3.0 * i, 0, 0.5});
    sim.step();
    EXPECT_EQ(sim.count(dEventContactBegin), 5);
    EXPECT_EQ(dWorldGetLostEvents(sim.world), 3);
    sim.step();
    EXPECT_EQ(sim.count(dEventContactPersist), 5);
    EXPECT_EQ(dWorldGetLostEvents(sim.world), 3);
    sim.gate({0, 0, 0.5}, {10, 1, 1});  // four boxes
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorBegin), 2) << "boxes at 0 and 3 m, with persist events in the way";
    EXPECT_EQ(sim.count(dEventContactPersist), 3);
    EXPECT_EQ(dWorldGetLostEvents(sim.world), 5);
}

// ---- sensors ----

TEST(Sensors, report_and_exert_no_force)
{
    EventWorld sim;
    const dGeomID gate = sim.gate({0, 0, 0}, {1, 1, 1});
    const dBodyID ball = sim.ball({0, 0, 2}, 0.1);
    EventWorld free;
    const dBodyID twin = free.ball({0, 0, 2}, 0.1);
    int begun = 0, ended = 0;
    for (int i = 0; i < 90; ++i) {
        sim.step(), free.step();
        EXPECT_EQ(position(ball).z, position(twin).z);
        const bool inside = std::abs(position(ball).z) < 0.6;
        for (const dEvent& e : sim.events()) {
            EXPECT_EQ(e.g1, gate);
            EXPECT_EQ(e.g2, geom_of(ball));
            EXPECT_EQ(e.kind, inside ? dEventSensorBegin : dEventSensorEnd);
            ++(inside ? begun : ended);
        }
    }
    EXPECT_EQ(begun, 1);
    EXPECT_EQ(ended, 1);
}

TEST(Sensors, on_moving_and_kinematic_bodies_meet_what_sleeps_and_what_stands)
{
    for (const bool kinematic : {false, true}) {
        EventWorld sim;
        dWorldSetGravity(sim.world, 0, 0, 0);
        const dBodyID carrier = sim.ball({-3, 0, 0}, 0.2);
        dGeomSetSensor(geom_of(carrier), 1);
        if (kinematic) dBodySetKinematic(carrier);
        velocity(carrier, {3, 0, 0});
        const dBodyID sleeper = sim.box({0, 0, 0}, 1);
        dBodyDisable(sleeper);
        const dGeomID wall = dCreateBox(sim.space, 1, 1, 1);
        dGeomSetPosition(wall, 3, 0, 0);
        std::vector<std::pair<int, dGeomID>> seen;
        for (int i = 0; i < 150; ++i) {
            sim.step();
            for (const dEvent& e : sim.events()) seen.emplace_back(e.kind, e.g2);
        }
        const std::vector<std::pair<int, dGeomID>> expected = {{dEventSensorBegin, geom_of(sleeper)},
                                                               {dEventSensorEnd, geom_of(sleeper)},
                                                               {dEventSensorBegin, wall},
                                                               {dEventSensorEnd, wall}};
        EXPECT_EQ(seen, expected) << (kinematic ? "kinematic" : "dynamic");
        EXPECT_EQ(dBodyIsEnabled(sleeper), 0);
        EXPECT_EQ(position(sleeper).x, 0);
    }
}

TEST(Sensors, keep_what_falls_asleep_in_them_and_see_it_destroyed)
{
    EventWorld sim;
    dWorldSetAutoDisableFlag(sim.world, 1);
    sim.ground();
    sim.gate({0, 0, 0.5}, {4, 4, 4});
    const dBodyID box = sim.box({0, 0, 0.5});
    const dGeomID geom = geom_of(box);
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorBegin), 1);
    for (int i = 0; i < 200; ++i) {
        sim.step();
        EXPECT_EQ(sim.events().size(), 0u);
    }
    ASSERT_EQ(dBodyIsEnabled(box), 0);
    dGeomDestroy(geom);
    sim.step();
    const auto events = sim.events();
    ASSERT_EQ(events.size(), 2u);
    EXPECT_EQ(events[0].kind, dEventContactEnd);
    EXPECT_EQ(events[1].kind, dEventSensorEnd);
    EXPECT_EQ(events[1].gone, dEventGoneG2);
}

TEST(Sensors, follow_the_rules_of_collision)
{
    EventWorld sim;
    dWorldSetGravity(sim.world, 0, 0, 0);
    const dGeomID gate = sim.gate({0, 0, 0}, {2, 2, 2});
    const dBodyID ball = sim.ball({0, 0, 0});
    sim.gate({0, 0, 0}, {1, 1, 1});  // sensors do not see each other, but both see the ball
    const dGeomID pillar = dCreateBox(sim.space, 1, 1, 1);  // neither it nor the gates have a body
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorBegin), 2);
    dGeomSetCategoryBits(gate, 1), dGeomSetCollideBits(gate, 2);
    dGeomSetCategoryBits(geom_of(ball), 4), dGeomSetCollideBits(geom_of(ball), 4);
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorEnd), 1);
    dGeomSetCollideBits(gate, 6);
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorBegin), 1);
    dGeomDisable(gate);
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorEnd), 1);
    dGeomEnable(gate);
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorBegin), 1);
    dGeomSetSensor(gate, 0);
    sim.step();
    EXPECT_EQ(sim.count(dEventSensorEnd), 1);
    EXPECT_EQ(dGeomGetSensor(gate), 0);
    EXPECT_EQ(dGeomGetSensor(pillar), 0);
}

TEST(Sensors, let_continuous_bodies_through)
{
    EventWorld sim;
    dWorldSetGravity(sim.world, 0, 0, 0);
    sim.gate({0, 0, 0}, {1, 1, 0.01});
    const dBodyID ball = sim.ball({0, 0, 2});
    dGeomSetContinuous(geom_of(ball), dContinuousOn);
    velocity(ball, {0, 0, -200});
    sim.step();
    EXPECT_NEAR(position(ball).z, 2 - 200 * kH, 1e-5);
    EXPECT_NEAR(velocity(ball).z, -200, 1e-3);
}

TEST(Sensors, a_geom_that_becomes_one_ends_its_contacts)
{
    EventWorld sim;
    const dGeomID floor = sim.ground();
    const dBodyID box = sim.box({0, 0, 0.5});
    for (int i = 0; i < 10; ++i) sim.step();
    dGeomSetSensor(floor, 1);
    sim.step();
    EXPECT_EQ(sim.count(dEventContactEnd), 1);
    EXPECT_EQ(sim.count(dEventSensorBegin), 1);
    for (int i = 0; i < 60; ++i) sim.step();
    EXPECT_LT(position(box).z, -1);
}

TEST(Sensors, in_the_way_of_ode_are_geoms_like_others)
{
    EventWorld sim;
    dWorldSetContactSpace(sim.world, nullptr);
    sim.gate({0, 0, 0}, {1, 1, 1});
    sim.ball({0, 0, 0});
    int pairs = 0;
    dSpaceCollide(sim.space, &pairs, [](void* count, dGeomID a, dGeomID b) {
        dContactGeom contact;
        EXPECT_TRUE(dGeomGetSensor(a) || dGeomGetSensor(b));
        *static_cast<int*>(count) += dCollide(a, b, 1, &contact, sizeof contact);
    });
    EXPECT_EQ(pairs, 1);
    sim.step();
    EXPECT_EQ(sim.events().size(), 0u) << "without a contact space";
}

// ---- breaks ----

TEST(Events, list_joints_that_break_with_their_impulse)
{
    for (const dStepper way : kWays) {
        EventWorld sim(way);
        const double mass = 2;
        const dBodyID ball = sim.ball({1, 2, 3}, 0.1, mass);
        const dJointID strong = dJointCreateFixed(sim.world, nullptr),
                       weak = dJointCreateBall(sim.world, nullptr);
        dJointAttach(strong, sim.ball({9, 0, 0}), nullptr);
        dJointSetFixed(strong);
        dJointAttach(weak, ball, nullptr);
        dJointSetBallAnchor(weak, 1, 2, 3);
        dJointSetBreakLimits(weak, real(mass * kG * 0.9), 0);
        sim.step();
        const auto events = sim.events();
        ASSERT_EQ(events.size(), 1u);
        EXPECT_EQ(events[0].kind, dEventJointBreak);
        EXPECT_EQ(events[0].joint, weak);
        EXPECT_EQ(events[0].g1, nullptr);
        EXPECT_NEAR(events[0].impulse, mass * kG * kH, 1e-3);
        EXPECT_NEAR(events[0].normal[2], 1, 1e-3);
        EXPECT_NEAR(events[0].pos[0], 1, 1e-3);
        sim.step();
        EXPECT_EQ(sim.events().size(), 0u);
        dJointEnable(weak);
        dBodyDisable(ball);
        sim.step();
        EXPECT_EQ(sim.events().size(), 0u) << "of the load that broke it before";
    }
}

// ---- order, threads, states ----

// A rain of balls and boxes through two gates, with a breakable chain.
class Rain {
  public:
    explicit Rain(int threads, bool events = true, int strangers = 0) : sim_(dStepperHybrid, kAllKinds)
    {
        if (!events) dWorldSetEventSettings(sim_.world, nullptr);
        dWorldSetStepThreads(sim_.world, threads);
        dWorldSetAutoDisableFlag(sim_.world, 1);
        std::vector<dGeomID> guests;  // take slots and go again
        for (int i = 0; i < strangers; ++i) guests.push_back(dCreateSphere(sim_.space, 1));
        own(sim_.ground());
        own(sim_.gate({0, 0, 1}, {30, 30, 0.2}));
        if (strangers > 0) dGeomDestroy(guests.back()), guests.pop_back();
        own(sim_.gate({0, 0, 0.2}, {2, 2, 2}));
        Random random(7);
        for (int i = 0; i < 120; ++i) {
            const V3 p = random.point(3);
            const V3 at{p.x, p.y, 3 + 0.05 * i};
            bodies.push_back(i % 2 ? sim_.ball(at, 0.2) : sim_.box(at, 0.4));
            own(geom_of(bodies.back()));
        }
        for (int i = 0; i + 1 < 10; ++i) {
            const dJointID joint = dJointCreateBall(sim_.world, nullptr);
            dJointAttach(joint, bodies[std::size_t(i)], bodies[std::size_t(i) + 1]);
            dJointSetBreakLimits(joint, 30, 0);
        }
        for (const dGeomID guest : guests) dGeomDestroy(guest);
    }
    // Kind, places of the objects, and all numbers.
    std::vector<double> next()
    {
        sim_.step();
        return listed();
    }
    std::vector<double> listed()
    {
        std::vector<double> out;
        for (const dEvent& e : sim_.events()) {
            out.insert(out.end(), {double(e.kind), number(e.g1), number(e.g2), e.approach_speed, e.impulse});
            for (int k = 0; k < 3; ++k) out.push_back(e.pos[k]), out.push_back(e.normal[k]);
        }
        return out;
    }
    std::vector<double> positions() const
    {
        std::vector<double> out;
        for (const dBodyID b : bodies) out.insert(out.end(), dBodyGetPosition(b), dBodyGetPosition(b) + 3);
        return out;
    }
    dWorldID world() const { return sim_.world; }

    std::vector<dBodyID> bodies;

  private:
    void own(dGeomID geom)
    {
        const double place = double(numbers_.size());
        numbers_[geom] = place;
    }
    double number(dGeomID geom) { return geom ? numbers_.at(geom) : -1; }

    EventWorld sim_;
    std::map<dGeomID, double> numbers_;
};

TEST(Events, are_the_same_in_the_same_order_on_any_number_of_threads)
{
    std::vector<std::vector<double>> alone;
    Rain first(1);
    std::size_t all = 0;
    for (int i = 0; i < 150; ++i) alone.push_back(first.next()), all += alone.back().size();
    EXPECT_GT(all, 10000u);
    for (const int threads : {2, 3, 5, 8}) {
        Rain rain(threads);
        for (int i = 0; i < 150; ++i) ASSERT_EQ(rain.next(), alone[std::size_t(i)]) << threads << ' ' << i;
    }
}

TEST(Events, change_nothing_of_the_simulation)
{
    Rain with(1), without(1, false);
    for (int i = 0; i < 150; ++i) (void)with.next(), (void)without.next();
    EXPECT_EQ(with.positions(), without.positions());
}

TEST(Events, go_on_after_a_state_as_they_would_have)
{
    Rain rain(1);
    for (int i = 0; i < 60; ++i) (void)rain.next();
    std::vector<char> state(dWorldGetStateSize(rain.world()));
    ASSERT_EQ(dWorldGetState(rain.world(), state.data(), state.size()), 1);
    std::vector<std::vector<double>> expected;
    for (int i = 0; i < 40; ++i) expected.push_back(rain.next());
    ASSERT_EQ(dWorldSetState(rain.world(), state.data(), state.size()), 1);
    EXPECT_EQ(dWorldGetEvents(rain.world(), nullptr, 0), 0);
    for (int i = 0; i < 40; ++i) ASSERT_EQ(rain.next(), expected[std::size_t(i)]) << i;
}

// A body that the program has destroyed since touches and is in the gate again.
TEST(Events, come_again_after_a_roll_back)
{
    Rain rain(1);
    ASSERT_EQ(dWorldSetHistory(rain.world(), 50), 1);
    for (int i = 0; i < 60; ++i) (void)rain.next();
    std::vector<std::vector<double>> expected;
    for (int i = 0; i < 30; ++i) expected.push_back(rain.next());
    const dBodyID gone = rain.bodies.back();
    const dGeomID geom = geom_of(gone);
    dGeomDestroy(geom);
    dBodyDestroy(gone);
    for (int i = 0; i < 5; ++i) (void)rain.next();
    ASSERT_EQ(dWorldRollBack(rain.world(), 35), 1);
    EXPECT_EQ(geom_of(gone), geom);
    EXPECT_EQ(dWorldGetEvents(rain.world(), nullptr, 0), 0);
    for (int i = 0; i < 30; ++i) ASSERT_EQ(rain.next(), expected[std::size_t(i)]) << i;
}

TEST(Events, of_worlds_stepped_together_are_those_of_each_alone)
{
    Rain alone(1), a(1), b(1, true, 3);
    const dWorldID worlds[] = {a.world(), b.world()};
    int events = 0;
    for (int i = 0; i < 80; ++i) {
        const auto expected = alone.next();
        ASSERT_EQ(dWorldsStep(worlds, 2, real(kH), dStepperHybrid, 1, 1, 2, nullptr), 2);
        ASSERT_EQ(a.listed(), expected) << i;
        ASSERT_EQ(b.listed(), expected) << i;
        events += int(expected.size());
    }
    EXPECT_GT(events, 1000);
}

TEST(Events, are_in_the_order_of_kinds_and_of_creation)
{
    EventWorld sim(dStepperSubsteps, kAllKinds);
    const dGeomID guest = dCreateSphere(sim.space, 1);
    dGeomSetPosition(guest, 100, 0, 0);
    sim.ground();
    std::vector<dGeomID> made;
    for (int i = 0; i < 6; ++i) made.push_back(geom_of(sim.box({3.0 * i, 0, 0.5})));
    dGeomDestroy(guest);
    dSpaceRemove(sim.space, made[0]), dSpaceAdd(sim.space, made[0]);  // the last to join, the first made
    sim.step();
    const auto events = sim.events();
    ASSERT_EQ(events.size(), 6u);
    for (std::size_t i = 0; i < 6; ++i) EXPECT_EQ(events[i].g1, made[i]);
}

TEST(Events, refuse_bad_settings)
{
    EventWorld sim;
    const auto refused = [&](const std::function<void(dEventSettings&)>& change, const char* word) {
        dEventSettings s = sim.settings();
        change(s);
        Messages messages;
        EXPECT_EQ(dWorldSetEventSettings(sim.world, &s), 0);
        EXPECT_EQ(messages.count(), 1);
        EXPECT_NE(messages.last().find(word), std::string::npos) << messages.last();
    };
    refused([](dEventSettings& s) { s.kinds = 64; }, "kinds");
    refused([](dEventSettings& s) { s.capacity = 0; }, "capacity");
    refused([](dEventSettings& s) { s.capacity = 2000000; }, "capacity");
    refused([](dEventSettings& s) { s.min_impulse = -1; }, "min_impulse");
    refused([](dEventSettings& s) { s.min_approach_speed = dInfinity; }, "min_approach_speed");
    refused([](dEventSettings& s) { s.struct_size = 4; }, "struct_size");
    Messages messages;
    dGeomSetSensor(dGeomID(sim.space), 1);
    dGeomSetSensor(sim.ground(), 2);
    dGeomSetSensor(nullptr, 1);
    EXPECT_EQ(messages.count(), 3);
}

}  // namespace
}  // namespace epode::physics
