// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
#include "contacts/support.h"

namespace epode {

// What rests and has been disturbed comes back first: the next update wants it, too.
bool ContactWorld::find_unsupported(const World& world, const Space& in, Array<Body*>& out)
{
    out.clear();
    if (!world.wakes_sleepers()) return true;
    bool complete = true;
    const auto list = [&](const Geom& geom) {
        Body* const body = own_body(world, geom);
        if (!body) return;  // it has been given to another world since the last step
        const bool put_down = body->put_down > seen_disturbance_;
        if (is_sleeper(*body) && !put_down) complete = out.push(body) && complete;
    };
    if (any_unsupported_)
        for (const Body& body : world.bodies)
            for_each_geom_from(body.first_geom, [&](const Geom& geom) {
                if (geom.watched & kUnsupported) list(geom);
            });
    if (in.last_disturbed <= seen_disturbance_) return complete;
    if (!take_disturbed(in)) return false;
    for (const ContactPair& pair : last_.pairs)
        visit_unsupported(pair, last_.of(pair), in, seen_disturbance_, list);
    return complete;
}

bool ContactWorld::take_disturbed(const Space& in)
{
    const Disturbances& all = in.disturbances;
    if (!all.knows_since(seen_disturbances_)) return resting_.empty() || resting_.take_all(float(h_), last_);
    for (std::uint64_t i = seen_disturbances_; i < all.count(); ++i)
        if (!resting_.take(all[i].serial, float(h_), last_)) return false;
    return true;
}

}  // namespace epode
