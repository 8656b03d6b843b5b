// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors that the file names (robots/sensors.h has those of worlds). Of the state: joints, actuators, frames, seen from the world or from
// another frame. Of the last step, where it began, with the accelerations a = S vdot that it gave: with A of a link as without them,
//     accelerometer at p:  A.v + A.w x p + w x (V.v + w x p),    A <- A + a, which counts gravity as an acceleration upwards
//     force on the parent: f - I A - V x* I V of the link and all that hangs on it, f being contacts' and loops', less what a medium takes
//     touch:               the normal forces of the link's contacts
//     limits:              the forces of their rows, 0 or more
#pragma once

#include "batch/lanes/medium.h"
#include "batch/lanes/observe.h"

namespace epode::batch {
namespace {

template <typename P, bool own>
struct Sensors {
    using T = typename P::Number;
    const Observe<P, own>& of;
    const P* accelerations;
    P* out;

    struct Seen {  // a frame in the world
        Vec3Of<P> at;
        Vec4Of<P> q;
        Mat3Of<P> r;
        Vec3Of<P> linear, angular;
    };

    void find() const
    {
        Motion<P, own>{model(), numbers(), of.q, of.v, work()}.find();
        of.find_actuators();
        bool any_of_step = false;
        for (const BatchSensor& sensor : model().sensors) {
            any_of_step |= is_of_step(sensor);
            if (sensor.values > 0 && !is_of_step(sensor)) read_state(sensor, out + sensor.address);
        }
        find_centres();
        if (any_of_step) find_step();
        for (const BatchSensor& sensor : model().sensors) {
            if (is_of_step(sensor)) read_step(sensor, out + sensor.address);
            if (sensor.high > 0) cut(sensor, out + sensor.address);
        }
    }

    static bool is_of_step(const BatchSensor& sensor)
    {
        const bool is_limit =
            sensor.kind == SensorKind::kLimitForce || sensor.kind == SensorKind::kTendonLimitForce;
        return sensor.values > 0 && (is_limit || sensor.kind >= SensorKind::kAccelerometer);
    }

    static void cut(const BatchSensor& sensor, P* to)
    {
        for (int k = 0; k < sensor.values; ++k) to[k] = clip(to[k], P(T(sensor.low)), P(T(sensor.high)));
    }

    const ModelView& model() const { return of.model; }
    Numbers<P, own> numbers() const { return of.numbers; }
    Work<P>& work() const { return of.work; }
    const LinkWork<P>& link(int number) const { return work().link[number]; }

    // From O of the link's tree, and about it.
    Vec3Of<P> place(int number, int first) const
    {
        return link(number).p + link(number).r * numbers().vec(first);
    }

    Seen seen(int number, int first) const
    {
        const LinkWork<P>& its = link(number);
        const Vec3Of<P> at = place(number, first);
        const Vec4Of<P> q = its.q * numbers().quat(first + 3);
        const int tree = number == 0 ? model().trees : model().links[number].tree;
        return {at + work().origin[tree], q, matrix_of(q), its.velocity.v + cross(its.velocity.w, at),
                its.velocity.w};
    }

    // As that frame sees it, which moves itself.
    static Seen seen_from(const Seen& from, const Seen& its)
    {
        const Vec3Of<P> apart = its.at - from.at, carried = from.linear + cross(from.angular, apart);
        const Vec4Of<P> q = Vec4Of<P>{from.q.w, -from.q.x, -from.q.y, -from.q.z} * its.q;
        return {transposed_times(from.r, apart), q, matrix_of(q),
                transposed_times(from.r, its.linear - carried),
                transposed_times(from.r, its.angular - from.angular)};
    }

    void read_state(const BatchSensor& sensor, P* to) const
    {
        if (sensor.kind == SensorKind::kPosition || sensor.kind == SensorKind::kVelocity) {
            const P* from = (sensor.kind == SensorKind::kPosition ? of.q : of.v) + sensor.object;
            for (int k = 0; k < sensor.values; ++k) to[k] = from[k];
        } else if (sensor.kind <= SensorKind::kLimitRate) {
            const Dof& dof = model().dofs[sensor.object];
            to[0] = beyond(of.q[model().joints[dof.joint].position], of.v[sensor.object],
                           numbers()[dof.first + dof_number::kLow], numbers()[dof.first + dof_number::kHigh],
                           sensor.kind == SensorKind::kLimitRate);
        } else if (sensor.kind == SensorKind::kJointForce) {
            to[0] = of.out[of.to().actuator + sensor.object];
        } else if (sensor.kind <= SensorKind::kActuatorRate) {
            to[0] = of_actuator(sensor.kind, sensor.object);
        } else if (sensor.kind <= SensorKind::kTendonLimitRate) {
            to[0] = of_tendon(sensor.kind, model().sums[sensor.object]);
        } else if (sensor.kind <= SensorKind::kPotential) {
            to[0] = sensor.kind == SensorKind::kKinetic ? kinetic() : potential();
        } else if (sensor.kind < SensorKind::kCentre) {
            read_frame(sensor, to);
        }
    }

