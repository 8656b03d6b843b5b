// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The C functions of models and robots: see api.h.
#include "epode/robots.h"

#include <cstring>

#include "robots/api.h"
#include "robots/constraints.h"
#include "robots/fluid.h"
#include "robots/kinematics.h"
#include "robots/load.h"
#include "robots/write/write.h"

using namespace epode::robots;

namespace {

std::vector<std::string> folders_of(const char* roots)
{
    std::vector<std::string> out;
    std::string text = roots ? roots : "";
    while (!text.empty()) {
        const size_t colon = text.find(':');
        if (colon != 0) out.push_back(text.substr(0, colon));
        text = colon == std::string::npos ? "" : text.substr(colon + 1);
    }
    return out;
}

epode::robots::LoadOptions options_of(const dRobotOptions* options)
{
    epode::robots::LoadOptions out;
    if (!options) return out;
    out.roots = folders_of(options->roots);
    out.strict = options->strict, out.keep_fixed = options->keep_fixed, out.fixed_base = options->fixed_base;
    out.repair = options->repair, out.inertia_from_shapes = options->inertia_from_shapes;
    out.meshes_as_triangles = options->meshes_as_triangles, out.missing_mass = double(options->missing_mass);
    out.meshes_as_parts = options->meshes_as_parts, out.parts.tolerance = double(options->part_tolerance);
    if (options->max_parts > 0) out.parts.max_parts = options->max_parts;
    if (options->max_part_vertices > 0) out.parts.max_vertices = unsigned(options->max_part_vertices);
    return out;
}

bool are_good(const dRobotOptions* options)
{
    if (!options) return true;
    const auto is_size = [](dReal value) { return is_usable(value) && value >= 0; };
    return options->struct_size == sizeof(dRobotOptions) && is_size(options->missing_mass) &&
           is_size(options->part_tolerance) && options->max_parts >= 0 && options->max_parts <= 256 &&
           (options->max_part_vertices == 0 || options->max_part_vertices >= 4);
}

dRobotModelID keep(RobotModel model)
{
    const auto its = std::find_if(model.report.begin(), model.report.end(),
                                  [](const auto& line) { return line.note == epode::robots::Note::kError; });
    if (its != model.report.end())
        dMessage(d_ERR_UNKNOWN, "robot %s:%d: %s", its->file.c_str(), its->line, its->text.c_str());
    auto out = std::make_unique<dxRobotModel>(dxRobotModel{std::move(model), nullptr});
    return Handles<dxRobotModel>::all().add(std::move(out));
}

void copy(epode::robots::Vec v, dVector3 out)
{
    out[0] = dReal(v.x), out[1] = dReal(v.y), out[2] = dReal(v.z), out[3] = 0;
}

dReal real_of(double value)
{
    return std::isinf(value) ? dReal(value > 0 ? dInfinity : -dInfinity) : dReal(value);
}

dRobotLink link_of(const epode::robots::Link& link)
{
    dRobotLink out{};
    out.name = link.name.c_str(), out.parent = link.parent, out.joints = int(link.joints.size());
    out.shapes = int(link.shapes.size()), out.mass = dReal(link.mass);
    copy(link.centre, out.centre);
    for (size_t i = 0; i < 3; ++i)
        for (size_t k = 0; k < 3; ++k) out.inertia[4 * i + k] = dReal(link.inertia[i][k]);
    return out;
}

dRobotJoint joint_of(const epode::robots::Joint& joint)
{
    dRobotJoint out{};
    out.name = joint.name.c_str(), out.kind = int(joint.kind), out.link = joint.link,
    out.position = joint.position;
    copy(joint.anchor, out.anchor), copy(joint.axis, out.axis);
    out.low = real_of(joint.low), out.high = real_of(joint.high);
    out.max_force = real_of(joint.max_force), out.max_velocity = real_of(joint.max_velocity);
    return out;
}

dRobotActuator actuator_of(const epode::robots::Actuator& actuator)
{
    const bool is_filtered = actuator.filter.kind != epode::robots::Activation::Kind::kNone;
    return {actuator.name.c_str(), actuator.joint, is_filtered, real_of(actuator.low),
            real_of(actuator.high)};
}

constexpr const char* kPositions =
    "a model without errors, its finite positions, a capacity of 0 or more, and an array unless it is 0";
constexpr const char* kArray = "a model, a capacity of 0 or more, and an array unless it is 0";

}  // namespace

