// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What acts only from step to step: forces of spatial tendons, and filters between controls and forces. With the length L of a tendon and
// its rate V, its force is, gear, gain and biases of its actuators being g, G, b0, bp, bv and their input u,
//     F = -k e - d V + sum g clamp(G u + b0 - bp g L - bv g V),    e: how far L is out of its range of rest,
// taken at the step's beginning. Alone it would move L by h^2 A F, with the inverse mass A = J M^-1 J'. A step of size h follows
// springs and dampers while h^2 A k and h A d are at most 1; of several tendons, while that holds of S = sum |A_ij|, row by row, which
// bounds the eigenvalues. Stiffer ones are as stiff as that, weaker ones are as they are.
// A limit is a force that takes L to it within the step, as far as it alone can tell: F <= (high - L - h V) / (h^2 S), and so with the
// lower one. Under a load that would accelerate L by a it gives way by a h^2.
#include <ode/ext.h>

#include <algorithm>
#include <numeric>

#include "robots/body_poses.h"
#include "robots/build.h"
#include "robots/mass_factor.h"
#include "robots/muscle.h"
#include "robots/wrench.h"

namespace epode::robots {

struct Robot::Pull {
    int tendon;
    Path path;
    double rate;
    double sum = 0, inverse = 0;  // S and A; 0: not needed
};

namespace {

double beyond(double value, double low, double high)
{
    return value > high ? value - high : value < low ? value - low : 0;
}

double share(double stiffness, double limit) { return stiffness > limit ? limit / stiffness : 1; }

// 1 - exp(-x), of x doubled from where the series is short: 1 - (1 - u)^2 = u (2 - u). The same bits everywhere.
double approached(double x)
{
    if (x > 40) return 1;
    const double y = x / 4096;
    double u = y * (1 - y / 2 * (1 - y / 3 * (1 - y / 4 * (1 - y / 5))));
    for (int i = 0; i < 12; ++i) u *= 2 - u;
    return u;
}

double moved(const Activation& filter, double act, double control, double h)
{
    const double time = std::max(filter.time, 1e-15);
    double out = act;
    switch (filter.kind) {
        case Activation::Kind::kNone:
            return control;
        case Activation::Kind::kIntegrator:
            out += h * control;
            break;
        case Activation::Kind::kFilter:
            out += std::min(1.0, h / time) * (control - act);
            break;
        case Activation::Kind::kExactFilter:
            out += approached(h / time) * (control - act);
            break;
        case Activation::Kind::kMuscle:
            out += h * muscle_rate(filter, act, control);
            break;
    }
    return std::clamp(out, filter.low, filter.high);
}

}  // namespace

bool Robot::is_filtered(size_t actuator) const
{
    return filters_act_ && model().actuators[actuator].filter.kind != Activation::Kind::kNone;
}

void Robot::set_drive_of(const Actuator& actuator)
{
    if (actuator.joint >= 0) set_joint_drive(actuator.joint);
    if (actuator.tendon >= 0) set_tendon_drive(actuator.tendon);
}

void Robot::set_control(int actuator, double value)
{
    const Actuator& its = model().actuators[size_t(actuator)];
    const double control = std::clamp(value, its.low, its.high);
    if (control != controls_[size_t(actuator)]) {
        if (its.tendon >= 0) wake(model().tendons[size_t(its.tendon)]);
        wake_pushed(its);
    }
    controls_[size_t(actuator)] = control;
    if (is_filtered(size_t(actuator))) return;
    inputs_[size_t(actuator)] = control;
    set_drive_of(its);
}

void Robot::set_activation(int actuator, double value)
{
    const Actuator& its = model().actuators[size_t(actuator)];
    if (its.filter.kind == Activation::Kind::kNone) return;
    filters_act_ = true;
    activations_[size_t(actuator)] = inputs_[size_t(actuator)] =
        std::clamp(value, its.filter.low, its.filter.high);
    set_drive_of(its);
}

// A drive holds what acts through the step; those that do not change are left, so that their bodies may sleep.
int Robot::move_filters(double h)
{
    int count = 0;
    filters_act_ = true;
    for (size_t i = 0; i < model().actuators.size(); ++i) {
        if (!is_filtered(i)) continue;
        const Actuator& its = model().actuators[i];
        const double now = activations_[i], next = moved(its.filter, now, controls_[i], h);
        const double acts = its.filter.is_early ? next : now;
        activations_[i] = next, ++count;
        if (acts == inputs_[i]) continue;
        inputs_[i] = acts;
        set_drive_of(its);
    }
    return count;
}

std::vector<Pose> Robot::link_poses() const
{
    std::vector<Pose> out;
    for (size_t i = 0; i < bodies_.size(); ++i)
        out.push_back(bodies_[i] ? pose_of(bodies_[i]) * Pose{-model().links[i].centre, {}} : placement_);
    return out;
}

Vec Robot::velocity_at(int link, Vec point) const
{
    const dBodyID its = body(link);
    if (!its) return {};
    const Vec arm = point - vec_of(dBodyGetPosition(its));
    return vec_of(dBodyGetLinearVel(its)) + cross(vec_of(dBodyGetAngularVel(its)), arm);
}

bool Robot::is_awake(const Tendon& tendon) const
{
    return std::any_of(tendon.path.begin(), tendon.path.end(), [&](const PathPart& part) {
        const dBodyID its = body(part.link);
        return its && dBodyIsEnabled(its) && !dBodyIsKinematic(its);
    });
}

void Robot::wake(const Tendon& tendon) const
{
    for (const PathPart& part : tendon.path)
        if (const dBodyID its = body(part.link)) dBodyEnable(its);
}

double Robot::stiffness(int tendon) const
{
    double sum = model().tendons[size_t(tendon)].stiffness;
    for (int i : prepared_->actuators_of_tendon(tendon)) {
        const double gear = model().actuators[size_t(i)].gear;
        sum += gear * gear * std::max(0.0, slope_of(size_t(i)).position);
    }
    return sum;
}

double Robot::damping(int tendon) const
{
    double sum = model().tendons[size_t(tendon)].damping;
    for (int i : prepared_->actuators_of_tendon(tendon)) {
        const double gear = model().actuators[size_t(i)].gear;
        sum += gear * gear * std::max(0.0, slope_of(size_t(i)).velocity);
    }
    return sum;
}

double Robot::force(const Pull& pull, double h) const
{
    const Tendon& tendon = model().tendons[size_t(pull.tendon)];
    const double length = pull.path.length, limit = pull.sum > 0 ? 1 / (h * pull.sum) : kInfinity;
    const double stiff = share(stiffness(pull.tendon), limit / h), damp = share(damping(pull.tendon), limit);
    const auto& rest = prepared_->rests()[size_t(pull.tendon)];
    double out =
        -stiff * tendon.stiffness * beyond(length, rest[0], rest[1]) - damp * tendon.damping * pull.rate;
    for (int i : prepared_->actuators_of_tendon(pull.tendon)) {
        const Actuator& a = model().actuators[size_t(i)];
        const double input = inputs_[size_t(i)];
        const Slope slope = slope_of(size_t(i));
        const double steady = a.muscle.acts
                                  ? muscle_force(a.muscle, input, a.gear * length, a.gear * pull.rate)
                                  : a.gain * input + a.bias - slope.position * a.gear * length;
        const double its = (slope.position > 0 ? stiff * steady : steady) -
                           (slope.velocity > 0 ? damp : 1) * slope.velocity * a.gear * pull.rate;
        out += a.gear * std::clamp(its, a.force_low, a.force_high);
    }
    return out;
}

double Robot::limited(const Pull& pull, double force, double h) const
{
    if (!(pull.sum > 0)) return force;
    const Tendon& tendon = model().tendons[size_t(pull.tendon)];
    const double limit = 1 / (h * h * pull.sum), next = pull.path.length + h * pull.rate;
    return std::max(std::min(force, limit * (tendon.high - next)), limit * (tendon.low - next));
}

bool Robot::has_past(int tendon) const
{
    const Tendon& its = model().tendons[size_t(tendon)];
    return !its.path.empty() && (its.friction > 0 || its.armature > 0);
}

// Armature b and dry friction. The mass matrix has b, and with it A. What b exerts is -b L'', which the step itself does not know: without
// b the tendon would have been accelerated by L'' - A0 B in the step before, with the force B of b in it and the inverse mass
// A0 = A / (1 - b A) without b, and is now; so B = -b ((1 - b A) L'' - A B), exact but for what else changes within a step.
// Friction stops the tendon, V = h A F, and remembers what that took, so that it holds a load without creep.
double Robot::drag(const Pull& pull, double h)
{
    if (!has_past(pull.tendon) || !(pull.inverse > 0)) return 0;
    const Tendon& tendon = model().tendons[size_t(pull.tendon)];
    const double b = tendon.armature, largest = tendon.friction, inverse = pull.inverse;
    Past& past = pasts_[size_t(pull.tendon)];
    const double acceleration = past.is_known ? (pull.rate - past.rate) / h : 0;
    const double inertia =
        past.is_known ? -b * ((1 - b * inverse) * acceleration - inverse * past.inertia) : 0;
    const double stop = pull.rate / (h * pull.sum);
    past.hold = std::clamp(past.hold - stop, -largest, largest);
    past.rate = pull.rate, past.inertia = inertia, past.is_known = true;
    return inertia + std::clamp(past.hold - stop, -largest, largest);
}

// S of those that need it.
void Robot::set_limits_of(std::vector<Pull>& pulls, double h) const
{
    std::vector<Pull*> stiff;
    std::vector<int> numbers;
    for (Pull& pull : pulls) {
        const Tendon& tendon = model().tendons[size_t(pull.tendon)];
        const bool is_held = beyond(pull.path.length + h * pull.rate, tendon.low, tendon.high) != 0;
        if (!is_held && !has_past(pull.tendon) && stiffness(pull.tendon) <= 0 && damping(pull.tendon) <= 0)
            continue;
        stiff.push_back(&pull), numbers.push_back(pull.tendon);
    }
    if (stiff.empty()) return;
    const std::vector<double> q = positions();
    const MassFactor masses(model(), q);
    if (!masses.is_good()) return;
    const std::vector<double> moments = tendon_moments(model(), q, numbers);
    std::vector<std::vector<double>> halves;
    for (size_t i = 0; i < stiff.size(); ++i) halves.push_back(masses.halfway(&moments[i * masses.size()]));
    const auto product = [&](size_t i, size_t k) {
        return std::inner_product(halves[k].begin(), halves[k].end(), halves[i].begin(), 0.0);
    };
    for (size_t i = 0; i < stiff.size(); ++i) {
        stiff[i]->inverse = product(i, i);
        for (size_t k = 0; k < stiff.size(); ++k) stiff[i]->sum += std::fabs(product(i, k));
    }
}

double Robot::rate_of(const Path& path) const
{
    double rate = 0;
    for (const Piece& piece : path.pieces)
        rate += dot(piece.direction, velocity_at(piece.link2, piece.p2) - velocity_at(piece.link1, piece.p1));
    return rate;
}

Robot::Stroke Robot::joint_stroke(int joint) const
{
    const dJointID its = joints_[size_t(joint)];
    return {double(dJointGetAxisPosition(its, 0)) + model().joints[size_t(joint)].reference,
            double(dJointGetAxisRate(its, 0))};
}

Robot::Stroke Robot::tendon_stroke(int number) const
{
    const Tendon& tendon = model().tendons[size_t(number)];
    Stroke out{0, 0};
    for (const Coupling::Term& term : tendon.terms) {
        const Stroke its = joint_stroke(term.joint);
        out.length += term.factor * its.length, out.rate += term.factor * its.rate;
    }
    if (tendon.path.empty()) return out;
    const Path path = path_of(tendon, link_poses());
    return {path.length, rate_of(path)};
}

// Of an actuator of a ball: of the rotation vector along its direction.
Robot::Stroke Robot::turn_stroke(const Actuator& actuator) const
{
    Stroke out{0, 0};
    for (int axis = 0; axis < 3; ++axis) {
        const dJointID its = turns_[size_t(actuator.joint)];
        out.length += actuator.direction[axis] * double(dJointGetAxisPosition(its, axis));
        out.rate += actuator.direction[axis] * double(dJointGetAxisRate(its, axis));
    }
    return out;
}

Robot::Stroke Robot::stroke(int actuator) const
{
    const Actuator& a = model().actuators[size_t(actuator)];
    if (a.wrench.link >= 0) return wrench_stroke(a.wrench);
    if (a.adhesive_link >= 0) return {0, 0};
    const Stroke its = a.joint < 0               ? tendon_stroke(a.tendon)
                       : turns_[size_t(a.joint)] ? turn_stroke(a)
                                                 : joint_stroke(a.joint);
    return {a.gear * its.length, a.gear * its.rate};
}

double Robot::actuator_force(int actuator) const
{
    const Actuator& a = model().actuators[size_t(actuator)];
    const Stroke its = stroke(actuator);
    const double input = inputs_[size_t(actuator)];
    const Slope slope = slope_of(size_t(actuator));
    const double force =
        a.muscle.acts ? muscle_force(a.muscle, input, its.length, its.rate)
                      : a.gain * input + a.bias - slope.position * its.length - slope.velocity * its.rate;
    return std::clamp(force, a.force_low, a.force_high);
}

double Robot::actuators_force(int joint) const
{
    const double largest = model().joints[size_t(joint)].max_force;
    const size_t column = size_t(velocity_of(model(), joint));
    double sum = 0;
    for (size_t i = 0; i < model().actuators.size(); ++i) {
        const Actuator& a = model().actuators[i];
        if (a.joint >= 0 ? a.joint != joint : a.adhesive_link >= 0) continue;
        const double arm = a.joint >= 0 ? 1
                           : a.wrench.link >= 0
                               ? wrench_moments(model(), positions(), a.wrench)[column]
                               : tendon_moments(model(), positions(), std::array{a.tendon})[column];
        if (arm != 0) sum += arm * a.gear * actuator_force(int(i));
    }
    return largest > 0 ? std::clamp(sum, -largest, largest) : sum;
}

// Before their gears, as MuJoCo's sensor has it.
double Robot::actuators_force_of_tendon(int tendon) const
{
    double sum = 0;
    for (size_t i = 0; i < model().actuators.size(); ++i)
        if (model().actuators[i].tendon == tendon) sum += actuator_force(int(i));
    return sum;
}

double Robot::joint_limit_force(int joint) const
{
    const dJointID turn = turns_[size_t(joint)], its = turn ? turn : joints_[size_t(joint)];
    return its && model().joints[size_t(joint)].limited ? std::fabs(double(dJointGetStopForce(its, 0))) : 0;
}

double Robot::tendon_limit_force(int tendon) const
{
    const dJointID its = tendons_[size_t(tendon)];
    return its ? std::fabs(double(dJointGetStopForce(its, 0))) : limits_[size_t(tendon)];
}

// Of the spatial tendons of which something moves.
std::vector<Robot::Pull> Robot::pulls(double h) const
{
    std::vector<Pull> out;
    std::vector<Pose> poses;
    for (size_t i = 0; i < model().tendons.size(); ++i) {
        const Tendon& tendon = model().tendons[i];
        if (tendon.path.empty() || !is_awake(tendon)) continue;
        if (poses.empty()) poses = link_poses();
        Pull pull{int(i), path_of(tendon, poses), 0};
        pull.rate = rate_of(pull.path);
        out.push_back(std::move(pull));
    }
    set_limits_of(out, h);
    return out;
}

void Robot::act(const Path& path, double force) const
{
    const auto pull = [&](int link, Vec point, Vec its) {
        const dBodyID to = body(link);
        if (!to || !dBodyIsEnabled(to) || dBodyIsKinematic(to)) return;
        add_force(to, its, cross(point - vec_of(dBodyGetPosition(to)), its));
    };
    for (const Piece& piece : path.pieces) {
        pull(piece.link1, piece.p1, -force * piece.direction);
        pull(piece.link2, piece.p2, force * piece.direction);
    }
}

int Robot::add_tendon_forces(double h)
{
    const std::vector<Pull> all = pulls(h);
    for (const Pull& pull : all) {
        const double free = force(pull, h), held = limited(pull, free, h);
        limits_[size_t(pull.tendon)] = std::fabs(held - free);
        act(pull.path, held + drag(pull, h));
    }
    return int(all.size());
}

bool Robot::moves_path(const Actuator& a) const
{
    return a.tendon >= 0 && !model().tendons[size_t(a.tendon)].path.empty();
}

// Those of joints and sums of coordinates, whose drives hold what they exert through the step.
int Robot::move_muscles()
{
    int count = 0;
    for (size_t i = 0; i < model().actuators.size(); ++i) {
        const Actuator& a = model().actuators[i];
        if (!a.muscle.acts || moves_path(a)) continue;
        const Stroke its = stroke(int(i));
        pulls_[i] = muscle_force(a.muscle, inputs_[i], its.length, its.rate);
        set_drive_of(a), ++count;
    }
    return count;
}

int Robot::add_forces(double h)
{
    const int filters = move_filters(h);
    move_muscles();
    return filters + move_tangents() + add_tendon_forces(h) + add_ties(h) + add_wrenches(h) + add_adhesion() +
           add_free_drag(h) + add_fluid_forces(h) + add_lifts();
}

}  // namespace epode::robots
