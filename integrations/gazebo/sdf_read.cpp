// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See sdf_read.h. docs/guide/gz_sim.md has the table of what is honoured.
#include "integrations/gazebo/sdf_read.h"

#include <sdf/Physics.hh>
#include <sdf/Surface.hh>

#include "integrations/gazebo/world_options.h"

namespace epode::gazebo {

namespace {

void read_friction(const ::sdf::ElementPtr& surface, Shape& shape)
{
    dMaterial& material = shape.material;
    if (const auto ode = element_at(surface, {"friction", "ode"})) {
        material.friction = std::max(0.0, number_in(ode, "mu", 1));
        material.cross_friction = std::max(0.0, number_in(ode, "mu2", 1));
        if (ode->HasElement("fdir1")) {
            const Vec along = vec_of(ode->Get<gz::math::Vector3d>("fdir1"));
            const Vec in_shape = rotate(conjugate(shape.pose.q), along);
            if (robots::is_finite(along))
                for (int i = 0; i < 3; ++i) material.friction_axis[i] = in_shape[i];
        }
    }
}

// A file that does not say from which speed on things bounce lets them bounce.
void read_bounce(const ::sdf::ElementPtr& surface, dMaterial& material)
{
    const auto bounce = element_at(surface, {"bounce"});
    if (!bounce) return;
    material.bounce = std::clamp(number_in(bounce, "restitution_coefficient", 0), 0.0, 1.0);
    material.bounce_speed =
        bounce->HasElement("threshold") ? std::max(0.0, number_in(bounce, "threshold", 0)) : 0.01;
}

// Softness at a point; kp and kd of the two geoms are springs in series.
void read_contact(const ::sdf::ElementPtr& surface, dMaterial& material)
{
    const auto ode = element_at(surface, {"contact", "ode"});
    if (!ode || !ode->HasElement("kp")) return;
    const double stiffness = number_in(ode, "kp", 0), damping = number_in(ode, "kd", 1);
    if (!(stiffness > 0)) return;
    material.compliance = 1 / stiffness;
    material.damping_time = std::max(0.0, damping) / stiffness;
}

}  // namespace

::sdf::ElementPtr element_at(::sdf::ElementPtr from, std::initializer_list<const char*> path)
{
    for (const char* name : path) {
        if (!from || !from->HasElement(name)) return nullptr;
        from = from->GetElement(name);
    }
    return from;
}

double number_in(const ::sdf::ElementPtr& element, const char* name, double value)
{
    if (!element || !element->HasElement(name)) return value;
    const double its = element->Get<double>(name);
    return std::isfinite(its) ? its : value;
}

void read_surface(const ::sdf::Collision& collision, Shape& shape)
{
    dMaterialInit(&shape.material, sizeof shape.material);
    shape.material.friction = shape.material.cross_friction = 1;
    shape.material.friction_rule = dCombineMinimum;
    const ::sdf::ElementPtr surface = element_at(collision.Element(), {"surface"});
    read_friction(surface, shape);
    read_bounce(surface, shape.material);
    read_contact(surface, shape.material);
    if (collision.Surface() && collision.Surface()->Contact())
        shape.mask = collision.Surface()->Contact()->CollideBitmask();
}

void read_physics(const ::sdf::World& from, World& world)
{
    const ::sdf::Physics* const physics = from.PhysicsDefault();
    const ::sdf::ElementPtr ode = physics ? element_at(physics->Element(), {"ode"}) : nullptr;
    if (!ode) return;
    if (const auto solver = element_at(ode, {"solver"})) {
        if (solver->HasElement("type")) choose_solver(world, solver->Get<std::string>("type"));
        const int sweeps = int(number_in(solver, "iters", 0));
        if (sweeps > 0) dWorldSetQuickStepNumIterations(world.world, sweeps);
        if (solver->HasElement("sor")) dWorldSetQuickStepW(world.world, number_in(solver, "sor", 1.3));
    }
    const auto constraints = element_at(ode, {"constraints"});
    if (!constraints) return;
    if (constraints->HasElement("cfm")) dWorldSetCFM(world.world, number_in(constraints, "cfm", 0));
    if (constraints->HasElement("erp")) dWorldSetERP(world.world, number_in(constraints, "erp", 0.2));
    if (constraints->HasElement("contact_max_correcting_vel"))
        dWorldSetContactMaxCorrectingVel(world.world,
                                         number_in(constraints, "contact_max_correcting_vel", 1));
    if (constraints->HasElement("contact_surface_layer"))
        dWorldSetContactSurfaceLayer(world.world, number_in(constraints, "contact_surface_layer", 0));
}

}  // namespace epode::gazebo
