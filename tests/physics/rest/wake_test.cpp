// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// In a world that manages its contacts what sleeps wakes when something happens to what it rests on, hangs from
// or is driven by, and nothing else wakes. Each disturbance is tried where most of the world sleeps and where
// it does not, because steps look at the pairs in different ways. With contact joints, and with ODE's
// behaviour, nothing of this may happen: the program wakes what it wants awake.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "ode/ext.h"
#include "ode/ode.h"

namespace {

enum class WakeStepper { kExact, kQuick, kSmall, kHybrid };
enum class Support { kStatic, kKinematic };
enum class Others { kAsleep, kAwake };
constexpr dReal kWakeStep = dReal(1) / 60;

// Two boxes on a table, a box on the ground and one that hangs in the air by a joint, all asleep.
class Table {
  public:
    explicit Table(Support support = Support::kStatic, Others others = Others::kAsleep) : others_(others)
    {
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world, space);
        dWorldSetAutoDisableFlag(world, 1);
        dCreatePlane(space, 0, 0, 1, 0);
        table = dCreateBox(space, 3, 3, dReal(0.4));
        if (support == Support::kKinematic) {
            table_body = dBodyCreate(world);
            dBodySetKinematic(table_body);
            dGeomSetBody(table, table_body);
        }
        dGeomSetPosition(table, 0, 0, 3);
        lower = box(0, 0, dReal(3.7));
        upper = box(0, 0, dReal(4.7));
        far = box(20, 0, dReal(0.5));
        hanging = box(-20, 0, 5);
        hinge = dJointCreateHinge(world, nullptr);
        dJointAttach(hinge, hanging, nullptr);
        dJointSetHingeAnchor(hinge, -20, 0, 5);
        dJointSetHingeAxis(hinge, 1, 0, 0);
        if (others == Others::kAwake) add_spinner();
    }
    Table(const Table&) = delete;
    Table& operator=(const Table&) = delete;
    ~Table()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }

    dBodyID box(dReal x, dReal y, dReal z)
    {
        const dBodyID body = dBodyCreate(world);
        dMass mass;
        dMassSetBox(&mass, 500, 1, 1, 1);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, y, z);
        dGeomSetBody(dCreateBox(space, 1, 1, 1), body);
        return body;
    }

    void step(WakeStepper stepper, int count = 1) const
    {
        for (int i = 0; i < count; ++i) switch (stepper) {
                case WakeStepper::kExact:
                    dWorldStep(world, kWakeStep);
                    break;
                case WakeStepper::kQuick:
                    dWorldQuickStep(world, kWakeStep);
                    break;
                case WakeStepper::kSmall:
                    dWorldStepFast1(world, kWakeStep, 5);
                    break;
                case WakeStepper::kHybrid:
                    dWorldStepHybrid(world, kWakeStep);
                    break;
            }
    }

    bool sleeps() const
    {
        for (const dBodyID body : {lower, upper, far, hanging})
            if (dBodyIsEnabled(body)) return false;
        return !table_body || !dBodyIsEnabled(table_body);
    }

    void put_to_sleep(WakeStepper stepper)
    {
        for (int i = 0; i < 600 && !sleeps(); ++i) step(stepper);
        ASSERT_TRUE(sleeps());
        // A geom that has not been looked at since it moved would let the next step find everything by itself.
        step(stepper, others_ == Others::kAwake ? 7 : 2);
        ASSERT_TRUE(sleeps());
    }

    dWorldID world;
    dSpaceID space;
    dGeomID table;
    dBodyID table_body = nullptr;
    dBodyID lower, upper, far, hanging;
    dJointID hinge;

  private:
    // It never sleeps, and is more than one of sixteen.
    void add_spinner()
    {
        const dBodyID body = box(40, 0, 10);
        dBodySetGravityMode(body, 0);
        dBodySetAngularVel(body, 0, 0, 3);
        dBodySetAutoDisableFlag(body, 0);
    }

    Others others_;
};

dReal height_of(dBodyID body) { return dBodyGetPosition(body)[2]; }

struct Disturbance {
    const char* name;
    void (*act)(Table&);
    enum After { kFall, kWake, kRise, kRide, kMove } after;
};

