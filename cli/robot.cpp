// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See robot.h. A robot that is not fixed begins with its lowest point 1 cm above a floor, unless its file has one.
#include "cli/robot.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>

#include "cli/console.h"
#include "cli/plan.h"
#include "scenes/build.h"
#include "scenes/extensions.h"

#ifdef EPODE_HAVE_ROBOTS
#include "robots/build.h"
#include "robots/load.h"
#include "robots/write/write.h"
#endif

namespace epode::cli {

void add_robot_options(CLI::App& command, RobotOptions& options)
{
    command.require_subcommand(1);
    CLI::App* check =
        command.add_subcommand("check", "links, joints, and every element that is not read as it is");
    CLI::App* convert = command.add_subcommand("convert", "writes URDF (.urdf) or MJCF (.xml)");
    for (CLI::App* its : {check, convert}) {
        its->add_option("file", options.file, "URDF, MJCF or SDF")->required();
        its->add_option("--root", options.roots,
                        "one more folder that may be read; packages are looked for there")
            ->allow_extra_args(false);
    }
    convert->add_option("to", options.to, "file to write")->required();
    check->add_flag("--strict", options.strict, "what is approximated or ignored is an error");
    check->add_flag("--json", options.json, "as one JSON object");
}

#ifdef EPODE_HAVE_ROBOTS

namespace {

using robots::RobotModel;

std::string quoted(const std::string& text)
{
    std::string out = "\"";
    for (char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
    return out + '"';
}

std::string range_of(const robots::Joint& joint)
{
    return joint.limited ? fmt::format("{:g} ... {:g}", joint.low, joint.high) : "-";
}

void print_table(const RobotModel& model)
{
    say("{} '{}': {} links, {} joints, {} coordinates\n", model.format, model.name, model.links.size() - 1,
        model.joints.size(), model.coordinates);
    say("\n{:<28} {:<24} {:>10} {:>7} {:>6}\n", "link", "on", "mass, kg", "shapes", "looks");
    for (size_t i = 0; i < model.links.size(); ++i) {
        const robots::Link& link = model.links[i];
        say("{:<28} {:<24} {:>10.4g} {:>7} {:>6}\n", link.name,
            link.parent < 0 ? "" : model.links[size_t(link.parent)].name, link.mass, link.shapes.size(),
            link.visuals.size());
    }
    say("\n{:<28} {:<6} {:<22} {:>8} {:>8} {:>9}\n", "joint", "kind", "limits", "damping", "friction",
        "armature");
    for (const robots::Joint& joint : model.joints)
        say("{:<28} {:<6} {:<22} {:>8g} {:>8g} {:>9g}\n", joint.name, robots::name_of(joint.kind),
            range_of(joint), joint.damping, joint.friction, joint.armature);
    say("\n{} couplings, {} closures, {} tendons, {} actuators, {} sensors, {} start poses, {} pairs that do "
        "not touch\n",
        model.couplings.size(), model.closures.size(), model.tendons.size(), model.actuators.size(),
        model.sensors.size(), model.starts.size(), model.excluded.size());
}

void print_json(const RobotModel& model, const std::vector<std::string>& not_built)
{
    std::string lines, missing;
    for (const robots::ReportLine& line : model.report)
        lines += fmt::format("{}\n    {{\"note\": \"{}\", \"file\": {}, \"line\": {}, \"text\": {}}}",
                             lines.empty() ? "" : ",", robots::name_of(line.note), quoted(line.file),
                             line.line, quoted(line.text));
    for (const std::string& text : not_built) missing += (missing.empty() ? "" : ", ") + quoted(text);
    say("{{\n  \"format\": {},\n  \"name\": {},\n  \"links\": {},\n  \"joints\": {},\n  \"coordinates\": "
        "{},\n"
        "  \"actuators\": {},\n  \"couplings\": {},\n  \"not_built\": [{}],\n  \"report\": [{}\n  ]\n}}\n",
        quoted(model.format), quoted(model.name), model.links.size(), model.joints.size(), model.coordinates,
        model.actuators.size(), model.couplings.size(), missing, lines);
}

std::shared_ptr<const robots::Prepared> offered;

// Of all geoms that a body has, or of all where none has.
struct Extent {
    double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL}, high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
};

Extent extent_of(const std::vector<dGeomID>& geoms)
{
    Extent out;
    for (dGeomID geom : geoms) {
        dReal box[6];
        dGeomGetAABB(geom, box);
        for (int i = 0; i < 3 && dGeomGetBody(geom); ++i) {
            out.low[i] = std::min(out.low[i], double(box[2 * i]));
            out.high[i] = std::max(out.high[i], double(box[2 * i + 1]));
        }
    }
    return out;
}

// From the front, on the right and a little above, as far as the robot is large.
void set_view(scenes::Scene& scene, const Extent& extent)
{
    scenes::Vec middle;
    double size = 0;
    double* its[3] = {&middle.x, &middle.y, &middle.z};
    for (int i = 0; i < 3; ++i) {
        *its[i] = (extent.low[i] + extent.high[i]) / 2;
        size = std::max(size, extent.high[i] - extent.low[i]);
    }
    if (!(size > 0) || !std::isfinite(size)) return;
    const scenes::Vec eye = {middle.x + 1.6 * size, middle.y - 1.2 * size, middle.z + 0.7 * size};
    scenes::set_view(scene, eye, middle);
}

// Coordinates in the joints' limits.
std::vector<double> start_of(const RobotModel& model)
{
    if (!model.starts.empty()) return model.starts[0].positions;
    std::vector<double> q = robots::reference_positions(model);
    for (const robots::Joint& joint : model.joints)
        if (joint.is_scalar() && joint.limited)
            q[size_t(joint.position)] = std::clamp(q[size_t(joint.position)], joint.low, joint.high);
    return q;
}

void add_floor(scenes::Scene& scene, const robots::Robot& robot, const Extent& extent)
{
    const auto& geoms = robot.geoms();
    if (std::any_of(geoms.begin(), geoms.end(),
                    [](dGeomID geom) { return dGeomGetClass(geom) == dPlaneClass; }))
        return;
    const auto& joints = robot.model().joints;
    const bool moves = std::any_of(joints.begin(), joints.end(),
                                   [](const auto& joint) { return joint.kind == robots::JointKind::kFree; });
    const double height = extent.low[2] - 0.01;
    if (!std::isfinite(height)) return;
    moves ? scenes::add_ground(scene, height) : scenes::add_floor(scene, height);
}

void build_offered(scenes::Scene& scene)
{
    const RobotModel& model = offered->model();
    dWorldSetGravity(scene.world(), dReal(model.gravity.x), dReal(model.gravity.y), dReal(model.gravity.z));
    const std::vector<double> start =
        model.starts.empty() ? std::vector<double>() : model.starts[0].positions;
    auto robot = std::make_shared<robots::Robot>(offered, scene.world(), scene.space(), robots::Pose{},
                                                 start_of(model));
    robot->add_looks(scene.space());
    for (dBodyID body : robot->all_bodies()) scene.add_body(body);
    for (dGeomID geom : robot->geoms()) scene.add_geom(geom);
    for (dJointID joint : robot->all_joints())
        if (dJointGetType(joint) != dJointTypeAMotor) scene.add_joint(joint);
    const Extent extent = extent_of(robot->geoms());
    add_floor(scene, *robot, extent);
    set_view(scene, extent);
    if (!model.starts.empty())
        for (size_t i = 0; i < std::min(model.starts[0].controls.size(), model.actuators.size()); ++i)
            robot->set_control(int(i), model.starts[0].controls[i]);
    robot->release();  // the scene destroys its world with all in it
}

// Links stay as the file has them: nothing is merged.
int convert_robot(const RobotOptions& options)
{
    robots::LoadOptions load;
    load.roots = options.roots, load.keep_fixed = true;
    const RobotModel model = robots::load_robot(options.file, load);
    for (const robots::ReportLine& line : model.report)
        if (line.note != robots::Note::kChanged)
            warn("{}:{}: {}: {}", line.file, line.line, robots::name_of(line.note), line.text);
    std::vector<std::string> lost;
    std::string problem;
    if (!robots::save_robot(model, options.to, lost, problem)) return complain(options.file, problem);
    for (const std::string& text : lost) say("{}: {}\n", options.to, text);
    return kFine;
}

int check_robot(const RobotOptions& options)
{
    robots::LoadOptions load;
    load.roots = options.roots, load.strict = options.strict;
    const RobotModel model = robots::load_robot(options.file, load);
    const std::vector<std::string> not_built = robots::Robot::not_built(model);
    if (options.json) {
        print_json(model, not_built);
    } else {
        if (!model.has_errors()) print_table(model);
        if (!model.report.empty()) say("\n");
        for (const robots::ReportLine& line : model.report)
            say("{}:{}: {}: {}\n", line.file, line.line, robots::name_of(line.note), line.text);
        for (const std::string& text : not_built) say("{}: {}\n", options.file, text);
    }
    return model.has_errors() ? kProblem : kFine;
}

}  // namespace

int run_robot(const RobotOptions& options)
{
    return options.to.empty() ? check_robot(options) : convert_robot(options);
}

bool offer_robot(const std::string& what, std::string& problem)
{
    const bool is_robot = what.ends_with(".urdf") || what.ends_with(".xml") || what.ends_with(".mjcf") ||
                          what.ends_with(".sdf");
    if (!is_robot) return true;
    if (!scenes::has_managed_contacts()) {
        problem = scenes::loaded_library() + " has no drives, hulls and couplings, of which robots are made";
        return false;
    }
    RobotModel model = robots::load_robot(what);
    for (const robots::ReportLine& line : model.report)
        if (line.note == robots::Note::kError)
            problem =
                fmt::format("line {}: {} (`epode robot check` has the whole report)", line.line, line.text);
    if (!problem.empty()) return false;
    for (const std::string& text : robots::Robot::not_built(model)) warn("{}: {}", what, text);
    static const std::string name = what;
    static const scenes::Recipe recipe = {
        name.c_str(), "a robot from a file", 0.002, 5, scenes::Stepper::kExact, &build_offered};
    const scenes::Runtime runtime;
    offered = std::make_shared<const robots::Prepared>(std::move(model));
    scenes::add_recipe(recipe);
    return true;
}

#else

int run_robot(const RobotOptions&)
{
    return refuse("this build has no robots: it wants pugixml (Debian: libpugixml-dev), then cmake again");
}

bool offer_robot(const std::string&, std::string&) { return true; }

#endif

}  // namespace epode::cli
