// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// All dMass functions on random sizes, and chains of translate, rotate, add and adjust.
#include "rig.h"

namespace parity {
namespace {

void put_mass(Output& out, const std::string& key, const dMass& m)
{
    out.put(key + ".mass", {m.mass});
    out.put(key + ".centre", m.c, 3);
    out.put_matrix3(key + ".inertia", m.I);
}

void put_shapes(Output& out, Random& random)
{
    dMass m;
    const double density = random.range(0.1, 10), x = random.range(0.1, 2), y = random.range(0.1, 2),
                 z = random.range(0.1, 2);
    dMassSetZero(&m);
    put_mass(out, "zero", m);
    dMassSetSphere(&m, density, x);
    put_mass(out, "sphere", m);
    dMassSetSphereTotal(&m, density, x);
    put_mass(out, "sphere-total", m);
    dMassSetBox(&m, density, x, y, z);
    put_mass(out, "box", m);
    dMassSetBoxTotal(&m, density, x, y, z);
    put_mass(out, "box-total", m);
    for (int direction = 1; direction <= 3; ++direction) {
        const std::string d = std::to_string(direction);
        dMassSetCapsule(&m, density, direction, x, y);
        put_mass(out, "capsule" + d, m);
        dMassSetCapsuleTotal(&m, density, direction, x, y);
        put_mass(out, "capsule-total" + d, m);
        dMassSetCylinder(&m, density, direction, x, y);
        put_mass(out, "cylinder" + d, m);
        dMassSetCylinderTotal(&m, density, direction, x, y);
        put_mass(out, "cylinder-total" + d, m);
    }
}

void put_chain(Output& out, Random& random)
{
    dMass sum, part;
    dMassSetBox(&sum, random.range(0.5, 3), random.range(0.2, 1), random.range(0.2, 1), random.range(0.2, 1));
    for (int i = 0; i < 4; ++i) {
        dMassSetCapsule(&part, random.range(0.5, 3), 1 + random.below(3), random.range(0.1, 0.5),
                        random.range(0.1, 1));
        const Vec3 t = random.in_cube(2), axis = random.direction();
        dMatrix3 R = {0};
        dRFromAxisAndAngle(R, axis.x, axis.y, axis.z, random.range(-3, 3));
        dMassRotate(&part, R);
        put_mass(out, "rotated" + std::to_string(i), part);
        dMassTranslate(&part, t.x, t.y, t.z);
        put_mass(out, "translated" + std::to_string(i), part);
        dMassAdd(&sum, &part);
        put_mass(out, "added" + std::to_string(i), sum);
    }
    const dMatrix3 cycle = {0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0};
    dMassRotate(&sum, cycle);
    put_mass(out, "turned", sum);
    dMassAdjust(&sum, random.range(0.1, 9));
    put_mass(out, "adjusted", sum);
    dMassTranslate(&sum, -sum.c[0], -sum.c[1], -sum.c[2]);
    put_mass(out, "centred", sum);
    out.put("check", {static_cast<double>(dMassCheck(&sum))});
}

PARITY_CASE(mass_shapes)
{
    for (int i = 0; i < 20; ++i) {
        out.open_block("t" + std::to_string(i));
        put_shapes(out, rng);
    }
}

PARITY_CASE(mass_chains)
{
    for (int i = 0; i < 20; ++i) {
        out.open_block("t" + std::to_string(i));
        put_chain(out, rng);
    }
}

PARITY_CASE(mass_check)
{
    for (int i = 0; i < 100; ++i) {
        dMass m;
        dMassSetParameters(&m, rng.range(-0.2, 2), rng.range(-1, 1), rng.range(-1, 1), rng.range(-1, 1),
                           rng.range(-0.2, 4), rng.range(-0.2, 4), rng.range(-0.2, 4), rng.range(-1, 1),
                           rng.range(-1, 1), rng.range(-1, 1));
        out.put("valid" + std::to_string(i), {static_cast<double>(dMassCheck(&m))});
    }
}

}  // namespace
}  // namespace parity
