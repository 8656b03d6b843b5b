// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// One thread, 1/60 s, CPU time of the process. Names of our library only are asked for at run time.
#include "bench/runs/hybrid.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <vector>

#include "bench/engines/stopwatch.h"

namespace epode::bench {
namespace {

constexpr dReal kH = dReal(1.0 / 60);
constexpr int kGame = 1, kHybrid = 0, kSubsteps = 3;  // of dDefaults and dStepper

template <class Function>
Function find(const char* name)
{
    return reinterpret_cast<Function>(dlsym(RTLD_DEFAULT, name));
}
using SetNumber = void (*)(dWorldID, int);
using SetSpace = void (*)(dWorldID, dSpaceID);
using MakeStep = int (*)(dWorldID, dReal);

class Scene {
  public:
    explicit Scene(int stepper)
    {
        find<SetNumber>("dWorldUseDefaults")(world, kGame);
        find<SetNumber>("dWorldSetStepThreads")(world, 1);
        find<SetNumber>("dWorldSetHybridStepper")(world, stepper);
        find<SetSpace>("dWorldSetContactSpace")(world, space);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dCreatePlane(space, 0, 0, 1, 0);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene() { dSpaceDestroy(space), dWorldDestroy(world); }

    double random(double low, double high)
    {
        state_ = state_ * 1664525u + 1013904223u;
        return low + (high - low) * double(state_ >> 8) / 16777216.0;
    }
    dBodyID add(dGeomID geom, const dMass& mass, double x, double y, double z)
    {
        const dBodyID body = dBodyCreate(world);
        dBodySetMass(body, &mass);
        dGeomSetBody(geom, body);
        dBodySetPosition(body, dReal(x), dReal(y), dReal(z));
        return body;
    }
    dBodyID box(double x, double y, double z, double a, double b, double c, double density)
    {
        dMass mass;
        dMassSetBox(&mass, dReal(density), dReal(a), dReal(b), dReal(c));
        return add(dCreateBox(space, dReal(a), dReal(b), dReal(c)), mass, x, y, z);
    }
    dBodyID capsule(double x, double y, double z, double radius, double length, int along)
    {
        dMass mass;
        dMassSetCapsule(&mass, 1000, 3, dReal(radius), dReal(length));
        const dBodyID body = add(dCreateCapsule(space, dReal(radius), dReal(length)), mass, x, y, z);
        dMatrix3 R;
        dRFromAxisAndAngle(R, 0, 1, 0, along == 3 ? 0 : dReal(1.5707963267948966));
        dBodySetRotation(body, R);
        return body;
    }
    void ball(dBodyID a, dBodyID b, double x, double y, double z)
    {
        const dJointID joint = dJointCreateBall(world, nullptr);
        dJointAttach(joint, a, b);
        dJointSetBallAnchor(joint, dReal(x), dReal(y), dReal(z));
    }
    void hinge(dBodyID a, dBodyID b, double x, double y, double z, double ax, double ay)
    {
        const dJointID joint = dJointCreateHinge(world, nullptr);
        dJointAttach(joint, a, b);
        dJointSetHingeAnchor(joint, dReal(x), dReal(y), dReal(z));
        dJointSetHingeAxis(joint, dReal(ax), dReal(ay), 0);
        dJointSetHingeParam(joint, dParamLoStop, dReal(-0.1));
        dJointSetHingeParam(joint, dParamHiStop, 2);
    }

    const dWorldID world = dWorldCreate();
    const dSpaceID space = dHashSpaceCreate(nullptr);

  private:
    std::uint32_t state_ = 1;
};

// Pieces of 5 to 30 cm that fly apart, boxes and balls, of unequal mass.
void build_debris(Scene& s, int count)
{
    const int side = int(std::ceil(std::sqrt(count / 4.0)));
    for (int i = 0; i < count; ++i) {
        const double size = s.random(0.05, 0.3);
        const double x = i / 4 % side * 0.45 + s.random(-0.05, 0.05), z = 0.3 + i % 4 * 0.4;
        const double y = i / 4 / side * 0.45 + s.random(-0.05, 0.05);
        dMass mass;
        dMassSetSphere(&mass, 2000, dReal(size / 2));
        const dBodyID body =
            i % 3 ? s.box(x, y, z, size, s.random(0.05, 0.3), s.random(0.05, 0.3), s.random(300, 3000))
                  : s.add(dCreateSphere(s.space, dReal(size / 2)), mass, x, y, z);
        const double v[3] = {s.random(-2, 2), s.random(-2, 2), s.random(-1, 3)};
        dBodySetLinearVel(body, dReal(v[0]), dReal(v[1]), dReal(v[2]));
        const double w[3] = {s.random(-5, 5), s.random(-5, 5), s.random(-5, 5)};
        dBodySetAngularVel(body, dReal(w[0]), dReal(w[1]), dReal(w[2]));
    }
}

// Eleven bodies.
void add_figure(Scene& s, double x, double y, double z)
{
    const dBodyID pelvis = s.box(x, y, z + 1, 0.3, 0.2, 0.2, 1000),
                  chest = s.box(x, y, z + 1.35, 0.36, 0.22, 0.4, 1000);
    const dBodyID head = s.capsule(x, y, z + 1.75, 0.1, 0.08, 3);
    s.ball(pelvis, chest, x, y, z + 1.12);
    s.ball(chest, head, x, y, z + 1.6);
    for (int side = -1; side <= 1; side += 2) {
        const dBodyID upper = s.capsule(x + side * 0.35, y, z + 1.5, 0.05, 0.22, 1);
        const dBodyID lower = s.capsule(x + side * 0.65, y, z + 1.5, 0.045, 0.2, 1);
        s.ball(chest, upper, x + side * 0.2, y, z + 1.5);
        s.hinge(upper, lower, x + side * 0.5, y, z + 1.5, 0, 1);
        const dBodyID thigh = s.capsule(x + side * 0.1, y, z + 0.7, 0.075, 0.3, 3);
        const dBodyID shin = s.capsule(x + side * 0.1, y, z + 0.27, 0.06, 0.3, 3);
        s.ball(pelvis, thigh, x + side * 0.1, y, z + 0.92);
        s.hinge(thigh, shin, x + side * 0.1, y, z + 0.48, 1, 0);
    }
}

void build_figures(Scene& s, int count)
{
    for (int i = 0; i < count; ++i)
        add_figure(s, i % 6 + s.random(-0.1, 0.1), i / 6 * 0.7 + s.random(-0.1, 0.1), 0.3 + i % 3 * 0.3);
}

void build_figure_pile(Scene& s, int count)
{
    for (int i = 0; i < count; ++i)
        add_figure(s, i % 3 * 0.6 + s.random(-0.1, 0.1), i / 3 % 3 * 0.5 + s.random(-0.1, 0.1),
                   0.3 + i / 9 * 2.2);
}

void build_stacks(Scene& s, int count)
{
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 10; ++k) s.box(i % 10 * 0.55, i / 10 * 0.55, 0.26 + k * 0.51, 0.5, 0.5, 0.5, 160);
}

void build_towers(Scene& s, int count)
{
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 20; ++k) s.box(i % 10 * 1.5, i / 10 * 1.5, 0.5 + k, 1, 1, 1, 100);
}

struct Row {
    const char* name;
    void (*build)(Scene&, int);
    int count;
    bool large = false;
};
constexpr Row kRows[] = {{"debris", build_debris, 500},
                         {"debris", build_debris, 2000},
                         {"debris", build_debris, 10000, true},
                         {"ragdolls", build_figures, 30},
                         {"ragdolls in a pile", build_figure_pile, 30},
                         {"stacks of 10 crates", build_stacks, 100},
                         {"towers of 20 boxes", build_towers, 10}};

struct Times {
    double mean = 0, median = 0, p99 = 0, worst = 0;  // ms
};

Times run(const Row& row, int stepper, int steps)
{
    Scene scene(stepper);
    row.build(scene, row.count);
    const auto step = find<MakeStep>("dWorldStepHybrid");
    std::vector<double> times;
    for (int i = 0; i < steps; ++i) {
        Stopwatch watch(false);
        step(scene.world, kH);
        times.push_back(watch.lap());
    }
    std::sort(times.begin(), times.end());
    Times out;
    for (double t : times) out.mean += t / double(times.size());
    out.median = times[times.size() / 2], out.p99 = times[times.size() * 99 / 100], out.worst = times.back();
    return out;
}

void print(const Times& t)
{
    fmt::print(" {:.2f} | {:.2f} | {:.2f} | {:.2f} |", t.mean, t.median, t.p99, t.worst);
}

}  // namespace

int bench_hybrid(const HybridOptions& options)
{
    if (!find<MakeStep>("dWorldStepHybrid") || !find<SetNumber>("dWorldUseDefaults")) {
        fmt::print(stderr, "epode_bench: a library without dWorldStepHybrid\n");
        return 1;
    }
    fmt::print(
        "| world, ms | substeps: mean | median | p99 | worst | hybrid: mean | median | p99 | worst "
        "| mean of substeps' | worst of substeps' |\n");
    fmt::print("|---|---|---|---|---|---|---|---|---|---|---|\n");
    for (const Row& row : kRows) {
        if (row.large && !options.large) continue;
        const Times substeps = run(row, kSubsteps, options.steps);
        const Times hybrid = run(row, kHybrid, options.steps);
        fmt::print("| {} {} |", row.count, row.name);
        print(substeps), print(hybrid);
        fmt::print(" {:.2f} | {:.2f} |\n", hybrid.mean / substeps.mean, hybrid.worst / substeps.worst);
        std::fflush(stdout);
    }
    return 0;
}

}  // namespace epode::bench
