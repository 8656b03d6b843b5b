// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Models of robots and robots in worlds, under the classes of epode.robot. A model is read once and shared by its robots,
// which keep the arrays that their geoms point to. A robot whose world is gone is released: it then owns nothing.
#include "calls.h"

#ifdef EPODE_HAVE_ROBOTS

#include <nanobind/stl/vector.h>

#include <algorithm>
#include <cmath>

#include "robots/build.h"
#include "robots/constraints.h"
#include "robots/fluid.h"
#include "robots/inverse.h"
#include "robots/kinematics.h"
#include "robots/load.h"
#include "robots/sensor_kinds.h"
#include "robots/sensors.h"
#include "robots/tendon.h"
#include "robots/write/write.h"

using namespace epode::robots;

namespace {

using Reals = std::vector<double>;

struct Model {
    RobotModel model;
    std::shared_ptr<const Prepared> prepared;  // made for the first robot
};

// A robot in a world and its sensors.
struct Built {
    std::unique_ptr<Robot> robot;
    std::unique_ptr<Sensors> sensors;
    const RobotModel& model() const { return robot->model(); }
    void release() { sensors->release(), robot->release(); }
};

nb::object row(const Reals& values) { return array_of(values.data(), int(values.size())); }
nb::object row(Vec v) { return row(Reals{v.x, v.y, v.z}); }
nb::object row(const Pose& p) { return row(Reals{p.p.x, p.p.y, p.p.z, p.q.w, p.q.x, p.q.y, p.q.z}); }

nb::object table(const Reals& values, size_t rows, size_t columns)
{
    dReal* data;
    nb::object out = real_array(rows, columns, &data);
    std::copy(values.begin(), values.end(), data);
    return out;
}

// Finite numbers, as many as wanted.
Reals read(nb::handle from, size_t count, const char* what)
{
    const auto array = array_in<double>(from);
    Reals out(array.data, array.data + array.size);
    for (double value : out)
        if (!std::isfinite(value)) throw nb::value_error((std::string(what) + " must be finite").c_str());
    if (out.size() == count) return out;
    const std::string text = std::string(what) + ": " + std::to_string(count) + " numbers expected, not " +
                             std::to_string(out.size());
    throw nb::value_error(text.c_str());
}

Reals read_or_nothing(nb::handle from, size_t count, const char* what)
{
    return from.is_none() ? Reals() : read(from, count, what);
}

Pose read_pose(nb::handle from)
{
    const Reals v = read(from, 7, "pose");
    return {{v[0], v[1], v[2]}, normalised({v[3], v[4], v[5], v[6]})};
}

size_t speeds(const RobotModel& model) { return size_t(number_of_velocities(model)); }

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

// (link, pose in it), or None.
nb::object frame(const Model& m, const std::string& name)
{
    Frame its;
    if (!m.model.frame_named(name, its)) return nb::none();
    return nb::make_tuple(its.link, row(its.pose));
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

void must_be_built(const Model& m)
{
    if (m.model.has_errors()) throw nb::value_error("the model has errors: see its report");
}

Built* build(Model& m, const WorldHandle& world, const SpaceHandle& space, nb::object pose)
{
    must_be_built(m);
    const Pose placement = read_pose(pose);
    Call call;
    call.uses(world.p);
    if (!m.prepared) m.prepared = std::make_shared<const Prepared>(m.model);
    auto built = std::make_unique<Built>();
    built->robot = std::make_unique<Robot>(m.prepared, world.p, space_of(&space), placement, Reals());
    built->sensors = std::make_unique<Sensors>(*built->robot, world.p);
    call.done();
    return built.release();
}

template <typename P>
nb::list handles(const std::vector<P>& all)
{
    nb::list out;
    for (P one : all) out.append(wrapped(one));
    return out;
}

void set_positions(Built& robot, nb::object from)
{
    Call call;
    call.uses(robot.robot->body(int(robot.model().links.size()) - 1));
    robot.robot->set_positions(read(from, size_t(robot.model().coordinates), "positions"));
    robot.sensors->begin();
    call.done();
}

void set_velocities(Built& robot, nb::object from)
{
    Call call;
    call.uses(robot.robot->body(int(robot.model().links.size()) - 1));
    robot.robot->set_velocities(read(from, speeds(robot.model()), "velocities"));
    robot.sensors->begin();
    call.done();
}

void set_control(Built& robot, int actuator, double value)
{
    if (actuator < 0 || actuator >= int(robot.model().actuators.size()))
        throw nb::index_error("no such actuator");
    if (!std::isfinite(value)) throw nb::value_error("a control must be finite");
    Call call;
    robot.robot->set_control(actuator, value);
    call.done();
}

void set_target(Built& robot, int joint, double target, double stiffness, double damping)
{
    if (joint < 0 || joint >= int(robot.model().joints.size()) ||
        !robot.model().joints[size_t(joint)].is_scalar())
        throw nb::index_error("no hinge or slider has this number");
    if (!std::isfinite(target) || !std::isfinite(stiffness) || !std::isfinite(damping) || stiffness < 0 ||
        damping < 0)
        throw nb::value_error("a finite target, and stiffness and damping of 0 or more are expected");
    Call call;
    robot.robot->set_servo(joint, {stiffness, damping, target});
    call.done();
}

// Arrays with a row for each of many robots of one model. Rows are judged before the first is taken.
using Many = std::vector<Built*>;

const RobotModel& model_of(const Many& robots)
{
    for (const Built* robot : robots)
        if (&robot->model() != &robots[0]->model()) throw nb::value_error("robots of one model are expected");
    return robots[0]->model();
}

void use_all(Call& call, const Many& robots)
{
    if (!any_is_busy()) return;
    for (const Built* robot : robots) call.uses(robot->robot->body(int(robot->model().links.size()) - 1));
}

template <typename F>
nb::object rows_of(const Many& robots, size_t width, F get)
{
    dReal* data;
    nb::object out = real_array(robots.size(), std::max<size_t>(width, 1), &data);
    Call call;
    use_all(call, robots);
    for (const Built* robot : robots) {
        const Reals its = get(*robot->robot);
        data = std::copy(its.begin(), its.end(), data);
    }
    call.done();
    return out;
}

template <typename F>
void take_rows(const Many& robots, nb::object from, size_t width, const char* what, F put)
{
    const Reals all = read(from, robots.size() * width, what);
    Call call;
    use_all(call, robots);
    for (size_t i = 0; i < robots.size(); ++i) put(*robots[i], &all[i * width]);
    call.done();
}

nb::object many_positions(const Many& robots)
{
    return rows_of(robots, size_t(model_of(robots).coordinates),
                   [](const Robot& r) { return r.positions(); });
}

nb::object many_velocities(const Many& robots)
{
    return rows_of(robots, speeds(model_of(robots)), [](const Robot& r) { return r.velocities(); });
}

void set_many_positions(const Many& robots, nb::object from)
{
    const size_t width = size_t(model_of(robots).coordinates);
    take_rows(robots, from, width, "positions", [&](Built& robot, const double* row) {
        robot.robot->set_positions(Reals(row, row + width));
        robot.sensors->begin();
    });
}

void set_many_velocities(const Many& robots, nb::object from)
{
    const size_t width = speeds(model_of(robots));
    take_rows(robots, from, width, "velocities", [&](Built& robot, const double* row) {
        robot.robot->set_velocities(Reals(row, row + width));
        robot.sensors->begin();
    });
}

void set_many_controls(const Many& robots, nb::object from)
{
    const size_t width = model_of(robots).actuators.size();
    take_rows(robots, from, width, "controls", [&](Built& robot, const double* row) {
        for (size_t i = 0; i < width; ++i) robot.robot->set_control(int(i), row[i]);
    });
}

int link_of(const Built& robot, int link)
{
    if (link < 0 || link >= int(robot.model().links.size())) throw nb::index_error("no such link");
    return link;
}

int add_fluid_forces(Built& robot, double stepsize)
{
    if (!(stepsize >= 0) || !std::isfinite(stepsize)) throw nb::value_error("a step size must be 0 or more");
    Call call;
    call.uses(robot.robot->body(int(robot.model().links.size()) - 1));
    const int count = robot.robot->add_fluid_forces(stepsize);
    call.done();
    return count;
}

int add_forces(Built& robot, double stepsize)
{
    if (!(stepsize > 0) || !std::isfinite(stepsize)) throw nb::value_error("a step size must be above 0");
    Call call;
    call.uses(robot.robot->body(int(robot.model().links.size()) - 1));
    const int count = robot.robot->add_forces(stepsize);
    call.done();
    return count;
}

void set_activation(Built& robot, int actuator, double value)
{
    if (actuator < 0 || actuator >= int(robot.model().actuators.size()))
        throw nb::index_error("no such actuator");
    if (!std::isfinite(value)) throw nb::value_error("an activation must be finite");
    Call call;
    robot.robot->set_activation(actuator, value);
    call.done();
}

void update(Built& robot, double stepsize)
{
    if (!(stepsize > 0) || !std::isfinite(stepsize)) throw nb::value_error("a step size must be positive");
    robot.sensors->update(stepsize);
}

nb::object imu(const Built& robot, int link, nb::object frame)
{
    Vec force, rate;
    if (!robot.sensors->imu(link_of(robot, link), read_pose(frame), force, rate))
        throw nb::value_error("call update_sensors after every step");
    return nb::make_tuple(row(force), row(rate));
}

nb::object force_torque(const Built& robot, int link, nb::object frame)
{
    Vec force, torque;
    if (!robot.sensors->force_torque(link_of(robot, link), read_pose(frame), force, torque))
        throw nb::value_error("watch_force of this link first");
    return nb::make_tuple(row(force), row(torque));
}

nb::object touch(const Built& robot, int link)
{
    const Touch its = robot.sensors->touch(link_of(robot, link));
    return nb::make_tuple(its.points, its.normal_force, row(its.force), row(its.centre));
}

nb::object rays(const Built& robot, int link, nb::object frame, const SpaceHandle& space,
                nb::object directions, double max_distance)
{
    const auto array = array_in<double>(directions);
    std::vector<Vec> ways;
    for (size_t i = 0; i + 2 < array.size; i += 3)
        ways.push_back({array.data[i], array.data[i + 1], array.data[i + 2]});
    if (array.size % 3 != 0 || !(max_distance >= 0))
        throw nb::value_error("rows of 3 numbers and a distance of 0 or more are expected");
    std::vector<dQueryHit> hits;
    Call call;
    robot.sensors->cast(link_of(robot, link), read_pose(frame), space_of(&space), ways, max_distance, 1,
                        hits);
    call.done();
    Reals out;
    for (const dQueryHit& hit : hits) out.push_back(hit.geom ? hit.distance : HUGE_VAL);
    return row(out);
}

// (color as bytes, depth, geoms as bytes of 64 bits each)
nb::object picture(const Built& robot, int link, nb::object frame, const SpaceHandle& space, int width,
                   int height, double field, double max_distance, int threads)
{
    if (width < 1 || height < 1 || width > 8192 || height > 8192 || !(field > 0) || !(field < 3.14159) ||
        !(max_distance > 0) || threads < 0)
        throw nb::value_error(
            "sides of 1 to 8192 pixels, a field between 0 and pi and a positive distance are expected");
    const size_t count = size_t(width) * size_t(height);
    std::vector<unsigned char> color(3 * count);
    std::vector<dGeomID> geoms(count);
    dReal* depth;
    nb::object depths = real_array(size_t(height), size_t(width), &depth);
    const View view{width, height, threads, field, max_distance};
    Call call;
    robot.sensors->take_picture(link_of(robot, link), read_pose(frame), space_of(&space), view,
                                {depth, geoms.data(), color.data()});
    call.done();
    return nb::make_tuple(nb::bytes(color.data(), color.size()), depths,
                          nb::bytes(geoms.data(), geoms.size() * sizeof(dGeomID)));
}

nb::list sensors(const Model& m)
{
    nb::list out;
    for (const Sensor& its : m.model.sensors)
        out.append(nb::make_tuple(its.name, its.kind, its.object, values_of(its.kind)));
    return out;
}

nb::object read_sensor(const Built& robot, int number, const SpaceHandle& space)
{
    if (number < 0 || number >= int(robot.model().sensors.size())) throw nb::index_error("no such sensor");
    std::string problem;
    const Reals values = robot.sensors->read(number, space_of(&space), problem);
    if (values.empty()) throw nb::value_error(("cannot be read; wanted: " + problem).c_str());
    return row(values);
}

}  // namespace

void bind_robots(nb::module_& m)
{
    nb::class_<Model>(m, "_RobotModel")
        .def(nb::new_([](const std::string& path, nb::object text, nb::dict options) {
                 return load(path, text, options);
             }),
             "path"_a, "text"_a.none(), "options"_a)
        .def_prop_ro("name", [](const Model& s) { return s.model.name; })
        .def_prop_ro("format", [](const Model& s) { return s.model.format; })
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
        .def_prop_ro("sensors", sensors)
        .def_prop_ro("frame_names", frame_names)
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
    nb::class_<Built>(m, "_Robot")
        .def_prop_ro("bodies", [](const Built& s) { return handles(s.robot->all_bodies()); })
        .def_prop_ro("joints", [](const Built& s) { return handles(s.robot->all_joints()); })
        .def_prop_ro("geoms", [](const Built& s) { return handles(s.robot->geoms()); })
        .def("body", [](const Built& s, int link) { return wrapped(s.robot->body(link)); })
        .def("joint", [](const Built& s, int joint) { return wrapped(s.robot->joint(joint)); })
        .def("release", &Built::release)
        .def("positions", [](const Built& s) { return row(s.robot->positions()); })
        .def("velocities", [](const Built& s) { return row(s.robot->velocities()); })
        .def("set_positions", set_positions)
        .def("set_velocities", set_velocities)
        .def("control", [](const Built& s, int actuator) { return s.robot->control(actuator); })
        .def("set_control", set_control)
        .def("set_target", set_target)
        .def("add_fluid_forces", add_fluid_forces)
        .def("add_forces", add_forces)
        .def("activation", [](const Built& s, int actuator) { return s.robot->activation(actuator); })
        .def("set_activation", set_activation)
        .def("update_sensors", update)
        .def("drive_forces", [](const Built& s) { return row(s.sensors->drive_forces()); })
        .def("imu", imu)
        .def("watch_force",
             [](Built& s, int link, bool on) { return s.sensors->watch_force(link_of(s, link), on); })
        .def("force_torque", force_torque)
        .def("touch", touch)
        .def("rays", rays)
        .def("picture", picture)
        .def("read_sensor", read_sensor);
    m.def("_many_positions", many_positions);
    m.def("_many_velocities", many_velocities);
    m.def("_set_many_positions", set_many_positions);
    m.def("_set_many_velocities", set_many_velocities);
    m.def("_set_many_controls", set_many_controls);
}

#else

void bind_robots(nb::module_&) {}

#endif
