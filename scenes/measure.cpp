// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See measure.h. A kinematic body has a mass on paper only and is left out of energy and momentum; a body
// without gravity has no potential.
#include "scenes/measure.h"

#include <algorithm>
#include <cmath>

#include "scenes/build.h"
#include "scenes/extensions.h"

namespace epode::scenes {

namespace {

void store(double out[3], Vec v) { out[0] = v.x, out[1] = v.y, out[2] = v.z; }

Vec rows_times(const dReal* m, Vec v)
{
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
            m[8] * v.x + m[9] * v.y + m[10] * v.z};
}

Vec columns_times(const dReal* m, Vec v)
{
    return {m[0] * v.x + m[4] * v.y + m[8] * v.z, m[1] * v.x + m[5] * v.y + m[9] * v.z,
            m[2] * v.x + m[6] * v.y + m[10] * v.z};
}

Vec gravity_of(dWorldID world)
{
    dVector3 g;
    dWorldGetGravity(world, g);
    return vec(g);
}

// R I R^T w: angular momentum of the body about its own centre.
Vec own_spin(dBodyID body, const dMass& mass)
{
    const dReal* rotation = dBodyGetRotation(body);
    const Vec local = columns_times(rotation, vec(dBodyGetAngularVel(body)));
    return rows_times(rotation, rows_times(mass.I, local));
}

using GetAnchor = void (*)(dJointID, dVector3);

Vec anchor_gap(dJointID joint, GetAnchor first, GetAnchor second)
{
    dVector3 a, b;
    first(joint, a);
    second(joint, b);
    return vec(a) - vec(b);
}

Vec without(Vec v, Vec unit) { return v - dot(v, unit) * unit; }

// How far body 2 has moved, seen from body 1, since the joint was made.
Vec moved(const JointRecord& record)
{
    dBodyID body1 = dJointGetBody(record.joint, 0), body2 = dJointGetBody(record.joint, 1);
    if (!body1) return {};
    dVector3 expected;
    dBodyGetRelPointPos(body1, dReal(record.reference[0]), dReal(record.reference[1]),
                        dReal(record.reference[2]), expected);
    return (body2 ? vec(dBodyGetPosition(body2)) : Vec{}) - vec(expected);
}

bool finite(const dReal* v, int count)
{
    return std::all_of(v, v + count, [](dReal x) { return std::isfinite(x); });
}

bool finite(dBodyID body)
{
    return finite(dBodyGetPosition(body), 3) && finite(dBodyGetQuaternion(body), 4) &&
           finite(dBodyGetLinearVel(body), 3) && finite(dBodyGetAngularVel(body), 3);
}

void add_motion(const Scene& scene, Quality& quality)
{
    const Vec gravity = gravity_of(scene.world());
    Vec momentum, spin, moment;
    for (dBodyID body : scene.bodies()) {
        if (dBodyIsKinematic(body)) continue;
        dMass mass;
        dBodyGetMass(body, &mass);
        const Vec pos = vec(dBodyGetPosition(body)), vel = vec(dBodyGetLinearVel(body));
        const Vec own = own_spin(body, mass), orbit = cross(pos, mass.mass * vel);
        quality.kinetic += 0.5 * mass.mass * dot(vel, vel) + 0.5 * dot(vec(dBodyGetAngularVel(body)), own);
        if (dBodyGetGravityMode(body)) quality.potential -= mass.mass * dot(gravity, pos);
        quality.mass += mass.mass;
        quality.momentum_scale += mass.mass * length(vel);
        quality.spin_scale += length(own) + length(orbit);
        quality.max_speed = std::max(quality.max_speed, length(vel));
        momentum = momentum + mass.mass * vel;
        moment = moment + mass.mass * pos;
        spin = spin + own + orbit;
    }
    // L about the centre c: L - c x p.
    if (quality.mass > 0) spin = spin - cross((1 / quality.mass) * moment, momentum);
    store(quality.momentum, momentum);
    store(quality.spin, spin);
}

}  // namespace

