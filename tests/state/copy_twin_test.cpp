// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// A program that is moved from world to world, and a twin that stays where it is. Both do the same: random
// pushes, bodies, joints, drives and couplings created, changed and destroyed, steps. One goes on in a clone
// of its world from time to time, or in what a file of it becomes, or is given back a state of its own, or
// takes steps back that the twin has never made, with what was created and destroyed in them. Both always
// have the same bytes. EPODE_STATE_OPERATIONS in the environment: how many operations in place of some
// thousands.
#include <algorithm>
#include <cstdlib>
#include <utility>

#include "../effort.h"
#include "copy_scene.h"

namespace epode::states {
namespace {

using Random = std::mt19937;

struct Operation {
    unsigned kind, a, b;
    dReal x, y;
};

// Up to this one none changes what histories do not take back.
constexpr unsigned kTame = 17, kKinds = 20;

Operation draw(Random& random, unsigned kinds)
{
    const auto small = [&] { return dReal(int(random() % 9) - 4) / 2; };
    const unsigned kind = random() % kinds, a = random(), b = random();
    const dReal x = small(), y = small();
    return {kind, a, b, x, y};
}

class Program {
  public:
    explicit Program(const Setting& setting) : setting_(setting), world(dWorldCreate())
    {
        space_ = dHashSpaceCreate(nullptr);
        dWorldSetGravity(world, 0, 0, dReal(-9.81));
        dWorldSetAutoDisableFlag(world, 1);
        if (setting.world_contacts) dWorldSetContactSpace(world, space_);
        dCreatePlane(space_, 0, 0, 1, 0);
        for (unsigned i = 0; i < 8; ++i) create({0, i, i, dReal(i % 3), dReal(i / 3)});
    }
    ~Program()
    {
        dJointGroupDestroy(contacts_);
        dWorldDestroy(world), dSpaceDestroy(space_);
    }
    Program(const Program&) = delete;
    Program& operator=(const Program&) = delete;

    // True: it was a step.
    bool apply(const Operation& o)
    {
        const dBodyID body = bodies_[o.a % bodies_.size()];
        switch (o.kind) {
            case 0:
                if (bodies_.size() < 14) create(o);
                break;
            case 1:
                destroy_body(o);
                break;
            case 2:
                join(o);
                break;
            case 3:
                if (!joints_.empty() && o.b % 2) dJointDestroy(taken(joints_, o.a));
                break;
            case 4:
                dBodyEnable(body), dBodySetLinearVel(body, o.x, o.y, 1);
                break;
            case 5:
                dBodyIsEnabled(body) ? dBodyDisable(body) : dBodyEnable(body);
                break;
            case 6:
                dBodyIsKinematic(body) ? dBodySetDynamic(body) : dBodySetKinematic(body);
                break;
            case 7:
                change_mass(body, o);
                break;
            case 8:
                dBodySetGravityMode(body, !dBodyGetGravityMode(body)), dBodyAddForce(body, 9 * o.x, 0, 40);
                break;
            case kTame:
                drive(o);
                break;
            case kTame + 1:
                couple(o);
                break;
            case kTame + 2:
                change_geom(dBodyGetFirstGeom(body), o);
                break;
            default:
                running().step();
                return true;
        }
        return false;
    }

    void move_to_clone()
    {
        dSpaceID space = space_;
        std::vector<dHandlePair> table(std::size_t(dWorldCountHandles(world, space_)));
        const dWorldID clone = dWorldClone(world, &space, table.data(), int(table.size()));
        ASSERT_TRUE(clone) << Messages::last();
        const auto rename = [&](auto& handle) {
            const auto at = std::find_if(table.begin(), table.end(),
                                         [&](const dHandlePair& pair) { return pair.original == handle; });
            ASSERT_NE(at, table.end());
            handle = static_cast<std::remove_reference_t<decltype(handle)>>(at->copy);
        };
        for (dBodyID& body : bodies_) rename(body);
        for (dJointID& joint : joints_) rename(joint);
        take(clone, space);
    }
    // Objects have the order of their creation.
    void move_to_file()
    {
        const Bytes file = file_of(world, space_);
        dSpaceID space = nullptr;
        const dWorldID loaded = dWorldLoadFromBuffer(file.data(), file.size(), &space);
        ASSERT_TRUE(loaded) << Messages::last();
        rename_by_order(bodies_, world, loaded, dWorldGetBodies);
        rename_by_order(joints_, world, loaded, dWorldGetJoints);
        take(loaded, space);
    }
    // On from a state of its own, after it has been elsewhere.
    void return_to_state(Random& random)
    {
        const Bytes state = state_of(world);
        for (unsigned i = random() % 4; i-- > 0;) running().step();
        dBodySetPosition(bodies_[0], 3, 3, 3);
        ASSERT_EQ(dWorldSetState(world, state.data(), state.size()), 1) << Messages::last();
    }
    // Lives on for a while, and takes it back. The last operation was a step.
    void make_excursion(Random& random)
    {
        if (has_couplings()) return;
        const auto bodies = bodies_;
        const auto joints = joints_;
        int made = 0;
        for (unsigned i = random() % 12; i-- > 0 && made < kFrames;) made += apply(draw(random, kTame));
        ASSERT_EQ(dWorldRollBack(world, made), 1) << Messages::last();
        bodies_ = bodies, joints_ = joints;
    }
    void keep_history() { ASSERT_EQ(dWorldSetHistory(world, kFrames), 1); }

