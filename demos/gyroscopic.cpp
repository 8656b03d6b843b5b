// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A bar in free flight, spun about its middle axis of inertia, turns over again and again (Dzhanibekov),
// while its angular momentum stays. One spun about its long axis next to it does not. Rotation is integrated
// exactly: ODE's way of doing it, the default, is stable but takes energy from such a motion.
#include <ode/ext.h>

#include <cmath>

#include "stage.h"

static dGeomID bars[2];
static int turns = 0;
static double last = 1;
static dVector3 momentum[2];

static void angular_momentum(dGeomID bar, dReal* L)
{
    dMass mass;
    dBodyGetMass(demo::body(bar), &mass);
    const dReal* w = dBodyGetAngularVel(demo::body(bar));
    dVector3 own, spin;
    dBodyVectorFromWorld(demo::body(bar), w[0], w[1], w[2], own);
    dMultiply0_331(spin, mass.I, own);
    dBodyVectorToWorld(demo::body(bar), spin[0], spin[1], spin[2], L);
}

static void build()
{
    dWorldSetGravity(demo::world, 0, 0, 0);
    dWorldSetExactRotation(demo::world, 1);
    for (int i = 0; i < 2; ++i) {
        bars[i] = demo::box(1.2 * i - 0.6, 0, 1, 0.2, 0.8, 0.4);
        dBodySetAngularVel(demo::body(bars[i]), i ? 0 : 0.02, i ? 6 : 0, i ? 0.02 : 6);
        angular_momentum(bars[i], momentum[i]);
    }
}

static void watch(double)
{
    const double up = dBodyGetRotation(demo::body(bars[0]))[10];
    if (std::fabs(up) > 0.8 && up * last < 0) {
        ++turns;
        last = up;
    }
}

static void judge()
{
    demo::claim(turns >= 3, "the bar turned over %d times", turns);
    demo::claim(std::fabs(dBodyGetRotation(demo::body(bars[1]))[5]) > 0.95, "the other left its long axis");
    for (int i = 0; i < 2; ++i) {
        dVector3 now;
        angular_momentum(bars[i], now);
        const double lost =
            dCalcPointsDistance3(now, momentum[i]) / std::sqrt(dCalcVectorDot3(momentum[i], momentum[i]));
        demo::claim(lost < 1e-6, "bar %d lost %g of its momentum", i, lost);
    }
}

int main(int argc, char** argv)
{
    return demo::run(argc, argv, {{0.6f, -2.6f, 1.8f}, {103, -15, 0}, 10, build, judge, watch});
}
