// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The writer of MJCF. Angles are radians, inertias are written and never taken from geoms, limits say whether they are
// on, so that no default of the format decides anything. A coupling  f1 q1 + f2 q2 = o  becomes
//     q1 - r1 = c0 + c1 (q2 - r2),    c1 = -f2/f1,    c0 = o/f1 - r1 + c1 r2.
// A loop is said by the bodies and a point of the first where that means the same, else by two sites.
#include <cmath>
#include <map>

#include "robots/files/files.h"
#include "robots/files/mjcf_custom.h"
#include "robots/sensor_kinds.h"
#include "robots/write/text.h"
#include "robots/write/write.h"

namespace epode::robots {

namespace {

using Node = pugi::xml_node;

const char* type_of(ShapeKind kind)
{
    if (kind == ShapeKind::kHeights) return "hfield";
    return kind == ShapeKind::kHull || kind == ShapeKind::kTriangles ? "mesh" : name_of(kind);
}

const char* yes(bool value) { return value ? "true" : "false"; }

std::string range_of(double low, double high) { return list_text({low, high}); }

bool is_near(const Pose& a, const Pose& b)
{
    return length(a.p - b.p) < 1e-9 && std::fabs(1 - std::fabs((conjugate(a.q) * b.q).w)) < 1e-12;
}

// No two of a kind have one name.
void name_it(Node node, Names& names, const std::string& name)
{
    if (!name.empty()) set(node, "name", names.unique(name, "", 0));
}

class MjcfWriter {
  public:
    MjcfWriter(const RobotModel& model, const std::string& folder) : model_(model), folder_(folder) {}
    WrittenRobot write();

  private:
    void name_all();
    void write_option(Node option);
    void write_meshes();
    void write_fields();
    void write_bodies();
    void write_pose(Node node, const Pose& pose);
    void write_inertial(Node body, const Link& link);
    void write_joint(Node body, size_t number);
    void write_passive(Node node, const Joint& joint);
    std::string write_geom(Node body, const Shape& shape, bool touches);
    void write_size(Node geom, const Shape& shape);
    void write_closures();
    std::string site_at(int link, const Pose& pose, bool by_place = false);
    void write_couplings();
    void write_tendons();
    void write_tendon(const Tendon& tendon, const std::string& name);
    void write_part(Node tendon, const PathPart& part);
    std::string surface_of(const PathPart& part);
    void write_tendon_equality(const Coupling& coupling);
    void write_actuators();
    void write_gains(Node actuator, const Actuator& from, const std::string& kind);
    void write_contacts_and_keys();
    // The attribute that names what a sensor is on, its type, and the name; no attribute: not to be said.
    struct Sensed {
        std::string attribute, type, object;
    };
    Sensed joint_object(const Sensor& sensor) const;
    Sensed frame_object(const std::string& kind, const std::string& type, const std::string& name) const;
    void write_reference(Node its, const Sensor& sensor) const;
    void write_sensors();
    void write_custom();
    void write_cameras();
    Node tuple(const char* name);
    void note_losses();
    Node body_of(int link, const Shape& shape);
    Node section(const char* name);

