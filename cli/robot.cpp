// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See robot.h: the command line of `epode robot`, check and convert.
#include "cli/robot.h"

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/plan.h"
#include "cli/view.h"

#ifdef EPODE_HAVE_ROBOTS
#include "robots/build.h"
#include "robots/load.h"
#include "robots/write/write.h"
#endif

namespace epode::cli {

void add_robot_options(CLI::App& command, RobotOptions& options, view::ViewOptions& viewing)
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
    check
        ->add_option(
            "--decompose", options.tolerance,
            "meshes as several hulls each, none reaching farther out of its mesh than so many m (0: 2.5 % of "
            "its longest side)")
        ->check(CLI::NonNegativeNumber)
        ->each([&options](const std::string&) { options.decomposes = true; });
    CLI::App* view = command.add_subcommand("view", "a window with a slider for every axis, without gravity");
    add_view_options(*view, viewing);
    view->callback([&options] { options.is_viewed = true; });
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

// Hulls of every mesh that touches, after decomposition.
void print_parts(const RobotModel& model)
{
    const robots::Prepared prepared(model);
    say("\n{:<40} {:>9} {:>6} {:>11} {:>11}\n", "mesh", "triangles", "hulls", "surplus, m", "allowed, m");
    for (const robots::Prepared::Fit& fit : prepared.fits()) {
        const robots::Mesh& mesh = model.meshes[size_t(fit.mesh)];
        say("{:<40} {:>9} {:>6} {:>11.3g} {:>11.3g}{}\n", mesh.path.substr(mesh.path.rfind('/') + 1),
            mesh.triangles.size(), fit.parts, fit.surplus, fit.tolerance, fit.is_closed ? "" : " not closed");
    }
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
    load.meshes_as_parts = options.decomposes, load.parts.tolerance = options.tolerance;
    const RobotModel model = robots::load_robot(options.file, load);
    const std::vector<std::string> not_built = robots::Robot::not_built(model);
    if (options.json) {
        print_json(model, not_built);
    } else {
        if (!model.has_errors()) print_table(model);
        if (!model.has_errors() && options.decomposes) print_parts(model);
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

#else

int run_robot(const RobotOptions&)
{
    return refuse("this build has no robots: it wants pugixml (Debian: libpugixml-dev), then cmake again");
}

#endif

}  // namespace epode::cli
