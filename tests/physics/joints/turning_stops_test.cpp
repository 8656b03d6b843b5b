// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Stops of angles where half a turn is near or passed, on every joint that has an angle with stops, about the z axis. An
// arm of 0.5 m at 5 rad/s: between stops at +-3.10 rad a step of 32 ms is longer (0.16 rad) than the gap (0.083 rad).
#include "../rig.h"

namespace epode::physics {
namespace {

using Make = dJointID (*)(dWorldID, dBodyID, dBodyID);
using Set = void (*)(dJointID, int, dReal);

// A joint whose axis number `axis` is z; its other axes are locked.
struct Kind {
    const char* name;
    int axis;
    Set set;
    Make make;

    void stops(dJointID joint, double low, double high) const
    {
        set(joint, dParamLoStop + axis * dParamGroup, real(low));
        set(joint, dParamHiStop + axis * dParamGroup, real(high));
    }
    void motor(dJointID joint, double speed, double torque) const
    {
        set(joint, dParamVel + axis * dParamGroup, real(speed));
        set(joint, dParamFMax + axis * dParamGroup, real(torque));
    }
};

void lock(Set set, dJointID joint, int axis)
{
    set(joint, dParamLoStop + axis * dParamGroup, 0), set(joint, dParamHiStop + axis * dParamGroup, 0);
}

dJointID hinge(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID j = dJointCreateHinge(world, nullptr);
    dJointAttach(j, a, b);
    dJointSetHingeAnchor(j, 0, 0, 0);
    dJointSetHingeAxis(j, 0, 0, 1);
    return j;
}

template <int kTurning>
dJointID universal(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID j = dJointCreateUniversal(world, nullptr);
    dJointAttach(j, a, b);
    dJointSetUniversalAnchor(j, 0, 0, 0);
    (kTurning == 0 ? dJointSetUniversalAxis1 : dJointSetUniversalAxis2)(j, 0, 0, 1);
    (kTurning == 0 ? dJointSetUniversalAxis2 : dJointSetUniversalAxis1)(j, 0, 1, 0);
    lock(dJointSetUniversalParam, j, 1 - kTurning);
    return j;
}

template <int kTurning>
dJointID pu(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID j = dJointCreatePU(world, nullptr);
    dJointAttach(j, a, b);
    dJointSetPUAnchor(j, 0, 0, 0);
    (kTurning == 0 ? dJointSetPUAxis1 : dJointSetPUAxis2)(j, 0, 0, 1);
    (kTurning == 0 ? dJointSetPUAxis2 : dJointSetPUAxis1)(j, 0, 1, 0);
    dJointSetPUAxis3(j, 1, 0, 0);
    lock(dJointSetPUParam, j, 1 - kTurning), lock(dJointSetPUParam, j, 2);
    return j;
}

dJointID piston(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID j = dJointCreatePiston(world, nullptr);
    dJointAttach(j, a, b);
    dJointSetPistonAnchor(j, 0, 0, 0);
    dJointSetPistonAxis(j, 0, 0, 1);
    lock(dJointSetPistonParam, j, 0);
    return j;
}

dJointID pr(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID j = dJointCreatePR(world, nullptr);
    dJointAttach(j, a, b);
    dJointSetPRAnchor(j, 0, 0, 0);
    dJointSetPRAxis1(j, 1, 0, 0);
    dJointSetPRAxis2(j, 0, 0, 1);
    lock(dJointSetPRParam, j, 0);
    return j;
}

// The wheel's motor stands in for a stop, which it does not have.
dJointID hinge2(dWorldID world, dBodyID a, dBodyID b)
{
    const dJointID j = dJointCreateHinge2(world, nullptr);
    dJointAttach(j, a, b);
    const dVector3 z = {0, 0, 1}, x = {1, 0, 0};
    dJointSetHinge2Anchor(j, 0, 0, 0);
    dJointSetHinge2Axes(j, z, x);
    dJointSetHinge2Param(j, dParamFMax2, 1000);
    return j;
}

// A disc at the anchor: the hinge holds the place, the motor's angle 0 turns.
dJointID amotor(dWorldID world, dBodyID a, dBodyID b)
{
    hinge(world, a, b);
    const dJointID j = dJointCreateAMotor(world, nullptr);
    dJointAttach(j, a, b);
    dJointSetAMotorMode(j, dAMotorEuler);
    dJointSetAMotorAxis(j, 0, 1, 0, 0, 1);
    dJointSetAMotorAxis(j, 2, 2, 1, 0, 0);
    return j;
}

const Kind kKinds[] = {{"hinge", 0, dJointSetHingeParam, hinge},
                       {"universal 1", 0, dJointSetUniversalParam, universal<0>},
                       {"universal 2", 1, dJointSetUniversalParam, universal<1>},
                       {"pu 1", 0, dJointSetPUParam, pu<0>},
                       {"pu 2", 1, dJointSetPUParam, pu<1>},
                       {"piston", 1, dJointSetPistonParam, piston},
                       {"pr", 1, dJointSetPRParam, pr},
                       {"hinge2", 0, dJointSetHinge2Param, hinge2},
                       {"amotor", 0, dJointSetAMotorParam, amotor}};

enum class Way { kExact, kQuick, kSubsteps, kHybrid, kGame, kRobot };
constexpr Way kWays[] = {Way::kExact, Way::kQuick, Way::kSubsteps, Way::kHybrid, Way::kGame, Way::kRobot};

struct Rotor {
    Rotor(const Kind& k, Way w, double h, bool arm, bool on_base) : kind(k), way(w), step(h)
    {
        if (way == Way::kGame || way == Way::kRobot)
            dWorldUseDefaults(world, way == Way::kGame ? dDefaultsGame : dDefaultsRobot);
        dWorldSetGravity(world, 0, 0, 0);
        dMass mass;
        if (arm)
            dMassSetBoxTotal(&mass, real(0.2), real(0.5), real(0.05), real(0.05));
        else
            dMassSetCylinderTotal(&mass, 1, 3, real(0.3), real(0.05));
        dBodySetMass(body, &mass);
        dBodySetPosition(body, arm ? real(0.25) : 0, 0, 0);
        if (on_base) {
            base = dBodyCreate(world);
            dBodySetKinematic(base);
        }
        joint = kind.make(world, body, base);
    }
    ~Rotor() { dWorldDestroy(world); }
    Rotor(const Rotor&) = delete;
    Rotor& operator=(const Rotor&) = delete;

