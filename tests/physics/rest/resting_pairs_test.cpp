// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Where most of a world sleeps, a step looks at what is awake alone. That must be seen in its time only: a
// twin, whose space holds another space and therefore is looked at as a whole in every step, goes through the
// same random calls, and has the same bits, contacts and events after each of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <random>
#include <tuple>
#include <vector>

#include "ode/ext.h"
#include "ode/ode.h"

namespace {

constexpr int kPiles = 40, kHeight = 3;
constexpr dReal kH = dReal(1) / 60;

enum class Stepper { kExact, kQuick, kSubsteps, kHybrid };

class Scene {
  public:
    Scene(Stepper stepper, bool whole) : stepper_(stepper)
    {
        world = dWorldCreate();
        space = dHashSpaceCreate(nullptr);
        if (whole) dSimpleSpaceCreate(space);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetContactSpace(world, space);
        dWorldSetAutoDisableFlag(world, 1);
        dWorldSetAutoDisableSteps(world, 4);
        dWorldSetAutoDisableTime(world, 0);
        dWorldSetAutoDisableLinearThreshold(world, dReal(0.05));
        dWorldSetAutoDisableAngularThreshold(world, dReal(0.05));
        dWorldSetDamping(world, dReal(0.02), dReal(0.05));  // what rolls comes to rest, too
        grounds.push_back(dCreatePlane(space, 0, 0, 1, 0));
        grounds.push_back(dCreateBox(space, 8, 200, 1));
        dGeomSetPosition(grounds[1], 20, 0, dReal(-0.3));
        grounds.push_back(floor_of_triangles());
        for (int i = 0; i < kPiles; ++i)
            for (int k = 0; k < kHeight; ++k)
                add(dReal(i % 8) * 4, dReal(i / 8) * 3, dReal(0.51) + dReal(1.01) * dReal(k), i % 5);
        for (int i = 0; i + kHeight < 30; i += 10) tie(i + kHeight - 1, i + 2 * kHeight - 1);
    }
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;
    ~Scene()
    {
        dWorldDestroy(world);
        dSpaceDestroy(space);
        dGeomTriMeshDataDestroy(mesh_);
    }

    void add(dReal x, dReal y, dReal z, int kind)
    {
        const dBodyID body = dBodyCreate(world);
        dMass mass;
        dMassSetBox(&mass, 500, 1, 1, 1);
        dBodySetMass(body, &mass);
        dBodySetPosition(body, x, y, z);
        const dGeomID geom = kind == 3   ? dCreateCylinder(space, dReal(0.5), 1)
                             : kind == 4 ? dCreateCapsule(space, dReal(0.5), dReal(0.01))
                                         : dCreateBox(space, 1, 1, 1);
        dGeomSetBody(geom, body);
        bodies.push_back(body), geoms.push_back(geom);
    }

    void tie(int a, int b)
    {
        const dJointID joint = dJointCreateBall(world, nullptr);
        dJointAttach(joint, bodies[std::size_t(a)], bodies[std::size_t(b)]);
        const dReal* p = dBodyGetPosition(bodies[std::size_t(a)]);
        dJointSetBallAnchor(joint, p[0], p[1], p[2]);
    }

    void step()
    {
        switch (stepper_) {
            case Stepper::kExact:
                dWorldStep(world, kH);
                break;
            case Stepper::kQuick:
                dWorldQuickStep(world, kH);
                break;
            case Stepper::kSubsteps:
                dWorldStepFast1(world, kH, 4);
                break;
            case Stepper::kHybrid:
                dWorldStepHybrid(world, kH);
                break;
        }
    }

    int awake() const
    {
        int count = 0;
        for (const dBodyID body : bodies) count += body && dBodyIsEnabled(body);
        return count;
    }

