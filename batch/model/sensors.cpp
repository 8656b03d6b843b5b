// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See sensors.h. What a kind reads is in lanes/sensors.h; which numbers it has, in robots/sensor_kinds.h. A batch has no rays, and no geoms whose distances it could measure; it counts no time.
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
                  {"jointlimitpos", SensorKind::kLimitPlace},
                  {"jointlimitvel", SensorKind::kLimitRate},
                  {"jointlimitfrc", SensorKind::kLimitForce},
                  {"jointactuatorfrc", SensorKind::kJointForce},
                  {"actuatorfrc", SensorKind::kActuatorForce},
                  {"actuatorpos", SensorKind::kActuatorLength},
                  {"actuatorvel", SensorKind::kActuatorRate},
                  {"tendonpos", SensorKind::kTendonLength},
                  {"tendonvel", SensorKind::kTendonRate},
                  {"tendonlimitpos", SensorKind::kTendonLimitPlace},
                  {"tendonlimitvel", SensorKind::kTendonLimitRate},
                  {"tendonlimitfrc", SensorKind::kTendonLimitForce},
                  {"e_kinetic", SensorKind::kKinetic},
                  {"e_potential", SensorKind::kPotential},
                  {"framepos", SensorKind::kPlace},
                  {"framequat", SensorKind::kTurn},
                  {"framexaxis", SensorKind::kAxisX},
                  {"frameyaxis", SensorKind::kAxisY},
                  {"framezaxis", SensorKind::kAxisZ},
                  {"framelinvel", SensorKind::kLinear},
                  {"frameangvel", SensorKind::kAngular},
                  {"velocimeter", SensorKind::kVelocimeter},
                  {"gyro", SensorKind::kGyro},
                  {"magnetometer", SensorKind::kMagnetometer},
                  {"subtreecom", SensorKind::kCentre},
                  {"subtreelinvel", SensorKind::kCentreVelocity},
                  {"subtreeangmom", SensorKind::kMomentum},
                  {"accelerometer", SensorKind::kAccelerometer},
                  {"framelinacc", SensorKind::kLinearAcceleration},
                  {"frameangacc", SensorKind::kTurningAcceleration},
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
    const bool wants_axis = its.kind >= SensorKind::kLimitPlace && its.kind <= SensorKind::kJointForce;
    if (wants_axis && !joint.is_scalar()) return false;
    if ((is_position ? joint.coordinates() : velocities_of(joint)) != its.values) return false;
    its.object = is_position ? joint.position : out.joints[size_t(number)].dof;
    return true;
}

bool find_frame(BatchModel& out, const RobotModel& model, const Sensor& sensor, BatchSensor& its)
{
    Frame frame, reference;
    if (!model.object_named(sensor.object_type, sensor.object, frame)) return false;
    // A link that has become part of another one has no subtree of its own.
    const bool is_subtree = its.kind >= SensorKind::kCentre && its.kind <= SensorKind::kMomentum;
    if (is_subtree && model.links[size_t(frame.link)].name != sensor.object) return false;
    its.link = frame.link, its.first = add_frame(out, frame.pose);
    if (its.kind == SensorKind::kMagnetometer) {
        const Vec field = model.magnetic;
        its.reference_first = int(out.numbers.size());
        out.numbers.insert(out.numbers.end(), {field.x, field.y, field.z});
    }
    if (sensor.reference.empty()) return true;
    if (!model.object_named(sensor.reference_type, sensor.reference, reference)) return false;
    its.reference = reference.link, its.reference_first = add_frame(out, reference.pose);
    return true;
}

// Of a tendon with a path: none.
bool find_sum(const std::vector<int>& sums, const RobotModel& model, const Sensor& sensor, BatchSensor& its)
{
    const int tendon = model.tendon_named(sensor.object);
    its.object = tendon < 0 ? -1 : sums[size_t(tendon)];
    return its.object >= 0;
}

void set_cutoff(const Sensor& sensor, BatchSensor& its)
{
    const SensorRange range = range_of_sensor(sensor.kind);
    if (!(sensor.cutoff > 0) || range == SensorRange::kNone) return;
    constexpr double kNoBound = 1e30;
    its.low = range == SensorRange::kPositive ? -kNoBound : -sensor.cutoff, its.high = sensor.cutoff;
}

bool find(BatchModel& out, const RobotModel& model, const std::vector<int>& sums, const Sensor& sensor,
          BatchSensor& its)
{
    const auto kind = kind_of(sensor.kind);
    if (!kind) return false;
    its.kind = *kind, its.values = values_of(sensor.kind), its.is_on_child = sensor.is_on_child;
    set_cutoff(sensor, its);
    if (its.kind <= SensorKind::kJointForce) return find_joint(out, model, sensor, its);
    if (its.kind > SensorKind::kPotential) return find_frame(out, model, sensor, its);
    if (its.kind >= SensorKind::kKinetic) return true;
    if (its.kind > SensorKind::kActuatorRate) return find_sum(sums, model, sensor, its);
    its.object = model.actuator_named(sensor.object);
    return its.object >= 0;
}

}  // namespace

void add_sensors(BatchModel& out, const RobotModel& model, const std::vector<int>& sums)
{
    for (const Sensor& sensor : model.sensors) {
        BatchSensor its;
        if (!find(out, model, sums, sensor, its)) its = {};
        its.address = out.sensor_values, out.sensor_values += its.values;
        const bool is_accelerated = its.kind >= SensorKind::kAccelerometer && its.kind <= SensorKind::kTorque;
        if (its.values > 0 && is_accelerated) out.accelerations = int(out.dofs.size());
        out.sensors.push_back(its);
    }
}

}  // namespace epode::batch
