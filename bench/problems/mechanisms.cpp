// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Torques are drawn for every world and axis from its own stream and held for kHold steps, which one call of
// dWorldsStep makes; setting them is not timed. Time is the process's own; callgrind counts what happens
// inside dWorldsStep (bench/robots). Names of our library only are asked for at run time.
#include "bench/problems/mechanisms.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include "bench/engines/stopwatch.h"
#include "bench/problems/mechanism_models.h"

namespace epode::bench {
namespace {

constexpr int kHold = 5;
constexpr unsigned long kGroundBit = 1, kRobotBit = 2;

template <class Function>
Function* find(const char* name, Function*)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}
#define EPODE_FIND(name) find(#name, &name)

struct Drive {
    dJointID joint;
    int axis;
    dDrive values;
    double torque;
};

struct Mechanism {
    dWorldID world;
    dSpaceID space;
    std::vector<dBodyID> bodies;
    std::vector<dJointID> hinges;
    std::vector<Drive> drives;
    std::uint64_t random;
};

double draw(std::uint64_t& state)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return double(state >> 11) * 0x1p-53 * 2 - 1;
}

Point plus(Point a, Point b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }

// Turns z towards d.
void turn_to(Point d, dMatrix3 R) { dRFromZAxis(R, dReal(d[0]), dReal(d[1]), dReal(d[2])); }

void add_mass(dMass& sum, const LinkShape& shape, double density)
{
    dMass mass;
    if (shape.radius == 0) {
        dMassSetBox(&mass, dReal(density), dReal(2 * shape.to[0]), dReal(2 * shape.to[1]),
                    dReal(2 * shape.to[2]));
        return dMassAdd(&sum, &mass);
    }
    const Point d{shape.to[0] - shape.from[0], shape.to[1] - shape.from[1], shape.to[2] - shape.from[2]};
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (length == 0) {
        dMassSetSphere(&mass, dReal(density), dReal(shape.radius));
    } else {
        dMatrix3 R;
        turn_to(d, R);
        dMassSetCapsule(&mass, dReal(density), 3, dReal(shape.radius), dReal(length));
        dMassRotate(&mass, R);
    }
    dMassTranslate(&mass, dReal(shape.from[0] + d[0] / 2), dReal(shape.from[1] + d[1] / 2),
                   dReal(shape.from[2] + d[2] / 2));
    dMassAdd(&sum, &mass);
}

// `centre`: of mass, in the link's frame.
void add_geom(Mechanism& to, const MechanismModel& model, const LinkShape& shape, const dReal* centre,
              dBodyID body)
{
    const Point d{shape.to[0] - shape.from[0], shape.to[1] - shape.from[1], shape.to[2] - shape.from[2]};
    const double length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    dGeomID geom;
    Point middle{shape.from[0] + d[0] / 2, shape.from[1] + d[1] / 2, shape.from[2] + d[2] / 2};
    if (shape.radius == 0) {
        geom = dCreateBox(to.space, dReal(2 * shape.to[0]), dReal(2 * shape.to[1]), dReal(2 * shape.to[2]));
        middle = {};
    } else if (length == 0) {
        geom = dCreateSphere(to.space, dReal(shape.radius));
    } else {
        geom = dCreateCapsule(to.space, dReal(shape.radius), dReal(length));
    }
    dGeomSetBody(geom, body);
    dGeomSetOffsetPosition(geom, dReal(middle[0]) - centre[0], dReal(middle[1]) - centre[1],
                           dReal(middle[2]) - centre[2]);
    if (shape.radius > 0 && length > 0) {
        dMatrix3 R;
        turn_to(d, R);
        dGeomSetOffsetRotation(geom, R);
    }
    dGeomSetCategoryBits(geom, kRobotBit);
    dGeomSetCollideBits(geom, kGroundBit | (model.self_contacts ? kRobotBit : 0));
    static const auto set_material = EPODE_FIND(dGeomSetMaterial);
    static const auto init = EPODE_FIND(dMaterialInit);
    dMaterial material;
    init(&material, sizeof material);
    material.friction = dReal(model.friction);
    set_material(geom, &material);
}

void add_drive(Mechanism& to, dJointID joint, int axis, const LinkAxis& from)
{
    if (from.armature == 0 && from.damping == 0 && from.torque == 0) return;
    static const auto init = EPODE_FIND(dDriveInit);
    Drive drive{joint, axis, {}, from.torque};
    init(&drive.values, sizeof drive.values);
    drive.values.armature = dReal(from.armature);
    drive.values.damping = dReal(from.damping);
    drive.values.stiffness = dReal(from.stiffness);
    to.drives.push_back(drive);
}

void add_hinge(Mechanism& to, dBodyID body, dBodyID parent, Point anchor, const LinkAxis& axis)
{
    const dJointID joint = dJointCreateHinge(to.world, nullptr);
    dJointAttach(joint, body, parent);
    dJointSetHingeAnchor(joint, dReal(anchor[0]), dReal(anchor[1]), dReal(anchor[2]));
    dJointSetHingeAxis(joint, dReal(axis.axis[0]), dReal(axis.axis[1]), dReal(axis.axis[2]));
    if (axis.low < axis.high) {
        // Gymnasium's machines may begin beyond their stops.
        dJointSetHingeParam(joint, dParamLoStop, dReal(axis.low));
        dJointSetHingeParam(joint, dParamHiStop, dReal(axis.high));
    }
    to.hinges.push_back(joint);
    add_drive(to, joint, 0, axis);
}

