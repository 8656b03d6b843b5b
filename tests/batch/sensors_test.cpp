// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors of the file: those of the state as a world's robot reads them, those of the last step as it does in the limit of short steps,
// and closed forms. python/tests/test_sensors.py compares them with MuJoCo.
#include "golden/golden.h"
#include "models.h"

#include <epode/robot_sensors.h>
#include <ode/ext.h>

#include <algorithm>

namespace epode::tests {
namespace {

const char* const kSensing =
    R"(<mujoco model="sensing"><compiler angle="radian"/><worldbody><site name="post" pos="0.3 0.2 0.1" euler="0.4 0.1 0.2"/>
<body name="cart" pos="0.1 0.2 1"><joint name="rail" type="slide" axis="1 0.2 0"/><inertial pos="0.05 0 0.02" mass="2" diaginertia="0.02 0.03 0.025"/>
<site name="eye" pos="0.1 0.05 0.2" euler="0.3 -0.5 0.7"/>
<body name="arm" pos="0.1 0 -0.1" euler="0.3 0.2 0.1"><joint name="u" axis="0 0 1" pos="0.02 0 0"/><joint name="v" axis="0 1 0" pos="0 0.03 0.01"/>
<inertial pos="0 0.02 -0.2" mass="1.1" diaginertia="0.012 0.011 0.004"/><site name="elbow" pos="0.01 0.02 -0.1" euler="0.2 0.3 -0.4"/>
<body name="bob" pos="0 0 -0.4"><joint name="w" type="ball" pos="0 0 0.02"/><inertial pos="0.03 0.01 -0.1" euler="0.4 0 0.5" mass="0.7" diaginertia="0.004 0.005 0.002"/>
<site name="tip" pos="0.02 -0.01 -0.15" euler="-0.6 0.2 0.9"/></body></body></body>
<body name="kite" pos="1 0 2"><freejoint name="loose"/><inertial pos="0.1 0 0" mass="0.9" diaginertia="0.01 0.02 0.027"/><site name="nose" pos="0.2 0.01 0.03" euler="0.1 0.2 0.3"/>
<body name="tail" pos="-0.2 0 0"><joint name="t" axis="0 1 0"/><inertial pos="-0.1 0 0" mass="0.2" diaginertia="0.001 0.002 0.002"/><site name="end" pos="-0.2 0 0" euler="0 0.7 0"/></body></body>
</worldbody><tendon><fixed name="sum"><joint joint="u" coef="0.5"/><joint joint="t" coef="-0.3"/></fixed></tendon>
<actuator><motor name="push" joint="rail" gear="3" ctrlrange="-0.5 0.5"/><position name="hold" joint="u" kp="2" kv="0.3" forcerange="-0.4 0.4"/><motor name="pull" tendon="sum" gear="2"/></actuator>
<sensor><jointpos name="jp" joint="rail"/><jointvel name="jv" joint="v"/><ballquat name="bq" joint="w"/><ballangvel name="bw" joint="w"/><rangefinder name="ray" site="eye"/>
<actuatorfrc name="af" actuator="push"/><actuatorfrc name="ag" actuator="hold"/><actuatorfrc name="ah" actuator="pull"/><actuatorpos name="ap" actuator="pull"/><actuatorvel name="av" actuator="hold"/>
<jointactuatorfrc name="ju" joint="u"/><jointactuatorfrc name="jt" joint="t"/>
<framepos name="fp" objtype="site" objname="tip"/><framequat name="fq" objtype="site" objname="elbow"/><framexaxis name="fx" objtype="site" objname="nose"/>
<frameyaxis name="fy" objtype="body" objname="kite"/><framezaxis name="fz" objtype="xbody" objname="arm"/><framelinvel name="fl" objtype="site" objname="tip"/><frameangvel name="fa" objtype="xbody" objname="bob"/>
<framepos name="rp" objtype="site" objname="tip" reftype="site" refname="eye"/><framequat name="rq" objtype="site" objname="nose" reftype="site" refname="elbow"/>
<framelinvel name="rl" objtype="site" objname="end" reftype="site" refname="tip"/><frameangvel name="ra" objtype="site" objname="end" reftype="site" refname="tip"/>
<framexaxis name="rx" objtype="site" objname="end" reftype="site" refname="post"/><velocimeter name="vm" site="tip"/><gyro name="gy" site="elbow"/>
<subtreecom name="sc" body="cart"/><subtreecom name="sw" body="world"/><subtreelinvel name="sv" body="kite"/>
<accelerometer name="ac" site="tip"/><accelerometer name="an" site="nose"/><force name="fo" site="elbow"/><torque name="to" site="elbow"/><force name="fe" site="end"/><torque name="te" site="end"/>
<touch name="tc" site="eye"/></sensor></mujoco>)";

class BatchSensors : public testing::Test {
  protected:
    BatchSensors()
    {
        dInitODE2(0);
        model = model_of(kSensing);
        sensors.resize(size_t(dRobotModelGetSensors(model, nullptr, 0)));
        dRobotModelGetSensors(model, sensors.data(), int(sensors.size()));
    }
    ~BatchSensors() override
    {
        dRobotModelDestroy(model);
        dCloseODE();
    }

