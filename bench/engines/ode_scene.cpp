// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See ode_scene.h. World parameters are ODE's own. A sprung hinge-2 is ODE's recipe for a spring and damper:
// ERP = h k / (h k + c), CFM = 1 / (h k + c).
#include "bench/engines/ode_scene.h"

#include <algorithm>
#include <iterator>

#include "scenes/extensions.h"

namespace epode::bench {

namespace {

dSpaceID make_space(const std::string& kind, double cube_side)
{
    if (kind == "sap") return dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ);
    if (kind != "quadtree") return dHashSpaceCreate(nullptr);
    const double half = cube_side > 0 ? cube_side / 2 : 200;
    const dVector3 centre = {0, 0, 0, 0}, extents = {dReal(half), dReal(half), dReal(half), 0};
    return dQuadTreeSpaceCreate(nullptr, centre, extents, 7);
}

template <class Place>
void place_at(Vec pos, Turn turn, Place place)
{
    const dQuaternion q = {dReal(turn.w), dReal(turn.x), dReal(turn.y), dReal(turn.z)};
    place(dReal(pos.x), dReal(pos.y), dReal(pos.z), q);
}

Vec vec(const dReal* v) { return {double(v[0]), double(v[1]), double(v[2])}; }

void push(std::vector<dReal>& list, Vec v) { list.insert(list.end(), {dReal(v.x), dReal(v.y), dReal(v.z)}); }

struct Nearest {
    bool hit = false;
    double distance = 0;
};

void meet_ray(void* nearest, dGeomID geom1, dGeomID geom2)
{
    dContactGeom contact;
    if (dCollide(geom1, geom2, 1, &contact, sizeof contact) == 0) return;
    Nearest& best = *static_cast<Nearest*>(nearest);
    const double distance = double(contact.depth);
    if (!best.hit || distance < best.distance) best = {true, distance};
}

}  // namespace

int body_number(dGeomID geom) { return int(reinterpret_cast<std::intptr_t>(dGeomGetData(geom))); }

OdeScene::OdeScene(const SceneData& data, const EngineOptions& options)
    : data_(data),
      options_(options),
      world_(dWorldCreate()),
      space_(make_space(options.space, data.cube_side)),
      hulls_(data.shapes.size()),
      meshes_(data.shapes.size()),
      driven_(driven_bodies(data))
{
    dWorldSetGravity(world_, 0, 0, dReal(-data.gravity));
    if (options.iterations > 0) dWorldSetQuickStepNumIterations(world_, options.iterations);
    if (options.threads > 1) scenes::set_step_threads(world_, options.threads);
    for (const ShapeData& shape : data.shapes) make_shape_arrays(shape);
    for (int i = 0; i < int(data.bodies.size()); ++i) {
        const BodyData& body = data.bodies[size_t(i)];
        kinds_.push_back({body.group, body.motion == Motion::kDynamic});
        make_body(i);
    }
    for (const JointData& joint : data.joints) make_joint(joint);
}

OdeScene::~OdeScene()
{
    if (ray_) dGeomDestroy(ray_);
    dSpaceDestroy(space_);
    dWorldDestroy(world_);
    for (const MeshArrays& mesh : meshes_) {
        if (mesh.id) dGeomTriMeshDataDestroy(mesh.id);
    }
}

void OdeScene::make_shape_arrays(const ShapeData& shape)
{
    const auto number = size_t(&shape - data_.shapes.data());
    if (shape.kind == ShapeKind::kHull) {
        HullArrays& hull = hulls_[number];
        for (Vec point : shape.points) push(hull.points, point);
        for (const auto& face : shape.triangles) {
            const Vec a = shape.points[size_t(face[0])];
            const Vec n = cross(shape.points[size_t(face[1])] - a, shape.points[size_t(face[2])] - a);
            const Vec unit = (1 / length(n)) * n;
            push(hull.planes, unit);
            hull.planes.push_back(dReal(dot(unit, a)));
            hull.polygons.insert(hull.polygons.end(),
                                 {3u, unsigned(face[0]), unsigned(face[1]), unsigned(face[2])});
        }
    }
    if (shape.kind == ShapeKind::kMesh) {
        MeshArrays& mesh = meshes_[number];
        for (Vec point : shape.points) {
            push(mesh.points, point);
            mesh.points.push_back(0);
        }
        for (const auto& t : shape.triangles)
            std::transform(t.begin(), t.end(), std::back_inserter(mesh.indices),
                           [](int i) { return dTriIndex(i); });
        mesh.id = dGeomTriMeshDataCreate();
        dGeomTriMeshDataBuildSimple(mesh.id, mesh.points.data(), int(shape.points.size()),
                                    mesh.indices.data(), int(mesh.indices.size()));
    }
}

