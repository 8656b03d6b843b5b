// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// From a model to bodies, joints and geoms in a world, as often as wanted: what costs time (hulls of meshes, pairs that
// overlap) is prepared once. A body's origin is its link's centre of mass, its axes are the link's. Bodies are made
// at the joints' reference position, where ODE's joints measure 0, and then moved to the start; a coordinate is ODE's
// position plus the reference. Where several joints act between two links, small bodies stand between them.
#pragma once

#include <ode/ext.h>
#include <ode/ode.h>

#include <memory>

#include "robots/bend.h"
#include "robots/kinematics.h"
#include "robots/model.h"
#include "robots/pairs.h"
#include "robots/parts/decompose.h"
#include "robots/softness.h"
#include "robots/tendon.h"

namespace epode::robots {

// A model made ready for worlds. Robots share it, and it lives as long as they do.
class Prepared {
  public:
    explicit Prepared(RobotModel model);
    ~Prepared();
    Prepared(const Prepared&) = delete;
    Prepared& operator=(const Prepared&) = delete;

    const RobotModel& model() const { return model_; }
    // Of a mesh: one, or several where the model decomposes meshes; none of a plate or a line.
    const std::vector<Hull>& hulls(int mesh) const { return hulls_[size_t(mesh)]; }
    struct Fit {
        int mesh, parts;
        double surplus;  // m
        double tolerance;
        bool is_closed;
    };
    // Of every mesh that was decomposed.
    const std::vector<Fit>& fits() const { return fits_; }
    dHeightfieldDataID heights(int field) const { return heights_[size_t(field)]; }
    dTriMeshDataID triangles(int mesh) const { return triangles_[size_t(mesh)]; }
    const Springs& springs() const { return springs_; }
    const PairMaterials& pairs() const { return pairs_; }
    // Of tendons the lengths between which their springs rest.
    const std::vector<std::array<double, 2>>& rests() const { return rests_; }
    const std::vector<std::array<int, 2>>& overlapping() const { return overlapping_; }
    // The numbers of those that act on it.
    const std::vector<int>& actuators_of_joint(int joint) const { return joint_actuators_[size_t(joint)]; }
    const std::vector<int>& actuators_of_tendon(int tendon) const
    {
        return tendon_actuators_[size_t(tendon)];
    }

  private:
    void make_hulls(int mesh);
    void make_triangles(size_t number);
    void make_heights();
    void make_rests();
    void list_actuators();
    void find_overlapping();

    RobotModel model_;
    Springs springs_;
    PairMaterials pairs_;
    std::vector<std::array<double, 2>> rests_;
    std::vector<std::vector<Hull>> hulls_;
    std::vector<Fit> fits_;
    std::vector<dTriMeshDataID> triangles_;
    std::vector<dHeightfieldDataID> heights_;
    std::vector<std::vector<dReal>> corners_;
    std::vector<std::vector<dTriIndex>> indices_;
    std::vector<std::array<int, 2>> overlapping_;
    std::vector<std::vector<int>> joint_actuators_, tendon_actuators_;
};

// A position drive that a program has put on a joint.
struct Servo {
    double stiffness = 0, damping = 0, target = 0;
};

class Robot {
  public:
    // Positions may be empty: the reference position. The pose is that of the world's frame of the model.
    Robot(std::shared_ptr<const Prepared> prepared, dWorldID world, dSpaceID space, const Pose& placement,
          const std::vector<double>& positions);
    ~Robot();
    Robot(const Robot&) = delete;
    Robot& operator=(const Robot&) = delete;

    const RobotModel& model() const { return prepared_->model(); }
    const std::shared_ptr<const Prepared>& prepared() const { return prepared_; }
    // Of tendons the lengths between which their springs rest.
    const std::vector<std::array<double, 2>>& rests() const { return prepared_->rests(); }
    // 0 of a world link that has no body.
    dBodyID body(int link) const { return bodies_[size_t(link)]; }
    // 0 of a free joint.
    dJointID joint(int number) const { return joints_[size_t(number)]; }
    const std::vector<dBodyID>& all_bodies() const { return all_bodies_; }
    const std::vector<dGeomID>& geoms() const { return geoms_; }
    const std::vector<dJointID>& all_joints() const { return all_joints_; }
    // Red, green and blue of a geom, by its place among geoms().
    const float* color(size_t geom) const { return colors_[geom].data(); }
    // What holds a link to its parent: the last of its joints; 0 of a free link.
    dJointID holder(int link) const { return holders_[size_t(link)]; }
    // Where the model's world is.
    const Pose& placement() const { return placement_; }
    // The model's parts that this builder does not make, a sentence each.
    static std::vector<std::string> not_built(const RobotModel& model);

