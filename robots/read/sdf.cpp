// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The reader of SDF, on libsdformat, which knows the format's versions and what its frames are relative to. Joints of SDF
// are a graph: the first one of a child is its place in the tree, and a later one closes a loop (of a hinge, by
// two points on its axis). A gearbox couples the two hinges on its reference body,  theta_2 = - ratio theta_1.
#include "robots/numbers.h"
#include "robots/read/sdf_counts.h"

namespace epode::robots {

#ifdef EPODE_HAVE_SDF

namespace {

using IgnitionPose = ignition::math::Pose3d;

constexpr double kUnlimited = 1e16;           // what SDF takes for no limit
constexpr int kMaxDepth = 64;                 // of models in models
constexpr double kLoopArm = 0.1;              // m, between the points that close a loop of a hinge
constexpr std::uint32_t kSelfBit = 1u << 31;  // the last model's; others count down

Vec vec_of(const ignition::math::Vector3d& v) { return {v.X(), v.Y(), v.Z()}; }
Pose pose_of(const IgnitionPose& pose)
{
    const auto& q = pose.Rot();
    return {vec_of(pose.Pos()), normalised({q.W(), q.X(), q.Y(), q.Z()})};
}

int line_of(const sdf::ElementPtr& element) { return element ? element->LineNumber().value_or(0) : 0; }

// A joint, with the links at its ends.
struct Edge {
    const sdf::Joint* joint = nullptr;
    std::string parent, child;  // scoped; the world has its own name
    std::string scope;
};

class Sdf {
  public:
    Sdf(Reading& reading, const std::string& folder)
        : reading_(reading), model_(reading.model), folder_(folder)
    {}
    void read(const sdf::Root& root);

  private:
    struct Source {
        const sdf::Link* link = nullptr;
        Pose pose;  // in the world, as the file has it
        bool is_static = false;
        std::uint32_t category = 1, collide = 1;
        int number = -1;
    };

    void collect(const sdf::Model& model, const Pose& pose, const std::string& scope, bool is_static,
                 int depth);
    void collect_joints(const sdf::Model& model, const std::string& scope);
    void collect_frames(const sdf::Model& model, const std::string& scope);
    void choose_tree();
    bool has_ends(const Edge& edge) const;
    void add_trees();
    void add_all_on(const std::string& root);
    void close_loops();
    void add_frames();
    void add_link(const std::string& name, int parent);
    void add_branches(const std::string& name, std::vector<const Edge*>& open);
    void read_inertial(const sdf::Link& from, Link& link);
    void read_shapes(const Source& source, Link& link);
    bool read_geometry(const sdf::Geometry& geometry, Note missing, int line, Shape& shape);
    bool read_mesh(const sdf::Mesh& mesh, Note missing, int line, Shape& shape);
    void read_joint(const Edge& edge);
    void add_axis(const Edge& edge, unsigned index, JointKind kind, bool is_limited);
    void read_axis(const sdf::JointAxis& axis, Joint& joint);
    Pose anchor_of(const Edge& edge);
    void close_loop(const Edge& edge);
    void add_closure(const Edge& edge, const Pose& at, bool weld);
    void read_gearbox(const Edge& edge);
    int hinge_between(const std::string& parent, const std::string& child) const;
    template <class Posed>
    bool resolve(const Posed& object, const std::string& frame, Pose& pose, int line);
    bool is_good(const sdf::Errors& errors, int line);
    void note(Note kind, int line, const std::string& text) { reading_.note(kind, model_.path, line, text); }

