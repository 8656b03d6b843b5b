/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * Mass, centre of mass and inertia of a rigid body, and the arithmetic on them.
 * The inertia tensor I is taken about the body's origin (not about the centre of mass c), in body axes.
 * For a body, c must be at the origin: translate by -c before dBodySetMass.
 * Units: density kg/m^3, lengths m, mass kg, inertia kg m^2.
 * Setters check their result and report a mass that no real body can have through
 * the message handler; dMassCheck asks without changing anything. */
#ifndef _ODE_MASS_H_
#define _ODE_MASS_H_

#include <ode/common.h>

#ifdef __cplusplus
extern "C" {
#endif

/** @chapter mass Mass of a body

    Mass, centre of mass and inertia of shapes, and the arithmetic on them. All shapes have their centre
    at the origin.

    A result that no real body can have is stored, with a message.

    Arguments:
    - m: the mass to write or to change.
    - density: kg/m^3.
    - total_mass: kg.
    - direction: 1, 2, 3 for an axis along x, y, z.
    - radius, length: m.
    - lx, ly, lz: full side lengths, m.

    Refused: null pointers; numbers that are not finite; [dMassSetCapsule, dMassSetCylinder,
    dMassSetCappedCylinder] another direction than 1, 2 or 3 (x, y or z). */

struct dMass;
typedef struct dMass dMass;

/** 1 when the mass *m is positive and both I and the inertia about the centre of mass are positive
    definite, else 0 with a message. [0.16] */
ODE_API int dMassCheck(const dMass* m);

/** Set everything to zero. [guide] */
ODE_API void dMassSetZero(dMass* m);

/** Give all values: the mass themass (kg), the centre (cgx, cgy, cgz), m, and the six different elements
    I11, I22, I33, I12, I13, I23 of the inertia about the origin, kg m^2. [0.16] */
ODE_API void dMassSetParameters(dMass* m, dReal themass, dReal cgx, dReal cgy, dReal cgz, dReal I11,
                                dReal I22, dReal I33, dReal I12, dReal I13, dReal I23);

/** - dMassSetSphere: Set *m to a full sphere of this radius, m, and density, kg/m^3: mass 4/3 pi r^3 times
      the density, I = 2/5 of the mass times r^2.
    - dMassSetSphereTotal: Set *m to a full sphere of this radius, m, that weighs total_mass, kg: I = 2/5
      total_mass r^2. [guide] */
ODE_API void dMassSetSphere(dMass* m, dReal density, dReal radius);
ODE_API void dMassSetSphereTotal(dMass* m, dReal total_mass, dReal radius);

/** The length is that of the cylindrical part, without the caps.
    - dMassSetCapsule: Set *m to a full capsule of this density, kg/m^3, radius and length, m, with its axis
      along direction.
    - dMassSetCapsuleTotal: Set *m to a full capsule that weighs total_mass, kg, of this radius and length,
      m, with its axis along direction. [0.16] */
ODE_API void dMassSetCapsule(dMass* m, dReal density, int direction, dReal radius, dReal length);
ODE_API void dMassSetCapsuleTotal(dMass* m, dReal total_mass, int direction, dReal radius, dReal length);

/** - dMassSetCylinder: Set *m to a full cylinder with flat ends of this density, kg/m^3, radius and length,
      m, with its axis along direction.
    - dMassSetCylinderTotal: Set *m to a full cylinder with flat ends that weighs total_mass, kg, of this
      radius and length, m, with its axis along direction. [guide] */
ODE_API void dMassSetCylinder(dMass* m, dReal density, int direction, dReal radius, dReal length);
ODE_API void dMassSetCylinderTotal(dMass* m, dReal total_mass, int direction, dReal radius, dReal length);

/** - dMassSetBox: Set *m to a full box of this density, kg/m^3, with the full side lengths lx, ly, lz, m.
    - dMassSetBoxTotal: Set *m to a full box that weighs total_mass, kg, with the full side lengths lx, ly,
      lz, m. [guide] */
ODE_API void dMassSetBox(dMass* m, dReal density, dReal lx, dReal ly, dReal lz);
ODE_API void dMassSetBoxTotal(dMass* m, dReal total_mass, dReal lx, dReal ly, dReal lz);

/** The mass is that of what the triangles enclose, as the mesh stands in the world: the centre is written as
    it is, and the inertia is that about the world's origin; translate by minus the centre for a body. The
    integrals are exact for a closed mesh whose fronts are outside. An open mesh is taken to be closed by
    cones over its border, from the first corner of its triangle 0. Refused: a geom without triangles;
    triangles that enclose nothing.
    - dMassSetTrimesh: Set *m to the solid that the triangles of the mesh g enclose, filled with density,
      kg/m^3. A mesh that is turned inside out has a negative mass.
    - dMassSetTrimeshTotal: Set *m to the solid that the triangles of the mesh g enclose and that weighs
      total_mass, kg. [0.16] */
ODE_API void dMassSetTrimesh(dMass* m, dReal density, dGeomID g);
ODE_API void dMassSetTrimeshTotal(dMass* m, dReal total_mass, dGeomID g);

/** Scale mass and inertia to the mass newmass (kg); the centre stays. A mass of 0 cannot be scaled:
    refused. [0.16] */
ODE_API void dMassAdjust(dMass* m, dReal newmass);

/** Move the material by (x, y, z), m, relative to the origin: the centre moves along and I is taken about
    the same origin as before. [0.16] */
ODE_API void dMassTranslate(dMass* m, dReal x, dReal y, dReal z);

/** Turn the material about the origin by the rotation matrix R: I becomes R I R^T, c becomes R c. [0.16] */
ODE_API void dMassRotate(dMass* m, const dMatrix3 R);

/** *a becomes the union of *a and *b, which must be given about the same origin and in the same axes.
    [0.16] */
ODE_API void dMassAdd(dMass* a, const dMass* b);

/** - dMassSetCappedCylinder: Old name of dMassSetCapsule: a capsule of this density, kg/m^3, radius and
      length of its cylindrical part, m, with its axis along direction.
    - dMassSetCappedCylinderTotal: Old name of dMassSetCapsuleTotal: a capsule that weighs total_mass, kg, of
      this radius and length of its cylindrical part, m, with its axis along direction. [guide] */
ODE_API_DEPRECATED ODE_API void dMassSetCappedCylinder(dMass* m, dReal density, int direction, dReal radius,
                                                       dReal length);
ODE_API_DEPRECATED ODE_API void dMassSetCappedCylinderTotal(dMass* m, dReal total_mass, int direction,
                                                            dReal radius, dReal length);

/** The mass itself. In C++ it has members that call the functions above and starts as zero; the layout is
    the same as in C. */
struct dMass {
    dReal mass; /**< kg */
    dVector3 c; /**< centre of mass, body frame, m */
    dMatrix3 I; /**< inertia about the body's origin, body axes, kg m^2 */

#ifdef __cplusplus
    /** A mass of zero; each member calls the dMass... function of its name. */
    dMass() { dMassSetZero(this); }
    void setZero() { dMassSetZero(this); }
    void setParameters(dReal themass, dReal cgx, dReal cgy, dReal cgz, dReal I11, dReal I22, dReal I33,
                       dReal I12, dReal I13, dReal I23)
    {
        dMassSetParameters(this, themass, cgx, cgy, cgz, I11, I22, I33, I12, I13, I23);
    }
    void setSphere(dReal density, dReal radius) { dMassSetSphere(this, density, radius); }
    void setSphereTotal(dReal total, dReal radius) { dMassSetSphereTotal(this, total, radius); }
    void setCapsule(dReal density, int direction, dReal radius, dReal length)
    {
        dMassSetCapsule(this, density, direction, radius, length);
    }
    void setCapsuleTotal(dReal total, int direction, dReal radius, dReal length)
    {
        dMassSetCapsuleTotal(this, total, direction, radius, length);
    }
    void setCylinder(dReal density, int direction, dReal radius, dReal length)
    {
        dMassSetCylinder(this, density, direction, radius, length);
    }
    void setCylinderTotal(dReal total, int direction, dReal radius, dReal length)
    {
        dMassSetCylinderTotal(this, total, direction, radius, length);
    }
    void setBox(dReal density, dReal lx, dReal ly, dReal lz) { dMassSetBox(this, density, lx, ly, lz); }
    void setBoxTotal(dReal total, dReal lx, dReal ly, dReal lz) { dMassSetBoxTotal(this, total, lx, ly, lz); }
    void setTrimesh(dReal density, dGeomID g) { dMassSetTrimesh(this, density, g); }
    void setTrimeshTotal(dReal total, dGeomID g) { dMassSetTrimeshTotal(this, total, g); }
    void adjust(dReal newmass) { dMassAdjust(this, newmass); }
    void translate(dReal x, dReal y, dReal z) { dMassTranslate(this, x, y, z); }
    void rotate(const dMatrix3 R) { dMassRotate(this, R); }
    void add(const dMass* b) { dMassAdd(this, b); }
#endif
};

#ifdef __cplusplus
}
#endif

#endif
