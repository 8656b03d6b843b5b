// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// What every line of geom_types.inc must keep: its box holds the solid and no pose makes it stale; lengths
// read as they were set; nonsense is refused and changes nothing; the pose obeys the rules of bodies and
// offsets; defaults.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "../unit/api/message_recorder.h"
#include "../unit/math/random_numbers.h"
#include "collide/solid_type.h"
#include "geometry/convex_view.h"
#include "solids.h"

#pragma GCC diagnostic ignored "-Wdeprecated-declarations"

namespace epode {
namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-11);
constexpr Real kNan = std::numeric_limits<Real>::quiet_NaN();

// How the test makes one of each class, and what points it has.
struct Case {
    std::string name;
    int number;
    std::function<dGeomID()> make;
    std::function<Vec3(dGeomID, Vec3)> support;  // farthest point in a direction; empty: no finite solid
};

Pose pose(dGeomID g) { return load_pose(dGeomGetPosition(g), dGeomGetRotation(g)); }

// Of a solid, by its view.
Vec3 support_of(dGeomID g, Vec3 direction)
{
    const ConvexView view = solid_view(*from_handle<Geom>(g), pose(g));
    return view.support(direction) + view.radius * direction;
}

dGeomID as_geom(dSpaceID space) { return reinterpret_cast<dGeomID>(space); }

// 2 x 4 m, heights 0 to 3, thickness 0.5; lives as long as the process.
dHeightfieldDataID slope()
{
    static const double heights[] = {0, 1, 2, 3};
    static const dHeightfieldDataID data = [] {
        dHeightfieldDataID made = dGeomHeightfieldDataCreate();
        dGeomHeightfieldDataBuildDouble(made, heights, 0, 2, 4, 2, 2, 1, 0, Real(0.5), 0);
        return made;
    }();
    return data;
}

// A tetrahedron with a right angle at the origin; lives as long as the process.
dTriMeshDataID corner()
{
    static const dReal vertices[] = {0, 0, 0, 0, 1, 0, 0, 0, 0, 2, 0, 0, 0, 0, 3, 0};
    static const dTriIndex triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    static const dTriMeshDataID data = [] {
        dTriMeshDataID made = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSimple(made, vertices, 4, triangles, 12);
        return made;
    }();
    return data;
}

Case make_case(const std::string& name, int number)
{
    if (geom_type(number)->solid)
        return {name, number, [=] { return tests::make_solid(number); }, support_of};
    switch (number) {
        case dPlaneClass:
            return {name, number, [] { return dCreatePlane(nullptr, 0, 0, 1, 2); }, nullptr};
        case dRayClass:
            return {name, number, [] { return dCreateRay(nullptr, 4); },
                    [](dGeomID g, Vec3 d) {
                        const Vec3 end = pose(g).to_world({0, 0, 4});
                        return dot(d, end - pose(g).p) > 0 ? end : pose(g).p;
                    }};
        case dGeomTransformClass:
            return {name, number,
                    [] {
                        dGeomID t = dCreateGeomTransform(nullptr), inner = dCreateSphere(nullptr, 1);
                        dGeomSetPosition(inner, 1, 2, 3);
                        dGeomTransformSetGeom(t, inner);
                        dGeomTransformSetCleanup(t, 1);
                        return t;
                    },
                    [](dGeomID g, Vec3 d) {
                        return pose(g).to_world({1, 2, 3}) + d;
                    }};
        case dHeightfieldClass:
            return {name, number, [] { return dCreateHeightfield(nullptr, slope(), 1); },
                    [](dGeomID g, Vec3 d) {
                        const Pose middle = pose(g) * Pose{{0, Real(1.25), 0}, Mat3::identity()};
                        return view_of(Box{{1, Real(1.75), 2}}, middle).support(d);
                    }};
        case dTriMeshClass:
            // The bounding box is that of the data's box.
            return {name, number, [] { return dCreateTriMesh(nullptr, corner(), nullptr, nullptr, nullptr); },
                    [](dGeomID g, Vec3 d) {
                        const Vec3 half{Real(0.5), 1, Real(1.5)};
                        return view_of(Box{half}, pose(g) * Pose{half, Mat3::identity()}).support(d);
                    }};
        case dSimpleSpaceClass:
            return {name, number, [] { return as_geom(dSimpleSpaceCreate(nullptr)); }, nullptr};
        case dHashSpaceClass:
            return {name, number, [] { return as_geom(dHashSpaceCreate(nullptr)); }, nullptr};
        case dSweepAndPruneSpaceClass:
            return {name, number, [] { return as_geom(dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ)); },
                    nullptr};
        case dQuadTreeSpaceClass: {
            return {name, number,
                    [] {
                        const dVector3 centre = {0, 0, 0}, extents = {9, 9, 9};
                        return as_geom(dQuadTreeSpaceCreate(nullptr, centre, extents, 3));
                    },
                    nullptr};
        }
        default:
            return {name, number, nullptr, nullptr};
    }
}

