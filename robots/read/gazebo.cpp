// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// <gazebo> in a URDF: what a simulator adds to links and joints, which the element's reference names. Elements are those of
// SDF under older names. Frictions, gravity and pairs that do not touch go to links, springs to joints; sensors get a frame
// in their link and MJCF's kinds. A sensor looks along x there, a rangefinder of MJCF along z.
#include <set>

#include "robots/read/reading.h"
#include "robots/sensors.h"

namespace epode::robots {

namespace {

constexpr size_t kMaxApart = 100;  // links that a link is kept from touching

// Older files have values as attributes.
std::string value_of(const Element& element)
{
    return element.has("value") ? element.text("value") : element.node.text().get();
}

class Gazebo {
  public:
    explicit Gazebo(Reading& reading) : reading_(reading), model_(reading.model) {}

    void read(const Element& gazebo)
    {
        const std::string reference = gazebo.text("reference");
        const int joint = model_.joint_named(reference), link = model_.link_named(reference);
        for (const Element& child : gazebo.children()) {
            if (child.name() == "sensor")
                read_sensor(child, reference, joint >= 0 ? model_.joints[size_t(joint)].link : link);
            else if (joint >= 0)
                read_of_joint(child, model_.joints[size_t(joint)]);
            else if (link >= 0)
                read_of_link(child, link);
            else
                ignore(child, reference);
        }
    }

  private:
    void ignore(const Element& child, const std::string& reference)
    {
        reading_.note(
            Note::kIgnored, child,
            "<" + child.name() + "> in <gazebo>" + (reference.empty() ? "" : " of '" + reference + "'"));
    }

    std::string shown(const Element& element) const
    {
        return "<" + element.name() + "> in <gazebo> is '" + value_of(element).substr(0, 60) + "', wanted ";
    }

    // False and an error where there is something else.
    bool numbers(const Element& element, size_t count, std::vector<double>& out)
    {
        if (parse_numbers(value_of(element), out) && out.size() == count) return true;
        reading_.error(element, shown(element) + std::to_string(count) +
                                    (count == 1 ? " finite number" : " finite numbers"));
        return false;
    }
    // False, too, with an error where it is neither.
    bool is_true(const Element& element)
    {
        static const std::set<std::string> yes{"true", "True", "1"}, no{"false", "False", "0"};
        std::string text = value_of(element);
        text.erase(0, std::min(text.find_first_not_of(" \t\r\n"), text.size()));
        text.erase(text.find_last_not_of(" \t\r\n") + 1);
        if (!yes.count(text) && !no.count(text)) reading_.error(element, shown(element) + "true or false");
        return yes.count(text) > 0;
    }
    bool number(const Element& element, double& out)
    {
        std::vector<double> values;
        if (!numbers(element, 1, values)) return false;
        out = values[0];
        return true;
    }

    void read_of_joint(const Element& child, Joint& joint)
    {
        static const std::set<std::string> harmless{"provideFeedback", "implicitSpringDamper",
                                                    "preserveFixedJoint", "disableFixedJointLumping"};
        const std::string name = child.name();
        double value = 0;
        if (harmless.count(name)) return;
        if (name == "springStiffness") {
            if (number(child, value)) joint.stiffness = std::max(0.0, value);
        } else if (name == "springReference") {
            number(child, joint.spring_reference);
        } else if (name == "stopCfm" || name == "stopErp" || name == "fudgeFactor") {
            number(child, value);
            reading_.note_once(Note::kApproximated, child, "joint " + name + ": limits are rigid");
        } else {
            ignore(child, joint.name);
        }
    }

    void read_of_link(const Element& child, int number_of_link)
    {
        static const std::set<std::string> looks{
            "material",          "visual", "laserRetro", "provideFeedback", "disableFixedJointLumping",
            "preserveFixedJoint"};
        static const std::set<std::string> soft{"kp",          "kd",       "maxVel",   "minDepth",
                                                "maxContacts", "soft_cfm", "soft_erp", "maxContact"};
        const std::string name = child.name();
        Link& link = model_.links[size_t(number_of_link)];
        if (looks.count(name)) return;
        if (name == "mu1" || name == "mu" || name == "mu2") {
            read_friction(child, link);
        } else if (soft.count(name)) {
            double value = 0;
            number(child, value);
            reading_.note_once(Note::kApproximated, child, "link " + name + ": contacts are rigid");
        } else if (name == "turnGravityOff" || name == "gravity") {
            link.is_weightless = is_true(child) == (name == "turnGravityOff");
        } else if (name == "selfCollide" || name == "self_collide") {
            if (!is_true(child)) keep_apart(child, number_of_link);
        } else {
            ignore(child, link.name);
        }
    }

