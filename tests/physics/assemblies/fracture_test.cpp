// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies that break: masses add up, rigid motion goes on, momentum is handed on, what is left of a blow goes on.
#include <algorithm>
#include <array>

#include "figure.h"

namespace epode::assemblies {
namespace {

constexpr double kH = 1.0 / 60;

// A list of parts of one stage.
struct Parts {
    std::vector<dFracturePart> list;

    dGeomID add(dGeomID geom, V3 at, double density = 1000)
    {
        dGeomSetPosition(geom, real(at.x), real(at.y), real(at.z));
        list.push_back({geom, real(density)});
        return geom;
    }
    // A box of n.x by n.y by n.z bricks about `at`.
    void add_bricks(const Stage& stage, V3 at, V3 brick, std::array<int, 3> n, double density = 1000)
    {
        for (int i = 0; i < n[0]; ++i)
            for (int j = 0; j < n[1]; ++j)
                for (int k = 0; k < n[2]; ++k)
                    add(dCreateBox(stage.space, real(brick.x), real(brick.y), real(brick.z)),
                        at + V3{(i - (n[0] - 1) / 2.0) * brick.x, (j - (n[1] - 1) / 2.0) * brick.y,
                                (k - (n[2] - 1) / 2.0) * brick.z},
                        density);
    }
    int count() const { return int(list.size()); }
    dBodyID unite(const Stage& stage) const { return dFractureCreate(stage.world, list.data(), count()); }
    int break_all(dBodyID body) const { return dFractureBreak(list.data(), count(), body, nullptr, 0); }
    int break_at(dBodyID body, V3 at, double radius) const
    {
        const dVector3 p = {real(at.x), real(at.y), real(at.z)};
        return dFractureBreak(list.data(), count(), body, p, real(radius));
    }
    int update(const Stage& stage, double strength, double radius = double(dInfinity)) const
    {
        const dFracture one = {list.data(), count(), real(strength), real(radius)};
        return dFractureUpdate(stage.world, &one, 1);
    }
    // Distinct, in the order of the parts.
    std::vector<dBodyID> bodies() const
    {
        std::vector<dBodyID> out;
        for (const dFracturePart& part : list) {
            const dBodyID body = dGeomGetBody(part.geom);
            if (body && std::find(out.begin(), out.end(), body) == out.end()) out.push_back(body);
        }
        return out;
    }
};

double mass_of(dBodyID body)
{
    dMass m;
    dBodyGetMass(body, &m);
    return m.mass;
}

struct Motion {
    double mass = 0, energy = 0;
    V3 momentum, spin;  // angular momentum about the origin
};

Motion motion_of(const std::vector<dBodyID>& bodies)
{
    Motion sum;
    for (dBodyID body : bodies) {
        const double m = mass_of(body);
        sum.mass += m;
        sum.energy += kinetic_energy(body);
        sum.momentum = sum.momentum + m * velocity(body);
        sum.spin = sum.spin + spin_momentum(body) + m * cross(position(body), velocity(body));
    }
    return sum;
}

dBodyID ball(const Stage& stage, V3 at, double radius, double mass, V3 v)
{
    const dBodyID body = dBodyCreate(stage.world);
    dMass m;
    dMassSetSphereTotal(&m, real(mass), real(radius));
    dBodySetMass(body, &m);
    dGeomSetBody(dCreateSphere(stage.space, real(radius)), body);
    place(body, at);
    velocity(body, v);
    dBodySetLinearDamping(body, 0), dBodySetAngularDamping(body, 0);
    return body;
}

void undamp(dBodyID body)
{
    dBodySetLinearDamping(body, 0), dBodySetAngularDamping(body, 0);
    dBodySetAutoDisableFlag(body, 0);
}

TEST(Fracture, parts_weigh_what_the_whole_does)
{
    Stage stage(dDefaultsGame);
    Parts parts;
    parts.add_bricks(stage, {1, 2, 3}, {0.1, 0.2, 0.3}, {3, 2, 4}, 800);
    const dBodyID body = parts.unite(stage);
    ASSERT_NE(body, nullptr);
    dMass whole, m;
    dMassSetBox(&whole, 800, real(0.3), real(0.4), real(1.2));
    dBodyGetMass(body, &m);
    EXPECT_NEAR(m.mass, whole.mass, tol(1e-12, 1e-5) * whole.mass);
    for (int k = 0; k < 12; ++k) EXPECT_NEAR(m.I[k], whole.I[k], tol(1e-12, 1e-5) * whole.mass);
    EXPECT_LT(length(position(body) - V3{1, 2, 3}), tol(1e-14, 4 * kEpsilon * 3.7));  // digits of the place
}

// Solids of every class, of different densities, on one body that turns and flies.
TEST(Fracture, a_break_continues_the_rigid_motion_and_keeps_its_momentum)
{
    Stage stage(dDefaultsGame, 0);
    Parts parts;
    const dReal corners[] = {0, 0, 0, real(0.3), 0, 0, 0, real(0.4), 0, 0, 0, real(0.5)};
    parts.add(dCreateSphere(stage.space, real(0.2)), {0, 0, 0}, 500);
    parts.add(dCreateBox(stage.space, real(0.3), real(0.2), real(0.1)), {0.5, 0, 0}, 2700);
    parts.add(dCreateCapsule(stage.space, real(0.1), real(0.4)), {0, 0.5, 0}, 0);
    parts.add(dCreateCylinder(stage.space, real(0.15), real(0.2)), {0, 0, 0.5}, 7800);
    parts.add(dCreateCone(stage.space, real(0.2), real(0.5)), {-0.5, 0, 0.1}, 900);
    parts.add(dCreateEllipsoid(stage.space, real(0.1), real(0.2), real(0.15)), {0, -0.6, 0}, 1200);
    parts.add(dCreateTaperedCapsule(stage.space, real(0.1), real(0.05), real(0.3)), {0.4, 0.4, 0.4}, 300);
    parts.add(dCreateConvexHull(stage.space, corners, 4, 0), {-0.3, -0.3, -0.3}, 2000);
    Random random(7);
    for (const dFracturePart& part : parts.list) {
        dQuaternion q;
        random.quaternion(q);
        dGeomSetQuaternion(part.geom, q);
    }
    const dBodyID body = parts.unite(stage);
    ASSERT_NE(body, nullptr);
    place(body, {3, -1, 2});
    velocity(body, {1, 2, -3}, {4, -5, 6});
    dBodySetLinearDamping(body, real(0.125));
    const Motion before = motion_of({body});
    const V3 v = velocity(body), w = spin(body), x = position(body);
    std::vector<V3> places;
    for (const dFracturePart& part : parts.list) places.push_back(vec(dGeomGetPosition(part.geom)));

    EXPECT_EQ(parts.break_all(body), 8);
    const std::vector<dBodyID> pieces = parts.bodies();
    ASSERT_EQ(pieces.size(), 8u);
    EXPECT_EQ(dWorldGetBodies(stage.world, nullptr, 0), 8);
    const Motion after = motion_of(pieces);
    const double close = tol(1e-12, 1e-5);
    EXPECT_NEAR(after.mass, before.mass, close * before.mass);
    EXPECT_LT(length(after.momentum - before.momentum), close * length(before.momentum));
    EXPECT_LT(length(after.spin - before.spin), close * length(before.spin));
    EXPECT_NEAR(after.energy, before.energy, close * before.energy);
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        EXPECT_LT(length(velocity(pieces[i]) - v - cross(w, position(pieces[i]) - x)), tol(1e-13, 1e-5));
        EXPECT_LT(length(vec(dGeomGetPosition(parts.list[i].geom)) - places[i]), tol(1e-14, 1e-6));
        EXPECT_EQ(dBodyGetLinearDamping(pieces[i]), real(0.125));
    }
}

// J = m M / (m + M) v of a ball that sticks to a free pane: the limit of the strength, to a thousandth, wherever in a step the
// two meet.
TEST(Fracture, breaks_where_the_impulse_passes_the_strength)
{
    for (int phase = 0; phase < 9; ++phase)
        for (const double share : {0.999, 1.001}) {
            Stage stage(dDefaultsGame, 0);
            Parts parts;
            parts.add_bricks(stage, {}, {0.3, 0.3, 0.05}, {3, 3, 1}, 2500);
            const dBodyID pane = parts.unite(stage);
            undamp(pane);
            const double m = 2, M = mass_of(pane), v = 6, J = m * M / (m + M) * v;
            const dBodyID shot = ball(stage, {0, 0, 0.225 + 0.0125 * phase}, 0.1, m, {0, 0, -v});
            int broken = 0;
            for (int i = 0; i < 20 && !broken; ++i) stage.step(kH), broken = parts.update(stage, share * J);
            EXPECT_EQ(broken, share < 1 ? 1 : 0) << share << " in phase " << phase;
            EXPECT_EQ(parts.bodies().size(), share < 1 ? 9u : 1u);
            // In floats the default CFM of a contact yields by up to 1/2000.
            EXPECT_NEAR(velocity(shot).z, -(v - std::fmin(share, 1) * J / m), tol(1e-5, v / 2000));
        }
}

// The ball loses the strength and no more; then it takes the part along that it has hit.
TEST(Fracture, what_is_left_of_the_blow_goes_on)
{
    Stage stage(dDefaultsGame, 0);
    Parts parts;
    parts.add_bricks(stage, {}, {0.3, 0.3, 0.05}, {3, 3, 1}, 2500);
    dMaterial smooth;
    dMaterialInit(&smooth, sizeof smooth);
    smooth.friction = 0;
    for (const dFracturePart& part : parts.list) dGeomSetMaterial(part.geom, &smooth);
    const dBodyID pane = parts.unite(stage);
    undamp(pane);
    const double m = 2, M = mass_of(pane), v = 20, S = 3;
    const dBodyID shot = ball(stage, {0, 0, 0.4}, 0.1, m, {0, 0, -v});
    int broken = 0;
    for (int i = 0; i < 10 && !broken; ++i) stage.step(kH), broken = parts.update(stage, S);
    ASSERT_EQ(broken, 1);
    EXPECT_NEAR(velocity(shot).z, -(v - S / m), tol(1e-6, 1e-4));
    std::vector<dBodyID> all = parts.bodies();
    ASSERT_EQ(all.size(), 9u);
    for (dBodyID piece : all) EXPECT_NEAR(velocity(piece).z, -S / M, tol(1e-6, 1e-4));
    all.push_back(shot);
    for (int i = 0; i < 30; ++i) {
        stage.step(kH);
        EXPECT_EQ(parts.update(stage, S), 0);  // single parts do not break
    }
    const Motion after = motion_of(all);
    EXPECT_NEAR(after.momentum.z, -m * v, tol(1e-5, 1e-3) * m * v);
    const double piece = M / 9, together = (m * (v - S / m) + piece * S / M) / (m + piece);
    EXPECT_NEAR(velocity(shot).z, -together, 0.01 * together);
    EXPECT_LT(position(shot).z, -1);
}

// Momentum and angular momentum of all, through break after break, eccentric, with friction and a turning target.
TEST(Fracture, breaks_hand_on_momentum_and_make_no_energy)
{
    for (int seed = 0; seed < 12; ++seed) {
        Stage stage(dDefaultsGame, 0);
        Random random(std::uint32_t(seed + 1));
        Parts parts;
        parts.add_bricks(stage, {}, {0.4, 0.3, 0.2}, {2, 3, 2}, 1500);
        const dBodyID target = parts.unite(stage);
        undamp(target);
        velocity(target, random.point(1), random.point(2));
        std::vector<dBodyID> shots;
        for (int i = 0; i < 4; ++i) {
            const V3 from = {i % 2 ? 1.5 : -1.5, random.uniform(-0.3, 0.3), random.uniform(-0.1, 0.1)};
            shots.push_back(ball(stage, (1 + i / 2) * from, 0.15, 20, -8.0 * from));
        }
        const auto all = [&] {
            std::vector<dBodyID> out = parts.bodies();
            out.insert(out.end(), shots.begin(), shots.end());
            return out;
        };
        int broken = 0;
        Motion motion = motion_of(all());
        for (int i = 0; i < 60; ++i) {
            stage.step(kH);
            const Motion stepped = motion_of(all());
            const int now = parts.update(stage, 20, 0.1);
            broken += now;
            const Motion after = motion_of(all());
            EXPECT_LT(length(after.momentum - stepped.momentum), tol(1e-10, 1e-2));
            EXPECT_LT(length(after.spin - stepped.spin), tol(1e-10, 1e-2));
            EXPECT_LE(after.energy, (now ? motion : stepped).energy * (1 + 1e-9)) << seed << " at " << i;
            motion = after;
        }
        EXPECT_GT(broken, 0) << seed;
    }
}

// What held the plate up did so because of what hit it: pieces of it are not thrown upwards.
TEST(Fracture, supports_do_not_throw_what_breaks_on_them)
{
    Stage stage(dDefaultsGame);
    for (const double x : {-0.8, 0.8}) {
        const dGeomID support = dCreateBox(stage.space, real(0.2), 1, 1);
        dGeomSetPosition(support, real(x), 0, real(0.5));
    }
    Parts parts;
    parts.add_bricks(stage, {0, 0, 1.05}, {0.3, 0.5, 0.1}, {7, 1, 1}, 2400);
    parts.unite(stage);
    for (int i = 0; i < 60; ++i) {
        stage.step(kH);
        ASSERT_EQ(parts.update(stage, 30), 0);
    }
    ball(stage, {0, 0, 3}, 0.2, 60, {0, 0, -5});
    int broken = 0;
    for (int i = 0; i < 60 && !broken; ++i) stage.step(kH), broken = parts.update(stage, 30);
    ASSERT_EQ(broken, 1);
    double up = 0;
    for (dBodyID piece : parts.bodies()) up = std::fmax(up, velocity(piece).z);
    EXPECT_LT(up, 0.15);
}

TEST(Fracture, the_weaker_of_two_breaks_and_spares_the_other)
{
    for (const bool swapped : {false, true}) {
        Stage stage(dDefaultsGame, 0);
        Parts left, right;
        left.add_bricks(stage, {-0.8, 0, 0}, {0.3, 0.3, 0.3}, {2, 1, 1});
        right.add_bricks(stage, {0.8, 0, 0}, {0.3, 0.3, 0.3}, {2, 1, 1});
        const dBodyID a = left.unite(stage), b = right.unite(stage);
        velocity(a, {5, 0, 0}), velocity(b, {-5, 0, 0});
        const double weak = 20, strong = 60;  // J = m v = 270 N s
        const dFracture both[] = {
            {left.list.data(), 2, real(swapped ? strong : weak), dInfinity},
            {right.list.data(), 2, real(swapped ? weak : strong), dInfinity},
        };
        int broken = 0;
        for (int i = 0; i < 10 && !broken; ++i)
            stage.step(kH), broken = dFractureUpdate(stage.world, both, 2);
        EXPECT_EQ(broken, 1);
        EXPECT_EQ(left.bodies().size(), swapped ? 1u : 2u);
        EXPECT_EQ(right.bodies().size(), swapped ? 2u : 1u);
    }
}

TEST(Fracture, comes_off_within_the_radius_and_the_rest_holds_together_where_it_touches)
{
    Stage stage(dDefaultsGame, 0);
    Parts parts;
    parts.add_bricks(stage, {}, {0.5, 0.2, 0.2}, {5, 1, 1});
    const dBodyID row = parts.unite(stage);
    dBodySetKinematic(row);
    EXPECT_EQ(parts.break_at(row, {5, 0, 0}, 0.5), 0);  // nothing near
    EXPECT_EQ(parts.bodies(), std::vector<dBodyID>{row});
    EXPECT_EQ(parts.break_at(row, {0, 0, 0}, 0.1), 3);
    const std::vector<dBodyID> pieces = parts.bodies();
    ASSERT_EQ(pieces.size(), 3u);
    const dBodyID left = pieces[0], middle = pieces[1], right = pieces[2];
    EXPECT_EQ(dGeomGetBody(parts.list[1].geom), left);
    EXPECT_EQ(dGeomGetBody(parts.list[3].geom), right);
    EXPECT_NEAR(position(left).x, -0.75, tol(1e-14, 1e-6));
    EXPECT_NEAR(mass_of(right), 2 * mass_of(middle), tol(1e-12, 1e-4));
    EXPECT_TRUE(dBodyIsKinematic(left) && dBodyIsKinematic(right) && !dBodyIsKinematic(middle));
    EXPECT_EQ(parts.break_at(left, {-1, 0, 0}, 0.1), 2);
    EXPECT_EQ(parts.bodies().size(), 4u);
}

struct Wall {
    Stage stage{dDefaultsGame};
    Parts parts;
    dBodyID shot;