// The lines of the list that `wanted` picks.
std::vector<Case> cases(bool (*wanted)(const Case&))
{
    std::vector<Case> all;
#define GEOM_TYPE(Name, Number, Object, Refusal) all.push_back(make_case(#Name, Number));
#include "collide/types/geom_types.inc"
#undef GEOM_TYPE
    std::erase_if(all, [&](const Case& c) { return !wanted(c); });
    return all;
}

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class GeomContract : public testing::TestWithParam<Case> {
  protected:
    GeomContract() { geom = GetParam().make ? GetParam().make() : nullptr; }
    ~GeomContract() override
    {
        if (geom) dGeomDestroy(geom);
        dWorldDestroy(world);
    }
    void SetUp() override
    {
        ASSERT_NE(geom, nullptr) << "this class is new: solids.inc or make_case must make one";
    }

    bool placeable() const { return geom_type(GetParam().number)->placeable; }
    void expect_pose(Vec3 p, const Mat3& R)
    {
        const Pose now = pose(geom);
        EXPECT_LE(length(now.p - p), kTight);
        for (int i = 0; i < 3; ++i) EXPECT_LE(length(now.R.row(i) - R.row(i)), kTight);
    }
    void expect_box_holds_support()
    {
        Real box[6];
        dGeomGetAABB(geom, box);
        Vec3 reached_lo{kInf, kInf, kInf}, reached_hi{-kInf, -kInf, -kInf};
        const auto look = [&](Vec3 d) {
            const Vec3 s = GetParam().support(geom, d);
            reached_lo = min(reached_lo, s);
            reached_hi = max(reached_hi, s);
        };
        for (int i = 0; i < 40; ++i) look(random.direction());
        for (int i = 0; i < 3; ++i) {
            Vec3 axis;
            axis.set(i, 1);
            look(axis), look(-axis);
        }
        for (int i = 0; i < 3; ++i) {
            EXPECT_NEAR(box[2 * i], reached_lo[i], 10 * kTight) << "axis " << i;
            EXPECT_NEAR(box[2 * i + 1], reached_hi[i], 10 * kTight) << "axis " << i;
        }
    }
    void place(Vec3 p, Quat q)
    {
        const Real numbers[4] = {q.w, q.x, q.y, q.z};
        dGeomSetPosition(geom, p.x, p.y, p.z);
        dGeomSetQuaternion(geom, numbers);
    }

    RandomNumbers random{11};
    dWorldID world = dWorldCreate();
    dGeomID geom = nullptr;
};

// Classes with a pose, without one, and those whose farthest points are known.
class UnplacedContract : public GeomContract {};
class PosedContract : public GeomContract {};
class SolidContract : public GeomContract {};

std::string name_of(const testing::TestParamInfo<Case>& instance) { return instance.param.name; }
bool has_pose(const Case& c) { return geom_type(c.number)->placeable; }
bool has_no_pose(const Case& c) { return !has_pose(c); }
bool is_solid(const Case& c) { return bool(c.support); }
bool any(const Case&) { return true; }

INSTANTIATE_TEST_SUITE_P(all, GeomContract, testing::ValuesIn(cases(any)), name_of);
INSTANTIATE_TEST_SUITE_P(all, UnplacedContract, testing::ValuesIn(cases(has_no_pose)), name_of);
INSTANTIATE_TEST_SUITE_P(all, PosedContract, testing::ValuesIn(cases(has_pose)), name_of);
INSTANTIATE_TEST_SUITE_P(all, SolidContract, testing::ValuesIn(cases(is_solid)), name_of);