int dRobotOptionsInit(dRobotOptions* options, unsigned struct_size)
{
    CHECK(options && struct_size == sizeof(dRobotOptions), "a structure and its size, sizeof(dRobotOptions)");
    *options = dRobotOptions{};
    options->struct_size = struct_size;
    return 1;
}

dRobotModelID dRobotModelLoad(const char* path, const dRobotOptions* options)
{
    CHECK(path && are_good(options),
          "a path, and NULL or options with their size and numbers in their ranges");
    return guarded(__func__, [&] { return keep(epode::robots::load_robot(path, options_of(options))); });
}

dRobotModelID dRobotModelLoadText(const char* path, const char* text, dsizeint size,
                                  const dRobotOptions* options)
{
    CHECK(path && text && are_good(options),
          "a path, a text, and NULL or options with their size and numbers in their ranges");
    return guarded(__func__, [&] {
        return keep(epode::robots::load_robot_text(path, std::string(text, size), options_of(options)));
    });
}

int dRobotModelSave(dRobotModelID model, const char* path)
{
    model = alive(model);
    CHECK(model && path, "a model and a path");
    return guarded(__func__, [&] {
        std::vector<std::string> lost;
        std::string problem;
        if (!epode::robots::save_robot(model->model, path, lost, problem)) {
            dMessage(d_ERR_UNKNOWN, "dRobotModelSave: refused: %s", problem.c_str());
            return 0;
        }
        for (const std::string& text : lost) dMessage(d_ERR_UNKNOWN, "robot %s: %s", path, text.c_str());
        return 1;
    });
}

void dRobotModelDestroy(dRobotModelID model)
{
    check(Handles<dxRobotModel>::all().remove(model), __func__, "a model");
}

int dRobotModelGetReport(dRobotModelID model, dRobotReportLine* lines, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (lines || capacity == 0), kArray);
    const auto& report = model->model.report;
    for (int i = 0; i < std::min(capacity, int(report.size())); ++i) {
        const auto& from = report[size_t(i)];
        lines[i] = {int(from.note), from.line, from.file.c_str(), from.text.c_str()};
    }
    return int(report.size());
}

int dRobotModelHasErrors(dRobotModelID model)
{
    model = alive(model);
    CHECK(model, "a model");
    return model->model.has_errors();
}

int dRobotModelGetLinks(dRobotModelID model, dRobotLink* links, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (links || capacity == 0), kArray);
    const auto& all = model->model.links;
    for (int i = 0; i < std::min(capacity, int(all.size())); ++i) links[i] = link_of(all[size_t(i)]);
    return int(all.size());
}

int dRobotModelGetJoints(dRobotModelID model, dRobotJoint* joints, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (joints || capacity == 0), kArray);
    const auto& all = model->model.joints;
    for (int i = 0; i < std::min(capacity, int(all.size())); ++i) joints[i] = joint_of(all[size_t(i)]);
    return int(all.size());
}

int dRobotModelGetActuators(dRobotModelID model, dRobotActuator* actuators, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (actuators || capacity == 0), kArray);
    const auto& all = model->model.actuators;
    for (int i = 0; i < std::min(capacity, int(all.size())); ++i) actuators[i] = actuator_of(all[size_t(i)]);
    return int(all.size());
}

int dRobotModelGetNumPositions(dRobotModelID model)
{
    model = alive(model);
    CHECK(model, "a model");
    return model->model.coordinates;
}

int dRobotModelGetNumActuators(dRobotModelID model)
{
    model = alive(model);
    CHECK(model, "a model");
    return int(model->model.actuators.size());
}

int dRobotModelGetNumStarts(dRobotModelID model)
{
    model = alive(model);
    CHECK(model, "a model");
    return int(model->model.starts.size());
}

int dRobotModelFindLink(dRobotModelID model, const char* name)
{
    model = alive(model);
    CHECK(model && name, "a model and a name");
    return guarded(__func__, [&] { return model->model.link_named(name); });
}

int dRobotModelFindJoint(dRobotModelID model, const char* name)
{
    model = alive(model);
    CHECK(model && name, "a model and a name");
    return guarded(__func__, [&] { return model->model.joint_named(name); });
}