    void advance()
    {
        if (way == Way::kExact)
            dWorldStep(world, real(step));
        else if (way == Way::kQuick)
            dWorldQuickStep(world, real(step));
        else if (way == Way::kSubsteps)
            dWorldStepFast1(world, real(step), 8);
        else
            dWorldStepHybrid(world, real(step));
        const double before = turned, now = orientation();
        turned = now + 2 * kPi * std::round((before - now) / (2 * kPi));
        largest_move = std::max(largest_move, std::fabs(turned - before));
        largest_angle = std::max(largest_angle, std::fabs(turned));
    }
    double orientation() const
    {
        const dReal* q = dBodyGetQuaternion(body);
        return 2 * std::atan2(double(q[3]), double(q[0]));
    }
    double rate() const { return spin(body).z; }
    double position() const { return double(dJointGetAxisPosition(joint, kind.axis)); }

    const Kind& kind;
    Way way;
    double step;
    dWorldID world = dWorldCreate();
    dBodyID body = dBodyCreate(world), base = nullptr;
    dJointID joint;
    double turned = 0, largest_move = 0, largest_angle = 0;
};

// visit(kind, way, continuous)
template <typename Visit>
void in_every_way(Visit visit)
{
    for (const Kind& kind : kKinds)
        for (const Way way : kWays)
            for (const bool continuous : {false, true}) {
                SCOPED_TRACE(testing::Message()
                             << kind.name << ", way " << int(way) << ", continuous " << continuous);
                visit(kind, way, continuous);
            }
}

bool is(const Kind& kind, const char* name) { return std::string(kind.name) == name; }

void hold_at_a_stop(const Kind& kind, Way way, bool continuous, double low, double high, double speed)
{
    const double goal = speed > 0 ? high : low, move = std::fabs(speed) * 0.032;
    // Sweeps of QuickStep converge slowly on a hinge with a motor of its own on a body that hangs off it.
    if (is(kind, "amotor") && way == Way::kQuick) return;
    Rotor rotor(kind, way, 0.032, true, is(kind, "hinge2"));
    dJointSetAxisContinuous(rotor.joint, kind.axis, continuous);
    kind.stops(rotor.joint, low, high);
    kind.motor(rotor.joint, speed, 2);
    for (int i = 0; i < 400; ++i) {
        rotor.advance();
        if (i < 200) continue;
        ASSERT_NEAR(rotor.position(), goal, 0.02);
        ASSERT_NEAR(rotor.turned, goal, 0.02);
        ASSERT_LT(std::fabs(rotor.rate()), 0.02);
    }
    EXPECT_LT(rotor.largest_angle, std::fabs(goal) + move + 0.03);
    EXPECT_LT(rotor.largest_move, 0.2);
}

TEST(TurningStops, hold_an_arm_whose_step_is_longer_than_the_gap)
{
    in_every_way([](const Kind& kind, Way way, bool continuous) {
        hold_at_a_stop(kind, way, continuous, -3.1, 3.1, 5);
        hold_at_a_stop(kind, way, continuous, -3.1, 3.1, -5);
        hold_at_a_stop(kind, way, continuous, -double(dInfinity), 3.14159, 5);
    });
}

// A blow of 50 N m for one step, on an arm that rests at its stop.
TEST(TurningStops, withstand_a_blow)
{
    in_every_way([](const Kind& kind, Way way, bool continuous) {
        if (is(kind, "amotor") && way == Way::kQuick) return;
        Rotor rotor(kind, way, 0.032, true, is(kind, "hinge2"));
        dJointSetAxisContinuous(rotor.joint, kind.axis, continuous);
        kind.stops(rotor.joint, -3.1, 3.1);
        kind.motor(rotor.joint, 5, 2);
        for (int i = 0; i < 100; ++i) {
            if (i == 50) dBodyAddTorque(rotor.body, 0, 0, 50);
            rotor.advance();
        }
        EXPECT_LT(rotor.largest_angle, 3.1 + 0.2);
        EXPECT_NEAR(rotor.turned, 3.1, 0.02);
    });
}

TEST(TurningStops, lie_beyond_half_a_turn)
{
    in_every_way([](const Kind& kind, Way way, bool continuous) {
        for (const auto& [low, high, speed] :
             {std::array{-3.49, 0.785, -5.}, {-0.1, 4.712, 5.}, {-6.28, 6.28, 5.}, {0., 18.85, 5.}}) {
            const double goal = speed > 0 ? high : low;
            Rotor rotor(kind, way, 0.01, false, is(kind, "hinge2"));
            dJointSetAxisContinuous(rotor.joint, kind.axis, continuous);
            kind.stops(rotor.joint, low, high);
            kind.motor(rotor.joint, speed, 5);
            for (int i = 0; i < 500; ++i) {
                rotor.advance();
                if (i > 10 && std::fabs(rotor.turned) < std::fabs(goal) - 0.06) {
                    ASSERT_NEAR(rotor.rate(), speed, 0.02) << "no stop on the way, at " << rotor.turned;
                }
            }
            EXPECT_NEAR(rotor.turned, goal, 0.01);
            EXPECT_NEAR(rotor.position(), goal, 0.01);
            EXPECT_LT(std::fabs(rotor.rate()), 1e-3);
        }
    });
}

// Attached as (0, body): the position, and the stops with it or against it, are counted as well.
TEST(TurningStops, hold_joints_that_are_attached_the_other_way_round)
{
    for (const Kind& kind : kKinds) {
        if (is(kind, "hinge2")) continue;
        SCOPED_TRACE(kind.name);
        Rotor rotor(kind, Way::kExact, 0.01, false, false);
        dJointDestroy(rotor.joint);
        rotor.joint = kind.make(rotor.world, nullptr, rotor.body);
        const int axis = is(kind, "universal 1") || is(kind, "pu 1")   ? 1
                         : is(kind, "universal 2") || is(kind, "pu 2") ? 0
                                                                       : kind.axis;
        const Kind own{kind.name, axis, kind.set, kind.make};
        for (int i = 0; i < 2; ++i)
            if (i != axis) kind.set(rotor.joint, dParamLoStop + i * dParamGroup, 0);
        own.stops(rotor.joint, -4, 4.5);
        own.motor(rotor.joint, 2, 5);
        for (int i = 0; i < 500; ++i) rotor.advance();
        const double limit = rotor.turned > 0 ? 4.5 : -4;
        EXPECT_NEAR(rotor.turned, limit, 0.01);
        EXPECT_NEAR(std::fabs(rotor.position()), std::fabs(limit), 0.01);
        EXPECT_LT(std::fabs(rotor.rate()), 1e-3);
    }
}

// The program places the arm on the other side of the gap: it is there, and not a turn further.
TEST(TurningStops, begin_again_where_the_program_places_the_body)
{
    for (const bool in_bulk : {false, true}) {
        Rotor rotor(kKinds[0], Way::kExact, 0.01, false, false);
        kKinds[0].stops(rotor.joint, -3.1, 3.1);
        dQuaternion q;
        dQFromAxisAndAngle(q, 0, 0, 1, 3);
        dBodySetQuaternion(rotor.body, q);
        rotor.advance();
        EXPECT_NEAR(rotor.position(), 3, 1e-5);
        dQFromAxisAndAngle(q, 0, 0, 1, -3);
        if (in_bulk)
            dBodiesSetStates(&rotor.body, 1, dStateQuaternion, q, 0);
        else
            dBodySetQuaternion(rotor.body, q);
        EXPECT_NEAR(rotor.position(), -3, 1e-5);
        rotor.advance();
        EXPECT_NEAR(rotor.position(), -3, 1e-5);
        EXPECT_NEAR(rotor.rate(), 0, 1e-9) << "no stop acts";
    }
}

TEST(TurningStops, know_the_turn_that_the_program_names)
{
    Rotor rotor(kKinds[0], Way::kExact, 0.01, false, false);
    kKinds[0].stops(rotor.joint, -6.28, 6.28);
    dQuaternion q;
    dQFromAxisAndAngle(q, 0, 0, 1, 4);
    dBodySetQuaternion(rotor.body, q);
    EXPECT_EQ(dJointSetAxisTurn(rotor.joint, 0, 4), 1);
    EXPECT_NEAR(rotor.position(), 4, 1e-5);
    kKinds[0].motor(rotor.joint, 2, 5);
    for (int i = 0; i < 300; ++i) rotor.advance();
    EXPECT_NEAR(rotor.position(), 6.28, 1e-3);
    const Messages messages;
    EXPECT_EQ(dJointSetAxisTurn(rotor.joint, 0, dInfinity), 0);
    EXPECT_NEAR(rotor.position(), 6.28, 1e-3);
}

// An angle with stops is not driven through the gap between them, although that is shorter.
TEST(TurningStops, a_servo_goes_between_them)
{
    Rotor rotor(kKinds[0], Way::kExact, 0.01, false, false);
    kKinds[0].stops(rotor.joint, -3.1, 3.1);
    dQuaternion q;
    dQFromAxisAndAngle(q, 0, 0, 1, -3);
    dBodySetQuaternion(rotor.body, q);
    dDrive servo;
    dDriveInit(&servo, sizeof servo);
    servo.stiffness = 10, servo.damping = 2, servo.target = 3;
    dJointSetDrive(rotor.joint, 0, &servo);
    for (int i = 0; i < 1000; ++i) rotor.advance();
    EXPECT_NEAR(rotor.position(), 3, 1e-3);
}

// As ODE: angles are compared in -pi ... pi, and the arm goes through.
TEST(TurningStops, compare_angles_within_half_a_turn_with_the_behaviour_of_ode)
{
    Rotor rotor(kKinds[0], Way::kExact, 0.01, false, false);
    dWorldSetBehaviour(rotor.world, dBehaviour016);
    kKinds[0].stops(rotor.joint, -4, 4);
    kKinds[0].motor(rotor.joint, 2, 5);
    for (int i = 0; i < 500; ++i) rotor.advance();
    EXPECT_GT(rotor.turned, 9);
    EXPECT_LT(std::fabs(rotor.position()), 3.15);
}

}  // namespace
}  // namespace epode::physics
