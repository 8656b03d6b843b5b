// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Plane mechanisms lie in z = 0 with hinges along z: each loop of them has three rows too many. A05's spring
// dampers are two contacts that face each other, without friction: soft_cfm = 1/(h K + C) and a wanted
// velocity of erp/h times the stretch, erp = h K/(h K + C), make of them the implicit spring, which a force
// would not be.
#include "problems.h"

#include <algorithm>
#include <cmath>

#include "reference.h"
#include "squeezer.h"

namespace epode::iftomm {
namespace {

constexpr double kPi = 3.14159265358979323846;

struct V {
    double x, y, z;
};

V read(const dReal* p) { return {double(p[0]), double(p[1]), double(p[2])}; }

V point(dBodyID b, double x, double y, double z)
{
    dVector3 p;
    dBodyGetRelPointPos(b, dReal(x), dReal(y), dReal(z), p);
    return read(p);
}

void set_speed(dBodyID b, V v, V w)
{
    dBodySetLinearVel(b, dReal(v.x), dReal(v.y), dReal(v.z));
    dBodySetAngularVel(b, dReal(w.x), dReal(w.y), dReal(w.z));
}

// A rod from a to b along the body's x.
void lay(dBodyID body, V a, V b)
{
    const V d{b.x - a.x, b.y - a.y, b.z - a.z};
    const bool upright = std::fabs(d.z) > 0.9 * std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
    const V n = upright ? V{0, 1, 0} : V{0, 0, 1};
    dMatrix3 R;
    dRFrom2Axes(R, dReal(d.x), dReal(d.y), dReal(d.z), dReal(n.y * d.z - n.z * d.y),
                dReal(n.z * d.x - n.x * d.z), dReal(n.x * d.y - n.y * d.x));
    dBodySetRotation(body, R);
    dBodySetPosition(body, dReal((a.x + b.x) / 2), dReal((a.y + b.y) / 2), dReal((a.z + b.z) / 2));
}

class Pendulum : public Problem {
  public:
    Pendulum()
    {
        gravity = kGravity;
        bob_ = body(1, 1e-3, 1e-3, 1e-3, -1, 0, 0);
        hinge(bob_, nullptr, 0, 0, 0, 0, 0, 1);
    }
    std::vector<double> outputs() const override
    {
        const V p = read(dBodyGetPosition(bob_));
        return {p.x, p.y};
    }

  private:
    dBodyID bob_;
};

class FourBars : public Problem {
  public:
    explicit FourBars(int windows)
    {
        gravity = kGravity;
        dBodyID before = nullptr;
        for (int i = 0; i <= windows; ++i) {
            const double x = i;
            dBodyID crank = body(1, 1. / 1200, 1. / 12, 1. / 12, 0, 0, 0);
            lay(crank, {x, 0, 0}, {x, 1, 0});
            set_speed(crank, {0.5, 0, 0}, {0, 0, -1});
            hinge(crank, nullptr, x, 0, 0, 0, 0, 1);
            if (i == 0) first_ = crank;
            if (before) hinge(before, crank, x, 1, 0, 0, 0, 1);
            if (i == windows) break;
            before = body(1, 1. / 1200, 1. / 12, 1. / 12, 0, 0, 0);
            lay(before, {x, 1, 0}, {x + 1, 1, 0});
            set_speed(before, {1, 0, 0}, {0, 0, 0});
            hinge(crank, before, x, 1, 0, 0, 0, 1);
        }
    }
    std::vector<double> outputs() const override
    {
        const V p = point(first_, 0.5, 0, 0);
        dVector3 v;
        dBodyGetRelPointVel(first_, dReal(0.5), 0, 0, v);
        return {p.x, p.y, double(v[0]), double(v[1])};
    }