int dRobotModelFindActuator(dRobotModelID model, const char* name)
{
    model = alive(model);
    CHECK(model && name, "a model and a name");
    return guarded(__func__, [&] { return model->model.actuator_named(name); });
}

int dRobotModelGetReference(dRobotModelID model, dReal* positions, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (positions || capacity == 0), kArray);
    return guarded(__func__, [&] {
        return copy_positions(epode::robots::reference_positions(model->model), positions, capacity);
    });
}

int dRobotModelGetStart(dRobotModelID model, int number, dReal* positions, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (positions || capacity == 0), kArray);
    CHECK(number >= 0 && number < int(model->model.starts.size()), "the number of a start pose");
    return copy_positions(model->model.starts[size_t(number)].positions, positions, capacity);
}

const char* dRobotModelGetStartName(dRobotModelID model, int number)
{
    model = alive(model);
    CHECK(model && number >= 0 && number < int(model->model.starts.size()),
          "a model and the number of a start pose");
    return model->model.starts[size_t(number)].name.c_str();
}

int dRobotModelGetPoses(dRobotModelID model, const dReal* positions, int count, dReal* poses, int capacity)
{
    model = alive(model);
    CHECK(model && capacity >= 0 && (poses || capacity == 0), kArray);
    CHECK(count == model->model.coordinates && (positions || count == 0) && are_usable(positions, count),
          "as many finite positions as dRobotModelGetNumPositions");
    return guarded(__func__, [&] {
        const auto all = epode::robots::forward_kinematics(model->model, doubles_of(positions, count));
        for (int i = 0; i < std::min(capacity, int(all.size())); ++i) {
            const Pose& p = all[size_t(i)];
            const double values[7] = {p.p.x, p.p.y, p.p.z, p.q.w, p.q.x, p.q.y, p.q.z};
            for (int k = 0; k < 7; ++k) poses[7 * i + k] = dReal(values[k]);
        }
        return int(all.size());
    });
}

int dRobotModelGetNumVelocities(dRobotModelID model)
{
    model = alive(model);
    CHECK(model, "a model");
    return epode::robots::number_of_velocities(model->model);
}

int dRobotModelGetJacobian(dRobotModelID model, const dReal* positions, int link, const dReal* point,
                           dReal* jacobian, int capacity)
{
    model = alive(model);
    CHECK(can_compute(model, positions) && capacity >= 0 && (jacobian || capacity == 0), kPositions);
    CHECK(link >= 0 && link < int(model->model.links.size()) && (!point || are_usable(point, 3)),
          "the number of a link and a finite point");
    return guarded(__func__, [&] {
        epode::robots::Vec place;
        for (int i = 0; point && i < 3; ++i) place[i] = double(point[i]);
        const auto q = doubles_of(positions, model->model.coordinates);
        return copy_positions(epode::robots::jacobian(model->model, q, link, place), jacobian, capacity);
    });
}

int dRobotModelGetConstraints(dRobotModelID model, const dReal* positions, dReal* residuals, dReal* jacobian,
                              int capacity)
{
    model = alive(model);
    CHECK(can_compute(model, positions) && capacity >= 0, kPositions);
    return guarded(__func__, [&] {
        const auto q = doubles_of(positions, model->model.coordinates);
        const auto c = epode::robots::constraint_errors(model->model, q);
        const int columns = epode::robots::number_of_velocities(model->model);
        const int rows = std::min(capacity, int(c.size()));
        if (residuals) copy_positions(c, residuals, rows);
        if (jacobian)
            copy_positions(epode::robots::constraint_jacobian(model->model, q), jacobian, rows * columns);
        return int(c.size());
    });
}

int dRobotModelGetGravity(dRobotModelID model, dReal* gravity)
{
    model = alive(model);
    CHECK(model && gravity, "a model and three reals");
    for (int i = 0; i < 3; ++i) gravity[i] = dReal(model->model.gravity[i]);
    return 1;
}

dReal dRobotModelGetStepsize(dRobotModelID model)
{
    model = alive(model);
    CHECK(model, "a model");
    return dReal(model->model.stepsize);
}

int dRobotModelGetMassMatrix(dRobotModelID model, const dReal* positions, dReal* matrix, int capacity)
{
    model = alive(model);
    CHECK(can_compute(model, positions) && capacity >= 0 && (matrix || capacity == 0), kPositions);
    return guarded(__func__, [&] {
        const auto q = doubles_of(positions, model->model.coordinates);
        return copy_positions(epode::robots::mass_matrix(model->model, q), matrix, capacity);
    });
}

