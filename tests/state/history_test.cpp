// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds that take steps back (dWorldRollBack), with bodies, geoms and joints created and destroyed in
// between. EPODE_HISTORY_OPERATIONS in the environment: how many operations in place of 100,000.
#include <cmath>
#include <cstdlib>
#include <deque>
#include <string>

#include "../effort.h"
#include "scene.h"

namespace epode::states {
namespace {

constexpr dReal kH = dReal(1) / 60;

std::vector<unsigned char> state_of(dWorldID world)
{
    Bytes bytes(dWorldGetStateSize(world));
    EXPECT_EQ(dWorldGetState(world, bytes.data(), bytes.size()), 1) << Messages::last();
    return bytes;
}

class History : public testing::Test {
  protected:
    History() { dWorldSetGravity(world, 0, 0, dReal(-9.81)), dWorldSetContactSpace(world, space); }
    ~History() override { dWorldDestroy(world), dSpaceDestroy(space); }
    void steps(int n)
    {
        for (int i = 0; i < n; ++i) dWorldStep(world, kH);
    }
    dBodyID add_ball(dReal x, dReal z)
    {
        const dBodyID body = dBodyCreate(world);
        dGeomSetBody(dCreateSphere(space, dReal(0.5)), body);
        dBodySetPosition(body, x, 0, z);
        return body;
    }
    Messages messages;
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
};

// Two wheels on axles that a coupling makes turn alike, one of them set in motion.
class CoupledHistory : public History {
  protected:
    CoupledHistory()
    {
        for (int i = 0; i < 2; ++i) {
            const dBodyID wheel = dBodyCreate(world);
            dBodySetPosition(wheel, 3 * i, 0, 5);
            axle[i] = dJointCreateHinge(world, nullptr);
            dJointAttach(axle[i], wheel, nullptr);
            dJointSetHingeAnchor(axle[i], 3 * i, 0, 5), dJointSetHingeAxis(axle[i], 0, 1, 0);
        }
        dBodySetAngularVel(dJointGetBody(axle[0], 0), 0, 4, 0);
        dJointSetCouplingAxis(coupling, 0, axle[0], 0, 1);
        dJointSetCouplingAxis(coupling, 1, axle[1], 0, -1);
        dWorldSetHistory(world, 20);
    }
    dReal error() const { return dJointGetHingeAngle(axle[0]) - dJointGetHingeAngle(axle[1]); }
    dJointID axle[2], coupling = dJointCreateCoupling(world, nullptr);
};

TEST_F(CoupledHistory, goes_on_with_the_same_bits_while_the_structure_stands)
{
    steps(10);
    const Bytes middle = state_of(world);
    steps(10);
    const Bytes end = state_of(world);
    EXPECT_GT(std::abs(dJointGetHingeAngle(axle[0])), dReal(0.1));
    EXPECT_NEAR(error(), 0, sizeof(dReal) == 8 ? 1e-9 : 1e-5);
    ASSERT_EQ(dWorldRollBack(world, 10), 1) << Messages::last();
    EXPECT_EQ(difference(state_of(world), middle), "");
    steps(10);
    EXPECT_EQ(difference(state_of(world), end), "");
}

TEST_F(CoupledHistory, refuses_to_take_back_what_has_been_created_or_destroyed)
{
    steps(5);
    const dBodyID more = add_ball(9, 9);
    steps(2);
    const Bytes now = state_of(world);
    EXPECT_EQ(dWorldRollBack(world, 4), 0);
    EXPECT_NE(std::string(Messages::last()).find("couplings"), std::string::npos) << Messages::last();
    EXPECT_EQ(difference(state_of(world), now), "");
    EXPECT_EQ(dWorldRollBack(world, 1), 1) << Messages::last();
    dBodyDestroy(more), dJointDestroy(coupling);
    EXPECT_EQ(dWorldRollBack(world, 0), 0);  // the coupling stays lost
    steps(2);
    EXPECT_EQ(dWorldRollBack(world, 1), 1) << Messages::last();
}

TEST_F(History, takes_steps_back_and_goes_on_with_the_same_bits)
{
    dCreatePlane(space, 0, 0, 1, 0);
    add_ball(0, 1), add_ball(dReal(0.2), dReal(2.1));
    ASSERT_EQ(dWorldSetHistory(world, 10), 1);
    EXPECT_EQ(dWorldGetHistory(world), 10);
    EXPECT_EQ(dWorldGetHistoryFrames(world), 0);
    steps(40);
    EXPECT_EQ(dWorldGetHistoryFrames(world), 10);
    EXPECT_GT(dWorldGetHistorySize(world), 1000u);
    const Bytes middle = state_of(world);
    steps(7);
    const Bytes end = state_of(world);
    ASSERT_EQ(dWorldRollBack(world, 7), 1) << Messages::last();
    EXPECT_EQ(difference(state_of(world), middle), "");
    EXPECT_EQ(dWorldGetHistoryFrames(world), 3);
    steps(7);
    EXPECT_EQ(difference(state_of(world), end), "");
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

TEST_F(History, zero_steps_take_back_what_the_program_has_done_since_the_last)
{
    const dBodyID ball = add_ball(0, 3);
    dWorldSetHistory(world, 3);
    steps(1);
    const Bytes before = state_of(world);
    dBodySetLinearVel(ball, 5, 0, 0), dBodyAddForce(ball, 1, 2, 3);
    ASSERT_EQ(dWorldRollBack(world, 0), 1);
    EXPECT_EQ(difference(state_of(world), before), "");
}

TEST_F(History, brings_destroyed_objects_back_under_their_handles)
{
    dCreatePlane(space, 0, 0, 1, 0);
    const dBodyID ball = add_ball(0, 2), other = add_ball(2, 2);
    const dGeomID geom = dBodyGetFirstGeom(ball);
    const dJointID hinge = dJointCreateHinge(world, nullptr);
    int tag = 0;
    dBodySetData(ball, &tag), dGeomSetData(geom, &tag);
    dGeomSetOffsetPosition(geom, 0, 0, dReal(0.1));
    dJointAttach(hinge, ball, other), dJointSetHingeAnchor(hinge, 1, 0, 2),
        dJointSetHingeAxis(hinge, 0, 1, 0);
    dWorldSetHistory(world, 20);
    steps(5);
    const Bytes before = state_of(world);
    steps(5);
    const Bytes after = state_of(world);
    dJointDestroy(hinge), dBodyDestroy(ball), dGeomDestroy(geom);
    const int refused = Messages::count();
    EXPECT_EQ(dBodyGetPosition(ball), nullptr);
    EXPECT_EQ(dGeomGetBody(geom), nullptr);
    EXPECT_EQ(dJointGetBody(hinge, 0), nullptr);
    EXPECT_EQ(Messages::count(), refused + 3);
    steps(3);
    ASSERT_EQ(dWorldRollBack(world, 8), 1) << Messages::last();
    EXPECT_EQ(difference(state_of(world), before), "");
    EXPECT_EQ(dBodyGetData(ball), &tag);
    EXPECT_EQ(dGeomGetData(geom), &tag);
    EXPECT_EQ(dGeomGetBody(geom), ball);
    EXPECT_EQ(dGeomGetOffsetPosition(geom)[2], dReal(0.1));
    EXPECT_EQ(dJointGetBody(hinge, 1), other);
    steps(5);
    EXPECT_EQ(difference(state_of(world), after), "");
}

TEST_F(History, removes_what_has_been_created_since)
{
    dWorldSetHistory(world, 4);
    add_ball(0, 1);
    steps(1);
    const Bytes before = state_of(world);
    const dBodyID late = add_ball(3, 3);
    const dGeomID geom = dBodyGetFirstGeom(late);
    const dJointGroupID group = dJointGroupCreate(0);
    const dJointID joint = dJointCreateBall(world, nullptr), grouped = dJointCreateBall(world, group);
    dJointAttach(joint, late, nullptr), dJointAttach(grouped, late, nullptr);
    steps(2);
    ASSERT_EQ(dWorldRollBack(world, 2), 1) << Messages::last();
    EXPECT_EQ(difference(state_of(world), before), "");
    EXPECT_EQ(dSpaceGetNumGeoms(space), 1);
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
    EXPECT_EQ(dBodyGetPosition(late), nullptr);
    EXPECT_EQ(dGeomGetSpace(geom), nullptr);
    EXPECT_EQ(dJointGetType(joint), dJointTypeNone);
    dJointGroupDestroy(group);
    steps(3);
}

TEST_F(History, brings_masses_and_reattached_joints_back)
{
    const dBodyID a = add_ball(0, 2), b = add_ball(2, 2), c = add_ball(4, 2);
    const dJointID joint = dJointCreateBall(world, nullptr);
    dJointAttach(joint, a, b), dJointSetBallAnchor(joint, dReal(0.7), 0, 2);
    dWorldSetHistory(world, 5);
    steps(1);
    const Bytes before = state_of(world);
    steps(3);
    const Bytes after = state_of(world);
    dMass heavy;
    dMassSetSphere(&heavy, 10, 1), dBodySetMass(a, &heavy);
    dJointAttach(joint, b, c), dJointSetBallAnchor(joint, 9, 9, 9);
    steps(1);
    ASSERT_EQ(dWorldRollBack(world, 4), 1) << Messages::last();
    EXPECT_EQ(difference(state_of(world), before), "");
    steps(3);
    EXPECT_EQ(difference(state_of(world), after), "");
}

TEST_F(History, objects_leave_it_with_their_last_frame)
{
    dWorldSetHistory(world, 3);
    steps(1);
    const dBodyID ball = add_ball(0, 1);
    steps(1);
    dBodyDestroy(ball);
    steps(3);
    ASSERT_EQ(dWorldRollBack(world, 3), 1);
    EXPECT_NE(dBodyGetPosition(ball), nullptr);
    dBodyDestroy(ball);
    steps(4);
    ASSERT_EQ(dWorldRollBack(world, 3), 1);
    EXPECT_EQ(dBodyGetPosition(ball), nullptr);
}

TEST_F(History, names_what_cannot_come_back_and_changes_nothing)
{
    const dGeomID box = dCreateBox(space, 1, 1, 1);
    dWorldSetHistory(world, 5);
    add_ball(0, 1);
    steps(2);
    dGeomBoxSetLengths(box, 2, 2, 2);
    steps(1);
    const Bytes before = state_of(world);
    EXPECT_EQ(dWorldRollBack(world, 1), 0);
    EXPECT_NE(Messages::last().find("another shape"), std::string::npos) << Messages::last();
    EXPECT_EQ(difference(state_of(world), before), "");
    const dSpaceID inner = dSimpleSpaceCreate(space);
    steps(1);
    dSpaceDestroy(inner);
    EXPECT_EQ(dWorldRollBack(world, 0), 0);
    EXPECT_NE(Messages::last().find("destroyed"), std::string::npos) << Messages::last();
    EXPECT_EQ(dWorldRollBack(world, 6), 0);
    EXPECT_NE(Messages::last().find("cannot take back 6 steps"), std::string::npos) << Messages::last();
    EXPECT_EQ(dWorldSetHistory(world, -1), 0);
    EXPECT_EQ(dWorldSetHistory(world, 0), 1);
    EXPECT_EQ(dWorldRollBack(world, 0), 0);
    EXPECT_NE(Messages::last().find("no history"), std::string::npos) << Messages::last();
}

TEST_F(History, names_the_class_of_a_geom_that_was_removed_with_its_space)
{
    const dSpaceID inside = dSimpleSpaceCreate(nullptr);
    const dBodyID body = dBodyCreate(world);
    dGeomSetBody(dCreateCylinder(inside, 1, 2), body);
    dWorldSetHistory(world, 3);
    steps(1);
    dSpaceDestroy(inside);
    EXPECT_EQ(dWorldRollBack(world, 1), 0);
    const std::string cylinder = "a geom of class " + std::to_string(dCylinderClass) + " has been destroyed";
    EXPECT_NE(Messages::last().find(cylinder), std::string::npos) << Messages::last();
}

TEST_F(History, outlived_by_spaces_and_worlds_in_any_order)
{
    const dSpaceID inside = dSimpleSpaceCreate(nullptr);
    const dWorldID second = dWorldCreate();
    dWorldSetHistory(second, 3);
    const dBodyID body = dBodyCreate(second);
    const dGeomID geom = dCreateSphere(inside, 1);
    dGeomSetBody(geom, body);
    dWorldStep(second, kH);
    dBodyDestroy(body), dGeomDestroy(geom);
    dSpaceDestroy(inside);
    dWorldStep(second, kH);
    EXPECT_EQ(dWorldRollBack(second, 1), 0);
    EXPECT_NE(Messages::last().find("space"), std::string::npos);
    dWorldDestroy(second);
}

// ---- random programs ----

struct Operation {
    unsigned kind, a, b;
    dReal x, y;
};

using Random = std::mt19937;

Operation draw(Random& random)
{
    const auto small = [&] { return dReal(int(random() % 9) - 4) / 2; };
    const unsigned kind = random() % 24, a = random(), b = random();
    const dReal x = small(), y = small();
    return {kind, a, b, x, y};
}

struct Objects {
    std::vector<dBodyID> bodies;
    std::vector<dGeomID> loose;  // geoms without a body
    std::vector<dJointID> joints, grouped;
};

void near(void* data, dGeomID a, dGeomID b);

class Player {
  public:
    Player(Stepper stepper, bool world_contacts) : stepper_(stepper), world_contacts_(world_contacts)
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetAutoDisableFlag(world, 1);
        if (world_contacts) dWorldSetContactSpace(world, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        for (int i = 0; i < 6; ++i) create({0, unsigned(i), 0, dReal(i % 3), dReal(i / 3)});
    }
    ~Player()
    {
        dJointGroupDestroy(group_), dJointGroupDestroy(contacts_);
        dWorldDestroy(world);
        dSpaceDestroy(space_);
    }
    Player(const Player&) = delete;
    Player& operator=(const Player&) = delete;

    // True: it was a step.
    bool apply(const Operation& o)
    {
        switch (o.kind) {
            case 0:
                if (has.bodies.size() < 14) create(o);
                return false;
            case 1:
                return destroy_body(o), false;
            case 2:
                return join(o), false;
            case 3:
                return part(o), false;
            case 4:
                if (o.b % 4 == 0) dJointGroupEmpty(group_), has.grouped.clear();
                return false;
            case 5:
                return change_geom(o), false;
            case 6:
                return change_mass(o), false;
            case 7:
            case 8:
            case 9:
                return push(o), false;
            case 10:
                if (!has.loose.empty()) dGeomDestroy(taken(has.loose, o.a));
                return false;
            case 11:
                return move_geom(o), false;
            default:
                return step(), true;
        }
    }
    void touch(dGeomID a, dGeomID b)
    {
        const dBodyID body1 = dGeomGetBody(a), body2 = dGeomGetBody(b);
        if (!body1 && !body2) return;
        dContact contact[3];
        const int count = dCollide(a, b, 3, &contact[0].geom, sizeof contact[0]);
        for (int i = 0; i < count; ++i) {
            contact[i].surface.mode = dContactApprox1, contact[i].surface.mu = 1;
            dJointAttach(dJointCreateContact(world, contacts_, &contact[i]), body1, body2);
        }
    }

    Objects has;
    const dWorldID world = dWorldCreate();

  private:
    template <typename Id>
    static Id taken(std::vector<Id>& from, unsigned i)
    {
        const auto at = from.begin() + long(i % from.size());
        const Id id = *at;
        from.erase(at);
        return id;
    }
    void create(const Operation& o)
    {
        const dBodyID body = dBodyCreate(world);
        const dGeomID geom = o.a % 3 ? dCreateBox(space_, dReal(0.5), dReal(0.5), dReal(0.4))
                                     : dCreateSphere(space_, dReal(0.3));
        dGeomSetBody(geom, body);
        dBodySetPosition(body, o.x, o.y, dReal(1) + dReal(o.a % 5) / 2);
        if (o.b % 4 == 0) dGeomSetOffsetPosition(geom, 0, dReal(0.05), 0);
        has.bodies.push_back(body);
    }
    void destroy_body(const Operation& o)
    {
        if (has.bodies.size() < 3) return;
        const dBodyID body = taken(has.bodies, o.a);
        const dGeomID geom = dBodyGetFirstGeom(body);
        for (const int end : {0, 1})
            if (int(o.b % 2) == end)
                dBodyDestroy(body);
            else if (geom && o.b % 3)
                dGeomDestroy(geom);
        if (geom && o.b % 3 == 0) has.loose.push_back(geom);
    }
    void join(const Operation& o)
    {
        if (has.joints.size() + has.grouped.size() > 6) return;
        const dBodyID a = has.bodies[o.a % has.bodies.size()], b = has.bodies[o.b % has.bodies.size()];
        if (a == b) return;
        const bool grouped = o.b % 2;
        const dJointGroupID group = grouped ? group_ : nullptr;
        const dJointID joint = o.a % 2 ? dJointCreateHinge(world, group) : dJointCreateBall(world, group);
        dJointAttach(joint, a, o.b % 5 ? b : nullptr);
        if (o.a % 2)
            dJointSetHingeAnchor(joint, o.x, o.y, 1), dJointSetHingeAxis(joint, 0, 1, 0);
        else
            dJointSetBallAnchor(joint, o.x, o.y, 1);
        (grouped ? has.grouped : has.joints).push_back(joint);
    }
    void part(const Operation& o)
    {
        if (has.joints.empty()) return;
        if (o.b % 3) return dJointDestroy(taken(has.joints, o.a));
        const dBodyID a = has.bodies[o.a % has.bodies.size()];
        dJointAttach(has.joints[o.a % has.joints.size()], a, nullptr);
    }
    void change_geom(const Operation& o)
    {
        if (has.loose.empty() || !world_contacts_) return;  // the program's own geoms are where it puts them
        const dBodyID body = has.bodies[o.b % has.bodies.size()];
        dGeomSetBody(taken(has.loose, o.a), body);
    }
    void change_mass(const Operation& o)
    {
        dMass mass;
        dMassSetSphere(&mass, 1 + dReal(o.a % 3), dReal(0.4));
        dBodySetMass(has.bodies[o.b % has.bodies.size()], &mass);
    }
    void push(const Operation& o)
    {
        const dBodyID body = has.bodies[o.a % has.bodies.size()];
        if (o.b % 3 == 0) return dBodyEnable(body), dBodySetLinearVel(body, o.x, o.y, 1);
        if (o.b % 3 == 1) return dBodyAddForce(body, 20 * o.x, 20 * o.y, 5);
        dBodySetAngularVel(body, o.x, o.y, 1);
    }
    void move_geom(const Operation& o)
    {
        if (world_contacts_ && !has.loose.empty())
            dGeomSetPosition(has.loose[o.a % has.loose.size()], o.x, o.y, 0);
    }
    void step()
    {
        if (!world_contacts_) dSpaceCollide(space_, this, near);
        step_with(stepper_, world, kH, 3);
        dJointGroupEmpty(contacts_);
    }

    const Stepper stepper_;
    const bool world_contacts_;
    const dSpaceID space_ = dHashSpaceCreate(nullptr);
    const dJointGroupID group_ = dJointGroupCreate(0), contacts_ = dJointGroupCreate(0);
};

void near(void* data, dGeomID a, dGeomID b) { static_cast<Player*>(data)->touch(a, b); }

int operations()
{
    const char* wanted = std::getenv("EPODE_HISTORY_OPERATIONS");
    return (wanted ? std::atoi(wanted) : tests::effort(100000)) / 8;
}

class Players : public testing::TestWithParam<int> {};

// What the program knows after each step, and has done since.
struct Past {
    Objects has;
    std::vector<Operation> done;
    Bytes state;
};

TEST_P(Players, stay_alike_although_one_takes_steps_back)
{
    const Messages messages;
    const Stepper stepper = kSteppers[std::size_t(GetParam()) % 4];
    Player one(stepper, GetParam() < 4), twin(stepper, GetParam() < 4);
    constexpr int kFrames = 12;
    ASSERT_EQ(dWorldSetHistory(one.world, kFrames), 1);
    Random random(unsigned(29 + GetParam()));
    std::deque<Past> past{{one.has, {}, state_of(one.world)}};
    for (int i = 0, count = operations(); i < count; ++i) {
        const Operation o = draw(random);
        const auto play = [&](const Operation& now) {
            past.back().done.push_back(now);
            if (one.apply(now)) past.push_back({one.has, {}, state_of(one.world)});
            if (past.size() > kFrames + 1) past.pop_front();
        };
        play(o), twin.apply(o);
        if (random() % 16 == 0) {
            ASSERT_EQ(dWorldGetHistoryFrames(one.world), int(past.size()) - 1);
            const std::size_t back = random() % past.size();
            ASSERT_EQ(dWorldRollBack(one.world, int(back)), 1)
                << "operation " << i << ": " << Messages::last();
            ASSERT_EQ(difference(state_of(one.world), past[past.size() - 1 - back].state), "")
                << "operation " << i << ", back by " << back;
            std::vector<Operation> again;
            for (std::size_t k = past.size() - 1 - back; k < past.size(); ++k)
                again.insert(again.end(), past[k].done.begin(), past[k].done.end());
            past.resize(past.size() - back);
            one.has = past.back().has, past.back().done.clear();
            for (const Operation& now : again) play(now);
            ASSERT_EQ(difference(state_of(one.world), state_of(twin.world)), "") << "after operation " << i;
        }
    }
    EXPECT_EQ(difference(state_of(one.world), state_of(twin.world)), "");
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

INSTANTIATE_TEST_SUITE_P(Settings, Players, testing::Range(0, 8));

}  // namespace
}  // namespace epode::states
