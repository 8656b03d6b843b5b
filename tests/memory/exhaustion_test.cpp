// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every allocation of a scripted scene is made to fail in turn, once, or it and all that follow. Whatever is
// asked for is then there or refused with one message, a step that returns 0 has changed nothing, and when
// memory is back the scene goes on. At the end every block has been given back.
#include "heap.h"

namespace epode::memory {
namespace {

// What an answer of nothing must come with: one message, and no change in the numbers of things.
template <typename Ask>
auto asked(const char* what, Ask&& ask)
{
    const int messages_before = messages();
    const auto answer = ask();
    EXPECT_EQ(messages() - messages_before, answer ? 0 : 1) << what;
    return answer;
}
#define ASKED(call) asked(#call, [&] { return call; })

int user_collider(dGeomID, dGeomID, int, dContactGeom*, int) { return 0; }
dColliderFn* offer(int) { return user_collider; }
void user_box(dGeomID, dReal box[6])
{
    for (int i = 0; i < 6; ++i) box[i] = dReal(i % 2);
}

class Scene {
  public:
    explicit Scene(const Setting& s) : setting_(s) {}

    void build()
    {
        world_ = ASKED(dWorldCreate());
        outer_ = ASKED(dHashSpaceCreate(nullptr));
        if (!world_ || !outer_) return;
        inner_ = ASKED(dSimpleSpaceCreate(outer_));
        group_ = ASKED(dJointGroupCreate(0));
        set_up(world_, setting_);
        ASKED(dCreatePlane(outer_, 0, 0, 1, 0));
        for (int i = 0; i < 7; ++i) add_body(i);
        tie_bodies();
        add_field();
        add_user_geom();
    }

    void step_once()
    {
        if (!world_ || !outer_) return;
        dSpaceCollide(outer_, this, &near);
        for (dBodyID b : bodies_) dBodyAddForce(b, 1, 0, dReal(0.5));
        const std::uint64_t before = hash_of(bodies_);
        const int messages_before = messages();
        if (step(world_, setting_.stepper, dReal(0.01))) {
            EXPECT_EQ(messages(), messages_before);
        } else {
            ++refused_steps;
            EXPECT_EQ(messages(), messages_before + 1);
            EXPECT_EQ(hash_of(bodies_), before) << "a refused step has changed something";
            EXPECT_TRUE(Heap::failed());
        }
        if (group_) dJointGroupEmpty(group_);
        change();
    }

    // All memory is back: everything can be done.
    void go_on()
    {
        const int messages_before = messages();
        if (!world_ || !outer_) {
            tear_down();
            build();
        }
        ASSERT_TRUE(world_ && outer_);
        if (!group_) group_ = dJointGroupCreate(0);
        dCreatePlane(outer_, 0, 0, 1, 0);
        add_body(0), add_body(1);
        contacts_ = 0;
        const int refusals = refused_steps;
        for (int i = 0; i < 2; ++i) step_once();
        EXPECT_EQ(refused_steps, refusals);
        EXPECT_GT(contacts_, 0);
        EXPECT_EQ(messages(), messages_before);
        for (dBodyID b : bodies_) EXPECT_TRUE(finite(b));
    }

    void tear_down()
    {
        if (world_) dWorldDestroy(world_);
        if (outer_) dSpaceDestroy(outer_);
        if (group_) dJointGroupDestroy(group_);
        for (dHeightfieldDataID f : fields_) dGeomHeightfieldDataDestroy(f);
        for (dGeomID g : loose_) dGeomDestroy(g);
        *this = Scene(setting_);
    }

    int refused_steps = 0;

