// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See robot.h: scenes of robots. One that is not fixed begins with its lowest point 1 cm above a floor, unless its file
// has one.
#include <algorithm>
#include <array>
#include <memory>
#include <set>

#include <fmt/format.h>

#include "cli/console.h"
#include "cli/robot.h"
#include "scenes/build.h"
#include "scenes/extensions.h"

#ifdef EPODE_HAVE_ROBOTS
#include "robots/build.h"
#include "robots/kinematics.h"
#include "robots/load.h"
#endif

namespace epode::cli {

#ifdef EPODE_HAVE_ROBOTS

namespace {

using robots::RobotModel;

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

// What a slider spans: an axis without limits half a turn or 1 m each way.
std::array<double, 2> reach_of(const RobotModel& model, int number)
{
    const robots::Joint& joint = model.joints[size_t(number)];
    const double reach = joint.kind == robots::JointKind::kHinge ? 3.14159 : 1;
    return {std::isfinite(joint.low) ? joint.low : joint.reference - reach,
            std::isfinite(joint.high) ? joint.high : joint.reference + reach};
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

// A slider for every actuator.
void add_controls(scenes::Scene& scene, const std::shared_ptr<robots::Robot>& robot)
{
    const auto& actuators = robot->model().actuators;
    for (size_t i = 0; i < actuators.size(); ++i) {
        const robots::Actuator& its = actuators[i];
        const double low = std::isfinite(its.low) ? its.low
                           : its.joint >= 0       ? reach_of(robot->model(), its.joint)[0]
                                                  : -1;
        const double high = std::isfinite(its.high) ? its.high
                            : its.joint >= 0        ? reach_of(robot->model(), its.joint)[1]
                                                    : 1;
        scene.dials.push_back({its.name, "", low, high, [robot, i] { return robot->control(int(i)); },
                               [robot, i](double value) { robot->set_control(int(i), value); }});
    }
}

std::shared_ptr<robots::Robot> add_robot(scenes::Scene& scene)
{
    auto robot = std::make_shared<robots::Robot>(offered, scene.world(), scene.space(), robots::Pose{},
                                                 start_of(offered->model()));
    robot->add_looks(scene.space());
    for (dBodyID body : robot->all_bodies()) scene.add_body(body);
    for (dGeomID geom : robot->geoms()) scene.add_geom(geom);
    for (dJointID joint : robot->all_joints())
        if (dJointGetType(joint) != dJointTypeAMotor) scene.add_joint(joint);
    const Extent extent = extent_of(robot->geoms());
    add_floor(scene, *robot, extent);
    set_view(scene, extent);
    robot->release();  // the scene destroys its world with all in it
    return robot;
}

void build_offered(scenes::Scene& scene)
{
    const RobotModel& model = offered->model();
    dWorldSetGravity(scene.world(), dReal(model.gravity.x), dReal(model.gravity.y), dReal(model.gravity.z));
    const std::shared_ptr<robots::Robot> robot = add_robot(scene);
    if (!model.starts.empty())
        for (size_t i = 0; i < std::min(model.starts[0].controls.size(), model.actuators.size()); ++i)
            robot->set_control(int(i), model.starts[0].controls[i]);
    scene.before_step([robot](double, double dt) { robot->add_forces(dt); });
    add_controls(scene, robot);
}

// Axes that others move: those that mimic one, and those of closed loops, but the first of each.
std::set<int> followers_of(const RobotModel& model)
{
    std::set<int> out;
    for (const robots::Closure& closure : model.closures) {
        std::vector<int> loop;
        for (int end : {closure.link1, closure.link2})
            for (int link = end; link > 0; link = model.links[size_t(link)].parent)
                loop.insert(loop.end(), model.links[size_t(link)].joints.begin(),
                            model.links[size_t(link)].joints.end());
        if (loop.empty()) continue;
        out.insert(loop.begin(), loop.end());
        out.erase(*std::min_element(loop.begin(), loop.end()));
    }
    for (const robots::Coupling& coupling : model.couplings) out.insert(coupling.terms[0].joint);
    return out;
}

// Nothing but servos moves a posed robot: no gravity, no actuators, springs and friction; a free root is held.
void make_passive(RobotModel& model)
{
    model.actuators.clear();
    for (robots::Joint& joint : model.joints) {
        joint.stiffness = joint.friction = 0;
        joint.max_force = robots::kInfinity;
    }
}

// Servos of kRate, critically damped by the inertia that each axis feels where the robot begins.
void build_posed(scenes::Scene& scene)
{
    constexpr double kRate = 15, kLeastInertia = 1e-6;  // 1/s, kg m^2 or kg
    const RobotModel& model = offered->model();
    dWorldSetGravity(scene.world(), 0, 0, 0);
    const std::shared_ptr<robots::Robot> robot = add_robot(scene);
    const std::vector<double> start = start_of(model), inertia = robots::mass_matrix(model, start);
    const std::set<int> followers = followers_of(model);
    const size_t n = size_t(robots::number_of_velocities(model));
    size_t velocity = 0;
    for (size_t i = 0; i < model.joints.size(); ++i) {
        const robots::Joint& joint = model.joints[i];
        if (joint.kind == robots::JointKind::kFree) dBodySetKinematic(robot->body(joint.link));
        const double felt = std::max(kLeastInertia, inertia[velocity * n + velocity]);
        velocity += size_t(robots::velocities_of(joint));
        if (!joint.is_scalar() || followers.count(int(i))) continue;
        auto servo = std::make_shared<robots::Servo>(
            robots::Servo{felt * kRate * kRate, 2 * felt * kRate, start[size_t(joint.position)]});
        robot->set_servo(int(i), *servo);
        const auto turn = [robot, i, servo](double value) {
            servo->target = value;
            robot->set_servo(int(i), *servo);
        };
        const auto [low, high] = reach_of(model, int(i));
        const bool is_hinge = joint.kind == robots::JointKind::kHinge;
        scene.dials.push_back(
            {joint.name, is_hinge ? "rad" : "m", low, high, [servo] { return servo->target; }, turn});
    }
}

}  // namespace

bool offer_robot(const std::string& what, bool posed, std::string& problem)
{
    const bool is_robot = what.ends_with(".urdf") || what.ends_with(".xml") || what.ends_with(".mjcf") ||
                          what.ends_with(".sdf");
    if (!is_robot) return true;
    if (!scenes::has_world_contacts()) {
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
    if (posed) make_passive(model);
    static const std::string name = what;
    const double stepsize = model.stepsize > 0 ? model.stepsize : 0.002;
    static const scenes::Recipe recipe = {name.c_str(),
                                          "a robot from a file",
                                          stepsize,
                                          5,
                                          scenes::Stepper::kExact,
                                          posed ? &build_posed : &build_offered};
    const scenes::Runtime runtime;
    offered = std::make_shared<const robots::Prepared>(std::move(model));
    scenes::add_recipe(recipe);
    return true;
}

#else

bool offer_robot(const std::string&, bool, std::string&) { return true; }

#endif

}  // namespace epode::cli