    struct State {
        std::vector<double> q, v, c;
    };
    State any(Dice& dice) const
    {
        const auto velocities = size_t(dRobotModelGetNumVelocities(model));
        return {any_positions(model, dice), dice.many(int(velocities), -1, 1), dice.many(3, -1, 1)};
    }
    static void put(Copies<double>& copies, const State& state)
    {
        copies.write(dBatchPositions, state.q), copies.write(dBatchVelocities, state.v),
            copies.write(dBatchControls, state.c);
    }
    static constexpr int kSteps = 40;
    static bool is_of_step(const std::string& kind)
    {
        return kind == "accelerometer" || kind == "force" || kind == "torque" || kind == "touch";
    }

    // What a world's robot reads, sensor by sensor; after steps of length h, if that is not 0.
    std::vector<std::vector<double>> of_world(const State& state, dReal h) const
    {
        const dWorldID world = dWorldCreate();
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-9.81)), dWorldSetCFM(world, 0);
        const dRobotID robot = dRobotCreate(world, space, model, nullptr, nullptr);
        const auto q = reals_of(state.q), v = reals_of(state.v);
        dRobotSetPositions(robot, q.data(), int(q.size())),
            dRobotSetVelocities(robot, v.data(), int(v.size()));
        for (int i = 0; i < 3; ++i) dRobotSetControl(robot, i, dReal(state.c[size_t(i)]));
        for (int link = 1; link < 6; ++link)
            if (link != 4) dRobotSetForceSensor(robot, link, 1);
        dRobotUpdateSensors(robot, dReal(0.001));
        // A world's joints feel that axes have turned after some steps only.
        for (int i = 0; i < kSteps && h > 0; ++i)
            dRobotAddForces(robot, h), dWorldStep(world, h), dRobotUpdateSensors(robot, h);
        std::vector<std::vector<double>> out;
        for (size_t i = 0; i < sensors.size(); ++i) {
            std::vector<dReal> its(size_t(sensors[i].values));
            const bool is_ray = std::string(sensors[i].kind) == "rangefinder";
            const int got = is_ray ? 1 : dRobotReadSensor(robot, int(i), space, its.data(), int(its.size()));
            EXPECT_EQ(got, sensors[i].values) << sensors[i].name;
            out.emplace_back(its.begin(), its.end());
        }
        dRobotDestroy(robot), dSpaceDestroy(space), dWorldDestroy(world);
        return out;
    }

    std::vector<double> of(Copies<double>& copies, size_t sensor) const
    {
        const auto all = copies.read(dBatchSensors);
        int first = -1;
        const int count = dBatchGetSensor(copies.id, int(sensor), &first);
        EXPECT_EQ(count, std::string(sensors[sensor].kind) == "rangefinder" ? 0 : sensors[sensor].values);
        return {all.begin() + first, all.begin() + first + count};
    }

    dRobotModelID model;
    std::vector<dRobotSensor> sensors;
};