void remake_material(Table& s, dReal friction, dReal belt)
{
    dMaterial m;
    dMaterialInit(&m, sizeof m);
    m.friction = friction, m.surface_velocity[0] = belt;
    dGeomSetMaterial(s.table, &m);
}

// Of the table, with a body or without.
const Disturbance kOfSupport[] = {
    {"destroyed", [](Table& s) { dGeomDestroy(s.table); }, Disturbance::kFall},
    {"taken_out", [](Table& s) { dSpaceRemove(s.space, s.table); }, Disturbance::kFall},
    {"taken_out_and_put_back_elsewhere",
     [](Table& s) {
         dSpaceRemove(s.space, s.table);
         dGeomSetPosition(s.table, 0, 50, 3);
         dSpaceAdd(s.space, s.table);
     },
     Disturbance::kFall},
    {"disabled", [](Table& s) { dGeomDisable(s.table); }, Disturbance::kFall},
    {"lowered", [](Table& s) { dGeomSetPosition(s.table, 0, 0, 2); }, Disturbance::kFall},
    {"moved_aside", [](Table& s) { dGeomSetPosition(s.table, 50, 0, 3); }, Disturbance::kFall},
    {"turned",
     [](Table& s) {
         dMatrix3 R;
         dRFromAxisAndAngle(R, 1, 0, 0, dReal(0.8));
         dGeomSetRotation(s.table, R);
     },
     Disturbance::kMove},
    {"made_thinner", [](Table& s) { dGeomBoxSetLengths(s.table, 3, 3, dReal(0.1)); }, Disturbance::kFall},
    {"without_category", [](Table& s) { dGeomSetCategoryBits(s.table, 0); }, Disturbance::kWake},
    {"without_bits",
     [](Table& s) {
         dGeomSetCategoryBits(s.table, 0);
         dGeomSetCollideBits(s.table, 0);
     },
     Disturbance::kFall},
    {"a_sensor", [](Table& s) { dGeomSetSensor(s.table, 1); }, Disturbance::kFall},
    {"slippery", [](Table& s) { remake_material(s, 0, 0); }, Disturbance::kWake},
    {"a_belt", [](Table& s) { remake_material(s, dReal(0.6), 1); }, Disturbance::kRide},
    {"gravity_up", [](Table& s) { dWorldSetGravity(s.world, 0, 0, 2); }, Disturbance::kRise},
};

const Disturbance kOfBody[] = {
    {"lift_down", [](Table& s) { dBodySetLinearVel(s.table_body, 0, 0, -1); }, Disturbance::kFall},
    {"lift_down_fast", [](Table& s) { dBodySetLinearVel(s.table_body, 0, 0, -20); }, Disturbance::kFall},
    {"lift_up", [](Table& s) { dBodySetLinearVel(s.table_body, 0, 0, 1); }, Disturbance::kRise},
    {"lift_by_states",
     [](Table& s) {
         const dReal up[3] = {0, 0, 1};
         dBodiesSetStates(&s.table_body, 1, dStateLinearVel, up, 3);
     },
     Disturbance::kRise},
    {"turntable", [](Table& s) { dBodySetAngularVel(s.table_body, 0, 0, 1); }, Disturbance::kWake},
    {"body_moved", [](Table& s) { dBodySetPosition(s.table_body, 0, 0, 1); }, Disturbance::kFall},
    {"body_freed", [](Table& s) { dBodySetDynamic(s.table_body); }, Disturbance::kFall},
};

struct WakeCase {
    WakeStepper stepper;
    Support support;
    Others others;
    const Disturbance* disturbance;
};

std::vector<WakeCase> wake_cases()
{
    std::vector<WakeCase> all;
    for (const WakeStepper stepper :
         {WakeStepper::kExact, WakeStepper::kQuick, WakeStepper::kSmall, WakeStepper::kHybrid})
        for (const Others others : {Others::kAsleep, Others::kAwake}) {
            for (const Support support : {Support::kStatic, Support::kKinematic})
                for (const Disturbance& d : kOfSupport) all.push_back({stepper, support, others, &d});
            for (const Disturbance& d : kOfBody) all.push_back({stepper, Support::kKinematic, others, &d});
        }
    return all;
}