  private:
    void add_body(int i)
    {
        const int made = dSpaceGetNumGeoms(outer_);
        dBodyID body = ASKED(dBodyCreate(world_));
        if (!body) return;
        bodies_.push_back(body);
        dBodySetPosition(body, dReal(1.1 * (i % 4)), dReal(1.1 * (i / 4)), dReal(0.45));
        dGeomID geom = nullptr;
        const dSpaceID inside = inner_ ? inner_ : outer_;
        switch (i % 5) {
            case 0:
                geom = ASKED(dCreateBox(outer_, 1, 1, 1));
                break;
            case 1:
                geom = ASKED(dCreateSphere(outer_, dReal(0.5)));
                break;
            case 2:
                geom = ASKED(dCreateCapsule(inside, dReal(0.3), dReal(0.5)));
                break;
            case 3:
                geom = ASKED(dCreateCylinder(inside, dReal(0.3), 1));
                break;
            default:
                geom = ASKED(dCreateGeomTransform(outer_));
                break;
        }
        if (!geom) {
            EXPECT_EQ(dSpaceGetNumGeoms(outer_), made);
            return;
        }
        dGeomSetBody(geom, body);
        if (i % 5 == 4) {
            if (dGeomID held = ASKED(dCreateBox(nullptr, dReal(0.5), 1, 1))) {
                dGeomTransformSetCleanup(geom, 1);
                dGeomTransformSetGeom(geom, held);
            }
        }
        if (i % 3 == 0) {
            const int messages_before = messages();
            dGeomSetOffsetPosition(geom, dReal(0.1), 0, 0);
            EXPECT_EQ(messages() - messages_before, dGeomIsOffset(geom) ? 0 : 1);
        }
        const int messages_before = messages();
        dBodySetAutoDisableAverageSamplesCount(body, unsigned(10 + i));
        EXPECT_EQ(messages() - messages_before,
                  dBodyGetAutoDisableAverageSamplesCount(body) == 10 + i ? 0 : 1);
    }

    void tie_bodies()
    {
        for (std::size_t i = 0; i + 1 < bodies_.size() && i < 5; ++i) {
            dJointGroupID group = i % 2 ? group_ : nullptr;
            const int before = dBodyGetNumJoints(bodies_[i]);
            dJointID joint =
                i % 3 ? ASKED(dJointCreateHinge(world_, group)) : ASKED(dJointCreateBall(world_, group));
            if (joint) dJointAttach(joint, bodies_[i], bodies_[i + 1]);
            EXPECT_EQ(dBodyGetNumJoints(bodies_[i]), before + (joint ? 1 : 0));
        }
    }

    void add_field()
    {
        static const double heights[16] = {0, 0.1, 0, 0, 0.1, 0.2, 0.1, 0, 0, 0.1, 0, 0, 0, 0, 0, 0};
        dHeightfieldDataID field = ASKED(dGeomHeightfieldDataCreate());
        if (!field) return;
        fields_.push_back(field);
        dGeomHeightfieldDataBuildDouble(field, heights, 1, 8, 8, 4, 4, dReal(0.1), 0, 1, 0);
        ASKED(dCreateHeightfield(outer_, field, 1));
    }

    void add_user_geom()
    {
        dGeomClass description{};
        description.bytes = 100;
        description.collider = offer;
        description.aabb = user_box;
        const int number = dCreateGeomClass(&description);
        ASSERT_GE(number, 0);
        if (dGeomID geom = ASKED(dCreateGeom(number))) {
            loose_.push_back(geom);
            dSpaceAdd(outer_, geom);
        }
        if (!loose_.empty() && dGeomGetSpace(loose_.back())) loose_.pop_back();  // dies with the space
    }

    // Bodies come and go, geoms change their space.
    void change()
    {
        if (bodies_.size() > 3) {
            dGeomID geom = dBodyGetFirstGeom(bodies_[1]);
            if (geom && inner_) {
                dSpaceID from = dGeomGetSpace(geom), to = from == inner_ ? outer_ : inner_;
                if (from) dSpaceRemove(from, geom);
                const int messages_before = messages();
                dSpaceAdd(to, geom);
                EXPECT_EQ(messages() - messages_before, dGeomGetSpace(geom) == to ? 0 : 1);
                if (!dGeomGetSpace(geom)) loose_.push_back(geom);
            }
            dBodyDestroy(bodies_[2]);
            bodies_.erase(bodies_.begin() + 2);
        }
        add_body(int(bodies_.size()));
    }

    static void near(void* self, dGeomID a, dGeomID b)
    {
        Scene& scene = *static_cast<Scene*>(self);
        if (dGeomIsSpace(a) || dGeomIsSpace(b)) return dSpaceCollide2(a, b, self, &near);
        dContact contact[2];
        const int n = dCollide(a, b, 2, &contact[0].geom, sizeof contact[0]);
        for (int i = 0; i < n; ++i) {
            contact[i].surface = {};
            contact[i].surface.mu = dReal(0.5);
            dJointID joint =
                scene.group_ ? dJointCreateContact(scene.world_, scene.group_, &contact[i]) : nullptr;
            if (!joint) continue;
            dJointAttach(joint, dGeomGetBody(a), dGeomGetBody(b));
            ++scene.contacts_;
        }
    }

