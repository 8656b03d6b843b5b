// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors against closed forms: gravity, turning, free fall, weights, planes and a ball before a camera.
#include <epode/robot_sensors.h>
#include <gtest/gtest.h>
#include <ode/ext.h>

#include <cmath>
#include <string>
#include <vector>

namespace {

constexpr bool kIsDouble = sizeof(dReal) == 8;
constexpr double kExact = kIsDouble ? 1e-9 : 1e-3, kFine = kIsDouble ? 1e-6 : 2e-2, kG = 9.81;
const dReal kStep = dReal(0.005);

class RobotSensors : public testing::Test {
  protected:
    RobotSensors()
    {
        dInitODE2(0);
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-kG));
        dWorldSetContactSpace(world, space);
    }
    ~RobotSensors() override
    {
        dSetMessageHandler(nullptr);
        if (robot) dRobotDestroy(robot);
        if (model) dRobotModelDestroy(model);
        dSpaceDestroy(space);
        dWorldDestroy(world);
        dCloseODE();
    }
    void load(const std::string& text, bool keep_fixed = false)
    {
        dRobotOptions options;
        dRobotOptionsInit(&options, sizeof options);
        options.keep_fixed = keep_fixed;
        model = dRobotModelLoadText("robot.xml", text.data(), text.size(), &options);
        ASSERT_EQ(dRobotModelHasErrors(model), 0);
        robot = dRobotCreate(world, space, model, nullptr, nullptr);
        ASSERT_NE(robot, nullptr);
    }
    void step(int count)
    {
        for (int i = 0; i < count; ++i) {
            dWorldStep(world, kStep);
            ASSERT_EQ(dRobotUpdateSensors(robot, kStep), 1);
        }
    }
    std::vector<dReal> read(const char* name, int count)
    {
        std::vector<dRobotSensor> all(size_t(dRobotModelGetSensors(model, nullptr, 0)));
        dRobotModelGetSensors(model, all.data(), int(all.size()));
        for (size_t i = 0; i < all.size(); ++i)
            if (all[i].name == std::string(name)) {
                std::vector<dReal> values(size_t(count), dReal(NAN));
                EXPECT_EQ(dRobotReadSensor(robot, int(i), space, values.data(), count), count) << name;
                EXPECT_EQ(all[i].values, count) << name;
                return values;
            }
        ADD_FAILURE() << name;
        return std::vector<dReal>(size_t(count));
    }
    dWorldID world;
    dSpaceID space;
    dRobotModelID model = nullptr;
    dRobotID robot = nullptr;
};

void expect_vec(const dReal* v, double x, double y, double z, double tolerance)
{
    EXPECT_NEAR(v[0], x, tolerance);
    EXPECT_NEAR(v[1], y, tolerance);
    EXPECT_NEAR(v[2], z, tolerance);
}

const char* kBox = R"(<mujoco><worldbody><body name="box" pos="0 0 1"><freejoint/>
    <geom type="box" size="0.1 0.1 0.1" mass="2"/></body></worldbody></mujoco>)";

TEST_F(RobotSensors, an_accelerometer_at_rest_reads_gravity_upwards)
{
    load(kBox);
    dCreatePlane(space, 0, 0, 1, dReal(0.9));
    step(200);
    dVector3 f, w;
    ASSERT_EQ(dRobotGetImu(robot, 1, nullptr, f, w), 1);
    expect_vec(f, 0, 0, kG, kFine);
    expect_vec(w, 0, 0, 0, kFine);
    // On its side: half a right angle about x.
    const dReal frame[7] = {dReal(0.1), 0, 0, std::sqrt(dReal(0.5)), std::sqrt(dReal(0.5)), 0, 0};
    ASSERT_EQ(dRobotGetImu(robot, 1, frame, f, nullptr), 1);
    expect_vec(f, 0, kG, 0, kFine);
    ASSERT_EQ(dRobotGetImu(robot, 0, nullptr, f, nullptr), 1);
    expect_vec(f, 0, 0, kG, kExact);
}

TEST_F(RobotSensors, an_accelerometer_in_free_fall_reads_nothing)
{
    load(kBox);
    step(50);
    dVector3 f;
    ASSERT_EQ(dRobotGetImu(robot, 1, nullptr, f, nullptr), 1);
    expect_vec(f, 0, 0, 0, kExact);
}

