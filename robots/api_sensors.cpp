// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of epode/robot_sensors.h: see api.h.
#include "epode/robot_sensors.h"

#include "robots/api.h"
#include "robots/body_poses.h"
#include "robots/kinematics.h"
#include "robots/sensor_kinds.h"

using namespace epode::robots;

namespace {

constexpr const char* kSensor = "a robot, the number of a link, and NULL or a finite pose with a quaternion";
constexpr int kMaxPixels = 8192;
constexpr double kHalfTurn = 3.14159;

bool has_link(dRobotID robot, int link)
{
    return robot && link >= 0 && link < int(robot->robot->model().links.size());
}

bool is_sensor(dRobotID robot, int link, const dReal* frame)
{
    if (!has_link(robot, link)) return false;
    if (!frame) return true;
    const dReal* q = frame + 3;
    return are_usable(frame, 7) && q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3] > 0;
}

Pose pose_of(const dReal* frame)
{
    if (!frame) return {};
    return {vec_of(frame), normalised(quat_of(frame + 3))};
}

void write(Vec v, dReal* out)
{
    for (int i = 0; out && i < 3; ++i) out[i] = dReal(v[i]);
}

bool is_good(const dRobotCamera& camera)
{
    const bool sides =
        camera.width > 0 && camera.height > 0 && camera.width <= kMaxPixels && camera.height <= kMaxPixels;
    return camera.struct_size == sizeof(dRobotCamera) && sides && camera.threads >= 0 && camera.field > 0 &&
           double(camera.field) < kHalfTurn && camera.max_distance > 0 && is_distance(camera.max_distance);
}

}  // namespace

int dRobotUpdateSensors(dRobotID robot, dReal stepsize)
{
    robot = alive(robot);
    CHECK(robot && is_usable(stepsize) && stepsize > 0 && is_usable(1 / stepsize),
          "a robot and a positive step size");
    return guarded(__func__, [&] {
        robot->sensors->update(double(stepsize));
        return 1;
    });
}

int dRobotGetDriveForces(dRobotID robot, dReal* forces, int capacity)
{
    robot = alive(robot);
    CHECK(robot && capacity >= 0 && (forces || capacity == 0),
          "a robot, a capacity of 0 or more, and an array unless it is 0");
    return guarded(__func__,
                   [&] { return copy_positions(robot->sensors->drive_forces(), forces, capacity); });
}

int dRobotGetImu(dRobotID robot, int link, const dReal* frame, dReal* specific_force, dReal* angular_velocity)
{
    robot = alive(robot);
    CHECK(is_sensor(robot, link, frame), kSensor);
    Vec force, rate;
    CHECK(robot->sensors->imu(link, pose_of(frame), force, rate),
          "dRobotUpdateSensors after every step, and at least one");
    write(force, specific_force), write(rate, angular_velocity);
    return 1;
}

int dRobotSetForceSensor(dRobotID robot, int link, int mode)
{
    robot = alive(robot);
    CHECK(has_link(robot, link) && (mode == 0 || mode == 1), "a robot, the number of a link, and 0 or 1");
    return guarded(__func__, [&] {
        return int(check(robot->sensors->watch_force(link, mode == 1), "dRobotSetForceSensor",
                         "a link that a joint holds"));
    });
}

int dRobotGetForceTorque(dRobotID robot, int link, const dReal* frame, dReal* force, dReal* torque)
{
    robot = alive(robot);
    CHECK(is_sensor(robot, link, frame), kSensor);
    Vec f, t;
    CHECK(robot->sensors->force_torque(link, pose_of(frame), f, t), "a link with dRobotSetForceSensor");
    write(f, force), write(t, torque);
    return 1;
}

int dRobotGetTouch(dRobotID robot, int link, dRobotTouch* touch)
{
    robot = alive(robot);
    CHECK(has_link(robot, link) && touch && touch->struct_size == sizeof(dRobotTouch),
          "a robot, the number of a link, and a structure with its size");
    return guarded(__func__, [&] {
        const Touch its = robot->sensors->touch(link);
        *touch = {touch->struct_size, its.points, dReal(its.normal_force), {}, {}};
        write(its.force, touch->force), write(its.centre, touch->centre);
        return 1;
    });
}

int dRobotCastRays(dRobotID robot, int link, const dReal* frame, dSpaceID space, int count,
                   const dReal* directions, dReal max_distance, dReal* ranges, dGeomID* geoms)
{
    robot = alive(robot);
    CHECK(is_sensor(robot, link, frame), kSensor);
    CHECK(is_space(space) && count >= 0 && is_distance(max_distance),
          "a space, and a count and a distance of 0 or more");
    CHECK(count == 0 || (directions && ranges && are_directions(directions, count)),
          "finite directions that are not 0, and an array of ranges");
    return guarded(__func__, [&] {
        std::vector<Vec> ways;
        for (int i = 0; i < count; ++i) ways.push_back(vec_of(directions + 3 * size_t(i)));
        std::vector<dQueryHit> hits;
        const int found =
            robot->sensors->cast(link, pose_of(frame), space, ways, double(max_distance), 1, hits);
        for (int i = 0; i < count; ++i) {
            const dQueryHit& hit = hits[size_t(i)];
            ranges[i] = hit.geom ? hit.distance : dReal(dInfinity);
            if (geoms) geoms[i] = hit.geom;
        }
        return found;
    });
}

int dRobotCameraInit(dRobotCamera* camera, unsigned struct_size)
{
    CHECK(camera && struct_size == sizeof(dRobotCamera), "a structure and its size, sizeof(dRobotCamera)");
    *camera = {struct_size, 320, 240, dReal(0.8), 100, 1};
    return 1;
}

int dRobotTakePicture(dRobotID robot, int link, const dReal* frame, dSpaceID space,
                      const dRobotCamera* camera, dReal* depth, dGeomID* geoms, unsigned char* color)
{
    robot = alive(robot);
    CHECK(is_sensor(robot, link, frame), kSensor);
    CHECK(is_space(space) && camera && is_good(*camera),
          "a space, and a camera with its size, sides of 1 ... 8192 pixels, a field between 0 and pi, a "
          "positive distance and 0 or more threads");
    return guarded(__func__, [&] {
        const View view{camera->width, camera->height, camera->threads, double(camera->field),
                        double(camera->max_distance)};
        return robot->sensors->take_picture(link, pose_of(frame), space, view, {depth, geoms, color});
    });
}

int dRobotModelGetSensors(dRobotModelID model, dRobotSensor* sensors, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (sensors || capacity == 0),
          "a model, a capacity of 0 or more, and an array unless it is 0");
    const auto& all = model->model.sensors;
    for (int i = 0; i < std::min(capacity, int(all.size())); ++i) {
        const Sensor& its = all[size_t(i)];
        sensors[i] = {its.name.c_str(), its.kind.c_str(), its.object.c_str(), values_of(its.kind)};
    }
    return int(all.size());
}

int dRobotReadSensor(dRobotID robot, int sensor, dSpaceID space, dReal* values, int capacity)
{
    robot = alive(robot);
    CHECK(robot && sensor >= 0 && sensor < int(robot->robot->model().sensors.size()) && capacity >= 0 &&
              (values || capacity == 0),
          "a robot, the number of a sensor, a capacity of 0 or more, and an array unless it is 0");
    CHECK(!space || is_space(space), "a space or NULL");
    return guarded(__func__, [&] {
        std::string problem;
        const std::vector<double> all = robot->sensors->read(sensor, space, problem);
        if (!check(!all.empty(), "dRobotReadSensor", problem.c_str())) return 0;
        return copy_positions(all, values, capacity);
    });
}