std::string wake_name(const testing::TestParamInfo<WakeCase>& info)
{
    const WakeCase& c = info.param;
    const char* const steppers[] = {"exact", "quick", "small", "hybrid"};
    return std::string(steppers[int(c.stepper)]) + (c.support == Support::kStatic ? "_static_" : "_body_") +
           (c.others == Others::kAsleep ? "asleep_" : "awake_") + c.disturbance->name;
}

class Wake : public testing::TestWithParam<WakeCase> {};

TEST_P(Wake, what_rests_on_what_is_disturbed)
{
    const WakeCase& c = GetParam();
    Table s(c.support, c.others);
    s.put_to_sleep(c.stepper);
    if (HasFatalFailure()) return;
    const dReal low = height_of(s.lower), high = height_of(s.upper);
    c.disturbance->act(s);
    s.step(c.stepper);
    EXPECT_TRUE(dBodyIsEnabled(s.lower));
    EXPECT_TRUE(dBodyIsEnabled(s.upper));
    const bool everywhere = std::string(c.disturbance->name) == "gravity_up";
    EXPECT_EQ(dBodyIsEnabled(s.far), everywhere);
    EXPECT_EQ(dBodyIsEnabled(s.hanging), everywhere);
    s.step(c.stepper, 40);
    const dReal ride = dBodyGetPosition(s.lower)[0];
    switch (c.disturbance->after) {
        case Disturbance::kFall:
            EXPECT_LT(height_of(s.lower), low - dReal(0.05));
            EXPECT_LT(height_of(s.upper), high - dReal(0.05));
            break;
        case Disturbance::kRise:
            EXPECT_GT(height_of(s.lower), low + dReal(0.3));
            EXPECT_GT(height_of(s.upper), high + dReal(0.3));
            break;
        case Disturbance::kRide:
            EXPECT_GT(ride, dReal(0.4));
            break;
        case Disturbance::kMove:
            EXPECT_GT(std::fabs(height_of(s.lower) - low), dReal(0.02));
            EXPECT_GT(std::fabs(height_of(s.upper) - high), dReal(0.02));
            break;
        case Disturbance::kWake:
            EXPECT_NEAR(height_of(s.upper), high, dReal(0.01));
            break;
    }
}

INSTANTIATE_TEST_SUITE_P(All, Wake, testing::ValuesIn(wake_cases()), wake_name);

// What a program does every frame although it changes nothing, and what concerns a geom alone.
const struct {
    const char* name;
    void (*act)(Table&);
} kNothing[] = {
    {"same position", [](Table& s) { dGeomSetPosition(s.table, 0, 0, 3); }},
    {"same rotation",
     [](Table& s) {
         dMatrix3 R;
         dRSetIdentity(R);
         dGeomSetRotation(s.table, R);
     }},
    {"same bits",
     [](Table& s) {
         dGeomSetCategoryBits(s.table, dGeomGetCategoryBits(s.table));
         dGeomSetCollideBits(s.table, dGeomGetCollideBits(s.table));
     }},
    {"enabled again", [](Table& s) { dGeomEnable(s.table); }},
    {"same material",
     [](Table& s) {
         dMaterial m;
         dMaterialInit(&m, sizeof m);
         dGeomGetMaterial(s.table, &m);
         dGeomSetMaterial(s.table, &m);
     }},
    {"same gravity", [](Table& s) { dWorldSetGravity(s.world, 0, 0, dReal(-9.81)); }},
    {"data", [](Table& s) { dGeomSetData(s.table, &s); }},
    {"a new geom far away", [](Table& s) { dGeomSetPosition(dCreateSphere(s.space, 1), 0, 80, 0); }},
    {"a ray", [](Table& s) { dGeomRaySet(dCreateRay(s.space, 5), 0, 0, 10, 0, 0, -1); }},
    {"no velocity", [](Table& s) { dBodySetLinearVel(s.far, 0, 0, 0); }},
    {"same states",
     [](Table& s) {
         const dBodyID bodies[] = {s.lower, s.upper, s.far};
         constexpr unsigned kAll = dStatePosition | dStateQuaternion | dStateLinearVel | dStateAngularVel;
         dReal states[3 * 13];
         ASSERT_EQ(dBodiesGetStates(bodies, 3, kAll, states, 0), 1);
         ASSERT_EQ(dBodiesSetStates(bodies, 3, kAll, states, 0), 1);
     }},
};