int dRobotModelGetInverseDynamics(dRobotModelID model, const dReal* positions, const dReal* velocities,
                                  const dReal* accelerations, dReal* forces, int capacity)
{
    model = alive(model);
    CHECK(can_compute(model, positions) && capacity >= 0 && (forces || capacity == 0), kPositions);
    const int count = epode::robots::number_of_velocities(model->model);
    CHECK((!velocities || are_usable(velocities, count)) &&
              (!accelerations || are_usable(accelerations, count)),
          "finite velocities and accelerations, or NULL");
    return guarded(__func__, [&] {
        const std::vector<double> zeros(size_t(count), 0);
        const auto q = doubles_of(positions, model->model.coordinates);
        return copy_positions(
            epode::robots::inverse_dynamics(
                model->model, q, velocities ? doubles_of(velocities, count) : zeros,
                accelerations ? doubles_of(accelerations, count) : zeros, model->model.gravity),
            forces, capacity);
    });
}

int dRobotModelGetFluidForces(dRobotModelID model, const dReal* positions, const dReal* velocities,
                              dReal* forces, int capacity)
{
    model = alive(model);
    CHECK(can_compute(model, positions) && capacity >= 0 && (forces || capacity == 0), kPositions);
    const int count = epode::robots::number_of_velocities(model->model);
    CHECK(count == 0 || (velocities && are_usable(velocities, count)), "finite velocities");
    return guarded(__func__, [&] {
        const auto q = doubles_of(positions, model->model.coordinates);
        return copy_positions(epode::robots::fluid_forces(model->model, q, doubles_of(velocities, count)),
                              forces, capacity);
    });
}

dRobotID dRobotCreate(dWorldID world, dSpaceID space, dRobotModelID model, const dReal* position,
                      const dReal* q)
{
    model = alive(model);
    CHECK(model, "a model");
    CHECK(!model->model.has_errors(), "a model without errors; dRobotModelGetReport has them");
    CHECK((!position || are_usable(position, 3)) && (!q || are_usable(q, 4)), "a finite pose");
    CHECK(is_world(world) && (!space || is_space(space)), "a world, and a space or NULL");
    return guarded(__func__, [&] {
        if (!model->prepared) {
            model->prepared = std::make_shared<const epode::robots::Prepared>(model->model);
            for (const std::string& text : epode::robots::Robot::not_built(model->model))
                dMessage(d_ERR_UNKNOWN, "robot %s: %s",
                         (model->model.name.empty() ? model->model.path : model->model.name).c_str(),
                         text.c_str());
        }
        Pose pose;
        if (position) pose.p = {double(position[0]), double(position[1]), double(position[2])};
        if (q) pose.q = epode::robots::normalised({double(q[0]), double(q[1]), double(q[2]), double(q[3])});
        auto out = std::make_unique<dxRobot>();
        out->robot = std::make_unique<epode::robots::Robot>(model->prepared, world, space, pose,
                                                            std::vector<double>());
        out->sensors = std::make_unique<Sensors>(*out->robot, world);
        return Handles<dxRobot>::all().add(std::move(out));
    });
}

void dRobotDestroy(dRobotID robot) { check(Handles<dxRobot>::all().remove(robot), __func__, "a robot"); }

dBodyID dRobotGetBody(dRobotID robot, int link)
{
    robot = alive(robot);
    CHECK(robot && link >= 0 && link < int(robot->robot->model().links.size()),
          "a robot and the number of a link");
    return robot->robot->body(link);
}

dJointID dRobotGetJoint(dRobotID robot, int joint)
{
    robot = alive(robot);
    CHECK(robot && joint >= 0 && joint < int(robot->robot->model().joints.size()),
          "a robot and the number of a joint");
    return robot->robot->joint(joint);
}

int dRobotSetPositions(dRobotID robot, const dReal* positions, int count)
{
    robot = alive(robot);
    CHECK(robot && count == robot->robot->model().coordinates && (positions || count == 0) &&
              are_usable(positions, count),
          "a robot, and as many finite positions as dRobotModelGetNumPositions");
    return guarded(__func__, [&] {
        robot->robot->set_positions(doubles_of(positions, count));
        robot->sensors->begin();
        return 1;
    });
}

