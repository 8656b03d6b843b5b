// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// Handles name what they were made for, or nothing.
use epode::{BodyDef, ErrorKind, Filter, GeomDef, JointDef, Result, Shape, World};

fn ball() -> BodyDef<'static> {
    BodyDef::new().shape(Shape::Sphere { radius: 0.5 })
}

#[test]
fn removed_objects_are_errors_whatever_takes_their_place() -> Result<()> {
    let mut world = World::new()?;
    let first = world.add_body(&ball())?;
    let geom = world.body(first)?.geoms()[0];
    let joint = world.add_joint(&JointDef::ball(first, None))?;
    world.remove_body(first)?;
    world.remove_joint(joint)?;
    // More than the 63 successors that the C library tells apart.
    for _ in 0..1000 {
        let next = world.add_body(&ball())?;
        let next_joint = world.add_joint(&JointDef::ball(next, None))?;
        assert_eq!(world.body(first).err().map(|e| e.kind()), Some(ErrorKind::Removed));
        assert_eq!(world.geom(geom).err().map(|e| e.kind()), Some(ErrorKind::Removed));
        assert_eq!(world.joint_mut(joint).err().map(|e| e.kind()), Some(ErrorKind::Removed));
        assert_eq!(world.remove_body(first).err().map(|e| e.kind()), Some(ErrorKind::Removed));
        world.remove_body(next)?;
        world.remove_joint(next_joint)?;
    }
    assert!(world.bodies().is_empty() && world.geoms().is_empty() && world.joints().is_empty());
    Ok(())
}

#[test]
fn handles_of_another_world_are_errors() -> Result<()> {
    let (mut one, mut other) = (World::new()?, World::new()?);
    let theirs = other.add_body(&ball())?;
    let ours = one.add_body(&ball())?;
    assert_eq!(one.body(theirs).err().map(|e| e.kind()), Some(ErrorKind::OtherWorld));
    assert_eq!(one.add_joint(&JointDef::hinge(ours, theirs)).err().map(|e| e.kind()), Some(ErrorKind::OtherWorld));
    assert!(one.joints().is_empty());
    assert!(one.ray([0.0; 3], [1.0, 0.0, 0.0], 1.0, &Filter::new().skip_body(theirs)).is_err());
    Ok(())
}

#[test]
fn what_belongs_together_is_found() -> Result<()> {
    let mut world = World::new()?;
    let (a, b) = (world.add_body(&ball().tag(7))?, world.add_body(&ball().position([2.0, 0.0, 0.0]))?);
    let joint = world.add_joint(&JointDef::ball(a, b).anchor([1.0, 0.0, 0.0]).tag(9))?;
    assert_eq!(world.body(a)?.joints(), [joint]);
    assert_eq!(world.joint(joint)?.bodies(), [Some(a), Some(b)]);
    assert_eq!((world.body(a)?.tag(), world.joint(joint)?.tag()), (7, 9));
    let extra = world.add_geom_to(a, &GeomDef::new(Shape::cube(0.1)).position([0.0, 0.0, 0.5]).tag(3))?;
    assert_eq!(world.geom(extra)?.body(), Some(a));
    assert_eq!(world.geom(extra)?.offset_position()?, [0.0, 0.0, 0.5]);
    assert_eq!(world.body(a)?.geoms().len(), 2);
    world.remove_body(a)?;
    assert!(world.geom(extra).is_err(), "geoms go with their body");
    assert_eq!(world.joint(joint)?.bodies(), [None, None]);
    Ok(())
}

#[test]
fn handles_and_worlds_may_travel_but_worlds_are_not_shared() {
    fn send<T: Send>() {}
    fn sync<T: Sync>() {}
    send::<World>();
    send::<epode::BodyId>();
    sync::<epode::BodyId>();
    sync::<epode::Error>();
    // That World is not Sync is a compile_fail test in the documentation of lib.rs.
}
