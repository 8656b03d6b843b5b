// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "robots/write/gazebo.h"

#include <algorithm>

#include "robots/sensor_kinds.h"

namespace epode::robots {

namespace {

// Two sensors that one of the file becomes, by what their names end in.
struct Pair {
    const char *type, *first, *first_end, *second, *second_end;
};
constexpr Pair kPairs[] = {{"imu", "accelerometer", "/acceleration", "gyro", "/turning"},
                           {"force_torque", "force", "/force", "torque", "/torque"}};

const Frame* frame_of(const RobotModel& model, const std::string& name)
{
    for (const Frame& frame : model.frames)
        if (!frame.name.empty() && frame.name == name) return &frame;
    return nullptr;
}

// Of links with shapes that are not alike there is none.
bool has_one_friction(const Link& link)
{
    return std::all_of(link.shapes.begin(), link.shapes.end(),
                       [&](const Shape& shape) { return shape.friction == link.shapes[0].friction; });
}

}  // namespace

GazeboWriter::GazeboWriter(const RobotModel& model, const std::vector<std::string>& links,
                           const std::vector<Vec>& shifts, pugi::xml_node robot, Losses& losses)
    : model_(model), links_(links), shifts_(shifts), robot_(robot), losses_(losses)
{
    gather_sensors();
    gather_apart();
}

bool GazeboWriter::pair_of_sensors(size_t first, const Frame& frame)
{
    if (first + 1 >= model_.sensors.size()) return false;
    const Sensor &a = model_.sensors[first], &b = model_.sensors[first + 1];
    for (const Pair& pair : kPairs)
        if (a.kind == pair.first && b.kind == pair.second && b.object == frame.name &&
            a.name == frame.name + pair.first_end && b.name == frame.name + pair.second_end) {
            sensors_.push_back({pair.type, frame.name, &frame});
            sensors_.back().is_on_child = a.is_on_child;
            return true;
        }
    return false;
}

// Sensors of a frame that bears their name, and those of the file's own kinds.
void GazeboWriter::gather_sensors()
{
    for (size_t i = 0; i < model_.sensors.size(); ++i) {
        const Sensor& sensor = model_.sensors[i];
        const Frame* frame = frame_of(model_, sensor.object);
        if (frame && pair_of_sensors(i, *frame)) {
            ++i;
            continue;
        }
        const bool is_touch = sensor.kind == "touch", is_ray = sensor.kind == "rangefinder";
        if (!frame || sensor.name != frame->name || (values_of(sensor.kind) > 0 && !is_touch && !is_ray)) {
            losses_.add("sensors other than Gazebo's are not in URDF");
            continue;
        }
        sensors_.push_back({is_touch ? "contact" : is_ray ? "ray" : sensor.kind, sensor.name, frame, is_ray});
    }
}

bool GazeboWriter::is_apart(int a, int b) const
{
    const std::array<int, 2> pair{std::min(a, b), std::max(a, b)};
    return std::find(model_.excluded.begin(), model_.excluded.end(), pair) != model_.excluded.end();
}

bool GazeboWriter::takes_all_apart(int link) const
{
    int others = 0;
    for (int i = 0; i < int(model_.links.size()); ++i) {
        if (i == link || model_.links[size_t(i)].shapes.empty()) continue;
        if (!is_apart(link, i)) return false;
        ++others;
    }
    return others > 0;
}

void GazeboWriter::gather_apart()
{
    if (model_.excluded.empty()) return;
    for (int link = 1; link < int(model_.links.size()); ++link)
        if (takes_all_apart(link)) alone_.push_back(link);
}

bool GazeboWriter::has_sensor(const Frame& frame) const
{
    return std::any_of(sensors_.begin(), sensors_.end(),
                       [&](const Sensed& sensed) { return sensed.frame == &frame; });
}

pugi::xml_node GazeboWriter::element_of(const std::string& reference)
{
    pugi::xml_node element = robot_.append_child("gazebo");
    set(element, "reference", reference);
    return element;
}

void GazeboWriter::write_link(size_t number)
{
    const Link& link = model_.links[number];
    const std::string& name = links_[number];
    pugi::xml_node element;
    write_friction(link, element, name);
    const bool alone = std::find(alone_.begin(), alone_.end(), int(number)) != alone_.end();
    if (!element && (link.is_weightless || alone)) element = element_of(name);
    if (link.is_weightless) element.append_child("turnGravityOff").text().set("true");
    if (alone) element.append_child("selfCollide").text().set("false");
}

void GazeboWriter::write_friction(const Link& link, pugi::xml_node& element, const std::string& name)
{
    const bool one = has_one_friction(link);
    if (!one) losses_.add("a link's shapes have one friction in URDF");
    for (const Shape& shape : link.shapes)
        if (shape.dimensions > 3 || shape.softness.stated || shape.category != 1 || shape.collide != 1)
            losses_.add("rolling friction, softness and categories of what touches are not in URDF");
    if (!one || link.shapes.empty() || link.shapes[0].friction == 1) return;
    element = element_of(name);
    for (const char* direction : {"mu1", "mu2"})
        element.append_child(direction).text().set(text_of(link.shapes[0].friction).c_str());
}

void GazeboWriter::write_joint(const Joint& joint, const std::string& name)
{
    if (joint.stiffness == 0 && joint.spring_reference == 0) return;
    pugi::xml_node element = element_of(name);
    element.append_child("springReference")
        .text()
        .set(text_of(joint.spring_reference - joint.reference).c_str());
    element.append_child("springStiffness").text().set(text_of(joint.stiffness).c_str());
}

void GazeboWriter::write_sensors()
{
    for (const Sensed& sensed : sensors_) {
        const Frame& frame = *sensed.frame;
        const Pose turned =
            sensed.looks_along_z ? frame.pose * Pose{{}, conjugate(turn_of_z({1, 0, 0}))} : frame.pose;
        const Pose pose{turned.p - shifts_[size_t(frame.link)], turned.q};
        pugi::xml_node sensor = element_of(links_[size_t(frame.link)]).append_child("sensor");
        set(sensor, "name", sensed.name), set(sensor, "type", sensed.type);
        if (sensed.is_on_child)
            sensor.append_child("force_torque")
                .append_child("measure_direction")
                .text()
                .set("parent_to_child");
        if (is_identity(pose)) continue;
        const Vec turn = rpy_of(pose.q);
        sensor.append_child("pose").text().set((text_of(pose.p) + " " + text_of(turn)).c_str());
    }
}

void GazeboWriter::note_losses()
{
    for (const auto& pair : model_.excluded)
        if (std::none_of(pair.begin(), pair.end(), [&](int link) {
                return std::find(alone_.begin(), alone_.end(), link) != alone_.end();
            }))
            losses_.add("pairs that do not touch are not in URDF");
}

}  // namespace epode::robots
