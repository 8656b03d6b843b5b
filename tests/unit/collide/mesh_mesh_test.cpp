// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Two meshes: boxes of 12 triangles against cut-up floors and each other, in both orders.
#include "collide/pairs/surfaces/mesh_mesh.h"
#include "collide/pairs/pairs.h"
#include "mesh_scene.h"

namespace epode::test {
namespace {

constexpr Real kTight = kSingle ? Real(1e-4) : Real(1e-9);

std::vector<Hit> crossings(const Mesh& a, const Pose& A, const Mesh& b, const Pose& B, int capacity = 32)
{
    dContactGeom raw[33];
    raw[capacity].depth = -77;
    ContactSink sink(raw, sizeof(dContactGeom), capacity, false);
    mesh_mesh_contacts({a.mesh, a.tree}, A, {b.mesh, b.tree}, B, sink);
    EXPECT_EQ(raw[capacity].depth, -77);
    std::vector<Hit> out;
    for (int k = 0; k < sink.count(); ++k) {
        const dContactGeom& c = raw[k];
        EXPECT_NEAR(length(load(c.normal)), 1, kSingle ? 1e-5 : 1e-9);
        EXPECT_TRUE(c.depth >= 0 && usable(c.depth) && usable(c.pos[0]) && usable(c.pos[1]) &&
                    usable(c.pos[2]));
        EXPECT_TRUE(c.side1 >= 0 && c.side1 < a.mesh.triangle_count());
        EXPECT_TRUE(c.side2 >= 0 && c.side2 < b.mesh.triangle_count());
        out.push_back({load(c.pos), load(c.normal), c.depth, c.side2});
    }
    return out;
}

Real rough(RandomNumbers& dice, Real height) { return dice.in(0, height); }

TEST(MeshMesh, a_box_stands_on_its_corners_wherever_on_a_floor)
{
    RandomNumbers dice(1);
    const Mesh floor(grid(12, 12, [](int, int) { return 0; }));
    for (int trial = 0; trial < 200; ++trial) {
        SCOPED_TRACE(trial);
        const Vec3 half{dice.in(Real(0.2), 2), dice.in(Real(0.2), 2), dice.in(Real(0.2), 2)};
        const Mesh box(box_mesh(half));
        const Mat3 R = turn_about_z(trial % 4 ? dice.in(0, 6) : 0);
        const Real deep = trial % 2 ? Real(1e-4) : Real(0.02);
        const Pose pose{{dice.in(4, 8), dice.in(4, 8), half.z - deep}, R};
        for (const bool turned : {false, true}) {
            const std::vector<Hit> found =
                turned ? crossings(floor, {}, box, pose) : crossings(box, pose, floor, {});
            ASSERT_EQ(found.size(), 4u);
            for (const Hit& h : found) {
                EXPECT_NEAR(h.normal.z, turned ? -1 : 1, kTight);
                EXPECT_NEAR(h.depth, deep, kTight * 100);
                const Vec3 p = pose.to_local(h.pos);
                EXPECT_NEAR(std::fabs(p.x), half.x, 1e-3);
                EXPECT_NEAR(std::fabs(p.y), half.y, 1e-3);
            }
        }
    }
}

TEST(MeshMesh, boxes_agree_with_boxes)
{
    RandomNumbers dice(2);
    int met = 0, missed = 0, wrong = 0;
    for (int trial = 0; trial < 2000; ++trial) {
        SCOPED_TRACE(trial);
        Box a, b;
        roll(dice, a), roll(dice, b);
        const Mesh ma(box_mesh(a.half)), mb(box_mesh(b.half));
        const Pose A{dice.in(0, Real(1.8)) * dice.direction(), to_matrix(dice.rotation())};
        const Pose B{{}, to_matrix(dice.rotation())};
        dContactGeom raw[8];
        ContactSink sink(raw, sizeof(dContactGeom), 8, false);
        box_box(a, A, b, B, sink);
        Real depth = -1;
        Vec3 normal;
        for (int k = 0; k < sink.count(); ++k)
            if (raw[k].depth > depth) depth = raw[k].depth, normal = load(raw[k].normal);
        const std::vector<Hit> found = crossings(ma, A, mb, B);
        if (sink.count() == 0) {
            EXPECT_TRUE(found.empty());
            continue;
        }
        if (depth < Real(1e-4) || depth > Real(0.1) * std::fmin(length(a.half), length(b.half))) continue;
        ++met;
        if (found.empty()) {
            ++missed;
            continue;
        }
        const Hit deep = *deepest(found);
        wrong +=
            dot(deep.normal, normal) < Real(0.9) || std::fabs(deep.depth - depth) > Real(0.1) * depth ? 1 : 0;
    }
    EXPECT_GT(met, 50);
    EXPECT_EQ(missed, 0);
    EXPECT_LE(wrong, met / 16) << "of " << met
                               << ": some triangle next to crossing edges sees a longer way out";
}

TEST(MeshMesh, spikes_and_rough_ground_push_boxes_up)
{
    RandomNumbers dice(3);
    const Mesh floor(grid(10, 10, [&](int, int) { return rough(dice, Real(0.5)); }));
    int met = 0;
    for (int trial = 0; trial < 150; ++trial) {
        SCOPED_TRACE(trial);
        Box b;
        roll(dice, b);
        const Mesh box(box_mesh(b.half));
        Pose pose{{dice.in(3, 7), dice.in(3, 7), Real(2.5)}, to_matrix(dice.rotation())};
        // Down until it is a little in.
        while (least_gap(b, pose, floor) > Real(0.1)) pose.p.z -= Real(0.1);
        while (least_gap(b, pose, floor) > Real(-0.02)) pose.p.z -= Real(0.01);
        for (int k = 0; k < 40; ++k) {
            const std::vector<Hit> found = crossings(box, pose, floor, {});
            met += k == 0 && !found.empty() ? 1 : 0;
            if (found.empty() || deepest(found)->depth < Real(1e-4)) break;
            for (const Hit& h : found) EXPECT_GT(h.normal.z, -0.2) << k;
            pose.p += (deepest(found)->depth + Real(1e-5)) * deepest(found)->normal;
        }
        EXPECT_GT(least_gap(b, pose, floor), Real(-5e-3));
    }
    EXPECT_EQ(met, 150);
}

}  // namespace
}  // namespace epode::test
