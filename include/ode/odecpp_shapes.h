/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The C++ classes of shapes beyond ODE's (ode/shapes.h), as those of odecpp_collision.h. A program that
 * includes this file depends on this library. */
#ifndef _ODE_ODECPP_SHAPES_H_
#define _ODE_ODECPP_SHAPES_H_

#include <ode/odecpp_collision.h>
#include <ode/shapes.h>

#ifdef __cplusplus

/** A cone: dCreateCone. */
class dCone : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dCone() {}
    dCone(dReal radius, dReal length) { create(0, radius, length); }
    dCone(dSpace& space, dReal radius, dReal length) { create(space.id(), radius, length); }
    dCone(dSpaceID space, dReal radius, dReal length) { create(space, radius, length); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal radius, dReal length) { own(dCreateCone(space, radius, length)); }

    /** dGeomConeSetParams, dGeomConeGetParams. */
    void setParams(dReal radius, dReal length) { dGeomConeSetParams(_id, radius, length); }
    void getParams(dReal* radius, dReal* length) const { dGeomConeGetParams(_id, radius, length); }
};

/** An ellipsoid: dCreateEllipsoid. */
class dEllipsoid : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dEllipsoid() {}
    dEllipsoid(dReal rx, dReal ry, dReal rz) { create(0, rx, ry, rz); }
    dEllipsoid(dSpace& space, dReal rx, dReal ry, dReal rz) { create(space.id(), rx, ry, rz); }
    dEllipsoid(dSpaceID space, dReal rx, dReal ry, dReal rz) { create(space, rx, ry, rz); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal rx, dReal ry, dReal rz) { own(dCreateEllipsoid(space, rx, ry, rz)); }

    /** dGeomEllipsoidSetRadii, dGeomEllipsoidGetRadii. */
    void setRadii(dReal rx, dReal ry, dReal rz) { dGeomEllipsoidSetRadii(_id, rx, ry, rz); }
    void getRadii(dVector3 result) const { dGeomEllipsoidGetRadii(_id, result); }
};

/** A tapered capsule: dCreateTaperedCapsule. */
class dTaperedCapsule : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dTaperedCapsule() {}
    dTaperedCapsule(dReal r1, dReal r2, dReal length) { create(0, r1, r2, length); }
    dTaperedCapsule(dSpace& space, dReal r1, dReal r2, dReal length) { create(space.id(), r1, r2, length); }
    dTaperedCapsule(dSpaceID space, dReal r1, dReal r2, dReal length) { create(space, r1, r2, length); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal r1, dReal r2, dReal length)
    {
        own(dCreateTaperedCapsule(space, r1, r2, length));
    }

    /** dGeomTaperedCapsuleSetParams, dGeomTaperedCapsuleGetParams. */
    void setParams(dReal r1, dReal r2, dReal length) { dGeomTaperedCapsuleSetParams(_id, r1, r2, length); }
    void getParams(dReal* r1, dReal* r2, dReal* length) const
    {
        dGeomTaperedCapsuleGetParams(_id, r1, r2, length);
    }
};

#endif
#endif
