// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Numbers, vectors and masses, and how they become C's: a C vector has a fourth number of padding, a C matrix one in each row.
use crate::prelude::*;

/// The real number: `f64`, or `f32` with the feature `single`.
pub type Real = sys::dReal;
/// x, y, z.
pub type Vec3 = [Real; 3];
/// A quaternion: w, x, y, z.
pub type Quat = [Real; 4];
/// The rows of a 3 x 3 matrix. A rotation leads from the object's frame to the world's.
pub type Mat3 = [[Real; 3]; 3];

pub(crate) fn pad3(v: Vec3) -> sys::dVector3 {
    [v[0], v[1], v[2], 0.0]
}
pub(crate) fn vec3(v: sys::dVector3) -> Vec3 {
    [v[0], v[1], v[2]]
}
pub(crate) fn pad33(m: Mat3) -> sys::dMatrix3 {
    let mut padded = [0.0; 12];
    for (row, to) in m.iter().zip(padded.chunks_exact_mut(4)) {
        to[..3].copy_from_slice(row);
    }
    padded
}
pub(crate) fn mat3(m: sys::dMatrix3) -> Mat3 {
    std::array::from_fn(|i| std::array::from_fn(|j| m[4 * i + j]))
}
/// Numbers that C takes and gives as they are.
pub(crate) fn same<T>(value: T) -> T {
    value
}

// C returns pointers into live objects, or null where it has refused (a message went along).
fn read<const N: usize>(from: *const Real) -> [Real; N] {
    if from.is_null() {
        return [0.0; N];
    }
    // The library's arrays of this kind have at least N numbers, and nobody changes them during this call.
    unsafe { from.cast::<[Real; N]>().read() }
}
pub(crate) fn read_vec3(from: *const Real) -> Vec3 {
    read(from)
}
pub(crate) fn read_quat(from: *const Real) -> Quat {
    read(from)
}
pub(crate) fn read_mat3(from: *const Real) -> Mat3 {
    mat3(read(from))
}

/// Mass, centre of mass and inertia of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mass {
    /// kg.
    pub mass: Real,
    /// Centre of mass in the body's frame, m; that of a body is its origin.
    pub centre: Vec3,
    /// About the body's origin, in its axes, kg m^2.
    pub inertia: Mat3,
}

impl Mass {
    /// A mass with its centre at the origin and the moments of inertia about the three axes.
    pub fn diagonal(mass: Real, moments: Vec3) -> Self {
        let inertia = std::array::from_fn(|i| std::array::from_fn(|j| if i == j { moments[i] } else { 0.0 }));
        Self { mass, centre: [0.0; 3], inertia }
    }
    pub(crate) fn to_raw(self) -> sys::dMass {
        sys::dMass { mass: self.mass, c: pad3(self.centre), I: pad33(self.inertia) }
    }
    pub(crate) fn from_raw(raw: &sys::dMass) -> Self {
        Self { mass: raw.mass, centre: vec3(raw.c), inertia: mat3(raw.I) }
    }
}

/// A parameter of a joint's axis: a stop, a motor, softness. Those of the second and third axis are `parameter.of_axis(1)` and
/// `.of_axis(2)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Param(i32);

#[rustfmt::skip]
impl Param {
    /// Lower end of the range of the angle (rad) or position (m); minus infinity: none.
    pub const LO_STOP: Self = Self(sys::dParamLoStop);
    /// Upper end of the range; infinity: none.
    pub const HI_STOP: Self = Self(sys::dParamHiStop);
    /// Wanted rate of the motor, rad/s or m/s.
    pub const VEL: Self = Self(sys::dParamVel);
    /// The most force or torque that the motor may use, N or N m; 0: no motor.
    pub const FMAX: Self = Self(sys::dParamFMax);
    /// Scales the force of a motor that drives away from a stop, 0 to 1.
    pub const FUDGE_FACTOR: Self = Self(sys::dParamFudgeFactor);
    /// Restitution at a stop, 0 to 1.
    pub const BOUNCE: Self = Self(sys::dParamBounce);
    /// Softness of the powered axis off its stops.
    pub const CFM: Self = Self(sys::dParamCFM);
    /// Share of the error at a stop that is corrected in a step.
    pub const STOP_ERP: Self = Self(sys::dParamStopERP);
    /// Softness of a stop.
    pub const STOP_CFM: Self = Self(sys::dParamStopCFM);
    /// Share of the suspension's error that is corrected in a step.
    pub const SUSPENSION_ERP: Self = Self(sys::dParamSuspensionERP);
    /// Softness of the suspension.
    pub const SUSPENSION_CFM: Self = Self(sys::dParamSuspensionCFM);
    /// Share of the joint's own error that is corrected in a step.
    pub const ERP: Self = Self(sys::dParamERP);

    /// The same parameter of the axis of this number, 0, 1 or 2; of others a parameter that joints do not have.
    pub const fn of_axis(self, axis: u8) -> Self {
        Self(self.0 % sys::dParamGroup + axis as i32 * sys::dParamGroup)
    }
    pub(crate) fn number(self) -> i32 {
        self.0
    }
}