dGeomID OdeScene::make_geom(int number)
{
    const ShapeData& shape = data_.shapes[size_t(number)];
    const dReal x = dReal(shape.size.x), y = dReal(shape.size.y), z = dReal(shape.size.z);
    HullArrays& hull = hulls_[size_t(number)];
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return dCreateSphere(space_, x);
        case ShapeKind::kBox:
            return dCreateBox(space_, x, y, z);
        case ShapeKind::kCapsule:
            return dCreateCapsule(space_, x, y);
        case ShapeKind::kCylinder:
            return dCreateCylinder(space_, x, y);
        case ShapeKind::kHull:
            return dCreateConvex(space_, hull.planes.data(), unsigned(hull.planes.size() / 4),
                                 hull.points.data(), unsigned(hull.points.size() / 3), hull.polygons.data());
        case ShapeKind::kMesh:
            break;
    }
    return dCreateTriMesh(space_, meshes_[size_t(number)].id, nullptr, nullptr, nullptr);
}

void OdeScene::make_part(int number, const PartData& part)
{
    const BodyData& body_data = data_.bodies[size_t(number)];
    dGeomID geom = make_geom(part.shape);
    dGeomSetData(geom, reinterpret_cast<void*>(std::intptr_t(number)));
    if (!geoms_[size_t(number)]) geoms_[size_t(number)] = geom;
    if (dBodyID owner = body(number)) {
        dGeomSetBody(geom, owner);
        if (body_data.motion == Motion::kDynamic) return;
        place_at(part.offset, part.turn, [&](dReal x, dReal y, dReal z, const dQuaternion q) {
            dGeomSetOffsetPosition(geom, x, y, z);
            dGeomSetOffsetQuaternion(geom, q);
        });
        return;
    }
    const Vec at = body_data.pos + rotate(body_data.turn, part.offset);
    place_at(at, body_data.turn * part.turn, [&](dReal x, dReal y, dReal z, const dQuaternion q) {
        dGeomSetPosition(geom, x, y, z);
        dGeomSetQuaternion(geom, q);
    });
}

void OdeScene::make_body(int number)
{
    const BodyData& from = data_.bodies[size_t(number)];
    geoms_.push_back(nullptr);
    bodies_.push_back(nullptr);
    // What only the broad phase looks at needs no body.
    if (from.motion != Motion::kFixed && data_.task == Task::kSimulate) {
        dBodyID made = bodies_.back() = dBodyCreate(world_);
        dMass mass;
        dMassSetParameters(
            &mass, dReal(from.mass > 0 ? from.mass : 1), 0, 0, 0, dReal(from.mass > 0 ? from.inertia.x : 1),
            dReal(from.mass > 0 ? from.inertia.y : 1), dReal(from.mass > 0 ? from.inertia.z : 1), 0, 0, 0);
        dBodySetMass(made, &mass);
        if (from.motion == Motion::kDriven) dBodySetKinematic(made);
        place_at(from.pos, from.turn, [&](dReal x, dReal y, dReal z, const dQuaternion q) {
            dBodySetPosition(made, x, y, z);
            dBodySetQuaternion(made, q);
        });
        dBodySetLinearVel(made, dReal(from.linear.x), dReal(from.linear.y), dReal(from.linear.z));
        dBodySetAngularVel(made, dReal(from.angular.x), dReal(from.angular.y), dReal(from.angular.z));
    }
    if (!from.collides) return;
    for (const PartData& part : from.parts) make_part(number, part);
}

void OdeScene::make_hinge2(const JointData& joint, dJointID made) const
{
    const double h = data_.dt, soft = h * joint.stiffness + joint.damping;
    const dVector3 axis1 = {dReal(joint.axis1.x), dReal(joint.axis1.y), dReal(joint.axis1.z), 0};
    const dVector3 axis2 = {dReal(joint.axis2.x), dReal(joint.axis2.y), dReal(joint.axis2.z), 0};
    dJointSetHinge2Axes(made, axis1, axis2);
    dJointSetHinge2Param(made, dParamLoStop, 0);
    dJointSetHinge2Param(made, dParamHiStop, 0);
    dJointSetHinge2Param(made, dParamSuspensionERP, dReal(h * joint.stiffness / soft));
    dJointSetHinge2Param(made, dParamSuspensionCFM, dReal(1 / soft));
    dJointSetHinge2Param(made, dParamVel2, dReal(joint.speed));
    dJointSetHinge2Param(made, dParamFMax2, dReal(joint.torque));
}