TEST_F(RobotSensors, an_imu_on_a_turntable_reads_centripetal_acceleration)
{
    load(R"(<mujoco><worldbody><body name="table"><joint name="turn" axis="0 0 1"/>
        <geom type="cylinder" size="0.5 0.02" mass="3"/><site name="imu" pos="0.4 0 0.02"/></body></worldbody>
        <sensor><accelerometer name="a" site="imu"/><gyro name="w" site="imu"/>
        <framelinvel name="v" objtype="site" objname="imu"/><jointvel name="rate" joint="turn"/></sensor></mujoco>)");
    const dReal rate = 3;
    ASSERT_EQ(dRobotSetVelocities(robot, &rate, 1), 1);
    step(100);
    expect_vec(read("a", 3).data(), -9 * 0.4, 0, kG, kFine);
    expect_vec(read("w", 3).data(), 0, 0, 3, kExact);
    EXPECT_NEAR(read("rate", 1)[0], 3, kExact);
    const std::vector<dReal> v = read("v", 3);
    EXPECT_NEAR(std::hypot(v[0], v[1]), 1.2, kExact);
}

TEST_F(RobotSensors, a_force_sensor_bears_what_hangs_on_it)
{
    load(
        R"(<robot name="arm"><link name="world"/><link name="rod"><inertial><origin xyz="0.3 0 -0.2"/><mass value="2"/>
        <inertia ixx="0.1" iyy="0.1" izz="0.1" ixy="0" ixz="0" iyz="0"/></inertial></link>
        <joint name="weld" type="fixed"><parent link="world"/><child link="rod"/></joint></robot>)",
        true);
    const int link = dRobotModelFindLink(model, "rod");
    dVector3 f, t;
    ASSERT_EQ(dRobotSetForceSensor(robot, link, 1), 1);
    step(10);
    ASSERT_EQ(dRobotGetForceTorque(robot, link, nullptr, f, t), 1);
    expect_vec(f, 0, 0, -2 * kG, kFine);
    expect_vec(t, 0, 0.3 * 2 * kG, 0, kFine);  // (0.3, 0, -0.2) x (0, 0, -2 g)
    const dReal frame[7] = {dReal(0.3), 0, 0, std::sqrt(dReal(0.5)), 0, std::sqrt(dReal(0.5)), 0};
    ASSERT_EQ(dRobotGetForceTorque(robot, link, frame, f, t), 1);
    expect_vec(f, 2 * kG, 0, 0, kFine);  // its x axis points down
    expect_vec(t, 0, 0, 0, kFine);
}

// Two weights in a row: the upper joint bears both; the drive holds the lower one out.
TEST_F(RobotSensors, named_sensors_of_a_chain_read_its_weights)
{
    load(
        R"(<mujoco><worldbody><body name="upper" pos="0 0 2"><joint name="swing" axis="0 1 0"/><site name="top"/>
        <inertial pos="0 0 -0.5" mass="3" diaginertia="0.1 0.1 0.1"/>
        <body name="lower" pos="0 0 -1"><joint name="lift" type="slide" axis="0 0 1"/><site name="middle"/>
        <inertial pos="0 0 -0.2" mass="1" diaginertia="0.1 0.1 0.1"/></body></body></worldbody>
        <actuator><position name="servo" joint="lift" kp="1e5" kv="1e3"/></actuator>
        <sensor><force name="both" site="top"/><torque name="none" site="top"/><force name="one" site="middle"/>
        <actuatorfrc name="servo" actuator="servo"/><jointpos name="lift" joint="lift"/><framepos name="where" objtype="body" objname="lower"/></sensor></mujoco>)");
    step(400);
    expect_vec(read("both", 3).data(), 0, 0, 4 * kG, 1e-3);  // MuJoCo 4.0: 39.24, as it acts on the link
    expect_vec(read("none", 3).data(), 0, 0, 0, 1e-3);
    expect_vec(read("one", 3).data(), 0, 0, 1 * kG, 1e-3);
    EXPECT_NEAR(read("servo", 1)[0], kG, kIsDouble ? 1e-3 : kFine);
    EXPECT_NEAR(read("lift", 1)[0], -kG / 1e5, 1e-5);
    EXPECT_NEAR(read("where", 3)[2], 0.8 - kG / 1e5, 1e-4);  // a body is its centre of mass
    dReal forces[2];
    ASSERT_EQ(dRobotGetDriveForces(robot, forces, 2), 2);
    EXPECT_EQ(forces[0], 0);
    EXPECT_NEAR(forces[1], kG, 1e-3);
}