  private:
    static constexpr int kFrames = 6;

    Running running() const { return {world, space_, contacts_, setting_.stepper, setting_.world_contacts}; }

    template <typename Id>
    static Id taken(std::vector<Id>& from, unsigned i)
    {
        const auto at = from.begin() + long(i % from.size());
        const Id id = *at;
        from.erase(at);
        return id;
    }
    template <typename Id, typename List>
    static void rename_by_order(std::vector<Id>& ids, dWorldID from, dWorldID to, List list)
    {
        std::vector<Id> old(std::size_t(list(from, nullptr, 0))), fresh(std::size_t(list(to, nullptr, 0)));
        ASSERT_EQ(old.size(), fresh.size());
        list(from, old.data(), int(old.size())), list(to, fresh.data(), int(fresh.size()));
        for (Id& id : ids) id = fresh[std::size_t(std::find(old.begin(), old.end(), id) - old.begin())];
    }
    void take(dWorldID other, dSpaceID its_space)
    {
        const bool history = dWorldGetHistory(world) > 0;
        dWorldDestroy(world), dSpaceDestroy(space_);
        world = other, space_ = its_space;
        if (history) keep_history();
    }

    void create(const Operation& o)
    {
        const dBodyID body = dBodyCreate(world);
        const dReal r = dReal(0.3);
        const dGeomID geom = o.a % 4 == 0   ? dCreateSphere(space_, r)
                             : o.a % 4 == 1 ? dCreateCapsule(space_, r, r)
                             : o.a % 4 == 2 ? dCreateCylinder(space_, r, 2 * r)
                                            : dCreateBox(space_, r, 2 * r, r);
        dGeomSetBody(geom, body);
        dBodySetPosition(body, o.x, o.y, dReal(0.5) + dReal(o.b % 7) / 2);
        if (o.b % 4 == 0) dGeomSetOffsetPosition(geom, 0, dReal(0.05), 0);
        bodies_.push_back(body);
    }
    void destroy_body(const Operation& o)
    {
        if (bodies_.size() < 4) return;
        const dBodyID body = taken(bodies_, o.a);
        const dGeomID geom = dBodyGetFirstGeom(body);
        dBodyDestroy(body), dGeomDestroy(geom);
    }
    void join(const Operation& o)
    {
        if (joints_.size() > 8) return;
        const dBodyID a = bodies_[o.a % bodies_.size()], b = bodies_[o.b % bodies_.size()];
        if (a == b) return;
        dJointID joint = nullptr;
        switch (o.a / 16 % 4) {
            case 0:
                joint = dJointCreateBall(world, nullptr);
                break;
            case 1:
                joint = dJointCreateSlider(world, nullptr);
                break;
            default:
                joint = dJointCreateHinge(world, nullptr);
        }
        dJointAttach(joint, a, o.b % 5 ? b : nullptr);
        const dReal* p = dBodyGetPosition(a);
        if (dJointGetType(joint) == dJointTypeHinge)
            dJointSetHingeAnchor(joint, p[0], p[1], p[2] + dReal(0.3)), dJointSetHingeAxis(joint, 0, 1, 0),
                dJointSetHingeParam(joint, dParamVel, o.x), dJointSetHingeParam(joint, dParamFMax, 2);
        else if (dJointGetType(joint) == dJointTypeBall)
            dJointSetBallAnchor(joint, p[0], p[1], p[2] + dReal(0.3));
        joints_.push_back(joint);
    }
    void drive(const Operation& o)
    {
        if (joints_.empty()) return;
        const dJointID joint = joints_[o.a % joints_.size()];
        dJointSetBreakLimits(joint, 500, 900);
        if (dJointGetType(joint) == dJointTypeBall) return (void)dJointSetSpring(joint, 2000, 30);
        if (dJointGetType(joint) != dJointTypeHinge) return;
        dDrive drive;
        dDriveInit(&drive, sizeof drive);
        drive.stiffness = 30, drive.damping = 2, drive.target = o.y / 4, drive.friction = dReal(0.1);
        dJointSetDrive(joint, 0, &drive), dJointSetAxisContinuous(joint, 0, int(o.b % 2));
        dJointSetHingeParam(joint, dParamLoStop, -1), dJointSetStopSpring(joint, 0, 200, 5);
    }
    bool has_couplings() const
    {
        return std::any_of(joints_.begin(), joints_.end(),
                           [](dJointID joint) { return dJointGetType(joint) == dJointTypeCoupling; });
    }
    void couple(const Operation& o)
    {
        std::vector<dJointID> hinges;
        for (const dJointID joint : joints_)
            if (dJointGetType(joint) == dJointTypeHinge) hinges.push_back(joint);
        if (hinges.size() < 2 || has_couplings()) return;
        const dJointID coupling = dJointCreateCoupling(world, nullptr);
        dJointSetCouplingAxis(coupling, 0, hinges[0], 0, 1);
        dJointSetCouplingAxis(coupling, 1, hinges[1], 0, dReal(-0.5));
        if (o.b % 2) dJointSetCouplingParam(coupling, dParamHiStop, dReal(0.2));
        joints_.push_back(coupling);
    }
    void change_mass(dBodyID body, const Operation& o)
    {
        dMass mass;
        dMassSetSphereTotal(&mass, 1 + dReal(o.b % 4), dReal(0.3));
        dBodySetMass(body, &mass);
    }
    void change_geom(dGeomID geom, const Operation& o)
    {
        dMaterial material;
        dMaterialInit(&material, sizeof material);
        material.friction = dReal(o.b % 3) / 2;
        dGeomSetMaterial(geom, &material);
        dGeomSetContinuous(geom, o.b % 4 == 0 ? dContinuousOn : dContinuousOff);
        if (dGeomGetClass(geom) == dSphereClass) dGeomSphereSetRadius(geom, dReal(0.3) + dReal(o.b % 3) / 10);
    }

