// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// <attach>: a body of another file, and all on it, with a prefix before its names. The other file is a model of its own, read
// with its own compiler and defaults; its links go where the element stands, what acts on them behind what acts on ours. What
// refers to something that is left behind is left behind too, as in MuJoCo.
#include <algorithm>

#include "robots/pairs.h"
#include "robots/read/mjcf.h"

namespace epode::robots {

namespace {

constexpr size_t kMaxNested = 64;
constexpr int kMaxAttached = 200'000;

// Where the links and joints of the other model went; -1: left behind.
struct Moved {
    const RobotModel& other;
    std::string prefix;
    std::vector<int> links, joints, tendons;
    size_t mesh = 0, field = 0;  // how many of ours come before
    Pose world{};                // of the other's in the link that it became part of

    // From a link of the other to ours, and a pose or point in it.
    template <typename Place>
    void move(int& link, Place& place) const
    {
        if (link == 0) place = world * place;
        link = links[size_t(link)];
    }
    int joint(int number) const { return number < 0 ? -1 : joints[size_t(number)]; }
    bool has(const std::vector<Coupling::Term>& terms) const
    {
        return std::all_of(terms.begin(), terms.end(), [&](const auto& t) { return joint(t.joint) >= 0; });
    }
    void change(std::vector<Coupling::Term>& terms) const
    {
        for (Coupling::Term& term : terms) term.joint = joint(term.joint);
    }
    std::string name(const std::string& its) const { return its.empty() ? its : prefix + its; }
};

void take_shape(const Moved& moved, const Pose& pose, Shape shape, std::vector<Shape>& into)
{
    shape.name = moved.name(shape.name), shape.pose = pose * shape.pose, shape.still = 0;
    if (shape.mesh >= 0) shape.mesh += int(moved.mesh);
    if (shape.field >= 0) shape.field += int(moved.field);
    into.push_back(shape);
}

void take_joints(RobotModel& model, Moved& moved, const Link& from, int link)
{
    for (int number : from.joints) {
        Joint joint = moved.other.joints[size_t(number)];
        joint.name = moved.name(joint.name), joint.link = link;
        moved.joints[size_t(number)] = int(model.joints.size());
        model.links[size_t(link)].joints.push_back(int(model.joints.size()));
        model.joints.push_back(joint);
    }
}

void take_shapes(RobotModel& model, const Moved& moved, const Link& from, int link, const Pose& pose)
{
    Link& into = model.links[size_t(link)];
    for (const Shape& shape : from.shapes) take_shape(moved, pose, shape, into.shapes);
    for (const Shape& shape : from.visuals) take_shape(moved, pose, shape, into.visuals);
}

void take_link(RobotModel& model, Moved& moved, size_t number, int parent, const Pose& pose)
{
    const Link& from = moved.other.links[number];
    Link link = from;
    link.name = moved.name(from.name), link.parent = parent, link.pose = pose;
    link.joints.clear(), link.shapes.clear(), link.visuals.clear(), link.boxes.clear();
    link.is_mocap = link.is_mocap && parent == 0;
    const int its = int(model.links.size());
    moved.links[number] = its;
    model.links.push_back(link);
    take_joints(model, moved, from, its);
    take_shapes(model, moved, from, its, {});
}

void take_tendons(RobotModel& model, Moved& moved)
{
    for (size_t i = 0; i < moved.other.tendons.size(); ++i) {
        Tendon tendon = moved.other.tendons[i];
        bool is_whole = moved.has(tendon.terms);
        for (PathPart& part : tendon.path) {
            if (part.kind != PathPart::Kind::kPulley) moved.move(part.link, part.pose);
            const bool has_side = part.side_link >= 0;
            if (has_side) moved.move(part.side_link, part.side);
            is_whole = is_whole && (!has_side || part.side_link >= 0);
            is_whole = is_whole && (part.kind == PathPart::Kind::kPulley || part.link >= 0);
        }
        if (!is_whole) continue;
        moved.change(tendon.terms), tendon.name = moved.name(tendon.name);
        moved.tendons[i] = int(model.tendons.size());
        model.tendons.push_back(tendon);
    }
}

void take_equalities(RobotModel& model, const Moved& moved)
{
    for (Coupling coupling : moved.other.couplings) {
        bool is_whole = moved.has(coupling.terms);
        for (int& tendon : coupling.tendons)
            if (tendon >= 0) tendon = moved.tendons[size_t(tendon)], is_whole = is_whole && tendon >= 0;
        if (!is_whole) continue;
        moved.change(coupling.terms), coupling.name = moved.name(coupling.name);
        model.couplings.push_back(coupling);
    }
    for (Closure closure : moved.other.closures) {
        moved.move(closure.link1, closure.pose1), moved.move(closure.link2, closure.pose2);
        closure.name = moved.name(closure.name);
        if (closure.link1 >= 0 && closure.link2 >= 0) model.closures.push_back(closure);
    }
    for (Tie tie : moved.other.ties) {
        bool is_whole = true;
        for (int* tendon : {&tie.tendon1, &tie.tendon2})
            if (*tendon >= 0) *tendon = moved.tendons[size_t(*tendon)], is_whole = is_whole && *tendon >= 0;
        tie.name = moved.name(tie.name);
        if (is_whole) model.ties.push_back(tie);
    }
    for (ShapePair pair : moved.other.pairs) {
        for (std::string* name : {&pair.name, &pair.shape1, &pair.shape2}) *name = moved.name(*name);
        int link = 0;
        if (shape_named(model, pair.shape1, link) && shape_named(model, pair.shape2, link))
            model.pairs.push_back(pair);
    }
    for (auto pair : moved.other.excluded) {
        for (int& link : pair) link = moved.links[size_t(link)];
        if (pair[0] >= 0 && pair[1] >= 0) model.excluded.push_back(pair);
    }
}

// Returns which of the other's actuators are ours.
std::vector<bool> take_actuators(RobotModel& model, const Moved& moved)
{
    std::vector<bool> out;
    for (Actuator actuator : moved.other.actuators) {
        SiteWrench& wrench = actuator.wrench;
        const bool has_reference = wrench.reference_link >= 0;
        if (wrench.link >= 0) moved.move(wrench.link, wrench.pose);
        if (has_reference) moved.move(wrench.reference_link, wrench.reference);
        if (has_reference && wrench.reference_link < 0) wrench.link = -1;
        if (actuator.adhesive_link >= 0) actuator.adhesive_link = moved.links[size_t(actuator.adhesive_link)];
        if (actuator.tendon >= 0) actuator.tendon = moved.tendons[size_t(actuator.tendon)];
        actuator.joint = moved.joint(actuator.joint);
        out.push_back(actuator.joint >= 0 || actuator.tendon >= 0 || wrench.link >= 0 ||
                      actuator.adhesive_link >= 0);
        actuator.name = moved.name(actuator.name);
        if (out.back()) model.actuators.push_back(actuator);
    }
    return out;
}

// What a sensor is on has the prefix now; where it was left behind there is none of that name.
void take_sensors(RobotModel& model, const Moved& moved)
{
    for (Sensor sensor : moved.other.sensors) {
        const std::string object = moved.name(sensor.object), reference = moved.name(sensor.reference);
        Frame frame;
        int link = 0;
        const auto is_there = [&](const std::string& name) {
            return name.empty() || model.any_shape_named(name, link) || model.frame_named(name, frame) ||
                   model.joint_named(name) >= 0 || model.actuator_named(name) >= 0 ||
                   model.tendon_named(name) >= 0;
        };
        if (!is_there(object) || !is_there(reference)) continue;
        sensor.name = moved.name(sensor.name), sensor.object = object, sensor.reference = reference;
        model.sensors.push_back(sensor);
    }
}

// Start poses with the prefix: what is not theirs stands at the reference.
void take_starts(RobotModel& model, const Moved& moved, const std::vector<bool>& actuators, size_t first)
{
    for (const Start& from : moved.other.starts) {
        Start start;
        start.name = moved.name(from.name), start.positions = reference_positions(model);
        for (size_t i = 0; i < moved.joints.size(); ++i) {
            if (moved.joints[i] < 0) continue;
            const Joint& joint = model.joints[size_t(moved.joints[i])];
            std::copy_n(from.positions.begin() + moved.other.joints[i].position, joint.coordinates(),
                        start.positions.begin() + joint.position);
        }
        size_t to = first;
        for (size_t i = 0; i < actuators.size() && i < from.controls.size(); ++i) {
            if (!actuators[i]) continue;
            start.controls.resize(model.actuators.size(), 0);
            start.controls[to++] = from.controls[i];
        }
        model.starts.push_back(start);
    }
}

}  // namespace

// What was taken, until all that is ours has been read.
struct Mjcf::Attached {
    std::shared_ptr<const RobotModel> other;
    Moved moved;
    std::vector<bool> actuators{};  // which of the other's are ours, and where they begin
    size_t first = 0;
};

std::shared_ptr<const RobotModel> Mjcf::model_of_file(const Element& where, ModelFile& asset)
{
    std::shared_ptr<RobotModel>& model = asset.model;
    if (model) return model->has_errors() ? nullptr : model;
    model = std::make_shared<RobotModel>();
    std::string problem;
    const std::string path = reading_.files.resolve(asset.file, folder_of(root_.file()), problem);
    const auto text = path.empty() ? std::nullopt : reading_.files.read(path, problem);
    const auto document = text ? parse_xml(path, *text, problem) : nullptr;
    if (std::find(including_.begin(), including_.end(), path) != including_.end())
        problem = "'" + path + "' attaches itself";
    if (including_.size() > kMaxNested) problem = "files that attach others are deeper than 64";
    RobotModel& its = *model;
    its.path = path;
    Reading reading(its, reading_.options, reading_.files);
    if (document && problem.empty()) {
        const Element root{document->tree.document_element(), document.get()};
        if (root.name() != "mujoco") problem = "'" + path + "' is no MJCF";
        Mjcf inner(root, reading);
        inner.including_ = including_;
        if (problem.empty()) inner.read();
    }
    if (!problem.empty()) reading.error(where, "model '" + asset.file + "': " + problem);
    for (const ReportLine& line : its.report) model_.report.push_back(line);
    return its.has_errors() ? nullptr : model;
}

void Mjcf::attach(const Element& element, const Scope& scope)
{
    const auto asset = models_.find(element.text("model"));
    if (asset == models_.end())
        return reading_.error(element, "there is no asset <model> '" + element.text("model") + "'");
    const std::shared_ptr<const RobotModel> other = model_of_file(element, asset->second);
    if (!other) return;
    const std::string body = element.text("body");
    if (element.has("frame"))
        return reading_.error(element, "<attach> of a frame is not read: name its body");
    copied_ += int(other->links.size());
    for (const Link& link : other->links) copied_ += int(link.shapes.size() + link.visuals.size());
    if (copied_ > kMaxAttached) return reading_.error(element, "copies of more than 200000 elements");
    if (asset->second.mesh < 0) {
        asset->second.mesh = int(model_.meshes.size()), asset->second.field = int(model_.fields.size());
        model_.meshes.insert(model_.meshes.end(), other->meshes.begin(), other->meshes.end());
        model_.fields.insert(model_.fields.end(), other->fields.begin(), other->fields.end());
    }
    Moved moved{
        *other, element.text("prefix"), {}, {}, {}, size_t(asset->second.mesh), size_t(asset->second.field),
        {}};
    moved.links.assign(other->links.size(), -1), moved.joints.assign(other->joints.size(), -1);
    moved.tendons.assign(other->tendons.size(), -1);
    size_t root = 0;
    while (root < other->links.size() && other->links[root].name != body && !body.empty()) ++root;
    if (root == other->links.size())
        return reading_.error(element, "the attached model has no body '" + body + "'");
    if (body.empty()) {
        moved.links[0] = scope.link, moved.world = scope.pose;
        if (scope.link > 0 && !other->links[0].shapes.empty())
            reading_.note(Note::kApproximated, element,
                          "masses of geoms that stand in the attached world do not count");
        take_shapes(model_, moved, other->links[0], scope.link, scope.pose);
    }
    for (size_t i = 1; i < other->links.size(); ++i) {
        const int above = other->links[i].parent;
        const bool is_first = body.empty() ? above == 0 : i == root;
        if (!is_first && moved.links[size_t(above)] < 0) continue;
        if (model_.links.size() > kMaxLinks) return reading_.error(element, Reading::too_many_links());
        if (is_first)
            take_link(model_, moved, i, scope.link, scope.pose * other->links[i].pose);
        else
            take_link(model_, moved, i, moved.links[size_t(above)], other->links[i].pose);
        for (int joint : model_.links.back().joints)
            if (model_.joints[size_t(joint)].kind == JointKind::kFree && model_.links.back().parent != 0)
                return reading_.error(element, "the attached body '" + other->links[i].name +
                                                   "' has a free joint, and is not attached to the world");
    }
    take_frames(moved.links, moved.prefix, *other, body.empty() ? scope.pose : Pose{});
    attached_.push_back(std::make_shared<Attached>(Attached{other, std::move(moved), {}, 0}));
}

void Mjcf::take_frames(const std::vector<int>& links, const std::string& prefix, const RobotModel& other,
                       const Pose& of_world)
{
    const auto take = [&](Frame frame) -> Frame {
        if (frame.link == 0) frame.pose = of_world * frame.pose;
        frame.link = links[size_t(frame.link)];
        if (!frame.name.empty()) frame.name = prefix + frame.name;
        return frame;
    };
    for (const Frame& frame : other.frames)
        if (links[size_t(frame.link)] >= 0) model_.frames.push_back(take(frame));
    for (const Camera& camera : other.cameras)
        if (links[size_t(camera.frame.link)] >= 0)
            model_.cameras.push_back({take(camera.frame), camera.field});
}

void Mjcf::finish_attached()
{
    for (const std::shared_ptr<Attached>& one : attached_) {
        take_tendons(model_, one->moved);
        take_equalities(model_, one->moved);
        const size_t first = model_.actuators.size();
        one->actuators = take_actuators(model_, one->moved), one->first = first;
        take_sensors(model_, one->moved);
    }
    for (const std::shared_ptr<Attached>& one : attached_)
        take_starts(model_, one->moved, one->actuators, one->first);
    std::set<std::string> links, joints;
    for (const Link& link : model_.links)
        if (!attached_.empty() && !link.name.empty() && !links.insert(link.name).second)
            reading_.error(root_, "two bodies are called '" + link.name + "': attach with a prefix");
    for (const Joint& joint : model_.joints)
        if (!attached_.empty() && !joint.name.empty() && !joints.insert(joint.name).second)
            reading_.error(root_, "two joints are called '" + joint.name + "': attach with a prefix");
}

}  // namespace epode::robots
