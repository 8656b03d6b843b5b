// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See construct.h.
#include "integrations/gazebo/construct.h"

#include <sdf/Box.hh>
#include <sdf/Capsule.hh>
#include <sdf/Cylinder.hh>
#include <sdf/Ellipsoid.hh>
#include <sdf/Geometry.hh>
#include <sdf/Plane.hh>
#include <sdf/Sphere.hh>

#include "integrations/gazebo/contact_filter.h"
#include "integrations/gazebo/links.h"
#include "integrations/gazebo/mesh_files.h"
#include "integrations/gazebo/sdf_read.h"
#include "integrations/gazebo/shapes.h"

namespace epode::gazebo {

namespace {

// A moving body of a file without inertial: SDF says 1 kg and 1 kg m^2.
dMass default_mass()
{
    dMass mass;
    dMassSetParameters(&mass, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0);
    return mass;
}

bool read_mass(const ::sdf::Link& from, dMass& mass)
{
    const auto& inertial = from.Inertial();
    const auto I = inertial.Moi();
    const double m = inertial.MassMatrix().Mass();
    bool is_good = m > 0 && std::isfinite(m) && inertial.Pose().IsFinite();
    for (unsigned i = 0; i < 3; ++i) is_good = is_good && I(i, i) > 0;
    if (is_good) dMassSetParameters(&mass, m, 0, 0, 0, I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2));
    if (is_good && dMassCheck(&mass)) return true;
    EPODE_GAZEBO_ERROR << "link '" << from.Name() << "' was refused: its mass (" << m
                       << " kg) and its moments must be positive, and finite\n";
    return false;
}

// False: a shape without a geom of its own.
bool read_geometry(const ::sdf::Geometry& from, Shape& shape)
{
    if (const auto* box = from.BoxShape()) {
        shape.kind = ShapeKind::kBox, shape.size = vec_of(box->Size());
    } else if (const auto* sphere = from.SphereShape()) {
        shape.kind = ShapeKind::kSphere, shape.size = {sphere->Radius(), 0, 0};
    } else if (const auto* cylinder = from.CylinderShape()) {
        shape.kind = ShapeKind::kCylinder, shape.size = {cylinder->Radius(), cylinder->Length(), 0};
    } else if (const auto* capsule = from.CapsuleShape()) {
        shape.kind = ShapeKind::kCapsule, shape.size = {capsule->Radius(), capsule->Length(), 0};
    } else if (const auto* ellipsoid = from.EllipsoidShape()) {
        shape.kind = ShapeKind::kEllipsoid, shape.size = vec_of(ellipsoid->Radii());
    } else if (const auto* plane = from.PlaneShape()) {
        shape.kind = ShapeKind::kPlane;
        shape.pose.q = shape.pose.q * robots::turn_of_z(vec_of(plane->Normal()));
    } else {
        return false;
    }
    return true;
}

}  // namespace

World::~World()
{
    if (!world) return;
    dWorldSetContactSpace(world, nullptr);
    dSpaceDestroy(space);
    dWorldDestroy(world);
}

World* Construct::add_world(const std::string& name)
{
    if (named(worlds_, name)) {
        EPODE_GAZEBO_ERROR << "world '" << name << "' was refused: there is one of that name\n";
        return nullptr;
    }
    const auto world = make<World>(name);
    world->world = dWorldCreate();
    world->space = dHashSpaceCreate(nullptr);
    dWorldUseDefaults(world->world, dDefaultsRobot);
    dWorldSetHybridStepper(world->world, dStepperHybrid);
    dWorldSetStepThreads(world->world, 0);
    // Loose bodies sleep as in games; those on joints do not (attach).
    dWorldSetAutoDisableLinearThreshold(world->world, 0.02);
    dWorldSetAutoDisableAngularThreshold(world->world, 0.02);
    dWorldSetAutoDisableSteps(world->world, 20);
    dWorldSetAutoDisableTime(world->world, 0.3);
    dWorldSetGravity(world->world, 0, 0, -9.8);
    dWorldSetContactSpace(world->world, world->space);
    dWorldSetContactFilter(world->world, may_touch, nullptr);
    worlds_.push_back(world);
    return world.get();
}

