// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Steps that run out of memory somewhere in the middle. Two worlds are built alike. Before each step of the
// first the same step is tried with too little memory: blocks of the working memory of a given size and not
// one more, a size that grows from nothing until the step is made, so that the place where memory ends moves
// through the whole step; or the n-th of the other allocations fails, for every n. Each refusal gives one
// message and changes nothing that can be read, and the step that is made at last gives the bits of the
// second world, which has always had memory: also what cannot be read - first guesses, the order of
// iterations, how long bodies have been idle - is as if the refused steps had not been.
#include "../effort.h"
#include "little_memory.h"

namespace epode::memory {
namespace {

constexpr int kWaking = 4;  // in step 4 a sleeping body is touched

// A motor-driven chain, a mat of balls on the ground, a top, bodies that fall asleep and one that is woken,
// two bullets on their way through walls that stop them.
class Stage {
  public:
    Stage(const Setting& s, int side) : setting_(s), side_(side)
    {
        set_up(world_, s);
        add_chain();
        add_mat();
        dBodySetAngularVel(add(0, 30, 5), 1, 5, dReal(0.3));  // the top
        add_idle();
        add_bullets();
    }
    ~Stage()
    {
        dSpaceDestroy(space_);
        dWorldDestroy(world_);
        dJointGroupDestroy(group_);
    }
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;

    dWorldID world() const { return world_; }
    int sleeping() const
    {
        int n = 0;
        for (dBodyID b : bodies_) n += !dBodyIsEnabled(b);
        return n;
    }
    std::uint64_t hash() const
    {
        std::uint64_t hash = hash_of(bodies_);
        for (dBodyID b : bodies_) hash = hash * 31 + std::uint64_t(dBodyIsEnabled(b));
        return hash;
    }

    // Contacts and forces of the step to come.
    void prepare(int number)
    {
        dJointGroupEmpty(group_);
        for (std::size_t i = 0; i < mat_.size(); i += 2) lay(mat_[i]);
        for (dBodyID b : idle_) lay(b);
        dBodyAddForce(bodies_[0], 3, 0, dReal(number));
        if (number == kWaking) {
            dBodyDisable(mat_[1]);  // which its neighbours wake
            dContact contact = touching(dBodyGetPosition(idle_[0]));
            dJointAttach(dJointCreateContact(world_, group_, &contact), idle_[0], mat_[0]);
        }
    }
    int go() { return step(world_, setting_.stepper, dReal(0.01)); }

  private:
    dBodyID add(double x, double y, double z)
    {
        dBodyID body = dBodyCreate(world_);
        dMass mass;
        dMassSetBox(&mass, 1, 1, dReal(0.8), dReal(0.6));
        dBodySetMass(body, &mass);
        dBodySetPosition(body, dReal(x), dReal(y), dReal(z));
        bodies_.push_back(body);
        return body;
    }
    void add_chain()
    {
        dBodyID last = nullptr;
        for (int i = 0; i < 4; ++i) {
            dBodyID body = add(i, -10, 3);
            dJointID hinge = dJointCreateHinge(world_, nullptr);
            dJointAttach(hinge, body, last);
            dJointSetHingeAnchor(hinge, dReal(i - 0.5), -10, 3);
            dJointSetHingeAxis(hinge, 0, 1, 0);
            dJointSetHingeParam(hinge, dParamVel, i + 1);
            dJointSetHingeParam(hinge, dParamFMax, 20);
            last = body;
        }
    }
    void add_mat()
    {
        for (int i = 0; i < side_ * side_; ++i) mat_.push_back(add(i % side_, i / side_, 0));
        for (int i = 0; i < side_ * side_; ++i) {
            if (i % side_ + 1 < side_) tie(i, i + 1);
            if (i + side_ < side_ * side_) tie(i, i + side_);
        }
    }
    void tie(int a, int b)
    {
        dBodyID one = mat_[std::size_t(a)], two = mat_[std::size_t(b)];
        const dReal *p = dBodyGetPosition(one), *q = dBodyGetPosition(two);
        dJointID joint = dJointCreateBall(world_, nullptr);
        dJointAttach(joint, one, two);
        dJointSetBallAnchor(joint, (p[0] + q[0]) / 2, (p[1] + q[1]) / 2, 0);
    }
    void add_idle()
    {
        for (int i = 0; i < 3; ++i) {
            dBodyID body = add(20 + 3 * i, 0, 0);
            dBodySetAutoDisableFlag(body, 1);
            dBodySetAutoDisableSteps(body, 1 + i);
            dBodySetAutoDisableTime(body, 0);
            dBodySetAutoDisableAverageSamplesCount(body, 2);
            dBodySetAutoDisableLinearThreshold(body, 1);
            dBodySetAutoDisableAngularThreshold(body, 1);
            dBodySetLinearVel(body, dReal(0.1), 0, 0);
            dBodySetAngularVel(body, dReal(0.1), dReal(0.3), dReal(0.2));
            idle_.push_back(body);
        }
    }
    void add_bullets()
    {
        for (int i = 0; i < 40; ++i) {
            const dGeomID wall = dCreateBox(space_, dReal(0.01), 4, 4);
            dGeomSetPosition(wall, dReal(0.7 * i), 30, 0);
        }
        for (int i = 0; i < 2; ++i) {
            dBodyID body = add(-1, 30 + i, 0);
            const dGeomID ball = dCreateSphere(space_, dReal(0.05));
            dGeomSetContinuous(ball, dContinuousOn);
            dGeomSetBody(ball, body);
            dBodySetLinearVel(body, 100, 0, 0);
        }
    }
    static dContact touching(const dReal* place)
    {
        dContact contact{};
        contact.geom.normal[2] = 1;
        for (int i = 0; i < 3; ++i) contact.geom.pos[i] = place[i];
        contact.surface.mu = dReal(0.5);
        return contact;
    }
    void lay(dBodyID body)
    {
        dContact contact = touching(dBodyGetPosition(body));
        dJointAttach(dJointCreateContact(world_, group_, &contact), body, nullptr);
    }