    std::vector<dReal> state() const
    {
        std::vector<dReal> all;
        const auto add = [&](const dReal* from, int n) { all.insert(all.end(), from, from + n); };
        for (const dBodyID body : bodies) {
            if (!body) continue;
            add(dBodyGetPosition(body), 3), add(dBodyGetQuaternion(body), 4);
            add(dBodyGetLinearVel(body), 3), add(dBodyGetAngularVel(body), 3);
            all.push_back(dReal(dBodyIsEnabled(body)));
        }
        return all;
    }

    // Geoms by number, so that twins can be compared.
    int number(dGeomID geom) const
    {
        if (!geom) return -1;
        const auto at = std::find(geoms.begin(), geoms.end(), geom);
        if (at != geoms.end()) return int(at - geoms.begin());
        return 1000 + int(std::find(grounds.begin(), grounds.end(), geom) - grounds.begin());
    }

    std::vector<std::tuple<int, int, int>> events() const
    {
        std::vector<dContactEvent> got(std::size_t(dWorldGetContactEvents(world, nullptr, 0)));
        dWorldGetContactEvents(world, got.data(), int(got.size()));
        std::vector<std::tuple<int, int, int>> out;
        for (const dContactEvent& e : got) out.emplace_back(number(e.g1), number(e.g2), int(e.kind));
        std::sort(out.begin(), out.end());
        return out;
    }

    std::vector<std::array<dReal, 9>> contacts() const
    {
        std::vector<dWorldContact> got(std::size_t(dWorldGetContacts(world, nullptr, 0)));
        dWorldGetContacts(world, got.data(), int(got.size()));
        std::vector<std::array<dReal, 9>> out;
        for (const dWorldContact& c : got)
            out.push_back({dReal(number(c.g1)), dReal(number(c.g2)), c.pos[0], c.pos[1], c.pos[2],
                           c.normal[0], c.normal[2], c.depth, c.normal_force});
        std::sort(out.begin(), out.end());
        return out;
    }

    dWorldID world;
    dSpaceID space;
    std::vector<dGeomID> grounds;  // null: gone
    std::vector<dBodyID> bodies;   // null: gone
    std::vector<dGeomID> geoms;    // of the bodies; null: gone

  private:
    dGeomID floor_of_triangles()
    {
        static const dReal corners[4][4] = {{26, -5, 0, 0}, {34, -5, 0, 0}, {34, 20, 0, 0}, {26, 20, 0, 0}};
        static const dTriIndex faces[2][3] = {{0, 1, 2}, {0, 2, 3}};
        mesh_ = dGeomTriMeshDataCreate();
#ifdef dIDEDOUBLE
        dGeomTriMeshDataBuildDouble(mesh_, corners, sizeof corners[0], 4, faces, 6, sizeof faces[0]);
#else
        dGeomTriMeshDataBuildSingle(mesh_, corners, sizeof corners[0], 4, faces, 6, sizeof faces[0]);
#endif
        const dGeomID geom = dCreateTriMesh(space, mesh_, nullptr, nullptr, nullptr);
        dGeomSetPosition(geom, 0, 0, dReal(0.02));
        return geom;
    }

