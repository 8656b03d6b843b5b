// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bodies in lanes: the kernels of every machine leave the same bits, and those are the bits of the formulas
// of dynamics/integrate for one body.
#include <gtest/gtest.h>

#include <cstring>
#include <vector>

#include "dynamics/integrate.h"
#include "dynamics/world.h"
#include "ode/ode.h"
#include "step/island/substep_model.h"
#include "systems.h"

namespace {

using namespace epode_test;

constexpr int kBodies = 21;  // two full groups and one that is not

// A world of bodies of every kind that substeps treat differently.
class Fleet {
  public:
    explicit Fleet(std::uint64_t seed) : world_(dWorldCreate())
    {
        Dice dice(seed);
        for (int i = 0; i < kBodies; ++i) bodies_.push_back(make(dice, i));
        solver_.resize(kBodies);
        for (std::size_t i = 0; i < kBodies; ++i) {
            load_inertia(*bodies_[i], solver_[i]);
            load_velocity(*bodies_[i], solver_[i]);
        }
        blocks_.resize(1);  // so that there are poses
        work_.island.bodies = bodies_;
        work_.system.bodies = solver_, work_.system.blocks = blocks_;
    }
    ~Fleet() { dWorldDestroy(world_); }

    const World& world() const { return *from_handle<World>(world_); }
    IslandWork& work() { return work_; }
    std::vector<Body*>& bodies() { return bodies_; }
    std::vector<SolverBody>& solver() { return solver_; }

  private:
    Body* make(Dice& dice, int i)
    {
        const dBodyID id = dBodyCreate(world_);
        dMass mass;
        if (i % 3 == 0)
            dMassSetSphereTotal(&mass, dice.real(1, 3), 1);
        else
            dMassSetBoxTotal(&mass, dice.real(1, 3), dice.real(1, 2), dice.real(1, 2), dice.real(1, 2));
        dBodySetMass(id, &mass);
        const Vec3 x = dice.vec(5), v = dice.vec(3), w = dice.vec(8), axis = dice.direction();
        dBodySetPosition(id, x.x, x.y, x.z);
        dQuaternion q;
        dQFromAxisAndAngle(q, axis.x, axis.y, axis.z, dice.real(0, 6));
        dBodySetQuaternion(id, q);
        dBodySetLinearVel(id, v.x, v.y, v.z), dBodySetAngularVel(id, w.x, w.y, w.z);
        dBodyAddForce(id, v.y, w.x, v.z), dBodyAddTorque(id, w.z, v.x, w.y);
        if (i % 5 == 1) dBodySetMaxAngularSpeed(id, 2);
        if (i % 7 == 2) dBodySetFiniteRotationMode(id, 1);
        if (i % 7 == 3) dBodySetFiniteRotationMode(id, 1), dBodySetFiniteRotationAxis(id, 0, 1, 0);
        if (i % 11 == 4) dBodySetKinematic(id);
        if (i % 11 == 5) dBodySetGyroscopicMode(id, 0);
        return from_handle<Body>(id);
    }