TEST_F(BatchSensors, stand_in_the_files_order)
{
    Copies<double> copies(model, 1, dReal(0.002));
    int next = 0;
    for (size_t i = 0; i < sensors.size(); ++i) {
        int first = -1;
        const int count = dBatchGetSensor(copies.id, int(i), &first);
        EXPECT_EQ(first, next);
        EXPECT_EQ(count > 0, std::string(sensors[i].name) != "ray") << sensors[i].name;
        next += count;
    }
    EXPECT_EQ(copies.size(dBatchSensors), next);
    EXPECT_EQ(dBatchGetSensor(copies.id, 0, nullptr), 1);
    int first = 7;
    EXPECT_EQ(dBatchGetSensor(copies.id, -1, &first), 0);
    EXPECT_EQ(dBatchGetSensor(copies.id, int(sensors.size()), &first), 0);
    EXPECT_EQ(dBatchGetSensor(nullptr, 0, &first), 0);
    EXPECT_EQ(first, 7);
}

TEST_F(BatchSensors, of_the_state_read_as_in_worlds)
{
    Copies<double> copies(model, 1, dReal(0.002));
    Dice dice(3);
    for (int i = 0; i < 40; ++i) {
        const State state = any(dice);
        put(copies, state);
        const auto want = of_world(state, 0);
        for (size_t k = 0; k < sensors.size(); ++k) {
            if (is_of_step(sensors[k].kind) || std::string(sensors[k].name) == "ray") continue;
            auto its = of(copies, k);
            const bool is_turn = its.size() == 4;  // whose sign is free
            if (is_turn && its[0] * want[k][0] < 0)
                for (double& x : its) x = -x;
            for (size_t n = 0; n < its.size(); ++n)
                EXPECT_NEAR(its[n], want[k][n], sizeof(dReal) == 8 ? 1e-9 : 1e-4) << sensors[k].name << n;
        }
    }
}

TEST_F(BatchSensors, of_the_step_read_as_in_worlds)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "differences of this size are rounding in floats";
    Dice dice(4);
    double worst = 0;
    for (int i = 0; i < 20; ++i) {
        const State state = any(dice);
        std::vector<double> coarse, fine;
        for (std::vector<double>* errors : {&coarse, &fine}) {
            const dReal h = dReal(errors == &fine ? 1e-5 : 4e-5);
            Copies<double> copies(model, 1, h, dReal(1e-13), 1, 20000);
            put(copies, state);
            dBatchStep(copies.id, kSteps);
            const auto want = of_world(state, h);
            for (size_t k = 0; k < sensors.size(); ++k) {
                const auto its = of(copies, k);
                double error = 0;
                for (size_t n = 0; n < its.size() && is_of_step(sensors[k].kind); ++n)
                    error = std::max(error, std::fabs(its[n] - want[k][n]));
                errors->push_back(error);
            }
        }
        for (size_t k = 0; k < sensors.size(); ++k) {
            EXPECT_LT(fine[k], 0.3 * coarse[k] + 1e-5) << i << ' ' << sensors[k].name;
            worst = std::max(worst, fine[k]);
        }
    }
    EXPECT_LT(worst, 0.02);  // of forces of tens of newtons
}

// What falls feels nothing; what hangs is borne by its joint; what stands presses with its weight.
TEST_F(BatchSensors, have_their_closed_forms)
{
    const char* text =
        R"(<mujoco><worldbody><geom type="plane" size="9 9 1"/><body pos="0 0 5"><freejoint/><geom size="0.1" mass="2"/><site name="falls"/></body>
<body pos="2 0 5"><joint axis="0 1 0"/><geom pos="0 0 -0.3" size="0.1" mass="2" contype="0" conaffinity="0"/><site name="hangs" euler="90 0 0"/>
<body pos="0 0 -0.3"><joint axis="1 0 0"/><geom pos="0 0 -0.3" size="0.1" mass="3" contype="0" conaffinity="0"/><site name="below" pos="0.1 0 0"/></body></body>
<body pos="4 0 0.1"><freejoint/><geom type="box" size="0.1 0.1 0.1" mass="4"/><site name="stands"/></body></worldbody>
<sensor><accelerometer site="falls"/><force site="hangs"/><force site="below"/><torque site="below"/><touch site="stands"/><accelerometer site="stands"/><touch site="falls"/></sensor></mujoco>)";
    const dRobotModelID other = model_of(text);
    Copies<double> copies(other, 1, dReal(0.002), dReal(1e-10), 1, 2000);
    std::vector<double> bound(size_t(copies.size(dBatchSensors)), -1);
    ASSERT_EQ(bound.size(), 15u + 2);
    EXPECT_EQ(dBatchBind(copies.id, dBatchSensors, bound.data()), 1);
    for (const double x : bound) EXPECT_TRUE(std::isfinite(x));
    dBatchStep(copies.id, 200);
    EXPECT_EQ(bound, copies.read(dBatchSensors));
    const double g = 9.81, want[] = {0, 0, 0, 0, 5 * g, 0, 0, 0, 3 * g, 0, 3 * g * 0.1, 0, 4 * g, 0, 0, g, 0};
    for (size_t i = 0; i < bound.size(); ++i) EXPECT_NEAR(std::fabs(bound[i]), want[i], 1e-6) << i;
    EXPECT_GT(bound[15], 0);
    dBatchReset(copies.id, nullptr);
    EXPECT_EQ(bound[12], 0);
    dRobotModelDestroy(other);
}

