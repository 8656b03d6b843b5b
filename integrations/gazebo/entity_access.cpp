// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See entity_access.h.
#include "integrations/gazebo/entity_access.h"

#include <algorithm>

#include "integrations/gazebo/joints.h"
#include "integrations/gazebo/links.h"
#include "integrations/gazebo/shapes.h"

namespace epode::gazebo {

namespace {

const std::string kNoName;

template <class List>
void take_out(List& list, const Entity* entity)
{
    const std::size_t index = index_in(list, entity);
    if (index < list.size()) list.erase(list.begin() + std::ptrdiff_t(index));
}

auto& siblings(Model& model) { return model.parent ? model.parent->models : model.world->models; }

}  // namespace

// Members of an entity, by number or name.
template <class T, class List>
Identity EntityAccess::by(const Identity& owner, List T::*list, std::size_t index) const
{
    const T* const found = get<T>(owner);
    return identity_of(found ? at(found->*list, index) : nullptr);
}
template <class T, class List>
Identity EntityAccess::by(const Identity& owner, List T::*list, const std::string& name) const
{
    const T* const found = get<T>(owner);
    return identity_of(found ? named(found->*list, name) : nullptr);
}
template <class T>
const std::string& EntityAccess::name_of(const Identity& identity) const
{
    const T* const found = get<T>(identity);
    return found ? found->name : kNoName;
}

const std::string& EntityAccess::GetEngineName(const Identity&) const
{
    static const std::string kName = "epode";
    return kName;
}

Identity EntityAccess::GetWorld(const Identity&, std::size_t index) const
{
    return identity_of(at(worlds_, index));
}
Identity EntityAccess::GetWorld(const Identity&, const std::string& name) const
{
    return identity_of(named(worlds_, name));
}
const std::string& EntityAccess::GetWorldName(const Identity& world) const { return name_of<World>(world); }
std::size_t EntityAccess::GetWorldIndex(const Identity& world) const
{
    return index_in(worlds_, get<World>(world));
}

std::size_t EntityAccess::GetModelCount(const Identity& world) const
{
    const World* const found = get<World>(world);
    return found ? found->models.size() : 0;
}
Identity EntityAccess::GetModel(const Identity& world, std::size_t index) const
{
    return by(world, &World::models, index);
}
Identity EntityAccess::GetModel(const Identity& world, const std::string& name) const
{
    return by(world, &World::models, name);
}
const std::string& EntityAccess::GetModelName(const Identity& model) const { return name_of<Model>(model); }
std::size_t EntityAccess::GetModelIndex(const Identity& model) const
{
    Model* const found = get<Model>(model);
    return found ? index_in(siblings(*found), found) : 0;
}
Identity EntityAccess::GetWorldOfModel(const Identity& model) const
{
    const Model* const found = get<Model>(model);
    return identity_of(found ? found->world : nullptr);
}

std::size_t EntityAccess::GetNestedModelCount(const Identity& model) const
{
    const Model* const found = get<Model>(model);
    return found ? found->models.size() : 0;
}
Identity EntityAccess::GetNestedModel(const Identity& model, std::size_t index) const
{
    return by(model, &Model::models, index);
}
Identity EntityAccess::GetNestedModel(const Identity& model, const std::string& name) const
{
    return by(model, &Model::models, name);
}

std::size_t EntityAccess::GetLinkCount(const Identity& model) const
{
    const Model* const found = get<Model>(model);
    return found ? found->links.size() : 0;
}
Identity EntityAccess::GetLink(const Identity& model, std::size_t index) const
{
    return by(model, &Model::links, index);
}
Identity EntityAccess::GetLink(const Identity& model, const std::string& name) const
{
    return by(model, &Model::links, name);
}
const std::string& EntityAccess::GetLinkName(const Identity& link) const { return name_of<Link>(link); }
std::size_t EntityAccess::GetLinkIndex(const Identity& link) const
{
    const Link* const found = get<Link>(link);
    return found ? index_in(found->model->links, found) : 0;
}
Identity EntityAccess::GetModelOfLink(const Identity& link) const
{
    const Link* const found = get<Link>(link);
    return identity_of(found ? found->model : nullptr);
}

std::size_t EntityAccess::GetJointCount(const Identity& model) const
{
    const Model* const found = get<Model>(model);
    return found ? found->joints.size() : 0;
}
Identity EntityAccess::GetJoint(const Identity& model, std::size_t index) const
{
    return by(model, &Model::joints, index);
}
Identity EntityAccess::GetJoint(const Identity& model, const std::string& name) const
{
    return by(model, &Model::joints, name);
}
const std::string& EntityAccess::GetJointName(const Identity& joint) const { return name_of<Joint>(joint); }
std::size_t EntityAccess::GetJointIndex(const Identity& joint) const
{
    const Joint* const found = get<Joint>(joint);
    return found ? index_in(found->model->joints, found) : 0;
}
Identity EntityAccess::GetModelOfJoint(const Identity& joint) const
{
    const Joint* const found = get<Joint>(joint);
    return identity_of(found ? found->model : nullptr);
}

std::size_t EntityAccess::GetShapeCount(const Identity& link) const
{
    const Link* const found = get<Link>(link);
    return found ? found->shapes.size() : 0;
}
Identity EntityAccess::GetShape(const Identity& link, std::size_t index) const
{
    return by(link, &Link::shapes, index);
}
Identity EntityAccess::GetShape(const Identity& link, const std::string& name) const
{
    return by(link, &Link::shapes, name);
}
const std::string& EntityAccess::GetShapeName(const Identity& shape) const { return name_of<Shape>(shape); }
std::size_t EntityAccess::GetShapeIndex(const Identity& shape) const
{
    const Shape* const found = get<Shape>(shape);
    return found ? index_in(found->link->shapes, found) : 0;
}
Identity EntityAccess::GetLinkOfShape(const Identity& shape) const
{
    const Shape* const found = get<Shape>(shape);
    return identity_of(found ? found->link : nullptr);
}

bool EntityAccess::RemoveModelByIndex(const Identity& world, std::size_t index)
{
    World* const found = get<World>(world);
    return found && remove(at(found->models, index));
}
bool EntityAccess::RemoveModelByName(const Identity& world, const std::string& name)
{
    World* const found = get<World>(world);
    return found && remove(named(found->models, name));
}
bool EntityAccess::RemoveModel(const Identity& model) { return remove(get<Model>(model)); }

// Asked of removed models too: no message.
bool EntityAccess::ModelRemoved(const Identity& model) const
{
    const Entity* const found = ReferenceInterface<Entity>(model);
    return !found || found->is_removed;
}
bool EntityAccess::RemoveNestedModelByIndex(const Identity& model, std::size_t index)
{
    Model* const found = get<Model>(model);
    return found && remove(at(found->models, index));
}
bool EntityAccess::RemoveNestedModelByName(const Identity& model, const std::string& name)
{
    Model* const found = get<Model>(model);
    return found && remove(named(found->models, name));
}

bool EntityAccess::remove(Model* model)
{
    if (!model) return false;
    const auto kept = share(*model);
    remove_all_of(*model);
    take_out(siblings(*model), model);
    return true;
}

void EntityAccess::remove_all_of(Model& model)
{
    for (const auto& inner : model.models) remove_all_of(*inner);
    while (!model.joints.empty()) remove_joint(*model.joints.back());
    for (const auto& link : model.links) remove_link(*link);
    model.models.clear(), model.links.clear();
    model.root = nullptr;
    if (model.group) forget(*model.group);
    forget(model);
}

void EntityAccess::remove_link(Link& link)
{
    while (!link.joints.empty()) remove_joint(*link.joints.back());
    for (const auto& shape : link.shapes) destroy_geoms(*shape), forget(*shape);
    link.shapes.clear();
    if (link.body) dBodyDestroy(link.body);
    link.body = nullptr;
    if (link.group) forget(*link.group);
    for (Model* outer = link.model->parent; outer; outer = outer->parent)
        if (outer->root == &link) outer->root = nullptr;
    forget(link);
}

void EntityAccess::remove_joint(Joint& joint)
{
    const auto kept = share(joint);
    for (Link* end : {joint.parent, joint.child}) {
        if (!end) continue;
        wake(*end);
        end->joints.erase(std::remove(end->joints.begin(), end->joints.end(), &joint), end->joints.end());
    }
    for (dJointID mimic : joint.mimics) dJointDestroy(mimic);
    joint.mimics.clear();
    destroy_joint(joint);
    take_out(joint.model->joints, &joint);
    forget(joint);
}

}  // namespace epode::gazebo