    // One friction for all directions: the first.
    void read_friction(const Element& child, Link& link)
    {
        double value = 0;
        if (!number(child, value)) return;
        if (value < 0) return ignore(child, link.name);
        const bool is_second = child.name() == "mu2";
        for (Shape& shape : link.shapes) {
            if (!is_second) shape.friction = value;
            if (is_second && shape.friction != value)
                reading_.note_once(Note::kApproximated, child,
                                   "friction is the same in both directions: mu1");
        }
        reading_.note_once(Note::kApproximated, child,
                           "a pair's friction is the geometric mean, where Gazebo takes the smaller");
    }

    void keep_apart(const Element& child, int link)
    {
        std::vector<std::array<int, 2>> pairs;
        for (size_t i = 0; i < model_.links.size(); ++i)
            if (int(i) != link && !model_.links[i].shapes.empty())
                pairs.push_back({std::min(link, int(i)), std::max(link, int(i))});
        if (pairs.size() > kMaxApart)
            return reading_.note(Note::kIgnored, child,
                                 "selfCollide of a robot with more than 100 links that touch");
        const std::set<std::array<int, 2>> known(model_.excluded.begin(), model_.excluded.end());
        for (const auto& pair : pairs)
            if (!known.count(pair)) model_.excluded.push_back(pair);
    }

    void read_sensor(const Element& sensor, const std::string& reference, int link)
    {
        const std::string type = sensor.text("type"), name = sensor.text("name");
        if (link < 0) return ignore(sensor, reference);
        Frame frame{unused(name.empty() ? reference + "/" + type : name), link, pose_of(sensor)};
        const auto add = [&](const std::string& kind, const std::string& its) {
            Sensor& one = model_.sensors.emplace_back();
            one.name = its, one.kind = kind, one.object = frame.name, one.line = sensor.line();
        };
        const auto list = [&](const std::string& function) {
            add(type, name);
            reading_.note_once(Note::kIgnored, sensor,
                               "sensors of kind <" + type + "> are listed, not computed by name" + function);
        };
        if (type == "imu") {
            add("accelerometer", name + "/acceleration"), add("gyro", name + "/turning");
        } else if (type == "force_torque") {
            const Element direction = sensor.child("force_torque").child("measure_direction");
            const bool is_on_child = std::string(direction.node.text().get()) == "parent_to_child";
            for (const char* kind : {"force", "torque"})
                add(kind, name + "/" + kind), model_.sensors.back().is_on_child = is_on_child;
        } else if (type == "contact") {
            add("touch", name);
            reading_.note_once(Note::kApproximated, sensor, "a contact sensor feels its whole link");
        } else if (is_ray(type) && rays_of(sensor) == 1) {
            add("rangefinder", name);
            frame.pose = frame.pose * Pose{{}, turn_of_z({1, 0, 0})};
        } else if (is_ray(type)) {
            list(": dRobotCastRays");
        } else {
            list(type.find("camera") != std::string::npos ? ": dRobotTakePicture" : "");
        }
        model_.frames.push_back(frame);
    }

    static bool is_ray(const std::string& type)
    {
        return type == "ray" || type == "gpu_ray" || type == "lidar" || type == "gpu_lidar";
    }

    // Of a scan, horizontal times vertical; a broken number counts as one.
    double rays_of(const Element& sensor)
    {
        double rays = 1;
        for (const char* kind : {"ray", "lidar"})
            for (const char* way : {"horizontal", "vertical"}) {
                const Element samples = sensor.child(kind).child("scan").child(way).child("samples");
                double count = 1;
                if (samples && number(samples, count)) rays *= count;
            }
        return rays;
    }

    Pose pose_of(const Element& sensor)
    {
        std::vector<double> p;
        const Element pose = sensor.child("pose");
        if (!pose || !numbers(pose, 6, p)) return {};
        return {{p[0], p[1], p[2]}, turn_of_rpy({p[3], p[4], p[5]})};
    }

    std::string unused(std::string name) const
    {
        while (model_.link_named(name) >= 0) name += "/sensor";
        return name;
    }

    Reading& reading_;
    RobotModel& model_;
};

}  // namespace

void read_gazebo(const Element& robot, Reading& reading)
{
    Gazebo reader(reading);
    for (const Element& gazebo : robot.children("gazebo")) reader.read(gazebo);
}

}  // namespace epode::robots
