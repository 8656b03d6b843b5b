// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What a host builds: worlds, models, links, joints and shapes, as a tree of plain data around the objects of the library. Hosts keep
// references to entities: a removed one stays in memory, marked, until nobody refers to it.
// A link's frame is that of its file; its body has the same axes and its origin in the centre of mass. Links of static models have no
// body: joints hold their other link to the world. A joint's frame is that of the file in both of its links:
//     X_child = X_parent from_parent J(q) to_child.
#pragma once

#include <ode/ext.h>
#include <ode/ode.h>

#include <array>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "robots/geometry.h"

namespace epode::gazebo {

using robots::Pose;
using robots::Vec;

struct World;
struct Model;
struct Link;

struct Entity {
    std::size_t id = 0;
    std::string name;
    bool is_removed = false;
    Entity() = default;
    virtual ~Entity() = default;
    Entity(const Entity&) = delete;
    Entity& operator=(const Entity&) = delete;
};

enum class ShapeKind { kBox, kSphere, kCylinder, kCapsule, kEllipsoid, kPlane, kMesh, kHeightmap };

struct Shape : Entity {
    ~Shape() override;
    Link* link = nullptr;
    ShapeKind kind = ShapeKind::kBox;
    Pose pose;                   // in the link's frame; of a plane z is its normal
    Vec size;                    // sides; radius and length; radii; of a mesh its extents without scale
    Vec scale{1, 1, 1};          // of a mesh
    Vec low, high;               // of a mesh and a height map: the box around it
    std::vector<dGeomID> geoms;  // of a mesh several, or none
    dMaterial material{};
    std::uint16_t mask = 0xffff;
    dHeightfieldDataID heights = nullptr;
    dTriMeshDataID triangles = nullptr;
    std::vector<double> corners;
    std::vector<dTriIndex> indices;
};

enum class JointKind { kRevolute, kPrismatic, kFixed, kUniversal, kRevolute2, kBall, kScrew };

struct Joint : Entity {
    static constexpr std::size_t kMaxAxes = 3;
    Model* model = nullptr;
    JointKind kind = JointKind::kFixed;
    Link *parent = nullptr, *child = nullptr;  // parent null: the world
    Pose from_parent, to_child;
    std::array<Vec, 2> axes{};  // in the joint's frame; of a ball none
    double pitch = 0;           // of a screw: m per rad
    dJointID joint = nullptr;
    dJointID helper = nullptr;  // of a screw what couples turn and way, of a ball its motor
    std::vector<dJointID> mimics;
    dJointFeedback feedback{};
    struct Axis {
        double low = -HUGE_VAL, high = HUGE_VAL;  // rad or m
        double min_velocity = -HUGE_VAL, max_velocity = HUGE_VAL;
        double min_effort = -HUGE_VAL, max_effort = HUGE_VAL;
        double stiffness = 0, spring_reference = 0, damping = 0, friction = 0;
        double force = 0;    // for the next step
        double exerted = 0;  // in the last one
        bool is_velocity_commanded = false;
        double last_velocity = 0, acceleration = 0;
    };
    std::array<Axis, kMaxAxes> axis{};
};

// A mimic joint as its file describes it: position = multiplier (leader's position - reference) + offset.
struct Mimic {
    std::weak_ptr<Joint> follower;
    std::size_t follower_axis = 0, leader_axis = 0;
    std::string leader;
    double multiplier = 1, offset = 0, reference = 0;
};

// What a host moves as one: the links of a model, or those that joints connect to a link, unless the world holds them.
struct FreeGroup : Entity {
    Model* model = nullptr;  // null: of the link alone
    Link* link = nullptr;
};

struct Link : Entity {
    Model* model = nullptr;
    dBodyID body = nullptr;  // null of a static model's
    Pose static_pose;        // of a link without a body
    Vec centre;              // of mass, in the link's frame
    std::vector<std::shared_ptr<Shape>> shapes;
    std::vector<Joint*> joints;  // at either end
    std::shared_ptr<FreeGroup> group;
    bool is_published = false;
    Pose published;                 // pose that the host knows
    Vec last_linear, last_angular;  // velocities before the last step, of the centre
    Vec linear_acceleration, angular_acceleration;
};

struct Model : Entity {
    World* world = nullptr;
    Model* parent = nullptr;  // of a nested one
    Pose pose;                // in the world when it was made
    Link* root = nullptr;     // canonical link
    std::string root_name;    // of it, where the file names one
    Pose in_root;             // the model's frame in that link's
    bool is_static = false, collides_itself = false, may_sleep = true;
    std::vector<std::shared_ptr<Link>> links;
    std::vector<std::shared_ptr<Joint>> joints;
    std::vector<std::shared_ptr<Model>> models;
    std::shared_ptr<FreeGroup> group;
    std::vector<Mimic> waiting;  // for leaders that are not there yet
};

struct World : Entity {
    ~World() override;
    dWorldID world = nullptr;
    dSpaceID space = nullptr;
    std::vector<std::shared_ptr<Model>> models;
    std::string solver = "hybrid", detector = "epode";
};

}  // namespace epode::gazebo
