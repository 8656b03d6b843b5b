// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// The entities of the engine under their numbers, and the base of all features. A number is never used twice. An identity of gz-physics
// is the number together with a reference to the entity; frames are known by the number alone.
#pragma once

#include <unordered_map>

#include "integrations/gazebo/entities.h"
#include "integrations/gazebo/names.h"

namespace epode::gazebo {

using gz::physics::Identity;

class Store : public virtual gz::physics::Feature::Implementation<gz::physics::FeaturePolicy3d> {
  public:
    Store();
    ~Store() override;
    Store(const Store&) = delete;
    Store& operator=(const Store&) = delete;
    // There is one engine, number 0.
    Identity InitiateEngine(std::size_t engine) override;

  protected:
    template <class T>
    std::shared_ptr<T> make(const std::string& name)
    {
        auto made = std::make_shared<T>();
        made->id = ++last_, made->name = name;
        entities_.emplace(made->id, made);
        return made;
    }
    Identity identity_of(const Entity* entity) const;
    // The entity of an identity; null, with a message, of a removed one and of one of another kind.
    template <class T>
    T* get(const Identity& identity) const
    {
        T* const found = dynamic_cast<T*>(ReferenceInterface<Entity>(identity));
        if (found && !found->is_removed) return found;
        EPODE_GAZEBO_ERROR << "entity " << std::size_t(identity)
                           << " is none of that kind, or has been removed\n";
        return nullptr;
    }
    // Null of a number that nothing has.
    Entity* find(std::size_t id) const;
    std::shared_ptr<Entity> share(const Entity& entity) const { return entities_.at(entity.id); }
    // Takes the entity out of the store and marks it.
    void forget(Entity& entity);

    std::vector<std::shared_ptr<World>> worlds_;

  private:
    std::unordered_map<std::size_t, std::shared_ptr<Entity>> entities_;
    std::size_t last_ = 0;
};

// By its number or its name in a list of shared pointers to entities; null where there is none.
template <class List>
auto* at(const List& list, std::size_t index)
{
    return index < list.size() ? list[index].get() : nullptr;
}
template <class List>
auto* named(const List& list, const std::string& name)
{
    for (const auto& entity : list)
        if (entity->name == name) return entity.get();
    return static_cast<decltype(list[0].get())>(nullptr);
}
// Its size where the entity is not in the list.
template <class List>
std::size_t index_in(const List& list, const Entity* entity)
{
    std::size_t i = 0;
    while (i < list.size() && list[i].get() != entity) ++i;
    return i;
}

}  // namespace epode::gazebo
