// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The writer of MJCF: links, joints, geoms and loops; see mjcf_writer.h. Angles are radians, inertias are written and never taken from
// geoms, limits say whether they are on, so that no default of the format decides anything. A loop is said by the bodies and a point
// of the first where that means the same, else by two sites.
#include <cmath>

#include "robots/files/files.h"
#include "robots/files/mjcf_custom.h"
#include "robots/write/mjcf_writer.h"

namespace epode::robots {

namespace {

using Node = pugi::xml_node;

const char* type_of(ShapeKind kind)
{
    if (kind == ShapeKind::kHeights) return "hfield";
    return kind == ShapeKind::kHull || kind == ShapeKind::kTriangles ? "mesh" : name_of(kind);
}

// Of a mesh without a file.
void write_corners(Node asset, const Mesh& mesh)
{
    std::vector<double> vertices, faces;
    for (Vec v : mesh.vertices) vertices.insert(vertices.end(), {v.x, v.y, v.z});
    for (const auto& t : mesh.triangles) faces.insert(faces.end(), t.begin(), t.end());
    set(asset, "vertex", list_text(vertices)), set(asset, "face", list_text(faces));
}

}  // namespace

void MjcfWriter::write_softness(Node node, const char* reference, const char* impedance, const Softness& s)
{
    if (!s.stated) return;
    set(node, reference, list_text({s.time, s.ratio}));
    set(node, impedance, list_text({s.low, s.high, s.width, s.middle, s.power}));
}

bool MjcfWriter::is_near(const Pose& a, const Pose& b)
{
    return length(a.p - b.p) < 1e-9 && std::fabs(1 - std::fabs((conjugate(a.q) * b.q).w)) < 1e-12;
}

Node MjcfWriter::section(const char* name)
{
    const Node found = root_.child(name);
    return found ? found : root_.append_child(name);
}

void MjcfWriter::name_all()
{
    Names links, joints;
    for (size_t i = 0; i < model_.links.size(); ++i)
        links_.push_back(links.unique(i ? model_.links[i].name : "world", "body", i));
    for (size_t i = 0; i < model_.still.size(); ++i)
        still_.push_back(links.unique(model_.still[i], "still", i));
    for (size_t i = 0; i < model_.joints.size(); ++i)
        joints_.push_back(joints.unique(model_.joints[i].name, "joint", i));
    for (size_t i = 0; i < model_.tendons.size(); ++i)
        tendons_.push_back(tendon_names_.unique(model_.tendons[i].name, "tendon", i));
}

void MjcfWriter::write_option(Node option)
{
    set(option, "gravity", text_of(model_.gravity));
    if (model_.stepsize > 0) set(option, "timestep", model_.stepsize);
    const Medium& medium = model_.medium;
    if (medium.density != 0) set(option, "density", medium.density);
    if (medium.viscosity != 0) set(option, "viscosity", medium.viscosity);
    if (length(medium.wind) > 0) set(option, "wind", text_of(medium.wind));
    if (length(model_.magnetic - Vec{0, -0.5, 0}) > 0) set(option, "magnetic", text_of(model_.magnetic));
}

void MjcfWriter::write_meshes()
{
    for (size_t i = 0; i < model_.meshes.size(); ++i) {
        const Mesh& mesh = model_.meshes[i];
        Node asset = section("asset").append_child("mesh");
        set(asset, "name", "mesh" + std::to_string(i));
        set(asset, "inertia", mesh.counts_folds ? "legacy" : "convex");
        if (mesh.path.empty()) {
            write_corners(asset, mesh);
            continue;
        }
        set(asset, "file", path_from(folder_, mesh.path));
        set(asset, "scale", text_of(mesh.scale));
        const std::string ending = ending_of(mesh.path);
        if (ending == "dae" || ending == "glb")
            losses_.add("MuJoCo itself reads no ." + ending + " meshes: turn them into .obj and name those");
    }
}

// Texts of samples run from the largest y down.
void MjcfWriter::write_fields()
{
    for (size_t i = 0; i < model_.fields.size(); ++i) {
        const HeightField& field = model_.fields[i];
        Node asset = section("asset").append_child("hfield");
        set(asset, "name", "field" + std::to_string(i));
        set(asset, "size", list_text({field.half_x, field.half_y, field.top, field.base}));
        if (!field.path.empty()) {
            set(asset, "file", path_from(folder_, field.path));
            continue;
        }
        std::vector<double> texts;
        for (int row = field.rows; row-- > 0;)
            texts.insert(texts.end(), &field.samples[size_t(row) * size_t(field.columns)],
                         &field.samples[size_t(row) * size_t(field.columns)] + field.columns);
        set(asset, "nrow", field.rows), set(asset, "ncol", field.columns);
        set(asset, "elevation", list_text(texts));
    }
}

void MjcfWriter::write_pose(Node node, const Pose& pose)
{
    if (is_identity(pose)) return;
    set(node, "pos", text_of(pose.p)), set(node, "quat", text_of(pose.q));
}

void MjcfWriter::write_inertial(Node body, const Link& link)
{
    const Matrix& i = link.inertia;
    const bool has_inertia = i[0][0] != 0 || i[1][1] != 0 || i[2][2] != 0;
    if (!link.has_inertial && link.mass <= 0 && !has_inertia) return;
    Node inertial = body.append_child("inertial");
    set(inertial, "pos", text_of(link.centre)), set(inertial, "mass", link.mass);
    if (link.boxes.size() > 1)
        losses_.add("links that are merged resist the medium as one: load with keep_fixed");
    if (link.boxes.size() == 1) {  // whose axes the medium knows
        set(inertial, "quat", text_of(link.boxes[0].pose.q));
        return set(inertial, "diaginertia", text_of(link.boxes[0].moments));
    }
    // MuJoCo takes zeros, which bodies that do not move may have, in this form alone.
    const bool is_diagonal = i[0][1] == 0 && i[0][2] == 0 && i[1][2] == 0;
    if (is_diagonal)
        set(inertial, "diaginertia", list_text({i[0][0], i[1][1], i[2][2]}));
    else
        set(inertial, "fullinertia", list_text({i[0][0], i[1][1], i[2][2], i[0][1], i[0][2], i[1][2]}));
}

// A <freejoint> where nothing else is to be said.
void MjcfWriter::write_joint(Node body, size_t number)
{
    const Joint& joint = model_.joints[number];
    const bool is_free = joint.kind == JointKind::kFree;
    const bool is_bare =
        is_free && joint.armature == 0 && joint.damping == 0 && joint.friction == 0 && joint.stiffness == 0;
    Node its = body.append_child(is_bare ? "freejoint" : "joint");
    set(its, "name", joints_[number]);
    if (is_bare) return;
    set(its, "type", name_of(joint.kind));
    if (!is_free) {
        set(its, "pos", text_of(joint.anchor)), set(its, "axis", text_of(joint.axis));
        set(its, "limited", yes(joint.limited));
        if (joint.limited) set(its, "range", range_of(joint.low, joint.high));
        if (joint.limited && joint.low == joint.high)
            losses_.add("MuJoCo itself wants a range with a width: joint '" + joint.name + "'");
    }
    write_passive(its, joint);
}

void MjcfWriter::write_passive(Node node, const Joint& joint)
{
    write_softness(node, "solreflimit", "solimplimit", joint.stop_softness);
    const std::pair<const char*, double> numbers[] = {
        {"ref", joint.reference},   {"springref", joint.spring_reference}, {"stiffness", joint.stiffness},
        {"damping", joint.damping}, {"armature", joint.armature},          {"frictionloss", joint.friction}};
    for (const auto& [name, value] : numbers)
        if (value != 0) set(node, name, value);
    if (std::isfinite(joint.max_force)) {
        set(node, "actuatorfrcrange", range_of(-joint.max_force, joint.max_force));
        set(node, "actuatorfrclimited", "true");
    }
    if (std::isfinite(joint.max_velocity))
        losses_.add("limits of velocities are not in MJCF: they stand in its <custom>, for Epode alone");
}

void MjcfWriter::write_size(Node geom, const Shape& shape)
{
    const Vec s = shape.size;
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return set(geom, "size", s.x);
        case ShapeKind::kCapsule:
        case ShapeKind::kCylinder:
            return set(geom, "size", list_text({s.x, s.y}));
        case ShapeKind::kBox:
        case ShapeKind::kEllipsoid:
            return set(geom, "size", text_of(s));
        case ShapeKind::kPlane:  // drawn size, and the spacing of its grid
            return set(geom, "size", list_text({s.x, s.y, s.z > 0 ? s.z : 1}));
        case ShapeKind::kTriangles:
            losses_.add("meshes touch as their convex hulls in MJCF, not as triangles");
            [[fallthrough]];
        case ShapeKind::kHull:
            return set(geom, "mesh", "mesh" + std::to_string(shape.mesh));
        case ShapeKind::kHeights:
            return set(geom, "hfield", "field" + std::to_string(shape.field));
    }
}

