// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// See asker.h. Pair functions know overlaps only, where a step wants what may meet soon. So where two solids are a distance d apart, or
// overlap by less than a layer, a is moved along the normal n until they overlap by the layer, and each point k found there has the gap
// (d + layer) n.n_k - depth_k, and lies midway. A shape on a landscape is lowered by the layer along the landscape's z.
#include "batch/asker.h"

#include <ode/ext.h>

#include <algorithm>

#include "batch/place_geom.h"
#include "robots/shape_geom.h"

namespace epode::batch {

using namespace robots;

namespace {

Vec column(const AskedPose& pose, int k) { return {pose.turn[k], pose.turn[3 + k], pose.turn[6 + k]}; }
Vec place(const AskedPose& pose) { return {pose.at[0], pose.at[1], pose.at[2]}; }
Vec vec_of(const dReal* from) { return {double(from[0]), double(from[1]), double(from[2])}; }

void write(AskedPoint& out, double gap, Vec point, Vec normal)
{
    out.gap = gap;
    for (int k = 0; k < 3; ++k) out.point[k] = point[k], out.normal[k] = normal[k];
}

// Normals within 60 degrees of the one that a is moved along.
constexpr double kAlike = 0.5;

// With a moved by -shift n.
int moved_points(dGeomID a, dGeomID b, Vec at, double shift, Vec n, int most, AskedPoint* out)
{
    dContactGeom found[8];
    const Vec there = at - shift * n;
    dGeomSetPosition(a, dReal(there.x), dReal(there.y), dReal(there.z));
    const int count = dCollide(a, b, std::min(most, 8), found, sizeof found[0]);
    int kept = 0;
    for (int k = 0; k < count; ++k) {
        const Vec its = vec_of(found[k].normal);
        const double along = dot(its, n);
        if (shift > 0 && !(along > kAlike)) continue;
        write(out[kept++], shift * along - double(found[k].depth), vec_of(found[k].pos) + 0.5 * shift * n,
              its);
    }
    return kept;
}

}  // namespace

PairAsker::PairAsker(const AskedPairs& pairs) : pairs_(pairs)
{
    for (const AskedShape& shape : pairs.shapes)
        geoms_.push_back(make_geom(nullptr, *pairs.prepared, *shape.shape, shape.part));
}

PairAsker::~PairAsker()
{
    for (const dGeomID geom : geoms_)
        if (geom) dGeomDestroy(geom);
}

Asker PairAsker::asker()
{
    return {this, [](void* its, int pair, const AskedPose& a, const AskedPose& b, double reach, double layer,
                     int most, AskedPoint* out) {
                return static_cast<PairAsker*>(its)->ask(pair, a, b, reach, layer, most, out);
            }};
}

int PairAsker::ask(int number, const AskedPose& a, const AskedPose& b, double reach, double layer, int most,
                   AskedPoint* out) const
{
    const AskedPair& pair = pairs_.pairs[size_t(number)];
    const auto kind = [&](int shape) { return pairs_.shapes[size_t(shape)].shape->kind; };
    const dGeomID one = geoms_[size_t(pair.shape_a)], two = geoms_[size_t(pair.shape_b)];
    if (!one || !two) return 0;
    put_geom(one, kind(pair.shape_a), a), put_geom(two, kind(pair.shape_b), b);
    if (pair.is_landscape)
        if (const int found = moved_points(one, two, place(a), layer, column(b, 2), most, out)) return found;
    if (pair.is_landscape) put_geom(one, kind(pair.shape_a), a);
    dQueryDistance apart;
    if (!dGeomGetDistance(one, two, dReal(reach), &apart)) return 0;
    const double distance = double(apart.distance), shift = std::max(0.0, distance + layer);
    const Vec n = vec_of(apart.normal);
    if (!pair.is_landscape)
        if (const int found = moved_points(one, two, place(a), shift, n, most, out)) return found;
    write(out[0], distance, 0.5 * (vec_of(apart.pos1) + vec_of(apart.pos2)), n);
    return 1;
}

}  // namespace epode::batch