TEST_P(GeomContract, has_odes_defaults)
{
    EXPECT_EQ(dGeomGetClass(geom), GetParam().number);
    EXPECT_EQ(dGeomIsEnabled(geom), 1);
    EXPECT_EQ(dGeomGetCategoryBits(geom), ~0ul);
    EXPECT_EQ(dGeomGetCollideBits(geom), ~0ul);
    EXPECT_EQ(dGeomGetData(geom), nullptr);
    EXPECT_EQ(dGeomGetBody(geom), nullptr);
    EXPECT_EQ(dGeomGetSpace(geom), nullptr);
    EXPECT_EQ(dGeomIsOffset(geom), 0);
    EXPECT_EQ(dGeomIsSpace(geom),
              GetParam().number >= dFirstSpaceClass && GetParam().number <= dLastSpaceClass);
    if (placeable()) expect_pose({0, 0, 0}, Mat3::identity());
}

TEST_P(GeomContract, keeps_data_bits_and_enabling)
{
    dGeomSetData(geom, this);
    dGeomSetCategoryBits(geom, 5);
    dGeomSetCollideBits(geom, 6);
    dGeomDisable(geom);
    EXPECT_EQ(dGeomGetData(geom), this);
    EXPECT_EQ(dGeomGetCategoryBits(geom), 5u);
    EXPECT_EQ(dGeomGetCollideBits(geom), 6u);
    EXPECT_EQ(dGeomIsEnabled(geom), 0);
}

TEST_P(SolidContract, box_is_the_tightest_round_the_solid)
{
    for (int i = 0; i < 20; ++i) {
        place(5 * random.vec(), random.rotation());
        expect_box_holds_support();
    }
}

TEST_P(SolidContract, box_follows_the_body_with_and_without_offset)
{
    dBodyID body = dBodyCreate(world);
    dGeomSetBody(geom, body);
    for (int i = 0; i < 20; ++i) {
        const Vec3 p = random.vec();
        const Quat q = random.rotation();
        const Real numbers[4] = {q.w, q.x, q.y, q.z};
        dBodySetPosition(body, p.x, p.y, p.z);
        dBodySetQuaternion(body, numbers);
        if (i == 10) dGeomSetOffsetPosition(geom, 1, 2, 3);
        expect_box_holds_support();
    }
}

TEST_P(UnplacedContract, without_a_place_refuses_pose_and_body)
{
    MessageRecorder messages;
    dGeomSetPosition(geom, 1, 2, 3);
    EXPECT_EQ(messages.take(), "2: geom must be placeable in dGeomSetPosition()");
    EXPECT_EQ(dGeomGetPosition(geom), nullptr);
    EXPECT_EQ(messages.take(), "2: geom must be placeable in dGeomGetPosition()");
    dBodyID body = dBodyCreate(world);
    dGeomSetBody(geom, body);
    EXPECT_EQ(messages.take(), "2: geom must be placeable in dGeomSetBody()");
    EXPECT_EQ(dBodyGetFirstGeom(body), nullptr);
    dGeomSetBody(geom, nullptr);
    EXPECT_EQ(messages.take(), "");
    dVector3 out;
    dGeomGetRelPointPos(geom, 1, 2, 3, out);
    EXPECT_EQ(out[1], 2);
}

TEST_P(PosedContract, refuses_poses_that_are_not_numbers)
{
    MessageRecorder messages;
    place({1, 2, 3}, random.rotation());
    const Pose before = pose(geom);
    dMatrix3 R = {1, 0, 0, 0, 0, kNan, 0, 0, 0, 0, 1, 0};
    const dQuaternion q = {kNan, 0, 0, 0};
    dGeomSetPosition(geom, kNan, 0, 0);
    dGeomSetPosition(geom, 0, kInf, 0);
    dGeomSetRotation(geom, R);
    dGeomSetRotation(geom, nullptr);
    dGeomSetQuaternion(geom, q);
    dGeomSetOffsetPosition(geom, 1, 0, 0);
    const std::string said = messages.take();
    EXPECT_EQ(std::count(said.begin(), said.end(), '|'), 5) << said;
    EXPECT_NE(said.find("geom must be on a body in dGeomSetOffsetPosition()"), std::string::npos);
    expect_pose(before.p, before.R);
}

