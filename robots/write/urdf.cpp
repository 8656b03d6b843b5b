// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The writer of URDF. There a link has one joint, whose axis goes through the link's origin and which is 0 where the file
// describes the robot. So the frame of a link moves to the anchor a of its joint, which leaves its motion as it is:
//     X = X_parent P T(a) R T(-a)   =>   X' = X T(a) = X'_parent T(-a_parent) P T(a) R,
// coordinates count from the reference, and links of several joints get weightless links between them, three for a
// ball. Frames of the model become weightless links on fixed joints, which readers merge again.
#include <algorithm>
#include <cmath>

#include <optional>

#include "robots/write/gazebo.h"
#include "robots/write/text.h"
#include "robots/write/write.h"

namespace epode::robots {

namespace {

using Node = pugi::xml_node;

constexpr double kUnlimited = 1e9;  // what URDF must have a number for

class UrdfWriter {
  public:
    UrdfWriter(const RobotModel& model, const std::string& folder) : model_(model), folder_(folder) {}
    WrittenRobot write();

  private:
    bool base_is_root() const;
    void write_link(size_t number);
    void write_frames();
    void write_shape(Node link, const Shape& shape, const char* element, Vec shift);
    void write_geometry(Node geometry, const Shape& shape);
    void write_joints(size_t number);
    // A joint from parent to child, where the child's frame stands in the parent's.
    Node connect(const std::string& name, const char* type, const std::string& parent,
                 const std::string& child, const Pose& origin);
    void write_ball(const Joint& joint, const std::string& name, const std::string& parent,
                    const std::string& child, const Pose& origin);
    void write_scalar(const Joint& joint, Node node);
    void write_limits(const Joint& joint, Node node);
    void write_mimics();
    void write_motors();
    void note_losses();
    std::string weightless(const std::string& name);