int dRobotGetPositions(dRobotID robot, dReal* positions, int capacity)
{
    robot = alive(robot);
    CHECK(robot && capacity >= 0 && (positions || capacity == 0),
          "a robot, a capacity of 0 or more, and an array unless it is 0");
    return guarded(__func__, [&] { return copy_positions(robot->robot->positions(), positions, capacity); });
}

int dRobotSetVelocities(dRobotID robot, const dReal* velocities, int count)
{
    robot = alive(robot);
    CHECK(robot && count == number_of_velocities(robot->robot->model()) && (velocities || count == 0) &&
              are_usable(velocities, count),
          "a robot, and as many finite velocities as dRobotModelGetNumVelocities");
    return guarded(__func__, [&] {
        robot->robot->set_velocities(doubles_of(velocities, count));
        robot->sensors->begin();
        return 1;
    });
}

int dRobotGetVelocities(dRobotID robot, dReal* velocities, int capacity)
{
    robot = alive(robot);
    CHECK(robot && capacity >= 0 && (velocities || capacity == 0),
          "a robot, a capacity of 0 or more, and an array unless it is 0");
    return guarded(__func__,
                   [&] { return copy_positions(robot->robot->velocities(), velocities, capacity); });
}

int dRobotSetControl(dRobotID robot, int actuator, dReal control)
{
    robot = alive(robot);
    CHECK(robot && actuator >= 0 && actuator < int(robot->robot->model().actuators.size()) &&
              is_usable(control),
          "a robot, the number of an actuator and a finite control");
    robot->robot->set_control(actuator, double(control));
    return 1;
}

dReal dRobotGetControl(dRobotID robot, int actuator)
{
    robot = alive(robot);
    CHECK(robot && actuator >= 0 && actuator < int(robot->robot->model().actuators.size()),
          "a robot and the number of an actuator");
    return dReal(robot->robot->control(actuator));
}

int dRobotSetTarget(dRobotID robot, int joint, dReal target, dReal stiffness, dReal damping)
{
    robot = alive(robot);
    CHECK(robot && joint >= 0 && joint < int(robot->robot->model().joints.size()) &&
              robot->robot->model().joints[size_t(joint)].is_scalar(),
          "a robot and the number of a hinge or slider");
    CHECK(is_usable(target) && is_usable(stiffness) && is_usable(damping) && stiffness >= 0 && damping >= 0,
          "finite numbers, and stiffness and damping of 0 or more");
    robot->robot->set_servo(joint, {double(stiffness), double(damping), double(target)});
    return 1;
}

int dRobotModelGetNumMocap(dRobotModelID model)
{
    model = alive(model);
    CHECK(model, "a model");
    return int(model->model.mocap_links().size());
}

int dRobotModelGetMocap(dRobotModelID model, int number)
{
    model = alive(model);
    const std::vector<int> all = model ? model->model.mocap_links() : std::vector<int>();
    if (check(number >= 0 && number < int(all.size()), __func__,
              "a model and a number below dRobotModelGetNumMocap"))
        return all[size_t(number)];
    return 0;
}

int dRobotSetMocap(dRobotID robot, int link, const dReal* position, const dReal* q)
{
    robot = alive(robot);
    CHECK(robot && link > 0 && link < int(robot->robot->model().links.size()) &&
              robot->robot->model().links[size_t(link)].is_mocap,
          "a robot and the number of a link that the program moves (mocap)");
    const bool has_turn = q && (q[0] != 0 || q[1] != 0 || q[2] != 0 || q[3] != 0);
    CHECK((!position || are_usable(position, 3)) && (!q || (are_usable(q, 4) && has_turn)), "a finite pose");
    Pose pose = robot->robot->link_pose(link);
    if (position) pose.p = {double(position[0]), double(position[1]), double(position[2])};
    if (q) pose.q = epode::robots::normalised({double(q[0]), double(q[1]), double(q[2]), double(q[3])});
    return robot->robot->set_mocap(link, pose);
}

int dRobotAddFluidForces(dRobotID robot, dReal stepsize)
{
    robot = alive(robot);
    CHECK(robot && is_usable(stepsize) && stepsize >= 0, "a robot and a stepsize of 0 or more");
    return robot->robot->add_fluid_forces(double(stepsize));
}