void OdeScene::make_joint(const JointData& joint)
{
    const dReal x = dReal(joint.anchor.x), y = dReal(joint.anchor.y), z = dReal(joint.anchor.z);
    dBodyID body1 = body(joint.body1), body2 = body(joint.body2);
    switch (joint.kind) {
        case JointKind::kBall: {
            dJointID made = dJointCreateBall(world_, nullptr);
            dJointAttach(made, body1, body2);
            dJointSetBallAnchor(made, x, y, z);
            return;
        }
        case JointKind::kHinge: {
            dJointID made = dJointCreateHinge(world_, nullptr);
            dJointAttach(made, body1, body2);
            dJointSetHingeAnchor(made, x, y, z);
            dJointSetHingeAxis(made, dReal(joint.axis1.x), dReal(joint.axis1.y), dReal(joint.axis1.z));
            if (joint.low >= joint.high) return;
            dJointSetHingeParam(made, dParamLoStop, dReal(joint.low));
            dJointSetHingeParam(made, dParamHiStop, dReal(joint.high));
            return;
        }
        case JointKind::kHinge2: {
            dJointID made = dJointCreateHinge2(world_, nullptr);
            dJointAttach(made, body1, body2);
            dJointSetHinge2Anchor(made, x, y, z);
            make_hinge2(joint, made);
            return;
        }
    }
}

bool OdeScene::may_touch(dGeomID geom1, dGeomID geom2) const
{
    const Kind a = kinds_[size_t(body_number(geom1))], b = kinds_[size_t(body_number(geom2))];
    if (!a.dynamic && !b.dynamic) return false;
    if (a.group != 0 && a.group == b.group) return false;
    if (data_.joints.empty()) return true;
    dBodyID body1 = dGeomGetBody(geom1), body2 = dGeomGetBody(geom2);
    return !body1 || !body2 || !dAreConnectedExcluding(body1, body2, dJointTypeContact);
}

void OdeScene::drive(double time)
{
    for (int i : driven_) {
        const BodyState now = driven(data_.bodies[size_t(i)], time, data_.dt);
        dBodyID moved = body(i);
        place_at(now.pos, now.turn, [&](dReal x, dReal y, dReal z, const dQuaternion q) {
            dBodySetPosition(moved, x, y, z);
            dBodySetQuaternion(moved, q);
        });
        dBodySetLinearVel(moved, dReal(now.linear.x), dReal(now.linear.y), dReal(now.linear.z));
        dBodySetAngularVel(moved, dReal(now.angular.x), dReal(now.angular.y), dReal(now.angular.z));
    }
}

int OdeScene::advance()
{
    const dReal dt = dReal(data_.dt);
    if (options_.stepper == "fast") return scenes::step_fast(world_, dt, std::max(options_.iterations, 4));
    const bool exact = options_.stepper.empty() ? data_.exact : options_.stepper == "exact";
    return exact ? dWorldStep(world_, dt) : dWorldQuickStep(world_, dt);
}

void OdeScene::read(State& state) const
{
    state.resize(data_.bodies.size());
    for (size_t i = 0; i < bodies_.size(); ++i) {
        state[i] = start_state(data_.bodies[i]);
        dBodyID from = bodies_[i];
        if (!from) continue;
        const dReal* q = dBodyGetQuaternion(from);
        state[i] = {vec(dBodyGetPosition(from)),
                    {double(q[0]), double(q[1]), double(q[2]), double(q[3])},
                    vec(dBodyGetLinearVel(from)),
                    vec(dBodyGetAngularVel(from))};
    }
}

RayAnswer OdeScene::cast(const std::vector<RayData>& rays)
{
    if (!ray_) {
        ray_ = dCreateRay(nullptr, 1);
        dGeomRaySetClosestHit(ray_, 1);
    }
    RayAnswer answer;
    for (const RayData& ray : rays) {
        const Vec along = ray.to - ray.from;
        dGeomRaySetLength(ray_, dReal(length(along)));
        dGeomRaySet(ray_, dReal(ray.from.x), dReal(ray.from.y), dReal(ray.from.z), dReal(along.x),
                    dReal(along.y), dReal(along.z));
        Nearest nearest;
        dSpaceCollide2(ray_, reinterpret_cast<dGeomID>(space_), &nearest, &meet_ray);
        answer.hits += nearest.hit;
        answer.distance += nearest.distance;
    }
    return answer;
}

int OdeScene::pairs_at(const std::vector<Vec>& places)
{
    for (size_t i = 0; i < places.size(); ++i) {
        if (!bodies_[i] && geoms_[i])
            dGeomSetPosition(geoms_[i], dReal(places[i].x), dReal(places[i].y), dReal(places[i].z));
    }
    int pairs = 0;
    dSpaceCollide(space_, &pairs, [](void* count, dGeomID, dGeomID) { ++*static_cast<int*>(count); });
    return pairs;
}

}  // namespace epode::bench
