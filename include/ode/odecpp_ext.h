/* SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026 The Epode authors
 *
 * The C++ classes with what this library adds to ODE's interface. A program includes this file, which
 * includes ode/ode.h and ode/ext.h; the classes of ode/odecpp.h are as they were.
 *
 * d<Name>Ext is the class or structure d<Name> with its additions: dWorldExt, dBodyExt, dMassExt; dGeomExt,
 * dSpaceExt and dJointExt take the class that they extend, dGeomExt<dSphere>, dSpaceExt<dHashSpace> or
 * dJointExt<dHingeJoint>. Structures that begin with struct_size have it, and their defaults, from the
 * beginning. As in ode/odecpp.h each member calls the C function of its name, which tells units, defaults and
 * refusals, wrappers own their object, and there is no library code behind them. They compile from C++98 on. It is
 * long, because the classes extend one another in its order and programs include one file. */
#ifndef _ODE_ODECPP_EXT_H_
#define _ODE_ODECPP_EXT_H_

#include <ode/ext.h>
#include <ode/ode.h>

#ifdef __cplusplus

/** A material with all defaults: dMaterialInit. */
struct dMaterialExt : public dMaterial {
    dMaterialExt() { dMaterialInit(this, sizeof(dMaterial)); }
};

/** A filter that finds everything: dQueryFilterInit. */
struct dQueryFilterExt : public dQueryFilter {
    dQueryFilterExt() { dQueryFilterInit(this, sizeof(dQueryFilter)); }
};

/** A drive that does nothing yet: dDriveInit. */
struct dDriveExt : public dDrive {
    dDriveExt() { dDriveInit(this, sizeof(dDrive)); }
};

/** Event settings with all defaults: dEventSettingsInit. */
struct dEventSettingsExt : public dEventSettings {
    dEventSettingsExt() { dEventSettingsInit(this, sizeof(dEventSettings)); }
};

/** Settings of a character with all defaults: dCharacterSettingsInit. */
struct dCharacterSettingsExt : public dCharacterSettings {
    dCharacterSettingsExt() { dCharacterSettingsInit(this, sizeof(dCharacterSettings)); }
};
/** A character's report that knows its size; all else is 0 at first. */
struct dCharacterReportExt : public dCharacterReport {
    dCharacterReportExt() : dCharacterReport() { struct_size = sizeof(dCharacterReport); }
};

/** Fluid settings with all defaults: dFluidSettingsInit. */
struct dFluidSettingsExt : public dFluidSettings {
    dFluidSettingsExt() { dFluidSettingsInit(this, sizeof(dFluidSettings)); }
};
/** Settings of a vehicle with all defaults: dVehicleSettingsInit. */
struct dVehicleSettingsExt : public dVehicleSettings {
    dVehicleSettingsExt() { dVehicleSettingsInit(this, sizeof(dVehicleSettings)); }
};
/** A wheel of a vehicle with all defaults: dVehicleWheelInit. */
struct dVehicleWheelExt : public dVehicleWheel {
    dVehicleWheelExt() { dVehicleWheelInit(this, sizeof(dVehicleWheel)); }
};
/** Settings of a rope with all defaults: dRopeSettingsInit. */
struct dRopeSettingsExt : public dRopeSettings {
    dRopeSettingsExt() { dRopeSettingsInit(this, sizeof(dRopeSettings)); }
};
/** Controls that do nothing, and know their size. */
struct dVehicleControlsExt : public dVehicleControls {
    dVehicleControlsExt() : dVehicleControls() { struct_size = sizeof(dVehicleControls); }
};
/** A vehicle's report that knows its size; all else is 0 at first. */
struct dVehicleReportExt : public dVehicleReport {
    dVehicleReportExt() : dVehicleReport() { struct_size = sizeof(dVehicleReport); }
};
/** The same of one wheel. */
struct dVehicleWheelReportExt : public dVehicleWheelReport {
    dVehicleWheelReportExt() : dVehicleWheelReport() { struct_size = sizeof(dVehicleWheelReport); }
};

/** A report that knows its size; all else is 0 at first. */
struct dWorldStepReportExt : public dWorldStepReport {
    dWorldStepReportExt() : dWorldStepReport() { struct_size = sizeof(dWorldStepReport); }
};
/** The same of one island. */
struct dIslandStepReportExt : public dIslandStepReport {
    dIslandStepReportExt() : dIslandStepReport() { struct_size = sizeof(dIslandStepReport); }
};