  private:
    dBodyID first_ = nullptr;
};

class Squeezer : public Problem {
  public:
    Squeezer()
    {
        const auto bars = squeezer::bars(squeezer::kStart);
        for (const squeezer::Bar& bar : bars)
            body(bar.mass, bar.inertia, bar.inertia, bar.inertia, bar.centre.x, bar.centre.y, 0);
        for (const squeezer::Pin& pin : squeezer::pins(squeezer::kStart))
            hinge(bodies[std::size_t(pin.a)], pin.b < 0 ? nullptr : bodies[std::size_t(pin.b)], pin.at.x,
                  pin.at.y, 0, 0, 0, 1);
        const squeezer::Point D = squeezer::spring_end(squeezer::kStart),
                              F = squeezer::pins(squeezer::kStart)[1].at;
        d_ = {D.x - bars[squeezer::kTriangle].centre.x, D.y - bars[squeezer::kTriangle].centre.y, 0};
        f_ = {F.x - bars[squeezer::kCrank].centre.x, F.y - bars[squeezer::kCrank].centre.y, 0};
    }
    void apply_forces(double) override
    {
        dBodyAddTorque(bodies[squeezer::kCrank], 0, 0, dReal(squeezer::kTorque));
        const V D = point(bodies[squeezer::kTriangle], d_.x, d_.y, 0);
        const double x = D.x - squeezer::kC.x, y = D.y - squeezer::kC.y, l = std::sqrt(x * x + y * y);
        const double pull = -squeezer::kStiffness * (l - squeezer::kRest) / l;
        dBodyAddForceAtPos(bodies[squeezer::kTriangle], dReal(pull * x), dReal(pull * y), 0, dReal(D.x),
                           dReal(D.y), 0);
    }
    std::vector<double> outputs() const override
    {
        const V p = point(bodies[squeezer::kCrank], f_.x, f_.y, 0);
        return {p.x, p.y};
    }
    double energy() const override
    {
        const V D = point(bodies[squeezer::kTriangle], d_.x, d_.y, 0);
        const double x = D.x - squeezer::kC.x, y = D.y - squeezer::kC.y;
        const double stretch = std::sqrt(x * x + y * y) - squeezer::kRest;
        return Problem::energy() + 0.5 * squeezer::kStiffness * stretch * stretch -
               squeezer::kTorque * crank_angle();
    }

  private:
    double crank_angle() const
    {
        const double now = double(dJointGetHingeAngle(hinges[0]));
        turned_ += std::remainder(now - last_, 2 * kPi);
        last_ = now;
        return turned_;
    }

    V d_{}, f_{};
    mutable double turned_ = 0, last_ = 0;
};

class Bricard : public Problem {
  public:
    Bricard()
    {
        gravity = kGravity;
        const V corner[6] = {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 1}, {0, 1, 1}, {0, 0, 1}};
        const V axis[6] = {{0, 1, 0}, {0, 0, 1}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 0}};
        for (int k = 1; k < 6; ++k)
            lay(body(1, 0.02 / 12, 1.01 / 12, 1.01 / 12, 0, 0, 0), corner[k], corner[(k + 1) % 6]);
        for (int k = 0; k < 6; ++k) {
            const auto link = [&](int i) { return i == 0 ? nullptr : bodies[std::size_t(i - 1)]; };
            dBodyID a = link(k), b = link((k + 5) % 6);
            if (!a) std::swap(a, b);
            hinge(a, b, corner[k].x, corner[k].y, corner[k].z, axis[k].x, axis[k].y, axis[k].z);
        }
    }
    std::vector<double> outputs() const override
    {
        const V p = point(bodies[1], 0.5, 0, 0);
        return {p.x, p.y, p.z};
    }
};

class Governor : public Problem {
  public:
    Governor() : contacts_(dJointGroupCreate(0))
    {
        up = 2;
        gravity = kGravity;
        const double rod = 0.3, thin = 0.01 * 0.01 / 12, phi = kPi / 6, spin = 2 * kPi;
        dBodyID shaft = body(rod, rod * (1. / 12 + thin), rod * (1. / 12 + thin), rod * 2 * thin, 0, 0, 0.5);
        set_speed(shaft, {0, 0, 0}, {0, 0, spin});
        hinge(shaft, nullptr, 0, 0, 0, 0, 0, 1);
        slider_ = body(3, 0.005, 0.005, 0.005, 0, 0, 0.5);
        set_speed(slider_, {0, 0, 0}, {0, 0, spin});
        dJointID along = dJointCreateSlider(world, nullptr);
        dJointAttach(along, slider_, shaft);
        dJointSetSliderAxis(along, 0, 0, 1);
        // Rod of 0.3 kg and 5 kg at its end: centre at 5.15/5.3 of its length.
        const double mass = rod + 5, centre = (rod * 0.5 + 5) / mass;
        const double across = rod * (1. / 3 + thin) + 5 - mass * centre * centre;
        middle_ = 0.5 - centre;
        for (double side : {1.0, -1.0}) {
            dBodyID b = body(mass, rod * 2 * thin, across, across, 0, 0, 0);
            const V end{side * std::cos(phi), 0, 1 - std::sin(phi)};
            lay(b, {0, 0, 1}, end);
            dBodySetPosition(b, dReal(centre * end.x), 0, dReal(1 + centre * (end.z - 1)));
            set_speed(b, {0, spin * centre * end.x, 0}, {0, 0, spin});
            hinge(b, shaft, 0, 0, 1, 0, 1, 0);
            rods_.push_back(b);
        }
    }
    ~Governor() override { dJointGroupDestroy(contacts_); }
    void apply_forces(double h) override
    {
        constexpr double K = 8e5, C = 4e4, rest = 0.5;
        dJointGroupEmpty(contacts_);
        for (dBodyID rod : rods_) {
            const V a = point(rod, middle_, 0, 0), b = read(dBodyGetPosition(slider_));
            const V d{a.x - b.x, a.y - b.y, a.z - b.z};
            const double l = std::sqrt(d.x * d.x + d.y * d.y + d.z * d.z);
            const double wanted = K / (h * K + C) * (rest - l);
            for (double side : {1.0, -1.0}) {
                dContact c{};
                c.surface.mode = dContactSoftCFM | dContactMotionN;
                c.surface.soft_cfm = dReal(1 / (h * K + C));
                c.surface.motionN = dReal(side * wanted);
                c.geom.pos[0] = dReal(a.x), c.geom.pos[1] = dReal(a.y), c.geom.pos[2] = dReal(a.z);
                c.geom.normal[0] = dReal(side * d.x / l), c.geom.normal[1] = dReal(side * d.y / l);
                c.geom.normal[2] = dReal(side * d.z / l);
                dJointAttach(dJointCreateContact(world, contacts_, &c), rod, slider_);
            }
        }
    }
    std::vector<double> outputs() const override { return {read(dBodyGetPosition(slider_)).z}; }

