// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The sensors that a file names, by MJCF's kinds: see sensors.h.
#include <algorithm>

#include "robots/energy.h"
#include "robots/kinematics.h"
#include "robots/sensor_kinds.h"
#include "robots/sensors.h"
#include "robots/zone.h"

namespace epode::robots {

namespace {

std::vector<double> list_of(Vec v) { return {v.x, v.y, v.z}; }

}  // namespace

std::vector<double> Sensors::read_joint(const Sensor& sensor) const
{
    const RobotModel& model = robot_.model();
    if (sensor.kind.starts_with("actuator")) {
        const int actuator = model.actuator_named(sensor.object);
        if (actuator < 0) return {};
        if (sensor.kind == "actuatorfrc") return {robot_.actuator_force(actuator)};
        const Robot::Stroke its = robot_.stroke(actuator);
        return {sensor.kind == "actuatorpos" ? its.length : its.rate};
    }
    if (sensor.kind.find("limit") != std::string::npos) return read_limit(sensor);
    if (sensor.kind.starts_with("tendon")) return read_tendon(sensor);
    const int number = model.joint_named(sensor.object);
    if (number < 0) return {};
    if (sensor.kind == "jointactuatorfrc") {
        if (!model.joints[size_t(number)].is_scalar()) return {};
        return {robot_.actuators_force(number)};
    }
    const Joint& joint = model.joints[size_t(number)];
    int first = 0;
    for (int i = 0; i < number; ++i) first += velocities_of(model.joints[size_t(i)]);
    const bool is_position = sensor.kind == "jointpos" || sensor.kind == "ballquat";
    const std::vector<double> all = is_position ? robot_.positions() : robot_.velocities();
    const int begin = is_position ? joint.position : first, count = values_of(sensor.kind);
    const int has = is_position ? joint.coordinates() : velocities_of(joint);
    if (has != count) return {};
    return {all.begin() + begin, all.begin() + begin + count};
}

std::vector<double> Sensors::read_tendon(const Sensor& sensor) const
{
    const int number = robot_.model().tendon_named(sensor.object);
    if (number < 0) return {};
    if (sensor.kind == "tendonactuatorfrc") return {robot_.actuators_force_of_tendon(number)};
    const Robot::Stroke its = robot_.tendon_stroke(number);
    return {sensor.kind == "tendonpos" ? its.length : its.rate};
}

// How far it is beyond, below 0, how fast that changes, and what the limit exerts; 0 within. Of a ball's limit the latter alone.
std::vector<double> Sensors::read_limit(const Sensor& sensor) const
{
    const RobotModel& model = robot_.model();
    const bool of_tendon = sensor.kind.starts_with("tendon");
    const int number = of_tendon ? model.tendon_named(sensor.object) : model.joint_named(sensor.object);
    if (number < 0) return {};
    if (sensor.kind.ends_with("frc"))
        return {of_tendon ? robot_.tendon_limit_force(number) : robot_.joint_limit_force(number)};
    if (!of_tendon && !model.joints[size_t(number)].is_scalar()) return {};
    const Robot::Stroke its = of_tendon ? robot_.tendon_stroke(number) : robot_.joint_stroke(number);
    const auto [low, high] =
        of_tendon ? std::pair(model.tendons[size_t(number)].low, model.tendons[size_t(number)].high)
                  : std::pair(model.joints[size_t(number)].low, model.joints[size_t(number)].high);
    const bool is_low = its.length<low, is_high = its.length> high;
    const double sign = is_low ? 1 : is_high ? -1 : 0;
    if (sign == 0) return {0};
    return {sensor.kind.ends_with("pos") ? sign * (its.length - (is_low ? low : high)) : sign * its.rate};
}

// As an accelerometer's, gravity in it, in the world's axes; or of the turning.
std::vector<double> Sensors::read_acceleration(const Sensor& sensor, const Frame& frame) const
{
    Vec force, rate;
    if (!imu(frame.link, frame.pose, force, rate)) return {};
    const Motion &a = before_[size_t(frame.link)], &b = now_[size_t(frame.link)];
    if (sensor.kind == "frameangacc")
        return list_of((1 / stepsize_) * (rotate(b.pose.q, b.angular) - rotate(a.pose.q, a.angular)));
    return list_of(rotate((link_pose(frame.link) * frame.pose).q, force));
}

Sensors::Seen Sensors::seen(const Frame& frame) const
{
    const Pose at = link_pose(frame.link) * frame.pose;
    const Motion motion = motion_now()[size_t(frame.link)];
    const Vec angular = rotate(motion.pose.q, motion.angular);
    return {at, rotate(motion.pose.q, motion.linear) + cross(angular, at.p - motion.pose.p), angular};
}

// Of the frame's origin, in the axes of the world or of the reference, which sees it move; a velocimeter's in its own.
std::vector<double> Sensors::read_motion(const Sensor& sensor, const Frame& frame) const
{
    Seen its = seen(frame);
    if (sensor.kind == "velocimeter") return list_of(rotate(conjugate(its.at.q), its.linear));
    if (!sensor.reference.empty()) {
        Frame reference;
        if (!robot_.model().object_named(sensor.reference_type, sensor.reference, reference)) return {};
        const Seen from = seen(reference);
        const Quat back = conjugate(from.at.q);
        const Vec carried = from.linear + cross(from.angular, its.at.p - from.at.p);
        its = {inverse(from.at) * its.at, rotate(back, its.linear - carried),
               rotate(back, its.angular - from.angular)};
    }
    const Quat q = its.at.q;
    if (sensor.kind == "framexaxis") return list_of(rotate(q, {1, 0, 0}));
    if (sensor.kind == "frameyaxis") return list_of(rotate(q, {0, 1, 0}));
    if (sensor.kind == "framezaxis") return list_of(rotate(q, {0, 0, 1}));
    if (sensor.kind == "framepos") return list_of(its.at.p);
    if (sensor.kind == "framequat") return {q.w, q.x, q.y, q.z};
    return list_of(sensor.kind == "frameangvel" ? its.angular : its.linear);
}

// Of a link and all that hangs on it: the centre of mass, its velocity, or the angular momentum about it. Not of links that have become part of others.
std::vector<double> Sensors::read_subtree(const Sensor& sensor, int root) const
{
    const auto& links = robot_.model().links;
    if (links[size_t(root)].name != sensor.object) return {};
    const std::vector<Motion> motions = motion_now();
    std::vector<bool> hangs(links.size());
    double mass = 0;
    Vec sum, momentum, about_origin, centre;
    for (size_t i = size_t(root); i < links.size(); ++i) {
        hangs[i] = int(i) == root || (links[i].parent >= 0 && hangs[size_t(links[i].parent)]);
        if (!hangs[i] || i == 0) continue;
        const Motion& its = motions[i];
        const Vec of = sensor.kind == "subtreecom" ? its.pose.p : rotate(its.pose.q, its.linear);
        mass += links[i].mass, sum = sum + links[i].mass * of;
        const Vec p = links[i].mass * rotate(its.pose.q, its.linear);
        momentum = momentum + p, centre = centre + links[i].mass * its.pose.p;
        about_origin =
            about_origin + cross(its.pose.p, p) + rotate(its.pose.q, apply(links[i].inertia, its.angular));
    }
    if (sensor.kind == "subtreeangmom" && mass > 0)
        return list_of(about_origin - cross((1 / mass) * centre, momentum));
    return mass > 0 ? list_of((1 / mass) * sum) : std::vector<double>{};
}

// Of the shapes of one name and those of another: the least distance, its direction, or the points where it is, within the cutoff.
std::vector<double> Sensors::read_distance(const Sensor& sensor)
{
    const RobotModel& model = robot_.model();
    const auto one = shapes_of(model, sensor.object_type, sensor.object),
               two = shapes_of(model, sensor.reference_type, sensor.reference);
    if (one.empty() || two.empty()) return {};
    if (!distances_) distances_ = std::make_unique<ShapeDistances>(robot_.prepared());
    std::vector<Pose> poses;
    for (size_t i = 0; i < model.links.size(); ++i) poses.push_back(link_pose(int(i)));
    const ShapeDistance its = distances_->find(poses, one, two, sensor.cutoff);
    if (sensor.kind == "distance") return {its.distance};
    if (sensor.kind == "fromto") return {its.from.x, its.from.y, its.from.z, its.to.x, its.to.y, its.to.z};
    const double size = length(its.to - its.from);
    return list_of(size > 0 ? (1 / size) * (its.to - its.from) : Vec{});
}

// 1 where a frame's origin is in the volume of a site; one that says no size is MuJoCo's ball of 5 mm.
std::vector<double> Sensors::read_inside(const Sensor& sensor, const Frame& frame) const
{
    Frame zone;
    if (!robot_.model().object_named("site", sensor.reference, zone)) return {};
    if (!(zone.size.x > 0)) zone.size = {0.005, 0.005, 0.005};
    const Vec at = link_pose(frame.link) * frame.pose.p;
    return {is_in_zone(zone.zone, zone.size, inverse(link_pose(zone.link) * zone.pose) * at) ? 1.0 : 0.0};
}

std::vector<double> Sensors::read(int number, dSpaceID space, std::string& problem)
{
    const Sensor& sensor = robot_.model().sensors[size_t(number)];
    std::vector<double> out = read_uncut(sensor, space, problem);
    const SensorRange range = range_of_sensor(sensor.kind);
    if (!(sensor.cutoff > 0) || range == SensorRange::kNone) return out;
    for (double& value : out)
        value =
            std::clamp(value, range == SensorRange::kPositive ? -kInfinity : -sensor.cutoff, sensor.cutoff);
    return out;
}

std::vector<double> Sensors::read_uncut(const Sensor& sensor, dSpaceID space, std::string& problem)
{
    problem = "a sensor that is computed, on something that the model has";
    if (sensor.kind == "clock") return {robot_.time()};
    if (values_of_geom_sensor(sensor.kind)) return read_distance(sensor);
    if (values_of_whole_sensor(sensor.kind))
        return {sensor.kind == "e_kinetic" ? kinetic_energy(robot_) : potential_energy(robot_, gravity())};
    if (values_of_joint_sensor(sensor.kind)) return read_joint(sensor);
    Frame frame;
    if (!values_of_frame_sensor(sensor.kind) ||
        !robot_.model().object_named(sensor.object_type, sensor.object, frame))
        return {};
    Vec first, second;
    if (sensor.kind == "framelinacc" || sensor.kind == "frameangacc") {
        problem = "dRobotUpdateSensors after every step";
        return read_acceleration(sensor, frame);
    }
    if (sensor.kind == "accelerometer" || sensor.kind == "gyro") {
        problem = "dRobotUpdateSensors after every step";
        if (!imu(frame.link, frame.pose, first, second)) return {};
        return list_of(sensor.kind == "gyro" ? second : first);
    }
    if (sensor.kind == "force" || sensor.kind == "torque") {
        problem = "a link that a joint holds";
        if (!force_torque(frame.link, frame.pose, first, second)) return {};
        const Vec its = sensor.kind == "force" ? first : second;
        return list_of(sensor.is_on_child ? -its : its);
    }
    if (sensor.kind == "insidesite") return read_inside(sensor, frame);
    if (sensor.kind.starts_with("subtree")) return read_subtree(sensor, frame.link);
    if (sensor.kind == "touch") return {touch(frame.link, frame.size.x > 0 ? &frame : nullptr).normal_force};
    if (sensor.kind == "magnetometer")
        return list_of(rotate(conjugate((link_pose(frame.link) * frame.pose).q),
                              rotate(robot_.placement().q, robot_.model().magnetic)));
    if (sensor.kind != "rangefinder") return read_motion(sensor, frame);
    problem = "a space for a rangefinder's ray";
    if (!space) return {};
    std::vector<dQueryHit> hits;
    cast(frame.link, frame.pose, space, {{0, 0, 1}}, double(dInfinity), 1, hits);
    return {hits[0].geom ? double(hits[0].distance) : -1};
}

}  // namespace epode::robots