/** An energy ledger that knows its size; all else is 0 at first. */
struct dEnergyLedgerExt : public dEnergyLedger {
    dEnergyLedgerExt() : dEnergyLedger() { struct_size = sizeof(dEnergyLedger); }
};

/** A world with the additions of ode/step_options.h, ode/report.h, ode/contacts.h, ode/defaults.h,
    ode/diagnosis.h, ode/steppers.h, ode/state.h and ode/world_file.h. */
class dWorldExt : public dWorld {
  public:
    /** dWorldGetNumFluids, dWorldGetFluid. */
    int getNumFluids() const { return dWorldGetNumFluids(get_id()); }
    dFluidID getFluid(int index) const { return dWorldGetFluid(get_id(), index); }

    /** All parameters in one call: dWorldUseDefaults. */
    int useDefaults(int preset) { return dWorldUseDefaults(get_id(), preset); }

    /** Whose results steps have: dWorldSetBehaviour. */
    void setBehaviour(int version) { dWorldSetBehaviour(get_id(), version); }
    int getBehaviour() const { return dWorldGetBehaviour(get_id()); }

    /** dWorldSetStepThreads, dWorldSetStepWarmStarting. */
    void setStepThreads(int threads) { dWorldSetStepThreads(get_id(), threads); }
    int getStepThreads() const { return dWorldGetStepThreads(get_id()); }
    void setStepWarmStarting(dReal factor) { dWorldSetStepWarmStarting(get_id(), factor); }
    dReal getStepWarmStarting() const { return dWorldGetStepWarmStarting(get_id()); }

    /** Friction of contacts: dWorldSetFrictionCone, dWorldSetManifoldFriction. */
    void setFrictionCone(int mode) { dWorldSetFrictionCone(get_id(), mode); }
    int getFrictionCone() const { return dWorldGetFrictionCone(get_id()); }
    void setManifoldFriction(int mode) { dWorldSetManifoldFriction(get_id(), mode); }
    int getManifoldFriction() const { return dWorldGetManifoldFriction(get_id()); }

    /** Joints that broke in the last step: dWorldGetBrokenJoints. */
    int getBrokenJoints(dJointID* joints, int capacity) const
    {
        return dWorldGetBrokenJoints(get_id(), joints, capacity);
    }

    /** More accurate steps: dWorldSetExactRotation, dWorldSetExactSubsteps, dWorldSetStepProjection,
        dWorldSetStepProjectionTolerance. */
    void setJointCoordinates(int mode) { dWorldSetJointCoordinates(get_id(), mode); }
    int getJointCoordinates() const { return dWorldGetJointCoordinates(get_id()); }
    void setExactRotation(int mode) { dWorldSetExactRotation(get_id(), mode); }
    int getExactRotation() const { return dWorldGetExactRotation(get_id()); }
    void setExactSubsteps(int count) { dWorldSetExactSubsteps(get_id(), count); }
    int getExactSubsteps() const { return dWorldGetExactSubsteps(get_id()); }
    void setStepProjection(int iterations) { dWorldSetStepProjection(get_id(), iterations); }
    int getStepProjection() const { return dWorldGetStepProjection(get_id()); }
    void setStepProjectionTolerance(dReal tolerance)
    {
        dWorldSetStepProjectionTolerance(get_id(), tolerance);
    }
    dReal getStepProjectionTolerance() const { return dWorldGetStepProjectionTolerance(get_id()); }

    /** Hybrid steps: dWorldStepHybrid, dWorldSetHybridStepper, dWorldSetHybridSubsteps, dWorldSetHybridBudget. */
    int stepHybrid(dReal stepsize) { return dWorldStepHybrid(get_id(), stepsize); }
    void setHybridStepper(int stepper) { dWorldSetHybridStepper(get_id(), stepper); }
    int getHybridStepper() const { return dWorldGetHybridStepper(get_id()); }
    void setHybridSubsteps(int count) { dWorldSetHybridSubsteps(get_id(), count); }
    int getHybridSubsteps() const { return dWorldGetHybridSubsteps(get_id()); }
    void setHybridBudget(dReal times) { dWorldSetHybridBudget(get_id(), times); }
    dReal getHybridBudget() const { return dWorldGetHybridBudget(get_id()); }

    /** What a step did: dWorldSetStepReportMode, dWorldGetStepReport, dWorldGetIslandStepReport. */
    void setStepReportMode(int mode) { dWorldSetStepReportMode(get_id(), mode); }
    int getStepReportMode() const { return dWorldGetStepReportMode(get_id()); }
    int getStepReport(dWorldStepReport* report) const { return dWorldGetStepReport(get_id(), report); }
    int getIslandStepReport(int island, dIslandStepReport* report) const
    {
        return dWorldGetIslandStepReport(get_id(), island, report);
    }

