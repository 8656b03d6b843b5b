// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See mechanism.h. The order of drawing is bodies, tree, loops and duplicates, touching.
#include "mechanism.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <utility>

#include "joints.h"

namespace epode::mechanisms {
namespace {

using parity::Quat;
using parity::Random;
using parity::Vec3;

Vec3 vec(const dReal* p) { return {double(p[0]), double(p[1]), double(p[2])}; }
Vec3 minus(const Vec3& a, const Vec3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
double length(const Vec3& a) { return std::sqrt(a.x * a.x + a.y * a.y + a.z * a.z); }

// Principal moments of a real body: b + c, c + a, a + b of second moments a, b, c; turned by a random
// rotation.
void draw_mass(Random& random, dBodyID body, double total)
{
    const double radius = random.range(0.05, 0.5);
    const double second[3] = {log_uniform(random, 0.01, 1), log_uniform(random, 0.01, 1), 1};
    const double unit = total * radius * radius / 2;
    const double principal[3] = {unit * (second[1] + second[2]), unit * (second[2] + second[0]),
                                 unit * (second[0] + second[1])};
    const Quat q = random.rotation(3);
    const Vec3 axis[3] = {rotate(q, {1, 0, 0}), rotate(q, {0, 1, 0}), rotate(q, {0, 0, 1})};
    double I[6] = {};  // xx yy zz xy xz yz
    for (int k = 0; k < 3; ++k) {
        const Vec3& n = axis[k];
        const double products[6] = {n.x * n.x, n.y * n.y, n.z * n.z, n.x * n.y, n.x * n.z, n.y * n.z};
        for (int i = 0; i < 6; ++i) I[i] += principal[k] * products[i];
    }
    dMass m;
    dMassSetParameters(&m, dReal(total), 0, 0, 0, dReal(I[0]), dReal(I[1]), dReal(I[2]), dReal(I[3]),
                       dReal(I[4]), dReal(I[5]));
    dBodySetMass(body, &m);
}

void turn(Random& random, dBodyID body)
{
    const Quat q = random.rotation(3);
    const dQuaternion given = {dReal(q.w), dReal(q.x), dReal(q.y), dReal(q.z)};
    dBodySetQuaternion(body, given);
}

}  // namespace

Mechanism::Mechanism(int number, const Limits& limits, std::vector<bool> without)
    : world(dWorldCreate()),
      random_("mechanism " + std::to_string(number)),
      kinds_(number < kAllJoints ? kFirstKinds : kKinds),
      without_(std::move(without)),
      contacts_(dJointGroupCreate(0))
{
    h = log_uniform(random_, 1.0 / 1000, 1.0 / 30);
    erp = random_.range(0, 0.8);
    const double softness = log_uniform(random_, 1e-10, 1e-3);
    const int kind = random_.below(5);  // as it comes, ODE's own, none
    cfm = kind == 0 && limits.zero_cfm ? 0 : kind <= 1 ? 1e-10 : softness;
    dWorldSetERP(world, dReal(erp));
    dWorldSetCFM(world, dReal(cfm));
    const Vec3 g = random_.in_cube(5);
    if (random_.unit() < 0.7)
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
    else
        dWorldSetGravity(world, dReal(g.x), dReal(g.y), dReal(g.z));
    add_bodies(limits);
    add_joints();
    add_touching();
}

Mechanism::~Mechanism()
{
    dJointGroupDestroy(contacts_);
    dWorldDestroy(world);
}

void Mechanism::add_bodies(const Limits& limits)
{
    const int count = limits.least_bodies + random_.below(limits.most_bodies - limits.least_bodies + 1);
    const double half_side = 0.5 * std::cbrt(double(count));
    for (int i = 0; i < count; ++i) {
        const dBodyID body = dBodyCreate(world);
        bodies.push_back(body);
        mass.push_back(log_uniform(random_, 1e-3, 1e3));
        draw_mass(random_, body, mass.back());
        flat_.push_back(random_.unit() < 0.05);
        const Vec3 p = random_.in_cube(half_side), v = random_.in_cube(1), w = random_.in_cube(2);
        dBodySetPosition(body, dReal(p.x), dReal(p.y), flat_.back() ? 0 : dReal(p.z));
        turn(random_, body);
        dBodySetLinearVel(body, dReal(v.x), dReal(v.y), dReal(v.z));
        dBodySetAngularVel(body, dReal(w.x), dReal(w.y), dReal(w.z));
    }
    if (random_.unit() < 0.1) dBodySetKinematic(bodies[0]);
}

// Every body hangs on an earlier one or on the world; then loops, then duplicates.
void Mechanism::add_joints()
{
    const int count = int(bodies.size());
    std::vector<std::pair<int, int>> made;
    std::vector<int> kinds;
    const auto add = [&](int child, int parent, int kind) {
        // A hinge-2 has two bodies; a motor alone lets two bodies part.
        if (kind == kHinge2 && parent < 0) kind = kHinge;
        if (kind == kPlane2D && !flat_[std::size_t(child)]) kind = kBall;
        if (kind == kUserMotor || kind == kEulerMotor || kind == kLinearMotor) {
            if (random_.unit() < 0.8) add_joint(child, parent, kBall, false);
        }
        add_joint(child, parent, kind, false);
        made.push_back({child, parent});
        kinds.push_back(kind);
    };
    for (int i = 0; i < count; ++i) {
        if (flat_[std::size_t(i)]) add_joint(i, -1, kPlane2D, false);
        if (random_.unit() < 0.1) continue;  // a tree of its own
        add(i, random_.below(i + 1) - 1, random_.below(kinds_));
    }
    const double wanted = random_.unit() < 0.4 ? 0 : random_.range(0, 0.5);
    for (int k = 0; k < int(wanted * count + 0.5); ++k) {
        const int child = random_.below(count), parent = random_.below(count + 1) - 1;
        if (child != parent) add(child, parent, random_.below(kinds_));
    }
    const int again = made.empty() || random_.unit() < 0.6 ? 0 : 1 + random_.below(3);
    for (int k = 0; k < again; ++k) {
        const auto which = std::size_t(random_.below(int(made.size())));
        add_joint(made[which].first, made[which].second, kinds[which], true);
    }
}

bool Mechanism::begin_part(const std::string& what)
{
    const std::size_t index = parts.size();
    parts.push_back(what);
    return index >= without_.size() || !without_[index];
}

// A duplicate repeats the numbers that its model was drawn from only in part: what makes it redundant is that
// it holds the same two bodies.
void Mechanism::add_joint(int child, int parent, int kind, bool again)
{
    const dBodyID a = bodies[std::size_t(child)], b = parent < 0 ? nullptr : bodies[std::size_t(parent)];
    const bool make = begin_part(std::string(name_of(kind)) + (again ? " again " : " ") +
                                 std::to_string(child) + " " + std::to_string(parent));
    std::string text;
    make_joint(kind, world, random_, a, b, make, text);
    parts.back() += text;
    pairs_.push_back({child, parent});
}

void Mechanism::draw_surface()
{
    const double kind = random_.unit();
    surface_.mu = kind < 0.15 ? 0 : kind < 0.3 ? dInfinity : dReal(random_.range(0, 1.5));
    surface_.mode = random_.unit() < 0.7 ? dContactApprox1 : dContactApprox0;
    if (surface_.mode == dContactApprox0 && surface_.mu != dInfinity) surface_.mu *= 10;
    const double bounce = random_.unit(), erp_here = random_.range(0, 0.8), slip = random_.unit();
    const double cfm_here = log_uniform(random_, 1e-10, 1e-2), slip_here = log_uniform(random_, 1e-6, 1);
    if (random_.unit() < 0.3) {
        surface_.mode |= dContactBounce;
        surface_.bounce = dReal(bounce);
        surface_.bounce_vel = dReal(0.05);
    }
    if (random_.unit() < 0.3) {
        surface_.mode |= dContactSoftERP | dContactSoftCFM;
        surface_.soft_erp = dReal(erp_here);
        surface_.soft_cfm = dReal(cfm_here);
    }
    if (slip < 0.15) {
        surface_.mode |= dContactSlip1 | dContactSlip2;
        surface_.slip1 = surface_.slip2 = dReal(slip_here);
    }
    if (random_.unit() < 0.15) {
        surface_.mode |= dContactRolling;
        surface_.rho = dReal(random_.range(0.001, 0.1));
    }
    if (random_.unit() < 0.15) {
        surface_.mode |= dContactMotion1;
        surface_.motion1 = dReal(random_.range(-1, 1));
    }
}

// Points of some bodies reach the ground, which lies so that the lowest just touches it; some are round.
void Mechanism::add_touching()
{
    draw_surface();
    const int count = int(bodies.size());
    const double share = random_.unit() < 0.3 ? 0 : random_.range(0.2, 1), deep = random_.range(-0.2, 0.01);
    ground_ = 1e300;
    for (int i = 0; i < count; ++i) {
        const Vec3 half{random_.range(0.05, 0.3), random_.range(0.05, 0.3), random_.range(0.05, 0.3)};
        const int points = 1 << random_.below(4);
        if (random_.unit() >= share) continue;
        for (int k = 0; k < points; ++k) {
            const dReal at[3] = {dReal(k & 1 ? half.x : -half.x), dReal(k & 2 ? half.y : -half.y),
                                 dReal(k & 4 ? half.z : -half.z)};
            dVector3 there;
            dBodyGetRelPointPos(bodies[std::size_t(i)], at[0], at[1], at[2], there);
            ground_ = std::min(ground_, double(there[2]));
            if (begin_part("foot " + std::to_string(i)))
                feet_.push_back({int(parts.size()) - 1, i, {at[0], at[1], at[2]}});
        }
    }
    ground_ += deep;
    for (int i = 0; i < count; ++i) {
        double nearest = 1;
        for (int j = 0; j < count; ++j)
            if (j != i)
                nearest = std::min(nearest, length(minus(vec(dBodyGetPosition(bodies[std::size_t(i)])),
                                                         vec(dBodyGetPosition(bodies[std::size_t(j)])))));
        const double radius = random_.range(0.2, 0.5) * nearest;
        if (random_.unit() < 0.5 * share && begin_part("round " + std::to_string(i)))
            balls_.push_back({int(parts.size()) - 1, i, radius});
    }
}

bool Mechanism::joined(int a, int b) const
{
    return std::any_of(pairs_.begin(), pairs_.end(), [&](const std::pair<int, int>& p) {
        return (p.first == a && p.second == b) || (p.first == b && p.second == a);
    });
}

void Mechanism::contact(const dReal* at, const dReal* normal, double depth, dBodyID a, dBodyID b)
{
    dContact c{};
    c.surface = surface_;
    std::copy_n(at, 3, c.geom.pos);
    std::copy_n(normal, 3, c.geom.normal);
    c.geom.depth = dReal(depth);
    dJointAttach(dJointCreateContact(world, contacts_, &c), a, b);
    ++contact_count;
}

void Mechanism::touch_ground()
{
    const dReal up[3] = {0, 0, 1};
    for (const Foot& foot : feet_) {
        const dBodyID body = bodies[std::size_t(foot.body)];
        dVector3 there;
        dBodyGetRelPointPos(body, foot.at[0], foot.at[1], foot.at[2], there);
        const double depth = ground_ - double(there[2]);
        if (depth >= 0) contact(there, up, depth, body, nullptr);
    }
}

void Mechanism::touch_each_other()
{
    for (std::size_t i = 0; i < balls_.size(); ++i)
        for (std::size_t j = i + 1; j < balls_.size(); ++j) {
            const Ball &x = balls_[i], &y = balls_[j];
            if (joined(x.body, y.body)) continue;
            const dBodyID a = bodies[std::size_t(x.body)], b = bodies[std::size_t(y.body)];
            const Vec3 pa = vec(dBodyGetPosition(a)), pb = vec(dBodyGetPosition(b)), d = minus(pa, pb);
            const double apart = length(d), depth = x.radius + y.radius - apart;
            if (depth < 0 || apart < 1e-6) continue;
            const dReal n[3] = {dReal(d.x / apart), dReal(d.y / apart), dReal(d.z / apart)};
            const double reach = y.radius - 0.5 * depth;
            const dReal at[3] = {dReal(pb.x + reach * double(n[0])), dReal(pb.y + reach * double(n[1])),
                                 dReal(pb.z + reach * double(n[2]))};
            contact(at, n, depth, a, b);
        }
}

void Mechanism::collide()
{
    dJointGroupEmpty(contacts_);
    contact_count = 0;
    touch_ground();
    touch_each_other();
}

std::vector<BodyState> Mechanism::state() const
{
    std::vector<BodyState> all(bodies.size());
    for (std::size_t i = 0; i < all.size(); ++i) {
        std::copy_n(dBodyGetPosition(bodies[i]), 3, all[i].pos);
        std::copy_n(dBodyGetQuaternion(bodies[i]), 4, all[i].q);
        std::copy_n(dBodyGetLinearVel(bodies[i]), 3, all[i].v);
        std::copy_n(dBodyGetAngularVel(bodies[i]), 3, all[i].w);
    }
    return all;
}

void Mechanism::put(const std::vector<BodyState>& all)
{
    for (std::size_t i = 0; i < all.size(); ++i) {
        const BodyState& s = all[i];
        dBodySetPosition(bodies[i], s.pos[0], s.pos[1], s.pos[2]);
        const dQuaternion q = {s.q[0], s.q[1], s.q[2], s.q[3]};
        dBodySetQuaternion(bodies[i], q);
        dBodySetLinearVel(bodies[i], s.v[0], s.v[1], s.v[2]);
        dBodySetAngularVel(bodies[i], s.w[0], s.w[1], s.w[2]);
    }
}

bool Mechanism::finite() const
{
    for (const BodyState& s : state()) {
        double sum = 0;
        for (int i = 0; i < 3; ++i) sum += double(s.pos[i]) + double(s.v[i]) + double(s.w[i]);
        for (int i = 0; i < 4; ++i) sum += double(s.q[i]);
        if (!std::isfinite(sum)) return false;
    }
    return true;
}

std::string Mechanism::summary() const
{
    char line[160];
    std::snprintf(line, sizeof line, "bodies %zu, parts %zu, h %.5f, cfm %.2g, erp %.2f, mu %.2g, mode %#x",
                  bodies.size(), parts.size(), h, cfm, erp, double(surface_.mu), unsigned(surface_.mode));
    return line;
}

}  // namespace epode::mechanisms
