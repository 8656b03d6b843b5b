// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms set and read: sizes, ray flags, bits, data, bodies and offsets in every order, poses through the geom
// and through its body, the bounding box after each of them, and boxes at infinity.
#include "geoms.h"

namespace parity {
namespace {

double flag(bool value) { return value ? 1.0 : 0.0; }

void put_box(Output& out, const std::string& key, dGeomID g)
{
    dReal box[6] = {0};
    dGeomGetAABB(g, box);
    out.put(key, box, 6);
}

void put_sizes(Output& out, const std::string& key, const Placed (&g)[6])
{
    dVector3 sides = {0, 0, 0, 0};
    dReal r1 = 0, l1 = 0, r2 = 0, l2 = 0, plane[4] = {0};
    dGeomBoxGetLengths(g[1].geom, sides);
    dGeomCapsuleGetParams(g[2].geom, &r1, &l1);
    dGeomCylinderGetParams(g[3].geom, &r2, &l2);
    dGeomPlaneGetParams(g[4].geom, plane);
    out.put(key + ".sphere", {dGeomSphereGetRadius(g[0].geom)});
    out.put(key + ".box", sides, 3);
    out.put(key + ".rods", {r1, l1, r2, l2});
    out.put(key + ".plane", plane, 4);
    out.put(key + ".ray", {dGeomRayGetLength(g[5].geom)});
    for (int i = 0; i < 6; ++i) { put_box(out, key + ".box" + std::to_string(i), g[i].geom); }
}

PARITY_CASE(geom_sizes)
{
    constexpr Kind kinds[6] = {Kind::kSphere,   Kind::kBox,   Kind::kCapsule,
                               Kind::kCylinder, Kind::kPlane, Kind::kRay};
    for (int trial = 0; trial < 20; ++trial) {
        out.open_block("t" + std::to_string(trial));
        Placed g[6];
        for (int i = 0; i < 6; ++i) {
            g[i] = make_geom(kinds[i], nullptr, rng);
            place_geom(g[i], kinds[i], rng.in_cube(2), rng);
        }
        put_sizes(out, "made", g);
        const bool zero = trial % 5 == 0;
        dGeomSphereSetRadius(g[0].geom, zero ? 0 : rng.range(0, 3));
        dGeomBoxSetLengths(g[1].geom, rng.range(0, 3), zero ? 0 : rng.range(0, 3), rng.range(0, 3));
        dGeomCapsuleSetParams(g[2].geom, rng.range(0, 3), zero ? 0 : rng.range(0, 3));
        dGeomCylinderSetParams(g[3].geom, rng.range(0, 3), zero ? 0 : rng.range(0, 3));
        dGeomPlaneSetParams(g[4].geom, rng.range(-1, 3), rng.range(-3, 3), rng.range(-3, 3),
                            rng.range(-9, 9));
        dGeomRaySetLength(g[5].geom, zero ? 0 : rng.range(0, 9));
        put_sizes(out, "set", g);
        const Vec3 p = rng.in_cube(1);
        out.put("depths", {dGeomSpherePointDepth(g[0].geom, p.x, p.y, p.z),
                           dGeomCapsulePointDepth(g[2].geom, p.x, p.y, p.z),
                           dGeomPlanePointDepth(g[4].geom, p.x, p.y, p.z)});
        for (const Placed& one : g) { dGeomDestroy(one.geom); }
    }
    const dGeomID plane = dCreatePlane(nullptr, 0, 0, 0, 5);
    dReal params[4] = {0};
    dGeomPlaneGetParams(plane, params);
    out.open_block("zero-plane");
    out.put("params", params, 4);
    dReal everywhere[6] = {0};
    dInfiniteAABB(plane, everywhere);
    out.put("everywhere", everywhere, 6);
    dGeomDestroy(plane);
}

void put_flags(Output& out, const std::string& key, dGeomID ray)
{
    int first = 7, cull = 7;
    dGeomRayGetParams(ray, &first, &cull);
    out.put(key + ".defaults", {static_cast<double>(first), static_cast<double>(cull),
                                static_cast<double>(dGeomRayGetFirstContact(ray)),
                                static_cast<double>(dGeomRayGetBackfaceCull(ray)),
                                static_cast<double>(dGeomRayGetClosestHit(ray))});
}

PARITY_CASE(geom_ray_settings)
{
    const dGeomID ray = dCreateRay(nullptr, 3);
    put_flags(out, "new", ray);
    for (int i = 0; i < 27; ++i) {
        const int a = i % 3, b = i / 3 % 3, c = i / 9;
        dGeomRaySetFirstContact(ray, a);
        dGeomRaySetBackfaceCull(ray, b);
        dGeomRaySetClosestHit(ray, 5 * c);
        put_flags(out, "set" + std::to_string(i), ray);
        dGeomRaySetParams(ray, b, c);
        put_flags(out, "params" + std::to_string(i), ray);
    }
    for (int i = 0; i < 20; ++i) {
        const Vec3 p = rng.in_cube(5), d = rng.in_cube(2);
        dGeomRaySet(ray, p.x, p.y, p.z, d.x, d.y, d.z);
        dVector3 start = {0, 0, 0, 0}, direction = {0, 0, 0, 0};
        dGeomRayGet(ray, start, direction);
        out.put("start" + std::to_string(i), start, 3);
        out.put("direction" + std::to_string(i), direction, 3);
        put_box(out, "box" + std::to_string(i), ray);
    }
    dGeomDestroy(ray);
}

void put_pose(Output& out, const std::string& key, dGeomID g, dBodyID body)
{
    dVector3 p = {0, 0, 0, 0};
    dMatrix3 R = {0};
    dQuaternion q = {0, 0, 0, 0};
    dGeomCopyPosition(g, p);
    dGeomCopyRotation(g, R);
    dGeomGetQuaternion(g, q);
    out.put(key + ".pos", p, 3);
    out.put_matrix3(key + ".rot", R);
    out.put(key + ".quat", q, 4);
    const dReal *kept = dGeomGetPosition(g), *rows = dGeomGetRotation(g);
    out.put(key + ".same", {flag(kept[0] == p[0] && kept[1] == p[1] && kept[2] == p[2]),
                            flag(rows[0] == R[0] && rows[6] == R[6] && rows[9] == R[9])});
    out.put(key + ".body", dBodyGetPosition(body), 3);
    out.put(key + ".body-quat", dBodyGetQuaternion(body), 4);
    out.put(key + ".offset", dGeomGetOffsetPosition(g), 3);
    out.put_matrix3(key + ".offset-rot", dGeomGetOffsetRotation(g));
    out.put(key + ".links", {flag(dGeomGetBody(g) != nullptr), static_cast<double>(dGeomIsOffset(g))});
    put_box(out, key + ".aabb", g);
}

struct PoseDeed {
    const char* name;
    bool needs_body;
    void (*run)(dGeomID, dBodyID, Random&);
};

void random_rotation(dMatrix3 R, dQuaternion q, Random& random)
{
    const Quat r = random.rotation(3.1);
    q[0] = r.w;
    q[1] = r.x;
    q[2] = r.y;
    q[3] = r.z;
    dRfromQ(R, q);
}

template <void (*Set)(dGeomID, const dMatrix3)>
void turn_by_matrix(dGeomID g, dBodyID, Random& random)
{
    dMatrix3 R = {0};
    dQuaternion q = {0, 0, 0, 0};
    random_rotation(R, q, random);
    Set(g, R);
}

template <void (*Set)(dGeomID, const dQuaternion)>
void turn_by_quaternion(dGeomID g, dBodyID, Random& random)
{
    dMatrix3 R = {0};
    dQuaternion q = {0, 0, 0, 0};
    random_rotation(R, q, random);
    Set(g, q);
}

template <void (*Set)(dGeomID, dReal, dReal, dReal)>
void move(dGeomID g, dBodyID, Random& random)
{
    const Vec3 p = random.in_cube(2);
    Set(g, p.x, p.y, p.z);
}

// dGeomSetQuaternion with an offset is an intended difference (differences.tsv, C1).
void set_quaternion(dGeomID g, dBodyID body, Random& random)
{
    if (!dGeomIsOffset(g)) { turn_by_quaternion<&dGeomSetQuaternion>(g, body, random); }
}

const PoseDeed kDeeds[] = {
    {"position", false, move<&dGeomSetPosition>},
    {"rotation", false, turn_by_matrix<&dGeomSetRotation>},
    {"quaternion", false, set_quaternion},
    {"offset-position", true, move<&dGeomSetOffsetPosition>},
    {"offset-rotation", true, turn_by_matrix<&dGeomSetOffsetRotation>},
    {"offset-quaternion", true, turn_by_quaternion<&dGeomSetOffsetQuaternion>},
    {"world-position", true, move<&dGeomSetOffsetWorldPosition>},
    {"world-rotation", true, turn_by_matrix<&dGeomSetOffsetWorldRotation>},
    {"world-quaternion", true, turn_by_quaternion<&dGeomSetOffsetWorldQuaternion>},
    {"clear-offset", false, [](dGeomID g, dBodyID, Random&) { dGeomClearOffset(g); }},
    {"attach", false, [](dGeomID g, dBodyID body, Random&) { dGeomSetBody(g, body); }},
    {"detach", false, [](dGeomID g, dBodyID, Random&) { dGeomSetBody(g, nullptr); }},
    {"body-position", false,
     [](dGeomID, dBodyID body, Random& random) {
         const Vec3 p = random.in_cube(2);
         dBodySetPosition(body, p.x, p.y, p.z);
     }},
    {"body-quaternion", false,
     [](dGeomID, dBodyID body, Random& random) {
         dMatrix3 R = {0};
         dQuaternion q = {0, 0, 0, 0};
         random_rotation(R, q, random);
         dBodySetQuaternion(body, q);
     }},
    {"body-rotation", false,
     [](dGeomID, dBodyID body, Random& random) {
         dMatrix3 R = {0};
         dQuaternion q = {0, 0, 0, 0};
         random_rotation(R, q, random);
         dBodySetRotation(body, R);
     }},
};

// Random sequences of everything that moves a geom, compared after each.
PARITY_CASE(geom_pose_sequences)
{
    constexpr Kind kinds[] = {Kind::kSphere, Kind::kBox, Kind::kCapsule, Kind::kCylinder};
    for (int trial = 0; trial < 40; ++trial) {
        out.open_block("t" + std::to_string(trial));
        const dWorldID world = dWorldCreate();
        const dBodyID body = dBodyCreate(world);
        const dSpaceID space = dSimpleSpaceCreate(nullptr);
        const dGeomID g = make_geom(kinds[trial % 4], space, rng).geom;
        for (int i = 0; i < 25; ++i) {
            const PoseDeed& deed = kDeeds[rng.below(15)];
            if (deed.needs_body && dGeomGetBody(g) == nullptr) { continue; }
            deed.run(g, body, rng);
            put_pose(out, std::to_string(i) + deed.name, g, body);
        }
        dSpaceDestroy(space);
        dWorldDestroy(world);
    }
}

PARITY_CASE(geom_labels)
{
    for (const Kind kind : kKinds) {
        out.open_block(kind_name(kind));
        int mark = 0;
        const dSpaceID space = dHashSpaceCreate(nullptr);
        const dGeomID g = make_geom(kind, space, rng).geom;
        dGeomSetData(g, &mark);
        dGeomSetCategoryBits(g, 0x12345678ul);
        dGeomSetCollideBits(g, 0x0f0f0f0ful);
        dGeomDisable(g);
        const auto put = [&](const char* key) {
            out.put(std::string(key) + "-defaults",
                    {flag(dGeomGetData(g) == &mark), static_cast<double>(dGeomGetCategoryBits(g)),
                     static_cast<double>(dGeomGetCollideBits(g)), flag(dGeomIsEnabled(g) != 0),
                     flag(dGeomGetSpace(g) == space), static_cast<double>(dGeomGetClass(g)),
                     flag(dGeomIsSpace(g) != 0), flag(dGeomIsSpace(reinterpret_cast<dGeomID>(space)) != 0)});
        };
        put("set");
        dGeomEnable(g);
        put("enabled");
        dSpaceRemove(space, g);
        put("removed");
        dSpaceAdd(space, g);
        put("added");
        dSpaceDestroy(space);
    }
}

// Vectors and points through geoms that cannot be placed come back as they are.
PARITY_CASE(geom_transforms)
{
    for (const Kind kind : kKinds) {
        for (int i = 0; i < 10; ++i) {
            out.open_block(std::string(kind_name(kind)) + std::to_string(i));
            const Placed placed = make_geom(kind, nullptr, rng);
            if (kind != Kind::kRay) { place_geom(placed, kind, rng.in_cube(2), rng); }
            const Vec3 p = rng.in_cube(3);
            const auto put = [&](const char* key, void (*get)(dGeomID, dReal, dReal, dReal, dVector3)) {
                dVector3 r = {0, 0, 0, 0};
                get(placed.geom, p.x, p.y, p.z, r);
                out.put(key, r, 3);
            };
            put("rel-point-pos", dGeomGetRelPointPos);
            put("pos-rel-point", dGeomGetPosRelPoint);
            put("to-world", dGeomVectorToWorld);
            put("from-world", dGeomVectorFromWorld);
            dGeomDestroy(placed.geom);
        }
    }
}

// A transform and what it holds.
PARITY_CASE(geom_transform_settings)
{
    const dGeomID transform = dCreateGeomTransform(nullptr);
    const auto put = [&](const char* key) {
        out.put(std::string(key) + "-defaults", {flag(dGeomTransformGetGeom(transform) != nullptr),
                                                 static_cast<double>(dGeomTransformGetCleanup(transform)),
                                                 static_cast<double>(dGeomTransformGetInfo(transform))});
        put_box(out, std::string(key) + ".aabb", transform);
    };
    put("empty");
    const dGeomID held = dCreateCapsule(nullptr, 0.5, 2), other = dCreateSphere(nullptr, 2);
    dGeomSetPosition(held, 1, 2, 3);
    dGeomTransformSetGeom(transform, held);
    dGeomSetPosition(transform, 5, 6, 7);
    put("held");
    dGeomTransformSetCleanup(transform, 1);
    dGeomTransformSetInfo(transform, 1);
    put("set");
    dGeomTransformSetCleanup(transform, 0);
    dGeomTransformSetGeom(transform, other);
    dGeomSetPosition(transform, 5, 6, 8);
    put("other");
    dGeomDestroy(transform);
    dGeomDestroy(held);
    dGeomDestroy(other);
}

}  // namespace
}  // namespace parity
