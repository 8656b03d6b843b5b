// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Debian's Bullet, in floats and on one thread, as its manual sets it up: dynamic tree, sequential impulses
// with 10 iterations, margins as they come (a hull's 4 cm stand outside it), one step of dt a call, nobody
// sleeps. Bullet multiplies the frictions of two bodies, so each gets the root of the scene's.
#include <btBulletDynamicsCommon.h>

#include <cmath>
#include <deque>

#include "bench/engines/engine.h"
#include "bench/engines/stopwatch.h"

namespace epode::bench {

namespace {

btVector3 to_bullet(Vec v) { return {btScalar(v.x), btScalar(v.y), btScalar(v.z)}; }
Vec from_bullet(const btVector3& v) { return {double(v.x()), double(v.y()), double(v.z())}; }

btTransform to_bullet(Vec pos, Turn q)
{
    const btQuaternion turn(btScalar(q.x), btScalar(q.y), btScalar(q.z), btScalar(q.w));
    return btTransform(turn, to_bullet(pos));
}

// The world's own step, with its two parts timed.
class TimedWorld : public btDiscreteDynamicsWorld {
  public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

    void performDiscreteCollisionDetection() override
    {
        times.rest += watch.lap();
        btDiscreteDynamicsWorld::performDiscreteCollisionDetection();
        times.collide += watch.lap();
    }
    void solveConstraints(btContactSolverInfo& info) override
    {
        times.rest += watch.lap();
        btDiscreteDynamicsWorld::solveConstraints(info);
        times.solve += watch.lap();
    }

    Stopwatch watch{false};
    StageTimes times;
};

struct GroupFilter : btOverlapFilterCallback {
    bool needBroadphaseCollision(btBroadphaseProxy* proxy1, btBroadphaseProxy* proxy2) const override
    {
        if (!(proxy1->m_collisionFilterGroup & proxy2->m_collisionFilterMask) ||
            !(proxy2->m_collisionFilterGroup & proxy1->m_collisionFilterMask))
            return false;
        const auto group = [](const btBroadphaseProxy* p) {
            return static_cast<const btCollisionObject*>(p->m_clientObject)->getUserIndex();
        };
        return group(proxy1) <= 0 || group(proxy1) != group(proxy2);
    }
};

class BulletEngine : public Engine {
  public:
    BulletEngine(const SceneData& data, const EngineOptions& options);
    ~BulletEngine() override;

    std::string version() const override
    {
        return "Bullet " + std::to_string(btGetVersion() / 100) + "." + std::to_string(btGetVersion() % 100);
    }
    StageTimes step(double time) override;
    void read(State& state) const override;
    RayAnswer cast(const std::vector<RayData>& rays) override;
    int pairs_at(const std::vector<Vec>& places) override;
    int contacts() override;

  private:
    btCollisionShape* make_shape(const ShapeData& shape);
    btCollisionShape* make_mesh(const ShapeData& shape);
    btCollisionShape* body_shape(const BodyData& body);
    void make_body(const BodyData& body);
    void make_joint(const JointData& joint);
    btTransform local(int body, Vec anchor, Turn frame) const;