TEST_P(PosedContract, on_a_body_shares_its_pose_and_moves_it)
{
    dBodyID body = dBodyCreate(world);
    dBodySetPosition(body, 1, 2, 3);
    dGeomSetBody(geom, body);
    EXPECT_EQ(dGeomGetBody(geom), body);
    EXPECT_EQ(dGeomGetPosition(geom), dBodyGetPosition(body));
    EXPECT_EQ(dGeomGetRotation(geom), dBodyGetRotation(body));
    const Quat q = random.rotation();
    place({4, 5, 6}, q);
    expect_pose({4, 5, 6}, to_matrix(q));
    EXPECT_EQ(dBodyGetPosition(body)[1], 5);
    dQuaternion now;
    dGeomGetQuaternion(geom, now);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(now[i], dBodyGetQuaternion(body)[i]);
    dGeomSetBody(geom, nullptr);
    EXPECT_NE(dGeomGetPosition(geom), dBodyGetPosition(body));
    expect_pose({4, 5, 6}, to_matrix(q));
    EXPECT_EQ(dBodyGetFirstGeom(body), nullptr);
}

TEST_P(PosedContract, with_an_offset_is_at_body_times_offset)
{
    dBodyID body = dBodyCreate(world);
    dGeomSetBody(geom, body);
    const Vec3 po{1, 2, 3};
    const Quat qo = random.rotation();
    const Real qo_numbers[4] = {qo.w, qo.x, qo.y, qo.z};
    dGeomSetOffsetPosition(geom, po.x, po.y, po.z);
    dGeomSetOffsetQuaternion(geom, qo_numbers);
    EXPECT_EQ(dGeomIsOffset(geom), 1);
    const Pose offset{po, to_matrix(qo)};
    for (int i = 0; i < 5; ++i) {
        const Vec3 p = 3 * random.vec();
        const Quat q = random.rotation();
        const Real numbers[4] = {q.w, q.x, q.y, q.z};
        dBodySetPosition(body, p.x, p.y, p.z);
        dBodySetQuaternion(body, numbers);
        const Pose expected = Pose{p, to_matrix(q)} * offset;
        expect_pose(expected.p, expected.R);
    }
    // Setting the geom's pose moves the body so that the geom gets there; turning keeps its place.
    const Quat q = random.rotation();
    place({7, 8, 9}, q);
    expect_pose({7, 8, 9}, to_matrix(q));
    const Pose body_pose = load_pose(dBodyGetPosition(body), dBodyGetRotation(body));
    EXPECT_LE(length(body_pose.to_world(po) - Vec3{7, 8, 9}), 10 * kTight);
    // World forms leave the body alone.
    dGeomSetOffsetWorldPosition(geom, -1, -2, -3);
    EXPECT_LE(length(pose(geom).p - Vec3{-1, -2, -3}), 10 * kTight);
    const Quat turned = random.rotation();
    const Real turned_numbers[4] = {turned.w, turned.x, turned.y, turned.z};
    dGeomSetOffsetWorldQuaternion(geom, turned_numbers);
    EXPECT_LE(length(pose(geom).p - Vec3{-1, -2, -3}), 10 * kTight);
    EXPECT_LE(length(pose(geom).R.row0 - to_matrix(turned).row0), 10 * kTight);
    EXPECT_LE(length(load(dBodyGetPosition(body)) - body_pose.p), 0);
    // Detaching folds the offset in; clearing drops it.
    dGeomSetBody(geom, nullptr);
    EXPECT_EQ(dGeomIsOffset(geom), 0);
    EXPECT_LE(length(pose(geom).p - Vec3{-1, -2, -3}), 10 * kTight);
    dGeomSetBody(geom, body);
    dGeomSetOffsetPosition(geom, 1, 1, 1);
    dGeomClearOffset(geom);
    EXPECT_EQ(dGeomGetPosition(geom), dBodyGetPosition(body));
    EXPECT_EQ(dGeomGetOffsetPosition(geom)[0], 0);
}

TEST_P(PosedContract, stays_where_it_is_when_its_body_goes)
{
    MessageRecorder messages;
    dBodyID body = dBodyCreate(world);
    dGeomID other = dCreateSphere(nullptr, 1);
    dGeomSetBody(geom, body);
    dGeomSetBody(other, body);
    EXPECT_EQ(dBodyGetFirstGeom(body), other);
    EXPECT_EQ(dBodyGetNextGeom(other), geom);
    EXPECT_EQ(dGeomGetBodyNext(geom), nullptr);
    dGeomSetOffsetPosition(geom, 1, 0, 0);
    dBodySetPosition(body, 5, 5, 5);
    dBodyDestroy(body);
    EXPECT_EQ(dGeomGetBody(geom), nullptr);
    expect_pose({6, 5, 5}, Mat3::identity());
    dGeomDestroy(other);
    EXPECT_EQ(messages.take(), "");
}