  private:
    dJointGroupID contacts_;
    dBodyID slider_;
    std::vector<dBodyID> rods_;
    double middle_;
};

}  // namespace

Problem::Problem() : world(dWorldCreate()) {}
Problem::~Problem() { dWorldDestroy(world); }

dBodyID Problem::body(double mass, double ixx, double iyy, double izz, double x, double y, double z)
{
    const dBodyID b = dBodyCreate(world);
    dMass m;
    dMassSetParameters(&m, dReal(mass), 0, 0, 0, dReal(ixx), dReal(iyy), dReal(izz), 0, 0, 0);
    dBodySetMass(b, &m);
    dBodySetPosition(b, dReal(x), dReal(y), dReal(z));
    bodies.push_back(b);
    dWorldSetGravity(world, 0, dReal(up == 1 ? -gravity : 0), dReal(up == 2 ? -gravity : 0));
    return b;
}

dJointID Problem::hinge(dBodyID a, dBodyID b, double x, double y, double z, double nx, double ny, double nz)
{
    const dJointID j = dJointCreateHinge(world, nullptr);
    dJointAttach(j, a, b);
    dJointSetHingeAnchor(j, dReal(x), dReal(y), dReal(z));
    dJointSetHingeAxis(j, dReal(nx), dReal(ny), dReal(nz));
    hinges.push_back(j);
    return j;
}

double Problem::energy() const
{
    double sum = 0;
    for (dBodyID b : bodies) {
        dMass m;
        dBodyGetMass(b, &m);
        const V v = read(dBodyGetLinearVel(b)), p = read(dBodyGetPosition(b));
        dVector3 w;
        dBodyVectorFromWorld(b, dBodyGetAngularVel(b)[0], dBodyGetAngularVel(b)[1], dBodyGetAngularVel(b)[2],
                             w);
        sum += 0.5 * double(m.mass) * (v.x * v.x + v.y * v.y + v.z * v.z);
        for (int i = 0; i < 3; ++i) sum += 0.5 * double(m.I[5 * i]) * double(w[i]) * double(w[i]);
        sum += double(m.mass) * gravity * (up == 1 ? p.y : p.z);
    }
    return sum;
}

double Problem::gap() const
{
    double largest = 0;
    for (dJointID j : hinges) {
        dVector3 a, b;
        dJointGetHingeAnchor(j, a);
        dJointGetHingeAnchor2(j, b);
        const double x = double(a[0] - b[0]), y = double(a[1] - b[1]), z = double(a[2] - b[2]);
        largest = std::max(largest, std::sqrt(x * x + y * y + z * z));
    }
    return largest;
}

std::unique_ptr<Problem> make_problem(const std::string& name, int size)
{
    if (name == "A01") return std::make_unique<Pendulum>();
    if (name == "A02") return std::make_unique<FourBars>(size);
    if (name == "A03") return std::make_unique<Squeezer>();
    if (name == "A04") return std::make_unique<Bricard>();
    if (name == "A05") return std::make_unique<Governor>();
    return nullptr;
}

}  // namespace epode::iftomm