    Stepper stepper_;
    dTriMeshDataID mesh_ = nullptr;
};

using Random = std::mt19937;

int below(Random& random, int n) { return int(random() % unsigned(n)); }

void kick(Scene& s, int i, Random& random)
{
    if (!s.bodies[std::size_t(i)]) return;
    dBodyEnable(s.bodies[std::size_t(i)]);
    dBodySetLinearVel(s.bodies[std::size_t(i)], dReal(below(random, 5) - 2), dReal(below(random, 5) - 2), 1);
}

void touch_body(Scene& s, int i, int what, Random& random)
{
    const dBodyID body = s.bodies[std::size_t(i)];
    dGeomID& geom = s.geoms[std::size_t(i)];
    if (!body) return;
    switch (what) {
        case 0:
            dBodyDisable(body);
            break;
        case 1:
            dBodyEnable(body);
            break;
        case 2: {
            const dReal* p = dBodyGetPosition(body);
            dBodySetPosition(body, p[0] + dReal(0.2), p[1], p[2] + dReal(below(random, 2)));
            break;
        }
        case 3:
            geom&& dGeomIsEnabled(geom) ? dGeomDisable(geom) : geom ? dGeomEnable(geom) : void();
            break;
        case 4:
            if (geom) dGeomSetCollideBits(geom, dGeomGetCollideBits(geom) ? 0 : ~0ul);
            break;
        case 5:
            if (geom) dGeomDestroy(geom);
            geom = nullptr;
            break;
        case 6:
            dBodyDestroy(body);  // its geom stays where it is
            s.bodies[std::size_t(i)] = nullptr;
            break;
        case 7:
            dBodySetKinematic(body), dBodyEnable(body), dBodySetLinearVel(body, dReal(0.1), 0, 0);
            break;
        case 8:
            dBodySetDynamic(body);
            break;
        default:
            break;
    }
}

// One of the calls that a program makes between steps, drawn from `random`.
void disturb(Scene& s, unsigned seed)
{
    Random random(seed);
    const int what = below(random, 100), i = below(random, int(s.bodies.size()));
    if (what < 30) return;
    if (what < 45) return kick(s, i, random);
    if (what < 54) return touch_body(s, i, what - 45, random);
    if (what < 57) return s.add(dReal(below(random, 28)), dReal(below(random, 12)), 6, below(random, 5));
    if (what < 59 && s.grounds[1])
        return dGeomSetPosition(s.grounds[1], 20, 0, dReal(-0.3) - dReal(below(random, 2)));
    if (what < 60 && s.grounds[2])
        return dGeomSetPosition(s.grounds[2], 0, 0, dReal(0.01) * dReal(below(random, 3)));
    if (what < 62) {
        const dGeomID block = dCreateBox(s.space, 1, 1, 1);
        dGeomSetPosition(block, dReal(below(random, 28)), dReal(below(random, 12)), dReal(0.5));
        return s.grounds.push_back(block);
    }
    if (what < 64 && s.grounds.size() > 3) {
        if (s.grounds.back()) dGeomDestroy(s.grounds.back());
        return s.grounds.pop_back();
    }
    if (what < 66) {
        dSpaceCollide(s.space, nullptr, [](void*, dGeomID, dGeomID) {});
        return;
    }
    if (what < 67 && s.bodies[std::size_t(i)] && s.bodies[0] && i > 0) return s.tie(0, i);
}

class RestingPairs : public testing::TestWithParam<std::tuple<Stepper, int>> {};

TEST_P(RestingPairs, do_not_differ_from_pairs_that_are_looked_at)
{
    const auto [stepper, seed] = GetParam();
    Scene few(stepper, false), whole(stepper, true);
    Random random(unsigned(seed) * 7919u + 1u);
    int few_awake = 0, woken = 0, before = 0;
    const int steps = 1200;
    for (int i = 0; i < steps; ++i) {
        // Calls come in bursts, so that all may fall asleep between them.
        const unsigned call = unsigned(random());
        if (i > 100 && i % 150 < 20) disturb(few, call), disturb(whole, call);
        few.step(), whole.step();
        ASSERT_EQ(few.state(), whole.state()) << "step " << i;
        ASSERT_EQ(few.events(), whole.events()) << "step " << i;
        ASSERT_EQ(few.contacts(), whole.contacts()) << "step " << i;
        const int awake = few.awake();
        few_awake += awake > 0 && 16 * awake <= int(few.bodies.size());
        woken += awake > before;
        before = awake;
    }
    EXPECT_GT(few_awake, steps / 20);
    EXPECT_GT(woken, steps / 100);
}

INSTANTIATE_TEST_SUITE_P(steppers, RestingPairs,
                         testing::Combine(testing::Values(Stepper::kExact, Stepper::kQuick,
                                                          Stepper::kSubsteps, Stepper::kHybrid),
                                          testing::Values(1, 2, 3)));

}  // namespace
