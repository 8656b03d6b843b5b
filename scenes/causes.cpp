// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "scenes/causes.h"

#include <algorithm>

#include "scenes/extensions.h"

namespace epode::scenes {

namespace {

std::int32_t number_of(const Scene& scene, dBodyID body)
{
    const auto& all = scene.bodies();
    const auto found = body ? std::find(all.begin(), all.end(), body) : all.end();
    return found == all.end() ? -1 : std::int32_t(found - all.begin());
}

}  // namespace

std::vector<Cause> causes_of(const Scene& scene, std::size_t max_count)
{
    std::vector<Cause> causes;
    for (const Accusation& one : diagnosis(scene.world(), max_count)) {
        Cause cause{one.severity, number_of(scene, one.body), one.text};
        const std::int32_t other = number_of(scene, one.other);
        if (cause.body >= 0) {
            cause.text += " [body " + std::to_string(cause.body);
            cause.text += other >= 0 ? ", body " + std::to_string(other) + "]" : "]";
        }
        causes.push_back(cause);
    }
    return causes;
}

}  // namespace epode::scenes
