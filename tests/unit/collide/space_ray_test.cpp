// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Rays and spaces in ODE's way, by callback: what a ray meets is reported, and hardly anything else, in every
// kind of space, from outside a space, inside one and across two; in the order of joining; all of it again
// when the program has put a function of its own in place of ours.
#include <gtest/gtest.h>

#include <algorithm>

#include "../math/random_numbers.h"
#include "space_scene.h"

namespace epode {
namespace {

// Does the segment come within `margin` of the box?
bool meets(dGeomID ray, dGeomID other, double margin)
{
    dVector3 start, way;
    dReal box[6];
    dGeomRayGet(ray, start, way);
    dGeomGetAABB(other, box);
    double near = 0, far = double(dGeomRayGetLength(ray));
    for (int i = 0; i < 3; ++i) {
        const double a = (double(box[2 * i]) - margin - double(start[i])) / double(way[i]);
        const double b = (double(box[2 * i + 1]) + margin - double(start[i])) / double(way[i]);
        near = std::max(near, std::min(a, b)), far = std::min(far, std::max(a, b));
    }
    return near <= far;
}

dSpaceID make_space(int kind)
{
    const dVector3 centre = {0, 0, 0}, extents = {10, 10, 10};
    return kind == 0   ? dSimpleSpaceCreate(nullptr)
           : kind == 1 ? dHashSpaceCreate(nullptr)
           : kind == 2 ? dSweepAndPruneSpaceCreate(nullptr, dSAP_AXES_XYZ)
                       : dQuadTreeSpaceCreate(nullptr, centre, extents, 4);
}

class SpaceRays : public testing::TestWithParam<int> {
  protected:
    SpaceRays()
    {
        dCreatePlane(space, 0, 0, 1, -2);
        for (int i = 0; i < 400; ++i) {
            const dGeomID box = dCreateBox(space, random.in(0.1, 1), random.in(0.1, 1), random.in(0.1, 1));
            move(box);
        }
    }
    ~SpaceRays() override { dSpaceDestroy(space); }
    void move(dGeomID geom) { dGeomSetPosition(geom, random.in(-5, 5), random.in(-5, 5), random.in(-5, 5)); }
    void aim(dGeomID ray)
    {
        dGeomRaySetLength(ray, random.in(1, 12));
        dGeomRaySet(ray, random.in(-5, 5), random.in(-5, 5), random.in(-5, 5), random.in(-1, 1),
                    random.in(-1, 1), random.in(-1, 1));
    }
    // Everything that the ray meets, once, newest first, and nothing that it misses by a hair.
    void expect_right(dGeomID ray, const PairList& reported)
    {
        std::vector<dGeomID> wanted;
        for (const dGeomID m : members_of(space))
            if (m != ray && dGeomIsEnabled(m) && meets(ray, m, -1e-4)) wanted.push_back(m);
        std::vector<dGeomID> got;
        for (const auto& [a, b] : reported) {
            if (a != ray && b != ray) continue;
            const dGeomID other = a == ray ? b : a;
            EXPECT_TRUE(meets(ray, other, 1e-4));
            if (meets(ray, other, -1e-4)) got.push_back(other);
        }
        EXPECT_EQ(got, wanted);
        met += int(got.size());
    }

    RandomNumbers random{17};
    dSpaceID space = make_space(GetParam());
    int met = 0;
};

INSTANTIATE_TEST_SUITE_P(kinds, SpaceRays, testing::Values(0, 1, 2, 3));

TEST_P(SpaceRays, meet_what_they_should_from_outside)
{
    const dGeomID ray = dCreateRay(nullptr, 1);
    for (int turn = 0; turn < 200; ++turn) {
        if (turn % 50 == 0)
            for (const dGeomID m : members_of(space))
                if (dGeomGetClass(m) == dBoxClass && random.below(3) == 0) move(m);
        aim(ray);
        expect_right(ray, pairs_across(ray, as_geom(space)));
        dContactGeom contact;
        int hits = 0;
        for (const dGeomID m : members_of(space)) hits += dCollide(ray, m, 1, &contact, sizeof contact);
        for (const auto& [a, b] : pairs_across(ray, as_geom(space)))
            hits -= dCollide(a, b, 1, &contact, sizeof contact);
        EXPECT_EQ(hits, 0) << "no hit is lost";
    }
    EXPECT_GT(met, 200);
    dGeomDestroy(ray);
}

TEST_P(SpaceRays, meet_what_they_should_as_members_and_across_two_spaces)
{
    const dSpaceID other = make_space(GetParam());
    const dGeomID inside = dCreateRay(space, 1), across = dCreateRay(other, 1);
    for (int turn = 0; turn < 40; ++turn) {
        aim(inside);
        aim(across);
        expect_right(inside, pairs_in(space));
        dGeomDisable(inside);
        expect_right(across, pairs_across(as_geom(other), as_geom(space)));
        dGeomEnable(inside);
    }
    EXPECT_GT(met, 60);
    dSpaceDestroy(other);
}

int thick_ray(dGeomID, dGeomID, int, dContactGeom*, int) { return 0; }

TEST_P(SpaceRays, are_reported_by_their_boxes_when_the_program_stands_in)
{
    const dGeomID ray = dCreateRay(nullptr, 1);
    aim(ray);
    dGeomRaySetLength(ray, 10);
    const auto count = [&] { return pairs_across(ray, as_geom(space)).size(); };
    std::size_t by_box = 0;
    for (const dGeomID m : members_of(space)) by_box += boxes_overlap(ray, m) ? 1 : 0;
    const std::size_t before = count();
    EXPECT_LT(2 * before, by_box);
    dInitODE();
    dSetColliderOverride(dSphereClass, dRayClass, thick_ray);
    EXPECT_EQ(count(), by_box);
    dCloseODE();
    EXPECT_EQ(count(), before) << "overrides end with the last close";
    dGeomDestroy(ray);
}

}  // namespace
}  // namespace epode