// A cart that runs along x at 2 m/s carries an arm that turns about z at 3 rad/s; both and the tip are called alike.
TEST_F(RobotSensors, frames_are_seen_from_others)
{
    load(
        R"(<mujoco><worldbody><body name="hand" pos="0 0 1"><joint type="slide" axis="1 0 0"/><inertial pos="0 0 0.1" mass="1" diaginertia="1 1 1"/>
        <body name="arm" pos="0 0 0.5"><joint axis="0 0 1"/><inertial pos="0.2 0 0" mass="1" diaginertia="1 1 1"/><site name="hand" pos="0.4 0 0"/></body></body></worldbody>
        <sensor><framepos name="tip" objtype="site" objname="hand"/><framepos name="body" objtype="body" objname="hand"/>
        <framepos name="origin" objtype="xbody" objname="hand"/><gyro name="gyro" site="hand"/><velocimeter name="velocity" site="hand"/>
        <framepos name="tip in arm" objtype="site" objname="hand" reftype="xbody" refname="arm"/>
        <framelinvel name="speed in arm" objtype="site" objname="hand" reftype="xbody" refname="arm"/>
        <framelinvel name="speed in cart" objtype="site" objname="hand" reftype="body" refname="hand"/>
        <framelinvel name="speed of arm" objtype="body" objname="arm"/>
        <frameangvel name="turn in cart" objtype="site" objname="hand" reftype="xbody" refname="hand"/>
        <frameangvel name="turn in arm" objtype="xbody" objname="hand" reftype="site" refname="hand"/>
        <framequat name="quat in arm" objtype="site" objname="hand" reftype="body" refname="arm"/></sensor></mujoco>)");
    const dReal v[2] = {2, 3};
    dWorldSetGravity(world, 0, 0, 0);
    ASSERT_EQ(dRobotSetVelocities(robot, v, 2), 1);
    ASSERT_EQ(dRobotUpdateSensors(robot, kStep), 1);
    expect_vec(read("tip", 3).data(), 0.4, 0, 1.5, kExact);
    expect_vec(read("body", 3).data(), 0, 0, 1.1, kExact);
    expect_vec(read("origin", 3).data(), 0, 0, 1, kExact);
    expect_vec(read("gyro", 3).data(), 0, 0, 3, kExact);
    expect_vec(read("velocity", 3).data(), 2, 1.2, 0, kExact);
    expect_vec(read("tip in arm", 3).data(), 0.4, 0, 0, kExact);
    expect_vec(read("speed in arm", 3).data(), 0, 0, 0, kExact);
    expect_vec(read("speed in cart", 3).data(), 0, 1.2, 0, kExact);
    expect_vec(read("speed of arm", 3).data(), 2, 0.6, 0, kExact);
    expect_vec(read("turn in cart", 3).data(), 0, 0, 3, kExact);
    expect_vec(read("turn in arm", 3).data(), 0, 0, -3, kExact);
    EXPECT_NEAR(read("quat in arm", 4)[0], 1, kExact);
}

// What an actuator exerts is before its gear, without springs and dampers; a joint's limit is for all of them together.
TEST_F(RobotSensors, actuators_read_their_own_force)
{
    load(
        R"(<mujoco><compiler autolimits="true"/><worldbody><body><joint name="a" type="slide" axis="1 0 0" stiffness="50" damping="3"/>
        <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body><body pos="1 0 0"><joint name="b" type="slide" axis="1 0 0" actuatorfrcrange="-5 5"/>
        <inertial pos="0 0 0" mass="1" diaginertia="1 1 1"/></body></worldbody>
        <tendon><fixed name="both"><joint joint="a" coef="2"/><joint joint="b" coef="-1"/></fixed></tendon>
        <actuator><position name="servo" joint="a" kp="10" gear="2"/><motor name="one" joint="b" gear="3"/><motor name="two" joint="b"/>
        <velocity name="rope" tendon="both" kv="0.5"/></actuator>
        <sensor><actuatorfrc name="servo" actuator="servo"/><actuatorfrc name="one" actuator="one"/><actuatorfrc name="rope" actuator="rope"/>
        <jointactuatorfrc name="a" joint="a"/><jointactuatorfrc name="b" joint="b"/></sensor></mujoco>)");
    dWorldSetGravity(world, 0, 0, 0);
    const dReal q[2] = {dReal(0.1), 0}, v[2] = {dReal(0.2), dReal(-0.4)};
    ASSERT_EQ(dRobotSetPositions(robot, q, 2), 1);
    ASSERT_EQ(dRobotSetVelocities(robot, v, 2), 1);
    const dReal controls[4] = {1, dReal(1.5), 2, 1};
    for (int i = 0; i < 4; ++i) ASSERT_EQ(dRobotSetControl(robot, i, controls[i]), 1);
    const double rope = 0.5 * (1 - (2 * 0.2 + 0.4));
    EXPECT_NEAR(read("servo", 1)[0], 10 * (1 - 2 * 0.1), kFine);
    EXPECT_NEAR(read("one", 1)[0], 1.5, kFine);
    EXPECT_NEAR(read("rope", 1)[0], rope, kFine);
    EXPECT_NEAR(read("a", 1)[0], 2 * 8 + 2 * rope, kFine);
    EXPECT_NEAR(read("b", 1)[0], 5, kFine);  // of 3 * 1.5 + 2 - rope
}

