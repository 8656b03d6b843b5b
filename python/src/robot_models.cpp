// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Models of robots, under epode.robot.Model: a file as data, with its kinematics and dynamics.
#include "robots.h"

#ifdef EPODE_HAVE_ROBOTS

#include <nanobind/stl/vector.h>

#include "robots/constraints.h"
#include "robots/fluid.h"
#include "robots/inverse.h"
#include "robots/kinematics.h"
#include "robots/load.h"
#include "robots/sensor_kinds.h"
#include "robots/tendon.h"
#include "robots/write/write.h"

using namespace bound;

namespace {

Reals read_positions(const Model& m, nb::handle from)
{
    return read(from, size_t(m.model.coordinates), "positions");
}

int link_in(const Model& m, int link)
{
    if (link < 0 || link >= int(m.model.links.size())) throw nb::index_error("no such link");
    return link;
}

Model* load(const std::string& path, nb::object text, nb::dict options)
{
    LoadOptions its;
    const auto flag = [&](const char* name, bool& value) {
        if (options.contains(name)) value = nb::cast<bool>(options[name]);
    };
    flag("strict", its.strict), flag("keep_fixed", its.keep_fixed), flag("fixed_base", its.fixed_base);
    flag("repair", its.repair), flag("inertia_from_shapes", its.inertia_from_shapes);
    flag("meshes_as_triangles", its.meshes_as_triangles), flag("meshes_as_parts", its.meshes_as_parts);
    its.missing_mass = nb::cast<double>(options["missing_mass"]);
    its.roots = nb::cast<std::vector<std::string>>(options["roots"]);
    if (!(its.missing_mass >= 0) || !std::isfinite(its.missing_mass))
        throw nb::value_error("missing_mass must be 0 kg or more");
    return new Model{
        text.is_none() ? load_robot(path, its) : load_robot_text(path, nb::cast<std::string>(text), its),
        nullptr};
}

nb::list sentences(const std::vector<std::string>& all)
{
    nb::list out;
    for (const std::string& one : all) out.append(one);
    return out;
}

// What the format cannot say.
nb::list save(const Model& m, const std::string& path)
{
    std::vector<std::string> lost;
    std::string problem;
    Call call;
    if (!save_robot(m.model, path, lost, problem)) Call::say({true, d_ERR_UASSERT, problem});
    call.done();
    return sentences(lost);
}

// (text, what the format cannot say)
nb::object text_of(const Model& m, bool as_urdf, const std::string& folder)
{
    const WrittenRobot written = as_urdf ? write_urdf(m.model, folder) : write_mjcf(m.model, folder);
    return nb::make_tuple(written.text, sentences(written.lost));
}

nb::list report(const Model& m)
{
    nb::list out;
    for (const ReportLine& line : m.model.report)
        out.append(nb::make_tuple(name_of(line.note), line.file, line.line, line.text));
    return out;
}

nb::list links(const Model& m)
{
    nb::list out;
    for (const Link& link : m.model.links) {
        Reals inertia;
        for (const auto& its : link.inertia) inertia.insert(inertia.end(), its.begin(), its.end());
        out.append(nb::make_tuple(link.name, link.parent, link.mass, row(link.centre), table(inertia, 3, 3),
                                  link.joints, link.shapes.size()));
    }
    return out;
}

nb::list joints(const Model& m)
{
    nb::list out;
    int velocity = 0;
    for (const Joint& joint : m.model.joints) {
        out.append(nb::make_tuple(joint.name, name_of(joint.kind), joint.link, joint.position, velocity,
                                  row(joint.anchor), row(joint.axis), joint.low, joint.high, joint.max_force,
                                  joint.max_velocity));
        velocity += velocities_of(joint);
    }
    return out;
}

nb::list actuators(const Model& m)
{
    nb::list out;
    for (const Actuator& a : m.model.actuators)
        out.append(nb::make_tuple(a.name, a.kind, a.joint, a.low, a.high));
    return out;
}

nb::dict starts(const Model& m)
{
    nb::dict out;
    for (const Start& start : m.model.starts) out[start.name.c_str()] = row(start.positions);
    return out;
}

// Of each start pose those of the bodies that the program moves.
nb::dict start_mocap(const Model& m)
{
    nb::dict out;
    for (const Start& start : m.model.starts) {
        Reals all;
        for (const Pose& p : start.mocap)
            all.insert(all.end(), {p.p.x, p.p.y, p.p.z, p.q.w, p.q.x, p.q.y, p.q.z});
        out[start.name.c_str()] = table(all, all.size() / 7, 7);
    }
    return out;
}

// (link, pose in it), or None.
nb::object frame(const Model& m, const std::string& name)
{
    Frame its;
    if (!m.model.frame_named(name, its)) return nb::none();
    return nb::make_tuple(its.link, row(its.pose));
}

// (name, link, pose in it, field of view)
nb::list cameras(const Model& m)
{
    nb::list out;
    for (const Camera& its : m.model.cameras)
        out.append(nb::make_tuple(its.frame.name, its.frame.link, row(its.frame.pose), its.field));
    return out;
}

nb::list frame_names(const Model& m)
{
    nb::list out;
    for (const Link& link : m.model.links) out.append(link.name);
    for (const Frame& its : m.model.frames) out.append(its.name);
    return out;
}

nb::object poses(const Model& m, nb::object positions)
{
    Reals out;
    for (const Pose& p : forward_kinematics(m.model, read_positions(m, positions)))
        out.insert(out.end(), {p.p.x, p.p.y, p.p.z, p.q.w, p.q.x, p.q.y, p.q.z});
    return table(out, out.size() / 7, 7);
}

nb::object get_jacobian(const Model& m, nb::object positions, int link, nb::object point)
{
    const Reals p = read(point, 3, "point");
    return table(jacobian(m.model, read_positions(m, positions), link_in(m, link), {p[0], p[1], p[2]}), 6,
                 speeds(m.model));
}

nb::object get_mass_matrix(const Model& m, nb::object positions)
{
    return table(mass_matrix(m.model, read_positions(m, positions)), speeds(m.model), speeds(m.model));
}

nb::object get_inverse_dynamics(const Model& m, nb::object positions, nb::object velocities,
                                nb::object accelerations)
{
    const size_t n = speeds(m.model);
    return row(inverse_dynamics(m.model, read_positions(m, positions), read(velocities, n, "velocities"),
                                read(accelerations, n, "accelerations"), m.model.gravity));
}

nb::object get_fluid_forces(const Model& m, nb::object positions, nb::object velocities)
{
    return row(
        fluid_forces(m.model, read_positions(m, positions), read(velocities, speeds(m.model), "velocities")));
}

nb::list tendon_names(const Model& m)
{
    nb::list out;
    for (const Tendon& tendon : m.model.tendons) out.append(tendon.name);
    return out;
}

// (lengths, their derivatives by the velocities)
nb::object get_tendons(const Model& m, nb::object positions)
{
    const Reals at = read_positions(m, positions);
    return nb::make_tuple(row(tendon_lengths(m.model, at)),
                          table(tendon_jacobian(m.model, at), m.model.tendons.size(), speeds(m.model)));
}

// (how far couplings and loops are from what they ask, its derivative by the velocities)
nb::object get_constraints(const Model& m, nb::object positions)
{
    const Reals at = read_positions(m, positions);
    const Reals errors = constraint_errors(m.model, at);
    return nb::make_tuple(row(errors),
                          table(constraint_jacobian(m.model, at), errors.size(), speeds(m.model)));
}

// goals: (link, frame in it, pose, position weight, orientation weight) each.
nb::object get_inverse(const Model& m, nb::object guess, nb::list goals, nb::object weights,
                       nb::object posture, int max_iterations, int max_starts, double tolerance)
{
    std::vector<Goal> wanted;
    for (nb::handle its : goals) {
        const Goal goal{link_in(m, nb::cast<int>(its[0])), read_pose(its[1]), read_pose(its[2]),
                        nb::cast<double>(its[3]), nb::cast<double>(its[4])};
        if (!(goal.position_weight >= 0) || !(goal.orientation_weight >= 0))
            throw nb::value_error("weights of targets must be 0 or more");
        wanted.push_back(goal);
    }
    InverseSettings settings{max_iterations, max_starts, tolerance,
                             read_or_nothing(weights, speeds(m.model), "weights"),
                             read_or_nothing(posture, size_t(m.model.coordinates), "posture")};
    for (double weight : settings.weights)
        if (weight < 0 || weight > 1e6) throw nb::value_error("weights must be from 0 to 1e6");
    if (max_iterations < 1 || max_iterations > 1000 || max_starts < 1 || max_starts > 1000 ||
        !(tolerance >= 0))
        throw nb::value_error("1 to 1000 iterations and starts, and a tolerance of 0 or more are expected");
    const InverseAnswer a = solve_inverse(m.model, read_positions(m, guess), wanted, settings);
    return nb::make_tuple(row(a.positions), a.is_reached, a.position_error, a.orientation_error, a.residual,
                          a.iterations, a.starts);
}

nb::list sensors(const Model& m)
{
    nb::list out;
    for (const Sensor& its : m.model.sensors)
        out.append(nb::make_tuple(its.name, its.kind, its.object, values_of(its.kind)));
    return out;
}

}  // namespace

