// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Births, deaths and who goes along with whom, by the rules of the guide.
#include "model.h"

namespace epode::sequences {

Body& Model::born_body(dBodyID id, World& world)
{
    Body& body = bodies.add(id);
    body.world = &world;
    world.bodies.push_back(&body);
    return body;
}

Joint& Model::born_joint(dJointID id, World& world, Group* group, int kind)
{
    Joint& joint = joints.add(id);
    joint.world = &world;
    joint.group = group;
    joint.kind = kind;
    world.joints.push_back(&joint);
    if (group) group->joints.push_back(&joint);
    return joint;
}

Geom& Model::born_geom(dGeomID id, Geom* space)
{
    Geom& geom = geoms.add(id);
    if (space) join(geom, *space);
    return geom;
}

void Model::attach(Joint& joint, Body* a, Body* b)
{
    for (Body*& body : joint.body) {
        if (body) forget(body->joints, &joint);
        body = nullptr;
    }
    joint.body[0] = a;
    joint.body[1] = b;
    for (Body* body : joint.body)
        if (body) body->joints.push_back(&joint);
}

void Model::set_body(Geom& geom, Body* body)
{
    if (geom.body == body) return;
    if (geom.body) forget(geom.body->geoms, &geom);
    geom.body = body;
    if (body) body->geoms.push_back(&geom);
}

void Model::join(Geom& geom, Geom& space)
{
    geom.space = &space;
    space.members.push_back(&geom);
}

void Model::leave(Geom& geom)
{
    if (geom.space) forget(geom.space->members, &geom);
    geom.space = nullptr;
}

void Model::hold(Geom& transform, Geom* inner)
{
    Geom* old = transform.inner;
    if (old == inner) return;
    if (old) forget(old->holders, &transform);
    transform.inner = inner;
    if (inner) inner->holders.push_back(&transform);
    if (old && transform.inner_cleanup) kill(*old);
}

void Model::let_go(Body& body)
{
    if (!forgetful)
        while (!body.joints.empty()) attach(*body.joints.back(), nullptr, nullptr);
    while (!body.geoms.empty()) set_body(*body.geoms.back(), nullptr);
}

void Model::kill(World& world)
{
    while (!world.bodies.empty()) kill(*world.bodies.back());
    while (!world.joints.empty()) {
        Joint& joint = *world.joints.back();
        if (joint.group) {
            attach(joint, nullptr, nullptr);
            joint.world = nullptr;
            world.joints.pop_back();
        } else {
            kill(joint);
        }
    }
    worlds.bury(world);
}

void Model::kill(Body& body)
{
    let_go(body);
    forget(body.world->bodies, &body);
    bodies.bury(body);
}

void Model::kill(Joint& joint)
{
    attach(joint, nullptr, nullptr);
    if (joint.world) forget(joint.world->joints, &joint);
    if (joint.group) forget(joint.group->joints, &joint);
    joints.bury(joint);
}

void Model::empty(Group& group)
{
    while (!group.joints.empty()) kill(*group.joints.back());
}

void Model::kill(Group& group)
{
    empty(group);
    groups.bury(group);
}

void Model::kill(Geom& geom)
{
    while (!geom.members.empty()) {
        Geom& member = *geom.members.back();
        geom.cleanup ? kill(member) : leave(member);
    }
    while (!geom.holders.empty()) {
        geom.holders.back()->inner = nullptr;
        geom.holders.pop_back();
    }
    leave(geom);
    set_body(geom, nullptr);
    geoms.bury(geom);
    if (geom.inner) hold(geom, nullptr);
}

bool Model::holds(const Geom& geom, const Geom& transform)
{
    for (const Geom* g = &geom; g; g = g->inner)
        if (g == &transform) return true;
    return false;
}

bool Model::inside(const Geom& geom, const Geom& space)
{
    for (const Geom* g = &geom; g; g = g->space)
        if (g == &space) return true;
    return false;
}

}  // namespace epode::sequences
