// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers that are none: every setter refuses NaN, and infinity where no limit is meant, says so once, and
// leaves everything that can be read exactly as it was. The world goes on afterwards.
#include <cstring>
#include <functional>
#include <limits>

#include "rig.h"

namespace epode::physics {
namespace {

constexpr dReal kNaN = std::numeric_limits<dReal>::quiet_NaN();
constexpr dReal kInf = std::numeric_limits<dReal>::infinity();

using Reals = std::vector<dReal>;

struct Trust : testing::Test {
    Sim sim;
    Messages messages;
    dBodyID b = sim.box({1, 2, 3}, {1, 1, 1}, 2);
    dBodyID b2 = sim.sphere({4, 2, 3}, 0.5, 2);
    dGeomID box = dBodyGetFirstGeom(b), ball = dBodyGetFirstGeom(b2);
    dGeomID capsule = dCreateCapsule(sim.space, 1, 2), cylinder = dCreateCylinder(sim.space, 1, 2);
    dGeomID plane = dCreatePlane(sim.space, 0, 0, 1, -50), ray = dCreateRay(sim.space, 3);
    dJointID hinge = attached(dJointCreateHinge(sim.world, nullptr));
    dJointID slider = attached(dJointCreateSlider(sim.world, nullptr));
    dJointID universal = attached(dJointCreateUniversal(sim.world, nullptr));
    dJointID hinge2 = attached(dJointCreateHinge2(sim.world, nullptr));
    dJointID balljoint = attached(dJointCreateBall(sim.world, nullptr));
    dJointID amotor = attached(dJointCreateAMotor(sim.world, nullptr));

    dJointID attached(dJointID j)
    {
        dJointAttach(j, b, b2);
        return j;
    }
    void SetUp() override
    {
        velocity(b, {1, 2, 3}, {0.1, 0.2, 0.3});
        dJointSetAMotorNumAxes(amotor, 3);
        for (dGeomID g : {capsule, cylinder}) dGeomSetPosition(g, 20, 0, 0);
    }

    void read_bodies(Reals& out)
    {
        for (dBodyID each : {b, b2}) {
            const auto add = [&out](const dReal* p, int n) { out.insert(out.end(), p, p + n); };
            add(dBodyGetPosition(each), 3), add(dBodyGetQuaternion(each), 4);
            add(dBodyGetRotation(each), 3), add(dBodyGetLinearVel(each), 3);
            add(dBodyGetAngularVel(each), 3), add(dBodyGetForce(each), 3), add(dBodyGetTorque(each), 3);
            dMass m;
            dBodyGetMass(each, &m);
            add(&m.mass, 1), add(m.I, 11);
            dVector3 axis{};
            dBodyGetFiniteRotationAxis(each, axis);
            add(axis, 3);
            out.insert(out.end(),
                       {dBodyGetLinearDamping(each), dBodyGetAngularDamping(each),
                        dBodyGetMaxAngularSpeed(each), dBodyGetLinearDampingThreshold(each),
                        dBodyGetAngularDampingThreshold(each), dBodyGetAutoDisableLinearThreshold(each),
                        dBodyGetAutoDisableAngularThreshold(each), dBodyGetAutoDisableTime(each)});
        }
    }
    void read_world(Reals& out)
    {
        dVector3 g{};
        dWorldGetGravity(sim.world, g);
        out.insert(out.end(), g, g + 3);
        dWorldID w = sim.world;
        out.insert(out.end(), {dWorldGetERP(w), dWorldGetCFM(w), dWorldGetQuickStepW(w),
                               dWorldGetContactMaxCorrectingVel(w), dWorldGetContactSurfaceLayer(w),
                               dWorldGetLinearDamping(w), dWorldGetAngularDamping(w),
                               dWorldGetMaxAngularSpeed(w), dWorldGetAutoDisableTime(w),
                               dWorldGetAutoDisableLinearThreshold(w), dWorldGetStepWarmStarting(w)});
    }
    void read_joints(Reals& out)
    {
        const auto vector = [&out](void (*get)(dJointID, dReal*), dJointID j) {
            dVector3 v{};
            get(j, v);
            out.insert(out.end(), v, v + 3);
        };
        vector(dJointGetHingeAnchor, hinge), vector(dJointGetHingeAxis, hinge);
        vector(dJointGetSliderAxis, slider), vector(dJointGetBallAnchor, balljoint);
        vector(dJointGetUniversalAnchor, universal), vector(dJointGetUniversalAxis1, universal);
        vector(dJointGetHinge2Anchor, hinge2), vector(dJointGetHinge2Axis1, hinge2);
        for (int axis = 0; axis < 3; ++axis) {
            dVector3 v{};
            dJointGetAMotorAxis(amotor, axis, v);
            out.insert(out.end(), v, v + 3);
        }
        for (int parameter = dParamLoStop; parameter < dParamLoStop + dParamsInGroup; ++parameter)
            out.insert(
                out.end(),
                {dJointGetHingeParam(hinge, parameter), dJointGetSliderParam(slider, parameter),
                 dJointGetUniversalParam(universal, parameter), dJointGetAMotorParam(amotor, parameter)});
    }
    void read_geoms(Reals& out)
    {
        dVector3 v{};
        dGeomBoxGetLengths(box, v);
        out.insert(out.end(), v, v + 3);
        dVector4 p{};
        dGeomPlaneGetParams(plane, p);
        out.insert(out.end(), p, p + 4);
        dReal r = 0, l = 0;
        dGeomCapsuleGetParams(capsule, &r, &l);
        out.insert(out.end(), {dGeomSphereGetRadius(ball), dGeomRayGetLength(ray), r, l});
        dGeomCylinderGetParams(cylinder, &r, &l);
        dVector3 start{}, direction{};
        dGeomRayGet(ray, start, direction);
        out.insert(out.end(), {r, l, start[0], start[1], start[2], direction[0], direction[1], direction[2]});
        for (dGeomID g : {capsule, cylinder, ray}) {
            const dReal *x = dGeomGetPosition(g), *R = dGeomGetRotation(g);
            out.insert(out.end(), x, x + 3);
            out.insert(out.end(), R, R + 3);
        }
    }
    Reals read()
    {
        Reals out;
        read_bodies(out), read_world(out), read_joints(out), read_geoms(out);
        return out;
    }

