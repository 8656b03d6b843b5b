// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Robots in worlds, under epode.robot.Robot. A model is read once and shared by its robots, which keep the arrays that their
// geoms point to. A robot whose world is gone is released: it then owns nothing.
#include "robots.h"

#ifdef EPODE_HAVE_ROBOTS

#include <nanobind/stl/vector.h>

using namespace bound;

Built* bound::build(Model& m, const WorldHandle& world, const SpaceHandle& space, nb::object pose)
{
    if (m.model.has_errors()) throw nb::value_error("the model has errors: see its report");
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

namespace {

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

void check_actuator(const Built& robot, int actuator, double value)
{
    if (actuator < 0 || actuator >= int(robot.model().actuators.size()))
        throw nb::index_error("no such actuator");
    if (!std::isfinite(value)) throw nb::value_error("a finite control or activation is expected");
}

void set_control(Built& robot, int actuator, double value)
{
    check_actuator(robot, actuator, value);
    Call call;
    robot.robot->set_control(actuator, value);
    call.done();
}

void set_activation(Built& robot, int actuator, double value)
{
    check_actuator(robot, actuator, value);
    Call call;
    robot.robot->set_activation(actuator, value);
    call.done();
}

void set_state(Built& robot, nb::object from)
{
    const Reals numbers = read(from, robot.robot->state().size(), "robot's numbers");
    Call call;
    call.uses(robot.robot->body(int(robot.model().links.size()) - 1));
    const bool fits = robot.robot->set_state(numbers);
    if (fits) robot.sensors->begin();
    call.done();
    if (!fits) throw nb::value_error("these are not the numbers of a robot of this model");
}

void set_mocap(Built& robot, int link, nb::object pose)
{
    Call call;
    const bool fits = robot.robot->set_mocap(link, read_pose(pose));
    call.done();
    if (!fits) throw nb::value_error("a link that the program moves (mocap) is expected");
}

template <typename P, typename Handle>
std::vector<P> pointers(nb::list from)
{
    std::vector<P> out;
    for (nb::handle one : from) out.push_back(nb::cast<const Handle&>(one).p);
    return out;
}

// The same robot in a copy of its world.
Built* counterpart(const Built& like, const WorldHandle& world, nb::list bodies, nb::list joints,
                   nb::list geoms)
{
    Call call;
    call.uses(world.p);
    auto out = std::make_unique<Built>();
    out->robot = like.robot->counterpart(pointers<dBodyID, BodyHandle>(bodies),
                                         pointers<dJointID, JointHandle>(joints),
                                         pointers<dGeomID, GeomHandle>(geoms));
    if (!out->robot) throw nb::value_error("these are not the parts of a robot of this model");
    out->sensors = std::make_unique<Sensors>(*out->robot, world.p);
    call.done();
    return out.release();
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

// A row of numbers of each.
template <Reals (*read_one)(const Built&)>
nb::object many(const Many& robots)
{
    model_of(robots);
    Reals all;
    Call call;
    use_all(call, robots);
    for (const Built* robot : robots) {
        const Reals its = read_one(*robot);
        all.insert(all.end(), its.begin(), its.end());
    }
    call.done();
    return table(all, robots.size(), all.size() / robots.size());
}

template <Reals (*read_one)(const Built&)>
nb::object one(const Built& robot)
{
    return row(read_one(robot));
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

Reals positions_of(const Built& s) { return s.robot->positions(); }
Reals velocities_of(const Built& s) { return s.robot->velocities(); }
Reals drive_forces_of(const Built& s) { return s.sensors->drive_forces(); }

template <typename Get>
Reals of_actuators(const Built& s, Get get)
{
    Reals out(s.model().actuators.size());
    for (size_t i = 0; i < out.size(); ++i) out[i] = get(*s.robot, int(i));
    return out;
}

Reals controls_of(const Built& s)
{
    return of_actuators(s, [](const Robot& r, int i) { return r.control(i); });
}
Reals activations_of(const Built& s)
{
    return of_actuators(s, [](const Robot& r, int i) { return r.activation(i); });
}
Reals actuator_forces_of(const Built& s)
{
    return of_actuators(s, [](const Robot& r, int i) { return r.actuator_force(i); });
}

Reals link_poses_of(const Built& s)
{
    Reals out;
    out.reserve(7 * s.model().links.size());
    for (size_t i = 0; i < s.model().links.size(); ++i) {
        const Pose p = s.robot->link_pose(int(i));
        out.insert(out.end(), {p.p.x, p.p.y, p.p.z, p.q.w, p.q.x, p.q.y, p.q.z});
    }
    return out;
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

template <typename F>
int add(Built& robot, F forces)
{
    Call call;
    call.uses(robot.robot->body(int(robot.model().links.size()) - 1));
    const int count = forces(*robot.robot);
    call.done();
    return count;
}

int add_fluid_forces(Built& robot, double stepsize)
{
    if (!(stepsize >= 0) || !std::isfinite(stepsize)) throw nb::value_error("a step size must be 0 or more");
    return add(robot, [&](Robot& its) { return its.add_fluid_forces(stepsize); });
}

int add_forces(Built& robot, double stepsize)
{
    if (!(stepsize > 0) || !std::isfinite(stepsize)) throw nb::value_error("a step size must be positive");
    return add(robot, [&](Robot& its) { return its.add_forces(stepsize); });
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
    bind_robot_models(m);
    nb::class_<Built>(m, "_Robot")
        .def_prop_ro("bodies", [](const Built& s) { return handles(s.robot->all_bodies()); })
        .def_prop_ro("joints", [](const Built& s) { return handles(s.robot->all_joints()); })
        .def_prop_ro("geoms", [](const Built& s) { return handles(s.robot->geoms()); })
        .def("body", [](const Built& s, int link) { return wrapped(s.robot->body(link)); })
        .def("joint", [](const Built& s, int joint) { return wrapped(s.robot->joint(joint)); })
        .def("release", &Built::release)
        .def("positions", one<positions_of>)
        .def("velocities", one<velocities_of>)
        .def("set_positions", set_positions)
        .def("set_velocities", set_velocities)
        .def("controls", one<controls_of>)
        .def("set_control", set_control)
        .def("set_target", set_target)
        .def("set_mocap", set_mocap)
        .def("actuator_forces", one<actuator_forces_of>)
        .def("link_pose", [](const Built& s, int link) { return row(s.robot->link_pose(link_of(s, link))); })
        .def("link_poses", one<link_poses_of>)
        .def("counterpart", counterpart)
        .def_prop_ro("placement", [](const Built& s) { return row(s.robot->placement()); })
        .def("add_fluid_forces", add_fluid_forces)
        .def("add_forces", add_forces)
        .def("activations", one<activations_of>)
        .def("set_activation", set_activation)
        .def("state", [](const Built& s) { return row(s.robot->state()); })
        .def("set_state", set_state)
        .def("update_sensors", update)
        .def("drive_forces", one<drive_forces_of>)
        .def("imu", imu)
        .def("watch_force",
             [](Built& s, int link, bool on) { return s.sensors->watch_force(link_of(s, link), on); })
        .def("force_torque", force_torque)
        .def("touch", touch)
        .def("rays", rays)
        .def("picture", picture)
        .def("read_sensor", read_sensor);
    m.def("_many_positions", many<positions_of>);
    m.def("_many_velocities", many<velocities_of>);
    m.def("_many_controls", many<controls_of>);
    m.def("_many_drive_forces", many<drive_forces_of>);
    m.def("_many_link_poses", many<link_poses_of>);
    m.def("_set_many_positions", set_many_positions);
    m.def("_set_many_velocities", set_many_velocities);
    m.def("_set_many_controls", set_many_controls);
}

#else

void bind_robots(nb::module_&) {}

#endif