void bind_robot_models(nb::module_& m)
{
    nb::class_<Model>(m, "_RobotModel")
        .def(nb::new_([](const std::string& path, nb::object text, nb::dict options) {
                 return load(path, text, options);
             }),
             "path"_a, "text"_a.none(), "options"_a)
        .def_prop_ro("name", [](const Model& s) { return s.model.name; })
        .def_prop_ro("format", [](const Model& s) { return s.model.format; })
        .def_prop_ro("stepsize", [](const Model& s) { return s.model.stepsize; })
        .def_prop_ro("gravity", [](const Model& s) { return row(s.model.gravity); })
        .def_prop_ro("position_count", [](const Model& s) { return s.model.coordinates; })
        .def_prop_ro("velocity_count", [](const Model& s) { return speeds(s.model); })
        .def_prop_ro("reference", [](const Model& s) { return row(reference_positions(s.model)); })
        .def_prop_ro("not_built", [](const Model& s) { return Robot::not_built(s.model); })
        .def_prop_ro("report", report)
        .def_prop_ro("links", links)
        .def_prop_ro("joints", joints)
        .def_prop_ro("actuators", actuators)
        .def_prop_ro("starts", starts)
        .def_prop_ro("start_mocap", start_mocap)
        .def_prop_ro("mocap", [](const Model& s) { return s.model.mocap_links(); })
        .def_prop_ro("sensors", sensors)
        .def_prop_ro("frame_names", frame_names)
        .def_prop_ro("cameras", cameras)
        .def("frame", frame)
        .def("poses", poses)
        .def("jacobian", get_jacobian)
        .def("mass_matrix", get_mass_matrix)
        .def("constraints", get_constraints)
        .def_prop_ro("tendon_names", tendon_names)
        .def("tendons", get_tendons)
        .def("inverse_dynamics", get_inverse_dynamics)
        .def("inverse", get_inverse, "guess"_a, "goals"_a, "weights"_a.none(), "posture"_a.none(),
             "max_iterations"_a, "max_starts"_a, "tolerance"_a)
        .def("fluid_forces", get_fluid_forces)
        .def("save", save)
        .def("text", text_of)
        .def("build", build);
}

#endif