// Limits, tendons, energies, angular momenta, magnetometers and accelerations of frames: of the state as in worlds, of the step by what bears
// a weight.
class BatchMoreSensors : public BatchSensors {
  protected:
    void use(const char* text)
    {
        dRobotModelDestroy(model);
        model = model_of(text);
        sensors.resize(size_t(dRobotModelGetSensors(model, nullptr, 0)));
        dRobotModelGetSensors(model, sensors.data(), int(sensors.size()));
    }
};

const char* const kMeasuring =
    R"(<mujoco><compiler angle="radian"/><option magnetic="0.3 -0.4 0.5"/><worldbody><body name="cart" pos="0.1 0.2 1"><joint name="rail" type="slide" axis="1 0.2 0" range="-0.3 0.2" stiffness="3" springref="0.1" armature="0.2"/>
<inertial pos="0.05 0 0.02" mass="2" diaginertia="0.02 0.03 0.025"/><body name="arm" pos="0.1 0 -0.1" euler="0.3 0.2 0.1"><joint name="u" axis="0 0 1" range="-0.2 0.3"/>
<inertial pos="0 0.02 -0.2" mass="1.1" diaginertia="0.012 0.011 0.004"/><site name="elbow" pos="0.01 0.02 -0.1" euler="0.2 0.3 -0.4"/></body></body>
<body name="kite" pos="1 0 2"><freejoint name="loose"/><inertial pos="0.1 0 0" mass="0.9" diaginertia="0.01 0.02 0.027"/><body name="tail" pos="-0.2 0 0"><joint name="t" axis="0 1 0"/>
<inertial pos="-0.1 0 0" mass="0.2" diaginertia="0.001 0.002 0.002"/></body></body></worldbody>
<tendon><fixed name="sum" range="-0.2 0.1" stiffness="4" springlength="0.05"><joint joint="u" coef="0.5"/><joint joint="t" coef="-0.3"/></fixed></tendon>
<actuator><motor joint="rail"/><motor joint="u"/><motor joint="t"/></actuator>
<sensor><jointlimitpos joint="rail"/><jointlimitvel joint="rail"/><jointlimitpos joint="u"/><jointlimitvel joint="u"/><tendonpos tendon="sum"/><tendonvel tendon="sum"/><tendonlimitpos tendon="sum"/><tendonlimitvel tendon="sum"/>
<e_kinetic/><e_potential/><subtreeangmom body="cart"/><subtreeangmom body="kite"/><magnetometer site="elbow"/><jointpos joint="u" cutoff="0.25"/><framepos objtype="site" objname="elbow" cutoff="0.4"/></sensor></mujoco>)";

TEST_F(BatchMoreSensors, of_the_state_read_as_in_worlds)
{
    use(kMeasuring);
    Copies<double> copies(model, 1, dReal(0.002));
    Dice dice(5);
    for (int i = 0; i < 40; ++i) {
        const State state = any(dice);
        put(copies, state);
        const auto want = of_world(state, 0);
        for (size_t k = 0; k < sensors.size(); ++k) {
            const auto its = of(copies, k);
            ASSERT_EQ(its.size(), want[k].size()) << sensors[k].kind;
            for (size_t n = 0; n < its.size(); ++n)
                EXPECT_NEAR(its[n], want[k][n], sizeof(dReal) == 8 ? 1e-9 : 1e-3) << sensors[k].kind << n;
        }
    }
}