    Reading& reading_;
    RobotModel& model_;
    std::string folder_;
    std::map<std::string, Source> links_;
    std::vector<std::string> order_, roots_;  // of links
    std::vector<Edge> edges_;
    std::map<std::string, std::vector<const Edge*>> children_;
    std::set<const Edge*> in_tree_;
    std::vector<std::pair<const sdf::Frame*, std::string>> frames_;
    std::uint32_t self_bit_ = kSelfBit;
};

bool Sdf::is_good(const sdf::Errors& errors, int line)
{
    for (const sdf::Error& error : errors)
        note(Note::kError, error.LineNumber().value_or(line), error.Message());
    return errors.empty();
}

// A frame without a name is the object's default: its link or model.
template <class Posed>
bool Sdf::resolve(const Posed& object, const std::string& frame, Pose& pose, int line)
{
    IgnitionPose its;
    if (!is_good(object.SemanticPose().Resolve(its, frame), line)) return false;
    if (!its.IsFinite()) return note(Note::kError, line, "a pose that is not finite"), false;
    pose = pose_of(its);
    return true;
}

// Links of a model that has that pose in the world, then those of the models in it.
void Sdf::collect(const sdf::Model& model, const Pose& pose, const std::string& scope, bool is_static,
                  int depth)
{
    const int line = line_of(model.Element());
    if (depth > kMaxDepth) return note(Note::kError, line, "models are nested deeper than 64");
    const bool stands = is_static || model.Static();
    const std::uint32_t category = model.SelfCollide() ? 1 : self_bit_,
                        collide = model.SelfCollide() ? 1 : ~self_bit_;
    if (!model.SelfCollide() && self_bit_ > 1) self_bit_ >>= 1;
    for (std::uint64_t i = 0; i < model.LinkCount(); ++i) {
        const sdf::Link& link = *model.LinkByIndex(i);
        Pose inner;
        if (!resolve(link, "__model__", inner, line_of(link.Element()))) continue;
        links_[scope + link.Name()] = {&link, pose * inner, stands, category, collide, -1};
        order_.push_back(scope + link.Name());
    }
    collect_joints(model, scope);
    collect_frames(model, scope);
    if (model.Element()->HasElement("plugin")) note(Note::kIgnored, line, "plugins");
    for (std::uint64_t i = 0; i < model.ModelCount(); ++i) {
        const sdf::Model& inner = *model.ModelByIndex(i);
        Pose place;
        if (resolve(inner, "", place, line_of(inner.Element())))
            collect(inner, pose * place, scope + inner.Name() + "::", stands, depth + 1);
    }
}

void Sdf::collect_joints(const sdf::Model& model, const std::string& scope)
{
    for (std::uint64_t i = 0; i < model.JointCount(); ++i) {
        Edge edge{model.JointByIndex(i), "", "", scope};
        const int line = line_of(edge.joint->Element());
        if (!is_good(edge.joint->ResolveParentLink(edge.parent), line)) continue;
        if (!is_good(edge.joint->ResolveChildLink(edge.child), line)) continue;
        edge.child = scope + edge.child;
        if (edge.parent != "world") edge.parent = scope + edge.parent;
        edges_.push_back(edge);
    }
}

void Sdf::collect_frames(const sdf::Model& model, const std::string& scope)
{
    for (std::uint64_t i = 0; i < model.FrameCount(); ++i) frames_.push_back({model.FrameByIndex(i), scope});
}

void Sdf::read_inertial(const sdf::Link& from, Link& link)
{
    const auto& inertial = from.Inertial();
    const auto moments = inertial.Moi();  // in the link's axes
    link.mass = inertial.MassMatrix().Mass(), link.centre = vec_of(inertial.Pose().Pos());
    for (unsigned i = 0; i < 3; ++i)
        for (unsigned k = 0; k < 3; ++k) link.inertia[i][k] = moments(i, k);
    link.has_inertial = link.mass > 0;
    if (!std::isfinite(link.mass) || !is_finite(link.centre) || !is_finite(link.inertia))
        note(Note::kError, link.line, "link '" + link.name + "' has an inertial that is not finite");
    if (!from.Element()->HasElement("inertial"))
        note(Note::kChanged, link.line,
             "link '" + link.name + "' has no inertial: 1 kg and 1 kg m^2, as SDF says");
}

double friction_of(const sdf::ElementPtr& collision)
{
    sdf::ElementPtr at = collision;
    for (const char* name : {"surface", "friction", "ode", "mu"}) {
        if (!at || !at->HasElement(name)) return 1;
        at = at->GetElement(name);
    }
    const double mu = at->Get<double>();
    return std::isfinite(mu) && mu >= 0 ? mu : 1;
}

void Sdf::read_shapes(const Source& source, Link& link)
{
    for (std::uint64_t i = 0; i < source.link->CollisionCount(); ++i) {
        const sdf::Collision& from = *source.link->CollisionByIndex(i);
        const int line = line_of(from.Element());
        Shape shape;
        shape.name = from.Name(), shape.friction = friction_of(from.Element());
        shape.category = source.category, shape.collide = source.collide;
        if (resolve(from, "", shape.pose, line) && read_geometry(*from.Geom(), Note::kError, line, shape))
            link.shapes.push_back(shape);
    }
    for (std::uint64_t i = 0; i < source.link->VisualCount(); ++i) {
        const sdf::Visual& from = *source.link->VisualByIndex(i);
        const int line = line_of(from.Element());
        Shape shape;
        shape.name = from.Name();
        if (const sdf::Material* material = from.Material()) {
            auto color = material->Diffuse();  // its [] is not const
            for (unsigned k = 0; k < 4; ++k) shape.color[k] = color[k];
        }
        if (resolve(from, "", shape.pose, line) && read_geometry(*from.Geom(), Note::kIgnored, line, shape))
            link.visuals.push_back(shape);
    }
}

bool Sdf::read_mesh(const sdf::Mesh& mesh, Note missing, int line, Shape& shape)
{
    shape.kind = reading_.options.meshes_as_triangles ? ShapeKind::kTriangles : ShapeKind::kHull;
    if (!mesh.Submesh().empty())
        note(Note::kApproximated, line, "a submesh '" + mesh.Submesh() + "' as its whole mesh");
    const MeshFile file{mesh.Uri(), folder_, vec_of(mesh.Scale()), false};
    shape.mesh = reading_.mesh({missing, model_.path, line}, file);
    return shape.mesh >= 0;
}

// False: nothing to add; the report has why.
bool Sdf::read_geometry(const sdf::Geometry& geometry, Note missing, int line, Shape& shape)
{
    if (const sdf::Box* box = geometry.BoxShape()) {
        shape.kind = ShapeKind::kBox, shape.size = 0.5 * vec_of(box->Size());
    } else if (const sdf::Sphere* sphere = geometry.SphereShape()) {
        shape.kind = ShapeKind::kSphere, shape.size = {sphere->Radius(), 0, 0};
    } else if (const sdf::Cylinder* cylinder = geometry.CylinderShape()) {
        shape.kind = ShapeKind::kCylinder, shape.size = {cylinder->Radius(), cylinder->Length() / 2, 0};
    } else if (const sdf::Capsule* capsule = geometry.CapsuleShape()) {
        shape.kind = ShapeKind::kCapsule, shape.size = {capsule->Radius(), capsule->Length() / 2, 0};
    } else if (const sdf::Ellipsoid* ellipsoid = geometry.EllipsoidShape()) {
        shape.kind = ShapeKind::kEllipsoid, shape.size = vec_of(ellipsoid->Radii());
    } else if (const sdf::Plane* plane = geometry.PlaneShape()) {
        shape.kind = ShapeKind::kPlane, shape.pose.q = shape.pose.q * turn_of_z(vec_of(plane->Normal()));
        return true;
    } else if (const sdf::Mesh* mesh = geometry.MeshShape()) {
        return read_mesh(*mesh, missing, line, shape);
    } else {
        return note(Note::kIgnored, line,
                    "a shape that is no box, sphere, cylinder, capsule, ellipsoid, plane or mesh"),
               false;
    }
    const bool is_solid = shape.kind == ShapeKind::kBox || shape.kind == ShapeKind::kEllipsoid;
    const int sizes = is_solid ? 3 : shape.kind == ShapeKind::kSphere ? 1 : 2;
    for (int i = 0; i < sizes; ++i)
        if (!(shape.size[i] > 0 && std::isfinite(shape.size[i])))
            return note(missing, line, std::string("a ") + name_of(shape.kind) + " without a positive size"),
                   false;
    return true;
}

void Sdf::add_link(const std::string& name, int parent)
{
    Source& source = links_[name];
    Link link;
    link.name = name, link.parent = parent, link.line = line_of(source.link->Element());
    const Pose outer = parent > 0 ? links_[model_.links[size_t(parent)].name].pose : Pose{};
    link.pose = inverse(outer) * source.pose;
    read_inertial(*source.link, link);
    read_shapes(source, link);
    if (source.link->SensorCount() > 0) note(Note::kIgnored, link.line, "sensors of link '" + name + "'");
    source.number = int(model_.links.size());
    model_.links.push_back(link);
}

void Sdf::add_branches(const std::string& name, std::vector<const Edge*>& open)
{
    const auto& edges = children_[name];
    open.insert(open.end(), edges.rbegin(), edges.rend());
}

// The first joint of a child, but of one that stands still.
void Sdf::choose_tree()
{
    std::set<std::string> has_parent;
    for (const Edge& edge : edges_) {
        if (edge.joint->Type() == sdf::JointType::GEARBOX || !has_ends(edge)) continue;
        if (links_[edge.child].is_static || !has_parent.insert(edge.child).second) continue;
        children_[edge.parent].push_back(&edge), in_tree_.insert(&edge);
    }
    for (const std::string& name : order_)
        if (!has_parent.count(name)) roots_.push_back(name);
}

bool Sdf::has_ends(const Edge& edge) const
{
    return links_.count(edge.child) && (edge.parent == "world" || links_.count(edge.parent));
}

// All that hangs on a link, branch by branch.
void Sdf::add_all_on(const std::string& root)
{
    std::vector<const Edge*> open;
    add_branches(root, open);
    while (!open.empty()) {
        const Edge& edge = *open.back();
        open.pop_back();
        add_link(edge.child, edge.parent == "world" ? 0 : links_[edge.parent].number);
        read_joint(edge);
        add_branches(edge.child, open);
    }
}

// Links without a parent are free, unless their model is static.
void Sdf::add_trees()
{
    choose_tree();
    add_all_on("world");
    for (const std::string& name : roots_) {
        add_link(name, 0);
        if (!links_[name].is_static && !reading_.options.fixed_base) {
            Joint joint;
            joint.kind = JointKind::kFree, joint.name = name, joint.link = links_[name].number;
            model_.links.back().joints.push_back(int(model_.joints.size()));
            model_.joints.push_back(joint);
        }
        add_all_on(name);
    }
    for (const std::string& name : order_)
        if (links_[name].number < 0)
            note(Note::kError, line_of(links_[name].link->Element()),
                 "link '" + name + "' hangs on a ring of joints");
}

// The joint's frame in its child.
Pose Sdf::anchor_of(const Edge& edge)
{
    Pose pose;
    resolve(*edge.joint, edge.joint->ChildLinkName(), pose, line_of(edge.joint->Element()));
    return pose;
}

void Sdf::read_axis(const sdf::JointAxis& axis, Joint& joint)
{
    if (joint.limited) {
        joint.low = axis.Lower(), joint.high = axis.Upper();
        joint.limited = joint.low > -kUnlimited || joint.high < kUnlimited;
        if (!(joint.low <= joint.high))
            note(Note::kError, joint.line,
                 "joint '" + joint.name + "' has a lower limit above the upper one");
    }
    if (!joint.limited) joint.low = -kInfinity, joint.high = kInfinity;
    if (axis.Effort() >= 0 && axis.Effort() < kUnlimited) joint.max_force = axis.Effort();
    if (axis.MaxVelocity() >= 0 && axis.MaxVelocity() < kUnlimited) joint.max_velocity = axis.MaxVelocity();
    joint.damping = axis.Damping(), joint.friction = axis.Friction();
    joint.stiffness = axis.SpringStiffness(), joint.spring_reference = axis.SpringReference();
    for (double value : {joint.damping, joint.friction, joint.stiffness})
        if (!(value >= 0 && std::isfinite(value)))
            note(Note::kError, joint.line,
                 "joint '" + joint.name +
                     "' has a damping, friction or stiffness that is negative or not finite");
    if (!std::isfinite(joint.spring_reference))
        note(Note::kError, joint.line, "a spring reference that is not finite");
}

void Sdf::add_axis(const Edge& edge, unsigned index, JointKind kind, bool is_limited)
{
    Joint joint;
    joint.kind = kind, joint.link = links_[edge.child].number, joint.line = line_of(edge.joint->Element());
    joint.name = edge.scope + edge.joint->Name() + (index > 0 ? "/second" : "");
    joint.anchor = anchor_of(edge).p, joint.limited = is_limited;
    if (const sdf::JointAxis* axis = edge.joint->Axis(index); axis && kind != JointKind::kBall) {
        ignition::math::Vector3d xyz;
        if (!is_good(axis->ResolveXyz(xyz, edge.joint->ChildLinkName()), joint.line)) return;
        joint.axis = vec_of(xyz);
        if (!(length(joint.axis) > 1e-9 && length(joint.axis) <= kMaxNumber))
            return note(Note::kError, joint.line,
                        "joint '" + joint.name + "' has an axis of no usable length");
        joint.axis = (1 / length(joint.axis)) * joint.axis;
        read_axis(*axis, joint);
    }
    model_.links[size_t(joint.link)].joints.push_back(int(model_.joints.size()));
    model_.joints.push_back(joint);
}

void Sdf::read_joint(const Edge& edge)
{
    const int line = line_of(edge.joint->Element());
    switch (edge.joint->Type()) {
        case sdf::JointType::FIXED:
            return;
        case sdf::JointType::REVOLUTE:
            return add_axis(edge, 0, JointKind::kHinge, true);
        case sdf::JointType::CONTINUOUS:
            return add_axis(edge, 0, JointKind::kHinge, false);
        case sdf::JointType::PRISMATIC:
            return add_axis(edge, 0, JointKind::kSlide, true);
        case sdf::JointType::BALL:
            return add_axis(edge, 0, JointKind::kBall, false);
        case sdf::JointType::REVOLUTE2:
        case sdf::JointType::UNIVERSAL:
            add_axis(edge, 0, JointKind::kHinge, true);
            return add_axis(edge, 1, JointKind::kHinge, true);
        default:
            note(Note::kError, line,
                 "the joint '" + edge.joint->Name() +
                     "' has a type that is not read; there are revolute, "
                     "revolute2, universal, continuous, prismatic, ball, fixed, gearbox");
    }
}

void Sdf::add_closure(const Edge& edge, const Pose& at, bool weld)
{
    const Source& child = links_[edge.child];
    const Pose outer = edge.parent == "world" ? Pose{} : links_[edge.parent].pose;
    Closure closure;
    closure.name = edge.scope + edge.joint->Name(), closure.line = line_of(edge.joint->Element()),
    closure.weld = weld;
    closure.link1 = child.number, closure.pose1 = at;
    closure.link2 = edge.parent == "world" ? 0 : links_[edge.parent].number;
    closure.pose2 = inverse(outer) * child.pose * at;
    model_.closures.push_back(closure);
}

void Sdf::close_loop(const Edge& edge)
{
    const Pose at = anchor_of(edge);
    const sdf::JointType type = edge.joint->Type();
    if (type == sdf::JointType::FIXED) return add_closure(edge, at, true);
    if (type == sdf::JointType::BALL) return add_closure(edge, {at.p, {}}, false);
    ignition::math::Vector3d xyz;
    const sdf::JointAxis* axis = edge.joint->Axis(0);
    const bool turns = type == sdf::JointType::REVOLUTE || type == sdf::JointType::CONTINUOUS;
    if (!turns || !axis ||
        !is_good(axis->ResolveXyz(xyz, edge.joint->ChildLinkName()), line_of(edge.joint->Element())))
        return note(Note::kIgnored, line_of(edge.joint->Element()),
                    "the joint '" + edge.joint->Name() + "', which closes a loop");
    add_closure(edge, {at.p, {}}, false);
    add_closure(edge, {at.p + kLoopArm * vec_of(xyz), {}}, false);
    model_.closures.back().name += "/second";
    note(Note::kChanged, line_of(edge.joint->Element()),
         "the joint '" + edge.joint->Name() +
             "' closes a loop: two points of its axis, without its limits and drive");
}

// -1 where the links have no hinge between them.
int Sdf::hinge_between(const std::string& parent, const std::string& child) const
{
    for (const Edge* edge : in_tree_) {
        if (edge->parent != parent || edge->child != child) continue;
        const Link& link = model_.links[size_t(links_.at(child).number)];
        if (link.joints.size() == 1 && model_.joints[size_t(link.joints[0])].kind == JointKind::kHinge)
            return link.joints[0];
    }
    return -1;
}

void Sdf::read_gearbox(const Edge& edge)
{
    const int line = line_of(edge.joint->Element());
    const std::string body = edge.scope + edge.joint->Element()->Get<std::string>("gearbox_reference_body");
    const double ratio = edge.joint->Element()->Get<double>("gearbox_ratio");
    const int first = hinge_between(body, edge.parent), second = hinge_between(body, edge.child);
    if (first < 0 || second < 0 || !std::isfinite(ratio))
        return note(
            Note::kIgnored, line,
            "the gearbox '" + edge.joint->Name() + "', whose links are not both on hinges of '" + body + "'");
    // The angles count along the gearbox's axes, the hinges may turn the other way.
    const auto sign = [&](unsigned index, int hinge) {
        const Joint& joint = model_.joints[size_t(hinge)];
        const std::string link = model_.links[size_t(joint.link)].name.substr(edge.scope.size());
        ignition::math::Vector3d xyz;
        const sdf::JointAxis* axis = edge.joint->Axis(index);
        if (!axis || !axis->ResolveXyz(xyz, link).empty()) return 1.0;
        return dot(vec_of(xyz), joint.axis) < 0 ? -1.0 : 1.0;
    };
    Coupling coupling;
    coupling.name = edge.scope + edge.joint->Name(), coupling.line = line;
    coupling.terms = {{second, sign(1, second)}, {first, ratio * sign(0, first)}};
    model_.couplings.push_back(coupling);
}

void Sdf::read(const sdf::Root& root)
{
    model_.touches_itself = true;
    Link world;
    world.name = "world";
    model_.links.push_back(world);
    if (const sdf::Model* model = root.Model()) {
        model_.name = model->Name();
        collect(*model, pose_of(model->RawPose()), "", false, 0);
    }
    for (std::uint64_t i = 0; i < root.WorldCount(); ++i) {
        const sdf::World& its = *root.WorldByIndex(i);
        model_.name = its.Name(), model_.gravity = vec_of(its.Gravity());
        const sdf::Physics* const physics = its.PhysicsDefault();
        if (physics && physics->Element() && physics->Element()->GetExplicitlySetInFile())
            model_.stepsize = physics->MaxStepSize();
        for (std::uint64_t k = 0; k < its.ModelCount(); ++k) {
            const sdf::Model& model = *its.ModelByIndex(k);
            Pose place;
            if (resolve(model, "", place, line_of(model.Element())))
                collect(model, place, model.Name() + "::", false, 0);
        }
    }
    if (links_.size() > kMaxLinks) note(Note::kError, 0, Reading::too_many_links());
    if (model_.has_errors()) return;
    add_trees();
    number_coordinates(model_);
    if (model_.has_errors()) return;
    close_loops();
    add_frames();
    reading_.add_motors();
}

void Sdf::close_loops()
{
    for (const Edge& edge : edges_) {
        if (edge.joint->Type() == sdf::JointType::GEARBOX)
            read_gearbox(edge);
        else if (!in_tree_.count(&edge) && has_ends(edge))
            close_loop(edge);
    }
}

void Sdf::add_frames()
{
    for (const auto& [frame, scope] : frames_) {
        std::string body;
        Frame out;
        const int line = line_of(frame->Element());
        if (!is_good(frame->ResolveAttachedToBody(body), line) || !links_.count(scope + body)) continue;
        if (!resolve(*frame, body, out.pose, line)) continue;
        out.name = scope + frame->Name(), out.link = links_[scope + body].number;
        model_.frames.push_back(out);
    }
}

// Other files are never opened: libsdformat would look for them outside of the roots.
bool has_includes(const Element& root, Reading& reading)
{
    std::vector<Element> open{root};
    bool found = false;
    while (!open.empty()) {
        const Element element = open.back();
        open.pop_back();
        if (element.name() == "include")
            reading.error(element, "<include> is not read in SDF; give the model's own file"), found = true;
        const std::vector<Element> children = element.children();
        open.insert(open.end(), children.rbegin(), children.rend());
    }
    return found;
}

}  // namespace

void read_sdf(const Element& root, const std::string& text, Reading& reading)
{
    if (has_includes(root, reading)) return;
    sdf::Console::Instance()->SetQuiet(true);
    sdf::ParserConfig config;
    config.SetFindCallback([](const std::string&) { return std::string(); });
    try {
        sdf::Root document;
        const sdf::Errors errors = document.LoadSdfString(text, config);
        for (const sdf::Error& error : errors)
            if (error.Code() != sdf::ErrorCode::LINK_INERTIA_INVALID)  // load.cpp judges inertias
                reading.note(Note::kError, reading.model.path, error.LineNumber().value_or(0),
                             error.Message());
        if (!reading.model.has_errors()) check_sdf_counts(document.Element(), root, reading);
        if (!reading.model.has_errors()) Sdf(reading, folder_of(root.file())).read(document);
    } catch (const std::exception& problem) {
        reading.error(root, std::string("libsdformat: ") + problem.what());
    }
}

#else

void read_sdf(const Element& root, const std::string&, Reading& reading)
{
    reading.error(root, "this build does not read SDF: it wants libsdformat-dev, then cmake again");
}

#endif

}  // namespace epode::robots
