// SPDX-License-Identifier: BSD-3-Clause
// Copyright (c) 2026 The Epode authors
//
// States, roll-backs, files and copies: the same bits; and handles after them.
use epode::{BodyDef, CharacterSettings, Fields, GeomDef, JointDef, Method, Real, Result, Shape, World, WorldDef};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::Arc;

fn tower(world: &mut World) -> Result<Vec<epode::BodyId>> {
    world.add_geom(&GeomDef::new(Shape::ground()))?;
    let mut bodies = Vec::new();
    for i in 0..6 {
        let at = [0.1 * i as Real, 0.0, 0.6 + 1.05 * i as Real];
        bodies.push(world.add_body(&BodyDef::new().position(at).shape(Shape::cube(1.0)).mass(1.0).tag(i))?);
    }
    world.add_joint(&JointDef::ball(bodies[4], bodies[5]).anchor([0.45, 0.0, 5.3]))?;
    Ok(bodies)
}

#[test]
fn a_saved_state_goes_on_with_the_same_bits() -> Result<()> {
    let mut world = World::new()?;
    tower(&mut world)?;
    (0..30).try_for_each(|_| world.step(0.01))?;
    let state = world.save_state()?;
    (0..50).try_for_each(|_| world.step(0.01))?;
    let end = world.state_hash()?;
    world.load_state(&state)?;
    let delta = {
        (0..50).try_for_each(|_| world.step(0.01))?;
        world.save_state_delta(&state)?
    };
    assert_eq!(world.state_hash()?, end);
    world.load_state(&state)?;
    world.load_state_delta(&state, &delta)?;
    assert_eq!(world.state_hash()?, end);
    // Bytes that are no state are refused and change nothing.
    let mut broken = state.clone();
    broken[state.len() / 2] ^= 1;
    assert!(world.load_state(&broken).is_err());
    assert!(world.load_state(&state[..state.len() - 1]).is_err());
    assert!(world.load_state(&[]).is_err());
    assert_eq!(world.state_hash()?, end);
    Ok(())
}

#[test]
fn steps_are_taken_back_with_what_was_removed_and_added() -> Result<()> {
    let mut world = WorldDef::new().history(20).build()?;
    let bodies = tower(&mut world)?;
    world.set_history(20)?;
    (0..5).try_for_each(|_| world.step(0.01))?;
    let hash = world.state_hash()?;
    world.remove_body(bodies[3])?;
    let added = world.add_body(&BodyDef::new().position([5.0, 0.0, 1.0]).shape(Shape::cube(1.0)))?;
    (0..7).try_for_each(|_| world.step(0.01))?;
    assert!(world.body(bodies[3]).is_err());
    world.roll_back(7)?;
    assert_eq!(world.state_hash()?, hash);
    assert_eq!(world.body(bodies[3])?.tag(), 3, "it is back under its handle");
    assert_eq!(world.body(bodies[3])?.geoms().len(), 1);
    assert!(world.body(added).is_err(), "it has never been");
    // Places of what is gone are used again under other handles.
    let next = world.add_body(&BodyDef::new())?;
    assert_ne!(next, added);
    assert!(world.body(added).is_err());
    Ok(())
}

#[test]
fn what_was_removed_before_the_history_is_forgotten() -> Result<()> {
    let mut world = WorldDef::new().history(3).build()?;
    let mut old = Vec::new();
    for i in 0..200 {
        let body = world.add_body(&BodyDef::new().shape(Shape::cube(1.0)).position([3.0 * i as Real, 0.0, 0.0]))?;
        world.step(0.01)?;
        world.remove_body(body)?;
        old.push(body);
        if i % 7 == 6 {
            world.roll_back(1)?;
            // As after the step before: the last body but one had not been removed yet, and this one did not exist.
            assert_eq!(world.bodies(), [old[i - 1]], "step {i}");
            world.remove_body(old[i - 1])?;
        }
    }
    assert!(old.iter().all(|&body| world.body(body).is_err()));
    let distinct: std::collections::HashSet<_> = old.iter().collect();
    assert_eq!(distinct.len(), 200);
    Ok(())
}