TEST_P(PosedContract, maps_points_and_vectors_by_its_pose)
{
    place(random.vec(), random.rotation());
    const Vec3 a = random.vec();
    dVector3 world_point, back;
    dGeomGetRelPointPos(geom, a.x, a.y, a.z, world_point);
    EXPECT_LE(length(load(world_point) - pose(geom).to_world(a)), kTight);
    dGeomGetPosRelPoint(geom, world_point[0], world_point[1], world_point[2], back);
    EXPECT_LE(length(load(back) - a), kTight);
    dGeomVectorToWorld(geom, a.x, a.y, a.z, world_point);
    EXPECT_LE(length(load(world_point) - pose(geom).R * a), kTight);
    dGeomVectorFromWorld(geom, world_point[0], world_point[1], world_point[2], back);
    EXPECT_LE(length(load(back) - a), kTight);
}

TEST_P(GeomContract, leaves_its_space_when_destroyed)
{
    dSpaceID space = dHashSpaceCreate(nullptr);
    dSpaceAdd(space, geom);
    EXPECT_EQ(dGeomGetSpace(geom), space);
    dGeomDestroy(geom);
    EXPECT_EQ(dSpaceGetNumGeoms(space), 0);
    MessageRecorder messages;
    EXPECT_EQ(dGeomGetClass(geom), -1) << "a stale handle is recognised";
    EXPECT_NE(messages.take(), "");
    geom = nullptr;
    dSpaceDestroy(space);
}

// ---- sizes, class by class ----

TEST(GeomSizes, read_as_set_and_nonsense_is_refused)
{
    MessageRecorder messages;
    dReal r = 0, l = 0;
    dVector3 sides;
    dGeomID sphere = dCreateSphere(nullptr, 1), box = dCreateBox(nullptr, 1, 1, 1);
    dGeomID capsule = dCreateCapsule(nullptr, 1, 1), cylinder = dCreateCylinder(nullptr, 1, 1);
    dGeomID ray = dCreateRay(nullptr, 1);
    dGeomSphereSetRadius(sphere, 2), dGeomBoxSetLengths(box, 2, 3, 4);
    dGeomCapsuleSetParams(capsule, 2, 3), dGeomCylinderSetParams(cylinder, 4, 5), dGeomRaySetLength(ray, -3);
    EXPECT_EQ(messages.take(), "");
    dGeomSphereSetRadius(sphere, -1), dGeomBoxSetLengths(box, 1, kNan, 1);
    dGeomCapsuleSetParams(capsule, -1, 1), dGeomCylinderSetParams(cylinder, 1, -1),
        dGeomRaySetLength(ray, kNan);
    EXPECT_EQ(messages.take(),
              "2: Bad argument(s) in dGeomSphereSetRadius()|2: Bad argument(s) in dGeomBoxSetLengths()|"
              "2: Bad argument(s) in dGeomCapsuleSetParams()|2: Bad argument(s) in dGeomCylinderSetParams()|"
              "2: Bad argument(s) in dGeomRaySetLength()");
    EXPECT_EQ(dGeomSphereGetRadius(sphere), 2);
    dGeomBoxGetLengths(box, sides);
    EXPECT_EQ(sides[0], 2);
    EXPECT_EQ(sides[1], 3);
    EXPECT_EQ(sides[2], 4);
    dGeomCapsuleGetParams(capsule, &r, &l);
    EXPECT_EQ(r, 2);
    EXPECT_EQ(l, 3);
    dGeomCylinderGetParams(cylinder, &r, &l);
    EXPECT_EQ(r, 4);
    EXPECT_EQ(l, 5);
    EXPECT_EQ(dGeomRayGetLength(ray), -3);
    EXPECT_EQ(dGeomSphereGetRadius(box), 0);
    EXPECT_EQ(messages.take(), "2: argument not a sphere in dGeomSphereGetRadius()");
    EXPECT_EQ(dCreateSphere(nullptr, -1), nullptr);
    EXPECT_EQ(dCreateBox(nullptr, 1, 1, kInf), nullptr);
    EXPECT_EQ(dCreateSphere(reinterpret_cast<dSpaceID>(box), 1), nullptr);
    EXPECT_NE(messages.take().find("argument not a space in dCreateSphere()"), std::string::npos);
    for (dGeomID g : {sphere, box, capsule, cylinder, ray}) dGeomDestroy(g);
}

