/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The C++ classes of geoms and spaces. They come with ode.h in C++.
 *
 * A wrapper owns one geom or space of the library and destroys it when it goes out of scope. Wrappers cannot
 * be copied. Each member calls the C function of its name, which tells units, frames, defaults and refusals.
 * A wrapper is nothing but the number of its geom: no virtual functions, the size of a pointer. (A space in
 * cleanup mode, which is the default, destroys the geoms in it: let the wrappers of the geoms go first, or
 * call setCleanup(0).) */
#ifndef _ODE_ODECPP_COLLISION_H_
#define _ODE_ODECPP_COLLISION_H_

#include <ode/collision.h>
#include <ode/collision_space.h>

#ifdef __cplusplus

/** What geoms of all classes share. Only the classes below can be made. */
class dGeom {
    dGeom(const dGeom&);
    void operator=(const dGeom&);

  protected:
    dGeomID _id; /**< 0: none */

    dGeom() : _id(0) {}

    /** Give up the geom there is and take this one. */
    void own(dGeomID geom)
    {
        destroy();
        _id = geom;
    }

  public:
    ~dGeom() { destroy(); }

    /** The geom's number, for the C functions; 0: there is none. */
    dGeomID id() const { return _id; }
    operator dGeomID() const { return _id; }

    /** Destroy the geom, if there is one; the wrapper is empty afterwards. */
    void destroy()
    {
        if (_id) {
            dGeomDestroy(_id);
            _id = 0;
        }
    }

    /** dGeomGetClass, dGeomGetSpace, dGeomIsSpace. */
    int getClass() const { return dGeomGetClass(_id); }
    dSpaceID getSpace() const { return dGeomGetSpace(_id); }
    int isSpace() const { return dGeomIsSpace(_id); }

    /** A pointer (data) of the program's, and the body (b) that carries the geom: dGeomSetData, dGeomSetBody.
     */
    void setData(void* data) { dGeomSetData(_id, data); }
    void* getData() const { return dGeomGetData(_id); }
    void setBody(dBodyID b) { dGeomSetBody(_id, b); }
    dBodyID getBody() const { return dGeomGetBody(_id); }

    /** The pose, (x, y, z), R or quat, and the bounding box aabb: dGeomSetPosition, dGeomSetRotation,
        dGeomSetQuaternion, dGeomGetAABB. */
    void setPosition(dReal x, dReal y, dReal z) { dGeomSetPosition(_id, x, y, z); }
    const dReal* getPosition() const { return dGeomGetPosition(_id); }
    void setRotation(const dMatrix3 R) { dGeomSetRotation(_id, R); }
    const dReal* getRotation() const { return dGeomGetRotation(_id); }
    void setQuaternion(const dQuaternion quat) { dGeomSetQuaternion(_id, quat); }
    void getQuaternion(dQuaternion quat) const { dGeomGetQuaternion(_id, quat); }
    void getAABB(dReal aabb[6]) const { dGeomGetAABB(_id, aabb); }

    /** What may collide: bits of dGeomSetCategoryBits and dGeomSetCollideBits; dGeomEnable. */
    void setCategoryBits(unsigned long bits) { dGeomSetCategoryBits(_id, bits); }
    void setCollideBits(unsigned long bits) { dGeomSetCollideBits(_id, bits); }
    unsigned long getCategoryBits() const { return dGeomGetCategoryBits(_id); }
    unsigned long getCollideBits() const { return dGeomGetCollideBits(_id); }
    void enable() { dGeomEnable(_id); }
    void disable() { dGeomDisable(_id); }
    int isEnabled() const { return dGeomIsEnabled(_id); }