// Two motors ask for 6.5 N of a joint that takes 5.
TEST_F(RobotSensors, motors_of_a_joint_are_limited_together)
{
    load(
        R"(<mujoco><compiler autolimits="true"/><worldbody><body><joint type="slide" axis="1 0 0" actuatorfrcrange="-5 5" name="b"/>
        <inertial pos="0 0 0" mass="2" diaginertia="1 1 1"/></body></worldbody>
        <actuator><motor joint="b" gear="3"/><motor joint="b"/></actuator></mujoco>)");
    dWorldSetGravity(world, 0, 0, 0);
    ASSERT_EQ(dRobotSetControl(robot, 0, dReal(1.5)), 1);
    ASSERT_EQ(dRobotSetControl(robot, 1, 2), 1);
    step(1);
    dReal v = 0;
    ASSERT_EQ(dRobotGetVelocities(robot, &v, 1), 1);
    EXPECT_NEAR(v, 2.5 * kStep, kFine * kStep);
}

TEST_F(RobotSensors, touch_of_a_resting_box_is_its_weight)
{
    load(R"(<mujoco><worldbody><body name="box" pos="0.5 0 0.1"><freejoint/><site name="skin"/>
        <geom type="box" size="0.1 0.1 0.1" mass="2"/></body><geom type="plane" size="1 1 1"/></worldbody>
        <sensor><touch name="skin" site="skin"/></sensor></mujoco>)");
    step(200);
    dRobotTouch touch{};
    touch.struct_size = sizeof touch;
    ASSERT_EQ(dRobotGetTouch(robot, 1, &touch), 1);
    EXPECT_NEAR(touch.normal_force, 2 * kG, 1e-3);
    expect_vec(touch.force, 0, 0, 2 * kG, 1e-3);
    expect_vec(touch.centre, 0.5, 0, 0, 1e-3);
    EXPECT_GE(touch.points, 3);
    EXPECT_NEAR(read("skin", 1)[0], 2 * kG, 1e-3);
    ASSERT_EQ(dRobotGetTouch(robot, 0, &touch), 1);  // the floor is the robot's world
    expect_vec(touch.force, 0, 0, -2 * kG, 1e-3);
}

TEST_F(RobotSensors, a_lidar_in_a_room_measures_its_walls)
{
    load(kBox);
    dCreatePlane(space, 1, 0, 0, -2), dCreatePlane(space, -1, 0, 0, -3), dCreatePlane(space, 0, 0, 1, 0);
    const int count = 90;
    std::vector<dReal> directions, ranges(count);
    for (int i = 0; i < count; ++i) {
        const double angle = 2 * M_PI * i / count;
        directions.insert(directions.end(), {dReal(std::cos(angle)), dReal(std::sin(angle)), 0});
    }
    const dReal frame[7] = {0, 0, dReal(0.2), 1, 0, 0, 0};
    const int found =
        dRobotCastRays(robot, 1, frame, space, count, directions.data(), 8, ranges.data(), nullptr);
    int expected = 0;
    for (int i = 0; i < count; ++i) {
        const double c = std::cos(2 * M_PI * i / count), wall = c > 0 ? 3 / c : 2 / -c;
        expected += wall <= 8;
        if (wall > 8) {
            EXPECT_EQ(ranges[size_t(i)], dReal(dInfinity)) << i;
        } else {
            EXPECT_NEAR(ranges[size_t(i)], wall, kFine) << i;
        }
    }
    EXPECT_EQ(found, expected);
}