TEST(WakeNot, what_nothing_happens_to)
{
    for (const WakeStepper stepper :
         {WakeStepper::kExact, WakeStepper::kQuick, WakeStepper::kSmall, WakeStepper::kHybrid})
        for (const Others others : {Others::kAsleep, Others::kAwake}) {
            Table s(Support::kStatic, others);
            s.put_to_sleep(stepper);
            for (const auto& nothing : kNothing) {
                nothing.act(s);
                s.step(stepper, 3);
                EXPECT_TRUE(s.sleeps())
                    << nothing.name << ", stepper " << int(stepper) << ", others " << int(others);
            }
        }
}

// A body that the program has moved stays as it is, but not what lay on it.
TEST(WakeNot, what_the_program_moves)
{
    for (const Others others : {Others::kAsleep, Others::kAwake})
        for (const bool in_bulk : {false, true}) {
            Table s(Support::kStatic, others);
            s.put_to_sleep(WakeStepper::kQuick);
            const dReal place[3] = {60, 0, 30};
            if (in_bulk) {
                ASSERT_EQ(dBodiesSetStates(&s.lower, 1, dStatePosition, place, 0), 1);
            } else {
                dBodySetPosition(s.lower, place[0], place[1], place[2]);
            }
            s.step(WakeStepper::kQuick, 40);
            EXPECT_FALSE(dBodyIsEnabled(s.lower));
            EXPECT_EQ(height_of(s.lower), 30);
            EXPECT_LT(height_of(s.upper), 4);
        }
}

// What never falls asleep by itself was disabled by the program.
TEST(WakeNot, what_the_program_has_disabled)
{
    Table s;
    for (const dBodyID body : {s.lower, s.upper, s.far, s.hanging}) dBodySetAutoDisableFlag(body, 0);
    s.step(WakeStepper::kQuick, 60);
    for (const dBodyID body : {s.lower, s.upper, s.far, s.hanging}) dBodyDisable(body);
    s.step(WakeStepper::kQuick, 2);
    dGeomDestroy(s.table);
    dWorldSetGravity(s.world, 0, 0, -5);
    s.step(WakeStepper::kQuick, 5);
    EXPECT_TRUE(s.sleeps());
}

// Asked to sleep after the disturbance, it sleeps; asked before, it had fallen asleep.
TEST(WakeNot, what_the_program_disables_afterwards)
{
    for (const Others others : {Others::kAsleep, Others::kAwake}) {
        Table s(Support::kStatic, others);
        s.put_to_sleep(WakeStepper::kQuick);
        dGeomDestroy(s.table);
        dBodyDisable(s.lower);
        s.step(WakeStepper::kQuick, 5);
        EXPECT_TRUE(s.sleeps());
        dBodyEnable(s.upper);
        s.step(WakeStepper::kQuick, 40);
        EXPECT_LT(height_of(s.lower), 3);
    }
}

TEST(WakeJoints, that_go_or_stop_acting)
{
    void (*const kActs[])(Table&) = {
        [](Table& s) { dJointDestroy(s.hinge); },
        [](Table& s) { dJointDisable(s.hinge); },
        [](Table& s) { dJointAttach(s.hinge, nullptr, nullptr); },
    };
    for (const WakeStepper stepper :
         {WakeStepper::kExact, WakeStepper::kQuick, WakeStepper::kSmall, WakeStepper::kHybrid})
        for (const auto& act : kActs) {
            Table s;
            s.put_to_sleep(stepper);
            act(s);
            s.step(stepper, 40);
            EXPECT_LT(height_of(s.hanging), 4);
            EXPECT_FALSE(dBodyIsEnabled(s.lower));
        }
}

