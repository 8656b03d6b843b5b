// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Geoms alone: bounding boxes, point depths, parameters, poses with body and offset, point transforms, and
// the contact rules that do not depend on a random pose (same body, room, order of the two geoms).
#include "geoms.h"

namespace parity {
namespace {

PARITY_CASE(geom_aabb)
{
    for (const Kind kind : kKinds) {
        for (int pose = 0; pose < 50; ++pose) {
            const Placed placed = make_geom(kind, nullptr, rng);
            place_geom(placed, kind, rng.in_cube(3), rng);
            dReal box[6] = {0};
            dGeomGetAABB(placed.geom, box);
            out.put(std::string(kind_name(kind)) + std::to_string(pose), box, 6);
            dGeomDestroy(placed.geom);
        }
    }
    const double axes[6][3] = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 2}, {0, 0, -2}};
    for (int i = 0; i < 6; ++i) {
        const dGeomID plane = dCreatePlane(nullptr, axes[i][0], axes[i][1], axes[i][2], 0.7);
        dReal box[6] = {0}, params[4] = {0};
        dGeomGetAABB(plane, box);
        dGeomPlaneGetParams(plane, params);
        out.put("axis-plane" + std::to_string(i), box, 6);
        out.put("axis-plane-params" + std::to_string(i), params, 4);
        dGeomDestroy(plane);
    }
}

PARITY_CASE(geom_point_depth)
{
    for (int i = 0; i < 200; ++i) {
        const Vec3 at = rng.in_cube(1), p = rng.in_cube(1.5);
        const Placed sphere = make_geom(Kind::kSphere, nullptr, rng),
                     box = make_geom(Kind::kBox, nullptr, rng),
                     capsule = make_geom(Kind::kCapsule, nullptr, rng),
                     plane = make_geom(Kind::kPlane, nullptr, rng);
        place_geom(sphere, Kind::kSphere, at, rng);
        place_geom(box, Kind::kBox, at, rng);
        place_geom(capsule, Kind::kCapsule, at, rng);
        place_geom(plane, Kind::kPlane, at, rng);
        const std::string n = std::to_string(i);
        out.put("sphere" + n, {dGeomSpherePointDepth(sphere.geom, p.x, p.y, p.z)});
        out.put("capsule" + n, {dGeomCapsulePointDepth(capsule.geom, p.x, p.y, p.z)});
        out.put("plane" + n, {dGeomPlanePointDepth(plane.geom, p.x, p.y, p.z)});
        // Outside a box only the sign has a meaning (differences.tsv, C6).
        const double depth = dGeomBoxPointDepth(box.geom, p.x, p.y, p.z);
        out.put("box" + n, {depth >= 0 ? depth : -1.0});
        for (const Placed& placed : {sphere, box, capsule, plane}) { dGeomDestroy(placed.geom); }
    }
}

void put_pose(Output& out, const std::string& key, dGeomID g)
{
    dVector3 p = {0, 0, 0, 0};
    dQuaternion q = {0, 0, 0, 0};
    dMatrix3 R = {0};
    dGeomCopyPosition(g, p);
    dGeomGetQuaternion(g, q);
    dGeomCopyRotation(g, R);
    out.put(key + ".pos", p, 3);
    out.put_matrix3(key + ".rot", R);
    out.put(key + ".quat", q, 4);
    dGeomCopyOffsetPosition(g, p);
    dGeomCopyOffsetRotation(g, R);
    dGeomGetOffsetQuaternion(g, q);
    out.put(key + ".offset", p, 3);
    out.put_matrix3(key + ".offset-rot", R);
    out.put(key + ".offset-quat", q, 4);
    out.put(key + ".is-offset", {static_cast<double>(dGeomIsOffset(g))});
}

void random_matrix(dMatrix3 R, dQuaternion q, Random& random)
{
    const Quat r = random.rotation(3);
    q[0] = r.w;
    q[1] = r.x;
    q[2] = r.y;
    q[3] = r.z;
    dRfromQ(R, q);
}

