// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Contacts of every ordered pair of geom classes on 1,000 random poses each, or as many as are asked for.
//
// One record per pose: "count depth nx ny nz sum separated shared". depth and normal are those of the deepest
// contact, sum is the sum of all depths. separated tells whether the pair is apart (or only touching) after
// the first geom has been moved out along the normal by the depth and a hair: a result of which that is true
// is a valid separation, whoever computed it. A minimal depth then follows from comparing two valid answers.
// shared is 1 where a point well inside both was found by sampling: then a miss is wrong, whoever reports it.
#include "case_list.h"
#include "geoms.h"
#include "inside.h"

#include <algorithm>

namespace parity {
namespace {

constexpr int kCapacity = 32;
constexpr double kMargin = 0.01;  // of a sampled point inside both
constexpr double kLeft = 1e-3;    // overlap that may be left after separating

int collide(dGeomID a, dGeomID b, std::array<dContactGeom, kCapacity>& contacts)
{
    return dCollide(a, b, kCapacity, contacts.data(), sizeof(dContactGeom));
}

bool is_ray_pair(Kind a, Kind b) { return a == Kind::kRay || b == Kind::kRay; }

// Moves the geom that can move; a plane cannot, so then the other goes the opposite way.
double is_apart_after_move(const Placed& first, const Placed& second, const dContactGeom& deepest,
                           Random& samples)
{
    const dGeomID a = first.geom, b = second.geom;
    const double way = deepest.depth * (1 + 1e-6) + 1e-6;
    const bool move_first = dGeomGetClass(a) != dPlaneClass;
    const dGeomID moved = move_first ? a : b;
    const double s = move_first ? way : -way;
    const dReal* p = dGeomGetPosition(moved);
    dGeomSetPosition(moved, p[0] + s * deepest.normal[0], p[1] + s * deepest.normal[1],
                     p[2] + s * deepest.normal[2]);
    std::array<dContactGeom, kCapacity> contacts;
    const int count = collide(a, b, contacts);
    for (int i = 0; i < count; ++i) {
        if (contacts[static_cast<std::size_t>(i)].depth > kLeft) { return 0; }
    }
    return share_a_point(first, second, kLeft, samples) ? 0 : 1;
}

void put_pose(Output& out, const std::string& key, const Placed& a, const Placed& b, bool rays)
{
    Random samples("inside" + key);
    const double shared = !rays && share_a_point(a, b, kMargin, samples) ? 1 : 0;
    std::array<dContactGeom, kCapacity> contacts = {};
    const int count = collide(a.geom, b.geom, contacts);
    if (count == 0) {
        out.put(key, {0, 0, 0, 0, 0, 0, 1, shared});
        return;
    }
    const auto shallower = [](const dContactGeom& x, const dContactGeom& y) { return x.depth < y.depth; };
    const dContactGeom deepest = *std::max_element(contacts.begin(), contacts.begin() + count, shallower);
    double sum = 0;
    for (int i = 0; i < count; ++i) { sum += contacts[static_cast<std::size_t>(i)].depth; }
    const double apart = rays ? 1 : is_apart_after_move(a, b, deepest, samples);
    out.put(key, {static_cast<double>(count), deepest.depth, deepest.normal[0], deepest.normal[1],
                  deepest.normal[2], sum, apart, shared});
}

void put_pair(Output& out, Random& random, Kind first, Kind second)
{
    for (int pose = 0; pose < poses_of_a_pair(); ++pose) {
        const Placed a = make_geom(first, nullptr, random), b = make_geom(second, nullptr, random);
        const Vec3 at = random.in_cube(1), away = random.direction();
        const double distance = (a.radius + b.radius) * random.range(0.2, 1.05);
        place_geom(a, first, at, random);
        place_geom(b, second, {at.x + distance * away.x, at.y + distance * away.y, at.z + distance * away.z},
                   random);
        put_pose(out, std::to_string(pose), a, b, is_ray_pair(first, second));
        dGeomDestroy(a.geom);
        dGeomDestroy(b.geom);
    }
}

// The cases of all ordered pairs, registered in a loop: a new Kind brings its row and column along.
template <std::size_t kIndex>
void run_pair(Output& out, Random& random)
{
    put_pair(out, random, kKinds[kIndex / kKinds.size()], kKinds[kIndex % kKinds.size()]);
}

template <std::size_t... kIndices>
bool register_pairs(std::index_sequence<kIndices...>)
{
    static const std::string names[] = {std::string("pair_") + kind_name(kKinds[kIndices / kKinds.size()]) +
                                        "_" + kind_name(kKinds[kIndices % kKinds.size()])...};
    (case_list().push_back({names[kIndices].c_str(), &run_pair<kIndices>}), ...);
    return true;
}

[[maybe_unused]] const bool kRegistered =
    register_pairs(std::make_index_sequence<kKinds.size() * kKinds.size()>());

}  // namespace
}  // namespace parity