    const Setting setting_;
    const dJointGroupID contacts_ = dJointGroupCreate(0);
    dSpaceID space_;
    std::vector<dBodyID> bodies_;
    std::vector<dJointID> joints_;

  public:
    dWorldID world;
};

int operations()
{
    const char* wanted = std::getenv("EPODE_STATE_OPERATIONS");
    return wanted ? std::atoi(wanted) : tests::effort(3000);
}

class MovingTwins : public testing::TestWithParam<int> {};

TEST_P(MovingTwins, stay_alike_although_one_goes_from_copy_to_copy)
{
    const Messages messages;
    const Setting setting{.stepper = kSteppers[std::size_t(GetParam()) % 4],
                          .world_contacts = GetParam() < 4};
    Program one(setting), twin(setting);
    one.keep_history();
    Random random(unsigned(29 + GetParam()));
    for (int i = 0; i < operations(); ++i) {
        const Operation o = draw(random, kKinds);
        const bool stepped = one.apply(o);
        twin.apply(o);
        const unsigned next = random() % 32;
        if (next == 0) one.move_to_clone();
        if (next == 1) one.move_to_file();
        if (next == 2) one.return_to_state(random);
        if (next > 24 && stepped) one.make_excursion(random);
        if (HasFatalFailure()) return;
        ASSERT_EQ(difference(state_of(one.world), state_of(twin.world)), "")
            << "after operation " << i << " of kind " << o.kind << ", then " << next;
        if (next < 2) { ASSERT_EQ(text_of(one.world), text_of(twin.world)) << "after operation " << i; }
    }
    EXPECT_EQ(Messages::count(), 0) << Messages::last();
}

INSTANTIATE_TEST_SUITE_P(Settings, MovingTwins, testing::Range(0, 8));

}  // namespace
}  // namespace epode::states