    /** Where the energy of a step goes: dWorldSetEnergyLedgerMode, dWorldGetEnergyLedger,
        dWorldGetIslandEnergyLedger. */
    int setEnergyLedgerMode(int mode) { return dWorldSetEnergyLedgerMode(get_id(), mode); }
    int getEnergyLedgerMode() const { return dWorldGetEnergyLedgerMode(get_id()); }
    int getEnergyLedger(dEnergyLedger* ledger) const { return dWorldGetEnergyLedger(get_id(), ledger); }
    int getIslandEnergyLedger(int island, dEnergyLedger* ledger) const
    {
        return dWorldGetIslandEnergyLedger(get_id(), island, ledger);
    }

    /** What goes wrong, and why: dWorldSetDiagnosisMode, dWorldDiagnose. */
    void setDiagnosisMode(int mode) { dWorldSetDiagnosisMode(get_id(), mode); }
    int getDiagnosisMode() const { return dWorldGetDiagnosisMode(get_id()); }
    int diagnose(dDiagnosis* causes, int capacity) const
    {
        return dWorldDiagnose(get_id(), causes, capacity);
    }

    /** Copies: dWorldClone, dWorldCountHandles, dWorldSave, dWorldSaveToBuffer. */
    dWorldID clone(dSpaceID* space, dHandlePair* table, int capacity) const
    {
        return dWorldClone(get_id(), space, table, capacity);
    }
    int countHandles(dSpaceID space) const { return dWorldCountHandles(get_id(), space); }
    /** dWorldShiftOrigin. */
    int shiftOrigin(dSpaceID space, const dVector3 offset)
    {
        return dWorldShiftOrigin(get_id(), space, offset);
    }
    int save(dSpaceID space, const char* path) const { return dWorldSave(get_id(), space, path); }
    size_t saveToBuffer(dSpaceID space, void* buffer, size_t capacity) const
    {
        return dWorldSaveToBuffer(get_id(), space, buffer, capacity);
    }

    /** World-managed contacts: dWorldSetContactSpace, dWorldSetContactFilter, dWorldGetContactEvents,
        dWorldGetContacts. */
    void setContactSpace(dSpaceID space) { dWorldSetContactSpace(get_id(), space); }
    dSpaceID getContactSpace() const { return dWorldGetContactSpace(get_id()); }
    void setContactFilter(dContactFilter* filter, void* data)
    {
        dWorldSetContactFilter(get_id(), filter, data);
    }
    /** dWorldSetManifoldFunction. */
    void setManifoldFunction(dManifoldFunction* function, void* data, int threads)
    {
        dWorldSetManifoldFunction(get_id(), function, data, threads);
    }
    int getContactEvents(dContactEvent* events, int capacity) const
    {
        return dWorldGetContactEvents(get_id(), events, capacity);
    }
    int getContacts(dWorldContact* contacts, int capacity) const
    {
        return dWorldGetContacts(get_id(), contacts, capacity);
    }

    /** What happened in the last step: dWorldSetEventSettings, dWorldGetEvents, dWorldGetLostEvents. */
    int setEventSettings(const dEventSettings* settings)
    {
        return dWorldSetEventSettings(get_id(), settings);
    }
    int getEventSettings(dEventSettings* settings) const
    {
        return dWorldGetEventSettings(get_id(), settings);
    }
    int getEvents(dEvent* events, int capacity) const { return dWorldGetEvents(get_id(), events, capacity); }
    int getLostEvents() const { return dWorldGetLostEvents(get_id()); }

    /** Steps that can be taken back: dWorldSetHistory, dWorldRollBack, dWorldGetHistoryFrames,
        dWorldGetHistorySize. */
    int setHistory(int frames) { return dWorldSetHistory(get_id(), frames); }
    int getHistory() const { return dWorldGetHistory(get_id()); }
    int rollBack(int frames) { return dWorldRollBack(get_id(), frames); }
    int getHistoryFrames() const { return dWorldGetHistoryFrames(get_id()); }
    size_t getHistorySize() const { return dWorldGetHistorySize(get_id()); }
};

/** A body with the additions of ode/steppers.h. */
class dBodyExt : public dBody {
  public:
    /** dBodyGetFluidForce. */
    int getFluidForce(dVector3 force, dVector3 torque) const
    {
        return dBodyGetFluidForce(get_id(), force, torque);
    }