void add_universal(Mechanism& to, dBodyID body, dBodyID parent, Point anchor, const Link& link)
{
    const dJointID joint = dJointCreateUniversal(to.world, nullptr);
    dJointAttach(joint, body, parent);
    dJointSetUniversalAnchor(joint, dReal(anchor[0]), dReal(anchor[1]), dReal(anchor[2]));
    const Point &a = link.axes[1].axis, &b = link.axes[0].axis;
    dJointSetUniversalAxis1(joint, dReal(a[0]), dReal(a[1]), dReal(a[2]));
    dJointSetUniversalAxis2(joint, dReal(b[0]), dReal(b[1]), dReal(b[2]));
    dJointSetUniversalParam(joint, dParamLoStop1, dReal(link.axes[1].low));
    dJointSetUniversalParam(joint, dParamHiStop1, dReal(link.axes[1].high));
    dJointSetUniversalParam(joint, dParamLoStop2, dReal(link.axes[0].low));
    dJointSetUniversalParam(joint, dParamHiStop2, dReal(link.axes[0].high));
    add_drive(to, joint, 0, link.axes[1]);
    add_drive(to, joint, 1, link.axes[0]);
}

void add_ball(Mechanism& to, dBodyID body, dBodyID parent, Point anchor, const Link& link)
{
    const dJointID ball = dJointCreateBall(to.world, nullptr);
    dJointAttach(ball, body, parent);
    dJointSetBallAnchor(ball, dReal(anchor[0]), dReal(anchor[1]), dReal(anchor[2]));
    const dJointID motor = dJointCreateAMotor(to.world, nullptr);
    dJointAttach(motor, body, parent);
    dJointSetAMotorMode(motor, dAMotorEuler);
    const Point &first = link.axes[0].axis, &last = link.axes[2].axis;
    dJointSetAMotorAxis(motor, 0, 1, dReal(first[0]), dReal(first[1]), dReal(first[2]));
    dJointSetAMotorAxis(motor, 2, 2, dReal(last[0]), dReal(last[1]), dReal(last[2]));
    for (int i = 0; i < 3; ++i) {
        const LinkAxis& axis = link.axes[std::size_t(i)];
        dJointSetAMotorParam(motor, dParamLoStop + dParamGroup * i, dReal(axis.low));
        dJointSetAMotorParam(motor, dParamHiStop + dParamGroup * i, dReal(axis.high));
        add_drive(to, motor, i, axis);
    }
}

void add_link(Mechanism& to, const MechanismModel& model, const Link& link, Point origin)
{
    dMass mass;
    dMassSetZero(&mass);
    for (const LinkShape& shape : link.shapes) add_mass(mass, shape, model.density);
    const dReal centre[3] = {mass.c[0], mass.c[1], mass.c[2]};
    const dBodyID body = dBodyCreate(to.world);
    dBodySetPosition(body, dReal(origin[0]) + centre[0], dReal(origin[1]) + centre[1],
                     dReal(origin[2]) + centre[2]);
    dMassTranslate(&mass, -mass.c[0], -mass.c[1], -mass.c[2]);
    dBodySetMass(body, &mass);
    for (const LinkShape& shape : link.shapes) add_geom(to, model, shape, centre, body);
    to.bodies.push_back(body);
    if (link.axes.empty()) return;
    const dBodyID parent = link.parent < 0 ? nullptr : to.bodies[std::size_t(link.parent)];
    const Point anchor = plus(origin, link.anchor);
    if (link.axes.size() == 1)
        add_hinge(to, body, parent, anchor, link.axes[0]);
    else if (link.axes.size() == 2)
        add_universal(to, body, parent, anchor, link);
    else
        add_ball(to, body, parent, anchor, link);
}

Mechanism build(const MechanismModel& model, int number)
{
    Mechanism made{
        dWorldCreate(), dHashSpaceCreate(nullptr), {}, {}, {}, std::uint64_t(number) * 2654435761u + 1};
    const dReal up[3] = {0, dReal(model.planar), dReal(!model.planar)};
    dWorldSetGravity(made.world, 0, dReal(-9.81) * up[1], dReal(-9.81) * up[2]);
    if (model.ground) {
        const dGeomID plane = dCreatePlane(made.space, 0, up[1], up[2], 0);
        dGeomSetCategoryBits(plane, kGroundBit);
        dGeomSetCollideBits(plane, kRobotBit);
    }
    std::vector<Point> origins;
    for (const Link& link : model.links) {
        origins.push_back(link.parent < 0 ? Point{0, model.height * up[1], model.height * up[2]}
                                          : plus(origins[std::size_t(link.parent)], link.origin));
        add_link(made, model, link, origins.back());
    }
    if (model.planar) dJointAttach(dJointCreatePlane2D(made.world, nullptr), made.bodies[0], nullptr);
    EPODE_FIND(dWorldSetContactSpace)(made.world, made.space);
    return made;
}