    /** Points and directions between geom and world: dGeomGetRelPointPos and its neighbours write result (3
        reals) for the point (px, py, pz) or p. */
    void getRelPointPos(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dGeomGetRelPointPos(_id, px, py, pz, result);
    }
    void getRelPointPos(const dVector3 p, dVector3 result) const { getRelPointPos(p[0], p[1], p[2], result); }
    void getPosRelPoint(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dGeomGetPosRelPoint(_id, px, py, pz, result);
    }
    void getPosRelPoint(const dVector3 p, dVector3 result) const { getPosRelPoint(p[0], p[1], p[2], result); }
    void vectorToWorld(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dGeomVectorToWorld(_id, px, py, pz, result);
    }
    void vectorToWorld(const dVector3 p, dVector3 result) const { vectorToWorld(p[0], p[1], p[2], result); }
    void vectorFromWorld(dReal px, dReal py, dReal pz, dVector3 result) const
    {
        dGeomVectorFromWorld(_id, px, py, pz, result);
    }
    void vectorFromWorld(const dVector3 p, dVector3 result) const
    {
        vectorFromWorld(p[0], p[1], p[2], result);
    }

    /** Collide with the geom or space g: dSpaceCollide2 with data and callback. */
    void collide2(dGeomID g, void* data, dNearCallback* callback) { dSpaceCollide2(_id, g, data, callback); }
};

/** What spaces of all kinds share. */
class dSpace : public dGeom {
  protected:
    dSpace() {}
    /** Give up the space there is and take this one. */
    void own_space(dSpaceID space) { own(reinterpret_cast<dGeomID>(space)); }

  public:
    /** The space's number, for the C functions. */
    dSpaceID id() const { return reinterpret_cast<dSpaceID>(_id); }
    operator dSpaceID() const { return id(); }

    /** Does the space destroy its members (mode)? dSpaceSetCleanup. */
    void setCleanup(int mode) { dSpaceSetCleanup(id(), mode); }
    int getCleanup() const { return dSpaceGetCleanup(id()); }

    /** Members: dSpaceAdd, dSpaceRemove, dSpaceQuery of the geom x; how many; number i. */
    void add(dGeomID x) { dSpaceAdd(id(), x); }
    void remove(dGeomID x) { dSpaceRemove(id(), x); }
    int query(dGeomID x) const { return dSpaceQuery(id(), x); }
    int getNumGeoms() const { return dSpaceGetNumGeoms(id()); }
    dGeomID getGeom(int i) const { return dSpaceGetGeom(id(), i); }

    /** dSpaceCollide with data and callback. */
    void collide(void* data, dNearCallback* callback) { dSpaceCollide(id(), data, callback); }
};

/** A space that tests every pair: dSimpleSpaceCreate. */
class dSimpleSpace : public dSpace {
  public:
    /** Made at once, at the top or inside another space. */
    dSimpleSpace() { own_space(dSimpleSpaceCreate(0)); }
    dSimpleSpace(dSpace& space) { own_space(dSimpleSpaceCreate(space.id())); }
    dSimpleSpace(dSpaceID space) { own_space(dSimpleSpaceCreate(space)); }
};

/** A space for many geoms: dHashSpaceCreate. */
class dHashSpace : public dSpace {
  public:
    /** Made at once, at the top or inside another space. */
    dHashSpace() { own_space(dHashSpaceCreate(0)); }
    dHashSpace(dSpace& space) { own_space(dHashSpaceCreate(space.id())); }
    dHashSpace(dSpaceID space) { own_space(dHashSpaceCreate(space)); }

    /** dHashSpaceSetLevels (minlevel, maxlevel). */
    void setLevels(int minlevel, int maxlevel) { dHashSpaceSetLevels(id(), minlevel, maxlevel); }
};