    // How far below its least or above its largest, less than 0, or how fast that changes; 0 between the two.
    static P beyond(const P& at, const P& rate, const P& low, const P& high, bool is_rate)
    {
        const P zero(0), below = is_rate ? rate : at - low, above = is_rate ? -rate : high - at;
        return if_greater(low, at, below, if_greater(at, high, above, zero));
    }

    P of_tendon(SensorKind kind, const BatchSum& sum) const
    {
        const P length = of.drives(of.q, 0).length_of(sum), rate = of.sums().rate(sum);
        if (kind == SensorKind::kTendonLength) return length;
        if (kind == SensorKind::kTendonRate) return rate;
        return beyond(length, rate, numbers()[sum.first + sum_number::kLow],
                      numbers()[sum.first + sum_number::kHigh], kind == SensorKind::kTendonLimitRate);
    }

    P kinetic() const
    {
        P sum(0);
        for (int i = 1; i < model().links.size(); ++i)
            sum = sum + dot(link(i).velocity, link(i).inertia * link(i).velocity);
        for (int i = 0; i < model().velocities; ++i)
            sum = sum + numbers()[model().dofs[i].first + dof_number::kArmature] * (of.v[i] * of.v[i]);
        return P(T(0.5)) * sum;
    }

    P potential() const
    {
        const P half(T(0.5));
        P sum(0);
        for (int i = 1; i < model().links.size(); ++i) {
            if (model().links[i].is_weightless) continue;
            const Inertia<P>& its = link(i).inertia;
            sum = sum -
                  dot(numbers().vec(model().gravity), its.h + its.m * work().origin[model().links[i].tree]);
        }
        for (const Dof& dof : model().dofs) {
            if (!dof.is_scalar) continue;
            const P e = of.q[model().joints[dof.joint].position] - numbers()[dof.first + dof_number::kRest];
            sum = sum + half * numbers()[dof.first + dof_number::kStiffness] * (e * e);
        }
        for (const BatchSum& its : model().sums) {
            const P e = of.drives(of.q, 0).length_of(its) - numbers()[its.first + sum_number::kRest];
            sum = sum + half * numbers()[its.first + sum_number::kStiffness] * (e * e);
        }
        return sum;
    }

    P of_actuator(SensorKind kind, int number) const
    {
        const BatchActuator& a = model().actuators[number];
        const auto its = [&](int which) { return numbers()[a.first + which]; };
        const P gear = its(actuator_number::kGear);
        P length, rate;
        if (a.sum >= 0)
            length = of.drives(of.q, 0).length_of(model().sums[a.sum]),
            rate = of.sums().rate(model().sums[a.sum]);
        else
            length = of.q[a.position], rate = of.v[a.dof];
        if (kind == SensorKind::kActuatorLength) return gear * length;
        if (kind == SensorKind::kActuatorRate) return gear * rate;
        const P u = of.drives(of.q, of.options.h).input(a, of.control[number]);
        const P force = its(actuator_number::kGain) * u + its(actuator_number::kBias) -
                        its(actuator_number::kBiasPosition) * (gear * length) -
                        its(actuator_number::kBiasVelocity) * (gear * rate);
        return clip(force, its(actuator_number::kForceLow), its(actuator_number::kForceHigh));
    }

    void read_frame(const BatchSensor& sensor, P* to) const
    {
        Seen its = seen(sensor.link, sensor.first);
        if (sensor.kind == SensorKind::kGyro) return put(to, transposed_times(its.r, its.angular));
        if (sensor.kind == SensorKind::kVelocimeter) return put(to, transposed_times(its.r, its.linear));
        if (sensor.kind == SensorKind::kMagnetometer)
            return put(to, transposed_times(its.r, numbers().vec(sensor.reference_first)));
        if (sensor.reference >= 0) its = seen_from(seen(sensor.reference, sensor.reference_first), its);
        const Mat3Of<P>& r = its.r;
        switch (sensor.kind) {
            case SensorKind::kPlace:
                return put(to, its.at);
            case SensorKind::kTurn:
                return void((to[0] = its.q.w, to[1] = its.q.x, to[2] = its.q.y, to[3] = its.q.z));
            case SensorKind::kAxisX:
                return put(to, Vec3Of<P>{r.row0.x, r.row1.x, r.row2.x});
            case SensorKind::kAxisY:
                return put(to, Vec3Of<P>{r.row0.y, r.row1.y, r.row2.y});
            case SensorKind::kAxisZ:
                return put(to, Vec3Of<P>{r.row0.z, r.row1.z, r.row2.z});
            case SensorKind::kLinear:
                return put(to, its.linear);
            default:
                return put(to, its.angular);
        }
    }

