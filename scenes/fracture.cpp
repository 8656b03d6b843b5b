// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scenes/fracture.h"

#include "record/watch/lookup.h"

namespace epode::scenes {

#define EPODE_FOUND(name) reinterpret_cast<decltype(&(name))>(record::library_function(#name))

dBodyID add_breakable(Scene& scene, const std::vector<dFracturePart>& parts, double strength, double radius)
{
    const auto create = EPODE_FOUND(dFractureCreate);
    const auto update = EPODE_FOUND(dFractureUpdate);
    if (!create || !update) return nullptr;
    scene.before_step([&scene, update, parts, strength, radius](double, double) {
        const dFracture one = {parts.data(), int(parts.size()), dReal(strength), dReal(radius)};
        update(scene.world(), &one, 1);
    });
    return create(scene.world(), parts.data(), int(parts.size()));
}

}  // namespace epode::scenes
