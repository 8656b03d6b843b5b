// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors

//! The C interface of Epode as it is: every exported function, structure and number, with the texts of the headers. The crate
//! `epode` is the safe one.
//!
//! Declarations are written by `rust/tools/generate.py` from the headers. Arguments that are arrays in C are pointers here, and
//! enumerations are the numbers that C passes. `tests/layout.rs` compares each structure and number with what a C compiler says.
#![allow(non_camel_case_types, non_snake_case, non_upper_case_globals)]
#![allow(clippy::too_many_arguments, clippy::doc_lazy_continuation, clippy::doc_overindented_list_items)]
#![no_std]

use core::ffi::{c_char, c_int, c_short, c_uchar, c_uint, c_ulong, c_void};

/// The real number of the interface.
#[cfg(not(feature = "single"))]
pub type dReal = f64;
/// The real number of the interface.
#[cfg(feature = "single")]
pub type dReal = f32;

/// A C stream, which only C can make.
#[repr(C)]
pub struct FILE {
    _private: [u8; 0],
    _marker: Unshared,
}

/// A `va_list` as it is passed to a function. On every ABI that the library is built for it is a pointer, or a structure that is
/// passed by one or that holds just one; so it can be handed on to `vsnprintf`.
pub type va_list = *mut c_void;

#[cfg(windows)]
type time_t = i64;
#[cfg(not(windows))]
type time_t = core::ffi::c_long;

/// What is known by its address alone: neither moved, nor shared between threads by the compiler's leave.
type Unshared = core::marker::PhantomData<(*mut u8, core::marker::PhantomPinned)>;

#[rustfmt::skip]
mod ode;
pub use ode::*;

#[cfg(feature = "robots")]
#[rustfmt::skip]
mod robots;
#[cfg(feature = "robots")]
pub use robots::*;

// libode_single asks every program for this name, so that none for doubles is linked with it (ode/odeconfig.h).
#[cfg(feature = "single")]
#[no_mangle]
#[used]
static dDoublePrecisionProgram_CompileWith_dIDESINGLE: c_char = 1;
