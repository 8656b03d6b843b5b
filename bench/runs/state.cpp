// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A pile of boxes with world-managed contacts: bytes of its state, and medians of CPU time for a step,
// for saving and restoring it, for the difference to the state of the step before, and for poses and
// velocities of all boxes in one call. And a robot of 14 links with drives: cloned, given its state. Names of our library are asked for at run time.
#include "bench/runs/state.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <ode/ext.h>
#include <ode/ode.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "bench/engines/stopwatch.h"

namespace epode::bench {
namespace {

constexpr dReal kH = dReal(1) / 60;

template <typename Function>
Function* named(const char* name)
{
    return reinterpret_cast<Function*>(dlsym(RTLD_DEFAULT, name));
}

struct Library {
    decltype(dWorldSetContactSpace)* set_space =
        named<decltype(dWorldSetContactSpace)>("dWorldSetContactSpace");
    decltype(dWorldStepFast1)* step = named<decltype(dWorldStepFast1)>("dWorldStepFast1");
    decltype(dWorldGetContacts)* contacts = named<decltype(dWorldGetContacts)>("dWorldGetContacts");
    decltype(dWorldGetStateSize)* size = named<decltype(dWorldGetStateSize)>("dWorldGetStateSize");
    decltype(dWorldGetState)* save = named<decltype(dWorldGetState)>("dWorldGetState");
    decltype(dWorldSetState)* load = named<decltype(dWorldSetState)>("dWorldSetState");
    decltype(dWorldGetStateDelta)* delta = named<decltype(dWorldGetStateDelta)>("dWorldGetStateDelta");
    decltype(dWorldSetHistory)* history = named<decltype(dWorldSetHistory)>("dWorldSetHistory");
    decltype(dWorldRollBack)* roll_back = named<decltype(dWorldRollBack)>("dWorldRollBack");
    decltype(dWorldGetHistorySize)* history_size =
        named<decltype(dWorldGetHistorySize)>("dWorldGetHistorySize");
    decltype(dWorldClone)* clone = named<decltype(dWorldClone)>("dWorldClone");
    decltype(dJointSetDrive)* drive = named<decltype(dJointSetDrive)>("dJointSetDrive");
    decltype(dBodiesGetStates)* get = named<decltype(dBodiesGetStates)>("dBodiesGetStates");
    decltype(dBodiesSetStates)* set = named<decltype(dBodiesSetStates)>("dBodiesSetStates");

    bool complete() const
    {
        return set_space && step && contacts && size && save && load && delta && get && set;
    }
};

// Boxes dropped in layers, each a little off the one below.
class Pile {
  public:
    Pile(const StateOptions& options, const Library& library) : library_(library)
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        if (options.sleeps) dWorldSetAutoDisableFlag(world, 1);
        library.set_space(world, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        const int side = std::max(1, int(std::cbrt(double(options.boxes))));
        for (int i = 0; i < options.boxes; ++i) add(i, side);
        for (int i = 0; i < options.steps; ++i) step();
    }
    ~Pile()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space_);
    }
    Pile(const Pile&) = delete;
    Pile& operator=(const Pile&) = delete;

    void step() { library_.step(world, kH, 4); }

    const dWorldID world = dWorldCreate();
    std::vector<dBodyID> boxes;

  private:
    void add(int i, int side)
    {
        const int column = i % (side * side), layer = i / (side * side);
        const dGeomID geom = dCreateBox(space_, dReal(0.5), dReal(0.5), dReal(0.5));
        const dBodyID body = dBodyCreate(world);
        dMass mass;
        dMassSetBox(&mass, 1000, dReal(0.5), dReal(0.5), dReal(0.5));
        dBodySetMass(body, &mass);
        const dReal off = dReal(0.1) * dReal(i * 7 % 11 - 5) / 5;
        dBodySetPosition(body, dReal(0.55) * dReal(column % side) + off,
                         dReal(0.55) * dReal(column / side) - off, dReal(0.3) + dReal(0.6) * dReal(layer));
        dGeomSetBody(geom, body);
        boxes.push_back(body);
    }

    const Library& library_;
    const dSpaceID space_ = dHashSpaceCreate(nullptr);
};

class Medians {
  public:
    explicit Medians(int rounds) : rounds_(rounds) {}

    // us.
    template <typename Work>
    double of(Work&& work)
    {
        std::vector<double> times;
        for (int i = 0; i < rounds_; ++i) {
            Stopwatch watch(false);
            work();
            times.push_back(1e3 * watch.lap());
        }
        std::nth_element(times.begin(), times.begin() + rounds_ / 2, times.end());
        return times[std::size_t(rounds_ / 2)];
    }

  private:
    int rounds_;
};

// A frame costs what a step with history takes longer; steps of both kinds alternate in blocks.
void bench_history(Pile& pile, const Library& library, const StateOptions& options)
{
    if (!library.history || !library.roll_back || !library.history_size) return;
    constexpr int kFrames = 60, kRuns = 5;
    double plain = 0, kept = 0;
    for (int run = 0; run < kRuns; ++run) {
        Medians us(options.rounds);
        library.history(pile.world, 0);
        plain += us.of([&] { pile.step(); }) / kRuns;
        library.history(pile.world, kFrames);
        for (int i = 0; i < 2 * kFrames; ++i) pile.step();
        kept += us.of([&] { pile.step(); }) / kRuns;
    }
    const auto bytes = double(library.history_size(pile.world));
    Medians once(1);
    const double back = once.of([&] { library.roll_back(pile.world, 8); });
    fmt::print(
        "us: step {:.0f}, with a history {:.0f}: a frame takes {:.1f} % of a step and {:.0f} bytes; "
        "8 steps taken back {:.1f}\n",
        plain, kept, 100 * (kept - plain) / plain, bytes / (kFrames + 1), back);
    library.history(pile.world, 0);
}

