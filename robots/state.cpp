// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a robot has in addition to its world's state, as numbers: of each actuator control, activation and input; whether filters act;
// of each joint stiffness, damping and target of its servo; of each spatial tendon with friction or armature its past; of each tie what it
// took to hold it; the time, where the file has a clock. A world's state has the drives that follow from them.
#include <ode/ext.h>

#include <algorithm>
#include <cmath>

#include "robots/build.h"

namespace epode::robots {

// A world takes states of worlds with drives on the same joints only. So all that a control or target may drive have theirs
// from the beginning, empty ones too.
void Robot::make_drives()
{
    for (size_t i = 0; i < joints_.size(); ++i)
        if (joints_[i] && model().joints[i].is_scalar()) dJointSetDrive(joints_[i], 0, nullptr);
    for (dJointID its : turns_)
        for (int axis = 0; its && axis < 3; ++axis) dJointSetDrive(its, axis, nullptr);
    for (dJointID tendon : tendons_)
        if (tendon) dJointSetDrive(tendon, 0, nullptr);
}

std::vector<double> Robot::state() const
{
    std::vector<double> out;
    for (const auto* values : {&controls_, &activations_, &inputs_})
        out.insert(out.end(), values->begin(), values->end());
    out.push_back(filters_act_);
    for (const Servo& servo : servos_) out.insert(out.end(), {servo.stiffness, servo.damping, servo.target});
    for (size_t i = 0; i < pasts_.size(); ++i)
        if (const Past& its = pasts_[i]; has_past(int(i)))
            out.insert(out.end(), {double(its.is_known), its.rate, its.inertia, its.hold});
    out.insert(out.end(), holds_.begin(), holds_.end());
    if (has_clock()) out.push_back(time_);
    return out;
}

// Within its range, or as at first.
bool Robot::can_be_control(size_t actuator, double value) const
{
    const Actuator& its = model().actuators[actuator];
    return value == 0 || value == std::clamp(value, its.low, its.high);
}

size_t Robot::state_size() const
{
    size_t with_past = 0;
    for (size_t i = 0; i < pasts_.size(); ++i) with_past += has_past(int(i));
    return 3 * controls_.size() + 1 + 3 * servos_.size() + 4 * with_past + holds_.size() + has_clock();
}

bool Robot::has_clock() const
{
    return std::any_of(model().sensors.begin(), model().sensors.end(),
                       [](const Sensor& sensor) { return sensor.kind == "clock"; });
}

bool Robot::is_state(const std::vector<double>& numbers) const
{
    const size_t servos = 3 * controls_.size() + 1;
    const size_t pasts = servos + 3 * servos_.size(), last = state_size() - holds_.size() - has_clock();
    if (numbers.size() != state_size()) return false;
    for (size_t i = pasts; i < last; i += 4)
        if (numbers[i] != 0 && numbers[i] != 1) return false;
    if (!std::all_of(numbers.begin(), numbers.end(), [](double x) { return std::isfinite(x); })) return false;
    for (size_t i = 0; i < controls_.size(); ++i)
        if (!can_be_control(i, numbers[i])) return false;
    for (size_t i = servos; i < pasts; i += 3)
        if (numbers[i] < 0 || numbers[i + 1] < 0) return false;
    return numbers[servos - 1] == 0 || numbers[servos - 1] == 1;
}

bool Robot::set_state(const std::vector<double>& numbers)
{
    if (!is_state(numbers)) return false;
    const double* from = numbers.data();
    for (auto* values : {&controls_, &activations_, &inputs_}) {
        std::copy_n(from, values->size(), values->begin());
        from += values->size();
    }
    filters_act_ = *from++ == 1;
    for (Servo& servo : servos_) servo = {from[0], from[1], from[2]}, from += 3;
    for (size_t i = 0; i < pasts_.size(); ++i)
        if (has_past(int(i))) pasts_[i] = {from[0] == 1, from[1], from[2], from[3]}, from += 4;
    for (double& hold : holds_) hold = *from++;
    if (has_clock()) time_ = *from;
    set_drives();
    return true;
}

}  // namespace epode::robots