    /** dBodyApplyImpulse, dBodyApplyAngularImpulse, dBodyApplyForce, dBodyApplyTorque, dBodySetVelocities. */
    void applyImpulse(const dVector3 impulse, const dVector3 pos)
    {
        dBodyApplyImpulse(get_id(), impulse, pos);
    }
    void applyAngularImpulse(const dVector3 impulse) { dBodyApplyAngularImpulse(get_id(), impulse); }
    void applyForce(const dVector3 force, const dVector3 pos) { dBodyApplyForce(get_id(), force, pos); }
    void applyTorque(const dVector3 torque) { dBodyApplyTorque(get_id(), torque); }
    void setVelocities(const dVector3 linear, const dVector3 angular, int wake)
    {
        dBodySetVelocities(get_id(), linear, angular, wake);
    }

    /** Without a world there is no body yet. */
    dBodyExt() {}
    dBodyExt(dWorldID world) : dBody(world) {}
    dBodyExt(dWorld& world) : dBody(world) {}

    /** dBodySetHybridStepper, dBodyGetHybridStepper. */
    void setHybridStepper(int stepper) { dBodySetHybridStepper(get_id(), stepper); }
    int getHybridStepper() const { return dBodyGetHybridStepper(get_id()); }

    /** dBodyIsVehicle. */
    int isVehicle() const { return dBodyIsVehicle(get_id()); }
};

/** A body on wheels: dVehicleCreate. */
class dVehicle : public dBodyExt {
  public:
    /** Without a world there is no vehicle yet; else it is made at once; settings 0: the defaults. */
    dVehicle() {}
    explicit dVehicle(dWorldID world, const dVehicleSettings* settings = 0) { create(world, settings); }

    /** Make a new body, a vehicle without wheels; the one before is destroyed. Returns 1. */
    int create(dWorldID world, const dVehicleSettings* settings = 0)
    {
        dBody::create(world);
        return dVehicleCreate(get_id(), settings);
    }

    /** dVehicleSetSettings, dVehicleGetSettings. */
    int setSettings(const dVehicleSettings* settings) { return dVehicleSetSettings(get_id(), settings); }
    int getSettings(dVehicleSettings* settings) const { return dVehicleGetSettings(get_id(), settings); }

    /** dVehicleAddWheel, dVehicleGetNumWheels, dVehicleSetWheel, dVehicleGetWheel. */
    int addWheel(const dVehicleWheel* wheel = 0) { return dVehicleAddWheel(get_id(), wheel); }
    int getNumWheels() const { return dVehicleGetNumWheels(get_id()); }
    int setWheel(int wheel, const dVehicleWheel* as) { return dVehicleSetWheel(get_id(), wheel, as); }
    int getWheel(int wheel, dVehicleWheel* out) const { return dVehicleGetWheel(get_id(), wheel, out); }

    /** dVehicleSetControls, dVehicleGetControls, dVehicleSetGear, dVehicleUpdate. */
    int setControls(const dVehicleControls* controls) { return dVehicleSetControls(get_id(), controls); }
    int getControls(dVehicleControls* controls) const { return dVehicleGetControls(get_id(), controls); }
    int setGear(int gear) { return dVehicleSetGear(get_id(), gear); }
    int update(dReal h) { return dVehicleUpdate(get_id(), h); }

    /** dVehicleGetReport, dVehicleGetWheelReport. */
    int getReport(dVehicleReport* report) const { return dVehicleGetReport(get_id(), report); }
    int getWheelReport(int wheel, dVehicleWheelReport* report) const
    {
        return dVehicleGetWheelReport(get_id(), wheel, report);
    }
};

/** A figure of bones: dRagdollCreate. Its bodies are the world's: they live on when this ends. */
class dRagdoll {
  public:
    /** Without bones there is no figure yet; the list, of count bones, must live as long as this. */
    dRagdoll() : _bones(0), _count(0) {}

    /** Build a figure, as dRagdollCreate does. Returns how many bones it has, or 0: what there was stays. */
    int create(dWorldID world, dSpaceID space, const dBone* bones, int count, const dVector3 position = 0,
               const dQuaternion orientation = 0)
    {
        const int made = dRagdollCreate(world, space, bones, count, position, orientation, _bodies);
        if (made) _bones = bones, _count = made;
        return made;
    }

    /** How many bones it has; the body of one, 0 where there is none. */
    int getNumBones() const { return _count; }
    dBodyID getBody(int i) const { return i >= 0 && i < _count ? _bodies[i] : 0; }

