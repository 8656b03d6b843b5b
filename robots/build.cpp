// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See build.h. Two bodies never touch if a joint connects them, so pairs that are not to touch are connected by a motor
// without axes: it has no rows, and every stepper and collision callback knows it.
#include "robots/build.h"

#include <ode/ext.h>

#include <algorithm>
#include <map>

#include "robots/body_poses.h"
#include "robots/inertia.h"
#include "robots/shape_geom.h"

namespace epode::robots {

namespace {

// Of a body between two joints, as a share of the link that it serves: motion differs by that much.
constexpr double kSmallShare = 1e-6;
// 1/s: how fast a limit takes back what is beyond it, as MuJoCo's by default at its fastest, 1/(e 20 ms).
constexpr double kStopRate = 20;
constexpr double kSmallRadius =
    0.01;  // m, about which a small body's mass is spread, if its link has no inertia

void set_mass(dBodyID body, double mass, const Matrix& i)
{
    dMass its;
    dMassSetParameters(&its, dReal(mass), 0, 0, 0, dReal(i[0][0]), dReal(i[1][1]), dReal(i[2][2]),
                       dReal(i[0][1]), dReal(i[0][2]), dReal(i[1][2]));
    dBodySetMass(body, &its);
}

void set_spring(dMaterial& material, const Spring& spring)
{
    if (!(spring.stiffness > 0)) return;
    material.compliance = dReal(1 / spring.stiffness);
    material.damping_time = dReal(spring.damping / spring.stiffness);
}

void set_touch(dGeomID geom, const Shape& shape, const Spring& spring, bool largest_friction)
{
    dGeomSetCategoryBits(geom, shape.category);
    dGeomSetCollideBits(geom, shape.collide);
    dMaterial material;
    dMaterialInit(&material, sizeof material);
    material.friction = dReal(shape.friction);
    material.rolling_friction = dReal(shape.dimensions >= 6 ? shape.rolling_friction : 0);
    set_spring(material, spring);
    if (largest_friction) material.friction_rule = dCombineMaximum;
    material.priority = shape.priority;
    dGeomSetMaterial(geom, &material);
}

dMaterial material_of(const ShapePair& pair, const Spring& spring)
{
    dMaterial material;
    dMaterialInit(&material, sizeof material);
    material.friction = dReal(pair.friction);
    material.rolling_friction = dReal(pair.dimensions >= 6 ? pair.rolling_friction : 0);
    set_spring(material, spring);
    return material;
}

Pose at_centre(const Pose& link, Vec centre) { return link * Pose{centre, {}}; }

// Mass that hangs on a link, itself included.
std::vector<double> carried_masses(const RobotModel& model)
{
    std::vector<double> out(model.links.size());
    for (size_t i = model.links.size(); i-- > 1;) {
        out[i] += model.links[i].mass;
        out[size_t(model.links[i].parent)] += out[i];
    }
    return out;
}

}  // namespace

Robot::Robot(std::shared_ptr<const Prepared> prepared, dWorldID world, dSpaceID space, const Pose& placement,
             const std::vector<double>& positions)
    : prepared_(std::move(prepared)),
      placement_(placement),
      controls_(model().actuators.size(), 0),
      activations_(model().actuators.size(), 0),
      inputs_(model().actuators.size(), 0),
      pulls_(model().actuators.size(), 0),
      servos_(model().joints.size()),
      pasts_(model().tendons.size()),
      holds_(model().ties.size(), 0),
      limits_(model().tendons.size(), 0)
{
    // What was made goes again where the rest of it cannot be made.
    const auto undo = [](Robot* robot) { robot->destroy(); };
    std::unique_ptr<Robot, decltype(undo)> unfinished(this, undo);
    make(world, space);
    if (!positions.empty()) set_positions(positions);
    unfinished.release();
}

void Robot::make(dWorldID world, dSpaceID space)
{
    world_ = world;
    reference_ = forward_kinematics(model(), reference_positions(model()));
    for (Pose& pose : reference_) pose = placement_ * pose;
    make_bodies(world);
    make_still_bodies(world);
    make_joints(world);
    for (const Closure& closure : model().closures) make_closure(world, closure);
    for (const auto& pair : model().excluded) exclude(world, pair[0], pair[1]);
    for (const auto& pair : model().excluded_still)
        keep_apart(world, body(pair[0]), still_.empty() ? body(0) : still_[size_t(pair[1]) - 1]);
    for (const auto& pair : prepared_->overlapping()) exclude(world, pair[0], pair[1]);
    for (size_t i = 0; i < model().links.size(); ++i)
        for (const Shape& shape : model().links[i].shapes) make_shape(space, int(i), shape);
    make_couplings(world);
    make_drives();
    set_drives();
}

Robot::~Robot() { destroy(); }

void Robot::destroy()
{
    for (dGeomID geom : geoms_) dGeomDestroy(geom);
    for (dJointID joint : all_joints_) dJointDestroy(joint);
    for (dBodyID body : all_bodies_) dBodyDestroy(body);
}

void Robot::place(dBodyID body, const Pose& link_pose, Vec centre) const
{
    set_pose(body, at_centre(link_pose, centre));
}

// The world's link gets a body that stands still where its shapes may have to be kept from touching others.
void Robot::make_bodies(dWorldID world)
{
    const std::vector<double> carried = carried_masses(model());
    bodies_.assign(model().links.size(), nullptr);
    for (size_t i = 0; i < model().links.size(); ++i) {
        const Link& link = model().links[i];
        if (i == 0 && (model().touches_itself || link.shapes.empty())) continue;
        const dBodyID body = dBodyCreate(world);
        if (!body) continue;
        bodies_[i] = body;
        all_bodies_.push_back(body);
        if (i == 0 || link.is_mocap) {
            dBodySetKinematic(body);
        } else if (link.mass > 0) {
            set_mass(body, link.mass,
                     fault_of(link.inertia).empty() ? link.inertia : mended(link.inertia, link.mass));
        } else {
            const double mass = std::max(1e-9, kSmallShare * carried[i]),
                         moment = mass * kSmallRadius * kSmallRadius;
            set_mass(body, mass, {{{moment, 0, 0}, {0, moment, 0}, {0, 0, moment}}});
        }
        if (link.is_weightless) dBodySetGravityMode(body, 0);
        place(body, reference_[i], link.centre);
    }
}

void Robot::make_still_bodies(dWorldID world)
{
    if (bodies_[0]) return;
    for (size_t i = 0; i < model().still.size(); ++i) {
        const dBodyID its = dBodyCreate(world);
        still_.push_back(its);
        if (!its) continue;
        all_bodies_.push_back(its);
        dBodySetKinematic(its);
        place(its, reference_[0], {});
    }
}

// 0: the shape stands in the world by itself.
dBodyID Robot::carrier(int link, const Shape& shape) const
{
    const bool is_apart = shape.still > 0 && !still_.empty() && shape.kind != ShapeKind::kPlane;
    return is_apart ? still_[size_t(shape.still) - 1] : body(link);
}

dBodyID Robot::make_small_body(dWorldID world, int number)
{
    const Link& link = model().links[size_t(number)];
    const dBodyID body = dBodyCreate(world);
    if (!body) return nullptr;
    const double mass = kSmallShare * std::max(link.mass, 1e-3);
    const double mean = (link.inertia[0][0] + link.inertia[1][1] + link.inertia[2][2]) / 3;
    const double moment = std::max(kSmallShare * mean, mass * kSmallRadius * kSmallRadius);
    set_mass(body, mass, {{{moment, 0, 0}, {0, moment, 0}, {0, 0, moment}}});
    place(body, reference_[size_t(number)], link.centre);
    all_bodies_.push_back(body);
    return body;
}

void Robot::make_joints(dWorldID world)
{
    joints_.assign(model().joints.size(), nullptr);
    turns_.assign(model().joints.size(), nullptr);
    movers_.assign(model().links.size(), 0);
    holders_.assign(model().links.size(), nullptr);
    for (size_t i = 1; i < model().links.size(); ++i) {
        const Link& link = model().links[i];
        dBodyID parent = bodies_[size_t(link.parent)];
        movers_[i] = link.is_mocap ? int(i) : movers_[size_t(link.parent)];
        if (link.joints.empty() && !link.is_mocap) {
            const dJointID fixed = dJointCreateFixed(world, nullptr);
            if (!fixed) continue;
            dJointAttach(fixed, bodies_[i], parent);
            dJointSetFixed(fixed);
            holders_[i] = fixed;
            all_joints_.push_back(fixed);
        }
        for (size_t k = 0; k < link.joints.size(); ++k) {
            const bool is_last = k + 1 == link.joints.size();
            const dBodyID child = is_last ? bodies_[i] : make_small_body(world, int(i));
            if (!is_last) small_.push_back({child, int(i), k + 1});
            const size_t number = size_t(link.joints[k]);
            joints_[number] = make_joint(world, int(number), child, parent, reference_[i]);
            if (joints_[number]) all_joints_.push_back(joints_[number]);
            if ((turns_[number] = make_turn(world, int(number), child, parent)))
                all_joints_.push_back(turns_[number]);
            holders_[i] = joints_[number];
            parent = child;
        }
        if (link.joints.size() > 1) exclude(world, link.parent, int(i));
    }
}

dJointID Robot::make_joint(dWorldID world, int number, dBodyID child, dBodyID parent, const Pose& frame)
{
    const Joint& joint = model().joints[size_t(number)];
    const Vec anchor = frame * joint.anchor, axis = rotate(frame.q, joint.axis);
    dJointID its = nullptr;
    switch (joint.kind) {
        case JointKind::kHinge:
            if (!(its = dJointCreateHinge(world, nullptr))) return nullptr;
            dJointAttach(its, child, parent);
            dJointSetHingeAnchor(its, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
            dJointSetHingeAxis(its, dReal(axis.x), dReal(axis.y), dReal(axis.z));
            break;
        case JointKind::kSlide:
            if (!(its = dJointCreateSlider(world, nullptr))) return nullptr;
            dJointAttach(its, child, parent);
            dJointSetSliderAxis(its, dReal(axis.x), dReal(axis.y), dReal(axis.z));
            break;
        case JointKind::kBall:
            if (!(its = dJointCreateBall(world, nullptr))) return nullptr;
            dJointAttach(its, child, parent);
            dJointSetBallAnchor(its, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
            break;
        case JointKind::kFree:
            return nullptr;
    }
    if (joint.is_scalar()) set_limits(number, its);
    return its;
}

// Where something acts on the turn of a ball.
dJointID Robot::make_turn(dWorldID world, int number, dBodyID child, dBodyID parent) const
{
    const Joint& joint = model().joints[size_t(number)];
    if (joint.kind != JointKind::kBall) return nullptr;
    const bool is_driven = std::any_of(model().actuators.begin(), model().actuators.end(),
                                       [&](const Actuator& a) { return a.joint == number; });
    if (!is_driven && !joint.limited && joint.stiffness <= 0 && joint.damping <= 0 && joint.armature <= 0 &&
        joint.friction <= 0)
        return nullptr;
    const dJointID its = dJointCreateAMotor(world, nullptr);
    if (!its) return nullptr;
    dJointAttach(its, child, parent);
    dJointSetAMotorMode(its, dAMotorTurn);
    if (!joint.limited) return its;
    dJointSetAMotorParam(its, dParamHiStop, dReal(std::max(joint.low, joint.high)));
    dJointSetStopRate(its, 0, dReal(kStopRate));
    const Spring spring = prepared_->springs().of_limit(model(), number);
    if (spring.stiffness > 0) dJointSetStopSpring(its, 0, dReal(spring.stiffness), dReal(spring.damping));
    return its;
}

void Robot::set_limits(int number, dJointID its) const
{
    const Joint& joint = model().joints[size_t(number)];
    if (joint.kind == JointKind::kHinge) dJointSetAxisContinuous(its, 0, 1);
    if (!joint.limited) return;
    const double low = joint.low - joint.reference, high = joint.high - joint.reference;
    if (joint.kind == JointKind::kSlide) {
        dJointSetSliderParam(its, dParamHiStop, dReal(high));
        dJointSetSliderParam(its, dParamLoStop, dReal(low));
    } else {
        dJointSetHingeParam(its, dParamLoStop, dReal(low));
        dJointSetHingeParam(its, dParamHiStop, dReal(high));
    }
    dJointSetStopRate(its, 0, dReal(kStopRate));
    const Spring spring = prepared_->springs().of_limit(model(), number);
    if (spring.stiffness > 0) dJointSetStopSpring(its, 0, dReal(spring.stiffness), dReal(spring.damping));
}

// The loop is closed where its ends meet: body 2 is moved there while the joint takes its measure.
void Robot::make_closure(dWorldID world, const Closure& closure)
{
    const dBodyID one = body(closure.link1), two = body(closure.link2);
    const dBodyID moved = two ? two : one;
    if (!moved || one == two) return;
    const Pose end1 = reference_[size_t(closure.link1)] * closure.pose1;
    const Pose end2 = reference_[size_t(closure.link2)] * closure.pose2;
    Pose onto = two ? end1 * inverse(end2) : end2 * inverse(end1);
    if (!closure.weld) onto = {two ? end1.p - end2.p : end2.p - end1.p, {}};
    const Vec anchor = two ? end1.p : end2.p;
    const dJointID joint =
        closure.weld ? dJointCreateFixed(world, nullptr) : dJointCreateBall(world, nullptr);
    if (!joint) return;
    all_joints_.push_back(joint);
    const Pose before = pose_of(moved);
    set_pose(moved, onto * before);
    dJointAttach(joint, one ? one : two, one ? two : nullptr);
    if (closure.weld)
        dJointSetFixed(joint);
    else
        dJointSetBallAnchor(joint, dReal(anchor.x), dReal(anchor.y), dReal(anchor.z));
    set_pose(moved, before);
}

void Robot::exclude(dWorldID world, int link1, int link2) { keep_apart(world, body(link1), body(link2)); }

void Robot::keep_apart(dWorldID world, dBodyID one, dBodyID two)
{
    if (!one || !two || one == two || dAreConnected(one, two)) return;
    const dJointID motor = dJointCreateAMotor(world, nullptr);
    if (!motor) return;
    dJointAttach(motor, one, two);
    all_joints_.push_back(motor);
}

void Robot::make_shape(dSpaceID space, int link, const Shape& shape)
{
    if (shape.kind == ShapeKind::kPlane && body(link)) return;  // a plane does not move
    for (int part = 0; part < parts_of(*prepared_, shape); ++part) {
        const dGeomID geom = make_geom(space, *prepared_, shape, part);
        if (geom && shape.kind == ShapeKind::kPlane) put_plane(geom, reference_[size_t(link)] * shape.pose);
        add_geom(geom, link, shape);
    }
}

void Robot::add_geom(dGeomID geom, int number, const Shape& shape)
{
    if (!geom) return;
    const Link& link = model().links[size_t(number)];
    const dBodyID its = carrier(number, shape);
    geoms_.push_back(geom);
    colors_.push_back({shape.color[0], shape.color[1], shape.color[2]});
    const Pose offset = (its ? Pose{-link.centre, {}} : reference_[size_t(number)]) * geom_pose(shape);
    const dQuaternion q = {dReal(offset.q.w), dReal(offset.q.x), dReal(offset.q.y), dReal(offset.q.z)};
    if (its) {
        dGeomSetBody(geom, its);
        dGeomSetOffsetPosition(geom, dReal(offset.p.x), dReal(offset.p.y), dReal(offset.p.z));
        dGeomSetOffsetQuaternion(geom, q);
    } else if (shape.kind != ShapeKind::kPlane) {
        dGeomSetPosition(geom, dReal(offset.p.x), dReal(offset.p.y), dReal(offset.p.z));
        dGeomSetQuaternion(geom, q);
    }
    set_touch(geom, shape, prepared_->springs().of_shape(number, shape), model().largest_friction);
    set_pairs(geom, shape);
}

void Robot::set_pairs(dGeomID geom, const Shape& shape) const
{
    const PairRules* const rules = prepared_->pairs().of(shape);
    if (!rules) return;
    dGeomSetCategoryBits(geom, shape.category | rules->category);
    dGeomSetCollideBits(geom, shape.collide | rules->collide);
    dMaterial own;
    dMaterialInit(&own, sizeof own);
    dGeomGetMaterial(geom, &own);
    own.kind = rules->kind;
    dGeomSetMaterial(geom, &own);
    for (const auto& [number, pair] : rules->materials) {
        const ShapePair& its = model().pairs[size_t(pair)];
        int one = 0, two = 0;
        shape_named(model(), its.shape1, one), shape_named(model(), its.shape2, two);
        const dMaterial material = material_of(its, prepared_->springs().of_pair(one, two, its.softness));
        dGeomSetFaceMaterial(geom, number, &material);
    }
}

void Robot::add_looks(dSpaceID space)
{
    for (size_t i = 0; i < model().links.size(); ++i) {
        if (!model().links[i].shapes.empty()) continue;
        for (Shape look : model().links[i].visuals) {
            look.category = look.collide = 0;
            make_shape(space, int(i), look);
        }
    }
}

Robot::Robot(const Robot& like, int)
    : prepared_(like.prepared_),
      placement_(like.placement_),
      reference_(like.reference_),
      bodies_(like.bodies_),
      all_bodies_(like.all_bodies_),
      joints_(like.joints_),
      turns_(like.turns_),
      tendons_(like.tendons_),
      all_joints_(like.all_joints_),
      holders_(like.holders_),
      still_(like.still_),
      movers_(like.movers_),
      world_(like.world_),
      geoms_(like.geoms_),
      colors_(like.colors_),
      small_(like.small_),
      controls_(like.controls_),
      activations_(like.activations_),
      inputs_(like.inputs_),
      filters_act_(like.filters_act_),
      pulls_(like.pulls_),
      servos_(like.servos_),
      pasts_(like.pasts_),
      bends_(like.bends_),
      holds_(like.holds_),
      limits_(like.limits_),
      time_(like.time_)
{}

std::unique_ptr<Robot> Robot::counterpart(const std::vector<dBodyID>& bodies,
                                          const std::vector<dJointID>& joints,
                                          const std::vector<dGeomID>& geoms) const
{
    if (bodies.size() != all_bodies_.size() || joints.size() != all_joints_.size() ||
        geoms.size() != geoms_.size() || bodies.empty())
        return nullptr;
    std::unique_ptr<Robot> out(new Robot(*this, 0));
    std::map<dBodyID, dBodyID> body_for;
    std::map<dJointID, dJointID> joint_for;
    for (size_t i = 0; i < bodies.size(); ++i) body_for[all_bodies_[i]] = bodies[i];
    for (size_t i = 0; i < joints.size(); ++i) joint_for[all_joints_[i]] = joints[i];
    for (auto* all : {&out->bodies_, &out->still_, &out->all_bodies_})
        for (dBodyID& one : *all) one = one ? body_for[one] : nullptr;
    for (Bent& bent : out->bends_) bent.joint = joint_for[bent.joint];
    for (auto* all : {&out->joints_, &out->turns_, &out->tendons_, &out->holders_, &out->all_joints_})
        for (dJointID& one : *all) one = one ? joint_for[one] : nullptr;
    for (Small& small : out->small_) small.body = body_for[small.body];
    out->geoms_ = geoms, out->world_ = dBodyGetWorld(bodies[0]);
    return out;
}

void Robot::release()
{
    geoms_.clear();
    all_joints_.clear();
    all_bodies_.clear();
}

}  // namespace epode::robots
