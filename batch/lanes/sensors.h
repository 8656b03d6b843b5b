// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Sensors that the file names (robots/sensors.h has those of worlds). Of the state: joints, actuators, frames, seen from the world or from
// another frame. Of the last step, where it began, with the accelerations a = S vdot that it gave: with A of a link as without them,
//     accelerometer at p:  A.v + A.w x p + w x (V.v + w x p),    A <- A + a, which counts gravity as an acceleration upwards
//     force on the parent: f - I A - V x* I V of the link and all that hangs on it, f being contacts' and loops', less what a medium takes
//     touch:               the normal forces of the link's contacts
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
        bool any_of_step = false;
        Motion<P, own>{model(), numbers(), of.q, of.v, work()}.find();
        of.find_actuators();
        for (const BatchSensor& sensor : model().sensors) {
            const bool is_of_step = sensor.kind >= SensorKind::kAccelerometer;
            any_of_step |= sensor.values > 0 && is_of_step;
            if (sensor.values > 0 && !is_of_step) read_state(sensor, out + sensor.address);
        }
        find_centres();
        if (!any_of_step) return;
        find_step();
        for (const BatchSensor& sensor : model().sensors)
            if (sensor.values > 0 && sensor.kind >= SensorKind::kAccelerometer)
                read_step(sensor, out + sensor.address);
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
        } else if (sensor.kind == SensorKind::kJointForce) {
            to[0] = of.out[of.to().actuator + sensor.object];
        } else if (sensor.kind <= SensorKind::kActuatorRate) {
            to[0] = of_actuator(sensor.kind, sensor.object);
        } else if (sensor.kind < SensorKind::kCentre) {
            read_frame(sensor, to);
        }
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

    // Of subtrees: the centre of mass h / m and its velocity, of the momentum, which forces of links become.
    void find_centres() const
    {
        bool any = false;
        for (const BatchSensor& sensor : model().sensors)
            any |= sensor.values > 0 &&
                   (sensor.kind == SensorKind::kCentre || sensor.kind == SensorKind::kCentreVelocity);
        if (!any) return;
        for (int i = 1; i < model().links.size(); ++i)
            work().link[i].force = link(i).inertia * link(i).velocity;
        gather_subtrees(model(), work());
        for (const BatchSensor& sensor : model().sensors) {
            const bool is_place = sensor.kind == SensorKind::kCentre;
            if (sensor.values == 0 || !(is_place || sensor.kind == SensorKind::kCentreVelocity)) continue;
            const Subtree its = subtree(sensor.link);
            put(out + sensor.address, inverse_or_zero(its.m) * (is_place ? its.at : its.momentum));
        }
    }

    struct Subtree {
        P m;
        Vec3Of<P> at, momentum;  // m times the centre's place
    };

    // All links hang on the world.
    Subtree subtree(int number) const
    {
        const P zero(0);
        Subtree sum{zero, {zero, zero, zero}, {zero, zero, zero}};
        for (int i = 1; i < model().links.size(); ++i) {
            if (number == 0 ? model().links[i].parent != 0 : i != number) continue;
            const LinkWork<P>& its = link(i);
            sum.m = sum.m + its.inertia.m, sum.momentum = sum.momentum + its.force.v;
            sum.at = sum.at + its.inertia.h + its.inertia.m * work().origin[model().links[i].tree];
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
        if (sensor.kind == SensorKind::kTouch) return void(to[0] = touching(sensor.link));
        const Vec3Of<P> p = place(sensor.link, sensor.first);
        const Mat3Of<P> r = matrix_of(its.q * numbers().quat(sensor.first + 3));
        if (sensor.kind == SensorKind::kAccelerometer) {
            const Spatial<P>&a = its.acceleration, &v = its.velocity;
            const Vec3Of<P> at = a.v + cross(a.w, p) + cross(v.w, v.v + cross(v.w, p));
            return put(to, transposed_times(r, at));
        }
        const P sign(sensor.is_on_child ? -1 : 1), zero(0);
        if (sensor.link == 0) return put(to, {zero, zero, zero});
        const bool is_force = sensor.kind == SensorKind::kForce;
        const Vec3Of<P> about = is_force ? its.force.v : its.force.w - cross(p, its.force.v);
        put(to, sign * transposed_times(r, about));
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
