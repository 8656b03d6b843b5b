// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world with one fluid, and bodies in it.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "ode/ext.h"
#include "ode/ode.h"
#include "rig.h"

namespace epode::physics {

constexpr double kWaterDensity = 1000, kG = 9.81;

struct Pool {
    dWorldID world = dWorldCreate();
    dSpaceID space = dHashSpaceCreate(nullptr);
    dFluidID fluid = dFluidCreate(world);

    Pool()
    {
        dWorldSetGravity(world, 0, 0, real(-kG));
        still();
    }
    ~Pool()
    {
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }
    Pool(const Pool&) = delete;
    Pool& operator=(const Pool&) = delete;

    void drag(double quadratic, double linear, double angular) const
    {
        dFluidSettings s;
        dFluidSettingsInit(&s, sizeof s);
        s.drag = real(quadratic), s.linear_drag = real(linear), s.angular_drag = real(angular);
        dFluidSetSettings(fluid, &s);
    }
    void still() const { drag(0, 0, 0); }

    // On the geom, with a uniform mass of that density; the geom's centre is at height z.
    dBodyID body(dGeomID geom, const dMass& mass, double z) const
    {
        const dBodyID made = dBodyCreate(world);
        dBodySetMass(made, &mass);
        dGeomSetBody(geom, made);
        dBodySetPosition(made, 0, 0, real(z));
        return made;
    }
    dBodyID box(double x, double y, double z, double density, double height) const
    {
        dMass m;
        dMassSetBox(&m, real(density), real(x), real(y), real(z));
        return body(dCreateBox(space, real(x), real(y), real(z)), m, height);
    }
    dBodyID ball(double radius, double density, double height) const
    {
        dMass m;
        dMassSetSphere(&m, real(density), real(radius));
        return body(dCreateSphere(space, real(radius)), m, height);
    }
    void run(double time, double h) const
    {
        for (int i = 0; i < int(time / h + 0.5); ++i) ASSERT_EQ(dWorldQuickStep(world, real(h)), 1);
    }
};

inline double height(dBodyID body) { return double(dBodyGetPosition(body)[2]); }

}  // namespace epode::physics