double penetration(const Scene& scene)
{
    double worst = 0;
    for (const ContactRecord& contact : scene.contacts()) worst = std::max(worst, contact.depth);
    return worst;
}

double joint_error(const JointRecord& record)
{
    dJointID joint = record.joint;
    dVector3 axis;
    switch (dJointGetType(joint)) {
        case dJointTypeBall:
            return length(anchor_gap(joint, dJointGetBallAnchor, dJointGetBallAnchor2));
        case dJointTypeHinge:
            return length(anchor_gap(joint, dJointGetHingeAnchor, dJointGetHingeAnchor2));
        case dJointTypeUniversal:
            return length(anchor_gap(joint, dJointGetUniversalAnchor, dJointGetUniversalAnchor2));
        case dJointTypeHinge2:
            dJointGetHinge2Axis1(joint, axis);
            return length(
                without(anchor_gap(joint, dJointGetHinge2Anchor, dJointGetHinge2Anchor2), vec(axis)));
        case dJointTypeSlider:
            dJointGetSliderAxis(joint, axis);
            return length(without(moved(record), vec(axis)));
        case dJointTypeFixed:
            return length(moved(record));
        default:
            return 0;
    }
}

double worst_joint_error(const Scene& scene)
{
    double worst = 0;
    for (const JointRecord& record : scene.joints()) worst = std::max(worst, joint_error(record));
    return worst;
}

int bodies_not_finite(const Scene& scene)
{
    const auto& bodies = scene.bodies();
    return int(std::count_if(bodies.begin(), bodies.end(), [](dBodyID body) { return !finite(body); }));
}

Quality measure(const Scene& scene)
{
    Quality quality;
    quality.penetration = penetration(scene);
    quality.joint_error = worst_joint_error(scene);
    quality.not_finite = bodies_not_finite(scene);
    add_motion(scene, quality);
    return quality;
}

RunRecord::RunRecord(const Scene& scene) : first(measure(scene)), last(first), touching(scene)
{
    has_residual = request_step_report(scene.world(), true);
    energy_scale = first.kinetic;
}

Quality RunRecord::observe(const Scene& scene)
{
    last = measure(scene);
    touching.observe(scene);
    ++steps;
    times.push_back(scene.times());
    contacts_sum += double(scene.contacts().size());
    contacts_max = std::max(contacts_max, scene.contacts().size());
    penetration = std::max(penetration, last.penetration);
    joint_error = std::max(joint_error, last.joint_error);
    max_speed = std::max(max_speed, last.max_speed);
    not_finite = std::max(not_finite, last.not_finite);

    energy_scale = std::max({energy_scale, last.kinetic, std::abs(last.potential - first.potential),
                             std::abs(last.energy() - first.energy())});
    energy_peak_rise = std::max(energy_peak_rise, last.energy() - first.energy());
    const Vec impulse = (last.mass * scene.time()) * gravity_of(scene.world());
    momentum_drift = std::max(momentum_drift, length(vec(last.momentum) - vec(first.momentum) - impulse));
    spin_drift = std::max(spin_drift, length(vec(last.spin) - vec(first.spin)));
    momentum_scale = std::max(momentum_scale, last.momentum_scale);
    spin_scale = std::max(spin_scale, last.spin_scale);

    if (const auto report = has_residual ? step_report(scene.world()) : std::nullopt) {
        last_residual = report->residual;
        residual = std::max(residual, report->residual);
        fallbacks += report->fallbacks;
        contained_islands += report->contained_islands;
        rows_max = std::max(rows_max, report->rows);
    }
    return last;
}

double quantile(std::vector<double> values, double part)
{
    if (values.empty()) return 0;
    const auto nth = values.begin() + std::ptrdiff_t(part * double(values.size() - 1) + 0.5);
    std::nth_element(values.begin(), nth, values.end());
    return *nth;
}

}  // namespace epode::scenes