// Returns the name that it is written with.
std::string MjcfWriter::write_geom(Node body, const Shape& shape, bool touches)
{
    Node geom = body.append_child("geom");
    const std::string name = shape.name.empty() ? "" : geoms_.unique(shape.name, "geom", 0);
    if (!name.empty()) set(geom, "name", name);
    set(geom, "type", type_of(shape.kind));
    write_size(geom, shape);
    write_pose(geom, shape.pose);
    set(geom, "rgba", color_text(shape.color));
    set(geom, "contype", touches ? double(shape.category) : 0),
        set(geom, "conaffinity", touches ? double(shape.collide) : 0);
    if (!touches) return name;
    if (shape.priority != 0) set(geom, "priority", double(shape.priority));
    set(geom, "condim", shape.dimensions > 3 || shape.friction > 0 ? shape.dimensions : 1);
    set(geom, "friction", list_text({shape.friction, shape.torsional_friction, shape.rolling_friction}));
    write_softness(geom, "solref", "solimp", shape.softness);
    return name;
}

// What of the world does not touch some link is a body of its own again.
Node MjcfWriter::body_of(int link, const Shape& shape)
{
    return shape.still > 0 ? still_bodies_[size_t(shape.still) - 1] : bodies_[size_t(link)];
}

void MjcfWriter::write_bodies()
{
    bodies_.resize(model_.links.size());
    bodies_[0] = root_.append_child("worldbody");
    for (const std::string& name : still_) {
        still_bodies_.push_back(bodies_[0].append_child("body"));
        set(still_bodies_.back(), "name", name);
    }
    for (size_t i = 0; i < model_.links.size(); ++i) {
        const Link& link = model_.links[i];
        if (i > 0) {
            bodies_[i] = bodies_[size_t(link.parent)].append_child("body");
            set(bodies_[i], "name", links_[i]);
            write_pose(bodies_[i], link.pose);
            if (link.is_mocap) set(bodies_[i], "mocap", "true");
            if (link.is_weightless) set(bodies_[i], "gravcomp", 1.0);
            if (link.lifts.size() == 1 && link.lifts[0].mass == link.mass)
                set(bodies_[i], "gravcomp", link.lifts[0].share);
            else if (!link.lifts.empty())
                losses_.add("links that are merged have one share of gravity: load with keep_fixed");
            write_inertial(bodies_[i], link);
        }
        for (int joint : link.joints) write_joint(bodies_[i], size_t(joint));
        std::vector<std::string>& names = geom_names_.emplace_back();
        for (const Shape& shape : link.shapes)
            names.push_back(write_geom(body_of(int(i), shape), shape, true));
        for (const Shape& shape : link.visuals) names.push_back(write_geom(bodies_[i], shape, false));
    }
    for (size_t i = 0; i < model_.frames.size(); ++i) {
        const Frame& frame = model_.frames[i];
        Node site = bodies_[size_t(frame.link)].append_child("site");
        frames_.push_back(frame.name.empty() ? "" : sites_.unique(frame.name, "site", i));
        if (!frames_[i].empty()) set(site, "name", frames_[i]);
        write_pose(site, frame.pose);
        write_zone(site, frame);
    }
}

