// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Written by rust/tools/generate.py from the public headers.
use super::*;

#[repr(C)]
pub struct dxWorld {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxSpace {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxBody {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxGeom {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxJoint {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxJointGroup {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxTriMeshData {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxHeightfieldData {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxThreadingImplementation {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxMutexGroup {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxCallReleasee {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxCallWait {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxCooperative {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxResourceRequirements {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxResourceContainer {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxThreadingThreadPool {
    _private: [u8; 0],
    _marker: Unshared,
}
#[repr(C)]
pub struct dxFluid {
    _private: [u8; 0],
    _marker: Unshared,
}
/// a dynamics world
pub type dWorldID = *mut dxWorld;
/// a collision space; also usable as a dGeomID by cast
pub type dSpaceID = *mut dxSpace;
/// a rigid body
pub type dBodyID = *mut dxBody;
/// a collision shape
pub type dGeomID = *mut dxGeom;
/// a joint, contacts included
pub type dJointID = *mut dxJoint;
/// a set of joints that die together
pub type dJointGroupID = *mut dxJointGroup;
/// the triangles, shared by any number of geoms
pub type dTriMeshDataID = *mut dxTriMeshData;
/// the heights of height fields
pub type dHeightfieldDataID = *mut dxHeightfieldData;
/// a threading implementation
pub type dThreadingImplementationID = *mut dxThreadingImplementation;
/// a group of mutexes
pub type dMutexGroupID = *mut dxMutexGroup;
/// a call that is not done, as one that others precede
pub type dCallReleaseeID = *mut dxCallReleasee;
/// something a thread can wait on until a call is done
pub type dCallWaitID = *mut dxCallWait;
/// Threads at work on one task.
pub type dCooperativeID = *mut dxCooperative;
/// Memory that calls will need.
pub type dResourceRequirementsID = *mut dxResourceRequirements;
/// That memory, acquired.
pub type dResourceContainerID = *mut dxResourceContainer;
/// A fluid of a world.
pub type dFluidID = *mut dxFluid;
/// A pool of threads.
pub type dThreadingThreadPoolID = *mut dxThreadingThreadPool;
pub type dTriIndex = u32;
/// number of a mutex in its group
pub type dmutexindex_t = c_uint;
/// how many calls must be done first
pub type ddependencycount_t = usize;
/// change of that number
pub type ddependencychange_t = isize;
/// which of several equal calls this is
pub type dcallindex_t = usize;
/// x, y, z, padding
pub type dVector3 = [dReal; 4];
/// x, y, z, o
pub type dVector4 = [dReal; 4];
/// w, x, y, z
pub type dQuaternion = [dReal; 4];
/// 3 rows of 4; element (i,j) at 4 i + j
pub type dMatrix3 = [dReal; 12];
/// 4 rows of 4
pub type dMatrix4 = [dReal; 16];
/// 6 rows of 8
pub type dMatrix6 = [dReal; 48];
/// A handler. errnum: one of the d\_ERR\_... numbers of common.h, 0 when unknown; msg: printf format;
/// ap: its arguments, which the handler may consume once.
pub type dMessageFunction = Option<unsafe extern "C" fn(c_int, *const c_char, va_list)>;
/// What dSpaceCollide and dSpaceCollide2 call for each pair; data is the caller's. A member that is a
/// space comes as a geom (dGeomIsSpace tells).
pub type dNearCallback = Option<unsafe extern "C" fn(*mut c_void, dGeomID, dGeomID)>;
/// May a triangle touch the other geom? Returns non-zero to let it.
pub type dTriCallback = Option<unsafe extern "C" fn(dGeomID, dGeomID, c_int) -> c_int>;
/// Told all triangles that touch the other geom.
pub type dTriArrayCallback = Option<unsafe extern "C" fn(dGeomID, dGeomID, *const c_int, c_int)>;
/// Does a ray's hit at barycentric coordinates (u, v) of a triangle count? Returns non-zero if so.
pub type dTriRayCallback = Option<unsafe extern "C" fn(dGeomID, dGeomID, c_int, dReal, dReal) -> c_int>;
/// Which triangle number a contact gets that is merged from those of two triangles.
pub type dTriTriMergeCallback = Option<unsafe extern "C" fn(dGeomID, c_int, c_int) -> c_int>;
/// The sample (x, z); it counts as 0 when it is no number. Must not change while a collision goes on.
pub type dHeightfieldGetHeight = Option<unsafe extern "C" fn(*mut c_void, c_int, c_int) -> dReal>;
/// Writes the bounding box of a geom; its pose is up to date.
pub type dGetAABBFn = Option<unsafe extern "C" fn(dGeomID, *mut dReal)>;
/// Finds contacts of o1 (of the class the function belongs to) and o2, as dCollide.
pub type dColliderFn = Option<unsafe extern "C" fn(dGeomID, dGeomID, c_int, *mut dContactGeom, c_int) -> c_int>;
/// Gives the function that collides the user class with class num, or 0. Asked once per class.
pub type dGetColliderFnFn = Option<unsafe extern "C" fn(c_int) -> dColliderFn>;
/// Called when a geom of the class is destroyed, before its data goes.
pub type dGeomDtorFn = Option<unsafe extern "C" fn(dGeomID)>;
/// May o1 touch anything inside o2's bounding box? 0 saves the closer test.
pub type dAABBTestFn = Option<unsafe extern "C" fn(dGeomID, dGeomID, *mut dReal) -> c_int>;
/// Decides whether a query keeps a geom that it has met: not if it returns 0. data is the filter's; geom is
/// the one that the result would name. It is called on the caller's thread, the geom that has joined last
/// first, but not for geoms farther than one that has been kept already where the nearest is asked for. It
/// must not change the space.
pub type dQueryCallback = Option<unsafe extern "C" fn(*mut c_void, dGeomID) -> c_int>;
/// Decides whether a character collides with another geom in one move: not if it returns 0. data is that of
/// the settings, velocity is what the move was asked for. It is called once for each geom nearby, the one
/// that has joined last first, and must not change the space. One-way platforms: answer 1 if the geom is the
/// ground of the last report, or if the character comes down with its feet above it.
pub type dCharacterFilter = Option<unsafe extern "C" fn(*mut c_void, dGeomID, dGeomID, *const dReal) -> c_int>;
/// Decides whether two geoms may touch: not if it returns 0. It is called once when they come near each
/// other, and again when they have been apart.
pub type dContactFilter = Option<unsafe extern "C" fn(*mut c_void, dGeomID, dGeomID) -> c_int>;
/// Sees every manifold of the world in every step, before it is solved, and may change it. data is the
/// program's. It must not change the space or the world, and depend on nothing that steps change.
pub type dManifoldFunction = Option<unsafe extern "C" fn(*mut c_void, *mut dManifold)>;
/// Make Mutex\_count mutexes, 1 to 65536, which need not be recursive. Mutex\_names\_ptr: as many names for
/// debugging, or NULL. Returns NULL on failure.
pub type dMutexGroupAllocFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, dmutexindex_t, *const *const c_char) -> dMutexGroupID>;
/// Free a group, none of whose mutexes is locked (refused otherwise). NULL is ignored.
pub type dMutexGroupFreeFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, dMutexGroupID)>;
/// Wait until mutex 0 \<= mutex\_index \< Mutex\_count is free, and lock it. Refused if the calling thread has
/// locked it already.
pub type dMutexGroupMutexLockFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, dMutexGroupID, dmutexindex_t)>;
/// Unlock a mutex that the calling thread has locked (refused otherwise).
pub type dMutexGroupMutexUnlockFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, dMutexGroupID, dmutexindex_t)>;
/// The work itself. call\_context and instance\_index are those it was posted with; this\_releasee names the
/// call, so that it can add dependencies to itself. Returns non-zero on success, 0 for a fault.
pub type dThreadedCallFunction = Option<unsafe extern "C" fn(*mut c_void, dcallindex_t, dCallReleaseeID) -> c_int>;
/// Make something to wait on. Returns NULL on failure.
pub type dThreadedCallWaitAllocFunction = Option<unsafe extern "C" fn(dThreadingImplementationID) -> dCallWaitID>;
/// Forget the calls it was posted with, so that it can be used for others. Refused while they are not done or
/// a thread waits.
pub type dThreadedCallWaitResetFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, dCallWaitID)>;
/// Free it. Refused while a call that was posted with it is not done, or a thread waits. NULL is ignored.
pub type dThreadedCallWaitFreeFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, dCallWaitID)>;
/// Hand in a call. It starts, on some thread, when dependencies\_count calls that name it as their
/// dependent\_releasee are done; with none it may start before this function returns.
/// - out\_summary\_fault: where 1 is written when the call is done and it, or a call that it depended on,
/// directly or not, has returned 0; else 0. May be NULL; must stay valid until the call is done.
/// - out\_post\_releasee: where the name of this call is written, by which others precede it. It is good until
/// the call is done. May be NULL.
/// - dependent\_releasee: the call that this one precedes, or NULL. It must count on one more dependency than
/// have been posted for it (refused otherwise).
/// - call\_wait: told when the call is done, or NULL. Several calls may share one: it then waits for all.
/// - call\_func, call\_context, instance\_index: what is called.
/// - call\_name: for debugging, or NULL; a literal, since it must stay valid.
///
/// A call that is refused, or that there is no memory to keep, counts as done with a fault; where memory is
/// out, a call without dependencies is run at once by the thread that posts it.
pub type dThreadedCallPostFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, *mut c_int, *mut dCallReleaseeID, ddependencycount_t, dCallReleaseeID, dCallWaitID, dThreadedCallFunction, *mut c_void, dcallindex_t, *const c_char)>;
/// Change the number of calls that a call which is not done depends on: before it starts, or by itself while
/// it runs. If none are left it starts, or is done if it has returned. Refused below the number of those that
/// have been posted for it and are not done.
pub type dThreadedCallDependenciesCountAlterFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, dCallReleaseeID, ddependencychange_t)>;
/// Wait until all calls that were posted with call\_wait are done. timeout\_time\_ptr: for how long at most (on
/// the monotonic clock); zero only asks; NULL for ever. out\_wait\_status, which may be NULL, is set to 1 if
/// they are done and to 0 if not. wait\_name is for debugging, or NULL. ODE forbids waiting inside a call,
/// since it takes a thread away. Here the waiting thread runs other calls meanwhile, as it does when no
/// thread serves. A wait without a limit that nothing can end (nothing was posted; it is that of a call which
/// the thread is in) is refused with status 0.
pub type dThreadedCallWaitFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, *mut c_int, dCallWaitID, *const dThreadedWaitTime, *const c_char)>;
/// How many threads serve; 0 says that the thread that waits does the work.
pub type dThreadingImplThreadCountRetrieveFunction = Option<unsafe extern "C" fn(dThreadingImplementationID) -> c_uint>;
/// Make room for so many calls at once, at most 65536. Returns 1, or 0 if there is none: then a step that
/// asked for it returns 0.
pub type dThreadingImplResourcesForCallsPreallocateFunction = Option<unsafe extern "C" fn(dThreadingImplementationID, ddependencycount_t) -> c_int>;
/// The height of the surface above the fluid's plane at a place of that plane (world frame, m) and a time (s); data is
/// the program's. It is called on the caller's thread, in the order of bodies and geoms; it must not change the world. What is not
/// finite counts as 0.
pub type dFluidSurface = Option<unsafe extern "C" fn(*mut c_void, *const dReal, dReal) -> dReal>;
/// Writes the velocity (m/s, world) of the fluid at a place (m, world) and a time (s) to velocity; data is the program's. It is called
/// like dFluidSurface. It replaces dFluidSettings::current.
pub type dFluidCurrent = Option<unsafe extern "C" fn(*mut c_void, *const dReal, dReal, *mut dReal)>;
/// Gives \`size\` bytes aligned for any type, or NULL.
pub type dAllocFunction = Option<unsafe extern "C" fn(usize) -> *mut c_void>;
/// Resizes a block from oldsize to newsize bytes, keeping the common part.
pub type dReallocFunction = Option<unsafe extern "C" fn(*mut c_void, usize, usize) -> *mut c_void>;
/// Takes back a block of \`size\` bytes.
pub type dFreeFunction = Option<unsafe extern "C" fn(*mut c_void, usize)>;
/// What a thread that begins to serve calls, with the context it was given.
pub type dThreadReadyToServeCallback = Option<unsafe extern "C" fn(*mut c_void)>;
/// Space axes.
pub type dSpaceAxis = c_uint;
pub const dSA__MIN: dSpaceAxis = 0;
pub const dSA_X: dSpaceAxis = 0;
pub const dSA_Y: dSpaceAxis = 1;
pub const dSA_Z: dSpaceAxis = 2;
pub const dSA__MAX: dSpaceAxis = 3;
/// The two parts of a rigid motion.
pub type dMotionDynamics = c_uint;
pub const dMD__MIN: dMotionDynamics = 0;
pub const dMD_LINEAR: dMotionDynamics = 0;
pub const dMD_ANGULAR: dMotionDynamics = 1;
pub const dMD__MAX: dMotionDynamics = 2;
/// The six components of a rigid motion, linear ones first.
pub type dDynamicsAxis = c_uint;
pub const dDA__MIN: dDynamicsAxis = 0;
pub const dDA__L_MIN: dDynamicsAxis = 0;
pub const dDA_LX: dDynamicsAxis = 0;
pub const dDA_LY: dDynamicsAxis = 1;
pub const dDA_LZ: dDynamicsAxis = 2;
pub const dDA__L_MAX: dDynamicsAxis = 3;
pub const dDA__A_MIN: dDynamicsAxis = 3;
pub const dDA_AX: dDynamicsAxis = 3;
pub const dDA_AY: dDynamicsAxis = 4;
pub const dDA_AZ: dDynamicsAxis = 5;
pub const dDA__A_MAX: dDynamicsAxis = 6;
pub const dDA__MAX: dDynamicsAxis = 6;
/// Elements of a dVector3: three axes and the padding.
pub type dVec3Element = c_uint;
pub const dV3E__MIN: dVec3Element = 0;
pub const dV3E__AXES_MIN: dVec3Element = 0;
pub const dV3E_X: dVec3Element = 0;
pub const dV3E_Y: dVec3Element = 1;
pub const dV3E_Z: dVec3Element = 2;
pub const dV3E__AXES_MAX: dVec3Element = 3;
pub const dV3E_PAD: dVec3Element = 3;
pub const dV3E__MAX: dVec3Element = 4;
pub const dV3E__AXES_COUNT: dVec3Element = 3;
/// Elements of a dVector4.
pub type dVec4Element = c_uint;
pub const dV4E__MIN: dVec4Element = 0;
pub const dV4E_X: dVec4Element = 0;
pub const dV4E_Y: dVec4Element = 1;
pub const dV4E_Z: dVec4Element = 2;
pub const dV4E_O: dVec4Element = 3;
pub const dV4E__MAX: dVec4Element = 4;
/// Elements of a dMatrix3: three rows of three and the padding; dM3E\_XY is row x, column y.
pub type dMat3Element = c_uint;
pub const dM3E__MIN: dMat3Element = 0;
pub const dM3E__X_MIN: dMat3Element = 0;
pub const dM3E__X_AXES_MIN: dMat3Element = 0;
pub const dM3E_XX: dMat3Element = 0;
pub const dM3E_XY: dMat3Element = 1;
pub const dM3E_XZ: dMat3Element = 2;
pub const dM3E__X_AXES_MAX: dMat3Element = 3;
pub const dM3E_XPAD: dMat3Element = 3;
pub const dM3E__X_MAX: dMat3Element = 4;
pub const dM3E__Y_MIN: dMat3Element = 4;
pub const dM3E__Y_AXES_MIN: dMat3Element = 4;
pub const dM3E_YX: dMat3Element = 4;
pub const dM3E_YY: dMat3Element = 5;
pub const dM3E_YZ: dMat3Element = 6;
pub const dM3E__Y_AXES_MAX: dMat3Element = 7;
pub const dM3E_YPAD: dMat3Element = 7;
pub const dM3E__Y_MAX: dMat3Element = 8;
pub const dM3E__Z_MIN: dMat3Element = 8;
pub const dM3E__Z_AXES_MIN: dMat3Element = 8;
pub const dM3E_ZX: dMat3Element = 8;
pub const dM3E_ZY: dMat3Element = 9;
pub const dM3E_ZZ: dMat3Element = 10;
pub const dM3E__Z_AXES_MAX: dMat3Element = 11;
pub const dM3E_ZPAD: dMat3Element = 11;
pub const dM3E__Z_MAX: dMat3Element = 12;
pub const dM3E__MAX: dMat3Element = 12;
/// Elements of a dMatrix4, rows x, y, z, o.
pub type dMat4Element = c_uint;
pub const dM4E__MIN: dMat4Element = 0;
pub const dM4E__X_MIN: dMat4Element = 0;
pub const dM4E_XX: dMat4Element = 0;
pub const dM4E_XY: dMat4Element = 1;
pub const dM4E_XZ: dMat4Element = 2;
pub const dM4E_XO: dMat4Element = 3;
pub const dM4E__X_MAX: dMat4Element = 4;
pub const dM4E__Y_MIN: dMat4Element = 4;
pub const dM4E_YX: dMat4Element = 4;
pub const dM4E_YY: dMat4Element = 5;
pub const dM4E_YZ: dMat4Element = 6;
pub const dM4E_YO: dMat4Element = 7;
pub const dM4E__Y_MAX: dMat4Element = 8;
pub const dM4E__Z_MIN: dMat4Element = 8;
pub const dM4E_ZX: dMat4Element = 8;
pub const dM4E_ZY: dMat4Element = 9;
pub const dM4E_ZZ: dMat4Element = 10;
pub const dM4E_ZO: dMat4Element = 11;
pub const dM4E__Z_MAX: dMat4Element = 12;
pub const dM4E__O_MIN: dMat4Element = 12;
pub const dM4E_OX: dMat4Element = 12;
pub const dM4E_OY: dMat4Element = 13;
pub const dM4E_OZ: dMat4Element = 14;
pub const dM4E_OO: dMat4Element = 15;
pub const dM4E__O_MAX: dMat4Element = 16;
pub const dM4E__MAX: dMat4Element = 16;
/// Elements of a quaternion: the real part R first, then the vector part I, J, K.
pub type dQuatElement = c_uint;
pub const dQUE__MIN: dQuatElement = 0;
pub const dQUE_R: dQuatElement = 0;
pub const dQUE__AXIS_MIN: dQuatElement = 1;
pub const dQUE_I: dQuatElement = 1;
pub const dQUE_J: dQuatElement = 2;
pub const dQUE_K: dQuatElement = 3;
pub const dQUE__AXIS_MAX: dQuatElement = 4;
pub const dQUE__MAX: dQuatElement = 4;
pub const d_ERR_UNKNOWN: c_int = 0;
/// the library's own assumption failed
pub const d_ERR_IASSERT: c_int = 1;
/// an argument was refused
pub const d_ERR_UASSERT: c_int = 2;
/// trouble in a constraint solver
pub const d_ERR_LCP: c_int = 3;
pub const dParamLoStop: c_int = 0;
pub const dParamHiStop: c_int = 1;
pub const dParamVel: c_int = 2;
pub const dParamLoVel: c_int = 3;
pub const dParamHiVel: c_int = 4;
pub const dParamFMax: c_int = 5;
pub const dParamFudgeFactor: c_int = 6;
pub const dParamBounce: c_int = 7;
pub const dParamCFM: c_int = 8;
pub const dParamStopERP: c_int = 9;
pub const dParamStopCFM: c_int = 10;
pub const dParamSuspensionERP: c_int = 11;
pub const dParamSuspensionCFM: c_int = 12;
pub const dParamERP: c_int = 13;
/// how many there are in a block
pub const dParamsInGroup: c_int = 14;
pub const dParamGroup1: c_int = 0;
pub const dParamLoStop1: c_int = 0;
pub const dParamHiStop1: c_int = 1;
pub const dParamVel1: c_int = 2;
pub const dParamLoVel1: c_int = 3;
pub const dParamHiVel1: c_int = 4;
pub const dParamFMax1: c_int = 5;
pub const dParamFudgeFactor1: c_int = 6;
pub const dParamBounce1: c_int = 7;
pub const dParamCFM1: c_int = 8;
pub const dParamStopERP1: c_int = 9;
pub const dParamStopCFM1: c_int = 10;
pub const dParamSuspensionERP1: c_int = 11;
pub const dParamSuspensionCFM1: c_int = 12;
pub const dParamERP1: c_int = 13;
pub const dParamGroup2: c_int = 256;
pub const dParamLoStop2: c_int = 256;
pub const dParamHiStop2: c_int = 257;
pub const dParamVel2: c_int = 258;
pub const dParamLoVel2: c_int = 259;
pub const dParamHiVel2: c_int = 260;
pub const dParamFMax2: c_int = 261;
pub const dParamFudgeFactor2: c_int = 262;
pub const dParamBounce2: c_int = 263;
pub const dParamCFM2: c_int = 264;
pub const dParamStopERP2: c_int = 265;
pub const dParamStopCFM2: c_int = 266;
pub const dParamSuspensionERP2: c_int = 267;
pub const dParamSuspensionCFM2: c_int = 268;
pub const dParamERP2: c_int = 269;
pub const dParamGroup3: c_int = 512;
pub const dParamLoStop3: c_int = 512;
pub const dParamHiStop3: c_int = 513;
pub const dParamVel3: c_int = 514;
pub const dParamLoVel3: c_int = 515;
pub const dParamHiVel3: c_int = 516;
pub const dParamFMax3: c_int = 517;
pub const dParamFudgeFactor3: c_int = 518;
pub const dParamBounce3: c_int = 519;
pub const dParamCFM3: c_int = 520;
pub const dParamStopERP3: c_int = 521;
pub const dParamStopCFM3: c_int = 522;
pub const dParamSuspensionERP3: c_int = 523;
pub const dParamSuspensionCFM3: c_int = 524;
pub const dParamERP3: c_int = 525;
/// distance of the blocks
pub const dParamGroup: c_int = 256;
/// the program sets axes and angles
pub const dAMotorUser: c_int = 0;
/// axes and angles follow from the bodies' orientations
pub const dAMotorEuler: c_int = 1;
pub const dTransmissionParallelAxes: c_int = 0;
pub const dTransmissionIntersectingAxes: c_int = 1;
pub const dTransmissionChainDrive: c_int = 2;
/// mu2 for friction direction 2 (else mu for both)
pub const dContactMu2: c_int = 1;
/// same bit; with dContactRolling also rho2 and rhoN
pub const dContactAxisDep: c_int = 1;
/// fdir1 gives friction direction 1
pub const dContactFDir1: c_int = 2;
/// bounce and bounce\_vel
pub const dContactBounce: c_int = 4;
/// soft\_erp instead of the world's ERP, normal direction
pub const dContactSoftERP: c_int = 8;
/// soft\_cfm instead of the world's CFM, normal direction
pub const dContactSoftCFM: c_int = 16;
/// motion1: the surface moves along direction 1
pub const dContactMotion1: c_int = 32;
/// motion2
pub const dContactMotion2: c_int = 64;
/// motionN: along the normal
pub const dContactMotionN: c_int = 128;
/// slip1: force-dependent slip along direction 1
pub const dContactSlip1: c_int = 256;
/// slip2
pub const dContactSlip2: c_int = 512;
/// rho (rho2, rhoN): friction against rolling and spinning
pub const dContactRolling: c_int = 1024;
/// mu is a force in newtons
pub const dContactApprox0: c_int = 0;
/// mu times the normal force, direction 1
pub const dContactApprox1_1: c_int = 4096;
/// the same for direction 2
pub const dContactApprox1_2: c_int = 8192;
/// the same for spinning about the normal
pub const dContactApprox1_N: c_int = 16384;
/// all three
pub const dContactApprox1: c_int = 28672;
pub const dGeomCommonControlClass: c_int = 0;
pub const dGeomColliderControlClass: c_int = 1;
pub const dGeomCommonAnyControlCode: c_int = 0;
pub const dGeomColliderSetMergeSphereContactsControlCode: c_int = 1;
pub const dGeomColliderGetMergeSphereContactsControlCode: c_int = 2;
pub const dGeomColliderMergeContactsValue__Default: c_int = 0;
pub const dGeomColliderMergeContactsValue_None: c_int = 1;
pub const dGeomColliderMergeContactsValue_Normals: c_int = 2;
pub const dGeomColliderMergeContactsValue_Full: c_int = 3;
pub const dMaxUserClasses: c_int = 4;
pub const dSphereClass: c_int = 0;
pub const dBoxClass: c_int = 1;
pub const dCapsuleClass: c_int = 2;
pub const dCylinderClass: c_int = 3;
pub const dPlaneClass: c_int = 4;
pub const dRayClass: c_int = 5;
pub const dConvexClass: c_int = 6;
pub const dGeomTransformClass: c_int = 7;
pub const dTriMeshClass: c_int = 8;
pub const dHeightfieldClass: c_int = 9;
pub const dFirstSpaceClass: c_int = 10;
pub const dSimpleSpaceClass: c_int = 10;
pub const dHashSpaceClass: c_int = 11;
pub const dSweepAndPruneSpaceClass: c_int = 12;
pub const dQuadTreeSpaceClass: c_int = 13;
pub const dLastSpaceClass: c_int = 13;
pub const dFirstUserClass: c_int = 14;
pub const dLastUserClass: c_int = 17;
pub const dGeomNumClasses: c_int = 18;
pub const dTRIMESHDATA__MIN: c_int = 0;
/// three dReal per triangle
pub const dTRIMESHDATA_FACE_NORMALS: c_int = 0;
/// a byte of dMESHDATAUSE\_ bits per triangle
pub const dTRIMESHDATA_USE_FLAGS: c_int = 1;
pub const dTRIMESHDATA__MAX: c_int = 2;
pub const TRIMESH_FACE_NORMALS: c_int = 0;
pub const dMESHDATAUSE_EDGE1: c_int = 1;
pub const dMESHDATAUSE_EDGE2: c_int = 2;
pub const dMESHDATAUSE_EDGE3: c_int = 4;
pub const dMESHDATAUSE_VERTEX1: c_int = 8;
pub const dMESHDATAUSE_VERTEX2: c_int = 16;
pub const dMESHDATAUSE_VERTEX3: c_int = 32;
pub const dTRIDATAPREPROCESS_BUILD__MIN: c_int = 0;
pub const dTRIDATAPREPROCESS_BUILD_CONCAVE_EDGES: c_int = 0;
pub const dTRIDATAPREPROCESS_BUILD_FACE_ANGLES: c_int = 1;
pub const dTRIDATAPREPROCESS_BUILD__MAX: c_int = 2;
pub const dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__MIN: c_int = 0;
pub const dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA_BYTE_POSITIVE: c_int = 0;
pub const dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA_BYTE_ALL: c_int = 1;
pub const dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA_WORD_ALL: c_int = 2;
pub const dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__MAX: c_int = 3;
pub const dTRIDATAPREPROCESS_FACE_ANGLES_EXTRA__DEFAULT: c_int = 0;
pub const dMaxCouplingAxes: c_int = 8;
/// the rotation vector
pub const dAMotorTurn: c_int = 2;
pub const dFractureMaxParts: c_int = 4096;
pub const dRagdollMaxBones: c_int = 128;
pub const dConeClass: c_int = 18;
pub const dEllipsoidClass: c_int = 19;
pub const dTaperedCapsuleClass: c_int = 20;
pub const dVehicleMaxTorquePoints: c_int = 16;
pub const dVehicleMaxGears: c_int = 10;
pub const dVehicleMaxWheels: c_int = 32;
/// What dJointGetType answers.
pub type dJointType = c_uint;
pub const dJointTypeNone: dJointType = 0;
pub const dJointTypeBall: dJointType = 1;
pub const dJointTypeHinge: dJointType = 2;
pub const dJointTypeSlider: dJointType = 3;
pub const dJointTypeContact: dJointType = 4;
pub const dJointTypeUniversal: dJointType = 5;
pub const dJointTypeHinge2: dJointType = 6;
pub const dJointTypeFixed: dJointType = 7;
pub const dJointTypeNull: dJointType = 8;
pub const dJointTypeAMotor: dJointType = 9;
pub const dJointTypeLMotor: dJointType = 10;
pub const dJointTypePlane2D: dJointType = 11;
pub const dJointTypePR: dJointType = 12;
pub const dJointTypePU: dJointType = 13;
pub const dJointTypePiston: dJointType = 14;
pub const dJointTypeDBall: dJointType = 15;
pub const dJointTypeDHinge: dJointType = 16;
pub const dJointTypeTransmission: dJointType = 17;
pub const dJointTypeCoupling: dJointType = 18;
/// The corners of a triangle.
pub type dMeshTriangleVertex = c_uint;
pub const dMTV__MIN: dMeshTriangleVertex = 0;
pub const dMTV_FIRST: dMeshTriangleVertex = 0;
pub const dMTV_SECOND: dMeshTriangleVertex = 1;
pub const dMTV_THIRD: dMeshTriangleVertex = 2;
pub const dMTV__MAX: dMeshTriangleVertex = 3;
/// What a character stands on.
pub type dCharacterState = c_uint;
/// on nothing
pub const dCharacterInAir: dCharacterState = 1;
/// it touches ground steeper than the slope limit, and nothing better
pub const dCharacterOnSteep: dCharacterState = 2;
/// it stands
pub const dCharacterOnGround: dCharacterState = 3;
/// How a coefficient of a pair follows from those of its two geoms. If their rules differ, the one that is
/// listed later here counts.
pub type dCombineRule = c_uint;
/// friction: the geometric mean; bounce and rolling friction: the larger
pub const dCombineDefault: dCombineRule = 0;
/// half the sum
pub const dCombineAverage: dCombineRule = 1;
/// the smaller
pub const dCombineMinimum: dCombineRule = 2;
/// the product
pub const dCombineProduct: dCombineRule = 3;
/// the larger
pub const dCombineMaximum: dCombineRule = 4;
/// What has happened to a pair in the last step.
pub type dContactEventKind = c_uint;
/// the geoms touch and did not before
pub const dContactBegin: dContactEventKind = 0;
/// they touch and did before
pub const dContactPersist: dContactEventKind = 1;
/// they touched before and do not
pub const dContactEnd: dContactEventKind = 2;
/// What a world is for. docs/guide/defaults.md has the values of each.
pub type dDefaults = c_uint;
/// as ODE begins: the values of a new world
pub const dDefaultsOde: dDefaults = 0;
/// piles, stacks, figures, vehicles: steps of 1/60 s, robust and quick, bodies sleep
pub const dDefaultsGame: dDefaults = 1;
/// machines and robots: steps of 0.001 to 0.005 s, joints exact, nothing sleeps
pub const dDefaultsRobot: dDefaults = 2;
/// Versions of the behaviour of worlds: a hundred times the major number, plus the minor one.
pub type dBehaviour = c_uint;
/// ODE 0.16, where the two differ in the results of a world and it can be had
pub const dBehaviour016: dBehaviour = 16;
/// this library's first, the default
pub const dBehaviour1: dBehaviour = 100;
/// Causes of failure. \`figure\` and \`threshold\` of a dDiagnosis are in the unit that is named here.
pub type dDiagnosisKind = c_uint;
/// the program set a huge velocity or force: m/s that it set or adds in a step;
/// or a call was refused: refusals before a step
pub const dDiagnosisInput: dDiagnosisKind = 0;
/// inertia far from the shapes': its radius over theirs; or not that of a body:
/// largest moment over the sum of the others
pub const dDiagnosisInertia: dDiagnosisKind = 1;
/// geoms started in each other: depth over the thinner one's half thickness
pub const dDiagnosisOverlap: dDiagnosisKind = 2;
/// joints that cannot hold together: error that stays, m or rad
pub const dDiagnosisContradiction: dDiagnosisKind = 3;
/// the program's force overshoots in each step: h^2 k/m; 4 is unstable
pub const dDiagnosisStiffSpring: dDiagnosisKind = 4;
/// the body rotates, or would swing under its load, too far in a step: rad
pub const dDiagnosisStepTooLong: dDiagnosisKind = 5;
/// a light body carries heavy ones: mass over mass
pub const dDiagnosisMassRatio: dDiagnosisKind = 6;
/// a body has passed through a geom: distance over its half thickness
pub const dDiagnosisTunnelling: dDiagnosisKind = 7;
/// contact so fast that it is found too late: travel over half thickness
pub const dDiagnosisImpact: dDiagnosisKind = 8;
/// energy from nowhere: J gained over J there was
pub const dDiagnosisEnergy: dDiagnosisKind = 9;
/// How sure it is that this is harmful.
pub type dSeverity = c_uint;
/// worth knowing if something looks wrong
pub const dSeverityNote: dSeverity = 0;
/// likely to be seen
pub const dSeverityWarning: dSeverity = 1;
/// the simulation is wrong
pub const dSeverityError: dSeverity = 2;
/// Kinds of events.
pub type dEventKind = c_uint;
/// the geoms touch and did not before
pub const dEventContactBegin: dEventKind = 0;
/// they touch and did before
pub const dEventContactPersist: dEventKind = 1;
/// they touched before and do not
pub const dEventContactEnd: dEventKind = 2;
/// a geom overlaps a sensor at the end of the step and did not before
pub const dEventSensorBegin: dEventKind = 3;
/// it did before and does not
pub const dEventSensorEnd: dEventKind = 4;
/// a joint broke (dJointSetBreakLimits)
pub const dEventJointBreak: dEventKind = 5;
/// Which objects of an event no longer exist. Their handles are those that they had: names to compare with,
/// which every function refuses.
pub type dEventGone = c_uint;
/// g1 has been destroyed
pub const dEventGoneG1: dEventGone = 1;
/// g2 has been destroyed
pub const dEventGoneG2: dEventGone = 2;
/// joint has been destroyed
pub const dEventGoneJoint: dEventGone = 4;
/// How a radial impulse decreases with the distance r from its centre, up to its radius R.
pub type dFalloff = c_uint;
/// it does not
pub const dFalloffNone: dFalloff = 0;
/// 1 - r / R
pub const dFalloffLinear: dFalloff = 1;
/// (1 - r / R)^2
pub const dFalloffQuadratic: dFalloff = 2;
/// The shape of a bone.
pub type dBoneShape = c_uint;
/// along the bone's z: radius, length of the cylinder
pub const dBoneCapsule: dBoneShape = 0;
/// three sides
pub const dBoneBox: dBoneShape = 1;
/// radius
pub const dBoneSphere: dBoneShape = 2;
/// What connects a bone with its parent.
pub type dBoneJoint = c_uint;
/// turns about its axis
pub const dBoneHinge: dBoneJoint = 0;
/// swings about two axes and does not twist about its own
pub const dBoneUniversal: dBoneJoint = 1;
/// swings and twists: a ball joint, and an angular motor that has limits and drives
pub const dBoneBall: dBoneJoint = 2;
/// does not turn
pub const dBoneFixed: dBoneJoint = 3;
/// How an island was solved.
pub type dIslandMethod = c_uint;
/// nothing to solve
pub const dIslandMethodNone: dIslandMethod = 0;
/// exact: active set on the dense matrix of a small island
pub const dIslandMethodDense: dIslandMethod = 1;
/// exact: active set on the sparse matrix
pub const dIslandMethodActiveSet: dIslandMethod = 2;
/// exact: interior point, then the active set from its answer
pub const dIslandMethodInteriorPoint: dIslandMethod = 3;
/// dWorldQuickStep
pub const dIslandMethodSweeps: dIslandMethod = 4;
/// dWorldStepFast1
pub const dIslandMethodSubsteps: dIslandMethod = 5;
/// substeps with all joints solved together
pub const dIslandMethodSubstepsExactJoints: dIslandMethod = 6;
/// exact: in joint coordinates (dWorldSetJointCoordinates)
pub const dIslandMethodJointCoordinates: dIslandMethod = 7;
/// Ends of a rope that are fastened.
pub type dRopeEnds = c_uint;
/// none
pub const dRopeLoose: dRopeEnds = 0;
/// the first
pub const dRopeFrom: dRopeEnds = 1;
/// the last
pub const dRopeTo: dRopeEnds = 2;
/// both
pub const dRopeBoth: dRopeEnds = 3;
/// What steps do about the path of a geom from one place to the next.
pub type dContinuousMode = c_uint;
/// nothing: where it ends is what counts
pub const dContinuousOff: dContinuousMode = 0;
/// it does not pass what it meets
pub const dContinuousOn: dContinuousMode = 1;
/// continuous geoms may pass it: sensors
pub const dContinuousIgnored: dContinuousMode = 2;
/// The parts of a body's state that arrays hold, in this order, added up; as many numbers of each as the text
/// says.
pub type dStateField = c_uint;
/// 3, m
pub const dStatePosition: dStateField = 1;
/// 4: w x y z
pub const dStateQuaternion: dStateField = 2;
/// 3, m/s
pub const dStateLinearVel: dStateField = 4;
/// 3, rad/s
pub const dStateAngularVel: dStateField = 8;
/// 3: accumulated for the next step, N
pub const dStateForce: dStateField = 16;
/// 3: likewise, N m
pub const dStateTorque: dStateField = 32;
/// 1: 1 or 0
pub const dStateEnabled: dStateField = 64;
/// How a world, or an island of it, is stepped; from the most exact on.
pub type dStepper = c_uint;
/// each island in its own way: as dWorldStepHybrid does
pub const dStepperHybrid: dStepper = 0;
/// as dWorldStep does
pub const dStepperExact: dStepper = 1;
/// in substeps, with all joints of an island solved together and exactly
pub const dStepperSubstepsExactJoints: dStepper = 2;
/// in substeps, as dWorldStepFast1 does; exact joints where sweeps fail
pub const dStepperSubsteps: dStepper = 3;
/// as dWorldQuickStep does
pub const dStepperQuick: dStepper = 4;
/// How a vehicle is driven and steered.
pub type dVehicleKind = c_uint;
/// by the angles of its wheels
pub const dVehicleCar: dVehicleKind = 1;
/// likewise, and it leans into curves by itself
pub const dVehicleBike: dVehicleKind = 2;
/// the wheels of each side turn together; the sides turn differently to steer
pub const dVehicleTracked: dVehicleKind = 3;
/// How a wheel finds what it stands on.
pub type dWheelCast = c_uint;
/// a ray through its hub: a disc on a plane. The cheapest
pub const dWheelRay: dWheelCast = 1;
/// a sphere of its radius: rolls over edges and kerbs
pub const dWheelSphere: dWheelCast = 2;
/// a cylinder of its radius and width: likewise, with its true outline
pub const dWheelCylinder: dWheelCast = 3;
/// How a differential divides: between the two wheels of an axle, or between axles.
pub type dDifferential = c_uint;
/// the same torque at any difference of speeds
pub const dDifferentialOpen: dDifferential = 1;
/// a clutch with at most the lock torque works against a difference
pub const dDifferentialLimited: dDifferential = 2;
/// one speed
pub const dDifferentialLocked: dDifferential = 3;
/// Flags of dInitODE2.
pub type dInitODEFlags = c_uint;
/// threads call dCleanupODEAllDataForThread themselves
pub const dInitFlagManualThreadCleanup: dInitODEFlags = 1;
/// Flags of dAllocateODEDataForThread.
pub type dAllocateODEDataFlags = c_int;
/// what every call may need
pub const dAllocateFlagBasicData: dAllocateODEDataFlags = 0;
/// what dCollide may need
pub const dAllocateFlagCollisionData: dAllocateODEDataFlags = 1;
/// everything
pub const dAllocateMaskAll: dAllocateODEDataFlags = -1;
/// What a joint did in the last step: force (N) and torque about the body's centre (N m), world
/// frame, on the first (f1, t1) and second (f2, t2) body. See dJointSetFeedback.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dJointFeedback {
    /// force on body 1
    pub f1: dVector3,
    /// torque on body 1
    pub t1: dVector3,
    /// force on body 2
    pub f2: dVector3,
    /// torque on body 2
    pub t2: dVector3,
}
/// How the surfaces behave. mode and mu must always be set.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dSurfaceParameters {
    /// dContact... bits
    pub mode: c_int,
    /// friction: a force (N), or a coefficient with Approx1; dInfinity never slips; \< 0 acts as 0
    pub mu: dReal,
    /// friction along direction 2
    pub mu2: dReal,
    /// rolling friction about direction 1 (about all three without AxisDep): torque (N m), or a
    /// length (m) with Approx1
    pub rho: dReal,
    /// rolling friction about direction 2
    pub rho2: dReal,
    /// spinning friction about the normal
    pub rhoN: dReal,
    /// restitution, 0 none ... 1 full
    pub bounce: dReal,
    /// least approach speed for a bounce, m/s; negative: never
    pub bounce_vel: dReal,
    /// part of the penetration corrected per step
    pub soft_erp: dReal,
    /// softness, (m/s)/N times the step size; with soft\_erp a spring and damper
    pub soft_cfm: dReal,
    /// wanted velocity of body 1 relative to body 2 along direction 1, m/s
    pub motion1: dReal,
    /// the same along direction 2
    pub motion2: dReal,
    /// the same along the normal
    pub motionN: dReal,
    /// slip velocity per friction force along direction 1, (m/s)/N
    pub slip1: dReal,
    /// the same along direction 2
    pub slip2: dReal,
}
/// Where the shapes meet. World frame.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dContactGeom {
    /// contact position, m
    pub pos: dVector3,
    /// unit vector into g1: moving g1 by depth \* normal parts the shapes
    pub normal: dVector3,
    /// penetration along the normal, m, \>= 0; for a ray the distance from its start
    pub depth: dReal,
    /// the first shape
    pub g1: dGeomID,
    /// the second shape
    pub g2: dGeomID,
    /// sub-element of g1 that was hit (triangle number), -1 when there is none
    pub side1: c_int,
    /// the same of g2
    pub side2: c_int,
}
/// Everything about one contact.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dContact {
    /// how the surfaces behave
    pub surface: dSurfaceParameters,
    /// where the shapes meet
    pub geom: dContactGeom,
    /// friction direction 1: unit, perpendicular to the normal, world frame; read with
    /// dContactFDir1 only
    pub fdir1: dVector3,
}
/// A class of the program's own. collider and aabb must be given, the other functions may be 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dGeomClass {
    /// size of the class's data in each geom
    pub bytes: c_int,
    /// gives the functions that find contacts
    pub collider: dGetColliderFnFn,
    /// computes the bounding box
    pub aabb: dGetAABBFn,
    /// saves closer tests, or 0
    pub aabb_test: dAABBTestFn,
    /// called when a geom is destroyed, or 0
    pub dtor: dGeomDtorFn,
}
/// What a query finds. A geom is left out if its bits do not agree, if it is on skip\_body, or if the
/// callback rejects it. The same bits are asked of nested spaces, for all that is in them. Each field ends
/// with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dQueryFilter {
    /// sizeof(dQueryFilter), set by the caller or dQueryFilterInit
    pub struct_size: c_uint,
    /// finds geoms whose collide bits have one of these ... \~0ul
    pub category_bits: c_ulong,
    /// ... or whose category bits have one of these. \~0ul
    pub collide_bits: c_ulong,
    /// leave the geoms of this body out; 0: none. 0
    pub skip_body: dBodyID,
    /// has the last word; 0: none. 0
    pub callback: dQueryCallback,
    /// for the callback. 0
    pub data: *mut c_void,
    /// 1: casts of shapes leave out what overlaps the shape at the beginning, of meshes and
    /// height fields those triangles. 0
    pub skip_overlaps: c_int,
}
/// What a query has hit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dQueryHit {
    /// the geom that was hit; 0: none, and all else is 0
    pub geom: dGeomID,
    /// where, in the world
    pub pos: dVector3,
    /// unit, out of that geom's surface, against the ray or the motion
    pub normal: dVector3,
    /// from the beginning of the ray or of the motion, m
    pub distance: dReal,
    /// triangle of a mesh, as dContactGeom::side2; -1: it has none
    pub side: c_int,
}
/// How far two geoms are from each other.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dQueryDistance {
    /// m; below 0: they overlap, and this is minus the depth
    pub distance: dReal,
    /// of o1, the point nearest to o2, or deepest in it, in the world
    pub pos1: dVector3,
    /// of o2 the point that belongs to it: pos1 - pos2 = distance \* normal
    pub pos2: dVector3,
    /// unit, from o2 into o1
    pub normal: dVector3,
    /// the geom of pos1: o1, or what lies in it if it is a space or a transform
    pub g1: dGeomID,
    /// the same of pos2
    pub g2: dGeomID,
    /// its triangle if g1 is a mesh, else -1
    pub side1: c_int,
    /// the same of g2
    pub side2: c_int,
}
/// What a cast of a shape has hit.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dCastHit {
    /// the geom that was hit
    pub geom: dGeomID,
    /// where, in the world
    pub pos: dVector3,
    /// unit, out of that geom: along it the two are nearest to each other
    pub normal: dVector3,
    /// from the beginning of the motion, m
    pub distance: dReal,
    /// triangle of a mesh; -1: it has none
    pub side: c_int,
    /// unit, of the face that was hit; of an edge or corner, of the face there that is
    /// most against the motion. Round geoms: normal
    pub face_normal: dVector3,
    /// of an overlap at the beginning, m; else 0
    pub depth: dReal,
}
/// What a character is and does. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dCharacterSettings {
    /// sizeof(dCharacterSettings), set by the caller or dCharacterSettingsInit
    pub struct_size: c_uint,
    /// dCapsuleClass, dCylinderClass or dBoxClass. dCapsuleClass
    pub shape: c_int,
    /// m; of a box, half the side of its square base. 0.3
    pub radius: dReal,
    /// m, from the feet to the top; of a capsule at least 2 radius. 1.8
    pub height: dReal,
    /// of any length but 0. (0, 0, 1)
    pub up: dVector3,
    /// of dCharacterWalk, m/s^2, 0 or more. 9.81
    pub gravity: dReal,
    /// the gap that it keeps, m, above 0 and at most radius / 4. 0.01
    pub skin: dReal,
    /// the steepest ground that it can stand on, rad, 0 ... 1.5. 0.87 (50 degrees)
    pub slope_limit: dReal,
    /// of steps that it climbs, m, 0 or more. 0.3
    pub step_height: dReal,
    /// how far down it follows ground that falls away, m, 0 or more. 0.3
    pub stick_distance: dReal,
    /// weighs with \`gravity\` on bodies that it stands on, kg; 0: nothing. 70
    pub mass: dReal,
    /// that it pushes bodies with, N, 0 or more, not infinite. 500
    pub max_force: dReal,
    /// of dCharacterWalk, how fast it turns in the air, m/s^2, 0 or more. 10
    pub air_acceleration: dReal,
    /// has the last word; 0: none. 0
    pub filter: dCharacterFilter,
    /// for the filter. 0
    pub data: *mut c_void,
}
/// What the last move has done. Without ground, its fields are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dCharacterReport {
    /// sizeof(dCharacterReport), set by the caller
    pub struct_size: c_uint,
    /// a dCharacterState; 0: it has not moved yet
    pub state: c_int,
    /// how it has really moved, m/s, with what carries it
    pub velocity: dVector3,
    /// the geom that it stands on or slides on; 0: none, or it is destroyed
    pub ground: dGeomID,
    /// its triangle if it is a mesh, else -1
    pub ground_side: c_int,
    /// where
    pub ground_pos: dVector3,
    /// unit, of the surface: of a face, not of its edge
    pub ground_normal: dVector3,
    /// of the ground at that point, m/s
    pub ground_velocity: dVector3,
    /// angle by which the ground has turned it, about up, rad
    pub turn: dReal,
    /// height of the steps that it has climbed, m
    pub climbed: dReal,
    /// 1: something steep was in its way
    pub hit_wall: c_int,
    /// 1: something above was
    pub hit_ceiling: c_int,
    /// depth that it could not be freed from, m; 0: none.
    pub overlap: dReal,
}
/// The surface of a geom. For a pair, friction, bounce and rolling friction follow the rules; the bounce
/// speed is the larger one, velocities of surfaces are subtracted, and compliances add up, as of springs in
/// series. A compliant contact is held, beyond the surface layer and in all steppers, by a spring of
/// stiffness 1/compliance and a damper of damping\_time/compliance at each of its points. Stiffer than 1e9
/// N/m counts as rigid. A surface with a friction axis, seen in the contact plane, bounds friction by the
/// ellipse of its two coefficients; what slides is braked by the point of it that takes most power. Of two
/// such surfaces the one whose coefficients differ more gives the axis. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dMaterial {
    /// sizeof(dMaterial), set by the caller or dMaterialInit
    pub struct_size: c_uint,
    /// coefficient of Coulomb friction, 0 ... dInfinity (does not slide). 0.6
    pub friction: dReal,
    /// restitution: share of the approach speed that comes back, 0 ... 1. 0
    pub bounce: dReal,
    /// slower approaches do not rebound, m/s. 1
    pub bounce_speed: dReal,
    /// of the surface against the geom, in the geom's frame, m/s: a belt. 0
    pub surface_velocity: dVector3,
    /// largest torque against rolling and spinning, per normal force, m. 0
    pub rolling_friction: dReal,
    /// depth per force at a point, m/N; 0: rigid. 0
    pub compliance: dReal,
    /// of a compliant surface: damping over stiffness, s. 0
    pub damping_time: dReal,
    /// a dCombineRule for friction. dCombineDefault
    pub friction_rule: c_int,
    /// for bounce. dCombineDefault
    pub bounce_rule: c_int,
    /// for rolling friction. dCombineDefault
    pub rolling_friction_rule: c_int,
    /// the geom of the larger one says friction, bounce and rolling friction alone. 0
    pub priority: c_int,
    /// coefficient across friction\_axis, where that is not 0. 0.6
    pub cross_friction: dReal,
    /// in the geom's frame: friction counts along it; 0: in all directions. 0
    pub friction_axis: dVector3,
    /// 1 ... 255: the other geom's material of that number counts alone, if it has one. 0
    pub kind: c_int,
}
/// One contact manifold for the coming step: points of two geoms with one normal. A function of the program
/// changes what begins with accept, for this step alone; the rest is for it to read. What it sets to numbers
/// that no dMaterial may have stays as the materials say. Its fields only grow at the end.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dManifold {
    /// of the library's dManifold
    pub struct_size: c_uint,
    /// has a body
    pub g1: dGeomID,
    /// the other one
    pub g2: dGeomID,
    /// 1: the two touched in the last step, too
    pub touched: c_int,
    /// how many points, 1 ... 4
    pub count: c_int,
    /// of the points, world, m
    pub pos: [dVector3; 4],
    /// of the points, m; below 0: a gap that the step may close
    pub depth: [dReal; 4],
    /// unit, into g1
    pub normal: dVector3,
    /// of g1 against g2 at the mean of the points, m/s
    pub velocity: dVector3,
    /// 0: the two pass through each other here. 1
    pub accept: c_int,
    /// coefficient; infinity: it does not slide
    pub friction: dReal,
    /// restitution, 0 ... 1
    pub bounce: dReal,
    /// slower approaches do not rebound, m/s
    pub bounce_speed: dReal,
    /// m
    pub rolling_friction: dReal,
    /// of each point, m/N; 0: rigid
    pub compliance: dReal,
    /// of a compliant point, s
    pub damping_time: dReal,
    /// velocity of g1 against g2 that friction aims at, world, m/s
    pub surface_velocity: dVector3,
    /// coefficient across friction\_axis
    pub cross_friction: dReal,
    /// world: friction counts along it; 0: in all directions
    pub friction_axis: dVector3,
    /// sum of the normal impulses in the step at most, N s; a share of each point, the
    /// same for all. dInfinity
    pub max_impulse: dReal,
}
/// One pair in one step. Elements of arrays, such as this, dWorldContact and dQueryHit, have no
/// struct\_size: their fields never change, and what may be added one day gets functions of its own.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dContactEvent {
    /// what has happened
    pub kind: dContactEventKind,
    /// has a body
    pub g1: dGeomID,
    /// the other one; both are 0 if destroyed since the step
    pub g2: dGeomID,
}
/// A point of contact in the last step.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dWorldContact {
    /// has a body
    pub g1: dGeomID,
    /// the other one; both are 0 if destroyed since the step
    pub g2: dGeomID,
    /// where, in the world, at the step's beginning, m
    pub pos: dVector3,
    /// unit, into g1
    pub normal: dVector3,
    /// at the step's beginning; below 0: the gap that the step has closed, m
    pub depth: dReal,
    /// along the normal, the mean over the step, N
    pub normal_force: dReal,
    /// on g1, N
    pub friction_force: dVector3,
}
/// A span of time: seconds and nanoseconds.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dThreadedWaitTime {
    /// seconds
    pub wait_sec: time_t,
    /// nanoseconds, below 10^9
    pub wait_nsec: c_ulong,
}
/// The table. struct\_size: sizeof(dThreadingFunctionsInfo), set by who fills it. No function may be missing.
/// A step uses, on the thread that calls it: retrieve\_thread\_count, preallocate\_resources\_for\_calls,
/// alloc\_call\_wait; for each of its parallel parts reset\_call\_wait, post\_call, wait\_call; free\_call\_wait.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dThreadingFunctionsInfo {
    /// sizeof(dThreadingFunctionsInfo)
    pub struct_size: c_uint,
    /// makes mutexes
    pub alloc_mutex_group: dMutexGroupAllocFunction,
    /// frees them
    pub free_mutex_group: dMutexGroupFreeFunction,
    /// locks one
    pub lock_group_mutex: dMutexGroupMutexLockFunction,
    /// unlocks one
    pub unlock_group_mutex: dMutexGroupMutexUnlockFunction,
    /// makes something to wait on
    pub alloc_call_wait: dThreadedCallWaitAllocFunction,
    /// makes it fit for another use
    pub reset_call_wait: dThreadedCallWaitResetFunction,
    /// frees it
    pub free_call_wait: dThreadedCallWaitFreeFunction,
    /// takes a call
    pub post_call: dThreadedCallPostFunction,
    /// changes how many calls come first
    pub alter_call_dependencies_count: dThreadedCallDependenciesCountAlterFunction,
    /// waits
    pub wait_call: dThreadedCallWaitFunction,
    /// tells how many threads serve
    pub retrieve_thread_count: dThreadingImplThreadCountRetrieveFunction,
    /// makes room
    pub preallocate_resources_for_calls: dThreadingImplResourcesForCallsPreallocateFunction,
}
/// One cause. Elements of arrays, such as this, have no struct\_size. Objects may have been destroyed since;
/// those that the cause does not concern are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dDiagnosis {
    /// which cause: one of dDiagnosisKind
    pub kind: c_int,
    /// how harmful: one of dSeverity
    pub severity: c_int,
    /// the body to blame
    pub body: dBodyID,
    /// the other one
    pub other: dBodyID,
    /// the joint to blame
    pub joint: dJointID,
    /// the geom that was met
    pub geom: dGeomID,
    /// worst value, see dDiagnosisKind
    pub figure: f64,
    /// what it should stay below
    pub threshold: f64,
    /// step in which it was seen first, 1: the first one since the mode is on
    pub first_step: c_int,
    /// in how many steps it was seen
    pub steps: c_int,
    /// the function that was refused, a number for dDiagnosisText; 0: none was
    pub call: c_int,
}
/// A drive on one axis of a joint: a spring and damper towards a target, a given force, a rotor and dry
/// friction. With position q and rate w it exerts
///
/// force + stiffness (target - q) + damping (target\_velocity - w),   at most force\_limit,
///
/// and besides armature times the deceleration of w, and up to friction against w. All of it is implicit:
/// stiff springs stay stable at any step. Start from zeros: what is 0 is not there.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dDrive {
    /// sizeof(dDrive), set by the caller or dDriveInit
    pub struct_size: c_uint,
    /// N/m or N m/rad, 0 or more
    pub stiffness: dReal,
    /// N s/m or N m s/rad, 0 or more
    pub damping: dReal,
    /// rotor inertia times the gear ratio squared, kg or kg m^2, 0 or more
    pub armature: dReal,
    /// dry friction, N or N m, 0 or more
    pub friction: dReal,
    /// position that the spring pulls to, m or rad
    pub target: dReal,
    /// rate that the damper pulls to, m/s or rad/s
    pub target_velocity: dReal,
    /// feed-forward along the axis, N or N m: of a plain motor, all it does
    pub force: dReal,
    /// of spring, damper and force together, N or N m; 0, dInfinity: none
    pub force_limit: dReal,
}
/// One event. Elements of arrays, such as this, have no struct\_size. What an event does not concern is 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dEvent {
    /// one of dEventKind
    pub kind: c_int,
    /// sum of dEventGone: which of the handles below are of destroyed objects
    pub gone: c_int,
    /// contacts: has a body; sensors: the sensor
    pub g1: dGeomID,
    /// the other geom
    pub g2: dGeomID,
    /// the joint that broke
    pub joint: dJointID,
    /// contacts: centre of the impulses, where the step has taken it; breaks: body 1's centre, m
    pub pos: dVector3,
    /// contacts: unit, into g1; breaks: direction of the force on body 1
    pub normal: dVector3,
    /// contacts: along the normal at the step's beginning, of the fastest point, m/s
    pub approach_speed: dReal,
    /// normal impulse, of a break that of the joint, over the whole step, N s
    pub impulse: dReal,
}
/// Which events a world lists. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dEventSettings {
    /// sizeof(dEventSettings), set by the caller or dEventSettingsInit
    pub struct_size: c_uint,
    /// sum of 1 \<\< dEventKind. All but dEventContactPersist
    pub kinds: c_uint,
    /// events of a step that are kept, 1 ... 1048576. 1024
    pub capacity: c_int,
    /// begin and persist events of contacts below it are left out, N s. 0
    pub min_impulse: dReal,
    /// the same by their approach speed, m/s. 0
    pub min_approach_speed: dReal,
}
/// What a fluid exerts. With u the velocity of a solid's submerged part against the fluid and A the shadow of the solid along u
/// times its submerged share, the drag is (density/2 drag \|u\| + linear\_drag) A u. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dFluidSettings {
    /// sizeof(dFluidSettings), set by the caller or dFluidSettingsInit
    pub struct_size: c_uint,
    /// kg/m^3, 0 or more. 1000, water
    pub density: dReal,
    /// coefficient of drag by pressure, 0 or more; a ball has about 0.47. 1
    pub drag: dReal,
    /// drag proportional to the velocity, of skin and of waves, N s/m^3, 0 or more. 200
    pub linear_drag: dReal,
    /// times the drag against turning of a box of the solid's extents, 0 or more. 1
    pub angular_drag: dReal,
    /// velocity of the fluid, m/s, world. 0
    pub current: dVector3,
}
/// One part. Elements of arrays, such as this and dFracture, have no struct\_size.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dFracturePart {
    /// its shape, where it is
    pub geom: dGeomID,
    /// kg/m^3, 0 or more; 0: 1000
    pub density: dReal,
}
/// What may break, and when.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dFracture {
    /// the list; must live as long as the call
    pub parts: *const dFracturePart,
    /// of parts
    pub count: c_int,
    /// normal impulse of a blow of one other geom on one part that it withstands, N s, 0 or
    /// more; dInfinity: any. A resting load exerts its weight times the step
    pub strength: dReal,
    /// m: parts within this distance of the hardest contact come off, each alone
    pub radius: dReal,
}
/// A bone, and the joint with its parent. Elements of arrays, such as this, have no struct\_size. Zeros are
/// a good start: what is 0 is not there, but for what a field says. Places and directions are in one frame
/// of the whole figure, in any pose within the limits.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dBone {
    /// number of an earlier bone; -1 for bone 0, which has none
    pub parent: c_int,
    /// a dBoneShape
    pub shape: c_int,
    /// as dBoneShape says, m, above 0
    pub size: dVector3,
    /// kg, 0 or more; 0: as density says
    pub mass: dReal,
    /// kg/m^3, 0 or more; 0: 1000
    pub density: dReal,
    /// of the centre, m
    pub position: dVector3,
    /// of the shape; zeros: none
    pub orientation: dQuaternion,
    /// a dBoneJoint
    pub joint: c_int,
    /// of the joint, m
    pub anchor: dVector3,
    /// not 0, of any length: the hinge's, or that of the twist, along the bone
    pub axis: dVector3,
    /// dBoneUniversal, dBoneBall: the first swing's, fixed in the parent; not along axis. What
    /// is along axis is taken away. The second is swing x axis, at right angles to both
    pub swing: dVector3,
    /// rad, of twist, second and first swing; a hinge has the first alone. -pi ... pi, of
    /// the second swing -1.5 ... 1.5
    pub low: [dReal; 3],
    /// likewise; where low is not below high, there is no limit
    pub high: [dReal; 3],
    /// of the motors that hold a pose, N m/rad, 0 or more
    pub stiffness: dReal,
    /// likewise, N m s/rad
    pub damping: dReal,
    /// the greatest torque of each, N m, 0 or more; 0: no limit
    pub strength: dReal,
    /// dry friction of each axis, N m, 0 or more
    pub friction: dReal,
}
/// What the last step of a world did. Sums and worst values over its islands. Lengths in m, angles in rad,
/// energies in J.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dWorldStepReport {
    /// sizeof(dWorldStepReport), set by the caller
    pub struct_size: c_uint,
    /// islands that were simulated
    pub islands: c_int,
    /// bodies in them
    pub bodies: c_int,
    /// joints in them that gave at least one row
    pub joints: c_int,
    /// constraint rows, all islands together
    pub rows: c_int,
    /// worst natural residual over the islands, relative; 0 = solved exactly
    pub residual: f64,
    /// solver iterations, or pivots of the exact solver, summed over islands
    pub iterations: c_int,
    /// islands that needed a more careful method than the first one
    pub fallbacks: c_int,
    /// islands kept from spreading bad numbers: velocities kept, forces zero
    pub contained_islands: c_int,
    /// sparse factorisations, summed over islands
    pub factorisations: c_int,
    /// worst distance that a joint should hold at zero, at the step's beginning
    pub joint_error: f64,
    /// the same for angles, rad
    pub joint_angle_error: f64,
    /// deepest contact beyond the surface layer, at the step's beginning
    pub penetration: f64,
    /// kinetic energy plus that of weight, at the step's beginning
    pub energy_before: f64,
    /// the same at its end, before the bodies' own damping
    pub energy_after: f64,
    /// Newton steps of dWorldSetStepProjection, summed over islands
    pub projection_iterations: c_int,
    /// islands that they left above the tolerance
    pub projections_unconverged: c_int,
    /// worst error that they left, in the unit of the tolerance
    pub projection_error: f64,
    /// bodies that continuous collision (dGeomSetContinuous) has stopped
    pub stopped_bodies: c_int,
    /// what friction is off Coulomb's, relative; dWorldStep with a cone
    pub friction_error: f64,
    /// light links whose inertia the step has raised, since it is too long for their loads
    pub raised_bodies: c_int,
    /// natural residual with the inertias as they are; \`residual\` if none is raised
    pub raised_residual: f64,
    /// the worst joint that contradicts others; it may be gone since. 0: none
    pub unsolved_joint: dJointID,
    /// how many do; dWorldStep and exact hybrid islands
    pub unsolved_joints: c_int,
}
/// What the last step did with one island. Fields as in dWorldStepReport.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dIslandStepReport {
    /// sizeof(dIslandStepReport), set by the caller
    pub struct_size: c_uint,
    /// one of dIslandMethod
    pub method: c_int,
    /// a body of the island; it may have been destroyed since the step
    pub body: dBodyID,
    /// its bodies
    pub bodies: c_int,
    /// its joints that gave at least one row
    pub joints: c_int,
    /// its constraint rows
    pub rows: c_int,
    /// as in dWorldStepReport, as are those below without a text of their own
    pub iterations: c_int,
    /// see dWorldStepReport
    pub factorisations: c_int,
    /// 1: needed a more careful method than the first one
    pub fallback: c_int,
    /// 1: kept from spreading bad numbers
    pub contained: c_int,
    /// see dWorldStepReport
    pub residual: f64,
    /// see dWorldStepReport
    pub joint_error: f64,
    /// see dWorldStepReport
    pub joint_angle_error: f64,
    /// see dWorldStepReport
    pub penetration: f64,
    /// see dWorldStepReport
    pub energy_before: f64,
    /// see dWorldStepReport
    pub energy_after: f64,
    /// see dWorldStepReport
    pub projection_iterations: c_int,
    /// 1: left above the tolerance
    pub projection_unconverged: c_int,
    /// see dWorldStepReport
    pub projection_error: f64,
    /// see dWorldStepReport
    pub stopped_bodies: c_int,
    /// see dWorldStepReport
    pub friction_error: f64,
    /// see dWorldStepReport
    pub raised_bodies: c_int,
    /// see dWorldStepReport
    pub raised_residual: f64,
    /// see dWorldStepReport
    pub unsolved_joint: dJointID,
    /// see dWorldStepReport
    pub unsolved_joints: c_int,
}
/// What the last step did to the energy of a world or an island, J. Bodies that sleep and kinematic ones have
/// none. Shares are above 0 where they add kinetic energy.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dEnergyLedger {
    /// sizeof(dEnergyLedger), set by the caller
    pub struct_size: c_uint,
    /// islands of the last step; 1 in that of an island
    pub islands: c_int,
    /// a body of the island; it may have been destroyed since the step. World: 0
    pub body: dBodyID,
    /// kinetic energy at the step's beginning
    pub kinetic_before: f64,
    /// at its end, after damping
    pub kinetic_after: f64,
    /// -sum m g.x over the bodies that gravity acts on, at the step's beginning
    pub potential_before: f64,
    /// the same at its end
    pub potential_after: f64,
    /// work of gravity along the path
    pub gravity: f64,
    /// work of the program's forces and torques
    pub forces: f64,
    /// of drives, motors, springs, all that is soft, moving surfaces and kinematic bodies
    pub drives: f64,
    /// of friction in contacts and axes: never above 0
    pub friction: f64,
    /// of normal forces of contacts and stops, also against friction: what restitution
    /// leaves of an impact
    pub impacts: f64,
    /// of rigid joints: 0 but for errors of first order in the step, and for what a
    /// joint takes when it seizes bodies in relative motion
    pub joints: f64,
    /// of dBodySetLinearDamping and its like
    pub damping: f64,
    /// of the correction of positions: penetrations and joint errors
    pub correction: f64,
    /// what none of these explains: the error of the integration, of first order in
    /// the step, and rounding
    pub integration: f64,
}
/// What a rope is. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dRopeSettings {
    /// sizeof(dRopeSettings), set by the caller or dRopeSettingsInit
    pub struct_size: c_uint,
    /// 1 ... 10000. 20
    pub links: c_int,
    /// of all links, m; at least the distance of the two points; 0: that. 0
    pub length: dReal,
    /// of all links, kg, above 0. 1
    pub mass: dReal,
    /// of the links, which are capsules, m: above 0, less than half a link's length; of planks
    /// half their thickness. 0.02
    pub radius: dReal,
    /// m, 0 or more. Above 0, links are planks on hinges, as wide, across the way. 0
    pub width: dReal,
    /// dRopeEnds. dRopeBoth
    pub ends: c_int,
    /// how much longer the rope is, as a share, under \`load\`; 0: it does not stretch. With
    /// dampers. Planks do not: 0. 0
    pub stretch: dReal,
    /// N, above 0. 1000
    pub load: dReal,
}
/// The mass itself. In C++ it has members that call the functions above and starts as zero; the layout is
/// the same as in C.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dMass {
    /// kg
    pub mass: dReal,
    /// centre of mass, body frame, m
    pub c: dVector3,
    /// inertia about the body's origin, body axes, kg m^2
    pub I: dMatrix3,
}
/// What a vehicle is, but for its wheels. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dVehicleSettings {
    /// sizeof(dVehicleSettings), set by the caller or dVehicleSettingsInit
    pub struct_size: c_uint,
    /// a dVehicleKind. dVehicleCar
    pub kind: c_int,
    /// in the body's frame, of any length but 0, not along up. (1, 0, 0)
    pub forward: dVector3,
    /// likewise; the suspensions work along it. (0, 0, 1)
    pub up: dVector3,
    /// of the engine's curve at full throttle, 2 ... 16; straight between them. 5
    pub torque_points: c_int,
    /// rad/s, each above the one before, the first 0 or more;
    /// the last is the limiter's. 0, 150, 350, 550, 650
    pub engine_speeds: [dReal; 16],
    /// N m, 0 or more. 120, 220, 300, 280, 240
    pub engine_torques: [dReal; 16],
    /// kg m^2, above 0. 0.2
    pub engine_inertia: dReal,
    /// N m at the limiter with closed throttle, in proportion to speed. 60
    pub engine_drag: dReal,
    /// rad/s, that the engine keeps by itself, 0 or more. 90
    pub idle_speed: dReal,
    /// 1: it shifts by itself between forward gears; 0: dVehicleSetGear alone. 1
    pub automatic: c_int,
    /// forward, 1 ... 10. 5
    pub gears: c_int,
    /// engine over shaft, above 0. 3.5, 2.1, 1.45, 1.1, 0.9
    pub gear_ratios: [dReal; 10],
    /// above 0. 3.3
    pub reverse_ratio: dReal,
    /// shaft over wheels, above 0. 3.8
    pub final_ratio: dReal,
    /// s without drive while it shifts, 0 or more. 0.2
    pub shift_time: dReal,
    /// of the engine, rad/s: the automatic gearbox shifts up above it. 580
    pub shift_up_speed: dReal,
    /// and down below it; it does not shift up to less. 230
    pub shift_down_speed: dReal,
    /// the greatest, N m, 0 or more. 700
    pub clutch_torque: dReal,
    /// a dDifferential, of each axle; of dVehicleTracked, of the sides. Open
    pub differential: c_int,
    /// of a limited one, N m, 0 or more. 200
    pub lock_torque: dReal,
    /// a dDifferential, between driven axles. Open
    pub centre_differential: c_int,
    /// of a limited one, N m, 0 or more. 200
    pub centre_lock_torque: dReal,
    /// rad, of a wheel in the middle with steer 1, 0 ... 1.4. 0.6
    pub max_steer: dReal,
    /// rad/s, that it turns with at most, above 0. 2
    pub steer_speed: dReal,
    /// 1: all axles point to one centre; 0: wheels of an axle are parallel. 1
    pub ackermann: dReal,
    /// N s^2/m^2: the air's force over the square of the speed, 0 or more. 0.4
    pub drag: dReal,
    /// N s^2/m^2, along minus up at the centre of mass, 0 or more. 0
    pub downforce: dReal,
    /// 1: brakes, not the handbrake, keep below locking. 0
    pub abs: c_int,
    /// rad/s, of dVehicleBike: how fast it leans; 0: it does not hold itself. 8
    pub lean_frequency: dReal,
    /// rad, 0 ... 1.4. 0.9
    pub lean_limit: dReal,
    /// its wheels meet geoms whose collide bits have one of these ... \~0ul
    pub category_bits: c_ulong,
    /// ... or whose category bits have one of these. \~0ul
    pub collide_bits: c_ulong,
}
/// A wheel with suspension, tyre and brakes. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dVehicleWheel {
    /// sizeof(dVehicleWheel), set by the caller or dVehicleWheelInit
    pub struct_size: c_uint,
    /// a dWheelCast. dWheelRay
    pub cast: c_int,
    /// of the hub when the suspension hangs free, in the body's frame, m. (0, 0, 0)
    pub position: dVector3,
    /// m, above 0. 0.33
    pub radius: dReal,
    /// m, above 0. 0.2
    pub width: dReal,
    /// about its axle, with its brake and shaft, kg m^2, above 0. 1
    pub inertia: dReal,
    /// the two wheels with one number are a pair, 0 ... 31. 0
    pub axle: c_int,
    /// of the suspension, m, 0 or more. 0.25
    pub travel: dReal,
    /// N, of the spring that hangs free, 0 or more. 0
    pub preload: dReal,
    /// N/m, 0 or more. 30000
    pub stiffness: dReal,
    /// N s/m, where it is compressed, 0 or more. 3000
    pub bump_damping: dReal,
    /// N s/m, where it extends, 0 or more. 3000
    pub rebound_damping: dReal,
    /// N/m, beyond the travel, 0 or more. 300000
    pub stop_stiffness: dReal,
    /// N/m, times the difference of the pair's compressions, 0 or more. 0
    pub anti_roll: dReal,
    /// m above what it stands on, where lateral forces act on the chassis. 0
    pub roll_centre: dReal,
    /// mu forward at the nominal load, above 0. 1.1
    pub friction_x: dReal,
    /// mu sideways, likewise. 1
    pub friction_y: dReal,
    /// force over load for a small slip ratio, above 0. 18
    pub stiffness_x: dReal,
    /// force over load for a small slip angle (rad), above 0. 14
    pub stiffness_y: dReal,
    /// what is left of mu in full slip, 0 ... 1. 0.8
    pub sliding: dReal,
    /// N, above 0. 4000
    pub nominal_load: dReal,
    /// mu falls by this share where the load doubles, 0 ... 1. 0.05
    pub load_sensitivity: dReal,
    /// m, that it rolls while its force builds up, above 0. 0.3
    pub relaxation: dReal,
    /// force over load, 0 or more. 0.012
    pub rolling_resistance: dReal,
    /// times the vehicle's angle, -1 ... 1. 0
    pub steer: dReal,
    /// its share of the torque, of all shares, 0 or more. 0
    pub drive: dReal,
    /// N m at brake 1, 0 or more. 1500
    pub brake_torque: dReal,
    /// N m at handbrake 1, 0 or more. 0
    pub handbrake_torque: dReal,
}
/// What the driver does. Each field ends with its default.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dVehicleControls {
    /// sizeof(dVehicleControls), set by the caller
    pub struct_size: c_uint,
    /// 0 ... 1. 0
    pub throttle: dReal,
    /// 0 ... 1. 0
    pub brake: dReal,
    /// 0 ... 1. 0
    pub handbrake: dReal,
    /// -1 ... 1, above 0 to the left. 0
    pub steer: dReal,
    /// 0 ... 1: pressed, nothing is driven; an automatic clutch works besides. 0
    pub clutch: dReal,
}
/// What the last update has done.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dVehicleReport {
    /// sizeof(dVehicleReport), set by the caller
    pub struct_size: c_uint,
    /// -1 reverse, 0 neutral, 1 ... ; while it shifts the next
    pub gear: c_int,
    /// of the chassis along forward, m/s
    pub speed: dReal,
    /// rad/s
    pub engine_speed: dReal,
    /// N m
    pub engine_torque: dReal,
    /// N m, that the engine gives to the gearbox
    pub clutch_torque: dReal,
    /// 1: no drive, for it shifts
    pub is_shifting: c_int,
    /// how many stand on something
    pub wheels_on_ground: c_int,
    /// the angle that it steers, rad
    pub steer: dReal,
    /// rad, about forward, above 0 to the right
    pub lean: dReal,
    /// of the path that it steers, 1/m, above 0 to the left
    pub curvature: dReal,
}
/// What the last update has done at a wheel. Without ground, its fields are 0.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dVehicleWheelReport {
    /// sizeof(dVehicleWheelReport), set by the caller
    pub struct_size: c_uint,
    /// 1: it stands on something
    pub on_ground: c_int,
    /// the geom; 0: none, or it is destroyed
    pub ground: dGeomID,
    /// its triangle if it is a mesh, else -1
    pub ground_side: c_int,
    /// where
    pub ground_pos: dVector3,
    /// unit
    pub ground_normal: dVector3,
    /// the middle of the wheel, to draw it, with or without ground, m
    pub hub: dVector3,
    /// rad about up, above 0 to the left
    pub steer: dReal,
    /// that it has turned, rad, 0 ... 2 pi
    pub angle: dReal,
    /// rad/s, above 0 forward
    pub spin: dReal,
    /// of the suspension, m
    pub compression: dReal,
    /// N along the normal
    pub load: dReal,
    /// N, forward along the ground, on the vehicle
    pub force_x: dReal,
    /// N, to the left
    pub force_y: dReal,
    /// of its speed over the ground: above 0 it drives
    pub slip_ratio: dReal,
    /// rad, from where it points to where it moves, above 0 to the left
    pub slip_angle: dReal,
    /// both together: from 1 on it slides.
    pub slip: dReal,
}
/// An object of a world and its counterpart in the clone: dWorldID, dBodyID, dJointID, dGeomID or dSpaceID.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dHandlePair {
    /// a handle
    pub original: *mut c_void,
    /// the handle of the counterpart
    pub copy: *mut c_void,
}
/// How much is taken in reserve. When blocks have become too small, they are replaced by one of
/// reserve\_factor times what the largest step needed; no block is smaller than reserve\_minimum. struct\_size:
/// sizeof of the struct, set by the caller.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dWorldStepReserveInfo {
    /// sizeof(dWorldStepReserveInfo)
    pub struct_size: c_uint,
    /// how many times what is needed, at least 1
    pub reserve_factor: f32,
    /// bytes
    pub reserve_minimum: c_uint,
}
/// Where step memory comes from. The functions are called by one thread at a time, which with several threads
/// need not be the one that steps. They must not change the joints of the world that is stepped, which is in
/// a step as in a moved callback. struct\_size: sizeof of the struct, set by the caller.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dWorldStepMemoryFunctionsInfo {
    /// sizeof(dWorldStepMemoryFunctionsInfo)
    pub struct_size: c_uint,
    pub alloc_block: Option<unsafe extern "C" fn(usize) -> *mut c_void>,
    pub shrink_block: Option<unsafe extern "C" fn(*mut c_void, usize, usize) -> *mut c_void>,
    pub free_block: Option<unsafe extern "C" fn(*mut c_void, usize)>,
}
/// A stopwatch. The members are the library's business; set it up with dStopwatchReset.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct dStopwatch {
    /// the library's
    pub time: f64,
    /// the library's
    pub cc: [c_ulong; 2],
}
extern "C" {
    /// Install the handler fn, which dError calls.
    ///
    /// Handlers are process-wide; install them before other threads use the library. A handler may leave by
    /// longjmp or by a C++ exception, also inside callbacks (docs/errors.md says what then becomes of the call around it;
    /// inside functions for memory or threads it must return). NULL brings the default back, which prints to the standard error stream.
    pub fn dSetErrorHandler(r#fn: dMessageFunction);
    /// Install the handler fn, which dDebug calls.
    ///
    /// Handlers are process-wide; install them before other threads use the library. A handler may leave by
    /// longjmp or by a C++ exception, also inside callbacks (docs/errors.md says what then becomes of the call around it;
    /// inside functions for memory or threads it must return). NULL brings the default back, which prints to the standard error stream.
    pub fn dSetDebugHandler(r#fn: dMessageFunction);
    /// Install the handler fn, which dMessage calls.
    ///
    /// Handlers are process-wide; install them before other threads use the library. A handler may leave by
    /// longjmp or by a C++ exception, also inside callbacks (docs/errors.md says what then becomes of the call around it;
    /// inside functions for memory or threads it must return). NULL brings the default back, which prints to the standard error stream.
    pub fn dSetMessageHandler(r#fn: dMessageFunction);
    /// The handler that dSetErrorHandler has installed, or NULL if it is the default one.
    pub fn dGetErrorHandler() -> dMessageFunction;
    /// The handler that dSetDebugHandler has installed, or NULL if it is the default one.
    pub fn dGetDebugHandler() -> dMessageFunction;
    /// The handler that dSetMessageHandler has installed, or NULL if it is the default
    /// one.
    pub fn dGetMessageHandler() -> dMessageFunction;
    /// For programs: report a fatal user-level error and leave the process with exit(1), also when a
    /// handler returns. num: error number, shown unless 0; msg, ...: as for printf.
    pub fn dError(num: c_int, msg: *const c_char, ...) -> !;
    /// For programs: report a broken assumption, as dError does (num, msg, ...), and abort(), also when a handler
    /// returns.
    pub fn dDebug(num: c_int, msg: *const c_char, ...) -> !;
    /// Report something worth knowing (num, msg, ... as for dError) and go on.
    pub fn dMessage(num: c_int, msg: *const c_char, ...);
    /// Say that the pose of geom changed behind the library's back: its bounding box will be computed
    /// anew. Functions that move geoms or bodies, and steps, do this themselves. Refused: what is no
    /// geom.
    pub fn dGeomMoved(geom: dGeomID);
    /// The next geom of the same body after geom, or 0: same as dBodyGetNextGeom. A geom that is 0 or destroyed
    /// is refused.
    pub fn dGeomGetBodyNext(geom: dGeomID) -> dGeomID;
    /// How this library was built: words separated by single spaces, for example "ODE" and
    /// "ODE\_double\_precision"; those of Debian's libode8. It takes nothing and refuses nothing.
    pub fn dGetConfiguration() -> *const c_char;
    /// 1 when \`token\` is one whole word of dGetConfiguration() (case counts), else 0; an empty text and one with
    /// a space in it give 1. A null token is refused: 0.
    pub fn dCheckConfiguration(token: *const c_char) -> c_int;
    /// A new space that tests every pair: the quickest for a few dozen geoms. space: the parent, or 0.
    pub fn dSimpleSpaceCreate(space: dSpaceID) -> dSpaceID;
    /// A new space for many geoms of similar and different sizes. space: the parent, or 0.
    pub fn dHashSpaceCreate(space: dSpaceID) -> dSpaceID;
    /// A space for geoms that lie along an axis. axisorder: one of the codes above.
    pub fn dSweepAndPruneSpaceCreate(space: dSpaceID, axisorder: c_int) -> dSpaceID;
    /// A space for a world of known extent: its Center and half sizes Extents (3 reals each, m), and Depth,
    /// how often it is divided in four (not negative). Geoms outside are found all the same. In this library
    /// hash, sweep-and-prune and quadtree spaces are one structure that needs none of these hints: they are
    /// checked, and they are for speed only.
    pub fn dQuadTreeSpaceCreate(space: dSpaceID, Center: *const dReal, Extents: *const dReal, Depth: c_int) -> dSpaceID;
    /// Destroy a space; with it, in cleanup mode, its members, else they only leave it.
    pub fn dSpaceDestroy(space: dSpaceID);
    /// Set the cell sizes of a hash space to 2^minlevel ... 2^maxlevel metres; default -3
    /// and 10. They are for speed only: no pair is lost whatever they are. minlevel \> maxlevel is refused.
    pub fn dHashSpaceSetLevels(space: dSpaceID, minlevel: c_int, maxlevel: c_int);
    /// Write the exponents of the smallest and the largest cell size of a hash space to
    /// minlevel and \*maxlevel: cells are 2^level metres. A null pointer is skipped.
    pub fn dHashSpaceGetLevels(space: dSpaceID, minlevel: *mut c_int, maxlevel: *mut c_int);
    /// Say whether destroying the space destroys its members (mode not 0, the default) or
    /// leaves them.
    pub fn dSpaceSetCleanup(space: dSpaceID, mode: c_int);
    /// Whether destroying the space destroys its members: 1 or 0.
    pub fn dSpaceGetCleanup(space: dSpaceID) -> c_int;
    /// Set the number by which dSpaceCollide2 decides which of two spaces it opens: the one
    /// with the higher sublevel. Default 0; the library does not change it.
    pub fn dSpaceSetSublevel(space: dSpaceID, sublevel: c_int);
    /// The number that dSpaceSetSublevel has set, 0 at first.
    pub fn dSpaceGetSublevel(space: dSpaceID) -> c_int;
    /// Do nothing with mode, in ODE a hint on the lifetime of caches that threads have;
    /// neither Debian's ODE nor this library has such caches.
    pub fn dSpaceSetManualCleanup(space: dSpaceID, mode: c_int);
    /// 1, whatever was set, as from Debian's ODE.
    pub fn dSpaceGetManualCleanup(space: dSpaceID) -> c_int;
    /// Add a geom that is in no space to the space.
    pub fn dSpaceAdd(space: dSpaceID, geom: dGeomID);
    /// Take a direct member, geom, out of the space.
    pub fn dSpaceRemove(space: dSpaceID, geom: dGeomID);
    /// 1 if geom is a direct member of the space, else 0.
    pub fn dSpaceQuery(space: dSpaceID, geom: dGeomID) -> c_int;
    /// Compute the bounding boxes of moved members now. dSpaceCollide does it by itself.
    pub fn dSpaceClean(space: dSpaceID);
    /// How many direct members the space has.
    pub fn dSpaceGetNumGeoms(space: dSpaceID) -> c_int;
    /// Direct member number i, 0 ... dSpaceGetNumGeoms - 1, of the space. The order is not
    /// promised and may change when geoms move. An i that there is not is refused.
    pub fn dSpaceGetGeom(space: dSpaceID, i: c_int) -> dGeomID;
    /// The class number of a space: dSimpleSpaceClass, dHashSpaceClass, ...
    pub fn dSpaceGetClass(space: dSpaceID) -> c_int;
    /// Destroy the geom; it leaves its space and its body. For a space the same as dSpaceDestroy.
    pub fn dGeomDestroy(geom: dGeomID);
    /// Store a pointer of the program's, data, with the geom; NULL at first. The library never
    /// looks at it.
    pub fn dGeomSetData(geom: dGeomID, data: *mut c_void);
    /// The pointer that the program stored with dGeomSetData; NULL if it stored none.
    pub fn dGeomGetData(geom: dGeomID) -> *mut c_void;
    /// Put the geom on the body, whose pose it then shares (an offset is dropped); 0 takes it
    /// off its body, and it stays where it is. A geom on a body moves with it, and setting the geom's pose
    /// moves the body.
    pub fn dGeomSetBody(geom: dGeomID, body: dBodyID);
    /// The body that the geom is on, or 0.
    pub fn dGeomGetBody(geom: dGeomID) -> dBodyID;
    /// Set the geom's position in the world to (x, y, z), m.
    ///
    /// On a body with an offset the body is moved so that the geom gets there.
    pub fn dGeomSetPosition(geom: dGeomID, x: dReal, y: dReal, z: dReal);
    /// Set the geom's rotation in the world to the matrix R, from the geom's frame to the
    /// world's.
    ///
    /// On a body with an offset the body is moved so that the geom gets there.
    pub fn dGeomSetRotation(geom: dGeomID, R: *const dReal);
    /// Set the geom's rotation in the world to the quaternion Q, of any length but zero.
    ///
    /// On a body with an offset the body is moved so that the geom gets there.
    pub fn dGeomSetQuaternion(geom: dGeomID, Q: *const dReal);
    /// A pointer to the geom's position in the world: 3 reals, m.
    ///
    /// The pointer is valid until the geom is changed, moved to another body or destroyed.
    pub fn dGeomGetPosition(geom: dGeomID) -> *const dReal;
    /// A pointer to the geom's rotation matrix in the world: 12 reals.
    ///
    /// The pointer is valid until the geom is changed, moved to another body or destroyed.
    pub fn dGeomGetRotation(geom: dGeomID) -> *const dReal;
    /// Copy the geom's position in the world, m, to pos.
    ///
    /// The padding is not written.
    pub fn dGeomCopyPosition(geom: dGeomID, pos: *mut dReal);
    /// Copy the geom's rotation matrix in the world to R: the 9 elements of 12 reals.
    ///
    /// The padding is not written.
    pub fn dGeomCopyRotation(geom: dGeomID, R: *mut dReal);
    /// Write the geom's rotation in the world to result as a quaternion.
    ///
    /// The padding is not written.
    pub fn dGeomGetQuaternion(geom: dGeomID, result: *mut dReal);
    /// The bounding box aabb in the world, m: xmin, xmax, ymin, ymax, zmin, zmax. A space gives the box round its
    /// members.
    pub fn dGeomGetAABB(geom: dGeomID, aabb: *mut dReal);
    /// 1 if the geom is a space, else 0.
    pub fn dGeomIsSpace(geom: dGeomID) -> c_int;
    /// The space that the geom is in, or 0.
    pub fn dGeomGetSpace(geom: dGeomID) -> dSpaceID;
    /// The number of the geom's class: dSphereClass, dBoxClass and so on; of a class of the
    /// program's, what dCreateGeomClass returned.
    pub fn dGeomGetClass(geom: dGeomID) -> c_int;
    /// Set the categories that the geom is in, one bit each; default: all.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    pub fn dGeomSetCategoryBits(geom: dGeomID, bits: c_ulong);
    /// Set the categories with which the geom collides, one bit each; default: all.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    pub fn dGeomSetCollideBits(geom: dGeomID, bits: c_ulong);
    /// The categories that the geom is in, one bit each.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    pub fn dGeomGetCategoryBits(geom: dGeomID) -> c_ulong;
    /// The categories with which the geom collides, one bit each.
    ///
    /// Spaces report two geoms when the category bits of one meet the collide bits of the other, in at least one
    /// direction.
    pub fn dGeomGetCollideBits(geom: dGeomID) -> c_ulong;
    /// Let spaces find the geom again. New geoms are enabled.
    ///
    /// Spaces skip disabled geoms; dCollide does not. A body's own state does not matter.
    pub fn dGeomEnable(geom: dGeomID);
    /// Let spaces skip the geom until dGeomEnable.
    ///
    /// Spaces skip disabled geoms; dCollide does not. A body's own state does not matter.
    pub fn dGeomDisable(geom: dGeomID);
    /// 1 if spaces find the geom, 0 if they skip it.
    ///
    /// Spaces skip disabled geoms; dCollide does not. A body's own state does not matter.
    pub fn dGeomIsEnabled(geom: dGeomID) -> c_int;
    /// Set or read a setting of the geom's class: controlClass is dGeomCommonControlClass or
    /// dGeomColliderControlClass, controlCode says which setting. \*dataSize is the size of \*dataValue. Returns 1
    /// when done; 0, with the size needed in \*dataSize, when size or pointer do not fit; a control the geom does
    /// not have gives size 0 and 0. Only triangle meshes have controls.
    pub fn dGeomLowLevelControl(geom: dGeomID, controlClass: c_int, controlCode: c_int, dataValue: *mut c_void, dataSize: *mut c_int) -> c_int;
    /// The position in the world of the point (px, py, pz) of the geom's frame, m.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    pub fn dGeomGetRelPointPos(geom: dGeomID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// The coordinates in the geom's frame of the world's point (px, py, pz), m.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    pub fn dGeomGetPosRelPoint(geom: dGeomID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// The direction (px, py, pz) of the geom's frame, turned to the world's axes.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    pub fn dGeomVectorToWorld(geom: dGeomID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// The direction (px, py, pz) of the world, turned to the geom's axes.
    ///
    /// A geom without a pose (a plane, a space) gives the input back.
    pub fn dGeomVectorFromWorld(geom: dGeomID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// Set the offset's position to (x, y, z), m, in the body's frame; its rotation
    /// stays.
    pub fn dGeomSetOffsetPosition(geom: dGeomID, x: dReal, y: dReal, z: dReal);
    /// Set the offset's rotation to the matrix R, from the geom's frame to the body's;
    /// its position stays.
    pub fn dGeomSetOffsetRotation(geom: dGeomID, R: *const dReal);
    /// Set the offset's rotation to the quaternion Q, of any length but zero, from
    /// the geom's frame to the body's; its position stays.
    pub fn dGeomSetOffsetQuaternion(geom: dGeomID, Q: *const dReal);
    /// Set the offset's position so that the geom is at the world's point (x, y,
    /// z), m, now; the body and the offset's rotation stay.
    pub fn dGeomSetOffsetWorldPosition(geom: dGeomID, x: dReal, y: dReal, z: dReal);
    /// Set the offset's rotation so that the geom has the rotation matrix R in
    /// the world now; the body and the offset's position stay.
    pub fn dGeomSetOffsetWorldRotation(geom: dGeomID, R: *const dReal);
    /// Set the offset's rotation so that the geom has the rotation Q in the
    /// world now, a quaternion of any length but zero; the body and the offset's position stay.
    pub fn dGeomSetOffsetWorldQuaternion(geom: dGeomID, Q: *const dReal);
    /// Drop the offset: the geom goes to the body's pose.
    pub fn dGeomClearOffset(geom: dGeomID);
    /// 1 when the geom has an offset, else 0.
    pub fn dGeomIsOffset(geom: dGeomID) -> c_int;
    /// A pointer to the offset's position in the body's frame, 3 reals, m; zeros if
    /// there is no offset. Valid until the offset is changed.
    pub fn dGeomGetOffsetPosition(geom: dGeomID) -> *const dReal;
    /// Copy the offset's position in the body's frame, m, to pos; zeros if there is
    /// no offset.
    pub fn dGeomCopyOffsetPosition(geom: dGeomID, pos: *mut dReal);
    /// A pointer to the offset's rotation matrix, from the geom's frame to the body's,
    /// 12 reals; the identity if there is no offset. Valid until the offset is changed.
    pub fn dGeomGetOffsetRotation(geom: dGeomID) -> *const dReal;
    /// Copy the offset's rotation matrix, from the geom's frame to the body's, to R;
    /// the identity if there is no offset.
    pub fn dGeomCopyOffsetRotation(geom: dGeomID, R: *mut dReal);
    /// Write the offset's rotation, from the geom's frame to the body's, to result
    /// as a quaternion; the identity if there is no offset.
    pub fn dGeomGetOffsetQuaternion(geom: dGeomID, result: *mut dReal);
    /// Contacts of two geoms o1 and o2 (or spaces, whose member pairs are then tested).
    /// flags: low 16 bits = room in the array, at least 1; and CONTACTS\_UNIMPORTANT.
    /// contact: array whose entries lie \`skip\` bytes apart, skip \>= sizeof(dContactGeom): for an array of
    /// dContact give &array\[0\].geom and sizeof(dContact).
    /// Returns how many entries were written. g1 belongs to o1, g2 to o2; the normal points into g1.
    /// Two geoms of the same body, or a geom with itself, give 0. Bits, enabling and bounding boxes
    /// are not looked at. Refused before dInitODE2.
    pub fn dCollide(o1: dGeomID, o2: dGeomID, flags: c_int, contact: *mut dContactGeom, skip: c_int) -> c_int;
    /// Call the callback, with data, once for each pair of direct members of the space that are enabled, not on
    /// the same body, not filtered by their bits, and whose bounding boxes touch. Geoms of zero size are skipped.
    /// The order of pairs and within a pair is not promised.
    pub fn dSpaceCollide(space: dSpaceID, data: *mut c_void, callback: dNearCallback);
    /// Call the callback, with data, once for each pair of geoms, one of (or in) space1 and one of (or in)
    /// space2, in this order, that are enabled, not on the same body, not filtered by their bits, and whose
    /// bounding boxes touch. Of two spaces with different sublevels the higher one is opened and the other passed
    /// whole; with equal sublevels both are opened; the same space twice is dSpaceCollide.
    pub fn dSpaceCollide2(space1: dGeomID, space2: dGeomID, data: *mut c_void, callback: dNearCallback);
    /// A new sphere of this radius, m, in the space, or (0) in none.
    pub fn dCreateSphere(space: dSpaceID, radius: dReal) -> dGeomID;
    /// Set the sphere's radius, m.
    pub fn dGeomSphereSetRadius(sphere: dGeomID, radius: dReal);
    /// The sphere's radius, m.
    pub fn dGeomSphereGetRadius(sphere: dGeomID) -> dReal;
    /// How deep the world's point (x, y, z) is inside the sphere, m: positive inside, 0
    /// on the surface, negative outside.
    pub fn dGeomSpherePointDepth(sphere: dGeomID, x: dReal, y: dReal, z: dReal) -> dReal;
    /// A new convex polyhedron in the space, or (0) in none.
    ///
    /// The solid is the hull of the points, in the geom's frame; the arrays are copied. Faces are found from the
    /// points, so that missing or inverted ones do no harm. Refused: no plane; fewer than 3 points; all points in
    /// a line (points of a plane make a plate); planes and polygons that are not numbers and indices of points.
    /// - points: pointcount points, 3 reals each, m.
    /// - polygons: for each of the planecount faces its number of corners and their indices, counter-clockwise.
    /// - planes: for each face its unit outward normal n and n . p of its points p, 4 reals.
    pub fn dCreateConvex(space: dSpaceID, planes: *const dReal, planecount: c_uint, points: *const dReal, pointcount: c_uint, polygons: *const c_uint) -> dGeomID;
    /// Give the geom convex another polyhedron, or the same arrays with other numbers.
    ///
    /// The solid is the hull of the points, in the geom's frame; the arrays are copied. Faces are found from the
    /// points, so that missing or inverted ones do no harm. Refused: no plane; fewer than 3 points; all points in
    /// a line (points of a plane make a plate); planes and polygons that are not numbers and indices of points.
    /// - points: pointcount points, 3 reals each, m.
    /// - polygons: for each of the planecount faces its number of corners and their indices, counter-clockwise.
    /// - planes: for each face its unit outward normal n and n . p of its points p, 4 reals.
    pub fn dGeomSetConvex(convex: dGeomID, planes: *const dReal, planecount: c_uint, points: *const dReal, pointcount: c_uint, polygons: *const c_uint);
    /// A new box in the space, or (0) in none, centred, with the full side lengths lx, ly, lz
    /// along its own axes, m.
    pub fn dCreateBox(space: dSpaceID, lx: dReal, ly: dReal, lz: dReal) -> dGeomID;
    /// Set the box's full side lengths to lx, ly, lz, m.
    pub fn dGeomBoxSetLengths(r#box: dGeomID, lx: dReal, ly: dReal, lz: dReal);
    /// Write the box's full side lengths to result: 3 reals, m.
    pub fn dGeomBoxGetLengths(r#box: dGeomID, result: *mut dReal);
    /// How deep a point is inside the box: the distance to the nearest face, negative outside.
    pub fn dGeomBoxPointDepth(r#box: dGeomID, x: dReal, y: dReal, z: dReal) -> dReal;
    /// A new plane in the space, or (0) in none: the solid half-space a x + b y + c z \<= d of
    /// the world. (a, b, c) is the outward normal; the four numbers are divided by its length, and a zero
    /// normal becomes (1, 0, 0) with d = 0. A plane has no pose and is on no body.
    pub fn dCreatePlane(space: dSpaceID, a: dReal, b: dReal, c: dReal, d: dReal) -> dGeomID;
    /// Set the plane to the half-space a x + b y + c z \<= d of the world; the four
    /// numbers are divided by the length of the outward normal (a, b, c), and a zero normal becomes (1, 0, 0)
    /// with d = 0.
    pub fn dGeomPlaneSetParams(plane: dGeomID, a: dReal, b: dReal, c: dReal, d: dReal);
    /// Write the plane's unit outward normal and its distance from the origin along it,
    /// m, to result: 4 reals.
    pub fn dGeomPlaneGetParams(plane: dGeomID, result: *mut dReal);
    /// How deep the world's point (x, y, z) is below the plane's surface, m: positive
    /// inside the solid half-space, 0 on the surface, negative outside.
    pub fn dGeomPlanePointDepth(plane: dGeomID, x: dReal, y: dReal, z: dReal) -> dReal;
    /// A new capsule in the space, or (0) in none: a cylinder of radius and length, m, along
    /// its own z axis, with round caps.
    ///
    /// The length leaves out the round caps.
    pub fn dCreateCapsule(space: dSpaceID, radius: dReal, length: dReal) -> dGeomID;
    /// Set the capsule's radius and length, m.
    ///
    /// The length leaves out the round caps.
    pub fn dGeomCapsuleSetParams(capsule: dGeomID, radius: dReal, length: dReal);
    /// Write the capsule's radius to \*radius and its length to \*length, m.
    ///
    /// The length leaves out the round caps.
    pub fn dGeomCapsuleGetParams(capsule: dGeomID, radius: *mut dReal, length: *mut dReal);
    /// How deep the world's point (x, y, z) is inside the capsule, m: positive inside,
    /// 0 on the surface, negative outside.
    ///
    /// The length leaves out the round caps.
    pub fn dGeomCapsulePointDepth(capsule: dGeomID, x: dReal, y: dReal, z: dReal) -> dReal;
    /// A new cylinder with flat ends in the space, or (0) in none, of radius and length, m,
    /// along its own z axis.
    pub fn dCreateCylinder(space: dSpaceID, radius: dReal, length: dReal) -> dGeomID;
    /// Set the cylinder's radius and length, m.
    pub fn dGeomCylinderSetParams(cylinder: dGeomID, radius: dReal, length: dReal);
    /// Write the cylinder's radius to \*radius and its length to \*length, m.
    pub fn dGeomCylinderGetParams(cylinder: dGeomID, radius: *mut dReal, length: *mut dReal);
    /// A new ray of this length, m (it may be infinite), in the space, or (0) in none. It goes from
    /// its position along its own z axis. A contact of a ray has its \`pos\` where it hits, as depth the distance
    /// from its start, as normal the surface normal that faces the start. It has at most one contact with a simple
    /// shape.
    pub fn dCreateRay(space: dSpaceID, length: dReal) -> dGeomID;
    /// Set the ray's length, m; it may be infinite.
    pub fn dGeomRaySetLength(ray: dGeomID, length: dReal);
    /// The ray's length, m.
    pub fn dGeomRayGetLength(ray: dGeomID) -> dReal;
    /// Set the ray's start to (px, py, pz), m, and its direction to (dx, dy, dz), which is
    /// normalised here and must not be zero; both in the world's frame.
    pub fn dGeomRaySet(ray: dGeomID, px: dReal, py: dReal, pz: dReal, dx: dReal, dy: dReal, dz: dReal);
    /// Write where the ray starts, m, to start, and its direction, a unit vector, to dir: 3 reals
    /// each, world frame.
    pub fn dGeomRayGet(ray: dGeomID, start: *mut dReal, dir: *mut dReal);
    /// Old form of two calls: dGeomRaySetFirstContact with FirstContact and
    /// dGeomRaySetBackfaceCull with BackfaceCull.
    pub fn dGeomRaySetParams(ray: dGeomID, FirstContact: c_int, BackfaceCull: c_int);
    /// Old form of two calls: write what dGeomRayGetFirstContact answers to \*FirstContact
    /// and what dGeomRayGetBackfaceCull answers to \*BackfaceCull.
    pub fn dGeomRayGetParams(ray: dGeomID, FirstContact: *mut c_int, BackfaceCull: *mut c_int);
    /// Let the ray take the first hit that is found on a shape with many
    /// (firstContact not 0) instead of looking for more; default 0.
    pub fn dGeomRaySetFirstContact(ray: dGeomID, firstContact: c_int);
    /// Whether the ray takes the first hit that is found: 1 or 0.
    pub fn dGeomRayGetFirstContact(ray: dGeomID) -> c_int;
    /// Let the ray ignore faces that it meets from behind (backfaceCull not 0);
    /// default 0.
    pub fn dGeomRaySetBackfaceCull(ray: dGeomID, backfaceCull: c_int);
    /// Whether the ray ignores faces that it meets from behind: 1 or 0.
    pub fn dGeomRayGetBackfaceCull(ray: dGeomID) -> c_int;
    /// Let the ray give only the closest of the hits on a shape with many (closestHit
    /// not 0); default 0.
    pub fn dGeomRaySetClosestHit(ray: dGeomID, closestHit: c_int);
    /// Whether the ray gives only the closest hit: 1 or 0.
    pub fn dGeomRayGetClosestHit(ray: dGeomID) -> c_int;
    /// New data for the triangles of one or more geoms, empty at first.
    pub fn dGeomTriMeshDataCreate() -> dTriMeshDataID;
    /// Destroy the data g; geoms that have them touch nothing afterwards. Refused
    /// during a collision that may need them.
    pub fn dGeomTriMeshDataDestroy(g: dTriMeshDataID);
    /// Set the triangles of the data g from vertices of type float. Edges that
    /// the rounding to floats may have bent count as flat.
    ///
    /// Data that have been built already get new triangles, and their geoms with them. Refused during a
    /// collision that needs the data.
    pub fn dGeomTriMeshDataBuildSingle(g: dTriMeshDataID, Vertices: *const c_void, VertexStride: c_int, VertexCount: c_int, Indices: *const c_void, IndexCount: c_int, TriStride: c_int);
    /// Set the triangles of the data g from vertices of type float, and their
    /// normals. Edges that the rounding to floats may have bent count as flat. Normals: three dReal for each
    /// triangle, or 0, as for dTRIMESHDATA\_FACE\_NORMALS.
    ///
    /// Data that have been built already get new triangles, and their geoms with them. Refused during a
    /// collision that needs the data.
    pub fn dGeomTriMeshDataBuildSingle1(g: dTriMeshDataID, Vertices: *const c_void, VertexStride: c_int, VertexCount: c_int, Indices: *const c_void, IndexCount: c_int, TriStride: c_int, Normals: *const c_void);
    /// Set the triangles of the data g from vertices of type double.
    ///
    /// Data that have been built already get new triangles, and their geoms with them. Refused during a
    /// collision that needs the data.
    pub fn dGeomTriMeshDataBuildDouble(g: dTriMeshDataID, Vertices: *const c_void, VertexStride: c_int, VertexCount: c_int, Indices: *const c_void, IndexCount: c_int, TriStride: c_int);
    /// Set the triangles of the data g from vertices of type double, and their
    /// normals. Normals: three dReal for each triangle, or 0, as for dTRIMESHDATA\_FACE\_NORMALS.
    ///
    /// Data that have been built already get new triangles, and their geoms with them. Refused during a
    /// collision that needs the data.
    pub fn dGeomTriMeshDataBuildDouble1(g: dTriMeshDataID, Vertices: *const c_void, VertexStride: c_int, VertexCount: c_int, Indices: *const c_void, IndexCount: c_int, TriStride: c_int, Normals: *const c_void);
    /// Set the triangles of the data g from vertices of type dVector3 and
    /// indices, both without gaps.
    ///
    /// Data that have been built already get new triangles, and their geoms with them. Refused during a
    /// collision that needs the data.
    pub fn dGeomTriMeshDataBuildSimple(g: dTriMeshDataID, Vertices: *const dReal, VertexCount: c_int, Indices: *const dTriIndex, IndexCount: c_int);
    /// Set the triangles of the data g from vertices of type dVector3 and
    /// indices, both without gaps, and their normals. Normals: three dReal for each triangle, behind a pointer
    /// of another type, or 0, as for dTRIMESHDATA\_FACE\_NORMALS.
    ///
    /// Data that have been built already get new triangles, and their geoms with them. Refused during a
    /// collision that needs the data.
    pub fn dGeomTriMeshDataBuildSimple1(g: dTriMeshDataID, Vertices: *const dReal, VertexCount: c_int, Indices: *const dTriIndex, IndexCount: c_int, Normals: *const c_int);
    /// Read the arrays that the data were built from again, after the program has moved vertices or, which costs
    /// as much as building, changed indices. Edges stay those that they were. The bounding boxes of the geoms
    /// follow. Refused, and nothing changes, for data that are not built, numbers that building refuses, and
    /// while a collision goes on that needs the data.
    pub fn dGeomTriMeshDataUpdate(g: dTriMeshDataID);
    /// Compute CONCAVE\_EDGES for the data g: dGeomTriMeshDataPreprocess2 with that
    /// bit alone.
    ///
    /// CONCAVE\_EDGES makes the use flags: dMESHDATAUSE\_ bits for each triangle; every edge that is not concave
    /// and every vertex without concave edges is given to one triangle, the one with the lowest index. Returns
    /// 1, or 0 if memory is exhausted or the call is refused. Calling it again computes again. Face normals that
    /// are not unit vectors are refused.
    pub fn dGeomTriMeshDataPreprocess(g: dTriMeshDataID) -> c_int;
    /// Compute for the data g what buildRequestFlags asks for, bits 1 \<\<
    /// dTRIDATAPREPROCESS\_BUILD\_... FACE\_ANGLES makes nothing, as all that contacts need is always there; its
    /// extra data, requestExtraData\[dTRIDATAPREPROCESS\_BUILD\_FACE\_ANGLES\], is checked. requestExtraData may be
    /// 0.
    ///
    /// CONCAVE\_EDGES makes the use flags: dMESHDATAUSE\_ bits for each triangle; every edge that is not concave
    /// and every vertex without concave edges is given to one triangle, the one with the lowest index. Returns
    /// 1, or 0 if memory is exhausted or the call is refused. Calling it again computes again. Face normals that
    /// are not unit vectors are refused.
    pub fn dGeomTriMeshDataPreprocess2(g: dTriMeshDataID, buildRequestFlags: c_uint, requestExtraData: *const isize) -> c_int;
    /// Give the data g an array of the program's own, in\_data, for data\_id
    /// (dTRIMESHDATA\_...); it is not copied. Use flags that are given hide those that have been computed until
    /// they are set to 0.
    ///
    /// Contacts do not use these data: they are there for programs that store them.
    pub fn dGeomTriMeshDataSet(g: dTriMeshDataID, data_id: c_int, in_data: *mut c_void);
    /// The array for data\_id (dTRIMESHDATA\_...) that the program has set or the library
    /// has computed, else 0. The number of its bytes is written to \*pout\_size unless pout\_size is 0.
    ///
    /// Contacts do not use these data: they are there for programs that store them.
    pub fn dGeomTriMeshDataGet2(g: dTriMeshDataID, data_id: c_int, pout_size: *mut usize) -> *mut c_void;
    /// Old form that reads the use flags of the data g: a pointer to them is
    /// written to \*buf, their number to \*bufLen; either pointer may be 0.
    pub fn dGeomTriMeshDataGetBuffer(g: dTriMeshDataID, buf: *mut *mut c_uchar, bufLen: *mut c_int);
    /// Old form that sets the use flags of the data g: buf are the flags, one byte
    /// for each triangle.
    pub fn dGeomTriMeshDataSetBuffer(g: dTriMeshDataID, buf: *mut c_uchar);
    /// A new mesh in the space, or (0) in none, of the triangles Data, with three functions of
    /// the program, each of which may be 0. Its bounding box is that of the data, turned.
    pub fn dCreateTriMesh(space: dSpaceID, Data: dTriMeshDataID, Callback: dTriCallback, ArrayCallback: dTriArrayCallback, RayCallback: dTriRayCallback) -> dGeomID;
    /// Give the mesh g other triangles, Data. Refused while the geom is being collided.
    pub fn dGeomTriMeshSetData(g: dGeomID, Data: dTriMeshDataID);
    /// The data of the mesh g, or 0.
    pub fn dGeomTriMeshGetData(g: dGeomID) -> dTriMeshDataID;
    /// The data of the mesh g, or 0; the same answer as dGeomTriMeshGetData.
    pub fn dGeomTriMeshGetTriMeshDataID(g: dGeomID) -> dTriMeshDataID;
    /// Set the function that accepts or refuses contacts of the mesh g with a
    /// triangle; 0: none. It is called for triangles near the other geom, which need not touch it, and for
    /// hits of rays. A refused triangle is a hole: solids rest on the edges towards it.
    pub fn dGeomTriMeshSetCallback(g: dGeomID, Callback: dTriCallback);
    /// The function that dGeomTriMeshSetCallback has set, or 0.
    pub fn dGeomTriMeshGetCallback(g: dGeomID) -> dTriCallback;
    /// Set the function that is given all triangles of the mesh g near the other
    /// geom at once; 0: none. They need not touch it.
    pub fn dGeomTriMeshSetArrayCallback(g: dGeomID, ArrayCallback: dTriArrayCallback);
    /// The function that dGeomTriMeshSetArrayCallback has set, or 0.
    pub fn dGeomTriMeshGetArrayCallback(g: dGeomID) -> dTriArrayCallback;
    /// Set the function that accepts or refuses hits of rays on the mesh g, from
    /// the nearest on, until enough are accepted; 0: none. The one of dGeomTriMeshSetCallback is asked after
    /// it, and both must accept.
    pub fn dGeomTriMeshSetRayCallback(g: dGeomID, Callback: dTriRayCallback);
    /// The function that dGeomTriMeshSetRayCallback has set, or 0.
    pub fn dGeomTriMeshGetRayCallback(g: dGeomID) -> dTriRayCallback;
    /// Set the function that is called when contacts of two triangles of the
    /// mesh g, at the same place and with the same normal, become one, and that gives the contact its index;
    /// 0: none,
    /// so that the contact has the index of the deeper one.
    pub fn dGeomTriMeshSetTriMergeCallback(g: dGeomID, Callback: dTriTriMergeCallback);
    /// The function that dGeomTriMeshSetTriMergeCallback has set, or 0.
    pub fn dGeomTriMeshGetTriMergeCallback(g: dGeomID) -> dTriTriMergeCallback;
    /// How many triangles there are, those without area included; 0 without data.
    pub fn dGeomTriMeshGetTriangleCount(g: dGeomID) -> c_int;
    /// Write the corners of triangle Index of the mesh g in the world, m, to \*v0, \*v1
    /// and \*v2; some of the pointers may be 0, but not all.
    pub fn dGeomTriMeshGetTriangle(g: dGeomID, Index: c_int, v0: *mut dVector3, v1: *mut dVector3, v2: *mut dVector3);
    /// Write the point (1 - u - v) a + u b + v c of triangle Index of the mesh g,
    /// with its corners a, b, c in the world, m, to Out.
    pub fn dGeomTriMeshGetPoint(g: dGeomID, Index: c_int, u: dReal, v: dReal, Out: *mut dReal);
    /// Store 16 reals, last\_trans, for the program: a place for the pose of the
    /// step before.
    ///
    /// Contacts do not need it.
    pub fn dGeomTriMeshSetLastTransform(g: dGeomID, last_trans: *const dReal);
    /// A pointer to the 16 reals that dGeomTriMeshSetLastTransform has stored,
    /// zeros at first; valid as long as the geom.
    ///
    /// Contacts do not need it.
    pub fn dGeomTriMeshGetLastTransform(g: dGeomID) -> *const dReal;
    /// Say whether (enable not 0) what is found out about geoms of class geomClass may
    /// be remembered for their next collision; default 0. It holds for dSphereClass, dBoxClass and
    /// dCapsuleClass; others stay 0.
    ///
    /// The setting is stored for the program; the library keeps no such memory.
    pub fn dGeomTriMeshEnableTC(g: dGeomID, geomClass: c_int, enable: c_int);
    /// Whether dGeomTriMeshEnableTC has been switched on for class geomClass: 1 or 0.
    ///
    /// The setting is stored for the program; the library keeps no such memory.
    pub fn dGeomTriMeshIsTCEnabled(g: dGeomID, geomClass: c_int) -> c_int;
    /// Does nothing: there is nothing to be cleared.
    ///
    /// The setting is stored for the program; the library keeps no such memory.
    pub fn dGeomTriMeshClearTCCache(g: dGeomID);
    /// A geom transform, in a space or (0) in none: an old way to place a geom relative to a body. Use offsets
    /// instead.
    pub fn dCreateGeomTransform(space: dSpaceID) -> dGeomID;
    /// Put the geom obj inside the transform, relative to which it is placed; 0: none.
    /// It must be in no space and on no body.
    pub fn dGeomTransformSetGeom(transform: dGeomID, obj: dGeomID);
    /// The geom inside the transform, or 0.
    pub fn dGeomTransformGetGeom(transform: dGeomID) -> dGeomID;
    /// Say whether (mode not 0) the geom inside is destroyed with the transform and
    /// when it is replaced; default 0.
    pub fn dGeomTransformSetCleanup(transform: dGeomID, mode: c_int);
    /// The mode that dGeomTransformSetCleanup has set, 0 at first.
    pub fn dGeomTransformGetCleanup(transform: dGeomID) -> c_int;
    /// Say whether contacts name the transform (mode 1) or the geom inside (0, the
    /// default).
    pub fn dGeomTransformSetInfo(transform: dGeomID, mode: c_int);
    /// The mode that dGeomTransformSetInfo has set, 0 at first.
    pub fn dGeomTransformGetInfo(transform: dGeomID) -> c_int;
    /// New data for the heights of one or more geoms, empty at first.
    pub fn dGeomHeightfieldDataCreate() -> dHeightfieldDataID;
    /// Destroy the data; do so after their geoms. A geom whose data are gone
    /// collides with nothing.
    pub fn dGeomHeightfieldDataDestroy(d: dHeightfieldDataID);
    /// Take the heights from the function pCallback, which is called with
    /// pUserData whenever a sample is needed.
    ///
    /// width, depth \> 0: sides of the rectangle, m; widthSamples, depthSamples \>= 2: samples along them.
    /// thickness \>= 0 lowers the bottom of the bounding box, so that spaces still report what has sunk that far.
    /// bWrap: the field repeats without end along x and z (then the last column and row stand for the first, and
    /// the bounding box is infinite). Heights that are no usable numbers are refused. Geoms that use the data
    /// already get their new box when they move or are given the data again.
    pub fn dGeomHeightfieldDataBuildCallback(d: dHeightfieldDataID, pUserData: *mut c_void, pCallback: dHeightfieldGetHeight, width: dReal, depth: dReal, widthSamples: c_int, depthSamples: c_int, scale: dReal, offset: dReal, thickness: dReal, bWrap: c_int);
    /// Take the heights from the bytes at pHeightData. bCopyHeightData 0: the
    /// program keeps the array alive.
    ///
    /// width, depth \> 0: sides of the rectangle, m; widthSamples, depthSamples \>= 2: samples along them.
    /// thickness \>= 0 lowers the bottom of the bounding box, so that spaces still report what has sunk that far.
    /// bWrap: the field repeats without end along x and z (then the last column and row stand for the first, and
    /// the bounding box is infinite). Heights that are no usable numbers are refused. Geoms that use the data
    /// already get their new box when they move or are given the data again.
    pub fn dGeomHeightfieldDataBuildByte(d: dHeightfieldDataID, pHeightData: *const c_uchar, bCopyHeightData: c_int, width: dReal, depth: dReal, widthSamples: c_int, depthSamples: c_int, scale: dReal, offset: dReal, thickness: dReal, bWrap: c_int);
    /// Take the heights from the short integers at pHeightData.
    /// bCopyHeightData 0: the program keeps the array alive.
    ///
    /// width, depth \> 0: sides of the rectangle, m; widthSamples, depthSamples \>= 2: samples along them.
    /// thickness \>= 0 lowers the bottom of the bounding box, so that spaces still report what has sunk that far.
    /// bWrap: the field repeats without end along x and z (then the last column and row stand for the first, and
    /// the bounding box is infinite). Heights that are no usable numbers are refused. Geoms that use the data
    /// already get their new box when they move or are given the data again.
    pub fn dGeomHeightfieldDataBuildShort(d: dHeightfieldDataID, pHeightData: *const c_short, bCopyHeightData: c_int, width: dReal, depth: dReal, widthSamples: c_int, depthSamples: c_int, scale: dReal, offset: dReal, thickness: dReal, bWrap: c_int);
    /// Take the heights from the floats at pHeightData. bCopyHeightData 0:
    /// the program keeps the array alive.
    ///
    /// width, depth \> 0: sides of the rectangle, m; widthSamples, depthSamples \>= 2: samples along them.
    /// thickness \>= 0 lowers the bottom of the bounding box, so that spaces still report what has sunk that far.
    /// bWrap: the field repeats without end along x and z (then the last column and row stand for the first, and
    /// the bounding box is infinite). Heights that are no usable numbers are refused. Geoms that use the data
    /// already get their new box when they move or are given the data again.
    pub fn dGeomHeightfieldDataBuildSingle(d: dHeightfieldDataID, pHeightData: *const f32, bCopyHeightData: c_int, width: dReal, depth: dReal, widthSamples: c_int, depthSamples: c_int, scale: dReal, offset: dReal, thickness: dReal, bWrap: c_int);
    /// Take the heights from the doubles at pHeightData. bCopyHeightData 0:
    /// the program keeps the array alive.
    ///
    /// width, depth \> 0: sides of the rectangle, m; widthSamples, depthSamples \>= 2: samples along them.
    /// thickness \>= 0 lowers the bottom of the bounding box, so that spaces still report what has sunk that far.
    /// bWrap: the field repeats without end along x and z (then the last column and row stand for the first, and
    /// the bounding box is infinite). Heights that are no usable numbers are refused. Geoms that use the data
    /// already get their new box when they move or are given the data again.
    pub fn dGeomHeightfieldDataBuildDouble(d: dHeightfieldDataID, pHeightData: *const f64, bCopyHeightData: c_int, width: dReal, depth: dReal, widthSamples: c_int, depthSamples: c_int, scale: dReal, offset: dReal, thickness: dReal, bWrap: c_int);
    /// The range minHeight ... maxHeight of samples (before scale and offset) that the bounding box is made of.
    /// Arrays know theirs; a callback's field has an infinite box until this is called.
    pub fn dGeomHeightfieldDataSetBounds(d: dHeightfieldDataID, minHeight: dReal, maxHeight: dReal);
    /// A new height field in the space, or (0) in none, over data, which may be 0 for now.
    /// bPlaceable 0: it stays at the origin, not rotated.
    pub fn dCreateHeightfield(space: dSpaceID, data: dHeightfieldDataID, bPlaceable: c_int) -> dGeomID;
    /// Give the height field g other heights: the data d.
    pub fn dGeomHeightfieldSetHeightfieldData(g: dGeomID, d: dHeightfieldDataID);
    /// The data of the height field g, or 0.
    pub fn dGeomHeightfieldGetHeightfieldData(g: dGeomID) -> dHeightfieldDataID;
    /// The closest points cp1 and cp2 (3 reals each) of the segments a1-a2 and b1-b2; of parallel segments one
    /// pair of them.
    pub fn dClosestLineSegmentPoints(a1: *const dReal, a2: *const dReal, b1: *const dReal, b2: *const dReal, cp1: *mut dReal, cp2: *mut dReal);
    /// 1 when two boxes touch or overlap, else 0. Their centres are \_p1 and \_p2 (m), their rotation matrices R1
    /// and R2, their full side lengths side1 and side2 (3 reals each).
    pub fn dBoxTouchesBox(_p1: *const dReal, R1: *const dReal, side1: *const dReal, _p2: *const dReal, R2: *const dReal, side2: *const dReal) -> c_int;
    /// Contacts of two boxes with centres p1, p2, rotation matrices R1, R2 and full side lengths side1, side2.
    /// Written: normal (from box 1 to box 2), the greatest depth (how far they must move apart along that normal),
    /// return\_code (1-3 face of box 1, 4-6 face of box 2, 7-15 a pair of edges), and \`pos\` and \`depth\` of as many
    /// entries of contact as fit (flags and skip as for dCollide). Returns their number, 0 when the boxes are
    /// apart.
    pub fn dBoxBox(p1: *const dReal, R1: *const dReal, side1: *const dReal, p2: *const dReal, R2: *const dReal, side2: *const dReal, normal: *mut dReal, depth: *mut dReal, return_code: *mut c_int, flags: c_int, contact: *mut dContactGeom, skip: c_int) -> c_int;
    /// A bounding box without bounds, written to aabb whatever the geom is: an aabb function for user classes.
    pub fn dInfiniteAABB(geom: dGeomID, aabb: *mut dReal);
    /// Register the class that \*classptr describes; returns its number, dFirstUserClass and up. Refused (-1) when
    /// the description is bad or dMaxUserClasses are taken. dCloseODE forgets the classes.
    pub fn dCreateGeomClass(classptr: *const dGeomClass) -> c_int;
    /// The data of geom, of a user class: \`bytes\` bytes, zero at first. A geom of another class is refused: 0.
    pub fn dGeomGetClassData(geom: dGeomID) -> *mut c_void;
    /// A geom of the user class classnum, in no space. A number that is none is refused: 0.
    pub fn dCreateGeom(classnum: c_int) -> dGeomID;
    /// Collide classes i and j with the function fn from now on (and j with i by turning it round); 0
    /// lets the pair not collide at all. Process-wide, until dCloseODE. Numbers that are no
    /// class are refused, and all calls while the library is not open.
    pub fn dSetColliderOverride(i: c_int, j: c_int, r#fn: dColliderFn);
    /// Fills \*filter with the default of every field, a filter that finds everything, and writes struct\_size,
    /// which is sizeof(dQueryFilter), to it: dQueryFilterInit(&filter, sizeof filter). Returns 1.
    pub fn dQueryFilterInit(filter: *mut dQueryFilter, struct_size: c_uint) -> c_int;
    /// Finds the geom that a ray hits first and writes it to \*hit. The ray goes from origin in direction (of
    /// any length but 0) to the distance length (0 ... dInfinity). Each geom is hit as dCollide with a ray geom
    /// says, with its closest hit; from inside, at its far wall. A surface that the ray leaves outward at its
    /// origin is not hit there. A null filter finds everything. Returns 1, or
    /// 0 if nothing is hit: then hit-\>geom is 0. Refused: a zero direction; a length below 0.
    pub fn dSpaceRayClosest(space: dSpaceID, origin: *const dReal, direction: *const dReal, length: dReal, filter: *const dQueryFilter, hit: *mut dQueryHit) -> c_int;
    /// Finds all geoms that a ray hits, each once, and writes at most capacity of them to hits, the nearest
    /// first. The ray (origin, direction, length) and a null filter are as in dSpaceRayClosest. Returns how
    /// many there are.
    pub fn dSpaceRayAll(space: dSpaceID, origin: *const dReal, direction: *const dReal, length: dReal, filter: *const dQueryFilter, hits: *mut dQueryHit, capacity: c_int) -> c_int;
    /// Casts count rays at once: hits\[i\] is the hit of dSpaceRayClosest for ray i. origins and directions have
    /// 3 reals for each ray, lengths one. At most so many threads work, the caller's included (threads 0: one
    /// for each processor), with the same bits on any number; the caller's does all if the filter has a
    /// callback, or if a geom of the space would call a function of the program. A null filter finds
    /// everything. Returns how many rays hit something. Refused, all of them: a ray that dSpaceRayClosest would
    /// refuse; a negative count or number of threads.
    pub fn dSpaceRayBatch(space: dSpaceID, count: c_int, origins: *const dReal, directions: *const dReal, lengths: *const dReal, filter: *const dQueryFilter, hits: *mut dQueryHit, threads: c_int) -> c_int;
    /// Finds the members of the space that touch or overlap a geom, other than itself and geoms of its body,
    /// and writes at most capacity of them to geoms, the one that has joined last first. A null filter takes
    /// the geom's own bits. Meshes are surfaces, unless solid; height fields are solid down to the bottom of
    /// their boxes; classes of the program and overridden pairs are met as dCollide says. Returns how many
    /// there are. Refused: a geom that is a space, destroyed or 0.
    pub fn dSpaceOverlap(space: dSpaceID, geom: dGeomID, filter: *const dQueryFilter, geoms: *mut dGeomID, capacity: c_int) -> c_int;
    /// Computes the signed distance of o1 and o2 and the points where it is attained, and writes them to
    /// result if it is at most max\_distance (dInfinity: however far). Solids that overlap have minus the least
    /// depth: moving o1 by -distance \* normal parts them. Of a space counts the member nearest to the other
    /// geom whose bits agree with its bits. Returns 1; 0 if they are farther apart, or where there is no
    /// distance: geoms of no triangles, classes of the program, two endless height fields. Meshes, rays, planes
    /// and height fields: docs/guide/queries.md. Refused: equal geoms, one that is destroyed or 0.
    pub fn dGeomGetDistance(o1: dGeomID, o2: dGeomID, max_distance: dReal, result: *mut dQueryDistance) -> c_int;
    /// Find where the geom hits one other geom, whatever its bits, and write that to \*hit.
    /// Refused: another geom that is o, destroyed, 0 or a space.
    ///
    /// The geom o moves by motion (m, world, not zero) without turning. It is a convex solid of any class, a
    /// ray, or a transform that holds one. What it overlaps at the beginning is hit at distance 0, with the
    /// normal that leads out; what it only touches is hit if the motion leads into it. Nothing is passed,
    /// however thin. Classes of the program are not met. Returns 1, or 0 if nothing is hit: then hit-\>geom is
    /// 0. Refused: no motion; an o that is not convex.
    pub fn dGeomCast(o: dGeomID, motion: *const dReal, other: dGeomID, hit: *mut dQueryHit) -> c_int;
    /// Find what the geom hits first in the space, other than itself and geoms of its body, and
    /// write that to \*hit. A null filter takes the geom's own bits.
    ///
    /// The geom o moves by motion (m, world, not zero) without turning. It is a convex solid of any class, a
    /// ray, or a transform that holds one. What it overlaps at the beginning is hit at distance 0, with the
    /// normal that leads out; what it only touches is hit if the motion leads into it. Nothing is passed,
    /// however thin. Classes of the program are not met. Returns 1, or 0 if nothing is hit: then hit-\>geom is
    /// 0. Refused: no motion; an o that is not convex.
    pub fn dSpaceCast(space: dSpaceID, o: dGeomID, motion: *const dReal, filter: *const dQueryFilter, hit: *mut dQueryHit) -> c_int;
    /// Finds all that the geom o would hit on its way, each geom once, where the motion meets it first, and
    /// writes at most capacity of them to hits, the nearest first. Motion, o and filter are as in dSpaceCast;
    /// nothing stops o. Returns how many there are. Refused: what dSpaceCast refuses.
    pub fn dSpaceCastAll(space: dSpaceID, o: dGeomID, motion: *const dReal, filter: *const dQueryFilter, hits: *mut dCastHit, capacity: c_int) -> c_int;
    /// Fills \*settings with the default of every field and writes struct\_size, which is
    /// sizeof(dCharacterSettings), to it: dCharacterSettingsInit(&settings, sizeof settings). Returns 1.
    pub fn dCharacterSettingsInit(settings: *mut dCharacterSettings, struct_size: c_uint) -> c_int;
    /// Create a character in the space with its feet at the origin; null settings are the defaults. Returns its
    /// geom.
    pub fn dCharacterCreate(space: dSpaceID, settings: *const dCharacterSettings) -> dGeomID;
    /// Returns 1 if the geom is a character, else 0.
    pub fn dGeomIsCharacter(geom: dGeomID) -> c_int;
    /// Give the character other settings. Returns 1. Refused: another shape, radius,
    /// height or up than it has; what dCharacterCreate refuses.
    ///
    /// The settings.
    pub fn dCharacterSetSettings(character: dGeomID, settings: *const dCharacterSettings) -> c_int;
    /// Write the settings to \*settings, whose struct\_size the caller has set. Returns 1.
    ///
    /// The settings.
    pub fn dCharacterGetSettings(character: dGeomID, settings: *mut dCharacterSettings) -> c_int;
    /// Change the height (m) while the feet stay where they are: to crouch and to stand up. Returns 1; 0 if there
    /// is no room above, or no height that the shape can have.
    pub fn dCharacterSetHeight(character: dGeomID, height: dReal) -> c_int;
    /// Put the feet at (x, y, z), whatever is there; it stands on nothing then.
    ///
    /// The position of the feet, m.
    pub fn dCharacterSetPosition(character: dGeomID, x: dReal, y: dReal, z: dReal);
    /// Write the position to feet. Returns 1.
    ///
    /// The position of the feet, m.
    pub fn dCharacterGetPosition(character: dGeomID, feet: *mut dReal) -> c_int;
    /// Move the character for a step of h seconds with a velocity that the program has worked out, gravity
    /// included: the ground carries it first, then it collides and slides. On ground it keeps the horizontal part
    /// of the velocity, uphill and downhill, unless the velocity leads away from the ground. Call it once for each
    /// dWorldStep, after it: what carries it has moved then. Called before, it lags by the ground's motion in that
    /// one step. Returns the dCharacterState. Refused: a velocity above 1e4 m/s.
    pub fn dCharacterMove(character: dGeomID, velocity: *const dReal, h: dReal) -> c_int;
    /// Walk: as dCharacterMove, but with gravity, falls and jumps. velocity is how it wants to go, relative to the
    /// ground; of it the part along up does not count. jump\_speed (m/s) above 0 lets it jump if it stands: to the
    /// height jump\_speed^2 / (2 gravity), whatever h. In the air it turns with air\_acceleration. Returns the
    /// dCharacterState. Refused: a jump\_speed below 0 or above 1e4.
    pub fn dCharacterWalk(character: dGeomID, velocity: *const dReal, jump_speed: dReal, h: dReal) -> c_int;
    /// Give it a velocity, as a blow or a spring board does: dCharacterWalk goes on from
    /// it, and leaves the ground if it leads upward.
    ///
    /// The velocity.
    pub fn dCharacterSetVelocity(character: dGeomID, velocity: *const dReal);
    /// Write how it has moved in the last move to velocity. Returns 1.
    ///
    /// The velocity.
    pub fn dCharacterGetVelocity(character: dGeomID, velocity: *mut dReal) -> c_int;
    /// Write what the last move has done to \*report, whose struct\_size the caller has set. Returns 1.
    pub fn dCharacterGetReport(character: dGeomID, report: *mut dCharacterReport) -> c_int;
    /// Advance the world by stepsize seconds with the small-step solver: the step is cut into maxiterations
    /// (1 ... 10000) equal small steps, and in each of them every joint is solved on its own as a rigid block.
    /// Time and memory grow linearly with the number of joints. More iterations give more accuracy; joint ERP and
    /// CFM keep the meaning they have for the whole step. May be mixed freely with dWorldStep and
    /// dWorldQuickStep on the same world. Returns 1 when the world was stepped, 0 when the call was refused
    /// (null world, stepsize not positive and finite, maxiterations outside 1 ... 10000) or out of memory: poses,
    /// velocities and accumulators are then as they were.
    pub fn dWorldStepFast1(w: dWorldID, stepsize: dReal, maxiterations: c_int) -> c_int;
    /// Store the world's autoEnableDepth of the guide. It changes nothing: waking
    /// through joints always reaches the whole island.
    pub fn dWorldSetAutoEnableDepthSF1(w: dWorldID, autoEnableDepth: c_int);
    /// The number that dWorldSetAutoEnableDepthSF1 has stored.
    pub fn dWorldGetAutoEnableDepthSF1(w: dWorldID) -> c_int;
    /// Old form that sets both thresholds of idleness to
    /// autoDisableThreshold: the linear one, m/s, and the angular one, rad/s.
    pub fn dBodySetAutoDisableThresholdSF1(b: dBodyID, autoDisableThreshold: dReal);
    /// The body's threshold of the linear speed, m/s: old name of
    /// dBodyGetAutoDisableLinearThreshold.
    pub fn dBodyGetAutoDisableThresholdSF1(b: dBodyID) -> dReal;
    /// Old name of dBodySetAutoDisableSteps; AutoDisableSteps is the number of
    /// idle steps.
    pub fn dBodySetAutoDisableStepsSF1(b: dBodyID, AutoDisableSteps: c_int);
    /// Old name of dBodyGetAutoDisableSteps.
    pub fn dBodyGetAutoDisableStepsSF1(b: dBodyID) -> c_int;
    /// Old name of dBodySetAutoDisableFlag; doAutoDisable not 0 switches it on.
    pub fn dBodySetAutoDisableSF1(b: dBodyID, doAutoDisable: c_int);
    /// Old name of dBodyGetAutoDisableFlag.
    pub fn dBodyGetAutoDisableSF1(b: dBodyID) -> c_int;
    /// Let the world find and solve the contacts between the geoms of a space; 0, the
    /// default, stops that. All contacts that the world knew are forgotten. A space that is destroyed is
    /// taken away from its world.
    pub fn dWorldSetContactSpace(world: dWorldID, space: dSpaceID);
    /// The space that dWorldSetContactSpace has set, or 0.
    pub fn dWorldGetContactSpace(world: dWorldID) -> dSpaceID;
    /// Fills \*material with the default of every field, and writes struct\_size, which is sizeof(dMaterial), to
    /// it: dMaterialInit(&material, sizeof material). Returns 1. Refused: what dGeomSetMaterial refuses as too
    /// small or too large.
    pub fn dMaterialInit(material: *mut dMaterial, struct_size: c_uint) -> c_int;
    /// Give the geom a copy of \*material from the next step on; 0: the default again.
    /// Returns 1. Refused: coefficients below 0; a bounce above 1; infinite rolling friction, compliance or
    /// damping time; unknown rules; a priority beyond a million; a kind outside 0 ... 255.
    ///
    /// A program whose dMaterial has fewer fields than the library's keeps working: the others have their
    /// defaults. Refused: a structure smaller than one that has friction alone, or larger than this library's.
    pub fn dGeomSetMaterial(geom: dGeomID, material: *const dMaterial) -> c_int;
    /// Copy the geom's material to \*material, the default if it has none. Returns 1.
    ///
    /// A program whose dMaterial has fewer fields than the library's keeps working: the others have their
    /// defaults. Refused: a structure smaller than one that has friction alone, or larger than this library's.
    pub fn dGeomGetMaterial(geom: dGeomID, material: *mut dMaterial) -> c_int;
    /// Give the geom a copy of \*material as its material of that number (1 ... 255), from
    /// the next step on; 0 removes it. Returns 1. Refused: another number; what dGeomSetMaterial refuses.
    ///
    /// Materials by number. Those of the faces of a geom: the triangles of a mesh, in their order, or the cells of a
    /// height field, cell (i, j) by i + j (samples along the first axis - 1); world-managed contacts take the
    /// material of the face that is nearest to the contact. Of any geom, those of pairs: against a geom whose
    /// material has that number as its kind, the numbered one alone says friction, bounce, rolling friction and
    /// compliance. Clones and files of worlds have them.
    pub fn dGeomSetFaceMaterial(geom: dGeomID, number: c_int, material: *const dMaterial) -> c_int;
    /// Copy that material, or the default material if there is none, to \*material.
    /// Returns 1.
    ///
    /// Materials by number. Those of the faces of a geom: the triangles of a mesh, in their order, or the cells of a
    /// height field, cell (i, j) by i + j (samples along the first axis - 1); world-managed contacts take the
    /// material of the face that is nearest to the contact. Of any geom, those of pairs: against a geom whose
    /// material has that number as its kind, the numbered one alone says friction, bounce, rolling friction and
    /// compliance. Clones and files of worlds have them.
    pub fn dGeomGetFaceMaterial(geom: dGeomID, number: c_int, material: *mut dMaterial) -> c_int;
    /// Take from numbers which material each of count faces has: with 0 or
    /// one without a material it has the geom's own. Count 0: all have. Returns 1. Refused:
    /// another class of geom; a count that is not 0 and not that of the faces.
    ///
    /// Materials by number. Those of the faces of a geom: the triangles of a mesh, in their order, or the cells of a
    /// height field, cell (i, j) by i + j (samples along the first axis - 1); world-managed contacts take the
    /// material of the face that is nearest to the contact. Of any geom, those of pairs: against a geom whose
    /// material has that number as its kind, the numbered one alone says friction, bounce, rolling friction and
    /// compliance. Clones and files of worlds have them.
    pub fn dGeomSetFaceMaterialNumbers(geom: dGeomID, numbers: *const c_uchar, count: c_int) -> c_int;
    /// Copy them, at most capacity, to numbers. Returns how many there are.
    ///
    /// Materials by number. Those of the faces of a geom: the triangles of a mesh, in their order, or the cells of a
    /// height field, cell (i, j) by i + j (samples along the first axis - 1); world-managed contacts take the
    /// material of the face that is nearest to the contact. Of any geom, those of pairs: against a geom whose
    /// material has that number as its kind, the numbered one alone says friction, bounce, rolling friction and
    /// compliance. Clones and files of worlds have them.
    pub fn dGeomGetFaceMaterialNumbers(geom: dGeomID, numbers: *mut c_uchar, capacity: c_int) -> c_int;
    /// Sets a function that rejects pairs, called with the given data; filter 0: none. The thread that steps
    /// calls it, in the order of the pairs. It must not change the space or the world.
    pub fn dWorldSetContactFilter(world: dWorldID, filter: dContactFilter, data: *mut c_void);
    /// Sets a function that sees, changes and rejects the manifolds of each step, called with the given data;
    /// function 0: none. threads 0: the thread that steps calls it, in the order of the pairs; 1: any thread of
    /// the world may, several at once, and results do not depend on which. Files have no functions. Refused:
    /// other threads.
    pub fn dWorldSetManifoldFunction(world: dWorldID, function: dManifoldFunction, data: *mut c_void, threads: c_int);
    /// Copies the events of the last step, at most capacity of them, to events. Pairs that the step has updated
    /// come first, in the order in which their geoms were created; then pairs at rest, in an order that depends
    /// on the program's calls alone. A pair that ends because a geom is destroyed or taken out of the space has
    /// its event in the next step. Returns how many there are.
    pub fn dWorldGetContactEvents(world: dWorldID, events: *mut dContactEvent, capacity: c_int) -> c_int;
    /// Copies the points of contact of the last step, at most capacity of them, to contacts, in the order of
    /// dWorldGetContactEvents. Returns how many there are.
    pub fn dWorldGetContacts(world: dWorldID, contacts: *mut dWorldContact, capacity: c_int) -> c_int;
    /// Threads for cooperative functions: those of a threading implementation, given by its table functionInfo
    /// (which is copied) and its handle threadingImpl; both NULL: the calling thread alone. Refused with one of
    /// the two NULL, struct\_size too small or a function missing.
    pub fn dCooperativeCreate(functionInfo: *const dThreadingFunctionsInfo, threadingImpl: dThreadingImplementationID) -> dCooperativeID;
    /// The requirements and containers made for it stay.
    pub fn dCooperativeDestroy(cooperative: dCooperativeID);
    /// New requirements for calls with the container cooperative: at first for
    /// nothing.
    pub fn dResourceRequirementsCreate(cooperative: dCooperativeID) -> dResourceRequirementsID;
    /// Destroy the requirements.
    pub fn dResourceRequirementsDestroy(requirements: dResourceRequirementsID);
    /// A copy that goes its own way.
    pub fn dResourceRequirementsClone(requirements: dResourceRequirementsID) -> dResourceRequirementsID;
    /// Raise summaryRequirements to what satisfies extraRequirements too. Refused if they were made for
    /// different threading implementations.
    pub fn dResourceRequirementsMergeIn(summaryRequirements: dResourceRequirementsID, extraRequirements: dResourceRequirementsID);
    /// The means for what has been estimated so far. One container serves one call at a time. 0 also if the
    /// threading implementation cannot prepare.
    pub fn dResourceContainerAcquire(requirements: dResourceRequirementsID) -> dResourceContainerID;
    /// Refused while a call uses the container.
    pub fn dResourceContainerDestroy(resources: dResourceContainerID);
    /// Create a relation between joints that has no axes yet, in the world, in the group or alone.
    pub fn dJointCreateCoupling(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// Let the position of an axis count factor times, in place i; joint 0 empties the
    /// place. Wakes the bodies. Another factor for the axis that a place has is, from then on, part of the
    /// world's state, not of its structure. Returns 1, or 0 when refused: a coupling or a joint of another
    /// world as joint; an axis that it does not have; a factor that is 0 or not finite; or out of memory.
    pub fn dJointSetCouplingAxis(coupling: dJointID, i: c_int, joint: dJointID, axis: c_int, factor: dReal) -> c_int;
    /// Returns the joint in place i, 0 if the place is empty.
    pub fn dJointGetCouplingJoint(coupling: dJointID, i: c_int) -> dJointID;
    /// Returns the number of its axis, 0 if the place is empty.
    pub fn dJointGetCouplingAxis(coupling: dJointID, i: c_int) -> c_int;
    /// Returns its factor, 0 if the place is empty.
    pub fn dJointGetCouplingFactor(coupling: dJointID, i: c_int) -> dReal;
    /// Set a parameter of the coupling to value: dParamLoStop and dParamHiStop, m or rad, 0 at
    /// first; dParamStopERP, dParamStopCFM and dParamBounce. Equal stops hold s there; a stop of -dInfinity or
    /// dInfinity is none. Others have no effect. Refused: NaN, and
    /// dInfinity where it is no stop.
    pub fn dJointSetCouplingParam(coupling: dJointID, parameter: c_int, value: dReal);
    /// Returns a parameter, 0 if the coupling does not have it.
    pub fn dJointGetCouplingParam(coupling: dJointID, parameter: c_int) -> dReal;
    /// Returns the force along s that stops, springs and drives of the coupling have exerted, N or N m, the mean
    /// over the last step in which it acted; positive lets s grow. Axis i received its factor times this.
    pub fn dJointGetCouplingForce(coupling: dJointID) -> dReal;
    /// Gives every parameter of the world's steps the value of the preset, one of dDefaults; dDefaultsText lists
    /// them. Step the world by dWorldStepHybrid then, which solves as dWorldSetHybridStepper says; the other
    /// steppers use the same parameters. Call it before bodies and joints are created, which copy some of the
    /// values (sleeping, damping, ERP, CFM). Gravity, the space of the contacts, threading functions and modes
    /// (reports, diagnosis, history, behaviour) stay. Returns 1.
    pub fn dWorldUseDefaults(world: dWorldID, preset: c_int) -> c_int;
    /// Writes to text, which has size bytes, what dWorldUseDefaults does for the preset: one call a line, in C,
    /// with the reason. It ends with a zero byte and is cut off where it does not fit; text may be 0 if size is.
    /// Returns the length of the whole text.
    pub fn dDefaultsText(preset: c_int, text: *mut c_char, size: c_int) -> c_int;
    /// Choose how the steps of the world behave: a version of dBehaviour. dBehaviour016:
    /// dWorldQuickStep sweeps in ODE's order, drawn from dRand, from zero and on one thread (states do not hold
    /// what dRandGetSeed returns); bodies fall asleep one by one; finite rotations with an axis are ODE's. At
    /// first dBehaviour1, or what the environment says: EPODE\_BEHAVIOUR=0.16 ./program.
    pub fn dWorldSetBehaviour(world: dWorldID, version: c_int);
    /// What dWorldSetBehaviour has set; at first 100 or what the environment says.
    pub fn dWorldGetBehaviour(world: dWorldID) -> c_int;
    /// Switch the diagnosis of steps on (mode 1) or off (0, the default), which forgets
    /// what has been found. While it is on a step takes longer; its results are the same bits. Other values are
    /// refused, as is a call during a step and one that finds no memory.
    pub fn dWorldSetDiagnosisMode(world: dWorldID, mode: c_int);
    /// 1 if steps are diagnosed, else 0.
    pub fn dWorldGetDiagnosisMode(world: dWorldID) -> c_int;
    /// Copies the causes found since the mode was switched on, at most capacity of them, to causes: the most severe
    /// first, of equal ones what was seen first. Returns how many there are, at most 64. Refused: a capacity below
    /// 0; a call during a step.
    pub fn dWorldDiagnose(world: dWorldID, causes: *mut dDiagnosis, capacity: c_int) -> c_int;
    /// Writes to text, which has size bytes, what the cause means and how to cure it: one line that ends with a
    /// zero byte, cut off where it does not fit. Returns the length of the whole line. Refused: a kind, severity or
    /// call that is none.
    pub fn dDiagnosisText(cause: *const dDiagnosis, text: *mut c_char, size: c_int) -> c_int;
    /// Returns how many axes the joint has: 0 ... 3, by its type; an AMotor and an LMotor have those that the
    /// program has given them.
    pub fn dJointGetNumAxes(joint: dJointID) -> c_int;
    /// Returns the joint's position along or about one of its axes, m or rad. Angles are
    /// in -pi ... pi, or count turns: with stops, and after dJointSetAxisContinuous. A joint without bodies
    /// answers 0.
    pub fn dJointGetAxisPosition(joint: dJointID, axis: c_int) -> dReal;
    /// Returns the derivative of dJointGetAxisPosition, m/s or rad/s. Unlike some of the
    /// types' own functions it is exact also where the bodies turn together.
    pub fn dJointGetAxisRate(joint: dJointID, axis: c_int) -> dReal;
    /// Let the angle of an axis count turns always, mode 1, from where it is now, or only
    /// while it has stops, mode 0, the default. Turns are counted in steps: an axis may turn by less than pi in
    /// each. Stops compare the position: they may lie beyond half a turn. (With dBehaviour016 and mode 0 they
    /// compare angles in -pi ... pi.) Axes that are no angles do not change. Returns 1. Another mode is refused.
    pub fn dJointSetAxisContinuous(joint: dJointID, axis: c_int, mode: c_int) -> c_int;
    /// Returns the mode that dJointSetAxisContinuous has set, 0 at first.
    pub fn dJointGetAxisContinuous(joint: dJointID, axis: c_int) -> c_int;
    /// Say in which turn an angle is that counts turns: in the one where it is nearest to
    /// position, rad. Otherwise, where the program places the bodies, it is the one nearest to the middle of its
    /// stops, or, where these are a turn or more apart, nearest to the last. Returns 1. Refused: a position
    /// that is not finite.
    pub fn dJointSetAxisTurn(joint: dJointID, axis: c_int, position: dReal) -> c_int;
    /// Fills \*drive with zeros, and writes struct\_size, which is sizeof(dDrive), to it: dDriveInit(&drive, sizeof
    /// drive). Returns 1. Refused: what dJointSetDrive refuses as too small or too large.
    pub fn dDriveInit(drive: *mut dDrive, struct_size: c_uint) -> c_int;
    /// Put a drive on an axis, in place of the one it has; drive NULL takes it away. It acts
    /// together with the axis's stops and the motor of dParamVel and dParamFMax, in every stepper and in each
    /// substep, until changed. An angle's target is taken modulo a turn, the shorter way, unless the axis counts
    /// turns (dJointGetAxisPosition). A change wakes the joint's bodies. Returns 1, or 0 when refused
    /// (numbers that are negative or not finite, a structure of a wrong size) or out of memory.
    pub fn dJointSetDrive(joint: dJointID, axis: c_int, drive: *const dDrive) -> c_int;
    /// Write to \*drive, whose size the caller has set, what dJointSetDrive has set, or zeros.
    /// Returns 1 if the axis has a drive, else 0.
    pub fn dJointGetDrive(joint: dJointID, axis: c_int, drive: *mut dDrive) -> c_int;
    /// Returns what spring, damper and feed-forward of an axis have exerted, N or N m, the
    /// mean over the last step; armature and friction are not in it. 0 where there are none.
    pub fn dJointGetDriveForce(joint: dJointID, axis: c_int) -> dReal;
    /// Let the stops of an axis be springs with dampers, N/m and N s/m or N m/rad and
    /// N m s/rad, that push back what is beyond them; with equal stops, in both directions. They hold in every
    /// step and substep, whatever its size, in place of dParamStopERP, dParamStopCFM and dParamBounce. Axes are
    /// numbered as groups of parameters are (dParamLoStop2 is a stop of axis 1). stiffness and damping, both 0:
    /// ERP and CFM count again. Returns 1, or 0 when refused: negative numbers; an axis without stops.
    pub fn dJointSetStopSpring(joint: dJointID, axis: c_int, stiffness: dReal, damping: dReal) -> c_int;
    /// Write to \*stiffness and \*damping what dJointSetStopSpring has set, zeros at first.
    /// Returns 1 if the axis's stops are springs, else 0.
    pub fn dJointGetStopSpring(joint: dJointID, axis: c_int, stiffness: *mut dReal, damping: *mut dReal) -> c_int;
    /// Let the stops of an axis push back what is beyond them by at most \`rate\` times the distance,
    /// per second. Robots of files have 20/s. dInfinity, the default: ERP alone counts. Returns 1, or 0 when
    /// refused: a \`rate\` that is not above 0; an axis without stops.
    ///
    /// A joint that is made far beyond a stop is pushed back at dParamStopERP / h times the distance: the faster, the
    /// smaller the step is, and it keeps that speed. A \`rate\` bounds it in steps that correct by velocities. It does not
    /// count where poses are corrected instead (dWorldSetStepProjection, dWorldSetContactMaxCorrectingVel).
    pub fn dJointSetStopRate(joint: dJointID, axis: c_int, rate: dReal) -> c_int;
    /// Returns what dJointSetStopRate has set. Refused: an axis without stops.
    ///
    /// A joint that is made far beyond a stop is pushed back at dParamStopERP / h times the distance: the faster, the
    /// smaller the step is, and it keeps that speed. A \`rate\` bounds it in steps that correct by velocities. It does not
    /// count where poses are corrected instead (dWorldSetStepProjection, dWorldSetContactMaxCorrectingVel).
    pub fn dJointGetStopRate(joint: dJointID, axis: c_int) -> dReal;
    /// Returns what the stops of an axis have exerted along it, N or N m, the mean over the last step in which the joint acted:
    /// above 0 where its position is to grow. 0 of an axis within its stops, and after a state was set. Refused: an axis without stops.
    pub fn dJointGetStopForce(joint: dJointID, axis: c_int) -> dReal;
    /// Let the rows that have the joint's own ERP and CFM be springs with dampers, N/m and
    /// N s/m: the anchor of a ball, the place of a fixed joint, the rod of a double ball or double hinge, the
    /// suspension of a hinge-2 (there dParamSuspensionERP and CFM), in every step and substep, whatever its
    /// size. stiffness and damping, both 0: ERP and CFM count again. Returns 1, or 0 when refused: negative
    /// numbers; a type without ERP and CFM of its own.
    pub fn dJointSetSpring(joint: dJointID, stiffness: dReal, damping: dReal) -> c_int;
    /// Write to \*stiffness and \*damping what dJointSetSpring has set, zeros at first. Returns
    /// 1 if there is such a spring, else 0.
    pub fn dJointGetSpring(joint: dJointID, stiffness: *mut dReal, damping: *mut dReal) -> c_int;
    /// Write to \*stiffness and \*damping the spring and damper on which mass, kg or kg m^2, swings at so many
    /// hertz with this damping\_ratio (1: just without overshooting): stiffness = mass w^2 and damping = 2
    /// damping\_ratio mass w with w = 2 pi hertz. Returns 1, or 0 when refused: numbers below 0, hertz or mass of
    /// 0.
    pub fn dSpringFromFrequency(mass: dReal, hertz: dReal, damping_ratio: dReal, stiffness: *mut dReal, damping: *mut dReal) -> c_int;
    /// Let the joint break when it has exerted more than this force, N, or torque, N m,
    /// as the mean over a step; 0 or dInfinity: no limit, the default. Force and torque are those on body 1,
    /// drives and motors included, the torque about the anchor of a ball, hinge, universal, hinge-2 or fixed
    /// joint, else about the body's centre. A joint that breaks has acted in the whole step and is disabled at
    /// its end; dJointEnable mends it. Returns 1, or 0 when refused (negative numbers, a contact joint) or out
    /// of memory.
    pub fn dJointSetBreakLimits(joint: dJointID, force: dReal, torque: dReal) -> c_int;
    /// Write to \*force and \*torque what dJointSetBreakLimits has set, dInfinity for none.
    /// Returns 1 if the joint has a limit, else 0.
    pub fn dJointGetBreakLimits(joint: dJointID, force: *mut dReal, torque: *mut dReal) -> c_int;
    /// Returns 1 if the joint has broken and has not been enabled since, else 0.
    pub fn dJointIsBroken(joint: dJointID) -> c_int;
    /// Write to \*joints those that broke in the last step of the world, as many as capacity, the youngest first.
    /// joints may be NULL where capacity is 0. Returns how many broke. Negative capacities are refused.
    pub fn dWorldGetBrokenJoints(world: dWorldID, joints: *mut dJointID, capacity: c_int) -> c_int;
    /// Fills \*settings with the default of every field, and writes struct\_size, which is sizeof(dEventSettings), to
    /// it: dEventSettingsInit(&settings, sizeof settings). Returns 1.
    pub fn dEventSettingsInit(settings: *mut dEventSettings, struct_size: c_uint) -> c_int;
    /// List events as \*settings says from the next step on; settings 0, the default:
    /// none, at no cost. The list becomes empty; what overlaps a sensor then begins in the next step, what
    /// touches has begun already. Returns 1. Refused: settings smaller than \`kinds\` or larger than this
    /// library's; settings with bits that are no kind or values out of range; a call during a step; no memory
    /// for the list.
    pub fn dWorldSetEventSettings(world: dWorldID, settings: *const dEventSettings) -> c_int;
    /// Copy the settings to \*settings. Returns 1; 0, and the defaults, if there are
    /// none.
    pub fn dWorldGetEventSettings(world: dWorldID, settings: *mut dEventSettings) -> c_int;
    /// Copy the events of the last step, at most capacity of them, to events, which may be 0
    /// where capacity is 0. Returns how many there are. Refused: a capacity below 0.
    pub fn dWorldGetEvents(world: dWorldID, events: *mut dEvent, capacity: c_int) -> c_int;
    /// Returns how many events of the last step did not fit into the list; those that
    /// persist are the first to go.
    pub fn dWorldGetLostEvents(world: dWorldID) -> c_int;
    /// Make the geom a sensor (mode 1) or an ordinary geom (mode 0, the default). World-managed
    /// contacts and continuous collision pass through a sensor; sensor events report the geoms that overlap it
    /// at the end of each step, asleep or not, if their bits agree, they or the sensor have a body of the world or they are characters,
    /// and they are not of one body. Sensors and rays are not reported. dSpaceCollide, dCollide and queries
    /// treat it as any geom: a near callback leaves it out by dGeomGetSensor. Refused: a geom that is a space or in
    /// a space that is being collided; other modes.
    pub fn dGeomSetSensor(geom: dGeomID, mode: c_int);
    /// 1 if the geom is a sensor, else 0.
    pub fn dGeomGetSensor(geom: dGeomID) -> c_int;
    /// Write the world w to the open text file as "Dynamics Interchange Format v0.1", tables in the syntax of
    /// Lua: Nworld, then Nbody\[i\] (pose, velocities, mass, flags, geoms) and Njoint\[i\] (bodies,
    /// anchors and axes in their frames, stops, motors), newest first, i from 0. world\_name: N, the prefix of the
    /// global names, printed as it is; NULL for none. SI units; thresholds of automatic disabling are squared, as
    /// they are compared. Not written: geom offsets, damping, callbacks, the contents of meshes and height fields.
    /// Numbers have 15 significant digits (9 in single precision) whatever the locale.
    pub fn dWorldExportDIF(w: dWorldID, file: *mut FILE, world_name: *const c_char);
    /// Fills \*settings with the default of every field, and writes struct\_size, which is sizeof(dFluidSettings), to it:
    /// dFluidSettingsInit(&settings, sizeof settings). Returns 1.
    pub fn dFluidSettingsInit(settings: *mut dFluidSettings, struct_size: c_uint) -> c_int;
    /// Create a fluid in the world, with the default settings: water below z = 0.
    pub fn dFluidCreate(world: dWorldID) -> dFluidID;
    /// Destroy the fluid; a world that is destroyed destroys its own.
    pub fn dFluidDestroy(fluid: dFluidID);
    /// The world that the fluid is in.
    pub fn dFluidGetWorld(fluid: dFluidID) -> dWorldID;
    /// How many fluids the world has.
    pub fn dWorldGetNumFluids(world: dWorldID) -> c_int;
    /// The fluid with that index, 0 ... dWorldGetNumFluids - 1, in the order of creation. Refused: another index.
    pub fn dWorldGetFluid(world: dWorldID, index: c_int) -> dFluidID;
    /// Give the fluid a copy of \*settings. Returns 1. Refused: numbers below 0 that may not be; another struct\_size.
    pub fn dFluidSetSettings(fluid: dFluidID, settings: *const dFluidSettings) -> c_int;
    /// Copy the settings to \*settings, whose struct\_size says how many. Returns 1.
    pub fn dFluidGetSettings(fluid: dFluidID, settings: *mut dFluidSettings) -> c_int;
    /// Set the surface at rest, a x + b y + c z = d, (a, b, c) pointing out of the fluid; at first z = 0.
    /// (a, b, c) need not be of length 1. Refused: (a, b, c) zero.
    pub fn dFluidSetPlane(fluid: dFluidID, a: dReal, b: dReal, c: dReal, d: dReal);
    /// Write a, b, c (of length 1) and d to plane, 4 reals.
    pub fn dFluidGetPlane(fluid: dFluidID, plane: *mut dReal);
    /// Let surface say how high the fluid stands above its plane, with data; surface 0, the default: nowhere.
    /// A geom sees the plane that fits the heights at four places under its box. Bodies in such a fluid do not fall asleep.
    pub fn dFluidSetSurface(fluid: dFluidID, surface: dFluidSurface, data: *mut c_void);
    /// Let current say how the fluid moves, with data; current 0, the default: as the settings say.
    pub fn dFluidSetCurrentFunction(fluid: dFluidID, current: dFluidCurrent, data: *mut c_void);
    /// Restrict the fluid to a geom, volume (a pool): it acts on geoms the centre of whose submerged part lies in the volume.
    /// The surface stays that of the fluid. volume 0, the default: no limit; a volume that has been destroyed: the fluid acts nowhere.
    /// Refused: a volume that is no box, sphere, capsule, cylinder, ellipsoid or convex hull.
    pub fn dFluidSetVolume(fluid: dFluidID, volume: dGeomID);
    /// The geom that the fluid is restricted to; 0: none, or one that has been destroyed.
    pub fn dFluidGetVolume(fluid: dFluidID) -> dGeomID;
    /// Set the time, s, that functions of the fluid get; 0 at first. Each step adds its size.
    pub fn dFluidSetTime(fluid: dFluidID, time: dReal);
    /// The time of the fluid, s. It is part of a world's state.
    pub fn dFluidGetTime(fluid: dFluidID) -> dReal;
    /// Of one geom, of a body or not.
    ///
    /// Compute what of a geom or body lies in the fluid now: its volume, m^3, and the centre of that, m, world (3 reals). Either may be 0.
    /// Returns 1 if anything does; 0, with zeros, if not. Exact for a flat surface: to rounding, for solids of revolution but balls to 1e-8 of the solid.
    pub fn dFluidGetSubmerged(fluid: dFluidID, geom: dGeomID, volume: *mut dReal, centre: *mut dReal) -> c_int;
    /// Of a body, the sum of its geoms.
    ///
    /// Compute what of a geom or body lies in the fluid now: its volume, m^3, and the centre of that, m, world (3 reals). Either may be 0.
    /// Returns 1 if anything does; 0, with zeros, if not. Exact for a flat surface: to rounding, for solids of revolution but balls to 1e-8 of the solid.
    pub fn dFluidGetSubmergedBody(fluid: dFluidID, body: dBodyID, volume: *mut dReal, centre: *mut dReal) -> c_int;
    /// Write the force, N, and the torque about the centre of mass, N m (3 reals each, world), that all fluids exerted on the body in the last step in
    /// which it was awake. Either may be 0. Returns 1 if it was in a fluid; 0, with zeros, if not.
    pub fn dBodyGetFluidForce(body: dBodyID, force: *mut dReal, torque: *mut dReal) -> c_int;
    /// Make a body of the parts, whose geoms are on no body, where they are: at their common centre of mass, of
    /// their masses and inertias added up, not turned. Returns the body.
    pub fn dFractureCreate(world: dWorldID, parts: *const dFracturePart, count: c_int) -> dBodyID;
    /// Break a body that has some of the parts. Those within radius of center (world, m; 0: all) become bodies of
    /// one part each; of the others those that touch each other stay together. The new bodies have the settings,
    /// data pointer and velocities of the old one, which is destroyed; joints are left without it. Of a
    /// kinematic body, what comes off is dynamic and the rest kinematic. Returns how many bodies it has become;
    /// 0, with nothing changed, if it does not break.
    pub fn dFractureBreak(parts: *const dFracturePart, count: c_int, body: dBodyID, center: *const dReal, radius: dReal) -> c_int;
    /// Break whatever the last step has hit harder than its strength: each body that has two or more parts of one
    /// of count fractures. World-managed contacts count (dWorldSetContactSpace), with what will stop the approach
    /// that is left. The blow then has the strength and no more: a ball goes on through a pane with what is left of
    /// its momentum. What was overloaded most breaks first. A body with geoms that are no parts
    /// stays whole, with a message. Call it before each step. Returns how many bodies broke.
    pub fn dFractureUpdate(world: dWorldID, fractures: *const dFracture, count: c_int) -> c_int;
    /// Give the body the impulse at pos, which may be 0: impulse / mass in velocity, and its
    /// moment about the centre.
    ///
    /// Change the velocities at once: by an impulse (N s), or by its moment alone (N m s).
    pub fn dBodyApplyImpulse(body: dBodyID, impulse: *const dReal, pos: *const dReal);
    /// Give the body the moment.
    ///
    /// Change the velocities at once: by an impulse (N s), or by its moment alone (N m s).
    pub fn dBodyApplyAngularImpulse(body: dBodyID, impulse: *const dReal);
    /// Add the force (N) at pos, which may be 0.
    ///
    /// Act in the next step, as dBodyAddForceAtPos and dBodyAddTorque do, on a body that is awake from now on.
    pub fn dBodyApplyForce(body: dBodyID, force: *const dReal, pos: *const dReal);
    /// Add the torque (N m).
    ///
    /// Act in the next step, as dBodyAddForceAtPos and dBodyAddTorque do, on a body that is awake from now on.
    pub fn dBodyApplyTorque(body: dBodyID, torque: *const dReal);
    /// Set the velocities, linear in m/s and angular in rad/s. Either may be 0: it stays. wake: 1 wakes the body;
    /// 0 does not, as dBodySetLinearVel and dBodySetAngularVel. Refused: another wake.
    pub fn dBodySetVelocities(body: dBodyID, linear: *const dReal, angular: *const dReal, wake: c_int);
    /// Give an impulse away from center to each body with a geom of the space within radius (m): impulse (N s)
    /// times what the falloff leaves at the geom's nearest point, there, along the line to the centre of mass.
    /// A body has it once, at its nearest geom. occlusion 1: only if nothing of another body, and no geom
    /// without one, is between center and that point; else 0. A null filter finds everything. Returns how many
    /// bodies had one. Refused: a radius of 0 or below; a dFalloff or an occlusion that is none.
    pub fn dSpaceApplyRadialImpulse(space: dSpaceID, center: *const dReal, radius: dReal, impulse: dReal, falloff: c_int, occlusion: c_int, filter: *const dQueryFilter) -> c_int;
    /// Write to bones, which has capacity of them, a human of this height and mass that stands, facing x, left y,
    /// up z, the soles at z = 0: 16 bones, in proportions and masses of Drillis and Contini and of Dempster.
    /// docs/guide/howto/ragdolls.md has them. Returns 16. Refused: a height outside 0.1 ... 100 m, a mass outside
    /// 0.001 ... 1e6 kg, a capacity below 16.
    pub fn dBonesMakeHuman(bones: *mut dBone, capacity: c_int, height: dReal, mass: dReal) -> c_int;
    /// Build a figure of the bones in the world, its geoms in space, which may be 0, with the list's frame at
    /// position (m) and orientation, either of which may be 0: none. Write the bodies of the bones to bodies,
    /// which has as many places. Without motors: it is limp. Returns count.
    pub fn dRagdollCreate(world: dWorldID, space: dSpaceID, bones: *const dBone, count: c_int, position: *const dReal, orientation: *const dReal, bodies: *mut dBodyID) -> c_int;
    /// Let motors pull the figure to a pose, where it can with their stiffness, damping and
    /// strength, times strength, 0 or more, each: drives (dJointSetDrive), implicit, stable at any step. 0: limp.
    /// What the pose says of bone 0 does not count. A change wakes the figure. Returns how many joints have
    /// motors.
    pub fn dRagdollSetPose(bones: *const dBone, bodies: *const dBodyID, count: c_int, pose: *const dQuaternion, strength: dReal) -> c_int;
    /// Write the present pose to pose. Returns count.
    pub fn dRagdollGetPose(bones: *const dBone, bodies: *const dBodyID, count: c_int, pose: *mut dQuaternion) -> c_int;
    /// Follow an animation: give the bodies velocities that bring them in the coming step of h seconds, above 0
    /// and at most 1, to the pose with bone 0 at position (m). weight, 0 ... 1, is the share of these velocities, the
    /// rest is what they have: 1 follows, 0 does nothing; between, a game lets go. The share of weight of gravity is
    /// taken away. Kinematic bodies follow wholly. Call it before each step. Returns how many bodies follow.
    pub fn dRagdollFollow(bones: *const dBone, bodies: *const dBodyID, count: c_int, position: *const dReal, pose: *const dQuaternion, weight: dReal, h: dReal) -> c_int;
    /// Returns the largest gap of a joint of the figure, m: how far the two sides of an anchor are apart.
    pub fn dRagdollGetGap(bones: *const dBone, bodies: *const dBodyID, count: c_int) -> dReal;
    /// Switch the report of steps on (mode 1) or off (0, the default). A report
    /// costs one more evaluation of the residual per step. Other values are refused.
    pub fn dWorldSetStepReportMode(world: dWorldID, mode: c_int);
    /// 1 if steps are reported, else 0.
    pub fn dWorldGetStepReportMode(world: dWorldID) -> c_int;
    /// Copies the report of the world's last step to \*report. Returns 1; 0 while the mode is off and before the
    /// first step since it was switched on.
    pub fn dWorldGetStepReport(world: dWorldID, report: *mut dWorldStepReport) -> c_int;
    /// Copies to \*report what the last step did in one island, 0 \<= island \< dWorldStepReport::islands. Islands
    /// are in the order in which ODE finds them, from the youngest body on. Returns as dWorldGetStepReport
    /// does. Refused: another index.
    pub fn dWorldGetIslandStepReport(world: dWorldID, island: c_int, report: *mut dIslandStepReport) -> c_int;
    /// Let steps keep an account of energy. Returns 1.
    pub fn dWorldSetEnergyLedgerMode(world: dWorldID, mode: c_int) -> c_int;
    /// 1 if steps keep one, else 0.
    pub fn dWorldGetEnergyLedgerMode(world: dWorldID) -> c_int;
    /// Copy the ledger of the world's last step to \*ledger.
    pub fn dWorldGetEnergyLedger(world: dWorldID, ledger: *mut dEnergyLedger) -> c_int;
    /// Copy that of one island to \*ledger, 0 \<= island \<
    /// dEnergyLedger::islands.
    ///
    /// Both return 1; 0 while the mode is off and before the first step since it was switched on.
    pub fn dWorldGetIslandEnergyLedger(world: dWorldID, island: c_int, ledger: *mut dEnergyLedger) -> c_int;
    /// Fills \*settings with the default of every field and writes its struct\_size, which is sizeof(dRopeSettings):
    /// dRopeSettingsInit(&settings, sizeof settings). Returns 1.
    pub fn dRopeSettingsInit(settings: *mut dRopeSettings, struct_size: c_uint) -> c_int;
    /// Lay a rope in the world from one point to another (m), its geoms in space, which may be 0; null settings
    /// are the defaults. What is longer than the way hangs in an arc, against the z axis or along gravity. Its ends are
    /// fastened to the bodies first and last, or to the world where these are 0. Write its links to bodies, and to
    /// joints, which may be 0, the joint before each link and that after the last: one more; 0 at a loose end.
    /// Returns how many links there are. Refused: points less than the thickness apart, longer ways than the
    /// rope; one link that is longer than the way.
    pub fn dRopeCreate(world: dWorldID, space: dSpaceID, from: *const dReal, to: *const dReal, first: dBodyID, last: dBodyID, settings: *const dRopeSettings, bodies: *mut dBodyID, joints: *mut dJointID) -> c_int;
    /// 1 when the mass \*m is positive and both I and the inertia about the centre of mass are positive
    /// definite, else 0 with a message.
    pub fn dMassCheck(m: *const dMass) -> c_int;
    /// Set everything to zero.
    pub fn dMassSetZero(m: *mut dMass);
    /// Give all values: the mass themass (kg), the centre (cgx, cgy, cgz), m, and the six different elements
    /// I11, I22, I33, I12, I13, I23 of the inertia about the origin, kg m^2.
    pub fn dMassSetParameters(m: *mut dMass, themass: dReal, cgx: dReal, cgy: dReal, cgz: dReal, I11: dReal, I22: dReal, I33: dReal, I12: dReal, I13: dReal, I23: dReal);
    /// Set \*m to a full sphere of this radius, m, and density, kg/m^3: mass 4/3 pi r^3 times
    /// the density, I = 2/5 of the mass times r^2.
    pub fn dMassSetSphere(m: *mut dMass, density: dReal, radius: dReal);
    /// Set \*m to a full sphere of this radius, m, that weighs total\_mass, kg: I = 2/5
    /// total\_mass r^2.
    pub fn dMassSetSphereTotal(m: *mut dMass, total_mass: dReal, radius: dReal);
    /// Set \*m to a full capsule of this density, kg/m^3, radius and length, m, with its axis
    /// along direction.
    ///
    /// The length is that of the cylindrical part, without the caps.
    pub fn dMassSetCapsule(m: *mut dMass, density: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Set \*m to a full capsule that weighs total\_mass, kg, of this radius and length,
    /// m, with its axis along direction.
    ///
    /// The length is that of the cylindrical part, without the caps.
    pub fn dMassSetCapsuleTotal(m: *mut dMass, total_mass: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Set \*m to a full cylinder with flat ends of this density, kg/m^3, radius and length,
    /// m, with its axis along direction.
    pub fn dMassSetCylinder(m: *mut dMass, density: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Set \*m to a full cylinder with flat ends that weighs total\_mass, kg, of this
    /// radius and length, m, with its axis along direction.
    pub fn dMassSetCylinderTotal(m: *mut dMass, total_mass: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Set \*m to a full box of this density, kg/m^3, with the full side lengths lx, ly, lz, m.
    pub fn dMassSetBox(m: *mut dMass, density: dReal, lx: dReal, ly: dReal, lz: dReal);
    /// Set \*m to a full box that weighs total\_mass, kg, with the full side lengths lx, ly,
    /// lz, m.
    pub fn dMassSetBoxTotal(m: *mut dMass, total_mass: dReal, lx: dReal, ly: dReal, lz: dReal);
    /// Set \*m to the solid that the triangles of the mesh g enclose, filled with density,
    /// kg/m^3. A mesh that is turned inside out has a negative mass.
    ///
    /// The mass is that of what the triangles enclose, as the mesh stands in the world: the centre is written as
    /// it is, and the inertia is that about the world's origin; translate by minus the centre for a body. The
    /// integrals are exact for a closed mesh whose fronts are outside. An open mesh is taken to be closed by
    /// cones over its border, from the first corner of its triangle 0. Refused: a geom without triangles;
    /// triangles that enclose nothing.
    pub fn dMassSetTrimesh(m: *mut dMass, density: dReal, g: dGeomID);
    /// Set \*m to the solid that the triangles of the mesh g enclose and that weighs
    /// total\_mass, kg.
    ///
    /// The mass is that of what the triangles enclose, as the mesh stands in the world: the centre is written as
    /// it is, and the inertia is that about the world's origin; translate by minus the centre for a body. The
    /// integrals are exact for a closed mesh whose fronts are outside. An open mesh is taken to be closed by
    /// cones over its border, from the first corner of its triangle 0. Refused: a geom without triangles;
    /// triangles that enclose nothing.
    pub fn dMassSetTrimeshTotal(m: *mut dMass, total_mass: dReal, g: dGeomID);
    /// Scale mass and inertia to the mass newmass (kg); the centre stays. A mass of 0 cannot be scaled:
    /// refused.
    pub fn dMassAdjust(m: *mut dMass, newmass: dReal);
    /// Move the material by (x, y, z), m, relative to the origin: the centre moves along and I is taken about
    /// the same origin as before.
    pub fn dMassTranslate(m: *mut dMass, x: dReal, y: dReal, z: dReal);
    /// Turn the material about the origin by the rotation matrix R: I becomes R I R^T, c becomes R c.
    pub fn dMassRotate(m: *mut dMass, R: *const dReal);
    /// \*a becomes the union of \*a and \*b, which must be given about the same origin and in the same axes.
    pub fn dMassAdd(a: *mut dMass, b: *const dMass);
    /// Old name of dMassSetCapsule: a capsule of this density, kg/m^3, radius and
    /// length of its cylindrical part, m, with its axis along direction.
    pub fn dMassSetCappedCylinder(m: *mut dMass, density: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Old name of dMassSetCapsuleTotal: a capsule that weighs total\_mass, kg, of
    /// this radius and length of its cylindrical part, m, with its axis along direction.
    pub fn dMassSetCappedCylinderTotal(m: *mut dMass, total_mass: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Create a conical geom in the space, or (0) in none. Its own z axis is its axis: the base,
    /// of that radius, lies at z = -length/4, the apex at z = 3 length/4, and the origin is the centre of mass.
    pub fn dCreateCone(space: dSpaceID, radius: dReal, length: dReal) -> dGeomID;
    /// Set the cone's radius and length, m.
    pub fn dGeomConeSetParams(cone: dGeomID, radius: dReal, length: dReal);
    /// Write the cone's radius to \*radius and its length to \*length, m.
    pub fn dGeomConeGetParams(cone: dGeomID, radius: *mut dReal, length: *mut dReal);
    /// Return how deep the world's point (x, y, z) is inside the cone, m.
    pub fn dGeomConePointDepth(cone: dGeomID, x: dReal, y: dReal, z: dReal) -> dReal;
    /// Set \*m to the mass of a solid of that shape about the origin, its centre of mass.
    pub fn dMassSetCone(m: *mut dMass, density: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Set \*m to the mass of a solid of that shape that weighs total\_mass. Refused by both:
    /// other numbers of direction.
    pub fn dMassSetConeTotal(m: *mut dMass, total_mass: dReal, direction: c_int, radius: dReal, length: dReal);
    /// Create a geom with these radii in the space, or (0) in none, about its origin.
    pub fn dCreateEllipsoid(space: dSpaceID, rx: dReal, ry: dReal, rz: dReal) -> dGeomID;
    /// Set the ellipsoid's radii along its own axes, m.
    pub fn dGeomEllipsoidSetRadii(ellipsoid: dGeomID, rx: dReal, ry: dReal, rz: dReal);
    /// Write the ellipsoid's radii to result, 3 reals, m.
    pub fn dGeomEllipsoidGetRadii(ellipsoid: dGeomID, result: *mut dReal);
    /// Return how deep the world's point (x, y, z) is inside the ellipsoid: the
    /// distance from its surface, m. Refused: an ellipsoid with a radius of 0.
    pub fn dGeomEllipsoidPointDepth(ellipsoid: dGeomID, x: dReal, y: dReal, z: dReal) -> dReal;
    /// Set \*m to the mass of a solid of these radii about the origin.
    pub fn dMassSetEllipsoid(m: *mut dMass, density: dReal, rx: dReal, ry: dReal, rz: dReal);
    /// Set \*m to the mass of a solid of these radii that weighs total\_mass.
    pub fn dMassSetEllipsoidTotal(m: *mut dMass, total_mass: dReal, rx: dReal, ry: dReal, rz: dReal);
    /// Create a tapered geom in the space, or (0) in none: the hull of two balls on its
    /// own z axis, r2 above r1. The origin is its centre of mass.
    pub fn dCreateTaperedCapsule(space: dSpaceID, r1: dReal, r2: dReal, length: dReal) -> dGeomID;
    /// Set the geom's radii and length, m; the centre of mass stays the origin.
    pub fn dGeomTaperedCapsuleSetParams(tapered_capsule: dGeomID, r1: dReal, r2: dReal, length: dReal);
    /// Write the geom's radii to \*r1 and \*r2 and its length to \*length, m.
    pub fn dGeomTaperedCapsuleGetParams(tapered_capsule: dGeomID, r1: *mut dReal, r2: *mut dReal, length: *mut dReal);
    /// Return how deep the world's point (x, y, z) is inside the geom, m.
    pub fn dGeomTaperedCapsulePointDepth(tapered_capsule: dGeomID, x: dReal, y: dReal, z: dReal) -> dReal;
    /// Set \*m to the mass of a solid of that shape about the origin, its centre of
    /// mass.
    pub fn dMassSetTaperedCapsule(m: *mut dMass, density: dReal, direction: c_int, r1: dReal, r2: dReal, length: dReal);
    /// Set \*m to the mass of a solid of that shape that weighs total\_mass. Refused
    /// by both: other numbers of direction; two radii of 0.
    pub fn dMassSetTaperedCapsuleTotal(m: *mut dMass, total_mass: dReal, direction: c_int, r1: dReal, r2: dReal, length: dReal);
    /// Write the surface of the geom as triangles, and return how many there are. Each is 9 reals: three corners
    /// in the geom's frame, m, counter-clockwise from outside. Round solids are cut into that many segments
    /// around the z axis, and half as many along it; a convex has its faces. At most capacity are written to
    /// facets. Refused: segments below 4 or above 512.
    pub fn dGeomGetTriangles(geom: dGeomID, segments: c_int, facets: *mut dReal, capacity: c_int) -> c_int;
    /// Choose whether a fast geom stops at what it would have passed: mode is one of
    /// dContinuousMode, dContinuousOff by default. If the geom would go deeper than an eighth of its
    /// thickness into another one, its body stands still, for the rest of the step, from the moment when they
    /// met; velocities are kept. dWorldStepReport::stopped\_bodies counts. Which geoms are met:
    /// docs/guide/shapes.md. Refused: other modes; dContinuousOn for a geom that is neither sphere, box,
    /// capsule, cylinder, convex, mesh nor a transform.
    pub fn dGeomSetContinuous(geom: dGeomID, mode: c_int);
    /// The mode that dGeomSetContinuous has set, dContinuousOff at first.
    pub fn dGeomGetContinuous(geom: dGeomID) -> c_int;
    /// A new convex geom in the space, or (0) in none: the convex hull of the points.
    ///
    /// The hull is that of pointcount points, 3 reals each, m, in the geom's frame. They are copied and may be
    /// in any order and anywhere. At most maxvertices of them become vertices, the farthest out first (at least
    /// 4; 0: no limit). Points in one plane, to a millionth of the extent (1e-5 in single precision), make one
    /// face. The result does not depend on the order of the points. Refused: fewer than 4 points; points that
    /// are all in one plane; more than 2^24.
    pub fn dCreateConvexHull(space: dSpaceID, points: *const dReal, pointcount: c_uint, maxvertices: c_uint) -> dGeomID;
    /// Make the geom convex the convex hull of the points.
    ///
    /// The hull is that of pointcount points, 3 reals each, m, in the geom's frame. They are copied and may be
    /// in any order and anywhere. At most maxvertices of them become vertices, the farthest out first (at least
    /// 4; 0: no limit). Points in one plane, to a millionth of the extent (1e-5 in single precision), make one
    /// face. The result does not depend on the order of the points. Refused: fewer than 4 points; points that
    /// are all in one plane; more than 2^24.
    pub fn dGeomSetConvexHull(convex: dGeomID, points: *const dReal, pointcount: c_uint, maxvertices: c_uint);
    /// Copy up to capacity of the vertices, 3 reals each, m, to points, in the order in
    /// which they were given. Returns how many vertices there are.
    ///
    /// Coordinates are in the geom's frame, as dCreateConvex takes them.
    pub fn dGeomConvexGetPoints(convex: dGeomID, points: *mut dReal, capacity: c_int) -> c_int;
    /// Copy up to capacity of the planes of the faces, 4 reals each, to planes: the
    /// unit outward normal n, and n . p of the face's points. Returns how many planes there are.
    ///
    /// Coordinates are in the geom's frame, as dCreateConvex takes them.
    pub fn dGeomConvexGetPlanes(convex: dGeomID, planes: *mut dReal, capacity: c_int) -> c_int;
    /// Copy up to capacity of the numbers that describe the faces to polygons: for
    /// each face the number of its corners and their indices among the vertices, counter-clockwise seen from
    /// outside. Returns how many numbers there are.
    ///
    /// Coordinates are in the geom's frame, as dCreateConvex takes them.
    pub fn dGeomConvexGetPolygons(convex: dGeomID, polygons: *mut c_uint, capacity: c_int) -> c_int;
    /// Set \*m to the mass of the geom convex filled with density, kg/m^3.
    ///
    /// The mass is that of the solid in the geom's own frame, exactly: centre of mass, and inertia about the
    /// frame's origin. For a body, move it to its centre with dMassTranslate and the geom with it
    /// (dGeomSetOffsetPosition). Refused: a plate without volume.
    pub fn dMassSetConvex(m: *mut dMass, density: dReal, convex: dGeomID);
    /// Set \*m to the mass of the geom convex that weighs total\_mass, kg.
    ///
    /// The mass is that of the solid in the geom's own frame, exactly: centre of mass, and inertia about the
    /// frame's origin. For a body, move it to its centre with dMassTranslate and the geom with it
    /// (dGeomSetOffsetPosition). Refused: a plate without volume.
    pub fn dMassSetConvexTotal(m: *mut dMass, total_mass: dReal, convex: dGeomID);
    /// Make the mesh the solid that its triangles enclose (solid 1) or, as in ODE and
    /// by default, their surface (0). A convex solid whose centre is inside a solid mesh is pushed out by the
    /// shortest way, however deep it is. docs/guide/shapes.md tells what other geoms and queries see.
    /// Refused: other values of solid; 1 for a mesh that is not closed (a triangle without a neighbour over
    /// an edge, or wound the other way) or that faces inward.
    pub fn dGeomTriMeshSetSolid(mesh: dGeomID, solid: c_int);
    /// 1 if the mesh is a solid now, else 0: data that are not closed make it a surface
    /// for as long as it has them.
    pub fn dGeomTriMeshGetSolid(mesh: dGeomID) -> c_int;
    /// Removes the cells whose byte is not 0 and restores all others: cell (i, j) is element i + j \* widthCells
    /// of holes, which is copied; 0: no holes. Call it while nothing is collided with the field. widthCells,
    /// depthCells: the numbers of cells along its width and depth. Refused: other numbers of cells; no memory.
    pub fn dGeomHeightfieldDataSetHoles(d: dHeightfieldDataID, holes: *const c_uchar, widthCells: c_int, depthCells: c_int);
    /// Remove cell (i, j) (hole 1) or restore it (0). Refused: other values of
    /// hole; no memory.
    pub fn dGeomHeightfieldDataSetHole(d: dHeightfieldDataID, i: c_int, j: c_int, hole: c_int);
    /// 1 if cell (i, j) has been removed, else 0.
    pub fn dGeomHeightfieldDataGetHole(d: dHeightfieldDataID, i: c_int, j: c_int) -> c_int;
    /// Returns how many bytes the state has now: another number when contacts come and go.
    pub fn dWorldGetStateSize(world: dWorldID) -> usize;
    /// Write the state to buffer, as many bytes as dWorldGetStateSize returns; size is how many the buffer has.
    /// The format has a version (that before is read, others are refused by name), is little endian, and has a
    /// checksum. Returns 1. Refused: a buffer that is too small.
    pub fn dWorldGetState(world: dWorldID, buffer: *mut c_void, size: usize) -> c_int;
    /// Give the world the state that dWorldGetState has written to buffer, this world's or that of another one of
    /// the same structure; size is how many bytes the buffer has, those behind the state's end are not looked at.
    /// Geoms are marked as moved, and no callback is called. Points that dWorldGetContacts returns lie where the
    /// bodies are now until the next step. Returns 1.
    pub fn dWorldSetState(world: dWorldID, buffer: *const c_void, size: usize) -> c_int;
    /// Write to out what dWorldGetState would write, as a difference from base, a state of
    /// base\_size bytes of the same structure: what sleeps costs next to nothing. capacity is how many bytes out
    /// has; 0: ask for the number alone, out may then be 0. Returns how many bytes the difference has; more
    /// than capacity: nothing was written.
    ///
    /// What has changed since another state, as bytes.
    pub fn dWorldGetStateDelta(world: dWorldID, base: *const c_void, base_size: usize, out: *mut c_void, capacity: usize) -> usize;
    /// Give the world the state that base and the difference, delta of delta\_size bytes,
    /// make up. Returns 1. Refused: another base than the one it was made from.
    ///
    /// What has changed since another state, as bytes.
    pub fn dWorldSetStateDelta(world: dWorldID, base: *const c_void, base_size: usize, delta: *const c_void, delta_size: usize) -> c_int;
    /// Keep the state now and after each of the coming steps, so that the last \`frames\` steps
    /// can be taken back; 0, the default: none. What was kept before is dropped. What the program destroys
    /// meanwhile is refused from then on, as always, but its memory is kept until no state has it. Returns 1.
    /// Refused: a number outside 0 ... 100000.
    ///
    /// Keep the states after the last steps inside the world, so that steps can be taken back.
    pub fn dWorldSetHistory(world: dWorldID, frames: c_int) -> c_int;
    /// Returns that number.
    ///
    /// Keep the states after the last steps inside the world, so that steps can be taken back.
    pub fn dWorldGetHistory(world: dWorldID) -> c_int;
    /// Take back the last \`frames\` steps, and all that the program has done since: the world goes on with the same
    /// bits as after that step. What has been destroyed since comes back under its handle, with data pointer, mass
    /// and attachments; what has been created since is destroyed, contact objects of ODE's way too. Returns 1.
    /// Refused, with nothing changed: more than dWorldGetHistoryFrames, a call during a step; by name, what cannot
    /// come back: another shape of a geom, drives that are new, destroyed spaces, transforms and geoms of a class
    /// of the program; fluids, vehicles or wheels made or lost; with couplings, \`joints\` or bodies made or lost.
    pub fn dWorldRollBack(world: dWorldID, frames: c_int) -> c_int;
    /// Returns how many steps can be taken back now. A step without memory for its state
    /// sends a message, and the history begins again: then 0.
    ///
    /// What the history has.
    pub fn dWorldGetHistoryFrames(world: dWorldID) -> c_int;
    /// Returns the bytes that the states take, without objects that may come back.
    ///
    /// What the history has.
    pub fn dWorldGetHistorySize(world: dWorldID) -> usize;
    /// Write the states of bodies to the rows of out. Returns 1.
    ///
    /// States of count bodies, which may be of several worlds, as arrays of count rows. A row has the parts that
    /// fields, a sum of dStateField, names, and begins stride numbers after the one before; stride 0: rows follow
    /// each other without gaps. Refused: a negative count, fields that are none, a stride above 0 and shorter
    /// than a row.
    pub fn dBodiesGetStates(bodies: *const dBodyID, count: c_int, fields: c_uint, out: *mut dReal, stride: c_int) -> c_int;
    /// Set the states of bodies from the rows of in, as dBodySetPosition and its sisters do:
    /// geoms are marked as moved once, dStateEnabled wakes bodies or disables them. Of a body that is named
    /// twice the later row counts. Returns 1. Refused, all of them: a row with a number that is not finite or a
    /// quaternion that is zero.
    ///
    /// States of count bodies, which may be of several worlds, as arrays of count rows. A row has the parts that
    /// fields, a sum of dStateField, names, and begins stride numbers after the one before; stride 0: rows follow
    /// each other without gaps. Refused: a negative count, fields that are none, a stride above 0 and shorter
    /// than a row.
    pub fn dBodiesSetStates(bodies: *const dBodyID, count: c_int, fields: c_uint, r#in: *const dReal, stride: c_int) -> c_int;
    /// Read the coordinates of the axes of count joints: positions into value and rates into rate, either of which
    /// may be 0, as dJointGetAxisPosition and dJointGetAxisRate return them. Rows have stride numbers; of each
    /// joint as many axes as fit, the rest is 0. Returns 1. Refused: a negative count, a stride below 1.
    pub fn dJointsGetStates(joints: *const dJointID, count: c_int, value: *mut dReal, rate: *mut dReal, stride: c_int) -> c_int;
    /// Write the bodies of the world to the array bodies. Returns how many there are.
    ///
    /// What a world has, from the oldest to the youngest, as many as capacity says; 0: ask for the number alone,
    /// the array may then be 0. Refused: a capacity below 0.
    pub fn dWorldGetBodies(world: dWorldID, bodies: *mut dBodyID, capacity: c_int) -> c_int;
    /// Write the joints of the world, contact joints too, to the array joints. Returns how
    /// many there are.
    ///
    /// What a world has, from the oldest to the youngest, as many as capacity says; 0: ask for the number alone,
    /// the array may then be 0. Refused: a capacity below 0.
    pub fn dWorldGetJoints(world: dWorldID, joints: *mut dJointID, capacity: c_int) -> c_int;
    /// Set the largest number of threads of a step of this world, the caller's
    /// included; 1 is the default, 0 means one for each processor, at most 64. The bits do not depend on it.
    /// Callbacks run on the caller's thread, memory handlers on any.
    /// dWorldSetStepIslandsProcessingMaxThreadCount limits the number further; an implementation set by
    /// dWorldSetStepThreadingImplementation replaces these threads. Negative numbers are refused.
    pub fn dWorldSetStepThreads(world: dWorldID, threads: c_int);
    /// The number that dWorldSetStepThreads has set, 1 at first.
    pub fn dWorldGetStepThreads(world: dWorldID) -> c_int;
    /// Set how much of the last step's constraint forces a step starts from:
    /// factor, 0 ... 1, of each stepper's usual share; default 1, 0 starts from nothing as ODE does. The
    /// answer of dWorldStep does not depend on it, only its time. Values outside 0 ... 1 are refused.
    pub fn dWorldSetStepWarmStarting(world: dWorldID, factor: dReal);
    /// The factor that dWorldSetStepWarmStarting has set, 1 at first.
    pub fn dWorldGetStepWarmStarting(world: dWorldID) -> dReal;
    /// Choose how the friction of contact joints is bounded. mode 0 (the default): each
    /// direction by itself, as ODE does. mode 1: both together, \|(f1/l1, f2/l2)\| \<= 1 with the limits l1 and
    /// l2 of the two directions: with one mu Coulomb's cone. World-managed contacts (ode/contacts.h) always
    /// have the cone in dWorldStepFast1 and dWorldQuickStep; in dWorldStep they have mode 1, too, and in mode 0
    /// bounds along their sliding and across. In dWorldStep limits follow in mode 1 from the present normal forces,
    /// not from those without friction: ladders stand. Refused: other values, a call during a step.
    pub fn dWorldSetFrictionCone(world: dWorldID, mode: c_int);
    /// The mode that dWorldSetFrictionCone has set, 0 at first.
    pub fn dWorldGetFrictionCone(world: dWorldID) -> c_int;
    /// Choose whether dWorldQuickStep and dWorldStepFast1 bound friction point by
    /// point (mode 0, the default) or once for all points of a manifold (mode 1): a force at the centre of
    /// the normal forces and a torque about the normal, bounded together. Feedback and reports still have
    /// each point's part. Faster for world-managed contacts, slower for contact joints. Other values are
    /// refused, as is a call during a step.
    pub fn dWorldSetManifoldFriction(world: dWorldID, mode: c_int);
    /// The mode that dWorldSetManifoldFriction has set, 0 at first.
    pub fn dWorldGetManifoldFriction(world: dWorldID) -> c_int;
    /// Choose how bodies under joints and contacts rotate: as ODE rotates them (mode 0, the default) or exactly
    /// (mode 1, dDefaultsGame and dDefaultsRobot), by the exponential map with the gyroscopic torque of the implicit midpoint rule: a free
    /// body keeps its energy and angular momentum while it turns by less than 2 rad in a step, a top its precession. A wheel that turns far
    /// in a step does so about the axis of its hinge, hinge-2, piston, universal or PU joint, and then with what carries it. Bodies on nothing
    /// rotate exactly in both modes, but with dBehaviour016 in mode 1 only. Other values are refused, as is a call during a step.
    pub fn dWorldSetExactRotation(world: dWorldID, mode: c_int);
    /// The mode that dWorldSetExactRotation has set, 0 at first.
    pub fn dWorldGetExactRotation(world: dWorldID) -> c_int;
    /// Choose whether dWorldStep solves islands of robots in the coordinates of their joints (mode 1, dDefaultsRobot and
    /// dDefaultsGame) or of their bodies (mode 0, the default): joints stay closed, energy does not drift, rotation is exact, and a robot's step costs a
    /// fraction. So where most joints are hinges, sliders, balls and fixed ones that have no springs of their own and are closed to the tolerance of
    /// dWorldSetStepProjection (joints that close loops, and those of other types, are solved with them), bodies turn by less than 2 rad in a step, no
    /// kinematic body that moves holds a joint, and loads do not make light links swing faster than it follows; contacts, stops, motors and drives may
    /// act, but where dWorldStepHybrid limits the time of exact steps, no contacts, few bodies and few of the others. Other islands are solved as in mode 0:
    /// dIslandStepReport::method says how. Other values are refused, as is a call during a step.
    pub fn dWorldSetJointCoordinates(world: dWorldID, mode: c_int);
    /// The mode that dWorldSetJointCoordinates has set, 0 at first.
    pub fn dWorldGetJointCoordinates(world: dWorldID) -> c_int;
    /// Set into how many equal substeps (count) dWorldStep divides its step; 1 is the
    /// default. Each is an exact solve with the poses, joints and stops of that moment, after one collision.
    /// ERP and CFM keep their meaning for the whole step, forces are held over it, and joint feedback is the
    /// mean. Errors fall as with as many steps; time grows with their number. Values outside 1 ... 1000 are
    /// refused.
    pub fn dWorldSetExactSubsteps(world: dWorldID, count: c_int);
    /// The number that dWorldSetExactSubsteps has set, 1 at first.
    pub fn dWorldGetExactSubsteps(world: dWorldID) -> c_int;
    /// Set how many Newton iterations on positions may follow each dWorldStep, 0
    /// (the default, as in ODE) to 100; 8 are plenty. They close joints until the worst error is below the
    /// tolerance, and push contacts apart by the share that is their ERP, without changing velocities.
    /// Springs, motors and friction are left alone. Costs about as much again as the step. Other values are
    /// refused.
    pub fn dWorldSetStepProjection(world: dWorldID, iterations: c_int);
    /// The number that dWorldSetStepProjection has set, 0 at first.
    pub fn dWorldGetStepProjection(world: dWorldID) -> c_int;
    /// Set the error (tolerance) that the projection need not remove: of
    /// angles in rad, of lengths as a share of the longest lever (from the centre of a body to the joint, at
    /// least its radius of gyration). Default 1e-4 (1e-3 in single precision). Values outside 0 ... 1, and
    /// both ends, are refused.
    pub fn dWorldSetStepProjectionTolerance(world: dWorldID, tolerance: dReal);
    /// The tolerance that dWorldSetStepProjectionTolerance has set; at
    /// first 1e-4, 1e-3 in single precision.
    pub fn dWorldGetStepProjectionTolerance(world: dWorldID) -> dReal;
    /// Advances the world by stepsize, s, and chooses the solver of each island. Everything else is as in
    /// dWorldStep. Returns 1. Refused: a stepsize that is not positive; a call during a step.
    pub fn dWorldStepHybrid(world: dWorldID, stepsize: dReal) -> c_int;
    /// Set how hybrid steps solve islands none of whose bodies requests a stepper;
    /// dStepperHybrid, the default, lets the library choose. Other numbers are refused.
    pub fn dWorldSetHybridStepper(world: dWorldID, stepper: c_int);
    /// What dWorldSetHybridStepper has set, dStepperHybrid at first.
    pub fn dWorldGetHybridStepper(world: dWorldID) -> c_int;
    /// Request a stepper for the body's island in hybrid steps; dStepperHybrid, the
    /// default: none. An island takes the most exact of those that its bodies request. Other numbers are
    /// refused.
    pub fn dBodySetHybridStepper(body: dBodyID, stepper: c_int);
    /// What dBodySetHybridStepper has set, dStepperHybrid at first.
    pub fn dBodyGetHybridStepper(body: dBodyID) -> c_int;
    /// Set how many substeps (count) a hybrid step has where it has any; default 4.
    /// Values outside 1 ... 10000 are refused.
    pub fn dWorldSetHybridSubsteps(world: dWorldID, count: c_int);
    /// The number that dWorldSetHybridSubsteps has set, 4 at first.
    pub fn dWorldGetHybridSubsteps(world: dWorldID) -> c_int;
    /// Set how long the exact solutions of a hybrid step may take together, times what
    /// substeps of all its islands would (times); default 1. What does not fit takes substeps. The same on every
    /// machine: work is counted, not timed, and 0.5 ms times \`times\` are always allowed. Islands whose bodies
    /// request dStepperExact, and those with couplings, do not count. 0: nothing else is solved exactly;
    /// dInfinity: whatever the rules of docs/solvers.md choose. Values below 0 are refused.
    pub fn dWorldSetHybridBudget(world: dWorldID, times: dReal);
    /// What dWorldSetHybridBudget has set, 1 at first.
    pub fn dWorldGetHybridBudget(world: dWorldID) -> dReal;
    /// Makes the given number of steps (at least 1) of stepsize, s, in each of count worlds, with one stepper
    /// (of dStepper), on at most so many threads, the caller's included (threads 0: one for each processor, at
    /// most 64). iterations, 1 ... 10000, is the number of substeps of dStepperSubsteps and
    /// dStepperSubstepsExactJoints. Writes to steps\_made, unless it is 0, how many steps each world has made: a
    /// world that finds no memory stops, the others go on. Returns how many have made them all. Refused, with
    /// no world changed: worlds that are 0, destroyed, in a step or in the array twice; a null array with a
    /// count above 0; another stepper; other numbers; a stepsize that is not positive.
    pub fn dWorldsStep(worlds: *const dWorldID, count: c_int, stepsize: dReal, stepper: c_int, iterations: c_int, steps: c_int, threads: c_int, steps_made: *mut c_int) -> c_int;
    /// Fills \*settings with the default of every field and writes struct\_size, which is sizeof(dVehicleSettings),
    /// to it: dVehicleSettingsInit(&settings, sizeof settings). Returns 1.
    pub fn dVehicleSettingsInit(settings: *mut dVehicleSettings, struct_size: c_uint) -> c_int;
    /// Fills \*wheel with the default of every field and writes struct\_size, which is sizeof(dVehicleWheel), to
    /// it: dVehicleWheelInit(&wheel, sizeof wheel). Returns 1.
    pub fn dVehicleWheelInit(wheel: *mut dVehicleWheel, struct_size: c_uint) -> c_int;
    /// Make the body a \`vehicle\` without wheels, in its first \`gear\`, the engine at idle; null settings are the defaults.
    /// A history (dWorldSetHistory) cannot take it back to before. Returns 1. Refused: a body that is a \`vehicle\`
    /// already.
    pub fn dVehicleCreate(body: dBodyID, settings: *const dVehicleSettings) -> c_int;
    /// Returns 1 if the body is a \`vehicle\`, else 0.
    pub fn dBodyIsVehicle(body: dBodyID) -> c_int;
    /// Give the vehicle other settings; a \`gear\` that it does not have any more becomes the
    /// highest. Returns 1. Refused: what dVehicleCreate refuses.
    ///
    /// The settings.
    pub fn dVehicleSetSettings(vehicle: dBodyID, settings: *const dVehicleSettings) -> c_int;
    /// Write the settings to \*settings, whose struct\_size the caller has set. Returns 1.
    ///
    /// The settings.
    pub fn dVehicleGetSettings(vehicle: dBodyID, settings: *mut dVehicleSettings) -> c_int;
    /// Add a wheel that does not turn; a null wheel is the default. Returns how many it has
    /// now: the number of the new one plus 1. Refused: more than dVehicleMaxWheels; a third wheel of an axle of
    /// a dVehicleCar.
    ///
    /// The wheels.
    pub fn dVehicleAddWheel(vehicle: dBodyID, wheel: *const dVehicleWheel) -> c_int;
    /// Return how many it has.
    ///
    /// The wheels.
    pub fn dVehicleGetNumWheels(vehicle: dBodyID) -> c_int;
    /// Give one other settings; it keeps its speed. Returns 1.
    ///
    /// The wheels.
    pub fn dVehicleSetWheel(vehicle: dBodyID, wheel: c_int, settings: *const dVehicleWheel) -> c_int;
    /// Write one to \*out, whose struct\_size the caller has set. Returns 1.
    ///
    /// The wheels.
    pub fn dVehicleGetWheel(vehicle: dBodyID, wheel: c_int, out: *mut dVehicleWheel) -> c_int;
    /// Set it; a change wakes a vehicle that has fallen asleep. Returns 1.
    ///
    /// What the driver does, until it is changed.
    pub fn dVehicleSetControls(vehicle: dBodyID, controls: *const dVehicleControls) -> c_int;
    /// Write it to \*controls, whose struct\_size the caller has set. Returns 1.
    ///
    /// What the driver does, until it is changed.
    pub fn dVehicleGetControls(vehicle: dBodyID, controls: *mut dVehicleControls) -> c_int;
    /// Shift: -1 reverse, 0 neutral, 1 ... forward. It takes the shift time. An automatic gearbox goes on from
    /// there, and never leaves reverse or neutral by itself. Returns 1. Refused: a gear that it does not
    /// have.
    pub fn dVehicleSetGear(vehicle: dBodyID, gear: c_int) -> c_int;
    /// Let wheels, engine and gears act for a step of h seconds: their forces join those of the program on the
    /// chassis and on the bodies under it, for the next step of the world. Call it once for each dWorldStep,
    /// before it, after the program's own forces on the chassis. A vehicle that sleeps costs nothing; it wakes when the
    /// throttle is open in a \`gear\` or what it stands on moves. Returns how many wheels stand on something.
    pub fn dVehicleUpdate(vehicle: dBodyID, h: dReal) -> c_int;
    /// The vehicle.
    ///
    /// Write what the last update has done to \*report, whose struct\_size the caller has set. Return 1.
    pub fn dVehicleGetReport(vehicle: dBodyID, report: *mut dVehicleReport) -> c_int;
    /// One of its wheels.
    ///
    /// Write what the last update has done to \*report, whose struct\_size the caller has set. Return 1.
    pub fn dVehicleGetWheelReport(vehicle: dBodyID, wheel: c_int, report: *mut dVehicleWheelReport) -> c_int;
    /// Create a world like this one and geoms like those of \*space, which becomes the new space;
    /// space may be 0. Write to table the handles of world, bodies, joints and geoms, as many as capacity says:
    /// the oldest first, spaces before their members. Capacity 0: table may be 0. Returns the new world.
    ///
    /// Clones of worlds, which share meshes and height fields. Refused, both: a call during a step, a space that
    /// is destroyed or lacks the contact space, geoms of the program's own classes.
    pub fn dWorldClone(world: dWorldID, space: *mut dSpaceID, table: *mut dHandlePair, capacity: c_int) -> dWorldID;
    /// Returns how many rows of handles a clone has.
    ///
    /// Clones of worlds, which share meshes and height fields. Refused, both: a call during a step, a space that
    /// is destroyed or lacks the contact space, geoms of the program's own classes.
    pub fn dWorldCountHandles(world: dWorldID, space: dSpaceID) -> c_int;
    /// Write the world to the file path, which is replaced when all is written. Returns 1. Refused:
    /// a path that cannot be written.
    ///
    /// Save structure and state, little endian, with a version and a checksum; later libraries of the same
    /// precision read it. Refused, both: what dWorldClone refuses.
    pub fn dWorldSave(world: dWorldID, space: dSpaceID, path: *const c_char) -> c_int;
    /// Write the same bytes to buffer, which has capacity bytes. Returns how many there are;
    /// more than capacity: nothing was written. Capacity 0: buffer may be 0.
    ///
    /// Save structure and state, little endian, with a version and a checksum; later libraries of the same
    /// precision read it. Refused, both: what dWorldClone refuses.
    pub fn dWorldSaveToBuffer(world: dWorldID, space: dSpaceID, buffer: *mut c_void, capacity: usize) -> usize;
    /// Load the file path. Returns the world. Refused: a file that cannot be read.
    ///
    /// Create a world with its spaces, geoms, meshes and height fields, and set \*space, which may be 0, to the
    /// outermost one. dGeomTriMeshGetData returns meshes, which are the program's to destroy. Refused, both: what
    /// is no world of a version and precision that this library reads, has changed, ends too early, or has what
    /// the interface would refuse.
    pub fn dWorldLoad(path: *const c_char, space: *mut dSpaceID) -> dWorldID;
    /// Load the world that buffer, of size bytes, begins with. Returns it.
    ///
    /// Create a world with its spaces, geoms, meshes and height fields, and set \*space, which may be 0, to the
    /// outermost one. dGeomTriMeshGetData returns meshes, which are the program's to destroy. Refused, both: what
    /// is no world of a version and precision that this library reads, has changed, ends too early, or has what
    /// the interface would refuse.
    pub fn dWorldLoadFromBuffer(buffer: *const c_void, size: usize, space: *mut dSpaceID) -> dWorldID;
    /// Makes the point offset (m, world) the new origin: subtracts it from the places of bodies, geoms of the space
    /// without bodies (0: the contact space), planes, anchors at the world, contacts, events, characters, vehicles
    /// and fluids. Nothing wakes or moves against anything else (docs/guide/howto/large\_worlds.md). A history
    /// begins again; states of before do not fit where planes or joints are at the world. Returns 1. Refused: a call
    /// during a step or a collision of the space; a space with geoms of another world's bodies; coordinates that
    /// would be no usable numbers; an offset along z in a world with plane joints, which hold bodies at z = 0.
    pub fn dWorldShiftOrigin(world: dWorldID, space: dSpaceID, offset: *const dReal) -> c_int;
    /// Set the n reals at a to zero.
    pub fn dSetZero(a: *mut dReal, n: c_int);
    /// Set the n reals at a to value.
    pub fn dSetValue(a: *mut dReal, n: c_int, value: dReal);
    /// Inner product of two vectors a and b of n reals.
    pub fn dDot(a: *const dReal, b: *const dReal, n: c_int) -> dReal;
    /// A = B C, with B p x q and C q x r.
    ///
    /// A is p x r and must not overlap B or C.
    pub fn dMultiply0(A: *mut dReal, B: *const dReal, C: *const dReal, p: c_int, q: c_int, r: c_int);
    /// A = B^T C, with B q x p and C q x r.
    ///
    /// A is p x r and must not overlap B or C.
    pub fn dMultiply1(A: *mut dReal, B: *const dReal, C: *const dReal, p: c_int, q: c_int, r: c_int);
    /// A = B C^T, with B p x q and C r x q.
    ///
    /// A is p x r and must not overlap B or C.
    pub fn dMultiply2(A: *mut dReal, B: *const dReal, C: *const dReal, p: c_int, q: c_int, r: c_int);
    /// Replace the lower triangle of the symmetric n x n matrix A by its Cholesky factor L; the upper
    /// triangle is neither read nor written. Returns 1, or 0 when A is not positive definite (the lower
    /// triangle is then partly overwritten).
    pub fn dFactorCholesky(A: *mut dReal, n: c_int) -> c_int;
    /// Solve L L^T x = b in place, L from dFactorCholesky.
    pub fn dSolveCholesky(L: *const dReal, b: *mut dReal, n: c_int);
    /// Ainv = A^-1 of a symmetric positive definite A (its lower triangle is used). Returns 1, or 0
    /// when A is not positive definite.
    pub fn dInvertPDMatrix(A: *const dReal, Ainv: *mut dReal, n: c_int) -> c_int;
    /// 1 when the symmetric matrix A (lower triangle) is positive definite, else 0. A is kept.
    pub fn dIsPositiveDefinite(A: *const dReal, n: c_int) -> c_int;
    /// A = L D L^T in place: L goes to the strict lower triangle, 1/D to d (n reals).
    pub fn dFactorLDLT(A: *mut dReal, d: *mut dReal, n: c_int, nskip: c_int);
    /// Solve L x = b for x.
    ///
    /// L is unit lower triangular, n x n with rows of nskip reals; the solution takes the place of b.
    pub fn dSolveL1(L: *const dReal, b: *mut dReal, n: c_int, nskip: c_int);
    /// Solve L^T x = b for x.
    ///
    /// L is unit lower triangular, n x n with rows of nskip reals; the solution takes the place of b.
    pub fn dSolveL1T(L: *const dReal, b: *mut dReal, n: c_int, nskip: c_int);
    /// a\[i\] \*= d\[i\] for n elements.
    pub fn dScaleVector(a: *mut dReal, d: *const dReal, n: c_int);
    /// Old name of dScaleVector: a\[i\] \*= d\[i\] for n elements.
    pub fn dVectorScale(a: *mut dReal, d: *const dReal, n: c_int);
    /// Solve L D L^T x = b in place, with L and d from dFactorLDLT.
    pub fn dSolveLDLT(L: *const dReal, d: *const dReal, b: *mut dReal, n: c_int, nskip: c_int);
    /// Update the factors for A + E, where E has a as its first row and first column and is zero
    /// elsewhere. Rows 1 ... n-1 of L (columns 1 and on) and d\[1 ... n-1\] are brought up to date, the
    /// first column of L and d\[0\] are not: the function serves to take row and column 0 out.
    pub fn dLDLTAddTL(L: *mut dReal, d: *mut dReal, a: *const dReal, n: c_int, nskip: c_int);
    /// Take row and column r out of a factorisation. A: n1 row pointers of a symmetric matrix (lower
    /// triangle used); p: n2 indices, L and d factor the n2 x n2 matrix A(p, p). Afterwards the leading
    /// n2-1 part of L and d factors it without index p\[r\]. p is not changed.
    pub fn dLDLTRemove(A: *mut *mut dReal, p: *const c_int, L: *mut dReal, d: *mut dReal, n1: c_int, n2: c_int, r: c_int, nskip: c_int);
    /// Delete row and column r of the n x n matrix A in place, closing up; the row length stays nskip.
    pub fn dRemoveRowCol(A: *mut dReal, n: c_int, nskip: c_int, r: c_int);
    /// What dCooperativelyFactorLDLT will need.
    pub fn dEstimateCooperativelyFactorLDLTResourceRequirements(requirements: dResourceRequirementsID, maximalAllowedThreadCount: c_uint, maximalRowCount: c_uint);
    /// dFactorLDLT: A = L D L^T in place, for symmetric A of rowCount rows, rowSkip reals apart, of which the
    /// lower triangle is read. L goes to the strict lower triangle, 1/D to d.
    pub fn dCooperativelyFactorLDLT(resources: dResourceContainerID, allowedThreadCount: c_uint, A: *mut dReal, d: *mut dReal, rowCount: c_uint, rowSkip: c_uint);
    /// What dCooperativelySolveLDLT will need.
    pub fn dEstimateCooperativelySolveLDLTResourceRequirements(requirements: dResourceRequirementsID, maximalAllowedThreadCount: c_uint, maximalRowCount: c_uint);
    /// dSolveLDLT: L D L^T x = b in place of b, with L and d (1/D) of the factorisation.
    pub fn dCooperativelySolveLDLT(resources: dResourceContainerID, allowedThreadCount: c_uint, L: *const dReal, d: *const dReal, b: *mut dReal, rowCount: c_uint, rowSkip: c_uint);
    /// What dCooperativelySolveL1Straight will need.
    pub fn dEstimateCooperativelySolveL1StraightResourceRequirements(requirements: dResourceRequirementsID, maximalAllowedThreadCount: c_uint, maximalRowCount: c_uint);
    /// dSolveL1: L x = b in place of b, L unit lower triangular (its diagonal is not read).
    pub fn dCooperativelySolveL1Straight(resources: dResourceContainerID, allowedThreadCount: c_uint, L: *const dReal, b: *mut dReal, rowCount: c_uint, rowSkip: c_uint);
    /// What dCooperativelySolveL1Transposed will need.
    pub fn dEstimateCooperativelySolveL1TransposedResourceRequirements(requirements: dResourceRequirementsID, maximalAllowedThreadCount: c_uint, maximalRowCount: c_uint);
    /// dSolveL1T: L^T x = b in place of b.
    pub fn dCooperativelySolveL1Transposed(resources: dResourceContainerID, allowedThreadCount: c_uint, L: *const dReal, b: *mut dReal, rowCount: c_uint, rowSkip: c_uint);
    /// What dCooperativelyScaleVector will need.
    pub fn dEstimateCooperativelyScaleVectorResourceRequirements(requirements: dResourceRequirementsID, maximalAllowedThreadCount: c_uint, maximalElementCount: c_uint);
    /// dScaleVector: dataVector\[i\] \*= scaleVector\[i\] for elementCount elements.
    pub fn dCooperativelyScaleVector(resources: dResourceContainerID, allowedThreadCount: c_uint, dataVector: *mut dReal, scaleVector: *const dReal, elementCount: c_uint);
    /// Install the function fn that gives memory in place of malloc.
    ///
    /// Process-wide. NULL brings the default back.
    pub fn dSetAllocHandler(r#fn: dAllocFunction);
    /// Install the function fn that changes the size of a block in place of realloc.
    ///
    /// Process-wide. NULL brings the default back.
    pub fn dSetReallocHandler(r#fn: dReallocFunction);
    /// Install the function fn that takes memory back in place of free.
    ///
    /// Process-wide. NULL brings the default back.
    pub fn dSetFreeHandler(r#fn: dFreeFunction);
    /// The function that dSetAllocHandler has installed, or NULL if it is the default one.
    pub fn dGetAllocHandler() -> dAllocFunction;
    /// The function that dSetReallocHandler has installed, or NULL if it is the default
    /// one.
    pub fn dGetReallocHandler() -> dReallocFunction;
    /// The function that dSetFreeHandler has installed, or NULL if it is the default one.
    pub fn dGetFreeHandler() -> dFreeFunction;
    /// A block of size bytes; NULL if there is no memory.
    ///
    /// Uses the handler that the program has installed, or the default one.
    pub fn dAlloc(size: usize) -> *mut c_void;
    /// Change the block ptr from oldsize to newsize bytes, keeping what fits; returns where it is
    /// now, or NULL if there is no memory.
    ///
    /// Uses the handler that the program has installed, or the default one.
    pub fn dRealloc(ptr: *mut c_void, oldsize: usize, newsize: usize) -> *mut c_void;
    /// Take the block ptr of size bytes back. A NULL ptr does nothing and calls no handler.
    ///
    /// Uses the handler that the program has installed, or the default one.
    pub fn dFree(ptr: *mut c_void, size: usize);
    /// 1 when the generator gives its known first numbers. The state is kept.
    pub fn dTestRand() -> c_int;
    /// Check the library's containers against plain arrays.
    ///
    /// The result is written to the standard output. Takes some hundredths of a second; dRand is not disturbed.
    pub fn dTestDataStructures();
    /// Check the solvers of dWorldStep on random linear complementarity problems. Returns 1 if
    /// all were solved to rounding, else 0.
    ///
    /// The result is written to the standard output. Takes some hundredths of a second; dRand is not disturbed.
    pub fn dTestSolveLCP() -> c_int;
    /// The next number, 0 ... 2^32 - 1.
    pub fn dRand() -> c_ulong;
    /// The state of the generator behind dRand.
    pub fn dRandGetSeed() -> c_ulong;
    /// Set the state of the generator behind dRand to s, so that what follows can be repeated.
    pub fn dRandSetSeed(s: c_ulong);
    /// An integer 0 ... n-1 from one draw of dRand; 0 when n \<= 1.
    pub fn dRandInt(n: c_int) -> c_int;
    /// A real in \[0, 1\] from one draw of dRand; both ends can occur.
    pub fn dRandReal() -> dReal;
    /// Print the n x m matrix A to the file f, each element with the printf format fmt, a line per row.
    pub fn dPrintMatrix(A: *const dReal, n: c_int, m: c_int, fmt: *const c_char, f: *mut FILE);
    /// Fill the vector A of n reals with numbers from -range ... range.
    pub fn dMakeRandomVector(A: *mut dReal, n: c_int, range: dReal);
    /// Fill the n x m matrix A row by row with numbers from -range ... range; its padding
    /// is not written.
    pub fn dMakeRandomMatrix(A: *mut dReal, n: c_int, m: c_int, range: dReal);
    /// Zero the elements above the diagonal of the n x n matrix A.
    pub fn dClearUpperTriangle(A: *mut dReal, n: c_int);
    /// The largest absolute difference of two n x m matrices A and B.
    pub fn dMaxDifference(A: *const dReal, B: *const dReal, n: c_int, m: c_int) -> dReal;
    /// The largest absolute difference of the lower triangles, diagonal included,
    /// of two n x n matrices A and B.
    pub fn dMaxDifferenceLowerTriangle(A: *const dReal, B: *const dReal, n: c_int) -> dReal;
    /// A new, empty world with no gravity.
    pub fn dWorldCreate() -> dWorldID;
    /// Destroy a world with all its bodies and all its joints that are in no joint group. Geoms survive
    /// without a body. Joints in groups lose their world and bodies (a message is sent for each) and go with
    /// their group.
    pub fn dWorldDestroy(world: dWorldID);
    /// Store a pointer of the program's, data, with the world; NULL at first. The library never
    /// looks at it.
    pub fn dWorldSetData(world: dWorldID, data: *mut c_void);
    /// The pointer that the program stored with dWorldSetData; NULL if it stored none.
    pub fn dWorldGetData(world: dWorldID) -> *mut c_void;
    /// Set gravity to (x, y, z), m/s^2, world frame; default (0, 0, 0). It acts on every
    /// body whose gravity mode is on.
    pub fn dWorldSetGravity(world: dWorldID, x: dReal, y: dReal, z: dReal);
    /// Write the world's gravity, m/s^2, to gravity: 3 reals, world frame.
    pub fn dWorldGetGravity(world: dWorldID, gravity: *mut dReal);
    /// Set the world's error reduction parameter erp: the part of joint errors that is corrected
    /// per step, sensibly 0.1 ... 0.8, default 0.2. Joints use the current value, except those parameters that
    /// a joint copies when it is created (dParamERP, dParamStopERP, dParamSuspensionERP).
    pub fn dWorldSetERP(world: dWorldID, erp: dReal);
    /// The world's error reduction parameter, 0.2 at first.
    pub fn dWorldGetERP(world: dWorldID) -> dReal;
    /// Set the world's constraint force mixing cfm: the softness of joints, sensibly 1e-9 ... 1,
    /// default 1e-10 (1e-5 in single precision). Joints use the current value, except those parameters that a
    /// joint copies when it is created (dParamCFM, dParamStopCFM, dParamSuspensionCFM). The default has a limit
    /// under heavy bodies (docs/guide/softness.md); other numbers are literal. A negative one is refused.
    pub fn dWorldSetCFM(world: dWorldID, cfm: dReal);
    /// The world's constraint force mixing; at first 1e-10, 1e-5 in single precision.
    pub fn dWorldGetCFM(world: dWorldID) -> dReal;
    /// Who does the work of a world's steps: a threading implementation of the library (ode/threading\_impl.h) or
    /// of the program, given by its table functions\_info (which is copied) and its handle threading\_impl.
    /// Islands, and parts of large islands, become calls of it, as many at a time as it has threads (at most 64),
    /// at least one; the thread that steps waits for them. A step has the same bits as without. Both NULL, the
    /// default: the calling thread, or those of dWorldSetStepThreads (ode/ext.h), which does not count while an
    /// implementation is set. One implementation may serve several worlds, also at the same time. Refused: one of
    /// the two NULL, struct\_size too small or a function missing, during a step. When the implementation cannot
    /// prepare for a step (its preallocation or its wait fails) the step returns 0 and the world stays as it was.
    pub fn dWorldSetStepThreadingImplementation(world: dWorldID, functions_info: *const dThreadingFunctionsInfo, threading_impl: dThreadingImplementationID);
    /// Set the most threads (count) that work on a step; 0 (the
    /// default, dWORLDSTEP\_THREADCOUNT\_UNLIMITED) sets no limit. It is a limit only: a world that has been
    /// given no threads steps on the calling thread.
    pub fn dWorldSetStepIslandsProcessingMaxThreadCount(world: dWorldID, count: c_uint);
    /// The most threads that work on a step; 0: no limit.
    pub fn dWorldGetStepIslandsProcessingMaxThreadCount(world: dWorldID) -> c_uint;
    /// Let the world use the working memory of from\_world, and its settings, from now on (it is made if
    /// from\_world has none); it is given back with the last world that uses it. The worlds must not step at the
    /// same time: a step that would is refused. A world that has working memory already is refused; from\_world
    /// NULL takes it away first: the world's next step begins with memory and settings as in a new world. Returns
    /// 1, or 0 when refused or out of memory.
    pub fn dWorldUseSharedWorkingMemory(world: dWorldID, from_world: dWorldID) -> c_int;
    /// Give the blocks back at once, with what the world keeps to save time; settings stay, and no result
    /// changes. Concerns all worlds that share the memory.
    pub fn dWorldCleanupWorkingMemory(world: dWorldID);
    /// Set the reserve for blocks taken from now on, to a copy of \*policyinfo; NULL: back to the defaults.
    /// Returns 1, or 0 when refused (a factor below 1 or not finite, struct\_size too small) or out of memory.
    pub fn dWorldSetStepMemoryReservationPolicy(world: dWorldID, policyinfo: *const dWorldStepReserveInfo) -> c_int;
    /// Take blocks from a copy of \*memfuncs from now on; NULL: from dAlloc again. Blocks that are there already
    /// go back where they came from. Returns 1, or 0 when refused (alloc\_block or free\_block NULL, struct\_size too
    /// small) or out of memory.
    pub fn dWorldSetStepMemoryManager(world: dWorldID, memfuncs: *const dWorldStepMemoryFunctionsInfo) -> c_int;
    /// Advance by stepsize seconds with the exact solver: the mixed complementarity problem of each island is
    /// solved to rounding. Friction limits are taken from the normal forces of the frictionless solution.
    /// Time grows with the cube, memory with the square of the constraint rows in an island. Order:
    /// auto-disable test; islands; per island forces, rows, solution, new velocities, new positions, moved
    /// callbacks. Force and torque accumulators of stepped bodies are zero afterwards. Returns 1; 0 when
    /// refused (stepsize not positive and finite) or out of memory: poses, velocities and accumulators are
    /// then as they were.
    pub fn dWorldStep(world: dWorldID, stepsize: dReal) -> c_int;
    /// Advance by stepsize seconds with the iterative solver (projected successive over-relaxation): time and
    /// memory linear in the rows. Friction limits follow the normal forces during the iteration. All else as
    /// dWorldStep.
    pub fn dWorldQuickStep(world: dWorldID, stepsize: dReal) -> c_int;
    /// The constant force (N, 3 reals written) that gives the impulse (ix, iy, iz), N s, within one step of
    /// stepsize seconds, which must not be 0: impulse / stepsize.
    pub fn dWorldImpulseToForce(world: dWorldID, stepsize: dReal, ix: dReal, iy: dReal, iz: dReal, force: *mut dReal);
    /// Set how many iterations (num) dWorldQuickStep makes, default 20. 0 or
    /// less lets the joints exert no force. More than 100000 are refused.
    pub fn dWorldSetQuickStepNumIterations(world: dWorldID, num: c_int);
    /// How many iterations dWorldQuickStep makes, 20 at first.
    pub fn dWorldGetQuickStepNumIterations(world: dWorldID) -> c_int;
    /// Set the factor over\_relaxation of dWorldQuickStep, sensibly within (0, 2), default
    /// 1.3.
    pub fn dWorldSetQuickStepW(world: dWorldID, over_relaxation: dReal);
    /// The factor of over-relaxation of dWorldQuickStep, 1.3 at first.
    pub fn dWorldGetQuickStepW(world: dWorldID) -> dReal;
    /// Set the greatest velocity vel, m/s, that a contact may use to undo
    /// penetration, and, if finite, to move joints back from beyond stops; default dInfinity. Bouncing is free. If
    /// it is finite, a step that would throw an island by closing joints or contacts makes a share of that.
    pub fn dWorldSetContactMaxCorrectingVel(world: dWorldID, vel: dReal);
    /// The greatest velocity that a contact may use to undo penetration,
    /// m/s; dInfinity at first.
    pub fn dWorldGetContactMaxCorrectingVel(world: dWorldID) -> dReal;
    /// Set the depth of penetration, m, that contacts leave alone so that they
    /// persist; default 0.
    pub fn dWorldSetContactSurfaceLayer(world: dWorldID, depth: dReal);
    /// The depth of penetration that contacts leave alone, m; 0 at first.
    pub fn dWorldGetContactSurfaceLayer(world: dWorldID) -> dReal;
    /// Set the linear speed linear\_average\_threshold, m/s, up to which
    /// new bodies count as idle; default 0.01.
    pub fn dWorldSetAutoDisableLinearThreshold(world: dWorldID, linear_average_threshold: dReal);
    /// The linear speed up to which new bodies count as idle, m/s; 0.01
    /// at first.
    pub fn dWorldGetAutoDisableLinearThreshold(world: dWorldID) -> dReal;
    /// Set the angular speed angular\_average\_threshold, rad/s, up to
    /// which new bodies count as idle; default 0.01.
    pub fn dWorldSetAutoDisableAngularThreshold(world: dWorldID, angular_average_threshold: dReal);
    /// The angular speed up to which new bodies count as idle, rad/s;
    /// 0.01 at first.
    pub fn dWorldGetAutoDisableAngularThreshold(world: dWorldID) -> dReal;
    /// Set over how many steps (average\_samples\_count) the velocities
    /// of new bodies are averaged, as vectors, so that swinging cancels. Default 1: the current velocity; 0:
    /// never disable. More than 2^20 are refused.
    pub fn dWorldSetAutoDisableAverageSamplesCount(world: dWorldID, average_samples_count: c_uint);
    /// Over how many steps the velocities of new bodies are averaged,
    /// 1 at first.
    pub fn dWorldGetAutoDisableAverageSamplesCount(world: dWorldID) -> c_int;
    /// Set how many idle steps new bodies need before they are disabled; default
    /// 10.
    pub fn dWorldSetAutoDisableSteps(world: dWorldID, steps: c_int);
    /// How many idle steps new bodies need before they are disabled, 10 at first.
    pub fn dWorldGetAutoDisableSteps(world: dWorldID) -> c_int;
    /// Set how much idle time, s, new bodies need before they are disabled; default
    /// 0.
    pub fn dWorldSetAutoDisableTime(world: dWorldID, time: dReal);
    /// How much idle time new bodies need before they are disabled, s; 0 at first.
    pub fn dWorldGetAutoDisableTime(world: dWorldID) -> dReal;
    /// Set whether new bodies disable themselves (do\_auto\_disable not 0); default 0.
    pub fn dWorldSetAutoDisableFlag(world: dWorldID, do_auto_disable: c_int);
    /// Non-zero if new bodies disable themselves, else 0.
    pub fn dWorldGetAutoDisableFlag(world: dWorldID) -> c_int;
    /// Set the linear speed threshold, m/s, from which on damping acts on new
    /// bodies; default 0.01.
    pub fn dWorldSetLinearDampingThreshold(world: dWorldID, threshold: dReal);
    /// The linear speed from which on damping acts on new bodies, m/s; 0.01
    /// at first.
    pub fn dWorldGetLinearDampingThreshold(world: dWorldID) -> dReal;
    /// Set the angular speed threshold, rad/s, from which on damping acts on
    /// new bodies; default 0.01.
    pub fn dWorldSetAngularDampingThreshold(world: dWorldID, threshold: dReal);
    /// The angular speed from which on damping acts on new bodies, rad/s;
    /// 0.01 at first.
    pub fn dWorldGetAngularDampingThreshold(world: dWorldID) -> dReal;
    /// Set the scale of linear damping of new bodies, sensibly 0 ... 1; default 0, no
    /// damping.
    pub fn dWorldSetLinearDamping(world: dWorldID, scale: dReal);
    /// The scale of linear damping of new bodies, 0 at first.
    pub fn dWorldGetLinearDamping(world: dWorldID) -> dReal;
    /// Set the scale of angular damping of new bodies, sensibly 0 ... 1; default 0,
    /// no damping.
    pub fn dWorldSetAngularDamping(world: dWorldID, scale: dReal);
    /// The scale of angular damping of new bodies, 0 at first.
    pub fn dWorldGetAngularDamping(world: dWorldID) -> dReal;
    /// Set the scales of linear (linear\_scale) and angular damping (angular\_scale) of new
    /// bodies, each sensibly 0 ... 1; default 0, no damping.
    pub fn dWorldSetDamping(world: dWorldID, linear_scale: dReal, angular_scale: dReal);
    /// Set the angular speed max\_speed, rad/s, that new bodies are held to; default
    /// dInfinity.
    pub fn dWorldSetMaxAngularSpeed(world: dWorldID, max_speed: dReal);
    /// The angular speed that new bodies are held to, rad/s; dInfinity at first.
    pub fn dWorldGetMaxAngularSpeed(world: dWorldID) -> dReal;
    /// A new body in the world: at the origin, not rotated, at rest, mass 1 kg with unit inertia, enabled;
    /// gravity and gyroscopic mode on; auto-disable, damping and speed limit as the world has them now.
    pub fn dBodyCreate(world: dWorldID) -> dBodyID;
    /// Destroy a body. Its geoms stay where they are, without a body. Its joints stay, detached from both of
    /// their bodies.
    pub fn dBodyDestroy(body: dBodyID);
    /// The world that the body is in.
    pub fn dBodyGetWorld(body: dBodyID) -> dWorldID;
    /// Store a pointer of the program's, data, with the body; NULL at first. The library never
    /// looks at it.
    pub fn dBodySetData(body: dBodyID, data: *mut c_void);
    /// The pointer that the program stored with dBodySetData; NULL if it stored none.
    pub fn dBodyGetData(body: dBodyID) -> *mut c_void;
    /// Position of the body's origin, which is its centre of mass, m.
    pub fn dBodySetPosition(body: dBodyID, x: dReal, y: dReal, z: dReal);
    /// Set the body's orientation, from body to world, by the rotation matrix R (12 reals,
    /// made orthonormal here). A degenerate matrix is refused.
    pub fn dBodySetRotation(body: dBodyID, R: *const dReal);
    /// Set the body's orientation, from body to world, by the quaternion q (4 reals,
    /// normalised here). A zero quaternion is refused.
    pub fn dBodySetQuaternion(body: dBodyID, q: *const dReal);
    /// Set the velocity of the body's centre of mass to (x, y, z), m/s.
    pub fn dBodySetLinearVel(body: dBodyID, x: dReal, y: dReal, z: dReal);
    /// Set the body's angular velocity to (x, y, z), rad/s.
    pub fn dBodySetAngularVel(body: dBodyID, x: dReal, y: dReal, z: dReal);
    /// A pointer to the body's position, 3 reals, m.
    ///
    /// The pointer stays valid as long as the body, and shows its current state.
    pub fn dBodyGetPosition(body: dBodyID) -> *const dReal;
    /// A pointer to the body's rotation matrix, from body to world, 12 reals.
    ///
    /// The pointer stays valid as long as the body, and shows its current state.
    pub fn dBodyGetRotation(body: dBodyID) -> *const dReal;
    /// A pointer to the body's orientation as a quaternion, from body to world, 4 reals.
    ///
    /// The pointer stays valid as long as the body, and shows its current state.
    pub fn dBodyGetQuaternion(body: dBodyID) -> *const dReal;
    /// A pointer to the velocity of the body's centre of mass, 3 reals, m/s.
    ///
    /// The pointer stays valid as long as the body, and shows its current state.
    pub fn dBodyGetLinearVel(body: dBodyID) -> *const dReal;
    /// A pointer to the body's angular velocity, 3 reals, rad/s.
    ///
    /// The pointer stays valid as long as the body, and shows its current state.
    pub fn dBodyGetAngularVel(body: dBodyID) -> *const dReal;
    /// Copy the body's position, m, to pos: 3 reals.
    pub fn dBodyCopyPosition(body: dBodyID, pos: *mut dReal);
    /// Copy the body's rotation matrix, from body to world, to R: 12 reals.
    pub fn dBodyCopyRotation(body: dBodyID, R: *mut dReal);
    /// Copy the body's orientation, from body to world, to the quaternion quat: 4 reals.
    pub fn dBodyCopyQuaternion(body: dBodyID, quat: *mut dReal);
    /// Give the body a copy of \*mass; it becomes dynamic. Refused if the centre of mass is not
    /// at the origin or dMassCheck says no.
    pub fn dBodySetMass(body: dBodyID, mass: *const dMass);
    /// Write the body's mass to \*mass. A kinematic body has one in store.
    pub fn dBodyGetMass(body: dBodyID, mass: *mut dMass);
    /// Add the force (fx, fy, fz), N, world frame, at the body's centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddForce(body: dBodyID, fx: dReal, fy: dReal, fz: dReal);
    /// Add the torque (fx, fy, fz), N m, world frame.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddTorque(body: dBodyID, fx: dReal, fy: dReal, fz: dReal);
    /// Add the force (fx, fy, fz), N, in the body's axes, at the body's centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddRelForce(body: dBodyID, fx: dReal, fy: dReal, fz: dReal);
    /// Add the torque (fx, fy, fz), N m, in the body's axes.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddRelTorque(body: dBodyID, fx: dReal, fy: dReal, fz: dReal);
    /// Add the force (fx, fy, fz), N, world frame, at the world's point (px, py, pz), with
    /// its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddForceAtPos(body: dBodyID, fx: dReal, fy: dReal, fz: dReal, px: dReal, py: dReal, pz: dReal);
    /// Add the force (fx, fy, fz), N, world frame, at the point (px, py, pz) of the
    /// body's frame, with its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddForceAtRelPos(body: dBodyID, fx: dReal, fy: dReal, fz: dReal, px: dReal, py: dReal, pz: dReal);
    /// Add the force (fx, fy, fz), N, in the body's axes, at the world's point (px, py,
    /// pz), with its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddRelForceAtPos(body: dBodyID, fx: dReal, fy: dReal, fz: dReal, px: dReal, py: dReal, pz: dReal);
    /// Add the force (fx, fy, fz), N, in the body's axes, at the point (px, py, pz)
    /// of the body's frame, with its torque about the centre of mass.
    ///
    /// It acts during the whole next step and is zeroed after it, as are all others that have been added.
    pub fn dBodyAddRelForceAtRelPos(body: dBodyID, fx: dReal, fy: dReal, fz: dReal, px: dReal, py: dReal, pz: dReal);
    /// A pointer to the sum of the forces that have been added for the next step: 3 reals, N,
    /// world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    pub fn dBodyGetForce(body: dBodyID) -> *const dReal;
    /// A pointer to the sum of the torques that have been added for the next step: 3 reals, N
    /// m, world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    pub fn dBodyGetTorque(body: dBodyID) -> *const dReal;
    /// Set the sum of the forces for the next step to (x, y, z), N, world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    pub fn dBodySetForce(body: dBodyID, x: dReal, y: dReal, z: dReal);
    /// Set the sum of the torques for the next step to (x, y, z), N m, world frame.
    ///
    /// A step clears the sums of all bodies. With dBehaviour016 a disabled body keeps its sum until it moves again.
    pub fn dBodySetTorque(body: dBodyID, x: dReal, y: dReal, z: dReal);
    /// The position in the world, m, of the point (px, py, pz) of the body's frame.
    pub fn dBodyGetRelPointPos(body: dBodyID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// The velocity in the world, m/s, of the point (px, py, pz) of the body's frame.
    pub fn dBodyGetRelPointVel(body: dBodyID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// Velocity of the body's material at the world point (px, py, pz), m/s, world frame.
    pub fn dBodyGetPointVel(body: dBodyID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// Body coordinates of the world point (px, py, pz).
    pub fn dBodyGetPosRelPoint(body: dBodyID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// The direction (px, py, pz) of the body's frame, turned to the world's axes.
    pub fn dBodyVectorToWorld(body: dBodyID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// The direction (px, py, pz) of the world, turned to the body's axes.
    pub fn dBodyVectorFromWorld(body: dBodyID, px: dReal, py: dReal, pz: dReal, result: *mut dReal);
    /// Set how the body's orientation is advanced (mode). 0 (default): q += h/2
    /// (0, w) q, normalised; cheap, inexact at high spin. Non-zero: the exact rotation by \|w\| h; with a finite
    /// rotation axis only the part of w about that axis is treated exactly.
    pub fn dBodySetFiniteRotationMode(body: dBodyID, mode: c_int);
    /// Non-zero if the body's orientation is advanced by exact rotations, else 0,
    /// the default.
    pub fn dBodyGetFiniteRotationMode(body: dBodyID) -> c_int;
    /// Set the axis of fast spin to (x, y, z), world frame, normalised here; (0,
    /// 0, 0), the default, means none.
    pub fn dBodySetFiniteRotationAxis(body: dBodyID, x: dReal, y: dReal, z: dReal);
    /// Write the axis of fast spin, a unit vector in the world's frame, to result;
    /// zeros: none.
    pub fn dBodyGetFiniteRotationAxis(body: dBodyID, result: *mut dReal);
    /// How many joints are attached to the body.
    pub fn dBodyGetNumJoints(body: dBodyID) -> c_int;
    /// The joint number index of those attached to the body, 0 being the one attached most
    /// recently; 0 for an index that there is not.
    pub fn dBodyGetJoint(body: dBodyID, index: c_int) -> dJointID;
    /// Make the body dynamic, which is the default, with the mass that it had.
    ///
    /// A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it acts
    /// on others as if infinitely heavy.
    pub fn dBodySetDynamic(body: dBodyID);
    /// Make the body kinematic; it keeps its mass in store.
    ///
    /// A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it acts
    /// on others as if infinitely heavy.
    pub fn dBodySetKinematic(body: dBodyID);
    /// 1 if the body is kinematic, else 0.
    ///
    /// A kinematic body moves by its velocity alone: forces, gravity and joints do not act on it, while it acts
    /// on others as if infinitely heavy.
    pub fn dBodyIsKinematic(body: dBodyID) -> c_int;
    /// Wake the body and restart its idle counters. New bodies are enabled.
    ///
    /// A disabled body is not stepped until it is enabled or an enabled body reaches it through a joint; it
    /// keeps its velocity.
    pub fn dBodyEnable(body: dBodyID);
    /// Put the body to sleep.
    ///
    /// A disabled body is not stepped until it is enabled or an enabled body reaches it through a joint; it
    /// keeps its velocity.
    pub fn dBodyDisable(body: dBodyID);
    /// 1 if the body is enabled, 0 if it is disabled.
    ///
    /// A disabled body is not stepped until it is enabled or an enabled body reaches it through a joint; it
    /// keeps its velocity.
    pub fn dBodyIsEnabled(body: dBodyID) -> c_int;
    /// Set whether the world's gravity acts on the body (mode not 0); default 1.
    pub fn dBodySetGravityMode(body: dBodyID, mode: c_int);
    /// Non-zero if the world's gravity acts on the body, else 0.
    pub fn dBodyGetGravityMode(body: dBodyID) -> c_int;
    /// Set whether the gyroscopic torque -w x I w is applied to the body (enabled not
    /// 0), by an implicit formula that is stable at any spin; default on.
    pub fn dBodySetGyroscopicMode(body: dBodyID, enabled: c_int);
    /// Non-zero if the gyroscopic torque is applied to the body, else 0.
    pub fn dBodyGetGyroscopicMode(body: dBodyID) -> c_int;
    /// A function (callback) that is called with every body that a step moved, after its new pose is set and
    /// before damping. It must not destroy the body or change the world's structure. NULL (default): none.
    pub fn dBodySetMovedCallback(body: dBodyID, callback: Option<unsafe extern "C" fn(dBodyID)>);
    /// The geom that was put on the body most recently, or 0.
    pub fn dBodyGetFirstGeom(body: dBodyID) -> dGeomID;
    /// The geom of the same body that was put on it just before geom, or 0.
    pub fn dBodyGetNextGeom(geom: dGeomID) -> dGeomID;
    /// Set the averaged linear speed linear\_average\_threshold, m/s, up to
    /// which the body counts as idle.
    pub fn dBodySetAutoDisableLinearThreshold(body: dBodyID, linear_average_threshold: dReal);
    /// The averaged linear speed up to which the body counts as idle, m/s.
    pub fn dBodyGetAutoDisableLinearThreshold(body: dBodyID) -> dReal;
    /// Set the averaged angular speed angular\_average\_threshold, rad/s,
    /// up to which the body counts as idle.
    pub fn dBodySetAutoDisableAngularThreshold(body: dBodyID, angular_average_threshold: dReal);
    /// The averaged angular speed up to which the body counts as idle,
    /// rad/s.
    pub fn dBodyGetAutoDisableAngularThreshold(body: dBodyID) -> dReal;
    /// Set over how many steps (average\_samples\_count) the body's
    /// velocities are averaged; more than 2^20 are refused. Changing the count throws the samples gathered so
    /// far away.
    pub fn dBodySetAutoDisableAverageSamplesCount(body: dBodyID, average_samples_count: c_uint);
    /// Over how many steps the body's velocities are averaged.
    pub fn dBodyGetAutoDisableAverageSamplesCount(body: dBodyID) -> c_int;
    /// Set how many idle steps the body needs before it is disabled. The new value
    /// counts from the next restart of the idle counters.
    pub fn dBodySetAutoDisableSteps(body: dBodyID, steps: c_int);
    /// How many idle steps the body needs before it is disabled.
    pub fn dBodyGetAutoDisableSteps(body: dBodyID) -> c_int;
    /// Set how much idle time, s, the body needs before it is disabled. The new value
    /// counts from the next restart of the idle counters.
    pub fn dBodySetAutoDisableTime(body: dBodyID, time: dReal);
    /// How much idle time the body needs before it is disabled, s.
    pub fn dBodyGetAutoDisableTime(body: dBodyID) -> dReal;
    /// Switch automatic disabling of the body on (do\_auto\_disable not 0) or off. Off
    /// also enables the body and takes steps, time and sample count over from the world.
    pub fn dBodySetAutoDisableFlag(body: dBodyID, do_auto_disable: c_int);
    /// Non-zero if the body disables itself, else 0.
    pub fn dBodyGetAutoDisableFlag(body: dBodyID) -> c_int;
    /// Take all auto-disable settings over from the world.
    pub fn dBodySetAutoDisableDefaults(body: dBodyID);
    /// Take all damping settings over from the world.
    pub fn dBodySetDampingDefaults(body: dBodyID);
    /// Set the scale of the body's linear damping, sensibly 0 ... 1; 0: no damping.
    pub fn dBodySetLinearDamping(body: dBodyID, scale: dReal);
    /// The scale of the body's linear damping.
    pub fn dBodyGetLinearDamping(body: dBodyID) -> dReal;
    /// Set the scale of the body's angular damping, sensibly 0 ... 1; 0: no damping.
    pub fn dBodySetAngularDamping(body: dBodyID, scale: dReal);
    /// The scale of the body's angular damping.
    pub fn dBodyGetAngularDamping(body: dBodyID) -> dReal;
    /// Set the scales of the body's linear (linear\_scale) and angular damping
    /// (angular\_scale), each sensibly 0 ... 1; 0: no damping.
    pub fn dBodySetDamping(body: dBodyID, linear_scale: dReal, angular_scale: dReal);
    /// Set the linear speed threshold, m/s, from which on damping acts on the
    /// body.
    pub fn dBodySetLinearDampingThreshold(body: dBodyID, threshold: dReal);
    /// The linear speed from which on damping acts on the body, m/s.
    pub fn dBodyGetLinearDampingThreshold(body: dBodyID) -> dReal;
    /// Set the angular speed threshold, rad/s, from which on damping acts on
    /// the body.
    pub fn dBodySetAngularDampingThreshold(body: dBodyID, threshold: dReal);
    /// The angular speed from which on damping acts on the body, rad/s.
    pub fn dBodyGetAngularDampingThreshold(body: dBodyID) -> dReal;
    /// Set the angular speed max\_speed, rad/s, that the body is held to.
    pub fn dBodySetMaxAngularSpeed(body: dBodyID, max_speed: dReal);
    /// The angular speed that the body is held to, rad/s.
    pub fn dBodyGetMaxAngularSpeed(body: dBodyID) -> dReal;
    /// A new ball joint, which holds a point of each body together.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateBall(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new hinge: a common point and a common axis.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateHinge(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new slider, which lets the bodies move along one axis only.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateSlider(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new hinge-2, a car wheel on its chassis.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateHinge2(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new universal (cardan) joint.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateUniversal(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new fixed joint, which holds the bodies' relative pose.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateFixed(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new angular motor.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateAMotor(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new linear motor.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateLMotor(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new plane joint, which keeps a body in the plane z = 0.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreatePlane2D(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new prismatic-rotoid joint: a slide and a turn.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreatePR(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new prismatic-universal joint: a slide and a universal joint.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreatePU(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new piston, which slides along an axis and turns about it.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreatePiston(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new double ball joint, which keeps the distance of two points.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateDBall(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new double hinge: a bar with parallel hinges at its ends.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateDHinge(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A new transmission: gears, bevel gears or wheels with a chain.
    ///
    /// It is made in the world, in the group or (0) alone, attached to nothing and without effect so far. 0 if
    /// the call is refused or memory is exhausted.
    pub fn dJointCreateTransmission(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A joint in the world, in the group or alone, that only connects: it has no constraint but joins
    /// islands and counts in dAreConnected.
    pub fn dJointCreateNull(world: dWorldID, group: dJointGroupID) -> dJointID;
    /// A contact in the world, in the group or alone. \*contact is copied; geom.g1 and geom.g2 do not choose
    /// the bodies, dJointAttach does. Meant to live for one step: put it in a group and empty the group after
    /// the step.
    pub fn dJointCreateContact(world: dWorldID, group: dJointGroupID, contact: *const dContact) -> dJointID;
    /// Destroy the joint, which leaves its bodies. A joint in a group is left alone: it goes with its group.
    pub fn dJointDestroy(joint: dJointID);
    /// A set of joints that are destroyed together, cheaply. max\_size is not used; give 0.
    pub fn dJointGroupCreate(max_size: c_int) -> dJointGroupID;
    /// Destroy the group and all its joints.
    pub fn dJointGroupDestroy(group: dJointGroupID);
    /// Destroy all joints of the group, which stays usable.
    pub fn dJointGroupEmpty(group: dJointGroupID);
    /// Attach to two bodies body1 and body2, or to one body and the world (the other being 0); (0, 0)
    /// detaches. The bodies must be different and of the joint's world; hinge-2 and transmission need both.
    /// (0, body) is allowed: the joint then counts the world as its first body, and angles and positions
    /// change sign accordingly. Attaching anew keeps the anchor and axes in the new first body's frame.
    pub fn dJointAttach(joint: dJointID, body1: dBodyID, body2: dBodyID);
    /// How many bodies are attached to the joint: 0, 1 or 2.
    pub fn dJointGetNumBodies(joint: dJointID) -> c_int;
    /// The body of the joint with this index, 0 or 1 as in dJointAttach; 0 if there is none, or
    /// for another index.
    pub fn dJointGetBody(joint: dJointID, index: c_int) -> dBodyID;
    /// Let the joint act again. New joints are enabled.
    ///
    /// A disabled joint exerts no force and connects no island, but stays attached.
    pub fn dJointEnable(joint: dJointID);
    /// Let the joint act no more until dJointEnable.
    ///
    /// A disabled joint exerts no force and connects no island, but stays attached.
    pub fn dJointDisable(joint: dJointID);
    /// 1 if the joint is enabled, 0 if it is disabled.
    ///
    /// A disabled joint exerts no force and connects no island, but stays attached.
    pub fn dJointIsEnabled(joint: dJointID) -> c_int;
    /// Store a pointer of the program's, data, with the joint; NULL at first. The library never
    /// looks at it.
    pub fn dJointSetData(joint: dJointID, data: *mut c_void);
    /// The pointer that the program stored with dJointSetData; NULL if it stored none.
    pub fn dJointGetData(joint: dJointID) -> *mut c_void;
    /// The joint's type; dJointTypeNone when refused.
    pub fn dJointGetType(joint: dJointID) -> dJointType;
    /// Set where each step writes the joint's forces: \*feedback (common.h), N and N m,
    /// world frame. The struct belongs to the program and must outlive its use. NULL (default): nowhere. With
    /// one body attached only f1 and t1 are written. Motor forces applied while at a stop, and the
    /// dJointAdd... functions, are not included.
    pub fn dJointSetFeedback(joint: dJointID, feedback: *mut dJointFeedback);
    /// The struct that dJointSetFeedback has set, or NULL.
    pub fn dJointGetFeedback(joint: dJointID) -> *mut dJointFeedback;
    /// A joint between body1 and body2, the one attached most recently, or 0.
    ///
    /// One of the bodies may be 0: the world.
    pub fn dConnectingJoint(body1: dBodyID, body2: dBodyID) -> dJointID;
    /// Write all joints between body1 and body2, most recently attached first, to the
    /// caller's array list (as many as dBodyGetNumJoints says are enough) and return how many.
    ///
    /// One of the bodies may be 0: the world.
    pub fn dConnectingJointList(body1: dBodyID, body2: dBodyID, list: *mut dJointID) -> c_int;
    /// 1 if a joint connects body1 and body2 directly, else 0.
    ///
    /// body1 must not be 0; body2 may be: the world.
    pub fn dAreConnected(body1: dBodyID, body2: dBodyID) -> c_int;
    /// 1 if a joint of another type than joint\_type (usually dJointTypeContact)
    /// connects body1 and body2 directly, else 0.
    ///
    /// body1 must not be 0; body2 may be: the world.
    pub fn dAreConnectedExcluding(body1: dBodyID, body2: dBodyID, joint_type: c_int) -> c_int;
    /// The point that both bodies have in common. Default: the origin of each body.
    pub fn dJointSetBallAnchor(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Sets only body 2's anchor; (x, y, z) is in body 2's frame (in the world's when there is no body 2).
    pub fn dJointSetBallAnchor2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Write the anchor as body 1 has it now to result, m, world frame. It differs from
    /// dJointGetBallAnchor2 by the joint's error.
    pub fn dJointGetBallAnchor(joint: dJointID, result: *mut dReal);
    /// Write the anchor as body 2 has it now to result, m, world frame. It differs from
    /// dJointGetBallAnchor by the joint's error.
    pub fn dJointGetBallAnchor2(joint: dJointID, result: *mut dReal);
    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    pub fn dJointSetBallParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    pub fn dJointGetBallParam(joint: dJointID, parameter: c_int) -> dReal;
    /// The point that both bodies have in common. The angle then reads 0.
    pub fn dJointSetHingeAnchor(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// As dJointSetHingeAnchor, with body 2's anchor moved by (ax, ay, az), m, when body 2 is the world.
    pub fn dJointSetHingeAnchorDelta(joint: dJointID, x: dReal, y: dReal, z: dReal, ax: dReal, ay: dReal, az: dReal);
    /// The axis that both bodies have in common. The angle then reads 0.
    pub fn dJointSetHingeAxis(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Sets the axis and shifts the zero of the angle, rad. With t the turn about the axis from body 2's
    /// orientation to body 1's, the angle then reads 2 t - angle: t if the bodies are turned by the given angle,
    /// -angle if they are not turned; attached as (0, B), all of it counts the turn the other way round.
    pub fn dJointSetHingeAxisOffset(joint: dJointID, x: dReal, y: dReal, z: dReal, angle: dReal);
    /// Set a parameter of the hinge's limit and motor to value; its unit is in the table
    /// of parameters.
    pub fn dJointSetHingeParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of the hinge's limit and motor.
    pub fn dJointGetHingeParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Apply a torque (N m) about the axis to body 1 and the opposite to body 2, for the next step.
    pub fn dJointAddHingeTorque(joint: dJointID, torque: dReal);
    /// Write the anchor as body 1 has it now to result, m, world frame. It differs from
    /// dJointGetHingeAnchor2 by the joint's error.
    pub fn dJointGetHingeAnchor(joint: dJointID, result: *mut dReal);
    /// Write the anchor as body 2 has it now to result, m, world frame. It differs from
    /// dJointGetHingeAnchor by the joint's error.
    pub fn dJointGetHingeAnchor2(joint: dJointID, result: *mut dReal);
    /// The axis as body 1 has it now, a unit vector.
    pub fn dJointGetHingeAxis(joint: dJointID, result: *mut dReal);
    /// The rotation of body 1 relative to body 2 about the axis since the anchor or axis
    /// was set, rad, within \[-pi, pi\].
    ///
    /// It changes sign when the joint is attached as (0, body).
    pub fn dJointGetHingeAngle(joint: dJointID) -> dReal;
    /// The rate of the hinge's angle, rad/s.
    ///
    /// It changes sign when the joint is attached as (0, body).
    pub fn dJointGetHingeAngleRate(joint: dJointID) -> dReal;
    /// The axis of the sliding. The position then reads 0, and the present rotation is the one to keep.
    pub fn dJointSetSliderAxis(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Sets the axis, with the zero position shifted by (ax, ay, az), m, when body 2 is the world: the
    /// position then reads -(axis . a).
    pub fn dJointSetSliderAxisDelta(joint: dJointID, x: dReal, y: dReal, z: dReal, ax: dReal, ay: dReal, az: dReal);
    /// Set a parameter of the slider's limit and motor to value; its unit is in the
    /// table of parameters.
    pub fn dJointSetSliderParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of the slider's limit and motor.
    pub fn dJointGetSliderParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step; the torque
    /// that keeps angular momentum is added, too.
    pub fn dJointAddSliderForce(joint: dJointID, force: dReal);
    /// How far body 1 has moved along the axis, relative to body 2, since the axis
    /// was set, m.
    ///
    /// It changes sign when the joint is attached as (0, body).
    pub fn dJointGetSliderPosition(joint: dJointID) -> dReal;
    /// The rate of the slider's position, m/s.
    ///
    /// It changes sign when the joint is attached as (0, body).
    pub fn dJointGetSliderPositionRate(joint: dJointID) -> dReal;
    /// The axis as body 1 has it now, a unit vector.
    pub fn dJointGetSliderAxis(joint: dJointID, result: *mut dReal);
    /// The point that both bodies have in common. The angles then read 0.
    pub fn dJointSetUniversalAnchor(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis 1, which moves with body 1; set it perpendicular to axis 2.
    ///
    /// The angles then read 0.
    pub fn dJointSetUniversalAxis1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis 2, which moves with body 2; set it perpendicular to axis 1.
    ///
    /// The angles then read 0.
    pub fn dJointSetUniversalAxis2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis 1, which moves with body 1, and the angles.
    ///
    /// The zeros are shifted so that the angles now read offset1 and offset2, rad.
    pub fn dJointSetUniversalAxis1Offset(joint: dJointID, x: dReal, y: dReal, z: dReal, offset1: dReal, offset2: dReal);
    /// Set axis 2, which moves with body 2, and the angles.
    ///
    /// The zeros are shifted so that the angles now read offset1 and offset2, rad.
    pub fn dJointSetUniversalAxis2Offset(joint: dJointID, x: dReal, y: dReal, z: dReal, offset1: dReal, offset2: dReal);
    /// Set a parameter of one of the two limits and motors to value: of axis 1 by the
    /// plain names, of axis 2 by those that end in 2.
    pub fn dJointSetUniversalParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of one of the two limits and motors: of axis 1 by the
    /// plain names, of axis 2 by those that end in 2.
    pub fn dJointGetUniversalParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    /// the next step.
    pub fn dJointAddUniversalTorques(joint: dJointID, torque1: dReal, torque2: dReal);
    /// Write the anchor as body 1 has it now to result, m, world frame. It differs
    /// from dJointGetUniversalAnchor2 by the joint's error.
    pub fn dJointGetUniversalAnchor(joint: dJointID, result: *mut dReal);
    /// Write the anchor as body 2 has it now to result, m, world frame. It differs
    /// from dJointGetUniversalAnchor by the joint's error.
    pub fn dJointGetUniversalAnchor2(joint: dJointID, result: *mut dReal);
    /// Write axis 1 as body 1 has it now to result: a unit vector, world frame.
    pub fn dJointGetUniversalAxis1(joint: dJointID, result: *mut dReal);
    /// Write axis 2 as body 2 has it now to result: a unit vector, world frame.
    pub fn dJointGetUniversalAxis2(joint: dJointID, result: *mut dReal);
    /// Write the angles between body 1 and the cross piece about axis 1, and between
    /// body 2 and the cross piece about axis 2, to \*angle1 and \*angle2: rad, within \[-pi, pi\]. Neither pointer
    /// may be null.
    pub fn dJointGetUniversalAngles(joint: dJointID, angle1: *mut dReal, angle2: *mut dReal);
    /// The angle between body 1 and the cross piece about axis 1, rad, within \[-pi,
    /// pi\].
    pub fn dJointGetUniversalAngle1(joint: dJointID) -> dReal;
    /// The angle between body 2 and the cross piece about axis 2, rad, within \[-pi,
    /// pi\].
    pub fn dJointGetUniversalAngle2(joint: dJointID) -> dReal;
    /// The rate of the angle about axis 1, rad/s.
    pub fn dJointGetUniversalAngle1Rate(joint: dJointID) -> dReal;
    /// The rate of the angle about axis 2, rad/s.
    pub fn dJointGetUniversalAngle2Rate(joint: dJointID) -> dReal;
    /// The centre of the wheel, common to both bodies. The angles then read 0.
    pub fn dJointSetHinge2Anchor(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis1 and axis2, each 3 reals, world frame, of any length but zero; NULL keeps one (not both). Two
    /// parallel axes are refused; one alone may be parallel to the other until that is set too (while they are,
    /// one turn is left free). The angles then read 0.
    pub fn dJointSetHinge2Axes(joint: dJointID, axis1: *const dReal, axis2: *const dReal);
    /// Old form: set axis 1, of the steering, which moves with body 1.
    ///
    /// The other axis stays. dJointSetHinge2Axes sets both.
    pub fn dJointSetHinge2Axis1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Old form: set axis 2, of the spin, which moves with body 2.
    ///
    /// The other axis stays. dJointSetHinge2Axes sets both.
    pub fn dJointSetHinge2Axis2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set a parameter to value: of axis 1 by the plain names, of the motor of axis 2 by
    /// those that end in 2, of the suspension dParamSuspensionERP and dParamSuspensionCFM.
    pub fn dJointSetHinge2Param(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter: of axis 1 by the plain names, of the motor of axis 2 by
    /// those that end in 2, of the suspension dParamSuspensionERP and dParamSuspensionCFM.
    pub fn dJointGetHinge2Param(joint: dJointID, parameter: c_int) -> dReal;
    /// Apply torque1 about axis 1 and torque2 about axis 2 (N m) to body 1 and the opposite to body 2, for
    /// the next step.
    pub fn dJointAddHinge2Torques(joint: dJointID, torque1: dReal, torque2: dReal);
    /// Write the anchor as body 1 has it now to result, m, world frame. It differs from
    /// dJointGetHinge2Anchor2 by the travel of the suspension.
    pub fn dJointGetHinge2Anchor(joint: dJointID, result: *mut dReal);
    /// Write the anchor as body 2 has it now to result, m, world frame. It differs
    /// from dJointGetHinge2Anchor by the travel of the suspension.
    pub fn dJointGetHinge2Anchor2(joint: dJointID, result: *mut dReal);
    /// Write axis 1 as body 1 has it now to result: a unit vector, world frame.
    pub fn dJointGetHinge2Axis1(joint: dJointID, result: *mut dReal);
    /// Write axis 2 as body 2 has it now to result: a unit vector, world frame.
    pub fn dJointGetHinge2Axis2(joint: dJointID, result: *mut dReal);
    /// Steering angle of body 1 relative to body 2 about axis 1, within (-pi, pi\], rad.
    pub fn dJointGetHinge2Angle1(joint: dJointID) -> dReal;
    /// Spin angle about axis 2, within (-pi, pi\], rad: it grows as the wheel turns forward about axis 2.
    pub fn dJointGetHinge2Angle2(joint: dJointID) -> dReal;
    /// The rate of the steering angle, of body 1 relative to body 2 about axis 1,
    /// rad/s.
    pub fn dJointGetHinge2Angle1Rate(joint: dJointID) -> dReal;
    /// The angular velocity of body 1 relative to body 2 about axis 2, rad/s. It
    /// has the opposite sign of the change of dJointGetHinge2Angle2.
    pub fn dJointGetHinge2Angle2Rate(joint: dJointID) -> dReal;
    /// Take the current relative pose as the one to keep. Call it after attaching: attaching alone does not.
    pub fn dJointSetFixed(joint: dJointID);
    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    pub fn dJointSetFixedParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    pub fn dJointGetFixedParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Set what mode the motor is in. dAMotorUser (default): the program sets axes and,
    /// for stops, angles. dAMotorEuler: three axes, of which the program sets axis 0 (fixed in body 1) and
    /// axis 2 (fixed in body 2), perpendicular at that time; axis 1 and the Euler angles follow. The angle
    /// about axis 1 must stay within (-pi/2, pi/2): give it stops. Another mode is refused.
    pub fn dJointSetAMotorMode(joint: dJointID, mode: c_int);
    /// The motor's mode: dAMotorUser or dAMotorEuler.
    pub fn dJointGetAMotorMode(joint: dJointID) -> c_int;
    /// Set how many axes are in use: num is 0 ... 3 (others are refused), default 0;
    /// in Euler mode it is always 3.
    pub fn dJointSetAMotorNumAxes(joint: dJointID, num: c_int);
    /// How many axes are in use.
    pub fn dJointGetAMotorNumAxes(joint: dJointID) -> c_int;
    /// Set axis anum to (x, y, z), world frame, and what it moves with: rel 0 the world,
    /// 1 body 1, 2 body 2. In Euler mode axis 0 goes with body 1 and axis 2 with body 2: with rel 0 their
    /// (x, y, z) are in the frame of that body, and the other body is refused.
    pub fn dJointSetAMotorAxis(joint: dJointID, anum: c_int, rel: c_int, x: dReal, y: dReal, z: dReal);
    /// Write axis anum as it is now to result: a unit vector, world frame.
    pub fn dJointGetAMotorAxis(joint: dJointID, anum: c_int, result: *mut dReal);
    /// What axis anum moves with: 0 the world, 1 body 1, 2 body 2.
    pub fn dJointGetAMotorAxisRel(joint: dJointID, anum: c_int) -> c_int;
    /// Tell the motor the angle about axis anum, rad, with which stops are compared;
    /// default 0. A program in user mode does so before each step; in Euler mode the call is refused.
    pub fn dJointSetAMotorAngle(joint: dJointID, anum: c_int, angle: dReal);
    /// The angle about axis anum, rad: in user mode what the program has set, in Euler
    /// mode that of the last step.
    pub fn dJointGetAMotorAngle(joint: dJointID, anum: c_int) -> dReal;
    /// Relative angular velocity of the bodies about axis anum, rad/s.
    pub fn dJointGetAMotorAngleRate(joint: dJointID, anum: c_int) -> dReal;
    /// Set a parameter of one of the three limits and motors to value: of axis 0 by the
    /// plain names, of axis 1 and 2 by those that end in 2 and 3.
    pub fn dJointSetAMotorParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of one of the three limits and motors: of axis 0 by the
    /// plain names, of axis 1 and 2 by those that end in 2 and 3.
    pub fn dJointGetAMotorParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Apply torque1, torque2, torque3 (N m) about the axes in use to body 1 and the opposite to body 2, for
    /// the next step.
    pub fn dJointAddAMotorTorques(joint: dJointID, torque1: dReal, torque2: dReal, torque3: dReal);
    /// Set how many axes are in use: num, held to 0 ... 3; default 0.
    pub fn dJointSetLMotorNumAxes(joint: dJointID, num: c_int);
    /// How many axes are in use.
    pub fn dJointGetLMotorNumAxes(joint: dJointID) -> c_int;
    /// Axis anum (0, 1, 2) and what it turns with: rel 0 the world, 1 body 1, 2 body 2 (body 1 when there is
    /// no body 2). (x, y, z) is in the world frame in any case.
    pub fn dJointSetLMotorAxis(joint: dJointID, anum: c_int, rel: c_int, x: dReal, y: dReal, z: dReal);
    /// Axis anum as it is stored: result is in the frame of the body it turns with, or in the world's.
    pub fn dJointGetLMotorAxis(joint: dJointID, anum: c_int, result: *mut dReal);
    /// Set a parameter of one of the three motors to value: of axis 0 by the plain
    /// names, of axis 1 and 2 by those that end in 2 and 3.
    pub fn dJointSetLMotorParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of one of the three motors: of axis 0 by the plain
    /// names, of axis 1 and 2 by those that end in 2 and 3.
    pub fn dJointGetLMotorParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Set a parameter of the motor along x to value.
    ///
    /// The plain names are meant; there are no stops.
    pub fn dJointSetPlane2DXParam(joint: dJointID, parameter: c_int, value: dReal);
    /// Set a parameter of the motor along y to value.
    ///
    /// The plain names are meant; there are no stops.
    pub fn dJointSetPlane2DYParam(joint: dJointID, parameter: c_int, value: dReal);
    /// Set a parameter of the motor about z to value.
    ///
    /// The plain names are meant; there are no stops.
    pub fn dJointSetPlane2DAngleParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The point on the turning axis. The position reads 0 afterwards; the angle keeps its zero.
    pub fn dJointSetPRAnchor(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis 1, along which the anchor slides.
    ///
    /// It sets the zero of the angle, too.
    pub fn dJointSetPRAxis1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis 2, about which body 2 turns.
    ///
    /// It sets the zero of the angle, too.
    pub fn dJointSetPRAxis2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set a parameter of a limit and motor to value: of the slide by the plain names, of
    /// the turn by those that end in 2.
    pub fn dJointSetPRParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of a limit and motor: of the slide by the plain names, of
    /// the turn by those that end in 2.
    pub fn dJointGetPRParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Apply a torque (N m) about axis 2 to body 1 and the opposite to body 2, for the next step.
    pub fn dJointAddPRTorque(joint: dJointID, torque: dReal);
    /// The anchor as body 2 has it now.
    pub fn dJointGetPRAnchor(joint: dJointID, result: *mut dReal);
    /// Write the axis of the slide as body 1 has it now to result: a unit vector, world
    /// frame.
    pub fn dJointGetPRAxis1(joint: dJointID, result: *mut dReal);
    /// Write the axis of the turn as body 1 has it now to result: a unit vector, world
    /// frame.
    pub fn dJointGetPRAxis2(joint: dJointID, result: *mut dReal);
    /// How far body 1's anchor is along axis 1 from body 2's, m.
    pub fn dJointGetPRPosition(joint: dJointID) -> dReal;
    /// The rate of the position along axis 1, m/s, where body 1 does not turn: its
    /// angular velocity is not counted.
    pub fn dJointGetPRPositionRate(joint: dJointID) -> dReal;
    /// The rotation of body 1 relative to body 2 about axis 2, rad, within \[-pi, pi\].
    pub fn dJointGetPRAngle(joint: dJointID) -> dReal;
    /// The rate of the angle about axis 2, rad/s.
    pub fn dJointGetPRAngleRate(joint: dJointID) -> dReal;
    /// The point where axes 1 and 2 meet. The position and the angles read 0 afterwards.
    pub fn dJointSetPUAnchor(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// As dJointSetPUAnchor, as if the bodies had come apart by (dx, dy, dz), m, since: the position reads
    /// axis 3 . (dx, dy, dz).
    pub fn dJointSetPUAnchorOffset(joint: dJointID, x: dReal, y: dReal, z: dReal, dx: dReal, dy: dReal, dz: dReal);
    /// Old form: the position reads -axis 3 . (dx, dy, dz), m, or plus when attached as (0, body).
    pub fn dJointSetPUAnchorDelta(joint: dJointID, x: dReal, y: dReal, z: dReal, dx: dReal, dy: dReal, dz: dReal);
    /// Set axis 1 of the universal joint, which moves with body 1. It sets the zeros of the
    /// angles, too.
    pub fn dJointSetPUAxis1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis 2 of the universal joint, which moves with body 2. It sets the zeros of the
    /// angles, too.
    pub fn dJointSetPUAxis2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set axis 3, along which the anchor slides.
    pub fn dJointSetPUAxis3(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Another name of dJointSetPUAxis3: set the axis along which the anchor slides.
    pub fn dJointSetPUAxisP(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set a parameter of a limit and motor to value: of axis 1 by the plain names, of axis
    /// 2 and the slide by those that end in 2 and 3.
    pub fn dJointSetPUParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of a limit and motor: of axis 1 by the plain names, of axis
    /// 2 and the slide by those that end in 2 and 3.
    pub fn dJointGetPUParam(joint: dJointID, parameter: c_int) -> dReal;
    /// The anchor as body 2 has it now.
    pub fn dJointGetPUAnchor(joint: dJointID, result: *mut dReal);
    /// Write axis 1 of the universal joint as body 1 has it now to result: a unit vector,
    /// world frame.
    pub fn dJointGetPUAxis1(joint: dJointID, result: *mut dReal);
    /// Write axis 2 of the universal joint as body 2 has it now to result: a unit vector,
    /// world frame.
    pub fn dJointGetPUAxis2(joint: dJointID, result: *mut dReal);
    /// Write axis 3, of the slide, as body 1 has it now to result: a unit vector, world
    /// frame.
    pub fn dJointGetPUAxis3(joint: dJointID, result: *mut dReal);
    /// Another name of dJointGetPUAxis3: write the axis of the slide to result, a unit
    /// vector, world frame.
    pub fn dJointGetPUAxisP(joint: dJointID, result: *mut dReal);
    /// How far body 1's anchor is along axis 3 from body 2's, m.
    pub fn dJointGetPUPosition(joint: dJointID) -> dReal;
    /// The rate of the position along axis 3, m/s, where body 2 does not turn: its
    /// angular velocity is counted with the opposite sign.
    pub fn dJointGetPUPositionRate(joint: dJointID) -> dReal;
    /// Write the angles about axis 1 and axis 2 to \*angle1 and \*angle2: rad, as of the
    /// universal joint. Neither pointer may be null.
    pub fn dJointGetPUAngles(joint: dJointID, angle1: *mut dReal, angle2: *mut dReal);
    /// The angle about axis 1, rad, as of the universal joint.
    pub fn dJointGetPUAngle1(joint: dJointID) -> dReal;
    /// The rate of the angle about axis 1, rad/s.
    pub fn dJointGetPUAngle1Rate(joint: dJointID) -> dReal;
    /// The angle about axis 2, rad, as of the universal joint.
    pub fn dJointGetPUAngle2(joint: dJointID) -> dReal;
    /// The rate of the angle about axis 2, rad/s.
    pub fn dJointGetPUAngle2Rate(joint: dJointID) -> dReal;
    /// A point on the axis. The position and the angle read 0 afterwards.
    pub fn dJointSetPistonAnchor(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// As dJointSetPistonAnchor, as if the bodies had come apart by (dx, dy, dz), m, since: the position
    /// reads axis . (dx, dy, dz).
    pub fn dJointSetPistonAnchorOffset(joint: dJointID, x: dReal, y: dReal, z: dReal, dx: dReal, dy: dReal, dz: dReal);
    /// The axis of the slide and the turn. Sets the zero of the angle, too.
    pub fn dJointSetPistonAxis(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Old form of little use: sets the axis, and the vector from body 1 to its anchor to the position of
    /// body 1 relative to body 2 (to the world) minus (ax, ay, az). Use dJointSetPistonAnchorOffset.
    pub fn dJointSetPistonAxisDelta(joint: dJointID, x: dReal, y: dReal, z: dReal, ax: dReal, ay: dReal, az: dReal);
    /// Set a parameter of a limit and motor to value: of the slide by the plain names,
    /// of the turn by those that end in 2.
    pub fn dJointSetPistonParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of a limit and motor: of the slide by the plain names,
    /// of the turn by those that end in 2.
    pub fn dJointGetPistonParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Apply a force (N) along the axis to body 1 and the opposite to body 2, for the next step: on each of
    /// two bodies at its anchor, on one body at its centre.
    pub fn dJointAddPistonForce(joint: dJointID, force: dReal);
    /// Write the anchor as body 1 has it now to result, m, world frame.
    pub fn dJointGetPistonAnchor(joint: dJointID, result: *mut dReal);
    /// Write the anchor as body 2 has it now to result, m, world frame.
    pub fn dJointGetPistonAnchor2(joint: dJointID, result: *mut dReal);
    /// The axis as body 1 has it now, a unit vector.
    pub fn dJointGetPistonAxis(joint: dJointID, result: *mut dReal);
    /// How far body 1's anchor is along the axis from body 2's, m.
    pub fn dJointGetPistonPosition(joint: dJointID) -> dReal;
    /// The velocity along the axis of body 1's centre relative to body 2's, m/s.
    pub fn dJointGetPistonPositionRate(joint: dJointID) -> dReal;
    /// The rotation of body 1 relative to body 2 about the axis, rad, within \[-pi, pi\].
    pub fn dJointGetPistonAngle(joint: dJointID) -> dReal;
    /// The rate of the angle about the axis, rad/s.
    pub fn dJointGetPistonAngleRate(joint: dJointID) -> dReal;
    /// Set the point of body 1, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    pub fn dJointSetDBallAnchor1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set the point of body 2, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    pub fn dJointSetDBallAnchor2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set the distance to keep, m; a negative one is refused.
    pub fn dJointSetDBallDistance(joint: dJointID, distance: dReal);
    /// The distance to keep, m, which need not be the present one.
    pub fn dJointGetDBallDistance(joint: dJointID) -> dReal;
    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    pub fn dJointSetDBallParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    pub fn dJointGetDBallParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Write where the point of body 1 is now to result, m, world frame.
    pub fn dJointGetDBallAnchor1(joint: dJointID, result: *mut dReal);
    /// Write where the point of body 2 is now to result, m, world frame.
    pub fn dJointGetDBallAnchor2(joint: dJointID, result: *mut dReal);
    /// The common axis. Needs a body; before it is called the joint keeps no axis.
    pub fn dJointSetDHingeAxis(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set the point of body 1, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    pub fn dJointSetDHingeAnchor1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set the point of body 2, world frame.
    ///
    /// The present distance becomes the one to keep, as when the joint is attached.
    pub fn dJointSetDHingeAnchor2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first those of
    /// the world.
    pub fn dJointSetDHingeParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    pub fn dJointGetDHingeParam(joint: dJointID, parameter: c_int) -> dReal;
    /// Write the common axis as body 1 has it now to result: a unit vector, world frame.
    pub fn dJointGetDHingeAxis(joint: dJointID, result: *mut dReal);
    /// Write where the point of body 1 is now to result, m, world frame.
    pub fn dJointGetDHingeAnchor1(joint: dJointID, result: *mut dReal);
    /// Write where the point of body 2 is now to result, m, world frame.
    pub fn dJointGetDHingeAnchor2(joint: dJointID, result: *mut dReal);
    /// The distance to keep, m.
    pub fn dJointGetDHingeDistance(joint: dJointID) -> dReal;
    /// Set what kind of wheels the joint couples: mode is dTransmissionParallelAxes
    /// (default), dTransmissionIntersectingAxes or dTransmissionChainDrive; another one is refused.
    pub fn dJointSetTransmissionMode(joint: dJointID, mode: c_int);
    /// What kind of wheels the joint couples: dTransmissionParallelAxes,
    /// dTransmissionIntersectingAxes or dTransmissionChainDrive.
    pub fn dJointGetTransmissionMode(joint: dJointID) -> c_int;
    /// Set the centre of wheel 1; at first the centre of body 1.
    pub fn dJointSetTransmissionAnchor1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set the centre of wheel 2; at first the centre of body 2.
    pub fn dJointSetTransmissionAnchor2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Write the centre of wheel 1 to result, m, world frame.
    pub fn dJointGetTransmissionAnchor1(joint: dJointID, result: *mut dReal);
    /// Write the centre of wheel 2 to result, m, world frame.
    pub fn dJointGetTransmissionAnchor2(joint: dJointID, result: *mut dReal);
    /// Set the axis of both wheels; refused with intersecting axes. Default: x of
    /// each body.
    pub fn dJointSetTransmissionAxis(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Write the axis of both wheels to result: a unit vector, world frame.
    pub fn dJointGetTransmissionAxis(joint: dJointID, result: *mut dReal);
    /// Set the axis of wheel 1; allowed with intersecting axes only.
    pub fn dJointSetTransmissionAxis1(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Set the axis of wheel 2; allowed with intersecting axes only.
    pub fn dJointSetTransmissionAxis2(joint: dJointID, x: dReal, y: dReal, z: dReal);
    /// Write the axis of wheel 1 to result: a unit vector, world frame.
    pub fn dJointGetTransmissionAxis1(joint: dJointID, result: *mut dReal);
    /// Write the axis of wheel 2 to result: a unit vector, world frame.
    pub fn dJointGetTransmissionAxis2(joint: dJointID, result: *mut dReal);
    /// Set the ratio radius 1 / radius 2, positive; allowed with parallel axes
    /// only. Default 1.
    pub fn dJointSetTransmissionRatio(joint: dJointID, ratio: dReal);
    /// The ratio radius 1 / radius 2.
    pub fn dJointGetTransmissionRatio(joint: dJointID) -> dReal;
    /// Set the radius of wheel 1, m, positive; allowed for a chain only.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    pub fn dJointSetTransmissionRadius1(joint: dJointID, radius: dReal);
    /// Set the radius of wheel 2, m, positive; allowed for a chain only.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    pub fn dJointSetTransmissionRadius2(joint: dJointID, radius: dReal);
    /// The radius of wheel 1, m: as set for a chain, else as measured by the
    /// first step.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    pub fn dJointGetTransmissionRadius1(joint: dJointID) -> dReal;
    /// The radius of wheel 2, m: as set for a chain, else as measured by the
    /// first step.
    ///
    /// Without radii a chain does nothing; in the other modes they follow from the geometry.
    pub fn dJointGetTransmissionRadius2(joint: dJointID) -> dReal;
    /// Set the backlash: the free play of the rims to either side of zero slip,
    /// m; default 0. A negative one is refused.
    pub fn dJointSetTransmissionBacklash(joint: dJointID, backlash: dReal);
    /// The backlash: the free play of the rims to either side of zero slip, m.
    pub fn dJointGetTransmissionBacklash(joint: dJointID) -> dReal;
    /// Set a parameter of the joint to value: dParamERP or dParamCFM, at first
    /// those of the world.
    pub fn dJointSetTransmissionParam(joint: dJointID, parameter: c_int, value: dReal);
    /// The value of a parameter of the joint: dParamERP or dParamCFM.
    pub fn dJointGetTransmissionParam(joint: dJointID, parameter: c_int) -> dReal;
    /// How far the point of contact has run around wheel 1, as body 1 sees it,
    /// about its axis, rad: a wheel that turns forward counts backward; full turns add up.
    ///
    /// It is what the last step began with.
    pub fn dJointGetTransmissionAngle1(joint: dJointID) -> dReal;
    /// How far the point of contact has run around wheel 2, as body 2 sees it,
    /// about its axis, rad: a wheel that turns forward counts backward; full turns add up.
    ///
    /// It is what the last step began with.
    pub fn dJointGetTransmissionAngle2(joint: dJointID) -> dReal;
    /// Write where wheel 1 touched the other wheel or the chain to result,
    /// m, world frame.
    ///
    /// It is what the last step began with.
    pub fn dJointGetTransmissionContactPoint1(joint: dJointID, result: *mut dReal);
    /// Write where wheel 2 touched the other wheel or the chain to result,
    /// m, world frame.
    ///
    /// It is what the last step began with.
    pub fn dJointGetTransmissionContactPoint2(joint: dJointID, result: *mut dReal);
    /// Same as dInitODE2(0) followed by dAllocateODEDataForThread(dAllocateMaskAll).
    pub fn dInitODE();
    /// Open the library. uiInitFlags: bits of dInitODEFlags. Returns non-zero on success, 0 on failure.
    pub fn dInitODE2(uiInitFlags: c_uint) -> c_int;
    /// Prepare the calling thread. uiAllocateFlags: bits of dAllocateODEDataFlags. Returns non-zero on
    /// success. Refused (0) before the library is opened. This library keeps no data per thread, so the
    /// call costs nothing; it is there for programs that rightly make it.
    pub fn dAllocateODEDataForThread(uiAllocateFlags: c_uint) -> c_int;
    /// Release what dAllocateODEDataForThread made for the calling thread. Refused before opening.
    pub fn dCleanupODEAllDataForThread();
    /// Close the library once. Refused when it is not open.
    pub fn dCloseODE();
    /// Scale the vector a of 3 reals to length 1.
    ///
    /// It is safe for very large and very small ones. Returns 1, or 0 with nothing changed if it is zero or not
    /// finite.
    pub fn dSafeNormalize3(a: *mut dReal) -> c_int;
    /// Scale the vector a of 4 reals to length 1.
    ///
    /// It is safe for very large and very small ones. Returns 1, or 0 with nothing changed if it is zero or not
    /// finite.
    pub fn dSafeNormalize4(a: *mut dReal) -> c_int;
    /// Scale the vector a of 3 reals, which must not be zero, to length 1.
    ///
    /// A zero vector is refused and stays as it is.
    pub fn dNormalize3(a: *mut dReal);
    /// Scale the vector a of 4 reals, which must not be zero, to length 1.
    ///
    /// A zero vector is refused and stays as it is.
    pub fn dNormalize4(a: *mut dReal);
    /// Two unit vectors p and q that make (n, p, q) a right-handed orthonormal frame. n: unit vector; zero is
    /// refused.
    pub fn dPlaneSpace(n: *const dReal, p: *mut dReal, q: *mut dReal);
    /// Make the rows of m orthonormal (Gram and Schmidt, first row leading, third = first x second, so no
    /// reflection survives). m: 12 reals; padding becomes 0. Returns 1, or 0 when a row degenerates.
    pub fn dOrthogonalizeR(m: *mut dReal) -> c_int;
    /// Set R to no rotation, the identity.
    pub fn dRSetIdentity(R: *mut dReal);
    /// A turn by \`angle\` about the axis (ax, ay, az), which need not be a unit vector; a zero axis gives the
    /// identity.
    pub fn dRFromAxisAndAngle(R: *mut dReal, ax: dReal, ay: dReal, az: dReal, angle: dReal);
    /// From Euler angles, rad: R = (Rz(psi) Ry(theta) Rx(phi))^T: first row (cos psi cos theta, sin psi cos
    /// theta, -sin theta). Note the transpose: it maps world to body in the usual aeronautical reading.
    pub fn dRFromEulerAngles(R: *mut dReal, phi: dReal, theta: dReal, psi: dReal);
    /// Columns of R: a = (ax, ay, az) normalised, the part of b = (bx, by, bz) perpendicular to a normalised,
    /// and their cross product. When a or b is zero or they are parallel, R is left as it is and a message is
    /// sent.
    pub fn dRFrom2Axes(R: *mut dReal, ax: dReal, ay: dReal, az: dReal, bx: dReal, by: dReal, bz: dReal);
    /// A rotation that takes the z axis to (ax, ay, az), normalised; the other two columns are those of
    /// dPlaneSpace. A zero vector is refused.
    pub fn dRFromZAxis(R: *mut dReal, ax: dReal, ay: dReal, az: dReal);
    /// Set q to no rotation: (1, 0, 0, 0).
    pub fn dQSetIdentity(q: *mut dReal);
    /// The quaternion of a turn by angle about the axis (ax, ay, az), as dRFromAxisAndAngle.
    pub fn dQFromAxisAndAngle(q: *mut dReal, ax: dReal, ay: dReal, az: dReal, angle: dReal);
    /// qa = qb qc.
    ///
    /// ' means the conjugate, which is the inverse of a unit quaternion. For rotations qb qc is "first qc, then
    /// qb". qa must be neither qb nor qc.
    pub fn dQMultiply0(qa: *mut dReal, qb: *const dReal, qc: *const dReal);
    /// qa = qb' qc.
    ///
    /// ' means the conjugate, which is the inverse of a unit quaternion. For rotations qb qc is "first qc, then
    /// qb". qa must be neither qb nor qc.
    pub fn dQMultiply1(qa: *mut dReal, qb: *const dReal, qc: *const dReal);
    /// qa = qb qc'.
    ///
    /// ' means the conjugate, which is the inverse of a unit quaternion. For rotations qb qc is "first qc, then
    /// qb". qa must be neither qb nor qc.
    pub fn dQMultiply2(qa: *mut dReal, qb: *const dReal, qc: *const dReal);
    /// qa = qb' qc'.
    ///
    /// ' means the conjugate, which is the inverse of a unit quaternion. For rotations qb qc is "first qc, then
    /// qb". qa must be neither qb nor qc.
    pub fn dQMultiply3(qa: *mut dReal, qb: *const dReal, qc: *const dReal);
    /// The matrix R of a quaternion. q is taken as a unit quaternion and is not normalised here.
    pub fn dRfromQ(R: *mut dReal, q: *const dReal);
    /// The quaternion q of a rotation matrix R. The component computed first (w when the trace is not
    /// negative, else that of the largest diagonal element) comes out positive.
    pub fn dQfromR(q: *mut dReal, R: *const dReal);
    /// Time derivative of a quaternion under the angular velocity w (world frame, rad/s): dq = 1/2 (0, w) q.
    pub fn dDQfromW(dq: *mut dReal, w: *const dReal, q: *const dReal);
    /// A new implementation whose calls are run by the thread that waits for them, the last posted first.
    /// Its thread count is 0 and no thread may serve it. Returns NULL when memory is out.
    pub fn dThreadingAllocateSelfThreadedImplementation() -> dThreadingImplementationID;
    /// A new implementation whose calls are run by the threads that serve it. While none does, the thread that
    /// waits for calls runs them, so that a step never waits for ever. Returns NULL when memory is out.
    pub fn dThreadingAllocateMultiThreadedImplementation() -> dThreadingImplementationID;
    /// The functions of an implementation made by dThreadingAllocateSelfThreadedImplementation or
    /// dThreadingAllocateMultiThreadedImplementation; static, never freed.
    pub fn dThreadingImplementationGetFunctions(r#impl: dThreadingImplementationID) -> *const dThreadingFunctionsInfo;
    /// Let the threads that serve go, after the calls that they are in. Calls that have not started stay. Without
    /// effect on a self-threaded implementation. Returns at once.
    pub fn dThreadingImplementationShutdownProcessing(r#impl: dThreadingImplementationID);
    /// After a shutdown, and when all threads have left: threads may serve again. Refused while some have not
    /// left. Without effect on a self-threaded implementation.
    pub fn dThreadingImplementationCleanupForRestart(r#impl: dThreadingImplementationID);
    /// Free an implementation with all its mutex groups and waits. Threads that are still on their way out after
    /// a shutdown are waited for. Refused while threads serve without having been released, wait, or run a call.
    /// A world that it is set on is not stepped any more (dWorldStep returns 0) until it gets another or none.
    /// NULL is ignored.
    pub fn dThreadingFreeImplementation(r#impl: dThreadingImplementationID);
    /// The calling thread serves a multi-threaded implementation until that is shut down; if it has been already,
    /// it returns at once. readiness\_callback (may be NULL) is called with callback\_context when the thread has
    /// been counted. Refused inside a call of the same implementation.
    pub fn dExternalThreadingServeMultiThreadedImplementation(r#impl: dThreadingImplementationID, readiness_callback: dThreadReadyToServeCallback, callback_context: *mut c_void);
    /// Start thread\_count threads, 1 to 1024, which inherit the caller's priority, take no signals, and call
    /// dAllocateODEDataForThread(ode\_data\_allocate\_flags). stack\_size: bytes of stack for each, at least
    /// PTHREAD\_STACK\_MIN; less than 64 KiB are made 64 KiB; 0 is the system's default. reserved is not looked at.
    /// Refused before dInitODE2. Returns NULL on failure.
    pub fn dThreadingAllocateThreadPool(thread_count: c_uint, stack_size: usize, ode_data_allocate_flags: c_uint, reserved: *mut c_void) -> dThreadingThreadPoolID;
    /// Let all threads of a pool serve a multi-threaded implementation; returns when they do. A pool serves one
    /// at a time: one that was shut down is waited for, one that was not makes this call refused. Several pools
    /// may serve the same implementation. If it has been shut down the threads come back at once.
    pub fn dThreadingThreadPoolServeMultiThreadedImplementation(pool: dThreadingThreadPoolID, r#impl: dThreadingImplementationID);
    /// Wait until no thread of the pool serves; at once if none does. Refused if the implementation that they
    /// serve has not been shut down.
    pub fn dThreadingThreadPoolWaitIdleState(pool: dThreadingThreadPoolID);
    /// Wait as dThreadingThreadPoolWaitIdleState does, end the threads and free the pool. Refused while an
    /// implementation that they serve has not been shut down. NULL is ignored.
    pub fn dThreadingFreeThreadPool(pool: dThreadingThreadPoolID);
    /// Set the stopwatch s back to zero.
    pub fn dStopwatchReset(s: *mut dStopwatch);
    /// Start the stopwatch s.
    pub fn dStopwatchStart(s: *mut dStopwatch);
    /// Stop the stopwatch s and add the time since its start.
    pub fn dStopwatchStop(s: *mut dStopwatch);
    /// The total time of the stopwatch s, in seconds.
    pub fn dStopwatchTime(s: *mut dStopwatch) -> f64;
    /// Begin a new list of events with one of this description, which is not copied and must live
    /// until the report.
    pub fn dTimerStart(description: *const c_char);
    /// Begin the next event, of this description, which is not copied and must live until the
    /// report. At most 100 events count.
    pub fn dTimerNow(description: *const c_char);
    /// End the list of events.
    pub fn dTimerEnd();
    /// Print the time and share of each event to fout. average != 0: also the means over all lists so far whose
    /// events were the same.
    pub fn dTimerReport(fout: *mut FILE, average: c_int);
    /// Ticks of the clock per second.
    pub fn dTimerTicksPerSecond() -> f64;
    /// The smallest step of the clock that can be seen, in seconds.
    pub fn dTimerResolution() -> f64;
}
