// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The reader of URDF. Links and joints may stand in any order: joints are read first as what they are, then the tree
// is walked from its one root, parents before children. A link's frame is its joint's, so a joint has its anchor at
// the origin; lengths in m, angles in rad, rpy about fixed axes.
#include <algorithm>
#include <map>
#include <set>

#include "robots/numbers.h"
#include "robots/read/counts.h"

namespace epode::robots {

namespace {

struct Edge {
    Element element;
    std::string name, kind, parent, child;
};

class Urdf {
  public:
    Urdf(const Element& robot, Reading& reading)
        : robot_(robot), reading_(reading), model_(reading.model), folder_(folder_of(robot.file()))
    {}

    void read();

  private:
    bool collect();
    void add_tree(const std::string& root);
    int add_link(const Element& element, int parent);
    void read_inertial(const Element& element, Link& link);
    bool read_shape(const Element& element, bool is_visual, Shape& shape);
    void read_color(const Element& material, Shape& shape);
    bool read_mesh(const Element& it, Note missing, Shape& shape);
    bool read_solid(const Element& it, Note broken, Shape& shape);
    void read_joint(const Edge& edge, int link);
    void add_planar(const Edge& edge, Vec normal, int link);
    void add_axis(const Edge& edge, Vec axis, int link);
    void add_joint(JointKind kind, const std::string& name, Vec axis, int link, const Element& element);
    void read_limits(const Element& element, Joint& joint);
    void read_mimics();
    void read_transmissions();
    void note_others(const Element& element, const std::set<std::string>& known);
    Pose origin_of(const Element& element);

