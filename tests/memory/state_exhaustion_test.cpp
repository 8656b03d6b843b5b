// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States on a heap that fails at each allocation in turn: refused with one message and nothing changed, or
// done; and when memory is back the world goes on with the bits of its state.
#include "../effort.h"
#include "heap.h"

namespace epode::memory {
namespace {

class World {
  public:
    explicit World(bool world_contacts) : world_contacts_(world_contacts)
    {
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetAutoDisableFlag(world, 1);
        if (world_contacts) dWorldSetContactSpace(world, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        for (int i = 0; i < 12; ++i) {
            const dBodyID body = dBodyCreate(world);
            dBodySetPosition(body, dReal(1.5) * dReal(i / 3), 0, dReal(0.5) + dReal(i % 3));
            dGeomSetBody(dCreateBox(space_, 1, 1, 1), body);
            bodies.push_back(body);
        }
        const dJointID ball = dJointCreateBall(world, nullptr);
        dJointAttach(ball, bodies[0], bodies[3]);
    }
    ~World()
    {
        dJointGroupDestroy(contacts_);
        dWorldDestroy(world);
        dSpaceDestroy(space_);
    }
    World(const World&) = delete;
    World& operator=(const World&) = delete;

    void step()
    {
        collide();
        dWorldQuickStep(world, dReal(0.02));
        dJointGroupEmpty(contacts_);
    }
    void steps(int n)
    {
        for (int i = 0; i < n; ++i) step();
    }
    void collide()
    {
        if (!world_contacts_) dSpaceCollide(space_, this, touch);
    }
    std::vector<unsigned char> state() const
    {
        std::vector<unsigned char> bytes(dWorldGetStateSize(world));
        EXPECT_EQ(dWorldGetState(world, bytes.data(), bytes.size()), 1);
        return bytes;
    }

    const dWorldID world = dWorldCreate();
    std::vector<dBodyID> bodies;

  private:
    static void touch(void* self, dGeomID a, dGeomID b)
    {
        World& w = *static_cast<World*>(self);
        dContact contact[4] = {};
        const int count = dCollide(a, b, 4, &contact[0].geom, sizeof contact[0]);
        for (int i = 0; i < count; ++i) {
            contact[i].surface.mu = 1;
            dJointAttach(dJointCreateContact(w.world, w.contacts_, &contact[i]), dGeomGetBody(a),
                         dGeomGetBody(b));
        }
    }

    const bool world_contacts_;
    const dSpaceID space_ = dHashSpaceCreate(nullptr);
    const dJointGroupID contacts_ = dJointGroupCreate(0);
};

class StateExhaustion : public testing::TestWithParam<bool> {};

TEST_P(StateExhaustion, each_allocation_may_fail_and_nothing_changes)
{
    const Library library;
    World first(GetParam());
    first.steps(60);
    const std::vector<unsigned char> begin = first.state();
    std::vector<unsigned char> buffer(begin.size());
    first.steps(5);
    const std::uint64_t later = hash_of(first.bodies);
    int tried = 0;
    for (const bool for_good : {false, true})
        for (int what = 0; what < 4; ++what)
            for (long n = 0;; n += tests::kSanitized ? 5 : 1) {
                World w(GetParam());  // a world keeps the memory of earlier calls
                w.steps(65);
                const std::uint64_t before = hash_of(w.bodies);
                const int messages_before = messages();
                Heap::fail_at(n, for_good);
                const bool done =
                    what == 0   ? dWorldGetState(w.world, buffer.data(), buffer.size())
                    : what == 1 ? dWorldSetState(w.world, begin.data(), begin.size())
                    : what == 2 ? dWorldGetStateSize(w.world) > 0
                                : dWorldGetStateDelta(w.world, begin.data(), begin.size(), nullptr, 0) > 0;
                const bool failed = Heap::failed();
                Heap::count();
                ASSERT_TRUE(done || failed);
                ASSERT_EQ(messages() - messages_before, done ? 0 : 1) << what << ' ' << n;
                if (!done) {
                    ASSERT_EQ(hash_of(w.bodies), before) << what << ' ' << n;
                } else if (what == 1) {
                    w.steps(5);
                    ASSERT_EQ(hash_of(w.bodies), later) << n;
                }
                if (!failed) break;
                ++tried;
            }
    EXPECT_GT(tried, tests::effort(30));
}

// What a step that fails takes back is all that a state holds.
TEST(StateUndo, a_step_that_finds_no_memory_leaves_the_state)
{
    const Library library;
    int refused = 0;
    for (const Stepper stepper : kSteppers)
        for (long n = 0;; ++n) {
            World w(false);
            for (int i = 0; i < 5; ++i) w.step();
            w.collide();
            dWorldCleanupWorkingMemory(w.world);
            const std::vector<unsigned char> before = w.state();
            Heap::fail_at(n, true);
            const int made = step(w.world, stepper, dReal(0.02));
            const bool failed = Heap::failed();
            Heap::count();
            if (!made) ++refused;
            ASSERT_TRUE(made || w.state() == before) << int(stepper) << ' ' << n;
            if (!failed) break;
        }
    EXPECT_GT(refused, 3);
}

INSTANTIATE_TEST_SUITE_P(Contacts, StateExhaustion, testing::Bool());

}  // namespace
}  // namespace epode::memory