// Weights on limits of a slide and of a sum of slides; and what stands feels gravity in the world's axes, turned or not.
TEST_F(BatchMoreSensors, of_the_step_have_their_closed_forms)
{
    use(R"(<mujoco><worldbody><body pos="0 0 1"><joint name="j" type="slide" axis="0 0 1" range="-0.01 1"/><geom size="0.1" mass="3" contype="0" conaffinity="0"/><site name="s" euler="90 0 0"/></body>
<body pos="1 0 1"><joint name="a" type="slide" axis="0 0 1"/><geom size="0.1" mass="1" contype="0" conaffinity="0"/></body><body pos="2 0 1"><joint name="b" type="slide" axis="0 0 1"/><geom size="0.1" mass="2" contype="0" conaffinity="0"/></body></worldbody>
<tendon><fixed name="t" range="-0.01 1"><joint joint="a" coef="1"/><joint joint="b" coef="2"/></fixed></tendon>
<sensor><jointlimitfrc joint="j"/><jointlimitfrc joint="a"/><tendonlimitfrc tendon="t"/><framelinacc objtype="site" objname="s"/><frameangacc objtype="site" objname="s"/><jointlimitfrc joint="j" cutoff="7"/></sensor></mujoco>)");
    Copies<double> copies(model, 1, dReal(0.002), dReal(1e-10), 1, 2000);
    dBatchStep(copies.id, 1000);
    const double g = 9.81, want[] = {3 * g, 0, g, 0, 0, g, 0, 0, 0, 7};
    const auto all = copies.read(dBatchSensors);
    ASSERT_EQ(all.size(), std::size(want));
    for (size_t i = 0; i < all.size(); ++i) EXPECT_NEAR(all[i], want[i], 1e-4) << i;
}

// A batch counts no time and has no geoms to measure between: such sensors have no numbers, the others theirs.
TEST_F(BatchMoreSensors, that_are_not_computed_have_no_numbers)
{
    use(R"(<mujoco><worldbody><body><joint name="j"/><geom name="g" size="0.1"/></body><body><joint name="k"/><geom name="h" size="0.1"/></body></worldbody>
<sensor><clock/><distance geom1="g" geom2="h"/><jointpos joint="j"/></sensor></mujoco>)");
    Copies<double> copies(model, 1, dReal(0.002));
    EXPECT_EQ(copies.size(dBatchSensors), 1);
    EXPECT_EQ(dBatchGetSensor(copies.id, 0, nullptr), 0);
    EXPECT_EQ(dBatchGetSensor(copies.id, 1, nullptr), 0);
}

template <typename T>
std::uint64_t hash_of_sensors(dRobotModelID model)
{
    Copies<T> copies(model, 13, dReal(0.004));
    for (int i = 0; i < 13; ++i) {
        Dice dice(unsigned(40 + i));
        const auto q = any_positions(model, dice), v = dice.many(copies.size(dBatchVelocities), -1, 1);
        copies.write_one(dBatchPositions, i, {q.begin(), q.end()}),
            copies.write_one(dBatchVelocities, i, {v.begin(), v.end()});
    }
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int i = 0; i < 5; ++i) {
        dBatchStep(copies.id, 20);
        for (const T x : copies.read(dBatchSensors)) hash = hashed(hash, x);
    }
    const auto all = copies.read(dBatchSensors), one = copies.read(dBatchSensors, 7, 1);
    EXPECT_EQ(std::memcmp(one.data(), &all[7 * one.size()], one.size() * sizeof(T)), 0);
    return hash;
}

TEST(BatchBits, of_sensors_are_golden)
{
    if (sizeof(dReal) == 4) GTEST_SKIP() << "step sizes and states pass through dReal";
    const dRobotModelID model = model_of(kSensing);
    EXPECT_TRUE(golden::is_golden("batch/sensors/double", hash_of_sensors<double>(model)));
    EXPECT_TRUE(golden::is_golden("batch/sensors/float", hash_of_sensors<float>(model)));
    dRobotModelDestroy(model);
}

}  // namespace
}  // namespace epode::tests
