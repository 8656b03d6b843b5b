// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies whose support goes fall, also those that sleep.
#include "measure.h"

#include <algorithm>

namespace epode::trials {

namespace {

constexpr double kTop = 3, kEdge = 0.5;

struct Pile {
    dGeomID platform;
    dBodyID carrier = nullptr;  // of the platform
    std::vector<dBodyID> stacked, alongside, apart;
};

void add_cube(Stage& stage, std::vector<dBodyID>& list, Vec at)
{
    list.push_back(stage.box({kEdge, kEdge, kEdge}, 20, at));
}

// Five cubes on each other and three next to them on a platform; two more 20 m away on the floor.
Pile build(Stage& stage, bool kinematic)
{
    Pile pile;
    pile.platform = stage.block({4, 4, 0.2}, {0, 0, kTop - 0.1});
    if (kinematic) {
        pile.carrier = dBodyCreate(stage.world);
        dBodySetKinematic(pile.carrier);
        dBodySetPosition(pile.carrier, 0, 0, kTop - 0.1);
        dGeomSetBody(pile.platform, pile.carrier);
    }
    stage.floor();
    for (int i = 0; i < 5; ++i) add_cube(stage, pile.stacked, {0, 0, kTop + (i + 0.5) * kEdge});
    for (int i = 0; i < 3; ++i) add_cube(stage, pile.alongside, {1.2, 0.8 * (i - 1), kTop + 0.5 * kEdge});
    for (int i = 0; i < 2; ++i) add_cube(stage, pile.apart, {20, 0, (i + 0.5) * kEdge});
    const auto asleep = [](const std::vector<dBodyID>& list) {
        return std::none_of(list.begin(), list.end(), [](dBodyID body) { return dBodyIsEnabled(body); });
    };
    for (int i = stage.steps_in(stage.setting.sleep ? 10 : 1.5); i-- > 0;) {
        stage.step();
        if (asleep(pile.stacked) && asleep(pile.alongside) && asleep(pile.apart)) break;
    }
    return pile;
}

// A fall of less than the cube that may have gone, and slower than the platform that sinks. Steps take the velocity at their end, and fall
// g t (t + h) / 2.
constexpr double kFallTime = 0.3, kFall = kGravity * kFallTime * kFallTime / 2;
double fall_bound(const Setting& setting) { return 2 + 100 * setting.h() / kFallTime; }

// A bar that hangs from a hinge.
void cut(Run& run)
{
    Stage stage(run);
    stage.floor();
    const dBodyID bar = stage.box({0.1, 0.1, 1}, 2, {0, 0, 2});
    const dJointID hinge = stage.hinge(bar, nullptr, {0, 0, 2.5}, kY);
    stage.advance(2);
    dJointDestroy(hinge);
    stage.advance(kFallTime);
    run.record("fall", 100 * std::fabs((2 - position(bar).z) / kFall - 1));
}

enum class Loss { kDestroyed, kMoved, kSensor, kBits, kShrunk, kSinks, kLowest, kGravity };

void take_away(Stage& stage, Pile& pile, Loss loss)
{
    switch (loss) {
        case Loss::kDestroyed:
            dGeomDestroy(pile.platform);
            break;
        case Loss::kMoved:
            dGeomSetPosition(pile.platform, 10, 0, kTop - 0.1);
            break;
        case Loss::kSensor:
            dGeomSetSensor(pile.platform, 1);
            break;
        case Loss::kBits:
            dGeomSetCategoryBits(pile.platform, 0), dGeomSetCollideBits(pile.platform, 0);
            break;
        case Loss::kShrunk:
            dGeomBoxSetLengths(pile.platform, 0.1, 0.1, 0.1);
            break;
        case Loss::kSinks:
            dBodySetLinearVel(pile.carrier, 0, 0, -2);
            break;
        case Loss::kLowest:
            dGeomDestroy(dBodyGetFirstGeom(pile.stacked[0]));
            dBodyDestroy(pile.stacked[0]);
            pile.stacked.erase(pile.stacked.begin());
            break;
        case Loss::kGravity:
            dWorldSetGravity(stage.world, 0, 0, kGravity);
            break;
    }
}

void lose(Run& run, Loss loss)
{
    Stage stage(run);
    stage.surface.friction = 0.6;
    Pile pile = build(stage, loss == Loss::kSinks);
    std::vector<Vec> start, other;
    const bool sleeps = pile.apart.size() && !dBodyIsEnabled(pile.apart[0]);
    take_away(stage, pile, loss);
    std::vector<dBodyID> falling = pile.stacked;
    if (loss != Loss::kLowest) falling.insert(falling.end(), pile.alongside.begin(), pile.alongside.end());
    for (dBodyID body : falling) start.push_back(position(body));
    int steps = 0;
    stage.advance(kFallTime, [&] {
        if (++steps == 2)
            for (dBodyID body : falling) run.record("woken", dBodyIsEnabled(body) ? 0 : 1);
        if (!sleeps || loss == Loss::kGravity) return;
        for (dBodyID body : pile.apart) run.record("apart", dBodyIsEnabled(body) ? 1 : 0);
        if (loss == Loss::kLowest)
            for (dBodyID body : pile.alongside) run.record("apart", dBodyIsEnabled(body) ? 1 : 0);
    });
    const double right = loss == Loss::kGravity ? -kFall : kFall;
    for (size_t i = 0; i < falling.size(); ++i) {
        // The small platform still carries what stands over it, 0.05 m lower; the stack then falls askew.
        if (loss == Loss::kShrunk && i < pile.stacked.size()) continue;
        const double fell = start[i].z - position(falling[i]).z;
        run.record("fall", 100 * std::fabs(fell / right - 1));
    }
}

void lose_all(Run& run)
{
    run.record("apart", 0);
    for (Loss loss : {Loss::kDestroyed, Loss::kMoved, Loss::kSensor, Loss::kBits, Loss::kShrunk, Loss::kSinks,
                      Loss::kLowest, Loss::kGravity})
        lose(run, loss);
    cut(run);
}

constexpr const char* kUnaware =
    "With contact joints the world does not know what lies on what, and nothing wakes a body "
    "(guide/sleeping.md)";

}  // namespace

extern const Scene kLostSupport{
    "Rest",
    "lost_support",
    "a pile on a platform that is destroyed, moved, made a sensor, loses its bits, shrinks or sinks; a cube "
    "below others is "
    "destroyed; gravity turns; a hinge is cut (C19)",
    {{"woken", "bodies that sleep two steps later", "1", 0, {{kCallback, 1, kUnaware}}},
     {"fall", "fall in 0.3 s, off g t^2 / 2", "%", &fall_bound, {{kCallback, 100, kUnaware}}},
     {"apart", "bodies that wake though they lie elsewhere", "1", 0}},
    &lose_all};

}  // namespace epode::trials
