// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

dMass mass_of(dBodyID body)
{
    dMass mass;
    dBodyGetMass(body, &mass);
    return mass;
}

// About its centre, in the world's axes, if the body was turned like this.
Vec own_angular_momentum(dBodyID body, Turn q)
{
    const dMass mass = mass_of(body);
    const Vec w = rotate(inverse(q), spin(body));
    const dVector3 local = {dReal(w.x), dReal(w.y), dReal(w.z)};
    dVector3 turned;
    dMultiply0_331(turned, mass.I, local);
    return rotate(q, vec(turned));
}

}  // namespace

std::vector<dBodyID> bodies_of(dWorldID world)
{
    std::vector<dBodyID> bodies(size_t(dWorldGetBodies(world, nullptr, 0)));
    dWorldGetBodies(world, bodies.data(), int(bodies.size()));
    return bodies;
}

double kinetic_energy(dBodyID body)
{
    return 0.5 * mass_of(body).mass * dot(velocity(body), velocity(body)) +
           0.5 * dot(spin(body), own_angular_momentum(body, orientation(body)));
}

double kinetic_energy(const Stage& stage)
{
    double sum = 0;
    for (dBodyID body : bodies_of(stage.world)) sum += kinetic_energy(body);
    return sum;
}

double potential_energy(const Stage& stage)
{
    dVector3 gravity;
    dWorldGetGravity(stage.world, gravity);
    double sum = 0;
    for (dBodyID body : bodies_of(stage.world)) sum -= mass_of(body).mass * dot(vec(gravity), position(body));
    return sum;
}

Vec momentum(const Stage& stage)
{
    Vec sum;
    for (dBodyID body : bodies_of(stage.world)) sum = sum + double(mass_of(body).mass) * velocity(body);
    return sum;
}

Vec angular_momentum(dBodyID body) { return angular_momentum(body, position(body), orientation(body)); }

Vec angular_momentum(dBodyID body, Vec at, Turn q)
{
    return own_angular_momentum(body, q) + double(mass_of(body).mass) * cross(at, velocity(body));
}

Vec angular_momentum(const Stage& stage)
{
    Vec sum;
    for (dBodyID body : bodies_of(stage.world)) sum = sum + angular_momentum(body);
    return sum;
}

double total_mass(const Stage& stage)
{
    double sum = 0;
    for (dBodyID body : bodies_of(stage.world)) sum += mass_of(body).mass;
    return sum;
}

double gap(dJointID joint)
{
    dVector3 a, b;
    if (dJointGetType(joint) == dJointTypeBall) {
        dJointGetBallAnchor(joint, a);
        dJointGetBallAnchor2(joint, b);
    } else {
        dJointGetHingeAnchor(joint, a);
        dJointGetHingeAnchor2(joint, b);
    }
    return length(vec(a) - vec(b));
}

double degrees_between(Vec a, Vec b) { return degrees(std::atan2(length(cross(a, b)), dot(a, b))); }

}  // namespace epode::trials