// A ball of 0.5 m, 4 m before the camera, covers a disc of tan = 0.5 / sqrt(16 - 0.25) around the middle.
TEST_F(RobotSensors, a_camera_sees_a_ball_before_a_wall)
{
    load(kBox);
    const dGeomID ball = dCreateSphere(space, dReal(0.5)), wall = dCreatePlane(space, -1, 0, 0, -6);
    dGeomSetPosition(ball, 4, 0, 1);
    dRobotCamera camera;
    dRobotCameraInit(&camera, sizeof camera);
    camera.width = 160, camera.height = 120;
    const size_t pixels = 160 * 120;
    std::vector<dReal> depth(pixels);
    std::vector<dGeomID> geoms(pixels);
    std::vector<unsigned char> color(3 * pixels);
    // -z along the world's x, y up.
    const dReal frame[7] = {0, 0, 0, dReal(0.5), dReal(0.5), dReal(-0.5), dReal(-0.5)};
    EXPECT_EQ(dRobotTakePicture(robot, 1, frame, space, &camera, depth.data(), geoms.data(), color.data()),
              int(pixels));
    const double per_pixel = 2 * std::tan(0.4) / 120, slope = 0.5 / std::sqrt(16 - 0.25);
    int seen = 0;
    for (size_t i = 0; i < pixels; ++i) {
        seen += geoms[i] == ball;
        if (geoms[i] != wall) continue;
        EXPECT_NEAR(depth[i], 6, kFine);
    }
    const double area = M_PI * slope * slope / (per_pixel * per_pixel);
    EXPECT_NEAR(seen, area, 0.02 * area);
    const size_t middle = 60 * 160 + 80;
    EXPECT_EQ(geoms[middle], ball);
    EXPECT_NEAR(depth[middle], 3.5, 1e-3);  // half a pixel off
    EXPECT_NE(color[3 * middle], color[0]);
    // A larger picture is taken in blocks of rows.
    camera.width = 400, camera.height = 300;
    std::vector<dReal> large(400 * 300);
    dRobotTakePicture(robot, 1, frame, space, &camera, large.data(), nullptr, nullptr);
    EXPECT_NEAR(large[150 * 400 + 200], 3.5, 1e-3);
    EXPECT_NEAR(large[299 * 400 + 399], 6, kFine);
    camera.width = 160, camera.height = 120;
    camera.threads = 4;
    std::vector<dReal> again(pixels);
    dRobotTakePicture(robot, 1, frame, space, &camera, again.data(), nullptr, nullptr);
    EXPECT_EQ(depth, again);
}

TEST_F(RobotSensors, say_what_they_refuse)
{
    load(kBox);
    static int refused;
    refused = 0;
    dSetMessageHandler([](int, const char*, va_list) { ++refused; });
    dVector3 v;
    dRobotTouch touch{};
    dRobotCamera camera;
    dReal range;
    const dReal nowhere[3] = {0, 0, 0}, frame[7] = {0, 0, 0, 0, 0, 0, 0};
    EXPECT_EQ(dRobotGetImu(robot, 1, nullptr, v, v), 0);  // before any step
    EXPECT_EQ(dRobotGetImu(robot, 7, nullptr, v, v), 0);
    EXPECT_EQ(dRobotGetImu(robot, 1, frame, v, v), 0);
    EXPECT_EQ(dRobotUpdateSensors(robot, 0), 0);
    EXPECT_EQ(dRobotGetForceTorque(robot, 1, nullptr, v, v), 0);
    EXPECT_EQ(dRobotSetForceSensor(robot, 1, 1), 0);  // free
    EXPECT_EQ(dRobotGetTouch(robot, 1, &touch), 0);
    EXPECT_EQ(dRobotCastRays(robot, 1, nullptr, space, 1, nowhere, 1, &range, nullptr), 0);
    EXPECT_EQ(dRobotCastRays(robot, 1, nullptr, nullptr, 0, nullptr, 1, nullptr, nullptr), 0);
    dRobotCameraInit(&camera, sizeof camera);
    camera.field = 4;
    EXPECT_EQ(dRobotTakePicture(robot, 1, nullptr, space, &camera, nullptr, nullptr, nullptr), 0);
    EXPECT_EQ(dRobotReadSensor(robot, 0, space, v, 3), 0);
    EXPECT_EQ(refused, 11);
}

}  // namespace