void set_torques(Mechanism& mechanism)
{
    static const auto set_drive = EPODE_FIND(dJointSetDrive);
    for (Drive& drive : mechanism.drives) {
        drive.values.force = dReal(drive.torque * draw(mechanism.random));
        set_drive(drive.joint, drive.axis, &drive.values);
    }
}

// The largest distance of the two anchors of a hinge.
double hinge_gap(const Mechanism& mechanism)
{
    double worst = 0;
    for (const dJointID joint : mechanism.hinges) {
        dVector3 a, b;
        dJointGetHingeAnchor(joint, a);
        dJointGetHingeAnchor2(joint, b);
        const double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
        worst = std::max(worst, std::sqrt(x * x + y * y + z * z));
    }
    return worst;
}

// Of all positions and velocities, so that two builds can be compared bit by bit.
std::uint64_t hash_of(std::span<const Mechanism> mechanisms)
{
    std::uint64_t hash = 14695981039346656037u;
    const auto add = [&](const dReal* numbers) {
        for (int i = 0; i < 3; ++i) {
            std::uint64_t bits = 0;
            std::memcpy(&bits, numbers + i, sizeof(dReal));
            hash = (hash ^ bits) * 1099511628211u;
        }
    };
    for (const Mechanism& mechanism : mechanisms)
        for (const dBodyID body : mechanism.bodies) add(dBodyGetPosition(body)), add(dBodyGetLinearVel(body));
    return hash;
}

int number_of(const std::string& stepper)
{
    return stepper == "exact" ? dStepperExact : stepper == "quick" ? dStepperQuick : dStepperSubsteps;
}

class Run {
  public:
    Run(const MechanismModel& model, const MechanismOptions& options)
        : options_(options), h_(dReal(model.h)), stepper_(number_of(options.stepper))
    {
        for (int i = 0; i < options.worlds; ++i) {
            mechanisms_.push_back(build(model, i));
            worlds_.push_back(mechanisms_.back().world);
            if (options.projection > 0)
                EPODE_FIND(dWorldSetStepProjection)(worlds_.back(), options.projection);
        }
    }
    ~Run()
    {
        for (Mechanism& mechanism : mechanisms_) {
            dWorldDestroy(mechanism.world);
            dSpaceDestroy(mechanism.space);
        }
    }

    // Milliseconds of `steps` steps of each world; below 0: a step failed.
    double make(int steps)
    {
        double sum = 0;
        for (int made = 0; made < steps; made += kHold) {
            for (Mechanism& mechanism : mechanisms_) set_torques(mechanism);
            Stopwatch watch(false);
            if (step_many_(worlds_.data(), int(worlds_.size()), h_, stepper_, 4, kHold, options_.threads,
                           nullptr) != int(worlds_.size()))
                return -1;
            sum += watch.lap();
            for (const Mechanism& mechanism : mechanisms_) gap_ = std::max(gap_, hinge_gap(mechanism));
        }
        return sum;
    }

    double gap() const { return gap_; }
    std::span<const Mechanism> mechanisms() const { return mechanisms_; }

  private:
    const MechanismOptions& options_;
    const dReal h_;
    const int stepper_;
    decltype(&dWorldsStep) step_many_ = EPODE_FIND(dWorldsStep);
    std::vector<Mechanism> mechanisms_;
    std::vector<dWorldID> worlds_;
    double gap_ = 0;
};

double mean_contacts(std::span<const Mechanism> mechanisms)
{
    const auto count = EPODE_FIND(dWorldGetContacts);
    double sum = 0;
    for (const Mechanism& mechanism : mechanisms) sum += count(mechanism.world, nullptr, 0);
    return sum / double(mechanisms.size());
}

}  // namespace

int bench_mechanisms(const MechanismOptions& options)
{
    const auto models = mechanism_models();
    const auto model =
        std::find_if(models.begin(), models.end(), [&](const auto& m) { return options.model == m.name; });
    if (model == models.end() || !EPODE_FIND(dWorldsStep) || !EPODE_FIND(dJointSetDrive)) {
        fmt::print(stderr, "epode_bench: no such mechanism, or a library without dWorldsStep and drives\n");
        return 1;
    }
    Run run(*model, options);
    double best = run.make(options.settle) < 0 ? -1 : 1e300;
    for (int round = 0; round < options.rounds && best >= 0; ++round)
        best = std::min(best, run.make(options.steps));
    if (best < 0) return 1;
    const int steps = (options.steps + kHold - 1) / kHold * kHold;
    fmt::print(
        "{{\"model\": \"{}\", \"worlds\": {}, \"us\": {:.4f}, \"gap\": {:.2e}, \"contacts\": {:.2f}, "
        "\"hash\": \"{:016x}\"}}\n",
        options.model, options.worlds, 1e3 * best / steps / options.worlds, run.gap(),
        mean_contacts(run.mechanisms()), hash_of(run.mechanisms()));
    return 0;
}

}  // namespace epode::bench