    const RobotModel& model_;
    std::string folder_;
    pugi::xml_document document_;
    Node root_;
    Names link_names_;
    std::vector<std::string> links_, joints_;
    std::vector<Vec> shifts_;  // of the links' frames
    std::vector<Node> joint_nodes_;
    bool is_rooted_ = false;  // in its base, without a link for the world
    Losses losses_;
    std::optional<GazeboWriter> gazebo_;
};

void write_origin(Node node, const Pose& pose)
{
    if (is_identity(pose)) return;
    Node origin = node.append_child("origin");
    set(origin, "xyz", text_of(pose.p)), set(origin, "rpy", text_of(rpy_of(pose.q)));
}

Pose moved_back(const Pose& pose, Vec shift) { return {pose.p - shift, pose.q}; }

// One free base and an empty world: what others expect.
bool UrdfWriter::base_is_root() const
{
    if (model_.links.size() < 2 || !model_.links[0].shapes.empty() || !model_.links[0].visuals.empty())
        return false;
    for (size_t i = 2; i < model_.links.size(); ++i)
        if (model_.links[i].parent == 0) return false;
    for (const Frame& frame : model_.frames)
        if (frame.link == 0) return false;
    const Link& base = model_.links[1];
    return base.joints.size() == 1 && model_.joints[size_t(base.joints[0])].kind == JointKind::kFree &&
           is_identity(base.pose) && base.name != "world";
}

std::string UrdfWriter::weightless(const std::string& name)
{
    const std::string its = link_names_.unique(name, "link", model_.links.size());
    set(root_.append_child("link"), "name", its);
    return its;
}

void UrdfWriter::write_link(size_t number)
{
    const Link& link = model_.links[number];
    const Vec shift = shifts_[number];
    Node its = root_.append_child("link");
    set(its, "name", links_[number]);
    if (number > 0 && link.mass > 0) {
        const Matrix& i = link.inertia;
        Node inertial = its.append_child("inertial");
        write_origin(inertial, {link.centre - shift, {}});
        set(inertial.append_child("mass"), "value", link.mass);
        Node tensor = inertial.append_child("inertia");
        set(tensor, "ixx", i[0][0]), set(tensor, "ixy", i[0][1]), set(tensor, "ixz", i[0][2]);
        set(tensor, "iyy", i[1][1]), set(tensor, "iyz", i[1][2]), set(tensor, "izz", i[2][2]);
    }
    for (const Shape& shape : link.visuals) write_shape(its, shape, "visual", shift);
    for (const Shape& shape : link.shapes) write_shape(its, shape, "collision", shift);
    gazebo_->write_link(number);
}

void UrdfWriter::write_shape(Node link, const Shape& shape, const char* element, Vec shift)
{
    if (shape.kind == ShapeKind::kPlane || shape.kind == ShapeKind::kEllipsoid || shape.field >= 0)
        return losses_.add(std::string("URDF has no ") + name_of(shape.kind));
    if (shape.mesh >= 0 && model_.meshes[size_t(shape.mesh)].path.empty())
        return losses_.add("URDF has no meshes without a file");
    Node its = link.append_child(element);
    const bool is_visual = its.name()[0] == 'v';
    if (!shape.name.empty()) set(its, "name", shape.name);
    write_origin(its, moved_back(shape.pose, shift));
    write_geometry(its.append_child("geometry"), shape);
    if (is_visual) {
        Node material = its.append_child("material");
        set(material, "name", ""), set(material.append_child("color"), "rgba", color_text(shape.color));
    }
}

void UrdfWriter::write_geometry(Node geometry, const Shape& shape)
{
    const Vec s = shape.size;
    const bool is_mesh = shape.kind == ShapeKind::kHull || shape.kind == ShapeKind::kTriangles;
    Node its = geometry.append_child(is_mesh ? "mesh" : name_of(shape.kind));
    if (is_mesh) {
        const Mesh& mesh = model_.meshes[size_t(shape.mesh)];
        set(its, "filename", path_from(folder_, mesh.path)), set(its, "scale", text_of(mesh.scale));
    } else if (shape.kind == ShapeKind::kBox) {
        set(its, "size", text_of(2 * s));
    } else {
        set(its, "radius", s.x);
        if (shape.kind != ShapeKind::kSphere) set(its, "length", 2 * s.y);
    }
    if (shape.kind == ShapeKind::kCapsule)
        losses_.add("capsules are no part of URDF: not every program reads them");
    if (shape.kind == ShapeKind::kTriangles)
        losses_.add("whether meshes touch as triangles or hulls is the reader's choice");
}

Node UrdfWriter::connect(const std::string& name, const char* type, const std::string& parent,
                         const std::string& child, const Pose& origin)
{
    Node its = root_.append_child("joint");
    set(its, "name", name), set(its, "type", type);
    set(its.append_child("parent"), "link", parent), set(its.append_child("child"), "link", child);
    write_origin(its, origin);
    return its;
}

void UrdfWriter::write_joints(size_t number)
{
    const Link& link = model_.links[number];
    const bool stands_in_world = link.parent == 0 && is_rooted_;
    if (stands_in_world) return;
    std::string parent = links_[size_t(link.parent)];
    Pose origin = Pose{-shifts_[size_t(link.parent)], {}} * link.pose;
    if (link.joints.empty()) connect(links_[number] + "_fixed", "fixed", parent, links_[number], origin);
    Vec at;  // of the last joint, in the link's frame
    for (size_t k = 0; k < link.joints.size(); ++k) {
        const Joint& joint = model_.joints[size_t(link.joints[k])];
        const std::string& name = joints_[size_t(link.joints[k])];
        const bool is_last = k + 1 == link.joints.size();
        const std::string child = is_last ? links_[number] : weightless(links_[number] + "_" + name);
        if (!is_last) losses_.add("several joints on a link: weightless links stand between them");
        const Vec anchor = joint.kind == JointKind::kSlide ? at : joint.anchor;
        origin = origin * Pose{anchor - at, {}};
        const char* type = joint.kind == JointKind::kFree    ? "floating"
                           : joint.kind == JointKind::kSlide ? "prismatic"
                           : joint.limited                   ? "revolute"
                                                             : "continuous";
        if (joint.kind == JointKind::kBall)
            write_ball(joint, name, parent, child, origin);
        else
            write_scalar(joint,
                         joint_nodes_[size_t(link.joints[k])] = connect(name, type, parent, child, origin));
        parent = child, origin = {}, at = anchor;
    }
}

void UrdfWriter::write_ball(const Joint& joint, const std::string& name, const std::string& parent,
                            const std::string& child, const Pose& origin)
{
    losses_.add("the ball joint '" + joint.name + "' as three hinges");
    std::string from = parent;
    for (int i = 0; i < 3; ++i) {
        const std::string part = name + "_" + "xyz"[i], to = i == 2 ? child : weightless(part);
        Vec axis;
        axis[i] = 1;
        Node its = connect(part, "continuous", from, to, i == 0 ? origin : Pose{});
        set(its.append_child("axis"), "xyz", text_of(axis));
        if (joint.damping > 0) set(its.append_child("dynamics"), "damping", joint.damping);
        from = to;
    }
}

void UrdfWriter::write_scalar(const Joint& joint, Node node)
{
    if (!joint.is_scalar()) return;
    set(node.append_child("axis"), "xyz", text_of(joint.axis));
    write_limits(joint, node);
    if (joint.damping != 0 || joint.friction != 0) {
        Node dynamics = node.append_child("dynamics");
        set(dynamics, "damping", joint.damping), set(dynamics, "friction", joint.friction);
    }
    gazebo_->write_joint(joint, node.attribute("name").value());
    if (joint.armature != 0) losses_.add("armatures of joints are not in URDF");
    if (joint.reference != 0) losses_.add("coordinates count from the pose of the file in URDF");
}

// Lower and upper are wanted of sliders too, effort and velocity wherever there are limits.
void UrdfWriter::write_limits(const Joint& joint, Node node)
{
    const bool needs = joint.limited || joint.kind == JointKind::kSlide;
    const auto number = [](double value) { return std::clamp(value, -kUnlimited, kUnlimited); };
    if (!needs && std::isinf(joint.max_force) && std::isinf(joint.max_velocity)) return;
    Node limit = node.append_child("limit");
    if (needs) {
        set(limit, "lower", number(joint.low - joint.reference));
        set(limit, "upper", number(joint.high - joint.reference));
    }
    set(limit, "effort", number(joint.max_force)), set(limit, "velocity", number(joint.max_velocity));
}

// Frames of the model that have a name.
void UrdfWriter::write_frames()
{
    for (const Frame& frame : model_.frames) {
        if (frame.name.empty() || gazebo_->has_sensor(frame)) continue;
        const std::string name = weightless(frame.name);
        connect(name + "_fixed", "fixed", links_[size_t(frame.link)], name,
                moved_back(frame.pose, shifts_[size_t(frame.link)]));
    }
}

// q1 = m q2 + o, of coordinates that count from their references.
void UrdfWriter::write_mimics()
{
    for (const Tie& tie : model_.ties) losses_.add("an equality of tendons: '" + tie.name + "'");
    for (const Coupling& coupling : model_.couplings) {
        const auto& terms = coupling.terms;
        if (terms.size() != 2 || terms[0].factor == 0) {
            losses_.add("a coupling that is not of two joints: '" + coupling.name + "'");
            continue;
        }
        const Joint &follower = model_.joints[size_t(terms[0].joint)],
                    &leader = model_.joints[size_t(terms[1].joint)];
        const double factor = -terms[1].factor / terms[0].factor;
        Node mimic = joint_nodes_[size_t(terms[0].joint)].append_child("mimic");
        set(mimic, "joint", joints_[size_t(terms[1].joint)]), set(mimic, "multiplier", factor);
        set(mimic, "offset",
            coupling.offset / terms[0].factor + factor * leader.reference - follower.reference);
        if (!coupling.polynomial.empty()) losses_.add("a mimic is a straight line");
    }
}

void UrdfWriter::write_motors()
{
    for (const Actuator& motor : model_.actuators) {
        if (motor.joint < 0) {
            losses_.add("actuators of tendons, sites and bodies are not in URDF");
            continue;
        }
        const std::string& joint = joints_[size_t(motor.joint)];
        Node its = root_.append_child("transmission");
        set(its, "name", joint + "_transmission");
        its.append_child("type").text().set("transmission_interface/SimpleTransmission");
        set(its.append_child("joint"), "name", joint);
        set(its.append_child("actuator"), "name", motor.name.empty() ? joint + "_motor" : motor.name);
        const bool is_plain = motor.kind == "motor" && motor.gear == 1 && motor.gain == 1 && motor.bias == 0;
        if (!is_plain || std::isfinite(motor.low))
            losses_.add("gears, gains and ranges of actuators are not in URDF");
    }
}

void UrdfWriter::note_losses()
{
    const RobotModel& m = model_;
    if (!m.pairs.empty()) losses_.add("contacts of single pairs of geoms are not in URDF");
    if (!m.closures.empty()) losses_.add("loops are not in URDF");
    if (!m.tendons.empty()) losses_.add("tendons are not in URDF");
    if (!m.cameras.empty()) losses_.add("cameras are not in URDF");
    if (!m.starts.empty()) losses_.add("start poses are not in URDF");
    gazebo_->note_losses();
    if (m.gravity.x != 0 || m.gravity.y != 0 || m.gravity.z != -9.81) losses_.add("gravity is not in URDF");
    if (m.touches_itself)
        losses_.add("read as URDF, links that overlap at the reference position do not touch");
}

WrittenRobot UrdfWriter::write()
{
    root_ = document_.append_child("robot");
    set(root_, "name", model_.name.empty() ? "robot" : model_.name);
    Names joints;
    for (size_t i = 0; i < model_.links.size(); ++i) {
        const Link& link = model_.links[i];
        links_.push_back(link_names_.unique(i ? link.name : "world", "link", i));
        shifts_.push_back({});
        for (int joint : link.joints)
            if (const Joint& its = model_.joints[size_t(joint)];
                its.kind != JointKind::kFree && its.kind != JointKind::kSlide)
                shifts_.back() = its.anchor;
    }
    for (size_t i = 0; i < model_.joints.size(); ++i)
        joints_.push_back(joints.unique(model_.joints[i].name, "joint", i));
    joint_nodes_.resize(model_.joints.size());
    is_rooted_ = base_is_root();
    gazebo_.emplace(model_, links_, shifts_, root_, losses_);
    for (size_t i = is_rooted_ ? 1 : 0; i < model_.links.size(); ++i) write_link(i);
    for (size_t i = 1; i < model_.links.size(); ++i) write_joints(i);
    write_frames();
    gazebo_->write_sensors();
    write_mimics();
    write_motors();
    note_losses();
    return {text_of(document_), losses_.all};
}

}  // namespace

WrittenRobot write_urdf(const RobotModel& model, const std::string& folder)
{
    return UrdfWriter(model, folder).write();
}

}  // namespace epode::robots
