// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The tree of bodies: see mjcf.h. A body's own joints, geoms and sites are read before the bodies in it, whatever
// their order in the file, since coordinates are counted in that order. <frame> moves what is in it.
#include <algorithm>

#include "robots/meshes/meshes.h"
#include "robots/numbers.h"
#include "robots/parts/hull.h"
#include "robots/read/mjcf.h"

namespace epode::robots {

namespace {

constexpr double kWater = 1000;  // kg/m^3
constexpr int kMaxDepth = 400;

bool is_round(ShapeKind kind) { return kind == ShapeKind::kCapsule || kind == ShapeKind::kCylinder; }

// Vertices and triangles of the hull in place of the mesh's. False of a plate.
bool take_hull(Mesh& mesh)
{
    const Hull hull = hull_of(mesh.vertices, 0);
    mesh.vertices = hull.corners();
    for (size_t i = 0; i < hull.polygons.size(); i += hull.polygons[i] + 1)
        for (unsigned k = 2; k < hull.polygons[i]; ++k)
            mesh.triangles.push_back({hull.polygons[i + 1], hull.polygons[i + k], hull.polygons[i + k + 1]});
    return !hull.is_empty();
}

// Each principal moment by itself, to at least the bound.
void raise_moments(Matrix& inertia, Quat guess, double bound)
{
    const PrincipalAxes axes = principal_axes(inertia, guess);
    const Vec m{std::max(axes.moments.x, bound), std::max(axes.moments.y, bound),
                std::max(axes.moments.z, bound)};
    inertia = rotated({{{m.x, 0, 0}, {0, m.y, 0}, {0, 0, m.z}}}, axes.q);
}

JointKind kind_of(const std::string& type)
{
    return type == "slide" ? JointKind::kSlide : type == "ball" ? JointKind::kBall : JointKind::kHinge;
}

}  // namespace

Quat Mjcf::turn_of_euler(Vec angles) const
{
    Quat q;
    for (int i = 0; i < 3; ++i) {
        const char axis = compiler_.euler[size_t(i)];
        const bool is_fixed = axis >= 'X' && axis <= 'Z';
        Vec direction;
        direction[is_fixed ? axis - 'X' : axis - 'x'] = 1;
        const Quat one = turn(direction, angle(angles[i]));
        q = is_fixed ? one * q : q * one;
    }
    return q;
}

Pose Mjcf::pose_of(const Attributes& attributes)
{
    Pose pose;
    std::vector<double> v;
    Vec three;
    vec(attributes, "pos", pose.p);
    if (list(attributes, "quat", 4, 4, v)) pose.q = normalised({v[0], v[1], v[2], v[3]});
    if (list(attributes, "axisangle", 4, 4, v)) pose.q = turn({v[0], v[1], v[2]}, angle(v[3]));
    if (vec(attributes, "euler", three)) pose.q = turn_of_euler(three);
    if (vec(attributes, "zaxis", three)) pose.q = turn_of_z(three);
    if (list(attributes, "xyaxes", 6, 6, v)) {
        Vec x{v[0], v[1], v[2]}, y{v[3], v[4], v[5]};
        if (length(x) > 0) x = (1 / length(x)) * x;
        y = y - dot(x, y) * x;
        if (length(y) > 0) y = (1 / length(y)) * y;
        const Vec z = cross(x, y);
        pose.q = turn_of({{{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}}});
    }
    return pose;
}

// Bodies that others must build first: what is in them is not read.
bool Mjcf::has_no_place(const Element& element)
{
    static const std::set<std::string> none{"composite", "flexcomp", "plugin"};
    if (!none.count(element.name())) return false;
    reading_.note(element.name() == "plugin" ? Note::kIgnored : Note::kError, element,
                  "<" + element.name() + "> in a body is not read");
    return true;
}

void Mjcf::read_bodies(const Element& body, const Scope& scope)
{
    const std::vector<Element> children = expand(body);
    Inertia of_geoms, inertial{-1, {}, {}};
    read_own(children, scope, of_geoms, &inertial);
    Link& link = model_.links[size_t(scope.link)];
    if (scope.link > 0) finish_link(link, of_geoms, inertial.mass >= 0 ? &inertial : nullptr);
    read_children(children, scope);
}

void Mjcf::read_own(const std::vector<Element>& children, const Scope& scope, Inertia& of_geoms,
                    Inertia* inertial)
{
    for (const Element& child : children) {
        const std::string name = child.name();
        if (name == "frame") {
            Scope inner = scope;
            inner.pose = scope.pose * pose_of({child, nullptr});
            if (child.has("childclass")) inner.childclass = child.text("childclass");
            if (++inner.depth < kMaxDepth) read_own(expand(child), inner, of_geoms, inertial);
            continue;
        }
        if (name == "body" || name == "light" || name == "attach" || has_no_place(child)) continue;
        const Attributes attributes = defaults_.of(child, scope.childclass, reading_);
        const bool is_of_bodies = name == "inertial" || name == "joint" || name == "freejoint";
        if (is_of_bodies && scope.link == 0) {
            reading_.error(child, "<" + name + "> in the world, which has none");
        } else if (name == "inertial") {
            read_inertial(attributes, scope.pose, *inertial);
        } else if (name == "joint") {
            read_joint(attributes, scope);
        } else if (name == "freejoint") {
            read_free_joint({child, nullptr}, scope);
        } else if (name == "geom") {
            read_geom(attributes, scope, of_geoms);
        } else if (name == "site") {
            read_site(attributes, scope);
        } else if (name == "camera") {
            read_camera(attributes, scope);
        } else {
            reading_.note(Note::kIgnored, child, "<" + name + "> in a body");
        }
    }
}

void Mjcf::read_children(const std::vector<Element>& children, const Scope& scope)
{
    for (const Element& child : children) {
        if (child.name() == "attach") attach(child, scope);
        if (child.name() != "body" && child.name() != "frame") continue;
        if (scope.depth >= kMaxDepth) return reading_.error(child, "bodies are nested deeper than 400");
        if (model_.links.size() > kMaxLinks) return reading_.error(child, Reading::too_many_links());
        Scope inner = scope;
        ++inner.depth;
        if (child.has("childclass")) inner.childclass = child.text("childclass");
        const Pose pose = scope.pose * pose_of({child, nullptr});
        if (child.name() == "frame") {
            inner.pose = pose;
            read_children(expand(child), inner);
            continue;
        }
        Link link;
        link.name = child.text("name"), link.parent = scope.link, link.pose = pose, link.line = child.line();
        inner.link = int(model_.links.size());
        inner.pose = {};
        model_.links.push_back(link);
        model_.links.back().is_mocap = child.text("mocap") == "true";
        if (model_.links.back().is_mocap && scope.link != 0)
            return reading_.error(child, "the mocap body '" + link.name + "' is no child of the world");
        double share = 0;
        if (reading_.number(child, "gravcomp", share) && share != 0)
            model_.links.back().lifts.push_back({{}, 0, share});
        read_bodies(child, inner);
    }
}

void Mjcf::read_inertial(const Attributes& attributes, const Pose& frame, Inertia& out)
{
    const Pose pose = frame * pose_of(attributes);
    Matrix tensor{};
    Vec d;
    std::vector<double> f;
    out.mass = 0;
    number(attributes, "mass", out.mass);
    if (vec(attributes, "diaginertia", d)) tensor = {{{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z}}};
    if (list(attributes, "fullinertia", 6, 6, f))
        tensor = {{{f[0], f[3], f[4]}, {f[3], f[1], f[5]}, {f[4], f[5], f[2]}}};
    out.centre = pose.p, out.tensor = rotated(tensor, pose.q), out.axes = pose.q;
    if (out.mass < 0) reading_.error(attributes.element(), "a negative mass"), out.mass = 0;
}

// A <freejoint> has no defaults; a <joint> of this type may have an armature, as all others.
// A zone where it says its size; MuJoCo's default, a sphere of 5 mm, hardly ever meets a contact, so that its sensor feels the link.
void Mjcf::read_site(const Attributes& a, const Scope& scope)
{
    static const std::map<std::string, ShapeKind> kinds{{"sphere", ShapeKind::kSphere},
                                                        {"box", ShapeKind::kBox},
                                                        {"capsule", ShapeKind::kCapsule},
                                                        {"cylinder", ShapeKind::kCylinder},
                                                        {"ellipsoid", ShapeKind::kEllipsoid}};
    Frame frame{a.element().text("name"), scope.link, pose_of(a)};
    const std::string type = a.has("type") ? a.text("type") : "sphere";
    const auto kind = kinds.find(type);
    if (kind != kinds.end())
        frame.zone = kind->second;
    else if (type != "sdf")
        return reading_.error(a.element(), "a site of type " + type);
    std::vector<double> size{0.005, 0.005, 0.005}, ends;
    list(a, "size", 1, 3, size);
    size.resize(3, size.back());
    if (list(a, "fromto", 6, 6, ends)) {
        const Vec from{ends[0], ends[1], ends[2]}, to{ends[3], ends[4], ends[5]};
        frame.pose = {0.5 * (from + to), turn_of_z(from - to)};
        (is_round(frame.zone) ? size[1] : size[2]) = length(to - from) / 2;
    }
    if (a.has("size") || a.has("fromto"))
        frame.size = {std::fabs(size[0]), std::fabs(size[1]), std::fabs(size[2])};
    frame.pose = scope.pose * frame.pose;
    model_.frames.push_back(frame);
}

void Mjcf::read_free_joint(const Attributes& a, const Scope& scope)
{
    const Element& element = a.element();
    if (model_.links[size_t(scope.link)].is_mocap)
        return reading_.error(element, "a body that the program moves (mocap) has no joints");
    Joint joint;
    joint.kind = JointKind::kFree, joint.name = element.text("name");
    joint.link = scope.link, joint.line = element.line();
    Link& link = model_.links[size_t(scope.link)];
    if (link.parent != 0 || !link.joints.empty())
        return reading_.error(element, "a free joint is the only one of a body of the world");
    const std::string align = a.text("align");
    if (align == "true" || (align != "false" && compiler_.align_free))
        reading_.note_once(Note::kChanged, element,
                           "frames of free bodies are the file's, not aligned with inertias");
    read_passive(a, joint);
    if (joint.armature > 0 || joint.stiffness > 0)
        reading_.note(Note::kApproximated, element,
                      "armature or stiffness of a free joint: a world's body has none");
    if (joint.damping > 0 || joint.friction > 0)
        reading_.note_once(
            Note::kChanged, element,
            "damping and friction of free joints act where dRobotAddForces is called before a step");
    link.joints.push_back(int(model_.joints.size()));
    model_.joints.push_back(joint);
}

void Mjcf::coefficient(const Attributes& a, const char* name, double& out)
{
    std::vector<double> values;
    if (!list(a, name, 1, 8, values)) return;
    out = std::max(0.0, values[0]);
    if (std::any_of(values.begin() + 1, values.end(), [](double value) { return value != 0; }))
        reading_.note_once(Note::kApproximated, a.element(),
                           a.element().name() + " " + name + " as its first coefficient");
}

// What acts on an axis by itself.
void Mjcf::read_passive(const Attributes& a, Joint& joint)
{
    std::vector<double> values;
    coefficient(a, "stiffness", joint.stiffness), coefficient(a, "damping", joint.damping);
    number(a, "armature", joint.armature), number(a, "frictionloss", joint.friction);
    joint.armature = std::max(0.0, joint.armature), joint.friction = std::max(0.0, joint.friction);
    if (list(a, "actuatorfrcrange", 2, 2, values) && a.text("actuatorfrclimited") != "false")
        joint.max_force = std::max(std::fabs(values[0]), std::fabs(values[1]));
}

void Mjcf::read_joint(const Attributes& a, const Scope& scope)
{
    const std::string type = a.text("type");
    if (type == "free") return read_free_joint(a, scope);
    if (!type.empty() && type != "slide" && type != "ball" && type != "hinge")
        return reading_.error(a.element(), "joint type '" + type + "'; there are hinge, slide, ball, free");
    if (model_.links[size_t(scope.link)].is_mocap)
        return reading_.error(a.element(), "a body that the program moves (mocap) has no joints");
    Joint joint;
    joint.name = a.element().text("name"), joint.link = scope.link, joint.line = a.element().line();
    joint.kind = kind_of(type);
    if (!fits_others(a, joint.kind, scope)) return;
    Vec axis{0, 0, 1}, anchor;
    vec(a, "axis", axis), vec(a, "pos", anchor);
    if (!(length(axis) > 1e-12 && length(axis) <= kMaxNumber))
        return reading_.error(a.element(), "a joint whose axis has no usable length");
    joint.axis = rotate(scope.pose.q, (1 / length(axis)) * axis), joint.anchor = scope.pose * anchor;
    if (!read_range(a, joint)) return;
    read_passive(a, joint);
    std::vector<double> spring;
    if (list(a, "springdamper", 2, 2, spring) && spring[0] > 0 && spring[1] > 0)
        springs_[int(model_.joints.size())] = {spring[0], spring[1]};
    read_softness(a, {"solreflimit", "solimplimit"}, joint.stop_softness);
    for (const char* soft : {"solreflimit", "solimplimit", "solreffriction", "margin"})
        if (a.has(soft)) reading_.note_once(Note::kApproximated, a.element(), std::string("joint ") + soft);
    model_.links[size_t(scope.link)].joints.push_back(int(model_.joints.size()));
    model_.joints.push_back(joint);
}

// As MuJoCo counts: at most six freedoms of a body, and what turns no more after a ball.
bool Mjcf::fits_others(const Attributes& a, JointKind kind, const Scope& scope)
{
    int freedoms = kind == JointKind::kBall ? 3 : 1;
    bool is_turned = false;
    for (int other : model_.links[size_t(scope.link)].joints) {
        const Joint& joint = model_.joints[size_t(other)];
        freedoms += joint.kind == JointKind::kFree ? 6 : joint.kind == JointKind::kBall ? 3 : 1;
        is_turned = is_turned || joint.kind == JointKind::kBall;
    }
    if (freedoms > 6)
        reading_.error(a.element(), "the joints of a body have more than six freedoms");
    else if (is_turned && kind != JointKind::kSlide)
        reading_.error(a.element(), "a joint that turns, behind a ball of the same body");
    else
        return true;
    return false;
}

void Mjcf::read_softness(const Attributes& a, const std::array<const char*, 2>& names, Softness& softness)
{
    std::vector<double> v;
    if (list(a, names[0], 1, 2, v)) {  // the second is 1 where it is left out
        softness.stated = true, softness.time = v[0];
        if (v.size() > 1) softness.ratio = v[1];
    }
    if (!list(a, names[1], 1, 5, v)) return;
    softness.stated = true;
    double* const to[] = {&softness.low, &softness.high, &softness.width, &softness.middle, &softness.power};
    for (size_t i = 0; i < v.size(); ++i) *to[i] = v[i];
}

// Limits, reference and rest. False and an error where the range ends before it begins.
bool Mjcf::read_range(const Attributes& a, Joint& joint)
{
    const bool turns = joint.kind != JointKind::kSlide;
    const auto in_rad = [&](double value) { return turns ? angle(value) : value; };
    std::vector<double> range;
    joint.limited = is_limited(a, "limited", "range");
    if (list(a, "range", 2, 2, range) && joint.limited)
        joint.low = in_rad(range[0]), joint.high = in_rad(range[1]);
    if (number(a, "ref", joint.reference)) joint.reference = in_rad(joint.reference);
    if (number(a, "springref", joint.spring_reference))
        joint.spring_reference = in_rad(joint.spring_reference);
    if (joint.kind == JointKind::kBall && joint.limited && joint.low != 0)
        return reading_.error(a.element(), "the range of the ball '" + joint.name + "' begins at 0"), false;
    if (!joint.limited || joint.low <= joint.high) return true;
    reading_.error(a.element(), "joint '" + joint.name + "' has a range that ends before it begins");
    return false;
}

// A mesh whose vertices stand in the file; without faces it is their hull. -1 and an error where it is neither.
int Mjcf::inline_mesh(const Asset& asset, bool counts_folds)
{
    const Element& element = asset.element;
    const std::string its = "the mesh '" + element.text("name") + "'";
    const auto refuse = [&](const std::string& problem) {
        return reading_.error(element, its + problem), -1;
    };
    constexpr size_t kMaxNumbers = 18'000'000;
    std::vector<double> numbers, corners;
    if (!element.has("vertex")) return refuse(" has no file and no vertices; built-in shapes are not read");
    if (!reading_.numbers(element, element.text("vertex"), "vertex", 12, kMaxNumbers, numbers)) return -1;
    reading_.numbers(element, element.text("face"), "face", 3, kMaxNumbers, corners);
    if (numbers.size() % 3 != 0 || corners.size() % 3 != 0)
        return refuse(" has vertices or faces of other than three numbers");
    Mesh mesh;
    for (size_t i = 0; i < numbers.size(); i += 3)
        mesh.vertices.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
    for (double corner : corners)
        if (!(corner >= 0 && corner < double(mesh.vertices.size()) && corner == std::floor(corner)))
            return refuse(" has a face with a corner that is no vertex");
    for (size_t i = 0; i < corners.size(); i += 3)
        mesh.triangles.push_back(
            {std::uint32_t(corners[i]), std::uint32_t(corners[i + 1]), std::uint32_t(corners[i + 2])});
    if (corners.empty() && !take_hull(mesh)) return refuse(" has all its vertices in one plane");
    scale_mesh(mesh, asset.scale);
    mesh.scale = {1, 1, 1}, mesh.counts_folds = counts_folds;
    model_.meshes.push_back(std::move(mesh));
    return int(model_.meshes.size()) - 1;
}

// Null and an error of a name that no mesh has, and of one that cannot be read.
const Frame* Mjcf::site_named(const std::string& name) const
{
    for (const Frame& frame : model_.frames)
        if (!name.empty() && frame.name == name) return &frame;
    return nullptr;
}

Mjcf::Asset* Mjcf::mesh_named(const std::string& name, const Element& where)
{
    const auto it = assets_.find(name);
    if (it == assets_.end()) return reading_.error(where, "there is no mesh '" + name + "'"), nullptr;
    Asset& asset = it->second;
    if (asset.tried) return asset.mesh < 0 ? nullptr : &asset;
    asset.tried = true;
    const bool counts_folds = asset.inertia.empty() || asset.inertia == "legacy";
    if (asset.element.text("file").empty())
        asset.mesh = inline_mesh(asset, counts_folds);
    else
        asset.mesh = reading_.mesh({Note::kError, asset.element.file(), asset.element.line()},
                                   {asset.file, folder_of(root_.file()), asset.scale, counts_folds});
    if (asset.mesh < 0) return nullptr;
    place(asset);
    return &asset;
}

// A vertex v of the file is S R^T (v - p) of the geom's frame, for the scale S and the reference (p, R). Meshes have S v, so that
// is a pose where S and R^T may change places; else the mesh gets vertices of its own.
void Mjcf::place(Asset& asset)
{
    const Vec s = asset.scale, p = asset.reference.p;
    const Quat back = conjugate(asset.reference.q);
    const bool may_change = std::fabs(back.w) == 1 || (s.x == s.y && s.y == s.z);
    if (may_change || s.x * s.y * s.z == 0) {
        asset.placed = inverse(Pose{scaled(p, s), asset.reference.q});
        return;
    }
    if (asset.element.has("file")) {  // other assets may have this file, too
        model_.meshes.push_back(model_.meshes[size_t(asset.mesh)]);
        asset.mesh = int(model_.meshes.size()) - 1;
    }
    Mesh& mesh = model_.meshes[size_t(asset.mesh)];
    scale_mesh(mesh, {1 / s.x, 1 / s.y, 1 / s.z});
    for (Vec& v : mesh.vertices) v = rotate(back, v - p);
    scale_mesh(mesh, s);
    mesh.path.clear(), mesh.scale = {1, 1, 1};
}

// Kind and size, and the pose that fromto means: across it a shape has its first size, in both directions. False: nothing to
// add; the report has why.
bool Mjcf::read_size(const Attributes& a, const std::string& type, Shape& shape)
{
    static const std::map<std::string, ShapeKind> kinds{
        {"sphere", ShapeKind::kSphere},     {"capsule", ShapeKind::kCapsule},
        {"cylinder", ShapeKind::kCylinder}, {"ellipsoid", ShapeKind::kEllipsoid},
        {"box", ShapeKind::kBox},           {"plane", ShapeKind::kPlane}};
    if (type == "hfield") return read_field(a, shape);
    if (type == "mesh" || (a.has("mesh") && type != "sdf")) return read_mesh(a, type, shape);
    const auto kind = kinds.find(type);
    if (kind == kinds.end())
        return reading_.note(Note::kIgnored, a.element(), "a geom of type " + type), false;
    shape.kind = kind->second;
    std::vector<double> size, ends;
    list(a, "size", 1, 3, size);
    size.resize(3, 0);
    shape.size = {size[0], size[1], size[2]};
    if (list(a, "fromto", 6, 6, ends)) {
        if (shape.kind == ShapeKind::kSphere || shape.kind == ShapeKind::kPlane)
            return reading_.error(a.element(), "a " + type + " has no fromto"), false;
        const Vec from{ends[0], ends[1], ends[2]}, to{ends[3], ends[4], ends[5]};
        const double half = length(to - from) / 2;
        shape.pose = {0.5 * (from + to), turn_of_z(from - to)};
        shape.size = is_round(shape.kind) ? Vec{size[0], half, 0} : Vec{size[0], size[0], half};
    }
    return has_good_size(a, type, shape);
}

bool Mjcf::read_mesh(const Attributes& a, const std::string& type, Shape& shape)
{
    shape.kind = reading_.options.meshes_as_triangles ? ShapeKind::kTriangles : ShapeKind::kHull;
    if (type != "mesh")
        reading_.note(Note::kApproximated, a.element(), "a " + type + " fitted to a mesh is the mesh");
    const Asset* asset = mesh_named(a.text("mesh"), a.element());
    if (!asset) return false;
    shape.mesh = asset->mesh, shape.pose = shape.pose * asset->placed;
    return true;
}

// What a shape does not use is 0.
bool Mjcf::has_good_size(const Attributes& a, const std::string& type, Shape& shape)
{
    if (shape.kind == ShapeKind::kPlane) return true;
    const int needed = shape.kind == ShapeKind::kSphere ? 1 : is_round(shape.kind) ? 2 : 3;
    for (int i = 0; i < 3; ++i) {
        if (i >= needed) shape.size[i] = 0;
        if (i < needed && !(shape.size[i] > 0))
            return reading_.error(a.element(), "a " + type + " whose size is not positive"), false;
    }
    return true;
}

void Mjcf::read_friction(const Attributes& a, Shape& shape)
{
    std::vector<double> values;
    double* const all[] = {&shape.friction, &shape.torsional_friction, &shape.rolling_friction};
    shape.torsional_friction = 0.005, shape.rolling_friction = 0.0001;
    if (list(a, "friction", 1, 3, values))
        for (size_t i = 0; i < values.size(); ++i) *all[i] = std::max(0.0, values[i]);
    double condim = 3;
    if (number(a, "condim", condim) && condim != 1 && condim != 3 && condim != 4 && condim != 6)
        reading_.error(a.element(), "geom condim is " + a.text("condim") + ", and there are 1 3 4 6");
    shape.dimensions = condim >= 6 ? 6 : condim >= 4 ? 4 : 3;
    if (condim == 1) shape.friction = 0;
    if (shape.dimensions == 4)
        reading_.note_once(Note::kApproximated, a.element(),
                           "condim 4: only batches have friction of torsion alone");
}

void Mjcf::read_geom(const Attributes& a, const Scope& scope, Inertia& of_geoms)
{
    Shape shape;
    shape.name = a.element().text("name");
    shape.pose = pose_of(a);
    const std::string type = a.has("type") ? a.text("type") : "sphere";
    if (!read_size(a, type, shape)) return;
    shape.pose = scope.pose * shape.pose;
    read_friction(a, shape);
    std::vector<double> values;
    double contype = 1, conaffinity = 1;
    number(a, "contype", contype), number(a, "conaffinity", conaffinity);
    shape.category = std::uint32_t(std::clamp(contype, 0.0, 4294967295.0));
    shape.collide = std::uint32_t(std::clamp(conaffinity, 0.0, 4294967295.0));
    read_color(a, shape);
    read_softness(a, {"solref", "solimp"}, shape.softness);
    double priority = 0;
    if (number(a, "priority", priority)) shape.priority = int(std::clamp(priority, -1e6, 1e6));
    for (const char* soft : {"solref", "solimp", "margin", "gap", "fluidshape"})
        if (a.has(soft)) reading_.note_once(Note::kApproximated, a.element(), std::string("geom ") + soft);
    add_mass(a, shape, of_geoms);
    Link& link = model_.links[size_t(scope.link)];
    (touches_ && (shape.category || shape.collide) ? link.shapes : link.visuals).push_back(shape);
}

// Its own, unless that is the grey of no choice and a material has one.
void Mjcf::read_color(const Attributes& a, Shape& shape)
{
    std::vector<double> values;
    if (list(a, "rgba", 4, 4, values))
        for (size_t i = 0; i < 4; ++i) shape.color[i] = float(values[i]);
    const bool is_grey = values.empty() || values == std::vector<double>{0.5, 0.5, 0.5, 1};
    if (const auto material = materials_.find(a.text("material")); is_grey && material != materials_.end())
        std::copy_n(material->second.begin(), 4, shape.color);
}

// The field of view is degrees whatever the compiler says; a sensor of some size behind a lens has one, too.
void Mjcf::read_camera(const Attributes& a, const Scope& scope)
{
    Camera camera;
    double degrees = 45;
    std::vector<double> sensor, focal, pixels;
    camera.frame = {a.element().text("name"), scope.link, scope.pose * pose_of(a)};
    number(a, "fovy", degrees);
    camera.field = degrees * kPi / 180;
    const bool has_lens = list(a, "focal", 2, 2, focal) && list(a, "sensorsize", 2, 2, sensor);
    if (has_lens && focal[1] > 0) camera.field = 2 * std::atan2(sensor[1] / 2, focal[1]);
    if (list(a, "focalpixel", 2, 2, focal) && list(a, "resolution", 2, 2, pixels) && focal[1] > 0)
        camera.field = 2 * std::atan2(pixels[1] / 2, focal[1]);
    if (!(camera.field > 0 && camera.field < kPi))
        return reading_.error(a.element(), "a camera whose field of view is not between 0 and 180 degrees");
    if (a.has("mode") && a.text("mode") != "fixed")
        reading_.note_once(Note::kChanged, a.element(),
                           "cameras that follow something (mode) are fixed to their bodies");
    model_.cameras.push_back(camera);
}

void Mjcf::add_mass(const Attributes& a, const Shape& shape, Inertia& of_geoms)
{
    double group = 0, mass = -1, density = kWater;
    number(a, "group", group);
    if (group < compiler_.low_group || group > compiler_.high_group) return;
    const Inertia one = unit_inertia(a, shape);
    number(a, "density", density);
    if (!number(a, "mass", mass)) mass = density * one.mass;
    if (mass > 0 && one.mass > 0) of_geoms = sum_of(of_geoms, with_mass(one, mass));
}

// At density 1, of a shell per area: as the geom says, or the asset of a mesh.
Inertia Mjcf::unit_inertia(const Attributes& a, const Shape& shape) const
{
    const auto asset = assets_.find(a.text("mesh"));
    const std::string its = shape.mesh >= 0 && asset != assets_.end() ? asset->second.inertia : "";
    if (its == "shell" || a.text("shellinertia") == "true") return shell_of(shape, model_.meshes);
    if (its != "convex") return inertia_of(shape, model_.meshes);
    Mesh hull = model_.meshes[size_t(shape.mesh)];
    hull.triangles.clear();
    Shape solid = shape;
    solid.mesh = 0;
    return take_hull(hull) ? inertia_of(solid, {hull}) : Inertia{};
}

void Mjcf::finish_link(Link& link, const Inertia& of_geoms, const Inertia* inertial)
{
    const bool by_geoms = compiler_.from_geoms == "true" || (compiler_.from_geoms == "auto" && !inertial);
    const Inertia none, &its = by_geoms ? of_geoms : inertial ? *inertial : none;
    link.mass = its.mass, link.centre = its.centre, link.inertia = its.tensor;
    link.inertia_axes = its.axes;
    link.has_inertial = its.mass > 0;
    link.mass = std::max(link.mass, compiler_.bound_mass);
    if (compiler_.bound_inertia > 0 && principal_moments(link.inertia)[0] < compiler_.bound_inertia)
        raise_moments(link.inertia, link.inertia_axes, compiler_.bound_inertia);
    if (compiler_.balance && !fault_of(link.inertia).empty() && link.mass > 0) {
        const auto m = principal_moments(link.inertia);
        const double mean = (m[0] + m[1] + m[2]) / 3;
        link.inertia = {{{mean, 0, 0}, {0, mean, 0}, {0, 0, mean}}};
        reading_.model.report.push_back(
            {Note::kChanged, root_.file(), link.line, "inertia of '" + link.name + "' balanced"});
    }
}

}  // namespace epode::robots
