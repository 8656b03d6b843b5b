// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// dGeom with the classes of shapes, dSpace with its kinds, member by member.
#include <string>

#include "twins.h"

// Debian's headers have no such shapes.
#if __has_include(<ode/odecpp_shapes.h>)
#include <ode/odecpp_shapes.h>
#define HAVE_MORE_SHAPES
#endif

namespace {

Numbers read_geom(dGeomID g)
{
    Numbers n;
    dQuaternion q = {0, 0, 0, 0};
    append(n, dGeomGetPosition(g), 3);
    append(n, dGeomGetRotation(g), 12);
    dGeomGetQuaternion(g, q);
    append(n, q, 4);
    n.push_back(dGeomGetClass(g));
    n.push_back(dGeomGetBody(g) != 0);
    n.push_back(dGeomGetSpace(g) != 0);
    n.push_back(dGeomGetData(g) != 0);
    n.push_back(double(dGeomGetCategoryBits(g)));
    n.push_back(double(dGeomGetCollideBits(g)));
    n.push_back(dGeomIsEnabled(g));
    return n;
}

void count_pairs(void* data, dGeomID, dGeomID) { ++*static_cast<int*>(data); }

void test_pose(dGeom& a, dGeomID b)
{
    const dQuaternion q = {REAL(0.5), REAL(0.5), REAL(-0.5), REAL(0.5)};
    dMatrix3 R;
    dRFromAxisAndAngle(R, 1, 2, 3, REAL(0.75));
    SET("dGeom::setPosition", read_geom, a, b, a.setPosition(1, 2, 3), dGeomSetPosition(b, 1, 2, 3));
    SET("dGeom::setQuaternion", read_geom, a, b, a.setQuaternion(q), dGeomSetQuaternion(b, q));
    SET("dGeom::setRotation", read_geom, a, b, a.setRotation(R), dGeomSetRotation(b, R));
    judge_get("dGeom::getPosition", a.getPosition()[2], dGeomGetPosition(b)[2]);
    judge_get("dGeom::getRotation", a.getRotation()[1], dGeomGetRotation(b)[1]);
    GET_ARRAY("dGeom::getQuaternion", 4, a.getQuaternion(out), dGeomGetQuaternion(b, out));
    GET_ARRAY("dGeom::getAABB", 6, a.getAABB(out), dGeomGetAABB(b, out));
}

void test_points(dGeom& a, dGeomID b)
{
    const dVector3 p = {1, 2, 3, 0};
    GET_ARRAY("dGeom::getRelPointPos", 3, a.getRelPointPos(1, 2, 3, out),
              dGeomGetRelPointPos(b, 1, 2, 3, out));
    GET_ARRAY("dGeom::getRelPointPos array", 3, a.getRelPointPos(p, out),
              dGeomGetRelPointPos(b, 1, 2, 3, out));
    GET_ARRAY("dGeom::getPosRelPoint", 3, a.getPosRelPoint(1, 2, 3, out),
              dGeomGetPosRelPoint(b, 1, 2, 3, out));
    GET_ARRAY("dGeom::getPosRelPoint array", 3, a.getPosRelPoint(p, out),
              dGeomGetPosRelPoint(b, 1, 2, 3, out));
    GET_ARRAY("dGeom::vectorToWorld", 3, a.vectorToWorld(1, 2, 3, out), dGeomVectorToWorld(b, 1, 2, 3, out));
    GET_ARRAY("dGeom::vectorToWorld array", 3, a.vectorToWorld(p, out), dGeomVectorToWorld(b, 1, 2, 3, out));
    GET_ARRAY("dGeom::vectorFromWorld", 3, a.vectorFromWorld(1, 2, 3, out),
              dGeomVectorFromWorld(b, 1, 2, 3, out));
    GET_ARRAY("dGeom::vectorFromWorld array", 3, a.vectorFromWorld(p, out),
              dGeomVectorFromWorld(b, 1, 2, 3, out));
}

void test_rest_of_geom(dGeom& a, dGeomID b)
{
    int something = 0;
    dWorld world;
    dBody body(world), other(world);
    SET("dGeom::setCategoryBits", read_geom, a, b, a.setCategoryBits(6), dGeomSetCategoryBits(b, 6));
    SET("dGeom::setCollideBits", read_geom, a, b, a.setCollideBits(5), dGeomSetCollideBits(b, 5));
    judge_get("dGeom::getCategoryBits", double(a.getCategoryBits()), 6);
    judge_get("dGeom::getCollideBits", double(a.getCollideBits()), 5);
    SET("dGeom::disable", read_geom, a, b, a.disable(), dGeomDisable(b));
    judge_get("dGeom::isEnabled", a.isEnabled(), 0);
    SET("dGeom::enable", read_geom, a, b, a.enable(), dGeomEnable(b));
    judge_get("dGeom::isEnabled yes", a.isEnabled(), 1);
    SET("dGeom::setData", read_geom, a, b, a.setData(&something), dGeomSetData(b, &something));
    judge_get("dGeom::getData", a.getData() == &something, true);
    SET("dGeom::setBody", read_geom, a, b, a.setBody(body), dGeomSetBody(b, other));
    judge_get("dGeom::getBody", a.getBody() == body.id(), true);
    judge_get("dGeom::getClass", a.getClass(), dGeomGetClass(b));
    judge_get("dGeom::isSpace", a.isSpace(), 0);
    judge_get("dGeom::getSpace", a.getSpace() == 0, true);
    judge_get("dGeom::id", a.id() != 0 && dGeomID(a) == a.id(), true);
}

void test_collide2()
{
    dSphere one(1), two(1);
    int pairs = 0;
    two.setPosition(1, 0, 0);
    one.collide2(two, &pairs, count_pairs);
    judge_get("dGeom::collide2", pairs, 1);
}

/** Whether two geoms of these numbers sit where they should. */
void judge_made(const std::string& name, const dGeom& empty, const dGeom& alone, const dGeom& in_wrapper,
                const dGeom& in_number, dSpaceID space, int number)
{
    judge_get((name + " empty").c_str(), empty.id() == 0, true);
    judge_get((name + " alone").c_str(), alone.getClass() == number && alone.getSpace() == 0, true);
    judge_get((name + " in space").c_str(), in_wrapper.getClass() == number && in_wrapper.getSpace() == space,
              true);
    judge_get((name + " in number").c_str(), in_number.getClass() == number && in_number.getSpace() == space,
              true);
}

/** create: in a space, then alone; the first geom is gone from the space. */
template <class Geom>
void judge_created(const std::string& name, Geom& geom, dSpaceID space, int members)
{
    judge_get((name + " in space").c_str(),
              geom.getSpace() == space && dSpaceGetNumGeoms(space) == members + 1, true);
}

void test_sphere_box_plane(dSpace& space)
{
    dSphere none, alone(2), inside(space, 2), by_number(space.id(), 2);
    judge_made("dSphere::dSphere", none, alone, inside, by_number, space, dSphereClass);
    none.create(space, 3);
    judge_created("dSphere::create", none, space, 2);
    judge_get("dSphere::getRadius", none.getRadius(), 3);
    none.setRadius(4);
    judge_get("dSphere::setRadius", none.getRadius(), dGeomSphereGetRadius(none));
    none.create(0, 5);
    judge_get("dSphere::create destroys", space.getNumGeoms(), 2);

    dBox nothing, box(1, 2, 3), box_inside(space, 1, 2, 3), box_by_number(space.id(), 1, 2, 3);
    judge_made("dBox::dBox", nothing, box, box_inside, box_by_number, space, dBoxClass);
    nothing.create(space, 4, 5, 6);
    judge_created("dBox::create", nothing, space, 4);
    GET_ARRAY("dBox::getLengths", 3, nothing.getLengths(out), (out[0] = 4, out[1] = 5, out[2] = 6));
    nothing.setLengths(7, 8, 9);
    GET_ARRAY("dBox::setLengths", 3, dGeomBoxGetLengths(nothing, out), (out[0] = 7, out[1] = 8, out[2] = 9));

    dPlane nowhere, plane(0, 0, 1, 2), plane_inside(space, 0, 0, 1, 2),
        plane_by_number(space.id(), 0, 0, 1, 2);
    judge_made("dPlane::dPlane", nowhere, plane, plane_inside, plane_by_number, space, dPlaneClass);
    nowhere.create(space, 0, 1, 0, 3);
    judge_created("dPlane::create", nowhere, space, 7);
    GET_ARRAY("dPlane::getParams", 4, nowhere.getParams(out), (out[1] = 1, out[3] = 3));
    nowhere.setParams(1, 0, 0, 5);
    GET_ARRAY("dPlane::setParams", 4, dGeomPlaneGetParams(nowhere, out), (out[0] = 1, out[3] = 5));
}

template <class Rod>
void test_rod(dSpace& space, const std::string& name, int number, void (*get)(dGeomID, dReal*, dReal*))
{
    Rod none, alone(2, 3), inside(space, 2, 3), by_number(space.id(), 2, 3);
    judge_made(name + "::" + name, none, alone, inside, by_number, space, number);
    none.create(space, 4, 5);
    judge_created(name + "::create", none, space, 2);
    GET_ARRAY((name + "::getParams").c_str(), 2, none.getParams(&out[0], &out[1]), (out[0] = 4, out[1] = 5));
    none.setParams(6, 7);
    GET_ARRAY((name + "::setParams").c_str(), 2, get(none, &out[0], &out[1]), (out[0] = 6, out[1] = 7));
}

#ifdef HAVE_MORE_SHAPES
void test_more_shapes(dSpace& space)
{
    test_rod<dCone>(space, "dCone", dConeClass, dGeomConeGetParams);

    dEllipsoid no_egg, egg(2, 3, 4), egg_inside(space, 2, 3, 4), egg_by_number(space.id(), 2, 3, 4);
    judge_made("dEllipsoid::dEllipsoid", no_egg, egg, egg_inside, egg_by_number, space, dEllipsoidClass);
    no_egg.create(space, 4, 5, 6);
    judge_created("dEllipsoid::create", no_egg, space, 2);
    GET_ARRAY("dEllipsoid::getRadii", 3, no_egg.getRadii(out), (out[0] = 4, out[1] = 5, out[2] = 6));
    no_egg.setRadii(7, 8, 9);
    GET_ARRAY("dEllipsoid::setRadii", 3, dGeomEllipsoidGetRadii(no_egg, out),
              (out[0] = 7, out[1] = 8, out[2] = 9));

    dTaperedCapsule none, alone(2, 1, 4), inside(space, 2, 1, 4), by_number(space.id(), 2, 1, 4);
    judge_made("dTaperedCapsule::dTaperedCapsule", none, alone, inside, by_number, space,
               dTaperedCapsuleClass);
    none.create(space, 3, 2, 5);
    judge_created("dTaperedCapsule::create", none, space, 5);
    GET_ARRAY("dTaperedCapsule::getParams", 3, none.getParams(&out[0], &out[1], &out[2]),
              (out[0] = 3, out[1] = 2, out[2] = 5));
    none.setParams(1, 2, 3);
    GET_ARRAY("dTaperedCapsule::setParams", 3, dGeomTaperedCapsuleGetParams(none, &out[0], &out[1], &out[2]),
              (out[0] = 1, out[1] = 2, out[2] = 3));
}
#endif

void test_ray(dSpace& space)
{
    dRay none, alone(2), inside(space, 2), by_number(space.id(), 2);
    judge_made("dRay::dRay", none, alone, inside, by_number, space, dRayClass);
    none.create(space, 4);
    judge_created("dRay::create", none, space, 2);
    judge_get("dRay::getLength", none.getLength(), 4);
    none.setLength(5);
    judge_get("dRay::setLength", none.getLength(), dGeomRayGetLength(none));
    none.set(1, 2, 3, 0, 3, 4);
    dGeomRaySet(alone, 1, 2, 3, 0, 3, 4);
    judge_get("dRay::set", read_geom(alone)[1], read_geom(none)[1]);
    GET_ARRAY("dRay::get", 8, none.get(out, out + 4), dGeomRayGet(alone, out, out + 4));

    int first = -1, cull = -1;
    none.setParams(1, 1);
    none.getParams(&first, &cull);
    judge_get("dRay::setParams", dGeomRayGetFirstContact(none) == 1 && dGeomRayGetBackfaceCull(none) == 1,
              true);
    judge_get("dRay::getParams", first == 1 && cull == 1, true);
    none.setFirstContact(0);
    judge_get("dRay::setFirstContact", dGeomRayGetFirstContact(none), 0);
    judge_get("dRay::getBackfaceCull", none.getBackfaceCull(), 1);
    none.setBackfaceCull(0);
    judge_get("dRay::setBackfaceCull", dGeomRayGetBackfaceCull(none), 0);
    judge_get("dRay::getFirstContact", none.getFirstContact(), 0);
    none.setClosestHit(1);
    judge_get("dRay::setClosestHit", dGeomRayGetClosestHit(none), 1);
    judge_get("dRay::getClosestHit", none.getClosestHit(), 1);
}

void test_transform(dSpace& space)
{
    dGeomTransform none, inside(space), by_number(space.id());
    judge_get("dGeomTransform::dGeomTransform", none.id() == 0, true);
    judge_get("dGeomTransform::dGeomTransform in space", inside.getSpace() == space.id(), true);
    judge_get("dGeomTransform::dGeomTransform in number", by_number.getSpace() == space.id(), true);
    none.create();
    judge_get("dGeomTransform::create", none.getClass(), dGeomTransformClass);
    dSphere sphere(1);
    none.setGeom(sphere);
    judge_get("dGeomTransform::setGeom", dGeomTransformGetGeom(none) == sphere.id(), true);
    judge_get("dGeomTransform::getGeom", none.getGeom() == sphere.id(), true);
    none.setCleanup(1);
    judge_get("dGeomTransform::getCleanup", none.getCleanup(), 1);
    none.setCleanup(0);
    judge_get("dGeomTransform::setCleanup", dGeomTransformGetCleanup(none), 0);
    none.setInfo(1);
    judge_get("dGeomTransform::setInfo", dGeomTransformGetInfo(none), 1);
    judge_get("dGeomTransform::getInfo", none.getInfo(), 1);
    none.create(space);
    judge_created("dGeomTransform::create", none, space, 2);
}

template <class Space>
void test_members(const char* kind, Space& space, int number)
{
    const std::string name = std::string(kind) + "::";
    dSphere one(1), two(1);
    int pairs = 0;
    judge_get((name + "class").c_str(), dSpaceGetClass(space), number);
    judge_get((name + "id").c_str(), space.id() != 0 && dSpaceID(space) == space.id(), true);
    judge_get((name + "isSpace").c_str(), space.isSpace(), 1);
    space.add(one);
    space.add(two);
    two.setPosition(1, 0, 0);
    judge_get((name + "add").c_str(), dSpaceGetNumGeoms(space), 2);
    judge_get((name + "getNumGeoms").c_str(), space.getNumGeoms(), 2);
    if (number != dQuadTreeSpaceClass) {  // Debian's ODE ends the program there
        judge_get((name + "getGeom").c_str(),
                  space.getGeom(0) != 0 && space.getGeom(0) == dSpaceGetGeom(space, 0), true);
    }
    judge_get((name + "query").c_str(), space.query(two), 1);
    space.collide(&pairs, count_pairs);
    judge_get((name + "collide").c_str(), pairs, 1);
    space.remove(one);
    judge_get((name + "remove").c_str(), dSpaceQuery(space, one), 0);
    space.setCleanup(0);
    judge_get((name + "setCleanup").c_str(), dSpaceGetCleanup(space), 0);
    judge_get((name + "getCleanup").c_str(), space.getCleanup(), 0);
}

}  // namespace

