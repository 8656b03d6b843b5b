// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Worlds, bodies, joints.
#ifndef _ODE_OBJECTS_H_
#define _ODE_OBJECTS_H_

#include <ode/common.h>
#include <ode/mass.h>
#include <ode/contact.h>
#include <ode/threading.h>

#ifdef __cplusplus
extern "C" {
#endif

#define dWORLDSTEP_THREADCOUNT_UNLIMITED dTHREADING_THREAD_COUNT_UNLIMITED
#define dWORLDSTEP_RESERVEFACTOR_DEFAULT 1.2f
#define dWORLDSTEP_RESERVESIZE_DEFAULT 65536U
typedef struct {
  unsigned struct_size;
  float reserve_factor;
  unsigned reserve_minimum;
} dWorldStepReserveInfo;
typedef struct {
  unsigned struct_size;
  void *(*alloc_block)(dsizeint block_size);
  void *(*shrink_block)(void *block_pointer, dsizeint block_current_size, dsizeint block_smaller_size);
  void (*free_block)(void *block_pointer, dsizeint block_current_size);
} dWorldStepMemoryFunctionsInfo;

ODE_API int dAreConnected(dBodyID, dBodyID);
ODE_API int dAreConnectedExcluding(dBodyID body1, dBodyID body2, int joint_type);
ODE_API void dBodyAddForce(dBodyID, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddForceAtPos(dBodyID, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddForceAtRelPos(dBodyID, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddRelForce(dBodyID, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddRelForceAtPos(dBodyID, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddRelForceAtRelPos(dBodyID, dReal fx, dReal fy, dReal fz, dReal px, dReal py, dReal pz);
ODE_API void dBodyAddRelTorque(dBodyID, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyAddTorque(dBodyID, dReal fx, dReal fy, dReal fz);
ODE_API void dBodyCopyPosition(dBodyID body, dVector3 pos);
ODE_API void dBodyCopyQuaternion(dBodyID body, dQuaternion quat);
ODE_API void dBodyCopyRotation(dBodyID, dMatrix3 R);
ODE_API dBodyID dBodyCreate(dWorldID);
ODE_API void dBodyDestroy(dBodyID);
ODE_API void dBodyDisable(dBodyID);
ODE_API void dBodyEnable(dBodyID);
ODE_API dReal dBodyGetAngularDamping(dBodyID b);
ODE_API dReal dBodyGetAngularDampingThreshold(dBodyID b);
ODE_API const dReal * dBodyGetAngularVel(dBodyID);
ODE_API dReal dBodyGetAutoDisableAngularThreshold(dBodyID);
ODE_API int dBodyGetAutoDisableAverageSamplesCount(dBodyID);
ODE_API int dBodyGetAutoDisableFlag(dBodyID);
ODE_API dReal dBodyGetAutoDisableLinearThreshold(dBodyID);
ODE_API int dBodyGetAutoDisableSteps(dBodyID);
ODE_API dReal dBodyGetAutoDisableTime(dBodyID);
ODE_API void *dBodyGetData(dBodyID);
ODE_API void dBodyGetFiniteRotationAxis(dBodyID, dVector3 result);
ODE_API int dBodyGetFiniteRotationMode(dBodyID);
ODE_API dGeomID dBodyGetFirstGeom(dBodyID b);
ODE_API const dReal * dBodyGetForce(dBodyID);
ODE_API int dBodyGetGravityMode(dBodyID b);
ODE_API int dBodyGetGyroscopicMode(dBodyID b);
ODE_API dJointID dBodyGetJoint(dBodyID, int index);
ODE_API dReal dBodyGetLinearDamping(dBodyID b);
ODE_API dReal dBodyGetLinearDampingThreshold(dBodyID b);
ODE_API const dReal * dBodyGetLinearVel(dBodyID);
ODE_API void dBodyGetMass(dBodyID, dMass *mass);
ODE_API dReal dBodyGetMaxAngularSpeed(dBodyID b);
ODE_API dGeomID dBodyGetNextGeom(dGeomID g);
ODE_API int dBodyGetNumJoints(dBodyID b);
ODE_API void dBodyGetPointVel( dBodyID, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API void dBodyGetPosRelPoint( dBodyID, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API const dReal * dBodyGetPosition(dBodyID);
ODE_API const dReal * dBodyGetQuaternion(dBodyID);
ODE_API void dBodyGetRelPointPos( dBodyID, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API void dBodyGetRelPointVel( dBodyID, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API const dReal * dBodyGetRotation(dBodyID);
ODE_API const dReal * dBodyGetTorque(dBodyID);
ODE_API dWorldID dBodyGetWorld(dBodyID);
ODE_API int dBodyIsEnabled(dBodyID);
ODE_API int dBodyIsKinematic(dBodyID);
ODE_API void dBodySetAngularDamping(dBodyID b, dReal scale);
ODE_API void dBodySetAngularDampingThreshold(dBodyID b, dReal threshold);
ODE_API void dBodySetAngularVel(dBodyID, dReal x, dReal y, dReal z);
ODE_API void dBodySetAutoDisableAngularThreshold(dBodyID, dReal angular_average_threshold);
ODE_API void dBodySetAutoDisableAverageSamplesCount(dBodyID, unsigned int average_samples_count);
ODE_API void dBodySetAutoDisableDefaults(dBodyID);
ODE_API void dBodySetAutoDisableFlag(dBodyID, int do_auto_disable);
ODE_API void dBodySetAutoDisableLinearThreshold(dBodyID, dReal linear_average_threshold);
ODE_API void dBodySetAutoDisableSteps(dBodyID, int steps);
ODE_API void dBodySetAutoDisableTime(dBodyID, dReal time);
ODE_API void dBodySetDamping(dBodyID b, dReal linear_scale, dReal angular_scale);
ODE_API void dBodySetDampingDefaults(dBodyID b);
ODE_API void dBodySetData(dBodyID, void *data);
ODE_API void dBodySetDynamic(dBodyID);
ODE_API void dBodySetFiniteRotationAxis(dBodyID, dReal x, dReal y, dReal z);
ODE_API void dBodySetFiniteRotationMode(dBodyID, int mode);
ODE_API void dBodySetForce(dBodyID b, dReal x, dReal y, dReal z);
ODE_API void dBodySetGravityMode(dBodyID b, int mode);
ODE_API void dBodySetGyroscopicMode(dBodyID b, int enabled);
ODE_API void dBodySetKinematic(dBodyID);
ODE_API void dBodySetLinearDamping(dBodyID b, dReal scale);
ODE_API void dBodySetLinearDampingThreshold(dBodyID b, dReal threshold);
ODE_API void dBodySetLinearVel(dBodyID, dReal x, dReal y, dReal z);
ODE_API void dBodySetMass(dBodyID, const dMass *mass);
ODE_API void dBodySetMaxAngularSpeed(dBodyID b, dReal max_speed);
ODE_API void dBodySetMovedCallback(dBodyID b, void(*callback)(dBodyID));
ODE_API void dBodySetPosition(dBodyID, dReal x, dReal y, dReal z);
ODE_API void dBodySetQuaternion(dBodyID, const dQuaternion q);
ODE_API void dBodySetRotation(dBodyID, const dMatrix3 R);
ODE_API void dBodySetTorque(dBodyID b, dReal x, dReal y, dReal z);
ODE_API void dBodyVectorFromWorld( dBodyID, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API void dBodyVectorToWorld( dBodyID, dReal px, dReal py, dReal pz, dVector3 result );
ODE_API dJointID dConnectingJoint(dBodyID, dBodyID);
ODE_API int dConnectingJointList(dBodyID, dBodyID, dJointID*);
ODE_API void dJointAddAMotorTorques(dJointID, dReal torque1, dReal torque2, dReal torque3);
ODE_API void dJointAddHinge2Torques(dJointID joint, dReal torque1, dReal torque2);
ODE_API void dJointAddHingeTorque(dJointID joint, dReal torque);
ODE_API void dJointAddSliderForce(dJointID joint, dReal force);
ODE_API void dJointAddUniversalTorques(dJointID joint, dReal torque1, dReal torque2);
ODE_API void dJointAttach(dJointID, dBodyID body1, dBodyID body2);
ODE_API dJointID dJointCreateAMotor(dWorldID, dJointGroupID);
ODE_API dJointID dJointCreateBall(dWorldID, dJointGroupID);
ODE_API dJointID dJointCreateContact(dWorldID, dJointGroupID, const dContact *);
ODE_API dJointID dJointCreateFixed(dWorldID, dJointGroupID);
ODE_API dJointID dJointCreateHinge(dWorldID, dJointGroupID);
ODE_API dJointID dJointCreateHinge2(dWorldID, dJointGroupID);
ODE_API dJointID dJointCreateNull(dWorldID, dJointGroupID);
ODE_API dJointID dJointCreateSlider(dWorldID, dJointGroupID);
ODE_API dJointID dJointCreateUniversal(dWorldID, dJointGroupID);
ODE_API void dJointDestroy(dJointID);
ODE_API void dJointDisable(dJointID);
ODE_API void dJointEnable(dJointID);
ODE_API dReal dJointGetAMotorAngle(dJointID, int anum);
ODE_API dReal dJointGetAMotorAngleRate(dJointID, int anum);
ODE_API void dJointGetAMotorAxis(dJointID, int anum, dVector3 result);
ODE_API int dJointGetAMotorAxisRel(dJointID, int anum);
ODE_API int dJointGetAMotorMode(dJointID);
ODE_API int dJointGetAMotorNumAxes(dJointID);
ODE_API dReal dJointGetAMotorParam(dJointID, int parameter);
ODE_API void dJointGetBallAnchor(dJointID, dVector3 result);
ODE_API void dJointGetBallAnchor2(dJointID, dVector3 result);
ODE_API dReal dJointGetBallParam(dJointID, int parameter);
ODE_API dBodyID dJointGetBody(dJointID, int index);
ODE_API void *dJointGetData(dJointID);
ODE_API dJointFeedback *dJointGetFeedback(dJointID);
ODE_API dReal dJointGetFixedParam(dJointID, int parameter);
ODE_API void dJointGetHinge2Anchor(dJointID, dVector3 result);
ODE_API void dJointGetHinge2Anchor2(dJointID, dVector3 result);
ODE_API dReal dJointGetHinge2Angle1(dJointID);
ODE_API dReal dJointGetHinge2Angle1Rate(dJointID);
ODE_API dReal dJointGetHinge2Angle2(dJointID);
ODE_API dReal dJointGetHinge2Angle2Rate(dJointID);
ODE_API void dJointGetHinge2Axis1(dJointID, dVector3 result);
ODE_API void dJointGetHinge2Axis2(dJointID, dVector3 result);
ODE_API dReal dJointGetHinge2Param(dJointID, int parameter);
ODE_API void dJointGetHingeAnchor(dJointID, dVector3 result);
ODE_API void dJointGetHingeAnchor2(dJointID, dVector3 result);
ODE_API dReal dJointGetHingeAngle(dJointID);
ODE_API dReal dJointGetHingeAngleRate(dJointID);
ODE_API void dJointGetHingeAxis(dJointID, dVector3 result);
ODE_API dReal dJointGetHingeParam(dJointID, int parameter);
ODE_API int dJointGetNumBodies(dJointID);
ODE_API void dJointGetSliderAxis(dJointID, dVector3 result);
ODE_API dReal dJointGetSliderParam(dJointID, int parameter);
ODE_API dReal dJointGetSliderPosition(dJointID);
ODE_API dReal dJointGetSliderPositionRate(dJointID);
ODE_API dJointType dJointGetType(dJointID);
ODE_API void dJointGetUniversalAnchor(dJointID, dVector3 result);
ODE_API void dJointGetUniversalAnchor2(dJointID, dVector3 result);
ODE_API dReal dJointGetUniversalAngle1(dJointID);
ODE_API dReal dJointGetUniversalAngle1Rate(dJointID);
ODE_API dReal dJointGetUniversalAngle2(dJointID);
ODE_API dReal dJointGetUniversalAngle2Rate(dJointID);
ODE_API void dJointGetUniversalAngles(dJointID, dReal *angle1, dReal *angle2);
ODE_API void dJointGetUniversalAxis1(dJointID, dVector3 result);
ODE_API void dJointGetUniversalAxis2(dJointID, dVector3 result);
ODE_API dReal dJointGetUniversalParam(dJointID, int parameter);
ODE_API dJointGroupID dJointGroupCreate(int max_size);
ODE_API void dJointGroupDestroy(dJointGroupID);
ODE_API void dJointGroupEmpty(dJointGroupID);
ODE_API int dJointIsEnabled(dJointID);
ODE_API void dJointSetAMotorAngle(dJointID, int anum, dReal angle);
ODE_API void dJointSetAMotorAxis(dJointID, int anum, int rel, dReal x, dReal y, dReal z);
ODE_API void dJointSetAMotorMode(dJointID, int mode);
ODE_API void dJointSetAMotorNumAxes(dJointID, int num);
ODE_API void dJointSetAMotorParam(dJointID, int parameter, dReal value);
ODE_API void dJointSetBallAnchor(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetBallAnchor2(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetBallParam(dJointID, int parameter, dReal value);
ODE_API void dJointSetData(dJointID, void *data);
ODE_API void dJointSetFeedback(dJointID, dJointFeedback *);
ODE_API void dJointSetFixed(dJointID);
ODE_API void dJointSetFixedParam(dJointID, int parameter, dReal value);
ODE_API void dJointSetHinge2Anchor(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetHinge2Axes(dJointID j, const dReal *axis1 , const dReal *axis2 );
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis1(dJointID j, dReal x, dReal y, dReal z);
ODE_API_DEPRECATED ODE_API void dJointSetHinge2Axis2(dJointID j, dReal x, dReal y, dReal z);
ODE_API void dJointSetHinge2Param(dJointID, int parameter, dReal value);
ODE_API void dJointSetHingeAnchor(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetHingeAnchorDelta(dJointID, dReal x, dReal y, dReal z, dReal ax, dReal ay, dReal az);
ODE_API void dJointSetHingeAxis(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetHingeAxisOffset(dJointID j, dReal x, dReal y, dReal z, dReal angle);
ODE_API void dJointSetHingeParam(dJointID, int parameter, dReal value);
ODE_API void dJointSetSliderAxis(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetSliderAxisDelta(dJointID, dReal x, dReal y, dReal z, dReal ax, dReal ay, dReal az);
ODE_API void dJointSetSliderParam(dJointID, int parameter, dReal value);
ODE_API void dJointSetUniversalAnchor(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetUniversalAxis1(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetUniversalAxis1Offset(dJointID, dReal x, dReal y, dReal z, dReal offset1, dReal offset2);
ODE_API void dJointSetUniversalAxis2(dJointID, dReal x, dReal y, dReal z);
ODE_API void dJointSetUniversalAxis2Offset(dJointID, dReal x, dReal y, dReal z, dReal offset1, dReal offset2);
ODE_API void dJointSetUniversalParam(dJointID, int parameter, dReal value);
ODE_API dWorldID dWorldCreate(void);
ODE_API void dWorldDestroy(dWorldID world);
ODE_API dReal dWorldGetAngularDamping(dWorldID w);
ODE_API dReal dWorldGetAngularDampingThreshold(dWorldID w);
ODE_API dReal dWorldGetAutoDisableAngularThreshold(dWorldID);
ODE_API int dWorldGetAutoDisableAverageSamplesCount(dWorldID);
ODE_API int dWorldGetAutoDisableFlag(dWorldID);
ODE_API dReal dWorldGetAutoDisableLinearThreshold(dWorldID);
ODE_API int dWorldGetAutoDisableSteps(dWorldID);
ODE_API dReal dWorldGetAutoDisableTime(dWorldID);
ODE_API dReal dWorldGetCFM(dWorldID);
ODE_API dReal dWorldGetContactMaxCorrectingVel(dWorldID);
ODE_API dReal dWorldGetContactSurfaceLayer(dWorldID);
ODE_API void* dWorldGetData(dWorldID world);
ODE_API dReal dWorldGetERP(dWorldID);
ODE_API void dWorldGetGravity(dWorldID, dVector3 gravity);
ODE_API dReal dWorldGetLinearDamping(dWorldID w);
ODE_API dReal dWorldGetLinearDampingThreshold(dWorldID w);
ODE_API dReal dWorldGetMaxAngularSpeed(dWorldID w);
ODE_API int dWorldGetQuickStepNumIterations(dWorldID);
ODE_API dReal dWorldGetQuickStepW(dWorldID);
ODE_API unsigned dWorldGetStepIslandsProcessingMaxThreadCount(dWorldID w);
ODE_API void dWorldImpulseToForce( dWorldID, dReal stepsize, dReal ix, dReal iy, dReal iz, dVector3 force );
ODE_API int dWorldQuickStep(dWorldID w, dReal stepsize);
ODE_API void dWorldSetAngularDamping(dWorldID w, dReal scale);
ODE_API void dWorldSetAngularDampingThreshold(dWorldID w, dReal threshold);
ODE_API void dWorldSetAutoDisableAngularThreshold(dWorldID, dReal angular_average_threshold);
ODE_API void dWorldSetAutoDisableAverageSamplesCount(dWorldID, unsigned int average_samples_count );
ODE_API void dWorldSetAutoDisableFlag(dWorldID, int do_auto_disable);
ODE_API void dWorldSetAutoDisableLinearThreshold(dWorldID, dReal linear_average_threshold);
ODE_API void dWorldSetAutoDisableSteps(dWorldID, int steps);
ODE_API void dWorldSetAutoDisableTime(dWorldID, dReal time);
ODE_API void dWorldSetCFM(dWorldID, dReal cfm);
ODE_API void dWorldSetContactMaxCorrectingVel(dWorldID, dReal vel);
ODE_API void dWorldSetContactSurfaceLayer(dWorldID, dReal depth);
ODE_API void dWorldSetDamping(dWorldID w, dReal linear_scale, dReal angular_scale);
ODE_API void dWorldSetData(dWorldID world, void* data);
ODE_API void dWorldSetERP(dWorldID, dReal erp);
ODE_API void dWorldSetGravity(dWorldID, dReal x, dReal y, dReal z);
ODE_API void dWorldSetLinearDamping(dWorldID w, dReal scale);
ODE_API void dWorldSetLinearDampingThreshold(dWorldID w, dReal threshold);
ODE_API void dWorldSetMaxAngularSpeed(dWorldID w, dReal max_speed);
ODE_API void dWorldSetQuickStepNumIterations(dWorldID, int num);
ODE_API void dWorldSetQuickStepW(dWorldID, dReal over_relaxation);
ODE_API void dWorldSetStepIslandsProcessingMaxThreadCount(dWorldID w, unsigned count);
ODE_API int dWorldStep(dWorldID w, dReal stepsize);

#ifdef __cplusplus
}
#endif

#endif