void MjcfWriter::write_cameras()
{
    Names names;
    for (const Camera& camera : model_.cameras) {
        Node its = bodies_[size_t(camera.frame.link)].append_child("camera");
        name_it(its, names, camera.frame.name);
        write_pose(its, camera.frame.pose);
        set(its, "fovy", camera.field * 180 / kPi);
    }
}

// None is one of zero size, which reads as none.
void MjcfWriter::write_zone(Node site, const Frame& frame)
{
    if (!(frame.size.x > 0)) return;
    set(site, "type", name_of(frame.zone)), set(site, "size", text_of(frame.size));
}

// A frame of the model that is there (by its place: turned anyhow), or a site made for it.
std::string MjcfWriter::site_at(int link, const Pose& pose, bool by_place)
{
    for (size_t i = 0; i < frames_.size(); ++i) {
        const Pose& its = model_.frames[i].pose;
        if (model_.frames[i].link == link && !frames_[i].empty() &&
            is_near(its, by_place ? Pose{pose.p, its.q} : pose))
            return frames_[i];
    }
    Node site = bodies_[size_t(link)].append_child("site");
    const std::string name = sites_.unique("", "loop", 1);
    set(site, "name", name);
    write_pose(site, pose);
    return name;
}

void MjcfWriter::write_closures()
{
    const std::vector<Pose> poses = forward_kinematics(model_, reference_positions(model_));
    for (const Closure& closure : model_.closures) {
        Node its = section("equality").append_child(closure.weld ? "weld" : "connect");
        name_it(its, equality_names_, closure.name);
        const Pose &one = poses[size_t(closure.link1)], &two = poses[size_t(closure.link2)];
        const Pose meant = closure.weld ? Pose{} : inverse(two) * (one * closure.pose1);
        if (!is_near(meant, closure.pose2)) {
            set(its, "site1", site_at(closure.link1, closure.pose1)),
                set(its, "site2", site_at(closure.link2, closure.pose2));
            continue;
        }
        set(its, "body1", links_[size_t(closure.link1)]), set(its, "body2", links_[size_t(closure.link2)]);
        if (closure.weld)
            set(its, "relpose", text_of(closure.pose1.p) + " " + text_of(closure.pose1.q));
        else
            set(its, "anchor", text_of(closure.pose1.p));
    }
}