// A chain of links above the ground, with a drive on each hinge.
class Robot {
  public:
    explicit Robot(const Library& library)
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        library.set_space(world, space);
        dCreatePlane(space, 0, 0, 1, 0);
        dDrive drive{};
        drive.struct_size = sizeof drive, drive.stiffness = 100, drive.damping = 5;
        dBodyID before = nullptr;
        for (int i = 0; i < kLinks; ++i) {
            const dBodyID link = dBodyCreate(world);
            dBodySetPosition(link, dReal(0.3) * dReal(i), 0, 1);
            dGeomSetBody(dCreateCapsule(space, dReal(0.05), dReal(0.15)), link);
            if (before) hinge(link, before, dReal(0.3) * dReal(i) - dReal(0.15), drive, library);
            before = link;
        }
        for (int i = 0; i < 60; ++i) dWorldStep(world, dReal(0.01));
    }
    ~Robot() { dWorldDestroy(world), dSpaceDestroy(space); }
    Robot(const Robot&) = delete;
    Robot& operator=(const Robot&) = delete;

    static constexpr int kLinks = 14;
    const dWorldID world = dWorldCreate();
    const dSpaceID space = dSimpleSpaceCreate(nullptr);

  private:
    void hinge(dBodyID a, dBodyID b, dReal x, const dDrive& drive, const Library& library) const
    {
        const dJointID joint = dJointCreateHinge(world, nullptr);
        dJointAttach(joint, a, b);
        dJointSetHingeAnchor(joint, x, 0, 1), dJointSetHingeAxis(joint, 0, 1, 0);
        library.drive(joint, 0, &drive);
    }
};

void bench_robot(const Library& library, const StateOptions& options)
{
    if (!library.clone || !library.drive) return;
    const Robot robot(library);
    std::vector<unsigned char> state(library.size(robot.world));
    library.save(robot.world, state.data(), state.size());
    std::vector<double> times;
    double set = 0;
    for (int i = 0; i < options.rounds; ++i) {
        dSpaceID space = robot.space;
        dWorldID clone = nullptr;
        Medians once(1);
        times.push_back(once.of([&] { clone = library.clone(robot.world, &space, nullptr, 0); }));
        Medians some(9);
        set += some.of([&] { library.load(clone, state.data(), state.size()); }) / options.rounds;
        dWorldDestroy(clone), dSpaceDestroy(space);
    }
    std::nth_element(times.begin(), times.begin() + options.rounds / 2, times.end());
    fmt::print("us: a robot of {} links cloned {:.1f}, given its state of {} bytes {:.2f}\n", Robot::kLinks,
               times[std::size_t(options.rounds / 2)], state.size(), set);
}

}  // namespace

int bench_state(const StateOptions& options)
{
    const Library library;
    if (!library.complete()) {
        fmt::print(stderr, "this libode has no states\n");
        return 1;
    }
    Pile pile(options, library);
    const dWorldID world = pile.world;
    const int count = int(pile.boxes.size());
    std::vector<unsigned char> before(library.size(world)), state;
    library.save(world, before.data(), before.size());
    pile.step();
    state.resize(library.size(world));
    library.save(world, state.data(), state.size());
    const int contacts = library.contacts(world, nullptr, 0);
    fmt::print("{} boxes, {} points that touch: {} bytes, {:.1f} a box\n", count, contacts, state.size(),
               double(state.size()) / count);
    fmt::print("difference to the step before: {} bytes\n",
               library.delta(world, before.data(), before.size(), nullptr, 0));
    Medians us(options.rounds);
    const double step = us.of([&] { pile.step(); });
    // After a step, as a game does it: what is saved has not been looked at since.
    const auto after_step = [&](auto&& work) {
        Medians one(1);
        std::vector<double> times;
        for (int i = 0; i < options.rounds; ++i) pile.step(), times.push_back(one.of(work));
        std::nth_element(times.begin(), times.begin() + options.rounds / 2, times.end());
        return times[std::size_t(options.rounds / 2)];
    };
    std::vector<unsigned char> buffer(2 * state.size());
    const double save = after_step([&] { library.save(world, buffer.data(), buffer.size()); });
    const double load = after_step([&] { library.load(world, state.data(), state.size()); });
    fmt::print("us: step {:.0f}, save {:.1f}, restore {:.1f}, both {:.1f} % of a step\n", step, save, load,
               100 * (save + load) / step);
    const unsigned fields = dStatePosition | dStateQuaternion | dStateLinearVel | dStateAngularVel;
    std::vector<dReal> rows(std::size_t(13 * count));
    const double get = us.of([&] { library.get(pile.boxes.data(), count, fields, rows.data(), 0); });
    const double set = us.of([&] { library.set(pile.boxes.data(), count, fields, rows.data(), 0); });
    bench_history(pile, library, options);
    bench_robot(library, options);
    fmt::print("us: poses and velocities of all read {:.1f}, set {:.1f}\n", get, set);
    return 0;
}

}  // namespace epode::bench