    Setting setting_;
    dWorldID world_ = nullptr;
    dSpaceID outer_ = nullptr, inner_ = nullptr;
    dJointGroupID group_ = nullptr;
    std::vector<dBodyID> bodies_;
    std::vector<dGeomID> loose_;
    std::vector<dHeightfieldDataID> fields_;
    int contacts_ = 0;
};

struct Exhaustion : testing::TestWithParam<Setting> {};

TEST_P(Exhaustion, each_allocation_may_fail_and_the_scene_goes_on)
{
    int tried = 0, refused = 0;
    for (bool for_good : {false, true}) {
        for (long n = 0;; ++n) {
            const Library library;
            Scene scene(GetParam());
            Heap::fail_at(n, for_good);
            scene.build();
            for (int i = 0; i < 2; ++i) scene.step_once();
            const bool failed = Heap::failed();
            refused += scene.refused_steps;
            Heap::count();
            if (failed) scene.go_on();
            scene.tear_down();
            if (HasFailure()) {
                ADD_FAILURE() << "with allocation " << n << (for_good ? " and all later ones" : "")
                              << " failing";
                return;
            }
            if (!failed) break;
            ++tried;
        }
    }
    EXPECT_GT(tried, 100);
    EXPECT_GT(refused, 0) << "of the steps";
    RecordProperty("allocations", tried);
}

constexpr Setting kSettings[] = {
    {Stepper::kExact, 1, false}, {Stepper::kExact, 3, false}, {Stepper::kExact, 1, true},
    {Stepper::kExact, 3, true},  {Stepper::kQuick, 1, false}, {Stepper::kQuick, 3, true},
    {Stepper::kFast, 1, true},   {Stepper::kFast, 3, false},
};

INSTANTIATE_TEST_SUITE_P(Settings, Exhaustion, testing::ValuesIn(kSettings), name_of);

// A mat of balls: one island that is worth all threads, whose factor and its plan need large blocks.
TEST(ExhaustionOfALargeIsland, a_step_that_fails_changes_nothing_and_the_next_one_succeeds)
{
    for (Stepper stepper : kSteppers)
        for (int threads : {1, 3}) {
            const Library library;
            constexpr int kSide = 14;
            dWorldID world = dWorldCreate();
            dWorldSetGravity(world, 0, 0, dReal(-9.81));
            dWorldSetStepThreads(world, threads);
            std::vector<dBodyID> bodies;
            for (int i = 0; i < kSide * kSide; ++i) {
                bodies.push_back(dBodyCreate(world));
                dBodySetPosition(bodies.back(), dReal(i % kSide), dReal(i / kSide), 0);
            }
            const auto tie = [&](int a, int b) {
                dJointID joint = dJointCreateBall(world, nullptr);
                dJointAttach(joint, bodies[std::size_t(a)], bodies[std::size_t(b)]);
                const dReal* p = dBodyGetPosition(bodies[std::size_t(a)]);
                dJointSetBallAnchor(joint, p[0] + dReal(0.5), p[1], 0);
            };
            for (int i = 0; i < kSide * kSide; ++i) {
                if (i % kSide + 1 < kSide) tie(i, i + 1);
                if (i + kSide < kSide * kSide) tie(i, i + kSide);
            }
            int refused = 0;
            for (long n = 0;; ++n) {
                const std::uint64_t before = hash_of(bodies);
                Heap::fail_at(n, true);
                if (step(world, stepper, dReal(0.01))) break;
                ++refused;
                EXPECT_EQ(hash_of(bodies), before) << "allocation " << n;
                ASSERT_LT(n, 1000);
            }
            EXPECT_GT(refused, 2);
            Heap::count();
            EXPECT_EQ(step(world, stepper, dReal(0.01)), 1);
            for (dBodyID b : bodies) EXPECT_TRUE(finite(b));
            dWorldDestroy(world);
        }
}

}  // namespace
}  // namespace epode::memory