/** A space over a known region, with its center, half sizes (extents) and depth: dQuadTreeSpaceCreate. */
class dQuadTreeSpace : public dSpace {
  public:
    /** Made at once, at the top or inside another space. */
    dQuadTreeSpace(const dVector3 center, const dVector3 extents, int depth)
    {
        own_space(dQuadTreeSpaceCreate(0, center, extents, depth));
    }
    dQuadTreeSpace(dSpace& space, const dVector3 center, const dVector3 extents, int depth)
    {
        own_space(dQuadTreeSpaceCreate(space.id(), center, extents, depth));
    }
    dQuadTreeSpace(dSpaceID space, const dVector3 center, const dVector3 extents, int depth)
    {
        own_space(dQuadTreeSpaceCreate(space, center, extents, depth));
    }
};

/** A sphere: dCreateSphere. */
class dSphere : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dSphere() {}
    dSphere(dReal radius) { create(0, radius); }
    dSphere(dSpace& space, dReal radius) { create(space.id(), radius); }
    dSphere(dSpaceID space, dReal radius) { create(space, radius); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal radius) { own(dCreateSphere(space, radius)); }

    /** dGeomSphereSetRadius, dGeomSphereGetRadius. */
    void setRadius(dReal radius) { dGeomSphereSetRadius(_id, radius); }
    dReal getRadius() const { return dGeomSphereGetRadius(_id); }
};

/** A box: dCreateBox. */
class dBox : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dBox() {}
    dBox(dReal lx, dReal ly, dReal lz) { create(0, lx, ly, lz); }
    dBox(dSpace& space, dReal lx, dReal ly, dReal lz) { create(space.id(), lx, ly, lz); }
    dBox(dSpaceID space, dReal lx, dReal ly, dReal lz) { create(space, lx, ly, lz); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal lx, dReal ly, dReal lz) { own(dCreateBox(space, lx, ly, lz)); }

    /** dGeomBoxSetLengths; getLengths writes result (3 reals). */
    void setLengths(dReal lx, dReal ly, dReal lz) { dGeomBoxSetLengths(_id, lx, ly, lz); }
    void getLengths(dVector3 result) const { dGeomBoxGetLengths(_id, result); }
};

/** A half-space a x + b y + c z <= d: dCreatePlane. */
class dPlane : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dPlane() {}
    dPlane(dReal a, dReal b, dReal c, dReal d) { create(0, a, b, c, d); }
    dPlane(dSpace& space, dReal a, dReal b, dReal c, dReal d) { create(space.id(), a, b, c, d); }
    dPlane(dSpaceID space, dReal a, dReal b, dReal c, dReal d) { create(space, a, b, c, d); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal a, dReal b, dReal c, dReal d) { own(dCreatePlane(space, a, b, c, d)); }

    /** dGeomPlaneSetParams; getParams writes result (4 reals). */
    void setParams(dReal a, dReal b, dReal c, dReal d) { dGeomPlaneSetParams(_id, a, b, c, d); }
    void getParams(dVector4 result) const { dGeomPlaneGetParams(_id, result); }
};

/** A capsule: dCreateCapsule. */
class dCapsule : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dCapsule() {}
    dCapsule(dReal radius, dReal length) { create(0, radius, length); }
    dCapsule(dSpace& space, dReal radius, dReal length) { create(space.id(), radius, length); }
    dCapsule(dSpaceID space, dReal radius, dReal length) { create(space, radius, length); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal radius, dReal length) { own(dCreateCapsule(space, radius, length)); }

    /** dGeomCapsuleSetParams, dGeomCapsuleGetParams. */
    void setParams(dReal radius, dReal length) { dGeomCapsuleSetParams(_id, radius, length); }
    void getParams(dReal* radius, dReal* length) const { dGeomCapsuleGetParams(_id, radius, length); }
};

/** A cylinder: dCreateCylinder. */
class dCylinder : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dCylinder() {}
    dCylinder(dReal radius, dReal length) { create(0, radius, length); }
    dCylinder(dSpace& space, dReal radius, dReal length) { create(space.id(), radius, length); }
    dCylinder(dSpaceID space, dReal radius, dReal length) { create(space, radius, length); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal radius, dReal length) { own(dCreateCylinder(space, radius, length)); }

    /** dGeomCylinderSetParams, dGeomCylinderGetParams. */
    void setParams(dReal radius, dReal length) { dGeomCylinderSetParams(_id, radius, length); }
    void getParams(dReal* radius, dReal* length) const { dGeomCylinderGetParams(_id, radius, length); }
};

