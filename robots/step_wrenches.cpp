// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What actuators of sites and adhesive ones add before a step. Servos of sites are as stiff as steps can follow, as spatial tendons are
// (step_forces.cpp). An adhesive one pulls its link and what it touches together: its force in equal parts at all points of contact of
// the last step, along their normals, as MuJoCo has it.
#include <ode/ext.h>

#include <algorithm>

#include "robots/body_poses.h"
#include "robots/build.h"
#include "robots/mass_factor.h"
#include "robots/wrench.h"

namespace epode::robots {

namespace {

void push_body(dBodyID body, Vec point, Vec force, Vec torque)
{
    if (!body || !dBodyIsEnabled(body) || dBodyIsKinematic(body)) return;
    add_force(body, force, torque + cross(point - vec_of(dBodyGetPosition(body)), force));
}

}  // namespace

// Links are woken by what pushes them.
void Robot::wake_pushed(const Actuator& actuator) const
{
    for (int link : {actuator.wrench.link, actuator.wrench.reference_link, actuator.adhesive_link})
        if (const dBodyID its = link >= 0 ? body(link) : nullptr) dBodyEnable(its);
}

Robot::Stroke Robot::wrench_stroke(const SiteWrench& wrench) const
{
    const std::vector<Pose> poses = link_poses();
    double rate = 0;
    for (const LinkLoad& its : loads_of(model(), wrench, poses)) {
        const dBodyID on = body(its.link);
        rate += dot(its.force, velocity_at(its.link, its.point));
        if (on) rate += dot(its.torque, vec_of(dBodyGetAngularVel(on)));
    }
    return {length_of(wrench, poses), rate};
}

// Of what it would exert, what steps of size h can follow.
double Robot::wrench_force(size_t number, double h) const
{
    const Actuator& a = model().actuators[number];
    const Slope slope = slope_of(number);
    if (slope.position <= 0 && slope.velocity <= 0) return actuator_force(int(number));
    const std::vector<double> q = positions();
    const MassFactor masses(model(), q);
    if (!masses.is_good()) return 0;
    const double inverse = masses.inverse_mass(wrench_moments(model(), q, a.wrench).data());
    const double limit = inverse > 0 ? 1 / (h * inverse) : kInfinity;
    const auto share = [](double its, double largest) { return its > largest ? largest / its : 1; };
    const Stroke its = stroke(int(number));
    const double steady = a.gain * inputs_[number] + a.bias - slope.position * its.length;
    const double stiff = slope.position > 0 ? share(slope.position, limit / h) : 1,
                 damp = slope.velocity > 0 ? share(slope.velocity, limit) : 1;
    return std::clamp(stiff * steady - damp * slope.velocity * its.rate, a.force_low, a.force_high);
}

int Robot::add_wrenches(double h)
{
    int count = 0;
    std::vector<Pose> poses;
    for (size_t i = 0; i < model().actuators.size(); ++i) {
        const Actuator& a = model().actuators[i];
        if (a.wrench.link < 0) continue;
        if (poses.empty()) poses = link_poses();
        const double force = wrench_force(i, h);
        for (const LinkLoad& its : loads_of(model(), a.wrench, poses))
            push_body(body(its.link), its.point, force * its.force, force * its.torque);
        ++count;
    }
    return count;
}

int Robot::add_adhesion()
{
    const auto adheres = [](const Actuator& a) { return a.adhesive_link >= 0; };
    if (std::none_of(model().actuators.begin(), model().actuators.end(), adheres)) return 0;
    std::vector<dWorldContact> contacts(size_t(std::max(0, dWorldGetContacts(world_, nullptr, 0))));
    dWorldGetContacts(world_, contacts.data(), int(contacts.size()));
    int count = 0;
    for (size_t i = 0; i < model().actuators.size(); ++i) {
        const Actuator& a = model().actuators[i];
        if (adheres(a)) adhere(body(a.adhesive_link), actuator_force(int(i)), contacts), ++count;
    }
    return count;
}

// The normal leads into g1.
void Robot::adhere(dBodyID its, double force, const std::vector<dWorldContact>& contacts)
{
    std::vector<const dWorldContact*> touching;
    for (const dWorldContact& contact : contacts)
        if (contact.g1 && contact.g2 && (dGeomGetBody(contact.g1) == its || dGeomGetBody(contact.g2) == its))
            touching.push_back(&contact);
    if (touching.empty() || force == 0 || !its) return;
    const double share = force / double(touching.size());
    for (const dWorldContact* contact : touching) {
        const Vec at = vec_of(contact->pos), pull = -share * vec_of(contact->normal);
        push_body(dGeomGetBody(contact->g1), at, pull, {});
        push_body(dGeomGetBody(contact->g2), at, -pull, {});
    }
}

}  // namespace epode::robots
