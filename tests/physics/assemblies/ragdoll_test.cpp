// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Ragdolls: what is built, poses that motors hold, animations that are followed, falls that end at rest.
#include <algorithm>
#include <tuple>

#include "figure.h"

namespace epode::assemblies {
namespace {

constexpr V3 kRight{0, -1, 0};

TEST(Ragdoll, a_human_has_its_mass_height_and_symmetry)
{
    const Figure f;
    double mass = 0, top = 0, sole = 1;
    V3 centre;
    for (const dBone& bone : f.bones) {
        mass += bone.mass;
        centre = centre + double(bone.mass) * vec(bone.position);
        if (bone.shape == dBoneCapsule && bone.orientation[1] == 0)
            top = std::fmax(top, bone.position[2] + bone.size[0] + bone.size[1] / 2);
        if (bone.shape == dBoneBox) sole = std::fmin(sole, bone.position[2] - bone.size[2] / 2);
    }
    EXPECT_NEAR(mass, 75, tol(1e-12, 1e-4));
    EXPECT_NEAR(top, 1.8, tol(1e-12, 1e-5));
    EXPECT_NEAR(sole, 0, tol(1e-12, 1e-6));
    EXPECT_NEAR(centre.y, 0, tol(1e-12, 1e-5));
    EXPECT_NEAR(centre.z / mass, 0.56 * 1.8, 0.02 * 1.8);  // of standing adults
}

TEST(Ragdoll, is_built_where_the_list_is_put_with_closed_joints)
{
    Stage stage(dDefaultsGame);
    Figure f;
    ASSERT_EQ(f.build(stage, {1, 2, 3}, 0.7), kBones);
    const double c = std::cos(0.7), s = std::sin(0.7), z = f.bones[kHead].position[2];
    const V3 head = position(f.bodies[kHead]);
    EXPECT_NEAR(head.x, 1, tol(1e-12, 1e-6));
    EXPECT_NEAR(head.y, 2 - s * z, tol(1e-12, 1e-6));
    EXPECT_NEAR(head.z, 3 + c * z, tol(1e-12, 1e-6));
    EXPECT_LT(f.gap(), tol(1e-14, 2e-6));
    EXPECT_EQ(dBodyGetNumJoints(f.bodies[kHead]), 2);  // ball and motor
}

TEST(Ragdoll, neighbours_do_not_collide_and_all_others_do)
{
    Stage stage(dDefaultsGame, 0);
    Figure f;
    f.build(stage);
    stage.step(1e-3);
    EXPECT_EQ(dWorldGetContacts(stage.world, nullptr, 0), 0);
    // The forearm is put into the belly.
    const V3 belly = position(f.bodies[kAbdomen]);
    place(f.bodies[kForearm], belly);
    stage.step(1e-4);
    EXPECT_GT(dWorldGetContacts(stage.world, nullptr, 0), 0);
}

class Presets : public testing::TestWithParam<std::tuple<int, double>> {
  protected:
    int preset() const { return std::get<0>(GetParam()); }
    double h() const { return std::get<1>(GetParam()); }
};
INSTANTIATE_TEST_SUITE_P(Ragdoll, Presets,
                         testing::Combine(testing::Values(int(dDefaultsGame), int(dDefaultsRobot)),
                                          testing::Values(1.0 / 60, 1.0 / 120, 1.0 / 240)));

// Springs against nothing but dry friction, which is none here: the pose is met, each angle with its sign.
TEST_P(Presets, motors_reach_a_pose_of_all_kinds_of_joints)
{
    Stage stage(preset(), 0);
    Figure f;
    for (dBone& bone : f.bones) bone.friction = 0;
    f.build(stage);
    dBodySetKinematic(f.bodies[kPelvis]);
    Pose pose = f.pose();
    turn(f, pose, kThorax, {0, 0, 1}, 0.2);
    turn(f, pose, kHead, {1, 0, 0}, 0.3);
    turn(f, pose, kArm, {1, 0, 0}, 0.8);
    turn(f, pose, kArm, kRight, 1.2);
    turn(f, pose, kForearm, kRight, 1.5);
    turn(f, pose, kHand, {1, 0, 0}, 0.2);
    turn(f, pose, kHand, kRight, -0.6);
    turn(f, pose, kThigh, kRight, 1.1);
    turn(f, pose, kShank, kRight, -1.4);
    turn(f, pose, kFoot, kRight, 0.2);
    EXPECT_EQ(f.hold(pose), kBones - 1);
    for (int i = 0; i < int(3 / h()); ++i) stage.step(h());
    EXPECT_LT(difference(f.pose(), pose), 2e-3);
    EXPECT_LT(f.gap(), 1e-4);
}

// The share of the strength that holds a forearm of mass m out at a right angle is m g r / strength.
TEST_P(Presets, a_motor_gives_way_at_its_strength)
{
    for (const double share : {0.9, 1.2}) {
        Stage stage(preset());
        Figure f;
        const double lever = f.bones[kForearm].anchor[2] - f.bones[kForearm].position[2],
                     hand_lever = f.bones[kForearm].anchor[2] - f.bones[kHand].position[2];
        const double torque = 9.81 * (f.bones[kForearm].mass * lever + f.bones[kHand].mass * hand_lever);
        for (dBone& bone : f.bones) bone.friction = 0;
        f.bones[kForearm].stiffness = 1e5, f.bones[kForearm].damping = 1e3;
        f.bones[kForearm].strength = real(torque * share);
        f.bones[kHand].joint = dBoneFixed;
        f.build(stage);
        for (int i = 0; i < kBones; ++i)
            if (i != kForearm && i != kHand) dBodySetKinematic(f.bodies[std::size_t(i)]);
        Pose pose = f.pose();
        turn(f, pose, kForearm, kRight, kPi / 2);
        const dReal* elbow = f.bones[kForearm].anchor;
        place(f.bodies[kForearm], {lever, elbow[1], elbow[2]});
        place(f.bodies[kHand], {hand_lever, elbow[1], elbow[2]});
        dQuaternion q;
        dQFromAxisAndAngle(q, 0, -1, 0, real(kPi / 2));
        dBodySetQuaternion(f.bodies[kForearm], q), dBodySetQuaternion(f.bodies[kHand], q);
        f.hold(pose);
        for (int i = 0; i < int(0.5 / h()); ++i) stage.step(h());
        const double fall = elbow[2] - position(f.bodies[kForearm]).z;
        if (share > 1)
            EXPECT_LT(fall, 2e-3);
        else
            EXPECT_GT(fall, 0.02);
    }
}

TEST_P(Presets, follows_an_animation_and_falls_when_it_lets_go)
{
    Stage stage(preset());
    Figure f;
    for (dBone& bone : f.bones) bone.friction = 0;
    f.build(stage);
    const Pose stand = f.pose();
    double off = 0, away = 0;
    const int frames = int(2 / h());
    for (int i = 1; i <= frames; ++i) {
        const double t = i * h(), swing = 0.5 * std::sin(4 * t) * std::fmin(1, t);
        Pose pose = stand;
        turn(f, pose, kArm, kRight, swing);
        turn(f, pose, kThigh, kRight, 0.3 * std::fabs(swing));
        const V3 at{t, 0, f.bones[0].position[2] + 0.02 * std::sin(8 * t)};
        EXPECT_EQ(f.follow(at, pose, 1, h()), kBones);
        stage.step(h());
        off = std::fmax(off, difference(f.pose(), pose));
        away = std::fmax(away, length(position(f.bodies[0]) - at));
    }
    EXPECT_LT(off, 200 * h() * h() * h() + 1e-3);
    EXPECT_LT(away, 200 * h() * h() * h() + 1e-4);
    // Without it, it falls: the centre of mass by g t^2 / 2.
    const auto centre = [&] {
        double z = 0;
        for (int i = 0; i < kBones; ++i)
            z += f.bones[std::size_t(i)].mass * dBodyGetPosition(f.bodies[std::size_t(i)])[2];
        return z / 75;
    };
    const auto rise = [&] {
        double v = 0;
        for (int i = 0; i < kBones; ++i)
            v += f.bones[std::size_t(i)].mass * dBodyGetLinearVel(f.bodies[std::size_t(i)])[2];
        return v / 75;
    };
    const double before = centre(), v = rise();
    EXPECT_EQ(f.follow({}, stand, 0, h()), 0);
    for (int i = 0; i < int(0.4 / h() + 0.5); ++i) stage.step(h());
    EXPECT_NEAR(centre() - before, v * 0.4 - 9.81 * 0.08, 9.81 * 0.4 * h() / 2 + 0.01);
}

TEST(Ragdoll, falls_and_lies_asleep_with_closed_joints)
{
    for (const double h : {1.0 / 60, 1.0 / 120, 1.0 / 240}) {
        Stage stage(dDefaultsGame);
        stage.floor();
        Figure f;
        f.build(stage, {0, 0, 0.5}, 0.5);
        double worst = 0, lowest = 1;
        for (int i = 0; i < int(5 / h); ++i) {
            stage.step(h);
            worst = std::fmax(worst, f.gap());
        }
        for (dBodyID body : f.bodies) lowest = std::fmin(lowest, position(body).z);
        EXPECT_LT(worst, 0.025) << h;
        EXPECT_LT(f.gap(), 1e-4) << h;
        EXPECT_GT(lowest, 0) << h;
        EXPECT_EQ(dBodyIsEnabled(f.bodies[0]), 0) << h;
    }
}

TEST(Ragdoll, lands_in_the_robot_preset_with_closed_joints)
{
    Stage stage(dDefaultsRobot);
    stage.floor();
    Figure f;
    f.build(stage, {0, 0, 0.1}, 0.5);
    double worst = 0;
    for (int i = 0; i < 120; ++i) {
        stage.step(1.0 / 240);
        worst = std::fmax(worst, f.gap());
    }
    EXPECT_LT(worst, 1e-3);
}

std::uint64_t hash_of(const Figure& f)
{
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (dBodyID body : f.bodies) {
        hash = hash_reals(dBodyGetPosition(body), 3, hash);
        hash = hash_reals(dBodyGetQuaternion(body), 4, hash);
        hash = hash_reals(dBodyGetAngularVel(body), 3, hash);
    }
    return hash;
}

// Three that fall over each other, with motors that change.
struct Crowd {
    explicit Crowd(int threads = 1) : stage(dDefaultsGame)
    {
        stage.floor();
        dWorldSetStepThreads(stage.world, threads);
        for (int i = 0; i < 3; ++i)
            figures[std::size_t(i)].build(stage, {0.3 * i, 0.1 * i, 0.1 + 0.5 * i}, 0.3);
        stand = figures[0].pose();
    }
    void steps(int from, int to)
    {
        for (int i = from; i < to; ++i) {
            figures[1].hold(stand, i / 20 % 2 ? 1 : 0);
            if (i < 30) figures[2].follow({0.6, 0.2, 2.2}, stand, 0.5, 1.0 / 60);
            stage.step(1.0 / 60);
        }
    }
    std::uint64_t hash() const
    {
        return hash_of(figures[0]) ^ 3 * hash_of(figures[1]) ^ 7 * hash_of(figures[2]);
    }
    Stage stage;
    Figure figures[3];
    Pose stand;
};

TEST(Ragdoll, has_the_same_bits_on_threads_after_a_roll_back_and_from_a_state)
{
    Crowd one, three(3);
    one.steps(0, 90), three.steps(0, 90);
    const std::uint64_t end = one.hash();
    EXPECT_EQ(three.hash(), end);

    Crowd back;
    back.steps(0, 40);
    ASSERT_EQ(dWorldSetHistory(back.stage.world, 60), 1);
    back.steps(40, 90);
    EXPECT_EQ(back.hash(), end);
    ASSERT_EQ(dWorldRollBack(back.stage.world, 50), 1);
    back.steps(40, 90);
    EXPECT_EQ(back.hash(), end);

    Crowd source, target;
    source.steps(0, 40);
    std::vector<char> bytes(dWorldGetStateSize(source.stage.world));
    ASSERT_EQ(dWorldGetState(source.stage.world, bytes.data(), bytes.size()), 1);
    for (Figure& f : target.figures) f.hold(target.stand, 1);  // drives are structure
    ASSERT_EQ(dWorldSetState(target.stage.world, bytes.data(), bytes.size()), 1);
    target.steps(40, 90);
    EXPECT_EQ(target.hash(), end);
}

TEST(Ragdoll, goes_on_with_the_same_bits_from_a_file_with_bodies_in_order)
{
    Crowd first;
    first.steps(0, 40);
    std::vector<char> file(dWorldSaveToBuffer(first.stage.world, nullptr, nullptr, 0));
    dWorldSaveToBuffer(first.stage.world, nullptr, file.data(), file.size());
    dSpaceID space = nullptr;
    const dWorldID world = dWorldLoadFromBuffer(file.data(), file.size(), &space);
    ASSERT_TRUE(world);
    dBodyID bodies[3 * kBones];
    ASSERT_EQ(dWorldGetBodies(world, bodies, 3 * kBones), 3 * kBones);
    Figure copy[3];
    for (int i = 0; i < 3; ++i) std::copy_n(bodies + i * kBones, kBones, copy[i].bodies.data());
    for (int i = 40; i < 90; ++i) {
        copy[1].hold(first.stand, i / 20 % 2 ? 1 : 0);
        dWorldStepHybrid(world, real(1.0 / 60));
    }
    first.steps(40, 90);
    EXPECT_EQ(hash_of(copy[0]) ^ 3 * hash_of(copy[1]) ^ 7 * hash_of(copy[2]), first.hash());
    dWorldDestroy(world);
    dSpaceDestroy(space);
}

TEST(Ragdoll, refuses_what_is_wrong_and_changes_nothing)
{
    Stage stage(dDefaultsGame);
    Figure f;
    Messages messages;
    const auto refused = [&](auto change) {
        std::array<dBone, kBones> bones = f.bones;
        change(bones);
        messages.clear();
        dBodyID made[kBones];
        const bool none =
            dRagdollCreate(stage.world, stage.space, bones.data(), kBones, nullptr, nullptr, made) == 0;
        return none && messages.count() == 1 && dWorldGetBodies(stage.world, nullptr, 0) == 0 &&
               dWorldGetJoints(stage.world, nullptr, 0) == 0 && dSpaceGetNumGeoms(stage.space) == 0;
    };
    EXPECT_TRUE(refused([](auto& b) { b[3].parent = 3; }));
    EXPECT_TRUE(refused([](auto& b) { b[4].swing[0] = 0, b[4].swing[1] = 0, b[4].swing[2] = 5; }));
    EXPECT_TRUE(refused([](auto& b) { b[4].high[1] = real(1.6); }));
    EXPECT_TRUE(refused([](auto& b) { b[15].strength = -1; }));
    EXPECT_TRUE(refused([](auto& b) { b[15].joint = 9; }));
    EXPECT_TRUE(refused([](auto& b) { b[2].size[2] = real(NAN); }));
    ASSERT_EQ(f.build(stage), kBones);
    const Pose pose = f.pose();
    messages.clear();
    EXPECT_EQ(f.hold(pose, -1), 0);
    EXPECT_EQ(f.follow({}, pose, 2, 0.01), 0);
    EXPECT_EQ(f.follow({}, pose, 1, 0), 0);
    dBodyDestroy(f.bodies[7]);
    EXPECT_EQ(f.hold(pose), 0);
    EXPECT_EQ(messages.count(), 4);
}

}  // namespace
}  // namespace epode::assemblies