    // Adds what links without shapes look like, as geoms that touch nothing.
    void add_looks(dSpaceID space);
    // The same robot made of other bodies, joints and geoms, in the order of all_bodies(), all_joints() and geoms(): of those of a copy of
    // its world. Null: not as many.
    std::unique_ptr<Robot> counterpart(const std::vector<dBodyID>& bodies,
                                       const std::vector<dJointID>& joints,
                                       const std::vector<dGeomID>& geoms) const;
    // Puts a body that the program moves at a pose in the world. False: of a link that is none.
    bool set_mocap(int link, const Pose& pose);
    Pose link_pose(int link) const;  // in the world
    // The angular motor of a ball with limits, drives or actuators (dAMotorTurn); 0: none.
    dJointID turn(int joint) const { return turns_[size_t(joint)]; }

    // Forgets bodies, joints and geoms: their world and space have been or will be destroyed with all in them.
    void release();

    // At rest, with all bodies where the coordinates put them.
    void set_positions(const std::vector<double>& positions);
    std::vector<double> positions() const;
    // As kinematics.h has them; setting them leaves the positions.
    void set_velocities(const std::vector<double>& velocities);
    std::vector<double> velocities() const;
    void set_control(int actuator, double value);
    double control(int actuator) const { return controls_[size_t(actuator)]; }
    void set_servo(int joint, const Servo& servo);
    // What is between control and force; 0 of an actuator without a filter.
    double activation(int actuator) const { return activations_[size_t(actuator)]; }
    void set_activation(int actuator, double value);
    // Controls, activations and servos: what acts next to the world's state (state.cpp).
    std::vector<double> state() const;
    size_t state_size() const;
    // False: numbers that state() does not return; nothing changes.
    bool set_state(const std::vector<double>& numbers);
    // Of an actuator: how long what it moves is, times its gear, and how fast that grows.
    struct Stroke {
        double length, rate;
    };
    Stroke stroke(int actuator) const;
    // Of a joint with one axis its coordinate, of a tendon its length.
    Stroke joint_stroke(int joint) const;
    Stroke tendon_stroke(int tendon) const;
    // Before its gear, at the present positions and velocities; and what all of them exert along a joint with one axis.
    double actuator_force(int actuator) const;
    double actuators_force(int joint) const;
    double actuators_force_of_tendon(int tendon) const;
    // What the limits of a joint or tendon exerted in the last step, or, of tendons with a path, at the last call of add_forces; 0 or more.
    double joint_limit_force(int joint) const;
    double tendon_limit_force(int tendon) const;
    // The sum of the steps that its sensors were told of.
    double time() const { return time_; }
    void pass(double stepsize) { time_ += stepsize; }
    // All that acts only from step to step: the medium, spatial tendons with their actuators (step_forces.cpp), and filters, which a
    // step of that size moves on. Returns how many boxes, tendons and filters there are.
    int add_forces(double stepsize);
    // What the medium exerts until the next step, of that size; 0: as if steps were infinitely small. Returns how many
    // boxes it acts on (fluid.h).
    int add_fluid_forces(double stepsize);

