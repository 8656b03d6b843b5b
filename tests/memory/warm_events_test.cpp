// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Events and energy ledgers ask for no memory in warm steps.
#include "heap.h"
#include "ode/ext.h"

namespace epode::memory {
namespace {

struct Balls {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);

    Balls()
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world, space);
        dCreatePlane(space, 0, 0, 1, 0);
        dMaterial rubber;
        dMaterialInit(&rubber, sizeof rubber);
        rubber.bounce = 1, rubber.bounce_speed = 0;
        for (int i = 0; i < 20; ++i) {
            const dBodyID body = dBodyCreate(world);
            const dGeomID geom = dCreateSphere(space, dReal(0.2));
            dGeomSetBody(geom, body);
            dGeomSetMaterial(geom, &rubber);
            dBodySetPosition(body, i, 0, 2);  // all hit at once: the first bounce has the most events
        }
        const dGeomID gate = dCreateBox(space, 100, 1, dReal(0.5));
        dGeomSetPosition(gate, 0, 0, 1);
        dGeomSetSensor(gate, 1);
    }
    ~Balls()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
    }
    bool set(unsigned kinds) const
    {
        dEventSettings settings;
        dEventSettingsInit(&settings, sizeof settings);
        settings.kinds = kinds;
        return dWorldSetEventSettings(world, &settings) == 1;
    }
};

TEST(Warm, events_ask_for_no_memory)
{
    const Library library;
    const Balls balls;
    ASSERT_TRUE(balls.set(63));
    ASSERT_EQ(dWorldSetEnergyLedgerMode(balls.world, 1), 1);
    for (int i = 0; i < 400; ++i) dWorldQuickStep(balls.world, dReal(0.01));
    Heap::count();
    int events = 0;
    for (int i = 0; i < 200; ++i) {
        dWorldQuickStep(balls.world, dReal(0.01));
        events += dWorldGetEvents(balls.world, nullptr, 0);
    }
    EXPECT_EQ(Heap::asked(), 0);
    EXPECT_GT(events, 50);
}

}  // namespace
}  // namespace epode::memory