    const RobotModel& model_;
    std::string folder_;
    pugi::xml_document document_;
    Node root_;
    std::vector<std::string> links_, joints_, tendons_;
    std::vector<Node> bodies_, still_bodies_;
    std::vector<std::string> still_;  // names of what stands apart
    Names sites_, geoms_, tendon_names_, equality_names_, actuator_names_, key_names_, sensor_names_;
    std::vector<std::string> frames_;                   // names of the model's, as written
    std::vector<std::vector<std::string>> geom_names_;  // by link: of what touches, then of looks
    Losses losses_;
};

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
    const Medium& medium = model_.medium;
    if (medium.density != 0) set(option, "density", medium.density);
    if (medium.viscosity != 0) set(option, "viscosity", medium.viscosity);
    if (length(medium.wind) > 0) set(option, "wind", text_of(medium.wind));
}

// Of a mesh without a file.
void write_corners(Node asset, const Mesh& mesh)
{
    std::vector<double> vertices, faces;
    for (Vec v : mesh.vertices) vertices.insert(vertices.end(), {v.x, v.y, v.z});
    for (const auto& t : mesh.triangles) faces.insert(faces.end(), t.begin(), t.end());
    set(asset, "vertex", list_text(vertices)), set(asset, "face", list_text(faces));
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
    if (!link.has_inertial && link.mass <= 0) return;
    const Matrix& i = link.inertia;
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

void write_softness(Node node, const char* reference, const char* impedance, const Softness& s)
{
    if (!s.stated) return;
    set(node, reference, list_text({s.time, s.ratio}));
    set(node, impedance, list_text({s.low, s.high, s.width, s.middle, s.power}));
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

// The tendons that it came from, or a tendon of its own.
void MjcfWriter::write_tendon_equality(const Coupling& coupling)
{
    const auto [one, two] = coupling.tendons;
    Node its = section("equality").append_child("tendon");
    name_it(its, equality_names_, coupling.name);
    if (one < 0) {
        Tendon own;
        own.terms = coupling.terms;
        tendons_.push_back(tendon_names_.unique("", "coupling", tendons_.size()));
        write_tendon(own, tendons_.back());
    }
    set(its, "tendon1", one < 0 ? tendons_.back() : tendons_[size_t(one)]);
    if (two >= 0) set(its, "tendon2", tendons_[size_t(two)]);
    std::vector<double> c{coupling.offset, coupling.ratio};
    for (const Coupling::Term& term : coupling.terms)
        c[0] -= term.factor * model_.joints[size_t(term.joint)].reference;
    c.insert(c.end(), coupling.polynomial.begin(), coupling.polynomial.end());
    c.resize(5, 0);
    set(its, "polycoef", list_text(c));
}

void MjcfWriter::write_couplings()
{
    for (const Coupling& coupling : model_.couplings) {
        const auto& terms = coupling.terms;
        if (terms.empty()) continue;
        if (coupling.tendons[0] >= 0 || terms.size() > 2 || terms[0].factor == 0) {
            write_tendon_equality(coupling);
            continue;
        }
        const double f1 = terms[0].factor, r1 = model_.joints[size_t(terms[0].joint)].reference;
        std::vector<double> c{coupling.offset / f1 - r1, 0};
        Node its = section("equality").append_child("joint");
        name_it(its, equality_names_, coupling.name);
        set(its, "joint1", joints_[size_t(terms[0].joint)]);
        if (terms.size() == 2) {
            set(its, "joint2", joints_[size_t(terms[1].joint)]);
            c[1] = -terms[1].factor / f1;
            c[0] += c[1] * model_.joints[size_t(terms[1].joint)].reference;
            c.insert(c.end(), coupling.polynomial.begin(), coupling.polynomial.end());
        }
        c.resize(5, 0);
        set(its, "polycoef", list_text(c));
    }
}

// Of a path's part the site, or the geom, which is made where there is none.
void MjcfWriter::write_part(Node tendon, const PathPart& part)
{
    using Kind = PathPart::Kind;
    if (part.kind == Kind::kPulley) return set(tendon.append_child("pulley"), "divisor", part.divisor);
    if (part.kind == Kind::kSite)
        return set(tendon.append_child("site"), "site", site_at(part.link, part.pose));
    Node its = tendon.append_child("geom");
    set(its, "geom", surface_of(part));
    if (part.side_link >= 0) set(its, "sidesite", site_at(part.side_link, {part.side, {}}, true));
}

std::string MjcfWriter::surface_of(const PathPart& part)
{
    const ShapeKind kind = part.kind == PathPart::Kind::kSphere ? ShapeKind::kSphere : ShapeKind::kCylinder;
    const Link& link = model_.links[size_t(part.link)];
    size_t number = 0;
    for (const auto* shapes : {&link.shapes, &link.visuals})
        for (const Shape& shape : *shapes) {
            const std::string& name = geom_names_[size_t(part.link)][number++];
            if (!name.empty() && shape.kind == kind && shape.size.x == part.radius &&
                is_near(shape.pose, part.pose))
                return name;
        }
    Shape own;
    own.kind = kind, own.pose = part.pose, own.size = {part.radius, part.radius, 0};
    own.name = "around", own.color[3] = 0;
    return write_geom(bodies_[size_t(part.link)], own, false);
}

void MjcfWriter::write_tendon(const Tendon& tendon, const std::string& name)
{
    Node its = section("tendon").append_child(tendon.path.empty() ? "fixed" : "spatial");
    const bool is_limited = std::isfinite(tendon.low) || std::isfinite(tendon.high);
    set(its, "name", name), set(its, "limited", yes(is_limited));
    if (is_limited) set(its, "range", range_of(tendon.low, tendon.high));
    if (tendon.stiffness != 0) set(its, "stiffness", tendon.stiffness);
    if (tendon.damping != 0) set(its, "damping", tendon.damping);
    if (tendon.has_rest) set(its, "springlength", range_of(tendon.rest, tendon.rest_high));
    for (const PathPart& part : tendon.path) write_part(its, part);
    for (const Coupling::Term& term : tendon.terms) {
        Node joint = its.append_child("joint");
        set(joint, "joint", joints_[size_t(term.joint)]), set(joint, "coef", term.factor);
    }
}

void MjcfWriter::write_tendons()
{
    for (size_t i = 0; i < model_.tendons.size(); ++i) write_tendon(model_.tendons[i], tendons_[i]);
}

// What the short kinds do not say is a general one.
std::string kind_of(const Actuator& a)
{
    if (a.muscle.acts) return "muscle";
    const bool is_plain = a.bias == 0 && a.activation.empty() && a.gain_position == 0 && a.gain_velocity == 0;
    if (a.kind == "position" && is_plain && a.gain == a.bias_position) return a.kind;
    if (a.kind == "velocity" && is_plain && a.gain == a.bias_velocity && a.bias_position == 0) return a.kind;
    const bool is_motor =
        a.kind == "motor" && is_plain && a.gain == 1 && a.bias_position == 0 && a.bias_velocity == 0;
    return is_motor ? a.kind : "general";
}

void MjcfWriter::write_gains(Node actuator, const Actuator& from, const std::string& kind)
{
    if (kind == "position") set(actuator, "kp", from.gain);
    if (kind == "position" || kind == "velocity") set(actuator, "kv", from.bias_velocity);
    if (kind == "muscle") {
        const Muscle& m = from.muscle;
        set(actuator, "timeconst", list_text({from.filter.time, from.filter.slower}));
        set(actuator, "tausmooth", from.filter.smooth), set(actuator, "range", range_of(m.low, m.high));
        set(actuator, "lengthrange", range_of(m.length_low, m.length_high));
        const std::pair<const char*, double> numbers[] = {{"force", m.force},   {"lmin", m.shortest},
                                                          {"lmax", m.longest},  {"vmax", m.fastest},
                                                          {"fpmax", m.passive}, {"fvmax", m.eccentric}};
        for (const auto& [name, value] : numbers) set(actuator, name, value);
    }
    if (kind != "general") return;
    const bool is_affine = from.gain_position != 0 || from.gain_velocity != 0;
    if (is_affine) set(actuator, "gaintype", "affine");
    set(actuator, "gainprm",
        is_affine ? list_text({from.gain, from.gain_position, from.gain_velocity}) : text_of(from.gain));
    set(actuator, "biastype", "affine");
    set(actuator, "biasprm", list_text({from.bias, -from.bias_position, -from.bias_velocity}));
}

void MjcfWriter::write_actuators()
{
    for (const Actuator& actuator : model_.actuators) {
        const std::string kind = kind_of(actuator);
        Node its = section("actuator").append_child(kind.c_str());
        name_it(its, actuator_names_, actuator.name);
        if (actuator.joint >= 0) set(its, "joint", joints_[size_t(actuator.joint)]);
        if (actuator.joint < 0) set(its, "tendon", tendons_[size_t(actuator.tendon)]);
        if (length(actuator.direction) > 0)
            set(its, "gear", text_of(actuator.direction) + " 0 0 0");
        else
            set(its, "gear", actuator.gear);
        const bool clamps_control = std::isfinite(actuator.low) || std::isfinite(actuator.high),
                   clamps_force = std::isfinite(actuator.force_low) || std::isfinite(actuator.force_high);
        set(its, "ctrllimited", yes(clamps_control)), set(its, "forcelimited", yes(clamps_force));
        if (clamps_control) set(its, "ctrlrange", range_of(actuator.low, actuator.high));
        if (clamps_force) set(its, "forcerange", range_of(actuator.force_low, actuator.force_high));
        write_gains(its, actuator, kind);
        for (const auto& [name, text] : actuator.activation) set(its, name.c_str(), text);
    }
}

void MjcfWriter::write_contacts_and_keys()
{
    for (const auto& pair : model_.excluded) {
        Node its = section("contact").append_child("exclude");
        set(its, "body1", links_[size_t(pair[0])]), set(its, "body2", links_[size_t(pair[1])]);
    }
    for (const auto& pair : model_.excluded_still) {
        Node its = section("contact").append_child("exclude");
        set(its, "body1", links_[size_t(pair[0])]), set(its, "body2", still_[size_t(pair[1]) - 1]);
    }
    for (const Start& start : model_.starts) {
        Node its = section("keyframe").append_child("key");
        name_it(its, key_names_, start.name);
        set(its, "qpos", list_text(start.positions));
        if (!start.controls.empty()) set(its, "ctrl", list_text(start.controls));
        std::vector<double> places, turns;
        for (const Pose& pose : start.mocap) {
            places.insert(places.end(), {pose.p.x, pose.p.y, pose.p.z});
            turns.insert(turns.end(), {pose.q.w, pose.q.x, pose.q.y, pose.q.z});
        }
        if (!places.empty()) set(its, "mpos", list_text(places)), set(its, "mquat", list_text(turns));
    }
}

// Kinds that are not computed as their file has named them, if it is MJCF.
void MjcfWriter::write_sensors()
{
    for (const Sensor& sensor : model_.sensors) {
        const bool of_frame = values_of_frame_sensor(sensor.kind) > 0;
        const Sensed on = values_of(sensor.kind) == 0
                              ? Sensed{sensor.attribute, sensor.object_type, sensor.object}
                          : of_frame ? frame_object(sensor.kind, sensor.object_type, sensor.object)
                                     : joint_object(sensor);
        if (on.attribute.empty()) {
            losses_.add("sensors of kind <" + sensor.kind + "> on '" + sensor.object + "' are not written");
            continue;
        }
        Node its = section("sensor").append_child(sensor.kind.c_str());
        name_it(its, sensor_names_, sensor.name);
        const bool is_force = sensor.kind == "force" || sensor.kind == "torque";
        if (is_force && !sensor.is_on_child && !sensor.name.empty()) {
            Node element = tuple(kOnParentName).append_child("element");
            set(element, "objtype", "sensor"), set(element, "objname", its.attribute("name").value());
        }
        if (!on.type.empty()) set(its, "objtype", on.type);
        set(its, on.attribute.c_str(), on.object);
        write_reference(its, sensor);
        if (is_force && !sensor.is_on_child)
            losses_.add(
                "force and torque sensors of MJCF read what acts on a link, not on its parent: the sign "
                "differs, but for Epode");
    }
}

void MjcfWriter::write_reference(Node its, const Sensor& sensor) const
{
    if (sensor.reference.empty()) return;
    const Sensed to = values_of(sensor.kind) == 0
                          ? Sensed{"refname", sensor.reference_type, sensor.reference}
                          : frame_object("frame", sensor.reference_type, sensor.reference);
    if (!to.object.empty()) set(its, "reftype", to.type), set(its, "refname", to.object);
}

MjcfWriter::Sensed MjcfWriter::joint_object(const Sensor& sensor) const
{
    if (sensor.kind == "actuatorfrc") return {"actuator", "", sensor.object};
    const int joint = model_.joint_named(sensor.object);
    if (values_of_joint_sensor(sensor.kind) == 0 || joint < 0) return {};
    return {"joint", "", joints_[size_t(joint)]};
}

// A body is its centre of mass, a link's own frame an xbody.
MjcfWriter::Sensed MjcfWriter::frame_object(const std::string& kind, const std::string& type,
                                            const std::string& name) const
{
    const bool says_type = kind.rfind("frame", 0) == 0, is_body = type == "body" || type == "xbody";
    const auto link = [&]() -> Sensed {
        for (size_t i = 0; i < model_.links.size(); ++i)
            if (says_type && model_.links[i].name == name)
                return {"objname", type == "body" ? "body" : "xbody", links_[i]};
        return {};
    };
    if (const Sensed its = link(); is_body && !its.attribute.empty()) return its;
    for (size_t i = 0; i < model_.frames.size(); ++i)
        if (!name.empty() && model_.frames[i].name == name)
            return {says_type ? "objname" : "site", says_type ? "site" : "", frames_[i]};
    return link();
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
    write_actuators();
    write_contacts_and_keys();
    write_sensors();
    note_losses();
    return {text_of(document_), losses_.all};
}

}  // namespace

WrittenRobot write_mjcf(const RobotModel& model, const std::string& folder)
{
    return MjcfWriter(model, folder).write();
}

}  // namespace epode::robots