Model* Construct::add_model(World& world, Model* parent, const std::string& name, const Pose& pose)
{
    auto& siblings = parent ? parent->models : world.models;
    if (named(siblings, name)) {
        EPODE_GAZEBO_ERROR << "model '" << name << "' was refused: there is one of that name\n";
        return nullptr;
    }
    if (!is_finite(pose)) {
        EPODE_GAZEBO_ERROR << "model '" << name << "' was refused: its pose is not finite\n";
        return nullptr;
    }
    const auto model = make<Model>(name);
    model->world = &world, model->parent = parent, model->pose = pose;
    siblings.push_back(model);
    return model.get();
}

Link* Construct::add_link(Model& model, const std::string& name, const Pose& pose)
{
    if (named(model.links, name) || !is_finite(pose)) {
        EPODE_GAZEBO_ERROR << "link '" << name << "' of model '" << model.name
                           << "' was refused: there is one of that name, or its pose is not finite\n";
        return nullptr;
    }
    const auto link = make<Link>(name);
    link->model = &model, link->static_pose = pose;
    model.links.push_back(link);
    return link.get();
}

void Construct::add_body(Link& link, const dMass& mass)
{
    const Pose pose = link.static_pose;
    link.body = dBodyCreate(link.model->world->world);
    dBodySetData(link.body, &link);
    dBodySetMass(link.body, &mass);
    dBodySetAutoDisableFlag(link.body, link.model->may_sleep);
    place(link, pose);
}

Identity Construct::ConstructSdfWorld(const Identity&, const ::sdf::World& from)
{
    World* const world = add_world(from.Name());
    if (!world) return GenerateInvalidId();
    const auto gravity = from.Gravity();
    dWorldSetGravity(world->world, gravity.X(), gravity.Y(), gravity.Z());
    read_physics(from, *world);
    for (std::uint64_t i = 0; i < from.ModelCount(); ++i) read_model(*world, nullptr, *from.ModelByIndex(i));
    return identity_of(world);
}

Identity Construct::ConstructSdfModel(const Identity& world, const ::sdf::Model& model)
{
    World* const found = get<World>(world);
    return identity_of(found ? read_model(*found, nullptr, model) : nullptr);
}

Identity Construct::ConstructSdfNestedModel(const Identity& owner, const ::sdf::Model& model)
{
    if (World* const world = dynamic_cast<World*>(ReferenceInterface<Entity>(owner)))
        return identity_of(read_model(*world, nullptr, model));
    Model* const found = get<Model>(owner);
    return identity_of(found ? read_model(*found->world, found, model) : nullptr);
}

// The model's links and those in it stand at 0 of all joints.
Model* Construct::read_model(World& world, Model* parent, const ::sdf::Model& from)
{
    const Pose outer = parent ? motion_of(*parent).pose : Pose{};
    const Pose pose = outer * pose_in(from, "");
    Model* const model = add_model(world, parent, from.Name(), pose);
    if (!model) return nullptr;
    model->is_static = from.Static() || (parent && parent->is_static);
    model->collides_itself = from.SelfCollide();
    model->may_sleep = from.AllowAutoDisable();
    model->root_name = from.CanonicalLinkName();
    for (std::uint64_t i = 0; i < from.LinkCount(); ++i) read_link(*model, *from.LinkByIndex(i));
    for (std::uint64_t i = 0; i < from.ModelCount(); ++i) read_model(world, model, *from.ModelByIndex(i));
    for (std::uint64_t i = 0; i < from.JointCount(); ++i) read_joint(*model, *from.JointByIndex(i));
    settle_root(*model, pose);
    return model;
}

// The canonical link is the one that the file names, else the first, else that of the first model in it.
void Construct::settle_root(Model& model, const Pose& frame)
{
    Link* root = model.root_name.empty() ? nullptr : find_link(model, model.root_name);
    if (!root && !model.links.empty()) root = model.links[0].get();
    for (const auto& inner : model.models)
        if (!root) root = inner->root;
    model.root = root;
    if (root) model.in_root = inverse(pose_of(*root)) * frame;
    if (root && model.parent && !model.parent->root) settle_root(*model.parent, model.parent->pose);
}