/** A ray: dCreateRay. */
class dRay : public dGeom {
  public:
    /** Without sizes there is no geom yet; else it is made at once, in no space or in the given one. */
    dRay() {}
    dRay(dReal length) { create(0, length); }
    dRay(dSpace& space, dReal length) { create(space.id(), length); }
    dRay(dSpaceID space, dReal length) { create(space, length); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dReal length) { own(dCreateRay(space, length)); }

    /** dGeomRaySetLength, dGeomRayGetLength. */
    void setLength(dReal length) { dGeomRaySetLength(_id, length); }
    dReal getLength() const { return dGeomRayGetLength(_id); }

    /** Start (px, py, pz) and direction (dx, dy, dz): dGeomRaySet; get writes start and dir, 3 reals each. */
    void set(dReal px, dReal py, dReal pz, dReal dx, dReal dy, dReal dz)
    {
        dGeomRaySet(_id, px, py, pz, dx, dy, dz);
    }
    void get(dVector3 start, dVector3 dir) const { dGeomRayGet(_id, start, dir); }

    /** Which hits count: dGeomRaySetFirstContact (firstContact), dGeomRaySetBackfaceCull (backfaceCull),
        dGeomRaySetClosestHit (closestHit). */
    void setParams(int firstContact, int backfaceCull)
    {
        setFirstContact(firstContact);
        setBackfaceCull(backfaceCull);
    }
    void getParams(int* firstContact, int* backfaceCull) const
    {
        *firstContact = getFirstContact();
        *backfaceCull = getBackfaceCull();
    }
    void setBackfaceCull(int backfaceCull) { dGeomRaySetBackfaceCull(_id, backfaceCull); }
    int getBackfaceCull() const { return dGeomRayGetBackfaceCull(_id); }
    void setFirstContact(int firstContact) { dGeomRaySetFirstContact(_id, firstContact); }
    int getFirstContact() const { return dGeomRayGetFirstContact(_id); }
    void setClosestHit(int closestHit) { dGeomRaySetClosestHit(_id, closestHit); }
    int getClosestHit() const { return dGeomRayGetClosestHit(_id); }
};

/* The class wraps deprecated functions and is deprecated with them; only its users are to be told. */
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wdeprecated-declarations"
#elif defined(_MSC_VER)
#pragma warning(push)
#pragma warning(disable : 4996)
#endif

/** A geom placed relative to a body: dCreateGeomTransform. Use offsets instead. */
class ODE_API_DEPRECATED dGeomTransform : public dGeom {
  public:
    /** Without a space there is no geom yet. */
    dGeomTransform() {}
    dGeomTransform(dSpace& space) { create(space.id()); }
    dGeomTransform(dSpaceID space) { create(space); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space = 0) { own(dCreateGeomTransform(space)); }

    /** The geom inside, and the cleanup and info mode: dGeomTransformSetGeom and its neighbours. */
    void setGeom(dGeomID geom) { dGeomTransformSetGeom(_id, geom); }
    dGeomID getGeom() const { return dGeomTransformGetGeom(_id); }
    void setCleanup(int mode) { dGeomTransformSetCleanup(_id, mode); }
    int getCleanup() const { return dGeomTransformGetCleanup(_id); }
    void setInfo(int mode) { dGeomTransformSetInfo(_id, mode); }
    int getInfo() const { return dGeomTransformGetInfo(_id); }
};

#if defined(__GNUC__)
#pragma GCC diagnostic pop
#elif defined(_MSC_VER)
#pragma warning(pop)
#endif

#endif
#endif