  private:
    void make(dWorldID world, dSpaceID space);
    void destroy();
    Robot(const Robot& like, int);  // all of it, handles too
    void make_bodies(dWorldID world);
    void make_still_bodies(dWorldID world);
    dBodyID carrier(int link, const Shape& shape) const;
    dJointID make_turn(dWorldID world, int number, dBodyID child, dBodyID parent) const;
    void set_turn_drive(int number);
    int add_lifts() const;
    // Of a link the model's world, where what carries the link has been moved by the program.
    Pose frame_of(int link) const;
    void make_shape(dSpaceID space, int link, const Shape& shape);
    void add_geom(dGeomID geom, int link, const Shape& shape);
    void set_pairs(dGeomID geom, const Shape& shape) const;
    void make_joints(dWorldID world);
    dJointID make_joint(dWorldID world, int number, dBodyID child, dBodyID parent, const Pose& frame);
    dBodyID make_small_body(dWorldID world, int link);
    void make_closure(dWorldID world, const Closure& closure);
    dJointID make_coupling(dWorldID world, const std::vector<Coupling::Term>& terms, double low, double high);
    void make_couplings(dWorldID world);
    void lay_tangents(const std::vector<double>& positions);
    int move_tangents();
    void exclude(dWorldID world, int link1, int link2);
    void keep_apart(dWorldID world, dBodyID one, dBodyID two);
    // What acts on a coordinate or on a tendon's sum.
    struct Passive {
        dJointID id;
        double reference, stiffness, rest, damping, armature, friction;
    };
    // step_forces.cpp
    bool is_filtered(size_t actuator) const;
    int move_filters(double stepsize);
    bool moves_path(const Actuator& actuator) const;  // of a spatial tendon
    int add_tendon_forces(double stepsize);
    // step_wrenches.cpp
    void wake_pushed(const Actuator& actuator) const;
    Stroke turn_stroke(const Actuator& actuator) const;
    Stroke wrench_stroke(const SiteWrench& wrench) const;
    double wrench_force(size_t actuator, double stepsize) const;
    int add_wrenches(double stepsize);
    int add_adhesion();
    int add_free_drag(double stepsize);  // free_drag.cpp
    static void adhere(dBodyID body, double force, const std::vector<dWorldContact>& contacts);
    struct Pull;  // of a spatial tendon
    std::vector<Pull> pulls(double stepsize) const;
    double rate_of(const Path& path) const;
    double stiffness(int tendon) const;
    double damping(int tendon) const;
    double force(const Pull& pull, double stepsize) const;
    double limited(const Pull& pull, double force, double stepsize) const;
    bool has_past(int tendon) const;  // a spatial one with friction or armature
    double drag(const Pull& pull, double stepsize);
    void set_limits_of(std::vector<Pull>& pulls, double stepsize) const;
    void act(const Path& path, double force) const;
    bool is_awake(const Tendon& tendon) const;
    // step_ties.cpp
    bool is_awake(const Tie& tie) const;
    int add_ties(double stepsize);
    void pull(int tendon, double force, const std::vector<Pose>& poses) const;
    void wake(const Tendon& tendon) const;
    Vec velocity_at(int link, Vec point) const;
    std::vector<Pose> link_poses() const;  // in the world
    void set_drive_of(const Actuator& actuator);
    // What a unit of the length and of its rate takes off an actuator's force at its present input.
    struct Slope {
        double position, velocity;
        bool is_servo() const { return position != 0 || velocity != 0; }
    };
    Slope slope_of(size_t actuator) const
    {
        const Actuator& a = model().actuators[actuator];
        return {a.bias_position - a.gain_position * inputs_[actuator],
                a.bias_velocity - a.gain_velocity * inputs_[actuator]};
    }
    double clamped_force(size_t actuator) const;  // without those two
    int move_muscles();
    void make_drives();
    bool can_be_control(size_t actuator, double value) const;
    bool is_state(const std::vector<double>& numbers) const;
    bool has_clock() const;
    void set_drives();
    // `largest`: of all motors together.
    void set_drive(const Passive& passive, const Servo& servo, double limit, double largest,
                   const std::vector<int>& actuators);
    void set_joint_drive(int joint);
    void set_tendon_drive(int tendon);
    void set_limits(int number, dJointID its) const;
    struct Small {
        dBodyID body;
        int link;
        size_t joints_before;
    };
    std::vector<double> held(const Small& small, std::vector<double> positions) const;
    // Of a link's body or a small one, given the link's pose and what the joints up to it do.
    struct Motion {  // of all links
        std::vector<Pose> poses;
        std::vector<LinkVelocity> velocities;
    };
    Motion motion_of(const std::vector<double>& positions, const std::vector<double>& velocities) const;
    void set_velocity(dBodyID body, int link, const Motion& motion) const;
    void place(dBodyID body, const Pose& link_pose, Vec centre) const;

    std::shared_ptr<const Prepared> prepared_;
    Pose placement_;
    std::vector<Pose> reference_;  // of links, in the world
    std::vector<dBodyID> bodies_, all_bodies_;
    std::vector<dJointID> joints_, turns_, tendons_, all_joints_, holders_;
    std::vector<dBodyID> still_;  // of RobotModel::still; empty where the world's link has a body
    std::vector<int> movers_;     // of links: the one that the program moves, on which they hang; 0: none
    dWorldID world_ = nullptr;
    std::vector<dGeomID> geoms_;
    std::vector<std::array<float, 3>> colors_;
    std::vector<Small> small_;
    std::vector<double> controls_, activations_;
    std::vector<double> inputs_;  // what acts: controls, or activations of filters
    bool filters_act_ = false;    // since add_forces or set_activation was called
    std::vector<double> pulls_;   // of muscles, what they exerted at the last call of add_forces
    std::vector<Servo> servos_;
    struct Past {  // of a tendon, at the last call of add_forces
        bool is_known = false;
        double rate = 0, inertia = 0;  // and the force of its armature
        double hold = 0;               // what its friction took to stop it
    };
    std::vector<Past> pasts_;  // of tendons
    struct Bent {              // a coupling that is no straight line
        int coupling;
        dJointID joint;
        Bend bend;
    };
    std::vector<Bent> bends_;
    std::vector<double> holds_;  // of ties, what it took to hold them
    std::vector<double>
        limits_;  // of tendons with a path, what their limits exerted at the last call of add_forces
    double time_ = 0;
};

}  // namespace epode::robots