PARITY_CASE(geom_offsets)
{
    for (int i = 0; i < 20; ++i) {
        out.open_block("t" + std::to_string(i));
        const dWorldID world = dWorldCreate();
        const dBodyID body = dBodyCreate(world);
        const dGeomID g = dCreateBox(nullptr, 1, 2, 3);
        dMatrix3 R = {0};
        dQuaternion q = {0, 0, 0, 0};
        const Vec3 a = rng.in_cube(1), b = rng.in_cube(1), c = rng.in_cube(1);
        random_matrix(R, q, rng);
        dBodySetPosition(body, a.x, a.y, a.z);
        dBodySetQuaternion(body, q);
        put_pose(out, "free", g);
        dGeomSetBody(g, body);
        put_pose(out, "attached", g);
        dGeomSetOffsetPosition(g, b.x, b.y, b.z);
        put_pose(out, "offset-position", g);
        random_matrix(R, q, rng);
        dGeomSetOffsetRotation(g, R);
        put_pose(out, "offset-rotation", g);
        random_matrix(R, q, rng);
        dGeomSetOffsetQuaternion(g, q);
        put_pose(out, "offset-quaternion", g);
        dGeomSetOffsetWorldPosition(g, c.x, c.y, c.z);
        put_pose(out, "world-position", g);
        random_matrix(R, q, rng);
        dGeomSetOffsetWorldRotation(g, R);
        put_pose(out, "world-rotation", g);
        random_matrix(R, q, rng);
        dGeomSetOffsetWorldQuaternion(g, q);
        put_pose(out, "world-quaternion", g);
        dGeomSetPosition(g, a.y, b.z, c.x);
        put_pose(out, "set-position", g);
        out.put("body.pos", dBodyGetPosition(body), 3);
        random_matrix(R, q, rng);
        dGeomSetRotation(g, R);
        put_pose(out, "set-rotation", g);
        out.put_matrix3("body.rot", dBodyGetRotation(body));
        dVector3 r = {0, 0, 0, 0};
        dGeomGetRelPointPos(g, b.x, c.y, a.z, r);
        out.put("rel-point", r, 3);
        dGeomGetPosRelPoint(g, b.x, c.y, a.z, r);
        out.put("pos-rel", r, 3);
        dGeomVectorToWorld(g, b.x, c.y, a.z, r);
        out.put("to-world", r, 3);
        dGeomVectorFromWorld(g, b.x, c.y, a.z, r);
        out.put("from-world", r, 3);
        dGeomSetBody(g, nullptr);
        put_pose(out, "detached", g);
        dGeomDestroy(g);
        dWorldDestroy(world);
    }
}

PARITY_CASE(geom_defaults)
{
    for (const Kind kind : kKinds) {
        out.open_block(kind_name(kind));
        const Placed placed = make_geom(kind, nullptr, rng);
        const dGeomID g = placed.geom;
        out.put("defaults",
                {static_cast<double>(dGeomGetClass(g)), static_cast<double>(dGeomIsEnabled(g)),
                 static_cast<double>(dGeomIsSpace(g)), dGeomGetBody(g) == nullptr ? 0.0 : 1.0,
                 dGeomGetSpace(g) == nullptr ? 0.0 : 1.0, dGeomGetData(g) == nullptr ? 0.0 : 1.0,
                 static_cast<double>(dGeomGetCategoryBits(g)), static_cast<double>(dGeomGetCollideBits(g))});
        dGeomDestroy(g);
    }
    const dGeomID ray = dCreateRay(nullptr, 4);
    dGeomRaySet(ray, 1, 2, 3, 0, 3, 4);
    dVector3 start = {0, 0, 0, 0}, direction = {0, 0, 0, 0};
    dGeomRayGet(ray, start, direction);
    out.open_block("ray-pose");
    out.put("start", start, 3);
    out.put("direction", direction, 3);
    out.put("length", {dGeomRayGetLength(ray), static_cast<double>(dGeomRayGetClosestHit(ray)),
                       static_cast<double>(dGeomRayGetFirstContact(ray)),
                       static_cast<double>(dGeomRayGetBackfaceCull(ray))});
    dGeomDestroy(ray);
}

}  // namespace
}  // namespace parity
