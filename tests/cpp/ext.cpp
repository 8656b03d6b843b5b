// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Every member of ode/odecpp_ext.h against the C call it stands for: setters by reading both objects, getters
// and queries by their result on one.
#include <ode/odecpp_ext.h>

#include "twins.h"

namespace {

Numbers read_world(dWorldID w)
{
    Numbers n;
    n.push_back(dWorldGetStepThreads(w));
    n.push_back(dWorldGetStepWarmStarting(w));
    n.push_back(dWorldGetFrictionCone(w));
    n.push_back(dWorldGetManifoldFriction(w));
    n.push_back(dWorldGetExactRotation(w));
    n.push_back(dWorldGetJointCoordinates(w));
    n.push_back(dWorldGetExactSubsteps(w));
    n.push_back(dWorldGetStepProjection(w));
    n.push_back(dWorldGetStepProjectionTolerance(w));
    n.push_back(dWorldGetHybridStepper(w));
    n.push_back(dWorldGetHybridSubsteps(w));
    n.push_back(dWorldGetHybridBudget(w));
    n.push_back(dWorldGetStepReportMode(w));
    n.push_back(dWorldGetEnergyLedgerMode(w));
    n.push_back(dWorldGetDiagnosisMode(w));
    n.push_back(dWorldGetContactSpace(w) != 0);
    n.push_back(dWorldGetBehaviour(w));
    return n;
}

#define WORLD_SET(Name, value)                                                                        \
    do {                                                                                              \
        SET("dWorldExt::set" #Name, read_world, a, b, a.set##Name(value), dWorldSet##Name(b, value)); \
        judge_get("dWorldExt::get" #Name, a.get##Name(), dWorldGet##Name(b));                         \
    } while (0)

void test_world_options()
{
    dWorldExt a, b;
    WORLD_SET(StepThreads, 2);
    WORLD_SET(StepWarmStarting, REAL(0.5));
    WORLD_SET(FrictionCone, 1);
    WORLD_SET(ManifoldFriction, 1);
    WORLD_SET(ExactRotation, 1);
    WORLD_SET(JointCoordinates, 1);
    WORLD_SET(ExactSubsteps, 3);
    WORLD_SET(StepProjection, 8);
    WORLD_SET(StepProjectionTolerance, REAL(0.01));
    WORLD_SET(HybridStepper, dStepperExact);
    WORLD_SET(HybridSubsteps, 7);
    WORLD_SET(HybridBudget, 3);
    WORLD_SET(StepReportMode, 1);
    WORLD_SET(EnergyLedgerMode, 1);
    WORLD_SET(DiagnosisMode, 1);
    WORLD_SET(Behaviour, dBehaviour016);
    judge(
        "dWorldExt::useDefaults",
        a.useDefaults(dDefaultsGame) == dWorldUseDefaults(b, dDefaultsGame) && read_world(a) == read_world(b),
        read_world(a));
}

int reject_all(void* data, dGeomID, dGeomID)
{
    ++*static_cast<int*>(data);
    return 0;
}

int keep_none(void*, dGeomID) { return 0; }

// A ball that lies on a plane, in a world that finds its contacts.
struct Ground {
    dWorldExt world;
    dSpaceExt<dHashSpace> space;
    dGeomExt<dPlane> plane;
    dGeomExt<dSphere> ball;
    dBodyExt body;

    Ground() : body(world)
    {
        space.setCleanup(0);
        plane.create(space, 0, 0, 1, 0);
        ball.create(space, 1);
        ball.setBody(body);
        body.setPosition(0, 0, REAL(0.9));
        world.setGravity(0, 0, -10);
    }
};

void pass_through(void*, dManifold* manifold) { manifold->accept = 0; }

void test_contacts()
{
    Ground ground;
    dWorldExt& world = ground.world;
    world.setContactSpace(ground.space);
    judge("dWorldExt::setContactSpace", dWorldGetContactSpace(world) == ground.space.id(), Numbers());
    judge("dWorldExt::getContactSpace", world.getContactSpace() == ground.space.id(), Numbers());
    dEventSettingsExt settings;
    settings.min_impulse = 0;
    judge("dWorldExt::setEventSettings", world.setEventSettings(&settings) == 1, Numbers());
    dEventSettings current = settings;
    judge("dWorldExt::getEventSettings", world.getEventSettings(&current) == 1, Numbers());
    world.setStepReportMode(1);
    world.setEnergyLedgerMode(1);
    judge("dWorldExt::stepHybrid", world.stepHybrid(REAL(0.01)) == 1,
          Numbers(1, ground.body.getPosition()[2]));
    dWorldContact points[4];
    dContactEvent events[4];
    judge("dWorldExt::getContacts", world.getContacts(points, 4) == 1 && points[0].g1 == ground.ball.geom(),
          Numbers(1, points[0].depth));
    judge("dWorldExt::getContactEvents",
          world.getContactEvents(events, 4) == 1 && events[0].kind == dContactBegin, Numbers());
    dEvent listed[4];
    judge("dWorldExt::getEvents", world.getEvents(listed, 4) == 1 && listed[0].kind == dEventContactBegin,
          Numbers(1, listed[0].impulse));
    judge("dWorldExt::getLostEvents", world.getLostEvents() == 0, Numbers());
    dWorldStepReportExt whole;
    dIslandStepReportExt one;
    judge("dWorldExt::getStepReport", world.getStepReport(&whole) == 1 && whole.islands == 1,
          Numbers(1, whole.bodies));
    judge("dWorldExt::getIslandStepReport", world.getIslandStepReport(0, &one) == 1 && one.bodies == 1,
          Numbers(1, one.rows));
    dEnergyLedgerExt account, part;
    judge("dWorldExt::getEnergyLedger", world.getEnergyLedger(&account) == 1 && account.islands == 1,
          Numbers(1, account.gravity));
    judge("dWorldExt::getIslandEnergyLedger",
          world.getIslandEnergyLedger(0, &part) == 1 && part.gravity == account.gravity, Numbers());
    int asked = 0;
    world.setContactSpace(0);
    world.setContactSpace(ground.space);
    world.setContactFilter(reject_all, &asked);
    world.stepHybrid(REAL(0.01));
    judge("dWorldExt::setContactFilter", asked == 1 && world.getContacts(points, 4) == 0, Numbers());
    world.setContactFilter(0, 0);
    world.setContactSpace(0);
    world.setContactSpace(ground.space);
    world.setManifoldFunction(pass_through, 0, 0);
    world.stepHybrid(REAL(0.01));
    judge("dWorldExt::setManifoldFunction", world.getContacts(points, 4) == 0, Numbers());
    world.setDiagnosisMode(1);
    ground.body.addForce(0, 0, REAL(1e12));
    world.stepHybrid(REAL(0.01));
    dDiagnosis cause;
    const int causes = world.diagnose(&cause, 1);
    judge("dWorldExt::diagnose", causes >= 1 && cause.kind == dDiagnosisInput,
          Numbers(1, dReal(cause.threshold)));
}

void test_copies()
{
    Ground ground;
    dWorldExt& world = ground.world;
    const int rows = world.countHandles(0);
    dHandlePair table[8];
    dSpaceID space = ground.space;
    const dWorldID clone = world.clone(&space, table, 8);
    judge("dWorldExt::countHandles", rows == dWorldCountHandles(world, 0), Numbers());
    judge("dWorldExt::clone", clone && table[0].copy == clone && table[0].original == world.id(), Numbers());
    const size_t size = world.saveToBuffer(ground.space, 0, 0);
    judge("dWorldExt::saveToBuffer", size == dWorldSaveToBuffer(world, ground.space, 0, 0), Numbers());
    const dVector3 offset = {REAL(2.0), 0, 0, 0};
    const dReal x = dBodyGetPosition(ground.body)[0];
    judge("dWorldExt::shiftOrigin",
          world.shiftOrigin(0, offset) == 1 && dBodyGetPosition(ground.body)[0] == x - 2, Numbers());
    judge("dWorldExt::save", world.save(ground.space, "/nowhere/at/all") == 0, Numbers());
    dWorldDestroy(clone);
    dSpaceDestroy(space);
}

void test_history()
{
    Ground ground;
    dWorldExt& world = ground.world;
    judge("dWorldExt::setHistory", world.setHistory(3) == 1, Numbers());
    judge("dWorldExt::getHistory", world.getHistory() == 3, Numbers());
    const dReal z = ground.body.getPosition()[2];
    world.step(REAL(0.01)), world.step(REAL(0.01));
    judge("dWorldExt::getHistoryFrames", world.getHistoryFrames() == 2, Numbers());
    judge("dWorldExt::getHistorySize", world.getHistorySize() == dWorldGetHistorySize(world), Numbers());
    judge("dWorldExt::rollBack", world.rollBack(2) == 1 && ground.body.getPosition()[2] == z, Numbers());
}

void test_characters()
{
    dWorldExt world;
    dHashSpace space(0);
    dPlane floor(space, 0, 0, 1, 0);
    dCharacter hero;
    hero.create(space);
    judge("dCharacter::create", dGeomIsCharacter(hero) == 1, Numbers());
    dCharacterSettings settings;
    dCharacterSettingsInit(&settings, sizeof settings);
    judge("dCharacter::getSettings", hero.getSettings(&settings) == 1 && settings.max_force == 500,
          Numbers());
    settings.max_force = 200;
    hero.setSettings(&settings);
    judge("dCharacter::setSettings", hero.getSettings(&settings) == 1 && settings.max_force == 200,
          Numbers());
    dVector3 feet, along = {1, 0, 0}, velocity;
    hero.setFeet(3, 0, REAL(0.1));
    judge("dCharacter::setFeet", dCharacterGetPosition(hero, feet) == 1 && feet[0] == 3, Numbers(1, feet[0]));
    judge("dCharacter::getFeet", hero.getFeet(feet) == 1 && feet[0] == 3, Numbers(1, feet[0]));
    hero.walk(along, 0, REAL(0.1));
    hero.getFeet(feet);
    judge("dCharacter::walk", feet[0] > 3, Numbers(1, feet[0]));
    const dReal before = feet[0];
    hero.move(along, REAL(0.1));
    hero.getFeet(feet);
    judge("dCharacter::move", feet[0] > before, Numbers(1, feet[0]));
    hero.setVelocity(along);
    judge("dCharacter::setVelocity", dCharacterGetVelocity(hero, velocity) == 1 && velocity[0] == 1,
          Numbers(1, velocity[0]));
    judge("dCharacter::getVelocity", hero.getVelocity(velocity) == 1 && velocity[0] == 1,
          Numbers(1, velocity[0]));
    judge("dCharacter::setHeight", hero.setHeight(1) == 1, Numbers());
    dCharacterReport report;
    report.struct_size = sizeof report;
    judge("dCharacter::getReport", hero.getReport(&report) == 1 && report.state != 0, Numbers());
}

dReal swell(void* data, const dVector3, dReal) { return *static_cast<const dReal*>(data); }

void stream(void* data, const dVector3, dReal, dVector3 velocity)
{
    velocity[0] = *static_cast<const dReal*>(data);
    velocity[1] = velocity[2] = 0;
}

void test_fluids()
{
    dWorldExt world;
    dHashSpace space(0);
    dFluid water(world);
    judge("dFluid::id", water.id() == dWorldGetFluid(world, 0), Numbers());
    judge("dFluid::getWorld", water.getWorld() == world.id(), Numbers());
    judge("dWorldExt::getNumFluids", world.getNumFluids() == 1, Numbers());
    judge("dWorldExt::getFluid", world.getFluid(0) == water.id(), Numbers());
    dFluidSettingsExt brine, read;
    brine.density = 1200;
    judge("dFluid::setSettings",
          water.setSettings(brine) == 1 && dFluidGetSettings(water, &read) == 1 && read.density == 1200,
          Numbers());
    judge("dFluid::getSettings", water.getSettings(read) == 1 && read.density == 1200, Numbers());
    dVector4 plane;
    water.setPlane(0, 0, 2, 1);
    dFluidGetPlane(water, plane);
    judge("dFluid::setPlane", plane[2] == 1 && plane[3] == REAL(0.5), Numbers(1, plane[3]));
    water.getPlane(plane);
    judge("dFluid::getPlane", plane[2] == 1 && plane[3] == REAL(0.5), Numbers(1, plane[3]));

    dBodyExt body(world);
    dBox box(space, 1, 1, 1);
    box.setBody(body);
    dReal volume, height = REAL(-0.5), speed = 3;
    dVector3 centre, force, torque;
    judge("dFluid::getSubmerged", water.getSubmerged(box, &volume, centre) == 1 && volume == 1,
          Numbers(1, volume));
    water.setSurface(swell, &height);
    judge(
        "dFluid::setSurface",
        water.getSubmergedBody(body, &volume, centre) == 1 && volume > REAL(0.4999) && volume < REAL(0.5001),
        Numbers(1, volume));
    judge("dFluid::getSubmergedBody", centre[2] > REAL(-0.2501) && centre[2] < REAL(-0.2499),
          Numbers(1, centre[2]));
    water.setCurrentFunction(stream, &speed);
    world.step(REAL(0.01));
    judge("dFluid::setCurrentFunction", body.getLinearVel()[0] > 0, Numbers(1, body.getLinearVel()[0]));
    judge("dBodyExt::getFluidForce", body.getFluidForce(force, torque) == 1 && force[0] > 0,
          Numbers(1, force[0]));
    judge("dFluid::getTime", water.getTime() == REAL(0.01), Numbers(1, water.getTime()));
    water.setTime(4);
    judge("dFluid::setTime", dFluidGetTime(water) == 4, Numbers());
    water.setVolume(box);
    judge("dFluid::setVolume", dFluidGetVolume(water) == box.id(), Numbers());
    judge("dFluid::getVolume", water.getVolume() == box.id(), Numbers());
}

void test_impulses()
{
    dWorldExt world;
    dSpaceExt<dHashSpace> space(0);
    dBodyExt body(world);  // of 1 kg
    dBox box(space, 1, 1, 1);
    box.setBody(body);
    const dVector3 J = {0, 0, 3}, L = {0, 2, 0}, still = {0, 0, 0}, below = {0, 0, -2};
    const dReal *v = body.getLinearVel(), *w = body.getAngularVel();
    body.disable();
    body.applyImpulse(J, 0);
    judge("dBodyExt::applyImpulse", v[2] == 3 && body.isEnabled(), Numbers(1, v[2]));
    body.applyAngularImpulse(L);
    judge("dBodyExt::applyAngularImpulse", w[1] == 2, Numbers(1, w[1]));
    body.disable();
    body.setVelocities(still, still, 0);
    judge("dBodyExt::setVelocities", v[2] == 0 && w[1] == 0 && !body.isEnabled(), Numbers(1, v[2]));
    body.applyForce(J, 0);
    judge("dBodyExt::applyForce", body.getForce()[2] == 3 && body.isEnabled(),
          Numbers(1, body.getForce()[2]));
    body.applyTorque(L);
    judge("dBodyExt::applyTorque", body.getTorque()[1] == 2, Numbers(1, body.getTorque()[1]));
    const int count = space.applyRadialImpulse(below, 4, 1, dFalloffNone, 1, 0);
    judge("dSpaceExt::applyRadialImpulse", count == 1 && v[2] == 1, Numbers(1, v[2]));
}

void test_vehicles()
{
    dWorldExt world;
    dHashSpace space(0);
    dPlane floor(space, 0, 0, 1, 0);
    dWorldSetContactSpace(world, space);
    world.setGravity(0, 0, REAL(-9.81));
    dVehicle car;
    judge("dVehicle::create", car.create(world) == 1 && dBodyIsVehicle(car) == 1, Numbers());
    judge("dBodyExt::isVehicle", car.isVehicle() == 1, Numbers());
    dVehicleSettingsExt settings;
    settings.gears = 3;
    car.setSettings(&settings);
    settings.gears = 5;
    judge("dVehicle::setSettings", dVehicleGetSettings(car, &settings) == 1 && settings.gears == 3,
          Numbers());
    judge("dVehicle::getSettings", car.getSettings(&settings) == 1 && settings.gears == 3, Numbers());
    dVehicleWheelExt wheel;
    judge("dVehicle::addWheel", car.addWheel(&wheel) == 1, Numbers());
    judge("dVehicle::getNumWheels", car.getNumWheels() == 1, Numbers());
    wheel.radius = REAL(0.5);
    car.setWheel(0, &wheel);
    wheel.radius = 1;
    judge("dVehicle::setWheel", dVehicleGetWheel(car, 0, &wheel) == 1 && wheel.radius == REAL(0.5),
          Numbers());
    judge("dVehicle::getWheel", car.getWheel(0, &wheel) == 1 && wheel.radius == REAL(0.5), Numbers());
    dVehicleControlsExt controls;
    controls.throttle = 1;
    car.setControls(&controls);
    controls.throttle = 0;
    judge("dVehicle::setControls", dVehicleGetControls(car, &controls) == 1 && controls.throttle == 1,
          Numbers());
    judge("dVehicle::getControls", car.getControls(&controls) == 1 && controls.throttle == 1, Numbers());
    car.setPosition(0, 0, REAL(0.4));
    judge("dVehicle::update", car.update(REAL(0.01)) == 1, Numbers());
    car.setGear(2);
    dVehicleReportExt report;
    judge("dVehicle::getReport", car.getReport(&report) == 1 && report.wheels_on_ground == 1, Numbers());
    judge("dVehicle::setGear", report.gear == 2, Numbers());
    dVehicleWheelReportExt at;
    judge("dVehicle::getWheelReport", car.getWheelReport(0, &at) == 1 && at.load > 0, Numbers());
}

void test_ragdolls()
{
    dWorldExt world;
    dBone bones[16];
    judge("dBonesMakeHuman", dBonesMakeHuman(bones, 16, REAL(1.8), 75) == 16, Numbers());
    dRagdoll figure;
    const dVector3 up = {0, 0, 5};
    judge("dRagdoll::create", figure.create(world, 0, bones, 16, up) == 16, Numbers());
    judge("dRagdoll::getNumBones", figure.getNumBones() == 16, Numbers());
    judge("dRagdoll::getBody", figure.getBody(15) != 0 && figure.getBody(16) == 0, Numbers());
    dQuaternion pose[16];
    judge("dRagdoll::getPose", figure.getPose(pose) == 16 && pose[5][0] == 1, Numbers());
    judge("dRagdoll::setPose", figure.setPose(pose) == 15, Numbers());
    const dVector3 to = {0, 0, 7};
    judge("dRagdoll::follow", figure.follow(to, pose, 1, 1) == 16, Numbers());
    judge("dRagdoll::getGap", figure.getGap() < REAL(1e-5), Numbers());
}

void test_fracture()
{
    dWorldExt world;
    dFracturePart parts[2];
    for (int i = 0; i < 2; ++i) {
        parts[i].geom = dCreateBox(0, 1, 1, 1), parts[i].density = 500;
        dGeomSetPosition(parts[i].geom, dReal(i), 0, 0);
    }
    const dBreakable pair(parts, 2, 100);
    const dBodyID body = pair.create(world);
    judge("dBreakable::create", body != 0 && dBodyGetPosition(body)[0] == REAL(0.5), Numbers());
    judge("dBreakable::update", pair.update(world) == 0, Numbers());
    judge("dBreakable::get", pair.get().count == 2 && pair.get().radius == dInfinity, Numbers());
    judge("dBreakable::breakBody", pair.breakBody(body) == 2, Numbers());
    for (int i = 0; i < 2; ++i) dGeomDestroy(parts[i].geom);
}

void test_joints()
{
    dWorldExt world;
    dBody body(world);
    dJointExt<dHingeJoint> joint;
    joint.create(world);
    joint.attach(body, 0);
    joint.setAxis(0, 0, 1);
    judge("dJointExt::getNumAxes", joint.getNumAxes() == 1, Numbers());
    dDriveExt motor, read;
    motor.force = 2;
    judge("dJointExt::setDrive", joint.setDrive(0, &motor) == 1, Numbers());
    judge("dJointExt::getDrive", joint.getDrive(0, &read) == 1 && read.force == 2, Numbers(1, read.force));
    joint.setAxisContinuous(0, 1);
    judge("dJointExt::setAxisContinuous", dJointGetAxisContinuous(joint, 0) == 1, Numbers());
    judge("dJointExt::getAxisContinuous", joint.getAxisContinuous(0) == 1, Numbers());
    joint.setAxisTurn(0, dReal(6.3));
    judge("dJointExt::setAxisTurn", joint.getAxisPosition(0) > 3, Numbers());
    joint.setAxisTurn(0, 0);
    dReal a, b;
    joint.setStopSpring(0, 30, 4);
    judge("dJointExt::setStopSpring", dJointGetStopSpring(joint, 0, &a, &b) == 1 && a == 30, Numbers(1, a));
    judge("dJointExt::getStopSpring", joint.getStopSpring(0, &a, &b) == 1 && b == 4, Numbers(1, b));
    joint.setStopRate(0, 20);
    judge("dJointExt::setStopRate", dJointGetStopRate(joint, 0) == 20, Numbers());
    judge("dJointExt::getStopRate", joint.getStopRate(0) == 20, Numbers());
    judge("dJointExt::getStopForce", joint.getStopForce(0) == dJointGetStopForce(joint, 0), Numbers());
    joint.setBreakLimits(1, 0);
    judge("dJointExt::setBreakLimits", dJointGetBreakLimits(joint, &a, &b) == 1 && a == 1, Numbers(1, a));
    judge("dJointExt::getBreakLimits", joint.getBreakLimits(&a, &b) == 1 && a == 1, Numbers(1, a));
    body.addForce(5, 0, 0);
    world.step(REAL(0.01));
    judge("dJointExt::getAxisPosition", joint.getAxisPosition(0) == dJointGetAxisPosition(joint, 0),
          Numbers());
    judge("dJointExt::getAxisRate", joint.getAxisRate(0) == dJointGetAxisRate(joint, 0), Numbers());
    judge("dJointExt::getDriveForce", joint.getDriveForce(0) == dJointGetDriveForce(joint, 0), Numbers());
    judge("dJointExt::isBroken", joint.isBroken() == 1, Numbers());
    dJointID broken = 0;
    judge("dWorldExt::getBrokenJoints", world.getBrokenJoints(&broken, 1) == 1 && broken == joint.id(),
          Numbers());
    dJointExt<dBallJoint> ball;
    ball.create(world);
    ball.setSpring(30, 4);
    judge("dJointExt::setSpring", dJointGetSpring(ball, &a, &b) == 1 && a == 30, Numbers(1, a));
    judge("dJointExt::getSpring", ball.getSpring(&a, &b) == 1 && b == 4, Numbers(1, b));
}

void test_coupling()
{
    dWorld world;
    dBody left(world), right(world);
    dHingeJoint first(world), second(world);
    first.attach(left, 0), second.attach(right, 0);
    dCouplingJoint gear(world);
    judge("dCouplingJoint::setAxis", gear.setAxis(0, first, 0, 1) == 1 && gear.setAxis(1, second, 0, -2) == 1,
          Numbers());
    judge("dCouplingJoint::id", dJointGetType(gear.id()) == dJointTypeCoupling, Numbers());
    judge("dCouplingJoint::getJoint", gear.getJoint(1) == second.id() && gear.getJoint(2) == 0, Numbers());
    judge("dCouplingJoint::getAxis", gear.getAxis(1) == 0, Numbers());
    judge("dCouplingJoint::getFactor", gear.getFactor(1) == -2, Numbers(1, gear.getFactor(1)));
    gear.setParam(dParamHiStop, dReal(0.5));
    judge("dCouplingJoint::setParam", dJointGetCouplingParam(gear, dParamHiStop) == dReal(0.5), Numbers());
    judge("dCouplingJoint::getParam", gear.getParam(dParamHiStop) == dReal(0.5), Numbers());
    gear.setParam(dParamHiStop, 0);
    left.addTorque(1, 0, 0);
    world.step(dReal(0.01));
    judge("dCouplingJoint::getForce", gear.getForce() == dJointGetCouplingForce(gear) && gear.getForce() != 0,
          Numbers(1, gear.getForce()));
}

void test_body_and_geoms()
{
    Ground ground;
    ground.body.setHybridStepper(dStepperExact);
    judge("dBodyExt::setHybridStepper", dBodyGetHybridStepper(ground.body) == dStepperExact, Numbers());
    judge("dBodyExt::getHybridStepper", ground.body.getHybridStepper() == dStepperExact, Numbers());
    judge("dGeomExt::isCharacter", ground.ball.isCharacter() == 0, Numbers());
    judge("dGeomExt::geom", ground.ball.geom() == ground.ball.id(), Numbers());
    dMaterialExt ice, read;
    ice.friction = REAL(0.02);
    judge("dGeomExt::setMaterial", ground.ball.setMaterial(ice) == 1, Numbers());
    judge("dGeomExt::getMaterial", ground.ball.getMaterial(&read) == 1 && read.friction == ice.friction,
          Numbers(1, read.bounce_speed));
    ground.ball.setSensor(1);
    judge("dGeomExt::setSensor", dGeomGetSensor(ground.ball) == 1, Numbers());
    judge("dGeomExt::getSensor", ground.ball.getSensor() == 1, Numbers());
    ground.ball.setSensor(0);
    ground.ball.setContinuous(dContinuousOn);
    judge("dGeomExt::setContinuous", dGeomGetContinuous(ground.ball) == dContinuousOn, Numbers());
    judge("dGeomExt::getContinuous", ground.ball.getContinuous() == dContinuousOn, Numbers());
    dQueryDistance d, plain;
    const int near = ground.ball.getDistance(ground.plane, dInfinity, &d);
    judge("dGeomExt::getDistance",
          near == dGeomGetDistance(ground.ball, ground.plane, dInfinity, &plain) &&
              d.distance == plain.distance,
          Numbers(1, d.distance));
    ground.ball.setPosition(0, 0, 5);
    const dVector3 down = {0, 0, -10, 0};
    dQueryHit hit, same;
    const int met = ground.ball.cast(down, ground.plane, &hit);
    judge("dGeomExt::cast",
          met == 1 && dGeomCast(ground.ball, down, ground.plane, &same) == 1 && hit.distance == same.distance,
          Numbers(1, hit.distance));
}

void test_queries()
{
    Ground ground;
    const dReal from[3] = {REAL(0.2), 0, 5}, down[3] = {0, 0, -1}, length = 10;
    const dVector3 way = {0, 0, -10, 0};
    dQueryHit a[4], b[4];
    dQueryFilterExt no_ball, nothing;
    no_ball.skip_body = ground.body;
    nothing.callback = keep_none;
    judge("dSpaceExt::rayClosest",
          ground.space.rayClosest(from, down, length, &no_ball, a) == 1 && a[0].geom == ground.plane.geom() &&
              ground.space.rayClosest(from, down, length, 0, b) == 1 && b[0].geom == ground.ball.geom() &&
              ground.space.rayClosest(from, down, length, &nothing, b) == 0,
          Numbers(1, a[0].distance));
    judge("dSpaceExt::rayAll", ground.space.rayAll(from, down, length, 0, a, 4) == 2,
          Numbers(1, a[1].distance));
    judge("dSpaceExt::rayBatch",
          ground.space.rayBatch(1, from, down, &length, &no_ball, b, 1) == 1 &&
              b[0].geom == ground.plane.geom(),
          Numbers(1, b[0].distance));
    dGeomExt<dBox> probe;
    probe.create(0, 1, 1, 1);
    dGeomID met[4];
    judge("dSpaceExt::overlap",
          ground.space.overlap(probe, &no_ball, met, 4) == 1 && met[0] == ground.plane.geom(), Numbers());
    probe.setPosition(0, 0, 5);
    judge("dSpaceExt::cast",
          ground.space.cast(probe, way, &no_ball, a) == 1 && a[0].geom == ground.plane.geom(),
          Numbers(1, a[0].distance));
    dCastHit all[4];
    judge("dSpaceExt::castAll",
          ground.space.castAll(probe, way, 0, all, 4) == 2 && all[0].geom == ground.ball.geom() &&
              all[1].geom == ground.plane.geom(),
          Numbers(1, all[1].distance));
}

void test_hull()
{
    const dReal points[] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1};
    dConvexHull hull(0, points, 4, 0);
    judge("dConvexHull::create", hull.getClass() == dConvexClass, Numbers());
    dReal corners[15], planes[24];
    unsigned polygons[64];
    judge("dConvexHull::getPoints", hull.getPoints(corners, 5) == 4, Numbers(1, corners[3]));
    judge("dConvexHull::getPlanes", hull.getPlanes(planes, 6) == 4, Numbers(1, planes[3]));
    judge("dConvexHull::getPolygons", hull.getPolygons(polygons, 64) == 16, Numbers(1, polygons[0]));
    dMassExt mass, plain;
    mass.setConvex(6, hull);
    dMassSetConvex(&plain, 6, hull);
    judge("dMassExt::setConvex", mass.mass == plain.mass, Numbers(1, mass.mass));
    mass.setConvexTotal(3, hull);
    judge("dMassExt::setConvexTotal", mass.mass == 3, Numbers(1, mass.mass));
    hull.set(points, 5, 0);
    judge("dConvexHull::set", dGeomConvexGetPoints(hull, 0, 0) == 5, Numbers());
}

void test_surfaces()
{
    static const dReal corners[] = {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
    static const dTriIndex triangles[] = {0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3};
    const dTriMeshDataID data = dGeomTriMeshDataCreate();
    dGeomTriMeshDataBuildSimple(data, corners, 4, triangles, 12);
    {
        dTriMeshExt mesh(0, data);
        judge("dTriMeshExt::create", mesh.getClass() == dTriMeshClass, Numbers());
        mesh.setSolid(1);
        judge("dTriMeshExt::setSolid", dGeomTriMeshGetSolid(mesh) == 1, Numbers());
        judge("dTriMeshExt::getSolid", mesh.getSolid() == 1, Numbers());
        dGeomExt<dTriMeshExt> faces;
        faces.create(0, data);
        dMaterialExt ice, read;
        ice.friction = REAL(0.02);
        const unsigned char numbers[4] = {0, 7, 7, 0};
        unsigned char got[4] = {0, 0, 0, 0};
        judge("dGeomExt::setFaceMaterial", faces.setFaceMaterial(7, &ice) == 1, Numbers());
        judge("dGeomExt::getFaceMaterial",
              faces.getFaceMaterial(7, &read) == 1 && read.friction == ice.friction, Numbers());
        judge("dGeomExt::setFaceMaterialNumbers", faces.setFaceMaterialNumbers(numbers, 4) == 1, Numbers());
        judge("dGeomExt::getFaceMaterialNumbers",
              faces.getFaceMaterialNumbers(got, 4) == 4 && got[1] == 7 && got[3] == 0, Numbers());
    }
    dGeomTriMeshDataDestroy(data);

    const double heights[9] = {0, 0, 0, 0, 0, 0, 0, 0, 0};
    const unsigned char gone[4] = {0, 1, 0, 0};
    const dHeightfieldDataID field = dGeomHeightfieldDataCreate();
    dGeomHeightfieldDataBuildDouble(field, heights, 1, 2, 2, 3, 3, 1, 0, 1, 0);
    dHeightfieldHoles holes(field);
    holes.setHoles(gone, 2, 2);
    judge("dHeightfieldHoles::setHoles", dGeomHeightfieldDataGetHole(field, 1, 0) == 1, Numbers());
    judge("dHeightfieldHoles::getHole", holes.getHole(1, 0) == 1 && holes.getHole(0, 0) == 0, Numbers());
    holes.setHole(1, 0, 0);
    judge("dHeightfieldHoles::setHole", dGeomHeightfieldDataGetHole(field, 1, 0) == 0, Numbers());
    dGeomHeightfieldDataDestroy(field);
}

}  // namespace

int main()
{
    dInitODE();
    test_world_options();
    test_contacts();
    test_copies();
    test_history();
    test_characters();
    test_fluids();
    test_impulses();
    test_vehicles();
    test_ragdolls();
    test_fracture();
    test_joints();
    test_coupling();
    test_body_and_geoms();
    test_queries();
    test_hull();
    test_surfaces();
    dCloseODE();
    std::fprintf(stderr, "%d checks of the additions, %d failed\n", g_checks, g_failures);
    return g_failures != 0;
}
