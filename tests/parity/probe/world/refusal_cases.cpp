// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Bad calls: which are refused. The original ends the program on most of them, so each runs in a process of
// its own; "refused" is a call that reached the debug handler, "taken" one that returned without a word. Ours
// must refuse what the original refuses and take what it takes, except for the calls at the foot, on which
// the two differ on purpose (differences.tsv, E1): their names begin with "ours-".
#include "joints/every_joint.h"

#include <sys/wait.h>
#include <unistd.h>
#include <cmath>
#include <cstdarg>

namespace parity {
namespace {

constexpr int kRefused = 3, kTaken = 4;

void say_refused(int, const char*, va_list) { _exit(kRefused); }

struct Scene {
    dWorldID world = dWorldCreate(), other = dWorldCreate();
    dBodyID a = dBodyCreate(world), b = dBodyCreate(world), stranger = dBodyCreate(other);
    dSpaceID space = dSimpleSpaceCreate(nullptr);
    dGeomID sphere = dCreateSphere(space, 1), box = dCreateBox(nullptr, 1, 1, 1),
            plane = dCreatePlane(space, 0, 0, 1, 0);
    dJointID ball = dJointCreateBall(world, nullptr), hinge = dJointCreateHinge(world, nullptr),
             hinge2 = dJointCreateHinge2(world, nullptr), amotor = dJointCreateAMotor(world, nullptr),
             gear = dJointCreateTransmission(world, nullptr), rod = dJointCreateDBall(world, nullptr);