void MjcfWriter::note_losses()
{
    if (!model_.touches_itself)
        losses_.add("in MJCF links that overlap at the reference position touch, but for Epode");
    if (!model_.largest_friction)
        losses_.add("MJCF takes the larger friction of a pair, not the geometric mean, but for Epode");
}

Node MjcfWriter::tuple(const char* name)
{
    const Node custom = section("custom"), found = custom.find_child_by_attribute("tuple", "name", name);
    if (found) return found;
    Node its = section("custom").append_child("tuple");
    set(its, "name", name);
    return its;
}

void MjcfWriter::write_custom()
{
    const auto text = [&](const char* name, const char* data) {
        Node its = section("custom").append_child("text");
        set(its, "name", name), set(its, "data", data);
    };
    if (!model_.touches_itself) text(kOverlapsName, kOverlapsApart);
    if (!model_.largest_friction) text(kFrictionName, kFrictionMean);
    for (size_t i = 0; i < model_.joints.size(); ++i) {
        if (!std::isfinite(model_.joints[i].max_velocity)) continue;
        Node its = tuple(kVelocitiesName).append_child("element");
        set(its, "objtype", "joint"), set(its, "objname", joints_[i]);
        set(its, "prm", model_.joints[i].max_velocity);
    }
}

WrittenRobot MjcfWriter::write()
{
    name_all();
    root_ = document_.append_child("mujoco");
    if (!model_.name.empty()) set(root_, "model", model_.name);
    Node compiler = root_.append_child("compiler");
    set(compiler, "angle", "radian"), set(compiler, "autolimits", "false"),
        set(compiler, "inertiafromgeom", "false");
    write_option(root_.append_child("option"));
    write_custom();
    write_meshes();
    write_fields();
    write_bodies();
    write_cameras();
    write_closures();
    write_tendons();
    write_couplings();
    write_ties();
    write_actuators();
    write_contacts_and_keys();
    write_sensors();
    note_losses();
    return {text_of(document_), losses_.all};
}

WrittenRobot write_mjcf(const RobotModel& model, const std::string& folder)
{
    return MjcfWriter(model, folder).write();
}

}  // namespace epode::robots