    /** dRagdollSetPose, dRagdollGetPose, dRagdollFollow, dRagdollGetGap. */
    int setPose(const dQuaternion* pose, dReal strength = 1)
    {
        return dRagdollSetPose(_bones, _bodies, _count, pose, strength);
    }
    int getPose(dQuaternion* pose) const { return dRagdollGetPose(_bones, _bodies, _count, pose); }
    int follow(const dVector3 position, const dQuaternion* pose, dReal weight, dReal h)
    {
        return dRagdollFollow(_bones, _bodies, _count, position, pose, weight, h);
    }
    dReal getGap() const { return dRagdollGetGap(_bones, _bodies, _count); }

  private:
    const dBone* _bones;
    int _count;
    dBodyID _bodies[dRagdollMaxBones];
};

/** What a body is made of, and how it breaks (ode/fracture.h). */
class dBreakable {
  public:
    /** The list, of count parts, must live as long as this; strength in N s, radius in m. */
    dBreakable(const dFracturePart* parts, int count, dReal strength, dReal radius = dInfinity)
    {
        _fracture.parts = parts, _fracture.count = count;
        _fracture.strength = strength, _fracture.radius = radius;
    }

    /** dFractureCreate, dFractureBreak, dFractureUpdate of this one. */
    dBodyID create(dWorldID world) const { return dFractureCreate(world, _fracture.parts, _fracture.count); }
    int breakBody(dBodyID body, const dVector3 center = 0, dReal radius = 0) const
    {
        return dFractureBreak(_fracture.parts, _fracture.count, body, center, radius);
    }
    int update(dWorldID world) const { return dFractureUpdate(world, &_fracture, 1); }
    /** For dFractureUpdate of many. */
    const dFracture& get() const { return _fracture; }

  private:
    dFracture _fracture;
};

/** A joint of class Type, one of ode/odecpp_joints.h, with the additions of ode/drives.h. It is made by
    create() of that class. */
template <class Type>
class dJointExt : public Type {
  public:
    /** Coordinates: dJointGetAxisPosition, dJointGetAxisRate, dJointSetAxisContinuous, dJointSetAxisTurn. */
    int getNumAxes() const { return dJointGetNumAxes(this->id()); }
    dReal getAxisPosition(int axis) const { return dJointGetAxisPosition(this->id(), axis); }
    dReal getAxisRate(int axis) const { return dJointGetAxisRate(this->id(), axis); }
    int setAxisContinuous(int axis, int mode) { return dJointSetAxisContinuous(this->id(), axis, mode); }
    int getAxisContinuous(int axis) const { return dJointGetAxisContinuous(this->id(), axis); }
    int setAxisTurn(int axis, dReal position) { return dJointSetAxisTurn(this->id(), axis, position); }

    /** dJointSetDrive; drive 0 takes the drive away. */
    int setDrive(int axis, const dDrive* drive) { return dJointSetDrive(this->id(), axis, drive); }
    int getDrive(int axis, dDrive* drive) const { return dJointGetDrive(this->id(), axis, drive); }
    dReal getDriveForce(int axis) const { return dJointGetDriveForce(this->id(), axis); }

    /** Springs in physical units: dJointSetStopSpring, dJointSetSpring. */
    int setStopSpring(int axis, dReal stiffness, dReal damping)
    {
        return dJointSetStopSpring(this->id(), axis, stiffness, damping);
    }
    int setStopRate(int axis, dReal rate) { return dJointSetStopRate(this->id(), axis, rate); }
    dReal getStopRate(int axis) const { return dJointGetStopRate(this->id(), axis); }
    dReal getStopForce(int axis) const { return dJointGetStopForce(this->id(), axis); }
    int getStopSpring(int axis, dReal* stiffness, dReal* damping) const
    {
        return dJointGetStopSpring(this->id(), axis, stiffness, damping);
    }
    int setSpring(dReal stiffness, dReal damping) { return dJointSetSpring(this->id(), stiffness, damping); }
    int getSpring(dReal* stiffness, dReal* damping) const
    {
        return dJointGetSpring(this->id(), stiffness, damping);
    }

    /** dJointSetBreakLimits, dJointIsBroken. */
    int setBreakLimits(dReal force, dReal torque) { return dJointSetBreakLimits(this->id(), force, torque); }
    int getBreakLimits(dReal* force, dReal* torque) const
    {
        return dJointGetBreakLimits(this->id(), force, torque);
    }
    int isBroken() const { return dJointIsBroken(this->id()); }
};

/** A relation between joints (ode/couplings.h), made by its constructor, in the group or (0) alone, and
    destroyed with the object. */