Identity Construct::ConstructSdfLink(const Identity& model, const ::sdf::Link& link)
{
    Model* const found = get<Model>(model);
    if (!found) return GenerateInvalidId();
    const Pose frame = motion_of(*found).pose;
    Link* const made = read_link(*found, link);
    if (made && (!found->root || made->name == found->root_name)) settle_root(*found, frame);
    return identity_of(made);
}

Link* Construct::read_link(Model& model, const ::sdf::Link& from)
{
    dMass mass = default_mass();
    if (!model.is_static && !read_mass(from, mass)) return nullptr;
    Link* const link = add_link(model, from.Name(), motion_of(model).pose * pose_in(from, "__model__"));
    if (!link) return nullptr;
    link->centre = vec_of(from.Inertial().Pose().Pos());
    if (!model.is_static) add_body(*link, mass);
    for (std::uint64_t i = 0; i < from.CollisionCount(); ++i)
        ConstructSdfCollision(identity_of(link), *from.CollisionByIndex(i));
    return link;
}

Identity Construct::ConstructSdfCollision(const Identity& link, const ::sdf::Collision& from)
{
    Link* const found = get<Link>(link);
    if (!found || !from.Geom()) return GenerateInvalidId();
    const auto shape = new_shape(*found, from.Name(), ShapeKind::kBox, pose_in(from, ""));
    if (!shape) return GenerateInvalidId();
    read_surface(from, *shape);
    if (read_geometry(*from.Geom(), *shape)) return keep(shape, make_geoms(*shape));
    if (from.Geom()->MeshShape()) return keep(shape, read_mesh_file(*from.Geom()->MeshShape(), *shape));
    if (from.Geom()->HeightmapShape())
        return keep(shape, read_height_file(*from.Geom()->HeightmapShape(), *shape));
    EPODE_GAZEBO_ERROR << "collision '" << from.Name() << "' of link '" << found->name
                       << "': a kind of geometry that is none of box, sphere, cylinder, capsule, ellipsoid, "
                       << "plane, mesh and heightmap\n";
    return keep(shape, false);
}

std::shared_ptr<Shape> Construct::new_shape(Link& link, const std::string& name, ShapeKind kind,
                                            const Pose& pose)
{
    if (named(link.shapes, name) || !is_finite(pose)) {
        EPODE_GAZEBO_ERROR << "collision '" << name << "' of link '" << link.name
                           << "' was refused: there is one of that name, or its pose is not finite\n";
        return nullptr;
    }
    const auto shape = make<Shape>(name);
    shape->link = &link, shape->kind = kind, shape->pose = pose;
    dMaterialInit(&shape->material, sizeof shape->material);
    shape->material.friction = shape->material.cross_friction = 1;
    shape->material.friction_rule = dCombineMinimum;
    return shape;
}

Identity Construct::keep(const std::shared_ptr<Shape>& shape, bool is_made)
{
    if (is_made) {
        shape->link->shapes.push_back(shape);
        return identity_of(shape.get());
    }
    destroy_geoms(*shape);
    forget(*shape);
    return GenerateInvalidId();
}

Identity Construct::ConstructEmptyWorld(const Identity&, const std::string& name)
{
    return identity_of(add_world(name));
}
Identity Construct::ConstructEmptyModel(const Identity& world, const std::string& name)
{
    World* const found = get<World>(world);
    return identity_of(found ? add_model(*found, nullptr, name, {}) : nullptr);
}
Identity Construct::ConstructEmptyNestedModel(const Identity& model, const std::string& name)
{
    Model* const found = get<Model>(model);
    return identity_of(found ? add_model(*found->world, found, name, motion_of(*found).pose) : nullptr);
}
Identity Construct::ConstructEmptyLink(const Identity& model, const std::string& name)
{
    Model* const found = get<Model>(model);
    const Pose frame = found ? motion_of(*found).pose : Pose{};
    Link* const link = found ? add_link(*found, name, frame) : nullptr;
    if (!link) return GenerateInvalidId();
    if (!found->is_static) add_body(*link, default_mass());
    if (!found->root) settle_root(*found, frame);
    return identity_of(link);
}

}  // namespace epode::gazebo