void test_geoms()
{
    {
        dBox a(1, 2, 3);
        dGeomID b = dCreateBox(0, 1, 2, 3);
        test_pose(a, b);
        test_points(a, b);
        test_rest_of_geom(a, b);
        a.destroy();
        judge_get("dGeom::destroy", a.id() == 0, true);
        dGeomDestroy(b);
    }
    test_collide2();
    dSimpleSpace space;
    space.setCleanup(0);
    test_sphere_box_plane(space);
    judge_get("dGeom::~", space.getNumGeoms(), 0);
    test_rod<dCapsule>(space, "dCapsule", dCapsuleClass, dGeomCapsuleGetParams);
    test_rod<dCylinder>(space, "dCylinder", dCylinderClass, dGeomCylinderGetParams);
    test_ray(space);
#ifdef HAVE_MORE_SHAPES
    test_more_shapes(space);
#endif
    test_transform(space);
}

void test_spaces()
{
    const dVector3 center = {0, 0, 0, 0}, extents = {10, 10, 10, 0};
    // A reference to the base: given a dSimpleSpace, dSimpleSpace would look for its copy constructor.
    dSimpleSpace top;
    dSpace& parent = top;
    parent.setCleanup(0);
    {
        dSimpleSpace simple, simple_inside(parent), simple_by_number(parent.id());
        dHashSpace hash, hash_inside(parent), hash_by_number(parent.id());
        dQuadTreeSpace quad(center, extents, 3), quad_inside(parent, center, extents, 3);
        dQuadTreeSpace quad_by_number(parent.id(), center, extents, 3);
        judge_get("dSpace::dSimpleSpace, dHashSpace, dQuadTreeSpace", parent.getNumGeoms(), 6);
        judge_get("dQuadTreeSpace::dQuadTreeSpace", quad_inside.getSpace() == parent.id(), true);
        test_members("dSpace", simple, dSimpleSpaceClass);
        test_members("dSimpleSpace", simple_inside, dSimpleSpaceClass);
        test_members("dHashSpace", hash, dHashSpaceClass);
        test_members("dQuadTreeSpace", quad, dQuadTreeSpaceClass);
        int low = 0, high = 0;
        hash.setLevels(-2, 5);
        dHashSpaceGetLevels(hash, &low, &high);
        judge_get("dHashSpace::setLevels", low == -2 && high == 5, true);
        judge_get("dHashSpace::dHashSpace", hash_by_number.getSpace() == parent.id(), true);
        judge_get("dSimpleSpace::dSimpleSpace", simple_by_number.getSpace() == parent.id(), true);
    }
    judge_get("dSpace::~", parent.getNumGeoms(), 0);
}