class dCouplingJoint {
  public:
    /** dJointCreateCoupling. */
    dCouplingJoint(dWorldID world, dJointGroupID group = 0) : id_(dJointCreateCoupling(world, group)) {}
    ~dCouplingJoint()
    {
        if (id_) dJointDestroy(id_);
    }
    /** The joint's handle, for the C functions. */
    dJointID id() const { return id_; }
    /** The same, where a C function wants it. */
    operator dJointID() const { return id_; }

    /** Its places for axes: dJointSetCouplingAxis and what reads them. */
    int setAxis(int i, dJointID joint, int axis, dReal factor)
    {
        return dJointSetCouplingAxis(id_, i, joint, axis, factor);
    }
    dJointID getJoint(int i) const { return dJointGetCouplingJoint(id_, i); }
    int getAxis(int i) const { return dJointGetCouplingAxis(id_, i); }
    dReal getFactor(int i) const { return dJointGetCouplingFactor(id_, i); }

    /** dJointSetCouplingParam, dJointGetCouplingParam, dJointGetCouplingForce. */
    void setParam(int parameter, dReal value) { dJointSetCouplingParam(id_, parameter, value); }
    dReal getParam(int parameter) const { return dJointGetCouplingParam(id_, parameter); }
    dReal getForce() const { return dJointGetCouplingForce(id_); }

  private:
    dCouplingJoint(const dCouplingJoint&);
    void operator=(const dCouplingJoint&);

    dJointID id_;
};

/** A geom of class Shape, one of ode/odecpp_collision.h, with the additions of ode/contacts.h, ode/shapes.h
    and ode/queries.h. It is made by create() of that class. */
template <class Shape>
class dGeomExt : public Shape {
  public:
    /** The geom's number; of a space it is that of a geom, too. */
    dGeomID geom() const { return *this; }

    /** dGeomSetMaterial, dGeomGetMaterial. */
    int setMaterial(const dMaterial& material) { return dGeomSetMaterial(geom(), &material); }
    int getMaterial(dMaterial* material) const { return dGeomGetMaterial(geom(), material); }

    /** dGeomSetFaceMaterial, dGeomGetFaceMaterial, dGeomSetFaceMaterialNumbers, dGeomGetFaceMaterialNumbers. */
    int setFaceMaterial(int number, const dMaterial* material)
    {
        return dGeomSetFaceMaterial(geom(), number, material);
    }
    int getFaceMaterial(int number, dMaterial* material) const
    {
        return dGeomGetFaceMaterial(geom(), number, material);
    }
    int setFaceMaterialNumbers(const unsigned char* numbers, int count)
    {
        return dGeomSetFaceMaterialNumbers(geom(), numbers, count);
    }
    int getFaceMaterialNumbers(unsigned char* numbers, int capacity) const
    {
        return dGeomGetFaceMaterialNumbers(geom(), numbers, capacity);
    }

    /** dGeomSetContinuous, dGeomGetContinuous. */
    void setContinuous(int mode) { dGeomSetContinuous(geom(), mode); }
    int getContinuous() const { return dGeomGetContinuous(geom()); }

    /** dGeomSetSensor, dGeomGetSensor. */
    void setSensor(int mode) { dGeomSetSensor(geom(), mode); }
    int getSensor() const { return dGeomGetSensor(geom()); }

    /** dGeomIsCharacter. */
    int isCharacter() const { return dGeomIsCharacter(geom()); }

    /** dGeomGetDistance, dGeomCast. */
    int getDistance(dGeomID other, dReal max_distance, dQueryDistance* result) const
    {
        return dGeomGetDistance(geom(), other, max_distance, result);
    }
    int cast(const dVector3 motion, dGeomID other, dQueryHit* hit) const
    {
        return dGeomCast(geom(), motion, other, hit);
    }
};

/** A geom that walks: dCharacterCreate. */
class dCharacter : public dGeom {
  public:
    /** Without a space there is no character yet; else it is made at once; settings 0: the defaults. */
    dCharacter() {}
    explicit dCharacter(dSpaceID space, const dCharacterSettings* settings = 0) { create(space, settings); }

    /** Make a new character in the space; the one before is destroyed. */
    void create(dSpaceID space, const dCharacterSettings* settings = 0)
    {
        own(dCharacterCreate(space, settings));
    }

    /** dCharacterMove, dCharacterWalk. */
    int move(const dVector3 velocity, dReal h) { return dCharacterMove(_id, velocity, h); }
    int walk(const dVector3 velocity, dReal jump_speed, dReal h)
    {
        return dCharacterWalk(_id, velocity, jump_speed, h);
    }