    Setting setting_;
    int side_;
    dWorldID world_ = dWorldCreate();
    dSpaceID space_ = dSimpleSpaceCreate(nullptr);
    dJointGroupID group_ = dJointGroupCreate(0);
    std::vector<dBodyID> bodies_, mat_, idle_;
};

int step_with_little(Stage& stage, int threads, unsigned first, unsigned stride)
{
    return memory::step_with_little(stage, threads, first, stride, [](int) {});
}

// The step with the n-th allocation from the heap failing, for n = `first` and so on; how often it was
// refused. A step that is made although one has failed, because it can do without, leaves the later n to the
// next step.
int step_with_failures(Stage& stage, long& first)
{
    for (int refused = 0;; ++refused, ++first) {
        Heap::fail_at(first, false);
        const bool made = tried(stage), failed = Heap::failed();
        Heap::count();
        if (!made && !testing::Test::HasFailure()) continue;
        first = failed ? first + 1 : 0;
        return refused;
    }
}

// `refuse` makes one step of the first stage, after refusals.
template <typename Refuse>
int compare(const Setting& setting, int side, int steps, bool own_functions, Refuse&& refuse)
{
    const Library library;
    Stage poor(setting, side), rich(setting, side);
    if (own_functions) limit_blocks(poor.world());
    int refused = 0;
    for (int i = 0; i < steps && !testing::Test::HasFailure(); ++i) {
        poor.prepare(i), rich.prepare(i);
        refused += refuse(poor, i);
        EXPECT_EQ(rich.go(), 1);
        EXPECT_EQ(poor.hash(), rich.hash()) << "step " << i;
        if (i == kWaking - 1) { EXPECT_EQ(rich.sleeping(), 3); }
        if (i == kWaking) { EXPECT_EQ(rich.sleeping(), 2); }
    }
    return refused;
}

struct TakenBack : testing::TestWithParam<Setting> {};

TEST_P(TakenBack, wherever_the_working_memory_ends)
{
    const Setting s = GetParam();
    const auto stride = unsigned(64 * (tests::kSanitized ? 23 : 3));
    const int refused = compare(s, 4, 6, true, [&](Stage& stage, int i) {
        return step_with_little(stage, s.threads, unsigned(64 * i), stride);
    });
    EXPECT_GT(refused, tests::effort(300));
    RecordProperty("refused", refused);
}

TEST_P(TakenBack, whichever_allocation_fails)
{
    long n = 0;
    int rounds = 0;
    const int refused = compare(GetParam(), 4, 40, false, [&](Stage& stage, int) {
        const dWorldStepReserveInfo many_blocks = {sizeof many_blocks, 1, 64};
        dWorldCleanupWorkingMemory(stage.world());
        dWorldSetStepMemoryReservationPolicy(stage.world(), &many_blocks);
        const int here = step_with_failures(stage, n);
        rounds += n == 0;
        return here;
    });
    EXPECT_GT(rounds, 1) << "every n has had its turn";
    EXPECT_GT(refused, 20);
    RecordProperty("refused", refused);
}

// An island that is worth all threads.
TEST_P(TakenBack, of_a_large_island)
{
    const Setting s = GetParam();
    const int refused = compare(s, 12, 6, true, [&](Stage& stage, int i) {
        return step_with_little(stage, s.threads, unsigned(64 * i), 64 * (tests::kSanitized ? 4999 : 997));
    });
    EXPECT_GT(refused, 10);
    RecordProperty("refused", refused);
}

// For scripts/nightly: every place of the small stage, and many of a large one.
TEST_P(TakenBack, DISABLED_at_every_place)
{
    const Setting s = GetParam();
    compare(s, 4, 6, true, [&](Stage& stage, int) { return step_with_little(stage, s.threads, 0, 64); });
    compare(s, 12, 6, true, [&](Stage& stage, int i) {
        return step_with_little(stage, s.threads, unsigned(64 * i), 64 * 37);
    });
}

constexpr Setting kSettings[] = {
    {Stepper::kExact, 1, false}, {Stepper::kExact, 3, true}, {Stepper::kExact, 3, false},
    {Stepper::kQuick, 1, false}, {Stepper::kQuick, 3, true}, {Stepper::kFast, 1, true},
    {Stepper::kFast, 3, false},
};

INSTANTIATE_TEST_SUITE_P(Settings, TakenBack, testing::ValuesIn(kSettings), name_of);

}  // namespace
}  // namespace epode::memory