TEST(GeomSizes, depth_of_points)
{
    dGeomID sphere = dCreateSphere(nullptr, 1), box = dCreateBox(nullptr, 2, 2, 2);
    dGeomID capsule = dCreateCapsule(nullptr, 1, 2), plane = dCreatePlane(nullptr, 0, 0, 2, 4);
    EXPECT_EQ(dGeomSpherePointDepth(sphere, 0, 0, 0), 1);
    EXPECT_EQ(dGeomSpherePointDepth(sphere, 3, 0, 0), -2);
    EXPECT_EQ(dGeomBoxPointDepth(box, 0, 0, 0), 1);
    EXPECT_EQ(dGeomBoxPointDepth(box, Real(0.5), 0, 0), Real(0.5));
    EXPECT_EQ(dGeomBoxPointDepth(box, 1, 0, 0), 0);
    EXPECT_EQ(dGeomBoxPointDepth(box, 4, 5, 0), -5);
    EXPECT_EQ(dGeomCapsulePointDepth(capsule, 0, 0, 1), 1);
    EXPECT_EQ(dGeomCapsulePointDepth(capsule, 0, 0, 3), -1);
    EXPECT_EQ(dGeomCapsulePointDepth(capsule, 3, 0, Real(0.5)), -2);
    EXPECT_EQ(dGeomPlanePointDepth(plane, 7, 7, 1), 1);
    for (dGeomID g : {sphere, box, capsule, plane}) dGeomDestroy(g);
}

TEST(GeomPlane, is_normalised_and_bounds_one_side_across_an_axis)
{
    dVector4 p;
    dGeomID plane = dCreatePlane(nullptr, 0, 0, 2, 4);
    dGeomPlaneGetParams(plane, p);
    EXPECT_EQ(p[2], 1);
    EXPECT_EQ(p[3], 2);
    Real box[6];
    dGeomGetAABB(plane, box);
    EXPECT_EQ(box[5], 2);
    EXPECT_EQ(box[4], -kInf);
    EXPECT_EQ(box[0], -kInf);
    EXPECT_EQ(box[1], kInf);
    dGeomPlaneSetParams(plane, -3, 0, 0, 6);
    dGeomGetAABB(plane, box);
    EXPECT_EQ(box[0], -2);
    EXPECT_EQ(box[1], kInf);
    EXPECT_EQ(box[5], kInf);
    dGeomPlaneSetParams(plane, 0, 0, 0, 5);
    dGeomPlaneGetParams(plane, p);
    EXPECT_EQ(p[0], 1);
    EXPECT_EQ(p[3], 0);
    dGeomDestroy(plane);
}

TEST(GeomRay, set_gives_start_and_unit_direction_and_moves_its_body)
{
    MessageRecorder messages;
    dWorldID world = dWorldCreate();
    dBodyID body = dBodyCreate(world);
    dGeomID ray = dCreateRay(nullptr, 5);
    dVector3 start, dir;
    for (int on_body = 0; on_body < 2; ++on_body) {
        dGeomRaySet(ray, 1, 2, 3, 0, -2, 0);
        dGeomRayGet(ray, start, dir);
        EXPECT_EQ(start[2], 3);
        EXPECT_NEAR(dir[1], -1, kTight);
        const Mat3 R = load_mat(dGeomGetRotation(ray));
        EXPECT_NEAR(determinant(R), 1, kTight) << "a proper rotation";
        if (on_body) { EXPECT_EQ(dBodyGetPosition(body)[1], 2); }
        dGeomSetBody(ray, body);
        EXPECT_EQ(messages.take(), "");
    }
    dGeomRaySet(ray, 0, 0, 0, 0, 0, 0);
    EXPECT_NE(messages.take(), "");
    dGeomRayGet(ray, start, dir);
    EXPECT_EQ(start[0], 1);
    dGeomRaySetClosestHit(ray, 7);
    EXPECT_EQ(dGeomRayGetClosestHit(ray), 1);
    dGeomRaySetParams(ray, 1, 0);
    int first = 0, cull = 1;
    dGeomRayGetParams(ray, &first, &cull);
    EXPECT_EQ(first, 1);
    EXPECT_EQ(cull, 0);
    dGeomDestroy(ray);
    ray = dCreateRay(nullptr, dInfinity);
    ASSERT_NE(ray, nullptr);
    EXPECT_GT(dGeomRayGetLength(ray), Real(1e17));
    dGeomDestroy(ray);
    dWorldDestroy(world);
}

}  // namespace
}  // namespace epode
