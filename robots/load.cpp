// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See load.h. After a reader: fixed links are merged, then masses are judged.
#include "robots/load.h"

#include <cmath>
#include <cstring>

#include "robots/inertia.h"
#include "robots/numbers.h"
#include "robots/read/reading.h"
#include "robots/weld.h"

namespace epode::robots {

namespace {

constexpr double kWater = 1000;  // kg/m^3

void add(RobotModel& model, Note note, int line, const std::string& text)
{
    model.report.push_back({note, model.path, line, text});
}

// Of a link and of those that merge with it.
double mass_with_fixed(const RobotModel& model, size_t number)
{
    std::vector<bool> is_part(model.links.size());
    double sum = 0;
    is_part[number] = true;
    for (size_t i = number; i < model.links.size(); ++i) {
        const Link& link = model.links[i];
        if (link.parent >= 0 && is_part[size_t(link.parent)] && link.joints.empty()) is_part[i] = true;
        if (is_part[i]) sum += link.mass;
    }
    return sum;
}

void remove_joint(RobotModel& model, int gone)
{
    model.joints.erase(model.joints.begin() + gone);
    for (Link& link : model.links) {
        std::erase(link.joints, gone);
        for (int& joint : link.joints) joint -= joint > gone;
    }
    for (Coupling& coupling : model.couplings)
        for (Coupling::Term& term : coupling.terms) term.joint -= term.joint > gone;
    for (Actuator& actuator : model.actuators) actuator.joint -= actuator.joint > gone;
    number_coordinates(model);
}

// A URDF whose root weighs nothing stands in the world: arms whose base has no inertial.
void fix_weightless_base(RobotModel& model)
{
    if (model.links.size() < 2) return;
    const Link& base = model.links[1];
    const bool is_free = base.joints.size() == 1 && base.parent == 0 &&
                         model.joints[size_t(base.joints[0])].kind == JointKind::kFree;
    if (!is_free || mass_with_fixed(model, 1) > 0) return;
    add(model, Note::kChanged, base.line,
        "the root link '" + base.name + "' has no mass: it is fixed to the world");
    remove_joint(model, base.joints[0]);
}

// What no world takes, and what sums of such numbers end in.
void judge_size(RobotModel& model, const Link& link)
{
    bool is_usable = std::fabs(link.mass) <= kMaxNumber && length(link.centre) <= kMaxNumber;
    for (const auto& row : link.inertia)
        for (double value : row) is_usable = is_usable && std::fabs(value) <= kMaxNumber;
    if (!is_usable)
        add(model, Note::kError, link.line,
            "the mass, centre or inertia of link '" + link.name + "' is beyond " + max_number_text());
}

bool give_mass(RobotModel& model, Link& link, const LoadOptions& options)
{
    Inertia sum;
    if (options.inertia_from_shapes)
        for (const Shape& shape : link.shapes) {
            const Inertia one = inertia_of(shape, model.meshes);
            sum = sum_of(sum, with_mass(one, one.mass * kWater));
        }
    if (!(sum.mass > 0) && options.missing_mass > 0) {
        Shape ball;
        ball.size = {0.05, 0, 0};
        sum = with_mass(inertia_of(ball, model.meshes), options.missing_mass);
    }
    link.mass = sum.mass, link.centre = sum.centre, link.inertia = sum.tensor;
    judge_size(model, link);
    return sum.mass > 0;
}

// Whether something with a mass moves with each link, itself not counted.
std::vector<bool> carries_mass(const RobotModel& model)
{
    std::vector<bool> out(model.links.size());
    for (size_t i = model.links.size(); i-- > 1;) {
        const Link& link = model.links[i];
        if (link.mass > 0 || out[i]) out[size_t(link.parent)] = true;
    }
    return out;
}

// Of a moving link without one.
void judge_missing_mass(RobotModel& model, Link& link, bool carries, const LoadOptions& options)
{
    const std::string its = "the moving link '" + link.name + "' has no ";
    if (give_mass(model, link, options))  // asked for, so not even strict minds
        add(model, Note::kApproximated, link.line,
            its + "inertial: it was given " + text_of(link.mass) + " kg");
    else if (carries)
        add(model, options.strict ? Note::kError : Note::kApproximated, link.line,
            its + "mass: a small body carries what hangs on it");
    else
        add(model, Note::kError, link.line,
            its +
                "mass; give it an <inertial>, or load with the inertia from its shapes or with a mass for "
                "such links");
}

void judge_inertia(RobotModel& model, Link& link, const LoadOptions& options)
{
    const std::string fault = fault_of(link.inertia),
                      its = "the inertia of link '" + link.name + "' " + fault;
    if (fault.empty()) return;
    if (!options.repair)
        return add(model, Note::kError, link.line, its + "; correct it, or load with repair");
    link.inertia = mended(link.inertia, link.mass);
    add(model, Note::kApproximated, link.line, its + ": mended");
}

void judge_masses(RobotModel& model, const LoadOptions& options)
{
    for (size_t i = 1; i < model.links.size(); ++i) judge_size(model, model.links[i]);
    if (model.has_errors()) return;
    const std::vector<bool> carries = carries_mass(model);
    for (size_t i = 1; i < model.links.size(); ++i) {
        Link& link = model.links[i];
        if (link.joints.empty()) continue;
        if (link.mass > 0)
            judge_inertia(model, link, options);
        else
            judge_missing_mass(model, link, carries[i], options);
    }
}

// A link of which nothing is pulled is simply weightless.
void simplify_lifts(RobotModel& model)
{
    for (Link& link : model.links) {
        double sum = 0;
        for (const Lift& lift : link.lifts) sum += lift.share == 1 ? lift.mass : 0;
        if (link.lifts.empty() || !(std::fabs(sum - link.mass) <= 1e-12 * link.mass)) continue;
        link.is_weightless = true, link.lifts.clear();
    }
    for (const Link& link : model.links)
        if (!link.lifts.empty())
            return add(model, Note::kChanged, link.line,
                       "shares of gravity (gravcomp) act where dRobotAddForces is called before a step");
}

void finish(RobotModel& model, const LoadOptions& options)
{
    judge_numbers(model);
    if (model.has_errors()) return;
    if (model.format == "URDF") fix_weightless_base(model);
    if (!options.keep_fixed) merge_fixed_links(model);
    simplify_lifts(model);
    judge_masses(model, options);
}

}  // namespace

// Whether an element of xacro's own is there, however deep.
static bool has_macros(const pugi::xml_node& root)
{
    return bool(root.find_node(
        [](const pugi::xml_node& node) { return std::strncmp(node.name(), "xacro:", 6) == 0; }));
}

RobotModel load_robot_text(const std::string& path, const std::string& text, const LoadOptions& options)
{
    RobotModel model;
    model.path = path;
    model.decomposes_meshes = options.meshes_as_parts, model.parts = options.parts;
    Files files(path, options.roots);
    Reading reading(model, options, files);
    std::string problem;
    const auto document = parse_xml(path, text, problem);
    if (!document) {
        add(model, Note::kError, 0, problem);
        return model;
    }
    const Element root{document->tree.document_element(), document.get()};
    const std::map<std::string, std::string> formats{{"robot", "URDF"}, {"mujoco", "MJCF"}, {"sdf", "SDF"}};
    if (root.name() == "robot" && has_macros(root.node))
        reading.error(
            root,
            "this is xacro, macros for URDF: write what the program xacro makes of it to a file, `xacro "
            "FILE > robot.urdf` (pip install xacro, or Debian's package xacro); Python's epode.load calls "
            "it");
    if (model.has_errors()) return model;
    if (const auto found = formats.find(root.name()); found != formats.end()) model.format = found->second;
    if (model.format == "URDF")
        read_urdf(root, reading);
    else if (model.format == "MJCF")
        read_mjcf(root, reading);
    else if (model.format == "SDF")
        read_sdf(root, text, reading);
    else
        reading.error(root, "the root element is <" + root.name().substr(0, 40) +
                                ">; <robot> (URDF), <mujoco> (MJCF) and <sdf> are read");
    finish(model, options);
    return model;
}

RobotModel load_robot(const std::string& path, const LoadOptions& options)
{
    Files files(path, options.roots);
    std::string problem;
    const auto text = files.read(path, problem);
    if (text) return load_robot_text(path, *text, options);
    RobotModel model;
    model.path = path;
    add(model, Note::kError, 0, problem);
    return model;
}

}  // namespace epode::robots