    Element robot_;
    Reading& reading_;
    RobotModel& model_;
    std::string folder_;
    std::map<std::string, Element> links_, materials_;
    std::vector<Edge> edges_;
    std::vector<std::string> order_;
    std::map<std::string, std::vector<const Edge*>> children_;
};

void Urdf::note_others(const Element& element, const std::set<std::string>& known)
{
    for (const Element& child : element.children())
        if (!known.count(child.name()))
            reading_.note(Note::kIgnored, child, "<" + child.name() + "> in <" + element.name() + ">");
}

Pose Urdf::origin_of(const Element& element)
{
    Pose pose;
    Vec rpy;
    const Element origin = element.child("origin");
    reading_.vec(origin, "xyz", pose.p);
    if (reading_.vec(origin, "rpy", rpy)) pose.q = turn_of_rpy(rpy);
    return pose;
}

// Links by name, and joints; names twice, joints without ends.
bool Urdf::collect()
{
    for (const Element& material : robot_.children("material")) materials_[material.text("name")] = material;
    for (const Element& link : robot_.children("link")) {
        const std::string name = link.text("name");
        if (name.empty()) reading_.error(link, "a link without a name");
        if (!links_.emplace(name, link).second) reading_.error(link, "a second link '" + name + "'");
        order_.push_back(name);
    }
    if (links_.size() > kMaxLinks) reading_.error(robot_, Reading::too_many_links());
    std::set<std::string> names, children;
    for (const Element& joint : robot_.children("joint")) {
        Edge edge{joint, joint.text("name"), joint.text("type"), joint.child("parent").text("link"),
                  joint.child("child").text("link")};
        if (!names.insert(edge.name).second) reading_.error(joint, "a second joint '" + edge.name + "'");
        for (const std::string& end : {edge.parent, edge.child})
            if (!links_.count(end))
                reading_.error(joint,
                               "joint '" + edge.name + "' names the link '" + end + "', which is not there");
        if (!children.insert(edge.child).second)
            reading_.error(joint, "link '" + edge.child + "' is the child of two joints; a tree has one");
        edges_.push_back(edge);
    }
    return !model_.has_errors();
}

void Urdf::read()
{
    model_.name = robot_.text("name");
    model_.touches_itself = false;
    note_others(robot_, {"link", "joint", "material", "transmission", "gazebo"});
    check_urdf_counts(robot_, reading_);
    if (!collect()) return;
    std::set<std::string> is_child;
    for (const Edge& edge : edges_) {
        children_[edge.parent].push_back(&edge);
        is_child.insert(edge.child);
    }
    std::vector<std::string> roots;
    for (const std::string& name : order_)
        if (!is_child.count(name)) roots.push_back(name);
    if (roots.size() != 1) {
        reading_.error(robot_, "there are " + std::to_string(roots.size()) +
                                   " links that are nobody's child; a tree has one root");
        return;
    }
    add_tree(roots[0]);
    if (model_.links.size() < links_.size() + (roots[0] == "world" ? 0 : 1))
        reading_.error(robot_,
                       "links that no joint connects to the root '" + roots[0] + "': a loop of joints");
    read_mimics();
    read_transmissions();
    read_gazebo(robot_, reading_);
}

// A link, then all that hangs on it, branch by branch in the order of the file; no recursion, since the depth is the
// file's.
void Urdf::add_tree(const std::string& root)
{
    Link world;
    world.name = "world";
    model_.links.push_back(world);
    const bool is_world = root == "world";
    const int base = add_link(links_[root], is_world ? -1 : 0);
    if (!is_world && !reading_.options.fixed_base) add_joint(JointKind::kFree, root, {}, base, links_[root]);
    std::vector<std::pair<const Edge*, int>> open;  // and the parent's number
    const auto add_branches = [&](const std::string& name, int number) {
        const std::vector<const Edge*>& edges = children_[name];
        for (size_t i = edges.size(); i-- > 0;) open.push_back({edges[i], number});
    };
    add_branches(root, base);
    while (!open.empty()) {
        const auto [edge, parent] = open.back();
        open.pop_back();
        const int link = add_link(links_[edge->child], parent);
        model_.links[size_t(link)].pose = origin_of(edge->element);
        read_joint(*edge, link);
        add_branches(edge->child, link);
    }
    number_coordinates(model_);
}

int Urdf::add_link(const Element& element, int parent)
{
    Link link;
    link.name = element.text("name");
    link.parent = parent;
    link.line = element.line();
    note_others(element, {"inertial", "visual", "collision"});
    if (parent >= 0) read_inertial(element, link);
    for (const Element& collision : element.children("collision")) {
        Shape shape;
        if (read_shape(collision, false, shape)) link.shapes.push_back(shape);
    }
    for (const Element& visual : element.children("visual")) {
        Shape shape;
        if (read_shape(visual, true, shape)) link.visuals.push_back(shape);
    }
    if (parent < 0) {
        model_.links[0] = link;
        return 0;
    }
    model_.links.push_back(link);
    return int(model_.links.size()) - 1;
}

void Urdf::read_inertial(const Element& element, Link& link)
{
    const Element inertial = element.child("inertial");
    if (!inertial) return;
    reading_.number(inertial.child("mass"), "value", link.mass);
    if (link.mass < 0)
        reading_.error(inertial, "link '" + link.name + "' has the mass " + text_of(link.mass) +
                                     " kg; it must be positive");
    const Pose origin = origin_of(inertial);
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0;
    const Element tensor = inertial.child("inertia");
    reading_.number(tensor, "ixx", xx), reading_.number(tensor, "ixy", xy),
        reading_.number(tensor, "ixz", xz);
    reading_.number(tensor, "iyy", yy), reading_.number(tensor, "iyz", yz),
        reading_.number(tensor, "izz", zz);
    link.centre = origin.p;
    link.inertia = rotated({{{xx, xy, xz}, {xy, yy, yz}, {xz, yz, zz}}}, origin.q);
    link.has_inertial = link.mass > 0;
}

void Urdf::read_color(const Element& material, Shape& shape)
{
    Element its = material;
    if (!its.child("color") && materials_.count(its.text("name"))) its = materials_[its.text("name")];
    std::vector<double> rgba;
    if (reading_.numbers(its.child("color"), its.child("color").text("rgba"), "rgba", 4, 4, rgba))
        for (size_t i = 0; i < 4; ++i) shape.color[i] = float(rgba[i]);
}

// False: nothing to add; the report has why.
bool Urdf::read_shape(const Element& element, bool is_visual, Shape& shape)
{
    const std::vector<Element> all = element.child("geometry").children();
    const Note broken = is_visual ? Note::kIgnored : Note::kError;
    shape.name = element.text("name");
    shape.pose = origin_of(element);
    if (is_visual) read_color(element.child("material"), shape);
    if (all.size() != 1) {
        reading_.error(element, "<" + element.name() + "> has " + std::to_string(all.size()) +
                                    " shapes in its geometry; one is wanted");
        return false;
    }
    return all[0].name() == "mesh" ? read_mesh(all[0], broken, shape) : read_solid(all[0], broken, shape);
}

bool Urdf::read_mesh(const Element& it, Note missing, Shape& shape)
{
    Vec scale{1, 1, 1};
    reading_.vec(it, "scale", scale);
    shape.kind = reading_.options.meshes_as_triangles ? ShapeKind::kTriangles : ShapeKind::kHull;
    shape.mesh = reading_.mesh({missing, it.file(), it.line()}, {it.text("filename"), folder_, scale, false});
    return shape.mesh >= 0;
}

// A capsule may have no length: it is a ball.
bool Urdf::read_solid(const Element& it, Note broken, Shape& shape)
{
    static const std::map<std::string, ShapeKind> kinds{{"box", ShapeKind::kBox},
                                                        {"sphere", ShapeKind::kSphere},
                                                        {"cylinder", ShapeKind::kCylinder},
                                                        {"capsule", ShapeKind::kCapsule}};
    const auto kind = kinds.find(it.name());
    if (kind == kinds.end()) return reading_.note(Note::kIgnored, it, "a shape <" + it.name() + ">"), false;
    shape.kind = kind->second;
    double radius = 0, high = 0;
    Vec size;
    reading_.number(it, "radius", radius), reading_.number(it, "length", high),
        reading_.vec(it, "size", size);
    shape.size = shape.kind == ShapeKind::kBox ? 0.5 * size : Vec{radius, high / 2, 0};
    if (shape.kind == ShapeKind::kSphere) shape.size.y = 0;
    const Vec s = shape.size;
    const bool is_long = shape.kind == ShapeKind::kBox        ? s.y > 0 && s.z > 0
                         : shape.kind == ShapeKind::kCylinder ? s.y > 0
                                                              : s.y >= 0;
    if (s.x > 0 && is_long) return true;
    reading_.note(broken, it, "a " + it.name() + " without a positive size");
    return false;
}

void Urdf::add_joint(JointKind kind, const std::string& name, Vec axis, int link, const Element& element)
{
    Joint joint;
    joint.kind = kind, joint.name = name, joint.axis = axis, joint.link = link, joint.line = element.line();
    model_.links[size_t(link)].joints.push_back(int(model_.joints.size()));
    model_.joints.push_back(joint);
}

void Urdf::read_limits(const Element& element, Joint& joint)
{
    const Element limit = element.child("limit"), dynamics = element.child("dynamics");
    if (joint.limited) {
        joint.low = joint.high = 0;  // what URDF takes for missing ones
        reading_.number(limit, "lower", joint.low), reading_.number(limit, "upper", joint.high);
        if (joint.low > joint.high) {
            reading_.error(element, "joint '" + joint.name + "' has the lower limit " + text_of(joint.low) +
                                        " above the upper " + text_of(joint.high));
        }
    }
    reading_.number(limit, "effort", joint.max_force), reading_.number(limit, "velocity", joint.max_velocity);
    reading_.number(dynamics, "damping", joint.damping),
        reading_.number(dynamics, "friction", joint.friction);
    if (joint.damping < 0 || joint.friction < 0)
        reading_.error(dynamics, "joint '" + joint.name + "' has negative damping or friction");
}

void Urdf::read_joint(const Edge& edge, int link)
{
    const Element& element = edge.element;
    note_others(element, {"origin", "parent", "child", "axis", "limit", "dynamics", "mimic",
                          "safety_controller", "calibration"});
    if (element.child("safety_controller"))
        reading_.note(Note::kIgnored, element.child("safety_controller"), "soft limits are a controller's");
    Vec axis{1, 0, 0};
    reading_.vec(element.child("axis"), "xyz", axis);
    const double size = length(axis);
    const std::string& kind = edge.kind;
    if (kind == "fixed") return;
    if (kind == "floating") return add_joint(JointKind::kFree, edge.name, axis, link, element);
    if (kind == "spherical") {
        reading_.note(Note::kChanged, element,
                      "joint '" + edge.name + "', spherical as PyBullet has it, as a ball");
        return add_joint(JointKind::kBall, edge.name, axis, link, element);
    }
    if (!(size > 1e-9 && size <= kMaxNumber))
        return reading_.error(element, "joint '" + edge.name + "' has an axis of no usable length");
    kind == "planar" ? add_planar(edge, (1 / size) * axis, link) : add_axis(edge, (1 / size) * axis, link);
}

void Urdf::add_planar(const Edge& edge, Vec normal, int link)
{
    const Quat frame = turn_of_z(normal);
    add_joint(JointKind::kSlide, edge.name + "/x", rotate(frame, {1, 0, 0}), link, edge.element);
    add_joint(JointKind::kSlide, edge.name + "/y", rotate(frame, {0, 1, 0}), link, edge.element);
    add_joint(JointKind::kHinge, edge.name + "/turn", normal, link, edge.element);
    reading_.note(Note::kChanged, edge.element,
                  "planar joint '" + edge.name + "' as two sliders and a hinge");
}

void Urdf::add_axis(const Edge& edge, Vec axis, int link)
{
    const bool turns = edge.kind == "revolute" || edge.kind == "continuous";
    if (!turns && edge.kind != "prismatic")
        return reading_.error(
            edge.element,
            "joint '" + edge.name + "' has the type '" + edge.kind +
                "'; there are revolute, continuous, prismatic, fixed, floating, planar, spherical");
    add_joint(turns ? JointKind::kHinge : JointKind::kSlide, edge.name, axis, link, edge.element);
    Joint& joint = model_.joints.back();
    joint.limited = edge.kind != "continuous";
    read_limits(edge.element, joint);
}

void Urdf::read_mimics()
{
    for (const Edge& edge : edges_) {
        const Element mimic = edge.element.child("mimic");
        if (!mimic) continue;
        const int follower = model_.joint_named(edge.name), leader = model_.joint_named(mimic.text("joint"));
        if (follower < 0) {
            reading_.note(Note::kIgnored, mimic,
                          "a mimic of the joint '" + edge.name + "', which has no axis");
        } else if (leader < 0 || leader == follower || !model_.joints[size_t(leader)].is_scalar()) {
            reading_.error(mimic, "joint '" + edge.name + "' mimics '" + mimic.text("joint") +
                                      "', which is no other joint with an axis");
        } else {
            double factor = 1, offset = 0;
            reading_.number(mimic, "multiplier", factor), reading_.number(mimic, "offset", offset);
            Coupling coupling;
            coupling.name = edge.name, coupling.offset = offset, coupling.line = mimic.line();
            coupling.terms = {{follower, 1}, {leader, -factor}};
            model_.couplings.push_back(coupling);
        }
    }
}

// A transmission names a joint that has a motor: its force in N or N m is the control. A file without any, as most are, says nothing
// of motors: all joints have one.
void Urdf::read_transmissions()
{
    if (robot_.children("transmission").empty()) return reading_.add_motors();
    for (const Element& transmission : robot_.children("transmission"))
        for (const Element& its : transmission.children("joint")) {
            const int joint = model_.joint_named(its.text("name"));
            if (joint < 0 || !model_.joints[size_t(joint)].is_scalar()) {
                reading_.note(Note::kIgnored, its,
                              "a transmission of '" + its.text("name") + "', which has no axis");
                continue;
            }
            reading_.add_motor(joint, its.text("name"), its.line());
        }
}

}  // namespace

void read_urdf(const Element& robot, Reading& reading) { Urdf(robot, reading).read(); }

}  // namespace epode::robots