// A motor that is given another speed, as a drive that is given another target; not one that keeps its own.
TEST(WakeJoints, whose_motors_change)
{
    for (const WakeStepper stepper :
         {WakeStepper::kExact, WakeStepper::kQuick, WakeStepper::kSmall, WakeStepper::kHybrid}) {
        Table s;
        dJointSetHingeParam(s.hinge, dParamFMax, 5000);
        s.put_to_sleep(stepper);
        dJointSetHingeParam(s.hinge, dParamVel, 0);
        dJointSetHingeParam(s.hinge, dParamFMax, 5000);
        s.step(stepper, 3);
        EXPECT_TRUE(s.sleeps());
        dJointSetHingeParam(s.hinge, dParamVel, 1);
        s.step(stepper, 60);
        EXPECT_NEAR(double(dJointGetHingeAngle(s.hinge)), 1, 0.03);
        EXPECT_FALSE(dBodyIsEnabled(s.lower));
    }
}

// A lift that goes up and down, sideways too, and waits until all on it sleep: nobody stays behind. (What an
// island had reached in its sleep fell asleep again in the air, for it had moved a few millimetres only: 10 of
// 18 boxes, on the fourth way down.)
TEST(WakeLift, takes_all_along)
{
    for (const WakeStepper stepper :
         {WakeStepper::kExact, WakeStepper::kQuick, WakeStepper::kSmall, WakeStepper::kHybrid}) {
        Table s(Support::kKinematic);
        dWorldUseDefaults(s.world, dDefaultsGame);
        dWorldSetGravity(s.world, 0, 0, dReal(-9.81));
        for (const dBodyID body : {s.lower, s.upper}) {
            dGeomDestroy(dBodyGetFirstGeom(body));
            dBodyDestroy(body);
        }
        dGeomBoxSetLengths(s.table, 4, 4, dReal(0.2));
        std::vector<dBodyID> boxes;
        for (int i = 0; i < 18; ++i) {
            const dBodyID body = dBodyCreate(s.world);
            dMass mass;
            dMassSetBoxTotal(&mass, 20, dReal(0.5), dReal(0.5), dReal(0.5));
            dBodySetMass(body, &mass);
            dGeomSetBody(dCreateBox(s.space, dReal(0.5), dReal(0.5), dReal(0.5)), body);
            dBodySetPosition(body, dReal(i % 3 - 1), dReal(i % 9 / 3 - 1), dReal(i < 9 ? 3.36 : 3.87));
            boxes.push_back(body);
        }
        for (int ride = 0; ride < 12; ++ride) {
            const dReal v = ride % 2 ? -1 : 1, aside = ride / 2 % 2 ? dReal(0.3) * v : 0;
            dBodySetLinearVel(s.table_body, aside, 0, v);
            s.step(stepper, 120);
            dBodySetLinearVel(s.table_body, 0, 0, 0);
            s.step(stepper, 360);
            for (const dBodyID box : boxes)
                EXPECT_LT(height_of(box) - height_of(s.table_body), dReal(0.9))
                    << int(stepper) << ' ' << ride;
        }
    }
}

// More is disturbed than a space remembers one by one.
TEST(WakeMany, wakes_what_many_supports_carry)
{
    constexpr int kCount = 700;
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);
    dWorldSetGravity(world, 0, 0, dReal(-9.81));
    dWorldSetContactSpace(world, space);
    dWorldSetAutoDisableFlag(world, 1);
    std::vector<dGeomID> tables;
    std::vector<dBodyID> balls;
    for (int i = 0; i < kCount; ++i) {
        tables.push_back(dCreateBox(space, 1, 1, 1));
        dGeomSetPosition(tables.back(), dReal(3 * i), 0, 0);
        balls.push_back(dBodyCreate(world));
        dGeomSetBody(dCreateBox(space, 1, 1, 1), balls.back());
        dBodySetPosition(balls.back(), dReal(3 * i), 0, 1);
    }
    for (int i = 0; i < 120; ++i) dWorldQuickStep(world, kWakeStep);
    for (const dBodyID ball : balls) ASSERT_FALSE(dBodyIsEnabled(ball));
    for (int i = 0; i < kCount; i += 2) dGeomDisable(tables[std::size_t(i)]);
    dWorldQuickStep(world, kWakeStep);
    for (int i = 0; i < kCount; ++i) EXPECT_EQ(dBodyIsEnabled(balls[std::size_t(i)]), i % 2 == 0) << i;
    dWorldDestroy(world);
    dSpaceDestroy(space);
}