    const SceneData& data_;
    btDefaultCollisionConfiguration configuration_;
    btCollisionDispatcher dispatcher_{&configuration_};
    btDbvtBroadphase broadphase_;
    btSequentialImpulseConstraintSolver solver_;
    GroupFilter filter_;
    TimedWorld world_{&dispatcher_, &broadphase_, &solver_, &configuration_};
    std::deque<std::unique_ptr<btTriangleIndexVertexArray>> meshes_;
    std::deque<std::vector<btScalar>> mesh_points_;
    std::vector<std::unique_ptr<btCollisionShape>> shapes_, compounds_;
    std::vector<std::unique_ptr<btRigidBody>> bodies_;
    std::vector<std::unique_ptr<btTypedConstraint>> joints_;
    std::vector<int> driven_;
};

BulletEngine::BulletEngine(const SceneData& data, const EngineOptions& options)
    : data_(data), driven_(driven_bodies(data))
{
    world_.setGravity({0, 0, btScalar(-data.gravity)});
    world_.getPairCache()->setOverlapFilterCallback(&filter_);
    if (options.iterations > 0) world_.getSolverInfo().m_numIterations = options.iterations;
    for (const ShapeData& shape : data.shapes) shapes_.emplace_back(make_shape(shape));
    for (const BodyData& body : data.bodies) make_body(body);
    for (const JointData& joint : data.joints) make_joint(joint);
}

BulletEngine::~BulletEngine()
{
    for (const auto& joint : joints_) world_.removeConstraint(joint.get());
    for (const auto& body : bodies_) world_.removeRigidBody(body.get());
}

btCollisionShape* BulletEngine::make_mesh(const ShapeData& shape)
{
    auto& points = mesh_points_.emplace_back();
    for (Vec p : shape.points) points.insert(points.end(), {btScalar(p.x), btScalar(p.y), btScalar(p.z)});
    auto mesh = std::make_unique<btTriangleIndexVertexArray>(
        int(shape.triangles.size()), const_cast<int*>(shape.triangles.data()->data()), int(3 * sizeof(int)),
        int(shape.points.size()), points.data(), int(3 * sizeof(btScalar)));
    return new btBvhTriangleMeshShape(meshes_.emplace_back(std::move(mesh)).get(), true);
}

btCollisionShape* BulletEngine::make_shape(const ShapeData& shape)
{
    const btScalar radius = btScalar(shape.size.x), along = btScalar(shape.size.y);
    switch (shape.kind) {
        case ShapeKind::kSphere:
            return new btSphereShape(radius);
        case ShapeKind::kBox:
            return new btBoxShape(to_bullet(0.5 * shape.size));
        case ShapeKind::kCapsule:
            return new btCapsuleShapeZ(radius, along);
        case ShapeKind::kCylinder:
            return new btCylinderShapeZ({radius, radius, along / 2});
        case ShapeKind::kHull: {
            auto* hull = new btConvexHullShape;
            for (Vec point : shape.points) hull->addPoint(to_bullet(point), false);
            hull->recalcLocalAabb();
            return hull;
        }
        case ShapeKind::kMesh:
            break;
    }
    return make_mesh(shape);
}

btCollisionShape* BulletEngine::body_shape(const BodyData& body)
{
    if (body.parts.size() == 1) return shapes_[size_t(body.parts[0].shape)].get();
    auto* compound = new btCompoundShape;
    for (const PartData& part : body.parts)
        compound->addChildShape(to_bullet(part.offset, part.turn), shapes_[size_t(part.shape)].get());
    return compounds_.emplace_back(compound).get();
}

void BulletEngine::make_body(const BodyData& from)
{
    const bool dynamic = from.motion == Motion::kDynamic;
    btRigidBody::btRigidBodyConstructionInfo info(dynamic ? btScalar(from.mass) : 0, nullptr,
                                                  body_shape(from),
                                                  dynamic ? to_bullet(from.inertia) : btVector3(0, 0, 0));
    info.m_startWorldTransform = to_bullet(from.pos, from.turn);
    info.m_friction = btScalar(std::sqrt(data_.friction));
    btRigidBody* body = bodies_.emplace_back(std::make_unique<btRigidBody>(info)).get();
    body->setActivationState(DISABLE_DEACTIVATION);
    body->setUserIndex(from.group);
    body->setLinearVelocity(to_bullet(from.linear));
    body->setAngularVelocity(to_bullet(from.angular));
    if (from.motion == Motion::kDriven)
        body->setCollisionFlags(body->getCollisionFlags() | btCollisionObject::CF_KINEMATIC_OBJECT);
    if (!from.collides) {
        world_.addRigidBody(body, 0, 0);
    } else {
        world_.addRigidBody(body);
    }
}

btTransform BulletEngine::local(int body, Vec anchor, Turn frame) const
{
    return bodies_[size_t(body)]->getWorldTransform().inverse() * to_bullet(anchor, frame);
}

// Frames of Bullet's hinge have it about z; those of its hinge-2 are given by the world's axes.
void BulletEngine::make_joint(const JointData& joint)
{
    btRigidBody &body1 = *bodies_[size_t(joint.body1)], &body2 = *bodies_[size_t(joint.body2)];
    std::unique_ptr<btTypedConstraint> made;
    if (joint.kind == JointKind::kBall) {
        made = std::make_unique<btPoint2PointConstraint>(body1, body2,
                                                         local(joint.body1, joint.anchor, {}).getOrigin(),
                                                         local(joint.body2, joint.anchor, {}).getOrigin());
    } else if (joint.kind == JointKind::kHinge) {
        const Vec z = joint.axis1, side = cross(scenes::kZ, z);
        const double angle = std::atan2(length(side), z.z);
        const Turn frame = length(side) > 1e-9 ? scenes::turn(side, angle) : Turn{};
        auto hinge = std::make_unique<btHingeConstraint>(
            body1, body2, local(joint.body1, joint.anchor, frame), local(joint.body2, joint.anchor, frame));
        // Bullet counts a hinge's angle the other way round.
        if (joint.low < joint.high) hinge->setLimit(btScalar(-joint.high), btScalar(-joint.low));
        made = std::move(hinge);
    } else {
        btVector3 anchor = to_bullet(joint.anchor), axis1 = to_bullet(joint.axis1),
                  axis2 = to_bullet(joint.axis2);
        auto hinge2 = std::make_unique<btHinge2Constraint>(body1, body2, anchor, axis1, axis2);
        hinge2->setLowerLimit(0);
        hinge2->setUpperLimit(0);
        hinge2->setStiffness(2, btScalar(joint.stiffness));
        hinge2->setDamping(2, btScalar(joint.damping));
        if (joint.torque > 0) {
            hinge2->enableMotor(3, true);
            hinge2->setTargetVelocity(3, btScalar(joint.speed));
            hinge2->setMaxMotorForce(3, btScalar(joint.torque));
        }
        made = std::move(hinge2);
    }
    world_.addConstraint(made.get(), true);
    joints_.push_back(std::move(made));
}

StageTimes BulletEngine::step(double time)
{
    world_.times = {};
    world_.watch.lap();
    for (int i : driven_) {
        // A body moved by hand is asked where it will be: Bullet takes its velocity from the difference.
        const BodyState there = driven(data_.bodies[size_t(i)], time + data_.dt, data_.dt);
        bodies_[size_t(i)]->setWorldTransform(to_bullet(there.pos, there.turn));
    }
    world_.stepSimulation(btScalar(data_.dt), 0);
    world_.times.rest += world_.watch.lap();
    return world_.times;
}

void BulletEngine::read(State& state) const
{
    state.resize(bodies_.size());
    for (size_t i = 0; i < bodies_.size(); ++i) {
        const btRigidBody& body = *bodies_[i];
        const btQuaternion q = body.getWorldTransform().getRotation();
        state[i] = {from_bullet(body.getWorldTransform().getOrigin()),
                    {double(q.w()), double(q.x()), double(q.y()), double(q.z())},
                    from_bullet(body.getLinearVelocity()),
                    from_bullet(body.getAngularVelocity())};
    }
}

RayAnswer BulletEngine::cast(const std::vector<RayData>& rays)
{
    RayAnswer answer;
    for (const RayData& ray : rays) {
        const btVector3 from = to_bullet(ray.from), to = to_bullet(ray.to);
        btCollisionWorld::ClosestRayResultCallback nearest(from, to);
        world_.rayTest(from, to, nearest);
        if (!nearest.hasHit()) continue;
        ++answer.hits;
        answer.distance += double(nearest.m_closestHitFraction) * length(ray.to - ray.from);
    }
    return answer;
}

int BulletEngine::pairs_at(const std::vector<Vec>& places)
{
    for (size_t i = 0; i < places.size(); ++i)
        bodies_[i]->getWorldTransform().setOrigin(to_bullet(places[i]));
    world_.updateAabbs();
    world_.computeOverlappingPairs();
    return broadphase_.getOverlappingPairCache()->getNumOverlappingPairs();
}

int BulletEngine::contacts()
{
    int count = 0;
    for (int i = 0; i < dispatcher_.getNumManifolds(); ++i)
        count += dispatcher_.getManifoldByIndexInternal(i)->getNumContacts();
    return count;
}

std::unique_ptr<Engine> make(const SceneData& data, const EngineOptions& options, std::string& refusal)
{
    if (options.threads > 1) refusal = "Bullet is built for one thread here";
    if (!refusal.empty()) return nullptr;
    return std::make_unique<BulletEngine>(data, options);
}

}  // namespace

extern const EngineEntry kBulletEngine = {"bullet", "Debian's Bullet, one thread", make};

}  // namespace epode::bench
