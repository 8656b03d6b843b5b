// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The sensors that a file names, by MJCF's kinds: see sensors.h.
#include <algorithm>

#include "robots/kinematics.h"
#include "robots/sensor_kinds.h"
#include "robots/sensors.h"

namespace epode::robots {

namespace {

std::vector<double> list_of(Vec v) { return {v.x, v.y, v.z}; }

int joint_of(const RobotModel& model, const Sensor& sensor)
{
    if (sensor.kind != "actuatorfrc") return model.joint_named(sensor.object);
    for (const Actuator& actuator : model.actuators)
        if (actuator.name == sensor.object) return actuator.joint;
    return -1;
}

}  // namespace

std::vector<double> Sensors::read_joint(const Sensor& sensor) const
{
    const RobotModel& model = robot_.model();
    const int number = joint_of(model, sensor);
    if (number < 0) return {};
    const Joint& joint = model.joints[size_t(number)];
    int first = 0;
    for (int i = 0; i < number; ++i) first += velocities_of(model.joints[size_t(i)]);
    const bool is_position = sensor.kind == "jointpos" || sensor.kind == "ballquat";
    const bool is_force = sensor.kind == "actuatorfrc" || sensor.kind == "jointactuatorfrc";
    const std::vector<double> all = is_position ? robot_.positions()
                                    : is_force  ? drive_forces()
                                                : robot_.velocities();
    const int begin = is_position ? joint.position : first, count = values_of(sensor.kind);
    const int has = is_position ? joint.coordinates() : velocities_of(joint);
    if (has != count) return {};
    return {all.begin() + begin, all.begin() + begin + count};
}

// Of the frame's origin, in the world's axes; a velocimeter's in its own.
std::vector<double> Sensors::read_motion(const Sensor& sensor, const Frame& frame) const
{
    const Pose at = link_pose(frame.link) * frame.pose;
    if (sensor.kind == "framepos") return list_of(at.p);
    if (sensor.kind == "framequat") return {at.q.w, at.q.x, at.q.y, at.q.z};
    const Motion motion = motion_now()[size_t(frame.link)];
    const Vec angular = rotate(motion.pose.q, motion.angular);
    const Vec linear = rotate(motion.pose.q, motion.linear) + cross(angular, at.p - motion.pose.p);
    if (sensor.kind == "frameangvel") return list_of(angular);
    if (sensor.kind == "framelinvel") return list_of(linear);
    return list_of(rotate(conjugate(at.q), linear));
}

std::vector<double> Sensors::read(int number, dSpaceID space, std::string& problem) const
{
    const Sensor& sensor = robot_.model().sensors[size_t(number)];
    problem = "a sensor that is computed, on something that the model has";
    if (values_of_joint_sensor(sensor.kind)) return read_joint(sensor);
    Frame frame;
    if (!values_of_frame_sensor(sensor.kind) || !robot_.model().frame_named(sensor.object, frame)) return {};
    Vec first, second;
    if (sensor.kind == "accelerometer" || sensor.kind == "gyro") {
        problem = "dRobotUpdateSensors after every step";
        if (!imu(frame.link, frame.pose, first, second)) return {};
        return list_of(sensor.kind == "gyro" ? second : first);
    }
    if (sensor.kind == "force" || sensor.kind == "torque") {
        problem = "a link that a joint holds";
        if (!force_torque(frame.link, frame.pose, first, second)) return {};
        return list_of(sensor.kind == "force" ? first : second);
    }
    if (sensor.kind == "touch") return {touch(frame.link).normal_force};
    if (sensor.kind != "rangefinder") return read_motion(sensor, frame);
    problem = "a space for a rangefinder's ray";
    if (!space) return {};
    std::vector<dQueryHit> hits;
    cast(frame.link, frame.pose, space, {{0, 0, 1}}, double(dInfinity), 1, hits);
    return {hits[0].geom ? double(hits[0].distance) : -1};
}

}  // namespace epode::robots
