// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A rod on a hinge swings by a small angle: its period is 2 pi sqrt(I / (m g d)), here with I = I_c + m d^2
// about the hinge and d from the hinge to the centre. Measured between the first and the fifth passage.
#include <ode/ode.h>

#include <cmath>
#include <iostream>

int main()
{
    constexpr double kLength = 1, kWidth = 0.02, kStep = 1e-3;
    dInitODE2(0);
    const dWorldID world = dWorldCreate();
    dWorldSetGravity(world, 0, 0, REAL(-9.81));
    const dBodyID rod = dBodyCreate(world);
    dMass mass;
    dMassSetBoxTotal(&mass, 2, dReal(kWidth), dReal(kWidth), dReal(kLength));
    dBodySetMass(rod, &mass);
    dBodySetPosition(rod, 0, 0, dReal(-kLength / 2));
    const dJointID hinge = dJointCreateHinge(world, 0);
    dJointAttach(hinge, rod, 0);
    dJointSetHingeAnchor(hinge, 0, 0, 0);
    dJointSetHingeAxis(hinge, 0, 1, 0);
    dBodySetAngularVel(rod, 0, REAL(0.1), 0);
    dBodySetLinearVel(rod, dReal(-0.1 * kLength / 2), 0, 0);

    int passages = 0;
    double first = 0, last = 0, before = 0;
    for (int i = 0; i < 10000 && passages < 5; ++i) {
        dWorldStep(world, dReal(kStep));
        const double angle = dJointGetHingeAngle(hinge);
        if (i > 0 && before * angle < 0) {
            last = (i - angle / (angle - before)) * kStep;
            if (passages++ == 0) first = last;
        }
        before = angle;
    }
    dWorldDestroy(world);
    dCloseODE();

    const double inertia = (kLength * kLength + kWidth * kWidth) / 12 + kLength * kLength / 4;
    const double wanted = 2 * M_PI * std::sqrt(inertia / (9.81 * kLength / 2));
    const double period = (last - first) / 2;
    std::cout << "pendulum: period " << period << " s, wanted " << wanted << ", reals of " << sizeof(dReal)
              << '\n';
    return passages == 5 && std::abs(period - wanted) < 2e-3 * wanted ? 0 : 1;
}