    void refuses(const char* name, const std::function<void(dReal)>& call, std::initializer_list<dReal> bads)
    {
        for (dReal bad : bads) {
            messages.clear();
            const Reals before = read();
            call(bad);
            const Reals after = read();
            ASSERT_EQ(before.size(), after.size());
            EXPECT_EQ(std::memcmp(before.data(), after.data(), before.size() * sizeof(dReal)), 0)
                << name << " took " << bad;
            EXPECT_EQ(messages.count(), 1) << name << " of " << bad << " said: " << messages.last();
        }
    }
    void finite(const char* name, const std::function<void(dReal)>& call)
    {
        refuses(name, call, {kNaN, kInf, -kInf});
    }
    void number(const char* name, const std::function<void(dReal)>& call) { refuses(name, call, {kNaN}); }
};

TEST_F(Trust, setters_of_bodies_refuse_what_is_no_number)
{
    finite("position", [&](dReal x) { dBodySetPosition(b, x, 0, 0); });
    finite("linear velocity", [&](dReal x) { dBodySetLinearVel(b, 0, x, 0); });
    finite("angular velocity", [&](dReal x) { dBodySetAngularVel(b, 0, 0, x); });
    finite("force", [&](dReal x) { dBodySetForce(b, 0, 0, x); });
    finite("torque", [&](dReal x) { dBodySetTorque(b, 0, x, 0); });
    finite("add force", [&](dReal x) { dBodyAddForce(b, x, 0, 0); });
    finite("add torque", [&](dReal x) { dBodyAddTorque(b, x, 0, 0); });
    finite("add relative force", [&](dReal x) { dBodyAddRelForce(b, x, 0, 0); });
    finite("add relative torque", [&](dReal x) { dBodyAddRelTorque(b, x, 0, 0); });
    finite("force at point", [&](dReal x) { dBodyAddForceAtPos(b, 1, 0, 0, 0, x, 0); });
    finite("force at relative point", [&](dReal x) { dBodyAddForceAtRelPos(b, 1, 0, 0, 0, 0, x); });
    finite("relative force at point", [&](dReal x) { dBodyAddRelForceAtPos(b, 1, x, 0, 0, 0, 0); });
    finite("relative force at relative point",
           [&](dReal x) { dBodyAddRelForceAtRelPos(b, 1, 0, 0, 0, x, 0); });
    finite("quaternion", [&](dReal x) {
        const dQuaternion q{1, x, 0, 0};
        dBodySetQuaternion(b, q);
    });
    finite("rotation", [&](dReal x) {
        const dMatrix3 R{1, 0, 0, 0, 0, x, 0, 0, 0, 0, 1, 0};
        dBodySetRotation(b, R);
    });
    finite("mass", [&](dReal x) {
        dMass m;
        dMassSetSphereTotal(&m, 1, 1);
        m.mass = x;
        dBodySetMass(b, &m);
    });
    finite("inertia", [&](dReal x) {
        dMass m;
        dMassSetSphereTotal(&m, 1, 1);
        m.I[5] = x;
        dBodySetMass(b, &m);
    });
    finite("finite rotation axis", [&](dReal x) { dBodySetFiniteRotationAxis(b, x, 0, 1); });
    number("linear damping", [&](dReal x) { dBodySetLinearDamping(b, x); });
    number("angular damping", [&](dReal x) { dBodySetAngularDamping(b, x); });
    number("damping threshold", [&](dReal x) { dBodySetLinearDampingThreshold(b, x); });
    number("angular damping threshold", [&](dReal x) { dBodySetAngularDampingThreshold(b, x); });
    number("max angular speed", [&](dReal x) { dBodySetMaxAngularSpeed(b, x); });
    number("sleep threshold", [&](dReal x) { dBodySetAutoDisableLinearThreshold(b, x); });
    number("angular sleep threshold", [&](dReal x) { dBodySetAutoDisableAngularThreshold(b, x); });
    number("sleep time", [&](dReal x) { dBodySetAutoDisableTime(b, x); });
}

TEST_F(Trust, setters_of_worlds_refuse_what_is_no_number)
{
    dWorldID w = sim.world;
    finite("gravity", [&](dReal x) { dWorldSetGravity(w, 0, 0, x); });
    finite("erp", [&](dReal x) { dWorldSetERP(w, x); });
    finite("cfm", [&](dReal x) { dWorldSetCFM(w, x); });
    finite("w", [&](dReal x) { dWorldSetQuickStepW(w, x); });
    finite("surface layer", [&](dReal x) { dWorldSetContactSurfaceLayer(w, x); });
    finite("linear damping", [&](dReal x) { dWorldSetLinearDamping(w, x); });
    finite("angular damping", [&](dReal x) { dWorldSetAngularDamping(w, x); });
    finite("warm starting", [&](dReal x) { dWorldSetStepWarmStarting(w, x); });
    number("correcting velocity", [&](dReal x) { dWorldSetContactMaxCorrectingVel(w, x); });
    number("max angular speed", [&](dReal x) { dWorldSetMaxAngularSpeed(w, x); });
    number("sleep time", [&](dReal x) { dWorldSetAutoDisableTime(w, x); });
    number("sleep threshold", [&](dReal x) { dWorldSetAutoDisableLinearThreshold(w, x); });
    for (auto* step : {&dWorldStep, &dWorldQuickStep})
        finite("step", [&](dReal x) { EXPECT_EQ(step(w, x), 0); });
    finite("fast step", [&](dReal x) { EXPECT_EQ(dWorldStepFast1(w, x, 5), 0); });
    refuses("no step", [&](dReal x) { EXPECT_EQ(dWorldStep(w, x), 0); }, {dReal(0), dReal(-1)});
    messages.clear();
    EXPECT_EQ(dWorldStepFast1(w, real(0.01), 0), 0);
    EXPECT_EQ(messages.count(), 1);
}

TEST_F(Trust, setters_of_joints_refuse_what_is_no_number)
{
    finite("hinge anchor", [&](dReal x) { dJointSetHingeAnchor(hinge, x, 0, 0); });
    finite("hinge axis", [&](dReal x) { dJointSetHingeAxis(hinge, x, 0, 0); });
    finite("slider axis", [&](dReal x) { dJointSetSliderAxis(slider, 0, x, 0); });
    finite("ball anchor", [&](dReal x) { dJointSetBallAnchor(balljoint, 0, x, 0); });
    finite("ball anchor 2", [&](dReal x) { dJointSetBallAnchor2(balljoint, 0, x, 0); });
    finite("universal anchor", [&](dReal x) { dJointSetUniversalAnchor(universal, 0, x, 0); });
    finite("universal axis", [&](dReal x) { dJointSetUniversalAxis1(universal, 0, x, 0); });
    finite("hinge-2 anchor", [&](dReal x) { dJointSetHinge2Anchor(hinge2, 0, x, 0); });
    finite("hinge-2 axes", [&](dReal x) {
        const dVector3 a{1, 0, x, 0}, c{0, 1, 0, 0};
        dJointSetHinge2Axes(hinge2, a, c);
    });
    finite("motor axis", [&](dReal x) { dJointSetAMotorAxis(amotor, 0, 0, x, 0, 0); });
    finite("hinge torque", [&](dReal x) { dJointAddHingeTorque(hinge, x); });
    finite("slider force", [&](dReal x) { dJointAddSliderForce(slider, x); });
    finite("universal torques", [&](dReal x) { dJointAddUniversalTorques(universal, 1, x); });
    finite("hinge-2 torques", [&](dReal x) { dJointAddHinge2Torques(hinge2, x, 1); });
    finite("motor torques", [&](dReal x) { dJointAddAMotorTorques(amotor, 0, x, 0); });
    for (int parameter = dParamLoStop; parameter <= dParamStopCFM; ++parameter) {
        number("hinge parameter", [&](dReal x) { dJointSetHingeParam(hinge, parameter, x); });
        number("slider parameter", [&](dReal x) { dJointSetSliderParam(slider, parameter, x); });
        number("universal parameter", [&](dReal x) { dJointSetUniversalParam(universal, parameter, x); });
        number("hinge-2 parameter", [&](dReal x) { dJointSetHinge2Param(hinge2, parameter, x); });
        number("motor parameter", [&](dReal x) { dJointSetAMotorParam(amotor, parameter, x); });
    }
    refuses("zero axis", [&](dReal x) { dJointSetHingeAxis(hinge, x, 0, 0); }, {dReal(0)});
    finite("contact", [&](dReal x) {
        dContact c = make_contact({0, 0, 0}, {0, 0, 1}, 0);
        c.geom.depth = x;
        EXPECT_EQ(dJointCreateContact(sim.world, nullptr, &c), nullptr);
    });
}

TEST_F(Trust, setters_of_geoms_refuse_what_is_no_number)
{
    finite("geom position", [&](dReal x) { dGeomSetPosition(capsule, x, 0, 0); });
    finite("geom quaternion", [&](dReal x) {
        const dQuaternion q{x, 1, 0, 0};
        dGeomSetQuaternion(capsule, q);
    });
    finite("geom offset", [&](dReal x) { dGeomSetOffsetPosition(box, x, 0, 0); });
    finite("box", [&](dReal x) { dGeomBoxSetLengths(box, 1, x, 1); });
    finite("sphere", [&](dReal x) { dGeomSphereSetRadius(ball, x); });
    finite("capsule", [&](dReal x) { dGeomCapsuleSetParams(capsule, x, 1); });
    finite("cylinder", [&](dReal x) { dGeomCylinderSetParams(cylinder, 1, x); });
    finite("plane", [&](dReal x) { dGeomPlaneSetParams(plane, 0, 0, 1, x); });
    finite("plane normal", [&](dReal x) { dGeomPlaneSetParams(plane, 0, x, 1, 1); });
    finite("ray", [&](dReal x) { dGeomRaySet(ray, 0, 0, 0, x, 0, 1); });
    number("ray length", [&](dReal x) { dGeomRaySetLength(ray, x); });  // may be infinite
    refuses("negative radius", [&](dReal x) { dGeomSphereSetRadius(ball, x); }, {dReal(-1)});
    refuses("negative side", [&](dReal x) { dGeomBoxSetLengths(box, x, 1, 1); }, {dReal(-1)});
}

TEST_F(Trust, a_world_that_has_refused_goes_on)
{
    sim.gravity(0, 0, -9.81);
    for (int i = 0; i < 20; ++i) {
        dBodySetPosition(b, kNaN, 0, 0);
        dBodyAddForce(b2, kInf, 0, 0);
        dJointSetHingeParam(hinge, dParamFMax, kNaN);
        EXPECT_EQ(sim.step(0.01), 1);
    }
    EXPECT_TRUE(finite_state(sim));
    EXPECT_LT(velocity(b).z + velocity(b2).z, 3) << "it falls";
}

}  // namespace
}  // namespace epode::physics
