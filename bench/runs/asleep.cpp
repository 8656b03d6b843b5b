// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// CPU time of one thread, as a mean over steps or, where a box is woken in each, the worst of them. Contacts
// are the world's own business where the library knows how (names of our library are asked for at run time);
// with a library that does not, or without a space, boxes are put to sleep by hand.
#include "bench/runs/asleep.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/engines/stopwatch.h"

namespace epode::bench {
namespace {

using SetSpace = void (*)(dWorldID, dSpaceID);
constexpr dReal kH = dReal(1) / 60, kSide = dReal(0.5);
constexpr int kHeight = 4, kMostSteps = 1000;

class Yard {
  public:
    explicit Yard(const AsleepOptions& options)
    {
        dWorldSetGravity(world_, 0, 0, dReal(-9.81));
        dWorldSetAutoDisableFlag(world_, 1);
        const auto set_space = reinterpret_cast<SetSpace>(dlsym(RTLD_DEFAULT, "dWorldSetContactSpace"));
        world_contacts_ = set_space && !options.no_space;
        if (world_contacts_) set_space(world_, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        const int side = int(std::ceil(std::sqrt(double(options.boxes) / kHeight)));
        for (int i = 0; i < options.boxes; ++i)
            boxes_.push_back(add(dCreateBox(space_, kSide, kSide, kSide), dReal(0.8) * (i / kHeight % side),
                                 dReal(0.8) * (i / kHeight / side), kSide * (dReal(0.5) + i % kHeight)));
    }
    ~Yard()
    {
        dWorldDestroy(world_);
        dSpaceDestroy(space_);
    }
    Yard(const Yard&) = delete;
    Yard& operator=(const Yard&) = delete;

    bool has_world_contacts() const { return world_contacts_; }
    void step() { dWorldQuickStep(world_, kH); }
    // False: they do not.
    bool fall_asleep()
    {
        for (int i = 0; world_contacts_ && i < kMostSteps && asleep() < int(boxes_.size()); ++i) step();
        if (!world_contacts_)
            for (const dBodyID box : boxes_) dBodyDisable(box);
        for (int i = 0; i < 5; ++i) step();
        return asleep() == int(boxes_.size());
    }
    void roll(int balls)
    {
        for (int i = 0; i < balls; ++i) {
            const dBodyID ball = add(dCreateSphere(space_, kSide / 2), -10 - i % 10, i / 10, kSide / 2);
            dBodySetAutoDisableFlag(ball, 0);
            dBodySetLinearVel(ball, -1, 0, 0);
            if (!world_contacts_) dBodySetGravityMode(ball, 0);
        }
    }
    void nudge(int i)
    {
        const dBodyID box = boxes_[std::size_t(i * 7919LL % int(boxes_.size()))];
        dBodyEnable(box);
        dBodySetLinearVel(box, dReal(0.3), 0, 0);
    }

  private:
    dBodyID add(dGeomID geom, dReal x, dReal y, dReal z)
    {
        const dBodyID body = dBodyCreate(world_);
        dMass mass;
        dMassSetBoxTotal(&mass, 100, kSide, kSide, kSide);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, y, z);
        dGeomSetBody(geom, body);
        return body;
    }
    int asleep() const
    {
        return int(std::count_if(boxes_.begin(), boxes_.end(), [](dBodyID b) { return !dBodyIsEnabled(b); }));
    }

    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dHashSpaceCreate(nullptr);
    bool world_contacts_;
    std::vector<dBodyID> boxes_;
};

template <typename Before>
std::pair<double, double> mean_and_worst(Yard& yard, int steps, Before&& before)
{
    double sum = 0, worst = 0;
    for (int i = 0; i < steps; ++i) {
        before(i);
        Stopwatch watch(false);
        yard.step();
        const double ms = watch.lap();
        sum += ms, worst = std::max(worst, ms);
    }
    return {sum / steps, worst};
}

void print(const char* text, std::pair<double, double> ms)
{
    fmt::print("{:<34} {:>9.4f} {:>9.4f}\n", text, ms.first, ms.second);
}

}  // namespace

int bench_asleep(const AsleepOptions& options)
{
    dInitODE2(0);
    {
        Yard yard(options);
        if (!yard.fall_asleep()) {
            fmt::print(stderr, "the boxes do not fall asleep\n");
            return 1;
        }
        const auto nothing = [](int) {};
        fmt::print("{} boxes asleep, {}; ms a step\n", options.boxes,
                   yard.has_world_contacts() ? "contacts managed by the world" : "no contacts");
        fmt::print("{:<34} {:>9} {:>9}\n", "", "mean", "worst");
        print("all asleep", mean_and_worst(yard, options.steps, nothing));
        yard.roll(options.awake);
        for (int i = 0; i < 60; ++i) yard.step();
        print(fmt::format("{} awake", options.awake).c_str(), mean_and_worst(yard, options.steps, nothing));
        print("and one more woken in each step",
              mean_and_worst(yard, options.steps, [&](int i) { yard.nudge(i); }));
    }
    dCloseODE();
    return 0;
}

}  // namespace epode::bench
