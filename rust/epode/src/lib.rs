// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors

//! Rigid bodies, joints and contacts: the engine Epode, safely.
//!
//! ```
//! use epode::{BodyDef, GeomDef, Shape, World};
//!
//! # fn main() -> epode::Result<()> {
//! let mut world = World::new()?; // gravity is (0, 0, -9.81)
//! world.add_geom(&GeomDef::new(Shape::ground()))?;
//! let ball = world.add_body(&BodyDef::new().position([0.0, 0.0, 2.0]).shape(Shape::Sphere { radius: 0.2 }))?;
//! for _ in 0..200 {
//!     world.step(0.01)?;
//! }
//! assert!((world.body(ball)?.position()[2] - 0.2).abs() < 1e-3);
//! # Ok(())
//! # }
//! ```
//!
//! - A [`World`] owns everything in it. Bodies, joints and geoms are named by handles ([`BodyId`], [`JointId`], [`GeomId`]): numbers
//!   that may be copied, kept anywhere and sent to other threads. [`World::body`] and its sisters lend a view for reading,
//!   [`World::body_mut`] one for changing; a handle of what has been removed, or of another world, is an [`Error`], never another
//!   object.
//! - What the library refuses is an [`Error`] with its own text, and has changed nothing.
//! - A callback may panic: the panic goes on when the step, which is completed, is over.
//! - Worlds may be sent to other threads (`Send`), and each thread may step its own; one world is used by one thread at a time
//!   (not `Sync`).
//! - Numbers are [`Real`]: `f64`, or `f32` with the feature `single`, which links `libode_single`.
//!
//! What does not compile: a view that outlives its world, or is sent to another thread, or is held while the world is changed; a world
//! that two threads read; a filter of a query that changes the world.
//!
//! ```compile_fail,E0505
//! let world = epode::World::new().unwrap();
//! let contacts = world.contacts();
//! drop(world);
//! contacts.len();
//! ```
//! ```compile_fail,E0502
//! let mut world = epode::World::new().unwrap();
//! let body = world.add_body(&epode::BodyDef::new()).unwrap();
//! let view = world.body(body).unwrap();
//! world.remove_body(body).unwrap();
//! view.position();
//! ```
//! ```compile_fail,E0277
//! let world = epode::World::new().unwrap();
//! std::thread::scope(|scope| {
//!     scope.spawn(|| world.bodies()); // World is not Sync
//! });
//! ```
//! ```compile_fail,E0502
//! let mut world = epode::World::new().unwrap();
//! let mut step = |_| world.step(0.01).is_ok();
//! world.ray([0.0; 3], [1.0, 0.0, 0.0], 1.0, &epode::Filter::new().keep(&mut step)).unwrap();
//! ```
//! ```compile_fail,E0277
//! let mut world = epode::World::new().unwrap();
//! let shared = std::rc::Rc::new(1); // functions of the program go with the world, wherever it is sent
//! world.set_contact_filter(move |_, _| *shared == 1).unwrap();
//! ```
//!
//! Most methods are written from the C headers with their texts, so names such as `dBodySetPosition` in them are those of C, and
//! `0` for an object is `None` here.
#![warn(missing_docs)]

mod body;
mod callbacks;
mod character;
mod contact;
mod error;
mod geom;
mod handle;
mod joint;
mod owned;
mod query;
#[cfg(feature = "robots")]
mod robot;
#[cfg(feature = "robots")]
mod robot_model;
mod shape;
mod state;
mod table;
mod values;
mod world;

#[rustfmt::skip]
mod generated {
    pub mod body;
    pub mod enums;
    pub mod geom;
    pub mod joint;
    pub mod structures;
    pub mod world;
}

/// What the generated files use.
mod prelude {
    pub(crate) use crate::error::{call, sure, Result};
    pub(crate) use crate::generated::enums::*;
    pub(crate) use crate::generated::structures::*;
    pub(crate) use crate::handle::{BodyId, GeomId, JointId};
    pub(crate) use crate::table::Shared;
    pub(crate) use crate::values::*;
    pub(crate) use crate::{Body, BodyMut, Geom, GeomMut, Joint, JointMut, World};
    pub(crate) use epode_sys as sys;
}

pub use body::{Body, BodyDef, BodyMut};
pub use callbacks::{Moved, Touching};
pub use contact::{Cause, Contact, ContactEvent, Contacts, Event};
pub use error::{on_message, Error, ErrorKind, Result};
pub use generated::enums::*;
pub use generated::structures::*;
pub use geom::{Geom, GeomDef, GeomMut};
pub use handle::{BodyId, GeomId, JointId};
pub use joint::{Joint, JointDef, JointMut};
pub use query::{Distance, Filter, Hit};
#[cfg(feature = "robots")]
pub use robot::{Robot, RobotId, RobotMut};
#[cfg(feature = "robots")]
pub use robot_model::{RobotJoint, RobotJointKind, RobotLink, RobotModel};
pub use shape::Shape;
pub use state::Fields;
pub use values::{Mass, Mat3, Param, Quat, Real, Vec3};
pub use world::{step_worlds, Method, World, WorldDef};

// The samples of the pages are compiled and run.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
mod readme {}
#[cfg(doctest)]
#[doc = include_str!("../../../docs/rust.md")]
mod page {}