    /** dCharacterSetSettings, dCharacterGetSettings, dCharacterSetHeight. */
    int setSettings(const dCharacterSettings* settings) { return dCharacterSetSettings(_id, settings); }
    int getSettings(dCharacterSettings* settings) const { return dCharacterGetSettings(_id, settings); }
    int setHeight(dReal height) { return dCharacterSetHeight(_id, height); }

    /** The feet: dCharacterSetPosition, dCharacterGetPosition. */
    void setFeet(dReal x, dReal y, dReal z) { dCharacterSetPosition(_id, x, y, z); }
    int getFeet(dVector3 feet) const { return dCharacterGetPosition(_id, feet); }

    /** dCharacterSetVelocity, dCharacterGetVelocity, dCharacterGetReport. */
    void setVelocity(const dVector3 velocity) { dCharacterSetVelocity(_id, velocity); }
    int getVelocity(dVector3 velocity) const { return dCharacterGetVelocity(_id, velocity); }
    int getReport(dCharacterReport* report) const { return dCharacterGetReport(_id, report); }
};

/** The convex hull of points: dCreateConvexHull. */
class dConvexHull : public dGeom {
  public:
    /** Without points there is no geom yet; else it is made at once, in no space or in the given one. */
    dConvexHull() {}
    dConvexHull(dSpaceID space, const dReal* points, unsigned pointcount, unsigned maxvertices)
    {
        create(space, points, pointcount, maxvertices);
    }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, const dReal* points, unsigned pointcount, unsigned maxvertices)
    {
        own(dCreateConvexHull(space, points, pointcount, maxvertices));
    }

    /** dGeomSetConvexHull, dGeomConvexGetPoints, dGeomConvexGetPlanes, dGeomConvexGetPolygons. */
    void set(const dReal* points, unsigned pointcount, unsigned maxvertices)
    {
        dGeomSetConvexHull(_id, points, pointcount, maxvertices);
    }
    int getPoints(dReal* points, int capacity) const { return dGeomConvexGetPoints(_id, points, capacity); }
    int getPlanes(dReal* planes, int capacity) const { return dGeomConvexGetPlanes(_id, planes, capacity); }
    int getPolygons(unsigned* polygons, int capacity) const
    {
        return dGeomConvexGetPolygons(_id, polygons, capacity);
    }
};

/** A mesh that may be solid: dCreateTriMesh. */
class dTriMeshExt : public dGeom {
  public:
    /** Without data there is no geom yet; else it is made at once, in no space or in the given one. */
    dTriMeshExt() {}
    dTriMeshExt(dSpaceID space, dTriMeshDataID data) { create(space, data); }

    /** Make a new geom in the space or (0) in none; the one before is destroyed. */
    void create(dSpaceID space, dTriMeshDataID data) { own(dCreateTriMesh(space, data, 0, 0, 0)); }

    /** dGeomTriMeshSetSolid, dGeomTriMeshGetSolid. */
    void setSolid(int solid) { dGeomTriMeshSetSolid(_id, solid); }
    int getSolid() const { return dGeomTriMeshGetSolid(_id); }
};

/** A space of class Space, one of ode/odecpp_collision.h, with the additions of ode/queries.h. Filters may
    be 0, as in the C functions. */
template <class Space>
class dSpaceExt : public Space {
  public:
    /** Made at once, at the top or inside another space. */
    dSpaceExt() {}
    explicit dSpaceExt(dSpaceID space) : Space(space) {}

    /** dSpaceRayClosest, dSpaceRayAll, dSpaceRayBatch. */
    int rayClosest(const dVector3 origin, const dVector3 direction, dReal length, const dQueryFilter* filter,
                   dQueryHit* hit) const
    {
        return dSpaceRayClosest(Space::id(), origin, direction, length, filter, hit);
    }
    int rayAll(const dVector3 origin, const dVector3 direction, dReal length, const dQueryFilter* filter,
               dQueryHit* hits, int capacity) const
    {
        return dSpaceRayAll(Space::id(), origin, direction, length, filter, hits, capacity);
    }
    int rayBatch(int count, const dReal* origins, const dReal* directions, const dReal* lengths,
                 const dQueryFilter* filter, dQueryHit* hits, int threads) const
    {
        return dSpaceRayBatch(Space::id(), count, origins, directions, lengths, filter, hits, threads);
    }

