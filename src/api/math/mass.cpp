// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dMass for clients. Null, non-finite and absurd arguments are refused and change nothing. Numbers that are
// finite but belong to no rigid body (zero volume, negative mass) are stored and commented upon
// by dMassCheck's message, as in ODE: clients build hollow solids by adding a negative one; dBodySetMass is
// where such a mass is stopped. The mesh setters live with the mesh geom (collide/types).
#include "ode/mass.h"

#include "base/check.h"
#include "base/float_environment.h"
#include "base/messages.h"
#include "geometry/inertia.h"

namespace epode {
namespace {

constexpr const char* kBadDirection = "bad direction number";

MassProperties properties_of(const dMass& m) { return {m.mass, load(m.c), symmetric_part(load_mat(m.I))}; }

bool check_and_report(const MassProperties& p)
{
    static constexpr const char* kTexts[] = {"", "mass must be > 0", "inertia must be positive definite",
                                             "center of mass inconsistent with mass parameters"};
    const MassFault fault = mass_fault(p);
    if (fault == MassFault::kNone) return true;
    note(d_ERR_UASSERT, "%s in dMassCheck()", kTexts[int(fault)]);
    return false;
}

void put(dMass* m, const MassProperties& p)
{
    m->mass = p.mass;
    store(m->c, p.center);
    m->c[3] = 0;
    store_mat(m->I, full(p.inertia));
}

void put_and_check(dMass* m, const MassProperties& p)
{
    put(m, p);
    check_and_report(p);
}

bool is_direction(int direction) { return direction >= 1 && direction <= 3; }

}  // namespace
}  // namespace epode

using namespace epode;

extern "C" int dMassCheck(const dMass* m)
{
    const FloatEnvironment floats;
    EPODE_USER(m, 0);
    return check_and_report(properties_of(*m));
}

extern "C" void dMassSetZero(dMass* m)
{
    EPODE_USER(m);
    put(m, {});
}

extern "C" void dMassSetParameters(dMass* m, dReal themass, dReal cgx, dReal cgy, dReal cgz, dReal I11,
                                   dReal I22, dReal I33, dReal I12, dReal I13, dReal I23)
{
    const FloatEnvironment floats;
    const MassProperties p = {themass, {cgx, cgy, cgz}, {I11, I22, I33, I12, I13, I23}};
    EPODE_USER(m && usable(p));
    put_and_check(m, p);
}

extern "C" void dMassSetSphere(dMass* m, dReal density, dReal radius)
{
    const FloatEnvironment floats;
    const MassProperties p = solid_sphere(density * sphere_volume(radius), radius);
    EPODE_USER(m && usable(p));
    put_and_check(m, p);
}

extern "C" void dMassSetSphereTotal(dMass* m, dReal total_mass, dReal radius)
{
    const FloatEnvironment floats;
    const MassProperties p = solid_sphere(total_mass, radius);
    EPODE_USER(m && usable(p));
    put_and_check(m, p);
}

extern "C" void dMassSetBox(dMass* m, dReal density, dReal lx, dReal ly, dReal lz)
{
    const FloatEnvironment floats;
    const MassProperties p = solid_box(density * box_volume({lx, ly, lz}), {lx, ly, lz});
    EPODE_USER(m && usable(p));
    put_and_check(m, p);
}

extern "C" void dMassSetBoxTotal(dMass* m, dReal total_mass, dReal lx, dReal ly, dReal lz)
{
    const FloatEnvironment floats;
    const MassProperties p = solid_box(total_mass, {lx, ly, lz});
    EPODE_USER(m && usable(p));
    put_and_check(m, p);
}

extern "C" void dMassSetCylinder(dMass* m, dReal density, int direction, dReal radius, dReal length)
{
    const FloatEnvironment floats;
    EPODE_USER_SAY(is_direction(direction), kBadDirection);
    const Real mass = density * cylinder_volume(radius, length);
    const MassProperties p = solid_cylinder(mass, direction - 1, radius, length);
    EPODE_USER(m && usable(p));
    put_and_check(m, p);
}

extern "C" void dMassSetCylinderTotal(dMass* m, dReal total_mass, int direction, dReal radius, dReal length)
{
    const FloatEnvironment floats;
    EPODE_USER_SAY(is_direction(direction), kBadDirection);
    const MassProperties p = solid_cylinder(total_mass, direction - 1, radius, length);
    EPODE_USER(m && usable(p));
    put_and_check(m, p);
}

// The capsule's functions and their old names, each of which names itself in a refusal.
#define MASS_CAPSULE(Name)                                                                             \
    extern "C" void dMassSet##Name(dMass* m, dReal density, int direction, dReal radius, dReal length) \
    {                                                                                                  \
        const FloatEnvironment floats;                                                                 \
        EPODE_USER_SAY(is_direction(direction), kBadDirection);                                        \
        const Real mass = density * capsule_volume(radius, length);                                    \
        const MassProperties p = solid_capsule(mass, direction - 1, radius, length);                   \
        EPODE_USER(m&& usable(p));                                                                     \
        put_and_check(m, p);                                                                           \
    }                                                                                                  \
    extern "C" void dMassSet##Name##Total(dMass* m, dReal total_mass, int direction, dReal radius,     \
                                          dReal length)                                                \
    {                                                                                                  \
        const FloatEnvironment floats;                                                                 \
        EPODE_USER_SAY(is_direction(direction), kBadDirection);                                        \
        const MassProperties p = solid_capsule(total_mass, direction - 1, radius, length);             \
        EPODE_USER(m&& usable(p));                                                                     \
        put_and_check(m, p);                                                                           \
    }

MASS_CAPSULE(Capsule)
MASS_CAPSULE(CappedCylinder)

extern "C" void dMassAdjust(dMass* m, dReal newmass)
{
    const FloatEnvironment floats;
    EPODE_USER(m);
    const MassProperties p = with_mass(properties_of(*m), newmass);
    EPODE_USER(usable(p));  // also a mass of zero, which nothing can be scaled from
    put_and_check(m, p);
}

extern "C" void dMassTranslate(dMass* m, dReal x, dReal y, dReal z)
{
    const FloatEnvironment floats;
    EPODE_USER(m);
    const MassProperties p = translated(properties_of(*m), {x, y, z});
    EPODE_USER(usable(p));
    put_and_check(m, p);
}

extern "C" void dMassRotate(dMass* m, const dMatrix3 R)
{
    const FloatEnvironment floats;
    EPODE_USER(m && R);
    const MassProperties p = rotated(properties_of(*m), load_mat(R));
    EPODE_USER(usable(p));
    put_and_check(m, p);
}

extern "C" void dMassAdd(dMass* a, const dMass* b)
{
    const FloatEnvironment floats;
    EPODE_USER(a && b);
    const MassProperties p = united(properties_of(*a), properties_of(*b));
    EPODE_USER(usable(p));
    put(a, p);
}