    Wall()
    {
        stage.floor();
        parts.add_bricks(stage, {0, 0, 0.75}, {0.2, 0.5, 0.3}, {1, 5, 5}, 1800);
        parts.unite(stage);
        shot = ball(stage, {3, 0.2, 1}, 0.2, 30, {-25, 0, 1});
    }
    int advance(int steps)
    {
        int broken = 0;
        for (int i = 0; i < steps; ++i) {
            broken += parts.update(stage, 150, 0.4);  // before the step: also the first after a roll-back
            stage.step(kH);
        }
        return broken;
    }
    std::uint64_t hash() const
    {
        std::uint64_t h = hash_reals(dBodyGetPosition(shot), 3, 1);
        for (const dFracturePart& part : parts.list) {
            h = hash_reals(dGeomGetPosition(part.geom), 3, h);
            h = hash_reals(dBodyGetLinearVel(dGeomGetBody(part.geom)), 3, h);
        }
        return h;
    }
};

TEST(Fracture, has_the_same_bits_on_threads_and_after_a_roll_back)
{
    std::uint64_t hash[3];
    for (int run = 0; run < 3; ++run) {
        Wall wall;
        dWorldSetStepThreads(wall.stage.world, run == 1 ? 3 : 1);
        if (run == 2) dWorldSetHistory(wall.stage.world, 60);
        EXPECT_GT(wall.advance(60), 0);
        const std::size_t pieces = wall.parts.bodies().size();
        EXPECT_GT(pieces, 2u);
        if (run == 2) {
            // Step 7 brings the blow, and the program breaks the wall before step 8: to before it, behind it, between the two.
            for (const int frames : {55, 52, 53}) {
                ASSERT_EQ(dWorldRollBack(wall.stage.world, frames), 1);
                EXPECT_EQ(wall.parts.bodies().size() == 1u, frames >= 53);
                wall.advance(frames);
                EXPECT_EQ(wall.parts.bodies().size(), pieces);
            }
        }
        hash[run] = wall.hash();
    }
    EXPECT_EQ(hash[1], hash[0]);
    EXPECT_EQ(hash[2], hash[0]);
}

TEST(Fracture, refuses_what_is_wrong_and_changes_nothing)
{
    Stage stage(dDefaultsGame);
    Messages messages;
    Parts parts;
    parts.add_bricks(stage, {}, {0.1, 0.1, 0.1}, {2, 1, 1});
    const auto refused = [&](auto&& call) {
        messages.clear();
        const bool nothing = !call();
        return nothing && messages.count() == 1 && dWorldGetBodies(stage.world, nullptr, 0) == 0;
    };
    const auto create = [&](std::vector<dFracturePart> list) {
        return dFractureCreate(stage.world, list.data(), int(list.size())) != nullptr;
    };
    const std::vector<dFracturePart> good = parts.list;
    EXPECT_TRUE(refused([&] { return create({good[0], good[0]}); }));
    EXPECT_TRUE(refused([&] { return create({{good[0].geom, -1}}); }));
    EXPECT_TRUE(refused([&] { return create({{good[0].geom, real(NAN)}}); }));
    EXPECT_TRUE(refused([&] { return create({good[0], {nullptr, 1}}); }));
    EXPECT_TRUE(refused([&] { return create({{dCreatePlane(stage.space, 0, 0, 1, 0), 1}}); }));
    EXPECT_TRUE(refused([&] { return create({{dCreateSphere(stage.space, 0), 1}}); }));
    EXPECT_TRUE(refused([&] { return parts.update(stage, -1); }));
    EXPECT_TRUE(refused([&] { return parts.update(stage, 1, NAN); }));
    EXPECT_TRUE(refused([&] { return dFractureUpdate(stage.world, nullptr, 1); }));

    const dBodyID body = parts.unite(stage);
    messages.clear();
    EXPECT_FALSE(create(good));  // on a body
    dGeomSetBody(dCreateSphere(stage.space, 1), body);
    EXPECT_EQ(parts.break_all(body), 0);  // a geom that is no part
    EXPECT_EQ(parts.break_all(nullptr), 0);
    dGeomDestroy(good[0].geom);
    EXPECT_EQ(parts.break_all(body), 0);
    EXPECT_EQ(messages.count(), 4);
    EXPECT_EQ(dGeomGetBody(good[1].geom), body);
}

}  // namespace
}  // namespace epode::assemblies