// In a space of its own inside the world's: the whole space goes, or its members' rules.
TEST(WakeNested, supports_in_a_space_of_their_own)
{
    void (*const kActs[])(dSpaceID, dSpaceID, dGeomID) = {
        [](dSpaceID, dSpaceID, dGeomID table) { dGeomDestroy(table); },
        [](dSpaceID, dSpaceID inner, dGeomID) { dSpaceDestroy(inner); },
        [](dSpaceID outer, dSpaceID inner, dGeomID) { dSpaceRemove(outer, (dGeomID)inner); },
        [](dSpaceID, dSpaceID inner, dGeomID) { dGeomDisable((dGeomID)inner); },
        [](dSpaceID, dSpaceID, dGeomID table) { dGeomSetPosition(table, 0, 0, 1); },
    };
    for (const auto& act : kActs) {
        Table s;
        dGeomDestroy(s.table);
        const dSpaceID inner = dSimpleSpaceCreate(s.space);
        s.table = dCreateBox(inner, 3, 3, dReal(0.4));
        dGeomSetPosition(s.table, 0, 0, 3);
        s.put_to_sleep(WakeStepper::kQuick);
        act(s.space, inner, s.table);
        s.step(WakeStepper::kQuick, 40);
        EXPECT_LT(height_of(s.upper), 4);
        EXPECT_FALSE(dBodyIsEnabled(s.far));
    }
}

// A state taken between the disturbance and the step knows of it, even of what is gone.
TEST(WakeStates, of_what_has_just_been_disturbed)
{
    for (const auto& act : kOfSupport)
        for (const WakeStepper stepper : {WakeStepper::kExact, WakeStepper::kQuick}) {
            Table s;
            s.put_to_sleep(stepper);
            act.act(s);
            std::vector<char> state(dWorldGetStateSize(s.world));
            ASSERT_TRUE(dWorldGetState(s.world, state.data(), state.size())) << act.name;
            s.step(stepper, 20);
            const dReal z = height_of(s.upper), x = dBodyGetPosition(s.upper)[0];
            s.step(stepper, 100);
            ASSERT_TRUE(dWorldSetState(s.world, state.data(), state.size())) << act.name;
            ASSERT_EQ(dBodyIsEnabled(s.far), act.after == Disturbance::kRise) << act.name;
            s.step(stepper, 20);
            EXPECT_EQ(height_of(s.upper), z) << act.name;
            EXPECT_EQ(dBodyGetPosition(s.upper)[0], x) << act.name;
        }
}

// Where the program makes the contacts it wakes what it wants awake.
TEST(WakeNot, in_worlds_without_a_contact_space)
{
    Table s(Support::kKinematic);
    s.put_to_sleep(WakeStepper::kQuick);
    dWorldSetContactSpace(s.world, nullptr);
    dWorldSetGravity(s.world, 0, 0, -5);
    dBodySetLinearVel(s.table_body, 0, 0, -1);
    dJointSetHingeParam(s.hinge, dParamVel, 1);
    dJointDestroy(s.hinge);
    dGeomDestroy(s.table);
    s.step(WakeStepper::kQuick, 5);
    EXPECT_TRUE(s.sleeps());
}

// With ODE's behaviour a body hangs where it fell asleep.
TEST(WakeNot, in_worlds_that_act_as_ode)
{
    Table s;
    dWorldSetBehaviour(s.world, dBehaviour016);
    s.put_to_sleep(WakeStepper::kQuick);
    dGeomDestroy(s.table);
    dWorldSetGravity(s.world, 0, 0, -5);
    dJointDestroy(s.hinge);
    s.step(WakeStepper::kQuick, 5);
    EXPECT_TRUE(s.sleeps());
}

}  // namespace