    /** dSpaceApplyRadialImpulse. */
    int applyRadialImpulse(const dVector3 center, dReal radius, dReal impulse, int falloff, int occlusion,
                           const dQueryFilter* filter)
    {
        return dSpaceApplyRadialImpulse(Space::id(), center, radius, impulse, falloff, occlusion, filter);
    }

    /** dSpaceOverlap, dSpaceCast. */
    int overlap(dGeomID geom, const dQueryFilter* filter, dGeomID* geoms, int capacity) const
    {
        return dSpaceOverlap(Space::id(), geom, filter, geoms, capacity);
    }
    int cast(dGeomID o, const dVector3 motion, const dQueryFilter* filter, dQueryHit* hit) const
    {
        return dSpaceCast(Space::id(), o, motion, filter, hit);
    }
    /** dSpaceCastAll. */
    int castAll(dGeomID o, const dVector3 motion, const dQueryFilter* filter, dCastHit* hits,
                int capacity) const
    {
        return dSpaceCastAll(Space::id(), o, motion, filter, hits, capacity);
    }
};

/** A mass with the additions of ode/shapes.h. */
struct dMassExt : public dMass {
    /** dMassSetConvex, dMassSetConvexTotal. */
    void setConvex(dReal density, dGeomID convex) { dMassSetConvex(this, density, convex); }
    void setConvexTotal(dReal total_mass, dGeomID convex) { dMassSetConvexTotal(this, total_mass, convex); }
};

/** A fluid of a world: dFluidCreate. It is destroyed with this object, which must not outlive its world. */
class dFluid {
    dFluidID _id;

    dFluid(const dFluid&);
    void operator=(const dFluid&);

  public:
    /** dFluidCreate. */
    explicit dFluid(dWorldID world) : _id(dFluidCreate(world)) {}
    ~dFluid()
    {
        if (_id) dFluidDestroy(_id);
    }
    /** The fluid, for the C functions. */
    dFluidID id() const { return _id; }
    /** The same. */
    operator dFluidID() const { return _id; }

    /** dFluidGetWorld. */
    dWorldID getWorld() const { return dFluidGetWorld(_id); }

    /** dFluidSetSettings, dFluidGetSettings. */
    int setSettings(const dFluidSettings& settings) { return dFluidSetSettings(_id, &settings); }
    int getSettings(dFluidSettings& settings) const { return dFluidGetSettings(_id, &settings); }

    /** dFluidSetPlane, dFluidGetPlane. */
    void setPlane(dReal a, dReal b, dReal c, dReal d) { dFluidSetPlane(_id, a, b, c, d); }
    void getPlane(dVector4 plane) const { dFluidGetPlane(_id, plane); }

    /** dFluidSetSurface, dFluidSetCurrentFunction. */
    void setSurface(dFluidSurface* surface, void* data) { dFluidSetSurface(_id, surface, data); }
    void setCurrentFunction(dFluidCurrent* current, void* data)
    {
        dFluidSetCurrentFunction(_id, current, data);
    }

    /** dFluidSetVolume, dFluidGetVolume. */
    void setVolume(dGeomID volume) { dFluidSetVolume(_id, volume); }
    dGeomID getVolume() const { return dFluidGetVolume(_id); }

    /** dFluidSetTime, dFluidGetTime. */
    void setTime(dReal time) { dFluidSetTime(_id, time); }
    dReal getTime() const { return dFluidGetTime(_id); }

    /** dFluidGetSubmerged, dFluidGetSubmergedBody. */
    int getSubmerged(dGeomID geom, dReal* volume, dVector3 centre) const
    {
        return dFluidGetSubmerged(_id, geom, volume, centre);
    }
    int getSubmergedBody(dBodyID body, dReal* volume, dVector3 centre) const
    {
        return dFluidGetSubmergedBody(_id, body, volume, centre);
    }
};

/** Holes in a height field's data, which it does not own. */
class dHeightfieldHoles {
    dHeightfieldDataID _data;

  public:
    /** The holes of these data. */
    explicit dHeightfieldHoles(dHeightfieldDataID data) : _data(data) {}

    /** dGeomHeightfieldDataSetHoles, dGeomHeightfieldDataSetHole, dGeomHeightfieldDataGetHole. */
    void setHoles(const unsigned char* holes, int widthCells, int depthCells)
    {
        dGeomHeightfieldDataSetHoles(_data, holes, widthCells, depthCells);
    }
    void setHole(int i, int j, int hole) { dGeomHeightfieldDataSetHole(_data, i, j, hole); }
    int getHole(int i, int j) const { return dGeomHeightfieldDataGetHole(_data, i, j); }
};

#endif
#endif
