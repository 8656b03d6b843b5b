// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See sensors.h. What a kind reads is in lanes/sensors.h; which numbers it has, in robots/sensor_kinds.h. A batch has no rays.
#include "batch/model/sensors.h"

#include <array>
#include <optional>

#include "robots/kinematics.h"
#include "robots/sensor_kinds.h"

namespace epode::batch {

using namespace robots;

namespace {

std::optional<SensorKind> kind_of(const std::string& name)
{
    static constexpr struct {
        const char* name;
        SensorKind kind;
    } kKinds[] = {{"jointpos", SensorKind::kPosition},
                  {"ballquat", SensorKind::kPosition},
                  {"jointvel", SensorKind::kVelocity},
                  {"ballangvel", SensorKind::kVelocity},
                  {"jointactuatorfrc", SensorKind::kJointForce},
                  {"actuatorfrc", SensorKind::kActuatorForce},
                  {"actuatorpos", SensorKind::kActuatorLength},
                  {"actuatorvel", SensorKind::kActuatorRate},
                  {"framepos", SensorKind::kPlace},
                  {"framequat", SensorKind::kTurn},
                  {"framexaxis", SensorKind::kAxisX},
                  {"frameyaxis", SensorKind::kAxisY},
                  {"framezaxis", SensorKind::kAxisZ},
                  {"framelinvel", SensorKind::kLinear},
                  {"frameangvel", SensorKind::kAngular},
                  {"velocimeter", SensorKind::kVelocimeter},
                  {"gyro", SensorKind::kGyro},
                  {"subtreecom", SensorKind::kCentre},
                  {"subtreelinvel", SensorKind::kCentreVelocity},
                  {"accelerometer", SensorKind::kAccelerometer},
                  {"force", SensorKind::kForce},
                  {"torque", SensorKind::kTorque},
                  {"touch", SensorKind::kTouch}};
    for (const auto& its : kKinds)
        if (name == its.name) return its.kind;
    return {};
}

int add_frame(BatchModel& out, const Pose& at)
{
    const int first = int(out.numbers.size());
    out.numbers.insert(out.numbers.end(), {at.p.x, at.p.y, at.p.z, at.q.w, at.q.x, at.q.y, at.q.z});
    return first;
}

// False: on nothing that the model has, or that a joint of this kind has not.
bool find_joint(const BatchModel& out, const RobotModel& model, const Sensor& sensor, BatchSensor& its)
{
    const int number = model.joint_named(sensor.object);
    if (number < 0) return false;
    const Joint& joint = model.joints[size_t(number)];
    const bool is_position = its.kind == SensorKind::kPosition;
    if (its.kind == SensorKind::kJointForce && !joint.is_scalar()) return false;
    if ((is_position ? joint.coordinates() : velocities_of(joint)) != its.values) return false;
    its.object = is_position ? joint.position : out.joints[size_t(number)].dof;
    return true;
}

bool find_frame(BatchModel& out, const RobotModel& model, const Sensor& sensor, BatchSensor& its)
{
    Frame frame, reference;
    if (!model.object_named(sensor.object_type, sensor.object, frame)) return false;
    // A link that has become part of another one has no subtree of its own.
    const bool is_subtree = its.kind == SensorKind::kCentre || its.kind == SensorKind::kCentreVelocity;
    if (is_subtree && model.links[size_t(frame.link)].name != sensor.object) return false;
    its.link = frame.link, its.first = add_frame(out, frame.pose);
    if (sensor.reference.empty()) return true;
    if (!model.object_named(sensor.reference_type, sensor.reference, reference)) return false;
    its.reference = reference.link, its.reference_first = add_frame(out, reference.pose);
    return true;
}

bool find(BatchModel& out, const RobotModel& model, const Sensor& sensor, BatchSensor& its)
{
    const auto kind = kind_of(sensor.kind);
    if (!kind) return false;
    its.kind = *kind, its.values = values_of(sensor.kind), its.is_on_child = sensor.is_on_child;
    if (its.kind <= SensorKind::kJointForce) return find_joint(out, model, sensor, its);
    if (its.kind > SensorKind::kActuatorRate) return find_frame(out, model, sensor, its);
    its.object = model.actuator_named(sensor.object);
    return its.object >= 0;
}

}  // namespace

void add_sensors(BatchModel& out, const RobotModel& model)
{
    for (const Sensor& sensor : model.sensors) {
        BatchSensor its;
        if (!find(out, model, sensor, its)) its = {};
        its.address = out.sensor_values, out.sensor_values += its.values;
        const bool is_accelerated = its.kind >= SensorKind::kAccelerometer && its.kind <= SensorKind::kTorque;
        if (its.values > 0 && is_accelerated) out.accelerations = int(out.dofs.size());
        out.sensors.push_back(its);
    }
}

}  // namespace epode::batch