    Scene()
    {
        for (const dJointID joint : {ball, hinge, hinge2, amotor, gear, rod}) { dJointAttach(joint, a, b); }
    }
};

struct Call {
    const char* name;
    void (*run)(Scene&);
};

const dVector3 kX = {1, 0, 0, 0};
const dQuaternion kNoQuaternion = {0, 0, 0, 0};

void mass_off_centre(dMass& m)
{
    dMassSetSphereTotal(&m, 1, 1);
    m.c[0] = 0.5;
}

const Call kCalls[] = {
    {"good", [](Scene& s) { dWorldStep(s.other, 0.01); }},
    {"world-null", [](Scene&) { dWorldSetGravity(nullptr, 0, 0, 0); }},
    {"world-step-null", [](Scene&) { dWorldStep(nullptr, 0.01); }},
    {"world-step-zero", [](Scene& s) { dWorldStep(s.world, 0); }},
    {"world-step-negative", [](Scene& s) { dWorldStep(s.world, -0.1); }},
    {"world-quick-zero", [](Scene& s) { dWorldQuickStep(s.world, 0); }},
    {"world-quick-negative", [](Scene& s) { dWorldQuickStep(s.world, -1); }},
    {"world-destroy-null", [](Scene&) { dWorldDestroy(nullptr); }},
    {"world-iterations-negative", [](Scene& s) { dWorldSetQuickStepNumIterations(s.world, -1); }},
    {"body-create-null", [](Scene&) { dBodyCreate(nullptr); }},
    {"body-null", [](Scene&) { dBodySetPosition(nullptr, 0, 0, 0); }},
    {"body-get-null", [](Scene&) { dBodyGetPosition(nullptr); }},
    {"body-mass-null", [](Scene& s) { dBodySetMass(s.a, nullptr); }},
    {"body-mass-zero",
     [](Scene& s) {
         dMass m;
         dMassSetZero(&m);
         dBodySetMass(s.a, &m);
     }},
    {"body-mass-off-centre",
     [](Scene& s) {
         dMass m;
         mass_off_centre(m);
         dBodySetMass(s.a, &m);
     }},
    {"body-mass-inertia",
     [](Scene& s) {
         dMass m;
         dMassSetSphereTotal(&m, 1, 1);
         m.I[0] = -1;
         dBodySetMass(s.a, &m);
     }},
    {"body-quaternion-zero", [](Scene& s) { dBodySetQuaternion(s.a, kNoQuaternion); }},
    {"body-joint-beyond", [](Scene& s) { dBodyGetJoint(s.a, 99); }},
    {"body-joint-negative", [](Scene& s) { dBodyGetJoint(s.a, -1); }},
    {"attach-null", [](Scene& s) { dJointAttach(nullptr, s.a, s.b); }},
    {"attach-twice", [](Scene& s) { dJointAttach(s.ball, s.a, s.a); }},
    {"attach-stranger", [](Scene& s) { dJointAttach(s.ball, s.a, s.stranger); }},
    {"attach-hinge2-alone", [](Scene& s) { dJointAttach(s.hinge2, s.a, nullptr); }},
    {"attach-hinge2-none", [](Scene& s) { dJointAttach(s.hinge2, nullptr, nullptr); }},
    {"attach-gear-alone", [](Scene& s) { dJointAttach(s.gear, nullptr, s.b); }},
    {"attach-none", [](Scene& s) { dJointAttach(s.ball, nullptr, nullptr); }},
    {"joint-create-null", [](Scene&) { dJointCreateHinge(nullptr, nullptr); }},
    {"joint-contact-null", [](Scene& s) { dJointCreateContact(s.world, nullptr, nullptr); }},
    {"joint-destroy-null", [](Scene&) { dJointDestroy(nullptr); }},
    {"joint-type-wrong", [](Scene& s) { dJointSetHingeAnchor(s.ball, 0, 0, 0); }},
    {"joint-type-wrong-get", [](Scene& s) { dJointGetHingeAngle(s.ball); }},
    {"joint-type-wrong-param", [](Scene& s) { dJointSetSliderParam(s.hinge, dParamVel, 1); }},
    {"joint-result-null", [](Scene& s) { dJointGetHingeAnchor(s.hinge, nullptr); }},
    {"joint-null", [](Scene&) { dJointSetHingeAnchor(nullptr, 0, 0, 0); }},
    {"joint-data-null", [](Scene&) { dJointGetData(nullptr); }},
    {"joint-axis-zero", [](Scene& s) { dJointSetHingeAxis(s.hinge, 0, 0, 0); }},
    {"hinge2-axes-none", [](Scene& s) { dJointSetHinge2Axes(s.hinge2, nullptr, nullptr); }},
    {"hinge2-axes-parallel", [](Scene& s) { dJointSetHinge2Axes(s.hinge2, kX, kX); }},
    {"amotor-axis-beyond", [](Scene& s) { dJointSetAMotorAxis(s.amotor, 3, 0, 1, 0, 0); }},
    {"amotor-axis-negative", [](Scene& s) { dJointSetAMotorAxis(s.amotor, -1, 0, 1, 0, 0); }},
    {"amotor-axis-zero", [](Scene& s) { dJointSetAMotorAxis(s.amotor, 0, 0, 0, 0, 0); }},
    {"amotor-angle-euler",
     [](Scene& s) {
         dJointSetAMotorMode(s.amotor, dAMotorEuler);
         dJointSetAMotorAngle(s.amotor, 0, 1);
     }},
    {"amotor-euler-rel",
     [](Scene& s) {
         dJointSetAMotorMode(s.amotor, dAMotorEuler);
         dJointSetAMotorAxis(s.amotor, 0, 2, 1, 0, 0);
     }},
    {"amotor-angle-beyond", [](Scene& s) { dJointGetAMotorAngle(s.amotor, 3); }},
    {"amotor-rate-beyond", [](Scene& s) { dJointGetAMotorAngleRate(s.amotor, -1); }},
    {"dball-distance-negative", [](Scene& s) { dJointSetDBallDistance(s.rod, -1); }},
    {"gear-mode", [](Scene& s) { dJointSetTransmissionMode(s.gear, 7); }},
    {"gear-radius-mode", [](Scene& s) { dJointSetTransmissionRadius1(s.gear, 1); }},
    {"gear-ratio-zero", [](Scene& s) { dJointSetTransmissionRatio(s.gear, 0); }},
    {"gear-ratio-mode",
     [](Scene& s) {
         dJointSetTransmissionMode(s.gear, dTransmissionChainDrive);
         dJointSetTransmissionRatio(s.gear, 2);
     }},
    {"gear-axis1-mode", [](Scene& s) { dJointSetTransmissionAxis1(s.gear, 1, 0, 0); }},
    {"group-null", [](Scene&) { dJointGroupEmpty(nullptr); }},
    {"connected-null", [](Scene& s) { dAreConnected(nullptr, s.a); }},
    {"connecting-null", [](Scene&) { dConnectingJoint(nullptr, nullptr); }},
    {"mass-null", [](Scene&) { dMassSetSphere(nullptr, 1, 1); }},
    {"mass-direction-zero",
     [](Scene&) {
         dMass m;
         dMassSetCapsule(&m, 1, 0, 1, 1);
     }},
    {"mass-direction-four",
     [](Scene&) {
         dMass m;
         dMassSetCylinder(&m, 1, 4, 1, 1);
     }},
    {"normalize3-zero",
     [](Scene&) {
         dVector3 v = {0, 0, 0, 0};
         dNormalize3(v);
     }},
    {"normalize4-zero",
     [](Scene&) {
         dVector4 v = {0, 0, 0, 0};
         dNormalize4(v);
     }},
    {"z-axis-zero",
     [](Scene&) {
         dMatrix3 R = {0};
         dRFromZAxis(R, 0, 0, 0);
     }},
    {"plane-space-null",
     [](Scene&) {
         dVector3 q;
         dPlaneSpace(kX, nullptr, q);
     }},
    {"rotation-null", [](Scene&) { dRFromAxisAndAngle(nullptr, 1, 0, 0, 1); }},
    {"rotation-axis-zero",
     [](Scene&) {
         dMatrix3 R = {0};
         dRFromAxisAndAngle(R, 0, 0, 0, 1);
     }},
    {"q-null",
     [](Scene&) {
         dQuaternion q = {1, 0, 0, 0};
         dQMultiply0(q, nullptr, q);
     }},
    {"multiply-size", [](Scene&) { dMultiply0(nullptr, kX, kX, 1, 1, 1); }},
    {"cholesky-null", [](Scene&) { dFactorCholesky(nullptr, 3); }},
    {"cholesky-zero",
     [](Scene&) {
         dReal a[4] = {1, 0, 0, 0};
         dFactorCholesky(a, 0);
     }},
    {"sphere-negative", [](Scene& s) { dCreateSphere(s.space, -1); }},
    {"box-negative", [](Scene& s) { dCreateBox(s.space, 1, -1, 1); }},
    {"capsule-negative", [](Scene& s) { dCreateCapsule(s.space, -1, 1); }},
    {"cylinder-negative", [](Scene& s) { dCreateCylinder(s.space, 1, -1); }},
    {"sphere-set-negative", [](Scene& s) { dGeomSphereSetRadius(s.sphere, -1); }},
    {"box-set-negative", [](Scene& s) { dGeomBoxSetLengths(s.box, 1, 1, -1); }},
    {"geom-type-wrong", [](Scene& s) { dGeomSphereGetRadius(s.box); }},
    {"geom-type-box", [](Scene& s) { dGeomBoxSetLengths(s.sphere, 1, 1, 1); }},
    {"geom-type-plane",
     [](Scene& s) {
         dVector4 p;
         dGeomPlaneGetParams(s.box, p);
     }},
    {"geom-type-ray", [](Scene& s) { dGeomRayGetLength(s.box); }},
    {"geom-null", [](Scene&) { dGeomSetPosition(nullptr, 0, 0, 0); }},
    {"geom-destroy-null", [](Scene&) { dGeomDestroy(nullptr); }},
    {"geom-plane-position", [](Scene& s) { dGeomSetPosition(s.plane, 0, 0, 0); }},
    {"geom-plane-body", [](Scene& s) { dGeomSetBody(s.plane, s.a); }},
    {"geom-plane-no-body", [](Scene& s) { dGeomSetBody(s.plane, nullptr); }},
    {"geom-plane-rotation", [](Scene& s) { dGeomGetRotation(s.plane); }},
    {"geom-offset-no-body", [](Scene& s) { dGeomSetOffsetPosition(s.box, 1, 0, 0); }},
    {"geom-world-offset-no-body", [](Scene& s) { dGeomSetOffsetWorldPosition(s.box, 1, 0, 0); }},
    {"geom-clear-no-body", [](Scene& s) { dGeomClearOffset(s.box); }},
    {"ray-direction-zero",
     [](Scene& s) {
         const dGeomID ray = dCreateRay(s.space, 1);
         dGeomRaySet(ray, 0, 0, 0, 0, 0, 0);
     }},
    {"space-add-twice", [](Scene& s) { dSpaceAdd(s.space, s.sphere); }},
    {"space-remove-stranger", [](Scene& s) { dSpaceRemove(s.space, s.box); }},
    {"space-query-null", [](Scene& s) { dSpaceQuery(s.space, nullptr); }},
    {"space-geom-beyond", [](Scene& s) { dSpaceGetGeom(s.space, 2); }},
    {"space-geom-negative", [](Scene& s) { dSpaceGetGeom(s.space, -1); }},
    {"space-null", [](Scene&) { dSpaceDestroy(nullptr); }},
    {"space-of-geom", [](Scene& s) { dSpaceGetNumGeoms(reinterpret_cast<dSpaceID>(s.box)); }},
    {"space-levels-crossed", [](Scene&) { dHashSpaceSetLevels(dHashSpaceCreate(nullptr), 3, 2); }},
    {"space-levels-simple", [](Scene& s) { dHashSpaceSetLevels(s.space, 1, 2); }},
    {"space-collide-no-callback", [](Scene& s) { dSpaceCollide(s.space, nullptr, nullptr); }},
    {"collide-no-room",
     [](Scene& s) {
         dContactGeom c;
         dCollide(s.sphere, s.box, 0, &c, sizeof c);
     }},
    {"collide-no-contacts", [](Scene& s) { dCollide(s.sphere, s.box, 1, nullptr, sizeof(dContactGeom)); }},
    {"collide-null",
     [](Scene& s) {
         dContactGeom c;
         dCollide(s.sphere, nullptr, 1, &c, sizeof c);
     }},
    {"class-number", [](Scene&) { dCreateGeom(dSphereClass); }},
    {"class-data", [](Scene& s) { dGeomGetClassData(s.sphere); }},
    {"class-empty",
     [](Scene&) {
         dGeomClass c = {};
         dCreateGeomClass(&c);
     }},
    {"transform-of-box", [](Scene& s) { dGeomTransformSetGeom(s.box, s.sphere); }},
};

// The space is locked while it collides: what would change it or move a member is refused.
const Call kLockedCalls[] = {
    {"nothing", [](Scene&) {}},
    {"add", [](Scene& s) { dSpaceAdd(s.space, s.box); }},
    {"remove", [](Scene& s) { dSpaceRemove(s.space, s.sphere); }},
    {"create", [](Scene& s) { dCreateSphere(s.space, 1); }},
    {"destroy-member", [](Scene& s) { dGeomDestroy(s.sphere); }},
    {"destroy-space", [](Scene& s) { dSpaceDestroy(s.space); }},
    {"move-member", [](Scene& s) { dGeomSetPosition(s.sphere, 1, 0, 0); }},
    {"turn-member",
     [](Scene& s) {
         const dQuaternion q = {1, 0, 0, 0};
         dGeomSetQuaternion(s.sphere, q);
     }},
    {"resize-member", [](Scene& s) { dGeomSphereSetRadius(s.sphere, 2); }},
    {"body-member", [](Scene& s) { dGeomSetBody(s.sphere, s.a); }},
    {"bits-member", [](Scene& s) { dGeomSetCategoryBits(s.sphere, 1); }},
    {"collide-bits-member", [](Scene& s) { dGeomSetCollideBits(s.sphere, 1); }},
    {"data-member", [](Scene& s) { dGeomSetData(s.sphere, nullptr); }},
    {"disable-member", [](Scene& s) { dGeomDisable(s.sphere); }},
    {"move-free", [](Scene& s) { dGeomSetPosition(s.box, 1, 0, 0); }},
    {"body-free", [](Scene& s) { dGeomSetBody(s.box, s.a); }},
    {"collide",
     [](Scene& s) {
         dContactGeom c;
         dCollide(s.sphere, s.plane, 1, &c, sizeof c);
     }},
    {"collide-again", [](Scene& s) { dSpaceCollide(s.space, nullptr, [](void*, dGeomID, dGeomID) {}); }},
    {"box-of-member",
     [](Scene& s) {
         dReal box[6];
         dGeomGetAABB(s.sphere, box);
     }},
};

// What the original takes or crashes on and we refuse; and a call without an answer that it dies of.
const Call kOurs[] = {
    {"low-level-nothing",
     [](Scene& s) {
         int size = 0;
         dGeomLowLevelControl(s.box, 1, 1, nullptr, &size);
     }},
    {"amotor-rel-beyond", [](Scene& s) { dJointSetAMotorAxis(s.amotor, 0, 3, 1, 0, 0); }},
    {"dot-null", [](Scene&) { dDot(nullptr, kX, 3); }},
    {"set-zero-null", [](Scene&) { dSetZero(nullptr, 3); }},
    {"transform-in-space", [](Scene& s) { dGeomTransformSetGeom(dCreateGeomTransform(nullptr), s.sphere); }},
    {"gravity-nan", [](Scene& s) { dWorldSetGravity(s.world, NAN, 0, 0); }},
    {"position-nan", [](Scene& s) { dBodySetPosition(s.a, 0, NAN, 0); }},
    {"position-infinite", [](Scene& s) { dBodySetPosition(s.a, dInfinity, 0, 0); }},
    {"velocity-nan", [](Scene& s) { dBodySetLinearVel(s.a, NAN, 0, 0); }},
    {"force-nan", [](Scene& s) { dBodyAddForce(s.a, 0, 0, NAN); }},
    {"anchor-nan", [](Scene& s) { dJointSetBallAnchor(s.ball, NAN, 0, 0); }},
    {"stop-nan", [](Scene& s) { dJointSetHingeParam(s.hinge, dParamLoStop, NAN); }},
    {"geom-position-nan", [](Scene& s) { dGeomSetPosition(s.box, NAN, 0, 0); }},
    {"radius-nan", [](Scene& s) { dGeomSphereSetRadius(s.sphere, NAN); }},
};

[[noreturn]] void be_the_process(void (*run)(Scene&), bool locked)
{
    static Scene scene;
    static void (*deed)(Scene&) = run;
    alarm(20);
    if (std::freopen("/dev/null", "w", stderr) == nullptr) { _exit(1); }
    dSetDebugHandler(&say_refused);
    if (!locked) {
        deed(scene);
        _exit(kTaken);
    }
    dSpaceCollide(scene.space, nullptr, [](void*, dGeomID, dGeomID) {
        deed(scene);
        _exit(kTaken);
    });
    _exit(1);  // no callback came
}

const char* in_own_process(void (*run)(Scene&), bool locked)
{
    std::fflush(stdout);
    const pid_t child = fork();
    if (child == 0) { be_the_process(run, locked); }
    int status = 0;
    waitpid(child, &status, 0);
    if (WIFSIGNALED(status)) { return "crashed"; }
    return WEXITSTATUS(status) == kRefused ? "refused" : WEXITSTATUS(status) == kTaken ? "taken" : "lost";
}

PARITY_CASE(refusals)
{
    for (const Call& call : kCalls) { out.put_text(call.name, in_own_process(call.run, false)); }
    for (const Call& call : kLockedCalls) {
        out.put_text(std::string("locked-") + call.name, in_own_process(call.run, true));
    }
    for (const Call& call : kOurs) {
        out.put_text(std::string("ours-") + call.name, in_own_process(call.run, false));
    }
}

}  // namespace
}  // namespace parity
