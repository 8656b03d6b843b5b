// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A world that is rolled back again and again, and a twin that never is. Both receive the same: random
// pushes, bodies woken, put to sleep, moved or made kinematic, geoms moved and disabled, motors and joints
// changed, steps. One goes back to a state that it has kept, whole or as a difference, and receives once more
// what happened since; then both have the same bytes. EPODE_STATE_OPERATIONS in the environment: how many
// operations in place of some thousands.
#include <cstdlib>

#include "../effort.h"
#include "scene.h"

namespace epode::states {
namespace {

struct Operation {
    unsigned kind, object;
    dReal x, y;
};

using Random = std::mt19937;

Operation draw(Random& random)
{
    const auto small = [&] { return dReal(int(random() % 9) - 4) / 2; };
    const unsigned kind = random() % 20, object = random();
    const dReal x = small(), y = small();
    return {kind, object, x, y};
}

void move(Scene& s, dBodyID body, const Operation& o)
{
    const dReal* p = dBodyGetPosition(body);
    dBodySetPosition(body, p[0] + o.x / 8, p[1] + o.y / 8, p[2] + dReal(0.1));
    (void)s;
}

void change_joint(Scene& s, const Operation& o)
{
    if (s.joints.empty()) return;
    const dJointID joint = s.joints[o.object % s.joints.size()];
    if (o.kind == 13) return dJointIsEnabled(joint) ? dJointDisable(joint) : dJointEnable(joint);
    dJointSetHingeParam(s.joints[1], dParamVel, o.x), dJointSetHingeParam(s.joints[1], dParamFMax, 50);
    dJointSetSliderParam(s.joints[2], dParamVel, o.y);
}

void apply(Scene& s, const Operation& o)
{
    // Without a space of the world's, geoms are the program's.
    if (!s.setting.world_contacts && (o.kind == 7 || o.kind == 8)) return;
    const dBodyID body = s.bodies[o.object % s.bodies.size()];
    switch (o.kind) {
        case 0:
        case 1:
            return dBodyEnable(body), dBodySetLinearVel(body, o.x, o.y, 1);
        case 2:
            return dBodyAddForce(body, 300 * o.x, 300 * o.y, 900);
        case 3:
            return dBodySetAngularVel(body, o.x, o.y, 0);
        case 4:
            return dBodyIsEnabled(body) ? dBodyDisable(body) : dBodyEnable(body);
        case 5:
            return move(s, body, o);
        case 6:
            return dBodyIsKinematic(body) ? dBodySetDynamic(body) : dBodySetKinematic(body);
        case 7:
            return dGeomSetPosition(s.grounds[1], 11 + o.x / 4, o.y / 4, dReal(-0.3));
        case 8: {
            const dGeomID geom = dBodyGetFirstGeom(body);
            return dGeomIsEnabled(geom) ? dGeomDisable(geom) : dGeomEnable(geom);
        }
        case 9:
            return dBodySetGravityMode(body, !dBodyGetGravityMode(body));
        case 10: {
            const dMatrix3 R = {0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1, 0};
            return dBodySetRotation(body, R);
        }
        case 11:
            return dBodySetAutoDisableFlag(body, !dBodyGetAutoDisableFlag(body));
        case 12:
        case 13:
            return change_joint(s, o);
        default:
            return s.step();
    }
}

struct Moment {
    std::size_t at;  // operations before it
    Bytes state;
};

// Back to a moment that has been kept, and on to the present.
void roll_back(Scene& s, const std::vector<Moment>& kept, const std::vector<Operation>& done, Random& random)
{
    const Moment& to = kept[random() % kept.size()];
    if (random() % 2) {
        const Moment& base = kept[random() % kept.size()];
        ASSERT_TRUE(s.load(to.state)) << Messages::last();
        Bytes delta(dWorldGetStateDelta(s.world, base.state.data(), base.state.size(), nullptr, 0));
        ASSERT_EQ(
            dWorldGetStateDelta(s.world, base.state.data(), base.state.size(), delta.data(), delta.size()),
            delta.size());
        s.step();
        ASSERT_EQ(
            dWorldSetStateDelta(s.world, base.state.data(), base.state.size(), delta.data(), delta.size()), 1)
            << Messages::last();
    } else {
        ASSERT_TRUE(s.load(to.state)) << Messages::last();
    }
    for (std::size_t i = to.at; i < done.size(); ++i) apply(s, done[i]);
}

int operations()
{
    const char* wanted = std::getenv("EPODE_STATE_OPERATIONS");
    return wanted ? std::atoi(wanted) : tests::effort(1500);
}

class Twins : public testing::TestWithParam<int> {};

TEST_P(Twins, stay_alike_although_one_is_rolled_back)
{
    const Messages messages;
    const Setting setting{.stepper = kSteppers[std::size_t(GetParam()) % 4],
                          .world_contacts = GetParam() < 4};
    Scene one(setting), twin(setting);
    Random random(unsigned(17 + GetParam()));
    std::vector<Operation> done;
    std::vector<Moment> kept;
    constexpr std::size_t kWindow = 64;
    for (int i = 0; i < operations(); ++i) {
        if (kept.empty() || random() % 16 == 0) kept.push_back({done.size(), one.save()});
        if (done.size() > kWindow) {
            for (Moment& m : kept) m.at -= std::min(m.at, kWindow / 2);
            done.erase(done.begin(), done.begin() + kWindow / 2);
            kept = {{done.size(), one.save()}};
        }
        done.push_back(draw(random));
        apply(one, done.back()), apply(twin, done.back());
        if (random() % 8 == 0) roll_back(one, kept, done, random);
        if (HasFatalFailure()) return;
        ASSERT_EQ(difference(one.save(), twin.save()), "")
            << "after operation " << i << " of kind " << done.back().kind;
    }
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

INSTANTIATE_TEST_SUITE_P(Settings, Twins, testing::Range(0, 8));

}  // namespace
}  // namespace epode::states
