// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See simulation.h.
#include "integrations/gazebo/simulation.h"

#include <chrono>

#include "integrations/gazebo/contact_filter.h"
#include "integrations/gazebo/convert.h"
#include "integrations/gazebo/joints.h"
#include "integrations/gazebo/links.h"

namespace epode::gazebo {

namespace {

constexpr double kDefaultStep = 0.001;
constexpr double kMaxStep = 1;  // s

double step_of(const gz::physics::ForwardStep::Input& input)
{
    if (const auto* duration = input.Query<std::chrono::steady_clock::duration>())
        return std::chrono::duration<double>(*duration).count();
    if (const auto* step = input.Query<gz::physics::TimeStep>()) return step->dt;
    return kDefaultStep;
}

template <class Function>
void for_each_model(const std::vector<std::shared_ptr<Model>>& models, const Function& function)
{
    for (const auto& model : models) function(*model), for_each_model(model->models, function);
}

void remember(Link& link)
{
    if (!link.body) return;
    link.last_linear = vec_of(dBodyGetLinearVel(link.body));
    link.last_angular = vec_of(dBodyGetAngularVel(link.body));
}

void differentiate(Link& link, double step)
{
    if (!link.body) return;
    link.linear_acceleration = (1 / step) * (vec_of(dBodyGetLinearVel(link.body)) - link.last_linear);
    link.angular_acceleration = (1 / step) * (vec_of(dBodyGetAngularVel(link.body)) - link.last_angular);
}

void remember(Joint& joint)
{
    for (std::size_t i = 0; i < degrees_of(joint); ++i) joint.axis[i].last_velocity = velocity_of(joint, i);
}

// Forces are for one step.
void finish(Joint& joint, double step)
{
    for (std::size_t i = 0; i < degrees_of(joint); ++i) {
        Joint::Axis& its = joint.axis[i];
        its.acceleration = (velocity_of(joint, i) - its.last_velocity) / step;
        its.exerted = exerted_force(joint, i);
        if (its.force != 0) its.force = 0, put_drive(joint, i);
    }
}

bool is_same(const Pose& a, const Pose& b)
{
    return a.p.x == b.p.x && a.p.y == b.p.y && a.p.z == b.p.z && a.q.w == b.q.w && a.q.x == b.q.x &&
           a.q.y == b.q.y && a.q.z == b.q.z;
}

void publish(Link& link, gz::physics::WorldPoses& all, gz::physics::ChangedWorldPoses& changed)
{
    const Pose pose = pose_of(link);
    const gz::physics::WorldPose entry{math_of(pose), link.id};
    all.entries.push_back(entry);
    if (link.is_published && is_same(pose, link.published)) return;
    link.is_published = true, link.published = pose;
    changed.entries.push_back(entry);
}

void set_rough(dManifold& manifold,
               const gz::physics::SetContactPropertiesCallbackFeature::ContactSurfaceParams<
                   gz::physics::FeaturePolicy3d>& to)
{
    if (to.frictionCoeff) manifold.friction = *to.frictionCoeff;
    if (to.secondaryFrictionCoeff) manifold.cross_friction = *to.secondaryFrictionCoeff;
    if (to.rollingFrictionCoeff) manifold.rolling_friction = *to.rollingFrictionCoeff;
    if (to.restitutionCoeff) manifold.bounce = *to.restitutionCoeff;
    for (int i = 0; i < 3; ++i) {
        if (to.firstFrictionalDirection) manifold.friction_axis[i] = (*to.firstFrictionalDirection)[i];
        if (to.contactSurfaceMotionVelocity)
            manifold.surface_velocity[i] = (*to.contactSurfaceMotionVelocity)[i];
    }
}

}  // namespace

void Simulation::WorldForwardStep(const Identity& world, gz::physics::ForwardStep::Output& output,
                                  gz::physics::ForwardStep::State&,
                                  const gz::physics::ForwardStep::Input& input)
{
    World* const found = get<World>(world);
    if (!found) return;
    const double step = step_of(input);
    if (!(step > 0 && step <= kMaxStep)) {
        EPODE_GAZEBO_ERROR << "a step of " << step << " s was refused: 0 < step <= 1 is wanted\n";
        return;
    }
    for_each_model(found->models, [](Model& model) {
        for (const auto& link : model.links) remember(*link);
        for (const auto& joint : model.joints) remember(*joint);
    });
    dWorldStepHybrid(found->world, step);
    auto& all = output.Get<gz::physics::WorldPoses>();
    auto& changed = output.Get<gz::physics::ChangedWorldPoses>();
    all.entries.clear(), changed.entries.clear();
    for_each_model(found->models, [&](Model& model) {
        for (const auto& link : model.links) differentiate(*link, step), publish(*link, all, changed);
        for (const auto& joint : model.joints) finish(*joint, step);
    });
}

// Those that exert a force, or overlap.
std::vector<Simulation::ContactInternal> Simulation::GetContactsFromLastStep(const Identity& world) const
{
    const World* const found = get<World>(world);
    if (!found) return {};
    std::vector<dWorldContact> contacts(std::size_t(dWorldGetContacts(found->world, nullptr, 0)));
    dWorldGetContacts(found->world, contacts.data(), int(contacts.size()));
    std::vector<ContactInternal> out;
    for (const dWorldContact& contact : contacts) {
        if (!contact.g1 || !contact.g2 || (contact.normal_force <= 0 && contact.depth < 0)) continue;
        gz::physics::CompositeData more;
        auto& extra = more.Get<ExtraContactData>();
        const Vec normal = vec_of(contact.normal);
        extra.force = eigen_of(contact.normal_force * normal + vec_of(contact.friction_force));
        extra.normal = eigen_of(normal), extra.depth = contact.depth;
        out.push_back({identity_of(shape_of(contact.g1)), identity_of(shape_of(contact.g2)),
                       eigen_of(vec_of(contact.pos)), more});
    }
    return out;
}

void Simulation::AddContactPropertiesCallback(const Identity& world, const std::string& name,
                                              SurfaceParamsCallback callback)
{
    World* const found = get<World>(world);
    if (!found) return;
    Callbacks& callbacks = callbacks_[found];
    callbacks.simulation = this;
    callbacks.functions[name] = std::move(callback);
    dWorldSetManifoldFunction(found->world, see_manifold, &callbacks, 0);
}

bool Simulation::RemoveContactPropertiesCallback(const Identity& world, const std::string& name)
{
    World* const found = get<World>(world);
    const auto its = callbacks_.find(found);
    if (!found || its == callbacks_.end() || its->second.functions.erase(name) == 0) return false;
    if (its->second.functions.empty()) dWorldSetManifoldFunction(found->world, nullptr, nullptr, 0);
    return true;
}

void Simulation::see_manifold(void* data, dManifold* manifold)
{
    const auto* const callbacks = static_cast<const Callbacks*>(data);
    callbacks->simulation->apply(*callbacks, *manifold);
}

void Simulation::apply(const Callbacks& callbacks, dManifold& manifold) const
{
    int deepest = 0;
    for (int i = 1; i < manifold.count; ++i)
        if (manifold.depth[i] > manifold.depth[deepest]) deepest = i;
    gz::physics::CompositeData more;
    auto& extra = more.Get<ExtraContactData>();
    extra.force = Eigen::Vector3d::Zero(), extra.normal = eigen_of(vec_of(manifold.normal));
    extra.depth = manifold.depth[deepest];
    const ContactInternal contact{identity_of(shape_of(manifold.g1)), identity_of(shape_of(manifold.g2)),
                                  eigen_of(vec_of(manifold.pos[deepest])), more};
    gz::physics::SetContactPropertiesCallbackFeature::ContactSurfaceParams<gz::physics::FeaturePolicy3d> to;
    to.frictionCoeff = manifold.friction, to.restitutionCoeff = manifold.bounce;
    for (const auto& [name, function] : callbacks.functions)
        if (function) function(contact, std::size_t(manifold.count), to);
    set_rough(manifold, to);
}

}  // namespace epode::gazebo