    dWorldID world_;
    std::vector<Body*> bodies_;
    std::vector<SolverBody> solver_;
    std::vector<RowBlock> blocks_;
    IslandWork work_;
};

bool same_bits(const void* a, const void* b, std::size_t size) { return std::memcmp(a, b, size) == 0; }

TEST(BodyLanes, move_bodies_to_the_bit_as_they_move_one_by_one)
{
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
        Fleet together(seed), alone(seed);
        constexpr Real kStep = Real(0.004);
        Arena arena;
        SubstepModel model(together.work(), together.world(), {}, false, {}, Tasks(3));
        ASSERT_TRUE(model.prepare(arena));
        std::vector<Velocity> v(kBodies + 1);
        load_velocities(together.work().system, v);
        for (int step = 0; step < 20; ++step) {
            model.apply_forces(v, kStep);
            model.advance(v, kStep);
            for (std::size_t i = 0; i < kBodies; ++i) {
                Body& body = *alone.bodies()[i];
                SolverBody& s = alone.solver()[i];
                load_pushed(body, kStep, s);
                store(body.lvel, s.v), store(body.avel, s.w);
                advance_pose(body, kStep);
                s.w = body.angular_velocity();
                load_inertia(body, s);
            }
        }
        model.settle();
        for (std::size_t i = 0; i < kBodies; ++i) {
            SCOPED_TRACE(i);
            const Body &a = *together.bodies()[i], &b = *alone.bodies()[i];
            const SolverBody& s = alone.solver()[i];
            EXPECT_TRUE(same_bits(a.pos, b.pos, 3 * sizeof(Real)));
            EXPECT_TRUE(same_bits(a.q, b.q, sizeof a.q));
            EXPECT_TRUE(same_bits(a.R, b.R, sizeof a.R));
            EXPECT_TRUE(same_bits(&v[i].v, &s.v, sizeof(Vec3)));
            EXPECT_TRUE(same_bits(&v[i].w, &s.w, sizeof(Vec3)));
            EXPECT_TRUE(same_bits(&together.solver()[i].inv_inertia, &s.inv_inertia, sizeof(Sym3)));
            const SolverPose& pose = together.work().system.poses[i];
            EXPECT_TRUE(same_bits(&pose.x, b.pos, 3 * sizeof(Real)));
            EXPECT_TRUE(same_bits(&pose.q, b.q, sizeof b.q));
            EXPECT_EQ(pose.main.y, s.inv_inertia.yy);
            EXPECT_EQ(pose.mixed.z, s.inv_inertia.yz);
        }
    }
}

TEST(BodyKernels, all_machines_make_the_same_bits)
{
    const auto all = body_kernels();
    ASSERT_STREQ(all[0]->name, "baseline");
    if (all.size() == 1) GTEST_SKIP() << "this machine runs the baseline only";
    Dice dice(3);
    std::vector<BodyLanes> groups((kBodies + kLanes - 1) / kLanes);
    for (BodyLanes& group : groups) {
        for (Lanes* lanes = group.x; lanes != &group.max_spin + 1; ++lanes)
            for (Real& number : lanes->at) number = dice.real(-1, 1);
        group.any_gyroscopic = group.any_uneven = group.any_limit = true;
    }
    std::vector<Velocity> velocities(kBodies);
    for (Velocity& v : velocities) v = {dice.vec(2), 0, dice.vec(2), 0};
    struct Outcome {
        std::vector<BodyLanes> groups;
        std::vector<Velocity> v;
        std::vector<SolverPose> poses;
    };
    const auto run = [&](const BodyKernels& kernels) {
        Outcome out{groups, velocities, std::vector<SolverPose>(kBodies)};
        for (int i = 0; i < 3; ++i) {
            kernels.accelerate(out.groups.data(), kBodies, out.v.data(), Real(0.01));
            kernels.turn(out.groups.data(), kBodies, out.v.data(), Real(0.01));
            kernels.place(out.groups.data(), kBodies, out.poses.data());
        }
        return out;
    };
    const Outcome expected = run(*all[0]);
    for (const BodyKernels* other : all.subspan(1)) {
        SCOPED_TRACE(other->name);
        const Outcome got = run(*other);
        EXPECT_TRUE(same_bits(expected.v.data(), got.v.data(), sizeof(Velocity) * kBodies));
        EXPECT_TRUE(same_bits(expected.poses.data(), got.poses.data(), sizeof(SolverPose) * kBodies));
        for (std::size_t i = 0; i < kBodies; ++i) {  // a wide vector also turns lanes that have no body
            const BodyLanes &a = expected.groups[i / kLanes], &b = got.groups[i / kLanes];
            for (const Lanes *x = a.x, *y = b.x; x != &a.max_spin + 1; ++x, ++y)
                EXPECT_TRUE(same_bits(&x->at[i % kLanes], &y->at[i % kLanes], sizeof(Real)));
        }
    }
}

}  // namespace