#[test]
fn a_character_that_comes_back_has_the_filter_that_it_had() -> Result<()> {
    let mut world = WorldDef::new().history(10).build()?;
    world.add_geom(&GeomDef::new(Shape::ground()))?;
    let walker = world.add_character(&CharacterSettings::default(), [0.0; 3])?;
    let calls = Arc::new([AtomicUsize::new(0), AtomicUsize::new(0)]);
    let count = |number: usize, calls: &Arc<[AtomicUsize; 2]>| {
        let calls = calls.clone();
        move |_, _| {
            calls[number].fetch_add(1, Ordering::Relaxed);
            true
        }
    };
    world.set_character_filter(walker, count(0, &calls))?;
    world.step(0.01)?;
    world.set_character_filter(walker, count(1, &calls))?;
    world.step(0.01)?;
    world.remove_geom(walker)?;
    world.step(0.01)?;
    world.roll_back(1)?;
    world.geom_mut(walker)?.character_walk([1.0, 0.0, 0.0], 0.0, 0.01)?;
    assert!(calls[1].load(Ordering::Relaxed) > 0);
    world.roll_back(1)?;
    world.geom_mut(walker)?.character_walk([1.0, 0.0, 0.0], 0.0, 0.01)?;
    assert_eq!(calls[0].load(Ordering::Relaxed), 0, "the first filter has been replaced");
    Ok(())
}

#[test]
fn copies_and_files_go_on_with_the_same_bits() -> Result<()> {
    let mut world = World::new()?;
    let bodies = tower(&mut world)?;
    let heights: Vec<Real> = (0..25).map(|i| (i % 5) as Real * 0.01).collect();
    let field = Shape::Heights { heights: &heights, columns: 5, rows: 5, width: 4.0, depth: 4.0 };
    world.add_geom(&GeomDef::new(field).position([0.0, 20.0, 0.0]))?;
    let vertices = [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mesh = Shape::Mesh { vertices: &vertices, triangles: &[[0, 2, 1], [0, 1, 3], [0, 3, 2], [1, 2, 3]] };
    world.add_body(&BodyDef::new().position([0.0, 5.0, 2.0]).shape(mesh))?;
    world.remove_body(bodies[1])?;
    world.set_method(Method::Quick);
    (0..10).try_for_each(|_| world.step(0.01))?;
    let mut copy = world.try_clone()?;
    let mut read = World::from_bytes(&world.to_bytes()?)?;
    read.set_method(Method::Quick);
    let path = std::env::temp_dir().join(format!("epode_{}.epw", std::process::id()));
    world.save(&path)?;
    let mut loaded = World::load(&path)?;
    std::fs::remove_file(&path).unwrap();
    loaded.set_method(Method::Quick);
    let there = bodies[4].in_world(&copy);
    assert_eq!(copy.body(there)?.tag(), 4);
    assert_eq!(copy.body(there)?.position(), world.body(bodies[4])?.position());
    assert!(copy.body(bodies[1].in_world(&copy)).is_err(), "it has been removed in both");
    for one in [&mut world, &mut copy, &mut read, &mut loaded] {
        (0..40).try_for_each(|_| one.step(0.01))?;
    }
    drop(world.try_clone()?);
    let hash = world.state_hash()?;
    drop(world); // what the copies have is their own
    for one in [&mut copy, &mut read, &mut loaded] {
        assert_eq!(one.state_hash()?, hash);
        assert_eq!((one.bodies().len(), one.joints().len(), one.geoms().len()), (6, 1, 8));
    }
    // New objects of the copy take no handle that the original has given away.
    let new = copy.add_body(&BodyDef::new())?;
    assert!(bodies.iter().all(|body| body.in_world(&copy) != new));
    Ok(())
}

#[test]
fn states_of_many_bodies_are_one_call() -> Result<()> {
    let mut world = World::new()?;
    let bodies = tower(&mut world)?;
    let fields = Fields::POSITION | Fields::LINEAR_VEL;
    let mut rows = vec![0.0; bodies.len() * fields.width()];
    world.body_states(&bodies, fields, &mut rows)?;
    assert_eq!(rows[6 * 3..6 * 3 + 3], world.body(bodies[3])?.position());
    rows.chunks_exact_mut(6).for_each(|row| row[3] = 2.0);
    world.set_body_states(&bodies, fields, &rows)?;
    assert!(bodies.iter().all(|&body| world.body(body).unwrap().linear_vel()[0] == 2.0));
    Ok(())
}