    // Of subtrees: the centre of mass h / m, its velocity, of the momentum, which forces of links become, and the angular momentum about it.
    void find_centres() const
    {
        bool any = false;
        for (const BatchSensor& sensor : model().sensors) any |= is_of_subtree(sensor);
        if (!any) return;
        for (int i = 1; i < model().links.size(); ++i)
            work().link[i].force = link(i).inertia * link(i).velocity;
        gather_subtrees(model(), work());
        for (const BatchSensor& sensor : model().sensors) {
            if (!is_of_subtree(sensor)) continue;
            const bool is_place = sensor.kind == SensorKind::kCentre;
            const Subtree its = subtree(sensor.link);
            const Vec3Of<P> mean = inverse_or_zero(its.m) * (is_place ? its.at : its.momentum);
            const bool is_turn = sensor.kind == SensorKind::kMomentum;
            put(out + sensor.address, is_turn ? its.angular - cross(its.at, mean) : mean);
        }
    }

    static bool is_of_subtree(const BatchSensor& sensor)
    {
        return sensor.values > 0 && sensor.kind >= SensorKind::kCentre &&
               sensor.kind <= SensorKind::kMomentum;
    }

    struct Subtree {
        P m;
        Vec3Of<P> at, momentum, angular;  // m times the centre's place; about the world's origin
    };

    // All links hang on the world.
    Subtree subtree(int number) const
    {
        const P zero(0);
        Subtree sum{zero, {zero, zero, zero}, {zero, zero, zero}, {zero, zero, zero}};
        for (int i = 1; i < model().links.size(); ++i) {
            if (number == 0 ? model().links[i].parent != 0 : i != number) continue;
            const LinkWork<P>& its = link(i);
            sum.m = sum.m + its.inertia.m, sum.momentum = sum.momentum + its.force.v;
            const Vec3Of<P> origin = work().origin[model().links[i].tree];
            sum.at = sum.at + its.inertia.h + its.inertia.m * origin;
            sum.angular = sum.angular + its.force.w + cross(origin, its.force.v);
        }
        return sum;
    }

    // Forces of links: what they have exerted on their parents.
    void find_step() const
    {
        const P zero(0);
        Motion<P, own>{model(), numbers(), of.before, of.before_v, work()}.find();
        if (model().boxes.size() > 0) Medium<P, own>{model(), numbers(), P(T(of.options.h)), work()}.find();
        for (int i = 1; i < model().links.size(); ++i) {
            LinkWork<P>& its = work().link[i];
            const Spatial<P> a = model().accelerations > 0
                                     ? accelerated(i)
                                     : Spatial<P>{{zero, zero, zero}, {zero, zero, zero}};
            its.acceleration = its.acceleration + a;
            its.force = P(-1) * (its.force + its.inertia * a);
        }
        of.add_forces();
        gather_subtrees(model(), work());
    }

    Spatial<P> accelerated(int number) const
    {
        const P zero(0);
        Spatial<P> sum{{zero, zero, zero}, {zero, zero, zero}};
        const int last = model().links[number].last_dof;
        if (last < 0) return sum;
        const Dof& dof = model().dofs[last];
        for (int k = 0; k <= dof.depth; ++k) {
            const int at = model().chains[dof.chain + k];
            sum = sum + accelerations[at] * work().s[at];
        }
        return sum;
    }

    void read_step(const BatchSensor& sensor, P* to) const
    {
        const LinkWork<P>& its = link(sensor.link);
        if (sensor.kind < SensorKind::kAccelerometer) return void(to[0] = limit_force(sensor));
        if (sensor.kind == SensorKind::kTouch) return void(to[0] = touching(sensor.link));
        const Vec3Of<P> p = place(sensor.link, sensor.first);
        const Mat3Of<P> r = matrix_of(its.q * numbers().quat(sensor.first + 3));
        if (sensor.kind == SensorKind::kTurningAcceleration) return put(to, its.acceleration.w);
        if (sensor.kind <= SensorKind::kLinearAcceleration) {
            const Spatial<P>&a = its.acceleration, &v = its.velocity;
            const Vec3Of<P> at = a.v + cross(a.w, p) + cross(v.w, v.v + cross(v.w, p));
            const bool is_own = sensor.kind == SensorKind::kAccelerometer;
            return put(to, is_own ? transposed_times(r, at) : at);
        }
        const P sign(sensor.is_on_child ? -1 : 1), zero(0);
        if (sensor.link == 0) return put(to, {zero, zero, zero});
        const bool is_force = sensor.kind == SensorKind::kForce;
        const Vec3Of<P> about = is_force ? its.force.v : its.force.w - cross(p, its.force.v);
        put(to, sign * transposed_times(r, about));
    }

    P limit_force(const BatchSensor& sensor) const
    {
        if (sensor.kind == SensorKind::kTendonLimitForce) {
            const int stop = model().sums[sensor.object].stop;
            return stop < 0 ? P(0) : of.forces[model().first_sum() + stop];
        }
        const int limit = model().dofs[sensor.object].limit;
        return limit < 0 ? P(0) : of.forces[3 * model().slots + limit];
    }

    P touching(int number) const
    {
        P sum(0);
        for (const BatchPair& pair : model().pairs) {
            if (model().shapes[pair.shape_a].link != number && model().shapes[pair.shape_b].link != number)
                continue;
            for (int k = 0; k < pair.slots; ++k) sum = sum + of.forces[3 * (pair.first_slot + k)];
        }
        return sum;
    }
};

}  // namespace
}  // namespace epode::batch
